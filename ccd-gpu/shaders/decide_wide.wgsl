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
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_37 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_38 {
    member: f64,
    member_1: f64,
}

struct type_41 {
    member: array<f64, 4>,
    member_1: f64,
    member_2: f64,
    member_3: f64,
}

struct type_43 {
    member: type_33,
    member_1: f64,
}

struct type_44 {
    member: u32,
    member_1: f64,
}

struct type_45 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_49 {
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
var<storage> paths: type_26;
@group(0) @binding(3) 
var<storage> elements: type_13;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_49;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_49;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_240_: f64;
    var phi_283_: f64;
    var phi_326_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_240_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_240_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_240_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_283_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_283_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_283_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_326_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_326_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_326_;
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
    var phi_7628_: array<array<f64, 3>, 4>;

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
        phi_7628_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e171)), (param_4[1] - (param_5[1] * _e171)), (param_4[2] - (param_5[2] * _e171))), array<f64, 3>((param_4[0] - (param_6[0] * _e215)), (param_4[1] - (param_6[1] * _e215)), (param_4[2] - (param_6[2] * _e215))), array<f64, 3>((_e9 - (param_6[0] * _e256)), (_e12 - (param_6[1] * _e256)), (_e15 - (param_6[2] * _e256))), array<f64, 3>((_e269 - (param_5[0] * _e303)), (_e272 - (param_5[1] * _e303)), (_e275 - (param_5[2] * _e303))));
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
        phi_7628_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e82)), (param_4[1] - (param_5[1] * _e82)), (param_4[2] - (param_5[2] * _e82))), array<f64, 3>((param_4[0] - (param_6[0] * _e126)), (param_4[1] - (param_6[1] * _e126)), (param_4[2] - (param_6[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_7628_;
    let _e319 = function_2(_e316[0], _e316[1]);
    let _e321 = function_2(_e319, _e316[2]);
    let _e323 = function_2(_e321, _e316[3]);
    return _e323;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_7227_: bool;
    var phi_7261_: array<f64, 3>;
    var phi_7262_: bool;
    var phi_7263_: array<f64, 3>;
    var phi_7264_: bool;
    var phi_7269_: array<f64, 3>;

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
        phi_7227_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_7227_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_7227_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_7261_ = array<f64, 3>((param_8[0] - ((param_9[0] * _e76) + (param_10[0] * _e80))), (param_8[1] - ((param_9[1] * _e76) + (param_10[1] * _e80))), (param_8[2] - ((param_9[2] * _e76) + (param_10[2] * _e80))));
            phi_7262_ = false;
        } else {
            phi_7261_ = array<f64, 3>();
            phi_7262_ = true;
        }
        let _e132 = phi_7261_;
        let _e134 = phi_7262_;
        phi_7263_ = _e132;
        phi_7264_ = _e134;
    } else {
        phi_7263_ = array<f64, 3>();
        phi_7264_ = true;
    }
    let _e136 = phi_7263_;
    let _e138 = phi_7264_;
    if _e138 {
        let _e139 = function_3(param_8, param_9, param_10, param_11);
        phi_7269_ = _e139;
    } else {
        phi_7269_ = _e136;
    }
    let _e141 = phi_7269_;
    return _e141;
}

fn function_5(param_12: ptr<function, type_41>, param_13: f64, param_14: f64, param_15: f64) -> bool {
    var phi_7102_: bool;
    var phi_7103_: bool;
    var phi_7108_: bool;

    let _e15 = (*param_12).member_3;
    let _e17 = (*param_12).member_3;
    let _e19 = (param_13 + (_e15 + _e17));
    if (_e19 < param_15) {
        let _e22 = (f64(1f) - param_14);
        let _e25 = (*param_12).member[0u];
        let _e28 = (*param_12).member[1u];
        let _e31 = (*param_12).member[2u];
        let _e34 = (*param_12).member[3u];
        let _e45 = ((((_e25 * _e22) + (_e28 * param_14)) * (_e22 * _e22)) + (((_e31 * _e22) + (_e34 * param_14)) * (param_14 * param_14)));
        let _e47 = select(param_14, _e19, (_e19 > param_14));
        let _e49 = (f64(1f) - _e47);
        let _e52 = (*param_12).member[0u];
        let _e55 = (*param_12).member[1u];
        let _e58 = (*param_12).member[2u];
        let _e61 = (*param_12).member[3u];
        let _e72 = ((((_e52 * _e49) + (_e55 * _e47)) * (_e49 * _e49)) + (((_e58 * _e49) + (_e61 * _e47)) * (_e47 * _e47)));
        let _e74 = (*param_12).member_1;
        let _e76 = (*param_12).member_1;
        let _e82 = (*param_12).member_1;
        if (select(_e45, -(_e45), (_e45 < 0.0lf)) > _e82) {
            let _e87 = (select(_e72, -(_e72), (_e72 < 0.0lf)) > (_e74 + _e76));
            phi_7102_ = select(bool(), ((_e45 > f64(0f)) == (_e72 > f64(0f))), _e87);
            phi_7103_ = select(true, false, _e87);
        } else {
            phi_7102_ = bool();
            phi_7103_ = true;
        }
        let _e96 = phi_7102_;
        let _e98 = phi_7103_;
        phi_7108_ = select(_e96, false, _e98);
    } else {
        phi_7108_ = false;
    }
    let _e101 = phi_7108_;
    return _e101;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_36;
    var local_1: type_36;
    var local_2: type_37;
    var local_3: type_37;
    var local_4: type_37;
    var local_5: array<type_38, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: type_41;
    var local_9: array<f64, 4>;
    var local_10: type_33;
    var phi_389_: u32;
    var phi_434_: u32;
    var phi_437_: type_9;
    var phi_599_: type_23;
    var phi_795_: type_31;
    var phi_956_: type_33;
    var phi_1229_: bool;
    var phi_1325_: type_43;
    var phi_1326_: bool;
    var phi_1327_: type_43;
    var phi_1328_: bool;
    var phi_1329_: type_43;
    var phi_1330_: bool;
    var phi_1335_: type_43;
    var phi_2075_: bool;
    var phi_2090_: f64;
    var phi_2166_: type_18;
    var phi_2169_: f64;
    var phi_2167_: type_18;
    var phi_2210_: type_19;
    var phi_2170_: f64;
    var local_11: f64;
    var phi_2223_: f64;
    var phi_2254_: type_9;
    var phi_2257_: u32;
    var phi_2324_: u32;
    var phi_2325_: u32;
    var phi_2258_: u32;
    var phi_2326_: u32;
    var phi_2384_: type_9;
    var phi_2544_: type_45;
    var phi_2545_: bool;
    var phi_2546_: type_45;
    var phi_2547_: bool;
    var phi_2582_: type_9;
    var phi_2585_: f64;
    var phi_2587_: f64;
    var phi_2589_: f64;
    var phi_2703_: bool;
    var phi_2710_: f64;
    var phi_2711_: bool;
    var phi_2586_: f64;
    var phi_2588_: f64;
    var phi_2590_: f64;
    var phi_2712_: f64;
    var phi_2713_: bool;
    var phi_2714_: bool;
    var local_12: bool;
    var local_13: f64;
    var local_14: f64;
    var phi_2719_: f64;
    var phi_2737_: type_9;
    var phi_2740_: f64;
    var phi_2806_: f64;
    var phi_2807_: bool;
    var phi_2808_: bool;
    var phi_2809_: bool;
    var phi_2810_: f64;
    var phi_2741_: f64;
    var phi_2811_: bool;
    var phi_2812_: bool;
    var phi_2813_: bool;
    var phi_2814_: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: f64;
    var phi_2828_: f64;
    var phi_2830_: type_45;
    var phi_3563_: u32;
    var phi_3564_: u32;
    var phi_3841_: array<type_38, 4>;
    var phi_3861_: type_9;
    var phi_3864_: bool;
    var phi_3865_: bool;
    var phi_3916_: bool;
    var phi_3917_: bool;
    var local_20: bool;
    var local_21: bool;
    var phi_3931_: u32;
    var phi_3932_: u32;
    var phi_3933_: bool;
    var phi_3964_: bool;
    var phi_3965_: bool;
    var phi_3966_: bool;
    var phi_3967_: bool;
    var phi_3968_: bool;
    var phi_3969_: bool;
    var phi_3970_: bool;
    var phi_3971_: bool;
    var phi_3972_: bool;
    var phi_3973_: bool;
    var phi_3974_: bool;
    var phi_3975_: bool;
    var phi_3976_: type_45;
    var phi_3977_: bool;
    var phi_3978_: type_45;
    var phi_3979_: bool;
    var phi_3980_: bool;
    var phi_3981_: bool;
    var phi_3982_: bool;
    var phi_3983_: type_45;
    var phi_3984_: bool;
    var phi_3985_: type_45;
    var phi_3986_: bool;
    var phi_3987_: bool;
    var phi_3988_: bool;
    var phi_3989_: bool;
    var phi_3990_: bool;
    var phi_3998_: type_45;
    var phi_3999_: bool;
    var phi_4000_: type_45;
    var phi_4001_: bool;
    var phi_4002_: bool;
    var phi_4003_: bool;
    var phi_4004_: bool;
    var phi_4005_: bool;
    var phi_4434_: type_9;
    var phi_4437_: f64;
    var phi_4439_: f64;
    var phi_4441_: f64;
    var phi_4443_: f64;
    var phi_4445_: bool;
    var phi_4447_: u32;
    var phi_4599_: array<f64, 3>;
    var phi_4667_: type_18;
    var phi_4670_: f64;
    var phi_4668_: type_18;
    var phi_4711_: type_19;
    var phi_4671_: f64;
    var local_22: f64;
    var phi_4724_: f64;
    var phi_4850_: type_36;
    var phi_4851_: bool;
    var phi_4852_: type_36;
    var phi_4853_: bool;
    var phi_4863_: type_36;
    var phi_5035_: bool;
    var phi_5036_: bool;
    var phi_5037_: bool;
    var phi_5038_: bool;
    var phi_5039_: bool;
    var phi_5040_: bool;
    var phi_5342_: bool;
    var phi_5343_: bool;
    var phi_5344_: bool;
    var phi_5345_: bool;
    var phi_5346_: bool;
    var phi_5347_: bool;
    var phi_5355_: bool;
    var phi_5465_: f64;
    var phi_5466_: bool;
    var phi_5467_: f64;
    var phi_5468_: bool;
    var phi_5469_: f64;
    var phi_5470_: bool;
    var phi_5471_: bool;
    var phi_5537_: f64;
    var phi_5538_: bool;
    var phi_5539_: f64;
    var phi_5540_: bool;
    var phi_5541_: f64;
    var phi_5542_: bool;
    var phi_5543_: bool;
    var phi_5614_: f64;
    var phi_5615_: bool;
    var phi_5616_: f64;
    var phi_5617_: bool;
    var phi_5618_: f64;
    var phi_5619_: bool;
    var phi_5620_: bool;
    var phi_5686_: f64;
    var phi_5687_: bool;
    var phi_5688_: f64;
    var phi_5689_: bool;
    var phi_5690_: f64;
    var phi_5691_: bool;
    var phi_5692_: bool;
    var phi_5869_: type_18;
    var phi_5872_: f64;
    var phi_5870_: type_18;
    var phi_5913_: type_19;
    var phi_5873_: f64;
    var local_23: f64;
    var phi_5926_: f64;
    var phi_6203_: bool;
    var phi_6204_: bool;
    var phi_6231_: f64;
    var phi_6232_: f64;
    var phi_6233_: bool;
    var phi_6234_: f64;
    var phi_6235_: f64;
    var phi_6236_: bool;
    var phi_6237_: bool;
    var phi_6238_: f64;
    var phi_6239_: f64;
    var phi_6240_: f64;
    var phi_6241_: f64;
    var phi_6242_: bool;
    var phi_6243_: bool;
    var phi_6244_: bool;
    var phi_6245_: bool;
    var phi_6246_: f64;
    var phi_6247_: f64;
    var phi_6248_: f64;
    var phi_6249_: f64;
    var phi_6250_: bool;
    var phi_6251_: bool;
    var phi_6252_: bool;
    var phi_6253_: bool;
    var phi_6254_: bool;
    var phi_6255_: f64;
    var phi_6256_: f64;
    var phi_6257_: f64;
    var phi_6258_: f64;
    var phi_6259_: bool;
    var phi_6260_: bool;
    var phi_6261_: bool;
    var phi_6262_: bool;
    var phi_6263_: bool;
    var phi_6601_: f64;
    var phi_6603_: u32;
    var phi_6604_: f64;
    var phi_6605_: bool;
    var phi_6606_: bool;
    var phi_6607_: bool;
    var phi_6608_: u32;
    var phi_6609_: f64;
    var phi_6610_: f64;
    var phi_6611_: f64;
    var phi_6612_: f64;
    var phi_6613_: bool;
    var phi_6614_: u32;
    var phi_6615_: bool;
    var phi_6616_: bool;
    var phi_6617_: bool;
    var phi_6618_: bool;
    var phi_6619_: bool;
    var phi_6620_: bool;
    var phi_6648_: f64;
    var phi_6649_: f64;
    var phi_6650_: f64;
    var phi_6651_: f64;
    var phi_6652_: bool;
    var phi_6653_: u32;
    var phi_6654_: bool;
    var phi_6655_: bool;
    var phi_6656_: bool;
    var phi_6657_: bool;
    var phi_6658_: bool;
    var phi_6659_: bool;
    var phi_4438_: f64;
    var phi_4440_: f64;
    var phi_4442_: f64;
    var phi_4444_: f64;
    var phi_4446_: bool;
    var phi_4448_: u32;
    var phi_6660_: f64;
    var phi_6661_: f64;
    var phi_6662_: bool;
    var phi_6663_: bool;
    var phi_6664_: bool;
    var phi_6665_: bool;
    var phi_6666_: bool;
    var phi_6667_: bool;
    var phi_6668_: bool;
    var local_24: bool;
    var local_25: bool;
    var local_26: bool;
    var local_27: bool;
    var local_28: bool;
    var local_29: bool;
    var local_30: bool;
    var local_31: bool;
    var local_32: bool;
    var local_33: bool;
    var local_34: f64;
    var local_35: bool;
    var local_36: f64;
    var local_37: f64;
    var local_38: f64;
    var phi_6736_: f64;
    var phi_6737_: bool;
    var phi_6738_: bool;
    var phi_6739_: bool;
    var phi_6740_: bool;
    var phi_6741_: bool;
    var phi_6742_: type_45;
    var phi_6743_: bool;
    var phi_6744_: f64;
    var phi_6745_: type_45;
    var phi_6746_: bool;
    var phi_6747_: bool;
    var phi_6748_: bool;
    var phi_6749_: bool;
    var phi_6750_: bool;
    var phi_6751_: bool;
    var local_39: bool;
    var local_40: bool;
    var local_41: type_45;
    var local_42: f64;
    var local_43: f64;
    var phi_6767_: type_44;
    var phi_6768_: bool;
    var local_44: f64;
    var phi_6774_: type_44;
    var phi_6775_: bool;
    var phi_6776_: bool;
    var phi_6777_: bool;
    var phi_6778_: bool;
    var local_45: bool;
    var local_46: type_45;
    var phi_6820_: type_44;
    var phi_6821_: type_44;
    var phi_6822_: bool;
    var phi_6866_: type_35;
    var phi_6906_: u32;
    var phi_6910_: type_20;
    var phi_6911_: bool;
    var phi_6922_: u32;
    var phi_6982_: bool;
    var phi_6983_: bool;
    var local_47: u32;
    var local_48: bool;
    var local_49: bool;
    var local_50: bool;
    var local_51: bool;
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
        phi_389_ = (_e128 - _e133);
    } else {
        phi_389_ = 0u;
    }
    let _e136 = phi_389_;
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
        phi_434_ = select(_e149, (_e149 + 1u), ((_e147 % _e121) > 0u));
    } else {
        phi_434_ = 0u;
    }
    let _e156 = phi_434_;
    phi_437_ = type_9(0u, _e156);
    loop {
        let _e159 = phi_437_;
        let _e162 = (_e159.member < _e159.member_1);
        let _e175 = (bitcast<i32>(select(0u, 1u, _e162)) != 0i);
        if _e175 {
            let _e179 = (((_e118 + (select(type_9().member_1, _e159.member, _e162) * _e121)) * 64u) + _e106);
            let _e182 = params.member.member_2.member;
            let _e185 = params.member.member.member_1;
            let _e187 = ((_e185 & 16u) != 0u);
            if (_e179 < _e140) {
                let _e192 = params.member.member_1.member_1;
                let _e194 = (2u * (_e192 + _e179));
                let _e197 = input.member[(4u + _e194)];
                let _e200 = input.member[(_e194 + 5u)];
                if (_e182 == 0u) {
                    let _e217 = (3u * _e200);
                    let _e219 = elements.member[_e217];
                    let _e222 = elements.member[(_e217 + 1u)];
                    let _e225 = elements.member[(_e217 + 2u)];
                    phi_599_ = type_23(0u, array<u32, 4>(_e197, _e219, _e222, _e225));
                } else {
                    let _e203 = (2u * _e197);
                    let _e204 = (2u * _e200);
                    let _e206 = elements.member[_e203];
                    let _e208 = elements.member[_e204];
                    let _e211 = elements.member[(_e203 + 1u)];
                    let _e214 = elements.member[(_e204 + 1u)];
                    phi_599_ = type_23(1u, array<u32, 4>(_e206, _e211, _e208, _e214));
                }
                let _e229 = phi_599_;
                let _e233 = params.member.member.member_1;
                if ((_e233 & 8u) != 0u) {
                    let _e277 = paths.member[_e229.member_1[0]];
                    let _e292 = paths.member[_e229.member_1[1]];
                    let _e307 = paths.member[_e229.member_1[2]];
                    let _e322 = paths.member[_e229.member_1[3]];
                    let _e343 = function_(array<f32, 3>(_e277.member.x, _e277.member.y, _e277.member.z));
                    let _e344 = function_(array<f32, 3>(_e292.member.x, _e292.member.y, _e292.member.z));
                    let _e345 = function_(array<f32, 3>(_e307.member.x, _e307.member.y, _e307.member.z));
                    let _e346 = function_(array<f32, 3>(_e322.member.x, _e322.member.y, _e322.member.z));
                    let _e348 = function_(array<f32, 3>(_e277.member_1.x, _e277.member_1.y, _e277.member_1.z));
                    let _e349 = function_(array<f32, 3>(_e292.member_1.x, _e292.member_1.y, _e292.member_1.z));
                    let _e350 = function_(array<f32, 3>(_e307.member_1.x, _e307.member_1.y, _e307.member_1.z));
                    let _e351 = function_(array<f32, 3>(_e322.member_1.x, _e322.member_1.y, _e322.member_1.z));
                    phi_795_ = type_31(array<array<f64, 3>, 4>(_e343, _e344, _e345, _e346), array<array<f64, 3>, 4>(_e348, _e349, _e350, _e351));
                } else {
                    let _e238 = positions.member[_e229.member_1[0]];
                    let _e241 = params.member.member.member[0u];
                    let _e244 = positions.member[(_e241 + _e229.member_1[0])];
                    let _e247 = positions.member[_e229.member_1[1]];
                    let _e250 = params.member.member.member[0u];
                    let _e253 = positions.member[(_e250 + _e229.member_1[1])];
                    let _e256 = positions.member[_e229.member_1[2]];
                    let _e259 = params.member.member.member[0u];
                    let _e262 = positions.member[(_e259 + _e229.member_1[2])];
                    let _e265 = positions.member[_e229.member_1[3]];
                    let _e268 = params.member.member.member[0u];
                    let _e271 = positions.member[(_e268 + _e229.member_1[3])];
                    phi_795_ = type_31(array<array<f64, 3>, 4>(_e238, _e247, _e256, _e265), array<array<f64, 3>, 4>(_e244, _e253, _e262, _e271));
                }
                let _e355 = phi_795_;
                if (_e229.member != 0u) {
                    phi_956_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e355.member[2][0] - _e355.member[0][0]), (_e355.member[2][1] - _e355.member[0][1]), (_e355.member[2][2] - _e355.member[0][2])), array<f64, 3>((_e355.member_1[2][0] - _e355.member_1[0][0]), (_e355.member_1[2][1] - _e355.member_1[0][1]), (_e355.member_1[2][2] - _e355.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e355.member[1][0] - _e355.member[0][0]), (_e355.member[1][1] - _e355.member[0][1]), (_e355.member[1][2] - _e355.member[0][2])), array<f64, 3>((_e355.member_1[1][0] - _e355.member_1[0][0]), (_e355.member_1[1][1] - _e355.member_1[0][1]), (_e355.member_1[1][2] - _e355.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e355.member[2][0] - _e355.member[3][0]), (_e355.member[2][1] - _e355.member[3][1]), (_e355.member[2][2] - _e355.member[3][2])), array<f64, 3>((_e355.member_1[2][0] - _e355.member_1[3][0]), (_e355.member_1[2][1] - _e355.member_1[3][1]), (_e355.member_1[2][2] - _e355.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_956_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e355.member[0][0] - _e355.member[1][0]), (_e355.member[0][1] - _e355.member[1][1]), (_e355.member[0][2] - _e355.member[1][2])), array<f64, 3>((_e355.member_1[0][0] - _e355.member_1[1][0]), (_e355.member_1[0][1] - _e355.member_1[1][1]), (_e355.member_1[0][2] - _e355.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e355.member[2][0] - _e355.member[1][0]), (_e355.member[2][1] - _e355.member[1][1]), (_e355.member[2][2] - _e355.member[1][2])), array<f64, 3>((_e355.member_1[2][0] - _e355.member_1[1][0]), (_e355.member_1[2][1] - _e355.member_1[1][1]), (_e355.member_1[2][2] - _e355.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e355.member[3][0] - _e355.member[1][0]), (_e355.member[3][1] - _e355.member[1][1]), (_e355.member[3][2] - _e355.member[1][2])), array<f64, 3>((_e355.member_1[3][0] - _e355.member_1[1][0]), (_e355.member_1[3][1] - _e355.member_1[1][1]), (_e355.member_1[3][2] - _e355.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e514 = phi_956_;
                let _e516 = params.member.member.member_14;
                let _e523 = bitcast<f64>(((u64(_e516[1]) * 4294967296lu) + u64(_e516[0])));
                let _e525 = params.member.member.member_15;
                let _e532 = bitcast<f64>(((u64(_e525[1]) * 4294967296lu) + u64(_e525[0])));
                let _e534 = params.member.member.member_16;
                let _e541 = bitcast<f64>(((u64(_e534[1]) * 4294967296lu) + u64(_e534[0])));
                let _e543 = params.member.member.member_16;
                let _e550 = bitcast<f64>(((u64(_e543[1]) * 4294967296lu) + u64(_e543[0])));
                let _e551 = f64(0f);
                let _e557 = select(_e514.member[0][0], -(_e514.member[0][0]), (_e514.member[0][0] < 0.0lf));
                let _e561 = select(_e514.member[0][1], -(_e514.member[0][1]), (_e514.member[0][1] < 0.0lf));
                let _e563 = select(_e561, _e557, (_e557 > _e561));
                let _e567 = select(_e514.member[0][2], -(_e514.member[0][2]), (_e514.member[0][2] < 0.0lf));
                let _e569 = select(_e567, _e563, (_e563 > _e567));
                let _e575 = select(_e514.member[1][0], -(_e514.member[1][0]), (_e514.member[1][0] < 0.0lf));
                let _e579 = select(_e514.member[1][1], -(_e514.member[1][1]), (_e514.member[1][1] < 0.0lf));
                let _e581 = select(_e579, _e575, (_e575 > _e579));
                let _e585 = select(_e514.member[1][2], -(_e514.member[1][2]), (_e514.member[1][2] < 0.0lf));
                let _e587 = select(_e585, _e581, (_e581 > _e585));
                let _e591 = (select(_e587, _e569, (_e569 > _e587)) + _e514.member_3);
                let _e597 = select(_e514.member_1[0][0], -(_e514.member_1[0][0]), (_e514.member_1[0][0] < 0.0lf));
                let _e601 = select(_e514.member_1[0][1], -(_e514.member_1[0][1]), (_e514.member_1[0][1] < 0.0lf));
                let _e603 = select(_e601, _e597, (_e597 > _e601));
                let _e607 = select(_e514.member_1[0][2], -(_e514.member_1[0][2]), (_e514.member_1[0][2] < 0.0lf));
                let _e609 = select(_e607, _e603, (_e603 > _e607));
                let _e615 = select(_e514.member_1[1][0], -(_e514.member_1[1][0]), (_e514.member_1[1][0] < 0.0lf));
                let _e619 = select(_e514.member_1[1][1], -(_e514.member_1[1][1]), (_e514.member_1[1][1] < 0.0lf));
                let _e621 = select(_e619, _e615, (_e615 > _e619));
                let _e625 = select(_e514.member_1[1][2], -(_e514.member_1[1][2]), (_e514.member_1[1][2] < 0.0lf));
                let _e627 = select(_e625, _e621, (_e621 > _e625));
                let _e631 = (select(_e627, _e609, (_e609 > _e627)) + _e514.member_3);
                let _e637 = select(_e514.member_2[0][0], -(_e514.member_2[0][0]), (_e514.member_2[0][0] < 0.0lf));
                let _e641 = select(_e514.member_2[0][1], -(_e514.member_2[0][1]), (_e514.member_2[0][1] < 0.0lf));
                let _e643 = select(_e641, _e637, (_e637 > _e641));
                let _e647 = select(_e514.member_2[0][2], -(_e514.member_2[0][2]), (_e514.member_2[0][2] < 0.0lf));
                let _e649 = select(_e647, _e643, (_e643 > _e647));
                let _e655 = select(_e514.member_2[1][0], -(_e514.member_2[1][0]), (_e514.member_2[1][0] < 0.0lf));
                let _e659 = select(_e514.member_2[1][1], -(_e514.member_2[1][1]), (_e514.member_2[1][1] < 0.0lf));
                let _e661 = select(_e659, _e655, (_e655 > _e659));
                let _e665 = select(_e514.member_2[1][2], -(_e514.member_2[1][2]), (_e514.member_2[1][2] < 0.0lf));
                let _e667 = select(_e665, _e661, (_e661 > _e665));
                let _e671 = (select(_e667, _e649, (_e649 > _e667)) + _e514.member_3);
                let _e673 = select(_e631, _e591, (_e591 > _e631));
                let _e675 = select(_e671, _e673, (_e673 > _e671));
                if (_e675 <= f64(65536f)) {
                    phi_1229_ = (_e675 >= f64((1f / 65536f)));
                } else {
                    phi_1229_ = false;
                }
                let _e682 = phi_1229_;
                if _e682 {
                    phi_1329_ = type_43();
                    phi_1330_ = true;
                } else {
                    if (_e675 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e675) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e689 = (9214364837600034816lu - (bitcast<u64>(_e675) & 9218868437227405312lu));
                            let _e692 = bitcast<f64>(select(4503599627370496lu, _e689, (_e689 > 4503599627370496lu)));
                            let _e693 = (_e551 * _e692);
                            phi_1325_ = type_43(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e514.member[0][0] * _e692), (_e514.member[0][1] * _e692), (_e514.member[0][2] * _e692)), array<f64, 3>((_e514.member[1][0] * _e692), (_e514.member[1][1] * _e692), (_e514.member[1][2] * _e692))), array<array<f64, 3>, 2>(array<f64, 3>((_e514.member_1[0][0] * _e692), (_e514.member_1[0][1] * _e692), (_e514.member_1[0][2] * _e692)), array<f64, 3>((_e514.member_1[1][0] * _e692), (_e514.member_1[1][1] * _e692), (_e514.member_1[1][2] * _e692))), array<array<f64, 3>, 2>(array<f64, 3>((_e514.member_2[0][0] * _e692), (_e514.member_2[0][1] * _e692), (_e514.member_2[0][2] * _e692)), array<f64, 3>((_e514.member_2[1][0] * _e692), (_e514.member_2[1][1] * _e692), (_e514.member_2[1][2] * _e692))), ((_e514.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e692)), select(_e693, select(2.2250738585072014e-308lf, _e693, (_e693 > 2.2250738585072014e-308lf)), (_e551 > f64(0f))));
                            phi_1326_ = false;
                        } else {
                            phi_1325_ = type_43();
                            phi_1326_ = true;
                        }
                        let _e764 = phi_1325_;
                        let _e766 = phi_1326_;
                        phi_1327_ = _e764;
                        phi_1328_ = _e766;
                    } else {
                        phi_1327_ = type_43();
                        phi_1328_ = true;
                    }
                    let _e768 = phi_1327_;
                    let _e770 = phi_1328_;
                    phi_1329_ = _e768;
                    phi_1330_ = _e770;
                }
                let _e772 = phi_1329_;
                let _e774 = phi_1330_;
                if _e774 {
                    phi_1335_ = type_43(_e514, _e551);
                } else {
                    phi_1335_ = _e772;
                }
                let _e777 = phi_1335_;
                local_10 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e777.member.member[0][0], _e777.member.member[0][1], _e777.member.member[0][2]), array<f64, 3>(_e777.member.member[1][0], _e777.member.member[1][1], _e777.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e777.member.member_1[0][0], _e777.member.member_1[0][1], _e777.member.member_1[0][2]), array<f64, 3>(_e777.member.member_1[1][0], _e777.member.member_1[1][1], _e777.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e777.member.member_2[0][0], _e777.member.member_2[0][1], _e777.member.member_2[0][2]), array<f64, 3>(_e777.member.member_2[1][0], _e777.member.member_2[1][1], _e777.member.member_2[1][2])), _e777.member.member_3);
                let _e817 = f64(0f);
                let _e820 = local_10.member_1[0u];
                let _e826 = local_10.member_2[0u];
                let _e832 = ((_e820[1] * _e826[2]) - (_e820[2] * _e826[1]));
                let _e835 = ((_e820[2] * _e826[0]) - (_e820[0] * _e826[2]));
                let _e838 = ((_e820[0] * _e826[1]) - (_e820[1] * _e826[0]));
                let _e841 = local_10.member_1[1u];
                let _e847 = local_10.member_2[1u];
                let _e853 = ((_e841[1] * _e847[2]) - (_e841[2] * _e847[1]));
                let _e856 = ((_e841[2] * _e847[0]) - (_e841[0] * _e847[2]));
                let _e859 = ((_e841[0] * _e847[1]) - (_e841[1] * _e847[0]));
                let _e862 = local_10.member_1[0u];
                let _e868 = local_10.member_2[1u];
                let _e883 = local_10.member_1[1u];
                let _e889 = local_10.member_2[0u];
                let _e902 = (((_e862[1] * _e868[2]) - (_e862[2] * _e868[1])) + ((_e883[1] * _e889[2]) - (_e883[2] * _e889[1])));
                let _e903 = (((_e862[2] * _e868[0]) - (_e862[0] * _e868[2])) + ((_e883[2] * _e889[0]) - (_e883[0] * _e889[2])));
                let _e904 = (((_e862[0] * _e868[1]) - (_e862[1] * _e868[0])) + ((_e883[0] * _e889[1]) - (_e883[1] * _e889[0])));
                let _e907 = local_10.member[0u];
                let _e915 = (((_e907[0] * _e832) + (_e907[1] * _e835)) + (_e907[2] * _e838));
                let _e918 = local_10.member[1u];
                let _e929 = local_10.member[0u];
                let _e938 = ((((_e918[0] * _e832) + (_e918[1] * _e835)) + (_e918[2] * _e838)) + (((_e929[0] * _e902) + (_e929[1] * _e903)) + (_e929[2] * _e904)));
                let _e941 = local_10.member[0u];
                let _e952 = local_10.member[1u];
                let _e961 = ((((_e941[0] * _e853) + (_e941[1] * _e856)) + (_e941[2] * _e859)) + (((_e952[0] * _e902) + (_e952[1] * _e903)) + (_e952[2] * _e904)));
                let _e964 = local_10.member[1u];
                let _e972 = (((_e964[0] * _e853) + (_e964[1] * _e856)) + (_e964[2] * _e859));
                let _e975 = local_10.member[0u];
                let _e981 = select(_e975[0], -(_e975[0]), (_e975[0] < 0.0lf));
                let _e984 = select(_e975[1], -(_e975[1]), (_e975[1] < 0.0lf));
                let _e986 = select(_e984, _e981, (_e981 > _e984));
                let _e989 = select(_e975[2], -(_e975[2]), (_e975[2] < 0.0lf));
                let _e991 = select(_e989, _e986, (_e986 > _e989));
                let _e994 = local_10.member[1u];
                let _e1000 = select(_e994[0], -(_e994[0]), (_e994[0] < 0.0lf));
                let _e1003 = select(_e994[1], -(_e994[1]), (_e994[1] < 0.0lf));
                let _e1005 = select(_e1003, _e1000, (_e1000 > _e1003));
                let _e1008 = select(_e994[2], -(_e994[2]), (_e994[2] < 0.0lf));
                let _e1010 = select(_e1008, _e1005, (_e1005 > _e1008));
                let _e1014 = local_10.member_3;
                let _e1015 = (select(_e1010, _e991, (_e991 > _e1010)) + _e1014);
                let _e1018 = local_10.member_1[0u];
                let _e1024 = select(_e1018[0], -(_e1018[0]), (_e1018[0] < 0.0lf));
                let _e1027 = select(_e1018[1], -(_e1018[1]), (_e1018[1] < 0.0lf));
                let _e1029 = select(_e1027, _e1024, (_e1024 > _e1027));
                let _e1032 = select(_e1018[2], -(_e1018[2]), (_e1018[2] < 0.0lf));
                let _e1034 = select(_e1032, _e1029, (_e1029 > _e1032));
                let _e1037 = local_10.member_1[1u];
                let _e1043 = select(_e1037[0], -(_e1037[0]), (_e1037[0] < 0.0lf));
                let _e1046 = select(_e1037[1], -(_e1037[1]), (_e1037[1] < 0.0lf));
                let _e1048 = select(_e1046, _e1043, (_e1043 > _e1046));
                let _e1051 = select(_e1037[2], -(_e1037[2]), (_e1037[2] < 0.0lf));
                let _e1053 = select(_e1051, _e1048, (_e1048 > _e1051));
                let _e1057 = local_10.member_3;
                let _e1058 = (select(_e1053, _e1034, (_e1034 > _e1053)) + _e1057);
                let _e1061 = local_10.member_2[0u];
                let _e1067 = select(_e1061[0], -(_e1061[0]), (_e1061[0] < 0.0lf));
                let _e1070 = select(_e1061[1], -(_e1061[1]), (_e1061[1] < 0.0lf));
                let _e1072 = select(_e1070, _e1067, (_e1067 > _e1070));
                let _e1075 = select(_e1061[2], -(_e1061[2]), (_e1061[2] < 0.0lf));
                let _e1077 = select(_e1075, _e1072, (_e1072 > _e1075));
                let _e1080 = local_10.member_2[1u];
                let _e1086 = select(_e1080[0], -(_e1080[0]), (_e1080[0] < 0.0lf));
                let _e1089 = select(_e1080[1], -(_e1080[1]), (_e1080[1] < 0.0lf));
                let _e1091 = select(_e1089, _e1086, (_e1086 > _e1089));
                let _e1094 = select(_e1080[2], -(_e1080[2]), (_e1080[2] < 0.0lf));
                let _e1096 = select(_e1094, _e1091, (_e1091 > _e1094));
                let _e1100 = local_10.member_3;
                let _e1101 = (select(_e1096, _e1077, (_e1077 > _e1096)) + _e1100);
                let _e1102 = f64(1f);
                let _e1103 = f64(8f);
                let _e1105 = ((_e1058 * _e1103) * _e1101);
                let _e1113 = local_10.member_3;
                let _e1140 = ((select(_e832, -(_e832), (_e832 < 0.0lf)) + select(_e835, -(_e835), (_e835 < 0.0lf))) + select(_e838, -(_e838), (_e838 < 0.0lf)));
                let _e1151 = ((select(_e853, -(_e853), (_e853 < 0.0lf)) + select(_e856, -(_e856), (_e856 < 0.0lf))) + select(_e859, -(_e859), (_e859 < 0.0lf)));
                let _e1153 = select(_e1151, _e1140, (_e1140 > _e1151));
                let _e1165 = (((select(_e902, -(_e902), (_e902 < 0.0lf)) + select(_e903, -(_e903), (_e903 < 0.0lf))) + select(_e904, -(_e904), (_e904 < 0.0lf))) * f64(0.5f));
                let _e1173 = local_10.member_3;
                let _e1187 = (((((_e1015 * _e1103) * _e1105) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1113 * f64(19f)) * ((_e1015 * (_e1058 + _e1101)) + (_e1058 * _e1101)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1102 + _e1015) * ((_e1102 + _e1058) * (_e1102 + _e1101)))));
                let _e1188 = f64(3f);
                let _e1189 = (_e915 * _e1188);
                let _e1190 = (_e972 * _e1188);
                let _e1192 = select(_e1190, _e1189, (_e1189 < _e1190));
                let _e1194 = select(_e961, _e938, (_e938 < _e961));
                let _e1196 = select(_e1194, _e1192, (_e1192 < _e1194));
                let _e1198 = select(_e1190, _e1189, (_e1189 > _e1190));
                let _e1200 = select(_e961, _e938, (_e938 > _e961));
                let _e1208 = -(select(_e1200, _e1198, (_e1198 > _e1200)));
                if ((select(_e1208, _e1196, (_e1196 > _e1208)) - (_e1187 + ((_e817 * (((select(_e1165, _e1153, (_e1153 > _e1165)) + (_e1105 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1173 * f64(6f)) * (_e1058 + _e1101))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1102 + _e1058) * (_e1102 + _e1101))))) * f64((3f * 1.0001f))))) > _e817) {
                    phi_6820_ = type_44(0u, type_44().member_1);
                    phi_6821_ = type_44();
                    phi_6822_ = true;
                } else {
                    let _e1217 = select(_e915, -(_e915), (_e915 < 0.0lf));
                    let _e1220 = select(_e938, -(_e938), (_e938 < 0.0lf));
                    let _e1222 = select(_e1220, _e1217, (_e1217 > _e1220));
                    let _e1225 = select(_e961, -(_e961), (_e961 < 0.0lf));
                    let _e1228 = select(_e972, -(_e972), (_e972 < 0.0lf));
                    let _e1230 = select(_e1228, _e1225, (_e1225 > _e1228));
                    let _e1232 = select(_e1230, _e1222, (_e1222 > _e1230));
                    let _e1234 = (2.2250738585072014e-308lf * f64(67108864f));
                    let _e1235 = f64(1f);
                    if (_e1232 >= _e1234) {
                        phi_2075_ = (_e1232 <= (_e1235 / _e1234));
                    } else {
                        phi_2075_ = false;
                    }
                    let _e1240 = phi_2075_;
                    if _e1240 {
                        phi_2090_ = (_e1235 / _e1232);
                    } else {
                        phi_2090_ = f64(0f);
                    }
                    let _e1250 = phi_2090_;
                    let _e1251 = f64(0.00000000000022737368f);
                    let _e1253 = (_e523 * f64(0.0625f));
                    local_8 = type_41(array<f64, 4>(_e915, _e938, _e961, _e972), ((_e1187 * f64(0.34f)) + (_e1232 * select(f64(2f), (1.1102230246251565e-16lf * f64(256f)), _e1240))), _e1250, select(_e1253, _e1251, (_e1251 < _e1253)));
                    let _e1258 = f64(0f);
                    let _e1259 = f64(1f);
                    let _e1260 = f64(3f);
                    let _e1263 = local_8.member[0u];
                    let _e1266 = local_8.member[1u];
                    let _e1269 = local_8.member[2u];
                    let _e1272 = local_8.member[3u];
                    let _e1279 = local_8.member_2;
                    let _e1280 = ((_e1266 - (_e1260 * _e1263)) * _e1279);
                    let _e1282 = local_8.member_2;
                    let _e1283 = ((_e1269 - _e1266) * _e1282);
                    let _e1285 = local_8.member_2;
                    let _e1286 = (((_e1260 * _e1272) - _e1269) * _e1285);
                    local_6[0u] = _e1258;
                    local_6[1u] = _e1259;
                    local_6[2u] = _e1259;
                    local_6[3u] = _e1259;
                    let _e1293 = ((_e1283 * _e1283) - (_e1280 * _e1286));
                    if (_e1293 > _e1258) {
                        if (_e1293 <= 2.2250738585072014e-308lf) {
                            phi_2223_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1293 > 0.0lf));
                        } else {
                            phi_2166_ = type_18(0i, 5i);
                            phi_2169_ = bitcast<f64>(((bitcast<u64>(_e1293) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1301 = phi_2166_;
                                let _e1303 = phi_2169_;
                                local_11 = _e1303;
                                if (_e1301.member < _e1301.member_1) {
                                    let _e1310 = (_e1301.member + 1i);
                                    phi_2167_ = type_18(select(_e1310, type_19().member_1, select(false, true, ((false == (_e1310 > _e1301.member)) != false))), _e1301.member_1);
                                    phi_2210_ = type_19(1u, _e1301.member);
                                } else {
                                    phi_2167_ = _e1301;
                                    phi_2210_ = type_19(0u, type_19().member_1);
                                }
                                let _e1321 = phi_2167_;
                                let _e1323 = phi_2210_;
                                let _e1326 = (bitcast<i32>(_e1323.member) != 0i);
                                if _e1326 {
                                    phi_2170_ = (0.5lf * (_e1303 + (_e1293 / _e1303)));
                                } else {
                                    phi_2170_ = f64();
                                }
                                let _e1331 = phi_2170_;
                                continue;
                                continuing {
                                    phi_2166_ = _e1321;
                                    phi_2169_ = _e1331;
                                    break if !(_e1326);
                                }
                            }
                            let _e1336 = local_11;
                            phi_2223_ = (_e1336 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1342 = phi_2223_;
                        let _e1347 = -((_e1283 + select(_e1342, -(_e1342), (_e1283 < _e1258))));
                        local_7[0u] = (_e1347 / (_e1347 + _e1286));
                        local_7[1u] = (_e1280 / (_e1280 + _e1347));
                        let _e1356 = local_7[1u];
                        let _e1357 = local_7[0u];
                        if (_e1356 < _e1357) {
                            let _e1360 = local_7[1u];
                            let _e1362 = local_7[0u];
                            local_7[0u] = _e1360;
                            local_7[1u] = _e1362;
                        }
                        phi_2254_ = type_9(0u, 2u);
                        phi_2257_ = 1u;
                        loop {
                            let _e1366 = phi_2254_;
                            let _e1368 = phi_2257_;
                            local_47 = _e1368;
                            let _e1371 = (_e1366.member < _e1366.member_1);
                            let _e1382 = select(type_9().member_1, _e1366.member, _e1371);
                            let _e1384 = (bitcast<i32>(select(0u, 1u, _e1371)) != 0i);
                            if _e1384 {
                                let _e1386 = local_7[_e1382];
                                if (_e1386 > _e1258) {
                                    let _e1389 = local_7[_e1382];
                                    if (_e1389 < _e1259) {
                                        let _e1392 = local_7[_e1382];
                                        local_6[_e1368] = _e1392;
                                        phi_2324_ = (_e1368 + 1u);
                                    } else {
                                        phi_2324_ = _e1368;
                                    }
                                    let _e1396 = phi_2324_;
                                    phi_2325_ = _e1396;
                                } else {
                                    phi_2325_ = _e1368;
                                }
                                let _e1398 = phi_2325_;
                                phi_2258_ = _e1398;
                            } else {
                                phi_2258_ = u32();
                            }
                            let _e1400 = phi_2258_;
                            continue;
                            continuing {
                                phi_2254_ = type_9(select(_e1366.member, (_e1366.member + 1u), _e1371), select(_e1366.member_1, _e1366.member_1, _e1371));
                                phi_2257_ = _e1400;
                                break if !(_e1384);
                            }
                        }
                        let _e4501 = local_47;
                        phi_2326_ = _e4501;
                    } else {
                        phi_2326_ = 1u;
                    }
                    let _e1403 = phi_2326_;
                    local_6[_e1403] = _e1259;
                    let _e1405 = local_6;
                    local_9 = _e1405;
                    let _e1407 = (_e523 * f64(0.99f));
                    let _e1409 = (f64(1f) - _e532);
                    let _e1412 = local_8.member[0u];
                    let _e1415 = local_8.member[1u];
                    let _e1418 = local_8.member[2u];
                    let _e1421 = local_8.member[3u];
                    let _e1432 = ((((_e1412 * _e1409) + (_e1415 * _e532)) * (_e1409 * _e1409)) + (((_e1418 * _e1409) + (_e1421 * _e532)) * (_e532 * _e532)));
                    let _e1437 = local_8.member_1;
                    phi_2384_ = type_9(select(1u, 0u, !((select(_e1432, -(_e1432), (_e1432 < 0.0lf)) > _e1437))), (_e1403 + 1u));
                    loop {
                        let _e1444 = phi_2384_;
                        let _e1447 = (_e1444.member < _e1444.member_1);
                        let _e1458 = select(type_9().member_1, _e1444.member, _e1447);
                        if (bitcast<i32>(select(0u, 1u, _e1447)) != 0i) {
                            if (_e1458 > 0u) {
                                let _e1465 = local_9[(_e1458 - 1u)];
                                let _e1467 = select(_e532, _e1465, (_e1465 > _e532));
                                let _e1469 = local_9[_e1458];
                                let _e1471 = select(_e541, _e1469, (_e1469 < _e541));
                                if (_e1467 <= _e1471) {
                                    let _e1473 = function_5((&local_8), _e550, _e1467, _e1471);
                                    if _e1473 {
                                        phi_3976_ = type_45();
                                        phi_3977_ = bool();
                                        phi_3978_ = type_45();
                                        phi_3979_ = false;
                                        phi_3980_ = false;
                                        phi_3981_ = false;
                                        phi_3982_ = false;
                                    } else {
                                        let _e1475 = (f64(1f) - _e1467);
                                        let _e1478 = local_8.member[0u];
                                        let _e1481 = local_8.member[1u];
                                        let _e1484 = local_8.member[2u];
                                        let _e1487 = local_8.member[3u];
                                        let _e1498 = ((((_e1478 * _e1475) + (_e1481 * _e1467)) * (_e1475 * _e1475)) + (((_e1484 * _e1475) + (_e1487 * _e1467)) * (_e1467 * _e1467)));
                                        let _e1500 = (f64(1f) - _e1471);
                                        let _e1503 = local_8.member[0u];
                                        let _e1506 = local_8.member[1u];
                                        let _e1509 = local_8.member[2u];
                                        let _e1512 = local_8.member[3u];
                                        let _e1523 = ((((_e1503 * _e1500) + (_e1506 * _e1471)) * (_e1500 * _e1500)) + (((_e1509 * _e1500) + (_e1512 * _e1471)) * (_e1471 * _e1471)));
                                        let _e1528 = local_8.member_1;
                                        let _e1529 = (select(_e1498, -(_e1498), (_e1498 < 0.0lf)) > _e1528);
                                        let _e1534 = local_8.member_1;
                                        let _e1535 = (select(_e1523, -(_e1523), (_e1523 < 0.0lf)) > _e1534);
                                        let _e1536 = f64(0f);
                                        let _e1544 = select(select(bool(), select(bool(), ((_e1498 > _e1536) != (_e1523 > _e1536)), _e1535), _e1529), false, select(true, select(true, false, _e1535), _e1529));
                                        if _e1529 {
                                            if _e1535 {
                                                phi_2544_ = type_45(select(f64(1f), type_45().member, _e1544), select(_e1536, type_45().member_1, _e1544), select(_e1544, type_45().member_2, _e1544));
                                                phi_2545_ = _e1544;
                                            } else {
                                                phi_2544_ = type_45();
                                                phi_2545_ = true;
                                            }
                                            let _e1554 = phi_2544_;
                                            let _e1556 = phi_2545_;
                                            phi_2546_ = _e1554;
                                            phi_2547_ = _e1556;
                                        } else {
                                            phi_2546_ = type_45();
                                            phi_2547_ = true;
                                        }
                                        let _e1558 = phi_2546_;
                                        let _e1560 = phi_2547_;
                                        if _e1560 {
                                            if _e1529 {
                                                let _e1564 = select(f64(1f), f64(-1f), (_e1498 < _e1536));
                                                let _e1566 = local_8.member_3;
                                                let _e1567 = f64(0.5f);
                                                let _e1568 = f64(3f);
                                                let _e1571 = local_8.member[0u];
                                                let _e1574 = local_8.member[1u];
                                                let _e1577 = local_8.member[2u];
                                                let _e1580 = local_8.member[3u];
                                                let _e1583 = (_e1577 - _e1574);
                                                phi_2582_ = type_9(0u, 64u);
                                                phi_2585_ = _e1471;
                                                phi_2587_ = _e1467;
                                                phi_2589_ = (_e1567 * (_e1467 + _e1471));
                                                loop {
                                                    let _e1589 = phi_2582_;
                                                    let _e1591 = phi_2585_;
                                                    let _e1593 = phi_2587_;
                                                    let _e1595 = phi_2589_;
                                                    local_14 = _e1593;
                                                    let _e1598 = (_e1589.member < _e1589.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1598)) != 0i) {
                                                        let _e1611 = (f64(1f) - _e1595);
                                                        let _e1614 = local_8.member[0u];
                                                        let _e1617 = local_8.member[1u];
                                                        let _e1620 = local_8.member[2u];
                                                        let _e1623 = local_8.member[3u];
                                                        let _e1637 = local_8.member_1;
                                                        let _e1638 = ((_e1564 * ((((_e1614 * _e1611) + (_e1617 * _e1595)) * (_e1611 * _e1611)) + (((_e1620 * _e1611) + (_e1623 * _e1595)) * (_e1595 * _e1595)))) - _e1637);
                                                        let _e1640 = (_e1638 > f64(0f));
                                                        let _e1641 = select(_e1595, _e1591, _e1640);
                                                        let _e1642 = select(_e1593, _e1595, _e1640);
                                                        let _e1644 = ((_e1641 - _e1642) > _e1566);
                                                        if _e1644 {
                                                            let _e1646 = (f64(1f) - _e1595);
                                                            let _e1658 = (-(_e1638) / (_e1564 * (((((_e1574 - (_e1568 * _e1571)) * _e1646) + (_e1583 * _e1595)) * _e1646) + (((_e1583 * _e1646) + (((_e1568 * _e1580) - _e1577) * _e1595)) * _e1595))));
                                                            let _e1666 = ((_e1595 + _e1658) + select(-((_e1567 * _e1566)), (_e1567 * _e1566), (_e1638 > f64(0f))));
                                                            if (_e1666 > _e1642) {
                                                                phi_2703_ = select(true, select(true, false, (select(_e1658, -(_e1658), (_e1658 < 0.0lf)) < (_e1567 * (_e1641 - _e1642)))), (_e1666 < _e1641));
                                                            } else {
                                                                phi_2703_ = true;
                                                            }
                                                            let _e1678 = phi_2703_;
                                                            phi_2710_ = select(_e1666, (_e1567 * (_e1642 + _e1641)), _e1678);
                                                            phi_2711_ = false;
                                                        } else {
                                                            phi_2710_ = f64();
                                                            phi_2711_ = true;
                                                        }
                                                        let _e1683 = phi_2710_;
                                                        let _e1685 = phi_2711_;
                                                        phi_2586_ = _e1641;
                                                        phi_2588_ = _e1642;
                                                        phi_2590_ = _e1683;
                                                        phi_2712_ = _e1642;
                                                        phi_2713_ = _e1644;
                                                        phi_2714_ = _e1685;
                                                    } else {
                                                        phi_2586_ = f64();
                                                        phi_2588_ = f64();
                                                        phi_2590_ = f64();
                                                        phi_2712_ = f64();
                                                        phi_2713_ = false;
                                                        phi_2714_ = false;
                                                    }
                                                    let _e1687 = phi_2586_;
                                                    let _e1689 = phi_2588_;
                                                    let _e1691 = phi_2590_;
                                                    let _e1693 = phi_2712_;
                                                    let _e1695 = phi_2713_;
                                                    let _e1697 = phi_2714_;
                                                    local_12 = _e1697;
                                                    local_13 = _e1693;
                                                    continue;
                                                    continuing {
                                                        phi_2582_ = type_9(select(_e1589.member, (_e1589.member + 1u), _e1598), select(_e1589.member_1, _e1589.member_1, _e1598));
                                                        phi_2585_ = _e1687;
                                                        phi_2587_ = _e1689;
                                                        phi_2589_ = _e1691;
                                                        break if !(_e1695);
                                                    }
                                                }
                                                let _e1700 = local_12;
                                                let _e1702 = local_13;
                                                let _e1704 = local_14;
                                                phi_2719_ = select(_e1704, _e1702, _e1700);
                                            } else {
                                                phi_2719_ = _e1467;
                                            }
                                            let _e1707 = phi_2719_;
                                            if _e1535 {
                                                let _e1713 = local_8.member_3;
                                                let _e1715 = local_8.member_3;
                                                phi_2737_ = type_9(0u, 64u);
                                                phi_2740_ = (_e1713 + _e1715);
                                                loop {
                                                    let _e1718 = phi_2737_;
                                                    let _e1720 = phi_2740_;
                                                    let _e1723 = (_e1718.member < _e1718.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1723)) != 0i) {
                                                        let _e1735 = (_e1707 + _e1720);
                                                        if (_e1735 < _e1471) {
                                                            let _e1738 = (f64(1f) - _e1735);
                                                            let _e1741 = local_8.member[0u];
                                                            let _e1744 = local_8.member[1u];
                                                            let _e1747 = local_8.member[2u];
                                                            let _e1750 = local_8.member[3u];
                                                            let _e1764 = local_8.member_1;
                                                            let _e1765 = ((select(f64(1f), f64(-1f), (_e1523 < _e1536)) * ((((_e1741 * _e1738) + (_e1744 * _e1735)) * (_e1738 * _e1738)) + (((_e1747 * _e1738) + (_e1750 * _e1735)) * (_e1735 * _e1735)))) > _e1764);
                                                            phi_2806_ = select((_e1720 + _e1720), f64(), _e1765);
                                                            phi_2807_ = select(true, false, _e1765);
                                                            phi_2808_ = _e1765;
                                                            phi_2809_ = false;
                                                        } else {
                                                            phi_2806_ = f64();
                                                            phi_2807_ = false;
                                                            phi_2808_ = false;
                                                            phi_2809_ = true;
                                                        }
                                                        let _e1770 = phi_2806_;
                                                        let _e1772 = phi_2807_;
                                                        let _e1774 = phi_2808_;
                                                        let _e1776 = phi_2809_;
                                                        phi_2810_ = _e1735;
                                                        phi_2741_ = _e1770;
                                                        phi_2811_ = _e1772;
                                                        phi_2812_ = _e1774;
                                                        phi_2813_ = _e1776;
                                                        phi_2814_ = false;
                                                    } else {
                                                        phi_2810_ = f64();
                                                        phi_2741_ = f64();
                                                        phi_2811_ = false;
                                                        phi_2812_ = false;
                                                        phi_2813_ = false;
                                                        phi_2814_ = true;
                                                    }
                                                    let _e1778 = phi_2810_;
                                                    let _e1780 = phi_2741_;
                                                    let _e1782 = phi_2811_;
                                                    let _e1784 = phi_2812_;
                                                    let _e1786 = phi_2813_;
                                                    let _e1788 = phi_2814_;
                                                    local_15 = _e1784;
                                                    local_16 = _e1786;
                                                    local_17 = _e1784;
                                                    local_18 = _e1788;
                                                    local_19 = _e1778;
                                                    continue;
                                                    continuing {
                                                        phi_2737_ = type_9(select(_e1718.member, (_e1718.member + 1u), _e1723), select(_e1718.member_1, _e1718.member_1, _e1723));
                                                        phi_2740_ = _e1780;
                                                        break if !(_e1782);
                                                    }
                                                }
                                                let _e1791 = local_15;
                                                let _e1793 = local_16;
                                                let _e1796 = local_17;
                                                let _e1798 = local_18;
                                                let _e1802 = local_19;
                                                phi_2828_ = select(_e1802, _e1471, select(select(_e1798, false, _e1796), true, select(_e1793, false, _e1791)));
                                            } else {
                                                phi_2828_ = _e1471;
                                            }
                                            let _e1805 = phi_2828_;
                                            phi_2830_ = type_45(_e1707, _e1805, _e1544);
                                        } else {
                                            phi_2830_ = _e1558;
                                        }
                                        let _e1808 = phi_2830_;
                                        if (_e1808.member > _e1808.member_1) {
                                            phi_3971_ = bool();
                                            phi_3972_ = true;
                                            phi_3973_ = false;
                                            phi_3974_ = false;
                                            phi_3975_ = false;
                                        } else {
                                            let _e1813 = (_e1808.member > _e550);
                                            if _e1813 {
                                                phi_3967_ = bool();
                                                phi_3968_ = false;
                                                phi_3969_ = false;
                                                phi_3970_ = false;
                                            } else {
                                                let _e1818 = ((_e1808.member_1 - _e1808.member) * f64(0.5f));
                                                let _e1819 = (_e1808.member + _e1818);
                                                let _e1822 = (_e1818 + (1.1102230246251565e-16lf * f64(4f)));
                                                let _e1824 = local_10.member_3;
                                                let _e1827 = local_10.member[0u];
                                                let _e1833 = select(_e1827[0], -(_e1827[0]), (_e1827[0] < 0.0lf));
                                                let _e1836 = select(_e1827[1], -(_e1827[1]), (_e1827[1] < 0.0lf));
                                                let _e1838 = select(_e1836, _e1833, (_e1833 > _e1836));
                                                let _e1841 = select(_e1827[2], -(_e1827[2]), (_e1827[2] < 0.0lf));
                                                let _e1843 = select(_e1841, _e1838, (_e1838 > _e1841));
                                                let _e1845 = local_10.member[1u];
                                                let _e1851 = select(_e1845[0], -(_e1845[0]), (_e1845[0] < 0.0lf));
                                                let _e1854 = select(_e1845[1], -(_e1845[1]), (_e1845[1] < 0.0lf));
                                                let _e1856 = select(_e1854, _e1851, (_e1851 > _e1854));
                                                let _e1859 = select(_e1845[2], -(_e1845[2]), (_e1845[2] < 0.0lf));
                                                let _e1861 = select(_e1859, _e1856, (_e1856 > _e1859));
                                                let _e1866 = local_10.member[0u];
                                                let _e1871 = local_10.member[1u];
                                                let _e1881 = (_e1866[0] + ((_e1871[0] - _e1866[0]) * _e1819));
                                                let _e1882 = (_e1866[1] + ((_e1871[1] - _e1866[1]) * _e1819));
                                                let _e1883 = (_e1866[2] + ((_e1871[2] - _e1866[2]) * _e1819));
                                                let _e1885 = local_10.member[1u];
                                                let _e1890 = local_10.member[0u];
                                                let _e1894 = (_e1885[0] - _e1890[0]);
                                                let _e1895 = (_e1885[1] - _e1890[1]);
                                                let _e1896 = (_e1885[2] - _e1890[2]);
                                                let _e1899 = select(_e1894, -(_e1894), (_e1894 < 0.0lf));
                                                let _e1902 = select(_e1895, -(_e1895), (_e1895 < 0.0lf));
                                                let _e1904 = select(_e1902, _e1899, (_e1899 > _e1902));
                                                let _e1907 = select(_e1896, -(_e1896), (_e1896 < 0.0lf));
                                                let _e1917 = ((((_e1822 * select(_e1907, _e1904, (_e1904 > _e1907))) * f64(1.01f)) + ((select(_e1861, _e1843, (_e1843 > _e1861)) + _e1824) * (1.1102230246251565e-16lf * f64(8f)))) + _e1824);
                                                let _e1920 = select(_e1881, -(_e1881), (_e1881 < 0.0lf));
                                                let _e1923 = select(_e1882, -(_e1882), (_e1882 < 0.0lf));
                                                let _e1925 = select(_e1923, _e1920, (_e1920 > _e1923));
                                                let _e1928 = select(_e1883, -(_e1883), (_e1883 < 0.0lf));
                                                local_2 = type_37(array<f64, 3>(_e1881, _e1882, _e1883), _e1917, (select(_e1928, _e1925, (_e1925 > _e1928)) + _e1917));
                                                let _e1936 = local_10.member_3;
                                                let _e1938 = local_10.member_1[0u];
                                                let _e1944 = select(_e1938[0], -(_e1938[0]), (_e1938[0] < 0.0lf));
                                                let _e1947 = select(_e1938[1], -(_e1938[1]), (_e1938[1] < 0.0lf));
                                                let _e1949 = select(_e1947, _e1944, (_e1944 > _e1947));
                                                let _e1952 = select(_e1938[2], -(_e1938[2]), (_e1938[2] < 0.0lf));
                                                let _e1954 = select(_e1952, _e1949, (_e1949 > _e1952));
                                                let _e1956 = local_10.member_1[1u];
                                                let _e1962 = select(_e1956[0], -(_e1956[0]), (_e1956[0] < 0.0lf));
                                                let _e1965 = select(_e1956[1], -(_e1956[1]), (_e1956[1] < 0.0lf));
                                                let _e1967 = select(_e1965, _e1962, (_e1962 > _e1965));
                                                let _e1970 = select(_e1956[2], -(_e1956[2]), (_e1956[2] < 0.0lf));
                                                let _e1972 = select(_e1970, _e1967, (_e1967 > _e1970));
                                                let _e1977 = local_10.member_1[0u];
                                                let _e1982 = local_10.member_1[1u];
                                                let _e1992 = (_e1977[0] + ((_e1982[0] - _e1977[0]) * _e1819));
                                                let _e1993 = (_e1977[1] + ((_e1982[1] - _e1977[1]) * _e1819));
                                                let _e1994 = (_e1977[2] + ((_e1982[2] - _e1977[2]) * _e1819));
                                                let _e1996 = local_10.member_1[1u];
                                                let _e2001 = local_10.member_1[0u];
                                                let _e2005 = (_e1996[0] - _e2001[0]);
                                                let _e2006 = (_e1996[1] - _e2001[1]);
                                                let _e2007 = (_e1996[2] - _e2001[2]);
                                                let _e2010 = select(_e2005, -(_e2005), (_e2005 < 0.0lf));
                                                let _e2013 = select(_e2006, -(_e2006), (_e2006 < 0.0lf));
                                                let _e2015 = select(_e2013, _e2010, (_e2010 > _e2013));
                                                let _e2018 = select(_e2007, -(_e2007), (_e2007 < 0.0lf));
                                                let _e2028 = ((((_e1822 * select(_e2018, _e2015, (_e2015 > _e2018))) * f64(1.01f)) + ((select(_e1972, _e1954, (_e1954 > _e1972)) + _e1936) * (1.1102230246251565e-16lf * f64(8f)))) + _e1936);
                                                let _e2031 = select(_e1992, -(_e1992), (_e1992 < 0.0lf));
                                                let _e2034 = select(_e1993, -(_e1993), (_e1993 < 0.0lf));
                                                let _e2036 = select(_e2034, _e2031, (_e2031 > _e2034));
                                                let _e2039 = select(_e1994, -(_e1994), (_e1994 < 0.0lf));
                                                local_3 = type_37(array<f64, 3>(_e1992, _e1993, _e1994), _e2028, (select(_e2039, _e2036, (_e2036 > _e2039)) + _e2028));
                                                let _e2047 = local_10.member_3;
                                                let _e2049 = local_10.member_2[0u];
                                                let _e2055 = select(_e2049[0], -(_e2049[0]), (_e2049[0] < 0.0lf));
                                                let _e2058 = select(_e2049[1], -(_e2049[1]), (_e2049[1] < 0.0lf));
                                                let _e2060 = select(_e2058, _e2055, (_e2055 > _e2058));
                                                let _e2063 = select(_e2049[2], -(_e2049[2]), (_e2049[2] < 0.0lf));
                                                let _e2065 = select(_e2063, _e2060, (_e2060 > _e2063));
                                                let _e2067 = local_10.member_2[1u];
                                                let _e2073 = select(_e2067[0], -(_e2067[0]), (_e2067[0] < 0.0lf));
                                                let _e2076 = select(_e2067[1], -(_e2067[1]), (_e2067[1] < 0.0lf));
                                                let _e2078 = select(_e2076, _e2073, (_e2073 > _e2076));
                                                let _e2081 = select(_e2067[2], -(_e2067[2]), (_e2067[2] < 0.0lf));
                                                let _e2083 = select(_e2081, _e2078, (_e2078 > _e2081));
                                                let _e2088 = local_10.member_2[0u];
                                                let _e2093 = local_10.member_2[1u];
                                                let _e2103 = (_e2088[0] + ((_e2093[0] - _e2088[0]) * _e1819));
                                                let _e2104 = (_e2088[1] + ((_e2093[1] - _e2088[1]) * _e1819));
                                                let _e2105 = (_e2088[2] + ((_e2093[2] - _e2088[2]) * _e1819));
                                                let _e2107 = local_10.member_2[1u];
                                                let _e2112 = local_10.member_2[0u];
                                                let _e2116 = (_e2107[0] - _e2112[0]);
                                                let _e2117 = (_e2107[1] - _e2112[1]);
                                                let _e2118 = (_e2107[2] - _e2112[2]);
                                                let _e2121 = select(_e2116, -(_e2116), (_e2116 < 0.0lf));
                                                let _e2124 = select(_e2117, -(_e2117), (_e2117 < 0.0lf));
                                                let _e2126 = select(_e2124, _e2121, (_e2121 > _e2124));
                                                let _e2129 = select(_e2118, -(_e2118), (_e2118 < 0.0lf));
                                                let _e2139 = ((((_e1822 * select(_e2129, _e2126, (_e2126 > _e2129))) * f64(1.01f)) + ((select(_e2083, _e2065, (_e2065 > _e2083)) + _e2047) * (1.1102230246251565e-16lf * f64(8f)))) + _e2047);
                                                let _e2142 = select(_e2103, -(_e2103), (_e2103 < 0.0lf));
                                                let _e2145 = select(_e2104, -(_e2104), (_e2104 < 0.0lf));
                                                let _e2147 = select(_e2145, _e2142, (_e2142 > _e2145));
                                                let _e2150 = select(_e2105, -(_e2105), (_e2105 < 0.0lf));
                                                local_4 = type_37(array<f64, 3>(_e2103, _e2104, _e2105), _e2139, (select(_e2150, _e2147, (_e2147 > _e2150)) + _e2139));
                                                let _e2157 = local_3.member;
                                                let _e2162 = local_4.member;
                                                let _e2168 = ((_e2157[1] * _e2162[2]) - (_e2157[2] * _e2162[1]));
                                                let _e2171 = ((_e2157[2] * _e2162[0]) - (_e2157[0] * _e2162[2]));
                                                let _e2174 = ((_e2157[0] * _e2162[1]) - (_e2157[1] * _e2162[0]));
                                                if (select(_e2168, -(_e2168), (_e2168 < 0.0lf)) > select(_e2171, -(_e2171), (_e2171 < 0.0lf))) {
                                                    let _e2197 = (select(_e2168, -(_e2168), (_e2168 < 0.0lf)) > select(_e2174, -(_e2174), (_e2174 < 0.0lf)));
                                                    phi_3563_ = select(1u, 2u, _e2197);
                                                    phi_3564_ = select(0u, 1u, _e2197);
                                                } else {
                                                    let _e2188 = (select(_e2171, -(_e2171), (_e2171 < 0.0lf)) > select(_e2174, -(_e2174), (_e2174 < 0.0lf)));
                                                    phi_3563_ = select(1u, 0u, _e2188);
                                                    phi_3564_ = select(0u, 2u, _e2188);
                                                }
                                                let _e2201 = phi_3563_;
                                                let _e2203 = phi_3564_;
                                                let _e2206 = local_3.member[_e2203];
                                                let _e2209 = local_4.member[_e2201];
                                                let _e2213 = local_3.member[_e2201];
                                                let _e2216 = local_4.member[_e2203];
                                                let _e2218 = ((_e2206 * _e2209) - (_e2213 * _e2216));
                                                let _e2219 = f64(1f);
                                                let _e2220 = f64(2f);
                                                let _e2222 = local_3.member_1;
                                                let _e2224 = local_4.member_2;
                                                let _e2227 = local_3.member_2;
                                                let _e2229 = local_4.member_1;
                                                let _e2235 = local_3.member_2;
                                                let _e2238 = local_4.member_2;
                                                let _e2247 = local_3.member_2;
                                                let _e2250 = local_4.member_2;
                                                let _e2254 = (((((_e2222 * _e2224) + (_e2227 * _e2229)) * f64(2.01f)) + (((_e2235 * _e2220) * (_e2238 * _e2220)) * (1.1102230246251565e-16lf * _e2220))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2219 + _e2247) * (_e2219 + _e2250))));
                                                if (select(_e2218, -(_e2218), (_e2218 < 0.0lf)) > _e2254) {
                                                    let _e2263 = select(f64(1f), f64(-1f), (_e2218 < f64(0f)));
                                                    let _e2266 = local_2.member[_e2203];
                                                    let _e2269 = local_4.member[_e2201];
                                                    let _e2273 = local_2.member[_e2201];
                                                    let _e2276 = local_4.member[_e2203];
                                                    let _e2279 = f64(1f);
                                                    let _e2280 = f64(2f);
                                                    let _e2282 = local_2.member_1;
                                                    let _e2284 = local_4.member_2;
                                                    let _e2287 = local_2.member_2;
                                                    let _e2289 = local_4.member_1;
                                                    let _e2295 = local_2.member_2;
                                                    let _e2298 = local_4.member_2;
                                                    let _e2307 = local_2.member_2;
                                                    let _e2310 = local_4.member_2;
                                                    let _e2314 = (((((_e2282 * _e2284) + (_e2287 * _e2289)) * f64(2.01f)) + (((_e2295 * _e2280) * (_e2298 * _e2280)) * (1.1102230246251565e-16lf * _e2280))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2279 + _e2307) * (_e2279 + _e2310))));
                                                    let _e2317 = local_3.member[_e2203];
                                                    let _e2320 = local_2.member[_e2201];
                                                    let _e2324 = local_3.member[_e2201];
                                                    let _e2327 = local_2.member[_e2203];
                                                    let _e2330 = f64(1f);
                                                    let _e2331 = f64(2f);
                                                    let _e2333 = local_3.member_1;
                                                    let _e2335 = local_2.member_2;
                                                    let _e2338 = local_3.member_2;
                                                    let _e2340 = local_2.member_1;
                                                    let _e2346 = local_3.member_2;
                                                    let _e2349 = local_2.member_2;
                                                    let _e2358 = local_3.member_2;
                                                    let _e2361 = local_2.member_2;
                                                    let _e2365 = (((((_e2333 * _e2335) + (_e2338 * _e2340)) * f64(2.01f)) + (((_e2346 * _e2331) * (_e2349 * _e2331)) * (1.1102230246251565e-16lf * _e2331))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2330 + _e2358) * (_e2330 + _e2361))));
                                                    let _e2366 = (_e2218 * _e2263);
                                                    let _e2367 = (((_e2266 * _e2269) - (_e2273 * _e2276)) * _e2263);
                                                    let _e2368 = (((_e2317 * _e2320) - (_e2324 * _e2327)) * _e2263);
                                                    let _e2382 = (((select(_e2366, -(_e2366), (_e2366 < 0.0lf)) + select(_e2367, -(_e2367), (_e2367 < 0.0lf))) + select(_e2368, -(_e2368), (_e2368 < 0.0lf))) * (1.1102230246251565e-16lf * f64(4f)));
                                                    if (_e229.member != 0u) {
                                                        phi_3841_ = array<type_38, 4>(type_38(_e2367, _e2314), type_38(_e2368, _e2365), type_38((_e2366 - _e2367), ((_e2254 + _e2314) + _e2382)), type_38((_e2366 - _e2368), ((_e2254 + _e2365) + _e2382)));
                                                    } else {
                                                        let _e2385 = ((_e2366 - _e2367) - _e2368);
                                                        let _e2388 = (((_e2254 + _e2314) + _e2365) + _e2382);
                                                        phi_3841_ = array<type_38, 4>(type_38(_e2367, _e2314), type_38(_e2368, _e2365), type_38(_e2385, _e2388), type_38(_e2385, _e2388));
                                                    }
                                                    let _e2406 = phi_3841_;
                                                    local_5 = array<type_38, 4>(type_38(_e2406[0].member, _e2406[0].member_1), type_38(_e2406[1].member, _e2406[1].member_1), type_38(_e2406[2].member, _e2406[2].member_1), type_38(_e2406[3].member, _e2406[3].member_1));
                                                    phi_3861_ = type_9(0u, 4u);
                                                    phi_3864_ = true;
                                                    loop {
                                                        let _e2425 = phi_3861_;
                                                        let _e2427 = phi_3864_;
                                                        local_21 = _e2427;
                                                        let _e2430 = (_e2425.member < _e2425.member_1);
                                                        let _e2441 = select(type_9().member_1, _e2425.member, _e2430);
                                                        if (bitcast<i32>(select(0u, 1u, _e2430)) != 0i) {
                                                            let _e2446 = local_5[_e2441].member;
                                                            let _e2449 = local_5[_e2441].member_1;
                                                            let _e2451 = (_e2446 < -(_e2449));
                                                            phi_3865_ = select((_e2427 && (_e2446 > _e2449)), bool(), _e2451);
                                                            phi_3916_ = select(true, false, _e2451);
                                                            phi_3917_ = _e2451;
                                                        } else {
                                                            phi_3865_ = bool();
                                                            phi_3916_ = false;
                                                            phi_3917_ = false;
                                                        }
                                                        let _e2457 = phi_3865_;
                                                        let _e2459 = phi_3916_;
                                                        let _e2461 = phi_3917_;
                                                        local_20 = _e2461;
                                                        continue;
                                                        continuing {
                                                            phi_3861_ = type_9(select(_e2425.member, (_e2425.member + 1u), _e2430), select(_e2425.member_1, _e2425.member_1, _e2430));
                                                            phi_3864_ = _e2457;
                                                            break if !(_e2459);
                                                        }
                                                    }
                                                    let _e2464 = local_20;
                                                    let _e2465 = select(true, false, _e2464);
                                                    let _e2467 = local_21;
                                                    phi_3931_ = select(u32(), select(2u, 1u, _e2467), _e2465);
                                                    phi_3932_ = 0u;
                                                    phi_3933_ = select(true, false, _e2465);
                                                } else {
                                                    phi_3931_ = u32();
                                                    phi_3932_ = 2u;
                                                    phi_3933_ = true;
                                                }
                                                let _e2472 = phi_3931_;
                                                let _e2474 = phi_3932_;
                                                let _e2476 = phi_3933_;
                                                let _e2477 = select(_e2472, _e2474, _e2476);
                                                let _e2478 = (_e2477 == 0u);
                                                if _e2478 {
                                                    phi_3964_ = bool();
                                                    phi_3965_ = false;
                                                    phi_3966_ = false;
                                                } else {
                                                    let _e2481 = select(false, _e1808.member_2, (_e2477 == 1u));
                                                    let _e2487 = select(true, select(true, false, ((_e1808.member_1 - _e1808.member) <= _e1407)), _e2481);
                                                    phi_3964_ = _e2481;
                                                    phi_3965_ = _e2487;
                                                    phi_3966_ = select(true, false, _e2487);
                                                }
                                                let _e2490 = phi_3964_;
                                                let _e2492 = phi_3965_;
                                                let _e2494 = phi_3966_;
                                                phi_3967_ = _e2490;
                                                phi_3968_ = _e2478;
                                                phi_3969_ = _e2492;
                                                phi_3970_ = _e2494;
                                            }
                                            let _e2496 = phi_3967_;
                                            let _e2498 = phi_3968_;
                                            let _e2500 = phi_3969_;
                                            let _e2502 = phi_3970_;
                                            phi_3971_ = _e2496;
                                            phi_3972_ = _e2498;
                                            phi_3973_ = _e2500;
                                            phi_3974_ = _e1813;
                                            phi_3975_ = _e2502;
                                        }
                                        let _e2504 = phi_3971_;
                                        let _e2506 = phi_3972_;
                                        let _e2508 = phi_3973_;
                                        let _e2510 = phi_3974_;
                                        let _e2512 = phi_3975_;
                                        phi_3976_ = _e1808;
                                        phi_3977_ = _e2504;
                                        phi_3978_ = _e1808;
                                        phi_3979_ = _e2506;
                                        phi_3980_ = _e2508;
                                        phi_3981_ = _e2510;
                                        phi_3982_ = _e2512;
                                    }
                                    let _e2514 = phi_3976_;
                                    let _e2516 = phi_3977_;
                                    let _e2518 = phi_3978_;
                                    let _e2520 = phi_3979_;
                                    let _e2522 = phi_3980_;
                                    let _e2524 = phi_3981_;
                                    let _e2526 = phi_3982_;
                                    phi_3983_ = _e2514;
                                    phi_3984_ = _e2516;
                                    phi_3985_ = _e2518;
                                    phi_3986_ = _e2520;
                                    phi_3987_ = _e2522;
                                    phi_3988_ = _e1473;
                                    phi_3989_ = _e2524;
                                    phi_3990_ = _e2526;
                                } else {
                                    phi_3983_ = type_45();
                                    phi_3984_ = bool();
                                    phi_3985_ = type_45();
                                    phi_3986_ = true;
                                    phi_3987_ = false;
                                    phi_3988_ = false;
                                    phi_3989_ = false;
                                    phi_3990_ = false;
                                }
                                let _e2528 = phi_3983_;
                                let _e2530 = phi_3984_;
                                let _e2532 = phi_3985_;
                                let _e2534 = phi_3986_;
                                let _e2536 = phi_3987_;
                                let _e2538 = phi_3988_;
                                let _e2540 = phi_3989_;
                                let _e2542 = phi_3990_;
                                phi_3998_ = _e2528;
                                phi_3999_ = _e2530;
                                phi_4000_ = _e2532;
                                phi_4001_ = select(_e2536, false, _e2534);
                                phi_4002_ = _e2534;
                                phi_4003_ = select(_e2538, false, _e2534);
                                phi_4004_ = select(_e2540, false, _e2534);
                                phi_4005_ = select(_e2542, false, _e2534);
                            } else {
                                phi_3998_ = type_45(_e532, _e532, false);
                                phi_3999_ = false;
                                phi_4000_ = type_45();
                                phi_4001_ = true;
                                phi_4002_ = false;
                                phi_4003_ = false;
                                phi_4004_ = false;
                                phi_4005_ = false;
                            }
                            let _e2548 = phi_3998_;
                            let _e2550 = phi_3999_;
                            let _e2552 = phi_4000_;
                            let _e2554 = phi_4001_;
                            let _e2556 = phi_4002_;
                            let _e2558 = phi_4003_;
                            let _e2560 = phi_4004_;
                            let _e2562 = phi_4005_;
                            if _e2554 {
                                let _e2567 = local_10.member[0u];
                                let _e2573 = local_10.member_1[0u];
                                let _e2579 = local_10.member_2[0u];
                                let _e2583 = (_e2567[0] - _e2573[0]);
                                let _e2584 = (_e2567[1] - _e2573[1]);
                                let _e2585 = (_e2567[2] - _e2573[2]);
                                let _e2586 = (_e229.member == 0u);
                                let _e2598 = local_10.member[1u];
                                let _e2604 = local_10.member_1[1u];
                                let _e2610 = local_10.member_2[1u];
                                let _e2614 = (_e2598[0] - _e2604[0]);
                                let _e2615 = (_e2598[1] - _e2604[1]);
                                let _e2616 = (_e2598[2] - _e2604[2]);
                                let _e2617 = (_e229.member == 0u);
                                let _e2629 = local_10.member[0u];
                                let _e2635 = select(_e2629[0], -(_e2629[0]), (_e2629[0] < 0.0lf));
                                let _e2638 = select(_e2629[1], -(_e2629[1]), (_e2629[1] < 0.0lf));
                                let _e2640 = select(_e2638, _e2635, (_e2635 > _e2638));
                                let _e2643 = select(_e2629[2], -(_e2629[2]), (_e2629[2] < 0.0lf));
                                let _e2645 = select(_e2643, _e2640, (_e2640 > _e2643));
                                let _e2648 = local_10.member[1u];
                                let _e2654 = select(_e2648[0], -(_e2648[0]), (_e2648[0] < 0.0lf));
                                let _e2657 = select(_e2648[1], -(_e2648[1]), (_e2648[1] < 0.0lf));
                                let _e2659 = select(_e2657, _e2654, (_e2654 > _e2657));
                                let _e2662 = select(_e2648[2], -(_e2648[2]), (_e2648[2] < 0.0lf));
                                let _e2664 = select(_e2662, _e2659, (_e2659 > _e2662));
                                let _e2668 = local_10.member_3;
                                let _e2672 = local_10.member_1[0u];
                                let _e2678 = select(_e2672[0], -(_e2672[0]), (_e2672[0] < 0.0lf));
                                let _e2681 = select(_e2672[1], -(_e2672[1]), (_e2672[1] < 0.0lf));
                                let _e2683 = select(_e2681, _e2678, (_e2678 > _e2681));
                                let _e2686 = select(_e2672[2], -(_e2672[2]), (_e2672[2] < 0.0lf));
                                let _e2688 = select(_e2686, _e2683, (_e2683 > _e2686));
                                let _e2691 = local_10.member_1[1u];
                                let _e2697 = select(_e2691[0], -(_e2691[0]), (_e2691[0] < 0.0lf));
                                let _e2700 = select(_e2691[1], -(_e2691[1]), (_e2691[1] < 0.0lf));
                                let _e2702 = select(_e2700, _e2697, (_e2697 > _e2700));
                                let _e2705 = select(_e2691[2], -(_e2691[2]), (_e2691[2] < 0.0lf));
                                let _e2707 = select(_e2705, _e2702, (_e2702 > _e2705));
                                let _e2711 = local_10.member_3;
                                let _e2715 = local_10.member_2[0u];
                                let _e2721 = select(_e2715[0], -(_e2715[0]), (_e2715[0] < 0.0lf));
                                let _e2724 = select(_e2715[1], -(_e2715[1]), (_e2715[1] < 0.0lf));
                                let _e2726 = select(_e2724, _e2721, (_e2721 > _e2724));
                                let _e2729 = select(_e2715[2], -(_e2715[2]), (_e2715[2] < 0.0lf));
                                let _e2731 = select(_e2729, _e2726, (_e2726 > _e2729));
                                let _e2734 = local_10.member_2[1u];
                                let _e2740 = select(_e2734[0], -(_e2734[0]), (_e2734[0] < 0.0lf));
                                let _e2743 = select(_e2734[1], -(_e2734[1]), (_e2734[1] < 0.0lf));
                                let _e2745 = select(_e2743, _e2740, (_e2740 > _e2743));
                                let _e2748 = select(_e2734[2], -(_e2734[2]), (_e2734[2] < 0.0lf));
                                let _e2750 = select(_e2748, _e2745, (_e2745 > _e2748));
                                let _e2754 = local_10.member_3;
                                let _e2762 = local_10.member_3;
                                let _e2770 = (_e523 * f64(0.00390625f));
                                let _e2771 = f64(0f);
                                let _e2772 = f64(1f);
                                local = type_36(array<f64, 4>(_e2771, _e2771, _e2771, _e2771), array<f64, 4>(_e2771, _e2771, _e2771, _e2771), array<f64, 4>(_e2772, _e2772, _e2772, _e2772));
                                phi_4434_ = type_9(0u, 96u);
                                phi_4437_ = _e2548.member;
                                phi_4439_ = _e2548.member;
                                phi_4441_ = (_e2548.member_1 - _e2548.member);
                                phi_4443_ = _e2548.member;
                                phi_4445_ = false;
                                phi_4447_ = 0u;
                                loop {
                                    let _e2779 = phi_4434_;
                                    let _e2781 = phi_4437_;
                                    let _e2783 = phi_4439_;
                                    let _e2785 = phi_4441_;
                                    let _e2787 = phi_4443_;
                                    let _e2789 = phi_4445_;
                                    let _e2791 = phi_4447_;
                                    local_34 = _e2781;
                                    local_38 = _e2783;
                                    let _e2794 = (_e2779.member < _e2779.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2794)) != 0i) {
                                        let _e2808 = local_10.member[0u];
                                        let _e2814 = local_10.member[1u];
                                        let _e2830 = local_10.member_1[0u];
                                        let _e2836 = local_10.member_1[1u];
                                        let _e2852 = local_10.member_2[0u];
                                        let _e2858 = local_10.member_2[1u];
                                        let _e2872 = function_4(array<f64, 3>((_e2808[0] + ((_e2814[0] - _e2808[0]) * _e2781)), (_e2808[1] + ((_e2814[1] - _e2808[1]) * _e2781)), (_e2808[2] + ((_e2814[2] - _e2808[2]) * _e2781))), array<f64, 3>((_e2830[0] + ((_e2836[0] - _e2830[0]) * _e2781)), (_e2830[1] + ((_e2836[1] - _e2830[1]) * _e2781)), (_e2830[2] + ((_e2836[2] - _e2830[2]) * _e2781))), array<f64, 3>((_e2852[0] + ((_e2858[0] - _e2852[0]) * _e2781)), (_e2852[1] + ((_e2858[1] - _e2852[1]) * _e2781)), (_e2852[2] + ((_e2858[2] - _e2852[2]) * _e2781))), _e229.member);
                                        if (_e2791 == 0u) {
                                            phi_4599_ = _e2872;
                                        } else {
                                            let _e2874 = f64(0f);
                                            phi_4599_ = array<f64, 3>(select(_e2874, _e2872[0], (_e2791 == 1u)), select(_e2874, _e2872[1], (_e2791 == 2u)), select(_e2874, _e2872[2], (_e2791 == 3u)));
                                        }
                                        let _e2886 = phi_4599_;
                                        let _e2900 = ((select(_e2886[0], -(_e2886[0]), (_e2886[0] < 0.0lf)) + select(_e2886[1], -(_e2886[1]), (_e2886[1] < 0.0lf))) + select(_e2886[2], -(_e2886[2]), (_e2886[2] < 0.0lf)));
                                        if (_e2900 > f64(0f)) {
                                            if ((bitcast<u64>(_e2900) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2907 = (f64(1f) / _e2900);
                                                let _e2909 = (_e2886[0] * _e2907);
                                                let _e2911 = (_e2886[1] * _e2907);
                                                let _e2913 = (_e2886[2] * _e2907);
                                                let _e2918 = (((_e2909 * _e2909) + (_e2911 * _e2911)) + (_e2913 * _e2913));
                                                if (_e2918 <= 2.2250738585072014e-308lf) {
                                                    phi_4724_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2918 > 0.0lf));
                                                } else {
                                                    phi_4667_ = type_18(0i, 5i);
                                                    phi_4670_ = bitcast<f64>(((bitcast<u64>(_e2918) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2925 = phi_4667_;
                                                        let _e2927 = phi_4670_;
                                                        local_22 = _e2927;
                                                        if (_e2925.member < _e2925.member_1) {
                                                            let _e2934 = (_e2925.member + 1i);
                                                            phi_4668_ = type_18(select(_e2934, type_19().member_1, select(false, true, ((false == (_e2934 > _e2925.member)) != false))), _e2925.member_1);
                                                            phi_4711_ = type_19(1u, _e2925.member);
                                                        } else {
                                                            phi_4668_ = _e2925;
                                                            phi_4711_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e2945 = phi_4668_;
                                                        let _e2947 = phi_4711_;
                                                        let _e2950 = (bitcast<i32>(_e2947.member) != 0i);
                                                        if _e2950 {
                                                            phi_4671_ = (0.5lf * (_e2927 + (_e2918 / _e2927)));
                                                        } else {
                                                            phi_4671_ = f64();
                                                        }
                                                        let _e2955 = phi_4671_;
                                                        continue;
                                                        continuing {
                                                            phi_4667_ = _e2945;
                                                            phi_4670_ = _e2955;
                                                            break if !(_e2950);
                                                        }
                                                    }
                                                    let _e2960 = local_22;
                                                    phi_4724_ = (_e2960 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2966 = phi_4724_;
                                                let _e2968 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2975 = ((((((((select(_e2664, _e2645, (_e2645 > _e2664)) + _e2668) + (select(_e2707, _e2688, (_e2688 > _e2707)) + _e2711)) + (select(_e2750, _e2731, (_e2731 > _e2750)) + _e2754)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2762 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e817 * _e2966) * (f64(1f) + _e2968)));
                                                let _e2980 = (((_e2909 * _e2567[0]) + (_e2911 * _e2567[1])) + (_e2913 * _e2567[2]));
                                                let _e2985 = (((_e2909 * _e2583) + (_e2911 * _e2584)) + (_e2913 * _e2585));
                                                let _e2990 = (((_e2909 * (_e2567[0] - _e2579[0])) + (_e2911 * (_e2567[1] - _e2579[1]))) + (_e2913 * (_e2567[2] - _e2579[2])));
                                                let _e2995 = (((_e2909 * select((_e2583 - _e2579[0]), _e2567[0], _e2586)) + (_e2911 * select((_e2584 - _e2579[1]), _e2567[1], _e2586))) + (_e2913 * select((_e2585 - _e2579[2]), _e2567[2], _e2586)));
                                                let _e3001 = (((_e2909 * _e2598[0]) + (_e2911 * _e2598[1])) + (_e2913 * _e2598[2]));
                                                let _e3006 = (((_e2909 * _e2614) + (_e2911 * _e2615)) + (_e2913 * _e2616));
                                                let _e3011 = (((_e2909 * (_e2598[0] - _e2610[0])) + (_e2911 * (_e2598[1] - _e2610[1]))) + (_e2913 * (_e2598[2] - _e2610[2])));
                                                let _e3016 = (((_e2909 * select((_e2614 - _e2610[0]), _e2598[0], _e2617)) + (_e2911 * select((_e2615 - _e2610[1]), _e2598[1], _e2617))) + (_e2913 * select((_e2616 - _e2610[2]), _e2598[2], _e2617)));
                                                phi_4850_ = type_36(array<f64, 4>(_e2980, _e2985, _e2990, _e2995), array<f64, 4>(_e3001, _e3006, _e3011, _e3016), array<f64, 4>((_e2975 + ((select(_e2980, -(_e2980), (_e2980 < 0.0lf)) + select(_e3001, -(_e3001), (_e3001 < 0.0lf))) * _e2968)), (_e2975 + ((select(_e2985, -(_e2985), (_e2985 < 0.0lf)) + select(_e3006, -(_e3006), (_e3006 < 0.0lf))) * _e2968)), (_e2975 + ((select(_e2990, -(_e2990), (_e2990 < 0.0lf)) + select(_e3011, -(_e3011), (_e3011 < 0.0lf))) * _e2968)), (_e2975 + ((select(_e2995, -(_e2995), (_e2995 < 0.0lf)) + select(_e3016, -(_e3016), (_e3016 < 0.0lf))) * _e2968))));
                                                phi_4851_ = false;
                                            } else {
                                                phi_4850_ = type_36();
                                                phi_4851_ = true;
                                            }
                                            let _e3057 = phi_4850_;
                                            let _e3059 = phi_4851_;
                                            phi_4852_ = _e3057;
                                            phi_4853_ = _e3059;
                                        } else {
                                            phi_4852_ = type_36();
                                            phi_4853_ = true;
                                        }
                                        let _e3061 = phi_4852_;
                                        let _e3063 = phi_4853_;
                                        if _e3063 {
                                            let _e3064 = f64(0f);
                                            let _e3065 = f64(1f);
                                            phi_4863_ = type_36(array<f64, 4>(_e3064, _e3064, _e3064, _e3064), array<f64, 4>(_e3064, _e3064, _e3064, _e3064), array<f64, 4>(_e3065, _e3065, _e3065, _e3065));
                                        } else {
                                            phi_4863_ = _e3061;
                                        }
                                        let _e3071 = phi_4863_;
                                        local_1 = type_36(array<f64, 4>(_e3071.member[0], _e3071.member[1], _e3071.member[2], _e3071.member[3]), array<f64, 4>(_e3071.member_1[0], _e3071.member_1[1], _e3071.member_1[2], _e3071.member_1[3]), array<f64, 4>(_e3071.member_2[0], _e3071.member_2[1], _e3071.member_2[2], _e3071.member_2[3]));
                                        let _e3091 = (_e2781 - _e2787);
                                        let _e3093 = f64(0f);
                                        let _e3096 = local_1.member[0u];
                                        let _e3099 = local_1.member_1[0u];
                                        let _e3102 = local_1.member[0u];
                                        let _e3108 = local_1.member_2[0u];
                                        if (((_e3096 + ((_e3099 - _e3102) * _e2781)) - _e3108) > _e3093) {
                                            let _e3113 = local_1.member[1u];
                                            let _e3116 = local_1.member_1[1u];
                                            let _e3119 = local_1.member[1u];
                                            let _e3125 = local_1.member_2[1u];
                                            if (((_e3113 + ((_e3116 - _e3119) * _e2781)) - _e3125) > _e3093) {
                                                let _e3130 = local_1.member[2u];
                                                let _e3133 = local_1.member_1[2u];
                                                let _e3136 = local_1.member[2u];
                                                let _e3142 = local_1.member_2[2u];
                                                if (((_e3130 + ((_e3133 - _e3136) * _e2781)) - _e3142) > _e3093) {
                                                    let _e3147 = local_1.member[3u];
                                                    let _e3150 = local_1.member_1[3u];
                                                    let _e3153 = local_1.member[3u];
                                                    let _e3159 = local_1.member_2[3u];
                                                    phi_5035_ = (((_e3147 + ((_e3150 - _e3153) * _e2781)) - _e3159) > _e3093);
                                                    phi_5036_ = false;
                                                } else {
                                                    phi_5035_ = bool();
                                                    phi_5036_ = true;
                                                }
                                                let _e3163 = phi_5035_;
                                                let _e3165 = phi_5036_;
                                                phi_5037_ = _e3163;
                                                phi_5038_ = _e3165;
                                            } else {
                                                phi_5037_ = bool();
                                                phi_5038_ = true;
                                            }
                                            let _e3167 = phi_5037_;
                                            let _e3169 = phi_5038_;
                                            phi_5039_ = _e3167;
                                            phi_5040_ = _e3169;
                                        } else {
                                            phi_5039_ = bool();
                                            phi_5040_ = true;
                                        }
                                        let _e3171 = phi_5039_;
                                        let _e3173 = phi_5040_;
                                        if select(_e3171, false, _e3173) {
                                            if (_e2781 <= _e2783) {
                                                phi_5355_ = true;
                                            } else {
                                                let _e3176 = f64(0f);
                                                let _e3179 = local.member[0u];
                                                let _e3182 = local.member_1[0u];
                                                let _e3185 = local.member[0u];
                                                let _e3191 = local.member_2[0u];
                                                let _e3195 = local_1.member[0u];
                                                let _e3198 = local_1.member_1[0u];
                                                let _e3201 = local_1.member[0u];
                                                let _e3207 = local_1.member_2[0u];
                                                if ((((_e3179 + ((_e3182 - _e3185) * _e2781)) - _e3191) + ((_e3195 + ((_e3198 - _e3201) * _e2787)) - _e3207)) > _e3176) {
                                                    let _e3213 = local.member[1u];
                                                    let _e3216 = local.member_1[1u];
                                                    let _e3219 = local.member[1u];
                                                    let _e3225 = local.member_2[1u];
                                                    let _e3229 = local_1.member[1u];
                                                    let _e3232 = local_1.member_1[1u];
                                                    let _e3235 = local_1.member[1u];
                                                    let _e3241 = local_1.member_2[1u];
                                                    if ((((_e3213 + ((_e3216 - _e3219) * _e2781)) - _e3225) + ((_e3229 + ((_e3232 - _e3235) * _e2787)) - _e3241)) > _e3176) {
                                                        let _e3247 = local.member[2u];
                                                        let _e3250 = local.member_1[2u];
                                                        let _e3253 = local.member[2u];
                                                        let _e3259 = local.member_2[2u];
                                                        let _e3263 = local_1.member[2u];
                                                        let _e3266 = local_1.member_1[2u];
                                                        let _e3269 = local_1.member[2u];
                                                        let _e3275 = local_1.member_2[2u];
                                                        if ((((_e3247 + ((_e3250 - _e3253) * _e2781)) - _e3259) + ((_e3263 + ((_e3266 - _e3269) * _e2787)) - _e3275)) > _e3176) {
                                                            let _e3281 = local.member[3u];
                                                            let _e3284 = local.member_1[3u];
                                                            let _e3287 = local.member[3u];
                                                            let _e3293 = local.member_2[3u];
                                                            let _e3297 = local_1.member[3u];
                                                            let _e3300 = local_1.member_1[3u];
                                                            let _e3303 = local_1.member[3u];
                                                            let _e3309 = local_1.member_2[3u];
                                                            phi_5342_ = ((((_e3281 + ((_e3284 - _e3287) * _e2781)) - _e3293) + ((_e3297 + ((_e3300 - _e3303) * _e2787)) - _e3309)) > _e3176);
                                                            phi_5343_ = false;
                                                        } else {
                                                            phi_5342_ = bool();
                                                            phi_5343_ = true;
                                                        }
                                                        let _e3314 = phi_5342_;
                                                        let _e3316 = phi_5343_;
                                                        phi_5344_ = _e3314;
                                                        phi_5345_ = _e3316;
                                                    } else {
                                                        phi_5344_ = bool();
                                                        phi_5345_ = true;
                                                    }
                                                    let _e3318 = phi_5344_;
                                                    let _e3320 = phi_5345_;
                                                    phi_5346_ = _e3318;
                                                    phi_5347_ = _e3320;
                                                } else {
                                                    phi_5346_ = bool();
                                                    phi_5347_ = true;
                                                }
                                                let _e3322 = phi_5346_;
                                                let _e3324 = phi_5347_;
                                                phi_5355_ = select(_e3322, false, _e3324);
                                            }
                                            let _e3327 = phi_5355_;
                                            if _e3327 {
                                                if select(true, select(true, false, (_e2781 >= _e2548.member_1)), _e2789) {
                                                    local = type_36(array<f64, 4>(_e3071.member[0], _e3071.member[1], _e3071.member[2], _e3071.member[3]), array<f64, 4>(_e3071.member_1[0], _e3071.member_1[1], _e3071.member_1[2], _e3071.member_1[3]), array<f64, 4>(_e3071.member_2[0], _e3071.member_2[1], _e3071.member_2[2], _e3071.member_2[3]));
                                                    let _e3352 = local.member[0u];
                                                    let _e3355 = local.member_1[0u];
                                                    let _e3358 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e3355 > _e3358)), (_e3352 > _e3358)) {
                                                        let _e3363 = (_e3355 >= _e3352);
                                                        if _e3363 {
                                                            phi_5467_ = f64();
                                                            phi_5468_ = false;
                                                        } else {
                                                            if ((_e3352 - _e3355) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5465_ = (((_e3352 - _e3358) / (_e3352 - _e3355)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5466_ = false;
                                                            } else {
                                                                phi_5465_ = f64();
                                                                phi_5466_ = true;
                                                            }
                                                            let _e3377 = phi_5465_;
                                                            let _e3379 = phi_5466_;
                                                            phi_5467_ = _e3377;
                                                            phi_5468_ = _e3379;
                                                        }
                                                        let _e3381 = phi_5467_;
                                                        let _e3383 = phi_5468_;
                                                        phi_5469_ = _e3381;
                                                        phi_5470_ = _e3363;
                                                        phi_5471_ = _e3383;
                                                    } else {
                                                        phi_5469_ = f64();
                                                        phi_5470_ = true;
                                                        phi_5471_ = false;
                                                    }
                                                    let _e3385 = phi_5469_;
                                                    let _e3387 = phi_5470_;
                                                    let _e3389 = phi_5471_;
                                                    let _e3393 = select(_e3385, select(_e2781, f64(2f), _e3387), select(_e3389, true, _e3387));
                                                    let _e3396 = local.member[1u];
                                                    let _e3399 = local.member_1[1u];
                                                    let _e3402 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e3399 > _e3402)), (_e3396 > _e3402)) {
                                                        let _e3407 = (_e3399 >= _e3396);
                                                        if _e3407 {
                                                            phi_5539_ = f64();
                                                            phi_5540_ = false;
                                                        } else {
                                                            if ((_e3396 - _e3399) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5537_ = (((_e3396 - _e3402) / (_e3396 - _e3399)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5538_ = false;
                                                            } else {
                                                                phi_5537_ = f64();
                                                                phi_5538_ = true;
                                                            }
                                                            let _e3421 = phi_5537_;
                                                            let _e3423 = phi_5538_;
                                                            phi_5539_ = _e3421;
                                                            phi_5540_ = _e3423;
                                                        }
                                                        let _e3425 = phi_5539_;
                                                        let _e3427 = phi_5540_;
                                                        phi_5541_ = _e3425;
                                                        phi_5542_ = _e3407;
                                                        phi_5543_ = _e3427;
                                                    } else {
                                                        phi_5541_ = f64();
                                                        phi_5542_ = true;
                                                        phi_5543_ = false;
                                                    }
                                                    let _e3429 = phi_5541_;
                                                    let _e3431 = phi_5542_;
                                                    let _e3433 = phi_5543_;
                                                    let _e3437 = select(_e3429, select(_e2781, f64(2f), _e3431), select(_e3433, true, _e3431));
                                                    let _e3439 = select(_e3437, _e3393, (_e3393 < _e3437));
                                                    let _e3442 = local.member[2u];
                                                    let _e3445 = local.member_1[2u];
                                                    let _e3448 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3445 > _e3448)), (_e3442 > _e3448)) {
                                                        let _e3453 = (_e3445 >= _e3442);
                                                        if _e3453 {
                                                            phi_5616_ = f64();
                                                            phi_5617_ = false;
                                                        } else {
                                                            if ((_e3442 - _e3445) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5614_ = (((_e3442 - _e3448) / (_e3442 - _e3445)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5615_ = false;
                                                            } else {
                                                                phi_5614_ = f64();
                                                                phi_5615_ = true;
                                                            }
                                                            let _e3467 = phi_5614_;
                                                            let _e3469 = phi_5615_;
                                                            phi_5616_ = _e3467;
                                                            phi_5617_ = _e3469;
                                                        }
                                                        let _e3471 = phi_5616_;
                                                        let _e3473 = phi_5617_;
                                                        phi_5618_ = _e3471;
                                                        phi_5619_ = _e3453;
                                                        phi_5620_ = _e3473;
                                                    } else {
                                                        phi_5618_ = f64();
                                                        phi_5619_ = true;
                                                        phi_5620_ = false;
                                                    }
                                                    let _e3475 = phi_5618_;
                                                    let _e3477 = phi_5619_;
                                                    let _e3479 = phi_5620_;
                                                    let _e3483 = select(_e3475, select(_e2781, f64(2f), _e3477), select(_e3479, true, _e3477));
                                                    let _e3486 = local.member[3u];
                                                    let _e3489 = local.member_1[3u];
                                                    let _e3492 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3489 > _e3492)), (_e3486 > _e3492)) {
                                                        let _e3497 = (_e3489 >= _e3486);
                                                        if _e3497 {
                                                            phi_5688_ = f64();
                                                            phi_5689_ = false;
                                                        } else {
                                                            if ((_e3486 - _e3489) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5686_ = (((_e3486 - _e3492) / (_e3486 - _e3489)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5687_ = false;
                                                            } else {
                                                                phi_5686_ = f64();
                                                                phi_5687_ = true;
                                                            }
                                                            let _e3511 = phi_5686_;
                                                            let _e3513 = phi_5687_;
                                                            phi_5688_ = _e3511;
                                                            phi_5689_ = _e3513;
                                                        }
                                                        let _e3515 = phi_5688_;
                                                        let _e3517 = phi_5689_;
                                                        phi_5690_ = _e3515;
                                                        phi_5691_ = _e3497;
                                                        phi_5692_ = _e3517;
                                                    } else {
                                                        phi_5690_ = f64();
                                                        phi_5691_ = true;
                                                        phi_5692_ = false;
                                                    }
                                                    let _e3519 = phi_5690_;
                                                    let _e3521 = phi_5691_;
                                                    let _e3523 = phi_5692_;
                                                    let _e3527 = select(_e3519, select(_e2781, f64(2f), _e3521), select(_e3523, true, _e3521));
                                                    let _e3529 = select(_e3527, _e3483, (_e3483 < _e3527));
                                                    let _e3531 = select(_e3529, _e3439, (_e3439 < _e3529));
                                                    let _e3533 = select(_e2781, _e3531, (_e3531 > _e2781));
                                                    let _e3534 = (_e3533 > _e2548.member_1);
                                                    if _e3534 {
                                                        phi_6234_ = f64();
                                                        phi_6235_ = f64();
                                                        phi_6236_ = false;
                                                        phi_6237_ = false;
                                                    } else {
                                                        let _e3535 = (_e3533 - _e2781);
                                                        let _e3536 = (_e3535 <= _e2770);
                                                        let _e3539 = (_e3533 + (_e523 * f64(0.01f)));
                                                        let _e3541 = select(_e2548.member_1, _e3539, (_e3539 < _e2548.member_1));
                                                        if _e3536 {
                                                            if (_e817 > f64(0f)) {
                                                                let _e3546 = local_10.member[0u];
                                                                let _e3552 = local_10.member[1u];
                                                                let _e3568 = local_10.member_1[0u];
                                                                let _e3574 = local_10.member_1[1u];
                                                                let _e3590 = local_10.member_2[0u];
                                                                let _e3596 = local_10.member_2[1u];
                                                                let _e3610 = function_4(array<f64, 3>((_e3546[0] + ((_e3552[0] - _e3546[0]) * _e3541)), (_e3546[1] + ((_e3552[1] - _e3546[1]) * _e3541)), (_e3546[2] + ((_e3552[2] - _e3546[2]) * _e3541))), array<f64, 3>((_e3568[0] + ((_e3574[0] - _e3568[0]) * _e3541)), (_e3568[1] + ((_e3574[1] - _e3568[1]) * _e3541)), (_e3568[2] + ((_e3574[2] - _e3568[2]) * _e3541))), array<f64, 3>((_e3590[0] + ((_e3596[0] - _e3590[0]) * _e3541)), (_e3590[1] + ((_e3596[1] - _e3590[1]) * _e3541)), (_e3590[2] + ((_e3596[2] - _e3590[2]) * _e3541))), _e229.member);
                                                                let _e3621 = (((_e3610[0] * _e3610[0]) + (_e3610[1] * _e3610[1])) + (_e3610[2] * _e3610[2]));
                                                                if (_e3621 <= 2.2250738585072014e-308lf) {
                                                                    phi_5926_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3621 > 0.0lf));
                                                                } else {
                                                                    phi_5869_ = type_18(0i, 5i);
                                                                    phi_5872_ = bitcast<f64>(((bitcast<u64>(_e3621) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e3628 = phi_5869_;
                                                                        let _e3630 = phi_5872_;
                                                                        local_23 = _e3630;
                                                                        if (_e3628.member < _e3628.member_1) {
                                                                            let _e3637 = (_e3628.member + 1i);
                                                                            phi_5870_ = type_18(select(_e3637, type_19().member_1, select(false, true, ((false == (_e3637 > _e3628.member)) != false))), _e3628.member_1);
                                                                            phi_5913_ = type_19(1u, _e3628.member);
                                                                        } else {
                                                                            phi_5870_ = _e3628;
                                                                            phi_5913_ = type_19(0u, type_19().member_1);
                                                                        }
                                                                        let _e3648 = phi_5870_;
                                                                        let _e3650 = phi_5913_;
                                                                        let _e3653 = (bitcast<i32>(_e3650.member) != 0i);
                                                                        if _e3653 {
                                                                            phi_5873_ = (0.5lf * (_e3630 + (_e3621 / _e3630)));
                                                                        } else {
                                                                            phi_5873_ = f64();
                                                                        }
                                                                        let _e3658 = phi_5873_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_5869_ = _e3648;
                                                                            phi_5872_ = _e3658;
                                                                            break if !(_e3653);
                                                                        }
                                                                    }
                                                                    let _e3663 = local_23;
                                                                    phi_5926_ = (_e3663 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e3669 = phi_5926_;
                                                                let _e3677 = local_10.member[0u];
                                                                let _e3683 = select(_e3677[0], -(_e3677[0]), (_e3677[0] < 0.0lf));
                                                                let _e3686 = select(_e3677[1], -(_e3677[1]), (_e3677[1] < 0.0lf));
                                                                let _e3688 = select(_e3686, _e3683, (_e3683 > _e3686));
                                                                let _e3691 = select(_e3677[2], -(_e3677[2]), (_e3677[2] < 0.0lf));
                                                                let _e3693 = select(_e3691, _e3688, (_e3688 > _e3691));
                                                                let _e3696 = local_10.member[1u];
                                                                let _e3702 = select(_e3696[0], -(_e3696[0]), (_e3696[0] < 0.0lf));
                                                                let _e3705 = select(_e3696[1], -(_e3696[1]), (_e3696[1] < 0.0lf));
                                                                let _e3707 = select(_e3705, _e3702, (_e3702 > _e3705));
                                                                let _e3710 = select(_e3696[2], -(_e3696[2]), (_e3696[2] < 0.0lf));
                                                                let _e3712 = select(_e3710, _e3707, (_e3707 > _e3710));
                                                                let _e3716 = local_10.member_3;
                                                                let _e3720 = local_10.member_1[0u];
                                                                let _e3726 = select(_e3720[0], -(_e3720[0]), (_e3720[0] < 0.0lf));
                                                                let _e3729 = select(_e3720[1], -(_e3720[1]), (_e3720[1] < 0.0lf));
                                                                let _e3731 = select(_e3729, _e3726, (_e3726 > _e3729));
                                                                let _e3734 = select(_e3720[2], -(_e3720[2]), (_e3720[2] < 0.0lf));
                                                                let _e3736 = select(_e3734, _e3731, (_e3731 > _e3734));
                                                                let _e3739 = local_10.member_1[1u];
                                                                let _e3745 = select(_e3739[0], -(_e3739[0]), (_e3739[0] < 0.0lf));
                                                                let _e3748 = select(_e3739[1], -(_e3739[1]), (_e3739[1] < 0.0lf));
                                                                let _e3750 = select(_e3748, _e3745, (_e3745 > _e3748));
                                                                let _e3753 = select(_e3739[2], -(_e3739[2]), (_e3739[2] < 0.0lf));
                                                                let _e3755 = select(_e3753, _e3750, (_e3750 > _e3753));
                                                                let _e3759 = local_10.member_3;
                                                                let _e3763 = local_10.member_2[0u];
                                                                let _e3769 = select(_e3763[0], -(_e3763[0]), (_e3763[0] < 0.0lf));
                                                                let _e3772 = select(_e3763[1], -(_e3763[1]), (_e3763[1] < 0.0lf));
                                                                let _e3774 = select(_e3772, _e3769, (_e3769 > _e3772));
                                                                let _e3777 = select(_e3763[2], -(_e3763[2]), (_e3763[2] < 0.0lf));
                                                                let _e3779 = select(_e3777, _e3774, (_e3774 > _e3777));
                                                                let _e3782 = local_10.member_2[1u];
                                                                let _e3788 = select(_e3782[0], -(_e3782[0]), (_e3782[0] < 0.0lf));
                                                                let _e3791 = select(_e3782[1], -(_e3782[1]), (_e3782[1] < 0.0lf));
                                                                let _e3793 = select(_e3791, _e3788, (_e3788 > _e3791));
                                                                let _e3796 = select(_e3782[2], -(_e3782[2]), (_e3782[2] < 0.0lf));
                                                                let _e3798 = select(_e3796, _e3793, (_e3793 > _e3796));
                                                                let _e3802 = local_10.member_3;
                                                                let _e3810 = local_10.member_3;
                                                                phi_6203_ = select(true, false, (((_e3669 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e3712, _e3693, (_e3693 > _e3712)) + _e3716) + (select(_e3755, _e3736, (_e3736 > _e3755)) + _e3759)) + (select(_e3798, _e3779, (_e3779 > _e3798)) + _e3802)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3810 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e817));
                                                            } else {
                                                                phi_6203_ = true;
                                                            }
                                                            let _e3823 = phi_6203_;
                                                            phi_6204_ = _e3823;
                                                        } else {
                                                            phi_6204_ = true;
                                                        }
                                                        let _e3825 = phi_6204_;
                                                        if _e3825 {
                                                            if _e2789 {
                                                                let _e3829 = (_e3535 <= (_e2785 * f64(0.25f)));
                                                                phi_6231_ = select(select(select(f64(), f64(0f), _e3829), f64(), _e3536), (_e3091 + _e3091), select(select(true, false, _e3829), true, _e3536));
                                                            } else {
                                                                phi_6231_ = (_e2548.member_1 - _e2781);
                                                            }
                                                            let _e3838 = phi_6231_;
                                                            phi_6232_ = _e3838;
                                                            phi_6233_ = false;
                                                        } else {
                                                            phi_6232_ = f64();
                                                            phi_6233_ = true;
                                                        }
                                                        let _e3840 = phi_6232_;
                                                        let _e3842 = phi_6233_;
                                                        phi_6234_ = _e3840;
                                                        phi_6235_ = _e3535;
                                                        phi_6236_ = _e3825;
                                                        phi_6237_ = _e3842;
                                                    }
                                                    let _e3844 = phi_6234_;
                                                    let _e3846 = phi_6235_;
                                                    let _e3848 = phi_6236_;
                                                    let _e3850 = phi_6237_;
                                                    phi_6238_ = _e3533;
                                                    phi_6239_ = _e3844;
                                                    phi_6240_ = _e3846;
                                                    phi_6241_ = _e3533;
                                                    phi_6242_ = _e3848;
                                                    phi_6243_ = _e3534;
                                                    phi_6244_ = _e3850;
                                                    phi_6245_ = false;
                                                } else {
                                                    phi_6238_ = f64();
                                                    phi_6239_ = f64();
                                                    phi_6240_ = f64();
                                                    phi_6241_ = f64();
                                                    phi_6242_ = false;
                                                    phi_6243_ = false;
                                                    phi_6244_ = false;
                                                    phi_6245_ = true;
                                                }
                                                let _e3852 = phi_6238_;
                                                let _e3854 = phi_6239_;
                                                let _e3856 = phi_6240_;
                                                let _e3858 = phi_6241_;
                                                let _e3860 = phi_6242_;
                                                let _e3862 = phi_6243_;
                                                let _e3864 = phi_6244_;
                                                let _e3866 = phi_6245_;
                                                phi_6246_ = _e3852;
                                                phi_6247_ = _e3854;
                                                phi_6248_ = _e3856;
                                                phi_6249_ = _e3858;
                                                phi_6250_ = false;
                                                phi_6251_ = _e3860;
                                                phi_6252_ = _e3862;
                                                phi_6253_ = _e3864;
                                                phi_6254_ = _e3866;
                                            } else {
                                                phi_6246_ = f64();
                                                phi_6247_ = f64();
                                                phi_6248_ = f64();
                                                phi_6249_ = f64();
                                                phi_6250_ = true;
                                                phi_6251_ = false;
                                                phi_6252_ = false;
                                                phi_6253_ = false;
                                                phi_6254_ = false;
                                            }
                                            let _e3868 = phi_6246_;
                                            let _e3870 = phi_6247_;
                                            let _e3872 = phi_6248_;
                                            let _e3874 = phi_6249_;
                                            let _e3876 = phi_6250_;
                                            let _e3878 = phi_6251_;
                                            let _e3880 = phi_6252_;
                                            let _e3882 = phi_6253_;
                                            let _e3884 = phi_6254_;
                                            phi_6255_ = _e3868;
                                            phi_6256_ = _e3870;
                                            phi_6257_ = _e3872;
                                            phi_6258_ = _e3874;
                                            phi_6259_ = _e3876;
                                            phi_6260_ = _e3878;
                                            phi_6261_ = _e3880;
                                            phi_6262_ = _e3882;
                                            phi_6263_ = _e3884;
                                        } else {
                                            phi_6255_ = f64();
                                            phi_6256_ = f64();
                                            phi_6257_ = f64();
                                            phi_6258_ = f64();
                                            phi_6259_ = true;
                                            phi_6260_ = false;
                                            phi_6261_ = false;
                                            phi_6262_ = false;
                                            phi_6263_ = false;
                                        }
                                        let _e3886 = phi_6255_;
                                        let _e3888 = phi_6256_;
                                        let _e3890 = phi_6257_;
                                        let _e3892 = phi_6258_;
                                        let _e3894 = phi_6259_;
                                        let _e3896 = phi_6260_;
                                        let _e3898 = phi_6261_;
                                        let _e3900 = phi_6262_;
                                        let _e3902 = phi_6263_;
                                        if _e3894 {
                                            if (_e2781 <= _e2783) {
                                                let _e4060 = (_e2791 + 1u);
                                                let _e4061 = (_e4060 > 3u);
                                                phi_6603_ = _e4060;
                                                phi_6604_ = f64();
                                                phi_6605_ = false;
                                                phi_6606_ = select(true, false, _e4061);
                                                phi_6607_ = _e4061;
                                            } else {
                                                let _e3906 = local.member[0u];
                                                let _e3909 = local.member_1[0u];
                                                let _e3912 = local.member[0u];
                                                let _e3918 = local.member_2[0u];
                                                let _e3919 = ((_e3906 + ((_e3909 - _e3912) * _e2787)) - _e3918);
                                                let _e3922 = local.member[1u];
                                                let _e3925 = local.member_1[1u];
                                                let _e3928 = local.member[1u];
                                                let _e3934 = local.member_2[1u];
                                                let _e3935 = ((_e3922 + ((_e3925 - _e3928) * _e2787)) - _e3934);
                                                let _e3937 = select(_e3935, _e3919, (_e3919 < _e3935));
                                                let _e3940 = local.member[2u];
                                                let _e3943 = local.member_1[2u];
                                                let _e3946 = local.member[2u];
                                                let _e3952 = local.member_2[2u];
                                                let _e3953 = ((_e3940 + ((_e3943 - _e3946) * _e2787)) - _e3952);
                                                let _e3956 = local.member[3u];
                                                let _e3959 = local.member_1[3u];
                                                let _e3962 = local.member[3u];
                                                let _e3968 = local.member_2[3u];
                                                let _e3969 = ((_e3956 + ((_e3959 - _e3962) * _e2787)) - _e3968);
                                                let _e3971 = select(_e3969, _e3953, (_e3953 < _e3969));
                                                let _e3973 = select(_e3971, _e3937, (_e3937 < _e3971));
                                                let _e3976 = local_1.member[0u];
                                                let _e3979 = local_1.member_1[0u];
                                                let _e3982 = local_1.member[0u];
                                                let _e3988 = local_1.member_2[0u];
                                                let _e3989 = ((_e3976 + ((_e3979 - _e3982) * _e2781)) - _e3988);
                                                let _e3992 = local_1.member[1u];
                                                let _e3995 = local_1.member_1[1u];
                                                let _e3998 = local_1.member[1u];
                                                let _e4004 = local_1.member_2[1u];
                                                let _e4005 = ((_e3992 + ((_e3995 - _e3998) * _e2781)) - _e4004);
                                                let _e4007 = select(_e4005, _e3989, (_e3989 < _e4005));
                                                let _e4010 = local_1.member[2u];
                                                let _e4013 = local_1.member_1[2u];
                                                let _e4016 = local_1.member[2u];
                                                let _e4022 = local_1.member_2[2u];
                                                let _e4023 = ((_e4010 + ((_e4013 - _e4016) * _e2781)) - _e4022);
                                                let _e4026 = local_1.member[3u];
                                                let _e4029 = local_1.member_1[3u];
                                                let _e4032 = local_1.member[3u];
                                                let _e4038 = local_1.member_2[3u];
                                                let _e4039 = ((_e4026 + ((_e4029 - _e4032) * _e2781)) - _e4038);
                                                let _e4041 = select(_e4039, _e4023, (_e4023 < _e4039));
                                                let _e4043 = select(_e4041, _e4007, (_e4007 < _e4041));
                                                let _e4044 = f64(0.0625f);
                                                let _e4046 = f64(0.9f);
                                                if (_e4043 > f64(0f)) {
                                                    phi_6601_ = f64(0.5f);
                                                } else {
                                                    let _e4052 = (f64(0.95f) * (_e3973 / (_e3973 - _e4043)));
                                                    phi_6601_ = select(_e4044, select(_e4046, _e4052, (_e4052 < _e4046)), (_e4052 > _e4044));
                                                }
                                                let _e4058 = phi_6601_;
                                                phi_6603_ = u32();
                                                phi_6604_ = (_e3091 * _e4058);
                                                phi_6605_ = true;
                                                phi_6606_ = false;
                                                phi_6607_ = false;
                                            }
                                            let _e4064 = phi_6603_;
                                            let _e4066 = phi_6604_;
                                            let _e4068 = phi_6605_;
                                            let _e4070 = phi_6606_;
                                            let _e4072 = phi_6607_;
                                            phi_6608_ = _e4064;
                                            phi_6609_ = _e2783;
                                            phi_6610_ = _e4066;
                                            phi_6611_ = _e2785;
                                            phi_6612_ = _e2787;
                                            phi_6613_ = _e2789;
                                            phi_6614_ = _e2791;
                                            phi_6615_ = _e4068;
                                            phi_6616_ = _e4070;
                                            phi_6617_ = _e4072;
                                            phi_6618_ = false;
                                            phi_6619_ = false;
                                            phi_6620_ = false;
                                        } else {
                                            phi_6608_ = u32();
                                            phi_6609_ = _e3886;
                                            phi_6610_ = _e3888;
                                            phi_6611_ = _e3890;
                                            phi_6612_ = _e2781;
                                            phi_6613_ = true;
                                            phi_6614_ = 0u;
                                            phi_6615_ = _e3896;
                                            phi_6616_ = false;
                                            phi_6617_ = false;
                                            phi_6618_ = _e3898;
                                            phi_6619_ = _e3900;
                                            phi_6620_ = _e3902;
                                        }
                                        let _e4074 = phi_6608_;
                                        let _e4076 = phi_6609_;
                                        let _e4078 = phi_6610_;
                                        let _e4080 = phi_6611_;
                                        let _e4082 = phi_6612_;
                                        let _e4084 = phi_6613_;
                                        let _e4086 = phi_6614_;
                                        let _e4088 = phi_6615_;
                                        let _e4090 = phi_6616_;
                                        let _e4092 = phi_6617_;
                                        let _e4094 = phi_6618_;
                                        let _e4096 = phi_6619_;
                                        let _e4098 = phi_6620_;
                                        if _e4088 {
                                            let _e4099 = (_e4082 + _e4078);
                                            let _e4101 = select(_e4076, _e4099, (_e4099 > _e4076));
                                            let _e4103 = select(_e2548.member_1, _e4101, (_e4101 < _e2548.member_1));
                                            let _e4106 = select(((_e4103 - _e4082) > _e2770), true, !(_e2789));
                                            phi_6648_ = _e4103;
                                            phi_6649_ = _e4076;
                                            phi_6650_ = _e4080;
                                            phi_6651_ = _e4082;
                                            phi_6652_ = _e4084;
                                            phi_6653_ = _e4086;
                                            phi_6654_ = _e4106;
                                            phi_6655_ = select(true, false, _e4106);
                                            phi_6656_ = false;
                                            phi_6657_ = false;
                                            phi_6658_ = false;
                                            phi_6659_ = false;
                                        } else {
                                            phi_6648_ = _e2781;
                                            phi_6649_ = _e2783;
                                            phi_6650_ = _e2785;
                                            phi_6651_ = _e2787;
                                            phi_6652_ = _e2789;
                                            phi_6653_ = _e4074;
                                            phi_6654_ = _e4090;
                                            phi_6655_ = false;
                                            phi_6656_ = _e4092;
                                            phi_6657_ = _e4094;
                                            phi_6658_ = _e4096;
                                            phi_6659_ = _e4098;
                                        }
                                        let _e4109 = phi_6648_;
                                        let _e4111 = phi_6649_;
                                        let _e4113 = phi_6650_;
                                        let _e4115 = phi_6651_;
                                        let _e4117 = phi_6652_;
                                        let _e4119 = phi_6653_;
                                        let _e4121 = phi_6654_;
                                        let _e4123 = phi_6655_;
                                        let _e4125 = phi_6656_;
                                        let _e4127 = phi_6657_;
                                        let _e4129 = phi_6658_;
                                        let _e4131 = phi_6659_;
                                        phi_4438_ = _e4109;
                                        phi_4440_ = _e4111;
                                        phi_4442_ = _e4113;
                                        phi_4444_ = _e4115;
                                        phi_4446_ = _e4117;
                                        phi_4448_ = _e4119;
                                        phi_6660_ = _e4076;
                                        phi_6661_ = _e3892;
                                        phi_6662_ = _e4121;
                                        phi_6663_ = _e4123;
                                        phi_6664_ = _e4125;
                                        phi_6665_ = _e4127;
                                        phi_6666_ = _e4129;
                                        phi_6667_ = false;
                                        phi_6668_ = _e4131;
                                    } else {
                                        phi_4438_ = f64();
                                        phi_4440_ = f64();
                                        phi_4442_ = f64();
                                        phi_4444_ = f64();
                                        phi_4446_ = bool();
                                        phi_4448_ = u32();
                                        phi_6660_ = f64();
                                        phi_6661_ = f64();
                                        phi_6662_ = false;
                                        phi_6663_ = false;
                                        phi_6664_ = false;
                                        phi_6665_ = false;
                                        phi_6666_ = false;
                                        phi_6667_ = true;
                                        phi_6668_ = false;
                                    }
                                    let _e4133 = phi_4438_;
                                    let _e4135 = phi_4440_;
                                    let _e4137 = phi_4442_;
                                    let _e4139 = phi_4444_;
                                    let _e4141 = phi_4446_;
                                    let _e4143 = phi_4448_;
                                    let _e4145 = phi_6660_;
                                    let _e4147 = phi_6661_;
                                    let _e4149 = phi_6662_;
                                    let _e4151 = phi_6663_;
                                    let _e4153 = phi_6664_;
                                    let _e4155 = phi_6665_;
                                    let _e4157 = phi_6666_;
                                    let _e4159 = phi_6667_;
                                    let _e4161 = phi_6668_;
                                    local_24 = _e4151;
                                    local_25 = _e4153;
                                    local_26 = _e4151;
                                    local_27 = _e4155;
                                    local_28 = _e4151;
                                    local_29 = _e4157;
                                    local_30 = _e4151;
                                    local_31 = _e4159;
                                    local_32 = _e4151;
                                    local_33 = _e4161;
                                    local_35 = _e4151;
                                    local_36 = _e4147;
                                    local_37 = _e4145;
                                    continue;
                                    continuing {
                                        phi_4434_ = type_9(select(_e2779.member, (_e2779.member + 1u), _e2794), select(_e2779.member_1, _e2779.member_1, _e2794));
                                        phi_4437_ = _e4133;
                                        phi_4439_ = _e4135;
                                        phi_4441_ = _e4137;
                                        phi_4443_ = _e4139;
                                        phi_4445_ = _e4141;
                                        phi_4447_ = _e4143;
                                        break if !(_e4149);
                                    }
                                }
                                let _e4164 = local_24;
                                let _e4166 = local_25;
                                let _e4167 = select(_e4166, false, _e4164);
                                let _e4169 = local_26;
                                let _e4171 = local_27;
                                let _e4174 = local_28;
                                let _e4176 = local_29;
                                let _e4179 = local_30;
                                let _e4181 = local_31;
                                let _e4184 = local_32;
                                let _e4186 = local_33;
                                let _e4192 = local_34;
                                let _e4194 = select(select(_e4171, false, _e4169), false, _e4167);
                                let _e4197 = local_35;
                                let _e4204 = select(select(select(_e4176, false, _e4174), false, _e4167), false, _e4194);
                                let _e4210 = local_36;
                                let _e4212 = local_37;
                                let _e4214 = select(select(select(_e4197, false, _e4167), false, _e4194), true, _e4204);
                                let _e4219 = local_38;
                                let _e4221 = select(select(select(select(select(_e4181, false, _e4179), false, _e4167), false, _e4194), false, _e4204), true, _e4214);
                                let _e4228 = select(select(select(select(select(select(_e4186, false, _e4184), false, _e4167), false, _e4194), false, _e4204), false, _e4214), false, _e4221);
                                let _e4233 = select(select(select(select(select(_e4167, true, _e4194), false, _e4204), false, _e4214), false, _e4221), true, _e4228);
                                let _e4236 = (select(select(type_44().member, 1u, _e4221), select(select(select(type_44().member, 1u, _e4167), 0u, _e4194), 0u, _e4228), _e4233) != 0u);
                                phi_6736_ = select(select(type_44().member_1, select(_e4219, select(_e4212, _e4210, _e4204), _e4214), _e4221), select(select(select(type_44().member_1, _e4192, _e4167), type_44().member_1, _e4194), type_44().member_1, _e4228), _e4233);
                                phi_6737_ = select(true, false, _e4236);
                                phi_6738_ = _e4236;
                                phi_6739_ = false;
                                phi_6740_ = false;
                                phi_6741_ = false;
                            } else {
                                phi_6736_ = f64();
                                phi_6737_ = _e2556;
                                phi_6738_ = false;
                                phi_6739_ = _e2558;
                                phi_6740_ = _e2560;
                                phi_6741_ = _e2562;
                            }
                            let _e4239 = phi_6736_;
                            let _e4241 = phi_6737_;
                            let _e4243 = phi_6738_;
                            let _e4245 = phi_6739_;
                            let _e4247 = phi_6740_;
                            let _e4249 = phi_6741_;
                            phi_6742_ = _e2548;
                            phi_6743_ = _e2550;
                            phi_6744_ = _e4239;
                            phi_6745_ = _e2552;
                            phi_6746_ = _e4241;
                            phi_6747_ = _e4243;
                            phi_6748_ = false;
                            phi_6749_ = _e4245;
                            phi_6750_ = _e4247;
                            phi_6751_ = _e4249;
                        } else {
                            phi_6742_ = type_45();
                            phi_6743_ = bool();
                            phi_6744_ = f64();
                            phi_6745_ = type_45();
                            phi_6746_ = false;
                            phi_6747_ = false;
                            phi_6748_ = true;
                            phi_6749_ = false;
                            phi_6750_ = false;
                            phi_6751_ = false;
                        }
                        let _e4251 = phi_6742_;
                        let _e4253 = phi_6743_;
                        let _e4255 = phi_6744_;
                        let _e4257 = phi_6745_;
                        let _e4259 = phi_6746_;
                        let _e4261 = phi_6747_;
                        let _e4263 = phi_6748_;
                        let _e4265 = phi_6749_;
                        let _e4267 = phi_6750_;
                        let _e4269 = phi_6751_;
                        local_39 = _e4261;
                        local_40 = _e4253;
                        local_41 = _e4251;
                        local_42 = _e4255;
                        local_43 = _e4255;
                        local_44 = _e4255;
                        local_48 = _e4263;
                        local_49 = _e4265;
                        local_50 = _e4267;
                        local_51 = _e4269;
                        local_45 = _e4261;
                        local_46 = _e4257;
                        continue;
                        continuing {
                            phi_2384_ = type_9(select(_e1444.member, (_e1444.member + 1u), _e1447), select(_e1444.member_1, _e1444.member_1, _e1447));
                            break if !(_e4259);
                        }
                    }
                    let _e4272 = local_39;
                    if _e4272 {
                        let _e4274 = local_40;
                        if _e4274 {
                            let _e4276 = local_41;
                            let _e4279 = local_42;
                            let _e4281 = ((_e4276.member_1 - _e4279) <= _e1407);
                            let _e4286 = local_43;
                            phi_6767_ = type_44(select(type_44().member, 1u, _e4281), select(type_44().member_1, _e4286, _e4281));
                            phi_6768_ = select(true, false, _e4281);
                        } else {
                            phi_6767_ = type_44();
                            phi_6768_ = true;
                        }
                        let _e4291 = phi_6767_;
                        let _e4293 = phi_6768_;
                        let _e4298 = local_44;
                        phi_6774_ = type_44(select(_e4291.member, 2u, _e4293), select(_e4291.member_1, _e4298, _e4293));
                        phi_6775_ = false;
                        phi_6776_ = false;
                        phi_6777_ = false;
                        phi_6778_ = false;
                    } else {
                        phi_6774_ = type_44();
                        let _e4782 = local_48;
                        phi_6775_ = _e4782;
                        let _e4785 = local_49;
                        phi_6776_ = _e4785;
                        let _e4788 = local_50;
                        phi_6777_ = _e4788;
                        let _e4791 = local_51;
                        phi_6778_ = _e4791;
                    }
                    let _e4302 = phi_6774_;
                    let _e4304 = phi_6775_;
                    let _e4306 = phi_6776_;
                    let _e4308 = phi_6777_;
                    let _e4310 = phi_6778_;
                    let _e4317 = select(_e4306, false, _e4304);
                    let _e4321 = local_45;
                    let _e4328 = select(select(_e4308, false, _e4304), false, _e4317);
                    let _e4334 = select(select(select(_e4310, false, _e4304), false, _e4317), false, _e4328);
                    let _e4338 = local_46;
                    let _e4342 = select(select(_e4317, true, _e4328), true, _e4334);
                    phi_6820_ = type_44(select(_e4302.member, select(select(select(type_44().member, 0u, _e4317), 0u, _e4328), 1u, _e4334), _e4342), select(_e4302.member_1, select(select(select(type_44().member_1, type_44().member_1, _e4317), type_44().member_1, _e4328), _e4338.member, _e4334), _e4342));
                    phi_6821_ = type_44(select(type_44().member, 0u, _e4304), select(type_44().member_1, type_44().member_1, _e4304));
                    phi_6822_ = select(select(select(select(select(_e4321, false, _e4304), false, _e4317), false, _e4328), false, _e4334), true, _e4342);
                }
                let _e4353 = phi_6820_;
                let _e4355 = phi_6821_;
                let _e4357 = phi_6822_;
                let _e4360 = select(_e4355.member, _e4353.member, _e4357);
                let _e4363 = select(_e4355.member_1, _e4353.member_1, _e4357);
                let _e4369 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e4363 > _e532)), (_e4360 == 1u))));
                switch bitcast<i32>(_e4360) {
                    case 0: {
                        phi_6866_ = type_35(0u, _e4369, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4373 = function_1(_e4363);
                        phi_6866_ = type_35(0u, _e4369, _e4373, true);
                        break;
                    }
                    case 2: {
                        let _e4371 = function_1(_e4363);
                        phi_6866_ = type_35(1u, _e4369, _e4371, true);
                        break;
                    }
                    default: {
                        phi_6866_ = type_35();
                        break;
                    }
                }
                let _e4377 = phi_6866_;
                let _e4383 = select(true, false, (_e4377.member == 0u));
                if _e4377.member_3 {
                    if _e4383 {
                    } else {
                        let _e4389 = (_e4377.member_2[1] >> bitcast<u32>(20i));
                        if (_e4389 <= 896u) {
                            phi_6906_ = 0u;
                        } else {
                            phi_6906_ = ((((_e4389 - 896u) << bitcast<u32>(23i)) | ((_e4377.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e4377.member_2[0] >> bitcast<u32>(29i)));
                        }
                        let _e4404 = phi_6906_;
                        let _e4406 = atomicMin((&earliest.member[0u]), _e4404);
                    }
                }
                phi_6910_ = type_20(_e182, _e4377.member, _e197, _e200, _e4377.member_2, _e4377.member_1);
                phi_6911_ = select(false, select(_e4383, true, _e187), _e4377.member_3);
            } else {
                phi_6910_ = type_20(_e182, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_6911_ = false;
            }
            let _e4408 = phi_6910_;
            let _e4410 = phi_6911_;
            if (_e106 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4410 {
                let _e4414 = atomicAdd((&counters[0u]), 1u);
                phi_6922_ = _e4414;
            } else {
                phi_6922_ = 0u;
            }
            let _e4416 = phi_6922_;
            workgroupBarrier();
            if (_e106 == 0u) {
                let _e4419 = atomicLoad((&counters[0u]));
                if (_e4419 > 0u) {
                    let _e4422 = atomicAdd((&contacts.member[0u]), _e4419);
                    atomicStore((&counters[1u]), _e4422);
                }
            }
            workgroupBarrier();
            let _e4425 = atomicLoad((&counters[1u]));
            let _e4426 = (_e4425 + _e4416);
            if _e4410 {
                if _e187 {
                    let _e4429 = params.member.member_1.member_3;
                    if (_e4426 < _e4429) {
                        let _e4431 = (7u * _e4426);
                        atomicStore((&contacts.member[(4u + _e4431)]), _e4408.member);
                        atomicStore((&contacts.member[(_e4431 + 5u)]), _e4408.member_1);
                        atomicStore((&contacts.member[(_e4431 + 6u)]), _e4408.member_2);
                        atomicStore((&contacts.member[(_e4431 + 7u)]), _e4408.member_3);
                        atomicStore((&contacts.member[(_e4431 + 8u)]), _e4408.member_4[0]);
                        atomicStore((&contacts.member[(_e4431 + 9u)]), _e4408.member_4[1]);
                        atomicStore((&contacts.member[(_e4431 + 10u)]), _e4408.member_5);
                    }
                    phi_6982_ = false;
                } else {
                    phi_6982_ = true;
                }
                let _e4456 = phi_6982_;
                phi_6983_ = _e4456;
            } else {
                phi_6983_ = true;
            }
            let _e4458 = phi_6983_;
            if _e4458 {
                if _e4410 {
                    let _e4463 = params.member.member_2.member_1;
                    if (_e4426 < _e4463) {
                        let _e4465 = (2u * _e4426);
                        atomicStore((&contacts.member[(4u + _e4465)]), _e4408.member_2);
                        atomicStore((&contacts.member[(_e4465 + 5u)]), _e4408.member_3);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_437_ = type_9(select(_e159.member, (_e159.member + 1u), _e162), select(_e159.member_1, _e159.member_1, _e162));
            break if !(_e175);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
