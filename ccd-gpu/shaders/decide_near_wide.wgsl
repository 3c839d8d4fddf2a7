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

struct type_22 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_23 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_29 {
    member: array<array<f64, 3>>,
}

struct type_30 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_32 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_34 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_35 {
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_36 {
    member: type_32,
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

struct type_40 {
    member: array<array<array<f64, 3>, 4>, 2>,
    member_1: f64,
    member_2: f64,
}

struct type_41 {
    member: f64,
    member_1: f64,
    member_2: u32,
}

struct type_45 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(4) 
var<storage> input: type_13;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> positions: type_29;
@group(0) @binding(1) 
var<storage> paths: type_25;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_45;
@group(0) @binding(3) 
var<storage> elements: type_13;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_45;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_231_: f64;
    var phi_274_: f64;
    var phi_317_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_231_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_231_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_231_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_274_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_274_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_274_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_317_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_317_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_317_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    let _e24 = ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])));
    return array<f64, 3>(select(param_1[0], param_2[0], _e24), select(param_1[1], param_2[1], _e24), select(param_1[2], param_2[2], _e24));
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_838_: array<array<f64, 3>, 4>;

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
        phi_838_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e171)), (param_3[1] - (param_4[1] * _e171)), (param_3[2] - (param_4[2] * _e171))), array<f64, 3>((param_3[0] - (param_5[0] * _e215)), (param_3[1] - (param_5[1] * _e215)), (param_3[2] - (param_5[2] * _e215))), array<f64, 3>((_e9 - (param_5[0] * _e256)), (_e12 - (param_5[1] * _e256)), (_e15 - (param_5[2] * _e256))), array<f64, 3>((_e269 - (param_4[0] * _e303)), (_e272 - (param_4[1] * _e303)), (_e275 - (param_4[2] * _e303))));
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
        phi_838_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e82)), (param_3[1] - (param_4[1] * _e82)), (param_3[2] - (param_4[2] * _e82))), array<f64, 3>((param_3[0] - (param_5[0] * _e126)), (param_3[1] - (param_5[1] * _e126)), (param_3[2] - (param_5[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_838_;
    let _e319 = function_1(_e316[0], _e316[1]);
    let _e321 = function_1(_e319, _e316[2]);
    let _e323 = function_1(_e321, _e316[3]);
    return _e323;
}

fn function_3(param_7: array<f64, 3>, param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: u32) -> array<f64, 3> {
    var phi_437_: bool;
    var phi_471_: array<f64, 3>;
    var phi_472_: bool;
    var phi_473_: array<f64, 3>;
    var phi_474_: bool;
    var phi_479_: array<f64, 3>;

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
        phi_437_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_437_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_437_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_471_ = array<f64, 3>((param_7[0] - ((param_8[0] * _e76) + (param_9[0] * _e80))), (param_7[1] - ((param_8[1] * _e76) + (param_9[1] * _e80))), (param_7[2] - ((param_8[2] * _e76) + (param_9[2] * _e80))));
            phi_472_ = false;
        } else {
            phi_471_ = array<f64, 3>();
            phi_472_ = true;
        }
        let _e132 = phi_471_;
        let _e134 = phi_472_;
        phi_473_ = _e132;
        phi_474_ = _e134;
    } else {
        phi_473_ = array<f64, 3>();
        phi_474_ = true;
    }
    let _e136 = phi_473_;
    let _e138 = phi_474_;
    if _e138 {
        let _e139 = function_2(param_7, param_8, param_9, param_10);
        phi_479_ = _e139;
    } else {
        phi_479_ = _e136;
    }
    let _e141 = phi_479_;
    return _e141;
}

fn function_4(param_11: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_11);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_5(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<f32, 3>;
    var local_1: type_40;
    var local_2: type_35;
    var local_3: type_35;
    var local_4: type_35;
    var local_5: type_32;
    var phi_939_: u32;
    var phi_987_: u32;
    var phi_990_: type_9;
    var phi_1145_: type_22;
    var phi_1341_: type_30;
    var phi_1502_: type_32;
    var phi_1776_: bool;
    var phi_1872_: type_36;
    var phi_1873_: bool;
    var phi_1874_: type_36;
    var phi_1875_: bool;
    var phi_1876_: type_36;
    var phi_1877_: bool;
    var phi_1882_: type_36;
    var phi_2052_: type_18;
    var phi_2055_: f64;
    var phi_2053_: type_18;
    var phi_2096_: type_19;
    var phi_2056_: f64;
    var local_6: f64;
    var phi_2109_: f64;
    var phi_3036_: type_38;
    var phi_3037_: bool;
    var phi_3038_: type_38;
    var phi_3039_: bool;
    var phi_3045_: type_18;
    var phi_3048_: f64;
    var phi_3050_: u32;
    var phi_3052_: f64;
    var phi_3046_: type_18;
    var phi_3093_: type_19;
    var phi_3536_: type_9;
    var phi_3539_: f64;
    var phi_3541_: f64;
    var phi_3543_: f64;
    var phi_3545_: f64;
    var phi_3547_: bool;
    var phi_3549_: u32;
    var phi_3701_: array<f64, 3>;
    var phi_3769_: type_18;
    var phi_3772_: f64;
    var phi_3770_: type_18;
    var phi_3813_: type_19;
    var phi_3773_: f64;
    var local_7: f64;
    var phi_3826_: f64;
    var phi_3952_: type_35;
    var phi_3953_: bool;
    var phi_3954_: type_35;
    var phi_3955_: bool;
    var phi_3965_: type_35;
    var phi_4137_: bool;
    var phi_4138_: bool;
    var phi_4139_: bool;
    var phi_4140_: bool;
    var phi_4141_: bool;
    var phi_4142_: bool;
    var phi_4444_: bool;
    var phi_4445_: bool;
    var phi_4446_: bool;
    var phi_4447_: bool;
    var phi_4448_: bool;
    var phi_4449_: bool;
    var phi_4457_: bool;
    var phi_4567_: f64;
    var phi_4568_: bool;
    var phi_4569_: f64;
    var phi_4570_: bool;
    var phi_4571_: f64;
    var phi_4572_: bool;
    var phi_4573_: bool;
    var phi_4639_: f64;
    var phi_4640_: bool;
    var phi_4641_: f64;
    var phi_4642_: bool;
    var phi_4643_: f64;
    var phi_4644_: bool;
    var phi_4645_: bool;
    var phi_4716_: f64;
    var phi_4717_: bool;
    var phi_4718_: f64;
    var phi_4719_: bool;
    var phi_4720_: f64;
    var phi_4721_: bool;
    var phi_4722_: bool;
    var phi_4788_: f64;
    var phi_4789_: bool;
    var phi_4790_: f64;
    var phi_4791_: bool;
    var phi_4792_: f64;
    var phi_4793_: bool;
    var phi_4794_: bool;
    var phi_4971_: type_18;
    var phi_4974_: f64;
    var phi_4972_: type_18;
    var phi_5015_: type_19;
    var phi_4975_: f64;
    var local_8: f64;
    var phi_5028_: f64;
    var phi_5305_: bool;
    var phi_5306_: bool;
    var phi_5333_: f64;
    var phi_5334_: f64;
    var phi_5335_: bool;
    var phi_5336_: f64;
    var phi_5337_: f64;
    var phi_5338_: bool;
    var phi_5339_: bool;
    var phi_5340_: f64;
    var phi_5341_: f64;
    var phi_5342_: f64;
    var phi_5343_: f64;
    var phi_5344_: bool;
    var phi_5345_: bool;
    var phi_5346_: bool;
    var phi_5347_: bool;
    var phi_5348_: f64;
    var phi_5349_: f64;
    var phi_5350_: f64;
    var phi_5351_: f64;
    var phi_5352_: bool;
    var phi_5353_: bool;
    var phi_5354_: bool;
    var phi_5355_: bool;
    var phi_5356_: bool;
    var phi_5357_: f64;
    var phi_5358_: f64;
    var phi_5359_: f64;
    var phi_5360_: f64;
    var phi_5361_: bool;
    var phi_5362_: bool;
    var phi_5363_: bool;
    var phi_5364_: bool;
    var phi_5365_: bool;
    var phi_5703_: f64;
    var phi_5705_: u32;
    var phi_5706_: f64;
    var phi_5707_: bool;
    var phi_5708_: bool;
    var phi_5709_: bool;
    var phi_5710_: u32;
    var phi_5711_: f64;
    var phi_5712_: f64;
    var phi_5713_: f64;
    var phi_5714_: f64;
    var phi_5715_: bool;
    var phi_5716_: u32;
    var phi_5717_: bool;
    var phi_5718_: bool;
    var phi_5719_: bool;
    var phi_5720_: bool;
    var phi_5721_: bool;
    var phi_5722_: bool;
    var phi_5750_: f64;
    var phi_5751_: f64;
    var phi_5752_: f64;
    var phi_5753_: f64;
    var phi_5754_: bool;
    var phi_5755_: u32;
    var phi_5756_: bool;
    var phi_5757_: bool;
    var phi_5758_: bool;
    var phi_5759_: bool;
    var phi_5760_: bool;
    var phi_5761_: bool;
    var phi_3540_: f64;
    var phi_3542_: f64;
    var phi_3544_: f64;
    var phi_3546_: f64;
    var phi_3548_: bool;
    var phi_3550_: u32;
    var phi_5762_: f64;
    var phi_5763_: f64;
    var phi_5764_: bool;
    var phi_5765_: bool;
    var phi_5766_: bool;
    var phi_5767_: bool;
    var phi_5768_: bool;
    var phi_5769_: bool;
    var phi_5770_: bool;
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
    var phi_5837_: f64;
    var phi_5838_: bool;
    var phi_6463_: type_18;
    var phi_6466_: f64;
    var phi_6464_: type_18;
    var phi_6507_: type_19;
    var phi_6467_: f64;
    var local_24: f64;
    var phi_6520_: f64;
    var phi_6758_: type_18;
    var phi_6761_: f64;
    var phi_6759_: type_18;
    var phi_6802_: type_19;
    var phi_6762_: f64;
    var local_25: f64;
    var phi_6815_: f64;
    var phi_6847_: type_18;
    var phi_6850_: f64;
    var phi_6848_: type_18;
    var phi_6891_: type_19;
    var phi_6851_: f64;
    var local_26: f64;
    var phi_6904_: f64;
    var phi_7222_: type_9;
    var phi_7225_: f64;
    var phi_7226_: f64;
    var local_27: f64;
    var local_28: f64;
    var phi_7327_: type_18;
    var phi_7330_: f64;
    var phi_7328_: type_18;
    var phi_7371_: type_19;
    var phi_7331_: f64;
    var local_29: f64;
    var phi_7384_: f64;
    var phi_7391_: type_9;
    var phi_7394_: f64;
    var phi_7396_: bool;
    var phi_7398_: bool;
    var phi_7634_: f64;
    var phi_7635_: f64;
    var phi_7395_: f64;
    var phi_7397_: bool;
    var phi_7399_: bool;
    var local_30: f64;
    var local_31: f64;
    var local_32: bool;
    var local_33: bool;
    var local_34: bool;
    var local_35: bool;
    var phi_7653_: type_41;
    var phi_7654_: bool;
    var local_36: bool;
    var phi_7676_: type_9;
    var phi_7679_: f64;
    var phi_7681_: f64;
    var phi_7791_: f64;
    var phi_7792_: f64;
    var phi_7793_: f64;
    var phi_7794_: f64;
    var phi_7680_: f64;
    var phi_7682_: f64;
    var local_37: f64;
    var local_38: f64;
    var local_39: f64;
    var phi_7957_: bool;
    var phi_7958_: bool;
    var phi_7959_: bool;
    var phi_7960_: bool;
    var phi_7961_: bool;
    var phi_7962_: bool;
    var phi_7971_: bool;
    var phi_7972_: bool;
    var phi_7981_: type_41;
    var phi_7982_: type_41;
    var phi_7983_: bool;
    var phi_7984_: type_41;
    var phi_7985_: type_41;
    var phi_7986_: bool;
    var phi_7992_: type_41;
    var phi_7993_: type_41;
    var phi_7994_: bool;
    var phi_7998_: type_41;
    var phi_7999_: type_41;
    var phi_8000_: bool;
    var phi_8001_: bool;
    var phi_8002_: type_41;
    var phi_8003_: type_41;
    var phi_8004_: bool;
    var phi_8005_: bool;
    var phi_8040_: f64;
    var phi_8041_: f64;
    var phi_8042_: bool;
    var phi_8043_: bool;
    var phi_8044_: bool;
    var phi_8045_: f64;
    var phi_8046_: u32;
    var phi_8047_: f64;
    var phi_8048_: type_41;
    var phi_8049_: u32;
    var phi_8050_: u32;
    var phi_8051_: bool;
    var phi_8052_: bool;
    var phi_8053_: bool;
    var phi_8054_: f64;
    var phi_8055_: u32;
    var phi_8056_: f64;
    var phi_8057_: type_41;
    var phi_8058_: u32;
    var phi_8059_: u32;
    var phi_8060_: bool;
    var phi_8061_: bool;
    var phi_8062_: bool;
    var phi_8063_: bool;
    var phi_8064_: bool;
    var phi_8065_: f64;
    var phi_3049_: f64;
    var phi_3051_: u32;
    var phi_3053_: f64;
    var phi_8066_: type_41;
    var phi_8067_: u32;
    var phi_8068_: f64;
    var phi_8069_: u32;
    var phi_8070_: bool;
    var phi_8071_: bool;
    var phi_8072_: bool;
    var phi_8073_: bool;
    var phi_8074_: bool;
    var phi_8075_: bool;
    var local_40: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: type_41;
    var local_49: type_41;
    var local_50: u32;
    var local_51: type_41;
    var phi_8104_: type_38;
    var phi_8105_: type_38;
    var phi_8106_: bool;
    var phi_8107_: bool;
    var phi_8108_: bool;
    var phi_8109_: bool;
    var local_52: u32;
    var local_53: u32;
    var local_54: f64;
    var local_55: f64;
    var local_56: f64;
    var local_57: u32;
    var phi_8143_: type_9;
    var phi_8319_: type_18;
    var phi_8322_: f64;
    var phi_8320_: type_18;
    var phi_8363_: type_19;
    var phi_8323_: f64;
    var local_58: f64;
    var phi_8376_: f64;
    var phi_8653_: bool;
    var phi_8654_: bool;
    var local_59: bool;
    var phi_8666_: type_38;
    var phi_8667_: bool;
    var phi_8679_: type_38;
    var phi_8680_: type_38;
    var phi_8681_: bool;
    var phi_8682_: bool;
    var phi_8689_: type_38;
    var phi_8690_: bool;
    var phi_8694_: type_38;
    var phi_8695_: type_38;
    var phi_8696_: bool;
    var phi_8700_: type_38;
    var phi_8718_: type_34;
    var phi_8719_: type_34;
    var phi_8720_: type_9;
    var phi_8760_: u32;
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
    let _e101 = id_2;
    let _e102 = n_2;
    let _e103 = lane_2;
    let _e115 = ((_e101.y * _e102.x) + _e101.x);
    let _e118 = (_e102.x * _e102.y);
    let _e121 = params.member.member_1.member_2;
    let _e123 = input.member[0u];
    let _e125 = select(_e123, _e121, (_e121 < _e123));
    let _e127 = params.member.member_1.member_1;
    if (_e125 > _e127) {
        let _e130 = params.member.member_1.member_1;
        phi_939_ = (_e125 - _e130);
    } else {
        phi_939_ = 0u;
    }
    let _e133 = phi_939_;
    let _e135 = params.member.member_1.member;
    let _e137 = select(_e133, _e135, (_e135 < _e133));
    let _e140 = params.member.member_2.member;
    let _e141 = (_e137 / 64u);
    let _e145 = select(_e141, (_e141 + 1u), ((_e137 % 64u) > 0u));
    if (_e145 > _e115) {
        let _e147 = (_e145 - _e115);
        if (_e118 == 0u) {
            return;
        }
        let _e149 = (_e147 / _e118);
        if (_e118 == 0u) {
            return;
        }
        phi_987_ = select(_e149, (_e149 + 1u), ((_e147 % _e118) > 0u));
    } else {
        phi_987_ = 0u;
    }
    let _e156 = phi_987_;
    phi_990_ = type_9(0u, _e156);
    loop {
        let _e159 = phi_990_;
        let _e162 = (_e159.member < _e159.member_1);
        let _e175 = (bitcast<i32>(select(0u, 1u, _e162)) != 0i);
        if _e175 {
            let _e179 = (((_e115 + (select(type_9().member_1, _e159.member, _e162) * _e118)) * 64u) + _e103);
            if (_e179 < _e137) {
                let _e183 = params.member.member_1.member_1;
                let _e185 = (2u * (_e183 + _e179));
                let _e188 = input.member[(4u + _e185)];
                let _e191 = input.member[(_e185 + 5u)];
                if (_e140 == 0u) {
                    let _e209 = (3u * _e191);
                    let _e211 = elements.member[_e209];
                    let _e214 = elements.member[(_e209 + 1u)];
                    let _e217 = elements.member[(_e209 + 2u)];
                    phi_1145_ = type_22(0u, array<u32, 4>(_e188, _e211, _e214, _e217));
                } else {
                    let _e195 = (2u * _e188);
                    let _e196 = (2u * _e191);
                    let _e198 = elements.member[_e195];
                    let _e200 = elements.member[_e196];
                    let _e203 = elements.member[(_e195 + 1u)];
                    let _e206 = elements.member[(_e196 + 1u)];
                    phi_1145_ = type_22(1u, array<u32, 4>(_e198, _e203, _e200, _e206));
                }
                let _e221 = phi_1145_;
                let _e225 = params.member.member.member_1;
                if ((_e225 & 8u) != 0u) {
                    let _e269 = paths.member[_e221.member_1[0]];
                    let _e284 = paths.member[_e221.member_1[1]];
                    let _e299 = paths.member[_e221.member_1[2]];
                    let _e314 = paths.member[_e221.member_1[3]];
                    let _e335 = function_(array<f32, 3>(_e269.member.x, _e269.member.y, _e269.member.z));
                    let _e336 = function_(array<f32, 3>(_e284.member.x, _e284.member.y, _e284.member.z));
                    let _e337 = function_(array<f32, 3>(_e299.member.x, _e299.member.y, _e299.member.z));
                    let _e338 = function_(array<f32, 3>(_e314.member.x, _e314.member.y, _e314.member.z));
                    let _e340 = function_(array<f32, 3>(_e269.member_1.x, _e269.member_1.y, _e269.member_1.z));
                    let _e341 = function_(array<f32, 3>(_e284.member_1.x, _e284.member_1.y, _e284.member_1.z));
                    let _e342 = function_(array<f32, 3>(_e299.member_1.x, _e299.member_1.y, _e299.member_1.z));
                    let _e343 = function_(array<f32, 3>(_e314.member_1.x, _e314.member_1.y, _e314.member_1.z));
                    phi_1341_ = type_30(array<array<f64, 3>, 4>(_e335, _e336, _e337, _e338), array<array<f64, 3>, 4>(_e340, _e341, _e342, _e343));
                } else {
                    let _e230 = positions.member[_e221.member_1[0]];
                    let _e233 = params.member.member.member[0u];
                    let _e236 = positions.member[(_e233 + _e221.member_1[0])];
                    let _e239 = positions.member[_e221.member_1[1]];
                    let _e242 = params.member.member.member[0u];
                    let _e245 = positions.member[(_e242 + _e221.member_1[1])];
                    let _e248 = positions.member[_e221.member_1[2]];
                    let _e251 = params.member.member.member[0u];
                    let _e254 = positions.member[(_e251 + _e221.member_1[2])];
                    let _e257 = positions.member[_e221.member_1[3]];
                    let _e260 = params.member.member.member[0u];
                    let _e263 = positions.member[(_e260 + _e221.member_1[3])];
                    phi_1341_ = type_30(array<array<f64, 3>, 4>(_e230, _e239, _e248, _e257), array<array<f64, 3>, 4>(_e236, _e245, _e254, _e263));
                }
                let _e347 = phi_1341_;
                if (_e221.member != 0u) {
                    phi_1502_ = type_32(array<array<f64, 3>, 2>(array<f64, 3>((_e347.member[2][0] - _e347.member[0][0]), (_e347.member[2][1] - _e347.member[0][1]), (_e347.member[2][2] - _e347.member[0][2])), array<f64, 3>((_e347.member_1[2][0] - _e347.member_1[0][0]), (_e347.member_1[2][1] - _e347.member_1[0][1]), (_e347.member_1[2][2] - _e347.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e347.member[1][0] - _e347.member[0][0]), (_e347.member[1][1] - _e347.member[0][1]), (_e347.member[1][2] - _e347.member[0][2])), array<f64, 3>((_e347.member_1[1][0] - _e347.member_1[0][0]), (_e347.member_1[1][1] - _e347.member_1[0][1]), (_e347.member_1[1][2] - _e347.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e347.member[2][0] - _e347.member[3][0]), (_e347.member[2][1] - _e347.member[3][1]), (_e347.member[2][2] - _e347.member[3][2])), array<f64, 3>((_e347.member_1[2][0] - _e347.member_1[3][0]), (_e347.member_1[2][1] - _e347.member_1[3][1]), (_e347.member_1[2][2] - _e347.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_1502_ = type_32(array<array<f64, 3>, 2>(array<f64, 3>((_e347.member[0][0] - _e347.member[1][0]), (_e347.member[0][1] - _e347.member[1][1]), (_e347.member[0][2] - _e347.member[1][2])), array<f64, 3>((_e347.member_1[0][0] - _e347.member_1[1][0]), (_e347.member_1[0][1] - _e347.member_1[1][1]), (_e347.member_1[0][2] - _e347.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e347.member[2][0] - _e347.member[1][0]), (_e347.member[2][1] - _e347.member[1][1]), (_e347.member[2][2] - _e347.member[1][2])), array<f64, 3>((_e347.member_1[2][0] - _e347.member_1[1][0]), (_e347.member_1[2][1] - _e347.member_1[1][1]), (_e347.member_1[2][2] - _e347.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e347.member[3][0] - _e347.member[1][0]), (_e347.member[3][1] - _e347.member[1][1]), (_e347.member[3][2] - _e347.member[1][2])), array<f64, 3>((_e347.member_1[3][0] - _e347.member_1[1][0]), (_e347.member_1[3][1] - _e347.member_1[1][1]), (_e347.member_1[3][2] - _e347.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e506 = phi_1502_;
                let _e508 = params.member.member.member_7;
                let _e515 = bitcast<f64>(((u64(_e508[1]) * 4294967296lu) + u64(_e508[0])));
                let _e517 = params.member.member.member_14;
                let _e524 = bitcast<f64>(((u64(_e517[1]) * 4294967296lu) + u64(_e517[0])));
                let _e526 = params.member.member.member_15;
                let _e533 = bitcast<f64>(((u64(_e526[1]) * 4294967296lu) + u64(_e526[0])));
                let _e535 = params.member.member.member_16;
                let _e542 = bitcast<f64>(((u64(_e535[1]) * 4294967296lu) + u64(_e535[0])));
                let _e544 = params.member.member.member_1;
                let _e552 = select(_e506.member[0][0], -(_e506.member[0][0]), (_e506.member[0][0] < 0.0lf));
                let _e556 = select(_e506.member[0][1], -(_e506.member[0][1]), (_e506.member[0][1] < 0.0lf));
                let _e558 = select(_e556, _e552, (_e552 > _e556));
                let _e562 = select(_e506.member[0][2], -(_e506.member[0][2]), (_e506.member[0][2] < 0.0lf));
                let _e564 = select(_e562, _e558, (_e558 > _e562));
                let _e570 = select(_e506.member[1][0], -(_e506.member[1][0]), (_e506.member[1][0] < 0.0lf));
                let _e574 = select(_e506.member[1][1], -(_e506.member[1][1]), (_e506.member[1][1] < 0.0lf));
                let _e576 = select(_e574, _e570, (_e570 > _e574));
                let _e580 = select(_e506.member[1][2], -(_e506.member[1][2]), (_e506.member[1][2] < 0.0lf));
                let _e582 = select(_e580, _e576, (_e576 > _e580));
                let _e586 = (select(_e582, _e564, (_e564 > _e582)) + _e506.member_3);
                let _e592 = select(_e506.member_1[0][0], -(_e506.member_1[0][0]), (_e506.member_1[0][0] < 0.0lf));
                let _e596 = select(_e506.member_1[0][1], -(_e506.member_1[0][1]), (_e506.member_1[0][1] < 0.0lf));
                let _e598 = select(_e596, _e592, (_e592 > _e596));
                let _e602 = select(_e506.member_1[0][2], -(_e506.member_1[0][2]), (_e506.member_1[0][2] < 0.0lf));
                let _e604 = select(_e602, _e598, (_e598 > _e602));
                let _e610 = select(_e506.member_1[1][0], -(_e506.member_1[1][0]), (_e506.member_1[1][0] < 0.0lf));
                let _e614 = select(_e506.member_1[1][1], -(_e506.member_1[1][1]), (_e506.member_1[1][1] < 0.0lf));
                let _e616 = select(_e614, _e610, (_e610 > _e614));
                let _e620 = select(_e506.member_1[1][2], -(_e506.member_1[1][2]), (_e506.member_1[1][2] < 0.0lf));
                let _e622 = select(_e620, _e616, (_e616 > _e620));
                let _e626 = (select(_e622, _e604, (_e604 > _e622)) + _e506.member_3);
                let _e632 = select(_e506.member_2[0][0], -(_e506.member_2[0][0]), (_e506.member_2[0][0] < 0.0lf));
                let _e636 = select(_e506.member_2[0][1], -(_e506.member_2[0][1]), (_e506.member_2[0][1] < 0.0lf));
                let _e638 = select(_e636, _e632, (_e632 > _e636));
                let _e642 = select(_e506.member_2[0][2], -(_e506.member_2[0][2]), (_e506.member_2[0][2] < 0.0lf));
                let _e644 = select(_e642, _e638, (_e638 > _e642));
                let _e650 = select(_e506.member_2[1][0], -(_e506.member_2[1][0]), (_e506.member_2[1][0] < 0.0lf));
                let _e654 = select(_e506.member_2[1][1], -(_e506.member_2[1][1]), (_e506.member_2[1][1] < 0.0lf));
                let _e656 = select(_e654, _e650, (_e650 > _e654));
                let _e660 = select(_e506.member_2[1][2], -(_e506.member_2[1][2]), (_e506.member_2[1][2] < 0.0lf));
                let _e662 = select(_e660, _e656, (_e656 > _e660));
                let _e666 = (select(_e662, _e644, (_e644 > _e662)) + _e506.member_3);
                let _e668 = select(_e626, _e586, (_e586 > _e626));
                let _e670 = select(_e666, _e668, (_e668 > _e666));
                if (_e670 <= f64(65536f)) {
                    phi_1776_ = (_e670 >= f64((1f / 65536f)));
                } else {
                    phi_1776_ = false;
                }
                let _e677 = phi_1776_;
                if _e677 {
                    phi_1876_ = type_36();
                    phi_1877_ = true;
                } else {
                    if (_e670 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e670) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e684 = (9214364837600034816lu - (bitcast<u64>(_e670) & 9218868437227405312lu));
                            let _e687 = bitcast<f64>(select(4503599627370496lu, _e684, (_e684 > 4503599627370496lu)));
                            let _e688 = (_e515 * _e687);
                            phi_1872_ = type_36(type_32(array<array<f64, 3>, 2>(array<f64, 3>((_e506.member[0][0] * _e687), (_e506.member[0][1] * _e687), (_e506.member[0][2] * _e687)), array<f64, 3>((_e506.member[1][0] * _e687), (_e506.member[1][1] * _e687), (_e506.member[1][2] * _e687))), array<array<f64, 3>, 2>(array<f64, 3>((_e506.member_1[0][0] * _e687), (_e506.member_1[0][1] * _e687), (_e506.member_1[0][2] * _e687)), array<f64, 3>((_e506.member_1[1][0] * _e687), (_e506.member_1[1][1] * _e687), (_e506.member_1[1][2] * _e687))), array<array<f64, 3>, 2>(array<f64, 3>((_e506.member_2[0][0] * _e687), (_e506.member_2[0][1] * _e687), (_e506.member_2[0][2] * _e687)), array<f64, 3>((_e506.member_2[1][0] * _e687), (_e506.member_2[1][1] * _e687), (_e506.member_2[1][2] * _e687))), ((_e506.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e687)), select(_e688, select(2.2250738585072014e-308lf, _e688, (_e688 > 2.2250738585072014e-308lf)), (_e515 > f64(0f))));
                            phi_1873_ = false;
                        } else {
                            phi_1872_ = type_36();
                            phi_1873_ = true;
                        }
                        let _e759 = phi_1872_;
                        let _e761 = phi_1873_;
                        phi_1874_ = _e759;
                        phi_1875_ = _e761;
                    } else {
                        phi_1874_ = type_36();
                        phi_1875_ = true;
                    }
                    let _e763 = phi_1874_;
                    let _e765 = phi_1875_;
                    phi_1876_ = _e763;
                    phi_1877_ = _e765;
                }
                let _e767 = phi_1876_;
                let _e769 = phi_1877_;
                if _e769 {
                    phi_1882_ = type_36(_e506, _e515);
                } else {
                    phi_1882_ = _e767;
                }
                let _e772 = phi_1882_;
                local_5 = type_32(array<array<f64, 3>, 2>(array<f64, 3>(_e772.member.member[0][0], _e772.member.member[0][1], _e772.member.member[0][2]), array<f64, 3>(_e772.member.member[1][0], _e772.member.member[1][1], _e772.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e772.member.member_1[0][0], _e772.member.member_1[0][1], _e772.member.member_1[0][2]), array<f64, 3>(_e772.member.member_1[1][0], _e772.member.member_1[1][1], _e772.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e772.member.member_2[0][0], _e772.member.member_2[0][1], _e772.member.member_2[0][2]), array<f64, 3>(_e772.member.member_2[1][0], _e772.member.member_2[1][1], _e772.member.member_2[1][2])), _e772.member.member_3);
                let _e815 = local_5.member[0u];
                let _e821 = local_5.member[1u];
                let _e837 = local_5.member_1[0u];
                let _e843 = local_5.member_1[1u];
                let _e859 = local_5.member_2[0u];
                let _e865 = local_5.member_2[1u];
                let _e879 = function_3(array<f64, 3>((_e815[0] + ((_e821[0] - _e815[0]) * _e533)), (_e815[1] + ((_e821[1] - _e815[1]) * _e533)), (_e815[2] + ((_e821[2] - _e815[2]) * _e533))), array<f64, 3>((_e837[0] + ((_e843[0] - _e837[0]) * _e533)), (_e837[1] + ((_e843[1] - _e837[1]) * _e533)), (_e837[2] + ((_e843[2] - _e837[2]) * _e533))), array<f64, 3>((_e859[0] + ((_e865[0] - _e859[0]) * _e533)), (_e859[1] + ((_e865[1] - _e859[1]) * _e533)), (_e859[2] + ((_e865[2] - _e859[2]) * _e533))), _e221.member);
                let _e890 = (((_e879[0] * _e879[0]) + (_e879[1] * _e879[1])) + (_e879[2] * _e879[2]));
                if (_e890 <= 2.2250738585072014e-308lf) {
                    phi_2109_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e890 > 0.0lf));
                } else {
                    phi_2052_ = type_18(0i, 5i);
                    phi_2055_ = bitcast<f64>(((bitcast<u64>(_e890) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e897 = phi_2052_;
                        let _e899 = phi_2055_;
                        local_6 = _e899;
                        if (_e897.member < _e897.member_1) {
                            let _e906 = (_e897.member + 1i);
                            phi_2053_ = type_18(select(_e906, type_19().member_1, select(false, true, ((false == (_e906 > _e897.member)) != false))), _e897.member_1);
                            phi_2096_ = type_19(1u, _e897.member);
                        } else {
                            phi_2053_ = _e897;
                            phi_2096_ = type_19(0u, type_19().member_1);
                        }
                        let _e917 = phi_2053_;
                        let _e919 = phi_2096_;
                        let _e922 = (bitcast<i32>(_e919.member) != 0i);
                        if _e922 {
                            phi_2056_ = (0.5lf * (_e899 + (_e890 / _e899)));
                        } else {
                            phi_2056_ = f64();
                        }
                        let _e927 = phi_2056_;
                        continue;
                        continuing {
                            phi_2052_ = _e917;
                            phi_2055_ = _e927;
                            break if !(_e922);
                        }
                    }
                    let _e932 = local_6;
                    phi_2109_ = (_e932 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e938 = phi_2109_;
                let _e946 = local_5.member[0u];
                let _e952 = select(_e946[0], -(_e946[0]), (_e946[0] < 0.0lf));
                let _e955 = select(_e946[1], -(_e946[1]), (_e946[1] < 0.0lf));
                let _e957 = select(_e955, _e952, (_e952 > _e955));
                let _e960 = select(_e946[2], -(_e946[2]), (_e946[2] < 0.0lf));
                let _e962 = select(_e960, _e957, (_e957 > _e960));
                let _e965 = local_5.member[1u];
                let _e971 = select(_e965[0], -(_e965[0]), (_e965[0] < 0.0lf));
                let _e974 = select(_e965[1], -(_e965[1]), (_e965[1] < 0.0lf));
                let _e976 = select(_e974, _e971, (_e971 > _e974));
                let _e979 = select(_e965[2], -(_e965[2]), (_e965[2] < 0.0lf));
                let _e981 = select(_e979, _e976, (_e976 > _e979));
                let _e985 = local_5.member_3;
                let _e989 = local_5.member_1[0u];
                let _e995 = select(_e989[0], -(_e989[0]), (_e989[0] < 0.0lf));
                let _e998 = select(_e989[1], -(_e989[1]), (_e989[1] < 0.0lf));
                let _e1000 = select(_e998, _e995, (_e995 > _e998));
                let _e1003 = select(_e989[2], -(_e989[2]), (_e989[2] < 0.0lf));
                let _e1005 = select(_e1003, _e1000, (_e1000 > _e1003));
                let _e1008 = local_5.member_1[1u];
                let _e1014 = select(_e1008[0], -(_e1008[0]), (_e1008[0] < 0.0lf));
                let _e1017 = select(_e1008[1], -(_e1008[1]), (_e1008[1] < 0.0lf));
                let _e1019 = select(_e1017, _e1014, (_e1014 > _e1017));
                let _e1022 = select(_e1008[2], -(_e1008[2]), (_e1008[2] < 0.0lf));
                let _e1024 = select(_e1022, _e1019, (_e1019 > _e1022));
                let _e1028 = local_5.member_3;
                let _e1032 = local_5.member_2[0u];
                let _e1038 = select(_e1032[0], -(_e1032[0]), (_e1032[0] < 0.0lf));
                let _e1041 = select(_e1032[1], -(_e1032[1]), (_e1032[1] < 0.0lf));
                let _e1043 = select(_e1041, _e1038, (_e1038 > _e1041));
                let _e1046 = select(_e1032[2], -(_e1032[2]), (_e1032[2] < 0.0lf));
                let _e1048 = select(_e1046, _e1043, (_e1043 > _e1046));
                let _e1051 = local_5.member_2[1u];
                let _e1057 = select(_e1051[0], -(_e1051[0]), (_e1051[0] < 0.0lf));
                let _e1060 = select(_e1051[1], -(_e1051[1]), (_e1051[1] < 0.0lf));
                let _e1062 = select(_e1060, _e1057, (_e1057 > _e1060));
                let _e1065 = select(_e1051[2], -(_e1051[2]), (_e1051[2] < 0.0lf));
                let _e1067 = select(_e1065, _e1062, (_e1062 > _e1065));
                let _e1071 = local_5.member_3;
                let _e1079 = local_5.member_3;
                let _e1089 = (((_e938 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e981, _e962, (_e962 > _e981)) + _e985) + (select(_e1024, _e1005, (_e1005 > _e1024)) + _e1028)) + (select(_e1067, _e1048, (_e1048 > _e1067)) + _e1071)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1079 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e772.member_1);
                if _e1089 {
                    phi_3038_ = type_38();
                    phi_3039_ = true;
                } else {
                    let _e1092 = local_5.member_1[0u];
                    let _e1098 = local_5.member_2[0u];
                    let _e1104 = ((_e1092[1] * _e1098[2]) - (_e1092[2] * _e1098[1]));
                    let _e1107 = ((_e1092[2] * _e1098[0]) - (_e1092[0] * _e1098[2]));
                    let _e1110 = ((_e1092[0] * _e1098[1]) - (_e1092[1] * _e1098[0]));
                    let _e1113 = local_5.member_1[1u];
                    let _e1119 = local_5.member_2[1u];
                    let _e1125 = ((_e1113[1] * _e1119[2]) - (_e1113[2] * _e1119[1]));
                    let _e1128 = ((_e1113[2] * _e1119[0]) - (_e1113[0] * _e1119[2]));
                    let _e1131 = ((_e1113[0] * _e1119[1]) - (_e1113[1] * _e1119[0]));
                    let _e1134 = local_5.member_1[0u];
                    let _e1140 = local_5.member_2[1u];
                    let _e1155 = local_5.member_1[1u];
                    let _e1161 = local_5.member_2[0u];
                    let _e1174 = (((_e1134[1] * _e1140[2]) - (_e1134[2] * _e1140[1])) + ((_e1155[1] * _e1161[2]) - (_e1155[2] * _e1161[1])));
                    let _e1175 = (((_e1134[2] * _e1140[0]) - (_e1134[0] * _e1140[2])) + ((_e1155[2] * _e1161[0]) - (_e1155[0] * _e1161[2])));
                    let _e1176 = (((_e1134[0] * _e1140[1]) - (_e1134[1] * _e1140[0])) + ((_e1155[0] * _e1161[1]) - (_e1155[1] * _e1161[0])));
                    let _e1179 = local_5.member[0u];
                    let _e1190 = local_5.member[1u];
                    let _e1201 = local_5.member[0u];
                    let _e1210 = ((((_e1190[0] * _e1104) + (_e1190[1] * _e1107)) + (_e1190[2] * _e1110)) + (((_e1201[0] * _e1174) + (_e1201[1] * _e1175)) + (_e1201[2] * _e1176)));
                    let _e1213 = local_5.member[0u];
                    let _e1224 = local_5.member[1u];
                    let _e1233 = ((((_e1213[0] * _e1125) + (_e1213[1] * _e1128)) + (_e1213[2] * _e1131)) + (((_e1224[0] * _e1174) + (_e1224[1] * _e1175)) + (_e1224[2] * _e1176)));
                    let _e1236 = local_5.member[1u];
                    let _e1247 = local_5.member[0u];
                    let _e1253 = select(_e1247[0], -(_e1247[0]), (_e1247[0] < 0.0lf));
                    let _e1256 = select(_e1247[1], -(_e1247[1]), (_e1247[1] < 0.0lf));
                    let _e1258 = select(_e1256, _e1253, (_e1253 > _e1256));
                    let _e1261 = select(_e1247[2], -(_e1247[2]), (_e1247[2] < 0.0lf));
                    let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                    let _e1266 = local_5.member[1u];
                    let _e1272 = select(_e1266[0], -(_e1266[0]), (_e1266[0] < 0.0lf));
                    let _e1275 = select(_e1266[1], -(_e1266[1]), (_e1266[1] < 0.0lf));
                    let _e1277 = select(_e1275, _e1272, (_e1272 > _e1275));
                    let _e1280 = select(_e1266[2], -(_e1266[2]), (_e1266[2] < 0.0lf));
                    let _e1282 = select(_e1280, _e1277, (_e1277 > _e1280));
                    let _e1286 = local_5.member_3;
                    let _e1287 = (select(_e1282, _e1263, (_e1263 > _e1282)) + _e1286);
                    let _e1290 = local_5.member_1[0u];
                    let _e1296 = select(_e1290[0], -(_e1290[0]), (_e1290[0] < 0.0lf));
                    let _e1299 = select(_e1290[1], -(_e1290[1]), (_e1290[1] < 0.0lf));
                    let _e1301 = select(_e1299, _e1296, (_e1296 > _e1299));
                    let _e1304 = select(_e1290[2], -(_e1290[2]), (_e1290[2] < 0.0lf));
                    let _e1306 = select(_e1304, _e1301, (_e1301 > _e1304));
                    let _e1309 = local_5.member_1[1u];
                    let _e1315 = select(_e1309[0], -(_e1309[0]), (_e1309[0] < 0.0lf));
                    let _e1318 = select(_e1309[1], -(_e1309[1]), (_e1309[1] < 0.0lf));
                    let _e1320 = select(_e1318, _e1315, (_e1315 > _e1318));
                    let _e1323 = select(_e1309[2], -(_e1309[2]), (_e1309[2] < 0.0lf));
                    let _e1325 = select(_e1323, _e1320, (_e1320 > _e1323));
                    let _e1329 = local_5.member_3;
                    let _e1330 = (select(_e1325, _e1306, (_e1306 > _e1325)) + _e1329);
                    let _e1333 = local_5.member_2[0u];
                    let _e1339 = select(_e1333[0], -(_e1333[0]), (_e1333[0] < 0.0lf));
                    let _e1342 = select(_e1333[1], -(_e1333[1]), (_e1333[1] < 0.0lf));
                    let _e1344 = select(_e1342, _e1339, (_e1339 > _e1342));
                    let _e1347 = select(_e1333[2], -(_e1333[2]), (_e1333[2] < 0.0lf));
                    let _e1349 = select(_e1347, _e1344, (_e1344 > _e1347));
                    let _e1352 = local_5.member_2[1u];
                    let _e1358 = select(_e1352[0], -(_e1352[0]), (_e1352[0] < 0.0lf));
                    let _e1361 = select(_e1352[1], -(_e1352[1]), (_e1352[1] < 0.0lf));
                    let _e1363 = select(_e1361, _e1358, (_e1358 > _e1361));
                    let _e1366 = select(_e1352[2], -(_e1352[2]), (_e1352[2] < 0.0lf));
                    let _e1368 = select(_e1366, _e1363, (_e1363 > _e1366));
                    let _e1372 = local_5.member_3;
                    let _e1373 = (select(_e1368, _e1349, (_e1349 > _e1368)) + _e1372);
                    let _e1374 = f64(1f);
                    let _e1375 = f64(8f);
                    let _e1377 = ((_e1330 * _e1375) * _e1373);
                    let _e1385 = local_5.member_3;
                    let _e1412 = ((select(_e1104, -(_e1104), (_e1104 < 0.0lf)) + select(_e1107, -(_e1107), (_e1107 < 0.0lf))) + select(_e1110, -(_e1110), (_e1110 < 0.0lf)));
                    let _e1423 = ((select(_e1125, -(_e1125), (_e1125 < 0.0lf)) + select(_e1128, -(_e1128), (_e1128 < 0.0lf))) + select(_e1131, -(_e1131), (_e1131 < 0.0lf)));
                    let _e1425 = select(_e1423, _e1412, (_e1412 > _e1423));
                    let _e1437 = (((select(_e1174, -(_e1174), (_e1174 < 0.0lf)) + select(_e1175, -(_e1175), (_e1175 < 0.0lf))) + select(_e1176, -(_e1176), (_e1176 < 0.0lf))) * f64(0.5f));
                    let _e1445 = local_5.member_3;
                    let _e1460 = f64(3f);
                    let _e1461 = ((((_e1179[0] * _e1104) + (_e1179[1] * _e1107)) + (_e1179[2] * _e1110)) * _e1460);
                    let _e1462 = ((((_e1236[0] * _e1125) + (_e1236[1] * _e1128)) + (_e1236[2] * _e1131)) * _e1460);
                    let _e1464 = select(_e1462, _e1461, (_e1461 < _e1462));
                    let _e1466 = select(_e1233, _e1210, (_e1210 < _e1233));
                    let _e1468 = select(_e1466, _e1464, (_e1464 < _e1466));
                    let _e1470 = select(_e1462, _e1461, (_e1461 > _e1462));
                    let _e1472 = select(_e1233, _e1210, (_e1210 > _e1233));
                    let _e1480 = -(select(_e1472, _e1470, (_e1470 > _e1472)));
                    if ((select(_e1480, _e1468, (_e1468 > _e1480)) - ((((((_e1287 * _e1375) * _e1377) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1385 * f64(19f)) * ((_e1287 * (_e1330 + _e1373)) + (_e1330 * _e1373)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1374 + _e1287) * ((_e1374 + _e1330) * (_e1374 + _e1373))))) + ((_e772.member_1 * (((select(_e1437, _e1425, (_e1425 > _e1437)) + (_e1377 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1445 * f64(6f)) * (_e1330 + _e1373))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1374 + _e1330) * (_e1374 + _e1373))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                        phi_3036_ = type_38(type_37(0u, f64()), 0u);
                        phi_3037_ = false;
                    } else {
                        phi_3036_ = type_38();
                        phi_3037_ = true;
                    }
                    let _e1489 = phi_3036_;
                    let _e1491 = phi_3037_;
                    phi_3038_ = _e1489;
                    phi_3039_ = _e1491;
                }
                let _e1493 = phi_3038_;
                let _e1495 = phi_3039_;
                if _e1495 {
                    phi_3045_ = type_18(0i, 2i);
                    phi_3048_ = _e533;
                    phi_3050_ = 0u;
                    phi_3052_ = _e533;
                    loop {
                        let _e1497 = phi_3045_;
                        let _e1499 = phi_3048_;
                        let _e1501 = phi_3050_;
                        let _e1503 = phi_3052_;
                        local_53 = _e1501;
                        local_56 = _e1499;
                        local_57 = _e1501;
                        if (_e1497.member < _e1497.member_1) {
                            let _e1510 = (_e1497.member + 1i);
                            phi_3046_ = type_18(select(_e1510, type_19().member_1, select(false, true, ((false == (_e1510 > _e1497.member)) != false))), _e1497.member_1);
                            phi_3093_ = type_19(1u, _e1497.member);
                        } else {
                            phi_3046_ = _e1497;
                            phi_3093_ = type_19(0u, type_19().member_1);
                        }
                        let _e1521 = phi_3046_;
                        let _e1523 = phi_3093_;
                        if (bitcast<i32>(_e1523.member) != 0i) {
                            if select(select(true, false, _e1089), true, (_e1523.member_1 > 0i)) {
                                let _e1533 = local_5.member[0u];
                                let _e1539 = local_5.member_1[0u];
                                let _e1545 = local_5.member_2[0u];
                                let _e1549 = (_e1533[0] - _e1539[0]);
                                let _e1550 = (_e1533[1] - _e1539[1]);
                                let _e1551 = (_e1533[2] - _e1539[2]);
                                let _e1552 = (_e221.member == 0u);
                                let _e1564 = local_5.member[1u];
                                let _e1570 = local_5.member_1[1u];
                                let _e1576 = local_5.member_2[1u];
                                let _e1580 = (_e1564[0] - _e1570[0]);
                                let _e1581 = (_e1564[1] - _e1570[1]);
                                let _e1582 = (_e1564[2] - _e1570[2]);
                                let _e1583 = (_e221.member == 0u);
                                let _e1595 = local_5.member[0u];
                                let _e1601 = select(_e1595[0], -(_e1595[0]), (_e1595[0] < 0.0lf));
                                let _e1604 = select(_e1595[1], -(_e1595[1]), (_e1595[1] < 0.0lf));
                                let _e1606 = select(_e1604, _e1601, (_e1601 > _e1604));
                                let _e1609 = select(_e1595[2], -(_e1595[2]), (_e1595[2] < 0.0lf));
                                let _e1611 = select(_e1609, _e1606, (_e1606 > _e1609));
                                let _e1614 = local_5.member[1u];
                                let _e1620 = select(_e1614[0], -(_e1614[0]), (_e1614[0] < 0.0lf));
                                let _e1623 = select(_e1614[1], -(_e1614[1]), (_e1614[1] < 0.0lf));
                                let _e1625 = select(_e1623, _e1620, (_e1620 > _e1623));
                                let _e1628 = select(_e1614[2], -(_e1614[2]), (_e1614[2] < 0.0lf));
                                let _e1630 = select(_e1628, _e1625, (_e1625 > _e1628));
                                let _e1634 = local_5.member_3;
                                let _e1638 = local_5.member_1[0u];
                                let _e1644 = select(_e1638[0], -(_e1638[0]), (_e1638[0] < 0.0lf));
                                let _e1647 = select(_e1638[1], -(_e1638[1]), (_e1638[1] < 0.0lf));
                                let _e1649 = select(_e1647, _e1644, (_e1644 > _e1647));
                                let _e1652 = select(_e1638[2], -(_e1638[2]), (_e1638[2] < 0.0lf));
                                let _e1654 = select(_e1652, _e1649, (_e1649 > _e1652));
                                let _e1657 = local_5.member_1[1u];
                                let _e1663 = select(_e1657[0], -(_e1657[0]), (_e1657[0] < 0.0lf));
                                let _e1666 = select(_e1657[1], -(_e1657[1]), (_e1657[1] < 0.0lf));
                                let _e1668 = select(_e1666, _e1663, (_e1663 > _e1666));
                                let _e1671 = select(_e1657[2], -(_e1657[2]), (_e1657[2] < 0.0lf));
                                let _e1673 = select(_e1671, _e1668, (_e1668 > _e1671));
                                let _e1677 = local_5.member_3;
                                let _e1681 = local_5.member_2[0u];
                                let _e1687 = select(_e1681[0], -(_e1681[0]), (_e1681[0] < 0.0lf));
                                let _e1690 = select(_e1681[1], -(_e1681[1]), (_e1681[1] < 0.0lf));
                                let _e1692 = select(_e1690, _e1687, (_e1687 > _e1690));
                                let _e1695 = select(_e1681[2], -(_e1681[2]), (_e1681[2] < 0.0lf));
                                let _e1697 = select(_e1695, _e1692, (_e1692 > _e1695));
                                let _e1700 = local_5.member_2[1u];
                                let _e1706 = select(_e1700[0], -(_e1700[0]), (_e1700[0] < 0.0lf));
                                let _e1709 = select(_e1700[1], -(_e1700[1]), (_e1700[1] < 0.0lf));
                                let _e1711 = select(_e1709, _e1706, (_e1706 > _e1709));
                                let _e1714 = select(_e1700[2], -(_e1700[2]), (_e1700[2] < 0.0lf));
                                let _e1716 = select(_e1714, _e1711, (_e1711 > _e1714));
                                let _e1720 = local_5.member_3;
                                let _e1728 = local_5.member_3;
                                let _e1736 = (_e524 * f64(0.00390625f));
                                let _e1737 = f64(0f);
                                let _e1738 = f64(1f);
                                local_3 = type_35(array<f64, 4>(_e1737, _e1737, _e1737, _e1737), array<f64, 4>(_e1737, _e1737, _e1737, _e1737), array<f64, 4>(_e1738, _e1738, _e1738, _e1738));
                                phi_3536_ = type_9(0u, 96u);
                                phi_3539_ = _e1503;
                                phi_3541_ = _e1503;
                                phi_3543_ = (_e542 - _e1503);
                                phi_3545_ = _e1503;
                                phi_3547_ = false;
                                phi_3549_ = 0u;
                                loop {
                                    let _e1745 = phi_3536_;
                                    let _e1747 = phi_3539_;
                                    let _e1749 = phi_3541_;
                                    let _e1751 = phi_3543_;
                                    let _e1753 = phi_3545_;
                                    let _e1755 = phi_3547_;
                                    let _e1757 = phi_3549_;
                                    local_19 = _e1747;
                                    local_23 = _e1749;
                                    let _e1760 = (_e1745.member < _e1745.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e1760)) != 0i) {
                                        let _e1774 = local_5.member[0u];
                                        let _e1780 = local_5.member[1u];
                                        let _e1796 = local_5.member_1[0u];
                                        let _e1802 = local_5.member_1[1u];
                                        let _e1818 = local_5.member_2[0u];
                                        let _e1824 = local_5.member_2[1u];
                                        let _e1838 = function_3(array<f64, 3>((_e1774[0] + ((_e1780[0] - _e1774[0]) * _e1747)), (_e1774[1] + ((_e1780[1] - _e1774[1]) * _e1747)), (_e1774[2] + ((_e1780[2] - _e1774[2]) * _e1747))), array<f64, 3>((_e1796[0] + ((_e1802[0] - _e1796[0]) * _e1747)), (_e1796[1] + ((_e1802[1] - _e1796[1]) * _e1747)), (_e1796[2] + ((_e1802[2] - _e1796[2]) * _e1747))), array<f64, 3>((_e1818[0] + ((_e1824[0] - _e1818[0]) * _e1747)), (_e1818[1] + ((_e1824[1] - _e1818[1]) * _e1747)), (_e1818[2] + ((_e1824[2] - _e1818[2]) * _e1747))), _e221.member);
                                        if (_e1757 == 0u) {
                                            phi_3701_ = _e1838;
                                        } else {
                                            let _e1840 = f64(0f);
                                            phi_3701_ = array<f64, 3>(select(_e1840, _e1838[0], (_e1757 == 1u)), select(_e1840, _e1838[1], (_e1757 == 2u)), select(_e1840, _e1838[2], (_e1757 == 3u)));
                                        }
                                        let _e1852 = phi_3701_;
                                        let _e1866 = ((select(_e1852[0], -(_e1852[0]), (_e1852[0] < 0.0lf)) + select(_e1852[1], -(_e1852[1]), (_e1852[1] < 0.0lf))) + select(_e1852[2], -(_e1852[2]), (_e1852[2] < 0.0lf)));
                                        if (_e1866 > f64(0f)) {
                                            if ((bitcast<u64>(_e1866) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e1873 = (f64(1f) / _e1866);
                                                let _e1875 = (_e1852[0] * _e1873);
                                                let _e1877 = (_e1852[1] * _e1873);
                                                let _e1879 = (_e1852[2] * _e1873);
                                                let _e1884 = (((_e1875 * _e1875) + (_e1877 * _e1877)) + (_e1879 * _e1879));
                                                if (_e1884 <= 2.2250738585072014e-308lf) {
                                                    phi_3826_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1884 > 0.0lf));
                                                } else {
                                                    phi_3769_ = type_18(0i, 5i);
                                                    phi_3772_ = bitcast<f64>(((bitcast<u64>(_e1884) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e1891 = phi_3769_;
                                                        let _e1893 = phi_3772_;
                                                        local_7 = _e1893;
                                                        if (_e1891.member < _e1891.member_1) {
                                                            let _e1900 = (_e1891.member + 1i);
                                                            phi_3770_ = type_18(select(_e1900, type_19().member_1, select(false, true, ((false == (_e1900 > _e1891.member)) != false))), _e1891.member_1);
                                                            phi_3813_ = type_19(1u, _e1891.member);
                                                        } else {
                                                            phi_3770_ = _e1891;
                                                            phi_3813_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e1911 = phi_3770_;
                                                        let _e1913 = phi_3813_;
                                                        let _e1916 = (bitcast<i32>(_e1913.member) != 0i);
                                                        if _e1916 {
                                                            phi_3773_ = (0.5lf * (_e1893 + (_e1884 / _e1893)));
                                                        } else {
                                                            phi_3773_ = f64();
                                                        }
                                                        let _e1921 = phi_3773_;
                                                        continue;
                                                        continuing {
                                                            phi_3769_ = _e1911;
                                                            phi_3772_ = _e1921;
                                                            break if !(_e1916);
                                                        }
                                                    }
                                                    let _e1926 = local_7;
                                                    phi_3826_ = (_e1926 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e1932 = phi_3826_;
                                                let _e1934 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e1941 = ((((((((select(_e1630, _e1611, (_e1611 > _e1630)) + _e1634) + (select(_e1673, _e1654, (_e1654 > _e1673)) + _e1677)) + (select(_e1716, _e1697, (_e1697 > _e1716)) + _e1720)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1728 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e772.member_1 * _e1932) * (f64(1f) + _e1934)));
                                                let _e1946 = (((_e1875 * _e1533[0]) + (_e1877 * _e1533[1])) + (_e1879 * _e1533[2]));
                                                let _e1951 = (((_e1875 * _e1549) + (_e1877 * _e1550)) + (_e1879 * _e1551));
                                                let _e1956 = (((_e1875 * (_e1533[0] - _e1545[0])) + (_e1877 * (_e1533[1] - _e1545[1]))) + (_e1879 * (_e1533[2] - _e1545[2])));
                                                let _e1961 = (((_e1875 * select((_e1549 - _e1545[0]), _e1533[0], _e1552)) + (_e1877 * select((_e1550 - _e1545[1]), _e1533[1], _e1552))) + (_e1879 * select((_e1551 - _e1545[2]), _e1533[2], _e1552)));
                                                let _e1967 = (((_e1875 * _e1564[0]) + (_e1877 * _e1564[1])) + (_e1879 * _e1564[2]));
                                                let _e1972 = (((_e1875 * _e1580) + (_e1877 * _e1581)) + (_e1879 * _e1582));
                                                let _e1977 = (((_e1875 * (_e1564[0] - _e1576[0])) + (_e1877 * (_e1564[1] - _e1576[1]))) + (_e1879 * (_e1564[2] - _e1576[2])));
                                                let _e1982 = (((_e1875 * select((_e1580 - _e1576[0]), _e1564[0], _e1583)) + (_e1877 * select((_e1581 - _e1576[1]), _e1564[1], _e1583))) + (_e1879 * select((_e1582 - _e1576[2]), _e1564[2], _e1583)));
                                                phi_3952_ = type_35(array<f64, 4>(_e1946, _e1951, _e1956, _e1961), array<f64, 4>(_e1967, _e1972, _e1977, _e1982), array<f64, 4>((_e1941 + ((select(_e1946, -(_e1946), (_e1946 < 0.0lf)) + select(_e1967, -(_e1967), (_e1967 < 0.0lf))) * _e1934)), (_e1941 + ((select(_e1951, -(_e1951), (_e1951 < 0.0lf)) + select(_e1972, -(_e1972), (_e1972 < 0.0lf))) * _e1934)), (_e1941 + ((select(_e1956, -(_e1956), (_e1956 < 0.0lf)) + select(_e1977, -(_e1977), (_e1977 < 0.0lf))) * _e1934)), (_e1941 + ((select(_e1961, -(_e1961), (_e1961 < 0.0lf)) + select(_e1982, -(_e1982), (_e1982 < 0.0lf))) * _e1934))));
                                                phi_3953_ = false;
                                            } else {
                                                phi_3952_ = type_35();
                                                phi_3953_ = true;
                                            }
                                            let _e2023 = phi_3952_;
                                            let _e2025 = phi_3953_;
                                            phi_3954_ = _e2023;
                                            phi_3955_ = _e2025;
                                        } else {
                                            phi_3954_ = type_35();
                                            phi_3955_ = true;
                                        }
                                        let _e2027 = phi_3954_;
                                        let _e2029 = phi_3955_;
                                        if _e2029 {
                                            let _e2030 = f64(0f);
                                            let _e2031 = f64(1f);
                                            phi_3965_ = type_35(array<f64, 4>(_e2030, _e2030, _e2030, _e2030), array<f64, 4>(_e2030, _e2030, _e2030, _e2030), array<f64, 4>(_e2031, _e2031, _e2031, _e2031));
                                        } else {
                                            phi_3965_ = _e2027;
                                        }
                                        let _e2037 = phi_3965_;
                                        local_4 = type_35(array<f64, 4>(_e2037.member[0], _e2037.member[1], _e2037.member[2], _e2037.member[3]), array<f64, 4>(_e2037.member_1[0], _e2037.member_1[1], _e2037.member_1[2], _e2037.member_1[3]), array<f64, 4>(_e2037.member_2[0], _e2037.member_2[1], _e2037.member_2[2], _e2037.member_2[3]));
                                        let _e2057 = (_e1747 - _e1753);
                                        let _e2059 = f64(0f);
                                        let _e2062 = local_4.member[0u];
                                        let _e2065 = local_4.member_1[0u];
                                        let _e2068 = local_4.member[0u];
                                        let _e2074 = local_4.member_2[0u];
                                        if (((_e2062 + ((_e2065 - _e2068) * _e1747)) - _e2074) > _e2059) {
                                            let _e2079 = local_4.member[1u];
                                            let _e2082 = local_4.member_1[1u];
                                            let _e2085 = local_4.member[1u];
                                            let _e2091 = local_4.member_2[1u];
                                            if (((_e2079 + ((_e2082 - _e2085) * _e1747)) - _e2091) > _e2059) {
                                                let _e2096 = local_4.member[2u];
                                                let _e2099 = local_4.member_1[2u];
                                                let _e2102 = local_4.member[2u];
                                                let _e2108 = local_4.member_2[2u];
                                                if (((_e2096 + ((_e2099 - _e2102) * _e1747)) - _e2108) > _e2059) {
                                                    let _e2113 = local_4.member[3u];
                                                    let _e2116 = local_4.member_1[3u];
                                                    let _e2119 = local_4.member[3u];
                                                    let _e2125 = local_4.member_2[3u];
                                                    phi_4137_ = (((_e2113 + ((_e2116 - _e2119) * _e1747)) - _e2125) > _e2059);
                                                    phi_4138_ = false;
                                                } else {
                                                    phi_4137_ = bool();
                                                    phi_4138_ = true;
                                                }
                                                let _e2129 = phi_4137_;
                                                let _e2131 = phi_4138_;
                                                phi_4139_ = _e2129;
                                                phi_4140_ = _e2131;
                                            } else {
                                                phi_4139_ = bool();
                                                phi_4140_ = true;
                                            }
                                            let _e2133 = phi_4139_;
                                            let _e2135 = phi_4140_;
                                            phi_4141_ = _e2133;
                                            phi_4142_ = _e2135;
                                        } else {
                                            phi_4141_ = bool();
                                            phi_4142_ = true;
                                        }
                                        let _e2137 = phi_4141_;
                                        let _e2139 = phi_4142_;
                                        if select(_e2137, false, _e2139) {
                                            if (_e1747 <= _e1749) {
                                                phi_4457_ = true;
                                            } else {
                                                let _e2142 = f64(0f);
                                                let _e2145 = local_3.member[0u];
                                                let _e2148 = local_3.member_1[0u];
                                                let _e2151 = local_3.member[0u];
                                                let _e2157 = local_3.member_2[0u];
                                                let _e2161 = local_4.member[0u];
                                                let _e2164 = local_4.member_1[0u];
                                                let _e2167 = local_4.member[0u];
                                                let _e2173 = local_4.member_2[0u];
                                                if ((((_e2145 + ((_e2148 - _e2151) * _e1747)) - _e2157) + ((_e2161 + ((_e2164 - _e2167) * _e1753)) - _e2173)) > _e2142) {
                                                    let _e2179 = local_3.member[1u];
                                                    let _e2182 = local_3.member_1[1u];
                                                    let _e2185 = local_3.member[1u];
                                                    let _e2191 = local_3.member_2[1u];
                                                    let _e2195 = local_4.member[1u];
                                                    let _e2198 = local_4.member_1[1u];
                                                    let _e2201 = local_4.member[1u];
                                                    let _e2207 = local_4.member_2[1u];
                                                    if ((((_e2179 + ((_e2182 - _e2185) * _e1747)) - _e2191) + ((_e2195 + ((_e2198 - _e2201) * _e1753)) - _e2207)) > _e2142) {
                                                        let _e2213 = local_3.member[2u];
                                                        let _e2216 = local_3.member_1[2u];
                                                        let _e2219 = local_3.member[2u];
                                                        let _e2225 = local_3.member_2[2u];
                                                        let _e2229 = local_4.member[2u];
                                                        let _e2232 = local_4.member_1[2u];
                                                        let _e2235 = local_4.member[2u];
                                                        let _e2241 = local_4.member_2[2u];
                                                        if ((((_e2213 + ((_e2216 - _e2219) * _e1747)) - _e2225) + ((_e2229 + ((_e2232 - _e2235) * _e1753)) - _e2241)) > _e2142) {
                                                            let _e2247 = local_3.member[3u];
                                                            let _e2250 = local_3.member_1[3u];
                                                            let _e2253 = local_3.member[3u];
                                                            let _e2259 = local_3.member_2[3u];
                                                            let _e2263 = local_4.member[3u];
                                                            let _e2266 = local_4.member_1[3u];
                                                            let _e2269 = local_4.member[3u];
                                                            let _e2275 = local_4.member_2[3u];
                                                            phi_4444_ = ((((_e2247 + ((_e2250 - _e2253) * _e1747)) - _e2259) + ((_e2263 + ((_e2266 - _e2269) * _e1753)) - _e2275)) > _e2142);
                                                            phi_4445_ = false;
                                                        } else {
                                                            phi_4444_ = bool();
                                                            phi_4445_ = true;
                                                        }
                                                        let _e2280 = phi_4444_;
                                                        let _e2282 = phi_4445_;
                                                        phi_4446_ = _e2280;
                                                        phi_4447_ = _e2282;
                                                    } else {
                                                        phi_4446_ = bool();
                                                        phi_4447_ = true;
                                                    }
                                                    let _e2284 = phi_4446_;
                                                    let _e2286 = phi_4447_;
                                                    phi_4448_ = _e2284;
                                                    phi_4449_ = _e2286;
                                                } else {
                                                    phi_4448_ = bool();
                                                    phi_4449_ = true;
                                                }
                                                let _e2288 = phi_4448_;
                                                let _e2290 = phi_4449_;
                                                phi_4457_ = select(_e2288, false, _e2290);
                                            }
                                            let _e2293 = phi_4457_;
                                            if _e2293 {
                                                if select(true, select(true, false, (_e1747 >= _e542)), _e1755) {
                                                    local_3 = type_35(array<f64, 4>(_e2037.member[0], _e2037.member[1], _e2037.member[2], _e2037.member[3]), array<f64, 4>(_e2037.member_1[0], _e2037.member_1[1], _e2037.member_1[2], _e2037.member_1[3]), array<f64, 4>(_e2037.member_2[0], _e2037.member_2[1], _e2037.member_2[2], _e2037.member_2[3]));
                                                    let _e2318 = local_3.member[0u];
                                                    let _e2321 = local_3.member_1[0u];
                                                    let _e2324 = local_3.member_2[0u];
                                                    if select(true, select(true, false, (_e2321 > _e2324)), (_e2318 > _e2324)) {
                                                        let _e2329 = (_e2321 >= _e2318);
                                                        if _e2329 {
                                                            phi_4569_ = f64();
                                                            phi_4570_ = false;
                                                        } else {
                                                            if ((_e2318 - _e2321) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4567_ = (((_e2318 - _e2324) / (_e2318 - _e2321)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4568_ = false;
                                                            } else {
                                                                phi_4567_ = f64();
                                                                phi_4568_ = true;
                                                            }
                                                            let _e2343 = phi_4567_;
                                                            let _e2345 = phi_4568_;
                                                            phi_4569_ = _e2343;
                                                            phi_4570_ = _e2345;
                                                        }
                                                        let _e2347 = phi_4569_;
                                                        let _e2349 = phi_4570_;
                                                        phi_4571_ = _e2347;
                                                        phi_4572_ = _e2329;
                                                        phi_4573_ = _e2349;
                                                    } else {
                                                        phi_4571_ = f64();
                                                        phi_4572_ = true;
                                                        phi_4573_ = false;
                                                    }
                                                    let _e2351 = phi_4571_;
                                                    let _e2353 = phi_4572_;
                                                    let _e2355 = phi_4573_;
                                                    let _e2359 = select(_e2351, select(_e1747, f64(2f), _e2353), select(_e2355, true, _e2353));
                                                    let _e2362 = local_3.member[1u];
                                                    let _e2365 = local_3.member_1[1u];
                                                    let _e2368 = local_3.member_2[1u];
                                                    if select(true, select(true, false, (_e2365 > _e2368)), (_e2362 > _e2368)) {
                                                        let _e2373 = (_e2365 >= _e2362);
                                                        if _e2373 {
                                                            phi_4641_ = f64();
                                                            phi_4642_ = false;
                                                        } else {
                                                            if ((_e2362 - _e2365) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4639_ = (((_e2362 - _e2368) / (_e2362 - _e2365)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4640_ = false;
                                                            } else {
                                                                phi_4639_ = f64();
                                                                phi_4640_ = true;
                                                            }
                                                            let _e2387 = phi_4639_;
                                                            let _e2389 = phi_4640_;
                                                            phi_4641_ = _e2387;
                                                            phi_4642_ = _e2389;
                                                        }
                                                        let _e2391 = phi_4641_;
                                                        let _e2393 = phi_4642_;
                                                        phi_4643_ = _e2391;
                                                        phi_4644_ = _e2373;
                                                        phi_4645_ = _e2393;
                                                    } else {
                                                        phi_4643_ = f64();
                                                        phi_4644_ = true;
                                                        phi_4645_ = false;
                                                    }
                                                    let _e2395 = phi_4643_;
                                                    let _e2397 = phi_4644_;
                                                    let _e2399 = phi_4645_;
                                                    let _e2403 = select(_e2395, select(_e1747, f64(2f), _e2397), select(_e2399, true, _e2397));
                                                    let _e2405 = select(_e2403, _e2359, (_e2359 < _e2403));
                                                    let _e2408 = local_3.member[2u];
                                                    let _e2411 = local_3.member_1[2u];
                                                    let _e2414 = local_3.member_2[2u];
                                                    if select(true, select(true, false, (_e2411 > _e2414)), (_e2408 > _e2414)) {
                                                        let _e2419 = (_e2411 >= _e2408);
                                                        if _e2419 {
                                                            phi_4718_ = f64();
                                                            phi_4719_ = false;
                                                        } else {
                                                            if ((_e2408 - _e2411) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4716_ = (((_e2408 - _e2414) / (_e2408 - _e2411)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4717_ = false;
                                                            } else {
                                                                phi_4716_ = f64();
                                                                phi_4717_ = true;
                                                            }
                                                            let _e2433 = phi_4716_;
                                                            let _e2435 = phi_4717_;
                                                            phi_4718_ = _e2433;
                                                            phi_4719_ = _e2435;
                                                        }
                                                        let _e2437 = phi_4718_;
                                                        let _e2439 = phi_4719_;
                                                        phi_4720_ = _e2437;
                                                        phi_4721_ = _e2419;
                                                        phi_4722_ = _e2439;
                                                    } else {
                                                        phi_4720_ = f64();
                                                        phi_4721_ = true;
                                                        phi_4722_ = false;
                                                    }
                                                    let _e2441 = phi_4720_;
                                                    let _e2443 = phi_4721_;
                                                    let _e2445 = phi_4722_;
                                                    let _e2449 = select(_e2441, select(_e1747, f64(2f), _e2443), select(_e2445, true, _e2443));
                                                    let _e2452 = local_3.member[3u];
                                                    let _e2455 = local_3.member_1[3u];
                                                    let _e2458 = local_3.member_2[3u];
                                                    if select(true, select(true, false, (_e2455 > _e2458)), (_e2452 > _e2458)) {
                                                        let _e2463 = (_e2455 >= _e2452);
                                                        if _e2463 {
                                                            phi_4790_ = f64();
                                                            phi_4791_ = false;
                                                        } else {
                                                            if ((_e2452 - _e2455) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_4788_ = (((_e2452 - _e2458) / (_e2452 - _e2455)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_4789_ = false;
                                                            } else {
                                                                phi_4788_ = f64();
                                                                phi_4789_ = true;
                                                            }
                                                            let _e2477 = phi_4788_;
                                                            let _e2479 = phi_4789_;
                                                            phi_4790_ = _e2477;
                                                            phi_4791_ = _e2479;
                                                        }
                                                        let _e2481 = phi_4790_;
                                                        let _e2483 = phi_4791_;
                                                        phi_4792_ = _e2481;
                                                        phi_4793_ = _e2463;
                                                        phi_4794_ = _e2483;
                                                    } else {
                                                        phi_4792_ = f64();
                                                        phi_4793_ = true;
                                                        phi_4794_ = false;
                                                    }
                                                    let _e2485 = phi_4792_;
                                                    let _e2487 = phi_4793_;
                                                    let _e2489 = phi_4794_;
                                                    let _e2493 = select(_e2485, select(_e1747, f64(2f), _e2487), select(_e2489, true, _e2487));
                                                    let _e2495 = select(_e2493, _e2449, (_e2449 < _e2493));
                                                    let _e2497 = select(_e2495, _e2405, (_e2405 < _e2495));
                                                    let _e2499 = select(_e1747, _e2497, (_e2497 > _e1747));
                                                    let _e2500 = (_e2499 > _e542);
                                                    if _e2500 {
                                                        phi_5336_ = f64();
                                                        phi_5337_ = f64();
                                                        phi_5338_ = false;
                                                        phi_5339_ = false;
                                                    } else {
                                                        let _e2501 = (_e2499 - _e1747);
                                                        let _e2502 = (_e2501 <= _e1736);
                                                        let _e2505 = (_e2499 + (_e524 * f64(0.01f)));
                                                        let _e2507 = select(_e542, _e2505, (_e2505 < _e542));
                                                        if _e2502 {
                                                            if (_e772.member_1 > f64(0f)) {
                                                                let _e2512 = local_5.member[0u];
                                                                let _e2518 = local_5.member[1u];
                                                                let _e2534 = local_5.member_1[0u];
                                                                let _e2540 = local_5.member_1[1u];
                                                                let _e2556 = local_5.member_2[0u];
                                                                let _e2562 = local_5.member_2[1u];
                                                                let _e2576 = function_3(array<f64, 3>((_e2512[0] + ((_e2518[0] - _e2512[0]) * _e2507)), (_e2512[1] + ((_e2518[1] - _e2512[1]) * _e2507)), (_e2512[2] + ((_e2518[2] - _e2512[2]) * _e2507))), array<f64, 3>((_e2534[0] + ((_e2540[0] - _e2534[0]) * _e2507)), (_e2534[1] + ((_e2540[1] - _e2534[1]) * _e2507)), (_e2534[2] + ((_e2540[2] - _e2534[2]) * _e2507))), array<f64, 3>((_e2556[0] + ((_e2562[0] - _e2556[0]) * _e2507)), (_e2556[1] + ((_e2562[1] - _e2556[1]) * _e2507)), (_e2556[2] + ((_e2562[2] - _e2556[2]) * _e2507))), _e221.member);
                                                                let _e2587 = (((_e2576[0] * _e2576[0]) + (_e2576[1] * _e2576[1])) + (_e2576[2] * _e2576[2]));
                                                                if (_e2587 <= 2.2250738585072014e-308lf) {
                                                                    phi_5028_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2587 > 0.0lf));
                                                                } else {
                                                                    phi_4971_ = type_18(0i, 5i);
                                                                    phi_4974_ = bitcast<f64>(((bitcast<u64>(_e2587) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e2594 = phi_4971_;
                                                                        let _e2596 = phi_4974_;
                                                                        local_8 = _e2596;
                                                                        if (_e2594.member < _e2594.member_1) {
                                                                            let _e2603 = (_e2594.member + 1i);
                                                                            phi_4972_ = type_18(select(_e2603, type_19().member_1, select(false, true, ((false == (_e2603 > _e2594.member)) != false))), _e2594.member_1);
                                                                            phi_5015_ = type_19(1u, _e2594.member);
                                                                        } else {
                                                                            phi_4972_ = _e2594;
                                                                            phi_5015_ = type_19(0u, type_19().member_1);
                                                                        }
                                                                        let _e2614 = phi_4972_;
                                                                        let _e2616 = phi_5015_;
                                                                        let _e2619 = (bitcast<i32>(_e2616.member) != 0i);
                                                                        if _e2619 {
                                                                            phi_4975_ = (0.5lf * (_e2596 + (_e2587 / _e2596)));
                                                                        } else {
                                                                            phi_4975_ = f64();
                                                                        }
                                                                        let _e2624 = phi_4975_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_4971_ = _e2614;
                                                                            phi_4974_ = _e2624;
                                                                            break if !(_e2619);
                                                                        }
                                                                    }
                                                                    let _e2629 = local_8;
                                                                    phi_5028_ = (_e2629 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e2635 = phi_5028_;
                                                                let _e2643 = local_5.member[0u];
                                                                let _e2649 = select(_e2643[0], -(_e2643[0]), (_e2643[0] < 0.0lf));
                                                                let _e2652 = select(_e2643[1], -(_e2643[1]), (_e2643[1] < 0.0lf));
                                                                let _e2654 = select(_e2652, _e2649, (_e2649 > _e2652));
                                                                let _e2657 = select(_e2643[2], -(_e2643[2]), (_e2643[2] < 0.0lf));
                                                                let _e2659 = select(_e2657, _e2654, (_e2654 > _e2657));
                                                                let _e2662 = local_5.member[1u];
                                                                let _e2668 = select(_e2662[0], -(_e2662[0]), (_e2662[0] < 0.0lf));
                                                                let _e2671 = select(_e2662[1], -(_e2662[1]), (_e2662[1] < 0.0lf));
                                                                let _e2673 = select(_e2671, _e2668, (_e2668 > _e2671));
                                                                let _e2676 = select(_e2662[2], -(_e2662[2]), (_e2662[2] < 0.0lf));
                                                                let _e2678 = select(_e2676, _e2673, (_e2673 > _e2676));
                                                                let _e2682 = local_5.member_3;
                                                                let _e2686 = local_5.member_1[0u];
                                                                let _e2692 = select(_e2686[0], -(_e2686[0]), (_e2686[0] < 0.0lf));
                                                                let _e2695 = select(_e2686[1], -(_e2686[1]), (_e2686[1] < 0.0lf));
                                                                let _e2697 = select(_e2695, _e2692, (_e2692 > _e2695));
                                                                let _e2700 = select(_e2686[2], -(_e2686[2]), (_e2686[2] < 0.0lf));
                                                                let _e2702 = select(_e2700, _e2697, (_e2697 > _e2700));
                                                                let _e2705 = local_5.member_1[1u];
                                                                let _e2711 = select(_e2705[0], -(_e2705[0]), (_e2705[0] < 0.0lf));
                                                                let _e2714 = select(_e2705[1], -(_e2705[1]), (_e2705[1] < 0.0lf));
                                                                let _e2716 = select(_e2714, _e2711, (_e2711 > _e2714));
                                                                let _e2719 = select(_e2705[2], -(_e2705[2]), (_e2705[2] < 0.0lf));
                                                                let _e2721 = select(_e2719, _e2716, (_e2716 > _e2719));
                                                                let _e2725 = local_5.member_3;
                                                                let _e2729 = local_5.member_2[0u];
                                                                let _e2735 = select(_e2729[0], -(_e2729[0]), (_e2729[0] < 0.0lf));
                                                                let _e2738 = select(_e2729[1], -(_e2729[1]), (_e2729[1] < 0.0lf));
                                                                let _e2740 = select(_e2738, _e2735, (_e2735 > _e2738));
                                                                let _e2743 = select(_e2729[2], -(_e2729[2]), (_e2729[2] < 0.0lf));
                                                                let _e2745 = select(_e2743, _e2740, (_e2740 > _e2743));
                                                                let _e2748 = local_5.member_2[1u];
                                                                let _e2754 = select(_e2748[0], -(_e2748[0]), (_e2748[0] < 0.0lf));
                                                                let _e2757 = select(_e2748[1], -(_e2748[1]), (_e2748[1] < 0.0lf));
                                                                let _e2759 = select(_e2757, _e2754, (_e2754 > _e2757));
                                                                let _e2762 = select(_e2748[2], -(_e2748[2]), (_e2748[2] < 0.0lf));
                                                                let _e2764 = select(_e2762, _e2759, (_e2759 > _e2762));
                                                                let _e2768 = local_5.member_3;
                                                                let _e2776 = local_5.member_3;
                                                                phi_5305_ = select(true, false, (((_e2635 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e2678, _e2659, (_e2659 > _e2678)) + _e2682) + (select(_e2721, _e2702, (_e2702 > _e2721)) + _e2725)) + (select(_e2764, _e2745, (_e2745 > _e2764)) + _e2768)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2776 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e772.member_1));
                                                            } else {
                                                                phi_5305_ = true;
                                                            }
                                                            let _e2789 = phi_5305_;
                                                            phi_5306_ = _e2789;
                                                        } else {
                                                            phi_5306_ = true;
                                                        }
                                                        let _e2791 = phi_5306_;
                                                        if _e2791 {
                                                            if _e1755 {
                                                                let _e2795 = (_e2501 <= (_e1751 * f64(0.25f)));
                                                                phi_5333_ = select(select(select(f64(), f64(0f), _e2795), f64(), _e2502), (_e2057 + _e2057), select(select(true, false, _e2795), true, _e2502));
                                                            } else {
                                                                phi_5333_ = (_e542 - _e1747);
                                                            }
                                                            let _e2804 = phi_5333_;
                                                            phi_5334_ = _e2804;
                                                            phi_5335_ = false;
                                                        } else {
                                                            phi_5334_ = f64();
                                                            phi_5335_ = true;
                                                        }
                                                        let _e2806 = phi_5334_;
                                                        let _e2808 = phi_5335_;
                                                        phi_5336_ = _e2806;
                                                        phi_5337_ = _e2501;
                                                        phi_5338_ = _e2791;
                                                        phi_5339_ = _e2808;
                                                    }
                                                    let _e2810 = phi_5336_;
                                                    let _e2812 = phi_5337_;
                                                    let _e2814 = phi_5338_;
                                                    let _e2816 = phi_5339_;
                                                    phi_5340_ = _e2499;
                                                    phi_5341_ = _e2810;
                                                    phi_5342_ = _e2812;
                                                    phi_5343_ = _e2499;
                                                    phi_5344_ = _e2814;
                                                    phi_5345_ = _e2500;
                                                    phi_5346_ = _e2816;
                                                    phi_5347_ = false;
                                                } else {
                                                    phi_5340_ = f64();
                                                    phi_5341_ = f64();
                                                    phi_5342_ = f64();
                                                    phi_5343_ = f64();
                                                    phi_5344_ = false;
                                                    phi_5345_ = false;
                                                    phi_5346_ = false;
                                                    phi_5347_ = true;
                                                }
                                                let _e2818 = phi_5340_;
                                                let _e2820 = phi_5341_;
                                                let _e2822 = phi_5342_;
                                                let _e2824 = phi_5343_;
                                                let _e2826 = phi_5344_;
                                                let _e2828 = phi_5345_;
                                                let _e2830 = phi_5346_;
                                                let _e2832 = phi_5347_;
                                                phi_5348_ = _e2818;
                                                phi_5349_ = _e2820;
                                                phi_5350_ = _e2822;
                                                phi_5351_ = _e2824;
                                                phi_5352_ = false;
                                                phi_5353_ = _e2826;
                                                phi_5354_ = _e2828;
                                                phi_5355_ = _e2830;
                                                phi_5356_ = _e2832;
                                            } else {
                                                phi_5348_ = f64();
                                                phi_5349_ = f64();
                                                phi_5350_ = f64();
                                                phi_5351_ = f64();
                                                phi_5352_ = true;
                                                phi_5353_ = false;
                                                phi_5354_ = false;
                                                phi_5355_ = false;
                                                phi_5356_ = false;
                                            }
                                            let _e2834 = phi_5348_;
                                            let _e2836 = phi_5349_;
                                            let _e2838 = phi_5350_;
                                            let _e2840 = phi_5351_;
                                            let _e2842 = phi_5352_;
                                            let _e2844 = phi_5353_;
                                            let _e2846 = phi_5354_;
                                            let _e2848 = phi_5355_;
                                            let _e2850 = phi_5356_;
                                            phi_5357_ = _e2834;
                                            phi_5358_ = _e2836;
                                            phi_5359_ = _e2838;
                                            phi_5360_ = _e2840;
                                            phi_5361_ = _e2842;
                                            phi_5362_ = _e2844;
                                            phi_5363_ = _e2846;
                                            phi_5364_ = _e2848;
                                            phi_5365_ = _e2850;
                                        } else {
                                            phi_5357_ = f64();
                                            phi_5358_ = f64();
                                            phi_5359_ = f64();
                                            phi_5360_ = f64();
                                            phi_5361_ = true;
                                            phi_5362_ = false;
                                            phi_5363_ = false;
                                            phi_5364_ = false;
                                            phi_5365_ = false;
                                        }
                                        let _e2852 = phi_5357_;
                                        let _e2854 = phi_5358_;
                                        let _e2856 = phi_5359_;
                                        let _e2858 = phi_5360_;
                                        let _e2860 = phi_5361_;
                                        let _e2862 = phi_5362_;
                                        let _e2864 = phi_5363_;
                                        let _e2866 = phi_5364_;
                                        let _e2868 = phi_5365_;
                                        if _e2860 {
                                            if (_e1747 <= _e1749) {
                                                let _e3026 = (_e1757 + 1u);
                                                let _e3027 = (_e3026 > 3u);
                                                phi_5705_ = _e3026;
                                                phi_5706_ = f64();
                                                phi_5707_ = false;
                                                phi_5708_ = select(true, false, _e3027);
                                                phi_5709_ = _e3027;
                                            } else {
                                                let _e2872 = local_3.member[0u];
                                                let _e2875 = local_3.member_1[0u];
                                                let _e2878 = local_3.member[0u];
                                                let _e2884 = local_3.member_2[0u];
                                                let _e2885 = ((_e2872 + ((_e2875 - _e2878) * _e1753)) - _e2884);
                                                let _e2888 = local_3.member[1u];
                                                let _e2891 = local_3.member_1[1u];
                                                let _e2894 = local_3.member[1u];
                                                let _e2900 = local_3.member_2[1u];
                                                let _e2901 = ((_e2888 + ((_e2891 - _e2894) * _e1753)) - _e2900);
                                                let _e2903 = select(_e2901, _e2885, (_e2885 < _e2901));
                                                let _e2906 = local_3.member[2u];
                                                let _e2909 = local_3.member_1[2u];
                                                let _e2912 = local_3.member[2u];
                                                let _e2918 = local_3.member_2[2u];
                                                let _e2919 = ((_e2906 + ((_e2909 - _e2912) * _e1753)) - _e2918);
                                                let _e2922 = local_3.member[3u];
                                                let _e2925 = local_3.member_1[3u];
                                                let _e2928 = local_3.member[3u];
                                                let _e2934 = local_3.member_2[3u];
                                                let _e2935 = ((_e2922 + ((_e2925 - _e2928) * _e1753)) - _e2934);
                                                let _e2937 = select(_e2935, _e2919, (_e2919 < _e2935));
                                                let _e2939 = select(_e2937, _e2903, (_e2903 < _e2937));
                                                let _e2942 = local_4.member[0u];
                                                let _e2945 = local_4.member_1[0u];
                                                let _e2948 = local_4.member[0u];
                                                let _e2954 = local_4.member_2[0u];
                                                let _e2955 = ((_e2942 + ((_e2945 - _e2948) * _e1747)) - _e2954);
                                                let _e2958 = local_4.member[1u];
                                                let _e2961 = local_4.member_1[1u];
                                                let _e2964 = local_4.member[1u];
                                                let _e2970 = local_4.member_2[1u];
                                                let _e2971 = ((_e2958 + ((_e2961 - _e2964) * _e1747)) - _e2970);
                                                let _e2973 = select(_e2971, _e2955, (_e2955 < _e2971));
                                                let _e2976 = local_4.member[2u];
                                                let _e2979 = local_4.member_1[2u];
                                                let _e2982 = local_4.member[2u];
                                                let _e2988 = local_4.member_2[2u];
                                                let _e2989 = ((_e2976 + ((_e2979 - _e2982) * _e1747)) - _e2988);
                                                let _e2992 = local_4.member[3u];
                                                let _e2995 = local_4.member_1[3u];
                                                let _e2998 = local_4.member[3u];
                                                let _e3004 = local_4.member_2[3u];
                                                let _e3005 = ((_e2992 + ((_e2995 - _e2998) * _e1747)) - _e3004);
                                                let _e3007 = select(_e3005, _e2989, (_e2989 < _e3005));
                                                let _e3009 = select(_e3007, _e2973, (_e2973 < _e3007));
                                                let _e3010 = f64(0.0625f);
                                                let _e3012 = f64(0.9f);
                                                if (_e3009 > f64(0f)) {
                                                    phi_5703_ = f64(0.5f);
                                                } else {
                                                    let _e3018 = (f64(0.95f) * (_e2939 / (_e2939 - _e3009)));
                                                    phi_5703_ = select(_e3010, select(_e3012, _e3018, (_e3018 < _e3012)), (_e3018 > _e3010));
                                                }
                                                let _e3024 = phi_5703_;
                                                phi_5705_ = u32();
                                                phi_5706_ = (_e2057 * _e3024);
                                                phi_5707_ = true;
                                                phi_5708_ = false;
                                                phi_5709_ = false;
                                            }
                                            let _e3030 = phi_5705_;
                                            let _e3032 = phi_5706_;
                                            let _e3034 = phi_5707_;
                                            let _e3036 = phi_5708_;
                                            let _e3038 = phi_5709_;
                                            phi_5710_ = _e3030;
                                            phi_5711_ = _e1749;
                                            phi_5712_ = _e3032;
                                            phi_5713_ = _e1751;
                                            phi_5714_ = _e1753;
                                            phi_5715_ = _e1755;
                                            phi_5716_ = _e1757;
                                            phi_5717_ = _e3034;
                                            phi_5718_ = _e3036;
                                            phi_5719_ = _e3038;
                                            phi_5720_ = false;
                                            phi_5721_ = false;
                                            phi_5722_ = false;
                                        } else {
                                            phi_5710_ = u32();
                                            phi_5711_ = _e2852;
                                            phi_5712_ = _e2854;
                                            phi_5713_ = _e2856;
                                            phi_5714_ = _e1747;
                                            phi_5715_ = true;
                                            phi_5716_ = 0u;
                                            phi_5717_ = _e2862;
                                            phi_5718_ = false;
                                            phi_5719_ = false;
                                            phi_5720_ = _e2864;
                                            phi_5721_ = _e2866;
                                            phi_5722_ = _e2868;
                                        }
                                        let _e3040 = phi_5710_;
                                        let _e3042 = phi_5711_;
                                        let _e3044 = phi_5712_;
                                        let _e3046 = phi_5713_;
                                        let _e3048 = phi_5714_;
                                        let _e3050 = phi_5715_;
                                        let _e3052 = phi_5716_;
                                        let _e3054 = phi_5717_;
                                        let _e3056 = phi_5718_;
                                        let _e3058 = phi_5719_;
                                        let _e3060 = phi_5720_;
                                        let _e3062 = phi_5721_;
                                        let _e3064 = phi_5722_;
                                        if _e3054 {
                                            let _e3065 = (_e3048 + _e3044);
                                            let _e3067 = select(_e3042, _e3065, (_e3065 > _e3042));
                                            let _e3069 = select(_e542, _e3067, (_e3067 < _e542));
                                            let _e3072 = select(((_e3069 - _e3048) > _e1736), true, !(_e1755));
                                            phi_5750_ = _e3069;
                                            phi_5751_ = _e3042;
                                            phi_5752_ = _e3046;
                                            phi_5753_ = _e3048;
                                            phi_5754_ = _e3050;
                                            phi_5755_ = _e3052;
                                            phi_5756_ = _e3072;
                                            phi_5757_ = select(true, false, _e3072);
                                            phi_5758_ = false;
                                            phi_5759_ = false;
                                            phi_5760_ = false;
                                            phi_5761_ = false;
                                        } else {
                                            phi_5750_ = _e1747;
                                            phi_5751_ = _e1749;
                                            phi_5752_ = _e1751;
                                            phi_5753_ = _e1753;
                                            phi_5754_ = _e1755;
                                            phi_5755_ = _e3040;
                                            phi_5756_ = _e3056;
                                            phi_5757_ = false;
                                            phi_5758_ = _e3058;
                                            phi_5759_ = _e3060;
                                            phi_5760_ = _e3062;
                                            phi_5761_ = _e3064;
                                        }
                                        let _e3075 = phi_5750_;
                                        let _e3077 = phi_5751_;
                                        let _e3079 = phi_5752_;
                                        let _e3081 = phi_5753_;
                                        let _e3083 = phi_5754_;
                                        let _e3085 = phi_5755_;
                                        let _e3087 = phi_5756_;
                                        let _e3089 = phi_5757_;
                                        let _e3091 = phi_5758_;
                                        let _e3093 = phi_5759_;
                                        let _e3095 = phi_5760_;
                                        let _e3097 = phi_5761_;
                                        phi_3540_ = _e3075;
                                        phi_3542_ = _e3077;
                                        phi_3544_ = _e3079;
                                        phi_3546_ = _e3081;
                                        phi_3548_ = _e3083;
                                        phi_3550_ = _e3085;
                                        phi_5762_ = _e3042;
                                        phi_5763_ = _e2858;
                                        phi_5764_ = _e3087;
                                        phi_5765_ = _e3089;
                                        phi_5766_ = _e3091;
                                        phi_5767_ = _e3093;
                                        phi_5768_ = _e3095;
                                        phi_5769_ = false;
                                        phi_5770_ = _e3097;
                                    } else {
                                        phi_3540_ = f64();
                                        phi_3542_ = f64();
                                        phi_3544_ = f64();
                                        phi_3546_ = f64();
                                        phi_3548_ = bool();
                                        phi_3550_ = u32();
                                        phi_5762_ = f64();
                                        phi_5763_ = f64();
                                        phi_5764_ = false;
                                        phi_5765_ = false;
                                        phi_5766_ = false;
                                        phi_5767_ = false;
                                        phi_5768_ = false;
                                        phi_5769_ = true;
                                        phi_5770_ = false;
                                    }
                                    let _e3099 = phi_3540_;
                                    let _e3101 = phi_3542_;
                                    let _e3103 = phi_3544_;
                                    let _e3105 = phi_3546_;
                                    let _e3107 = phi_3548_;
                                    let _e3109 = phi_3550_;
                                    let _e3111 = phi_5762_;
                                    let _e3113 = phi_5763_;
                                    let _e3115 = phi_5764_;
                                    let _e3117 = phi_5765_;
                                    let _e3119 = phi_5766_;
                                    let _e3121 = phi_5767_;
                                    let _e3123 = phi_5768_;
                                    let _e3125 = phi_5769_;
                                    let _e3127 = phi_5770_;
                                    local_9 = _e3117;
                                    local_10 = _e3119;
                                    local_11 = _e3117;
                                    local_12 = _e3121;
                                    local_13 = _e3117;
                                    local_14 = _e3123;
                                    local_15 = _e3117;
                                    local_16 = _e3125;
                                    local_17 = _e3117;
                                    local_18 = _e3127;
                                    local_20 = _e3117;
                                    local_21 = _e3113;
                                    local_22 = _e3111;
                                    continue;
                                    continuing {
                                        phi_3536_ = type_9(select(_e1745.member, (_e1745.member + 1u), _e1760), select(_e1745.member_1, _e1745.member_1, _e1760));
                                        phi_3539_ = _e3099;
                                        phi_3541_ = _e3101;
                                        phi_3543_ = _e3103;
                                        phi_3545_ = _e3105;
                                        phi_3547_ = _e3107;
                                        phi_3549_ = _e3109;
                                        break if !(_e3115);
                                    }
                                }
                                let _e3130 = local_9;
                                let _e3132 = local_10;
                                let _e3133 = select(_e3132, false, _e3130);
                                let _e3135 = local_11;
                                let _e3137 = local_12;
                                let _e3140 = local_13;
                                let _e3142 = local_14;
                                let _e3145 = local_15;
                                let _e3147 = local_16;
                                let _e3150 = local_17;
                                let _e3152 = local_18;
                                let _e3158 = local_19;
                                let _e3160 = select(select(_e3137, false, _e3135), false, _e3133);
                                let _e3163 = local_20;
                                let _e3170 = select(select(select(_e3142, false, _e3140), false, _e3133), false, _e3160);
                                let _e3176 = local_21;
                                let _e3178 = local_22;
                                let _e3180 = select(select(select(_e3163, false, _e3133), false, _e3160), true, _e3170);
                                let _e3185 = local_23;
                                let _e3187 = select(select(select(select(select(_e3147, false, _e3145), false, _e3133), false, _e3160), false, _e3170), true, _e3180);
                                let _e3194 = select(select(select(select(select(select(_e3152, false, _e3150), false, _e3133), false, _e3160), false, _e3170), false, _e3180), false, _e3187);
                                let _e3199 = select(select(select(select(select(_e3133, true, _e3160), false, _e3170), false, _e3180), false, _e3187), true, _e3194);
                                phi_5837_ = select(select(type_37().member_1, select(_e3185, select(_e3178, _e3176, _e3170), _e3180), _e3187), select(select(select(type_37().member_1, _e3158, _e3133), type_37().member_1, _e3160), type_37().member_1, _e3194), _e3199);
                                phi_5838_ = (select(select(type_37().member, 1u, _e3187), select(select(select(type_37().member, 1u, _e3133), 0u, _e3160), 0u, _e3194), _e3199) != 0u);
                            } else {
                                phi_5837_ = _e1499;
                                phi_5838_ = true;
                            }
                            let _e3204 = phi_5837_;
                            let _e3206 = phi_5838_;
                            if _e3206 {
                                let _e3207 = (_e3204 > _e533);
                                if _e3207 {
                                    phi_8045_ = f64();
                                    phi_8046_ = u32();
                                    phi_8047_ = f64();
                                    phi_8048_ = type_41();
                                    phi_8049_ = u32();
                                    phi_8050_ = u32();
                                    phi_8051_ = false;
                                    phi_8052_ = false;
                                    phi_8053_ = false;
                                } else {
                                    let _e3211 = local_5.member[0u];
                                    let _e3217 = local_5.member[1u];
                                    let _e3233 = local_5.member_1[0u];
                                    let _e3239 = local_5.member_1[1u];
                                    let _e3255 = local_5.member_2[0u];
                                    let _e3261 = local_5.member_2[1u];
                                    let _e3275 = function_3(array<f64, 3>((_e3211[0] + ((_e3217[0] - _e3211[0]) * _e1503)), (_e3211[1] + ((_e3217[1] - _e3211[1]) * _e1503)), (_e3211[2] + ((_e3217[2] - _e3211[2]) * _e1503))), array<f64, 3>((_e3233[0] + ((_e3239[0] - _e3233[0]) * _e1503)), (_e3233[1] + ((_e3239[1] - _e3233[1]) * _e1503)), (_e3233[2] + ((_e3239[2] - _e3233[2]) * _e1503))), array<f64, 3>((_e3255[0] + ((_e3261[0] - _e3255[0]) * _e1503)), (_e3255[1] + ((_e3261[1] - _e3255[1]) * _e1503)), (_e3255[2] + ((_e3261[2] - _e3255[2]) * _e1503))), _e221.member);
                                    let _e3289 = ((select(_e3275[0], -(_e3275[0]), (_e3275[0] < 0.0lf)) + select(_e3275[1], -(_e3275[1]), (_e3275[1] < 0.0lf))) + select(_e3275[2], -(_e3275[2]), (_e3275[2] < 0.0lf)));
                                    let _e3292 = local_5.member[0u];
                                    let _e3298 = local_5.member_1[0u];
                                    let _e3304 = local_5.member_2[0u];
                                    let _e3308 = (_e3292[0] - _e3298[0]);
                                    let _e3309 = (_e3292[1] - _e3298[1]);
                                    let _e3310 = (_e3292[2] - _e3298[2]);
                                    let _e3311 = (_e221.member == 0u);
                                    let _e3323 = local_5.member[1u];
                                    let _e3329 = local_5.member_1[1u];
                                    let _e3335 = local_5.member_2[1u];
                                    let _e3339 = (_e3323[0] - _e3329[0]);
                                    let _e3340 = (_e3323[1] - _e3329[1]);
                                    let _e3341 = (_e3323[2] - _e3329[2]);
                                    let _e3342 = (_e221.member == 0u);
                                    let _e3354 = local_5.member[0u];
                                    let _e3360 = select(_e3354[0], -(_e3354[0]), (_e3354[0] < 0.0lf));
                                    let _e3363 = select(_e3354[1], -(_e3354[1]), (_e3354[1] < 0.0lf));
                                    let _e3365 = select(_e3363, _e3360, (_e3360 > _e3363));
                                    let _e3368 = select(_e3354[2], -(_e3354[2]), (_e3354[2] < 0.0lf));
                                    let _e3370 = select(_e3368, _e3365, (_e3365 > _e3368));
                                    let _e3373 = local_5.member[1u];
                                    let _e3379 = select(_e3373[0], -(_e3373[0]), (_e3373[0] < 0.0lf));
                                    let _e3382 = select(_e3373[1], -(_e3373[1]), (_e3373[1] < 0.0lf));
                                    let _e3384 = select(_e3382, _e3379, (_e3379 > _e3382));
                                    let _e3387 = select(_e3373[2], -(_e3373[2]), (_e3373[2] < 0.0lf));
                                    let _e3389 = select(_e3387, _e3384, (_e3384 > _e3387));
                                    let _e3393 = local_5.member_3;
                                    let _e3397 = local_5.member_1[0u];
                                    let _e3403 = select(_e3397[0], -(_e3397[0]), (_e3397[0] < 0.0lf));
                                    let _e3406 = select(_e3397[1], -(_e3397[1]), (_e3397[1] < 0.0lf));
                                    let _e3408 = select(_e3406, _e3403, (_e3403 > _e3406));
                                    let _e3411 = select(_e3397[2], -(_e3397[2]), (_e3397[2] < 0.0lf));
                                    let _e3413 = select(_e3411, _e3408, (_e3408 > _e3411));
                                    let _e3416 = local_5.member_1[1u];
                                    let _e3422 = select(_e3416[0], -(_e3416[0]), (_e3416[0] < 0.0lf));
                                    let _e3425 = select(_e3416[1], -(_e3416[1]), (_e3416[1] < 0.0lf));
                                    let _e3427 = select(_e3425, _e3422, (_e3422 > _e3425));
                                    let _e3430 = select(_e3416[2], -(_e3416[2]), (_e3416[2] < 0.0lf));
                                    let _e3432 = select(_e3430, _e3427, (_e3427 > _e3430));
                                    let _e3436 = local_5.member_3;
                                    let _e3440 = local_5.member_2[0u];
                                    let _e3446 = select(_e3440[0], -(_e3440[0]), (_e3440[0] < 0.0lf));
                                    let _e3449 = select(_e3440[1], -(_e3440[1]), (_e3440[1] < 0.0lf));
                                    let _e3451 = select(_e3449, _e3446, (_e3446 > _e3449));
                                    let _e3454 = select(_e3440[2], -(_e3440[2]), (_e3440[2] < 0.0lf));
                                    let _e3456 = select(_e3454, _e3451, (_e3451 > _e3454));
                                    let _e3459 = local_5.member_2[1u];
                                    let _e3465 = select(_e3459[0], -(_e3459[0]), (_e3459[0] < 0.0lf));
                                    let _e3468 = select(_e3459[1], -(_e3459[1]), (_e3459[1] < 0.0lf));
                                    let _e3470 = select(_e3468, _e3465, (_e3465 > _e3468));
                                    let _e3473 = select(_e3459[2], -(_e3459[2]), (_e3459[2] < 0.0lf));
                                    let _e3475 = select(_e3473, _e3470, (_e3470 > _e3473));
                                    let _e3479 = local_5.member_3;
                                    let _e3487 = local_5.member_3;
                                    local_1 = type_40(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e3292, array<f64, 3>(_e3308, _e3309, _e3310), array<f64, 3>((_e3292[0] - _e3304[0]), (_e3292[1] - _e3304[1]), (_e3292[2] - _e3304[2])), array<f64, 3>(select((_e3308 - _e3304[0]), _e3292[0], _e3311), select((_e3309 - _e3304[1]), _e3292[1], _e3311), select((_e3310 - _e3304[2]), _e3292[2], _e3311))), array<array<f64, 3>, 4>(_e3323, array<f64, 3>(_e3339, _e3340, _e3341), array<f64, 3>((_e3323[0] - _e3335[0]), (_e3323[1] - _e3335[1]), (_e3323[2] - _e3335[2])), array<f64, 3>(select((_e3339 - _e3335[0]), _e3323[0], _e3342), select((_e3340 - _e3335[1]), _e3323[1], _e3342), select((_e3341 - _e3335[2]), _e3323[2], _e3342)))), ((((((select(_e3389, _e3370, (_e3370 > _e3389)) + _e3393) + (select(_e3432, _e3413, (_e3413 > _e3432)) + _e3436)) + (select(_e3475, _e3456, (_e3456 > _e3475)) + _e3479)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3487 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e772.member_1);
                                    let _e3505 = local_1.member_1;
                                    if (_e3289 > _e3505) {
                                        if ((bitcast<u64>(_e3289) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e3511 = (f64(1f) / _e3289);
                                            let _e3513 = (_e3275[0] * _e3511);
                                            let _e3515 = (_e3275[1] * _e3511);
                                            let _e3517 = (_e3275[2] * _e3511);
                                            let _e3522 = (((_e3513 * _e3513) + (_e3515 * _e3515)) + (_e3517 * _e3517));
                                            if (_e3522 <= 2.2250738585072014e-308lf) {
                                                phi_6520_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3522 > 0.0lf));
                                            } else {
                                                phi_6463_ = type_18(0i, 5i);
                                                phi_6466_ = bitcast<f64>(((bitcast<u64>(_e3522) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3529 = phi_6463_;
                                                    let _e3531 = phi_6466_;
                                                    local_24 = _e3531;
                                                    if (_e3529.member < _e3529.member_1) {
                                                        let _e3538 = (_e3529.member + 1i);
                                                        phi_6464_ = type_18(select(_e3538, type_19().member_1, select(false, true, ((false == (_e3538 > _e3529.member)) != false))), _e3529.member_1);
                                                        phi_6507_ = type_19(1u, _e3529.member);
                                                    } else {
                                                        phi_6464_ = _e3529;
                                                        phi_6507_ = type_19(0u, type_19().member_1);
                                                    }
                                                    let _e3549 = phi_6464_;
                                                    let _e3551 = phi_6507_;
                                                    let _e3554 = (bitcast<i32>(_e3551.member) != 0i);
                                                    if _e3554 {
                                                        phi_6467_ = (0.5lf * (_e3531 + (_e3522 / _e3531)));
                                                    } else {
                                                        phi_6467_ = f64();
                                                    }
                                                    let _e3559 = phi_6467_;
                                                    continue;
                                                    continuing {
                                                        phi_6463_ = _e3549;
                                                        phi_6466_ = _e3559;
                                                        break if !(_e3554);
                                                    }
                                                }
                                                let _e3564 = local_24;
                                                phi_6520_ = (_e3564 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3570 = phi_6520_;
                                            let _e3572 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e3574 = local_1.member_1;
                                            let _e3578 = local_1.member_2;
                                            let _e3583 = ((_e3574 * f64(1.01f)) + ((_e3578 * _e3570) * (f64(1f) + _e3572)));
                                            let _e3587 = local_1.member[0u][0u];
                                            let _e3595 = (((_e3513 * _e3587[0]) + (_e3515 * _e3587[1])) + (_e3517 * _e3587[2]));
                                            let _e3599 = local_1.member[0u][1u];
                                            let _e3607 = (((_e3513 * _e3599[0]) + (_e3515 * _e3599[1])) + (_e3517 * _e3599[2]));
                                            let _e3611 = local_1.member[0u][2u];
                                            let _e3619 = (((_e3513 * _e3611[0]) + (_e3515 * _e3611[1])) + (_e3517 * _e3611[2]));
                                            let _e3623 = local_1.member[0u][3u];
                                            let _e3631 = (((_e3513 * _e3623[0]) + (_e3515 * _e3623[1])) + (_e3517 * _e3623[2]));
                                            let _e3635 = local_1.member[1u][0u];
                                            let _e3643 = (((_e3513 * _e3635[0]) + (_e3515 * _e3635[1])) + (_e3517 * _e3635[2]));
                                            let _e3647 = local_1.member[1u][1u];
                                            let _e3655 = (((_e3513 * _e3647[0]) + (_e3515 * _e3647[1])) + (_e3517 * _e3647[2]));
                                            let _e3659 = local_1.member[1u][2u];
                                            let _e3667 = (((_e3513 * _e3659[0]) + (_e3515 * _e3659[1])) + (_e3517 * _e3659[2]));
                                            let _e3671 = local_1.member[1u][3u];
                                            let _e3679 = (((_e3513 * _e3671[0]) + (_e3515 * _e3671[1])) + (_e3517 * _e3671[2]));
                                            local_2 = type_35(array<f64, 4>(_e3595, _e3607, _e3619, _e3631), array<f64, 4>(_e3643, _e3655, _e3667, _e3679), array<f64, 4>((_e3583 + ((select(_e3595, -(_e3595), (_e3595 < 0.0lf)) + select(_e3643, -(_e3643), (_e3643 < 0.0lf))) * _e3572)), (_e3583 + ((select(_e3607, -(_e3607), (_e3607 < 0.0lf)) + select(_e3655, -(_e3655), (_e3655 < 0.0lf))) * _e3572)), (_e3583 + ((select(_e3619, -(_e3619), (_e3619 < 0.0lf)) + select(_e3667, -(_e3667), (_e3667 < 0.0lf))) * _e3572)), (_e3583 + ((select(_e3631, -(_e3631), (_e3631 < 0.0lf)) + select(_e3679, -(_e3679), (_e3679 < 0.0lf))) * _e3572))));
                                            let _e3724 = (((_e3513 * _e3513) + (_e3515 * _e3515)) + (_e3517 * _e3517));
                                            if (_e3724 <= 2.2250738585072014e-308lf) {
                                                phi_6815_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3724 > 0.0lf));
                                            } else {
                                                phi_6758_ = type_18(0i, 5i);
                                                phi_6761_ = bitcast<f64>(((bitcast<u64>(_e3724) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3731 = phi_6758_;
                                                    let _e3733 = phi_6761_;
                                                    local_25 = _e3733;
                                                    if (_e3731.member < _e3731.member_1) {
                                                        let _e3740 = (_e3731.member + 1i);
                                                        phi_6759_ = type_18(select(_e3740, type_19().member_1, select(false, true, ((false == (_e3740 > _e3731.member)) != false))), _e3731.member_1);
                                                        phi_6802_ = type_19(1u, _e3731.member);
                                                    } else {
                                                        phi_6759_ = _e3731;
                                                        phi_6802_ = type_19(0u, type_19().member_1);
                                                    }
                                                    let _e3751 = phi_6759_;
                                                    let _e3753 = phi_6802_;
                                                    let _e3756 = (bitcast<i32>(_e3753.member) != 0i);
                                                    if _e3756 {
                                                        phi_6762_ = (0.5lf * (_e3733 + (_e3724 / _e3733)));
                                                    } else {
                                                        phi_6762_ = f64();
                                                    }
                                                    let _e3761 = phi_6762_;
                                                    continue;
                                                    continuing {
                                                        phi_6758_ = _e3751;
                                                        phi_6761_ = _e3761;
                                                        break if !(_e3756);
                                                    }
                                                }
                                                let _e3766 = local_25;
                                                phi_6815_ = (_e3766 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3772 = phi_6815_;
                                            let _e3783 = (((_e3275[0] * _e3275[0]) + (_e3275[1] * _e3275[1])) + (_e3275[2] * _e3275[2]));
                                            if (_e3783 <= 2.2250738585072014e-308lf) {
                                                phi_6904_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3783 > 0.0lf));
                                            } else {
                                                phi_6847_ = type_18(0i, 5i);
                                                phi_6850_ = bitcast<f64>(((bitcast<u64>(_e3783) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e3790 = phi_6847_;
                                                    let _e3792 = phi_6850_;
                                                    local_26 = _e3792;
                                                    if (_e3790.member < _e3790.member_1) {
                                                        let _e3799 = (_e3790.member + 1i);
                                                        phi_6848_ = type_18(select(_e3799, type_19().member_1, select(false, true, ((false == (_e3799 > _e3790.member)) != false))), _e3790.member_1);
                                                        phi_6891_ = type_19(1u, _e3790.member);
                                                    } else {
                                                        phi_6848_ = _e3790;
                                                        phi_6891_ = type_19(0u, type_19().member_1);
                                                    }
                                                    let _e3810 = phi_6848_;
                                                    let _e3812 = phi_6891_;
                                                    let _e3815 = (bitcast<i32>(_e3812.member) != 0i);
                                                    if _e3815 {
                                                        phi_6851_ = (0.5lf * (_e3792 + (_e3783 / _e3792)));
                                                    } else {
                                                        phi_6851_ = f64();
                                                    }
                                                    let _e3820 = phi_6851_;
                                                    continue;
                                                    continuing {
                                                        phi_6847_ = _e3810;
                                                        phi_6850_ = _e3820;
                                                        break if !(_e3815);
                                                    }
                                                }
                                                let _e3825 = local_26;
                                                phi_6904_ = (_e3825 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e3831 = phi_6904_;
                                            let _e3839 = local_5.member[0u];
                                            let _e3845 = select(_e3839[0], -(_e3839[0]), (_e3839[0] < 0.0lf));
                                            let _e3848 = select(_e3839[1], -(_e3839[1]), (_e3839[1] < 0.0lf));
                                            let _e3850 = select(_e3848, _e3845, (_e3845 > _e3848));
                                            let _e3853 = select(_e3839[2], -(_e3839[2]), (_e3839[2] < 0.0lf));
                                            let _e3855 = select(_e3853, _e3850, (_e3850 > _e3853));
                                            let _e3858 = local_5.member[1u];
                                            let _e3864 = select(_e3858[0], -(_e3858[0]), (_e3858[0] < 0.0lf));
                                            let _e3867 = select(_e3858[1], -(_e3858[1]), (_e3858[1] < 0.0lf));
                                            let _e3869 = select(_e3867, _e3864, (_e3864 > _e3867));
                                            let _e3872 = select(_e3858[2], -(_e3858[2]), (_e3858[2] < 0.0lf));
                                            let _e3874 = select(_e3872, _e3869, (_e3869 > _e3872));
                                            let _e3878 = local_5.member_3;
                                            let _e3882 = local_5.member_1[0u];
                                            let _e3888 = select(_e3882[0], -(_e3882[0]), (_e3882[0] < 0.0lf));
                                            let _e3891 = select(_e3882[1], -(_e3882[1]), (_e3882[1] < 0.0lf));
                                            let _e3893 = select(_e3891, _e3888, (_e3888 > _e3891));
                                            let _e3896 = select(_e3882[2], -(_e3882[2]), (_e3882[2] < 0.0lf));
                                            let _e3898 = select(_e3896, _e3893, (_e3893 > _e3896));
                                            let _e3901 = local_5.member_1[1u];
                                            let _e3907 = select(_e3901[0], -(_e3901[0]), (_e3901[0] < 0.0lf));
                                            let _e3910 = select(_e3901[1], -(_e3901[1]), (_e3901[1] < 0.0lf));
                                            let _e3912 = select(_e3910, _e3907, (_e3907 > _e3910));
                                            let _e3915 = select(_e3901[2], -(_e3901[2]), (_e3901[2] < 0.0lf));
                                            let _e3917 = select(_e3915, _e3912, (_e3912 > _e3915));
                                            let _e3921 = local_5.member_3;
                                            let _e3925 = local_5.member_2[0u];
                                            let _e3931 = select(_e3925[0], -(_e3925[0]), (_e3925[0] < 0.0lf));
                                            let _e3934 = select(_e3925[1], -(_e3925[1]), (_e3925[1] < 0.0lf));
                                            let _e3936 = select(_e3934, _e3931, (_e3931 > _e3934));
                                            let _e3939 = select(_e3925[2], -(_e3925[2]), (_e3925[2] < 0.0lf));
                                            let _e3941 = select(_e3939, _e3936, (_e3936 > _e3939));
                                            let _e3944 = local_5.member_2[1u];
                                            let _e3950 = select(_e3944[0], -(_e3944[0]), (_e3944[0] < 0.0lf));
                                            let _e3953 = select(_e3944[1], -(_e3944[1]), (_e3944[1] < 0.0lf));
                                            let _e3955 = select(_e3953, _e3950, (_e3950 > _e3953));
                                            let _e3958 = select(_e3944[2], -(_e3944[2]), (_e3944[2] < 0.0lf));
                                            let _e3960 = select(_e3958, _e3955, (_e3955 > _e3958));
                                            let _e3964 = local_5.member_3;
                                            let _e3972 = local_5.member_3;
                                            let _e3987 = ((((_e3831 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e3874, _e3855, (_e3855 > _e3874)) + _e3878) + (select(_e3917, _e3898, (_e3898 > _e3917)) + _e3921)) + (select(_e3960, _e3941, (_e3941 > _e3960)) + _e3964)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3972 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e3772) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                            let _e3990 = local_2.member[0u];
                                            let _e3993 = local_2.member_1[0u];
                                            phi_7222_ = type_9(1u, 4u);
                                            phi_7225_ = ((_e3990 + ((_e3993 - _e3990) * _e1503)) - ((_e3505 * f64(1.01f)) + ((select(_e3990, -(_e3990), (_e3990 < 0.0lf)) + select(_e3993, -(_e3993), (_e3993 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f)))));
                                            loop {
                                                let _e4012 = phi_7222_;
                                                let _e4014 = phi_7225_;
                                                local_27 = _e4014;
                                                local_28 = _e4014;
                                                let _e4017 = (_e4012.member < _e4012.member_1);
                                                let _e4028 = select(type_9().member_1, _e4012.member, _e4017);
                                                let _e4030 = (bitcast<i32>(select(0u, 1u, _e4017)) != 0i);
                                                if _e4030 {
                                                    let _e4033 = local_2.member[_e4028];
                                                    let _e4036 = local_2.member_1[_e4028];
                                                    let _e4053 = ((_e4033 + ((_e4036 - _e4033) * _e1503)) - ((_e3505 * f64(1.01f)) + ((select(_e4033, -(_e4033), (_e4033 < 0.0lf)) + select(_e4036, -(_e4036), (_e4036 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f)))));
                                                    phi_7226_ = select(_e4053, _e4014, (_e4014 < _e4053));
                                                } else {
                                                    phi_7226_ = f64();
                                                }
                                                let _e4057 = phi_7226_;
                                                continue;
                                                continuing {
                                                    phi_7222_ = type_9(select(_e4012.member, (_e4012.member + 1u), _e4017), select(_e4012.member_1, _e4012.member_1, _e4017));
                                                    phi_7225_ = _e4057;
                                                    break if !(_e4030);
                                                }
                                            }
                                            let _e4060 = local_27;
                                            if (_e4060 > f64(0f)) {
                                                let _e4065 = local_28;
                                                let _e4069 = (((_e3987 - _e4065) / _e3987) * f64(2.02f));
                                                if (_e4069 <= 2.2250738585072014e-308lf) {
                                                    phi_7384_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e4069 > 0.0lf));
                                                } else {
                                                    phi_7327_ = type_18(0i, 5i);
                                                    phi_7330_ = bitcast<f64>(((bitcast<u64>(_e4069) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e4076 = phi_7327_;
                                                        let _e4078 = phi_7330_;
                                                        local_29 = _e4078;
                                                        if (_e4076.member < _e4076.member_1) {
                                                            let _e4085 = (_e4076.member + 1i);
                                                            phi_7328_ = type_18(select(_e4085, type_19().member_1, select(false, true, ((false == (_e4085 > _e4076.member)) != false))), _e4076.member_1);
                                                            phi_7371_ = type_19(1u, _e4076.member);
                                                        } else {
                                                            phi_7328_ = _e4076;
                                                            phi_7371_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e4096 = phi_7328_;
                                                        let _e4098 = phi_7371_;
                                                        let _e4101 = (bitcast<i32>(_e4098.member) != 0i);
                                                        if _e4101 {
                                                            phi_7331_ = (0.5lf * (_e4078 + (_e4069 / _e4078)));
                                                        } else {
                                                            phi_7331_ = f64();
                                                        }
                                                        let _e4106 = phi_7331_;
                                                        continue;
                                                        continuing {
                                                            phi_7327_ = _e4096;
                                                            phi_7330_ = _e4106;
                                                            break if !(_e4101);
                                                        }
                                                    }
                                                    let _e4111 = local_29;
                                                    phi_7384_ = (_e4111 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e4117 = phi_7384_;
                                                let _e4120 = ((_e4117 * _e3772) * f64(1.01f));
                                                phi_7391_ = type_9(0u, 4u);
                                                phi_7394_ = f64(2f);
                                                phi_7396_ = true;
                                                phi_7398_ = true;
                                                loop {
                                                    let _e4123 = phi_7391_;
                                                    let _e4125 = phi_7394_;
                                                    let _e4127 = phi_7396_;
                                                    let _e4129 = phi_7398_;
                                                    local_30 = _e4125;
                                                    local_31 = _e4125;
                                                    local_32 = _e4127;
                                                    local_33 = _e4129;
                                                    local_34 = _e4129;
                                                    local_35 = _e4129;
                                                    local_60 = _e4129;
                                                    local_36 = _e4129;
                                                    let _e4132 = (_e4123.member < _e4123.member_1);
                                                    let _e4143 = select(type_9().member_1, _e4123.member, _e4132);
                                                    let _e4145 = (bitcast<i32>(select(0u, 1u, _e4132)) != 0i);
                                                    if _e4145 {
                                                        let _e4149 = local_1.member[0u][_e4143];
                                                        let _e4156 = local_1.member[1u][_e4143];
                                                        let _e4170 = ((select(_e4149[0], -(_e4149[0]), (_e4149[0] < 0.0lf)) + select(_e4149[1], -(_e4149[1]), (_e4149[1] < 0.0lf))) + select(_e4149[2], -(_e4149[2]), (_e4149[2] < 0.0lf)));
                                                        let _e4181 = ((select(_e4156[0], -(_e4156[0]), (_e4156[0] < 0.0lf)) + select(_e4156[1], -(_e4156[1]), (_e4156[1] < 0.0lf))) + select(_e4156[2], -(_e4156[2]), (_e4156[2] < 0.0lf)));
                                                        let _e4189 = (_e4156[0] - _e4149[0]);
                                                        let _e4190 = (_e4156[1] - _e4149[1]);
                                                        let _e4191 = (_e4156[2] - _e4149[2]);
                                                        let _e4210 = local_2.member[_e4143];
                                                        let _e4213 = local_2.member_1[_e4143];
                                                        let _e4226 = ((_e3505 * f64(1.01f)) + ((select(_e4210, -(_e4210), (_e4210 < 0.0lf)) + select(_e4213, -(_e4213), (_e4213 < 0.0lf))) * (1.1102230246251565e-16lf * f64(12f))));
                                                        let _e4233 = local_2.member_1[_e4143];
                                                        let _e4236 = local_2.member[_e4143];
                                                        let _e4237 = (_e4233 - _e4236);
                                                        let _e4240 = ((_e4226 + _e4226) + (_e4120 * ((((select(_e4189, -(_e4189), (_e4189 < 0.0lf)) + select(_e4190, -(_e4190), (_e4190 < 0.0lf))) + select(_e4191, -(_e4191), (_e4191 < 0.0lf))) + (_e3505 * f64(6f))) * f64(1.01f))));
                                                        let _e4243 = ((((_e4210 + ((_e4213 - _e4210) * _e1503)) - _e4226) - (_e4120 * ((select(_e4181, _e4170, (_e4170 > _e4181)) + (_e3505 * f64(3f))) * f64(1.01f)))) - _e3987);
                                                        let _e4244 = (_e4243 > 2.2250738585072014e-308lf);
                                                        let _e4245 = (_e4237 > _e4240);
                                                        if _e4245 {
                                                            phi_7635_ = _e4125;
                                                        } else {
                                                            if _e4244 {
                                                                let _e4252 = (_e4240 - _e4237);
                                                                let _e4255 = (_e4243 / select(2.2250738585072014e-308lf, _e4252, (_e4252 > 2.2250738585072014e-308lf)));
                                                                phi_7634_ = select(_e4255, _e4125, (_e4125 < _e4255));
                                                            } else {
                                                                phi_7634_ = _e4125;
                                                            }
                                                            let _e4259 = phi_7634_;
                                                            phi_7635_ = _e4259;
                                                        }
                                                        let _e4261 = phi_7635_;
                                                        phi_7395_ = _e4261;
                                                        phi_7397_ = (_e4127 && select(_e4244, true, (_e4237 < -(_e4240))));
                                                        phi_7399_ = (_e4129 && select(_e4244, true, _e4245));
                                                    } else {
                                                        phi_7395_ = f64();
                                                        phi_7397_ = bool();
                                                        phi_7399_ = bool();
                                                    }
                                                    let _e4263 = phi_7395_;
                                                    let _e4265 = phi_7397_;
                                                    let _e4267 = phi_7399_;
                                                    continue;
                                                    continuing {
                                                        phi_7391_ = type_9(select(_e4123.member, (_e4123.member + 1u), _e4132), select(_e4123.member_1, _e4123.member_1, _e4132));
                                                        phi_7394_ = _e4263;
                                                        phi_7396_ = _e4265;
                                                        phi_7398_ = _e4267;
                                                        break if !(_e4145);
                                                    }
                                                }
                                                let _e4269 = f64(2f);
                                                let _e4271 = local_30;
                                                let _e4274 = local_31;
                                                let _e4277 = (select(_e4269, _e4274, (_e4271 < _e4269)) * f64(0.999f));
                                                let _e4279 = local_32;
                                                if _e4279 {
                                                    let _e4283 = local_33;
                                                    let _e4287 = local_34;
                                                    let _e4291 = local_35;
                                                    phi_7653_ = type_41(select(_e1503, type_41().member, _e4283), select(f64(2f), type_41().member_1, _e4287), select(1u, type_41().member_2, _e4291));
                                                    let _e5403 = local_60;
                                                    phi_7654_ = _e5403;
                                                } else {
                                                    phi_7653_ = type_41();
                                                    phi_7654_ = true;
                                                }
                                                let _e4295 = phi_7653_;
                                                let _e4297 = phi_7654_;
                                                if _e4297 {
                                                    let _e4299 = local_36;
                                                    if _e4299 {
                                                        let _e4305 = (_e1503 + _e4277);
                                                        let _e4308 = select(_e1503, select(_e542, _e4305, (_e4305 < _e542)), (_e4277 > (1.1102230246251565e-16lf * f64(4096f))));
                                                        phi_7676_ = type_9(0u, 4u);
                                                        phi_7679_ = _e4308;
                                                        phi_7681_ = _e1503;
                                                        loop {
                                                            let _e4310 = phi_7676_;
                                                            let _e4312 = phi_7679_;
                                                            let _e4314 = phi_7681_;
                                                            local_37 = _e4312;
                                                            local_38 = _e4314;
                                                            local_39 = _e4314;
                                                            let _e4317 = (_e4310.member < _e4310.member_1);
                                                            let _e4328 = select(type_9().member_1, _e4310.member, _e4317);
                                                            let _e4330 = (bitcast<i32>(select(0u, 1u, _e4317)) != 0i);
                                                            if _e4330 {
                                                                let _e4333 = local_2.member[_e4328];
                                                                let _e4336 = local_2.member_1[_e4328];
                                                                let _e4339 = local_2.member[_e4328];
                                                                let _e4345 = local_2.member_2[_e4328];
                                                                let _e4346 = ((_e4333 + ((_e4336 - _e4339) * _e1503)) - _e4345);
                                                                let _e4349 = local_2.member_1[_e4328];
                                                                let _e4352 = local_2.member[_e4328];
                                                                let _e4353 = (_e4349 - _e4352);
                                                                if (_e4353 > f64(0f)) {
                                                                    let _e4369 = (_e1503 - (_e4346 / _e4353));
                                                                    phi_7793_ = _e4312;
                                                                    phi_7794_ = select(_e4369, _e4314, (_e4314 > _e4369));
                                                                } else {
                                                                    if (_e4346 > f64(0f)) {
                                                                        if (_e4353 < f64(0f)) {
                                                                            let _e4361 = (_e1503 - (_e4346 / _e4353));
                                                                            phi_7791_ = select(_e4361, _e4312, (_e4312 < _e4361));
                                                                        } else {
                                                                            phi_7791_ = _e4312;
                                                                        }
                                                                        let _e4365 = phi_7791_;
                                                                        phi_7792_ = _e4365;
                                                                    } else {
                                                                        phi_7792_ = _e4312;
                                                                    }
                                                                    let _e4367 = phi_7792_;
                                                                    phi_7793_ = _e4367;
                                                                    phi_7794_ = _e4314;
                                                                }
                                                                let _e4373 = phi_7793_;
                                                                let _e4375 = phi_7794_;
                                                                phi_7680_ = _e4373;
                                                                phi_7682_ = _e4375;
                                                            } else {
                                                                phi_7680_ = f64();
                                                                phi_7682_ = f64();
                                                            }
                                                            let _e4377 = phi_7680_;
                                                            let _e4379 = phi_7682_;
                                                            continue;
                                                            continuing {
                                                                phi_7676_ = type_9(select(_e4310.member, (_e4310.member + 1u), _e4317), select(_e4310.member_1, _e4310.member_1, _e4317));
                                                                phi_7679_ = _e4377;
                                                                phi_7681_ = _e4379;
                                                                break if !(_e4330);
                                                            }
                                                        }
                                                        let _e4382 = local_37;
                                                        let _e4384 = local_38;
                                                        let _e4389 = local_39;
                                                        let _e4390 = (_e4389 + ((_e4382 - _e4384) * f64(0.5f)));
                                                        if (_e4390 > _e1503) {
                                                            if (_e4390 <= _e4308) {
                                                                let _e4393 = f64(0f);
                                                                let _e4396 = local_2.member[0u];
                                                                let _e4399 = local_2.member_1[0u];
                                                                let _e4402 = local_2.member[0u];
                                                                let _e4408 = local_2.member_2[0u];
                                                                if (((_e4396 + ((_e4399 - _e4402) * _e4390)) - _e4408) > _e4393) {
                                                                    let _e4413 = local_2.member[1u];
                                                                    let _e4416 = local_2.member_1[1u];
                                                                    let _e4419 = local_2.member[1u];
                                                                    let _e4425 = local_2.member_2[1u];
                                                                    if (((_e4413 + ((_e4416 - _e4419) * _e4390)) - _e4425) > _e4393) {
                                                                        let _e4430 = local_2.member[2u];
                                                                        let _e4433 = local_2.member_1[2u];
                                                                        let _e4436 = local_2.member[2u];
                                                                        let _e4442 = local_2.member_2[2u];
                                                                        if (((_e4430 + ((_e4433 - _e4436) * _e4390)) - _e4442) > _e4393) {
                                                                            let _e4447 = local_2.member[3u];
                                                                            let _e4450 = local_2.member_1[3u];
                                                                            let _e4453 = local_2.member[3u];
                                                                            let _e4459 = local_2.member_2[3u];
                                                                            phi_7957_ = (((_e4447 + ((_e4450 - _e4453) * _e4390)) - _e4459) > _e4393);
                                                                            phi_7958_ = false;
                                                                        } else {
                                                                            phi_7957_ = bool();
                                                                            phi_7958_ = true;
                                                                        }
                                                                        let _e4463 = phi_7957_;
                                                                        let _e4465 = phi_7958_;
                                                                        phi_7959_ = _e4463;
                                                                        phi_7960_ = _e4465;
                                                                    } else {
                                                                        phi_7959_ = bool();
                                                                        phi_7960_ = true;
                                                                    }
                                                                    let _e4467 = phi_7959_;
                                                                    let _e4469 = phi_7960_;
                                                                    phi_7961_ = _e4467;
                                                                    phi_7962_ = _e4469;
                                                                } else {
                                                                    phi_7961_ = bool();
                                                                    phi_7962_ = true;
                                                                }
                                                                let _e4471 = phi_7961_;
                                                                let _e4473 = phi_7962_;
                                                                phi_7971_ = select(true, false, select(_e4471, false, _e4473));
                                                            } else {
                                                                phi_7971_ = true;
                                                            }
                                                            let _e4477 = phi_7971_;
                                                            phi_7972_ = _e4477;
                                                        } else {
                                                            phi_7972_ = true;
                                                        }
                                                        let _e4479 = phi_7972_;
                                                        phi_7981_ = type_41(_e4308, select(_e4390, f64(2f), _e4479), 2u);
                                                        phi_7982_ = type_41();
                                                        phi_7983_ = false;
                                                    } else {
                                                        phi_7981_ = type_41();
                                                        phi_7982_ = type_41(_e1503, f64(2f), 0u);
                                                        phi_7983_ = true;
                                                    }
                                                    let _e4484 = phi_7981_;
                                                    let _e4486 = phi_7982_;
                                                    let _e4488 = phi_7983_;
                                                    phi_7984_ = _e4484;
                                                    phi_7985_ = _e4486;
                                                    phi_7986_ = _e4488;
                                                } else {
                                                    phi_7984_ = type_41();
                                                    phi_7985_ = _e4295;
                                                    phi_7986_ = true;
                                                }
                                                let _e4490 = phi_7984_;
                                                let _e4492 = phi_7985_;
                                                let _e4494 = phi_7986_;
                                                phi_7992_ = _e4492;
                                                phi_7993_ = _e4490;
                                                phi_7994_ = _e4494;
                                            } else {
                                                phi_7992_ = type_41(_e1503, f64(2f), 0u);
                                                phi_7993_ = type_41();
                                                phi_7994_ = true;
                                            }
                                            let _e4496 = phi_7992_;
                                            let _e4498 = phi_7993_;
                                            let _e4500 = phi_7994_;
                                            phi_7998_ = _e4496;
                                            phi_7999_ = _e4498;
                                            phi_8000_ = false;
                                            phi_8001_ = _e4500;
                                        } else {
                                            phi_7998_ = type_41();
                                            phi_7999_ = type_41();
                                            phi_8000_ = true;
                                            phi_8001_ = false;
                                        }
                                        let _e4502 = phi_7998_;
                                        let _e4504 = phi_7999_;
                                        let _e4506 = phi_8000_;
                                        let _e4508 = phi_8001_;
                                        phi_8002_ = _e4502;
                                        phi_8003_ = _e4504;
                                        phi_8004_ = _e4506;
                                        phi_8005_ = _e4508;
                                    } else {
                                        phi_8002_ = type_41();
                                        phi_8003_ = type_41();
                                        phi_8004_ = true;
                                        phi_8005_ = false;
                                    }
                                    let _e4510 = phi_8002_;
                                    let _e4512 = phi_8003_;
                                    let _e4514 = phi_8004_;
                                    let _e4516 = phi_8005_;
                                    let _e4524 = select(_e4516, true, _e4514);
                                    let _e4528 = select(_e4512.member_1, select(_e4510.member_1, f64(2f), _e4514), _e4524);
                                    let _e4530 = select(_e4512.member_2, select(_e4510.member_2, 0u, _e4514), _e4524);
                                    if ((_e544 & 64u) != 0u) {
                                        let _e4532 = (_e4530 == 2u);
                                        let _e4533 = (_e4528 <= _e542);
                                        phi_8040_ = select(f64(), select(f64(), _e4528, _e4533), _e4532);
                                        phi_8041_ = select(f64(), select(f64(), _e4528, _e4533), _e4532);
                                        phi_8042_ = select(false, _e4533, _e4532);
                                        phi_8043_ = select(false, select(true, false, _e4533), _e4532);
                                        phi_8044_ = select(true, false, _e4532);
                                    } else {
                                        phi_8040_ = f64();
                                        phi_8041_ = f64();
                                        phi_8042_ = false;
                                        phi_8043_ = false;
                                        phi_8044_ = true;
                                    }
                                    let _e4543 = phi_8040_;
                                    let _e4545 = phi_8041_;
                                    let _e4547 = phi_8042_;
                                    let _e4549 = phi_8043_;
                                    let _e4551 = phi_8044_;
                                    phi_8045_ = _e4543;
                                    phi_8046_ = _e4530;
                                    phi_8047_ = _e4545;
                                    phi_8048_ = type_41(select(_e4512.member, select(_e4510.member, _e1503, _e4514), _e4524), _e4528, _e4530);
                                    phi_8049_ = _e4530;
                                    phi_8050_ = _e4530;
                                    phi_8051_ = _e4547;
                                    phi_8052_ = _e4549;
                                    phi_8053_ = _e4551;
                                }
                                let _e4553 = phi_8045_;
                                let _e4555 = phi_8046_;
                                let _e4557 = phi_8047_;
                                let _e4559 = phi_8048_;
                                let _e4561 = phi_8049_;
                                let _e4563 = phi_8050_;
                                let _e4565 = phi_8051_;
                                let _e4567 = phi_8052_;
                                let _e4569 = phi_8053_;
                                phi_8054_ = _e4553;
                                phi_8055_ = _e4555;
                                phi_8056_ = _e4557;
                                phi_8057_ = _e4559;
                                phi_8058_ = _e4561;
                                phi_8059_ = _e4563;
                                phi_8060_ = _e4565;
                                phi_8061_ = _e3207;
                                phi_8062_ = _e4567;
                                phi_8063_ = _e4569;
                                phi_8064_ = false;
                            } else {
                                phi_8054_ = f64();
                                phi_8055_ = u32();
                                phi_8056_ = f64();
                                phi_8057_ = type_41();
                                phi_8058_ = u32();
                                phi_8059_ = u32();
                                phi_8060_ = false;
                                phi_8061_ = false;
                                phi_8062_ = false;
                                phi_8063_ = false;
                                phi_8064_ = true;
                            }
                            let _e4571 = phi_8054_;
                            let _e4573 = phi_8055_;
                            let _e4575 = phi_8056_;
                            let _e4577 = phi_8057_;
                            let _e4579 = phi_8058_;
                            let _e4581 = phi_8059_;
                            let _e4583 = phi_8060_;
                            let _e4585 = phi_8061_;
                            let _e4587 = phi_8062_;
                            let _e4589 = phi_8063_;
                            let _e4591 = phi_8064_;
                            phi_8065_ = _e3204;
                            phi_3049_ = _e4571;
                            phi_3051_ = _e4573;
                            phi_3053_ = _e4575;
                            phi_8066_ = _e4577;
                            phi_8067_ = _e4579;
                            phi_8068_ = _e3204;
                            phi_8069_ = _e4581;
                            phi_8070_ = _e4583;
                            phi_8071_ = _e4585;
                            phi_8072_ = _e4587;
                            phi_8073_ = _e4589;
                            phi_8074_ = false;
                            phi_8075_ = _e4591;
                        } else {
                            phi_8065_ = f64();
                            phi_3049_ = f64();
                            phi_3051_ = u32();
                            phi_3053_ = f64();
                            phi_8066_ = type_41();
                            phi_8067_ = u32();
                            phi_8068_ = f64();
                            phi_8069_ = u32();
                            phi_8070_ = false;
                            phi_8071_ = false;
                            phi_8072_ = false;
                            phi_8073_ = false;
                            phi_8074_ = true;
                            phi_8075_ = false;
                        }
                        let _e4593 = phi_8065_;
                        let _e4595 = phi_3049_;
                        let _e4597 = phi_3051_;
                        let _e4599 = phi_3053_;
                        let _e4601 = phi_8066_;
                        let _e4603 = phi_8067_;
                        let _e4605 = phi_8068_;
                        let _e4607 = phi_8069_;
                        let _e4609 = phi_8070_;
                        let _e4611 = phi_8071_;
                        let _e4613 = phi_8072_;
                        let _e4615 = phi_8073_;
                        let _e4617 = phi_8074_;
                        let _e4619 = phi_8075_;
                        local_40 = _e4611;
                        local_41 = _e4613;
                        local_42 = _e4611;
                        local_43 = _e4615;
                        local_44 = _e4611;
                        local_45 = _e4617;
                        local_46 = _e4611;
                        local_47 = _e4619;
                        local_48 = _e4601;
                        local_49 = _e4601;
                        local_50 = _e4603;
                        local_51 = _e4601;
                        local_61 = _e4611;
                        local_52 = _e4607;
                        local_54 = _e4605;
                        local_55 = _e4593;
                        continue;
                        continuing {
                            phi_3045_ = _e1521;
                            phi_3048_ = _e4595;
                            phi_3050_ = _e4597;
                            phi_3052_ = _e4599;
                            break if !(_e4609);
                        }
                    }
                    let _e4622 = local_40;
                    let _e4624 = local_41;
                    let _e4625 = select(_e4624, false, _e4622);
                    let _e4627 = local_42;
                    let _e4629 = local_43;
                    let _e4632 = local_44;
                    let _e4634 = local_45;
                    let _e4637 = local_46;
                    let _e4639 = local_47;
                    if _e4625 {
                        let _e4642 = local_48;
                        if (_e4642.member >= _e542) {
                            phi_8104_ = type_38(type_37(0u, f64()), 0u);
                        } else {
                            let _e4646 = local_49;
                            let _e4650 = local_50;
                            let _e4653 = local_51;
                            phi_8104_ = type_38(type_37(2u, _e4653.member), select(_e4650, 0u, (_e4646.member > _e533)));
                        }
                        let _e4660 = phi_8104_;
                        phi_8105_ = _e4660;
                        phi_8106_ = false;
                        phi_8107_ = false;
                        phi_8108_ = false;
                        phi_8109_ = false;
                    } else {
                        phi_8105_ = type_38();
                        phi_8106_ = select(_e4629, false, _e4627);
                        let _e5498 = local_61;
                        phi_8107_ = _e5498;
                        phi_8108_ = select(_e4634, false, _e4632);
                        phi_8109_ = select(_e4639, false, _e4637);
                    }
                    let _e4662 = phi_8105_;
                    let _e4664 = phi_8106_;
                    let _e4666 = phi_8107_;
                    let _e4668 = phi_8108_;
                    let _e4670 = phi_8109_;
                    let _e4672 = local_52;
                    let _e4674 = local_53;
                    let _e4677 = local_54;
                    let _e4679 = local_55;
                    let _e4681 = select(_e4666, true, _e4664);
                    let _e4686 = local_56;
                    let _e4687 = select(_e4686, select(_e4679, _e4677, _e4664), _e4681);
                    let _e4689 = local_57;
                    let _e4690 = select(_e4689, select(_e4674, _e4672, _e4664), _e4681);
                    if select(select(_e4668, false, _e4664), true, _e4681) {
                        local[0u] = 0.01f;
                        local[1u] = 0f;
                        local[2u] = 0.8f;
                        phi_8143_ = type_9(0u, 3u);
                        loop {
                            let _e4703 = phi_8143_;
                            let _e4706 = (_e4703.member < _e4703.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e4706)) != 0i) {
                                let _e4721 = local[select(type_9().member_1, _e4703.member, _e4706)];
                                let _e4724 = (_e4687 + (select(f64(0f), _e524, (_e524 >= (1.1102230246251565e-16lf * f64(8f)))) * f64(_e4721)));
                                let _e4726 = select(_e542, _e4724, (_e4724 < _e542));
                                let _e4729 = local_5.member[0u];
                                let _e4735 = local_5.member[1u];
                                let _e4751 = local_5.member_1[0u];
                                let _e4757 = local_5.member_1[1u];
                                let _e4773 = local_5.member_2[0u];
                                let _e4779 = local_5.member_2[1u];
                                let _e4793 = function_3(array<f64, 3>((_e4729[0] + ((_e4735[0] - _e4729[0]) * _e4726)), (_e4729[1] + ((_e4735[1] - _e4729[1]) * _e4726)), (_e4729[2] + ((_e4735[2] - _e4729[2]) * _e4726))), array<f64, 3>((_e4751[0] + ((_e4757[0] - _e4751[0]) * _e4726)), (_e4751[1] + ((_e4757[1] - _e4751[1]) * _e4726)), (_e4751[2] + ((_e4757[2] - _e4751[2]) * _e4726))), array<f64, 3>((_e4773[0] + ((_e4779[0] - _e4773[0]) * _e4726)), (_e4773[1] + ((_e4779[1] - _e4773[1]) * _e4726)), (_e4773[2] + ((_e4779[2] - _e4773[2]) * _e4726))), _e221.member);
                                let _e4804 = (((_e4793[0] * _e4793[0]) + (_e4793[1] * _e4793[1])) + (_e4793[2] * _e4793[2]));
                                if (_e4804 <= 2.2250738585072014e-308lf) {
                                    phi_8376_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e4804 > 0.0lf));
                                } else {
                                    phi_8319_ = type_18(0i, 5i);
                                    phi_8322_ = bitcast<f64>(((bitcast<u64>(_e4804) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e4811 = phi_8319_;
                                        let _e4813 = phi_8322_;
                                        local_58 = _e4813;
                                        if (_e4811.member < _e4811.member_1) {
                                            let _e4820 = (_e4811.member + 1i);
                                            phi_8320_ = type_18(select(_e4820, type_19().member_1, select(false, true, ((false == (_e4820 > _e4811.member)) != false))), _e4811.member_1);
                                            phi_8363_ = type_19(1u, _e4811.member);
                                        } else {
                                            phi_8320_ = _e4811;
                                            phi_8363_ = type_19(0u, type_19().member_1);
                                        }
                                        let _e4831 = phi_8320_;
                                        let _e4833 = phi_8363_;
                                        let _e4836 = (bitcast<i32>(_e4833.member) != 0i);
                                        if _e4836 {
                                            phi_8323_ = (0.5lf * (_e4813 + (_e4804 / _e4813)));
                                        } else {
                                            phi_8323_ = f64();
                                        }
                                        let _e4841 = phi_8323_;
                                        continue;
                                        continuing {
                                            phi_8319_ = _e4831;
                                            phi_8322_ = _e4841;
                                            break if !(_e4836);
                                        }
                                    }
                                    let _e4846 = local_58;
                                    phi_8376_ = (_e4846 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e4852 = phi_8376_;
                                let _e4860 = local_5.member[0u];
                                let _e4866 = select(_e4860[0], -(_e4860[0]), (_e4860[0] < 0.0lf));
                                let _e4869 = select(_e4860[1], -(_e4860[1]), (_e4860[1] < 0.0lf));
                                let _e4871 = select(_e4869, _e4866, (_e4866 > _e4869));
                                let _e4874 = select(_e4860[2], -(_e4860[2]), (_e4860[2] < 0.0lf));
                                let _e4876 = select(_e4874, _e4871, (_e4871 > _e4874));
                                let _e4879 = local_5.member[1u];
                                let _e4885 = select(_e4879[0], -(_e4879[0]), (_e4879[0] < 0.0lf));
                                let _e4888 = select(_e4879[1], -(_e4879[1]), (_e4879[1] < 0.0lf));
                                let _e4890 = select(_e4888, _e4885, (_e4885 > _e4888));
                                let _e4893 = select(_e4879[2], -(_e4879[2]), (_e4879[2] < 0.0lf));
                                let _e4895 = select(_e4893, _e4890, (_e4890 > _e4893));
                                let _e4899 = local_5.member_3;
                                let _e4903 = local_5.member_1[0u];
                                let _e4909 = select(_e4903[0], -(_e4903[0]), (_e4903[0] < 0.0lf));
                                let _e4912 = select(_e4903[1], -(_e4903[1]), (_e4903[1] < 0.0lf));
                                let _e4914 = select(_e4912, _e4909, (_e4909 > _e4912));
                                let _e4917 = select(_e4903[2], -(_e4903[2]), (_e4903[2] < 0.0lf));
                                let _e4919 = select(_e4917, _e4914, (_e4914 > _e4917));
                                let _e4922 = local_5.member_1[1u];
                                let _e4928 = select(_e4922[0], -(_e4922[0]), (_e4922[0] < 0.0lf));
                                let _e4931 = select(_e4922[1], -(_e4922[1]), (_e4922[1] < 0.0lf));
                                let _e4933 = select(_e4931, _e4928, (_e4928 > _e4931));
                                let _e4936 = select(_e4922[2], -(_e4922[2]), (_e4922[2] < 0.0lf));
                                let _e4938 = select(_e4936, _e4933, (_e4933 > _e4936));
                                let _e4942 = local_5.member_3;
                                let _e4946 = local_5.member_2[0u];
                                let _e4952 = select(_e4946[0], -(_e4946[0]), (_e4946[0] < 0.0lf));
                                let _e4955 = select(_e4946[1], -(_e4946[1]), (_e4946[1] < 0.0lf));
                                let _e4957 = select(_e4955, _e4952, (_e4952 > _e4955));
                                let _e4960 = select(_e4946[2], -(_e4946[2]), (_e4946[2] < 0.0lf));
                                let _e4962 = select(_e4960, _e4957, (_e4957 > _e4960));
                                let _e4965 = local_5.member_2[1u];
                                let _e4971 = select(_e4965[0], -(_e4965[0]), (_e4965[0] < 0.0lf));
                                let _e4974 = select(_e4965[1], -(_e4965[1]), (_e4965[1] < 0.0lf));
                                let _e4976 = select(_e4974, _e4971, (_e4971 > _e4974));
                                let _e4979 = select(_e4965[2], -(_e4965[2]), (_e4965[2] < 0.0lf));
                                let _e4981 = select(_e4979, _e4976, (_e4976 > _e4979));
                                let _e4985 = local_5.member_3;
                                let _e4993 = local_5.member_3;
                                let _e5003 = (((_e4852 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e4895, _e4876, (_e4876 > _e4895)) + _e4899) + (select(_e4938, _e4919, (_e4919 > _e4938)) + _e4942)) + (select(_e4981, _e4962, (_e4962 > _e4981)) + _e4985)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4993 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e772.member_1);
                                phi_8653_ = select(true, false, _e5003);
                                phi_8654_ = _e5003;
                            } else {
                                phi_8653_ = false;
                                phi_8654_ = false;
                            }
                            let _e5006 = phi_8653_;
                            let _e5008 = phi_8654_;
                            local_59 = _e5008;
                            continue;
                            continuing {
                                phi_8143_ = type_9(select(_e4703.member, (_e4703.member + 1u), _e4706), select(_e4703.member_1, _e4703.member_1, _e4706));
                                break if !(_e5006);
                            }
                        }
                        let _e5011 = local_59;
                        if _e5011 {
                            phi_8666_ = type_38(type_37(1u, _e4687), select(_e4690, 1u, (_e4687 > _e533)));
                            phi_8667_ = false;
                        } else {
                            phi_8666_ = type_38();
                            phi_8667_ = true;
                        }
                        let _e5017 = phi_8666_;
                        let _e5019 = phi_8667_;
                        if _e5019 {
                            phi_8679_ = type_38(type_37(2u, _e4687), select(_e4690, 0u, (_e4687 > _e533)));
                        } else {
                            phi_8679_ = _e5017;
                        }
                        let _e5025 = phi_8679_;
                        phi_8680_ = _e5025;
                        phi_8681_ = false;
                        phi_8682_ = false;
                    } else {
                        phi_8680_ = type_38();
                        phi_8681_ = select(select(_e4670, false, _e4664), false, _e4681);
                        phi_8682_ = select(select(_e4625, false, _e4664), false, _e4681);
                    }
                    let _e5027 = phi_8680_;
                    let _e5029 = phi_8681_;
                    let _e5031 = phi_8682_;
                    if _e5029 {
                        phi_8689_ = type_38(type_37(0u, f64()), 0u);
                        phi_8690_ = true;
                    } else {
                        phi_8689_ = _e4662;
                        phi_8690_ = _e5031;
                    }
                    let _e5035 = phi_8689_;
                    let _e5037 = phi_8690_;
                    phi_8694_ = _e5035;
                    phi_8695_ = _e5027;
                    phi_8696_ = _e5037;
                } else {
                    phi_8694_ = _e1493;
                    phi_8695_ = type_38();
                    phi_8696_ = true;
                }
                let _e5039 = phi_8694_;
                let _e5041 = phi_8695_;
                let _e5043 = phi_8696_;
                if _e5043 {
                    phi_8700_ = _e5039;
                } else {
                    phi_8700_ = _e5041;
                }
                let _e5045 = phi_8700_;
                switch bitcast<i32>(_e5045.member.member) {
                    case 0: {
                        phi_8718_ = type_34(0u, _e5045.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5056 = function_4(_e5045.member.member_1);
                        phi_8718_ = type_34(0u, _e5045.member_1, _e5056, true);
                        break;
                    }
                    case 2: {
                        let _e5052 = function_4(_e5045.member.member_1);
                        phi_8718_ = type_34(1u, _e5045.member_1, _e5052, true);
                        break;
                    }
                    default: {
                        phi_8718_ = type_34();
                        break;
                    }
                }
                let _e5060 = phi_8718_;
                phi_8719_ = _e5060;
                phi_8720_ = type_9(_e188, _e191);
            } else {
                phi_8719_ = type_34(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_8720_ = type_9(0u, 0u);
            }
            let _e5062 = phi_8719_;
            let _e5064 = phi_8720_;
            let _e5069 = params.member.member.member_1;
            let _e5071 = ((_e5069 & 16u) != 0u);
            let _e5074 = select(false, select(false, true, _e5071), _e5062.member_3);
            if _e5062.member_3 {
                let _e5079 = (_e5062.member_2[1] >> bitcast<u32>(20i));
                if (_e5079 <= 896u) {
                    phi_8760_ = 0u;
                } else {
                    phi_8760_ = ((((_e5079 - 896u) << bitcast<u32>(23i)) | ((_e5062.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e5062.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e5094 = phi_8760_;
                let _e5096 = atomicMin((&earliest.member[0u]), _e5094);
            }
            if (_e103 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5074 {
                let _e5100 = atomicAdd((&counters[0u]), 1u);
                phi_8774_ = _e5100;
            } else {
                phi_8774_ = 0u;
            }
            let _e5102 = phi_8774_;
            workgroupBarrier();
            if (_e103 == 0u) {
                let _e5105 = atomicLoad((&counters[0u]));
                if (_e5105 > 0u) {
                    let _e5108 = atomicAdd((&contacts.member[0u]), _e5105);
                    atomicStore((&counters[1u]), _e5108);
                }
            }
            workgroupBarrier();
            let _e5111 = atomicLoad((&counters[1u]));
            let _e5112 = (_e5111 + _e5102);
            if _e5074 {
                if _e5071 {
                    let _e5115 = params.member.member_1.member_3;
                    let _e5118 = params.member.member_2.member;
                    if (_e5112 < _e5115) {
                        let _e5120 = (7u * _e5112);
                        atomicStore((&contacts.member[(4u + _e5120)]), _e5118);
                        atomicStore((&contacts.member[(_e5120 + 5u)]), _e5062.member);
                        atomicStore((&contacts.member[(_e5120 + 6u)]), _e5064.member);
                        atomicStore((&contacts.member[(_e5120 + 7u)]), _e5064.member_1);
                        atomicStore((&contacts.member[(_e5120 + 8u)]), _e5062.member_2[0]);
                        atomicStore((&contacts.member[(_e5120 + 9u)]), _e5062.member_2[1]);
                        atomicStore((&contacts.member[(_e5120 + 10u)]), _e5062.member_1);
                    }
                    phi_8834_ = false;
                } else {
                    phi_8834_ = true;
                }
                let _e5142 = phi_8834_;
                phi_8835_ = _e5142;
            } else {
                phi_8835_ = true;
            }
            let _e5144 = phi_8835_;
            if _e5144 {
                if _e5074 {
                    let _e5147 = params.member.member_2.member_1;
                    if (_e5112 < _e5147) {
                        let _e5149 = (2u * _e5112);
                        atomicStore((&contacts.member[(4u + _e5149)]), _e5064.member);
                        atomicStore((&contacts.member[(_e5149 + 5u)]), _e5064.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_990_ = type_9(select(_e159.member, (_e159.member + 1u), _e162), select(_e159.member_1, _e159.member_1, _e162));
            break if !(_e175);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_near_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
