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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

struct type_18 {
    member: i32,
    member_1: i32,
}

struct type_19 {
    member: u32,
    member_1: i32,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
    member_5: u32,
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
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_37 {
    member: type_33,
    member_1: f64,
}

struct type_38 {
    member: u32,
    member_1: f64,
}

struct type_39 {
    member: type_38,
    member_1: u32,
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

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(4) 
var<storage> input: type_13;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> positions: type_30;
@group(0) @binding(1) 
var<storage> paths: type_26;
@group(0) @binding(3) 
var<storage> elements: type_13;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_46;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_46;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_232_: f64;
    var phi_275_: f64;
    var phi_318_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_232_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_232_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_232_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_275_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_275_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_275_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_318_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_318_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_318_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    let _e24 = ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])));
    return array<f64, 3>(select(param_1[0], param_2[0], _e24), select(param_1[1], param_2[1], _e24), select(param_1[2], param_2[2], _e24));
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_839_: array<array<f64, 3>, 4>;

    let _e9 = (param_3[0] - param_4[0]);
    let _e12 = (param_3[1] - param_4[1]);
    let _e15 = (param_3[2] - param_4[2]);
    if (param_6 != 0u) {
        let _e163 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        let _e171 = select(f64(0f), select(f64(1f), _e163, (_e163 < f64(1f))), (_e163 > f64(0f)));
        let _e207 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e215 = select(f64(0f), select(f64(1f), _e207, (_e207 < f64(1f))), (_e207 > f64(0f)));
        let _e248 = ((((_e9 * param_5[0]) + (_e12 * param_5[1])) + (_e15 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e256 = select(f64(0f), select(f64(1f), _e248, (_e248 < f64(1f))), (_e248 > f64(0f)));
        let _e269 = (param_3[0] - param_5[0]);
        let _e272 = (param_3[1] - param_5[1]);
        let _e275 = (param_3[2] - param_5[2]);
        let _e295 = ((((_e269 * param_4[0]) + (_e272 * param_4[1])) + (_e275 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        let _e303 = select(f64(0f), select(f64(1f), _e295, (_e295 < f64(1f))), (_e295 > f64(0f)));
        phi_839_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e171)), (param_3[1] - (param_4[1] * _e171)), (param_3[2] - (param_4[2] * _e171))), array<f64, 3>((param_3[0] - (param_5[0] * _e215)), (param_3[1] - (param_5[1] * _e215)), (param_3[2] - (param_5[2] * _e215))), array<f64, 3>((_e9 - (param_5[0] * _e256)), (_e12 - (param_5[1] * _e256)), (_e15 - (param_5[2] * _e256))), array<f64, 3>((_e269 - (param_4[0] * _e303)), (_e272 - (param_4[1] * _e303)), (_e275 - (param_4[2] * _e303))));
    } else {
        let _e19 = (param_5[0] - param_4[0]);
        let _e22 = (param_5[1] - param_4[1]);
        let _e25 = (param_5[2] - param_4[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        let _e44 = select(f64(0f), select(f64(1f), _e36, (_e36 < f64(1f))), (_e36 > f64(0f)));
        let _e51 = array<f64, 3>((_e9 - (_e19 * _e44)), (_e12 - (_e22 * _e44)), (_e15 - (_e25 * _e44)));
        let _e74 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        let _e82 = select(f64(0f), select(f64(1f), _e74, (_e74 < f64(1f))), (_e74 > f64(0f)));
        let _e118 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e126 = select(f64(0f), select(f64(1f), _e118, (_e118 < f64(1f))), (_e118 > f64(0f)));
        phi_839_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e82)), (param_3[1] - (param_4[1] * _e82)), (param_3[2] - (param_4[2] * _e82))), array<f64, 3>((param_3[0] - (param_5[0] * _e126)), (param_3[1] - (param_5[1] * _e126)), (param_3[2] - (param_5[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_839_;
    let _e319 = function_1(_e316[0], _e316[1]);
    let _e321 = function_1(_e319, _e316[2]);
    let _e323 = function_1(_e321, _e316[3]);
    return _e323;
}

fn function_3(param_7: array<f64, 3>, param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: u32) -> array<f64, 3> {
    var phi_438_: bool;
    var phi_472_: array<f64, 3>;
    var phi_473_: bool;
    var phi_474_: array<f64, 3>;
    var phi_475_: bool;
    var phi_480_: array<f64, 3>;

    let _e23 = (((param_8[0] * param_8[0]) + (param_8[1] * param_8[1])) + (param_8[2] * param_8[2]));
    let _e34 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e45 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e56 = (((param_7[0] * param_8[0]) + (param_7[1] * param_8[1])) + (param_7[2] * param_8[2]));
    let _e67 = (((param_7[0] * param_9[0]) + (param_7[1] * param_9[1])) + (param_7[2] * param_9[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e71 = f64(0f);
    let _e72 = f64(1f);
    let _e76 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e80 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_10 != 0u) {
        let _e91 = (_e76 >= _e71);
        let _e92 = (_e80 >= _e71);
        let _e93 = (_e76 <= _e72);
        phi_438_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_438_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_438_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_472_ = array<f64, 3>((param_7[0] - ((param_8[0] * _e76) + (param_9[0] * _e80))), (param_7[1] - ((param_8[1] * _e76) + (param_9[1] * _e80))), (param_7[2] - ((param_8[2] * _e76) + (param_9[2] * _e80))));
            phi_473_ = false;
        } else {
            phi_472_ = array<f64, 3>();
            phi_473_ = true;
        }
        let _e132 = phi_472_;
        let _e134 = phi_473_;
        phi_474_ = _e132;
        phi_475_ = _e134;
    } else {
        phi_474_ = array<f64, 3>();
        phi_475_ = true;
    }
    let _e136 = phi_474_;
    let _e138 = phi_475_;
    if _e138 {
        let _e139 = function_2(param_7, param_8, param_9, param_10);
        phi_480_ = _e139;
    } else {
        phi_480_ = _e136;
    }
    let _e141 = phi_480_;
    return _e141;
}

fn function_4(param_11: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_11);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_5(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<f32, 3>;
    var local_1: type_41;
    var local_2: type_36;
    var local_3: type_36;
    var local_4: type_36;
    var local_5: type_33;
    var phi_940_: u32;
    var phi_985_: u32;
    var phi_988_: type_9;
    var phi_1150_: type_23;
    var phi_1346_: type_31;
    var phi_1507_: type_33;
    var phi_1781_: bool;
    var phi_1877_: type_37;
    var phi_1878_: bool;
    var phi_1879_: type_37;
    var phi_1880_: bool;
    var phi_1881_: type_37;
    var phi_1882_: bool;
    var phi_1887_: type_37;
    var phi_2057_: type_18;
    var phi_2060_: f64;
    var phi_2058_: type_18;
    var phi_2101_: type_19;
    var phi_2061_: f64;
    var local_6: f64;
    var phi_2114_: f64;
    var phi_3041_: type_39;
    var phi_3042_: bool;
    var phi_3043_: type_39;
    var phi_3044_: bool;
    var phi_3050_: type_18;
    var phi_3053_: f64;
    var phi_3055_: u32;
    var phi_3057_: f64;
    var phi_3051_: type_18;
    var phi_3098_: type_19;
    var phi_3541_: type_9;
    var phi_3544_: f64;
    var phi_3546_: f64;
    var phi_3548_: f64;
    var phi_3550_: f64;
    var phi_3552_: bool;
    var phi_3554_: u32;
    var phi_3706_: array<f64, 3>;
    var phi_3774_: type_18;
    var phi_3777_: f64;
    var phi_3775_: type_18;
    var phi_3818_: type_19;
    var phi_3778_: f64;
    var local_7: f64;
    var phi_3831_: f64;
    var phi_3957_: type_36;
    var phi_3958_: bool;
    var phi_3959_: type_36;
    var phi_3960_: bool;
    var phi_3970_: type_36;
    var phi_4142_: bool;
    var phi_4143_: bool;
    var phi_4144_: bool;
    var phi_4145_: bool;
    var phi_4146_: bool;
    var phi_4147_: bool;
    var phi_4449_: bool;
    var phi_4450_: bool;
    var phi_4451_: bool;
    var phi_4452_: bool;
    var phi_4453_: bool;
    var phi_4454_: bool;
    var phi_4462_: bool;
    var phi_4572_: f64;
    var phi_4573_: bool;
    var phi_4574_: f64;
    var phi_4575_: bool;
    var phi_4576_: f64;
    var phi_4577_: bool;
    var phi_4578_: bool;
    var phi_4644_: f64;
    var phi_4645_: bool;
    var phi_4646_: f64;
    var phi_4647_: bool;
    var phi_4648_: f64;
    var phi_4649_: bool;
    var phi_4650_: bool;
    var phi_4721_: f64;
    var phi_4722_: bool;
    var phi_4723_: f64;
    var phi_4724_: bool;
    var phi_4725_: f64;
    var phi_4726_: bool;
    var phi_4727_: bool;
    var phi_4793_: f64;
    var phi_4794_: bool;
    var phi_4795_: f64;
    var phi_4796_: bool;
    var phi_4797_: f64;
    var phi_4798_: bool;
    var phi_4799_: bool;
    var phi_4976_: type_18;
    var phi_4979_: f64;
    var phi_4977_: type_18;
    var phi_5020_: type_19;
    var phi_4980_: f64;
    var local_8: f64;
    var phi_5033_: f64;
    var phi_5310_: bool;
    var phi_5311_: bool;
    var phi_5338_: f64;
    var phi_5339_: f64;
    var phi_5340_: bool;
    var phi_5341_: f64;
    var phi_5342_: f64;
    var phi_5343_: bool;
    var phi_5344_: bool;
    var phi_5345_: f64;
    var phi_5346_: f64;
    var phi_5347_: f64;
    var phi_5348_: f64;
    var phi_5349_: bool;
    var phi_5350_: bool;
    var phi_5351_: bool;
    var phi_5352_: bool;
    var phi_5353_: f64;
    var phi_5354_: f64;
    var phi_5355_: f64;
    var phi_5356_: f64;
    var phi_5357_: bool;
    var phi_5358_: bool;
    var phi_5359_: bool;
    var phi_5360_: bool;
    var phi_5361_: bool;
    var phi_5362_: f64;
    var phi_5363_: f64;
    var phi_5364_: f64;
    var phi_5365_: f64;
    var phi_5366_: bool;
    var phi_5367_: bool;
    var phi_5368_: bool;
    var phi_5369_: bool;
    var phi_5370_: bool;
    var phi_5708_: f64;
    var phi_5710_: u32;
    var phi_5711_: f64;
    var phi_5712_: bool;
    var phi_5713_: bool;
    var phi_5714_: bool;
    var phi_5715_: u32;
    var phi_5716_: f64;
    var phi_5717_: f64;
    var phi_5718_: f64;
    var phi_5719_: f64;
    var phi_5720_: bool;
    var phi_5721_: u32;
    var phi_5722_: bool;
    var phi_5723_: bool;
    var phi_5724_: bool;
    var phi_5725_: bool;
    var phi_5726_: bool;
    var phi_5727_: bool;
    var phi_5755_: f64;
    var phi_5756_: f64;
    var phi_5757_: f64;
    var phi_5758_: f64;
    var phi_5759_: bool;
    var phi_5760_: u32;
    var phi_5761_: bool;
    var phi_5762_: bool;
    var phi_5763_: bool;
    var phi_5764_: bool;
    var phi_5765_: bool;
    var phi_5766_: bool;
    var phi_3545_: f64;
    var phi_3547_: f64;
    var phi_3549_: f64;
    var phi_3551_: f64;
    var phi_3553_: bool;
    var phi_3555_: u32;
    var phi_5767_: f64;
    var phi_5768_: f64;
    var phi_5769_: bool;
    var phi_5770_: bool;
    var phi_5771_: bool;
    var phi_5772_: bool;
    var phi_5773_: bool;
    var phi_5774_: bool;
    var phi_5775_: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: f64;
    var local_20: bool;
    var local_21: f64;
    var local_22: f64;
    var local_23: f64;
    var phi_5842_: f64;
    var phi_5843_: bool;
    var phi_6468_: type_18;
    var phi_6471_: f64;
    var phi_6469_: type_18;
    var phi_6512_: type_19;
    var phi_6472_: f64;
    var local_24: f64;
    var phi_6525_: f64;
    var phi_6763_: type_18;
    var phi_6766_: f64;
    var phi_6764_: type_18;
    var phi_6807_: type_19;
    var phi_6767_: f64;
    var local_25: f64;
    var phi_6820_: f64;
    var phi_6852_: type_18;
    var phi_6855_: f64;
    var phi_6853_: type_18;
    var phi_6896_: type_19;
    var phi_6856_: f64;
    var local_26: f64;
    var phi_6909_: f64;
    var phi_7227_: type_9;
    var phi_7230_: f64;
    var phi_7231_: f64;
    var local_27: f64;
    var local_28: f64;
    var phi_7332_: type_18;
    var phi_7335_: f64;
    var phi_7333_: type_18;
    var phi_7376_: type_19;
    var phi_7336_: f64;
    var local_29: f64;
    var phi_7389_: f64;
    var phi_7396_: type_9;
    var phi_7399_: f64;
    var phi_7401_: bool;
    var phi_7403_: bool;
    var phi_7639_: f64;
    var phi_7640_: f64;
    var phi_7400_: f64;
    var phi_7402_: bool;
    var phi_7404_: bool;
    var local_30: f64;
    var local_31: f64;
    var local_32: bool;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var phi_7658_: type_42;
    var phi_7659_: bool;
    var local_36: bool;
    var phi_7681_: type_9;
    var phi_7684_: f64;
    var phi_7686_: f64;
    var phi_7796_: f64;
    var phi_7797_: f64;
    var phi_7798_: f64;
    var phi_7799_: f64;
    var phi_7685_: f64;
    var phi_7687_: f64;
    var local_37: f64;
    var local_38: f64;
    var local_39: f64;
    var phi_7962_: bool;
    var phi_7963_: bool;
    var phi_7964_: bool;
    var phi_7965_: bool;
    var phi_7966_: bool;
    var phi_7967_: bool;
    var phi_7976_: bool;
    var phi_7977_: bool;
    var phi_7986_: type_42;
    var phi_7987_: type_42;
    var phi_7988_: bool;
    var phi_7989_: type_42;
    var phi_7990_: type_42;
    var phi_7991_: bool;
    var phi_7997_: type_42;
    var phi_7998_: type_42;
    var phi_7999_: bool;
    var phi_8003_: type_42;
    var phi_8004_: type_42;
    var phi_8005_: bool;
    var phi_8006_: bool;
    var phi_8007_: type_42;
    var phi_8008_: type_42;
    var phi_8009_: bool;
    var phi_8010_: bool;
    var phi_8045_: f64;
    var phi_8046_: f64;
    var phi_8047_: bool;
    var phi_8048_: bool;
    var phi_8049_: bool;
    var phi_8050_: f64;
    var phi_8051_: u32;
    var phi_8052_: f64;
    var phi_8053_: type_42;
    var phi_8054_: u32;
    var phi_8055_: u32;
    var phi_8056_: bool;
    var phi_8057_: bool;
    var phi_8058_: bool;
    var phi_8059_: f64;
    var phi_8060_: u32;
    var phi_8061_: f64;
    var phi_8062_: type_42;
    var phi_8063_: u32;
    var phi_8064_: u32;
    var phi_8065_: bool;
    var phi_8066_: bool;
    var phi_8067_: bool;
    var phi_8068_: bool;
    var phi_8069_: bool;
    var phi_8070_: f64;
    var phi_3054_: f64;
    var phi_3056_: u32;
    var phi_3058_: f64;
    var phi_8071_: type_42;
    var phi_8072_: u32;
    var phi_8073_: f64;
    var phi_8074_: u32;
    var phi_8075_: bool;
    var phi_8076_: bool;
    var phi_8077_: bool;
    var phi_8078_: bool;
    var phi_8079_: bool;
    var phi_8080_: bool;
    var local_40: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: type_42;
    var local_49: type_42;
    var local_50: u32;
    var local_51: type_42;
    var phi_8109_: type_39;
    var phi_8110_: type_39;
    var phi_8111_: bool;
    var phi_8112_: bool;
    var phi_8113_: bool;
    var phi_8114_: bool;
    var local_52: u32;
    var local_53: u32;
    var local_54: f64;
    var local_55: f64;
    var local_56: f64;
    var local_57: u32;
    var phi_8148_: type_9;
    var phi_8324_: type_18;
    var phi_8327_: f64;
    var phi_8325_: type_18;
    var phi_8368_: type_19;
    var phi_8328_: f64;
    var local_58: f64;
    var phi_8381_: f64;
    var phi_8658_: bool;
    var phi_8659_: bool;
    var local_59: bool;
    var phi_8671_: type_39;
    var phi_8672_: bool;
    var phi_8684_: type_39;
    var phi_8685_: type_39;
    var phi_8686_: bool;
    var phi_8687_: bool;
    var phi_8694_: type_39;
    var phi_8695_: bool;
    var phi_8699_: type_39;
    var phi_8700_: type_39;
    var phi_8701_: bool;
    var phi_8705_: type_39;
    var phi_8723_: type_35;
    var phi_8758_: u32;
    var phi_8762_: type_20;
    var phi_8763_: bool;
    var phi_8774_: u32;
    var phi_8834_: bool;
    var phi_8835_: bool;
    var local_60: bool;
    var local_61: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e99 = id_2;
    let _e100 = n_2;
    let _e101 = lane_2;
    let _e113 = ((_e99.y * _e100.x) + _e99.x);
    let _e116 = (_e100.x * _e100.y);
    let _e119 = params.member.member_1.member_2;
    let _e121 = input.member[0u];
    let _e123 = select(_e121, _e119, (_e119 < _e121));
    let _e125 = params.member.member_1.member_1;
    if (_e123 > _e125) {
        let _e128 = params.member.member_1.member_1;
        phi_940_ = (_e123 - _e128);
    } else {
        phi_940_ = 0u;
    }
    let _e131 = phi_940_;
    let _e133 = params.member.member_1.member;
    let _e135 = select(_e131, _e133, (_e133 < _e131));
    let _e136 = (_e135 / 64u);
    let _e140 = select(_e136, (_e136 + 1u), ((_e135 % 64u) > 0u));
    if (_e140 > _e113) {
        let _e142 = (_e140 - _e113);
        if (_e116 == 0u) {
            return;
        }
        let _e144 = (_e142 / _e116);
        if (_e116 == 0u) {
            return;
        }
        phi_985_ = select(_e144, (_e144 + 1u), ((_e142 % _e116) > 0u));
    } else {
        phi_985_ = 0u;
    }
    let _e151 = phi_985_;
    phi_988_ = type_9(0u, _e151);
    loop {
        let _e154 = phi_988_;
        let _e157 = (_e154.member < _e154.member_1);
        let _e170 = (bitcast<i32>(select(0u, 1u, _e157)) != 0i);
        if _e170 {
            let _e174 = (((_e113 + (select(type_9().member_1, _e154.member, _e157) * _e116)) * 64u) + _e101);
            let _e177 = params.member.member_2.member;
            let _e180 = params.member.member.member_1;
            let _e182 = ((_e180 & 16u) != 0u);
            if (_e174 < _e135) {
                let _e187 = params.member.member_1.member_1;
                let _e189 = (2u * (_e187 + _e174));
                let _e192 = input.member[(4u + _e189)];
                let _e195 = input.member[(_e189 + 5u)];
                if (_e177 == 0u) {
                    let _e212 = (3u * _e195);
                    let _e214 = elements.member[_e212];
                    let _e217 = elements.member[(_e212 + 1u)];
                    let _e220 = elements.member[(_e212 + 2u)];
                    phi_1150_ = type_23(0u, array<u32, 4>(_e192, _e214, _e217, _e220));
                } else {
                    let _e198 = (2u * _e192);
                    let _e199 = (2u * _e195);
                    let _e201 = elements.member[_e198];
                    let _e203 = elements.member[_e199];
                    let _e206 = elements.member[(_e198 + 1u)];
                    let _e209 = elements.member[(_e199 + 1u)];
                    phi_1150_ = type_23(1u, array<u32, 4>(_e201, _e206, _e203, _e209));
                }
                let _e224 = phi_1150_;
                let _e228 = params.member.member.member_1;
                if ((_e228 & 8u) != 0u) {
                    let _e272 = paths.member[_e224.member_1[0]];
                    let _e287 = paths.member[_e224.member_1[1]];
                    let _e302 = paths.member[_e224.member_1[2]];
                    let _e317 = paths.member[_e224.member_1[3]];
                    let _e338 = function_(array<f32, 3>(_e272.member.x, _e272.member.y, _e272.member.z));
                    let _e339 = function_(array<f32, 3>(_e287.member.x, _e287.member.y, _e287.member.z));
                    let _e340 = function_(array<f32, 3>(_e302.member.x, _e302.member.y, _e302.member.z));
                    let _e341 = function_(array<f32, 3>(_e317.member.x, _e317.member.y, _e317.member.z));
                    let _e343 = function_(array<f32, 3>(_e272.member_1.x, _e272.member_1.y, _e272.member_1.z));
                    let _e344 = function_(array<f32, 3>(_e287.member_1.x, _e287.member_1.y, _e287.member_1.z));
                    let _e345 = function_(array<f32, 3>(_e302.member_1.x, _e302.member_1.y, _e302.member_1.z));
                    let _e346 = function_(array<f32, 3>(_e317.member_1.x, _e317.member_1.y, _e317.member_1.z));
                    phi_1346_ = type_31(array<array<f64, 3>, 4>(_e338, _e339, _e340, _e341), array<array<f64, 3>, 4>(_e343, _e344, _e345, _e346));
                } else {
                    let _e233 = positions.member[_e224.member_1[0]];
                    let _e236 = params.member.member.member[0u];
                    let _e239 = positions.member[(_e236 + _e224.member_1[0])];
                    let _e242 = positions.member[_e224.member_1[1]];
                    let _e245 = params.member.member.member[0u];
                    let _e248 = positions.member[(_e245 + _e224.member_1[1])];
                    let _e251 = positions.member[_e224.member_1[2]];
                    let _e254 = params.member.member.member[0u];
                    let _e257 = positions.member[(_e254 + _e224.member_1[2])];
                    let _e260 = positions.member[_e224.member_1[3]];
                    let _e263 = params.member.member.member[0u];
                    let _e266 = positions.member[(_e263 + _e224.member_1[3])];
                    phi_1346_ = type_31(array<array<f64, 3>, 4>(_e233, _e242, _e251, _e260), array<array<f64, 3>, 4>(_e239, _e248, _e257, _e266));
                }
                let _e350 = phi_1346_;
                if (_e224.member != 0u) {
                    phi_1507_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e350.member[2][0] - _e350.member[0][0]), (_e350.member[2][1] - _e350.member[0][1]), (_e350.member[2][2] - _e350.member[0][2])), array<f64, 3>((_e350.member_1[2][0] - _e350.member_1[0][0]), (_e350.member_1[2][1] - _e350.member_1[0][1]), (_e350.member_1[2][2] - _e350.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e350.member[1][0] - _e350.member[0][0]), (_e350.member[1][1] - _e350.member[0][1]), (_e350.member[1][2] - _e350.member[0][2])), array<f64, 3>((_e350.member_1[1][0] - _e350.member_1[0][0]), (_e350.member_1[1][1] - _e350.member_1[0][1]), (_e350.member_1[1][2] - _e350.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e350.member[2][0] - _e350.member[3][0]), (_e350.member[2][1] - _e350.member[3][1]), (_e350.member[2][2] - _e350.member[3][2])), array<f64, 3>((_e350.member_1[2][0] - _e350.member_1[3][0]), (_e350.member_1[2][1] - _e350.member_1[3][1]), (_e350.member_1[2][2] - _e350.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_1507_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e350.member[0][0] - _e350.member[1][0]), (_e350.member[0][1] - _e350.member[1][1]), (_e350.member[0][2] - _e350.member[1][2])), array<f64, 3>((_e350.member_1[0][0] - _e350.member_1[1][0]), (_e350.member_1[0][1] - _e350.member_1[1][1]), (_e350.member_1[0][2] - _e350.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e350.member[2][0] - _e350.member[1][0]), (_e350.member[2][1] - _e350.member[1][1]), (_e350.member[2][2] - _e350.member[1][2])), array<f64, 3>((_e350.member_1[2][0] - _e350.member_1[1][0]), (_e350.member_1[2][1] - _e350.member_1[1][1]), (_e350.member_1[2][2] - _e350.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e350.member[3][0] - _e350.member[1][0]), (_e350.member[3][1] - _e350.member[1][1]), (_e350.member[3][2] - _e350.member[1][2])), array<f64, 3>((_e350.member_1[3][0] - _e350.member_1[1][0]), (_e350.member_1[3][1] - _e350.member_1[1][1]), (_e350.member_1[3][2] - _e350.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e509 = phi_1507_;
                let _e511 = params.member.member.member_7;
                let _e518 = bitcast<f64>(((u64(_e511[1]) * 4294967296lu) + u64(_e511[0])));
                let _e520 = params.member.member.member_14;
                let _e527 = bitcast<f64>(((u64(_e520[1]) * 4294967296lu) + u64(_e520[0])));
                let _e529 = params.member.member.member_15;
                let _e536 = bitcast<f64>(((u64(_e529[1]) * 4294967296lu) + u64(_e529[0])));
                let _e538 = params.member.member.member_16;
                let _e545 = bitcast<f64>(((u64(_e538[1]) * 4294967296lu) + u64(_e538[0])));
                let _e547 = params.member.member.member_1;
                let _e555 = select(_e509.member[0][0], -(_e509.member[0][0]), (_e509.member[0][0] < 0.0lf));
                let _e559 = select(_e509.member[0][1], -(_e509.member[0][1]), (_e509.member[0][1] < 0.0lf));
                let _e561 = select(_e559, _e555, (_e555 > _e559));
                let _e565 = select(_e509.member[0][2], -(_e509.member[0][2]), (_e509.member[0][2] < 0.0lf));
                let _e567 = select(_e565, _e561, (_e561 > _e565));
                let _e573 = select(_e509.member[1][0], -(_e509.member[1][0]), (_e509.member[1][0] < 0.0lf));
                let _e577 = select(_e509.member[1][1], -(_e509.member[1][1]), (_e509.member[1][1] < 0.0lf));
                let _e579 = select(_e577, _e573, (_e573 > _e577));
                let _e583 = select(_e509.member[1][2], -(_e509.member[1][2]), (_e509.member[1][2] < 0.0lf));
                let _e585 = select(_e583, _e579, (_e579 > _e583));
                let _e589 = (select(_e585, _e567, (_e567 > _e585)) + _e509.member_3);
                let _e595 = select(_e509.member_1[0][0], -(_e509.member_1[0][0]), (_e509.member_1[0][0] < 0.0lf));
                let _e599 = select(_e509.member_1[0][1], -(_e509.member_1[0][1]), (_e509.member_1[0][1] < 0.0lf));
                let _e601 = select(_e599, _e595, (_e595 > _e599));
                let _e605 = select(_e509.member_1[0][2], -(_e509.member_1[0][2]), (_e509.member_1[0][2] < 0.0lf));
                let _e607 = select(_e605, _e601, (_e601 > _e605));
                let _e613 = select(_e509.member_1[1][0], -(_e509.member_1[1][0]), (_e509.member_1[1][0] < 0.0lf));
                let _e617 = select(_e509.member_1[1][1], -(_e509.member_1[1][1]), (_e509.member_1[1][1] < 0.0lf));
                let _e619 = select(_e617, _e613, (_e613 > _e617));
                let _e623 = select(_e509.member_1[1][2], -(_e509.member_1[1][2]), (_e509.member_1[1][2] < 0.0lf));
                let _e625 = select(_e623, _e619, (_e619 > _e623));
                let _e629 = (select(_e625, _e607, (_e607 > _e625)) + _e509.member_3);
                let _e635 = select(_e509.member_2[0][0], -(_e509.member_2[0][0]), (_e509.member_2[0][0] < 0.0lf));
                let _e639 = select(_e509.member_2[0][1], -(_e509.member_2[0][1]), (_e509.member_2[0][1] < 0.0lf));
                let _e641 = select(_e639, _e635, (_e635 > _e639));
                let _e645 = select(_e509.member_2[0][2], -(_e509.member_2[0][2]), (_e509.member_2[0][2] < 0.0lf));
                let _e647 = select(_e645, _e641, (_e641 > _e645));
                let _e653 = select(_e509.member_2[1][0], -(_e509.member_2[1][0]), (_e509.member_2[1][0] < 0.0lf));
                let _e657 = select(_e509.member_2[1][1], -(_e509.member_2[1][1]), (_e509.member_2[1][1] < 0.0lf));
                let _e659 = select(_e657, _e653, (_e653 > _e657));
                let _e663 = select(_e509.member_2[1][2], -(_e509.member_2[1][2]), (_e509.member_2[1][2] < 0.0lf));
                let _e665 = select(_e663, _e659, (_e659 > _e663));
                let _e669 = (select(_e665, _e647, (_e647 > _e665)) + _e509.member_3);
                let _e671 = select(_e629, _e589, (_e589 > _e629));
                let _e673 = select(_e669, _e671, (_e671 > _e669));
                if (_e673 <= f64(65536f)) {
                    phi_1781_ = (_e673 >= f64((1f / 65536f)));
                } else {
                    phi_1781_ = false;
                }
                let _e680 = phi_1781_;
                if _e680 {
                    phi_1881_ = type_37();
                    phi_1882_ = true;
                } else {
                    if (_e673 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e673) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e687 = (9214364837600034816lu - (bitcast<u64>(_e673) & 9218868437227405312lu));
                            let _e690 = bitcast<f64>(select(4503599627370496lu, _e687, (_e687 > 4503599627370496lu)));
                            let _e691 = (_e518 * _e690);
                            phi_1877_ = type_37(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e509.member[0][0] * _e690), (_e509.member[0][1] * _e690), (_e509.member[0][2] * _e690)), array<f64, 3>((_e509.member[1][0] * _e690), (_e509.member[1][1] * _e690), (_e509.member[1][2] * _e690))), array<array<f64, 3>, 2>(array<f64, 3>((_e509.member_1[0][0] * _e690), (_e509.member_1[0][1] * _e690), (_e509.member_1[0][2] * _e690)), array<f64, 3>((_e509.member_1[1][0] * _e690), (_e509.member_1[1][1] * _e690), (_e509.member_1[1][2] * _e690))), array<array<f64, 3>, 2>(array<f64, 3>((_e509.member_2[0][0] * _e690), (_e509.member_2[0][1] * _e690), (_e509.member_2[0][2] * _e690)), array<f64, 3>((_e509.member_2[1][0] * _e690), (_e509.member_2[1][1] * _e690), (_e509.member_2[1][2] * _e690))), ((_e509.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e690)), select(_e691, select(2.2250738585072014e-308lf, _e691, (_e691 > 2.2250738585072014e-308lf)), (_e518 > f64(0f))));
                            phi_1878_ = false;
                        } else {
                            phi_1877_ = type_37();
                            phi_1878_ = true;
                        }
                        let _e762 = phi_1877_;
                        let _e764 = phi_1878_;
                        phi_1879_ = _e762;
                        phi_1880_ = _e764;
                    } else {
                        phi_1879_ = type_37();
                        phi_1880_ = true;
                    }
                    let _e766 = phi_1879_;
                    let _e768 = phi_1880_;
                    phi_1881_ = _e766;
                    phi_1882_ = _e768;
                }
                let _e770 = phi_1881_;
                let _e772 = phi_1882_;
                if _e772 {
                    phi_1887_ = type_37(_e509, _e518);
                } else {
                    phi_1887_ = _e770;
                }
                let _e775 = phi_1887_;
                local_5 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e775.member.member[0][0], _e775.member.member[0][1], _e775.member.member[0][2]), array<f64, 3>(_e775.member.member[1][0], _e775.member.member[1][1], _e775.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e775.member.member_1[0][0], _e775.member.member_1[0][1], _e775.member.member_1[0][2]), array<f64, 3>(_e775.member.member_1[1][0], _e775.member.member_1[1][1], _e775.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e775.member.member_2[0][0], _e775.member.member_2[0][1], _e775.member.member_2[0][2]), array<f64, 3>(_e775.member.member_2[1][0], _e775.member.member_2[1][1], _e775.member.member_2[1][2])), _e775.member.member_3);
                let _e818 = local_5.member[0u];
                let _e824 = local_5.member[1u];
                let _e840 = local_5.member_1[0u];
                let _e846 = local_5.member_1[1u];
                let _e862 = local_5.member_2[0u];
                let _e868 = local_5.member_2[1u];
                let _e882 = function_3(array<f64, 3>((_e818[0] + ((_e824[0] - _e818[0]) * _e536)), (_e818[1] + ((_e824[1] - _e818[1]) * _e536)), (_e818[2] + ((_e824[2] - _e818[2]) * _e536))), array<f64, 3>((_e840[0] + ((_e846[0] - _e840[0]) * _e536)), (_e840[1] + ((_e846[1] - _e840[1]) * _e536)), (_e840[2] + ((_e846[2] - _e840[2]) * _e536))), array<f64, 3>((_e862[0] + ((_e868[0] - _e862[0]) * _e536)), (_e862[1] + ((_e868[1] - _e862[1]) * _e536)), (_e862[2] + ((_e868[2] - _e862[2]) * _e536))), _e224.member);
                let _e893 = (((_e882[0] * _e882[0]) + (_e882[1] * _e882[1])) + (_e882[2] * _e882[2]));
                if (_e893 <= 2.2250738585072014e-308lf) {
                    phi_2114_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e893 > 0.0lf));
                } else {
                    phi_2057_ = type_18(0i, 5i);
                    phi_2060_ = bitcast<f64>(((bitcast<u64>(_e893) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e900 = phi_2057_;
                        let _e902 = phi_2060_;
                        local_6 = _e902;
                        if (_e900.member < _e900.member_1) {
                            let _e909 = (_e900.member + 1i);
                            phi_2058_ = type_18(select(_e909, type_19().member_1, select(false, true, ((false == (_e909 > _e900.member)) != false))), _e900.member_1);
                            phi_2101_ = type_19(1u, _e900.member);
                        } else {
                            phi_2058_ = _e900;
                            phi_2101_ = type_19(0u, type_19().member_1);
                        }
                        let _e920 = phi_2058_;
                        let _e922 = phi_2101_;
                        let _e925 = (bitcast<i32>(_e922.member) != 0i);
                        if _e925 {
                            phi_2061_ = (0.5lf * (_e902 + (_e893 / _e902)));
                        } else {
                            phi_2061_ = f64();
                        }
                        let _e930 = phi_2061_;
                        continue;
                        continuing {
                            phi_2057_ = _e920;
                            phi_2060_ = _e930;
                            break if !(_e925);
                        }
                    }
                    let _e935 = local_6;
                    phi_2114_ = (_e935 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e941 = phi_2114_;
                let _e949 = local_5.member[0u];
                let _e955 = select(_e949[0], -(_e949[0]), (_e949[0] < 0.0lf));
                let _e958 = select(_e949[1], -(_e949[1]), (_e949[1] < 0.0lf));
                let _e960 = select(_e958, _e955, (_e955 > _e958));
                let _e963 = select(_e949[2], -(_e949[2]), (_e949[2] < 0.0lf));
                let _e965 = select(_e963, _e960, (_e960 > _e963));
                let _e968 = local_5.member[1u];
                let _e974 = select(_e968[0], -(_e968[0]), (_e968[0] < 0.0lf));
                let _e977 = select(_e968[1], -(_e968[1]), (_e968[1] < 0.0lf));
                let _e979 = select(_e977, _e974, (_e974 > _e977));
                let _e982 = select(_e968[2], -(_e968[2]), (_e968[2] < 0.0lf));
                let _e984 = select(_e982, _e979, (_e979 > _e982));
                let _e988 = local_5.member_3;
                let _e992 = local_5.member_1[0u];
                let _e998 = select(_e992[0], -(_e992[0]), (_e992[0] < 0.0lf));
                let _e1001 = select(_e992[1], -(_e992[1]), (_e992[1] < 0.0lf));
                let _e1003 = select(_e1001, _e998, (_e998 > _e1001));
                let _e1006 = select(_e992[2], -(_e992[2]), (_e992[2] < 0.0lf));
                let _e1008 = select(_e1006, _e1003, (_e1003 > _e1006));
                let _e1011 = local_5.member_1[1u];
                let _e1017 = select(_e1011[0], -(_e1011[0]), (_e1011[0] < 0.0lf));
                let _e1020 = select(_e1011[1], -(_e1011[1]), (_e1011[1] < 0.0lf));
                let _e1022 = select(_e1020, _e1017, (_e1017 > _e1020));
                let _e1025 = select(_e1011[2], -(_e1011[2]), (_e1011[2] < 0.0lf));
                let _e1027 = select(_e1025, _e1022, (_e1022 > _e1025));
                let _e1031 = local_5.member_3;
                let _e1035 = local_5.member_2[0u];
                let _e1041 = select(_e1035[0], -(_e1035[0]), (_e1035[0] < 0.0lf));
                let _e1044 = select(_e1035[1], -(_e1035[1]), (_e1035[1] < 0.0lf));
                let _e1046 = select(_e1044, _e1041, (_e1041 > _e1044));
                let _e1049 = select(_e1035[2], -(_e1035[2]), (_e1035[2] < 0.0lf));
                let _e1051 = select(_e1049, _e1046, (_e1046 > _e1049));
                let _e1054 = local_5.member_2[1u];
                let _e1060 = select(_e1054[0], -(_e1054[0]), (_e1054[0] < 0.0lf));
                let _e1063 = select(_e1054[1], -(_e1054[1]), (_e1054[1] < 0.0lf));
                let _e1065 = select(_e1063, _e1060, (_e1060 > _e1063));
                let _e1068 = select(_e1054[2], -(_e1054[2]), (_e1054[2] < 0.0lf));
                let _e1070 = select(_e1068, _e1065, (_e1065 > _e1068));
                let _e1074 = local_5.member_3;
                let _e1082 = local_5.member_3;
                let _e1092 = (((_e941 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e984, _e965, (_e965 > _e984)) + _e988) + (select(_e1027, _e1008, (_e1008 > _e1027)) + _e1031)) + (select(_e1070, _e1051, (_e1051 > _e1070)) + _e1074)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1082 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e775.member_1);
                if _e1092 {
                    phi_3043_ = type_39();
                    phi_3044_ = true;
                } else {
                    let _e1095 = local_5.member_1[0u];
                    let _e1101 = local_5.member_2[0u];
                    let _e1107 = ((_e1095[1] * _e1101[2]) - (_e1095[2] * _e1101[1]));
                    let _e1110 = ((_e1095[2] * _e1101[0]) - (_e1095[0] * _e1101[2]));
                    let _e1113 = ((_e1095[0] * _e1101[1]) - (_e1095[1] * _e1101[0]));
                    let _e1116 = local_5.member_1[1u];
                    let _e1122 = local_5.member_2[1u];
                    let _e1128 = ((_e1116[1] * _e1122[2]) - (_e1116[2] * _e1122[1]));
                    let _e1131 = ((_e1116[2] * _e1122[0]) - (_e1116[0] * _e1122[2]));
                    let _e1134 = ((_e1116[0] * _e1122[1]) - (_e1116[1] * _e1122[0]));
                    let _e1137 = local_5.member_1[0u];
                    let _e1143 = local_5.member_2[1u];
                    let _e1158 = local_5.member_1[1u];
                    let _e1164 = local_5.member_2[0u];
                    let _e1177 = (((_e1137[1] * _e1143[2]) - (_e1137[2] * _e1143[1])) + ((_e1158[1] * _e1164[2]) - (_e1158[2] * _e1164[1])));
                    let _e1178 = (((_e1137[2] * _e1143[0]) - (_e1137[0] * _e1143[2])) + ((_e1158[2] * _e1164[0]) - (_e1158[0] * _e1164[2])));
                    let _e1179 = (((_e1137[0] * _e1143[1]) - (_e1137[1] * _e1143[0])) + ((_e1158[0] * _e1164[1]) - (_e1158[1] * _e1164[0])));
                    let _e1182 = local_5.member[0u];
                    let _e1193 = local_5.member[1u];
                    let _e1204 = local_5.member[0u];
                    let _e1213 = ((((_e1193[0] * _e1107) + (_e1193[1] * _e1110)) + (_e1193[2] * _e1113)) + (((_e1204[0] * _e1177) + (_e1204[1] * _e1178)) + (_e1204[2] * _e1179)));
                    let _e1216 = local_5.member[0u];
                    let _e1227 = local_5.member[1u];
                    let _e1236 = ((((_e1216[0] * _e1128) + (_e1216[1] * _e1131)) + (_e1216[2] * _e1134)) + (((_e1227[0] * _e1177) + (_e1227[1] * _e1178)) + (_e1227[2] * _e1179)));
                    let _e1239 = local_5.member[1u];
                    let _e1250 = local_5.member[0u];
                    let _e1256 = select(_e1250[0], -(_e1250[0]), (_e1250[0] < 0.0lf));
                    let _e1259 = select(_e1250[1], -(_e1250[1]), (_e1250[1] < 0.0lf));
                    let _e1261 = select(_e1259, _e1256, (_e1256 > _e1259));
                    let _e1264 = select(_e1250[2], -(_e1250[2]), (_e1250[2] < 0.0lf));
                    let _e1266 = select(_e1264, _e1261, (_e1261 > _e1264));
                    let _e1269 = local_5.member[1u];
                    let _e1275 = select(_e1269[0], -(_e1269[0]), (_e1269[0] < 0.0lf));
                    let _e1278 = select(_e1269[1], -(_e1269[1]), (_e1269[1] < 0.0lf));
                    let _e1280 = select(_e1278, _e1275, (_e1275 > _e1278));
                    let _e1283 = select(_e1269[2], -(_e1269[2]), (_e1269[2] < 0.0lf));
                    let _e1285 = select(_e1283, _e1280, (_e1280 > _e1283));
                    let _e1289 = local_5.member_3;
                    let _e1290 = (select(_e1285, _e1266, (_e1266 > _e1285)) + _e1289);
                    let _e1293 = local_5.member_1[0u];
                    let _e1299 = select(_e1293[0], -(_e1293[0]), (_e1293[0] < 0.0lf));
                    let _e1302 = select(_e1293[1], -(_e1293[1]), (_e1293[1] < 0.0lf));
                    let _e1304 = select(_e1302, _e1299, (_e1299 > _e1302));
                    let _e1307 = select(_e1293[2], -(_e1293[2]), (_e1293[2] < 0.0lf));
                    let _e1309 = select(_e1307, _e1304, (_e1304 > _e1307));
                    let _e1312 = local_5.member_1[1u];
                    let _e1318 = select(_e1312[0], -(_e1312[0]), (_e1312[0] < 0.0lf));
                    let _e1321 = select(_e1312[1], -(_e1312[1]), (_e1312[1] < 0.0lf));
                    let _e1323 = select(_e1321, _e1318, (_e1318 > _e1321));
                    let _e1326 = select(_e1312[2], -(_e1312[2]), (_e1312[2] < 0.0lf));
                    let _e1328 = select(_e1326, _e1323, (_e1323 > _e1326));
                    let _e1332 = local_5.member_3;
                    let _e1333 = (select(_e1328, _e1309, (_e1309 > _e1328)) + _e1332);
                    let _e1336 = local_5.member_2[0u];
                    let _e1342 = select(_e1336[0], -(_e1336[0]), (_e1336[0] < 0.0lf));
                    let _e1345 = select(_e1336[1], -(_e1336[1]), (_e1336[1] < 0.0lf));
                    let _e1347 = select(_e1345, _e1342, (_e1342 > _e1345));
                    let _e1350 = select(_e1336[2], -(_e1336[2]), (_e1336[2] < 0.0lf));
                    let _e1352 = select(_e1350, _e1347, (_e1347 > _e1350));
                    let _e1355 = local_5.member_2[1u];
                    let _e1361 = select(_e1355[0], -(_e1355[0]), (_e1355[0] < 0.0lf));
                    let _e1364 = select(_e1355[1], -(_e1355[1]), (_e1355[1] < 0.0lf));
                    let _e1366 = select(_e1364, _e1361, (_e1361 > _e1364));
                    let _e1369 = select(_e1355[2], -(_e1355[2]), (_e1355[2] < 0.0lf));
                    let _e1371 = select(_e1369, _e1366, (_e1366 > _e1369));
                    let _e1375 = local_5.member_3;
                    let _e1376 = (select(_e1371, _e1352, (_e1352 > _e1371)) + _e1375);
                    let _e1377 = f64(1f);
                    let _e1378 = f64(8f);
                    let _e1380 = ((_e1333 * _e1378) * _e1376);
                    let _e1388 = local_5.member_3;
                    let _e1415 = ((select(_e1107, -(_e1107), (_e1107 < 0.0lf)) + select(_e1110, -(_e1110), (_e1110 < 0.0lf))) + select(_e1113, -(_e1113), (_e1113 < 0.0lf)));
                    let _e1426 = ((select(_e1128, -(_e1128), (_e1128 < 0.0lf)) + select(_e1131, -(_e1131), (_e1131 < 0.0lf))) + select(_e1134, -(_e1134), (_e1134 < 0.0lf)));
                    let _e1428 = select(_e1426, _e1415, (_e1415 > _e1426));
                    let _e1440 = (((select(_e1177, -(_e1177), (_e1177 < 0.0lf)) + select(_e1178, -(_e1178), (_e1178 < 0.0lf))) + select(_e1179, -(_e1179), (_e1179 < 0.0lf))) * f64(0.5f));
                    let _e1448 = local_5.member_3;
                    let _e1463 = f64(3f);
                    let _e1464 = ((((_e1182[0] * _e1107) + (_e1182[1] * _e1110)) + (_e1182[2] * _e1113)) * _e1463);
                    let _e1465 = ((((_e1239[0] * _e1128) + (_e1239[1] * _e1131)) + (_e1239[2] * _e1134)) * _e1463);
                    let _e1467 = select(_e1465, _e1464, (_e1464 < _e1465));
                    let _e1469 = select(_e1236, _e1213, (_e1213 < _e1236));
                    let _e1471 = select(_e1469, _e1467, (_e1467 < _e1469));
                    let _e1473 = select(_e1465, _e1464, (_e1464 > _e1465));
                    let _e1475 = select(_e1236, _e1213, (_e1213 > _e1236));
                    let _e1483 = -(select(_e1475, _e1473, (_e1473 > _e1475)));
                    if ((select(_e1483, _e1471, (_e1471 > _e1483)) - ((((((_e1290 * _e1378) * _e1380) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1388 * f64(19f)) * ((_e1290 * (_e1333 + _e1376)) + (_e1333 * _e1376)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1377 + _e1290) * ((_e1377 + _e1333) * (_e1377 + _e1376))))) + ((_e775.member_1 * (((select(_e1440, _e1428, (_e1428 > _e1440)) + (_e1380 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1448 * f64(6f)) * (_e1333 + _e1376))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1377 + _e1333) * (_e1377 + _e1376))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                        phi_3041_ = type_39(type_38(0u, f64()), 0u);
                        phi_3042_ = false;
                    } else {
                        phi_3041_ = type_39();
                        phi_3042_ = true;
                    }
                    let _e1492 = phi_3041_;
                    let _e1494 = phi_3042_;
                    phi_3043_ = _e1492;
                    phi_3044_ = _e1494;
                }
                let _e1496 = phi_3043_;
                let _e1498 = phi_3044_;
                if _e1498 {
                    phi_3050_ = type_18(0i, 2i);
                    phi_3053_ = _e536;
                    phi_3055_ = 0u;
                    phi_3057_ = _e536;
                    loop {
                        let _e1500 = phi_3050_;
                        let _e1502 = phi_3053_;
                        let _e1504 = phi_3055_;
                        let _e1506 = phi_3057_;
                        local_53 = _e1504;
                        local_56 = _e1502;
                        local_57 = _e1504;
                        if (_e1500.member < _e1500.member_1) {
                            let _e1513 = (_e1500.member + 1i);
                            phi_3051_ = type_18(select(_e1513, type_19().member_1, select(false, true, ((false == (_e1513 > _e1500.member)) != false))), _e1500.member_1);
                            phi_3098_ = type_19(1u, _e1500.member);
                        } else {
                            phi_3051_ = _e1500;
                            phi_3098_ = type_19(0u, type_19().member_1);
                        }
                        let _e1524 = phi_3051_;
                        let _e1526 = phi_3098_;
                        if (bitcast<i32>(_e1526.member) != 0i) {
                            if select(select(true, false, _e1092), true, (_e1526.member_1 > 0i)) {
                                let _e1536 = local_5.member[0u];
                                let _e1542 = local_5.member_1[0u];
                                let _e1548 = local_5.member_2[0u];
                                let _e1552 = (_e1536[0] - _e1542[0]);
                                let _e1553 = (_e1536[1] - _e1542[1]);
                                let _e1554 = (_e1536[2] - _e1542[2]);
                                let _e1555 = (_e224.member == 0u);
                                let _e1567 = local_5.member[1u];
                                let _e1573 = local_5.member_1[1u];
                                let _e1579 = local_5.member_2[1u];
                                let _e1583 = (_e1567[0] - _e1573[0]);
                                let _e1584 = (_e1567[1] - _e1573[1]);
                                let _e1585 = (_e1567[2] - _e1573[2]);
                                let _e1586 = (_e224.member == 0u);
                                let _e1598 = local_5.member[0u];
                                let _e1604 = select(_e1598[0], -(_e1598[0]), (_e1598[0] < 0.0lf));
                                let _e1607 = select(_e1598[1], -(_e1598[1]), (_e1598[1] < 0.0lf));
                                let _e1609 = select(_e1607, _e1604, (_e1604 > _e1607));
                                let _e1612 = select(_e1598[2], -(_e1598[2]), (_e1598[2] < 0.0lf));
                                let _e1614 = select(_e1612, _e1609, (_e1609 > _e1612));
                                let _e1617 = local_5.member[1u];
                                let _e1623 = select(_e1617[0], -(_e1617[0]), (_e1617[0] < 0.0lf));
                                let _e1626 = select(_e1617[1], -(_e1617[1]), (_e1617[1] < 0.0lf));
                                let _e1628 = select(_e1626, _e1623, (_e1623 > _e1626));
                                let _e1631 = select(_e1617[2], -(_e1617[2]), (_e1617[2] < 0.0lf));
                                let _e1633 = select(_e1631, _e1628, (_e1628 > _e1631));
                                let _e1637 = local_5.member_3;
                                let _e1641 = local_5.member_1[0u];
                                let _e1647 = select(_e1641[0], -(_e1641[0]), (_e1641[0] < 0.0lf));
                                let _e1650 = select(_e1641[1], -(_e1641[1]), (_e1641[1] < 0.0lf));
                                let _e1652 = select(_e1650, _e1647, (_e1647 > _e1650));
                                let _e1655 = select(_e1641[2], -(_e1641[2]), (_e1641[2] < 0.0lf));
                                let _e1657 = select(_e1655, _e1652, (_e1652 > _e1655));
                                let _e1660 = local_5.member_1[1u];
                                let _e1666 = select(_e1660[0], -(_e1660[0]), (_e1660[0] < 0.0lf));
                                let _e1669 = select(_e1660[1], -(_e1660[1]), (_e1660[1] < 0.0lf));
                                let _e1671 = select(_e1669, _e1666, (_e1666 > _e1669));
                                let _e1674 = select(_e1660[2], -(_e1660[2]), (_e1660[2] < 0.0lf));
                                let _e1676 = select(_e1674, _e1671, (_e1671 > _e1674));
                                let _e1680 = local_5.member_3;
                                let _e1684 = local_5.member_2[0u];
                                let _e1690 = select(_e1684[0], -(_e1684[0]), (_e1684[0] < 0.0lf));
                                let _e1693 = select(_e1684[1], -(_e1684[1]), (_e1684[1] < 0.0lf));
                                let _e1695 = select(_e1693, _e1690, (_e1690 > _e1693));
                                let _e1698 = select(_e1684[2], -(_e1684[2]), (_e1684[2] < 0.0lf));
                                let _e1700 = select(_e1698, _e1695, (_e1695 > _e1698));
                                let _e1703 = local_5.member_2[1u];
                                let _e1709 = select(_e1703[0], -(_e1703[0]), (_e1703[0] < 0.0lf));
                                let _e1712 = select(_e1703[1], -(_e1703[1]), (_e1703[1] < 0.0lf));
                                let _e1714 = select(_e1712, _e1709, (_e1709 > _e1712));
                                let _e1717 = select(_e1703[2], -(_e1703[2]), (_e1703[2] < 0.0lf));
                                let _e1719 = select(_e1717, _e1714, (_e1714 > _e1717));
                                let _e1723 = local_5.member_3;
                                let _e1731 = local_5.member_3;
                                let _e1739 = (_e527 * f64(0.00390625f));
                                let _e1740 = f64(0f);
                                let _e1741 = f64(1f);
                                local_3 = type_36(array<f64, 4>(_e1740, _e1740, _e1740, _e1740), array<f64, 4>(_e1740, _e1740, _e1740, _e1740), array<f64, 4>(_e1741, _e1741, _e1741, _e1741));
                                phi_3541_ = type_9(0u, 96u);
                                phi_3544_ = _e1506;
                                phi_3546_ = _e1506;
                                phi_3548_ = (_e545 - _e1506);
                                phi_3550_ = _e1506;
                                phi_3552_ = false;
                                phi_3554_ = 0u;
                                loop {
                                    let _e1748 = phi_3541_;
                                    let _e1750 = phi_3544_;
                                    let _e1752 = phi_3546_;
                                    let _e1754 = phi_3548_;
                                    let _e1756 = phi_3550_;
                                    let _e1758 = phi_3552_;
                                    let _e1760 = phi_3554_;
                                    local_19 = _e1750;
                                    local_23 = _e1752;
                                    let _e1763 = (_e1748.member < _e1748.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e1763)) != 0i) {
                                        let _e1777 = local_5.member[0u];
                                        let _e1783 = local_5.member[1u];
                                        let _e1799 = local_5.member_1[0u];
                                        let _e1805 = local_5.member_1[1u];
                                        let _e1821 = local_5.member_2[0u];
                                        let _e1827 = local_5.member_2[1u];
                                        let _e1841 = function_3(array<f64, 3>((_e1777[0] + ((_e1783[0] - _e1777[0]) * _e1750)), (_e1777[1] + ((_e1783[1] - _e1777[1]) * _e1750)), (_e1777[2] + ((_e1783[2] - _e1777[2]) * _e1750))), array<f64, 3>((_e1799[0] + ((_e1805[0] - _e1799[0]) * _e1750)), (_e1799[1] + ((_e1805[1] - _e1799[1]) * _e1750)), (_e1799[2] + ((_e1805[2] - _e1799[2]) * _e1750))), array<f64, 3>((_e1821[0] + ((_e1827[0] - _e1821[0]) * _e1750)), (_e1821[1] + ((_e1827[1] - _e1821[1]) * _e1750)), (_e1821[2] + ((_e1827[2] - _e1821[2]) * _e1750))), _e224.member);
                                        if (_e1760 == 0u) {
                                            phi_3706_ = _e1841;
                                        } else {
                                            let _e1843 = f64(0f);
                                            phi_3706_ = array<f64, 3>(select(_e1843, _e1841[0], (_e1760 == 1u)), select(_e1843, _e1841[1], (_e1760 == 2u)), select(_e1843, _e1841[2], (_e1760 == 3u)));
                                        }
                                        let _e1855 = phi_3706_;
                                        let _e1869 = ((select(_e1855[0], -(_e1855[0]), (_e1855[0] < 0.0lf)) + select(_e1855[1], -(_e1855[1]), (_e1855[1] < 0.0lf))) + select(_e1855[2], -(_e1855[2]), (_e1855[2] < 0.0lf)));
                                        if (_e1869 > f64(0f)) {
                                            if ((bitcast<u64>(_e1869) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e1876 = (f64(1f) / _e1869);
                                                let _e1878 = (_e1855[0] * _e1876);
                                                let _e1880 = (_e1855[1] * _e1876);
                                                let _e1882 = (_e1855[2] * _e1876);
                                                let _e1887 = (((_e1878 * _e1878) + (_e1880 * _e1880)) + (_e1882 * _e1882));
                                                if (_e1887 <= 2.2250738585072014e-308lf) {
                                                    phi_3831_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1887 > 0.0lf));
                                                } else {
                                                    phi_3774_ = type_18(0i, 5i);
                                                    phi_3777_ = bitcast<f64>(((bitcast<u64>(_e1887) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e1894 = phi_3774_;
                                                        let _e1896 = phi_3777_;
                                                        local_7 = _e1896;
                                                        if (_e1894.member < _e1894.member_1) {
                                                            let _e1903 = (_e1894.member + 1i);
                                                            phi_3775_ = type_18(select(_e1903, type_19().member_1, select(false, true, ((false == (_e1903 > _e1894.member)) != false))), _e1894.member_1);
                                                            phi_3818_ = type_19(1u, _e1894.member);
                                                        } else {
                                                            phi_3775_ = _e1894;
                                                            phi_3818_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e1914 = phi_3775_;
                                                        let _e1916 = phi_3818_;
                                                        let _e1919 = (bitcast<i32>(_e1916.member) != 0i);
                                                        if _e1919 {
                                                            phi_3778_ = (0.5lf * (_e1896 + (_e1887 / _e1896)));
                                                        } else {
                                                            phi_3778_ = f64();
                                                        }
                                                        let _e1924 = phi_3778_;
                                                        continue;
                                                        continuing {
                                                            phi_3774_ = _e1914;
                                                            phi_3777_ = _e1924;
                                                            break if !(_e1919);
                                                        }
                                                    }
                                                    let _e1929 = local_7;
                                                    phi_3831_ = (_e1929 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e1935 = phi_3831_;
                                                let _e1937 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e1944 = ((((((((select(_e1633, _e1614, (_e1614 > _e1633)) + _e1637) + (select(_e1676, _e1657, (_e1657 > _e1676)) + _e1680)) + (select(_e1719, _e1700, (_e1700 > _e1719)) + _e1723)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1731 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e775.member_1 * _e1935) * (f64(1f) + _e1937)));
                                                let _e1949 = (((_e1878 * _e1536[0]) + (_e1880 * _e1536[1])) + (_e1882 * _e1536[2]));
                                                let _e1954 = (((_e1878 * _e1552) + (_e1880 * _e1553)) + (_e1882 * _e1554));
                                                let _e1959 = (((_e1878 * (_e1536[0] - _e1548[0])) + (_e1880 * (_e1536[1] - _e1548[1]))) + (_e1882 * (_e1536[2] - _e1548[2])));
                                                let _e1964 = (((_e1878 * select((_e1552 - _e1548[0]), _e1536[0], _e1555)) + (_e1880 * select((_e1553 - _e1548[1]), _e1536[1], _e1555))) + (_e1882 * select((_e1554 - _e1548[2]), _e1536[2], _e1555)));
                                                let _e1970 = (((_e1878 * _e1567[0]) + (_e1880 * _e1567[1])) + (_e1882 * _e1567[2]));
                                                let _e1975 = (((_e1878 * _e1583) + (_e1880 * _e1584)) + (_e1882 * _e1585));
                                                let _e1980 = (((_e1878 * (_e1567[0] - _e1579[0])) + (_e1880 * (_e1567[1] - _e1579[1]))) + (_e1882 * (_e1567[2] - _e1579[2])));
                                                let _e1985 = (((_e1878 * select((_e1583 - _e1579[0]), _e1567[0], _e1586)) + (_e1880 * select((_e1584 - _e1579[1]), _e1567[1], _e1586))) + (_e1882 * select((_e1585 - _e1579[2]), _e1567[2], _e1586)));
                                                phi_3957_ = type_36(array<f64, 4>(_e1949, _e1954, _e1959, _e1964), array<f64, 4>(_e1970, _e1975, _e1980, _e1985), array<f64, 4>((_e1944 + ((select(_e1949, -(_e1949), (_e1949 < 0.0lf)) + select(_e1970, -(_e1970), (_e1970 < 0.0lf))) * _e1937)), (_e1944 + ((select(_e1954, -(_e1954), (_e1954 < 0.0lf)) + select(_e1975, -(_e1975), (_e1975 < 0.0lf))) * _e1937)), (_e1944 + ((select(_e1959, -(_e1959), (_e1959 < 0.0lf)) + select(_e1980, -(_e1980), (_e1980 < 0.0lf))) * _e1937)), (_e1944 + ((select(_e1964, -(_e1964), (_e1964 < 0.0lf)) + select(_e1985, -(_e1985), (_e1985 < 0.0lf))) * _e1937))));
                                                phi_3958_ = false;
                                            } else {
                                                phi_3957_ = type_36();
                                                phi_3958_ = true;
                                            }
                                            let _e2026 = phi_3957_;
                                            let _e2028 = phi_3958_;
                                            phi_3959_ = _e2026;
                                            phi_3960_ = _e2028;
                                        } else {
                                            phi_3959_ = type_36();
                                            phi_3960_ = true;
                                        }
                                        let _e2030 = phi_3959_;
                                        let _e2032 = phi_3960_;
                                        if _e2032 {
                                            let _e2033 = f64(0f);
                                            let _e2034 = f64(1f);
                                            phi_3970_ = type_36(array<f64, 4>(_e2033, _e2033, _e2033, _e2033), array<f64, 4>(_e2033, _e2033, _e2033, _e2033), array<f64, 4>(_e2034, _e2034, _e2034, _e2034));
                                        } else {
                                            phi_3970_ = _e2030;
                                        }
                                        let _e2040 = phi_3970_;
                                        local_4 = type_36(array<f64, 4>(_e2040.member[0], _e2040.member[1], _e2040.member[2], _e2040.member[3]), array<f64, 4>(_e2040.member_1[0], _e2040.member_1[1], _e2040.member_1[2], _e2040.member_1[3]), array<f64, 4>(_e2040.member_2[0], _e2040.member_2[1], _e2040.member_2[2], _e2040.member_2[3]));
                                        let _e2060 = (_e1750 - _e1756);
                                        let _e2062 = f64(0f);
                                        let _e2065 = local_4.member[0u];
                                        let _e2068 = local_4.member_1[0u];
                                        let _e2071 = local_4.member[0u];
                                        let _e2077 = local_4.member_2[0u];
                                        if (((_e2065 + ((_e2068 - _e2071) * _e1750)) - _e2077) > _e2062) {
                                            let _e2082 = local_4.member[1u];
                                            let _e2085 = local_4.member_1[1u];
                                            let _e2088 = local_4.member[1u];
                                            let _e2094 = local_4.member_2[1u];
                                            if (((_e2082 + ((_e2085 - _e2088) * _e1750)) - _e2094) > _e2062) {
                                                let _e2099 = local_4.member[2u];
                                                let _e2102 = local_4.member_1[2u];
                                                let _e2105 = local_4.member[2u];
                                                let _e2111 = local_4.member_2[2u];
                                                if (((_e2099 + ((_e2102 - _e2105) * _e1750)) - _e2111) > _e2062) {
                                                    let _e2116 = local_4.member[3u];
                                                    let _e2119 = local_4.member_1[3u];
                                                    let _e2122 = local_4.member[3u];
                                                    let _e2128 = local_4.member_2[3u];
                                                    phi_4142_ = (((_e2116 + ((_e2119 - _e2122) * _e1750)) - _e2128) > _e2062);
                                                    phi_4143_ = false;
                                                } else {
                                                    phi_4142_ = bool();
                                                    phi_4143_ = true;
                                                }
                                                let _e2132 = phi_4142_;
                                                let _e2134 = phi_4143_;
                                                phi_4144_ = _e2132;
                                                phi_4145_ = _e2134;
                                            } else {
                                                phi_4144_ = bool();
                                                phi_4145_ = true;
                                            }
                                            let _e2136 = phi_4144_;
                                            let _e2138 = phi_4145_;
                                            phi_4146_ = _e2136;
                                            phi_4147_ = _e2138;
                                        } else {
                                            phi_4146_ = bool();
                                            phi_4147_ = true;
                                        }
                                        let _e2140 = phi_4146_;
                                        let _e2142 = phi_4147_;
                                        if select(_e2140, false, _e2142) {
                                            if (_e1750 <= _e1752) {
                                                phi_4462_ = true;
                                            } else {
                                                let _e2145 = f64(0f);
                                                let _e2148 = local_3.member[0u];
                                                let _e2151 = local_3.member_1[0u];
                                                let _e2154 = local_3.member[0u];
                                                let _e2160 = local_3.member_2[0u];
                                                let _e2164 = local_4.member[0u];
                                                let _e2167 = local_4.member_1[0u];
                                                let _e2170 = local_4.member[0u];
                                                let _e2176 = local_4.member_2[0u];
                                                if ((((_e2148 + ((_e2151 - _e2154) * _e1750)) - _e2160) + ((_e2164 + ((_e2167 - _e2170) * _e1756)) - _e2176)) > _e2145) {
                                                    let _e2182 = local_3.member[1u];
                                                    let _e2185 = local_3.member_1[1u];
                                                    let _e2188 = local_3.member[1u];
                                                    let _e2194 = local_3.member_2[1u];
                                                    let _e2198 = local_4.member[1u];
                                                    let _e2201 = local_4.member_1[1u];
                                                    let _e2204 = local_4.member[1u];
                                                    let _e2210 = local_4.member_2[1u];
                                                    if ((((_e2182 + ((_e2185 - _e2188) * _e1750)) - _e2194) + ((_e2198 + ((_e2201 - _e2204) * _e1756)) - _e2210)) > _e2145) {
                                                        let _e2216 = local_3.member[2u];
                                                        let _e2219 = local_3.member_1[2u];
                                                        let _e2222 = local_3.member[2u];
                                                        let _e2228 = local_3.member_2[2u];
                                                        let _e2232 = local_4.member[2u];
                                                        let _e2235 = local_4.member_1[2u];
                                                        let _e2238 = local_4.member[2u];
                                                        let _e2244 = local_4.member_2[2u];
                                                        if ((((_e2216 + ((_e2219 - _e2222) * _e1750)) - _e2228) + ((_e2232 + ((_e2235 - _e2238) * _e1756)) - _e2244)) > _e2145) {
                                                            let _e2250 = local_3.member[3u];
                                                            let _e2253 = local_3.member_1[3u];
                                                            let _e2256 = local_3.member[3u];
                                                            let _e2262 = local_3.member_2[3u];
                                                            let _e2266 = local_4.member[3u];
                                                            let _e2269 = local_4.member_1[3u];
                                                            let _e2272 = local_4.member[3u];
                                                            let _e2278 = local_4.member_2[3u];
                                                            phi_4449_ = ((((_e2250 + ((_e2253 - _e2256) * _e1750)) - _e2262) + ((_e2266 + ((_e2269 - _e2272) * _e1756)) - _e2278)) > _e2145);
                                                            phi_4450_ = false;
                                                        } else {
                                                            phi_4449_ = bool();
                                                            phi_4450_ = true;
                                                        }
                                                        let _e2283 = phi_4449_;
                                                        let _e2285 = phi_4450_;
                                                        phi_4451_ = _e2283;
                                                        phi_4452_ = _e2285;
                                                    } else {
                                                        phi_4451_ = bool();
                                                        phi_4452_ = true;
                                                    }
                                                    let _e2287 = phi_4451_;
                                                    let _e2289 = phi_4452_;
                                                    phi_4453_ = _e2287;
                                                    phi_4454_ = _e2289;
                                                } else {
                                                    phi_4453_ = bool();
                                                    phi_4454_ = true;
                                                }
                                                let _e2291 = phi_4453_;
                                                let _e2293 = phi_4454_;
                                                phi_4462_ = select(_e2291, false, _e2293);
                                            }
                                            let _e2296 = phi_4462_;
                                            if _e2296 {
                                                if select(true, select(true, false, (_e1750 >= _e545)), _e1758) {
                                                    local_3 = type_36(array<f64, 4>(_e2040.member[0], _e2040.member[1], _e2040.member[2], _e2040.member[3]), array<f64, 4>(_e2040.member_1[0], _e2040.member_1[1], _e2040.member_1[2], _e2040.member_1[3]), array<f64, 4>(_e2040.member_2[0], _e2040.member_2[1], _e2040.member_2[2], _e2040.member_2[3]));
                                                    let _e2321 = local_3.member[0u];
                                                    let _e2324 = local_3.member_1[0u];
                                                    let _e2327 = local_3.member_2[0u];
                                                    if select(true, select(true, false, (_e2324 > _e2327)), (_e2321 > _e2327)) {
                                                        let _e2332 = (_e2324 >= _e2321);
                                                        if _e2332 {
                                                            phi_4574_ = f64();
                                                            phi_4575_ = false;
                                                        } else {
                                                            if ((_e2321 - _e2324) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4572_ = (((_e2321 - _e2327) / (_e2321 - _e2324)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4573_ = false;
                                                            } else {
                                                                phi_4572_ = f64();
                                                                phi_4573_ = true;
                                                            }
                                                            let _e2346 = phi_4572_;
                                                            let _e2348 = phi_4573_;
                                                            phi_4574_ = _e2346;
                                                            phi_4575_ = _e2348;
                                                        }
                                                        let _e2350 = phi_4574_;
                                                        let _e2352 = phi_4575_;
                                                        phi_4576_ = _e2350;
                                                        phi_4577_ = _e2332;
                                                        phi_4578_ = _e2352;
                                                    } else {
                                                        phi_4576_ = f64();
                                                        phi_4577_ = true;
                                                        phi_4578_ = false;
                                                    }
                                                    let _e2354 = phi_4576_;
                                                    let _e2356 = phi_4577_;
                                                    let _e2358 = phi_4578_;
                                                    let _e2362 = select(_e2354, select(_e1750, f64(2f), _e2356), select(_e2358, true, _e2356));
                                                    let _e2365 = local_3.member[1u];
                                                    let _e2368 = local_3.member_1[1u];
                                                    let _e2371 = local_3.member_2[1u];
                                                    if select(true, select(true, false, (_e2368 > _e2371)), (_e2365 > _e2371)) {
                                                        let _e2376 = (_e2368 >= _e2365);
                                                        if _e2376 {
                                                            phi_4646_ = f64();
                                                            phi_4647_ = false;
                                                        } else {
                                                            if ((_e2365 - _e2368) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4644_ = (((_e2365 - _e2371) / (_e2365 - _e2368)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4645_ = false;
                                                            } else {
                                                                phi_4644_ = f64();
                                                                phi_4645_ = true;
                                                            }
                                                            let _e2390 = phi_4644_;
                                                            let _e2392 = phi_4645_;
                                                            phi_4646_ = _e2390;
                                                            phi_4647_ = _e2392;
                                                        }
                                                        let _e2394 = phi_4646_;
                                                        let _e2396 = phi_4647_;
                                                        phi_4648_ = _e2394;
                                                        phi_4649_ = _e2376;
                                                        phi_4650_ = _e2396;
                                                    } else {
                                                        phi_4648_ = f64();
                                                        phi_4649_ = true;
                                                        phi_4650_ = false;
                                                    }
                                                    let _e2398 = phi_4648_;
                                                    let _e2400 = phi_4649_;
                                                    let _e2402 = phi_4650_;
                                                    let _e2406 = select(_e2398, select(_e1750, f64(2f), _e2400), select(_e2402, true, _e2400));
                                                    let _e2408 = select(_e2406, _e2362, (_e2362 < _e2406));
                                                    let _e2411 = local_3.member[2u];
                                                    let _e2414 = local_3.member_1[2u];
                                                    let _e2417 = local_3.member_2[2u];
                                                    if select(true, select(true, false, (_e2414 > _e2417)), (_e2411 > _e2417)) {
                                                        let _e2422 = (_e2414 >= _e2411);
                                                        if _e2422 {
                                                            phi_4723_ = f64();
                                                            phi_4724_ = false;
                                                        } else {
                                                            if ((_e2411 - _e2414) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4721_ = (((_e2411 - _e2417) / (_e2411 - _e2414)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4722_ = false;
                                                            } else {
                                                                phi_4721_ = f64();
                                                                phi_4722_ = true;
                                                            }
                                                            let _e2436 = phi_4721_;
                                                            let _e2438 = phi_4722_;
                                                            phi_4723_ = _e2436;
                                                            phi_4724_ = _e2438;
                                                        }
                                                        let _e2440 = phi_4723_;
                                                        let _e2442 = phi_4724_;
                                                        phi_4725_ = _e2440;
                                                        phi_4726_ = _e2422;
                                                        phi_4727_ = _e2442;
                                                    } else {
                                                        phi_4725_ = f64();
                                                        phi_4726_ = true;
                                                        phi_4727_ = false;
                                                    }
                                                    let _e2444 = phi_4725_;
                                                    let _e2446 = phi_4726_;
                                                    let _e2448 = phi_4727_;
                                                    let _e2452 = select(_e2444, select(_e1750, f64(2f), _e2446), select(_e2448, true, _e2446));
                                                    let _e2455 = local_3.member[3u];
                                                    let _e2458 = local_3.member_1[3u];
                                                    let _e2461 = local_3.member_2[3u];
                                                    if select(true, select(true, false, (_e2458 > _e2461)), (_e2455 > _e2461)) {
                                                        let _e2466 = (_e2458 >= _e2455);
                                                        if _e2466 {
                                                            phi_4795_ = f64();
                                                            phi_4796_ = false;
                                                        } else {
                                                            if ((_e2455 - _e2458) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4793_ = (((_e2455 - _e2461) / (_e2455 - _e2458)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4794_ = false;
                                                            } else {
                                                                phi_4793_ = f64();
                                                                phi_4794_ = true;
                                                            }
                                                            let _e2480 = phi_4793_;
                                                            let _e2482 = phi_4794_;
                                                            phi_4795_ = _e2480;
                                                            phi_4796_ = _e2482;
                                                        }
                                                        let _e2484 = phi_4795_;
                                                        let _e2486 = phi_4796_;
                                                        phi_4797_ = _e2484;
                                                        phi_4798_ = _e2466;
                                                        phi_4799_ = _e2486;
                                                    } else {
                                                        phi_4797_ = f64();
                                                        phi_4798_ = true;
                                                        phi_4799_ = false;
                                                    }
                                                    let _e2488 = phi_4797_;
                                                    let _e2490 = phi_4798_;
                                                    let _e2492 = phi_4799_;
                                                    let _e2496 = select(_e2488, select(_e1750, f64(2f), _e2490), select(_e2492, true, _e2490));
                                                    let _e2498 = select(_e2496, _e2452, (_e2452 < _e2496));
                                                    let _e2500 = select(_e2498, _e2408, (_e2408 < _e2498));
                                                    let _e2502 = select(_e1750, _e2500, (_e2500 > _e1750));
                                                    let _e2503 = (_e2502 > _e545);
                                                    if _e2503 {
                                                        phi_5341_ = f64();
                                                        phi_5342_ = f64();
                                                        phi_5343_ = false;
                                                        phi_5344_ = false;
                                                    } else {
                                                        let _e2504 = (_e2502 - _e1750);
                                                        let _e2505 = (_e2504 <= _e1739);
                                                        let _e2508 = (_e2502 + (_e527 * f64(0.01f)));
                                                        let _e2510 = select(_e545, _e2508, (_e2508 < _e545));
                                                        if _e2505 {
                                                            if (_e775.member_1 > f64(0f)) {
                                                                let _e2515 = local_5.member[0u];
                                                                let _e2521 = local_5.member[1u];
                                                                let _e2537 = local_5.member_1[0u];
                                                                let _e2543 = local_5.member_1[1u];
                                                                let _e2559 = local_5.member_2[0u];
                                                                let _e2565 = local_5.member_2[1u];
                                                                let _e2579 = function_3(array<f64, 3>((_e2515[0] + ((_e2521[0] - _e2515[0]) * _e2510)), (_e2515[1] + ((_e2521[1] - _e2515[1]) * _e2510)), (_e2515[2] + ((_e2521[2] - _e2515[2]) * _e2510))), array<f64, 3>((_e2537[0] + ((_e2543[0] - _e2537[0]) * _e2510)), (_e2537[1] + ((_e2543[1] - _e2537[1]) * _e2510)), (_e2537[2] + ((_e2543[2] - _e2537[2]) * _e2510))), array<f64, 3>((_e2559[0] + ((_e2565[0] - _e2559[0]) * _e2510)), (_e2559[1] + ((_e2565[1] - _e2559[1]) * _e2510)), (_e2559[2] + ((_e2565[2] - _e2559[2]) * _e2510))), _e224.member);
                                                                let _e2590 = (((_e2579[0] * _e2579[0]) + (_e2579[1] * _e2579[1])) + (_e2579[2] * _e2579[2]));
                                                                if (_e2590 <= 2.2250738585072014e-308lf) {
                                                                    phi_5033_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2590 > 0.0lf));
                                                                } else {
                                                                    phi_4976_ = type_18(0i, 5i);
                                                                    phi_4979_ = bitcast<f64>(((bitcast<u64>(_e2590) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e2597 = phi_4976_;
                                                                        let _e2599 = phi_4979_;
                                                                        local_8 = _e2599;
                                                                        if (_e2597.member < _e2597.member_1) {
                                                                            let _e2606 = (_e2597.member + 1i);
                                                                            phi_4977_ = type_18(select(_e2606, type_19().member_1, select(false, true, ((false == (_e2606 > _e2597.member)) != false))), _e2597.member_1);
                                                                            phi_5020_ = type_19(1u, _e2597.member);
                                                                        } else {
                                                                            phi_4977_ = _e2597;
                                                                            phi_5020_ = type_19(0u, type_19().member_1);
                                                                        }
                                                                        let _e2617 = phi_4977_;
                                                                        let _e2619 = phi_5020_;
                                                                        let _e2622 = (bitcast<i32>(_e2619.member) != 0i);
                                                                        if _e2622 {
                                                                            phi_4980_ = (0.5lf * (_e2599 + (_e2590 / _e2599)));
                                                                        } else {
                                                                            phi_4980_ = f64();
                                                                        }
                                                                        let _e2627 = phi_4980_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_4976_ = _e2617;
                                                                            phi_4979_ = _e2627;
                                                                            break if !(_e2622);
                                                                        }
                                                                    }
                                                                    let _e2632 = local_8;
                                                                    phi_5033_ = (_e2632 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e2638 = phi_5033_;
                                                                let _e2646 = local_5.member[0u];
                                                                let _e2652 = select(_e2646[0], -(_e2646[0]), (_e2646[0] < 0.0lf));
                                                                let _e2655 = select(_e2646[1], -(_e2646[1]), (_e2646[1] < 0.0lf));
                                                                let _e2657 = select(_e2655, _e2652, (_e2652 > _e2655));
                                                                let _e2660 = select(_e2646[2], -(_e2646[2]), (_e2646[2] < 0.0lf));
                                                                let _e2662 = select(_e2660, _e2657, (_e2657 > _e2660));
                                                                let _e2665 = local_5.member[1u];
                                                                let _e2671 = select(_e2665[0], -(_e2665[0]), (_e2665[0] < 0.0lf));
                                                                let _e2674 = select(_e2665[1], -(_e2665[1]), (_e2665[1] < 0.0lf));
                                                                let _e2676 = select(_e2674, _e2671, (_e2671 > _e2674));
                                                                let _e2679 = select(_e2665[2], -(_e2665[2]), (_e2665[2] < 0.0lf));
                                                                let _e2681 = select(_e2679, _e2676, (_e2676 > _e2679));
                                                                let _e2685 = local_5.member_3;
                                                                let _e2689 = local_5.member_1[0u];
                                                                let _e2695 = select(_e2689[0], -(_e2689[0]), (_e2689[0] < 0.0lf));
                                                                let _e2698 = select(_e2689[1], -(_e2689[1]), (_e2689[1] < 0.0lf));
                                                                let _e2700 = select(_e2698, _e2695, (_e2695 > _e2698));
                                                                let _e2703 = select(_e2689[2], -(_e2689[2]), (_e2689[2] < 0.0lf));
                                                                let _e2705 = select(_e2703, _e2700, (_e2700 > _e2703));
                                                                let _e2708 = local_5.member_1[1u];
                                                                let _e2714 = select(_e2708[0], -(_e2708[0]), (_e2708[0] < 0.0lf));
                                                                let _e2717 = select(_e2708[1], -(_e2708[1]), (_e2708[1] < 0.0lf));
                                                                let _e2719 = select(_e2717, _e2714, (_e2714 > _e2717));
                                                                let _e2722 = select(_e2708[2], -(_e2708[2]), (_e2708[2] < 0.0lf));
                                                                let _e2724 = select(_e2722, _e2719, (_e2719 > _e2722));
                                                                let _e2728 = local_5.member_3;
                                                                let _e2732 = local_5.member_2[0u];
                                                                let _e2738 = select(_e2732[0], -(_e2732[0]), (_e2732[0] < 0.0lf));
                                                                let _e2741 = select(_e2732[1], -(_e2732[1]), (_e2732[1] < 0.0lf));
                                                                let _e2743 = select(_e2741, _e2738, (_e2738 > _e2741));
                                                                let _e2746 = select(_e2732[2], -(_e2732[2]), (_e2732[2] < 0.0lf));
                                                                let _e2748 = select(_e2746, _e2743, (_e2743 > _e2746));
                                                                let _e2751 = local_5.member_2[1u];
                                                                let _e2757 = select(_e2751[0], -(_e2751[0]), (_e2751[0] < 0.0lf));
                                                                let _e2760 = select(_e2751[1], -(_e2751[1]), (_e2751[1] < 0.0lf));
                                                                let _e2762 = select(_e2760, _e2757, (_e2757 > _e2760));
                                                                let _e2765 = select(_e2751[2], -(_e2751[2]), (_e2751[2] < 0.0lf));
                                                                let _e2767 = select(_e2765, _e2762, (_e2762 > _e2765));
                                                                let _e2771 = local_5.member_3;
                                                                let _e2779 = local_5.member_3;
                                                                phi_5310_ = select(true, false, (((_e2638 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e2681, _e2662, (_e2662 > _e2681)) + _e2685) + (select(_e2724, _e2705, (_e2705 > _e2724)) + _e2728)) + (select(_e2767, _e2748, (_e2748 > _e2767)) + _e2771)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2779 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e775.member_1));
                                                            } else {
                                                                phi_5310_ = true;
                                                            }
                                                            let _e2792 = phi_5310_;
                                                            phi_5311_ = _e2792;
                                                        } else {
                                                            phi_5311_ = true;
                                                        }
                                                        let _e2794 = phi_5311_;
                                                        if _e2794 {
                                                            if _e1758 {
                                                                let _e2798 = (_e2504 <= (_e1754 * f64(0.25f)));
                                                                phi_5338_ = select(select(select(f64(), f64(0f), _e2798), f64(), _e2505), (_e2060 + _e2060), select(select(true, false, _e2798), true, _e2505));
                                                            } else {
                                                                phi_5338_ = (_e545 - _e1750);
                                                            }
                                                            let _e2807 = phi_5338_;
                                                            phi_5339_ = _e2807;
                                                            phi_5340_ = false;
                                                        } else {
                                                            phi_5339_ = f64();
                                                            phi_5340_ = true;
                                                        }
                                                        let _e2809 = phi_5339_;
                                                        let _e2811 = phi_5340_;
                                                        phi_5341_ = _e2809;
                                                        phi_5342_ = _e2504;
                                                        phi_5343_ = _e2794;
                                                        phi_5344_ = _e2811;
                                                    }
                                                    let _e2813 = phi_5341_;
                                                    let _e2815 = phi_5342_;
                                                    let _e2817 = phi_5343_;
                                                    let _e2819 = phi_5344_;
                                                    phi_5345_ = _e2502;
                                                    phi_5346_ = _e2813;
                                                    phi_5347_ = _e2815;
                                                    phi_5348_ = _e2502;
                                                    phi_5349_ = _e2817;
                                                    phi_5350_ = _e2503;
                                                    phi_5351_ = _e2819;
                                                    phi_5352_ = false;
                                                } else {
                                                    phi_5345_ = f64();
                                                    phi_5346_ = f64();
                                                    phi_5347_ = f64();
                                                    phi_5348_ = f64();
                                                    phi_5349_ = false;
                                                    phi_5350_ = false;
                                                    phi_5351_ = false;
                                                    phi_5352_ = true;
                                                }
                                                let _e2821 = phi_5345_;
                                                let _e2823 = phi_5346_;
                                                let _e2825 = phi_5347_;
                                                let _e2827 = phi_5348_;
                                                let _e2829 = phi_5349_;
                                                let _e2831 = phi_5350_;
                                                let _e2833 = phi_5351_;
                                                let _e2835 = phi_5352_;
                                                phi_5353_ = _e2821;
                                                phi_5354_ = _e2823;
                                                phi_5355_ = _e2825;
                                                phi_5356_ = _e2827;
                                                phi_5357_ = false;
                                                phi_5358_ = _e2829;
                                                phi_5359_ = _e2831;
                                                phi_5360_ = _e2833;
                                                phi_5361_ = _e2835;
                                            } else {
                                                phi_5353_ = f64();
                                                phi_5354_ = f64();
                                                phi_5355_ = f64();
                                                phi_5356_ = f64();
                                                phi_5357_ = true;
                                                phi_5358_ = false;
                                                phi_5359_ = false;
                                                phi_5360_ = false;
                                                phi_5361_ = false;
                                            }
                                            let _e2837 = phi_5353_;
                                            let _e2839 = phi_5354_;
                                            let _e2841 = phi_5355_;
                                            let _e2843 = phi_5356_;
                                            let _e2845 = phi_5357_;
                                            let _e2847 = phi_5358_;
                                            let _e2849 = phi_5359_;
                                            let _e2851 = phi_5360_;
                                            let _e2853 = phi_5361_;
                                            phi_5362_ = _e2837;
                                            phi_5363_ = _e2839;
                                            phi_5364_ = _e2841;
                                            phi_5365_ = _e2843;
                                            phi_5366_ = _e2845;
                                            phi_5367_ = _e2847;
                                            phi_5368_ = _e2849;
                                            phi_5369_ = _e2851;
                                            phi_5370_ = _e2853;
                                        } else {
                                            phi_5362_ = f64();
                                            phi_5363_ = f64();
                                            phi_5364_ = f64();
                                            phi_5365_ = f64();
                                            phi_5366_ = true;
                                            phi_5367_ = false;
                                            phi_5368_ = false;
                                            phi_5369_ = false;
                                            phi_5370_ = false;
                                        }
                                        let _e2855 = phi_5362_;
                                        let _e2857 = phi_5363_;
                                        let _e2859 = phi_5364_;
                                        let _e2861 = phi_5365_;
                                        let _e2863 = phi_5366_;
                                        let _e2865 = phi_5367_;
                                        let _e2867 = phi_5368_;
                                        let _e2869 = phi_5369_;
                                        let _e2871 = phi_5370_;
                                        if _e2863 {
                                            if (_e1750 <= _e1752) {
                                                let _e3029 = (_e1760 + 1u);
                                                let _e3030 = (_e3029 > 3u);
                                                phi_5710_ = _e3029;
                                                phi_5711_ = f64();
                                                phi_5712_ = false;
                                                phi_5713_ = select(true, false, _e3030);
                                                phi_5714_ = _e3030;
                                            } else {
                                                let _e2875 = local_3.member[0u];
                                                let _e2878 = local_3.member_1[0u];
                                                let _e2881 = local_3.member[0u];
                                                let _e2887 = local_3.member_2[0u];
                                                let _e2888 = ((_e2875 + ((_e2878 - _e2881) * _e1756)) - _e2887);
                                                let _e2891 = local_3.member[1u];
                                                let _e2894 = local_3.member_1[1u];
                                                let _e2897 = local_3.member[1u];
                                                let _e2903 = local_3.member_2[1u];
                                                let _e2904 = ((_e2891 + ((_e2894 - _e2897) * _e1756)) - _e2903);
                                                let _e2906 = select(_e2904, _e2888, (_e2888 < _e2904));
                                                let _e2909 = local_3.member[2u];
                                                let _e2912 = local_3.member_1[2u];
                                                let _e2915 = local_3.member[2u];
                                                let _e2921 = local_3.member_2[2u];
                                                let _e2922 = ((_e2909 + ((_e2912 - _e2915) * _e1756)) - _e2921);
                                                let _e2925 = local_3.member[3u];
                                                let _e2928 = local_3.member_1[3u];
                                                let _e2931 = local_3.member[3u];
                                                let _e2937 = local_3.member_2[3u];
                                                let _e2938 = ((_e2925 + ((_e2928 - _e2931) * _e1756)) - _e2937);
                                                let _e2940 = select(_e2938, _e2922, (_e2922 < _e2938));
                                                let _e2942 = select(_e2940, _e2906, (_e2906 < _e2940));
                                                let _e2945 = local_4.member[0u];
                                                let _e2948 = local_4.member_1[0u];
                                                let _e2951 = local_4.member[0u];
                                                let _e2957 = local_4.member_2[0u];
                                                let _e2958 = ((_e2945 + ((_e2948 - _e2951) * _e1750)) - _e2957);
                                                let _e2961 = local_4.member[1u];
                                                let _e2964 = local_4.member_1[1u];
                                                let _e2967 = local_4.member[1u];
                                                let _e2973 = local_4.member_2[1u];
                                                let _e2974 = ((_e2961 + ((_e2964 - _e2967) * _e1750)) - _e2973);
                                                let _e2976 = select(_e2974, _e2958, (_e2958 < _e2974));
                                                let _e2979 = local_4.member[2u];
                                                let _e2982 = local_4.member_1[2u];
                                                let _e2985 = local_4.member[2u];
                                                let _e2991 = local_4.member_2[2u];
                                                let _e2992 = ((_e2979 + ((_e2982 - _e2985) * _e1750)) - _e2991);
                                                let _e2995 = local_4.member[3u];
                                                let _e2998 = local_4.member_1[3u];
                                                let _e3001 = local_4.member[3u];
                                                let _e3007 = local_4.member_2[3u];
                                                let _e3008 = ((_e2995 + ((_e2998 - _e3001) * _e1750)) - _e3007);
                                                let _e3010 = select(_e3008, _e2992, (_e2992 < _e3008));
                                                let _e3012 = select(_e3010, _e2976, (_e2976 < _e3010));
                                                let _e3013 = f64(0.0625f);
                                                let _e3015 = f64(0.9f);
                                                if (_e3012 > f64(0f)) {
                                                    phi_5708_ = f64(0.5f);
                                                } else {
                                                    let _e3021 = (f64(0.95f) * (_e2942 / (_e2942 - _e3012)));
                                                    phi_5708_ = select(_e3013, select(_e3015, _e3021, (_e3021 < _e3015)), (_e3021 > _e3013));
                                                }
                                                let _e3027 = phi_5708_;
                                                phi_5710_ = u32();
                                                phi_5711_ = (_e2060 * _e3027);
                                                phi_5712_ = true;
                                                phi_5713_ = false;
                                                phi_5714_ = false;
                                            }
                                            let _e3033 = phi_5710_;
                                            let _e3035 = phi_5711_;
                                            let _e3037 = phi_5712_;
                                            let _e3039 = phi_5713_;
                                            let _e3041 = phi_5714_;
                                            phi_5715_ = _e3033;
                                            phi_5716_ = _e1752;
                                            phi_5717_ = _e3035;
                                            phi_5718_ = _e1754;
                                            phi_5719_ = _e1756;
                                            phi_5720_ = _e1758;
                                            phi_5721_ = _e1760;
                                            phi_5722_ = _e3037;
                                            phi_5723_ = _e3039;
                                            phi_5724_ = _e3041;
                                            phi_5725_ = false;
                                            phi_5726_ = false;
                                            phi_5727_ = false;
                                        } else {
                                            phi_5715_ = u32();
                                            phi_5716_ = _e2855;
                                            phi_5717_ = _e2857;
                                            phi_5718_ = _e2859;
                                            phi_5719_ = _e1750;
                                            phi_5720_ = true;
                                            phi_5721_ = 0u;
                                            phi_5722_ = _e2865;
                                            phi_5723_ = false;
                                            phi_5724_ = false;
                                            phi_5725_ = _e2867;
                                            phi_5726_ = _e2869;
                                            phi_5727_ = _e2871;
                                        }
                                        let _e3043 = phi_5715_;
                                        let _e3045 = phi_5716_;
                                        let _e3047 = phi_5717_;
                                        let _e3049 = phi_5718_;
                                        let _e3051 = phi_5719_;
                                        let _e3053 = phi_5720_;
                                        let _e3055 = phi_5721_;
                                        let _e3057 = phi_5722_;
                                        let _e3059 = phi_5723_;
                                        let _e3061 = phi_5724_;
                                        let _e3063 = phi_5725_;
                                        let _e3065 = phi_5726_;
                                        let _e3067 = phi_5727_;
                                        if _e3057 {
                                            let _e3068 = (_e3051 + _e3047);
                                            let _e3070 = select(_e3045, _e3068, (_e3068 > _e3045));
                                            let _e3072 = select(_e545, _e3070, (_e3070 < _e545));
                                            let _e3075 = select(((_e3072 - _e3051) > _e1739), true, !(_e1758));
                                            phi_5755_ = _e3072;
                                            phi_5756_ = _e3045;
                                            phi_5757_ = _e3049;
                                            phi_5758_ = _e3051;
                                            phi_5759_ = _e3053;
                                            phi_5760_ = _e3055;
                                            phi_5761_ = _e3075;
                                            phi_5762_ = select(true, false, _e3075);
                                            phi_5763_ = false;
                                            phi_5764_ = false;
                                            phi_5765_ = false;
                                            phi_5766_ = false;
                                        } else {
                                            phi_5755_ = _e1750;
                                            phi_5756_ = _e1752;
                                            phi_5757_ = _e1754;
                                            phi_5758_ = _e1756;
                                            phi_5759_ = _e1758;
                                            phi_5760_ = _e3043;
                                            phi_5761_ = _e3059;
                                            phi_5762_ = false;
                                            phi_5763_ = _e3061;
                                            phi_5764_ = _e3063;
                                            phi_5765_ = _e3065;
                                            phi_5766_ = _e3067;
                                        }
                                        let _e3078 = phi_5755_;
                                        let _e3080 = phi_5756_;
                                        let _e3082 = phi_5757_;
                                        let _e3084 = phi_5758_;
                                        let _e3086 = phi_5759_;
                                        let _e3088 = phi_5760_;
                                        let _e3090 = phi_5761_;
                                        let _e3092 = phi_5762_;
                                        let _e3094 = phi_5763_;
                                        let _e3096 = phi_5764_;
                                        let _e3098 = phi_5765_;
                                        let _e3100 = phi_5766_;
                                        phi_3545_ = _e3078;
                                        phi_3547_ = _e3080;
                                        phi_3549_ = _e3082;
                                        phi_3551_ = _e3084;
                                        phi_3553_ = _e3086;
                                        phi_3555_ = _e3088;
                                        phi_5767_ = _e3045;
                                        phi_5768_ = _e2861;
                                        phi_5769_ = _e3090;
                                        phi_5770_ = _e3092;
                                        phi_5771_ = _e3094;
                                        phi_5772_ = _e3096;
                                        phi_5773_ = _e3098;
                                        phi_5774_ = false;
                                        phi_5775_ = _e3100;
                                    } else {
                                        phi_3545_ = f64();
                                        phi_3547_ = f64();
                                        phi_3549_ = f64();
                                        phi_3551_ = f64();
                                        phi_3553_ = bool();
                                        phi_3555_ = u32();
                                        phi_5767_ = f64();
                                        phi_5768_ = f64();
                                        phi_5769_ = false;
                                        phi_5770_ = false;
                                        phi_5771_ = false;
                                        phi_5772_ = false;
                                        phi_5773_ = false;
                                        phi_5774_ = true;
                                        phi_5775_ = false;
                                    }
                                    let _e3102 = phi_3545_;
                                    let _e3104 = phi_3547_;
                                    let _e3106 = phi_3549_;
                                    let _e3108 = phi_3551_;
                                    let _e3110 = phi_3553_;
                                    let _e3112 = phi_3555_;
                                    let _e3114 = phi_5767_;
                                    let _e3116 = phi_5768_;
                                    let _e3118 = phi_5769_;
                                    let _e3120 = phi_5770_;
                                    let _e3122 = phi_5771_;
                                    let _e3124 = phi_5772_;
                                    let _e3126 = phi_5773_;
                                    let _e3128 = phi_5774_;
                                    let _e3130 = phi_5775_;
                                    local_9 = _e3120;
                                    local_10 = _e3122;
                                    local_11 = _e3120;
                                    local_12 = _e3124;
                                    local_13 = _e3120;
                                    local_14 = _e3126;
                                    local_15 = _e3120;
                                    local_16 = _e3128;
                                    local_17 = _e3120;
                                    local_18 = _e3130;
                                    local_20 = _e3120;
                                    local_21 = _e3116;
                                    local_22 = _e3114;
                                    continue;
                                    continuing {
                                        phi_3541_ = type_9(select(_e1748.member, (_e1748.member + 1u), _e1763), select(_e1748.member_1, _e1748.member_1, _e1763));
                                        phi_3544_ = _e3102;
                                        phi_3546_ = _e3104;
                                        phi_3548_ = _e3106;
                                        phi_3550_ = _e3108;
                                        phi_3552_ = _e3110;
                                        phi_3554_ = _e3112;
                                        break if !(_e3118);
                                    }
                                }
                                let _e3133 = local_9;
                                let _e3135 = local_10;
                                let _e3136 = select(_e3135, false, _e3133);
                                let _e3138 = local_11;
                                let _e3140 = local_12;
                                let _e3143 = local_13;
                                let _e3145 = local_14;
                                let _e3148 = local_15;
                                let _e3150 = local_16;
                                let _e3153 = local_17;
                                let _e3155 = local_18;
                                let _e3161 = local_19;
                                let _e3163 = select(select(_e3140, false, _e3138), false, _e3136);
                                let _e3166 = local_20;
                                let _e3173 = select(select(select(_e3145, false, _e3143), false, _e3136), false, _e3163);
                                let _e3179 = local_21;
                                let _e3181 = local_22;
                                let _e3183 = select(select(select(_e3166, false, _e3136), false, _e3163), true, _e3173);
                                let _e3188 = local_23;
                                let _e3190 = select(select(select(select(select(_e3150, false, _e3148), false, _e3136), false, _e3163), false, _e3173), true, _e3183);
                                let _e3197 = select(select(select(select(select(select(_e3155, false, _e3153), false, _e3136), false, _e3163), false, _e3173), false, _e3183), false, _e3190);
                                let _e3202 = select(select(select(select(select(_e3136, true, _e3163), false, _e3173), false, _e3183), false, _e3190), true, _e3197);
                                phi_5842_ = select(select(type_38().member_1, select(_e3188, select(_e3181, _e3179, _e3173), _e3183), _e3190), select(select(select(type_38().member_1, _e3161, _e3136), type_38().member_1, _e3163), type_38().member_1, _e3197), _e3202);
                                phi_5843_ = (select(select(type_38().member, 1u, _e3190), select(select(select(type_38().member, 1u, _e3136), 0u, _e3163), 0u, _e3197), _e3202) != 0u);
                            } else {
                                phi_5842_ = _e1502;
                                phi_5843_ = true;
                            }
                            let _e3207 = phi_5842_;
                            let _e3209 = phi_5843_;
                            if _e3209 {
                                let _e3210 = (_e3207 > _e536);
                                if _e3210 {
                                    phi_8050_ = f64();
                                    phi_8051_ = u32();
                                    phi_8052_ = f64();
                                    phi_8053_ = type_42();
                                    phi_8054_ = u32();
                                    phi_8055_ = u32();
                                    phi_8056_ = false;
                                    phi_8057_ = false;
                                    phi_8058_ = false;
                                } else {
                                    let _e3214 = local_5.member[0u];
                                    let _e3220 = local_5.member[1u];
                                    let _e3236 = local_5.member_1[0u];
                                    let _e3242 = local_5.member_1[1u];
                                    let _e3258 = local_5.member_2[0u];
                                    let _e3264 = local_5.member_2[1u];
                                    let _e3278 = function_3(array<f64, 3>((_e3214[0] + ((_e3220[0] - _e3214[0]) * _e1506)), (_e3214[1] + ((_e3220[1] - _e3214[1]) * _e1506)), (_e3214[2] + ((_e3220[2] - _e3214[2]) * _e1506))), array<f64, 3>((_e3236[0] + ((_e3242[0] - _e3236[0]) * _e1506)), (_e3236[1] + ((_e3242[1] - _e3236[1]) * _e1506)), (_e3236[2] + ((_e3242[2] - _e3236[2]) * _e1506))), array<f64, 3>((_e3258[0] + ((_e3264[0] - _e3258[0]) * _e1506)), (_e3258[1] + ((_e3264[1] - _e3258[1]) * _e1506)), (_e3258[2] + ((_e3264[2] - _e3258[2]) * _e1506))), _e224.member);
                                    let _e3292 = ((select(_e3278[0], -(_e3278[0]), (_e3278[0] < 0.0lf)) + select(_e3278[1], -(_e3278[1]), (_e3278[1] < 0.0lf))) + select(_e3278[2], -(_e3278[2]), (_e3278[2] < 0.0lf)));
                                    let _e3295 = local_5.member[0u];
                                    let _e3301 = local_5.member_1[0u];
                                    let _e3307 = local_5.member_2[0u];
                                    let _e3311 = (_e3295[0] - _e3301[0]);
                                    let _e3312 = (_e3295[1] - _e3301[1]);
                                    let _e3313 = (_e3295[2] - _e3301[2]);
                                    let _e3314 = (_e224.member == 0u);
                                    let _e3326 = local_5.member[1u];
                                    let _e3332 = local_5.member_1[1u];
                                    let _e3338 = local_5.member_2[1u];
                                    let _e3342 = (_e3326[0] - _e3332[0]);
                                    let _e3343 = (_e3326[1] - _e3332[1]);
                                    let _e3344 = (_e3326[2] - _e3332[2]);
                                    let _e3345 = (_e224.member == 0u);
                                    let _e3357 = local_5.member[0u];
                                    let _e3363 = select(_e3357[0], -(_e3357[0]), (_e3357[0] < 0.0lf));
                                    let _e3366 = select(_e3357[1], -(_e3357[1]), (_e3357[1] < 0.0lf));
                                    let _e3368 = select(_e3366, _e3363, (_e3363 > _e3366));
                                    let _e3371 = select(_e3357[2], -(_e3357[2]), (_e3357[2] < 0.0lf));
                                    let _e3373 = select(_e3371, _e3368, (_e3368 > _e3371));
                                    let _e3376 = local_5.member[1u];
                                    let _e3382 = select(_e3376[0], -(_e3376[0]), (_e3376[0] < 0.0lf));
                                    let _e3385 = select(_e3376[1], -(_e3376[1]), (_e3376[1] < 0.0lf));
                                    let _e3387 = select(_e3385, _e3382, (_e3382 > _e3385));
                                    let _e3390 = select(_e3376[2], -(_e3376[2]), (_e3376[2] < 0.0lf));
                                    let _e3392 = select(_e3390, _e3387, (_e3387 > _e3390));
                                    let _e3396 = local_5.member_3;
                                    let _e3400 = local_5.member_1[0u];
                                    let _e3406 = select(_e3400[0], -(_e3400[0]), (_e3400[0] < 0.0lf));
                                    let _e3409 = select(_e3400[1], -(_e3400[1]), (_e3400[1] < 0.0lf));
                                    let _e3411 = select(_e3409, _e3406, (_e3406 > _e3409));
                                    let _e3414 = select(_e3400[2], -(_e3400[2]), (_e3400[2] < 0.0lf));
                                    let _e3416 = select(_e3414, _e3411, (_e3411 > _e3414));
                                    let _e3419 = local_5.member_1[1u];
                                    let _e3425 = select(_e3419[0], -(_e3419[0]), (_e3419[0] < 0.0lf));
                                    let _e3428 = select(_e3419[1], -(_e3419[1]), (_e3419[1] < 0.0lf));
                                    let _e3430 = select(_e3428, _e3425, (_e3425 > _e3428));
                                    let _e3433 = select(_e3419[2], -(_e3419[2]), (_e3419[2] < 0.0lf));
                                    let _e3435 = select(_e3433, _e3430, (_e3430 > _e3433));
                                    let _e3439 = local_5.member_3;
                                    let _e3443 = local_5.member_2[0u];
                                    let _e3449 = select(_e3443[0], -(_e3443[0]), (_e3443[0] < 0.0lf));
                                    let _e3452 = select(_e3443[1], -(_e3443[1]), (_e3443[1] < 0.0lf));
                                    let _e3454 = select(_e3452, _e3449, (_e3449 > _e3452));
                                    let _e3457 = select(_e3443[2], -(_e3443[2]), (_e3443[2] < 0.0lf));
                                    let _e3459 = select(_e3457, _e3454, (_e3454 > _e3457));
                                    let _e3462 = local_5.member_2[1u];
                                    let _e3468 = select(_e3462[0], -(_e3462[0]), (_e3462[0] < 0.0lf));
                                    let _e3471 = select(_e3462[1], -(_e3462[1]), (_e3462[1] < 0.0lf));
                                    let _e3473 = select(_e3471, _e3468, (_e3468 > _e3471));
                                    let _e3476 = select(_e3462[2], -(_e3462[2]), (_e3462[2] < 0.0lf));
                                    let _e3478 = select(_e3476, _e3473, (_e3473 > _e3476));
                                    let _e3482 = local_5.member_3;
                                    let _e3490 = local_5.member_3;
                                    local_1 = type_41(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e3295, array<f64, 3>(_e3311, _e3312, _e3313), array<f64, 3>((_e3295[0] - _e3307[0]), (_e3295[1] - _e3307[1]), (_e3295[2] - _e3307[2])), array<f64, 3>(select((_e3311 - _e3307[0]), _e3295[0], _e3314), select((_e3312 - _e3307[1]), _e3295[1], _e3314), select((_e3313 - _e3307[2]), _e3295[2], _e3314))), array<array<f64, 3>, 4>(_e3326, array<f64, 3>(_e3342, _e3343, _e3344), array<f64, 3>((_e3326[0] - _e3338[0]), (_e3326[1] - _e3338[1]), (_e3326[2] - _e3338[2])), array<f64, 3>(select((_e3342 - _e3338[0]), _e3326[0], _e3345), select((_e3343 - _e3338[1]), _e3326[1], _e3345), select((_e3344 - _e3338[2]), _e3326[2], _e3345)))), ((((((select(_e3392, _e3373, (_e3373 > _e3392)) + _e3396) + (select(_e3435, _e3416, (_e3416 > _e3435)) + _e3439)) + (select(_e3478, _e3459, (_e3459 > _e3478)) + _e3482)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3490 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e775.member_1);
                                    let _e3508 = local_1.member_1;
                                    if (_e3292 > _e3508) {
                                        if ((bitcast<u64>(_e3292) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e3514 = (f64(1f) / _e3292);
                                            let _e3516 = (_e3278[0] * _e3514);
                                            let _e3518 = (_e3278[1] * _e3514);
                                            let _e3520 = (_e3278[2] * _e3514);
                                            let _e3525 = (((_e3516 * _e3516) + (_e3518 * _e3518)) + (_e3520 * _e3520));
                                            if (_e3525 <= 2.2250738585072014e-308lf) {
                                                phi_6525_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3525 > 0.0lf));
                                            } else {
                                                phi_6468_ = type_18(0i, 5i);
                                                phi_6471_ = bitcast<f64>(((bitcast<u64>(_e3525) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3532 = phi_6468_;
                                                    let _e3534 = phi_6471_;
                                                    local_24 = _e3534;
                                                    if (_e3532.member < _e3532.member_1) {
                                                        let _e3541 = (_e3532.member + 1i);
                                                        phi_6469_ = type_18(select(_e3541, type_19().member_1, select(false, true, ((false == (_e3541 > _e3532.member)) != false))), _e3532.member_1);
                                                        phi_6512_ = type_19(1u, _e3532.member);
                                                    } else {
                                                        phi_6469_ = _e3532;
                                                        phi_6512_ = type_19(0u, type_19().member_1);
                                                    }
                                                    let _e3552 = phi_6469_;
                                                    let _e3554 = phi_6512_;
                                                    let _e3557 = (bitcast<i32>(_e3554.member) != 0i);
                                                    if _e3557 {
                                                        phi_6472_ = (0.5lf * (_e3534 + (_e3525 / _e3534)));
                                                    } else {
                                                        phi_6472_ = f64();
                                                    }
                                                    let _e3562 = phi_6472_;
                                                    continue;
                                                    continuing {
                                                        phi_6468_ = _e3552;
                                                        phi_6471_ = _e3562;
                                                        break if !(_e3557);
                                                    }
                                                }
                                                let _e3567 = local_24;
                                                phi_6525_ = (_e3567 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3573 = phi_6525_;
                                            let _e3575 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e3577 = local_1.member_1;
                                            let _e3581 = local_1.member_2;
                                            let _e3586 = ((_e3577 * f64(1.01f)) + ((_e3581 * _e3573) * (f64(1f) + _e3575)));
                                            let _e3590 = local_1.member[0u][0u];
                                            let _e3598 = (((_e3516 * _e3590[0]) + (_e3518 * _e3590[1])) + (_e3520 * _e3590[2]));
                                            let _e3602 = local_1.member[0u][1u];
                                            let _e3610 = (((_e3516 * _e3602[0]) + (_e3518 * _e3602[1])) + (_e3520 * _e3602[2]));
                                            let _e3614 = local_1.member[0u][2u];
                                            let _e3622 = (((_e3516 * _e3614[0]) + (_e3518 * _e3614[1])) + (_e3520 * _e3614[2]));
                                            let _e3626 = local_1.member[0u][3u];
                                            let _e3634 = (((_e3516 * _e3626[0]) + (_e3518 * _e3626[1])) + (_e3520 * _e3626[2]));
                                            let _e3638 = local_1.member[1u][0u];
                                            let _e3646 = (((_e3516 * _e3638[0]) + (_e3518 * _e3638[1])) + (_e3520 * _e3638[2]));
                                            let _e3650 = local_1.member[1u][1u];
                                            let _e3658 = (((_e3516 * _e3650[0]) + (_e3518 * _e3650[1])) + (_e3520 * _e3650[2]));
                                            let _e3662 = local_1.member[1u][2u];
                                            let _e3670 = (((_e3516 * _e3662[0]) + (_e3518 * _e3662[1])) + (_e3520 * _e3662[2]));
                                            let _e3674 = local_1.member[1u][3u];
                                            let _e3682 = (((_e3516 * _e3674[0]) + (_e3518 * _e3674[1])) + (_e3520 * _e3674[2]));
                                            local_2 = type_36(array<f64, 4>(_e3598, _e3610, _e3622, _e3634), array<f64, 4>(_e3646, _e3658, _e3670, _e3682), array<f64, 4>((_e3586 + ((select(_e3598, -(_e3598), (_e3598 < 0.0lf)) + select(_e3646, -(_e3646), (_e3646 < 0.0lf))) * _e3575)), (_e3586 + ((select(_e3610, -(_e3610), (_e3610 < 0.0lf)) + select(_e3658, -(_e3658), (_e3658 < 0.0lf))) * _e3575)), (_e3586 + ((select(_e3622, -(_e3622), (_e3622 < 0.0lf)) + select(_e3670, -(_e3670), (_e3670 < 0.0lf))) * _e3575)), (_e3586 + ((select(_e3634, -(_e3634), (_e3634 < 0.0lf)) + select(_e3682, -(_e3682), (_e3682 < 0.0lf))) * _e3575))));
                                            let _e3727 = (((_e3516 * _e3516) + (_e3518 * _e3518)) + (_e3520 * _e3520));
                                            if (_e3727 <= 2.2250738585072014e-308lf) {
                                                phi_6820_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3727 > 0.0lf));
                                            } else {
                                                phi_6763_ = type_18(0i, 5i);
                                                phi_6766_ = bitcast<f64>(((bitcast<u64>(_e3727) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3734 = phi_6763_;
                                                    let _e3736 = phi_6766_;
                                                    local_25 = _e3736;
                                                    if (_e3734.member < _e3734.member_1) {
                                                        let _e3743 = (_e3734.member + 1i);
                                                        phi_6764_ = type_18(select(_e3743, type_19().member_1, select(false, true, ((false == (_e3743 > _e3734.member)) != false))), _e3734.member_1);
                                                        phi_6807_ = type_19(1u, _e3734.member);
                                                    } else {
                                                        phi_6764_ = _e3734;
                                                        phi_6807_ = type_19(0u, type_19().member_1);
                                                    }
                                                    let _e3754 = phi_6764_;
                                                    let _e3756 = phi_6807_;
                                                    let _e3759 = (bitcast<i32>(_e3756.member) != 0i);
                                                    if _e3759 {
                                                        phi_6767_ = (0.5lf * (_e3736 + (_e3727 / _e3736)));
                                                    } else {
                                                        phi_6767_ = f64();
                                                    }
                                                    let _e3764 = phi_6767_;
                                                    continue;
                                                    continuing {
                                                        phi_6763_ = _e3754;
                                                        phi_6766_ = _e3764;
                                                        break if !(_e3759);
                                                    }
                                                }
                                                let _e3769 = local_25;
                                                phi_6820_ = (_e3769 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3775 = phi_6820_;
                                            let _e3786 = (((_e3278[0] * _e3278[0]) + (_e3278[1] * _e3278[1])) + (_e3278[2] * _e3278[2]));
                                            if (_e3786 <= 2.2250738585072014e-308lf) {
                                                phi_6909_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3786 > 0.0lf));
                                            } else {
                                                phi_6852_ = type_18(0i, 5i);
                                                phi_6855_ = bitcast<f64>(((bitcast<u64>(_e3786) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3793 = phi_6852_;
                                                    let _e3795 = phi_6855_;
                                                    local_26 = _e3795;
                                                    if (_e3793.member < _e3793.member_1) {
                                                        let _e3802 = (_e3793.member + 1i);
                                                        phi_6853_ = type_18(select(_e3802, type_19().member_1, select(false, true, ((false == (_e3802 > _e3793.member)) != false))), _e3793.member_1);
                                                        phi_6896_ = type_19(1u, _e3793.member);
                                                    } else {
                                                        phi_6853_ = _e3793;
                                                        phi_6896_ = type_19(0u, type_19().member_1);
                                                    }
                                                    let _e3813 = phi_6853_;
                                                    let _e3815 = phi_6896_;
                                                    let _e3818 = (bitcast<i32>(_e3815.member) != 0i);
                                                    if _e3818 {
                                                        phi_6856_ = (0.5lf * (_e3795 + (_e3786 / _e3795)));
                                                    } else {
                                                        phi_6856_ = f64();
                                                    }
                                                    let _e3823 = phi_6856_;
                                                    continue;
                                                    continuing {
                                                        phi_6852_ = _e3813;
                                                        phi_6855_ = _e3823;
                                                        break if !(_e3818);
                                                    }
                                                }
                                                let _e3828 = local_26;
                                                phi_6909_ = (_e3828 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3834 = phi_6909_;
                                            let _e3842 = local_5.member[0u];
                                            let _e3848 = select(_e3842[0], -(_e3842[0]), (_e3842[0] < 0.0lf));
                                            let _e3851 = select(_e3842[1], -(_e3842[1]), (_e3842[1] < 0.0lf));
                                            let _e3853 = select(_e3851, _e3848, (_e3848 > _e3851));
                                            let _e3856 = select(_e3842[2], -(_e3842[2]), (_e3842[2] < 0.0lf));
                                            let _e3858 = select(_e3856, _e3853, (_e3853 > _e3856));
                                            let _e3861 = local_5.member[1u];
                                            let _e3867 = select(_e3861[0], -(_e3861[0]), (_e3861[0] < 0.0lf));
                                            let _e3870 = select(_e3861[1], -(_e3861[1]), (_e3861[1] < 0.0lf));
                                            let _e3872 = select(_e3870, _e3867, (_e3867 > _e3870));
                                            let _e3875 = select(_e3861[2], -(_e3861[2]), (_e3861[2] < 0.0lf));
                                            let _e3877 = select(_e3875, _e3872, (_e3872 > _e3875));
                                            let _e3881 = local_5.member_3;
                                            let _e3885 = local_5.member_1[0u];
                                            let _e3891 = select(_e3885[0], -(_e3885[0]), (_e3885[0] < 0.0lf));
                                            let _e3894 = select(_e3885[1], -(_e3885[1]), (_e3885[1] < 0.0lf));
                                            let _e3896 = select(_e3894, _e3891, (_e3891 > _e3894));
                                            let _e3899 = select(_e3885[2], -(_e3885[2]), (_e3885[2] < 0.0lf));
                                            let _e3901 = select(_e3899, _e3896, (_e3896 > _e3899));
                                            let _e3904 = local_5.member_1[1u];
                                            let _e3910 = select(_e3904[0], -(_e3904[0]), (_e3904[0] < 0.0lf));
                                            let _e3913 = select(_e3904[1], -(_e3904[1]), (_e3904[1] < 0.0lf));
                                            let _e3915 = select(_e3913, _e3910, (_e3910 > _e3913));
                                            let _e3918 = select(_e3904[2], -(_e3904[2]), (_e3904[2] < 0.0lf));
                                            let _e3920 = select(_e3918, _e3915, (_e3915 > _e3918));
                                            let _e3924 = local_5.member_3;
                                            let _e3928 = local_5.member_2[0u];
                                            let _e3934 = select(_e3928[0], -(_e3928[0]), (_e3928[0] < 0.0lf));
                                            let _e3937 = select(_e3928[1], -(_e3928[1]), (_e3928[1] < 0.0lf));
                                            let _e3939 = select(_e3937, _e3934, (_e3934 > _e3937));
                                            let _e3942 = select(_e3928[2], -(_e3928[2]), (_e3928[2] < 0.0lf));
                                            let _e3944 = select(_e3942, _e3939, (_e3939 > _e3942));
                                            let _e3947 = local_5.member_2[1u];
                                            let _e3953 = select(_e3947[0], -(_e3947[0]), (_e3947[0] < 0.0lf));
                                            let _e3956 = select(_e3947[1], -(_e3947[1]), (_e3947[1] < 0.0lf));
                                            let _e3958 = select(_e3956, _e3953, (_e3953 > _e3956));
                                            let _e3961 = select(_e3947[2], -(_e3947[2]), (_e3947[2] < 0.0lf));
                                            let _e3963 = select(_e3961, _e3958, (_e3958 > _e3961));
                                            let _e3967 = local_5.member_3;
                                            let _e3975 = local_5.member_3;
                                            let _e3990 = ((((_e3834 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e3877, _e3858, (_e3858 > _e3877)) + _e3881) + (select(_e3920, _e3901, (_e3901 > _e3920)) + _e3924)) + (select(_e3963, _e3944, (_e3944 > _e3963)) + _e3967)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3975 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e3775) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                            let _e3993 = local_2.member[0u];
                                            let _e3996 = local_2.member_1[0u];
                                            phi_7227_ = type_9(1u, 4u);
                                            phi_7230_ = ((_e3993 + ((_e3996 - _e3993) * _e1506)) - ((_e3508 * f64(1.01f)) + ((select(_e3993, -(_e3993), (_e3993 < 0.0lf)) + select(_e3996, -(_e3996), (_e3996 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f)))));
                                            loop {
                                                let _e4015 = phi_7227_;
                                                let _e4017 = phi_7230_;
                                                local_27 = _e4017;
                                                local_28 = _e4017;
                                                let _e4020 = (_e4015.member < _e4015.member_1);
                                                let _e4031 = select(type_9().member_1, _e4015.member, _e4020);
                                                let _e4033 = (bitcast<i32>(select(0u, 1u, _e4020)) != 0i);
                                                if _e4033 {
                                                    let _e4036 = local_2.member[_e4031];
                                                    let _e4039 = local_2.member_1[_e4031];
                                                    let _e4056 = ((_e4036 + ((_e4039 - _e4036) * _e1506)) - ((_e3508 * f64(1.01f)) + ((select(_e4036, -(_e4036), (_e4036 < 0.0lf)) + select(_e4039, -(_e4039), (_e4039 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f)))));
                                                    phi_7231_ = select(_e4056, _e4017, (_e4017 < _e4056));
                                                } else {
                                                    phi_7231_ = f64();
                                                }
                                                let _e4060 = phi_7231_;
                                                continue;
                                                continuing {
                                                    phi_7227_ = type_9(select(_e4015.member, (_e4015.member + 1u), _e4020), select(_e4015.member_1, _e4015.member_1, _e4020));
                                                    phi_7230_ = _e4060;
                                                    break if !(_e4033);
                                                }
                                            }
                                            let _e4063 = local_27;
                                            if (_e4063 > f64(0f)) {
                                                let _e4068 = local_28;
                                                let _e4072 = (((_e3990 - _e4068) / _e3990) * f64(2.02f));
                                                if (_e4072 <= 2.2250738585072014e-308lf) {
                                                    phi_7389_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e4072 > 0.0lf));
                                                } else {
                                                    phi_7332_ = type_18(0i, 5i);
                                                    phi_7335_ = bitcast<f64>(((bitcast<u64>(_e4072) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e4079 = phi_7332_;
                                                        let _e4081 = phi_7335_;
                                                        local_29 = _e4081;
                                                        if (_e4079.member < _e4079.member_1) {
                                                            let _e4088 = (_e4079.member + 1i);
                                                            phi_7333_ = type_18(select(_e4088, type_19().member_1, select(false, true, ((false == (_e4088 > _e4079.member)) != false))), _e4079.member_1);
                                                            phi_7376_ = type_19(1u, _e4079.member);
                                                        } else {
                                                            phi_7333_ = _e4079;
                                                            phi_7376_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e4099 = phi_7333_;
                                                        let _e4101 = phi_7376_;
                                                        let _e4104 = (bitcast<i32>(_e4101.member) != 0i);
                                                        if _e4104 {
                                                            phi_7336_ = (0.5lf * (_e4081 + (_e4072 / _e4081)));
                                                        } else {
                                                            phi_7336_ = f64();
                                                        }
                                                        let _e4109 = phi_7336_;
                                                        continue;
                                                        continuing {
                                                            phi_7332_ = _e4099;
                                                            phi_7335_ = _e4109;
                                                            break if !(_e4104);
                                                        }
                                                    }
                                                    let _e4114 = local_29;
                                                    phi_7389_ = (_e4114 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e4120 = phi_7389_;
                                                let _e4123 = ((_e4120 * _e3775) * f64(1.01f));
                                                phi_7396_ = type_9(0u, 4u);
                                                phi_7399_ = f64(2f);
                                                phi_7401_ = true;
                                                phi_7403_ = true;
                                                loop {
                                                    let _e4126 = phi_7396_;
                                                    let _e4128 = phi_7399_;
                                                    let _e4130 = phi_7401_;
                                                    let _e4132 = phi_7403_;
                                                    local_30 = _e4128;
                                                    local_31 = _e4128;
                                                    local_32 = _e4130;
                                                    local_33 = _e4132;
                                                    local_34 = _e4132;
                                                    local_35 = _e4132;
                                                    local_60 = _e4132;
                                                    local_36 = _e4132;
                                                    let _e4135 = (_e4126.member < _e4126.member_1);
                                                    let _e4146 = select(type_9().member_1, _e4126.member, _e4135);
                                                    let _e4148 = (bitcast<i32>(select(0u, 1u, _e4135)) != 0i);
                                                    if _e4148 {
                                                        let _e4152 = local_1.member[0u][_e4146];
                                                        let _e4159 = local_1.member[1u][_e4146];
                                                        let _e4173 = ((select(_e4152[0], -(_e4152[0]), (_e4152[0] < 0.0lf)) + select(_e4152[1], -(_e4152[1]), (_e4152[1] < 0.0lf))) + select(_e4152[2], -(_e4152[2]), (_e4152[2] < 0.0lf)));
                                                        let _e4184 = ((select(_e4159[0], -(_e4159[0]), (_e4159[0] < 0.0lf)) + select(_e4159[1], -(_e4159[1]), (_e4159[1] < 0.0lf))) + select(_e4159[2], -(_e4159[2]), (_e4159[2] < 0.0lf)));
                                                        let _e4192 = (_e4159[0] - _e4152[0]);
                                                        let _e4193 = (_e4159[1] - _e4152[1]);
                                                        let _e4194 = (_e4159[2] - _e4152[2]);
                                                        let _e4213 = local_2.member[_e4146];
                                                        let _e4216 = local_2.member_1[_e4146];
                                                        let _e4229 = ((_e3508 * f64(1.01f)) + ((select(_e4213, -(_e4213), (_e4213 < 0.0lf)) + select(_e4216, -(_e4216), (_e4216 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f))));
                                                        let _e4236 = local_2.member_1[_e4146];
                                                        let _e4239 = local_2.member[_e4146];
                                                        let _e4240 = (_e4236 - _e4239);
                                                        let _e4243 = ((_e4229 + _e4229) + (_e4123 * ((((select(_e4192, -(_e4192), (_e4192 < 0.0lf)) + select(_e4193, -(_e4193), (_e4193 < 0.0lf))) + select(_e4194, -(_e4194), (_e4194 < 0.0lf))) + (_e3508 * f64(6f))) * f64(1.01f))));
                                                        let _e4246 = ((((_e4213 + ((_e4216 - _e4213) * _e1506)) - _e4229) - (_e4123 * ((select(_e4184, _e4173, (_e4173 > _e4184)) + (_e3508 * f64(3f))) * f64(1.01f)))) - _e3990);
                                                        let _e4247 = (_e4246 > 2.2250738585072014e-308lf);
                                                        let _e4248 = (_e4240 > _e4243);
                                                        if _e4248 {
                                                            phi_7640_ = _e4128;
                                                        } else {
                                                            if _e4247 {
                                                                let _e4255 = (_e4243 - _e4240);
                                                                let _e4258 = (_e4246 / select(2.2250738585072014e-308lf, _e4255, (_e4255 > 2.2250738585072014e-308lf)));
                                                                phi_7639_ = select(_e4258, _e4128, (_e4128 < _e4258));
                                                            } else {
                                                                phi_7639_ = _e4128;
                                                            }
                                                            let _e4262 = phi_7639_;
                                                            phi_7640_ = _e4262;
                                                        }
                                                        let _e4264 = phi_7640_;
                                                        phi_7400_ = _e4264;
                                                        phi_7402_ = (_e4130 && select(_e4247, true, (_e4240 < -(_e4243))));
                                                        phi_7404_ = (_e4132 && select(_e4247, true, _e4248));
                                                    } else {
                                                        phi_7400_ = f64();
                                                        phi_7402_ = bool();
                                                        phi_7404_ = bool();
                                                    }
                                                    let _e4266 = phi_7400_;
                                                    let _e4268 = phi_7402_;
                                                    let _e4270 = phi_7404_;
                                                    continue;
                                                    continuing {
                                                        phi_7396_ = type_9(select(_e4126.member, (_e4126.member + 1u), _e4135), select(_e4126.member_1, _e4126.member_1, _e4135));
                                                        phi_7399_ = _e4266;
                                                        phi_7401_ = _e4268;
                                                        phi_7403_ = _e4270;
                                                        break if !(_e4148);
                                                    }
                                                }
                                                let _e4272 = f64(2f);
                                                let _e4274 = local_30;
                                                let _e4277 = local_31;
                                                let _e4280 = (select(_e4272, _e4277, (_e4274 < _e4272)) * f64(0.999f));
                                                let _e4282 = local_32;
                                                if _e4282 {
                                                    let _e4286 = local_33;
                                                    let _e4290 = local_34;
                                                    let _e4294 = local_35;
                                                    phi_7658_ = type_42(select(_e1506, type_42().member, _e4286), select(f64(2f), type_42().member_1, _e4290), select(1u, type_42().member_2, _e4294));
                                                    let _e5403 = local_60;
                                                    phi_7659_ = _e5403;
                                                } else {
                                                    phi_7658_ = type_42();
                                                    phi_7659_ = true;
                                                }
                                                let _e4298 = phi_7658_;
                                                let _e4300 = phi_7659_;
                                                if _e4300 {
                                                    let _e4302 = local_36;
                                                    if _e4302 {
                                                        let _e4308 = (_e1506 + _e4280);
                                                        let _e4311 = select(_e1506, select(_e545, _e4308, (_e4308 < _e545)), (_e4280 > (1.1102230246251565e-16lf * f64(4096f))));
                                                        phi_7681_ = type_9(0u, 4u);
                                                        phi_7684_ = _e4311;
                                                        phi_7686_ = _e1506;
                                                        loop {
                                                            let _e4313 = phi_7681_;
                                                            let _e4315 = phi_7684_;
                                                            let _e4317 = phi_7686_;
                                                            local_37 = _e4315;
                                                            local_38 = _e4317;
                                                            local_39 = _e4317;
                                                            let _e4320 = (_e4313.member < _e4313.member_1);
                                                            let _e4331 = select(type_9().member_1, _e4313.member, _e4320);
                                                            let _e4333 = (bitcast<i32>(select(0u, 1u, _e4320)) != 0i);
                                                            if _e4333 {
                                                                let _e4336 = local_2.member[_e4331];
                                                                let _e4339 = local_2.member_1[_e4331];
                                                                let _e4342 = local_2.member[_e4331];
                                                                let _e4348 = local_2.member_2[_e4331];
                                                                let _e4349 = ((_e4336 + ((_e4339 - _e4342) * _e1506)) - _e4348);
                                                                let _e4352 = local_2.member_1[_e4331];
                                                                let _e4355 = local_2.member[_e4331];
                                                                let _e4356 = (_e4352 - _e4355);
                                                                if (_e4356 > f64(0f)) {
                                                                    let _e4372 = (_e1506 - (_e4349 / _e4356));
                                                                    phi_7798_ = _e4315;
                                                                    phi_7799_ = select(_e4372, _e4317, (_e4317 > _e4372));
                                                                } else {
                                                                    if (_e4349 > f64(0f)) {
                                                                        if (_e4356 < f64(0f)) {
                                                                            let _e4364 = (_e1506 - (_e4349 / _e4356));
                                                                            phi_7796_ = select(_e4364, _e4315, (_e4315 < _e4364));
                                                                        } else {
                                                                            phi_7796_ = _e4315;
                                                                        }
                                                                        let _e4368 = phi_7796_;
                                                                        phi_7797_ = _e4368;
                                                                    } else {
                                                                        phi_7797_ = _e4315;
                                                                    }
                                                                    let _e4370 = phi_7797_;
                                                                    phi_7798_ = _e4370;
                                                                    phi_7799_ = _e4317;
                                                                }
                                                                let _e4376 = phi_7798_;
                                                                let _e4378 = phi_7799_;
                                                                phi_7685_ = _e4376;
                                                                phi_7687_ = _e4378;
                                                            } else {
                                                                phi_7685_ = f64();
                                                                phi_7687_ = f64();
                                                            }
                                                            let _e4380 = phi_7685_;
                                                            let _e4382 = phi_7687_;
                                                            continue;
                                                            continuing {
                                                                phi_7681_ = type_9(select(_e4313.member, (_e4313.member + 1u), _e4320), select(_e4313.member_1, _e4313.member_1, _e4320));
                                                                phi_7684_ = _e4380;
                                                                phi_7686_ = _e4382;
                                                                break if !(_e4333);
                                                            }
                                                        }
                                                        let _e4385 = local_37;
                                                        let _e4387 = local_38;
                                                        let _e4392 = local_39;
                                                        let _e4393 = (_e4392 + ((_e4385 - _e4387) * f64(0.5f)));
                                                        if (_e4393 > _e1506) {
                                                            if (_e4393 <= _e4311) {
                                                                let _e4396 = f64(0f);
                                                                let _e4399 = local_2.member[0u];
                                                                let _e4402 = local_2.member_1[0u];
                                                                let _e4405 = local_2.member[0u];
                                                                let _e4411 = local_2.member_2[0u];
                                                                if (((_e4399 + ((_e4402 - _e4405) * _e4393)) - _e4411) > _e4396) {
                                                                    let _e4416 = local_2.member[1u];
                                                                    let _e4419 = local_2.member_1[1u];
                                                                    let _e4422 = local_2.member[1u];
                                                                    let _e4428 = local_2.member_2[1u];
                                                                    if (((_e4416 + ((_e4419 - _e4422) * _e4393)) - _e4428) > _e4396) {
                                                                        let _e4433 = local_2.member[2u];
                                                                        let _e4436 = local_2.member_1[2u];
                                                                        let _e4439 = local_2.member[2u];
                                                                        let _e4445 = local_2.member_2[2u];
                                                                        if (((_e4433 + ((_e4436 - _e4439) * _e4393)) - _e4445) > _e4396) {
                                                                            let _e4450 = local_2.member[3u];
                                                                            let _e4453 = local_2.member_1[3u];
                                                                            let _e4456 = local_2.member[3u];
                                                                            let _e4462 = local_2.member_2[3u];
                                                                            phi_7962_ = (((_e4450 + ((_e4453 - _e4456) * _e4393)) - _e4462) > _e4396);
                                                                            phi_7963_ = false;
                                                                        } else {
                                                                            phi_7962_ = bool();
                                                                            phi_7963_ = true;
                                                                        }
                                                                        let _e4466 = phi_7962_;
                                                                        let _e4468 = phi_7963_;
                                                                        phi_7964_ = _e4466;
                                                                        phi_7965_ = _e4468;
                                                                    } else {
                                                                        phi_7964_ = bool();
                                                                        phi_7965_ = true;
                                                                    }
                                                                    let _e4470 = phi_7964_;
                                                                    let _e4472 = phi_7965_;
                                                                    phi_7966_ = _e4470;
                                                                    phi_7967_ = _e4472;
                                                                } else {
                                                                    phi_7966_ = bool();
                                                                    phi_7967_ = true;
                                                                }
                                                                let _e4474 = phi_7966_;
                                                                let _e4476 = phi_7967_;
                                                                phi_7976_ = select(true, false, select(_e4474, false, _e4476));
                                                            } else {
                                                                phi_7976_ = true;
                                                            }
                                                            let _e4480 = phi_7976_;
                                                            phi_7977_ = _e4480;
                                                        } else {
                                                            phi_7977_ = true;
                                                        }
                                                        let _e4482 = phi_7977_;
                                                        phi_7986_ = type_42(_e4311, select(_e4393, f64(2f), _e4482), 2u);
                                                        phi_7987_ = type_42();
                                                        phi_7988_ = false;
                                                    } else {
                                                        phi_7986_ = type_42();
                                                        phi_7987_ = type_42(_e1506, f64(2f), 0u);
                                                        phi_7988_ = true;
                                                    }
                                                    let _e4487 = phi_7986_;
                                                    let _e4489 = phi_7987_;
                                                    let _e4491 = phi_7988_;
                                                    phi_7989_ = _e4487;
                                                    phi_7990_ = _e4489;
                                                    phi_7991_ = _e4491;
                                                } else {
                                                    phi_7989_ = type_42();
                                                    phi_7990_ = _e4298;
                                                    phi_7991_ = true;
                                                }
                                                let _e4493 = phi_7989_;
                                                let _e4495 = phi_7990_;
                                                let _e4497 = phi_7991_;
                                                phi_7997_ = _e4495;
                                                phi_7998_ = _e4493;
                                                phi_7999_ = _e4497;
                                            } else {
                                                phi_7997_ = type_42(_e1506, f64(2f), 0u);
                                                phi_7998_ = type_42();
                                                phi_7999_ = true;
                                            }
                                            let _e4499 = phi_7997_;
                                            let _e4501 = phi_7998_;
                                            let _e4503 = phi_7999_;
                                            phi_8003_ = _e4499;
                                            phi_8004_ = _e4501;
                                            phi_8005_ = false;
                                            phi_8006_ = _e4503;
                                        } else {
                                            phi_8003_ = type_42();
                                            phi_8004_ = type_42();
                                            phi_8005_ = true;
                                            phi_8006_ = false;
                                        }
                                        let _e4505 = phi_8003_;
                                        let _e4507 = phi_8004_;
                                        let _e4509 = phi_8005_;
                                        let _e4511 = phi_8006_;
                                        phi_8007_ = _e4505;
                                        phi_8008_ = _e4507;
                                        phi_8009_ = _e4509;
                                        phi_8010_ = _e4511;
                                    } else {
                                        phi_8007_ = type_42();
                                        phi_8008_ = type_42();
                                        phi_8009_ = true;
                                        phi_8010_ = false;
                                    }
                                    let _e4513 = phi_8007_;
                                    let _e4515 = phi_8008_;
                                    let _e4517 = phi_8009_;
                                    let _e4519 = phi_8010_;
                                    let _e4527 = select(_e4519, true, _e4517);
                                    let _e4531 = select(_e4515.member_1, select(_e4513.member_1, f64(2f), _e4517), _e4527);
                                    let _e4533 = select(_e4515.member_2, select(_e4513.member_2, 0u, _e4517), _e4527);
                                    if ((_e547 & 64u) != 0u) {
                                        let _e4535 = (_e4533 == 2u);
                                        let _e4536 = (_e4531 <= _e545);
                                        phi_8045_ = select(f64(), select(f64(), _e4531, _e4536), _e4535);
                                        phi_8046_ = select(f64(), select(f64(), _e4531, _e4536), _e4535);
                                        phi_8047_ = select(false, _e4536, _e4535);
                                        phi_8048_ = select(false, select(true, false, _e4536), _e4535);
                                        phi_8049_ = select(true, false, _e4535);
                                    } else {
                                        phi_8045_ = f64();
                                        phi_8046_ = f64();
                                        phi_8047_ = false;
                                        phi_8048_ = false;
                                        phi_8049_ = true;
                                    }
                                    let _e4546 = phi_8045_;
                                    let _e4548 = phi_8046_;
                                    let _e4550 = phi_8047_;
                                    let _e4552 = phi_8048_;
                                    let _e4554 = phi_8049_;
                                    phi_8050_ = _e4546;
                                    phi_8051_ = _e4533;
                                    phi_8052_ = _e4548;
                                    phi_8053_ = type_42(select(_e4515.member, select(_e4513.member, _e1506, _e4517), _e4527), _e4531, _e4533);
                                    phi_8054_ = _e4533;
                                    phi_8055_ = _e4533;
                                    phi_8056_ = _e4550;
                                    phi_8057_ = _e4552;
                                    phi_8058_ = _e4554;
                                }
                                let _e4556 = phi_8050_;
                                let _e4558 = phi_8051_;
                                let _e4560 = phi_8052_;
                                let _e4562 = phi_8053_;
                                let _e4564 = phi_8054_;
                                let _e4566 = phi_8055_;
                                let _e4568 = phi_8056_;
                                let _e4570 = phi_8057_;
                                let _e4572 = phi_8058_;
                                phi_8059_ = _e4556;
                                phi_8060_ = _e4558;
                                phi_8061_ = _e4560;
                                phi_8062_ = _e4562;
                                phi_8063_ = _e4564;
                                phi_8064_ = _e4566;
                                phi_8065_ = _e4568;
                                phi_8066_ = _e3210;
                                phi_8067_ = _e4570;
                                phi_8068_ = _e4572;
                                phi_8069_ = false;
                            } else {
                                phi_8059_ = f64();
                                phi_8060_ = u32();
                                phi_8061_ = f64();
                                phi_8062_ = type_42();
                                phi_8063_ = u32();
                                phi_8064_ = u32();
                                phi_8065_ = false;
                                phi_8066_ = false;
                                phi_8067_ = false;
                                phi_8068_ = false;
                                phi_8069_ = true;
                            }
                            let _e4574 = phi_8059_;
                            let _e4576 = phi_8060_;
                            let _e4578 = phi_8061_;
                            let _e4580 = phi_8062_;
                            let _e4582 = phi_8063_;
                            let _e4584 = phi_8064_;
                            let _e4586 = phi_8065_;
                            let _e4588 = phi_8066_;
                            let _e4590 = phi_8067_;
                            let _e4592 = phi_8068_;
                            let _e4594 = phi_8069_;
                            phi_8070_ = _e3207;
                            phi_3054_ = _e4574;
                            phi_3056_ = _e4576;
                            phi_3058_ = _e4578;
                            phi_8071_ = _e4580;
                            phi_8072_ = _e4582;
                            phi_8073_ = _e3207;
                            phi_8074_ = _e4584;
                            phi_8075_ = _e4586;
                            phi_8076_ = _e4588;
                            phi_8077_ = _e4590;
                            phi_8078_ = _e4592;
                            phi_8079_ = false;
                            phi_8080_ = _e4594;
                        } else {
                            phi_8070_ = f64();
                            phi_3054_ = f64();
                            phi_3056_ = u32();
                            phi_3058_ = f64();
                            phi_8071_ = type_42();
                            phi_8072_ = u32();
                            phi_8073_ = f64();
                            phi_8074_ = u32();
                            phi_8075_ = false;
                            phi_8076_ = false;
                            phi_8077_ = false;
                            phi_8078_ = false;
                            phi_8079_ = true;
                            phi_8080_ = false;
                        }
                        let _e4596 = phi_8070_;
                        let _e4598 = phi_3054_;
                        let _e4600 = phi_3056_;
                        let _e4602 = phi_3058_;
                        let _e4604 = phi_8071_;
                        let _e4606 = phi_8072_;
                        let _e4608 = phi_8073_;
                        let _e4610 = phi_8074_;
                        let _e4612 = phi_8075_;
                        let _e4614 = phi_8076_;
                        let _e4616 = phi_8077_;
                        let _e4618 = phi_8078_;
                        let _e4620 = phi_8079_;
                        let _e4622 = phi_8080_;
                        local_40 = _e4614;
                        local_41 = _e4616;
                        local_42 = _e4614;
                        local_43 = _e4618;
                        local_44 = _e4614;
                        local_45 = _e4620;
                        local_46 = _e4614;
                        local_47 = _e4622;
                        local_48 = _e4604;
                        local_49 = _e4604;
                        local_50 = _e4606;
                        local_51 = _e4604;
                        local_61 = _e4614;
                        local_52 = _e4610;
                        local_54 = _e4608;
                        local_55 = _e4596;
                        continue;
                        continuing {
                            phi_3050_ = _e1524;
                            phi_3053_ = _e4598;
                            phi_3055_ = _e4600;
                            phi_3057_ = _e4602;
                            break if !(_e4612);
                        }
                    }
                    let _e4625 = local_40;
                    let _e4627 = local_41;
                    let _e4628 = select(_e4627, false, _e4625);
                    let _e4630 = local_42;
                    let _e4632 = local_43;
                    let _e4635 = local_44;
                    let _e4637 = local_45;
                    let _e4640 = local_46;
                    let _e4642 = local_47;
                    if _e4628 {
                        let _e4645 = local_48;
                        if (_e4645.member >= _e545) {
                            phi_8109_ = type_39(type_38(0u, f64()), 0u);
                        } else {
                            let _e4649 = local_49;
                            let _e4653 = local_50;
                            let _e4656 = local_51;
                            phi_8109_ = type_39(type_38(2u, _e4656.member), select(_e4653, 0u, (_e4649.member > _e536)));
                        }
                        let _e4663 = phi_8109_;
                        phi_8110_ = _e4663;
                        phi_8111_ = false;
                        phi_8112_ = false;
                        phi_8113_ = false;
                        phi_8114_ = false;
                    } else {
                        phi_8110_ = type_39();
                        phi_8111_ = select(_e4632, false, _e4630);
                        let _e5498 = local_61;
                        phi_8112_ = _e5498;
                        phi_8113_ = select(_e4637, false, _e4635);
                        phi_8114_ = select(_e4642, false, _e4640);
                    }
                    let _e4665 = phi_8110_;
                    let _e4667 = phi_8111_;
                    let _e4669 = phi_8112_;
                    let _e4671 = phi_8113_;
                    let _e4673 = phi_8114_;
                    let _e4675 = local_52;
                    let _e4677 = local_53;
                    let _e4680 = local_54;
                    let _e4682 = local_55;
                    let _e4684 = select(_e4669, true, _e4667);
                    let _e4689 = local_56;
                    let _e4690 = select(_e4689, select(_e4682, _e4680, _e4667), _e4684);
                    let _e4692 = local_57;
                    let _e4693 = select(_e4692, select(_e4677, _e4675, _e4667), _e4684);
                    if select(select(_e4671, false, _e4667), true, _e4684) {
                        local[0u] = 0.01f;
                        local[1u] = 0f;
                        local[2u] = 0.8f;
                        phi_8148_ = type_9(0u, 3u);
                        loop {
                            let _e4706 = phi_8148_;
                            let _e4709 = (_e4706.member < _e4706.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e4709)) != 0i) {
                                let _e4724 = local[select(type_9().member_1, _e4706.member, _e4709)];
                                let _e4727 = (_e4690 + (select(f64(0f), _e527, (_e527 >= (1.1102230246251565e-16lf * f64(8f)))) * f64(_e4724)));
                                let _e4729 = select(_e545, _e4727, (_e4727 < _e545));
                                let _e4732 = local_5.member[0u];
                                let _e4738 = local_5.member[1u];
                                let _e4754 = local_5.member_1[0u];
                                let _e4760 = local_5.member_1[1u];
                                let _e4776 = local_5.member_2[0u];
                                let _e4782 = local_5.member_2[1u];
                                let _e4796 = function_3(array<f64, 3>((_e4732[0] + ((_e4738[0] - _e4732[0]) * _e4729)), (_e4732[1] + ((_e4738[1] - _e4732[1]) * _e4729)), (_e4732[2] + ((_e4738[2] - _e4732[2]) * _e4729))), array<f64, 3>((_e4754[0] + ((_e4760[0] - _e4754[0]) * _e4729)), (_e4754[1] + ((_e4760[1] - _e4754[1]) * _e4729)), (_e4754[2] + ((_e4760[2] - _e4754[2]) * _e4729))), array<f64, 3>((_e4776[0] + ((_e4782[0] - _e4776[0]) * _e4729)), (_e4776[1] + ((_e4782[1] - _e4776[1]) * _e4729)), (_e4776[2] + ((_e4782[2] - _e4776[2]) * _e4729))), _e224.member);
                                let _e4807 = (((_e4796[0] * _e4796[0]) + (_e4796[1] * _e4796[1])) + (_e4796[2] * _e4796[2]));
                                if (_e4807 <= 2.2250738585072014e-308lf) {
                                    phi_8381_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e4807 > 0.0lf));
                                } else {
                                    phi_8324_ = type_18(0i, 5i);
                                    phi_8327_ = bitcast<f64>(((bitcast<u64>(_e4807) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e4814 = phi_8324_;
                                        let _e4816 = phi_8327_;
                                        local_58 = _e4816;
                                        if (_e4814.member < _e4814.member_1) {
                                            let _e4823 = (_e4814.member + 1i);
                                            phi_8325_ = type_18(select(_e4823, type_19().member_1, select(false, true, ((false == (_e4823 > _e4814.member)) != false))), _e4814.member_1);
                                            phi_8368_ = type_19(1u, _e4814.member);
                                        } else {
                                            phi_8325_ = _e4814;
                                            phi_8368_ = type_19(0u, type_19().member_1);
                                        }
                                        let _e4834 = phi_8325_;
                                        let _e4836 = phi_8368_;
                                        let _e4839 = (bitcast<i32>(_e4836.member) != 0i);
                                        if _e4839 {
                                            phi_8328_ = (0.5lf * (_e4816 + (_e4807 / _e4816)));
                                        } else {
                                            phi_8328_ = f64();
                                        }
                                        let _e4844 = phi_8328_;
                                        continue;
                                        continuing {
                                            phi_8324_ = _e4834;
                                            phi_8327_ = _e4844;
                                            break if !(_e4839);
                                        }
                                    }
                                    let _e4849 = local_58;
                                    phi_8381_ = (_e4849 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e4855 = phi_8381_;
                                let _e4863 = local_5.member[0u];
                                let _e4869 = select(_e4863[0], -(_e4863[0]), (_e4863[0] < 0.0lf));
                                let _e4872 = select(_e4863[1], -(_e4863[1]), (_e4863[1] < 0.0lf));
                                let _e4874 = select(_e4872, _e4869, (_e4869 > _e4872));
                                let _e4877 = select(_e4863[2], -(_e4863[2]), (_e4863[2] < 0.0lf));
                                let _e4879 = select(_e4877, _e4874, (_e4874 > _e4877));
                                let _e4882 = local_5.member[1u];
                                let _e4888 = select(_e4882[0], -(_e4882[0]), (_e4882[0] < 0.0lf));
                                let _e4891 = select(_e4882[1], -(_e4882[1]), (_e4882[1] < 0.0lf));
                                let _e4893 = select(_e4891, _e4888, (_e4888 > _e4891));
                                let _e4896 = select(_e4882[2], -(_e4882[2]), (_e4882[2] < 0.0lf));
                                let _e4898 = select(_e4896, _e4893, (_e4893 > _e4896));
                                let _e4902 = local_5.member_3;
                                let _e4906 = local_5.member_1[0u];
                                let _e4912 = select(_e4906[0], -(_e4906[0]), (_e4906[0] < 0.0lf));
                                let _e4915 = select(_e4906[1], -(_e4906[1]), (_e4906[1] < 0.0lf));
                                let _e4917 = select(_e4915, _e4912, (_e4912 > _e4915));
                                let _e4920 = select(_e4906[2], -(_e4906[2]), (_e4906[2] < 0.0lf));
                                let _e4922 = select(_e4920, _e4917, (_e4917 > _e4920));
                                let _e4925 = local_5.member_1[1u];
                                let _e4931 = select(_e4925[0], -(_e4925[0]), (_e4925[0] < 0.0lf));
                                let _e4934 = select(_e4925[1], -(_e4925[1]), (_e4925[1] < 0.0lf));
                                let _e4936 = select(_e4934, _e4931, (_e4931 > _e4934));
                                let _e4939 = select(_e4925[2], -(_e4925[2]), (_e4925[2] < 0.0lf));
                                let _e4941 = select(_e4939, _e4936, (_e4936 > _e4939));
                                let _e4945 = local_5.member_3;
                                let _e4949 = local_5.member_2[0u];
                                let _e4955 = select(_e4949[0], -(_e4949[0]), (_e4949[0] < 0.0lf));
                                let _e4958 = select(_e4949[1], -(_e4949[1]), (_e4949[1] < 0.0lf));
                                let _e4960 = select(_e4958, _e4955, (_e4955 > _e4958));
                                let _e4963 = select(_e4949[2], -(_e4949[2]), (_e4949[2] < 0.0lf));
                                let _e4965 = select(_e4963, _e4960, (_e4960 > _e4963));
                                let _e4968 = local_5.member_2[1u];
                                let _e4974 = select(_e4968[0], -(_e4968[0]), (_e4968[0] < 0.0lf));
                                let _e4977 = select(_e4968[1], -(_e4968[1]), (_e4968[1] < 0.0lf));
                                let _e4979 = select(_e4977, _e4974, (_e4974 > _e4977));
                                let _e4982 = select(_e4968[2], -(_e4968[2]), (_e4968[2] < 0.0lf));
                                let _e4984 = select(_e4982, _e4979, (_e4979 > _e4982));
                                let _e4988 = local_5.member_3;
                                let _e4996 = local_5.member_3;
                                let _e5006 = (((_e4855 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e4898, _e4879, (_e4879 > _e4898)) + _e4902) + (select(_e4941, _e4922, (_e4922 > _e4941)) + _e4945)) + (select(_e4984, _e4965, (_e4965 > _e4984)) + _e4988)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4996 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e775.member_1);
                                phi_8658_ = select(true, false, _e5006);
                                phi_8659_ = _e5006;
                            } else {
                                phi_8658_ = false;
                                phi_8659_ = false;
                            }
                            let _e5009 = phi_8658_;
                            let _e5011 = phi_8659_;
                            local_59 = _e5011;
                            continue;
                            continuing {
                                phi_8148_ = type_9(select(_e4706.member, (_e4706.member + 1u), _e4709), select(_e4706.member_1, _e4706.member_1, _e4709));
                                break if !(_e5009);
                            }
                        }
                        let _e5014 = local_59;
                        if _e5014 {
                            phi_8671_ = type_39(type_38(1u, _e4690), select(_e4693, 1u, (_e4690 > _e536)));
                            phi_8672_ = false;
                        } else {
                            phi_8671_ = type_39();
                            phi_8672_ = true;
                        }
                        let _e5020 = phi_8671_;
                        let _e5022 = phi_8672_;
                        if _e5022 {
                            phi_8684_ = type_39(type_38(2u, _e4690), select(_e4693, 0u, (_e4690 > _e536)));
                        } else {
                            phi_8684_ = _e5020;
                        }
                        let _e5028 = phi_8684_;
                        phi_8685_ = _e5028;
                        phi_8686_ = false;
                        phi_8687_ = false;
                    } else {
                        phi_8685_ = type_39();
                        phi_8686_ = select(select(_e4673, false, _e4667), false, _e4684);
                        phi_8687_ = select(select(_e4628, false, _e4667), false, _e4684);
                    }
                    let _e5030 = phi_8685_;
                    let _e5032 = phi_8686_;
                    let _e5034 = phi_8687_;
                    if _e5032 {
                        phi_8694_ = type_39(type_38(0u, f64()), 0u);
                        phi_8695_ = true;
                    } else {
                        phi_8694_ = _e4665;
                        phi_8695_ = _e5034;
                    }
                    let _e5038 = phi_8694_;
                    let _e5040 = phi_8695_;
                    phi_8699_ = _e5038;
                    phi_8700_ = _e5030;
                    phi_8701_ = _e5040;
                } else {
                    phi_8699_ = _e1496;
                    phi_8700_ = type_39();
                    phi_8701_ = true;
                }
                let _e5042 = phi_8699_;
                let _e5044 = phi_8700_;
                let _e5046 = phi_8701_;
                if _e5046 {
                    phi_8705_ = _e5042;
                } else {
                    phi_8705_ = _e5044;
                }
                let _e5048 = phi_8705_;
                switch bitcast<i32>(_e5048.member.member) {
                    case 0: {
                        phi_8723_ = type_35(0u, _e5048.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5059 = function_4(_e5048.member.member_1);
                        phi_8723_ = type_35(0u, _e5048.member_1, _e5059, true);
                        break;
                    }
                    case 2: {
                        let _e5055 = function_4(_e5048.member.member_1);
                        phi_8723_ = type_35(1u, _e5048.member_1, _e5055, true);
                        break;
                    }
                    default: {
                        phi_8723_ = type_35();
                        break;
                    }
                }
                let _e5063 = phi_8723_;
                if _e5063.member_3 {
                    let _e5073 = (_e5063.member_2[1] >> bitcast<u32>(20i));
                    if (_e5073 <= 896u) {
                        phi_8758_ = 0u;
                    } else {
                        phi_8758_ = ((((_e5073 - 896u) << bitcast<u32>(23i)) | ((_e5063.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e5063.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e5088 = phi_8758_;
                    let _e5090 = atomicMin((&earliest.member[0u]), _e5088);
                }
                phi_8762_ = type_20(_e177, _e5063.member, _e192, _e195, _e5063.member_2, _e5063.member_1);
                phi_8763_ = select(false, select(false, true, _e182), _e5063.member_3);
            } else {
                phi_8762_ = type_20(_e177, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_8763_ = false;
            }
            let _e5092 = phi_8762_;
            let _e5094 = phi_8763_;
            if (_e101 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5094 {
                let _e5098 = atomicAdd((&counters[0u]), 1u);
                phi_8774_ = _e5098;
            } else {
                phi_8774_ = 0u;
            }
            let _e5100 = phi_8774_;
            workgroupBarrier();
            if (_e101 == 0u) {
                let _e5103 = atomicLoad((&counters[0u]));
                if (_e5103 > 0u) {
                    let _e5106 = atomicAdd((&contacts.member[0u]), _e5103);
                    atomicStore((&counters[1u]), _e5106);
                }
            }
            workgroupBarrier();
            let _e5109 = atomicLoad((&counters[1u]));
            let _e5110 = (_e5109 + _e5100);
            if _e5094 {
                if _e182 {
                    let _e5113 = params.member.member_1.member_3;
                    if (_e5110 < _e5113) {
                        let _e5115 = (7u * _e5110);
                        atomicStore((&contacts.member[(4u + _e5115)]), _e5092.member);
                        atomicStore((&contacts.member[(_e5115 + 5u)]), _e5092.member_1);
                        atomicStore((&contacts.member[(_e5115 + 6u)]), _e5092.member_2);
                        atomicStore((&contacts.member[(_e5115 + 7u)]), _e5092.member_3);
                        atomicStore((&contacts.member[(_e5115 + 8u)]), _e5092.member_4[0]);
                        atomicStore((&contacts.member[(_e5115 + 9u)]), _e5092.member_4[1]);
                        atomicStore((&contacts.member[(_e5115 + 10u)]), _e5092.member_5);
                    }
                    phi_8834_ = false;
                } else {
                    phi_8834_ = true;
                }
                let _e5140 = phi_8834_;
                phi_8835_ = _e5140;
            } else {
                phi_8835_ = true;
            }
            let _e5142 = phi_8835_;
            if _e5142 {
                if _e5094 {
                    let _e5147 = params.member.member_2.member_1;
                    if (_e5110 < _e5147) {
                        let _e5149 = (2u * _e5110);
                        atomicStore((&contacts.member[(4u + _e5149)]), _e5092.member_2);
                        atomicStore((&contacts.member[(_e5149 + 5u)]), _e5092.member_3);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_988_ = type_9(select(_e154.member, (_e154.member + 1u), _e157), select(_e154.member_1, _e154.member_1, _e157));
            break if !(_e170);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_near_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
