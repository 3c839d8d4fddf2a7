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
    member: u32,
    member_1: array<u32, 4>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: f32,
    member_5: f32,
    member_6: f32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
}

struct type_27 {
    member: type_7,
    member_1: type_8,
    member_2: type_26,
}

struct type_28 {
    member: type_27,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 4>,
    member_5: array<u32, 4>,
}

struct type_31 {
    member: array<type_29>,
}

struct type_33 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_34 {
    member: f32,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

@group(0) @binding(1) 
var<storage> paths: type_19;
@group(0) @binding(2) 
var<storage> elements: type_11;
@group(0) @binding(0) 
var<storage> params: type_28;
@group(0) @binding(3) 
var<storage> contacts: type_11;
@group(0) @binding(4) 
var<storage, read_write> geometry: type_31;

fn function_(param: array<f32, 4>, param_1: u32) -> array<f32, 4> {
    var phi_4466_: array<f32, 4>;

    switch bitcast<i32>(param_1) {
        case 0: {
            phi_4466_ = param;
            break;
        }
        case 1: {
            phi_4466_ = array<f32, 4>(param[0], param[3], param[1], param[2]);
            break;
        }
        default: {
            phi_4466_ = array<f32, 4>(param[0], param[2], param[3], param[1]);
            break;
        }
    }
    let _e14 = phi_4466_;
    return _e14;
}

fn function_1(param_2: array<array<f32, 3>, 2>) -> array<f32, 3> {
    return array<f32, 3>((param_2[1][0] - param_2[0][0]), (param_2[1][1] - param_2[0][1]), (param_2[1][2] - param_2[0][2]));
}

fn function_2(param_3: type_34, param_4: type_34) -> type_34 {
    var phi_4434_: type_34;

    if (param_4.member_3 < param_3.member_3) {
        phi_4434_ = param_4;
    } else {
        phi_4434_ = param_3;
    }
    let _e6 = phi_4434_;
    return _e6;
}

fn function_3(param_5: f32, param_6: f32) -> f32 {
    let _e5 = select(param_6, param_5, (param_5 < param_6));
    return select(0f, select(0f, _e5, (_e5 > 0f)), (param_5 > 0f));
}

fn function_4(param_7: ptr<function, type_22>, param_8: f32, param_9: f32) -> f32 {
    let _e4 = (*param_7).member;
    let _e9 = (*param_7).member_2;
    let _e20 = (*param_7).member_1;
    let _e30 = (*param_7).member_1;
    let _e35 = (*param_7).member_1;
    let _e45 = function_3((((((_e4[0] - (_e9[0] * param_8)) * _e20[0]) + ((_e4[1] - (_e9[1] * param_8)) * _e20[1])) + ((_e4[2] - (_e9[2] * param_8)) * _e20[2])) / (((_e30[0] * _e35[0]) + (_e30[1] * _e35[1])) + (_e30[2] * _e35[2]))), param_9);
    return _e45;
}

fn function_5(param_10: ptr<function, type_22>, param_11: f32, param_12: f32) -> type_34 {
    let _e4 = (*param_10).member;
    let _e9 = (*param_10).member_1;
    let _e20 = (*param_10).member_2;
    let _e27 = ((_e4[0] - (_e9[0] * param_11)) - (_e20[0] * param_12));
    let _e28 = ((_e4[1] - (_e9[1] * param_11)) - (_e20[1] * param_12));
    let _e29 = ((_e4[2] - (_e9[2] * param_11)) - (_e20[2] * param_12));
    return type_34(param_11, param_12, array<f32, 3>(_e27, _e28, _e29), (((_e27 * _e27) + (_e28 * _e28)) + (_e29 * _e29)));
}

fn function_6(param_13: ptr<function, type_22>, param_14: f32, param_15: f32) -> f32 {
    let _e4 = (*param_13).member;
    let _e9 = (*param_13).member_1;
    let _e20 = (*param_13).member_2;
    let _e30 = (*param_13).member_2;
    let _e35 = (*param_13).member_2;
    let _e45 = function_3((((((_e4[0] - (_e9[0] * param_14)) * _e20[0]) + ((_e4[1] - (_e9[1] * param_14)) * _e20[1])) + ((_e4[2] - (_e9[2] * param_14)) * _e20[2])) / (((_e30[0] * _e35[0]) + (_e30[1] * _e35[1])) + (_e30[2] * _e35[2]))), param_15);
    return _e45;
}

fn function_7(param_16: ptr<function, type_22>, param_17: u32) -> type_34 {
    var phi_4151_: type_34;
    var phi_4152_: bool;
    var phi_4153_: type_34;
    var phi_4154_: bool;
    var phi_4036_: type_34;
    var phi_4037_: bool;
    var phi_4038_: type_34;
    var phi_4039_: bool;
    var phi_4040_: type_34;
    var phi_4041_: bool;
    var phi_4158_: type_34;
    var phi_4159_: bool;
    var phi_4234_: type_34;
    var phi_4235_: type_34;
    var phi_4236_: bool;
    var phi_4240_: type_34;

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
                    phi_4036_ = _e176;
                    phi_4037_ = false;
                } else {
                    phi_4036_ = type_34();
                    phi_4037_ = true;
                }
                let _e178 = phi_4036_;
                let _e180 = phi_4037_;
                phi_4038_ = _e178;
                phi_4039_ = _e180;
            } else {
                phi_4038_ = type_34();
                phi_4039_ = true;
            }
            let _e182 = phi_4038_;
            let _e184 = phi_4039_;
            phi_4040_ = _e182;
            phi_4041_ = _e184;
        } else {
            phi_4040_ = type_34();
            phi_4041_ = true;
        }
        let _e186 = phi_4040_;
        let _e188 = phi_4041_;
        phi_4158_ = _e186;
        phi_4159_ = _e188;
    } else {
        if _e9 {
            phi_4153_ = type_34();
            phi_4154_ = true;
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
                phi_4151_ = _e78;
                phi_4152_ = false;
            } else {
                phi_4151_ = type_34();
                phi_4152_ = true;
            }
            let _e80 = phi_4151_;
            let _e82 = phi_4152_;
            phi_4153_ = _e80;
            phi_4154_ = _e82;
        }
        let _e84 = phi_4153_;
        let _e86 = phi_4154_;
        phi_4158_ = _e84;
        phi_4159_ = _e86;
    }
    let _e190 = phi_4158_;
    let _e192 = phi_4159_;
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
            phi_4234_ = _e244;
        } else {
            let _e198 = function_6(param_16, 1f, 1f);
            let _e199 = function_5(param_16, 1f, _e198);
            let _e200 = function_4(param_16, 1f, 1f);
            let _e201 = function_5(param_16, _e200, 1f);
            let _e202 = function_2(_e199, _e201);
            let _e203 = function_2(_e197, _e202);
            phi_4234_ = _e203;
        }
        let _e246 = phi_4234_;
        phi_4235_ = _e246;
        phi_4236_ = false;
    } else {
        phi_4235_ = type_34();
        phi_4236_ = true;
    }
    let _e248 = phi_4235_;
    let _e250 = phi_4236_;
    if _e250 {
        phi_4240_ = _e190;
    } else {
        phi_4240_ = _e248;
    }
    let _e252 = phi_4240_;
    return _e252;
}

fn function_8(param_18: f32) -> f32 {
    var phi_3869_: f32;
    var phi_3870_: f32;

    if ((bitcast<u32>(param_18) & 2139095040u) != 2139095040u) {
        if (param_18 >= 0.000000000000000000000000000000000000011754944f) {
            let _e13 = (2130706432u - (bitcast<u32>(param_18) & 2139095040u));
            phi_3869_ = bitcast<f32>(select(8388608u, _e13, (_e13 > 8388608u)));
        } else {
            phi_3869_ = (1f / 0.000000000000000000000000000000000000011754944f);
        }
        let _e18 = phi_3869_;
        phi_3870_ = _e18;
    } else {
        phi_3870_ = 1f;
    }
    let _e20 = phi_3870_;
    return _e20;
}

fn function_9(param_19: array<f32, 3>, param_20: array<f32, 3>, param_21: f32) -> array<f32, 3> {
    let _e4 = (1f - param_21);
    return array<f32, 3>(((param_19[0] * _e4) + (param_20[0] * param_21)), ((param_19[1] * _e4) + (param_20[1] * param_21)), ((param_19[2] * _e4) + (param_20[2] * param_21)));
}

fn function_10(param_22: ptr<function, array<array<f32, 3>, 4>>, param_23: u32) -> array<array<f32, 3>, 4> {
    var phi_3843_: array<array<f32, 3>, 4>;

    switch bitcast<i32>(param_23) {
        case 0: {
            let _e32 = (*param_22);
            phi_3843_ = array<array<f32, 3>, 4>(array<f32, 3>(_e32[0][0], _e32[0][1], _e32[0][2]), array<f32, 3>(_e32[1][0], _e32[1][1], _e32[1][2]), array<f32, 3>(_e32[2][0], _e32[2][1], _e32[2][2]), array<f32, 3>(_e32[3][0], _e32[3][1], _e32[3][2]));
            break;
        }
        case 1: {
            let _e8 = (*param_22)[0u];
            let _e14 = (*param_22)[2u];
            let _e20 = (*param_22)[3u];
            let _e26 = (*param_22)[1u];
            phi_3843_ = array<array<f32, 3>, 4>(array<f32, 3>(_e8[0], _e8[1], _e8[2]), array<f32, 3>(_e14[0], _e14[1], _e14[2]), array<f32, 3>(_e20[0], _e20[1], _e20[2]), array<f32, 3>(_e26[0], _e26[1], _e26[2]));
            break;
        }
        default: {
            let _e55 = (*param_22)[0u];
            let _e61 = (*param_22)[3u];
            let _e67 = (*param_22)[1u];
            let _e73 = (*param_22)[2u];
            phi_3843_ = array<array<f32, 3>, 4>(array<f32, 3>(_e55[0], _e55[1], _e55[2]), array<f32, 3>(_e61[0], _e61[1], _e61[2]), array<f32, 3>(_e67[0], _e67[1], _e67[2]), array<f32, 3>(_e73[0], _e73[1], _e73[2]));
            break;
        }
    }
    let _e80 = phi_3843_;
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
    var local: type_22;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var phi_183_: u32;
    var phi_228_: u32;
    var phi_231_: type_9;
    var phi_443_: type_21;
    var phi_601_: u32;
    var phi_762_: type_33;
    var phi_1218_: type_14;
    var phi_1221_: f32;
    var phi_1219_: type_14;
    var phi_1262_: type_15;
    var phi_1222_: f32;
    var local_3: f32;
    var phi_1275_: f32;
    var phi_1283_: f32;
    var phi_1338_: type_14;
    var phi_1341_: f32;
    var phi_1339_: type_14;
    var phi_1382_: type_15;
    var phi_1342_: f32;
    var local_4: f32;
    var phi_1395_: f32;
    var phi_1403_: f32;
    var phi_2096_: type_14;
    var phi_2099_: f32;
    var phi_2097_: type_14;
    var phi_2140_: type_15;
    var phi_2100_: f32;
    var local_5: f32;
    var phi_2153_: f32;
    var phi_2221_: array<f32, 3>;
    var phi_2222_: bool;
    var phi_2223_: array<f32, 3>;
    var phi_2224_: bool;
    var phi_2270_: array<f32, 3>;
    var phi_2271_: bool;
    var phi_2272_: array<f32, 3>;
    var phi_2273_: bool;
    var phi_2274_: array<f32, 3>;
    var phi_2275_: bool;
    var phi_2364_: bool;
    var phi_2374_: array<f32, 3>;
    var phi_2375_: bool;
    var phi_2376_: array<f32, 3>;
    var phi_2377_: bool;
    var phi_2391_: array<f32, 3>;
    var phi_2392_: array<f32, 3>;
    var phi_2393_: array<f32, 3>;
    var phi_2531_: type_14;
    var phi_2534_: f32;
    var phi_2532_: type_14;
    var phi_2575_: type_15;
    var phi_2535_: f32;
    var local_6: f32;
    var phi_2588_: f32;
    var phi_2615_: array<f32, 3>;
    var phi_2707_: type_14;
    var phi_2710_: f32;
    var phi_2708_: type_14;
    var phi_2751_: type_15;
    var phi_2711_: f32;
    var local_7: f32;
    var phi_2764_: f32;
    var phi_2780_: array<f32, 3>;
    var phi_2781_: bool;
    var phi_2782_: array<f32, 3>;
    var phi_2783_: bool;
    var phi_3066_: array<f32, 3>;
    var phi_3067_: bool;
    var phi_3078_: array<f32, 3>;
    var phi_3142_: type_14;
    var phi_3145_: f32;
    var phi_3143_: type_14;
    var phi_3186_: type_15;
    var phi_3146_: f32;
    var local_8: f32;
    var phi_3199_: f32;
    var phi_3286_: type_14;
    var phi_3289_: f32;
    var phi_3287_: type_14;
    var phi_3330_: type_15;
    var phi_3290_: f32;
    var local_9: f32;
    var phi_3343_: f32;
    var phi_3360_: array<f32, 3>;
    var phi_2847_: type_14;
    var phi_2850_: f32;
    var phi_2848_: type_14;
    var phi_2891_: type_15;
    var phi_2851_: f32;
    var local_10: f32;
    var phi_2904_: f32;
    var phi_3361_: array<f32, 3>;
    var phi_3383_: array<f32, 3>;
    var phi_3384_: bool;
    var phi_3385_: array<f32, 3>;
    var phi_3386_: array<f32, 3>;
    var phi_3387_: bool;
    var phi_1603_: type_14;
    var phi_1606_: f32;
    var phi_1604_: type_14;
    var phi_1647_: type_15;
    var phi_1607_: f32;
    var local_11: f32;
    var phi_1660_: f32;
    var phi_1676_: array<f32, 3>;
    var phi_1677_: bool;
    var phi_1678_: array<f32, 3>;
    var phi_1679_: bool;
    var phi_1680_: array<f32, 3>;
    var phi_1681_: bool;
    var phi_1742_: type_14;
    var phi_1745_: f32;
    var phi_1743_: type_14;
    var phi_1786_: type_15;
    var phi_1746_: f32;
    var local_12: f32;
    var phi_1799_: f32;
    var phi_1815_: array<f32, 3>;
    var phi_3391_: array<f32, 3>;
    var phi_3392_: array<f32, 3>;
    var phi_3393_: bool;
    var phi_3470_: array<f32, 3>;
    var phi_3471_: array<f32, 3>;
    var phi_3472_: array<f32, 4>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e54 = id_2;
    let _e55 = n_2;
    let _e56 = lane_2;
    let _e66 = ((_e54.y * _e55.x) + _e54.x);
    let _e69 = (_e55.x * _e55.y);
    let _e72 = params.member.member_1.member_2;
    let _e74 = contacts.member[0u];
    let _e76 = select(_e74, _e72, (_e72 < _e74));
    let _e78 = params.member.member_1.member_1;
    if (_e76 > _e78) {
        let _e81 = params.member.member_1.member_1;
        phi_183_ = (_e76 - _e81);
    } else {
        phi_183_ = 0u;
    }
    let _e84 = phi_183_;
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
        phi_228_ = select(_e97, (_e97 + 1u), ((_e95 % _e69) > 0u));
    } else {
        phi_228_ = 0u;
    }
    let _e104 = phi_228_;
    phi_231_ = type_9(0u, _e104);
    loop {
        let _e107 = phi_231_;
        let _e110 = (_e107.member < _e107.member_1);
        let _e123 = (bitcast<i32>(select(0u, 1u, _e110)) != 0i);
        if _e123 {
            let _e127 = (((_e66 + (select(type_9().member_1, _e107.member, _e110) * _e69)) * 64u) + _e56);
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
                    let _e170 = params.member.member.member[1u];
                    let _e173 = ((2u * _e170) + (3u * _e145));
                    let _e175 = elements.member[_e173];
                    let _e178 = elements.member[(_e173 + 1u)];
                    let _e181 = elements.member[(_e173 + 2u)];
                    phi_443_ = type_21(0u, array<u32, 4>(_e142, _e175, _e178, _e181));
                } else {
                    let _e154 = (2u * _e142);
                    let _e156 = elements.member[_e154];
                    let _e159 = elements.member[(_e154 + 1u)];
                    let _e160 = (2u * _e145);
                    let _e162 = elements.member[_e160];
                    let _e165 = elements.member[(_e160 + 1u)];
                    phi_443_ = type_21(1u, array<u32, 4>(_e156, _e159, _e162, _e165));
                }
                let _e185 = phi_443_;
                let _e190 = paths.member[_e185.member_1[0]];
                let _e193 = paths.member[_e185.member_1[1]];
                let _e200 = paths.member[_e185.member_1[2]];
                let _e203 = paths.member[_e185.member_1[3]];
                local_1 = array<array<f32, 3>, 4>(array<f32, 3>(_e190.member[0], _e190.member[1], _e190.member[2]), array<f32, 3>(_e193.member[0], _e193.member[1], _e193.member[2]), array<f32, 3>(_e200.member[0], _e200.member[1], _e200.member[2]), array<f32, 3>(_e203.member[0], _e203.member[1], _e203.member[2]));
                local_2 = array<array<f32, 3>, 4>(array<f32, 3>(_e190.member_1[0], _e190.member_1[1], _e190.member_1[2]), array<f32, 3>(_e193.member_1[0], _e193.member_1[1], _e193.member_1[2]), array<f32, 3>(_e200.member_1[0], _e200.member_1[1], _e200.member_1[2]), array<f32, 3>(_e203.member_1[0], _e203.member_1[1], _e203.member_1[2]));
                let _e243 = (_e151 >> bitcast<u32>(20i));
                let _e255 = select(((((_e243 - 896u) << bitcast<u32>(23i)) | ((_e151 & 1048575u) << bitcast<u32>(3i))) | (_e148 >> bitcast<u32>(29i))), 0u, (_e243 <= 896u));
                let _e261 = params.member.member.member_4;
                let _e262 = function_3(select(1f, bitcast<f32>(_e255), (_e255 < 1065353216u)), 1f);
                if (_e185.member == 0u) {
                    let _e264 = function_11((&local_1), (&local_2), _e262);
                    phi_601_ = _e264;
                } else {
                    phi_601_ = 0u;
                }
                let _e266 = phi_601_;
                let _e267 = function_10((&local_1), _e266);
                let _e268 = function_10((&local_2), _e266);
                if (_e185.member != 0u) {
                    phi_762_ = type_33(array<array<f32, 3>, 2>(array<f32, 3>((_e267[2][0] - _e267[0][0]), (_e267[2][1] - _e267[0][1]), (_e267[2][2] - _e267[0][2])), array<f32, 3>((_e268[2][0] - _e268[0][0]), (_e268[2][1] - _e268[0][1]), (_e268[2][2] - _e268[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e267[1][0] - _e267[0][0]), (_e267[1][1] - _e267[0][1]), (_e267[1][2] - _e267[0][2])), array<f32, 3>((_e268[1][0] - _e268[0][0]), (_e268[1][1] - _e268[0][1]), (_e268[1][2] - _e268[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e267[2][0] - _e267[3][0]), (_e267[2][1] - _e267[3][1]), (_e267[2][2] - _e267[3][2])), array<f32, 3>((_e268[2][0] - _e268[3][0]), (_e268[2][1] - _e268[3][1]), (_e268[2][2] - _e268[3][2]))), (_e261 + _e261));
                } else {
                    phi_762_ = type_33(array<array<f32, 3>, 2>(array<f32, 3>((_e267[0][0] - _e267[1][0]), (_e267[0][1] - _e267[1][1]), (_e267[0][2] - _e267[1][2])), array<f32, 3>((_e268[0][0] - _e268[1][0]), (_e268[0][1] - _e268[1][1]), (_e268[0][2] - _e268[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e267[2][0] - _e267[1][0]), (_e267[2][1] - _e267[1][1]), (_e267[2][2] - _e267[1][2])), array<f32, 3>((_e268[2][0] - _e268[1][0]), (_e268[2][1] - _e268[1][1]), (_e268[2][2] - _e268[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e267[3][0] - _e267[1][0]), (_e267[3][1] - _e267[1][1]), (_e267[3][2] - _e267[1][2])), array<f32, 3>((_e268[3][0] - _e268[1][0]), (_e268[3][1] - _e268[1][1]), (_e268[3][2] - _e268[1][2]))), (_e261 + _e261));
                }
                let _e425 = phi_762_;
                let _e430 = function_9(_e425.member[0], _e425.member[1], _e262);
                let _e435 = function_9(_e425.member_1[0], _e425.member_1[1], _e262);
                let _e440 = function_9(_e425.member_2[0], _e425.member_2[1], _e262);
                let _e444 = select(_e430[0], -(_e430[0]), (_e430[0] < 0f));
                let _e448 = select(_e430[1], -(_e430[1]), (_e430[1] < 0f));
                let _e450 = select(_e448, _e444, (_e444 > _e448));
                let _e454 = select(_e430[2], -(_e430[2]), (_e430[2] < 0f));
                let _e456 = select(_e454, _e450, (_e450 > _e454));
                let _e460 = select(_e435[0], -(_e435[0]), (_e435[0] < 0f));
                let _e464 = select(_e435[1], -(_e435[1]), (_e435[1] < 0f));
                let _e466 = select(_e464, _e460, (_e460 > _e464));
                let _e470 = select(_e435[2], -(_e435[2]), (_e435[2] < 0f));
                let _e472 = select(_e470, _e466, (_e466 > _e470));
                let _e474 = select(_e472, _e456, (_e456 > _e472));
                let _e478 = select(_e440[0], -(_e440[0]), (_e440[0] < 0f));
                let _e482 = select(_e440[1], -(_e440[1]), (_e440[1] < 0f));
                let _e484 = select(_e482, _e478, (_e478 > _e482));
                let _e488 = select(_e440[2], -(_e440[2]), (_e440[2] < 0f));
                let _e490 = select(_e488, _e484, (_e484 > _e488));
                let _e493 = function_8(select(_e490, _e474, (_e474 > _e490)));
                let _e501 = (_e435[0] * _e493);
                let _e503 = (_e435[1] * _e493);
                let _e505 = (_e435[2] * _e493);
                let _e507 = (_e440[0] * _e493);
                let _e509 = (_e440[1] * _e493);
                let _e511 = (_e440[2] * _e493);
                let _e517 = select(_e425.member[0][0], -(_e425.member[0][0]), (_e425.member[0][0] < 0f));
                let _e521 = select(_e425.member[0][1], -(_e425.member[0][1]), (_e425.member[0][1] < 0f));
                let _e523 = select(_e521, _e517, (_e517 > _e521));
                let _e527 = select(_e425.member[0][2], -(_e425.member[0][2]), (_e425.member[0][2] < 0f));
                let _e529 = select(_e527, _e523, (_e523 > _e527));
                let _e535 = select(_e425.member[1][0], -(_e425.member[1][0]), (_e425.member[1][0] < 0f));
                let _e539 = select(_e425.member[1][1], -(_e425.member[1][1]), (_e425.member[1][1] < 0f));
                let _e541 = select(_e539, _e535, (_e535 > _e539));
                let _e545 = select(_e425.member[1][2], -(_e425.member[1][2]), (_e425.member[1][2] < 0f));
                let _e547 = select(_e545, _e541, (_e541 > _e545));
                let _e557 = select(_e425.member_1[0][0], -(_e425.member_1[0][0]), (_e425.member_1[0][0] < 0f));
                let _e561 = select(_e425.member_1[0][1], -(_e425.member_1[0][1]), (_e425.member_1[0][1] < 0f));
                let _e563 = select(_e561, _e557, (_e557 > _e561));
                let _e567 = select(_e425.member_1[0][2], -(_e425.member_1[0][2]), (_e425.member_1[0][2] < 0f));
                let _e569 = select(_e567, _e563, (_e563 > _e567));
                let _e575 = select(_e425.member_1[1][0], -(_e425.member_1[1][0]), (_e425.member_1[1][0] < 0f));
                let _e579 = select(_e425.member_1[1][1], -(_e425.member_1[1][1]), (_e425.member_1[1][1] < 0f));
                let _e581 = select(_e579, _e575, (_e575 > _e579));
                let _e585 = select(_e425.member_1[1][2], -(_e425.member_1[1][2]), (_e425.member_1[1][2] < 0f));
                let _e587 = select(_e585, _e581, (_e581 > _e585));
                let _e591 = (select(_e587, _e569, (_e569 > _e587)) + _e425.member_3);
                let _e597 = select(_e425.member_2[0][0], -(_e425.member_2[0][0]), (_e425.member_2[0][0] < 0f));
                let _e601 = select(_e425.member_2[0][1], -(_e425.member_2[0][1]), (_e425.member_2[0][1] < 0f));
                let _e603 = select(_e601, _e597, (_e597 > _e601));
                let _e607 = select(_e425.member_2[0][2], -(_e425.member_2[0][2]), (_e425.member_2[0][2] < 0f));
                let _e609 = select(_e607, _e603, (_e603 > _e607));
                let _e615 = select(_e425.member_2[1][0], -(_e425.member_2[1][0]), (_e425.member_2[1][0] < 0f));
                let _e619 = select(_e425.member_2[1][1], -(_e425.member_2[1][1]), (_e425.member_2[1][1] < 0f));
                let _e621 = select(_e619, _e615, (_e615 > _e619));
                let _e625 = select(_e425.member_2[1][2], -(_e425.member_2[1][2]), (_e425.member_2[1][2] < 0f));
                let _e627 = select(_e625, _e621, (_e621 > _e625));
                let _e631 = (select(_e627, _e609, (_e609 > _e627)) + _e425.member_3);
                let _e632 = (0.000000059604645f * 16f);
                let _e634 = (_e425.member_3 * 4f);
                let _e642 = ((_e503 * _e511) - (_e505 * _e509));
                let _e645 = ((_e505 * _e507) - (_e501 * _e511));
                let _e648 = ((_e501 * _e509) - (_e503 * _e507));
                let _e656 = select(_e507, -(_e507), (_e507 < 0f));
                let _e659 = select(_e509, -(_e509), (_e509 < 0f));
                let _e661 = select(_e659, _e656, (_e656 > _e659));
                let _e664 = select(_e511, -(_e511), (_e511 < 0f));
                let _e671 = select(_e501, -(_e501), (_e501 < 0f));
                let _e674 = select(_e503, -(_e503), (_e503 < 0f));
                let _e676 = select(_e674, _e671, (_e671 > _e674));
                let _e679 = select(_e505, -(_e505), (_e505 < 0f));
                let _e683 = (((((_e591 * _e632) + _e634) * _e493) * select(_e664, _e661, (_e661 > _e664))) + ((((_e631 * _e632) + _e634) * _e493) * select(_e679, _e676, (_e676 > _e679))));
                let _e688 = (((_e642 * _e642) + (_e645 * _e645)) + (_e648 * _e648));
                if (_e688 <= 0.000000000000000000000000000000000000011754944f) {
                    phi_1275_ = select(0f, (0.000000000000000000106433627f * 2f), (_e688 > 0f));
                } else {
                    phi_1218_ = type_14(0i, 5i);
                    phi_1221_ = bitcast<f32>(((bitcast<u32>(_e688) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e696 = phi_1218_;
                        let _e698 = phi_1221_;
                        local_3 = _e698;
                        if (_e696.member < _e696.member_1) {
                            let _e705 = (_e696.member + 1i);
                            phi_1219_ = type_14(select(_e705, type_15().member_1, select(false, true, ((false == (_e705 > _e696.member)) != false))), _e696.member_1);
                            phi_1262_ = type_15(1u, _e696.member);
                        } else {
                            phi_1219_ = _e696;
                            phi_1262_ = type_15(0u, type_15().member_1);
                        }
                        let _e716 = phi_1219_;
                        let _e718 = phi_1262_;
                        let _e721 = (bitcast<i32>(_e718.member) != 0i);
                        if _e721 {
                            phi_1222_ = (0.5f * (_e698 + (_e688 / _e698)));
                        } else {
                            phi_1222_ = f32();
                        }
                        let _e726 = phi_1222_;
                        continue;
                        continuing {
                            phi_1218_ = _e716;
                            phi_1221_ = _e726;
                            break if !(_e721);
                        }
                    }
                    let _e731 = local_3;
                    phi_1275_ = (_e731 * (1f + (8f * 0.000000059604645f)));
                }
                let _e737 = phi_1275_;
                if (_e737 > 0f) {
                    phi_1283_ = ((_e737 + (_e688 / _e737)) * 0.5f);
                } else {
                    phi_1283_ = _e737;
                }
                let _e743 = phi_1283_;
                local = type_22(array<f32, 3>((_e430[0] * _e493), (_e430[1] * _e493), (_e430[2] * _e493)), array<f32, 3>(_e501, _e503, _e505), array<f32, 3>(_e507, _e509, _e511), array<f32, 3>(_e642, _e645, _e648), select(0f, _e743, (_e743 > _e683)), _e683, ((((((select(_e547, _e529, (_e529 > _e547)) + _e425.member_3) + _e591) + _e631) * _e632) + _e634) * _e493));
                let _e751 = function_7((&local), _e185.member);
                if (_e751.member_3 <= 0.000000000000000000000000000000000000011754944f) {
                    phi_1395_ = select(0f, (0.000000000000000000106433627f * 2f), (_e751.member_3 > 0f));
                } else {
                    phi_1338_ = type_14(0i, 5i);
                    phi_1341_ = bitcast<f32>(((bitcast<u32>(_e751.member_3) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e762 = phi_1338_;
                        let _e764 = phi_1341_;
                        local_4 = _e764;
                        if (_e762.member < _e762.member_1) {
                            let _e771 = (_e762.member + 1i);
                            phi_1339_ = type_14(select(_e771, type_15().member_1, select(false, true, ((false == (_e771 > _e762.member)) != false))), _e762.member_1);
                            phi_1382_ = type_15(1u, _e762.member);
                        } else {
                            phi_1339_ = _e762;
                            phi_1382_ = type_15(0u, type_15().member_1);
                        }
                        let _e782 = phi_1339_;
                        let _e784 = phi_1382_;
                        let _e787 = (bitcast<i32>(_e784.member) != 0i);
                        if _e787 {
                            phi_1342_ = (0.5f * (_e764 + (_e751.member_3 / _e764)));
                        } else {
                            phi_1342_ = f32();
                        }
                        let _e792 = phi_1342_;
                        continue;
                        continuing {
                            phi_1338_ = _e782;
                            phi_1341_ = _e792;
                            break if !(_e787);
                        }
                    }
                    let _e797 = local_4;
                    phi_1395_ = (_e797 * (1f + (8f * 0.000000059604645f)));
                }
                let _e803 = phi_1395_;
                if (_e803 > 0f) {
                    phi_1403_ = ((_e803 + (_e751.member_3 / _e803)) * 0.5f);
                } else {
                    phi_1403_ = _e803;
                }
                let _e809 = phi_1403_;
                let _e812 = select(-(1f), 1f, (_e185.member == 0u));
                let _e814 = function_1(_e425.member);
                let _e816 = function_1(_e425.member_1);
                let _e830 = function_1(_e425.member_2);
                let _e840 = (((_e814[0] - (_e816[0] * _e751.member)) - (_e830[0] * _e751.member_1)) * _e812);
                let _e841 = (((_e814[1] - (_e816[1] * _e751.member)) - (_e830[1] * _e751.member_1)) * _e812);
                let _e842 = (((_e814[2] - (_e816[2] * _e751.member)) - (_e830[2] * _e751.member_1)) * _e812);
                let _e848 = select(false, (_e751.member < 1f), (_e751.member > 0f));
                let _e851 = select(false, (_e751.member_1 < 1f), (_e751.member_1 > 0f));
                let _e852 = (_e812 > 0f);
                let _e862 = select(select(bool(), select(bool(), select(true, ((_e751.member + _e751.member_1) < (1f - (0.000000059604645f * 4f))), _e852), _e851), _e848), false, select(true, select(true, false, _e851), _e848));
                let _e864 = local.member_4;
                let _e865 = (_e864 > 0f);
                let _e867 = local.member_3;
                let _e871 = (_e867[0] * _e812);
                let _e872 = (_e867[1] * _e812);
                let _e873 = (_e867[2] * _e812);
                let _e875 = local.member_6;
                if (_e809 > _e875) {
                    let _e1875 = (_e751.member_2[0] * _e812);
                    let _e1877 = (_e751.member_2[1] * _e812);
                    let _e1879 = (_e751.member_2[2] * _e812);
                    if _e865 {
                        if _e862 {
                            let _e1881 = local.member_5;
                            let _e1884 = local.member_6;
                            let _e1886 = local.member_4;
                            if ((_e1881 * _e809) <= (_e1884 * _e1886)) {
                                let _e1894 = ((((_e1875 * _e871) + (_e1877 * _e872)) + (_e1879 * _e873)) >= 0f);
                                let _e1895 = -(1f);
                                let _e1899 = select((_e871 * _e1895), _e871, _e1894);
                                let _e1900 = select((_e872 * _e1895), _e872, _e1894);
                                let _e1901 = select((_e873 * _e1895), _e873, _e1894);
                                let _e1904 = select(_e1899, -(_e1899), (_e1899 < 0f));
                                let _e1907 = select(_e1900, -(_e1900), (_e1900 < 0f));
                                let _e1909 = select(_e1907, _e1904, (_e1904 > _e1907));
                                let _e1912 = select(_e1901, -(_e1901), (_e1901 < 0f));
                                let _e1915 = function_8(select(_e1912, _e1909, (_e1909 > _e1912)));
                                let _e1916 = (_e1899 * _e1915);
                                let _e1917 = (_e1900 * _e1915);
                                let _e1918 = (_e1901 * _e1915);
                                let _e1923 = (((_e1916 * _e1916) + (_e1917 * _e1917)) + (_e1918 * _e1918));
                                if (_e1923 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_1660_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1923 > 0f));
                                } else {
                                    phi_1603_ = type_14(0i, 5i);
                                    phi_1606_ = bitcast<f32>(((bitcast<u32>(_e1923) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1931 = phi_1603_;
                                        let _e1933 = phi_1606_;
                                        local_11 = _e1933;
                                        if (_e1931.member < _e1931.member_1) {
                                            let _e1940 = (_e1931.member + 1i);
                                            phi_1604_ = type_14(select(_e1940, type_15().member_1, select(false, true, ((false == (_e1940 > _e1931.member)) != false))), _e1931.member_1);
                                            phi_1647_ = type_15(1u, _e1931.member);
                                        } else {
                                            phi_1604_ = _e1931;
                                            phi_1647_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1951 = phi_1604_;
                                        let _e1953 = phi_1647_;
                                        let _e1956 = (bitcast<i32>(_e1953.member) != 0i);
                                        if _e1956 {
                                            phi_1607_ = (0.5f * (_e1933 + (_e1923 / _e1933)));
                                        } else {
                                            phi_1607_ = f32();
                                        }
                                        let _e1961 = phi_1607_;
                                        continue;
                                        continuing {
                                            phi_1603_ = _e1951;
                                            phi_1606_ = _e1961;
                                            break if !(_e1956);
                                        }
                                    }
                                    let _e1966 = local_11;
                                    phi_1660_ = (_e1966 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1972 = phi_1660_;
                                let _e1973 = (1f / _e1972);
                                let _e1974 = (_e1916 * _e1973);
                                let _e1975 = (_e1917 * _e1973);
                                let _e1976 = (_e1918 * _e1973);
                                let _e1983 = ((3f - (((_e1974 * _e1974) + (_e1975 * _e1975)) + (_e1976 * _e1976))) * 0.5f);
                                phi_1676_ = array<f32, 3>((_e1974 * _e1983), (_e1975 * _e1983), (_e1976 * _e1983));
                                phi_1677_ = false;
                            } else {
                                phi_1676_ = array<f32, 3>();
                                phi_1677_ = true;
                            }
                            let _e1989 = phi_1676_;
                            let _e1991 = phi_1677_;
                            phi_1678_ = _e1989;
                            phi_1679_ = _e1991;
                        } else {
                            phi_1678_ = array<f32, 3>();
                            phi_1679_ = true;
                        }
                        let _e1993 = phi_1678_;
                        let _e1995 = phi_1679_;
                        phi_1680_ = _e1993;
                        phi_1681_ = _e1995;
                    } else {
                        phi_1680_ = array<f32, 3>();
                        phi_1681_ = true;
                    }
                    let _e1997 = phi_1680_;
                    let _e1999 = phi_1681_;
                    if _e1999 {
                        let _e2002 = select(_e1875, -(_e1875), (_e1875 < 0f));
                        let _e2005 = select(_e1877, -(_e1877), (_e1877 < 0f));
                        let _e2007 = select(_e2005, _e2002, (_e2002 > _e2005));
                        let _e2010 = select(_e1879, -(_e1879), (_e1879 < 0f));
                        let _e2013 = function_8(select(_e2010, _e2007, (_e2007 > _e2010)));
                        let _e2014 = (_e1875 * _e2013);
                        let _e2015 = (_e1877 * _e2013);
                        let _e2016 = (_e1879 * _e2013);
                        let _e2021 = (((_e2014 * _e2014) + (_e2015 * _e2015)) + (_e2016 * _e2016));
                        if (_e2021 <= 0.000000000000000000000000000000000000011754944f) {
                            phi_1799_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2021 > 0f));
                        } else {
                            phi_1742_ = type_14(0i, 5i);
                            phi_1745_ = bitcast<f32>(((bitcast<u32>(_e2021) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e2029 = phi_1742_;
                                let _e2031 = phi_1745_;
                                local_12 = _e2031;
                                if (_e2029.member < _e2029.member_1) {
                                    let _e2038 = (_e2029.member + 1i);
                                    phi_1743_ = type_14(select(_e2038, type_15().member_1, select(false, true, ((false == (_e2038 > _e2029.member)) != false))), _e2029.member_1);
                                    phi_1786_ = type_15(1u, _e2029.member);
                                } else {
                                    phi_1743_ = _e2029;
                                    phi_1786_ = type_15(0u, type_15().member_1);
                                }
                                let _e2049 = phi_1743_;
                                let _e2051 = phi_1786_;
                                let _e2054 = (bitcast<i32>(_e2051.member) != 0i);
                                if _e2054 {
                                    phi_1746_ = (0.5f * (_e2031 + (_e2021 / _e2031)));
                                } else {
                                    phi_1746_ = f32();
                                }
                                let _e2059 = phi_1746_;
                                continue;
                                continuing {
                                    phi_1742_ = _e2049;
                                    phi_1745_ = _e2059;
                                    break if !(_e2054);
                                }
                            }
                            let _e2064 = local_12;
                            phi_1799_ = (_e2064 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e2070 = phi_1799_;
                        let _e2071 = (1f / _e2070);
                        let _e2072 = (_e2014 * _e2071);
                        let _e2073 = (_e2015 * _e2071);
                        let _e2074 = (_e2016 * _e2071);
                        let _e2081 = ((3f - (((_e2072 * _e2072) + (_e2073 * _e2073)) + (_e2074 * _e2074))) * 0.5f);
                        phi_1815_ = array<f32, 3>((_e2072 * _e2081), (_e2073 * _e2081), (_e2074 * _e2081));
                    } else {
                        phi_1815_ = _e1997;
                    }
                    let _e2087 = phi_1815_;
                    phi_3391_ = _e2087;
                    phi_3392_ = array<f32, 3>();
                    phi_3393_ = true;
                } else {
                    let _e882 = select(_e425.member[0][0], -(_e425.member[0][0]), (_e425.member[0][0] < 0f));
                    let _e886 = select(_e425.member[0][1], -(_e425.member[0][1]), (_e425.member[0][1] < 0f));
                    let _e888 = select(_e886, _e882, (_e882 > _e886));
                    let _e892 = select(_e425.member[0][2], -(_e425.member[0][2]), (_e425.member[0][2] < 0f));
                    let _e894 = select(_e892, _e888, (_e888 > _e892));
                    let _e900 = select(_e425.member[1][0], -(_e425.member[1][0]), (_e425.member[1][0] < 0f));
                    let _e904 = select(_e425.member[1][1], -(_e425.member[1][1]), (_e425.member[1][1] < 0f));
                    let _e906 = select(_e904, _e900, (_e900 > _e904));
                    let _e910 = select(_e425.member[1][2], -(_e425.member[1][2]), (_e425.member[1][2] < 0f));
                    let _e912 = select(_e910, _e906, (_e906 > _e910));
                    let _e922 = select(_e425.member_1[0][0], -(_e425.member_1[0][0]), (_e425.member_1[0][0] < 0f));
                    let _e926 = select(_e425.member_1[0][1], -(_e425.member_1[0][1]), (_e425.member_1[0][1] < 0f));
                    let _e928 = select(_e926, _e922, (_e922 > _e926));
                    let _e932 = select(_e425.member_1[0][2], -(_e425.member_1[0][2]), (_e425.member_1[0][2] < 0f));
                    let _e934 = select(_e932, _e928, (_e928 > _e932));
                    let _e940 = select(_e425.member_1[1][0], -(_e425.member_1[1][0]), (_e425.member_1[1][0] < 0f));
                    let _e944 = select(_e425.member_1[1][1], -(_e425.member_1[1][1]), (_e425.member_1[1][1] < 0f));
                    let _e946 = select(_e944, _e940, (_e940 > _e944));
                    let _e950 = select(_e425.member_1[1][2], -(_e425.member_1[1][2]), (_e425.member_1[1][2] < 0f));
                    let _e952 = select(_e950, _e946, (_e946 > _e950));
                    let _e962 = select(_e425.member_2[0][0], -(_e425.member_2[0][0]), (_e425.member_2[0][0] < 0f));
                    let _e966 = select(_e425.member_2[0][1], -(_e425.member_2[0][1]), (_e425.member_2[0][1] < 0f));
                    let _e968 = select(_e966, _e962, (_e962 > _e966));
                    let _e972 = select(_e425.member_2[0][2], -(_e425.member_2[0][2]), (_e425.member_2[0][2] < 0f));
                    let _e974 = select(_e972, _e968, (_e968 > _e972));
                    let _e980 = select(_e425.member_2[1][0], -(_e425.member_2[1][0]), (_e425.member_2[1][0] < 0f));
                    let _e984 = select(_e425.member_2[1][1], -(_e425.member_2[1][1]), (_e425.member_2[1][1] < 0f));
                    let _e986 = select(_e984, _e980, (_e980 > _e984));
                    let _e990 = select(_e425.member_2[1][2], -(_e425.member_2[1][2]), (_e425.member_2[1][2] < 0f));
                    let _e992 = select(_e990, _e986, (_e986 > _e990));
                    let _e1003 = (((((select(_e912, _e894, (_e894 > _e912)) + _e425.member_3) + (select(_e952, _e934, (_e934 > _e952)) + _e425.member_3)) + (select(_e992, _e974, (_e974 > _e992)) + _e425.member_3)) * (0.000000059604645f * 32f)) + (_e425.member_3 * 8f));
                    if _e865 {
                        let _e1006 = select(_e871, -(_e871), (_e871 < 0f));
                        let _e1009 = select(_e872, -(_e872), (_e872 < 0f));
                        let _e1011 = select(_e1009, _e1006, (_e1006 > _e1009));
                        let _e1014 = select(_e873, -(_e873), (_e873 < 0f));
                        let _e1017 = function_8(select(_e1014, _e1011, (_e1011 > _e1014)));
                        let _e1018 = (_e871 * _e1017);
                        let _e1019 = (_e872 * _e1017);
                        let _e1020 = (_e873 * _e1017);
                        let _e1025 = (((_e1018 * _e1018) + (_e1019 * _e1019)) + (_e1020 * _e1020));
                        if (_e1025 <= 0.000000000000000000000000000000000000011754944f) {
                            phi_2153_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1025 > 0f));
                        } else {
                            phi_2096_ = type_14(0i, 5i);
                            phi_2099_ = bitcast<f32>(((bitcast<u32>(_e1025) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e1033 = phi_2096_;
                                let _e1035 = phi_2099_;
                                local_5 = _e1035;
                                if (_e1033.member < _e1033.member_1) {
                                    let _e1042 = (_e1033.member + 1i);
                                    phi_2097_ = type_14(select(_e1042, type_15().member_1, select(false, true, ((false == (_e1042 > _e1033.member)) != false))), _e1033.member_1);
                                    phi_2140_ = type_15(1u, _e1033.member);
                                } else {
                                    phi_2097_ = _e1033;
                                    phi_2140_ = type_15(0u, type_15().member_1);
                                }
                                let _e1053 = phi_2097_;
                                let _e1055 = phi_2140_;
                                let _e1058 = (bitcast<i32>(_e1055.member) != 0i);
                                if _e1058 {
                                    phi_2100_ = (0.5f * (_e1035 + (_e1025 / _e1035)));
                                } else {
                                    phi_2100_ = f32();
                                }
                                let _e1063 = phi_2100_;
                                continue;
                                continuing {
                                    phi_2096_ = _e1053;
                                    phi_2099_ = _e1063;
                                    break if !(_e1058);
                                }
                            }
                            let _e1068 = local_5;
                            phi_2153_ = (_e1068 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e1074 = phi_2153_;
                        let _e1075 = (1f / _e1074);
                        let _e1076 = (_e1018 * _e1075);
                        let _e1077 = (_e1019 * _e1075);
                        let _e1078 = (_e1020 * _e1075);
                        let _e1085 = ((3f - (((_e1076 * _e1076) + (_e1077 * _e1077)) + (_e1078 * _e1078))) * 0.5f);
                        let _e1086 = (_e1076 * _e1085);
                        let _e1087 = (_e1077 * _e1085);
                        let _e1088 = (_e1078 * _e1085);
                        let _e1093 = (((_e840 * _e1086) + (_e841 * _e1087)) + (_e842 * _e1088));
                        let _e1106 = local.member_5;
                        let _e1108 = local.member_4;
                        if (select(_e1093, -(_e1093), (_e1093 < 0f)) > (_e1003 + (((select(_e840, -(_e840), (_e840 < 0f)) + select(_e841, -(_e841), (_e841 < 0f))) + select(_e842, -(_e842), (_e842 < 0f))) * (_e1106 / _e1108)))) {
                            let _e1116 = (_e1093 < 0f);
                            let _e1117 = -(1f);
                            phi_2221_ = array<f32, 3>(select((_e1086 * _e1117), _e1086, _e1116), select((_e1087 * _e1117), _e1087, _e1116), select((_e1088 * _e1117), _e1088, _e1116));
                            phi_2222_ = false;
                        } else {
                            phi_2221_ = array<f32, 3>();
                            phi_2222_ = true;
                        }
                        let _e1126 = phi_2221_;
                        let _e1128 = phi_2222_;
                        phi_2223_ = _e1126;
                        phi_2224_ = _e1128;
                    } else {
                        phi_2223_ = array<f32, 3>();
                        phi_2224_ = true;
                    }
                    let _e1130 = phi_2223_;
                    let _e1132 = phi_2224_;
                    if _e1132 {
                        if select(true, select(true, false, _e862), _e865) {
                            if _e852 {
                                if _e848 {
                                    if _e851 {
                                        let _e1136 = local.member_2;
                                        let _e1141 = local.member_1;
                                        phi_2270_ = array<f32, 3>((_e1136[0] - _e1141[0]), (_e1136[1] - _e1141[1]), (_e1136[2] - _e1141[2]));
                                        phi_2271_ = false;
                                    } else {
                                        phi_2270_ = array<f32, 3>();
                                        phi_2271_ = true;
                                    }
                                    let _e1150 = phi_2270_;
                                    let _e1152 = phi_2271_;
                                    phi_2272_ = _e1150;
                                    phi_2273_ = _e1152;
                                } else {
                                    phi_2272_ = array<f32, 3>();
                                    phi_2273_ = true;
                                }
                                let _e1154 = phi_2272_;
                                let _e1156 = phi_2273_;
                                phi_2274_ = _e1154;
                                phi_2275_ = _e1156;
                            } else {
                                phi_2274_ = array<f32, 3>();
                                phi_2275_ = true;
                            }
                            let _e1158 = phi_2274_;
                            let _e1160 = phi_2275_;
                            if _e1160 {
                                if _e848 {
                                    if _e851 {
                                        let _e1162 = local.member_2;
                                        let _e1168 = select(_e1162[0], -(_e1162[0]), (_e1162[0] < 0f));
                                        let _e1171 = select(_e1162[1], -(_e1162[1]), (_e1162[1] < 0f));
                                        let _e1173 = select(_e1171, _e1168, (_e1168 > _e1171));
                                        let _e1176 = select(_e1162[2], -(_e1162[2]), (_e1162[2] < 0f));
                                        let _e1180 = local.member_1;
                                        let _e1186 = select(_e1180[0], -(_e1180[0]), (_e1180[0] < 0f));
                                        let _e1189 = select(_e1180[1], -(_e1180[1]), (_e1180[1] < 0f));
                                        let _e1191 = select(_e1189, _e1186, (_e1186 > _e1189));
                                        let _e1194 = select(_e1180[2], -(_e1180[2]), (_e1180[2] < 0f));
                                        phi_2364_ = select(true, false, (select(_e1176, _e1173, (_e1173 > _e1176)) > select(_e1194, _e1191, (_e1191 > _e1194))));
                                    } else {
                                        phi_2364_ = true;
                                    }
                                    let _e1200 = phi_2364_;
                                    if _e1200 {
                                        let _e1202 = local.member_1;
                                        phi_2374_ = array<f32, 3>(_e1202[0], _e1202[1], _e1202[2]);
                                        phi_2375_ = false;
                                    } else {
                                        phi_2374_ = array<f32, 3>();
                                        phi_2375_ = true;
                                    }
                                    let _e1208 = phi_2374_;
                                    let _e1210 = phi_2375_;
                                    phi_2376_ = _e1208;
                                    phi_2377_ = _e1210;
                                } else {
                                    phi_2376_ = array<f32, 3>();
                                    phi_2377_ = true;
                                }
                                let _e1212 = phi_2376_;
                                let _e1214 = phi_2377_;
                                if _e1214 {
                                    if _e851 {
                                        let _e1216 = local.member_2;
                                        phi_2391_ = array<f32, 3>(_e1216[0], _e1216[1], _e1216[2]);
                                    } else {
                                        phi_2391_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e1222 = phi_2391_;
                                    phi_2392_ = _e1222;
                                } else {
                                    phi_2392_ = _e1212;
                                }
                                let _e1224 = phi_2392_;
                                phi_2393_ = _e1224;
                            } else {
                                phi_2393_ = _e1158;
                            }
                            let _e1226 = phi_2393_;
                            let _e1230 = select(_e1226[0], -(_e1226[0]), (_e1226[0] < 0f));
                            let _e1234 = select(_e1226[1], -(_e1226[1]), (_e1226[1] < 0f));
                            let _e1236 = select(_e1234, _e1230, (_e1230 > _e1234));
                            let _e1240 = select(_e1226[2], -(_e1226[2]), (_e1226[2] < 0f));
                            let _e1244 = local.member_6;
                            let _e1245 = (select(_e1240, _e1236, (_e1236 > _e1240)) > _e1244);
                            let _e1247 = select(0f, _e1226[0], _e1245);
                            let _e1249 = select(0f, _e1226[1], _e1245);
                            let _e1251 = select(0f, _e1226[2], _e1245);
                            let _e1254 = select(_e1247, -(_e1247), (_e1247 < 0f));
                            let _e1257 = select(_e1249, -(_e1249), (_e1249 < 0f));
                            let _e1259 = select(_e1257, _e1254, (_e1254 > _e1257));
                            let _e1262 = select(_e1251, -(_e1251), (_e1251 < 0f));
                            if (select(_e1262, _e1259, (_e1259 > _e1262)) > 0f) {
                                let _e1268 = select(_e1247, -(_e1247), (_e1247 < 0f));
                                let _e1271 = select(_e1249, -(_e1249), (_e1249 < 0f));
                                let _e1273 = select(_e1271, _e1268, (_e1268 > _e1271));
                                let _e1276 = select(_e1251, -(_e1251), (_e1251 < 0f));
                                let _e1279 = function_8(select(_e1276, _e1273, (_e1273 > _e1276)));
                                let _e1280 = (_e1247 * _e1279);
                                let _e1281 = (_e1249 * _e1279);
                                let _e1282 = (_e1251 * _e1279);
                                let _e1287 = (((_e1280 * _e1280) + (_e1281 * _e1281)) + (_e1282 * _e1282));
                                if (_e1287 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_2588_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1287 > 0f));
                                } else {
                                    phi_2531_ = type_14(0i, 5i);
                                    phi_2534_ = bitcast<f32>(((bitcast<u32>(_e1287) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1295 = phi_2531_;
                                        let _e1297 = phi_2534_;
                                        local_6 = _e1297;
                                        if (_e1295.member < _e1295.member_1) {
                                            let _e1304 = (_e1295.member + 1i);
                                            phi_2532_ = type_14(select(_e1304, type_15().member_1, select(false, true, ((false == (_e1304 > _e1295.member)) != false))), _e1295.member_1);
                                            phi_2575_ = type_15(1u, _e1295.member);
                                        } else {
                                            phi_2532_ = _e1295;
                                            phi_2575_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1315 = phi_2532_;
                                        let _e1317 = phi_2575_;
                                        let _e1320 = (bitcast<i32>(_e1317.member) != 0i);
                                        if _e1320 {
                                            phi_2535_ = (0.5f * (_e1297 + (_e1287 / _e1297)));
                                        } else {
                                            phi_2535_ = f32();
                                        }
                                        let _e1325 = phi_2535_;
                                        continue;
                                        continuing {
                                            phi_2531_ = _e1315;
                                            phi_2534_ = _e1325;
                                            break if !(_e1320);
                                        }
                                    }
                                    let _e1330 = local_6;
                                    phi_2588_ = (_e1330 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1336 = phi_2588_;
                                let _e1337 = (1f / _e1336);
                                let _e1338 = (_e1280 * _e1337);
                                let _e1339 = (_e1281 * _e1337);
                                let _e1340 = (_e1282 * _e1337);
                                let _e1347 = ((3f - (((_e1338 * _e1338) + (_e1339 * _e1339)) + (_e1340 * _e1340))) * 0.5f);
                                let _e1348 = (_e1338 * _e1347);
                                let _e1349 = (_e1339 * _e1347);
                                let _e1350 = (_e1340 * _e1347);
                                let _e1355 = (((_e840 * _e1348) + (_e841 * _e1349)) + (_e842 * _e1350));
                                phi_2615_ = array<f32, 3>((_e840 - (_e1348 * _e1355)), (_e841 - (_e1349 * _e1355)), (_e842 - (_e1350 * _e1355)));
                            } else {
                                phi_2615_ = array<f32, 3>(_e840, _e841, _e842);
                            }
                            let _e1364 = phi_2615_;
                            if (((select(_e1364[0], -(_e1364[0]), (_e1364[0] < 0f)) + select(_e1364[1], -(_e1364[1]), (_e1364[1] < 0f))) + select(_e1364[2], -(_e1364[2]), (_e1364[2] < 0f))) > _e1003) {
                                let _e1380 = -(1f);
                                let _e1382 = (_e1364[0] * _e1380);
                                let _e1384 = (_e1364[1] * _e1380);
                                let _e1386 = (_e1364[2] * _e1380);
                                let _e1389 = select(_e1382, -(_e1382), (_e1382 < 0f));
                                let _e1392 = select(_e1384, -(_e1384), (_e1384 < 0f));
                                let _e1394 = select(_e1392, _e1389, (_e1389 > _e1392));
                                let _e1397 = select(_e1386, -(_e1386), (_e1386 < 0f));
                                let _e1400 = function_8(select(_e1397, _e1394, (_e1394 > _e1397)));
                                let _e1401 = (_e1382 * _e1400);
                                let _e1402 = (_e1384 * _e1400);
                                let _e1403 = (_e1386 * _e1400);
                                let _e1408 = (((_e1401 * _e1401) + (_e1402 * _e1402)) + (_e1403 * _e1403));
                                if (_e1408 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_2764_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1408 > 0f));
                                } else {
                                    phi_2707_ = type_14(0i, 5i);
                                    phi_2710_ = bitcast<f32>(((bitcast<u32>(_e1408) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1416 = phi_2707_;
                                        let _e1418 = phi_2710_;
                                        local_7 = _e1418;
                                        if (_e1416.member < _e1416.member_1) {
                                            let _e1425 = (_e1416.member + 1i);
                                            phi_2708_ = type_14(select(_e1425, type_15().member_1, select(false, true, ((false == (_e1425 > _e1416.member)) != false))), _e1416.member_1);
                                            phi_2751_ = type_15(1u, _e1416.member);
                                        } else {
                                            phi_2708_ = _e1416;
                                            phi_2751_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1436 = phi_2708_;
                                        let _e1438 = phi_2751_;
                                        let _e1441 = (bitcast<i32>(_e1438.member) != 0i);
                                        if _e1441 {
                                            phi_2711_ = (0.5f * (_e1418 + (_e1408 / _e1418)));
                                        } else {
                                            phi_2711_ = f32();
                                        }
                                        let _e1446 = phi_2711_;
                                        continue;
                                        continuing {
                                            phi_2707_ = _e1436;
                                            phi_2710_ = _e1446;
                                            break if !(_e1441);
                                        }
                                    }
                                    let _e1451 = local_7;
                                    phi_2764_ = (_e1451 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1457 = phi_2764_;
                                let _e1458 = (1f / _e1457);
                                let _e1459 = (_e1401 * _e1458);
                                let _e1460 = (_e1402 * _e1458);
                                let _e1461 = (_e1403 * _e1458);
                                let _e1468 = ((3f - (((_e1459 * _e1459) + (_e1460 * _e1460)) + (_e1461 * _e1461))) * 0.5f);
                                phi_2780_ = array<f32, 3>((_e1459 * _e1468), (_e1460 * _e1468), (_e1461 * _e1468));
                                phi_2781_ = false;
                            } else {
                                phi_2780_ = array<f32, 3>();
                                phi_2781_ = true;
                            }
                            let _e1474 = phi_2780_;
                            let _e1476 = phi_2781_;
                            phi_2782_ = _e1474;
                            phi_2783_ = _e1476;
                        } else {
                            phi_2782_ = array<f32, 3>();
                            phi_2783_ = true;
                        }
                        let _e1478 = phi_2782_;
                        let _e1480 = phi_2783_;
                        if _e1480 {
                            if _e865 {
                                let _e1754 = select(_e871, -(_e871), (_e871 < 0f));
                                let _e1757 = select(_e872, -(_e872), (_e872 < 0f));
                                let _e1759 = select(_e1757, _e1754, (_e1754 > _e1757));
                                let _e1762 = select(_e873, -(_e873), (_e873 < 0f));
                                let _e1765 = function_8(select(_e1762, _e1759, (_e1759 > _e1762)));
                                let _e1766 = (_e871 * _e1765);
                                let _e1767 = (_e872 * _e1765);
                                let _e1768 = (_e873 * _e1765);
                                let _e1773 = (((_e1766 * _e1766) + (_e1767 * _e1767)) + (_e1768 * _e1768));
                                if (_e1773 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_2904_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1773 > 0f));
                                } else {
                                    phi_2847_ = type_14(0i, 5i);
                                    phi_2850_ = bitcast<f32>(((bitcast<u32>(_e1773) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1781 = phi_2847_;
                                        let _e1783 = phi_2850_;
                                        local_10 = _e1783;
                                        if (_e1781.member < _e1781.member_1) {
                                            let _e1790 = (_e1781.member + 1i);
                                            phi_2848_ = type_14(select(_e1790, type_15().member_1, select(false, true, ((false == (_e1790 > _e1781.member)) != false))), _e1781.member_1);
                                            phi_2891_ = type_15(1u, _e1781.member);
                                        } else {
                                            phi_2848_ = _e1781;
                                            phi_2891_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1801 = phi_2848_;
                                        let _e1803 = phi_2891_;
                                        let _e1806 = (bitcast<i32>(_e1803.member) != 0i);
                                        if _e1806 {
                                            phi_2851_ = (0.5f * (_e1783 + (_e1773 / _e1783)));
                                        } else {
                                            phi_2851_ = f32();
                                        }
                                        let _e1811 = phi_2851_;
                                        continue;
                                        continuing {
                                            phi_2847_ = _e1801;
                                            phi_2850_ = _e1811;
                                            break if !(_e1806);
                                        }
                                    }
                                    let _e1816 = local_10;
                                    phi_2904_ = (_e1816 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1822 = phi_2904_;
                                let _e1823 = (1f / _e1822);
                                let _e1824 = (_e1766 * _e1823);
                                let _e1825 = (_e1767 * _e1823);
                                let _e1826 = (_e1768 * _e1823);
                                let _e1833 = ((3f - (((_e1824 * _e1824) + (_e1825 * _e1825)) + (_e1826 * _e1826))) * 0.5f);
                                phi_3361_ = array<f32, 3>((_e1824 * _e1833), (_e1825 * _e1833), (_e1826 * _e1833));
                            } else {
                                let _e1482 = local.member_1;
                                let _e1487 = local.member_2;
                                let _e1493 = select(_e1487[0], -(_e1487[0]), (_e1487[0] < 0f));
                                let _e1496 = select(_e1487[1], -(_e1487[1]), (_e1487[1] < 0f));
                                let _e1498 = select(_e1496, _e1493, (_e1493 > _e1496));
                                let _e1501 = select(_e1487[2], -(_e1487[2]), (_e1487[2] < 0f));
                                let _e1506 = select(_e1482[0], -(_e1482[0]), (_e1482[0] < 0f));
                                let _e1509 = select(_e1482[1], -(_e1482[1]), (_e1482[1] < 0f));
                                let _e1511 = select(_e1509, _e1506, (_e1506 > _e1509));
                                let _e1514 = select(_e1482[2], -(_e1482[2]), (_e1482[2] < 0f));
                                let _e1517 = (select(_e1501, _e1498, (_e1498 > _e1501)) > select(_e1514, _e1511, (_e1511 > _e1514)));
                                let _e1518 = select(_e1482[0], _e1487[0], _e1517);
                                let _e1519 = select(_e1482[1], _e1487[1], _e1517);
                                let _e1520 = select(_e1482[2], _e1487[2], _e1517);
                                let _e1523 = select(_e1518, -(_e1518), (_e1518 < 0f));
                                let _e1526 = select(_e1519, -(_e1519), (_e1519 < 0f));
                                let _e1528 = select(_e1526, _e1523, (_e1523 > _e1526));
                                let _e1531 = select(_e1520, -(_e1520), (_e1520 < 0f));
                                if (select(_e1531, _e1528, (_e1528 > _e1531)) > 0f) {
                                    let _e1537 = select(_e1518, -(_e1518), (_e1518 < 0f));
                                    let _e1540 = select(_e1519, -(_e1519), (_e1519 < 0f));
                                    let _e1543 = select(_e1520, -(_e1520), (_e1520 < 0f));
                                    if (_e1537 <= _e1540) {
                                        let _e1545 = (_e1537 <= _e1543);
                                        phi_3066_ = array<f32, 3>(select(array<f32, 3>()[0], 1f, _e1545), select(array<f32, 3>()[1], 0f, _e1545), select(array<f32, 3>()[2], 0f, _e1545));
                                        phi_3067_ = select(true, false, _e1545);
                                    } else {
                                        phi_3066_ = array<f32, 3>();
                                        phi_3067_ = true;
                                    }
                                    let _e1555 = phi_3066_;
                                    let _e1557 = phi_3067_;
                                    if _e1557 {
                                        let _e1558 = (_e1540 <= _e1543);
                                        phi_3078_ = array<f32, 3>(0f, select(0f, 1f, _e1558), select(1f, 0f, _e1558));
                                    } else {
                                        phi_3078_ = _e1555;
                                    }
                                    let _e1563 = phi_3078_;
                                    let _e1566 = select(_e1518, -(_e1518), (_e1518 < 0f));
                                    let _e1569 = select(_e1519, -(_e1519), (_e1519 < 0f));
                                    let _e1571 = select(_e1569, _e1566, (_e1566 > _e1569));
                                    let _e1574 = select(_e1520, -(_e1520), (_e1520 < 0f));
                                    let _e1577 = function_8(select(_e1574, _e1571, (_e1571 > _e1574)));
                                    let _e1578 = (_e1518 * _e1577);
                                    let _e1579 = (_e1519 * _e1577);
                                    let _e1580 = (_e1520 * _e1577);
                                    let _e1585 = (((_e1578 * _e1578) + (_e1579 * _e1579)) + (_e1580 * _e1580));
                                    if (_e1585 <= 0.000000000000000000000000000000000000011754944f) {
                                        phi_3199_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1585 > 0f));
                                    } else {
                                        phi_3142_ = type_14(0i, 5i);
                                        phi_3145_ = bitcast<f32>(((bitcast<u32>(_e1585) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1593 = phi_3142_;
                                            let _e1595 = phi_3145_;
                                            local_8 = _e1595;
                                            if (_e1593.member < _e1593.member_1) {
                                                let _e1602 = (_e1593.member + 1i);
                                                phi_3143_ = type_14(select(_e1602, type_15().member_1, select(false, true, ((false == (_e1602 > _e1593.member)) != false))), _e1593.member_1);
                                                phi_3186_ = type_15(1u, _e1593.member);
                                            } else {
                                                phi_3143_ = _e1593;
                                                phi_3186_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1613 = phi_3143_;
                                            let _e1615 = phi_3186_;
                                            let _e1618 = (bitcast<i32>(_e1615.member) != 0i);
                                            if _e1618 {
                                                phi_3146_ = (0.5f * (_e1595 + (_e1585 / _e1595)));
                                            } else {
                                                phi_3146_ = f32();
                                            }
                                            let _e1623 = phi_3146_;
                                            continue;
                                            continuing {
                                                phi_3142_ = _e1613;
                                                phi_3145_ = _e1623;
                                                break if !(_e1618);
                                            }
                                        }
                                        let _e1628 = local_8;
                                        phi_3199_ = (_e1628 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1634 = phi_3199_;
                                    let _e1635 = (1f / _e1634);
                                    let _e1636 = (_e1578 * _e1635);
                                    let _e1637 = (_e1579 * _e1635);
                                    let _e1638 = (_e1580 * _e1635);
                                    let _e1645 = ((3f - (((_e1636 * _e1636) + (_e1637 * _e1637)) + (_e1638 * _e1638))) * 0.5f);
                                    let _e1646 = (_e1636 * _e1645);
                                    let _e1647 = (_e1637 * _e1645);
                                    let _e1648 = (_e1638 * _e1645);
                                    let _e1653 = ((_e1647 * _e1563[2]) - (_e1648 * _e1563[1]));
                                    let _e1658 = ((_e1648 * _e1563[0]) - (_e1646 * _e1563[2]));
                                    let _e1663 = ((_e1646 * _e1563[1]) - (_e1647 * _e1563[0]));
                                    let _e1666 = select(_e1653, -(_e1653), (_e1653 < 0f));
                                    let _e1669 = select(_e1658, -(_e1658), (_e1658 < 0f));
                                    let _e1671 = select(_e1669, _e1666, (_e1666 > _e1669));
                                    let _e1674 = select(_e1663, -(_e1663), (_e1663 < 0f));
                                    let _e1677 = function_8(select(_e1674, _e1671, (_e1671 > _e1674)));
                                    let _e1678 = (_e1653 * _e1677);
                                    let _e1679 = (_e1658 * _e1677);
                                    let _e1680 = (_e1663 * _e1677);
                                    let _e1685 = (((_e1678 * _e1678) + (_e1679 * _e1679)) + (_e1680 * _e1680));
                                    if (_e1685 <= 0.000000000000000000000000000000000000011754944f) {
                                        phi_3343_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1685 > 0f));
                                    } else {
                                        phi_3286_ = type_14(0i, 5i);
                                        phi_3289_ = bitcast<f32>(((bitcast<u32>(_e1685) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1693 = phi_3286_;
                                            let _e1695 = phi_3289_;
                                            local_9 = _e1695;
                                            if (_e1693.member < _e1693.member_1) {
                                                let _e1702 = (_e1693.member + 1i);
                                                phi_3287_ = type_14(select(_e1702, type_15().member_1, select(false, true, ((false == (_e1702 > _e1693.member)) != false))), _e1693.member_1);
                                                phi_3330_ = type_15(1u, _e1693.member);
                                            } else {
                                                phi_3287_ = _e1693;
                                                phi_3330_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1713 = phi_3287_;
                                            let _e1715 = phi_3330_;
                                            let _e1718 = (bitcast<i32>(_e1715.member) != 0i);
                                            if _e1718 {
                                                phi_3290_ = (0.5f * (_e1695 + (_e1685 / _e1695)));
                                            } else {
                                                phi_3290_ = f32();
                                            }
                                            let _e1723 = phi_3290_;
                                            continue;
                                            continuing {
                                                phi_3286_ = _e1713;
                                                phi_3289_ = _e1723;
                                                break if !(_e1718);
                                            }
                                        }
                                        let _e1728 = local_9;
                                        phi_3343_ = (_e1728 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1734 = phi_3343_;
                                    let _e1735 = (1f / _e1734);
                                    let _e1736 = (_e1678 * _e1735);
                                    let _e1737 = (_e1679 * _e1735);
                                    let _e1738 = (_e1680 * _e1735);
                                    let _e1745 = ((3f - (((_e1736 * _e1736) + (_e1737 * _e1737)) + (_e1738 * _e1738))) * 0.5f);
                                    phi_3360_ = array<f32, 3>((_e1736 * _e1745), (_e1737 * _e1745), (_e1738 * _e1745));
                                } else {
                                    phi_3360_ = array<f32, 3>(1f, 0f, 0f);
                                }
                                let _e1751 = phi_3360_;
                                phi_3361_ = _e1751;
                            }
                            let _e1839 = phi_3361_;
                            let _e1848 = ((((_e840 * _e1839[0]) + (_e841 * _e1839[1])) + (_e842 * _e1839[2])) > _e1003);
                            let _e1849 = -(1f);
                            phi_3383_ = array<f32, 3>(select(_e1839[0], (_e1839[0] * _e1849), _e1848), select(_e1839[1], (_e1839[1] * _e1849), _e1848), select(_e1839[2], (_e1839[2] * _e1849), _e1848));
                            phi_3384_ = false;
                        } else {
                            phi_3383_ = array<f32, 3>();
                            phi_3384_ = true;
                        }
                        let _e1864 = phi_3383_;
                        let _e1866 = phi_3384_;
                        phi_3385_ = _e1864;
                        phi_3386_ = _e1478;
                        phi_3387_ = _e1866;
                    } else {
                        phi_3385_ = array<f32, 3>();
                        phi_3386_ = _e1130;
                        phi_3387_ = true;
                    }
                    let _e1868 = phi_3385_;
                    let _e1870 = phi_3386_;
                    let _e1872 = phi_3387_;
                    phi_3391_ = _e1870;
                    phi_3392_ = _e1868;
                    phi_3393_ = _e1872;
                }
                let _e2089 = phi_3391_;
                let _e2091 = phi_3392_;
                let _e2093 = phi_3393_;
                let _e2096 = select(_e2091[0], _e2089[0], _e2093);
                let _e2099 = select(_e2091[1], _e2089[1], _e2093);
                let _e2102 = select(_e2091[2], _e2089[2], _e2093);
                let _e2108 = ((((_e2096 * _e2096) + (_e2099 * _e2099)) + (_e2102 * _e2102)) > 0.5f);
                let _e2115 = function_9(_e267[0], _e268[0], _e262);
                let _e2118 = function_9(_e267[1], _e268[1], _e262);
                let _e2121 = function_9(_e267[2], _e268[2], _e262);
                let _e2124 = function_9(_e267[3], _e268[3], _e262);
                if (_e185.member != 0u) {
                    let _e2160 = function_9(_e2115, _e2118, _e751.member);
                    let _e2161 = function_9(_e2121, _e2124, _e751.member_1);
                    phi_3470_ = _e2161;
                    phi_3471_ = _e2160;
                    phi_3472_ = array<f32, 4>((1f - _e751.member), _e751.member, (1f - _e751.member_1), _e751.member_1);
                } else {
                    let _e2127 = ((1f - _e751.member) - _e751.member_1);
                    let _e2129 = select(0f, _e2127, (_e2127 > 0f));
                    let _e2156 = function_(array<f32, 4>(1f, _e2129, _e751.member, _e751.member_1), _e266);
                    phi_3470_ = array<f32, 3>((((_e2118[0] * _e2129) + (_e2121[0] * _e751.member)) + (_e2124[0] * _e751.member_1)), (((_e2118[1] * _e2129) + (_e2121[1] * _e751.member)) + (_e2124[1] * _e751.member_1)), (((_e2118[2] * _e2129) + (_e2121[2] * _e751.member)) + (_e2124[2] * _e751.member_1)));
                    phi_3471_ = _e2115;
                    phi_3472_ = _e2156;
                }
                let _e2163 = phi_3470_;
                let _e2165 = phi_3471_;
                let _e2167 = phi_3472_;
                let _e2168 = function_9(_e2165, _e2163, 0.5f);
                let _e2172 = params.member.member_2.member;
                let _e2175 = params.member.member_2.member_1;
                geometry.member[_e132] = type_29(array<f32, 3>(((_e2168[0] * _e2175) + _e2172[0]), ((_e2168[1] * _e2175) + _e2172[1]), ((_e2168[2] * _e2175) + _e2172[2])), ((_e809 / _e493) * _e2175), array<f32, 3>(select(1f, _e2096, _e2108), select(0f, _e2099, _e2108), select(0f, _e2102, _e2108)), _e139, _e2167, _e185.member_1);
            }
        }
        continue;
        continuing {
            phi_231_ = type_9(select(_e107.member, (_e107.member + 1u), _e110), select(_e107.member_1, _e107.member_1, _e110));
            break if !(_e123);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn contact_geometry(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_12(id, n, lane);
}
