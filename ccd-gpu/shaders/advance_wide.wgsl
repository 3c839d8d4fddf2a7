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
    var phi_7478_: array<array<f64, 3>, 4>;

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
        phi_7478_ = array<array<f64, 3>, 4>(array<f64, 3>((param_8[0] - (param_9[0] * _e171)), (param_8[1] - (param_9[1] * _e171)), (param_8[2] - (param_9[2] * _e171))), array<f64, 3>((param_8[0] - (param_10[0] * _e215)), (param_8[1] - (param_10[1] * _e215)), (param_8[2] - (param_10[2] * _e215))), array<f64, 3>((_e9 - (param_10[0] * _e256)), (_e12 - (param_10[1] * _e256)), (_e15 - (param_10[2] * _e256))), array<f64, 3>((_e269 - (param_9[0] * _e303)), (_e272 - (param_9[1] * _e303)), (_e275 - (param_9[2] * _e303))));
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
        phi_7478_ = array<array<f64, 3>, 4>(array<f64, 3>((param_8[0] - (param_9[0] * _e82)), (param_8[1] - (param_9[1] * _e82)), (param_8[2] - (param_9[2] * _e82))), array<f64, 3>((param_8[0] - (param_10[0] * _e126)), (param_8[1] - (param_10[1] * _e126)), (param_8[2] - (param_10[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_7478_;
    let _e319 = function_3(_e316[0], _e316[1]);
    let _e321 = function_3(_e319, _e316[2]);
    let _e323 = function_3(_e321, _e316[3]);
    return _e323;
}

fn function_5(param_12: array<f64, 3>, param_13: array<f64, 3>, param_14: array<f64, 3>, param_15: u32) -> array<f64, 3> {
    var phi_7077_: bool;
    var phi_7111_: array<f64, 3>;
    var phi_7112_: bool;
    var phi_7113_: array<f64, 3>;
    var phi_7114_: bool;
    var phi_7119_: array<f64, 3>;

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
        phi_7077_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_7077_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_7077_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_7111_ = array<f64, 3>((param_12[0] - ((param_13[0] * _e76) + (param_14[0] * _e80))), (param_12[1] - ((param_13[1] * _e76) + (param_14[1] * _e80))), (param_12[2] - ((param_13[2] * _e76) + (param_14[2] * _e80))));
            phi_7112_ = false;
        } else {
            phi_7111_ = array<f64, 3>();
            phi_7112_ = true;
        }
        let _e132 = phi_7111_;
        let _e134 = phi_7112_;
        phi_7113_ = _e132;
        phi_7114_ = _e134;
    } else {
        phi_7113_ = array<f64, 3>();
        phi_7114_ = true;
    }
    let _e136 = phi_7113_;
    let _e138 = phi_7114_;
    if _e138 {
        let _e139 = function_4(param_12, param_13, param_14, param_15);
        phi_7119_ = _e139;
    } else {
        phi_7119_ = _e136;
    }
    let _e141 = phi_7119_;
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
    var phi_1356_: bool;
    var phi_1452_: type_41;
    var phi_1453_: bool;
    var phi_1454_: type_41;
    var phi_1455_: bool;
    var phi_1456_: type_41;
    var phi_1457_: bool;
    var phi_1462_: type_41;
    var phi_2164_: bool;
    var phi_2179_: f64;
    var phi_2255_: type_16;
    var phi_2258_: f64;
    var phi_2256_: type_16;
    var phi_2299_: type_17;
    var phi_2259_: f64;
    var local_9: f64;
    var phi_2312_: f64;
    var phi_2343_: type_9;
    var phi_2346_: u32;
    var phi_2413_: u32;
    var phi_2414_: u32;
    var phi_2347_: u32;
    var phi_2415_: u32;
    var phi_2473_: type_9;
    var phi_2633_: type_43;
    var phi_2634_: bool;
    var phi_2635_: type_43;
    var phi_2636_: bool;
    var phi_2671_: type_9;
    var phi_2674_: f64;
    var phi_2676_: f64;
    var phi_2678_: f64;
    var phi_2792_: bool;
    var phi_2799_: f64;
    var phi_2800_: bool;
    var phi_2675_: f64;
    var phi_2677_: f64;
    var phi_2679_: f64;
    var phi_2801_: f64;
    var phi_2802_: bool;
    var phi_2803_: bool;
    var local_10: bool;
    var local_11: f64;
    var local_12: f64;
    var phi_2808_: f64;
    var phi_2826_: type_9;
    var phi_2829_: f64;
    var phi_2895_: f64;
    var phi_2896_: bool;
    var phi_2897_: bool;
    var phi_2898_: bool;
    var phi_2899_: f64;
    var phi_2830_: f64;
    var phi_2900_: bool;
    var phi_2901_: bool;
    var phi_2902_: bool;
    var phi_2903_: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: f64;
    var phi_2917_: f64;
    var phi_2919_: type_43;
    var phi_3780_: array<type_36, 4>;
    var phi_3800_: type_9;
    var phi_3803_: bool;
    var phi_3804_: bool;
    var phi_3855_: bool;
    var phi_3856_: bool;
    var local_18: bool;
    var local_19: bool;
    var phi_3870_: u32;
    var phi_3871_: u32;
    var phi_3872_: bool;
    var phi_3903_: bool;
    var phi_3904_: bool;
    var phi_3905_: bool;
    var phi_3906_: bool;
    var phi_3907_: bool;
    var phi_3908_: bool;
    var phi_3909_: bool;
    var phi_3910_: bool;
    var phi_3911_: bool;
    var phi_3912_: bool;
    var phi_3913_: bool;
    var phi_3914_: bool;
    var phi_3915_: type_43;
    var phi_3916_: bool;
    var phi_3917_: type_43;
    var phi_3918_: bool;
    var phi_3919_: bool;
    var phi_3920_: bool;
    var phi_3921_: bool;
    var phi_3922_: type_43;
    var phi_3923_: bool;
    var phi_3924_: type_43;
    var phi_3925_: bool;
    var phi_3926_: bool;
    var phi_3927_: bool;
    var phi_3928_: bool;
    var phi_3929_: bool;
    var phi_3937_: type_43;
    var phi_3938_: bool;
    var phi_3939_: type_43;
    var phi_3940_: bool;
    var phi_3941_: bool;
    var phi_3942_: bool;
    var phi_3943_: bool;
    var phi_3944_: bool;
    var phi_4373_: type_9;
    var phi_4376_: f64;
    var phi_4378_: f64;
    var phi_4380_: f64;
    var phi_4382_: f64;
    var phi_4384_: bool;
    var phi_4386_: u32;
    var phi_4538_: array<f64, 3>;
    var phi_4606_: type_16;
    var phi_4609_: f64;
    var phi_4607_: type_16;
    var phi_4650_: type_17;
    var phi_4610_: f64;
    var local_20: f64;
    var phi_4663_: f64;
    var phi_4789_: type_44;
    var phi_4790_: bool;
    var phi_4791_: type_44;
    var phi_4792_: bool;
    var phi_4802_: type_44;
    var phi_4974_: bool;
    var phi_4975_: bool;
    var phi_4976_: bool;
    var phi_4977_: bool;
    var phi_4978_: bool;
    var phi_4979_: bool;
    var phi_5281_: bool;
    var phi_5282_: bool;
    var phi_5283_: bool;
    var phi_5284_: bool;
    var phi_5285_: bool;
    var phi_5286_: bool;
    var phi_5294_: bool;
    var phi_5404_: f64;
    var phi_5405_: bool;
    var phi_5406_: f64;
    var phi_5407_: bool;
    var phi_5408_: f64;
    var phi_5409_: bool;
    var phi_5410_: bool;
    var phi_5476_: f64;
    var phi_5477_: bool;
    var phi_5478_: f64;
    var phi_5479_: bool;
    var phi_5480_: f64;
    var phi_5481_: bool;
    var phi_5482_: bool;
    var phi_5553_: f64;
    var phi_5554_: bool;
    var phi_5555_: f64;
    var phi_5556_: bool;
    var phi_5557_: f64;
    var phi_5558_: bool;
    var phi_5559_: bool;
    var phi_5625_: f64;
    var phi_5626_: bool;
    var phi_5627_: f64;
    var phi_5628_: bool;
    var phi_5629_: f64;
    var phi_5630_: bool;
    var phi_5631_: bool;
    var phi_5808_: type_16;
    var phi_5811_: f64;
    var phi_5809_: type_16;
    var phi_5852_: type_17;
    var phi_5812_: f64;
    var local_21: f64;
    var phi_5865_: f64;
    var phi_6142_: bool;
    var phi_6143_: bool;
    var phi_6170_: f64;
    var phi_6171_: f64;
    var phi_6172_: bool;
    var phi_6173_: f64;
    var phi_6174_: f64;
    var phi_6175_: bool;
    var phi_6176_: bool;
    var phi_6177_: f64;
    var phi_6178_: f64;
    var phi_6179_: f64;
    var phi_6180_: f64;
    var phi_6181_: bool;
    var phi_6182_: bool;
    var phi_6183_: bool;
    var phi_6184_: bool;
    var phi_6185_: f64;
    var phi_6186_: f64;
    var phi_6187_: f64;
    var phi_6188_: f64;
    var phi_6189_: bool;
    var phi_6190_: bool;
    var phi_6191_: bool;
    var phi_6192_: bool;
    var phi_6193_: bool;
    var phi_6194_: f64;
    var phi_6195_: f64;
    var phi_6196_: f64;
    var phi_6197_: f64;
    var phi_6198_: bool;
    var phi_6199_: bool;
    var phi_6200_: bool;
    var phi_6201_: bool;
    var phi_6202_: bool;
    var phi_6540_: f64;
    var phi_6542_: u32;
    var phi_6543_: f64;
    var phi_6544_: bool;
    var phi_6545_: bool;
    var phi_6546_: bool;
    var phi_6547_: u32;
    var phi_6548_: f64;
    var phi_6549_: f64;
    var phi_6550_: f64;
    var phi_6551_: f64;
    var phi_6552_: bool;
    var phi_6553_: u32;
    var phi_6554_: bool;
    var phi_6555_: bool;
    var phi_6556_: bool;
    var phi_6557_: bool;
    var phi_6558_: bool;
    var phi_6559_: bool;
    var phi_6587_: f64;
    var phi_6588_: f64;
    var phi_6589_: f64;
    var phi_6590_: f64;
    var phi_6591_: bool;
    var phi_6592_: u32;
    var phi_6593_: bool;
    var phi_6594_: bool;
    var phi_6595_: bool;
    var phi_6596_: bool;
    var phi_6597_: bool;
    var phi_6598_: bool;
    var phi_4377_: f64;
    var phi_4379_: f64;
    var phi_4381_: f64;
    var phi_4383_: f64;
    var phi_4385_: bool;
    var phi_4387_: u32;
    var phi_6599_: f64;
    var phi_6600_: f64;
    var phi_6601_: bool;
    var phi_6602_: bool;
    var phi_6603_: bool;
    var phi_6604_: bool;
    var phi_6605_: bool;
    var phi_6606_: bool;
    var phi_6607_: bool;
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
    var phi_6675_: f64;
    var phi_6676_: bool;
    var phi_6677_: bool;
    var phi_6678_: bool;
    var phi_6679_: bool;
    var phi_6680_: bool;
    var phi_6681_: type_43;
    var phi_6682_: bool;
    var phi_6683_: f64;
    var phi_6684_: type_43;
    var phi_6685_: bool;
    var phi_6686_: bool;
    var phi_6687_: bool;
    var phi_6688_: bool;
    var phi_6689_: bool;
    var phi_6690_: bool;
    var local_37: bool;
    var local_38: bool;
    var local_39: type_43;
    var local_40: f64;
    var local_41: f64;
    var phi_6706_: type_42;
    var phi_6707_: bool;
    var local_42: f64;
    var phi_6713_: type_42;
    var phi_6714_: bool;
    var phi_6715_: bool;
    var phi_6716_: bool;
    var phi_6717_: bool;
    var local_43: bool;
    var local_44: type_43;
    var phi_6759_: type_42;
    var phi_6760_: type_42;
    var phi_6761_: bool;
    var phi_6805_: type_35;
    var phi_6814_: type_9;
    var phi_6843_: bool;
    var phi_6844_: bool;
    var phi_6887_: u32;
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
                if (_e676 <= f64(65536f)) {
                    phi_1356_ = (_e676 >= f64((1f / 65536f)));
                } else {
                    phi_1356_ = false;
                }
                let _e683 = phi_1356_;
                if _e683 {
                    phi_1456_ = type_41();
                    phi_1457_ = true;
                } else {
                    if (_e676 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e676) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e690 = (9214364837600034816lu - (bitcast<u64>(_e676) & 9218868437227405312lu));
                            let _e693 = bitcast<f64>(select(4503599627370496lu, _e690, (_e690 > 4503599627370496lu)));
                            let _e694 = (_e552 * _e693);
                            phi_1452_ = type_41(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e515.member[0][0] * _e693), (_e515.member[0][1] * _e693), (_e515.member[0][2] * _e693)), array<f64, 3>((_e515.member[1][0] * _e693), (_e515.member[1][1] * _e693), (_e515.member[1][2] * _e693))), array<array<f64, 3>, 2>(array<f64, 3>((_e515.member_1[0][0] * _e693), (_e515.member_1[0][1] * _e693), (_e515.member_1[0][2] * _e693)), array<f64, 3>((_e515.member_1[1][0] * _e693), (_e515.member_1[1][1] * _e693), (_e515.member_1[1][2] * _e693))), array<array<f64, 3>, 2>(array<f64, 3>((_e515.member_2[0][0] * _e693), (_e515.member_2[0][1] * _e693), (_e515.member_2[0][2] * _e693)), array<f64, 3>((_e515.member_2[1][0] * _e693), (_e515.member_2[1][1] * _e693), (_e515.member_2[1][2] * _e693))), ((_e515.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e693)), select(_e694, select(2.2250738585072014e-308lf, _e694, (_e694 > 2.2250738585072014e-308lf)), (_e552 > f64(0f))));
                            phi_1453_ = false;
                        } else {
                            phi_1452_ = type_41();
                            phi_1453_ = true;
                        }
                        let _e765 = phi_1452_;
                        let _e767 = phi_1453_;
                        phi_1454_ = _e765;
                        phi_1455_ = _e767;
                    } else {
                        phi_1454_ = type_41();
                        phi_1455_ = true;
                    }
                    let _e769 = phi_1454_;
                    let _e771 = phi_1455_;
                    phi_1456_ = _e769;
                    phi_1457_ = _e771;
                }
                let _e773 = phi_1456_;
                let _e775 = phi_1457_;
                if _e775 {
                    phi_1462_ = type_41(_e515, _e552);
                } else {
                    phi_1462_ = _e773;
                }
                let _e778 = phi_1462_;
                local_7 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e778.member.member[0][0], _e778.member.member[0][1], _e778.member.member[0][2]), array<f64, 3>(_e778.member.member[1][0], _e778.member.member[1][1], _e778.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e778.member.member_1[0][0], _e778.member.member_1[0][1], _e778.member.member_1[0][2]), array<f64, 3>(_e778.member.member_1[1][0], _e778.member.member_1[1][1], _e778.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e778.member.member_2[0][0], _e778.member.member_2[0][1], _e778.member.member_2[0][2]), array<f64, 3>(_e778.member.member_2[1][0], _e778.member.member_2[1][1], _e778.member.member_2[1][2])), _e778.member.member_3);
                let _e820 = local_7.member_1[0u];
                let _e826 = local_7.member_2[0u];
                let _e832 = ((_e820[1] * _e826[2]) - (_e820[2] * _e826[1]));
                let _e835 = ((_e820[2] * _e826[0]) - (_e820[0] * _e826[2]));
                let _e838 = ((_e820[0] * _e826[1]) - (_e820[1] * _e826[0]));
                let _e841 = local_7.member_1[1u];
                let _e847 = local_7.member_2[1u];
                let _e853 = ((_e841[1] * _e847[2]) - (_e841[2] * _e847[1]));
                let _e856 = ((_e841[2] * _e847[0]) - (_e841[0] * _e847[2]));
                let _e859 = ((_e841[0] * _e847[1]) - (_e841[1] * _e847[0]));
                let _e862 = local_7.member_1[0u];
                let _e868 = local_7.member_2[1u];
                let _e883 = local_7.member_1[1u];
                let _e889 = local_7.member_2[0u];
                let _e902 = (((_e862[1] * _e868[2]) - (_e862[2] * _e868[1])) + ((_e883[1] * _e889[2]) - (_e883[2] * _e889[1])));
                let _e903 = (((_e862[2] * _e868[0]) - (_e862[0] * _e868[2])) + ((_e883[2] * _e889[0]) - (_e883[0] * _e889[2])));
                let _e904 = (((_e862[0] * _e868[1]) - (_e862[1] * _e868[0])) + ((_e883[0] * _e889[1]) - (_e883[1] * _e889[0])));
                let _e907 = local_7.member[0u];
                let _e915 = (((_e907[0] * _e832) + (_e907[1] * _e835)) + (_e907[2] * _e838));
                let _e918 = local_7.member[1u];
                let _e929 = local_7.member[0u];
                let _e938 = ((((_e918[0] * _e832) + (_e918[1] * _e835)) + (_e918[2] * _e838)) + (((_e929[0] * _e902) + (_e929[1] * _e903)) + (_e929[2] * _e904)));
                let _e941 = local_7.member[0u];
                let _e952 = local_7.member[1u];
                let _e961 = ((((_e941[0] * _e853) + (_e941[1] * _e856)) + (_e941[2] * _e859)) + (((_e952[0] * _e902) + (_e952[1] * _e903)) + (_e952[2] * _e904)));
                let _e964 = local_7.member[1u];
                let _e972 = (((_e964[0] * _e853) + (_e964[1] * _e856)) + (_e964[2] * _e859));
                let _e975 = local_7.member[0u];
                let _e981 = select(_e975[0], -(_e975[0]), (_e975[0] < 0.0lf));
                let _e984 = select(_e975[1], -(_e975[1]), (_e975[1] < 0.0lf));
                let _e986 = select(_e984, _e981, (_e981 > _e984));
                let _e989 = select(_e975[2], -(_e975[2]), (_e975[2] < 0.0lf));
                let _e991 = select(_e989, _e986, (_e986 > _e989));
                let _e994 = local_7.member[1u];
                let _e1000 = select(_e994[0], -(_e994[0]), (_e994[0] < 0.0lf));
                let _e1003 = select(_e994[1], -(_e994[1]), (_e994[1] < 0.0lf));
                let _e1005 = select(_e1003, _e1000, (_e1000 > _e1003));
                let _e1008 = select(_e994[2], -(_e994[2]), (_e994[2] < 0.0lf));
                let _e1010 = select(_e1008, _e1005, (_e1005 > _e1008));
                let _e1014 = local_7.member_3;
                let _e1015 = (select(_e1010, _e991, (_e991 > _e1010)) + _e1014);
                let _e1018 = local_7.member_1[0u];
                let _e1024 = select(_e1018[0], -(_e1018[0]), (_e1018[0] < 0.0lf));
                let _e1027 = select(_e1018[1], -(_e1018[1]), (_e1018[1] < 0.0lf));
                let _e1029 = select(_e1027, _e1024, (_e1024 > _e1027));
                let _e1032 = select(_e1018[2], -(_e1018[2]), (_e1018[2] < 0.0lf));
                let _e1034 = select(_e1032, _e1029, (_e1029 > _e1032));
                let _e1037 = local_7.member_1[1u];
                let _e1043 = select(_e1037[0], -(_e1037[0]), (_e1037[0] < 0.0lf));
                let _e1046 = select(_e1037[1], -(_e1037[1]), (_e1037[1] < 0.0lf));
                let _e1048 = select(_e1046, _e1043, (_e1043 > _e1046));
                let _e1051 = select(_e1037[2], -(_e1037[2]), (_e1037[2] < 0.0lf));
                let _e1053 = select(_e1051, _e1048, (_e1048 > _e1051));
                let _e1057 = local_7.member_3;
                let _e1058 = (select(_e1053, _e1034, (_e1034 > _e1053)) + _e1057);
                let _e1061 = local_7.member_2[0u];
                let _e1067 = select(_e1061[0], -(_e1061[0]), (_e1061[0] < 0.0lf));
                let _e1070 = select(_e1061[1], -(_e1061[1]), (_e1061[1] < 0.0lf));
                let _e1072 = select(_e1070, _e1067, (_e1067 > _e1070));
                let _e1075 = select(_e1061[2], -(_e1061[2]), (_e1061[2] < 0.0lf));
                let _e1077 = select(_e1075, _e1072, (_e1072 > _e1075));
                let _e1080 = local_7.member_2[1u];
                let _e1086 = select(_e1080[0], -(_e1080[0]), (_e1080[0] < 0.0lf));
                let _e1089 = select(_e1080[1], -(_e1080[1]), (_e1080[1] < 0.0lf));
                let _e1091 = select(_e1089, _e1086, (_e1086 > _e1089));
                let _e1094 = select(_e1080[2], -(_e1080[2]), (_e1080[2] < 0.0lf));
                let _e1096 = select(_e1094, _e1091, (_e1091 > _e1094));
                let _e1100 = local_7.member_3;
                let _e1101 = (select(_e1096, _e1077, (_e1077 > _e1096)) + _e1100);
                let _e1102 = f64(1f);
                let _e1103 = f64(8f);
                let _e1113 = local_7.member_3;
                let _e1130 = (((((_e1015 * _e1103) * ((_e1058 * _e1103) * _e1101)) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1113 * f64(19f)) * ((_e1015 * (_e1058 + _e1101)) + (_e1058 * _e1101)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1102 + _e1015) * ((_e1102 + _e1058) * (_e1102 + _e1101)))));
                let _e1131 = f64(0f);
                let _e1132 = f64(3f);
                let _e1133 = (_e915 * _e1132);
                let _e1134 = (_e972 * _e1132);
                let _e1136 = select(_e1134, _e1133, (_e1133 < _e1134));
                let _e1138 = select(_e961, _e938, (_e938 < _e961));
                let _e1140 = select(_e1138, _e1136, (_e1136 < _e1138));
                let _e1142 = select(_e1134, _e1133, (_e1133 > _e1134));
                let _e1144 = select(_e961, _e938, (_e938 > _e961));
                let _e1147 = -(select(_e1144, _e1142, (_e1142 > _e1144)));
                if (select(_e1147, _e1140, (_e1140 > _e1147)) > _e1130) {
                    phi_6759_ = type_42(0u, type_42().member_1);
                    phi_6760_ = type_42();
                    phi_6761_ = true;
                } else {
                    let _e1155 = select(_e915, -(_e915), (_e915 < 0.0lf));
                    let _e1158 = select(_e938, -(_e938), (_e938 < 0.0lf));
                    let _e1160 = select(_e1158, _e1155, (_e1155 > _e1158));
                    let _e1163 = select(_e961, -(_e961), (_e961 < 0.0lf));
                    let _e1166 = select(_e972, -(_e972), (_e972 < 0.0lf));
                    let _e1168 = select(_e1166, _e1163, (_e1163 > _e1166));
                    let _e1170 = select(_e1168, _e1160, (_e1160 > _e1168));
                    let _e1172 = (2.2250738585072014e-308lf * f64(67108864f));
                    let _e1173 = f64(1f);
                    if (_e1170 >= _e1172) {
                        phi_2164_ = (_e1170 <= (_e1173 / _e1172));
                    } else {
                        phi_2164_ = false;
                    }
                    let _e1178 = phi_2164_;
                    if _e1178 {
                        phi_2179_ = (_e1173 / _e1170);
                    } else {
                        phi_2179_ = f64(0f);
                    }
                    let _e1188 = phi_2179_;
                    let _e1189 = f64(0.00000000000022737368f);
                    let _e1191 = (_e524 * f64(0.0625f));
                    local_5 = type_39(array<f64, 4>(_e915, _e938, _e961, _e972), ((_e1130 * f64(0.34f)) + (_e1170 * select(f64(2f), (1.1102230246251565e-16lf * f64(256f)), _e1178))), _e1188, select(_e1191, _e1189, (_e1189 < _e1191)));
                    let _e1196 = f64(0f);
                    let _e1197 = f64(1f);
                    let _e1198 = f64(3f);
                    let _e1201 = local_5.member[0u];
                    let _e1204 = local_5.member[1u];
                    let _e1207 = local_5.member[2u];
                    let _e1210 = local_5.member[3u];
                    let _e1217 = local_5.member_2;
                    let _e1218 = ((_e1204 - (_e1198 * _e1201)) * _e1217);
                    let _e1220 = local_5.member_2;
                    let _e1221 = ((_e1207 - _e1204) * _e1220);
                    let _e1223 = local_5.member_2;
                    let _e1224 = (((_e1198 * _e1210) - _e1207) * _e1223);
                    local_3[0u] = _e1196;
                    local_3[1u] = _e1197;
                    local_3[2u] = _e1197;
                    local_3[3u] = _e1197;
                    let _e1231 = ((_e1221 * _e1221) - (_e1218 * _e1224));
                    if (_e1231 > _e1196) {
                        if (_e1231 <= 2.2250738585072014e-308lf) {
                            phi_2312_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1231 > 0.0lf));
                        } else {
                            phi_2255_ = type_16(0i, 5i);
                            phi_2258_ = bitcast<f64>(((bitcast<u64>(_e1231) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1239 = phi_2255_;
                                let _e1241 = phi_2258_;
                                local_9 = _e1241;
                                if (_e1239.member < _e1239.member_1) {
                                    let _e1248 = (_e1239.member + 1i);
                                    phi_2256_ = type_16(select(_e1248, type_17().member_1, select(false, true, ((false == (_e1248 > _e1239.member)) != false))), _e1239.member_1);
                                    phi_2299_ = type_17(1u, _e1239.member);
                                } else {
                                    phi_2256_ = _e1239;
                                    phi_2299_ = type_17(0u, type_17().member_1);
                                }
                                let _e1259 = phi_2256_;
                                let _e1261 = phi_2299_;
                                let _e1264 = (bitcast<i32>(_e1261.member) != 0i);
                                if _e1264 {
                                    phi_2259_ = (0.5lf * (_e1241 + (_e1231 / _e1241)));
                                } else {
                                    phi_2259_ = f64();
                                }
                                let _e1269 = phi_2259_;
                                continue;
                                continuing {
                                    phi_2255_ = _e1259;
                                    phi_2258_ = _e1269;
                                    break if !(_e1264);
                                }
                            }
                            let _e1274 = local_9;
                            phi_2312_ = (_e1274 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1280 = phi_2312_;
                        let _e1285 = -((_e1221 + select(_e1280, -(_e1280), (_e1221 < _e1196))));
                        local_4[0u] = (_e1285 / (_e1285 + _e1224));
                        local_4[1u] = (_e1218 / (_e1218 + _e1285));
                        let _e1294 = local_4[1u];
                        let _e1295 = local_4[0u];
                        if (_e1294 < _e1295) {
                            let _e1298 = local_4[1u];
                            let _e1300 = local_4[0u];
                            local_4[0u] = _e1298;
                            local_4[1u] = _e1300;
                        }
                        phi_2343_ = type_9(0u, 2u);
                        phi_2346_ = 1u;
                        loop {
                            let _e1304 = phi_2343_;
                            let _e1306 = phi_2346_;
                            local_45 = _e1306;
                            let _e1309 = (_e1304.member < _e1304.member_1);
                            let _e1320 = select(type_9().member_1, _e1304.member, _e1309);
                            let _e1322 = (bitcast<i32>(select(0u, 1u, _e1309)) != 0i);
                            if _e1322 {
                                let _e1324 = local_4[_e1320];
                                if (_e1324 > _e1196) {
                                    let _e1327 = local_4[_e1320];
                                    if (_e1327 < _e1197) {
                                        let _e1330 = local_4[_e1320];
                                        local_3[_e1306] = _e1330;
                                        phi_2413_ = (_e1306 + 1u);
                                    } else {
                                        phi_2413_ = _e1306;
                                    }
                                    let _e1334 = phi_2413_;
                                    phi_2414_ = _e1334;
                                } else {
                                    phi_2414_ = _e1306;
                                }
                                let _e1336 = phi_2414_;
                                phi_2347_ = _e1336;
                            } else {
                                phi_2347_ = u32();
                            }
                            let _e1338 = phi_2347_;
                            continue;
                            continuing {
                                phi_2343_ = type_9(select(_e1304.member, (_e1304.member + 1u), _e1309), select(_e1304.member_1, _e1304.member_1, _e1309));
                                phi_2346_ = _e1338;
                                break if !(_e1322);
                            }
                        }
                        let _e4358 = local_45;
                        phi_2415_ = _e4358;
                    } else {
                        phi_2415_ = 1u;
                    }
                    let _e1341 = phi_2415_;
                    local_3[_e1341] = _e1197;
                    let _e1343 = local_3;
                    local_6 = _e1343;
                    let _e1345 = (_e524 * f64(0.99f));
                    let _e1347 = (f64(1f) - _e533);
                    let _e1350 = local_5.member[0u];
                    let _e1353 = local_5.member[1u];
                    let _e1356 = local_5.member[2u];
                    let _e1359 = local_5.member[3u];
                    let _e1370 = ((((_e1350 * _e1347) + (_e1353 * _e533)) * (_e1347 * _e1347)) + (((_e1356 * _e1347) + (_e1359 * _e533)) * (_e533 * _e533)));
                    let _e1375 = local_5.member_1;
                    phi_2473_ = type_9(select(1u, 0u, !((select(_e1370, -(_e1370), (_e1370 < 0.0lf)) > _e1375))), (_e1341 + 1u));
                    loop {
                        let _e1382 = phi_2473_;
                        let _e1385 = (_e1382.member < _e1382.member_1);
                        let _e1396 = select(type_9().member_1, _e1382.member, _e1385);
                        if (bitcast<i32>(select(0u, 1u, _e1385)) != 0i) {
                            if (_e1396 > 0u) {
                                let _e1403 = local_6[(_e1396 - 1u)];
                                let _e1405 = select(_e533, _e1403, (_e1403 > _e533));
                                let _e1407 = local_6[_e1396];
                                let _e1409 = select(_e542, _e1407, (_e1407 < _e542));
                                if (_e1405 <= _e1409) {
                                    let _e1411 = function_1((&local_5), _e551, _e1405, _e1409);
                                    if _e1411 {
                                        phi_3915_ = type_43();
                                        phi_3916_ = bool();
                                        phi_3917_ = type_43();
                                        phi_3918_ = false;
                                        phi_3919_ = false;
                                        phi_3920_ = false;
                                        phi_3921_ = false;
                                    } else {
                                        let _e1413 = (f64(1f) - _e1405);
                                        let _e1416 = local_5.member[0u];
                                        let _e1419 = local_5.member[1u];
                                        let _e1422 = local_5.member[2u];
                                        let _e1425 = local_5.member[3u];
                                        let _e1436 = ((((_e1416 * _e1413) + (_e1419 * _e1405)) * (_e1413 * _e1413)) + (((_e1422 * _e1413) + (_e1425 * _e1405)) * (_e1405 * _e1405)));
                                        let _e1438 = (f64(1f) - _e1409);
                                        let _e1441 = local_5.member[0u];
                                        let _e1444 = local_5.member[1u];
                                        let _e1447 = local_5.member[2u];
                                        let _e1450 = local_5.member[3u];
                                        let _e1461 = ((((_e1441 * _e1438) + (_e1444 * _e1409)) * (_e1438 * _e1438)) + (((_e1447 * _e1438) + (_e1450 * _e1409)) * (_e1409 * _e1409)));
                                        let _e1466 = local_5.member_1;
                                        let _e1467 = (select(_e1436, -(_e1436), (_e1436 < 0.0lf)) > _e1466);
                                        let _e1472 = local_5.member_1;
                                        let _e1473 = (select(_e1461, -(_e1461), (_e1461 < 0.0lf)) > _e1472);
                                        let _e1474 = f64(0f);
                                        let _e1482 = select(select(bool(), select(bool(), ((_e1436 > _e1474) != (_e1461 > _e1474)), _e1473), _e1467), false, select(true, select(true, false, _e1473), _e1467));
                                        if _e1467 {
                                            if _e1473 {
                                                phi_2633_ = type_43(select(f64(1f), type_43().member, _e1482), select(_e1474, type_43().member_1, _e1482), select(_e1482, type_43().member_2, _e1482));
                                                phi_2634_ = _e1482;
                                            } else {
                                                phi_2633_ = type_43();
                                                phi_2634_ = true;
                                            }
                                            let _e1492 = phi_2633_;
                                            let _e1494 = phi_2634_;
                                            phi_2635_ = _e1492;
                                            phi_2636_ = _e1494;
                                        } else {
                                            phi_2635_ = type_43();
                                            phi_2636_ = true;
                                        }
                                        let _e1496 = phi_2635_;
                                        let _e1498 = phi_2636_;
                                        if _e1498 {
                                            if _e1467 {
                                                let _e1502 = select(f64(1f), f64(-1f), (_e1436 < _e1474));
                                                let _e1504 = local_5.member_3;
                                                let _e1505 = f64(0.5f);
                                                let _e1506 = f64(3f);
                                                let _e1509 = local_5.member[0u];
                                                let _e1512 = local_5.member[1u];
                                                let _e1515 = local_5.member[2u];
                                                let _e1518 = local_5.member[3u];
                                                let _e1521 = (_e1515 - _e1512);
                                                phi_2671_ = type_9(0u, 64u);
                                                phi_2674_ = _e1409;
                                                phi_2676_ = _e1405;
                                                phi_2678_ = (_e1505 * (_e1405 + _e1409));
                                                loop {
                                                    let _e1527 = phi_2671_;
                                                    let _e1529 = phi_2674_;
                                                    let _e1531 = phi_2676_;
                                                    let _e1533 = phi_2678_;
                                                    local_12 = _e1531;
                                                    let _e1536 = (_e1527.member < _e1527.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1536)) != 0i) {
                                                        let _e1549 = (f64(1f) - _e1533);
                                                        let _e1552 = local_5.member[0u];
                                                        let _e1555 = local_5.member[1u];
                                                        let _e1558 = local_5.member[2u];
                                                        let _e1561 = local_5.member[3u];
                                                        let _e1575 = local_5.member_1;
                                                        let _e1576 = ((_e1502 * ((((_e1552 * _e1549) + (_e1555 * _e1533)) * (_e1549 * _e1549)) + (((_e1558 * _e1549) + (_e1561 * _e1533)) * (_e1533 * _e1533)))) - _e1575);
                                                        let _e1578 = (_e1576 > f64(0f));
                                                        let _e1579 = select(_e1533, _e1529, _e1578);
                                                        let _e1580 = select(_e1531, _e1533, _e1578);
                                                        let _e1582 = ((_e1579 - _e1580) > _e1504);
                                                        if _e1582 {
                                                            let _e1584 = (f64(1f) - _e1533);
                                                            let _e1596 = (-(_e1576) / (_e1502 * (((((_e1512 - (_e1506 * _e1509)) * _e1584) + (_e1521 * _e1533)) * _e1584) + (((_e1521 * _e1584) + (((_e1506 * _e1518) - _e1515) * _e1533)) * _e1533))));
                                                            let _e1604 = ((_e1533 + _e1596) + select(-((_e1505 * _e1504)), (_e1505 * _e1504), (_e1576 > f64(0f))));
                                                            if (_e1604 > _e1580) {
                                                                phi_2792_ = select(true, select(true, false, (select(_e1596, -(_e1596), (_e1596 < 0.0lf)) < (_e1505 * (_e1579 - _e1580)))), (_e1604 < _e1579));
                                                            } else {
                                                                phi_2792_ = true;
                                                            }
                                                            let _e1616 = phi_2792_;
                                                            phi_2799_ = select(_e1604, (_e1505 * (_e1580 + _e1579)), _e1616);
                                                            phi_2800_ = false;
                                                        } else {
                                                            phi_2799_ = f64();
                                                            phi_2800_ = true;
                                                        }
                                                        let _e1621 = phi_2799_;
                                                        let _e1623 = phi_2800_;
                                                        phi_2675_ = _e1579;
                                                        phi_2677_ = _e1580;
                                                        phi_2679_ = _e1621;
                                                        phi_2801_ = _e1580;
                                                        phi_2802_ = _e1582;
                                                        phi_2803_ = _e1623;
                                                    } else {
                                                        phi_2675_ = f64();
                                                        phi_2677_ = f64();
                                                        phi_2679_ = f64();
                                                        phi_2801_ = f64();
                                                        phi_2802_ = false;
                                                        phi_2803_ = false;
                                                    }
                                                    let _e1625 = phi_2675_;
                                                    let _e1627 = phi_2677_;
                                                    let _e1629 = phi_2679_;
                                                    let _e1631 = phi_2801_;
                                                    let _e1633 = phi_2802_;
                                                    let _e1635 = phi_2803_;
                                                    local_10 = _e1635;
                                                    local_11 = _e1631;
                                                    continue;
                                                    continuing {
                                                        phi_2671_ = type_9(select(_e1527.member, (_e1527.member + 1u), _e1536), select(_e1527.member_1, _e1527.member_1, _e1536));
                                                        phi_2674_ = _e1625;
                                                        phi_2676_ = _e1627;
                                                        phi_2678_ = _e1629;
                                                        break if !(_e1633);
                                                    }
                                                }
                                                let _e1638 = local_10;
                                                let _e1640 = local_11;
                                                let _e1642 = local_12;
                                                phi_2808_ = select(_e1642, _e1640, _e1638);
                                            } else {
                                                phi_2808_ = _e1405;
                                            }
                                            let _e1645 = phi_2808_;
                                            if _e1473 {
                                                let _e1651 = local_5.member_3;
                                                let _e1653 = local_5.member_3;
                                                phi_2826_ = type_9(0u, 64u);
                                                phi_2829_ = (_e1651 + _e1653);
                                                loop {
                                                    let _e1656 = phi_2826_;
                                                    let _e1658 = phi_2829_;
                                                    let _e1661 = (_e1656.member < _e1656.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1661)) != 0i) {
                                                        let _e1673 = (_e1645 + _e1658);
                                                        if (_e1673 < _e1409) {
                                                            let _e1676 = (f64(1f) - _e1673);
                                                            let _e1679 = local_5.member[0u];
                                                            let _e1682 = local_5.member[1u];
                                                            let _e1685 = local_5.member[2u];
                                                            let _e1688 = local_5.member[3u];
                                                            let _e1702 = local_5.member_1;
                                                            let _e1703 = ((select(f64(1f), f64(-1f), (_e1461 < _e1474)) * ((((_e1679 * _e1676) + (_e1682 * _e1673)) * (_e1676 * _e1676)) + (((_e1685 * _e1676) + (_e1688 * _e1673)) * (_e1673 * _e1673)))) > _e1702);
                                                            phi_2895_ = select((_e1658 + _e1658), f64(), _e1703);
                                                            phi_2896_ = select(true, false, _e1703);
                                                            phi_2897_ = _e1703;
                                                            phi_2898_ = false;
                                                        } else {
                                                            phi_2895_ = f64();
                                                            phi_2896_ = false;
                                                            phi_2897_ = false;
                                                            phi_2898_ = true;
                                                        }
                                                        let _e1708 = phi_2895_;
                                                        let _e1710 = phi_2896_;
                                                        let _e1712 = phi_2897_;
                                                        let _e1714 = phi_2898_;
                                                        phi_2899_ = _e1673;
                                                        phi_2830_ = _e1708;
                                                        phi_2900_ = _e1710;
                                                        phi_2901_ = _e1712;
                                                        phi_2902_ = _e1714;
                                                        phi_2903_ = false;
                                                    } else {
                                                        phi_2899_ = f64();
                                                        phi_2830_ = f64();
                                                        phi_2900_ = false;
                                                        phi_2901_ = false;
                                                        phi_2902_ = false;
                                                        phi_2903_ = true;
                                                    }
                                                    let _e1716 = phi_2899_;
                                                    let _e1718 = phi_2830_;
                                                    let _e1720 = phi_2900_;
                                                    let _e1722 = phi_2901_;
                                                    let _e1724 = phi_2902_;
                                                    let _e1726 = phi_2903_;
                                                    local_13 = _e1722;
                                                    local_14 = _e1724;
                                                    local_15 = _e1722;
                                                    local_16 = _e1726;
                                                    local_17 = _e1716;
                                                    continue;
                                                    continuing {
                                                        phi_2826_ = type_9(select(_e1656.member, (_e1656.member + 1u), _e1661), select(_e1656.member_1, _e1656.member_1, _e1661));
                                                        phi_2829_ = _e1718;
                                                        break if !(_e1720);
                                                    }
                                                }
                                                let _e1729 = local_13;
                                                let _e1731 = local_14;
                                                let _e1734 = local_15;
                                                let _e1736 = local_16;
                                                let _e1740 = local_17;
                                                phi_2917_ = select(_e1740, _e1409, select(select(_e1736, false, _e1734), true, select(_e1731, false, _e1729)));
                                            } else {
                                                phi_2917_ = _e1409;
                                            }
                                            let _e1743 = phi_2917_;
                                            phi_2919_ = type_43(_e1645, _e1743, _e1482);
                                        } else {
                                            phi_2919_ = _e1496;
                                        }
                                        let _e1746 = phi_2919_;
                                        if (_e1746.member > _e1746.member_1) {
                                            phi_3910_ = bool();
                                            phi_3911_ = true;
                                            phi_3912_ = false;
                                            phi_3913_ = false;
                                            phi_3914_ = false;
                                        } else {
                                            let _e1751 = (_e1746.member > _e551);
                                            if _e1751 {
                                                phi_3906_ = bool();
                                                phi_3907_ = false;
                                                phi_3908_ = false;
                                                phi_3909_ = false;
                                            } else {
                                                let _e1756 = ((_e1746.member_1 - _e1746.member) * f64(0.5f));
                                                let _e1757 = (_e1746.member + _e1756);
                                                let _e1760 = (_e1756 + (1.1102230246251565e-16lf * f64(4f)));
                                                let _e1762 = local_7.member_3;
                                                let _e1765 = local_7.member[0u];
                                                let _e1771 = select(_e1765[0], -(_e1765[0]), (_e1765[0] < 0.0lf));
                                                let _e1774 = select(_e1765[1], -(_e1765[1]), (_e1765[1] < 0.0lf));
                                                let _e1776 = select(_e1774, _e1771, (_e1771 > _e1774));
                                                let _e1779 = select(_e1765[2], -(_e1765[2]), (_e1765[2] < 0.0lf));
                                                let _e1781 = select(_e1779, _e1776, (_e1776 > _e1779));
                                                let _e1783 = local_7.member[1u];
                                                let _e1789 = select(_e1783[0], -(_e1783[0]), (_e1783[0] < 0.0lf));
                                                let _e1792 = select(_e1783[1], -(_e1783[1]), (_e1783[1] < 0.0lf));
                                                let _e1794 = select(_e1792, _e1789, (_e1789 > _e1792));
                                                let _e1797 = select(_e1783[2], -(_e1783[2]), (_e1783[2] < 0.0lf));
                                                let _e1799 = select(_e1797, _e1794, (_e1794 > _e1797));
                                                let _e1804 = local_7.member[0u];
                                                let _e1809 = local_7.member[1u];
                                                let _e1819 = (_e1804[0] + ((_e1809[0] - _e1804[0]) * _e1757));
                                                let _e1820 = (_e1804[1] + ((_e1809[1] - _e1804[1]) * _e1757));
                                                let _e1821 = (_e1804[2] + ((_e1809[2] - _e1804[2]) * _e1757));
                                                let _e1823 = local_7.member[1u];
                                                let _e1828 = local_7.member[0u];
                                                let _e1832 = (_e1823[0] - _e1828[0]);
                                                let _e1833 = (_e1823[1] - _e1828[1]);
                                                let _e1834 = (_e1823[2] - _e1828[2]);
                                                let _e1837 = select(_e1832, -(_e1832), (_e1832 < 0.0lf));
                                                let _e1840 = select(_e1833, -(_e1833), (_e1833 < 0.0lf));
                                                let _e1842 = select(_e1840, _e1837, (_e1837 > _e1840));
                                                let _e1845 = select(_e1834, -(_e1834), (_e1834 < 0.0lf));
                                                let _e1855 = ((((_e1760 * select(_e1845, _e1842, (_e1842 > _e1845))) * f64(1.01f)) + ((select(_e1799, _e1781, (_e1781 > _e1799)) + _e1762) * (1.1102230246251565e-16lf * f64(8f)))) + _e1762);
                                                let _e1858 = select(_e1819, -(_e1819), (_e1819 < 0.0lf));
                                                let _e1861 = select(_e1820, -(_e1820), (_e1820 < 0.0lf));
                                                let _e1863 = select(_e1861, _e1858, (_e1858 > _e1861));
                                                let _e1866 = select(_e1821, -(_e1821), (_e1821 < 0.0lf));
                                                let _e1869 = (select(_e1866, _e1863, (_e1863 > _e1866)) + _e1855);
                                                let _e1872 = local_7.member_3;
                                                let _e1874 = local_7.member_1[0u];
                                                let _e1880 = select(_e1874[0], -(_e1874[0]), (_e1874[0] < 0.0lf));
                                                let _e1883 = select(_e1874[1], -(_e1874[1]), (_e1874[1] < 0.0lf));
                                                let _e1885 = select(_e1883, _e1880, (_e1880 > _e1883));
                                                let _e1888 = select(_e1874[2], -(_e1874[2]), (_e1874[2] < 0.0lf));
                                                let _e1890 = select(_e1888, _e1885, (_e1885 > _e1888));
                                                let _e1892 = local_7.member_1[1u];
                                                let _e1898 = select(_e1892[0], -(_e1892[0]), (_e1892[0] < 0.0lf));
                                                let _e1901 = select(_e1892[1], -(_e1892[1]), (_e1892[1] < 0.0lf));
                                                let _e1903 = select(_e1901, _e1898, (_e1898 > _e1901));
                                                let _e1906 = select(_e1892[2], -(_e1892[2]), (_e1892[2] < 0.0lf));
                                                let _e1908 = select(_e1906, _e1903, (_e1903 > _e1906));
                                                let _e1913 = local_7.member_1[0u];
                                                let _e1918 = local_7.member_1[1u];
                                                let _e1928 = (_e1913[0] + ((_e1918[0] - _e1913[0]) * _e1757));
                                                let _e1929 = (_e1913[1] + ((_e1918[1] - _e1913[1]) * _e1757));
                                                let _e1930 = (_e1913[2] + ((_e1918[2] - _e1913[2]) * _e1757));
                                                let _e1932 = local_7.member_1[1u];
                                                let _e1937 = local_7.member_1[0u];
                                                let _e1941 = (_e1932[0] - _e1937[0]);
                                                let _e1942 = (_e1932[1] - _e1937[1]);
                                                let _e1943 = (_e1932[2] - _e1937[2]);
                                                let _e1946 = select(_e1941, -(_e1941), (_e1941 < 0.0lf));
                                                let _e1949 = select(_e1942, -(_e1942), (_e1942 < 0.0lf));
                                                let _e1951 = select(_e1949, _e1946, (_e1946 > _e1949));
                                                let _e1954 = select(_e1943, -(_e1943), (_e1943 < 0.0lf));
                                                let _e1964 = ((((_e1760 * select(_e1954, _e1951, (_e1951 > _e1954))) * f64(1.01f)) + ((select(_e1908, _e1890, (_e1890 > _e1908)) + _e1872) * (1.1102230246251565e-16lf * f64(8f)))) + _e1872);
                                                let _e1967 = select(_e1928, -(_e1928), (_e1928 < 0.0lf));
                                                let _e1970 = select(_e1929, -(_e1929), (_e1929 < 0.0lf));
                                                let _e1972 = select(_e1970, _e1967, (_e1967 > _e1970));
                                                let _e1975 = select(_e1930, -(_e1930), (_e1930 < 0.0lf));
                                                let _e1978 = (select(_e1975, _e1972, (_e1972 > _e1975)) + _e1964);
                                                let _e1981 = local_7.member_3;
                                                let _e1983 = local_7.member_2[0u];
                                                let _e1989 = select(_e1983[0], -(_e1983[0]), (_e1983[0] < 0.0lf));
                                                let _e1992 = select(_e1983[1], -(_e1983[1]), (_e1983[1] < 0.0lf));
                                                let _e1994 = select(_e1992, _e1989, (_e1989 > _e1992));
                                                let _e1997 = select(_e1983[2], -(_e1983[2]), (_e1983[2] < 0.0lf));
                                                let _e1999 = select(_e1997, _e1994, (_e1994 > _e1997));
                                                let _e2001 = local_7.member_2[1u];
                                                let _e2007 = select(_e2001[0], -(_e2001[0]), (_e2001[0] < 0.0lf));
                                                let _e2010 = select(_e2001[1], -(_e2001[1]), (_e2001[1] < 0.0lf));
                                                let _e2012 = select(_e2010, _e2007, (_e2007 > _e2010));
                                                let _e2015 = select(_e2001[2], -(_e2001[2]), (_e2001[2] < 0.0lf));
                                                let _e2017 = select(_e2015, _e2012, (_e2012 > _e2015));
                                                let _e2022 = local_7.member_2[0u];
                                                let _e2027 = local_7.member_2[1u];
                                                let _e2037 = (_e2022[0] + ((_e2027[0] - _e2022[0]) * _e1757));
                                                let _e2038 = (_e2022[1] + ((_e2027[1] - _e2022[1]) * _e1757));
                                                let _e2039 = (_e2022[2] + ((_e2027[2] - _e2022[2]) * _e1757));
                                                let _e2041 = local_7.member_2[1u];
                                                let _e2046 = local_7.member_2[0u];
                                                let _e2050 = (_e2041[0] - _e2046[0]);
                                                let _e2051 = (_e2041[1] - _e2046[1]);
                                                let _e2052 = (_e2041[2] - _e2046[2]);
                                                let _e2055 = select(_e2050, -(_e2050), (_e2050 < 0.0lf));
                                                let _e2058 = select(_e2051, -(_e2051), (_e2051 < 0.0lf));
                                                let _e2060 = select(_e2058, _e2055, (_e2055 > _e2058));
                                                let _e2063 = select(_e2052, -(_e2052), (_e2052 < 0.0lf));
                                                let _e2073 = ((((_e1760 * select(_e2063, _e2060, (_e2060 > _e2063))) * f64(1.01f)) + ((select(_e2017, _e1999, (_e1999 > _e2017)) + _e1981) * (1.1102230246251565e-16lf * f64(8f)))) + _e1981);
                                                let _e2076 = select(_e2037, -(_e2037), (_e2037 < 0.0lf));
                                                let _e2079 = select(_e2038, -(_e2038), (_e2038 < 0.0lf));
                                                let _e2081 = select(_e2079, _e2076, (_e2076 > _e2079));
                                                let _e2084 = select(_e2039, -(_e2039), (_e2039 < 0.0lf));
                                                let _e2087 = (select(_e2084, _e2081, (_e2081 > _e2084)) + _e2073);
                                                let _e2090 = ((_e1929 * _e2039) - (_e1930 * _e2038));
                                                let _e2093 = ((_e1930 * _e2037) - (_e1928 * _e2039));
                                                let _e2096 = ((_e1928 * _e2038) - (_e1929 * _e2037));
                                                let _e2111 = select(false, (select(_e2090, -(_e2090), (_e2090 < 0.0lf)) > select(_e2096, -(_e2096), (_e2096 < 0.0lf))), (select(_e2090, -(_e2090), (_e2090 < 0.0lf)) > select(_e2093, -(_e2093), (_e2093 < 0.0lf))));
                                                let _e2126 = select((select(_e2093, -(_e2093), (_e2093 < 0.0lf)) > select(_e2096, -(_e2096), (_e2096 < 0.0lf))), false, (select(_e2090, -(_e2090), (_e2090 < 0.0lf)) > select(_e2093, -(_e2093), (_e2093 < 0.0lf))));
                                                let _e2129 = select(select(_e1819, _e1820, _e2111), _e1821, _e2126);
                                                let _e2130 = select(select(_e1820, _e1821, _e2111), _e1819, _e2126);
                                                let _e2133 = select(select(_e1928, _e1929, _e2111), _e1930, _e2126);
                                                let _e2134 = select(select(_e1929, _e1930, _e2111), _e1928, _e2126);
                                                let _e2137 = select(select(_e2037, _e2038, _e2111), _e2039, _e2126);
                                                let _e2138 = select(select(_e2038, _e2039, _e2111), _e2037, _e2126);
                                                let _e2141 = ((_e2133 * _e2138) - (_e2134 * _e2137));
                                                let _e2142 = f64(1f);
                                                let _e2143 = f64(2f);
                                                let _e2161 = (((((_e1964 * _e2087) + (_e1978 * _e2073)) * f64(2.01f)) + (((_e1978 * _e2143) * (_e2087 * _e2143)) * (1.1102230246251565e-16lf * _e2143))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2142 + _e1978) * (_e2142 + _e2087))));
                                                if (select(_e2141, -(_e2141), (_e2141 < 0.0lf)) > _e2161) {
                                                    let _e2170 = select(f64(1f), f64(-1f), (_e2141 < f64(0f)));
                                                    let _e2174 = f64(1f);
                                                    let _e2175 = f64(2f);
                                                    let _e2193 = (((((_e1855 * _e2087) + (_e1869 * _e2073)) * f64(2.01f)) + (((_e1869 * _e2175) * (_e2087 * _e2175)) * (1.1102230246251565e-16lf * _e2175))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2174 + _e1869) * (_e2174 + _e2087))));
                                                    let _e2197 = f64(1f);
                                                    let _e2198 = f64(2f);
                                                    let _e2216 = (((((_e1964 * _e1869) + (_e1978 * _e1855)) * f64(2.01f)) + (((_e1978 * _e2198) * (_e1869 * _e2198)) * (1.1102230246251565e-16lf * _e2198))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2197 + _e1978) * (_e2197 + _e1869))));
                                                    let _e2217 = (_e2141 * _e2170);
                                                    let _e2218 = (((_e2129 * _e2138) - (_e2130 * _e2137)) * _e2170);
                                                    let _e2219 = (((_e2133 * _e2130) - (_e2134 * _e2129)) * _e2170);
                                                    let _e2233 = (((select(_e2217, -(_e2217), (_e2217 < 0.0lf)) + select(_e2218, -(_e2218), (_e2218 < 0.0lf))) + select(_e2219, -(_e2219), (_e2219 < 0.0lf))) * (1.1102230246251565e-16lf * f64(4f)));
                                                    if (_e230.member != 0u) {
                                                        phi_3780_ = array<type_36, 4>(type_36(_e2218, _e2193), type_36(_e2219, _e2216), type_36((_e2217 - _e2218), ((_e2161 + _e2193) + _e2233)), type_36((_e2217 - _e2219), ((_e2161 + _e2216) + _e2233)));
                                                    } else {
                                                        let _e2236 = ((_e2217 - _e2218) - _e2219);
                                                        let _e2239 = (((_e2161 + _e2193) + _e2216) + _e2233);
                                                        phi_3780_ = array<type_36, 4>(type_36(_e2218, _e2193), type_36(_e2219, _e2216), type_36(_e2236, _e2239), type_36(_e2236, _e2239));
                                                    }
                                                    let _e2257 = phi_3780_;
                                                    local_2 = array<type_36, 4>(type_36(_e2257[0].member, _e2257[0].member_1), type_36(_e2257[1].member, _e2257[1].member_1), type_36(_e2257[2].member, _e2257[2].member_1), type_36(_e2257[3].member, _e2257[3].member_1));
                                                    phi_3800_ = type_9(0u, 4u);
                                                    phi_3803_ = true;
                                                    loop {
                                                        let _e2276 = phi_3800_;
                                                        let _e2278 = phi_3803_;
                                                        local_19 = _e2278;
                                                        let _e2281 = (_e2276.member < _e2276.member_1);
                                                        let _e2292 = select(type_9().member_1, _e2276.member, _e2281);
                                                        if (bitcast<i32>(select(0u, 1u, _e2281)) != 0i) {
                                                            let _e2297 = local_2[_e2292].member;
                                                            let _e2300 = local_2[_e2292].member_1;
                                                            let _e2302 = (_e2297 < -(_e2300));
                                                            phi_3804_ = select((_e2278 && (_e2297 > _e2300)), bool(), _e2302);
                                                            phi_3855_ = select(true, false, _e2302);
                                                            phi_3856_ = _e2302;
                                                        } else {
                                                            phi_3804_ = bool();
                                                            phi_3855_ = false;
                                                            phi_3856_ = false;
                                                        }
                                                        let _e2308 = phi_3804_;
                                                        let _e2310 = phi_3855_;
                                                        let _e2312 = phi_3856_;
                                                        local_18 = _e2312;
                                                        continue;
                                                        continuing {
                                                            phi_3800_ = type_9(select(_e2276.member, (_e2276.member + 1u), _e2281), select(_e2276.member_1, _e2276.member_1, _e2281));
                                                            phi_3803_ = _e2308;
                                                            break if !(_e2310);
                                                        }
                                                    }
                                                    let _e2315 = local_18;
                                                    let _e2316 = select(true, false, _e2315);
                                                    let _e2318 = local_19;
                                                    phi_3870_ = select(u32(), select(2u, 1u, _e2318), _e2316);
                                                    phi_3871_ = 0u;
                                                    phi_3872_ = select(true, false, _e2316);
                                                } else {
                                                    phi_3870_ = u32();
                                                    phi_3871_ = 2u;
                                                    phi_3872_ = true;
                                                }
                                                let _e2323 = phi_3870_;
                                                let _e2325 = phi_3871_;
                                                let _e2327 = phi_3872_;
                                                let _e2328 = select(_e2323, _e2325, _e2327);
                                                let _e2329 = (_e2328 == 0u);
                                                if _e2329 {
                                                    phi_3903_ = bool();
                                                    phi_3904_ = false;
                                                    phi_3905_ = false;
                                                } else {
                                                    let _e2332 = select(false, _e1746.member_2, (_e2328 == 1u));
                                                    let _e2338 = select(true, select(true, false, ((_e1746.member_1 - _e1746.member) <= _e1345)), _e2332);
                                                    phi_3903_ = _e2332;
                                                    phi_3904_ = _e2338;
                                                    phi_3905_ = select(true, false, _e2338);
                                                }
                                                let _e2341 = phi_3903_;
                                                let _e2343 = phi_3904_;
                                                let _e2345 = phi_3905_;
                                                phi_3906_ = _e2341;
                                                phi_3907_ = _e2329;
                                                phi_3908_ = _e2343;
                                                phi_3909_ = _e2345;
                                            }
                                            let _e2347 = phi_3906_;
                                            let _e2349 = phi_3907_;
                                            let _e2351 = phi_3908_;
                                            let _e2353 = phi_3909_;
                                            phi_3910_ = _e2347;
                                            phi_3911_ = _e2349;
                                            phi_3912_ = _e2351;
                                            phi_3913_ = _e1751;
                                            phi_3914_ = _e2353;
                                        }
                                        let _e2355 = phi_3910_;
                                        let _e2357 = phi_3911_;
                                        let _e2359 = phi_3912_;
                                        let _e2361 = phi_3913_;
                                        let _e2363 = phi_3914_;
                                        phi_3915_ = _e1746;
                                        phi_3916_ = _e2355;
                                        phi_3917_ = _e1746;
                                        phi_3918_ = _e2357;
                                        phi_3919_ = _e2359;
                                        phi_3920_ = _e2361;
                                        phi_3921_ = _e2363;
                                    }
                                    let _e2365 = phi_3915_;
                                    let _e2367 = phi_3916_;
                                    let _e2369 = phi_3917_;
                                    let _e2371 = phi_3918_;
                                    let _e2373 = phi_3919_;
                                    let _e2375 = phi_3920_;
                                    let _e2377 = phi_3921_;
                                    phi_3922_ = _e2365;
                                    phi_3923_ = _e2367;
                                    phi_3924_ = _e2369;
                                    phi_3925_ = _e2371;
                                    phi_3926_ = _e2373;
                                    phi_3927_ = _e1411;
                                    phi_3928_ = _e2375;
                                    phi_3929_ = _e2377;
                                } else {
                                    phi_3922_ = type_43();
                                    phi_3923_ = bool();
                                    phi_3924_ = type_43();
                                    phi_3925_ = true;
                                    phi_3926_ = false;
                                    phi_3927_ = false;
                                    phi_3928_ = false;
                                    phi_3929_ = false;
                                }
                                let _e2379 = phi_3922_;
                                let _e2381 = phi_3923_;
                                let _e2383 = phi_3924_;
                                let _e2385 = phi_3925_;
                                let _e2387 = phi_3926_;
                                let _e2389 = phi_3927_;
                                let _e2391 = phi_3928_;
                                let _e2393 = phi_3929_;
                                phi_3937_ = _e2379;
                                phi_3938_ = _e2381;
                                phi_3939_ = _e2383;
                                phi_3940_ = select(_e2387, false, _e2385);
                                phi_3941_ = _e2385;
                                phi_3942_ = select(_e2389, false, _e2385);
                                phi_3943_ = select(_e2391, false, _e2385);
                                phi_3944_ = select(_e2393, false, _e2385);
                            } else {
                                phi_3937_ = type_43(_e533, _e533, false);
                                phi_3938_ = false;
                                phi_3939_ = type_43();
                                phi_3940_ = true;
                                phi_3941_ = false;
                                phi_3942_ = false;
                                phi_3943_ = false;
                                phi_3944_ = false;
                            }
                            let _e2399 = phi_3937_;
                            let _e2401 = phi_3938_;
                            let _e2403 = phi_3939_;
                            let _e2405 = phi_3940_;
                            let _e2407 = phi_3941_;
                            let _e2409 = phi_3942_;
                            let _e2411 = phi_3943_;
                            let _e2413 = phi_3944_;
                            if _e2405 {
                                let _e2418 = local_7.member[0u];
                                let _e2424 = local_7.member_1[0u];
                                let _e2430 = local_7.member_2[0u];
                                let _e2434 = (_e2418[0] - _e2424[0]);
                                let _e2435 = (_e2418[1] - _e2424[1]);
                                let _e2436 = (_e2418[2] - _e2424[2]);
                                let _e2437 = (_e230.member == 0u);
                                let _e2449 = local_7.member[1u];
                                let _e2455 = local_7.member_1[1u];
                                let _e2461 = local_7.member_2[1u];
                                let _e2465 = (_e2449[0] - _e2455[0]);
                                let _e2466 = (_e2449[1] - _e2455[1]);
                                let _e2467 = (_e2449[2] - _e2455[2]);
                                let _e2468 = (_e230.member == 0u);
                                let _e2480 = local_7.member[0u];
                                let _e2486 = select(_e2480[0], -(_e2480[0]), (_e2480[0] < 0.0lf));
                                let _e2489 = select(_e2480[1], -(_e2480[1]), (_e2480[1] < 0.0lf));
                                let _e2491 = select(_e2489, _e2486, (_e2486 > _e2489));
                                let _e2494 = select(_e2480[2], -(_e2480[2]), (_e2480[2] < 0.0lf));
                                let _e2496 = select(_e2494, _e2491, (_e2491 > _e2494));
                                let _e2499 = local_7.member[1u];
                                let _e2505 = select(_e2499[0], -(_e2499[0]), (_e2499[0] < 0.0lf));
                                let _e2508 = select(_e2499[1], -(_e2499[1]), (_e2499[1] < 0.0lf));
                                let _e2510 = select(_e2508, _e2505, (_e2505 > _e2508));
                                let _e2513 = select(_e2499[2], -(_e2499[2]), (_e2499[2] < 0.0lf));
                                let _e2515 = select(_e2513, _e2510, (_e2510 > _e2513));
                                let _e2519 = local_7.member_3;
                                let _e2523 = local_7.member_1[0u];
                                let _e2529 = select(_e2523[0], -(_e2523[0]), (_e2523[0] < 0.0lf));
                                let _e2532 = select(_e2523[1], -(_e2523[1]), (_e2523[1] < 0.0lf));
                                let _e2534 = select(_e2532, _e2529, (_e2529 > _e2532));
                                let _e2537 = select(_e2523[2], -(_e2523[2]), (_e2523[2] < 0.0lf));
                                let _e2539 = select(_e2537, _e2534, (_e2534 > _e2537));
                                let _e2542 = local_7.member_1[1u];
                                let _e2548 = select(_e2542[0], -(_e2542[0]), (_e2542[0] < 0.0lf));
                                let _e2551 = select(_e2542[1], -(_e2542[1]), (_e2542[1] < 0.0lf));
                                let _e2553 = select(_e2551, _e2548, (_e2548 > _e2551));
                                let _e2556 = select(_e2542[2], -(_e2542[2]), (_e2542[2] < 0.0lf));
                                let _e2558 = select(_e2556, _e2553, (_e2553 > _e2556));
                                let _e2562 = local_7.member_3;
                                let _e2566 = local_7.member_2[0u];
                                let _e2572 = select(_e2566[0], -(_e2566[0]), (_e2566[0] < 0.0lf));
                                let _e2575 = select(_e2566[1], -(_e2566[1]), (_e2566[1] < 0.0lf));
                                let _e2577 = select(_e2575, _e2572, (_e2572 > _e2575));
                                let _e2580 = select(_e2566[2], -(_e2566[2]), (_e2566[2] < 0.0lf));
                                let _e2582 = select(_e2580, _e2577, (_e2577 > _e2580));
                                let _e2585 = local_7.member_2[1u];
                                let _e2591 = select(_e2585[0], -(_e2585[0]), (_e2585[0] < 0.0lf));
                                let _e2594 = select(_e2585[1], -(_e2585[1]), (_e2585[1] < 0.0lf));
                                let _e2596 = select(_e2594, _e2591, (_e2591 > _e2594));
                                let _e2599 = select(_e2585[2], -(_e2585[2]), (_e2585[2] < 0.0lf));
                                let _e2601 = select(_e2599, _e2596, (_e2596 > _e2599));
                                let _e2605 = local_7.member_3;
                                let _e2613 = local_7.member_3;
                                let _e2621 = (_e524 * f64(0.00390625f));
                                let _e2622 = f64(0f);
                                let _e2623 = f64(1f);
                                local = type_44(array<f64, 4>(_e2622, _e2622, _e2622, _e2622), array<f64, 4>(_e2622, _e2622, _e2622, _e2622), array<f64, 4>(_e2623, _e2623, _e2623, _e2623));
                                phi_4373_ = type_9(0u, 96u);
                                phi_4376_ = _e2399.member;
                                phi_4378_ = _e2399.member;
                                phi_4380_ = (_e2399.member_1 - _e2399.member);
                                phi_4382_ = _e2399.member;
                                phi_4384_ = false;
                                phi_4386_ = 0u;
                                loop {
                                    let _e2630 = phi_4373_;
                                    let _e2632 = phi_4376_;
                                    let _e2634 = phi_4378_;
                                    let _e2636 = phi_4380_;
                                    let _e2638 = phi_4382_;
                                    let _e2640 = phi_4384_;
                                    let _e2642 = phi_4386_;
                                    local_32 = _e2632;
                                    local_36 = _e2634;
                                    let _e2645 = (_e2630.member < _e2630.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2645)) != 0i) {
                                        let _e2659 = local_7.member[0u];
                                        let _e2665 = local_7.member[1u];
                                        let _e2681 = local_7.member_1[0u];
                                        let _e2687 = local_7.member_1[1u];
                                        let _e2703 = local_7.member_2[0u];
                                        let _e2709 = local_7.member_2[1u];
                                        let _e2723 = function_5(array<f64, 3>((_e2659[0] + ((_e2665[0] - _e2659[0]) * _e2632)), (_e2659[1] + ((_e2665[1] - _e2659[1]) * _e2632)), (_e2659[2] + ((_e2665[2] - _e2659[2]) * _e2632))), array<f64, 3>((_e2681[0] + ((_e2687[0] - _e2681[0]) * _e2632)), (_e2681[1] + ((_e2687[1] - _e2681[1]) * _e2632)), (_e2681[2] + ((_e2687[2] - _e2681[2]) * _e2632))), array<f64, 3>((_e2703[0] + ((_e2709[0] - _e2703[0]) * _e2632)), (_e2703[1] + ((_e2709[1] - _e2703[1]) * _e2632)), (_e2703[2] + ((_e2709[2] - _e2703[2]) * _e2632))), _e230.member);
                                        if (_e2642 == 0u) {
                                            phi_4538_ = _e2723;
                                        } else {
                                            let _e2725 = f64(0f);
                                            phi_4538_ = array<f64, 3>(select(_e2725, _e2723[0], (_e2642 == 1u)), select(_e2725, _e2723[1], (_e2642 == 2u)), select(_e2725, _e2723[2], (_e2642 == 3u)));
                                        }
                                        let _e2737 = phi_4538_;
                                        let _e2751 = ((select(_e2737[0], -(_e2737[0]), (_e2737[0] < 0.0lf)) + select(_e2737[1], -(_e2737[1]), (_e2737[1] < 0.0lf))) + select(_e2737[2], -(_e2737[2]), (_e2737[2] < 0.0lf)));
                                        if (_e2751 > f64(0f)) {
                                            if ((bitcast<u64>(_e2751) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2758 = (f64(1f) / _e2751);
                                                let _e2760 = (_e2737[0] * _e2758);
                                                let _e2762 = (_e2737[1] * _e2758);
                                                let _e2764 = (_e2737[2] * _e2758);
                                                let _e2769 = (((_e2760 * _e2760) + (_e2762 * _e2762)) + (_e2764 * _e2764));
                                                if (_e2769 <= 2.2250738585072014e-308lf) {
                                                    phi_4663_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2769 > 0.0lf));
                                                } else {
                                                    phi_4606_ = type_16(0i, 5i);
                                                    phi_4609_ = bitcast<f64>(((bitcast<u64>(_e2769) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2776 = phi_4606_;
                                                        let _e2778 = phi_4609_;
                                                        local_20 = _e2778;
                                                        if (_e2776.member < _e2776.member_1) {
                                                            let _e2785 = (_e2776.member + 1i);
                                                            phi_4607_ = type_16(select(_e2785, type_17().member_1, select(false, true, ((false == (_e2785 > _e2776.member)) != false))), _e2776.member_1);
                                                            phi_4650_ = type_17(1u, _e2776.member);
                                                        } else {
                                                            phi_4607_ = _e2776;
                                                            phi_4650_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2796 = phi_4607_;
                                                        let _e2798 = phi_4650_;
                                                        let _e2801 = (bitcast<i32>(_e2798.member) != 0i);
                                                        if _e2801 {
                                                            phi_4610_ = (0.5lf * (_e2778 + (_e2769 / _e2778)));
                                                        } else {
                                                            phi_4610_ = f64();
                                                        }
                                                        let _e2806 = phi_4610_;
                                                        continue;
                                                        continuing {
                                                            phi_4606_ = _e2796;
                                                            phi_4609_ = _e2806;
                                                            break if !(_e2801);
                                                        }
                                                    }
                                                    let _e2811 = local_20;
                                                    phi_4663_ = (_e2811 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2817 = phi_4663_;
                                                let _e2819 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2826 = ((((((((select(_e2515, _e2496, (_e2496 > _e2515)) + _e2519) + (select(_e2558, _e2539, (_e2539 > _e2558)) + _e2562)) + (select(_e2601, _e2582, (_e2582 > _e2601)) + _e2605)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2613 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e1131 * _e2817) * (f64(1f) + _e2819)));
                                                let _e2831 = (((_e2760 * _e2418[0]) + (_e2762 * _e2418[1])) + (_e2764 * _e2418[2]));
                                                let _e2836 = (((_e2760 * _e2434) + (_e2762 * _e2435)) + (_e2764 * _e2436));
                                                let _e2841 = (((_e2760 * (_e2418[0] - _e2430[0])) + (_e2762 * (_e2418[1] - _e2430[1]))) + (_e2764 * (_e2418[2] - _e2430[2])));
                                                let _e2846 = (((_e2760 * select((_e2434 - _e2430[0]), _e2418[0], _e2437)) + (_e2762 * select((_e2435 - _e2430[1]), _e2418[1], _e2437))) + (_e2764 * select((_e2436 - _e2430[2]), _e2418[2], _e2437)));
                                                let _e2852 = (((_e2760 * _e2449[0]) + (_e2762 * _e2449[1])) + (_e2764 * _e2449[2]));
                                                let _e2857 = (((_e2760 * _e2465) + (_e2762 * _e2466)) + (_e2764 * _e2467));
                                                let _e2862 = (((_e2760 * (_e2449[0] - _e2461[0])) + (_e2762 * (_e2449[1] - _e2461[1]))) + (_e2764 * (_e2449[2] - _e2461[2])));
                                                let _e2867 = (((_e2760 * select((_e2465 - _e2461[0]), _e2449[0], _e2468)) + (_e2762 * select((_e2466 - _e2461[1]), _e2449[1], _e2468))) + (_e2764 * select((_e2467 - _e2461[2]), _e2449[2], _e2468)));
                                                phi_4789_ = type_44(array<f64, 4>(_e2831, _e2836, _e2841, _e2846), array<f64, 4>(_e2852, _e2857, _e2862, _e2867), array<f64, 4>((_e2826 + ((select(_e2831, -(_e2831), (_e2831 < 0.0lf)) + select(_e2852, -(_e2852), (_e2852 < 0.0lf))) * _e2819)), (_e2826 + ((select(_e2836, -(_e2836), (_e2836 < 0.0lf)) + select(_e2857, -(_e2857), (_e2857 < 0.0lf))) * _e2819)), (_e2826 + ((select(_e2841, -(_e2841), (_e2841 < 0.0lf)) + select(_e2862, -(_e2862), (_e2862 < 0.0lf))) * _e2819)), (_e2826 + ((select(_e2846, -(_e2846), (_e2846 < 0.0lf)) + select(_e2867, -(_e2867), (_e2867 < 0.0lf))) * _e2819))));
                                                phi_4790_ = false;
                                            } else {
                                                phi_4789_ = type_44();
                                                phi_4790_ = true;
                                            }
                                            let _e2908 = phi_4789_;
                                            let _e2910 = phi_4790_;
                                            phi_4791_ = _e2908;
                                            phi_4792_ = _e2910;
                                        } else {
                                            phi_4791_ = type_44();
                                            phi_4792_ = true;
                                        }
                                        let _e2912 = phi_4791_;
                                        let _e2914 = phi_4792_;
                                        if _e2914 {
                                            let _e2915 = f64(0f);
                                            let _e2916 = f64(1f);
                                            phi_4802_ = type_44(array<f64, 4>(_e2915, _e2915, _e2915, _e2915), array<f64, 4>(_e2915, _e2915, _e2915, _e2915), array<f64, 4>(_e2916, _e2916, _e2916, _e2916));
                                        } else {
                                            phi_4802_ = _e2912;
                                        }
                                        let _e2922 = phi_4802_;
                                        local_1 = type_44(array<f64, 4>(_e2922.member[0], _e2922.member[1], _e2922.member[2], _e2922.member[3]), array<f64, 4>(_e2922.member_1[0], _e2922.member_1[1], _e2922.member_1[2], _e2922.member_1[3]), array<f64, 4>(_e2922.member_2[0], _e2922.member_2[1], _e2922.member_2[2], _e2922.member_2[3]));
                                        let _e2942 = (_e2632 - _e2638);
                                        let _e2944 = f64(0f);
                                        let _e2947 = local_1.member[0u];
                                        let _e2950 = local_1.member_1[0u];
                                        let _e2953 = local_1.member[0u];
                                        let _e2959 = local_1.member_2[0u];
                                        if (((_e2947 + ((_e2950 - _e2953) * _e2632)) - _e2959) > _e2944) {
                                            let _e2964 = local_1.member[1u];
                                            let _e2967 = local_1.member_1[1u];
                                            let _e2970 = local_1.member[1u];
                                            let _e2976 = local_1.member_2[1u];
                                            if (((_e2964 + ((_e2967 - _e2970) * _e2632)) - _e2976) > _e2944) {
                                                let _e2981 = local_1.member[2u];
                                                let _e2984 = local_1.member_1[2u];
                                                let _e2987 = local_1.member[2u];
                                                let _e2993 = local_1.member_2[2u];
                                                if (((_e2981 + ((_e2984 - _e2987) * _e2632)) - _e2993) > _e2944) {
                                                    let _e2998 = local_1.member[3u];
                                                    let _e3001 = local_1.member_1[3u];
                                                    let _e3004 = local_1.member[3u];
                                                    let _e3010 = local_1.member_2[3u];
                                                    phi_4974_ = (((_e2998 + ((_e3001 - _e3004) * _e2632)) - _e3010) > _e2944);
                                                    phi_4975_ = false;
                                                } else {
                                                    phi_4974_ = bool();
                                                    phi_4975_ = true;
                                                }
                                                let _e3014 = phi_4974_;
                                                let _e3016 = phi_4975_;
                                                phi_4976_ = _e3014;
                                                phi_4977_ = _e3016;
                                            } else {
                                                phi_4976_ = bool();
                                                phi_4977_ = true;
                                            }
                                            let _e3018 = phi_4976_;
                                            let _e3020 = phi_4977_;
                                            phi_4978_ = _e3018;
                                            phi_4979_ = _e3020;
                                        } else {
                                            phi_4978_ = bool();
                                            phi_4979_ = true;
                                        }
                                        let _e3022 = phi_4978_;
                                        let _e3024 = phi_4979_;
                                        if select(_e3022, false, _e3024) {
                                            if (_e2632 <= _e2634) {
                                                phi_5294_ = true;
                                            } else {
                                                let _e3027 = f64(0f);
                                                let _e3030 = local.member[0u];
                                                let _e3033 = local.member_1[0u];
                                                let _e3036 = local.member[0u];
                                                let _e3042 = local.member_2[0u];
                                                let _e3046 = local_1.member[0u];
                                                let _e3049 = local_1.member_1[0u];
                                                let _e3052 = local_1.member[0u];
                                                let _e3058 = local_1.member_2[0u];
                                                if ((((_e3030 + ((_e3033 - _e3036) * _e2632)) - _e3042) + ((_e3046 + ((_e3049 - _e3052) * _e2638)) - _e3058)) > _e3027) {
                                                    let _e3064 = local.member[1u];
                                                    let _e3067 = local.member_1[1u];
                                                    let _e3070 = local.member[1u];
                                                    let _e3076 = local.member_2[1u];
                                                    let _e3080 = local_1.member[1u];
                                                    let _e3083 = local_1.member_1[1u];
                                                    let _e3086 = local_1.member[1u];
                                                    let _e3092 = local_1.member_2[1u];
                                                    if ((((_e3064 + ((_e3067 - _e3070) * _e2632)) - _e3076) + ((_e3080 + ((_e3083 - _e3086) * _e2638)) - _e3092)) > _e3027) {
                                                        let _e3098 = local.member[2u];
                                                        let _e3101 = local.member_1[2u];
                                                        let _e3104 = local.member[2u];
                                                        let _e3110 = local.member_2[2u];
                                                        let _e3114 = local_1.member[2u];
                                                        let _e3117 = local_1.member_1[2u];
                                                        let _e3120 = local_1.member[2u];
                                                        let _e3126 = local_1.member_2[2u];
                                                        if ((((_e3098 + ((_e3101 - _e3104) * _e2632)) - _e3110) + ((_e3114 + ((_e3117 - _e3120) * _e2638)) - _e3126)) > _e3027) {
                                                            let _e3132 = local.member[3u];
                                                            let _e3135 = local.member_1[3u];
                                                            let _e3138 = local.member[3u];
                                                            let _e3144 = local.member_2[3u];
                                                            let _e3148 = local_1.member[3u];
                                                            let _e3151 = local_1.member_1[3u];
                                                            let _e3154 = local_1.member[3u];
                                                            let _e3160 = local_1.member_2[3u];
                                                            phi_5281_ = ((((_e3132 + ((_e3135 - _e3138) * _e2632)) - _e3144) + ((_e3148 + ((_e3151 - _e3154) * _e2638)) - _e3160)) > _e3027);
                                                            phi_5282_ = false;
                                                        } else {
                                                            phi_5281_ = bool();
                                                            phi_5282_ = true;
                                                        }
                                                        let _e3165 = phi_5281_;
                                                        let _e3167 = phi_5282_;
                                                        phi_5283_ = _e3165;
                                                        phi_5284_ = _e3167;
                                                    } else {
                                                        phi_5283_ = bool();
                                                        phi_5284_ = true;
                                                    }
                                                    let _e3169 = phi_5283_;
                                                    let _e3171 = phi_5284_;
                                                    phi_5285_ = _e3169;
                                                    phi_5286_ = _e3171;
                                                } else {
                                                    phi_5285_ = bool();
                                                    phi_5286_ = true;
                                                }
                                                let _e3173 = phi_5285_;
                                                let _e3175 = phi_5286_;
                                                phi_5294_ = select(_e3173, false, _e3175);
                                            }
                                            let _e3178 = phi_5294_;
                                            if _e3178 {
                                                if select(true, select(true, false, (_e2632 >= _e2399.member_1)), _e2640) {
                                                    local = type_44(array<f64, 4>(_e2922.member[0], _e2922.member[1], _e2922.member[2], _e2922.member[3]), array<f64, 4>(_e2922.member_1[0], _e2922.member_1[1], _e2922.member_1[2], _e2922.member_1[3]), array<f64, 4>(_e2922.member_2[0], _e2922.member_2[1], _e2922.member_2[2], _e2922.member_2[3]));
                                                    let _e3203 = local.member[0u];
                                                    let _e3206 = local.member_1[0u];
                                                    let _e3209 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e3206 > _e3209)), (_e3203 > _e3209)) {
                                                        let _e3214 = (_e3206 >= _e3203);
                                                        if _e3214 {
                                                            phi_5406_ = f64();
                                                            phi_5407_ = false;
                                                        } else {
                                                            if ((_e3203 - _e3206) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5404_ = (((_e3203 - _e3209) / (_e3203 - _e3206)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5405_ = false;
                                                            } else {
                                                                phi_5404_ = f64();
                                                                phi_5405_ = true;
                                                            }
                                                            let _e3228 = phi_5404_;
                                                            let _e3230 = phi_5405_;
                                                            phi_5406_ = _e3228;
                                                            phi_5407_ = _e3230;
                                                        }
                                                        let _e3232 = phi_5406_;
                                                        let _e3234 = phi_5407_;
                                                        phi_5408_ = _e3232;
                                                        phi_5409_ = _e3214;
                                                        phi_5410_ = _e3234;
                                                    } else {
                                                        phi_5408_ = f64();
                                                        phi_5409_ = true;
                                                        phi_5410_ = false;
                                                    }
                                                    let _e3236 = phi_5408_;
                                                    let _e3238 = phi_5409_;
                                                    let _e3240 = phi_5410_;
                                                    let _e3244 = select(_e3236, select(_e2632, f64(2f), _e3238), select(_e3240, true, _e3238));
                                                    let _e3247 = local.member[1u];
                                                    let _e3250 = local.member_1[1u];
                                                    let _e3253 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e3250 > _e3253)), (_e3247 > _e3253)) {
                                                        let _e3258 = (_e3250 >= _e3247);
                                                        if _e3258 {
                                                            phi_5478_ = f64();
                                                            phi_5479_ = false;
                                                        } else {
                                                            if ((_e3247 - _e3250) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5476_ = (((_e3247 - _e3253) / (_e3247 - _e3250)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5477_ = false;
                                                            } else {
                                                                phi_5476_ = f64();
                                                                phi_5477_ = true;
                                                            }
                                                            let _e3272 = phi_5476_;
                                                            let _e3274 = phi_5477_;
                                                            phi_5478_ = _e3272;
                                                            phi_5479_ = _e3274;
                                                        }
                                                        let _e3276 = phi_5478_;
                                                        let _e3278 = phi_5479_;
                                                        phi_5480_ = _e3276;
                                                        phi_5481_ = _e3258;
                                                        phi_5482_ = _e3278;
                                                    } else {
                                                        phi_5480_ = f64();
                                                        phi_5481_ = true;
                                                        phi_5482_ = false;
                                                    }
                                                    let _e3280 = phi_5480_;
                                                    let _e3282 = phi_5481_;
                                                    let _e3284 = phi_5482_;
                                                    let _e3288 = select(_e3280, select(_e2632, f64(2f), _e3282), select(_e3284, true, _e3282));
                                                    let _e3290 = select(_e3288, _e3244, (_e3244 < _e3288));
                                                    let _e3293 = local.member[2u];
                                                    let _e3296 = local.member_1[2u];
                                                    let _e3299 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3296 > _e3299)), (_e3293 > _e3299)) {
                                                        let _e3304 = (_e3296 >= _e3293);
                                                        if _e3304 {
                                                            phi_5555_ = f64();
                                                            phi_5556_ = false;
                                                        } else {
                                                            if ((_e3293 - _e3296) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5553_ = (((_e3293 - _e3299) / (_e3293 - _e3296)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5554_ = false;
                                                            } else {
                                                                phi_5553_ = f64();
                                                                phi_5554_ = true;
                                                            }
                                                            let _e3318 = phi_5553_;
                                                            let _e3320 = phi_5554_;
                                                            phi_5555_ = _e3318;
                                                            phi_5556_ = _e3320;
                                                        }
                                                        let _e3322 = phi_5555_;
                                                        let _e3324 = phi_5556_;
                                                        phi_5557_ = _e3322;
                                                        phi_5558_ = _e3304;
                                                        phi_5559_ = _e3324;
                                                    } else {
                                                        phi_5557_ = f64();
                                                        phi_5558_ = true;
                                                        phi_5559_ = false;
                                                    }
                                                    let _e3326 = phi_5557_;
                                                    let _e3328 = phi_5558_;
                                                    let _e3330 = phi_5559_;
                                                    let _e3334 = select(_e3326, select(_e2632, f64(2f), _e3328), select(_e3330, true, _e3328));
                                                    let _e3337 = local.member[3u];
                                                    let _e3340 = local.member_1[3u];
                                                    let _e3343 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3340 > _e3343)), (_e3337 > _e3343)) {
                                                        let _e3348 = (_e3340 >= _e3337);
                                                        if _e3348 {
                                                            phi_5627_ = f64();
                                                            phi_5628_ = false;
                                                        } else {
                                                            if ((_e3337 - _e3340) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5625_ = (((_e3337 - _e3343) / (_e3337 - _e3340)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5626_ = false;
                                                            } else {
                                                                phi_5625_ = f64();
                                                                phi_5626_ = true;
                                                            }
                                                            let _e3362 = phi_5625_;
                                                            let _e3364 = phi_5626_;
                                                            phi_5627_ = _e3362;
                                                            phi_5628_ = _e3364;
                                                        }
                                                        let _e3366 = phi_5627_;
                                                        let _e3368 = phi_5628_;
                                                        phi_5629_ = _e3366;
                                                        phi_5630_ = _e3348;
                                                        phi_5631_ = _e3368;
                                                    } else {
                                                        phi_5629_ = f64();
                                                        phi_5630_ = true;
                                                        phi_5631_ = false;
                                                    }
                                                    let _e3370 = phi_5629_;
                                                    let _e3372 = phi_5630_;
                                                    let _e3374 = phi_5631_;
                                                    let _e3378 = select(_e3370, select(_e2632, f64(2f), _e3372), select(_e3374, true, _e3372));
                                                    let _e3380 = select(_e3378, _e3334, (_e3334 < _e3378));
                                                    let _e3382 = select(_e3380, _e3290, (_e3290 < _e3380));
                                                    let _e3384 = select(_e2632, _e3382, (_e3382 > _e2632));
                                                    let _e3385 = (_e3384 > _e2399.member_1);
                                                    if _e3385 {
                                                        phi_6173_ = f64();
                                                        phi_6174_ = f64();
                                                        phi_6175_ = false;
                                                        phi_6176_ = false;
                                                    } else {
                                                        let _e3386 = (_e3384 - _e2632);
                                                        let _e3387 = (_e3386 <= _e2621);
                                                        let _e3390 = (_e3384 + (_e524 * f64(0.01f)));
                                                        let _e3392 = select(_e2399.member_1, _e3390, (_e3390 < _e2399.member_1));
                                                        if _e3387 {
                                                            if (_e1131 > f64(0f)) {
                                                                let _e3397 = local_7.member[0u];
                                                                let _e3403 = local_7.member[1u];
                                                                let _e3419 = local_7.member_1[0u];
                                                                let _e3425 = local_7.member_1[1u];
                                                                let _e3441 = local_7.member_2[0u];
                                                                let _e3447 = local_7.member_2[1u];
                                                                let _e3461 = function_5(array<f64, 3>((_e3397[0] + ((_e3403[0] - _e3397[0]) * _e3392)), (_e3397[1] + ((_e3403[1] - _e3397[1]) * _e3392)), (_e3397[2] + ((_e3403[2] - _e3397[2]) * _e3392))), array<f64, 3>((_e3419[0] + ((_e3425[0] - _e3419[0]) * _e3392)), (_e3419[1] + ((_e3425[1] - _e3419[1]) * _e3392)), (_e3419[2] + ((_e3425[2] - _e3419[2]) * _e3392))), array<f64, 3>((_e3441[0] + ((_e3447[0] - _e3441[0]) * _e3392)), (_e3441[1] + ((_e3447[1] - _e3441[1]) * _e3392)), (_e3441[2] + ((_e3447[2] - _e3441[2]) * _e3392))), _e230.member);
                                                                let _e3472 = (((_e3461[0] * _e3461[0]) + (_e3461[1] * _e3461[1])) + (_e3461[2] * _e3461[2]));
                                                                if (_e3472 <= 2.2250738585072014e-308lf) {
                                                                    phi_5865_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3472 > 0.0lf));
                                                                } else {
                                                                    phi_5808_ = type_16(0i, 5i);
                                                                    phi_5811_ = bitcast<f64>(((bitcast<u64>(_e3472) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e3479 = phi_5808_;
                                                                        let _e3481 = phi_5811_;
                                                                        local_21 = _e3481;
                                                                        if (_e3479.member < _e3479.member_1) {
                                                                            let _e3488 = (_e3479.member + 1i);
                                                                            phi_5809_ = type_16(select(_e3488, type_17().member_1, select(false, true, ((false == (_e3488 > _e3479.member)) != false))), _e3479.member_1);
                                                                            phi_5852_ = type_17(1u, _e3479.member);
                                                                        } else {
                                                                            phi_5809_ = _e3479;
                                                                            phi_5852_ = type_17(0u, type_17().member_1);
                                                                        }
                                                                        let _e3499 = phi_5809_;
                                                                        let _e3501 = phi_5852_;
                                                                        let _e3504 = (bitcast<i32>(_e3501.member) != 0i);
                                                                        if _e3504 {
                                                                            phi_5812_ = (0.5lf * (_e3481 + (_e3472 / _e3481)));
                                                                        } else {
                                                                            phi_5812_ = f64();
                                                                        }
                                                                        let _e3509 = phi_5812_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_5808_ = _e3499;
                                                                            phi_5811_ = _e3509;
                                                                            break if !(_e3504);
                                                                        }
                                                                    }
                                                                    let _e3514 = local_21;
                                                                    phi_5865_ = (_e3514 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e3520 = phi_5865_;
                                                                let _e3528 = local_7.member[0u];
                                                                let _e3534 = select(_e3528[0], -(_e3528[0]), (_e3528[0] < 0.0lf));
                                                                let _e3537 = select(_e3528[1], -(_e3528[1]), (_e3528[1] < 0.0lf));
                                                                let _e3539 = select(_e3537, _e3534, (_e3534 > _e3537));
                                                                let _e3542 = select(_e3528[2], -(_e3528[2]), (_e3528[2] < 0.0lf));
                                                                let _e3544 = select(_e3542, _e3539, (_e3539 > _e3542));
                                                                let _e3547 = local_7.member[1u];
                                                                let _e3553 = select(_e3547[0], -(_e3547[0]), (_e3547[0] < 0.0lf));
                                                                let _e3556 = select(_e3547[1], -(_e3547[1]), (_e3547[1] < 0.0lf));
                                                                let _e3558 = select(_e3556, _e3553, (_e3553 > _e3556));
                                                                let _e3561 = select(_e3547[2], -(_e3547[2]), (_e3547[2] < 0.0lf));
                                                                let _e3563 = select(_e3561, _e3558, (_e3558 > _e3561));
                                                                let _e3567 = local_7.member_3;
                                                                let _e3571 = local_7.member_1[0u];
                                                                let _e3577 = select(_e3571[0], -(_e3571[0]), (_e3571[0] < 0.0lf));
                                                                let _e3580 = select(_e3571[1], -(_e3571[1]), (_e3571[1] < 0.0lf));
                                                                let _e3582 = select(_e3580, _e3577, (_e3577 > _e3580));
                                                                let _e3585 = select(_e3571[2], -(_e3571[2]), (_e3571[2] < 0.0lf));
                                                                let _e3587 = select(_e3585, _e3582, (_e3582 > _e3585));
                                                                let _e3590 = local_7.member_1[1u];
                                                                let _e3596 = select(_e3590[0], -(_e3590[0]), (_e3590[0] < 0.0lf));
                                                                let _e3599 = select(_e3590[1], -(_e3590[1]), (_e3590[1] < 0.0lf));
                                                                let _e3601 = select(_e3599, _e3596, (_e3596 > _e3599));
                                                                let _e3604 = select(_e3590[2], -(_e3590[2]), (_e3590[2] < 0.0lf));
                                                                let _e3606 = select(_e3604, _e3601, (_e3601 > _e3604));
                                                                let _e3610 = local_7.member_3;
                                                                let _e3614 = local_7.member_2[0u];
                                                                let _e3620 = select(_e3614[0], -(_e3614[0]), (_e3614[0] < 0.0lf));
                                                                let _e3623 = select(_e3614[1], -(_e3614[1]), (_e3614[1] < 0.0lf));
                                                                let _e3625 = select(_e3623, _e3620, (_e3620 > _e3623));
                                                                let _e3628 = select(_e3614[2], -(_e3614[2]), (_e3614[2] < 0.0lf));
                                                                let _e3630 = select(_e3628, _e3625, (_e3625 > _e3628));
                                                                let _e3633 = local_7.member_2[1u];
                                                                let _e3639 = select(_e3633[0], -(_e3633[0]), (_e3633[0] < 0.0lf));
                                                                let _e3642 = select(_e3633[1], -(_e3633[1]), (_e3633[1] < 0.0lf));
                                                                let _e3644 = select(_e3642, _e3639, (_e3639 > _e3642));
                                                                let _e3647 = select(_e3633[2], -(_e3633[2]), (_e3633[2] < 0.0lf));
                                                                let _e3649 = select(_e3647, _e3644, (_e3644 > _e3647));
                                                                let _e3653 = local_7.member_3;
                                                                let _e3661 = local_7.member_3;
                                                                phi_6142_ = select(true, false, (((_e3520 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e3563, _e3544, (_e3544 > _e3563)) + _e3567) + (select(_e3606, _e3587, (_e3587 > _e3606)) + _e3610)) + (select(_e3649, _e3630, (_e3630 > _e3649)) + _e3653)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3661 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e1131));
                                                            } else {
                                                                phi_6142_ = true;
                                                            }
                                                            let _e3674 = phi_6142_;
                                                            phi_6143_ = _e3674;
                                                        } else {
                                                            phi_6143_ = true;
                                                        }
                                                        let _e3676 = phi_6143_;
                                                        if _e3676 {
                                                            if _e2640 {
                                                                let _e3680 = (_e3386 <= (_e2636 * f64(0.25f)));
                                                                phi_6170_ = select(select(select(f64(), f64(0f), _e3680), f64(), _e3387), (_e2942 + _e2942), select(select(true, false, _e3680), true, _e3387));
                                                            } else {
                                                                phi_6170_ = (_e2399.member_1 - _e2632);
                                                            }
                                                            let _e3689 = phi_6170_;
                                                            phi_6171_ = _e3689;
                                                            phi_6172_ = false;
                                                        } else {
                                                            phi_6171_ = f64();
                                                            phi_6172_ = true;
                                                        }
                                                        let _e3691 = phi_6171_;
                                                        let _e3693 = phi_6172_;
                                                        phi_6173_ = _e3691;
                                                        phi_6174_ = _e3386;
                                                        phi_6175_ = _e3676;
                                                        phi_6176_ = _e3693;
                                                    }
                                                    let _e3695 = phi_6173_;
                                                    let _e3697 = phi_6174_;
                                                    let _e3699 = phi_6175_;
                                                    let _e3701 = phi_6176_;
                                                    phi_6177_ = _e3384;
                                                    phi_6178_ = _e3695;
                                                    phi_6179_ = _e3697;
                                                    phi_6180_ = _e3384;
                                                    phi_6181_ = _e3699;
                                                    phi_6182_ = _e3385;
                                                    phi_6183_ = _e3701;
                                                    phi_6184_ = false;
                                                } else {
                                                    phi_6177_ = f64();
                                                    phi_6178_ = f64();
                                                    phi_6179_ = f64();
                                                    phi_6180_ = f64();
                                                    phi_6181_ = false;
                                                    phi_6182_ = false;
                                                    phi_6183_ = false;
                                                    phi_6184_ = true;
                                                }
                                                let _e3703 = phi_6177_;
                                                let _e3705 = phi_6178_;
                                                let _e3707 = phi_6179_;
                                                let _e3709 = phi_6180_;
                                                let _e3711 = phi_6181_;
                                                let _e3713 = phi_6182_;
                                                let _e3715 = phi_6183_;
                                                let _e3717 = phi_6184_;
                                                phi_6185_ = _e3703;
                                                phi_6186_ = _e3705;
                                                phi_6187_ = _e3707;
                                                phi_6188_ = _e3709;
                                                phi_6189_ = false;
                                                phi_6190_ = _e3711;
                                                phi_6191_ = _e3713;
                                                phi_6192_ = _e3715;
                                                phi_6193_ = _e3717;
                                            } else {
                                                phi_6185_ = f64();
                                                phi_6186_ = f64();
                                                phi_6187_ = f64();
                                                phi_6188_ = f64();
                                                phi_6189_ = true;
                                                phi_6190_ = false;
                                                phi_6191_ = false;
                                                phi_6192_ = false;
                                                phi_6193_ = false;
                                            }
                                            let _e3719 = phi_6185_;
                                            let _e3721 = phi_6186_;
                                            let _e3723 = phi_6187_;
                                            let _e3725 = phi_6188_;
                                            let _e3727 = phi_6189_;
                                            let _e3729 = phi_6190_;
                                            let _e3731 = phi_6191_;
                                            let _e3733 = phi_6192_;
                                            let _e3735 = phi_6193_;
                                            phi_6194_ = _e3719;
                                            phi_6195_ = _e3721;
                                            phi_6196_ = _e3723;
                                            phi_6197_ = _e3725;
                                            phi_6198_ = _e3727;
                                            phi_6199_ = _e3729;
                                            phi_6200_ = _e3731;
                                            phi_6201_ = _e3733;
                                            phi_6202_ = _e3735;
                                        } else {
                                            phi_6194_ = f64();
                                            phi_6195_ = f64();
                                            phi_6196_ = f64();
                                            phi_6197_ = f64();
                                            phi_6198_ = true;
                                            phi_6199_ = false;
                                            phi_6200_ = false;
                                            phi_6201_ = false;
                                            phi_6202_ = false;
                                        }
                                        let _e3737 = phi_6194_;
                                        let _e3739 = phi_6195_;
                                        let _e3741 = phi_6196_;
                                        let _e3743 = phi_6197_;
                                        let _e3745 = phi_6198_;
                                        let _e3747 = phi_6199_;
                                        let _e3749 = phi_6200_;
                                        let _e3751 = phi_6201_;
                                        let _e3753 = phi_6202_;
                                        if _e3745 {
                                            if (_e2632 <= _e2634) {
                                                let _e3911 = (_e2642 + 1u);
                                                let _e3912 = (_e3911 > 3u);
                                                phi_6542_ = _e3911;
                                                phi_6543_ = f64();
                                                phi_6544_ = false;
                                                phi_6545_ = select(true, false, _e3912);
                                                phi_6546_ = _e3912;
                                            } else {
                                                let _e3757 = local.member[0u];
                                                let _e3760 = local.member_1[0u];
                                                let _e3763 = local.member[0u];
                                                let _e3769 = local.member_2[0u];
                                                let _e3770 = ((_e3757 + ((_e3760 - _e3763) * _e2638)) - _e3769);
                                                let _e3773 = local.member[1u];
                                                let _e3776 = local.member_1[1u];
                                                let _e3779 = local.member[1u];
                                                let _e3785 = local.member_2[1u];
                                                let _e3786 = ((_e3773 + ((_e3776 - _e3779) * _e2638)) - _e3785);
                                                let _e3788 = select(_e3786, _e3770, (_e3770 < _e3786));
                                                let _e3791 = local.member[2u];
                                                let _e3794 = local.member_1[2u];
                                                let _e3797 = local.member[2u];
                                                let _e3803 = local.member_2[2u];
                                                let _e3804 = ((_e3791 + ((_e3794 - _e3797) * _e2638)) - _e3803);
                                                let _e3807 = local.member[3u];
                                                let _e3810 = local.member_1[3u];
                                                let _e3813 = local.member[3u];
                                                let _e3819 = local.member_2[3u];
                                                let _e3820 = ((_e3807 + ((_e3810 - _e3813) * _e2638)) - _e3819);
                                                let _e3822 = select(_e3820, _e3804, (_e3804 < _e3820));
                                                let _e3824 = select(_e3822, _e3788, (_e3788 < _e3822));
                                                let _e3827 = local_1.member[0u];
                                                let _e3830 = local_1.member_1[0u];
                                                let _e3833 = local_1.member[0u];
                                                let _e3839 = local_1.member_2[0u];
                                                let _e3840 = ((_e3827 + ((_e3830 - _e3833) * _e2632)) - _e3839);
                                                let _e3843 = local_1.member[1u];
                                                let _e3846 = local_1.member_1[1u];
                                                let _e3849 = local_1.member[1u];
                                                let _e3855 = local_1.member_2[1u];
                                                let _e3856 = ((_e3843 + ((_e3846 - _e3849) * _e2632)) - _e3855);
                                                let _e3858 = select(_e3856, _e3840, (_e3840 < _e3856));
                                                let _e3861 = local_1.member[2u];
                                                let _e3864 = local_1.member_1[2u];
                                                let _e3867 = local_1.member[2u];
                                                let _e3873 = local_1.member_2[2u];
                                                let _e3874 = ((_e3861 + ((_e3864 - _e3867) * _e2632)) - _e3873);
                                                let _e3877 = local_1.member[3u];
                                                let _e3880 = local_1.member_1[3u];
                                                let _e3883 = local_1.member[3u];
                                                let _e3889 = local_1.member_2[3u];
                                                let _e3890 = ((_e3877 + ((_e3880 - _e3883) * _e2632)) - _e3889);
                                                let _e3892 = select(_e3890, _e3874, (_e3874 < _e3890));
                                                let _e3894 = select(_e3892, _e3858, (_e3858 < _e3892));
                                                let _e3895 = f64(0.0625f);
                                                let _e3897 = f64(0.9f);
                                                if (_e3894 > f64(0f)) {
                                                    phi_6540_ = f64(0.5f);
                                                } else {
                                                    let _e3903 = (f64(0.95f) * (_e3824 / (_e3824 - _e3894)));
                                                    phi_6540_ = select(_e3895, select(_e3897, _e3903, (_e3903 < _e3897)), (_e3903 > _e3895));
                                                }
                                                let _e3909 = phi_6540_;
                                                phi_6542_ = u32();
                                                phi_6543_ = (_e2942 * _e3909);
                                                phi_6544_ = true;
                                                phi_6545_ = false;
                                                phi_6546_ = false;
                                            }
                                            let _e3915 = phi_6542_;
                                            let _e3917 = phi_6543_;
                                            let _e3919 = phi_6544_;
                                            let _e3921 = phi_6545_;
                                            let _e3923 = phi_6546_;
                                            phi_6547_ = _e3915;
                                            phi_6548_ = _e2634;
                                            phi_6549_ = _e3917;
                                            phi_6550_ = _e2636;
                                            phi_6551_ = _e2638;
                                            phi_6552_ = _e2640;
                                            phi_6553_ = _e2642;
                                            phi_6554_ = _e3919;
                                            phi_6555_ = _e3921;
                                            phi_6556_ = _e3923;
                                            phi_6557_ = false;
                                            phi_6558_ = false;
                                            phi_6559_ = false;
                                        } else {
                                            phi_6547_ = u32();
                                            phi_6548_ = _e3737;
                                            phi_6549_ = _e3739;
                                            phi_6550_ = _e3741;
                                            phi_6551_ = _e2632;
                                            phi_6552_ = true;
                                            phi_6553_ = 0u;
                                            phi_6554_ = _e3747;
                                            phi_6555_ = false;
                                            phi_6556_ = false;
                                            phi_6557_ = _e3749;
                                            phi_6558_ = _e3751;
                                            phi_6559_ = _e3753;
                                        }
                                        let _e3925 = phi_6547_;
                                        let _e3927 = phi_6548_;
                                        let _e3929 = phi_6549_;
                                        let _e3931 = phi_6550_;
                                        let _e3933 = phi_6551_;
                                        let _e3935 = phi_6552_;
                                        let _e3937 = phi_6553_;
                                        let _e3939 = phi_6554_;
                                        let _e3941 = phi_6555_;
                                        let _e3943 = phi_6556_;
                                        let _e3945 = phi_6557_;
                                        let _e3947 = phi_6558_;
                                        let _e3949 = phi_6559_;
                                        if _e3939 {
                                            let _e3950 = (_e3933 + _e3929);
                                            let _e3952 = select(_e3927, _e3950, (_e3950 > _e3927));
                                            let _e3954 = select(_e2399.member_1, _e3952, (_e3952 < _e2399.member_1));
                                            let _e3957 = select(((_e3954 - _e3933) > _e2621), true, !(_e2640));
                                            phi_6587_ = _e3954;
                                            phi_6588_ = _e3927;
                                            phi_6589_ = _e3931;
                                            phi_6590_ = _e3933;
                                            phi_6591_ = _e3935;
                                            phi_6592_ = _e3937;
                                            phi_6593_ = _e3957;
                                            phi_6594_ = select(true, false, _e3957);
                                            phi_6595_ = false;
                                            phi_6596_ = false;
                                            phi_6597_ = false;
                                            phi_6598_ = false;
                                        } else {
                                            phi_6587_ = _e2632;
                                            phi_6588_ = _e2634;
                                            phi_6589_ = _e2636;
                                            phi_6590_ = _e2638;
                                            phi_6591_ = _e2640;
                                            phi_6592_ = _e3925;
                                            phi_6593_ = _e3941;
                                            phi_6594_ = false;
                                            phi_6595_ = _e3943;
                                            phi_6596_ = _e3945;
                                            phi_6597_ = _e3947;
                                            phi_6598_ = _e3949;
                                        }
                                        let _e3960 = phi_6587_;
                                        let _e3962 = phi_6588_;
                                        let _e3964 = phi_6589_;
                                        let _e3966 = phi_6590_;
                                        let _e3968 = phi_6591_;
                                        let _e3970 = phi_6592_;
                                        let _e3972 = phi_6593_;
                                        let _e3974 = phi_6594_;
                                        let _e3976 = phi_6595_;
                                        let _e3978 = phi_6596_;
                                        let _e3980 = phi_6597_;
                                        let _e3982 = phi_6598_;
                                        phi_4377_ = _e3960;
                                        phi_4379_ = _e3962;
                                        phi_4381_ = _e3964;
                                        phi_4383_ = _e3966;
                                        phi_4385_ = _e3968;
                                        phi_4387_ = _e3970;
                                        phi_6599_ = _e3927;
                                        phi_6600_ = _e3743;
                                        phi_6601_ = _e3972;
                                        phi_6602_ = _e3974;
                                        phi_6603_ = _e3976;
                                        phi_6604_ = _e3978;
                                        phi_6605_ = _e3980;
                                        phi_6606_ = false;
                                        phi_6607_ = _e3982;
                                    } else {
                                        phi_4377_ = f64();
                                        phi_4379_ = f64();
                                        phi_4381_ = f64();
                                        phi_4383_ = f64();
                                        phi_4385_ = bool();
                                        phi_4387_ = u32();
                                        phi_6599_ = f64();
                                        phi_6600_ = f64();
                                        phi_6601_ = false;
                                        phi_6602_ = false;
                                        phi_6603_ = false;
                                        phi_6604_ = false;
                                        phi_6605_ = false;
                                        phi_6606_ = true;
                                        phi_6607_ = false;
                                    }
                                    let _e3984 = phi_4377_;
                                    let _e3986 = phi_4379_;
                                    let _e3988 = phi_4381_;
                                    let _e3990 = phi_4383_;
                                    let _e3992 = phi_4385_;
                                    let _e3994 = phi_4387_;
                                    let _e3996 = phi_6599_;
                                    let _e3998 = phi_6600_;
                                    let _e4000 = phi_6601_;
                                    let _e4002 = phi_6602_;
                                    let _e4004 = phi_6603_;
                                    let _e4006 = phi_6604_;
                                    let _e4008 = phi_6605_;
                                    let _e4010 = phi_6606_;
                                    let _e4012 = phi_6607_;
                                    local_22 = _e4002;
                                    local_23 = _e4004;
                                    local_24 = _e4002;
                                    local_25 = _e4006;
                                    local_26 = _e4002;
                                    local_27 = _e4008;
                                    local_28 = _e4002;
                                    local_29 = _e4010;
                                    local_30 = _e4002;
                                    local_31 = _e4012;
                                    local_33 = _e4002;
                                    local_34 = _e3998;
                                    local_35 = _e3996;
                                    continue;
                                    continuing {
                                        phi_4373_ = type_9(select(_e2630.member, (_e2630.member + 1u), _e2645), select(_e2630.member_1, _e2630.member_1, _e2645));
                                        phi_4376_ = _e3984;
                                        phi_4378_ = _e3986;
                                        phi_4380_ = _e3988;
                                        phi_4382_ = _e3990;
                                        phi_4384_ = _e3992;
                                        phi_4386_ = _e3994;
                                        break if !(_e4000);
                                    }
                                }
                                let _e4015 = local_22;
                                let _e4017 = local_23;
                                let _e4018 = select(_e4017, false, _e4015);
                                let _e4020 = local_24;
                                let _e4022 = local_25;
                                let _e4025 = local_26;
                                let _e4027 = local_27;
                                let _e4030 = local_28;
                                let _e4032 = local_29;
                                let _e4035 = local_30;
                                let _e4037 = local_31;
                                let _e4043 = local_32;
                                let _e4045 = select(select(_e4022, false, _e4020), false, _e4018);
                                let _e4048 = local_33;
                                let _e4055 = select(select(select(_e4027, false, _e4025), false, _e4018), false, _e4045);
                                let _e4061 = local_34;
                                let _e4063 = local_35;
                                let _e4065 = select(select(select(_e4048, false, _e4018), false, _e4045), true, _e4055);
                                let _e4070 = local_36;
                                let _e4072 = select(select(select(select(select(_e4032, false, _e4030), false, _e4018), false, _e4045), false, _e4055), true, _e4065);
                                let _e4079 = select(select(select(select(select(select(_e4037, false, _e4035), false, _e4018), false, _e4045), false, _e4055), false, _e4065), false, _e4072);
                                let _e4084 = select(select(select(select(select(_e4018, true, _e4045), false, _e4055), false, _e4065), false, _e4072), true, _e4079);
                                let _e4087 = (select(select(type_42().member, 1u, _e4072), select(select(select(type_42().member, 1u, _e4018), 0u, _e4045), 0u, _e4079), _e4084) != 0u);
                                phi_6675_ = select(select(type_42().member_1, select(_e4070, select(_e4063, _e4061, _e4055), _e4065), _e4072), select(select(select(type_42().member_1, _e4043, _e4018), type_42().member_1, _e4045), type_42().member_1, _e4079), _e4084);
                                phi_6676_ = select(true, false, _e4087);
                                phi_6677_ = _e4087;
                                phi_6678_ = false;
                                phi_6679_ = false;
                                phi_6680_ = false;
                            } else {
                                phi_6675_ = f64();
                                phi_6676_ = _e2407;
                                phi_6677_ = false;
                                phi_6678_ = _e2409;
                                phi_6679_ = _e2411;
                                phi_6680_ = _e2413;
                            }
                            let _e4090 = phi_6675_;
                            let _e4092 = phi_6676_;
                            let _e4094 = phi_6677_;
                            let _e4096 = phi_6678_;
                            let _e4098 = phi_6679_;
                            let _e4100 = phi_6680_;
                            phi_6681_ = _e2399;
                            phi_6682_ = _e2401;
                            phi_6683_ = _e4090;
                            phi_6684_ = _e2403;
                            phi_6685_ = _e4092;
                            phi_6686_ = _e4094;
                            phi_6687_ = false;
                            phi_6688_ = _e4096;
                            phi_6689_ = _e4098;
                            phi_6690_ = _e4100;
                        } else {
                            phi_6681_ = type_43();
                            phi_6682_ = bool();
                            phi_6683_ = f64();
                            phi_6684_ = type_43();
                            phi_6685_ = false;
                            phi_6686_ = false;
                            phi_6687_ = true;
                            phi_6688_ = false;
                            phi_6689_ = false;
                            phi_6690_ = false;
                        }
                        let _e4102 = phi_6681_;
                        let _e4104 = phi_6682_;
                        let _e4106 = phi_6683_;
                        let _e4108 = phi_6684_;
                        let _e4110 = phi_6685_;
                        let _e4112 = phi_6686_;
                        let _e4114 = phi_6687_;
                        let _e4116 = phi_6688_;
                        let _e4118 = phi_6689_;
                        let _e4120 = phi_6690_;
                        local_37 = _e4112;
                        local_38 = _e4104;
                        local_39 = _e4102;
                        local_40 = _e4106;
                        local_41 = _e4106;
                        local_42 = _e4106;
                        local_46 = _e4114;
                        local_47 = _e4116;
                        local_48 = _e4118;
                        local_49 = _e4120;
                        local_43 = _e4112;
                        local_44 = _e4108;
                        continue;
                        continuing {
                            phi_2473_ = type_9(select(_e1382.member, (_e1382.member + 1u), _e1385), select(_e1382.member_1, _e1382.member_1, _e1385));
                            break if !(_e4110);
                        }
                    }
                    let _e4123 = local_37;
                    if _e4123 {
                        let _e4125 = local_38;
                        if _e4125 {
                            let _e4127 = local_39;
                            let _e4130 = local_40;
                            let _e4132 = ((_e4127.member_1 - _e4130) <= _e1345);
                            let _e4137 = local_41;
                            phi_6706_ = type_42(select(type_42().member, 1u, _e4132), select(type_42().member_1, _e4137, _e4132));
                            phi_6707_ = select(true, false, _e4132);
                        } else {
                            phi_6706_ = type_42();
                            phi_6707_ = true;
                        }
                        let _e4142 = phi_6706_;
                        let _e4144 = phi_6707_;
                        let _e4149 = local_42;
                        phi_6713_ = type_42(select(_e4142.member, 2u, _e4144), select(_e4142.member_1, _e4149, _e4144));
                        phi_6714_ = false;
                        phi_6715_ = false;
                        phi_6716_ = false;
                        phi_6717_ = false;
                    } else {
                        phi_6713_ = type_42();
                        let _e4637 = local_46;
                        phi_6714_ = _e4637;
                        let _e4640 = local_47;
                        phi_6715_ = _e4640;
                        let _e4643 = local_48;
                        phi_6716_ = _e4643;
                        let _e4646 = local_49;
                        phi_6717_ = _e4646;
                    }
                    let _e4153 = phi_6713_;
                    let _e4155 = phi_6714_;
                    let _e4157 = phi_6715_;
                    let _e4159 = phi_6716_;
                    let _e4161 = phi_6717_;
                    let _e4168 = select(_e4157, false, _e4155);
                    let _e4172 = local_43;
                    let _e4179 = select(select(_e4159, false, _e4155), false, _e4168);
                    let _e4185 = select(select(select(_e4161, false, _e4155), false, _e4168), false, _e4179);
                    let _e4189 = local_44;
                    let _e4193 = select(select(_e4168, true, _e4179), true, _e4185);
                    phi_6759_ = type_42(select(_e4153.member, select(select(select(type_42().member, 0u, _e4168), 0u, _e4179), 1u, _e4185), _e4193), select(_e4153.member_1, select(select(select(type_42().member_1, type_42().member_1, _e4168), type_42().member_1, _e4179), _e4189.member, _e4185), _e4193));
                    phi_6760_ = type_42(select(type_42().member, 0u, _e4155), select(type_42().member_1, type_42().member_1, _e4155));
                    phi_6761_ = select(select(select(select(select(_e4172, false, _e4155), false, _e4168), false, _e4179), false, _e4185), true, _e4193);
                }
                let _e4204 = phi_6759_;
                let _e4206 = phi_6760_;
                let _e4208 = phi_6761_;
                let _e4211 = select(_e4206.member, _e4204.member, _e4208);
                let _e4214 = select(_e4206.member_1, _e4204.member_1, _e4208);
                let _e4220 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e4214 > _e533)), (_e4211 == 1u))));
                switch bitcast<i32>(_e4211) {
                    case 0: {
                        phi_6805_ = type_35(0u, _e4220, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4224 = function_2(_e4214);
                        phi_6805_ = type_35(0u, _e4220, _e4224, true);
                        break;
                    }
                    case 2: {
                        let _e4222 = function_2(_e4214);
                        phi_6805_ = type_35(1u, _e4220, _e4222, true);
                        break;
                    }
                    default: {
                        phi_6805_ = type_35();
                        break;
                    }
                }
                let _e4228 = phi_6805_;
                local_8 = type_35(_e4228.member, _e4228.member_1, array<u32, 2>(_e4228.member_2[0], _e4228.member_2[1]), _e4228.member_3);
                phi_6814_ = type_9(_e188, _e191);
            } else {
                phi_6814_ = type_9(0u, 0u);
            }
            let _e4238 = phi_6814_;
            let _e4244 = local_8.member;
            let _e4246 = select(true, false, (_e4244 == 0u));
            let _e4248 = local_8.member_3;
            if _e4248 {
                if _e4246 {
                    phi_6843_ = true;
                } else {
                    let _e4250 = params.member.member.member_1;
                    phi_6843_ = ((_e4250 & 16u) != 0u);
                }
                let _e4254 = phi_6843_;
                phi_6844_ = _e4254;
            } else {
                phi_6844_ = false;
            }
            let _e4256 = phi_6844_;
            let _e4258 = local_8.member_3;
            if _e4258 {
                if _e4246 {
                } else {
                    let _e4260 = local_8.member_2;
                    let _e4264 = (_e4260[1] >> bitcast<u32>(20i));
                    let _e4278 = atomicMin((&earliest.member[0u]), select(((((_e4264 - 896u) << bitcast<u32>(23i)) | ((_e4260[1] & 1048575u) << bitcast<u32>(3i))) | (_e4260[0] >> bitcast<u32>(29i))), 0u, (_e4264 <= 896u)));
                }
            }
            if (_e106 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4256 {
                let _e4282 = atomicAdd((&counters[0u]), 1u);
                phi_6887_ = _e4282;
            } else {
                phi_6887_ = 0u;
            }
            let _e4284 = phi_6887_;
            workgroupBarrier();
            if (_e106 == 0u) {
                let _e4287 = atomicLoad((&counters[0u]));
                if (_e4287 > 0u) {
                    let _e4290 = atomicAdd((&contacts.member[0u]), _e4287);
                    atomicStore((&counters[1u]), _e4290);
                }
            }
            workgroupBarrier();
            let _e4293 = atomicLoad((&counters[1u]));
            let _e4294 = (_e4293 + _e4284);
            if _e4256 {
                let _e4296 = params.member.member_1.member_3;
                if (_e4294 < _e4296) {
                    let _e4302 = (7u * _e4294);
                    atomicStore((&contacts.member[(4u + _e4302)]), select(1u, 0u, ((_e4238.member_1 & 2147483648u) == 0u)));
                    let _e4307 = local_8.member;
                    atomicStore((&contacts.member[(_e4302 + 5u)]), _e4307);
                    atomicStore((&contacts.member[(_e4302 + 6u)]), _e4238.member);
                    atomicStore((&contacts.member[(_e4302 + 7u)]), (_e4238.member_1 & 2147483647u));
                    let _e4316 = local_8.member_2[0u];
                    atomicStore((&contacts.member[(_e4302 + 8u)]), _e4316);
                    let _e4321 = local_8.member_2[1u];
                    atomicStore((&contacts.member[(_e4302 + 9u)]), _e4321);
                    let _e4325 = local_8.member_1;
                    atomicStore((&contacts.member[(_e4302 + 10u)]), _e4325);
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
