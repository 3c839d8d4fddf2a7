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
    var phi_4468_: array<f32, 4>;

    switch bitcast<i32>(param_1) {
        case 0: {
            phi_4468_ = param;
            break;
        }
        case 1: {
            phi_4468_ = array<f32, 4>(param[0], param[3], param[1], param[2]);
            break;
        }
        default: {
            phi_4468_ = array<f32, 4>(param[0], param[2], param[3], param[1]);
            break;
        }
    }
    let _e14 = phi_4468_;
    return _e14;
}

fn function_1(param_2: array<array<f32, 3>, 2>) -> array<f32, 3> {
    return array<f32, 3>((param_2[1][0] - param_2[0][0]), (param_2[1][1] - param_2[0][1]), (param_2[1][2] - param_2[0][2]));
}

fn function_2(param_3: type_34, param_4: type_34) -> type_34 {
    var phi_4436_: type_34;

    if (param_4.member_3 < param_3.member_3) {
        phi_4436_ = param_4;
    } else {
        phi_4436_ = param_3;
    }
    let _e6 = phi_4436_;
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
    var phi_4153_: type_34;
    var phi_4154_: bool;
    var phi_4155_: type_34;
    var phi_4156_: bool;
    var phi_4038_: type_34;
    var phi_4039_: bool;
    var phi_4040_: type_34;
    var phi_4041_: bool;
    var phi_4042_: type_34;
    var phi_4043_: bool;
    var phi_4160_: type_34;
    var phi_4161_: bool;
    var phi_4236_: type_34;
    var phi_4237_: type_34;
    var phi_4238_: bool;
    var phi_4242_: type_34;

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
                    phi_4038_ = _e176;
                    phi_4039_ = false;
                } else {
                    phi_4038_ = type_34();
                    phi_4039_ = true;
                }
                let _e178 = phi_4038_;
                let _e180 = phi_4039_;
                phi_4040_ = _e178;
                phi_4041_ = _e180;
            } else {
                phi_4040_ = type_34();
                phi_4041_ = true;
            }
            let _e182 = phi_4040_;
            let _e184 = phi_4041_;
            phi_4042_ = _e182;
            phi_4043_ = _e184;
        } else {
            phi_4042_ = type_34();
            phi_4043_ = true;
        }
        let _e186 = phi_4042_;
        let _e188 = phi_4043_;
        phi_4160_ = _e186;
        phi_4161_ = _e188;
    } else {
        if _e9 {
            phi_4155_ = type_34();
            phi_4156_ = true;
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
                phi_4153_ = _e78;
                phi_4154_ = false;
            } else {
                phi_4153_ = type_34();
                phi_4154_ = true;
            }
            let _e80 = phi_4153_;
            let _e82 = phi_4154_;
            phi_4155_ = _e80;
            phi_4156_ = _e82;
        }
        let _e84 = phi_4155_;
        let _e86 = phi_4156_;
        phi_4160_ = _e84;
        phi_4161_ = _e86;
    }
    let _e190 = phi_4160_;
    let _e192 = phi_4161_;
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
            phi_4236_ = _e244;
        } else {
            let _e198 = function_6(param_16, 1f, 1f);
            let _e199 = function_5(param_16, 1f, _e198);
            let _e200 = function_4(param_16, 1f, 1f);
            let _e201 = function_5(param_16, _e200, 1f);
            let _e202 = function_2(_e199, _e201);
            let _e203 = function_2(_e197, _e202);
            phi_4236_ = _e203;
        }
        let _e246 = phi_4236_;
        phi_4237_ = _e246;
        phi_4238_ = false;
    } else {
        phi_4237_ = type_34();
        phi_4238_ = true;
    }
    let _e248 = phi_4237_;
    let _e250 = phi_4238_;
    if _e250 {
        phi_4242_ = _e190;
    } else {
        phi_4242_ = _e248;
    }
    let _e252 = phi_4242_;
    return _e252;
}

fn function_8(param_18: f32) -> f32 {
    var phi_3871_: f32;
    var phi_3872_: f32;

    if ((bitcast<u32>(param_18) & 2139095040u) != 2139095040u) {
        if (param_18 >= 0.000000000000000000000000000000000000011754944f) {
            let _e13 = (2130706432u - (bitcast<u32>(param_18) & 2139095040u));
            phi_3871_ = bitcast<f32>(select(8388608u, _e13, (_e13 > 8388608u)));
        } else {
            phi_3871_ = (1f / 0.000000000000000000000000000000000000011754944f);
        }
        let _e18 = phi_3871_;
        phi_3872_ = _e18;
    } else {
        phi_3872_ = 1f;
    }
    let _e20 = phi_3872_;
    return _e20;
}

fn function_9(param_19: array<f32, 3>, param_20: array<f32, 3>, param_21: f32) -> array<f32, 3> {
    let _e4 = (1f - param_21);
    return array<f32, 3>(((param_19[0] * _e4) + (param_20[0] * param_21)), ((param_19[1] * _e4) + (param_20[1] * param_21)), ((param_19[2] * _e4) + (param_20[2] * param_21)));
}

fn function_10(param_22: ptr<function, array<array<f32, 3>, 4>>, param_23: u32) -> array<array<f32, 3>, 4> {
    var phi_3845_: array<array<f32, 3>, 4>;

    switch bitcast<i32>(param_23) {
        case 0: {
            let _e32 = (*param_22);
            phi_3845_ = array<array<f32, 3>, 4>(array<f32, 3>(_e32[0][0], _e32[0][1], _e32[0][2]), array<f32, 3>(_e32[1][0], _e32[1][1], _e32[1][2]), array<f32, 3>(_e32[2][0], _e32[2][1], _e32[2][2]), array<f32, 3>(_e32[3][0], _e32[3][1], _e32[3][2]));
            break;
        }
        case 1: {
            let _e8 = (*param_22)[0u];
            let _e14 = (*param_22)[2u];
            let _e20 = (*param_22)[3u];
            let _e26 = (*param_22)[1u];
            phi_3845_ = array<array<f32, 3>, 4>(array<f32, 3>(_e8[0], _e8[1], _e8[2]), array<f32, 3>(_e14[0], _e14[1], _e14[2]), array<f32, 3>(_e20[0], _e20[1], _e20[2]), array<f32, 3>(_e26[0], _e26[1], _e26[2]));
            break;
        }
        default: {
            let _e55 = (*param_22)[0u];
            let _e61 = (*param_22)[3u];
            let _e67 = (*param_22)[1u];
            let _e73 = (*param_22)[2u];
            phi_3845_ = array<array<f32, 3>, 4>(array<f32, 3>(_e55[0], _e55[1], _e55[2]), array<f32, 3>(_e61[0], _e61[1], _e61[2]), array<f32, 3>(_e67[0], _e67[1], _e67[2]), array<f32, 3>(_e73[0], _e73[1], _e73[2]));
            break;
        }
    }
    let _e80 = phi_3845_;
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
    var phi_184_: u32;
    var phi_229_: u32;
    var phi_232_: type_9;
    var phi_444_: type_21;
    var phi_603_: u32;
    var phi_764_: type_33;
    var phi_1220_: type_14;
    var phi_1223_: f32;
    var phi_1221_: type_14;
    var phi_1264_: type_15;
    var phi_1224_: f32;
    var local_3: f32;
    var phi_1277_: f32;
    var phi_1285_: f32;
    var phi_1340_: type_14;
    var phi_1343_: f32;
    var phi_1341_: type_14;
    var phi_1384_: type_15;
    var phi_1344_: f32;
    var local_4: f32;
    var phi_1397_: f32;
    var phi_1405_: f32;
    var phi_2098_: type_14;
    var phi_2101_: f32;
    var phi_2099_: type_14;
    var phi_2142_: type_15;
    var phi_2102_: f32;
    var local_5: f32;
    var phi_2155_: f32;
    var phi_2223_: array<f32, 3>;
    var phi_2224_: bool;
    var phi_2225_: array<f32, 3>;
    var phi_2226_: bool;
    var phi_2272_: array<f32, 3>;
    var phi_2273_: bool;
    var phi_2274_: array<f32, 3>;
    var phi_2275_: bool;
    var phi_2276_: array<f32, 3>;
    var phi_2277_: bool;
    var phi_2366_: bool;
    var phi_2376_: array<f32, 3>;
    var phi_2377_: bool;
    var phi_2378_: array<f32, 3>;
    var phi_2379_: bool;
    var phi_2393_: array<f32, 3>;
    var phi_2394_: array<f32, 3>;
    var phi_2395_: array<f32, 3>;
    var phi_2533_: type_14;
    var phi_2536_: f32;
    var phi_2534_: type_14;
    var phi_2577_: type_15;
    var phi_2537_: f32;
    var local_6: f32;
    var phi_2590_: f32;
    var phi_2617_: array<f32, 3>;
    var phi_2709_: type_14;
    var phi_2712_: f32;
    var phi_2710_: type_14;
    var phi_2753_: type_15;
    var phi_2713_: f32;
    var local_7: f32;
    var phi_2766_: f32;
    var phi_2782_: array<f32, 3>;
    var phi_2783_: bool;
    var phi_2784_: array<f32, 3>;
    var phi_2785_: bool;
    var phi_3068_: array<f32, 3>;
    var phi_3069_: bool;
    var phi_3080_: array<f32, 3>;
    var phi_3144_: type_14;
    var phi_3147_: f32;
    var phi_3145_: type_14;
    var phi_3188_: type_15;
    var phi_3148_: f32;
    var local_8: f32;
    var phi_3201_: f32;
    var phi_3288_: type_14;
    var phi_3291_: f32;
    var phi_3289_: type_14;
    var phi_3332_: type_15;
    var phi_3292_: f32;
    var local_9: f32;
    var phi_3345_: f32;
    var phi_3362_: array<f32, 3>;
    var phi_2849_: type_14;
    var phi_2852_: f32;
    var phi_2850_: type_14;
    var phi_2893_: type_15;
    var phi_2853_: f32;
    var local_10: f32;
    var phi_2906_: f32;
    var phi_3363_: array<f32, 3>;
    var phi_3385_: array<f32, 3>;
    var phi_3386_: bool;
    var phi_3387_: array<f32, 3>;
    var phi_3388_: array<f32, 3>;
    var phi_3389_: bool;
    var phi_1605_: type_14;
    var phi_1608_: f32;
    var phi_1606_: type_14;
    var phi_1649_: type_15;
    var phi_1609_: f32;
    var local_11: f32;
    var phi_1662_: f32;
    var phi_1678_: array<f32, 3>;
    var phi_1679_: bool;
    var phi_1680_: array<f32, 3>;
    var phi_1681_: bool;
    var phi_1682_: array<f32, 3>;
    var phi_1683_: bool;
    var phi_1744_: type_14;
    var phi_1747_: f32;
    var phi_1745_: type_14;
    var phi_1788_: type_15;
    var phi_1748_: f32;
    var local_12: f32;
    var phi_1801_: f32;
    var phi_1817_: array<f32, 3>;
    var phi_3393_: array<f32, 3>;
    var phi_3394_: array<f32, 3>;
    var phi_3395_: bool;
    var phi_3472_: array<f32, 3>;
    var phi_3473_: array<f32, 3>;
    var phi_3474_: array<f32, 4>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e55 = id_2;
    let _e56 = n_2;
    let _e57 = lane_2;
    let _e67 = ((_e55.y * _e56.x) + _e55.x);
    let _e70 = (_e56.x * _e56.y);
    let _e73 = params.member.member_1.member_2;
    let _e75 = contacts.member[0u];
    let _e77 = select(_e75, _e73, (_e73 < _e75));
    let _e79 = params.member.member_1.member_1;
    if (_e77 > _e79) {
        let _e82 = params.member.member_1.member_1;
        phi_184_ = (_e77 - _e82);
    } else {
        phi_184_ = 0u;
    }
    let _e85 = phi_184_;
    let _e87 = params.member.member_1.member;
    let _e89 = select(_e85, _e87, (_e87 < _e85));
    let _e90 = (_e89 / 64u);
    let _e94 = select(_e90, (_e90 + 1u), ((_e89 % 64u) > 0u));
    if (_e94 > _e67) {
        let _e96 = (_e94 - _e67);
        if (_e70 == 0u) {
            return;
        }
        let _e98 = (_e96 / _e70);
        if (_e70 == 0u) {
            return;
        }
        phi_229_ = select(_e98, (_e98 + 1u), ((_e96 % _e70) > 0u));
    } else {
        phi_229_ = 0u;
    }
    let _e105 = phi_229_;
    phi_232_ = type_9(0u, _e105);
    loop {
        let _e108 = phi_232_;
        let _e111 = (_e108.member < _e108.member_1);
        let _e124 = (bitcast<i32>(select(0u, 1u, _e111)) != 0i);
        if _e124 {
            let _e128 = (((_e67 + (select(type_9().member_1, _e108.member, _e111) * _e70)) * 64u) + _e57);
            if (_e128 < _e89) {
                let _e132 = params.member.member_1.member_1;
                let _e133 = (_e132 + _e128);
                let _e134 = (7u * _e133);
                let _e137 = contacts.member[(4u + _e134)];
                let _e140 = contacts.member[(_e134 + 5u)];
                let _e143 = contacts.member[(_e134 + 6u)];
                let _e146 = contacts.member[(_e134 + 7u)];
                let _e149 = contacts.member[(_e134 + 8u)];
                let _e152 = contacts.member[(_e134 + 9u)];
                if (_e137 == 0u) {
                    let _e171 = params.member.member.member[1u];
                    let _e174 = ((2u * _e171) + (3u * _e146));
                    let _e176 = elements.member[_e174];
                    let _e179 = elements.member[(_e174 + 1u)];
                    let _e182 = elements.member[(_e174 + 2u)];
                    phi_444_ = type_21(0u, array<u32, 4>(_e143, _e176, _e179, _e182));
                } else {
                    let _e155 = (2u * _e143);
                    let _e157 = elements.member[_e155];
                    let _e160 = elements.member[(_e155 + 1u)];
                    let _e161 = (2u * _e146);
                    let _e163 = elements.member[_e161];
                    let _e166 = elements.member[(_e161 + 1u)];
                    phi_444_ = type_21(1u, array<u32, 4>(_e157, _e160, _e163, _e166));
                }
                let _e186 = phi_444_;
                let _e191 = paths.member[_e186.member_1[0]];
                let _e194 = paths.member[_e186.member_1[1]];
                let _e201 = paths.member[_e186.member_1[2]];
                let _e204 = paths.member[_e186.member_1[3]];
                local_1 = array<array<f32, 3>, 4>(array<f32, 3>(_e191.member[0], _e191.member[1], _e191.member[2]), array<f32, 3>(_e194.member[0], _e194.member[1], _e194.member[2]), array<f32, 3>(_e201.member[0], _e201.member[1], _e201.member[2]), array<f32, 3>(_e204.member[0], _e204.member[1], _e204.member[2]));
                local_2 = array<array<f32, 3>, 4>(array<f32, 3>(_e191.member_1[0], _e191.member_1[1], _e191.member_1[2]), array<f32, 3>(_e194.member_1[0], _e194.member_1[1], _e194.member_1[2]), array<f32, 3>(_e201.member_1[0], _e201.member_1[1], _e201.member_1[2]), array<f32, 3>(_e204.member_1[0], _e204.member_1[1], _e204.member_1[2]));
                let _e245 = ((_e152 >> bitcast<u32>(20i)) & 2047u);
                let _e257 = select(((((_e245 - 896u) << bitcast<u32>(23i)) | ((_e152 & 1048575u) << bitcast<u32>(3i))) | (_e149 >> bitcast<u32>(29i))), 0u, (_e245 <= 896u));
                let _e263 = params.member.member.member_4;
                let _e264 = function_3(select(1f, bitcast<f32>(_e257), (_e257 < 1065353216u)), 1f);
                if (_e186.member == 0u) {
                    let _e266 = function_11((&local_1), (&local_2), _e264);
                    phi_603_ = _e266;
                } else {
                    phi_603_ = 0u;
                }
                let _e268 = phi_603_;
                let _e269 = function_10((&local_1), _e268);
                let _e270 = function_10((&local_2), _e268);
                if (_e186.member != 0u) {
                    phi_764_ = type_33(array<array<f32, 3>, 2>(array<f32, 3>((_e269[2][0] - _e269[0][0]), (_e269[2][1] - _e269[0][1]), (_e269[2][2] - _e269[0][2])), array<f32, 3>((_e270[2][0] - _e270[0][0]), (_e270[2][1] - _e270[0][1]), (_e270[2][2] - _e270[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e269[1][0] - _e269[0][0]), (_e269[1][1] - _e269[0][1]), (_e269[1][2] - _e269[0][2])), array<f32, 3>((_e270[1][0] - _e270[0][0]), (_e270[1][1] - _e270[0][1]), (_e270[1][2] - _e270[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e269[2][0] - _e269[3][0]), (_e269[2][1] - _e269[3][1]), (_e269[2][2] - _e269[3][2])), array<f32, 3>((_e270[2][0] - _e270[3][0]), (_e270[2][1] - _e270[3][1]), (_e270[2][2] - _e270[3][2]))), (_e263 + _e263));
                } else {
                    phi_764_ = type_33(array<array<f32, 3>, 2>(array<f32, 3>((_e269[0][0] - _e269[1][0]), (_e269[0][1] - _e269[1][1]), (_e269[0][2] - _e269[1][2])), array<f32, 3>((_e270[0][0] - _e270[1][0]), (_e270[0][1] - _e270[1][1]), (_e270[0][2] - _e270[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e269[2][0] - _e269[1][0]), (_e269[2][1] - _e269[1][1]), (_e269[2][2] - _e269[1][2])), array<f32, 3>((_e270[2][0] - _e270[1][0]), (_e270[2][1] - _e270[1][1]), (_e270[2][2] - _e270[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e269[3][0] - _e269[1][0]), (_e269[3][1] - _e269[1][1]), (_e269[3][2] - _e269[1][2])), array<f32, 3>((_e270[3][0] - _e270[1][0]), (_e270[3][1] - _e270[1][1]), (_e270[3][2] - _e270[1][2]))), (_e263 + _e263));
                }
                let _e427 = phi_764_;
                let _e432 = function_9(_e427.member[0], _e427.member[1], _e264);
                let _e437 = function_9(_e427.member_1[0], _e427.member_1[1], _e264);
                let _e442 = function_9(_e427.member_2[0], _e427.member_2[1], _e264);
                let _e446 = select(_e432[0], -(_e432[0]), (_e432[0] < 0f));
                let _e450 = select(_e432[1], -(_e432[1]), (_e432[1] < 0f));
                let _e452 = select(_e450, _e446, (_e446 > _e450));
                let _e456 = select(_e432[2], -(_e432[2]), (_e432[2] < 0f));
                let _e458 = select(_e456, _e452, (_e452 > _e456));
                let _e462 = select(_e437[0], -(_e437[0]), (_e437[0] < 0f));
                let _e466 = select(_e437[1], -(_e437[1]), (_e437[1] < 0f));
                let _e468 = select(_e466, _e462, (_e462 > _e466));
                let _e472 = select(_e437[2], -(_e437[2]), (_e437[2] < 0f));
                let _e474 = select(_e472, _e468, (_e468 > _e472));
                let _e476 = select(_e474, _e458, (_e458 > _e474));
                let _e480 = select(_e442[0], -(_e442[0]), (_e442[0] < 0f));
                let _e484 = select(_e442[1], -(_e442[1]), (_e442[1] < 0f));
                let _e486 = select(_e484, _e480, (_e480 > _e484));
                let _e490 = select(_e442[2], -(_e442[2]), (_e442[2] < 0f));
                let _e492 = select(_e490, _e486, (_e486 > _e490));
                let _e495 = function_8(select(_e492, _e476, (_e476 > _e492)));
                let _e503 = (_e437[0] * _e495);
                let _e505 = (_e437[1] * _e495);
                let _e507 = (_e437[2] * _e495);
                let _e509 = (_e442[0] * _e495);
                let _e511 = (_e442[1] * _e495);
                let _e513 = (_e442[2] * _e495);
                let _e519 = select(_e427.member[0][0], -(_e427.member[0][0]), (_e427.member[0][0] < 0f));
                let _e523 = select(_e427.member[0][1], -(_e427.member[0][1]), (_e427.member[0][1] < 0f));
                let _e525 = select(_e523, _e519, (_e519 > _e523));
                let _e529 = select(_e427.member[0][2], -(_e427.member[0][2]), (_e427.member[0][2] < 0f));
                let _e531 = select(_e529, _e525, (_e525 > _e529));
                let _e537 = select(_e427.member[1][0], -(_e427.member[1][0]), (_e427.member[1][0] < 0f));
                let _e541 = select(_e427.member[1][1], -(_e427.member[1][1]), (_e427.member[1][1] < 0f));
                let _e543 = select(_e541, _e537, (_e537 > _e541));
                let _e547 = select(_e427.member[1][2], -(_e427.member[1][2]), (_e427.member[1][2] < 0f));
                let _e549 = select(_e547, _e543, (_e543 > _e547));
                let _e559 = select(_e427.member_1[0][0], -(_e427.member_1[0][0]), (_e427.member_1[0][0] < 0f));
                let _e563 = select(_e427.member_1[0][1], -(_e427.member_1[0][1]), (_e427.member_1[0][1] < 0f));
                let _e565 = select(_e563, _e559, (_e559 > _e563));
                let _e569 = select(_e427.member_1[0][2], -(_e427.member_1[0][2]), (_e427.member_1[0][2] < 0f));
                let _e571 = select(_e569, _e565, (_e565 > _e569));
                let _e577 = select(_e427.member_1[1][0], -(_e427.member_1[1][0]), (_e427.member_1[1][0] < 0f));
                let _e581 = select(_e427.member_1[1][1], -(_e427.member_1[1][1]), (_e427.member_1[1][1] < 0f));
                let _e583 = select(_e581, _e577, (_e577 > _e581));
                let _e587 = select(_e427.member_1[1][2], -(_e427.member_1[1][2]), (_e427.member_1[1][2] < 0f));
                let _e589 = select(_e587, _e583, (_e583 > _e587));
                let _e593 = (select(_e589, _e571, (_e571 > _e589)) + _e427.member_3);
                let _e599 = select(_e427.member_2[0][0], -(_e427.member_2[0][0]), (_e427.member_2[0][0] < 0f));
                let _e603 = select(_e427.member_2[0][1], -(_e427.member_2[0][1]), (_e427.member_2[0][1] < 0f));
                let _e605 = select(_e603, _e599, (_e599 > _e603));
                let _e609 = select(_e427.member_2[0][2], -(_e427.member_2[0][2]), (_e427.member_2[0][2] < 0f));
                let _e611 = select(_e609, _e605, (_e605 > _e609));
                let _e617 = select(_e427.member_2[1][0], -(_e427.member_2[1][0]), (_e427.member_2[1][0] < 0f));
                let _e621 = select(_e427.member_2[1][1], -(_e427.member_2[1][1]), (_e427.member_2[1][1] < 0f));
                let _e623 = select(_e621, _e617, (_e617 > _e621));
                let _e627 = select(_e427.member_2[1][2], -(_e427.member_2[1][2]), (_e427.member_2[1][2] < 0f));
                let _e629 = select(_e627, _e623, (_e623 > _e627));
                let _e633 = (select(_e629, _e611, (_e611 > _e629)) + _e427.member_3);
                let _e634 = (0.000000059604645f * 16f);
                let _e636 = (_e427.member_3 * 4f);
                let _e644 = ((_e505 * _e513) - (_e507 * _e511));
                let _e647 = ((_e507 * _e509) - (_e503 * _e513));
                let _e650 = ((_e503 * _e511) - (_e505 * _e509));
                let _e658 = select(_e509, -(_e509), (_e509 < 0f));
                let _e661 = select(_e511, -(_e511), (_e511 < 0f));
                let _e663 = select(_e661, _e658, (_e658 > _e661));
                let _e666 = select(_e513, -(_e513), (_e513 < 0f));
                let _e673 = select(_e503, -(_e503), (_e503 < 0f));
                let _e676 = select(_e505, -(_e505), (_e505 < 0f));
                let _e678 = select(_e676, _e673, (_e673 > _e676));
                let _e681 = select(_e507, -(_e507), (_e507 < 0f));
                let _e685 = (((((_e593 * _e634) + _e636) * _e495) * select(_e666, _e663, (_e663 > _e666))) + ((((_e633 * _e634) + _e636) * _e495) * select(_e681, _e678, (_e678 > _e681))));
                let _e690 = (((_e644 * _e644) + (_e647 * _e647)) + (_e650 * _e650));
                if (_e690 <= 0.000000000000000000000000000000000000011754944f) {
                    phi_1277_ = select(0f, (0.000000000000000000106433627f * 2f), (_e690 > 0f));
                } else {
                    phi_1220_ = type_14(0i, 5i);
                    phi_1223_ = bitcast<f32>(((bitcast<u32>(_e690) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e698 = phi_1220_;
                        let _e700 = phi_1223_;
                        local_3 = _e700;
                        if (_e698.member < _e698.member_1) {
                            let _e707 = (_e698.member + 1i);
                            phi_1221_ = type_14(select(_e707, type_15().member_1, select(false, true, ((false == (_e707 > _e698.member)) != false))), _e698.member_1);
                            phi_1264_ = type_15(1u, _e698.member);
                        } else {
                            phi_1221_ = _e698;
                            phi_1264_ = type_15(0u, type_15().member_1);
                        }
                        let _e718 = phi_1221_;
                        let _e720 = phi_1264_;
                        let _e723 = (bitcast<i32>(_e720.member) != 0i);
                        if _e723 {
                            phi_1224_ = (0.5f * (_e700 + (_e690 / _e700)));
                        } else {
                            phi_1224_ = f32();
                        }
                        let _e728 = phi_1224_;
                        continue;
                        continuing {
                            phi_1220_ = _e718;
                            phi_1223_ = _e728;
                            break if !(_e723);
                        }
                    }
                    let _e733 = local_3;
                    phi_1277_ = (_e733 * (1f + (8f * 0.000000059604645f)));
                }
                let _e739 = phi_1277_;
                if (_e739 > 0f) {
                    phi_1285_ = ((_e739 + (_e690 / _e739)) * 0.5f);
                } else {
                    phi_1285_ = _e739;
                }
                let _e745 = phi_1285_;
                local = type_22(array<f32, 3>((_e432[0] * _e495), (_e432[1] * _e495), (_e432[2] * _e495)), array<f32, 3>(_e503, _e505, _e507), array<f32, 3>(_e509, _e511, _e513), array<f32, 3>(_e644, _e647, _e650), select(0f, _e745, (_e745 > _e685)), _e685, ((((((select(_e549, _e531, (_e531 > _e549)) + _e427.member_3) + _e593) + _e633) * _e634) + _e636) * _e495));
                let _e753 = function_7((&local), _e186.member);
                if (_e753.member_3 <= 0.000000000000000000000000000000000000011754944f) {
                    phi_1397_ = select(0f, (0.000000000000000000106433627f * 2f), (_e753.member_3 > 0f));
                } else {
                    phi_1340_ = type_14(0i, 5i);
                    phi_1343_ = bitcast<f32>(((bitcast<u32>(_e753.member_3) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e764 = phi_1340_;
                        let _e766 = phi_1343_;
                        local_4 = _e766;
                        if (_e764.member < _e764.member_1) {
                            let _e773 = (_e764.member + 1i);
                            phi_1341_ = type_14(select(_e773, type_15().member_1, select(false, true, ((false == (_e773 > _e764.member)) != false))), _e764.member_1);
                            phi_1384_ = type_15(1u, _e764.member);
                        } else {
                            phi_1341_ = _e764;
                            phi_1384_ = type_15(0u, type_15().member_1);
                        }
                        let _e784 = phi_1341_;
                        let _e786 = phi_1384_;
                        let _e789 = (bitcast<i32>(_e786.member) != 0i);
                        if _e789 {
                            phi_1344_ = (0.5f * (_e766 + (_e753.member_3 / _e766)));
                        } else {
                            phi_1344_ = f32();
                        }
                        let _e794 = phi_1344_;
                        continue;
                        continuing {
                            phi_1340_ = _e784;
                            phi_1343_ = _e794;
                            break if !(_e789);
                        }
                    }
                    let _e799 = local_4;
                    phi_1397_ = (_e799 * (1f + (8f * 0.000000059604645f)));
                }
                let _e805 = phi_1397_;
                if (_e805 > 0f) {
                    phi_1405_ = ((_e805 + (_e753.member_3 / _e805)) * 0.5f);
                } else {
                    phi_1405_ = _e805;
                }
                let _e811 = phi_1405_;
                let _e814 = select(-(1f), 1f, (_e186.member == 0u));
                let _e816 = function_1(_e427.member);
                let _e818 = function_1(_e427.member_1);
                let _e832 = function_1(_e427.member_2);
                let _e842 = (((_e816[0] - (_e818[0] * _e753.member)) - (_e832[0] * _e753.member_1)) * _e814);
                let _e843 = (((_e816[1] - (_e818[1] * _e753.member)) - (_e832[1] * _e753.member_1)) * _e814);
                let _e844 = (((_e816[2] - (_e818[2] * _e753.member)) - (_e832[2] * _e753.member_1)) * _e814);
                let _e850 = select(false, (_e753.member < 1f), (_e753.member > 0f));
                let _e853 = select(false, (_e753.member_1 < 1f), (_e753.member_1 > 0f));
                let _e854 = (_e814 > 0f);
                let _e864 = select(select(bool(), select(bool(), select(true, ((_e753.member + _e753.member_1) < (1f - (0.000000059604645f * 4f))), _e854), _e853), _e850), false, select(true, select(true, false, _e853), _e850));
                let _e866 = local.member_4;
                let _e867 = (_e866 > 0f);
                let _e869 = local.member_3;
                let _e873 = (_e869[0] * _e814);
                let _e874 = (_e869[1] * _e814);
                let _e875 = (_e869[2] * _e814);
                let _e877 = local.member_6;
                if (_e811 > _e877) {
                    let _e1877 = (_e753.member_2[0] * _e814);
                    let _e1879 = (_e753.member_2[1] * _e814);
                    let _e1881 = (_e753.member_2[2] * _e814);
                    if _e867 {
                        if _e864 {
                            let _e1883 = local.member_5;
                            let _e1886 = local.member_6;
                            let _e1888 = local.member_4;
                            if ((_e1883 * _e811) <= (_e1886 * _e1888)) {
                                let _e1896 = ((((_e1877 * _e873) + (_e1879 * _e874)) + (_e1881 * _e875)) >= 0f);
                                let _e1897 = -(1f);
                                let _e1901 = select((_e873 * _e1897), _e873, _e1896);
                                let _e1902 = select((_e874 * _e1897), _e874, _e1896);
                                let _e1903 = select((_e875 * _e1897), _e875, _e1896);
                                let _e1906 = select(_e1901, -(_e1901), (_e1901 < 0f));
                                let _e1909 = select(_e1902, -(_e1902), (_e1902 < 0f));
                                let _e1911 = select(_e1909, _e1906, (_e1906 > _e1909));
                                let _e1914 = select(_e1903, -(_e1903), (_e1903 < 0f));
                                let _e1917 = function_8(select(_e1914, _e1911, (_e1911 > _e1914)));
                                let _e1918 = (_e1901 * _e1917);
                                let _e1919 = (_e1902 * _e1917);
                                let _e1920 = (_e1903 * _e1917);
                                let _e1925 = (((_e1918 * _e1918) + (_e1919 * _e1919)) + (_e1920 * _e1920));
                                if (_e1925 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_1662_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1925 > 0f));
                                } else {
                                    phi_1605_ = type_14(0i, 5i);
                                    phi_1608_ = bitcast<f32>(((bitcast<u32>(_e1925) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1933 = phi_1605_;
                                        let _e1935 = phi_1608_;
                                        local_11 = _e1935;
                                        if (_e1933.member < _e1933.member_1) {
                                            let _e1942 = (_e1933.member + 1i);
                                            phi_1606_ = type_14(select(_e1942, type_15().member_1, select(false, true, ((false == (_e1942 > _e1933.member)) != false))), _e1933.member_1);
                                            phi_1649_ = type_15(1u, _e1933.member);
                                        } else {
                                            phi_1606_ = _e1933;
                                            phi_1649_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1953 = phi_1606_;
                                        let _e1955 = phi_1649_;
                                        let _e1958 = (bitcast<i32>(_e1955.member) != 0i);
                                        if _e1958 {
                                            phi_1609_ = (0.5f * (_e1935 + (_e1925 / _e1935)));
                                        } else {
                                            phi_1609_ = f32();
                                        }
                                        let _e1963 = phi_1609_;
                                        continue;
                                        continuing {
                                            phi_1605_ = _e1953;
                                            phi_1608_ = _e1963;
                                            break if !(_e1958);
                                        }
                                    }
                                    let _e1968 = local_11;
                                    phi_1662_ = (_e1968 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1974 = phi_1662_;
                                let _e1975 = (1f / _e1974);
                                let _e1976 = (_e1918 * _e1975);
                                let _e1977 = (_e1919 * _e1975);
                                let _e1978 = (_e1920 * _e1975);
                                let _e1985 = ((3f - (((_e1976 * _e1976) + (_e1977 * _e1977)) + (_e1978 * _e1978))) * 0.5f);
                                phi_1678_ = array<f32, 3>((_e1976 * _e1985), (_e1977 * _e1985), (_e1978 * _e1985));
                                phi_1679_ = false;
                            } else {
                                phi_1678_ = array<f32, 3>();
                                phi_1679_ = true;
                            }
                            let _e1991 = phi_1678_;
                            let _e1993 = phi_1679_;
                            phi_1680_ = _e1991;
                            phi_1681_ = _e1993;
                        } else {
                            phi_1680_ = array<f32, 3>();
                            phi_1681_ = true;
                        }
                        let _e1995 = phi_1680_;
                        let _e1997 = phi_1681_;
                        phi_1682_ = _e1995;
                        phi_1683_ = _e1997;
                    } else {
                        phi_1682_ = array<f32, 3>();
                        phi_1683_ = true;
                    }
                    let _e1999 = phi_1682_;
                    let _e2001 = phi_1683_;
                    if _e2001 {
                        let _e2004 = select(_e1877, -(_e1877), (_e1877 < 0f));
                        let _e2007 = select(_e1879, -(_e1879), (_e1879 < 0f));
                        let _e2009 = select(_e2007, _e2004, (_e2004 > _e2007));
                        let _e2012 = select(_e1881, -(_e1881), (_e1881 < 0f));
                        let _e2015 = function_8(select(_e2012, _e2009, (_e2009 > _e2012)));
                        let _e2016 = (_e1877 * _e2015);
                        let _e2017 = (_e1879 * _e2015);
                        let _e2018 = (_e1881 * _e2015);
                        let _e2023 = (((_e2016 * _e2016) + (_e2017 * _e2017)) + (_e2018 * _e2018));
                        if (_e2023 <= 0.000000000000000000000000000000000000011754944f) {
                            phi_1801_ = select(0f, (0.000000000000000000106433627f * 2f), (_e2023 > 0f));
                        } else {
                            phi_1744_ = type_14(0i, 5i);
                            phi_1747_ = bitcast<f32>(((bitcast<u32>(_e2023) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e2031 = phi_1744_;
                                let _e2033 = phi_1747_;
                                local_12 = _e2033;
                                if (_e2031.member < _e2031.member_1) {
                                    let _e2040 = (_e2031.member + 1i);
                                    phi_1745_ = type_14(select(_e2040, type_15().member_1, select(false, true, ((false == (_e2040 > _e2031.member)) != false))), _e2031.member_1);
                                    phi_1788_ = type_15(1u, _e2031.member);
                                } else {
                                    phi_1745_ = _e2031;
                                    phi_1788_ = type_15(0u, type_15().member_1);
                                }
                                let _e2051 = phi_1745_;
                                let _e2053 = phi_1788_;
                                let _e2056 = (bitcast<i32>(_e2053.member) != 0i);
                                if _e2056 {
                                    phi_1748_ = (0.5f * (_e2033 + (_e2023 / _e2033)));
                                } else {
                                    phi_1748_ = f32();
                                }
                                let _e2061 = phi_1748_;
                                continue;
                                continuing {
                                    phi_1744_ = _e2051;
                                    phi_1747_ = _e2061;
                                    break if !(_e2056);
                                }
                            }
                            let _e2066 = local_12;
                            phi_1801_ = (_e2066 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e2072 = phi_1801_;
                        let _e2073 = (1f / _e2072);
                        let _e2074 = (_e2016 * _e2073);
                        let _e2075 = (_e2017 * _e2073);
                        let _e2076 = (_e2018 * _e2073);
                        let _e2083 = ((3f - (((_e2074 * _e2074) + (_e2075 * _e2075)) + (_e2076 * _e2076))) * 0.5f);
                        phi_1817_ = array<f32, 3>((_e2074 * _e2083), (_e2075 * _e2083), (_e2076 * _e2083));
                    } else {
                        phi_1817_ = _e1999;
                    }
                    let _e2089 = phi_1817_;
                    phi_3393_ = _e2089;
                    phi_3394_ = array<f32, 3>();
                    phi_3395_ = true;
                } else {
                    let _e884 = select(_e427.member[0][0], -(_e427.member[0][0]), (_e427.member[0][0] < 0f));
                    let _e888 = select(_e427.member[0][1], -(_e427.member[0][1]), (_e427.member[0][1] < 0f));
                    let _e890 = select(_e888, _e884, (_e884 > _e888));
                    let _e894 = select(_e427.member[0][2], -(_e427.member[0][2]), (_e427.member[0][2] < 0f));
                    let _e896 = select(_e894, _e890, (_e890 > _e894));
                    let _e902 = select(_e427.member[1][0], -(_e427.member[1][0]), (_e427.member[1][0] < 0f));
                    let _e906 = select(_e427.member[1][1], -(_e427.member[1][1]), (_e427.member[1][1] < 0f));
                    let _e908 = select(_e906, _e902, (_e902 > _e906));
                    let _e912 = select(_e427.member[1][2], -(_e427.member[1][2]), (_e427.member[1][2] < 0f));
                    let _e914 = select(_e912, _e908, (_e908 > _e912));
                    let _e924 = select(_e427.member_1[0][0], -(_e427.member_1[0][0]), (_e427.member_1[0][0] < 0f));
                    let _e928 = select(_e427.member_1[0][1], -(_e427.member_1[0][1]), (_e427.member_1[0][1] < 0f));
                    let _e930 = select(_e928, _e924, (_e924 > _e928));
                    let _e934 = select(_e427.member_1[0][2], -(_e427.member_1[0][2]), (_e427.member_1[0][2] < 0f));
                    let _e936 = select(_e934, _e930, (_e930 > _e934));
                    let _e942 = select(_e427.member_1[1][0], -(_e427.member_1[1][0]), (_e427.member_1[1][0] < 0f));
                    let _e946 = select(_e427.member_1[1][1], -(_e427.member_1[1][1]), (_e427.member_1[1][1] < 0f));
                    let _e948 = select(_e946, _e942, (_e942 > _e946));
                    let _e952 = select(_e427.member_1[1][2], -(_e427.member_1[1][2]), (_e427.member_1[1][2] < 0f));
                    let _e954 = select(_e952, _e948, (_e948 > _e952));
                    let _e964 = select(_e427.member_2[0][0], -(_e427.member_2[0][0]), (_e427.member_2[0][0] < 0f));
                    let _e968 = select(_e427.member_2[0][1], -(_e427.member_2[0][1]), (_e427.member_2[0][1] < 0f));
                    let _e970 = select(_e968, _e964, (_e964 > _e968));
                    let _e974 = select(_e427.member_2[0][2], -(_e427.member_2[0][2]), (_e427.member_2[0][2] < 0f));
                    let _e976 = select(_e974, _e970, (_e970 > _e974));
                    let _e982 = select(_e427.member_2[1][0], -(_e427.member_2[1][0]), (_e427.member_2[1][0] < 0f));
                    let _e986 = select(_e427.member_2[1][1], -(_e427.member_2[1][1]), (_e427.member_2[1][1] < 0f));
                    let _e988 = select(_e986, _e982, (_e982 > _e986));
                    let _e992 = select(_e427.member_2[1][2], -(_e427.member_2[1][2]), (_e427.member_2[1][2] < 0f));
                    let _e994 = select(_e992, _e988, (_e988 > _e992));
                    let _e1005 = (((((select(_e914, _e896, (_e896 > _e914)) + _e427.member_3) + (select(_e954, _e936, (_e936 > _e954)) + _e427.member_3)) + (select(_e994, _e976, (_e976 > _e994)) + _e427.member_3)) * (0.000000059604645f * 32f)) + (_e427.member_3 * 8f));
                    if _e867 {
                        let _e1008 = select(_e873, -(_e873), (_e873 < 0f));
                        let _e1011 = select(_e874, -(_e874), (_e874 < 0f));
                        let _e1013 = select(_e1011, _e1008, (_e1008 > _e1011));
                        let _e1016 = select(_e875, -(_e875), (_e875 < 0f));
                        let _e1019 = function_8(select(_e1016, _e1013, (_e1013 > _e1016)));
                        let _e1020 = (_e873 * _e1019);
                        let _e1021 = (_e874 * _e1019);
                        let _e1022 = (_e875 * _e1019);
                        let _e1027 = (((_e1020 * _e1020) + (_e1021 * _e1021)) + (_e1022 * _e1022));
                        if (_e1027 <= 0.000000000000000000000000000000000000011754944f) {
                            phi_2155_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1027 > 0f));
                        } else {
                            phi_2098_ = type_14(0i, 5i);
                            phi_2101_ = bitcast<f32>(((bitcast<u32>(_e1027) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e1035 = phi_2098_;
                                let _e1037 = phi_2101_;
                                local_5 = _e1037;
                                if (_e1035.member < _e1035.member_1) {
                                    let _e1044 = (_e1035.member + 1i);
                                    phi_2099_ = type_14(select(_e1044, type_15().member_1, select(false, true, ((false == (_e1044 > _e1035.member)) != false))), _e1035.member_1);
                                    phi_2142_ = type_15(1u, _e1035.member);
                                } else {
                                    phi_2099_ = _e1035;
                                    phi_2142_ = type_15(0u, type_15().member_1);
                                }
                                let _e1055 = phi_2099_;
                                let _e1057 = phi_2142_;
                                let _e1060 = (bitcast<i32>(_e1057.member) != 0i);
                                if _e1060 {
                                    phi_2102_ = (0.5f * (_e1037 + (_e1027 / _e1037)));
                                } else {
                                    phi_2102_ = f32();
                                }
                                let _e1065 = phi_2102_;
                                continue;
                                continuing {
                                    phi_2098_ = _e1055;
                                    phi_2101_ = _e1065;
                                    break if !(_e1060);
                                }
                            }
                            let _e1070 = local_5;
                            phi_2155_ = (_e1070 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e1076 = phi_2155_;
                        let _e1077 = (1f / _e1076);
                        let _e1078 = (_e1020 * _e1077);
                        let _e1079 = (_e1021 * _e1077);
                        let _e1080 = (_e1022 * _e1077);
                        let _e1087 = ((3f - (((_e1078 * _e1078) + (_e1079 * _e1079)) + (_e1080 * _e1080))) * 0.5f);
                        let _e1088 = (_e1078 * _e1087);
                        let _e1089 = (_e1079 * _e1087);
                        let _e1090 = (_e1080 * _e1087);
                        let _e1095 = (((_e842 * _e1088) + (_e843 * _e1089)) + (_e844 * _e1090));
                        let _e1108 = local.member_5;
                        let _e1110 = local.member_4;
                        if (select(_e1095, -(_e1095), (_e1095 < 0f)) > (_e1005 + (((select(_e842, -(_e842), (_e842 < 0f)) + select(_e843, -(_e843), (_e843 < 0f))) + select(_e844, -(_e844), (_e844 < 0f))) * (_e1108 / _e1110)))) {
                            let _e1118 = (_e1095 < 0f);
                            let _e1119 = -(1f);
                            phi_2223_ = array<f32, 3>(select((_e1088 * _e1119), _e1088, _e1118), select((_e1089 * _e1119), _e1089, _e1118), select((_e1090 * _e1119), _e1090, _e1118));
                            phi_2224_ = false;
                        } else {
                            phi_2223_ = array<f32, 3>();
                            phi_2224_ = true;
                        }
                        let _e1128 = phi_2223_;
                        let _e1130 = phi_2224_;
                        phi_2225_ = _e1128;
                        phi_2226_ = _e1130;
                    } else {
                        phi_2225_ = array<f32, 3>();
                        phi_2226_ = true;
                    }
                    let _e1132 = phi_2225_;
                    let _e1134 = phi_2226_;
                    if _e1134 {
                        if select(true, select(true, false, _e864), _e867) {
                            if _e854 {
                                if _e850 {
                                    if _e853 {
                                        let _e1138 = local.member_2;
                                        let _e1143 = local.member_1;
                                        phi_2272_ = array<f32, 3>((_e1138[0] - _e1143[0]), (_e1138[1] - _e1143[1]), (_e1138[2] - _e1143[2]));
                                        phi_2273_ = false;
                                    } else {
                                        phi_2272_ = array<f32, 3>();
                                        phi_2273_ = true;
                                    }
                                    let _e1152 = phi_2272_;
                                    let _e1154 = phi_2273_;
                                    phi_2274_ = _e1152;
                                    phi_2275_ = _e1154;
                                } else {
                                    phi_2274_ = array<f32, 3>();
                                    phi_2275_ = true;
                                }
                                let _e1156 = phi_2274_;
                                let _e1158 = phi_2275_;
                                phi_2276_ = _e1156;
                                phi_2277_ = _e1158;
                            } else {
                                phi_2276_ = array<f32, 3>();
                                phi_2277_ = true;
                            }
                            let _e1160 = phi_2276_;
                            let _e1162 = phi_2277_;
                            if _e1162 {
                                if _e850 {
                                    if _e853 {
                                        let _e1164 = local.member_2;
                                        let _e1170 = select(_e1164[0], -(_e1164[0]), (_e1164[0] < 0f));
                                        let _e1173 = select(_e1164[1], -(_e1164[1]), (_e1164[1] < 0f));
                                        let _e1175 = select(_e1173, _e1170, (_e1170 > _e1173));
                                        let _e1178 = select(_e1164[2], -(_e1164[2]), (_e1164[2] < 0f));
                                        let _e1182 = local.member_1;
                                        let _e1188 = select(_e1182[0], -(_e1182[0]), (_e1182[0] < 0f));
                                        let _e1191 = select(_e1182[1], -(_e1182[1]), (_e1182[1] < 0f));
                                        let _e1193 = select(_e1191, _e1188, (_e1188 > _e1191));
                                        let _e1196 = select(_e1182[2], -(_e1182[2]), (_e1182[2] < 0f));
                                        phi_2366_ = select(true, false, (select(_e1178, _e1175, (_e1175 > _e1178)) > select(_e1196, _e1193, (_e1193 > _e1196))));
                                    } else {
                                        phi_2366_ = true;
                                    }
                                    let _e1202 = phi_2366_;
                                    if _e1202 {
                                        let _e1204 = local.member_1;
                                        phi_2376_ = array<f32, 3>(_e1204[0], _e1204[1], _e1204[2]);
                                        phi_2377_ = false;
                                    } else {
                                        phi_2376_ = array<f32, 3>();
                                        phi_2377_ = true;
                                    }
                                    let _e1210 = phi_2376_;
                                    let _e1212 = phi_2377_;
                                    phi_2378_ = _e1210;
                                    phi_2379_ = _e1212;
                                } else {
                                    phi_2378_ = array<f32, 3>();
                                    phi_2379_ = true;
                                }
                                let _e1214 = phi_2378_;
                                let _e1216 = phi_2379_;
                                if _e1216 {
                                    if _e853 {
                                        let _e1218 = local.member_2;
                                        phi_2393_ = array<f32, 3>(_e1218[0], _e1218[1], _e1218[2]);
                                    } else {
                                        phi_2393_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e1224 = phi_2393_;
                                    phi_2394_ = _e1224;
                                } else {
                                    phi_2394_ = _e1214;
                                }
                                let _e1226 = phi_2394_;
                                phi_2395_ = _e1226;
                            } else {
                                phi_2395_ = _e1160;
                            }
                            let _e1228 = phi_2395_;
                            let _e1232 = select(_e1228[0], -(_e1228[0]), (_e1228[0] < 0f));
                            let _e1236 = select(_e1228[1], -(_e1228[1]), (_e1228[1] < 0f));
                            let _e1238 = select(_e1236, _e1232, (_e1232 > _e1236));
                            let _e1242 = select(_e1228[2], -(_e1228[2]), (_e1228[2] < 0f));
                            let _e1246 = local.member_6;
                            let _e1247 = (select(_e1242, _e1238, (_e1238 > _e1242)) > _e1246);
                            let _e1249 = select(0f, _e1228[0], _e1247);
                            let _e1251 = select(0f, _e1228[1], _e1247);
                            let _e1253 = select(0f, _e1228[2], _e1247);
                            let _e1256 = select(_e1249, -(_e1249), (_e1249 < 0f));
                            let _e1259 = select(_e1251, -(_e1251), (_e1251 < 0f));
                            let _e1261 = select(_e1259, _e1256, (_e1256 > _e1259));
                            let _e1264 = select(_e1253, -(_e1253), (_e1253 < 0f));
                            if (select(_e1264, _e1261, (_e1261 > _e1264)) > 0f) {
                                let _e1270 = select(_e1249, -(_e1249), (_e1249 < 0f));
                                let _e1273 = select(_e1251, -(_e1251), (_e1251 < 0f));
                                let _e1275 = select(_e1273, _e1270, (_e1270 > _e1273));
                                let _e1278 = select(_e1253, -(_e1253), (_e1253 < 0f));
                                let _e1281 = function_8(select(_e1278, _e1275, (_e1275 > _e1278)));
                                let _e1282 = (_e1249 * _e1281);
                                let _e1283 = (_e1251 * _e1281);
                                let _e1284 = (_e1253 * _e1281);
                                let _e1289 = (((_e1282 * _e1282) + (_e1283 * _e1283)) + (_e1284 * _e1284));
                                if (_e1289 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_2590_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1289 > 0f));
                                } else {
                                    phi_2533_ = type_14(0i, 5i);
                                    phi_2536_ = bitcast<f32>(((bitcast<u32>(_e1289) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1297 = phi_2533_;
                                        let _e1299 = phi_2536_;
                                        local_6 = _e1299;
                                        if (_e1297.member < _e1297.member_1) {
                                            let _e1306 = (_e1297.member + 1i);
                                            phi_2534_ = type_14(select(_e1306, type_15().member_1, select(false, true, ((false == (_e1306 > _e1297.member)) != false))), _e1297.member_1);
                                            phi_2577_ = type_15(1u, _e1297.member);
                                        } else {
                                            phi_2534_ = _e1297;
                                            phi_2577_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1317 = phi_2534_;
                                        let _e1319 = phi_2577_;
                                        let _e1322 = (bitcast<i32>(_e1319.member) != 0i);
                                        if _e1322 {
                                            phi_2537_ = (0.5f * (_e1299 + (_e1289 / _e1299)));
                                        } else {
                                            phi_2537_ = f32();
                                        }
                                        let _e1327 = phi_2537_;
                                        continue;
                                        continuing {
                                            phi_2533_ = _e1317;
                                            phi_2536_ = _e1327;
                                            break if !(_e1322);
                                        }
                                    }
                                    let _e1332 = local_6;
                                    phi_2590_ = (_e1332 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1338 = phi_2590_;
                                let _e1339 = (1f / _e1338);
                                let _e1340 = (_e1282 * _e1339);
                                let _e1341 = (_e1283 * _e1339);
                                let _e1342 = (_e1284 * _e1339);
                                let _e1349 = ((3f - (((_e1340 * _e1340) + (_e1341 * _e1341)) + (_e1342 * _e1342))) * 0.5f);
                                let _e1350 = (_e1340 * _e1349);
                                let _e1351 = (_e1341 * _e1349);
                                let _e1352 = (_e1342 * _e1349);
                                let _e1357 = (((_e842 * _e1350) + (_e843 * _e1351)) + (_e844 * _e1352));
                                phi_2617_ = array<f32, 3>((_e842 - (_e1350 * _e1357)), (_e843 - (_e1351 * _e1357)), (_e844 - (_e1352 * _e1357)));
                            } else {
                                phi_2617_ = array<f32, 3>(_e842, _e843, _e844);
                            }
                            let _e1366 = phi_2617_;
                            if (((select(_e1366[0], -(_e1366[0]), (_e1366[0] < 0f)) + select(_e1366[1], -(_e1366[1]), (_e1366[1] < 0f))) + select(_e1366[2], -(_e1366[2]), (_e1366[2] < 0f))) > _e1005) {
                                let _e1382 = -(1f);
                                let _e1384 = (_e1366[0] * _e1382);
                                let _e1386 = (_e1366[1] * _e1382);
                                let _e1388 = (_e1366[2] * _e1382);
                                let _e1391 = select(_e1384, -(_e1384), (_e1384 < 0f));
                                let _e1394 = select(_e1386, -(_e1386), (_e1386 < 0f));
                                let _e1396 = select(_e1394, _e1391, (_e1391 > _e1394));
                                let _e1399 = select(_e1388, -(_e1388), (_e1388 < 0f));
                                let _e1402 = function_8(select(_e1399, _e1396, (_e1396 > _e1399)));
                                let _e1403 = (_e1384 * _e1402);
                                let _e1404 = (_e1386 * _e1402);
                                let _e1405 = (_e1388 * _e1402);
                                let _e1410 = (((_e1403 * _e1403) + (_e1404 * _e1404)) + (_e1405 * _e1405));
                                if (_e1410 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_2766_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1410 > 0f));
                                } else {
                                    phi_2709_ = type_14(0i, 5i);
                                    phi_2712_ = bitcast<f32>(((bitcast<u32>(_e1410) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1418 = phi_2709_;
                                        let _e1420 = phi_2712_;
                                        local_7 = _e1420;
                                        if (_e1418.member < _e1418.member_1) {
                                            let _e1427 = (_e1418.member + 1i);
                                            phi_2710_ = type_14(select(_e1427, type_15().member_1, select(false, true, ((false == (_e1427 > _e1418.member)) != false))), _e1418.member_1);
                                            phi_2753_ = type_15(1u, _e1418.member);
                                        } else {
                                            phi_2710_ = _e1418;
                                            phi_2753_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1438 = phi_2710_;
                                        let _e1440 = phi_2753_;
                                        let _e1443 = (bitcast<i32>(_e1440.member) != 0i);
                                        if _e1443 {
                                            phi_2713_ = (0.5f * (_e1420 + (_e1410 / _e1420)));
                                        } else {
                                            phi_2713_ = f32();
                                        }
                                        let _e1448 = phi_2713_;
                                        continue;
                                        continuing {
                                            phi_2709_ = _e1438;
                                            phi_2712_ = _e1448;
                                            break if !(_e1443);
                                        }
                                    }
                                    let _e1453 = local_7;
                                    phi_2766_ = (_e1453 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1459 = phi_2766_;
                                let _e1460 = (1f / _e1459);
                                let _e1461 = (_e1403 * _e1460);
                                let _e1462 = (_e1404 * _e1460);
                                let _e1463 = (_e1405 * _e1460);
                                let _e1470 = ((3f - (((_e1461 * _e1461) + (_e1462 * _e1462)) + (_e1463 * _e1463))) * 0.5f);
                                phi_2782_ = array<f32, 3>((_e1461 * _e1470), (_e1462 * _e1470), (_e1463 * _e1470));
                                phi_2783_ = false;
                            } else {
                                phi_2782_ = array<f32, 3>();
                                phi_2783_ = true;
                            }
                            let _e1476 = phi_2782_;
                            let _e1478 = phi_2783_;
                            phi_2784_ = _e1476;
                            phi_2785_ = _e1478;
                        } else {
                            phi_2784_ = array<f32, 3>();
                            phi_2785_ = true;
                        }
                        let _e1480 = phi_2784_;
                        let _e1482 = phi_2785_;
                        if _e1482 {
                            if _e867 {
                                let _e1756 = select(_e873, -(_e873), (_e873 < 0f));
                                let _e1759 = select(_e874, -(_e874), (_e874 < 0f));
                                let _e1761 = select(_e1759, _e1756, (_e1756 > _e1759));
                                let _e1764 = select(_e875, -(_e875), (_e875 < 0f));
                                let _e1767 = function_8(select(_e1764, _e1761, (_e1761 > _e1764)));
                                let _e1768 = (_e873 * _e1767);
                                let _e1769 = (_e874 * _e1767);
                                let _e1770 = (_e875 * _e1767);
                                let _e1775 = (((_e1768 * _e1768) + (_e1769 * _e1769)) + (_e1770 * _e1770));
                                if (_e1775 <= 0.000000000000000000000000000000000000011754944f) {
                                    phi_2906_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1775 > 0f));
                                } else {
                                    phi_2849_ = type_14(0i, 5i);
                                    phi_2852_ = bitcast<f32>(((bitcast<u32>(_e1775) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1783 = phi_2849_;
                                        let _e1785 = phi_2852_;
                                        local_10 = _e1785;
                                        if (_e1783.member < _e1783.member_1) {
                                            let _e1792 = (_e1783.member + 1i);
                                            phi_2850_ = type_14(select(_e1792, type_15().member_1, select(false, true, ((false == (_e1792 > _e1783.member)) != false))), _e1783.member_1);
                                            phi_2893_ = type_15(1u, _e1783.member);
                                        } else {
                                            phi_2850_ = _e1783;
                                            phi_2893_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1803 = phi_2850_;
                                        let _e1805 = phi_2893_;
                                        let _e1808 = (bitcast<i32>(_e1805.member) != 0i);
                                        if _e1808 {
                                            phi_2853_ = (0.5f * (_e1785 + (_e1775 / _e1785)));
                                        } else {
                                            phi_2853_ = f32();
                                        }
                                        let _e1813 = phi_2853_;
                                        continue;
                                        continuing {
                                            phi_2849_ = _e1803;
                                            phi_2852_ = _e1813;
                                            break if !(_e1808);
                                        }
                                    }
                                    let _e1818 = local_10;
                                    phi_2906_ = (_e1818 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1824 = phi_2906_;
                                let _e1825 = (1f / _e1824);
                                let _e1826 = (_e1768 * _e1825);
                                let _e1827 = (_e1769 * _e1825);
                                let _e1828 = (_e1770 * _e1825);
                                let _e1835 = ((3f - (((_e1826 * _e1826) + (_e1827 * _e1827)) + (_e1828 * _e1828))) * 0.5f);
                                phi_3363_ = array<f32, 3>((_e1826 * _e1835), (_e1827 * _e1835), (_e1828 * _e1835));
                            } else {
                                let _e1484 = local.member_1;
                                let _e1489 = local.member_2;
                                let _e1495 = select(_e1489[0], -(_e1489[0]), (_e1489[0] < 0f));
                                let _e1498 = select(_e1489[1], -(_e1489[1]), (_e1489[1] < 0f));
                                let _e1500 = select(_e1498, _e1495, (_e1495 > _e1498));
                                let _e1503 = select(_e1489[2], -(_e1489[2]), (_e1489[2] < 0f));
                                let _e1508 = select(_e1484[0], -(_e1484[0]), (_e1484[0] < 0f));
                                let _e1511 = select(_e1484[1], -(_e1484[1]), (_e1484[1] < 0f));
                                let _e1513 = select(_e1511, _e1508, (_e1508 > _e1511));
                                let _e1516 = select(_e1484[2], -(_e1484[2]), (_e1484[2] < 0f));
                                let _e1519 = (select(_e1503, _e1500, (_e1500 > _e1503)) > select(_e1516, _e1513, (_e1513 > _e1516)));
                                let _e1520 = select(_e1484[0], _e1489[0], _e1519);
                                let _e1521 = select(_e1484[1], _e1489[1], _e1519);
                                let _e1522 = select(_e1484[2], _e1489[2], _e1519);
                                let _e1525 = select(_e1520, -(_e1520), (_e1520 < 0f));
                                let _e1528 = select(_e1521, -(_e1521), (_e1521 < 0f));
                                let _e1530 = select(_e1528, _e1525, (_e1525 > _e1528));
                                let _e1533 = select(_e1522, -(_e1522), (_e1522 < 0f));
                                if (select(_e1533, _e1530, (_e1530 > _e1533)) > 0f) {
                                    let _e1539 = select(_e1520, -(_e1520), (_e1520 < 0f));
                                    let _e1542 = select(_e1521, -(_e1521), (_e1521 < 0f));
                                    let _e1545 = select(_e1522, -(_e1522), (_e1522 < 0f));
                                    if (_e1539 <= _e1542) {
                                        let _e1547 = (_e1539 <= _e1545);
                                        phi_3068_ = array<f32, 3>(select(array<f32, 3>()[0], 1f, _e1547), select(array<f32, 3>()[1], 0f, _e1547), select(array<f32, 3>()[2], 0f, _e1547));
                                        phi_3069_ = select(true, false, _e1547);
                                    } else {
                                        phi_3068_ = array<f32, 3>();
                                        phi_3069_ = true;
                                    }
                                    let _e1557 = phi_3068_;
                                    let _e1559 = phi_3069_;
                                    if _e1559 {
                                        let _e1560 = (_e1542 <= _e1545);
                                        phi_3080_ = array<f32, 3>(0f, select(0f, 1f, _e1560), select(1f, 0f, _e1560));
                                    } else {
                                        phi_3080_ = _e1557;
                                    }
                                    let _e1565 = phi_3080_;
                                    let _e1568 = select(_e1520, -(_e1520), (_e1520 < 0f));
                                    let _e1571 = select(_e1521, -(_e1521), (_e1521 < 0f));
                                    let _e1573 = select(_e1571, _e1568, (_e1568 > _e1571));
                                    let _e1576 = select(_e1522, -(_e1522), (_e1522 < 0f));
                                    let _e1579 = function_8(select(_e1576, _e1573, (_e1573 > _e1576)));
                                    let _e1580 = (_e1520 * _e1579);
                                    let _e1581 = (_e1521 * _e1579);
                                    let _e1582 = (_e1522 * _e1579);
                                    let _e1587 = (((_e1580 * _e1580) + (_e1581 * _e1581)) + (_e1582 * _e1582));
                                    if (_e1587 <= 0.000000000000000000000000000000000000011754944f) {
                                        phi_3201_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1587 > 0f));
                                    } else {
                                        phi_3144_ = type_14(0i, 5i);
                                        phi_3147_ = bitcast<f32>(((bitcast<u32>(_e1587) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1595 = phi_3144_;
                                            let _e1597 = phi_3147_;
                                            local_8 = _e1597;
                                            if (_e1595.member < _e1595.member_1) {
                                                let _e1604 = (_e1595.member + 1i);
                                                phi_3145_ = type_14(select(_e1604, type_15().member_1, select(false, true, ((false == (_e1604 > _e1595.member)) != false))), _e1595.member_1);
                                                phi_3188_ = type_15(1u, _e1595.member);
                                            } else {
                                                phi_3145_ = _e1595;
                                                phi_3188_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1615 = phi_3145_;
                                            let _e1617 = phi_3188_;
                                            let _e1620 = (bitcast<i32>(_e1617.member) != 0i);
                                            if _e1620 {
                                                phi_3148_ = (0.5f * (_e1597 + (_e1587 / _e1597)));
                                            } else {
                                                phi_3148_ = f32();
                                            }
                                            let _e1625 = phi_3148_;
                                            continue;
                                            continuing {
                                                phi_3144_ = _e1615;
                                                phi_3147_ = _e1625;
                                                break if !(_e1620);
                                            }
                                        }
                                        let _e1630 = local_8;
                                        phi_3201_ = (_e1630 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1636 = phi_3201_;
                                    let _e1637 = (1f / _e1636);
                                    let _e1638 = (_e1580 * _e1637);
                                    let _e1639 = (_e1581 * _e1637);
                                    let _e1640 = (_e1582 * _e1637);
                                    let _e1647 = ((3f - (((_e1638 * _e1638) + (_e1639 * _e1639)) + (_e1640 * _e1640))) * 0.5f);
                                    let _e1648 = (_e1638 * _e1647);
                                    let _e1649 = (_e1639 * _e1647);
                                    let _e1650 = (_e1640 * _e1647);
                                    let _e1655 = ((_e1649 * _e1565[2]) - (_e1650 * _e1565[1]));
                                    let _e1660 = ((_e1650 * _e1565[0]) - (_e1648 * _e1565[2]));
                                    let _e1665 = ((_e1648 * _e1565[1]) - (_e1649 * _e1565[0]));
                                    let _e1668 = select(_e1655, -(_e1655), (_e1655 < 0f));
                                    let _e1671 = select(_e1660, -(_e1660), (_e1660 < 0f));
                                    let _e1673 = select(_e1671, _e1668, (_e1668 > _e1671));
                                    let _e1676 = select(_e1665, -(_e1665), (_e1665 < 0f));
                                    let _e1679 = function_8(select(_e1676, _e1673, (_e1673 > _e1676)));
                                    let _e1680 = (_e1655 * _e1679);
                                    let _e1681 = (_e1660 * _e1679);
                                    let _e1682 = (_e1665 * _e1679);
                                    let _e1687 = (((_e1680 * _e1680) + (_e1681 * _e1681)) + (_e1682 * _e1682));
                                    if (_e1687 <= 0.000000000000000000000000000000000000011754944f) {
                                        phi_3345_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1687 > 0f));
                                    } else {
                                        phi_3288_ = type_14(0i, 5i);
                                        phi_3291_ = bitcast<f32>(((bitcast<u32>(_e1687) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1695 = phi_3288_;
                                            let _e1697 = phi_3291_;
                                            local_9 = _e1697;
                                            if (_e1695.member < _e1695.member_1) {
                                                let _e1704 = (_e1695.member + 1i);
                                                phi_3289_ = type_14(select(_e1704, type_15().member_1, select(false, true, ((false == (_e1704 > _e1695.member)) != false))), _e1695.member_1);
                                                phi_3332_ = type_15(1u, _e1695.member);
                                            } else {
                                                phi_3289_ = _e1695;
                                                phi_3332_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1715 = phi_3289_;
                                            let _e1717 = phi_3332_;
                                            let _e1720 = (bitcast<i32>(_e1717.member) != 0i);
                                            if _e1720 {
                                                phi_3292_ = (0.5f * (_e1697 + (_e1687 / _e1697)));
                                            } else {
                                                phi_3292_ = f32();
                                            }
                                            let _e1725 = phi_3292_;
                                            continue;
                                            continuing {
                                                phi_3288_ = _e1715;
                                                phi_3291_ = _e1725;
                                                break if !(_e1720);
                                            }
                                        }
                                        let _e1730 = local_9;
                                        phi_3345_ = (_e1730 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1736 = phi_3345_;
                                    let _e1737 = (1f / _e1736);
                                    let _e1738 = (_e1680 * _e1737);
                                    let _e1739 = (_e1681 * _e1737);
                                    let _e1740 = (_e1682 * _e1737);
                                    let _e1747 = ((3f - (((_e1738 * _e1738) + (_e1739 * _e1739)) + (_e1740 * _e1740))) * 0.5f);
                                    phi_3362_ = array<f32, 3>((_e1738 * _e1747), (_e1739 * _e1747), (_e1740 * _e1747));
                                } else {
                                    phi_3362_ = array<f32, 3>(1f, 0f, 0f);
                                }
                                let _e1753 = phi_3362_;
                                phi_3363_ = _e1753;
                            }
                            let _e1841 = phi_3363_;
                            let _e1850 = ((((_e842 * _e1841[0]) + (_e843 * _e1841[1])) + (_e844 * _e1841[2])) > _e1005);
                            let _e1851 = -(1f);
                            phi_3385_ = array<f32, 3>(select(_e1841[0], (_e1841[0] * _e1851), _e1850), select(_e1841[1], (_e1841[1] * _e1851), _e1850), select(_e1841[2], (_e1841[2] * _e1851), _e1850));
                            phi_3386_ = false;
                        } else {
                            phi_3385_ = array<f32, 3>();
                            phi_3386_ = true;
                        }
                        let _e1866 = phi_3385_;
                        let _e1868 = phi_3386_;
                        phi_3387_ = _e1866;
                        phi_3388_ = _e1480;
                        phi_3389_ = _e1868;
                    } else {
                        phi_3387_ = array<f32, 3>();
                        phi_3388_ = _e1132;
                        phi_3389_ = true;
                    }
                    let _e1870 = phi_3387_;
                    let _e1872 = phi_3388_;
                    let _e1874 = phi_3389_;
                    phi_3393_ = _e1872;
                    phi_3394_ = _e1870;
                    phi_3395_ = _e1874;
                }
                let _e2091 = phi_3393_;
                let _e2093 = phi_3394_;
                let _e2095 = phi_3395_;
                let _e2098 = select(_e2093[0], _e2091[0], _e2095);
                let _e2101 = select(_e2093[1], _e2091[1], _e2095);
                let _e2104 = select(_e2093[2], _e2091[2], _e2095);
                let _e2110 = ((((_e2098 * _e2098) + (_e2101 * _e2101)) + (_e2104 * _e2104)) > 0.5f);
                let _e2117 = function_9(_e269[0], _e270[0], _e264);
                let _e2120 = function_9(_e269[1], _e270[1], _e264);
                let _e2123 = function_9(_e269[2], _e270[2], _e264);
                let _e2126 = function_9(_e269[3], _e270[3], _e264);
                if (_e186.member != 0u) {
                    let _e2162 = function_9(_e2117, _e2120, _e753.member);
                    let _e2163 = function_9(_e2123, _e2126, _e753.member_1);
                    phi_3472_ = _e2163;
                    phi_3473_ = _e2162;
                    phi_3474_ = array<f32, 4>((1f - _e753.member), _e753.member, (1f - _e753.member_1), _e753.member_1);
                } else {
                    let _e2129 = ((1f - _e753.member) - _e753.member_1);
                    let _e2131 = select(0f, _e2129, (_e2129 > 0f));
                    let _e2158 = function_(array<f32, 4>(1f, _e2131, _e753.member, _e753.member_1), _e268);
                    phi_3472_ = array<f32, 3>((((_e2120[0] * _e2131) + (_e2123[0] * _e753.member)) + (_e2126[0] * _e753.member_1)), (((_e2120[1] * _e2131) + (_e2123[1] * _e753.member)) + (_e2126[1] * _e753.member_1)), (((_e2120[2] * _e2131) + (_e2123[2] * _e753.member)) + (_e2126[2] * _e753.member_1)));
                    phi_3473_ = _e2117;
                    phi_3474_ = _e2158;
                }
                let _e2165 = phi_3472_;
                let _e2167 = phi_3473_;
                let _e2169 = phi_3474_;
                let _e2170 = function_9(_e2167, _e2165, 0.5f);
                let _e2174 = params.member.member_2.member;
                let _e2177 = params.member.member_2.member_1;
                geometry.member[_e133] = type_29(array<f32, 3>(((_e2170[0] * _e2177) + _e2174[0]), ((_e2170[1] * _e2177) + _e2174[1]), ((_e2170[2] * _e2177) + _e2174[2])), ((_e811 / _e495) * _e2177), array<f32, 3>(select(1f, _e2098, _e2110), select(0f, _e2101, _e2110), select(0f, _e2104, _e2110)), _e140, _e2169, _e186.member_1);
            }
        }
        continue;
        continuing {
            phi_232_ = type_9(select(_e108.member, (_e108.member + 1u), _e111), select(_e108.member_1, _e108.member_1, _e111));
            break if !(_e124);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn contact_geometry(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_12(id, n, lane);
}
