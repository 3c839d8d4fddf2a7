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
    var phi_2029_: bool;
    var phi_2125_: type_36;
    var phi_2126_: bool;
    var phi_2127_: type_36;
    var phi_2128_: bool;
    var phi_2129_: type_36;
    var phi_2130_: bool;
    var phi_2135_: type_36;
    var phi_2305_: type_16;
    var phi_2308_: f64;
    var phi_2306_: type_16;
    var phi_2349_: type_17;
    var phi_2309_: f64;
    var local_7: f64;
    var phi_2362_: f64;
    var phi_3289_: type_38;
    var phi_3290_: bool;
    var phi_3291_: type_38;
    var phi_3292_: bool;
    var phi_3298_: type_16;
    var phi_3301_: f64;
    var phi_3303_: u32;
    var phi_3305_: f64;
    var phi_3299_: type_16;
    var phi_3346_: type_17;
    var phi_3789_: type_9;
    var phi_3792_: f64;
    var phi_3794_: f64;
    var phi_3796_: f64;
    var phi_3798_: f64;
    var phi_3800_: bool;
    var phi_3802_: u32;
    var phi_3954_: array<f64, 3>;
    var phi_4022_: type_16;
    var phi_4025_: f64;
    var phi_4023_: type_16;
    var phi_4066_: type_17;
    var phi_4026_: f64;
    var local_8: f64;
    var phi_4079_: f64;
    var phi_4205_: type_39;
    var phi_4206_: bool;
    var phi_4207_: type_39;
    var phi_4208_: bool;
    var phi_4218_: type_39;
    var phi_4390_: bool;
    var phi_4391_: bool;
    var phi_4392_: bool;
    var phi_4393_: bool;
    var phi_4394_: bool;
    var phi_4395_: bool;
    var phi_4697_: bool;
    var phi_4698_: bool;
    var phi_4699_: bool;
    var phi_4700_: bool;
    var phi_4701_: bool;
    var phi_4702_: bool;
    var phi_4710_: bool;
    var phi_4820_: f64;
    var phi_4821_: bool;
    var phi_4822_: f64;
    var phi_4823_: bool;
    var phi_4824_: f64;
    var phi_4825_: bool;
    var phi_4826_: bool;
    var phi_4892_: f64;
    var phi_4893_: bool;
    var phi_4894_: f64;
    var phi_4895_: bool;
    var phi_4896_: f64;
    var phi_4897_: bool;
    var phi_4898_: bool;
    var phi_4969_: f64;
    var phi_4970_: bool;
    var phi_4971_: f64;
    var phi_4972_: bool;
    var phi_4973_: f64;
    var phi_4974_: bool;
    var phi_4975_: bool;
    var phi_5041_: f64;
    var phi_5042_: bool;
    var phi_5043_: f64;
    var phi_5044_: bool;
    var phi_5045_: f64;
    var phi_5046_: bool;
    var phi_5047_: bool;
    var phi_5224_: type_16;
    var phi_5227_: f64;
    var phi_5225_: type_16;
    var phi_5268_: type_17;
    var phi_5228_: f64;
    var local_9: f64;
    var phi_5281_: f64;
    var phi_5558_: bool;
    var phi_5559_: bool;
    var phi_5586_: f64;
    var phi_5587_: f64;
    var phi_5588_: bool;
    var phi_5589_: f64;
    var phi_5590_: f64;
    var phi_5591_: bool;
    var phi_5592_: bool;
    var phi_5593_: f64;
    var phi_5594_: f64;
    var phi_5595_: f64;
    var phi_5596_: f64;
    var phi_5597_: bool;
    var phi_5598_: bool;
    var phi_5599_: bool;
    var phi_5600_: bool;
    var phi_5601_: f64;
    var phi_5602_: f64;
    var phi_5603_: f64;
    var phi_5604_: f64;
    var phi_5605_: bool;
    var phi_5606_: bool;
    var phi_5607_: bool;
    var phi_5608_: bool;
    var phi_5609_: bool;
    var phi_5610_: f64;
    var phi_5611_: f64;
    var phi_5612_: f64;
    var phi_5613_: f64;
    var phi_5614_: bool;
    var phi_5615_: bool;
    var phi_5616_: bool;
    var phi_5617_: bool;
    var phi_5618_: bool;
    var phi_5956_: f64;
    var phi_5958_: u32;
    var phi_5959_: f64;
    var phi_5960_: bool;
    var phi_5961_: bool;
    var phi_5962_: bool;
    var phi_5963_: u32;
    var phi_5964_: f64;
    var phi_5965_: f64;
    var phi_5966_: f64;
    var phi_5967_: f64;
    var phi_5968_: bool;
    var phi_5969_: u32;
    var phi_5970_: bool;
    var phi_5971_: bool;
    var phi_5972_: bool;
    var phi_5973_: bool;
    var phi_5974_: bool;
    var phi_5975_: bool;
    var phi_6003_: f64;
    var phi_6004_: f64;
    var phi_6005_: f64;
    var phi_6006_: f64;
    var phi_6007_: bool;
    var phi_6008_: u32;
    var phi_6009_: bool;
    var phi_6010_: bool;
    var phi_6011_: bool;
    var phi_6012_: bool;
    var phi_6013_: bool;
    var phi_6014_: bool;
    var phi_3793_: f64;
    var phi_3795_: f64;
    var phi_3797_: f64;
    var phi_3799_: f64;
    var phi_3801_: bool;
    var phi_3803_: u32;
    var phi_6015_: f64;
    var phi_6016_: f64;
    var phi_6017_: bool;
    var phi_6018_: bool;
    var phi_6019_: bool;
    var phi_6020_: bool;
    var phi_6021_: bool;
    var phi_6022_: bool;
    var phi_6023_: bool;
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
    var phi_6090_: f64;
    var phi_6091_: bool;
    var phi_6716_: type_16;
    var phi_6719_: f64;
    var phi_6717_: type_16;
    var phi_6760_: type_17;
    var phi_6720_: f64;
    var local_25: f64;
    var phi_6773_: f64;
    var phi_7011_: type_16;
    var phi_7014_: f64;
    var phi_7012_: type_16;
    var phi_7055_: type_17;
    var phi_7015_: f64;
    var local_26: f64;
    var phi_7068_: f64;
    var phi_7100_: type_16;
    var phi_7103_: f64;
    var phi_7101_: type_16;
    var phi_7144_: type_17;
    var phi_7104_: f64;
    var local_27: f64;
    var phi_7157_: f64;
    var phi_7475_: type_9;
    var phi_7478_: f64;
    var phi_7479_: f64;
    var local_28: f64;
    var local_29: f64;
    var phi_7580_: type_16;
    var phi_7583_: f64;
    var phi_7581_: type_16;
    var phi_7624_: type_17;
    var phi_7584_: f64;
    var local_30: f64;
    var phi_7637_: f64;
    var phi_7644_: type_9;
    var phi_7647_: f64;
    var phi_7649_: bool;
    var phi_7651_: bool;
    var phi_7887_: f64;
    var phi_7888_: f64;
    var phi_7648_: f64;
    var phi_7650_: bool;
    var phi_7652_: bool;
    var local_31: f64;
    var local_32: f64;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var local_36: bool;
    var phi_7906_: type_42;
    var phi_7907_: bool;
    var local_37: bool;
    var phi_7929_: type_9;
    var phi_7932_: f64;
    var phi_7934_: f64;
    var phi_8044_: f64;
    var phi_8045_: f64;
    var phi_8046_: f64;
    var phi_8047_: f64;
    var phi_7933_: f64;
    var phi_7935_: f64;
    var local_38: f64;
    var local_39: f64;
    var local_40: f64;
    var phi_8210_: bool;
    var phi_8211_: bool;
    var phi_8212_: bool;
    var phi_8213_: bool;
    var phi_8214_: bool;
    var phi_8215_: bool;
    var phi_8224_: bool;
    var phi_8225_: bool;
    var phi_8234_: type_42;
    var phi_8235_: type_42;
    var phi_8236_: bool;
    var phi_8237_: type_42;
    var phi_8238_: type_42;
    var phi_8239_: bool;
    var phi_8245_: type_42;
    var phi_8246_: type_42;
    var phi_8247_: bool;
    var phi_8251_: type_42;
    var phi_8252_: type_42;
    var phi_8253_: bool;
    var phi_8254_: bool;
    var phi_8255_: type_42;
    var phi_8256_: type_42;
    var phi_8257_: bool;
    var phi_8258_: bool;
    var phi_8293_: f64;
    var phi_8294_: f64;
    var phi_8295_: bool;
    var phi_8296_: bool;
    var phi_8297_: bool;
    var phi_8298_: f64;
    var phi_8299_: u32;
    var phi_8300_: f64;
    var phi_8301_: type_42;
    var phi_8302_: u32;
    var phi_8303_: u32;
    var phi_8304_: bool;
    var phi_8305_: bool;
    var phi_8306_: bool;
    var phi_8307_: f64;
    var phi_8308_: u32;
    var phi_8309_: f64;
    var phi_8310_: type_42;
    var phi_8311_: u32;
    var phi_8312_: u32;
    var phi_8313_: bool;
    var phi_8314_: bool;
    var phi_8315_: bool;
    var phi_8316_: bool;
    var phi_8317_: bool;
    var phi_8318_: f64;
    var phi_3302_: f64;
    var phi_3304_: u32;
    var phi_3306_: f64;
    var phi_8319_: type_42;
    var phi_8320_: u32;
    var phi_8321_: f64;
    var phi_8322_: u32;
    var phi_8323_: bool;
    var phi_8324_: bool;
    var phi_8325_: bool;
    var phi_8326_: bool;
    var phi_8327_: bool;
    var phi_8328_: bool;
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
    var phi_8357_: type_38;
    var phi_8358_: type_38;
    var phi_8359_: bool;
    var phi_8360_: bool;
    var phi_8361_: bool;
    var phi_8362_: bool;
    var local_53: u32;
    var local_54: u32;
    var local_55: f64;
    var local_56: f64;
    var local_57: f64;
    var local_58: u32;
    var phi_8396_: type_9;
    var phi_8572_: type_16;
    var phi_8575_: f64;
    var phi_8573_: type_16;
    var phi_8616_: type_17;
    var phi_8576_: f64;
    var local_59: f64;
    var phi_8629_: f64;
    var phi_8906_: bool;
    var phi_8907_: bool;
    var local_60: bool;
    var phi_8919_: type_38;
    var phi_8920_: bool;
    var phi_8932_: type_38;
    var phi_8933_: type_38;
    var phi_8934_: bool;
    var phi_8935_: bool;
    var phi_8942_: type_38;
    var phi_8943_: bool;
    var phi_8947_: type_38;
    var phi_8948_: type_38;
    var phi_8949_: bool;
    var phi_8953_: type_38;
    var phi_8971_: type_35;
    var phi_8980_: type_9;
    var phi_9005_: bool;
    var phi_9048_: u32;
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
                let _e685 = select(_e515.member[0][0], -(_e515.member[0][0]), (_e515.member[0][0] < 0.0lf));
                let _e689 = select(_e515.member[0][1], -(_e515.member[0][1]), (_e515.member[0][1] < 0.0lf));
                let _e691 = select(_e689, _e685, (_e685 > _e689));
                let _e695 = select(_e515.member[0][2], -(_e515.member[0][2]), (_e515.member[0][2] < 0.0lf));
                let _e697 = select(_e695, _e691, (_e691 > _e695));
                let _e703 = select(_e515.member[1][0], -(_e515.member[1][0]), (_e515.member[1][0] < 0.0lf));
                let _e707 = select(_e515.member[1][1], -(_e515.member[1][1]), (_e515.member[1][1] < 0.0lf));
                let _e709 = select(_e707, _e703, (_e703 > _e707));
                let _e713 = select(_e515.member[1][2], -(_e515.member[1][2]), (_e515.member[1][2] < 0.0lf));
                let _e715 = select(_e713, _e709, (_e709 > _e713));
                let _e719 = (select(_e715, _e697, (_e697 > _e715)) + _e515.member_3);
                let _e725 = select(_e515.member_1[0][0], -(_e515.member_1[0][0]), (_e515.member_1[0][0] < 0.0lf));
                let _e729 = select(_e515.member_1[0][1], -(_e515.member_1[0][1]), (_e515.member_1[0][1] < 0.0lf));
                let _e731 = select(_e729, _e725, (_e725 > _e729));
                let _e735 = select(_e515.member_1[0][2], -(_e515.member_1[0][2]), (_e515.member_1[0][2] < 0.0lf));
                let _e737 = select(_e735, _e731, (_e731 > _e735));
                let _e743 = select(_e515.member_1[1][0], -(_e515.member_1[1][0]), (_e515.member_1[1][0] < 0.0lf));
                let _e747 = select(_e515.member_1[1][1], -(_e515.member_1[1][1]), (_e515.member_1[1][1] < 0.0lf));
                let _e749 = select(_e747, _e743, (_e743 > _e747));
                let _e753 = select(_e515.member_1[1][2], -(_e515.member_1[1][2]), (_e515.member_1[1][2] < 0.0lf));
                let _e755 = select(_e753, _e749, (_e749 > _e753));
                let _e759 = (select(_e755, _e737, (_e737 > _e755)) + _e515.member_3);
                let _e765 = select(_e515.member_2[0][0], -(_e515.member_2[0][0]), (_e515.member_2[0][0] < 0.0lf));
                let _e769 = select(_e515.member_2[0][1], -(_e515.member_2[0][1]), (_e515.member_2[0][1] < 0.0lf));
                let _e771 = select(_e769, _e765, (_e765 > _e769));
                let _e775 = select(_e515.member_2[0][2], -(_e515.member_2[0][2]), (_e515.member_2[0][2] < 0.0lf));
                let _e777 = select(_e775, _e771, (_e771 > _e775));
                let _e783 = select(_e515.member_2[1][0], -(_e515.member_2[1][0]), (_e515.member_2[1][0] < 0.0lf));
                let _e787 = select(_e515.member_2[1][1], -(_e515.member_2[1][1]), (_e515.member_2[1][1] < 0.0lf));
                let _e789 = select(_e787, _e783, (_e783 > _e787));
                let _e793 = select(_e515.member_2[1][2], -(_e515.member_2[1][2]), (_e515.member_2[1][2] < 0.0lf));
                let _e795 = select(_e793, _e789, (_e789 > _e793));
                let _e799 = (select(_e795, _e777, (_e777 > _e795)) + _e515.member_3);
                let _e801 = select(_e759, _e719, (_e719 > _e759));
                let _e803 = select(_e799, _e801, (_e801 > _e799));
                if (_e803 <= f64(65536f)) {
                    phi_2029_ = (_e803 >= f64((1f / 65536f)));
                } else {
                    phi_2029_ = false;
                }
                let _e810 = phi_2029_;
                if _e810 {
                    phi_2129_ = type_36();
                    phi_2130_ = true;
                } else {
                    if (_e679 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e679) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e817 = (9214364837600034816lu - (bitcast<u64>(_e679) & 9218868437227405312lu));
                            let _e820 = bitcast<f64>(select(4503599627370496lu, _e817, (_e817 > 4503599627370496lu)));
                            let _e821 = (_e524 * _e820);
                            phi_2125_ = type_36(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e515.member[0][0] * _e820), (_e515.member[0][1] * _e820), (_e515.member[0][2] * _e820)), array<f64, 3>((_e515.member[1][0] * _e820), (_e515.member[1][1] * _e820), (_e515.member[1][2] * _e820))), array<array<f64, 3>, 2>(array<f64, 3>((_e515.member_1[0][0] * _e820), (_e515.member_1[0][1] * _e820), (_e515.member_1[0][2] * _e820)), array<f64, 3>((_e515.member_1[1][0] * _e820), (_e515.member_1[1][1] * _e820), (_e515.member_1[1][2] * _e820))), array<array<f64, 3>, 2>(array<f64, 3>((_e515.member_2[0][0] * _e820), (_e515.member_2[0][1] * _e820), (_e515.member_2[0][2] * _e820)), array<f64, 3>((_e515.member_2[1][0] * _e820), (_e515.member_2[1][1] * _e820), (_e515.member_2[1][2] * _e820))), ((_e515.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e820)), select(_e821, select(2.2250738585072014e-308lf, _e821, (_e821 > 2.2250738585072014e-308lf)), (_e524 > f64(0f))));
                            phi_2126_ = false;
                        } else {
                            phi_2125_ = type_36();
                            phi_2126_ = true;
                        }
                        let _e892 = phi_2125_;
                        let _e894 = phi_2126_;
                        phi_2127_ = _e892;
                        phi_2128_ = _e894;
                    } else {
                        phi_2127_ = type_36();
                        phi_2128_ = true;
                    }
                    let _e896 = phi_2127_;
                    let _e898 = phi_2128_;
                    phi_2129_ = _e896;
                    phi_2130_ = _e898;
                }
                let _e900 = phi_2129_;
                let _e902 = phi_2130_;
                if _e902 {
                    phi_2135_ = type_36(_e515, _e524);
                } else {
                    phi_2135_ = _e900;
                }
                let _e905 = phi_2135_;
                local_5 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e905.member.member[0][0], _e905.member.member[0][1], _e905.member.member[0][2]), array<f64, 3>(_e905.member.member[1][0], _e905.member.member[1][1], _e905.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e905.member.member_1[0][0], _e905.member.member_1[0][1], _e905.member.member_1[0][2]), array<f64, 3>(_e905.member.member_1[1][0], _e905.member.member_1[1][1], _e905.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e905.member.member_2[0][0], _e905.member.member_2[0][1], _e905.member.member_2[0][2]), array<f64, 3>(_e905.member.member_2[1][0], _e905.member.member_2[1][1], _e905.member.member_2[1][2])), _e905.member.member_3);
                let _e948 = local_5.member[0u];
                let _e954 = local_5.member[1u];
                let _e970 = local_5.member_1[0u];
                let _e976 = local_5.member_1[1u];
                let _e992 = local_5.member_2[0u];
                let _e998 = local_5.member_2[1u];
                let _e1012 = function_4(array<f64, 3>((_e948[0] + ((_e954[0] - _e948[0]) * _e542)), (_e948[1] + ((_e954[1] - _e948[1]) * _e542)), (_e948[2] + ((_e954[2] - _e948[2]) * _e542))), array<f64, 3>((_e970[0] + ((_e976[0] - _e970[0]) * _e542)), (_e970[1] + ((_e976[1] - _e970[1]) * _e542)), (_e970[2] + ((_e976[2] - _e970[2]) * _e542))), array<f64, 3>((_e992[0] + ((_e998[0] - _e992[0]) * _e542)), (_e992[1] + ((_e998[1] - _e992[1]) * _e542)), (_e992[2] + ((_e998[2] - _e992[2]) * _e542))), _e230.member);
                let _e1023 = (((_e1012[0] * _e1012[0]) + (_e1012[1] * _e1012[1])) + (_e1012[2] * _e1012[2]));
                if (_e1023 <= 2.2250738585072014e-308lf) {
                    phi_2362_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1023 > 0.0lf));
                } else {
                    phi_2305_ = type_16(0i, 5i);
                    phi_2308_ = bitcast<f64>(((bitcast<u64>(_e1023) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e1030 = phi_2305_;
                        let _e1032 = phi_2308_;
                        local_7 = _e1032;
                        if (_e1030.member < _e1030.member_1) {
                            let _e1039 = (_e1030.member + 1i);
                            phi_2306_ = type_16(select(_e1039, type_17().member_1, select(false, true, ((false == (_e1039 > _e1030.member)) != false))), _e1030.member_1);
                            phi_2349_ = type_17(1u, _e1030.member);
                        } else {
                            phi_2306_ = _e1030;
                            phi_2349_ = type_17(0u, type_17().member_1);
                        }
                        let _e1050 = phi_2306_;
                        let _e1052 = phi_2349_;
                        let _e1055 = (bitcast<i32>(_e1052.member) != 0i);
                        if _e1055 {
                            phi_2309_ = (0.5lf * (_e1032 + (_e1023 / _e1032)));
                        } else {
                            phi_2309_ = f64();
                        }
                        let _e1060 = phi_2309_;
                        continue;
                        continuing {
                            phi_2305_ = _e1050;
                            phi_2308_ = _e1060;
                            break if !(_e1055);
                        }
                    }
                    let _e1065 = local_7;
                    phi_2362_ = (_e1065 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e1071 = phi_2362_;
                let _e1079 = local_5.member[0u];
                let _e1085 = select(_e1079[0], -(_e1079[0]), (_e1079[0] < 0.0lf));
                let _e1088 = select(_e1079[1], -(_e1079[1]), (_e1079[1] < 0.0lf));
                let _e1090 = select(_e1088, _e1085, (_e1085 > _e1088));
                let _e1093 = select(_e1079[2], -(_e1079[2]), (_e1079[2] < 0.0lf));
                let _e1095 = select(_e1093, _e1090, (_e1090 > _e1093));
                let _e1098 = local_5.member[1u];
                let _e1104 = select(_e1098[0], -(_e1098[0]), (_e1098[0] < 0.0lf));
                let _e1107 = select(_e1098[1], -(_e1098[1]), (_e1098[1] < 0.0lf));
                let _e1109 = select(_e1107, _e1104, (_e1104 > _e1107));
                let _e1112 = select(_e1098[2], -(_e1098[2]), (_e1098[2] < 0.0lf));
                let _e1114 = select(_e1112, _e1109, (_e1109 > _e1112));
                let _e1118 = local_5.member_3;
                let _e1122 = local_5.member_1[0u];
                let _e1128 = select(_e1122[0], -(_e1122[0]), (_e1122[0] < 0.0lf));
                let _e1131 = select(_e1122[1], -(_e1122[1]), (_e1122[1] < 0.0lf));
                let _e1133 = select(_e1131, _e1128, (_e1128 > _e1131));
                let _e1136 = select(_e1122[2], -(_e1122[2]), (_e1122[2] < 0.0lf));
                let _e1138 = select(_e1136, _e1133, (_e1133 > _e1136));
                let _e1141 = local_5.member_1[1u];
                let _e1147 = select(_e1141[0], -(_e1141[0]), (_e1141[0] < 0.0lf));
                let _e1150 = select(_e1141[1], -(_e1141[1]), (_e1141[1] < 0.0lf));
                let _e1152 = select(_e1150, _e1147, (_e1147 > _e1150));
                let _e1155 = select(_e1141[2], -(_e1141[2]), (_e1141[2] < 0.0lf));
                let _e1157 = select(_e1155, _e1152, (_e1152 > _e1155));
                let _e1161 = local_5.member_3;
                let _e1165 = local_5.member_2[0u];
                let _e1171 = select(_e1165[0], -(_e1165[0]), (_e1165[0] < 0.0lf));
                let _e1174 = select(_e1165[1], -(_e1165[1]), (_e1165[1] < 0.0lf));
                let _e1176 = select(_e1174, _e1171, (_e1171 > _e1174));
                let _e1179 = select(_e1165[2], -(_e1165[2]), (_e1165[2] < 0.0lf));
                let _e1181 = select(_e1179, _e1176, (_e1176 > _e1179));
                let _e1184 = local_5.member_2[1u];
                let _e1190 = select(_e1184[0], -(_e1184[0]), (_e1184[0] < 0.0lf));
                let _e1193 = select(_e1184[1], -(_e1184[1]), (_e1184[1] < 0.0lf));
                let _e1195 = select(_e1193, _e1190, (_e1190 > _e1193));
                let _e1198 = select(_e1184[2], -(_e1184[2]), (_e1184[2] < 0.0lf));
                let _e1200 = select(_e1198, _e1195, (_e1195 > _e1198));
                let _e1204 = local_5.member_3;
                let _e1212 = local_5.member_3;
                let _e1222 = (((_e1071 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e1114, _e1095, (_e1095 > _e1114)) + _e1118) + (select(_e1157, _e1138, (_e1138 > _e1157)) + _e1161)) + (select(_e1200, _e1181, (_e1181 > _e1200)) + _e1204)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1212 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e905.member_1);
                if _e1222 {
                    phi_3291_ = type_38();
                    phi_3292_ = true;
                } else {
                    let _e1225 = local_5.member_1[0u];
                    let _e1231 = local_5.member_2[0u];
                    let _e1237 = ((_e1225[1] * _e1231[2]) - (_e1225[2] * _e1231[1]));
                    let _e1240 = ((_e1225[2] * _e1231[0]) - (_e1225[0] * _e1231[2]));
                    let _e1243 = ((_e1225[0] * _e1231[1]) - (_e1225[1] * _e1231[0]));
                    let _e1246 = local_5.member_1[1u];
                    let _e1252 = local_5.member_2[1u];
                    let _e1258 = ((_e1246[1] * _e1252[2]) - (_e1246[2] * _e1252[1]));
                    let _e1261 = ((_e1246[2] * _e1252[0]) - (_e1246[0] * _e1252[2]));
                    let _e1264 = ((_e1246[0] * _e1252[1]) - (_e1246[1] * _e1252[0]));
                    let _e1267 = local_5.member_1[0u];
                    let _e1273 = local_5.member_2[1u];
                    let _e1288 = local_5.member_1[1u];
                    let _e1294 = local_5.member_2[0u];
                    let _e1307 = (((_e1267[1] * _e1273[2]) - (_e1267[2] * _e1273[1])) + ((_e1288[1] * _e1294[2]) - (_e1288[2] * _e1294[1])));
                    let _e1308 = (((_e1267[2] * _e1273[0]) - (_e1267[0] * _e1273[2])) + ((_e1288[2] * _e1294[0]) - (_e1288[0] * _e1294[2])));
                    let _e1309 = (((_e1267[0] * _e1273[1]) - (_e1267[1] * _e1273[0])) + ((_e1288[0] * _e1294[1]) - (_e1288[1] * _e1294[0])));
                    let _e1312 = local_5.member[0u];
                    let _e1323 = local_5.member[1u];
                    let _e1334 = local_5.member[0u];
                    let _e1343 = ((((_e1323[0] * _e1237) + (_e1323[1] * _e1240)) + (_e1323[2] * _e1243)) + (((_e1334[0] * _e1307) + (_e1334[1] * _e1308)) + (_e1334[2] * _e1309)));
                    let _e1346 = local_5.member[0u];
                    let _e1357 = local_5.member[1u];
                    let _e1366 = ((((_e1346[0] * _e1258) + (_e1346[1] * _e1261)) + (_e1346[2] * _e1264)) + (((_e1357[0] * _e1307) + (_e1357[1] * _e1308)) + (_e1357[2] * _e1309)));
                    let _e1369 = local_5.member[1u];
                    let _e1380 = local_5.member[0u];
                    let _e1386 = select(_e1380[0], -(_e1380[0]), (_e1380[0] < 0.0lf));
                    let _e1389 = select(_e1380[1], -(_e1380[1]), (_e1380[1] < 0.0lf));
                    let _e1391 = select(_e1389, _e1386, (_e1386 > _e1389));
                    let _e1394 = select(_e1380[2], -(_e1380[2]), (_e1380[2] < 0.0lf));
                    let _e1396 = select(_e1394, _e1391, (_e1391 > _e1394));
                    let _e1399 = local_5.member[1u];
                    let _e1405 = select(_e1399[0], -(_e1399[0]), (_e1399[0] < 0.0lf));
                    let _e1408 = select(_e1399[1], -(_e1399[1]), (_e1399[1] < 0.0lf));
                    let _e1410 = select(_e1408, _e1405, (_e1405 > _e1408));
                    let _e1413 = select(_e1399[2], -(_e1399[2]), (_e1399[2] < 0.0lf));
                    let _e1415 = select(_e1413, _e1410, (_e1410 > _e1413));
                    let _e1419 = local_5.member_3;
                    let _e1420 = (select(_e1415, _e1396, (_e1396 > _e1415)) + _e1419);
                    let _e1423 = local_5.member_1[0u];
                    let _e1429 = select(_e1423[0], -(_e1423[0]), (_e1423[0] < 0.0lf));
                    let _e1432 = select(_e1423[1], -(_e1423[1]), (_e1423[1] < 0.0lf));
                    let _e1434 = select(_e1432, _e1429, (_e1429 > _e1432));
                    let _e1437 = select(_e1423[2], -(_e1423[2]), (_e1423[2] < 0.0lf));
                    let _e1439 = select(_e1437, _e1434, (_e1434 > _e1437));
                    let _e1442 = local_5.member_1[1u];
                    let _e1448 = select(_e1442[0], -(_e1442[0]), (_e1442[0] < 0.0lf));
                    let _e1451 = select(_e1442[1], -(_e1442[1]), (_e1442[1] < 0.0lf));
                    let _e1453 = select(_e1451, _e1448, (_e1448 > _e1451));
                    let _e1456 = select(_e1442[2], -(_e1442[2]), (_e1442[2] < 0.0lf));
                    let _e1458 = select(_e1456, _e1453, (_e1453 > _e1456));
                    let _e1462 = local_5.member_3;
                    let _e1463 = (select(_e1458, _e1439, (_e1439 > _e1458)) + _e1462);
                    let _e1466 = local_5.member_2[0u];
                    let _e1472 = select(_e1466[0], -(_e1466[0]), (_e1466[0] < 0.0lf));
                    let _e1475 = select(_e1466[1], -(_e1466[1]), (_e1466[1] < 0.0lf));
                    let _e1477 = select(_e1475, _e1472, (_e1472 > _e1475));
                    let _e1480 = select(_e1466[2], -(_e1466[2]), (_e1466[2] < 0.0lf));
                    let _e1482 = select(_e1480, _e1477, (_e1477 > _e1480));
                    let _e1485 = local_5.member_2[1u];
                    let _e1491 = select(_e1485[0], -(_e1485[0]), (_e1485[0] < 0.0lf));
                    let _e1494 = select(_e1485[1], -(_e1485[1]), (_e1485[1] < 0.0lf));
                    let _e1496 = select(_e1494, _e1491, (_e1491 > _e1494));
                    let _e1499 = select(_e1485[2], -(_e1485[2]), (_e1485[2] < 0.0lf));
                    let _e1501 = select(_e1499, _e1496, (_e1496 > _e1499));
                    let _e1505 = local_5.member_3;
                    let _e1506 = (select(_e1501, _e1482, (_e1482 > _e1501)) + _e1505);
                    let _e1507 = f64(1f);
                    let _e1508 = f64(8f);
                    let _e1510 = ((_e1463 * _e1508) * _e1506);
                    let _e1518 = local_5.member_3;
                    let _e1545 = ((select(_e1237, -(_e1237), (_e1237 < 0.0lf)) + select(_e1240, -(_e1240), (_e1240 < 0.0lf))) + select(_e1243, -(_e1243), (_e1243 < 0.0lf)));
                    let _e1556 = ((select(_e1258, -(_e1258), (_e1258 < 0.0lf)) + select(_e1261, -(_e1261), (_e1261 < 0.0lf))) + select(_e1264, -(_e1264), (_e1264 < 0.0lf)));
                    let _e1558 = select(_e1556, _e1545, (_e1545 > _e1556));
                    let _e1570 = (((select(_e1307, -(_e1307), (_e1307 < 0.0lf)) + select(_e1308, -(_e1308), (_e1308 < 0.0lf))) + select(_e1309, -(_e1309), (_e1309 < 0.0lf))) * f64(0.5f));
                    let _e1578 = local_5.member_3;
                    let _e1593 = f64(3f);
                    let _e1594 = ((((_e1312[0] * _e1237) + (_e1312[1] * _e1240)) + (_e1312[2] * _e1243)) * _e1593);
                    let _e1595 = ((((_e1369[0] * _e1258) + (_e1369[1] * _e1261)) + (_e1369[2] * _e1264)) * _e1593);
                    let _e1597 = select(_e1595, _e1594, (_e1594 < _e1595));
                    let _e1599 = select(_e1366, _e1343, (_e1343 < _e1366));
                    let _e1601 = select(_e1599, _e1597, (_e1597 < _e1599));
                    let _e1603 = select(_e1595, _e1594, (_e1594 > _e1595));
                    let _e1605 = select(_e1366, _e1343, (_e1343 > _e1366));
                    let _e1608 = -(select(_e1605, _e1603, (_e1603 > _e1605)));
                    if ((select(_e1608, _e1601, (_e1601 > _e1608)) - ((((((_e1420 * _e1508) * _e1510) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1518 * f64(19f)) * ((_e1420 * (_e1463 + _e1506)) + (_e1463 * _e1506)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1507 + _e1420) * ((_e1507 + _e1463) * (_e1507 + _e1506))))) + ((_e905.member_1 * (((select(_e1570, _e1558, (_e1558 > _e1570)) + (_e1510 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1578 * f64(6f)) * (_e1463 + _e1506))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1507 + _e1463) * (_e1507 + _e1506))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                        phi_3289_ = type_38(type_37(0u, f64()), 0u);
                        phi_3290_ = false;
                    } else {
                        phi_3289_ = type_38();
                        phi_3290_ = true;
                    }
                    let _e1622 = phi_3289_;
                    let _e1624 = phi_3290_;
                    phi_3291_ = _e1622;
                    phi_3292_ = _e1624;
                }
                let _e1626 = phi_3291_;
                let _e1628 = phi_3292_;
                if _e1628 {
                    phi_3298_ = type_16(0i, 2i);
                    phi_3301_ = _e542;
                    phi_3303_ = 0u;
                    phi_3305_ = _e542;
                    loop {
                        let _e1630 = phi_3298_;
                        let _e1632 = phi_3301_;
                        let _e1634 = phi_3303_;
                        let _e1636 = phi_3305_;
                        local_54 = _e1634;
                        local_57 = _e1632;
                        local_58 = _e1634;
                        if (_e1630.member < _e1630.member_1) {
                            let _e1643 = (_e1630.member + 1i);
                            phi_3299_ = type_16(select(_e1643, type_17().member_1, select(false, true, ((false == (_e1643 > _e1630.member)) != false))), _e1630.member_1);
                            phi_3346_ = type_17(1u, _e1630.member);
                        } else {
                            phi_3299_ = _e1630;
                            phi_3346_ = type_17(0u, type_17().member_1);
                        }
                        let _e1654 = phi_3299_;
                        let _e1656 = phi_3346_;
                        if (bitcast<i32>(_e1656.member) != 0i) {
                            if select(select(true, false, _e1222), true, (_e1656.member_1 > 0i)) {
                                let _e1666 = local_5.member[0u];
                                let _e1672 = local_5.member_1[0u];
                                let _e1678 = local_5.member_2[0u];
                                let _e1682 = (_e1666[0] - _e1672[0]);
                                let _e1683 = (_e1666[1] - _e1672[1]);
                                let _e1684 = (_e1666[2] - _e1672[2]);
                                let _e1685 = (_e230.member == 0u);
                                let _e1697 = local_5.member[1u];
                                let _e1703 = local_5.member_1[1u];
                                let _e1709 = local_5.member_2[1u];
                                let _e1713 = (_e1697[0] - _e1703[0]);
                                let _e1714 = (_e1697[1] - _e1703[1]);
                                let _e1715 = (_e1697[2] - _e1703[2]);
                                let _e1716 = (_e230.member == 0u);
                                let _e1728 = local_5.member[0u];
                                let _e1734 = select(_e1728[0], -(_e1728[0]), (_e1728[0] < 0.0lf));
                                let _e1737 = select(_e1728[1], -(_e1728[1]), (_e1728[1] < 0.0lf));
                                let _e1739 = select(_e1737, _e1734, (_e1734 > _e1737));
                                let _e1742 = select(_e1728[2], -(_e1728[2]), (_e1728[2] < 0.0lf));
                                let _e1744 = select(_e1742, _e1739, (_e1739 > _e1742));
                                let _e1747 = local_5.member[1u];
                                let _e1753 = select(_e1747[0], -(_e1747[0]), (_e1747[0] < 0.0lf));
                                let _e1756 = select(_e1747[1], -(_e1747[1]), (_e1747[1] < 0.0lf));
                                let _e1758 = select(_e1756, _e1753, (_e1753 > _e1756));
                                let _e1761 = select(_e1747[2], -(_e1747[2]), (_e1747[2] < 0.0lf));
                                let _e1763 = select(_e1761, _e1758, (_e1758 > _e1761));
                                let _e1767 = local_5.member_3;
                                let _e1771 = local_5.member_1[0u];
                                let _e1777 = select(_e1771[0], -(_e1771[0]), (_e1771[0] < 0.0lf));
                                let _e1780 = select(_e1771[1], -(_e1771[1]), (_e1771[1] < 0.0lf));
                                let _e1782 = select(_e1780, _e1777, (_e1777 > _e1780));
                                let _e1785 = select(_e1771[2], -(_e1771[2]), (_e1771[2] < 0.0lf));
                                let _e1787 = select(_e1785, _e1782, (_e1782 > _e1785));
                                let _e1790 = local_5.member_1[1u];
                                let _e1796 = select(_e1790[0], -(_e1790[0]), (_e1790[0] < 0.0lf));
                                let _e1799 = select(_e1790[1], -(_e1790[1]), (_e1790[1] < 0.0lf));
                                let _e1801 = select(_e1799, _e1796, (_e1796 > _e1799));
                                let _e1804 = select(_e1790[2], -(_e1790[2]), (_e1790[2] < 0.0lf));
                                let _e1806 = select(_e1804, _e1801, (_e1801 > _e1804));
                                let _e1810 = local_5.member_3;
                                let _e1814 = local_5.member_2[0u];
                                let _e1820 = select(_e1814[0], -(_e1814[0]), (_e1814[0] < 0.0lf));
                                let _e1823 = select(_e1814[1], -(_e1814[1]), (_e1814[1] < 0.0lf));
                                let _e1825 = select(_e1823, _e1820, (_e1820 > _e1823));
                                let _e1828 = select(_e1814[2], -(_e1814[2]), (_e1814[2] < 0.0lf));
                                let _e1830 = select(_e1828, _e1825, (_e1825 > _e1828));
                                let _e1833 = local_5.member_2[1u];
                                let _e1839 = select(_e1833[0], -(_e1833[0]), (_e1833[0] < 0.0lf));
                                let _e1842 = select(_e1833[1], -(_e1833[1]), (_e1833[1] < 0.0lf));
                                let _e1844 = select(_e1842, _e1839, (_e1839 > _e1842));
                                let _e1847 = select(_e1833[2], -(_e1833[2]), (_e1833[2] < 0.0lf));
                                let _e1849 = select(_e1847, _e1844, (_e1844 > _e1847));
                                let _e1853 = local_5.member_3;
                                let _e1861 = local_5.member_3;
                                let _e1869 = (_e533 * f64(0.00390625f));
                                let _e1870 = f64(0f);
                                let _e1871 = f64(1f);
                                local_3 = type_39(array<f64, 4>(_e1870, _e1870, _e1870, _e1870), array<f64, 4>(_e1870, _e1870, _e1870, _e1870), array<f64, 4>(_e1871, _e1871, _e1871, _e1871));
                                phi_3789_ = type_9(0u, 96u);
                                phi_3792_ = _e1636;
                                phi_3794_ = _e1636;
                                phi_3796_ = (_e551 - _e1636);
                                phi_3798_ = _e1636;
                                phi_3800_ = false;
                                phi_3802_ = 0u;
                                loop {
                                    let _e1878 = phi_3789_;
                                    let _e1880 = phi_3792_;
                                    let _e1882 = phi_3794_;
                                    let _e1884 = phi_3796_;
                                    let _e1886 = phi_3798_;
                                    let _e1888 = phi_3800_;
                                    let _e1890 = phi_3802_;
                                    local_20 = _e1880;
                                    local_24 = _e1882;
                                    let _e1893 = (_e1878.member < _e1878.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e1893)) != 0i) {
                                        let _e1907 = local_5.member[0u];
                                        let _e1913 = local_5.member[1u];
                                        let _e1929 = local_5.member_1[0u];
                                        let _e1935 = local_5.member_1[1u];
                                        let _e1951 = local_5.member_2[0u];
                                        let _e1957 = local_5.member_2[1u];
                                        let _e1971 = function_4(array<f64, 3>((_e1907[0] + ((_e1913[0] - _e1907[0]) * _e1880)), (_e1907[1] + ((_e1913[1] - _e1907[1]) * _e1880)), (_e1907[2] + ((_e1913[2] - _e1907[2]) * _e1880))), array<f64, 3>((_e1929[0] + ((_e1935[0] - _e1929[0]) * _e1880)), (_e1929[1] + ((_e1935[1] - _e1929[1]) * _e1880)), (_e1929[2] + ((_e1935[2] - _e1929[2]) * _e1880))), array<f64, 3>((_e1951[0] + ((_e1957[0] - _e1951[0]) * _e1880)), (_e1951[1] + ((_e1957[1] - _e1951[1]) * _e1880)), (_e1951[2] + ((_e1957[2] - _e1951[2]) * _e1880))), _e230.member);
                                        if (_e1890 == 0u) {
                                            phi_3954_ = _e1971;
                                        } else {
                                            let _e1973 = f64(0f);
                                            phi_3954_ = array<f64, 3>(select(_e1973, _e1971[0], (_e1890 == 1u)), select(_e1973, _e1971[1], (_e1890 == 2u)), select(_e1973, _e1971[2], (_e1890 == 3u)));
                                        }
                                        let _e1985 = phi_3954_;
                                        let _e1999 = ((select(_e1985[0], -(_e1985[0]), (_e1985[0] < 0.0lf)) + select(_e1985[1], -(_e1985[1]), (_e1985[1] < 0.0lf))) + select(_e1985[2], -(_e1985[2]), (_e1985[2] < 0.0lf)));
                                        if (_e1999 > f64(0f)) {
                                            if ((bitcast<u64>(_e1999) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2006 = (f64(1f) / _e1999);
                                                let _e2008 = (_e1985[0] * _e2006);
                                                let _e2010 = (_e1985[1] * _e2006);
                                                let _e2012 = (_e1985[2] * _e2006);
                                                let _e2017 = (((_e2008 * _e2008) + (_e2010 * _e2010)) + (_e2012 * _e2012));
                                                if (_e2017 <= 2.2250738585072014e-308lf) {
                                                    phi_4079_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2017 > 0.0lf));
                                                } else {
                                                    phi_4022_ = type_16(0i, 5i);
                                                    phi_4025_ = bitcast<f64>(((bitcast<u64>(_e2017) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2024 = phi_4022_;
                                                        let _e2026 = phi_4025_;
                                                        local_8 = _e2026;
                                                        if (_e2024.member < _e2024.member_1) {
                                                            let _e2033 = (_e2024.member + 1i);
                                                            phi_4023_ = type_16(select(_e2033, type_17().member_1, select(false, true, ((false == (_e2033 > _e2024.member)) != false))), _e2024.member_1);
                                                            phi_4066_ = type_17(1u, _e2024.member);
                                                        } else {
                                                            phi_4023_ = _e2024;
                                                            phi_4066_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2044 = phi_4023_;
                                                        let _e2046 = phi_4066_;
                                                        let _e2049 = (bitcast<i32>(_e2046.member) != 0i);
                                                        if _e2049 {
                                                            phi_4026_ = (0.5lf * (_e2026 + (_e2017 / _e2026)));
                                                        } else {
                                                            phi_4026_ = f64();
                                                        }
                                                        let _e2054 = phi_4026_;
                                                        continue;
                                                        continuing {
                                                            phi_4022_ = _e2044;
                                                            phi_4025_ = _e2054;
                                                            break if !(_e2049);
                                                        }
                                                    }
                                                    let _e2059 = local_8;
                                                    phi_4079_ = (_e2059 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2065 = phi_4079_;
                                                let _e2067 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2074 = ((((((((select(_e1763, _e1744, (_e1744 > _e1763)) + _e1767) + (select(_e1806, _e1787, (_e1787 > _e1806)) + _e1810)) + (select(_e1849, _e1830, (_e1830 > _e1849)) + _e1853)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1861 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e905.member_1 * _e2065) * (f64(1f) + _e2067)));
                                                let _e2079 = (((_e2008 * _e1666[0]) + (_e2010 * _e1666[1])) + (_e2012 * _e1666[2]));
                                                let _e2084 = (((_e2008 * _e1682) + (_e2010 * _e1683)) + (_e2012 * _e1684));
                                                let _e2089 = (((_e2008 * (_e1666[0] - _e1678[0])) + (_e2010 * (_e1666[1] - _e1678[1]))) + (_e2012 * (_e1666[2] - _e1678[2])));
                                                let _e2094 = (((_e2008 * select((_e1682 - _e1678[0]), _e1666[0], _e1685)) + (_e2010 * select((_e1683 - _e1678[1]), _e1666[1], _e1685))) + (_e2012 * select((_e1684 - _e1678[2]), _e1666[2], _e1685)));
                                                let _e2100 = (((_e2008 * _e1697[0]) + (_e2010 * _e1697[1])) + (_e2012 * _e1697[2]));
                                                let _e2105 = (((_e2008 * _e1713) + (_e2010 * _e1714)) + (_e2012 * _e1715));
                                                let _e2110 = (((_e2008 * (_e1697[0] - _e1709[0])) + (_e2010 * (_e1697[1] - _e1709[1]))) + (_e2012 * (_e1697[2] - _e1709[2])));
                                                let _e2115 = (((_e2008 * select((_e1713 - _e1709[0]), _e1697[0], _e1716)) + (_e2010 * select((_e1714 - _e1709[1]), _e1697[1], _e1716))) + (_e2012 * select((_e1715 - _e1709[2]), _e1697[2], _e1716)));
                                                phi_4205_ = type_39(array<f64, 4>(_e2079, _e2084, _e2089, _e2094), array<f64, 4>(_e2100, _e2105, _e2110, _e2115), array<f64, 4>((_e2074 + ((select(_e2079, -(_e2079), (_e2079 < 0.0lf)) + select(_e2100, -(_e2100), (_e2100 < 0.0lf))) * _e2067)), (_e2074 + ((select(_e2084, -(_e2084), (_e2084 < 0.0lf)) + select(_e2105, -(_e2105), (_e2105 < 0.0lf))) * _e2067)), (_e2074 + ((select(_e2089, -(_e2089), (_e2089 < 0.0lf)) + select(_e2110, -(_e2110), (_e2110 < 0.0lf))) * _e2067)), (_e2074 + ((select(_e2094, -(_e2094), (_e2094 < 0.0lf)) + select(_e2115, -(_e2115), (_e2115 < 0.0lf))) * _e2067))));
                                                phi_4206_ = false;
                                            } else {
                                                phi_4205_ = type_39();
                                                phi_4206_ = true;
                                            }
                                            let _e2156 = phi_4205_;
                                            let _e2158 = phi_4206_;
                                            phi_4207_ = _e2156;
                                            phi_4208_ = _e2158;
                                        } else {
                                            phi_4207_ = type_39();
                                            phi_4208_ = true;
                                        }
                                        let _e2160 = phi_4207_;
                                        let _e2162 = phi_4208_;
                                        if _e2162 {
                                            let _e2163 = f64(0f);
                                            let _e2164 = f64(1f);
                                            phi_4218_ = type_39(array<f64, 4>(_e2163, _e2163, _e2163, _e2163), array<f64, 4>(_e2163, _e2163, _e2163, _e2163), array<f64, 4>(_e2164, _e2164, _e2164, _e2164));
                                        } else {
                                            phi_4218_ = _e2160;
                                        }
                                        let _e2170 = phi_4218_;
                                        local_4 = type_39(array<f64, 4>(_e2170.member[0], _e2170.member[1], _e2170.member[2], _e2170.member[3]), array<f64, 4>(_e2170.member_1[0], _e2170.member_1[1], _e2170.member_1[2], _e2170.member_1[3]), array<f64, 4>(_e2170.member_2[0], _e2170.member_2[1], _e2170.member_2[2], _e2170.member_2[3]));
                                        let _e2190 = (_e1880 - _e1886);
                                        let _e2192 = f64(0f);
                                        let _e2195 = local_4.member[0u];
                                        let _e2198 = local_4.member_1[0u];
                                        let _e2201 = local_4.member[0u];
                                        let _e2207 = local_4.member_2[0u];
                                        if (((_e2195 + ((_e2198 - _e2201) * _e1880)) - _e2207) > _e2192) {
                                            let _e2212 = local_4.member[1u];
                                            let _e2215 = local_4.member_1[1u];
                                            let _e2218 = local_4.member[1u];
                                            let _e2224 = local_4.member_2[1u];
                                            if (((_e2212 + ((_e2215 - _e2218) * _e1880)) - _e2224) > _e2192) {
                                                let _e2229 = local_4.member[2u];
                                                let _e2232 = local_4.member_1[2u];
                                                let _e2235 = local_4.member[2u];
                                                let _e2241 = local_4.member_2[2u];
                                                if (((_e2229 + ((_e2232 - _e2235) * _e1880)) - _e2241) > _e2192) {
                                                    let _e2246 = local_4.member[3u];
                                                    let _e2249 = local_4.member_1[3u];
                                                    let _e2252 = local_4.member[3u];
                                                    let _e2258 = local_4.member_2[3u];
                                                    phi_4390_ = (((_e2246 + ((_e2249 - _e2252) * _e1880)) - _e2258) > _e2192);
                                                    phi_4391_ = false;
                                                } else {
                                                    phi_4390_ = bool();
                                                    phi_4391_ = true;
                                                }
                                                let _e2262 = phi_4390_;
                                                let _e2264 = phi_4391_;
                                                phi_4392_ = _e2262;
                                                phi_4393_ = _e2264;
                                            } else {
                                                phi_4392_ = bool();
                                                phi_4393_ = true;
                                            }
                                            let _e2266 = phi_4392_;
                                            let _e2268 = phi_4393_;
                                            phi_4394_ = _e2266;
                                            phi_4395_ = _e2268;
                                        } else {
                                            phi_4394_ = bool();
                                            phi_4395_ = true;
                                        }
                                        let _e2270 = phi_4394_;
                                        let _e2272 = phi_4395_;
                                        if select(_e2270, false, _e2272) {
                                            if (_e1880 <= _e1882) {
                                                phi_4710_ = true;
                                            } else {
                                                let _e2275 = f64(0f);
                                                let _e2278 = local_3.member[0u];
                                                let _e2281 = local_3.member_1[0u];
                                                let _e2284 = local_3.member[0u];
                                                let _e2290 = local_3.member_2[0u];
                                                let _e2294 = local_4.member[0u];
                                                let _e2297 = local_4.member_1[0u];
                                                let _e2300 = local_4.member[0u];
                                                let _e2306 = local_4.member_2[0u];
                                                if ((((_e2278 + ((_e2281 - _e2284) * _e1880)) - _e2290) + ((_e2294 + ((_e2297 - _e2300) * _e1886)) - _e2306)) > _e2275) {
                                                    let _e2312 = local_3.member[1u];
                                                    let _e2315 = local_3.member_1[1u];
                                                    let _e2318 = local_3.member[1u];
                                                    let _e2324 = local_3.member_2[1u];
                                                    let _e2328 = local_4.member[1u];
                                                    let _e2331 = local_4.member_1[1u];
                                                    let _e2334 = local_4.member[1u];
                                                    let _e2340 = local_4.member_2[1u];
                                                    if ((((_e2312 + ((_e2315 - _e2318) * _e1880)) - _e2324) + ((_e2328 + ((_e2331 - _e2334) * _e1886)) - _e2340)) > _e2275) {
                                                        let _e2346 = local_3.member[2u];
                                                        let _e2349 = local_3.member_1[2u];
                                                        let _e2352 = local_3.member[2u];
                                                        let _e2358 = local_3.member_2[2u];
                                                        let _e2362 = local_4.member[2u];
                                                        let _e2365 = local_4.member_1[2u];
                                                        let _e2368 = local_4.member[2u];
                                                        let _e2374 = local_4.member_2[2u];
                                                        if ((((_e2346 + ((_e2349 - _e2352) * _e1880)) - _e2358) + ((_e2362 + ((_e2365 - _e2368) * _e1886)) - _e2374)) > _e2275) {
                                                            let _e2380 = local_3.member[3u];
                                                            let _e2383 = local_3.member_1[3u];
                                                            let _e2386 = local_3.member[3u];
                                                            let _e2392 = local_3.member_2[3u];
                                                            let _e2396 = local_4.member[3u];
                                                            let _e2399 = local_4.member_1[3u];
                                                            let _e2402 = local_4.member[3u];
                                                            let _e2408 = local_4.member_2[3u];
                                                            phi_4697_ = ((((_e2380 + ((_e2383 - _e2386) * _e1880)) - _e2392) + ((_e2396 + ((_e2399 - _e2402) * _e1886)) - _e2408)) > _e2275);
                                                            phi_4698_ = false;
                                                        } else {
                                                            phi_4697_ = bool();
                                                            phi_4698_ = true;
                                                        }
                                                        let _e2413 = phi_4697_;
                                                        let _e2415 = phi_4698_;
                                                        phi_4699_ = _e2413;
                                                        phi_4700_ = _e2415;
                                                    } else {
                                                        phi_4699_ = bool();
                                                        phi_4700_ = true;
                                                    }
                                                    let _e2417 = phi_4699_;
                                                    let _e2419 = phi_4700_;
                                                    phi_4701_ = _e2417;
                                                    phi_4702_ = _e2419;
                                                } else {
                                                    phi_4701_ = bool();
                                                    phi_4702_ = true;
                                                }
                                                let _e2421 = phi_4701_;
                                                let _e2423 = phi_4702_;
                                                phi_4710_ = select(_e2421, false, _e2423);
                                            }
                                            let _e2426 = phi_4710_;
                                            if _e2426 {
                                                if select(true, select(true, false, (_e1880 >= _e551)), _e1888) {
                                                    local_3 = type_39(array<f64, 4>(_e2170.member[0], _e2170.member[1], _e2170.member[2], _e2170.member[3]), array<f64, 4>(_e2170.member_1[0], _e2170.member_1[1], _e2170.member_1[2], _e2170.member_1[3]), array<f64, 4>(_e2170.member_2[0], _e2170.member_2[1], _e2170.member_2[2], _e2170.member_2[3]));
                                                    let _e2451 = local_3.member[0u];
                                                    let _e2454 = local_3.member_1[0u];
                                                    let _e2457 = local_3.member_2[0u];
                                                    if select(true, select(true, false, (_e2454 > _e2457)), (_e2451 > _e2457)) {
                                                        let _e2462 = (_e2454 >= _e2451);
                                                        if _e2462 {
                                                            phi_4822_ = f64();
                                                            phi_4823_ = false;
                                                        } else {
                                                            if ((_e2451 - _e2454) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4820_ = (((_e2451 - _e2457) / (_e2451 - _e2454)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4821_ = false;
                                                            } else {
                                                                phi_4820_ = f64();
                                                                phi_4821_ = true;
                                                            }
                                                            let _e2476 = phi_4820_;
                                                            let _e2478 = phi_4821_;
                                                            phi_4822_ = _e2476;
                                                            phi_4823_ = _e2478;
                                                        }
                                                        let _e2480 = phi_4822_;
                                                        let _e2482 = phi_4823_;
                                                        phi_4824_ = _e2480;
                                                        phi_4825_ = _e2462;
                                                        phi_4826_ = _e2482;
                                                    } else {
                                                        phi_4824_ = f64();
                                                        phi_4825_ = true;
                                                        phi_4826_ = false;
                                                    }
                                                    let _e2484 = phi_4824_;
                                                    let _e2486 = phi_4825_;
                                                    let _e2488 = phi_4826_;
                                                    let _e2492 = select(_e2484, select(_e1880, f64(2f), _e2486), select(_e2488, true, _e2486));
                                                    let _e2495 = local_3.member[1u];
                                                    let _e2498 = local_3.member_1[1u];
                                                    let _e2501 = local_3.member_2[1u];
                                                    if select(true, select(true, false, (_e2498 > _e2501)), (_e2495 > _e2501)) {
                                                        let _e2506 = (_e2498 >= _e2495);
                                                        if _e2506 {
                                                            phi_4894_ = f64();
                                                            phi_4895_ = false;
                                                        } else {
                                                            if ((_e2495 - _e2498) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4892_ = (((_e2495 - _e2501) / (_e2495 - _e2498)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4893_ = false;
                                                            } else {
                                                                phi_4892_ = f64();
                                                                phi_4893_ = true;
                                                            }
                                                            let _e2520 = phi_4892_;
                                                            let _e2522 = phi_4893_;
                                                            phi_4894_ = _e2520;
                                                            phi_4895_ = _e2522;
                                                        }
                                                        let _e2524 = phi_4894_;
                                                        let _e2526 = phi_4895_;
                                                        phi_4896_ = _e2524;
                                                        phi_4897_ = _e2506;
                                                        phi_4898_ = _e2526;
                                                    } else {
                                                        phi_4896_ = f64();
                                                        phi_4897_ = true;
                                                        phi_4898_ = false;
                                                    }
                                                    let _e2528 = phi_4896_;
                                                    let _e2530 = phi_4897_;
                                                    let _e2532 = phi_4898_;
                                                    let _e2536 = select(_e2528, select(_e1880, f64(2f), _e2530), select(_e2532, true, _e2530));
                                                    let _e2538 = select(_e2536, _e2492, (_e2492 < _e2536));
                                                    let _e2541 = local_3.member[2u];
                                                    let _e2544 = local_3.member_1[2u];
                                                    let _e2547 = local_3.member_2[2u];
                                                    if select(true, select(true, false, (_e2544 > _e2547)), (_e2541 > _e2547)) {
                                                        let _e2552 = (_e2544 >= _e2541);
                                                        if _e2552 {
                                                            phi_4971_ = f64();
                                                            phi_4972_ = false;
                                                        } else {
                                                            if ((_e2541 - _e2544) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4969_ = (((_e2541 - _e2547) / (_e2541 - _e2544)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4970_ = false;
                                                            } else {
                                                                phi_4969_ = f64();
                                                                phi_4970_ = true;
                                                            }
                                                            let _e2566 = phi_4969_;
                                                            let _e2568 = phi_4970_;
                                                            phi_4971_ = _e2566;
                                                            phi_4972_ = _e2568;
                                                        }
                                                        let _e2570 = phi_4971_;
                                                        let _e2572 = phi_4972_;
                                                        phi_4973_ = _e2570;
                                                        phi_4974_ = _e2552;
                                                        phi_4975_ = _e2572;
                                                    } else {
                                                        phi_4973_ = f64();
                                                        phi_4974_ = true;
                                                        phi_4975_ = false;
                                                    }
                                                    let _e2574 = phi_4973_;
                                                    let _e2576 = phi_4974_;
                                                    let _e2578 = phi_4975_;
                                                    let _e2582 = select(_e2574, select(_e1880, f64(2f), _e2576), select(_e2578, true, _e2576));
                                                    let _e2585 = local_3.member[3u];
                                                    let _e2588 = local_3.member_1[3u];
                                                    let _e2591 = local_3.member_2[3u];
                                                    if select(true, select(true, false, (_e2588 > _e2591)), (_e2585 > _e2591)) {
                                                        let _e2596 = (_e2588 >= _e2585);
                                                        if _e2596 {
                                                            phi_5043_ = f64();
                                                            phi_5044_ = false;
                                                        } else {
                                                            if ((_e2585 - _e2588) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5041_ = (((_e2585 - _e2591) / (_e2585 - _e2588)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5042_ = false;
                                                            } else {
                                                                phi_5041_ = f64();
                                                                phi_5042_ = true;
                                                            }
                                                            let _e2610 = phi_5041_;
                                                            let _e2612 = phi_5042_;
                                                            phi_5043_ = _e2610;
                                                            phi_5044_ = _e2612;
                                                        }
                                                        let _e2614 = phi_5043_;
                                                        let _e2616 = phi_5044_;
                                                        phi_5045_ = _e2614;
                                                        phi_5046_ = _e2596;
                                                        phi_5047_ = _e2616;
                                                    } else {
                                                        phi_5045_ = f64();
                                                        phi_5046_ = true;
                                                        phi_5047_ = false;
                                                    }
                                                    let _e2618 = phi_5045_;
                                                    let _e2620 = phi_5046_;
                                                    let _e2622 = phi_5047_;
                                                    let _e2626 = select(_e2618, select(_e1880, f64(2f), _e2620), select(_e2622, true, _e2620));
                                                    let _e2628 = select(_e2626, _e2582, (_e2582 < _e2626));
                                                    let _e2630 = select(_e2628, _e2538, (_e2538 < _e2628));
                                                    let _e2632 = select(_e1880, _e2630, (_e2630 > _e1880));
                                                    let _e2633 = (_e2632 > _e551);
                                                    if _e2633 {
                                                        phi_5589_ = f64();
                                                        phi_5590_ = f64();
                                                        phi_5591_ = false;
                                                        phi_5592_ = false;
                                                    } else {
                                                        let _e2634 = (_e2632 - _e1880);
                                                        let _e2635 = (_e2634 <= _e1869);
                                                        let _e2638 = (_e2632 + (_e533 * f64(0.01f)));
                                                        let _e2640 = select(_e551, _e2638, (_e2638 < _e551));
                                                        if _e2635 {
                                                            if (_e905.member_1 > f64(0f)) {
                                                                let _e2645 = local_5.member[0u];
                                                                let _e2651 = local_5.member[1u];
                                                                let _e2667 = local_5.member_1[0u];
                                                                let _e2673 = local_5.member_1[1u];
                                                                let _e2689 = local_5.member_2[0u];
                                                                let _e2695 = local_5.member_2[1u];
                                                                let _e2709 = function_4(array<f64, 3>((_e2645[0] + ((_e2651[0] - _e2645[0]) * _e2640)), (_e2645[1] + ((_e2651[1] - _e2645[1]) * _e2640)), (_e2645[2] + ((_e2651[2] - _e2645[2]) * _e2640))), array<f64, 3>((_e2667[0] + ((_e2673[0] - _e2667[0]) * _e2640)), (_e2667[1] + ((_e2673[1] - _e2667[1]) * _e2640)), (_e2667[2] + ((_e2673[2] - _e2667[2]) * _e2640))), array<f64, 3>((_e2689[0] + ((_e2695[0] - _e2689[0]) * _e2640)), (_e2689[1] + ((_e2695[1] - _e2689[1]) * _e2640)), (_e2689[2] + ((_e2695[2] - _e2689[2]) * _e2640))), _e230.member);
                                                                let _e2720 = (((_e2709[0] * _e2709[0]) + (_e2709[1] * _e2709[1])) + (_e2709[2] * _e2709[2]));
                                                                if (_e2720 <= 2.2250738585072014e-308lf) {
                                                                    phi_5281_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2720 > 0.0lf));
                                                                } else {
                                                                    phi_5224_ = type_16(0i, 5i);
                                                                    phi_5227_ = bitcast<f64>(((bitcast<u64>(_e2720) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e2727 = phi_5224_;
                                                                        let _e2729 = phi_5227_;
                                                                        local_9 = _e2729;
                                                                        if (_e2727.member < _e2727.member_1) {
                                                                            let _e2736 = (_e2727.member + 1i);
                                                                            phi_5225_ = type_16(select(_e2736, type_17().member_1, select(false, true, ((false == (_e2736 > _e2727.member)) != false))), _e2727.member_1);
                                                                            phi_5268_ = type_17(1u, _e2727.member);
                                                                        } else {
                                                                            phi_5225_ = _e2727;
                                                                            phi_5268_ = type_17(0u, type_17().member_1);
                                                                        }
                                                                        let _e2747 = phi_5225_;
                                                                        let _e2749 = phi_5268_;
                                                                        let _e2752 = (bitcast<i32>(_e2749.member) != 0i);
                                                                        if _e2752 {
                                                                            phi_5228_ = (0.5lf * (_e2729 + (_e2720 / _e2729)));
                                                                        } else {
                                                                            phi_5228_ = f64();
                                                                        }
                                                                        let _e2757 = phi_5228_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_5224_ = _e2747;
                                                                            phi_5227_ = _e2757;
                                                                            break if !(_e2752);
                                                                        }
                                                                    }
                                                                    let _e2762 = local_9;
                                                                    phi_5281_ = (_e2762 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e2768 = phi_5281_;
                                                                let _e2776 = local_5.member[0u];
                                                                let _e2782 = select(_e2776[0], -(_e2776[0]), (_e2776[0] < 0.0lf));
                                                                let _e2785 = select(_e2776[1], -(_e2776[1]), (_e2776[1] < 0.0lf));
                                                                let _e2787 = select(_e2785, _e2782, (_e2782 > _e2785));
                                                                let _e2790 = select(_e2776[2], -(_e2776[2]), (_e2776[2] < 0.0lf));
                                                                let _e2792 = select(_e2790, _e2787, (_e2787 > _e2790));
                                                                let _e2795 = local_5.member[1u];
                                                                let _e2801 = select(_e2795[0], -(_e2795[0]), (_e2795[0] < 0.0lf));
                                                                let _e2804 = select(_e2795[1], -(_e2795[1]), (_e2795[1] < 0.0lf));
                                                                let _e2806 = select(_e2804, _e2801, (_e2801 > _e2804));
                                                                let _e2809 = select(_e2795[2], -(_e2795[2]), (_e2795[2] < 0.0lf));
                                                                let _e2811 = select(_e2809, _e2806, (_e2806 > _e2809));
                                                                let _e2815 = local_5.member_3;
                                                                let _e2819 = local_5.member_1[0u];
                                                                let _e2825 = select(_e2819[0], -(_e2819[0]), (_e2819[0] < 0.0lf));
                                                                let _e2828 = select(_e2819[1], -(_e2819[1]), (_e2819[1] < 0.0lf));
                                                                let _e2830 = select(_e2828, _e2825, (_e2825 > _e2828));
                                                                let _e2833 = select(_e2819[2], -(_e2819[2]), (_e2819[2] < 0.0lf));
                                                                let _e2835 = select(_e2833, _e2830, (_e2830 > _e2833));
                                                                let _e2838 = local_5.member_1[1u];
                                                                let _e2844 = select(_e2838[0], -(_e2838[0]), (_e2838[0] < 0.0lf));
                                                                let _e2847 = select(_e2838[1], -(_e2838[1]), (_e2838[1] < 0.0lf));
                                                                let _e2849 = select(_e2847, _e2844, (_e2844 > _e2847));
                                                                let _e2852 = select(_e2838[2], -(_e2838[2]), (_e2838[2] < 0.0lf));
                                                                let _e2854 = select(_e2852, _e2849, (_e2849 > _e2852));
                                                                let _e2858 = local_5.member_3;
                                                                let _e2862 = local_5.member_2[0u];
                                                                let _e2868 = select(_e2862[0], -(_e2862[0]), (_e2862[0] < 0.0lf));
                                                                let _e2871 = select(_e2862[1], -(_e2862[1]), (_e2862[1] < 0.0lf));
                                                                let _e2873 = select(_e2871, _e2868, (_e2868 > _e2871));
                                                                let _e2876 = select(_e2862[2], -(_e2862[2]), (_e2862[2] < 0.0lf));
                                                                let _e2878 = select(_e2876, _e2873, (_e2873 > _e2876));
                                                                let _e2881 = local_5.member_2[1u];
                                                                let _e2887 = select(_e2881[0], -(_e2881[0]), (_e2881[0] < 0.0lf));
                                                                let _e2890 = select(_e2881[1], -(_e2881[1]), (_e2881[1] < 0.0lf));
                                                                let _e2892 = select(_e2890, _e2887, (_e2887 > _e2890));
                                                                let _e2895 = select(_e2881[2], -(_e2881[2]), (_e2881[2] < 0.0lf));
                                                                let _e2897 = select(_e2895, _e2892, (_e2892 > _e2895));
                                                                let _e2901 = local_5.member_3;
                                                                let _e2909 = local_5.member_3;
                                                                phi_5558_ = select(true, false, (((_e2768 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e2811, _e2792, (_e2792 > _e2811)) + _e2815) + (select(_e2854, _e2835, (_e2835 > _e2854)) + _e2858)) + (select(_e2897, _e2878, (_e2878 > _e2897)) + _e2901)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2909 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e905.member_1));
                                                            } else {
                                                                phi_5558_ = true;
                                                            }
                                                            let _e2922 = phi_5558_;
                                                            phi_5559_ = _e2922;
                                                        } else {
                                                            phi_5559_ = true;
                                                        }
                                                        let _e2924 = phi_5559_;
                                                        if _e2924 {
                                                            if _e1888 {
                                                                let _e2928 = (_e2634 <= (_e1884 * f64(0.25f)));
                                                                phi_5586_ = select(select(select(f64(), f64(0f), _e2928), f64(), _e2635), (_e2190 + _e2190), select(select(true, false, _e2928), true, _e2635));
                                                            } else {
                                                                phi_5586_ = (_e551 - _e1880);
                                                            }
                                                            let _e2937 = phi_5586_;
                                                            phi_5587_ = _e2937;
                                                            phi_5588_ = false;
                                                        } else {
                                                            phi_5587_ = f64();
                                                            phi_5588_ = true;
                                                        }
                                                        let _e2939 = phi_5587_;
                                                        let _e2941 = phi_5588_;
                                                        phi_5589_ = _e2939;
                                                        phi_5590_ = _e2634;
                                                        phi_5591_ = _e2924;
                                                        phi_5592_ = _e2941;
                                                    }
                                                    let _e2943 = phi_5589_;
                                                    let _e2945 = phi_5590_;
                                                    let _e2947 = phi_5591_;
                                                    let _e2949 = phi_5592_;
                                                    phi_5593_ = _e2632;
                                                    phi_5594_ = _e2943;
                                                    phi_5595_ = _e2945;
                                                    phi_5596_ = _e2632;
                                                    phi_5597_ = _e2947;
                                                    phi_5598_ = _e2633;
                                                    phi_5599_ = _e2949;
                                                    phi_5600_ = false;
                                                } else {
                                                    phi_5593_ = f64();
                                                    phi_5594_ = f64();
                                                    phi_5595_ = f64();
                                                    phi_5596_ = f64();
                                                    phi_5597_ = false;
                                                    phi_5598_ = false;
                                                    phi_5599_ = false;
                                                    phi_5600_ = true;
                                                }
                                                let _e2951 = phi_5593_;
                                                let _e2953 = phi_5594_;
                                                let _e2955 = phi_5595_;
                                                let _e2957 = phi_5596_;
                                                let _e2959 = phi_5597_;
                                                let _e2961 = phi_5598_;
                                                let _e2963 = phi_5599_;
                                                let _e2965 = phi_5600_;
                                                phi_5601_ = _e2951;
                                                phi_5602_ = _e2953;
                                                phi_5603_ = _e2955;
                                                phi_5604_ = _e2957;
                                                phi_5605_ = false;
                                                phi_5606_ = _e2959;
                                                phi_5607_ = _e2961;
                                                phi_5608_ = _e2963;
                                                phi_5609_ = _e2965;
                                            } else {
                                                phi_5601_ = f64();
                                                phi_5602_ = f64();
                                                phi_5603_ = f64();
                                                phi_5604_ = f64();
                                                phi_5605_ = true;
                                                phi_5606_ = false;
                                                phi_5607_ = false;
                                                phi_5608_ = false;
                                                phi_5609_ = false;
                                            }
                                            let _e2967 = phi_5601_;
                                            let _e2969 = phi_5602_;
                                            let _e2971 = phi_5603_;
                                            let _e2973 = phi_5604_;
                                            let _e2975 = phi_5605_;
                                            let _e2977 = phi_5606_;
                                            let _e2979 = phi_5607_;
                                            let _e2981 = phi_5608_;
                                            let _e2983 = phi_5609_;
                                            phi_5610_ = _e2967;
                                            phi_5611_ = _e2969;
                                            phi_5612_ = _e2971;
                                            phi_5613_ = _e2973;
                                            phi_5614_ = _e2975;
                                            phi_5615_ = _e2977;
                                            phi_5616_ = _e2979;
                                            phi_5617_ = _e2981;
                                            phi_5618_ = _e2983;
                                        } else {
                                            phi_5610_ = f64();
                                            phi_5611_ = f64();
                                            phi_5612_ = f64();
                                            phi_5613_ = f64();
                                            phi_5614_ = true;
                                            phi_5615_ = false;
                                            phi_5616_ = false;
                                            phi_5617_ = false;
                                            phi_5618_ = false;
                                        }
                                        let _e2985 = phi_5610_;
                                        let _e2987 = phi_5611_;
                                        let _e2989 = phi_5612_;
                                        let _e2991 = phi_5613_;
                                        let _e2993 = phi_5614_;
                                        let _e2995 = phi_5615_;
                                        let _e2997 = phi_5616_;
                                        let _e2999 = phi_5617_;
                                        let _e3001 = phi_5618_;
                                        if _e2993 {
                                            if (_e1880 <= _e1882) {
                                                let _e3159 = (_e1890 + 1u);
                                                let _e3160 = (_e3159 > 3u);
                                                phi_5958_ = _e3159;
                                                phi_5959_ = f64();
                                                phi_5960_ = false;
                                                phi_5961_ = select(true, false, _e3160);
                                                phi_5962_ = _e3160;
                                            } else {
                                                let _e3005 = local_3.member[0u];
                                                let _e3008 = local_3.member_1[0u];
                                                let _e3011 = local_3.member[0u];
                                                let _e3017 = local_3.member_2[0u];
                                                let _e3018 = ((_e3005 + ((_e3008 - _e3011) * _e1886)) - _e3017);
                                                let _e3021 = local_3.member[1u];
                                                let _e3024 = local_3.member_1[1u];
                                                let _e3027 = local_3.member[1u];
                                                let _e3033 = local_3.member_2[1u];
                                                let _e3034 = ((_e3021 + ((_e3024 - _e3027) * _e1886)) - _e3033);
                                                let _e3036 = select(_e3034, _e3018, (_e3018 < _e3034));
                                                let _e3039 = local_3.member[2u];
                                                let _e3042 = local_3.member_1[2u];
                                                let _e3045 = local_3.member[2u];
                                                let _e3051 = local_3.member_2[2u];
                                                let _e3052 = ((_e3039 + ((_e3042 - _e3045) * _e1886)) - _e3051);
                                                let _e3055 = local_3.member[3u];
                                                let _e3058 = local_3.member_1[3u];
                                                let _e3061 = local_3.member[3u];
                                                let _e3067 = local_3.member_2[3u];
                                                let _e3068 = ((_e3055 + ((_e3058 - _e3061) * _e1886)) - _e3067);
                                                let _e3070 = select(_e3068, _e3052, (_e3052 < _e3068));
                                                let _e3072 = select(_e3070, _e3036, (_e3036 < _e3070));
                                                let _e3075 = local_4.member[0u];
                                                let _e3078 = local_4.member_1[0u];
                                                let _e3081 = local_4.member[0u];
                                                let _e3087 = local_4.member_2[0u];
                                                let _e3088 = ((_e3075 + ((_e3078 - _e3081) * _e1880)) - _e3087);
                                                let _e3091 = local_4.member[1u];
                                                let _e3094 = local_4.member_1[1u];
                                                let _e3097 = local_4.member[1u];
                                                let _e3103 = local_4.member_2[1u];
                                                let _e3104 = ((_e3091 + ((_e3094 - _e3097) * _e1880)) - _e3103);
                                                let _e3106 = select(_e3104, _e3088, (_e3088 < _e3104));
                                                let _e3109 = local_4.member[2u];
                                                let _e3112 = local_4.member_1[2u];
                                                let _e3115 = local_4.member[2u];
                                                let _e3121 = local_4.member_2[2u];
                                                let _e3122 = ((_e3109 + ((_e3112 - _e3115) * _e1880)) - _e3121);
                                                let _e3125 = local_4.member[3u];
                                                let _e3128 = local_4.member_1[3u];
                                                let _e3131 = local_4.member[3u];
                                                let _e3137 = local_4.member_2[3u];
                                                let _e3138 = ((_e3125 + ((_e3128 - _e3131) * _e1880)) - _e3137);
                                                let _e3140 = select(_e3138, _e3122, (_e3122 < _e3138));
                                                let _e3142 = select(_e3140, _e3106, (_e3106 < _e3140));
                                                let _e3143 = f64(0.0625f);
                                                let _e3145 = f64(0.9f);
                                                if (_e3142 > f64(0f)) {
                                                    phi_5956_ = f64(0.5f);
                                                } else {
                                                    let _e3151 = (f64(0.95f) * (_e3072 / (_e3072 - _e3142)));
                                                    phi_5956_ = select(_e3143, select(_e3145, _e3151, (_e3151 < _e3145)), (_e3151 > _e3143));
                                                }
                                                let _e3157 = phi_5956_;
                                                phi_5958_ = u32();
                                                phi_5959_ = (_e2190 * _e3157);
                                                phi_5960_ = true;
                                                phi_5961_ = false;
                                                phi_5962_ = false;
                                            }
                                            let _e3163 = phi_5958_;
                                            let _e3165 = phi_5959_;
                                            let _e3167 = phi_5960_;
                                            let _e3169 = phi_5961_;
                                            let _e3171 = phi_5962_;
                                            phi_5963_ = _e3163;
                                            phi_5964_ = _e1882;
                                            phi_5965_ = _e3165;
                                            phi_5966_ = _e1884;
                                            phi_5967_ = _e1886;
                                            phi_5968_ = _e1888;
                                            phi_5969_ = _e1890;
                                            phi_5970_ = _e3167;
                                            phi_5971_ = _e3169;
                                            phi_5972_ = _e3171;
                                            phi_5973_ = false;
                                            phi_5974_ = false;
                                            phi_5975_ = false;
                                        } else {
                                            phi_5963_ = u32();
                                            phi_5964_ = _e2985;
                                            phi_5965_ = _e2987;
                                            phi_5966_ = _e2989;
                                            phi_5967_ = _e1880;
                                            phi_5968_ = true;
                                            phi_5969_ = 0u;
                                            phi_5970_ = _e2995;
                                            phi_5971_ = false;
                                            phi_5972_ = false;
                                            phi_5973_ = _e2997;
                                            phi_5974_ = _e2999;
                                            phi_5975_ = _e3001;
                                        }
                                        let _e3173 = phi_5963_;
                                        let _e3175 = phi_5964_;
                                        let _e3177 = phi_5965_;
                                        let _e3179 = phi_5966_;
                                        let _e3181 = phi_5967_;
                                        let _e3183 = phi_5968_;
                                        let _e3185 = phi_5969_;
                                        let _e3187 = phi_5970_;
                                        let _e3189 = phi_5971_;
                                        let _e3191 = phi_5972_;
                                        let _e3193 = phi_5973_;
                                        let _e3195 = phi_5974_;
                                        let _e3197 = phi_5975_;
                                        if _e3187 {
                                            let _e3198 = (_e3181 + _e3177);
                                            let _e3200 = select(_e3175, _e3198, (_e3198 > _e3175));
                                            let _e3202 = select(_e551, _e3200, (_e3200 < _e551));
                                            let _e3205 = select(((_e3202 - _e3181) > _e1869), true, !(_e1888));
                                            phi_6003_ = _e3202;
                                            phi_6004_ = _e3175;
                                            phi_6005_ = _e3179;
                                            phi_6006_ = _e3181;
                                            phi_6007_ = _e3183;
                                            phi_6008_ = _e3185;
                                            phi_6009_ = _e3205;
                                            phi_6010_ = select(true, false, _e3205);
                                            phi_6011_ = false;
                                            phi_6012_ = false;
                                            phi_6013_ = false;
                                            phi_6014_ = false;
                                        } else {
                                            phi_6003_ = _e1880;
                                            phi_6004_ = _e1882;
                                            phi_6005_ = _e1884;
                                            phi_6006_ = _e1886;
                                            phi_6007_ = _e1888;
                                            phi_6008_ = _e3173;
                                            phi_6009_ = _e3189;
                                            phi_6010_ = false;
                                            phi_6011_ = _e3191;
                                            phi_6012_ = _e3193;
                                            phi_6013_ = _e3195;
                                            phi_6014_ = _e3197;
                                        }
                                        let _e3208 = phi_6003_;
                                        let _e3210 = phi_6004_;
                                        let _e3212 = phi_6005_;
                                        let _e3214 = phi_6006_;
                                        let _e3216 = phi_6007_;
                                        let _e3218 = phi_6008_;
                                        let _e3220 = phi_6009_;
                                        let _e3222 = phi_6010_;
                                        let _e3224 = phi_6011_;
                                        let _e3226 = phi_6012_;
                                        let _e3228 = phi_6013_;
                                        let _e3230 = phi_6014_;
                                        phi_3793_ = _e3208;
                                        phi_3795_ = _e3210;
                                        phi_3797_ = _e3212;
                                        phi_3799_ = _e3214;
                                        phi_3801_ = _e3216;
                                        phi_3803_ = _e3218;
                                        phi_6015_ = _e3175;
                                        phi_6016_ = _e2991;
                                        phi_6017_ = _e3220;
                                        phi_6018_ = _e3222;
                                        phi_6019_ = _e3224;
                                        phi_6020_ = _e3226;
                                        phi_6021_ = _e3228;
                                        phi_6022_ = false;
                                        phi_6023_ = _e3230;
                                    } else {
                                        phi_3793_ = f64();
                                        phi_3795_ = f64();
                                        phi_3797_ = f64();
                                        phi_3799_ = f64();
                                        phi_3801_ = bool();
                                        phi_3803_ = u32();
                                        phi_6015_ = f64();
                                        phi_6016_ = f64();
                                        phi_6017_ = false;
                                        phi_6018_ = false;
                                        phi_6019_ = false;
                                        phi_6020_ = false;
                                        phi_6021_ = false;
                                        phi_6022_ = true;
                                        phi_6023_ = false;
                                    }
                                    let _e3232 = phi_3793_;
                                    let _e3234 = phi_3795_;
                                    let _e3236 = phi_3797_;
                                    let _e3238 = phi_3799_;
                                    let _e3240 = phi_3801_;
                                    let _e3242 = phi_3803_;
                                    let _e3244 = phi_6015_;
                                    let _e3246 = phi_6016_;
                                    let _e3248 = phi_6017_;
                                    let _e3250 = phi_6018_;
                                    let _e3252 = phi_6019_;
                                    let _e3254 = phi_6020_;
                                    let _e3256 = phi_6021_;
                                    let _e3258 = phi_6022_;
                                    let _e3260 = phi_6023_;
                                    local_10 = _e3250;
                                    local_11 = _e3252;
                                    local_12 = _e3250;
                                    local_13 = _e3254;
                                    local_14 = _e3250;
                                    local_15 = _e3256;
                                    local_16 = _e3250;
                                    local_17 = _e3258;
                                    local_18 = _e3250;
                                    local_19 = _e3260;
                                    local_21 = _e3250;
                                    local_22 = _e3246;
                                    local_23 = _e3244;
                                    continue;
                                    continuing {
                                        phi_3789_ = type_9(select(_e1878.member, (_e1878.member + 1u), _e1893), select(_e1878.member_1, _e1878.member_1, _e1893));
                                        phi_3792_ = _e3232;
                                        phi_3794_ = _e3234;
                                        phi_3796_ = _e3236;
                                        phi_3798_ = _e3238;
                                        phi_3800_ = _e3240;
                                        phi_3802_ = _e3242;
                                        break if !(_e3248);
                                    }
                                }
                                let _e3263 = local_10;
                                let _e3265 = local_11;
                                let _e3266 = select(_e3265, false, _e3263);
                                let _e3268 = local_12;
                                let _e3270 = local_13;
                                let _e3273 = local_14;
                                let _e3275 = local_15;
                                let _e3278 = local_16;
                                let _e3280 = local_17;
                                let _e3283 = local_18;
                                let _e3285 = local_19;
                                let _e3291 = local_20;
                                let _e3293 = select(select(_e3270, false, _e3268), false, _e3266);
                                let _e3296 = local_21;
                                let _e3303 = select(select(select(_e3275, false, _e3273), false, _e3266), false, _e3293);
                                let _e3309 = local_22;
                                let _e3311 = local_23;
                                let _e3313 = select(select(select(_e3296, false, _e3266), false, _e3293), true, _e3303);
                                let _e3318 = local_24;
                                let _e3320 = select(select(select(select(select(_e3280, false, _e3278), false, _e3266), false, _e3293), false, _e3303), true, _e3313);
                                let _e3327 = select(select(select(select(select(select(_e3285, false, _e3283), false, _e3266), false, _e3293), false, _e3303), false, _e3313), false, _e3320);
                                let _e3332 = select(select(select(select(select(_e3266, true, _e3293), false, _e3303), false, _e3313), false, _e3320), true, _e3327);
                                phi_6090_ = select(select(type_37().member_1, select(_e3318, select(_e3311, _e3309, _e3303), _e3313), _e3320), select(select(select(type_37().member_1, _e3291, _e3266), type_37().member_1, _e3293), type_37().member_1, _e3327), _e3332);
                                phi_6091_ = (select(select(type_37().member, 1u, _e3320), select(select(select(type_37().member, 1u, _e3266), 0u, _e3293), 0u, _e3327), _e3332) != 0u);
                            } else {
                                phi_6090_ = _e1632;
                                phi_6091_ = true;
                            }
                            let _e3337 = phi_6090_;
                            let _e3339 = phi_6091_;
                            if _e3339 {
                                let _e3340 = (_e3337 > _e542);
                                if _e3340 {
                                    phi_8298_ = f64();
                                    phi_8299_ = u32();
                                    phi_8300_ = f64();
                                    phi_8301_ = type_42();
                                    phi_8302_ = u32();
                                    phi_8303_ = u32();
                                    phi_8304_ = false;
                                    phi_8305_ = false;
                                    phi_8306_ = false;
                                } else {
                                    let _e3344 = local_5.member[0u];
                                    let _e3350 = local_5.member[1u];
                                    let _e3366 = local_5.member_1[0u];
                                    let _e3372 = local_5.member_1[1u];
                                    let _e3388 = local_5.member_2[0u];
                                    let _e3394 = local_5.member_2[1u];
                                    let _e3408 = function_4(array<f64, 3>((_e3344[0] + ((_e3350[0] - _e3344[0]) * _e1636)), (_e3344[1] + ((_e3350[1] - _e3344[1]) * _e1636)), (_e3344[2] + ((_e3350[2] - _e3344[2]) * _e1636))), array<f64, 3>((_e3366[0] + ((_e3372[0] - _e3366[0]) * _e1636)), (_e3366[1] + ((_e3372[1] - _e3366[1]) * _e1636)), (_e3366[2] + ((_e3372[2] - _e3366[2]) * _e1636))), array<f64, 3>((_e3388[0] + ((_e3394[0] - _e3388[0]) * _e1636)), (_e3388[1] + ((_e3394[1] - _e3388[1]) * _e1636)), (_e3388[2] + ((_e3394[2] - _e3388[2]) * _e1636))), _e230.member);
                                    let _e3422 = ((select(_e3408[0], -(_e3408[0]), (_e3408[0] < 0.0lf)) + select(_e3408[1], -(_e3408[1]), (_e3408[1] < 0.0lf))) + select(_e3408[2], -(_e3408[2]), (_e3408[2] < 0.0lf)));
                                    let _e3425 = local_5.member[0u];
                                    let _e3431 = local_5.member_1[0u];
                                    let _e3437 = local_5.member_2[0u];
                                    let _e3441 = (_e3425[0] - _e3431[0]);
                                    let _e3442 = (_e3425[1] - _e3431[1]);
                                    let _e3443 = (_e3425[2] - _e3431[2]);
                                    let _e3444 = (_e230.member == 0u);
                                    let _e3456 = local_5.member[1u];
                                    let _e3462 = local_5.member_1[1u];
                                    let _e3468 = local_5.member_2[1u];
                                    let _e3472 = (_e3456[0] - _e3462[0]);
                                    let _e3473 = (_e3456[1] - _e3462[1]);
                                    let _e3474 = (_e3456[2] - _e3462[2]);
                                    let _e3475 = (_e230.member == 0u);
                                    let _e3487 = local_5.member[0u];
                                    let _e3493 = select(_e3487[0], -(_e3487[0]), (_e3487[0] < 0.0lf));
                                    let _e3496 = select(_e3487[1], -(_e3487[1]), (_e3487[1] < 0.0lf));
                                    let _e3498 = select(_e3496, _e3493, (_e3493 > _e3496));
                                    let _e3501 = select(_e3487[2], -(_e3487[2]), (_e3487[2] < 0.0lf));
                                    let _e3503 = select(_e3501, _e3498, (_e3498 > _e3501));
                                    let _e3506 = local_5.member[1u];
                                    let _e3512 = select(_e3506[0], -(_e3506[0]), (_e3506[0] < 0.0lf));
                                    let _e3515 = select(_e3506[1], -(_e3506[1]), (_e3506[1] < 0.0lf));
                                    let _e3517 = select(_e3515, _e3512, (_e3512 > _e3515));
                                    let _e3520 = select(_e3506[2], -(_e3506[2]), (_e3506[2] < 0.0lf));
                                    let _e3522 = select(_e3520, _e3517, (_e3517 > _e3520));
                                    let _e3526 = local_5.member_3;
                                    let _e3530 = local_5.member_1[0u];
                                    let _e3536 = select(_e3530[0], -(_e3530[0]), (_e3530[0] < 0.0lf));
                                    let _e3539 = select(_e3530[1], -(_e3530[1]), (_e3530[1] < 0.0lf));
                                    let _e3541 = select(_e3539, _e3536, (_e3536 > _e3539));
                                    let _e3544 = select(_e3530[2], -(_e3530[2]), (_e3530[2] < 0.0lf));
                                    let _e3546 = select(_e3544, _e3541, (_e3541 > _e3544));
                                    let _e3549 = local_5.member_1[1u];
                                    let _e3555 = select(_e3549[0], -(_e3549[0]), (_e3549[0] < 0.0lf));
                                    let _e3558 = select(_e3549[1], -(_e3549[1]), (_e3549[1] < 0.0lf));
                                    let _e3560 = select(_e3558, _e3555, (_e3555 > _e3558));
                                    let _e3563 = select(_e3549[2], -(_e3549[2]), (_e3549[2] < 0.0lf));
                                    let _e3565 = select(_e3563, _e3560, (_e3560 > _e3563));
                                    let _e3569 = local_5.member_3;
                                    let _e3573 = local_5.member_2[0u];
                                    let _e3579 = select(_e3573[0], -(_e3573[0]), (_e3573[0] < 0.0lf));
                                    let _e3582 = select(_e3573[1], -(_e3573[1]), (_e3573[1] < 0.0lf));
                                    let _e3584 = select(_e3582, _e3579, (_e3579 > _e3582));
                                    let _e3587 = select(_e3573[2], -(_e3573[2]), (_e3573[2] < 0.0lf));
                                    let _e3589 = select(_e3587, _e3584, (_e3584 > _e3587));
                                    let _e3592 = local_5.member_2[1u];
                                    let _e3598 = select(_e3592[0], -(_e3592[0]), (_e3592[0] < 0.0lf));
                                    let _e3601 = select(_e3592[1], -(_e3592[1]), (_e3592[1] < 0.0lf));
                                    let _e3603 = select(_e3601, _e3598, (_e3598 > _e3601));
                                    let _e3606 = select(_e3592[2], -(_e3592[2]), (_e3592[2] < 0.0lf));
                                    let _e3608 = select(_e3606, _e3603, (_e3603 > _e3606));
                                    let _e3612 = local_5.member_3;
                                    let _e3620 = local_5.member_3;
                                    local_1 = type_41(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e3425, array<f64, 3>(_e3441, _e3442, _e3443), array<f64, 3>((_e3425[0] - _e3437[0]), (_e3425[1] - _e3437[1]), (_e3425[2] - _e3437[2])), array<f64, 3>(select((_e3441 - _e3437[0]), _e3425[0], _e3444), select((_e3442 - _e3437[1]), _e3425[1], _e3444), select((_e3443 - _e3437[2]), _e3425[2], _e3444))), array<array<f64, 3>, 4>(_e3456, array<f64, 3>(_e3472, _e3473, _e3474), array<f64, 3>((_e3456[0] - _e3468[0]), (_e3456[1] - _e3468[1]), (_e3456[2] - _e3468[2])), array<f64, 3>(select((_e3472 - _e3468[0]), _e3456[0], _e3475), select((_e3473 - _e3468[1]), _e3456[1], _e3475), select((_e3474 - _e3468[2]), _e3456[2], _e3475)))), ((((((select(_e3522, _e3503, (_e3503 > _e3522)) + _e3526) + (select(_e3565, _e3546, (_e3546 > _e3565)) + _e3569)) + (select(_e3608, _e3589, (_e3589 > _e3608)) + _e3612)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3620 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e905.member_1);
                                    let _e3638 = local_1.member_1;
                                    if (_e3422 > _e3638) {
                                        if ((bitcast<u64>(_e3422) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e3644 = (f64(1f) / _e3422);
                                            let _e3646 = (_e3408[0] * _e3644);
                                            let _e3648 = (_e3408[1] * _e3644);
                                            let _e3650 = (_e3408[2] * _e3644);
                                            let _e3655 = (((_e3646 * _e3646) + (_e3648 * _e3648)) + (_e3650 * _e3650));
                                            if (_e3655 <= 2.2250738585072014e-308lf) {
                                                phi_6773_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3655 > 0.0lf));
                                            } else {
                                                phi_6716_ = type_16(0i, 5i);
                                                phi_6719_ = bitcast<f64>(((bitcast<u64>(_e3655) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3662 = phi_6716_;
                                                    let _e3664 = phi_6719_;
                                                    local_25 = _e3664;
                                                    if (_e3662.member < _e3662.member_1) {
                                                        let _e3671 = (_e3662.member + 1i);
                                                        phi_6717_ = type_16(select(_e3671, type_17().member_1, select(false, true, ((false == (_e3671 > _e3662.member)) != false))), _e3662.member_1);
                                                        phi_6760_ = type_17(1u, _e3662.member);
                                                    } else {
                                                        phi_6717_ = _e3662;
                                                        phi_6760_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3682 = phi_6717_;
                                                    let _e3684 = phi_6760_;
                                                    let _e3687 = (bitcast<i32>(_e3684.member) != 0i);
                                                    if _e3687 {
                                                        phi_6720_ = (0.5lf * (_e3664 + (_e3655 / _e3664)));
                                                    } else {
                                                        phi_6720_ = f64();
                                                    }
                                                    let _e3692 = phi_6720_;
                                                    continue;
                                                    continuing {
                                                        phi_6716_ = _e3682;
                                                        phi_6719_ = _e3692;
                                                        break if !(_e3687);
                                                    }
                                                }
                                                let _e3697 = local_25;
                                                phi_6773_ = (_e3697 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3703 = phi_6773_;
                                            let _e3705 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e3707 = local_1.member_1;
                                            let _e3711 = local_1.member_2;
                                            let _e3716 = ((_e3707 * f64(1.01f)) + ((_e3711 * _e3703) * (f64(1f) + _e3705)));
                                            let _e3720 = local_1.member[0u][0u];
                                            let _e3728 = (((_e3646 * _e3720[0]) + (_e3648 * _e3720[1])) + (_e3650 * _e3720[2]));
                                            let _e3732 = local_1.member[0u][1u];
                                            let _e3740 = (((_e3646 * _e3732[0]) + (_e3648 * _e3732[1])) + (_e3650 * _e3732[2]));
                                            let _e3744 = local_1.member[0u][2u];
                                            let _e3752 = (((_e3646 * _e3744[0]) + (_e3648 * _e3744[1])) + (_e3650 * _e3744[2]));
                                            let _e3756 = local_1.member[0u][3u];
                                            let _e3764 = (((_e3646 * _e3756[0]) + (_e3648 * _e3756[1])) + (_e3650 * _e3756[2]));
                                            let _e3768 = local_1.member[1u][0u];
                                            let _e3776 = (((_e3646 * _e3768[0]) + (_e3648 * _e3768[1])) + (_e3650 * _e3768[2]));
                                            let _e3780 = local_1.member[1u][1u];
                                            let _e3788 = (((_e3646 * _e3780[0]) + (_e3648 * _e3780[1])) + (_e3650 * _e3780[2]));
                                            let _e3792 = local_1.member[1u][2u];
                                            let _e3800 = (((_e3646 * _e3792[0]) + (_e3648 * _e3792[1])) + (_e3650 * _e3792[2]));
                                            let _e3804 = local_1.member[1u][3u];
                                            let _e3812 = (((_e3646 * _e3804[0]) + (_e3648 * _e3804[1])) + (_e3650 * _e3804[2]));
                                            local_2 = type_39(array<f64, 4>(_e3728, _e3740, _e3752, _e3764), array<f64, 4>(_e3776, _e3788, _e3800, _e3812), array<f64, 4>((_e3716 + ((select(_e3728, -(_e3728), (_e3728 < 0.0lf)) + select(_e3776, -(_e3776), (_e3776 < 0.0lf))) * _e3705)), (_e3716 + ((select(_e3740, -(_e3740), (_e3740 < 0.0lf)) + select(_e3788, -(_e3788), (_e3788 < 0.0lf))) * _e3705)), (_e3716 + ((select(_e3752, -(_e3752), (_e3752 < 0.0lf)) + select(_e3800, -(_e3800), (_e3800 < 0.0lf))) * _e3705)), (_e3716 + ((select(_e3764, -(_e3764), (_e3764 < 0.0lf)) + select(_e3812, -(_e3812), (_e3812 < 0.0lf))) * _e3705))));
                                            let _e3857 = (((_e3646 * _e3646) + (_e3648 * _e3648)) + (_e3650 * _e3650));
                                            if (_e3857 <= 2.2250738585072014e-308lf) {
                                                phi_7068_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3857 > 0.0lf));
                                            } else {
                                                phi_7011_ = type_16(0i, 5i);
                                                phi_7014_ = bitcast<f64>(((bitcast<u64>(_e3857) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3864 = phi_7011_;
                                                    let _e3866 = phi_7014_;
                                                    local_26 = _e3866;
                                                    if (_e3864.member < _e3864.member_1) {
                                                        let _e3873 = (_e3864.member + 1i);
                                                        phi_7012_ = type_16(select(_e3873, type_17().member_1, select(false, true, ((false == (_e3873 > _e3864.member)) != false))), _e3864.member_1);
                                                        phi_7055_ = type_17(1u, _e3864.member);
                                                    } else {
                                                        phi_7012_ = _e3864;
                                                        phi_7055_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3884 = phi_7012_;
                                                    let _e3886 = phi_7055_;
                                                    let _e3889 = (bitcast<i32>(_e3886.member) != 0i);
                                                    if _e3889 {
                                                        phi_7015_ = (0.5lf * (_e3866 + (_e3857 / _e3866)));
                                                    } else {
                                                        phi_7015_ = f64();
                                                    }
                                                    let _e3894 = phi_7015_;
                                                    continue;
                                                    continuing {
                                                        phi_7011_ = _e3884;
                                                        phi_7014_ = _e3894;
                                                        break if !(_e3889);
                                                    }
                                                }
                                                let _e3899 = local_26;
                                                phi_7068_ = (_e3899 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3905 = phi_7068_;
                                            let _e3916 = (((_e3408[0] * _e3408[0]) + (_e3408[1] * _e3408[1])) + (_e3408[2] * _e3408[2]));
                                            if (_e3916 <= 2.2250738585072014e-308lf) {
                                                phi_7157_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3916 > 0.0lf));
                                            } else {
                                                phi_7100_ = type_16(0i, 5i);
                                                phi_7103_ = bitcast<f64>(((bitcast<u64>(_e3916) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3923 = phi_7100_;
                                                    let _e3925 = phi_7103_;
                                                    local_27 = _e3925;
                                                    if (_e3923.member < _e3923.member_1) {
                                                        let _e3932 = (_e3923.member + 1i);
                                                        phi_7101_ = type_16(select(_e3932, type_17().member_1, select(false, true, ((false == (_e3932 > _e3923.member)) != false))), _e3923.member_1);
                                                        phi_7144_ = type_17(1u, _e3923.member);
                                                    } else {
                                                        phi_7101_ = _e3923;
                                                        phi_7144_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e3943 = phi_7101_;
                                                    let _e3945 = phi_7144_;
                                                    let _e3948 = (bitcast<i32>(_e3945.member) != 0i);
                                                    if _e3948 {
                                                        phi_7104_ = (0.5lf * (_e3925 + (_e3916 / _e3925)));
                                                    } else {
                                                        phi_7104_ = f64();
                                                    }
                                                    let _e3953 = phi_7104_;
                                                    continue;
                                                    continuing {
                                                        phi_7100_ = _e3943;
                                                        phi_7103_ = _e3953;
                                                        break if !(_e3948);
                                                    }
                                                }
                                                let _e3958 = local_27;
                                                phi_7157_ = (_e3958 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3964 = phi_7157_;
                                            let _e3972 = local_5.member[0u];
                                            let _e3978 = select(_e3972[0], -(_e3972[0]), (_e3972[0] < 0.0lf));
                                            let _e3981 = select(_e3972[1], -(_e3972[1]), (_e3972[1] < 0.0lf));
                                            let _e3983 = select(_e3981, _e3978, (_e3978 > _e3981));
                                            let _e3986 = select(_e3972[2], -(_e3972[2]), (_e3972[2] < 0.0lf));
                                            let _e3988 = select(_e3986, _e3983, (_e3983 > _e3986));
                                            let _e3991 = local_5.member[1u];
                                            let _e3997 = select(_e3991[0], -(_e3991[0]), (_e3991[0] < 0.0lf));
                                            let _e4000 = select(_e3991[1], -(_e3991[1]), (_e3991[1] < 0.0lf));
                                            let _e4002 = select(_e4000, _e3997, (_e3997 > _e4000));
                                            let _e4005 = select(_e3991[2], -(_e3991[2]), (_e3991[2] < 0.0lf));
                                            let _e4007 = select(_e4005, _e4002, (_e4002 > _e4005));
                                            let _e4011 = local_5.member_3;
                                            let _e4015 = local_5.member_1[0u];
                                            let _e4021 = select(_e4015[0], -(_e4015[0]), (_e4015[0] < 0.0lf));
                                            let _e4024 = select(_e4015[1], -(_e4015[1]), (_e4015[1] < 0.0lf));
                                            let _e4026 = select(_e4024, _e4021, (_e4021 > _e4024));
                                            let _e4029 = select(_e4015[2], -(_e4015[2]), (_e4015[2] < 0.0lf));
                                            let _e4031 = select(_e4029, _e4026, (_e4026 > _e4029));
                                            let _e4034 = local_5.member_1[1u];
                                            let _e4040 = select(_e4034[0], -(_e4034[0]), (_e4034[0] < 0.0lf));
                                            let _e4043 = select(_e4034[1], -(_e4034[1]), (_e4034[1] < 0.0lf));
                                            let _e4045 = select(_e4043, _e4040, (_e4040 > _e4043));
                                            let _e4048 = select(_e4034[2], -(_e4034[2]), (_e4034[2] < 0.0lf));
                                            let _e4050 = select(_e4048, _e4045, (_e4045 > _e4048));
                                            let _e4054 = local_5.member_3;
                                            let _e4058 = local_5.member_2[0u];
                                            let _e4064 = select(_e4058[0], -(_e4058[0]), (_e4058[0] < 0.0lf));
                                            let _e4067 = select(_e4058[1], -(_e4058[1]), (_e4058[1] < 0.0lf));
                                            let _e4069 = select(_e4067, _e4064, (_e4064 > _e4067));
                                            let _e4072 = select(_e4058[2], -(_e4058[2]), (_e4058[2] < 0.0lf));
                                            let _e4074 = select(_e4072, _e4069, (_e4069 > _e4072));
                                            let _e4077 = local_5.member_2[1u];
                                            let _e4083 = select(_e4077[0], -(_e4077[0]), (_e4077[0] < 0.0lf));
                                            let _e4086 = select(_e4077[1], -(_e4077[1]), (_e4077[1] < 0.0lf));
                                            let _e4088 = select(_e4086, _e4083, (_e4083 > _e4086));
                                            let _e4091 = select(_e4077[2], -(_e4077[2]), (_e4077[2] < 0.0lf));
                                            let _e4093 = select(_e4091, _e4088, (_e4088 > _e4091));
                                            let _e4097 = local_5.member_3;
                                            let _e4105 = local_5.member_3;
                                            let _e4120 = ((((_e3964 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e4007, _e3988, (_e3988 > _e4007)) + _e4011) + (select(_e4050, _e4031, (_e4031 > _e4050)) + _e4054)) + (select(_e4093, _e4074, (_e4074 > _e4093)) + _e4097)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4105 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e3905) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                            let _e4123 = local_2.member[0u];
                                            let _e4126 = local_2.member_1[0u];
                                            phi_7475_ = type_9(1u, 4u);
                                            phi_7478_ = ((_e4123 + ((_e4126 - _e4123) * _e1636)) - ((_e3638 * f64(1.01f)) + ((select(_e4123, -(_e4123), (_e4123 < 0.0lf)) + select(_e4126, -(_e4126), (_e4126 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f)))));
                                            loop {
                                                let _e4145 = phi_7475_;
                                                let _e4147 = phi_7478_;
                                                local_28 = _e4147;
                                                local_29 = _e4147;
                                                let _e4150 = (_e4145.member < _e4145.member_1);
                                                let _e4161 = select(type_9().member_1, _e4145.member, _e4150);
                                                let _e4163 = (bitcast<i32>(select(0u, 1u, _e4150)) != 0i);
                                                if _e4163 {
                                                    let _e4166 = local_2.member[_e4161];
                                                    let _e4169 = local_2.member_1[_e4161];
                                                    let _e4186 = ((_e4166 + ((_e4169 - _e4166) * _e1636)) - ((_e3638 * f64(1.01f)) + ((select(_e4166, -(_e4166), (_e4166 < 0.0lf)) + select(_e4169, -(_e4169), (_e4169 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f)))));
                                                    phi_7479_ = select(_e4186, _e4147, (_e4147 < _e4186));
                                                } else {
                                                    phi_7479_ = f64();
                                                }
                                                let _e4190 = phi_7479_;
                                                continue;
                                                continuing {
                                                    phi_7475_ = type_9(select(_e4145.member, (_e4145.member + 1u), _e4150), select(_e4145.member_1, _e4145.member_1, _e4150));
                                                    phi_7478_ = _e4190;
                                                    break if !(_e4163);
                                                }
                                            }
                                            let _e4193 = local_28;
                                            if (_e4193 > f64(0f)) {
                                                let _e4198 = local_29;
                                                let _e4202 = (((_e4120 - _e4198) / _e4120) * f64(2.02f));
                                                if (_e4202 <= 2.2250738585072014e-308lf) {
                                                    phi_7637_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e4202 > 0.0lf));
                                                } else {
                                                    phi_7580_ = type_16(0i, 5i);
                                                    phi_7583_ = bitcast<f64>(((bitcast<u64>(_e4202) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e4209 = phi_7580_;
                                                        let _e4211 = phi_7583_;
                                                        local_30 = _e4211;
                                                        if (_e4209.member < _e4209.member_1) {
                                                            let _e4218 = (_e4209.member + 1i);
                                                            phi_7581_ = type_16(select(_e4218, type_17().member_1, select(false, true, ((false == (_e4218 > _e4209.member)) != false))), _e4209.member_1);
                                                            phi_7624_ = type_17(1u, _e4209.member);
                                                        } else {
                                                            phi_7581_ = _e4209;
                                                            phi_7624_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e4229 = phi_7581_;
                                                        let _e4231 = phi_7624_;
                                                        let _e4234 = (bitcast<i32>(_e4231.member) != 0i);
                                                        if _e4234 {
                                                            phi_7584_ = (0.5lf * (_e4211 + (_e4202 / _e4211)));
                                                        } else {
                                                            phi_7584_ = f64();
                                                        }
                                                        let _e4239 = phi_7584_;
                                                        continue;
                                                        continuing {
                                                            phi_7580_ = _e4229;
                                                            phi_7583_ = _e4239;
                                                            break if !(_e4234);
                                                        }
                                                    }
                                                    let _e4244 = local_30;
                                                    phi_7637_ = (_e4244 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e4250 = phi_7637_;
                                                let _e4253 = ((_e4250 * _e3905) * f64(1.01f));
                                                phi_7644_ = type_9(0u, 4u);
                                                phi_7647_ = f64(2f);
                                                phi_7649_ = true;
                                                phi_7651_ = true;
                                                loop {
                                                    let _e4256 = phi_7644_;
                                                    let _e4258 = phi_7647_;
                                                    let _e4260 = phi_7649_;
                                                    let _e4262 = phi_7651_;
                                                    local_31 = _e4258;
                                                    local_32 = _e4258;
                                                    local_33 = _e4260;
                                                    local_34 = _e4262;
                                                    local_35 = _e4262;
                                                    local_36 = _e4262;
                                                    local_61 = _e4262;
                                                    local_37 = _e4262;
                                                    let _e4265 = (_e4256.member < _e4256.member_1);
                                                    let _e4276 = select(type_9().member_1, _e4256.member, _e4265);
                                                    let _e4278 = (bitcast<i32>(select(0u, 1u, _e4265)) != 0i);
                                                    if _e4278 {
                                                        let _e4282 = local_1.member[0u][_e4276];
                                                        let _e4289 = local_1.member[1u][_e4276];
                                                        let _e4303 = ((select(_e4282[0], -(_e4282[0]), (_e4282[0] < 0.0lf)) + select(_e4282[1], -(_e4282[1]), (_e4282[1] < 0.0lf))) + select(_e4282[2], -(_e4282[2]), (_e4282[2] < 0.0lf)));
                                                        let _e4314 = ((select(_e4289[0], -(_e4289[0]), (_e4289[0] < 0.0lf)) + select(_e4289[1], -(_e4289[1]), (_e4289[1] < 0.0lf))) + select(_e4289[2], -(_e4289[2]), (_e4289[2] < 0.0lf)));
                                                        let _e4322 = (_e4289[0] - _e4282[0]);
                                                        let _e4323 = (_e4289[1] - _e4282[1]);
                                                        let _e4324 = (_e4289[2] - _e4282[2]);
                                                        let _e4343 = local_2.member[_e4276];
                                                        let _e4346 = local_2.member_1[_e4276];
                                                        let _e4359 = ((_e3638 * f64(1.01f)) + ((select(_e4343, -(_e4343), (_e4343 < 0.0lf)) + select(_e4346, -(_e4346), (_e4346 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f))));
                                                        let _e4366 = local_2.member_1[_e4276];
                                                        let _e4369 = local_2.member[_e4276];
                                                        let _e4370 = (_e4366 - _e4369);
                                                        let _e4373 = ((_e4359 + _e4359) + (_e4253 * ((((select(_e4322, -(_e4322), (_e4322 < 0.0lf)) + select(_e4323, -(_e4323), (_e4323 < 0.0lf))) + select(_e4324, -(_e4324), (_e4324 < 0.0lf))) + (_e3638 * f64(6f))) * f64(1.01f))));
                                                        let _e4376 = ((((_e4343 + ((_e4346 - _e4343) * _e1636)) - _e4359) - (_e4253 * ((select(_e4314, _e4303, (_e4303 > _e4314)) + (_e3638 * f64(3f))) * f64(1.01f)))) - _e4120);
                                                        let _e4377 = (_e4376 > 2.2250738585072014e-308lf);
                                                        let _e4378 = (_e4370 > _e4373);
                                                        if _e4378 {
                                                            phi_7888_ = _e4258;
                                                        } else {
                                                            if _e4377 {
                                                                let _e4385 = (_e4373 - _e4370);
                                                                let _e4388 = (_e4376 / select(2.2250738585072014e-308lf, _e4385, (_e4385 > 2.2250738585072014e-308lf)));
                                                                phi_7887_ = select(_e4388, _e4258, (_e4258 < _e4388));
                                                            } else {
                                                                phi_7887_ = _e4258;
                                                            }
                                                            let _e4392 = phi_7887_;
                                                            phi_7888_ = _e4392;
                                                        }
                                                        let _e4394 = phi_7888_;
                                                        phi_7648_ = _e4394;
                                                        phi_7650_ = (_e4260 && select(_e4377, true, (_e4370 < -(_e4373))));
                                                        phi_7652_ = (_e4262 && select(_e4377, true, _e4378));
                                                    } else {
                                                        phi_7648_ = f64();
                                                        phi_7650_ = bool();
                                                        phi_7652_ = bool();
                                                    }
                                                    let _e4396 = phi_7648_;
                                                    let _e4398 = phi_7650_;
                                                    let _e4400 = phi_7652_;
                                                    continue;
                                                    continuing {
                                                        phi_7644_ = type_9(select(_e4256.member, (_e4256.member + 1u), _e4265), select(_e4256.member_1, _e4256.member_1, _e4265));
                                                        phi_7647_ = _e4396;
                                                        phi_7649_ = _e4398;
                                                        phi_7651_ = _e4400;
                                                        break if !(_e4278);
                                                    }
                                                }
                                                let _e4402 = f64(2f);
                                                let _e4404 = local_31;
                                                let _e4407 = local_32;
                                                let _e4410 = (select(_e4402, _e4407, (_e4404 < _e4402)) * f64(0.999f));
                                                let _e4412 = local_33;
                                                if _e4412 {
                                                    let _e4416 = local_34;
                                                    let _e4420 = local_35;
                                                    let _e4424 = local_36;
                                                    phi_7906_ = type_42(select(_e1636, type_42().member, _e4416), select(f64(2f), type_42().member_1, _e4420), select(1u, type_42().member_2, _e4424));
                                                    let _e5535 = local_61;
                                                    phi_7907_ = _e5535;
                                                } else {
                                                    phi_7906_ = type_42();
                                                    phi_7907_ = true;
                                                }
                                                let _e4428 = phi_7906_;
                                                let _e4430 = phi_7907_;
                                                if _e4430 {
                                                    let _e4432 = local_37;
                                                    if _e4432 {
                                                        let _e4438 = (_e1636 + _e4410);
                                                        let _e4441 = select(_e1636, select(_e551, _e4438, (_e4438 < _e551)), (_e4410 > (1.1102230246251565e-16lf * f64(4096f))));
                                                        phi_7929_ = type_9(0u, 4u);
                                                        phi_7932_ = _e4441;
                                                        phi_7934_ = _e1636;
                                                        loop {
                                                            let _e4443 = phi_7929_;
                                                            let _e4445 = phi_7932_;
                                                            let _e4447 = phi_7934_;
                                                            local_38 = _e4445;
                                                            local_39 = _e4447;
                                                            local_40 = _e4447;
                                                            let _e4450 = (_e4443.member < _e4443.member_1);
                                                            let _e4461 = select(type_9().member_1, _e4443.member, _e4450);
                                                            let _e4463 = (bitcast<i32>(select(0u, 1u, _e4450)) != 0i);
                                                            if _e4463 {
                                                                let _e4466 = local_2.member[_e4461];
                                                                let _e4469 = local_2.member_1[_e4461];
                                                                let _e4472 = local_2.member[_e4461];
                                                                let _e4478 = local_2.member_2[_e4461];
                                                                let _e4479 = ((_e4466 + ((_e4469 - _e4472) * _e1636)) - _e4478);
                                                                let _e4482 = local_2.member_1[_e4461];
                                                                let _e4485 = local_2.member[_e4461];
                                                                let _e4486 = (_e4482 - _e4485);
                                                                if (_e4486 > f64(0f)) {
                                                                    let _e4502 = (_e1636 - (_e4479 / _e4486));
                                                                    phi_8046_ = _e4445;
                                                                    phi_8047_ = select(_e4502, _e4447, (_e4447 > _e4502));
                                                                } else {
                                                                    if (_e4479 > f64(0f)) {
                                                                        if (_e4486 < f64(0f)) {
                                                                            let _e4494 = (_e1636 - (_e4479 / _e4486));
                                                                            phi_8044_ = select(_e4494, _e4445, (_e4445 < _e4494));
                                                                        } else {
                                                                            phi_8044_ = _e4445;
                                                                        }
                                                                        let _e4498 = phi_8044_;
                                                                        phi_8045_ = _e4498;
                                                                    } else {
                                                                        phi_8045_ = _e4445;
                                                                    }
                                                                    let _e4500 = phi_8045_;
                                                                    phi_8046_ = _e4500;
                                                                    phi_8047_ = _e4447;
                                                                }
                                                                let _e4506 = phi_8046_;
                                                                let _e4508 = phi_8047_;
                                                                phi_7933_ = _e4506;
                                                                phi_7935_ = _e4508;
                                                            } else {
                                                                phi_7933_ = f64();
                                                                phi_7935_ = f64();
                                                            }
                                                            let _e4510 = phi_7933_;
                                                            let _e4512 = phi_7935_;
                                                            continue;
                                                            continuing {
                                                                phi_7929_ = type_9(select(_e4443.member, (_e4443.member + 1u), _e4450), select(_e4443.member_1, _e4443.member_1, _e4450));
                                                                phi_7932_ = _e4510;
                                                                phi_7934_ = _e4512;
                                                                break if !(_e4463);
                                                            }
                                                        }
                                                        let _e4515 = local_38;
                                                        let _e4517 = local_39;
                                                        let _e4522 = local_40;
                                                        let _e4523 = (_e4522 + ((_e4515 - _e4517) * f64(0.5f)));
                                                        if (_e4523 > _e1636) {
                                                            if (_e4523 <= _e4441) {
                                                                let _e4526 = f64(0f);
                                                                let _e4529 = local_2.member[0u];
                                                                let _e4532 = local_2.member_1[0u];
                                                                let _e4535 = local_2.member[0u];
                                                                let _e4541 = local_2.member_2[0u];
                                                                if (((_e4529 + ((_e4532 - _e4535) * _e4523)) - _e4541) > _e4526) {
                                                                    let _e4546 = local_2.member[1u];
                                                                    let _e4549 = local_2.member_1[1u];
                                                                    let _e4552 = local_2.member[1u];
                                                                    let _e4558 = local_2.member_2[1u];
                                                                    if (((_e4546 + ((_e4549 - _e4552) * _e4523)) - _e4558) > _e4526) {
                                                                        let _e4563 = local_2.member[2u];
                                                                        let _e4566 = local_2.member_1[2u];
                                                                        let _e4569 = local_2.member[2u];
                                                                        let _e4575 = local_2.member_2[2u];
                                                                        if (((_e4563 + ((_e4566 - _e4569) * _e4523)) - _e4575) > _e4526) {
                                                                            let _e4580 = local_2.member[3u];
                                                                            let _e4583 = local_2.member_1[3u];
                                                                            let _e4586 = local_2.member[3u];
                                                                            let _e4592 = local_2.member_2[3u];
                                                                            phi_8210_ = (((_e4580 + ((_e4583 - _e4586) * _e4523)) - _e4592) > _e4526);
                                                                            phi_8211_ = false;
                                                                        } else {
                                                                            phi_8210_ = bool();
                                                                            phi_8211_ = true;
                                                                        }
                                                                        let _e4596 = phi_8210_;
                                                                        let _e4598 = phi_8211_;
                                                                        phi_8212_ = _e4596;
                                                                        phi_8213_ = _e4598;
                                                                    } else {
                                                                        phi_8212_ = bool();
                                                                        phi_8213_ = true;
                                                                    }
                                                                    let _e4600 = phi_8212_;
                                                                    let _e4602 = phi_8213_;
                                                                    phi_8214_ = _e4600;
                                                                    phi_8215_ = _e4602;
                                                                } else {
                                                                    phi_8214_ = bool();
                                                                    phi_8215_ = true;
                                                                }
                                                                let _e4604 = phi_8214_;
                                                                let _e4606 = phi_8215_;
                                                                phi_8224_ = select(true, false, select(_e4604, false, _e4606));
                                                            } else {
                                                                phi_8224_ = true;
                                                            }
                                                            let _e4610 = phi_8224_;
                                                            phi_8225_ = _e4610;
                                                        } else {
                                                            phi_8225_ = true;
                                                        }
                                                        let _e4612 = phi_8225_;
                                                        phi_8234_ = type_42(_e4441, select(_e4523, f64(2f), _e4612), 2u);
                                                        phi_8235_ = type_42();
                                                        phi_8236_ = false;
                                                    } else {
                                                        phi_8234_ = type_42();
                                                        phi_8235_ = type_42(_e1636, f64(2f), 0u);
                                                        phi_8236_ = true;
                                                    }
                                                    let _e4617 = phi_8234_;
                                                    let _e4619 = phi_8235_;
                                                    let _e4621 = phi_8236_;
                                                    phi_8237_ = _e4617;
                                                    phi_8238_ = _e4619;
                                                    phi_8239_ = _e4621;
                                                } else {
                                                    phi_8237_ = type_42();
                                                    phi_8238_ = _e4428;
                                                    phi_8239_ = true;
                                                }
                                                let _e4623 = phi_8237_;
                                                let _e4625 = phi_8238_;
                                                let _e4627 = phi_8239_;
                                                phi_8245_ = _e4625;
                                                phi_8246_ = _e4623;
                                                phi_8247_ = _e4627;
                                            } else {
                                                phi_8245_ = type_42(_e1636, f64(2f), 0u);
                                                phi_8246_ = type_42();
                                                phi_8247_ = true;
                                            }
                                            let _e4629 = phi_8245_;
                                            let _e4631 = phi_8246_;
                                            let _e4633 = phi_8247_;
                                            phi_8251_ = _e4629;
                                            phi_8252_ = _e4631;
                                            phi_8253_ = false;
                                            phi_8254_ = _e4633;
                                        } else {
                                            phi_8251_ = type_42();
                                            phi_8252_ = type_42();
                                            phi_8253_ = true;
                                            phi_8254_ = false;
                                        }
                                        let _e4635 = phi_8251_;
                                        let _e4637 = phi_8252_;
                                        let _e4639 = phi_8253_;
                                        let _e4641 = phi_8254_;
                                        phi_8255_ = _e4635;
                                        phi_8256_ = _e4637;
                                        phi_8257_ = _e4639;
                                        phi_8258_ = _e4641;
                                    } else {
                                        phi_8255_ = type_42();
                                        phi_8256_ = type_42();
                                        phi_8257_ = true;
                                        phi_8258_ = false;
                                    }
                                    let _e4643 = phi_8255_;
                                    let _e4645 = phi_8256_;
                                    let _e4647 = phi_8257_;
                                    let _e4649 = phi_8258_;
                                    let _e4657 = select(_e4649, true, _e4647);
                                    let _e4661 = select(_e4645.member_1, select(_e4643.member_1, f64(2f), _e4647), _e4657);
                                    let _e4663 = select(_e4645.member_2, select(_e4643.member_2, 0u, _e4647), _e4657);
                                    if ((_e553 & 64u) != 0u) {
                                        let _e4665 = (_e4663 == 2u);
                                        let _e4666 = (_e4661 <= _e551);
                                        phi_8293_ = select(f64(), select(f64(), _e4661, _e4666), _e4665);
                                        phi_8294_ = select(f64(), select(f64(), _e4661, _e4666), _e4665);
                                        phi_8295_ = select(false, _e4666, _e4665);
                                        phi_8296_ = select(false, select(true, false, _e4666), _e4665);
                                        phi_8297_ = select(true, false, _e4665);
                                    } else {
                                        phi_8293_ = f64();
                                        phi_8294_ = f64();
                                        phi_8295_ = false;
                                        phi_8296_ = false;
                                        phi_8297_ = true;
                                    }
                                    let _e4676 = phi_8293_;
                                    let _e4678 = phi_8294_;
                                    let _e4680 = phi_8295_;
                                    let _e4682 = phi_8296_;
                                    let _e4684 = phi_8297_;
                                    phi_8298_ = _e4676;
                                    phi_8299_ = _e4663;
                                    phi_8300_ = _e4678;
                                    phi_8301_ = type_42(select(_e4645.member, select(_e4643.member, _e1636, _e4647), _e4657), _e4661, _e4663);
                                    phi_8302_ = _e4663;
                                    phi_8303_ = _e4663;
                                    phi_8304_ = _e4680;
                                    phi_8305_ = _e4682;
                                    phi_8306_ = _e4684;
                                }
                                let _e4686 = phi_8298_;
                                let _e4688 = phi_8299_;
                                let _e4690 = phi_8300_;
                                let _e4692 = phi_8301_;
                                let _e4694 = phi_8302_;
                                let _e4696 = phi_8303_;
                                let _e4698 = phi_8304_;
                                let _e4700 = phi_8305_;
                                let _e4702 = phi_8306_;
                                phi_8307_ = _e4686;
                                phi_8308_ = _e4688;
                                phi_8309_ = _e4690;
                                phi_8310_ = _e4692;
                                phi_8311_ = _e4694;
                                phi_8312_ = _e4696;
                                phi_8313_ = _e4698;
                                phi_8314_ = _e3340;
                                phi_8315_ = _e4700;
                                phi_8316_ = _e4702;
                                phi_8317_ = false;
                            } else {
                                phi_8307_ = f64();
                                phi_8308_ = u32();
                                phi_8309_ = f64();
                                phi_8310_ = type_42();
                                phi_8311_ = u32();
                                phi_8312_ = u32();
                                phi_8313_ = false;
                                phi_8314_ = false;
                                phi_8315_ = false;
                                phi_8316_ = false;
                                phi_8317_ = true;
                            }
                            let _e4704 = phi_8307_;
                            let _e4706 = phi_8308_;
                            let _e4708 = phi_8309_;
                            let _e4710 = phi_8310_;
                            let _e4712 = phi_8311_;
                            let _e4714 = phi_8312_;
                            let _e4716 = phi_8313_;
                            let _e4718 = phi_8314_;
                            let _e4720 = phi_8315_;
                            let _e4722 = phi_8316_;
                            let _e4724 = phi_8317_;
                            phi_8318_ = _e3337;
                            phi_3302_ = _e4704;
                            phi_3304_ = _e4706;
                            phi_3306_ = _e4708;
                            phi_8319_ = _e4710;
                            phi_8320_ = _e4712;
                            phi_8321_ = _e3337;
                            phi_8322_ = _e4714;
                            phi_8323_ = _e4716;
                            phi_8324_ = _e4718;
                            phi_8325_ = _e4720;
                            phi_8326_ = _e4722;
                            phi_8327_ = false;
                            phi_8328_ = _e4724;
                        } else {
                            phi_8318_ = f64();
                            phi_3302_ = f64();
                            phi_3304_ = u32();
                            phi_3306_ = f64();
                            phi_8319_ = type_42();
                            phi_8320_ = u32();
                            phi_8321_ = f64();
                            phi_8322_ = u32();
                            phi_8323_ = false;
                            phi_8324_ = false;
                            phi_8325_ = false;
                            phi_8326_ = false;
                            phi_8327_ = true;
                            phi_8328_ = false;
                        }
                        let _e4726 = phi_8318_;
                        let _e4728 = phi_3302_;
                        let _e4730 = phi_3304_;
                        let _e4732 = phi_3306_;
                        let _e4734 = phi_8319_;
                        let _e4736 = phi_8320_;
                        let _e4738 = phi_8321_;
                        let _e4740 = phi_8322_;
                        let _e4742 = phi_8323_;
                        let _e4744 = phi_8324_;
                        let _e4746 = phi_8325_;
                        let _e4748 = phi_8326_;
                        let _e4750 = phi_8327_;
                        let _e4752 = phi_8328_;
                        local_41 = _e4744;
                        local_42 = _e4746;
                        local_43 = _e4744;
                        local_44 = _e4748;
                        local_45 = _e4744;
                        local_46 = _e4750;
                        local_47 = _e4744;
                        local_48 = _e4752;
                        local_49 = _e4734;
                        local_50 = _e4734;
                        local_51 = _e4736;
                        local_52 = _e4734;
                        local_62 = _e4744;
                        local_53 = _e4740;
                        local_55 = _e4738;
                        local_56 = _e4726;
                        continue;
                        continuing {
                            phi_3298_ = _e1654;
                            phi_3301_ = _e4728;
                            phi_3303_ = _e4730;
                            phi_3305_ = _e4732;
                            break if !(_e4742);
                        }
                    }
                    let _e4755 = local_41;
                    let _e4757 = local_42;
                    let _e4758 = select(_e4757, false, _e4755);
                    let _e4760 = local_43;
                    let _e4762 = local_44;
                    let _e4765 = local_45;
                    let _e4767 = local_46;
                    let _e4770 = local_47;
                    let _e4772 = local_48;
                    if _e4758 {
                        let _e4775 = local_49;
                        if (_e4775.member >= _e551) {
                            phi_8357_ = type_38(type_37(0u, f64()), 0u);
                        } else {
                            let _e4779 = local_50;
                            let _e4783 = local_51;
                            let _e4786 = local_52;
                            phi_8357_ = type_38(type_37(2u, _e4786.member), select(_e4783, 0u, (_e4779.member > _e542)));
                        }
                        let _e4793 = phi_8357_;
                        phi_8358_ = _e4793;
                        phi_8359_ = false;
                        phi_8360_ = false;
                        phi_8361_ = false;
                        phi_8362_ = false;
                    } else {
                        phi_8358_ = type_38();
                        phi_8359_ = select(_e4762, false, _e4760);
                        let _e5630 = local_62;
                        phi_8360_ = _e5630;
                        phi_8361_ = select(_e4767, false, _e4765);
                        phi_8362_ = select(_e4772, false, _e4770);
                    }
                    let _e4795 = phi_8358_;
                    let _e4797 = phi_8359_;
                    let _e4799 = phi_8360_;
                    let _e4801 = phi_8361_;
                    let _e4803 = phi_8362_;
                    let _e4805 = local_53;
                    let _e4807 = local_54;
                    let _e4810 = local_55;
                    let _e4812 = local_56;
                    let _e4814 = select(_e4799, true, _e4797);
                    let _e4819 = local_57;
                    let _e4820 = select(_e4819, select(_e4812, _e4810, _e4797), _e4814);
                    let _e4822 = local_58;
                    let _e4823 = select(_e4822, select(_e4807, _e4805, _e4797), _e4814);
                    if select(select(_e4801, false, _e4797), true, _e4814) {
                        local[0u] = 0.01f;
                        local[1u] = 0f;
                        local[2u] = 0.8f;
                        phi_8396_ = type_9(0u, 3u);
                        loop {
                            let _e4836 = phi_8396_;
                            let _e4839 = (_e4836.member < _e4836.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e4839)) != 0i) {
                                let _e4854 = local[select(type_9().member_1, _e4836.member, _e4839)];
                                let _e4857 = (_e4820 + (select(f64(0f), _e533, (_e533 >= (1.1102230246251565e-16lf * f64(8f)))) * f64(_e4854)));
                                let _e4859 = select(_e551, _e4857, (_e4857 < _e551));
                                let _e4862 = local_5.member[0u];
                                let _e4868 = local_5.member[1u];
                                let _e4884 = local_5.member_1[0u];
                                let _e4890 = local_5.member_1[1u];
                                let _e4906 = local_5.member_2[0u];
                                let _e4912 = local_5.member_2[1u];
                                let _e4926 = function_4(array<f64, 3>((_e4862[0] + ((_e4868[0] - _e4862[0]) * _e4859)), (_e4862[1] + ((_e4868[1] - _e4862[1]) * _e4859)), (_e4862[2] + ((_e4868[2] - _e4862[2]) * _e4859))), array<f64, 3>((_e4884[0] + ((_e4890[0] - _e4884[0]) * _e4859)), (_e4884[1] + ((_e4890[1] - _e4884[1]) * _e4859)), (_e4884[2] + ((_e4890[2] - _e4884[2]) * _e4859))), array<f64, 3>((_e4906[0] + ((_e4912[0] - _e4906[0]) * _e4859)), (_e4906[1] + ((_e4912[1] - _e4906[1]) * _e4859)), (_e4906[2] + ((_e4912[2] - _e4906[2]) * _e4859))), _e230.member);
                                let _e4937 = (((_e4926[0] * _e4926[0]) + (_e4926[1] * _e4926[1])) + (_e4926[2] * _e4926[2]));
                                if (_e4937 <= 2.2250738585072014e-308lf) {
                                    phi_8629_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e4937 > 0.0lf));
                                } else {
                                    phi_8572_ = type_16(0i, 5i);
                                    phi_8575_ = bitcast<f64>(((bitcast<u64>(_e4937) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e4944 = phi_8572_;
                                        let _e4946 = phi_8575_;
                                        local_59 = _e4946;
                                        if (_e4944.member < _e4944.member_1) {
                                            let _e4953 = (_e4944.member + 1i);
                                            phi_8573_ = type_16(select(_e4953, type_17().member_1, select(false, true, ((false == (_e4953 > _e4944.member)) != false))), _e4944.member_1);
                                            phi_8616_ = type_17(1u, _e4944.member);
                                        } else {
                                            phi_8573_ = _e4944;
                                            phi_8616_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e4964 = phi_8573_;
                                        let _e4966 = phi_8616_;
                                        let _e4969 = (bitcast<i32>(_e4966.member) != 0i);
                                        if _e4969 {
                                            phi_8576_ = (0.5lf * (_e4946 + (_e4937 / _e4946)));
                                        } else {
                                            phi_8576_ = f64();
                                        }
                                        let _e4974 = phi_8576_;
                                        continue;
                                        continuing {
                                            phi_8572_ = _e4964;
                                            phi_8575_ = _e4974;
                                            break if !(_e4969);
                                        }
                                    }
                                    let _e4979 = local_59;
                                    phi_8629_ = (_e4979 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e4985 = phi_8629_;
                                let _e4993 = local_5.member[0u];
                                let _e4999 = select(_e4993[0], -(_e4993[0]), (_e4993[0] < 0.0lf));
                                let _e5002 = select(_e4993[1], -(_e4993[1]), (_e4993[1] < 0.0lf));
                                let _e5004 = select(_e5002, _e4999, (_e4999 > _e5002));
                                let _e5007 = select(_e4993[2], -(_e4993[2]), (_e4993[2] < 0.0lf));
                                let _e5009 = select(_e5007, _e5004, (_e5004 > _e5007));
                                let _e5012 = local_5.member[1u];
                                let _e5018 = select(_e5012[0], -(_e5012[0]), (_e5012[0] < 0.0lf));
                                let _e5021 = select(_e5012[1], -(_e5012[1]), (_e5012[1] < 0.0lf));
                                let _e5023 = select(_e5021, _e5018, (_e5018 > _e5021));
                                let _e5026 = select(_e5012[2], -(_e5012[2]), (_e5012[2] < 0.0lf));
                                let _e5028 = select(_e5026, _e5023, (_e5023 > _e5026));
                                let _e5032 = local_5.member_3;
                                let _e5036 = local_5.member_1[0u];
                                let _e5042 = select(_e5036[0], -(_e5036[0]), (_e5036[0] < 0.0lf));
                                let _e5045 = select(_e5036[1], -(_e5036[1]), (_e5036[1] < 0.0lf));
                                let _e5047 = select(_e5045, _e5042, (_e5042 > _e5045));
                                let _e5050 = select(_e5036[2], -(_e5036[2]), (_e5036[2] < 0.0lf));
                                let _e5052 = select(_e5050, _e5047, (_e5047 > _e5050));
                                let _e5055 = local_5.member_1[1u];
                                let _e5061 = select(_e5055[0], -(_e5055[0]), (_e5055[0] < 0.0lf));
                                let _e5064 = select(_e5055[1], -(_e5055[1]), (_e5055[1] < 0.0lf));
                                let _e5066 = select(_e5064, _e5061, (_e5061 > _e5064));
                                let _e5069 = select(_e5055[2], -(_e5055[2]), (_e5055[2] < 0.0lf));
                                let _e5071 = select(_e5069, _e5066, (_e5066 > _e5069));
                                let _e5075 = local_5.member_3;
                                let _e5079 = local_5.member_2[0u];
                                let _e5085 = select(_e5079[0], -(_e5079[0]), (_e5079[0] < 0.0lf));
                                let _e5088 = select(_e5079[1], -(_e5079[1]), (_e5079[1] < 0.0lf));
                                let _e5090 = select(_e5088, _e5085, (_e5085 > _e5088));
                                let _e5093 = select(_e5079[2], -(_e5079[2]), (_e5079[2] < 0.0lf));
                                let _e5095 = select(_e5093, _e5090, (_e5090 > _e5093));
                                let _e5098 = local_5.member_2[1u];
                                let _e5104 = select(_e5098[0], -(_e5098[0]), (_e5098[0] < 0.0lf));
                                let _e5107 = select(_e5098[1], -(_e5098[1]), (_e5098[1] < 0.0lf));
                                let _e5109 = select(_e5107, _e5104, (_e5104 > _e5107));
                                let _e5112 = select(_e5098[2], -(_e5098[2]), (_e5098[2] < 0.0lf));
                                let _e5114 = select(_e5112, _e5109, (_e5109 > _e5112));
                                let _e5118 = local_5.member_3;
                                let _e5126 = local_5.member_3;
                                let _e5136 = (((_e4985 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e5028, _e5009, (_e5009 > _e5028)) + _e5032) + (select(_e5071, _e5052, (_e5052 > _e5071)) + _e5075)) + (select(_e5114, _e5095, (_e5095 > _e5114)) + _e5118)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5126 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e905.member_1);
                                phi_8906_ = select(true, false, _e5136);
                                phi_8907_ = _e5136;
                            } else {
                                phi_8906_ = false;
                                phi_8907_ = false;
                            }
                            let _e5139 = phi_8906_;
                            let _e5141 = phi_8907_;
                            local_60 = _e5141;
                            continue;
                            continuing {
                                phi_8396_ = type_9(select(_e4836.member, (_e4836.member + 1u), _e4839), select(_e4836.member_1, _e4836.member_1, _e4839));
                                break if !(_e5139);
                            }
                        }
                        let _e5144 = local_60;
                        if _e5144 {
                            phi_8919_ = type_38(type_37(1u, _e4820), select(_e4823, 1u, (_e4820 > _e542)));
                            phi_8920_ = false;
                        } else {
                            phi_8919_ = type_38();
                            phi_8920_ = true;
                        }
                        let _e5150 = phi_8919_;
                        let _e5152 = phi_8920_;
                        if _e5152 {
                            phi_8932_ = type_38(type_37(2u, _e4820), select(_e4823, 0u, (_e4820 > _e542)));
                        } else {
                            phi_8932_ = _e5150;
                        }
                        let _e5158 = phi_8932_;
                        phi_8933_ = _e5158;
                        phi_8934_ = false;
                        phi_8935_ = false;
                    } else {
                        phi_8933_ = type_38();
                        phi_8934_ = select(select(_e4803, false, _e4797), false, _e4814);
                        phi_8935_ = select(select(_e4758, false, _e4797), false, _e4814);
                    }
                    let _e5160 = phi_8933_;
                    let _e5162 = phi_8934_;
                    let _e5164 = phi_8935_;
                    if _e5162 {
                        phi_8942_ = type_38(type_37(0u, f64()), 0u);
                        phi_8943_ = true;
                    } else {
                        phi_8942_ = _e4795;
                        phi_8943_ = _e5164;
                    }
                    let _e5168 = phi_8942_;
                    let _e5170 = phi_8943_;
                    phi_8947_ = _e5168;
                    phi_8948_ = _e5160;
                    phi_8949_ = _e5170;
                } else {
                    phi_8947_ = _e1626;
                    phi_8948_ = type_38();
                    phi_8949_ = true;
                }
                let _e5172 = phi_8947_;
                let _e5174 = phi_8948_;
                let _e5176 = phi_8949_;
                if _e5176 {
                    phi_8953_ = _e5172;
                } else {
                    phi_8953_ = _e5174;
                }
                let _e5178 = phi_8953_;
                switch bitcast<i32>(_e5178.member.member) {
                    case 0: {
                        phi_8971_ = type_35(0u, _e5178.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5189 = function_1(_e5178.member.member_1);
                        phi_8971_ = type_35(0u, _e5178.member_1, _e5189, true);
                        break;
                    }
                    case 2: {
                        let _e5185 = function_1(_e5178.member.member_1);
                        phi_8971_ = type_35(1u, _e5178.member_1, _e5185, true);
                        break;
                    }
                    default: {
                        phi_8971_ = type_35();
                        break;
                    }
                }
                let _e5193 = phi_8971_;
                local_6 = type_35(_e5193.member, _e5193.member_1, array<u32, 2>(_e5193.member_2[0], _e5193.member_2[1]), _e5193.member_3);
                phi_8980_ = type_9(_e188, _e191);
            } else {
                phi_8980_ = type_9(0u, 0u);
            }
            let _e5203 = phi_8980_;
            let _e5209 = local_6.member_3;
            if _e5209 {
                let _e5211 = params.member.member.member_1;
                phi_9005_ = ((_e5211 & 16u) != 0u);
            } else {
                phi_9005_ = false;
            }
            let _e5215 = phi_9005_;
            let _e5217 = local_6.member_3;
            if _e5217 {
                let _e5219 = local_6.member_2;
                let _e5223 = (_e5219[1] >> bitcast<u32>(20i));
                let _e5237 = atomicMin((&earliest.member[0u]), select(((((_e5223 - 896u) << bitcast<u32>(23i)) | ((_e5219[1] & 1048575u) << bitcast<u32>(3i))) | (_e5219[0] >> bitcast<u32>(29i))), 0u, (_e5223 <= 896u)));
            }
            if (_e106 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5215 {
                let _e5241 = atomicAdd((&counters[0u]), 1u);
                phi_9048_ = _e5241;
            } else {
                phi_9048_ = 0u;
            }
            let _e5243 = phi_9048_;
            workgroupBarrier();
            if (_e106 == 0u) {
                let _e5246 = atomicLoad((&counters[0u]));
                if (_e5246 > 0u) {
                    let _e5249 = atomicAdd((&contacts.member[0u]), _e5246);
                    atomicStore((&counters[1u]), _e5249);
                }
            }
            workgroupBarrier();
            let _e5252 = atomicLoad((&counters[1u]));
            let _e5253 = (_e5252 + _e5243);
            if _e5215 {
                let _e5255 = params.member.member_1.member_3;
                if (_e5253 < _e5255) {
                    let _e5261 = (7u * _e5253);
                    atomicStore((&contacts.member[(4u + _e5261)]), select(1u, 0u, ((_e5203.member_1 & 2147483648u) == 0u)));
                    let _e5266 = local_6.member;
                    atomicStore((&contacts.member[(_e5261 + 5u)]), _e5266);
                    atomicStore((&contacts.member[(_e5261 + 6u)]), _e5203.member);
                    atomicStore((&contacts.member[(_e5261 + 7u)]), (_e5203.member_1 & 2147483647u));
                    let _e5275 = local_6.member_2[0u];
                    atomicStore((&contacts.member[(_e5261 + 8u)]), _e5275);
                    let _e5280 = local_6.member_2[1u];
                    atomicStore((&contacts.member[(_e5261 + 9u)]), _e5280);
                    let _e5284 = local_6.member_1;
                    atomicStore((&contacts.member[(_e5261 + 10u)]), _e5284);
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
