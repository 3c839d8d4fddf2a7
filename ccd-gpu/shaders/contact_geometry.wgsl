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

struct type_10 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
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

struct type_24 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_26 {
    member: array<array<u32, 3>>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: f32,
    member_5: f32,
    member_6: f32,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
}

struct type_32 {
    member: type_7,
    member_1: type_8,
    member_2: type_31,
}

struct type_33 {
    member: type_32,
}

struct type_34 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 4>,
    member_5: array<u32, 4>,
}

struct type_36 {
    member: array<type_34>,
}

struct type_37 {
    member: u32,
    member_1: array<u32, 4>,
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
var<storage> params: type_33;
@group(0) @binding(2) 
var<storage> edges: type_21;
@group(0) @binding(3) 
var<storage> faces: type_26;
@group(0) @binding(4) 
var<storage> contacts: type_10;
@group(0) @binding(5) 
var<storage, read_write> geometry: type_36;

fn function_(param: array<f32, 4>, param_1: u32) -> array<f32, 4> {
    var phi_4352_: array<f32, 4>;

    switch bitcast<i32>(param_1) {
        case 0: {
            phi_4352_ = param;
            break;
        }
        case 1: {
            phi_4352_ = array<f32, 4>(param[0], param[3], param[1], param[2]);
            break;
        }
        default: {
            phi_4352_ = array<f32, 4>(param[0], param[2], param[3], param[1]);
            break;
        }
    }
    let _e14 = phi_4352_;
    return _e14;
}

fn function_1(param_2: array<array<f32, 3>, 2>) -> array<f32, 3> {
    return array<f32, 3>((param_2[1][0] - param_2[0][0]), (param_2[1][1] - param_2[0][1]), (param_2[1][2] - param_2[0][2]));
}

fn function_2(param_3: type_38, param_4: type_38) -> type_38 {
    var phi_4320_: type_38;

    if (param_4.member_3 < param_3.member_3) {
        phi_4320_ = param_4;
    } else {
        phi_4320_ = param_3;
    }
    let _e6 = phi_4320_;
    return _e6;
}

fn function_3(param_5: f32, param_6: f32) -> f32 {
    var phi_3395_: f32;
    var phi_3400_: f32;
    var phi_3401_: f32;

    if (param_5 > 0f) {
        if (param_5 < param_6) {
            phi_3395_ = param_5;
        } else {
            phi_3395_ = param_6;
        }
        let _e6 = phi_3395_;
        if (_e6 > 0f) {
            phi_3400_ = _e6;
        } else {
            phi_3400_ = 0f;
        }
        let _e9 = phi_3400_;
        phi_3401_ = _e9;
    } else {
        phi_3401_ = 0f;
    }
    let _e11 = phi_3401_;
    return _e11;
}

fn function_4(param_7: ptr<function, type_27>, param_8: f32, param_9: f32) -> f32 {
    let _e4 = (*param_7).member;
    let _e9 = (*param_7).member_2;
    let _e20 = (*param_7).member_1;
    let _e30 = (*param_7).member_1;
    let _e35 = (*param_7).member_1;
    let _e45 = function_3((((((_e4[0] - (_e9[0] * param_8)) * _e20[0]) + ((_e4[1] - (_e9[1] * param_8)) * _e20[1])) + ((_e4[2] - (_e9[2] * param_8)) * _e20[2])) / (((_e30[0] * _e35[0]) + (_e30[1] * _e35[1])) + (_e30[2] * _e35[2]))), param_9);
    return _e45;
}

fn function_5(param_10: ptr<function, type_27>, param_11: f32, param_12: f32) -> type_38 {
    let _e4 = (*param_10).member;
    let _e9 = (*param_10).member_1;
    let _e20 = (*param_10).member_2;
    let _e27 = ((_e4[0] - (_e9[0] * param_11)) - (_e20[0] * param_12));
    let _e28 = ((_e4[1] - (_e9[1] * param_11)) - (_e20[1] * param_12));
    let _e29 = ((_e4[2] - (_e9[2] * param_11)) - (_e20[2] * param_12));
    return type_38(param_11, param_12, array<f32, 3>(_e27, _e28, _e29), (((_e27 * _e27) + (_e28 * _e28)) + (_e29 * _e29)));
}

fn function_6(param_13: ptr<function, type_27>, param_14: f32, param_15: f32) -> f32 {
    let _e4 = (*param_13).member;
    let _e9 = (*param_13).member_1;
    let _e20 = (*param_13).member_2;
    let _e30 = (*param_13).member_2;
    let _e35 = (*param_13).member_2;
    let _e45 = function_3((((((_e4[0] - (_e9[0] * param_14)) * _e20[0]) + ((_e4[1] - (_e9[1] * param_14)) * _e20[1])) + ((_e4[2] - (_e9[2] * param_14)) * _e20[2])) / (((_e30[0] * _e35[0]) + (_e30[1] * _e35[1])) + (_e30[2] * _e35[2]))), param_15);
    return _e45;
}

fn function_7(param_16: ptr<function, type_27>, param_17: u32) -> type_38 {
    var phi_4019_: f32;
    var phi_4026_: f32;
    var phi_4037_: type_38;
    var phi_4038_: bool;
    var phi_4039_: type_38;
    var phi_4040_: bool;
    var phi_3896_: bool;
    var phi_3897_: bool;
    var phi_3913_: f32;
    var phi_3919_: f32;
    var phi_3922_: type_38;
    var phi_3923_: bool;
    var phi_3924_: type_38;
    var phi_3925_: bool;
    var phi_3926_: type_38;
    var phi_3927_: bool;
    var phi_4044_: type_38;
    var phi_4045_: bool;
    var phi_4120_: type_38;
    var phi_4121_: type_38;
    var phi_4122_: bool;
    var phi_4126_: type_38;

    let _e9 = (param_17 == 0u);
    let _e11 = (*param_16).member_4;
    if (_e11 > 0f) {
        let _e90 = (*param_16).member_3;
        let _e95 = (*param_16).member_3;
        let _e103 = (((_e90[0] * _e95[0]) + (_e90[1] * _e95[1])) + (_e90[2] * _e95[2]));
        let _e105 = (*param_16).member;
        let _e110 = (*param_16).member_2;
        let _e124 = (*param_16).member_3;
        let _e133 = ((((((_e105[1] * _e110[2]) - (_e105[2] * _e110[1])) * _e124[0]) + (((_e105[2] * _e110[0]) - (_e105[0] * _e110[2])) * _e124[1])) + (((_e105[0] * _e110[1]) - (_e105[1] * _e110[0])) * _e124[2])) / _e103);
        let _e135 = (*param_16).member_1;
        let _e140 = (*param_16).member;
        let _e154 = (*param_16).member_3;
        let _e163 = ((((((_e135[1] * _e140[2]) - (_e135[2] * _e140[1])) * _e154[0]) + (((_e135[2] * _e140[0]) - (_e135[0] * _e140[2])) * _e154[1])) + (((_e135[0] * _e140[1]) - (_e135[1] * _e140[0])) * _e154[2])) / _e103);
        if _e9 {
            phi_3897_ = ((_e133 + _e163) <= 1f);
        } else {
            if (_e133 <= 1f) {
                phi_3896_ = (_e163 <= 1f);
            } else {
                phi_3896_ = false;
            }
            let _e167 = phi_3896_;
            phi_3897_ = _e167;
        }
        let _e171 = phi_3897_;
        if (_e133 >= 0f) {
            if (_e163 >= 0f) {
                if _e171 {
                    if _e9 {
                        phi_3913_ = (1f - _e133);
                    } else {
                        phi_3913_ = 1f;
                    }
                    let _e176 = phi_3913_;
                    let _e177 = function_6(param_16, _e133, _e176);
                    if _e9 {
                        phi_3919_ = (1f - _e177);
                    } else {
                        phi_3919_ = 1f;
                    }
                    let _e180 = phi_3919_;
                    let _e181 = function_4(param_16, _e177, _e180);
                    let _e182 = function_5(param_16, _e181, _e177);
                    phi_3922_ = _e182;
                    phi_3923_ = false;
                } else {
                    phi_3922_ = type_38();
                    phi_3923_ = true;
                }
                let _e184 = phi_3922_;
                let _e186 = phi_3923_;
                phi_3924_ = _e184;
                phi_3925_ = _e186;
            } else {
                phi_3924_ = type_38();
                phi_3925_ = true;
            }
            let _e188 = phi_3924_;
            let _e190 = phi_3925_;
            phi_3926_ = _e188;
            phi_3927_ = _e190;
        } else {
            phi_3926_ = type_38();
            phi_3927_ = true;
        }
        let _e192 = phi_3926_;
        let _e194 = phi_3927_;
        phi_4044_ = _e192;
        phi_4045_ = _e194;
    } else {
        if _e9 {
            phi_4039_ = type_38();
            phi_4040_ = true;
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
            if (_e27 < _e50) {
                phi_4019_ = _e27;
            } else {
                phi_4019_ = _e50;
            }
            let _e68 = phi_4019_;
            let _e70 = function_3((_e68 / _e65), 1f);
            if (_e27 > _e50) {
                phi_4026_ = _e27;
            } else {
                phi_4026_ = _e50;
            }
            let _e73 = phi_4026_;
            let _e75 = function_3((_e73 / _e65), 1f);
            if (_e70 < _e75) {
                let _e78 = ((_e70 + _e75) * 0.5f);
                let _e79 = function_6(param_16, _e78, 1f);
                let _e80 = function_5(param_16, _e78, _e79);
                phi_4037_ = _e80;
                phi_4038_ = false;
            } else {
                phi_4037_ = type_38();
                phi_4038_ = true;
            }
            let _e82 = phi_4037_;
            let _e84 = phi_4038_;
            phi_4039_ = _e82;
            phi_4040_ = _e84;
        }
        let _e86 = phi_4039_;
        let _e88 = phi_4040_;
        phi_4044_ = _e86;
        phi_4045_ = _e88;
    }
    let _e196 = phi_4044_;
    let _e198 = phi_4045_;
    if _e198 {
        let _e199 = function_4(param_16, 0f, 1f);
        let _e200 = function_5(param_16, _e199, 0f);
        let _e201 = function_6(param_16, 0f, 1f);
        let _e202 = function_5(param_16, 0f, _e201);
        let _e203 = function_2(_e200, _e202);
        if _e9 {
            let _e211 = (*param_16).member_2;
            let _e216 = (*param_16).member_1;
            let _e220 = (_e211[0] - _e216[0]);
            let _e221 = (_e211[1] - _e216[1]);
            let _e222 = (_e211[2] - _e216[2]);
            let _e224 = (*param_16).member;
            let _e229 = (*param_16).member_1;
            let _e247 = function_3((((((_e224[0] - _e229[0]) * _e220) + ((_e224[1] - _e229[1]) * _e221)) + ((_e224[2] - _e229[2]) * _e222)) / (((_e220 * _e220) + (_e221 * _e221)) + (_e222 * _e222))), 1f);
            let _e249 = function_5(param_16, (1f - _e247), _e247);
            let _e250 = function_2(_e203, _e249);
            phi_4120_ = _e250;
        } else {
            let _e204 = function_6(param_16, 1f, 1f);
            let _e205 = function_5(param_16, 1f, _e204);
            let _e206 = function_4(param_16, 1f, 1f);
            let _e207 = function_5(param_16, _e206, 1f);
            let _e208 = function_2(_e205, _e207);
            let _e209 = function_2(_e203, _e208);
            phi_4120_ = _e209;
        }
        let _e252 = phi_4120_;
        phi_4121_ = _e252;
        phi_4122_ = false;
    } else {
        phi_4121_ = type_38();
        phi_4122_ = true;
    }
    let _e254 = phi_4121_;
    let _e256 = phi_4122_;
    if _e256 {
        phi_4126_ = _e196;
    } else {
        phi_4126_ = _e254;
    }
    let _e258 = phi_4126_;
    return _e258;
}

fn function_8(param_18: f32) -> f32 {
    var phi_3752_: u32;
    var phi_3755_: f32;
    var phi_3756_: f32;

    if ((bitcast<u32>(param_18) & 2139095040u) != 2139095040u) {
        if (param_18 >= 0.000000000000000000000000000000000000011754944f) {
            let _e13 = (2130706432u - (bitcast<u32>(param_18) & 2139095040u));
            if (_e13 > 8388608u) {
                phi_3752_ = _e13;
            } else {
                phi_3752_ = 8388608u;
            }
            let _e16 = phi_3752_;
            phi_3755_ = bitcast<f32>(_e16);
        } else {
            phi_3755_ = (1f / 0.000000000000000000000000000000000000011754944f);
        }
        let _e19 = phi_3755_;
        phi_3756_ = _e19;
    } else {
        phi_3756_ = 1f;
    }
    let _e21 = phi_3756_;
    return _e21;
}

fn function_9(param_19: array<f32, 3>, param_20: array<f32, 3>, param_21: f32) -> array<f32, 3> {
    let _e4 = (1f - param_21);
    return array<f32, 3>(((param_19[0] * _e4) + (param_20[0] * param_21)), ((param_19[1] * _e4) + (param_20[1] * param_21)), ((param_19[2] * _e4) + (param_20[2] * param_21)));
}

fn function_10(param_22: ptr<function, array<array<f32, 3>, 4>>, param_23: u32) -> array<array<f32, 3>, 4> {
    var phi_3729_: array<array<f32, 3>, 4>;

    switch bitcast<i32>(param_23) {
        case 0: {
            let _e32 = (*param_22);
            phi_3729_ = array<array<f32, 3>, 4>(array<f32, 3>(_e32[0][0], _e32[0][1], _e32[0][2]), array<f32, 3>(_e32[1][0], _e32[1][1], _e32[1][2]), array<f32, 3>(_e32[2][0], _e32[2][1], _e32[2][2]), array<f32, 3>(_e32[3][0], _e32[3][1], _e32[3][2]));
            break;
        }
        case 1: {
            let _e8 = (*param_22)[0u];
            let _e14 = (*param_22)[2u];
            let _e20 = (*param_22)[3u];
            let _e26 = (*param_22)[1u];
            phi_3729_ = array<array<f32, 3>, 4>(array<f32, 3>(_e8[0], _e8[1], _e8[2]), array<f32, 3>(_e14[0], _e14[1], _e14[2]), array<f32, 3>(_e20[0], _e20[1], _e20[2]), array<f32, 3>(_e26[0], _e26[1], _e26[2]));
            break;
        }
        default: {
            let _e55 = (*param_22)[0u];
            let _e61 = (*param_22)[3u];
            let _e67 = (*param_22)[1u];
            let _e73 = (*param_22)[2u];
            phi_3729_ = array<array<f32, 3>, 4>(array<f32, 3>(_e55[0], _e55[1], _e55[2]), array<f32, 3>(_e61[0], _e61[1], _e61[2]), array<f32, 3>(_e67[0], _e67[1], _e67[2]), array<f32, 3>(_e73[0], _e73[1], _e73[2]));
            break;
        }
    }
    let _e80 = phi_3729_;
    return _e80;
}

fn function_11(param_24: ptr<function, array<array<f32, 3>, 4>>, param_25: ptr<function, array<array<f32, 3>, 4>>, param_26: f32) -> u32 {
    var phi_3457_: f32;
    var phi_3464_: f32;
    var phi_3472_: f32;
    var phi_3525_: f32;
    var phi_3532_: f32;
    var phi_3540_: f32;
    var phi_3593_: f32;
    var phi_3600_: f32;
    var phi_3608_: f32;
    var phi_3618_: bool;
    var phi_3619_: bool;
    var phi_3627_: u32;
    var phi_3628_: u32;

    let _e11 = (*param_24)[3u];
    let _e16 = (*param_24)[2u];
    let _e25 = (*param_25)[3u];
    let _e30 = (*param_25)[2u];
    let _e38 = function_9(array<f32, 3>((_e11[0] - _e16[0]), (_e11[1] - _e16[1]), (_e11[2] - _e16[2])), array<f32, 3>((_e25[0] - _e30[0]), (_e25[1] - _e30[1]), (_e25[2] - _e30[2])), param_26);
    if (_e38[0] < 0f) {
        phi_3457_ = -(_e38[0]);
    } else {
        phi_3457_ = _e38[0];
    }
    let _e43 = phi_3457_;
    if (_e38[1] < 0f) {
        phi_3464_ = -(_e38[1]);
    } else {
        phi_3464_ = _e38[1];
    }
    let _e48 = phi_3464_;
    if (_e38[2] < 0f) {
        phi_3472_ = -(_e38[2]);
    } else {
        phi_3472_ = _e38[2];
    }
    let _e54 = phi_3472_;
    let _e55 = ((_e43 + _e48) + _e54);
    let _e57 = (*param_24)[1u];
    let _e62 = (*param_24)[3u];
    let _e71 = (*param_25)[1u];
    let _e76 = (*param_25)[3u];
    let _e84 = function_9(array<f32, 3>((_e57[0] - _e62[0]), (_e57[1] - _e62[1]), (_e57[2] - _e62[2])), array<f32, 3>((_e71[0] - _e76[0]), (_e71[1] - _e76[1]), (_e71[2] - _e76[2])), param_26);
    if (_e84[0] < 0f) {
        phi_3525_ = -(_e84[0]);
    } else {
        phi_3525_ = _e84[0];
    }
    let _e89 = phi_3525_;
    if (_e84[1] < 0f) {
        phi_3532_ = -(_e84[1]);
    } else {
        phi_3532_ = _e84[1];
    }
    let _e94 = phi_3532_;
    if (_e84[2] < 0f) {
        phi_3540_ = -(_e84[2]);
    } else {
        phi_3540_ = _e84[2];
    }
    let _e100 = phi_3540_;
    let _e101 = ((_e89 + _e94) + _e100);
    let _e103 = (*param_24)[2u];
    let _e108 = (*param_24)[1u];
    let _e117 = (*param_25)[2u];
    let _e122 = (*param_25)[1u];
    let _e130 = function_9(array<f32, 3>((_e103[0] - _e108[0]), (_e103[1] - _e108[1]), (_e103[2] - _e108[2])), array<f32, 3>((_e117[0] - _e122[0]), (_e117[1] - _e122[1]), (_e117[2] - _e122[2])), param_26);
    if (_e130[0] < 0f) {
        phi_3593_ = -(_e130[0]);
    } else {
        phi_3593_ = _e130[0];
    }
    let _e135 = phi_3593_;
    if (_e130[1] < 0f) {
        phi_3600_ = -(_e130[1]);
    } else {
        phi_3600_ = _e130[1];
    }
    let _e140 = phi_3600_;
    if (_e130[2] < 0f) {
        phi_3608_ = -(_e130[2]);
    } else {
        phi_3608_ = _e130[2];
    }
    let _e146 = phi_3608_;
    let _e147 = ((_e135 + _e140) + _e146);
    if (_e55 >= _e101) {
        if (_e55 >= _e147) {
            phi_3618_ = false;
        } else {
            phi_3618_ = true;
        }
        let _e151 = phi_3618_;
        phi_3619_ = _e151;
    } else {
        phi_3619_ = true;
    }
    let _e153 = phi_3619_;
    if _e153 {
        if (_e101 >= _e147) {
            phi_3627_ = 1u;
        } else {
            phi_3627_ = 2u;
        }
        let _e156 = phi_3627_;
        phi_3628_ = _e156;
    } else {
        phi_3628_ = 0u;
    }
    let _e158 = phi_3628_;
    return _e158;
}

fn function_12(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_27;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var phi_185_: u32;
    var phi_201_: u32;
    var phi_222_: u32;
    var phi_223_: u32;
    var phi_226_: type_12;
    var phi_227_: type_12;
    var phi_250_: type_12;
    var phi_389_: type_37;
    var phi_532_: u32;
    var phi_538_: f32;
    var phi_547_: u32;
    var phi_708_: type_24;
    var phi_724_: f32;
    var phi_731_: f32;
    var phi_736_: f32;
    var phi_743_: f32;
    var phi_748_: f32;
    var phi_755_: f32;
    var phi_762_: f32;
    var phi_767_: f32;
    var phi_774_: f32;
    var phi_779_: f32;
    var phi_784_: f32;
    var phi_791_: f32;
    var phi_798_: f32;
    var phi_803_: f32;
    var phi_810_: f32;
    var phi_815_: f32;
    var phi_820_: f32;
    var phi_850_: f32;
    var phi_857_: f32;
    var phi_862_: f32;
    var phi_869_: f32;
    var phi_874_: f32;
    var phi_882_: f32;
    var phi_889_: f32;
    var phi_894_: f32;
    var phi_901_: f32;
    var phi_906_: f32;
    var phi_911_: f32;
    var phi_921_: f32;
    var phi_928_: f32;
    var phi_933_: f32;
    var phi_940_: f32;
    var phi_945_: f32;
    var phi_953_: f32;
    var phi_960_: f32;
    var phi_965_: f32;
    var phi_972_: f32;
    var phi_977_: f32;
    var phi_982_: f32;
    var phi_992_: f32;
    var phi_999_: f32;
    var phi_1004_: f32;
    var phi_1011_: f32;
    var phi_1016_: f32;
    var phi_1024_: f32;
    var phi_1031_: f32;
    var phi_1036_: f32;
    var phi_1043_: f32;
    var phi_1048_: f32;
    var phi_1053_: f32;
    var phi_1084_: f32;
    var phi_1090_: f32;
    var phi_1095_: f32;
    var phi_1101_: f32;
    var phi_1106_: f32;
    var phi_1114_: f32;
    var phi_1120_: f32;
    var phi_1125_: f32;
    var phi_1131_: f32;
    var phi_1136_: f32;
    var phi_1164_: type_14;
    var phi_1167_: f32;
    var phi_1188_: bool;
    var phi_1194_: type_15;
    var phi_1165_: type_14;
    var phi_1208_: type_15;
    var phi_1168_: f32;
    var local_3: f32;
    var phi_1157_: f32;
    var phi_1221_: f32;
    var phi_1229_: f32;
    var phi_1234_: f32;
    var phi_1284_: type_14;
    var phi_1287_: f32;
    var phi_1308_: bool;
    var phi_1314_: type_15;
    var phi_1285_: type_14;
    var phi_1328_: type_15;
    var phi_1288_: f32;
    var local_4: f32;
    var phi_1277_: f32;
    var phi_1341_: f32;
    var phi_1349_: f32;
    var phi_1355_: f32;
    var phi_1394_: bool;
    var phi_1400_: bool;
    var phi_1415_: bool;
    var phi_1416_: bool;
    var phi_1417_: bool;
    var phi_1418_: bool;
    var phi_1419_: bool;
    var phi_1423_: bool;
    var phi_1769_: f32;
    var phi_1776_: f32;
    var phi_1781_: f32;
    var phi_1788_: f32;
    var phi_1793_: f32;
    var phi_1801_: f32;
    var phi_1808_: f32;
    var phi_1813_: f32;
    var phi_1820_: f32;
    var phi_1825_: f32;
    var phi_1830_: f32;
    var phi_1840_: f32;
    var phi_1847_: f32;
    var phi_1852_: f32;
    var phi_1859_: f32;
    var phi_1864_: f32;
    var phi_1872_: f32;
    var phi_1879_: f32;
    var phi_1884_: f32;
    var phi_1891_: f32;
    var phi_1896_: f32;
    var phi_1901_: f32;
    var phi_1911_: f32;
    var phi_1918_: f32;
    var phi_1923_: f32;
    var phi_1930_: f32;
    var phi_1935_: f32;
    var phi_1943_: f32;
    var phi_1950_: f32;
    var phi_1955_: f32;
    var phi_1962_: f32;
    var phi_1967_: f32;
    var phi_1972_: f32;
    var phi_1990_: f32;
    var phi_1996_: f32;
    var phi_2001_: f32;
    var phi_2007_: f32;
    var phi_2012_: f32;
    var phi_2042_: type_14;
    var phi_2045_: f32;
    var phi_2066_: bool;
    var phi_2072_: type_15;
    var phi_2043_: type_14;
    var phi_2086_: type_15;
    var phi_2046_: f32;
    var local_5: f32;
    var phi_2035_: f32;
    var phi_2099_: f32;
    var phi_2125_: f32;
    var phi_2131_: f32;
    var phi_2138_: f32;
    var phi_2152_: f32;
    var phi_2166_: array<f32, 3>;
    var phi_2167_: array<f32, 3>;
    var phi_2168_: bool;
    var phi_2169_: array<f32, 3>;
    var phi_2170_: bool;
    var phi_2180_: bool;
    var phi_2181_: bool;
    var phi_2216_: array<f32, 3>;
    var phi_2217_: bool;
    var phi_2218_: array<f32, 3>;
    var phi_2219_: bool;
    var phi_2220_: array<f32, 3>;
    var phi_2221_: bool;
    var phi_2243_: f32;
    var phi_2250_: f32;
    var phi_2255_: f32;
    var phi_2262_: f32;
    var phi_2267_: f32;
    var phi_2280_: f32;
    var phi_2287_: f32;
    var phi_2292_: f32;
    var phi_2299_: f32;
    var phi_2304_: f32;
    var phi_2309_: bool;
    var phi_2310_: bool;
    var phi_2320_: array<f32, 3>;
    var phi_2321_: bool;
    var phi_2322_: array<f32, 3>;
    var phi_2323_: bool;
    var phi_2337_: array<f32, 3>;
    var phi_2338_: array<f32, 3>;
    var phi_2339_: array<f32, 3>;
    var phi_2346_: f32;
    var phi_2353_: f32;
    var phi_2358_: f32;
    var phi_2365_: f32;
    var phi_2370_: f32;
    var phi_2381_: f32;
    var phi_2388_: f32;
    var phi_2393_: f32;
    var phi_2400_: f32;
    var phi_2405_: f32;
    var phi_2438_: type_14;
    var phi_2441_: f32;
    var phi_2462_: bool;
    var phi_2468_: type_15;
    var phi_2439_: type_14;
    var phi_2482_: type_15;
    var phi_2442_: f32;
    var local_6: f32;
    var phi_2431_: f32;
    var phi_2495_: f32;
    var phi_2522_: array<f32, 3>;
    var phi_2529_: f32;
    var phi_2536_: f32;
    var phi_2544_: f32;
    var phi_2562_: f32;
    var phi_2568_: f32;
    var phi_2573_: f32;
    var phi_2579_: f32;
    var phi_2584_: f32;
    var phi_2614_: type_14;
    var phi_2617_: f32;
    var phi_2638_: bool;
    var phi_2644_: type_15;
    var phi_2615_: type_14;
    var phi_2658_: type_15;
    var phi_2618_: f32;
    var local_7: f32;
    var phi_2607_: f32;
    var phi_2671_: f32;
    var phi_2687_: array<f32, 3>;
    var phi_2688_: bool;
    var phi_2689_: array<f32, 3>;
    var phi_2690_: bool;
    var phi_2845_: f32;
    var phi_2852_: f32;
    var phi_2857_: f32;
    var phi_2864_: f32;
    var phi_2869_: f32;
    var phi_2876_: f32;
    var phi_2883_: f32;
    var phi_2888_: f32;
    var phi_2895_: f32;
    var phi_2900_: f32;
    var phi_2905_: array<f32, 3>;
    var phi_2912_: f32;
    var phi_2919_: f32;
    var phi_2924_: f32;
    var phi_2931_: f32;
    var phi_2936_: f32;
    var phi_2947_: f32;
    var phi_2954_: f32;
    var phi_2961_: f32;
    var phi_2971_: array<f32, 3>;
    var phi_2972_: bool;
    var phi_2973_: array<f32, 3>;
    var phi_2974_: bool;
    var phi_2984_: array<f32, 3>;
    var phi_2985_: array<f32, 3>;
    var phi_2992_: f32;
    var phi_2999_: f32;
    var phi_3004_: f32;
    var phi_3011_: f32;
    var phi_3016_: f32;
    var phi_3049_: type_14;
    var phi_3052_: f32;
    var phi_3073_: bool;
    var phi_3079_: type_15;
    var phi_3050_: type_14;
    var phi_3093_: type_15;
    var phi_3053_: f32;
    var local_8: f32;
    var phi_3042_: f32;
    var phi_3106_: f32;
    var phi_3141_: f32;
    var phi_3147_: f32;
    var phi_3152_: f32;
    var phi_3158_: f32;
    var phi_3163_: f32;
    var phi_3193_: type_14;
    var phi_3196_: f32;
    var phi_3217_: bool;
    var phi_3223_: type_15;
    var phi_3194_: type_14;
    var phi_3237_: type_15;
    var phi_3197_: f32;
    var local_9: f32;
    var phi_3186_: f32;
    var phi_3250_: f32;
    var phi_3267_: array<f32, 3>;
    var phi_2702_: f32;
    var phi_2708_: f32;
    var phi_2713_: f32;
    var phi_2719_: f32;
    var phi_2724_: f32;
    var phi_2754_: type_14;
    var phi_2757_: f32;
    var phi_2778_: bool;
    var phi_2784_: type_15;
    var phi_2755_: type_14;
    var phi_2798_: type_15;
    var phi_2758_: f32;
    var local_10: f32;
    var phi_2747_: f32;
    var phi_2811_: f32;
    var phi_3268_: array<f32, 3>;
    var phi_3269_: array<f32, 3>;
    var phi_3270_: bool;
    var phi_3271_: array<f32, 3>;
    var phi_3272_: array<f32, 3>;
    var phi_3273_: bool;
    var phi_1485_: array<f32, 3>;
    var phi_1492_: f32;
    var phi_1499_: f32;
    var phi_1504_: f32;
    var phi_1511_: f32;
    var phi_1516_: f32;
    var phi_1549_: type_14;
    var phi_1552_: f32;
    var phi_1573_: bool;
    var phi_1579_: type_15;
    var phi_1550_: type_14;
    var phi_1593_: type_15;
    var phi_1553_: f32;
    var local_11: f32;
    var phi_1542_: f32;
    var phi_1606_: f32;
    var phi_1622_: array<f32, 3>;
    var phi_1623_: bool;
    var phi_1624_: array<f32, 3>;
    var phi_1625_: bool;
    var phi_1626_: array<f32, 3>;
    var phi_1627_: bool;
    var phi_1636_: f32;
    var phi_1642_: f32;
    var phi_1647_: f32;
    var phi_1653_: f32;
    var phi_1658_: f32;
    var phi_1688_: type_14;
    var phi_1691_: f32;
    var phi_1712_: bool;
    var phi_1718_: type_15;
    var phi_1689_: type_14;
    var phi_1732_: type_15;
    var phi_1692_: f32;
    var local_12: f32;
    var phi_1681_: f32;
    var phi_1745_: f32;
    var phi_1761_: array<f32, 3>;
    var phi_3277_: array<f32, 3>;
    var phi_3278_: array<f32, 3>;
    var phi_3279_: bool;
    var phi_3283_: array<f32, 3>;
    var phi_3300_: array<f32, 3>;
    var phi_3328_: f32;
    var phi_3356_: array<f32, 3>;
    var phi_3357_: array<f32, 3>;
    var phi_3358_: array<f32, 4>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e55 = id_2;
    let _e56 = n_2;
    let _e57 = lane_2;
    let _e68 = ((_e55.y * _e56.x) + _e55.x);
    let _e71 = (_e56.x * _e56.y);
    let _e74 = params.member.member_1.member_2;
    let _e76 = contacts.member[0u];
    if (_e74 < _e76) {
        phi_185_ = _e74;
    } else {
        phi_185_ = _e76;
    }
    let _e79 = phi_185_;
    let _e80 = (_e79 / 64u);
    if ((_e79 % 64u) > 0u) {
        phi_201_ = (_e80 + 1u);
    } else {
        phi_201_ = _e80;
    }
    let _e85 = phi_201_;
    if (_e85 > _e68) {
        let _e87 = (_e85 - _e68);
        if (_e71 == 0u) {
            return;
        }
        let _e89 = (_e87 / _e71);
        if (_e71 == 0u) {
            return;
        }
        if ((_e87 % _e71) > 0u) {
            phi_222_ = (_e89 + 1u);
        } else {
            phi_222_ = _e89;
        }
        let _e95 = phi_222_;
        phi_223_ = _e95;
    } else {
        phi_223_ = 0u;
    }
    let _e97 = phi_223_;
    phi_226_ = type_12(0u, _e97);
    loop {
        let _e100 = phi_226_;
        if (_e100.member < _e100.member_1) {
            phi_227_ = type_12((_e100.member + 1u), _e100.member_1);
            phi_250_ = type_12(1u, _e100.member);
        } else {
            phi_227_ = _e100;
            phi_250_ = type_12(0u, type_12().member_1);
        }
        let _e112 = phi_227_;
        let _e114 = phi_250_;
        let _e118 = (bitcast<i32>(_e114.member) != 0i);
        if _e118 {
            let _e122 = (((_e68 + (_e114.member_1 * _e71)) * 64u) + _e57);
            if (_e122 < _e79) {
                let _e124 = (7u * _e122);
                let _e127 = contacts.member[(4u + _e124)];
                let _e130 = contacts.member[(_e124 + 5u)];
                let _e133 = contacts.member[(_e124 + 6u)];
                let _e136 = contacts.member[(_e124 + 7u)];
                let _e139 = contacts.member[(_e124 + 8u)];
                let _e142 = contacts.member[(_e124 + 9u)];
                if (_e127 == 0u) {
                    let _e155 = faces.member[_e136];
                    phi_389_ = type_37(0u, array<u32, 4>(_e133, _e155[0], _e155[1], _e155[2]));
                } else {
                    let _e145 = edges.member[_e133];
                    let _e147 = edges.member[_e136];
                    phi_389_ = type_37(1u, array<u32, 4>(_e145[0], _e145[1], _e147[0], _e147[1]));
                }
                let _e162 = phi_389_;
                let _e167 = paths.member[_e162.member_1[0]];
                let _e170 = paths.member[_e162.member_1[1]];
                let _e177 = paths.member[_e162.member_1[2]];
                let _e180 = paths.member[_e162.member_1[3]];
                local_1 = array<array<f32, 3>, 4>(array<f32, 3>(_e167.member[0], _e167.member[1], _e167.member[2]), array<f32, 3>(_e170.member[0], _e170.member[1], _e170.member[2]), array<f32, 3>(_e177.member[0], _e177.member[1], _e177.member[2]), array<f32, 3>(_e180.member[0], _e180.member[1], _e180.member[2]));
                local_2 = array<array<f32, 3>, 4>(array<f32, 3>(_e167.member_1[0], _e167.member_1[1], _e167.member_1[2]), array<f32, 3>(_e170.member_1[0], _e170.member_1[1], _e170.member_1[2]), array<f32, 3>(_e177.member_1[0], _e177.member_1[1], _e177.member_1[2]), array<f32, 3>(_e180.member_1[0], _e180.member_1[1], _e180.member_1[2]));
                let _e220 = (_e142 >> bitcast<u32>(20i));
                if (_e220 <= 896u) {
                    phi_532_ = 0u;
                } else {
                    phi_532_ = ((((_e220 - 896u) << bitcast<u32>(23i)) | ((_e142 & 1048575u) << bitcast<u32>(3i))) | (_e139 >> bitcast<u32>(29i)));
                }
                let _e233 = phi_532_;
                if (_e233 < 1065353216u) {
                    phi_538_ = bitcast<f32>(_e233);
                } else {
                    phi_538_ = 1f;
                }
                let _e237 = phi_538_;
                let _e240 = params.member.member.member_4;
                let _e241 = function_3(_e237, 1f);
                if (_e162.member == 0u) {
                    let _e243 = function_11((&local_1), (&local_2), _e241);
                    phi_547_ = _e243;
                } else {
                    phi_547_ = 0u;
                }
                let _e245 = phi_547_;
                let _e246 = function_10((&local_1), _e245);
                let _e247 = function_10((&local_2), _e245);
                if (_e162.member != 0u) {
                    phi_708_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e246[2][0] - _e246[0][0]), (_e246[2][1] - _e246[0][1]), (_e246[2][2] - _e246[0][2])), array<f32, 3>((_e247[2][0] - _e247[0][0]), (_e247[2][1] - _e247[0][1]), (_e247[2][2] - _e247[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e246[1][0] - _e246[0][0]), (_e246[1][1] - _e246[0][1]), (_e246[1][2] - _e246[0][2])), array<f32, 3>((_e247[1][0] - _e247[0][0]), (_e247[1][1] - _e247[0][1]), (_e247[1][2] - _e247[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e246[2][0] - _e246[3][0]), (_e246[2][1] - _e246[3][1]), (_e246[2][2] - _e246[3][2])), array<f32, 3>((_e247[2][0] - _e247[3][0]), (_e247[2][1] - _e247[3][1]), (_e247[2][2] - _e247[3][2]))), (_e240 + _e240));
                } else {
                    phi_708_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e246[0][0] - _e246[1][0]), (_e246[0][1] - _e246[1][1]), (_e246[0][2] - _e246[1][2])), array<f32, 3>((_e247[0][0] - _e247[1][0]), (_e247[0][1] - _e247[1][1]), (_e247[0][2] - _e247[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e246[2][0] - _e246[1][0]), (_e246[2][1] - _e246[1][1]), (_e246[2][2] - _e246[1][2])), array<f32, 3>((_e247[2][0] - _e247[1][0]), (_e247[2][1] - _e247[1][1]), (_e247[2][2] - _e247[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e246[3][0] - _e246[1][0]), (_e246[3][1] - _e246[1][1]), (_e246[3][2] - _e246[1][2])), array<f32, 3>((_e247[3][0] - _e247[1][0]), (_e247[3][1] - _e247[1][1]), (_e247[3][2] - _e247[1][2]))), (_e240 + _e240));
                }
                let _e404 = phi_708_;
                let _e409 = function_9(_e404.member[0], _e404.member[1], _e241);
                let _e414 = function_9(_e404.member_1[0], _e404.member_1[1], _e241);
                let _e419 = function_9(_e404.member_2[0], _e404.member_2[1], _e241);
                if (_e409[0] < 0f) {
                    phi_724_ = -(_e409[0]);
                } else {
                    phi_724_ = _e409[0];
                }
                let _e424 = phi_724_;
                if (_e409[1] < 0f) {
                    phi_731_ = -(_e409[1]);
                } else {
                    phi_731_ = _e409[1];
                }
                let _e429 = phi_731_;
                if (_e424 > _e429) {
                    phi_736_ = _e424;
                } else {
                    phi_736_ = _e429;
                }
                let _e432 = phi_736_;
                if (_e409[2] < 0f) {
                    phi_743_ = -(_e409[2]);
                } else {
                    phi_743_ = _e409[2];
                }
                let _e437 = phi_743_;
                if (_e432 > _e437) {
                    phi_748_ = _e432;
                } else {
                    phi_748_ = _e437;
                }
                let _e440 = phi_748_;
                if (_e414[0] < 0f) {
                    phi_755_ = -(_e414[0]);
                } else {
                    phi_755_ = _e414[0];
                }
                let _e445 = phi_755_;
                if (_e414[1] < 0f) {
                    phi_762_ = -(_e414[1]);
                } else {
                    phi_762_ = _e414[1];
                }
                let _e450 = phi_762_;
                if (_e445 > _e450) {
                    phi_767_ = _e445;
                } else {
                    phi_767_ = _e450;
                }
                let _e453 = phi_767_;
                if (_e414[2] < 0f) {
                    phi_774_ = -(_e414[2]);
                } else {
                    phi_774_ = _e414[2];
                }
                let _e458 = phi_774_;
                if (_e453 > _e458) {
                    phi_779_ = _e453;
                } else {
                    phi_779_ = _e458;
                }
                let _e461 = phi_779_;
                if (_e440 > _e461) {
                    phi_784_ = _e440;
                } else {
                    phi_784_ = _e461;
                }
                let _e464 = phi_784_;
                if (_e419[0] < 0f) {
                    phi_791_ = -(_e419[0]);
                } else {
                    phi_791_ = _e419[0];
                }
                let _e469 = phi_791_;
                if (_e419[1] < 0f) {
                    phi_798_ = -(_e419[1]);
                } else {
                    phi_798_ = _e419[1];
                }
                let _e474 = phi_798_;
                if (_e469 > _e474) {
                    phi_803_ = _e469;
                } else {
                    phi_803_ = _e474;
                }
                let _e477 = phi_803_;
                if (_e419[2] < 0f) {
                    phi_810_ = -(_e419[2]);
                } else {
                    phi_810_ = _e419[2];
                }
                let _e482 = phi_810_;
                if (_e477 > _e482) {
                    phi_815_ = _e477;
                } else {
                    phi_815_ = _e482;
                }
                let _e485 = phi_815_;
                if (_e464 > _e485) {
                    phi_820_ = _e464;
                } else {
                    phi_820_ = _e485;
                }
                let _e488 = phi_820_;
                let _e489 = function_8(_e488);
                let _e497 = (_e414[0] * _e489);
                let _e499 = (_e414[1] * _e489);
                let _e501 = (_e414[2] * _e489);
                let _e503 = (_e419[0] * _e489);
                let _e505 = (_e419[1] * _e489);
                let _e507 = (_e419[2] * _e489);
                if (_e404.member[0][0] < 0f) {
                    phi_850_ = -(_e404.member[0][0]);
                } else {
                    phi_850_ = _e404.member[0][0];
                }
                let _e514 = phi_850_;
                if (_e404.member[0][1] < 0f) {
                    phi_857_ = -(_e404.member[0][1]);
                } else {
                    phi_857_ = _e404.member[0][1];
                }
                let _e519 = phi_857_;
                if (_e514 > _e519) {
                    phi_862_ = _e514;
                } else {
                    phi_862_ = _e519;
                }
                let _e522 = phi_862_;
                if (_e404.member[0][2] < 0f) {
                    phi_869_ = -(_e404.member[0][2]);
                } else {
                    phi_869_ = _e404.member[0][2];
                }
                let _e527 = phi_869_;
                if (_e522 > _e527) {
                    phi_874_ = _e522;
                } else {
                    phi_874_ = _e527;
                }
                let _e530 = phi_874_;
                if (_e404.member[1][0] < 0f) {
                    phi_882_ = -(_e404.member[1][0]);
                } else {
                    phi_882_ = _e404.member[1][0];
                }
                let _e537 = phi_882_;
                if (_e404.member[1][1] < 0f) {
                    phi_889_ = -(_e404.member[1][1]);
                } else {
                    phi_889_ = _e404.member[1][1];
                }
                let _e542 = phi_889_;
                if (_e537 > _e542) {
                    phi_894_ = _e537;
                } else {
                    phi_894_ = _e542;
                }
                let _e545 = phi_894_;
                if (_e404.member[1][2] < 0f) {
                    phi_901_ = -(_e404.member[1][2]);
                } else {
                    phi_901_ = _e404.member[1][2];
                }
                let _e550 = phi_901_;
                if (_e545 > _e550) {
                    phi_906_ = _e545;
                } else {
                    phi_906_ = _e550;
                }
                let _e553 = phi_906_;
                if (_e530 > _e553) {
                    phi_911_ = _e530;
                } else {
                    phi_911_ = _e553;
                }
                let _e556 = phi_911_;
                if (_e404.member_1[0][0] < 0f) {
                    phi_921_ = -(_e404.member_1[0][0]);
                } else {
                    phi_921_ = _e404.member_1[0][0];
                }
                let _e565 = phi_921_;
                if (_e404.member_1[0][1] < 0f) {
                    phi_928_ = -(_e404.member_1[0][1]);
                } else {
                    phi_928_ = _e404.member_1[0][1];
                }
                let _e570 = phi_928_;
                if (_e565 > _e570) {
                    phi_933_ = _e565;
                } else {
                    phi_933_ = _e570;
                }
                let _e573 = phi_933_;
                if (_e404.member_1[0][2] < 0f) {
                    phi_940_ = -(_e404.member_1[0][2]);
                } else {
                    phi_940_ = _e404.member_1[0][2];
                }
                let _e578 = phi_940_;
                if (_e573 > _e578) {
                    phi_945_ = _e573;
                } else {
                    phi_945_ = _e578;
                }
                let _e581 = phi_945_;
                if (_e404.member_1[1][0] < 0f) {
                    phi_953_ = -(_e404.member_1[1][0]);
                } else {
                    phi_953_ = _e404.member_1[1][0];
                }
                let _e588 = phi_953_;
                if (_e404.member_1[1][1] < 0f) {
                    phi_960_ = -(_e404.member_1[1][1]);
                } else {
                    phi_960_ = _e404.member_1[1][1];
                }
                let _e593 = phi_960_;
                if (_e588 > _e593) {
                    phi_965_ = _e588;
                } else {
                    phi_965_ = _e593;
                }
                let _e596 = phi_965_;
                if (_e404.member_1[1][2] < 0f) {
                    phi_972_ = -(_e404.member_1[1][2]);
                } else {
                    phi_972_ = _e404.member_1[1][2];
                }
                let _e601 = phi_972_;
                if (_e596 > _e601) {
                    phi_977_ = _e596;
                } else {
                    phi_977_ = _e601;
                }
                let _e604 = phi_977_;
                if (_e581 > _e604) {
                    phi_982_ = _e581;
                } else {
                    phi_982_ = _e604;
                }
                let _e607 = phi_982_;
                let _e609 = (_e607 + _e404.member_3);
                if (_e404.member_2[0][0] < 0f) {
                    phi_992_ = -(_e404.member_2[0][0]);
                } else {
                    phi_992_ = _e404.member_2[0][0];
                }
                let _e616 = phi_992_;
                if (_e404.member_2[0][1] < 0f) {
                    phi_999_ = -(_e404.member_2[0][1]);
                } else {
                    phi_999_ = _e404.member_2[0][1];
                }
                let _e621 = phi_999_;
                if (_e616 > _e621) {
                    phi_1004_ = _e616;
                } else {
                    phi_1004_ = _e621;
                }
                let _e624 = phi_1004_;
                if (_e404.member_2[0][2] < 0f) {
                    phi_1011_ = -(_e404.member_2[0][2]);
                } else {
                    phi_1011_ = _e404.member_2[0][2];
                }
                let _e629 = phi_1011_;
                if (_e624 > _e629) {
                    phi_1016_ = _e624;
                } else {
                    phi_1016_ = _e629;
                }
                let _e632 = phi_1016_;
                if (_e404.member_2[1][0] < 0f) {
                    phi_1024_ = -(_e404.member_2[1][0]);
                } else {
                    phi_1024_ = _e404.member_2[1][0];
                }
                let _e639 = phi_1024_;
                if (_e404.member_2[1][1] < 0f) {
                    phi_1031_ = -(_e404.member_2[1][1]);
                } else {
                    phi_1031_ = _e404.member_2[1][1];
                }
                let _e644 = phi_1031_;
                if (_e639 > _e644) {
                    phi_1036_ = _e639;
                } else {
                    phi_1036_ = _e644;
                }
                let _e647 = phi_1036_;
                if (_e404.member_2[1][2] < 0f) {
                    phi_1043_ = -(_e404.member_2[1][2]);
                } else {
                    phi_1043_ = _e404.member_2[1][2];
                }
                let _e652 = phi_1043_;
                if (_e647 > _e652) {
                    phi_1048_ = _e647;
                } else {
                    phi_1048_ = _e652;
                }
                let _e655 = phi_1048_;
                if (_e632 > _e655) {
                    phi_1053_ = _e632;
                } else {
                    phi_1053_ = _e655;
                }
                let _e658 = phi_1053_;
                let _e660 = (_e658 + _e404.member_3);
                let _e661 = (0.000000059604645f * 16f);
                let _e663 = (_e404.member_3 * 4f);
                let _e671 = ((_e499 * _e507) - (_e501 * _e505));
                let _e674 = ((_e501 * _e503) - (_e497 * _e507));
                let _e677 = ((_e497 * _e505) - (_e499 * _e503));
                if (_e503 < 0f) {
                    phi_1084_ = -(_e503);
                } else {
                    phi_1084_ = _e503;
                }
                let _e686 = phi_1084_;
                if (_e505 < 0f) {
                    phi_1090_ = -(_e505);
                } else {
                    phi_1090_ = _e505;
                }
                let _e690 = phi_1090_;
                if (_e686 > _e690) {
                    phi_1095_ = _e686;
                } else {
                    phi_1095_ = _e690;
                }
                let _e693 = phi_1095_;
                if (_e507 < 0f) {
                    phi_1101_ = -(_e507);
                } else {
                    phi_1101_ = _e507;
                }
                let _e697 = phi_1101_;
                if (_e693 > _e697) {
                    phi_1106_ = _e693;
                } else {
                    phi_1106_ = _e697;
                }
                let _e700 = phi_1106_;
                if (_e497 < 0f) {
                    phi_1114_ = -(_e497);
                } else {
                    phi_1114_ = _e497;
                }
                let _e706 = phi_1114_;
                if (_e499 < 0f) {
                    phi_1120_ = -(_e499);
                } else {
                    phi_1120_ = _e499;
                }
                let _e710 = phi_1120_;
                if (_e706 > _e710) {
                    phi_1125_ = _e706;
                } else {
                    phi_1125_ = _e710;
                }
                let _e713 = phi_1125_;
                if (_e501 < 0f) {
                    phi_1131_ = -(_e501);
                } else {
                    phi_1131_ = _e501;
                }
                let _e717 = phi_1131_;
                if (_e713 > _e717) {
                    phi_1136_ = _e713;
                } else {
                    phi_1136_ = _e717;
                }
                let _e720 = phi_1136_;
                let _e722 = (((((_e609 * _e661) + _e663) * _e489) * _e700) + ((((_e660 * _e661) + _e663) * _e489) * _e720));
                let _e727 = (((_e671 * _e671) + (_e674 * _e674)) + (_e677 * _e677));
                if (_e727 <= 0.000000000000000000000000000000000000011754944f) {
                    if (_e727 > 0f) {
                        phi_1157_ = (0.000000000000000000106433627f * 2f);
                    } else {
                        phi_1157_ = 0f;
                    }
                    let _e780 = phi_1157_;
                    phi_1221_ = _e780;
                } else {
                    phi_1164_ = type_14(0i, 5i);
                    phi_1167_ = bitcast<f32>(((bitcast<u32>(_e727) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e735 = phi_1164_;
                        let _e737 = phi_1167_;
                        local_3 = _e737;
                        if (_e735.member < _e735.member_1) {
                            let _e744 = (_e735.member + 1i);
                            if ((false == (_e744 > _e735.member)) != false) {
                                phi_1188_ = true;
                            } else {
                                phi_1188_ = false;
                            }
                            let _e749 = phi_1188_;
                            if _e749 {
                                phi_1194_ = type_15(0u, type_15().member_1);
                            } else {
                                phi_1194_ = type_15(1u, _e744);
                            }
                            let _e754 = phi_1194_;
                            phi_1165_ = type_14(_e754.member_1, _e735.member_1);
                            phi_1208_ = type_15(1u, _e735.member);
                        } else {
                            phi_1165_ = _e735;
                            phi_1208_ = type_15(0u, type_15().member_1);
                        }
                        let _e760 = phi_1165_;
                        let _e762 = phi_1208_;
                        let _e765 = (bitcast<i32>(_e762.member) != 0i);
                        if _e765 {
                            phi_1168_ = (0.5f * (_e737 + (_e727 / _e737)));
                        } else {
                            phi_1168_ = f32();
                        }
                        let _e770 = phi_1168_;
                        continue;
                        continuing {
                            phi_1164_ = _e760;
                            phi_1167_ = _e770;
                            break if !(_e765);
                        }
                    }
                    let _e775 = local_3;
                    phi_1221_ = (_e775 * (1f + (8f * 0.000000059604645f)));
                }
                let _e782 = phi_1221_;
                if (_e782 > 0f) {
                    phi_1229_ = ((_e782 + (_e727 / _e782)) * 0.5f);
                } else {
                    phi_1229_ = _e782;
                }
                let _e788 = phi_1229_;
                if (_e788 > _e722) {
                    phi_1234_ = _e788;
                } else {
                    phi_1234_ = 0f;
                }
                let _e791 = phi_1234_;
                local = type_27(array<f32, 3>((_e409[0] * _e489), (_e409[1] * _e489), (_e409[2] * _e489)), array<f32, 3>(_e497, _e499, _e501), array<f32, 3>(_e503, _e505, _e507), array<f32, 3>(_e671, _e674, _e677), _e791, _e722, ((((((_e556 + _e404.member_3) + _e609) + _e660) * _e661) + _e663) * _e489));
                let _e797 = function_7((&local), _e162.member);
                if (_e797.member_3 <= 0.000000000000000000000000000000000000011754944f) {
                    if (_e797.member_3 > 0f) {
                        phi_1277_ = (0.000000000000000000106433627f * 2f);
                    } else {
                        phi_1277_ = 0f;
                    }
                    let _e853 = phi_1277_;
                    phi_1341_ = _e853;
                } else {
                    phi_1284_ = type_14(0i, 5i);
                    phi_1287_ = bitcast<f32>(((bitcast<u32>(_e797.member_3) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e808 = phi_1284_;
                        let _e810 = phi_1287_;
                        local_4 = _e810;
                        if (_e808.member < _e808.member_1) {
                            let _e817 = (_e808.member + 1i);
                            if ((false == (_e817 > _e808.member)) != false) {
                                phi_1308_ = true;
                            } else {
                                phi_1308_ = false;
                            }
                            let _e822 = phi_1308_;
                            if _e822 {
                                phi_1314_ = type_15(0u, type_15().member_1);
                            } else {
                                phi_1314_ = type_15(1u, _e817);
                            }
                            let _e827 = phi_1314_;
                            phi_1285_ = type_14(_e827.member_1, _e808.member_1);
                            phi_1328_ = type_15(1u, _e808.member);
                        } else {
                            phi_1285_ = _e808;
                            phi_1328_ = type_15(0u, type_15().member_1);
                        }
                        let _e833 = phi_1285_;
                        let _e835 = phi_1328_;
                        let _e838 = (bitcast<i32>(_e835.member) != 0i);
                        if _e838 {
                            phi_1288_ = (0.5f * (_e810 + (_e797.member_3 / _e810)));
                        } else {
                            phi_1288_ = f32();
                        }
                        let _e843 = phi_1288_;
                        continue;
                        continuing {
                            phi_1284_ = _e833;
                            phi_1287_ = _e843;
                            break if !(_e838);
                        }
                    }
                    let _e848 = local_4;
                    phi_1341_ = (_e848 * (1f + (8f * 0.000000059604645f)));
                }
                let _e855 = phi_1341_;
                if (_e855 > 0f) {
                    phi_1349_ = ((_e855 + (_e797.member_3 / _e855)) * 0.5f);
                } else {
                    phi_1349_ = _e855;
                }
                let _e861 = phi_1349_;
                if (_e162.member == 0u) {
                    phi_1355_ = 1f;
                } else {
                    phi_1355_ = -(1f);
                }
                let _e865 = phi_1355_;
                let _e867 = function_1(_e404.member);
                let _e869 = function_1(_e404.member_1);
                let _e883 = function_1(_e404.member_2);
                let _e893 = (((_e867[0] - (_e869[0] * _e797.member)) - (_e883[0] * _e797.member_1)) * _e865);
                let _e894 = (((_e867[1] - (_e869[1] * _e797.member)) - (_e883[1] * _e797.member_1)) * _e865);
                let _e895 = (((_e867[2] - (_e869[2] * _e797.member)) - (_e883[2] * _e797.member_1)) * _e865);
                if (_e797.member > 0f) {
                    phi_1394_ = (_e797.member < 1f);
                } else {
                    phi_1394_ = false;
                }
                let _e902 = phi_1394_;
                if (_e797.member_1 > 0f) {
                    phi_1400_ = (_e797.member_1 < 1f);
                } else {
                    phi_1400_ = false;
                }
                let _e906 = phi_1400_;
                let _e907 = (_e865 > 0f);
                if _e902 {
                    if _e906 {
                        if _e907 {
                            phi_1415_ = ((_e797.member + _e797.member_1) < (1f - (0.000000059604645f * 4f)));
                        } else {
                            phi_1415_ = true;
                        }
                        let _e913 = phi_1415_;
                        phi_1416_ = _e913;
                        phi_1417_ = false;
                    } else {
                        phi_1416_ = bool();
                        phi_1417_ = true;
                    }
                    let _e915 = phi_1416_;
                    let _e917 = phi_1417_;
                    phi_1418_ = _e915;
                    phi_1419_ = _e917;
                } else {
                    phi_1418_ = bool();
                    phi_1419_ = true;
                }
                let _e919 = phi_1418_;
                let _e921 = phi_1419_;
                if _e921 {
                    phi_1423_ = false;
                } else {
                    phi_1423_ = _e919;
                }
                let _e923 = phi_1423_;
                let _e925 = local.member_4;
                let _e926 = (_e925 > 0f);
                let _e928 = local.member_3;
                let _e932 = (_e928[0] * _e865);
                let _e933 = (_e928[1] * _e865);
                let _e934 = (_e928[2] * _e865);
                let _e937 = local.member_6;
                if (_e861 > _e937) {
                    let _e2048 = (_e797.member_2[0] * _e865);
                    let _e2050 = (_e797.member_2[1] * _e865);
                    let _e2052 = (_e797.member_2[2] * _e865);
                    if _e926 {
                        if _e923 {
                            let _e2054 = local.member_5;
                            let _e2057 = local.member_6;
                            let _e2059 = local.member_4;
                            if ((_e2054 * _e861) <= (_e2057 * _e2059)) {
                                if ((((_e2048 * _e932) + (_e2050 * _e933)) + (_e2052 * _e934)) >= 0f) {
                                    phi_1485_ = array<f32, 3>(_e932, _e933, _e934);
                                } else {
                                    let _e2068 = -(1f);
                                    phi_1485_ = array<f32, 3>((_e932 * _e2068), (_e933 * _e2068), (_e934 * _e2068));
                                }
                                let _e2074 = phi_1485_;
                                if (_e2074[0] < 0f) {
                                    phi_1492_ = -(_e2074[0]);
                                } else {
                                    phi_1492_ = _e2074[0];
                                }
                                let _e2079 = phi_1492_;
                                if (_e2074[1] < 0f) {
                                    phi_1499_ = -(_e2074[1]);
                                } else {
                                    phi_1499_ = _e2074[1];
                                }
                                let _e2084 = phi_1499_;
                                if (_e2079 > _e2084) {
                                    phi_1504_ = _e2079;
                                } else {
                                    phi_1504_ = _e2084;
                                }
                                let _e2087 = phi_1504_;
                                if (_e2074[2] < 0f) {
                                    phi_1511_ = -(_e2074[2]);
                                } else {
                                    phi_1511_ = _e2074[2];
                                }
                                let _e2092 = phi_1511_;
                                if (_e2087 > _e2092) {
                                    phi_1516_ = _e2087;
                                } else {
                                    phi_1516_ = _e2092;
                                }
                                let _e2095 = phi_1516_;
                                let _e2096 = function_8(_e2095);
                                let _e2098 = (_e2074[0] * _e2096);
                                let _e2100 = (_e2074[1] * _e2096);
                                let _e2102 = (_e2074[2] * _e2096);
                                let _e2107 = (((_e2098 * _e2098) + (_e2100 * _e2100)) + (_e2102 * _e2102));
                                if (_e2107 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e2107 > 0f) {
                                        phi_1542_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_1542_ = 0f;
                                    }
                                    let _e2160 = phi_1542_;
                                    phi_1606_ = _e2160;
                                } else {
                                    phi_1549_ = type_14(0i, 5i);
                                    phi_1552_ = bitcast<f32>(((bitcast<u32>(_e2107) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e2115 = phi_1549_;
                                        let _e2117 = phi_1552_;
                                        local_11 = _e2117;
                                        if (_e2115.member < _e2115.member_1) {
                                            let _e2124 = (_e2115.member + 1i);
                                            if ((false == (_e2124 > _e2115.member)) != false) {
                                                phi_1573_ = true;
                                            } else {
                                                phi_1573_ = false;
                                            }
                                            let _e2129 = phi_1573_;
                                            if _e2129 {
                                                phi_1579_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_1579_ = type_15(1u, _e2124);
                                            }
                                            let _e2134 = phi_1579_;
                                            phi_1550_ = type_14(_e2134.member_1, _e2115.member_1);
                                            phi_1593_ = type_15(1u, _e2115.member);
                                        } else {
                                            phi_1550_ = _e2115;
                                            phi_1593_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2140 = phi_1550_;
                                        let _e2142 = phi_1593_;
                                        let _e2145 = (bitcast<i32>(_e2142.member) != 0i);
                                        if _e2145 {
                                            phi_1553_ = (0.5f * (_e2117 + (_e2107 / _e2117)));
                                        } else {
                                            phi_1553_ = f32();
                                        }
                                        let _e2150 = phi_1553_;
                                        continue;
                                        continuing {
                                            phi_1549_ = _e2140;
                                            phi_1552_ = _e2150;
                                            break if !(_e2145);
                                        }
                                    }
                                    let _e2155 = local_11;
                                    phi_1606_ = (_e2155 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2162 = phi_1606_;
                                let _e2163 = (1f / _e2162);
                                let _e2164 = (_e2098 * _e2163);
                                let _e2165 = (_e2100 * _e2163);
                                let _e2166 = (_e2102 * _e2163);
                                let _e2173 = ((3f - (((_e2164 * _e2164) + (_e2165 * _e2165)) + (_e2166 * _e2166))) * 0.5f);
                                phi_1622_ = array<f32, 3>((_e2164 * _e2173), (_e2165 * _e2173), (_e2166 * _e2173));
                                phi_1623_ = false;
                            } else {
                                phi_1622_ = array<f32, 3>();
                                phi_1623_ = true;
                            }
                            let _e2179 = phi_1622_;
                            let _e2181 = phi_1623_;
                            phi_1624_ = _e2179;
                            phi_1625_ = _e2181;
                        } else {
                            phi_1624_ = array<f32, 3>();
                            phi_1625_ = true;
                        }
                        let _e2183 = phi_1624_;
                        let _e2185 = phi_1625_;
                        phi_1626_ = _e2183;
                        phi_1627_ = _e2185;
                    } else {
                        phi_1626_ = array<f32, 3>();
                        phi_1627_ = true;
                    }
                    let _e2187 = phi_1626_;
                    let _e2189 = phi_1627_;
                    if _e2189 {
                        if (_e2048 < 0f) {
                            phi_1636_ = -(_e2048);
                        } else {
                            phi_1636_ = _e2048;
                        }
                        let _e2193 = phi_1636_;
                        if (_e2050 < 0f) {
                            phi_1642_ = -(_e2050);
                        } else {
                            phi_1642_ = _e2050;
                        }
                        let _e2197 = phi_1642_;
                        if (_e2193 > _e2197) {
                            phi_1647_ = _e2193;
                        } else {
                            phi_1647_ = _e2197;
                        }
                        let _e2200 = phi_1647_;
                        if (_e2052 < 0f) {
                            phi_1653_ = -(_e2052);
                        } else {
                            phi_1653_ = _e2052;
                        }
                        let _e2204 = phi_1653_;
                        if (_e2200 > _e2204) {
                            phi_1658_ = _e2200;
                        } else {
                            phi_1658_ = _e2204;
                        }
                        let _e2207 = phi_1658_;
                        let _e2208 = function_8(_e2207);
                        let _e2209 = (_e2048 * _e2208);
                        let _e2210 = (_e2050 * _e2208);
                        let _e2211 = (_e2052 * _e2208);
                        let _e2216 = (((_e2209 * _e2209) + (_e2210 * _e2210)) + (_e2211 * _e2211));
                        if (_e2216 <= 0.000000000000000000000000000000000000011754944f) {
                            if (_e2216 > 0f) {
                                phi_1681_ = (0.000000000000000000106433627f * 2f);
                            } else {
                                phi_1681_ = 0f;
                            }
                            let _e2269 = phi_1681_;
                            phi_1745_ = _e2269;
                        } else {
                            phi_1688_ = type_14(0i, 5i);
                            phi_1691_ = bitcast<f32>(((bitcast<u32>(_e2216) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e2224 = phi_1688_;
                                let _e2226 = phi_1691_;
                                local_12 = _e2226;
                                if (_e2224.member < _e2224.member_1) {
                                    let _e2233 = (_e2224.member + 1i);
                                    if ((false == (_e2233 > _e2224.member)) != false) {
                                        phi_1712_ = true;
                                    } else {
                                        phi_1712_ = false;
                                    }
                                    let _e2238 = phi_1712_;
                                    if _e2238 {
                                        phi_1718_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_1718_ = type_15(1u, _e2233);
                                    }
                                    let _e2243 = phi_1718_;
                                    phi_1689_ = type_14(_e2243.member_1, _e2224.member_1);
                                    phi_1732_ = type_15(1u, _e2224.member);
                                } else {
                                    phi_1689_ = _e2224;
                                    phi_1732_ = type_15(0u, type_15().member_1);
                                }
                                let _e2249 = phi_1689_;
                                let _e2251 = phi_1732_;
                                let _e2254 = (bitcast<i32>(_e2251.member) != 0i);
                                if _e2254 {
                                    phi_1692_ = (0.5f * (_e2226 + (_e2216 / _e2226)));
                                } else {
                                    phi_1692_ = f32();
                                }
                                let _e2259 = phi_1692_;
                                continue;
                                continuing {
                                    phi_1688_ = _e2249;
                                    phi_1691_ = _e2259;
                                    break if !(_e2254);
                                }
                            }
                            let _e2264 = local_12;
                            phi_1745_ = (_e2264 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e2271 = phi_1745_;
                        let _e2272 = (1f / _e2271);
                        let _e2273 = (_e2209 * _e2272);
                        let _e2274 = (_e2210 * _e2272);
                        let _e2275 = (_e2211 * _e2272);
                        let _e2282 = ((3f - (((_e2273 * _e2273) + (_e2274 * _e2274)) + (_e2275 * _e2275))) * 0.5f);
                        phi_1761_ = array<f32, 3>((_e2273 * _e2282), (_e2274 * _e2282), (_e2275 * _e2282));
                    } else {
                        phi_1761_ = _e2187;
                    }
                    let _e2288 = phi_1761_;
                    phi_3277_ = _e2288;
                    phi_3278_ = array<f32, 3>();
                    phi_3279_ = true;
                } else {
                    if (_e404.member[0][0] < 0f) {
                        phi_1769_ = -(_e404.member[0][0]);
                    } else {
                        phi_1769_ = _e404.member[0][0];
                    }
                    let _e945 = phi_1769_;
                    if (_e404.member[0][1] < 0f) {
                        phi_1776_ = -(_e404.member[0][1]);
                    } else {
                        phi_1776_ = _e404.member[0][1];
                    }
                    let _e950 = phi_1776_;
                    if (_e945 > _e950) {
                        phi_1781_ = _e945;
                    } else {
                        phi_1781_ = _e950;
                    }
                    let _e953 = phi_1781_;
                    if (_e404.member[0][2] < 0f) {
                        phi_1788_ = -(_e404.member[0][2]);
                    } else {
                        phi_1788_ = _e404.member[0][2];
                    }
                    let _e958 = phi_1788_;
                    if (_e953 > _e958) {
                        phi_1793_ = _e953;
                    } else {
                        phi_1793_ = _e958;
                    }
                    let _e961 = phi_1793_;
                    if (_e404.member[1][0] < 0f) {
                        phi_1801_ = -(_e404.member[1][0]);
                    } else {
                        phi_1801_ = _e404.member[1][0];
                    }
                    let _e968 = phi_1801_;
                    if (_e404.member[1][1] < 0f) {
                        phi_1808_ = -(_e404.member[1][1]);
                    } else {
                        phi_1808_ = _e404.member[1][1];
                    }
                    let _e973 = phi_1808_;
                    if (_e968 > _e973) {
                        phi_1813_ = _e968;
                    } else {
                        phi_1813_ = _e973;
                    }
                    let _e976 = phi_1813_;
                    if (_e404.member[1][2] < 0f) {
                        phi_1820_ = -(_e404.member[1][2]);
                    } else {
                        phi_1820_ = _e404.member[1][2];
                    }
                    let _e981 = phi_1820_;
                    if (_e976 > _e981) {
                        phi_1825_ = _e976;
                    } else {
                        phi_1825_ = _e981;
                    }
                    let _e984 = phi_1825_;
                    if (_e961 > _e984) {
                        phi_1830_ = _e961;
                    } else {
                        phi_1830_ = _e984;
                    }
                    let _e987 = phi_1830_;
                    if (_e404.member_1[0][0] < 0f) {
                        phi_1840_ = -(_e404.member_1[0][0]);
                    } else {
                        phi_1840_ = _e404.member_1[0][0];
                    }
                    let _e996 = phi_1840_;
                    if (_e404.member_1[0][1] < 0f) {
                        phi_1847_ = -(_e404.member_1[0][1]);
                    } else {
                        phi_1847_ = _e404.member_1[0][1];
                    }
                    let _e1001 = phi_1847_;
                    if (_e996 > _e1001) {
                        phi_1852_ = _e996;
                    } else {
                        phi_1852_ = _e1001;
                    }
                    let _e1004 = phi_1852_;
                    if (_e404.member_1[0][2] < 0f) {
                        phi_1859_ = -(_e404.member_1[0][2]);
                    } else {
                        phi_1859_ = _e404.member_1[0][2];
                    }
                    let _e1009 = phi_1859_;
                    if (_e1004 > _e1009) {
                        phi_1864_ = _e1004;
                    } else {
                        phi_1864_ = _e1009;
                    }
                    let _e1012 = phi_1864_;
                    if (_e404.member_1[1][0] < 0f) {
                        phi_1872_ = -(_e404.member_1[1][0]);
                    } else {
                        phi_1872_ = _e404.member_1[1][0];
                    }
                    let _e1019 = phi_1872_;
                    if (_e404.member_1[1][1] < 0f) {
                        phi_1879_ = -(_e404.member_1[1][1]);
                    } else {
                        phi_1879_ = _e404.member_1[1][1];
                    }
                    let _e1024 = phi_1879_;
                    if (_e1019 > _e1024) {
                        phi_1884_ = _e1019;
                    } else {
                        phi_1884_ = _e1024;
                    }
                    let _e1027 = phi_1884_;
                    if (_e404.member_1[1][2] < 0f) {
                        phi_1891_ = -(_e404.member_1[1][2]);
                    } else {
                        phi_1891_ = _e404.member_1[1][2];
                    }
                    let _e1032 = phi_1891_;
                    if (_e1027 > _e1032) {
                        phi_1896_ = _e1027;
                    } else {
                        phi_1896_ = _e1032;
                    }
                    let _e1035 = phi_1896_;
                    if (_e1012 > _e1035) {
                        phi_1901_ = _e1012;
                    } else {
                        phi_1901_ = _e1035;
                    }
                    let _e1038 = phi_1901_;
                    if (_e404.member_2[0][0] < 0f) {
                        phi_1911_ = -(_e404.member_2[0][0]);
                    } else {
                        phi_1911_ = _e404.member_2[0][0];
                    }
                    let _e1047 = phi_1911_;
                    if (_e404.member_2[0][1] < 0f) {
                        phi_1918_ = -(_e404.member_2[0][1]);
                    } else {
                        phi_1918_ = _e404.member_2[0][1];
                    }
                    let _e1052 = phi_1918_;
                    if (_e1047 > _e1052) {
                        phi_1923_ = _e1047;
                    } else {
                        phi_1923_ = _e1052;
                    }
                    let _e1055 = phi_1923_;
                    if (_e404.member_2[0][2] < 0f) {
                        phi_1930_ = -(_e404.member_2[0][2]);
                    } else {
                        phi_1930_ = _e404.member_2[0][2];
                    }
                    let _e1060 = phi_1930_;
                    if (_e1055 > _e1060) {
                        phi_1935_ = _e1055;
                    } else {
                        phi_1935_ = _e1060;
                    }
                    let _e1063 = phi_1935_;
                    if (_e404.member_2[1][0] < 0f) {
                        phi_1943_ = -(_e404.member_2[1][0]);
                    } else {
                        phi_1943_ = _e404.member_2[1][0];
                    }
                    let _e1070 = phi_1943_;
                    if (_e404.member_2[1][1] < 0f) {
                        phi_1950_ = -(_e404.member_2[1][1]);
                    } else {
                        phi_1950_ = _e404.member_2[1][1];
                    }
                    let _e1075 = phi_1950_;
                    if (_e1070 > _e1075) {
                        phi_1955_ = _e1070;
                    } else {
                        phi_1955_ = _e1075;
                    }
                    let _e1078 = phi_1955_;
                    if (_e404.member_2[1][2] < 0f) {
                        phi_1962_ = -(_e404.member_2[1][2]);
                    } else {
                        phi_1962_ = _e404.member_2[1][2];
                    }
                    let _e1083 = phi_1962_;
                    if (_e1078 > _e1083) {
                        phi_1967_ = _e1078;
                    } else {
                        phi_1967_ = _e1083;
                    }
                    let _e1086 = phi_1967_;
                    if (_e1063 > _e1086) {
                        phi_1972_ = _e1063;
                    } else {
                        phi_1972_ = _e1086;
                    }
                    let _e1089 = phi_1972_;
                    let _e1098 = (((((_e987 + _e404.member_3) + (_e1038 + _e404.member_3)) + (_e1089 + _e404.member_3)) * (0.000000059604645f * 32f)) + (_e404.member_3 * 8f));
                    if _e926 {
                        if (_e932 < 0f) {
                            phi_1990_ = -(_e932);
                        } else {
                            phi_1990_ = _e932;
                        }
                        let _e1102 = phi_1990_;
                        if (_e933 < 0f) {
                            phi_1996_ = -(_e933);
                        } else {
                            phi_1996_ = _e933;
                        }
                        let _e1106 = phi_1996_;
                        if (_e1102 > _e1106) {
                            phi_2001_ = _e1102;
                        } else {
                            phi_2001_ = _e1106;
                        }
                        let _e1109 = phi_2001_;
                        if (_e934 < 0f) {
                            phi_2007_ = -(_e934);
                        } else {
                            phi_2007_ = _e934;
                        }
                        let _e1113 = phi_2007_;
                        if (_e1109 > _e1113) {
                            phi_2012_ = _e1109;
                        } else {
                            phi_2012_ = _e1113;
                        }
                        let _e1116 = phi_2012_;
                        let _e1117 = function_8(_e1116);
                        let _e1118 = (_e932 * _e1117);
                        let _e1119 = (_e933 * _e1117);
                        let _e1120 = (_e934 * _e1117);
                        let _e1125 = (((_e1118 * _e1118) + (_e1119 * _e1119)) + (_e1120 * _e1120));
                        if (_e1125 <= 0.000000000000000000000000000000000000011754944f) {
                            if (_e1125 > 0f) {
                                phi_2035_ = (0.000000000000000000106433627f * 2f);
                            } else {
                                phi_2035_ = 0f;
                            }
                            let _e1178 = phi_2035_;
                            phi_2099_ = _e1178;
                        } else {
                            phi_2042_ = type_14(0i, 5i);
                            phi_2045_ = bitcast<f32>(((bitcast<u32>(_e1125) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e1133 = phi_2042_;
                                let _e1135 = phi_2045_;
                                local_5 = _e1135;
                                if (_e1133.member < _e1133.member_1) {
                                    let _e1142 = (_e1133.member + 1i);
                                    if ((false == (_e1142 > _e1133.member)) != false) {
                                        phi_2066_ = true;
                                    } else {
                                        phi_2066_ = false;
                                    }
                                    let _e1147 = phi_2066_;
                                    if _e1147 {
                                        phi_2072_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_2072_ = type_15(1u, _e1142);
                                    }
                                    let _e1152 = phi_2072_;
                                    phi_2043_ = type_14(_e1152.member_1, _e1133.member_1);
                                    phi_2086_ = type_15(1u, _e1133.member);
                                } else {
                                    phi_2043_ = _e1133;
                                    phi_2086_ = type_15(0u, type_15().member_1);
                                }
                                let _e1158 = phi_2043_;
                                let _e1160 = phi_2086_;
                                let _e1163 = (bitcast<i32>(_e1160.member) != 0i);
                                if _e1163 {
                                    phi_2046_ = (0.5f * (_e1135 + (_e1125 / _e1135)));
                                } else {
                                    phi_2046_ = f32();
                                }
                                let _e1168 = phi_2046_;
                                continue;
                                continuing {
                                    phi_2042_ = _e1158;
                                    phi_2045_ = _e1168;
                                    break if !(_e1163);
                                }
                            }
                            let _e1173 = local_5;
                            phi_2099_ = (_e1173 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e1180 = phi_2099_;
                        let _e1181 = (1f / _e1180);
                        let _e1182 = (_e1118 * _e1181);
                        let _e1183 = (_e1119 * _e1181);
                        let _e1184 = (_e1120 * _e1181);
                        let _e1191 = ((3f - (((_e1182 * _e1182) + (_e1183 * _e1183)) + (_e1184 * _e1184))) * 0.5f);
                        let _e1192 = (_e1182 * _e1191);
                        let _e1193 = (_e1183 * _e1191);
                        let _e1194 = (_e1184 * _e1191);
                        let _e1200 = (((_e893 * _e1192) + (_e894 * _e1193)) + (_e895 * _e1194));
                        if (_e893 < 0f) {
                            phi_2125_ = -(_e893);
                        } else {
                            phi_2125_ = _e893;
                        }
                        let _e1204 = phi_2125_;
                        if (_e894 < 0f) {
                            phi_2131_ = -(_e894);
                        } else {
                            phi_2131_ = _e894;
                        }
                        let _e1208 = phi_2131_;
                        if (_e895 < 0f) {
                            phi_2138_ = -(_e895);
                        } else {
                            phi_2138_ = _e895;
                        }
                        let _e1213 = phi_2138_;
                        let _e1216 = local.member_5;
                        let _e1218 = local.member_4;
                        if (_e1200 < 0f) {
                            phi_2152_ = -(_e1200);
                        } else {
                            phi_2152_ = _e1200;
                        }
                        let _e1225 = phi_2152_;
                        if (_e1225 > (_e1098 + (((_e1204 + _e1208) + _e1213) * (_e1216 / _e1218)))) {
                            if (_e1200 < 0f) {
                                phi_2166_ = array<f32, 3>(_e1192, _e1193, _e1194);
                            } else {
                                let _e1228 = -(1f);
                                phi_2166_ = array<f32, 3>((_e1192 * _e1228), (_e1193 * _e1228), (_e1194 * _e1228));
                            }
                            let _e1234 = phi_2166_;
                            phi_2167_ = _e1234;
                            phi_2168_ = false;
                        } else {
                            phi_2167_ = array<f32, 3>();
                            phi_2168_ = true;
                        }
                        let _e1236 = phi_2167_;
                        let _e1238 = phi_2168_;
                        phi_2169_ = _e1236;
                        phi_2170_ = _e1238;
                    } else {
                        phi_2169_ = array<f32, 3>();
                        phi_2170_ = true;
                    }
                    let _e1240 = phi_2169_;
                    let _e1242 = phi_2170_;
                    if _e1242 {
                        if _e926 {
                            if _e923 {
                                phi_2180_ = false;
                            } else {
                                phi_2180_ = true;
                            }
                            let _e1244 = phi_2180_;
                            phi_2181_ = _e1244;
                        } else {
                            phi_2181_ = true;
                        }
                        let _e1246 = phi_2181_;
                        if _e1246 {
                            if _e907 {
                                if _e902 {
                                    if _e906 {
                                        let _e1248 = local.member_2;
                                        let _e1253 = local.member_1;
                                        phi_2216_ = array<f32, 3>((_e1248[0] - _e1253[0]), (_e1248[1] - _e1253[1]), (_e1248[2] - _e1253[2]));
                                        phi_2217_ = false;
                                    } else {
                                        phi_2216_ = array<f32, 3>();
                                        phi_2217_ = true;
                                    }
                                    let _e1262 = phi_2216_;
                                    let _e1264 = phi_2217_;
                                    phi_2218_ = _e1262;
                                    phi_2219_ = _e1264;
                                } else {
                                    phi_2218_ = array<f32, 3>();
                                    phi_2219_ = true;
                                }
                                let _e1266 = phi_2218_;
                                let _e1268 = phi_2219_;
                                phi_2220_ = _e1266;
                                phi_2221_ = _e1268;
                            } else {
                                phi_2220_ = array<f32, 3>();
                                phi_2221_ = true;
                            }
                            let _e1270 = phi_2220_;
                            let _e1272 = phi_2221_;
                            if _e1272 {
                                if _e902 {
                                    if _e906 {
                                        let _e1274 = local.member_2;
                                        if (_e1274[0] < 0f) {
                                            phi_2243_ = -(_e1274[0]);
                                        } else {
                                            phi_2243_ = _e1274[0];
                                        }
                                        let _e1281 = phi_2243_;
                                        if (_e1274[1] < 0f) {
                                            phi_2250_ = -(_e1274[1]);
                                        } else {
                                            phi_2250_ = _e1274[1];
                                        }
                                        let _e1285 = phi_2250_;
                                        if (_e1281 > _e1285) {
                                            phi_2255_ = _e1281;
                                        } else {
                                            phi_2255_ = _e1285;
                                        }
                                        let _e1288 = phi_2255_;
                                        if (_e1274[2] < 0f) {
                                            phi_2262_ = -(_e1274[2]);
                                        } else {
                                            phi_2262_ = _e1274[2];
                                        }
                                        let _e1292 = phi_2262_;
                                        if (_e1288 > _e1292) {
                                            phi_2267_ = _e1288;
                                        } else {
                                            phi_2267_ = _e1292;
                                        }
                                        let _e1295 = phi_2267_;
                                        let _e1297 = local.member_1;
                                        if (_e1297[0] < 0f) {
                                            phi_2280_ = -(_e1297[0]);
                                        } else {
                                            phi_2280_ = _e1297[0];
                                        }
                                        let _e1304 = phi_2280_;
                                        if (_e1297[1] < 0f) {
                                            phi_2287_ = -(_e1297[1]);
                                        } else {
                                            phi_2287_ = _e1297[1];
                                        }
                                        let _e1308 = phi_2287_;
                                        if (_e1304 > _e1308) {
                                            phi_2292_ = _e1304;
                                        } else {
                                            phi_2292_ = _e1308;
                                        }
                                        let _e1311 = phi_2292_;
                                        if (_e1297[2] < 0f) {
                                            phi_2299_ = -(_e1297[2]);
                                        } else {
                                            phi_2299_ = _e1297[2];
                                        }
                                        let _e1315 = phi_2299_;
                                        if (_e1311 > _e1315) {
                                            phi_2304_ = _e1311;
                                        } else {
                                            phi_2304_ = _e1315;
                                        }
                                        let _e1318 = phi_2304_;
                                        if (_e1295 > _e1318) {
                                            phi_2309_ = false;
                                        } else {
                                            phi_2309_ = true;
                                        }
                                        let _e1321 = phi_2309_;
                                        phi_2310_ = _e1321;
                                    } else {
                                        phi_2310_ = true;
                                    }
                                    let _e1323 = phi_2310_;
                                    if _e1323 {
                                        let _e1325 = local.member_1;
                                        phi_2320_ = array<f32, 3>(_e1325[0], _e1325[1], _e1325[2]);
                                        phi_2321_ = false;
                                    } else {
                                        phi_2320_ = array<f32, 3>();
                                        phi_2321_ = true;
                                    }
                                    let _e1331 = phi_2320_;
                                    let _e1333 = phi_2321_;
                                    phi_2322_ = _e1331;
                                    phi_2323_ = _e1333;
                                } else {
                                    phi_2322_ = array<f32, 3>();
                                    phi_2323_ = true;
                                }
                                let _e1335 = phi_2322_;
                                let _e1337 = phi_2323_;
                                if _e1337 {
                                    if _e906 {
                                        let _e1339 = local.member_2;
                                        phi_2337_ = array<f32, 3>(_e1339[0], _e1339[1], _e1339[2]);
                                    } else {
                                        phi_2337_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e1345 = phi_2337_;
                                    phi_2338_ = _e1345;
                                } else {
                                    phi_2338_ = _e1335;
                                }
                                let _e1347 = phi_2338_;
                                phi_2339_ = _e1347;
                            } else {
                                phi_2339_ = _e1270;
                            }
                            let _e1349 = phi_2339_;
                            if (_e1349[0] < 0f) {
                                phi_2346_ = -(_e1349[0]);
                            } else {
                                phi_2346_ = _e1349[0];
                            }
                            let _e1354 = phi_2346_;
                            if (_e1349[1] < 0f) {
                                phi_2353_ = -(_e1349[1]);
                            } else {
                                phi_2353_ = _e1349[1];
                            }
                            let _e1359 = phi_2353_;
                            if (_e1354 > _e1359) {
                                phi_2358_ = _e1354;
                            } else {
                                phi_2358_ = _e1359;
                            }
                            let _e1362 = phi_2358_;
                            if (_e1349[2] < 0f) {
                                phi_2365_ = -(_e1349[2]);
                            } else {
                                phi_2365_ = _e1349[2];
                            }
                            let _e1367 = phi_2365_;
                            if (_e1362 > _e1367) {
                                phi_2370_ = _e1362;
                            } else {
                                phi_2370_ = _e1367;
                            }
                            let _e1370 = phi_2370_;
                            if (_e1370 > 0f) {
                                if (_e1349[0] < 0f) {
                                    phi_2381_ = -(_e1349[0]);
                                } else {
                                    phi_2381_ = _e1349[0];
                                }
                                let _e1376 = phi_2381_;
                                if (_e1349[1] < 0f) {
                                    phi_2388_ = -(_e1349[1]);
                                } else {
                                    phi_2388_ = _e1349[1];
                                }
                                let _e1381 = phi_2388_;
                                if (_e1376 > _e1381) {
                                    phi_2393_ = _e1376;
                                } else {
                                    phi_2393_ = _e1381;
                                }
                                let _e1384 = phi_2393_;
                                if (_e1349[2] < 0f) {
                                    phi_2400_ = -(_e1349[2]);
                                } else {
                                    phi_2400_ = _e1349[2];
                                }
                                let _e1389 = phi_2400_;
                                if (_e1384 > _e1389) {
                                    phi_2405_ = _e1384;
                                } else {
                                    phi_2405_ = _e1389;
                                }
                                let _e1392 = phi_2405_;
                                let _e1393 = function_8(_e1392);
                                let _e1395 = (_e1349[0] * _e1393);
                                let _e1397 = (_e1349[1] * _e1393);
                                let _e1399 = (_e1349[2] * _e1393);
                                let _e1404 = (((_e1395 * _e1395) + (_e1397 * _e1397)) + (_e1399 * _e1399));
                                if (_e1404 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e1404 > 0f) {
                                        phi_2431_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_2431_ = 0f;
                                    }
                                    let _e1457 = phi_2431_;
                                    phi_2495_ = _e1457;
                                } else {
                                    phi_2438_ = type_14(0i, 5i);
                                    phi_2441_ = bitcast<f32>(((bitcast<u32>(_e1404) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1412 = phi_2438_;
                                        let _e1414 = phi_2441_;
                                        local_6 = _e1414;
                                        if (_e1412.member < _e1412.member_1) {
                                            let _e1421 = (_e1412.member + 1i);
                                            if ((false == (_e1421 > _e1412.member)) != false) {
                                                phi_2462_ = true;
                                            } else {
                                                phi_2462_ = false;
                                            }
                                            let _e1426 = phi_2462_;
                                            if _e1426 {
                                                phi_2468_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_2468_ = type_15(1u, _e1421);
                                            }
                                            let _e1431 = phi_2468_;
                                            phi_2439_ = type_14(_e1431.member_1, _e1412.member_1);
                                            phi_2482_ = type_15(1u, _e1412.member);
                                        } else {
                                            phi_2439_ = _e1412;
                                            phi_2482_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1437 = phi_2439_;
                                        let _e1439 = phi_2482_;
                                        let _e1442 = (bitcast<i32>(_e1439.member) != 0i);
                                        if _e1442 {
                                            phi_2442_ = (0.5f * (_e1414 + (_e1404 / _e1414)));
                                        } else {
                                            phi_2442_ = f32();
                                        }
                                        let _e1447 = phi_2442_;
                                        continue;
                                        continuing {
                                            phi_2438_ = _e1437;
                                            phi_2441_ = _e1447;
                                            break if !(_e1442);
                                        }
                                    }
                                    let _e1452 = local_6;
                                    phi_2495_ = (_e1452 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1459 = phi_2495_;
                                let _e1460 = (1f / _e1459);
                                let _e1461 = (_e1395 * _e1460);
                                let _e1462 = (_e1397 * _e1460);
                                let _e1463 = (_e1399 * _e1460);
                                let _e1470 = ((3f - (((_e1461 * _e1461) + (_e1462 * _e1462)) + (_e1463 * _e1463))) * 0.5f);
                                let _e1471 = (_e1461 * _e1470);
                                let _e1472 = (_e1462 * _e1470);
                                let _e1473 = (_e1463 * _e1470);
                                let _e1478 = (((_e893 * _e1471) + (_e894 * _e1472)) + (_e895 * _e1473));
                                phi_2522_ = array<f32, 3>((_e893 - (_e1471 * _e1478)), (_e894 - (_e1472 * _e1478)), (_e895 - (_e1473 * _e1478)));
                            } else {
                                phi_2522_ = array<f32, 3>(_e893, _e894, _e895);
                            }
                            let _e1487 = phi_2522_;
                            if (_e1487[0] < 0f) {
                                phi_2529_ = -(_e1487[0]);
                            } else {
                                phi_2529_ = _e1487[0];
                            }
                            let _e1492 = phi_2529_;
                            if (_e1487[1] < 0f) {
                                phi_2536_ = -(_e1487[1]);
                            } else {
                                phi_2536_ = _e1487[1];
                            }
                            let _e1497 = phi_2536_;
                            if (_e1487[2] < 0f) {
                                phi_2544_ = -(_e1487[2]);
                            } else {
                                phi_2544_ = _e1487[2];
                            }
                            let _e1503 = phi_2544_;
                            if (((_e1492 + _e1497) + _e1503) > _e1098) {
                                let _e1506 = -(1f);
                                let _e1508 = (_e1487[0] * _e1506);
                                let _e1510 = (_e1487[1] * _e1506);
                                let _e1512 = (_e1487[2] * _e1506);
                                if (_e1508 < 0f) {
                                    phi_2562_ = -(_e1508);
                                } else {
                                    phi_2562_ = _e1508;
                                }
                                let _e1516 = phi_2562_;
                                if (_e1510 < 0f) {
                                    phi_2568_ = -(_e1510);
                                } else {
                                    phi_2568_ = _e1510;
                                }
                                let _e1520 = phi_2568_;
                                if (_e1516 > _e1520) {
                                    phi_2573_ = _e1516;
                                } else {
                                    phi_2573_ = _e1520;
                                }
                                let _e1523 = phi_2573_;
                                if (_e1512 < 0f) {
                                    phi_2579_ = -(_e1512);
                                } else {
                                    phi_2579_ = _e1512;
                                }
                                let _e1527 = phi_2579_;
                                if (_e1523 > _e1527) {
                                    phi_2584_ = _e1523;
                                } else {
                                    phi_2584_ = _e1527;
                                }
                                let _e1530 = phi_2584_;
                                let _e1531 = function_8(_e1530);
                                let _e1532 = (_e1508 * _e1531);
                                let _e1533 = (_e1510 * _e1531);
                                let _e1534 = (_e1512 * _e1531);
                                let _e1539 = (((_e1532 * _e1532) + (_e1533 * _e1533)) + (_e1534 * _e1534));
                                if (_e1539 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e1539 > 0f) {
                                        phi_2607_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_2607_ = 0f;
                                    }
                                    let _e1592 = phi_2607_;
                                    phi_2671_ = _e1592;
                                } else {
                                    phi_2614_ = type_14(0i, 5i);
                                    phi_2617_ = bitcast<f32>(((bitcast<u32>(_e1539) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1547 = phi_2614_;
                                        let _e1549 = phi_2617_;
                                        local_7 = _e1549;
                                        if (_e1547.member < _e1547.member_1) {
                                            let _e1556 = (_e1547.member + 1i);
                                            if ((false == (_e1556 > _e1547.member)) != false) {
                                                phi_2638_ = true;
                                            } else {
                                                phi_2638_ = false;
                                            }
                                            let _e1561 = phi_2638_;
                                            if _e1561 {
                                                phi_2644_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_2644_ = type_15(1u, _e1556);
                                            }
                                            let _e1566 = phi_2644_;
                                            phi_2615_ = type_14(_e1566.member_1, _e1547.member_1);
                                            phi_2658_ = type_15(1u, _e1547.member);
                                        } else {
                                            phi_2615_ = _e1547;
                                            phi_2658_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1572 = phi_2615_;
                                        let _e1574 = phi_2658_;
                                        let _e1577 = (bitcast<i32>(_e1574.member) != 0i);
                                        if _e1577 {
                                            phi_2618_ = (0.5f * (_e1549 + (_e1539 / _e1549)));
                                        } else {
                                            phi_2618_ = f32();
                                        }
                                        let _e1582 = phi_2618_;
                                        continue;
                                        continuing {
                                            phi_2614_ = _e1572;
                                            phi_2617_ = _e1582;
                                            break if !(_e1577);
                                        }
                                    }
                                    let _e1587 = local_7;
                                    phi_2671_ = (_e1587 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1594 = phi_2671_;
                                let _e1595 = (1f / _e1594);
                                let _e1596 = (_e1532 * _e1595);
                                let _e1597 = (_e1533 * _e1595);
                                let _e1598 = (_e1534 * _e1595);
                                let _e1605 = ((3f - (((_e1596 * _e1596) + (_e1597 * _e1597)) + (_e1598 * _e1598))) * 0.5f);
                                phi_2687_ = array<f32, 3>((_e1596 * _e1605), (_e1597 * _e1605), (_e1598 * _e1605));
                                phi_2688_ = false;
                            } else {
                                phi_2687_ = array<f32, 3>();
                                phi_2688_ = true;
                            }
                            let _e1611 = phi_2687_;
                            let _e1613 = phi_2688_;
                            phi_2689_ = _e1611;
                            phi_2690_ = _e1613;
                        } else {
                            phi_2689_ = array<f32, 3>();
                            phi_2690_ = true;
                        }
                        let _e1615 = phi_2689_;
                        let _e1617 = phi_2690_;
                        if _e1617 {
                            if _e926 {
                                if (_e932 < 0f) {
                                    phi_2702_ = -(_e932);
                                } else {
                                    phi_2702_ = _e932;
                                }
                                let _e1940 = phi_2702_;
                                if (_e933 < 0f) {
                                    phi_2708_ = -(_e933);
                                } else {
                                    phi_2708_ = _e933;
                                }
                                let _e1944 = phi_2708_;
                                if (_e1940 > _e1944) {
                                    phi_2713_ = _e1940;
                                } else {
                                    phi_2713_ = _e1944;
                                }
                                let _e1947 = phi_2713_;
                                if (_e934 < 0f) {
                                    phi_2719_ = -(_e934);
                                } else {
                                    phi_2719_ = _e934;
                                }
                                let _e1951 = phi_2719_;
                                if (_e1947 > _e1951) {
                                    phi_2724_ = _e1947;
                                } else {
                                    phi_2724_ = _e1951;
                                }
                                let _e1954 = phi_2724_;
                                let _e1955 = function_8(_e1954);
                                let _e1956 = (_e932 * _e1955);
                                let _e1957 = (_e933 * _e1955);
                                let _e1958 = (_e934 * _e1955);
                                let _e1963 = (((_e1956 * _e1956) + (_e1957 * _e1957)) + (_e1958 * _e1958));
                                if (_e1963 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e1963 > 0f) {
                                        phi_2747_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_2747_ = 0f;
                                    }
                                    let _e2016 = phi_2747_;
                                    phi_2811_ = _e2016;
                                } else {
                                    phi_2754_ = type_14(0i, 5i);
                                    phi_2757_ = bitcast<f32>(((bitcast<u32>(_e1963) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1971 = phi_2754_;
                                        let _e1973 = phi_2757_;
                                        local_10 = _e1973;
                                        if (_e1971.member < _e1971.member_1) {
                                            let _e1980 = (_e1971.member + 1i);
                                            if ((false == (_e1980 > _e1971.member)) != false) {
                                                phi_2778_ = true;
                                            } else {
                                                phi_2778_ = false;
                                            }
                                            let _e1985 = phi_2778_;
                                            if _e1985 {
                                                phi_2784_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_2784_ = type_15(1u, _e1980);
                                            }
                                            let _e1990 = phi_2784_;
                                            phi_2755_ = type_14(_e1990.member_1, _e1971.member_1);
                                            phi_2798_ = type_15(1u, _e1971.member);
                                        } else {
                                            phi_2755_ = _e1971;
                                            phi_2798_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1996 = phi_2755_;
                                        let _e1998 = phi_2798_;
                                        let _e2001 = (bitcast<i32>(_e1998.member) != 0i);
                                        if _e2001 {
                                            phi_2758_ = (0.5f * (_e1973 + (_e1963 / _e1973)));
                                        } else {
                                            phi_2758_ = f32();
                                        }
                                        let _e2006 = phi_2758_;
                                        continue;
                                        continuing {
                                            phi_2754_ = _e1996;
                                            phi_2757_ = _e2006;
                                            break if !(_e2001);
                                        }
                                    }
                                    let _e2011 = local_10;
                                    phi_2811_ = (_e2011 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2018 = phi_2811_;
                                let _e2019 = (1f / _e2018);
                                let _e2020 = (_e1956 * _e2019);
                                let _e2021 = (_e1957 * _e2019);
                                let _e2022 = (_e1958 * _e2019);
                                let _e2029 = ((3f - (((_e2020 * _e2020) + (_e2021 * _e2021)) + (_e2022 * _e2022))) * 0.5f);
                                phi_3268_ = array<f32, 3>((_e2020 * _e2029), (_e2021 * _e2029), (_e2022 * _e2029));
                            } else {
                                let _e1619 = local.member_1;
                                let _e1625 = local.member_2;
                                if (_e1625[0] < 0f) {
                                    phi_2845_ = -(_e1625[0]);
                                } else {
                                    phi_2845_ = _e1625[0];
                                }
                                let _e1633 = phi_2845_;
                                if (_e1625[1] < 0f) {
                                    phi_2852_ = -(_e1625[1]);
                                } else {
                                    phi_2852_ = _e1625[1];
                                }
                                let _e1637 = phi_2852_;
                                if (_e1633 > _e1637) {
                                    phi_2857_ = _e1633;
                                } else {
                                    phi_2857_ = _e1637;
                                }
                                let _e1640 = phi_2857_;
                                if (_e1625[2] < 0f) {
                                    phi_2864_ = -(_e1625[2]);
                                } else {
                                    phi_2864_ = _e1625[2];
                                }
                                let _e1644 = phi_2864_;
                                if (_e1640 > _e1644) {
                                    phi_2869_ = _e1640;
                                } else {
                                    phi_2869_ = _e1644;
                                }
                                let _e1647 = phi_2869_;
                                if (_e1619[0] < 0f) {
                                    phi_2876_ = -(_e1619[0]);
                                } else {
                                    phi_2876_ = _e1619[0];
                                }
                                let _e1651 = phi_2876_;
                                if (_e1619[1] < 0f) {
                                    phi_2883_ = -(_e1619[1]);
                                } else {
                                    phi_2883_ = _e1619[1];
                                }
                                let _e1655 = phi_2883_;
                                if (_e1651 > _e1655) {
                                    phi_2888_ = _e1651;
                                } else {
                                    phi_2888_ = _e1655;
                                }
                                let _e1658 = phi_2888_;
                                if (_e1619[2] < 0f) {
                                    phi_2895_ = -(_e1619[2]);
                                } else {
                                    phi_2895_ = _e1619[2];
                                }
                                let _e1662 = phi_2895_;
                                if (_e1658 > _e1662) {
                                    phi_2900_ = _e1658;
                                } else {
                                    phi_2900_ = _e1662;
                                }
                                let _e1665 = phi_2900_;
                                if (_e1647 > _e1665) {
                                    phi_2905_ = array<f32, 3>(_e1625[0], _e1625[1], _e1625[2]);
                                } else {
                                    phi_2905_ = array<f32, 3>(_e1619[0], _e1619[1], _e1619[2]);
                                }
                                let _e1668 = phi_2905_;
                                if (_e1668[0] < 0f) {
                                    phi_2912_ = -(_e1668[0]);
                                } else {
                                    phi_2912_ = _e1668[0];
                                }
                                let _e1673 = phi_2912_;
                                if (_e1668[1] < 0f) {
                                    phi_2919_ = -(_e1668[1]);
                                } else {
                                    phi_2919_ = _e1668[1];
                                }
                                let _e1678 = phi_2919_;
                                if (_e1673 > _e1678) {
                                    phi_2924_ = _e1673;
                                } else {
                                    phi_2924_ = _e1678;
                                }
                                let _e1681 = phi_2924_;
                                if (_e1668[2] < 0f) {
                                    phi_2931_ = -(_e1668[2]);
                                } else {
                                    phi_2931_ = _e1668[2];
                                }
                                let _e1686 = phi_2931_;
                                if (_e1681 > _e1686) {
                                    phi_2936_ = _e1681;
                                } else {
                                    phi_2936_ = _e1686;
                                }
                                let _e1689 = phi_2936_;
                                if (_e1689 > 0f) {
                                    if (_e1668[0] < 0f) {
                                        phi_2947_ = -(_e1668[0]);
                                    } else {
                                        phi_2947_ = _e1668[0];
                                    }
                                    let _e1695 = phi_2947_;
                                    if (_e1668[1] < 0f) {
                                        phi_2954_ = -(_e1668[1]);
                                    } else {
                                        phi_2954_ = _e1668[1];
                                    }
                                    let _e1700 = phi_2954_;
                                    if (_e1668[2] < 0f) {
                                        phi_2961_ = -(_e1668[2]);
                                    } else {
                                        phi_2961_ = _e1668[2];
                                    }
                                    let _e1705 = phi_2961_;
                                    if (_e1695 <= _e1700) {
                                        if (_e1695 <= _e1705) {
                                            phi_2971_ = array<f32, 3>(1f, 0f, 0f);
                                            phi_2972_ = false;
                                        } else {
                                            phi_2971_ = array<f32, 3>();
                                            phi_2972_ = true;
                                        }
                                        let _e1709 = phi_2971_;
                                        let _e1711 = phi_2972_;
                                        phi_2973_ = _e1709;
                                        phi_2974_ = _e1711;
                                    } else {
                                        phi_2973_ = array<f32, 3>();
                                        phi_2974_ = true;
                                    }
                                    let _e1713 = phi_2973_;
                                    let _e1715 = phi_2974_;
                                    if _e1715 {
                                        if (_e1700 <= _e1705) {
                                            phi_2984_ = array<f32, 3>(0f, 1f, 0f);
                                        } else {
                                            phi_2984_ = array<f32, 3>(0f, 0f, 1f);
                                        }
                                        let _e1718 = phi_2984_;
                                        phi_2985_ = _e1718;
                                    } else {
                                        phi_2985_ = _e1713;
                                    }
                                    let _e1720 = phi_2985_;
                                    if (_e1668[0] < 0f) {
                                        phi_2992_ = -(_e1668[0]);
                                    } else {
                                        phi_2992_ = _e1668[0];
                                    }
                                    let _e1725 = phi_2992_;
                                    if (_e1668[1] < 0f) {
                                        phi_2999_ = -(_e1668[1]);
                                    } else {
                                        phi_2999_ = _e1668[1];
                                    }
                                    let _e1730 = phi_2999_;
                                    if (_e1725 > _e1730) {
                                        phi_3004_ = _e1725;
                                    } else {
                                        phi_3004_ = _e1730;
                                    }
                                    let _e1733 = phi_3004_;
                                    if (_e1668[2] < 0f) {
                                        phi_3011_ = -(_e1668[2]);
                                    } else {
                                        phi_3011_ = _e1668[2];
                                    }
                                    let _e1738 = phi_3011_;
                                    if (_e1733 > _e1738) {
                                        phi_3016_ = _e1733;
                                    } else {
                                        phi_3016_ = _e1738;
                                    }
                                    let _e1741 = phi_3016_;
                                    let _e1742 = function_8(_e1741);
                                    let _e1744 = (_e1668[0] * _e1742);
                                    let _e1746 = (_e1668[1] * _e1742);
                                    let _e1748 = (_e1668[2] * _e1742);
                                    let _e1753 = (((_e1744 * _e1744) + (_e1746 * _e1746)) + (_e1748 * _e1748));
                                    if (_e1753 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1753 > 0f) {
                                            phi_3042_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3042_ = 0f;
                                        }
                                        let _e1806 = phi_3042_;
                                        phi_3106_ = _e1806;
                                    } else {
                                        phi_3049_ = type_14(0i, 5i);
                                        phi_3052_ = bitcast<f32>(((bitcast<u32>(_e1753) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1761 = phi_3049_;
                                            let _e1763 = phi_3052_;
                                            local_8 = _e1763;
                                            if (_e1761.member < _e1761.member_1) {
                                                let _e1770 = (_e1761.member + 1i);
                                                if ((false == (_e1770 > _e1761.member)) != false) {
                                                    phi_3073_ = true;
                                                } else {
                                                    phi_3073_ = false;
                                                }
                                                let _e1775 = phi_3073_;
                                                if _e1775 {
                                                    phi_3079_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_3079_ = type_15(1u, _e1770);
                                                }
                                                let _e1780 = phi_3079_;
                                                phi_3050_ = type_14(_e1780.member_1, _e1761.member_1);
                                                phi_3093_ = type_15(1u, _e1761.member);
                                            } else {
                                                phi_3050_ = _e1761;
                                                phi_3093_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1786 = phi_3050_;
                                            let _e1788 = phi_3093_;
                                            let _e1791 = (bitcast<i32>(_e1788.member) != 0i);
                                            if _e1791 {
                                                phi_3053_ = (0.5f * (_e1763 + (_e1753 / _e1763)));
                                            } else {
                                                phi_3053_ = f32();
                                            }
                                            let _e1796 = phi_3053_;
                                            continue;
                                            continuing {
                                                phi_3049_ = _e1786;
                                                phi_3052_ = _e1796;
                                                break if !(_e1791);
                                            }
                                        }
                                        let _e1801 = local_8;
                                        phi_3106_ = (_e1801 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1808 = phi_3106_;
                                    let _e1809 = (1f / _e1808);
                                    let _e1810 = (_e1744 * _e1809);
                                    let _e1811 = (_e1746 * _e1809);
                                    let _e1812 = (_e1748 * _e1809);
                                    let _e1819 = ((3f - (((_e1810 * _e1810) + (_e1811 * _e1811)) + (_e1812 * _e1812))) * 0.5f);
                                    let _e1820 = (_e1810 * _e1819);
                                    let _e1821 = (_e1811 * _e1819);
                                    let _e1822 = (_e1812 * _e1819);
                                    let _e1827 = ((_e1821 * _e1720[2]) - (_e1822 * _e1720[1]));
                                    let _e1832 = ((_e1822 * _e1720[0]) - (_e1820 * _e1720[2]));
                                    let _e1837 = ((_e1820 * _e1720[1]) - (_e1821 * _e1720[0]));
                                    if (_e1827 < 0f) {
                                        phi_3141_ = -(_e1827);
                                    } else {
                                        phi_3141_ = _e1827;
                                    }
                                    let _e1841 = phi_3141_;
                                    if (_e1832 < 0f) {
                                        phi_3147_ = -(_e1832);
                                    } else {
                                        phi_3147_ = _e1832;
                                    }
                                    let _e1845 = phi_3147_;
                                    if (_e1841 > _e1845) {
                                        phi_3152_ = _e1841;
                                    } else {
                                        phi_3152_ = _e1845;
                                    }
                                    let _e1848 = phi_3152_;
                                    if (_e1837 < 0f) {
                                        phi_3158_ = -(_e1837);
                                    } else {
                                        phi_3158_ = _e1837;
                                    }
                                    let _e1852 = phi_3158_;
                                    if (_e1848 > _e1852) {
                                        phi_3163_ = _e1848;
                                    } else {
                                        phi_3163_ = _e1852;
                                    }
                                    let _e1855 = phi_3163_;
                                    let _e1856 = function_8(_e1855);
                                    let _e1857 = (_e1827 * _e1856);
                                    let _e1858 = (_e1832 * _e1856);
                                    let _e1859 = (_e1837 * _e1856);
                                    let _e1864 = (((_e1857 * _e1857) + (_e1858 * _e1858)) + (_e1859 * _e1859));
                                    if (_e1864 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1864 > 0f) {
                                            phi_3186_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3186_ = 0f;
                                        }
                                        let _e1917 = phi_3186_;
                                        phi_3250_ = _e1917;
                                    } else {
                                        phi_3193_ = type_14(0i, 5i);
                                        phi_3196_ = bitcast<f32>(((bitcast<u32>(_e1864) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1872 = phi_3193_;
                                            let _e1874 = phi_3196_;
                                            local_9 = _e1874;
                                            if (_e1872.member < _e1872.member_1) {
                                                let _e1881 = (_e1872.member + 1i);
                                                if ((false == (_e1881 > _e1872.member)) != false) {
                                                    phi_3217_ = true;
                                                } else {
                                                    phi_3217_ = false;
                                                }
                                                let _e1886 = phi_3217_;
                                                if _e1886 {
                                                    phi_3223_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_3223_ = type_15(1u, _e1881);
                                                }
                                                let _e1891 = phi_3223_;
                                                phi_3194_ = type_14(_e1891.member_1, _e1872.member_1);
                                                phi_3237_ = type_15(1u, _e1872.member);
                                            } else {
                                                phi_3194_ = _e1872;
                                                phi_3237_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1897 = phi_3194_;
                                            let _e1899 = phi_3237_;
                                            let _e1902 = (bitcast<i32>(_e1899.member) != 0i);
                                            if _e1902 {
                                                phi_3197_ = (0.5f * (_e1874 + (_e1864 / _e1874)));
                                            } else {
                                                phi_3197_ = f32();
                                            }
                                            let _e1907 = phi_3197_;
                                            continue;
                                            continuing {
                                                phi_3193_ = _e1897;
                                                phi_3196_ = _e1907;
                                                break if !(_e1902);
                                            }
                                        }
                                        let _e1912 = local_9;
                                        phi_3250_ = (_e1912 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1919 = phi_3250_;
                                    let _e1920 = (1f / _e1919);
                                    let _e1921 = (_e1857 * _e1920);
                                    let _e1922 = (_e1858 * _e1920);
                                    let _e1923 = (_e1859 * _e1920);
                                    let _e1930 = ((3f - (((_e1921 * _e1921) + (_e1922 * _e1922)) + (_e1923 * _e1923))) * 0.5f);
                                    phi_3267_ = array<f32, 3>((_e1921 * _e1930), (_e1922 * _e1930), (_e1923 * _e1930));
                                } else {
                                    phi_3267_ = array<f32, 3>(1f, 0f, 0f);
                                }
                                let _e1936 = phi_3267_;
                                phi_3268_ = _e1936;
                            }
                            let _e2035 = phi_3268_;
                            phi_3269_ = _e2035;
                            phi_3270_ = false;
                        } else {
                            phi_3269_ = array<f32, 3>();
                            phi_3270_ = true;
                        }
                        let _e2037 = phi_3269_;
                        let _e2039 = phi_3270_;
                        phi_3271_ = _e2037;
                        phi_3272_ = _e1615;
                        phi_3273_ = _e2039;
                    } else {
                        phi_3271_ = array<f32, 3>();
                        phi_3272_ = _e1240;
                        phi_3273_ = true;
                    }
                    let _e2041 = phi_3271_;
                    let _e2043 = phi_3272_;
                    let _e2045 = phi_3273_;
                    phi_3277_ = _e2043;
                    phi_3278_ = _e2041;
                    phi_3279_ = _e2045;
                }
                let _e2290 = phi_3277_;
                let _e2292 = phi_3278_;
                let _e2294 = phi_3279_;
                if _e2294 {
                    phi_3283_ = _e2290;
                } else {
                    phi_3283_ = _e2292;
                }
                let _e2296 = phi_3283_;
                if ((((_e2296[0] * _e2296[0]) + (_e2296[1] * _e2296[1])) + (_e2296[2] * _e2296[2])) > 0.5f) {
                    phi_3300_ = _e2296;
                } else {
                    phi_3300_ = array<f32, 3>(1f, 0f, 0f);
                }
                let _e2310 = phi_3300_;
                let _e2313 = function_9(_e246[0], _e247[0], _e241);
                let _e2316 = function_9(_e246[1], _e247[1], _e241);
                let _e2319 = function_9(_e246[2], _e247[2], _e241);
                let _e2322 = function_9(_e246[3], _e247[3], _e241);
                if (_e162.member != 0u) {
                    let _e2359 = function_9(_e2313, _e2316, _e797.member);
                    let _e2360 = function_9(_e2319, _e2322, _e797.member_1);
                    phi_3356_ = _e2360;
                    phi_3357_ = _e2359;
                    phi_3358_ = array<f32, 4>((1f - _e797.member), _e797.member, (1f - _e797.member_1), _e797.member_1);
                } else {
                    let _e2325 = ((1f - _e797.member) - _e797.member_1);
                    if (_e2325 > 0f) {
                        phi_3328_ = _e2325;
                    } else {
                        phi_3328_ = 0f;
                    }
                    let _e2328 = phi_3328_;
                    let _e2355 = function_(array<f32, 4>(1f, _e2328, _e797.member, _e797.member_1), _e245);
                    phi_3356_ = array<f32, 3>((((_e2316[0] * _e2328) + (_e2319[0] * _e797.member)) + (_e2322[0] * _e797.member_1)), (((_e2316[1] * _e2328) + (_e2319[1] * _e797.member)) + (_e2322[1] * _e797.member_1)), (((_e2316[2] * _e2328) + (_e2319[2] * _e797.member)) + (_e2322[2] * _e797.member_1)));
                    phi_3357_ = _e2313;
                    phi_3358_ = _e2355;
                }
                let _e2362 = phi_3356_;
                let _e2364 = phi_3357_;
                let _e2366 = phi_3358_;
                let _e2367 = function_9(_e2364, _e2362, 0.5f);
                let _e2371 = params.member.member_2.member;
                let _e2374 = params.member.member_2.member_1;
                geometry.member[_e122] = type_34(array<f32, 3>(((_e2367[0] * _e2374) + _e2371[0]), ((_e2367[1] * _e2374) + _e2371[1]), ((_e2367[2] * _e2374) + _e2371[2])), ((_e861 / _e489) * _e2374), _e2310, _e130, _e2366, _e162.member_1);
            }
        }
        continue;
        continuing {
            phi_226_ = _e112;
            break if !(_e118);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn contact_geometry(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_12(id, n, lane);
}
