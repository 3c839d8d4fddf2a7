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

struct type_14 {
    member: i32,
    member_1: i32,
}

struct type_15 {
    member: u32,
    member_1: i32,
}

struct type_17 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_23 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_25 {
    member: array<array<u32, 3>>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: f32,
    member_5: f32,
    member_6: f32,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
}

struct type_31 {
    member: type_7,
    member_1: type_8,
    member_2: type_30,
}

struct type_32 {
    member: type_31,
}

struct type_33 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 4>,
    member_5: array<u32, 4>,
}

struct type_35 {
    member: array<type_33>,
}

struct type_37 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_38 {
    member: f32,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

@group(0) @binding(1) 
var<storage> paths: type_19;
@group(0) @binding(0) 
var<storage> params: type_32;
@group(0) @binding(2) 
var<storage> edges: type_21;
@group(0) @binding(3) 
var<storage> faces: type_25;
@group(0) @binding(4) 
var<storage> contacts: type_11;
@group(0) @binding(5) 
var<storage, read_write> geometry: type_35;

fn function_(param: array<f32, 4>, param_1: u32) -> array<f32, 4> {
    var phi_4433_: array<f32, 4>;

    switch bitcast<i32>(param_1) {
        case 0: {
            phi_4433_ = param;
            break;
        }
        case 1: {
            phi_4433_ = array<f32, 4>(param[0], param[3], param[1], param[2]);
            break;
        }
        default: {
            phi_4433_ = array<f32, 4>(param[0], param[2], param[3], param[1]);
            break;
        }
    }
    let _e14 = phi_4433_;
    return _e14;
}

fn function_1(param_2: array<array<f32, 3>, 2>) -> array<f32, 3> {
    return array<f32, 3>((param_2[1][0] - param_2[0][0]), (param_2[1][1] - param_2[0][1]), (param_2[1][2] - param_2[0][2]));
}

fn function_2(param_3: type_38, param_4: type_38) -> type_38 {
    var phi_4401_: type_38;

    if (param_4.member_3 < param_3.member_3) {
        phi_4401_ = param_4;
    } else {
        phi_4401_ = param_3;
    }
    let _e6 = phi_4401_;
    return _e6;
}

fn function_3(param_5: f32, param_6: f32) -> f32 {
    let _e5 = select(param_6, param_5, (param_5 < param_6));
    return select(0f, select(0f, _e5, (_e5 > 0f)), (param_5 > 0f));
}

fn function_4(param_7: ptr<function, type_26>, param_8: f32, param_9: f32) -> f32 {
    let _e4 = (*param_7).member;
    let _e9 = (*param_7).member_2;
    let _e20 = (*param_7).member_1;
    let _e30 = (*param_7).member_1;
    let _e35 = (*param_7).member_1;
    let _e45 = function_3((((((_e4[0] - (_e9[0] * param_8)) * _e20[0]) + ((_e4[1] - (_e9[1] * param_8)) * _e20[1])) + ((_e4[2] - (_e9[2] * param_8)) * _e20[2])) / (((_e30[0] * _e35[0]) + (_e30[1] * _e35[1])) + (_e30[2] * _e35[2]))), param_9);
    return _e45;
}

fn function_5(param_10: ptr<function, type_26>, param_11: f32, param_12: f32) -> type_38 {
    let _e4 = (*param_10).member;
    let _e9 = (*param_10).member_1;
    let _e20 = (*param_10).member_2;
    let _e27 = ((_e4[0] - (_e9[0] * param_11)) - (_e20[0] * param_12));
    let _e28 = ((_e4[1] - (_e9[1] * param_11)) - (_e20[1] * param_12));
    let _e29 = ((_e4[2] - (_e9[2] * param_11)) - (_e20[2] * param_12));
    return type_38(param_11, param_12, array<f32, 3>(_e27, _e28, _e29), (((_e27 * _e27) + (_e28 * _e28)) + (_e29 * _e29)));
}

fn function_6(param_13: ptr<function, type_26>, param_14: f32, param_15: f32) -> f32 {
    let _e4 = (*param_13).member;
    let _e9 = (*param_13).member_1;
    let _e20 = (*param_13).member_2;
    let _e30 = (*param_13).member_2;
    let _e35 = (*param_13).member_2;
    let _e45 = function_3((((((_e4[0] - (_e9[0] * param_14)) * _e20[0]) + ((_e4[1] - (_e9[1] * param_14)) * _e20[1])) + ((_e4[2] - (_e9[2] * param_14)) * _e20[2])) / (((_e30[0] * _e35[0]) + (_e30[1] * _e35[1])) + (_e30[2] * _e35[2]))), param_15);
    return _e45;
}

fn function_7(param_16: ptr<function, type_26>, param_17: u32) -> type_38 {
    var phi_4118_: type_38;
    var phi_4119_: bool;
    var phi_4120_: type_38;
    var phi_4121_: bool;
    var phi_4003_: type_38;
    var phi_4004_: bool;
    var phi_4005_: type_38;
    var phi_4006_: bool;
    var phi_4007_: type_38;
    var phi_4008_: bool;
    var phi_4125_: type_38;
    var phi_4126_: bool;
    var phi_4201_: type_38;
    var phi_4202_: type_38;
    var phi_4203_: bool;
    var phi_4207_: type_38;

    let _e9 = (param_17 == 0u);
    let _e11 = (*param_16).member_4;
    if (_e11 > 0f) {
        let _e88 = (*param_16).member_3;
        let _e93 = (*param_16).member_3;
        let _e101 = (((_e88[0] * _e93[0]) + (_e88[1] * _e93[1])) + (_e88[2] * _e93[2]));
        let _e103 = (*param_16).member;
        let _e108 = (*param_16).member_2;
        let _e122 = (*param_16).member_3;
        let _e131 = ((((((_e103[1] * _e108[2]) - (_e103[2] * _e108[1])) * _e122[0]) + (((_e103[2] * _e108[0]) - (_e103[0] * _e108[2])) * _e122[1])) + (((_e103[0] * _e108[1]) - (_e103[1] * _e108[0])) * _e122[2])) / _e101);
        let _e133 = (*param_16).member_1;
        let _e138 = (*param_16).member;
        let _e152 = (*param_16).member_3;
        let _e161 = ((((((_e133[1] * _e138[2]) - (_e133[2] * _e138[1])) * _e152[0]) + (((_e133[2] * _e138[0]) - (_e133[0] * _e138[2])) * _e152[1])) + (((_e133[0] * _e138[1]) - (_e133[1] * _e138[0])) * _e152[2])) / _e101);
        if (_e131 >= 0f) {
            if (_e161 >= 0f) {
                if select(select(false, (_e161 <= 1f), (_e131 <= 1f)), ((_e131 + _e161) <= 1f), _e9) {
                    let _e172 = function_6(param_16, _e131, select(1f, (1f - _e131), _e9));
                    let _e175 = function_4(param_16, _e172, select(1f, (1f - _e172), _e9));
                    let _e176 = function_5(param_16, _e175, _e172);
                    phi_4003_ = _e176;
                    phi_4004_ = false;
                } else {
                    phi_4003_ = type_38();
                    phi_4004_ = true;
                }
                let _e178 = phi_4003_;
                let _e180 = phi_4004_;
                phi_4005_ = _e178;
                phi_4006_ = _e180;
            } else {
                phi_4005_ = type_38();
                phi_4006_ = true;
            }
            let _e182 = phi_4005_;
            let _e184 = phi_4006_;
            phi_4007_ = _e182;
            phi_4008_ = _e184;
        } else {
            phi_4007_ = type_38();
            phi_4008_ = true;
        }
        let _e186 = phi_4007_;
        let _e188 = phi_4008_;
        phi_4125_ = _e186;
        phi_4126_ = _e188;
    } else {
        if _e9 {
            phi_4120_ = type_38();
            phi_4121_ = true;
        } else {
            let _e14 = (*param_16).member;
            let _e19 = (*param_16).member_1;
            let _e27 = (((_e14[0] * _e19[0]) + (_e14[1] * _e19[1])) + (_e14[2] * _e19[2]));
            let _e29 = (*param_16).member;
            let _e34 = (*param_16).member_2;
            let _e42 = (*param_16).member_1;
            let _e50 = ((((_e29[0] - _e34[0]) * _e42[0]) + ((_e29[1] - _e34[1]) * _e42[1])) + ((_e29[2] - _e34[2]) * _e42[2]));
            let _e52 = (*param_16).member_1;
            let _e57 = (*param_16).member_1;
            let _e65 = (((_e52[0] * _e57[0]) + (_e52[1] * _e57[1])) + (_e52[2] * _e57[2]));
            let _e69 = function_3((select(_e50, _e27, (_e27 < _e50)) / _e65), 1f);
            let _e73 = function_3((select(_e50, _e27, (_e27 > _e50)) / _e65), 1f);
            if (_e69 < _e73) {
                let _e76 = ((_e69 + _e73) * 0.5f);
                let _e77 = function_6(param_16, _e76, 1f);
                let _e78 = function_5(param_16, _e76, _e77);
                phi_4118_ = _e78;
                phi_4119_ = false;
            } else {
                phi_4118_ = type_38();
                phi_4119_ = true;
            }
            let _e80 = phi_4118_;
            let _e82 = phi_4119_;
            phi_4120_ = _e80;
            phi_4121_ = _e82;
        }
        let _e84 = phi_4120_;
        let _e86 = phi_4121_;
        phi_4125_ = _e84;
        phi_4126_ = _e86;
    }
    let _e190 = phi_4125_;
    let _e192 = phi_4126_;
    if _e192 {
        let _e193 = function_4(param_16, 0f, 1f);
        let _e194 = function_5(param_16, _e193, 0f);
        let _e195 = function_6(param_16, 0f, 1f);
        let _e196 = function_5(param_16, 0f, _e195);
        let _e197 = function_2(_e194, _e196);
        if _e9 {
            let _e205 = (*param_16).member_2;
            let _e210 = (*param_16).member_1;
            let _e214 = (_e205[0] - _e210[0]);
            let _e215 = (_e205[1] - _e210[1]);
            let _e216 = (_e205[2] - _e210[2]);
            let _e218 = (*param_16).member;
            let _e223 = (*param_16).member_1;
            let _e241 = function_3((((((_e218[0] - _e223[0]) * _e214) + ((_e218[1] - _e223[1]) * _e215)) + ((_e218[2] - _e223[2]) * _e216)) / (((_e214 * _e214) + (_e215 * _e215)) + (_e216 * _e216))), 1f);
            let _e243 = function_5(param_16, (1f - _e241), _e241);
            let _e244 = function_2(_e197, _e243);
            phi_4201_ = _e244;
        } else {
            let _e198 = function_6(param_16, 1f, 1f);
            let _e199 = function_5(param_16, 1f, _e198);
            let _e200 = function_4(param_16, 1f, 1f);
            let _e201 = function_5(param_16, _e200, 1f);
            let _e202 = function_2(_e199, _e201);
            let _e203 = function_2(_e197, _e202);
            phi_4201_ = _e203;
        }
        let _e246 = phi_4201_;
        phi_4202_ = _e246;
        phi_4203_ = false;
    } else {
        phi_4202_ = type_38();
        phi_4203_ = true;
    }
    let _e248 = phi_4202_;
    let _e250 = phi_4203_;
    if _e250 {
        phi_4207_ = _e190;
    } else {
        phi_4207_ = _e248;
    }
    let _e252 = phi_4207_;
    return _e252;
}

fn function_8(param_18: f32) -> f32 {
    var phi_3836_: f32;
    var phi_3837_: f32;

    if ((bitcast<u32>(param_18) & 2139095040u) != 2139095040u) {
        if (param_18 >= 0.000000000000000000000000000000000000011754944f) {
            let _e13 = (2130706432u - (bitcast<u32>(param_18) & 2139095040u));
            phi_3836_ = bitcast<f32>(select(8388608u, _e13, (_e13 > 8388608u)));
        } else {
            phi_3836_ = (1f / 0.000000000000000000000000000000000000011754944f);
        }
        let _e18 = phi_3836_;
        phi_3837_ = _e18;
    } else {
        phi_3837_ = 1f;
    }
    let _e20 = phi_3837_;
    return _e20;
}

fn function_9(param_19: array<f32, 3>, param_20: array<f32, 3>, param_21: f32) -> array<f32, 3> {
    let _e4 = (1f - param_21);
    return array<f32, 3>(((param_19[0] * _e4) + (param_20[0] * param_21)), ((param_19[1] * _e4) + (param_20[1] * param_21)), ((param_19[2] * _e4) + (param_20[2] * param_21)));
}

fn function_10(param_22: ptr<function, array<array<f32, 3>, 4>>, param_23: u32) -> array<array<f32, 3>, 4> {
    var phi_3810_: array<array<f32, 3>, 4>;

    switch bitcast<i32>(param_23) {
        case 0: {
            let _e32 = (*param_22);
            phi_3810_ = array<array<f32, 3>, 4>(array<f32, 3>(_e32[0][0], _e32[0][1], _e32[0][2]), array<f32, 3>(_e32[1][0], _e32[1][1], _e32[1][2]), array<f32, 3>(_e32[2][0], _e32[2][1], _e32[2][2]), array<f32, 3>(_e32[3][0], _e32[3][1], _e32[3][2]));
            break;
        }
        case 1: {
            let _e8 = (*param_22)[0u];
            let _e14 = (*param_22)[2u];
            let _e20 = (*param_22)[3u];
            let _e26 = (*param_22)[1u];
            phi_3810_ = array<array<f32, 3>, 4>(array<f32, 3>(_e8[0], _e8[1], _e8[2]), array<f32, 3>(_e14[0], _e14[1], _e14[2]), array<f32, 3>(_e20[0], _e20[1], _e20[2]), array<f32, 3>(_e26[0], _e26[1], _e26[2]));
            break;
        }
        default: {
            let _e55 = (*param_22)[0u];
            let _e61 = (*param_22)[3u];
            let _e67 = (*param_22)[1u];
            let _e73 = (*param_22)[2u];
            phi_3810_ = array<array<f32, 3>, 4>(array<f32, 3>(_e55[0], _e55[1], _e55[2]), array<f32, 3>(_e61[0], _e61[1], _e61[2]), array<f32, 3>(_e67[0], _e67[1], _e67[2]), array<f32, 3>(_e73[0], _e73[1], _e73[2]));
            break;
        }
    }
    let _e80 = phi_3810_;
    return _e80;
}

fn function_11(param_24: ptr<function, array<array<f32, 3>, 4>>, param_25: ptr<function, array<array<f32, 3>, 4>>, param_26: f32) -> u32 {
    let _e11 = (*param_24)[3u];
    let _e16 = (*param_24)[2u];
    let _e25 = (*param_25)[3u];
    let _e30 = (*param_25)[2u];
    let _e38 = function_9(array<f32, 3>((_e11[0] - _e16[0]), (_e11[1] - _e16[1]), (_e11[2] - _e16[2])), array<f32, 3>((_e25[0] - _e30[0]), (_e25[1] - _e30[1]), (_e25[2] - _e30[2])), param_26);
    let _e52 = ((select(_e38[0], -(_e38[0]), (_e38[0] < 0f)) + select(_e38[1], -(_e38[1]), (_e38[1] < 0f))) + select(_e38[2], -(_e38[2]), (_e38[2] < 0f)));
    let _e54 = (*param_24)[1u];
    let _e59 = (*param_24)[3u];
    let _e68 = (*param_25)[1u];
    let _e73 = (*param_25)[3u];
    let _e81 = function_9(array<f32, 3>((_e54[0] - _e59[0]), (_e54[1] - _e59[1]), (_e54[2] - _e59[2])), array<f32, 3>((_e68[0] - _e73[0]), (_e68[1] - _e73[1]), (_e68[2] - _e73[2])), param_26);
    let _e95 = ((select(_e81[0], -(_e81[0]), (_e81[0] < 0f)) + select(_e81[1], -(_e81[1]), (_e81[1] < 0f))) + select(_e81[2], -(_e81[2]), (_e81[2] < 0f)));
    let _e97 = (*param_24)[2u];
    let _e102 = (*param_24)[1u];
    let _e111 = (*param_25)[2u];
    let _e116 = (*param_25)[1u];
    let _e124 = function_9(array<f32, 3>((_e97[0] - _e102[0]), (_e97[1] - _e102[1]), (_e97[2] - _e102[2])), array<f32, 3>((_e111[0] - _e116[0]), (_e111[1] - _e116[1]), (_e111[2] - _e116[2])), param_26);
    let _e138 = ((select(_e124[0], -(_e124[0]), (_e124[0] < 0f)) + select(_e124[1], -(_e124[1]), (_e124[1] < 0f))) + select(_e124[2], -(_e124[2]), (_e124[2] < 0f)));
    return select(0u, select(2u, 1u, (_e95 >= _e138)), select(true, select(true, false, (_e52 >= _e138)), (_e52 >= _e95)));
}

fn function_12(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var phi_195_: u32;
    var phi_240_: u32;
    var phi_243_: type_9;
    var phi_410_: type_23;
    var phi_568_: u32;
    var phi_729_: type_37;
    var phi_1185_: type_14;
    var phi_1188_: f32;
    var phi_1186_: type_14;
    var phi_1229_: type_15;
    var phi_1189_: f32;
    var local_3: f32;
    var phi_1242_: f32;
    var phi_1250_: f32;
    var phi_1305_: type_14;
    var phi_1308_: f32;
    var phi_1306_: type_14;
    var phi_1349_: type_15;
    var phi_1309_: f32;
    var local_4: f32;
    var phi_1362_: f32;
    var phi_1370_: f32;
    var phi_2063_: type_14;
    var phi_2066_: f32;
    var phi_2064_: type_14;
    var phi_2107_: type_15;
    var phi_2067_: f32;
    var local_5: f32;
    var phi_2120_: f32;
    var phi_2188_: array<f32, 3>;
    var phi_2189_: bool;
    var phi_2190_: array<f32, 3>;
    var phi_2191_: bool;
    var phi_2237_: array<f32, 3>;
    var phi_2238_: bool;
    var phi_2239_: array<f32, 3>;
    var phi_2240_: bool;
    var phi_2241_: array<f32, 3>;
    var phi_2242_: bool;
    var phi_2331_: bool;
    var phi_2341_: array<f32, 3>;
    var phi_2342_: bool;
    var phi_2343_: array<f32, 3>;
    var phi_2344_: bool;
    var phi_2358_: array<f32, 3>;
    var phi_2359_: array<f32, 3>;
    var phi_2360_: array<f32, 3>;
    var phi_2498_: type_14;
    var phi_2501_: f32;
    var phi_2499_: type_14;
    var phi_2542_: type_15;
    var phi_2502_: f32;
    var local_6: f32;
    var phi_2555_: f32;
    var phi_2582_: array<f32, 3>;
    var phi_2674_: type_14;
    var phi_2677_: f32;
    var phi_2675_: type_14;
    var phi_2718_: type_15;
    var phi_2678_: f32;
    var local_7: f32;
    var phi_2731_: f32;
    var phi_2747_: array<f32, 3>;
    var phi_2748_: bool;
    var phi_2749_: array<f32, 3>;
    var phi_2750_: bool;
    var phi_3033_: array<f32, 3>;
    var phi_3034_: bool;
    var phi_3045_: array<f32, 3>;
    var phi_3109_: type_14;
    var phi_3112_: f32;
    var phi_3110_: type_14;
    var phi_3153_: type_15;
    var phi_3113_: f32;
    var local_8: f32;
    var phi_3166_: f32;
    var phi_3253_: type_14;
    var phi_3256_: f32;
    var phi_3254_: type_14;
    var phi_3297_: type_15;
    var phi_3257_: f32;
    var local_9: f32;
    var phi_3310_: f32;
    var phi_3327_: array<f32, 3>;
    var phi_2814_: type_14;
    var phi_2817_: f32;
    var phi_2815_: type_14;
    var phi_2858_: type_15;
    var phi_2818_: f32;
    var local_10: f32;
    var phi_2871_: f32;
    var phi_3328_: array<f32, 3>;
    var phi_3350_: array<f32, 3>;
    var phi_3351_: bool;
    var phi_3352_: array<f32, 3>;
    var phi_3353_: array<f32, 3>;
    var phi_3354_: bool;
    var phi_1570_: type_14;
    var phi_1573_: f32;
    var phi_1571_: type_14;
    var phi_1614_: type_15;
    var phi_1574_: f32;
    var local_11: f32;
    var phi_1627_: f32;
    var phi_1643_: array<f32, 3>;
    var phi_1644_: bool;
    var phi_1645_: array<f32, 3>;
    var phi_1646_: bool;
    var phi_1647_: array<f32, 3>;
    var phi_1648_: bool;
    var phi_1709_: type_14;
    var phi_1712_: f32;
    var phi_1710_: type_14;
    var phi_1753_: type_15;
    var phi_1713_: f32;
    var local_12: f32;
    var phi_1766_: f32;
    var phi_1782_: array<f32, 3>;
    var phi_3358_: array<f32, 3>;
    var phi_3359_: array<f32, 3>;
    var phi_3360_: bool;
    var phi_3437_: array<f32, 3>;
    var phi_3438_: array<f32, 3>;
    var phi_3439_: array<f32, 4>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e53 = id_2;
    let _e54 = n_2;
    let _e55 = lane_2;
    let _e66 = ((_e53.y * _e54.x) + _e53.x);
    let _e69 = (_e54.x * _e54.y);
    let _e72 = params.member.member_1.member_2;
    let _e74 = contacts.member[0u];
    let _e76 = select(_e74, _e72, (_e72 < _e74));
    let _e78 = params.member.member_1.member_1;
    if (_e76 > _e78) {
        let _e81 = params.member.member_1.member_1;
        phi_195_ = (_e76 - _e81);
    } else {
        phi_195_ = 0u;
    }
    let _e84 = phi_195_;
    let _e86 = params.member.member_1.member;
    let _e88 = select(_e84, _e86, (_e86 < _e84));
    let _e89 = (_e88 / 64u);
    let _e93 = select(_e89, (_e89 + 1u), ((_e88 % 64u) > 0u));
    if (_e93 > _e66) {
        let _e95 = (_e93 - _e66);
        if (_e69 == 0u) {
            return;
        }
        let _e97 = (_e95 / _e69);
        if (_e69 == 0u) {
            return;
        }
        phi_240_ = select(_e97, (_e97 + 1u), ((_e95 % _e69) > 0u));
    } else {
        phi_240_ = 0u;
    }
    let _e104 = phi_240_;
    phi_243_ = type_9(0u, _e104);
    loop {
        let _e107 = phi_243_;
        let _e110 = (_e107.member < _e107.member_1);
        let _e123 = (bitcast<i32>(select(0u, 1u, _e110)) != 0i);
        if _e123 {
            let _e127 = (((_e66 + (select(type_9().member_1, _e107.member, _e110) * _e69)) * 64u) + _e55);
            if (_e127 < _e88) {
                let _e131 = params.member.member_1.member_1;
                let _e132 = (_e131 + _e127);
                let _e133 = (7u * _e132);
                let _e136 = contacts.member[(4u + _e133)];
                let _e139 = contacts.member[(_e133 + 5u)];
                let _e142 = contacts.member[(_e133 + 6u)];
                let _e145 = contacts.member[(_e133 + 7u)];
                let _e148 = contacts.member[(_e133 + 8u)];
                let _e151 = contacts.member[(_e133 + 9u)];
                if (_e136 == 0u) {
                    let _e164 = faces.member[_e145];
                    phi_410_ = type_23(0u, array<u32, 4>(_e142, _e164[0], _e164[1], _e164[2]));
                } else {
                    let _e154 = edges.member[_e142];
                    let _e156 = edges.member[_e145];
                    phi_410_ = type_23(1u, array<u32, 4>(_e154[0], _e154[1], _e156[0], _e156[1]));
                }
                let _e171 = phi_410_;
                let _e176 = paths.member[_e171.member_1[0]];
                let _e179 = paths.member[_e171.member_1[1]];
                let _e186 = paths.member[_e171.member_1[2]];
                let _e189 = paths.member[_e171.member_1[3]];
                local_1 = array<array<f32, 3>, 4>(array<f32, 3>(_e176.member[0], _e176.member[1], _e176.member[2]), array<f32, 3>(_e179.member[0], _e179.member[1], _e179.member[2]), array<f32, 3>(_e186.member[0], _e186.member[1], _e186.member[2]), array<f32, 3>(_e189.member[0], _e189.member[1], _e189.member[2]));
                local_2 = array<array<f32, 3>, 4>(array<f32, 3>(_e176.member_1[0], _e176.member_1[1], _e176.member_1[2]), array<f32, 3>(_e179.member_1[0], _e179.member_1[1], _e179.member_1[2]), array<f32, 3>(_e186.member_1[0], _e186.member_1[1], _e186.member_1[2]), array<f32, 3>(_e189.member_1[0], _e189.member_1[1], _e189.member_1[2]));
                let _e229 = (_e151 >> bitcast<u32>(20i));
                let _e241 = select(((((_e229 - 896u) << bitcast<u32>(23i)) | ((_e151 & 1048575u) << bitcast<u32>(3i))) | (_e148 >> bitcast<u32>(29i))), 0u, (_e229 <= 896u));
                let _e247 = params.member.member.member_4;
                let _e248 = function_3(select(1f, bitcast<f32>(_e241), (_e241 < 1065353216u)), 1f);
                if (_e171.member == 0u) {
                    let _e250 = function_11((&local_1), (&local_2), _e248);
                    phi_568_ = _e250;
                } else {
                    phi_568_ = 0u;
                }
                let _e252 = phi_568_;
                let _e253 = function_10((&local_1), _e252);
                let _e254 = function_10((&local_2), _e252);
                if (_e171.member != 0u) {
                    phi_729_ = type_37(array<array<f32, 3>, 2>(array<f32, 3>((_e253[2][0] - _e253[0][0]), (_e253[2][1] - _e253[0][1]), (_e253[2][2] - _e253[0][2])), array<f32, 3>((_e254[2][0] - _e254[0][0]), (_e254[2][1] - _e254[0][1]), (_e254[2][2] - _e254[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e253[1][0] - _e253[0][0]), (_e253[1][1] - _e253[0][1]), (_e253[1][2] - _e253[0][2])), array<f32, 3>((_e254[1][0] - _e254[0][0]), (_e254[1][1] - _e254[0][1]), (_e254[1][2] - _e254[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e253[2][0] - _e253[3][0]), (_e253[2][1] - _e253[3][1]), (_e253[2][2] - _e253[3][2])), array<f32, 3>((_e254[2][0] - _e254[3][0]), (_e254[2][1] - _e254[3][1]), (_e254[2][2] - _e254[3][2]))), (_e247 + _e247));
                } else {
                    phi_729_ = type_37(array<array<f32, 3>, 2>(array<f32, 3>((_e253[0][0] - _e253[1][0]), (_e253[0][1] - _e253[1][1]), (_e253[0][2] - _e253[1][2])), array<f32, 3>((_e254[0][0] - _e254[1][0]), (_e254[0][1] - _e254[1][1]), (_e254[0][2] - _e254[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e253[2][0] - _e253[1][0]), (_e253[2][1] - _e253[1][1]), (_e253[2][2] - _e253[1][2])), array<f32, 3>((_e254[2][0] - _e254[1][0]), (_e254[2][1] - _e254[1][1]), (_e254[2][2] - _e254[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e253[3][0] - _e253[1][0]), (_e253[3][1] - _e253[1][1]), (_e253[3][2] - _e253[1][2])), array<f32, 3>((_e254[3][0] - _e254[1][0]), (_e254[3][1] - _e254[1][1]), (_e254[3][2] - _e254[1][2]))), (_e247 + _e247));
                }
                let _e411 = phi_729_;
                let _e416 = function_9(_e411.member[0], _e411.member[1], _e248);
                let _e421 = function_9(_e411.member_1[0], _e411.member_1[1], _e248);
                let _e426 = function_9(_e411.member_2[0], _e411.member_2[1], _e248);
                let _e430 = select(_e416[0], -(_e416[0]), (_e416[0] < 0f));
                let _e434 = select(_e416[1], -(_e416[1]), (_e416[1] < 0f));
                let _e436 = select(_e434, _e430, (_e430 > _e434));
                let _e440 = select(_e416[2], -(_e416[2]), (_e416[2] < 0f));
                let _e442 = select(_e440, _e436, (_e436 > _e440));
                let _e446 = select(_e421[0], -(_e421[0]), (_e421[0] < 0f));
                let _e450 = select(_e421[1], -(_e421[1]), (_e421[1] < 0f));
                let _e452 = select(_e450, _e446, (_e446 > _e450));
                let _e456 = select(_e421[2], -(_e421[2]), (_e421[2] < 0f));
                let _e458 = select(_e456, _e452, (_e452 > _e456));
                let _e460 = select(_e458, _e442, (_e442 > _e458));
                let _e464 = select(_e426[0], -(_e426[0]), (_e426[0] < 0f));
                let _e468 = select(_e426[1], -(_e426[1]), (_e426[1] < 0f));
                let _e470 = select(_e468, _e464, (_e464 > _e468));
                let _e474 = select(_e426[2], -(_e426[2]), (_e426[2] < 0f));
                let _e476 = select(_e474, _e470, (_e470 > _e474));
                let _e479 = function_8(select(_e476, _e460, (_e460 > _e476)));
                let _e487 = (_e421[0] * _e479);
                let _e489 = (_e421[1] * _e479);
                let _e491 = (_e421[2] * _e479);
                let _e493 = (_e426[0] * _e479);
                let _e495 = (_e426[1] * _e479);
                let _e497 = (_e426[2] * _e479);
                let _e503 = select(_e411.member[0][0], -(_e411.member[0][0]), (_e411.member[0][0] < 0f));
                let _e507 = select(_e411.member[0][1], -(_e411.member[0][1]), (_e411.member[0][1] < 0f));
                let _e509 = select(_e507, _e503, (_e503 > _e507));
                let _e513 = select(_e411.member[0][2], -(_e411.member[0][2]), (_e411.member[0][2] < 0f));
                let _e515 = select(_e513, _e509, (_e509 > _e513));
                let _e521 = select(_e411.member[1][0], -(_e411.member[1][0]), (_e411.member[1][0] < 0f));
                let _e525 = select(_e411.member[1][1], -(_e411.member[1][1]), (_e411.member[1][1] < 0f));
                let _e527 = select(_e525, _e521, (_e521 > _e525));
                let _e531 = select(_e411.member[1][2], -(_e411.member[1][2]), (_e411.member[1][2] < 0f));
                let _e533 = select(_e531, _e527, (_e527 > _e531));
                let _e543 = select(_e411.member_1[0][0], -(_e411.member_1[0][0]), (_e411.member_1[0][0] < 0f));
                let _e547 = select(_e411.member_1[0][1], -(_e411.member_1[0][1]), (_e411.member_1[0][1] < 0f));
                let _e549 = select(_e547, _e543, (_e543 > _e547));
                let _e553 = select(_e411.member_1[0][2], -(_e411.member_1[0][2]), (_e411.member_1[0][2] < 0f));
                let _e555 = select(_e553, _e549, (_e549 > _e553));
                let _e561 = select(_e411.member_1[1][0], -(_e411.member_1[1][0]), (_e411.member_1[1][0] < 0f));
                let _e565 = select(_e411.member_1[1][1], -(_e411.member_1[1][1]), (_e411.member_1[1][1] < 0f));
                let _e567 = select(_e565, _e561, (_e561 > _e565));
                let _e571 = select(_e411.member_1[1][2], -(_e411.member_1[1][2]), (_e411.member_1[1][2] < 0f));
                let _e573 = select(_e571, _e567, (_e567 > _e571));
                let _e577 = (select(_e573, _e555, (_e555 > _e573)) + _e411.member_3);
                let _e583 = select(_e411.member_2[0][0], -(_e411.member_2[0][0]), (_e411.member_2[0][0] < 0f));
                let _e587 = select(_e411.member_2[0][1], -(_e411.member_2[0][1]), (_e411.member_2[0][1] < 0f));
                let _e589 = select(_e587, _e583, (_e583 > _e587));
                let _e593 = select(_e411.member_2[0][2], -(_e411.member_2[0][2]), (_e411.member_2[0][2] < 0f));
                let _e595 = select(_e593, _e589, (_e589 > _e593));
                let _e601 = select(_e411.member_2[1][0], -(_e411.member_2[1][0]), (_e411.member_2[1][0] < 0f));
                let _e605 = select(_e411.member_2[1][1], -(_e411.member_2[1][1]), (_e411.member_2[1][1] < 0f));
                let _e607 = select(_e605, _e601, (_e601 > _e605));
                let _e611 = select(_e411.member_2[1][2], -(_e411.member_2[1][2]), (_e411.member_2[1][2] < 0f));
                let _e613 = select(_e611, _e607, (_e607 > _e611));
                let _e617 = (select(_e613, _e595, (_e595 > _e613)) + _e411.member_3);
                let _e618 = (0.000000059604645f * 16f);
                let _e620 = (_e411.member_3 * 4f);
                let _e628 = ((_e489 * _e497) - (_e491 * _e495));
                let _e631 = ((_e491 * _e493) - (_e487 * _e497));
                let _e634 = ((_e487 * _e495) - (_e489 * _e493));
                let _e642 = select(_e493, -(_e493), (_e493 < 0f));
                let _e645 = select(_e495, -(_e495), (_e495 < 0f));
                let _e647 = select(_e645, _e642, (_e642 > _e645));
                let _e650 = select(_e497, -(_e497), (_e497 < 0f));
                let _e657 = select(_e487, -(_e487), (_e487 < 0f));
                let _e660 = select(_e489, -(_e489), (_e489 < 0f));
                let _e662 = select(_e660, _e657, (_e657 > _e660));
                let _e665 = select(_e491, -(_e491), (_e491 < 0f));
                let _e669 = (((((_e577 * _e618) + _e620) * _e479) * select(_e650, _e647, (_e647 > _e650))) + ((((_e617 * _e618) + _e620) * _e479) * select(_e665, _e662, (_e662 > _e665))));
                let _e674 = (((_e628 * _e628) + (_e631 * _e631)) + (_e634 * _e634));
                if (_e674 <= 0.000000000000000000000000000000000000011754944f) {
                    phi_1242_ = select(0f, (0.000000000000000000106433627f * 2f), (_e674 > 0f));
                } else {
                    phi_1185_ = type_14(0i, 5i);
                    phi_1188_ = bitcast<f32>(((bitcast<u32>(_e674) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e682 = phi_1185_;
                        let _e684 = phi_1188_;
                        local_3 = _e684;
                        if (_e682.member < _e682.member_1) {
                            let _e691 = (_e682.member + 1i);
                            phi_1186_ = type_14(select(_e691, type_15().member_1, select(false, true, ((false == (_e691 > _e682.member)) != false))), _e682.member_1);
                            phi_1229_ = type_15(1u, _e682.member);
                        } else {
                            phi_1186_ = _e682;
                            phi_1229_ = type_15(0u, type_15().member_1);
                        }
                        let _e702 = phi_1186_;
                        let _e704 = phi_1229_;
                        let _e707 = (bitcast<i32>(_e704.member) != 0i);
                        if _e707 {
                            phi_1189_ = (0.5f * (_e684 + (_e674 / _e684)));
                        } else {
                            phi_1189_ = f32();
                        }
                        let _e712 = phi_1189_;
                        continue;
                        continuing {
                            phi_1185_ = _e702;
                            phi_1188_ = _e712;
                            break if !(_e707);
                        }
                    }
                    let _e717 = local_3;
                    phi_1242_ = (_e717 * (1f + (8f * 0.000000059604645f)));
                }
                let _e723 = phi_1242_;
                if (_e723 > 0f) {
                    phi_1250_ = ((_e723 + (_e674 / _e723)) * 0.5f);
                } else {
                    phi_1250_ = _e723;
                }
                let _e729 = phi_1250_;
                local = type_26(array<f32, 3>((_e416[0] * _e479), (_e416[1] * _e479), (_e416[2] * _e479)), array<f32, 3>(_e487, _e489, _e491), array<f32, 3>(_e493, _e495, _e497), array<f32, 3>(_e628, _e631, _e634), select(0f, _e729, (_e729 > _e669)), _e669, ((((((select(_e533, _e515, (_e515 > _e533)) + _e411.member_3) + _e577) + _e617) * _e618) + _e620) * _e479));
                let _e737 = function_7((&local), _e171.member);
                if (_e737.member_3 <= 0.000000000000000000000000000000000000011754944f) {
                    phi_1362_ = select(0f, (0.000000000000000000106433627f * 2f), (_e737.member_3 > 0f));
                } else {
                    phi_1305_ = type_14(0i, 5i);
                    phi_1308_ = bitcast<f32>(((bitcast<u32>(_e737.member_3) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e748 = phi_1305_;
                        let _e750 = phi_1308_;
                        local_4 = _e750;
                        if (_e748.member < _e748.member_1) {
                            let _e757 = (_e748.member + 1i);
                            phi_1306_ = type_14(select(_e757, type_15().member_1, select(false, true, ((false == (_e757 > _e748.member)) != false))), _e748.member_1);
                            phi_1349_ = type_15(1u, _e748.member);
                        } else {
                            phi_1306_ = _e748;
                            phi_1349_ = type_15(0u, type_15().member_1);
                        }
                        let _e768 = phi_1306_;
                        let _e770 = phi_1349_;
                        let _e773 = (bitcast<i32>(_e770.member) != 0i);
                        if _e773 {
                            phi_1309_ = (0.5f * (_e750 + (_e737.member_3 / _e750)));
                        } else {
                            phi_1309_ = f32();
                        }
                        let _e778 = phi_1309_;
                        continue;
                        continuing {
                            phi_1305_ = _e768;
                            phi_1308_ = _e778;
                            break if !(_e773);
                        }
                    }
                    let _e783 = local_4;
                    phi_1362_ = (_e783 * (1f + (8f * 0.000000059604645f)));
                }
                let _e789 = phi_1362_;
                if (_e789 > 0f) {
                    phi_1370_ = ((_e789 + (_e737.member_3 / _e789)) * 0.5f);
                } else {
                    phi_1370_ = _e789;
                }
                let _e795 = phi_1370_;
                let _e798 = select(-(1f), 1f, (_e171.member == 0u));
                let _e800 = function_1(_e411.member);
                let _e802 = function_1(_e411.member_1);
                let _e816 = function_1(_e411.member_2);
                let _e826 = (((_e800[0] - (_e802[0] * _e737.member)) - (_e816[0] * _e737.member_1)) * _e798);
                let _e827 = (((_e800[1] - (_e802[1] * _e737.member)) - (_e816[1] * _e737.member_1)) * _e798);
                let _e828 = (((_e800[2] - (_e802[2] * _e737.member)) - (_e816[2] * _e737.member_1)) * _e798);
                let _e834 = select(false, (_e737.member < 1f), (_e737.member > 0f));
                let _e837 = select(false, (_e737.member_1 < 1f), (_e737.member_1 > 0f));
                let _e838 = (_e798 > 0f);
                let _e848 = select(select(bool(), select(bool(), select(true, ((_e737.member + _e737.member_1) < (1f - (0.000000059604645f * 4f))), _e838), _e837), _e834), false, select(true, select(true, false, _e837), _e834));
                let _e850 = local.member_4;
                let _e851 = (_e850 > 0f);
                let _e853 = local.member_3;
                let _e857 = (_e853[0] * _e798);
                let _e858 = (_e853[1] * _e798);
                let _e859 = (_e853[2] * _e798);
                let _e861 = local.member_6;
                if (_e795 > _e861) {
                    let _e1861 = (_e737.member_2[0] * _e798);
                    let _e1863 = (_e737.member_2[1] * _e798);
                    let _e1865 = (_e737.member_2[2] * _e798);
                    if _e851 {
                        if _e848 {
                            let _e1867 = local.member_5;
                            let _e1870 = local.member_6;
                            let _e1872 = local.member_4;
                            if ((_e1867 * _e795) <= (_e1870 * _e1872)) {
                                let _e1880 = ((((_e1861 * _e857) + (_e1863 * _e858)) + (_e1865 * _e859)) >= 0f);
                                let _e1881 = -(1f);
                                let _e1885 = select((_e857 * _e1881), _e857, _e1880);
                                let _e1886 = select((_e858 * _e1881), _e858, _e1880);
                                let _e1887 = select((_e859 * _e1881), _e859, _e1880);
                                let _e1890 = select(_e1885, -(_e1885), (_e1885 < 0f));
                                let _e1893 = select(_e1886, -(_e1886), (_e1886 < 0f));
                                let _e1895 = select(_e1893, _e1890, (_e1890 > _e1893));
                                let _e1898 = select(_e1887, -(_e1887), (_e1887 < 0f));
                                let _e1901 = function_8(select(_e1898, _e1895, (_e1895 > _e1898)));
                                let _e1902 = (_e1885 * _e1901);
                                let _e1903 = (_e1886 * _e1901);
                                let _e1904 = (_e1887 * _e1901);
                                let _e1909 = (((_e1902 * _e1902) + (_e1903 * _e1903)) + (_e1904 * _e1904));
                                if (_e1909 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_1627_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1909 > 0f));
                                } else {
                                    phi_1570_ = type_14(0i, 5i);
                                    phi_1573_ = bitcast<f32>(((bitcast<u32>(_e1909) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1917 = phi_1570_;
                                        let _e1919 = phi_1573_;
                                        local_11 = _e1919;
                                        if (_e1917.member < _e1917.member_1) {
                                            let _e1926 = (_e1917.member + 1i);
                                            phi_1571_ = type_14(select(_e1926, type_15().member_1, select(false, true, ((false == (_e1926 > _e1917.member)) != false))), _e1917.member_1);
                                            phi_1614_ = type_15(1u, _e1917.member);
                                        } else {
                                            phi_1571_ = _e1917;
                                            phi_1614_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1937 = phi_1571_;
                                        let _e1939 = phi_1614_;
                                        let _e1942 = (bitcast<i32>(_e1939.member) != 0i);
                                        if _e1942 {
                                            phi_1574_ = (0.5f * (_e1919 + (_e1909 / _e1919)));
                                        } else {
                                            phi_1574_ = f32();
                                        }
                                        let _e1947 = phi_1574_;
                                        continue;
                                        continuing {
                                            phi_1570_ = _e1937;
                                            phi_1573_ = _e1947;
                                            break if !(_e1942);
                                        }
                                    }
                                    let _e1952 = local_11;
                                    phi_1627_ = (_e1952 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1958 = phi_1627_;
                                let _e1959 = (1f / _e1958);
                                let _e1960 = (_e1902 * _e1959);
                                let _e1961 = (_e1903 * _e1959);
                                let _e1962 = (_e1904 * _e1959);
                                let _e1969 = ((3f - (((_e1960 * _e1960) + (_e1961 * _e1961)) + (_e1962 * _e1962))) * 0.5f);
                                phi_1643_ = array<f32, 3>((_e1960 * _e1969), (_e1961 * _e1969), (_e1962 * _e1969));
                                phi_1644_ = false;
                            } else {
                                phi_1643_ = array<f32, 3>();
                                phi_1644_ = true;
                            }
                            let _e1975 = phi_1643_;
                            let _e1977 = phi_1644_;
                            phi_1645_ = _e1975;
                            phi_1646_ = _e1977;
                        } else {
                            phi_1645_ = array<f32, 3>();
                            phi_1646_ = true;
                        }
                        let _e1979 = phi_1645_;
                        let _e1981 = phi_1646_;
                        phi_1647_ = _e1979;
                        phi_1648_ = _e1981;
                    } else {
                        phi_1647_ = array<f32, 3>();
                        phi_1648_ = true;
                    }
                    let _e1983 = phi_1647_;
                    let _e1985 = phi_1648_;
                    if _e1985 {
                        let _e1988 = select(_e1861, -(_e1861), (_e1861 < 0f));
                        let _e1991 = select(_e1863, -(_e1863), (_e1863 < 0f));
                        let _e1993 = select(_e1991, _e1988, (_e1988 > _e1991));
                        let _e1996 = select(_e1865, -(_e1865), (_e1865 < 0f));
                        let _e1999 = function_8(select(_e1996, _e1993, (_e1993 > _e1996)));
                        let _e2000 = (_e1861 * _e1999);
                        let _e2001 = (_e1863 * _e1999);
                        let _e2002 = (_e1865 * _e1999);
                        let _e2007 = (((_e2000 * _e2000) + (_e2001 * _e2001)) + (_e2002 * _e2002));
                        if (_e2007 <= 0.000000000000000000000000000000000000011754944f) {
                            phi_1766_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2007 > 0f));
                        } else {
                            phi_1709_ = type_14(0i, 5i);
                            phi_1712_ = bitcast<f32>(((bitcast<u32>(_e2007) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e2015 = phi_1709_;
                                let _e2017 = phi_1712_;
                                local_12 = _e2017;
                                if (_e2015.member < _e2015.member_1) {
                                    let _e2024 = (_e2015.member + 1i);
                                    phi_1710_ = type_14(select(_e2024, type_15().member_1, select(false, true, ((false == (_e2024 > _e2015.member)) != false))), _e2015.member_1);
                                    phi_1753_ = type_15(1u, _e2015.member);
                                } else {
                                    phi_1710_ = _e2015;
                                    phi_1753_ = type_15(0u, type_15().member_1);
                                }
                                let _e2035 = phi_1710_;
                                let _e2037 = phi_1753_;
                                let _e2040 = (bitcast<i32>(_e2037.member) != 0i);
                                if _e2040 {
                                    phi_1713_ = (0.5f * (_e2017 + (_e2007 / _e2017)));
                                } else {
                                    phi_1713_ = f32();
                                }
                                let _e2045 = phi_1713_;
                                continue;
                                continuing {
                                    phi_1709_ = _e2035;
                                    phi_1712_ = _e2045;
                                    break if !(_e2040);
                                }
                            }
                            let _e2050 = local_12;
                            phi_1766_ = (_e2050 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e2056 = phi_1766_;
                        let _e2057 = (1f / _e2056);
                        let _e2058 = (_e2000 * _e2057);
                        let _e2059 = (_e2001 * _e2057);
                        let _e2060 = (_e2002 * _e2057);
                        let _e2067 = ((3f - (((_e2058 * _e2058) + (_e2059 * _e2059)) + (_e2060 * _e2060))) * 0.5f);
                        phi_1782_ = array<f32, 3>((_e2058 * _e2067), (_e2059 * _e2067), (_e2060 * _e2067));
                    } else {
                        phi_1782_ = _e1983;
                    }
                    let _e2073 = phi_1782_;
                    phi_3358_ = _e2073;
                    phi_3359_ = array<f32, 3>();
                    phi_3360_ = true;
                } else {
                    let _e868 = select(_e411.member[0][0], -(_e411.member[0][0]), (_e411.member[0][0] < 0f));
                    let _e872 = select(_e411.member[0][1], -(_e411.member[0][1]), (_e411.member[0][1] < 0f));
                    let _e874 = select(_e872, _e868, (_e868 > _e872));
                    let _e878 = select(_e411.member[0][2], -(_e411.member[0][2]), (_e411.member[0][2] < 0f));
                    let _e880 = select(_e878, _e874, (_e874 > _e878));
                    let _e886 = select(_e411.member[1][0], -(_e411.member[1][0]), (_e411.member[1][0] < 0f));
                    let _e890 = select(_e411.member[1][1], -(_e411.member[1][1]), (_e411.member[1][1] < 0f));
                    let _e892 = select(_e890, _e886, (_e886 > _e890));
                    let _e896 = select(_e411.member[1][2], -(_e411.member[1][2]), (_e411.member[1][2] < 0f));
                    let _e898 = select(_e896, _e892, (_e892 > _e896));
                    let _e908 = select(_e411.member_1[0][0], -(_e411.member_1[0][0]), (_e411.member_1[0][0] < 0f));
                    let _e912 = select(_e411.member_1[0][1], -(_e411.member_1[0][1]), (_e411.member_1[0][1] < 0f));
                    let _e914 = select(_e912, _e908, (_e908 > _e912));
                    let _e918 = select(_e411.member_1[0][2], -(_e411.member_1[0][2]), (_e411.member_1[0][2] < 0f));
                    let _e920 = select(_e918, _e914, (_e914 > _e918));
                    let _e926 = select(_e411.member_1[1][0], -(_e411.member_1[1][0]), (_e411.member_1[1][0] < 0f));
                    let _e930 = select(_e411.member_1[1][1], -(_e411.member_1[1][1]), (_e411.member_1[1][1] < 0f));
                    let _e932 = select(_e930, _e926, (_e926 > _e930));
                    let _e936 = select(_e411.member_1[1][2], -(_e411.member_1[1][2]), (_e411.member_1[1][2] < 0f));
                    let _e938 = select(_e936, _e932, (_e932 > _e936));
                    let _e948 = select(_e411.member_2[0][0], -(_e411.member_2[0][0]), (_e411.member_2[0][0] < 0f));
                    let _e952 = select(_e411.member_2[0][1], -(_e411.member_2[0][1]), (_e411.member_2[0][1] < 0f));
                    let _e954 = select(_e952, _e948, (_e948 > _e952));
                    let _e958 = select(_e411.member_2[0][2], -(_e411.member_2[0][2]), (_e411.member_2[0][2] < 0f));
                    let _e960 = select(_e958, _e954, (_e954 > _e958));
                    let _e966 = select(_e411.member_2[1][0], -(_e411.member_2[1][0]), (_e411.member_2[1][0] < 0f));
                    let _e970 = select(_e411.member_2[1][1], -(_e411.member_2[1][1]), (_e411.member_2[1][1] < 0f));
                    let _e972 = select(_e970, _e966, (_e966 > _e970));
                    let _e976 = select(_e411.member_2[1][2], -(_e411.member_2[1][2]), (_e411.member_2[1][2] < 0f));
                    let _e978 = select(_e976, _e972, (_e972 > _e976));
                    let _e989 = (((((select(_e898, _e880, (_e880 > _e898)) + _e411.member_3) + (select(_e938, _e920, (_e920 > _e938)) + _e411.member_3)) + (select(_e978, _e960, (_e960 > _e978)) + _e411.member_3)) * (0.000000059604645f * 32f)) + (_e411.member_3 * 8f));
                    if _e851 {
                        let _e992 = select(_e857, -(_e857), (_e857 < 0f));
                        let _e995 = select(_e858, -(_e858), (_e858 < 0f));
                        let _e997 = select(_e995, _e992, (_e992 > _e995));
                        let _e1000 = select(_e859, -(_e859), (_e859 < 0f));
                        let _e1003 = function_8(select(_e1000, _e997, (_e997 > _e1000)));
                        let _e1004 = (_e857 * _e1003);
                        let _e1005 = (_e858 * _e1003);
                        let _e1006 = (_e859 * _e1003);
                        let _e1011 = (((_e1004 * _e1004) + (_e1005 * _e1005)) + (_e1006 * _e1006));
                        if (_e1011 <= 0.000000000000000000000000000000000000011754944f) {
                            phi_2120_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1011 > 0f));
                        } else {
                            phi_2063_ = type_14(0i, 5i);
                            phi_2066_ = bitcast<f32>(((bitcast<u32>(_e1011) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e1019 = phi_2063_;
                                let _e1021 = phi_2066_;
                                local_5 = _e1021;
                                if (_e1019.member < _e1019.member_1) {
                                    let _e1028 = (_e1019.member + 1i);
                                    phi_2064_ = type_14(select(_e1028, type_15().member_1, select(false, true, ((false == (_e1028 > _e1019.member)) != false))), _e1019.member_1);
                                    phi_2107_ = type_15(1u, _e1019.member);
                                } else {
                                    phi_2064_ = _e1019;
                                    phi_2107_ = type_15(0u, type_15().member_1);
                                }
                                let _e1039 = phi_2064_;
                                let _e1041 = phi_2107_;
                                let _e1044 = (bitcast<i32>(_e1041.member) != 0i);
                                if _e1044 {
                                    phi_2067_ = (0.5f * (_e1021 + (_e1011 / _e1021)));
                                } else {
                                    phi_2067_ = f32();
                                }
                                let _e1049 = phi_2067_;
                                continue;
                                continuing {
                                    phi_2063_ = _e1039;
                                    phi_2066_ = _e1049;
                                    break if !(_e1044);
                                }
                            }
                            let _e1054 = local_5;
                            phi_2120_ = (_e1054 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e1060 = phi_2120_;
                        let _e1061 = (1f / _e1060);
                        let _e1062 = (_e1004 * _e1061);
                        let _e1063 = (_e1005 * _e1061);
                        let _e1064 = (_e1006 * _e1061);
                        let _e1071 = ((3f - (((_e1062 * _e1062) + (_e1063 * _e1063)) + (_e1064 * _e1064))) * 0.5f);
                        let _e1072 = (_e1062 * _e1071);
                        let _e1073 = (_e1063 * _e1071);
                        let _e1074 = (_e1064 * _e1071);
                        let _e1079 = (((_e826 * _e1072) + (_e827 * _e1073)) + (_e828 * _e1074));
                        let _e1092 = local.member_5;
                        let _e1094 = local.member_4;
                        if (select(_e1079, -(_e1079), (_e1079 < 0f)) > (_e989 + (((select(_e826, -(_e826), (_e826 < 0f)) + select(_e827, -(_e827), (_e827 < 0f))) + select(_e828, -(_e828), (_e828 < 0f))) * (_e1092 / _e1094)))) {
                            let _e1102 = (_e1079 < 0f);
                            let _e1103 = -(1f);
                            phi_2188_ = array<f32, 3>(select((_e1072 * _e1103), _e1072, _e1102), select((_e1073 * _e1103), _e1073, _e1102), select((_e1074 * _e1103), _e1074, _e1102));
                            phi_2189_ = false;
                        } else {
                            phi_2188_ = array<f32, 3>();
                            phi_2189_ = true;
                        }
                        let _e1112 = phi_2188_;
                        let _e1114 = phi_2189_;
                        phi_2190_ = _e1112;
                        phi_2191_ = _e1114;
                    } else {
                        phi_2190_ = array<f32, 3>();
                        phi_2191_ = true;
                    }
                    let _e1116 = phi_2190_;
                    let _e1118 = phi_2191_;
                    if _e1118 {
                        if select(true, select(true, false, _e848), _e851) {
                            if _e838 {
                                if _e834 {
                                    if _e837 {
                                        let _e1122 = local.member_2;
                                        let _e1127 = local.member_1;
                                        phi_2237_ = array<f32, 3>((_e1122[0] - _e1127[0]), (_e1122[1] - _e1127[1]), (_e1122[2] - _e1127[2]));
                                        phi_2238_ = false;
                                    } else {
                                        phi_2237_ = array<f32, 3>();
                                        phi_2238_ = true;
                                    }
                                    let _e1136 = phi_2237_;
                                    let _e1138 = phi_2238_;
                                    phi_2239_ = _e1136;
                                    phi_2240_ = _e1138;
                                } else {
                                    phi_2239_ = array<f32, 3>();
                                    phi_2240_ = true;
                                }
                                let _e1140 = phi_2239_;
                                let _e1142 = phi_2240_;
                                phi_2241_ = _e1140;
                                phi_2242_ = _e1142;
                            } else {
                                phi_2241_ = array<f32, 3>();
                                phi_2242_ = true;
                            }
                            let _e1144 = phi_2241_;
                            let _e1146 = phi_2242_;
                            if _e1146 {
                                if _e834 {
                                    if _e837 {
                                        let _e1148 = local.member_2;
                                        let _e1154 = select(_e1148[0], -(_e1148[0]), (_e1148[0] < 0f));
                                        let _e1157 = select(_e1148[1], -(_e1148[1]), (_e1148[1] < 0f));
                                        let _e1159 = select(_e1157, _e1154, (_e1154 > _e1157));
                                        let _e1162 = select(_e1148[2], -(_e1148[2]), (_e1148[2] < 0f));
                                        let _e1166 = local.member_1;
                                        let _e1172 = select(_e1166[0], -(_e1166[0]), (_e1166[0] < 0f));
                                        let _e1175 = select(_e1166[1], -(_e1166[1]), (_e1166[1] < 0f));
                                        let _e1177 = select(_e1175, _e1172, (_e1172 > _e1175));
                                        let _e1180 = select(_e1166[2], -(_e1166[2]), (_e1166[2] < 0f));
                                        phi_2331_ = select(true, false, (select(_e1162, _e1159, (_e1159 > _e1162)) > select(_e1180, _e1177, (_e1177 > _e1180))));
                                    } else {
                                        phi_2331_ = true;
                                    }
                                    let _e1186 = phi_2331_;
                                    if _e1186 {
                                        let _e1188 = local.member_1;
                                        phi_2341_ = array<f32, 3>(_e1188[0], _e1188[1], _e1188[2]);
                                        phi_2342_ = false;
                                    } else {
                                        phi_2341_ = array<f32, 3>();
                                        phi_2342_ = true;
                                    }
                                    let _e1194 = phi_2341_;
                                    let _e1196 = phi_2342_;
                                    phi_2343_ = _e1194;
                                    phi_2344_ = _e1196;
                                } else {
                                    phi_2343_ = array<f32, 3>();
                                    phi_2344_ = true;
                                }
                                let _e1198 = phi_2343_;
                                let _e1200 = phi_2344_;
                                if _e1200 {
                                    if _e837 {
                                        let _e1202 = local.member_2;
                                        phi_2358_ = array<f32, 3>(_e1202[0], _e1202[1], _e1202[2]);
                                    } else {
                                        phi_2358_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e1208 = phi_2358_;
                                    phi_2359_ = _e1208;
                                } else {
                                    phi_2359_ = _e1198;
                                }
                                let _e1210 = phi_2359_;
                                phi_2360_ = _e1210;
                            } else {
                                phi_2360_ = _e1144;
                            }
                            let _e1212 = phi_2360_;
                            let _e1216 = select(_e1212[0], -(_e1212[0]), (_e1212[0] < 0f));
                            let _e1220 = select(_e1212[1], -(_e1212[1]), (_e1212[1] < 0f));
                            let _e1222 = select(_e1220, _e1216, (_e1216 > _e1220));
                            let _e1226 = select(_e1212[2], -(_e1212[2]), (_e1212[2] < 0f));
                            let _e1230 = local.member_6;
                            let _e1231 = (select(_e1226, _e1222, (_e1222 > _e1226)) > _e1230);
                            let _e1233 = select(0f, _e1212[0], _e1231);
                            let _e1235 = select(0f, _e1212[1], _e1231);
                            let _e1237 = select(0f, _e1212[2], _e1231);
                            let _e1240 = select(_e1233, -(_e1233), (_e1233 < 0f));
                            let _e1243 = select(_e1235, -(_e1235), (_e1235 < 0f));
                            let _e1245 = select(_e1243, _e1240, (_e1240 > _e1243));
                            let _e1248 = select(_e1237, -(_e1237), (_e1237 < 0f));
                            if (select(_e1248, _e1245, (_e1245 > _e1248)) > 0f) {
                                let _e1254 = select(_e1233, -(_e1233), (_e1233 < 0f));
                                let _e1257 = select(_e1235, -(_e1235), (_e1235 < 0f));
                                let _e1259 = select(_e1257, _e1254, (_e1254 > _e1257));
                                let _e1262 = select(_e1237, -(_e1237), (_e1237 < 0f));
                                let _e1265 = function_8(select(_e1262, _e1259, (_e1259 > _e1262)));
                                let _e1266 = (_e1233 * _e1265);
                                let _e1267 = (_e1235 * _e1265);
                                let _e1268 = (_e1237 * _e1265);
                                let _e1273 = (((_e1266 * _e1266) + (_e1267 * _e1267)) + (_e1268 * _e1268));
                                if (_e1273 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_2555_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1273 > 0f));
                                } else {
                                    phi_2498_ = type_14(0i, 5i);
                                    phi_2501_ = bitcast<f32>(((bitcast<u32>(_e1273) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1281 = phi_2498_;
                                        let _e1283 = phi_2501_;
                                        local_6 = _e1283;
                                        if (_e1281.member < _e1281.member_1) {
                                            let _e1290 = (_e1281.member + 1i);
                                            phi_2499_ = type_14(select(_e1290, type_15().member_1, select(false, true, ((false == (_e1290 > _e1281.member)) != false))), _e1281.member_1);
                                            phi_2542_ = type_15(1u, _e1281.member);
                                        } else {
                                            phi_2499_ = _e1281;
                                            phi_2542_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1301 = phi_2499_;
                                        let _e1303 = phi_2542_;
                                        let _e1306 = (bitcast<i32>(_e1303.member) != 0i);
                                        if _e1306 {
                                            phi_2502_ = (0.5f * (_e1283 + (_e1273 / _e1283)));
                                        } else {
                                            phi_2502_ = f32();
                                        }
                                        let _e1311 = phi_2502_;
                                        continue;
                                        continuing {
                                            phi_2498_ = _e1301;
                                            phi_2501_ = _e1311;
                                            break if !(_e1306);
                                        }
                                    }
                                    let _e1316 = local_6;
                                    phi_2555_ = (_e1316 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1322 = phi_2555_;
                                let _e1323 = (1f / _e1322);
                                let _e1324 = (_e1266 * _e1323);
                                let _e1325 = (_e1267 * _e1323);
                                let _e1326 = (_e1268 * _e1323);
                                let _e1333 = ((3f - (((_e1324 * _e1324) + (_e1325 * _e1325)) + (_e1326 * _e1326))) * 0.5f);
                                let _e1334 = (_e1324 * _e1333);
                                let _e1335 = (_e1325 * _e1333);
                                let _e1336 = (_e1326 * _e1333);
                                let _e1341 = (((_e826 * _e1334) + (_e827 * _e1335)) + (_e828 * _e1336));
                                phi_2582_ = array<f32, 3>((_e826 - (_e1334 * _e1341)), (_e827 - (_e1335 * _e1341)), (_e828 - (_e1336 * _e1341)));
                            } else {
                                phi_2582_ = array<f32, 3>(_e826, _e827, _e828);
                            }
                            let _e1350 = phi_2582_;
                            if (((select(_e1350[0], -(_e1350[0]), (_e1350[0] < 0f)) + select(_e1350[1], -(_e1350[1]), (_e1350[1] < 0f))) + select(_e1350[2], -(_e1350[2]), (_e1350[2] < 0f))) > _e989) {
                                let _e1366 = -(1f);
                                let _e1368 = (_e1350[0] * _e1366);
                                let _e1370 = (_e1350[1] * _e1366);
                                let _e1372 = (_e1350[2] * _e1366);
                                let _e1375 = select(_e1368, -(_e1368), (_e1368 < 0f));
                                let _e1378 = select(_e1370, -(_e1370), (_e1370 < 0f));
                                let _e1380 = select(_e1378, _e1375, (_e1375 > _e1378));
                                let _e1383 = select(_e1372, -(_e1372), (_e1372 < 0f));
                                let _e1386 = function_8(select(_e1383, _e1380, (_e1380 > _e1383)));
                                let _e1387 = (_e1368 * _e1386);
                                let _e1388 = (_e1370 * _e1386);
                                let _e1389 = (_e1372 * _e1386);
                                let _e1394 = (((_e1387 * _e1387) + (_e1388 * _e1388)) + (_e1389 * _e1389));
                                if (_e1394 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_2731_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1394 > 0f));
                                } else {
                                    phi_2674_ = type_14(0i, 5i);
                                    phi_2677_ = bitcast<f32>(((bitcast<u32>(_e1394) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1402 = phi_2674_;
                                        let _e1404 = phi_2677_;
                                        local_7 = _e1404;
                                        if (_e1402.member < _e1402.member_1) {
                                            let _e1411 = (_e1402.member + 1i);
                                            phi_2675_ = type_14(select(_e1411, type_15().member_1, select(false, true, ((false == (_e1411 > _e1402.member)) != false))), _e1402.member_1);
                                            phi_2718_ = type_15(1u, _e1402.member);
                                        } else {
                                            phi_2675_ = _e1402;
                                            phi_2718_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1422 = phi_2675_;
                                        let _e1424 = phi_2718_;
                                        let _e1427 = (bitcast<i32>(_e1424.member) != 0i);
                                        if _e1427 {
                                            phi_2678_ = (0.5f * (_e1404 + (_e1394 / _e1404)));
                                        } else {
                                            phi_2678_ = f32();
                                        }
                                        let _e1432 = phi_2678_;
                                        continue;
                                        continuing {
                                            phi_2674_ = _e1422;
                                            phi_2677_ = _e1432;
                                            break if !(_e1427);
                                        }
                                    }
                                    let _e1437 = local_7;
                                    phi_2731_ = (_e1437 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1443 = phi_2731_;
                                let _e1444 = (1f / _e1443);
                                let _e1445 = (_e1387 * _e1444);
                                let _e1446 = (_e1388 * _e1444);
                                let _e1447 = (_e1389 * _e1444);
                                let _e1454 = ((3f - (((_e1445 * _e1445) + (_e1446 * _e1446)) + (_e1447 * _e1447))) * 0.5f);
                                phi_2747_ = array<f32, 3>((_e1445 * _e1454), (_e1446 * _e1454), (_e1447 * _e1454));
                                phi_2748_ = false;
                            } else {
                                phi_2747_ = array<f32, 3>();
                                phi_2748_ = true;
                            }
                            let _e1460 = phi_2747_;
                            let _e1462 = phi_2748_;
                            phi_2749_ = _e1460;
                            phi_2750_ = _e1462;
                        } else {
                            phi_2749_ = array<f32, 3>();
                            phi_2750_ = true;
                        }
                        let _e1464 = phi_2749_;
                        let _e1466 = phi_2750_;
                        if _e1466 {
                            if _e851 {
                                let _e1740 = select(_e857, -(_e857), (_e857 < 0f));
                                let _e1743 = select(_e858, -(_e858), (_e858 < 0f));
                                let _e1745 = select(_e1743, _e1740, (_e1740 > _e1743));
                                let _e1748 = select(_e859, -(_e859), (_e859 < 0f));
                                let _e1751 = function_8(select(_e1748, _e1745, (_e1745 > _e1748)));
                                let _e1752 = (_e857 * _e1751);
                                let _e1753 = (_e858 * _e1751);
                                let _e1754 = (_e859 * _e1751);
                                let _e1759 = (((_e1752 * _e1752) + (_e1753 * _e1753)) + (_e1754 * _e1754));
                                if (_e1759 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_2871_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1759 > 0f));
                                } else {
                                    phi_2814_ = type_14(0i, 5i);
                                    phi_2817_ = bitcast<f32>(((bitcast<u32>(_e1759) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1767 = phi_2814_;
                                        let _e1769 = phi_2817_;
                                        local_10 = _e1769;
                                        if (_e1767.member < _e1767.member_1) {
                                            let _e1776 = (_e1767.member + 1i);
                                            phi_2815_ = type_14(select(_e1776, type_15().member_1, select(false, true, ((false == (_e1776 > _e1767.member)) != false))), _e1767.member_1);
                                            phi_2858_ = type_15(1u, _e1767.member);
                                        } else {
                                            phi_2815_ = _e1767;
                                            phi_2858_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1787 = phi_2815_;
                                        let _e1789 = phi_2858_;
                                        let _e1792 = (bitcast<i32>(_e1789.member) != 0i);
                                        if _e1792 {
                                            phi_2818_ = (0.5f * (_e1769 + (_e1759 / _e1769)));
                                        } else {
                                            phi_2818_ = f32();
                                        }
                                        let _e1797 = phi_2818_;
                                        continue;
                                        continuing {
                                            phi_2814_ = _e1787;
                                            phi_2817_ = _e1797;
                                            break if !(_e1792);
                                        }
                                    }
                                    let _e1802 = local_10;
                                    phi_2871_ = (_e1802 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1808 = phi_2871_;
                                let _e1809 = (1f / _e1808);
                                let _e1810 = (_e1752 * _e1809);
                                let _e1811 = (_e1753 * _e1809);
                                let _e1812 = (_e1754 * _e1809);
                                let _e1819 = ((3f - (((_e1810 * _e1810) + (_e1811 * _e1811)) + (_e1812 * _e1812))) * 0.5f);
                                phi_3328_ = array<f32, 3>((_e1810 * _e1819), (_e1811 * _e1819), (_e1812 * _e1819));
                            } else {
                                let _e1468 = local.member_1;
                                let _e1473 = local.member_2;
                                let _e1479 = select(_e1473[0], -(_e1473[0]), (_e1473[0] < 0f));
                                let _e1482 = select(_e1473[1], -(_e1473[1]), (_e1473[1] < 0f));
                                let _e1484 = select(_e1482, _e1479, (_e1479 > _e1482));
                                let _e1487 = select(_e1473[2], -(_e1473[2]), (_e1473[2] < 0f));
                                let _e1492 = select(_e1468[0], -(_e1468[0]), (_e1468[0] < 0f));
                                let _e1495 = select(_e1468[1], -(_e1468[1]), (_e1468[1] < 0f));
                                let _e1497 = select(_e1495, _e1492, (_e1492 > _e1495));
                                let _e1500 = select(_e1468[2], -(_e1468[2]), (_e1468[2] < 0f));
                                let _e1503 = (select(_e1487, _e1484, (_e1484 > _e1487)) > select(_e1500, _e1497, (_e1497 > _e1500)));
                                let _e1504 = select(_e1468[0], _e1473[0], _e1503);
                                let _e1505 = select(_e1468[1], _e1473[1], _e1503);
                                let _e1506 = select(_e1468[2], _e1473[2], _e1503);
                                let _e1509 = select(_e1504, -(_e1504), (_e1504 < 0f));
                                let _e1512 = select(_e1505, -(_e1505), (_e1505 < 0f));
                                let _e1514 = select(_e1512, _e1509, (_e1509 > _e1512));
                                let _e1517 = select(_e1506, -(_e1506), (_e1506 < 0f));
                                if (select(_e1517, _e1514, (_e1514 > _e1517)) > 0f) {
                                    let _e1523 = select(_e1504, -(_e1504), (_e1504 < 0f));
                                    let _e1526 = select(_e1505, -(_e1505), (_e1505 < 0f));
                                    let _e1529 = select(_e1506, -(_e1506), (_e1506 < 0f));
                                    if (_e1523 <= _e1526) {
                                        let _e1531 = (_e1523 <= _e1529);
                                        phi_3033_ = array<f32, 3>(select(array<f32, 3>()[0], 1f, _e1531), select(array<f32, 3>()[1], 0f, _e1531), select(array<f32, 3>()[2], 0f, _e1531));
                                        phi_3034_ = select(true, false, _e1531);
                                    } else {
                                        phi_3033_ = array<f32, 3>();
                                        phi_3034_ = true;
                                    }
                                    let _e1541 = phi_3033_;
                                    let _e1543 = phi_3034_;
                                    if _e1543 {
                                        let _e1544 = (_e1526 <= _e1529);
                                        phi_3045_ = array<f32, 3>(0f, select(0f, 1f, _e1544), select(1f, 0f, _e1544));
                                    } else {
                                        phi_3045_ = _e1541;
                                    }
                                    let _e1549 = phi_3045_;
                                    let _e1552 = select(_e1504, -(_e1504), (_e1504 < 0f));
                                    let _e1555 = select(_e1505, -(_e1505), (_e1505 < 0f));
                                    let _e1557 = select(_e1555, _e1552, (_e1552 > _e1555));
                                    let _e1560 = select(_e1506, -(_e1506), (_e1506 < 0f));
                                    let _e1563 = function_8(select(_e1560, _e1557, (_e1557 > _e1560)));
                                    let _e1564 = (_e1504 * _e1563);
                                    let _e1565 = (_e1505 * _e1563);
                                    let _e1566 = (_e1506 * _e1563);
                                    let _e1571 = (((_e1564 * _e1564) + (_e1565 * _e1565)) + (_e1566 * _e1566));
                                    if (_e1571 <= 0.000000000000000000000000000000000000011754944f) {
                                        phi_3166_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1571 > 0f));
                                    } else {
                                        phi_3109_ = type_14(0i, 5i);
                                        phi_3112_ = bitcast<f32>(((bitcast<u32>(_e1571) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1579 = phi_3109_;
                                            let _e1581 = phi_3112_;
                                            local_8 = _e1581;
                                            if (_e1579.member < _e1579.member_1) {
                                                let _e1588 = (_e1579.member + 1i);
                                                phi_3110_ = type_14(select(_e1588, type_15().member_1, select(false, true, ((false == (_e1588 > _e1579.member)) != false))), _e1579.member_1);
                                                phi_3153_ = type_15(1u, _e1579.member);
                                            } else {
                                                phi_3110_ = _e1579;
                                                phi_3153_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1599 = phi_3110_;
                                            let _e1601 = phi_3153_;
                                            let _e1604 = (bitcast<i32>(_e1601.member) != 0i);
                                            if _e1604 {
                                                phi_3113_ = (0.5f * (_e1581 + (_e1571 / _e1581)));
                                            } else {
                                                phi_3113_ = f32();
                                            }
                                            let _e1609 = phi_3113_;
                                            continue;
                                            continuing {
                                                phi_3109_ = _e1599;
                                                phi_3112_ = _e1609;
                                                break if !(_e1604);
                                            }
                                        }
                                        let _e1614 = local_8;
                                        phi_3166_ = (_e1614 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1620 = phi_3166_;
                                    let _e1621 = (1f / _e1620);
                                    let _e1622 = (_e1564 * _e1621);
                                    let _e1623 = (_e1565 * _e1621);
                                    let _e1624 = (_e1566 * _e1621);
                                    let _e1631 = ((3f - (((_e1622 * _e1622) + (_e1623 * _e1623)) + (_e1624 * _e1624))) * 0.5f);
                                    let _e1632 = (_e1622 * _e1631);
                                    let _e1633 = (_e1623 * _e1631);
                                    let _e1634 = (_e1624 * _e1631);
                                    let _e1639 = ((_e1633 * _e1549[2]) - (_e1634 * _e1549[1]));
                                    let _e1644 = ((_e1634 * _e1549[0]) - (_e1632 * _e1549[2]));
                                    let _e1649 = ((_e1632 * _e1549[1]) - (_e1633 * _e1549[0]));
                                    let _e1652 = select(_e1639, -(_e1639), (_e1639 < 0f));
                                    let _e1655 = select(_e1644, -(_e1644), (_e1644 < 0f));
                                    let _e1657 = select(_e1655, _e1652, (_e1652 > _e1655));
                                    let _e1660 = select(_e1649, -(_e1649), (_e1649 < 0f));
                                    let _e1663 = function_8(select(_e1660, _e1657, (_e1657 > _e1660)));
                                    let _e1664 = (_e1639 * _e1663);
                                    let _e1665 = (_e1644 * _e1663);
                                    let _e1666 = (_e1649 * _e1663);
                                    let _e1671 = (((_e1664 * _e1664) + (_e1665 * _e1665)) + (_e1666 * _e1666));
                                    if (_e1671 <= 0.000000000000000000000000000000000000011754944f) {
                                        phi_3310_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1671 > 0f));
                                    } else {
                                        phi_3253_ = type_14(0i, 5i);
                                        phi_3256_ = bitcast<f32>(((bitcast<u32>(_e1671) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1679 = phi_3253_;
                                            let _e1681 = phi_3256_;
                                            local_9 = _e1681;
                                            if (_e1679.member < _e1679.member_1) {
                                                let _e1688 = (_e1679.member + 1i);
                                                phi_3254_ = type_14(select(_e1688, type_15().member_1, select(false, true, ((false == (_e1688 > _e1679.member)) != false))), _e1679.member_1);
                                                phi_3297_ = type_15(1u, _e1679.member);
                                            } else {
                                                phi_3254_ = _e1679;
                                                phi_3297_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1699 = phi_3254_;
                                            let _e1701 = phi_3297_;
                                            let _e1704 = (bitcast<i32>(_e1701.member) != 0i);
                                            if _e1704 {
                                                phi_3257_ = (0.5f * (_e1681 + (_e1671 / _e1681)));
                                            } else {
                                                phi_3257_ = f32();
                                            }
                                            let _e1709 = phi_3257_;
                                            continue;
                                            continuing {
                                                phi_3253_ = _e1699;
                                                phi_3256_ = _e1709;
                                                break if !(_e1704);
                                            }
                                        }
                                        let _e1714 = local_9;
                                        phi_3310_ = (_e1714 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1720 = phi_3310_;
                                    let _e1721 = (1f / _e1720);
                                    let _e1722 = (_e1664 * _e1721);
                                    let _e1723 = (_e1665 * _e1721);
                                    let _e1724 = (_e1666 * _e1721);
                                    let _e1731 = ((3f - (((_e1722 * _e1722) + (_e1723 * _e1723)) + (_e1724 * _e1724))) * 0.5f);
                                    phi_3327_ = array<f32, 3>((_e1722 * _e1731), (_e1723 * _e1731), (_e1724 * _e1731));
                                } else {
                                    phi_3327_ = array<f32, 3>(1f, 0f, 0f);
                                }
                                let _e1737 = phi_3327_;
                                phi_3328_ = _e1737;
                            }
                            let _e1825 = phi_3328_;
                            let _e1834 = ((((_e826 * _e1825[0]) + (_e827 * _e1825[1])) + (_e828 * _e1825[2])) > _e989);
                            let _e1835 = -(1f);
                            phi_3350_ = array<f32, 3>(select(_e1825[0], (_e1825[0] * _e1835), _e1834), select(_e1825[1], (_e1825[1] * _e1835), _e1834), select(_e1825[2], (_e1825[2] * _e1835), _e1834));
                            phi_3351_ = false;
                        } else {
                            phi_3350_ = array<f32, 3>();
                            phi_3351_ = true;
                        }
                        let _e1850 = phi_3350_;
                        let _e1852 = phi_3351_;
                        phi_3352_ = _e1850;
                        phi_3353_ = _e1464;
                        phi_3354_ = _e1852;
                    } else {
                        phi_3352_ = array<f32, 3>();
                        phi_3353_ = _e1116;
                        phi_3354_ = true;
                    }
                    let _e1854 = phi_3352_;
                    let _e1856 = phi_3353_;
                    let _e1858 = phi_3354_;
                    phi_3358_ = _e1856;
                    phi_3359_ = _e1854;
                    phi_3360_ = _e1858;
                }
                let _e2075 = phi_3358_;
                let _e2077 = phi_3359_;
                let _e2079 = phi_3360_;
                let _e2082 = select(_e2077[0], _e2075[0], _e2079);
                let _e2085 = select(_e2077[1], _e2075[1], _e2079);
                let _e2088 = select(_e2077[2], _e2075[2], _e2079);
                let _e2094 = ((((_e2082 * _e2082) + (_e2085 * _e2085)) + (_e2088 * _e2088)) > 0.5f);
                let _e2101 = function_9(_e253[0], _e254[0], _e248);
                let _e2104 = function_9(_e253[1], _e254[1], _e248);
                let _e2107 = function_9(_e253[2], _e254[2], _e248);
                let _e2110 = function_9(_e253[3], _e254[3], _e248);
                if (_e171.member != 0u) {
                    let _e2146 = function_9(_e2101, _e2104, _e737.member);
                    let _e2147 = function_9(_e2107, _e2110, _e737.member_1);
                    phi_3437_ = _e2147;
                    phi_3438_ = _e2146;
                    phi_3439_ = array<f32, 4>((1f - _e737.member), _e737.member, (1f - _e737.member_1), _e737.member_1);
                } else {
                    let _e2113 = ((1f - _e737.member) - _e737.member_1);
                    let _e2115 = select(0f, _e2113, (_e2113 > 0f));
                    let _e2142 = function_(array<f32, 4>(1f, _e2115, _e737.member, _e737.member_1), _e252);
                    phi_3437_ = array<f32, 3>((((_e2104[0] * _e2115) + (_e2107[0] * _e737.member)) + (_e2110[0] * _e737.member_1)), (((_e2104[1] * _e2115) + (_e2107[1] * _e737.member)) + (_e2110[1] * _e737.member_1)), (((_e2104[2] * _e2115) + (_e2107[2] * _e737.member)) + (_e2110[2] * _e737.member_1)));
                    phi_3438_ = _e2101;
                    phi_3439_ = _e2142;
                }
                let _e2149 = phi_3437_;
                let _e2151 = phi_3438_;
                let _e2153 = phi_3439_;
                let _e2154 = function_9(_e2151, _e2149, 0.5f);
                let _e2158 = params.member.member_2.member;
                let _e2161 = params.member.member_2.member_1;
                geometry.member[_e132] = type_33(array<f32, 3>(((_e2154[0] * _e2161) + _e2158[0]), ((_e2154[1] * _e2161) + _e2158[1]), ((_e2154[2] * _e2161) + _e2158[2])), ((_e795 / _e479) * _e2161), array<f32, 3>(select(1f, _e2082, _e2094), select(0f, _e2085, _e2094), select(0f, _e2088, _e2094)), _e139, _e2153, _e171.member_1);
            }
        }
        continue;
        continuing {
            phi_243_ = type_9(select(_e107.member, (_e107.member + 1u), _e110), select(_e107.member_1, _e107.member_1, _e110));
            break if !(_e123);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn contact_geometry(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_12(id, n, lane);
}
