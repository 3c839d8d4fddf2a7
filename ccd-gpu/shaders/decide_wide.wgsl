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
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_37 {
    member: f64,
    member_1: f64,
}

struct type_40 {
    member: array<f64, 4>,
    member_1: f64,
    member_2: f64,
    member_3: f64,
}

struct type_42 {
    member: type_32,
    member_1: f64,
}

struct type_43 {
    member: u32,
    member_1: f64,
}

struct type_44 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_48 {
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
var<storage, read_write> earliest: type_48;
@group(0) @binding(3) 
var<storage> elements: type_13;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_48;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_239_: f64;
    var phi_282_: f64;
    var phi_325_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_239_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_239_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_239_;
    let _e40 = bitcast<u32>(param[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_282_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_282_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_282_;
    let _e70 = bitcast<u32>(param[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_325_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_325_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_325_;
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
    var phi_7627_: array<array<f64, 3>, 4>;

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
        phi_7627_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e171)), (param_4[1] - (param_5[1] * _e171)), (param_4[2] - (param_5[2] * _e171))), array<f64, 3>((param_4[0] - (param_6[0] * _e215)), (param_4[1] - (param_6[1] * _e215)), (param_4[2] - (param_6[2] * _e215))), array<f64, 3>((_e9 - (param_6[0] * _e256)), (_e12 - (param_6[1] * _e256)), (_e15 - (param_6[2] * _e256))), array<f64, 3>((_e269 - (param_5[0] * _e303)), (_e272 - (param_5[1] * _e303)), (_e275 - (param_5[2] * _e303))));
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
        phi_7627_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e82)), (param_4[1] - (param_5[1] * _e82)), (param_4[2] - (param_5[2] * _e82))), array<f64, 3>((param_4[0] - (param_6[0] * _e126)), (param_4[1] - (param_6[1] * _e126)), (param_4[2] - (param_6[2] * _e126))), _e51, _e51);
    }
    let _e316 = phi_7627_;
    let _e319 = function_2(_e316[0], _e316[1]);
    let _e321 = function_2(_e319, _e316[2]);
    let _e323 = function_2(_e321, _e316[3]);
    return _e323;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_7226_: bool;
    var phi_7260_: array<f64, 3>;
    var phi_7261_: bool;
    var phi_7262_: array<f64, 3>;
    var phi_7263_: bool;
    var phi_7268_: array<f64, 3>;

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
        phi_7226_ = select(select(bool(), select(bool(), select(bool(), (_e80 <= _e72), _e93), _e92), _e91), false, select(true, select(true, select(true, false, _e93), _e92), _e91));
    } else {
        let _e82 = (_e76 >= _e71);
        let _e83 = (_e80 >= _e71);
        phi_7226_ = select(select(bool(), select(bool(), ((_e76 + _e80) <= _e72), _e83), _e82), false, select(true, select(true, false, _e83), _e82));
    }
    let _e103 = phi_7226_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e103 {
            phi_7260_ = array<f64, 3>((param_8[0] - ((param_9[0] * _e76) + (param_10[0] * _e80))), (param_8[1] - ((param_9[1] * _e76) + (param_10[1] * _e80))), (param_8[2] - ((param_9[2] * _e76) + (param_10[2] * _e80))));
            phi_7261_ = false;
        } else {
            phi_7260_ = array<f64, 3>();
            phi_7261_ = true;
        }
        let _e132 = phi_7260_;
        let _e134 = phi_7261_;
        phi_7262_ = _e132;
        phi_7263_ = _e134;
    } else {
        phi_7262_ = array<f64, 3>();
        phi_7263_ = true;
    }
    let _e136 = phi_7262_;
    let _e138 = phi_7263_;
    if _e138 {
        let _e139 = function_3(param_8, param_9, param_10, param_11);
        phi_7268_ = _e139;
    } else {
        phi_7268_ = _e136;
    }
    let _e141 = phi_7268_;
    return _e141;
}

fn function_5(param_12: ptr<function, type_40>, param_13: f64, param_14: f64, param_15: f64) -> bool {
    var phi_7101_: bool;
    var phi_7102_: bool;
    var phi_7107_: bool;

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
            phi_7101_ = select(bool(), ((_e45 > f64(0f)) == (_e72 > f64(0f))), _e87);
            phi_7102_ = select(true, false, _e87);
        } else {
            phi_7101_ = bool();
            phi_7102_ = true;
        }
        let _e96 = phi_7101_;
        let _e98 = phi_7102_;
        phi_7107_ = select(_e96, false, _e98);
    } else {
        phi_7107_ = false;
    }
    let _e101 = phi_7107_;
    return _e101;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_35;
    var local_1: type_35;
    var local_2: type_36;
    var local_3: type_36;
    var local_4: type_36;
    var local_5: array<type_37, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: type_40;
    var local_9: array<f64, 4>;
    var local_10: type_32;
    var phi_388_: u32;
    var phi_436_: u32;
    var phi_439_: type_9;
    var phi_594_: type_22;
    var phi_790_: type_30;
    var phi_951_: type_32;
    var phi_1224_: bool;
    var phi_1320_: type_42;
    var phi_1321_: bool;
    var phi_1322_: type_42;
    var phi_1323_: bool;
    var phi_1324_: type_42;
    var phi_1325_: bool;
    var phi_1330_: type_42;
    var phi_2070_: bool;
    var phi_2085_: f64;
    var phi_2161_: type_18;
    var phi_2164_: f64;
    var phi_2162_: type_18;
    var phi_2205_: type_19;
    var phi_2165_: f64;
    var local_11: f64;
    var phi_2218_: f64;
    var phi_2249_: type_9;
    var phi_2252_: u32;
    var phi_2319_: u32;
    var phi_2320_: u32;
    var phi_2253_: u32;
    var phi_2321_: u32;
    var phi_2379_: type_9;
    var phi_2539_: type_44;
    var phi_2540_: bool;
    var phi_2541_: type_44;
    var phi_2542_: bool;
    var phi_2577_: type_9;
    var phi_2580_: f64;
    var phi_2582_: f64;
    var phi_2584_: f64;
    var phi_2698_: bool;
    var phi_2705_: f64;
    var phi_2706_: bool;
    var phi_2581_: f64;
    var phi_2583_: f64;
    var phi_2585_: f64;
    var phi_2707_: f64;
    var phi_2708_: bool;
    var phi_2709_: bool;
    var local_12: bool;
    var local_13: f64;
    var local_14: f64;
    var phi_2714_: f64;
    var phi_2732_: type_9;
    var phi_2735_: f64;
    var phi_2801_: f64;
    var phi_2802_: bool;
    var phi_2803_: bool;
    var phi_2804_: bool;
    var phi_2805_: f64;
    var phi_2736_: f64;
    var phi_2806_: bool;
    var phi_2807_: bool;
    var phi_2808_: bool;
    var phi_2809_: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: f64;
    var phi_2823_: f64;
    var phi_2825_: type_44;
    var phi_3558_: u32;
    var phi_3559_: u32;
    var phi_3836_: array<type_37, 4>;
    var phi_3856_: type_9;
    var phi_3859_: bool;
    var phi_3860_: bool;
    var phi_3911_: bool;
    var phi_3912_: bool;
    var local_20: bool;
    var local_21: bool;
    var phi_3926_: u32;
    var phi_3927_: u32;
    var phi_3928_: bool;
    var phi_3959_: bool;
    var phi_3960_: bool;
    var phi_3961_: bool;
    var phi_3962_: bool;
    var phi_3963_: bool;
    var phi_3964_: bool;
    var phi_3965_: bool;
    var phi_3966_: bool;
    var phi_3967_: bool;
    var phi_3968_: bool;
    var phi_3969_: bool;
    var phi_3970_: bool;
    var phi_3971_: type_44;
    var phi_3972_: bool;
    var phi_3973_: type_44;
    var phi_3974_: bool;
    var phi_3975_: bool;
    var phi_3976_: bool;
    var phi_3977_: bool;
    var phi_3978_: type_44;
    var phi_3979_: bool;
    var phi_3980_: type_44;
    var phi_3981_: bool;
    var phi_3982_: bool;
    var phi_3983_: bool;
    var phi_3984_: bool;
    var phi_3985_: bool;
    var phi_3993_: type_44;
    var phi_3994_: bool;
    var phi_3995_: type_44;
    var phi_3996_: bool;
    var phi_3997_: bool;
    var phi_3998_: bool;
    var phi_3999_: bool;
    var phi_4000_: bool;
    var phi_4429_: type_9;
    var phi_4432_: f64;
    var phi_4434_: f64;
    var phi_4436_: f64;
    var phi_4438_: f64;
    var phi_4440_: bool;
    var phi_4442_: u32;
    var phi_4594_: array<f64, 3>;
    var phi_4662_: type_18;
    var phi_4665_: f64;
    var phi_4663_: type_18;
    var phi_4706_: type_19;
    var phi_4666_: f64;
    var local_22: f64;
    var phi_4719_: f64;
    var phi_4845_: type_35;
    var phi_4846_: bool;
    var phi_4847_: type_35;
    var phi_4848_: bool;
    var phi_4858_: type_35;
    var phi_5030_: bool;
    var phi_5031_: bool;
    var phi_5032_: bool;
    var phi_5033_: bool;
    var phi_5034_: bool;
    var phi_5035_: bool;
    var phi_5337_: bool;
    var phi_5338_: bool;
    var phi_5339_: bool;
    var phi_5340_: bool;
    var phi_5341_: bool;
    var phi_5342_: bool;
    var phi_5350_: bool;
    var phi_5460_: f64;
    var phi_5461_: bool;
    var phi_5462_: f64;
    var phi_5463_: bool;
    var phi_5464_: f64;
    var phi_5465_: bool;
    var phi_5466_: bool;
    var phi_5532_: f64;
    var phi_5533_: bool;
    var phi_5534_: f64;
    var phi_5535_: bool;
    var phi_5536_: f64;
    var phi_5537_: bool;
    var phi_5538_: bool;
    var phi_5609_: f64;
    var phi_5610_: bool;
    var phi_5611_: f64;
    var phi_5612_: bool;
    var phi_5613_: f64;
    var phi_5614_: bool;
    var phi_5615_: bool;
    var phi_5681_: f64;
    var phi_5682_: bool;
    var phi_5683_: f64;
    var phi_5684_: bool;
    var phi_5685_: f64;
    var phi_5686_: bool;
    var phi_5687_: bool;
    var phi_5864_: type_18;
    var phi_5867_: f64;
    var phi_5865_: type_18;
    var phi_5908_: type_19;
    var phi_5868_: f64;
    var local_23: f64;
    var phi_5921_: f64;
    var phi_6198_: bool;
    var phi_6199_: bool;
    var phi_6226_: f64;
    var phi_6227_: f64;
    var phi_6228_: bool;
    var phi_6229_: f64;
    var phi_6230_: f64;
    var phi_6231_: bool;
    var phi_6232_: bool;
    var phi_6233_: f64;
    var phi_6234_: f64;
    var phi_6235_: f64;
    var phi_6236_: f64;
    var phi_6237_: bool;
    var phi_6238_: bool;
    var phi_6239_: bool;
    var phi_6240_: bool;
    var phi_6241_: f64;
    var phi_6242_: f64;
    var phi_6243_: f64;
    var phi_6244_: f64;
    var phi_6245_: bool;
    var phi_6246_: bool;
    var phi_6247_: bool;
    var phi_6248_: bool;
    var phi_6249_: bool;
    var phi_6250_: f64;
    var phi_6251_: f64;
    var phi_6252_: f64;
    var phi_6253_: f64;
    var phi_6254_: bool;
    var phi_6255_: bool;
    var phi_6256_: bool;
    var phi_6257_: bool;
    var phi_6258_: bool;
    var phi_6596_: f64;
    var phi_6598_: u32;
    var phi_6599_: f64;
    var phi_6600_: bool;
    var phi_6601_: bool;
    var phi_6602_: bool;
    var phi_6603_: u32;
    var phi_6604_: f64;
    var phi_6605_: f64;
    var phi_6606_: f64;
    var phi_6607_: f64;
    var phi_6608_: bool;
    var phi_6609_: u32;
    var phi_6610_: bool;
    var phi_6611_: bool;
    var phi_6612_: bool;
    var phi_6613_: bool;
    var phi_6614_: bool;
    var phi_6615_: bool;
    var phi_6643_: f64;
    var phi_6644_: f64;
    var phi_6645_: f64;
    var phi_6646_: f64;
    var phi_6647_: bool;
    var phi_6648_: u32;
    var phi_6649_: bool;
    var phi_6650_: bool;
    var phi_6651_: bool;
    var phi_6652_: bool;
    var phi_6653_: bool;
    var phi_6654_: bool;
    var phi_4433_: f64;
    var phi_4435_: f64;
    var phi_4437_: f64;
    var phi_4439_: f64;
    var phi_4441_: bool;
    var phi_4443_: u32;
    var phi_6655_: f64;
    var phi_6656_: f64;
    var phi_6657_: bool;
    var phi_6658_: bool;
    var phi_6659_: bool;
    var phi_6660_: bool;
    var phi_6661_: bool;
    var phi_6662_: bool;
    var phi_6663_: bool;
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
    var phi_6731_: f64;
    var phi_6732_: bool;
    var phi_6733_: bool;
    var phi_6734_: bool;
    var phi_6735_: bool;
    var phi_6736_: bool;
    var phi_6737_: type_44;
    var phi_6738_: bool;
    var phi_6739_: f64;
    var phi_6740_: type_44;
    var phi_6741_: bool;
    var phi_6742_: bool;
    var phi_6743_: bool;
    var phi_6744_: bool;
    var phi_6745_: bool;
    var phi_6746_: bool;
    var local_39: bool;
    var local_40: bool;
    var local_41: type_44;
    var local_42: f64;
    var local_43: f64;
    var phi_6762_: type_43;
    var phi_6763_: bool;
    var local_44: f64;
    var phi_6769_: type_43;
    var phi_6770_: bool;
    var phi_6771_: bool;
    var phi_6772_: bool;
    var phi_6773_: bool;
    var local_45: bool;
    var local_46: type_44;
    var phi_6815_: type_43;
    var phi_6816_: type_43;
    var phi_6817_: bool;
    var phi_6861_: type_34;
    var phi_6862_: type_34;
    var phi_6863_: type_9;
    var phi_6909_: u32;
    var phi_6923_: u32;
    var phi_6983_: bool;
    var phi_6984_: bool;
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
        phi_388_ = (_e130 - _e135);
    } else {
        phi_388_ = 0u;
    }
    let _e138 = phi_388_;
    let _e140 = params.member.member_1.member;
    let _e142 = select(_e138, _e140, (_e140 < _e138));
    let _e145 = params.member.member_2.member;
    let _e146 = (_e142 / 64u);
    let _e150 = select(_e146, (_e146 + 1u), ((_e142 % 64u) > 0u));
    if (_e150 > _e120) {
        let _e152 = (_e150 - _e120);
        if (_e123 == 0u) {
            return;
        }
        let _e154 = (_e152 / _e123);
        if (_e123 == 0u) {
            return;
        }
        phi_436_ = select(_e154, (_e154 + 1u), ((_e152 % _e123) > 0u));
    } else {
        phi_436_ = 0u;
    }
    let _e161 = phi_436_;
    phi_439_ = type_9(0u, _e161);
    loop {
        let _e164 = phi_439_;
        let _e167 = (_e164.member < _e164.member_1);
        let _e180 = (bitcast<i32>(select(0u, 1u, _e167)) != 0i);
        if _e180 {
            let _e184 = (((_e120 + (select(type_9().member_1, _e164.member, _e167) * _e123)) * 64u) + _e108);
            if (_e184 < _e142) {
                let _e188 = params.member.member_1.member_1;
                let _e190 = (2u * (_e188 + _e184));
                let _e193 = input.member[(4u + _e190)];
                let _e196 = input.member[(_e190 + 5u)];
                if (_e145 == 0u) {
                    let _e214 = (3u * _e196);
                    let _e216 = elements.member[_e214];
                    let _e219 = elements.member[(_e214 + 1u)];
                    let _e222 = elements.member[(_e214 + 2u)];
                    phi_594_ = type_22(0u, array<u32, 4>(_e193, _e216, _e219, _e222));
                } else {
                    let _e200 = (2u * _e193);
                    let _e201 = (2u * _e196);
                    let _e203 = elements.member[_e200];
                    let _e205 = elements.member[_e201];
                    let _e208 = elements.member[(_e200 + 1u)];
                    let _e211 = elements.member[(_e201 + 1u)];
                    phi_594_ = type_22(1u, array<u32, 4>(_e203, _e208, _e205, _e211));
                }
                let _e226 = phi_594_;
                let _e230 = params.member.member.member_1;
                if ((_e230 & 8u) != 0u) {
                    let _e274 = paths.member[_e226.member_1[0]];
                    let _e289 = paths.member[_e226.member_1[1]];
                    let _e304 = paths.member[_e226.member_1[2]];
                    let _e319 = paths.member[_e226.member_1[3]];
                    let _e340 = function_(array<f32, 3>(_e274.member.x, _e274.member.y, _e274.member.z));
                    let _e341 = function_(array<f32, 3>(_e289.member.x, _e289.member.y, _e289.member.z));
                    let _e342 = function_(array<f32, 3>(_e304.member.x, _e304.member.y, _e304.member.z));
                    let _e343 = function_(array<f32, 3>(_e319.member.x, _e319.member.y, _e319.member.z));
                    let _e345 = function_(array<f32, 3>(_e274.member_1.x, _e274.member_1.y, _e274.member_1.z));
                    let _e346 = function_(array<f32, 3>(_e289.member_1.x, _e289.member_1.y, _e289.member_1.z));
                    let _e347 = function_(array<f32, 3>(_e304.member_1.x, _e304.member_1.y, _e304.member_1.z));
                    let _e348 = function_(array<f32, 3>(_e319.member_1.x, _e319.member_1.y, _e319.member_1.z));
                    phi_790_ = type_30(array<array<f64, 3>, 4>(_e340, _e341, _e342, _e343), array<array<f64, 3>, 4>(_e345, _e346, _e347, _e348));
                } else {
                    let _e235 = positions.member[_e226.member_1[0]];
                    let _e238 = params.member.member.member[0u];
                    let _e241 = positions.member[(_e238 + _e226.member_1[0])];
                    let _e244 = positions.member[_e226.member_1[1]];
                    let _e247 = params.member.member.member[0u];
                    let _e250 = positions.member[(_e247 + _e226.member_1[1])];
                    let _e253 = positions.member[_e226.member_1[2]];
                    let _e256 = params.member.member.member[0u];
                    let _e259 = positions.member[(_e256 + _e226.member_1[2])];
                    let _e262 = positions.member[_e226.member_1[3]];
                    let _e265 = params.member.member.member[0u];
                    let _e268 = positions.member[(_e265 + _e226.member_1[3])];
                    phi_790_ = type_30(array<array<f64, 3>, 4>(_e235, _e244, _e253, _e262), array<array<f64, 3>, 4>(_e241, _e250, _e259, _e268));
                }
                let _e352 = phi_790_;
                if (_e226.member != 0u) {
                    phi_951_ = type_32(array<array<f64, 3>, 2>(array<f64, 3>((_e352.member[2][0] - _e352.member[0][0]), (_e352.member[2][1] - _e352.member[0][1]), (_e352.member[2][2] - _e352.member[0][2])), array<f64, 3>((_e352.member_1[2][0] - _e352.member_1[0][0]), (_e352.member_1[2][1] - _e352.member_1[0][1]), (_e352.member_1[2][2] - _e352.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e352.member[1][0] - _e352.member[0][0]), (_e352.member[1][1] - _e352.member[0][1]), (_e352.member[1][2] - _e352.member[0][2])), array<f64, 3>((_e352.member_1[1][0] - _e352.member_1[0][0]), (_e352.member_1[1][1] - _e352.member_1[0][1]), (_e352.member_1[1][2] - _e352.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e352.member[2][0] - _e352.member[3][0]), (_e352.member[2][1] - _e352.member[3][1]), (_e352.member[2][2] - _e352.member[3][2])), array<f64, 3>((_e352.member_1[2][0] - _e352.member_1[3][0]), (_e352.member_1[2][1] - _e352.member_1[3][1]), (_e352.member_1[2][2] - _e352.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_951_ = type_32(array<array<f64, 3>, 2>(array<f64, 3>((_e352.member[0][0] - _e352.member[1][0]), (_e352.member[0][1] - _e352.member[1][1]), (_e352.member[0][2] - _e352.member[1][2])), array<f64, 3>((_e352.member_1[0][0] - _e352.member_1[1][0]), (_e352.member_1[0][1] - _e352.member_1[1][1]), (_e352.member_1[0][2] - _e352.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e352.member[2][0] - _e352.member[1][0]), (_e352.member[2][1] - _e352.member[1][1]), (_e352.member[2][2] - _e352.member[1][2])), array<f64, 3>((_e352.member_1[2][0] - _e352.member_1[1][0]), (_e352.member_1[2][1] - _e352.member_1[1][1]), (_e352.member_1[2][2] - _e352.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e352.member[3][0] - _e352.member[1][0]), (_e352.member[3][1] - _e352.member[1][1]), (_e352.member[3][2] - _e352.member[1][2])), array<f64, 3>((_e352.member_1[3][0] - _e352.member_1[1][0]), (_e352.member_1[3][1] - _e352.member_1[1][1]), (_e352.member_1[3][2] - _e352.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e511 = phi_951_;
                let _e513 = params.member.member.member_14;
                let _e520 = bitcast<f64>(((u64(_e513[1]) * 4294967296lu) + u64(_e513[0])));
                let _e522 = params.member.member.member_15;
                let _e529 = bitcast<f64>(((u64(_e522[1]) * 4294967296lu) + u64(_e522[0])));
                let _e531 = params.member.member.member_16;
                let _e538 = bitcast<f64>(((u64(_e531[1]) * 4294967296lu) + u64(_e531[0])));
                let _e540 = params.member.member.member_16;
                let _e547 = bitcast<f64>(((u64(_e540[1]) * 4294967296lu) + u64(_e540[0])));
                let _e548 = f64(0f);
                let _e554 = select(_e511.member[0][0], -(_e511.member[0][0]), (_e511.member[0][0] < 0.0lf));
                let _e558 = select(_e511.member[0][1], -(_e511.member[0][1]), (_e511.member[0][1] < 0.0lf));
                let _e560 = select(_e558, _e554, (_e554 > _e558));
                let _e564 = select(_e511.member[0][2], -(_e511.member[0][2]), (_e511.member[0][2] < 0.0lf));
                let _e566 = select(_e564, _e560, (_e560 > _e564));
                let _e572 = select(_e511.member[1][0], -(_e511.member[1][0]), (_e511.member[1][0] < 0.0lf));
                let _e576 = select(_e511.member[1][1], -(_e511.member[1][1]), (_e511.member[1][1] < 0.0lf));
                let _e578 = select(_e576, _e572, (_e572 > _e576));
                let _e582 = select(_e511.member[1][2], -(_e511.member[1][2]), (_e511.member[1][2] < 0.0lf));
                let _e584 = select(_e582, _e578, (_e578 > _e582));
                let _e588 = (select(_e584, _e566, (_e566 > _e584)) + _e511.member_3);
                let _e594 = select(_e511.member_1[0][0], -(_e511.member_1[0][0]), (_e511.member_1[0][0] < 0.0lf));
                let _e598 = select(_e511.member_1[0][1], -(_e511.member_1[0][1]), (_e511.member_1[0][1] < 0.0lf));
                let _e600 = select(_e598, _e594, (_e594 > _e598));
                let _e604 = select(_e511.member_1[0][2], -(_e511.member_1[0][2]), (_e511.member_1[0][2] < 0.0lf));
                let _e606 = select(_e604, _e600, (_e600 > _e604));
                let _e612 = select(_e511.member_1[1][0], -(_e511.member_1[1][0]), (_e511.member_1[1][0] < 0.0lf));
                let _e616 = select(_e511.member_1[1][1], -(_e511.member_1[1][1]), (_e511.member_1[1][1] < 0.0lf));
                let _e618 = select(_e616, _e612, (_e612 > _e616));
                let _e622 = select(_e511.member_1[1][2], -(_e511.member_1[1][2]), (_e511.member_1[1][2] < 0.0lf));
                let _e624 = select(_e622, _e618, (_e618 > _e622));
                let _e628 = (select(_e624, _e606, (_e606 > _e624)) + _e511.member_3);
                let _e634 = select(_e511.member_2[0][0], -(_e511.member_2[0][0]), (_e511.member_2[0][0] < 0.0lf));
                let _e638 = select(_e511.member_2[0][1], -(_e511.member_2[0][1]), (_e511.member_2[0][1] < 0.0lf));
                let _e640 = select(_e638, _e634, (_e634 > _e638));
                let _e644 = select(_e511.member_2[0][2], -(_e511.member_2[0][2]), (_e511.member_2[0][2] < 0.0lf));
                let _e646 = select(_e644, _e640, (_e640 > _e644));
                let _e652 = select(_e511.member_2[1][0], -(_e511.member_2[1][0]), (_e511.member_2[1][0] < 0.0lf));
                let _e656 = select(_e511.member_2[1][1], -(_e511.member_2[1][1]), (_e511.member_2[1][1] < 0.0lf));
                let _e658 = select(_e656, _e652, (_e652 > _e656));
                let _e662 = select(_e511.member_2[1][2], -(_e511.member_2[1][2]), (_e511.member_2[1][2] < 0.0lf));
                let _e664 = select(_e662, _e658, (_e658 > _e662));
                let _e668 = (select(_e664, _e646, (_e646 > _e664)) + _e511.member_3);
                let _e670 = select(_e628, _e588, (_e588 > _e628));
                let _e672 = select(_e668, _e670, (_e670 > _e668));
                if (_e672 <= f64(65536f)) {
                    phi_1224_ = (_e672 >= f64((1f / 65536f)));
                } else {
                    phi_1224_ = false;
                }
                let _e679 = phi_1224_;
                if _e679 {
                    phi_1324_ = type_42();
                    phi_1325_ = true;
                } else {
                    if (_e672 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e672) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e686 = (9214364837600034816lu - (bitcast<u64>(_e672) & 9218868437227405312lu));
                            let _e689 = bitcast<f64>(select(4503599627370496lu, _e686, (_e686 > 4503599627370496lu)));
                            let _e690 = (_e548 * _e689);
                            phi_1320_ = type_42(type_32(array<array<f64, 3>, 2>(array<f64, 3>((_e511.member[0][0] * _e689), (_e511.member[0][1] * _e689), (_e511.member[0][2] * _e689)), array<f64, 3>((_e511.member[1][0] * _e689), (_e511.member[1][1] * _e689), (_e511.member[1][2] * _e689))), array<array<f64, 3>, 2>(array<f64, 3>((_e511.member_1[0][0] * _e689), (_e511.member_1[0][1] * _e689), (_e511.member_1[0][2] * _e689)), array<f64, 3>((_e511.member_1[1][0] * _e689), (_e511.member_1[1][1] * _e689), (_e511.member_1[1][2] * _e689))), array<array<f64, 3>, 2>(array<f64, 3>((_e511.member_2[0][0] * _e689), (_e511.member_2[0][1] * _e689), (_e511.member_2[0][2] * _e689)), array<f64, 3>((_e511.member_2[1][0] * _e689), (_e511.member_2[1][1] * _e689), (_e511.member_2[1][2] * _e689))), ((_e511.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e689)), select(_e690, select(2.2250738585072014e-308lf, _e690, (_e690 > 2.2250738585072014e-308lf)), (_e548 > f64(0f))));
                            phi_1321_ = false;
                        } else {
                            phi_1320_ = type_42();
                            phi_1321_ = true;
                        }
                        let _e761 = phi_1320_;
                        let _e763 = phi_1321_;
                        phi_1322_ = _e761;
                        phi_1323_ = _e763;
                    } else {
                        phi_1322_ = type_42();
                        phi_1323_ = true;
                    }
                    let _e765 = phi_1322_;
                    let _e767 = phi_1323_;
                    phi_1324_ = _e765;
                    phi_1325_ = _e767;
                }
                let _e769 = phi_1324_;
                let _e771 = phi_1325_;
                if _e771 {
                    phi_1330_ = type_42(_e511, _e548);
                } else {
                    phi_1330_ = _e769;
                }
                let _e774 = phi_1330_;
                local_10 = type_32(array<array<f64, 3>, 2>(array<f64, 3>(_e774.member.member[0][0], _e774.member.member[0][1], _e774.member.member[0][2]), array<f64, 3>(_e774.member.member[1][0], _e774.member.member[1][1], _e774.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e774.member.member_1[0][0], _e774.member.member_1[0][1], _e774.member.member_1[0][2]), array<f64, 3>(_e774.member.member_1[1][0], _e774.member.member_1[1][1], _e774.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e774.member.member_2[0][0], _e774.member.member_2[0][1], _e774.member.member_2[0][2]), array<f64, 3>(_e774.member.member_2[1][0], _e774.member.member_2[1][1], _e774.member.member_2[1][2])), _e774.member.member_3);
                let _e814 = f64(0f);
                let _e817 = local_10.member_1[0u];
                let _e823 = local_10.member_2[0u];
                let _e829 = ((_e817[1] * _e823[2]) - (_e817[2] * _e823[1]));
                let _e832 = ((_e817[2] * _e823[0]) - (_e817[0] * _e823[2]));
                let _e835 = ((_e817[0] * _e823[1]) - (_e817[1] * _e823[0]));
                let _e838 = local_10.member_1[1u];
                let _e844 = local_10.member_2[1u];
                let _e850 = ((_e838[1] * _e844[2]) - (_e838[2] * _e844[1]));
                let _e853 = ((_e838[2] * _e844[0]) - (_e838[0] * _e844[2]));
                let _e856 = ((_e838[0] * _e844[1]) - (_e838[1] * _e844[0]));
                let _e859 = local_10.member_1[0u];
                let _e865 = local_10.member_2[1u];
                let _e880 = local_10.member_1[1u];
                let _e886 = local_10.member_2[0u];
                let _e899 = (((_e859[1] * _e865[2]) - (_e859[2] * _e865[1])) + ((_e880[1] * _e886[2]) - (_e880[2] * _e886[1])));
                let _e900 = (((_e859[2] * _e865[0]) - (_e859[0] * _e865[2])) + ((_e880[2] * _e886[0]) - (_e880[0] * _e886[2])));
                let _e901 = (((_e859[0] * _e865[1]) - (_e859[1] * _e865[0])) + ((_e880[0] * _e886[1]) - (_e880[1] * _e886[0])));
                let _e904 = local_10.member[0u];
                let _e912 = (((_e904[0] * _e829) + (_e904[1] * _e832)) + (_e904[2] * _e835));
                let _e915 = local_10.member[1u];
                let _e926 = local_10.member[0u];
                let _e935 = ((((_e915[0] * _e829) + (_e915[1] * _e832)) + (_e915[2] * _e835)) + (((_e926[0] * _e899) + (_e926[1] * _e900)) + (_e926[2] * _e901)));
                let _e938 = local_10.member[0u];
                let _e949 = local_10.member[1u];
                let _e958 = ((((_e938[0] * _e850) + (_e938[1] * _e853)) + (_e938[2] * _e856)) + (((_e949[0] * _e899) + (_e949[1] * _e900)) + (_e949[2] * _e901)));
                let _e961 = local_10.member[1u];
                let _e969 = (((_e961[0] * _e850) + (_e961[1] * _e853)) + (_e961[2] * _e856));
                let _e972 = local_10.member[0u];
                let _e978 = select(_e972[0], -(_e972[0]), (_e972[0] < 0.0lf));
                let _e981 = select(_e972[1], -(_e972[1]), (_e972[1] < 0.0lf));
                let _e983 = select(_e981, _e978, (_e978 > _e981));
                let _e986 = select(_e972[2], -(_e972[2]), (_e972[2] < 0.0lf));
                let _e988 = select(_e986, _e983, (_e983 > _e986));
                let _e991 = local_10.member[1u];
                let _e997 = select(_e991[0], -(_e991[0]), (_e991[0] < 0.0lf));
                let _e1000 = select(_e991[1], -(_e991[1]), (_e991[1] < 0.0lf));
                let _e1002 = select(_e1000, _e997, (_e997 > _e1000));
                let _e1005 = select(_e991[2], -(_e991[2]), (_e991[2] < 0.0lf));
                let _e1007 = select(_e1005, _e1002, (_e1002 > _e1005));
                let _e1011 = local_10.member_3;
                let _e1012 = (select(_e1007, _e988, (_e988 > _e1007)) + _e1011);
                let _e1015 = local_10.member_1[0u];
                let _e1021 = select(_e1015[0], -(_e1015[0]), (_e1015[0] < 0.0lf));
                let _e1024 = select(_e1015[1], -(_e1015[1]), (_e1015[1] < 0.0lf));
                let _e1026 = select(_e1024, _e1021, (_e1021 > _e1024));
                let _e1029 = select(_e1015[2], -(_e1015[2]), (_e1015[2] < 0.0lf));
                let _e1031 = select(_e1029, _e1026, (_e1026 > _e1029));
                let _e1034 = local_10.member_1[1u];
                let _e1040 = select(_e1034[0], -(_e1034[0]), (_e1034[0] < 0.0lf));
                let _e1043 = select(_e1034[1], -(_e1034[1]), (_e1034[1] < 0.0lf));
                let _e1045 = select(_e1043, _e1040, (_e1040 > _e1043));
                let _e1048 = select(_e1034[2], -(_e1034[2]), (_e1034[2] < 0.0lf));
                let _e1050 = select(_e1048, _e1045, (_e1045 > _e1048));
                let _e1054 = local_10.member_3;
                let _e1055 = (select(_e1050, _e1031, (_e1031 > _e1050)) + _e1054);
                let _e1058 = local_10.member_2[0u];
                let _e1064 = select(_e1058[0], -(_e1058[0]), (_e1058[0] < 0.0lf));
                let _e1067 = select(_e1058[1], -(_e1058[1]), (_e1058[1] < 0.0lf));
                let _e1069 = select(_e1067, _e1064, (_e1064 > _e1067));
                let _e1072 = select(_e1058[2], -(_e1058[2]), (_e1058[2] < 0.0lf));
                let _e1074 = select(_e1072, _e1069, (_e1069 > _e1072));
                let _e1077 = local_10.member_2[1u];
                let _e1083 = select(_e1077[0], -(_e1077[0]), (_e1077[0] < 0.0lf));
                let _e1086 = select(_e1077[1], -(_e1077[1]), (_e1077[1] < 0.0lf));
                let _e1088 = select(_e1086, _e1083, (_e1083 > _e1086));
                let _e1091 = select(_e1077[2], -(_e1077[2]), (_e1077[2] < 0.0lf));
                let _e1093 = select(_e1091, _e1088, (_e1088 > _e1091));
                let _e1097 = local_10.member_3;
                let _e1098 = (select(_e1093, _e1074, (_e1074 > _e1093)) + _e1097);
                let _e1099 = f64(1f);
                let _e1100 = f64(8f);
                let _e1102 = ((_e1055 * _e1100) * _e1098);
                let _e1110 = local_10.member_3;
                let _e1137 = ((select(_e829, -(_e829), (_e829 < 0.0lf)) + select(_e832, -(_e832), (_e832 < 0.0lf))) + select(_e835, -(_e835), (_e835 < 0.0lf)));
                let _e1148 = ((select(_e850, -(_e850), (_e850 < 0.0lf)) + select(_e853, -(_e853), (_e853 < 0.0lf))) + select(_e856, -(_e856), (_e856 < 0.0lf)));
                let _e1150 = select(_e1148, _e1137, (_e1137 > _e1148));
                let _e1162 = (((select(_e899, -(_e899), (_e899 < 0.0lf)) + select(_e900, -(_e900), (_e900 < 0.0lf))) + select(_e901, -(_e901), (_e901 < 0.0lf))) * f64(0.5f));
                let _e1170 = local_10.member_3;
                let _e1184 = (((((_e1012 * _e1100) * _e1102) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1110 * f64(19f)) * ((_e1012 * (_e1055 + _e1098)) + (_e1055 * _e1098)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1099 + _e1012) * ((_e1099 + _e1055) * (_e1099 + _e1098)))));
                let _e1185 = f64(3f);
                let _e1186 = (_e912 * _e1185);
                let _e1187 = (_e969 * _e1185);
                let _e1189 = select(_e1187, _e1186, (_e1186 < _e1187));
                let _e1191 = select(_e958, _e935, (_e935 < _e958));
                let _e1193 = select(_e1191, _e1189, (_e1189 < _e1191));
                let _e1195 = select(_e1187, _e1186, (_e1186 > _e1187));
                let _e1197 = select(_e958, _e935, (_e935 > _e958));
                let _e1205 = -(select(_e1197, _e1195, (_e1195 > _e1197)));
                if ((select(_e1205, _e1193, (_e1193 > _e1205)) - (_e1184 + ((_e814 * (((select(_e1162, _e1150, (_e1150 > _e1162)) + (_e1102 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1170 * f64(6f)) * (_e1055 + _e1098))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1099 + _e1055) * (_e1099 + _e1098))))) * f64((3f * 1.0001f))))) > _e814) {
                    phi_6815_ = type_43(0u, type_43().member_1);
                    phi_6816_ = type_43();
                    phi_6817_ = true;
                } else {
                    let _e1214 = select(_e912, -(_e912), (_e912 < 0.0lf));
                    let _e1217 = select(_e935, -(_e935), (_e935 < 0.0lf));
                    let _e1219 = select(_e1217, _e1214, (_e1214 > _e1217));
                    let _e1222 = select(_e958, -(_e958), (_e958 < 0.0lf));
                    let _e1225 = select(_e969, -(_e969), (_e969 < 0.0lf));
                    let _e1227 = select(_e1225, _e1222, (_e1222 > _e1225));
                    let _e1229 = select(_e1227, _e1219, (_e1219 > _e1227));
                    let _e1231 = (2.2250738585072014e-308lf * f64(67108864f));
                    let _e1232 = f64(1f);
                    if (_e1229 >= _e1231) {
                        phi_2070_ = (_e1229 <= (_e1232 / _e1231));
                    } else {
                        phi_2070_ = false;
                    }
                    let _e1237 = phi_2070_;
                    if _e1237 {
                        phi_2085_ = (_e1232 / _e1229);
                    } else {
                        phi_2085_ = f64(0f);
                    }
                    let _e1247 = phi_2085_;
                    let _e1248 = f64(0.00000000000022737368f);
                    let _e1250 = (_e520 * f64(0.0625f));
                    local_8 = type_40(array<f64, 4>(_e912, _e935, _e958, _e969), ((_e1184 * f64(0.34f)) + (_e1229 * select(f64(2f), (1.1102230246251565e-16lf * f64(256f)), _e1237))), _e1247, select(_e1250, _e1248, (_e1248 < _e1250)));
                    let _e1255 = f64(0f);
                    let _e1256 = f64(1f);
                    let _e1257 = f64(3f);
                    let _e1260 = local_8.member[0u];
                    let _e1263 = local_8.member[1u];
                    let _e1266 = local_8.member[2u];
                    let _e1269 = local_8.member[3u];
                    let _e1276 = local_8.member_2;
                    let _e1277 = ((_e1263 - (_e1257 * _e1260)) * _e1276);
                    let _e1279 = local_8.member_2;
                    let _e1280 = ((_e1266 - _e1263) * _e1279);
                    let _e1282 = local_8.member_2;
                    let _e1283 = (((_e1257 * _e1269) - _e1266) * _e1282);
                    local_6[0u] = _e1255;
                    local_6[1u] = _e1256;
                    local_6[2u] = _e1256;
                    local_6[3u] = _e1256;
                    let _e1290 = ((_e1280 * _e1280) - (_e1277 * _e1283));
                    if (_e1290 > _e1255) {
                        if (_e1290 <= 2.2250738585072014e-308lf) {
                            phi_2218_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1290 > 0.0lf));
                        } else {
                            phi_2161_ = type_18(0i, 5i);
                            phi_2164_ = bitcast<f64>(((bitcast<u64>(_e1290) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1298 = phi_2161_;
                                let _e1300 = phi_2164_;
                                local_11 = _e1300;
                                if (_e1298.member < _e1298.member_1) {
                                    let _e1307 = (_e1298.member + 1i);
                                    phi_2162_ = type_18(select(_e1307, type_19().member_1, select(false, true, ((false == (_e1307 > _e1298.member)) != false))), _e1298.member_1);
                                    phi_2205_ = type_19(1u, _e1298.member);
                                } else {
                                    phi_2162_ = _e1298;
                                    phi_2205_ = type_19(0u, type_19().member_1);
                                }
                                let _e1318 = phi_2162_;
                                let _e1320 = phi_2205_;
                                let _e1323 = (bitcast<i32>(_e1320.member) != 0i);
                                if _e1323 {
                                    phi_2165_ = (0.5lf * (_e1300 + (_e1290 / _e1300)));
                                } else {
                                    phi_2165_ = f64();
                                }
                                let _e1328 = phi_2165_;
                                continue;
                                continuing {
                                    phi_2161_ = _e1318;
                                    phi_2164_ = _e1328;
                                    break if !(_e1323);
                                }
                            }
                            let _e1333 = local_11;
                            phi_2218_ = (_e1333 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1339 = phi_2218_;
                        let _e1344 = -((_e1280 + select(_e1339, -(_e1339), (_e1280 < _e1255))));
                        local_7[0u] = (_e1344 / (_e1344 + _e1283));
                        local_7[1u] = (_e1277 / (_e1277 + _e1344));
                        let _e1353 = local_7[1u];
                        let _e1354 = local_7[0u];
                        if (_e1353 < _e1354) {
                            let _e1357 = local_7[1u];
                            let _e1359 = local_7[0u];
                            local_7[0u] = _e1357;
                            local_7[1u] = _e1359;
                        }
                        phi_2249_ = type_9(0u, 2u);
                        phi_2252_ = 1u;
                        loop {
                            let _e1363 = phi_2249_;
                            let _e1365 = phi_2252_;
                            local_47 = _e1365;
                            let _e1368 = (_e1363.member < _e1363.member_1);
                            let _e1379 = select(type_9().member_1, _e1363.member, _e1368);
                            let _e1381 = (bitcast<i32>(select(0u, 1u, _e1368)) != 0i);
                            if _e1381 {
                                let _e1383 = local_7[_e1379];
                                if (_e1383 > _e1255) {
                                    let _e1386 = local_7[_e1379];
                                    if (_e1386 < _e1256) {
                                        let _e1389 = local_7[_e1379];
                                        local_6[_e1365] = _e1389;
                                        phi_2319_ = (_e1365 + 1u);
                                    } else {
                                        phi_2319_ = _e1365;
                                    }
                                    let _e1393 = phi_2319_;
                                    phi_2320_ = _e1393;
                                } else {
                                    phi_2320_ = _e1365;
                                }
                                let _e1395 = phi_2320_;
                                phi_2253_ = _e1395;
                            } else {
                                phi_2253_ = u32();
                            }
                            let _e1397 = phi_2253_;
                            continue;
                            continuing {
                                phi_2249_ = type_9(select(_e1363.member, (_e1363.member + 1u), _e1368), select(_e1363.member_1, _e1363.member_1, _e1368));
                                phi_2252_ = _e1397;
                                break if !(_e1381);
                            }
                        }
                        let _e4502 = local_47;
                        phi_2321_ = _e4502;
                    } else {
                        phi_2321_ = 1u;
                    }
                    let _e1400 = phi_2321_;
                    local_6[_e1400] = _e1256;
                    let _e1402 = local_6;
                    local_9 = _e1402;
                    let _e1404 = (_e520 * f64(0.99f));
                    let _e1406 = (f64(1f) - _e529);
                    let _e1409 = local_8.member[0u];
                    let _e1412 = local_8.member[1u];
                    let _e1415 = local_8.member[2u];
                    let _e1418 = local_8.member[3u];
                    let _e1429 = ((((_e1409 * _e1406) + (_e1412 * _e529)) * (_e1406 * _e1406)) + (((_e1415 * _e1406) + (_e1418 * _e529)) * (_e529 * _e529)));
                    let _e1434 = local_8.member_1;
                    phi_2379_ = type_9(select(1u, 0u, !((select(_e1429, -(_e1429), (_e1429 < 0.0lf)) > _e1434))), (_e1400 + 1u));
                    loop {
                        let _e1441 = phi_2379_;
                        let _e1444 = (_e1441.member < _e1441.member_1);
                        let _e1455 = select(type_9().member_1, _e1441.member, _e1444);
                        if (bitcast<i32>(select(0u, 1u, _e1444)) != 0i) {
                            if (_e1455 > 0u) {
                                let _e1462 = local_9[(_e1455 - 1u)];
                                let _e1464 = select(_e529, _e1462, (_e1462 > _e529));
                                let _e1466 = local_9[_e1455];
                                let _e1468 = select(_e538, _e1466, (_e1466 < _e538));
                                if (_e1464 <= _e1468) {
                                    let _e1470 = function_5((&local_8), _e547, _e1464, _e1468);
                                    if _e1470 {
                                        phi_3971_ = type_44();
                                        phi_3972_ = bool();
                                        phi_3973_ = type_44();
                                        phi_3974_ = false;
                                        phi_3975_ = false;
                                        phi_3976_ = false;
                                        phi_3977_ = false;
                                    } else {
                                        let _e1472 = (f64(1f) - _e1464);
                                        let _e1475 = local_8.member[0u];
                                        let _e1478 = local_8.member[1u];
                                        let _e1481 = local_8.member[2u];
                                        let _e1484 = local_8.member[3u];
                                        let _e1495 = ((((_e1475 * _e1472) + (_e1478 * _e1464)) * (_e1472 * _e1472)) + (((_e1481 * _e1472) + (_e1484 * _e1464)) * (_e1464 * _e1464)));
                                        let _e1497 = (f64(1f) - _e1468);
                                        let _e1500 = local_8.member[0u];
                                        let _e1503 = local_8.member[1u];
                                        let _e1506 = local_8.member[2u];
                                        let _e1509 = local_8.member[3u];
                                        let _e1520 = ((((_e1500 * _e1497) + (_e1503 * _e1468)) * (_e1497 * _e1497)) + (((_e1506 * _e1497) + (_e1509 * _e1468)) * (_e1468 * _e1468)));
                                        let _e1525 = local_8.member_1;
                                        let _e1526 = (select(_e1495, -(_e1495), (_e1495 < 0.0lf)) > _e1525);
                                        let _e1531 = local_8.member_1;
                                        let _e1532 = (select(_e1520, -(_e1520), (_e1520 < 0.0lf)) > _e1531);
                                        let _e1533 = f64(0f);
                                        let _e1541 = select(select(bool(), select(bool(), ((_e1495 > _e1533) != (_e1520 > _e1533)), _e1532), _e1526), false, select(true, select(true, false, _e1532), _e1526));
                                        if _e1526 {
                                            if _e1532 {
                                                phi_2539_ = type_44(select(f64(1f), type_44().member, _e1541), select(_e1533, type_44().member_1, _e1541), select(_e1541, type_44().member_2, _e1541));
                                                phi_2540_ = _e1541;
                                            } else {
                                                phi_2539_ = type_44();
                                                phi_2540_ = true;
                                            }
                                            let _e1551 = phi_2539_;
                                            let _e1553 = phi_2540_;
                                            phi_2541_ = _e1551;
                                            phi_2542_ = _e1553;
                                        } else {
                                            phi_2541_ = type_44();
                                            phi_2542_ = true;
                                        }
                                        let _e1555 = phi_2541_;
                                        let _e1557 = phi_2542_;
                                        if _e1557 {
                                            if _e1526 {
                                                let _e1561 = select(f64(1f), f64(-1f), (_e1495 < _e1533));
                                                let _e1563 = local_8.member_3;
                                                let _e1564 = f64(0.5f);
                                                let _e1565 = f64(3f);
                                                let _e1568 = local_8.member[0u];
                                                let _e1571 = local_8.member[1u];
                                                let _e1574 = local_8.member[2u];
                                                let _e1577 = local_8.member[3u];
                                                let _e1580 = (_e1574 - _e1571);
                                                phi_2577_ = type_9(0u, 64u);
                                                phi_2580_ = _e1468;
                                                phi_2582_ = _e1464;
                                                phi_2584_ = (_e1564 * (_e1464 + _e1468));
                                                loop {
                                                    let _e1586 = phi_2577_;
                                                    let _e1588 = phi_2580_;
                                                    let _e1590 = phi_2582_;
                                                    let _e1592 = phi_2584_;
                                                    local_14 = _e1590;
                                                    let _e1595 = (_e1586.member < _e1586.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1595)) != 0i) {
                                                        let _e1608 = (f64(1f) - _e1592);
                                                        let _e1611 = local_8.member[0u];
                                                        let _e1614 = local_8.member[1u];
                                                        let _e1617 = local_8.member[2u];
                                                        let _e1620 = local_8.member[3u];
                                                        let _e1634 = local_8.member_1;
                                                        let _e1635 = ((_e1561 * ((((_e1611 * _e1608) + (_e1614 * _e1592)) * (_e1608 * _e1608)) + (((_e1617 * _e1608) + (_e1620 * _e1592)) * (_e1592 * _e1592)))) - _e1634);
                                                        let _e1637 = (_e1635 > f64(0f));
                                                        let _e1638 = select(_e1592, _e1588, _e1637);
                                                        let _e1639 = select(_e1590, _e1592, _e1637);
                                                        let _e1641 = ((_e1638 - _e1639) > _e1563);
                                                        if _e1641 {
                                                            let _e1643 = (f64(1f) - _e1592);
                                                            let _e1655 = (-(_e1635) / (_e1561 * (((((_e1571 - (_e1565 * _e1568)) * _e1643) + (_e1580 * _e1592)) * _e1643) + (((_e1580 * _e1643) + (((_e1565 * _e1577) - _e1574) * _e1592)) * _e1592))));
                                                            let _e1663 = ((_e1592 + _e1655) + select(-((_e1564 * _e1563)), (_e1564 * _e1563), (_e1635 > f64(0f))));
                                                            if (_e1663 > _e1639) {
                                                                phi_2698_ = select(true, select(true, false, (select(_e1655, -(_e1655), (_e1655 < 0.0lf)) < (_e1564 * (_e1638 - _e1639)))), (_e1663 < _e1638));
                                                            } else {
                                                                phi_2698_ = true;
                                                            }
                                                            let _e1675 = phi_2698_;
                                                            phi_2705_ = select(_e1663, (_e1564 * (_e1639 + _e1638)), _e1675);
                                                            phi_2706_ = false;
                                                        } else {
                                                            phi_2705_ = f64();
                                                            phi_2706_ = true;
                                                        }
                                                        let _e1680 = phi_2705_;
                                                        let _e1682 = phi_2706_;
                                                        phi_2581_ = _e1638;
                                                        phi_2583_ = _e1639;
                                                        phi_2585_ = _e1680;
                                                        phi_2707_ = _e1639;
                                                        phi_2708_ = _e1641;
                                                        phi_2709_ = _e1682;
                                                    } else {
                                                        phi_2581_ = f64();
                                                        phi_2583_ = f64();
                                                        phi_2585_ = f64();
                                                        phi_2707_ = f64();
                                                        phi_2708_ = false;
                                                        phi_2709_ = false;
                                                    }
                                                    let _e1684 = phi_2581_;
                                                    let _e1686 = phi_2583_;
                                                    let _e1688 = phi_2585_;
                                                    let _e1690 = phi_2707_;
                                                    let _e1692 = phi_2708_;
                                                    let _e1694 = phi_2709_;
                                                    local_12 = _e1694;
                                                    local_13 = _e1690;
                                                    continue;
                                                    continuing {
                                                        phi_2577_ = type_9(select(_e1586.member, (_e1586.member + 1u), _e1595), select(_e1586.member_1, _e1586.member_1, _e1595));
                                                        phi_2580_ = _e1684;
                                                        phi_2582_ = _e1686;
                                                        phi_2584_ = _e1688;
                                                        break if !(_e1692);
                                                    }
                                                }
                                                let _e1697 = local_12;
                                                let _e1699 = local_13;
                                                let _e1701 = local_14;
                                                phi_2714_ = select(_e1701, _e1699, _e1697);
                                            } else {
                                                phi_2714_ = _e1464;
                                            }
                                            let _e1704 = phi_2714_;
                                            if _e1532 {
                                                let _e1710 = local_8.member_3;
                                                let _e1712 = local_8.member_3;
                                                phi_2732_ = type_9(0u, 64u);
                                                phi_2735_ = (_e1710 + _e1712);
                                                loop {
                                                    let _e1715 = phi_2732_;
                                                    let _e1717 = phi_2735_;
                                                    let _e1720 = (_e1715.member < _e1715.member_1);
                                                    if (bitcast<i32>(select(0u, 1u, _e1720)) != 0i) {
                                                        let _e1732 = (_e1704 + _e1717);
                                                        if (_e1732 < _e1468) {
                                                            let _e1735 = (f64(1f) - _e1732);
                                                            let _e1738 = local_8.member[0u];
                                                            let _e1741 = local_8.member[1u];
                                                            let _e1744 = local_8.member[2u];
                                                            let _e1747 = local_8.member[3u];
                                                            let _e1761 = local_8.member_1;
                                                            let _e1762 = ((select(f64(1f), f64(-1f), (_e1520 < _e1533)) * ((((_e1738 * _e1735) + (_e1741 * _e1732)) * (_e1735 * _e1735)) + (((_e1744 * _e1735) + (_e1747 * _e1732)) * (_e1732 * _e1732)))) > _e1761);
                                                            phi_2801_ = select((_e1717 + _e1717), f64(), _e1762);
                                                            phi_2802_ = select(true, false, _e1762);
                                                            phi_2803_ = _e1762;
                                                            phi_2804_ = false;
                                                        } else {
                                                            phi_2801_ = f64();
                                                            phi_2802_ = false;
                                                            phi_2803_ = false;
                                                            phi_2804_ = true;
                                                        }
                                                        let _e1767 = phi_2801_;
                                                        let _e1769 = phi_2802_;
                                                        let _e1771 = phi_2803_;
                                                        let _e1773 = phi_2804_;
                                                        phi_2805_ = _e1732;
                                                        phi_2736_ = _e1767;
                                                        phi_2806_ = _e1769;
                                                        phi_2807_ = _e1771;
                                                        phi_2808_ = _e1773;
                                                        phi_2809_ = false;
                                                    } else {
                                                        phi_2805_ = f64();
                                                        phi_2736_ = f64();
                                                        phi_2806_ = false;
                                                        phi_2807_ = false;
                                                        phi_2808_ = false;
                                                        phi_2809_ = true;
                                                    }
                                                    let _e1775 = phi_2805_;
                                                    let _e1777 = phi_2736_;
                                                    let _e1779 = phi_2806_;
                                                    let _e1781 = phi_2807_;
                                                    let _e1783 = phi_2808_;
                                                    let _e1785 = phi_2809_;
                                                    local_15 = _e1781;
                                                    local_16 = _e1783;
                                                    local_17 = _e1781;
                                                    local_18 = _e1785;
                                                    local_19 = _e1775;
                                                    continue;
                                                    continuing {
                                                        phi_2732_ = type_9(select(_e1715.member, (_e1715.member + 1u), _e1720), select(_e1715.member_1, _e1715.member_1, _e1720));
                                                        phi_2735_ = _e1777;
                                                        break if !(_e1779);
                                                    }
                                                }
                                                let _e1788 = local_15;
                                                let _e1790 = local_16;
                                                let _e1793 = local_17;
                                                let _e1795 = local_18;
                                                let _e1799 = local_19;
                                                phi_2823_ = select(_e1799, _e1468, select(select(_e1795, false, _e1793), true, select(_e1790, false, _e1788)));
                                            } else {
                                                phi_2823_ = _e1468;
                                            }
                                            let _e1802 = phi_2823_;
                                            phi_2825_ = type_44(_e1704, _e1802, _e1541);
                                        } else {
                                            phi_2825_ = _e1555;
                                        }
                                        let _e1805 = phi_2825_;
                                        if (_e1805.member > _e1805.member_1) {
                                            phi_3966_ = bool();
                                            phi_3967_ = true;
                                            phi_3968_ = false;
                                            phi_3969_ = false;
                                            phi_3970_ = false;
                                        } else {
                                            let _e1810 = (_e1805.member > _e547);
                                            if _e1810 {
                                                phi_3962_ = bool();
                                                phi_3963_ = false;
                                                phi_3964_ = false;
                                                phi_3965_ = false;
                                            } else {
                                                let _e1815 = ((_e1805.member_1 - _e1805.member) * f64(0.5f));
                                                let _e1816 = (_e1805.member + _e1815);
                                                let _e1819 = (_e1815 + (1.1102230246251565e-16lf * f64(4f)));
                                                let _e1821 = local_10.member_3;
                                                let _e1824 = local_10.member[0u];
                                                let _e1830 = select(_e1824[0], -(_e1824[0]), (_e1824[0] < 0.0lf));
                                                let _e1833 = select(_e1824[1], -(_e1824[1]), (_e1824[1] < 0.0lf));
                                                let _e1835 = select(_e1833, _e1830, (_e1830 > _e1833));
                                                let _e1838 = select(_e1824[2], -(_e1824[2]), (_e1824[2] < 0.0lf));
                                                let _e1840 = select(_e1838, _e1835, (_e1835 > _e1838));
                                                let _e1842 = local_10.member[1u];
                                                let _e1848 = select(_e1842[0], -(_e1842[0]), (_e1842[0] < 0.0lf));
                                                let _e1851 = select(_e1842[1], -(_e1842[1]), (_e1842[1] < 0.0lf));
                                                let _e1853 = select(_e1851, _e1848, (_e1848 > _e1851));
                                                let _e1856 = select(_e1842[2], -(_e1842[2]), (_e1842[2] < 0.0lf));
                                                let _e1858 = select(_e1856, _e1853, (_e1853 > _e1856));
                                                let _e1863 = local_10.member[0u];
                                                let _e1868 = local_10.member[1u];
                                                let _e1878 = (_e1863[0] + ((_e1868[0] - _e1863[0]) * _e1816));
                                                let _e1879 = (_e1863[1] + ((_e1868[1] - _e1863[1]) * _e1816));
                                                let _e1880 = (_e1863[2] + ((_e1868[2] - _e1863[2]) * _e1816));
                                                let _e1882 = local_10.member[1u];
                                                let _e1887 = local_10.member[0u];
                                                let _e1891 = (_e1882[0] - _e1887[0]);
                                                let _e1892 = (_e1882[1] - _e1887[1]);
                                                let _e1893 = (_e1882[2] - _e1887[2]);
                                                let _e1896 = select(_e1891, -(_e1891), (_e1891 < 0.0lf));
                                                let _e1899 = select(_e1892, -(_e1892), (_e1892 < 0.0lf));
                                                let _e1901 = select(_e1899, _e1896, (_e1896 > _e1899));
                                                let _e1904 = select(_e1893, -(_e1893), (_e1893 < 0.0lf));
                                                let _e1914 = ((((_e1819 * select(_e1904, _e1901, (_e1901 > _e1904))) * f64(1.01f)) + ((select(_e1858, _e1840, (_e1840 > _e1858)) + _e1821) * (1.1102230246251565e-16lf * f64(8f)))) + _e1821);
                                                let _e1917 = select(_e1878, -(_e1878), (_e1878 < 0.0lf));
                                                let _e1920 = select(_e1879, -(_e1879), (_e1879 < 0.0lf));
                                                let _e1922 = select(_e1920, _e1917, (_e1917 > _e1920));
                                                let _e1925 = select(_e1880, -(_e1880), (_e1880 < 0.0lf));
                                                local_2 = type_36(array<f64, 3>(_e1878, _e1879, _e1880), _e1914, (select(_e1925, _e1922, (_e1922 > _e1925)) + _e1914));
                                                let _e1933 = local_10.member_3;
                                                let _e1935 = local_10.member_1[0u];
                                                let _e1941 = select(_e1935[0], -(_e1935[0]), (_e1935[0] < 0.0lf));
                                                let _e1944 = select(_e1935[1], -(_e1935[1]), (_e1935[1] < 0.0lf));
                                                let _e1946 = select(_e1944, _e1941, (_e1941 > _e1944));
                                                let _e1949 = select(_e1935[2], -(_e1935[2]), (_e1935[2] < 0.0lf));
                                                let _e1951 = select(_e1949, _e1946, (_e1946 > _e1949));
                                                let _e1953 = local_10.member_1[1u];
                                                let _e1959 = select(_e1953[0], -(_e1953[0]), (_e1953[0] < 0.0lf));
                                                let _e1962 = select(_e1953[1], -(_e1953[1]), (_e1953[1] < 0.0lf));
                                                let _e1964 = select(_e1962, _e1959, (_e1959 > _e1962));
                                                let _e1967 = select(_e1953[2], -(_e1953[2]), (_e1953[2] < 0.0lf));
                                                let _e1969 = select(_e1967, _e1964, (_e1964 > _e1967));
                                                let _e1974 = local_10.member_1[0u];
                                                let _e1979 = local_10.member_1[1u];
                                                let _e1989 = (_e1974[0] + ((_e1979[0] - _e1974[0]) * _e1816));
                                                let _e1990 = (_e1974[1] + ((_e1979[1] - _e1974[1]) * _e1816));
                                                let _e1991 = (_e1974[2] + ((_e1979[2] - _e1974[2]) * _e1816));
                                                let _e1993 = local_10.member_1[1u];
                                                let _e1998 = local_10.member_1[0u];
                                                let _e2002 = (_e1993[0] - _e1998[0]);
                                                let _e2003 = (_e1993[1] - _e1998[1]);
                                                let _e2004 = (_e1993[2] - _e1998[2]);
                                                let _e2007 = select(_e2002, -(_e2002), (_e2002 < 0.0lf));
                                                let _e2010 = select(_e2003, -(_e2003), (_e2003 < 0.0lf));
                                                let _e2012 = select(_e2010, _e2007, (_e2007 > _e2010));
                                                let _e2015 = select(_e2004, -(_e2004), (_e2004 < 0.0lf));
                                                let _e2025 = ((((_e1819 * select(_e2015, _e2012, (_e2012 > _e2015))) * f64(1.01f)) + ((select(_e1969, _e1951, (_e1951 > _e1969)) + _e1933) * (1.1102230246251565e-16lf * f64(8f)))) + _e1933);
                                                let _e2028 = select(_e1989, -(_e1989), (_e1989 < 0.0lf));
                                                let _e2031 = select(_e1990, -(_e1990), (_e1990 < 0.0lf));
                                                let _e2033 = select(_e2031, _e2028, (_e2028 > _e2031));
                                                let _e2036 = select(_e1991, -(_e1991), (_e1991 < 0.0lf));
                                                local_3 = type_36(array<f64, 3>(_e1989, _e1990, _e1991), _e2025, (select(_e2036, _e2033, (_e2033 > _e2036)) + _e2025));
                                                let _e2044 = local_10.member_3;
                                                let _e2046 = local_10.member_2[0u];
                                                let _e2052 = select(_e2046[0], -(_e2046[0]), (_e2046[0] < 0.0lf));
                                                let _e2055 = select(_e2046[1], -(_e2046[1]), (_e2046[1] < 0.0lf));
                                                let _e2057 = select(_e2055, _e2052, (_e2052 > _e2055));
                                                let _e2060 = select(_e2046[2], -(_e2046[2]), (_e2046[2] < 0.0lf));
                                                let _e2062 = select(_e2060, _e2057, (_e2057 > _e2060));
                                                let _e2064 = local_10.member_2[1u];
                                                let _e2070 = select(_e2064[0], -(_e2064[0]), (_e2064[0] < 0.0lf));
                                                let _e2073 = select(_e2064[1], -(_e2064[1]), (_e2064[1] < 0.0lf));
                                                let _e2075 = select(_e2073, _e2070, (_e2070 > _e2073));
                                                let _e2078 = select(_e2064[2], -(_e2064[2]), (_e2064[2] < 0.0lf));
                                                let _e2080 = select(_e2078, _e2075, (_e2075 > _e2078));
                                                let _e2085 = local_10.member_2[0u];
                                                let _e2090 = local_10.member_2[1u];
                                                let _e2100 = (_e2085[0] + ((_e2090[0] - _e2085[0]) * _e1816));
                                                let _e2101 = (_e2085[1] + ((_e2090[1] - _e2085[1]) * _e1816));
                                                let _e2102 = (_e2085[2] + ((_e2090[2] - _e2085[2]) * _e1816));
                                                let _e2104 = local_10.member_2[1u];
                                                let _e2109 = local_10.member_2[0u];
                                                let _e2113 = (_e2104[0] - _e2109[0]);
                                                let _e2114 = (_e2104[1] - _e2109[1]);
                                                let _e2115 = (_e2104[2] - _e2109[2]);
                                                let _e2118 = select(_e2113, -(_e2113), (_e2113 < 0.0lf));
                                                let _e2121 = select(_e2114, -(_e2114), (_e2114 < 0.0lf));
                                                let _e2123 = select(_e2121, _e2118, (_e2118 > _e2121));
                                                let _e2126 = select(_e2115, -(_e2115), (_e2115 < 0.0lf));
                                                let _e2136 = ((((_e1819 * select(_e2126, _e2123, (_e2123 > _e2126))) * f64(1.01f)) + ((select(_e2080, _e2062, (_e2062 > _e2080)) + _e2044) * (1.1102230246251565e-16lf * f64(8f)))) + _e2044);
                                                let _e2139 = select(_e2100, -(_e2100), (_e2100 < 0.0lf));
                                                let _e2142 = select(_e2101, -(_e2101), (_e2101 < 0.0lf));
                                                let _e2144 = select(_e2142, _e2139, (_e2139 > _e2142));
                                                let _e2147 = select(_e2102, -(_e2102), (_e2102 < 0.0lf));
                                                local_4 = type_36(array<f64, 3>(_e2100, _e2101, _e2102), _e2136, (select(_e2147, _e2144, (_e2144 > _e2147)) + _e2136));
                                                let _e2154 = local_3.member;
                                                let _e2159 = local_4.member;
                                                let _e2165 = ((_e2154[1] * _e2159[2]) - (_e2154[2] * _e2159[1]));
                                                let _e2168 = ((_e2154[2] * _e2159[0]) - (_e2154[0] * _e2159[2]));
                                                let _e2171 = ((_e2154[0] * _e2159[1]) - (_e2154[1] * _e2159[0]));
                                                if (select(_e2165, -(_e2165), (_e2165 < 0.0lf)) > select(_e2168, -(_e2168), (_e2168 < 0.0lf))) {
                                                    let _e2194 = (select(_e2165, -(_e2165), (_e2165 < 0.0lf)) > select(_e2171, -(_e2171), (_e2171 < 0.0lf)));
                                                    phi_3558_ = select(1u, 2u, _e2194);
                                                    phi_3559_ = select(0u, 1u, _e2194);
                                                } else {
                                                    let _e2185 = (select(_e2168, -(_e2168), (_e2168 < 0.0lf)) > select(_e2171, -(_e2171), (_e2171 < 0.0lf)));
                                                    phi_3558_ = select(1u, 0u, _e2185);
                                                    phi_3559_ = select(0u, 2u, _e2185);
                                                }
                                                let _e2198 = phi_3558_;
                                                let _e2200 = phi_3559_;
                                                let _e2203 = local_3.member[_e2200];
                                                let _e2206 = local_4.member[_e2198];
                                                let _e2210 = local_3.member[_e2198];
                                                let _e2213 = local_4.member[_e2200];
                                                let _e2215 = ((_e2203 * _e2206) - (_e2210 * _e2213));
                                                let _e2216 = f64(1f);
                                                let _e2217 = f64(2f);
                                                let _e2219 = local_3.member_1;
                                                let _e2221 = local_4.member_2;
                                                let _e2224 = local_3.member_2;
                                                let _e2226 = local_4.member_1;
                                                let _e2232 = local_3.member_2;
                                                let _e2235 = local_4.member_2;
                                                let _e2244 = local_3.member_2;
                                                let _e2247 = local_4.member_2;
                                                let _e2251 = (((((_e2219 * _e2221) + (_e2224 * _e2226)) * f64(2.01f)) + (((_e2232 * _e2217) * (_e2235 * _e2217)) * (1.1102230246251565e-16lf * _e2217))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2216 + _e2244) * (_e2216 + _e2247))));
                                                if (select(_e2215, -(_e2215), (_e2215 < 0.0lf)) > _e2251) {
                                                    let _e2260 = select(f64(1f), f64(-1f), (_e2215 < f64(0f)));
                                                    let _e2263 = local_2.member[_e2200];
                                                    let _e2266 = local_4.member[_e2198];
                                                    let _e2270 = local_2.member[_e2198];
                                                    let _e2273 = local_4.member[_e2200];
                                                    let _e2276 = f64(1f);
                                                    let _e2277 = f64(2f);
                                                    let _e2279 = local_2.member_1;
                                                    let _e2281 = local_4.member_2;
                                                    let _e2284 = local_2.member_2;
                                                    let _e2286 = local_4.member_1;
                                                    let _e2292 = local_2.member_2;
                                                    let _e2295 = local_4.member_2;
                                                    let _e2304 = local_2.member_2;
                                                    let _e2307 = local_4.member_2;
                                                    let _e2311 = (((((_e2279 * _e2281) + (_e2284 * _e2286)) * f64(2.01f)) + (((_e2292 * _e2277) * (_e2295 * _e2277)) * (1.1102230246251565e-16lf * _e2277))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2276 + _e2304) * (_e2276 + _e2307))));
                                                    let _e2314 = local_3.member[_e2200];
                                                    let _e2317 = local_2.member[_e2198];
                                                    let _e2321 = local_3.member[_e2198];
                                                    let _e2324 = local_2.member[_e2200];
                                                    let _e2327 = f64(1f);
                                                    let _e2328 = f64(2f);
                                                    let _e2330 = local_3.member_1;
                                                    let _e2332 = local_2.member_2;
                                                    let _e2335 = local_3.member_2;
                                                    let _e2337 = local_2.member_1;
                                                    let _e2343 = local_3.member_2;
                                                    let _e2346 = local_2.member_2;
                                                    let _e2355 = local_3.member_2;
                                                    let _e2358 = local_2.member_2;
                                                    let _e2362 = (((((_e2330 * _e2332) + (_e2335 * _e2337)) * f64(2.01f)) + (((_e2343 * _e2328) * (_e2346 * _e2328)) * (1.1102230246251565e-16lf * _e2328))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2327 + _e2355) * (_e2327 + _e2358))));
                                                    let _e2363 = (_e2215 * _e2260);
                                                    let _e2364 = (((_e2263 * _e2266) - (_e2270 * _e2273)) * _e2260);
                                                    let _e2365 = (((_e2314 * _e2317) - (_e2321 * _e2324)) * _e2260);
                                                    let _e2379 = (((select(_e2363, -(_e2363), (_e2363 < 0.0lf)) + select(_e2364, -(_e2364), (_e2364 < 0.0lf))) + select(_e2365, -(_e2365), (_e2365 < 0.0lf))) * (1.1102230246251565e-16lf * f64(4f)));
                                                    if (_e226.member != 0u) {
                                                        phi_3836_ = array<type_37, 4>(type_37(_e2364, _e2311), type_37(_e2365, _e2362), type_37((_e2363 - _e2364), ((_e2251 + _e2311) + _e2379)), type_37((_e2363 - _e2365), ((_e2251 + _e2362) + _e2379)));
                                                    } else {
                                                        let _e2382 = ((_e2363 - _e2364) - _e2365);
                                                        let _e2385 = (((_e2251 + _e2311) + _e2362) + _e2379);
                                                        phi_3836_ = array<type_37, 4>(type_37(_e2364, _e2311), type_37(_e2365, _e2362), type_37(_e2382, _e2385), type_37(_e2382, _e2385));
                                                    }
                                                    let _e2403 = phi_3836_;
                                                    local_5 = array<type_37, 4>(type_37(_e2403[0].member, _e2403[0].member_1), type_37(_e2403[1].member, _e2403[1].member_1), type_37(_e2403[2].member, _e2403[2].member_1), type_37(_e2403[3].member, _e2403[3].member_1));
                                                    phi_3856_ = type_9(0u, 4u);
                                                    phi_3859_ = true;
                                                    loop {
                                                        let _e2422 = phi_3856_;
                                                        let _e2424 = phi_3859_;
                                                        local_21 = _e2424;
                                                        let _e2427 = (_e2422.member < _e2422.member_1);
                                                        let _e2438 = select(type_9().member_1, _e2422.member, _e2427);
                                                        if (bitcast<i32>(select(0u, 1u, _e2427)) != 0i) {
                                                            let _e2443 = local_5[_e2438].member;
                                                            let _e2446 = local_5[_e2438].member_1;
                                                            let _e2448 = (_e2443 < -(_e2446));
                                                            phi_3860_ = select((_e2424 && (_e2443 > _e2446)), bool(), _e2448);
                                                            phi_3911_ = select(true, false, _e2448);
                                                            phi_3912_ = _e2448;
                                                        } else {
                                                            phi_3860_ = bool();
                                                            phi_3911_ = false;
                                                            phi_3912_ = false;
                                                        }
                                                        let _e2454 = phi_3860_;
                                                        let _e2456 = phi_3911_;
                                                        let _e2458 = phi_3912_;
                                                        local_20 = _e2458;
                                                        continue;
                                                        continuing {
                                                            phi_3856_ = type_9(select(_e2422.member, (_e2422.member + 1u), _e2427), select(_e2422.member_1, _e2422.member_1, _e2427));
                                                            phi_3859_ = _e2454;
                                                            break if !(_e2456);
                                                        }
                                                    }
                                                    let _e2461 = local_20;
                                                    let _e2462 = select(true, false, _e2461);
                                                    let _e2464 = local_21;
                                                    phi_3926_ = select(u32(), select(2u, 1u, _e2464), _e2462);
                                                    phi_3927_ = 0u;
                                                    phi_3928_ = select(true, false, _e2462);
                                                } else {
                                                    phi_3926_ = u32();
                                                    phi_3927_ = 2u;
                                                    phi_3928_ = true;
                                                }
                                                let _e2469 = phi_3926_;
                                                let _e2471 = phi_3927_;
                                                let _e2473 = phi_3928_;
                                                let _e2474 = select(_e2469, _e2471, _e2473);
                                                let _e2475 = (_e2474 == 0u);
                                                if _e2475 {
                                                    phi_3959_ = bool();
                                                    phi_3960_ = false;
                                                    phi_3961_ = false;
                                                } else {
                                                    let _e2478 = select(false, _e1805.member_2, (_e2474 == 1u));
                                                    let _e2484 = select(true, select(true, false, ((_e1805.member_1 - _e1805.member) <= _e1404)), _e2478);
                                                    phi_3959_ = _e2478;
                                                    phi_3960_ = _e2484;
                                                    phi_3961_ = select(true, false, _e2484);
                                                }
                                                let _e2487 = phi_3959_;
                                                let _e2489 = phi_3960_;
                                                let _e2491 = phi_3961_;
                                                phi_3962_ = _e2487;
                                                phi_3963_ = _e2475;
                                                phi_3964_ = _e2489;
                                                phi_3965_ = _e2491;
                                            }
                                            let _e2493 = phi_3962_;
                                            let _e2495 = phi_3963_;
                                            let _e2497 = phi_3964_;
                                            let _e2499 = phi_3965_;
                                            phi_3966_ = _e2493;
                                            phi_3967_ = _e2495;
                                            phi_3968_ = _e2497;
                                            phi_3969_ = _e1810;
                                            phi_3970_ = _e2499;
                                        }
                                        let _e2501 = phi_3966_;
                                        let _e2503 = phi_3967_;
                                        let _e2505 = phi_3968_;
                                        let _e2507 = phi_3969_;
                                        let _e2509 = phi_3970_;
                                        phi_3971_ = _e1805;
                                        phi_3972_ = _e2501;
                                        phi_3973_ = _e1805;
                                        phi_3974_ = _e2503;
                                        phi_3975_ = _e2505;
                                        phi_3976_ = _e2507;
                                        phi_3977_ = _e2509;
                                    }
                                    let _e2511 = phi_3971_;
                                    let _e2513 = phi_3972_;
                                    let _e2515 = phi_3973_;
                                    let _e2517 = phi_3974_;
                                    let _e2519 = phi_3975_;
                                    let _e2521 = phi_3976_;
                                    let _e2523 = phi_3977_;
                                    phi_3978_ = _e2511;
                                    phi_3979_ = _e2513;
                                    phi_3980_ = _e2515;
                                    phi_3981_ = _e2517;
                                    phi_3982_ = _e2519;
                                    phi_3983_ = _e1470;
                                    phi_3984_ = _e2521;
                                    phi_3985_ = _e2523;
                                } else {
                                    phi_3978_ = type_44();
                                    phi_3979_ = bool();
                                    phi_3980_ = type_44();
                                    phi_3981_ = true;
                                    phi_3982_ = false;
                                    phi_3983_ = false;
                                    phi_3984_ = false;
                                    phi_3985_ = false;
                                }
                                let _e2525 = phi_3978_;
                                let _e2527 = phi_3979_;
                                let _e2529 = phi_3980_;
                                let _e2531 = phi_3981_;
                                let _e2533 = phi_3982_;
                                let _e2535 = phi_3983_;
                                let _e2537 = phi_3984_;
                                let _e2539 = phi_3985_;
                                phi_3993_ = _e2525;
                                phi_3994_ = _e2527;
                                phi_3995_ = _e2529;
                                phi_3996_ = select(_e2533, false, _e2531);
                                phi_3997_ = _e2531;
                                phi_3998_ = select(_e2535, false, _e2531);
                                phi_3999_ = select(_e2537, false, _e2531);
                                phi_4000_ = select(_e2539, false, _e2531);
                            } else {
                                phi_3993_ = type_44(_e529, _e529, false);
                                phi_3994_ = false;
                                phi_3995_ = type_44();
                                phi_3996_ = true;
                                phi_3997_ = false;
                                phi_3998_ = false;
                                phi_3999_ = false;
                                phi_4000_ = false;
                            }
                            let _e2545 = phi_3993_;
                            let _e2547 = phi_3994_;
                            let _e2549 = phi_3995_;
                            let _e2551 = phi_3996_;
                            let _e2553 = phi_3997_;
                            let _e2555 = phi_3998_;
                            let _e2557 = phi_3999_;
                            let _e2559 = phi_4000_;
                            if _e2551 {
                                let _e2564 = local_10.member[0u];
                                let _e2570 = local_10.member_1[0u];
                                let _e2576 = local_10.member_2[0u];
                                let _e2580 = (_e2564[0] - _e2570[0]);
                                let _e2581 = (_e2564[1] - _e2570[1]);
                                let _e2582 = (_e2564[2] - _e2570[2]);
                                let _e2583 = (_e226.member == 0u);
                                let _e2595 = local_10.member[1u];
                                let _e2601 = local_10.member_1[1u];
                                let _e2607 = local_10.member_2[1u];
                                let _e2611 = (_e2595[0] - _e2601[0]);
                                let _e2612 = (_e2595[1] - _e2601[1]);
                                let _e2613 = (_e2595[2] - _e2601[2]);
                                let _e2614 = (_e226.member == 0u);
                                let _e2626 = local_10.member[0u];
                                let _e2632 = select(_e2626[0], -(_e2626[0]), (_e2626[0] < 0.0lf));
                                let _e2635 = select(_e2626[1], -(_e2626[1]), (_e2626[1] < 0.0lf));
                                let _e2637 = select(_e2635, _e2632, (_e2632 > _e2635));
                                let _e2640 = select(_e2626[2], -(_e2626[2]), (_e2626[2] < 0.0lf));
                                let _e2642 = select(_e2640, _e2637, (_e2637 > _e2640));
                                let _e2645 = local_10.member[1u];
                                let _e2651 = select(_e2645[0], -(_e2645[0]), (_e2645[0] < 0.0lf));
                                let _e2654 = select(_e2645[1], -(_e2645[1]), (_e2645[1] < 0.0lf));
                                let _e2656 = select(_e2654, _e2651, (_e2651 > _e2654));
                                let _e2659 = select(_e2645[2], -(_e2645[2]), (_e2645[2] < 0.0lf));
                                let _e2661 = select(_e2659, _e2656, (_e2656 > _e2659));
                                let _e2665 = local_10.member_3;
                                let _e2669 = local_10.member_1[0u];
                                let _e2675 = select(_e2669[0], -(_e2669[0]), (_e2669[0] < 0.0lf));
                                let _e2678 = select(_e2669[1], -(_e2669[1]), (_e2669[1] < 0.0lf));
                                let _e2680 = select(_e2678, _e2675, (_e2675 > _e2678));
                                let _e2683 = select(_e2669[2], -(_e2669[2]), (_e2669[2] < 0.0lf));
                                let _e2685 = select(_e2683, _e2680, (_e2680 > _e2683));
                                let _e2688 = local_10.member_1[1u];
                                let _e2694 = select(_e2688[0], -(_e2688[0]), (_e2688[0] < 0.0lf));
                                let _e2697 = select(_e2688[1], -(_e2688[1]), (_e2688[1] < 0.0lf));
                                let _e2699 = select(_e2697, _e2694, (_e2694 > _e2697));
                                let _e2702 = select(_e2688[2], -(_e2688[2]), (_e2688[2] < 0.0lf));
                                let _e2704 = select(_e2702, _e2699, (_e2699 > _e2702));
                                let _e2708 = local_10.member_3;
                                let _e2712 = local_10.member_2[0u];
                                let _e2718 = select(_e2712[0], -(_e2712[0]), (_e2712[0] < 0.0lf));
                                let _e2721 = select(_e2712[1], -(_e2712[1]), (_e2712[1] < 0.0lf));
                                let _e2723 = select(_e2721, _e2718, (_e2718 > _e2721));
                                let _e2726 = select(_e2712[2], -(_e2712[2]), (_e2712[2] < 0.0lf));
                                let _e2728 = select(_e2726, _e2723, (_e2723 > _e2726));
                                let _e2731 = local_10.member_2[1u];
                                let _e2737 = select(_e2731[0], -(_e2731[0]), (_e2731[0] < 0.0lf));
                                let _e2740 = select(_e2731[1], -(_e2731[1]), (_e2731[1] < 0.0lf));
                                let _e2742 = select(_e2740, _e2737, (_e2737 > _e2740));
                                let _e2745 = select(_e2731[2], -(_e2731[2]), (_e2731[2] < 0.0lf));
                                let _e2747 = select(_e2745, _e2742, (_e2742 > _e2745));
                                let _e2751 = local_10.member_3;
                                let _e2759 = local_10.member_3;
                                let _e2767 = (_e520 * f64(0.00390625f));
                                let _e2768 = f64(0f);
                                let _e2769 = f64(1f);
                                local = type_35(array<f64, 4>(_e2768, _e2768, _e2768, _e2768), array<f64, 4>(_e2768, _e2768, _e2768, _e2768), array<f64, 4>(_e2769, _e2769, _e2769, _e2769));
                                phi_4429_ = type_9(0u, 96u);
                                phi_4432_ = _e2545.member;
                                phi_4434_ = _e2545.member;
                                phi_4436_ = (_e2545.member_1 - _e2545.member);
                                phi_4438_ = _e2545.member;
                                phi_4440_ = false;
                                phi_4442_ = 0u;
                                loop {
                                    let _e2776 = phi_4429_;
                                    let _e2778 = phi_4432_;
                                    let _e2780 = phi_4434_;
                                    let _e2782 = phi_4436_;
                                    let _e2784 = phi_4438_;
                                    let _e2786 = phi_4440_;
                                    let _e2788 = phi_4442_;
                                    local_34 = _e2778;
                                    local_38 = _e2780;
                                    let _e2791 = (_e2776.member < _e2776.member_1);
                                    if (bitcast<i32>(select(0u, 1u, _e2791)) != 0i) {
                                        let _e2805 = local_10.member[0u];
                                        let _e2811 = local_10.member[1u];
                                        let _e2827 = local_10.member_1[0u];
                                        let _e2833 = local_10.member_1[1u];
                                        let _e2849 = local_10.member_2[0u];
                                        let _e2855 = local_10.member_2[1u];
                                        let _e2869 = function_4(array<f64, 3>((_e2805[0] + ((_e2811[0] - _e2805[0]) * _e2778)), (_e2805[1] + ((_e2811[1] - _e2805[1]) * _e2778)), (_e2805[2] + ((_e2811[2] - _e2805[2]) * _e2778))), array<f64, 3>((_e2827[0] + ((_e2833[0] - _e2827[0]) * _e2778)), (_e2827[1] + ((_e2833[1] - _e2827[1]) * _e2778)), (_e2827[2] + ((_e2833[2] - _e2827[2]) * _e2778))), array<f64, 3>((_e2849[0] + ((_e2855[0] - _e2849[0]) * _e2778)), (_e2849[1] + ((_e2855[1] - _e2849[1]) * _e2778)), (_e2849[2] + ((_e2855[2] - _e2849[2]) * _e2778))), _e226.member);
                                        if (_e2788 == 0u) {
                                            phi_4594_ = _e2869;
                                        } else {
                                            let _e2871 = f64(0f);
                                            phi_4594_ = array<f64, 3>(select(_e2871, _e2869[0], (_e2788 == 1u)), select(_e2871, _e2869[1], (_e2788 == 2u)), select(_e2871, _e2869[2], (_e2788 == 3u)));
                                        }
                                        let _e2883 = phi_4594_;
                                        let _e2897 = ((select(_e2883[0], -(_e2883[0]), (_e2883[0] < 0.0lf)) + select(_e2883[1], -(_e2883[1]), (_e2883[1] < 0.0lf))) + select(_e2883[2], -(_e2883[2]), (_e2883[2] < 0.0lf)));
                                        if (_e2897 > f64(0f)) {
                                            if ((bitcast<u64>(_e2897) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2904 = (f64(1f) / _e2897);
                                                let _e2906 = (_e2883[0] * _e2904);
                                                let _e2908 = (_e2883[1] * _e2904);
                                                let _e2910 = (_e2883[2] * _e2904);
                                                let _e2915 = (((_e2906 * _e2906) + (_e2908 * _e2908)) + (_e2910 * _e2910));
                                                if (_e2915 <= 2.2250738585072014e-308lf) {
                                                    phi_4719_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2915 > 0.0lf));
                                                } else {
                                                    phi_4662_ = type_18(0i, 5i);
                                                    phi_4665_ = bitcast<f64>(((bitcast<u64>(_e2915) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2922 = phi_4662_;
                                                        let _e2924 = phi_4665_;
                                                        local_22 = _e2924;
                                                        if (_e2922.member < _e2922.member_1) {
                                                            let _e2931 = (_e2922.member + 1i);
                                                            phi_4663_ = type_18(select(_e2931, type_19().member_1, select(false, true, ((false == (_e2931 > _e2922.member)) != false))), _e2922.member_1);
                                                            phi_4706_ = type_19(1u, _e2922.member);
                                                        } else {
                                                            phi_4663_ = _e2922;
                                                            phi_4706_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e2942 = phi_4663_;
                                                        let _e2944 = phi_4706_;
                                                        let _e2947 = (bitcast<i32>(_e2944.member) != 0i);
                                                        if _e2947 {
                                                            phi_4666_ = (0.5lf * (_e2924 + (_e2915 / _e2924)));
                                                        } else {
                                                            phi_4666_ = f64();
                                                        }
                                                        let _e2952 = phi_4666_;
                                                        continue;
                                                        continuing {
                                                            phi_4662_ = _e2942;
                                                            phi_4665_ = _e2952;
                                                            break if !(_e2947);
                                                        }
                                                    }
                                                    let _e2957 = local_22;
                                                    phi_4719_ = (_e2957 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2963 = phi_4719_;
                                                let _e2965 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2972 = ((((((((select(_e2661, _e2642, (_e2642 > _e2661)) + _e2665) + (select(_e2704, _e2685, (_e2685 > _e2704)) + _e2708)) + (select(_e2747, _e2728, (_e2728 > _e2747)) + _e2751)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2759 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e814 * _e2963) * (f64(1f) + _e2965)));
                                                let _e2977 = (((_e2906 * _e2564[0]) + (_e2908 * _e2564[1])) + (_e2910 * _e2564[2]));
                                                let _e2982 = (((_e2906 * _e2580) + (_e2908 * _e2581)) + (_e2910 * _e2582));
                                                let _e2987 = (((_e2906 * (_e2564[0] - _e2576[0])) + (_e2908 * (_e2564[1] - _e2576[1]))) + (_e2910 * (_e2564[2] - _e2576[2])));
                                                let _e2992 = (((_e2906 * select((_e2580 - _e2576[0]), _e2564[0], _e2583)) + (_e2908 * select((_e2581 - _e2576[1]), _e2564[1], _e2583))) + (_e2910 * select((_e2582 - _e2576[2]), _e2564[2], _e2583)));
                                                let _e2998 = (((_e2906 * _e2595[0]) + (_e2908 * _e2595[1])) + (_e2910 * _e2595[2]));
                                                let _e3003 = (((_e2906 * _e2611) + (_e2908 * _e2612)) + (_e2910 * _e2613));
                                                let _e3008 = (((_e2906 * (_e2595[0] - _e2607[0])) + (_e2908 * (_e2595[1] - _e2607[1]))) + (_e2910 * (_e2595[2] - _e2607[2])));
                                                let _e3013 = (((_e2906 * select((_e2611 - _e2607[0]), _e2595[0], _e2614)) + (_e2908 * select((_e2612 - _e2607[1]), _e2595[1], _e2614))) + (_e2910 * select((_e2613 - _e2607[2]), _e2595[2], _e2614)));
                                                phi_4845_ = type_35(array<f64, 4>(_e2977, _e2982, _e2987, _e2992), array<f64, 4>(_e2998, _e3003, _e3008, _e3013), array<f64, 4>((_e2972 + ((select(_e2977, -(_e2977), (_e2977 < 0.0lf)) + select(_e2998, -(_e2998), (_e2998 < 0.0lf))) * _e2965)), (_e2972 + ((select(_e2982, -(_e2982), (_e2982 < 0.0lf)) + select(_e3003, -(_e3003), (_e3003 < 0.0lf))) * _e2965)), (_e2972 + ((select(_e2987, -(_e2987), (_e2987 < 0.0lf)) + select(_e3008, -(_e3008), (_e3008 < 0.0lf))) * _e2965)), (_e2972 + ((select(_e2992, -(_e2992), (_e2992 < 0.0lf)) + select(_e3013, -(_e3013), (_e3013 < 0.0lf))) * _e2965))));
                                                phi_4846_ = false;
                                            } else {
                                                phi_4845_ = type_35();
                                                phi_4846_ = true;
                                            }
                                            let _e3054 = phi_4845_;
                                            let _e3056 = phi_4846_;
                                            phi_4847_ = _e3054;
                                            phi_4848_ = _e3056;
                                        } else {
                                            phi_4847_ = type_35();
                                            phi_4848_ = true;
                                        }
                                        let _e3058 = phi_4847_;
                                        let _e3060 = phi_4848_;
                                        if _e3060 {
                                            let _e3061 = f64(0f);
                                            let _e3062 = f64(1f);
                                            phi_4858_ = type_35(array<f64, 4>(_e3061, _e3061, _e3061, _e3061), array<f64, 4>(_e3061, _e3061, _e3061, _e3061), array<f64, 4>(_e3062, _e3062, _e3062, _e3062));
                                        } else {
                                            phi_4858_ = _e3058;
                                        }
                                        let _e3068 = phi_4858_;
                                        local_1 = type_35(array<f64, 4>(_e3068.member[0], _e3068.member[1], _e3068.member[2], _e3068.member[3]), array<f64, 4>(_e3068.member_1[0], _e3068.member_1[1], _e3068.member_1[2], _e3068.member_1[3]), array<f64, 4>(_e3068.member_2[0], _e3068.member_2[1], _e3068.member_2[2], _e3068.member_2[3]));
                                        let _e3088 = (_e2778 - _e2784);
                                        let _e3090 = f64(0f);
                                        let _e3093 = local_1.member[0u];
                                        let _e3096 = local_1.member_1[0u];
                                        let _e3099 = local_1.member[0u];
                                        let _e3105 = local_1.member_2[0u];
                                        if (((_e3093 + ((_e3096 - _e3099) * _e2778)) - _e3105) > _e3090) {
                                            let _e3110 = local_1.member[1u];
                                            let _e3113 = local_1.member_1[1u];
                                            let _e3116 = local_1.member[1u];
                                            let _e3122 = local_1.member_2[1u];
                                            if (((_e3110 + ((_e3113 - _e3116) * _e2778)) - _e3122) > _e3090) {
                                                let _e3127 = local_1.member[2u];
                                                let _e3130 = local_1.member_1[2u];
                                                let _e3133 = local_1.member[2u];
                                                let _e3139 = local_1.member_2[2u];
                                                if (((_e3127 + ((_e3130 - _e3133) * _e2778)) - _e3139) > _e3090) {
                                                    let _e3144 = local_1.member[3u];
                                                    let _e3147 = local_1.member_1[3u];
                                                    let _e3150 = local_1.member[3u];
                                                    let _e3156 = local_1.member_2[3u];
                                                    phi_5030_ = (((_e3144 + ((_e3147 - _e3150) * _e2778)) - _e3156) > _e3090);
                                                    phi_5031_ = false;
                                                } else {
                                                    phi_5030_ = bool();
                                                    phi_5031_ = true;
                                                }
                                                let _e3160 = phi_5030_;
                                                let _e3162 = phi_5031_;
                                                phi_5032_ = _e3160;
                                                phi_5033_ = _e3162;
                                            } else {
                                                phi_5032_ = bool();
                                                phi_5033_ = true;
                                            }
                                            let _e3164 = phi_5032_;
                                            let _e3166 = phi_5033_;
                                            phi_5034_ = _e3164;
                                            phi_5035_ = _e3166;
                                        } else {
                                            phi_5034_ = bool();
                                            phi_5035_ = true;
                                        }
                                        let _e3168 = phi_5034_;
                                        let _e3170 = phi_5035_;
                                        if select(_e3168, false, _e3170) {
                                            if (_e2778 <= _e2780) {
                                                phi_5350_ = true;
                                            } else {
                                                let _e3173 = f64(0f);
                                                let _e3176 = local.member[0u];
                                                let _e3179 = local.member_1[0u];
                                                let _e3182 = local.member[0u];
                                                let _e3188 = local.member_2[0u];
                                                let _e3192 = local_1.member[0u];
                                                let _e3195 = local_1.member_1[0u];
                                                let _e3198 = local_1.member[0u];
                                                let _e3204 = local_1.member_2[0u];
                                                if ((((_e3176 + ((_e3179 - _e3182) * _e2778)) - _e3188) + ((_e3192 + ((_e3195 - _e3198) * _e2784)) - _e3204)) > _e3173) {
                                                    let _e3210 = local.member[1u];
                                                    let _e3213 = local.member_1[1u];
                                                    let _e3216 = local.member[1u];
                                                    let _e3222 = local.member_2[1u];
                                                    let _e3226 = local_1.member[1u];
                                                    let _e3229 = local_1.member_1[1u];
                                                    let _e3232 = local_1.member[1u];
                                                    let _e3238 = local_1.member_2[1u];
                                                    if ((((_e3210 + ((_e3213 - _e3216) * _e2778)) - _e3222) + ((_e3226 + ((_e3229 - _e3232) * _e2784)) - _e3238)) > _e3173) {
                                                        let _e3244 = local.member[2u];
                                                        let _e3247 = local.member_1[2u];
                                                        let _e3250 = local.member[2u];
                                                        let _e3256 = local.member_2[2u];
                                                        let _e3260 = local_1.member[2u];
                                                        let _e3263 = local_1.member_1[2u];
                                                        let _e3266 = local_1.member[2u];
                                                        let _e3272 = local_1.member_2[2u];
                                                        if ((((_e3244 + ((_e3247 - _e3250) * _e2778)) - _e3256) + ((_e3260 + ((_e3263 - _e3266) * _e2784)) - _e3272)) > _e3173) {
                                                            let _e3278 = local.member[3u];
                                                            let _e3281 = local.member_1[3u];
                                                            let _e3284 = local.member[3u];
                                                            let _e3290 = local.member_2[3u];
                                                            let _e3294 = local_1.member[3u];
                                                            let _e3297 = local_1.member_1[3u];
                                                            let _e3300 = local_1.member[3u];
                                                            let _e3306 = local_1.member_2[3u];
                                                            phi_5337_ = ((((_e3278 + ((_e3281 - _e3284) * _e2778)) - _e3290) + ((_e3294 + ((_e3297 - _e3300) * _e2784)) - _e3306)) > _e3173);
                                                            phi_5338_ = false;
                                                        } else {
                                                            phi_5337_ = bool();
                                                            phi_5338_ = true;
                                                        }
                                                        let _e3311 = phi_5337_;
                                                        let _e3313 = phi_5338_;
                                                        phi_5339_ = _e3311;
                                                        phi_5340_ = _e3313;
                                                    } else {
                                                        phi_5339_ = bool();
                                                        phi_5340_ = true;
                                                    }
                                                    let _e3315 = phi_5339_;
                                                    let _e3317 = phi_5340_;
                                                    phi_5341_ = _e3315;
                                                    phi_5342_ = _e3317;
                                                } else {
                                                    phi_5341_ = bool();
                                                    phi_5342_ = true;
                                                }
                                                let _e3319 = phi_5341_;
                                                let _e3321 = phi_5342_;
                                                phi_5350_ = select(_e3319, false, _e3321);
                                            }
                                            let _e3324 = phi_5350_;
                                            if _e3324 {
                                                if select(true, select(true, false, (_e2778 >= _e2545.member_1)), _e2786) {
                                                    local = type_35(array<f64, 4>(_e3068.member[0], _e3068.member[1], _e3068.member[2], _e3068.member[3]), array<f64, 4>(_e3068.member_1[0], _e3068.member_1[1], _e3068.member_1[2], _e3068.member_1[3]), array<f64, 4>(_e3068.member_2[0], _e3068.member_2[1], _e3068.member_2[2], _e3068.member_2[3]));
                                                    let _e3349 = local.member[0u];
                                                    let _e3352 = local.member_1[0u];
                                                    let _e3355 = local.member_2[0u];
                                                    if select(true, select(true, false, (_e3352 > _e3355)), (_e3349 > _e3355)) {
                                                        let _e3360 = (_e3352 >= _e3349);
                                                        if _e3360 {
                                                            phi_5462_ = f64();
                                                            phi_5463_ = false;
                                                        } else {
                                                            if ((_e3349 - _e3352) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5460_ = (((_e3349 - _e3355) / (_e3349 - _e3352)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5461_ = false;
                                                            } else {
                                                                phi_5460_ = f64();
                                                                phi_5461_ = true;
                                                            }
                                                            let _e3374 = phi_5460_;
                                                            let _e3376 = phi_5461_;
                                                            phi_5462_ = _e3374;
                                                            phi_5463_ = _e3376;
                                                        }
                                                        let _e3378 = phi_5462_;
                                                        let _e3380 = phi_5463_;
                                                        phi_5464_ = _e3378;
                                                        phi_5465_ = _e3360;
                                                        phi_5466_ = _e3380;
                                                    } else {
                                                        phi_5464_ = f64();
                                                        phi_5465_ = true;
                                                        phi_5466_ = false;
                                                    }
                                                    let _e3382 = phi_5464_;
                                                    let _e3384 = phi_5465_;
                                                    let _e3386 = phi_5466_;
                                                    let _e3390 = select(_e3382, select(_e2778, f64(2f), _e3384), select(_e3386, true, _e3384));
                                                    let _e3393 = local.member[1u];
                                                    let _e3396 = local.member_1[1u];
                                                    let _e3399 = local.member_2[1u];
                                                    if select(true, select(true, false, (_e3396 > _e3399)), (_e3393 > _e3399)) {
                                                        let _e3404 = (_e3396 >= _e3393);
                                                        if _e3404 {
                                                            phi_5534_ = f64();
                                                            phi_5535_ = false;
                                                        } else {
                                                            if ((_e3393 - _e3396) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5532_ = (((_e3393 - _e3399) / (_e3393 - _e3396)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5533_ = false;
                                                            } else {
                                                                phi_5532_ = f64();
                                                                phi_5533_ = true;
                                                            }
                                                            let _e3418 = phi_5532_;
                                                            let _e3420 = phi_5533_;
                                                            phi_5534_ = _e3418;
                                                            phi_5535_ = _e3420;
                                                        }
                                                        let _e3422 = phi_5534_;
                                                        let _e3424 = phi_5535_;
                                                        phi_5536_ = _e3422;
                                                        phi_5537_ = _e3404;
                                                        phi_5538_ = _e3424;
                                                    } else {
                                                        phi_5536_ = f64();
                                                        phi_5537_ = true;
                                                        phi_5538_ = false;
                                                    }
                                                    let _e3426 = phi_5536_;
                                                    let _e3428 = phi_5537_;
                                                    let _e3430 = phi_5538_;
                                                    let _e3434 = select(_e3426, select(_e2778, f64(2f), _e3428), select(_e3430, true, _e3428));
                                                    let _e3436 = select(_e3434, _e3390, (_e3390 < _e3434));
                                                    let _e3439 = local.member[2u];
                                                    let _e3442 = local.member_1[2u];
                                                    let _e3445 = local.member_2[2u];
                                                    if select(true, select(true, false, (_e3442 > _e3445)), (_e3439 > _e3445)) {
                                                        let _e3450 = (_e3442 >= _e3439);
                                                        if _e3450 {
                                                            phi_5611_ = f64();
                                                            phi_5612_ = false;
                                                        } else {
                                                            if ((_e3439 - _e3442) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5609_ = (((_e3439 - _e3445) / (_e3439 - _e3442)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5610_ = false;
                                                            } else {
                                                                phi_5609_ = f64();
                                                                phi_5610_ = true;
                                                            }
                                                            let _e3464 = phi_5609_;
                                                            let _e3466 = phi_5610_;
                                                            phi_5611_ = _e3464;
                                                            phi_5612_ = _e3466;
                                                        }
                                                        let _e3468 = phi_5611_;
                                                        let _e3470 = phi_5612_;
                                                        phi_5613_ = _e3468;
                                                        phi_5614_ = _e3450;
                                                        phi_5615_ = _e3470;
                                                    } else {
                                                        phi_5613_ = f64();
                                                        phi_5614_ = true;
                                                        phi_5615_ = false;
                                                    }
                                                    let _e3472 = phi_5613_;
                                                    let _e3474 = phi_5614_;
                                                    let _e3476 = phi_5615_;
                                                    let _e3480 = select(_e3472, select(_e2778, f64(2f), _e3474), select(_e3476, true, _e3474));
                                                    let _e3483 = local.member[3u];
                                                    let _e3486 = local.member_1[3u];
                                                    let _e3489 = local.member_2[3u];
                                                    if select(true, select(true, false, (_e3486 > _e3489)), (_e3483 > _e3489)) {
                                                        let _e3494 = (_e3486 >= _e3483);
                                                        if _e3494 {
                                                            phi_5683_ = f64();
                                                            phi_5684_ = false;
                                                        } else {
                                                            if ((_e3483 - _e3486) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                phi_5681_ = (((_e3483 - _e3489) / (_e3483 - _e3486)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                phi_5682_ = false;
                                                            } else {
                                                                phi_5681_ = f64();
                                                                phi_5682_ = true;
                                                            }
                                                            let _e3508 = phi_5681_;
                                                            let _e3510 = phi_5682_;
                                                            phi_5683_ = _e3508;
                                                            phi_5684_ = _e3510;
                                                        }
                                                        let _e3512 = phi_5683_;
                                                        let _e3514 = phi_5684_;
                                                        phi_5685_ = _e3512;
                                                        phi_5686_ = _e3494;
                                                        phi_5687_ = _e3514;
                                                    } else {
                                                        phi_5685_ = f64();
                                                        phi_5686_ = true;
                                                        phi_5687_ = false;
                                                    }
                                                    let _e3516 = phi_5685_;
                                                    let _e3518 = phi_5686_;
                                                    let _e3520 = phi_5687_;
                                                    let _e3524 = select(_e3516, select(_e2778, f64(2f), _e3518), select(_e3520, true, _e3518));
                                                    let _e3526 = select(_e3524, _e3480, (_e3480 < _e3524));
                                                    let _e3528 = select(_e3526, _e3436, (_e3436 < _e3526));
                                                    let _e3530 = select(_e2778, _e3528, (_e3528 > _e2778));
                                                    let _e3531 = (_e3530 > _e2545.member_1);
                                                    if _e3531 {
                                                        phi_6229_ = f64();
                                                        phi_6230_ = f64();
                                                        phi_6231_ = false;
                                                        phi_6232_ = false;
                                                    } else {
                                                        let _e3532 = (_e3530 - _e2778);
                                                        let _e3533 = (_e3532 <= _e2767);
                                                        let _e3536 = (_e3530 + (_e520 * f64(0.01f)));
                                                        let _e3538 = select(_e2545.member_1, _e3536, (_e3536 < _e2545.member_1));
                                                        if _e3533 {
                                                            if (_e814 > f64(0f)) {
                                                                let _e3543 = local_10.member[0u];
                                                                let _e3549 = local_10.member[1u];
                                                                let _e3565 = local_10.member_1[0u];
                                                                let _e3571 = local_10.member_1[1u];
                                                                let _e3587 = local_10.member_2[0u];
                                                                let _e3593 = local_10.member_2[1u];
                                                                let _e3607 = function_4(array<f64, 3>((_e3543[0] + ((_e3549[0] - _e3543[0]) * _e3538)), (_e3543[1] + ((_e3549[1] - _e3543[1]) * _e3538)), (_e3543[2] + ((_e3549[2] - _e3543[2]) * _e3538))), array<f64, 3>((_e3565[0] + ((_e3571[0] - _e3565[0]) * _e3538)), (_e3565[1] + ((_e3571[1] - _e3565[1]) * _e3538)), (_e3565[2] + ((_e3571[2] - _e3565[2]) * _e3538))), array<f64, 3>((_e3587[0] + ((_e3593[0] - _e3587[0]) * _e3538)), (_e3587[1] + ((_e3593[1] - _e3587[1]) * _e3538)), (_e3587[2] + ((_e3593[2] - _e3587[2]) * _e3538))), _e226.member);
                                                                let _e3618 = (((_e3607[0] * _e3607[0]) + (_e3607[1] * _e3607[1])) + (_e3607[2] * _e3607[2]));
                                                                if (_e3618 <= 2.2250738585072014e-308lf) {
                                                                    phi_5921_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e3618 > 0.0lf));
                                                                } else {
                                                                    phi_5864_ = type_18(0i, 5i);
                                                                    phi_5867_ = bitcast<f64>(((bitcast<u64>(_e3618) / 2lu) + 2303426169912950784lu));
                                                                    loop {
                                                                        let _e3625 = phi_5864_;
                                                                        let _e3627 = phi_5867_;
                                                                        local_23 = _e3627;
                                                                        if (_e3625.member < _e3625.member_1) {
                                                                            let _e3634 = (_e3625.member + 1i);
                                                                            phi_5865_ = type_18(select(_e3634, type_19().member_1, select(false, true, ((false == (_e3634 > _e3625.member)) != false))), _e3625.member_1);
                                                                            phi_5908_ = type_19(1u, _e3625.member);
                                                                        } else {
                                                                            phi_5865_ = _e3625;
                                                                            phi_5908_ = type_19(0u, type_19().member_1);
                                                                        }
                                                                        let _e3645 = phi_5865_;
                                                                        let _e3647 = phi_5908_;
                                                                        let _e3650 = (bitcast<i32>(_e3647.member) != 0i);
                                                                        if _e3650 {
                                                                            phi_5868_ = (0.5lf * (_e3627 + (_e3618 / _e3627)));
                                                                        } else {
                                                                            phi_5868_ = f64();
                                                                        }
                                                                        let _e3655 = phi_5868_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_5864_ = _e3645;
                                                                            phi_5867_ = _e3655;
                                                                            break if !(_e3650);
                                                                        }
                                                                    }
                                                                    let _e3660 = local_23;
                                                                    phi_5921_ = (_e3660 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                }
                                                                let _e3666 = phi_5921_;
                                                                let _e3674 = local_10.member[0u];
                                                                let _e3680 = select(_e3674[0], -(_e3674[0]), (_e3674[0] < 0.0lf));
                                                                let _e3683 = select(_e3674[1], -(_e3674[1]), (_e3674[1] < 0.0lf));
                                                                let _e3685 = select(_e3683, _e3680, (_e3680 > _e3683));
                                                                let _e3688 = select(_e3674[2], -(_e3674[2]), (_e3674[2] < 0.0lf));
                                                                let _e3690 = select(_e3688, _e3685, (_e3685 > _e3688));
                                                                let _e3693 = local_10.member[1u];
                                                                let _e3699 = select(_e3693[0], -(_e3693[0]), (_e3693[0] < 0.0lf));
                                                                let _e3702 = select(_e3693[1], -(_e3693[1]), (_e3693[1] < 0.0lf));
                                                                let _e3704 = select(_e3702, _e3699, (_e3699 > _e3702));
                                                                let _e3707 = select(_e3693[2], -(_e3693[2]), (_e3693[2] < 0.0lf));
                                                                let _e3709 = select(_e3707, _e3704, (_e3704 > _e3707));
                                                                let _e3713 = local_10.member_3;
                                                                let _e3717 = local_10.member_1[0u];
                                                                let _e3723 = select(_e3717[0], -(_e3717[0]), (_e3717[0] < 0.0lf));
                                                                let _e3726 = select(_e3717[1], -(_e3717[1]), (_e3717[1] < 0.0lf));
                                                                let _e3728 = select(_e3726, _e3723, (_e3723 > _e3726));
                                                                let _e3731 = select(_e3717[2], -(_e3717[2]), (_e3717[2] < 0.0lf));
                                                                let _e3733 = select(_e3731, _e3728, (_e3728 > _e3731));
                                                                let _e3736 = local_10.member_1[1u];
                                                                let _e3742 = select(_e3736[0], -(_e3736[0]), (_e3736[0] < 0.0lf));
                                                                let _e3745 = select(_e3736[1], -(_e3736[1]), (_e3736[1] < 0.0lf));
                                                                let _e3747 = select(_e3745, _e3742, (_e3742 > _e3745));
                                                                let _e3750 = select(_e3736[2], -(_e3736[2]), (_e3736[2] < 0.0lf));
                                                                let _e3752 = select(_e3750, _e3747, (_e3747 > _e3750));
                                                                let _e3756 = local_10.member_3;
                                                                let _e3760 = local_10.member_2[0u];
                                                                let _e3766 = select(_e3760[0], -(_e3760[0]), (_e3760[0] < 0.0lf));
                                                                let _e3769 = select(_e3760[1], -(_e3760[1]), (_e3760[1] < 0.0lf));
                                                                let _e3771 = select(_e3769, _e3766, (_e3766 > _e3769));
                                                                let _e3774 = select(_e3760[2], -(_e3760[2]), (_e3760[2] < 0.0lf));
                                                                let _e3776 = select(_e3774, _e3771, (_e3771 > _e3774));
                                                                let _e3779 = local_10.member_2[1u];
                                                                let _e3785 = select(_e3779[0], -(_e3779[0]), (_e3779[0] < 0.0lf));
                                                                let _e3788 = select(_e3779[1], -(_e3779[1]), (_e3779[1] < 0.0lf));
                                                                let _e3790 = select(_e3788, _e3785, (_e3785 > _e3788));
                                                                let _e3793 = select(_e3779[2], -(_e3779[2]), (_e3779[2] < 0.0lf));
                                                                let _e3795 = select(_e3793, _e3790, (_e3790 > _e3793));
                                                                let _e3799 = local_10.member_3;
                                                                let _e3807 = local_10.member_3;
                                                                phi_6198_ = select(true, false, (((_e3666 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((select(_e3709, _e3690, (_e3690 > _e3709)) + _e3713) + (select(_e3752, _e3733, (_e3733 > _e3752)) + _e3756)) + (select(_e3795, _e3776, (_e3776 > _e3795)) + _e3799)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3807 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e814));
                                                            } else {
                                                                phi_6198_ = true;
                                                            }
                                                            let _e3820 = phi_6198_;
                                                            phi_6199_ = _e3820;
                                                        } else {
                                                            phi_6199_ = true;
                                                        }
                                                        let _e3822 = phi_6199_;
                                                        if _e3822 {
                                                            if _e2786 {
                                                                let _e3826 = (_e3532 <= (_e2782 * f64(0.25f)));
                                                                phi_6226_ = select(select(select(f64(), f64(0f), _e3826), f64(), _e3533), (_e3088 + _e3088), select(select(true, false, _e3826), true, _e3533));
                                                            } else {
                                                                phi_6226_ = (_e2545.member_1 - _e2778);
                                                            }
                                                            let _e3835 = phi_6226_;
                                                            phi_6227_ = _e3835;
                                                            phi_6228_ = false;
                                                        } else {
                                                            phi_6227_ = f64();
                                                            phi_6228_ = true;
                                                        }
                                                        let _e3837 = phi_6227_;
                                                        let _e3839 = phi_6228_;
                                                        phi_6229_ = _e3837;
                                                        phi_6230_ = _e3532;
                                                        phi_6231_ = _e3822;
                                                        phi_6232_ = _e3839;
                                                    }
                                                    let _e3841 = phi_6229_;
                                                    let _e3843 = phi_6230_;
                                                    let _e3845 = phi_6231_;
                                                    let _e3847 = phi_6232_;
                                                    phi_6233_ = _e3530;
                                                    phi_6234_ = _e3841;
                                                    phi_6235_ = _e3843;
                                                    phi_6236_ = _e3530;
                                                    phi_6237_ = _e3845;
                                                    phi_6238_ = _e3531;
                                                    phi_6239_ = _e3847;
                                                    phi_6240_ = false;
                                                } else {
                                                    phi_6233_ = f64();
                                                    phi_6234_ = f64();
                                                    phi_6235_ = f64();
                                                    phi_6236_ = f64();
                                                    phi_6237_ = false;
                                                    phi_6238_ = false;
                                                    phi_6239_ = false;
                                                    phi_6240_ = true;
                                                }
                                                let _e3849 = phi_6233_;
                                                let _e3851 = phi_6234_;
                                                let _e3853 = phi_6235_;
                                                let _e3855 = phi_6236_;
                                                let _e3857 = phi_6237_;
                                                let _e3859 = phi_6238_;
                                                let _e3861 = phi_6239_;
                                                let _e3863 = phi_6240_;
                                                phi_6241_ = _e3849;
                                                phi_6242_ = _e3851;
                                                phi_6243_ = _e3853;
                                                phi_6244_ = _e3855;
                                                phi_6245_ = false;
                                                phi_6246_ = _e3857;
                                                phi_6247_ = _e3859;
                                                phi_6248_ = _e3861;
                                                phi_6249_ = _e3863;
                                            } else {
                                                phi_6241_ = f64();
                                                phi_6242_ = f64();
                                                phi_6243_ = f64();
                                                phi_6244_ = f64();
                                                phi_6245_ = true;
                                                phi_6246_ = false;
                                                phi_6247_ = false;
                                                phi_6248_ = false;
                                                phi_6249_ = false;
                                            }
                                            let _e3865 = phi_6241_;
                                            let _e3867 = phi_6242_;
                                            let _e3869 = phi_6243_;
                                            let _e3871 = phi_6244_;
                                            let _e3873 = phi_6245_;
                                            let _e3875 = phi_6246_;
                                            let _e3877 = phi_6247_;
                                            let _e3879 = phi_6248_;
                                            let _e3881 = phi_6249_;
                                            phi_6250_ = _e3865;
                                            phi_6251_ = _e3867;
                                            phi_6252_ = _e3869;
                                            phi_6253_ = _e3871;
                                            phi_6254_ = _e3873;
                                            phi_6255_ = _e3875;
                                            phi_6256_ = _e3877;
                                            phi_6257_ = _e3879;
                                            phi_6258_ = _e3881;
                                        } else {
                                            phi_6250_ = f64();
                                            phi_6251_ = f64();
                                            phi_6252_ = f64();
                                            phi_6253_ = f64();
                                            phi_6254_ = true;
                                            phi_6255_ = false;
                                            phi_6256_ = false;
                                            phi_6257_ = false;
                                            phi_6258_ = false;
                                        }
                                        let _e3883 = phi_6250_;
                                        let _e3885 = phi_6251_;
                                        let _e3887 = phi_6252_;
                                        let _e3889 = phi_6253_;
                                        let _e3891 = phi_6254_;
                                        let _e3893 = phi_6255_;
                                        let _e3895 = phi_6256_;
                                        let _e3897 = phi_6257_;
                                        let _e3899 = phi_6258_;
                                        if _e3891 {
                                            if (_e2778 <= _e2780) {
                                                let _e4057 = (_e2788 + 1u);
                                                let _e4058 = (_e4057 > 3u);
                                                phi_6598_ = _e4057;
                                                phi_6599_ = f64();
                                                phi_6600_ = false;
                                                phi_6601_ = select(true, false, _e4058);
                                                phi_6602_ = _e4058;
                                            } else {
                                                let _e3903 = local.member[0u];
                                                let _e3906 = local.member_1[0u];
                                                let _e3909 = local.member[0u];
                                                let _e3915 = local.member_2[0u];
                                                let _e3916 = ((_e3903 + ((_e3906 - _e3909) * _e2784)) - _e3915);
                                                let _e3919 = local.member[1u];
                                                let _e3922 = local.member_1[1u];
                                                let _e3925 = local.member[1u];
                                                let _e3931 = local.member_2[1u];
                                                let _e3932 = ((_e3919 + ((_e3922 - _e3925) * _e2784)) - _e3931);
                                                let _e3934 = select(_e3932, _e3916, (_e3916 < _e3932));
                                                let _e3937 = local.member[2u];
                                                let _e3940 = local.member_1[2u];
                                                let _e3943 = local.member[2u];
                                                let _e3949 = local.member_2[2u];
                                                let _e3950 = ((_e3937 + ((_e3940 - _e3943) * _e2784)) - _e3949);
                                                let _e3953 = local.member[3u];
                                                let _e3956 = local.member_1[3u];
                                                let _e3959 = local.member[3u];
                                                let _e3965 = local.member_2[3u];
                                                let _e3966 = ((_e3953 + ((_e3956 - _e3959) * _e2784)) - _e3965);
                                                let _e3968 = select(_e3966, _e3950, (_e3950 < _e3966));
                                                let _e3970 = select(_e3968, _e3934, (_e3934 < _e3968));
                                                let _e3973 = local_1.member[0u];
                                                let _e3976 = local_1.member_1[0u];
                                                let _e3979 = local_1.member[0u];
                                                let _e3985 = local_1.member_2[0u];
                                                let _e3986 = ((_e3973 + ((_e3976 - _e3979) * _e2778)) - _e3985);
                                                let _e3989 = local_1.member[1u];
                                                let _e3992 = local_1.member_1[1u];
                                                let _e3995 = local_1.member[1u];
                                                let _e4001 = local_1.member_2[1u];
                                                let _e4002 = ((_e3989 + ((_e3992 - _e3995) * _e2778)) - _e4001);
                                                let _e4004 = select(_e4002, _e3986, (_e3986 < _e4002));
                                                let _e4007 = local_1.member[2u];
                                                let _e4010 = local_1.member_1[2u];
                                                let _e4013 = local_1.member[2u];
                                                let _e4019 = local_1.member_2[2u];
                                                let _e4020 = ((_e4007 + ((_e4010 - _e4013) * _e2778)) - _e4019);
                                                let _e4023 = local_1.member[3u];
                                                let _e4026 = local_1.member_1[3u];
                                                let _e4029 = local_1.member[3u];
                                                let _e4035 = local_1.member_2[3u];
                                                let _e4036 = ((_e4023 + ((_e4026 - _e4029) * _e2778)) - _e4035);
                                                let _e4038 = select(_e4036, _e4020, (_e4020 < _e4036));
                                                let _e4040 = select(_e4038, _e4004, (_e4004 < _e4038));
                                                let _e4041 = f64(0.0625f);
                                                let _e4043 = f64(0.9f);
                                                if (_e4040 > f64(0f)) {
                                                    phi_6596_ = f64(0.5f);
                                                } else {
                                                    let _e4049 = (f64(0.95f) * (_e3970 / (_e3970 - _e4040)));
                                                    phi_6596_ = select(_e4041, select(_e4043, _e4049, (_e4049 < _e4043)), (_e4049 > _e4041));
                                                }
                                                let _e4055 = phi_6596_;
                                                phi_6598_ = u32();
                                                phi_6599_ = (_e3088 * _e4055);
                                                phi_6600_ = true;
                                                phi_6601_ = false;
                                                phi_6602_ = false;
                                            }
                                            let _e4061 = phi_6598_;
                                            let _e4063 = phi_6599_;
                                            let _e4065 = phi_6600_;
                                            let _e4067 = phi_6601_;
                                            let _e4069 = phi_6602_;
                                            phi_6603_ = _e4061;
                                            phi_6604_ = _e2780;
                                            phi_6605_ = _e4063;
                                            phi_6606_ = _e2782;
                                            phi_6607_ = _e2784;
                                            phi_6608_ = _e2786;
                                            phi_6609_ = _e2788;
                                            phi_6610_ = _e4065;
                                            phi_6611_ = _e4067;
                                            phi_6612_ = _e4069;
                                            phi_6613_ = false;
                                            phi_6614_ = false;
                                            phi_6615_ = false;
                                        } else {
                                            phi_6603_ = u32();
                                            phi_6604_ = _e3883;
                                            phi_6605_ = _e3885;
                                            phi_6606_ = _e3887;
                                            phi_6607_ = _e2778;
                                            phi_6608_ = true;
                                            phi_6609_ = 0u;
                                            phi_6610_ = _e3893;
                                            phi_6611_ = false;
                                            phi_6612_ = false;
                                            phi_6613_ = _e3895;
                                            phi_6614_ = _e3897;
                                            phi_6615_ = _e3899;
                                        }
                                        let _e4071 = phi_6603_;
                                        let _e4073 = phi_6604_;
                                        let _e4075 = phi_6605_;
                                        let _e4077 = phi_6606_;
                                        let _e4079 = phi_6607_;
                                        let _e4081 = phi_6608_;
                                        let _e4083 = phi_6609_;
                                        let _e4085 = phi_6610_;
                                        let _e4087 = phi_6611_;
                                        let _e4089 = phi_6612_;
                                        let _e4091 = phi_6613_;
                                        let _e4093 = phi_6614_;
                                        let _e4095 = phi_6615_;
                                        if _e4085 {
                                            let _e4096 = (_e4079 + _e4075);
                                            let _e4098 = select(_e4073, _e4096, (_e4096 > _e4073));
                                            let _e4100 = select(_e2545.member_1, _e4098, (_e4098 < _e2545.member_1));
                                            let _e4103 = select(((_e4100 - _e4079) > _e2767), true, !(_e2786));
                                            phi_6643_ = _e4100;
                                            phi_6644_ = _e4073;
                                            phi_6645_ = _e4077;
                                            phi_6646_ = _e4079;
                                            phi_6647_ = _e4081;
                                            phi_6648_ = _e4083;
                                            phi_6649_ = _e4103;
                                            phi_6650_ = select(true, false, _e4103);
                                            phi_6651_ = false;
                                            phi_6652_ = false;
                                            phi_6653_ = false;
                                            phi_6654_ = false;
                                        } else {
                                            phi_6643_ = _e2778;
                                            phi_6644_ = _e2780;
                                            phi_6645_ = _e2782;
                                            phi_6646_ = _e2784;
                                            phi_6647_ = _e2786;
                                            phi_6648_ = _e4071;
                                            phi_6649_ = _e4087;
                                            phi_6650_ = false;
                                            phi_6651_ = _e4089;
                                            phi_6652_ = _e4091;
                                            phi_6653_ = _e4093;
                                            phi_6654_ = _e4095;
                                        }
                                        let _e4106 = phi_6643_;
                                        let _e4108 = phi_6644_;
                                        let _e4110 = phi_6645_;
                                        let _e4112 = phi_6646_;
                                        let _e4114 = phi_6647_;
                                        let _e4116 = phi_6648_;
                                        let _e4118 = phi_6649_;
                                        let _e4120 = phi_6650_;
                                        let _e4122 = phi_6651_;
                                        let _e4124 = phi_6652_;
                                        let _e4126 = phi_6653_;
                                        let _e4128 = phi_6654_;
                                        phi_4433_ = _e4106;
                                        phi_4435_ = _e4108;
                                        phi_4437_ = _e4110;
                                        phi_4439_ = _e4112;
                                        phi_4441_ = _e4114;
                                        phi_4443_ = _e4116;
                                        phi_6655_ = _e4073;
                                        phi_6656_ = _e3889;
                                        phi_6657_ = _e4118;
                                        phi_6658_ = _e4120;
                                        phi_6659_ = _e4122;
                                        phi_6660_ = _e4124;
                                        phi_6661_ = _e4126;
                                        phi_6662_ = false;
                                        phi_6663_ = _e4128;
                                    } else {
                                        phi_4433_ = f64();
                                        phi_4435_ = f64();
                                        phi_4437_ = f64();
                                        phi_4439_ = f64();
                                        phi_4441_ = bool();
                                        phi_4443_ = u32();
                                        phi_6655_ = f64();
                                        phi_6656_ = f64();
                                        phi_6657_ = false;
                                        phi_6658_ = false;
                                        phi_6659_ = false;
                                        phi_6660_ = false;
                                        phi_6661_ = false;
                                        phi_6662_ = true;
                                        phi_6663_ = false;
                                    }
                                    let _e4130 = phi_4433_;
                                    let _e4132 = phi_4435_;
                                    let _e4134 = phi_4437_;
                                    let _e4136 = phi_4439_;
                                    let _e4138 = phi_4441_;
                                    let _e4140 = phi_4443_;
                                    let _e4142 = phi_6655_;
                                    let _e4144 = phi_6656_;
                                    let _e4146 = phi_6657_;
                                    let _e4148 = phi_6658_;
                                    let _e4150 = phi_6659_;
                                    let _e4152 = phi_6660_;
                                    let _e4154 = phi_6661_;
                                    let _e4156 = phi_6662_;
                                    let _e4158 = phi_6663_;
                                    local_24 = _e4148;
                                    local_25 = _e4150;
                                    local_26 = _e4148;
                                    local_27 = _e4152;
                                    local_28 = _e4148;
                                    local_29 = _e4154;
                                    local_30 = _e4148;
                                    local_31 = _e4156;
                                    local_32 = _e4148;
                                    local_33 = _e4158;
                                    local_35 = _e4148;
                                    local_36 = _e4144;
                                    local_37 = _e4142;
                                    continue;
                                    continuing {
                                        phi_4429_ = type_9(select(_e2776.member, (_e2776.member + 1u), _e2791), select(_e2776.member_1, _e2776.member_1, _e2791));
                                        phi_4432_ = _e4130;
                                        phi_4434_ = _e4132;
                                        phi_4436_ = _e4134;
                                        phi_4438_ = _e4136;
                                        phi_4440_ = _e4138;
                                        phi_4442_ = _e4140;
                                        break if !(_e4146);
                                    }
                                }
                                let _e4161 = local_24;
                                let _e4163 = local_25;
                                let _e4164 = select(_e4163, false, _e4161);
                                let _e4166 = local_26;
                                let _e4168 = local_27;
                                let _e4171 = local_28;
                                let _e4173 = local_29;
                                let _e4176 = local_30;
                                let _e4178 = local_31;
                                let _e4181 = local_32;
                                let _e4183 = local_33;
                                let _e4189 = local_34;
                                let _e4191 = select(select(_e4168, false, _e4166), false, _e4164);
                                let _e4194 = local_35;
                                let _e4201 = select(select(select(_e4173, false, _e4171), false, _e4164), false, _e4191);
                                let _e4207 = local_36;
                                let _e4209 = local_37;
                                let _e4211 = select(select(select(_e4194, false, _e4164), false, _e4191), true, _e4201);
                                let _e4216 = local_38;
                                let _e4218 = select(select(select(select(select(_e4178, false, _e4176), false, _e4164), false, _e4191), false, _e4201), true, _e4211);
                                let _e4225 = select(select(select(select(select(select(_e4183, false, _e4181), false, _e4164), false, _e4191), false, _e4201), false, _e4211), false, _e4218);
                                let _e4230 = select(select(select(select(select(_e4164, true, _e4191), false, _e4201), false, _e4211), false, _e4218), true, _e4225);
                                let _e4233 = (select(select(type_43().member, 1u, _e4218), select(select(select(type_43().member, 1u, _e4164), 0u, _e4191), 0u, _e4225), _e4230) != 0u);
                                phi_6731_ = select(select(type_43().member_1, select(_e4216, select(_e4209, _e4207, _e4201), _e4211), _e4218), select(select(select(type_43().member_1, _e4189, _e4164), type_43().member_1, _e4191), type_43().member_1, _e4225), _e4230);
                                phi_6732_ = select(true, false, _e4233);
                                phi_6733_ = _e4233;
                                phi_6734_ = false;
                                phi_6735_ = false;
                                phi_6736_ = false;
                            } else {
                                phi_6731_ = f64();
                                phi_6732_ = _e2553;
                                phi_6733_ = false;
                                phi_6734_ = _e2555;
                                phi_6735_ = _e2557;
                                phi_6736_ = _e2559;
                            }
                            let _e4236 = phi_6731_;
                            let _e4238 = phi_6732_;
                            let _e4240 = phi_6733_;
                            let _e4242 = phi_6734_;
                            let _e4244 = phi_6735_;
                            let _e4246 = phi_6736_;
                            phi_6737_ = _e2545;
                            phi_6738_ = _e2547;
                            phi_6739_ = _e4236;
                            phi_6740_ = _e2549;
                            phi_6741_ = _e4238;
                            phi_6742_ = _e4240;
                            phi_6743_ = false;
                            phi_6744_ = _e4242;
                            phi_6745_ = _e4244;
                            phi_6746_ = _e4246;
                        } else {
                            phi_6737_ = type_44();
                            phi_6738_ = bool();
                            phi_6739_ = f64();
                            phi_6740_ = type_44();
                            phi_6741_ = false;
                            phi_6742_ = false;
                            phi_6743_ = true;
                            phi_6744_ = false;
                            phi_6745_ = false;
                            phi_6746_ = false;
                        }
                        let _e4248 = phi_6737_;
                        let _e4250 = phi_6738_;
                        let _e4252 = phi_6739_;
                        let _e4254 = phi_6740_;
                        let _e4256 = phi_6741_;
                        let _e4258 = phi_6742_;
                        let _e4260 = phi_6743_;
                        let _e4262 = phi_6744_;
                        let _e4264 = phi_6745_;
                        let _e4266 = phi_6746_;
                        local_39 = _e4258;
                        local_40 = _e4250;
                        local_41 = _e4248;
                        local_42 = _e4252;
                        local_43 = _e4252;
                        local_44 = _e4252;
                        local_48 = _e4260;
                        local_49 = _e4262;
                        local_50 = _e4264;
                        local_51 = _e4266;
                        local_45 = _e4258;
                        local_46 = _e4254;
                        continue;
                        continuing {
                            phi_2379_ = type_9(select(_e1441.member, (_e1441.member + 1u), _e1444), select(_e1441.member_1, _e1441.member_1, _e1444));
                            break if !(_e4256);
                        }
                    }
                    let _e4269 = local_39;
                    if _e4269 {
                        let _e4271 = local_40;
                        if _e4271 {
                            let _e4273 = local_41;
                            let _e4276 = local_42;
                            let _e4278 = ((_e4273.member_1 - _e4276) <= _e1404);
                            let _e4283 = local_43;
                            phi_6762_ = type_43(select(type_43().member, 1u, _e4278), select(type_43().member_1, _e4283, _e4278));
                            phi_6763_ = select(true, false, _e4278);
                        } else {
                            phi_6762_ = type_43();
                            phi_6763_ = true;
                        }
                        let _e4288 = phi_6762_;
                        let _e4290 = phi_6763_;
                        let _e4295 = local_44;
                        phi_6769_ = type_43(select(_e4288.member, 2u, _e4290), select(_e4288.member_1, _e4295, _e4290));
                        phi_6770_ = false;
                        phi_6771_ = false;
                        phi_6772_ = false;
                        phi_6773_ = false;
                    } else {
                        phi_6769_ = type_43();
                        let _e4783 = local_48;
                        phi_6770_ = _e4783;
                        let _e4786 = local_49;
                        phi_6771_ = _e4786;
                        let _e4789 = local_50;
                        phi_6772_ = _e4789;
                        let _e4792 = local_51;
                        phi_6773_ = _e4792;
                    }
                    let _e4299 = phi_6769_;
                    let _e4301 = phi_6770_;
                    let _e4303 = phi_6771_;
                    let _e4305 = phi_6772_;
                    let _e4307 = phi_6773_;
                    let _e4314 = select(_e4303, false, _e4301);
                    let _e4318 = local_45;
                    let _e4325 = select(select(_e4305, false, _e4301), false, _e4314);
                    let _e4331 = select(select(select(_e4307, false, _e4301), false, _e4314), false, _e4325);
                    let _e4335 = local_46;
                    let _e4339 = select(select(_e4314, true, _e4325), true, _e4331);
                    phi_6815_ = type_43(select(_e4299.member, select(select(select(type_43().member, 0u, _e4314), 0u, _e4325), 1u, _e4331), _e4339), select(_e4299.member_1, select(select(select(type_43().member_1, type_43().member_1, _e4314), type_43().member_1, _e4325), _e4335.member, _e4331), _e4339));
                    phi_6816_ = type_43(select(type_43().member, 0u, _e4301), select(type_43().member_1, type_43().member_1, _e4301));
                    phi_6817_ = select(select(select(select(select(_e4318, false, _e4301), false, _e4314), false, _e4325), false, _e4331), true, _e4339);
                }
                let _e4350 = phi_6815_;
                let _e4352 = phi_6816_;
                let _e4354 = phi_6817_;
                let _e4357 = select(_e4352.member, _e4350.member, _e4354);
                let _e4360 = select(_e4352.member_1, _e4350.member_1, _e4354);
                let _e4366 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e4360 > _e529)), (_e4357 == 1u))));
                switch bitcast<i32>(_e4357) {
                    case 0: {
                        phi_6861_ = type_34(0u, _e4366, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4370 = function_1(_e4360);
                        phi_6861_ = type_34(0u, _e4366, _e4370, true);
                        break;
                    }
                    case 2: {
                        let _e4368 = function_1(_e4360);
                        phi_6861_ = type_34(1u, _e4366, _e4368, true);
                        break;
                    }
                    default: {
                        phi_6861_ = type_34();
                        break;
                    }
                }
                let _e4374 = phi_6861_;
                phi_6862_ = _e4374;
                phi_6863_ = type_9(_e193, _e196);
            } else {
                phi_6862_ = type_34(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_6863_ = type_9(0u, 0u);
            }
            let _e4376 = phi_6862_;
            let _e4378 = phi_6863_;
            let _e4383 = params.member.member.member_1;
            let _e4385 = ((_e4383 & 16u) != 0u);
            let _e4388 = select(true, false, (_e4376.member == 0u));
            let _e4391 = select(false, select(_e4388, true, _e4385), _e4376.member_3);
            if _e4376.member_3 {
                if _e4388 {
                } else {
                    let _e4396 = (_e4376.member_2[1] >> bitcast<u32>(20i));
                    if (_e4396 <= 896u) {
                        phi_6909_ = 0u;
                    } else {
                        phi_6909_ = ((((_e4396 - 896u) << bitcast<u32>(23i)) | ((_e4376.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e4376.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e4411 = phi_6909_;
                    let _e4413 = atomicMin((&earliest.member[0u]), _e4411);
                }
            }
            if (_e108 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4391 {
                let _e4417 = atomicAdd((&counters[0u]), 1u);
                phi_6923_ = _e4417;
            } else {
                phi_6923_ = 0u;
            }
            let _e4419 = phi_6923_;
            workgroupBarrier();
            if (_e108 == 0u) {
                let _e4422 = atomicLoad((&counters[0u]));
                if (_e4422 > 0u) {
                    let _e4425 = atomicAdd((&contacts.member[0u]), _e4422);
                    atomicStore((&counters[1u]), _e4425);
                }
            }
            workgroupBarrier();
            let _e4428 = atomicLoad((&counters[1u]));
            let _e4429 = (_e4428 + _e4419);
            if _e4391 {
                if _e4385 {
                    let _e4432 = params.member.member_1.member_3;
                    let _e4435 = params.member.member_2.member;
                    if (_e4429 < _e4432) {
                        let _e4437 = (7u * _e4429);
                        atomicStore((&contacts.member[(4u + _e4437)]), _e4435);
                        atomicStore((&contacts.member[(_e4437 + 5u)]), _e4376.member);
                        atomicStore((&contacts.member[(_e4437 + 6u)]), _e4378.member);
                        atomicStore((&contacts.member[(_e4437 + 7u)]), _e4378.member_1);
                        atomicStore((&contacts.member[(_e4437 + 8u)]), _e4376.member_2[0]);
                        atomicStore((&contacts.member[(_e4437 + 9u)]), _e4376.member_2[1]);
                        atomicStore((&contacts.member[(_e4437 + 10u)]), _e4376.member_1);
                    }
                    phi_6983_ = false;
                } else {
                    phi_6983_ = true;
                }
                let _e4459 = phi_6983_;
                phi_6984_ = _e4459;
            } else {
                phi_6984_ = true;
            }
            let _e4461 = phi_6984_;
            if _e4461 {
                if _e4391 {
                    let _e4464 = params.member.member_2.member_1;
                    if (_e4429 < _e4464) {
                        let _e4466 = (2u * _e4429);
                        atomicStore((&contacts.member[(4u + _e4466)]), _e4378.member);
                        atomicStore((&contacts.member[(_e4466 + 5u)]), _e4378.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_439_ = type_9(select(_e164.member, (_e164.member + 1u), _e167), select(_e164.member_1, _e164.member_1, _e167));
            break if !(_e180);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
