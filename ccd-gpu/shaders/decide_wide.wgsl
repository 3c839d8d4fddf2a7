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

struct type_28 {
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
    member: type_32,
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

struct type_47 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(4) 
var<storage> input: type_13;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> positions: type_28;
@group(0) @binding(1) 
var<storage> paths: type_25;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_47;
@group(0) @binding(3) 
var<storage> elements: type_13;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_47;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_236_: f64;
    var phi_279_: f64;
    var phi_322_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_236_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_236_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_236_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_279_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_279_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_279_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_322_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_322_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_322_;
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
    var phi_7471_: array<array<f64, 3>, 4>;

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
        phi_7471_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e171)), (param_4[1] - (param_5[1] * _e171)), (param_4[2] - (param_5[2] * _e171))), array<f64, 3>((param_4[0] - (param_6[0] * _e215)), (param_4[1] - (param_6[1] * _e215)), (param_4[2] - (param_6[2] * _e215))), array<f64, 3>((_e9 - (param_6[0] * _e256)), (_e12 - (param_6[1] * _e256)), (_e15 - (param_6[2] * _e256))), array<f64, 3>((_e269 - (param_5[0] * _e303)), (_e272 - (param_5[1] * _e303)), (_e275 - (param_5[2] * _e303))));
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
        phi_7471_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e82)), (param_4[1] - (param_5[1] * _e82)), (param_4[2] - (param_5[2] * _e82))), array<f64, 3>((param_4[0] - (param_6[0] * _e126)), (param_4[1] - (param_6[1] * _e126)), (param_4[2] - (param_6[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_7471_;
    let _e319 = function_2(_e316[0], _e316[1]);
    let _e321 = function_2(_e319, _e316[2]);
    let _e323 = function_2(_e321, _e316[3]);
    return _e323;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_7070_: bool;
    var phi_7104_: array<f64, 3>;
    var phi_7105_: bool;
    var phi_7106_: array<f64, 3>;
    var phi_7107_: bool;
    var phi_7112_: array<f64, 3>;

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
        phi_7070_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_7070_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_7070_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_7104_ = array<f64, 3>((param_8[0] - ((param_9[0] * _e76) + (param_10[0] * _e80))), (param_8[1] - ((param_9[1] * _e76) + (param_10[1] * _e80))), (param_8[2] - ((param_9[2] * _e76) + (param_10[2] * _e80))));
            phi_7105_ = false;
        } else {
            phi_7104_ = array<f64, 3>();
            phi_7105_ = true;
        }
        let _e132 = phi_7104_;
        let _e134 = phi_7105_;
        phi_7106_ = _e132;
        phi_7107_ = _e134;
    } else {
        phi_7106_ = array<f64, 3>();
        phi_7107_ = true;
    }
    let _e136 = phi_7106_;
    let _e138 = phi_7107_;
    if _e138 {
        let _e139 = function_3(param_8, param_9, param_10, param_11);
        phi_7112_ = _e139;
    } else {
        phi_7112_ = _e136;
    }
    let _e141 = phi_7112_;
    return _e141;
}

fn function_5(param_12: ptr<function, type_39>, param_13: f64, param_14: f64, param_15: f64) -> bool {
    var phi_6945_: bool;
    var phi_6946_: bool;
    var phi_6951_: bool;

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
            phi_6945_ = select(bool(), ((_e45 > f64(0f)) == (_e72 > f64(0f))), _e87);
            phi_6946_ = select(true, false, _e87);
        } else {
            phi_6945_ = bool();
            phi_6946_ = true;
        }
        let _e96 = phi_6945_;
        let _e98 = phi_6946_;
        phi_6951_ = select(_e96, false, _e98);
    } else {
        phi_6951_ = false;
    }
    let _e101 = phi_6951_;
    return _e101;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_35;
    var local_1: type_35;
    var local_2: array<type_36, 4>;
    var local_3: array<f64, 4>;
    var local_4: array<f64, 2>;
    var local_5: type_39;
    var local_6: array<f64, 4>;
    var local_7: type_32;
    var phi_382_: u32;
    var phi_430_: u32;
    var phi_433_: type_9;
    var phi_588_: type_22;
    var phi_784_: type_30;
    var phi_945_: type_32;
    var phi_1218_: bool;
    var phi_1314_: type_41;
    var phi_1315_: bool;
    var phi_1316_: type_41;
    var phi_1317_: bool;
    var phi_1318_: type_41;
    var phi_1319_: bool;
    var phi_1324_: type_41;
    var phi_2064_: bool;
    var phi_2079_: f64;
    var phi_2155_: type_18;
    var phi_2158_: f64;
    var phi_2156_: type_18;
    var phi_2199_: type_19;
    var phi_2159_: f64;
    var local_8: f64;
    var phi_2212_: f64;
    var phi_2243_: type_9;
    var phi_2246_: u32;
    var phi_2313_: u32;
    var phi_2314_: u32;
    var phi_2247_: u32;
    var phi_2315_: u32;
    var phi_2373_: type_9;
    var phi_2533_: type_43;
    var phi_2534_: bool;
    var phi_2535_: type_43;
    var phi_2536_: bool;
    var phi_2571_: type_9;
    var phi_2574_: f64;
    var phi_2576_: f64;
    var phi_2578_: f64;
    var phi_2692_: bool;
    var phi_2699_: f64;
    var phi_2700_: bool;
    var phi_2575_: f64;
    var phi_2577_: f64;
    var phi_2579_: f64;
    var phi_2701_: f64;
    var phi_2702_: bool;
    var phi_2703_: bool;
    var local_9: bool;
    var local_10: f64;
    var local_11: f64;
    var phi_2708_: f64;
    var phi_2726_: type_9;
    var phi_2729_: f64;
    var phi_2795_: f64;
    var phi_2796_: bool;
    var phi_2797_: bool;
    var phi_2798_: bool;
    var phi_2799_: f64;
    var phi_2730_: f64;
    var phi_2800_: bool;
    var phi_2801_: bool;
    var phi_2802_: bool;
    var phi_2803_: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: f64;
    var phi_2817_: f64;
    var phi_2819_: type_43;
    var phi_3680_: array<type_36, 4>;
    var phi_3700_: type_9;
    var phi_3703_: bool;
    var phi_3704_: bool;
    var phi_3755_: bool;
    var phi_3756_: bool;
    var local_17: bool;
    var local_18: bool;
    var phi_3770_: u32;
    var phi_3771_: u32;
    var phi_3772_: bool;
    var phi_3803_: bool;
    var phi_3804_: bool;
    var phi_3805_: bool;
    var phi_3806_: bool;
    var phi_3807_: bool;
    var phi_3808_: bool;
    var phi_3809_: bool;
    var phi_3810_: bool;
    var phi_3811_: bool;
    var phi_3812_: bool;
    var phi_3813_: bool;
    var phi_3814_: bool;
    var phi_3815_: type_43;
    var phi_3816_: bool;
    var phi_3817_: type_43;
    var phi_3818_: bool;
    var phi_3819_: bool;
    var phi_3820_: bool;
    var phi_3821_: bool;
    var phi_3822_: type_43;
    var phi_3823_: bool;
    var phi_3824_: type_43;
    var phi_3825_: bool;
    var phi_3826_: bool;
    var phi_3827_: bool;
    var phi_3828_: bool;
    var phi_3829_: bool;
    var phi_3837_: type_43;
    var phi_3838_: bool;
    var phi_3839_: type_43;
    var phi_3840_: bool;
    var phi_3841_: bool;
    var phi_3842_: bool;
    var phi_3843_: bool;
    var phi_3844_: bool;
    var phi_4273_: type_9;
    var phi_4276_: f64;
    var phi_4278_: f64;
    var phi_4280_: f64;
    var phi_4282_: f64;
    var phi_4284_: bool;
    var phi_4286_: u32;
    var phi_4438_: array<f64, 3>;
    var phi_4506_: type_18;
    var phi_4509_: f64;
    var phi_4507_: type_18;
    var phi_4550_: type_19;
    var phi_4510_: f64;
    var local_19: f64;
    var phi_4563_: f64;
    var phi_4689_: type_35;
    var phi_4690_: bool;
    var phi_4691_: type_35;
    var phi_4692_: bool;
    var phi_4702_: type_35;
    var phi_4874_: bool;
    var phi_4875_: bool;
    var phi_4876_: bool;
    var phi_4877_: bool;
    var phi_4878_: bool;
    var phi_4879_: bool;
    var phi_5181_: bool;
    var phi_5182_: bool;
    var phi_5183_: bool;
    var phi_5184_: bool;
    var phi_5185_: bool;
    var phi_5186_: bool;
    var phi_5194_: bool;
    var phi_5304_: f64;
    var phi_5305_: bool;
    var phi_5306_: f64;
    var phi_5307_: bool;
    var phi_5308_: f64;
    var phi_5309_: bool;
    var phi_5310_: bool;
    var phi_5376_: f64;
    var phi_5377_: bool;
    var phi_5378_: f64;
    var phi_5379_: bool;
    var phi_5380_: f64;
    var phi_5381_: bool;
    var phi_5382_: bool;
    var phi_5453_: f64;
    var phi_5454_: bool;
    var phi_5455_: f64;
    var phi_5456_: bool;
    var phi_5457_: f64;
    var phi_5458_: bool;
    var phi_5459_: bool;
    var phi_5525_: f64;
    var phi_5526_: bool;
    var phi_5527_: f64;
    var phi_5528_: bool;
    var phi_5529_: f64;
    var phi_5530_: bool;
    var phi_5531_: bool;
    var phi_5708_: type_18;
    var phi_5711_: f64;
    var phi_5709_: type_18;
    var phi_5752_: type_19;
    var phi_5712_: f64;
    var local_20: f64;
    var phi_5765_: f64;
    var phi_6042_: bool;
    var phi_6043_: bool;
    var phi_6070_: f64;
    var phi_6071_: f64;
    var phi_6072_: bool;
    var phi_6073_: f64;
    var phi_6074_: f64;
    var phi_6075_: bool;
    var phi_6076_: bool;
    var phi_6077_: f64;
    var phi_6078_: f64;
    var phi_6079_: f64;
    var phi_6080_: f64;
    var phi_6081_: bool;
    var phi_6082_: bool;
    var phi_6083_: bool;
    var phi_6084_: bool;
    var phi_6085_: f64;
    var phi_6086_: f64;
    var phi_6087_: f64;
    var phi_6088_: f64;
    var phi_6089_: bool;
    var phi_6090_: bool;
    var phi_6091_: bool;
    var phi_6092_: bool;
    var phi_6093_: bool;
    var phi_6094_: f64;
    var phi_6095_: f64;
    var phi_6096_: f64;
    var phi_6097_: f64;
    var phi_6098_: bool;
    var phi_6099_: bool;
    var phi_6100_: bool;
    var phi_6101_: bool;
    var phi_6102_: bool;
    var phi_6440_: f64;
    var phi_6442_: u32;
    var phi_6443_: f64;
    var phi_6444_: bool;
    var phi_6445_: bool;
    var phi_6446_: bool;
    var phi_6447_: u32;
    var phi_6448_: f64;
    var phi_6449_: f64;
    var phi_6450_: f64;
    var phi_6451_: f64;
    var phi_6452_: bool;
    var phi_6453_: u32;
    var phi_6454_: bool;
    var phi_6455_: bool;
    var phi_6456_: bool;
    var phi_6457_: bool;
    var phi_6458_: bool;
    var phi_6459_: bool;
    var phi_6487_: f64;
    var phi_6488_: f64;
    var phi_6489_: f64;
    var phi_6490_: f64;
    var phi_6491_: bool;
    var phi_6492_: u32;
    var phi_6493_: bool;
    var phi_6494_: bool;
    var phi_6495_: bool;
    var phi_6496_: bool;
    var phi_6497_: bool;
    var phi_6498_: bool;
    var phi_4277_: f64;
    var phi_4279_: f64;
    var phi_4281_: f64;
    var phi_4283_: f64;
    var phi_4285_: bool;
    var phi_4287_: u32;
    var phi_6499_: f64;
    var phi_6500_: f64;
    var phi_6501_: bool;
    var phi_6502_: bool;
    var phi_6503_: bool;
    var phi_6504_: bool;
    var phi_6505_: bool;
    var phi_6506_: bool;
    var phi_6507_: bool;
    var local_21: bool;
    var local_22: bool;
    var local_23: bool;
    var local_24: bool;
    var local_25: bool;
    var local_26: bool;
    var local_27: bool;
    var local_28: bool;
    var local_29: bool;
    var local_30: bool;
    var local_31: f64;
    var local_32: bool;
    var local_33: f64;
    var local_34: f64;
    var local_35: f64;
    var phi_6575_: f64;
    var phi_6576_: bool;
    var phi_6577_: bool;
    var phi_6578_: bool;
    var phi_6579_: bool;
    var phi_6580_: bool;
    var phi_6581_: type_43;
    var phi_6582_: bool;
    var phi_6583_: f64;
    var phi_6584_: type_43;
    var phi_6585_: bool;
    var phi_6586_: bool;
    var phi_6587_: bool;
    var phi_6588_: bool;
    var phi_6589_: bool;
    var phi_6590_: bool;
    var local_36: bool;
    var local_37: bool;
    var local_38: type_43;
    var local_39: f64;
    var local_40: f64;
    var phi_6606_: type_42;
    var phi_6607_: bool;
    var local_41: f64;
    var phi_6613_: type_42;
    var phi_6614_: bool;
    var phi_6615_: bool;
    var phi_6616_: bool;
    var phi_6617_: bool;
    var local_42: bool;
    var local_43: type_43;
    var phi_6659_: type_42;
    var phi_6660_: type_42;
    var phi_6661_: bool;
    var phi_6705_: type_34;
    var phi_6706_: type_34;
    var phi_6707_: type_9;
    var phi_6753_: u32;
    var phi_6767_: u32;
    var phi_6827_: bool;
    var phi_6828_: bool;
    var local_44: u32;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e103 = id_2;
    let _e104 = n_2;
    let _e105 = lane_2;
    let _e117 = ((_e103.y * _e104.x) + _e103.x);
    let _e120 = (_e104.x * _e104.y);
    let _e123 = params.member.member_1.member_2;
    let _e125 = input.member[0u];
    let _e127 = select(_e125, _e123, (_e123 < _e125));
    let _e129 = params.member.member_1.member_1;
    if (_e127 > _e129) {
        let _e132 = params.member.member_1.member_1;
        phi_382_ = (_e127 - _e132);
    } else {
        phi_382_ = 0u;
    }
    let _e135 = phi_382_;
    let _e137 = params.member.member_1.member;
    let _e139 = select(_e135, _e137, (_e137 < _e135));
    let _e142 = params.member.member_2.member;
    let _e143 = (_e139 / 64u);
    let _e147 = select(_e143, (_e143 + 1u), ((_e139 % 64u) > 0u));
    if (_e147 > _e117) {
        let _e149 = (_e147 - _e117);
        if (_e120 == 0u) {
            return;
        }
        let _e151 = (_e149 / _e120);
        if (_e120 == 0u) {
            return;
        }
        phi_430_ = select(_e151, (_e151 + 1u), ((_e149 % _e120) > 0u));
    } else {
        phi_430_ = 0u;
    }
    let _e158 = phi_430_;
    phi_433_ = type_9(0u, _e158);
    loop {
        let _e161 = phi_433_;
        let _e164 = (_e161.member < _e161.member_1);
        let _e177 = (bitcast<i32>(select(0u, 1u, _e164)) != 0i);
        if _e177 {
            let _e181 = (((_e117 + (select(type_9().member_1, _e161.member, _e164) * _e120)) * 64u) + _e105);
            if (_e181 < _e139) {
                let _e185 = params.member.member_1.member_1;
                let _e187 = (2u * (_e185 + _e181));
                let _e190 = input.member[(4u + _e187)];
                let _e193 = input.member[(_e187 + 5u)];
                if (_e142 == 0u) {
                    let _e211 = (3u * _e193);
                    let _e213 = elements.member[_e211];
                    let _e216 = elements.member[(_e211 + 1u)];
                    let _e219 = elements.member[(_e211 + 2u)];
                    phi_588_ = type_22(0u, array<u32, 4>(_e190, _e213, _e216, _e219));
                } else {
                    let _e197 = (2u * _e190);
                    let _e198 = (2u * _e193);
                    let _e200 = elements.member[_e197];
                    let _e202 = elements.member[_e198];
                    let _e205 = elements.member[(_e197 + 1u)];
                    let _e208 = elements.member[(_e198 + 1u)];
                    phi_588_ = type_22(1u, array<u32, 4>(_e200, _e205, _e202, _e208));
                }
                let _e223 = phi_588_;
                let _e227 = params.member.member.member_1;
                if ((_e227 & 8u) != 0u) {
                    let _e271 = paths.member[_e223.member_1[0]];
                    let _e286 = paths.member[_e223.member_1[1]];
                    let _e301 = paths.member[_e223.member_1[2]];
                    let _e316 = paths.member[_e223.member_1[3]];
                    let _e337 = function_(array<f32, 3>(_e271.member.x, _e271.member.y, _e271.member.z));
                    let _e338 = function_(array<f32, 3>(_e286.member.x, _e286.member.y, _e286.member.z));
                    let _e339 = function_(array<f32, 3>(_e301.member.x, _e301.member.y, _e301.member.z));
                    let _e340 = function_(array<f32, 3>(_e316.member.x, _e316.member.y, _e316.member.z));
                    let _e342 = function_(array<f32, 3>(_e271.member_1.x, _e271.member_1.y, _e271.member_1.z));
                    let _e343 = function_(array<f32, 3>(_e286.member_1.x, _e286.member_1.y, _e286.member_1.z));
                    let _e344 = function_(array<f32, 3>(_e301.member_1.x, _e301.member_1.y, _e301.member_1.z));
                    let _e345 = function_(array<f32, 3>(_e316.member_1.x, _e316.member_1.y, _e316.member_1.z));
                    phi_784_ = type_30(array<array<f64, 3>, 4>(_e337, _e338, _e339, _e340), array<array<f64, 3>, 4>(_e342, _e343, _e344, _e345));
                } else {
                    let _e232 = positions.member[_e223.member_1[0]];
                    let _e235 = params.member.member.member[0u];
                    let _e238 = positions.member[(_e235 + _e223.member_1[0])];
                    let _e241 = positions.member[_e223.member_1[1]];
                    let _e244 = params.member.member.member[0u];
                    let _e247 = positions.member[(_e244 + _e223.member_1[1])];
                    let _e250 = positions.member[_e223.member_1[2]];
                    let _e253 = params.member.member.member[0u];
                    let _e256 = positions.member[(_e253 + _e223.member_1[2])];
                    let _e259 = positions.member[_e223.member_1[3]];
                    let _e262 = params.member.member.member[0u];
                    let _e265 = positions.member[(_e262 + _e223.member_1[3])];
                    phi_784_ = type_30(array<array<f64, 3>, 4>(_e232, _e241, _e250, _e259), array<array<f64, 3>, 4>(_e238, _e247, _e256, _e265));
                }
                let _e349 = phi_784_;
                if (_e223.member != 0u) {
                    phi_945_ = type_32(array<array<f64, 3>, 2>(array<f64, 3>((_e349.member[2][0] - _e349.member[0][0]), (_e349.member[2][1] - _e349.member[0][1]), (_e349.member[2][2] - _e349.member[0][2])), array<f64, 3>((_e349.member_1[2][0] - _e349.member_1[0][0]), (_e349.member_1[2][1] - _e349.member_1[0][1]), (_e349.member_1[2][2] - _e349.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e349.member[1][0] - _e349.member[0][0]), (_e349.member[1][1] - _e349.member[0][1]), (_e349.member[1][2] - _e349.member[0][2])), array<f64, 3>((_e349.member_1[1][0] - _e349.member_1[0][0]), (_e349.member_1[1][1] - _e349.member_1[0][1]), (_e349.member_1[1][2] - _e349.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e349.member[2][0] - _e349.member[3][0]), (_e349.member[2][1] - _e349.member[3][1]), (_e349.member[2][2] - _e349.member[3][2])), array<f64, 3>((_e349.member_1[2][0] - _e349.member_1[3][0]), (_e349.member_1[2][1] - _e349.member_1[3][1]), (_e349.member_1[2][2] - _e349.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_945_ = type_32(array<array<f64, 3>, 2>(array<f64, 3>((_e349.member[0][0] - _e349.member[1][0]), (_e349.member[0][1] - _e349.member[1][1]), (_e349.member[0][2] - _e349.member[1][2])), array<f64, 3>((_e349.member_1[0][0] - _e349.member_1[1][0]), (_e349.member_1[0][1] - _e349.member_1[1][1]), (_e349.member_1[0][2] - _e349.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e349.member[2][0] - _e349.member[1][0]), (_e349.member[2][1] - _e349.member[1][1]), (_e349.member[2][2] - _e349.member[1][2])), array<f64, 3>((_e349.member_1[2][0] - _e349.member_1[1][0]), (_e349.member_1[2][1] - _e349.member_1[1][1]), (_e349.member_1[2][2] - _e349.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e349.member[3][0] - _e349.member[1][0]), (_e349.member[3][1] - _e349.member[1][1]), (_e349.member[3][2] - _e349.member[1][2])), array<f64, 3>((_e349.member_1[3][0] - _e349.member_1[1][0]), (_e349.member_1[3][1] - _e349.member_1[1][1]), (_e349.member_1[3][2] - _e349.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e508 = phi_945_;
                let _e510 = params.member.member.member_14;
                let _e517 = bitcast<f64>(((u64(_e510[1]) * 4294967296lu) + u64(_e510[0])));
                let _e519 = params.member.member.member_15;
                let _e526 = bitcast<f64>(((u64(_e519[1]) * 4294967296lu) + u64(_e519[0])));
                let _e528 = params.member.member.member_16;
                let _e535 = bitcast<f64>(((u64(_e528[1]) * 4294967296lu) + u64(_e528[0])));
                let _e537 = params.member.member.member_16;
                let _e544 = bitcast<f64>(((u64(_e537[1]) * 4294967296lu) + u64(_e537[0])));
                let _e545 = f64(0f);
                let _e551 = select(_e508.member[0][0], -(_e508.member[0][0]), (_e508.member[0][0] < 0.0lf));
                let _e555 = select(_e508.member[0][1], -(_e508.member[0][1]), (_e508.member[0][1] < 0.0lf));
                let _e557 = select(_e555, _e551, (_e551 > _e555));
                let _e561 = select(_e508.member[0][2], -(_e508.member[0][2]), (_e508.member[0][2] < 0.0lf));
                let _e563 = select(_e561, _e557, (_e557 > _e561));
                let _e569 = select(_e508.member[1][0], -(_e508.member[1][0]), (_e508.member[1][0] < 0.0lf));
                let _e573 = select(_e508.member[1][1], -(_e508.member[1][1]), (_e508.member[1][1] < 0.0lf));
                let _e575 = select(_e573, _e569, (_e569 > _e573));
                let _e579 = select(_e508.member[1][2], -(_e508.member[1][2]), (_e508.member[1][2] < 0.0lf));
                let _e581 = select(_e579, _e575, (_e575 > _e579));
                let _e585 = (select(_e581, _e563, (_e563 > _e581)) + _e508.member_3);
                let _e591 = select(_e508.member_1[0][0], -(_e508.member_1[0][0]), (_e508.member_1[0][0] < 0.0lf));
                let _e595 = select(_e508.member_1[0][1], -(_e508.member_1[0][1]), (_e508.member_1[0][1] < 0.0lf));
                let _e597 = select(_e595, _e591, (_e591 > _e595));
                let _e601 = select(_e508.member_1[0][2], -(_e508.member_1[0][2]), (_e508.member_1[0][2] < 0.0lf));
                let _e603 = select(_e601, _e597, (_e597 > _e601));
                let _e609 = select(_e508.member_1[1][0], -(_e508.member_1[1][0]), (_e508.member_1[1][0] < 0.0lf));
                let _e613 = select(_e508.member_1[1][1], -(_e508.member_1[1][1]), (_e508.member_1[1][1] < 0.0lf));
                let _e615 = select(_e613, _e609, (_e609 > _e613));
                let _e619 = select(_e508.member_1[1][2], -(_e508.member_1[1][2]), (_e508.member_1[1][2] < 0.0lf));
                let _e621 = select(_e619, _e615, (_e615 > _e619));
                let _e625 = (select(_e621, _e603, (_e603 > _e621)) + _e508.member_3);
                let _e631 = select(_e508.member_2[0][0], -(_e508.member_2[0][0]), (_e508.member_2[0][0] < 0.0lf));
                let _e635 = select(_e508.member_2[0][1], -(_e508.member_2[0][1]), (_e508.member_2[0][1] < 0.0lf));
                let _e637 = select(_e635, _e631, (_e631 > _e635));
                let _e641 = select(_e508.member_2[0][2], -(_e508.member_2[0][2]), (_e508.member_2[0][2] < 0.0lf));
                let _e643 = select(_e641, _e637, (_e637 > _e641));
                let _e649 = select(_e508.member_2[1][0], -(_e508.member_2[1][0]), (_e508.member_2[1][0] < 0.0lf));
                let _e653 = select(_e508.member_2[1][1], -(_e508.member_2[1][1]), (_e508.member_2[1][1] < 0.0lf));
                let _e655 = select(_e653, _e649, (_e649 > _e653));
                let _e659 = select(_e508.member_2[1][2], -(_e508.member_2[1][2]), (_e508.member_2[1][2] < 0.0lf));
                let _e661 = select(_e659, _e655, (_e655 > _e659));
                let _e665 = (select(_e661, _e643, (_e643 > _e661)) + _e508.member_3);
                let _e667 = select(_e625, _e585, (_e585 > _e625));
                let _e669 = select(_e665, _e667, (_e667 > _e665));
                if (_e669 <= f64(65536f)) {
                    phi_1218_ = (_e669 >= f64((1f / 65536f)));
                } else {
                    phi_1218_ = false;
                }
                let _e676 = phi_1218_;
                if _e676 {
                    phi_1318_ = type_41();
                    phi_1319_ = true;
                } else {
                    if (_e669 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e669) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e683 = (9214364837600034816lu - (bitcast<u64>(_e669) & 9218868437227405312lu));
                            let _e686 = bitcast<f64>(select(4503599627370496lu, _e683, (_e683 > 4503599627370496lu)));
                            let _e687 = (_e545 * _e686);
                            phi_1314_ = type_41(type_32(array<array<f64, 3>, 2>(array<f64, 3>((_e508.member[0][0] * _e686), (_e508.member[0][1] * _e686), (_e508.member[0][2] * _e686)), array<f64, 3>((_e508.member[1][0] * _e686), (_e508.member[1][1] * _e686), (_e508.member[1][2] * _e686))), array<array<f64, 3>, 2>(array<f64, 3>((_e508.member_1[0][0] * _e686), (_e508.member_1[0][1] * _e686), (_e508.member_1[0][2] * _e686)), array<f64, 3>((_e508.member_1[1][0] * _e686), (_e508.member_1[1][1] * _e686), (_e508.member_1[1][2] * _e686))), array<array<f64, 3>, 2>(array<f64, 3>((_e508.member_2[0][0] * _e686), (_e508.member_2[0][1] * _e686), (_e508.member_2[0][2] * _e686)), array<f64, 3>((_e508.member_2[1][0] * _e686), (_e508.member_2[1][1] * _e686), (_e508.member_2[1][2] * _e686))), ((_e508.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e686)), select(_e687, select(2.2250738585072014e-308lf, _e687, (_e687 > 2.2250738585072014e-308lf)), (_e545 > f64(0f))));
                            phi_1315_ = false;
                        } else {
                            phi_1314_ = type_41();
                            phi_1315_ = true;
                        }
                        let _e758 = phi_1314_;
                        let _e760 = phi_1315_;
                        phi_1316_ = _e758;
                        phi_1317_ = _e760;
                    } else {
                        phi_1316_ = type_41();
                        phi_1317_ = true;
                    }
                    let _e762 = phi_1316_;
                    let _e764 = phi_1317_;
                    phi_1318_ = _e762;
                    phi_1319_ = _e764;
                }
                let _e766 = phi_1318_;
                let _e768 = phi_1319_;
                if _e768 {
                    phi_1324_ = type_41(_e508, _e545);
                } else {
                    phi_1324_ = _e766;
                }
                let _e771 = phi_1324_;
                local_7 = type_32(array<array<f64, 3>, 2>(array<f64, 3>(_e771.member.member[0][0], _e771.member.member[0][1], _e771.member.member[0][2]), array<f64, 3>(_e771.member.member[1][0], _e771.member.member[1][1], _e771.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e771.member.member_1[0][0], _e771.member.member_1[0][1], _e771.member.member_1[0][2]), array<f64, 3>(_e771.member.member_1[1][0], _e771.member.member_1[1][1], _e771.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e771.member.member_2[0][0], _e771.member.member_2[0][1], _e771.member.member_2[0][2]), array<f64, 3>(_e771.member.member_2[1][0], _e771.member.member_2[1][1], _e771.member.member_2[1][2])), _e771.member.member_3);
                let _e811 = f64(0f);
                let _e814 = local_7.member_1[0u];
                let _e820 = local_7.member_2[0u];
                let _e826 = ((_e814[1] * _e820[2]) - (_e814[2] * _e820[1]));
                let _e829 = ((_e814[2] * _e820[0]) - (_e814[0] * _e820[2]));
                let _e832 = ((_e814[0] * _e820[1]) - (_e814[1] * _e820[0]));
                let _e835 = local_7.member_1[1u];
                let _e841 = local_7.member_2[1u];
                let _e847 = ((_e835[1] * _e841[2]) - (_e835[2] * _e841[1]));
                let _e850 = ((_e835[2] * _e841[0]) - (_e835[0] * _e841[2]));
                let _e853 = ((_e835[0] * _e841[1]) - (_e835[1] * _e841[0]));
                let _e856 = local_7.member_1[0u];
                let _e862 = local_7.member_2[1u];
                let _e877 = local_7.member_1[1u];
                let _e883 = local_7.member_2[0u];
                let _e896 = (((_e856[1] * _e862[2]) - (_e856[2] * _e862[1])) + ((_e877[1] * _e883[2]) - (_e877[2] * _e883[1])));
                let _e897 = (((_e856[2] * _e862[0]) - (_e856[0] * _e862[2])) + ((_e877[2] * _e883[0]) - (_e877[0] * _e883[2])));
                let _e898 = (((_e856[0] * _e862[1]) - (_e856[1] * _e862[0])) + ((_e877[0] * _e883[1]) - (_e877[1] * _e883[0])));
                let _e901 = local_7.member[0u];
                let _e909 = (((_e901[0] * _e826) + (_e901[1] * _e829)) + (_e901[2] * _e832));
                let _e912 = local_7.member[1u];
                let _e923 = local_7.member[0u];
                let _e932 = ((((_e912[0] * _e826) + (_e912[1] * _e829)) + (_e912[2] * _e832)) + (((_e923[0] * _e896) + (_e923[1] * _e897)) + (_e923[2] * _e898)));
                let _e935 = local_7.member[0u];
                let _e946 = local_7.member[1u];
                let _e955 = ((((_e935[0] * _e847) + (_e935[1] * _e850)) + (_e935[2] * _e853)) + (((_e946[0] * _e896) + (_e946[1] * _e897)) + (_e946[2] * _e898)));
                let _e958 = local_7.member[1u];
                let _e966 = (((_e958[0] * _e847) + (_e958[1] * _e850)) + (_e958[2] * _e853));
                let _e969 = local_7.member[0u];
                let _e975 = select(_e969[0], -(_e969[0]), (_e969[0] < 0.0lf));
                let _e978 = select(_e969[1], -(_e969[1]), (_e969[1] < 0.0lf));
                let _e980 = select(_e978, _e975, (_e975 > _e978));
                let _e983 = select(_e969[2], -(_e969[2]), (_e969[2] < 0.0lf));
                let _e985 = select(_e983, _e980, (_e980 > _e983));
                let _e988 = local_7.member[1u];
                let _e994 = select(_e988[0], -(_e988[0]), (_e988[0] < 0.0lf));
                let _e997 = select(_e988[1], -(_e988[1]), (_e988[1] < 0.0lf));
                let _e999 = select(_e997, _e994, (_e994 > _e997));
                let _e1002 = select(_e988[2], -(_e988[2]), (_e988[2] < 0.0lf));
                let _e1004 = select(_e1002, _e999, (_e999 > _e1002));
                let _e1008 = local_7.member_3;
                let _e1009 = (select(_e1004, _e985, (_e985 > _e1004)) + _e1008);
                let _e1012 = local_7.member_1[0u];
                let _e1018 = select(_e1012[0], -(_e1012[0]), (_e1012[0] < 0.0lf));
                let _e1021 = select(_e1012[1], -(_e1012[1]), (_e1012[1] < 0.0lf));
                let _e1023 = select(_e1021, _e1018, (_e1018 > _e1021));
                let _e1026 = select(_e1012[2], -(_e1012[2]), (_e1012[2] < 0.0lf));
                let _e1028 = select(_e1026, _e1023, (_e1023 > _e1026));
                let _e1031 = local_7.member_1[1u];
                let _e1037 = select(_e1031[0], -(_e1031[0]), (_e1031[0] < 0.0lf));
                let _e1040 = select(_e1031[1], -(_e1031[1]), (_e1031[1] < 0.0lf));
                let _e1042 = select(_e1040, _e1037, (_e1037 > _e1040));
                let _e1045 = select(_e1031[2], -(_e1031[2]), (_e1031[2] < 0.0lf));
                let _e1047 = select(_e1045, _e1042, (_e1042 > _e1045));
                let _e1051 = local_7.member_3;
                let _e1052 = (select(_e1047, _e1028, (_e1028 > _e1047)) + _e1051);
                let _e1055 = local_7.member_2[0u];
                let _e1061 = select(_e1055[0], -(_e1055[0]), (_e1055[0] < 0.0lf));
                let _e1064 = select(_e1055[1], -(_e1055[1]), (_e1055[1] < 0.0lf));
                let _e1066 = select(_e1064, _e1061, (_e1061 > _e1064));
                let _e1069 = select(_e1055[2], -(_e1055[2]), (_e1055[2] < 0.0lf));
                let _e1071 = select(_e1069, _e1066, (_e1066 > _e1069));
                let _e1074 = local_7.member_2[1u];
                let _e1080 = select(_e1074[0], -(_e1074[0]), (_e1074[0] < 0.0lf));
                let _e1083 = select(_e1074[1], -(_e1074[1]), (_e1074[1] < 0.0lf));
                let _e1085 = select(_e1083, _e1080, (_e1080 > _e1083));
                let _e1088 = select(_e1074[2], -(_e1074[2]), (_e1074[2] < 0.0lf));
                let _e1090 = select(_e1088, _e1085, (_e1085 > _e1088));
                let _e1094 = local_7.member_3;
                let _e1095 = (select(_e1090, _e1071, (_e1071 > _e1090)) + _e1094);
                let _e1096 = f64(1f);
                let _e1097 = f64(8f);
                let _e1099 = ((_e1052 * _e1097) * _e1095);
                let _e1107 = local_7.member_3;
                let _e1134 = ((select(_e826, -(_e826), (_e826 < 0.0lf)) + select(_e829, -(_e829), (_e829 < 0.0lf))) + select(_e832, -(_e832), (_e832 < 0.0lf)));
                let _e1145 = ((select(_e847, -(_e847), (_e847 < 0.0lf)) + select(_e850, -(_e850), (_e850 < 0.0lf))) + select(_e853, -(_e853), (_e853 < 0.0lf)));
                let _e1147 = select(_e1145, _e1134, (_e1134 > _e1145));
                let _e1159 = (((select(_e896, -(_e896), (_e896 < 0.0lf)) + select(_e897, -(_e897), (_e897 < 0.0lf))) + select(_e898, -(_e898), (_e898 < 0.0lf))) * f64(0.5f));
                let _e1167 = local_7.member_3;
                let _e1181 = (((((_e1009 * _e1097) * _e1099) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1107 * f64(19f)) * ((_e1009 * (_e1052 + _e1095)) + (_e1052 * _e1095)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1096 + _e1009) * ((_e1096 + _e1052) * (_e1096 + _e1095)))));
                let _e1182 = f64(3f);
                let _e1183 = (_e909 * _e1182);
                let _e1184 = (_e966 * _e1182);
                let _e1186 = select(_e1184, _e1183, (_e1183 < _e1184));
                let _e1188 = select(_e955, _e932, (_e932 < _e955));
                let _e1190 = select(_e1188, _e1186, (_e1186 < _e1188));
                let _e1192 = select(_e1184, _e1183, (_e1183 > _e1184));
                let _e1194 = select(_e955, _e932, (_e932 > _e955));
                let _e1202 = -(select(_e1194, _e1192, (_e1192 > _e1194)));
                if ((select(_e1202, _e1190, (_e1190 > _e1202)) - (_e1181 + ((_e811 * (((select(_e1159, _e1147, (_e1147 > _e1159)) + (_e1099 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1167 * f64(6f)) * (_e1052 + _e1095))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1096 + _e1052) * (_e1096 + _e1095))))) * f64((3f * 1.0001f))))) > _e811) {
                    phi_6659_ = type_42(0u, type_42().member_1);
                    phi_6660_ = type_42();
                    phi_6661_ = true;
                } else {
                    let _e1211 = select(_e909, -(_e909), (_e909 < 0.0lf));
                    let _e1214 = select(_e932, -(_e932), (_e932 < 0.0lf));
                    let _e1216 = select(_e1214, _e1211, (_e1211 > _e1214));
                    let _e1219 = select(_e955, -(_e955), (_e955 < 0.0lf));
                    let _e1222 = select(_e966, -(_e966), (_e966 < 0.0lf));
                    let _e1224 = select(_e1222, _e1219, (_e1219 > _e1222));
                    let _e1226 = select(_e1224, _e1216, (_e1216 > _e1224));
                    let _e1228 = (2.2250738585072014e-308lf * f64(67108864f));
                    let _e1229 = f64(1f);
                    if (_e1226 >= _e1228) {
                        phi_2064_ = (_e1226 <= (_e1229 / _e1228));
                    } else {
                        phi_2064_ = false;
                    }
                    let _e1234 = phi_2064_;
                    if _e1234 {
                        phi_2079_ = (_e1229 / _e1226);
                    } else {
                        phi_2079_ = f64(0f);
                    }
                    let _e1244 = phi_2079_;
                    let _e1245 = f64(0.00000000000022737368f);
                    let _e1247 = (_e517 * f64(0.0625f));
                    local_5 = type_39(array<f64, 4>(_e909, _e932, _e955, _e966), ((_e1181 * f64(0.34f)) + (_e1226 * select(f64(2f), (1.1102230246251565e-16lf * f64(256f)), _e1234))), _e1244, select(_e1247, _e1245, (_e1245 < _e1247)));
                    let _e1252 = f64(0f);
                    let _e1253 = f64(1f);
                    let _e1254 = f64(3f);
                    let _e1257 = local_5.member[0u];
                    let _e1260 = local_5.member[1u];
                    let _e1263 = local_5.member[2u];
                    let _e1266 = local_5.member[3u];
                    let _e1273 = local_5.member_2;
                    let _e1274 = ((_e1260 - (_e1254 * _e1257)) * _e1273);
                    let _e1276 = local_5.member_2;
                    let _e1277 = ((_e1263 - _e1260) * _e1276);
                    let _e1279 = local_5.member_2;
                    let _e1280 = (((_e1254 * _e1266) - _e1263) * _e1279);
                    local_3[0u] = _e1252;
                    local_3[1u] = _e1253;
                    local_3[2u] = _e1253;
                    local_3[3u] = _e1253;
                    let _e1287 = ((_e1277 * _e1277) - (_e1274 * _e1280));
                    if (_e1287 > _e1252) {
                        if (_e1287 <= 2.2250738585072014e-308lf) {
                            phi_2212_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1287 > 0.0lf));
                        } else {
                            phi_2155_ = type_18(0i, 5i);
                            phi_2158_ = bitcast<f64>(((bitcast<u64>(_e1287) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1295 = phi_2155_;
                                let _e1297 = phi_2158_;
                                local_8 = _e1297;
                                if (_e1295.member < _e1295.member_1) {
                                    let _e1304 = (_e1295.member + 1i);
                                    phi_2156_ = type_18(select(_e1304, type_19().member_1, select(false, true, ((false == (_e1304 > _e1295.member)) != false))), _e1295.member_1);
                                    phi_2199_ = type_19(1u, _e1295.member);
                                } else {
                                    phi_2156_ = _e1295;
                                    phi_2199_ = type_19(0u, type_19().member_1);
                                }
                                let _e1315 = phi_2156_;
                                let _e1317 = phi_2199_;
                                let _e1320 = (bitcast<i32>(_e1317.member) != 0i);
                                if _e1320 {
                                    phi_2159_ = (0.5lf * (_e1297 + (_e1287 / _e1297)));
                                } else {
                                    phi_2159_ = f64();
                                }
                                let _e1325 = phi_2159_;
                                continue;
                                continuing {
                                    phi_2155_ = _e1315;
                                    phi_2158_ = _e1325;
                                    break if !(_e1320);
                                }
                            }
                            let _e1330 = local_8;
                            phi_2212_ = (_e1330 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1336 = phi_2212_;
                        let _e1341 = -((_e1277 + select(_e1336, -(_e1336), (_e1277 < _e1252))));
                        local_4[0u] = (_e1341 / (_e1341 + _e1280));
                        local_4[1u] = (_e1274 / (_e1274 + _e1341));
                        let _e1350 = local_4[1u];
                        let _e1351 = local_4[0u];
                        if (_e1350 < _e1351) {
                            let _e1354 = local_4[1u];
                            let _e1356 = local_4[0u];
                            local_4[0u] = _e1354;
                            local_4[1u] = _e1356;
                        }
                        phi_2243_ = type_9(0u, 2u);
                        phi_2246_ = 1u;
                        loop {
                            let _e1360 = phi_2243_;
                            let _e1362 = phi_2246_;
                            local_44 = _e1362;
                            let _e1365 = (_e1360.member < _e1360.member_1);
                            let _e1376 = select(type_9().member_1, _e1360.member, _e1365);
                            let _e1378 = (bitcast<i32>(select(0u, 1u, _e1365)) != 0i);
                            if _e1378 {
                                let _e1380 = local_4[_e1376];
                                if (_e1380 > _e1252) {
                                    let _e1383 = local_4[_e1376];
                                    if (_e1383 < _e1253) {
                                        let _e1386 = local_4[_e1376];
                                        local_3[_e1362] = _e1386;
                                        phi_2313_ = (_e1362 + 1u);
                                    } else {
                                        phi_2313_ = _e1362;
                                    }
                                    let _e1390 = phi_2313_;
                                    phi_2314_ = _e1390;
                                } else {
                                    phi_2314_ = _e1362;
                                }
                                let _e1392 = phi_2314_;
                                phi_2247_ = _e1392;
                            } else {
                                phi_2247_ = u32();
                            }
                            let _e1394 = phi_2247_;
                            continue;
                            continuing {
                                phi_2243_ = type_9(select(_e1360.member, (_e1360.member + 1u), _e1365), select(_e1360.member_1, _e1360.member_1, _e1365));
                                phi_2246_ = _e1394;
                                break if !(_e1378);
                            }
                        }
                        let _e4412 = local_44;
                        phi_2315_ = _e4412;
                    } else {
                        phi_2315_ = 1u;
                    }
                    let _e1397 = phi_2315_;
                    local_3[_e1397] = _e1253;
                    let _e1399 = local_3;
                    local_6 = _e1399;
                    let _e1401 = (_e517 * f64(0.99f));
                    let _e1403 = (f64(1f) - _e526);
                    let _e1406 = local_5.member[0u];
                    let _e1409 = local_5.member[1u];
                    let _e1412 = local_5.member[2u];
                    let _e1415 = local_5.member[3u];
                    let _e1426 = ((((_e1406 * _e1403) + (_e1409 * _e526)) * (_e1403 * _e1403)) + (((_e1412 * _e1403) + (_e1415 * _e526)) * (_e526 * _e526)));
                    let _e1431 = local_5.member_1;
                    phi_2373_ = type_9(select(1u, 0u, !((select(_e1426, -(_e1426), (_e1426 < 0.0lf)) > _e1431))), (_e1397 + 1u));
                    loop {
                        let _e1438 = phi_2373_;
                        let _e1441 = (_e1438.member < _e1438.member_1);
                        let _e1452 = select(type_9().member_1, _e1438.member, _e1441);
                        if (bitcast<i32>(select(0u, 1u, _e1441)) != 0i) {
                            if (_e1452 > 0u) {
                                let _e1459 = local_6[(_e1452 - 1u)];
                                let _e1461 = select(_e526, _e1459, (_e1459 > _e526));
                                let _e1463 = local_6[_e1452];
                                let _e1465 = select(_e535, _e1463, (_e1463 < _e535));
                                if (_e1461 <= _e1465) {
                                    let _e1467 = function_5((&local_5), _e544, _e1461, _e1465);
                                    if _e1467 {
                                        phi_3815_ = type_43();
                                        phi_3816_ = bool();
                                        phi_3817_ = type_43();
                                        phi_3818_ = false;
                                        phi_3819_ = false;
                                        phi_3820_ = false;
                                        phi_3821_ = false;
                                    } else {
                                        let _e1469 = (f64(1f) - _e1461);
                                        let _e1472 = local_5.member[0u];
                                        let _e1475 = local_5.member[1u];
                                        let _e1478 = local_5.member[2u];
                                        let _e1481 = local_5.member[3u];
                                        let _e1492 = ((((_e1472 * _e1469) + (_e1475 * _e1461)) * (_e1469 * _e1469)) + (((_e1478 * _e1469) + (_e1481 * _e1461)) * (_e1461 * _e1461)));
                                        let _e1494 = (f64(1f) - _e1465);
                                        let _e1497 = local_5.member[0u];
                                        let _e1500 = local_5.member[1u];
                                        let _e1503 = local_5.member[2u];
                                        let _e1506 = local_5.member[3u];
                                        let _e1517 = ((((_e1497 * _e1494) + (_e1500 * _e1465)) * (_e1494 * _e1494)) + (((_e1503 * _e1494) + (_e1506 * _e1465)) * (_e1465 * _e1465)));
                                        let _e1522 = local_5.member_1;
                                        let _e1523 = (select(_e1492, -(_e1492), (_e1492 < 0.0lf)) > _e1522);
                                        let _e1528 = local_5.member_1;
                                        let _e1529 = (select(_e1517, -(_e1517), (_e1517 < 0.0lf)) > _e1528);
                                        let _e1530 = f64(0f);
                                        let _e1538 = select(select(bool(), select(bool(), ((_e1492 > _e1530) != (_e1517 > _e1530)), _e1529), _e1523), false, select(true, select(true, false, _e1529), _e1523));
                                        if _e1523 {
                                            if _e1529 {
                                                phi_2533_ = type_43(select(f64(1f), type_43().member, _e1538), select(_e1530, type_43().member_1, _e1538), select(_e1538, type_43().member_2, _e1538));
                                                phi_2534_ = _e1538;
                                            } else {
                                                phi_2533_ = type_43();
                                                phi_2534_ = true;
                                            }
                                            let _e1548 = phi_2533_;
                                            let _e1550 = phi_2534_;
                                            phi_2535_ = _e1548;
                                            phi_2536_ = _e1550;
                                        } else {
                                            phi_2535_ = type_43();
                                            phi_2536_ = true;
                                        }
                                        let _e1552 = phi_2535_;
                                        let _e1554 = phi_2536_;
                                        if _e1554 {
                                            if _e1523 {
                                                let _e1558 = select(f64(1f), f64(-1f), (_e1492 < _e1530));
                                                let _e1560 = local_5.member_3;
                                                let _e1561 = f64(0.5f);
                                                let _e1562 = f64(3f);
                                                let _e1565 = local_5.member[0u];
                                                let _e1568 = local_5.member[1u];
                                                let _e1571 = local_5.member[2u];
                                                let _e1574 = local_5.member[3u];
                                                let _e1577 = (_e1571 - _e1568);
                                                phi_2571_ = type_9(0u, 64u);
                                                phi_2574_ = _e1465;
                                                phi_2576_ = _e1461;
                                                phi_2578_ = (_e1561 * (_e1461 + _e1465));
                                                loop {
                                                    let _e1583 = phi_2571_;
                                                    let _e1585 = phi_2574_;
                                                    let _e1587 = phi_2576_;
                                                    let _e1589 = phi_2578_;
                                                    local_11 = _e1587;
                                                    let _e1592 = (_e1583.member < _e1583.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1592)) != 0i) {
                                                        let _e1605 = (f64(1f) - _e1589);
                                                        let _e1608 = local_5.member[0u];
                                                        let _e1611 = local_5.member[1u];
                                                        let _e1614 = local_5.member[2u];
                                                        let _e1617 = local_5.member[3u];
                                                        let _e1631 = local_5.member_1;
                                                        let _e1632 = ((_e1558 * ((((_e1608 * _e1605) + (_e1611 * _e1589)) * (_e1605 * _e1605)) + (((_e1614 * _e1605) + (_e1617 * _e1589)) * (_e1589 * _e1589)))) - _e1631);
                                                        let _e1634 = (_e1632 > f64(0f));
                                                        let _e1635 = select(_e1589, _e1585, _e1634);
                                                        let _e1636 = select(_e1587, _e1589, _e1634);
                                                        let _e1638 = ((_e1635 - _e1636) > _e1560);
                                                        if _e1638 {
                                                            let _e1640 = (f64(1f) - _e1589);
                                                            let _e1652 = (-(_e1632) / (_e1558 * (((((_e1568 - (_e1562 * _e1565)) * _e1640) + (_e1577 * _e1589)) * _e1640) + (((_e1577 * _e1640) + (((_e1562 * _e1574) - _e1571) * _e1589)) * _e1589))));
                                                            let _e1660 = ((_e1589 + _e1652) + select(-((_e1561 * _e1560)), (_e1561 * _e1560), (_e1632 > f64(0f))));
                                                            if (_e1660 > _e1636) {
                                                                phi_2692_ = select(true, select(true, false, (select(_e1652, -(_e1652), (_e1652 < 0.0lf)) < (_e1561 * (_e1635 - _e1636)))), (_e1660 < _e1635));
                                                            } else {
                                                                phi_2692_ = true;
                                                            }
                                                            let _e1672 = phi_2692_;
                                                            phi_2699_ = select(_e1660, (_e1561 * (_e1636 + _e1635)), _e1672);
                                                            phi_2700_ = false;
                                                        } else {
                                                            phi_2699_ = f64();
                                                            phi_2700_ = true;
                                                        }
                                                        let _e1677 = phi_2699_;
                                                        let _e1679 = phi_2700_;
                                                        phi_2575_ = _e1635;
                                                        phi_2577_ = _e1636;
                                                        phi_2579_ = _e1677;
                                                        phi_2701_ = _e1636;
                                                        phi_2702_ = _e1638;
                                                        phi_2703_ = _e1679;
                                                    } else {
                                                        phi_2575_ = f64();
                                                        phi_2577_ = f64();
                                                        phi_2579_ = f64();
                                                        phi_2701_ = f64();
                                                        phi_2702_ = false;
                                                        phi_2703_ = false;
                                                    }
                                                    let _e1681 = phi_2575_;
                                                    let _e1683 = phi_2577_;
                                                    let _e1685 = phi_2579_;
                                                    let _e1687 = phi_2701_;
                                                    let _e1689 = phi_2702_;
                                                    let _e1691 = phi_2703_;
                                                    local_9 = _e1691;
                                                    local_10 = _e1687;
                                                    continue;
                                                    continuing {
                                                        phi_2571_ = type_9(select(_e1583.member, (_e1583.member + 1u), _e1592), select(_e1583.member_1, _e1583.member_1, _e1592));
                                                        phi_2574_ = _e1681;
                                                        phi_2576_ = _e1683;
                                                        phi_2578_ = _e1685;
                                                        break if !(_e1689);
                                                    }
                                                }
                                                let _e1694 = local_9;
                                                let _e1696 = local_10;
                                                let _e1698 = local_11;
                                                phi_2708_ = select(_e1698, _e1696, _e1694);
                                            } else {
                                                phi_2708_ = _e1461;
                                            }
                                            let _e1701 = phi_2708_;
                                            if _e1529 {
                                                let _e1707 = local_5.member_3;
                                                let _e1709 = local_5.member_3;
                                                phi_2726_ = type_9(0u, 64u);
                                                phi_2729_ = (_e1707 + _e1709);
                                                loop {
                                                    let _e1712 = phi_2726_;
                                                    let _e1714 = phi_2729_;
                                                    let _e1717 = (_e1712.member < _e1712.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1717)) != 0i) {
                                                        let _e1729 = (_e1701 + _e1714);
                                                        if (_e1729 < _e1465) {
                                                            let _e1732 = (f64(1f) - _e1729);
                                                            let _e1735 = local_5.member[0u];
                                                            let _e1738 = local_5.member[1u];
                                                            let _e1741 = local_5.member[2u];
                                                            let _e1744 = local_5.member[3u];
                                                            let _e1758 = local_5.member_1;
                                                            let _e1759 = ((select(f64(1f), f64(-1f), (_e1517 < _e1530)) * ((((_e1735 * _e1732) + (_e1738 * _e1729)) * (_e1732 * _e1732)) + (((_e1741 * _e1732) + (_e1744 * _e1729)) * (_e1729 * _e1729)))) > _e1758);
                                                            phi_2795_ = select((_e1714 + _e1714), f64(), _e1759);
                                                            phi_2796_ = select(true, false, _e1759);
                                                            phi_2797_ = _e1759;
                                                            phi_2798_ = false;
                                                        } else {
                                                            phi_2795_ = f64();
                                                            phi_2796_ = false;
                                                            phi_2797_ = false;
                                                            phi_2798_ = true;
                                                        }
                                                        let _e1764 = phi_2795_;
                                                        let _e1766 = phi_2796_;
                                                        let _e1768 = phi_2797_;
                                                        let _e1770 = phi_2798_;
                                                        phi_2799_ = _e1729;
                                                        phi_2730_ = _e1764;
                                                        phi_2800_ = _e1766;
                                                        phi_2801_ = _e1768;
                                                        phi_2802_ = _e1770;
                                                        phi_2803_ = false;
                                                    } else {
                                                        phi_2799_ = f64();
                                                        phi_2730_ = f64();
                                                        phi_2800_ = false;
                                                        phi_2801_ = false;
                                                        phi_2802_ = false;
                                                        phi_2803_ = true;
                                                    }
                                                    let _e1772 = phi_2799_;
                                                    let _e1774 = phi_2730_;
                                                    let _e1776 = phi_2800_;
                                                    let _e1778 = phi_2801_;
                                                    let _e1780 = phi_2802_;
                                                    let _e1782 = phi_2803_;
                                                    local_12 = _e1778;
                                                    local_13 = _e1780;
                                                    local_14 = _e1778;
                                                    local_15 = _e1782;
                                                    local_16 = _e1772;
                                                    continue;
                                                    continuing {
                                                        phi_2726_ = type_9(select(_e1712.member, (_e1712.member + 1u), _e1717), select(_e1712.member_1, _e1712.member_1, _e1717));
                                                        phi_2729_ = _e1774;
                                                        break if !(_e1776);
                                                    }
                                                }
                                                let _e1785 = local_12;
                                                let _e1787 = local_13;
                                                let _e1790 = local_14;
                                                let _e1792 = local_15;
                                                let _e1796 = local_16;
                                                phi_2817_ = select(_e1796, _e1465, select(select(_e1792, false, _e1790), true, select(_e1787, false, _e1785)));
                                            } else {
                                                phi_2817_ = _e1465;
                                            }
                                            let _e1799 = phi_2817_;
                                            phi_2819_ = type_43(_e1701, _e1799, _e1538);
                                        } else {
                                            phi_2819_ = _e1552;
                                        }
                                        let _e1802 = phi_2819_;
                                        if (_e1802.member > _e1802.member_1) {
                                            phi_3810_ = bool();
                                            phi_3811_ = true;
                                            phi_3812_ = false;
                                            phi_3813_ = false;
                                            phi_3814_ = false;
                                        } else {
                                            let _e1807 = (_e1802.member > _e544);
                                            if _e1807 {
                                                phi_3806_ = bool();
                                                phi_3807_ = false;
                                                phi_3808_ = false;
                                                phi_3809_ = false;
                                            } else {
                                                let _e1812 = ((_e1802.member_1 - _e1802.member) * f64(0.5f));
                                                let _e1813 = (_e1802.member + _e1812);
                                                let _e1816 = (_e1812 + (1.1102230246251565e-16lf * f64(4f)));
                                                let _e1818 = local_7.member_3;
                                                let _e1821 = local_7.member[0u];
                                                let _e1827 = select(_e1821[0], -(_e1821[0]), (_e1821[0] < 0.0lf));
                                                let _e1830 = select(_e1821[1], -(_e1821[1]), (_e1821[1] < 0.0lf));
                                                let _e1832 = select(_e1830, _e1827, (_e1827 > _e1830));
                                                let _e1835 = select(_e1821[2], -(_e1821[2]), (_e1821[2] < 0.0lf));
                                                let _e1837 = select(_e1835, _e1832, (_e1832 > _e1835));
                                                let _e1839 = local_7.member[1u];
                                                let _e1845 = select(_e1839[0], -(_e1839[0]), (_e1839[0] < 0.0lf));
                                                let _e1848 = select(_e1839[1], -(_e1839[1]), (_e1839[1] < 0.0lf));
                                                let _e1850 = select(_e1848, _e1845, (_e1845 > _e1848));
                                                let _e1853 = select(_e1839[2], -(_e1839[2]), (_e1839[2] < 0.0lf));
                                                let _e1855 = select(_e1853, _e1850, (_e1850 > _e1853));
                                                let _e1860 = local_7.member[0u];
                                                let _e1865 = local_7.member[1u];
                                                let _e1875 = (_e1860[0] + ((_e1865[0] - _e1860[0]) * _e1813));
                                                let _e1876 = (_e1860[1] + ((_e1865[1] - _e1860[1]) * _e1813));
                                                let _e1877 = (_e1860[2] + ((_e1865[2] - _e1860[2]) * _e1813));
                                                let _e1879 = local_7.member[1u];
                                                let _e1884 = local_7.member[0u];
                                                let _e1888 = (_e1879[0] - _e1884[0]);
                                                let _e1889 = (_e1879[1] - _e1884[1]);
                                                let _e1890 = (_e1879[2] - _e1884[2]);
                                                let _e1893 = select(_e1888, -(_e1888), (_e1888 < 0.0lf));
                                                let _e1896 = select(_e1889, -(_e1889), (_e1889 < 0.0lf));
                                                let _e1898 = select(_e1896, _e1893, (_e1893 > _e1896));
                                                let _e1901 = select(_e1890, -(_e1890), (_e1890 < 0.0lf));
                                                let _e1911 = ((((_e1816 * select(_e1901, _e1898, (_e1898 > _e1901))) * f64(1.01f)) + ((select(_e1855, _e1837, (_e1837 > _e1855)) + _e1818) * (1.1102230246251565e-16lf * f64(8f)))) + _e1818);
                                                let _e1914 = select(_e1875, -(_e1875), (_e1875 < 0.0lf));
                                                let _e1917 = select(_e1876, -(_e1876), (_e1876 < 0.0lf));
                                                let _e1919 = select(_e1917, _e1914, (_e1914 > _e1917));
                                                let _e1922 = select(_e1877, -(_e1877), (_e1877 < 0.0lf));
                                                let _e1925 = (select(_e1922, _e1919, (_e1919 > _e1922)) + _e1911);
                                                let _e1928 = local_7.member_3;
                                                let _e1930 = local_7.member_1[0u];
                                                let _e1936 = select(_e1930[0], -(_e1930[0]), (_e1930[0] < 0.0lf));
                                                let _e1939 = select(_e1930[1], -(_e1930[1]), (_e1930[1] < 0.0lf));
                                                let _e1941 = select(_e1939, _e1936, (_e1936 > _e1939));
                                                let _e1944 = select(_e1930[2], -(_e1930[2]), (_e1930[2] < 0.0lf));
                                                let _e1946 = select(_e1944, _e1941, (_e1941 > _e1944));
                                                let _e1948 = local_7.member_1[1u];
                                                let _e1954 = select(_e1948[0], -(_e1948[0]), (_e1948[0] < 0.0lf));
                                                let _e1957 = select(_e1948[1], -(_e1948[1]), (_e1948[1] < 0.0lf));
                                                let _e1959 = select(_e1957, _e1954, (_e1954 > _e1957));
                                                let _e1962 = select(_e1948[2], -(_e1948[2]), (_e1948[2] < 0.0lf));
                                                let _e1964 = select(_e1962, _e1959, (_e1959 > _e1962));
                                                let _e1969 = local_7.member_1[0u];
                                                let _e1974 = local_7.member_1[1u];
                                                let _e1984 = (_e1969[0] + ((_e1974[0] - _e1969[0]) * _e1813));
                                                let _e1985 = (_e1969[1] + ((_e1974[1] - _e1969[1]) * _e1813));
                                                let _e1986 = (_e1969[2] + ((_e1974[2] - _e1969[2]) * _e1813));
                                                let _e1988 = local_7.member_1[1u];
                                                let _e1993 = local_7.member_1[0u];
                                                let _e1997 = (_e1988[0] - _e1993[0]);
                                                let _e1998 = (_e1988[1] - _e1993[1]);
                                                let _e1999 = (_e1988[2] - _e1993[2]);
                                                let _e2002 = select(_e1997, -(_e1997), (_e1997 < 0.0lf));
                                                let _e2005 = select(_e1998, -(_e1998), (_e1998 < 0.0lf));
                                                let _e2007 = select(_e2005, _e2002, (_e2002 > _e2005));
                                                let _e2010 = select(_e1999, -(_e1999), (_e1999 < 0.0lf));
                                                let _e2020 = ((((_e1816 * select(_e2010, _e2007, (_e2007 > _e2010))) * f64(1.01f)) + ((select(_e1964, _e1946, (_e1946 > _e1964)) + _e1928) * (1.1102230246251565e-16lf * f64(8f)))) + _e1928);
                                                let _e2023 = select(_e1984, -(_e1984), (_e1984 < 0.0lf));
                                                let _e2026 = select(_e1985, -(_e1985), (_e1985 < 0.0lf));
                                                let _e2028 = select(_e2026, _e2023, (_e2023 > _e2026));
                                                let _e2031 = select(_e1986, -(_e1986), (_e1986 < 0.0lf));
                                                let _e2034 = (select(_e2031, _e2028, (_e2028 > _e2031)) + _e2020);
                                                let _e2037 = local_7.member_3;
                                                let _e2039 = local_7.member_2[0u];
                                                let _e2045 = select(_e2039[0], -(_e2039[0]), (_e2039[0] < 0.0lf));
                                                let _e2048 = select(_e2039[1], -(_e2039[1]), (_e2039[1] < 0.0lf));
                                                let _e2050 = select(_e2048, _e2045, (_e2045 > _e2048));
                                                let _e2053 = select(_e2039[2], -(_e2039[2]), (_e2039[2] < 0.0lf));
                                                let _e2055 = select(_e2053, _e2050, (_e2050 > _e2053));
                                                let _e2057 = local_7.member_2[1u];
                                                let _e2063 = select(_e2057[0], -(_e2057[0]), (_e2057[0] < 0.0lf));
                                                let _e2066 = select(_e2057[1], -(_e2057[1]), (_e2057[1] < 0.0lf));
                                                let _e2068 = select(_e2066, _e2063, (_e2063 > _e2066));
                                                let _e2071 = select(_e2057[2], -(_e2057[2]), (_e2057[2] < 0.0lf));
                                                let _e2073 = select(_e2071, _e2068, (_e2068 > _e2071));
                                                let _e2078 = local_7.member_2[0u];
                                                let _e2083 = local_7.member_2[1u];
                                                let _e2093 = (_e2078[0] + ((_e2083[0] - _e2078[0]) * _e1813));
                                                let _e2094 = (_e2078[1] + ((_e2083[1] - _e2078[1]) * _e1813));
                                                let _e2095 = (_e2078[2] + ((_e2083[2] - _e2078[2]) * _e1813));
                                                let _e2097 = local_7.member_2[1u];
                                                let _e2102 = local_7.member_2[0u];
                                                let _e2106 = (_e2097[0] - _e2102[0]);
                                                let _e2107 = (_e2097[1] - _e2102[1]);
                                                let _e2108 = (_e2097[2] - _e2102[2]);
                                                let _e2111 = select(_e2106, -(_e2106), (_e2106 < 0.0lf));
                                                let _e2114 = select(_e2107, -(_e2107), (_e2107 < 0.0lf));
                                                let _e2116 = select(_e2114, _e2111, (_e2111 > _e2114));
                                                let _e2119 = select(_e2108, -(_e2108), (_e2108 < 0.0lf));
                                                let _e2129 = ((((_e1816 * select(_e2119, _e2116, (_e2116 > _e2119))) * f64(1.01f)) + ((select(_e2073, _e2055, (_e2055 > _e2073)) + _e2037) * (1.1102230246251565e-16lf * f64(8f)))) + _e2037);
                                                let _e2132 = select(_e2093, -(_e2093), (_e2093 < 0.0lf));
                                                let _e2135 = select(_e2094, -(_e2094), (_e2094 < 0.0lf));
                                                let _e2137 = select(_e2135, _e2132, (_e2132 > _e2135));
                                                let _e2140 = select(_e2095, -(_e2095), (_e2095 < 0.0lf));
                                                let _e2143 = (select(_e2140, _e2137, (_e2137 > _e2140)) + _e2129);
                                                let _e2146 = ((_e1985 * _e2095) - (_e1986 * _e2094));
                                                let _e2149 = ((_e1986 * _e2093) - (_e1984 * _e2095));
                                                let _e2152 = ((_e1984 * _e2094) - (_e1985 * _e2093));
                                                let _e2167 = select(false, (select(_e2146, -(_e2146), (_e2146 < 0.0lf)) > select(_e2152, -(_e2152), (_e2152 < 0.0lf))), (select(_e2146, -(_e2146), (_e2146 < 0.0lf)) > select(_e2149, -(_e2149), (_e2149 < 0.0lf))));
                                                let _e2182 = select((select(_e2149, -(_e2149), (_e2149 < 0.0lf)) > select(_e2152, -(_e2152), (_e2152 < 0.0lf))), false, (select(_e2146, -(_e2146), (_e2146 < 0.0lf)) > select(_e2149, -(_e2149), (_e2149 < 0.0lf))));
                                                let _e2185 = select(select(_e1875, _e1876, _e2167), _e1877, _e2182);
                                                let _e2186 = select(select(_e1876, _e1877, _e2167), _e1875, _e2182);
                                                let _e2189 = select(select(_e1984, _e1985, _e2167), _e1986, _e2182);
                                                let _e2190 = select(select(_e1985, _e1986, _e2167), _e1984, _e2182);
                                                let _e2193 = select(select(_e2093, _e2094, _e2167), _e2095, _e2182);
                                                let _e2194 = select(select(_e2094, _e2095, _e2167), _e2093, _e2182);
                                                let _e2197 = ((_e2189 * _e2194) - (_e2190 * _e2193));
                                                let _e2198 = f64(1f);
                                                let _e2199 = f64(2f);
                                                let _e2217 = (((((_e2020 * _e2143) + (_e2034 * _e2129)) * f64(2.01f)) + (((_e2034 * _e2199) * (_e2143 * _e2199)) * (1.1102230246251565e-16lf * _e2199))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2198 + _e2034) * (_e2198 + _e2143))));
                                                if (select(_e2197, -(_e2197), (_e2197 < 0.0lf)) > _e2217) {
                                                    let _e2226 = select(f64(1f), f64(-1f), (_e2197 < f64(0f)));
                                                    let _e2230 = f64(1f);
                                                    let _e2231 = f64(2f);
                                                    let _e2249 = (((((_e1911 * _e2143) + (_e1925 * _e2129)) * f64(2.01f)) + (((_e1925 * _e2231) * (_e2143 * _e2231)) * (1.1102230246251565e-16lf * _e2231))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2230 + _e1925) * (_e2230 + _e2143))));
                                                    let _e2253 = f64(1f);
                                                    let _e2254 = f64(2f);
                                                    let _e2272 = (((((_e2020 * _e1925) + (_e2034 * _e1911)) * f64(2.01f)) + (((_e2034 * _e2254) * (_e1925 * _e2254)) * (1.1102230246251565e-16lf * _e2254))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2253 + _e2034) * (_e2253 + _e1925))));
                                                    let _e2273 = (_e2197 * _e2226);
                                                    let _e2274 = (((_e2185 * _e2194) - (_e2186 * _e2193)) * _e2226);
                                                    let _e2275 = (((_e2189 * _e2186) - (_e2190 * _e2185)) * _e2226);
                                                    let _e2289 = (((select(_e2273, -(_e2273), (_e2273 < 0.0lf)) + select(_e2274, -(_e2274), (_e2274 < 0.0lf))) + select(_e2275, -(_e2275), (_e2275 < 0.0lf))) * (1.1102230246251565e-16lf * f64(4f)));
                                                    if (_e223.member != 0u) {
                                                        phi_3680_ = array<type_36, 4>(type_36(_e2274, _e2249), type_36(_e2275, _e2272), type_36((_e2273 - _e2274), ((_e2217 + _e2249) + _e2289)), type_36((_e2273 - _e2275), ((_e2217 + _e2272) + _e2289)));
                                                    } else {
                                                        let _e2292 = ((_e2273 - _e2274) - _e2275);
                                                        let _e2295 = (((_e2217 + _e2249) + _e2272) + _e2289);
                                                        phi_3680_ = array<type_36, 4>(type_36(_e2274, _e2249), type_36(_e2275, _e2272), type_36(_e2292, _e2295), type_36(_e2292, _e2295));
                                                    }
                                                    let _e2313 = phi_3680_;
                                                    local_2 = array<type_36, 4>(type_36(_e2313[0].member, _e2313[0].member_1), type_36(_e2313[1].member, _e2313[1].member_1), type_36(_e2313[2].member, _e2313[2].member_1), type_36(_e2313[3].member, _e2313[3].member_1));
                                                    phi_3700_ = type_9(0u, 4u);
                                                    phi_3703_ = true;
                                                    loop {
                                                        let _e2332 = phi_3700_;
                                                        let _e2334 = phi_3703_;
                                                        local_18 = _e2334;
                                                        let _e2337 = (_e2332.member < _e2332.member_1);
                                                        let _e2348 = select(type_9().member_1, _e2332.member, _e2337);
                                                        if (bitcast<i32>(select(0u, 1u, _e2337)) != 0i) {
                                                            let _e2353 = local_2[_e2348].member;
                                                            let _e2356 = local_2[_e2348].member_1;
                                                            let _e2358 = (_e2353 < -(_e2356));
                                                            phi_3704_ = select((_e2334 && (_e2353 > _e2356)), bool(), _e2358);
                                                            phi_3755_ = select(true, false, _e2358);
                                                            phi_3756_ = _e2358;
                                                        } else {
                                                            phi_3704_ = bool();
                                                            phi_3755_ = false;
                                                            phi_3756_ = false;
                                                        }
                                                        let _e2364 = phi_3704_;
                                                        let _e2366 = phi_3755_;
                                                        let _e2368 = phi_3756_;
                                                        local_17 = _e2368;
                                                        continue;
                                                        continuing {
                                                            phi_3700_ = type_9(select(_e2332.member, (_e2332.member + 1u), _e2337), select(_e2332.member_1, _e2332.member_1, _e2337));
                                                            phi_3703_ = _e2364;
                                                            break if !(_e2366);
                                                        }
                                                    }
                                                    let _e2371 = local_17;
                                                    let _e2372 = select(true, false, _e2371);
                                                    let _e2374 = local_18;
                                                    phi_3770_ = select(u32(), select(2u, 1u, _e2374), _e2372);
                                                    phi_3771_ = 0u;
                                                    phi_3772_ = select(true, false, _e2372);
                                                } else {
                                                    phi_3770_ = u32();
                                                    phi_3771_ = 2u;
                                                    phi_3772_ = true;
                                                }
                                                let _e2379 = phi_3770_;
                                                let _e2381 = phi_3771_;
                                                let _e2383 = phi_3772_;
                                                let _e2384 = select(_e2379, _e2381, _e2383);
                                                let _e2385 = (_e2384 == 0u);
                                                if _e2385 {
                                                    phi_3803_ = bool();
                                                    phi_3804_ = false;
                                                    phi_3805_ = false;
                                                } else {
                                                    let _e2388 = select(false, _e1802.member_2, (_e2384 == 1u));
                                                    let _e2394 = select(true, select(true, false, ((_e1802.member_1 - _e1802.member) <= _e1401)), _e2388);
                                                    phi_3803_ = _e2388;
                                                    phi_3804_ = _e2394;
                                                    phi_3805_ = select(true, false, _e2394);
                                                }
                                                let _e2397 = phi_3803_;
                                                let _e2399 = phi_3804_;
                                                let _e2401 = phi_3805_;
                                                phi_3806_ = _e2397;
                                                phi_3807_ = _e2385;
                                                phi_3808_ = _e2399;
                                                phi_3809_ = _e2401;
                                            }
                                            let _e2403 = phi_3806_;
                                            let _e2405 = phi_3807_;
                                            let _e2407 = phi_3808_;
                                            let _e2409 = phi_3809_;
                                            phi_3810_ = _e2403;
                                            phi_3811_ = _e2405;
                                            phi_3812_ = _e2407;
                                            phi_3813_ = _e1807;
                                            phi_3814_ = _e2409;
                                        }
                                        let _e2411 = phi_3810_;
                                        let _e2413 = phi_3811_;
                                        let _e2415 = phi_3812_;
                                        let _e2417 = phi_3813_;
                                        let _e2419 = phi_3814_;
                                        phi_3815_ = _e1802;
                                        phi_3816_ = _e2411;
                                        phi_3817_ = _e1802;
                                        phi_3818_ = _e2413;
                                        phi_3819_ = _e2415;
                                        phi_3820_ = _e2417;
                                        phi_3821_ = _e2419;
                                    }
                                    let _e2421 = phi_3815_;
                                    let _e2423 = phi_3816_;
                                    let _e2425 = phi_3817_;
                                    let _e2427 = phi_3818_;
                                    let _e2429 = phi_3819_;
                                    let _e2431 = phi_3820_;
                                    let _e2433 = phi_3821_;
                                    phi_3822_ = _e2421;
                                    phi_3823_ = _e2423;
                                    phi_3824_ = _e2425;
                                    phi_3825_ = _e2427;
                                    phi_3826_ = _e2429;
                                    phi_3827_ = _e1467;
                                    phi_3828_ = _e2431;
                                    phi_3829_ = _e2433;
                                } else {
                                    phi_3822_ = type_43();
                                    phi_3823_ = bool();
                                    phi_3824_ = type_43();
                                    phi_3825_ = true;
                                    phi_3826_ = false;
                                    phi_3827_ = false;
                                    phi_3828_ = false;
                                    phi_3829_ = false;
                                }
                                let _e2435 = phi_3822_;
                                let _e2437 = phi_3823_;
                                let _e2439 = phi_3824_;
                                let _e2441 = phi_3825_;
                                let _e2443 = phi_3826_;
                                let _e2445 = phi_3827_;
                                let _e2447 = phi_3828_;
                                let _e2449 = phi_3829_;
                                phi_3837_ = _e2435;
                                phi_3838_ = _e2437;
                                phi_3839_ = _e2439;
                                phi_3840_ = select(_e2443, false, _e2441);
                                phi_3841_ = _e2441;
                                phi_3842_ = select(_e2445, false, _e2441);
                                phi_3843_ = select(_e2447, false, _e2441);
                                phi_3844_ = select(_e2449, false, _e2441);
                            } else {
                                phi_3837_ = type_43(_e526, _e526, false);
                                phi_3838_ = false;
                                phi_3839_ = type_43();
                                phi_3840_ = true;
                                phi_3841_ = false;
                                phi_3842_ = false;
                                phi_3843_ = false;
                                phi_3844_ = false;
                            }
                            let _e2455 = phi_3837_;
                            let _e2457 = phi_3838_;
                            let _e2459 = phi_3839_;
                            let _e2461 = phi_3840_;
                            let _e2463 = phi_3841_;
                            let _e2465 = phi_3842_;
                            let _e2467 = phi_3843_;
                            let _e2469 = phi_3844_;
                            if _e2461 {
                                let _e2474 = local_7.member[0u];
                                let _e2480 = local_7.member_1[0u];
                                let _e2486 = local_7.member_2[0u];
                                let _e2490 = (_e2474[0] - _e2480[0]);
                                let _e2491 = (_e2474[1] - _e2480[1]);
                                let _e2492 = (_e2474[2] - _e2480[2]);
                                let _e2493 = (_e223.member == 0u);
                                let _e2505 = local_7.member[1u];
                                let _e2511 = local_7.member_1[1u];
                                let _e2517 = local_7.member_2[1u];
                                let _e2521 = (_e2505[0] - _e2511[0]);
                                let _e2522 = (_e2505[1] - _e2511[1]);
                                let _e2523 = (_e2505[2] - _e2511[2]);
                                let _e2524 = (_e223.member == 0u);
                                let _e2536 = local_7.member[0u];
                                let _e2542 = select(_e2536[0], -(_e2536[0]), (_e2536[0] < 0.0lf));
                                let _e2545 = select(_e2536[1], -(_e2536[1]), (_e2536[1] < 0.0lf));
                                let _e2547 = select(_e2545, _e2542, (_e2542 > _e2545));
                                let _e2550 = select(_e2536[2], -(_e2536[2]), (_e2536[2] < 0.0lf));
                                let _e2552 = select(_e2550, _e2547, (_e2547 > _e2550));
                                let _e2555 = local_7.member[1u];
                                let _e2561 = select(_e2555[0], -(_e2555[0]), (_e2555[0] < 0.0lf));
                                let _e2564 = select(_e2555[1], -(_e2555[1]), (_e2555[1] < 0.0lf));
                                let _e2566 = select(_e2564, _e2561, (_e2561 > _e2564));
                                let _e2569 = select(_e2555[2], -(_e2555[2]), (_e2555[2] < 0.0lf));
                                let _e2571 = select(_e2569, _e2566, (_e2566 > _e2569));
                                let _e2575 = local_7.member_3;
                                let _e2579 = local_7.member_1[0u];
                                let _e2585 = select(_e2579[0], -(_e2579[0]), (_e2579[0] < 0.0lf));
                                let _e2588 = select(_e2579[1], -(_e2579[1]), (_e2579[1] < 0.0lf));
                                let _e2590 = select(_e2588, _e2585, (_e2585 > _e2588));
                                let _e2593 = select(_e2579[2], -(_e2579[2]), (_e2579[2] < 0.0lf));
                                let _e2595 = select(_e2593, _e2590, (_e2590 > _e2593));
                                let _e2598 = local_7.member_1[1u];
                                let _e2604 = select(_e2598[0], -(_e2598[0]), (_e2598[0] < 0.0lf));
                                let _e2607 = select(_e2598[1], -(_e2598[1]), (_e2598[1] < 0.0lf));
                                let _e2609 = select(_e2607, _e2604, (_e2604 > _e2607));
                                let _e2612 = select(_e2598[2], -(_e2598[2]), (_e2598[2] < 0.0lf));
                                let _e2614 = select(_e2612, _e2609, (_e2609 > _e2612));
                                let _e2618 = local_7.member_3;
                                let _e2622 = local_7.member_2[0u];
                                let _e2628 = select(_e2622[0], -(_e2622[0]), (_e2622[0] < 0.0lf));
                                let _e2631 = select(_e2622[1], -(_e2622[1]), (_e2622[1] < 0.0lf));
                                let _e2633 = select(_e2631, _e2628, (_e2628 > _e2631));
                                let _e2636 = select(_e2622[2], -(_e2622[2]), (_e2622[2] < 0.0lf));
                                let _e2638 = select(_e2636, _e2633, (_e2633 > _e2636));
                                let _e2641 = local_7.member_2[1u];
                                let _e2647 = select(_e2641[0], -(_e2641[0]), (_e2641[0] < 0.0lf));
                                let _e2650 = select(_e2641[1], -(_e2641[1]), (_e2641[1] < 0.0lf));
                                let _e2652 = select(_e2650, _e2647, (_e2647 > _e2650));
                                let _e2655 = select(_e2641[2], -(_e2641[2]), (_e2641[2] < 0.0lf));
                                let _e2657 = select(_e2655, _e2652, (_e2652 > _e2655));
                                let _e2661 = local_7.member_3;
                                let _e2669 = local_7.member_3;
                                let _e2677 = (_e517 * f64(0.00390625f));
                                let _e2678 = f64(0f);
                                let _e2679 = f64(1f);
                                local = type_35(array<f64, 4>(_e2678, _e2678, _e2678, _e2678), array<f64, 4>(_e2678, _e2678, _e2678, _e2678), array<f64, 4>(_e2679, _e2679, _e2679, _e2679));
                                phi_4273_ = type_9(0u, 96u);
                                phi_4276_ = _e2455.member;
                                phi_4278_ = _e2455.member;
                                phi_4280_ = (_e2455.member_1 - _e2455.member);
                                phi_4282_ = _e2455.member;
                                phi_4284_ = false;
                                phi_4286_ = 0u;
                                loop {
                                    let _e2686 = phi_4273_;
                                    let _e2688 = phi_4276_;
                                    let _e2690 = phi_4278_;
                                    let _e2692 = phi_4280_;
                                    let _e2694 = phi_4282_;
                                    let _e2696 = phi_4284_;
                                    let _e2698 = phi_4286_;
                                    local_31 = _e2688;
                                    local_35 = _e2690;
                                    let _e2701 = (_e2686.member < _e2686.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2701)) != 0i) {
                                        let _e2715 = local_7.member[0u];
                                        let _e2721 = local_7.member[1u];
                                        let _e2737 = local_7.member_1[0u];
                                        let _e2743 = local_7.member_1[1u];
                                        let _e2759 = local_7.member_2[0u];
                                        let _e2765 = local_7.member_2[1u];
                                        let _e2779 = function_4(array<f64, 3>((_e2715[0] + ((_e2721[0] - _e2715[0]) * _e2688)), (_e2715[1] + ((_e2721[1] - _e2715[1]) * _e2688)), (_e2715[2] + ((_e2721[2] - _e2715[2]) * _e2688))), array<f64, 3>((_e2737[0] + ((_e2743[0] - _e2737[0]) * _e2688)), (_e2737[1] + ((_e2743[1] - _e2737[1]) * _e2688)), (_e2737[2] + ((_e2743[2] - _e2737[2]) * _e2688))), array<f64, 3>((_e2759[0] + ((_e2765[0] - _e2759[0]) * _e2688)), (_e2759[1] + ((_e2765[1] - _e2759[1]) * _e2688)), (_e2759[2] + ((_e2765[2] - _e2759[2]) * _e2688))), _e223.member);
                                        if (_e2698 == 0u) {
                                            phi_4438_ = _e2779;
                                        } else {
                                            let _e2781 = f64(0f);
                                            phi_4438_ = array<f64, 3>(select(_e2781, _e2779[0], (_e2698 == 1u)), select(_e2781, _e2779[1], (_e2698 == 2u)), select(_e2781, _e2779[2], (_e2698 == 3u)));
                                        }
                                        let _e2793 = phi_4438_;
                                        let _e2807 = ((select(_e2793[0], -(_e2793[0]), (_e2793[0] < 0.0lf)) + select(_e2793[1], -(_e2793[1]), (_e2793[1] < 0.0lf))) + select(_e2793[2], -(_e2793[2]), (_e2793[2] < 0.0lf)));
                                        if (_e2807 > f64(0f)) {
                                            if ((bitcast<u64>(_e2807) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2814 = (f64(1f) / _e2807);
                                                let _e2816 = (_e2793[0] * _e2814);
                                                let _e2818 = (_e2793[1] * _e2814);
                                                let _e2820 = (_e2793[2] * _e2814);
                                                let _e2825 = (((_e2816 * _e2816) + (_e2818 * _e2818)) + (_e2820 * _e2820));
                                                if (_e2825 <= 2.2250738585072014e-308lf) {
                                                    phi_4563_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2825 > 0.0lf));
                                                } else {
                                                    phi_4506_ = type_18(0i, 5i);
                                                    phi_4509_ = bitcast<f64>(((bitcast<u64>(_e2825) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2832 = phi_4506_;
                                                        let _e2834 = phi_4509_;
                                                        local_19 = _e2834;
                                                        if (_e2832.member < _e2832.member_1) {
                                                            let _e2841 = (_e2832.member + 1i);
                                                            phi_4507_ = type_18(select(_e2841, type_19().member_1, select(false, true, ((false == (_e2841 > _e2832.member)) != false))), _e2832.member_1);
                                                            phi_4550_ = type_19(1u, _e2832.member);
                                                        } else {
                                                            phi_4507_ = _e2832;
                                                            phi_4550_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e2852 = phi_4507_;
                                                        let _e2854 = phi_4550_;
                                                        let _e2857 = (bitcast<i32>(_e2854.member) != 0i);
                                                        if _e2857 {
                                                            phi_4510_ = (0.5lf * (_e2834 + (_e2825 / _e2834)));
                                                        } else {
                                                            phi_4510_ = f64();
                                                        }
                                                        let _e2862 = phi_4510_;
                                                        continue;
                                                        continuing {
                                                            phi_4506_ = _e2852;
                                                            phi_4509_ = _e2862;
                                                            break if !(_e2857);
                                                        }
                                                    }
                                                    let _e2867 = local_19;
                                                    phi_4563_ = (_e2867 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2873 = phi_4563_;
                                                let _e2875 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2882 = ((((((((select(_e2571, _e2552, (_e2552 > _e2571)) + _e2575) + (select(_e2614, _e2595, (_e2595 > _e2614)) + _e2618)) + (select(_e2657, _e2638, (_e2638 > _e2657)) + _e2661)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2669 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e811 * _e2873) * (f64(1f) + _e2875)));
                                                let _e2887 = (((_e2816 * _e2474[0]) + (_e2818 * _e2474[1])) + (_e2820 * _e2474[2]));
                                                let _e2892 = (((_e2816 * _e2490) + (_e2818 * _e2491)) + (_e2820 * _e2492));
                                                let _e2897 = (((_e2816 * (_e2474[0] - _e2486[0])) + (_e2818 * (_e2474[1] - _e2486[1]))) + (_e2820 * (_e2474[2] - _e2486[2])));
                                                let _e2902 = (((_e2816 * select((_e2490 - _e2486[0]), _e2474[0], _e2493)) + (_e2818 * select((_e2491 - _e2486[1]), _e2474[1], _e2493))) + (_e2820 * select((_e2492 - _e2486[2]), _e2474[2], _e2493)));
                                                let _e2908 = (((_e2816 * _e2505[0]) + (_e2818 * _e2505[1])) + (_e2820 * _e2505[2]));
                                                let _e2913 = (((_e2816 * _e2521) + (_e2818 * _e2522)) + (_e2820 * _e2523));
                                                let _e2918 = (((_e2816 * (_e2505[0] - _e2517[0])) + (_e2818 * (_e2505[1] - _e2517[1]))) + (_e2820 * (_e2505[2] - _e2517[2])));
                                                let _e2923 = (((_e2816 * select((_e2521 - _e2517[0]), _e2505[0], _e2524)) + (_e2818 * select((_e2522 - _e2517[1]), _e2505[1], _e2524))) + (_e2820 * select((_e2523 - _e2517[2]), _e2505[2], _e2524)));
                                                phi_4689_ = type_35(array<f64, 4>(_e2887, _e2892, _e2897, _e2902), array<f64, 4>(_e2908, _e2913, _e2918, _e2923), array<f64, 4>((_e2882 + ((select(_e2887, -(_e2887), (_e2887 < 0.0lf)) + select(_e2908, -(_e2908), (_e2908 < 0.0lf))) * _e2875)), (_e2882 + ((select(_e2892, -(_e2892), (_e2892 < 0.0lf)) + select(_e2913, -(_e2913), (_e2913 < 0.0lf))) * _e2875)), (_e2882 + ((select(_e2897, -(_e2897), (_e2897 < 0.0lf)) + select(_e2918, -(_e2918), (_e2918 < 0.0lf))) * _e2875)), (_e2882 + ((select(_e2902, -(_e2902), (_e2902 < 0.0lf)) + select(_e2923, -(_e2923), (_e2923 < 0.0lf))) * _e2875))));
                                                phi_4690_ = false;
                                            } else {
                                                phi_4689_ = type_35();
                                                phi_4690_ = true;
                                            }
                                            let _e2964 = phi_4689_;
                                            let _e2966 = phi_4690_;
                                            phi_4691_ = _e2964;
                                            phi_4692_ = _e2966;
                                        } else {
                                            phi_4691_ = type_35();
                                            phi_4692_ = true;
                                        }
                                        let _e2968 = phi_4691_;
                                        let _e2970 = phi_4692_;
                                        if _e2970 {
                                            let _e2971 = f64(0f);
                                            let _e2972 = f64(1f);
                                            phi_4702_ = type_35(array<f64, 4>(_e2971, _e2971, _e2971, _e2971), array<f64, 4>(_e2971, _e2971, _e2971, _e2971), array<f64, 4>(_e2972, _e2972, _e2972, _e2972));
                                        } else {
                                            phi_4702_ = _e2968;
                                        }
                                        let _e2978 = phi_4702_;
                                        local_1 = type_35(array<f64, 4>(_e2978.member[0], _e2978.member[1], _e2978.member[2], _e2978.member[3]), array<f64, 4>(_e2978.member_1[0], _e2978.member_1[1], _e2978.member_1[2], _e2978.member_1[3]), array<f64, 4>(_e2978.member_2[0], _e2978.member_2[1], _e2978.member_2[2], _e2978.member_2[3]));
                                        let _e2998 = (_e2688 - _e2694);
                                        let _e3000 = f64(0f);
                                        let _e3003 = local_1.member[0u];
                                        let _e3006 = local_1.member_1[0u];
                                        let _e3009 = local_1.member[0u];
                                        let _e3015 = local_1.member_2[0u];
                                        if (((_e3003 + ((_e3006 - _e3009) * _e2688)) - _e3015) > _e3000) {
                                            let _e3020 = local_1.member[1u];
                                            let _e3023 = local_1.member_1[1u];
                                            let _e3026 = local_1.member[1u];
                                            let _e3032 = local_1.member_2[1u];
                                            if (((_e3020 + ((_e3023 - _e3026) * _e2688)) - _e3032) > _e3000) {
                                                let _e3037 = local_1.member[2u];
                                                let _e3040 = local_1.member_1[2u];
                                                let _e3043 = local_1.member[2u];
                                                let _e3049 = local_1.member_2[2u];
                                                if (((_e3037 + ((_e3040 - _e3043) * _e2688)) - _e3049) > _e3000) {
                                                    let _e3054 = local_1.member[3u];
                                                    let _e3057 = local_1.member_1[3u];
                                                    let _e3060 = local_1.member[3u];
                                                    let _e3066 = local_1.member_2[3u];
                                                    phi_4874_ = (((_e3054 + ((_e3057 - _e3060) * _e2688)) - _e3066) > _e3000);
                                                    phi_4875_ = false;
                                                } else {
                                                    phi_4874_ = bool();
                                                    phi_4875_ = true;
                                                }
                                                let _e3070 = phi_4874_;
                                                let _e3072 = phi_4875_;
                                                phi_4876_ = _e3070;
                                                phi_4877_ = _e3072;
                                            } else {
                                                phi_4876_ = bool();
                                                phi_4877_ = true;
                                            }
                                            let _e3074 = phi_4876_;
                                            let _e3076 = phi_4877_;
                                            phi_4878_ = _e3074;
                                            phi_4879_ = _e3076;
                                        } else {
                                            phi_4878_ = bool();
                                            phi_4879_ = true;
                                        }
                                        let _e3078 = phi_4878_;
                                        let _e3080 = phi_4879_;
                                        if select(_e3078, false, _e3080) {
                                            if (_e2688 <= _e2690) {
                                                phi_5194_ = true;
                                            } else {
                                                let _e3083 = f64(0f);
                                                let _e3086 = local.member[0u];
                                                let _e3089 = local.member_1[0u];
                                                let _e3092 = local.member[0u];
                                                let _e3098 = local.member_2[0u];
                                                let _e3102 = local_1.member[0u];
                                                let _e3105 = local_1.member_1[0u];
                                                let _e3108 = local_1.member[0u];
                                                let _e3114 = local_1.member_2[0u];
                                                if ((((_e3086 + ((_e3089 - _e3092) * _e2688)) - _e3098) + ((_e3102 + ((_e3105 - _e3108) * _e2694)) - _e3114)) > _e3083) {
                                                    let _e3120 = local.member[1u];
                                                    let _e3123 = local.member_1[1u];
                                                    let _e3126 = local.member[1u];
                                                    let _e3132 = local.member_2[1u];
                                                    let _e3136 = local_1.member[1u];
                                                    let _e3139 = local_1.member_1[1u];
                                                    let _e3142 = local_1.member[1u];
                                                    let _e3148 = local_1.member_2[1u];
                                                    if ((((_e3120 + ((_e3123 - _e3126) * _e2688)) - _e3132) + ((_e3136 + ((_e3139 - _e3142) * _e2694)) - _e3148)) > _e3083) {
                                                        let _e3154 = local.member[2u];
                                                        let _e3157 = local.member_1[2u];
                                                        let _e3160 = local.member[2u];
                                                        let _e3166 = local.member_2[2u];
                                                        let _e3170 = local_1.member[2u];
                                                        let _e3173 = local_1.member_1[2u];
                                                        let _e3176 = local_1.member[2u];
                                                        let _e3182 = local_1.member_2[2u];
                                                        if ((((_e3154 + ((_e3157 - _e3160) * _e2688)) - _e3166) + ((_e3170 + ((_e3173 - _e3176) * _e2694)) - _e3182)) > _e3083) {
                                                            let _e3188 = local.member[3u];
                                                            let _e3191 = local.member_1[3u];
                                                            let _e3194 = local.member[3u];
                                                            let _e3200 = local.member_2[3u];
                                                            let _e3204 = local_1.member[3u];
                                                            let _e3207 = local_1.member_1[3u];
                                                            let _e3210 = local_1.member[3u];
                                                            let _e3216 = local_1.member_2[3u];
                                                            phi_5181_ = ((((_e3188 + ((_e3191 - _e3194) * _e2688)) - _e3200) + ((_e3204 + ((_e3207 - _e3210) * _e2694)) - _e3216)) > _e3083);
                                                            phi_5182_ = false;
                                                        } else {
                                                            phi_5181_ = bool();
                                                            phi_5182_ = true;
                                                        }
                                                        let _e3221 = phi_5181_;
                                                        let _e3223 = phi_5182_;
                                                        phi_5183_ = _e3221;
                                                        phi_5184_ = _e3223;
                                                    } else {
                                                        phi_5183_ = bool();
                                                        phi_5184_ = true;
                                                    }
                                                    let _e3225 = phi_5183_;
                                                    let _e3227 = phi_5184_;
                                                    phi_5185_ = _e3225;
                                                    phi_5186_ = _e3227;
                                                } else {
                                                    phi_5185_ = bool();
                                                    phi_5186_ = true;
                                                }
                                                let _e3229 = phi_5185_;
                                                let _e3231 = phi_5186_;
                                                phi_5194_ = select(_e3229, false, _e3231);
                                            }
                                            let _e3234 = phi_5194_;
                                            if _e3234 {
                                                if select(true, select(true, false, (_e2688 >= _e2455.member_1)), _e2696) {
                                                    local = type_35(array<f64, 4>(_e2978.member[0], _e2978.member[1], _e2978.member[2], _e2978.member[3]), array<f64, 4>(_e2978.member_1[0], _e2978.member_1[1], _e2978.member_1[2], _e2978.member_1[3]), array<f64, 4>(_e2978.member_2[0], _e2978.member_2[1], _e2978.member_2[2], _e2978.member_2[3]));
                                                    let _e3259 = local.member[0u];
                                                    let _e3262 = local.member_1[0u];
                                                    let _e3265 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e3262 > _e3265)), (_e3259 > _e3265)) {
                                                        let _e3270 = (_e3262 >= _e3259);
                                                        if _e3270 {
                                                            phi_5306_ = f64();
                                                            phi_5307_ = false;
                                                        } else {
                                                            if ((_e3259 - _e3262) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5304_ = (((_e3259 - _e3265) / (_e3259 - _e3262)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5305_ = false;
                                                            } else {
                                                                phi_5304_ = f64();
                                                                phi_5305_ = true;
                                                            }
                                                            let _e3284 = phi_5304_;
                                                            let _e3286 = phi_5305_;
                                                            phi_5306_ = _e3284;
                                                            phi_5307_ = _e3286;
                                                        }
                                                        let _e3288 = phi_5306_;
                                                        let _e3290 = phi_5307_;
                                                        phi_5308_ = _e3288;
                                                        phi_5309_ = _e3270;
                                                        phi_5310_ = _e3290;
                                                    } else {
                                                        phi_5308_ = f64();
                                                        phi_5309_ = true;
                                                        phi_5310_ = false;
                                                    }
                                                    let _e3292 = phi_5308_;
                                                    let _e3294 = phi_5309_;
                                                    let _e3296 = phi_5310_;
                                                    let _e3300 = select(_e3292, select(_e2688, f64(2f), _e3294), select(_e3296, true, _e3294));
                                                    let _e3303 = local.member[1u];
                                                    let _e3306 = local.member_1[1u];
                                                    let _e3309 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e3306 > _e3309)), (_e3303 > _e3309)) {
                                                        let _e3314 = (_e3306 >= _e3303);
                                                        if _e3314 {
                                                            phi_5378_ = f64();
                                                            phi_5379_ = false;
                                                        } else {
                                                            if ((_e3303 - _e3306) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5376_ = (((_e3303 - _e3309) / (_e3303 - _e3306)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5377_ = false;
                                                            } else {
                                                                phi_5376_ = f64();
                                                                phi_5377_ = true;
                                                            }
                                                            let _e3328 = phi_5376_;
                                                            let _e3330 = phi_5377_;
                                                            phi_5378_ = _e3328;
                                                            phi_5379_ = _e3330;
                                                        }
                                                        let _e3332 = phi_5378_;
                                                        let _e3334 = phi_5379_;
                                                        phi_5380_ = _e3332;
                                                        phi_5381_ = _e3314;
                                                        phi_5382_ = _e3334;
                                                    } else {
                                                        phi_5380_ = f64();
                                                        phi_5381_ = true;
                                                        phi_5382_ = false;
                                                    }
                                                    let _e3336 = phi_5380_;
                                                    let _e3338 = phi_5381_;
                                                    let _e3340 = phi_5382_;
                                                    let _e3344 = select(_e3336, select(_e2688, f64(2f), _e3338), select(_e3340, true, _e3338));
                                                    let _e3346 = select(_e3344, _e3300, (_e3300 < _e3344));
                                                    let _e3349 = local.member[2u];
                                                    let _e3352 = local.member_1[2u];
                                                    let _e3355 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3352 > _e3355)), (_e3349 > _e3355)) {
                                                        let _e3360 = (_e3352 >= _e3349);
                                                        if _e3360 {
                                                            phi_5455_ = f64();
                                                            phi_5456_ = false;
                                                        } else {
                                                            if ((_e3349 - _e3352) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5453_ = (((_e3349 - _e3355) / (_e3349 - _e3352)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5454_ = false;
                                                            } else {
                                                                phi_5453_ = f64();
                                                                phi_5454_ = true;
                                                            }
                                                            let _e3374 = phi_5453_;
                                                            let _e3376 = phi_5454_;
                                                            phi_5455_ = _e3374;
                                                            phi_5456_ = _e3376;
                                                        }
                                                        let _e3378 = phi_5455_;
                                                        let _e3380 = phi_5456_;
                                                        phi_5457_ = _e3378;
                                                        phi_5458_ = _e3360;
                                                        phi_5459_ = _e3380;
                                                    } else {
                                                        phi_5457_ = f64();
                                                        phi_5458_ = true;
                                                        phi_5459_ = false;
                                                    }
                                                    let _e3382 = phi_5457_;
                                                    let _e3384 = phi_5458_;
                                                    let _e3386 = phi_5459_;
                                                    let _e3390 = select(_e3382, select(_e2688, f64(2f), _e3384), select(_e3386, true, _e3384));
                                                    let _e3393 = local.member[3u];
                                                    let _e3396 = local.member_1[3u];
                                                    let _e3399 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3396 > _e3399)), (_e3393 > _e3399)) {
                                                        let _e3404 = (_e3396 >= _e3393);
                                                        if _e3404 {
                                                            phi_5527_ = f64();
                                                            phi_5528_ = false;
                                                        } else {
                                                            if ((_e3393 - _e3396) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5525_ = (((_e3393 - _e3399) / (_e3393 - _e3396)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5526_ = false;
                                                            } else {
                                                                phi_5525_ = f64();
                                                                phi_5526_ = true;
                                                            }
                                                            let _e3418 = phi_5525_;
                                                            let _e3420 = phi_5526_;
                                                            phi_5527_ = _e3418;
                                                            phi_5528_ = _e3420;
                                                        }
                                                        let _e3422 = phi_5527_;
                                                        let _e3424 = phi_5528_;
                                                        phi_5529_ = _e3422;
                                                        phi_5530_ = _e3404;
                                                        phi_5531_ = _e3424;
                                                    } else {
                                                        phi_5529_ = f64();
                                                        phi_5530_ = true;
                                                        phi_5531_ = false;
                                                    }
                                                    let _e3426 = phi_5529_;
                                                    let _e3428 = phi_5530_;
                                                    let _e3430 = phi_5531_;
                                                    let _e3434 = select(_e3426, select(_e2688, f64(2f), _e3428), select(_e3430, true, _e3428));
                                                    let _e3436 = select(_e3434, _e3390, (_e3390 < _e3434));
                                                    let _e3438 = select(_e3436, _e3346, (_e3346 < _e3436));
                                                    let _e3440 = select(_e2688, _e3438, (_e3438 > _e2688));
                                                    let _e3441 = (_e3440 > _e2455.member_1);
                                                    if _e3441 {
                                                        phi_6073_ = f64();
                                                        phi_6074_ = f64();
                                                        phi_6075_ = false;
                                                        phi_6076_ = false;
                                                    } else {
                                                        let _e3442 = (_e3440 - _e2688);
                                                        let _e3443 = (_e3442 <= _e2677);
                                                        let _e3446 = (_e3440 + (_e517 * f64(0.01f)));
                                                        let _e3448 = select(_e2455.member_1, _e3446, (_e3446 < _e2455.member_1));
                                                        if _e3443 {
                                                            if (_e811 > f64(0f)) {
                                                                let _e3453 = local_7.member[0u];
                                                                let _e3459 = local_7.member[1u];
                                                                let _e3475 = local_7.member_1[0u];
                                                                let _e3481 = local_7.member_1[1u];
                                                                let _e3497 = local_7.member_2[0u];
                                                                let _e3503 = local_7.member_2[1u];
                                                                let _e3517 = function_4(array<f64, 3>((_e3453[0] + ((_e3459[0] - _e3453[0]) * _e3448)), (_e3453[1] + ((_e3459[1] - _e3453[1]) * _e3448)), (_e3453[2] + ((_e3459[2] - _e3453[2]) * _e3448))), array<f64, 3>((_e3475[0] + ((_e3481[0] - _e3475[0]) * _e3448)), (_e3475[1] + ((_e3481[1] - _e3475[1]) * _e3448)), (_e3475[2] + ((_e3481[2] - _e3475[2]) * _e3448))), array<f64, 3>((_e3497[0] + ((_e3503[0] - _e3497[0]) * _e3448)), (_e3497[1] + ((_e3503[1] - _e3497[1]) * _e3448)), (_e3497[2] + ((_e3503[2] - _e3497[2]) * _e3448))), _e223.member);
                                                                let _e3528 = (((_e3517[0] * _e3517[0]) + (_e3517[1] * _e3517[1])) + (_e3517[2] * _e3517[2]));
                                                                if (_e3528 <= 2.2250738585072014e-308lf) {
                                                                    phi_5765_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3528 > 0.0lf));
                                                                } else {
                                                                    phi_5708_ = type_18(0i, 5i);
                                                                    phi_5711_ = bitcast<f64>(((bitcast<u64>(_e3528) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e3535 = phi_5708_;
                                                                        let _e3537 = phi_5711_;
                                                                        local_20 = _e3537;
                                                                        if (_e3535.member < _e3535.member_1) {
                                                                            let _e3544 = (_e3535.member + 1i);
                                                                            phi_5709_ = type_18(select(_e3544, type_19().member_1, select(false, true, ((false == (_e3544 > _e3535.member)) != false))), _e3535.member_1);
                                                                            phi_5752_ = type_19(1u, _e3535.member);
                                                                        } else {
                                                                            phi_5709_ = _e3535;
                                                                            phi_5752_ = type_19(0u, type_19().member_1);
                                                                        }
                                                                        let _e3555 = phi_5709_;
                                                                        let _e3557 = phi_5752_;
                                                                        let _e3560 = (bitcast<i32>(_e3557.member) != 0i);
                                                                        if _e3560 {
                                                                            phi_5712_ = (0.5lf * (_e3537 + (_e3528 / _e3537)));
                                                                        } else {
                                                                            phi_5712_ = f64();
                                                                        }
                                                                        let _e3565 = phi_5712_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_5708_ = _e3555;
                                                                            phi_5711_ = _e3565;
                                                                            break if !(_e3560);
                                                                        }
                                                                    }
                                                                    let _e3570 = local_20;
                                                                    phi_5765_ = (_e3570 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e3576 = phi_5765_;
                                                                let _e3584 = local_7.member[0u];
                                                                let _e3590 = select(_e3584[0], -(_e3584[0]), (_e3584[0] < 0.0lf));
                                                                let _e3593 = select(_e3584[1], -(_e3584[1]), (_e3584[1] < 0.0lf));
                                                                let _e3595 = select(_e3593, _e3590, (_e3590 > _e3593));
                                                                let _e3598 = select(_e3584[2], -(_e3584[2]), (_e3584[2] < 0.0lf));
                                                                let _e3600 = select(_e3598, _e3595, (_e3595 > _e3598));
                                                                let _e3603 = local_7.member[1u];
                                                                let _e3609 = select(_e3603[0], -(_e3603[0]), (_e3603[0] < 0.0lf));
                                                                let _e3612 = select(_e3603[1], -(_e3603[1]), (_e3603[1] < 0.0lf));
                                                                let _e3614 = select(_e3612, _e3609, (_e3609 > _e3612));
                                                                let _e3617 = select(_e3603[2], -(_e3603[2]), (_e3603[2] < 0.0lf));
                                                                let _e3619 = select(_e3617, _e3614, (_e3614 > _e3617));
                                                                let _e3623 = local_7.member_3;
                                                                let _e3627 = local_7.member_1[0u];
                                                                let _e3633 = select(_e3627[0], -(_e3627[0]), (_e3627[0] < 0.0lf));
                                                                let _e3636 = select(_e3627[1], -(_e3627[1]), (_e3627[1] < 0.0lf));
                                                                let _e3638 = select(_e3636, _e3633, (_e3633 > _e3636));
                                                                let _e3641 = select(_e3627[2], -(_e3627[2]), (_e3627[2] < 0.0lf));
                                                                let _e3643 = select(_e3641, _e3638, (_e3638 > _e3641));
                                                                let _e3646 = local_7.member_1[1u];
                                                                let _e3652 = select(_e3646[0], -(_e3646[0]), (_e3646[0] < 0.0lf));
                                                                let _e3655 = select(_e3646[1], -(_e3646[1]), (_e3646[1] < 0.0lf));
                                                                let _e3657 = select(_e3655, _e3652, (_e3652 > _e3655));
                                                                let _e3660 = select(_e3646[2], -(_e3646[2]), (_e3646[2] < 0.0lf));
                                                                let _e3662 = select(_e3660, _e3657, (_e3657 > _e3660));
                                                                let _e3666 = local_7.member_3;
                                                                let _e3670 = local_7.member_2[0u];
                                                                let _e3676 = select(_e3670[0], -(_e3670[0]), (_e3670[0] < 0.0lf));
                                                                let _e3679 = select(_e3670[1], -(_e3670[1]), (_e3670[1] < 0.0lf));
                                                                let _e3681 = select(_e3679, _e3676, (_e3676 > _e3679));
                                                                let _e3684 = select(_e3670[2], -(_e3670[2]), (_e3670[2] < 0.0lf));
                                                                let _e3686 = select(_e3684, _e3681, (_e3681 > _e3684));
                                                                let _e3689 = local_7.member_2[1u];
                                                                let _e3695 = select(_e3689[0], -(_e3689[0]), (_e3689[0] < 0.0lf));
                                                                let _e3698 = select(_e3689[1], -(_e3689[1]), (_e3689[1] < 0.0lf));
                                                                let _e3700 = select(_e3698, _e3695, (_e3695 > _e3698));
                                                                let _e3703 = select(_e3689[2], -(_e3689[2]), (_e3689[2] < 0.0lf));
                                                                let _e3705 = select(_e3703, _e3700, (_e3700 > _e3703));
                                                                let _e3709 = local_7.member_3;
                                                                let _e3717 = local_7.member_3;
                                                                phi_6042_ = select(true, false, (((_e3576 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e3619, _e3600, (_e3600 > _e3619)) + _e3623) + (select(_e3662, _e3643, (_e3643 > _e3662)) + _e3666)) + (select(_e3705, _e3686, (_e3686 > _e3705)) + _e3709)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3717 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e811));
                                                            } else {
                                                                phi_6042_ = true;
                                                            }
                                                            let _e3730 = phi_6042_;
                                                            phi_6043_ = _e3730;
                                                        } else {
                                                            phi_6043_ = true;
                                                        }
                                                        let _e3732 = phi_6043_;
                                                        if _e3732 {
                                                            if _e2696 {
                                                                let _e3736 = (_e3442 <= (_e2692 * f64(0.25f)));
                                                                phi_6070_ = select(select(select(f64(), f64(0f), _e3736), f64(), _e3443), (_e2998 + _e2998), select(select(true, false, _e3736), true, _e3443));
                                                            } else {
                                                                phi_6070_ = (_e2455.member_1 - _e2688);
                                                            }
                                                            let _e3745 = phi_6070_;
                                                            phi_6071_ = _e3745;
                                                            phi_6072_ = false;
                                                        } else {
                                                            phi_6071_ = f64();
                                                            phi_6072_ = true;
                                                        }
                                                        let _e3747 = phi_6071_;
                                                        let _e3749 = phi_6072_;
                                                        phi_6073_ = _e3747;
                                                        phi_6074_ = _e3442;
                                                        phi_6075_ = _e3732;
                                                        phi_6076_ = _e3749;
                                                    }
                                                    let _e3751 = phi_6073_;
                                                    let _e3753 = phi_6074_;
                                                    let _e3755 = phi_6075_;
                                                    let _e3757 = phi_6076_;
                                                    phi_6077_ = _e3440;
                                                    phi_6078_ = _e3751;
                                                    phi_6079_ = _e3753;
                                                    phi_6080_ = _e3440;
                                                    phi_6081_ = _e3755;
                                                    phi_6082_ = _e3441;
                                                    phi_6083_ = _e3757;
                                                    phi_6084_ = false;
                                                } else {
                                                    phi_6077_ = f64();
                                                    phi_6078_ = f64();
                                                    phi_6079_ = f64();
                                                    phi_6080_ = f64();
                                                    phi_6081_ = false;
                                                    phi_6082_ = false;
                                                    phi_6083_ = false;
                                                    phi_6084_ = true;
                                                }
                                                let _e3759 = phi_6077_;
                                                let _e3761 = phi_6078_;
                                                let _e3763 = phi_6079_;
                                                let _e3765 = phi_6080_;
                                                let _e3767 = phi_6081_;
                                                let _e3769 = phi_6082_;
                                                let _e3771 = phi_6083_;
                                                let _e3773 = phi_6084_;
                                                phi_6085_ = _e3759;
                                                phi_6086_ = _e3761;
                                                phi_6087_ = _e3763;
                                                phi_6088_ = _e3765;
                                                phi_6089_ = false;
                                                phi_6090_ = _e3767;
                                                phi_6091_ = _e3769;
                                                phi_6092_ = _e3771;
                                                phi_6093_ = _e3773;
                                            } else {
                                                phi_6085_ = f64();
                                                phi_6086_ = f64();
                                                phi_6087_ = f64();
                                                phi_6088_ = f64();
                                                phi_6089_ = true;
                                                phi_6090_ = false;
                                                phi_6091_ = false;
                                                phi_6092_ = false;
                                                phi_6093_ = false;
                                            }
                                            let _e3775 = phi_6085_;
                                            let _e3777 = phi_6086_;
                                            let _e3779 = phi_6087_;
                                            let _e3781 = phi_6088_;
                                            let _e3783 = phi_6089_;
                                            let _e3785 = phi_6090_;
                                            let _e3787 = phi_6091_;
                                            let _e3789 = phi_6092_;
                                            let _e3791 = phi_6093_;
                                            phi_6094_ = _e3775;
                                            phi_6095_ = _e3777;
                                            phi_6096_ = _e3779;
                                            phi_6097_ = _e3781;
                                            phi_6098_ = _e3783;
                                            phi_6099_ = _e3785;
                                            phi_6100_ = _e3787;
                                            phi_6101_ = _e3789;
                                            phi_6102_ = _e3791;
                                        } else {
                                            phi_6094_ = f64();
                                            phi_6095_ = f64();
                                            phi_6096_ = f64();
                                            phi_6097_ = f64();
                                            phi_6098_ = true;
                                            phi_6099_ = false;
                                            phi_6100_ = false;
                                            phi_6101_ = false;
                                            phi_6102_ = false;
                                        }
                                        let _e3793 = phi_6094_;
                                        let _e3795 = phi_6095_;
                                        let _e3797 = phi_6096_;
                                        let _e3799 = phi_6097_;
                                        let _e3801 = phi_6098_;
                                        let _e3803 = phi_6099_;
                                        let _e3805 = phi_6100_;
                                        let _e3807 = phi_6101_;
                                        let _e3809 = phi_6102_;
                                        if _e3801 {
                                            if (_e2688 <= _e2690) {
                                                let _e3967 = (_e2698 + 1u);
                                                let _e3968 = (_e3967 > 3u);
                                                phi_6442_ = _e3967;
                                                phi_6443_ = f64();
                                                phi_6444_ = false;
                                                phi_6445_ = select(true, false, _e3968);
                                                phi_6446_ = _e3968;
                                            } else {
                                                let _e3813 = local.member[0u];
                                                let _e3816 = local.member_1[0u];
                                                let _e3819 = local.member[0u];
                                                let _e3825 = local.member_2[0u];
                                                let _e3826 = ((_e3813 + ((_e3816 - _e3819) * _e2694)) - _e3825);
                                                let _e3829 = local.member[1u];
                                                let _e3832 = local.member_1[1u];
                                                let _e3835 = local.member[1u];
                                                let _e3841 = local.member_2[1u];
                                                let _e3842 = ((_e3829 + ((_e3832 - _e3835) * _e2694)) - _e3841);
                                                let _e3844 = select(_e3842, _e3826, (_e3826 < _e3842));
                                                let _e3847 = local.member[2u];
                                                let _e3850 = local.member_1[2u];
                                                let _e3853 = local.member[2u];
                                                let _e3859 = local.member_2[2u];
                                                let _e3860 = ((_e3847 + ((_e3850 - _e3853) * _e2694)) - _e3859);
                                                let _e3863 = local.member[3u];
                                                let _e3866 = local.member_1[3u];
                                                let _e3869 = local.member[3u];
                                                let _e3875 = local.member_2[3u];
                                                let _e3876 = ((_e3863 + ((_e3866 - _e3869) * _e2694)) - _e3875);
                                                let _e3878 = select(_e3876, _e3860, (_e3860 < _e3876));
                                                let _e3880 = select(_e3878, _e3844, (_e3844 < _e3878));
                                                let _e3883 = local_1.member[0u];
                                                let _e3886 = local_1.member_1[0u];
                                                let _e3889 = local_1.member[0u];
                                                let _e3895 = local_1.member_2[0u];
                                                let _e3896 = ((_e3883 + ((_e3886 - _e3889) * _e2688)) - _e3895);
                                                let _e3899 = local_1.member[1u];
                                                let _e3902 = local_1.member_1[1u];
                                                let _e3905 = local_1.member[1u];
                                                let _e3911 = local_1.member_2[1u];
                                                let _e3912 = ((_e3899 + ((_e3902 - _e3905) * _e2688)) - _e3911);
                                                let _e3914 = select(_e3912, _e3896, (_e3896 < _e3912));
                                                let _e3917 = local_1.member[2u];
                                                let _e3920 = local_1.member_1[2u];
                                                let _e3923 = local_1.member[2u];
                                                let _e3929 = local_1.member_2[2u];
                                                let _e3930 = ((_e3917 + ((_e3920 - _e3923) * _e2688)) - _e3929);
                                                let _e3933 = local_1.member[3u];
                                                let _e3936 = local_1.member_1[3u];
                                                let _e3939 = local_1.member[3u];
                                                let _e3945 = local_1.member_2[3u];
                                                let _e3946 = ((_e3933 + ((_e3936 - _e3939) * _e2688)) - _e3945);
                                                let _e3948 = select(_e3946, _e3930, (_e3930 < _e3946));
                                                let _e3950 = select(_e3948, _e3914, (_e3914 < _e3948));
                                                let _e3951 = f64(0.0625f);
                                                let _e3953 = f64(0.9f);
                                                if (_e3950 > f64(0f)) {
                                                    phi_6440_ = f64(0.5f);
                                                } else {
                                                    let _e3959 = (f64(0.95f) * (_e3880 / (_e3880 - _e3950)));
                                                    phi_6440_ = select(_e3951, select(_e3953, _e3959, (_e3959 < _e3953)), (_e3959 > _e3951));
                                                }
                                                let _e3965 = phi_6440_;
                                                phi_6442_ = u32();
                                                phi_6443_ = (_e2998 * _e3965);
                                                phi_6444_ = true;
                                                phi_6445_ = false;
                                                phi_6446_ = false;
                                            }
                                            let _e3971 = phi_6442_;
                                            let _e3973 = phi_6443_;
                                            let _e3975 = phi_6444_;
                                            let _e3977 = phi_6445_;
                                            let _e3979 = phi_6446_;
                                            phi_6447_ = _e3971;
                                            phi_6448_ = _e2690;
                                            phi_6449_ = _e3973;
                                            phi_6450_ = _e2692;
                                            phi_6451_ = _e2694;
                                            phi_6452_ = _e2696;
                                            phi_6453_ = _e2698;
                                            phi_6454_ = _e3975;
                                            phi_6455_ = _e3977;
                                            phi_6456_ = _e3979;
                                            phi_6457_ = false;
                                            phi_6458_ = false;
                                            phi_6459_ = false;
                                        } else {
                                            phi_6447_ = u32();
                                            phi_6448_ = _e3793;
                                            phi_6449_ = _e3795;
                                            phi_6450_ = _e3797;
                                            phi_6451_ = _e2688;
                                            phi_6452_ = true;
                                            phi_6453_ = 0u;
                                            phi_6454_ = _e3803;
                                            phi_6455_ = false;
                                            phi_6456_ = false;
                                            phi_6457_ = _e3805;
                                            phi_6458_ = _e3807;
                                            phi_6459_ = _e3809;
                                        }
                                        let _e3981 = phi_6447_;
                                        let _e3983 = phi_6448_;
                                        let _e3985 = phi_6449_;
                                        let _e3987 = phi_6450_;
                                        let _e3989 = phi_6451_;
                                        let _e3991 = phi_6452_;
                                        let _e3993 = phi_6453_;
                                        let _e3995 = phi_6454_;
                                        let _e3997 = phi_6455_;
                                        let _e3999 = phi_6456_;
                                        let _e4001 = phi_6457_;
                                        let _e4003 = phi_6458_;
                                        let _e4005 = phi_6459_;
                                        if _e3995 {
                                            let _e4006 = (_e3989 + _e3985);
                                            let _e4008 = select(_e3983, _e4006, (_e4006 > _e3983));
                                            let _e4010 = select(_e2455.member_1, _e4008, (_e4008 < _e2455.member_1));
                                            let _e4013 = select(((_e4010 - _e3989) > _e2677), true, !(_e2696));
                                            phi_6487_ = _e4010;
                                            phi_6488_ = _e3983;
                                            phi_6489_ = _e3987;
                                            phi_6490_ = _e3989;
                                            phi_6491_ = _e3991;
                                            phi_6492_ = _e3993;
                                            phi_6493_ = _e4013;
                                            phi_6494_ = select(true, false, _e4013);
                                            phi_6495_ = false;
                                            phi_6496_ = false;
                                            phi_6497_ = false;
                                            phi_6498_ = false;
                                        } else {
                                            phi_6487_ = _e2688;
                                            phi_6488_ = _e2690;
                                            phi_6489_ = _e2692;
                                            phi_6490_ = _e2694;
                                            phi_6491_ = _e2696;
                                            phi_6492_ = _e3981;
                                            phi_6493_ = _e3997;
                                            phi_6494_ = false;
                                            phi_6495_ = _e3999;
                                            phi_6496_ = _e4001;
                                            phi_6497_ = _e4003;
                                            phi_6498_ = _e4005;
                                        }
                                        let _e4016 = phi_6487_;
                                        let _e4018 = phi_6488_;
                                        let _e4020 = phi_6489_;
                                        let _e4022 = phi_6490_;
                                        let _e4024 = phi_6491_;
                                        let _e4026 = phi_6492_;
                                        let _e4028 = phi_6493_;
                                        let _e4030 = phi_6494_;
                                        let _e4032 = phi_6495_;
                                        let _e4034 = phi_6496_;
                                        let _e4036 = phi_6497_;
                                        let _e4038 = phi_6498_;
                                        phi_4277_ = _e4016;
                                        phi_4279_ = _e4018;
                                        phi_4281_ = _e4020;
                                        phi_4283_ = _e4022;
                                        phi_4285_ = _e4024;
                                        phi_4287_ = _e4026;
                                        phi_6499_ = _e3983;
                                        phi_6500_ = _e3799;
                                        phi_6501_ = _e4028;
                                        phi_6502_ = _e4030;
                                        phi_6503_ = _e4032;
                                        phi_6504_ = _e4034;
                                        phi_6505_ = _e4036;
                                        phi_6506_ = false;
                                        phi_6507_ = _e4038;
                                    } else {
                                        phi_4277_ = f64();
                                        phi_4279_ = f64();
                                        phi_4281_ = f64();
                                        phi_4283_ = f64();
                                        phi_4285_ = bool();
                                        phi_4287_ = u32();
                                        phi_6499_ = f64();
                                        phi_6500_ = f64();
                                        phi_6501_ = false;
                                        phi_6502_ = false;
                                        phi_6503_ = false;
                                        phi_6504_ = false;
                                        phi_6505_ = false;
                                        phi_6506_ = true;
                                        phi_6507_ = false;
                                    }
                                    let _e4040 = phi_4277_;
                                    let _e4042 = phi_4279_;
                                    let _e4044 = phi_4281_;
                                    let _e4046 = phi_4283_;
                                    let _e4048 = phi_4285_;
                                    let _e4050 = phi_4287_;
                                    let _e4052 = phi_6499_;
                                    let _e4054 = phi_6500_;
                                    let _e4056 = phi_6501_;
                                    let _e4058 = phi_6502_;
                                    let _e4060 = phi_6503_;
                                    let _e4062 = phi_6504_;
                                    let _e4064 = phi_6505_;
                                    let _e4066 = phi_6506_;
                                    let _e4068 = phi_6507_;
                                    local_21 = _e4058;
                                    local_22 = _e4060;
                                    local_23 = _e4058;
                                    local_24 = _e4062;
                                    local_25 = _e4058;
                                    local_26 = _e4064;
                                    local_27 = _e4058;
                                    local_28 = _e4066;
                                    local_29 = _e4058;
                                    local_30 = _e4068;
                                    local_32 = _e4058;
                                    local_33 = _e4054;
                                    local_34 = _e4052;
                                    continue;
                                    continuing {
                                        phi_4273_ = type_9(select(_e2686.member, (_e2686.member + 1u), _e2701), select(_e2686.member_1, _e2686.member_1, _e2701));
                                        phi_4276_ = _e4040;
                                        phi_4278_ = _e4042;
                                        phi_4280_ = _e4044;
                                        phi_4282_ = _e4046;
                                        phi_4284_ = _e4048;
                                        phi_4286_ = _e4050;
                                        break if !(_e4056);
                                    }
                                }
                                let _e4071 = local_21;
                                let _e4073 = local_22;
                                let _e4074 = select(_e4073, false, _e4071);
                                let _e4076 = local_23;
                                let _e4078 = local_24;
                                let _e4081 = local_25;
                                let _e4083 = local_26;
                                let _e4086 = local_27;
                                let _e4088 = local_28;
                                let _e4091 = local_29;
                                let _e4093 = local_30;
                                let _e4099 = local_31;
                                let _e4101 = select(select(_e4078, false, _e4076), false, _e4074);
                                let _e4104 = local_32;
                                let _e4111 = select(select(select(_e4083, false, _e4081), false, _e4074), false, _e4101);
                                let _e4117 = local_33;
                                let _e4119 = local_34;
                                let _e4121 = select(select(select(_e4104, false, _e4074), false, _e4101), true, _e4111);
                                let _e4126 = local_35;
                                let _e4128 = select(select(select(select(select(_e4088, false, _e4086), false, _e4074), false, _e4101), false, _e4111), true, _e4121);
                                let _e4135 = select(select(select(select(select(select(_e4093, false, _e4091), false, _e4074), false, _e4101), false, _e4111), false, _e4121), false, _e4128);
                                let _e4140 = select(select(select(select(select(_e4074, true, _e4101), false, _e4111), false, _e4121), false, _e4128), true, _e4135);
                                let _e4143 = (select(select(type_42().member, 1u, _e4128), select(select(select(type_42().member, 1u, _e4074), 0u, _e4101), 0u, _e4135), _e4140) != 0u);
                                phi_6575_ = select(select(type_42().member_1, select(_e4126, select(_e4119, _e4117, _e4111), _e4121), _e4128), select(select(select(type_42().member_1, _e4099, _e4074), type_42().member_1, _e4101), type_42().member_1, _e4135), _e4140);
                                phi_6576_ = select(true, false, _e4143);
                                phi_6577_ = _e4143;
                                phi_6578_ = false;
                                phi_6579_ = false;
                                phi_6580_ = false;
                            } else {
                                phi_6575_ = f64();
                                phi_6576_ = _e2463;
                                phi_6577_ = false;
                                phi_6578_ = _e2465;
                                phi_6579_ = _e2467;
                                phi_6580_ = _e2469;
                            }
                            let _e4146 = phi_6575_;
                            let _e4148 = phi_6576_;
                            let _e4150 = phi_6577_;
                            let _e4152 = phi_6578_;
                            let _e4154 = phi_6579_;
                            let _e4156 = phi_6580_;
                            phi_6581_ = _e2455;
                            phi_6582_ = _e2457;
                            phi_6583_ = _e4146;
                            phi_6584_ = _e2459;
                            phi_6585_ = _e4148;
                            phi_6586_ = _e4150;
                            phi_6587_ = false;
                            phi_6588_ = _e4152;
                            phi_6589_ = _e4154;
                            phi_6590_ = _e4156;
                        } else {
                            phi_6581_ = type_43();
                            phi_6582_ = bool();
                            phi_6583_ = f64();
                            phi_6584_ = type_43();
                            phi_6585_ = false;
                            phi_6586_ = false;
                            phi_6587_ = true;
                            phi_6588_ = false;
                            phi_6589_ = false;
                            phi_6590_ = false;
                        }
                        let _e4158 = phi_6581_;
                        let _e4160 = phi_6582_;
                        let _e4162 = phi_6583_;
                        let _e4164 = phi_6584_;
                        let _e4166 = phi_6585_;
                        let _e4168 = phi_6586_;
                        let _e4170 = phi_6587_;
                        let _e4172 = phi_6588_;
                        let _e4174 = phi_6589_;
                        let _e4176 = phi_6590_;
                        local_36 = _e4168;
                        local_37 = _e4160;
                        local_38 = _e4158;
                        local_39 = _e4162;
                        local_40 = _e4162;
                        local_41 = _e4162;
                        local_45 = _e4170;
                        local_46 = _e4172;
                        local_47 = _e4174;
                        local_48 = _e4176;
                        local_42 = _e4168;
                        local_43 = _e4164;
                        continue;
                        continuing {
                            phi_2373_ = type_9(select(_e1438.member, (_e1438.member + 1u), _e1441), select(_e1438.member_1, _e1438.member_1, _e1441));
                            break if !(_e4166);
                        }
                    }
                    let _e4179 = local_36;
                    if _e4179 {
                        let _e4181 = local_37;
                        if _e4181 {
                            let _e4183 = local_38;
                            let _e4186 = local_39;
                            let _e4188 = ((_e4183.member_1 - _e4186) <= _e1401);
                            let _e4193 = local_40;
                            phi_6606_ = type_42(select(type_42().member, 1u, _e4188), select(type_42().member_1, _e4193, _e4188));
                            phi_6607_ = select(true, false, _e4188);
                        } else {
                            phi_6606_ = type_42();
                            phi_6607_ = true;
                        }
                        let _e4198 = phi_6606_;
                        let _e4200 = phi_6607_;
                        let _e4205 = local_41;
                        phi_6613_ = type_42(select(_e4198.member, 2u, _e4200), select(_e4198.member_1, _e4205, _e4200));
                        phi_6614_ = false;
                        phi_6615_ = false;
                        phi_6616_ = false;
                        phi_6617_ = false;
                    } else {
                        phi_6613_ = type_42();
                        let _e4691 = local_45;
                        phi_6614_ = _e4691;
                        let _e4694 = local_46;
                        phi_6615_ = _e4694;
                        let _e4697 = local_47;
                        phi_6616_ = _e4697;
                        let _e4700 = local_48;
                        phi_6617_ = _e4700;
                    }
                    let _e4209 = phi_6613_;
                    let _e4211 = phi_6614_;
                    let _e4213 = phi_6615_;
                    let _e4215 = phi_6616_;
                    let _e4217 = phi_6617_;
                    let _e4224 = select(_e4213, false, _e4211);
                    let _e4228 = local_42;
                    let _e4235 = select(select(_e4215, false, _e4211), false, _e4224);
                    let _e4241 = select(select(select(_e4217, false, _e4211), false, _e4224), false, _e4235);
                    let _e4245 = local_43;
                    let _e4249 = select(select(_e4224, true, _e4235), true, _e4241);
                    phi_6659_ = type_42(select(_e4209.member, select(select(select(type_42().member, 0u, _e4224), 0u, _e4235), 1u, _e4241), _e4249), select(_e4209.member_1, select(select(select(type_42().member_1, type_42().member_1, _e4224), type_42().member_1, _e4235), _e4245.member, _e4241), _e4249));
                    phi_6660_ = type_42(select(type_42().member, 0u, _e4211), select(type_42().member_1, type_42().member_1, _e4211));
                    phi_6661_ = select(select(select(select(select(_e4228, false, _e4211), false, _e4224), false, _e4235), false, _e4241), true, _e4249);
                }
                let _e4260 = phi_6659_;
                let _e4262 = phi_6660_;
                let _e4264 = phi_6661_;
                let _e4267 = select(_e4262.member, _e4260.member, _e4264);
                let _e4270 = select(_e4262.member_1, _e4260.member_1, _e4264);
                let _e4276 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e4270 > _e526)), (_e4267 == 1u))));
                switch bitcast<i32>(_e4267) {
                    case 0: {
                        phi_6705_ = type_34(0u, _e4276, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4280 = function_1(_e4270);
                        phi_6705_ = type_34(0u, _e4276, _e4280, true);
                        break;
                    }
                    case 2: {
                        let _e4278 = function_1(_e4270);
                        phi_6705_ = type_34(1u, _e4276, _e4278, true);
                        break;
                    }
                    default: {
                        phi_6705_ = type_34();
                        break;
                    }
                }
                let _e4284 = phi_6705_;
                phi_6706_ = _e4284;
                phi_6707_ = type_9(_e190, _e193);
            } else {
                phi_6706_ = type_34(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_6707_ = type_9(0u, 0u);
            }
            let _e4286 = phi_6706_;
            let _e4288 = phi_6707_;
            let _e4293 = params.member.member.member_1;
            let _e4295 = ((_e4293 & 16u) != 0u);
            let _e4298 = select(true, false, (_e4286.member == 0u));
            let _e4301 = select(false, select(_e4298, true, _e4295), _e4286.member_3);
            if _e4286.member_3 {
                if _e4298 {
                } else {
                    let _e4306 = (_e4286.member_2[1] >> bitcast<u32>(20i));
                    if (_e4306 <= 896u) {
                        phi_6753_ = 0u;
                    } else {
                        phi_6753_ = ((((_e4306 - 896u) << bitcast<u32>(23i)) | ((_e4286.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e4286.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e4321 = phi_6753_;
                    let _e4323 = atomicMin((&earliest.member[0u]), _e4321);
                }
            }
            if (_e105 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4301 {
                let _e4327 = atomicAdd((&counters[0u]), 1u);
                phi_6767_ = _e4327;
            } else {
                phi_6767_ = 0u;
            }
            let _e4329 = phi_6767_;
            workgroupBarrier();
            if (_e105 == 0u) {
                let _e4332 = atomicLoad((&counters[0u]));
                if (_e4332 > 0u) {
                    let _e4335 = atomicAdd((&contacts.member[0u]), _e4332);
                    atomicStore((&counters[1u]), _e4335);
                }
            }
            workgroupBarrier();
            let _e4338 = atomicLoad((&counters[1u]));
            let _e4339 = (_e4338 + _e4329);
            if _e4301 {
                if _e4295 {
                    let _e4342 = params.member.member_1.member_3;
                    let _e4345 = params.member.member_2.member;
                    if (_e4339 < _e4342) {
                        let _e4347 = (7u * _e4339);
                        atomicStore((&contacts.member[(4u + _e4347)]), _e4345);
                        atomicStore((&contacts.member[(_e4347 + 5u)]), _e4286.member);
                        atomicStore((&contacts.member[(_e4347 + 6u)]), _e4288.member);
                        atomicStore((&contacts.member[(_e4347 + 7u)]), _e4288.member_1);
                        atomicStore((&contacts.member[(_e4347 + 8u)]), _e4286.member_2[0]);
                        atomicStore((&contacts.member[(_e4347 + 9u)]), _e4286.member_2[1]);
                        atomicStore((&contacts.member[(_e4347 + 10u)]), _e4286.member_1);
                    }
                    phi_6827_ = false;
                } else {
                    phi_6827_ = true;
                }
                let _e4369 = phi_6827_;
                phi_6828_ = _e4369;
            } else {
                phi_6828_ = true;
            }
            let _e4371 = phi_6828_;
            if _e4371 {
                if _e4301 {
                    let _e4374 = params.member.member_2.member_1;
                    if (_e4339 < _e4374) {
                        let _e4376 = (2u * _e4339);
                        atomicStore((&contacts.member[(4u + _e4376)]), _e4288.member);
                        atomicStore((&contacts.member[(_e4376 + 5u)]), _e4288.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_433_ = type_9(select(_e161.member, (_e161.member + 1u), _e164), select(_e161.member_1, _e161.member_1, _e164));
            break if !(_e177);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
