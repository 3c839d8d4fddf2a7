// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_7 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: array<array<u32, 2>, 3>,
    member_9: array<u32, 2>,
    member_10: array<u32, 2>,
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: array<u32, 2>,
    member_15: array<u32, 2>,
    member_16: array<u32, 2>,
}

struct type_8 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<u32>,
}

struct type_16 {
    member: i32,
    member_1: i32,
}

struct type_17 {
    member: u32,
    member_1: i32,
}

struct type_20 {
    member: u32,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_23 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_26 {
    member: array<type_24>,
}

struct type_30 {
    member: array<array<f64, 3>>,
}

struct type_31 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_33 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_35 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_36 {
    member: type_33,
    member_1: f64,
}

struct type_37 {
    member: u32,
    member_1: f64,
}

struct type_38 {
    member: type_37,
    member_1: u32,
}

struct type_39 {
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_41 {
    member: array<array<array<f64, 3>, 4>, 2>,
    member_1: f64,
    member_2: f64,
}

struct type_42 {
    member: f64,
    member_1: f64,
    member_2: u32,
}

struct type_46 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(2) 
var<storage> positions: type_30;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(1) 
var<storage> paths: type_26;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_46;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_46;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_244_: f64;
    var phi_287_: f64;
    var phi_330_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_244_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_244_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_244_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_287_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_287_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_287_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_330_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_330_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_330_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_1(param_1: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_1);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_2(param_2: array<f64, 3>, param_3: array<f64, 3>) -> array<f64, 3> {
    let _e24 = ((((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])) < (((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])));
    return array<f64, 3>(select(param_2[0], param_3[0], _e24), select(param_2[1], param_3[1], _e24), select(param_2[2], param_3[2], _e24));
}

fn function_3(param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: array<f64, 3>, param_7: u32) -> array<f64, 3> {
    var phi_858_: array<array<f64, 3>, 4>;

    let _e9 = (param_4[0] - param_5[0]);
    let _e12 = (param_4[1] - param_5[1]);
    let _e15 = (param_4[2] - param_5[2]);
    if (param_7 != 0u) {
        let _e163 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e171 = select(f64(0f), select(f64(1f), _e163, (_e163 < f64(1f))), (_e163 > f64(0f)));
        let _e207 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        let _e215 = select(f64(0f), select(f64(1f), _e207, (_e207 < f64(1f))), (_e207 > f64(0f)));
        let _e248 = ((((_e9 * param_6[0]) + (_e12 * param_6[1])) + (_e15 * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        let _e256 = select(f64(0f), select(f64(1f), _e248, (_e248 < f64(1f))), (_e248 > f64(0f)));
        let _e269 = (param_4[0] - param_6[0]);
        let _e272 = (param_4[1] - param_6[1]);
        let _e275 = (param_4[2] - param_6[2]);
        let _e295 = ((((_e269 * param_5[0]) + (_e272 * param_5[1])) + (_e275 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e303 = select(f64(0f), select(f64(1f), _e295, (_e295 < f64(1f))), (_e295 > f64(0f)));
        phi_858_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e171)), (param_4[1] - (param_5[1] * _e171)), (param_4[2] - (param_5[2] * _e171))), array<f64, 3>((param_4[0] - (param_6[0] * _e215)), (param_4[1] - (param_6[1] * _e215)), (param_4[2] - (param_6[2] * _e215))), array<f64, 3>((_e9 - (param_6[0] * _e256)), (_e12 - (param_6[1] * _e256)), (_e15 - (param_6[2] * _e256))), array<f64, 3>((_e269 - (param_5[0] * _e303)), (_e272 - (param_5[1] * _e303)), (_e275 - (param_5[2] * _e303))));
    } else {
        let _e19 = (param_6[0] - param_5[0]);
        let _e22 = (param_6[1] - param_5[1]);
        let _e25 = (param_6[2] - param_5[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        let _e44 = select(f64(0f), select(f64(1f), _e36, (_e36 < f64(1f))), (_e36 > f64(0f)));
        let _e51 = array<f64, 3>((_e9 - (_e19 * _e44)), (_e12 - (_e22 * _e44)), (_e15 - (_e25 * _e44)));
        let _e74 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e82 = select(f64(0f), select(f64(1f), _e74, (_e74 < f64(1f))), (_e74 > f64(0f)));
        let _e118 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        let _e126 = select(f64(0f), select(f64(1f), _e118, (_e118 < f64(1f))), (_e118 > f64(0f)));
        phi_858_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e82)), (param_4[1] - (param_5[1] * _e82)), (param_4[2] - (param_5[2] * _e82))), array<f64, 3>((param_4[0] - (param_6[0] * _e126)), (param_4[1] - (param_6[1] * _e126)), (param_4[2] - (param_6[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_858_;
    let _e319 = function_2(_e316[0], _e316[1]);
    let _e321 = function_2(_e319, _e316[2]);
    let _e323 = function_2(_e321, _e316[3]);
    return _e323;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_457_: bool;
    var phi_491_: array<f64, 3>;
    var phi_492_: bool;
    var phi_493_: array<f64, 3>;
    var phi_494_: bool;
    var phi_499_: array<f64, 3>;

    let _e23 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e34 = (((param_9[0] * param_10[0]) + (param_9[1] * param_10[1])) + (param_9[2] * param_10[2]));
    let _e45 = (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2]));
    let _e56 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e67 = (((param_8[0] * param_10[0]) + (param_8[1] * param_10[1])) + (param_8[2] * param_10[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e71 = f64(0f);
    let _e72 = f64(1f);
    let _e76 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e80 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_11 != 0u) {
        let _e91 = (_e76 >= _e71);
        let _e92 = (_e80 >= _e71);
        let _e93 = (_e76 <= _e72);
        phi_457_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_457_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_457_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_491_ = array<f64, 3>((param_8[0] - ((param_9[0] * _e76) + (param_10[0] * _e80))), (param_8[1] - ((param_9[1] * _e76) + (param_10[1] * _e80))), (param_8[2] - ((param_9[2] * _e76) + (param_10[2] * _e80))));
            phi_492_ = false;
        } else {
            phi_491_ = array<f64, 3>();
            phi_492_ = true;
        }
        let _e132 = phi_491_;
        let _e134 = phi_492_;
        phi_493_ = _e132;
        phi_494_ = _e134;
    } else {
        phi_493_ = array<f64, 3>();
        phi_494_ = true;
    }
    let _e136 = phi_493_;
    let _e138 = phi_494_;
    if _e138 {
        let _e139 = function_3(param_8, param_9, param_10, param_11);
        phi_499_ = _e139;
    } else {
        phi_499_ = _e136;
    }
    let _e141 = phi_499_;
    return _e141;
}

fn function_5(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<f32, 3>;
    var local_1: type_41;
    var local_2: type_39;
    var local_3: type_39;
    var local_4: type_39;
    var local_5: type_33;
    var local_6: type_35;
    var phi_953_: u32;
    var phi_998_: u32;
    var phi_1001_: type_9;
    var phi_1175_: type_23;
    var phi_1371_: type_31;
    var phi_1532_: type_33;
    var phi_1806_: bool;
    var phi_1902_: type_36;
    var phi_1903_: bool;
    var phi_1904_: type_36;
    var phi_1905_: bool;
    var phi_1906_: type_36;
    var phi_1907_: bool;
    var phi_1912_: type_36;
    var phi_2082_: type_16;
    var phi_2085_: f64;
    var phi_2083_: type_16;
    var phi_2126_: type_17;
    var phi_2086_: f64;
    var local_7: f64;
    var phi_2139_: f64;
    var phi_3066_: type_38;
    var phi_3067_: bool;
    var phi_3068_: type_38;
    var phi_3069_: bool;
    var phi_3075_: type_16;
    var phi_3078_: f64;
    var phi_3080_: u32;
    var phi_3082_: f64;
    var phi_3076_: type_16;
    var phi_3123_: type_17;
    var phi_3566_: type_9;
    var phi_3569_: f64;
    var phi_3571_: f64;
    var phi_3573_: f64;
    var phi_3575_: f64;
    var phi_3577_: bool;
    var phi_3579_: u32;
    var phi_3731_: array<f64, 3>;
    var phi_3799_: type_16;
    var phi_3802_: f64;
    var phi_3800_: type_16;
    var phi_3843_: type_17;
    var phi_3803_: f64;
    var local_8: f64;
    var phi_3856_: f64;
    var phi_3982_: type_39;
    var phi_3983_: bool;
    var phi_3984_: type_39;
    var phi_3985_: bool;
    var phi_3995_: type_39;
    var phi_4167_: bool;
    var phi_4168_: bool;
    var phi_4169_: bool;
    var phi_4170_: bool;
    var phi_4171_: bool;
    var phi_4172_: bool;
    var phi_4474_: bool;
    var phi_4475_: bool;
    var phi_4476_: bool;
    var phi_4477_: bool;
    var phi_4478_: bool;
    var phi_4479_: bool;
    var phi_4487_: bool;
    var phi_4597_: f64;
    var phi_4598_: bool;
    var phi_4599_: f64;
    var phi_4600_: bool;
    var phi_4601_: f64;
    var phi_4602_: bool;
    var phi_4603_: bool;
    var phi_4669_: f64;
    var phi_4670_: bool;
    var phi_4671_: f64;
    var phi_4672_: bool;
    var phi_4673_: f64;
    var phi_4674_: bool;
    var phi_4675_: bool;
    var phi_4746_: f64;
    var phi_4747_: bool;
    var phi_4748_: f64;
    var phi_4749_: bool;
    var phi_4750_: f64;
    var phi_4751_: bool;
    var phi_4752_: bool;
    var phi_4818_: f64;
    var phi_4819_: bool;
    var phi_4820_: f64;
    var phi_4821_: bool;
    var phi_4822_: f64;
    var phi_4823_: bool;
    var phi_4824_: bool;
    var phi_5001_: type_16;
    var phi_5004_: f64;
    var phi_5002_: type_16;
    var phi_5045_: type_17;
    var phi_5005_: f64;
    var local_9: f64;
    var phi_5058_: f64;
    var phi_5335_: bool;
    var phi_5336_: bool;
    var phi_5363_: f64;
    var phi_5364_: f64;
    var phi_5365_: bool;
    var phi_5366_: f64;
    var phi_5367_: f64;
    var phi_5368_: bool;
    var phi_5369_: bool;
    var phi_5370_: f64;
    var phi_5371_: f64;
    var phi_5372_: f64;
    var phi_5373_: f64;
    var phi_5374_: bool;
    var phi_5375_: bool;
    var phi_5376_: bool;
    var phi_5377_: bool;
    var phi_5378_: f64;
    var phi_5379_: f64;
    var phi_5380_: f64;
    var phi_5381_: f64;
    var phi_5382_: bool;
    var phi_5383_: bool;
    var phi_5384_: bool;
    var phi_5385_: bool;
    var phi_5386_: bool;
    var phi_5387_: f64;
    var phi_5388_: f64;
    var phi_5389_: f64;
    var phi_5390_: f64;
    var phi_5391_: bool;
    var phi_5392_: bool;
    var phi_5393_: bool;
    var phi_5394_: bool;
    var phi_5395_: bool;
    var phi_5733_: f64;
    var phi_5735_: u32;
    var phi_5736_: f64;
    var phi_5737_: bool;
    var phi_5738_: bool;
    var phi_5739_: bool;
    var phi_5740_: u32;
    var phi_5741_: f64;
    var phi_5742_: f64;
    var phi_5743_: f64;
    var phi_5744_: f64;
    var phi_5745_: bool;
    var phi_5746_: u32;
    var phi_5747_: bool;
    var phi_5748_: bool;
    var phi_5749_: bool;
    var phi_5750_: bool;
    var phi_5751_: bool;
    var phi_5752_: bool;
    var phi_5780_: f64;
    var phi_5781_: f64;
    var phi_5782_: f64;
    var phi_5783_: f64;
    var phi_5784_: bool;
    var phi_5785_: u32;
    var phi_5786_: bool;
    var phi_5787_: bool;
    var phi_5788_: bool;
    var phi_5789_: bool;
    var phi_5790_: bool;
    var phi_5791_: bool;
    var phi_3570_: f64;
    var phi_3572_: f64;
    var phi_3574_: f64;
    var phi_3576_: f64;
    var phi_3578_: bool;
    var phi_3580_: u32;
    var phi_5792_: f64;
    var phi_5793_: f64;
    var phi_5794_: bool;
    var phi_5795_: bool;
    var phi_5796_: bool;
    var phi_5797_: bool;
    var phi_5798_: bool;
    var phi_5799_: bool;
    var phi_5800_: bool;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: f64;
    var local_21: bool;
    var local_22: f64;
    var local_23: f64;
    var local_24: f64;
    var phi_5867_: f64;
    var phi_5868_: bool;
    var phi_6493_: type_16;
    var phi_6496_: f64;
    var phi_6494_: type_16;
    var phi_6537_: type_17;
    var phi_6497_: f64;
    var local_25: f64;
    var phi_6550_: f64;
    var phi_6788_: type_16;
    var phi_6791_: f64;
    var phi_6789_: type_16;
    var phi_6832_: type_17;
    var phi_6792_: f64;
    var local_26: f64;
    var phi_6845_: f64;
    var phi_6877_: type_16;
    var phi_6880_: f64;
    var phi_6878_: type_16;
    var phi_6921_: type_17;
    var phi_6881_: f64;
    var local_27: f64;
    var phi_6934_: f64;
    var phi_7252_: type_9;
    var phi_7255_: f64;
    var phi_7256_: f64;
    var local_28: f64;
    var local_29: f64;
    var phi_7357_: type_16;
    var phi_7360_: f64;
    var phi_7358_: type_16;
    var phi_7401_: type_17;
    var phi_7361_: f64;
    var local_30: f64;
    var phi_7414_: f64;
    var phi_7421_: type_9;
    var phi_7424_: f64;
    var phi_7426_: bool;
    var phi_7428_: bool;
    var phi_7664_: f64;
    var phi_7665_: f64;
    var phi_7425_: f64;
    var phi_7427_: bool;
    var phi_7429_: bool;
    var local_31: f64;
    var local_32: f64;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var local_36: bool;
    var phi_7683_: type_42;
    var phi_7684_: bool;
    var local_37: bool;
    var phi_7706_: type_9;
    var phi_7709_: f64;
    var phi_7711_: f64;
    var phi_7821_: f64;
    var phi_7822_: f64;
    var phi_7823_: f64;
    var phi_7824_: f64;
    var phi_7710_: f64;
    var phi_7712_: f64;
    var local_38: f64;
    var local_39: f64;
    var local_40: f64;
    var phi_7987_: bool;
    var phi_7988_: bool;
    var phi_7989_: bool;
    var phi_7990_: bool;
    var phi_7991_: bool;
    var phi_7992_: bool;
    var phi_8001_: bool;
    var phi_8002_: bool;
    var phi_8011_: type_42;
    var phi_8012_: type_42;
    var phi_8013_: bool;
    var phi_8014_: type_42;
    var phi_8015_: type_42;
    var phi_8016_: bool;
    var phi_8022_: type_42;
    var phi_8023_: type_42;
    var phi_8024_: bool;
    var phi_8028_: type_42;
    var phi_8029_: type_42;
    var phi_8030_: bool;
    var phi_8031_: bool;
    var phi_8032_: type_42;
    var phi_8033_: type_42;
    var phi_8034_: bool;
    var phi_8035_: bool;
    var phi_8070_: f64;
    var phi_8071_: f64;
    var phi_8072_: bool;
    var phi_8073_: bool;
    var phi_8074_: bool;
    var phi_8075_: f64;
    var phi_8076_: u32;
    var phi_8077_: f64;
    var phi_8078_: type_42;
    var phi_8079_: u32;
    var phi_8080_: u32;
    var phi_8081_: bool;
    var phi_8082_: bool;
    var phi_8083_: bool;
    var phi_8084_: f64;
    var phi_8085_: u32;
    var phi_8086_: f64;
    var phi_8087_: type_42;
    var phi_8088_: u32;
    var phi_8089_: u32;
    var phi_8090_: bool;
    var phi_8091_: bool;
    var phi_8092_: bool;
    var phi_8093_: bool;
    var phi_8094_: bool;
    var phi_8095_: f64;
    var phi_3079_: f64;
    var phi_3081_: u32;
    var phi_3083_: f64;
    var phi_8096_: type_42;
    var phi_8097_: u32;
    var phi_8098_: f64;
    var phi_8099_: u32;
    var phi_8100_: bool;
    var phi_8101_: bool;
    var phi_8102_: bool;
    var phi_8103_: bool;
    var phi_8104_: bool;
    var phi_8105_: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var local_49: type_42;
    var local_50: type_42;
    var local_51: u32;
    var local_52: type_42;
    var phi_8134_: type_38;
    var phi_8135_: type_38;
    var phi_8136_: bool;
    var phi_8137_: bool;
    var phi_8138_: bool;
    var phi_8139_: bool;
    var local_53: u32;
    var local_54: u32;
    var local_55: f64;
    var local_56: f64;
    var local_57: f64;
    var local_58: u32;
    var phi_8173_: type_9;
    var phi_8349_: type_16;
    var phi_8352_: f64;
    var phi_8350_: type_16;
    var phi_8393_: type_17;
    var phi_8353_: f64;
    var local_59: f64;
    var phi_8406_: f64;
    var phi_8683_: bool;
    var phi_8684_: bool;
    var local_60: bool;
    var phi_8696_: type_38;
    var phi_8697_: bool;
    var phi_8709_: type_38;
    var phi_8710_: type_38;
    var phi_8711_: bool;
    var phi_8712_: bool;
    var phi_8719_: type_38;
    var phi_8720_: bool;
    var phi_8724_: type_38;
    var phi_8725_: type_38;
    var phi_8726_: bool;
    var phi_8730_: type_38;
    var phi_8748_: type_35;
    var phi_8757_: type_9;
    var phi_8782_: bool;
    var phi_8825_: u32;
    var local_61: bool;
    var local_62: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e104 = id_2;
    let _e105 = n_2;
    let _e106 = lane_2;
    let _e118 = ((_e104.y * _e105.x) + _e104.x);
    let _e121 = (_e105.x * _e105.y);
    let _e124 = params.member.member_1.member_2;
    let _e126 = input.member[0u];
    let _e128 = select(_e126, _e124, (_e124 < _e126));
    let _e130 = params.member.member_1.member_1;
    if (_e128 > _e130) {
        let _e133 = params.member.member_1.member_1;
        phi_953_ = (_e128 - _e133);
    } else {
        phi_953_ = 0u;
    }
    let _e136 = phi_953_;
    let _e138 = params.member.member_1.member;
    let _e140 = select(_e136, _e138, (_e138 < _e136));
    let _e141 = (_e140 / 64u);
    let _e145 = select(_e141, (_e141 + 1u), ((_e140 % 64u) > 0u));
    if (_e145 > _e118) {
        let _e147 = (_e145 - _e118);
        if (_e121 == 0u) {
            return;
        }
        let _e149 = (_e147 / _e121);
        if (_e121 == 0u) {
            return;
        }
        phi_998_ = select(_e149, (_e149 + 1u), ((_e147 % _e121) > 0u));
    } else {
        phi_998_ = 0u;
    }
    let _e156 = phi_998_;
    phi_1001_ = type_9(0u, _e156);
    loop {
        let _e159 = phi_1001_;
        let _e162 = (_e159.member < _e159.member_1);
        let _e175 = (bitcast<i32>(select(0u, 1u, _e162)) != 0i);
        if _e175 {
            let _e179 = (((_e118 + (select(type_9().member_1, _e159.member, _e162) * _e121)) * 64u) + _e106);
            local_6 = type_35(0u, 0u, array<u32, 2>(0u, 0u), false);
            if (_e179 < _e140) {
                let _e183 = params.member.member_1.member_1;
                let _e185 = (2u * (_e183 + _e179));
                let _e188 = input.member[(4u + _e185)];
                let _e191 = input.member[(_e185 + 5u)];
                let _e196 = (_e191 & 2147483647u);
                if (select(1u, 0u, ((_e191 & 2147483648u) == 0u)) == 0u) {
                    let _e215 = params.member.member.member[1u];
                    let _e218 = ((2u * _e215) + (3u * _e196));
                    let _e220 = elements.member[_e218];
                    let _e223 = elements.member[(_e218 + 1u)];
                    let _e226 = elements.member[(_e218 + 2u)];
                    phi_1175_ = type_23(0u, array<u32, 4>(_e188, _e220, _e223, _e226));
                } else {
                    let _e199 = (2u * _e188);
                    let _e201 = elements.member[_e199];
                    let _e204 = elements.member[(_e199 + 1u)];
                    let _e205 = (2u * _e196);
                    let _e207 = elements.member[_e205];
                    let _e210 = elements.member[(_e205 + 1u)];
                    phi_1175_ = type_23(1u, array<u32, 4>(_e201, _e204, _e207, _e210));
                }
                let _e230 = phi_1175_;
                let _e234 = params.member.member.member_1;
                if ((_e234 & 8u) != 0u) {
                    let _e278 = paths.member[_e230.member_1[0]];
                    let _e293 = paths.member[_e230.member_1[1]];
                    let _e308 = paths.member[_e230.member_1[2]];
                    let _e323 = paths.member[_e230.member_1[3]];
                    let _e344 = function_(array<f32, 3>(_e278.member.x, _e278.member.y, _e278.member.z));
                    let _e345 = function_(array<f32, 3>(_e293.member.x, _e293.member.y, _e293.member.z));
                    let _e346 = function_(array<f32, 3>(_e308.member.x, _e308.member.y, _e308.member.z));
                    let _e347 = function_(array<f32, 3>(_e323.member.x, _e323.member.y, _e323.member.z));
                    let _e349 = function_(array<f32, 3>(_e278.member_1.x, _e278.member_1.y, _e278.member_1.z));
                    let _e350 = function_(array<f32, 3>(_e293.member_1.x, _e293.member_1.y, _e293.member_1.z));
                    let _e351 = function_(array<f32, 3>(_e308.member_1.x, _e308.member_1.y, _e308.member_1.z));
                    let _e352 = function_(array<f32, 3>(_e323.member_1.x, _e323.member_1.y, _e323.member_1.z));
                    phi_1371_ = type_31(array<array<f64, 3>, 4>(_e344, _e345, _e346, _e347), array<array<f64, 3>, 4>(_e349, _e350, _e351, _e352));
                } else {
                    let _e239 = positions.member[_e230.member_1[0]];
                    let _e242 = params.member.member.member[0u];
                    let _e245 = positions.member[(_e242 + _e230.member_1[0])];
                    let _e248 = positions.member[_e230.member_1[1]];
                    let _e251 = params.member.member.member[0u];
                    let _e254 = positions.member[(_e251 + _e230.member_1[1])];
                    let _e257 = positions.member[_e230.member_1[2]];
                    let _e260 = params.member.member.member[0u];
                    let _e263 = positions.member[(_e260 + _e230.member_1[2])];
                    let _e266 = positions.member[_e230.member_1[3]];
                    let _e269 = params.member.member.member[0u];
                    let _e272 = positions.member[(_e269 + _e230.member_1[3])];
                    phi_1371_ = type_31(array<array<f64, 3>, 4>(_e239, _e248, _e257, _e266), array<array<f64, 3>, 4>(_e245, _e254, _e263, _e272));
                }
                let _e356 = phi_1371_;
                if (_e230.member != 0u) {
                    phi_1532_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e356.member[2][0] - _e356.member[0][0]), (_e356.member[2][1] - _e356.member[0][1]), (_e356.member[2][2] - _e356.member[0][2])), array<f64, 3>((_e356.member_1[2][0] - _e356.member_1[0][0]), (_e356.member_1[2][1] - _e356.member_1[0][1]), (_e356.member_1[2][2] - _e356.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e356.member[1][0] - _e356.member[0][0]), (_e356.member[1][1] - _e356.member[0][1]), (_e356.member[1][2] - _e356.member[0][2])), array<f64, 3>((_e356.member_1[1][0] - _e356.member_1[0][0]), (_e356.member_1[1][1] - _e356.member_1[0][1]), (_e356.member_1[1][2] - _e356.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e356.member[2][0] - _e356.member[3][0]), (_e356.member[2][1] - _e356.member[3][1]), (_e356.member[2][2] - _e356.member[3][2])), array<f64, 3>((_e356.member_1[2][0] - _e356.member_1[3][0]), (_e356.member_1[2][1] - _e356.member_1[3][1]), (_e356.member_1[2][2] - _e356.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_1532_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e356.member[0][0] - _e356.member[1][0]), (_e356.member[0][1] - _e356.member[1][1]), (_e356.member[0][2] - _e356.member[1][2])), array<f64, 3>((_e356.member_1[0][0] - _e356.member_1[1][0]), (_e356.member_1[0][1] - _e356.member_1[1][1]), (_e356.member_1[0][2] - _e356.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e356.member[2][0] - _e356.member[1][0]), (_e356.member[2][1] - _e356.member[1][1]), (_e356.member[2][2] - _e356.member[1][2])), array<f64, 3>((_e356.member_1[2][0] - _e356.member_1[1][0]), (_e356.member_1[2][1] - _e356.member_1[1][1]), (_e356.member_1[2][2] - _e356.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e356.member[3][0] - _e356.member[1][0]), (_e356.member[3][1] - _e356.member[1][1]), (_e356.member[3][2] - _e356.member[1][2])), array<f64, 3>((_e356.member_1[3][0] - _e356.member_1[1][0]), (_e356.member_1[3][1] - _e356.member_1[1][1]), (_e356.member_1[3][2] - _e356.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e515 = phi_1532_;
                let _e517 = params.member.member.member_7;
                let _e524 = bitcast<f64>(((u64(_e517[1]) * 4294967296lu) + u64(_e517[0])));
                let _e526 = params.member.member.member_14;
                let _e533 = bitcast<f64>(((u64(_e526[1]) * 4294967296lu) + u64(_e526[0])));
                let _e535 = params.member.member.member_15;
                let _e542 = bitcast<f64>(((u64(_e535[1]) * 4294967296lu) + u64(_e535[0])));
                let _e544 = params.member.member.member_16;
                let _e551 = bitcast<f64>(((u64(_e544[1]) * 4294967296lu) + u64(_e544[0])));
                let _e553 = params.member.member.member_1;
                let _e561 = select(_e515.member[0][0], -(_e515.member[0][0]), (_e515.member[0][0] < 0.0lf));
                let _e565 = select(_e515.member[0][1], -(_e515.member[0][1]), (_e515.member[0][1] < 0.0lf));
                let _e567 = select(_e565, _e561, (_e561 > _e565));
                let _e571 = select(_e515.member[0][2], -(_e515.member[0][2]), (_e515.member[0][2] < 0.0lf));
                let _e573 = select(_e571, _e567, (_e567 > _e571));
                let _e579 = select(_e515.member[1][0], -(_e515.member[1][0]), (_e515.member[1][0] < 0.0lf));
                let _e583 = select(_e515.member[1][1], -(_e515.member[1][1]), (_e515.member[1][1] < 0.0lf));
                let _e585 = select(_e583, _e579, (_e579 > _e583));
                let _e589 = select(_e515.member[1][2], -(_e515.member[1][2]), (_e515.member[1][2] < 0.0lf));
                let _e591 = select(_e589, _e585, (_e585 > _e589));
                let _e595 = (select(_e591, _e573, (_e573 > _e591)) + _e515.member_3);
                let _e601 = select(_e515.member_1[0][0], -(_e515.member_1[0][0]), (_e515.member_1[0][0] < 0.0lf));
                let _e605 = select(_e515.member_1[0][1], -(_e515.member_1[0][1]), (_e515.member_1[0][1] < 0.0lf));
                let _e607 = select(_e605, _e601, (_e601 > _e605));
                let _e611 = select(_e515.member_1[0][2], -(_e515.member_1[0][2]), (_e515.member_1[0][2] < 0.0lf));
                let _e613 = select(_e611, _e607, (_e607 > _e611));
                let _e619 = select(_e515.member_1[1][0], -(_e515.member_1[1][0]), (_e515.member_1[1][0] < 0.0lf));
                let _e623 = select(_e515.member_1[1][1], -(_e515.member_1[1][1]), (_e515.member_1[1][1] < 0.0lf));
                let _e625 = select(_e623, _e619, (_e619 > _e623));
                let _e629 = select(_e515.member_1[1][2], -(_e515.member_1[1][2]), (_e515.member_1[1][2] < 0.0lf));
                let _e631 = select(_e629, _e625, (_e625 > _e629));
                let _e635 = (select(_e631, _e613, (_e613 > _e631)) + _e515.member_3);
                let _e641 = select(_e515.member_2[0][0], -(_e515.member_2[0][0]), (_e515.member_2[0][0] < 0.0lf));
                let _e645 = select(_e515.member_2[0][1], -(_e515.member_2[0][1]), (_e515.member_2[0][1] < 0.0lf));
                let _e647 = select(_e645, _e641, (_e641 > _e645));
                let _e651 = select(_e515.member_2[0][2], -(_e515.member_2[0][2]), (_e515.member_2[0][2] < 0.0lf));
                let _e653 = select(_e651, _e647, (_e647 > _e651));
                let _e659 = select(_e515.member_2[1][0], -(_e515.member_2[1][0]), (_e515.member_2[1][0] < 0.0lf));
                let _e663 = select(_e515.member_2[1][1], -(_e515.member_2[1][1]), (_e515.member_2[1][1] < 0.0lf));
                let _e665 = select(_e663, _e659, (_e659 > _e663));
                let _e669 = select(_e515.member_2[1][2], -(_e515.member_2[1][2]), (_e515.member_2[1][2] < 0.0lf));
                let _e671 = select(_e669, _e665, (_e665 > _e669));
                let _e675 = (select(_e671, _e653, (_e653 > _e671)) + _e515.member_3);
                let _e677 = select(_e635, _e595, (_e595 > _e635));
                let _e679 = select(_e675, _e677, (_e677 > _e675));
                if (_e679 <= f64(65536f)) {
                    phi_1806_ = (_e679 >= f64((1f / 65536f)));
                } else {
                    phi_1806_ = false;
                }
                let _e686 = phi_1806_;
                if _e686 {
                    phi_1906_ = type_36();
                    phi_1907_ = true;
                } else {
                    if (_e679 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e679) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e693 = (9214364837600034816lu - (bitcast<u64>(_e679) & 9218868437227405312lu));
                            let _e696 = bitcast<f64>(select(4503599627370496lu, _e693, (_e693 > 4503599627370496lu)));
                            let _e697 = (_e524 * _e696);
                            phi_1902_ = type_36(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e515.member[0][0] * _e696), (_e515.member[0][1] * _e696), (_e515.member[0][2] * _e696)), array<f64, 3>((_e515.member[1][0] * _e696), (_e515.member[1][1] * _e696), (_e515.member[1][2] * _e696))), array<array<f64, 3>, 2>(array<f64, 3>((_e515.member_1[0][0] * _e696), (_e515.member_1[0][1] * _e696), (_e515.member_1[0][2] * _e696)), array<f64, 3>((_e515.member_1[1][0] * _e696), (_e515.member_1[1][1] * _e696), (_e515.member_1[1][2] * _e696))), array<array<f64, 3>, 2>(array<f64, 3>((_e515.member_2[0][0] * _e696), (_e515.member_2[0][1] * _e696), (_e515.member_2[0][2] * _e696)), array<f64, 3>((_e515.member_2[1][0] * _e696), (_e515.member_2[1][1] * _e696), (_e515.member_2[1][2] * _e696))), ((_e515.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e696)), select(_e697, select(2.2250738585072014e-308lf, _e697, (_e697 > 2.2250738585072014e-308lf)), (_e524 > f64(0f))));
                            phi_1903_ = false;
                        } else {
                            phi_1902_ = type_36();
                            phi_1903_ = true;
                        }
                        let _e768 = phi_1902_;
                        let _e770 = phi_1903_;
                        phi_1904_ = _e768;
                        phi_1905_ = _e770;
                    } else {
                        phi_1904_ = type_36();
                        phi_1905_ = true;
                    }
                    let _e772 = phi_1904_;
                    let _e774 = phi_1905_;
                    phi_1906_ = _e772;
                    phi_1907_ = _e774;
                }
                let _e776 = phi_1906_;
                let _e778 = phi_1907_;
                if _e778 {
                    phi_1912_ = type_36(_e515, _e524);
                } else {
                    phi_1912_ = _e776;
                }
                let _e781 = phi_1912_;
                local_5 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e781.member.member[0][0], _e781.member.member[0][1], _e781.member.member[0][2]), array<f64, 3>(_e781.member.member[1][0], _e781.member.member[1][1], _e781.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e781.member.member_1[0][0], _e781.member.member_1[0][1], _e781.member.member_1[0][2]), array<f64, 3>(_e781.member.member_1[1][0], _e781.member.member_1[1][1], _e781.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e781.member.member_2[0][0], _e781.member.member_2[0][1], _e781.member.member_2[0][2]), array<f64, 3>(_e781.member.member_2[1][0], _e781.member.member_2[1][1], _e781.member.member_2[1][2])), _e781.member.member_3);
                let _e824 = local_5.member[0u];
                let _e830 = local_5.member[1u];
                let _e846 = local_5.member_1[0u];
                let _e852 = local_5.member_1[1u];
                let _e868 = local_5.member_2[0u];
                let _e874 = local_5.member_2[1u];
                let _e888 = function_4(array<f64, 3>((_e824[0] + ((_e830[0] - _e824[0]) * _e542)), (_e824[1] + ((_e830[1] - _e824[1]) * _e542)), (_e824[2] + ((_e830[2] - _e824[2]) * _e542))), array<f64, 3>((_e846[0] + ((_e852[0] - _e846[0]) * _e542)), (_e846[1] + ((_e852[1] - _e846[1]) * _e542)), (_e846[2] + ((_e852[2] - _e846[2]) * _e542))), array<f64, 3>((_e868[0] + ((_e874[0] - _e868[0]) * _e542)), (_e868[1] + ((_e874[1] - _e868[1]) * _e542)), (_e868[2] + ((_e874[2] - _e868[2]) * _e542))), _e230.member);
                let _e899 = (((_e888[0] * _e888[0]) + (_e888[1] * _e888[1])) + (_e888[2] * _e888[2]));
                if (_e899 <= 2.2250738585072014e-308lf) {
                    phi_2139_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e899 > 0.0lf));
                } else {
                    phi_2082_ = type_16(0i, 5i);
                    phi_2085_ = bitcast<f64>(((bitcast<u64>(_e899) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e906 = phi_2082_;
                        let _e908 = phi_2085_;
                        local_7 = _e908;
                        if (_e906.member < _e906.member_1) {
                            let _e915 = (_e906.member + 1i);
                            phi_2083_ = type_16(select(_e915, type_17().member_1, select(false, true, ((false == (_e915 > _e906.member)) != false))), _e906.member_1);
                            phi_2126_ = type_17(1u, _e906.member);
                        } else {
                            phi_2083_ = _e906;
                            phi_2126_ = type_17(0u, type_17().member_1);
                        }
                        let _e926 = phi_2083_;
                        let _e928 = phi_2126_;
                        let _e931 = (bitcast<i32>(_e928.member) != 0i);
                        if _e931 {
                            phi_2086_ = (0.5lf * (_e908 + (_e899 / _e908)));
                        } else {
                            phi_2086_ = f64();
                        }
                        let _e936 = phi_2086_;
                        continue;
                        continuing {
                            phi_2082_ = _e926;
                            phi_2085_ = _e936;
                            break if !(_e931);
                        }
                    }
                    let _e941 = local_7;
                    phi_2139_ = (_e941 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e947 = phi_2139_;
                let _e955 = local_5.member[0u];
                let _e961 = select(_e955[0], -(_e955[0]), (_e955[0] < 0.0lf));
                let _e964 = select(_e955[1], -(_e955[1]), (_e955[1] < 0.0lf));
                let _e966 = select(_e964, _e961, (_e961 > _e964));
                let _e969 = select(_e955[2], -(_e955[2]), (_e955[2] < 0.0lf));
                let _e971 = select(_e969, _e966, (_e966 > _e969));
                let _e974 = local_5.member[1u];
                let _e980 = select(_e974[0], -(_e974[0]), (_e974[0] < 0.0lf));
                let _e983 = select(_e974[1], -(_e974[1]), (_e974[1] < 0.0lf));
                let _e985 = select(_e983, _e980, (_e980 > _e983));
                let _e988 = select(_e974[2], -(_e974[2]), (_e974[2] < 0.0lf));
                let _e990 = select(_e988, _e985, (_e985 > _e988));
                let _e994 = local_5.member_3;
                let _e998 = local_5.member_1[0u];
                let _e1004 = select(_e998[0], -(_e998[0]), (_e998[0] < 0.0lf));
                let _e1007 = select(_e998[1], -(_e998[1]), (_e998[1] < 0.0lf));
                let _e1009 = select(_e1007, _e1004, (_e1004 > _e1007));
                let _e1012 = select(_e998[2], -(_e998[2]), (_e998[2] < 0.0lf));
                let _e1014 = select(_e1012, _e1009, (_e1009 > _e1012));
                let _e1017 = local_5.member_1[1u];
                let _e1023 = select(_e1017[0], -(_e1017[0]), (_e1017[0] < 0.0lf));
                let _e1026 = select(_e1017[1], -(_e1017[1]), (_e1017[1] < 0.0lf));
                let _e1028 = select(_e1026, _e1023, (_e1023 > _e1026));
                let _e1031 = select(_e1017[2], -(_e1017[2]), (_e1017[2] < 0.0lf));
                let _e1033 = select(_e1031, _e1028, (_e1028 > _e1031));
                let _e1037 = local_5.member_3;
                let _e1041 = local_5.member_2[0u];
                let _e1047 = select(_e1041[0], -(_e1041[0]), (_e1041[0] < 0.0lf));
                let _e1050 = select(_e1041[1], -(_e1041[1]), (_e1041[1] < 0.0lf));
                let _e1052 = select(_e1050, _e1047, (_e1047 > _e1050));
                let _e1055 = select(_e1041[2], -(_e1041[2]), (_e1041[2] < 0.0lf));
                let _e1057 = select(_e1055, _e1052, (_e1052 > _e1055));
                let _e1060 = local_5.member_2[1u];
                let _e1066 = select(_e1060[0], -(_e1060[0]), (_e1060[0] < 0.0lf));
                let _e1069 = select(_e1060[1], -(_e1060[1]), (_e1060[1] < 0.0lf));
                let _e1071 = select(_e1069, _e1066, (_e1066 > _e1069));
                let _e1074 = select(_e1060[2], -(_e1060[2]), (_e1060[2] < 0.0lf));
                let _e1076 = select(_e1074, _e1071, (_e1071 > _e1074));
                let _e1080 = local_5.member_3;
                let _e1088 = local_5.member_3;
                let _e1098 = (((_e947 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e990, _e971, (_e971 > _e990)) + _e994) + (select(_e1033, _e1014, (_e1014 > _e1033)) + _e1037)) + (select(_e1076, _e1057, (_e1057 > _e1076)) + _e1080)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1088 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e781.member_1);
                if _e1098 {
                    phi_3068_ = type_38();
                    phi_3069_ = true;
                } else {
                    let _e1101 = local_5.member_1[0u];
                    let _e1107 = local_5.member_2[0u];
                    let _e1113 = ((_e1101[1] * _e1107[2]) - (_e1101[2] * _e1107[1]));
                    let _e1116 = ((_e1101[2] * _e1107[0]) - (_e1101[0] * _e1107[2]));
                    let _e1119 = ((_e1101[0] * _e1107[1]) - (_e1101[1] * _e1107[0]));
                    let _e1122 = local_5.member_1[1u];
                    let _e1128 = local_5.member_2[1u];
                    let _e1134 = ((_e1122[1] * _e1128[2]) - (_e1122[2] * _e1128[1]));
                    let _e1137 = ((_e1122[2] * _e1128[0]) - (_e1122[0] * _e1128[2]));
                    let _e1140 = ((_e1122[0] * _e1128[1]) - (_e1122[1] * _e1128[0]));
                    let _e1143 = local_5.member_1[0u];
                    let _e1149 = local_5.member_2[1u];
                    let _e1164 = local_5.member_1[1u];
                    let _e1170 = local_5.member_2[0u];
                    let _e1183 = (((_e1143[1] * _e1149[2]) - (_e1143[2] * _e1149[1])) + ((_e1164[1] * _e1170[2]) - (_e1164[2] * _e1170[1])));
                    let _e1184 = (((_e1143[2] * _e1149[0]) - (_e1143[0] * _e1149[2])) + ((_e1164[2] * _e1170[0]) - (_e1164[0] * _e1170[2])));
                    let _e1185 = (((_e1143[0] * _e1149[1]) - (_e1143[1] * _e1149[0])) + ((_e1164[0] * _e1170[1]) - (_e1164[1] * _e1170[0])));
                    let _e1188 = local_5.member[0u];
                    let _e1199 = local_5.member[1u];
                    let _e1210 = local_5.member[0u];
                    let _e1219 = ((((_e1199[0] * _e1113) + (_e1199[1] * _e1116)) + (_e1199[2] * _e1119)) + (((_e1210[0] * _e1183) + (_e1210[1] * _e1184)) + (_e1210[2] * _e1185)));
                    let _e1222 = local_5.member[0u];
                    let _e1233 = local_5.member[1u];
                    let _e1242 = ((((_e1222[0] * _e1134) + (_e1222[1] * _e1137)) + (_e1222[2] * _e1140)) + (((_e1233[0] * _e1183) + (_e1233[1] * _e1184)) + (_e1233[2] * _e1185)));
                    let _e1245 = local_5.member[1u];
                    let _e1256 = local_5.member[0u];
                    let _e1262 = select(_e1256[0], -(_e1256[0]), (_e1256[0] < 0.0lf));
                    let _e1265 = select(_e1256[1], -(_e1256[1]), (_e1256[1] < 0.0lf));
                    let _e1267 = select(_e1265, _e1262, (_e1262 > _e1265));
                    let _e1270 = select(_e1256[2], -(_e1256[2]), (_e1256[2] < 0.0lf));
                    let _e1272 = select(_e1270, _e1267, (_e1267 > _e1270));
                    let _e1275 = local_5.member[1u];
                    let _e1281 = select(_e1275[0], -(_e1275[0]), (_e1275[0] < 0.0lf));
                    let _e1284 = select(_e1275[1], -(_e1275[1]), (_e1275[1] < 0.0lf));
                    let _e1286 = select(_e1284, _e1281, (_e1281 > _e1284));
                    let _e1289 = select(_e1275[2], -(_e1275[2]), (_e1275[2] < 0.0lf));
                    let _e1291 = select(_e1289, _e1286, (_e1286 > _e1289));
                    let _e1295 = local_5.member_3;
                    let _e1296 = (select(_e1291, _e1272, (_e1272 > _e1291)) + _e1295);
                    let _e1299 = local_5.member_1[0u];
                    let _e1305 = select(_e1299[0], -(_e1299[0]), (_e1299[0] < 0.0lf));
                    let _e1308 = select(_e1299[1], -(_e1299[1]), (_e1299[1] < 0.0lf));
                    let _e1310 = select(_e1308, _e1305, (_e1305 > _e1308));
                    let _e1313 = select(_e1299[2], -(_e1299[2]), (_e1299[2] < 0.0lf));
                    let _e1315 = select(_e1313, _e1310, (_e1310 > _e1313));
                    let _e1318 = local_5.member_1[1u];
                    let _e1324 = select(_e1318[0], -(_e1318[0]), (_e1318[0] < 0.0lf));
                    let _e1327 = select(_e1318[1], -(_e1318[1]), (_e1318[1] < 0.0lf));
                    let _e1329 = select(_e1327, _e1324, (_e1324 > _e1327));
                    let _e1332 = select(_e1318[2], -(_e1318[2]), (_e1318[2] < 0.0lf));
                    let _e1334 = select(_e1332, _e1329, (_e1329 > _e1332));
                    let _e1338 = local_5.member_3;
                    let _e1339 = (select(_e1334, _e1315, (_e1315 > _e1334)) + _e1338);
                    let _e1342 = local_5.member_2[0u];
                    let _e1348 = select(_e1342[0], -(_e1342[0]), (_e1342[0] < 0.0lf));
                    let _e1351 = select(_e1342[1], -(_e1342[1]), (_e1342[1] < 0.0lf));
                    let _e1353 = select(_e1351, _e1348, (_e1348 > _e1351));
                    let _e1356 = select(_e1342[2], -(_e1342[2]), (_e1342[2] < 0.0lf));
                    let _e1358 = select(_e1356, _e1353, (_e1353 > _e1356));
                    let _e1361 = local_5.member_2[1u];
                    let _e1367 = select(_e1361[0], -(_e1361[0]), (_e1361[0] < 0.0lf));
                    let _e1370 = select(_e1361[1], -(_e1361[1]), (_e1361[1] < 0.0lf));
                    let _e1372 = select(_e1370, _e1367, (_e1367 > _e1370));
                    let _e1375 = select(_e1361[2], -(_e1361[2]), (_e1361[2] < 0.0lf));
                    let _e1377 = select(_e1375, _e1372, (_e1372 > _e1375));
                    let _e1381 = local_5.member_3;
                    let _e1382 = (select(_e1377, _e1358, (_e1358 > _e1377)) + _e1381);
                    let _e1383 = f64(1f);
                    let _e1384 = f64(8f);
                    let _e1386 = ((_e1339 * _e1384) * _e1382);
                    let _e1394 = local_5.member_3;
                    let _e1421 = ((select(_e1113, -(_e1113), (_e1113 < 0.0lf)) + select(_e1116, -(_e1116), (_e1116 < 0.0lf))) + select(_e1119, -(_e1119), (_e1119 < 0.0lf)));
                    let _e1432 = ((select(_e1134, -(_e1134), (_e1134 < 0.0lf)) + select(_e1137, -(_e1137), (_e1137 < 0.0lf))) + select(_e1140, -(_e1140), (_e1140 < 0.0lf)));
                    let _e1434 = select(_e1432, _e1421, (_e1421 > _e1432));
                    let _e1446 = (((select(_e1183, -(_e1183), (_e1183 < 0.0lf)) + select(_e1184, -(_e1184), (_e1184 < 0.0lf))) + select(_e1185, -(_e1185), (_e1185 < 0.0lf))) * f64(0.5f));
                    let _e1454 = local_5.member_3;
                    let _e1469 = f64(3f);
                    let _e1470 = ((((_e1188[0] * _e1113) + (_e1188[1] * _e1116)) + (_e1188[2] * _e1119)) * _e1469);
                    let _e1471 = ((((_e1245[0] * _e1134) + (_e1245[1] * _e1137)) + (_e1245[2] * _e1140)) * _e1469);
                    let _e1473 = select(_e1471, _e1470, (_e1470 < _e1471));
                    let _e1475 = select(_e1242, _e1219, (_e1219 < _e1242));
                    let _e1477 = select(_e1475, _e1473, (_e1473 < _e1475));
                    let _e1479 = select(_e1471, _e1470, (_e1470 > _e1471));
                    let _e1481 = select(_e1242, _e1219, (_e1219 > _e1242));
                    let _e1484 = -(select(_e1481, _e1479, (_e1479 > _e1481)));
                    if ((select(_e1484, _e1477, (_e1477 > _e1484)) - ((((((_e1296 * _e1384) * _e1386) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1394 * f64(19f)) * ((_e1296 * (_e1339 + _e1382)) + (_e1339 * _e1382)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1383 + _e1296) * ((_e1383 + _e1339) * (_e1383 + _e1382))))) + ((_e781.member_1 * (((select(_e1446, _e1434, (_e1434 > _e1446)) + (_e1386 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1454 * f64(6f)) * (_e1339 + _e1382))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1383 + _e1339) * (_e1383 + _e1382))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                        phi_3066_ = type_38(type_37(0u, f64()), 0u);
                        phi_3067_ = false;
                    } else {
                        phi_3066_ = type_38();
                        phi_3067_ = true;
                    }
                    let _e1498 = phi_3066_;
                    let _e1500 = phi_3067_;
                    phi_3068_ = _e1498;
                    phi_3069_ = _e1500;
                }
                let _e1502 = phi_3068_;
                let _e1504 = phi_3069_;
                if _e1504 {
                    phi_3075_ = type_16(0i, 2i);
                    phi_3078_ = _e542;
                    phi_3080_ = 0u;
                    phi_3082_ = _e542;
                    loop {
                        let _e1506 = phi_3075_;
                        let _e1508 = phi_3078_;
                        let _e1510 = phi_3080_;
                        let _e1512 = phi_3082_;
                        local_54 = _e1510;
                        local_57 = _e1508;
                        local_58 = _e1510;
                        if (_e1506.member < _e1506.member_1) {
                            let _e1519 = (_e1506.member + 1i);
                            phi_3076_ = type_16(select(_e1519, type_17().member_1, select(false, true, ((false == (_e1519 > _e1506.member)) != false))), _e1506.member_1);
                            phi_3123_ = type_17(1u, _e1506.member);
                        } else {
                            phi_3076_ = _e1506;
                            phi_3123_ = type_17(0u, type_17().member_1);
                        }
                        let _e1530 = phi_3076_;
                        let _e1532 = phi_3123_;
                        if (bitcast<i32>(_e1532.member) != 0i) {
                            if select(select(true, false, _e1098), true, (_e1532.member_1 > 0i)) {
                                let _e1542 = local_5.member[0u];
                                let _e1548 = local_5.member_1[0u];
                                let _e1554 = local_5.member_2[0u];
                                let _e1558 = (_e1542[0] - _e1548[0]);
                                let _e1559 = (_e1542[1] - _e1548[1]);
                                let _e1560 = (_e1542[2] - _e1548[2]);
                                let _e1561 = (_e230.member == 0u);
                                let _e1573 = local_5.member[1u];
                                let _e1579 = local_5.member_1[1u];
                                let _e1585 = local_5.member_2[1u];
                                let _e1589 = (_e1573[0] - _e1579[0]);
                                let _e1590 = (_e1573[1] - _e1579[1]);
                                let _e1591 = (_e1573[2] - _e1579[2]);
                                let _e1592 = (_e230.member == 0u);
                                let _e1604 = local_5.member[0u];
                                let _e1610 = select(_e1604[0], -(_e1604[0]), (_e1604[0] < 0.0lf));
                                let _e1613 = select(_e1604[1], -(_e1604[1]), (_e1604[1] < 0.0lf));
                                let _e1615 = select(_e1613, _e1610, (_e1610 > _e1613));
                                let _e1618 = select(_e1604[2], -(_e1604[2]), (_e1604[2] < 0.0lf));
                                let _e1620 = select(_e1618, _e1615, (_e1615 > _e1618));
                                let _e1623 = local_5.member[1u];
                                let _e1629 = select(_e1623[0], -(_e1623[0]), (_e1623[0] < 0.0lf));
                                let _e1632 = select(_e1623[1], -(_e1623[1]), (_e1623[1] < 0.0lf));
                                let _e1634 = select(_e1632, _e1629, (_e1629 > _e1632));
                                let _e1637 = select(_e1623[2], -(_e1623[2]), (_e1623[2] < 0.0lf));
                                let _e1639 = select(_e1637, _e1634, (_e1634 > _e1637));
                                let _e1643 = local_5.member_3;
                                let _e1647 = local_5.member_1[0u];
                                let _e1653 = select(_e1647[0], -(_e1647[0]), (_e1647[0] < 0.0lf));
                                let _e1656 = select(_e1647[1], -(_e1647[1]), (_e1647[1] < 0.0lf));
                                let _e1658 = select(_e1656, _e1653, (_e1653 > _e1656));
                                let _e1661 = select(_e1647[2], -(_e1647[2]), (_e1647[2] < 0.0lf));
                                let _e1663 = select(_e1661, _e1658, (_e1658 > _e1661));
                                let _e1666 = local_5.member_1[1u];
                                let _e1672 = select(_e1666[0], -(_e1666[0]), (_e1666[0] < 0.0lf));
                                let _e1675 = select(_e1666[1], -(_e1666[1]), (_e1666[1] < 0.0lf));
                                let _e1677 = select(_e1675, _e1672, (_e1672 > _e1675));
                                let _e1680 = select(_e1666[2], -(_e1666[2]), (_e1666[2] < 0.0lf));
                                let _e1682 = select(_e1680, _e1677, (_e1677 > _e1680));
                                let _e1686 = local_5.member_3;
                                let _e1690 = local_5.member_2[0u];
                                let _e1696 = select(_e1690[0], -(_e1690[0]), (_e1690[0] < 0.0lf));
                                let _e1699 = select(_e1690[1], -(_e1690[1]), (_e1690[1] < 0.0lf));
                                let _e1701 = select(_e1699, _e1696, (_e1696 > _e1699));
                                let _e1704 = select(_e1690[2], -(_e1690[2]), (_e1690[2] < 0.0lf));
                                let _e1706 = select(_e1704, _e1701, (_e1701 > _e1704));
                                let _e1709 = local_5.member_2[1u];
                                let _e1715 = select(_e1709[0], -(_e1709[0]), (_e1709[0] < 0.0lf));
                                let _e1718 = select(_e1709[1], -(_e1709[1]), (_e1709[1] < 0.0lf));
                                let _e1720 = select(_e1718, _e1715, (_e1715 > _e1718));
                                let _e1723 = select(_e1709[2], -(_e1709[2]), (_e1709[2] < 0.0lf));
                                let _e1725 = select(_e1723, _e1720, (_e1720 > _e1723));
                                let _e1729 = local_5.member_3;
                                let _e1737 = local_5.member_3;
                                let _e1745 = (_e533 * f64(0.00390625f));
                                let _e1746 = f64(0f);
                                let _e1747 = f64(1f);
                                local_3 = type_39(array<f64, 4>(_e1746, _e1746, _e1746, _e1746), array<f64, 4>(_e1746, _e1746, _e1746, _e1746), array<f64, 4>(_e1747, _e1747, _e1747, _e1747));
                                phi_3566_ = type_9(0u, 96u);
                                phi_3569_ = _e1512;
                                phi_3571_ = _e1512;
                                phi_3573_ = (_e551 - _e1512);
                                phi_3575_ = _e1512;
                                phi_3577_ = false;
                                phi_3579_ = 0u;
                                loop {
                                    let _e1754 = phi_3566_;
                                    let _e1756 = phi_3569_;
                                    let _e1758 = phi_3571_;
                                    let _e1760 = phi_3573_;
                                    let _e1762 = phi_3575_;
                                    let _e1764 = phi_3577_;
                                    let _e1766 = phi_3579_;
                                    local_20 = _e1756;
                                    local_24 = _e1758;
                                    let _e1769 = (_e1754.member < _e1754.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e1769)) != 0i) {
                                        let _e1783 = local_5.member[0u];
                                        let _e1789 = local_5.member[1u];
                                        let _e1805 = local_5.member_1[0u];
                                        let _e1811 = local_5.member_1[1u];
                                        let _e1827 = local_5.member_2[0u];
                                        let _e1833 = local_5.member_2[1u];
                                        let _e1847 = function_4(array<f64, 3>((_e1783[0] + ((_e1789[0] - _e1783[0]) * _e1756)), (_e1783[1] + ((_e1789[1] - _e1783[1]) * _e1756)), (_e1783[2] + ((_e1789[2] - _e1783[2]) * _e1756))), array<f64, 3>((_e1805[0] + ((_e1811[0] - _e1805[0]) * _e1756)), (_e1805[1] + ((_e1811[1] - _e1805[1]) * _e1756)), (_e1805[2] + ((_e1811[2] - _e1805[2]) * _e1756))), array<f64, 3>((_e1827[0] + ((_e1833[0] - _e1827[0]) * _e1756)), (_e1827[1] + ((_e1833[1] - _e1827[1]) * _e1756)), (_e1827[2] + ((_e1833[2] - _e1827[2]) * _e1756))), _e230.member);
                                        if (_e1766 == 0u) {
                                            phi_3731_ = _e1847;
                                        } else {
                                            let _e1849 = f64(0f);
                                            phi_3731_ = array<f64, 3>(select(_e1849, _e1847[0], (_e1766 == 1u)), select(_e1849, _e1847[1], (_e1766 == 2u)), select(_e1849, _e1847[2], (_e1766 == 3u)));
                                        }
                                        let _e1861 = phi_3731_;
                                        let _e1875 = ((select(_e1861[0], -(_e1861[0]), (_e1861[0] < 0.0lf)) + select(_e1861[1], -(_e1861[1]), (_e1861[1] < 0.0lf))) + select(_e1861[2], -(_e1861[2]), (_e1861[2] < 0.0lf)));
                                        if (_e1875 > f64(0f)) {
                                            if ((bitcast<u64>(_e1875) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e1882 = (f64(1f) / _e1875);
                                                let _e1884 = (_e1861[0] * _e1882);
                                                let _e1886 = (_e1861[1] * _e1882);
                                                let _e1888 = (_e1861[2] * _e1882);
                                                let _e1893 = (((_e1884 * _e1884) + (_e1886 * _e1886)) + (_e1888 * _e1888));
                                                if (_e1893 <= 2.2250738585072014e-308lf) {
                                                    phi_3856_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1893 > 0.0lf));
                                                } else {
                                                    phi_3799_ = type_16(0i, 5i);
                                                    phi_3802_ = bitcast<f64>(((bitcast<u64>(_e1893) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e1900 = phi_3799_;
                                                        let _e1902 = phi_3802_;
                                                        local_8 = _e1902;
                                                        if (_e1900.member < _e1900.member_1) {
                                                            let _e1909 = (_e1900.member + 1i);
                                                            phi_3800_ = type_16(select(_e1909, type_17().member_1, select(false, true, ((false == (_e1909 > _e1900.member)) != false))), _e1900.member_1);
                                                            phi_3843_ = type_17(1u, _e1900.member);
                                                        } else {
                                                            phi_3800_ = _e1900;
                                                            phi_3843_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e1920 = phi_3800_;
                                                        let _e1922 = phi_3843_;
                                                        let _e1925 = (bitcast<i32>(_e1922.member) != 0i);
                                                        if _e1925 {
                                                            phi_3803_ = (0.5lf * (_e1902 + (_e1893 / _e1902)));
                                                        } else {
                                                            phi_3803_ = f64();
                                                        }
                                                        let _e1930 = phi_3803_;
                                                        continue;
                                                        continuing {
                                                            phi_3799_ = _e1920;
                                                            phi_3802_ = _e1930;
                                                            break if !(_e1925);
                                                        }
                                                    }
                                                    let _e1935 = local_8;
                                                    phi_3856_ = (_e1935 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e1941 = phi_3856_;
                                                let _e1943 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e1950 = ((((((((select(_e1639, _e1620, (_e1620 > _e1639)) + _e1643) + (select(_e1682, _e1663, (_e1663 > _e1682)) + _e1686)) + (select(_e1725, _e1706, (_e1706 > _e1725)) + _e1729)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1737 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e781.member_1 * _e1941) * (f64(1f) + _e1943)));
                                                let _e1955 = (((_e1884 * _e1542[0]) + (_e1886 * _e1542[1])) + (_e1888 * _e1542[2]));
                                                let _e1960 = (((_e1884 * _e1558) + (_e1886 * _e1559)) + (_e1888 * _e1560));
                                                let _e1965 = (((_e1884 * (_e1542[0] - _e1554[0])) + (_e1886 * (_e1542[1] - _e1554[1]))) + (_e1888 * (_e1542[2] - _e1554[2])));
                                                let _e1970 = (((_e1884 * select((_e1558 - _e1554[0]), _e1542[0], _e1561)) + (_e1886 * select((_e1559 - _e1554[1]), _e1542[1], _e1561))) + (_e1888 * select((_e1560 - _e1554[2]), _e1542[2], _e1561)));
                                                let _e1976 = (((_e1884 * _e1573[0]) + (_e1886 * _e1573[1])) + (_e1888 * _e1573[2]));
                                                let _e1981 = (((_e1884 * _e1589) + (_e1886 * _e1590)) + (_e1888 * _e1591));
                                                let _e1986 = (((_e1884 * (_e1573[0] - _e1585[0])) + (_e1886 * (_e1573[1] - _e1585[1]))) + (_e1888 * (_e1573[2] - _e1585[2])));
                                                let _e1991 = (((_e1884 * select((_e1589 - _e1585[0]), _e1573[0], _e1592)) + (_e1886 * select((_e1590 - _e1585[1]), _e1573[1], _e1592))) + (_e1888 * select((_e1591 - _e1585[2]), _e1573[2], _e1592)));
                                                phi_3982_ = type_39(array<f64, 4>(_e1955, _e1960, _e1965, _e1970), array<f64, 4>(_e1976, _e1981, _e1986, _e1991), array<f64, 4>((_e1950 + ((select(_e1955, -(_e1955), (_e1955 < 0.0lf)) + select(_e1976, -(_e1976), (_e1976 < 0.0lf))) * _e1943)), (_e1950 + ((select(_e1960, -(_e1960), (_e1960 < 0.0lf)) + select(_e1981, -(_e1981), (_e1981 < 0.0lf))) * _e1943)), (_e1950 + ((select(_e1965, -(_e1965), (_e1965 < 0.0lf)) + select(_e1986, -(_e1986), (_e1986 < 0.0lf))) * _e1943)), (_e1950 + ((select(_e1970, -(_e1970), (_e1970 < 0.0lf)) + select(_e1991, -(_e1991), (_e1991 < 0.0lf))) * _e1943))));
                                                phi_3983_ = false;
                                            } else {
                                                phi_3982_ = type_39();
                                                phi_3983_ = true;
                                            }
                                            let _e2032 = phi_3982_;
                                            let _e2034 = phi_3983_;
                                            phi_3984_ = _e2032;
                                            phi_3985_ = _e2034;
                                        } else {
                                            phi_3984_ = type_39();
                                            phi_3985_ = true;
                                        }
                                        let _e2036 = phi_3984_;
                                        let _e2038 = phi_3985_;
                                        if _e2038 {
                                            let _e2039 = f64(0f);
                                            let _e2040 = f64(1f);
                                            phi_3995_ = type_39(array<f64, 4>(_e2039, _e2039, _e2039, _e2039), array<f64, 4>(_e2039, _e2039, _e2039, _e2039), array<f64, 4>(_e2040, _e2040, _e2040, _e2040));
                                        } else {
                                            phi_3995_ = _e2036;
                                        }
                                        let _e2046 = phi_3995_;
                                        local_4 = type_39(array<f64, 4>(_e2046.member[0], _e2046.member[1], _e2046.member[2], _e2046.member[3]), array<f64, 4>(_e2046.member_1[0], _e2046.member_1[1], _e2046.member_1[2], _e2046.member_1[3]), array<f64, 4>(_e2046.member_2[0], _e2046.member_2[1], _e2046.member_2[2], _e2046.member_2[3]));
                                        let _e2066 = (_e1756 - _e1762);
                                        let _e2068 = f64(0f);
                                        let _e2071 = local_4.member[0u];
                                        let _e2074 = local_4.member_1[0u];
                                        let _e2077 = local_4.member[0u];
                                        let _e2083 = local_4.member_2[0u];
                                        if (((_e2071 + ((_e2074 - _e2077) * _e1756)) - _e2083) > _e2068) {
                                            let _e2088 = local_4.member[1u];
                                            let _e2091 = local_4.member_1[1u];
                                            let _e2094 = local_4.member[1u];
                                            let _e2100 = local_4.member_2[1u];
                                            if (((_e2088 + ((_e2091 - _e2094) * _e1756)) - _e2100) > _e2068) {
                                                let _e2105 = local_4.member[2u];
                                                let _e2108 = local_4.member_1[2u];
                                                let _e2111 = local_4.member[2u];
                                                let _e2117 = local_4.member_2[2u];
                                                if (((_e2105 + ((_e2108 - _e2111) * _e1756)) - _e2117) > _e2068) {
                                                    let _e2122 = local_4.member[3u];
                                                    let _e2125 = local_4.member_1[3u];
                                                    let _e2128 = local_4.member[3u];
                                                    let _e2134 = local_4.member_2[3u];
                                                    phi_4167_ = (((_e2122 + ((_e2125 - _e2128) * _e1756)) - _e2134) > _e2068);
                                                    phi_4168_ = false;
                                                } else {
                                                    phi_4167_ = bool();
                                                    phi_4168_ = true;
                                                }
                                                let _e2138 = phi_4167_;
                                                let _e2140 = phi_4168_;
                                                phi_4169_ = _e2138;
                                                phi_4170_ = _e2140;
                                            } else {
                                                phi_4169_ = bool();
                                                phi_4170_ = true;
                                            }
                                            let _e2142 = phi_4169_;
                                            let _e2144 = phi_4170_;
                                            phi_4171_ = _e2142;
                                            phi_4172_ = _e2144;
                                        } else {
                                            phi_4171_ = bool();
                                            phi_4172_ = true;
                                        }
                                        let _e2146 = phi_4171_;
                                        let _e2148 = phi_4172_;
                                        if select(_e2146, false, _e2148) {
                                            if (_e1756 <= _e1758) {
                                                phi_4487_ = true;
                                            } else {
                                                let _e2151 = f64(0f);
                                                let _e2154 = local_3.member[0u];
                                                let _e2157 = local_3.member_1[0u];
                                                let _e2160 = local_3.member[0u];
                                                let _e2166 = local_3.member_2[0u];
                                                let _e2170 = local_4.member[0u];
                                                let _e2173 = local_4.member_1[0u];
                                                let _e2176 = local_4.member[0u];
                                                let _e2182 = local_4.member_2[0u];
                                                if ((((_e2154 + ((_e2157 - _e2160) * _e1756)) - _e2166) + ((_e2170 + ((_e2173 - _e2176) * _e1762)) - _e2182)) > _e2151) {
                                                    let _e2188 = local_3.member[1u];
                                                    let _e2191 = local_3.member_1[1u];
                                                    let _e2194 = local_3.member[1u];
                                                    let _e2200 = local_3.member_2[1u];
                                                    let _e2204 = local_4.member[1u];
                                                    let _e2207 = local_4.member_1[1u];
                                                    let _e2210 = local_4.member[1u];
                                                    let _e2216 = local_4.member_2[1u];
                                                    if ((((_e2188 + ((_e2191 - _e2194) * _e1756)) - _e2200) + ((_e2204 + ((_e2207 - _e2210) * _e1762)) - _e2216)) > _e2151) {
                                                        let _e2222 = local_3.member[2u];
                                                        let _e2225 = local_3.member_1[2u];
                                                        let _e2228 = local_3.member[2u];
                                                        let _e2234 = local_3.member_2[2u];
                                                        let _e2238 = local_4.member[2u];
                                                        let _e2241 = local_4.member_1[2u];
                                                        let _e2244 = local_4.member[2u];
                                                        let _e2250 = local_4.member_2[2u];
                                                        if ((((_e2222 + ((_e2225 - _e2228) * _e1756)) - _e2234) + ((_e2238 + ((_e2241 - _e2244) * _e1762)) - _e2250)) > _e2151) {
                                                            let _e2256 = local_3.member[3u];
                                                            let _e2259 = local_3.member_1[3u];
                                                            let _e2262 = local_3.member[3u];
                                                            let _e2268 = local_3.member_2[3u];
                                                            let _e2272 = local_4.member[3u];
                                                            let _e2275 = local_4.member_1[3u];
                                                            let _e2278 = local_4.member[3u];
                                                            let _e2284 = local_4.member_2[3u];
                                                            phi_4474_ = ((((_e2256 + ((_e2259 - _e2262) * _e1756)) - _e2268) + ((_e2272 + ((_e2275 - _e2278) * _e1762)) - _e2284)) > _e2151);
                                                            phi_4475_ = false;
                                                        } else {
                                                            phi_4474_ = bool();
                                                            phi_4475_ = true;
                                                        }
                                                        let _e2289 = phi_4474_;
                                                        let _e2291 = phi_4475_;
                                                        phi_4476_ = _e2289;
                                                        phi_4477_ = _e2291;
                                                    } else {
                                                        phi_4476_ = bool();
                                                        phi_4477_ = true;
                                                    }
                                                    let _e2293 = phi_4476_;
                                                    let _e2295 = phi_4477_;
                                                    phi_4478_ = _e2293;
                                                    phi_4479_ = _e2295;
                                                } else {
                                                    phi_4478_ = bool();
                                                    phi_4479_ = true;
                                                }
                                                let _e2297 = phi_4478_;
                                                let _e2299 = phi_4479_;
                                                phi_4487_ = select(_e2297, false, _e2299);
                                            }
                                            let _e2302 = phi_4487_;
                                            if _e2302 {
                                                if select(true, select(true, false, (_e1756 >= _e551)), _e1764) {
                                                    local_3 = type_39(array<f64, 4>(_e2046.member[0], _e2046.member[1], _e2046.member[2], _e2046.member[3]), array<f64, 4>(_e2046.member_1[0], _e2046.member_1[1], _e2046.member_1[2], _e2046.member_1[3]), array<f64, 4>(_e2046.member_2[0], _e2046.member_2[1], _e2046.member_2[2], _e2046.member_2[3]));
                                                    let _e2327 = local_3.member[0u];
                                                    let _e2330 = local_3.member_1[0u];
                                                    let _e2333 = local_3.member_2[0u];
                                                    if select(true, select(true, false, (_e2330 > _e2333)), (_e2327 > _e2333)) {
                                                        let _e2338 = (_e2330 >= _e2327);
                                                        if _e2338 {
                                                            phi_4599_ = f64();
                                                            phi_4600_ = false;
                                                        } else {
                                                            if ((_e2327 - _e2330) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4597_ = (((_e2327 - _e2333) / (_e2327 - _e2330)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4598_ = false;
                                                            } else {
                                                                phi_4597_ = f64();
                                                                phi_4598_ = true;
                                                            }
                                                            let _e2352 = phi_4597_;
                                                            let _e2354 = phi_4598_;
                                                            phi_4599_ = _e2352;
                                                            phi_4600_ = _e2354;
                                                        }
                                                        let _e2356 = phi_4599_;
                                                        let _e2358 = phi_4600_;
                                                        phi_4601_ = _e2356;
                                                        phi_4602_ = _e2338;
                                                        phi_4603_ = _e2358;
                                                    } else {
                                                        phi_4601_ = f64();
                                                        phi_4602_ = true;
                                                        phi_4603_ = false;
                                                    }
                                                    let _e2360 = phi_4601_;
                                                    let _e2362 = phi_4602_;
                                                    let _e2364 = phi_4603_;
                                                    let _e2368 = select(_e2360, select(_e1756, f64(2f), _e2362), select(_e2364, true, _e2362));
                                                    let _e2371 = local_3.member[1u];
                                                    let _e2374 = local_3.member_1[1u];
                                                    let _e2377 = local_3.member_2[1u];
                                                    if select(true, select(true, false, (_e2374 > _e2377)), (_e2371 > _e2377)) {
                                                        let _e2382 = (_e2374 >= _e2371);
                                                        if _e2382 {
                                                            phi_4671_ = f64();
                                                            phi_4672_ = false;
                                                        } else {
                                                            if ((_e2371 - _e2374) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4669_ = (((_e2371 - _e2377) / (_e2371 - _e2374)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4670_ = false;
                                                            } else {
                                                                phi_4669_ = f64();
                                                                phi_4670_ = true;
                                                            }
                                                            let _e2396 = phi_4669_;
                                                            let _e2398 = phi_4670_;
                                                            phi_4671_ = _e2396;
                                                            phi_4672_ = _e2398;
                                                        }
                                                        let _e2400 = phi_4671_;
                                                        let _e2402 = phi_4672_;
                                                        phi_4673_ = _e2400;
                                                        phi_4674_ = _e2382;
                                                        phi_4675_ = _e2402;
                                                    } else {
                                                        phi_4673_ = f64();
                                                        phi_4674_ = true;
                                                        phi_4675_ = false;
                                                    }
                                                    let _e2404 = phi_4673_;
                                                    let _e2406 = phi_4674_;
                                                    let _e2408 = phi_4675_;
                                                    let _e2412 = select(_e2404, select(_e1756, f64(2f), _e2406), select(_e2408, true, _e2406));
                                                    let _e2414 = select(_e2412, _e2368, (_e2368 < _e2412));
                                                    let _e2417 = local_3.member[2u];
                                                    let _e2420 = local_3.member_1[2u];
                                                    let _e2423 = local_3.member_2[2u];
                                                    if select(true, select(true, false, (_e2420 > _e2423)), (_e2417 > _e2423)) {
                                                        let _e2428 = (_e2420 >= _e2417);
                                                        if _e2428 {
                                                            phi_4748_ = f64();
                                                            phi_4749_ = false;
                                                        } else {
                                                            if ((_e2417 - _e2420) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4746_ = (((_e2417 - _e2423) / (_e2417 - _e2420)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4747_ = false;
                                                            } else {
                                                                phi_4746_ = f64();
                                                                phi_4747_ = true;
                                                            }
                                                            let _e2442 = phi_4746_;
                                                            let _e2444 = phi_4747_;
                                                            phi_4748_ = _e2442;
                                                            phi_4749_ = _e2444;
                                                        }
                                                        let _e2446 = phi_4748_;
                                                        let _e2448 = phi_4749_;
                                                        phi_4750_ = _e2446;
                                                        phi_4751_ = _e2428;
                                                        phi_4752_ = _e2448;
                                                    } else {
                                                        phi_4750_ = f64();
                                                        phi_4751_ = true;
                                                        phi_4752_ = false;
                                                    }
                                                    let _e2450 = phi_4750_;
                                                    let _e2452 = phi_4751_;
                                                    let _e2454 = phi_4752_;
                                                    let _e2458 = select(_e2450, select(_e1756, f64(2f), _e2452), select(_e2454, true, _e2452));
                                                    let _e2461 = local_3.member[3u];
                                                    let _e2464 = local_3.member_1[3u];
                                                    let _e2467 = local_3.member_2[3u];
                                                    if select(true, select(true, false, (_e2464 > _e2467)), (_e2461 > _e2467)) {
                                                        let _e2472 = (_e2464 >= _e2461);
                                                        if _e2472 {
                                                            phi_4820_ = f64();
                                                            phi_4821_ = false;
                                                        } else {
                                                            if ((_e2461 - _e2464) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4818_ = (((_e2461 - _e2467) / (_e2461 - _e2464)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4819_ = false;
                                                            } else {
                                                                phi_4818_ = f64();
                                                                phi_4819_ = true;
                                                            }
                                                            let _e2486 = phi_4818_;
                                                            let _e2488 = phi_4819_;
                                                            phi_4820_ = _e2486;
                                                            phi_4821_ = _e2488;
                                                        }
                                                        let _e2490 = phi_4820_;
                                                        let _e2492 = phi_4821_;
                                                        phi_4822_ = _e2490;
                                                        phi_4823_ = _e2472;
                                                        phi_4824_ = _e2492;
                                                    } else {
                                                        phi_4822_ = f64();
                                                        phi_4823_ = true;
                                                        phi_4824_ = false;
                                                    }
                                                    let _e2494 = phi_4822_;
                                                    let _e2496 = phi_4823_;
                                                    let _e2498 = phi_4824_;
                                                    let _e2502 = select(_e2494, select(_e1756, f64(2f), _e2496), select(_e2498, true, _e2496));
                                                    let _e2504 = select(_e2502, _e2458, (_e2458 < _e2502));
                                                    let _e2506 = select(_e2504, _e2414, (_e2414 < _e2504));
                                                    let _e2508 = select(_e1756, _e2506, (_e2506 > _e1756));
                                                    let _e2509 = (_e2508 > _e551);
                                                    if _e2509 {
                                                        phi_5366_ = f64();
                                                        phi_5367_ = f64();
                                                        phi_5368_ = false;
                                                        phi_5369_ = false;
                                                    } else {
                                                        let _e2510 = (_e2508 - _e1756);
                                                        let _e2511 = (_e2510 <= _e1745);
                                                        let _e2514 = (_e2508 + (_e533 * f64(0.01f)));
                                                        let _e2516 = select(_e551, _e2514, (_e2514 < _e551));
                                                        if _e2511 {
                                                            if (_e781.member_1 > f64(0f)) {
                                                                let _e2521 = local_5.member[0u];
                                                                let _e2527 = local_5.member[1u];
                                                                let _e2543 = local_5.member_1[0u];
                                                                let _e2549 = local_5.member_1[1u];
                                                                let _e2565 = local_5.member_2[0u];
                                                                let _e2571 = local_5.member_2[1u];
                                                                let _e2585 = function_4(array<f64, 3>((_e2521[0] + ((_e2527[0] - _e2521[0]) * _e2516)), (_e2521[1] + ((_e2527[1] - _e2521[1]) * _e2516)), (_e2521[2] + ((_e2527[2] - _e2521[2]) * _e2516))), array<f64, 3>((_e2543[0] + ((_e2549[0] - _e2543[0]) * _e2516)), (_e2543[1] + ((_e2549[1] - _e2543[1]) * _e2516)), (_e2543[2] + ((_e2549[2] - _e2543[2]) * _e2516))), array<f64, 3>((_e2565[0] + ((_e2571[0] - _e2565[0]) * _e2516)), (_e2565[1] + ((_e2571[1] - _e2565[1]) * _e2516)), (_e2565[2] + ((_e2571[2] - _e2565[2]) * _e2516))), _e230.member);
                                                                let _e2596 = (((_e2585[0] * _e2585[0]) + (_e2585[1] * _e2585[1])) + (_e2585[2] * _e2585[2]));
                                                                if (_e2596 <= 2.2250738585072014e-308lf) {
                                                                    phi_5058_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2596 > 0.0lf));
                                                                } else {
                                                                    phi_5001_ = type_16(0i, 5i);
                                                                    phi_5004_ = bitcast<f64>(((bitcast<u64>(_e2596) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e2603 = phi_5001_;
                                                                        let _e2605 = phi_5004_;
                                                                        local_9 = _e2605;
                                                                        if (_e2603.member < _e2603.member_1) {
                                                                            let _e2612 = (_e2603.member + 1i);
                                                                            phi_5002_ = type_16(select(_e2612, type_17().member_1, select(false, true, ((false == (_e2612 > _e2603.member)) != false))), _e2603.member_1);
                                                                            phi_5045_ = type_17(1u, _e2603.member);
                                                                        } else {
                                                                            phi_5002_ = _e2603;
                                                                            phi_5045_ = type_17(0u, type_17().member_1);
                                                                        }
                                                                        let _e2623 = phi_5002_;
                                                                        let _e2625 = phi_5045_;
                                                                        let _e2628 = (bitcast<i32>(_e2625.member) != 0i);
                                                                        if _e2628 {
                                                                            phi_5005_ = (0.5lf * (_e2605 + (_e2596 / _e2605)));
                                                                        } else {
                                                                            phi_5005_ = f64();
                                                                        }
                                                                        let _e2633 = phi_5005_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_5001_ = _e2623;
                                                                            phi_5004_ = _e2633;
                                                                            break if !(_e2628);
                                                                        }
                                                                    }
                                                                    let _e2638 = local_9;
                                                                    phi_5058_ = (_e2638 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e2644 = phi_5058_;
                                                                let _e2652 = local_5.member[0u];
                                                                let _e2658 = select(_e2652[0], -(_e2652[0]), (_e2652[0] < 0.0lf));
                                                                let _e2661 = select(_e2652[1], -(_e2652[1]), (_e2652[1] < 0.0lf));
                                                                let _e2663 = select(_e2661, _e2658, (_e2658 > _e2661));
                                                                let _e2666 = select(_e2652[2], -(_e2652[2]), (_e2652[2] < 0.0lf));
                                                                let _e2668 = select(_e2666, _e2663, (_e2663 > _e2666));
                                                                let _e2671 = local_5.member[1u];
                                                                let _e2677 = select(_e2671[0], -(_e2671[0]), (_e2671[0] < 0.0lf));
                                                                let _e2680 = select(_e2671[1], -(_e2671[1]), (_e2671[1] < 0.0lf));
                                                                let _e2682 = select(_e2680, _e2677, (_e2677 > _e2680));
                                                                let _e2685 = select(_e2671[2], -(_e2671[2]), (_e2671[2] < 0.0lf));
                                                                let _e2687 = select(_e2685, _e2682, (_e2682 > _e2685));
                                                                let _e2691 = local_5.member_3;
                                                                let _e2695 = local_5.member_1[0u];
                                                                let _e2701 = select(_e2695[0], -(_e2695[0]), (_e2695[0] < 0.0lf));
                                                                let _e2704 = select(_e2695[1], -(_e2695[1]), (_e2695[1] < 0.0lf));
                                                                let _e2706 = select(_e2704, _e2701, (_e2701 > _e2704));
                                                                let _e2709 = select(_e2695[2], -(_e2695[2]), (_e2695[2] < 0.0lf));
                                                                let _e2711 = select(_e2709, _e2706, (_e2706 > _e2709));
                                                                let _e2714 = local_5.member_1[1u];
                                                                let _e2720 = select(_e2714[0], -(_e2714[0]), (_e2714[0] < 0.0lf));
                                                                let _e2723 = select(_e2714[1], -(_e2714[1]), (_e2714[1] < 0.0lf));
                                                                let _e2725 = select(_e2723, _e2720, (_e2720 > _e2723));
                                                                let _e2728 = select(_e2714[2], -(_e2714[2]), (_e2714[2] < 0.0lf));
                                                                let _e2730 = select(_e2728, _e2725, (_e2725 > _e2728));
                                                                let _e2734 = local_5.member_3;
                                                                let _e2738 = local_5.member_2[0u];
                                                                let _e2744 = select(_e2738[0], -(_e2738[0]), (_e2738[0] < 0.0lf));
                                                                let _e2747 = select(_e2738[1], -(_e2738[1]), (_e2738[1] < 0.0lf));
                                                                let _e2749 = select(_e2747, _e2744, (_e2744 > _e2747));
                                                                let _e2752 = select(_e2738[2], -(_e2738[2]), (_e2738[2] < 0.0lf));
                                                                let _e2754 = select(_e2752, _e2749, (_e2749 > _e2752));
                                                                let _e2757 = local_5.member_2[1u];
                                                                let _e2763 = select(_e2757[0], -(_e2757[0]), (_e2757[0] < 0.0lf));
                                                                let _e2766 = select(_e2757[1], -(_e2757[1]), (_e2757[1] < 0.0lf));
                                                                let _e2768 = select(_e2766, _e2763, (_e2763 > _e2766));
                                                                let _e2771 = select(_e2757[2], -(_e2757[2]), (_e2757[2] < 0.0lf));
                                                                let _e2773 = select(_e2771, _e2768, (_e2768 > _e2771));
                                                                let _e2777 = local_5.member_3;
                                                                let _e2785 = local_5.member_3;
                                                                phi_5335_ = select(true, false, (((_e2644 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e2687, _e2668, (_e2668 > _e2687)) + _e2691) + (select(_e2730, _e2711, (_e2711 > _e2730)) + _e2734)) + (select(_e2773, _e2754, (_e2754 > _e2773)) + _e2777)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2785 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e781.member_1));
                                                            } else {
                                                                phi_5335_ = true;
                                                            }
                                                            let _e2798 = phi_5335_;
                                                            phi_5336_ = _e2798;
                                                        } else {
                                                            phi_5336_ = true;
                                                        }
                                                        let _e2800 = phi_5336_;
                                                        if _e2800 {
                                                            if _e1764 {
                                                                let _e2804 = (_e2510 <= (_e1760 * f64(0.25f)));
                                                                phi_5363_ = select(select(select(f64(), f64(0f), _e2804), f64(), _e2511), (_e2066 + _e2066), select(select(true, false, _e2804), true, _e2511));
                                                            } else {
                                                                phi_5363_ = (_e551 - _e1756);
                                                            }
                                                            let _e2813 = phi_5363_;
                                                            phi_5364_ = _e2813;
                                                            phi_5365_ = false;
                                                        } else {
                                                            phi_5364_ = f64();
                                                            phi_5365_ = true;
                                                        }
                                                        let _e2815 = phi_5364_;
                                                        let _e2817 = phi_5365_;
                                                        phi_5366_ = _e2815;
                                                        phi_5367_ = _e2510;
                                                        phi_5368_ = _e2800;
                                                        phi_5369_ = _e2817;
                                                    }
                                                    let _e2819 = phi_5366_;
                                                    let _e2821 = phi_5367_;
                                                    let _e2823 = phi_5368_;
                                                    let _e2825 = phi_5369_;
                                                    phi_5370_ = _e2508;
                                                    phi_5371_ = _e2819;
                                                    phi_5372_ = _e2821;
                                                    phi_5373_ = _e2508;
                                                    phi_5374_ = _e2823;
                                                    phi_5375_ = _e2509;
                                                    phi_5376_ = _e2825;
                                                    phi_5377_ = false;
                                                } else {
                                                    phi_5370_ = f64();
                                                    phi_5371_ = f64();
                                                    phi_5372_ = f64();
                                                    phi_5373_ = f64();
                                                    phi_5374_ = false;
                                                    phi_5375_ = false;
                                                    phi_5376_ = false;
                                                    phi_5377_ = true;
                                                }
                                                let _e2827 = phi_5370_;
                                                let _e2829 = phi_5371_;
                                                let _e2831 = phi_5372_;
                                                let _e2833 = phi_5373_;
                                                let _e2835 = phi_5374_;
                                                let _e2837 = phi_5375_;
                                                let _e2839 = phi_5376_;
                                                let _e2841 = phi_5377_;
                                                phi_5378_ = _e2827;
                                                phi_5379_ = _e2829;
                                                phi_5380_ = _e2831;
                                                phi_5381_ = _e2833;
                                                phi_5382_ = false;
                                                phi_5383_ = _e2835;
                                                phi_5384_ = _e2837;
                                                phi_5385_ = _e2839;
                                                phi_5386_ = _e2841;
                                            } else {
                                                phi_5378_ = f64();
                                                phi_5379_ = f64();
                                                phi_5380_ = f64();
                                                phi_5381_ = f64();
                                                phi_5382_ = true;
                                                phi_5383_ = false;
                                                phi_5384_ = false;
                                                phi_5385_ = false;
                                                phi_5386_ = false;
                                            }
                                            let _e2843 = phi_5378_;
                                            let _e2845 = phi_5379_;
                                            let _e2847 = phi_5380_;
                                            let _e2849 = phi_5381_;
                                            let _e2851 = phi_5382_;
                                            let _e2853 = phi_5383_;
                                            let _e2855 = phi_5384_;
                                            let _e2857 = phi_5385_;
                                            let _e2859 = phi_5386_;
                                            phi_5387_ = _e2843;
                                            phi_5388_ = _e2845;
                                            phi_5389_ = _e2847;
                                            phi_5390_ = _e2849;
                                            phi_5391_ = _e2851;
                                            phi_5392_ = _e2853;
                                            phi_5393_ = _e2855;
                                            phi_5394_ = _e2857;
                                            phi_5395_ = _e2859;
                                        } else {
                                            phi_5387_ = f64();
                                            phi_5388_ = f64();
                                            phi_5389_ = f64();
                                            phi_5390_ = f64();
                                            phi_5391_ = true;
                                            phi_5392_ = false;
                                            phi_5393_ = false;
                                            phi_5394_ = false;
                                            phi_5395_ = false;
                                        }
                                        let _e2861 = phi_5387_;
                                        let _e2863 = phi_5388_;
                                        let _e2865 = phi_5389_;
                                        let _e2867 = phi_5390_;
                                        let _e2869 = phi_5391_;
                                        let _e2871 = phi_5392_;
                                        let _e2873 = phi_5393_;
                                        let _e2875 = phi_5394_;
                                        let _e2877 = phi_5395_;
                                        if _e2869 {
                                            if (_e1756 <= _e1758) {
                                                let _e3035 = (_e1766 + 1u);
                                                let _e3036 = (_e3035 > 3u);
                                                phi_5735_ = _e3035;
                                                phi_5736_ = f64();
                                                phi_5737_ = false;
                                                phi_5738_ = select(true, false, _e3036);
                                                phi_5739_ = _e3036;
                                            } else {
                                                let _e2881 = local_3.member[0u];
                                                let _e2884 = local_3.member_1[0u];
                                                let _e2887 = local_3.member[0u];
                                                let _e2893 = local_3.member_2[0u];
                                                let _e2894 = ((_e2881 + ((_e2884 - _e2887) * _e1762)) - _e2893);
                                                let _e2897 = local_3.member[1u];
                                                let _e2900 = local_3.member_1[1u];
                                                let _e2903 = local_3.member[1u];
                                                let _e2909 = local_3.member_2[1u];
                                                let _e2910 = ((_e2897 + ((_e2900 - _e2903) * _e1762)) - _e2909);
                                                let _e2912 = select(_e2910, _e2894, (_e2894 < _e2910));
                                                let _e2915 = local_3.member[2u];
                                                let _e2918 = local_3.member_1[2u];
                                                let _e2921 = local_3.member[2u];
                                                let _e2927 = local_3.member_2[2u];
                                                let _e2928 = ((_e2915 + ((_e2918 - _e2921) * _e1762)) - _e2927);
                                                let _e2931 = local_3.member[3u];
                                                let _e2934 = local_3.member_1[3u];
                                                let _e2937 = local_3.member[3u];
                                                let _e2943 = local_3.member_2[3u];
                                                let _e2944 = ((_e2931 + ((_e2934 - _e2937) * _e1762)) - _e2943);
                                                let _e2946 = select(_e2944, _e2928, (_e2928 < _e2944));
                                                let _e2948 = select(_e2946, _e2912, (_e2912 < _e2946));
                                                let _e2951 = local_4.member[0u];
                                                let _e2954 = local_4.member_1[0u];
                                                let _e2957 = local_4.member[0u];
                                                let _e2963 = local_4.member_2[0u];
                                                let _e2964 = ((_e2951 + ((_e2954 - _e2957) * _e1756)) - _e2963);
                                                let _e2967 = local_4.member[1u];
                                                let _e2970 = local_4.member_1[1u];
                                                let _e2973 = local_4.member[1u];
                                                let _e2979 = local_4.member_2[1u];
                                                let _e2980 = ((_e2967 + ((_e2970 - _e2973) * _e1756)) - _e2979);
                                                let _e2982 = select(_e2980, _e2964, (_e2964 < _e2980));
                                                let _e2985 = local_4.member[2u];
                                                let _e2988 = local_4.member_1[2u];
                                                let _e2991 = local_4.member[2u];
                                                let _e2997 = local_4.member_2[2u];
                                                let _e2998 = ((_e2985 + ((_e2988 - _e2991) * _e1756)) - _e2997);
                                                let _e3001 = local_4.member[3u];
                                                let _e3004 = local_4.member_1[3u];
                                                let _e3007 = local_4.member[3u];
                                                let _e3013 = local_4.member_2[3u];
                                                let _e3014 = ((_e3001 + ((_e3004 - _e3007) * _e1756)) - _e3013);
                                                let _e3016 = select(_e3014, _e2998, (_e2998 < _e3014));
                                                let _e3018 = select(_e3016, _e2982, (_e2982 < _e3016));
                                                let _e3019 = f64(0.0625f);
                                                let _e3021 = f64(0.9f);
                                                if (_e3018 > f64(0f)) {
                                                    phi_5733_ = f64(0.5f);
                                                } else {
                                                    let _e3027 = (f64(0.95f) * (_e2948 / (_e2948 - _e3018)));
                                                    phi_5733_ = select(_e3019, select(_e3021, _e3027, (_e3027 < _e3021)), (_e3027 > _e3019));
                                                }
                                                let _e3033 = phi_5733_;
                                                phi_5735_ = u32();
                                                phi_5736_ = (_e2066 * _e3033);
                                                phi_5737_ = true;
                                                phi_5738_ = false;
                                                phi_5739_ = false;
                                            }
                                            let _e3039 = phi_5735_;
                                            let _e3041 = phi_5736_;
                                            let _e3043 = phi_5737_;
                                            let _e3045 = phi_5738_;
                                            let _e3047 = phi_5739_;
                                            phi_5740_ = _e3039;
                                            phi_5741_ = _e1758;
                                            phi_5742_ = _e3041;
                                            phi_5743_ = _e1760;
                                            phi_5744_ = _e1762;
                                            phi_5745_ = _e1764;
                                            phi_5746_ = _e1766;
                                            phi_5747_ = _e3043;
                                            phi_5748_ = _e3045;
                                            phi_5749_ = _e3047;
                                            phi_5750_ = false;
                                            phi_5751_ = false;
                                            phi_5752_ = false;
                                        } else {
                                            phi_5740_ = u32();
                                            phi_5741_ = _e2861;
                                            phi_5742_ = _e2863;
                                            phi_5743_ = _e2865;
                                            phi_5744_ = _e1756;
                                            phi_5745_ = true;
                                            phi_5746_ = 0u;
                                            phi_5747_ = _e2871;
                                            phi_5748_ = false;
                                            phi_5749_ = false;
                                            phi_5750_ = _e2873;
                                            phi_5751_ = _e2875;
                                            phi_5752_ = _e2877;
                                        }
                                        let _e3049 = phi_5740_;
                                        let _e3051 = phi_5741_;
                                        let _e3053 = phi_5742_;
                                        let _e3055 = phi_5743_;
                                        let _e3057 = phi_5744_;
                                        let _e3059 = phi_5745_;
                                        let _e3061 = phi_5746_;
                                        let _e3063 = phi_5747_;
                                        let _e3065 = phi_5748_;
                                        let _e3067 = phi_5749_;
                                        let _e3069 = phi_5750_;
                                        let _e3071 = phi_5751_;
                                        let _e3073 = phi_5752_;
                                        if _e3063 {
                                            let _e3074 = (_e3057 + _e3053);
                                            let _e3076 = select(_e3051, _e3074, (_e3074 > _e3051));
                                            let _e3078 = select(_e551, _e3076, (_e3076 < _e551));
                                            let _e3081 = select(((_e3078 - _e3057) > _e1745), true, !(_e1764));
                                            phi_5780_ = _e3078;
                                            phi_5781_ = _e3051;
                                            phi_5782_ = _e3055;
                                            phi_5783_ = _e3057;
                                            phi_5784_ = _e3059;
                                            phi_5785_ = _e3061;
                                            phi_5786_ = _e3081;
                                            phi_5787_ = select(true, false, _e3081);
                                            phi_5788_ = false;
                                            phi_5789_ = false;
                                            phi_5790_ = false;
                                            phi_5791_ = false;
                                        } else {
                                            phi_5780_ = _e1756;
                                            phi_5781_ = _e1758;
                                            phi_5782_ = _e1760;
                                            phi_5783_ = _e1762;
                                            phi_5784_ = _e1764;
                                            phi_5785_ = _e3049;
                                            phi_5786_ = _e3065;
                                            phi_5787_ = false;
                                            phi_5788_ = _e3067;
                                            phi_5789_ = _e3069;
                                            phi_5790_ = _e3071;
                                            phi_5791_ = _e3073;
                                        }
                                        let _e3084 = phi_5780_;
                                        let _e3086 = phi_5781_;
                                        let _e3088 = phi_5782_;
                                        let _e3090 = phi_5783_;
                                        let _e3092 = phi_5784_;
                                        let _e3094 = phi_5785_;
                                        let _e3096 = phi_5786_;
                                        let _e3098 = phi_5787_;
                                        let _e3100 = phi_5788_;
                                        let _e3102 = phi_5789_;
                                        let _e3104 = phi_5790_;
                                        let _e3106 = phi_5791_;
                                        phi_3570_ = _e3084;
                                        phi_3572_ = _e3086;
                                        phi_3574_ = _e3088;
                                        phi_3576_ = _e3090;
                                        phi_3578_ = _e3092;
                                        phi_3580_ = _e3094;
                                        phi_5792_ = _e3051;
                                        phi_5793_ = _e2867;
                                        phi_5794_ = _e3096;
                                        phi_5795_ = _e3098;
                                        phi_5796_ = _e3100;
                                        phi_5797_ = _e3102;
                                        phi_5798_ = _e3104;
                                        phi_5799_ = false;
                                        phi_5800_ = _e3106;
                                    } else {
                                        phi_3570_ = f64();
                                        phi_3572_ = f64();
                                        phi_3574_ = f64();
                                        phi_3576_ = f64();
                                        phi_3578_ = bool();
                                        phi_3580_ = u32();
                                        phi_5792_ = f64();
                                        phi_5793_ = f64();
                                        phi_5794_ = false;
                                        phi_5795_ = false;
                                        phi_5796_ = false;
                                        phi_5797_ = false;
                                        phi_5798_ = false;
                                        phi_5799_ = true;
                                        phi_5800_ = false;
                                    }
                                    let _e3108 = phi_3570_;
                                    let _e3110 = phi_3572_;
                                    let _e3112 = phi_3574_;
                                    let _e3114 = phi_3576_;
                                    let _e3116 = phi_3578_;
                                    let _e3118 = phi_3580_;
                                    let _e3120 = phi_5792_;
                                    let _e3122 = phi_5793_;
                                    let _e3124 = phi_5794_;
                                    let _e3126 = phi_5795_;
                                    let _e3128 = phi_5796_;
                                    let _e3130 = phi_5797_;
                                    let _e3132 = phi_5798_;
                                    let _e3134 = phi_5799_;
                                    let _e3136 = phi_5800_;
                                    local_10 = _e3126;
                                    local_11 = _e3128;
                                    local_12 = _e3126;
                                    local_13 = _e3130;
                                    local_14 = _e3126;
                                    local_15 = _e3132;
                                    local_16 = _e3126;
                                    local_17 = _e3134;
                                    local_18 = _e3126;
                                    local_19 = _e3136;
                                    local_21 = _e3126;
                                    local_22 = _e3122;
                                    local_23 = _e3120;
                                    continue;
                                    continuing {
                                        phi_3566_ = type_9(select(_e1754.member, (_e1754.member + 1u), _e1769), select(_e1754.member_1, _e1754.member_1, _e1769));
                                        phi_3569_ = _e3108;
                                        phi_3571_ = _e3110;
                                        phi_3573_ = _e3112;
                                        phi_3575_ = _e3114;
                                        phi_3577_ = _e3116;
                                        phi_3579_ = _e3118;
                                        break if !(_e3124);
                                    }
                                }
                                let _e3139 = local_10;
                                let _e3141 = local_11;
                                let _e3142 = select(_e3141, false, _e3139);
                                let _e3144 = local_12;
                                let _e3146 = local_13;
                                let _e3149 = local_14;
                                let _e3151 = local_15;
                                let _e3154 = local_16;
                                let _e3156 = local_17;
                                let _e3159 = local_18;
                                let _e3161 = local_19;
                                let _e3167 = local_20;
                                let _e3169 = select(select(_e3146, false, _e3144), false, _e3142);
                                let _e3172 = local_21;
                                let _e3179 = select(select(select(_e3151, false, _e3149), false, _e3142), false, _e3169);
                                let _e3185 = local_22;
                                let _e3187 = local_23;
                                let _e3189 = select(select(select(_e3172, false, _e3142), false, _e3169), true, _e3179);
                                let _e3194 = local_24;
                                let _e3196 = select(select(select(select(select(_e3156, false, _e3154), false, _e3142), false, _e3169), false, _e3179), true, _e3189);
                                let _e3203 = select(select(select(select(select(select(_e3161, false, _e3159), false, _e3142), false, _e3169), false, _e3179), false, _e3189), false, _e3196);
                                let _e3208 = select(select(select(select(select(_e3142, true, _e3169), false, _e3179), false, _e3189), false, _e3196), true, _e3203);
                                phi_5867_ = select(select(type_37().member_1, select(_e3194, select(_e3187, _e3185, _e3179), _e3189), _e3196), select(select(select(type_37().member_1, _e3167, _e3142), type_37().member_1, _e3169), type_37().member_1, _e3203), _e3208);
                                phi_5868_ = (select(select(type_37().member, 1u, _e3196), select(select(select(type_37().member, 1u, _e3142), 0u, _e3169), 0u, _e3203), _e3208) != 0u);
                            } else {
                                phi_5867_ = _e1508;
                                phi_5868_ = true;
                            }
                            let _e3213 = phi_5867_;
                            let _e3215 = phi_5868_;
                            if _e3215 {
                                let _e3216 = (_e3213 > _e542);
                                if _e3216 {
                                    phi_8075_ = f64();
                                    phi_8076_ = u32();
                                    phi_8077_ = f64();
                                    phi_8078_ = type_42();
                                    phi_8079_ = u32();
                                    phi_8080_ = u32();
                                    phi_8081_ = false;
                                    phi_8082_ = false;
                                    phi_8083_ = false;
                                } else {
                                    let _e3220 = local_5.member[0u];
                                    let _e3226 = local_5.member[1u];
                                    let _e3242 = local_5.member_1[0u];
                                    let _e3248 = local_5.member_1[1u];
                                    let _e3264 = local_5.member_2[0u];
                                    let _e3270 = local_5.member_2[1u];
                                    let _e3284 = function_4(array<f64, 3>((_e3220[0] + ((_e3226[0] - _e3220[0]) * _e1512)), (_e3220[1] + ((_e3226[1] - _e3220[1]) * _e1512)), (_e3220[2] + ((_e3226[2] - _e3220[2]) * _e1512))), array<f64, 3>((_e3242[0] + ((_e3248[0] - _e3242[0]) * _e1512)), (_e3242[1] + ((_e3248[1] - _e3242[1]) * _e1512)), (_e3242[2] + ((_e3248[2] - _e3242[2]) * _e1512))), array<f64, 3>((_e3264[0] + ((_e3270[0] - _e3264[0]) * _e1512)), (_e3264[1] + ((_e3270[1] - _e3264[1]) * _e1512)), (_e3264[2] + ((_e3270[2] - _e3264[2]) * _e1512))), _e230.member);
                                    let _e3298 = ((select(_e3284[0], -(_e3284[0]), (_e3284[0] < 0.0lf)) + select(_e3284[1], -(_e3284[1]), (_e3284[1] < 0.0lf))) + select(_e3284[2], -(_e3284[2]), (_e3284[2] < 0.0lf)));
                                    let _e3301 = local_5.member[0u];
                                    let _e3307 = local_5.member_1[0u];
                                    let _e3313 = local_5.member_2[0u];
                                    let _e3317 = (_e3301[0] - _e3307[0]);
                                    let _e3318 = (_e3301[1] - _e3307[1]);
                                    let _e3319 = (_e3301[2] - _e3307[2]);
                                    let _e3320 = (_e230.member == 0u);
                                    let _e3332 = local_5.member[1u];
                                    let _e3338 = local_5.member_1[1u];
                                    let _e3344 = local_5.member_2[1u];
                                    let _e3348 = (_e3332[0] - _e3338[0]);
                                    let _e3349 = (_e3332[1] - _e3338[1]);
                                    let _e3350 = (_e3332[2] - _e3338[2]);
                                    let _e3351 = (_e230.member == 0u);
                                    let _e3363 = local_5.member[0u];
                                    let _e3369 = select(_e3363[0], -(_e3363[0]), (_e3363[0] < 0.0lf));
                                    let _e3372 = select(_e3363[1], -(_e3363[1]), (_e3363[1] < 0.0lf));
                                    let _e3374 = select(_e3372, _e3369, (_e3369 > _e3372));
                                    let _e3377 = select(_e3363[2], -(_e3363[2]), (_e3363[2] < 0.0lf));
                                    let _e3379 = select(_e3377, _e3374, (_e3374 > _e3377));
                                    let _e3382 = local_5.member[1u];
                                    let _e3388 = select(_e3382[0], -(_e3382[0]), (_e3382[0] < 0.0lf));
                                    let _e3391 = select(_e3382[1], -(_e3382[1]), (_e3382[1] < 0.0lf));
                                    let _e3393 = select(_e3391, _e3388, (_e3388 > _e3391));
                                    let _e3396 = select(_e3382[2], -(_e3382[2]), (_e3382[2] < 0.0lf));
                                    let _e3398 = select(_e3396, _e3393, (_e3393 > _e3396));
                                    let _e3402 = local_5.member_3;
                                    let _e3406 = local_5.member_1[0u];
                                    let _e3412 = select(_e3406[0], -(_e3406[0]), (_e3406[0] < 0.0lf));
                                    let _e3415 = select(_e3406[1], -(_e3406[1]), (_e3406[1] < 0.0lf));
                                    let _e3417 = select(_e3415, _e3412, (_e3412 > _e3415));
                                    let _e3420 = select(_e3406[2], -(_e3406[2]), (_e3406[2] < 0.0lf));
                                    let _e3422 = select(_e3420, _e3417, (_e3417 > _e3420));
                                    let _e3425 = local_5.member_1[1u];
                                    let _e3431 = select(_e3425[0], -(_e3425[0]), (_e3425[0] < 0.0lf));
                                    let _e3434 = select(_e3425[1], -(_e3425[1]), (_e3425[1] < 0.0lf));
                                    let _e3436 = select(_e3434, _e3431, (_e3431 > _e3434));
                                    let _e3439 = select(_e3425[2], -(_e3425[2]), (_e3425[2] < 0.0lf));
                                    let _e3441 = select(_e3439, _e3436, (_e3436 > _e3439));
                                    let _e3445 = local_5.member_3;
                                    let _e3449 = local_5.member_2[0u];
                                    let _e3455 = select(_e3449[0], -(_e3449[0]), (_e3449[0] < 0.0lf));
                                    let _e3458 = select(_e3449[1], -(_e3449[1]), (_e3449[1] < 0.0lf));
                                    let _e3460 = select(_e3458, _e3455, (_e3455 > _e3458));
                                    let _e3463 = select(_e3449[2], -(_e3449[2]), (_e3449[2] < 0.0lf));
                                    let _e3465 = select(_e3463, _e3460, (_e3460 > _e3463));
                                    let _e3468 = local_5.member_2[1u];
                                    let _e3474 = select(_e3468[0], -(_e3468[0]), (_e3468[0] < 0.0lf));
                                    let _e3477 = select(_e3468[1], -(_e3468[1]), (_e3468[1] < 0.0lf));
                                    let _e3479 = select(_e3477, _e3474, (_e3474 > _e3477));
                                    let _e3482 = select(_e3468[2], -(_e3468[2]), (_e3468[2] < 0.0lf));
                                    let _e3484 = select(_e3482, _e3479, (_e3479 > _e3482));
                                    let _e3488 = local_5.member_3;
                                    let _e3496 = local_5.member_3;
                                    local_1 = type_41(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e3301, array<f64, 3>(_e3317, _e3318, _e3319), array<f64, 3>((_e3301[0] - _e3313[0]), (_e3301[1] - _e3313[1]), (_e3301[2] - _e3313[2])), array<f64, 3>(select((_e3317 - _e3313[0]), _e3301[0], _e3320), select((_e3318 - _e3313[1]), _e3301[1], _e3320), select((_e3319 - _e3313[2]), _e3301[2], _e3320))), array<array<f64, 3>, 4>(_e3332, array<f64, 3>(_e3348, _e3349, _e3350), array<f64, 3>((_e3332[0] - _e3344[0]), (_e3332[1] - _e3344[1]), (_e3332[2] - _e3344[2])), array<f64, 3>(select((_e3348 - _e3344[0]), _e3332[0], _e3351), select((_e3349 - _e3344[1]), _e3332[1], _e3351), select((_e3350 - _e3344[2]), _e3332[2], _e3351)))), ((((((select(_e3398, _e3379, (_e3379 > _e3398)) + _e3402) + (select(_e3441, _e3422, (_e3422 > _e3441)) + _e3445)) + (select(_e3484, _e3465, (_e3465 > _e3484)) + _e3488)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3496 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e781.member_1);
                                    let _e3514 = local_1.member_1;
                                    if (_e3298 > _e3514) {
                                        if ((bitcast<u64>(_e3298) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e3520 = (f64(1f) / _e3298);
                                            let _e3522 = (_e3284[0] * _e3520);
                                            let _e3524 = (_e3284[1] * _e3520);
                                            let _e3526 = (_e3284[2] * _e3520);
                                            let _e3531 = (((_e3522 * _e3522) + (_e3524 * _e3524)) + (_e3526 * _e3526));
                                            if (_e3531 <= 2.2250738585072014e-308lf) {
                                                phi_6550_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3531 > 0.0lf));
                                            } else {
                                                phi_6493_ = type_16(0i, 5i);
                                                phi_6496_ = bitcast<f64>(((bitcast<u64>(_e3531) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3538 = phi_6493_;
                                                    let _e3540 = phi_6496_;
                                                    local_25 = _e3540;
                                                    if (_e3538.member < _e3538.member_1) {
                                                        let _e3547 = (_e3538.member + 1i);
                                                        phi_6494_ = type_16(select(_e3547, type_17().member_1, select(false, true, ((false == (_e3547 > _e3538.member)) != false))), _e3538.member_1);
                                                        phi_6537_ = type_17(1u, _e3538.member);
                                                    } else {
                                                        phi_6494_ = _e3538;
                                                        phi_6537_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3558 = phi_6494_;
                                                    let _e3560 = phi_6537_;
                                                    let _e3563 = (bitcast<i32>(_e3560.member) != 0i);
                                                    if _e3563 {
                                                        phi_6497_ = (0.5lf * (_e3540 + (_e3531 / _e3540)));
                                                    } else {
                                                        phi_6497_ = f64();
                                                    }
                                                    let _e3568 = phi_6497_;
                                                    continue;
                                                    continuing {
                                                        phi_6493_ = _e3558;
                                                        phi_6496_ = _e3568;
                                                        break if !(_e3563);
                                                    }
                                                }
                                                let _e3573 = local_25;
                                                phi_6550_ = (_e3573 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3579 = phi_6550_;
                                            let _e3581 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e3583 = local_1.member_1;
                                            let _e3587 = local_1.member_2;
                                            let _e3592 = ((_e3583 * f64(1.01f)) + ((_e3587 * _e3579) * (f64(1f) + _e3581)));
                                            let _e3596 = local_1.member[0u][0u];
                                            let _e3604 = (((_e3522 * _e3596[0]) + (_e3524 * _e3596[1])) + (_e3526 * _e3596[2]));
                                            let _e3608 = local_1.member[0u][1u];
                                            let _e3616 = (((_e3522 * _e3608[0]) + (_e3524 * _e3608[1])) + (_e3526 * _e3608[2]));
                                            let _e3620 = local_1.member[0u][2u];
                                            let _e3628 = (((_e3522 * _e3620[0]) + (_e3524 * _e3620[1])) + (_e3526 * _e3620[2]));
                                            let _e3632 = local_1.member[0u][3u];
                                            let _e3640 = (((_e3522 * _e3632[0]) + (_e3524 * _e3632[1])) + (_e3526 * _e3632[2]));
                                            let _e3644 = local_1.member[1u][0u];
                                            let _e3652 = (((_e3522 * _e3644[0]) + (_e3524 * _e3644[1])) + (_e3526 * _e3644[2]));
                                            let _e3656 = local_1.member[1u][1u];
                                            let _e3664 = (((_e3522 * _e3656[0]) + (_e3524 * _e3656[1])) + (_e3526 * _e3656[2]));
                                            let _e3668 = local_1.member[1u][2u];
                                            let _e3676 = (((_e3522 * _e3668[0]) + (_e3524 * _e3668[1])) + (_e3526 * _e3668[2]));
                                            let _e3680 = local_1.member[1u][3u];
                                            let _e3688 = (((_e3522 * _e3680[0]) + (_e3524 * _e3680[1])) + (_e3526 * _e3680[2]));
                                            local_2 = type_39(array<f64, 4>(_e3604, _e3616, _e3628, _e3640), array<f64, 4>(_e3652, _e3664, _e3676, _e3688), array<f64, 4>((_e3592 + ((select(_e3604, -(_e3604), (_e3604 < 0.0lf)) + select(_e3652, -(_e3652), (_e3652 < 0.0lf))) * _e3581)), (_e3592 + ((select(_e3616, -(_e3616), (_e3616 < 0.0lf)) + select(_e3664, -(_e3664), (_e3664 < 0.0lf))) * _e3581)), (_e3592 + ((select(_e3628, -(_e3628), (_e3628 < 0.0lf)) + select(_e3676, -(_e3676), (_e3676 < 0.0lf))) * _e3581)), (_e3592 + ((select(_e3640, -(_e3640), (_e3640 < 0.0lf)) + select(_e3688, -(_e3688), (_e3688 < 0.0lf))) * _e3581))));
                                            let _e3733 = (((_e3522 * _e3522) + (_e3524 * _e3524)) + (_e3526 * _e3526));
                                            if (_e3733 <= 2.2250738585072014e-308lf) {
                                                phi_6845_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3733 > 0.0lf));
                                            } else {
                                                phi_6788_ = type_16(0i, 5i);
                                                phi_6791_ = bitcast<f64>(((bitcast<u64>(_e3733) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3740 = phi_6788_;
                                                    let _e3742 = phi_6791_;
                                                    local_26 = _e3742;
                                                    if (_e3740.member < _e3740.member_1) {
                                                        let _e3749 = (_e3740.member + 1i);
                                                        phi_6789_ = type_16(select(_e3749, type_17().member_1, select(false, true, ((false == (_e3749 > _e3740.member)) != false))), _e3740.member_1);
                                                        phi_6832_ = type_17(1u, _e3740.member);
                                                    } else {
                                                        phi_6789_ = _e3740;
                                                        phi_6832_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3760 = phi_6789_;
                                                    let _e3762 = phi_6832_;
                                                    let _e3765 = (bitcast<i32>(_e3762.member) != 0i);
                                                    if _e3765 {
                                                        phi_6792_ = (0.5lf * (_e3742 + (_e3733 / _e3742)));
                                                    } else {
                                                        phi_6792_ = f64();
                                                    }
                                                    let _e3770 = phi_6792_;
                                                    continue;
                                                    continuing {
                                                        phi_6788_ = _e3760;
                                                        phi_6791_ = _e3770;
                                                        break if !(_e3765);
                                                    }
                                                }
                                                let _e3775 = local_26;
                                                phi_6845_ = (_e3775 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3781 = phi_6845_;
                                            let _e3792 = (((_e3284[0] * _e3284[0]) + (_e3284[1] * _e3284[1])) + (_e3284[2] * _e3284[2]));
                                            if (_e3792 <= 2.2250738585072014e-308lf) {
                                                phi_6934_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3792 > 0.0lf));
                                            } else {
                                                phi_6877_ = type_16(0i, 5i);
                                                phi_6880_ = bitcast<f64>(((bitcast<u64>(_e3792) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3799 = phi_6877_;
                                                    let _e3801 = phi_6880_;
                                                    local_27 = _e3801;
                                                    if (_e3799.member < _e3799.member_1) {
                                                        let _e3808 = (_e3799.member + 1i);
                                                        phi_6878_ = type_16(select(_e3808, type_17().member_1, select(false, true, ((false == (_e3808 > _e3799.member)) != false))), _e3799.member_1);
                                                        phi_6921_ = type_17(1u, _e3799.member);
                                                    } else {
                                                        phi_6878_ = _e3799;
                                                        phi_6921_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3819 = phi_6878_;
                                                    let _e3821 = phi_6921_;
                                                    let _e3824 = (bitcast<i32>(_e3821.member) != 0i);
                                                    if _e3824 {
                                                        phi_6881_ = (0.5lf * (_e3801 + (_e3792 / _e3801)));
                                                    } else {
                                                        phi_6881_ = f64();
                                                    }
                                                    let _e3829 = phi_6881_;
                                                    continue;
                                                    continuing {
                                                        phi_6877_ = _e3819;
                                                        phi_6880_ = _e3829;
                                                        break if !(_e3824);
                                                    }
                                                }
                                                let _e3834 = local_27;
                                                phi_6934_ = (_e3834 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3840 = phi_6934_;
                                            let _e3848 = local_5.member[0u];
                                            let _e3854 = select(_e3848[0], -(_e3848[0]), (_e3848[0] < 0.0lf));
                                            let _e3857 = select(_e3848[1], -(_e3848[1]), (_e3848[1] < 0.0lf));
                                            let _e3859 = select(_e3857, _e3854, (_e3854 > _e3857));
                                            let _e3862 = select(_e3848[2], -(_e3848[2]), (_e3848[2] < 0.0lf));
                                            let _e3864 = select(_e3862, _e3859, (_e3859 > _e3862));
                                            let _e3867 = local_5.member[1u];
                                            let _e3873 = select(_e3867[0], -(_e3867[0]), (_e3867[0] < 0.0lf));
                                            let _e3876 = select(_e3867[1], -(_e3867[1]), (_e3867[1] < 0.0lf));
                                            let _e3878 = select(_e3876, _e3873, (_e3873 > _e3876));
                                            let _e3881 = select(_e3867[2], -(_e3867[2]), (_e3867[2] < 0.0lf));
                                            let _e3883 = select(_e3881, _e3878, (_e3878 > _e3881));
                                            let _e3887 = local_5.member_3;
                                            let _e3891 = local_5.member_1[0u];
                                            let _e3897 = select(_e3891[0], -(_e3891[0]), (_e3891[0] < 0.0lf));
                                            let _e3900 = select(_e3891[1], -(_e3891[1]), (_e3891[1] < 0.0lf));
                                            let _e3902 = select(_e3900, _e3897, (_e3897 > _e3900));
                                            let _e3905 = select(_e3891[2], -(_e3891[2]), (_e3891[2] < 0.0lf));
                                            let _e3907 = select(_e3905, _e3902, (_e3902 > _e3905));
                                            let _e3910 = local_5.member_1[1u];
                                            let _e3916 = select(_e3910[0], -(_e3910[0]), (_e3910[0] < 0.0lf));
                                            let _e3919 = select(_e3910[1], -(_e3910[1]), (_e3910[1] < 0.0lf));
                                            let _e3921 = select(_e3919, _e3916, (_e3916 > _e3919));
                                            let _e3924 = select(_e3910[2], -(_e3910[2]), (_e3910[2] < 0.0lf));
                                            let _e3926 = select(_e3924, _e3921, (_e3921 > _e3924));
                                            let _e3930 = local_5.member_3;
                                            let _e3934 = local_5.member_2[0u];
                                            let _e3940 = select(_e3934[0], -(_e3934[0]), (_e3934[0] < 0.0lf));
                                            let _e3943 = select(_e3934[1], -(_e3934[1]), (_e3934[1] < 0.0lf));
                                            let _e3945 = select(_e3943, _e3940, (_e3940 > _e3943));
                                            let _e3948 = select(_e3934[2], -(_e3934[2]), (_e3934[2] < 0.0lf));
                                            let _e3950 = select(_e3948, _e3945, (_e3945 > _e3948));
                                            let _e3953 = local_5.member_2[1u];
                                            let _e3959 = select(_e3953[0], -(_e3953[0]), (_e3953[0] < 0.0lf));
                                            let _e3962 = select(_e3953[1], -(_e3953[1]), (_e3953[1] < 0.0lf));
                                            let _e3964 = select(_e3962, _e3959, (_e3959 > _e3962));
                                            let _e3967 = select(_e3953[2], -(_e3953[2]), (_e3953[2] < 0.0lf));
                                            let _e3969 = select(_e3967, _e3964, (_e3964 > _e3967));
                                            let _e3973 = local_5.member_3;
                                            let _e3981 = local_5.member_3;
                                            let _e3996 = ((((_e3840 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e3883, _e3864, (_e3864 > _e3883)) + _e3887) + (select(_e3926, _e3907, (_e3907 > _e3926)) + _e3930)) + (select(_e3969, _e3950, (_e3950 > _e3969)) + _e3973)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3981 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e3781) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                            let _e3999 = local_2.member[0u];
                                            let _e4002 = local_2.member_1[0u];
                                            phi_7252_ = type_9(1u, 4u);
                                            phi_7255_ = ((_e3999 + ((_e4002 - _e3999) * _e1512)) - ((_e3514 * f64(1.01f)) + ((select(_e3999, -(_e3999), (_e3999 < 0.0lf)) + select(_e4002, -(_e4002), (_e4002 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f)))));
                                            loop {
                                                let _e4021 = phi_7252_;
                                                let _e4023 = phi_7255_;
                                                local_28 = _e4023;
                                                local_29 = _e4023;
                                                let _e4026 = (_e4021.member < _e4021.member_1);
                                                let _e4037 = select(type_9().member_1, _e4021.member, _e4026);
                                                let _e4039 = (bitcast<i32>(select(0u, 1u, _e4026)) != 0i);
                                                if _e4039 {
                                                    let _e4042 = local_2.member[_e4037];
                                                    let _e4045 = local_2.member_1[_e4037];
                                                    let _e4062 = ((_e4042 + ((_e4045 - _e4042) * _e1512)) - ((_e3514 * f64(1.01f)) + ((select(_e4042, -(_e4042), (_e4042 < 0.0lf)) + select(_e4045, -(_e4045), (_e4045 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f)))));
                                                    phi_7256_ = select(_e4062, _e4023, (_e4023 < _e4062));
                                                } else {
                                                    phi_7256_ = f64();
                                                }
                                                let _e4066 = phi_7256_;
                                                continue;
                                                continuing {
                                                    phi_7252_ = type_9(select(_e4021.member, (_e4021.member + 1u), _e4026), select(_e4021.member_1, _e4021.member_1, _e4026));
                                                    phi_7255_ = _e4066;
                                                    break if !(_e4039);
                                                }
                                            }
                                            let _e4069 = local_28;
                                            if (_e4069 > f64(0f)) {
                                                let _e4074 = local_29;
                                                let _e4078 = (((_e3996 - _e4074) / _e3996) * f64(2.02f));
                                                if (_e4078 <= 2.2250738585072014e-308lf) {
                                                    phi_7414_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e4078 > 0.0lf));
                                                } else {
                                                    phi_7357_ = type_16(0i, 5i);
                                                    phi_7360_ = bitcast<f64>(((bitcast<u64>(_e4078) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e4085 = phi_7357_;
                                                        let _e4087 = phi_7360_;
                                                        local_30 = _e4087;
                                                        if (_e4085.member < _e4085.member_1) {
                                                            let _e4094 = (_e4085.member + 1i);
                                                            phi_7358_ = type_16(select(_e4094, type_17().member_1, select(false, true, ((false == (_e4094 > _e4085.member)) != false))), _e4085.member_1);
                                                            phi_7401_ = type_17(1u, _e4085.member);
                                                        } else {
                                                            phi_7358_ = _e4085;
                                                            phi_7401_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e4105 = phi_7358_;
                                                        let _e4107 = phi_7401_;
                                                        let _e4110 = (bitcast<i32>(_e4107.member) != 0i);
                                                        if _e4110 {
                                                            phi_7361_ = (0.5lf * (_e4087 + (_e4078 / _e4087)));
                                                        } else {
                                                            phi_7361_ = f64();
                                                        }
                                                        let _e4115 = phi_7361_;
                                                        continue;
                                                        continuing {
                                                            phi_7357_ = _e4105;
                                                            phi_7360_ = _e4115;
                                                            break if !(_e4110);
                                                        }
                                                    }
                                                    let _e4120 = local_30;
                                                    phi_7414_ = (_e4120 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e4126 = phi_7414_;
                                                let _e4129 = ((_e4126 * _e3781) * f64(1.01f));
                                                phi_7421_ = type_9(0u, 4u);
                                                phi_7424_ = f64(2f);
                                                phi_7426_ = true;
                                                phi_7428_ = true;
                                                loop {
                                                    let _e4132 = phi_7421_;
                                                    let _e4134 = phi_7424_;
                                                    let _e4136 = phi_7426_;
                                                    let _e4138 = phi_7428_;
                                                    local_31 = _e4134;
                                                    local_32 = _e4134;
                                                    local_33 = _e4136;
                                                    local_34 = _e4138;
                                                    local_35 = _e4138;
                                                    local_36 = _e4138;
                                                    local_61 = _e4138;
                                                    local_37 = _e4138;
                                                    let _e4141 = (_e4132.member < _e4132.member_1);
                                                    let _e4152 = select(type_9().member_1, _e4132.member, _e4141);
                                                    let _e4154 = (bitcast<i32>(select(0u, 1u, _e4141)) != 0i);
                                                    if _e4154 {
                                                        let _e4158 = local_1.member[0u][_e4152];
                                                        let _e4165 = local_1.member[1u][_e4152];
                                                        let _e4179 = ((select(_e4158[0], -(_e4158[0]), (_e4158[0] < 0.0lf)) + select(_e4158[1], -(_e4158[1]), (_e4158[1] < 0.0lf))) + select(_e4158[2], -(_e4158[2]), (_e4158[2] < 0.0lf)));
                                                        let _e4190 = ((select(_e4165[0], -(_e4165[0]), (_e4165[0] < 0.0lf)) + select(_e4165[1], -(_e4165[1]), (_e4165[1] < 0.0lf))) + select(_e4165[2], -(_e4165[2]), (_e4165[2] < 0.0lf)));
                                                        let _e4198 = (_e4165[0] - _e4158[0]);
                                                        let _e4199 = (_e4165[1] - _e4158[1]);
                                                        let _e4200 = (_e4165[2] - _e4158[2]);
                                                        let _e4219 = local_2.member[_e4152];
                                                        let _e4222 = local_2.member_1[_e4152];
                                                        let _e4235 = ((_e3514 * f64(1.01f)) + ((select(_e4219, -(_e4219), (_e4219 < 0.0lf)) + select(_e4222, -(_e4222), (_e4222 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f))));
                                                        let _e4242 = local_2.member_1[_e4152];
                                                        let _e4245 = local_2.member[_e4152];
                                                        let _e4246 = (_e4242 - _e4245);
                                                        let _e4249 = ((_e4235 + _e4235) + (_e4129 * ((((select(_e4198, -(_e4198), (_e4198 < 0.0lf)) + select(_e4199, -(_e4199), (_e4199 < 0.0lf))) + select(_e4200, -(_e4200), (_e4200 < 0.0lf))) + (_e3514 * f64(6f))) * f64(1.01f))));
                                                        let _e4252 = ((((_e4219 + ((_e4222 - _e4219) * _e1512)) - _e4235) - (_e4129 * ((select(_e4190, _e4179, (_e4179 > _e4190)) + (_e3514 * f64(3f))) * f64(1.01f)))) - _e3996);
                                                        let _e4253 = (_e4252 > 2.2250738585072014e-308lf);
                                                        let _e4254 = (_e4246 > _e4249);
                                                        if _e4254 {
                                                            phi_7665_ = _e4134;
                                                        } else {
                                                            if _e4253 {
                                                                let _e4261 = (_e4249 - _e4246);
                                                                let _e4264 = (_e4252 / select(2.2250738585072014e-308lf, _e4261, (_e4261 > 2.2250738585072014e-308lf)));
                                                                phi_7664_ = select(_e4264, _e4134, (_e4134 < _e4264));
                                                            } else {
                                                                phi_7664_ = _e4134;
                                                            }
                                                            let _e4268 = phi_7664_;
                                                            phi_7665_ = _e4268;
                                                        }
                                                        let _e4270 = phi_7665_;
                                                        phi_7425_ = _e4270;
                                                        phi_7427_ = (_e4136 && select(_e4253, true, (_e4246 < -(_e4249))));
                                                        phi_7429_ = (_e4138 && select(_e4253, true, _e4254));
                                                    } else {
                                                        phi_7425_ = f64();
                                                        phi_7427_ = bool();
                                                        phi_7429_ = bool();
                                                    }
                                                    let _e4272 = phi_7425_;
                                                    let _e4274 = phi_7427_;
                                                    let _e4276 = phi_7429_;
                                                    continue;
                                                    continuing {
                                                        phi_7421_ = type_9(select(_e4132.member, (_e4132.member + 1u), _e4141), select(_e4132.member_1, _e4132.member_1, _e4141));
                                                        phi_7424_ = _e4272;
                                                        phi_7426_ = _e4274;
                                                        phi_7428_ = _e4276;
                                                        break if !(_e4154);
                                                    }
                                                }
                                                let _e4278 = f64(2f);
                                                let _e4280 = local_31;
                                                let _e4283 = local_32;
                                                let _e4286 = (select(_e4278, _e4283, (_e4280 < _e4278)) * f64(0.999f));
                                                let _e4288 = local_33;
                                                if _e4288 {
                                                    let _e4292 = local_34;
                                                    let _e4296 = local_35;
                                                    let _e4300 = local_36;
                                                    phi_7683_ = type_42(select(_e1512, type_42().member, _e4292), select(f64(2f), type_42().member_1, _e4296), select(1u, type_42().member_2, _e4300));
                                                    let _e5411 = local_61;
                                                    phi_7684_ = _e5411;
                                                } else {
                                                    phi_7683_ = type_42();
                                                    phi_7684_ = true;
                                                }
                                                let _e4304 = phi_7683_;
                                                let _e4306 = phi_7684_;
                                                if _e4306 {
                                                    let _e4308 = local_37;
                                                    if _e4308 {
                                                        let _e4314 = (_e1512 + _e4286);
                                                        let _e4317 = select(_e1512, select(_e551, _e4314, (_e4314 < _e551)), (_e4286 > (1.1102230246251565e-16lf * f64(4096f))));
                                                        phi_7706_ = type_9(0u, 4u);
                                                        phi_7709_ = _e4317;
                                                        phi_7711_ = _e1512;
                                                        loop {
                                                            let _e4319 = phi_7706_;
                                                            let _e4321 = phi_7709_;
                                                            let _e4323 = phi_7711_;
                                                            local_38 = _e4321;
                                                            local_39 = _e4323;
                                                            local_40 = _e4323;
                                                            let _e4326 = (_e4319.member < _e4319.member_1);
                                                            let _e4337 = select(type_9().member_1, _e4319.member, _e4326);
                                                            let _e4339 = (bitcast<i32>(select(0u, 1u, _e4326)) != 0i);
                                                            if _e4339 {
                                                                let _e4342 = local_2.member[_e4337];
                                                                let _e4345 = local_2.member_1[_e4337];
                                                                let _e4348 = local_2.member[_e4337];
                                                                let _e4354 = local_2.member_2[_e4337];
                                                                let _e4355 = ((_e4342 + ((_e4345 - _e4348) * _e1512)) - _e4354);
                                                                let _e4358 = local_2.member_1[_e4337];
                                                                let _e4361 = local_2.member[_e4337];
                                                                let _e4362 = (_e4358 - _e4361);
                                                                if (_e4362 > f64(0f)) {
                                                                    let _e4378 = (_e1512 - (_e4355 / _e4362));
                                                                    phi_7823_ = _e4321;
                                                                    phi_7824_ = select(_e4378, _e4323, (_e4323 > _e4378));
                                                                } else {
                                                                    if (_e4355 > f64(0f)) {
                                                                        if (_e4362 < f64(0f)) {
                                                                            let _e4370 = (_e1512 - (_e4355 / _e4362));
                                                                            phi_7821_ = select(_e4370, _e4321, (_e4321 < _e4370));
                                                                        } else {
                                                                            phi_7821_ = _e4321;
                                                                        }
                                                                        let _e4374 = phi_7821_;
                                                                        phi_7822_ = _e4374;
                                                                    } else {
                                                                        phi_7822_ = _e4321;
                                                                    }
                                                                    let _e4376 = phi_7822_;
                                                                    phi_7823_ = _e4376;
                                                                    phi_7824_ = _e4323;
                                                                }
                                                                let _e4382 = phi_7823_;
                                                                let _e4384 = phi_7824_;
                                                                phi_7710_ = _e4382;
                                                                phi_7712_ = _e4384;
                                                            } else {
                                                                phi_7710_ = f64();
                                                                phi_7712_ = f64();
                                                            }
                                                            let _e4386 = phi_7710_;
                                                            let _e4388 = phi_7712_;
                                                            continue;
                                                            continuing {
                                                                phi_7706_ = type_9(select(_e4319.member, (_e4319.member + 1u), _e4326), select(_e4319.member_1, _e4319.member_1, _e4326));
                                                                phi_7709_ = _e4386;
                                                                phi_7711_ = _e4388;
                                                                break if !(_e4339);
                                                            }
                                                        }
                                                        let _e4391 = local_38;
                                                        let _e4393 = local_39;
                                                        let _e4398 = local_40;
                                                        let _e4399 = (_e4398 + ((_e4391 - _e4393) * f64(0.5f)));
                                                        if (_e4399 > _e1512) {
                                                            if (_e4399 <= _e4317) {
                                                                let _e4402 = f64(0f);
                                                                let _e4405 = local_2.member[0u];
                                                                let _e4408 = local_2.member_1[0u];
                                                                let _e4411 = local_2.member[0u];
                                                                let _e4417 = local_2.member_2[0u];
                                                                if (((_e4405 + ((_e4408 - _e4411) * _e4399)) - _e4417) > _e4402) {
                                                                    let _e4422 = local_2.member[1u];
                                                                    let _e4425 = local_2.member_1[1u];
                                                                    let _e4428 = local_2.member[1u];
                                                                    let _e4434 = local_2.member_2[1u];
                                                                    if (((_e4422 + ((_e4425 - _e4428) * _e4399)) - _e4434) > _e4402) {
                                                                        let _e4439 = local_2.member[2u];
                                                                        let _e4442 = local_2.member_1[2u];
                                                                        let _e4445 = local_2.member[2u];
                                                                        let _e4451 = local_2.member_2[2u];
                                                                        if (((_e4439 + ((_e4442 - _e4445) * _e4399)) - _e4451) > _e4402) {
                                                                            let _e4456 = local_2.member[3u];
                                                                            let _e4459 = local_2.member_1[3u];
                                                                            let _e4462 = local_2.member[3u];
                                                                            let _e4468 = local_2.member_2[3u];
                                                                            phi_7987_ = (((_e4456 + ((_e4459 - _e4462) * _e4399)) - _e4468) > _e4402);
                                                                            phi_7988_ = false;
                                                                        } else {
                                                                            phi_7987_ = bool();
                                                                            phi_7988_ = true;
                                                                        }
                                                                        let _e4472 = phi_7987_;
                                                                        let _e4474 = phi_7988_;
                                                                        phi_7989_ = _e4472;
                                                                        phi_7990_ = _e4474;
                                                                    } else {
                                                                        phi_7989_ = bool();
                                                                        phi_7990_ = true;
                                                                    }
                                                                    let _e4476 = phi_7989_;
                                                                    let _e4478 = phi_7990_;
                                                                    phi_7991_ = _e4476;
                                                                    phi_7992_ = _e4478;
                                                                } else {
                                                                    phi_7991_ = bool();
                                                                    phi_7992_ = true;
                                                                }
                                                                let _e4480 = phi_7991_;
                                                                let _e4482 = phi_7992_;
                                                                phi_8001_ = select(true, false, select(_e4480, false, _e4482));
                                                            } else {
                                                                phi_8001_ = true;
                                                            }
                                                            let _e4486 = phi_8001_;
                                                            phi_8002_ = _e4486;
                                                        } else {
                                                            phi_8002_ = true;
                                                        }
                                                        let _e4488 = phi_8002_;
                                                        phi_8011_ = type_42(_e4317, select(_e4399, f64(2f), _e4488), 2u);
                                                        phi_8012_ = type_42();
                                                        phi_8013_ = false;
                                                    } else {
                                                        phi_8011_ = type_42();
                                                        phi_8012_ = type_42(_e1512, f64(2f), 0u);
                                                        phi_8013_ = true;
                                                    }
                                                    let _e4493 = phi_8011_;
                                                    let _e4495 = phi_8012_;
                                                    let _e4497 = phi_8013_;
                                                    phi_8014_ = _e4493;
                                                    phi_8015_ = _e4495;
                                                    phi_8016_ = _e4497;
                                                } else {
                                                    phi_8014_ = type_42();
                                                    phi_8015_ = _e4304;
                                                    phi_8016_ = true;
                                                }
                                                let _e4499 = phi_8014_;
                                                let _e4501 = phi_8015_;
                                                let _e4503 = phi_8016_;
                                                phi_8022_ = _e4501;
                                                phi_8023_ = _e4499;
                                                phi_8024_ = _e4503;
                                            } else {
                                                phi_8022_ = type_42(_e1512, f64(2f), 0u);
                                                phi_8023_ = type_42();
                                                phi_8024_ = true;
                                            }
                                            let _e4505 = phi_8022_;
                                            let _e4507 = phi_8023_;
                                            let _e4509 = phi_8024_;
                                            phi_8028_ = _e4505;
                                            phi_8029_ = _e4507;
                                            phi_8030_ = false;
                                            phi_8031_ = _e4509;
                                        } else {
                                            phi_8028_ = type_42();
                                            phi_8029_ = type_42();
                                            phi_8030_ = true;
                                            phi_8031_ = false;
                                        }
                                        let _e4511 = phi_8028_;
                                        let _e4513 = phi_8029_;
                                        let _e4515 = phi_8030_;
                                        let _e4517 = phi_8031_;
                                        phi_8032_ = _e4511;
                                        phi_8033_ = _e4513;
                                        phi_8034_ = _e4515;
                                        phi_8035_ = _e4517;
                                    } else {
                                        phi_8032_ = type_42();
                                        phi_8033_ = type_42();
                                        phi_8034_ = true;
                                        phi_8035_ = false;
                                    }
                                    let _e4519 = phi_8032_;
                                    let _e4521 = phi_8033_;
                                    let _e4523 = phi_8034_;
                                    let _e4525 = phi_8035_;
                                    let _e4533 = select(_e4525, true, _e4523);
                                    let _e4537 = select(_e4521.member_1, select(_e4519.member_1, f64(2f), _e4523), _e4533);
                                    let _e4539 = select(_e4521.member_2, select(_e4519.member_2, 0u, _e4523), _e4533);
                                    if ((_e553 & 64u) != 0u) {
                                        let _e4541 = (_e4539 == 2u);
                                        let _e4542 = (_e4537 <= _e551);
                                        phi_8070_ = select(f64(), select(f64(), _e4537, _e4542), _e4541);
                                        phi_8071_ = select(f64(), select(f64(), _e4537, _e4542), _e4541);
                                        phi_8072_ = select(false, _e4542, _e4541);
                                        phi_8073_ = select(false, select(true, false, _e4542), _e4541);
                                        phi_8074_ = select(true, false, _e4541);
                                    } else {
                                        phi_8070_ = f64();
                                        phi_8071_ = f64();
                                        phi_8072_ = false;
                                        phi_8073_ = false;
                                        phi_8074_ = true;
                                    }
                                    let _e4552 = phi_8070_;
                                    let _e4554 = phi_8071_;
                                    let _e4556 = phi_8072_;
                                    let _e4558 = phi_8073_;
                                    let _e4560 = phi_8074_;
                                    phi_8075_ = _e4552;
                                    phi_8076_ = _e4539;
                                    phi_8077_ = _e4554;
                                    phi_8078_ = type_42(select(_e4521.member, select(_e4519.member, _e1512, _e4523), _e4533), _e4537, _e4539);
                                    phi_8079_ = _e4539;
                                    phi_8080_ = _e4539;
                                    phi_8081_ = _e4556;
                                    phi_8082_ = _e4558;
                                    phi_8083_ = _e4560;
                                }
                                let _e4562 = phi_8075_;
                                let _e4564 = phi_8076_;
                                let _e4566 = phi_8077_;
                                let _e4568 = phi_8078_;
                                let _e4570 = phi_8079_;
                                let _e4572 = phi_8080_;
                                let _e4574 = phi_8081_;
                                let _e4576 = phi_8082_;
                                let _e4578 = phi_8083_;
                                phi_8084_ = _e4562;
                                phi_8085_ = _e4564;
                                phi_8086_ = _e4566;
                                phi_8087_ = _e4568;
                                phi_8088_ = _e4570;
                                phi_8089_ = _e4572;
                                phi_8090_ = _e4574;
                                phi_8091_ = _e3216;
                                phi_8092_ = _e4576;
                                phi_8093_ = _e4578;
                                phi_8094_ = false;
                            } else {
                                phi_8084_ = f64();
                                phi_8085_ = u32();
                                phi_8086_ = f64();
                                phi_8087_ = type_42();
                                phi_8088_ = u32();
                                phi_8089_ = u32();
                                phi_8090_ = false;
                                phi_8091_ = false;
                                phi_8092_ = false;
                                phi_8093_ = false;
                                phi_8094_ = true;
                            }
                            let _e4580 = phi_8084_;
                            let _e4582 = phi_8085_;
                            let _e4584 = phi_8086_;
                            let _e4586 = phi_8087_;
                            let _e4588 = phi_8088_;
                            let _e4590 = phi_8089_;
                            let _e4592 = phi_8090_;
                            let _e4594 = phi_8091_;
                            let _e4596 = phi_8092_;
                            let _e4598 = phi_8093_;
                            let _e4600 = phi_8094_;
                            phi_8095_ = _e3213;
                            phi_3079_ = _e4580;
                            phi_3081_ = _e4582;
                            phi_3083_ = _e4584;
                            phi_8096_ = _e4586;
                            phi_8097_ = _e4588;
                            phi_8098_ = _e3213;
                            phi_8099_ = _e4590;
                            phi_8100_ = _e4592;
                            phi_8101_ = _e4594;
                            phi_8102_ = _e4596;
                            phi_8103_ = _e4598;
                            phi_8104_ = false;
                            phi_8105_ = _e4600;
                        } else {
                            phi_8095_ = f64();
                            phi_3079_ = f64();
                            phi_3081_ = u32();
                            phi_3083_ = f64();
                            phi_8096_ = type_42();
                            phi_8097_ = u32();
                            phi_8098_ = f64();
                            phi_8099_ = u32();
                            phi_8100_ = false;
                            phi_8101_ = false;
                            phi_8102_ = false;
                            phi_8103_ = false;
                            phi_8104_ = true;
                            phi_8105_ = false;
                        }
                        let _e4602 = phi_8095_;
                        let _e4604 = phi_3079_;
                        let _e4606 = phi_3081_;
                        let _e4608 = phi_3083_;
                        let _e4610 = phi_8096_;
                        let _e4612 = phi_8097_;
                        let _e4614 = phi_8098_;
                        let _e4616 = phi_8099_;
                        let _e4618 = phi_8100_;
                        let _e4620 = phi_8101_;
                        let _e4622 = phi_8102_;
                        let _e4624 = phi_8103_;
                        let _e4626 = phi_8104_;
                        let _e4628 = phi_8105_;
                        local_41 = _e4620;
                        local_42 = _e4622;
                        local_43 = _e4620;
                        local_44 = _e4624;
                        local_45 = _e4620;
                        local_46 = _e4626;
                        local_47 = _e4620;
                        local_48 = _e4628;
                        local_49 = _e4610;
                        local_50 = _e4610;
                        local_51 = _e4612;
                        local_52 = _e4610;
                        local_62 = _e4620;
                        local_53 = _e4616;
                        local_55 = _e4614;
                        local_56 = _e4602;
                        continue;
                        continuing {
                            phi_3075_ = _e1530;
                            phi_3078_ = _e4604;
                            phi_3080_ = _e4606;
                            phi_3082_ = _e4608;
                            break if !(_e4618);
                        }
                    }
                    let _e4631 = local_41;
                    let _e4633 = local_42;
                    let _e4634 = select(_e4633, false, _e4631);
                    let _e4636 = local_43;
                    let _e4638 = local_44;
                    let _e4641 = local_45;
                    let _e4643 = local_46;
                    let _e4646 = local_47;
                    let _e4648 = local_48;
                    if _e4634 {
                        let _e4651 = local_49;
                        if (_e4651.member >= _e551) {
                            phi_8134_ = type_38(type_37(0u, f64()), 0u);
                        } else {
                            let _e4655 = local_50;
                            let _e4659 = local_51;
                            let _e4662 = local_52;
                            phi_8134_ = type_38(type_37(2u, _e4662.member), select(_e4659, 0u, (_e4655.member > _e542)));
                        }
                        let _e4669 = phi_8134_;
                        phi_8135_ = _e4669;
                        phi_8136_ = false;
                        phi_8137_ = false;
                        phi_8138_ = false;
                        phi_8139_ = false;
                    } else {
                        phi_8135_ = type_38();
                        phi_8136_ = select(_e4638, false, _e4636);
                        let _e5506 = local_62;
                        phi_8137_ = _e5506;
                        phi_8138_ = select(_e4643, false, _e4641);
                        phi_8139_ = select(_e4648, false, _e4646);
                    }
                    let _e4671 = phi_8135_;
                    let _e4673 = phi_8136_;
                    let _e4675 = phi_8137_;
                    let _e4677 = phi_8138_;
                    let _e4679 = phi_8139_;
                    let _e4681 = local_53;
                    let _e4683 = local_54;
                    let _e4686 = local_55;
                    let _e4688 = local_56;
                    let _e4690 = select(_e4675, true, _e4673);
                    let _e4695 = local_57;
                    let _e4696 = select(_e4695, select(_e4688, _e4686, _e4673), _e4690);
                    let _e4698 = local_58;
                    let _e4699 = select(_e4698, select(_e4683, _e4681, _e4673), _e4690);
                    if select(select(_e4677, false, _e4673), true, _e4690) {
                        local[0u] = 0.01f;
                        local[1u] = 0f;
                        local[2u] = 0.8f;
                        phi_8173_ = type_9(0u, 3u);
                        loop {
                            let _e4712 = phi_8173_;
                            let _e4715 = (_e4712.member < _e4712.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e4715)) != 0i) {
                                let _e4730 = local[select(type_9().member_1, _e4712.member, _e4715)];
                                let _e4733 = (_e4696 + (select(f64(0f), _e533, (_e533 >= (1.1102230246251565e-16lf * f64(8f)))) * f64(_e4730)));
                                let _e4735 = select(_e551, _e4733, (_e4733 < _e551));
                                let _e4738 = local_5.member[0u];
                                let _e4744 = local_5.member[1u];
                                let _e4760 = local_5.member_1[0u];
                                let _e4766 = local_5.member_1[1u];
                                let _e4782 = local_5.member_2[0u];
                                let _e4788 = local_5.member_2[1u];
                                let _e4802 = function_4(array<f64, 3>((_e4738[0] + ((_e4744[0] - _e4738[0]) * _e4735)), (_e4738[1] + ((_e4744[1] - _e4738[1]) * _e4735)), (_e4738[2] + ((_e4744[2] - _e4738[2]) * _e4735))), array<f64, 3>((_e4760[0] + ((_e4766[0] - _e4760[0]) * _e4735)), (_e4760[1] + ((_e4766[1] - _e4760[1]) * _e4735)), (_e4760[2] + ((_e4766[2] - _e4760[2]) * _e4735))), array<f64, 3>((_e4782[0] + ((_e4788[0] - _e4782[0]) * _e4735)), (_e4782[1] + ((_e4788[1] - _e4782[1]) * _e4735)), (_e4782[2] + ((_e4788[2] - _e4782[2]) * _e4735))), _e230.member);
                                let _e4813 = (((_e4802[0] * _e4802[0]) + (_e4802[1] * _e4802[1])) + (_e4802[2] * _e4802[2]));
                                if (_e4813 <= 2.2250738585072014e-308lf) {
                                    phi_8406_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e4813 > 0.0lf));
                                } else {
                                    phi_8349_ = type_16(0i, 5i);
                                    phi_8352_ = bitcast<f64>(((bitcast<u64>(_e4813) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e4820 = phi_8349_;
                                        let _e4822 = phi_8352_;
                                        local_59 = _e4822;
                                        if (_e4820.member < _e4820.member_1) {
                                            let _e4829 = (_e4820.member + 1i);
                                            phi_8350_ = type_16(select(_e4829, type_17().member_1, select(false, true, ((false == (_e4829 > _e4820.member)) != false))), _e4820.member_1);
                                            phi_8393_ = type_17(1u, _e4820.member);
                                        } else {
                                            phi_8350_ = _e4820;
                                            phi_8393_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e4840 = phi_8350_;
                                        let _e4842 = phi_8393_;
                                        let _e4845 = (bitcast<i32>(_e4842.member) != 0i);
                                        if _e4845 {
                                            phi_8353_ = (0.5lf * (_e4822 + (_e4813 / _e4822)));
                                        } else {
                                            phi_8353_ = f64();
                                        }
                                        let _e4850 = phi_8353_;
                                        continue;
                                        continuing {
                                            phi_8349_ = _e4840;
                                            phi_8352_ = _e4850;
                                            break if !(_e4845);
                                        }
                                    }
                                    let _e4855 = local_59;
                                    phi_8406_ = (_e4855 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e4861 = phi_8406_;
                                let _e4869 = local_5.member[0u];
                                let _e4875 = select(_e4869[0], -(_e4869[0]), (_e4869[0] < 0.0lf));
                                let _e4878 = select(_e4869[1], -(_e4869[1]), (_e4869[1] < 0.0lf));
                                let _e4880 = select(_e4878, _e4875, (_e4875 > _e4878));
                                let _e4883 = select(_e4869[2], -(_e4869[2]), (_e4869[2] < 0.0lf));
                                let _e4885 = select(_e4883, _e4880, (_e4880 > _e4883));
                                let _e4888 = local_5.member[1u];
                                let _e4894 = select(_e4888[0], -(_e4888[0]), (_e4888[0] < 0.0lf));
                                let _e4897 = select(_e4888[1], -(_e4888[1]), (_e4888[1] < 0.0lf));
                                let _e4899 = select(_e4897, _e4894, (_e4894 > _e4897));
                                let _e4902 = select(_e4888[2], -(_e4888[2]), (_e4888[2] < 0.0lf));
                                let _e4904 = select(_e4902, _e4899, (_e4899 > _e4902));
                                let _e4908 = local_5.member_3;
                                let _e4912 = local_5.member_1[0u];
                                let _e4918 = select(_e4912[0], -(_e4912[0]), (_e4912[0] < 0.0lf));
                                let _e4921 = select(_e4912[1], -(_e4912[1]), (_e4912[1] < 0.0lf));
                                let _e4923 = select(_e4921, _e4918, (_e4918 > _e4921));
                                let _e4926 = select(_e4912[2], -(_e4912[2]), (_e4912[2] < 0.0lf));
                                let _e4928 = select(_e4926, _e4923, (_e4923 > _e4926));
                                let _e4931 = local_5.member_1[1u];
                                let _e4937 = select(_e4931[0], -(_e4931[0]), (_e4931[0] < 0.0lf));
                                let _e4940 = select(_e4931[1], -(_e4931[1]), (_e4931[1] < 0.0lf));
                                let _e4942 = select(_e4940, _e4937, (_e4937 > _e4940));
                                let _e4945 = select(_e4931[2], -(_e4931[2]), (_e4931[2] < 0.0lf));
                                let _e4947 = select(_e4945, _e4942, (_e4942 > _e4945));
                                let _e4951 = local_5.member_3;
                                let _e4955 = local_5.member_2[0u];
                                let _e4961 = select(_e4955[0], -(_e4955[0]), (_e4955[0] < 0.0lf));
                                let _e4964 = select(_e4955[1], -(_e4955[1]), (_e4955[1] < 0.0lf));
                                let _e4966 = select(_e4964, _e4961, (_e4961 > _e4964));
                                let _e4969 = select(_e4955[2], -(_e4955[2]), (_e4955[2] < 0.0lf));
                                let _e4971 = select(_e4969, _e4966, (_e4966 > _e4969));
                                let _e4974 = local_5.member_2[1u];
                                let _e4980 = select(_e4974[0], -(_e4974[0]), (_e4974[0] < 0.0lf));
                                let _e4983 = select(_e4974[1], -(_e4974[1]), (_e4974[1] < 0.0lf));
                                let _e4985 = select(_e4983, _e4980, (_e4980 > _e4983));
                                let _e4988 = select(_e4974[2], -(_e4974[2]), (_e4974[2] < 0.0lf));
                                let _e4990 = select(_e4988, _e4985, (_e4985 > _e4988));
                                let _e4994 = local_5.member_3;
                                let _e5002 = local_5.member_3;
                                let _e5012 = (((_e4861 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e4904, _e4885, (_e4885 > _e4904)) + _e4908) + (select(_e4947, _e4928, (_e4928 > _e4947)) + _e4951)) + (select(_e4990, _e4971, (_e4971 > _e4990)) + _e4994)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5002 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e781.member_1);
                                phi_8683_ = select(true, false, _e5012);
                                phi_8684_ = _e5012;
                            } else {
                                phi_8683_ = false;
                                phi_8684_ = false;
                            }
                            let _e5015 = phi_8683_;
                            let _e5017 = phi_8684_;
                            local_60 = _e5017;
                            continue;
                            continuing {
                                phi_8173_ = type_9(select(_e4712.member, (_e4712.member + 1u), _e4715), select(_e4712.member_1, _e4712.member_1, _e4715));
                                break if !(_e5015);
                            }
                        }
                        let _e5020 = local_60;
                        if _e5020 {
                            phi_8696_ = type_38(type_37(1u, _e4696), select(_e4699, 1u, (_e4696 > _e542)));
                            phi_8697_ = false;
                        } else {
                            phi_8696_ = type_38();
                            phi_8697_ = true;
                        }
                        let _e5026 = phi_8696_;
                        let _e5028 = phi_8697_;
                        if _e5028 {
                            phi_8709_ = type_38(type_37(2u, _e4696), select(_e4699, 0u, (_e4696 > _e542)));
                        } else {
                            phi_8709_ = _e5026;
                        }
                        let _e5034 = phi_8709_;
                        phi_8710_ = _e5034;
                        phi_8711_ = false;
                        phi_8712_ = false;
                    } else {
                        phi_8710_ = type_38();
                        phi_8711_ = select(select(_e4679, false, _e4673), false, _e4690);
                        phi_8712_ = select(select(_e4634, false, _e4673), false, _e4690);
                    }
                    let _e5036 = phi_8710_;
                    let _e5038 = phi_8711_;
                    let _e5040 = phi_8712_;
                    if _e5038 {
                        phi_8719_ = type_38(type_37(0u, f64()), 0u);
                        phi_8720_ = true;
                    } else {
                        phi_8719_ = _e4671;
                        phi_8720_ = _e5040;
                    }
                    let _e5044 = phi_8719_;
                    let _e5046 = phi_8720_;
                    phi_8724_ = _e5044;
                    phi_8725_ = _e5036;
                    phi_8726_ = _e5046;
                } else {
                    phi_8724_ = _e1502;
                    phi_8725_ = type_38();
                    phi_8726_ = true;
                }
                let _e5048 = phi_8724_;
                let _e5050 = phi_8725_;
                let _e5052 = phi_8726_;
                if _e5052 {
                    phi_8730_ = _e5048;
                } else {
                    phi_8730_ = _e5050;
                }
                let _e5054 = phi_8730_;
                switch bitcast<i32>(_e5054.member.member) {
                    case 0: {
                        phi_8748_ = type_35(0u, _e5054.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5065 = function_1(_e5054.member.member_1);
                        phi_8748_ = type_35(0u, _e5054.member_1, _e5065, true);
                        break;
                    }
                    case 2: {
                        let _e5061 = function_1(_e5054.member.member_1);
                        phi_8748_ = type_35(1u, _e5054.member_1, _e5061, true);
                        break;
                    }
                    default: {
                        phi_8748_ = type_35();
                        break;
                    }
                }
                let _e5069 = phi_8748_;
                local_6 = type_35(_e5069.member, _e5069.member_1, array<u32, 2>(_e5069.member_2[0], _e5069.member_2[1]), _e5069.member_3);
                phi_8757_ = type_9(_e188, _e191);
            } else {
                phi_8757_ = type_9(0u, 0u);
            }
            let _e5079 = phi_8757_;
            let _e5085 = local_6.member_3;
            if _e5085 {
                let _e5087 = params.member.member.member_1;
                phi_8782_ = ((_e5087 & 16u) != 0u);
            } else {
                phi_8782_ = false;
            }
            let _e5091 = phi_8782_;
            let _e5093 = local_6.member_3;
            if _e5093 {
                let _e5095 = local_6.member_2;
                let _e5099 = (_e5095[1] >> bitcast<u32>(20i));
                let _e5113 = atomicMin((&earliest.member[0u]), select(((((_e5099 - 896u) << bitcast<u32>(23i)) | ((_e5095[1] & 1048575u) << bitcast<u32>(3i))) | (_e5095[0] >> bitcast<u32>(29i))), 0u, (_e5099 <= 896u)));
            }
            if (_e106 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5091 {
                let _e5117 = atomicAdd((&counters[0u]), 1u);
                phi_8825_ = _e5117;
            } else {
                phi_8825_ = 0u;
            }
            let _e5119 = phi_8825_;
            workgroupBarrier();
            if (_e106 == 0u) {
                let _e5122 = atomicLoad((&counters[0u]));
                if (_e5122 > 0u) {
                    let _e5125 = atomicAdd((&contacts.member[0u]), _e5122);
                    atomicStore((&counters[1u]), _e5125);
                }
            }
            workgroupBarrier();
            let _e5128 = atomicLoad((&counters[1u]));
            let _e5129 = (_e5128 + _e5119);
            if _e5091 {
                let _e5131 = params.member.member_1.member_3;
                if (_e5129 < _e5131) {
                    let _e5137 = (7u * _e5129);
                    atomicStore((&contacts.member[(4u + _e5137)]), select(1u, 0u, ((_e5079.member_1 & 2147483648u) == 0u)));
                    let _e5142 = local_6.member;
                    atomicStore((&contacts.member[(_e5137 + 5u)]), _e5142);
                    atomicStore((&contacts.member[(_e5137 + 6u)]), _e5079.member);
                    atomicStore((&contacts.member[(_e5137 + 7u)]), (_e5079.member_1 & 2147483647u));
                    let _e5151 = local_6.member_2[0u];
                    atomicStore((&contacts.member[(_e5137 + 8u)]), _e5151);
                    let _e5156 = local_6.member_2[1u];
                    atomicStore((&contacts.member[(_e5137 + 9u)]), _e5156);
                    let _e5160 = local_6.member_1;
                    atomicStore((&contacts.member[(_e5137 + 10u)]), _e5160);
                }
            }
        }
        continue;
        continuing {
            phi_1001_ = type_9(select(_e159.member, (_e159.member + 1u), _e162), select(_e159.member_1, _e159.member_1, _e162));
            break if !(_e175);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_near_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
