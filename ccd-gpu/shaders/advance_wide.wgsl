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
    var phi_247_: f64;
    var phi_290_: f64;
    var phi_333_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_247_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_247_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_247_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_290_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_290_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_290_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_333_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_333_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_333_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_1(param_1: ptr<function, type_39>, param_2: f64, param_3: f64, param_4: f64) -> bool {
    var phi_431_: bool;
    var phi_432_: bool;
    var phi_437_: bool;

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
            phi_431_ = select(bool(), ((_e45 > f64(0f)) == (_e72 > f64(0f))), _e87);
            phi_432_ = select(true, false, _e87);
        } else {
            phi_431_ = bool();
            phi_432_ = true;
        }
        let _e96 = phi_431_;
        let _e98 = phi_432_;
        phi_437_ = select(_e96, false, _e98);
    } else {
        phi_437_ = false;
    }
    let _e101 = phi_437_;
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
    var phi_7701_: array<array<f64, 3>, 4>;

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
        phi_7701_ = array<array<f64, 3>, 4>(array<f64, 3>((param_8[0] - (param_9[0] * _e171)), (param_8[1] - (param_9[1] * _e171)), (param_8[2] - (param_9[2] * _e171))), array<f64, 3>((param_8[0] - (param_10[0] * _e215)), (param_8[1] - (param_10[1] * _e215)), (param_8[2] - (param_10[2] * _e215))), array<f64, 3>((_e9 - (param_10[0] * _e256)), (_e12 - (param_10[1] * _e256)), (_e15 - (param_10[2] * _e256))), array<f64, 3>((_e269 - (param_9[0] * _e303)), (_e272 - (param_9[1] * _e303)), (_e275 - (param_9[2] * _e303))));
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
        phi_7701_ = array<array<f64, 3>, 4>(array<f64, 3>((param_8[0] - (param_9[0] * _e82)), (param_8[1] - (param_9[1] * _e82)), (param_8[2] - (param_9[2] * _e82))), array<f64, 3>((param_8[0] - (param_10[0] * _e126)), (param_8[1] - (param_10[1] * _e126)), (param_8[2] - (param_10[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_7701_;
    let _e319 = function_3(_e316[0], _e316[1]);
    let _e321 = function_3(_e319, _e316[2]);
    let _e323 = function_3(_e321, _e316[3]);
    return _e323;
}

fn function_5(param_12: array<f64, 3>, param_13: array<f64, 3>, param_14: array<f64, 3>, param_15: u32) -> array<f64, 3> {
    var phi_7300_: bool;
    var phi_7334_: array<f64, 3>;
    var phi_7335_: bool;
    var phi_7336_: array<f64, 3>;
    var phi_7337_: bool;
    var phi_7342_: array<f64, 3>;

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
        phi_7300_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_7300_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_7300_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_7334_ = array<f64, 3>((param_12[0] - ((param_13[0] * _e76) + (param_14[0] * _e80))), (param_12[1] - ((param_13[1] * _e76) + (param_14[1] * _e80))), (param_12[2] - ((param_13[2] * _e76) + (param_14[2] * _e80))));
            phi_7335_ = false;
        } else {
            phi_7334_ = array<f64, 3>();
            phi_7335_ = true;
        }
        let _e132 = phi_7334_;
        let _e134 = phi_7335_;
        phi_7336_ = _e132;
        phi_7337_ = _e134;
    } else {
        phi_7336_ = array<f64, 3>();
        phi_7337_ = true;
    }
    let _e136 = phi_7336_;
    let _e138 = phi_7337_;
    if _e138 {
        let _e139 = function_4(param_12, param_13, param_14, param_15);
        phi_7342_ = _e139;
    } else {
        phi_7342_ = _e136;
    }
    let _e141 = phi_7342_;
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
    var phi_504_: u32;
    var phi_549_: u32;
    var phi_552_: type_9;
    var phi_726_: type_23;
    var phi_922_: type_31;
    var phi_1083_: type_33;
    var phi_1579_: bool;
    var phi_1675_: type_41;
    var phi_1676_: bool;
    var phi_1677_: type_41;
    var phi_1678_: bool;
    var phi_1679_: type_41;
    var phi_1680_: bool;
    var phi_1685_: type_41;
    var phi_2387_: bool;
    var phi_2402_: f64;
    var phi_2478_: type_16;
    var phi_2481_: f64;
    var phi_2479_: type_16;
    var phi_2522_: type_17;
    var phi_2482_: f64;
    var local_9: f64;
    var phi_2535_: f64;
    var phi_2566_: type_9;
    var phi_2569_: u32;
    var phi_2636_: u32;
    var phi_2637_: u32;
    var phi_2570_: u32;
    var phi_2638_: u32;
    var phi_2696_: type_9;
    var phi_2856_: type_43;
    var phi_2857_: bool;
    var phi_2858_: type_43;
    var phi_2859_: bool;
    var phi_2894_: type_9;
    var phi_2897_: f64;
    var phi_2899_: f64;
    var phi_2901_: f64;
    var phi_3015_: bool;
    var phi_3022_: f64;
    var phi_3023_: bool;
    var phi_2898_: f64;
    var phi_2900_: f64;
    var phi_2902_: f64;
    var phi_3024_: f64;
    var phi_3025_: bool;
    var phi_3026_: bool;
    var local_10: bool;
    var local_11: f64;
    var local_12: f64;
    var phi_3031_: f64;
    var phi_3049_: type_9;
    var phi_3052_: f64;
    var phi_3118_: f64;
    var phi_3119_: bool;
    var phi_3120_: bool;
    var phi_3121_: bool;
    var phi_3122_: f64;
    var phi_3053_: f64;
    var phi_3123_: bool;
    var phi_3124_: bool;
    var phi_3125_: bool;
    var phi_3126_: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: f64;
    var phi_3140_: f64;
    var phi_3142_: type_43;
    var phi_4003_: array<type_36, 4>;
    var phi_4023_: type_9;
    var phi_4026_: bool;
    var phi_4027_: bool;
    var phi_4078_: bool;
    var phi_4079_: bool;
    var local_18: bool;
    var local_19: bool;
    var phi_4093_: u32;
    var phi_4094_: u32;
    var phi_4095_: bool;
    var phi_4126_: bool;
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
    var phi_4138_: type_43;
    var phi_4139_: bool;
    var phi_4140_: type_43;
    var phi_4141_: bool;
    var phi_4142_: bool;
    var phi_4143_: bool;
    var phi_4144_: bool;
    var phi_4145_: type_43;
    var phi_4146_: bool;
    var phi_4147_: type_43;
    var phi_4148_: bool;
    var phi_4149_: bool;
    var phi_4150_: bool;
    var phi_4151_: bool;
    var phi_4152_: bool;
    var phi_4160_: type_43;
    var phi_4161_: bool;
    var phi_4162_: type_43;
    var phi_4163_: bool;
    var phi_4164_: bool;
    var phi_4165_: bool;
    var phi_4166_: bool;
    var phi_4167_: bool;
    var phi_4596_: type_9;
    var phi_4599_: f64;
    var phi_4601_: f64;
    var phi_4603_: f64;
    var phi_4605_: f64;
    var phi_4607_: bool;
    var phi_4609_: u32;
    var phi_4761_: array<f64, 3>;
    var phi_4829_: type_16;
    var phi_4832_: f64;
    var phi_4830_: type_16;
    var phi_4873_: type_17;
    var phi_4833_: f64;
    var local_20: f64;
    var phi_4886_: f64;
    var phi_5012_: type_44;
    var phi_5013_: bool;
    var phi_5014_: type_44;
    var phi_5015_: bool;
    var phi_5025_: type_44;
    var phi_5197_: bool;
    var phi_5198_: bool;
    var phi_5199_: bool;
    var phi_5200_: bool;
    var phi_5201_: bool;
    var phi_5202_: bool;
    var phi_5504_: bool;
    var phi_5505_: bool;
    var phi_5506_: bool;
    var phi_5507_: bool;
    var phi_5508_: bool;
    var phi_5509_: bool;
    var phi_5517_: bool;
    var phi_5627_: f64;
    var phi_5628_: bool;
    var phi_5629_: f64;
    var phi_5630_: bool;
    var phi_5631_: f64;
    var phi_5632_: bool;
    var phi_5633_: bool;
    var phi_5699_: f64;
    var phi_5700_: bool;
    var phi_5701_: f64;
    var phi_5702_: bool;
    var phi_5703_: f64;
    var phi_5704_: bool;
    var phi_5705_: bool;
    var phi_5776_: f64;
    var phi_5777_: bool;
    var phi_5778_: f64;
    var phi_5779_: bool;
    var phi_5780_: f64;
    var phi_5781_: bool;
    var phi_5782_: bool;
    var phi_5848_: f64;
    var phi_5849_: bool;
    var phi_5850_: f64;
    var phi_5851_: bool;
    var phi_5852_: f64;
    var phi_5853_: bool;
    var phi_5854_: bool;
    var phi_6031_: type_16;
    var phi_6034_: f64;
    var phi_6032_: type_16;
    var phi_6075_: type_17;
    var phi_6035_: f64;
    var local_21: f64;
    var phi_6088_: f64;
    var phi_6365_: bool;
    var phi_6366_: bool;
    var phi_6393_: f64;
    var phi_6394_: f64;
    var phi_6395_: bool;
    var phi_6396_: f64;
    var phi_6397_: f64;
    var phi_6398_: bool;
    var phi_6399_: bool;
    var phi_6400_: f64;
    var phi_6401_: f64;
    var phi_6402_: f64;
    var phi_6403_: f64;
    var phi_6404_: bool;
    var phi_6405_: bool;
    var phi_6406_: bool;
    var phi_6407_: bool;
    var phi_6408_: f64;
    var phi_6409_: f64;
    var phi_6410_: f64;
    var phi_6411_: f64;
    var phi_6412_: bool;
    var phi_6413_: bool;
    var phi_6414_: bool;
    var phi_6415_: bool;
    var phi_6416_: bool;
    var phi_6417_: f64;
    var phi_6418_: f64;
    var phi_6419_: f64;
    var phi_6420_: f64;
    var phi_6421_: bool;
    var phi_6422_: bool;
    var phi_6423_: bool;
    var phi_6424_: bool;
    var phi_6425_: bool;
    var phi_6763_: f64;
    var phi_6765_: u32;
    var phi_6766_: f64;
    var phi_6767_: bool;
    var phi_6768_: bool;
    var phi_6769_: bool;
    var phi_6770_: u32;
    var phi_6771_: f64;
    var phi_6772_: f64;
    var phi_6773_: f64;
    var phi_6774_: f64;
    var phi_6775_: bool;
    var phi_6776_: u32;
    var phi_6777_: bool;
    var phi_6778_: bool;
    var phi_6779_: bool;
    var phi_6780_: bool;
    var phi_6781_: bool;
    var phi_6782_: bool;
    var phi_6810_: f64;
    var phi_6811_: f64;
    var phi_6812_: f64;
    var phi_6813_: f64;
    var phi_6814_: bool;
    var phi_6815_: u32;
    var phi_6816_: bool;
    var phi_6817_: bool;
    var phi_6818_: bool;
    var phi_6819_: bool;
    var phi_6820_: bool;
    var phi_6821_: bool;
    var phi_4600_: f64;
    var phi_4602_: f64;
    var phi_4604_: f64;
    var phi_4606_: f64;
    var phi_4608_: bool;
    var phi_4610_: u32;
    var phi_6822_: f64;
    var phi_6823_: f64;
    var phi_6824_: bool;
    var phi_6825_: bool;
    var phi_6826_: bool;
    var phi_6827_: bool;
    var phi_6828_: bool;
    var phi_6829_: bool;
    var phi_6830_: bool;
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
    var phi_6898_: f64;
    var phi_6899_: bool;
    var phi_6900_: bool;
    var phi_6901_: bool;
    var phi_6902_: bool;
    var phi_6903_: bool;
    var phi_6904_: type_43;
    var phi_6905_: bool;
    var phi_6906_: f64;
    var phi_6907_: type_43;
    var phi_6908_: bool;
    var phi_6909_: bool;
    var phi_6910_: bool;
    var phi_6911_: bool;
    var phi_6912_: bool;
    var phi_6913_: bool;
    var local_37: bool;
    var local_38: bool;
    var local_39: type_43;
    var local_40: f64;
    var local_41: f64;
    var phi_6929_: type_42;
    var phi_6930_: bool;
    var local_42: f64;
    var phi_6936_: type_42;
    var phi_6937_: bool;
    var phi_6938_: bool;
    var phi_6939_: bool;
    var phi_6940_: bool;
    var local_43: bool;
    var local_44: type_43;
    var phi_6982_: type_42;
    var phi_6983_: type_42;
    var phi_6984_: bool;
    var phi_7028_: type_35;
    var phi_7037_: type_9;
    var phi_7066_: bool;
    var phi_7067_: bool;
    var phi_7110_: u32;
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
        phi_504_ = (_e128 - _e133);
    } else {
        phi_504_ = 0u;
    }
    let _e136 = phi_504_;
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
        phi_549_ = select(_e149, (_e149 + 1u), ((_e147 % _e121) > 0u));
    } else {
        phi_549_ = 0u;
    }
    let _e156 = phi_549_;
    phi_552_ = type_9(0u, _e156);
    loop {
        let _e159 = phi_552_;
        let _e162 = (_e159.member < _e159.member_1);
        let _e175 = (bitcast<i32>(select(0u, 1u, _e162)) != 0i);
        if _e175 {
            let _e179 = (((_e118 + (select(type_9().member_1, _e159.member, _e162) * _e121)) * 64u) + _e106);
            local_8 = type_35(0u, 0u, array<u32, 2>(0u, 0u), false);
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
                    phi_726_ = type_23(0u, array<u32, 4>(_e188, _e220, _e223, _e226));
                } else {
                    let _e199 = (2u * _e188);
                    let _e201 = elements.member[_e199];
                    let _e204 = elements.member[(_e199 + 1u)];
                    let _e205 = (2u * _e196);
                    let _e207 = elements.member[_e205];
                    let _e210 = elements.member[(_e205 + 1u)];
                    phi_726_ = type_23(1u, array<u32, 4>(_e201, _e204, _e207, _e210));
                }
                let _e230 = phi_726_;
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
                    phi_922_ = type_31(array<array<f64, 3>, 4>(_e344, _e345, _e346, _e347), array<array<f64, 3>, 4>(_e349, _e350, _e351, _e352));
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
                    phi_922_ = type_31(array<array<f64, 3>, 4>(_e239, _e248, _e257, _e266), array<array<f64, 3>, 4>(_e245, _e254, _e263, _e272));
                }
                let _e356 = phi_922_;
                if (_e230.member != 0u) {
                    phi_1083_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e356.member[2][0] - _e356.member[0][0]), (_e356.member[2][1] - _e356.member[0][1]), (_e356.member[2][2] - _e356.member[0][2])), array<f64, 3>((_e356.member_1[2][0] - _e356.member_1[0][0]), (_e356.member_1[2][1] - _e356.member_1[0][1]), (_e356.member_1[2][2] - _e356.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e356.member[1][0] - _e356.member[0][0]), (_e356.member[1][1] - _e356.member[0][1]), (_e356.member[1][2] - _e356.member[0][2])), array<f64, 3>((_e356.member_1[1][0] - _e356.member_1[0][0]), (_e356.member_1[1][1] - _e356.member_1[0][1]), (_e356.member_1[1][2] - _e356.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e356.member[2][0] - _e356.member[3][0]), (_e356.member[2][1] - _e356.member[3][1]), (_e356.member[2][2] - _e356.member[3][2])), array<f64, 3>((_e356.member_1[2][0] - _e356.member_1[3][0]), (_e356.member_1[2][1] - _e356.member_1[3][1]), (_e356.member_1[2][2] - _e356.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_1083_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e356.member[0][0] - _e356.member[1][0]), (_e356.member[0][1] - _e356.member[1][1]), (_e356.member[0][2] - _e356.member[1][2])), array<f64, 3>((_e356.member_1[0][0] - _e356.member_1[1][0]), (_e356.member_1[0][1] - _e356.member_1[1][1]), (_e356.member_1[0][2] - _e356.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e356.member[2][0] - _e356.member[1][0]), (_e356.member[2][1] - _e356.member[1][1]), (_e356.member[2][2] - _e356.member[1][2])), array<f64, 3>((_e356.member_1[2][0] - _e356.member_1[1][0]), (_e356.member_1[2][1] - _e356.member_1[1][1]), (_e356.member_1[2][2] - _e356.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e356.member[3][0] - _e356.member[1][0]), (_e356.member[3][1] - _e356.member[1][1]), (_e356.member[3][2] - _e356.member[1][2])), array<f64, 3>((_e356.member_1[3][0] - _e356.member_1[1][0]), (_e356.member_1[3][1] - _e356.member_1[1][1]), (_e356.member_1[3][2] - _e356.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e515 = phi_1083_;
                let _e517 = params.member.member.member_14;
                let _e524 = bitcast<f64>(((u64(_e517[1]) * 4294967296lu) + u64(_e517[0])));
                let _e526 = params.member.member.member_15;
                let _e533 = bitcast<f64>(((u64(_e526[1]) * 4294967296lu) + u64(_e526[0])));
                let _e535 = params.member.member.member_16;
                let _e542 = bitcast<f64>(((u64(_e535[1]) * 4294967296lu) + u64(_e535[0])));
                let _e544 = params.member.member.member_16;
                let _e551 = bitcast<f64>(((u64(_e544[1]) * 4294967296lu) + u64(_e544[0])));
                let _e552 = f64(0f);
                let _e558 = select(_e515.member[0][0], -(_e515.member[0][0]), (_e515.member[0][0] < 0.0lf));
                let _e562 = select(_e515.member[0][1], -(_e515.member[0][1]), (_e515.member[0][1] < 0.0lf));
                let _e564 = select(_e562, _e558, (_e558 > _e562));
                let _e568 = select(_e515.member[0][2], -(_e515.member[0][2]), (_e515.member[0][2] < 0.0lf));
                let _e570 = select(_e568, _e564, (_e564 > _e568));
                let _e576 = select(_e515.member[1][0], -(_e515.member[1][0]), (_e515.member[1][0] < 0.0lf));
                let _e580 = select(_e515.member[1][1], -(_e515.member[1][1]), (_e515.member[1][1] < 0.0lf));
                let _e582 = select(_e580, _e576, (_e576 > _e580));
                let _e586 = select(_e515.member[1][2], -(_e515.member[1][2]), (_e515.member[1][2] < 0.0lf));
                let _e588 = select(_e586, _e582, (_e582 > _e586));
                let _e592 = (select(_e588, _e570, (_e570 > _e588)) + _e515.member_3);
                let _e598 = select(_e515.member_1[0][0], -(_e515.member_1[0][0]), (_e515.member_1[0][0] < 0.0lf));
                let _e602 = select(_e515.member_1[0][1], -(_e515.member_1[0][1]), (_e515.member_1[0][1] < 0.0lf));
                let _e604 = select(_e602, _e598, (_e598 > _e602));
                let _e608 = select(_e515.member_1[0][2], -(_e515.member_1[0][2]), (_e515.member_1[0][2] < 0.0lf));
                let _e610 = select(_e608, _e604, (_e604 > _e608));
                let _e616 = select(_e515.member_1[1][0], -(_e515.member_1[1][0]), (_e515.member_1[1][0] < 0.0lf));
                let _e620 = select(_e515.member_1[1][1], -(_e515.member_1[1][1]), (_e515.member_1[1][1] < 0.0lf));
                let _e622 = select(_e620, _e616, (_e616 > _e620));
                let _e626 = select(_e515.member_1[1][2], -(_e515.member_1[1][2]), (_e515.member_1[1][2] < 0.0lf));
                let _e628 = select(_e626, _e622, (_e622 > _e626));
                let _e632 = (select(_e628, _e610, (_e610 > _e628)) + _e515.member_3);
                let _e638 = select(_e515.member_2[0][0], -(_e515.member_2[0][0]), (_e515.member_2[0][0] < 0.0lf));
                let _e642 = select(_e515.member_2[0][1], -(_e515.member_2[0][1]), (_e515.member_2[0][1] < 0.0lf));
                let _e644 = select(_e642, _e638, (_e638 > _e642));
                let _e648 = select(_e515.member_2[0][2], -(_e515.member_2[0][2]), (_e515.member_2[0][2] < 0.0lf));
                let _e650 = select(_e648, _e644, (_e644 > _e648));
                let _e656 = select(_e515.member_2[1][0], -(_e515.member_2[1][0]), (_e515.member_2[1][0] < 0.0lf));
                let _e660 = select(_e515.member_2[1][1], -(_e515.member_2[1][1]), (_e515.member_2[1][1] < 0.0lf));
                let _e662 = select(_e660, _e656, (_e656 > _e660));
                let _e666 = select(_e515.member_2[1][2], -(_e515.member_2[1][2]), (_e515.member_2[1][2] < 0.0lf));
                let _e668 = select(_e666, _e662, (_e662 > _e666));
                let _e672 = (select(_e668, _e650, (_e650 > _e668)) + _e515.member_3);
                let _e674 = select(_e632, _e592, (_e592 > _e632));
                let _e676 = select(_e672, _e674, (_e674 > _e672));
                let _e682 = select(_e515.member[0][0], -(_e515.member[0][0]), (_e515.member[0][0] < 0.0lf));
                let _e686 = select(_e515.member[0][1], -(_e515.member[0][1]), (_e515.member[0][1] < 0.0lf));
                let _e688 = select(_e686, _e682, (_e682 > _e686));
                let _e692 = select(_e515.member[0][2], -(_e515.member[0][2]), (_e515.member[0][2] < 0.0lf));
                let _e694 = select(_e692, _e688, (_e688 > _e692));
                let _e700 = select(_e515.member[1][0], -(_e515.member[1][0]), (_e515.member[1][0] < 0.0lf));
                let _e704 = select(_e515.member[1][1], -(_e515.member[1][1]), (_e515.member[1][1] < 0.0lf));
                let _e706 = select(_e704, _e700, (_e700 > _e704));
                let _e710 = select(_e515.member[1][2], -(_e515.member[1][2]), (_e515.member[1][2] < 0.0lf));
                let _e712 = select(_e710, _e706, (_e706 > _e710));
                let _e716 = (select(_e712, _e694, (_e694 > _e712)) + _e515.member_3);
                let _e722 = select(_e515.member_1[0][0], -(_e515.member_1[0][0]), (_e515.member_1[0][0] < 0.0lf));
                let _e726 = select(_e515.member_1[0][1], -(_e515.member_1[0][1]), (_e515.member_1[0][1] < 0.0lf));
                let _e728 = select(_e726, _e722, (_e722 > _e726));
                let _e732 = select(_e515.member_1[0][2], -(_e515.member_1[0][2]), (_e515.member_1[0][2] < 0.0lf));
                let _e734 = select(_e732, _e728, (_e728 > _e732));
                let _e740 = select(_e515.member_1[1][0], -(_e515.member_1[1][0]), (_e515.member_1[1][0] < 0.0lf));
                let _e744 = select(_e515.member_1[1][1], -(_e515.member_1[1][1]), (_e515.member_1[1][1] < 0.0lf));
                let _e746 = select(_e744, _e740, (_e740 > _e744));
                let _e750 = select(_e515.member_1[1][2], -(_e515.member_1[1][2]), (_e515.member_1[1][2] < 0.0lf));
                let _e752 = select(_e750, _e746, (_e746 > _e750));
                let _e756 = (select(_e752, _e734, (_e734 > _e752)) + _e515.member_3);
                let _e762 = select(_e515.member_2[0][0], -(_e515.member_2[0][0]), (_e515.member_2[0][0] < 0.0lf));
                let _e766 = select(_e515.member_2[0][1], -(_e515.member_2[0][1]), (_e515.member_2[0][1] < 0.0lf));
                let _e768 = select(_e766, _e762, (_e762 > _e766));
                let _e772 = select(_e515.member_2[0][2], -(_e515.member_2[0][2]), (_e515.member_2[0][2] < 0.0lf));
                let _e774 = select(_e772, _e768, (_e768 > _e772));
                let _e780 = select(_e515.member_2[1][0], -(_e515.member_2[1][0]), (_e515.member_2[1][0] < 0.0lf));
                let _e784 = select(_e515.member_2[1][1], -(_e515.member_2[1][1]), (_e515.member_2[1][1] < 0.0lf));
                let _e786 = select(_e784, _e780, (_e780 > _e784));
                let _e790 = select(_e515.member_2[1][2], -(_e515.member_2[1][2]), (_e515.member_2[1][2] < 0.0lf));
                let _e792 = select(_e790, _e786, (_e786 > _e790));
                let _e796 = (select(_e792, _e774, (_e774 > _e792)) + _e515.member_3);
                let _e798 = select(_e756, _e716, (_e716 > _e756));
                let _e800 = select(_e796, _e798, (_e798 > _e796));
                if (_e800 <= f64(65536f)) {
                    phi_1579_ = (_e800 >= f64((1f / 65536f)));
                } else {
                    phi_1579_ = false;
                }
                let _e807 = phi_1579_;
                if _e807 {
                    phi_1679_ = type_41();
                    phi_1680_ = true;
                } else {
                    if (_e676 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e676) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e814 = (9214364837600034816lu - (bitcast<u64>(_e676) & 9218868437227405312lu));
                            let _e817 = bitcast<f64>(select(4503599627370496lu, _e814, (_e814 > 4503599627370496lu)));
                            let _e818 = (_e552 * _e817);
                            phi_1675_ = type_41(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e515.member[0][0] * _e817), (_e515.member[0][1] * _e817), (_e515.member[0][2] * _e817)), array<f64, 3>((_e515.member[1][0] * _e817), (_e515.member[1][1] * _e817), (_e515.member[1][2] * _e817))), array<array<f64, 3>, 2>(array<f64, 3>((_e515.member_1[0][0] * _e817), (_e515.member_1[0][1] * _e817), (_e515.member_1[0][2] * _e817)), array<f64, 3>((_e515.member_1[1][0] * _e817), (_e515.member_1[1][1] * _e817), (_e515.member_1[1][2] * _e817))), array<array<f64, 3>, 2>(array<f64, 3>((_e515.member_2[0][0] * _e817), (_e515.member_2[0][1] * _e817), (_e515.member_2[0][2] * _e817)), array<f64, 3>((_e515.member_2[1][0] * _e817), (_e515.member_2[1][1] * _e817), (_e515.member_2[1][2] * _e817))), ((_e515.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e817)), select(_e818, select(2.2250738585072014e-308lf, _e818, (_e818 > 2.2250738585072014e-308lf)), (_e552 > f64(0f))));
                            phi_1676_ = false;
                        } else {
                            phi_1675_ = type_41();
                            phi_1676_ = true;
                        }
                        let _e889 = phi_1675_;
                        let _e891 = phi_1676_;
                        phi_1677_ = _e889;
                        phi_1678_ = _e891;
                    } else {
                        phi_1677_ = type_41();
                        phi_1678_ = true;
                    }
                    let _e893 = phi_1677_;
                    let _e895 = phi_1678_;
                    phi_1679_ = _e893;
                    phi_1680_ = _e895;
                }
                let _e897 = phi_1679_;
                let _e899 = phi_1680_;
                if _e899 {
                    phi_1685_ = type_41(_e515, _e552);
                } else {
                    phi_1685_ = _e897;
                }
                let _e902 = phi_1685_;
                local_7 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e902.member.member[0][0], _e902.member.member[0][1], _e902.member.member[0][2]), array<f64, 3>(_e902.member.member[1][0], _e902.member.member[1][1], _e902.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e902.member.member_1[0][0], _e902.member.member_1[0][1], _e902.member.member_1[0][2]), array<f64, 3>(_e902.member.member_1[1][0], _e902.member.member_1[1][1], _e902.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e902.member.member_2[0][0], _e902.member.member_2[0][1], _e902.member.member_2[0][2]), array<f64, 3>(_e902.member.member_2[1][0], _e902.member.member_2[1][1], _e902.member.member_2[1][2])), _e902.member.member_3);
                let _e944 = local_7.member_1[0u];
                let _e950 = local_7.member_2[0u];
                let _e956 = ((_e944[1] * _e950[2]) - (_e944[2] * _e950[1]));
                let _e959 = ((_e944[2] * _e950[0]) - (_e944[0] * _e950[2]));
                let _e962 = ((_e944[0] * _e950[1]) - (_e944[1] * _e950[0]));
                let _e965 = local_7.member_1[1u];
                let _e971 = local_7.member_2[1u];
                let _e977 = ((_e965[1] * _e971[2]) - (_e965[2] * _e971[1]));
                let _e980 = ((_e965[2] * _e971[0]) - (_e965[0] * _e971[2]));
                let _e983 = ((_e965[0] * _e971[1]) - (_e965[1] * _e971[0]));
                let _e986 = local_7.member_1[0u];
                let _e992 = local_7.member_2[1u];
                let _e1007 = local_7.member_1[1u];
                let _e1013 = local_7.member_2[0u];
                let _e1026 = (((_e986[1] * _e992[2]) - (_e986[2] * _e992[1])) + ((_e1007[1] * _e1013[2]) - (_e1007[2] * _e1013[1])));
                let _e1027 = (((_e986[2] * _e992[0]) - (_e986[0] * _e992[2])) + ((_e1007[2] * _e1013[0]) - (_e1007[0] * _e1013[2])));
                let _e1028 = (((_e986[0] * _e992[1]) - (_e986[1] * _e992[0])) + ((_e1007[0] * _e1013[1]) - (_e1007[1] * _e1013[0])));
                let _e1031 = local_7.member[0u];
                let _e1039 = (((_e1031[0] * _e956) + (_e1031[1] * _e959)) + (_e1031[2] * _e962));
                let _e1042 = local_7.member[1u];
                let _e1053 = local_7.member[0u];
                let _e1062 = ((((_e1042[0] * _e956) + (_e1042[1] * _e959)) + (_e1042[2] * _e962)) + (((_e1053[0] * _e1026) + (_e1053[1] * _e1027)) + (_e1053[2] * _e1028)));
                let _e1065 = local_7.member[0u];
                let _e1076 = local_7.member[1u];
                let _e1085 = ((((_e1065[0] * _e977) + (_e1065[1] * _e980)) + (_e1065[2] * _e983)) + (((_e1076[0] * _e1026) + (_e1076[1] * _e1027)) + (_e1076[2] * _e1028)));
                let _e1088 = local_7.member[1u];
                let _e1096 = (((_e1088[0] * _e977) + (_e1088[1] * _e980)) + (_e1088[2] * _e983));
                let _e1099 = local_7.member[0u];
                let _e1105 = select(_e1099[0], -(_e1099[0]), (_e1099[0] < 0.0lf));
                let _e1108 = select(_e1099[1], -(_e1099[1]), (_e1099[1] < 0.0lf));
                let _e1110 = select(_e1108, _e1105, (_e1105 > _e1108));
                let _e1113 = select(_e1099[2], -(_e1099[2]), (_e1099[2] < 0.0lf));
                let _e1115 = select(_e1113, _e1110, (_e1110 > _e1113));
                let _e1118 = local_7.member[1u];
                let _e1124 = select(_e1118[0], -(_e1118[0]), (_e1118[0] < 0.0lf));
                let _e1127 = select(_e1118[1], -(_e1118[1]), (_e1118[1] < 0.0lf));
                let _e1129 = select(_e1127, _e1124, (_e1124 > _e1127));
                let _e1132 = select(_e1118[2], -(_e1118[2]), (_e1118[2] < 0.0lf));
                let _e1134 = select(_e1132, _e1129, (_e1129 > _e1132));
                let _e1138 = local_7.member_3;
                let _e1139 = (select(_e1134, _e1115, (_e1115 > _e1134)) + _e1138);
                let _e1142 = local_7.member_1[0u];
                let _e1148 = select(_e1142[0], -(_e1142[0]), (_e1142[0] < 0.0lf));
                let _e1151 = select(_e1142[1], -(_e1142[1]), (_e1142[1] < 0.0lf));
                let _e1153 = select(_e1151, _e1148, (_e1148 > _e1151));
                let _e1156 = select(_e1142[2], -(_e1142[2]), (_e1142[2] < 0.0lf));
                let _e1158 = select(_e1156, _e1153, (_e1153 > _e1156));
                let _e1161 = local_7.member_1[1u];
                let _e1167 = select(_e1161[0], -(_e1161[0]), (_e1161[0] < 0.0lf));
                let _e1170 = select(_e1161[1], -(_e1161[1]), (_e1161[1] < 0.0lf));
                let _e1172 = select(_e1170, _e1167, (_e1167 > _e1170));
                let _e1175 = select(_e1161[2], -(_e1161[2]), (_e1161[2] < 0.0lf));
                let _e1177 = select(_e1175, _e1172, (_e1172 > _e1175));
                let _e1181 = local_7.member_3;
                let _e1182 = (select(_e1177, _e1158, (_e1158 > _e1177)) + _e1181);
                let _e1185 = local_7.member_2[0u];
                let _e1191 = select(_e1185[0], -(_e1185[0]), (_e1185[0] < 0.0lf));
                let _e1194 = select(_e1185[1], -(_e1185[1]), (_e1185[1] < 0.0lf));
                let _e1196 = select(_e1194, _e1191, (_e1191 > _e1194));
                let _e1199 = select(_e1185[2], -(_e1185[2]), (_e1185[2] < 0.0lf));
                let _e1201 = select(_e1199, _e1196, (_e1196 > _e1199));
                let _e1204 = local_7.member_2[1u];
                let _e1210 = select(_e1204[0], -(_e1204[0]), (_e1204[0] < 0.0lf));
                let _e1213 = select(_e1204[1], -(_e1204[1]), (_e1204[1] < 0.0lf));
                let _e1215 = select(_e1213, _e1210, (_e1210 > _e1213));
                let _e1218 = select(_e1204[2], -(_e1204[2]), (_e1204[2] < 0.0lf));
                let _e1220 = select(_e1218, _e1215, (_e1215 > _e1218));
                let _e1224 = local_7.member_3;
                let _e1225 = (select(_e1220, _e1201, (_e1201 > _e1220)) + _e1224);
                let _e1226 = f64(1f);
                let _e1227 = f64(8f);
                let _e1237 = local_7.member_3;
                let _e1254 = (((((_e1139 * _e1227) * ((_e1182 * _e1227) * _e1225)) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1237 * f64(19f)) * ((_e1139 * (_e1182 + _e1225)) + (_e1182 * _e1225)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1226 + _e1139) * ((_e1226 + _e1182) * (_e1226 + _e1225)))));
                let _e1255 = f64(0f);
                let _e1256 = f64(3f);
                let _e1257 = (_e1039 * _e1256);
                let _e1258 = (_e1096 * _e1256);
                let _e1260 = select(_e1258, _e1257, (_e1257 < _e1258));
                let _e1262 = select(_e1085, _e1062, (_e1062 < _e1085));
                let _e1264 = select(_e1262, _e1260, (_e1260 < _e1262));
                let _e1266 = select(_e1258, _e1257, (_e1257 > _e1258));
                let _e1268 = select(_e1085, _e1062, (_e1062 > _e1085));
                let _e1271 = -(select(_e1268, _e1266, (_e1266 > _e1268)));
                if (select(_e1271, _e1264, (_e1264 > _e1271)) > _e1254) {
                    phi_6982_ = type_42(0u, type_42().member_1);
                    phi_6983_ = type_42();
                    phi_6984_ = true;
                } else {
                    let _e1279 = select(_e1039, -(_e1039), (_e1039 < 0.0lf));
                    let _e1282 = select(_e1062, -(_e1062), (_e1062 < 0.0lf));
                    let _e1284 = select(_e1282, _e1279, (_e1279 > _e1282));
                    let _e1287 = select(_e1085, -(_e1085), (_e1085 < 0.0lf));
                    let _e1290 = select(_e1096, -(_e1096), (_e1096 < 0.0lf));
                    let _e1292 = select(_e1290, _e1287, (_e1287 > _e1290));
                    let _e1294 = select(_e1292, _e1284, (_e1284 > _e1292));
                    let _e1296 = (2.2250738585072014e-308lf * f64(67108864f));
                    let _e1297 = f64(1f);
                    if (_e1294 >= _e1296) {
                        phi_2387_ = (_e1294 <= (_e1297 / _e1296));
                    } else {
                        phi_2387_ = false;
                    }
                    let _e1302 = phi_2387_;
                    if _e1302 {
                        phi_2402_ = (_e1297 / _e1294);
                    } else {
                        phi_2402_ = f64(0f);
                    }
                    let _e1312 = phi_2402_;
                    let _e1313 = f64(0.00000000000022737368f);
                    let _e1315 = (_e524 * f64(0.0625f));
                    local_5 = type_39(array<f64, 4>(_e1039, _e1062, _e1085, _e1096), ((_e1254 * f64(0.34f)) + (_e1294 * select(f64(2f), (1.1102230246251565e-16lf * f64(256f)), _e1302))), _e1312, select(_e1315, _e1313, (_e1313 < _e1315)));
                    let _e1320 = f64(0f);
                    let _e1321 = f64(1f);
                    let _e1322 = f64(3f);
                    let _e1325 = local_5.member[0u];
                    let _e1328 = local_5.member[1u];
                    let _e1331 = local_5.member[2u];
                    let _e1334 = local_5.member[3u];
                    let _e1341 = local_5.member_2;
                    let _e1342 = ((_e1328 - (_e1322 * _e1325)) * _e1341);
                    let _e1344 = local_5.member_2;
                    let _e1345 = ((_e1331 - _e1328) * _e1344);
                    let _e1347 = local_5.member_2;
                    let _e1348 = (((_e1322 * _e1334) - _e1331) * _e1347);
                    local_3[0u] = _e1320;
                    local_3[1u] = _e1321;
                    local_3[2u] = _e1321;
                    local_3[3u] = _e1321;
                    let _e1355 = ((_e1345 * _e1345) - (_e1342 * _e1348));
                    if (_e1355 > _e1320) {
                        if (_e1355 <= 2.2250738585072014e-308lf) {
                            phi_2535_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1355 > 0.0lf));
                        } else {
                            phi_2478_ = type_16(0i, 5i);
                            phi_2481_ = bitcast<f64>(((bitcast<u64>(_e1355) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1363 = phi_2478_;
                                let _e1365 = phi_2481_;
                                local_9 = _e1365;
                                if (_e1363.member < _e1363.member_1) {
                                    let _e1372 = (_e1363.member + 1i);
                                    phi_2479_ = type_16(select(_e1372, type_17().member_1, select(false, true, ((false == (_e1372 > _e1363.member)) != false))), _e1363.member_1);
                                    phi_2522_ = type_17(1u, _e1363.member);
                                } else {
                                    phi_2479_ = _e1363;
                                    phi_2522_ = type_17(0u, type_17().member_1);
                                }
                                let _e1383 = phi_2479_;
                                let _e1385 = phi_2522_;
                                let _e1388 = (bitcast<i32>(_e1385.member) != 0i);
                                if _e1388 {
                                    phi_2482_ = (0.5lf * (_e1365 + (_e1355 / _e1365)));
                                } else {
                                    phi_2482_ = f64();
                                }
                                let _e1393 = phi_2482_;
                                continue;
                                continuing {
                                    phi_2478_ = _e1383;
                                    phi_2481_ = _e1393;
                                    break if !(_e1388);
                                }
                            }
                            let _e1398 = local_9;
                            phi_2535_ = (_e1398 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1404 = phi_2535_;
                        let _e1409 = -((_e1345 + select(_e1404, -(_e1404), (_e1345 < _e1320))));
                        local_4[0u] = (_e1409 / (_e1409 + _e1348));
                        local_4[1u] = (_e1342 / (_e1342 + _e1409));
                        let _e1418 = local_4[1u];
                        let _e1419 = local_4[0u];
                        if (_e1418 < _e1419) {
                            let _e1422 = local_4[1u];
                            let _e1424 = local_4[0u];
                            local_4[0u] = _e1422;
                            local_4[1u] = _e1424;
                        }
                        phi_2566_ = type_9(0u, 2u);
                        phi_2569_ = 1u;
                        loop {
                            let _e1428 = phi_2566_;
                            let _e1430 = phi_2569_;
                            local_45 = _e1430;
                            let _e1433 = (_e1428.member < _e1428.member_1);
                            let _e1444 = select(type_9().member_1, _e1428.member, _e1433);
                            let _e1446 = (bitcast<i32>(select(0u, 1u, _e1433)) != 0i);
                            if _e1446 {
                                let _e1448 = local_4[_e1444];
                                if (_e1448 > _e1320) {
                                    let _e1451 = local_4[_e1444];
                                    if (_e1451 < _e1321) {
                                        let _e1454 = local_4[_e1444];
                                        local_3[_e1430] = _e1454;
                                        phi_2636_ = (_e1430 + 1u);
                                    } else {
                                        phi_2636_ = _e1430;
                                    }
                                    let _e1458 = phi_2636_;
                                    phi_2637_ = _e1458;
                                } else {
                                    phi_2637_ = _e1430;
                                }
                                let _e1460 = phi_2637_;
                                phi_2570_ = _e1460;
                            } else {
                                phi_2570_ = u32();
                            }
                            let _e1462 = phi_2570_;
                            continue;
                            continuing {
                                phi_2566_ = type_9(select(_e1428.member, (_e1428.member + 1u), _e1433), select(_e1428.member_1, _e1428.member_1, _e1433));
                                phi_2569_ = _e1462;
                                break if !(_e1446);
                            }
                        }
                        let _e4482 = local_45;
                        phi_2638_ = _e4482;
                    } else {
                        phi_2638_ = 1u;
                    }
                    let _e1465 = phi_2638_;
                    local_3[_e1465] = _e1321;
                    let _e1467 = local_3;
                    local_6 = _e1467;
                    let _e1469 = (_e524 * f64(0.99f));
                    let _e1471 = (f64(1f) - _e533);
                    let _e1474 = local_5.member[0u];
                    let _e1477 = local_5.member[1u];
                    let _e1480 = local_5.member[2u];
                    let _e1483 = local_5.member[3u];
                    let _e1494 = ((((_e1474 * _e1471) + (_e1477 * _e533)) * (_e1471 * _e1471)) + (((_e1480 * _e1471) + (_e1483 * _e533)) * (_e533 * _e533)));
                    let _e1499 = local_5.member_1;
                    phi_2696_ = type_9(select(1u, 0u, !((select(_e1494, -(_e1494), (_e1494 < 0.0lf)) > _e1499))), (_e1465 + 1u));
                    loop {
                        let _e1506 = phi_2696_;
                        let _e1509 = (_e1506.member < _e1506.member_1);
                        let _e1520 = select(type_9().member_1, _e1506.member, _e1509);
                        if (bitcast<i32>(select(0u, 1u, _e1509)) != 0i) {
                            if (_e1520 > 0u) {
                                let _e1527 = local_6[(_e1520 - 1u)];
                                let _e1529 = select(_e533, _e1527, (_e1527 > _e533));
                                let _e1531 = local_6[_e1520];
                                let _e1533 = select(_e542, _e1531, (_e1531 < _e542));
                                if (_e1529 <= _e1533) {
                                    let _e1535 = function_1((&local_5), _e551, _e1529, _e1533);
                                    if _e1535 {
                                        phi_4138_ = type_43();
                                        phi_4139_ = bool();
                                        phi_4140_ = type_43();
                                        phi_4141_ = false;
                                        phi_4142_ = false;
                                        phi_4143_ = false;
                                        phi_4144_ = false;
                                    } else {
                                        let _e1537 = (f64(1f) - _e1529);
                                        let _e1540 = local_5.member[0u];
                                        let _e1543 = local_5.member[1u];
                                        let _e1546 = local_5.member[2u];
                                        let _e1549 = local_5.member[3u];
                                        let _e1560 = ((((_e1540 * _e1537) + (_e1543 * _e1529)) * (_e1537 * _e1537)) + (((_e1546 * _e1537) + (_e1549 * _e1529)) * (_e1529 * _e1529)));
                                        let _e1562 = (f64(1f) - _e1533);
                                        let _e1565 = local_5.member[0u];
                                        let _e1568 = local_5.member[1u];
                                        let _e1571 = local_5.member[2u];
                                        let _e1574 = local_5.member[3u];
                                        let _e1585 = ((((_e1565 * _e1562) + (_e1568 * _e1533)) * (_e1562 * _e1562)) + (((_e1571 * _e1562) + (_e1574 * _e1533)) * (_e1533 * _e1533)));
                                        let _e1590 = local_5.member_1;
                                        let _e1591 = (select(_e1560, -(_e1560), (_e1560 < 0.0lf)) > _e1590);
                                        let _e1596 = local_5.member_1;
                                        let _e1597 = (select(_e1585, -(_e1585), (_e1585 < 0.0lf)) > _e1596);
                                        let _e1598 = f64(0f);
                                        let _e1606 = select(select(bool(), select(bool(), ((_e1560 > _e1598) != (_e1585 > _e1598)), _e1597), _e1591), false, select(true, select(true, false, _e1597), _e1591));
                                        if _e1591 {
                                            if _e1597 {
                                                phi_2856_ = type_43(select(f64(1f), type_43().member, _e1606), select(_e1598, type_43().member_1, _e1606), select(_e1606, type_43().member_2, _e1606));
                                                phi_2857_ = _e1606;
                                            } else {
                                                phi_2856_ = type_43();
                                                phi_2857_ = true;
                                            }
                                            let _e1616 = phi_2856_;
                                            let _e1618 = phi_2857_;
                                            phi_2858_ = _e1616;
                                            phi_2859_ = _e1618;
                                        } else {
                                            phi_2858_ = type_43();
                                            phi_2859_ = true;
                                        }
                                        let _e1620 = phi_2858_;
                                        let _e1622 = phi_2859_;
                                        if _e1622 {
                                            if _e1591 {
                                                let _e1626 = select(f64(1f), f64(-1f), (_e1560 < _e1598));
                                                let _e1628 = local_5.member_3;
                                                let _e1629 = f64(0.5f);
                                                let _e1630 = f64(3f);
                                                let _e1633 = local_5.member[0u];
                                                let _e1636 = local_5.member[1u];
                                                let _e1639 = local_5.member[2u];
                                                let _e1642 = local_5.member[3u];
                                                let _e1645 = (_e1639 - _e1636);
                                                phi_2894_ = type_9(0u, 64u);
                                                phi_2897_ = _e1533;
                                                phi_2899_ = _e1529;
                                                phi_2901_ = (_e1629 * (_e1529 + _e1533));
                                                loop {
                                                    let _e1651 = phi_2894_;
                                                    let _e1653 = phi_2897_;
                                                    let _e1655 = phi_2899_;
                                                    let _e1657 = phi_2901_;
                                                    local_12 = _e1655;
                                                    let _e1660 = (_e1651.member < _e1651.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1660)) != 0i) {
                                                        let _e1673 = (f64(1f) - _e1657);
                                                        let _e1676 = local_5.member[0u];
                                                        let _e1679 = local_5.member[1u];
                                                        let _e1682 = local_5.member[2u];
                                                        let _e1685 = local_5.member[3u];
                                                        let _e1699 = local_5.member_1;
                                                        let _e1700 = ((_e1626 * ((((_e1676 * _e1673) + (_e1679 * _e1657)) * (_e1673 * _e1673)) + (((_e1682 * _e1673) + (_e1685 * _e1657)) * (_e1657 * _e1657)))) - _e1699);
                                                        let _e1702 = (_e1700 > f64(0f));
                                                        let _e1703 = select(_e1657, _e1653, _e1702);
                                                        let _e1704 = select(_e1655, _e1657, _e1702);
                                                        let _e1706 = ((_e1703 - _e1704) > _e1628);
                                                        if _e1706 {
                                                            let _e1708 = (f64(1f) - _e1657);
                                                            let _e1720 = (-(_e1700) / (_e1626 * (((((_e1636 - (_e1630 * _e1633)) * _e1708) + (_e1645 * _e1657)) * _e1708) + (((_e1645 * _e1708) + (((_e1630 * _e1642) - _e1639) * _e1657)) * _e1657))));
                                                            let _e1728 = ((_e1657 + _e1720) + select(-((_e1629 * _e1628)), (_e1629 * _e1628), (_e1700 > f64(0f))));
                                                            if (_e1728 > _e1704) {
                                                                phi_3015_ = select(true, select(true, false, (select(_e1720, -(_e1720), (_e1720 < 0.0lf)) < (_e1629 * (_e1703 - _e1704)))), (_e1728 < _e1703));
                                                            } else {
                                                                phi_3015_ = true;
                                                            }
                                                            let _e1740 = phi_3015_;
                                                            phi_3022_ = select(_e1728, (_e1629 * (_e1704 + _e1703)), _e1740);
                                                            phi_3023_ = false;
                                                        } else {
                                                            phi_3022_ = f64();
                                                            phi_3023_ = true;
                                                        }
                                                        let _e1745 = phi_3022_;
                                                        let _e1747 = phi_3023_;
                                                        phi_2898_ = _e1703;
                                                        phi_2900_ = _e1704;
                                                        phi_2902_ = _e1745;
                                                        phi_3024_ = _e1704;
                                                        phi_3025_ = _e1706;
                                                        phi_3026_ = _e1747;
                                                    } else {
                                                        phi_2898_ = f64();
                                                        phi_2900_ = f64();
                                                        phi_2902_ = f64();
                                                        phi_3024_ = f64();
                                                        phi_3025_ = false;
                                                        phi_3026_ = false;
                                                    }
                                                    let _e1749 = phi_2898_;
                                                    let _e1751 = phi_2900_;
                                                    let _e1753 = phi_2902_;
                                                    let _e1755 = phi_3024_;
                                                    let _e1757 = phi_3025_;
                                                    let _e1759 = phi_3026_;
                                                    local_10 = _e1759;
                                                    local_11 = _e1755;
                                                    continue;
                                                    continuing {
                                                        phi_2894_ = type_9(select(_e1651.member, (_e1651.member + 1u), _e1660), select(_e1651.member_1, _e1651.member_1, _e1660));
                                                        phi_2897_ = _e1749;
                                                        phi_2899_ = _e1751;
                                                        phi_2901_ = _e1753;
                                                        break if !(_e1757);
                                                    }
                                                }
                                                let _e1762 = local_10;
                                                let _e1764 = local_11;
                                                let _e1766 = local_12;
                                                phi_3031_ = select(_e1766, _e1764, _e1762);
                                            } else {
                                                phi_3031_ = _e1529;
                                            }
                                            let _e1769 = phi_3031_;
                                            if _e1597 {
                                                let _e1775 = local_5.member_3;
                                                let _e1777 = local_5.member_3;
                                                phi_3049_ = type_9(0u, 64u);
                                                phi_3052_ = (_e1775 + _e1777);
                                                loop {
                                                    let _e1780 = phi_3049_;
                                                    let _e1782 = phi_3052_;
                                                    let _e1785 = (_e1780.member < _e1780.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1785)) != 0i) {
                                                        let _e1797 = (_e1769 + _e1782);
                                                        if (_e1797 < _e1533) {
                                                            let _e1800 = (f64(1f) - _e1797);
                                                            let _e1803 = local_5.member[0u];
                                                            let _e1806 = local_5.member[1u];
                                                            let _e1809 = local_5.member[2u];
                                                            let _e1812 = local_5.member[3u];
                                                            let _e1826 = local_5.member_1;
                                                            let _e1827 = ((select(f64(1f), f64(-1f), (_e1585 < _e1598)) * ((((_e1803 * _e1800) + (_e1806 * _e1797)) * (_e1800 * _e1800)) + (((_e1809 * _e1800) + (_e1812 * _e1797)) * (_e1797 * _e1797)))) > _e1826);
                                                            phi_3118_ = select((_e1782 + _e1782), f64(), _e1827);
                                                            phi_3119_ = select(true, false, _e1827);
                                                            phi_3120_ = _e1827;
                                                            phi_3121_ = false;
                                                        } else {
                                                            phi_3118_ = f64();
                                                            phi_3119_ = false;
                                                            phi_3120_ = false;
                                                            phi_3121_ = true;
                                                        }
                                                        let _e1832 = phi_3118_;
                                                        let _e1834 = phi_3119_;
                                                        let _e1836 = phi_3120_;
                                                        let _e1838 = phi_3121_;
                                                        phi_3122_ = _e1797;
                                                        phi_3053_ = _e1832;
                                                        phi_3123_ = _e1834;
                                                        phi_3124_ = _e1836;
                                                        phi_3125_ = _e1838;
                                                        phi_3126_ = false;
                                                    } else {
                                                        phi_3122_ = f64();
                                                        phi_3053_ = f64();
                                                        phi_3123_ = false;
                                                        phi_3124_ = false;
                                                        phi_3125_ = false;
                                                        phi_3126_ = true;
                                                    }
                                                    let _e1840 = phi_3122_;
                                                    let _e1842 = phi_3053_;
                                                    let _e1844 = phi_3123_;
                                                    let _e1846 = phi_3124_;
                                                    let _e1848 = phi_3125_;
                                                    let _e1850 = phi_3126_;
                                                    local_13 = _e1846;
                                                    local_14 = _e1848;
                                                    local_15 = _e1846;
                                                    local_16 = _e1850;
                                                    local_17 = _e1840;
                                                    continue;
                                                    continuing {
                                                        phi_3049_ = type_9(select(_e1780.member, (_e1780.member + 1u), _e1785), select(_e1780.member_1, _e1780.member_1, _e1785));
                                                        phi_3052_ = _e1842;
                                                        break if !(_e1844);
                                                    }
                                                }
                                                let _e1853 = local_13;
                                                let _e1855 = local_14;
                                                let _e1858 = local_15;
                                                let _e1860 = local_16;
                                                let _e1864 = local_17;
                                                phi_3140_ = select(_e1864, _e1533, select(select(_e1860, false, _e1858), true, select(_e1855, false, _e1853)));
                                            } else {
                                                phi_3140_ = _e1533;
                                            }
                                            let _e1867 = phi_3140_;
                                            phi_3142_ = type_43(_e1769, _e1867, _e1606);
                                        } else {
                                            phi_3142_ = _e1620;
                                        }
                                        let _e1870 = phi_3142_;
                                        if (_e1870.member > _e1870.member_1) {
                                            phi_4133_ = bool();
                                            phi_4134_ = true;
                                            phi_4135_ = false;
                                            phi_4136_ = false;
                                            phi_4137_ = false;
                                        } else {
                                            let _e1875 = (_e1870.member > _e551);
                                            if _e1875 {
                                                phi_4129_ = bool();
                                                phi_4130_ = false;
                                                phi_4131_ = false;
                                                phi_4132_ = false;
                                            } else {
                                                let _e1880 = ((_e1870.member_1 - _e1870.member) * f64(0.5f));
                                                let _e1881 = (_e1870.member + _e1880);
                                                let _e1884 = (_e1880 + (1.1102230246251565e-16lf * f64(4f)));
                                                let _e1886 = local_7.member_3;
                                                let _e1889 = local_7.member[0u];
                                                let _e1895 = select(_e1889[0], -(_e1889[0]), (_e1889[0] < 0.0lf));
                                                let _e1898 = select(_e1889[1], -(_e1889[1]), (_e1889[1] < 0.0lf));
                                                let _e1900 = select(_e1898, _e1895, (_e1895 > _e1898));
                                                let _e1903 = select(_e1889[2], -(_e1889[2]), (_e1889[2] < 0.0lf));
                                                let _e1905 = select(_e1903, _e1900, (_e1900 > _e1903));
                                                let _e1907 = local_7.member[1u];
                                                let _e1913 = select(_e1907[0], -(_e1907[0]), (_e1907[0] < 0.0lf));
                                                let _e1916 = select(_e1907[1], -(_e1907[1]), (_e1907[1] < 0.0lf));
                                                let _e1918 = select(_e1916, _e1913, (_e1913 > _e1916));
                                                let _e1921 = select(_e1907[2], -(_e1907[2]), (_e1907[2] < 0.0lf));
                                                let _e1923 = select(_e1921, _e1918, (_e1918 > _e1921));
                                                let _e1928 = local_7.member[0u];
                                                let _e1933 = local_7.member[1u];
                                                let _e1943 = (_e1928[0] + ((_e1933[0] - _e1928[0]) * _e1881));
                                                let _e1944 = (_e1928[1] + ((_e1933[1] - _e1928[1]) * _e1881));
                                                let _e1945 = (_e1928[2] + ((_e1933[2] - _e1928[2]) * _e1881));
                                                let _e1947 = local_7.member[1u];
                                                let _e1952 = local_7.member[0u];
                                                let _e1956 = (_e1947[0] - _e1952[0]);
                                                let _e1957 = (_e1947[1] - _e1952[1]);
                                                let _e1958 = (_e1947[2] - _e1952[2]);
                                                let _e1961 = select(_e1956, -(_e1956), (_e1956 < 0.0lf));
                                                let _e1964 = select(_e1957, -(_e1957), (_e1957 < 0.0lf));
                                                let _e1966 = select(_e1964, _e1961, (_e1961 > _e1964));
                                                let _e1969 = select(_e1958, -(_e1958), (_e1958 < 0.0lf));
                                                let _e1979 = ((((_e1884 * select(_e1969, _e1966, (_e1966 > _e1969))) * f64(1.01f)) + ((select(_e1923, _e1905, (_e1905 > _e1923)) + _e1886) * (1.1102230246251565e-16lf * f64(8f)))) + _e1886);
                                                let _e1982 = select(_e1943, -(_e1943), (_e1943 < 0.0lf));
                                                let _e1985 = select(_e1944, -(_e1944), (_e1944 < 0.0lf));
                                                let _e1987 = select(_e1985, _e1982, (_e1982 > _e1985));
                                                let _e1990 = select(_e1945, -(_e1945), (_e1945 < 0.0lf));
                                                let _e1993 = (select(_e1990, _e1987, (_e1987 > _e1990)) + _e1979);
                                                let _e1996 = local_7.member_3;
                                                let _e1998 = local_7.member_1[0u];
                                                let _e2004 = select(_e1998[0], -(_e1998[0]), (_e1998[0] < 0.0lf));
                                                let _e2007 = select(_e1998[1], -(_e1998[1]), (_e1998[1] < 0.0lf));
                                                let _e2009 = select(_e2007, _e2004, (_e2004 > _e2007));
                                                let _e2012 = select(_e1998[2], -(_e1998[2]), (_e1998[2] < 0.0lf));
                                                let _e2014 = select(_e2012, _e2009, (_e2009 > _e2012));
                                                let _e2016 = local_7.member_1[1u];
                                                let _e2022 = select(_e2016[0], -(_e2016[0]), (_e2016[0] < 0.0lf));
                                                let _e2025 = select(_e2016[1], -(_e2016[1]), (_e2016[1] < 0.0lf));
                                                let _e2027 = select(_e2025, _e2022, (_e2022 > _e2025));
                                                let _e2030 = select(_e2016[2], -(_e2016[2]), (_e2016[2] < 0.0lf));
                                                let _e2032 = select(_e2030, _e2027, (_e2027 > _e2030));
                                                let _e2037 = local_7.member_1[0u];
                                                let _e2042 = local_7.member_1[1u];
                                                let _e2052 = (_e2037[0] + ((_e2042[0] - _e2037[0]) * _e1881));
                                                let _e2053 = (_e2037[1] + ((_e2042[1] - _e2037[1]) * _e1881));
                                                let _e2054 = (_e2037[2] + ((_e2042[2] - _e2037[2]) * _e1881));
                                                let _e2056 = local_7.member_1[1u];
                                                let _e2061 = local_7.member_1[0u];
                                                let _e2065 = (_e2056[0] - _e2061[0]);
                                                let _e2066 = (_e2056[1] - _e2061[1]);
                                                let _e2067 = (_e2056[2] - _e2061[2]);
                                                let _e2070 = select(_e2065, -(_e2065), (_e2065 < 0.0lf));
                                                let _e2073 = select(_e2066, -(_e2066), (_e2066 < 0.0lf));
                                                let _e2075 = select(_e2073, _e2070, (_e2070 > _e2073));
                                                let _e2078 = select(_e2067, -(_e2067), (_e2067 < 0.0lf));
                                                let _e2088 = ((((_e1884 * select(_e2078, _e2075, (_e2075 > _e2078))) * f64(1.01f)) + ((select(_e2032, _e2014, (_e2014 > _e2032)) + _e1996) * (1.1102230246251565e-16lf * f64(8f)))) + _e1996);
                                                let _e2091 = select(_e2052, -(_e2052), (_e2052 < 0.0lf));
                                                let _e2094 = select(_e2053, -(_e2053), (_e2053 < 0.0lf));
                                                let _e2096 = select(_e2094, _e2091, (_e2091 > _e2094));
                                                let _e2099 = select(_e2054, -(_e2054), (_e2054 < 0.0lf));
                                                let _e2102 = (select(_e2099, _e2096, (_e2096 > _e2099)) + _e2088);
                                                let _e2105 = local_7.member_3;
                                                let _e2107 = local_7.member_2[0u];
                                                let _e2113 = select(_e2107[0], -(_e2107[0]), (_e2107[0] < 0.0lf));
                                                let _e2116 = select(_e2107[1], -(_e2107[1]), (_e2107[1] < 0.0lf));
                                                let _e2118 = select(_e2116, _e2113, (_e2113 > _e2116));
                                                let _e2121 = select(_e2107[2], -(_e2107[2]), (_e2107[2] < 0.0lf));
                                                let _e2123 = select(_e2121, _e2118, (_e2118 > _e2121));
                                                let _e2125 = local_7.member_2[1u];
                                                let _e2131 = select(_e2125[0], -(_e2125[0]), (_e2125[0] < 0.0lf));
                                                let _e2134 = select(_e2125[1], -(_e2125[1]), (_e2125[1] < 0.0lf));
                                                let _e2136 = select(_e2134, _e2131, (_e2131 > _e2134));
                                                let _e2139 = select(_e2125[2], -(_e2125[2]), (_e2125[2] < 0.0lf));
                                                let _e2141 = select(_e2139, _e2136, (_e2136 > _e2139));
                                                let _e2146 = local_7.member_2[0u];
                                                let _e2151 = local_7.member_2[1u];
                                                let _e2161 = (_e2146[0] + ((_e2151[0] - _e2146[0]) * _e1881));
                                                let _e2162 = (_e2146[1] + ((_e2151[1] - _e2146[1]) * _e1881));
                                                let _e2163 = (_e2146[2] + ((_e2151[2] - _e2146[2]) * _e1881));
                                                let _e2165 = local_7.member_2[1u];
                                                let _e2170 = local_7.member_2[0u];
                                                let _e2174 = (_e2165[0] - _e2170[0]);
                                                let _e2175 = (_e2165[1] - _e2170[1]);
                                                let _e2176 = (_e2165[2] - _e2170[2]);
                                                let _e2179 = select(_e2174, -(_e2174), (_e2174 < 0.0lf));
                                                let _e2182 = select(_e2175, -(_e2175), (_e2175 < 0.0lf));
                                                let _e2184 = select(_e2182, _e2179, (_e2179 > _e2182));
                                                let _e2187 = select(_e2176, -(_e2176), (_e2176 < 0.0lf));
                                                let _e2197 = ((((_e1884 * select(_e2187, _e2184, (_e2184 > _e2187))) * f64(1.01f)) + ((select(_e2141, _e2123, (_e2123 > _e2141)) + _e2105) * (1.1102230246251565e-16lf * f64(8f)))) + _e2105);
                                                let _e2200 = select(_e2161, -(_e2161), (_e2161 < 0.0lf));
                                                let _e2203 = select(_e2162, -(_e2162), (_e2162 < 0.0lf));
                                                let _e2205 = select(_e2203, _e2200, (_e2200 > _e2203));
                                                let _e2208 = select(_e2163, -(_e2163), (_e2163 < 0.0lf));
                                                let _e2211 = (select(_e2208, _e2205, (_e2205 > _e2208)) + _e2197);
                                                let _e2214 = ((_e2053 * _e2163) - (_e2054 * _e2162));
                                                let _e2217 = ((_e2054 * _e2161) - (_e2052 * _e2163));
                                                let _e2220 = ((_e2052 * _e2162) - (_e2053 * _e2161));
                                                let _e2235 = select(false, (select(_e2214, -(_e2214), (_e2214 < 0.0lf)) > select(_e2220, -(_e2220), (_e2220 < 0.0lf))), (select(_e2214, -(_e2214), (_e2214 < 0.0lf)) > select(_e2217, -(_e2217), (_e2217 < 0.0lf))));
                                                let _e2250 = select((select(_e2217, -(_e2217), (_e2217 < 0.0lf)) > select(_e2220, -(_e2220), (_e2220 < 0.0lf))), false, (select(_e2214, -(_e2214), (_e2214 < 0.0lf)) > select(_e2217, -(_e2217), (_e2217 < 0.0lf))));
                                                let _e2253 = select(select(_e1943, _e1944, _e2235), _e1945, _e2250);
                                                let _e2254 = select(select(_e1944, _e1945, _e2235), _e1943, _e2250);
                                                let _e2257 = select(select(_e2052, _e2053, _e2235), _e2054, _e2250);
                                                let _e2258 = select(select(_e2053, _e2054, _e2235), _e2052, _e2250);
                                                let _e2261 = select(select(_e2161, _e2162, _e2235), _e2163, _e2250);
                                                let _e2262 = select(select(_e2162, _e2163, _e2235), _e2161, _e2250);
                                                let _e2265 = ((_e2257 * _e2262) - (_e2258 * _e2261));
                                                let _e2266 = f64(1f);
                                                let _e2267 = f64(2f);
                                                let _e2285 = (((((_e2088 * _e2211) + (_e2102 * _e2197)) * f64(2.01f)) + (((_e2102 * _e2267) * (_e2211 * _e2267)) * (1.1102230246251565e-16lf * _e2267))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2266 + _e2102) * (_e2266 + _e2211))));
                                                if (select(_e2265, -(_e2265), (_e2265 < 0.0lf)) > _e2285) {
                                                    let _e2294 = select(f64(1f), f64(-1f), (_e2265 < f64(0f)));
                                                    let _e2298 = f64(1f);
                                                    let _e2299 = f64(2f);
                                                    let _e2317 = (((((_e1979 * _e2211) + (_e1993 * _e2197)) * f64(2.01f)) + (((_e1993 * _e2299) * (_e2211 * _e2299)) * (1.1102230246251565e-16lf * _e2299))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2298 + _e1993) * (_e2298 + _e2211))));
                                                    let _e2321 = f64(1f);
                                                    let _e2322 = f64(2f);
                                                    let _e2340 = (((((_e2088 * _e1993) + (_e2102 * _e1979)) * f64(2.01f)) + (((_e2102 * _e2322) * (_e1993 * _e2322)) * (1.1102230246251565e-16lf * _e2322))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2321 + _e2102) * (_e2321 + _e1993))));
                                                    let _e2341 = (_e2265 * _e2294);
                                                    let _e2342 = (((_e2253 * _e2262) - (_e2254 * _e2261)) * _e2294);
                                                    let _e2343 = (((_e2257 * _e2254) - (_e2258 * _e2253)) * _e2294);
                                                    let _e2357 = (((select(_e2341, -(_e2341), (_e2341 < 0.0lf)) + select(_e2342, -(_e2342), (_e2342 < 0.0lf))) + select(_e2343, -(_e2343), (_e2343 < 0.0lf))) * (1.1102230246251565e-16lf * f64(4f)));
                                                    if (_e230.member != 0u) {
                                                        phi_4003_ = array<type_36, 4>(type_36(_e2342, _e2317), type_36(_e2343, _e2340), type_36((_e2341 - _e2342), ((_e2285 + _e2317) + _e2357)), type_36((_e2341 - _e2343), ((_e2285 + _e2340) + _e2357)));
                                                    } else {
                                                        let _e2360 = ((_e2341 - _e2342) - _e2343);
                                                        let _e2363 = (((_e2285 + _e2317) + _e2340) + _e2357);
                                                        phi_4003_ = array<type_36, 4>(type_36(_e2342, _e2317), type_36(_e2343, _e2340), type_36(_e2360, _e2363), type_36(_e2360, _e2363));
                                                    }
                                                    let _e2381 = phi_4003_;
                                                    local_2 = array<type_36, 4>(type_36(_e2381[0].member, _e2381[0].member_1), type_36(_e2381[1].member, _e2381[1].member_1), type_36(_e2381[2].member, _e2381[2].member_1), type_36(_e2381[3].member, _e2381[3].member_1));
                                                    phi_4023_ = type_9(0u, 4u);
                                                    phi_4026_ = true;
                                                    loop {
                                                        let _e2400 = phi_4023_;
                                                        let _e2402 = phi_4026_;
                                                        local_19 = _e2402;
                                                        let _e2405 = (_e2400.member < _e2400.member_1);
                                                        let _e2416 = select(type_9().member_1, _e2400.member, _e2405);
                                                        if (bitcast<i32>(select(0u, 1u, _e2405)) != 0i) {
                                                            let _e2421 = local_2[_e2416].member;
                                                            let _e2424 = local_2[_e2416].member_1;
                                                            let _e2426 = (_e2421 < -(_e2424));
                                                            phi_4027_ = select((_e2402 && (_e2421 > _e2424)), bool(), _e2426);
                                                            phi_4078_ = select(true, false, _e2426);
                                                            phi_4079_ = _e2426;
                                                        } else {
                                                            phi_4027_ = bool();
                                                            phi_4078_ = false;
                                                            phi_4079_ = false;
                                                        }
                                                        let _e2432 = phi_4027_;
                                                        let _e2434 = phi_4078_;
                                                        let _e2436 = phi_4079_;
                                                        local_18 = _e2436;
                                                        continue;
                                                        continuing {
                                                            phi_4023_ = type_9(select(_e2400.member, (_e2400.member + 1u), _e2405), select(_e2400.member_1, _e2400.member_1, _e2405));
                                                            phi_4026_ = _e2432;
                                                            break if !(_e2434);
                                                        }
                                                    }
                                                    let _e2439 = local_18;
                                                    let _e2440 = select(true, false, _e2439);
                                                    let _e2442 = local_19;
                                                    phi_4093_ = select(u32(), select(2u, 1u, _e2442), _e2440);
                                                    phi_4094_ = 0u;
                                                    phi_4095_ = select(true, false, _e2440);
                                                } else {
                                                    phi_4093_ = u32();
                                                    phi_4094_ = 2u;
                                                    phi_4095_ = true;
                                                }
                                                let _e2447 = phi_4093_;
                                                let _e2449 = phi_4094_;
                                                let _e2451 = phi_4095_;
                                                let _e2452 = select(_e2447, _e2449, _e2451);
                                                let _e2453 = (_e2452 == 0u);
                                                if _e2453 {
                                                    phi_4126_ = bool();
                                                    phi_4127_ = false;
                                                    phi_4128_ = false;
                                                } else {
                                                    let _e2456 = select(false, _e1870.member_2, (_e2452 == 1u));
                                                    let _e2462 = select(true, select(true, false, ((_e1870.member_1 - _e1870.member) <= _e1469)), _e2456);
                                                    phi_4126_ = _e2456;
                                                    phi_4127_ = _e2462;
                                                    phi_4128_ = select(true, false, _e2462);
                                                }
                                                let _e2465 = phi_4126_;
                                                let _e2467 = phi_4127_;
                                                let _e2469 = phi_4128_;
                                                phi_4129_ = _e2465;
                                                phi_4130_ = _e2453;
                                                phi_4131_ = _e2467;
                                                phi_4132_ = _e2469;
                                            }
                                            let _e2471 = phi_4129_;
                                            let _e2473 = phi_4130_;
                                            let _e2475 = phi_4131_;
                                            let _e2477 = phi_4132_;
                                            phi_4133_ = _e2471;
                                            phi_4134_ = _e2473;
                                            phi_4135_ = _e2475;
                                            phi_4136_ = _e1875;
                                            phi_4137_ = _e2477;
                                        }
                                        let _e2479 = phi_4133_;
                                        let _e2481 = phi_4134_;
                                        let _e2483 = phi_4135_;
                                        let _e2485 = phi_4136_;
                                        let _e2487 = phi_4137_;
                                        phi_4138_ = _e1870;
                                        phi_4139_ = _e2479;
                                        phi_4140_ = _e1870;
                                        phi_4141_ = _e2481;
                                        phi_4142_ = _e2483;
                                        phi_4143_ = _e2485;
                                        phi_4144_ = _e2487;
                                    }
                                    let _e2489 = phi_4138_;
                                    let _e2491 = phi_4139_;
                                    let _e2493 = phi_4140_;
                                    let _e2495 = phi_4141_;
                                    let _e2497 = phi_4142_;
                                    let _e2499 = phi_4143_;
                                    let _e2501 = phi_4144_;
                                    phi_4145_ = _e2489;
                                    phi_4146_ = _e2491;
                                    phi_4147_ = _e2493;
                                    phi_4148_ = _e2495;
                                    phi_4149_ = _e2497;
                                    phi_4150_ = _e1535;
                                    phi_4151_ = _e2499;
                                    phi_4152_ = _e2501;
                                } else {
                                    phi_4145_ = type_43();
                                    phi_4146_ = bool();
                                    phi_4147_ = type_43();
                                    phi_4148_ = true;
                                    phi_4149_ = false;
                                    phi_4150_ = false;
                                    phi_4151_ = false;
                                    phi_4152_ = false;
                                }
                                let _e2503 = phi_4145_;
                                let _e2505 = phi_4146_;
                                let _e2507 = phi_4147_;
                                let _e2509 = phi_4148_;
                                let _e2511 = phi_4149_;
                                let _e2513 = phi_4150_;
                                let _e2515 = phi_4151_;
                                let _e2517 = phi_4152_;
                                phi_4160_ = _e2503;
                                phi_4161_ = _e2505;
                                phi_4162_ = _e2507;
                                phi_4163_ = select(_e2511, false, _e2509);
                                phi_4164_ = _e2509;
                                phi_4165_ = select(_e2513, false, _e2509);
                                phi_4166_ = select(_e2515, false, _e2509);
                                phi_4167_ = select(_e2517, false, _e2509);
                            } else {
                                phi_4160_ = type_43(_e533, _e533, false);
                                phi_4161_ = false;
                                phi_4162_ = type_43();
                                phi_4163_ = true;
                                phi_4164_ = false;
                                phi_4165_ = false;
                                phi_4166_ = false;
                                phi_4167_ = false;
                            }
                            let _e2523 = phi_4160_;
                            let _e2525 = phi_4161_;
                            let _e2527 = phi_4162_;
                            let _e2529 = phi_4163_;
                            let _e2531 = phi_4164_;
                            let _e2533 = phi_4165_;
                            let _e2535 = phi_4166_;
                            let _e2537 = phi_4167_;
                            if _e2529 {
                                let _e2542 = local_7.member[0u];
                                let _e2548 = local_7.member_1[0u];
                                let _e2554 = local_7.member_2[0u];
                                let _e2558 = (_e2542[0] - _e2548[0]);
                                let _e2559 = (_e2542[1] - _e2548[1]);
                                let _e2560 = (_e2542[2] - _e2548[2]);
                                let _e2561 = (_e230.member == 0u);
                                let _e2573 = local_7.member[1u];
                                let _e2579 = local_7.member_1[1u];
                                let _e2585 = local_7.member_2[1u];
                                let _e2589 = (_e2573[0] - _e2579[0]);
                                let _e2590 = (_e2573[1] - _e2579[1]);
                                let _e2591 = (_e2573[2] - _e2579[2]);
                                let _e2592 = (_e230.member == 0u);
                                let _e2604 = local_7.member[0u];
                                let _e2610 = select(_e2604[0], -(_e2604[0]), (_e2604[0] < 0.0lf));
                                let _e2613 = select(_e2604[1], -(_e2604[1]), (_e2604[1] < 0.0lf));
                                let _e2615 = select(_e2613, _e2610, (_e2610 > _e2613));
                                let _e2618 = select(_e2604[2], -(_e2604[2]), (_e2604[2] < 0.0lf));
                                let _e2620 = select(_e2618, _e2615, (_e2615 > _e2618));
                                let _e2623 = local_7.member[1u];
                                let _e2629 = select(_e2623[0], -(_e2623[0]), (_e2623[0] < 0.0lf));
                                let _e2632 = select(_e2623[1], -(_e2623[1]), (_e2623[1] < 0.0lf));
                                let _e2634 = select(_e2632, _e2629, (_e2629 > _e2632));
                                let _e2637 = select(_e2623[2], -(_e2623[2]), (_e2623[2] < 0.0lf));
                                let _e2639 = select(_e2637, _e2634, (_e2634 > _e2637));
                                let _e2643 = local_7.member_3;
                                let _e2647 = local_7.member_1[0u];
                                let _e2653 = select(_e2647[0], -(_e2647[0]), (_e2647[0] < 0.0lf));
                                let _e2656 = select(_e2647[1], -(_e2647[1]), (_e2647[1] < 0.0lf));
                                let _e2658 = select(_e2656, _e2653, (_e2653 > _e2656));
                                let _e2661 = select(_e2647[2], -(_e2647[2]), (_e2647[2] < 0.0lf));
                                let _e2663 = select(_e2661, _e2658, (_e2658 > _e2661));
                                let _e2666 = local_7.member_1[1u];
                                let _e2672 = select(_e2666[0], -(_e2666[0]), (_e2666[0] < 0.0lf));
                                let _e2675 = select(_e2666[1], -(_e2666[1]), (_e2666[1] < 0.0lf));
                                let _e2677 = select(_e2675, _e2672, (_e2672 > _e2675));
                                let _e2680 = select(_e2666[2], -(_e2666[2]), (_e2666[2] < 0.0lf));
                                let _e2682 = select(_e2680, _e2677, (_e2677 > _e2680));
                                let _e2686 = local_7.member_3;
                                let _e2690 = local_7.member_2[0u];
                                let _e2696 = select(_e2690[0], -(_e2690[0]), (_e2690[0] < 0.0lf));
                                let _e2699 = select(_e2690[1], -(_e2690[1]), (_e2690[1] < 0.0lf));
                                let _e2701 = select(_e2699, _e2696, (_e2696 > _e2699));
                                let _e2704 = select(_e2690[2], -(_e2690[2]), (_e2690[2] < 0.0lf));
                                let _e2706 = select(_e2704, _e2701, (_e2701 > _e2704));
                                let _e2709 = local_7.member_2[1u];
                                let _e2715 = select(_e2709[0], -(_e2709[0]), (_e2709[0] < 0.0lf));
                                let _e2718 = select(_e2709[1], -(_e2709[1]), (_e2709[1] < 0.0lf));
                                let _e2720 = select(_e2718, _e2715, (_e2715 > _e2718));
                                let _e2723 = select(_e2709[2], -(_e2709[2]), (_e2709[2] < 0.0lf));
                                let _e2725 = select(_e2723, _e2720, (_e2720 > _e2723));
                                let _e2729 = local_7.member_3;
                                let _e2737 = local_7.member_3;
                                let _e2745 = (_e524 * f64(0.00390625f));
                                let _e2746 = f64(0f);
                                let _e2747 = f64(1f);
                                local = type_44(array<f64, 4>(_e2746, _e2746, _e2746, _e2746), array<f64, 4>(_e2746, _e2746, _e2746, _e2746), array<f64, 4>(_e2747, _e2747, _e2747, _e2747));
                                phi_4596_ = type_9(0u, 96u);
                                phi_4599_ = _e2523.member;
                                phi_4601_ = _e2523.member;
                                phi_4603_ = (_e2523.member_1 - _e2523.member);
                                phi_4605_ = _e2523.member;
                                phi_4607_ = false;
                                phi_4609_ = 0u;
                                loop {
                                    let _e2754 = phi_4596_;
                                    let _e2756 = phi_4599_;
                                    let _e2758 = phi_4601_;
                                    let _e2760 = phi_4603_;
                                    let _e2762 = phi_4605_;
                                    let _e2764 = phi_4607_;
                                    let _e2766 = phi_4609_;
                                    local_32 = _e2756;
                                    local_36 = _e2758;
                                    let _e2769 = (_e2754.member < _e2754.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2769)) != 0i) {
                                        let _e2783 = local_7.member[0u];
                                        let _e2789 = local_7.member[1u];
                                        let _e2805 = local_7.member_1[0u];
                                        let _e2811 = local_7.member_1[1u];
                                        let _e2827 = local_7.member_2[0u];
                                        let _e2833 = local_7.member_2[1u];
                                        let _e2847 = function_5(array<f64, 3>((_e2783[0] + ((_e2789[0] - _e2783[0]) * _e2756)), (_e2783[1] + ((_e2789[1] - _e2783[1]) * _e2756)), (_e2783[2] + ((_e2789[2] - _e2783[2]) * _e2756))), array<f64, 3>((_e2805[0] + ((_e2811[0] - _e2805[0]) * _e2756)), (_e2805[1] + ((_e2811[1] - _e2805[1]) * _e2756)), (_e2805[2] + ((_e2811[2] - _e2805[2]) * _e2756))), array<f64, 3>((_e2827[0] + ((_e2833[0] - _e2827[0]) * _e2756)), (_e2827[1] + ((_e2833[1] - _e2827[1]) * _e2756)), (_e2827[2] + ((_e2833[2] - _e2827[2]) * _e2756))), _e230.member);
                                        if (_e2766 == 0u) {
                                            phi_4761_ = _e2847;
                                        } else {
                                            let _e2849 = f64(0f);
                                            phi_4761_ = array<f64, 3>(select(_e2849, _e2847[0], (_e2766 == 1u)), select(_e2849, _e2847[1], (_e2766 == 2u)), select(_e2849, _e2847[2], (_e2766 == 3u)));
                                        }
                                        let _e2861 = phi_4761_;
                                        let _e2875 = ((select(_e2861[0], -(_e2861[0]), (_e2861[0] < 0.0lf)) + select(_e2861[1], -(_e2861[1]), (_e2861[1] < 0.0lf))) + select(_e2861[2], -(_e2861[2]), (_e2861[2] < 0.0lf)));
                                        if (_e2875 > f64(0f)) {
                                            if ((bitcast<u64>(_e2875) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2882 = (f64(1f) / _e2875);
                                                let _e2884 = (_e2861[0] * _e2882);
                                                let _e2886 = (_e2861[1] * _e2882);
                                                let _e2888 = (_e2861[2] * _e2882);
                                                let _e2893 = (((_e2884 * _e2884) + (_e2886 * _e2886)) + (_e2888 * _e2888));
                                                if (_e2893 <= 2.2250738585072014e-308lf) {
                                                    phi_4886_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2893 > 0.0lf));
                                                } else {
                                                    phi_4829_ = type_16(0i, 5i);
                                                    phi_4832_ = bitcast<f64>(((bitcast<u64>(_e2893) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2900 = phi_4829_;
                                                        let _e2902 = phi_4832_;
                                                        local_20 = _e2902;
                                                        if (_e2900.member < _e2900.member_1) {
                                                            let _e2909 = (_e2900.member + 1i);
                                                            phi_4830_ = type_16(select(_e2909, type_17().member_1, select(false, true, ((false == (_e2909 > _e2900.member)) != false))), _e2900.member_1);
                                                            phi_4873_ = type_17(1u, _e2900.member);
                                                        } else {
                                                            phi_4830_ = _e2900;
                                                            phi_4873_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2920 = phi_4830_;
                                                        let _e2922 = phi_4873_;
                                                        let _e2925 = (bitcast<i32>(_e2922.member) != 0i);
                                                        if _e2925 {
                                                            phi_4833_ = (0.5lf * (_e2902 + (_e2893 / _e2902)));
                                                        } else {
                                                            phi_4833_ = f64();
                                                        }
                                                        let _e2930 = phi_4833_;
                                                        continue;
                                                        continuing {
                                                            phi_4829_ = _e2920;
                                                            phi_4832_ = _e2930;
                                                            break if !(_e2925);
                                                        }
                                                    }
                                                    let _e2935 = local_20;
                                                    phi_4886_ = (_e2935 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2941 = phi_4886_;
                                                let _e2943 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2950 = ((((((((select(_e2639, _e2620, (_e2620 > _e2639)) + _e2643) + (select(_e2682, _e2663, (_e2663 > _e2682)) + _e2686)) + (select(_e2725, _e2706, (_e2706 > _e2725)) + _e2729)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2737 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e1255 * _e2941) * (f64(1f) + _e2943)));
                                                let _e2955 = (((_e2884 * _e2542[0]) + (_e2886 * _e2542[1])) + (_e2888 * _e2542[2]));
                                                let _e2960 = (((_e2884 * _e2558) + (_e2886 * _e2559)) + (_e2888 * _e2560));
                                                let _e2965 = (((_e2884 * (_e2542[0] - _e2554[0])) + (_e2886 * (_e2542[1] - _e2554[1]))) + (_e2888 * (_e2542[2] - _e2554[2])));
                                                let _e2970 = (((_e2884 * select((_e2558 - _e2554[0]), _e2542[0], _e2561)) + (_e2886 * select((_e2559 - _e2554[1]), _e2542[1], _e2561))) + (_e2888 * select((_e2560 - _e2554[2]), _e2542[2], _e2561)));
                                                let _e2976 = (((_e2884 * _e2573[0]) + (_e2886 * _e2573[1])) + (_e2888 * _e2573[2]));
                                                let _e2981 = (((_e2884 * _e2589) + (_e2886 * _e2590)) + (_e2888 * _e2591));
                                                let _e2986 = (((_e2884 * (_e2573[0] - _e2585[0])) + (_e2886 * (_e2573[1] - _e2585[1]))) + (_e2888 * (_e2573[2] - _e2585[2])));
                                                let _e2991 = (((_e2884 * select((_e2589 - _e2585[0]), _e2573[0], _e2592)) + (_e2886 * select((_e2590 - _e2585[1]), _e2573[1], _e2592))) + (_e2888 * select((_e2591 - _e2585[2]), _e2573[2], _e2592)));
                                                phi_5012_ = type_44(array<f64, 4>(_e2955, _e2960, _e2965, _e2970), array<f64, 4>(_e2976, _e2981, _e2986, _e2991), array<f64, 4>((_e2950 + ((select(_e2955, -(_e2955), (_e2955 < 0.0lf)) + select(_e2976, -(_e2976), (_e2976 < 0.0lf))) * _e2943)), (_e2950 + ((select(_e2960, -(_e2960), (_e2960 < 0.0lf)) + select(_e2981, -(_e2981), (_e2981 < 0.0lf))) * _e2943)), (_e2950 + ((select(_e2965, -(_e2965), (_e2965 < 0.0lf)) + select(_e2986, -(_e2986), (_e2986 < 0.0lf))) * _e2943)), (_e2950 + ((select(_e2970, -(_e2970), (_e2970 < 0.0lf)) + select(_e2991, -(_e2991), (_e2991 < 0.0lf))) * _e2943))));
                                                phi_5013_ = false;
                                            } else {
                                                phi_5012_ = type_44();
                                                phi_5013_ = true;
                                            }
                                            let _e3032 = phi_5012_;
                                            let _e3034 = phi_5013_;
                                            phi_5014_ = _e3032;
                                            phi_5015_ = _e3034;
                                        } else {
                                            phi_5014_ = type_44();
                                            phi_5015_ = true;
                                        }
                                        let _e3036 = phi_5014_;
                                        let _e3038 = phi_5015_;
                                        if _e3038 {
                                            let _e3039 = f64(0f);
                                            let _e3040 = f64(1f);
                                            phi_5025_ = type_44(array<f64, 4>(_e3039, _e3039, _e3039, _e3039), array<f64, 4>(_e3039, _e3039, _e3039, _e3039), array<f64, 4>(_e3040, _e3040, _e3040, _e3040));
                                        } else {
                                            phi_5025_ = _e3036;
                                        }
                                        let _e3046 = phi_5025_;
                                        local_1 = type_44(array<f64, 4>(_e3046.member[0], _e3046.member[1], _e3046.member[2], _e3046.member[3]), array<f64, 4>(_e3046.member_1[0], _e3046.member_1[1], _e3046.member_1[2], _e3046.member_1[3]), array<f64, 4>(_e3046.member_2[0], _e3046.member_2[1], _e3046.member_2[2], _e3046.member_2[3]));
                                        let _e3066 = (_e2756 - _e2762);
                                        let _e3068 = f64(0f);
                                        let _e3071 = local_1.member[0u];
                                        let _e3074 = local_1.member_1[0u];
                                        let _e3077 = local_1.member[0u];
                                        let _e3083 = local_1.member_2[0u];
                                        if (((_e3071 + ((_e3074 - _e3077) * _e2756)) - _e3083) > _e3068) {
                                            let _e3088 = local_1.member[1u];
                                            let _e3091 = local_1.member_1[1u];
                                            let _e3094 = local_1.member[1u];
                                            let _e3100 = local_1.member_2[1u];
                                            if (((_e3088 + ((_e3091 - _e3094) * _e2756)) - _e3100) > _e3068) {
                                                let _e3105 = local_1.member[2u];
                                                let _e3108 = local_1.member_1[2u];
                                                let _e3111 = local_1.member[2u];
                                                let _e3117 = local_1.member_2[2u];
                                                if (((_e3105 + ((_e3108 - _e3111) * _e2756)) - _e3117) > _e3068) {
                                                    let _e3122 = local_1.member[3u];
                                                    let _e3125 = local_1.member_1[3u];
                                                    let _e3128 = local_1.member[3u];
                                                    let _e3134 = local_1.member_2[3u];
                                                    phi_5197_ = (((_e3122 + ((_e3125 - _e3128) * _e2756)) - _e3134) > _e3068);
                                                    phi_5198_ = false;
                                                } else {
                                                    phi_5197_ = bool();
                                                    phi_5198_ = true;
                                                }
                                                let _e3138 = phi_5197_;
                                                let _e3140 = phi_5198_;
                                                phi_5199_ = _e3138;
                                                phi_5200_ = _e3140;
                                            } else {
                                                phi_5199_ = bool();
                                                phi_5200_ = true;
                                            }
                                            let _e3142 = phi_5199_;
                                            let _e3144 = phi_5200_;
                                            phi_5201_ = _e3142;
                                            phi_5202_ = _e3144;
                                        } else {
                                            phi_5201_ = bool();
                                            phi_5202_ = true;
                                        }
                                        let _e3146 = phi_5201_;
                                        let _e3148 = phi_5202_;
                                        if select(_e3146, false, _e3148) {
                                            if (_e2756 <= _e2758) {
                                                phi_5517_ = true;
                                            } else {
                                                let _e3151 = f64(0f);
                                                let _e3154 = local.member[0u];
                                                let _e3157 = local.member_1[0u];
                                                let _e3160 = local.member[0u];
                                                let _e3166 = local.member_2[0u];
                                                let _e3170 = local_1.member[0u];
                                                let _e3173 = local_1.member_1[0u];
                                                let _e3176 = local_1.member[0u];
                                                let _e3182 = local_1.member_2[0u];
                                                if ((((_e3154 + ((_e3157 - _e3160) * _e2756)) - _e3166) + ((_e3170 + ((_e3173 - _e3176) * _e2762)) - _e3182)) > _e3151) {
                                                    let _e3188 = local.member[1u];
                                                    let _e3191 = local.member_1[1u];
                                                    let _e3194 = local.member[1u];
                                                    let _e3200 = local.member_2[1u];
                                                    let _e3204 = local_1.member[1u];
                                                    let _e3207 = local_1.member_1[1u];
                                                    let _e3210 = local_1.member[1u];
                                                    let _e3216 = local_1.member_2[1u];
                                                    if ((((_e3188 + ((_e3191 - _e3194) * _e2756)) - _e3200) + ((_e3204 + ((_e3207 - _e3210) * _e2762)) - _e3216)) > _e3151) {
                                                        let _e3222 = local.member[2u];
                                                        let _e3225 = local.member_1[2u];
                                                        let _e3228 = local.member[2u];
                                                        let _e3234 = local.member_2[2u];
                                                        let _e3238 = local_1.member[2u];
                                                        let _e3241 = local_1.member_1[2u];
                                                        let _e3244 = local_1.member[2u];
                                                        let _e3250 = local_1.member_2[2u];
                                                        if ((((_e3222 + ((_e3225 - _e3228) * _e2756)) - _e3234) + ((_e3238 + ((_e3241 - _e3244) * _e2762)) - _e3250)) > _e3151) {
                                                            let _e3256 = local.member[3u];
                                                            let _e3259 = local.member_1[3u];
                                                            let _e3262 = local.member[3u];
                                                            let _e3268 = local.member_2[3u];
                                                            let _e3272 = local_1.member[3u];
                                                            let _e3275 = local_1.member_1[3u];
                                                            let _e3278 = local_1.member[3u];
                                                            let _e3284 = local_1.member_2[3u];
                                                            phi_5504_ = ((((_e3256 + ((_e3259 - _e3262) * _e2756)) - _e3268) + ((_e3272 + ((_e3275 - _e3278) * _e2762)) - _e3284)) > _e3151);
                                                            phi_5505_ = false;
                                                        } else {
                                                            phi_5504_ = bool();
                                                            phi_5505_ = true;
                                                        }
                                                        let _e3289 = phi_5504_;
                                                        let _e3291 = phi_5505_;
                                                        phi_5506_ = _e3289;
                                                        phi_5507_ = _e3291;
                                                    } else {
                                                        phi_5506_ = bool();
                                                        phi_5507_ = true;
                                                    }
                                                    let _e3293 = phi_5506_;
                                                    let _e3295 = phi_5507_;
                                                    phi_5508_ = _e3293;
                                                    phi_5509_ = _e3295;
                                                } else {
                                                    phi_5508_ = bool();
                                                    phi_5509_ = true;
                                                }
                                                let _e3297 = phi_5508_;
                                                let _e3299 = phi_5509_;
                                                phi_5517_ = select(_e3297, false, _e3299);
                                            }
                                            let _e3302 = phi_5517_;
                                            if _e3302 {
                                                if select(true, select(true, false, (_e2756 >= _e2523.member_1)), _e2764) {
                                                    local = type_44(array<f64, 4>(_e3046.member[0], _e3046.member[1], _e3046.member[2], _e3046.member[3]), array<f64, 4>(_e3046.member_1[0], _e3046.member_1[1], _e3046.member_1[2], _e3046.member_1[3]), array<f64, 4>(_e3046.member_2[0], _e3046.member_2[1], _e3046.member_2[2], _e3046.member_2[3]));
                                                    let _e3327 = local.member[0u];
                                                    let _e3330 = local.member_1[0u];
                                                    let _e3333 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e3330 > _e3333)), (_e3327 > _e3333)) {
                                                        let _e3338 = (_e3330 >= _e3327);
                                                        if _e3338 {
                                                            phi_5629_ = f64();
                                                            phi_5630_ = false;
                                                        } else {
                                                            if ((_e3327 - _e3330) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5627_ = (((_e3327 - _e3333) / (_e3327 - _e3330)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5628_ = false;
                                                            } else {
                                                                phi_5627_ = f64();
                                                                phi_5628_ = true;
                                                            }
                                                            let _e3352 = phi_5627_;
                                                            let _e3354 = phi_5628_;
                                                            phi_5629_ = _e3352;
                                                            phi_5630_ = _e3354;
                                                        }
                                                        let _e3356 = phi_5629_;
                                                        let _e3358 = phi_5630_;
                                                        phi_5631_ = _e3356;
                                                        phi_5632_ = _e3338;
                                                        phi_5633_ = _e3358;
                                                    } else {
                                                        phi_5631_ = f64();
                                                        phi_5632_ = true;
                                                        phi_5633_ = false;
                                                    }
                                                    let _e3360 = phi_5631_;
                                                    let _e3362 = phi_5632_;
                                                    let _e3364 = phi_5633_;
                                                    let _e3368 = select(_e3360, select(_e2756, f64(2f), _e3362), select(_e3364, true, _e3362));
                                                    let _e3371 = local.member[1u];
                                                    let _e3374 = local.member_1[1u];
                                                    let _e3377 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e3374 > _e3377)), (_e3371 > _e3377)) {
                                                        let _e3382 = (_e3374 >= _e3371);
                                                        if _e3382 {
                                                            phi_5701_ = f64();
                                                            phi_5702_ = false;
                                                        } else {
                                                            if ((_e3371 - _e3374) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5699_ = (((_e3371 - _e3377) / (_e3371 - _e3374)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5700_ = false;
                                                            } else {
                                                                phi_5699_ = f64();
                                                                phi_5700_ = true;
                                                            }
                                                            let _e3396 = phi_5699_;
                                                            let _e3398 = phi_5700_;
                                                            phi_5701_ = _e3396;
                                                            phi_5702_ = _e3398;
                                                        }
                                                        let _e3400 = phi_5701_;
                                                        let _e3402 = phi_5702_;
                                                        phi_5703_ = _e3400;
                                                        phi_5704_ = _e3382;
                                                        phi_5705_ = _e3402;
                                                    } else {
                                                        phi_5703_ = f64();
                                                        phi_5704_ = true;
                                                        phi_5705_ = false;
                                                    }
                                                    let _e3404 = phi_5703_;
                                                    let _e3406 = phi_5704_;
                                                    let _e3408 = phi_5705_;
                                                    let _e3412 = select(_e3404, select(_e2756, f64(2f), _e3406), select(_e3408, true, _e3406));
                                                    let _e3414 = select(_e3412, _e3368, (_e3368 < _e3412));
                                                    let _e3417 = local.member[2u];
                                                    let _e3420 = local.member_1[2u];
                                                    let _e3423 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3420 > _e3423)), (_e3417 > _e3423)) {
                                                        let _e3428 = (_e3420 >= _e3417);
                                                        if _e3428 {
                                                            phi_5778_ = f64();
                                                            phi_5779_ = false;
                                                        } else {
                                                            if ((_e3417 - _e3420) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5776_ = (((_e3417 - _e3423) / (_e3417 - _e3420)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5777_ = false;
                                                            } else {
                                                                phi_5776_ = f64();
                                                                phi_5777_ = true;
                                                            }
                                                            let _e3442 = phi_5776_;
                                                            let _e3444 = phi_5777_;
                                                            phi_5778_ = _e3442;
                                                            phi_5779_ = _e3444;
                                                        }
                                                        let _e3446 = phi_5778_;
                                                        let _e3448 = phi_5779_;
                                                        phi_5780_ = _e3446;
                                                        phi_5781_ = _e3428;
                                                        phi_5782_ = _e3448;
                                                    } else {
                                                        phi_5780_ = f64();
                                                        phi_5781_ = true;
                                                        phi_5782_ = false;
                                                    }
                                                    let _e3450 = phi_5780_;
                                                    let _e3452 = phi_5781_;
                                                    let _e3454 = phi_5782_;
                                                    let _e3458 = select(_e3450, select(_e2756, f64(2f), _e3452), select(_e3454, true, _e3452));
                                                    let _e3461 = local.member[3u];
                                                    let _e3464 = local.member_1[3u];
                                                    let _e3467 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3464 > _e3467)), (_e3461 > _e3467)) {
                                                        let _e3472 = (_e3464 >= _e3461);
                                                        if _e3472 {
                                                            phi_5850_ = f64();
                                                            phi_5851_ = false;
                                                        } else {
                                                            if ((_e3461 - _e3464) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5848_ = (((_e3461 - _e3467) / (_e3461 - _e3464)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5849_ = false;
                                                            } else {
                                                                phi_5848_ = f64();
                                                                phi_5849_ = true;
                                                            }
                                                            let _e3486 = phi_5848_;
                                                            let _e3488 = phi_5849_;
                                                            phi_5850_ = _e3486;
                                                            phi_5851_ = _e3488;
                                                        }
                                                        let _e3490 = phi_5850_;
                                                        let _e3492 = phi_5851_;
                                                        phi_5852_ = _e3490;
                                                        phi_5853_ = _e3472;
                                                        phi_5854_ = _e3492;
                                                    } else {
                                                        phi_5852_ = f64();
                                                        phi_5853_ = true;
                                                        phi_5854_ = false;
                                                    }
                                                    let _e3494 = phi_5852_;
                                                    let _e3496 = phi_5853_;
                                                    let _e3498 = phi_5854_;
                                                    let _e3502 = select(_e3494, select(_e2756, f64(2f), _e3496), select(_e3498, true, _e3496));
                                                    let _e3504 = select(_e3502, _e3458, (_e3458 < _e3502));
                                                    let _e3506 = select(_e3504, _e3414, (_e3414 < _e3504));
                                                    let _e3508 = select(_e2756, _e3506, (_e3506 > _e2756));
                                                    let _e3509 = (_e3508 > _e2523.member_1);
                                                    if _e3509 {
                                                        phi_6396_ = f64();
                                                        phi_6397_ = f64();
                                                        phi_6398_ = false;
                                                        phi_6399_ = false;
                                                    } else {
                                                        let _e3510 = (_e3508 - _e2756);
                                                        let _e3511 = (_e3510 <= _e2745);
                                                        let _e3514 = (_e3508 + (_e524 * f64(0.01f)));
                                                        let _e3516 = select(_e2523.member_1, _e3514, (_e3514 < _e2523.member_1));
                                                        if _e3511 {
                                                            if (_e1255 > f64(0f)) {
                                                                let _e3521 = local_7.member[0u];
                                                                let _e3527 = local_7.member[1u];
                                                                let _e3543 = local_7.member_1[0u];
                                                                let _e3549 = local_7.member_1[1u];
                                                                let _e3565 = local_7.member_2[0u];
                                                                let _e3571 = local_7.member_2[1u];
                                                                let _e3585 = function_5(array<f64, 3>((_e3521[0] + ((_e3527[0] - _e3521[0]) * _e3516)), (_e3521[1] + ((_e3527[1] - _e3521[1]) * _e3516)), (_e3521[2] + ((_e3527[2] - _e3521[2]) * _e3516))), array<f64, 3>((_e3543[0] + ((_e3549[0] - _e3543[0]) * _e3516)), (_e3543[1] + ((_e3549[1] - _e3543[1]) * _e3516)), (_e3543[2] + ((_e3549[2] - _e3543[2]) * _e3516))), array<f64, 3>((_e3565[0] + ((_e3571[0] - _e3565[0]) * _e3516)), (_e3565[1] + ((_e3571[1] - _e3565[1]) * _e3516)), (_e3565[2] + ((_e3571[2] - _e3565[2]) * _e3516))), _e230.member);
                                                                let _e3596 = (((_e3585[0] * _e3585[0]) + (_e3585[1] * _e3585[1])) + (_e3585[2] * _e3585[2]));
                                                                if (_e3596 <= 2.2250738585072014e-308lf) {
                                                                    phi_6088_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3596 > 0.0lf));
                                                                } else {
                                                                    phi_6031_ = type_16(0i, 5i);
                                                                    phi_6034_ = bitcast<f64>(((bitcast<u64>(_e3596) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e3603 = phi_6031_;
                                                                        let _e3605 = phi_6034_;
                                                                        local_21 = _e3605;
                                                                        if (_e3603.member < _e3603.member_1) {
                                                                            let _e3612 = (_e3603.member + 1i);
                                                                            phi_6032_ = type_16(select(_e3612, type_17().member_1, select(false, true, ((false == (_e3612 > _e3603.member)) != false))), _e3603.member_1);
                                                                            phi_6075_ = type_17(1u, _e3603.member);
                                                                        } else {
                                                                            phi_6032_ = _e3603;
                                                                            phi_6075_ = type_17(0u, type_17().member_1);
                                                                        }
                                                                        let _e3623 = phi_6032_;
                                                                        let _e3625 = phi_6075_;
                                                                        let _e3628 = (bitcast<i32>(_e3625.member) != 0i);
                                                                        if _e3628 {
                                                                            phi_6035_ = (0.5lf * (_e3605 + (_e3596 / _e3605)));
                                                                        } else {
                                                                            phi_6035_ = f64();
                                                                        }
                                                                        let _e3633 = phi_6035_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_6031_ = _e3623;
                                                                            phi_6034_ = _e3633;
                                                                            break if !(_e3628);
                                                                        }
                                                                    }
                                                                    let _e3638 = local_21;
                                                                    phi_6088_ = (_e3638 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e3644 = phi_6088_;
                                                                let _e3652 = local_7.member[0u];
                                                                let _e3658 = select(_e3652[0], -(_e3652[0]), (_e3652[0] < 0.0lf));
                                                                let _e3661 = select(_e3652[1], -(_e3652[1]), (_e3652[1] < 0.0lf));
                                                                let _e3663 = select(_e3661, _e3658, (_e3658 > _e3661));
                                                                let _e3666 = select(_e3652[2], -(_e3652[2]), (_e3652[2] < 0.0lf));
                                                                let _e3668 = select(_e3666, _e3663, (_e3663 > _e3666));
                                                                let _e3671 = local_7.member[1u];
                                                                let _e3677 = select(_e3671[0], -(_e3671[0]), (_e3671[0] < 0.0lf));
                                                                let _e3680 = select(_e3671[1], -(_e3671[1]), (_e3671[1] < 0.0lf));
                                                                let _e3682 = select(_e3680, _e3677, (_e3677 > _e3680));
                                                                let _e3685 = select(_e3671[2], -(_e3671[2]), (_e3671[2] < 0.0lf));
                                                                let _e3687 = select(_e3685, _e3682, (_e3682 > _e3685));
                                                                let _e3691 = local_7.member_3;
                                                                let _e3695 = local_7.member_1[0u];
                                                                let _e3701 = select(_e3695[0], -(_e3695[0]), (_e3695[0] < 0.0lf));
                                                                let _e3704 = select(_e3695[1], -(_e3695[1]), (_e3695[1] < 0.0lf));
                                                                let _e3706 = select(_e3704, _e3701, (_e3701 > _e3704));
                                                                let _e3709 = select(_e3695[2], -(_e3695[2]), (_e3695[2] < 0.0lf));
                                                                let _e3711 = select(_e3709, _e3706, (_e3706 > _e3709));
                                                                let _e3714 = local_7.member_1[1u];
                                                                let _e3720 = select(_e3714[0], -(_e3714[0]), (_e3714[0] < 0.0lf));
                                                                let _e3723 = select(_e3714[1], -(_e3714[1]), (_e3714[1] < 0.0lf));
                                                                let _e3725 = select(_e3723, _e3720, (_e3720 > _e3723));
                                                                let _e3728 = select(_e3714[2], -(_e3714[2]), (_e3714[2] < 0.0lf));
                                                                let _e3730 = select(_e3728, _e3725, (_e3725 > _e3728));
                                                                let _e3734 = local_7.member_3;
                                                                let _e3738 = local_7.member_2[0u];
                                                                let _e3744 = select(_e3738[0], -(_e3738[0]), (_e3738[0] < 0.0lf));
                                                                let _e3747 = select(_e3738[1], -(_e3738[1]), (_e3738[1] < 0.0lf));
                                                                let _e3749 = select(_e3747, _e3744, (_e3744 > _e3747));
                                                                let _e3752 = select(_e3738[2], -(_e3738[2]), (_e3738[2] < 0.0lf));
                                                                let _e3754 = select(_e3752, _e3749, (_e3749 > _e3752));
                                                                let _e3757 = local_7.member_2[1u];
                                                                let _e3763 = select(_e3757[0], -(_e3757[0]), (_e3757[0] < 0.0lf));
                                                                let _e3766 = select(_e3757[1], -(_e3757[1]), (_e3757[1] < 0.0lf));
                                                                let _e3768 = select(_e3766, _e3763, (_e3763 > _e3766));
                                                                let _e3771 = select(_e3757[2], -(_e3757[2]), (_e3757[2] < 0.0lf));
                                                                let _e3773 = select(_e3771, _e3768, (_e3768 > _e3771));
                                                                let _e3777 = local_7.member_3;
                                                                let _e3785 = local_7.member_3;
                                                                phi_6365_ = select(true, false, (((_e3644 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e3687, _e3668, (_e3668 > _e3687)) + _e3691) + (select(_e3730, _e3711, (_e3711 > _e3730)) + _e3734)) + (select(_e3773, _e3754, (_e3754 > _e3773)) + _e3777)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3785 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e1255));
                                                            } else {
                                                                phi_6365_ = true;
                                                            }
                                                            let _e3798 = phi_6365_;
                                                            phi_6366_ = _e3798;
                                                        } else {
                                                            phi_6366_ = true;
                                                        }
                                                        let _e3800 = phi_6366_;
                                                        if _e3800 {
                                                            if _e2764 {
                                                                let _e3804 = (_e3510 <= (_e2760 * f64(0.25f)));
                                                                phi_6393_ = select(select(select(f64(), f64(0f), _e3804), f64(), _e3511), (_e3066 + _e3066), select(select(true, false, _e3804), true, _e3511));
                                                            } else {
                                                                phi_6393_ = (_e2523.member_1 - _e2756);
                                                            }
                                                            let _e3813 = phi_6393_;
                                                            phi_6394_ = _e3813;
                                                            phi_6395_ = false;
                                                        } else {
                                                            phi_6394_ = f64();
                                                            phi_6395_ = true;
                                                        }
                                                        let _e3815 = phi_6394_;
                                                        let _e3817 = phi_6395_;
                                                        phi_6396_ = _e3815;
                                                        phi_6397_ = _e3510;
                                                        phi_6398_ = _e3800;
                                                        phi_6399_ = _e3817;
                                                    }
                                                    let _e3819 = phi_6396_;
                                                    let _e3821 = phi_6397_;
                                                    let _e3823 = phi_6398_;
                                                    let _e3825 = phi_6399_;
                                                    phi_6400_ = _e3508;
                                                    phi_6401_ = _e3819;
                                                    phi_6402_ = _e3821;
                                                    phi_6403_ = _e3508;
                                                    phi_6404_ = _e3823;
                                                    phi_6405_ = _e3509;
                                                    phi_6406_ = _e3825;
                                                    phi_6407_ = false;
                                                } else {
                                                    phi_6400_ = f64();
                                                    phi_6401_ = f64();
                                                    phi_6402_ = f64();
                                                    phi_6403_ = f64();
                                                    phi_6404_ = false;
                                                    phi_6405_ = false;
                                                    phi_6406_ = false;
                                                    phi_6407_ = true;
                                                }
                                                let _e3827 = phi_6400_;
                                                let _e3829 = phi_6401_;
                                                let _e3831 = phi_6402_;
                                                let _e3833 = phi_6403_;
                                                let _e3835 = phi_6404_;
                                                let _e3837 = phi_6405_;
                                                let _e3839 = phi_6406_;
                                                let _e3841 = phi_6407_;
                                                phi_6408_ = _e3827;
                                                phi_6409_ = _e3829;
                                                phi_6410_ = _e3831;
                                                phi_6411_ = _e3833;
                                                phi_6412_ = false;
                                                phi_6413_ = _e3835;
                                                phi_6414_ = _e3837;
                                                phi_6415_ = _e3839;
                                                phi_6416_ = _e3841;
                                            } else {
                                                phi_6408_ = f64();
                                                phi_6409_ = f64();
                                                phi_6410_ = f64();
                                                phi_6411_ = f64();
                                                phi_6412_ = true;
                                                phi_6413_ = false;
                                                phi_6414_ = false;
                                                phi_6415_ = false;
                                                phi_6416_ = false;
                                            }
                                            let _e3843 = phi_6408_;
                                            let _e3845 = phi_6409_;
                                            let _e3847 = phi_6410_;
                                            let _e3849 = phi_6411_;
                                            let _e3851 = phi_6412_;
                                            let _e3853 = phi_6413_;
                                            let _e3855 = phi_6414_;
                                            let _e3857 = phi_6415_;
                                            let _e3859 = phi_6416_;
                                            phi_6417_ = _e3843;
                                            phi_6418_ = _e3845;
                                            phi_6419_ = _e3847;
                                            phi_6420_ = _e3849;
                                            phi_6421_ = _e3851;
                                            phi_6422_ = _e3853;
                                            phi_6423_ = _e3855;
                                            phi_6424_ = _e3857;
                                            phi_6425_ = _e3859;
                                        } else {
                                            phi_6417_ = f64();
                                            phi_6418_ = f64();
                                            phi_6419_ = f64();
                                            phi_6420_ = f64();
                                            phi_6421_ = true;
                                            phi_6422_ = false;
                                            phi_6423_ = false;
                                            phi_6424_ = false;
                                            phi_6425_ = false;
                                        }
                                        let _e3861 = phi_6417_;
                                        let _e3863 = phi_6418_;
                                        let _e3865 = phi_6419_;
                                        let _e3867 = phi_6420_;
                                        let _e3869 = phi_6421_;
                                        let _e3871 = phi_6422_;
                                        let _e3873 = phi_6423_;
                                        let _e3875 = phi_6424_;
                                        let _e3877 = phi_6425_;
                                        if _e3869 {
                                            if (_e2756 <= _e2758) {
                                                let _e4035 = (_e2766 + 1u);
                                                let _e4036 = (_e4035 > 3u);
                                                phi_6765_ = _e4035;
                                                phi_6766_ = f64();
                                                phi_6767_ = false;
                                                phi_6768_ = select(true, false, _e4036);
                                                phi_6769_ = _e4036;
                                            } else {
                                                let _e3881 = local.member[0u];
                                                let _e3884 = local.member_1[0u];
                                                let _e3887 = local.member[0u];
                                                let _e3893 = local.member_2[0u];
                                                let _e3894 = ((_e3881 + ((_e3884 - _e3887) * _e2762)) - _e3893);
                                                let _e3897 = local.member[1u];
                                                let _e3900 = local.member_1[1u];
                                                let _e3903 = local.member[1u];
                                                let _e3909 = local.member_2[1u];
                                                let _e3910 = ((_e3897 + ((_e3900 - _e3903) * _e2762)) - _e3909);
                                                let _e3912 = select(_e3910, _e3894, (_e3894 < _e3910));
                                                let _e3915 = local.member[2u];
                                                let _e3918 = local.member_1[2u];
                                                let _e3921 = local.member[2u];
                                                let _e3927 = local.member_2[2u];
                                                let _e3928 = ((_e3915 + ((_e3918 - _e3921) * _e2762)) - _e3927);
                                                let _e3931 = local.member[3u];
                                                let _e3934 = local.member_1[3u];
                                                let _e3937 = local.member[3u];
                                                let _e3943 = local.member_2[3u];
                                                let _e3944 = ((_e3931 + ((_e3934 - _e3937) * _e2762)) - _e3943);
                                                let _e3946 = select(_e3944, _e3928, (_e3928 < _e3944));
                                                let _e3948 = select(_e3946, _e3912, (_e3912 < _e3946));
                                                let _e3951 = local_1.member[0u];
                                                let _e3954 = local_1.member_1[0u];
                                                let _e3957 = local_1.member[0u];
                                                let _e3963 = local_1.member_2[0u];
                                                let _e3964 = ((_e3951 + ((_e3954 - _e3957) * _e2756)) - _e3963);
                                                let _e3967 = local_1.member[1u];
                                                let _e3970 = local_1.member_1[1u];
                                                let _e3973 = local_1.member[1u];
                                                let _e3979 = local_1.member_2[1u];
                                                let _e3980 = ((_e3967 + ((_e3970 - _e3973) * _e2756)) - _e3979);
                                                let _e3982 = select(_e3980, _e3964, (_e3964 < _e3980));
                                                let _e3985 = local_1.member[2u];
                                                let _e3988 = local_1.member_1[2u];
                                                let _e3991 = local_1.member[2u];
                                                let _e3997 = local_1.member_2[2u];
                                                let _e3998 = ((_e3985 + ((_e3988 - _e3991) * _e2756)) - _e3997);
                                                let _e4001 = local_1.member[3u];
                                                let _e4004 = local_1.member_1[3u];
                                                let _e4007 = local_1.member[3u];
                                                let _e4013 = local_1.member_2[3u];
                                                let _e4014 = ((_e4001 + ((_e4004 - _e4007) * _e2756)) - _e4013);
                                                let _e4016 = select(_e4014, _e3998, (_e3998 < _e4014));
                                                let _e4018 = select(_e4016, _e3982, (_e3982 < _e4016));
                                                let _e4019 = f64(0.0625f);
                                                let _e4021 = f64(0.9f);
                                                if (_e4018 > f64(0f)) {
                                                    phi_6763_ = f64(0.5f);
                                                } else {
                                                    let _e4027 = (f64(0.95f) * (_e3948 / (_e3948 - _e4018)));
                                                    phi_6763_ = select(_e4019, select(_e4021, _e4027, (_e4027 < _e4021)), (_e4027 > _e4019));
                                                }
                                                let _e4033 = phi_6763_;
                                                phi_6765_ = u32();
                                                phi_6766_ = (_e3066 * _e4033);
                                                phi_6767_ = true;
                                                phi_6768_ = false;
                                                phi_6769_ = false;
                                            }
                                            let _e4039 = phi_6765_;
                                            let _e4041 = phi_6766_;
                                            let _e4043 = phi_6767_;
                                            let _e4045 = phi_6768_;
                                            let _e4047 = phi_6769_;
                                            phi_6770_ = _e4039;
                                            phi_6771_ = _e2758;
                                            phi_6772_ = _e4041;
                                            phi_6773_ = _e2760;
                                            phi_6774_ = _e2762;
                                            phi_6775_ = _e2764;
                                            phi_6776_ = _e2766;
                                            phi_6777_ = _e4043;
                                            phi_6778_ = _e4045;
                                            phi_6779_ = _e4047;
                                            phi_6780_ = false;
                                            phi_6781_ = false;
                                            phi_6782_ = false;
                                        } else {
                                            phi_6770_ = u32();
                                            phi_6771_ = _e3861;
                                            phi_6772_ = _e3863;
                                            phi_6773_ = _e3865;
                                            phi_6774_ = _e2756;
                                            phi_6775_ = true;
                                            phi_6776_ = 0u;
                                            phi_6777_ = _e3871;
                                            phi_6778_ = false;
                                            phi_6779_ = false;
                                            phi_6780_ = _e3873;
                                            phi_6781_ = _e3875;
                                            phi_6782_ = _e3877;
                                        }
                                        let _e4049 = phi_6770_;
                                        let _e4051 = phi_6771_;
                                        let _e4053 = phi_6772_;
                                        let _e4055 = phi_6773_;
                                        let _e4057 = phi_6774_;
                                        let _e4059 = phi_6775_;
                                        let _e4061 = phi_6776_;
                                        let _e4063 = phi_6777_;
                                        let _e4065 = phi_6778_;
                                        let _e4067 = phi_6779_;
                                        let _e4069 = phi_6780_;
                                        let _e4071 = phi_6781_;
                                        let _e4073 = phi_6782_;
                                        if _e4063 {
                                            let _e4074 = (_e4057 + _e4053);
                                            let _e4076 = select(_e4051, _e4074, (_e4074 > _e4051));
                                            let _e4078 = select(_e2523.member_1, _e4076, (_e4076 < _e2523.member_1));
                                            let _e4081 = select(((_e4078 - _e4057) > _e2745), true, !(_e2764));
                                            phi_6810_ = _e4078;
                                            phi_6811_ = _e4051;
                                            phi_6812_ = _e4055;
                                            phi_6813_ = _e4057;
                                            phi_6814_ = _e4059;
                                            phi_6815_ = _e4061;
                                            phi_6816_ = _e4081;
                                            phi_6817_ = select(true, false, _e4081);
                                            phi_6818_ = false;
                                            phi_6819_ = false;
                                            phi_6820_ = false;
                                            phi_6821_ = false;
                                        } else {
                                            phi_6810_ = _e2756;
                                            phi_6811_ = _e2758;
                                            phi_6812_ = _e2760;
                                            phi_6813_ = _e2762;
                                            phi_6814_ = _e2764;
                                            phi_6815_ = _e4049;
                                            phi_6816_ = _e4065;
                                            phi_6817_ = false;
                                            phi_6818_ = _e4067;
                                            phi_6819_ = _e4069;
                                            phi_6820_ = _e4071;
                                            phi_6821_ = _e4073;
                                        }
                                        let _e4084 = phi_6810_;
                                        let _e4086 = phi_6811_;
                                        let _e4088 = phi_6812_;
                                        let _e4090 = phi_6813_;
                                        let _e4092 = phi_6814_;
                                        let _e4094 = phi_6815_;
                                        let _e4096 = phi_6816_;
                                        let _e4098 = phi_6817_;
                                        let _e4100 = phi_6818_;
                                        let _e4102 = phi_6819_;
                                        let _e4104 = phi_6820_;
                                        let _e4106 = phi_6821_;
                                        phi_4600_ = _e4084;
                                        phi_4602_ = _e4086;
                                        phi_4604_ = _e4088;
                                        phi_4606_ = _e4090;
                                        phi_4608_ = _e4092;
                                        phi_4610_ = _e4094;
                                        phi_6822_ = _e4051;
                                        phi_6823_ = _e3867;
                                        phi_6824_ = _e4096;
                                        phi_6825_ = _e4098;
                                        phi_6826_ = _e4100;
                                        phi_6827_ = _e4102;
                                        phi_6828_ = _e4104;
                                        phi_6829_ = false;
                                        phi_6830_ = _e4106;
                                    } else {
                                        phi_4600_ = f64();
                                        phi_4602_ = f64();
                                        phi_4604_ = f64();
                                        phi_4606_ = f64();
                                        phi_4608_ = bool();
                                        phi_4610_ = u32();
                                        phi_6822_ = f64();
                                        phi_6823_ = f64();
                                        phi_6824_ = false;
                                        phi_6825_ = false;
                                        phi_6826_ = false;
                                        phi_6827_ = false;
                                        phi_6828_ = false;
                                        phi_6829_ = true;
                                        phi_6830_ = false;
                                    }
                                    let _e4108 = phi_4600_;
                                    let _e4110 = phi_4602_;
                                    let _e4112 = phi_4604_;
                                    let _e4114 = phi_4606_;
                                    let _e4116 = phi_4608_;
                                    let _e4118 = phi_4610_;
                                    let _e4120 = phi_6822_;
                                    let _e4122 = phi_6823_;
                                    let _e4124 = phi_6824_;
                                    let _e4126 = phi_6825_;
                                    let _e4128 = phi_6826_;
                                    let _e4130 = phi_6827_;
                                    let _e4132 = phi_6828_;
                                    let _e4134 = phi_6829_;
                                    let _e4136 = phi_6830_;
                                    local_22 = _e4126;
                                    local_23 = _e4128;
                                    local_24 = _e4126;
                                    local_25 = _e4130;
                                    local_26 = _e4126;
                                    local_27 = _e4132;
                                    local_28 = _e4126;
                                    local_29 = _e4134;
                                    local_30 = _e4126;
                                    local_31 = _e4136;
                                    local_33 = _e4126;
                                    local_34 = _e4122;
                                    local_35 = _e4120;
                                    continue;
                                    continuing {
                                        phi_4596_ = type_9(select(_e2754.member, (_e2754.member + 1u), _e2769), select(_e2754.member_1, _e2754.member_1, _e2769));
                                        phi_4599_ = _e4108;
                                        phi_4601_ = _e4110;
                                        phi_4603_ = _e4112;
                                        phi_4605_ = _e4114;
                                        phi_4607_ = _e4116;
                                        phi_4609_ = _e4118;
                                        break if !(_e4124);
                                    }
                                }
                                let _e4139 = local_22;
                                let _e4141 = local_23;
                                let _e4142 = select(_e4141, false, _e4139);
                                let _e4144 = local_24;
                                let _e4146 = local_25;
                                let _e4149 = local_26;
                                let _e4151 = local_27;
                                let _e4154 = local_28;
                                let _e4156 = local_29;
                                let _e4159 = local_30;
                                let _e4161 = local_31;
                                let _e4167 = local_32;
                                let _e4169 = select(select(_e4146, false, _e4144), false, _e4142);
                                let _e4172 = local_33;
                                let _e4179 = select(select(select(_e4151, false, _e4149), false, _e4142), false, _e4169);
                                let _e4185 = local_34;
                                let _e4187 = local_35;
                                let _e4189 = select(select(select(_e4172, false, _e4142), false, _e4169), true, _e4179);
                                let _e4194 = local_36;
                                let _e4196 = select(select(select(select(select(_e4156, false, _e4154), false, _e4142), false, _e4169), false, _e4179), true, _e4189);
                                let _e4203 = select(select(select(select(select(select(_e4161, false, _e4159), false, _e4142), false, _e4169), false, _e4179), false, _e4189), false, _e4196);
                                let _e4208 = select(select(select(select(select(_e4142, true, _e4169), false, _e4179), false, _e4189), false, _e4196), true, _e4203);
                                let _e4211 = (select(select(type_42().member, 1u, _e4196), select(select(select(type_42().member, 1u, _e4142), 0u, _e4169), 0u, _e4203), _e4208) != 0u);
                                phi_6898_ = select(select(type_42().member_1, select(_e4194, select(_e4187, _e4185, _e4179), _e4189), _e4196), select(select(select(type_42().member_1, _e4167, _e4142), type_42().member_1, _e4169), type_42().member_1, _e4203), _e4208);
                                phi_6899_ = select(true, false, _e4211);
                                phi_6900_ = _e4211;
                                phi_6901_ = false;
                                phi_6902_ = false;
                                phi_6903_ = false;
                            } else {
                                phi_6898_ = f64();
                                phi_6899_ = _e2531;
                                phi_6900_ = false;
                                phi_6901_ = _e2533;
                                phi_6902_ = _e2535;
                                phi_6903_ = _e2537;
                            }
                            let _e4214 = phi_6898_;
                            let _e4216 = phi_6899_;
                            let _e4218 = phi_6900_;
                            let _e4220 = phi_6901_;
                            let _e4222 = phi_6902_;
                            let _e4224 = phi_6903_;
                            phi_6904_ = _e2523;
                            phi_6905_ = _e2525;
                            phi_6906_ = _e4214;
                            phi_6907_ = _e2527;
                            phi_6908_ = _e4216;
                            phi_6909_ = _e4218;
                            phi_6910_ = false;
                            phi_6911_ = _e4220;
                            phi_6912_ = _e4222;
                            phi_6913_ = _e4224;
                        } else {
                            phi_6904_ = type_43();
                            phi_6905_ = bool();
                            phi_6906_ = f64();
                            phi_6907_ = type_43();
                            phi_6908_ = false;
                            phi_6909_ = false;
                            phi_6910_ = true;
                            phi_6911_ = false;
                            phi_6912_ = false;
                            phi_6913_ = false;
                        }
                        let _e4226 = phi_6904_;
                        let _e4228 = phi_6905_;
                        let _e4230 = phi_6906_;
                        let _e4232 = phi_6907_;
                        let _e4234 = phi_6908_;
                        let _e4236 = phi_6909_;
                        let _e4238 = phi_6910_;
                        let _e4240 = phi_6911_;
                        let _e4242 = phi_6912_;
                        let _e4244 = phi_6913_;
                        local_37 = _e4236;
                        local_38 = _e4228;
                        local_39 = _e4226;
                        local_40 = _e4230;
                        local_41 = _e4230;
                        local_42 = _e4230;
                        local_46 = _e4238;
                        local_47 = _e4240;
                        local_48 = _e4242;
                        local_49 = _e4244;
                        local_43 = _e4236;
                        local_44 = _e4232;
                        continue;
                        continuing {
                            phi_2696_ = type_9(select(_e1506.member, (_e1506.member + 1u), _e1509), select(_e1506.member_1, _e1506.member_1, _e1509));
                            break if !(_e4234);
                        }
                    }
                    let _e4247 = local_37;
                    if _e4247 {
                        let _e4249 = local_38;
                        if _e4249 {
                            let _e4251 = local_39;
                            let _e4254 = local_40;
                            let _e4256 = ((_e4251.member_1 - _e4254) <= _e1469);
                            let _e4261 = local_41;
                            phi_6929_ = type_42(select(type_42().member, 1u, _e4256), select(type_42().member_1, _e4261, _e4256));
                            phi_6930_ = select(true, false, _e4256);
                        } else {
                            phi_6929_ = type_42();
                            phi_6930_ = true;
                        }
                        let _e4266 = phi_6929_;
                        let _e4268 = phi_6930_;
                        let _e4273 = local_42;
                        phi_6936_ = type_42(select(_e4266.member, 2u, _e4268), select(_e4266.member_1, _e4273, _e4268));
                        phi_6937_ = false;
                        phi_6938_ = false;
                        phi_6939_ = false;
                        phi_6940_ = false;
                    } else {
                        phi_6936_ = type_42();
                        let _e4761 = local_46;
                        phi_6937_ = _e4761;
                        let _e4764 = local_47;
                        phi_6938_ = _e4764;
                        let _e4767 = local_48;
                        phi_6939_ = _e4767;
                        let _e4770 = local_49;
                        phi_6940_ = _e4770;
                    }
                    let _e4277 = phi_6936_;
                    let _e4279 = phi_6937_;
                    let _e4281 = phi_6938_;
                    let _e4283 = phi_6939_;
                    let _e4285 = phi_6940_;
                    let _e4292 = select(_e4281, false, _e4279);
                    let _e4296 = local_43;
                    let _e4303 = select(select(_e4283, false, _e4279), false, _e4292);
                    let _e4309 = select(select(select(_e4285, false, _e4279), false, _e4292), false, _e4303);
                    let _e4313 = local_44;
                    let _e4317 = select(select(_e4292, true, _e4303), true, _e4309);
                    phi_6982_ = type_42(select(_e4277.member, select(select(select(type_42().member, 0u, _e4292), 0u, _e4303), 1u, _e4309), _e4317), select(_e4277.member_1, select(select(select(type_42().member_1, type_42().member_1, _e4292), type_42().member_1, _e4303), _e4313.member, _e4309), _e4317));
                    phi_6983_ = type_42(select(type_42().member, 0u, _e4279), select(type_42().member_1, type_42().member_1, _e4279));
                    phi_6984_ = select(select(select(select(select(_e4296, false, _e4279), false, _e4292), false, _e4303), false, _e4309), true, _e4317);
                }
                let _e4328 = phi_6982_;
                let _e4330 = phi_6983_;
                let _e4332 = phi_6984_;
                let _e4335 = select(_e4330.member, _e4328.member, _e4332);
                let _e4338 = select(_e4330.member_1, _e4328.member_1, _e4332);
                let _e4344 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e4338 > _e533)), (_e4335 == 1u))));
                switch bitcast<i32>(_e4335) {
                    case 0: {
                        phi_7028_ = type_35(0u, _e4344, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4348 = function_2(_e4338);
                        phi_7028_ = type_35(0u, _e4344, _e4348, true);
                        break;
                    }
                    case 2: {
                        let _e4346 = function_2(_e4338);
                        phi_7028_ = type_35(1u, _e4344, _e4346, true);
                        break;
                    }
                    default: {
                        phi_7028_ = type_35();
                        break;
                    }
                }
                let _e4352 = phi_7028_;
                local_8 = type_35(_e4352.member, _e4352.member_1, array<u32, 2>(_e4352.member_2[0], _e4352.member_2[1]), _e4352.member_3);
                phi_7037_ = type_9(_e188, _e191);
            } else {
                phi_7037_ = type_9(0u, 0u);
            }
            let _e4362 = phi_7037_;
            let _e4368 = local_8.member;
            let _e4370 = select(true, false, (_e4368 == 0u));
            let _e4372 = local_8.member_3;
            if _e4372 {
                if _e4370 {
                    phi_7066_ = true;
                } else {
                    let _e4374 = params.member.member.member_1;
                    phi_7066_ = ((_e4374 & 16u) != 0u);
                }
                let _e4378 = phi_7066_;
                phi_7067_ = _e4378;
            } else {
                phi_7067_ = false;
            }
            let _e4380 = phi_7067_;
            let _e4382 = local_8.member_3;
            if _e4382 {
                if _e4370 {
                } else {
                    let _e4384 = local_8.member_2;
                    let _e4388 = (_e4384[1] >> bitcast<u32>(20i));
                    let _e4402 = atomicMin((&earliest.member[0u]), select(((((_e4388 - 896u) << bitcast<u32>(23i)) | ((_e4384[1] & 1048575u) << bitcast<u32>(3i))) | (_e4384[0] >> bitcast<u32>(29i))), 0u, (_e4388 <= 896u)));
                }
            }
            if (_e106 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4380 {
                let _e4406 = atomicAdd((&counters[0u]), 1u);
                phi_7110_ = _e4406;
            } else {
                phi_7110_ = 0u;
            }
            let _e4408 = phi_7110_;
            workgroupBarrier();
            if (_e106 == 0u) {
                let _e4411 = atomicLoad((&counters[0u]));
                if (_e4411 > 0u) {
                    let _e4414 = atomicAdd((&contacts.member[0u]), _e4411);
                    atomicStore((&counters[1u]), _e4414);
                }
            }
            workgroupBarrier();
            let _e4417 = atomicLoad((&counters[1u]));
            let _e4418 = (_e4417 + _e4408);
            if _e4380 {
                let _e4420 = params.member.member_1.member_3;
                if (_e4418 < _e4420) {
                    let _e4426 = (7u * _e4418);
                    atomicStore((&contacts.member[(4u + _e4426)]), select(1u, 0u, ((_e4362.member_1 & 2147483648u) == 0u)));
                    let _e4431 = local_8.member;
                    atomicStore((&contacts.member[(_e4426 + 5u)]), _e4431);
                    atomicStore((&contacts.member[(_e4426 + 6u)]), _e4362.member);
                    atomicStore((&contacts.member[(_e4426 + 7u)]), (_e4362.member_1 & 2147483647u));
                    let _e4440 = local_8.member_2[0u];
                    atomicStore((&contacts.member[(_e4426 + 8u)]), _e4440);
                    let _e4445 = local_8.member_2[1u];
                    atomicStore((&contacts.member[(_e4426 + 9u)]), _e4445);
                    let _e4449 = local_8.member_1;
                    atomicStore((&contacts.member[(_e4426 + 10u)]), _e4449);
                }
            }
        }
        continue;
        continuing {
            phi_552_ = type_9(select(_e159.member, (_e159.member + 1u), _e162), select(_e159.member_1, _e159.member_1, _e162));
            break if !(_e175);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn advance_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
