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

struct type_29 {
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
    member: f64,
    member_1: f64,
}

struct type_39 {
    member: array<f64, 4>,
    member_1: f64,
    member_2: f64,
    member_3: f64,
}

struct type_41 {
    member: type_33,
    member_1: f64,
}

struct type_42 {
    member: u32,
    member_1: f64,
}

struct type_43 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_44 {
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_48 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(2) 
var<storage> positions: type_29;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(1) 
var<storage> paths: type_26;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_48;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_48;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_248_: f64;
    var phi_291_: f64;
    var phi_334_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_248_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_248_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_248_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_291_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_291_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_291_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_334_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_334_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_334_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_1(param_1: ptr<function, type_39>, param_2: f64, param_3: f64, param_4: f64) -> bool {
    var phi_432_: bool;
    var phi_433_: bool;
    var phi_438_: bool;

    let _e15 = (*param_1).member_3;
    let _e17 = (*param_1).member_3;
    let _e19 = (param_2 + (_e15 + _e17));
    if (_e19 < param_4) {
        let _e22 = (f64(1f) - param_3);
        let _e25 = (*param_1).member[0u];
        let _e28 = (*param_1).member[1u];
        let _e31 = (*param_1).member[2u];
        let _e34 = (*param_1).member[3u];
        let _e45 = ((((_e25 * _e22) + (_e28 * param_3)) * (_e22 * _e22)) + (((_e31 * _e22) + (_e34 * param_3)) * (param_3 * param_3)));
        let _e47 = select(param_3, _e19, (_e19 > param_3));
        let _e49 = (f64(1f) - _e47);
        let _e52 = (*param_1).member[0u];
        let _e55 = (*param_1).member[1u];
        let _e58 = (*param_1).member[2u];
        let _e61 = (*param_1).member[3u];
        let _e72 = ((((_e52 * _e49) + (_e55 * _e47)) * (_e49 * _e49)) + (((_e58 * _e49) + (_e61 * _e47)) * (_e47 * _e47)));
        let _e74 = (*param_1).member_1;
        let _e76 = (*param_1).member_1;
        let _e82 = (*param_1).member_1;
        if (select(_e45, -(_e45), (_e45 < 0.0lf)) > _e82) {
            let _e87 = (select(_e72, -(_e72), (_e72 < 0.0lf)) > (_e74 + _e76));
            phi_432_ = select(bool(), ((_e45 > f64(0f)) == (_e72 > f64(0f))), _e87);
            phi_433_ = select(true, false, _e87);
        } else {
            phi_432_ = bool();
            phi_433_ = true;
        }
        let _e96 = phi_432_;
        let _e98 = phi_433_;
        phi_438_ = select(_e96, false, _e98);
    } else {
        phi_438_ = false;
    }
    let _e101 = phi_438_;
    return _e101;
}

fn function_2(param_5: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_5);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_3(param_6: array<f64, 3>, param_7: array<f64, 3>) -> array<f64, 3> {
    let _e24 = ((((param_7[0] * param_7[0]) + (param_7[1] * param_7[1])) + (param_7[2] * param_7[2])) < (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
    return array<f64, 3>(select(param_6[0], param_7[0], _e24), select(param_6[1], param_7[1], _e24), select(param_6[2], param_7[2], _e24));
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_7703_: array<array<f64, 3>, 4>;

    let _e9 = (param_8[0] - param_9[0]);
    let _e12 = (param_8[1] - param_9[1]);
    let _e15 = (param_8[2] - param_9[2]);
    if (param_11 != 0u) {
        let _e163 = ((((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2])) / (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2])));
        let _e171 = select(f64(0f), select(f64(1f), _e163, (_e163 < f64(1f))), (_e163 > f64(0f)));
        let _e207 = ((((param_8[0] * param_10[0]) + (param_8[1] * param_10[1])) + (param_8[2] * param_10[2])) / (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2])));
        let _e215 = select(f64(0f), select(f64(1f), _e207, (_e207 < f64(1f))), (_e207 > f64(0f)));
        let _e248 = ((((_e9 * param_10[0]) + (_e12 * param_10[1])) + (_e15 * param_10[2])) / (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2])));
        let _e256 = select(f64(0f), select(f64(1f), _e248, (_e248 < f64(1f))), (_e248 > f64(0f)));
        let _e269 = (param_8[0] - param_10[0]);
        let _e272 = (param_8[1] - param_10[1]);
        let _e275 = (param_8[2] - param_10[2]);
        let _e295 = ((((_e269 * param_9[0]) + (_e272 * param_9[1])) + (_e275 * param_9[2])) / (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2])));
        let _e303 = select(f64(0f), select(f64(1f), _e295, (_e295 < f64(1f))), (_e295 > f64(0f)));
        phi_7703_ = array<array<f64, 3>, 4>(array<f64, 3>((param_8[0] - (param_9[0] * _e171)), (param_8[1] - (param_9[1] * _e171)), (param_8[2] - (param_9[2] * _e171))), array<f64, 3>((param_8[0] - (param_10[0] * _e215)), (param_8[1] - (param_10[1] * _e215)), (param_8[2] - (param_10[2] * _e215))), array<f64, 3>((_e9 - (param_10[0] * _e256)), (_e12 - (param_10[1] * _e256)), (_e15 - (param_10[2] * _e256))), array<f64, 3>((_e269 - (param_9[0] * _e303)), (_e272 - (param_9[1] * _e303)), (_e275 - (param_9[2] * _e303))));
    } else {
        let _e19 = (param_10[0] - param_9[0]);
        let _e22 = (param_10[1] - param_9[1]);
        let _e25 = (param_10[2] - param_9[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        let _e44 = select(f64(0f), select(f64(1f), _e36, (_e36 < f64(1f))), (_e36 > f64(0f)));
        let _e51 = array<f64, 3>((_e9 - (_e19 * _e44)), (_e12 - (_e22 * _e44)), (_e15 - (_e25 * _e44)));
        let _e74 = ((((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2])) / (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2])));
        let _e82 = select(f64(0f), select(f64(1f), _e74, (_e74 < f64(1f))), (_e74 > f64(0f)));
        let _e118 = ((((param_8[0] * param_10[0]) + (param_8[1] * param_10[1])) + (param_8[2] * param_10[2])) / (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2])));
        let _e126 = select(f64(0f), select(f64(1f), _e118, (_e118 < f64(1f))), (_e118 > f64(0f)));
        phi_7703_ = array<array<f64, 3>, 4>(array<f64, 3>((param_8[0] - (param_9[0] * _e82)), (param_8[1] - (param_9[1] * _e82)), (param_8[2] - (param_9[2] * _e82))), array<f64, 3>((param_8[0] - (param_10[0] * _e126)), (param_8[1] - (param_10[1] * _e126)), (param_8[2] - (param_10[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_7703_;
    let _e319 = function_3(_e316[0], _e316[1]);
    let _e321 = function_3(_e319, _e316[2]);
    let _e323 = function_3(_e321, _e316[3]);
    return _e323;
}

fn function_5(param_12: array<f64, 3>, param_13: array<f64, 3>, param_14: array<f64, 3>, param_15: u32) -> array<f64, 3> {
    var phi_7302_: bool;
    var phi_7336_: array<f64, 3>;
    var phi_7337_: bool;
    var phi_7338_: array<f64, 3>;
    var phi_7339_: bool;
    var phi_7344_: array<f64, 3>;

    let _e23 = (((param_13[0] * param_13[0]) + (param_13[1] * param_13[1])) + (param_13[2] * param_13[2]));
    let _e34 = (((param_13[0] * param_14[0]) + (param_13[1] * param_14[1])) + (param_13[2] * param_14[2]));
    let _e45 = (((param_14[0] * param_14[0]) + (param_14[1] * param_14[1])) + (param_14[2] * param_14[2]));
    let _e56 = (((param_12[0] * param_13[0]) + (param_12[1] * param_13[1])) + (param_12[2] * param_13[2]));
    let _e67 = (((param_12[0] * param_14[0]) + (param_12[1] * param_14[1])) + (param_12[2] * param_14[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e71 = f64(0f);
    let _e72 = f64(1f);
    let _e76 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e80 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_15 != 0u) {
        let _e91 = (_e76 >= _e71);
        let _e92 = (_e80 >= _e71);
        let _e93 = (_e76 <= _e72);
        phi_7302_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_7302_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_7302_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_7336_ = array<f64, 3>((param_12[0] - ((param_13[0] * _e76) + (param_14[0] * _e80))), (param_12[1] - ((param_13[1] * _e76) + (param_14[1] * _e80))), (param_12[2] - ((param_13[2] * _e76) + (param_14[2] * _e80))));
            phi_7337_ = false;
        } else {
            phi_7336_ = array<f64, 3>();
            phi_7337_ = true;
        }
        let _e132 = phi_7336_;
        let _e134 = phi_7337_;
        phi_7338_ = _e132;
        phi_7339_ = _e134;
    } else {
        phi_7338_ = array<f64, 3>();
        phi_7339_ = true;
    }
    let _e136 = phi_7338_;
    let _e138 = phi_7339_;
    if _e138 {
        let _e139 = function_4(param_12, param_13, param_14, param_15);
        phi_7344_ = _e139;
    } else {
        phi_7344_ = _e136;
    }
    let _e141 = phi_7344_;
    return _e141;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_44;
    var local_1: type_44;
    var local_2: array<type_36, 4>;
    var local_3: array<f64, 4>;
    var local_4: array<f64, 2>;
    var local_5: type_39;
    var local_6: array<f64, 4>;
    var local_7: type_33;
    var local_8: type_35;
    var phi_505_: u32;
    var phi_550_: u32;
    var phi_553_: type_9;
    var phi_727_: type_23;
    var phi_923_: type_31;
    var phi_1084_: type_33;
    var phi_1580_: bool;
    var phi_1676_: type_41;
    var phi_1677_: bool;
    var phi_1678_: type_41;
    var phi_1679_: bool;
    var phi_1680_: type_41;
    var phi_1681_: bool;
    var phi_1686_: type_41;
    var phi_2388_: bool;
    var phi_2403_: f64;
    var phi_2479_: type_16;
    var phi_2482_: f64;
    var phi_2480_: type_16;
    var phi_2523_: type_17;
    var phi_2483_: f64;
    var local_9: f64;
    var phi_2536_: f64;
    var phi_2567_: type_9;
    var phi_2570_: u32;
    var phi_2637_: u32;
    var phi_2638_: u32;
    var phi_2571_: u32;
    var phi_2639_: u32;
    var phi_2697_: type_9;
    var phi_2857_: type_43;
    var phi_2858_: bool;
    var phi_2859_: type_43;
    var phi_2860_: bool;
    var phi_2895_: type_9;
    var phi_2898_: f64;
    var phi_2900_: f64;
    var phi_2902_: f64;
    var phi_3016_: bool;
    var phi_3023_: f64;
    var phi_3024_: bool;
    var phi_2899_: f64;
    var phi_2901_: f64;
    var phi_2903_: f64;
    var phi_3025_: f64;
    var phi_3026_: bool;
    var phi_3027_: bool;
    var local_10: bool;
    var local_11: f64;
    var local_12: f64;
    var phi_3032_: f64;
    var phi_3050_: type_9;
    var phi_3053_: f64;
    var phi_3119_: f64;
    var phi_3120_: bool;
    var phi_3121_: bool;
    var phi_3122_: bool;
    var phi_3123_: f64;
    var phi_3054_: f64;
    var phi_3124_: bool;
    var phi_3125_: bool;
    var phi_3126_: bool;
    var phi_3127_: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: f64;
    var phi_3141_: f64;
    var phi_3143_: type_43;
    var phi_4004_: array<type_36, 4>;
    var phi_4024_: type_9;
    var phi_4027_: bool;
    var phi_4028_: bool;
    var phi_4079_: bool;
    var phi_4080_: bool;
    var local_18: bool;
    var local_19: bool;
    var phi_4094_: u32;
    var phi_4095_: u32;
    var phi_4096_: bool;
    var phi_4127_: bool;
    var phi_4128_: bool;
    var phi_4129_: bool;
    var phi_4130_: bool;
    var phi_4131_: bool;
    var phi_4132_: bool;
    var phi_4133_: bool;
    var phi_4134_: bool;
    var phi_4135_: bool;
    var phi_4136_: bool;
    var phi_4137_: bool;
    var phi_4138_: bool;
    var phi_4139_: type_43;
    var phi_4140_: bool;
    var phi_4141_: type_43;
    var phi_4142_: bool;
    var phi_4143_: bool;
    var phi_4144_: bool;
    var phi_4145_: bool;
    var phi_4146_: type_43;
    var phi_4147_: bool;
    var phi_4148_: type_43;
    var phi_4149_: bool;
    var phi_4150_: bool;
    var phi_4151_: bool;
    var phi_4152_: bool;
    var phi_4153_: bool;
    var phi_4161_: type_43;
    var phi_4162_: bool;
    var phi_4163_: type_43;
    var phi_4164_: bool;
    var phi_4165_: bool;
    var phi_4166_: bool;
    var phi_4167_: bool;
    var phi_4168_: bool;
    var phi_4597_: type_9;
    var phi_4600_: f64;
    var phi_4602_: f64;
    var phi_4604_: f64;
    var phi_4606_: f64;
    var phi_4608_: bool;
    var phi_4610_: u32;
    var phi_4762_: array<f64, 3>;
    var phi_4830_: type_16;
    var phi_4833_: f64;
    var phi_4831_: type_16;
    var phi_4874_: type_17;
    var phi_4834_: f64;
    var local_20: f64;
    var phi_4887_: f64;
    var phi_5013_: type_44;
    var phi_5014_: bool;
    var phi_5015_: type_44;
    var phi_5016_: bool;
    var phi_5026_: type_44;
    var phi_5198_: bool;
    var phi_5199_: bool;
    var phi_5200_: bool;
    var phi_5201_: bool;
    var phi_5202_: bool;
    var phi_5203_: bool;
    var phi_5505_: bool;
    var phi_5506_: bool;
    var phi_5507_: bool;
    var phi_5508_: bool;
    var phi_5509_: bool;
    var phi_5510_: bool;
    var phi_5518_: bool;
    var phi_5628_: f64;
    var phi_5629_: bool;
    var phi_5630_: f64;
    var phi_5631_: bool;
    var phi_5632_: f64;
    var phi_5633_: bool;
    var phi_5634_: bool;
    var phi_5700_: f64;
    var phi_5701_: bool;
    var phi_5702_: f64;
    var phi_5703_: bool;
    var phi_5704_: f64;
    var phi_5705_: bool;
    var phi_5706_: bool;
    var phi_5777_: f64;
    var phi_5778_: bool;
    var phi_5779_: f64;
    var phi_5780_: bool;
    var phi_5781_: f64;
    var phi_5782_: bool;
    var phi_5783_: bool;
    var phi_5849_: f64;
    var phi_5850_: bool;
    var phi_5851_: f64;
    var phi_5852_: bool;
    var phi_5853_: f64;
    var phi_5854_: bool;
    var phi_5855_: bool;
    var phi_6032_: type_16;
    var phi_6035_: f64;
    var phi_6033_: type_16;
    var phi_6076_: type_17;
    var phi_6036_: f64;
    var local_21: f64;
    var phi_6089_: f64;
    var phi_6366_: bool;
    var phi_6367_: bool;
    var phi_6394_: f64;
    var phi_6395_: f64;
    var phi_6396_: bool;
    var phi_6397_: f64;
    var phi_6398_: f64;
    var phi_6399_: bool;
    var phi_6400_: bool;
    var phi_6401_: f64;
    var phi_6402_: f64;
    var phi_6403_: f64;
    var phi_6404_: f64;
    var phi_6405_: bool;
    var phi_6406_: bool;
    var phi_6407_: bool;
    var phi_6408_: bool;
    var phi_6409_: f64;
    var phi_6410_: f64;
    var phi_6411_: f64;
    var phi_6412_: f64;
    var phi_6413_: bool;
    var phi_6414_: bool;
    var phi_6415_: bool;
    var phi_6416_: bool;
    var phi_6417_: bool;
    var phi_6418_: f64;
    var phi_6419_: f64;
    var phi_6420_: f64;
    var phi_6421_: f64;
    var phi_6422_: bool;
    var phi_6423_: bool;
    var phi_6424_: bool;
    var phi_6425_: bool;
    var phi_6426_: bool;
    var phi_6764_: f64;
    var phi_6766_: u32;
    var phi_6767_: f64;
    var phi_6768_: bool;
    var phi_6769_: bool;
    var phi_6770_: bool;
    var phi_6771_: u32;
    var phi_6772_: f64;
    var phi_6773_: f64;
    var phi_6774_: f64;
    var phi_6775_: f64;
    var phi_6776_: bool;
    var phi_6777_: u32;
    var phi_6778_: bool;
    var phi_6779_: bool;
    var phi_6780_: bool;
    var phi_6781_: bool;
    var phi_6782_: bool;
    var phi_6783_: bool;
    var phi_6811_: f64;
    var phi_6812_: f64;
    var phi_6813_: f64;
    var phi_6814_: f64;
    var phi_6815_: bool;
    var phi_6816_: u32;
    var phi_6817_: bool;
    var phi_6818_: bool;
    var phi_6819_: bool;
    var phi_6820_: bool;
    var phi_6821_: bool;
    var phi_6822_: bool;
    var phi_4601_: f64;
    var phi_4603_: f64;
    var phi_4605_: f64;
    var phi_4607_: f64;
    var phi_4609_: bool;
    var phi_4611_: u32;
    var phi_6823_: f64;
    var phi_6824_: f64;
    var phi_6825_: bool;
    var phi_6826_: bool;
    var phi_6827_: bool;
    var phi_6828_: bool;
    var phi_6829_: bool;
    var phi_6830_: bool;
    var phi_6831_: bool;
    var local_22: bool;
    var local_23: bool;
    var local_24: bool;
    var local_25: bool;
    var local_26: bool;
    var local_27: bool;
    var local_28: bool;
    var local_29: bool;
    var local_30: bool;
    var local_31: bool;
    var local_32: f64;
    var local_33: bool;
    var local_34: f64;
    var local_35: f64;
    var local_36: f64;
    var phi_6899_: f64;
    var phi_6900_: bool;
    var phi_6901_: bool;
    var phi_6902_: bool;
    var phi_6903_: bool;
    var phi_6904_: bool;
    var phi_6905_: type_43;
    var phi_6906_: bool;
    var phi_6907_: f64;
    var phi_6908_: type_43;
    var phi_6909_: bool;
    var phi_6910_: bool;
    var phi_6911_: bool;
    var phi_6912_: bool;
    var phi_6913_: bool;
    var phi_6914_: bool;
    var local_37: bool;
    var local_38: bool;
    var local_39: type_43;
    var local_40: f64;
    var local_41: f64;
    var phi_6930_: type_42;
    var phi_6931_: bool;
    var local_42: f64;
    var phi_6937_: type_42;
    var phi_6938_: bool;
    var phi_6939_: bool;
    var phi_6940_: bool;
    var phi_6941_: bool;
    var local_43: bool;
    var local_44: type_43;
    var phi_6983_: type_42;
    var phi_6984_: type_42;
    var phi_6985_: bool;
    var phi_7029_: type_35;
    var phi_7038_: type_9;
    var phi_7067_: bool;
    var phi_7068_: bool;
    var phi_7112_: u32;
    var local_45: u32;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var local_49: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e105 = id_2;
    let _e106 = n_2;
    let _e107 = lane_2;
    let _e119 = ((_e105.y * _e106.x) + _e105.x);
    let _e122 = (_e106.x * _e106.y);
    let _e125 = params.member.member_1.member_2;
    let _e127 = input.member[0u];
    let _e129 = select(_e127, _e125, (_e125 < _e127));
    let _e131 = params.member.member_1.member_1;
    if (_e129 > _e131) {
        let _e134 = params.member.member_1.member_1;
        phi_505_ = (_e129 - _e134);
    } else {
        phi_505_ = 0u;
    }
    let _e137 = phi_505_;
    let _e139 = params.member.member_1.member;
    let _e141 = select(_e137, _e139, (_e139 < _e137));
    let _e142 = (_e141 / 64u);
    let _e146 = select(_e142, (_e142 + 1u), ((_e141 % 64u) > 0u));
    if (_e146 > _e119) {
        let _e148 = (_e146 - _e119);
        if (_e122 == 0u) {
            return;
        }
        let _e150 = (_e148 / _e122);
        if (_e122 == 0u) {
            return;
        }
        phi_550_ = select(_e150, (_e150 + 1u), ((_e148 % _e122) > 0u));
    } else {
        phi_550_ = 0u;
    }
    let _e157 = phi_550_;
    phi_553_ = type_9(0u, _e157);
    loop {
        let _e160 = phi_553_;
        let _e163 = (_e160.member < _e160.member_1);
        let _e176 = (bitcast<i32>(select(0u, 1u, _e163)) != 0i);
        if _e176 {
            let _e180 = (((_e119 + (select(type_9().member_1, _e160.member, _e163) * _e122)) * 64u) + _e107);
            local_8 = type_35(0u, 0u, array<u32, 2>(0u, 0u), false);
            if (_e180 < _e141) {
                let _e184 = params.member.member_1.member_1;
                let _e186 = (2u * (_e184 + _e180));
                let _e189 = input.member[(4u + _e186)];
                let _e192 = input.member[(_e186 + 5u)];
                let _e197 = (_e192 & 2147483647u);
                if (select(1u, 0u, ((_e192 & 2147483648u) == 0u)) == 0u) {
                    let _e216 = params.member.member.member[1u];
                    let _e219 = ((2u * _e216) + (3u * _e197));
                    let _e221 = elements.member[_e219];
                    let _e224 = elements.member[(_e219 + 1u)];
                    let _e227 = elements.member[(_e219 + 2u)];
                    phi_727_ = type_23(0u, array<u32, 4>(_e189, _e221, _e224, _e227));
                } else {
                    let _e200 = (2u * _e189);
                    let _e202 = elements.member[_e200];
                    let _e205 = elements.member[(_e200 + 1u)];
                    let _e206 = (2u * _e197);
                    let _e208 = elements.member[_e206];
                    let _e211 = elements.member[(_e206 + 1u)];
                    phi_727_ = type_23(1u, array<u32, 4>(_e202, _e205, _e208, _e211));
                }
                let _e231 = phi_727_;
                let _e235 = params.member.member.member_1;
                if ((_e235 & 8u) != 0u) {
                    let _e279 = paths.member[_e231.member_1[0]];
                    let _e294 = paths.member[_e231.member_1[1]];
                    let _e309 = paths.member[_e231.member_1[2]];
                    let _e324 = paths.member[_e231.member_1[3]];
                    let _e345 = function_(array<f32, 3>(_e279.member.x, _e279.member.y, _e279.member.z));
                    let _e346 = function_(array<f32, 3>(_e294.member.x, _e294.member.y, _e294.member.z));
                    let _e347 = function_(array<f32, 3>(_e309.member.x, _e309.member.y, _e309.member.z));
                    let _e348 = function_(array<f32, 3>(_e324.member.x, _e324.member.y, _e324.member.z));
                    let _e350 = function_(array<f32, 3>(_e279.member_1.x, _e279.member_1.y, _e279.member_1.z));
                    let _e351 = function_(array<f32, 3>(_e294.member_1.x, _e294.member_1.y, _e294.member_1.z));
                    let _e352 = function_(array<f32, 3>(_e309.member_1.x, _e309.member_1.y, _e309.member_1.z));
                    let _e353 = function_(array<f32, 3>(_e324.member_1.x, _e324.member_1.y, _e324.member_1.z));
                    phi_923_ = type_31(array<array<f64, 3>, 4>(_e345, _e346, _e347, _e348), array<array<f64, 3>, 4>(_e350, _e351, _e352, _e353));
                } else {
                    let _e240 = positions.member[_e231.member_1[0]];
                    let _e243 = params.member.member.member[0u];
                    let _e246 = positions.member[(_e243 + _e231.member_1[0])];
                    let _e249 = positions.member[_e231.member_1[1]];
                    let _e252 = params.member.member.member[0u];
                    let _e255 = positions.member[(_e252 + _e231.member_1[1])];
                    let _e258 = positions.member[_e231.member_1[2]];
                    let _e261 = params.member.member.member[0u];
                    let _e264 = positions.member[(_e261 + _e231.member_1[2])];
                    let _e267 = positions.member[_e231.member_1[3]];
                    let _e270 = params.member.member.member[0u];
                    let _e273 = positions.member[(_e270 + _e231.member_1[3])];
                    phi_923_ = type_31(array<array<f64, 3>, 4>(_e240, _e249, _e258, _e267), array<array<f64, 3>, 4>(_e246, _e255, _e264, _e273));
                }
                let _e357 = phi_923_;
                if (_e231.member != 0u) {
                    phi_1084_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[2][0] - _e357.member[0][0]), (_e357.member[2][1] - _e357.member[0][1]), (_e357.member[2][2] - _e357.member[0][2])), array<f64, 3>((_e357.member_1[2][0] - _e357.member_1[0][0]), (_e357.member_1[2][1] - _e357.member_1[0][1]), (_e357.member_1[2][2] - _e357.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[1][0] - _e357.member[0][0]), (_e357.member[1][1] - _e357.member[0][1]), (_e357.member[1][2] - _e357.member[0][2])), array<f64, 3>((_e357.member_1[1][0] - _e357.member_1[0][0]), (_e357.member_1[1][1] - _e357.member_1[0][1]), (_e357.member_1[1][2] - _e357.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[2][0] - _e357.member[3][0]), (_e357.member[2][1] - _e357.member[3][1]), (_e357.member[2][2] - _e357.member[3][2])), array<f64, 3>((_e357.member_1[2][0] - _e357.member_1[3][0]), (_e357.member_1[2][1] - _e357.member_1[3][1]), (_e357.member_1[2][2] - _e357.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_1084_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[0][0] - _e357.member[1][0]), (_e357.member[0][1] - _e357.member[1][1]), (_e357.member[0][2] - _e357.member[1][2])), array<f64, 3>((_e357.member_1[0][0] - _e357.member_1[1][0]), (_e357.member_1[0][1] - _e357.member_1[1][1]), (_e357.member_1[0][2] - _e357.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[2][0] - _e357.member[1][0]), (_e357.member[2][1] - _e357.member[1][1]), (_e357.member[2][2] - _e357.member[1][2])), array<f64, 3>((_e357.member_1[2][0] - _e357.member_1[1][0]), (_e357.member_1[2][1] - _e357.member_1[1][1]), (_e357.member_1[2][2] - _e357.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[3][0] - _e357.member[1][0]), (_e357.member[3][1] - _e357.member[1][1]), (_e357.member[3][2] - _e357.member[1][2])), array<f64, 3>((_e357.member_1[3][0] - _e357.member_1[1][0]), (_e357.member_1[3][1] - _e357.member_1[1][1]), (_e357.member_1[3][2] - _e357.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e516 = phi_1084_;
                let _e518 = params.member.member.member_14;
                let _e525 = bitcast<f64>(((u64(_e518[1]) * 4294967296lu) + u64(_e518[0])));
                let _e527 = params.member.member.member_15;
                let _e534 = bitcast<f64>(((u64(_e527[1]) * 4294967296lu) + u64(_e527[0])));
                let _e536 = params.member.member.member_16;
                let _e543 = bitcast<f64>(((u64(_e536[1]) * 4294967296lu) + u64(_e536[0])));
                let _e545 = params.member.member.member_16;
                let _e552 = bitcast<f64>(((u64(_e545[1]) * 4294967296lu) + u64(_e545[0])));
                let _e553 = f64(0f);
                let _e559 = select(_e516.member[0][0], -(_e516.member[0][0]), (_e516.member[0][0] < 0.0lf));
                let _e563 = select(_e516.member[0][1], -(_e516.member[0][1]), (_e516.member[0][1] < 0.0lf));
                let _e565 = select(_e563, _e559, (_e559 > _e563));
                let _e569 = select(_e516.member[0][2], -(_e516.member[0][2]), (_e516.member[0][2] < 0.0lf));
                let _e571 = select(_e569, _e565, (_e565 > _e569));
                let _e577 = select(_e516.member[1][0], -(_e516.member[1][0]), (_e516.member[1][0] < 0.0lf));
                let _e581 = select(_e516.member[1][1], -(_e516.member[1][1]), (_e516.member[1][1] < 0.0lf));
                let _e583 = select(_e581, _e577, (_e577 > _e581));
                let _e587 = select(_e516.member[1][2], -(_e516.member[1][2]), (_e516.member[1][2] < 0.0lf));
                let _e589 = select(_e587, _e583, (_e583 > _e587));
                let _e593 = (select(_e589, _e571, (_e571 > _e589)) + _e516.member_3);
                let _e599 = select(_e516.member_1[0][0], -(_e516.member_1[0][0]), (_e516.member_1[0][0] < 0.0lf));
                let _e603 = select(_e516.member_1[0][1], -(_e516.member_1[0][1]), (_e516.member_1[0][1] < 0.0lf));
                let _e605 = select(_e603, _e599, (_e599 > _e603));
                let _e609 = select(_e516.member_1[0][2], -(_e516.member_1[0][2]), (_e516.member_1[0][2] < 0.0lf));
                let _e611 = select(_e609, _e605, (_e605 > _e609));
                let _e617 = select(_e516.member_1[1][0], -(_e516.member_1[1][0]), (_e516.member_1[1][0] < 0.0lf));
                let _e621 = select(_e516.member_1[1][1], -(_e516.member_1[1][1]), (_e516.member_1[1][1] < 0.0lf));
                let _e623 = select(_e621, _e617, (_e617 > _e621));
                let _e627 = select(_e516.member_1[1][2], -(_e516.member_1[1][2]), (_e516.member_1[1][2] < 0.0lf));
                let _e629 = select(_e627, _e623, (_e623 > _e627));
                let _e633 = (select(_e629, _e611, (_e611 > _e629)) + _e516.member_3);
                let _e639 = select(_e516.member_2[0][0], -(_e516.member_2[0][0]), (_e516.member_2[0][0] < 0.0lf));
                let _e643 = select(_e516.member_2[0][1], -(_e516.member_2[0][1]), (_e516.member_2[0][1] < 0.0lf));
                let _e645 = select(_e643, _e639, (_e639 > _e643));
                let _e649 = select(_e516.member_2[0][2], -(_e516.member_2[0][2]), (_e516.member_2[0][2] < 0.0lf));
                let _e651 = select(_e649, _e645, (_e645 > _e649));
                let _e657 = select(_e516.member_2[1][0], -(_e516.member_2[1][0]), (_e516.member_2[1][0] < 0.0lf));
                let _e661 = select(_e516.member_2[1][1], -(_e516.member_2[1][1]), (_e516.member_2[1][1] < 0.0lf));
                let _e663 = select(_e661, _e657, (_e657 > _e661));
                let _e667 = select(_e516.member_2[1][2], -(_e516.member_2[1][2]), (_e516.member_2[1][2] < 0.0lf));
                let _e669 = select(_e667, _e663, (_e663 > _e667));
                let _e673 = (select(_e669, _e651, (_e651 > _e669)) + _e516.member_3);
                let _e675 = select(_e633, _e593, (_e593 > _e633));
                let _e677 = select(_e673, _e675, (_e675 > _e673));
                let _e683 = select(_e516.member[0][0], -(_e516.member[0][0]), (_e516.member[0][0] < 0.0lf));
                let _e687 = select(_e516.member[0][1], -(_e516.member[0][1]), (_e516.member[0][1] < 0.0lf));
                let _e689 = select(_e687, _e683, (_e683 > _e687));
                let _e693 = select(_e516.member[0][2], -(_e516.member[0][2]), (_e516.member[0][2] < 0.0lf));
                let _e695 = select(_e693, _e689, (_e689 > _e693));
                let _e701 = select(_e516.member[1][0], -(_e516.member[1][0]), (_e516.member[1][0] < 0.0lf));
                let _e705 = select(_e516.member[1][1], -(_e516.member[1][1]), (_e516.member[1][1] < 0.0lf));
                let _e707 = select(_e705, _e701, (_e701 > _e705));
                let _e711 = select(_e516.member[1][2], -(_e516.member[1][2]), (_e516.member[1][2] < 0.0lf));
                let _e713 = select(_e711, _e707, (_e707 > _e711));
                let _e717 = (select(_e713, _e695, (_e695 > _e713)) + _e516.member_3);
                let _e723 = select(_e516.member_1[0][0], -(_e516.member_1[0][0]), (_e516.member_1[0][0] < 0.0lf));
                let _e727 = select(_e516.member_1[0][1], -(_e516.member_1[0][1]), (_e516.member_1[0][1] < 0.0lf));
                let _e729 = select(_e727, _e723, (_e723 > _e727));
                let _e733 = select(_e516.member_1[0][2], -(_e516.member_1[0][2]), (_e516.member_1[0][2] < 0.0lf));
                let _e735 = select(_e733, _e729, (_e729 > _e733));
                let _e741 = select(_e516.member_1[1][0], -(_e516.member_1[1][0]), (_e516.member_1[1][0] < 0.0lf));
                let _e745 = select(_e516.member_1[1][1], -(_e516.member_1[1][1]), (_e516.member_1[1][1] < 0.0lf));
                let _e747 = select(_e745, _e741, (_e741 > _e745));
                let _e751 = select(_e516.member_1[1][2], -(_e516.member_1[1][2]), (_e516.member_1[1][2] < 0.0lf));
                let _e753 = select(_e751, _e747, (_e747 > _e751));
                let _e757 = (select(_e753, _e735, (_e735 > _e753)) + _e516.member_3);
                let _e763 = select(_e516.member_2[0][0], -(_e516.member_2[0][0]), (_e516.member_2[0][0] < 0.0lf));
                let _e767 = select(_e516.member_2[0][1], -(_e516.member_2[0][1]), (_e516.member_2[0][1] < 0.0lf));
                let _e769 = select(_e767, _e763, (_e763 > _e767));
                let _e773 = select(_e516.member_2[0][2], -(_e516.member_2[0][2]), (_e516.member_2[0][2] < 0.0lf));
                let _e775 = select(_e773, _e769, (_e769 > _e773));
                let _e781 = select(_e516.member_2[1][0], -(_e516.member_2[1][0]), (_e516.member_2[1][0] < 0.0lf));
                let _e785 = select(_e516.member_2[1][1], -(_e516.member_2[1][1]), (_e516.member_2[1][1] < 0.0lf));
                let _e787 = select(_e785, _e781, (_e781 > _e785));
                let _e791 = select(_e516.member_2[1][2], -(_e516.member_2[1][2]), (_e516.member_2[1][2] < 0.0lf));
                let _e793 = select(_e791, _e787, (_e787 > _e791));
                let _e797 = (select(_e793, _e775, (_e775 > _e793)) + _e516.member_3);
                let _e799 = select(_e757, _e717, (_e717 > _e757));
                let _e801 = select(_e797, _e799, (_e799 > _e797));
                if (_e801 <= f64(65536f)) {
                    phi_1580_ = (_e801 >= f64((1f / 65536f)));
                } else {
                    phi_1580_ = false;
                }
                let _e808 = phi_1580_;
                if _e808 {
                    phi_1680_ = type_41();
                    phi_1681_ = true;
                } else {
                    if (_e677 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e677) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e815 = (9214364837600034816lu - (bitcast<u64>(_e677) & 9218868437227405312lu));
                            let _e818 = bitcast<f64>(select(4503599627370496lu, _e815, (_e815 > 4503599627370496lu)));
                            let _e819 = (_e553 * _e818);
                            phi_1676_ = type_41(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e516.member[0][0] * _e818), (_e516.member[0][1] * _e818), (_e516.member[0][2] * _e818)), array<f64, 3>((_e516.member[1][0] * _e818), (_e516.member[1][1] * _e818), (_e516.member[1][2] * _e818))), array<array<f64, 3>, 2>(array<f64, 3>((_e516.member_1[0][0] * _e818), (_e516.member_1[0][1] * _e818), (_e516.member_1[0][2] * _e818)), array<f64, 3>((_e516.member_1[1][0] * _e818), (_e516.member_1[1][1] * _e818), (_e516.member_1[1][2] * _e818))), array<array<f64, 3>, 2>(array<f64, 3>((_e516.member_2[0][0] * _e818), (_e516.member_2[0][1] * _e818), (_e516.member_2[0][2] * _e818)), array<f64, 3>((_e516.member_2[1][0] * _e818), (_e516.member_2[1][1] * _e818), (_e516.member_2[1][2] * _e818))), ((_e516.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e818)), select(_e819, select(2.2250738585072014e-308lf, _e819, (_e819 > 2.2250738585072014e-308lf)), (_e553 > f64(0f))));
                            phi_1677_ = false;
                        } else {
                            phi_1676_ = type_41();
                            phi_1677_ = true;
                        }
                        let _e890 = phi_1676_;
                        let _e892 = phi_1677_;
                        phi_1678_ = _e890;
                        phi_1679_ = _e892;
                    } else {
                        phi_1678_ = type_41();
                        phi_1679_ = true;
                    }
                    let _e894 = phi_1678_;
                    let _e896 = phi_1679_;
                    phi_1680_ = _e894;
                    phi_1681_ = _e896;
                }
                let _e898 = phi_1680_;
                let _e900 = phi_1681_;
                if _e900 {
                    phi_1686_ = type_41(_e516, _e553);
                } else {
                    phi_1686_ = _e898;
                }
                let _e903 = phi_1686_;
                local_7 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e903.member.member[0][0], _e903.member.member[0][1], _e903.member.member[0][2]), array<f64, 3>(_e903.member.member[1][0], _e903.member.member[1][1], _e903.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e903.member.member_1[0][0], _e903.member.member_1[0][1], _e903.member.member_1[0][2]), array<f64, 3>(_e903.member.member_1[1][0], _e903.member.member_1[1][1], _e903.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e903.member.member_2[0][0], _e903.member.member_2[0][1], _e903.member.member_2[0][2]), array<f64, 3>(_e903.member.member_2[1][0], _e903.member.member_2[1][1], _e903.member.member_2[1][2])), _e903.member.member_3);
                let _e945 = local_7.member_1[0u];
                let _e951 = local_7.member_2[0u];
                let _e957 = ((_e945[1] * _e951[2]) - (_e945[2] * _e951[1]));
                let _e960 = ((_e945[2] * _e951[0]) - (_e945[0] * _e951[2]));
                let _e963 = ((_e945[0] * _e951[1]) - (_e945[1] * _e951[0]));
                let _e966 = local_7.member_1[1u];
                let _e972 = local_7.member_2[1u];
                let _e978 = ((_e966[1] * _e972[2]) - (_e966[2] * _e972[1]));
                let _e981 = ((_e966[2] * _e972[0]) - (_e966[0] * _e972[2]));
                let _e984 = ((_e966[0] * _e972[1]) - (_e966[1] * _e972[0]));
                let _e987 = local_7.member_1[0u];
                let _e993 = local_7.member_2[1u];
                let _e1008 = local_7.member_1[1u];
                let _e1014 = local_7.member_2[0u];
                let _e1027 = (((_e987[1] * _e993[2]) - (_e987[2] * _e993[1])) + ((_e1008[1] * _e1014[2]) - (_e1008[2] * _e1014[1])));
                let _e1028 = (((_e987[2] * _e993[0]) - (_e987[0] * _e993[2])) + ((_e1008[2] * _e1014[0]) - (_e1008[0] * _e1014[2])));
                let _e1029 = (((_e987[0] * _e993[1]) - (_e987[1] * _e993[0])) + ((_e1008[0] * _e1014[1]) - (_e1008[1] * _e1014[0])));
                let _e1032 = local_7.member[0u];
                let _e1040 = (((_e1032[0] * _e957) + (_e1032[1] * _e960)) + (_e1032[2] * _e963));
                let _e1043 = local_7.member[1u];
                let _e1054 = local_7.member[0u];
                let _e1063 = ((((_e1043[0] * _e957) + (_e1043[1] * _e960)) + (_e1043[2] * _e963)) + (((_e1054[0] * _e1027) + (_e1054[1] * _e1028)) + (_e1054[2] * _e1029)));
                let _e1066 = local_7.member[0u];
                let _e1077 = local_7.member[1u];
                let _e1086 = ((((_e1066[0] * _e978) + (_e1066[1] * _e981)) + (_e1066[2] * _e984)) + (((_e1077[0] * _e1027) + (_e1077[1] * _e1028)) + (_e1077[2] * _e1029)));
                let _e1089 = local_7.member[1u];
                let _e1097 = (((_e1089[0] * _e978) + (_e1089[1] * _e981)) + (_e1089[2] * _e984));
                let _e1100 = local_7.member[0u];
                let _e1106 = select(_e1100[0], -(_e1100[0]), (_e1100[0] < 0.0lf));
                let _e1109 = select(_e1100[1], -(_e1100[1]), (_e1100[1] < 0.0lf));
                let _e1111 = select(_e1109, _e1106, (_e1106 > _e1109));
                let _e1114 = select(_e1100[2], -(_e1100[2]), (_e1100[2] < 0.0lf));
                let _e1116 = select(_e1114, _e1111, (_e1111 > _e1114));
                let _e1119 = local_7.member[1u];
                let _e1125 = select(_e1119[0], -(_e1119[0]), (_e1119[0] < 0.0lf));
                let _e1128 = select(_e1119[1], -(_e1119[1]), (_e1119[1] < 0.0lf));
                let _e1130 = select(_e1128, _e1125, (_e1125 > _e1128));
                let _e1133 = select(_e1119[2], -(_e1119[2]), (_e1119[2] < 0.0lf));
                let _e1135 = select(_e1133, _e1130, (_e1130 > _e1133));
                let _e1139 = local_7.member_3;
                let _e1140 = (select(_e1135, _e1116, (_e1116 > _e1135)) + _e1139);
                let _e1143 = local_7.member_1[0u];
                let _e1149 = select(_e1143[0], -(_e1143[0]), (_e1143[0] < 0.0lf));
                let _e1152 = select(_e1143[1], -(_e1143[1]), (_e1143[1] < 0.0lf));
                let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
                let _e1157 = select(_e1143[2], -(_e1143[2]), (_e1143[2] < 0.0lf));
                let _e1159 = select(_e1157, _e1154, (_e1154 > _e1157));
                let _e1162 = local_7.member_1[1u];
                let _e1168 = select(_e1162[0], -(_e1162[0]), (_e1162[0] < 0.0lf));
                let _e1171 = select(_e1162[1], -(_e1162[1]), (_e1162[1] < 0.0lf));
                let _e1173 = select(_e1171, _e1168, (_e1168 > _e1171));
                let _e1176 = select(_e1162[2], -(_e1162[2]), (_e1162[2] < 0.0lf));
                let _e1178 = select(_e1176, _e1173, (_e1173 > _e1176));
                let _e1182 = local_7.member_3;
                let _e1183 = (select(_e1178, _e1159, (_e1159 > _e1178)) + _e1182);
                let _e1186 = local_7.member_2[0u];
                let _e1192 = select(_e1186[0], -(_e1186[0]), (_e1186[0] < 0.0lf));
                let _e1195 = select(_e1186[1], -(_e1186[1]), (_e1186[1] < 0.0lf));
                let _e1197 = select(_e1195, _e1192, (_e1192 > _e1195));
                let _e1200 = select(_e1186[2], -(_e1186[2]), (_e1186[2] < 0.0lf));
                let _e1202 = select(_e1200, _e1197, (_e1197 > _e1200));
                let _e1205 = local_7.member_2[1u];
                let _e1211 = select(_e1205[0], -(_e1205[0]), (_e1205[0] < 0.0lf));
                let _e1214 = select(_e1205[1], -(_e1205[1]), (_e1205[1] < 0.0lf));
                let _e1216 = select(_e1214, _e1211, (_e1211 > _e1214));
                let _e1219 = select(_e1205[2], -(_e1205[2]), (_e1205[2] < 0.0lf));
                let _e1221 = select(_e1219, _e1216, (_e1216 > _e1219));
                let _e1225 = local_7.member_3;
                let _e1226 = (select(_e1221, _e1202, (_e1202 > _e1221)) + _e1225);
                let _e1227 = f64(1f);
                let _e1228 = f64(8f);
                let _e1238 = local_7.member_3;
                let _e1255 = (((((_e1140 * _e1228) * ((_e1183 * _e1228) * _e1226)) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1238 * f64(19f)) * ((_e1140 * (_e1183 + _e1226)) + (_e1183 * _e1226)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1227 + _e1140) * ((_e1227 + _e1183) * (_e1227 + _e1226)))));
                let _e1256 = f64(0f);
                let _e1257 = f64(3f);
                let _e1258 = (_e1040 * _e1257);
                let _e1259 = (_e1097 * _e1257);
                let _e1261 = select(_e1259, _e1258, (_e1258 < _e1259));
                let _e1263 = select(_e1086, _e1063, (_e1063 < _e1086));
                let _e1265 = select(_e1263, _e1261, (_e1261 < _e1263));
                let _e1267 = select(_e1259, _e1258, (_e1258 > _e1259));
                let _e1269 = select(_e1086, _e1063, (_e1063 > _e1086));
                let _e1272 = -(select(_e1269, _e1267, (_e1267 > _e1269)));
                if (select(_e1272, _e1265, (_e1265 > _e1272)) > _e1255) {
                    phi_6983_ = type_42(0u, type_42().member_1);
                    phi_6984_ = type_42();
                    phi_6985_ = true;
                } else {
                    let _e1280 = select(_e1040, -(_e1040), (_e1040 < 0.0lf));
                    let _e1283 = select(_e1063, -(_e1063), (_e1063 < 0.0lf));
                    let _e1285 = select(_e1283, _e1280, (_e1280 > _e1283));
                    let _e1288 = select(_e1086, -(_e1086), (_e1086 < 0.0lf));
                    let _e1291 = select(_e1097, -(_e1097), (_e1097 < 0.0lf));
                    let _e1293 = select(_e1291, _e1288, (_e1288 > _e1291));
                    let _e1295 = select(_e1293, _e1285, (_e1285 > _e1293));
                    let _e1297 = (2.2250738585072014e-308lf * f64(67108864f));
                    let _e1298 = f64(1f);
                    if (_e1295 >= _e1297) {
                        phi_2388_ = (_e1295 <= (_e1298 / _e1297));
                    } else {
                        phi_2388_ = false;
                    }
                    let _e1303 = phi_2388_;
                    if _e1303 {
                        phi_2403_ = (_e1298 / _e1295);
                    } else {
                        phi_2403_ = f64(0f);
                    }
                    let _e1313 = phi_2403_;
                    let _e1314 = f64(0.00000000000022737368f);
                    let _e1316 = (_e525 * f64(0.0625f));
                    local_5 = type_39(array<f64, 4>(_e1040, _e1063, _e1086, _e1097), ((_e1255 * f64(0.34f)) + (_e1295 * select(f64(2f), (1.1102230246251565e-16lf * f64(256f)), _e1303))), _e1313, select(_e1316, _e1314, (_e1314 < _e1316)));
                    let _e1321 = f64(0f);
                    let _e1322 = f64(1f);
                    let _e1323 = f64(3f);
                    let _e1326 = local_5.member[0u];
                    let _e1329 = local_5.member[1u];
                    let _e1332 = local_5.member[2u];
                    let _e1335 = local_5.member[3u];
                    let _e1342 = local_5.member_2;
                    let _e1343 = ((_e1329 - (_e1323 * _e1326)) * _e1342);
                    let _e1345 = local_5.member_2;
                    let _e1346 = ((_e1332 - _e1329) * _e1345);
                    let _e1348 = local_5.member_2;
                    let _e1349 = (((_e1323 * _e1335) - _e1332) * _e1348);
                    local_3[0u] = _e1321;
                    local_3[1u] = _e1322;
                    local_3[2u] = _e1322;
                    local_3[3u] = _e1322;
                    let _e1356 = ((_e1346 * _e1346) - (_e1343 * _e1349));
                    if (_e1356 > _e1321) {
                        if (_e1356 <= 2.2250738585072014e-308lf) {
                            phi_2536_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1356 > 0.0lf));
                        } else {
                            phi_2479_ = type_16(0i, 5i);
                            phi_2482_ = bitcast<f64>(((bitcast<u64>(_e1356) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1364 = phi_2479_;
                                let _e1366 = phi_2482_;
                                local_9 = _e1366;
                                if (_e1364.member < _e1364.member_1) {
                                    let _e1373 = (_e1364.member + 1i);
                                    phi_2480_ = type_16(select(_e1373, type_17().member_1, select(false, true, ((false == (_e1373 > _e1364.member)) != false))), _e1364.member_1);
                                    phi_2523_ = type_17(1u, _e1364.member);
                                } else {
                                    phi_2480_ = _e1364;
                                    phi_2523_ = type_17(0u, type_17().member_1);
                                }
                                let _e1384 = phi_2480_;
                                let _e1386 = phi_2523_;
                                let _e1389 = (bitcast<i32>(_e1386.member) != 0i);
                                if _e1389 {
                                    phi_2483_ = (0.5lf * (_e1366 + (_e1356 / _e1366)));
                                } else {
                                    phi_2483_ = f64();
                                }
                                let _e1394 = phi_2483_;
                                continue;
                                continuing {
                                    phi_2479_ = _e1384;
                                    phi_2482_ = _e1394;
                                    break if !(_e1389);
                                }
                            }
                            let _e1399 = local_9;
                            phi_2536_ = (_e1399 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1405 = phi_2536_;
                        let _e1410 = -((_e1346 + select(_e1405, -(_e1405), (_e1346 < _e1321))));
                        local_4[0u] = (_e1410 / (_e1410 + _e1349));
                        local_4[1u] = (_e1343 / (_e1343 + _e1410));
                        let _e1419 = local_4[1u];
                        let _e1420 = local_4[0u];
                        if (_e1419 < _e1420) {
                            let _e1423 = local_4[1u];
                            let _e1425 = local_4[0u];
                            local_4[0u] = _e1423;
                            local_4[1u] = _e1425;
                        }
                        phi_2567_ = type_9(0u, 2u);
                        phi_2570_ = 1u;
                        loop {
                            let _e1429 = phi_2567_;
                            let _e1431 = phi_2570_;
                            local_45 = _e1431;
                            let _e1434 = (_e1429.member < _e1429.member_1);
                            let _e1445 = select(type_9().member_1, _e1429.member, _e1434);
                            let _e1447 = (bitcast<i32>(select(0u, 1u, _e1434)) != 0i);
                            if _e1447 {
                                let _e1449 = local_4[_e1445];
                                if (_e1449 > _e1321) {
                                    let _e1452 = local_4[_e1445];
                                    if (_e1452 < _e1322) {
                                        let _e1455 = local_4[_e1445];
                                        local_3[_e1431] = _e1455;
                                        phi_2637_ = (_e1431 + 1u);
                                    } else {
                                        phi_2637_ = _e1431;
                                    }
                                    let _e1459 = phi_2637_;
                                    phi_2638_ = _e1459;
                                } else {
                                    phi_2638_ = _e1431;
                                }
                                let _e1461 = phi_2638_;
                                phi_2571_ = _e1461;
                            } else {
                                phi_2571_ = u32();
                            }
                            let _e1463 = phi_2571_;
                            continue;
                            continuing {
                                phi_2567_ = type_9(select(_e1429.member, (_e1429.member + 1u), _e1434), select(_e1429.member_1, _e1429.member_1, _e1434));
                                phi_2570_ = _e1463;
                                break if !(_e1447);
                            }
                        }
                        let _e4484 = local_45;
                        phi_2639_ = _e4484;
                    } else {
                        phi_2639_ = 1u;
                    }
                    let _e1466 = phi_2639_;
                    local_3[_e1466] = _e1322;
                    let _e1468 = local_3;
                    local_6 = _e1468;
                    let _e1470 = (_e525 * f64(0.99f));
                    let _e1472 = (f64(1f) - _e534);
                    let _e1475 = local_5.member[0u];
                    let _e1478 = local_5.member[1u];
                    let _e1481 = local_5.member[2u];
                    let _e1484 = local_5.member[3u];
                    let _e1495 = ((((_e1475 * _e1472) + (_e1478 * _e534)) * (_e1472 * _e1472)) + (((_e1481 * _e1472) + (_e1484 * _e534)) * (_e534 * _e534)));
                    let _e1500 = local_5.member_1;
                    phi_2697_ = type_9(select(1u, 0u, !((select(_e1495, -(_e1495), (_e1495 < 0.0lf)) > _e1500))), (_e1466 + 1u));
                    loop {
                        let _e1507 = phi_2697_;
                        let _e1510 = (_e1507.member < _e1507.member_1);
                        let _e1521 = select(type_9().member_1, _e1507.member, _e1510);
                        if (bitcast<i32>(select(0u, 1u, _e1510)) != 0i) {
                            if (_e1521 > 0u) {
                                let _e1528 = local_6[(_e1521 - 1u)];
                                let _e1530 = select(_e534, _e1528, (_e1528 > _e534));
                                let _e1532 = local_6[_e1521];
                                let _e1534 = select(_e543, _e1532, (_e1532 < _e543));
                                if (_e1530 <= _e1534) {
                                    let _e1536 = function_1((&local_5), _e552, _e1530, _e1534);
                                    if _e1536 {
                                        phi_4139_ = type_43();
                                        phi_4140_ = bool();
                                        phi_4141_ = type_43();
                                        phi_4142_ = false;
                                        phi_4143_ = false;
                                        phi_4144_ = false;
                                        phi_4145_ = false;
                                    } else {
                                        let _e1538 = (f64(1f) - _e1530);
                                        let _e1541 = local_5.member[0u];
                                        let _e1544 = local_5.member[1u];
                                        let _e1547 = local_5.member[2u];
                                        let _e1550 = local_5.member[3u];
                                        let _e1561 = ((((_e1541 * _e1538) + (_e1544 * _e1530)) * (_e1538 * _e1538)) + (((_e1547 * _e1538) + (_e1550 * _e1530)) * (_e1530 * _e1530)));
                                        let _e1563 = (f64(1f) - _e1534);
                                        let _e1566 = local_5.member[0u];
                                        let _e1569 = local_5.member[1u];
                                        let _e1572 = local_5.member[2u];
                                        let _e1575 = local_5.member[3u];
                                        let _e1586 = ((((_e1566 * _e1563) + (_e1569 * _e1534)) * (_e1563 * _e1563)) + (((_e1572 * _e1563) + (_e1575 * _e1534)) * (_e1534 * _e1534)));
                                        let _e1591 = local_5.member_1;
                                        let _e1592 = (select(_e1561, -(_e1561), (_e1561 < 0.0lf)) > _e1591);
                                        let _e1597 = local_5.member_1;
                                        let _e1598 = (select(_e1586, -(_e1586), (_e1586 < 0.0lf)) > _e1597);
                                        let _e1599 = f64(0f);
                                        let _e1607 = select(select(bool(), select(bool(), ((_e1561 > _e1599) != (_e1586 > _e1599)), _e1598), _e1592), false, select(true, select(true, false, _e1598), _e1592));
                                        if _e1592 {
                                            if _e1598 {
                                                phi_2857_ = type_43(select(f64(1f), type_43().member, _e1607), select(_e1599, type_43().member_1, _e1607), select(_e1607, type_43().member_2, _e1607));
                                                phi_2858_ = _e1607;
                                            } else {
                                                phi_2857_ = type_43();
                                                phi_2858_ = true;
                                            }
                                            let _e1617 = phi_2857_;
                                            let _e1619 = phi_2858_;
                                            phi_2859_ = _e1617;
                                            phi_2860_ = _e1619;
                                        } else {
                                            phi_2859_ = type_43();
                                            phi_2860_ = true;
                                        }
                                        let _e1621 = phi_2859_;
                                        let _e1623 = phi_2860_;
                                        if _e1623 {
                                            if _e1592 {
                                                let _e1627 = select(f64(1f), f64(-1f), (_e1561 < _e1599));
                                                let _e1629 = local_5.member_3;
                                                let _e1630 = f64(0.5f);
                                                let _e1631 = f64(3f);
                                                let _e1634 = local_5.member[0u];
                                                let _e1637 = local_5.member[1u];
                                                let _e1640 = local_5.member[2u];
                                                let _e1643 = local_5.member[3u];
                                                let _e1646 = (_e1640 - _e1637);
                                                phi_2895_ = type_9(0u, 64u);
                                                phi_2898_ = _e1534;
                                                phi_2900_ = _e1530;
                                                phi_2902_ = (_e1630 * (_e1530 + _e1534));
                                                loop {
                                                    let _e1652 = phi_2895_;
                                                    let _e1654 = phi_2898_;
                                                    let _e1656 = phi_2900_;
                                                    let _e1658 = phi_2902_;
                                                    local_12 = _e1656;
                                                    let _e1661 = (_e1652.member < _e1652.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1661)) != 0i) {
                                                        let _e1674 = (f64(1f) - _e1658);
                                                        let _e1677 = local_5.member[0u];
                                                        let _e1680 = local_5.member[1u];
                                                        let _e1683 = local_5.member[2u];
                                                        let _e1686 = local_5.member[3u];
                                                        let _e1700 = local_5.member_1;
                                                        let _e1701 = ((_e1627 * ((((_e1677 * _e1674) + (_e1680 * _e1658)) * (_e1674 * _e1674)) + (((_e1683 * _e1674) + (_e1686 * _e1658)) * (_e1658 * _e1658)))) - _e1700);
                                                        let _e1703 = (_e1701 > f64(0f));
                                                        let _e1704 = select(_e1658, _e1654, _e1703);
                                                        let _e1705 = select(_e1656, _e1658, _e1703);
                                                        let _e1707 = ((_e1704 - _e1705) > _e1629);
                                                        if _e1707 {
                                                            let _e1709 = (f64(1f) - _e1658);
                                                            let _e1721 = (-(_e1701) / (_e1627 * (((((_e1637 - (_e1631 * _e1634)) * _e1709) + (_e1646 * _e1658)) * _e1709) + (((_e1646 * _e1709) + (((_e1631 * _e1643) - _e1640) * _e1658)) * _e1658))));
                                                            let _e1729 = ((_e1658 + _e1721) + select(-((_e1630 * _e1629)), (_e1630 * _e1629), (_e1701 > f64(0f))));
                                                            if (_e1729 > _e1705) {
                                                                phi_3016_ = select(true, select(true, false, (select(_e1721, -(_e1721), (_e1721 < 0.0lf)) < (_e1630 * (_e1704 - _e1705)))), (_e1729 < _e1704));
                                                            } else {
                                                                phi_3016_ = true;
                                                            }
                                                            let _e1741 = phi_3016_;
                                                            phi_3023_ = select(_e1729, (_e1630 * (_e1705 + _e1704)), _e1741);
                                                            phi_3024_ = false;
                                                        } else {
                                                            phi_3023_ = f64();
                                                            phi_3024_ = true;
                                                        }
                                                        let _e1746 = phi_3023_;
                                                        let _e1748 = phi_3024_;
                                                        phi_2899_ = _e1704;
                                                        phi_2901_ = _e1705;
                                                        phi_2903_ = _e1746;
                                                        phi_3025_ = _e1705;
                                                        phi_3026_ = _e1707;
                                                        phi_3027_ = _e1748;
                                                    } else {
                                                        phi_2899_ = f64();
                                                        phi_2901_ = f64();
                                                        phi_2903_ = f64();
                                                        phi_3025_ = f64();
                                                        phi_3026_ = false;
                                                        phi_3027_ = false;
                                                    }
                                                    let _e1750 = phi_2899_;
                                                    let _e1752 = phi_2901_;
                                                    let _e1754 = phi_2903_;
                                                    let _e1756 = phi_3025_;
                                                    let _e1758 = phi_3026_;
                                                    let _e1760 = phi_3027_;
                                                    local_10 = _e1760;
                                                    local_11 = _e1756;
                                                    continue;
                                                    continuing {
                                                        phi_2895_ = type_9(select(_e1652.member, (_e1652.member + 1u), _e1661), select(_e1652.member_1, _e1652.member_1, _e1661));
                                                        phi_2898_ = _e1750;
                                                        phi_2900_ = _e1752;
                                                        phi_2902_ = _e1754;
                                                        break if !(_e1758);
                                                    }
                                                }
                                                let _e1763 = local_10;
                                                let _e1765 = local_11;
                                                let _e1767 = local_12;
                                                phi_3032_ = select(_e1767, _e1765, _e1763);
                                            } else {
                                                phi_3032_ = _e1530;
                                            }
                                            let _e1770 = phi_3032_;
                                            if _e1598 {
                                                let _e1776 = local_5.member_3;
                                                let _e1778 = local_5.member_3;
                                                phi_3050_ = type_9(0u, 64u);
                                                phi_3053_ = (_e1776 + _e1778);
                                                loop {
                                                    let _e1781 = phi_3050_;
                                                    let _e1783 = phi_3053_;
                                                    let _e1786 = (_e1781.member < _e1781.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1786)) != 0i) {
                                                        let _e1798 = (_e1770 + _e1783);
                                                        if (_e1798 < _e1534) {
                                                            let _e1801 = (f64(1f) - _e1798);
                                                            let _e1804 = local_5.member[0u];
                                                            let _e1807 = local_5.member[1u];
                                                            let _e1810 = local_5.member[2u];
                                                            let _e1813 = local_5.member[3u];
                                                            let _e1827 = local_5.member_1;
                                                            let _e1828 = ((select(f64(1f), f64(-1f), (_e1586 < _e1599)) * ((((_e1804 * _e1801) + (_e1807 * _e1798)) * (_e1801 * _e1801)) + (((_e1810 * _e1801) + (_e1813 * _e1798)) * (_e1798 * _e1798)))) > _e1827);
                                                            phi_3119_ = select((_e1783 + _e1783), f64(), _e1828);
                                                            phi_3120_ = select(true, false, _e1828);
                                                            phi_3121_ = _e1828;
                                                            phi_3122_ = false;
                                                        } else {
                                                            phi_3119_ = f64();
                                                            phi_3120_ = false;
                                                            phi_3121_ = false;
                                                            phi_3122_ = true;
                                                        }
                                                        let _e1833 = phi_3119_;
                                                        let _e1835 = phi_3120_;
                                                        let _e1837 = phi_3121_;
                                                        let _e1839 = phi_3122_;
                                                        phi_3123_ = _e1798;
                                                        phi_3054_ = _e1833;
                                                        phi_3124_ = _e1835;
                                                        phi_3125_ = _e1837;
                                                        phi_3126_ = _e1839;
                                                        phi_3127_ = false;
                                                    } else {
                                                        phi_3123_ = f64();
                                                        phi_3054_ = f64();
                                                        phi_3124_ = false;
                                                        phi_3125_ = false;
                                                        phi_3126_ = false;
                                                        phi_3127_ = true;
                                                    }
                                                    let _e1841 = phi_3123_;
                                                    let _e1843 = phi_3054_;
                                                    let _e1845 = phi_3124_;
                                                    let _e1847 = phi_3125_;
                                                    let _e1849 = phi_3126_;
                                                    let _e1851 = phi_3127_;
                                                    local_13 = _e1847;
                                                    local_14 = _e1849;
                                                    local_15 = _e1847;
                                                    local_16 = _e1851;
                                                    local_17 = _e1841;
                                                    continue;
                                                    continuing {
                                                        phi_3050_ = type_9(select(_e1781.member, (_e1781.member + 1u), _e1786), select(_e1781.member_1, _e1781.member_1, _e1786));
                                                        phi_3053_ = _e1843;
                                                        break if !(_e1845);
                                                    }
                                                }
                                                let _e1854 = local_13;
                                                let _e1856 = local_14;
                                                let _e1859 = local_15;
                                                let _e1861 = local_16;
                                                let _e1865 = local_17;
                                                phi_3141_ = select(_e1865, _e1534, select(select(_e1861, false, _e1859), true, select(_e1856, false, _e1854)));
                                            } else {
                                                phi_3141_ = _e1534;
                                            }
                                            let _e1868 = phi_3141_;
                                            phi_3143_ = type_43(_e1770, _e1868, _e1607);
                                        } else {
                                            phi_3143_ = _e1621;
                                        }
                                        let _e1871 = phi_3143_;
                                        if (_e1871.member > _e1871.member_1) {
                                            phi_4134_ = bool();
                                            phi_4135_ = true;
                                            phi_4136_ = false;
                                            phi_4137_ = false;
                                            phi_4138_ = false;
                                        } else {
                                            let _e1876 = (_e1871.member > _e552);
                                            if _e1876 {
                                                phi_4130_ = bool();
                                                phi_4131_ = false;
                                                phi_4132_ = false;
                                                phi_4133_ = false;
                                            } else {
                                                let _e1881 = ((_e1871.member_1 - _e1871.member) * f64(0.5f));
                                                let _e1882 = (_e1871.member + _e1881);
                                                let _e1885 = (_e1881 + (1.1102230246251565e-16lf * f64(4f)));
                                                let _e1887 = local_7.member_3;
                                                let _e1890 = local_7.member[0u];
                                                let _e1896 = select(_e1890[0], -(_e1890[0]), (_e1890[0] < 0.0lf));
                                                let _e1899 = select(_e1890[1], -(_e1890[1]), (_e1890[1] < 0.0lf));
                                                let _e1901 = select(_e1899, _e1896, (_e1896 > _e1899));
                                                let _e1904 = select(_e1890[2], -(_e1890[2]), (_e1890[2] < 0.0lf));
                                                let _e1906 = select(_e1904, _e1901, (_e1901 > _e1904));
                                                let _e1908 = local_7.member[1u];
                                                let _e1914 = select(_e1908[0], -(_e1908[0]), (_e1908[0] < 0.0lf));
                                                let _e1917 = select(_e1908[1], -(_e1908[1]), (_e1908[1] < 0.0lf));
                                                let _e1919 = select(_e1917, _e1914, (_e1914 > _e1917));
                                                let _e1922 = select(_e1908[2], -(_e1908[2]), (_e1908[2] < 0.0lf));
                                                let _e1924 = select(_e1922, _e1919, (_e1919 > _e1922));
                                                let _e1929 = local_7.member[0u];
                                                let _e1934 = local_7.member[1u];
                                                let _e1944 = (_e1929[0] + ((_e1934[0] - _e1929[0]) * _e1882));
                                                let _e1945 = (_e1929[1] + ((_e1934[1] - _e1929[1]) * _e1882));
                                                let _e1946 = (_e1929[2] + ((_e1934[2] - _e1929[2]) * _e1882));
                                                let _e1948 = local_7.member[1u];
                                                let _e1953 = local_7.member[0u];
                                                let _e1957 = (_e1948[0] - _e1953[0]);
                                                let _e1958 = (_e1948[1] - _e1953[1]);
                                                let _e1959 = (_e1948[2] - _e1953[2]);
                                                let _e1962 = select(_e1957, -(_e1957), (_e1957 < 0.0lf));
                                                let _e1965 = select(_e1958, -(_e1958), (_e1958 < 0.0lf));
                                                let _e1967 = select(_e1965, _e1962, (_e1962 > _e1965));
                                                let _e1970 = select(_e1959, -(_e1959), (_e1959 < 0.0lf));
                                                let _e1980 = ((((_e1885 * select(_e1970, _e1967, (_e1967 > _e1970))) * f64(1.01f)) + ((select(_e1924, _e1906, (_e1906 > _e1924)) + _e1887) * (1.1102230246251565e-16lf * f64(8f)))) + _e1887);
                                                let _e1983 = select(_e1944, -(_e1944), (_e1944 < 0.0lf));
                                                let _e1986 = select(_e1945, -(_e1945), (_e1945 < 0.0lf));
                                                let _e1988 = select(_e1986, _e1983, (_e1983 > _e1986));
                                                let _e1991 = select(_e1946, -(_e1946), (_e1946 < 0.0lf));
                                                let _e1994 = (select(_e1991, _e1988, (_e1988 > _e1991)) + _e1980);
                                                let _e1997 = local_7.member_3;
                                                let _e1999 = local_7.member_1[0u];
                                                let _e2005 = select(_e1999[0], -(_e1999[0]), (_e1999[0] < 0.0lf));
                                                let _e2008 = select(_e1999[1], -(_e1999[1]), (_e1999[1] < 0.0lf));
                                                let _e2010 = select(_e2008, _e2005, (_e2005 > _e2008));
                                                let _e2013 = select(_e1999[2], -(_e1999[2]), (_e1999[2] < 0.0lf));
                                                let _e2015 = select(_e2013, _e2010, (_e2010 > _e2013));
                                                let _e2017 = local_7.member_1[1u];
                                                let _e2023 = select(_e2017[0], -(_e2017[0]), (_e2017[0] < 0.0lf));
                                                let _e2026 = select(_e2017[1], -(_e2017[1]), (_e2017[1] < 0.0lf));
                                                let _e2028 = select(_e2026, _e2023, (_e2023 > _e2026));
                                                let _e2031 = select(_e2017[2], -(_e2017[2]), (_e2017[2] < 0.0lf));
                                                let _e2033 = select(_e2031, _e2028, (_e2028 > _e2031));
                                                let _e2038 = local_7.member_1[0u];
                                                let _e2043 = local_7.member_1[1u];
                                                let _e2053 = (_e2038[0] + ((_e2043[0] - _e2038[0]) * _e1882));
                                                let _e2054 = (_e2038[1] + ((_e2043[1] - _e2038[1]) * _e1882));
                                                let _e2055 = (_e2038[2] + ((_e2043[2] - _e2038[2]) * _e1882));
                                                let _e2057 = local_7.member_1[1u];
                                                let _e2062 = local_7.member_1[0u];
                                                let _e2066 = (_e2057[0] - _e2062[0]);
                                                let _e2067 = (_e2057[1] - _e2062[1]);
                                                let _e2068 = (_e2057[2] - _e2062[2]);
                                                let _e2071 = select(_e2066, -(_e2066), (_e2066 < 0.0lf));
                                                let _e2074 = select(_e2067, -(_e2067), (_e2067 < 0.0lf));
                                                let _e2076 = select(_e2074, _e2071, (_e2071 > _e2074));
                                                let _e2079 = select(_e2068, -(_e2068), (_e2068 < 0.0lf));
                                                let _e2089 = ((((_e1885 * select(_e2079, _e2076, (_e2076 > _e2079))) * f64(1.01f)) + ((select(_e2033, _e2015, (_e2015 > _e2033)) + _e1997) * (1.1102230246251565e-16lf * f64(8f)))) + _e1997);
                                                let _e2092 = select(_e2053, -(_e2053), (_e2053 < 0.0lf));
                                                let _e2095 = select(_e2054, -(_e2054), (_e2054 < 0.0lf));
                                                let _e2097 = select(_e2095, _e2092, (_e2092 > _e2095));
                                                let _e2100 = select(_e2055, -(_e2055), (_e2055 < 0.0lf));
                                                let _e2103 = (select(_e2100, _e2097, (_e2097 > _e2100)) + _e2089);
                                                let _e2106 = local_7.member_3;
                                                let _e2108 = local_7.member_2[0u];
                                                let _e2114 = select(_e2108[0], -(_e2108[0]), (_e2108[0] < 0.0lf));
                                                let _e2117 = select(_e2108[1], -(_e2108[1]), (_e2108[1] < 0.0lf));
                                                let _e2119 = select(_e2117, _e2114, (_e2114 > _e2117));
                                                let _e2122 = select(_e2108[2], -(_e2108[2]), (_e2108[2] < 0.0lf));
                                                let _e2124 = select(_e2122, _e2119, (_e2119 > _e2122));
                                                let _e2126 = local_7.member_2[1u];
                                                let _e2132 = select(_e2126[0], -(_e2126[0]), (_e2126[0] < 0.0lf));
                                                let _e2135 = select(_e2126[1], -(_e2126[1]), (_e2126[1] < 0.0lf));
                                                let _e2137 = select(_e2135, _e2132, (_e2132 > _e2135));
                                                let _e2140 = select(_e2126[2], -(_e2126[2]), (_e2126[2] < 0.0lf));
                                                let _e2142 = select(_e2140, _e2137, (_e2137 > _e2140));
                                                let _e2147 = local_7.member_2[0u];
                                                let _e2152 = local_7.member_2[1u];
                                                let _e2162 = (_e2147[0] + ((_e2152[0] - _e2147[0]) * _e1882));
                                                let _e2163 = (_e2147[1] + ((_e2152[1] - _e2147[1]) * _e1882));
                                                let _e2164 = (_e2147[2] + ((_e2152[2] - _e2147[2]) * _e1882));
                                                let _e2166 = local_7.member_2[1u];
                                                let _e2171 = local_7.member_2[0u];
                                                let _e2175 = (_e2166[0] - _e2171[0]);
                                                let _e2176 = (_e2166[1] - _e2171[1]);
                                                let _e2177 = (_e2166[2] - _e2171[2]);
                                                let _e2180 = select(_e2175, -(_e2175), (_e2175 < 0.0lf));
                                                let _e2183 = select(_e2176, -(_e2176), (_e2176 < 0.0lf));
                                                let _e2185 = select(_e2183, _e2180, (_e2180 > _e2183));
                                                let _e2188 = select(_e2177, -(_e2177), (_e2177 < 0.0lf));
                                                let _e2198 = ((((_e1885 * select(_e2188, _e2185, (_e2185 > _e2188))) * f64(1.01f)) + ((select(_e2142, _e2124, (_e2124 > _e2142)) + _e2106) * (1.1102230246251565e-16lf * f64(8f)))) + _e2106);
                                                let _e2201 = select(_e2162, -(_e2162), (_e2162 < 0.0lf));
                                                let _e2204 = select(_e2163, -(_e2163), (_e2163 < 0.0lf));
                                                let _e2206 = select(_e2204, _e2201, (_e2201 > _e2204));
                                                let _e2209 = select(_e2164, -(_e2164), (_e2164 < 0.0lf));
                                                let _e2212 = (select(_e2209, _e2206, (_e2206 > _e2209)) + _e2198);
                                                let _e2215 = ((_e2054 * _e2164) - (_e2055 * _e2163));
                                                let _e2218 = ((_e2055 * _e2162) - (_e2053 * _e2164));
                                                let _e2221 = ((_e2053 * _e2163) - (_e2054 * _e2162));
                                                let _e2236 = select(false, (select(_e2215, -(_e2215), (_e2215 < 0.0lf)) > select(_e2221, -(_e2221), (_e2221 < 0.0lf))), (select(_e2215, -(_e2215), (_e2215 < 0.0lf)) > select(_e2218, -(_e2218), (_e2218 < 0.0lf))));
                                                let _e2251 = select((select(_e2218, -(_e2218), (_e2218 < 0.0lf)) > select(_e2221, -(_e2221), (_e2221 < 0.0lf))), false, (select(_e2215, -(_e2215), (_e2215 < 0.0lf)) > select(_e2218, -(_e2218), (_e2218 < 0.0lf))));
                                                let _e2254 = select(select(_e1944, _e1945, _e2236), _e1946, _e2251);
                                                let _e2255 = select(select(_e1945, _e1946, _e2236), _e1944, _e2251);
                                                let _e2258 = select(select(_e2053, _e2054, _e2236), _e2055, _e2251);
                                                let _e2259 = select(select(_e2054, _e2055, _e2236), _e2053, _e2251);
                                                let _e2262 = select(select(_e2162, _e2163, _e2236), _e2164, _e2251);
                                                let _e2263 = select(select(_e2163, _e2164, _e2236), _e2162, _e2251);
                                                let _e2266 = ((_e2258 * _e2263) - (_e2259 * _e2262));
                                                let _e2267 = f64(1f);
                                                let _e2268 = f64(2f);
                                                let _e2286 = (((((_e2089 * _e2212) + (_e2103 * _e2198)) * f64(2.01f)) + (((_e2103 * _e2268) * (_e2212 * _e2268)) * (1.1102230246251565e-16lf * _e2268))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2267 + _e2103) * (_e2267 + _e2212))));
                                                if (select(_e2266, -(_e2266), (_e2266 < 0.0lf)) > _e2286) {
                                                    let _e2295 = select(f64(1f), f64(-1f), (_e2266 < f64(0f)));
                                                    let _e2299 = f64(1f);
                                                    let _e2300 = f64(2f);
                                                    let _e2318 = (((((_e1980 * _e2212) + (_e1994 * _e2198)) * f64(2.01f)) + (((_e1994 * _e2300) * (_e2212 * _e2300)) * (1.1102230246251565e-16lf * _e2300))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2299 + _e1994) * (_e2299 + _e2212))));
                                                    let _e2322 = f64(1f);
                                                    let _e2323 = f64(2f);
                                                    let _e2341 = (((((_e2089 * _e1994) + (_e2103 * _e1980)) * f64(2.01f)) + (((_e2103 * _e2323) * (_e1994 * _e2323)) * (1.1102230246251565e-16lf * _e2323))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2322 + _e2103) * (_e2322 + _e1994))));
                                                    let _e2342 = (_e2266 * _e2295);
                                                    let _e2343 = (((_e2254 * _e2263) - (_e2255 * _e2262)) * _e2295);
                                                    let _e2344 = (((_e2258 * _e2255) - (_e2259 * _e2254)) * _e2295);
                                                    let _e2358 = (((select(_e2342, -(_e2342), (_e2342 < 0.0lf)) + select(_e2343, -(_e2343), (_e2343 < 0.0lf))) + select(_e2344, -(_e2344), (_e2344 < 0.0lf))) * (1.1102230246251565e-16lf * f64(4f)));
                                                    if (_e231.member != 0u) {
                                                        phi_4004_ = array<type_36, 4>(type_36(_e2343, _e2318), type_36(_e2344, _e2341), type_36((_e2342 - _e2343), ((_e2286 + _e2318) + _e2358)), type_36((_e2342 - _e2344), ((_e2286 + _e2341) + _e2358)));
                                                    } else {
                                                        let _e2361 = ((_e2342 - _e2343) - _e2344);
                                                        let _e2364 = (((_e2286 + _e2318) + _e2341) + _e2358);
                                                        phi_4004_ = array<type_36, 4>(type_36(_e2343, _e2318), type_36(_e2344, _e2341), type_36(_e2361, _e2364), type_36(_e2361, _e2364));
                                                    }
                                                    let _e2382 = phi_4004_;
                                                    local_2 = array<type_36, 4>(type_36(_e2382[0].member, _e2382[0].member_1), type_36(_e2382[1].member, _e2382[1].member_1), type_36(_e2382[2].member, _e2382[2].member_1), type_36(_e2382[3].member, _e2382[3].member_1));
                                                    phi_4024_ = type_9(0u, 4u);
                                                    phi_4027_ = true;
                                                    loop {
                                                        let _e2401 = phi_4024_;
                                                        let _e2403 = phi_4027_;
                                                        local_19 = _e2403;
                                                        let _e2406 = (_e2401.member < _e2401.member_1);
                                                        let _e2417 = select(type_9().member_1, _e2401.member, _e2406);
                                                        if (bitcast<i32>(select(0u, 1u, _e2406)) != 0i) {
                                                            let _e2422 = local_2[_e2417].member;
                                                            let _e2425 = local_2[_e2417].member_1;
                                                            let _e2427 = (_e2422 < -(_e2425));
                                                            phi_4028_ = select((_e2403 && (_e2422 > _e2425)), bool(), _e2427);
                                                            phi_4079_ = select(true, false, _e2427);
                                                            phi_4080_ = _e2427;
                                                        } else {
                                                            phi_4028_ = bool();
                                                            phi_4079_ = false;
                                                            phi_4080_ = false;
                                                        }
                                                        let _e2433 = phi_4028_;
                                                        let _e2435 = phi_4079_;
                                                        let _e2437 = phi_4080_;
                                                        local_18 = _e2437;
                                                        continue;
                                                        continuing {
                                                            phi_4024_ = type_9(select(_e2401.member, (_e2401.member + 1u), _e2406), select(_e2401.member_1, _e2401.member_1, _e2406));
                                                            phi_4027_ = _e2433;
                                                            break if !(_e2435);
                                                        }
                                                    }
                                                    let _e2440 = local_18;
                                                    let _e2441 = select(true, false, _e2440);
                                                    let _e2443 = local_19;
                                                    phi_4094_ = select(u32(), select(2u, 1u, _e2443), _e2441);
                                                    phi_4095_ = 0u;
                                                    phi_4096_ = select(true, false, _e2441);
                                                } else {
                                                    phi_4094_ = u32();
                                                    phi_4095_ = 2u;
                                                    phi_4096_ = true;
                                                }
                                                let _e2448 = phi_4094_;
                                                let _e2450 = phi_4095_;
                                                let _e2452 = phi_4096_;
                                                let _e2453 = select(_e2448, _e2450, _e2452);
                                                let _e2454 = (_e2453 == 0u);
                                                if _e2454 {
                                                    phi_4127_ = bool();
                                                    phi_4128_ = false;
                                                    phi_4129_ = false;
                                                } else {
                                                    let _e2457 = select(false, _e1871.member_2, (_e2453 == 1u));
                                                    let _e2463 = select(true, select(true, false, ((_e1871.member_1 - _e1871.member) <= _e1470)), _e2457);
                                                    phi_4127_ = _e2457;
                                                    phi_4128_ = _e2463;
                                                    phi_4129_ = select(true, false, _e2463);
                                                }
                                                let _e2466 = phi_4127_;
                                                let _e2468 = phi_4128_;
                                                let _e2470 = phi_4129_;
                                                phi_4130_ = _e2466;
                                                phi_4131_ = _e2454;
                                                phi_4132_ = _e2468;
                                                phi_4133_ = _e2470;
                                            }
                                            let _e2472 = phi_4130_;
                                            let _e2474 = phi_4131_;
                                            let _e2476 = phi_4132_;
                                            let _e2478 = phi_4133_;
                                            phi_4134_ = _e2472;
                                            phi_4135_ = _e2474;
                                            phi_4136_ = _e2476;
                                            phi_4137_ = _e1876;
                                            phi_4138_ = _e2478;
                                        }
                                        let _e2480 = phi_4134_;
                                        let _e2482 = phi_4135_;
                                        let _e2484 = phi_4136_;
                                        let _e2486 = phi_4137_;
                                        let _e2488 = phi_4138_;
                                        phi_4139_ = _e1871;
                                        phi_4140_ = _e2480;
                                        phi_4141_ = _e1871;
                                        phi_4142_ = _e2482;
                                        phi_4143_ = _e2484;
                                        phi_4144_ = _e2486;
                                        phi_4145_ = _e2488;
                                    }
                                    let _e2490 = phi_4139_;
                                    let _e2492 = phi_4140_;
                                    let _e2494 = phi_4141_;
                                    let _e2496 = phi_4142_;
                                    let _e2498 = phi_4143_;
                                    let _e2500 = phi_4144_;
                                    let _e2502 = phi_4145_;
                                    phi_4146_ = _e2490;
                                    phi_4147_ = _e2492;
                                    phi_4148_ = _e2494;
                                    phi_4149_ = _e2496;
                                    phi_4150_ = _e2498;
                                    phi_4151_ = _e1536;
                                    phi_4152_ = _e2500;
                                    phi_4153_ = _e2502;
                                } else {
                                    phi_4146_ = type_43();
                                    phi_4147_ = bool();
                                    phi_4148_ = type_43();
                                    phi_4149_ = true;
                                    phi_4150_ = false;
                                    phi_4151_ = false;
                                    phi_4152_ = false;
                                    phi_4153_ = false;
                                }
                                let _e2504 = phi_4146_;
                                let _e2506 = phi_4147_;
                                let _e2508 = phi_4148_;
                                let _e2510 = phi_4149_;
                                let _e2512 = phi_4150_;
                                let _e2514 = phi_4151_;
                                let _e2516 = phi_4152_;
                                let _e2518 = phi_4153_;
                                phi_4161_ = _e2504;
                                phi_4162_ = _e2506;
                                phi_4163_ = _e2508;
                                phi_4164_ = select(_e2512, false, _e2510);
                                phi_4165_ = _e2510;
                                phi_4166_ = select(_e2514, false, _e2510);
                                phi_4167_ = select(_e2516, false, _e2510);
                                phi_4168_ = select(_e2518, false, _e2510);
                            } else {
                                phi_4161_ = type_43(_e534, _e534, false);
                                phi_4162_ = false;
                                phi_4163_ = type_43();
                                phi_4164_ = true;
                                phi_4165_ = false;
                                phi_4166_ = false;
                                phi_4167_ = false;
                                phi_4168_ = false;
                            }
                            let _e2524 = phi_4161_;
                            let _e2526 = phi_4162_;
                            let _e2528 = phi_4163_;
                            let _e2530 = phi_4164_;
                            let _e2532 = phi_4165_;
                            let _e2534 = phi_4166_;
                            let _e2536 = phi_4167_;
                            let _e2538 = phi_4168_;
                            if _e2530 {
                                let _e2543 = local_7.member[0u];
                                let _e2549 = local_7.member_1[0u];
                                let _e2555 = local_7.member_2[0u];
                                let _e2559 = (_e2543[0] - _e2549[0]);
                                let _e2560 = (_e2543[1] - _e2549[1]);
                                let _e2561 = (_e2543[2] - _e2549[2]);
                                let _e2562 = (_e231.member == 0u);
                                let _e2574 = local_7.member[1u];
                                let _e2580 = local_7.member_1[1u];
                                let _e2586 = local_7.member_2[1u];
                                let _e2590 = (_e2574[0] - _e2580[0]);
                                let _e2591 = (_e2574[1] - _e2580[1]);
                                let _e2592 = (_e2574[2] - _e2580[2]);
                                let _e2593 = (_e231.member == 0u);
                                let _e2605 = local_7.member[0u];
                                let _e2611 = select(_e2605[0], -(_e2605[0]), (_e2605[0] < 0.0lf));
                                let _e2614 = select(_e2605[1], -(_e2605[1]), (_e2605[1] < 0.0lf));
                                let _e2616 = select(_e2614, _e2611, (_e2611 > _e2614));
                                let _e2619 = select(_e2605[2], -(_e2605[2]), (_e2605[2] < 0.0lf));
                                let _e2621 = select(_e2619, _e2616, (_e2616 > _e2619));
                                let _e2624 = local_7.member[1u];
                                let _e2630 = select(_e2624[0], -(_e2624[0]), (_e2624[0] < 0.0lf));
                                let _e2633 = select(_e2624[1], -(_e2624[1]), (_e2624[1] < 0.0lf));
                                let _e2635 = select(_e2633, _e2630, (_e2630 > _e2633));
                                let _e2638 = select(_e2624[2], -(_e2624[2]), (_e2624[2] < 0.0lf));
                                let _e2640 = select(_e2638, _e2635, (_e2635 > _e2638));
                                let _e2644 = local_7.member_3;
                                let _e2648 = local_7.member_1[0u];
                                let _e2654 = select(_e2648[0], -(_e2648[0]), (_e2648[0] < 0.0lf));
                                let _e2657 = select(_e2648[1], -(_e2648[1]), (_e2648[1] < 0.0lf));
                                let _e2659 = select(_e2657, _e2654, (_e2654 > _e2657));
                                let _e2662 = select(_e2648[2], -(_e2648[2]), (_e2648[2] < 0.0lf));
                                let _e2664 = select(_e2662, _e2659, (_e2659 > _e2662));
                                let _e2667 = local_7.member_1[1u];
                                let _e2673 = select(_e2667[0], -(_e2667[0]), (_e2667[0] < 0.0lf));
                                let _e2676 = select(_e2667[1], -(_e2667[1]), (_e2667[1] < 0.0lf));
                                let _e2678 = select(_e2676, _e2673, (_e2673 > _e2676));
                                let _e2681 = select(_e2667[2], -(_e2667[2]), (_e2667[2] < 0.0lf));
                                let _e2683 = select(_e2681, _e2678, (_e2678 > _e2681));
                                let _e2687 = local_7.member_3;
                                let _e2691 = local_7.member_2[0u];
                                let _e2697 = select(_e2691[0], -(_e2691[0]), (_e2691[0] < 0.0lf));
                                let _e2700 = select(_e2691[1], -(_e2691[1]), (_e2691[1] < 0.0lf));
                                let _e2702 = select(_e2700, _e2697, (_e2697 > _e2700));
                                let _e2705 = select(_e2691[2], -(_e2691[2]), (_e2691[2] < 0.0lf));
                                let _e2707 = select(_e2705, _e2702, (_e2702 > _e2705));
                                let _e2710 = local_7.member_2[1u];
                                let _e2716 = select(_e2710[0], -(_e2710[0]), (_e2710[0] < 0.0lf));
                                let _e2719 = select(_e2710[1], -(_e2710[1]), (_e2710[1] < 0.0lf));
                                let _e2721 = select(_e2719, _e2716, (_e2716 > _e2719));
                                let _e2724 = select(_e2710[2], -(_e2710[2]), (_e2710[2] < 0.0lf));
                                let _e2726 = select(_e2724, _e2721, (_e2721 > _e2724));
                                let _e2730 = local_7.member_3;
                                let _e2738 = local_7.member_3;
                                let _e2746 = (_e525 * f64(0.00390625f));
                                let _e2747 = f64(0f);
                                let _e2748 = f64(1f);
                                local = type_44(array<f64, 4>(_e2747, _e2747, _e2747, _e2747), array<f64, 4>(_e2747, _e2747, _e2747, _e2747), array<f64, 4>(_e2748, _e2748, _e2748, _e2748));
                                phi_4597_ = type_9(0u, 96u);
                                phi_4600_ = _e2524.member;
                                phi_4602_ = _e2524.member;
                                phi_4604_ = (_e2524.member_1 - _e2524.member);
                                phi_4606_ = _e2524.member;
                                phi_4608_ = false;
                                phi_4610_ = 0u;
                                loop {
                                    let _e2755 = phi_4597_;
                                    let _e2757 = phi_4600_;
                                    let _e2759 = phi_4602_;
                                    let _e2761 = phi_4604_;
                                    let _e2763 = phi_4606_;
                                    let _e2765 = phi_4608_;
                                    let _e2767 = phi_4610_;
                                    local_32 = _e2757;
                                    local_36 = _e2759;
                                    let _e2770 = (_e2755.member < _e2755.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2770)) != 0i) {
                                        let _e2784 = local_7.member[0u];
                                        let _e2790 = local_7.member[1u];
                                        let _e2806 = local_7.member_1[0u];
                                        let _e2812 = local_7.member_1[1u];
                                        let _e2828 = local_7.member_2[0u];
                                        let _e2834 = local_7.member_2[1u];
                                        let _e2848 = function_5(array<f64, 3>((_e2784[0] + ((_e2790[0] - _e2784[0]) * _e2757)), (_e2784[1] + ((_e2790[1] - _e2784[1]) * _e2757)), (_e2784[2] + ((_e2790[2] - _e2784[2]) * _e2757))), array<f64, 3>((_e2806[0] + ((_e2812[0] - _e2806[0]) * _e2757)), (_e2806[1] + ((_e2812[1] - _e2806[1]) * _e2757)), (_e2806[2] + ((_e2812[2] - _e2806[2]) * _e2757))), array<f64, 3>((_e2828[0] + ((_e2834[0] - _e2828[0]) * _e2757)), (_e2828[1] + ((_e2834[1] - _e2828[1]) * _e2757)), (_e2828[2] + ((_e2834[2] - _e2828[2]) * _e2757))), _e231.member);
                                        if (_e2767 == 0u) {
                                            phi_4762_ = _e2848;
                                        } else {
                                            let _e2850 = f64(0f);
                                            phi_4762_ = array<f64, 3>(select(_e2850, _e2848[0], (_e2767 == 1u)), select(_e2850, _e2848[1], (_e2767 == 2u)), select(_e2850, _e2848[2], (_e2767 == 3u)));
                                        }
                                        let _e2862 = phi_4762_;
                                        let _e2876 = ((select(_e2862[0], -(_e2862[0]), (_e2862[0] < 0.0lf)) + select(_e2862[1], -(_e2862[1]), (_e2862[1] < 0.0lf))) + select(_e2862[2], -(_e2862[2]), (_e2862[2] < 0.0lf)));
                                        if (_e2876 > f64(0f)) {
                                            if ((bitcast<u64>(_e2876) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2883 = (f64(1f) / _e2876);
                                                let _e2885 = (_e2862[0] * _e2883);
                                                let _e2887 = (_e2862[1] * _e2883);
                                                let _e2889 = (_e2862[2] * _e2883);
                                                let _e2894 = (((_e2885 * _e2885) + (_e2887 * _e2887)) + (_e2889 * _e2889));
                                                if (_e2894 <= 2.2250738585072014e-308lf) {
                                                    phi_4887_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2894 > 0.0lf));
                                                } else {
                                                    phi_4830_ = type_16(0i, 5i);
                                                    phi_4833_ = bitcast<f64>(((bitcast<u64>(_e2894) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2901 = phi_4830_;
                                                        let _e2903 = phi_4833_;
                                                        local_20 = _e2903;
                                                        if (_e2901.member < _e2901.member_1) {
                                                            let _e2910 = (_e2901.member + 1i);
                                                            phi_4831_ = type_16(select(_e2910, type_17().member_1, select(false, true, ((false == (_e2910 > _e2901.member)) != false))), _e2901.member_1);
                                                            phi_4874_ = type_17(1u, _e2901.member);
                                                        } else {
                                                            phi_4831_ = _e2901;
                                                            phi_4874_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2921 = phi_4831_;
                                                        let _e2923 = phi_4874_;
                                                        let _e2926 = (bitcast<i32>(_e2923.member) != 0i);
                                                        if _e2926 {
                                                            phi_4834_ = (0.5lf * (_e2903 + (_e2894 / _e2903)));
                                                        } else {
                                                            phi_4834_ = f64();
                                                        }
                                                        let _e2931 = phi_4834_;
                                                        continue;
                                                        continuing {
                                                            phi_4830_ = _e2921;
                                                            phi_4833_ = _e2931;
                                                            break if !(_e2926);
                                                        }
                                                    }
                                                    let _e2936 = local_20;
                                                    phi_4887_ = (_e2936 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2942 = phi_4887_;
                                                let _e2944 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2951 = ((((((((select(_e2640, _e2621, (_e2621 > _e2640)) + _e2644) + (select(_e2683, _e2664, (_e2664 > _e2683)) + _e2687)) + (select(_e2726, _e2707, (_e2707 > _e2726)) + _e2730)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2738 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e1256 * _e2942) * (f64(1f) + _e2944)));
                                                let _e2956 = (((_e2885 * _e2543[0]) + (_e2887 * _e2543[1])) + (_e2889 * _e2543[2]));
                                                let _e2961 = (((_e2885 * _e2559) + (_e2887 * _e2560)) + (_e2889 * _e2561));
                                                let _e2966 = (((_e2885 * (_e2543[0] - _e2555[0])) + (_e2887 * (_e2543[1] - _e2555[1]))) + (_e2889 * (_e2543[2] - _e2555[2])));
                                                let _e2971 = (((_e2885 * select((_e2559 - _e2555[0]), _e2543[0], _e2562)) + (_e2887 * select((_e2560 - _e2555[1]), _e2543[1], _e2562))) + (_e2889 * select((_e2561 - _e2555[2]), _e2543[2], _e2562)));
                                                let _e2977 = (((_e2885 * _e2574[0]) + (_e2887 * _e2574[1])) + (_e2889 * _e2574[2]));
                                                let _e2982 = (((_e2885 * _e2590) + (_e2887 * _e2591)) + (_e2889 * _e2592));
                                                let _e2987 = (((_e2885 * (_e2574[0] - _e2586[0])) + (_e2887 * (_e2574[1] - _e2586[1]))) + (_e2889 * (_e2574[2] - _e2586[2])));
                                                let _e2992 = (((_e2885 * select((_e2590 - _e2586[0]), _e2574[0], _e2593)) + (_e2887 * select((_e2591 - _e2586[1]), _e2574[1], _e2593))) + (_e2889 * select((_e2592 - _e2586[2]), _e2574[2], _e2593)));
                                                phi_5013_ = type_44(array<f64, 4>(_e2956, _e2961, _e2966, _e2971), array<f64, 4>(_e2977, _e2982, _e2987, _e2992), array<f64, 4>((_e2951 + ((select(_e2956, -(_e2956), (_e2956 < 0.0lf)) + select(_e2977, -(_e2977), (_e2977 < 0.0lf))) * _e2944)), (_e2951 + ((select(_e2961, -(_e2961), (_e2961 < 0.0lf)) + select(_e2982, -(_e2982), (_e2982 < 0.0lf))) * _e2944)), (_e2951 + ((select(_e2966, -(_e2966), (_e2966 < 0.0lf)) + select(_e2987, -(_e2987), (_e2987 < 0.0lf))) * _e2944)), (_e2951 + ((select(_e2971, -(_e2971), (_e2971 < 0.0lf)) + select(_e2992, -(_e2992), (_e2992 < 0.0lf))) * _e2944))));
                                                phi_5014_ = false;
                                            } else {
                                                phi_5013_ = type_44();
                                                phi_5014_ = true;
                                            }
                                            let _e3033 = phi_5013_;
                                            let _e3035 = phi_5014_;
                                            phi_5015_ = _e3033;
                                            phi_5016_ = _e3035;
                                        } else {
                                            phi_5015_ = type_44();
                                            phi_5016_ = true;
                                        }
                                        let _e3037 = phi_5015_;
                                        let _e3039 = phi_5016_;
                                        if _e3039 {
                                            let _e3040 = f64(0f);
                                            let _e3041 = f64(1f);
                                            phi_5026_ = type_44(array<f64, 4>(_e3040, _e3040, _e3040, _e3040), array<f64, 4>(_e3040, _e3040, _e3040, _e3040), array<f64, 4>(_e3041, _e3041, _e3041, _e3041));
                                        } else {
                                            phi_5026_ = _e3037;
                                        }
                                        let _e3047 = phi_5026_;
                                        local_1 = type_44(array<f64, 4>(_e3047.member[0], _e3047.member[1], _e3047.member[2], _e3047.member[3]), array<f64, 4>(_e3047.member_1[0], _e3047.member_1[1], _e3047.member_1[2], _e3047.member_1[3]), array<f64, 4>(_e3047.member_2[0], _e3047.member_2[1], _e3047.member_2[2], _e3047.member_2[3]));
                                        let _e3067 = (_e2757 - _e2763);
                                        let _e3069 = f64(0f);
                                        let _e3072 = local_1.member[0u];
                                        let _e3075 = local_1.member_1[0u];
                                        let _e3078 = local_1.member[0u];
                                        let _e3084 = local_1.member_2[0u];
                                        if (((_e3072 + ((_e3075 - _e3078) * _e2757)) - _e3084) > _e3069) {
                                            let _e3089 = local_1.member[1u];
                                            let _e3092 = local_1.member_1[1u];
                                            let _e3095 = local_1.member[1u];
                                            let _e3101 = local_1.member_2[1u];
                                            if (((_e3089 + ((_e3092 - _e3095) * _e2757)) - _e3101) > _e3069) {
                                                let _e3106 = local_1.member[2u];
                                                let _e3109 = local_1.member_1[2u];
                                                let _e3112 = local_1.member[2u];
                                                let _e3118 = local_1.member_2[2u];
                                                if (((_e3106 + ((_e3109 - _e3112) * _e2757)) - _e3118) > _e3069) {
                                                    let _e3123 = local_1.member[3u];
                                                    let _e3126 = local_1.member_1[3u];
                                                    let _e3129 = local_1.member[3u];
                                                    let _e3135 = local_1.member_2[3u];
                                                    phi_5198_ = (((_e3123 + ((_e3126 - _e3129) * _e2757)) - _e3135) > _e3069);
                                                    phi_5199_ = false;
                                                } else {
                                                    phi_5198_ = bool();
                                                    phi_5199_ = true;
                                                }
                                                let _e3139 = phi_5198_;
                                                let _e3141 = phi_5199_;
                                                phi_5200_ = _e3139;
                                                phi_5201_ = _e3141;
                                            } else {
                                                phi_5200_ = bool();
                                                phi_5201_ = true;
                                            }
                                            let _e3143 = phi_5200_;
                                            let _e3145 = phi_5201_;
                                            phi_5202_ = _e3143;
                                            phi_5203_ = _e3145;
                                        } else {
                                            phi_5202_ = bool();
                                            phi_5203_ = true;
                                        }
                                        let _e3147 = phi_5202_;
                                        let _e3149 = phi_5203_;
                                        if select(_e3147, false, _e3149) {
                                            if (_e2757 <= _e2759) {
                                                phi_5518_ = true;
                                            } else {
                                                let _e3152 = f64(0f);
                                                let _e3155 = local.member[0u];
                                                let _e3158 = local.member_1[0u];
                                                let _e3161 = local.member[0u];
                                                let _e3167 = local.member_2[0u];
                                                let _e3171 = local_1.member[0u];
                                                let _e3174 = local_1.member_1[0u];
                                                let _e3177 = local_1.member[0u];
                                                let _e3183 = local_1.member_2[0u];
                                                if ((((_e3155 + ((_e3158 - _e3161) * _e2757)) - _e3167) + ((_e3171 + ((_e3174 - _e3177) * _e2763)) - _e3183)) > _e3152) {
                                                    let _e3189 = local.member[1u];
                                                    let _e3192 = local.member_1[1u];
                                                    let _e3195 = local.member[1u];
                                                    let _e3201 = local.member_2[1u];
                                                    let _e3205 = local_1.member[1u];
                                                    let _e3208 = local_1.member_1[1u];
                                                    let _e3211 = local_1.member[1u];
                                                    let _e3217 = local_1.member_2[1u];
                                                    if ((((_e3189 + ((_e3192 - _e3195) * _e2757)) - _e3201) + ((_e3205 + ((_e3208 - _e3211) * _e2763)) - _e3217)) > _e3152) {
                                                        let _e3223 = local.member[2u];
                                                        let _e3226 = local.member_1[2u];
                                                        let _e3229 = local.member[2u];
                                                        let _e3235 = local.member_2[2u];
                                                        let _e3239 = local_1.member[2u];
                                                        let _e3242 = local_1.member_1[2u];
                                                        let _e3245 = local_1.member[2u];
                                                        let _e3251 = local_1.member_2[2u];
                                                        if ((((_e3223 + ((_e3226 - _e3229) * _e2757)) - _e3235) + ((_e3239 + ((_e3242 - _e3245) * _e2763)) - _e3251)) > _e3152) {
                                                            let _e3257 = local.member[3u];
                                                            let _e3260 = local.member_1[3u];
                                                            let _e3263 = local.member[3u];
                                                            let _e3269 = local.member_2[3u];
                                                            let _e3273 = local_1.member[3u];
                                                            let _e3276 = local_1.member_1[3u];
                                                            let _e3279 = local_1.member[3u];
                                                            let _e3285 = local_1.member_2[3u];
                                                            phi_5505_ = ((((_e3257 + ((_e3260 - _e3263) * _e2757)) - _e3269) + ((_e3273 + ((_e3276 - _e3279) * _e2763)) - _e3285)) > _e3152);
                                                            phi_5506_ = false;
                                                        } else {
                                                            phi_5505_ = bool();
                                                            phi_5506_ = true;
                                                        }
                                                        let _e3290 = phi_5505_;
                                                        let _e3292 = phi_5506_;
                                                        phi_5507_ = _e3290;
                                                        phi_5508_ = _e3292;
                                                    } else {
                                                        phi_5507_ = bool();
                                                        phi_5508_ = true;
                                                    }
                                                    let _e3294 = phi_5507_;
                                                    let _e3296 = phi_5508_;
                                                    phi_5509_ = _e3294;
                                                    phi_5510_ = _e3296;
                                                } else {
                                                    phi_5509_ = bool();
                                                    phi_5510_ = true;
                                                }
                                                let _e3298 = phi_5509_;
                                                let _e3300 = phi_5510_;
                                                phi_5518_ = select(_e3298, false, _e3300);
                                            }
                                            let _e3303 = phi_5518_;
                                            if _e3303 {
                                                if select(true, select(true, false, (_e2757 >= _e2524.member_1)), _e2765) {
                                                    local = type_44(array<f64, 4>(_e3047.member[0], _e3047.member[1], _e3047.member[2], _e3047.member[3]), array<f64, 4>(_e3047.member_1[0], _e3047.member_1[1], _e3047.member_1[2], _e3047.member_1[3]), array<f64, 4>(_e3047.member_2[0], _e3047.member_2[1], _e3047.member_2[2], _e3047.member_2[3]));
                                                    let _e3328 = local.member[0u];
                                                    let _e3331 = local.member_1[0u];
                                                    let _e3334 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e3331 > _e3334)), (_e3328 > _e3334)) {
                                                        let _e3339 = (_e3331 >= _e3328);
                                                        if _e3339 {
                                                            phi_5630_ = f64();
                                                            phi_5631_ = false;
                                                        } else {
                                                            if ((_e3328 - _e3331) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5628_ = (((_e3328 - _e3334) / (_e3328 - _e3331)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5629_ = false;
                                                            } else {
                                                                phi_5628_ = f64();
                                                                phi_5629_ = true;
                                                            }
                                                            let _e3353 = phi_5628_;
                                                            let _e3355 = phi_5629_;
                                                            phi_5630_ = _e3353;
                                                            phi_5631_ = _e3355;
                                                        }
                                                        let _e3357 = phi_5630_;
                                                        let _e3359 = phi_5631_;
                                                        phi_5632_ = _e3357;
                                                        phi_5633_ = _e3339;
                                                        phi_5634_ = _e3359;
                                                    } else {
                                                        phi_5632_ = f64();
                                                        phi_5633_ = true;
                                                        phi_5634_ = false;
                                                    }
                                                    let _e3361 = phi_5632_;
                                                    let _e3363 = phi_5633_;
                                                    let _e3365 = phi_5634_;
                                                    let _e3369 = select(_e3361, select(_e2757, f64(2f), _e3363), select(_e3365, true, _e3363));
                                                    let _e3372 = local.member[1u];
                                                    let _e3375 = local.member_1[1u];
                                                    let _e3378 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e3375 > _e3378)), (_e3372 > _e3378)) {
                                                        let _e3383 = (_e3375 >= _e3372);
                                                        if _e3383 {
                                                            phi_5702_ = f64();
                                                            phi_5703_ = false;
                                                        } else {
                                                            if ((_e3372 - _e3375) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5700_ = (((_e3372 - _e3378) / (_e3372 - _e3375)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5701_ = false;
                                                            } else {
                                                                phi_5700_ = f64();
                                                                phi_5701_ = true;
                                                            }
                                                            let _e3397 = phi_5700_;
                                                            let _e3399 = phi_5701_;
                                                            phi_5702_ = _e3397;
                                                            phi_5703_ = _e3399;
                                                        }
                                                        let _e3401 = phi_5702_;
                                                        let _e3403 = phi_5703_;
                                                        phi_5704_ = _e3401;
                                                        phi_5705_ = _e3383;
                                                        phi_5706_ = _e3403;
                                                    } else {
                                                        phi_5704_ = f64();
                                                        phi_5705_ = true;
                                                        phi_5706_ = false;
                                                    }
                                                    let _e3405 = phi_5704_;
                                                    let _e3407 = phi_5705_;
                                                    let _e3409 = phi_5706_;
                                                    let _e3413 = select(_e3405, select(_e2757, f64(2f), _e3407), select(_e3409, true, _e3407));
                                                    let _e3415 = select(_e3413, _e3369, (_e3369 < _e3413));
                                                    let _e3418 = local.member[2u];
                                                    let _e3421 = local.member_1[2u];
                                                    let _e3424 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3421 > _e3424)), (_e3418 > _e3424)) {
                                                        let _e3429 = (_e3421 >= _e3418);
                                                        if _e3429 {
                                                            phi_5779_ = f64();
                                                            phi_5780_ = false;
                                                        } else {
                                                            if ((_e3418 - _e3421) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5777_ = (((_e3418 - _e3424) / (_e3418 - _e3421)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5778_ = false;
                                                            } else {
                                                                phi_5777_ = f64();
                                                                phi_5778_ = true;
                                                            }
                                                            let _e3443 = phi_5777_;
                                                            let _e3445 = phi_5778_;
                                                            phi_5779_ = _e3443;
                                                            phi_5780_ = _e3445;
                                                        }
                                                        let _e3447 = phi_5779_;
                                                        let _e3449 = phi_5780_;
                                                        phi_5781_ = _e3447;
                                                        phi_5782_ = _e3429;
                                                        phi_5783_ = _e3449;
                                                    } else {
                                                        phi_5781_ = f64();
                                                        phi_5782_ = true;
                                                        phi_5783_ = false;
                                                    }
                                                    let _e3451 = phi_5781_;
                                                    let _e3453 = phi_5782_;
                                                    let _e3455 = phi_5783_;
                                                    let _e3459 = select(_e3451, select(_e2757, f64(2f), _e3453), select(_e3455, true, _e3453));
                                                    let _e3462 = local.member[3u];
                                                    let _e3465 = local.member_1[3u];
                                                    let _e3468 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3465 > _e3468)), (_e3462 > _e3468)) {
                                                        let _e3473 = (_e3465 >= _e3462);
                                                        if _e3473 {
                                                            phi_5851_ = f64();
                                                            phi_5852_ = false;
                                                        } else {
                                                            if ((_e3462 - _e3465) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5849_ = (((_e3462 - _e3468) / (_e3462 - _e3465)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5850_ = false;
                                                            } else {
                                                                phi_5849_ = f64();
                                                                phi_5850_ = true;
                                                            }
                                                            let _e3487 = phi_5849_;
                                                            let _e3489 = phi_5850_;
                                                            phi_5851_ = _e3487;
                                                            phi_5852_ = _e3489;
                                                        }
                                                        let _e3491 = phi_5851_;
                                                        let _e3493 = phi_5852_;
                                                        phi_5853_ = _e3491;
                                                        phi_5854_ = _e3473;
                                                        phi_5855_ = _e3493;
                                                    } else {
                                                        phi_5853_ = f64();
                                                        phi_5854_ = true;
                                                        phi_5855_ = false;
                                                    }
                                                    let _e3495 = phi_5853_;
                                                    let _e3497 = phi_5854_;
                                                    let _e3499 = phi_5855_;
                                                    let _e3503 = select(_e3495, select(_e2757, f64(2f), _e3497), select(_e3499, true, _e3497));
                                                    let _e3505 = select(_e3503, _e3459, (_e3459 < _e3503));
                                                    let _e3507 = select(_e3505, _e3415, (_e3415 < _e3505));
                                                    let _e3509 = select(_e2757, _e3507, (_e3507 > _e2757));
                                                    let _e3510 = (_e3509 > _e2524.member_1);
                                                    if _e3510 {
                                                        phi_6397_ = f64();
                                                        phi_6398_ = f64();
                                                        phi_6399_ = false;
                                                        phi_6400_ = false;
                                                    } else {
                                                        let _e3511 = (_e3509 - _e2757);
                                                        let _e3512 = (_e3511 <= _e2746);
                                                        let _e3515 = (_e3509 + (_e525 * f64(0.01f)));
                                                        let _e3517 = select(_e2524.member_1, _e3515, (_e3515 < _e2524.member_1));
                                                        if _e3512 {
                                                            if (_e1256 > f64(0f)) {
                                                                let _e3522 = local_7.member[0u];
                                                                let _e3528 = local_7.member[1u];
                                                                let _e3544 = local_7.member_1[0u];
                                                                let _e3550 = local_7.member_1[1u];
                                                                let _e3566 = local_7.member_2[0u];
                                                                let _e3572 = local_7.member_2[1u];
                                                                let _e3586 = function_5(array<f64, 3>((_e3522[0] + ((_e3528[0] - _e3522[0]) * _e3517)), (_e3522[1] + ((_e3528[1] - _e3522[1]) * _e3517)), (_e3522[2] + ((_e3528[2] - _e3522[2]) * _e3517))), array<f64, 3>((_e3544[0] + ((_e3550[0] - _e3544[0]) * _e3517)), (_e3544[1] + ((_e3550[1] - _e3544[1]) * _e3517)), (_e3544[2] + ((_e3550[2] - _e3544[2]) * _e3517))), array<f64, 3>((_e3566[0] + ((_e3572[0] - _e3566[0]) * _e3517)), (_e3566[1] + ((_e3572[1] - _e3566[1]) * _e3517)), (_e3566[2] + ((_e3572[2] - _e3566[2]) * _e3517))), _e231.member);
                                                                let _e3597 = (((_e3586[0] * _e3586[0]) + (_e3586[1] * _e3586[1])) + (_e3586[2] * _e3586[2]));
                                                                if (_e3597 <= 2.2250738585072014e-308lf) {
                                                                    phi_6089_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3597 > 0.0lf));
                                                                } else {
                                                                    phi_6032_ = type_16(0i, 5i);
                                                                    phi_6035_ = bitcast<f64>(((bitcast<u64>(_e3597) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e3604 = phi_6032_;
                                                                        let _e3606 = phi_6035_;
                                                                        local_21 = _e3606;
                                                                        if (_e3604.member < _e3604.member_1) {
                                                                            let _e3613 = (_e3604.member + 1i);
                                                                            phi_6033_ = type_16(select(_e3613, type_17().member_1, select(false, true, ((false == (_e3613 > _e3604.member)) != false))), _e3604.member_1);
                                                                            phi_6076_ = type_17(1u, _e3604.member);
                                                                        } else {
                                                                            phi_6033_ = _e3604;
                                                                            phi_6076_ = type_17(0u, type_17().member_1);
                                                                        }
                                                                        let _e3624 = phi_6033_;
                                                                        let _e3626 = phi_6076_;
                                                                        let _e3629 = (bitcast<i32>(_e3626.member) != 0i);
                                                                        if _e3629 {
                                                                            phi_6036_ = (0.5lf * (_e3606 + (_e3597 / _e3606)));
                                                                        } else {
                                                                            phi_6036_ = f64();
                                                                        }
                                                                        let _e3634 = phi_6036_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_6032_ = _e3624;
                                                                            phi_6035_ = _e3634;
                                                                            break if !(_e3629);
                                                                        }
                                                                    }
                                                                    let _e3639 = local_21;
                                                                    phi_6089_ = (_e3639 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e3645 = phi_6089_;
                                                                let _e3653 = local_7.member[0u];
                                                                let _e3659 = select(_e3653[0], -(_e3653[0]), (_e3653[0] < 0.0lf));
                                                                let _e3662 = select(_e3653[1], -(_e3653[1]), (_e3653[1] < 0.0lf));
                                                                let _e3664 = select(_e3662, _e3659, (_e3659 > _e3662));
                                                                let _e3667 = select(_e3653[2], -(_e3653[2]), (_e3653[2] < 0.0lf));
                                                                let _e3669 = select(_e3667, _e3664, (_e3664 > _e3667));
                                                                let _e3672 = local_7.member[1u];
                                                                let _e3678 = select(_e3672[0], -(_e3672[0]), (_e3672[0] < 0.0lf));
                                                                let _e3681 = select(_e3672[1], -(_e3672[1]), (_e3672[1] < 0.0lf));
                                                                let _e3683 = select(_e3681, _e3678, (_e3678 > _e3681));
                                                                let _e3686 = select(_e3672[2], -(_e3672[2]), (_e3672[2] < 0.0lf));
                                                                let _e3688 = select(_e3686, _e3683, (_e3683 > _e3686));
                                                                let _e3692 = local_7.member_3;
                                                                let _e3696 = local_7.member_1[0u];
                                                                let _e3702 = select(_e3696[0], -(_e3696[0]), (_e3696[0] < 0.0lf));
                                                                let _e3705 = select(_e3696[1], -(_e3696[1]), (_e3696[1] < 0.0lf));
                                                                let _e3707 = select(_e3705, _e3702, (_e3702 > _e3705));
                                                                let _e3710 = select(_e3696[2], -(_e3696[2]), (_e3696[2] < 0.0lf));
                                                                let _e3712 = select(_e3710, _e3707, (_e3707 > _e3710));
                                                                let _e3715 = local_7.member_1[1u];
                                                                let _e3721 = select(_e3715[0], -(_e3715[0]), (_e3715[0] < 0.0lf));
                                                                let _e3724 = select(_e3715[1], -(_e3715[1]), (_e3715[1] < 0.0lf));
                                                                let _e3726 = select(_e3724, _e3721, (_e3721 > _e3724));
                                                                let _e3729 = select(_e3715[2], -(_e3715[2]), (_e3715[2] < 0.0lf));
                                                                let _e3731 = select(_e3729, _e3726, (_e3726 > _e3729));
                                                                let _e3735 = local_7.member_3;
                                                                let _e3739 = local_7.member_2[0u];
                                                                let _e3745 = select(_e3739[0], -(_e3739[0]), (_e3739[0] < 0.0lf));
                                                                let _e3748 = select(_e3739[1], -(_e3739[1]), (_e3739[1] < 0.0lf));
                                                                let _e3750 = select(_e3748, _e3745, (_e3745 > _e3748));
                                                                let _e3753 = select(_e3739[2], -(_e3739[2]), (_e3739[2] < 0.0lf));
                                                                let _e3755 = select(_e3753, _e3750, (_e3750 > _e3753));
                                                                let _e3758 = local_7.member_2[1u];
                                                                let _e3764 = select(_e3758[0], -(_e3758[0]), (_e3758[0] < 0.0lf));
                                                                let _e3767 = select(_e3758[1], -(_e3758[1]), (_e3758[1] < 0.0lf));
                                                                let _e3769 = select(_e3767, _e3764, (_e3764 > _e3767));
                                                                let _e3772 = select(_e3758[2], -(_e3758[2]), (_e3758[2] < 0.0lf));
                                                                let _e3774 = select(_e3772, _e3769, (_e3769 > _e3772));
                                                                let _e3778 = local_7.member_3;
                                                                let _e3786 = local_7.member_3;
                                                                phi_6366_ = select(true, false, (((_e3645 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e3688, _e3669, (_e3669 > _e3688)) + _e3692) + (select(_e3731, _e3712, (_e3712 > _e3731)) + _e3735)) + (select(_e3774, _e3755, (_e3755 > _e3774)) + _e3778)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3786 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e1256));
                                                            } else {
                                                                phi_6366_ = true;
                                                            }
                                                            let _e3799 = phi_6366_;
                                                            phi_6367_ = _e3799;
                                                        } else {
                                                            phi_6367_ = true;
                                                        }
                                                        let _e3801 = phi_6367_;
                                                        if _e3801 {
                                                            if _e2765 {
                                                                let _e3805 = (_e3511 <= (_e2761 * f64(0.25f)));
                                                                phi_6394_ = select(select(select(f64(), f64(0f), _e3805), f64(), _e3512), (_e3067 + _e3067), select(select(true, false, _e3805), true, _e3512));
                                                            } else {
                                                                phi_6394_ = (_e2524.member_1 - _e2757);
                                                            }
                                                            let _e3814 = phi_6394_;
                                                            phi_6395_ = _e3814;
                                                            phi_6396_ = false;
                                                        } else {
                                                            phi_6395_ = f64();
                                                            phi_6396_ = true;
                                                        }
                                                        let _e3816 = phi_6395_;
                                                        let _e3818 = phi_6396_;
                                                        phi_6397_ = _e3816;
                                                        phi_6398_ = _e3511;
                                                        phi_6399_ = _e3801;
                                                        phi_6400_ = _e3818;
                                                    }
                                                    let _e3820 = phi_6397_;
                                                    let _e3822 = phi_6398_;
                                                    let _e3824 = phi_6399_;
                                                    let _e3826 = phi_6400_;
                                                    phi_6401_ = _e3509;
                                                    phi_6402_ = _e3820;
                                                    phi_6403_ = _e3822;
                                                    phi_6404_ = _e3509;
                                                    phi_6405_ = _e3824;
                                                    phi_6406_ = _e3510;
                                                    phi_6407_ = _e3826;
                                                    phi_6408_ = false;
                                                } else {
                                                    phi_6401_ = f64();
                                                    phi_6402_ = f64();
                                                    phi_6403_ = f64();
                                                    phi_6404_ = f64();
                                                    phi_6405_ = false;
                                                    phi_6406_ = false;
                                                    phi_6407_ = false;
                                                    phi_6408_ = true;
                                                }
                                                let _e3828 = phi_6401_;
                                                let _e3830 = phi_6402_;
                                                let _e3832 = phi_6403_;
                                                let _e3834 = phi_6404_;
                                                let _e3836 = phi_6405_;
                                                let _e3838 = phi_6406_;
                                                let _e3840 = phi_6407_;
                                                let _e3842 = phi_6408_;
                                                phi_6409_ = _e3828;
                                                phi_6410_ = _e3830;
                                                phi_6411_ = _e3832;
                                                phi_6412_ = _e3834;
                                                phi_6413_ = false;
                                                phi_6414_ = _e3836;
                                                phi_6415_ = _e3838;
                                                phi_6416_ = _e3840;
                                                phi_6417_ = _e3842;
                                            } else {
                                                phi_6409_ = f64();
                                                phi_6410_ = f64();
                                                phi_6411_ = f64();
                                                phi_6412_ = f64();
                                                phi_6413_ = true;
                                                phi_6414_ = false;
                                                phi_6415_ = false;
                                                phi_6416_ = false;
                                                phi_6417_ = false;
                                            }
                                            let _e3844 = phi_6409_;
                                            let _e3846 = phi_6410_;
                                            let _e3848 = phi_6411_;
                                            let _e3850 = phi_6412_;
                                            let _e3852 = phi_6413_;
                                            let _e3854 = phi_6414_;
                                            let _e3856 = phi_6415_;
                                            let _e3858 = phi_6416_;
                                            let _e3860 = phi_6417_;
                                            phi_6418_ = _e3844;
                                            phi_6419_ = _e3846;
                                            phi_6420_ = _e3848;
                                            phi_6421_ = _e3850;
                                            phi_6422_ = _e3852;
                                            phi_6423_ = _e3854;
                                            phi_6424_ = _e3856;
                                            phi_6425_ = _e3858;
                                            phi_6426_ = _e3860;
                                        } else {
                                            phi_6418_ = f64();
                                            phi_6419_ = f64();
                                            phi_6420_ = f64();
                                            phi_6421_ = f64();
                                            phi_6422_ = true;
                                            phi_6423_ = false;
                                            phi_6424_ = false;
                                            phi_6425_ = false;
                                            phi_6426_ = false;
                                        }
                                        let _e3862 = phi_6418_;
                                        let _e3864 = phi_6419_;
                                        let _e3866 = phi_6420_;
                                        let _e3868 = phi_6421_;
                                        let _e3870 = phi_6422_;
                                        let _e3872 = phi_6423_;
                                        let _e3874 = phi_6424_;
                                        let _e3876 = phi_6425_;
                                        let _e3878 = phi_6426_;
                                        if _e3870 {
                                            if (_e2757 <= _e2759) {
                                                let _e4036 = (_e2767 + 1u);
                                                let _e4037 = (_e4036 > 3u);
                                                phi_6766_ = _e4036;
                                                phi_6767_ = f64();
                                                phi_6768_ = false;
                                                phi_6769_ = select(true, false, _e4037);
                                                phi_6770_ = _e4037;
                                            } else {
                                                let _e3882 = local.member[0u];
                                                let _e3885 = local.member_1[0u];
                                                let _e3888 = local.member[0u];
                                                let _e3894 = local.member_2[0u];
                                                let _e3895 = ((_e3882 + ((_e3885 - _e3888) * _e2763)) - _e3894);
                                                let _e3898 = local.member[1u];
                                                let _e3901 = local.member_1[1u];
                                                let _e3904 = local.member[1u];
                                                let _e3910 = local.member_2[1u];
                                                let _e3911 = ((_e3898 + ((_e3901 - _e3904) * _e2763)) - _e3910);
                                                let _e3913 = select(_e3911, _e3895, (_e3895 < _e3911));
                                                let _e3916 = local.member[2u];
                                                let _e3919 = local.member_1[2u];
                                                let _e3922 = local.member[2u];
                                                let _e3928 = local.member_2[2u];
                                                let _e3929 = ((_e3916 + ((_e3919 - _e3922) * _e2763)) - _e3928);
                                                let _e3932 = local.member[3u];
                                                let _e3935 = local.member_1[3u];
                                                let _e3938 = local.member[3u];
                                                let _e3944 = local.member_2[3u];
                                                let _e3945 = ((_e3932 + ((_e3935 - _e3938) * _e2763)) - _e3944);
                                                let _e3947 = select(_e3945, _e3929, (_e3929 < _e3945));
                                                let _e3949 = select(_e3947, _e3913, (_e3913 < _e3947));
                                                let _e3952 = local_1.member[0u];
                                                let _e3955 = local_1.member_1[0u];
                                                let _e3958 = local_1.member[0u];
                                                let _e3964 = local_1.member_2[0u];
                                                let _e3965 = ((_e3952 + ((_e3955 - _e3958) * _e2757)) - _e3964);
                                                let _e3968 = local_1.member[1u];
                                                let _e3971 = local_1.member_1[1u];
                                                let _e3974 = local_1.member[1u];
                                                let _e3980 = local_1.member_2[1u];
                                                let _e3981 = ((_e3968 + ((_e3971 - _e3974) * _e2757)) - _e3980);
                                                let _e3983 = select(_e3981, _e3965, (_e3965 < _e3981));
                                                let _e3986 = local_1.member[2u];
                                                let _e3989 = local_1.member_1[2u];
                                                let _e3992 = local_1.member[2u];
                                                let _e3998 = local_1.member_2[2u];
                                                let _e3999 = ((_e3986 + ((_e3989 - _e3992) * _e2757)) - _e3998);
                                                let _e4002 = local_1.member[3u];
                                                let _e4005 = local_1.member_1[3u];
                                                let _e4008 = local_1.member[3u];
                                                let _e4014 = local_1.member_2[3u];
                                                let _e4015 = ((_e4002 + ((_e4005 - _e4008) * _e2757)) - _e4014);
                                                let _e4017 = select(_e4015, _e3999, (_e3999 < _e4015));
                                                let _e4019 = select(_e4017, _e3983, (_e3983 < _e4017));
                                                let _e4020 = f64(0.0625f);
                                                let _e4022 = f64(0.9f);
                                                if (_e4019 > f64(0f)) {
                                                    phi_6764_ = f64(0.5f);
                                                } else {
                                                    let _e4028 = (f64(0.95f) * (_e3949 / (_e3949 - _e4019)));
                                                    phi_6764_ = select(_e4020, select(_e4022, _e4028, (_e4028 < _e4022)), (_e4028 > _e4020));
                                                }
                                                let _e4034 = phi_6764_;
                                                phi_6766_ = u32();
                                                phi_6767_ = (_e3067 * _e4034);
                                                phi_6768_ = true;
                                                phi_6769_ = false;
                                                phi_6770_ = false;
                                            }
                                            let _e4040 = phi_6766_;
                                            let _e4042 = phi_6767_;
                                            let _e4044 = phi_6768_;
                                            let _e4046 = phi_6769_;
                                            let _e4048 = phi_6770_;
                                            phi_6771_ = _e4040;
                                            phi_6772_ = _e2759;
                                            phi_6773_ = _e4042;
                                            phi_6774_ = _e2761;
                                            phi_6775_ = _e2763;
                                            phi_6776_ = _e2765;
                                            phi_6777_ = _e2767;
                                            phi_6778_ = _e4044;
                                            phi_6779_ = _e4046;
                                            phi_6780_ = _e4048;
                                            phi_6781_ = false;
                                            phi_6782_ = false;
                                            phi_6783_ = false;
                                        } else {
                                            phi_6771_ = u32();
                                            phi_6772_ = _e3862;
                                            phi_6773_ = _e3864;
                                            phi_6774_ = _e3866;
                                            phi_6775_ = _e2757;
                                            phi_6776_ = true;
                                            phi_6777_ = 0u;
                                            phi_6778_ = _e3872;
                                            phi_6779_ = false;
                                            phi_6780_ = false;
                                            phi_6781_ = _e3874;
                                            phi_6782_ = _e3876;
                                            phi_6783_ = _e3878;
                                        }
                                        let _e4050 = phi_6771_;
                                        let _e4052 = phi_6772_;
                                        let _e4054 = phi_6773_;
                                        let _e4056 = phi_6774_;
                                        let _e4058 = phi_6775_;
                                        let _e4060 = phi_6776_;
                                        let _e4062 = phi_6777_;
                                        let _e4064 = phi_6778_;
                                        let _e4066 = phi_6779_;
                                        let _e4068 = phi_6780_;
                                        let _e4070 = phi_6781_;
                                        let _e4072 = phi_6782_;
                                        let _e4074 = phi_6783_;
                                        if _e4064 {
                                            let _e4075 = (_e4058 + _e4054);
                                            let _e4077 = select(_e4052, _e4075, (_e4075 > _e4052));
                                            let _e4079 = select(_e2524.member_1, _e4077, (_e4077 < _e2524.member_1));
                                            let _e4082 = select(((_e4079 - _e4058) > _e2746), true, !(_e2765));
                                            phi_6811_ = _e4079;
                                            phi_6812_ = _e4052;
                                            phi_6813_ = _e4056;
                                            phi_6814_ = _e4058;
                                            phi_6815_ = _e4060;
                                            phi_6816_ = _e4062;
                                            phi_6817_ = _e4082;
                                            phi_6818_ = select(true, false, _e4082);
                                            phi_6819_ = false;
                                            phi_6820_ = false;
                                            phi_6821_ = false;
                                            phi_6822_ = false;
                                        } else {
                                            phi_6811_ = _e2757;
                                            phi_6812_ = _e2759;
                                            phi_6813_ = _e2761;
                                            phi_6814_ = _e2763;
                                            phi_6815_ = _e2765;
                                            phi_6816_ = _e4050;
                                            phi_6817_ = _e4066;
                                            phi_6818_ = false;
                                            phi_6819_ = _e4068;
                                            phi_6820_ = _e4070;
                                            phi_6821_ = _e4072;
                                            phi_6822_ = _e4074;
                                        }
                                        let _e4085 = phi_6811_;
                                        let _e4087 = phi_6812_;
                                        let _e4089 = phi_6813_;
                                        let _e4091 = phi_6814_;
                                        let _e4093 = phi_6815_;
                                        let _e4095 = phi_6816_;
                                        let _e4097 = phi_6817_;
                                        let _e4099 = phi_6818_;
                                        let _e4101 = phi_6819_;
                                        let _e4103 = phi_6820_;
                                        let _e4105 = phi_6821_;
                                        let _e4107 = phi_6822_;
                                        phi_4601_ = _e4085;
                                        phi_4603_ = _e4087;
                                        phi_4605_ = _e4089;
                                        phi_4607_ = _e4091;
                                        phi_4609_ = _e4093;
                                        phi_4611_ = _e4095;
                                        phi_6823_ = _e4052;
                                        phi_6824_ = _e3868;
                                        phi_6825_ = _e4097;
                                        phi_6826_ = _e4099;
                                        phi_6827_ = _e4101;
                                        phi_6828_ = _e4103;
                                        phi_6829_ = _e4105;
                                        phi_6830_ = false;
                                        phi_6831_ = _e4107;
                                    } else {
                                        phi_4601_ = f64();
                                        phi_4603_ = f64();
                                        phi_4605_ = f64();
                                        phi_4607_ = f64();
                                        phi_4609_ = bool();
                                        phi_4611_ = u32();
                                        phi_6823_ = f64();
                                        phi_6824_ = f64();
                                        phi_6825_ = false;
                                        phi_6826_ = false;
                                        phi_6827_ = false;
                                        phi_6828_ = false;
                                        phi_6829_ = false;
                                        phi_6830_ = true;
                                        phi_6831_ = false;
                                    }
                                    let _e4109 = phi_4601_;
                                    let _e4111 = phi_4603_;
                                    let _e4113 = phi_4605_;
                                    let _e4115 = phi_4607_;
                                    let _e4117 = phi_4609_;
                                    let _e4119 = phi_4611_;
                                    let _e4121 = phi_6823_;
                                    let _e4123 = phi_6824_;
                                    let _e4125 = phi_6825_;
                                    let _e4127 = phi_6826_;
                                    let _e4129 = phi_6827_;
                                    let _e4131 = phi_6828_;
                                    let _e4133 = phi_6829_;
                                    let _e4135 = phi_6830_;
                                    let _e4137 = phi_6831_;
                                    local_22 = _e4127;
                                    local_23 = _e4129;
                                    local_24 = _e4127;
                                    local_25 = _e4131;
                                    local_26 = _e4127;
                                    local_27 = _e4133;
                                    local_28 = _e4127;
                                    local_29 = _e4135;
                                    local_30 = _e4127;
                                    local_31 = _e4137;
                                    local_33 = _e4127;
                                    local_34 = _e4123;
                                    local_35 = _e4121;
                                    continue;
                                    continuing {
                                        phi_4597_ = type_9(select(_e2755.member, (_e2755.member + 1u), _e2770), select(_e2755.member_1, _e2755.member_1, _e2770));
                                        phi_4600_ = _e4109;
                                        phi_4602_ = _e4111;
                                        phi_4604_ = _e4113;
                                        phi_4606_ = _e4115;
                                        phi_4608_ = _e4117;
                                        phi_4610_ = _e4119;
                                        break if !(_e4125);
                                    }
                                }
                                let _e4140 = local_22;
                                let _e4142 = local_23;
                                let _e4143 = select(_e4142, false, _e4140);
                                let _e4145 = local_24;
                                let _e4147 = local_25;
                                let _e4150 = local_26;
                                let _e4152 = local_27;
                                let _e4155 = local_28;
                                let _e4157 = local_29;
                                let _e4160 = local_30;
                                let _e4162 = local_31;
                                let _e4168 = local_32;
                                let _e4170 = select(select(_e4147, false, _e4145), false, _e4143);
                                let _e4173 = local_33;
                                let _e4180 = select(select(select(_e4152, false, _e4150), false, _e4143), false, _e4170);
                                let _e4186 = local_34;
                                let _e4188 = local_35;
                                let _e4190 = select(select(select(_e4173, false, _e4143), false, _e4170), true, _e4180);
                                let _e4195 = local_36;
                                let _e4197 = select(select(select(select(select(_e4157, false, _e4155), false, _e4143), false, _e4170), false, _e4180), true, _e4190);
                                let _e4204 = select(select(select(select(select(select(_e4162, false, _e4160), false, _e4143), false, _e4170), false, _e4180), false, _e4190), false, _e4197);
                                let _e4209 = select(select(select(select(select(_e4143, true, _e4170), false, _e4180), false, _e4190), false, _e4197), true, _e4204);
                                let _e4212 = (select(select(type_42().member, 1u, _e4197), select(select(select(type_42().member, 1u, _e4143), 0u, _e4170), 0u, _e4204), _e4209) != 0u);
                                phi_6899_ = select(select(type_42().member_1, select(_e4195, select(_e4188, _e4186, _e4180), _e4190), _e4197), select(select(select(type_42().member_1, _e4168, _e4143), type_42().member_1, _e4170), type_42().member_1, _e4204), _e4209);
                                phi_6900_ = select(true, false, _e4212);
                                phi_6901_ = _e4212;
                                phi_6902_ = false;
                                phi_6903_ = false;
                                phi_6904_ = false;
                            } else {
                                phi_6899_ = f64();
                                phi_6900_ = _e2532;
                                phi_6901_ = false;
                                phi_6902_ = _e2534;
                                phi_6903_ = _e2536;
                                phi_6904_ = _e2538;
                            }
                            let _e4215 = phi_6899_;
                            let _e4217 = phi_6900_;
                            let _e4219 = phi_6901_;
                            let _e4221 = phi_6902_;
                            let _e4223 = phi_6903_;
                            let _e4225 = phi_6904_;
                            phi_6905_ = _e2524;
                            phi_6906_ = _e2526;
                            phi_6907_ = _e4215;
                            phi_6908_ = _e2528;
                            phi_6909_ = _e4217;
                            phi_6910_ = _e4219;
                            phi_6911_ = false;
                            phi_6912_ = _e4221;
                            phi_6913_ = _e4223;
                            phi_6914_ = _e4225;
                        } else {
                            phi_6905_ = type_43();
                            phi_6906_ = bool();
                            phi_6907_ = f64();
                            phi_6908_ = type_43();
                            phi_6909_ = false;
                            phi_6910_ = false;
                            phi_6911_ = true;
                            phi_6912_ = false;
                            phi_6913_ = false;
                            phi_6914_ = false;
                        }
                        let _e4227 = phi_6905_;
                        let _e4229 = phi_6906_;
                        let _e4231 = phi_6907_;
                        let _e4233 = phi_6908_;
                        let _e4235 = phi_6909_;
                        let _e4237 = phi_6910_;
                        let _e4239 = phi_6911_;
                        let _e4241 = phi_6912_;
                        let _e4243 = phi_6913_;
                        let _e4245 = phi_6914_;
                        local_37 = _e4237;
                        local_38 = _e4229;
                        local_39 = _e4227;
                        local_40 = _e4231;
                        local_41 = _e4231;
                        local_42 = _e4231;
                        local_46 = _e4239;
                        local_47 = _e4241;
                        local_48 = _e4243;
                        local_49 = _e4245;
                        local_43 = _e4237;
                        local_44 = _e4233;
                        continue;
                        continuing {
                            phi_2697_ = type_9(select(_e1507.member, (_e1507.member + 1u), _e1510), select(_e1507.member_1, _e1507.member_1, _e1510));
                            break if !(_e4235);
                        }
                    }
                    let _e4248 = local_37;
                    if _e4248 {
                        let _e4250 = local_38;
                        if _e4250 {
                            let _e4252 = local_39;
                            let _e4255 = local_40;
                            let _e4257 = ((_e4252.member_1 - _e4255) <= _e1470);
                            let _e4262 = local_41;
                            phi_6930_ = type_42(select(type_42().member, 1u, _e4257), select(type_42().member_1, _e4262, _e4257));
                            phi_6931_ = select(true, false, _e4257);
                        } else {
                            phi_6930_ = type_42();
                            phi_6931_ = true;
                        }
                        let _e4267 = phi_6930_;
                        let _e4269 = phi_6931_;
                        let _e4274 = local_42;
                        phi_6937_ = type_42(select(_e4267.member, 2u, _e4269), select(_e4267.member_1, _e4274, _e4269));
                        phi_6938_ = false;
                        phi_6939_ = false;
                        phi_6940_ = false;
                        phi_6941_ = false;
                    } else {
                        phi_6937_ = type_42();
                        let _e4763 = local_46;
                        phi_6938_ = _e4763;
                        let _e4766 = local_47;
                        phi_6939_ = _e4766;
                        let _e4769 = local_48;
                        phi_6940_ = _e4769;
                        let _e4772 = local_49;
                        phi_6941_ = _e4772;
                    }
                    let _e4278 = phi_6937_;
                    let _e4280 = phi_6938_;
                    let _e4282 = phi_6939_;
                    let _e4284 = phi_6940_;
                    let _e4286 = phi_6941_;
                    let _e4293 = select(_e4282, false, _e4280);
                    let _e4297 = local_43;
                    let _e4304 = select(select(_e4284, false, _e4280), false, _e4293);
                    let _e4310 = select(select(select(_e4286, false, _e4280), false, _e4293), false, _e4304);
                    let _e4314 = local_44;
                    let _e4318 = select(select(_e4293, true, _e4304), true, _e4310);
                    phi_6983_ = type_42(select(_e4278.member, select(select(select(type_42().member, 0u, _e4293), 0u, _e4304), 1u, _e4310), _e4318), select(_e4278.member_1, select(select(select(type_42().member_1, type_42().member_1, _e4293), type_42().member_1, _e4304), _e4314.member, _e4310), _e4318));
                    phi_6984_ = type_42(select(type_42().member, 0u, _e4280), select(type_42().member_1, type_42().member_1, _e4280));
                    phi_6985_ = select(select(select(select(select(_e4297, false, _e4280), false, _e4293), false, _e4304), false, _e4310), true, _e4318);
                }
                let _e4329 = phi_6983_;
                let _e4331 = phi_6984_;
                let _e4333 = phi_6985_;
                let _e4336 = select(_e4331.member, _e4329.member, _e4333);
                let _e4339 = select(_e4331.member_1, _e4329.member_1, _e4333);
                let _e4345 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e4339 > _e534)), (_e4336 == 1u))));
                switch bitcast<i32>(_e4336) {
                    case 0: {
                        phi_7029_ = type_35(0u, _e4345, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4349 = function_2(_e4339);
                        phi_7029_ = type_35(0u, _e4345, _e4349, true);
                        break;
                    }
                    case 2: {
                        let _e4347 = function_2(_e4339);
                        phi_7029_ = type_35(1u, _e4345, _e4347, true);
                        break;
                    }
                    default: {
                        phi_7029_ = type_35();
                        break;
                    }
                }
                let _e4353 = phi_7029_;
                local_8 = type_35(_e4353.member, _e4353.member_1, array<u32, 2>(_e4353.member_2[0], _e4353.member_2[1]), _e4353.member_3);
                phi_7038_ = type_9(_e189, _e192);
            } else {
                phi_7038_ = type_9(0u, 0u);
            }
            let _e4363 = phi_7038_;
            let _e4369 = local_8.member;
            let _e4371 = select(true, false, (_e4369 == 0u));
            let _e4373 = local_8.member_3;
            if _e4373 {
                if _e4371 {
                    phi_7067_ = true;
                } else {
                    let _e4375 = params.member.member.member_1;
                    phi_7067_ = ((_e4375 & 16u) != 0u);
                }
                let _e4379 = phi_7067_;
                phi_7068_ = _e4379;
            } else {
                phi_7068_ = false;
            }
            let _e4381 = phi_7068_;
            let _e4383 = local_8.member_3;
            if _e4383 {
                if _e4371 {
                } else {
                    let _e4385 = local_8.member_2;
                    let _e4390 = ((_e4385[1] >> bitcast<u32>(20i)) & 2047u);
                    let _e4404 = atomicMin((&earliest.member[0u]), select(((((_e4390 - 896u) << bitcast<u32>(23i)) | ((_e4385[1] & 1048575u) << bitcast<u32>(3i))) | (_e4385[0] >> bitcast<u32>(29i))), 0u, (_e4390 <= 896u)));
                }
            }
            if (_e107 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4381 {
                let _e4408 = atomicAdd((&counters[0u]), 1u);
                phi_7112_ = _e4408;
            } else {
                phi_7112_ = 0u;
            }
            let _e4410 = phi_7112_;
            workgroupBarrier();
            if (_e107 == 0u) {
                let _e4413 = atomicLoad((&counters[0u]));
                if (_e4413 > 0u) {
                    let _e4416 = atomicAdd((&contacts.member[0u]), _e4413);
                    atomicStore((&counters[1u]), _e4416);
                }
            }
            workgroupBarrier();
            let _e4419 = atomicLoad((&counters[1u]));
            let _e4420 = (_e4419 + _e4410);
            if _e4381 {
                let _e4422 = params.member.member_1.member_3;
                if (_e4420 < _e4422) {
                    let _e4428 = (7u * _e4420);
                    atomicStore((&contacts.member[(4u + _e4428)]), select(1u, 0u, ((_e4363.member_1 & 2147483648u) == 0u)));
                    let _e4433 = local_8.member;
                    atomicStore((&contacts.member[(_e4428 + 5u)]), _e4433);
                    atomicStore((&contacts.member[(_e4428 + 6u)]), _e4363.member);
                    atomicStore((&contacts.member[(_e4428 + 7u)]), (_e4363.member_1 & 2147483647u));
                    let _e4442 = local_8.member_2[0u];
                    atomicStore((&contacts.member[(_e4428 + 8u)]), _e4442);
                    let _e4447 = local_8.member_2[1u];
                    atomicStore((&contacts.member[(_e4428 + 9u)]), _e4447);
                    let _e4451 = local_8.member_1;
                    atomicStore((&contacts.member[(_e4428 + 10u)]), _e4451);
                }
            }
        }
        continue;
        continuing {
            phi_553_ = type_9(select(_e160.member, (_e160.member + 1u), _e163), select(_e160.member_1, _e160.member_1, _e163));
            break if !(_e176);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn advance_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
