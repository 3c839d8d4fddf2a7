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
    var phi_249_: f64;
    var phi_292_: f64;
    var phi_335_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_249_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_249_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_249_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_292_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_292_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_292_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_335_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_335_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_335_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_1(param_1: ptr<function, type_39>, param_2: f64, param_3: f64, param_4: f64) -> bool {
    var phi_433_: bool;
    var phi_434_: bool;
    var phi_439_: bool;

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
            phi_433_ = select(bool(), ((_e45 > f64(0f)) == (_e72 > f64(0f))), _e87);
            phi_434_ = select(true, false, _e87);
        } else {
            phi_433_ = bool();
            phi_434_ = true;
        }
        let _e96 = phi_433_;
        let _e98 = phi_434_;
        phi_439_ = select(_e96, false, _e98);
    } else {
        phi_439_ = false;
    }
    let _e101 = phi_439_;
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
    var phi_7518_: array<array<f64, 3>, 4>;

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
        phi_7518_ = array<array<f64, 3>, 4>(array<f64, 3>((param_8[0] - (param_9[0] * _e171)), (param_8[1] - (param_9[1] * _e171)), (param_8[2] - (param_9[2] * _e171))), array<f64, 3>((param_8[0] - (param_10[0] * _e215)), (param_8[1] - (param_10[1] * _e215)), (param_8[2] - (param_10[2] * _e215))), array<f64, 3>((_e9 - (param_10[0] * _e256)), (_e12 - (param_10[1] * _e256)), (_e15 - (param_10[2] * _e256))), array<f64, 3>((_e269 - (param_9[0] * _e303)), (_e272 - (param_9[1] * _e303)), (_e275 - (param_9[2] * _e303))));
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
        phi_7518_ = array<array<f64, 3>, 4>(array<f64, 3>((param_8[0] - (param_9[0] * _e82)), (param_8[1] - (param_9[1] * _e82)), (param_8[2] - (param_9[2] * _e82))), array<f64, 3>((param_8[0] - (param_10[0] * _e126)), (param_8[1] - (param_10[1] * _e126)), (param_8[2] - (param_10[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_7518_;
    let _e319 = function_3(_e316[0], _e316[1]);
    let _e321 = function_3(_e319, _e316[2]);
    let _e323 = function_3(_e321, _e316[3]);
    return _e323;
}

fn function_5(param_12: array<f64, 3>, param_13: array<f64, 3>, param_14: array<f64, 3>, param_15: u32) -> array<f64, 3> {
    var phi_7117_: bool;
    var phi_7151_: array<f64, 3>;
    var phi_7152_: bool;
    var phi_7153_: array<f64, 3>;
    var phi_7154_: bool;
    var phi_7159_: array<f64, 3>;

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
        phi_7117_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_7117_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_7117_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_7151_ = array<f64, 3>((param_12[0] - ((param_13[0] * _e76) + (param_14[0] * _e80))), (param_12[1] - ((param_13[1] * _e76) + (param_14[1] * _e80))), (param_12[2] - ((param_13[2] * _e76) + (param_14[2] * _e80))));
            phi_7152_ = false;
        } else {
            phi_7151_ = array<f64, 3>();
            phi_7152_ = true;
        }
        let _e132 = phi_7151_;
        let _e134 = phi_7152_;
        phi_7153_ = _e132;
        phi_7154_ = _e134;
    } else {
        phi_7153_ = array<f64, 3>();
        phi_7154_ = true;
    }
    let _e136 = phi_7153_;
    let _e138 = phi_7154_;
    if _e138 {
        let _e139 = function_4(param_12, param_13, param_14, param_15);
        phi_7159_ = _e139;
    } else {
        phi_7159_ = _e136;
    }
    let _e141 = phi_7159_;
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
    var phi_506_: u32;
    var phi_551_: u32;
    var phi_554_: type_9;
    var phi_728_: type_23;
    var phi_924_: type_31;
    var phi_1085_: type_33;
    var phi_1358_: bool;
    var phi_1454_: type_41;
    var phi_1455_: bool;
    var phi_1456_: type_41;
    var phi_1457_: bool;
    var phi_1458_: type_41;
    var phi_1459_: bool;
    var phi_1464_: type_41;
    var phi_2204_: bool;
    var phi_2219_: f64;
    var phi_2295_: type_16;
    var phi_2298_: f64;
    var phi_2296_: type_16;
    var phi_2339_: type_17;
    var phi_2299_: f64;
    var local_9: f64;
    var phi_2352_: f64;
    var phi_2383_: type_9;
    var phi_2386_: u32;
    var phi_2453_: u32;
    var phi_2454_: u32;
    var phi_2387_: u32;
    var phi_2455_: u32;
    var phi_2513_: type_9;
    var phi_2673_: type_43;
    var phi_2674_: bool;
    var phi_2675_: type_43;
    var phi_2676_: bool;
    var phi_2711_: type_9;
    var phi_2714_: f64;
    var phi_2716_: f64;
    var phi_2718_: f64;
    var phi_2832_: bool;
    var phi_2839_: f64;
    var phi_2840_: bool;
    var phi_2715_: f64;
    var phi_2717_: f64;
    var phi_2719_: f64;
    var phi_2841_: f64;
    var phi_2842_: bool;
    var phi_2843_: bool;
    var local_10: bool;
    var local_11: f64;
    var local_12: f64;
    var phi_2848_: f64;
    var phi_2866_: type_9;
    var phi_2869_: f64;
    var phi_2935_: f64;
    var phi_2936_: bool;
    var phi_2937_: bool;
    var phi_2938_: bool;
    var phi_2939_: f64;
    var phi_2870_: f64;
    var phi_2940_: bool;
    var phi_2941_: bool;
    var phi_2942_: bool;
    var phi_2943_: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: f64;
    var phi_2957_: f64;
    var phi_2959_: type_43;
    var phi_3820_: array<type_36, 4>;
    var phi_3840_: type_9;
    var phi_3843_: bool;
    var phi_3844_: bool;
    var phi_3895_: bool;
    var phi_3896_: bool;
    var local_18: bool;
    var local_19: bool;
    var phi_3910_: u32;
    var phi_3911_: u32;
    var phi_3912_: bool;
    var phi_3943_: bool;
    var phi_3944_: bool;
    var phi_3945_: bool;
    var phi_3946_: bool;
    var phi_3947_: bool;
    var phi_3948_: bool;
    var phi_3949_: bool;
    var phi_3950_: bool;
    var phi_3951_: bool;
    var phi_3952_: bool;
    var phi_3953_: bool;
    var phi_3954_: bool;
    var phi_3955_: type_43;
    var phi_3956_: bool;
    var phi_3957_: type_43;
    var phi_3958_: bool;
    var phi_3959_: bool;
    var phi_3960_: bool;
    var phi_3961_: bool;
    var phi_3962_: type_43;
    var phi_3963_: bool;
    var phi_3964_: type_43;
    var phi_3965_: bool;
    var phi_3966_: bool;
    var phi_3967_: bool;
    var phi_3968_: bool;
    var phi_3969_: bool;
    var phi_3977_: type_43;
    var phi_3978_: bool;
    var phi_3979_: type_43;
    var phi_3980_: bool;
    var phi_3981_: bool;
    var phi_3982_: bool;
    var phi_3983_: bool;
    var phi_3984_: bool;
    var phi_4413_: type_9;
    var phi_4416_: f64;
    var phi_4418_: f64;
    var phi_4420_: f64;
    var phi_4422_: f64;
    var phi_4424_: bool;
    var phi_4426_: u32;
    var phi_4578_: array<f64, 3>;
    var phi_4646_: type_16;
    var phi_4649_: f64;
    var phi_4647_: type_16;
    var phi_4690_: type_17;
    var phi_4650_: f64;
    var local_20: f64;
    var phi_4703_: f64;
    var phi_4829_: type_44;
    var phi_4830_: bool;
    var phi_4831_: type_44;
    var phi_4832_: bool;
    var phi_4842_: type_44;
    var phi_5014_: bool;
    var phi_5015_: bool;
    var phi_5016_: bool;
    var phi_5017_: bool;
    var phi_5018_: bool;
    var phi_5019_: bool;
    var phi_5321_: bool;
    var phi_5322_: bool;
    var phi_5323_: bool;
    var phi_5324_: bool;
    var phi_5325_: bool;
    var phi_5326_: bool;
    var phi_5334_: bool;
    var phi_5444_: f64;
    var phi_5445_: bool;
    var phi_5446_: f64;
    var phi_5447_: bool;
    var phi_5448_: f64;
    var phi_5449_: bool;
    var phi_5450_: bool;
    var phi_5516_: f64;
    var phi_5517_: bool;
    var phi_5518_: f64;
    var phi_5519_: bool;
    var phi_5520_: f64;
    var phi_5521_: bool;
    var phi_5522_: bool;
    var phi_5593_: f64;
    var phi_5594_: bool;
    var phi_5595_: f64;
    var phi_5596_: bool;
    var phi_5597_: f64;
    var phi_5598_: bool;
    var phi_5599_: bool;
    var phi_5665_: f64;
    var phi_5666_: bool;
    var phi_5667_: f64;
    var phi_5668_: bool;
    var phi_5669_: f64;
    var phi_5670_: bool;
    var phi_5671_: bool;
    var phi_5848_: type_16;
    var phi_5851_: f64;
    var phi_5849_: type_16;
    var phi_5892_: type_17;
    var phi_5852_: f64;
    var local_21: f64;
    var phi_5905_: f64;
    var phi_6182_: bool;
    var phi_6183_: bool;
    var phi_6210_: f64;
    var phi_6211_: f64;
    var phi_6212_: bool;
    var phi_6213_: f64;
    var phi_6214_: f64;
    var phi_6215_: bool;
    var phi_6216_: bool;
    var phi_6217_: f64;
    var phi_6218_: f64;
    var phi_6219_: f64;
    var phi_6220_: f64;
    var phi_6221_: bool;
    var phi_6222_: bool;
    var phi_6223_: bool;
    var phi_6224_: bool;
    var phi_6225_: f64;
    var phi_6226_: f64;
    var phi_6227_: f64;
    var phi_6228_: f64;
    var phi_6229_: bool;
    var phi_6230_: bool;
    var phi_6231_: bool;
    var phi_6232_: bool;
    var phi_6233_: bool;
    var phi_6234_: f64;
    var phi_6235_: f64;
    var phi_6236_: f64;
    var phi_6237_: f64;
    var phi_6238_: bool;
    var phi_6239_: bool;
    var phi_6240_: bool;
    var phi_6241_: bool;
    var phi_6242_: bool;
    var phi_6580_: f64;
    var phi_6582_: u32;
    var phi_6583_: f64;
    var phi_6584_: bool;
    var phi_6585_: bool;
    var phi_6586_: bool;
    var phi_6587_: u32;
    var phi_6588_: f64;
    var phi_6589_: f64;
    var phi_6590_: f64;
    var phi_6591_: f64;
    var phi_6592_: bool;
    var phi_6593_: u32;
    var phi_6594_: bool;
    var phi_6595_: bool;
    var phi_6596_: bool;
    var phi_6597_: bool;
    var phi_6598_: bool;
    var phi_6599_: bool;
    var phi_6627_: f64;
    var phi_6628_: f64;
    var phi_6629_: f64;
    var phi_6630_: f64;
    var phi_6631_: bool;
    var phi_6632_: u32;
    var phi_6633_: bool;
    var phi_6634_: bool;
    var phi_6635_: bool;
    var phi_6636_: bool;
    var phi_6637_: bool;
    var phi_6638_: bool;
    var phi_4417_: f64;
    var phi_4419_: f64;
    var phi_4421_: f64;
    var phi_4423_: f64;
    var phi_4425_: bool;
    var phi_4427_: u32;
    var phi_6639_: f64;
    var phi_6640_: f64;
    var phi_6641_: bool;
    var phi_6642_: bool;
    var phi_6643_: bool;
    var phi_6644_: bool;
    var phi_6645_: bool;
    var phi_6646_: bool;
    var phi_6647_: bool;
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
    var phi_6715_: f64;
    var phi_6716_: bool;
    var phi_6717_: bool;
    var phi_6718_: bool;
    var phi_6719_: bool;
    var phi_6720_: bool;
    var phi_6721_: type_43;
    var phi_6722_: bool;
    var phi_6723_: f64;
    var phi_6724_: type_43;
    var phi_6725_: bool;
    var phi_6726_: bool;
    var phi_6727_: bool;
    var phi_6728_: bool;
    var phi_6729_: bool;
    var phi_6730_: bool;
    var local_37: bool;
    var local_38: bool;
    var local_39: type_43;
    var local_40: f64;
    var local_41: f64;
    var phi_6746_: type_42;
    var phi_6747_: bool;
    var local_42: f64;
    var phi_6753_: type_42;
    var phi_6754_: bool;
    var phi_6755_: bool;
    var phi_6756_: bool;
    var phi_6757_: bool;
    var local_43: bool;
    var local_44: type_43;
    var phi_6799_: type_42;
    var phi_6800_: type_42;
    var phi_6801_: bool;
    var phi_6845_: type_35;
    var phi_6854_: type_9;
    var phi_6883_: bool;
    var phi_6884_: bool;
    var phi_6927_: u32;
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
    let _e106 = id_2;
    let _e107 = n_2;
    let _e108 = lane_2;
    let _e120 = ((_e106.y * _e107.x) + _e106.x);
    let _e123 = (_e107.x * _e107.y);
    let _e126 = params.member.member_1.member_2;
    let _e128 = input.member[0u];
    let _e130 = select(_e128, _e126, (_e126 < _e128));
    let _e132 = params.member.member_1.member_1;
    if (_e130 > _e132) {
        let _e135 = params.member.member_1.member_1;
        phi_506_ = (_e130 - _e135);
    } else {
        phi_506_ = 0u;
    }
    let _e138 = phi_506_;
    let _e140 = params.member.member_1.member;
    let _e142 = select(_e138, _e140, (_e140 < _e138));
    let _e143 = (_e142 / 64u);
    let _e147 = select(_e143, (_e143 + 1u), ((_e142 % 64u) > 0u));
    if (_e147 > _e120) {
        let _e149 = (_e147 - _e120);
        if (_e123 == 0u) {
            return;
        }
        let _e151 = (_e149 / _e123);
        if (_e123 == 0u) {
            return;
        }
        phi_551_ = select(_e151, (_e151 + 1u), ((_e149 % _e123) > 0u));
    } else {
        phi_551_ = 0u;
    }
    let _e158 = phi_551_;
    phi_554_ = type_9(0u, _e158);
    loop {
        let _e161 = phi_554_;
        let _e164 = (_e161.member < _e161.member_1);
        let _e177 = (bitcast<i32>(select(0u, 1u, _e164)) != 0i);
        if _e177 {
            let _e181 = (((_e120 + (select(type_9().member_1, _e161.member, _e164) * _e123)) * 64u) + _e108);
            local_8 = type_35(0u, 0u, array<u32, 2>(0u, 0u), false);
            if (_e181 < _e142) {
                let _e185 = params.member.member_1.member_1;
                let _e187 = (2u * (_e185 + _e181));
                let _e190 = input.member[(4u + _e187)];
                let _e193 = input.member[(_e187 + 5u)];
                let _e198 = (_e193 & 2147483647u);
                if (select(1u, 0u, ((_e193 & 2147483648u) == 0u)) == 0u) {
                    let _e217 = params.member.member.member[1u];
                    let _e220 = ((2u * _e217) + (3u * _e198));
                    let _e222 = elements.member[_e220];
                    let _e225 = elements.member[(_e220 + 1u)];
                    let _e228 = elements.member[(_e220 + 2u)];
                    phi_728_ = type_23(0u, array<u32, 4>(_e190, _e222, _e225, _e228));
                } else {
                    let _e201 = (2u * _e190);
                    let _e203 = elements.member[_e201];
                    let _e206 = elements.member[(_e201 + 1u)];
                    let _e207 = (2u * _e198);
                    let _e209 = elements.member[_e207];
                    let _e212 = elements.member[(_e207 + 1u)];
                    phi_728_ = type_23(1u, array<u32, 4>(_e203, _e206, _e209, _e212));
                }
                let _e232 = phi_728_;
                let _e236 = params.member.member.member_1;
                if ((_e236 & 8u) != 0u) {
                    let _e280 = paths.member[_e232.member_1[0]];
                    let _e295 = paths.member[_e232.member_1[1]];
                    let _e310 = paths.member[_e232.member_1[2]];
                    let _e325 = paths.member[_e232.member_1[3]];
                    let _e346 = function_(array<f32, 3>(_e280.member.x, _e280.member.y, _e280.member.z));
                    let _e347 = function_(array<f32, 3>(_e295.member.x, _e295.member.y, _e295.member.z));
                    let _e348 = function_(array<f32, 3>(_e310.member.x, _e310.member.y, _e310.member.z));
                    let _e349 = function_(array<f32, 3>(_e325.member.x, _e325.member.y, _e325.member.z));
                    let _e351 = function_(array<f32, 3>(_e280.member_1.x, _e280.member_1.y, _e280.member_1.z));
                    let _e352 = function_(array<f32, 3>(_e295.member_1.x, _e295.member_1.y, _e295.member_1.z));
                    let _e353 = function_(array<f32, 3>(_e310.member_1.x, _e310.member_1.y, _e310.member_1.z));
                    let _e354 = function_(array<f32, 3>(_e325.member_1.x, _e325.member_1.y, _e325.member_1.z));
                    phi_924_ = type_31(array<array<f64, 3>, 4>(_e346, _e347, _e348, _e349), array<array<f64, 3>, 4>(_e351, _e352, _e353, _e354));
                } else {
                    let _e241 = positions.member[_e232.member_1[0]];
                    let _e244 = params.member.member.member[0u];
                    let _e247 = positions.member[(_e244 + _e232.member_1[0])];
                    let _e250 = positions.member[_e232.member_1[1]];
                    let _e253 = params.member.member.member[0u];
                    let _e256 = positions.member[(_e253 + _e232.member_1[1])];
                    let _e259 = positions.member[_e232.member_1[2]];
                    let _e262 = params.member.member.member[0u];
                    let _e265 = positions.member[(_e262 + _e232.member_1[2])];
                    let _e268 = positions.member[_e232.member_1[3]];
                    let _e271 = params.member.member.member[0u];
                    let _e274 = positions.member[(_e271 + _e232.member_1[3])];
                    phi_924_ = type_31(array<array<f64, 3>, 4>(_e241, _e250, _e259, _e268), array<array<f64, 3>, 4>(_e247, _e256, _e265, _e274));
                }
                let _e358 = phi_924_;
                if (_e232.member != 0u) {
                    phi_1085_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e358.member[2][0] - _e358.member[0][0]), (_e358.member[2][1] - _e358.member[0][1]), (_e358.member[2][2] - _e358.member[0][2])), array<f64, 3>((_e358.member_1[2][0] - _e358.member_1[0][0]), (_e358.member_1[2][1] - _e358.member_1[0][1]), (_e358.member_1[2][2] - _e358.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e358.member[1][0] - _e358.member[0][0]), (_e358.member[1][1] - _e358.member[0][1]), (_e358.member[1][2] - _e358.member[0][2])), array<f64, 3>((_e358.member_1[1][0] - _e358.member_1[0][0]), (_e358.member_1[1][1] - _e358.member_1[0][1]), (_e358.member_1[1][2] - _e358.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e358.member[2][0] - _e358.member[3][0]), (_e358.member[2][1] - _e358.member[3][1]), (_e358.member[2][2] - _e358.member[3][2])), array<f64, 3>((_e358.member_1[2][0] - _e358.member_1[3][0]), (_e358.member_1[2][1] - _e358.member_1[3][1]), (_e358.member_1[2][2] - _e358.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_1085_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e358.member[0][0] - _e358.member[1][0]), (_e358.member[0][1] - _e358.member[1][1]), (_e358.member[0][2] - _e358.member[1][2])), array<f64, 3>((_e358.member_1[0][0] - _e358.member_1[1][0]), (_e358.member_1[0][1] - _e358.member_1[1][1]), (_e358.member_1[0][2] - _e358.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e358.member[2][0] - _e358.member[1][0]), (_e358.member[2][1] - _e358.member[1][1]), (_e358.member[2][2] - _e358.member[1][2])), array<f64, 3>((_e358.member_1[2][0] - _e358.member_1[1][0]), (_e358.member_1[2][1] - _e358.member_1[1][1]), (_e358.member_1[2][2] - _e358.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e358.member[3][0] - _e358.member[1][0]), (_e358.member[3][1] - _e358.member[1][1]), (_e358.member[3][2] - _e358.member[1][2])), array<f64, 3>((_e358.member_1[3][0] - _e358.member_1[1][0]), (_e358.member_1[3][1] - _e358.member_1[1][1]), (_e358.member_1[3][2] - _e358.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e517 = phi_1085_;
                let _e519 = params.member.member.member_14;
                let _e526 = bitcast<f64>(((u64(_e519[1]) * 4294967296lu) + u64(_e519[0])));
                let _e528 = params.member.member.member_15;
                let _e535 = bitcast<f64>(((u64(_e528[1]) * 4294967296lu) + u64(_e528[0])));
                let _e537 = params.member.member.member_16;
                let _e544 = bitcast<f64>(((u64(_e537[1]) * 4294967296lu) + u64(_e537[0])));
                let _e546 = params.member.member.member_16;
                let _e553 = bitcast<f64>(((u64(_e546[1]) * 4294967296lu) + u64(_e546[0])));
                let _e554 = f64(0f);
                let _e560 = select(_e517.member[0][0], -(_e517.member[0][0]), (_e517.member[0][0] < 0.0lf));
                let _e564 = select(_e517.member[0][1], -(_e517.member[0][1]), (_e517.member[0][1] < 0.0lf));
                let _e566 = select(_e564, _e560, (_e560 > _e564));
                let _e570 = select(_e517.member[0][2], -(_e517.member[0][2]), (_e517.member[0][2] < 0.0lf));
                let _e572 = select(_e570, _e566, (_e566 > _e570));
                let _e578 = select(_e517.member[1][0], -(_e517.member[1][0]), (_e517.member[1][0] < 0.0lf));
                let _e582 = select(_e517.member[1][1], -(_e517.member[1][1]), (_e517.member[1][1] < 0.0lf));
                let _e584 = select(_e582, _e578, (_e578 > _e582));
                let _e588 = select(_e517.member[1][2], -(_e517.member[1][2]), (_e517.member[1][2] < 0.0lf));
                let _e590 = select(_e588, _e584, (_e584 > _e588));
                let _e594 = (select(_e590, _e572, (_e572 > _e590)) + _e517.member_3);
                let _e600 = select(_e517.member_1[0][0], -(_e517.member_1[0][0]), (_e517.member_1[0][0] < 0.0lf));
                let _e604 = select(_e517.member_1[0][1], -(_e517.member_1[0][1]), (_e517.member_1[0][1] < 0.0lf));
                let _e606 = select(_e604, _e600, (_e600 > _e604));
                let _e610 = select(_e517.member_1[0][2], -(_e517.member_1[0][2]), (_e517.member_1[0][2] < 0.0lf));
                let _e612 = select(_e610, _e606, (_e606 > _e610));
                let _e618 = select(_e517.member_1[1][0], -(_e517.member_1[1][0]), (_e517.member_1[1][0] < 0.0lf));
                let _e622 = select(_e517.member_1[1][1], -(_e517.member_1[1][1]), (_e517.member_1[1][1] < 0.0lf));
                let _e624 = select(_e622, _e618, (_e618 > _e622));
                let _e628 = select(_e517.member_1[1][2], -(_e517.member_1[1][2]), (_e517.member_1[1][2] < 0.0lf));
                let _e630 = select(_e628, _e624, (_e624 > _e628));
                let _e634 = (select(_e630, _e612, (_e612 > _e630)) + _e517.member_3);
                let _e640 = select(_e517.member_2[0][0], -(_e517.member_2[0][0]), (_e517.member_2[0][0] < 0.0lf));
                let _e644 = select(_e517.member_2[0][1], -(_e517.member_2[0][1]), (_e517.member_2[0][1] < 0.0lf));
                let _e646 = select(_e644, _e640, (_e640 > _e644));
                let _e650 = select(_e517.member_2[0][2], -(_e517.member_2[0][2]), (_e517.member_2[0][2] < 0.0lf));
                let _e652 = select(_e650, _e646, (_e646 > _e650));
                let _e658 = select(_e517.member_2[1][0], -(_e517.member_2[1][0]), (_e517.member_2[1][0] < 0.0lf));
                let _e662 = select(_e517.member_2[1][1], -(_e517.member_2[1][1]), (_e517.member_2[1][1] < 0.0lf));
                let _e664 = select(_e662, _e658, (_e658 > _e662));
                let _e668 = select(_e517.member_2[1][2], -(_e517.member_2[1][2]), (_e517.member_2[1][2] < 0.0lf));
                let _e670 = select(_e668, _e664, (_e664 > _e668));
                let _e674 = (select(_e670, _e652, (_e652 > _e670)) + _e517.member_3);
                let _e676 = select(_e634, _e594, (_e594 > _e634));
                let _e678 = select(_e674, _e676, (_e676 > _e674));
                if (_e678 <= f64(65536f)) {
                    phi_1358_ = (_e678 >= f64((1f / 65536f)));
                } else {
                    phi_1358_ = false;
                }
                let _e685 = phi_1358_;
                if _e685 {
                    phi_1458_ = type_41();
                    phi_1459_ = true;
                } else {
                    if (_e678 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e678) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e692 = (9214364837600034816lu - (bitcast<u64>(_e678) & 9218868437227405312lu));
                            let _e695 = bitcast<f64>(select(4503599627370496lu, _e692, (_e692 > 4503599627370496lu)));
                            let _e696 = (_e554 * _e695);
                            phi_1454_ = type_41(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e517.member[0][0] * _e695), (_e517.member[0][1] * _e695), (_e517.member[0][2] * _e695)), array<f64, 3>((_e517.member[1][0] * _e695), (_e517.member[1][1] * _e695), (_e517.member[1][2] * _e695))), array<array<f64, 3>, 2>(array<f64, 3>((_e517.member_1[0][0] * _e695), (_e517.member_1[0][1] * _e695), (_e517.member_1[0][2] * _e695)), array<f64, 3>((_e517.member_1[1][0] * _e695), (_e517.member_1[1][1] * _e695), (_e517.member_1[1][2] * _e695))), array<array<f64, 3>, 2>(array<f64, 3>((_e517.member_2[0][0] * _e695), (_e517.member_2[0][1] * _e695), (_e517.member_2[0][2] * _e695)), array<f64, 3>((_e517.member_2[1][0] * _e695), (_e517.member_2[1][1] * _e695), (_e517.member_2[1][2] * _e695))), ((_e517.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e695)), select(_e696, select(2.2250738585072014e-308lf, _e696, (_e696 > 2.2250738585072014e-308lf)), (_e554 > f64(0f))));
                            phi_1455_ = false;
                        } else {
                            phi_1454_ = type_41();
                            phi_1455_ = true;
                        }
                        let _e767 = phi_1454_;
                        let _e769 = phi_1455_;
                        phi_1456_ = _e767;
                        phi_1457_ = _e769;
                    } else {
                        phi_1456_ = type_41();
                        phi_1457_ = true;
                    }
                    let _e771 = phi_1456_;
                    let _e773 = phi_1457_;
                    phi_1458_ = _e771;
                    phi_1459_ = _e773;
                }
                let _e775 = phi_1458_;
                let _e777 = phi_1459_;
                if _e777 {
                    phi_1464_ = type_41(_e517, _e554);
                } else {
                    phi_1464_ = _e775;
                }
                let _e780 = phi_1464_;
                local_7 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e780.member.member[0][0], _e780.member.member[0][1], _e780.member.member[0][2]), array<f64, 3>(_e780.member.member[1][0], _e780.member.member[1][1], _e780.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e780.member.member_1[0][0], _e780.member.member_1[0][1], _e780.member.member_1[0][2]), array<f64, 3>(_e780.member.member_1[1][0], _e780.member.member_1[1][1], _e780.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e780.member.member_2[0][0], _e780.member.member_2[0][1], _e780.member.member_2[0][2]), array<f64, 3>(_e780.member.member_2[1][0], _e780.member.member_2[1][1], _e780.member.member_2[1][2])), _e780.member.member_3);
                let _e820 = f64(0f);
                let _e823 = local_7.member_1[0u];
                let _e829 = local_7.member_2[0u];
                let _e835 = ((_e823[1] * _e829[2]) - (_e823[2] * _e829[1]));
                let _e838 = ((_e823[2] * _e829[0]) - (_e823[0] * _e829[2]));
                let _e841 = ((_e823[0] * _e829[1]) - (_e823[1] * _e829[0]));
                let _e844 = local_7.member_1[1u];
                let _e850 = local_7.member_2[1u];
                let _e856 = ((_e844[1] * _e850[2]) - (_e844[2] * _e850[1]));
                let _e859 = ((_e844[2] * _e850[0]) - (_e844[0] * _e850[2]));
                let _e862 = ((_e844[0] * _e850[1]) - (_e844[1] * _e850[0]));
                let _e865 = local_7.member_1[0u];
                let _e871 = local_7.member_2[1u];
                let _e886 = local_7.member_1[1u];
                let _e892 = local_7.member_2[0u];
                let _e905 = (((_e865[1] * _e871[2]) - (_e865[2] * _e871[1])) + ((_e886[1] * _e892[2]) - (_e886[2] * _e892[1])));
                let _e906 = (((_e865[2] * _e871[0]) - (_e865[0] * _e871[2])) + ((_e886[2] * _e892[0]) - (_e886[0] * _e892[2])));
                let _e907 = (((_e865[0] * _e871[1]) - (_e865[1] * _e871[0])) + ((_e886[0] * _e892[1]) - (_e886[1] * _e892[0])));
                let _e910 = local_7.member[0u];
                let _e918 = (((_e910[0] * _e835) + (_e910[1] * _e838)) + (_e910[2] * _e841));
                let _e921 = local_7.member[1u];
                let _e932 = local_7.member[0u];
                let _e941 = ((((_e921[0] * _e835) + (_e921[1] * _e838)) + (_e921[2] * _e841)) + (((_e932[0] * _e905) + (_e932[1] * _e906)) + (_e932[2] * _e907)));
                let _e944 = local_7.member[0u];
                let _e955 = local_7.member[1u];
                let _e964 = ((((_e944[0] * _e856) + (_e944[1] * _e859)) + (_e944[2] * _e862)) + (((_e955[0] * _e905) + (_e955[1] * _e906)) + (_e955[2] * _e907)));
                let _e967 = local_7.member[1u];
                let _e975 = (((_e967[0] * _e856) + (_e967[1] * _e859)) + (_e967[2] * _e862));
                let _e978 = local_7.member[0u];
                let _e984 = select(_e978[0], -(_e978[0]), (_e978[0] < 0.0lf));
                let _e987 = select(_e978[1], -(_e978[1]), (_e978[1] < 0.0lf));
                let _e989 = select(_e987, _e984, (_e984 > _e987));
                let _e992 = select(_e978[2], -(_e978[2]), (_e978[2] < 0.0lf));
                let _e994 = select(_e992, _e989, (_e989 > _e992));
                let _e997 = local_7.member[1u];
                let _e1003 = select(_e997[0], -(_e997[0]), (_e997[0] < 0.0lf));
                let _e1006 = select(_e997[1], -(_e997[1]), (_e997[1] < 0.0lf));
                let _e1008 = select(_e1006, _e1003, (_e1003 > _e1006));
                let _e1011 = select(_e997[2], -(_e997[2]), (_e997[2] < 0.0lf));
                let _e1013 = select(_e1011, _e1008, (_e1008 > _e1011));
                let _e1017 = local_7.member_3;
                let _e1018 = (select(_e1013, _e994, (_e994 > _e1013)) + _e1017);
                let _e1021 = local_7.member_1[0u];
                let _e1027 = select(_e1021[0], -(_e1021[0]), (_e1021[0] < 0.0lf));
                let _e1030 = select(_e1021[1], -(_e1021[1]), (_e1021[1] < 0.0lf));
                let _e1032 = select(_e1030, _e1027, (_e1027 > _e1030));
                let _e1035 = select(_e1021[2], -(_e1021[2]), (_e1021[2] < 0.0lf));
                let _e1037 = select(_e1035, _e1032, (_e1032 > _e1035));
                let _e1040 = local_7.member_1[1u];
                let _e1046 = select(_e1040[0], -(_e1040[0]), (_e1040[0] < 0.0lf));
                let _e1049 = select(_e1040[1], -(_e1040[1]), (_e1040[1] < 0.0lf));
                let _e1051 = select(_e1049, _e1046, (_e1046 > _e1049));
                let _e1054 = select(_e1040[2], -(_e1040[2]), (_e1040[2] < 0.0lf));
                let _e1056 = select(_e1054, _e1051, (_e1051 > _e1054));
                let _e1060 = local_7.member_3;
                let _e1061 = (select(_e1056, _e1037, (_e1037 > _e1056)) + _e1060);
                let _e1064 = local_7.member_2[0u];
                let _e1070 = select(_e1064[0], -(_e1064[0]), (_e1064[0] < 0.0lf));
                let _e1073 = select(_e1064[1], -(_e1064[1]), (_e1064[1] < 0.0lf));
                let _e1075 = select(_e1073, _e1070, (_e1070 > _e1073));
                let _e1078 = select(_e1064[2], -(_e1064[2]), (_e1064[2] < 0.0lf));
                let _e1080 = select(_e1078, _e1075, (_e1075 > _e1078));
                let _e1083 = local_7.member_2[1u];
                let _e1089 = select(_e1083[0], -(_e1083[0]), (_e1083[0] < 0.0lf));
                let _e1092 = select(_e1083[1], -(_e1083[1]), (_e1083[1] < 0.0lf));
                let _e1094 = select(_e1092, _e1089, (_e1089 > _e1092));
                let _e1097 = select(_e1083[2], -(_e1083[2]), (_e1083[2] < 0.0lf));
                let _e1099 = select(_e1097, _e1094, (_e1094 > _e1097));
                let _e1103 = local_7.member_3;
                let _e1104 = (select(_e1099, _e1080, (_e1080 > _e1099)) + _e1103);
                let _e1105 = f64(1f);
                let _e1106 = f64(8f);
                let _e1108 = ((_e1061 * _e1106) * _e1104);
                let _e1116 = local_7.member_3;
                let _e1143 = ((select(_e835, -(_e835), (_e835 < 0.0lf)) + select(_e838, -(_e838), (_e838 < 0.0lf))) + select(_e841, -(_e841), (_e841 < 0.0lf)));
                let _e1154 = ((select(_e856, -(_e856), (_e856 < 0.0lf)) + select(_e859, -(_e859), (_e859 < 0.0lf))) + select(_e862, -(_e862), (_e862 < 0.0lf)));
                let _e1156 = select(_e1154, _e1143, (_e1143 > _e1154));
                let _e1168 = (((select(_e905, -(_e905), (_e905 < 0.0lf)) + select(_e906, -(_e906), (_e906 < 0.0lf))) + select(_e907, -(_e907), (_e907 < 0.0lf))) * f64(0.5f));
                let _e1176 = local_7.member_3;
                let _e1190 = (((((_e1018 * _e1106) * _e1108) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1116 * f64(19f)) * ((_e1018 * (_e1061 + _e1104)) + (_e1061 * _e1104)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1105 + _e1018) * ((_e1105 + _e1061) * (_e1105 + _e1104)))));
                let _e1191 = f64(3f);
                let _e1192 = (_e918 * _e1191);
                let _e1193 = (_e975 * _e1191);
                let _e1195 = select(_e1193, _e1192, (_e1192 < _e1193));
                let _e1197 = select(_e964, _e941, (_e941 < _e964));
                let _e1199 = select(_e1197, _e1195, (_e1195 < _e1197));
                let _e1201 = select(_e1193, _e1192, (_e1192 > _e1193));
                let _e1203 = select(_e964, _e941, (_e941 > _e964));
                let _e1206 = -(select(_e1203, _e1201, (_e1201 > _e1203)));
                if ((select(_e1206, _e1199, (_e1199 > _e1206)) - (_e1190 + ((_e820 * (((select(_e1168, _e1156, (_e1156 > _e1168)) + (_e1108 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1176 * f64(6f)) * (_e1061 + _e1104))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1105 + _e1061) * (_e1105 + _e1104))))) * f64((3f * 1.0001f))))) > _e820) {
                    phi_6799_ = type_42(0u, type_42().member_1);
                    phi_6800_ = type_42();
                    phi_6801_ = true;
                } else {
                    let _e1220 = select(_e918, -(_e918), (_e918 < 0.0lf));
                    let _e1223 = select(_e941, -(_e941), (_e941 < 0.0lf));
                    let _e1225 = select(_e1223, _e1220, (_e1220 > _e1223));
                    let _e1228 = select(_e964, -(_e964), (_e964 < 0.0lf));
                    let _e1231 = select(_e975, -(_e975), (_e975 < 0.0lf));
                    let _e1233 = select(_e1231, _e1228, (_e1228 > _e1231));
                    let _e1235 = select(_e1233, _e1225, (_e1225 > _e1233));
                    let _e1237 = (2.2250738585072014e-308lf * f64(67108864f));
                    let _e1238 = f64(1f);
                    if (_e1235 >= _e1237) {
                        phi_2204_ = (_e1235 <= (_e1238 / _e1237));
                    } else {
                        phi_2204_ = false;
                    }
                    let _e1243 = phi_2204_;
                    if _e1243 {
                        phi_2219_ = (_e1238 / _e1235);
                    } else {
                        phi_2219_ = f64(0f);
                    }
                    let _e1253 = phi_2219_;
                    let _e1254 = f64(0.00000000000022737368f);
                    let _e1256 = (_e526 * f64(0.0625f));
                    local_5 = type_39(array<f64, 4>(_e918, _e941, _e964, _e975), ((_e1190 * f64(0.34f)) + (_e1235 * select(f64(2f), (1.1102230246251565e-16lf * f64(256f)), _e1243))), _e1253, select(_e1256, _e1254, (_e1254 < _e1256)));
                    let _e1261 = f64(0f);
                    let _e1262 = f64(1f);
                    let _e1263 = f64(3f);
                    let _e1266 = local_5.member[0u];
                    let _e1269 = local_5.member[1u];
                    let _e1272 = local_5.member[2u];
                    let _e1275 = local_5.member[3u];
                    let _e1282 = local_5.member_2;
                    let _e1283 = ((_e1269 - (_e1263 * _e1266)) * _e1282);
                    let _e1285 = local_5.member_2;
                    let _e1286 = ((_e1272 - _e1269) * _e1285);
                    let _e1288 = local_5.member_2;
                    let _e1289 = (((_e1263 * _e1275) - _e1272) * _e1288);
                    local_3[0u] = _e1261;
                    local_3[1u] = _e1262;
                    local_3[2u] = _e1262;
                    local_3[3u] = _e1262;
                    let _e1296 = ((_e1286 * _e1286) - (_e1283 * _e1289));
                    if (_e1296 > _e1261) {
                        if (_e1296 <= 2.2250738585072014e-308lf) {
                            phi_2352_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1296 > 0.0lf));
                        } else {
                            phi_2295_ = type_16(0i, 5i);
                            phi_2298_ = bitcast<f64>(((bitcast<u64>(_e1296) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1304 = phi_2295_;
                                let _e1306 = phi_2298_;
                                local_9 = _e1306;
                                if (_e1304.member < _e1304.member_1) {
                                    let _e1313 = (_e1304.member + 1i);
                                    phi_2296_ = type_16(select(_e1313, type_17().member_1, select(false, true, ((false == (_e1313 > _e1304.member)) != false))), _e1304.member_1);
                                    phi_2339_ = type_17(1u, _e1304.member);
                                } else {
                                    phi_2296_ = _e1304;
                                    phi_2339_ = type_17(0u, type_17().member_1);
                                }
                                let _e1324 = phi_2296_;
                                let _e1326 = phi_2339_;
                                let _e1329 = (bitcast<i32>(_e1326.member) != 0i);
                                if _e1329 {
                                    phi_2299_ = (0.5lf * (_e1306 + (_e1296 / _e1306)));
                                } else {
                                    phi_2299_ = f64();
                                }
                                let _e1334 = phi_2299_;
                                continue;
                                continuing {
                                    phi_2295_ = _e1324;
                                    phi_2298_ = _e1334;
                                    break if !(_e1329);
                                }
                            }
                            let _e1339 = local_9;
                            phi_2352_ = (_e1339 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1345 = phi_2352_;
                        let _e1350 = -((_e1286 + select(_e1345, -(_e1345), (_e1286 < _e1261))));
                        local_4[0u] = (_e1350 / (_e1350 + _e1289));
                        local_4[1u] = (_e1283 / (_e1283 + _e1350));
                        let _e1359 = local_4[1u];
                        let _e1360 = local_4[0u];
                        if (_e1359 < _e1360) {
                            let _e1363 = local_4[1u];
                            let _e1365 = local_4[0u];
                            local_4[0u] = _e1363;
                            local_4[1u] = _e1365;
                        }
                        phi_2383_ = type_9(0u, 2u);
                        phi_2386_ = 1u;
                        loop {
                            let _e1369 = phi_2383_;
                            let _e1371 = phi_2386_;
                            local_45 = _e1371;
                            let _e1374 = (_e1369.member < _e1369.member_1);
                            let _e1385 = select(type_9().member_1, _e1369.member, _e1374);
                            let _e1387 = (bitcast<i32>(select(0u, 1u, _e1374)) != 0i);
                            if _e1387 {
                                let _e1389 = local_4[_e1385];
                                if (_e1389 > _e1261) {
                                    let _e1392 = local_4[_e1385];
                                    if (_e1392 < _e1262) {
                                        let _e1395 = local_4[_e1385];
                                        local_3[_e1371] = _e1395;
                                        phi_2453_ = (_e1371 + 1u);
                                    } else {
                                        phi_2453_ = _e1371;
                                    }
                                    let _e1399 = phi_2453_;
                                    phi_2454_ = _e1399;
                                } else {
                                    phi_2454_ = _e1371;
                                }
                                let _e1401 = phi_2454_;
                                phi_2387_ = _e1401;
                            } else {
                                phi_2387_ = u32();
                            }
                            let _e1403 = phi_2387_;
                            continue;
                            continuing {
                                phi_2383_ = type_9(select(_e1369.member, (_e1369.member + 1u), _e1374), select(_e1369.member_1, _e1369.member_1, _e1374));
                                phi_2386_ = _e1403;
                                break if !(_e1387);
                            }
                        }
                        let _e4423 = local_45;
                        phi_2455_ = _e4423;
                    } else {
                        phi_2455_ = 1u;
                    }
                    let _e1406 = phi_2455_;
                    local_3[_e1406] = _e1262;
                    let _e1408 = local_3;
                    local_6 = _e1408;
                    let _e1410 = (_e526 * f64(0.99f));
                    let _e1412 = (f64(1f) - _e535);
                    let _e1415 = local_5.member[0u];
                    let _e1418 = local_5.member[1u];
                    let _e1421 = local_5.member[2u];
                    let _e1424 = local_5.member[3u];
                    let _e1435 = ((((_e1415 * _e1412) + (_e1418 * _e535)) * (_e1412 * _e1412)) + (((_e1421 * _e1412) + (_e1424 * _e535)) * (_e535 * _e535)));
                    let _e1440 = local_5.member_1;
                    phi_2513_ = type_9(select(1u, 0u, !((select(_e1435, -(_e1435), (_e1435 < 0.0lf)) > _e1440))), (_e1406 + 1u));
                    loop {
                        let _e1447 = phi_2513_;
                        let _e1450 = (_e1447.member < _e1447.member_1);
                        let _e1461 = select(type_9().member_1, _e1447.member, _e1450);
                        if (bitcast<i32>(select(0u, 1u, _e1450)) != 0i) {
                            if (_e1461 > 0u) {
                                let _e1468 = local_6[(_e1461 - 1u)];
                                let _e1470 = select(_e535, _e1468, (_e1468 > _e535));
                                let _e1472 = local_6[_e1461];
                                let _e1474 = select(_e544, _e1472, (_e1472 < _e544));
                                if (_e1470 <= _e1474) {
                                    let _e1476 = function_1((&local_5), _e553, _e1470, _e1474);
                                    if _e1476 {
                                        phi_3955_ = type_43();
                                        phi_3956_ = bool();
                                        phi_3957_ = type_43();
                                        phi_3958_ = false;
                                        phi_3959_ = false;
                                        phi_3960_ = false;
                                        phi_3961_ = false;
                                    } else {
                                        let _e1478 = (f64(1f) - _e1470);
                                        let _e1481 = local_5.member[0u];
                                        let _e1484 = local_5.member[1u];
                                        let _e1487 = local_5.member[2u];
                                        let _e1490 = local_5.member[3u];
                                        let _e1501 = ((((_e1481 * _e1478) + (_e1484 * _e1470)) * (_e1478 * _e1478)) + (((_e1487 * _e1478) + (_e1490 * _e1470)) * (_e1470 * _e1470)));
                                        let _e1503 = (f64(1f) - _e1474);
                                        let _e1506 = local_5.member[0u];
                                        let _e1509 = local_5.member[1u];
                                        let _e1512 = local_5.member[2u];
                                        let _e1515 = local_5.member[3u];
                                        let _e1526 = ((((_e1506 * _e1503) + (_e1509 * _e1474)) * (_e1503 * _e1503)) + (((_e1512 * _e1503) + (_e1515 * _e1474)) * (_e1474 * _e1474)));
                                        let _e1531 = local_5.member_1;
                                        let _e1532 = (select(_e1501, -(_e1501), (_e1501 < 0.0lf)) > _e1531);
                                        let _e1537 = local_5.member_1;
                                        let _e1538 = (select(_e1526, -(_e1526), (_e1526 < 0.0lf)) > _e1537);
                                        let _e1539 = f64(0f);
                                        let _e1547 = select(select(bool(), select(bool(), ((_e1501 > _e1539) != (_e1526 > _e1539)), _e1538), _e1532), false, select(true, select(true, false, _e1538), _e1532));
                                        if _e1532 {
                                            if _e1538 {
                                                phi_2673_ = type_43(select(f64(1f), type_43().member, _e1547), select(_e1539, type_43().member_1, _e1547), select(_e1547, type_43().member_2, _e1547));
                                                phi_2674_ = _e1547;
                                            } else {
                                                phi_2673_ = type_43();
                                                phi_2674_ = true;
                                            }
                                            let _e1557 = phi_2673_;
                                            let _e1559 = phi_2674_;
                                            phi_2675_ = _e1557;
                                            phi_2676_ = _e1559;
                                        } else {
                                            phi_2675_ = type_43();
                                            phi_2676_ = true;
                                        }
                                        let _e1561 = phi_2675_;
                                        let _e1563 = phi_2676_;
                                        if _e1563 {
                                            if _e1532 {
                                                let _e1567 = select(f64(1f), f64(-1f), (_e1501 < _e1539));
                                                let _e1569 = local_5.member_3;
                                                let _e1570 = f64(0.5f);
                                                let _e1571 = f64(3f);
                                                let _e1574 = local_5.member[0u];
                                                let _e1577 = local_5.member[1u];
                                                let _e1580 = local_5.member[2u];
                                                let _e1583 = local_5.member[3u];
                                                let _e1586 = (_e1580 - _e1577);
                                                phi_2711_ = type_9(0u, 64u);
                                                phi_2714_ = _e1474;
                                                phi_2716_ = _e1470;
                                                phi_2718_ = (_e1570 * (_e1470 + _e1474));
                                                loop {
                                                    let _e1592 = phi_2711_;
                                                    let _e1594 = phi_2714_;
                                                    let _e1596 = phi_2716_;
                                                    let _e1598 = phi_2718_;
                                                    local_12 = _e1596;
                                                    let _e1601 = (_e1592.member < _e1592.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1601)) != 0i) {
                                                        let _e1614 = (f64(1f) - _e1598);
                                                        let _e1617 = local_5.member[0u];
                                                        let _e1620 = local_5.member[1u];
                                                        let _e1623 = local_5.member[2u];
                                                        let _e1626 = local_5.member[3u];
                                                        let _e1640 = local_5.member_1;
                                                        let _e1641 = ((_e1567 * ((((_e1617 * _e1614) + (_e1620 * _e1598)) * (_e1614 * _e1614)) + (((_e1623 * _e1614) + (_e1626 * _e1598)) * (_e1598 * _e1598)))) - _e1640);
                                                        let _e1643 = (_e1641 > f64(0f));
                                                        let _e1644 = select(_e1598, _e1594, _e1643);
                                                        let _e1645 = select(_e1596, _e1598, _e1643);
                                                        let _e1647 = ((_e1644 - _e1645) > _e1569);
                                                        if _e1647 {
                                                            let _e1649 = (f64(1f) - _e1598);
                                                            let _e1661 = (-(_e1641) / (_e1567 * (((((_e1577 - (_e1571 * _e1574)) * _e1649) + (_e1586 * _e1598)) * _e1649) + (((_e1586 * _e1649) + (((_e1571 * _e1583) - _e1580) * _e1598)) * _e1598))));
                                                            let _e1669 = ((_e1598 + _e1661) + select(-((_e1570 * _e1569)), (_e1570 * _e1569), (_e1641 > f64(0f))));
                                                            if (_e1669 > _e1645) {
                                                                phi_2832_ = select(true, select(true, false, (select(_e1661, -(_e1661), (_e1661 < 0.0lf)) < (_e1570 * (_e1644 - _e1645)))), (_e1669 < _e1644));
                                                            } else {
                                                                phi_2832_ = true;
                                                            }
                                                            let _e1681 = phi_2832_;
                                                            phi_2839_ = select(_e1669, (_e1570 * (_e1645 + _e1644)), _e1681);
                                                            phi_2840_ = false;
                                                        } else {
                                                            phi_2839_ = f64();
                                                            phi_2840_ = true;
                                                        }
                                                        let _e1686 = phi_2839_;
                                                        let _e1688 = phi_2840_;
                                                        phi_2715_ = _e1644;
                                                        phi_2717_ = _e1645;
                                                        phi_2719_ = _e1686;
                                                        phi_2841_ = _e1645;
                                                        phi_2842_ = _e1647;
                                                        phi_2843_ = _e1688;
                                                    } else {
                                                        phi_2715_ = f64();
                                                        phi_2717_ = f64();
                                                        phi_2719_ = f64();
                                                        phi_2841_ = f64();
                                                        phi_2842_ = false;
                                                        phi_2843_ = false;
                                                    }
                                                    let _e1690 = phi_2715_;
                                                    let _e1692 = phi_2717_;
                                                    let _e1694 = phi_2719_;
                                                    let _e1696 = phi_2841_;
                                                    let _e1698 = phi_2842_;
                                                    let _e1700 = phi_2843_;
                                                    local_10 = _e1700;
                                                    local_11 = _e1696;
                                                    continue;
                                                    continuing {
                                                        phi_2711_ = type_9(select(_e1592.member, (_e1592.member + 1u), _e1601), select(_e1592.member_1, _e1592.member_1, _e1601));
                                                        phi_2714_ = _e1690;
                                                        phi_2716_ = _e1692;
                                                        phi_2718_ = _e1694;
                                                        break if !(_e1698);
                                                    }
                                                }
                                                let _e1703 = local_10;
                                                let _e1705 = local_11;
                                                let _e1707 = local_12;
                                                phi_2848_ = select(_e1707, _e1705, _e1703);
                                            } else {
                                                phi_2848_ = _e1470;
                                            }
                                            let _e1710 = phi_2848_;
                                            if _e1538 {
                                                let _e1716 = local_5.member_3;
                                                let _e1718 = local_5.member_3;
                                                phi_2866_ = type_9(0u, 64u);
                                                phi_2869_ = (_e1716 + _e1718);
                                                loop {
                                                    let _e1721 = phi_2866_;
                                                    let _e1723 = phi_2869_;
                                                    let _e1726 = (_e1721.member < _e1721.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1726)) != 0i) {
                                                        let _e1738 = (_e1710 + _e1723);
                                                        if (_e1738 < _e1474) {
                                                            let _e1741 = (f64(1f) - _e1738);
                                                            let _e1744 = local_5.member[0u];
                                                            let _e1747 = local_5.member[1u];
                                                            let _e1750 = local_5.member[2u];
                                                            let _e1753 = local_5.member[3u];
                                                            let _e1767 = local_5.member_1;
                                                            let _e1768 = ((select(f64(1f), f64(-1f), (_e1526 < _e1539)) * ((((_e1744 * _e1741) + (_e1747 * _e1738)) * (_e1741 * _e1741)) + (((_e1750 * _e1741) + (_e1753 * _e1738)) * (_e1738 * _e1738)))) > _e1767);
                                                            phi_2935_ = select((_e1723 + _e1723), f64(), _e1768);
                                                            phi_2936_ = select(true, false, _e1768);
                                                            phi_2937_ = _e1768;
                                                            phi_2938_ = false;
                                                        } else {
                                                            phi_2935_ = f64();
                                                            phi_2936_ = false;
                                                            phi_2937_ = false;
                                                            phi_2938_ = true;
                                                        }
                                                        let _e1773 = phi_2935_;
                                                        let _e1775 = phi_2936_;
                                                        let _e1777 = phi_2937_;
                                                        let _e1779 = phi_2938_;
                                                        phi_2939_ = _e1738;
                                                        phi_2870_ = _e1773;
                                                        phi_2940_ = _e1775;
                                                        phi_2941_ = _e1777;
                                                        phi_2942_ = _e1779;
                                                        phi_2943_ = false;
                                                    } else {
                                                        phi_2939_ = f64();
                                                        phi_2870_ = f64();
                                                        phi_2940_ = false;
                                                        phi_2941_ = false;
                                                        phi_2942_ = false;
                                                        phi_2943_ = true;
                                                    }
                                                    let _e1781 = phi_2939_;
                                                    let _e1783 = phi_2870_;
                                                    let _e1785 = phi_2940_;
                                                    let _e1787 = phi_2941_;
                                                    let _e1789 = phi_2942_;
                                                    let _e1791 = phi_2943_;
                                                    local_13 = _e1787;
                                                    local_14 = _e1789;
                                                    local_15 = _e1787;
                                                    local_16 = _e1791;
                                                    local_17 = _e1781;
                                                    continue;
                                                    continuing {
                                                        phi_2866_ = type_9(select(_e1721.member, (_e1721.member + 1u), _e1726), select(_e1721.member_1, _e1721.member_1, _e1726));
                                                        phi_2869_ = _e1783;
                                                        break if !(_e1785);
                                                    }
                                                }
                                                let _e1794 = local_13;
                                                let _e1796 = local_14;
                                                let _e1799 = local_15;
                                                let _e1801 = local_16;
                                                let _e1805 = local_17;
                                                phi_2957_ = select(_e1805, _e1474, select(select(_e1801, false, _e1799), true, select(_e1796, false, _e1794)));
                                            } else {
                                                phi_2957_ = _e1474;
                                            }
                                            let _e1808 = phi_2957_;
                                            phi_2959_ = type_43(_e1710, _e1808, _e1547);
                                        } else {
                                            phi_2959_ = _e1561;
                                        }
                                        let _e1811 = phi_2959_;
                                        if (_e1811.member > _e1811.member_1) {
                                            phi_3950_ = bool();
                                            phi_3951_ = true;
                                            phi_3952_ = false;
                                            phi_3953_ = false;
                                            phi_3954_ = false;
                                        } else {
                                            let _e1816 = (_e1811.member > _e553);
                                            if _e1816 {
                                                phi_3946_ = bool();
                                                phi_3947_ = false;
                                                phi_3948_ = false;
                                                phi_3949_ = false;
                                            } else {
                                                let _e1821 = ((_e1811.member_1 - _e1811.member) * f64(0.5f));
                                                let _e1822 = (_e1811.member + _e1821);
                                                let _e1825 = (_e1821 + (1.1102230246251565e-16lf * f64(4f)));
                                                let _e1827 = local_7.member_3;
                                                let _e1830 = local_7.member[0u];
                                                let _e1836 = select(_e1830[0], -(_e1830[0]), (_e1830[0] < 0.0lf));
                                                let _e1839 = select(_e1830[1], -(_e1830[1]), (_e1830[1] < 0.0lf));
                                                let _e1841 = select(_e1839, _e1836, (_e1836 > _e1839));
                                                let _e1844 = select(_e1830[2], -(_e1830[2]), (_e1830[2] < 0.0lf));
                                                let _e1846 = select(_e1844, _e1841, (_e1841 > _e1844));
                                                let _e1848 = local_7.member[1u];
                                                let _e1854 = select(_e1848[0], -(_e1848[0]), (_e1848[0] < 0.0lf));
                                                let _e1857 = select(_e1848[1], -(_e1848[1]), (_e1848[1] < 0.0lf));
                                                let _e1859 = select(_e1857, _e1854, (_e1854 > _e1857));
                                                let _e1862 = select(_e1848[2], -(_e1848[2]), (_e1848[2] < 0.0lf));
                                                let _e1864 = select(_e1862, _e1859, (_e1859 > _e1862));
                                                let _e1869 = local_7.member[0u];
                                                let _e1874 = local_7.member[1u];
                                                let _e1884 = (_e1869[0] + ((_e1874[0] - _e1869[0]) * _e1822));
                                                let _e1885 = (_e1869[1] + ((_e1874[1] - _e1869[1]) * _e1822));
                                                let _e1886 = (_e1869[2] + ((_e1874[2] - _e1869[2]) * _e1822));
                                                let _e1888 = local_7.member[1u];
                                                let _e1893 = local_7.member[0u];
                                                let _e1897 = (_e1888[0] - _e1893[0]);
                                                let _e1898 = (_e1888[1] - _e1893[1]);
                                                let _e1899 = (_e1888[2] - _e1893[2]);
                                                let _e1902 = select(_e1897, -(_e1897), (_e1897 < 0.0lf));
                                                let _e1905 = select(_e1898, -(_e1898), (_e1898 < 0.0lf));
                                                let _e1907 = select(_e1905, _e1902, (_e1902 > _e1905));
                                                let _e1910 = select(_e1899, -(_e1899), (_e1899 < 0.0lf));
                                                let _e1920 = ((((_e1825 * select(_e1910, _e1907, (_e1907 > _e1910))) * f64(1.01f)) + ((select(_e1864, _e1846, (_e1846 > _e1864)) + _e1827) * (1.1102230246251565e-16lf * f64(8f)))) + _e1827);
                                                let _e1923 = select(_e1884, -(_e1884), (_e1884 < 0.0lf));
                                                let _e1926 = select(_e1885, -(_e1885), (_e1885 < 0.0lf));
                                                let _e1928 = select(_e1926, _e1923, (_e1923 > _e1926));
                                                let _e1931 = select(_e1886, -(_e1886), (_e1886 < 0.0lf));
                                                let _e1934 = (select(_e1931, _e1928, (_e1928 > _e1931)) + _e1920);
                                                let _e1937 = local_7.member_3;
                                                let _e1939 = local_7.member_1[0u];
                                                let _e1945 = select(_e1939[0], -(_e1939[0]), (_e1939[0] < 0.0lf));
                                                let _e1948 = select(_e1939[1], -(_e1939[1]), (_e1939[1] < 0.0lf));
                                                let _e1950 = select(_e1948, _e1945, (_e1945 > _e1948));
                                                let _e1953 = select(_e1939[2], -(_e1939[2]), (_e1939[2] < 0.0lf));
                                                let _e1955 = select(_e1953, _e1950, (_e1950 > _e1953));
                                                let _e1957 = local_7.member_1[1u];
                                                let _e1963 = select(_e1957[0], -(_e1957[0]), (_e1957[0] < 0.0lf));
                                                let _e1966 = select(_e1957[1], -(_e1957[1]), (_e1957[1] < 0.0lf));
                                                let _e1968 = select(_e1966, _e1963, (_e1963 > _e1966));
                                                let _e1971 = select(_e1957[2], -(_e1957[2]), (_e1957[2] < 0.0lf));
                                                let _e1973 = select(_e1971, _e1968, (_e1968 > _e1971));
                                                let _e1978 = local_7.member_1[0u];
                                                let _e1983 = local_7.member_1[1u];
                                                let _e1993 = (_e1978[0] + ((_e1983[0] - _e1978[0]) * _e1822));
                                                let _e1994 = (_e1978[1] + ((_e1983[1] - _e1978[1]) * _e1822));
                                                let _e1995 = (_e1978[2] + ((_e1983[2] - _e1978[2]) * _e1822));
                                                let _e1997 = local_7.member_1[1u];
                                                let _e2002 = local_7.member_1[0u];
                                                let _e2006 = (_e1997[0] - _e2002[0]);
                                                let _e2007 = (_e1997[1] - _e2002[1]);
                                                let _e2008 = (_e1997[2] - _e2002[2]);
                                                let _e2011 = select(_e2006, -(_e2006), (_e2006 < 0.0lf));
                                                let _e2014 = select(_e2007, -(_e2007), (_e2007 < 0.0lf));
                                                let _e2016 = select(_e2014, _e2011, (_e2011 > _e2014));
                                                let _e2019 = select(_e2008, -(_e2008), (_e2008 < 0.0lf));
                                                let _e2029 = ((((_e1825 * select(_e2019, _e2016, (_e2016 > _e2019))) * f64(1.01f)) + ((select(_e1973, _e1955, (_e1955 > _e1973)) + _e1937) * (1.1102230246251565e-16lf * f64(8f)))) + _e1937);
                                                let _e2032 = select(_e1993, -(_e1993), (_e1993 < 0.0lf));
                                                let _e2035 = select(_e1994, -(_e1994), (_e1994 < 0.0lf));
                                                let _e2037 = select(_e2035, _e2032, (_e2032 > _e2035));
                                                let _e2040 = select(_e1995, -(_e1995), (_e1995 < 0.0lf));
                                                let _e2043 = (select(_e2040, _e2037, (_e2037 > _e2040)) + _e2029);
                                                let _e2046 = local_7.member_3;
                                                let _e2048 = local_7.member_2[0u];
                                                let _e2054 = select(_e2048[0], -(_e2048[0]), (_e2048[0] < 0.0lf));
                                                let _e2057 = select(_e2048[1], -(_e2048[1]), (_e2048[1] < 0.0lf));
                                                let _e2059 = select(_e2057, _e2054, (_e2054 > _e2057));
                                                let _e2062 = select(_e2048[2], -(_e2048[2]), (_e2048[2] < 0.0lf));
                                                let _e2064 = select(_e2062, _e2059, (_e2059 > _e2062));
                                                let _e2066 = local_7.member_2[1u];
                                                let _e2072 = select(_e2066[0], -(_e2066[0]), (_e2066[0] < 0.0lf));
                                                let _e2075 = select(_e2066[1], -(_e2066[1]), (_e2066[1] < 0.0lf));
                                                let _e2077 = select(_e2075, _e2072, (_e2072 > _e2075));
                                                let _e2080 = select(_e2066[2], -(_e2066[2]), (_e2066[2] < 0.0lf));
                                                let _e2082 = select(_e2080, _e2077, (_e2077 > _e2080));
                                                let _e2087 = local_7.member_2[0u];
                                                let _e2092 = local_7.member_2[1u];
                                                let _e2102 = (_e2087[0] + ((_e2092[0] - _e2087[0]) * _e1822));
                                                let _e2103 = (_e2087[1] + ((_e2092[1] - _e2087[1]) * _e1822));
                                                let _e2104 = (_e2087[2] + ((_e2092[2] - _e2087[2]) * _e1822));
                                                let _e2106 = local_7.member_2[1u];
                                                let _e2111 = local_7.member_2[0u];
                                                let _e2115 = (_e2106[0] - _e2111[0]);
                                                let _e2116 = (_e2106[1] - _e2111[1]);
                                                let _e2117 = (_e2106[2] - _e2111[2]);
                                                let _e2120 = select(_e2115, -(_e2115), (_e2115 < 0.0lf));
                                                let _e2123 = select(_e2116, -(_e2116), (_e2116 < 0.0lf));
                                                let _e2125 = select(_e2123, _e2120, (_e2120 > _e2123));
                                                let _e2128 = select(_e2117, -(_e2117), (_e2117 < 0.0lf));
                                                let _e2138 = ((((_e1825 * select(_e2128, _e2125, (_e2125 > _e2128))) * f64(1.01f)) + ((select(_e2082, _e2064, (_e2064 > _e2082)) + _e2046) * (1.1102230246251565e-16lf * f64(8f)))) + _e2046);
                                                let _e2141 = select(_e2102, -(_e2102), (_e2102 < 0.0lf));
                                                let _e2144 = select(_e2103, -(_e2103), (_e2103 < 0.0lf));
                                                let _e2146 = select(_e2144, _e2141, (_e2141 > _e2144));
                                                let _e2149 = select(_e2104, -(_e2104), (_e2104 < 0.0lf));
                                                let _e2152 = (select(_e2149, _e2146, (_e2146 > _e2149)) + _e2138);
                                                let _e2155 = ((_e1994 * _e2104) - (_e1995 * _e2103));
                                                let _e2158 = ((_e1995 * _e2102) - (_e1993 * _e2104));
                                                let _e2161 = ((_e1993 * _e2103) - (_e1994 * _e2102));
                                                let _e2176 = select(false, (select(_e2155, -(_e2155), (_e2155 < 0.0lf)) > select(_e2161, -(_e2161), (_e2161 < 0.0lf))), (select(_e2155, -(_e2155), (_e2155 < 0.0lf)) > select(_e2158, -(_e2158), (_e2158 < 0.0lf))));
                                                let _e2191 = select((select(_e2158, -(_e2158), (_e2158 < 0.0lf)) > select(_e2161, -(_e2161), (_e2161 < 0.0lf))), false, (select(_e2155, -(_e2155), (_e2155 < 0.0lf)) > select(_e2158, -(_e2158), (_e2158 < 0.0lf))));
                                                let _e2194 = select(select(_e1884, _e1885, _e2176), _e1886, _e2191);
                                                let _e2195 = select(select(_e1885, _e1886, _e2176), _e1884, _e2191);
                                                let _e2198 = select(select(_e1993, _e1994, _e2176), _e1995, _e2191);
                                                let _e2199 = select(select(_e1994, _e1995, _e2176), _e1993, _e2191);
                                                let _e2202 = select(select(_e2102, _e2103, _e2176), _e2104, _e2191);
                                                let _e2203 = select(select(_e2103, _e2104, _e2176), _e2102, _e2191);
                                                let _e2206 = ((_e2198 * _e2203) - (_e2199 * _e2202));
                                                let _e2207 = f64(1f);
                                                let _e2208 = f64(2f);
                                                let _e2226 = (((((_e2029 * _e2152) + (_e2043 * _e2138)) * f64(2.01f)) + (((_e2043 * _e2208) * (_e2152 * _e2208)) * (1.1102230246251565e-16lf * _e2208))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2207 + _e2043) * (_e2207 + _e2152))));
                                                if (select(_e2206, -(_e2206), (_e2206 < 0.0lf)) > _e2226) {
                                                    let _e2235 = select(f64(1f), f64(-1f), (_e2206 < f64(0f)));
                                                    let _e2239 = f64(1f);
                                                    let _e2240 = f64(2f);
                                                    let _e2258 = (((((_e1920 * _e2152) + (_e1934 * _e2138)) * f64(2.01f)) + (((_e1934 * _e2240) * (_e2152 * _e2240)) * (1.1102230246251565e-16lf * _e2240))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2239 + _e1934) * (_e2239 + _e2152))));
                                                    let _e2262 = f64(1f);
                                                    let _e2263 = f64(2f);
                                                    let _e2281 = (((((_e2029 * _e1934) + (_e2043 * _e1920)) * f64(2.01f)) + (((_e2043 * _e2263) * (_e1934 * _e2263)) * (1.1102230246251565e-16lf * _e2263))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2262 + _e2043) * (_e2262 + _e1934))));
                                                    let _e2282 = (_e2206 * _e2235);
                                                    let _e2283 = (((_e2194 * _e2203) - (_e2195 * _e2202)) * _e2235);
                                                    let _e2284 = (((_e2198 * _e2195) - (_e2199 * _e2194)) * _e2235);
                                                    let _e2298 = (((select(_e2282, -(_e2282), (_e2282 < 0.0lf)) + select(_e2283, -(_e2283), (_e2283 < 0.0lf))) + select(_e2284, -(_e2284), (_e2284 < 0.0lf))) * (1.1102230246251565e-16lf * f64(4f)));
                                                    if (_e232.member != 0u) {
                                                        phi_3820_ = array<type_36, 4>(type_36(_e2283, _e2258), type_36(_e2284, _e2281), type_36((_e2282 - _e2283), ((_e2226 + _e2258) + _e2298)), type_36((_e2282 - _e2284), ((_e2226 + _e2281) + _e2298)));
                                                    } else {
                                                        let _e2301 = ((_e2282 - _e2283) - _e2284);
                                                        let _e2304 = (((_e2226 + _e2258) + _e2281) + _e2298);
                                                        phi_3820_ = array<type_36, 4>(type_36(_e2283, _e2258), type_36(_e2284, _e2281), type_36(_e2301, _e2304), type_36(_e2301, _e2304));
                                                    }
                                                    let _e2322 = phi_3820_;
                                                    local_2 = array<type_36, 4>(type_36(_e2322[0].member, _e2322[0].member_1), type_36(_e2322[1].member, _e2322[1].member_1), type_36(_e2322[2].member, _e2322[2].member_1), type_36(_e2322[3].member, _e2322[3].member_1));
                                                    phi_3840_ = type_9(0u, 4u);
                                                    phi_3843_ = true;
                                                    loop {
                                                        let _e2341 = phi_3840_;
                                                        let _e2343 = phi_3843_;
                                                        local_19 = _e2343;
                                                        let _e2346 = (_e2341.member < _e2341.member_1);
                                                        let _e2357 = select(type_9().member_1, _e2341.member, _e2346);
                                                        if (bitcast<i32>(select(0u, 1u, _e2346)) != 0i) {
                                                            let _e2362 = local_2[_e2357].member;
                                                            let _e2365 = local_2[_e2357].member_1;
                                                            let _e2367 = (_e2362 < -(_e2365));
                                                            phi_3844_ = select((_e2343 && (_e2362 > _e2365)), bool(), _e2367);
                                                            phi_3895_ = select(true, false, _e2367);
                                                            phi_3896_ = _e2367;
                                                        } else {
                                                            phi_3844_ = bool();
                                                            phi_3895_ = false;
                                                            phi_3896_ = false;
                                                        }
                                                        let _e2373 = phi_3844_;
                                                        let _e2375 = phi_3895_;
                                                        let _e2377 = phi_3896_;
                                                        local_18 = _e2377;
                                                        continue;
                                                        continuing {
                                                            phi_3840_ = type_9(select(_e2341.member, (_e2341.member + 1u), _e2346), select(_e2341.member_1, _e2341.member_1, _e2346));
                                                            phi_3843_ = _e2373;
                                                            break if !(_e2375);
                                                        }
                                                    }
                                                    let _e2380 = local_18;
                                                    let _e2381 = select(true, false, _e2380);
                                                    let _e2383 = local_19;
                                                    phi_3910_ = select(u32(), select(2u, 1u, _e2383), _e2381);
                                                    phi_3911_ = 0u;
                                                    phi_3912_ = select(true, false, _e2381);
                                                } else {
                                                    phi_3910_ = u32();
                                                    phi_3911_ = 2u;
                                                    phi_3912_ = true;
                                                }
                                                let _e2388 = phi_3910_;
                                                let _e2390 = phi_3911_;
                                                let _e2392 = phi_3912_;
                                                let _e2393 = select(_e2388, _e2390, _e2392);
                                                let _e2394 = (_e2393 == 0u);
                                                if _e2394 {
                                                    phi_3943_ = bool();
                                                    phi_3944_ = false;
                                                    phi_3945_ = false;
                                                } else {
                                                    let _e2397 = select(false, _e1811.member_2, (_e2393 == 1u));
                                                    let _e2403 = select(true, select(true, false, ((_e1811.member_1 - _e1811.member) <= _e1410)), _e2397);
                                                    phi_3943_ = _e2397;
                                                    phi_3944_ = _e2403;
                                                    phi_3945_ = select(true, false, _e2403);
                                                }
                                                let _e2406 = phi_3943_;
                                                let _e2408 = phi_3944_;
                                                let _e2410 = phi_3945_;
                                                phi_3946_ = _e2406;
                                                phi_3947_ = _e2394;
                                                phi_3948_ = _e2408;
                                                phi_3949_ = _e2410;
                                            }
                                            let _e2412 = phi_3946_;
                                            let _e2414 = phi_3947_;
                                            let _e2416 = phi_3948_;
                                            let _e2418 = phi_3949_;
                                            phi_3950_ = _e2412;
                                            phi_3951_ = _e2414;
                                            phi_3952_ = _e2416;
                                            phi_3953_ = _e1816;
                                            phi_3954_ = _e2418;
                                        }
                                        let _e2420 = phi_3950_;
                                        let _e2422 = phi_3951_;
                                        let _e2424 = phi_3952_;
                                        let _e2426 = phi_3953_;
                                        let _e2428 = phi_3954_;
                                        phi_3955_ = _e1811;
                                        phi_3956_ = _e2420;
                                        phi_3957_ = _e1811;
                                        phi_3958_ = _e2422;
                                        phi_3959_ = _e2424;
                                        phi_3960_ = _e2426;
                                        phi_3961_ = _e2428;
                                    }
                                    let _e2430 = phi_3955_;
                                    let _e2432 = phi_3956_;
                                    let _e2434 = phi_3957_;
                                    let _e2436 = phi_3958_;
                                    let _e2438 = phi_3959_;
                                    let _e2440 = phi_3960_;
                                    let _e2442 = phi_3961_;
                                    phi_3962_ = _e2430;
                                    phi_3963_ = _e2432;
                                    phi_3964_ = _e2434;
                                    phi_3965_ = _e2436;
                                    phi_3966_ = _e2438;
                                    phi_3967_ = _e1476;
                                    phi_3968_ = _e2440;
                                    phi_3969_ = _e2442;
                                } else {
                                    phi_3962_ = type_43();
                                    phi_3963_ = bool();
                                    phi_3964_ = type_43();
                                    phi_3965_ = true;
                                    phi_3966_ = false;
                                    phi_3967_ = false;
                                    phi_3968_ = false;
                                    phi_3969_ = false;
                                }
                                let _e2444 = phi_3962_;
                                let _e2446 = phi_3963_;
                                let _e2448 = phi_3964_;
                                let _e2450 = phi_3965_;
                                let _e2452 = phi_3966_;
                                let _e2454 = phi_3967_;
                                let _e2456 = phi_3968_;
                                let _e2458 = phi_3969_;
                                phi_3977_ = _e2444;
                                phi_3978_ = _e2446;
                                phi_3979_ = _e2448;
                                phi_3980_ = select(_e2452, false, _e2450);
                                phi_3981_ = _e2450;
                                phi_3982_ = select(_e2454, false, _e2450);
                                phi_3983_ = select(_e2456, false, _e2450);
                                phi_3984_ = select(_e2458, false, _e2450);
                            } else {
                                phi_3977_ = type_43(_e535, _e535, false);
                                phi_3978_ = false;
                                phi_3979_ = type_43();
                                phi_3980_ = true;
                                phi_3981_ = false;
                                phi_3982_ = false;
                                phi_3983_ = false;
                                phi_3984_ = false;
                            }
                            let _e2464 = phi_3977_;
                            let _e2466 = phi_3978_;
                            let _e2468 = phi_3979_;
                            let _e2470 = phi_3980_;
                            let _e2472 = phi_3981_;
                            let _e2474 = phi_3982_;
                            let _e2476 = phi_3983_;
                            let _e2478 = phi_3984_;
                            if _e2470 {
                                let _e2483 = local_7.member[0u];
                                let _e2489 = local_7.member_1[0u];
                                let _e2495 = local_7.member_2[0u];
                                let _e2499 = (_e2483[0] - _e2489[0]);
                                let _e2500 = (_e2483[1] - _e2489[1]);
                                let _e2501 = (_e2483[2] - _e2489[2]);
                                let _e2502 = (_e232.member == 0u);
                                let _e2514 = local_7.member[1u];
                                let _e2520 = local_7.member_1[1u];
                                let _e2526 = local_7.member_2[1u];
                                let _e2530 = (_e2514[0] - _e2520[0]);
                                let _e2531 = (_e2514[1] - _e2520[1]);
                                let _e2532 = (_e2514[2] - _e2520[2]);
                                let _e2533 = (_e232.member == 0u);
                                let _e2545 = local_7.member[0u];
                                let _e2551 = select(_e2545[0], -(_e2545[0]), (_e2545[0] < 0.0lf));
                                let _e2554 = select(_e2545[1], -(_e2545[1]), (_e2545[1] < 0.0lf));
                                let _e2556 = select(_e2554, _e2551, (_e2551 > _e2554));
                                let _e2559 = select(_e2545[2], -(_e2545[2]), (_e2545[2] < 0.0lf));
                                let _e2561 = select(_e2559, _e2556, (_e2556 > _e2559));
                                let _e2564 = local_7.member[1u];
                                let _e2570 = select(_e2564[0], -(_e2564[0]), (_e2564[0] < 0.0lf));
                                let _e2573 = select(_e2564[1], -(_e2564[1]), (_e2564[1] < 0.0lf));
                                let _e2575 = select(_e2573, _e2570, (_e2570 > _e2573));
                                let _e2578 = select(_e2564[2], -(_e2564[2]), (_e2564[2] < 0.0lf));
                                let _e2580 = select(_e2578, _e2575, (_e2575 > _e2578));
                                let _e2584 = local_7.member_3;
                                let _e2588 = local_7.member_1[0u];
                                let _e2594 = select(_e2588[0], -(_e2588[0]), (_e2588[0] < 0.0lf));
                                let _e2597 = select(_e2588[1], -(_e2588[1]), (_e2588[1] < 0.0lf));
                                let _e2599 = select(_e2597, _e2594, (_e2594 > _e2597));
                                let _e2602 = select(_e2588[2], -(_e2588[2]), (_e2588[2] < 0.0lf));
                                let _e2604 = select(_e2602, _e2599, (_e2599 > _e2602));
                                let _e2607 = local_7.member_1[1u];
                                let _e2613 = select(_e2607[0], -(_e2607[0]), (_e2607[0] < 0.0lf));
                                let _e2616 = select(_e2607[1], -(_e2607[1]), (_e2607[1] < 0.0lf));
                                let _e2618 = select(_e2616, _e2613, (_e2613 > _e2616));
                                let _e2621 = select(_e2607[2], -(_e2607[2]), (_e2607[2] < 0.0lf));
                                let _e2623 = select(_e2621, _e2618, (_e2618 > _e2621));
                                let _e2627 = local_7.member_3;
                                let _e2631 = local_7.member_2[0u];
                                let _e2637 = select(_e2631[0], -(_e2631[0]), (_e2631[0] < 0.0lf));
                                let _e2640 = select(_e2631[1], -(_e2631[1]), (_e2631[1] < 0.0lf));
                                let _e2642 = select(_e2640, _e2637, (_e2637 > _e2640));
                                let _e2645 = select(_e2631[2], -(_e2631[2]), (_e2631[2] < 0.0lf));
                                let _e2647 = select(_e2645, _e2642, (_e2642 > _e2645));
                                let _e2650 = local_7.member_2[1u];
                                let _e2656 = select(_e2650[0], -(_e2650[0]), (_e2650[0] < 0.0lf));
                                let _e2659 = select(_e2650[1], -(_e2650[1]), (_e2650[1] < 0.0lf));
                                let _e2661 = select(_e2659, _e2656, (_e2656 > _e2659));
                                let _e2664 = select(_e2650[2], -(_e2650[2]), (_e2650[2] < 0.0lf));
                                let _e2666 = select(_e2664, _e2661, (_e2661 > _e2664));
                                let _e2670 = local_7.member_3;
                                let _e2678 = local_7.member_3;
                                let _e2686 = (_e526 * f64(0.00390625f));
                                let _e2687 = f64(0f);
                                let _e2688 = f64(1f);
                                local = type_44(array<f64, 4>(_e2687, _e2687, _e2687, _e2687), array<f64, 4>(_e2687, _e2687, _e2687, _e2687), array<f64, 4>(_e2688, _e2688, _e2688, _e2688));
                                phi_4413_ = type_9(0u, 96u);
                                phi_4416_ = _e2464.member;
                                phi_4418_ = _e2464.member;
                                phi_4420_ = (_e2464.member_1 - _e2464.member);
                                phi_4422_ = _e2464.member;
                                phi_4424_ = false;
                                phi_4426_ = 0u;
                                loop {
                                    let _e2695 = phi_4413_;
                                    let _e2697 = phi_4416_;
                                    let _e2699 = phi_4418_;
                                    let _e2701 = phi_4420_;
                                    let _e2703 = phi_4422_;
                                    let _e2705 = phi_4424_;
                                    let _e2707 = phi_4426_;
                                    local_32 = _e2697;
                                    local_36 = _e2699;
                                    let _e2710 = (_e2695.member < _e2695.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2710)) != 0i) {
                                        let _e2724 = local_7.member[0u];
                                        let _e2730 = local_7.member[1u];
                                        let _e2746 = local_7.member_1[0u];
                                        let _e2752 = local_7.member_1[1u];
                                        let _e2768 = local_7.member_2[0u];
                                        let _e2774 = local_7.member_2[1u];
                                        let _e2788 = function_5(array<f64, 3>((_e2724[0] + ((_e2730[0] - _e2724[0]) * _e2697)), (_e2724[1] + ((_e2730[1] - _e2724[1]) * _e2697)), (_e2724[2] + ((_e2730[2] - _e2724[2]) * _e2697))), array<f64, 3>((_e2746[0] + ((_e2752[0] - _e2746[0]) * _e2697)), (_e2746[1] + ((_e2752[1] - _e2746[1]) * _e2697)), (_e2746[2] + ((_e2752[2] - _e2746[2]) * _e2697))), array<f64, 3>((_e2768[0] + ((_e2774[0] - _e2768[0]) * _e2697)), (_e2768[1] + ((_e2774[1] - _e2768[1]) * _e2697)), (_e2768[2] + ((_e2774[2] - _e2768[2]) * _e2697))), _e232.member);
                                        if (_e2707 == 0u) {
                                            phi_4578_ = _e2788;
                                        } else {
                                            let _e2790 = f64(0f);
                                            phi_4578_ = array<f64, 3>(select(_e2790, _e2788[0], (_e2707 == 1u)), select(_e2790, _e2788[1], (_e2707 == 2u)), select(_e2790, _e2788[2], (_e2707 == 3u)));
                                        }
                                        let _e2802 = phi_4578_;
                                        let _e2816 = ((select(_e2802[0], -(_e2802[0]), (_e2802[0] < 0.0lf)) + select(_e2802[1], -(_e2802[1]), (_e2802[1] < 0.0lf))) + select(_e2802[2], -(_e2802[2]), (_e2802[2] < 0.0lf)));
                                        if (_e2816 > f64(0f)) {
                                            if ((bitcast<u64>(_e2816) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2823 = (f64(1f) / _e2816);
                                                let _e2825 = (_e2802[0] * _e2823);
                                                let _e2827 = (_e2802[1] * _e2823);
                                                let _e2829 = (_e2802[2] * _e2823);
                                                let _e2834 = (((_e2825 * _e2825) + (_e2827 * _e2827)) + (_e2829 * _e2829));
                                                if (_e2834 <= 2.2250738585072014e-308lf) {
                                                    phi_4703_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2834 > 0.0lf));
                                                } else {
                                                    phi_4646_ = type_16(0i, 5i);
                                                    phi_4649_ = bitcast<f64>(((bitcast<u64>(_e2834) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2841 = phi_4646_;
                                                        let _e2843 = phi_4649_;
                                                        local_20 = _e2843;
                                                        if (_e2841.member < _e2841.member_1) {
                                                            let _e2850 = (_e2841.member + 1i);
                                                            phi_4647_ = type_16(select(_e2850, type_17().member_1, select(false, true, ((false == (_e2850 > _e2841.member)) != false))), _e2841.member_1);
                                                            phi_4690_ = type_17(1u, _e2841.member);
                                                        } else {
                                                            phi_4647_ = _e2841;
                                                            phi_4690_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2861 = phi_4647_;
                                                        let _e2863 = phi_4690_;
                                                        let _e2866 = (bitcast<i32>(_e2863.member) != 0i);
                                                        if _e2866 {
                                                            phi_4650_ = (0.5lf * (_e2843 + (_e2834 / _e2843)));
                                                        } else {
                                                            phi_4650_ = f64();
                                                        }
                                                        let _e2871 = phi_4650_;
                                                        continue;
                                                        continuing {
                                                            phi_4646_ = _e2861;
                                                            phi_4649_ = _e2871;
                                                            break if !(_e2866);
                                                        }
                                                    }
                                                    let _e2876 = local_20;
                                                    phi_4703_ = (_e2876 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2882 = phi_4703_;
                                                let _e2884 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2891 = ((((((((select(_e2580, _e2561, (_e2561 > _e2580)) + _e2584) + (select(_e2623, _e2604, (_e2604 > _e2623)) + _e2627)) + (select(_e2666, _e2647, (_e2647 > _e2666)) + _e2670)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2678 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e820 * _e2882) * (f64(1f) + _e2884)));
                                                let _e2896 = (((_e2825 * _e2483[0]) + (_e2827 * _e2483[1])) + (_e2829 * _e2483[2]));
                                                let _e2901 = (((_e2825 * _e2499) + (_e2827 * _e2500)) + (_e2829 * _e2501));
                                                let _e2906 = (((_e2825 * (_e2483[0] - _e2495[0])) + (_e2827 * (_e2483[1] - _e2495[1]))) + (_e2829 * (_e2483[2] - _e2495[2])));
                                                let _e2911 = (((_e2825 * select((_e2499 - _e2495[0]), _e2483[0], _e2502)) + (_e2827 * select((_e2500 - _e2495[1]), _e2483[1], _e2502))) + (_e2829 * select((_e2501 - _e2495[2]), _e2483[2], _e2502)));
                                                let _e2917 = (((_e2825 * _e2514[0]) + (_e2827 * _e2514[1])) + (_e2829 * _e2514[2]));
                                                let _e2922 = (((_e2825 * _e2530) + (_e2827 * _e2531)) + (_e2829 * _e2532));
                                                let _e2927 = (((_e2825 * (_e2514[0] - _e2526[0])) + (_e2827 * (_e2514[1] - _e2526[1]))) + (_e2829 * (_e2514[2] - _e2526[2])));
                                                let _e2932 = (((_e2825 * select((_e2530 - _e2526[0]), _e2514[0], _e2533)) + (_e2827 * select((_e2531 - _e2526[1]), _e2514[1], _e2533))) + (_e2829 * select((_e2532 - _e2526[2]), _e2514[2], _e2533)));
                                                phi_4829_ = type_44(array<f64, 4>(_e2896, _e2901, _e2906, _e2911), array<f64, 4>(_e2917, _e2922, _e2927, _e2932), array<f64, 4>((_e2891 + ((select(_e2896, -(_e2896), (_e2896 < 0.0lf)) + select(_e2917, -(_e2917), (_e2917 < 0.0lf))) * _e2884)), (_e2891 + ((select(_e2901, -(_e2901), (_e2901 < 0.0lf)) + select(_e2922, -(_e2922), (_e2922 < 0.0lf))) * _e2884)), (_e2891 + ((select(_e2906, -(_e2906), (_e2906 < 0.0lf)) + select(_e2927, -(_e2927), (_e2927 < 0.0lf))) * _e2884)), (_e2891 + ((select(_e2911, -(_e2911), (_e2911 < 0.0lf)) + select(_e2932, -(_e2932), (_e2932 < 0.0lf))) * _e2884))));
                                                phi_4830_ = false;
                                            } else {
                                                phi_4829_ = type_44();
                                                phi_4830_ = true;
                                            }
                                            let _e2973 = phi_4829_;
                                            let _e2975 = phi_4830_;
                                            phi_4831_ = _e2973;
                                            phi_4832_ = _e2975;
                                        } else {
                                            phi_4831_ = type_44();
                                            phi_4832_ = true;
                                        }
                                        let _e2977 = phi_4831_;
                                        let _e2979 = phi_4832_;
                                        if _e2979 {
                                            let _e2980 = f64(0f);
                                            let _e2981 = f64(1f);
                                            phi_4842_ = type_44(array<f64, 4>(_e2980, _e2980, _e2980, _e2980), array<f64, 4>(_e2980, _e2980, _e2980, _e2980), array<f64, 4>(_e2981, _e2981, _e2981, _e2981));
                                        } else {
                                            phi_4842_ = _e2977;
                                        }
                                        let _e2987 = phi_4842_;
                                        local_1 = type_44(array<f64, 4>(_e2987.member[0], _e2987.member[1], _e2987.member[2], _e2987.member[3]), array<f64, 4>(_e2987.member_1[0], _e2987.member_1[1], _e2987.member_1[2], _e2987.member_1[3]), array<f64, 4>(_e2987.member_2[0], _e2987.member_2[1], _e2987.member_2[2], _e2987.member_2[3]));
                                        let _e3007 = (_e2697 - _e2703);
                                        let _e3009 = f64(0f);
                                        let _e3012 = local_1.member[0u];
                                        let _e3015 = local_1.member_1[0u];
                                        let _e3018 = local_1.member[0u];
                                        let _e3024 = local_1.member_2[0u];
                                        if (((_e3012 + ((_e3015 - _e3018) * _e2697)) - _e3024) > _e3009) {
                                            let _e3029 = local_1.member[1u];
                                            let _e3032 = local_1.member_1[1u];
                                            let _e3035 = local_1.member[1u];
                                            let _e3041 = local_1.member_2[1u];
                                            if (((_e3029 + ((_e3032 - _e3035) * _e2697)) - _e3041) > _e3009) {
                                                let _e3046 = local_1.member[2u];
                                                let _e3049 = local_1.member_1[2u];
                                                let _e3052 = local_1.member[2u];
                                                let _e3058 = local_1.member_2[2u];
                                                if (((_e3046 + ((_e3049 - _e3052) * _e2697)) - _e3058) > _e3009) {
                                                    let _e3063 = local_1.member[3u];
                                                    let _e3066 = local_1.member_1[3u];
                                                    let _e3069 = local_1.member[3u];
                                                    let _e3075 = local_1.member_2[3u];
                                                    phi_5014_ = (((_e3063 + ((_e3066 - _e3069) * _e2697)) - _e3075) > _e3009);
                                                    phi_5015_ = false;
                                                } else {
                                                    phi_5014_ = bool();
                                                    phi_5015_ = true;
                                                }
                                                let _e3079 = phi_5014_;
                                                let _e3081 = phi_5015_;
                                                phi_5016_ = _e3079;
                                                phi_5017_ = _e3081;
                                            } else {
                                                phi_5016_ = bool();
                                                phi_5017_ = true;
                                            }
                                            let _e3083 = phi_5016_;
                                            let _e3085 = phi_5017_;
                                            phi_5018_ = _e3083;
                                            phi_5019_ = _e3085;
                                        } else {
                                            phi_5018_ = bool();
                                            phi_5019_ = true;
                                        }
                                        let _e3087 = phi_5018_;
                                        let _e3089 = phi_5019_;
                                        if select(_e3087, false, _e3089) {
                                            if (_e2697 <= _e2699) {
                                                phi_5334_ = true;
                                            } else {
                                                let _e3092 = f64(0f);
                                                let _e3095 = local.member[0u];
                                                let _e3098 = local.member_1[0u];
                                                let _e3101 = local.member[0u];
                                                let _e3107 = local.member_2[0u];
                                                let _e3111 = local_1.member[0u];
                                                let _e3114 = local_1.member_1[0u];
                                                let _e3117 = local_1.member[0u];
                                                let _e3123 = local_1.member_2[0u];
                                                if ((((_e3095 + ((_e3098 - _e3101) * _e2697)) - _e3107) + ((_e3111 + ((_e3114 - _e3117) * _e2703)) - _e3123)) > _e3092) {
                                                    let _e3129 = local.member[1u];
                                                    let _e3132 = local.member_1[1u];
                                                    let _e3135 = local.member[1u];
                                                    let _e3141 = local.member_2[1u];
                                                    let _e3145 = local_1.member[1u];
                                                    let _e3148 = local_1.member_1[1u];
                                                    let _e3151 = local_1.member[1u];
                                                    let _e3157 = local_1.member_2[1u];
                                                    if ((((_e3129 + ((_e3132 - _e3135) * _e2697)) - _e3141) + ((_e3145 + ((_e3148 - _e3151) * _e2703)) - _e3157)) > _e3092) {
                                                        let _e3163 = local.member[2u];
                                                        let _e3166 = local.member_1[2u];
                                                        let _e3169 = local.member[2u];
                                                        let _e3175 = local.member_2[2u];
                                                        let _e3179 = local_1.member[2u];
                                                        let _e3182 = local_1.member_1[2u];
                                                        let _e3185 = local_1.member[2u];
                                                        let _e3191 = local_1.member_2[2u];
                                                        if ((((_e3163 + ((_e3166 - _e3169) * _e2697)) - _e3175) + ((_e3179 + ((_e3182 - _e3185) * _e2703)) - _e3191)) > _e3092) {
                                                            let _e3197 = local.member[3u];
                                                            let _e3200 = local.member_1[3u];
                                                            let _e3203 = local.member[3u];
                                                            let _e3209 = local.member_2[3u];
                                                            let _e3213 = local_1.member[3u];
                                                            let _e3216 = local_1.member_1[3u];
                                                            let _e3219 = local_1.member[3u];
                                                            let _e3225 = local_1.member_2[3u];
                                                            phi_5321_ = ((((_e3197 + ((_e3200 - _e3203) * _e2697)) - _e3209) + ((_e3213 + ((_e3216 - _e3219) * _e2703)) - _e3225)) > _e3092);
                                                            phi_5322_ = false;
                                                        } else {
                                                            phi_5321_ = bool();
                                                            phi_5322_ = true;
                                                        }
                                                        let _e3230 = phi_5321_;
                                                        let _e3232 = phi_5322_;
                                                        phi_5323_ = _e3230;
                                                        phi_5324_ = _e3232;
                                                    } else {
                                                        phi_5323_ = bool();
                                                        phi_5324_ = true;
                                                    }
                                                    let _e3234 = phi_5323_;
                                                    let _e3236 = phi_5324_;
                                                    phi_5325_ = _e3234;
                                                    phi_5326_ = _e3236;
                                                } else {
                                                    phi_5325_ = bool();
                                                    phi_5326_ = true;
                                                }
                                                let _e3238 = phi_5325_;
                                                let _e3240 = phi_5326_;
                                                phi_5334_ = select(_e3238, false, _e3240);
                                            }
                                            let _e3243 = phi_5334_;
                                            if _e3243 {
                                                if select(true, select(true, false, (_e2697 >= _e2464.member_1)), _e2705) {
                                                    local = type_44(array<f64, 4>(_e2987.member[0], _e2987.member[1], _e2987.member[2], _e2987.member[3]), array<f64, 4>(_e2987.member_1[0], _e2987.member_1[1], _e2987.member_1[2], _e2987.member_1[3]), array<f64, 4>(_e2987.member_2[0], _e2987.member_2[1], _e2987.member_2[2], _e2987.member_2[3]));
                                                    let _e3268 = local.member[0u];
                                                    let _e3271 = local.member_1[0u];
                                                    let _e3274 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e3271 > _e3274)), (_e3268 > _e3274)) {
                                                        let _e3279 = (_e3271 >= _e3268);
                                                        if _e3279 {
                                                            phi_5446_ = f64();
                                                            phi_5447_ = false;
                                                        } else {
                                                            if ((_e3268 - _e3271) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5444_ = (((_e3268 - _e3274) / (_e3268 - _e3271)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5445_ = false;
                                                            } else {
                                                                phi_5444_ = f64();
                                                                phi_5445_ = true;
                                                            }
                                                            let _e3293 = phi_5444_;
                                                            let _e3295 = phi_5445_;
                                                            phi_5446_ = _e3293;
                                                            phi_5447_ = _e3295;
                                                        }
                                                        let _e3297 = phi_5446_;
                                                        let _e3299 = phi_5447_;
                                                        phi_5448_ = _e3297;
                                                        phi_5449_ = _e3279;
                                                        phi_5450_ = _e3299;
                                                    } else {
                                                        phi_5448_ = f64();
                                                        phi_5449_ = true;
                                                        phi_5450_ = false;
                                                    }
                                                    let _e3301 = phi_5448_;
                                                    let _e3303 = phi_5449_;
                                                    let _e3305 = phi_5450_;
                                                    let _e3309 = select(_e3301, select(_e2697, f64(2f), _e3303), select(_e3305, true, _e3303));
                                                    let _e3312 = local.member[1u];
                                                    let _e3315 = local.member_1[1u];
                                                    let _e3318 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e3315 > _e3318)), (_e3312 > _e3318)) {
                                                        let _e3323 = (_e3315 >= _e3312);
                                                        if _e3323 {
                                                            phi_5518_ = f64();
                                                            phi_5519_ = false;
                                                        } else {
                                                            if ((_e3312 - _e3315) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5516_ = (((_e3312 - _e3318) / (_e3312 - _e3315)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5517_ = false;
                                                            } else {
                                                                phi_5516_ = f64();
                                                                phi_5517_ = true;
                                                            }
                                                            let _e3337 = phi_5516_;
                                                            let _e3339 = phi_5517_;
                                                            phi_5518_ = _e3337;
                                                            phi_5519_ = _e3339;
                                                        }
                                                        let _e3341 = phi_5518_;
                                                        let _e3343 = phi_5519_;
                                                        phi_5520_ = _e3341;
                                                        phi_5521_ = _e3323;
                                                        phi_5522_ = _e3343;
                                                    } else {
                                                        phi_5520_ = f64();
                                                        phi_5521_ = true;
                                                        phi_5522_ = false;
                                                    }
                                                    let _e3345 = phi_5520_;
                                                    let _e3347 = phi_5521_;
                                                    let _e3349 = phi_5522_;
                                                    let _e3353 = select(_e3345, select(_e2697, f64(2f), _e3347), select(_e3349, true, _e3347));
                                                    let _e3355 = select(_e3353, _e3309, (_e3309 < _e3353));
                                                    let _e3358 = local.member[2u];
                                                    let _e3361 = local.member_1[2u];
                                                    let _e3364 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3361 > _e3364)), (_e3358 > _e3364)) {
                                                        let _e3369 = (_e3361 >= _e3358);
                                                        if _e3369 {
                                                            phi_5595_ = f64();
                                                            phi_5596_ = false;
                                                        } else {
                                                            if ((_e3358 - _e3361) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5593_ = (((_e3358 - _e3364) / (_e3358 - _e3361)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5594_ = false;
                                                            } else {
                                                                phi_5593_ = f64();
                                                                phi_5594_ = true;
                                                            }
                                                            let _e3383 = phi_5593_;
                                                            let _e3385 = phi_5594_;
                                                            phi_5595_ = _e3383;
                                                            phi_5596_ = _e3385;
                                                        }
                                                        let _e3387 = phi_5595_;
                                                        let _e3389 = phi_5596_;
                                                        phi_5597_ = _e3387;
                                                        phi_5598_ = _e3369;
                                                        phi_5599_ = _e3389;
                                                    } else {
                                                        phi_5597_ = f64();
                                                        phi_5598_ = true;
                                                        phi_5599_ = false;
                                                    }
                                                    let _e3391 = phi_5597_;
                                                    let _e3393 = phi_5598_;
                                                    let _e3395 = phi_5599_;
                                                    let _e3399 = select(_e3391, select(_e2697, f64(2f), _e3393), select(_e3395, true, _e3393));
                                                    let _e3402 = local.member[3u];
                                                    let _e3405 = local.member_1[3u];
                                                    let _e3408 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3405 > _e3408)), (_e3402 > _e3408)) {
                                                        let _e3413 = (_e3405 >= _e3402);
                                                        if _e3413 {
                                                            phi_5667_ = f64();
                                                            phi_5668_ = false;
                                                        } else {
                                                            if ((_e3402 - _e3405) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5665_ = (((_e3402 - _e3408) / (_e3402 - _e3405)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5666_ = false;
                                                            } else {
                                                                phi_5665_ = f64();
                                                                phi_5666_ = true;
                                                            }
                                                            let _e3427 = phi_5665_;
                                                            let _e3429 = phi_5666_;
                                                            phi_5667_ = _e3427;
                                                            phi_5668_ = _e3429;
                                                        }
                                                        let _e3431 = phi_5667_;
                                                        let _e3433 = phi_5668_;
                                                        phi_5669_ = _e3431;
                                                        phi_5670_ = _e3413;
                                                        phi_5671_ = _e3433;
                                                    } else {
                                                        phi_5669_ = f64();
                                                        phi_5670_ = true;
                                                        phi_5671_ = false;
                                                    }
                                                    let _e3435 = phi_5669_;
                                                    let _e3437 = phi_5670_;
                                                    let _e3439 = phi_5671_;
                                                    let _e3443 = select(_e3435, select(_e2697, f64(2f), _e3437), select(_e3439, true, _e3437));
                                                    let _e3445 = select(_e3443, _e3399, (_e3399 < _e3443));
                                                    let _e3447 = select(_e3445, _e3355, (_e3355 < _e3445));
                                                    let _e3449 = select(_e2697, _e3447, (_e3447 > _e2697));
                                                    let _e3450 = (_e3449 > _e2464.member_1);
                                                    if _e3450 {
                                                        phi_6213_ = f64();
                                                        phi_6214_ = f64();
                                                        phi_6215_ = false;
                                                        phi_6216_ = false;
                                                    } else {
                                                        let _e3451 = (_e3449 - _e2697);
                                                        let _e3452 = (_e3451 <= _e2686);
                                                        let _e3455 = (_e3449 + (_e526 * f64(0.01f)));
                                                        let _e3457 = select(_e2464.member_1, _e3455, (_e3455 < _e2464.member_1));
                                                        if _e3452 {
                                                            if (_e820 > f64(0f)) {
                                                                let _e3462 = local_7.member[0u];
                                                                let _e3468 = local_7.member[1u];
                                                                let _e3484 = local_7.member_1[0u];
                                                                let _e3490 = local_7.member_1[1u];
                                                                let _e3506 = local_7.member_2[0u];
                                                                let _e3512 = local_7.member_2[1u];
                                                                let _e3526 = function_5(array<f64, 3>((_e3462[0] + ((_e3468[0] - _e3462[0]) * _e3457)), (_e3462[1] + ((_e3468[1] - _e3462[1]) * _e3457)), (_e3462[2] + ((_e3468[2] - _e3462[2]) * _e3457))), array<f64, 3>((_e3484[0] + ((_e3490[0] - _e3484[0]) * _e3457)), (_e3484[1] + ((_e3490[1] - _e3484[1]) * _e3457)), (_e3484[2] + ((_e3490[2] - _e3484[2]) * _e3457))), array<f64, 3>((_e3506[0] + ((_e3512[0] - _e3506[0]) * _e3457)), (_e3506[1] + ((_e3512[1] - _e3506[1]) * _e3457)), (_e3506[2] + ((_e3512[2] - _e3506[2]) * _e3457))), _e232.member);
                                                                let _e3537 = (((_e3526[0] * _e3526[0]) + (_e3526[1] * _e3526[1])) + (_e3526[2] * _e3526[2]));
                                                                if (_e3537 <= 2.2250738585072014e-308lf) {
                                                                    phi_5905_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3537 > 0.0lf));
                                                                } else {
                                                                    phi_5848_ = type_16(0i, 5i);
                                                                    phi_5851_ = bitcast<f64>(((bitcast<u64>(_e3537) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e3544 = phi_5848_;
                                                                        let _e3546 = phi_5851_;
                                                                        local_21 = _e3546;
                                                                        if (_e3544.member < _e3544.member_1) {
                                                                            let _e3553 = (_e3544.member + 1i);
                                                                            phi_5849_ = type_16(select(_e3553, type_17().member_1, select(false, true, ((false == (_e3553 > _e3544.member)) != false))), _e3544.member_1);
                                                                            phi_5892_ = type_17(1u, _e3544.member);
                                                                        } else {
                                                                            phi_5849_ = _e3544;
                                                                            phi_5892_ = type_17(0u, type_17().member_1);
                                                                        }
                                                                        let _e3564 = phi_5849_;
                                                                        let _e3566 = phi_5892_;
                                                                        let _e3569 = (bitcast<i32>(_e3566.member) != 0i);
                                                                        if _e3569 {
                                                                            phi_5852_ = (0.5lf * (_e3546 + (_e3537 / _e3546)));
                                                                        } else {
                                                                            phi_5852_ = f64();
                                                                        }
                                                                        let _e3574 = phi_5852_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_5848_ = _e3564;
                                                                            phi_5851_ = _e3574;
                                                                            break if !(_e3569);
                                                                        }
                                                                    }
                                                                    let _e3579 = local_21;
                                                                    phi_5905_ = (_e3579 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e3585 = phi_5905_;
                                                                let _e3593 = local_7.member[0u];
                                                                let _e3599 = select(_e3593[0], -(_e3593[0]), (_e3593[0] < 0.0lf));
                                                                let _e3602 = select(_e3593[1], -(_e3593[1]), (_e3593[1] < 0.0lf));
                                                                let _e3604 = select(_e3602, _e3599, (_e3599 > _e3602));
                                                                let _e3607 = select(_e3593[2], -(_e3593[2]), (_e3593[2] < 0.0lf));
                                                                let _e3609 = select(_e3607, _e3604, (_e3604 > _e3607));
                                                                let _e3612 = local_7.member[1u];
                                                                let _e3618 = select(_e3612[0], -(_e3612[0]), (_e3612[0] < 0.0lf));
                                                                let _e3621 = select(_e3612[1], -(_e3612[1]), (_e3612[1] < 0.0lf));
                                                                let _e3623 = select(_e3621, _e3618, (_e3618 > _e3621));
                                                                let _e3626 = select(_e3612[2], -(_e3612[2]), (_e3612[2] < 0.0lf));
                                                                let _e3628 = select(_e3626, _e3623, (_e3623 > _e3626));
                                                                let _e3632 = local_7.member_3;
                                                                let _e3636 = local_7.member_1[0u];
                                                                let _e3642 = select(_e3636[0], -(_e3636[0]), (_e3636[0] < 0.0lf));
                                                                let _e3645 = select(_e3636[1], -(_e3636[1]), (_e3636[1] < 0.0lf));
                                                                let _e3647 = select(_e3645, _e3642, (_e3642 > _e3645));
                                                                let _e3650 = select(_e3636[2], -(_e3636[2]), (_e3636[2] < 0.0lf));
                                                                let _e3652 = select(_e3650, _e3647, (_e3647 > _e3650));
                                                                let _e3655 = local_7.member_1[1u];
                                                                let _e3661 = select(_e3655[0], -(_e3655[0]), (_e3655[0] < 0.0lf));
                                                                let _e3664 = select(_e3655[1], -(_e3655[1]), (_e3655[1] < 0.0lf));
                                                                let _e3666 = select(_e3664, _e3661, (_e3661 > _e3664));
                                                                let _e3669 = select(_e3655[2], -(_e3655[2]), (_e3655[2] < 0.0lf));
                                                                let _e3671 = select(_e3669, _e3666, (_e3666 > _e3669));
                                                                let _e3675 = local_7.member_3;
                                                                let _e3679 = local_7.member_2[0u];
                                                                let _e3685 = select(_e3679[0], -(_e3679[0]), (_e3679[0] < 0.0lf));
                                                                let _e3688 = select(_e3679[1], -(_e3679[1]), (_e3679[1] < 0.0lf));
                                                                let _e3690 = select(_e3688, _e3685, (_e3685 > _e3688));
                                                                let _e3693 = select(_e3679[2], -(_e3679[2]), (_e3679[2] < 0.0lf));
                                                                let _e3695 = select(_e3693, _e3690, (_e3690 > _e3693));
                                                                let _e3698 = local_7.member_2[1u];
                                                                let _e3704 = select(_e3698[0], -(_e3698[0]), (_e3698[0] < 0.0lf));
                                                                let _e3707 = select(_e3698[1], -(_e3698[1]), (_e3698[1] < 0.0lf));
                                                                let _e3709 = select(_e3707, _e3704, (_e3704 > _e3707));
                                                                let _e3712 = select(_e3698[2], -(_e3698[2]), (_e3698[2] < 0.0lf));
                                                                let _e3714 = select(_e3712, _e3709, (_e3709 > _e3712));
                                                                let _e3718 = local_7.member_3;
                                                                let _e3726 = local_7.member_3;
                                                                phi_6182_ = select(true, false, (((_e3585 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e3628, _e3609, (_e3609 > _e3628)) + _e3632) + (select(_e3671, _e3652, (_e3652 > _e3671)) + _e3675)) + (select(_e3714, _e3695, (_e3695 > _e3714)) + _e3718)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3726 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e820));
                                                            } else {
                                                                phi_6182_ = true;
                                                            }
                                                            let _e3739 = phi_6182_;
                                                            phi_6183_ = _e3739;
                                                        } else {
                                                            phi_6183_ = true;
                                                        }
                                                        let _e3741 = phi_6183_;
                                                        if _e3741 {
                                                            if _e2705 {
                                                                let _e3745 = (_e3451 <= (_e2701 * f64(0.25f)));
                                                                phi_6210_ = select(select(select(f64(), f64(0f), _e3745), f64(), _e3452), (_e3007 + _e3007), select(select(true, false, _e3745), true, _e3452));
                                                            } else {
                                                                phi_6210_ = (_e2464.member_1 - _e2697);
                                                            }
                                                            let _e3754 = phi_6210_;
                                                            phi_6211_ = _e3754;
                                                            phi_6212_ = false;
                                                        } else {
                                                            phi_6211_ = f64();
                                                            phi_6212_ = true;
                                                        }
                                                        let _e3756 = phi_6211_;
                                                        let _e3758 = phi_6212_;
                                                        phi_6213_ = _e3756;
                                                        phi_6214_ = _e3451;
                                                        phi_6215_ = _e3741;
                                                        phi_6216_ = _e3758;
                                                    }
                                                    let _e3760 = phi_6213_;
                                                    let _e3762 = phi_6214_;
                                                    let _e3764 = phi_6215_;
                                                    let _e3766 = phi_6216_;
                                                    phi_6217_ = _e3449;
                                                    phi_6218_ = _e3760;
                                                    phi_6219_ = _e3762;
                                                    phi_6220_ = _e3449;
                                                    phi_6221_ = _e3764;
                                                    phi_6222_ = _e3450;
                                                    phi_6223_ = _e3766;
                                                    phi_6224_ = false;
                                                } else {
                                                    phi_6217_ = f64();
                                                    phi_6218_ = f64();
                                                    phi_6219_ = f64();
                                                    phi_6220_ = f64();
                                                    phi_6221_ = false;
                                                    phi_6222_ = false;
                                                    phi_6223_ = false;
                                                    phi_6224_ = true;
                                                }
                                                let _e3768 = phi_6217_;
                                                let _e3770 = phi_6218_;
                                                let _e3772 = phi_6219_;
                                                let _e3774 = phi_6220_;
                                                let _e3776 = phi_6221_;
                                                let _e3778 = phi_6222_;
                                                let _e3780 = phi_6223_;
                                                let _e3782 = phi_6224_;
                                                phi_6225_ = _e3768;
                                                phi_6226_ = _e3770;
                                                phi_6227_ = _e3772;
                                                phi_6228_ = _e3774;
                                                phi_6229_ = false;
                                                phi_6230_ = _e3776;
                                                phi_6231_ = _e3778;
                                                phi_6232_ = _e3780;
                                                phi_6233_ = _e3782;
                                            } else {
                                                phi_6225_ = f64();
                                                phi_6226_ = f64();
                                                phi_6227_ = f64();
                                                phi_6228_ = f64();
                                                phi_6229_ = true;
                                                phi_6230_ = false;
                                                phi_6231_ = false;
                                                phi_6232_ = false;
                                                phi_6233_ = false;
                                            }
                                            let _e3784 = phi_6225_;
                                            let _e3786 = phi_6226_;
                                            let _e3788 = phi_6227_;
                                            let _e3790 = phi_6228_;
                                            let _e3792 = phi_6229_;
                                            let _e3794 = phi_6230_;
                                            let _e3796 = phi_6231_;
                                            let _e3798 = phi_6232_;
                                            let _e3800 = phi_6233_;
                                            phi_6234_ = _e3784;
                                            phi_6235_ = _e3786;
                                            phi_6236_ = _e3788;
                                            phi_6237_ = _e3790;
                                            phi_6238_ = _e3792;
                                            phi_6239_ = _e3794;
                                            phi_6240_ = _e3796;
                                            phi_6241_ = _e3798;
                                            phi_6242_ = _e3800;
                                        } else {
                                            phi_6234_ = f64();
                                            phi_6235_ = f64();
                                            phi_6236_ = f64();
                                            phi_6237_ = f64();
                                            phi_6238_ = true;
                                            phi_6239_ = false;
                                            phi_6240_ = false;
                                            phi_6241_ = false;
                                            phi_6242_ = false;
                                        }
                                        let _e3802 = phi_6234_;
                                        let _e3804 = phi_6235_;
                                        let _e3806 = phi_6236_;
                                        let _e3808 = phi_6237_;
                                        let _e3810 = phi_6238_;
                                        let _e3812 = phi_6239_;
                                        let _e3814 = phi_6240_;
                                        let _e3816 = phi_6241_;
                                        let _e3818 = phi_6242_;
                                        if _e3810 {
                                            if (_e2697 <= _e2699) {
                                                let _e3976 = (_e2707 + 1u);
                                                let _e3977 = (_e3976 > 3u);
                                                phi_6582_ = _e3976;
                                                phi_6583_ = f64();
                                                phi_6584_ = false;
                                                phi_6585_ = select(true, false, _e3977);
                                                phi_6586_ = _e3977;
                                            } else {
                                                let _e3822 = local.member[0u];
                                                let _e3825 = local.member_1[0u];
                                                let _e3828 = local.member[0u];
                                                let _e3834 = local.member_2[0u];
                                                let _e3835 = ((_e3822 + ((_e3825 - _e3828) * _e2703)) - _e3834);
                                                let _e3838 = local.member[1u];
                                                let _e3841 = local.member_1[1u];
                                                let _e3844 = local.member[1u];
                                                let _e3850 = local.member_2[1u];
                                                let _e3851 = ((_e3838 + ((_e3841 - _e3844) * _e2703)) - _e3850);
                                                let _e3853 = select(_e3851, _e3835, (_e3835 < _e3851));
                                                let _e3856 = local.member[2u];
                                                let _e3859 = local.member_1[2u];
                                                let _e3862 = local.member[2u];
                                                let _e3868 = local.member_2[2u];
                                                let _e3869 = ((_e3856 + ((_e3859 - _e3862) * _e2703)) - _e3868);
                                                let _e3872 = local.member[3u];
                                                let _e3875 = local.member_1[3u];
                                                let _e3878 = local.member[3u];
                                                let _e3884 = local.member_2[3u];
                                                let _e3885 = ((_e3872 + ((_e3875 - _e3878) * _e2703)) - _e3884);
                                                let _e3887 = select(_e3885, _e3869, (_e3869 < _e3885));
                                                let _e3889 = select(_e3887, _e3853, (_e3853 < _e3887));
                                                let _e3892 = local_1.member[0u];
                                                let _e3895 = local_1.member_1[0u];
                                                let _e3898 = local_1.member[0u];
                                                let _e3904 = local_1.member_2[0u];
                                                let _e3905 = ((_e3892 + ((_e3895 - _e3898) * _e2697)) - _e3904);
                                                let _e3908 = local_1.member[1u];
                                                let _e3911 = local_1.member_1[1u];
                                                let _e3914 = local_1.member[1u];
                                                let _e3920 = local_1.member_2[1u];
                                                let _e3921 = ((_e3908 + ((_e3911 - _e3914) * _e2697)) - _e3920);
                                                let _e3923 = select(_e3921, _e3905, (_e3905 < _e3921));
                                                let _e3926 = local_1.member[2u];
                                                let _e3929 = local_1.member_1[2u];
                                                let _e3932 = local_1.member[2u];
                                                let _e3938 = local_1.member_2[2u];
                                                let _e3939 = ((_e3926 + ((_e3929 - _e3932) * _e2697)) - _e3938);
                                                let _e3942 = local_1.member[3u];
                                                let _e3945 = local_1.member_1[3u];
                                                let _e3948 = local_1.member[3u];
                                                let _e3954 = local_1.member_2[3u];
                                                let _e3955 = ((_e3942 + ((_e3945 - _e3948) * _e2697)) - _e3954);
                                                let _e3957 = select(_e3955, _e3939, (_e3939 < _e3955));
                                                let _e3959 = select(_e3957, _e3923, (_e3923 < _e3957));
                                                let _e3960 = f64(0.0625f);
                                                let _e3962 = f64(0.9f);
                                                if (_e3959 > f64(0f)) {
                                                    phi_6580_ = f64(0.5f);
                                                } else {
                                                    let _e3968 = (f64(0.95f) * (_e3889 / (_e3889 - _e3959)));
                                                    phi_6580_ = select(_e3960, select(_e3962, _e3968, (_e3968 < _e3962)), (_e3968 > _e3960));
                                                }
                                                let _e3974 = phi_6580_;
                                                phi_6582_ = u32();
                                                phi_6583_ = (_e3007 * _e3974);
                                                phi_6584_ = true;
                                                phi_6585_ = false;
                                                phi_6586_ = false;
                                            }
                                            let _e3980 = phi_6582_;
                                            let _e3982 = phi_6583_;
                                            let _e3984 = phi_6584_;
                                            let _e3986 = phi_6585_;
                                            let _e3988 = phi_6586_;
                                            phi_6587_ = _e3980;
                                            phi_6588_ = _e2699;
                                            phi_6589_ = _e3982;
                                            phi_6590_ = _e2701;
                                            phi_6591_ = _e2703;
                                            phi_6592_ = _e2705;
                                            phi_6593_ = _e2707;
                                            phi_6594_ = _e3984;
                                            phi_6595_ = _e3986;
                                            phi_6596_ = _e3988;
                                            phi_6597_ = false;
                                            phi_6598_ = false;
                                            phi_6599_ = false;
                                        } else {
                                            phi_6587_ = u32();
                                            phi_6588_ = _e3802;
                                            phi_6589_ = _e3804;
                                            phi_6590_ = _e3806;
                                            phi_6591_ = _e2697;
                                            phi_6592_ = true;
                                            phi_6593_ = 0u;
                                            phi_6594_ = _e3812;
                                            phi_6595_ = false;
                                            phi_6596_ = false;
                                            phi_6597_ = _e3814;
                                            phi_6598_ = _e3816;
                                            phi_6599_ = _e3818;
                                        }
                                        let _e3990 = phi_6587_;
                                        let _e3992 = phi_6588_;
                                        let _e3994 = phi_6589_;
                                        let _e3996 = phi_6590_;
                                        let _e3998 = phi_6591_;
                                        let _e4000 = phi_6592_;
                                        let _e4002 = phi_6593_;
                                        let _e4004 = phi_6594_;
                                        let _e4006 = phi_6595_;
                                        let _e4008 = phi_6596_;
                                        let _e4010 = phi_6597_;
                                        let _e4012 = phi_6598_;
                                        let _e4014 = phi_6599_;
                                        if _e4004 {
                                            let _e4015 = (_e3998 + _e3994);
                                            let _e4017 = select(_e3992, _e4015, (_e4015 > _e3992));
                                            let _e4019 = select(_e2464.member_1, _e4017, (_e4017 < _e2464.member_1));
                                            let _e4022 = select(((_e4019 - _e3998) > _e2686), true, !(_e2705));
                                            phi_6627_ = _e4019;
                                            phi_6628_ = _e3992;
                                            phi_6629_ = _e3996;
                                            phi_6630_ = _e3998;
                                            phi_6631_ = _e4000;
                                            phi_6632_ = _e4002;
                                            phi_6633_ = _e4022;
                                            phi_6634_ = select(true, false, _e4022);
                                            phi_6635_ = false;
                                            phi_6636_ = false;
                                            phi_6637_ = false;
                                            phi_6638_ = false;
                                        } else {
                                            phi_6627_ = _e2697;
                                            phi_6628_ = _e2699;
                                            phi_6629_ = _e2701;
                                            phi_6630_ = _e2703;
                                            phi_6631_ = _e2705;
                                            phi_6632_ = _e3990;
                                            phi_6633_ = _e4006;
                                            phi_6634_ = false;
                                            phi_6635_ = _e4008;
                                            phi_6636_ = _e4010;
                                            phi_6637_ = _e4012;
                                            phi_6638_ = _e4014;
                                        }
                                        let _e4025 = phi_6627_;
                                        let _e4027 = phi_6628_;
                                        let _e4029 = phi_6629_;
                                        let _e4031 = phi_6630_;
                                        let _e4033 = phi_6631_;
                                        let _e4035 = phi_6632_;
                                        let _e4037 = phi_6633_;
                                        let _e4039 = phi_6634_;
                                        let _e4041 = phi_6635_;
                                        let _e4043 = phi_6636_;
                                        let _e4045 = phi_6637_;
                                        let _e4047 = phi_6638_;
                                        phi_4417_ = _e4025;
                                        phi_4419_ = _e4027;
                                        phi_4421_ = _e4029;
                                        phi_4423_ = _e4031;
                                        phi_4425_ = _e4033;
                                        phi_4427_ = _e4035;
                                        phi_6639_ = _e3992;
                                        phi_6640_ = _e3808;
                                        phi_6641_ = _e4037;
                                        phi_6642_ = _e4039;
                                        phi_6643_ = _e4041;
                                        phi_6644_ = _e4043;
                                        phi_6645_ = _e4045;
                                        phi_6646_ = false;
                                        phi_6647_ = _e4047;
                                    } else {
                                        phi_4417_ = f64();
                                        phi_4419_ = f64();
                                        phi_4421_ = f64();
                                        phi_4423_ = f64();
                                        phi_4425_ = bool();
                                        phi_4427_ = u32();
                                        phi_6639_ = f64();
                                        phi_6640_ = f64();
                                        phi_6641_ = false;
                                        phi_6642_ = false;
                                        phi_6643_ = false;
                                        phi_6644_ = false;
                                        phi_6645_ = false;
                                        phi_6646_ = true;
                                        phi_6647_ = false;
                                    }
                                    let _e4049 = phi_4417_;
                                    let _e4051 = phi_4419_;
                                    let _e4053 = phi_4421_;
                                    let _e4055 = phi_4423_;
                                    let _e4057 = phi_4425_;
                                    let _e4059 = phi_4427_;
                                    let _e4061 = phi_6639_;
                                    let _e4063 = phi_6640_;
                                    let _e4065 = phi_6641_;
                                    let _e4067 = phi_6642_;
                                    let _e4069 = phi_6643_;
                                    let _e4071 = phi_6644_;
                                    let _e4073 = phi_6645_;
                                    let _e4075 = phi_6646_;
                                    let _e4077 = phi_6647_;
                                    local_22 = _e4067;
                                    local_23 = _e4069;
                                    local_24 = _e4067;
                                    local_25 = _e4071;
                                    local_26 = _e4067;
                                    local_27 = _e4073;
                                    local_28 = _e4067;
                                    local_29 = _e4075;
                                    local_30 = _e4067;
                                    local_31 = _e4077;
                                    local_33 = _e4067;
                                    local_34 = _e4063;
                                    local_35 = _e4061;
                                    continue;
                                    continuing {
                                        phi_4413_ = type_9(select(_e2695.member, (_e2695.member + 1u), _e2710), select(_e2695.member_1, _e2695.member_1, _e2710));
                                        phi_4416_ = _e4049;
                                        phi_4418_ = _e4051;
                                        phi_4420_ = _e4053;
                                        phi_4422_ = _e4055;
                                        phi_4424_ = _e4057;
                                        phi_4426_ = _e4059;
                                        break if !(_e4065);
                                    }
                                }
                                let _e4080 = local_22;
                                let _e4082 = local_23;
                                let _e4083 = select(_e4082, false, _e4080);
                                let _e4085 = local_24;
                                let _e4087 = local_25;
                                let _e4090 = local_26;
                                let _e4092 = local_27;
                                let _e4095 = local_28;
                                let _e4097 = local_29;
                                let _e4100 = local_30;
                                let _e4102 = local_31;
                                let _e4108 = local_32;
                                let _e4110 = select(select(_e4087, false, _e4085), false, _e4083);
                                let _e4113 = local_33;
                                let _e4120 = select(select(select(_e4092, false, _e4090), false, _e4083), false, _e4110);
                                let _e4126 = local_34;
                                let _e4128 = local_35;
                                let _e4130 = select(select(select(_e4113, false, _e4083), false, _e4110), true, _e4120);
                                let _e4135 = local_36;
                                let _e4137 = select(select(select(select(select(_e4097, false, _e4095), false, _e4083), false, _e4110), false, _e4120), true, _e4130);
                                let _e4144 = select(select(select(select(select(select(_e4102, false, _e4100), false, _e4083), false, _e4110), false, _e4120), false, _e4130), false, _e4137);
                                let _e4149 = select(select(select(select(select(_e4083, true, _e4110), false, _e4120), false, _e4130), false, _e4137), true, _e4144);
                                let _e4152 = (select(select(type_42().member, 1u, _e4137), select(select(select(type_42().member, 1u, _e4083), 0u, _e4110), 0u, _e4144), _e4149) != 0u);
                                phi_6715_ = select(select(type_42().member_1, select(_e4135, select(_e4128, _e4126, _e4120), _e4130), _e4137), select(select(select(type_42().member_1, _e4108, _e4083), type_42().member_1, _e4110), type_42().member_1, _e4144), _e4149);
                                phi_6716_ = select(true, false, _e4152);
                                phi_6717_ = _e4152;
                                phi_6718_ = false;
                                phi_6719_ = false;
                                phi_6720_ = false;
                            } else {
                                phi_6715_ = f64();
                                phi_6716_ = _e2472;
                                phi_6717_ = false;
                                phi_6718_ = _e2474;
                                phi_6719_ = _e2476;
                                phi_6720_ = _e2478;
                            }
                            let _e4155 = phi_6715_;
                            let _e4157 = phi_6716_;
                            let _e4159 = phi_6717_;
                            let _e4161 = phi_6718_;
                            let _e4163 = phi_6719_;
                            let _e4165 = phi_6720_;
                            phi_6721_ = _e2464;
                            phi_6722_ = _e2466;
                            phi_6723_ = _e4155;
                            phi_6724_ = _e2468;
                            phi_6725_ = _e4157;
                            phi_6726_ = _e4159;
                            phi_6727_ = false;
                            phi_6728_ = _e4161;
                            phi_6729_ = _e4163;
                            phi_6730_ = _e4165;
                        } else {
                            phi_6721_ = type_43();
                            phi_6722_ = bool();
                            phi_6723_ = f64();
                            phi_6724_ = type_43();
                            phi_6725_ = false;
                            phi_6726_ = false;
                            phi_6727_ = true;
                            phi_6728_ = false;
                            phi_6729_ = false;
                            phi_6730_ = false;
                        }
                        let _e4167 = phi_6721_;
                        let _e4169 = phi_6722_;
                        let _e4171 = phi_6723_;
                        let _e4173 = phi_6724_;
                        let _e4175 = phi_6725_;
                        let _e4177 = phi_6726_;
                        let _e4179 = phi_6727_;
                        let _e4181 = phi_6728_;
                        let _e4183 = phi_6729_;
                        let _e4185 = phi_6730_;
                        local_37 = _e4177;
                        local_38 = _e4169;
                        local_39 = _e4167;
                        local_40 = _e4171;
                        local_41 = _e4171;
                        local_42 = _e4171;
                        local_46 = _e4179;
                        local_47 = _e4181;
                        local_48 = _e4183;
                        local_49 = _e4185;
                        local_43 = _e4177;
                        local_44 = _e4173;
                        continue;
                        continuing {
                            phi_2513_ = type_9(select(_e1447.member, (_e1447.member + 1u), _e1450), select(_e1447.member_1, _e1447.member_1, _e1450));
                            break if !(_e4175);
                        }
                    }
                    let _e4188 = local_37;
                    if _e4188 {
                        let _e4190 = local_38;
                        if _e4190 {
                            let _e4192 = local_39;
                            let _e4195 = local_40;
                            let _e4197 = ((_e4192.member_1 - _e4195) <= _e1410);
                            let _e4202 = local_41;
                            phi_6746_ = type_42(select(type_42().member, 1u, _e4197), select(type_42().member_1, _e4202, _e4197));
                            phi_6747_ = select(true, false, _e4197);
                        } else {
                            phi_6746_ = type_42();
                            phi_6747_ = true;
                        }
                        let _e4207 = phi_6746_;
                        let _e4209 = phi_6747_;
                        let _e4214 = local_42;
                        phi_6753_ = type_42(select(_e4207.member, 2u, _e4209), select(_e4207.member_1, _e4214, _e4209));
                        phi_6754_ = false;
                        phi_6755_ = false;
                        phi_6756_ = false;
                        phi_6757_ = false;
                    } else {
                        phi_6753_ = type_42();
                        let _e4702 = local_46;
                        phi_6754_ = _e4702;
                        let _e4705 = local_47;
                        phi_6755_ = _e4705;
                        let _e4708 = local_48;
                        phi_6756_ = _e4708;
                        let _e4711 = local_49;
                        phi_6757_ = _e4711;
                    }
                    let _e4218 = phi_6753_;
                    let _e4220 = phi_6754_;
                    let _e4222 = phi_6755_;
                    let _e4224 = phi_6756_;
                    let _e4226 = phi_6757_;
                    let _e4233 = select(_e4222, false, _e4220);
                    let _e4237 = local_43;
                    let _e4244 = select(select(_e4224, false, _e4220), false, _e4233);
                    let _e4250 = select(select(select(_e4226, false, _e4220), false, _e4233), false, _e4244);
                    let _e4254 = local_44;
                    let _e4258 = select(select(_e4233, true, _e4244), true, _e4250);
                    phi_6799_ = type_42(select(_e4218.member, select(select(select(type_42().member, 0u, _e4233), 0u, _e4244), 1u, _e4250), _e4258), select(_e4218.member_1, select(select(select(type_42().member_1, type_42().member_1, _e4233), type_42().member_1, _e4244), _e4254.member, _e4250), _e4258));
                    phi_6800_ = type_42(select(type_42().member, 0u, _e4220), select(type_42().member_1, type_42().member_1, _e4220));
                    phi_6801_ = select(select(select(select(select(_e4237, false, _e4220), false, _e4233), false, _e4244), false, _e4250), true, _e4258);
                }
                let _e4269 = phi_6799_;
                let _e4271 = phi_6800_;
                let _e4273 = phi_6801_;
                let _e4276 = select(_e4271.member, _e4269.member, _e4273);
                let _e4279 = select(_e4271.member_1, _e4269.member_1, _e4273);
                let _e4285 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e4279 > _e535)), (_e4276 == 1u))));
                switch bitcast<i32>(_e4276) {
                    case 0: {
                        phi_6845_ = type_35(0u, _e4285, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4289 = function_2(_e4279);
                        phi_6845_ = type_35(0u, _e4285, _e4289, true);
                        break;
                    }
                    case 2: {
                        let _e4287 = function_2(_e4279);
                        phi_6845_ = type_35(1u, _e4285, _e4287, true);
                        break;
                    }
                    default: {
                        phi_6845_ = type_35();
                        break;
                    }
                }
                let _e4293 = phi_6845_;
                local_8 = type_35(_e4293.member, _e4293.member_1, array<u32, 2>(_e4293.member_2[0], _e4293.member_2[1]), _e4293.member_3);
                phi_6854_ = type_9(_e190, _e193);
            } else {
                phi_6854_ = type_9(0u, 0u);
            }
            let _e4303 = phi_6854_;
            let _e4309 = local_8.member;
            let _e4311 = select(true, false, (_e4309 == 0u));
            let _e4313 = local_8.member_3;
            if _e4313 {
                if _e4311 {
                    phi_6883_ = true;
                } else {
                    let _e4315 = params.member.member.member_1;
                    phi_6883_ = ((_e4315 & 16u) != 0u);
                }
                let _e4319 = phi_6883_;
                phi_6884_ = _e4319;
            } else {
                phi_6884_ = false;
            }
            let _e4321 = phi_6884_;
            let _e4323 = local_8.member_3;
            if _e4323 {
                if _e4311 {
                } else {
                    let _e4325 = local_8.member_2;
                    let _e4329 = (_e4325[1] >> bitcast<u32>(20i));
                    let _e4343 = atomicMin((&earliest.member[0u]), select(((((_e4329 - 896u) << bitcast<u32>(23i)) | ((_e4325[1] & 1048575u) << bitcast<u32>(3i))) | (_e4325[0] >> bitcast<u32>(29i))), 0u, (_e4329 <= 896u)));
                }
            }
            if (_e108 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4321 {
                let _e4347 = atomicAdd((&counters[0u]), 1u);
                phi_6927_ = _e4347;
            } else {
                phi_6927_ = 0u;
            }
            let _e4349 = phi_6927_;
            workgroupBarrier();
            if (_e108 == 0u) {
                let _e4352 = atomicLoad((&counters[0u]));
                if (_e4352 > 0u) {
                    let _e4355 = atomicAdd((&contacts.member[0u]), _e4352);
                    atomicStore((&counters[1u]), _e4355);
                }
            }
            workgroupBarrier();
            let _e4358 = atomicLoad((&counters[1u]));
            let _e4359 = (_e4358 + _e4349);
            if _e4321 {
                let _e4361 = params.member.member_1.member_3;
                if (_e4359 < _e4361) {
                    let _e4367 = (7u * _e4359);
                    atomicStore((&contacts.member[(4u + _e4367)]), select(1u, 0u, ((_e4303.member_1 & 2147483648u) == 0u)));
                    let _e4372 = local_8.member;
                    atomicStore((&contacts.member[(_e4367 + 5u)]), _e4372);
                    atomicStore((&contacts.member[(_e4367 + 6u)]), _e4303.member);
                    atomicStore((&contacts.member[(_e4367 + 7u)]), (_e4303.member_1 & 2147483647u));
                    let _e4381 = local_8.member_2[0u];
                    atomicStore((&contacts.member[(_e4367 + 8u)]), _e4381);
                    let _e4386 = local_8.member_2[1u];
                    atomicStore((&contacts.member[(_e4367 + 9u)]), _e4386);
                    let _e4390 = local_8.member_1;
                    atomicStore((&contacts.member[(_e4367 + 10u)]), _e4390);
                }
            }
        }
        continue;
        continuing {
            phi_554_ = type_9(select(_e161.member, (_e161.member + 1u), _e164), select(_e161.member_1, _e161.member_1, _e164));
            break if !(_e177);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn advance_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
