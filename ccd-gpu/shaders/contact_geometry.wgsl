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
    var phi_4377_: array<f32, 4>;

    switch bitcast<i32>(param_1) {
        case 0: {
            phi_4377_ = param;
            break;
        }
        case 1: {
            phi_4377_ = array<f32, 4>(param[0], param[3], param[1], param[2]);
            break;
        }
        default: {
            phi_4377_ = array<f32, 4>(param[0], param[2], param[3], param[1]);
            break;
        }
    }
    let _e14 = phi_4377_;
    return _e14;
}

fn function_1(param_2: array<array<f32, 3>, 2>) -> array<f32, 3> {
    return array<f32, 3>((param_2[1][0] - param_2[0][0]), (param_2[1][1] - param_2[0][1]), (param_2[1][2] - param_2[0][2]));
}

fn function_2(param_3: type_38, param_4: type_38) -> type_38 {
    var phi_4345_: type_38;

    if (param_4.member_3 < param_3.member_3) {
        phi_4345_ = param_4;
    } else {
        phi_4345_ = param_3;
    }
    let _e6 = phi_4345_;
    return _e6;
}

fn function_3(param_5: f32, param_6: f32) -> f32 {
    var phi_3420_: f32;
    var phi_3425_: f32;
    var phi_3426_: f32;

    if (param_5 > 0f) {
        if (param_5 < param_6) {
            phi_3420_ = param_5;
        } else {
            phi_3420_ = param_6;
        }
        let _e6 = phi_3420_;
        if (_e6 > 0f) {
            phi_3425_ = _e6;
        } else {
            phi_3425_ = 0f;
        }
        let _e9 = phi_3425_;
        phi_3426_ = _e9;
    } else {
        phi_3426_ = 0f;
    }
    let _e11 = phi_3426_;
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
    var phi_4044_: f32;
    var phi_4051_: f32;
    var phi_4062_: type_38;
    var phi_4063_: bool;
    var phi_4064_: type_38;
    var phi_4065_: bool;
    var phi_3921_: bool;
    var phi_3922_: bool;
    var phi_3938_: f32;
    var phi_3944_: f32;
    var phi_3947_: type_38;
    var phi_3948_: bool;
    var phi_3949_: type_38;
    var phi_3950_: bool;
    var phi_3951_: type_38;
    var phi_3952_: bool;
    var phi_4069_: type_38;
    var phi_4070_: bool;
    var phi_4145_: type_38;
    var phi_4146_: type_38;
    var phi_4147_: bool;
    var phi_4151_: type_38;

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
            phi_3922_ = ((_e133 + _e163) <= 1f);
        } else {
            if (_e133 <= 1f) {
                phi_3921_ = (_e163 <= 1f);
            } else {
                phi_3921_ = false;
            }
            let _e167 = phi_3921_;
            phi_3922_ = _e167;
        }
        let _e171 = phi_3922_;
        if (_e133 >= 0f) {
            if (_e163 >= 0f) {
                if _e171 {
                    if _e9 {
                        phi_3938_ = (1f - _e133);
                    } else {
                        phi_3938_ = 1f;
                    }
                    let _e176 = phi_3938_;
                    let _e177 = function_6(param_16, _e133, _e176);
                    if _e9 {
                        phi_3944_ = (1f - _e177);
                    } else {
                        phi_3944_ = 1f;
                    }
                    let _e180 = phi_3944_;
                    let _e181 = function_4(param_16, _e177, _e180);
                    let _e182 = function_5(param_16, _e181, _e177);
                    phi_3947_ = _e182;
                    phi_3948_ = false;
                } else {
                    phi_3947_ = type_38();
                    phi_3948_ = true;
                }
                let _e184 = phi_3947_;
                let _e186 = phi_3948_;
                phi_3949_ = _e184;
                phi_3950_ = _e186;
            } else {
                phi_3949_ = type_38();
                phi_3950_ = true;
            }
            let _e188 = phi_3949_;
            let _e190 = phi_3950_;
            phi_3951_ = _e188;
            phi_3952_ = _e190;
        } else {
            phi_3951_ = type_38();
            phi_3952_ = true;
        }
        let _e192 = phi_3951_;
        let _e194 = phi_3952_;
        phi_4069_ = _e192;
        phi_4070_ = _e194;
    } else {
        if _e9 {
            phi_4064_ = type_38();
            phi_4065_ = true;
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
                phi_4044_ = _e27;
            } else {
                phi_4044_ = _e50;
            }
            let _e68 = phi_4044_;
            let _e70 = function_3((_e68 / _e65), 1f);
            if (_e27 > _e50) {
                phi_4051_ = _e27;
            } else {
                phi_4051_ = _e50;
            }
            let _e73 = phi_4051_;
            let _e75 = function_3((_e73 / _e65), 1f);
            if (_e70 < _e75) {
                let _e78 = ((_e70 + _e75) * 0.5f);
                let _e79 = function_6(param_16, _e78, 1f);
                let _e80 = function_5(param_16, _e78, _e79);
                phi_4062_ = _e80;
                phi_4063_ = false;
            } else {
                phi_4062_ = type_38();
                phi_4063_ = true;
            }
            let _e82 = phi_4062_;
            let _e84 = phi_4063_;
            phi_4064_ = _e82;
            phi_4065_ = _e84;
        }
        let _e86 = phi_4064_;
        let _e88 = phi_4065_;
        phi_4069_ = _e86;
        phi_4070_ = _e88;
    }
    let _e196 = phi_4069_;
    let _e198 = phi_4070_;
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
            phi_4145_ = _e250;
        } else {
            let _e204 = function_6(param_16, 1f, 1f);
            let _e205 = function_5(param_16, 1f, _e204);
            let _e206 = function_4(param_16, 1f, 1f);
            let _e207 = function_5(param_16, _e206, 1f);
            let _e208 = function_2(_e205, _e207);
            let _e209 = function_2(_e203, _e208);
            phi_4145_ = _e209;
        }
        let _e252 = phi_4145_;
        phi_4146_ = _e252;
        phi_4147_ = false;
    } else {
        phi_4146_ = type_38();
        phi_4147_ = true;
    }
    let _e254 = phi_4146_;
    let _e256 = phi_4147_;
    if _e256 {
        phi_4151_ = _e196;
    } else {
        phi_4151_ = _e254;
    }
    let _e258 = phi_4151_;
    return _e258;
}

fn function_8(param_18: f32) -> f32 {
    var phi_3777_: u32;
    var phi_3780_: f32;
    var phi_3781_: f32;

    if ((bitcast<u32>(param_18) & 2139095040u) != 2139095040u) {
        if (param_18 >= 0.000000000000000000000000000000000000011754944f) {
            let _e13 = (2130706432u - (bitcast<u32>(param_18) & 2139095040u));
            if (_e13 > 8388608u) {
                phi_3777_ = _e13;
            } else {
                phi_3777_ = 8388608u;
            }
            let _e16 = phi_3777_;
            phi_3780_ = bitcast<f32>(_e16);
        } else {
            phi_3780_ = (1f / 0.000000000000000000000000000000000000011754944f);
        }
        let _e19 = phi_3780_;
        phi_3781_ = _e19;
    } else {
        phi_3781_ = 1f;
    }
    let _e21 = phi_3781_;
    return _e21;
}

fn function_9(param_19: array<f32, 3>, param_20: array<f32, 3>, param_21: f32) -> array<f32, 3> {
    let _e4 = (1f - param_21);
    return array<f32, 3>(((param_19[0] * _e4) + (param_20[0] * param_21)), ((param_19[1] * _e4) + (param_20[1] * param_21)), ((param_19[2] * _e4) + (param_20[2] * param_21)));
}

fn function_10(param_22: ptr<function, array<array<f32, 3>, 4>>, param_23: u32) -> array<array<f32, 3>, 4> {
    var phi_3754_: array<array<f32, 3>, 4>;

    switch bitcast<i32>(param_23) {
        case 0: {
            let _e32 = (*param_22);
            phi_3754_ = array<array<f32, 3>, 4>(array<f32, 3>(_e32[0][0], _e32[0][1], _e32[0][2]), array<f32, 3>(_e32[1][0], _e32[1][1], _e32[1][2]), array<f32, 3>(_e32[2][0], _e32[2][1], _e32[2][2]), array<f32, 3>(_e32[3][0], _e32[3][1], _e32[3][2]));
            break;
        }
        case 1: {
            let _e8 = (*param_22)[0u];
            let _e14 = (*param_22)[2u];
            let _e20 = (*param_22)[3u];
            let _e26 = (*param_22)[1u];
            phi_3754_ = array<array<f32, 3>, 4>(array<f32, 3>(_e8[0], _e8[1], _e8[2]), array<f32, 3>(_e14[0], _e14[1], _e14[2]), array<f32, 3>(_e20[0], _e20[1], _e20[2]), array<f32, 3>(_e26[0], _e26[1], _e26[2]));
            break;
        }
        default: {
            let _e55 = (*param_22)[0u];
            let _e61 = (*param_22)[3u];
            let _e67 = (*param_22)[1u];
            let _e73 = (*param_22)[2u];
            phi_3754_ = array<array<f32, 3>, 4>(array<f32, 3>(_e55[0], _e55[1], _e55[2]), array<f32, 3>(_e61[0], _e61[1], _e61[2]), array<f32, 3>(_e67[0], _e67[1], _e67[2]), array<f32, 3>(_e73[0], _e73[1], _e73[2]));
            break;
        }
    }
    let _e80 = phi_3754_;
    return _e80;
}

fn function_11(param_24: ptr<function, array<array<f32, 3>, 4>>, param_25: ptr<function, array<array<f32, 3>, 4>>, param_26: f32) -> u32 {
    var phi_3482_: f32;
    var phi_3489_: f32;
    var phi_3497_: f32;
    var phi_3550_: f32;
    var phi_3557_: f32;
    var phi_3565_: f32;
    var phi_3618_: f32;
    var phi_3625_: f32;
    var phi_3633_: f32;
    var phi_3643_: bool;
    var phi_3644_: bool;
    var phi_3652_: u32;
    var phi_3653_: u32;

    let _e11 = (*param_24)[3u];
    let _e16 = (*param_24)[2u];
    let _e25 = (*param_25)[3u];
    let _e30 = (*param_25)[2u];
    let _e38 = function_9(array<f32, 3>((_e11[0] - _e16[0]), (_e11[1] - _e16[1]), (_e11[2] - _e16[2])), array<f32, 3>((_e25[0] - _e30[0]), (_e25[1] - _e30[1]), (_e25[2] - _e30[2])), param_26);
    if (_e38[0] < 0f) {
        phi_3482_ = -(_e38[0]);
    } else {
        phi_3482_ = _e38[0];
    }
    let _e43 = phi_3482_;
    if (_e38[1] < 0f) {
        phi_3489_ = -(_e38[1]);
    } else {
        phi_3489_ = _e38[1];
    }
    let _e48 = phi_3489_;
    if (_e38[2] < 0f) {
        phi_3497_ = -(_e38[2]);
    } else {
        phi_3497_ = _e38[2];
    }
    let _e54 = phi_3497_;
    let _e55 = ((_e43 + _e48) + _e54);
    let _e57 = (*param_24)[1u];
    let _e62 = (*param_24)[3u];
    let _e71 = (*param_25)[1u];
    let _e76 = (*param_25)[3u];
    let _e84 = function_9(array<f32, 3>((_e57[0] - _e62[0]), (_e57[1] - _e62[1]), (_e57[2] - _e62[2])), array<f32, 3>((_e71[0] - _e76[0]), (_e71[1] - _e76[1]), (_e71[2] - _e76[2])), param_26);
    if (_e84[0] < 0f) {
        phi_3550_ = -(_e84[0]);
    } else {
        phi_3550_ = _e84[0];
    }
    let _e89 = phi_3550_;
    if (_e84[1] < 0f) {
        phi_3557_ = -(_e84[1]);
    } else {
        phi_3557_ = _e84[1];
    }
    let _e94 = phi_3557_;
    if (_e84[2] < 0f) {
        phi_3565_ = -(_e84[2]);
    } else {
        phi_3565_ = _e84[2];
    }
    let _e100 = phi_3565_;
    let _e101 = ((_e89 + _e94) + _e100);
    let _e103 = (*param_24)[2u];
    let _e108 = (*param_24)[1u];
    let _e117 = (*param_25)[2u];
    let _e122 = (*param_25)[1u];
    let _e130 = function_9(array<f32, 3>((_e103[0] - _e108[0]), (_e103[1] - _e108[1]), (_e103[2] - _e108[2])), array<f32, 3>((_e117[0] - _e122[0]), (_e117[1] - _e122[1]), (_e117[2] - _e122[2])), param_26);
    if (_e130[0] < 0f) {
        phi_3618_ = -(_e130[0]);
    } else {
        phi_3618_ = _e130[0];
    }
    let _e135 = phi_3618_;
    if (_e130[1] < 0f) {
        phi_3625_ = -(_e130[1]);
    } else {
        phi_3625_ = _e130[1];
    }
    let _e140 = phi_3625_;
    if (_e130[2] < 0f) {
        phi_3633_ = -(_e130[2]);
    } else {
        phi_3633_ = _e130[2];
    }
    let _e146 = phi_3633_;
    let _e147 = ((_e135 + _e140) + _e146);
    if (_e55 >= _e101) {
        if (_e55 >= _e147) {
            phi_3643_ = false;
        } else {
            phi_3643_ = true;
        }
        let _e151 = phi_3643_;
        phi_3644_ = _e151;
    } else {
        phi_3644_ = true;
    }
    let _e153 = phi_3644_;
    if _e153 {
        if (_e101 >= _e147) {
            phi_3652_ = 1u;
        } else {
            phi_3652_ = 2u;
        }
        let _e156 = phi_3652_;
        phi_3653_ = _e156;
    } else {
        phi_3653_ = 0u;
    }
    let _e158 = phi_3653_;
    return _e158;
}

fn function_12(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_27;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var phi_185_: u32;
    var phi_195_: u32;
    var phi_202_: u32;
    var phi_218_: u32;
    var phi_239_: u32;
    var phi_240_: u32;
    var phi_243_: type_12;
    var phi_244_: type_12;
    var phi_267_: type_12;
    var phi_410_: type_37;
    var phi_553_: u32;
    var phi_559_: f32;
    var phi_568_: u32;
    var phi_729_: type_24;
    var phi_745_: f32;
    var phi_752_: f32;
    var phi_757_: f32;
    var phi_764_: f32;
    var phi_769_: f32;
    var phi_776_: f32;
    var phi_783_: f32;
    var phi_788_: f32;
    var phi_795_: f32;
    var phi_800_: f32;
    var phi_805_: f32;
    var phi_812_: f32;
    var phi_819_: f32;
    var phi_824_: f32;
    var phi_831_: f32;
    var phi_836_: f32;
    var phi_841_: f32;
    var phi_871_: f32;
    var phi_878_: f32;
    var phi_883_: f32;
    var phi_890_: f32;
    var phi_895_: f32;
    var phi_903_: f32;
    var phi_910_: f32;
    var phi_915_: f32;
    var phi_922_: f32;
    var phi_927_: f32;
    var phi_932_: f32;
    var phi_942_: f32;
    var phi_949_: f32;
    var phi_954_: f32;
    var phi_961_: f32;
    var phi_966_: f32;
    var phi_974_: f32;
    var phi_981_: f32;
    var phi_986_: f32;
    var phi_993_: f32;
    var phi_998_: f32;
    var phi_1003_: f32;
    var phi_1013_: f32;
    var phi_1020_: f32;
    var phi_1025_: f32;
    var phi_1032_: f32;
    var phi_1037_: f32;
    var phi_1045_: f32;
    var phi_1052_: f32;
    var phi_1057_: f32;
    var phi_1064_: f32;
    var phi_1069_: f32;
    var phi_1074_: f32;
    var phi_1107_: f32;
    var phi_1113_: f32;
    var phi_1118_: f32;
    var phi_1124_: f32;
    var phi_1129_: f32;
    var phi_1137_: f32;
    var phi_1143_: f32;
    var phi_1148_: f32;
    var phi_1154_: f32;
    var phi_1159_: f32;
    var phi_1187_: type_14;
    var phi_1190_: f32;
    var phi_1211_: bool;
    var phi_1217_: type_15;
    var phi_1188_: type_14;
    var phi_1231_: type_15;
    var phi_1191_: f32;
    var local_3: f32;
    var phi_1180_: f32;
    var phi_1244_: f32;
    var phi_1252_: f32;
    var phi_1257_: f32;
    var phi_1307_: type_14;
    var phi_1310_: f32;
    var phi_1331_: bool;
    var phi_1337_: type_15;
    var phi_1308_: type_14;
    var phi_1351_: type_15;
    var phi_1311_: f32;
    var local_4: f32;
    var phi_1300_: f32;
    var phi_1364_: f32;
    var phi_1372_: f32;
    var phi_1378_: f32;
    var phi_1417_: bool;
    var phi_1423_: bool;
    var phi_1438_: bool;
    var phi_1439_: bool;
    var phi_1440_: bool;
    var phi_1441_: bool;
    var phi_1442_: bool;
    var phi_1446_: bool;
    var phi_1792_: f32;
    var phi_1799_: f32;
    var phi_1804_: f32;
    var phi_1811_: f32;
    var phi_1816_: f32;
    var phi_1824_: f32;
    var phi_1831_: f32;
    var phi_1836_: f32;
    var phi_1843_: f32;
    var phi_1848_: f32;
    var phi_1853_: f32;
    var phi_1863_: f32;
    var phi_1870_: f32;
    var phi_1875_: f32;
    var phi_1882_: f32;
    var phi_1887_: f32;
    var phi_1895_: f32;
    var phi_1902_: f32;
    var phi_1907_: f32;
    var phi_1914_: f32;
    var phi_1919_: f32;
    var phi_1924_: f32;
    var phi_1934_: f32;
    var phi_1941_: f32;
    var phi_1946_: f32;
    var phi_1953_: f32;
    var phi_1958_: f32;
    var phi_1966_: f32;
    var phi_1973_: f32;
    var phi_1978_: f32;
    var phi_1985_: f32;
    var phi_1990_: f32;
    var phi_1995_: f32;
    var phi_2015_: f32;
    var phi_2021_: f32;
    var phi_2026_: f32;
    var phi_2032_: f32;
    var phi_2037_: f32;
    var phi_2067_: type_14;
    var phi_2070_: f32;
    var phi_2091_: bool;
    var phi_2097_: type_15;
    var phi_2068_: type_14;
    var phi_2111_: type_15;
    var phi_2071_: f32;
    var local_5: f32;
    var phi_2060_: f32;
    var phi_2124_: f32;
    var phi_2150_: f32;
    var phi_2156_: f32;
    var phi_2163_: f32;
    var phi_2177_: f32;
    var phi_2191_: array<f32, 3>;
    var phi_2192_: array<f32, 3>;
    var phi_2193_: bool;
    var phi_2194_: array<f32, 3>;
    var phi_2195_: bool;
    var phi_2205_: bool;
    var phi_2206_: bool;
    var phi_2241_: array<f32, 3>;
    var phi_2242_: bool;
    var phi_2243_: array<f32, 3>;
    var phi_2244_: bool;
    var phi_2245_: array<f32, 3>;
    var phi_2246_: bool;
    var phi_2268_: f32;
    var phi_2275_: f32;
    var phi_2280_: f32;
    var phi_2287_: f32;
    var phi_2292_: f32;
    var phi_2305_: f32;
    var phi_2312_: f32;
    var phi_2317_: f32;
    var phi_2324_: f32;
    var phi_2329_: f32;
    var phi_2334_: bool;
    var phi_2335_: bool;
    var phi_2345_: array<f32, 3>;
    var phi_2346_: bool;
    var phi_2347_: array<f32, 3>;
    var phi_2348_: bool;
    var phi_2362_: array<f32, 3>;
    var phi_2363_: array<f32, 3>;
    var phi_2364_: array<f32, 3>;
    var phi_2371_: f32;
    var phi_2378_: f32;
    var phi_2383_: f32;
    var phi_2390_: f32;
    var phi_2395_: f32;
    var phi_2406_: f32;
    var phi_2413_: f32;
    var phi_2418_: f32;
    var phi_2425_: f32;
    var phi_2430_: f32;
    var phi_2463_: type_14;
    var phi_2466_: f32;
    var phi_2487_: bool;
    var phi_2493_: type_15;
    var phi_2464_: type_14;
    var phi_2507_: type_15;
    var phi_2467_: f32;
    var local_6: f32;
    var phi_2456_: f32;
    var phi_2520_: f32;
    var phi_2547_: array<f32, 3>;
    var phi_2554_: f32;
    var phi_2561_: f32;
    var phi_2569_: f32;
    var phi_2587_: f32;
    var phi_2593_: f32;
    var phi_2598_: f32;
    var phi_2604_: f32;
    var phi_2609_: f32;
    var phi_2639_: type_14;
    var phi_2642_: f32;
    var phi_2663_: bool;
    var phi_2669_: type_15;
    var phi_2640_: type_14;
    var phi_2683_: type_15;
    var phi_2643_: f32;
    var local_7: f32;
    var phi_2632_: f32;
    var phi_2696_: f32;
    var phi_2712_: array<f32, 3>;
    var phi_2713_: bool;
    var phi_2714_: array<f32, 3>;
    var phi_2715_: bool;
    var phi_2870_: f32;
    var phi_2877_: f32;
    var phi_2882_: f32;
    var phi_2889_: f32;
    var phi_2894_: f32;
    var phi_2901_: f32;
    var phi_2908_: f32;
    var phi_2913_: f32;
    var phi_2920_: f32;
    var phi_2925_: f32;
    var phi_2930_: array<f32, 3>;
    var phi_2937_: f32;
    var phi_2944_: f32;
    var phi_2949_: f32;
    var phi_2956_: f32;
    var phi_2961_: f32;
    var phi_2972_: f32;
    var phi_2979_: f32;
    var phi_2986_: f32;
    var phi_2996_: array<f32, 3>;
    var phi_2997_: bool;
    var phi_2998_: array<f32, 3>;
    var phi_2999_: bool;
    var phi_3009_: array<f32, 3>;
    var phi_3010_: array<f32, 3>;
    var phi_3017_: f32;
    var phi_3024_: f32;
    var phi_3029_: f32;
    var phi_3036_: f32;
    var phi_3041_: f32;
    var phi_3074_: type_14;
    var phi_3077_: f32;
    var phi_3098_: bool;
    var phi_3104_: type_15;
    var phi_3075_: type_14;
    var phi_3118_: type_15;
    var phi_3078_: f32;
    var local_8: f32;
    var phi_3067_: f32;
    var phi_3131_: f32;
    var phi_3166_: f32;
    var phi_3172_: f32;
    var phi_3177_: f32;
    var phi_3183_: f32;
    var phi_3188_: f32;
    var phi_3218_: type_14;
    var phi_3221_: f32;
    var phi_3242_: bool;
    var phi_3248_: type_15;
    var phi_3219_: type_14;
    var phi_3262_: type_15;
    var phi_3222_: f32;
    var local_9: f32;
    var phi_3211_: f32;
    var phi_3275_: f32;
    var phi_3292_: array<f32, 3>;
    var phi_2727_: f32;
    var phi_2733_: f32;
    var phi_2738_: f32;
    var phi_2744_: f32;
    var phi_2749_: f32;
    var phi_2779_: type_14;
    var phi_2782_: f32;
    var phi_2803_: bool;
    var phi_2809_: type_15;
    var phi_2780_: type_14;
    var phi_2823_: type_15;
    var phi_2783_: f32;
    var local_10: f32;
    var phi_2772_: f32;
    var phi_2836_: f32;
    var phi_3293_: array<f32, 3>;
    var phi_3294_: array<f32, 3>;
    var phi_3295_: bool;
    var phi_3296_: array<f32, 3>;
    var phi_3297_: array<f32, 3>;
    var phi_3298_: bool;
    var phi_1508_: array<f32, 3>;
    var phi_1515_: f32;
    var phi_1522_: f32;
    var phi_1527_: f32;
    var phi_1534_: f32;
    var phi_1539_: f32;
    var phi_1572_: type_14;
    var phi_1575_: f32;
    var phi_1596_: bool;
    var phi_1602_: type_15;
    var phi_1573_: type_14;
    var phi_1616_: type_15;
    var phi_1576_: f32;
    var local_11: f32;
    var phi_1565_: f32;
    var phi_1629_: f32;
    var phi_1645_: array<f32, 3>;
    var phi_1646_: bool;
    var phi_1647_: array<f32, 3>;
    var phi_1648_: bool;
    var phi_1649_: array<f32, 3>;
    var phi_1650_: bool;
    var phi_1659_: f32;
    var phi_1665_: f32;
    var phi_1670_: f32;
    var phi_1676_: f32;
    var phi_1681_: f32;
    var phi_1711_: type_14;
    var phi_1714_: f32;
    var phi_1735_: bool;
    var phi_1741_: type_15;
    var phi_1712_: type_14;
    var phi_1755_: type_15;
    var phi_1715_: f32;
    var local_12: f32;
    var phi_1704_: f32;
    var phi_1768_: f32;
    var phi_1784_: array<f32, 3>;
    var phi_3302_: array<f32, 3>;
    var phi_3303_: array<f32, 3>;
    var phi_3304_: bool;
    var phi_3308_: array<f32, 3>;
    var phi_3325_: array<f32, 3>;
    var phi_3353_: f32;
    var phi_3381_: array<f32, 3>;
    var phi_3382_: array<f32, 3>;
    var phi_3383_: array<f32, 4>;
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
    let _e81 = params.member.member_1.member_1;
    if (_e79 > _e81) {
        let _e84 = params.member.member_1.member_1;
        phi_195_ = (_e79 - _e84);
    } else {
        phi_195_ = 0u;
    }
    let _e87 = phi_195_;
    let _e89 = params.member.member_1.member;
    if (_e89 < _e87) {
        phi_202_ = _e89;
    } else {
        phi_202_ = _e87;
    }
    let _e92 = phi_202_;
    let _e93 = (_e92 / 64u);
    if ((_e92 % 64u) > 0u) {
        phi_218_ = (_e93 + 1u);
    } else {
        phi_218_ = _e93;
    }
    let _e98 = phi_218_;
    if (_e98 > _e68) {
        let _e100 = (_e98 - _e68);
        if (_e71 == 0u) {
            return;
        }
        let _e102 = (_e100 / _e71);
        if (_e71 == 0u) {
            return;
        }
        if ((_e100 % _e71) > 0u) {
            phi_239_ = (_e102 + 1u);
        } else {
            phi_239_ = _e102;
        }
        let _e108 = phi_239_;
        phi_240_ = _e108;
    } else {
        phi_240_ = 0u;
    }
    let _e110 = phi_240_;
    phi_243_ = type_12(0u, _e110);
    loop {
        let _e113 = phi_243_;
        if (_e113.member < _e113.member_1) {
            phi_244_ = type_12((_e113.member + 1u), _e113.member_1);
            phi_267_ = type_12(1u, _e113.member);
        } else {
            phi_244_ = _e113;
            phi_267_ = type_12(0u, type_12().member_1);
        }
        let _e125 = phi_244_;
        let _e127 = phi_267_;
        let _e131 = (bitcast<i32>(_e127.member) != 0i);
        if _e131 {
            let _e135 = (((_e68 + (_e127.member_1 * _e71)) * 64u) + _e57);
            if (_e135 < _e92) {
                let _e139 = params.member.member_1.member_1;
                let _e140 = (_e139 + _e135);
                let _e141 = (7u * _e140);
                let _e144 = contacts.member[(4u + _e141)];
                let _e147 = contacts.member[(_e141 + 5u)];
                let _e150 = contacts.member[(_e141 + 6u)];
                let _e153 = contacts.member[(_e141 + 7u)];
                let _e156 = contacts.member[(_e141 + 8u)];
                let _e159 = contacts.member[(_e141 + 9u)];
                if (_e144 == 0u) {
                    let _e172 = faces.member[_e153];
                    phi_410_ = type_37(0u, array<u32, 4>(_e150, _e172[0], _e172[1], _e172[2]));
                } else {
                    let _e162 = edges.member[_e150];
                    let _e164 = edges.member[_e153];
                    phi_410_ = type_37(1u, array<u32, 4>(_e162[0], _e162[1], _e164[0], _e164[1]));
                }
                let _e179 = phi_410_;
                let _e184 = paths.member[_e179.member_1[0]];
                let _e187 = paths.member[_e179.member_1[1]];
                let _e194 = paths.member[_e179.member_1[2]];
                let _e197 = paths.member[_e179.member_1[3]];
                local_1 = array<array<f32, 3>, 4>(array<f32, 3>(_e184.member[0], _e184.member[1], _e184.member[2]), array<f32, 3>(_e187.member[0], _e187.member[1], _e187.member[2]), array<f32, 3>(_e194.member[0], _e194.member[1], _e194.member[2]), array<f32, 3>(_e197.member[0], _e197.member[1], _e197.member[2]));
                local_2 = array<array<f32, 3>, 4>(array<f32, 3>(_e184.member_1[0], _e184.member_1[1], _e184.member_1[2]), array<f32, 3>(_e187.member_1[0], _e187.member_1[1], _e187.member_1[2]), array<f32, 3>(_e194.member_1[0], _e194.member_1[1], _e194.member_1[2]), array<f32, 3>(_e197.member_1[0], _e197.member_1[1], _e197.member_1[2]));
                let _e237 = (_e159 >> bitcast<u32>(20i));
                if (_e237 <= 896u) {
                    phi_553_ = 0u;
                } else {
                    phi_553_ = ((((_e237 - 896u) << bitcast<u32>(23i)) | ((_e159 & 1048575u) << bitcast<u32>(3i))) | (_e156 >> bitcast<u32>(29i)));
                }
                let _e250 = phi_553_;
                if (_e250 < 1065353216u) {
                    phi_559_ = bitcast<f32>(_e250);
                } else {
                    phi_559_ = 1f;
                }
                let _e254 = phi_559_;
                let _e257 = params.member.member.member_4;
                let _e258 = function_3(_e254, 1f);
                if (_e179.member == 0u) {
                    let _e260 = function_11((&local_1), (&local_2), _e258);
                    phi_568_ = _e260;
                } else {
                    phi_568_ = 0u;
                }
                let _e262 = phi_568_;
                let _e263 = function_10((&local_1), _e262);
                let _e264 = function_10((&local_2), _e262);
                if (_e179.member != 0u) {
                    phi_729_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e263[2][0] - _e263[0][0]), (_e263[2][1] - _e263[0][1]), (_e263[2][2] - _e263[0][2])), array<f32, 3>((_e264[2][0] - _e264[0][0]), (_e264[2][1] - _e264[0][1]), (_e264[2][2] - _e264[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263[1][0] - _e263[0][0]), (_e263[1][1] - _e263[0][1]), (_e263[1][2] - _e263[0][2])), array<f32, 3>((_e264[1][0] - _e264[0][0]), (_e264[1][1] - _e264[0][1]), (_e264[1][2] - _e264[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263[2][0] - _e263[3][0]), (_e263[2][1] - _e263[3][1]), (_e263[2][2] - _e263[3][2])), array<f32, 3>((_e264[2][0] - _e264[3][0]), (_e264[2][1] - _e264[3][1]), (_e264[2][2] - _e264[3][2]))), (_e257 + _e257));
                } else {
                    phi_729_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e263[0][0] - _e263[1][0]), (_e263[0][1] - _e263[1][1]), (_e263[0][2] - _e263[1][2])), array<f32, 3>((_e264[0][0] - _e264[1][0]), (_e264[0][1] - _e264[1][1]), (_e264[0][2] - _e264[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263[2][0] - _e263[1][0]), (_e263[2][1] - _e263[1][1]), (_e263[2][2] - _e263[1][2])), array<f32, 3>((_e264[2][0] - _e264[1][0]), (_e264[2][1] - _e264[1][1]), (_e264[2][2] - _e264[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263[3][0] - _e263[1][0]), (_e263[3][1] - _e263[1][1]), (_e263[3][2] - _e263[1][2])), array<f32, 3>((_e264[3][0] - _e264[1][0]), (_e264[3][1] - _e264[1][1]), (_e264[3][2] - _e264[1][2]))), (_e257 + _e257));
                }
                let _e421 = phi_729_;
                let _e426 = function_9(_e421.member[0], _e421.member[1], _e258);
                let _e431 = function_9(_e421.member_1[0], _e421.member_1[1], _e258);
                let _e436 = function_9(_e421.member_2[0], _e421.member_2[1], _e258);
                if (_e426[0] < 0f) {
                    phi_745_ = -(_e426[0]);
                } else {
                    phi_745_ = _e426[0];
                }
                let _e441 = phi_745_;
                if (_e426[1] < 0f) {
                    phi_752_ = -(_e426[1]);
                } else {
                    phi_752_ = _e426[1];
                }
                let _e446 = phi_752_;
                if (_e441 > _e446) {
                    phi_757_ = _e441;
                } else {
                    phi_757_ = _e446;
                }
                let _e449 = phi_757_;
                if (_e426[2] < 0f) {
                    phi_764_ = -(_e426[2]);
                } else {
                    phi_764_ = _e426[2];
                }
                let _e454 = phi_764_;
                if (_e449 > _e454) {
                    phi_769_ = _e449;
                } else {
                    phi_769_ = _e454;
                }
                let _e457 = phi_769_;
                if (_e431[0] < 0f) {
                    phi_776_ = -(_e431[0]);
                } else {
                    phi_776_ = _e431[0];
                }
                let _e462 = phi_776_;
                if (_e431[1] < 0f) {
                    phi_783_ = -(_e431[1]);
                } else {
                    phi_783_ = _e431[1];
                }
                let _e467 = phi_783_;
                if (_e462 > _e467) {
                    phi_788_ = _e462;
                } else {
                    phi_788_ = _e467;
                }
                let _e470 = phi_788_;
                if (_e431[2] < 0f) {
                    phi_795_ = -(_e431[2]);
                } else {
                    phi_795_ = _e431[2];
                }
                let _e475 = phi_795_;
                if (_e470 > _e475) {
                    phi_800_ = _e470;
                } else {
                    phi_800_ = _e475;
                }
                let _e478 = phi_800_;
                if (_e457 > _e478) {
                    phi_805_ = _e457;
                } else {
                    phi_805_ = _e478;
                }
                let _e481 = phi_805_;
                if (_e436[0] < 0f) {
                    phi_812_ = -(_e436[0]);
                } else {
                    phi_812_ = _e436[0];
                }
                let _e486 = phi_812_;
                if (_e436[1] < 0f) {
                    phi_819_ = -(_e436[1]);
                } else {
                    phi_819_ = _e436[1];
                }
                let _e491 = phi_819_;
                if (_e486 > _e491) {
                    phi_824_ = _e486;
                } else {
                    phi_824_ = _e491;
                }
                let _e494 = phi_824_;
                if (_e436[2] < 0f) {
                    phi_831_ = -(_e436[2]);
                } else {
                    phi_831_ = _e436[2];
                }
                let _e499 = phi_831_;
                if (_e494 > _e499) {
                    phi_836_ = _e494;
                } else {
                    phi_836_ = _e499;
                }
                let _e502 = phi_836_;
                if (_e481 > _e502) {
                    phi_841_ = _e481;
                } else {
                    phi_841_ = _e502;
                }
                let _e505 = phi_841_;
                let _e506 = function_8(_e505);
                let _e514 = (_e431[0] * _e506);
                let _e516 = (_e431[1] * _e506);
                let _e518 = (_e431[2] * _e506);
                let _e520 = (_e436[0] * _e506);
                let _e522 = (_e436[1] * _e506);
                let _e524 = (_e436[2] * _e506);
                if (_e421.member[0][0] < 0f) {
                    phi_871_ = -(_e421.member[0][0]);
                } else {
                    phi_871_ = _e421.member[0][0];
                }
                let _e531 = phi_871_;
                if (_e421.member[0][1] < 0f) {
                    phi_878_ = -(_e421.member[0][1]);
                } else {
                    phi_878_ = _e421.member[0][1];
                }
                let _e536 = phi_878_;
                if (_e531 > _e536) {
                    phi_883_ = _e531;
                } else {
                    phi_883_ = _e536;
                }
                let _e539 = phi_883_;
                if (_e421.member[0][2] < 0f) {
                    phi_890_ = -(_e421.member[0][2]);
                } else {
                    phi_890_ = _e421.member[0][2];
                }
                let _e544 = phi_890_;
                if (_e539 > _e544) {
                    phi_895_ = _e539;
                } else {
                    phi_895_ = _e544;
                }
                let _e547 = phi_895_;
                if (_e421.member[1][0] < 0f) {
                    phi_903_ = -(_e421.member[1][0]);
                } else {
                    phi_903_ = _e421.member[1][0];
                }
                let _e554 = phi_903_;
                if (_e421.member[1][1] < 0f) {
                    phi_910_ = -(_e421.member[1][1]);
                } else {
                    phi_910_ = _e421.member[1][1];
                }
                let _e559 = phi_910_;
                if (_e554 > _e559) {
                    phi_915_ = _e554;
                } else {
                    phi_915_ = _e559;
                }
                let _e562 = phi_915_;
                if (_e421.member[1][2] < 0f) {
                    phi_922_ = -(_e421.member[1][2]);
                } else {
                    phi_922_ = _e421.member[1][2];
                }
                let _e567 = phi_922_;
                if (_e562 > _e567) {
                    phi_927_ = _e562;
                } else {
                    phi_927_ = _e567;
                }
                let _e570 = phi_927_;
                if (_e547 > _e570) {
                    phi_932_ = _e547;
                } else {
                    phi_932_ = _e570;
                }
                let _e573 = phi_932_;
                if (_e421.member_1[0][0] < 0f) {
                    phi_942_ = -(_e421.member_1[0][0]);
                } else {
                    phi_942_ = _e421.member_1[0][0];
                }
                let _e582 = phi_942_;
                if (_e421.member_1[0][1] < 0f) {
                    phi_949_ = -(_e421.member_1[0][1]);
                } else {
                    phi_949_ = _e421.member_1[0][1];
                }
                let _e587 = phi_949_;
                if (_e582 > _e587) {
                    phi_954_ = _e582;
                } else {
                    phi_954_ = _e587;
                }
                let _e590 = phi_954_;
                if (_e421.member_1[0][2] < 0f) {
                    phi_961_ = -(_e421.member_1[0][2]);
                } else {
                    phi_961_ = _e421.member_1[0][2];
                }
                let _e595 = phi_961_;
                if (_e590 > _e595) {
                    phi_966_ = _e590;
                } else {
                    phi_966_ = _e595;
                }
                let _e598 = phi_966_;
                if (_e421.member_1[1][0] < 0f) {
                    phi_974_ = -(_e421.member_1[1][0]);
                } else {
                    phi_974_ = _e421.member_1[1][0];
                }
                let _e605 = phi_974_;
                if (_e421.member_1[1][1] < 0f) {
                    phi_981_ = -(_e421.member_1[1][1]);
                } else {
                    phi_981_ = _e421.member_1[1][1];
                }
                let _e610 = phi_981_;
                if (_e605 > _e610) {
                    phi_986_ = _e605;
                } else {
                    phi_986_ = _e610;
                }
                let _e613 = phi_986_;
                if (_e421.member_1[1][2] < 0f) {
                    phi_993_ = -(_e421.member_1[1][2]);
                } else {
                    phi_993_ = _e421.member_1[1][2];
                }
                let _e618 = phi_993_;
                if (_e613 > _e618) {
                    phi_998_ = _e613;
                } else {
                    phi_998_ = _e618;
                }
                let _e621 = phi_998_;
                if (_e598 > _e621) {
                    phi_1003_ = _e598;
                } else {
                    phi_1003_ = _e621;
                }
                let _e624 = phi_1003_;
                let _e626 = (_e624 + _e421.member_3);
                if (_e421.member_2[0][0] < 0f) {
                    phi_1013_ = -(_e421.member_2[0][0]);
                } else {
                    phi_1013_ = _e421.member_2[0][0];
                }
                let _e633 = phi_1013_;
                if (_e421.member_2[0][1] < 0f) {
                    phi_1020_ = -(_e421.member_2[0][1]);
                } else {
                    phi_1020_ = _e421.member_2[0][1];
                }
                let _e638 = phi_1020_;
                if (_e633 > _e638) {
                    phi_1025_ = _e633;
                } else {
                    phi_1025_ = _e638;
                }
                let _e641 = phi_1025_;
                if (_e421.member_2[0][2] < 0f) {
                    phi_1032_ = -(_e421.member_2[0][2]);
                } else {
                    phi_1032_ = _e421.member_2[0][2];
                }
                let _e646 = phi_1032_;
                if (_e641 > _e646) {
                    phi_1037_ = _e641;
                } else {
                    phi_1037_ = _e646;
                }
                let _e649 = phi_1037_;
                if (_e421.member_2[1][0] < 0f) {
                    phi_1045_ = -(_e421.member_2[1][0]);
                } else {
                    phi_1045_ = _e421.member_2[1][0];
                }
                let _e656 = phi_1045_;
                if (_e421.member_2[1][1] < 0f) {
                    phi_1052_ = -(_e421.member_2[1][1]);
                } else {
                    phi_1052_ = _e421.member_2[1][1];
                }
                let _e661 = phi_1052_;
                if (_e656 > _e661) {
                    phi_1057_ = _e656;
                } else {
                    phi_1057_ = _e661;
                }
                let _e664 = phi_1057_;
                if (_e421.member_2[1][2] < 0f) {
                    phi_1064_ = -(_e421.member_2[1][2]);
                } else {
                    phi_1064_ = _e421.member_2[1][2];
                }
                let _e669 = phi_1064_;
                if (_e664 > _e669) {
                    phi_1069_ = _e664;
                } else {
                    phi_1069_ = _e669;
                }
                let _e672 = phi_1069_;
                if (_e649 > _e672) {
                    phi_1074_ = _e649;
                } else {
                    phi_1074_ = _e672;
                }
                let _e675 = phi_1074_;
                let _e677 = (_e675 + _e421.member_3);
                let _e678 = (0.000000059604645f * 16f);
                let _e682 = ((_e421.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * 4f);
                let _e690 = ((_e516 * _e524) - (_e518 * _e522));
                let _e693 = ((_e518 * _e520) - (_e514 * _e524));
                let _e696 = ((_e514 * _e522) - (_e516 * _e520));
                if (_e520 < 0f) {
                    phi_1107_ = -(_e520);
                } else {
                    phi_1107_ = _e520;
                }
                let _e705 = phi_1107_;
                if (_e522 < 0f) {
                    phi_1113_ = -(_e522);
                } else {
                    phi_1113_ = _e522;
                }
                let _e709 = phi_1113_;
                if (_e705 > _e709) {
                    phi_1118_ = _e705;
                } else {
                    phi_1118_ = _e709;
                }
                let _e712 = phi_1118_;
                if (_e524 < 0f) {
                    phi_1124_ = -(_e524);
                } else {
                    phi_1124_ = _e524;
                }
                let _e716 = phi_1124_;
                if (_e712 > _e716) {
                    phi_1129_ = _e712;
                } else {
                    phi_1129_ = _e716;
                }
                let _e719 = phi_1129_;
                if (_e514 < 0f) {
                    phi_1137_ = -(_e514);
                } else {
                    phi_1137_ = _e514;
                }
                let _e725 = phi_1137_;
                if (_e516 < 0f) {
                    phi_1143_ = -(_e516);
                } else {
                    phi_1143_ = _e516;
                }
                let _e729 = phi_1143_;
                if (_e725 > _e729) {
                    phi_1148_ = _e725;
                } else {
                    phi_1148_ = _e729;
                }
                let _e732 = phi_1148_;
                if (_e518 < 0f) {
                    phi_1154_ = -(_e518);
                } else {
                    phi_1154_ = _e518;
                }
                let _e736 = phi_1154_;
                if (_e732 > _e736) {
                    phi_1159_ = _e732;
                } else {
                    phi_1159_ = _e736;
                }
                let _e739 = phi_1159_;
                let _e741 = (((((_e626 * _e678) + _e682) * _e506) * _e719) + ((((_e677 * _e678) + _e682) * _e506) * _e739));
                let _e746 = (((_e690 * _e690) + (_e693 * _e693)) + (_e696 * _e696));
                if (_e746 <= 0.000000000000000000000000000000000000011754944f) {
                    if (_e746 > 0f) {
                        phi_1180_ = (0.000000000000000000106433627f * 2f);
                    } else {
                        phi_1180_ = 0f;
                    }
                    let _e799 = phi_1180_;
                    phi_1244_ = _e799;
                } else {
                    phi_1187_ = type_14(0i, 5i);
                    phi_1190_ = bitcast<f32>(((bitcast<u32>(_e746) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e754 = phi_1187_;
                        let _e756 = phi_1190_;
                        local_3 = _e756;
                        if (_e754.member < _e754.member_1) {
                            let _e763 = (_e754.member + 1i);
                            if ((false == (_e763 > _e754.member)) != false) {
                                phi_1211_ = true;
                            } else {
                                phi_1211_ = false;
                            }
                            let _e768 = phi_1211_;
                            if _e768 {
                                phi_1217_ = type_15(0u, type_15().member_1);
                            } else {
                                phi_1217_ = type_15(1u, _e763);
                            }
                            let _e773 = phi_1217_;
                            phi_1188_ = type_14(_e773.member_1, _e754.member_1);
                            phi_1231_ = type_15(1u, _e754.member);
                        } else {
                            phi_1188_ = _e754;
                            phi_1231_ = type_15(0u, type_15().member_1);
                        }
                        let _e779 = phi_1188_;
                        let _e781 = phi_1231_;
                        let _e784 = (bitcast<i32>(_e781.member) != 0i);
                        if _e784 {
                            phi_1191_ = (0.5f * (_e756 + (_e746 / _e756)));
                        } else {
                            phi_1191_ = f32();
                        }
                        let _e789 = phi_1191_;
                        continue;
                        continuing {
                            phi_1187_ = _e779;
                            phi_1190_ = _e789;
                            break if !(_e784);
                        }
                    }
                    let _e794 = local_3;
                    phi_1244_ = (_e794 * (1f + (8f * 0.000000059604645f)));
                }
                let _e801 = phi_1244_;
                if (_e801 > 0f) {
                    phi_1252_ = ((_e801 + (_e746 / _e801)) * 0.5f);
                } else {
                    phi_1252_ = _e801;
                }
                let _e807 = phi_1252_;
                if (_e807 > _e741) {
                    phi_1257_ = _e807;
                } else {
                    phi_1257_ = 0f;
                }
                let _e810 = phi_1257_;
                local = type_27(array<f32, 3>((_e426[0] * _e506), (_e426[1] * _e506), (_e426[2] * _e506)), array<f32, 3>(_e514, _e516, _e518), array<f32, 3>(_e520, _e522, _e524), array<f32, 3>(_e690, _e693, _e696), _e810, _e741, ((((((_e573 + _e421.member_3) + _e626) + _e677) * _e678) + _e682) * _e506));
                let _e816 = function_7((&local), _e179.member);
                if (_e816.member_3 <= 0.000000000000000000000000000000000000011754944f) {
                    if (_e816.member_3 > 0f) {
                        phi_1300_ = (0.000000000000000000106433627f * 2f);
                    } else {
                        phi_1300_ = 0f;
                    }
                    let _e872 = phi_1300_;
                    phi_1364_ = _e872;
                } else {
                    phi_1307_ = type_14(0i, 5i);
                    phi_1310_ = bitcast<f32>(((bitcast<u32>(_e816.member_3) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e827 = phi_1307_;
                        let _e829 = phi_1310_;
                        local_4 = _e829;
                        if (_e827.member < _e827.member_1) {
                            let _e836 = (_e827.member + 1i);
                            if ((false == (_e836 > _e827.member)) != false) {
                                phi_1331_ = true;
                            } else {
                                phi_1331_ = false;
                            }
                            let _e841 = phi_1331_;
                            if _e841 {
                                phi_1337_ = type_15(0u, type_15().member_1);
                            } else {
                                phi_1337_ = type_15(1u, _e836);
                            }
                            let _e846 = phi_1337_;
                            phi_1308_ = type_14(_e846.member_1, _e827.member_1);
                            phi_1351_ = type_15(1u, _e827.member);
                        } else {
                            phi_1308_ = _e827;
                            phi_1351_ = type_15(0u, type_15().member_1);
                        }
                        let _e852 = phi_1308_;
                        let _e854 = phi_1351_;
                        let _e857 = (bitcast<i32>(_e854.member) != 0i);
                        if _e857 {
                            phi_1311_ = (0.5f * (_e829 + (_e816.member_3 / _e829)));
                        } else {
                            phi_1311_ = f32();
                        }
                        let _e862 = phi_1311_;
                        continue;
                        continuing {
                            phi_1307_ = _e852;
                            phi_1310_ = _e862;
                            break if !(_e857);
                        }
                    }
                    let _e867 = local_4;
                    phi_1364_ = (_e867 * (1f + (8f * 0.000000059604645f)));
                }
                let _e874 = phi_1364_;
                if (_e874 > 0f) {
                    phi_1372_ = ((_e874 + (_e816.member_3 / _e874)) * 0.5f);
                } else {
                    phi_1372_ = _e874;
                }
                let _e880 = phi_1372_;
                if (_e179.member == 0u) {
                    phi_1378_ = 1f;
                } else {
                    phi_1378_ = -(1f);
                }
                let _e884 = phi_1378_;
                let _e886 = function_1(_e421.member);
                let _e888 = function_1(_e421.member_1);
                let _e902 = function_1(_e421.member_2);
                let _e912 = (((_e886[0] - (_e888[0] * _e816.member)) - (_e902[0] * _e816.member_1)) * _e884);
                let _e913 = (((_e886[1] - (_e888[1] * _e816.member)) - (_e902[1] * _e816.member_1)) * _e884);
                let _e914 = (((_e886[2] - (_e888[2] * _e816.member)) - (_e902[2] * _e816.member_1)) * _e884);
                if (_e816.member > 0f) {
                    phi_1417_ = (_e816.member < 1f);
                } else {
                    phi_1417_ = false;
                }
                let _e921 = phi_1417_;
                if (_e816.member_1 > 0f) {
                    phi_1423_ = (_e816.member_1 < 1f);
                } else {
                    phi_1423_ = false;
                }
                let _e925 = phi_1423_;
                let _e926 = (_e884 > 0f);
                if _e921 {
                    if _e925 {
                        if _e926 {
                            phi_1438_ = ((_e816.member + _e816.member_1) < (1f - (0.000000059604645f * 4f)));
                        } else {
                            phi_1438_ = true;
                        }
                        let _e932 = phi_1438_;
                        phi_1439_ = _e932;
                        phi_1440_ = false;
                    } else {
                        phi_1439_ = bool();
                        phi_1440_ = true;
                    }
                    let _e934 = phi_1439_;
                    let _e936 = phi_1440_;
                    phi_1441_ = _e934;
                    phi_1442_ = _e936;
                } else {
                    phi_1441_ = bool();
                    phi_1442_ = true;
                }
                let _e938 = phi_1441_;
                let _e940 = phi_1442_;
                if _e940 {
                    phi_1446_ = false;
                } else {
                    phi_1446_ = _e938;
                }
                let _e942 = phi_1446_;
                let _e944 = local.member_4;
                let _e945 = (_e944 > 0f);
                let _e947 = local.member_3;
                let _e951 = (_e947[0] * _e884);
                let _e952 = (_e947[1] * _e884);
                let _e953 = (_e947[2] * _e884);
                let _e956 = local.member_6;
                if (_e880 > _e956) {
                    let _e2069 = (_e816.member_2[0] * _e884);
                    let _e2071 = (_e816.member_2[1] * _e884);
                    let _e2073 = (_e816.member_2[2] * _e884);
                    if _e945 {
                        if _e942 {
                            let _e2075 = local.member_5;
                            let _e2078 = local.member_6;
                            let _e2080 = local.member_4;
                            if ((_e2075 * _e880) <= (_e2078 * _e2080)) {
                                if ((((_e2069 * _e951) + (_e2071 * _e952)) + (_e2073 * _e953)) >= 0f) {
                                    phi_1508_ = array<f32, 3>(_e951, _e952, _e953);
                                } else {
                                    let _e2089 = -(1f);
                                    phi_1508_ = array<f32, 3>((_e951 * _e2089), (_e952 * _e2089), (_e953 * _e2089));
                                }
                                let _e2095 = phi_1508_;
                                if (_e2095[0] < 0f) {
                                    phi_1515_ = -(_e2095[0]);
                                } else {
                                    phi_1515_ = _e2095[0];
                                }
                                let _e2100 = phi_1515_;
                                if (_e2095[1] < 0f) {
                                    phi_1522_ = -(_e2095[1]);
                                } else {
                                    phi_1522_ = _e2095[1];
                                }
                                let _e2105 = phi_1522_;
                                if (_e2100 > _e2105) {
                                    phi_1527_ = _e2100;
                                } else {
                                    phi_1527_ = _e2105;
                                }
                                let _e2108 = phi_1527_;
                                if (_e2095[2] < 0f) {
                                    phi_1534_ = -(_e2095[2]);
                                } else {
                                    phi_1534_ = _e2095[2];
                                }
                                let _e2113 = phi_1534_;
                                if (_e2108 > _e2113) {
                                    phi_1539_ = _e2108;
                                } else {
                                    phi_1539_ = _e2113;
                                }
                                let _e2116 = phi_1539_;
                                let _e2117 = function_8(_e2116);
                                let _e2119 = (_e2095[0] * _e2117);
                                let _e2121 = (_e2095[1] * _e2117);
                                let _e2123 = (_e2095[2] * _e2117);
                                let _e2128 = (((_e2119 * _e2119) + (_e2121 * _e2121)) + (_e2123 * _e2123));
                                if (_e2128 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e2128 > 0f) {
                                        phi_1565_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_1565_ = 0f;
                                    }
                                    let _e2181 = phi_1565_;
                                    phi_1629_ = _e2181;
                                } else {
                                    phi_1572_ = type_14(0i, 5i);
                                    phi_1575_ = bitcast<f32>(((bitcast<u32>(_e2128) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e2136 = phi_1572_;
                                        let _e2138 = phi_1575_;
                                        local_11 = _e2138;
                                        if (_e2136.member < _e2136.member_1) {
                                            let _e2145 = (_e2136.member + 1i);
                                            if ((false == (_e2145 > _e2136.member)) != false) {
                                                phi_1596_ = true;
                                            } else {
                                                phi_1596_ = false;
                                            }
                                            let _e2150 = phi_1596_;
                                            if _e2150 {
                                                phi_1602_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_1602_ = type_15(1u, _e2145);
                                            }
                                            let _e2155 = phi_1602_;
                                            phi_1573_ = type_14(_e2155.member_1, _e2136.member_1);
                                            phi_1616_ = type_15(1u, _e2136.member);
                                        } else {
                                            phi_1573_ = _e2136;
                                            phi_1616_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2161 = phi_1573_;
                                        let _e2163 = phi_1616_;
                                        let _e2166 = (bitcast<i32>(_e2163.member) != 0i);
                                        if _e2166 {
                                            phi_1576_ = (0.5f * (_e2138 + (_e2128 / _e2138)));
                                        } else {
                                            phi_1576_ = f32();
                                        }
                                        let _e2171 = phi_1576_;
                                        continue;
                                        continuing {
                                            phi_1572_ = _e2161;
                                            phi_1575_ = _e2171;
                                            break if !(_e2166);
                                        }
                                    }
                                    let _e2176 = local_11;
                                    phi_1629_ = (_e2176 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2183 = phi_1629_;
                                let _e2184 = (1f / _e2183);
                                let _e2185 = (_e2119 * _e2184);
                                let _e2186 = (_e2121 * _e2184);
                                let _e2187 = (_e2123 * _e2184);
                                let _e2194 = ((3f - (((_e2185 * _e2185) + (_e2186 * _e2186)) + (_e2187 * _e2187))) * 0.5f);
                                phi_1645_ = array<f32, 3>((_e2185 * _e2194), (_e2186 * _e2194), (_e2187 * _e2194));
                                phi_1646_ = false;
                            } else {
                                phi_1645_ = array<f32, 3>();
                                phi_1646_ = true;
                            }
                            let _e2200 = phi_1645_;
                            let _e2202 = phi_1646_;
                            phi_1647_ = _e2200;
                            phi_1648_ = _e2202;
                        } else {
                            phi_1647_ = array<f32, 3>();
                            phi_1648_ = true;
                        }
                        let _e2204 = phi_1647_;
                        let _e2206 = phi_1648_;
                        phi_1649_ = _e2204;
                        phi_1650_ = _e2206;
                    } else {
                        phi_1649_ = array<f32, 3>();
                        phi_1650_ = true;
                    }
                    let _e2208 = phi_1649_;
                    let _e2210 = phi_1650_;
                    if _e2210 {
                        if (_e2069 < 0f) {
                            phi_1659_ = -(_e2069);
                        } else {
                            phi_1659_ = _e2069;
                        }
                        let _e2214 = phi_1659_;
                        if (_e2071 < 0f) {
                            phi_1665_ = -(_e2071);
                        } else {
                            phi_1665_ = _e2071;
                        }
                        let _e2218 = phi_1665_;
                        if (_e2214 > _e2218) {
                            phi_1670_ = _e2214;
                        } else {
                            phi_1670_ = _e2218;
                        }
                        let _e2221 = phi_1670_;
                        if (_e2073 < 0f) {
                            phi_1676_ = -(_e2073);
                        } else {
                            phi_1676_ = _e2073;
                        }
                        let _e2225 = phi_1676_;
                        if (_e2221 > _e2225) {
                            phi_1681_ = _e2221;
                        } else {
                            phi_1681_ = _e2225;
                        }
                        let _e2228 = phi_1681_;
                        let _e2229 = function_8(_e2228);
                        let _e2230 = (_e2069 * _e2229);
                        let _e2231 = (_e2071 * _e2229);
                        let _e2232 = (_e2073 * _e2229);
                        let _e2237 = (((_e2230 * _e2230) + (_e2231 * _e2231)) + (_e2232 * _e2232));
                        if (_e2237 <= 0.000000000000000000000000000000000000011754944f) {
                            if (_e2237 > 0f) {
                                phi_1704_ = (0.000000000000000000106433627f * 2f);
                            } else {
                                phi_1704_ = 0f;
                            }
                            let _e2290 = phi_1704_;
                            phi_1768_ = _e2290;
                        } else {
                            phi_1711_ = type_14(0i, 5i);
                            phi_1714_ = bitcast<f32>(((bitcast<u32>(_e2237) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e2245 = phi_1711_;
                                let _e2247 = phi_1714_;
                                local_12 = _e2247;
                                if (_e2245.member < _e2245.member_1) {
                                    let _e2254 = (_e2245.member + 1i);
                                    if ((false == (_e2254 > _e2245.member)) != false) {
                                        phi_1735_ = true;
                                    } else {
                                        phi_1735_ = false;
                                    }
                                    let _e2259 = phi_1735_;
                                    if _e2259 {
                                        phi_1741_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_1741_ = type_15(1u, _e2254);
                                    }
                                    let _e2264 = phi_1741_;
                                    phi_1712_ = type_14(_e2264.member_1, _e2245.member_1);
                                    phi_1755_ = type_15(1u, _e2245.member);
                                } else {
                                    phi_1712_ = _e2245;
                                    phi_1755_ = type_15(0u, type_15().member_1);
                                }
                                let _e2270 = phi_1712_;
                                let _e2272 = phi_1755_;
                                let _e2275 = (bitcast<i32>(_e2272.member) != 0i);
                                if _e2275 {
                                    phi_1715_ = (0.5f * (_e2247 + (_e2237 / _e2247)));
                                } else {
                                    phi_1715_ = f32();
                                }
                                let _e2280 = phi_1715_;
                                continue;
                                continuing {
                                    phi_1711_ = _e2270;
                                    phi_1714_ = _e2280;
                                    break if !(_e2275);
                                }
                            }
                            let _e2285 = local_12;
                            phi_1768_ = (_e2285 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e2292 = phi_1768_;
                        let _e2293 = (1f / _e2292);
                        let _e2294 = (_e2230 * _e2293);
                        let _e2295 = (_e2231 * _e2293);
                        let _e2296 = (_e2232 * _e2293);
                        let _e2303 = ((3f - (((_e2294 * _e2294) + (_e2295 * _e2295)) + (_e2296 * _e2296))) * 0.5f);
                        phi_1784_ = array<f32, 3>((_e2294 * _e2303), (_e2295 * _e2303), (_e2296 * _e2303));
                    } else {
                        phi_1784_ = _e2208;
                    }
                    let _e2309 = phi_1784_;
                    phi_3302_ = _e2309;
                    phi_3303_ = array<f32, 3>();
                    phi_3304_ = true;
                } else {
                    if (_e421.member[0][0] < 0f) {
                        phi_1792_ = -(_e421.member[0][0]);
                    } else {
                        phi_1792_ = _e421.member[0][0];
                    }
                    let _e964 = phi_1792_;
                    if (_e421.member[0][1] < 0f) {
                        phi_1799_ = -(_e421.member[0][1]);
                    } else {
                        phi_1799_ = _e421.member[0][1];
                    }
                    let _e969 = phi_1799_;
                    if (_e964 > _e969) {
                        phi_1804_ = _e964;
                    } else {
                        phi_1804_ = _e969;
                    }
                    let _e972 = phi_1804_;
                    if (_e421.member[0][2] < 0f) {
                        phi_1811_ = -(_e421.member[0][2]);
                    } else {
                        phi_1811_ = _e421.member[0][2];
                    }
                    let _e977 = phi_1811_;
                    if (_e972 > _e977) {
                        phi_1816_ = _e972;
                    } else {
                        phi_1816_ = _e977;
                    }
                    let _e980 = phi_1816_;
                    if (_e421.member[1][0] < 0f) {
                        phi_1824_ = -(_e421.member[1][0]);
                    } else {
                        phi_1824_ = _e421.member[1][0];
                    }
                    let _e987 = phi_1824_;
                    if (_e421.member[1][1] < 0f) {
                        phi_1831_ = -(_e421.member[1][1]);
                    } else {
                        phi_1831_ = _e421.member[1][1];
                    }
                    let _e992 = phi_1831_;
                    if (_e987 > _e992) {
                        phi_1836_ = _e987;
                    } else {
                        phi_1836_ = _e992;
                    }
                    let _e995 = phi_1836_;
                    if (_e421.member[1][2] < 0f) {
                        phi_1843_ = -(_e421.member[1][2]);
                    } else {
                        phi_1843_ = _e421.member[1][2];
                    }
                    let _e1000 = phi_1843_;
                    if (_e995 > _e1000) {
                        phi_1848_ = _e995;
                    } else {
                        phi_1848_ = _e1000;
                    }
                    let _e1003 = phi_1848_;
                    if (_e980 > _e1003) {
                        phi_1853_ = _e980;
                    } else {
                        phi_1853_ = _e1003;
                    }
                    let _e1006 = phi_1853_;
                    if (_e421.member_1[0][0] < 0f) {
                        phi_1863_ = -(_e421.member_1[0][0]);
                    } else {
                        phi_1863_ = _e421.member_1[0][0];
                    }
                    let _e1015 = phi_1863_;
                    if (_e421.member_1[0][1] < 0f) {
                        phi_1870_ = -(_e421.member_1[0][1]);
                    } else {
                        phi_1870_ = _e421.member_1[0][1];
                    }
                    let _e1020 = phi_1870_;
                    if (_e1015 > _e1020) {
                        phi_1875_ = _e1015;
                    } else {
                        phi_1875_ = _e1020;
                    }
                    let _e1023 = phi_1875_;
                    if (_e421.member_1[0][2] < 0f) {
                        phi_1882_ = -(_e421.member_1[0][2]);
                    } else {
                        phi_1882_ = _e421.member_1[0][2];
                    }
                    let _e1028 = phi_1882_;
                    if (_e1023 > _e1028) {
                        phi_1887_ = _e1023;
                    } else {
                        phi_1887_ = _e1028;
                    }
                    let _e1031 = phi_1887_;
                    if (_e421.member_1[1][0] < 0f) {
                        phi_1895_ = -(_e421.member_1[1][0]);
                    } else {
                        phi_1895_ = _e421.member_1[1][0];
                    }
                    let _e1038 = phi_1895_;
                    if (_e421.member_1[1][1] < 0f) {
                        phi_1902_ = -(_e421.member_1[1][1]);
                    } else {
                        phi_1902_ = _e421.member_1[1][1];
                    }
                    let _e1043 = phi_1902_;
                    if (_e1038 > _e1043) {
                        phi_1907_ = _e1038;
                    } else {
                        phi_1907_ = _e1043;
                    }
                    let _e1046 = phi_1907_;
                    if (_e421.member_1[1][2] < 0f) {
                        phi_1914_ = -(_e421.member_1[1][2]);
                    } else {
                        phi_1914_ = _e421.member_1[1][2];
                    }
                    let _e1051 = phi_1914_;
                    if (_e1046 > _e1051) {
                        phi_1919_ = _e1046;
                    } else {
                        phi_1919_ = _e1051;
                    }
                    let _e1054 = phi_1919_;
                    if (_e1031 > _e1054) {
                        phi_1924_ = _e1031;
                    } else {
                        phi_1924_ = _e1054;
                    }
                    let _e1057 = phi_1924_;
                    if (_e421.member_2[0][0] < 0f) {
                        phi_1934_ = -(_e421.member_2[0][0]);
                    } else {
                        phi_1934_ = _e421.member_2[0][0];
                    }
                    let _e1066 = phi_1934_;
                    if (_e421.member_2[0][1] < 0f) {
                        phi_1941_ = -(_e421.member_2[0][1]);
                    } else {
                        phi_1941_ = _e421.member_2[0][1];
                    }
                    let _e1071 = phi_1941_;
                    if (_e1066 > _e1071) {
                        phi_1946_ = _e1066;
                    } else {
                        phi_1946_ = _e1071;
                    }
                    let _e1074 = phi_1946_;
                    if (_e421.member_2[0][2] < 0f) {
                        phi_1953_ = -(_e421.member_2[0][2]);
                    } else {
                        phi_1953_ = _e421.member_2[0][2];
                    }
                    let _e1079 = phi_1953_;
                    if (_e1074 > _e1079) {
                        phi_1958_ = _e1074;
                    } else {
                        phi_1958_ = _e1079;
                    }
                    let _e1082 = phi_1958_;
                    if (_e421.member_2[1][0] < 0f) {
                        phi_1966_ = -(_e421.member_2[1][0]);
                    } else {
                        phi_1966_ = _e421.member_2[1][0];
                    }
                    let _e1089 = phi_1966_;
                    if (_e421.member_2[1][1] < 0f) {
                        phi_1973_ = -(_e421.member_2[1][1]);
                    } else {
                        phi_1973_ = _e421.member_2[1][1];
                    }
                    let _e1094 = phi_1973_;
                    if (_e1089 > _e1094) {
                        phi_1978_ = _e1089;
                    } else {
                        phi_1978_ = _e1094;
                    }
                    let _e1097 = phi_1978_;
                    if (_e421.member_2[1][2] < 0f) {
                        phi_1985_ = -(_e421.member_2[1][2]);
                    } else {
                        phi_1985_ = _e421.member_2[1][2];
                    }
                    let _e1102 = phi_1985_;
                    if (_e1097 > _e1102) {
                        phi_1990_ = _e1097;
                    } else {
                        phi_1990_ = _e1102;
                    }
                    let _e1105 = phi_1990_;
                    if (_e1082 > _e1105) {
                        phi_1995_ = _e1082;
                    } else {
                        phi_1995_ = _e1105;
                    }
                    let _e1108 = phi_1995_;
                    let _e1119 = (((((_e1006 + _e421.member_3) + (_e1057 + _e421.member_3)) + (_e1108 + _e421.member_3)) * (0.000000059604645f * 32f)) + ((_e421.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * 8f));
                    if _e945 {
                        if (_e951 < 0f) {
                            phi_2015_ = -(_e951);
                        } else {
                            phi_2015_ = _e951;
                        }
                        let _e1123 = phi_2015_;
                        if (_e952 < 0f) {
                            phi_2021_ = -(_e952);
                        } else {
                            phi_2021_ = _e952;
                        }
                        let _e1127 = phi_2021_;
                        if (_e1123 > _e1127) {
                            phi_2026_ = _e1123;
                        } else {
                            phi_2026_ = _e1127;
                        }
                        let _e1130 = phi_2026_;
                        if (_e953 < 0f) {
                            phi_2032_ = -(_e953);
                        } else {
                            phi_2032_ = _e953;
                        }
                        let _e1134 = phi_2032_;
                        if (_e1130 > _e1134) {
                            phi_2037_ = _e1130;
                        } else {
                            phi_2037_ = _e1134;
                        }
                        let _e1137 = phi_2037_;
                        let _e1138 = function_8(_e1137);
                        let _e1139 = (_e951 * _e1138);
                        let _e1140 = (_e952 * _e1138);
                        let _e1141 = (_e953 * _e1138);
                        let _e1146 = (((_e1139 * _e1139) + (_e1140 * _e1140)) + (_e1141 * _e1141));
                        if (_e1146 <= 0.000000000000000000000000000000000000011754944f) {
                            if (_e1146 > 0f) {
                                phi_2060_ = (0.000000000000000000106433627f * 2f);
                            } else {
                                phi_2060_ = 0f;
                            }
                            let _e1199 = phi_2060_;
                            phi_2124_ = _e1199;
                        } else {
                            phi_2067_ = type_14(0i, 5i);
                            phi_2070_ = bitcast<f32>(((bitcast<u32>(_e1146) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e1154 = phi_2067_;
                                let _e1156 = phi_2070_;
                                local_5 = _e1156;
                                if (_e1154.member < _e1154.member_1) {
                                    let _e1163 = (_e1154.member + 1i);
                                    if ((false == (_e1163 > _e1154.member)) != false) {
                                        phi_2091_ = true;
                                    } else {
                                        phi_2091_ = false;
                                    }
                                    let _e1168 = phi_2091_;
                                    if _e1168 {
                                        phi_2097_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_2097_ = type_15(1u, _e1163);
                                    }
                                    let _e1173 = phi_2097_;
                                    phi_2068_ = type_14(_e1173.member_1, _e1154.member_1);
                                    phi_2111_ = type_15(1u, _e1154.member);
                                } else {
                                    phi_2068_ = _e1154;
                                    phi_2111_ = type_15(0u, type_15().member_1);
                                }
                                let _e1179 = phi_2068_;
                                let _e1181 = phi_2111_;
                                let _e1184 = (bitcast<i32>(_e1181.member) != 0i);
                                if _e1184 {
                                    phi_2071_ = (0.5f * (_e1156 + (_e1146 / _e1156)));
                                } else {
                                    phi_2071_ = f32();
                                }
                                let _e1189 = phi_2071_;
                                continue;
                                continuing {
                                    phi_2067_ = _e1179;
                                    phi_2070_ = _e1189;
                                    break if !(_e1184);
                                }
                            }
                            let _e1194 = local_5;
                            phi_2124_ = (_e1194 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e1201 = phi_2124_;
                        let _e1202 = (1f / _e1201);
                        let _e1203 = (_e1139 * _e1202);
                        let _e1204 = (_e1140 * _e1202);
                        let _e1205 = (_e1141 * _e1202);
                        let _e1212 = ((3f - (((_e1203 * _e1203) + (_e1204 * _e1204)) + (_e1205 * _e1205))) * 0.5f);
                        let _e1213 = (_e1203 * _e1212);
                        let _e1214 = (_e1204 * _e1212);
                        let _e1215 = (_e1205 * _e1212);
                        let _e1221 = (((_e912 * _e1213) + (_e913 * _e1214)) + (_e914 * _e1215));
                        if (_e912 < 0f) {
                            phi_2150_ = -(_e912);
                        } else {
                            phi_2150_ = _e912;
                        }
                        let _e1225 = phi_2150_;
                        if (_e913 < 0f) {
                            phi_2156_ = -(_e913);
                        } else {
                            phi_2156_ = _e913;
                        }
                        let _e1229 = phi_2156_;
                        if (_e914 < 0f) {
                            phi_2163_ = -(_e914);
                        } else {
                            phi_2163_ = _e914;
                        }
                        let _e1234 = phi_2163_;
                        let _e1237 = local.member_5;
                        let _e1239 = local.member_4;
                        if (_e1221 < 0f) {
                            phi_2177_ = -(_e1221);
                        } else {
                            phi_2177_ = _e1221;
                        }
                        let _e1246 = phi_2177_;
                        if (_e1246 > (_e1119 + (((_e1225 + _e1229) + _e1234) * (_e1237 / _e1239)))) {
                            if (_e1221 < 0f) {
                                phi_2191_ = array<f32, 3>(_e1213, _e1214, _e1215);
                            } else {
                                let _e1249 = -(1f);
                                phi_2191_ = array<f32, 3>((_e1213 * _e1249), (_e1214 * _e1249), (_e1215 * _e1249));
                            }
                            let _e1255 = phi_2191_;
                            phi_2192_ = _e1255;
                            phi_2193_ = false;
                        } else {
                            phi_2192_ = array<f32, 3>();
                            phi_2193_ = true;
                        }
                        let _e1257 = phi_2192_;
                        let _e1259 = phi_2193_;
                        phi_2194_ = _e1257;
                        phi_2195_ = _e1259;
                    } else {
                        phi_2194_ = array<f32, 3>();
                        phi_2195_ = true;
                    }
                    let _e1261 = phi_2194_;
                    let _e1263 = phi_2195_;
                    if _e1263 {
                        if _e945 {
                            if _e942 {
                                phi_2205_ = false;
                            } else {
                                phi_2205_ = true;
                            }
                            let _e1265 = phi_2205_;
                            phi_2206_ = _e1265;
                        } else {
                            phi_2206_ = true;
                        }
                        let _e1267 = phi_2206_;
                        if _e1267 {
                            if _e926 {
                                if _e921 {
                                    if _e925 {
                                        let _e1269 = local.member_2;
                                        let _e1274 = local.member_1;
                                        phi_2241_ = array<f32, 3>((_e1269[0] - _e1274[0]), (_e1269[1] - _e1274[1]), (_e1269[2] - _e1274[2]));
                                        phi_2242_ = false;
                                    } else {
                                        phi_2241_ = array<f32, 3>();
                                        phi_2242_ = true;
                                    }
                                    let _e1283 = phi_2241_;
                                    let _e1285 = phi_2242_;
                                    phi_2243_ = _e1283;
                                    phi_2244_ = _e1285;
                                } else {
                                    phi_2243_ = array<f32, 3>();
                                    phi_2244_ = true;
                                }
                                let _e1287 = phi_2243_;
                                let _e1289 = phi_2244_;
                                phi_2245_ = _e1287;
                                phi_2246_ = _e1289;
                            } else {
                                phi_2245_ = array<f32, 3>();
                                phi_2246_ = true;
                            }
                            let _e1291 = phi_2245_;
                            let _e1293 = phi_2246_;
                            if _e1293 {
                                if _e921 {
                                    if _e925 {
                                        let _e1295 = local.member_2;
                                        if (_e1295[0] < 0f) {
                                            phi_2268_ = -(_e1295[0]);
                                        } else {
                                            phi_2268_ = _e1295[0];
                                        }
                                        let _e1302 = phi_2268_;
                                        if (_e1295[1] < 0f) {
                                            phi_2275_ = -(_e1295[1]);
                                        } else {
                                            phi_2275_ = _e1295[1];
                                        }
                                        let _e1306 = phi_2275_;
                                        if (_e1302 > _e1306) {
                                            phi_2280_ = _e1302;
                                        } else {
                                            phi_2280_ = _e1306;
                                        }
                                        let _e1309 = phi_2280_;
                                        if (_e1295[2] < 0f) {
                                            phi_2287_ = -(_e1295[2]);
                                        } else {
                                            phi_2287_ = _e1295[2];
                                        }
                                        let _e1313 = phi_2287_;
                                        if (_e1309 > _e1313) {
                                            phi_2292_ = _e1309;
                                        } else {
                                            phi_2292_ = _e1313;
                                        }
                                        let _e1316 = phi_2292_;
                                        let _e1318 = local.member_1;
                                        if (_e1318[0] < 0f) {
                                            phi_2305_ = -(_e1318[0]);
                                        } else {
                                            phi_2305_ = _e1318[0];
                                        }
                                        let _e1325 = phi_2305_;
                                        if (_e1318[1] < 0f) {
                                            phi_2312_ = -(_e1318[1]);
                                        } else {
                                            phi_2312_ = _e1318[1];
                                        }
                                        let _e1329 = phi_2312_;
                                        if (_e1325 > _e1329) {
                                            phi_2317_ = _e1325;
                                        } else {
                                            phi_2317_ = _e1329;
                                        }
                                        let _e1332 = phi_2317_;
                                        if (_e1318[2] < 0f) {
                                            phi_2324_ = -(_e1318[2]);
                                        } else {
                                            phi_2324_ = _e1318[2];
                                        }
                                        let _e1336 = phi_2324_;
                                        if (_e1332 > _e1336) {
                                            phi_2329_ = _e1332;
                                        } else {
                                            phi_2329_ = _e1336;
                                        }
                                        let _e1339 = phi_2329_;
                                        if (_e1316 > _e1339) {
                                            phi_2334_ = false;
                                        } else {
                                            phi_2334_ = true;
                                        }
                                        let _e1342 = phi_2334_;
                                        phi_2335_ = _e1342;
                                    } else {
                                        phi_2335_ = true;
                                    }
                                    let _e1344 = phi_2335_;
                                    if _e1344 {
                                        let _e1346 = local.member_1;
                                        phi_2345_ = array<f32, 3>(_e1346[0], _e1346[1], _e1346[2]);
                                        phi_2346_ = false;
                                    } else {
                                        phi_2345_ = array<f32, 3>();
                                        phi_2346_ = true;
                                    }
                                    let _e1352 = phi_2345_;
                                    let _e1354 = phi_2346_;
                                    phi_2347_ = _e1352;
                                    phi_2348_ = _e1354;
                                } else {
                                    phi_2347_ = array<f32, 3>();
                                    phi_2348_ = true;
                                }
                                let _e1356 = phi_2347_;
                                let _e1358 = phi_2348_;
                                if _e1358 {
                                    if _e925 {
                                        let _e1360 = local.member_2;
                                        phi_2362_ = array<f32, 3>(_e1360[0], _e1360[1], _e1360[2]);
                                    } else {
                                        phi_2362_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e1366 = phi_2362_;
                                    phi_2363_ = _e1366;
                                } else {
                                    phi_2363_ = _e1356;
                                }
                                let _e1368 = phi_2363_;
                                phi_2364_ = _e1368;
                            } else {
                                phi_2364_ = _e1291;
                            }
                            let _e1370 = phi_2364_;
                            if (_e1370[0] < 0f) {
                                phi_2371_ = -(_e1370[0]);
                            } else {
                                phi_2371_ = _e1370[0];
                            }
                            let _e1375 = phi_2371_;
                            if (_e1370[1] < 0f) {
                                phi_2378_ = -(_e1370[1]);
                            } else {
                                phi_2378_ = _e1370[1];
                            }
                            let _e1380 = phi_2378_;
                            if (_e1375 > _e1380) {
                                phi_2383_ = _e1375;
                            } else {
                                phi_2383_ = _e1380;
                            }
                            let _e1383 = phi_2383_;
                            if (_e1370[2] < 0f) {
                                phi_2390_ = -(_e1370[2]);
                            } else {
                                phi_2390_ = _e1370[2];
                            }
                            let _e1388 = phi_2390_;
                            if (_e1383 > _e1388) {
                                phi_2395_ = _e1383;
                            } else {
                                phi_2395_ = _e1388;
                            }
                            let _e1391 = phi_2395_;
                            if (_e1391 > 0f) {
                                if (_e1370[0] < 0f) {
                                    phi_2406_ = -(_e1370[0]);
                                } else {
                                    phi_2406_ = _e1370[0];
                                }
                                let _e1397 = phi_2406_;
                                if (_e1370[1] < 0f) {
                                    phi_2413_ = -(_e1370[1]);
                                } else {
                                    phi_2413_ = _e1370[1];
                                }
                                let _e1402 = phi_2413_;
                                if (_e1397 > _e1402) {
                                    phi_2418_ = _e1397;
                                } else {
                                    phi_2418_ = _e1402;
                                }
                                let _e1405 = phi_2418_;
                                if (_e1370[2] < 0f) {
                                    phi_2425_ = -(_e1370[2]);
                                } else {
                                    phi_2425_ = _e1370[2];
                                }
                                let _e1410 = phi_2425_;
                                if (_e1405 > _e1410) {
                                    phi_2430_ = _e1405;
                                } else {
                                    phi_2430_ = _e1410;
                                }
                                let _e1413 = phi_2430_;
                                let _e1414 = function_8(_e1413);
                                let _e1416 = (_e1370[0] * _e1414);
                                let _e1418 = (_e1370[1] * _e1414);
                                let _e1420 = (_e1370[2] * _e1414);
                                let _e1425 = (((_e1416 * _e1416) + (_e1418 * _e1418)) + (_e1420 * _e1420));
                                if (_e1425 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e1425 > 0f) {
                                        phi_2456_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_2456_ = 0f;
                                    }
                                    let _e1478 = phi_2456_;
                                    phi_2520_ = _e1478;
                                } else {
                                    phi_2463_ = type_14(0i, 5i);
                                    phi_2466_ = bitcast<f32>(((bitcast<u32>(_e1425) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1433 = phi_2463_;
                                        let _e1435 = phi_2466_;
                                        local_6 = _e1435;
                                        if (_e1433.member < _e1433.member_1) {
                                            let _e1442 = (_e1433.member + 1i);
                                            if ((false == (_e1442 > _e1433.member)) != false) {
                                                phi_2487_ = true;
                                            } else {
                                                phi_2487_ = false;
                                            }
                                            let _e1447 = phi_2487_;
                                            if _e1447 {
                                                phi_2493_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_2493_ = type_15(1u, _e1442);
                                            }
                                            let _e1452 = phi_2493_;
                                            phi_2464_ = type_14(_e1452.member_1, _e1433.member_1);
                                            phi_2507_ = type_15(1u, _e1433.member);
                                        } else {
                                            phi_2464_ = _e1433;
                                            phi_2507_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1458 = phi_2464_;
                                        let _e1460 = phi_2507_;
                                        let _e1463 = (bitcast<i32>(_e1460.member) != 0i);
                                        if _e1463 {
                                            phi_2467_ = (0.5f * (_e1435 + (_e1425 / _e1435)));
                                        } else {
                                            phi_2467_ = f32();
                                        }
                                        let _e1468 = phi_2467_;
                                        continue;
                                        continuing {
                                            phi_2463_ = _e1458;
                                            phi_2466_ = _e1468;
                                            break if !(_e1463);
                                        }
                                    }
                                    let _e1473 = local_6;
                                    phi_2520_ = (_e1473 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1480 = phi_2520_;
                                let _e1481 = (1f / _e1480);
                                let _e1482 = (_e1416 * _e1481);
                                let _e1483 = (_e1418 * _e1481);
                                let _e1484 = (_e1420 * _e1481);
                                let _e1491 = ((3f - (((_e1482 * _e1482) + (_e1483 * _e1483)) + (_e1484 * _e1484))) * 0.5f);
                                let _e1492 = (_e1482 * _e1491);
                                let _e1493 = (_e1483 * _e1491);
                                let _e1494 = (_e1484 * _e1491);
                                let _e1499 = (((_e912 * _e1492) + (_e913 * _e1493)) + (_e914 * _e1494));
                                phi_2547_ = array<f32, 3>((_e912 - (_e1492 * _e1499)), (_e913 - (_e1493 * _e1499)), (_e914 - (_e1494 * _e1499)));
                            } else {
                                phi_2547_ = array<f32, 3>(_e912, _e913, _e914);
                            }
                            let _e1508 = phi_2547_;
                            if (_e1508[0] < 0f) {
                                phi_2554_ = -(_e1508[0]);
                            } else {
                                phi_2554_ = _e1508[0];
                            }
                            let _e1513 = phi_2554_;
                            if (_e1508[1] < 0f) {
                                phi_2561_ = -(_e1508[1]);
                            } else {
                                phi_2561_ = _e1508[1];
                            }
                            let _e1518 = phi_2561_;
                            if (_e1508[2] < 0f) {
                                phi_2569_ = -(_e1508[2]);
                            } else {
                                phi_2569_ = _e1508[2];
                            }
                            let _e1524 = phi_2569_;
                            if (((_e1513 + _e1518) + _e1524) > _e1119) {
                                let _e1527 = -(1f);
                                let _e1529 = (_e1508[0] * _e1527);
                                let _e1531 = (_e1508[1] * _e1527);
                                let _e1533 = (_e1508[2] * _e1527);
                                if (_e1529 < 0f) {
                                    phi_2587_ = -(_e1529);
                                } else {
                                    phi_2587_ = _e1529;
                                }
                                let _e1537 = phi_2587_;
                                if (_e1531 < 0f) {
                                    phi_2593_ = -(_e1531);
                                } else {
                                    phi_2593_ = _e1531;
                                }
                                let _e1541 = phi_2593_;
                                if (_e1537 > _e1541) {
                                    phi_2598_ = _e1537;
                                } else {
                                    phi_2598_ = _e1541;
                                }
                                let _e1544 = phi_2598_;
                                if (_e1533 < 0f) {
                                    phi_2604_ = -(_e1533);
                                } else {
                                    phi_2604_ = _e1533;
                                }
                                let _e1548 = phi_2604_;
                                if (_e1544 > _e1548) {
                                    phi_2609_ = _e1544;
                                } else {
                                    phi_2609_ = _e1548;
                                }
                                let _e1551 = phi_2609_;
                                let _e1552 = function_8(_e1551);
                                let _e1553 = (_e1529 * _e1552);
                                let _e1554 = (_e1531 * _e1552);
                                let _e1555 = (_e1533 * _e1552);
                                let _e1560 = (((_e1553 * _e1553) + (_e1554 * _e1554)) + (_e1555 * _e1555));
                                if (_e1560 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e1560 > 0f) {
                                        phi_2632_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_2632_ = 0f;
                                    }
                                    let _e1613 = phi_2632_;
                                    phi_2696_ = _e1613;
                                } else {
                                    phi_2639_ = type_14(0i, 5i);
                                    phi_2642_ = bitcast<f32>(((bitcast<u32>(_e1560) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1568 = phi_2639_;
                                        let _e1570 = phi_2642_;
                                        local_7 = _e1570;
                                        if (_e1568.member < _e1568.member_1) {
                                            let _e1577 = (_e1568.member + 1i);
                                            if ((false == (_e1577 > _e1568.member)) != false) {
                                                phi_2663_ = true;
                                            } else {
                                                phi_2663_ = false;
                                            }
                                            let _e1582 = phi_2663_;
                                            if _e1582 {
                                                phi_2669_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_2669_ = type_15(1u, _e1577);
                                            }
                                            let _e1587 = phi_2669_;
                                            phi_2640_ = type_14(_e1587.member_1, _e1568.member_1);
                                            phi_2683_ = type_15(1u, _e1568.member);
                                        } else {
                                            phi_2640_ = _e1568;
                                            phi_2683_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1593 = phi_2640_;
                                        let _e1595 = phi_2683_;
                                        let _e1598 = (bitcast<i32>(_e1595.member) != 0i);
                                        if _e1598 {
                                            phi_2643_ = (0.5f * (_e1570 + (_e1560 / _e1570)));
                                        } else {
                                            phi_2643_ = f32();
                                        }
                                        let _e1603 = phi_2643_;
                                        continue;
                                        continuing {
                                            phi_2639_ = _e1593;
                                            phi_2642_ = _e1603;
                                            break if !(_e1598);
                                        }
                                    }
                                    let _e1608 = local_7;
                                    phi_2696_ = (_e1608 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1615 = phi_2696_;
                                let _e1616 = (1f / _e1615);
                                let _e1617 = (_e1553 * _e1616);
                                let _e1618 = (_e1554 * _e1616);
                                let _e1619 = (_e1555 * _e1616);
                                let _e1626 = ((3f - (((_e1617 * _e1617) + (_e1618 * _e1618)) + (_e1619 * _e1619))) * 0.5f);
                                phi_2712_ = array<f32, 3>((_e1617 * _e1626), (_e1618 * _e1626), (_e1619 * _e1626));
                                phi_2713_ = false;
                            } else {
                                phi_2712_ = array<f32, 3>();
                                phi_2713_ = true;
                            }
                            let _e1632 = phi_2712_;
                            let _e1634 = phi_2713_;
                            phi_2714_ = _e1632;
                            phi_2715_ = _e1634;
                        } else {
                            phi_2714_ = array<f32, 3>();
                            phi_2715_ = true;
                        }
                        let _e1636 = phi_2714_;
                        let _e1638 = phi_2715_;
                        if _e1638 {
                            if _e945 {
                                if (_e951 < 0f) {
                                    phi_2727_ = -(_e951);
                                } else {
                                    phi_2727_ = _e951;
                                }
                                let _e1961 = phi_2727_;
                                if (_e952 < 0f) {
                                    phi_2733_ = -(_e952);
                                } else {
                                    phi_2733_ = _e952;
                                }
                                let _e1965 = phi_2733_;
                                if (_e1961 > _e1965) {
                                    phi_2738_ = _e1961;
                                } else {
                                    phi_2738_ = _e1965;
                                }
                                let _e1968 = phi_2738_;
                                if (_e953 < 0f) {
                                    phi_2744_ = -(_e953);
                                } else {
                                    phi_2744_ = _e953;
                                }
                                let _e1972 = phi_2744_;
                                if (_e1968 > _e1972) {
                                    phi_2749_ = _e1968;
                                } else {
                                    phi_2749_ = _e1972;
                                }
                                let _e1975 = phi_2749_;
                                let _e1976 = function_8(_e1975);
                                let _e1977 = (_e951 * _e1976);
                                let _e1978 = (_e952 * _e1976);
                                let _e1979 = (_e953 * _e1976);
                                let _e1984 = (((_e1977 * _e1977) + (_e1978 * _e1978)) + (_e1979 * _e1979));
                                if (_e1984 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e1984 > 0f) {
                                        phi_2772_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_2772_ = 0f;
                                    }
                                    let _e2037 = phi_2772_;
                                    phi_2836_ = _e2037;
                                } else {
                                    phi_2779_ = type_14(0i, 5i);
                                    phi_2782_ = bitcast<f32>(((bitcast<u32>(_e1984) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1992 = phi_2779_;
                                        let _e1994 = phi_2782_;
                                        local_10 = _e1994;
                                        if (_e1992.member < _e1992.member_1) {
                                            let _e2001 = (_e1992.member + 1i);
                                            if ((false == (_e2001 > _e1992.member)) != false) {
                                                phi_2803_ = true;
                                            } else {
                                                phi_2803_ = false;
                                            }
                                            let _e2006 = phi_2803_;
                                            if _e2006 {
                                                phi_2809_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_2809_ = type_15(1u, _e2001);
                                            }
                                            let _e2011 = phi_2809_;
                                            phi_2780_ = type_14(_e2011.member_1, _e1992.member_1);
                                            phi_2823_ = type_15(1u, _e1992.member);
                                        } else {
                                            phi_2780_ = _e1992;
                                            phi_2823_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2017 = phi_2780_;
                                        let _e2019 = phi_2823_;
                                        let _e2022 = (bitcast<i32>(_e2019.member) != 0i);
                                        if _e2022 {
                                            phi_2783_ = (0.5f * (_e1994 + (_e1984 / _e1994)));
                                        } else {
                                            phi_2783_ = f32();
                                        }
                                        let _e2027 = phi_2783_;
                                        continue;
                                        continuing {
                                            phi_2779_ = _e2017;
                                            phi_2782_ = _e2027;
                                            break if !(_e2022);
                                        }
                                    }
                                    let _e2032 = local_10;
                                    phi_2836_ = (_e2032 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2039 = phi_2836_;
                                let _e2040 = (1f / _e2039);
                                let _e2041 = (_e1977 * _e2040);
                                let _e2042 = (_e1978 * _e2040);
                                let _e2043 = (_e1979 * _e2040);
                                let _e2050 = ((3f - (((_e2041 * _e2041) + (_e2042 * _e2042)) + (_e2043 * _e2043))) * 0.5f);
                                phi_3293_ = array<f32, 3>((_e2041 * _e2050), (_e2042 * _e2050), (_e2043 * _e2050));
                            } else {
                                let _e1640 = local.member_1;
                                let _e1646 = local.member_2;
                                if (_e1646[0] < 0f) {
                                    phi_2870_ = -(_e1646[0]);
                                } else {
                                    phi_2870_ = _e1646[0];
                                }
                                let _e1654 = phi_2870_;
                                if (_e1646[1] < 0f) {
                                    phi_2877_ = -(_e1646[1]);
                                } else {
                                    phi_2877_ = _e1646[1];
                                }
                                let _e1658 = phi_2877_;
                                if (_e1654 > _e1658) {
                                    phi_2882_ = _e1654;
                                } else {
                                    phi_2882_ = _e1658;
                                }
                                let _e1661 = phi_2882_;
                                if (_e1646[2] < 0f) {
                                    phi_2889_ = -(_e1646[2]);
                                } else {
                                    phi_2889_ = _e1646[2];
                                }
                                let _e1665 = phi_2889_;
                                if (_e1661 > _e1665) {
                                    phi_2894_ = _e1661;
                                } else {
                                    phi_2894_ = _e1665;
                                }
                                let _e1668 = phi_2894_;
                                if (_e1640[0] < 0f) {
                                    phi_2901_ = -(_e1640[0]);
                                } else {
                                    phi_2901_ = _e1640[0];
                                }
                                let _e1672 = phi_2901_;
                                if (_e1640[1] < 0f) {
                                    phi_2908_ = -(_e1640[1]);
                                } else {
                                    phi_2908_ = _e1640[1];
                                }
                                let _e1676 = phi_2908_;
                                if (_e1672 > _e1676) {
                                    phi_2913_ = _e1672;
                                } else {
                                    phi_2913_ = _e1676;
                                }
                                let _e1679 = phi_2913_;
                                if (_e1640[2] < 0f) {
                                    phi_2920_ = -(_e1640[2]);
                                } else {
                                    phi_2920_ = _e1640[2];
                                }
                                let _e1683 = phi_2920_;
                                if (_e1679 > _e1683) {
                                    phi_2925_ = _e1679;
                                } else {
                                    phi_2925_ = _e1683;
                                }
                                let _e1686 = phi_2925_;
                                if (_e1668 > _e1686) {
                                    phi_2930_ = array<f32, 3>(_e1646[0], _e1646[1], _e1646[2]);
                                } else {
                                    phi_2930_ = array<f32, 3>(_e1640[0], _e1640[1], _e1640[2]);
                                }
                                let _e1689 = phi_2930_;
                                if (_e1689[0] < 0f) {
                                    phi_2937_ = -(_e1689[0]);
                                } else {
                                    phi_2937_ = _e1689[0];
                                }
                                let _e1694 = phi_2937_;
                                if (_e1689[1] < 0f) {
                                    phi_2944_ = -(_e1689[1]);
                                } else {
                                    phi_2944_ = _e1689[1];
                                }
                                let _e1699 = phi_2944_;
                                if (_e1694 > _e1699) {
                                    phi_2949_ = _e1694;
                                } else {
                                    phi_2949_ = _e1699;
                                }
                                let _e1702 = phi_2949_;
                                if (_e1689[2] < 0f) {
                                    phi_2956_ = -(_e1689[2]);
                                } else {
                                    phi_2956_ = _e1689[2];
                                }
                                let _e1707 = phi_2956_;
                                if (_e1702 > _e1707) {
                                    phi_2961_ = _e1702;
                                } else {
                                    phi_2961_ = _e1707;
                                }
                                let _e1710 = phi_2961_;
                                if (_e1710 > 0f) {
                                    if (_e1689[0] < 0f) {
                                        phi_2972_ = -(_e1689[0]);
                                    } else {
                                        phi_2972_ = _e1689[0];
                                    }
                                    let _e1716 = phi_2972_;
                                    if (_e1689[1] < 0f) {
                                        phi_2979_ = -(_e1689[1]);
                                    } else {
                                        phi_2979_ = _e1689[1];
                                    }
                                    let _e1721 = phi_2979_;
                                    if (_e1689[2] < 0f) {
                                        phi_2986_ = -(_e1689[2]);
                                    } else {
                                        phi_2986_ = _e1689[2];
                                    }
                                    let _e1726 = phi_2986_;
                                    if (_e1716 <= _e1721) {
                                        if (_e1716 <= _e1726) {
                                            phi_2996_ = array<f32, 3>(1f, 0f, 0f);
                                            phi_2997_ = false;
                                        } else {
                                            phi_2996_ = array<f32, 3>();
                                            phi_2997_ = true;
                                        }
                                        let _e1730 = phi_2996_;
                                        let _e1732 = phi_2997_;
                                        phi_2998_ = _e1730;
                                        phi_2999_ = _e1732;
                                    } else {
                                        phi_2998_ = array<f32, 3>();
                                        phi_2999_ = true;
                                    }
                                    let _e1734 = phi_2998_;
                                    let _e1736 = phi_2999_;
                                    if _e1736 {
                                        if (_e1721 <= _e1726) {
                                            phi_3009_ = array<f32, 3>(0f, 1f, 0f);
                                        } else {
                                            phi_3009_ = array<f32, 3>(0f, 0f, 1f);
                                        }
                                        let _e1739 = phi_3009_;
                                        phi_3010_ = _e1739;
                                    } else {
                                        phi_3010_ = _e1734;
                                    }
                                    let _e1741 = phi_3010_;
                                    if (_e1689[0] < 0f) {
                                        phi_3017_ = -(_e1689[0]);
                                    } else {
                                        phi_3017_ = _e1689[0];
                                    }
                                    let _e1746 = phi_3017_;
                                    if (_e1689[1] < 0f) {
                                        phi_3024_ = -(_e1689[1]);
                                    } else {
                                        phi_3024_ = _e1689[1];
                                    }
                                    let _e1751 = phi_3024_;
                                    if (_e1746 > _e1751) {
                                        phi_3029_ = _e1746;
                                    } else {
                                        phi_3029_ = _e1751;
                                    }
                                    let _e1754 = phi_3029_;
                                    if (_e1689[2] < 0f) {
                                        phi_3036_ = -(_e1689[2]);
                                    } else {
                                        phi_3036_ = _e1689[2];
                                    }
                                    let _e1759 = phi_3036_;
                                    if (_e1754 > _e1759) {
                                        phi_3041_ = _e1754;
                                    } else {
                                        phi_3041_ = _e1759;
                                    }
                                    let _e1762 = phi_3041_;
                                    let _e1763 = function_8(_e1762);
                                    let _e1765 = (_e1689[0] * _e1763);
                                    let _e1767 = (_e1689[1] * _e1763);
                                    let _e1769 = (_e1689[2] * _e1763);
                                    let _e1774 = (((_e1765 * _e1765) + (_e1767 * _e1767)) + (_e1769 * _e1769));
                                    if (_e1774 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1774 > 0f) {
                                            phi_3067_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3067_ = 0f;
                                        }
                                        let _e1827 = phi_3067_;
                                        phi_3131_ = _e1827;
                                    } else {
                                        phi_3074_ = type_14(0i, 5i);
                                        phi_3077_ = bitcast<f32>(((bitcast<u32>(_e1774) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1782 = phi_3074_;
                                            let _e1784 = phi_3077_;
                                            local_8 = _e1784;
                                            if (_e1782.member < _e1782.member_1) {
                                                let _e1791 = (_e1782.member + 1i);
                                                if ((false == (_e1791 > _e1782.member)) != false) {
                                                    phi_3098_ = true;
                                                } else {
                                                    phi_3098_ = false;
                                                }
                                                let _e1796 = phi_3098_;
                                                if _e1796 {
                                                    phi_3104_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_3104_ = type_15(1u, _e1791);
                                                }
                                                let _e1801 = phi_3104_;
                                                phi_3075_ = type_14(_e1801.member_1, _e1782.member_1);
                                                phi_3118_ = type_15(1u, _e1782.member);
                                            } else {
                                                phi_3075_ = _e1782;
                                                phi_3118_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1807 = phi_3075_;
                                            let _e1809 = phi_3118_;
                                            let _e1812 = (bitcast<i32>(_e1809.member) != 0i);
                                            if _e1812 {
                                                phi_3078_ = (0.5f * (_e1784 + (_e1774 / _e1784)));
                                            } else {
                                                phi_3078_ = f32();
                                            }
                                            let _e1817 = phi_3078_;
                                            continue;
                                            continuing {
                                                phi_3074_ = _e1807;
                                                phi_3077_ = _e1817;
                                                break if !(_e1812);
                                            }
                                        }
                                        let _e1822 = local_8;
                                        phi_3131_ = (_e1822 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1829 = phi_3131_;
                                    let _e1830 = (1f / _e1829);
                                    let _e1831 = (_e1765 * _e1830);
                                    let _e1832 = (_e1767 * _e1830);
                                    let _e1833 = (_e1769 * _e1830);
                                    let _e1840 = ((3f - (((_e1831 * _e1831) + (_e1832 * _e1832)) + (_e1833 * _e1833))) * 0.5f);
                                    let _e1841 = (_e1831 * _e1840);
                                    let _e1842 = (_e1832 * _e1840);
                                    let _e1843 = (_e1833 * _e1840);
                                    let _e1848 = ((_e1842 * _e1741[2]) - (_e1843 * _e1741[1]));
                                    let _e1853 = ((_e1843 * _e1741[0]) - (_e1841 * _e1741[2]));
                                    let _e1858 = ((_e1841 * _e1741[1]) - (_e1842 * _e1741[0]));
                                    if (_e1848 < 0f) {
                                        phi_3166_ = -(_e1848);
                                    } else {
                                        phi_3166_ = _e1848;
                                    }
                                    let _e1862 = phi_3166_;
                                    if (_e1853 < 0f) {
                                        phi_3172_ = -(_e1853);
                                    } else {
                                        phi_3172_ = _e1853;
                                    }
                                    let _e1866 = phi_3172_;
                                    if (_e1862 > _e1866) {
                                        phi_3177_ = _e1862;
                                    } else {
                                        phi_3177_ = _e1866;
                                    }
                                    let _e1869 = phi_3177_;
                                    if (_e1858 < 0f) {
                                        phi_3183_ = -(_e1858);
                                    } else {
                                        phi_3183_ = _e1858;
                                    }
                                    let _e1873 = phi_3183_;
                                    if (_e1869 > _e1873) {
                                        phi_3188_ = _e1869;
                                    } else {
                                        phi_3188_ = _e1873;
                                    }
                                    let _e1876 = phi_3188_;
                                    let _e1877 = function_8(_e1876);
                                    let _e1878 = (_e1848 * _e1877);
                                    let _e1879 = (_e1853 * _e1877);
                                    let _e1880 = (_e1858 * _e1877);
                                    let _e1885 = (((_e1878 * _e1878) + (_e1879 * _e1879)) + (_e1880 * _e1880));
                                    if (_e1885 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1885 > 0f) {
                                            phi_3211_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3211_ = 0f;
                                        }
                                        let _e1938 = phi_3211_;
                                        phi_3275_ = _e1938;
                                    } else {
                                        phi_3218_ = type_14(0i, 5i);
                                        phi_3221_ = bitcast<f32>(((bitcast<u32>(_e1885) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1893 = phi_3218_;
                                            let _e1895 = phi_3221_;
                                            local_9 = _e1895;
                                            if (_e1893.member < _e1893.member_1) {
                                                let _e1902 = (_e1893.member + 1i);
                                                if ((false == (_e1902 > _e1893.member)) != false) {
                                                    phi_3242_ = true;
                                                } else {
                                                    phi_3242_ = false;
                                                }
                                                let _e1907 = phi_3242_;
                                                if _e1907 {
                                                    phi_3248_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_3248_ = type_15(1u, _e1902);
                                                }
                                                let _e1912 = phi_3248_;
                                                phi_3219_ = type_14(_e1912.member_1, _e1893.member_1);
                                                phi_3262_ = type_15(1u, _e1893.member);
                                            } else {
                                                phi_3219_ = _e1893;
                                                phi_3262_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1918 = phi_3219_;
                                            let _e1920 = phi_3262_;
                                            let _e1923 = (bitcast<i32>(_e1920.member) != 0i);
                                            if _e1923 {
                                                phi_3222_ = (0.5f * (_e1895 + (_e1885 / _e1895)));
                                            } else {
                                                phi_3222_ = f32();
                                            }
                                            let _e1928 = phi_3222_;
                                            continue;
                                            continuing {
                                                phi_3218_ = _e1918;
                                                phi_3221_ = _e1928;
                                                break if !(_e1923);
                                            }
                                        }
                                        let _e1933 = local_9;
                                        phi_3275_ = (_e1933 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1940 = phi_3275_;
                                    let _e1941 = (1f / _e1940);
                                    let _e1942 = (_e1878 * _e1941);
                                    let _e1943 = (_e1879 * _e1941);
                                    let _e1944 = (_e1880 * _e1941);
                                    let _e1951 = ((3f - (((_e1942 * _e1942) + (_e1943 * _e1943)) + (_e1944 * _e1944))) * 0.5f);
                                    phi_3292_ = array<f32, 3>((_e1942 * _e1951), (_e1943 * _e1951), (_e1944 * _e1951));
                                } else {
                                    phi_3292_ = array<f32, 3>(1f, 0f, 0f);
                                }
                                let _e1957 = phi_3292_;
                                phi_3293_ = _e1957;
                            }
                            let _e2056 = phi_3293_;
                            phi_3294_ = _e2056;
                            phi_3295_ = false;
                        } else {
                            phi_3294_ = array<f32, 3>();
                            phi_3295_ = true;
                        }
                        let _e2058 = phi_3294_;
                        let _e2060 = phi_3295_;
                        phi_3296_ = _e2058;
                        phi_3297_ = _e1636;
                        phi_3298_ = _e2060;
                    } else {
                        phi_3296_ = array<f32, 3>();
                        phi_3297_ = _e1261;
                        phi_3298_ = true;
                    }
                    let _e2062 = phi_3296_;
                    let _e2064 = phi_3297_;
                    let _e2066 = phi_3298_;
                    phi_3302_ = _e2064;
                    phi_3303_ = _e2062;
                    phi_3304_ = _e2066;
                }
                let _e2311 = phi_3302_;
                let _e2313 = phi_3303_;
                let _e2315 = phi_3304_;
                if _e2315 {
                    phi_3308_ = _e2311;
                } else {
                    phi_3308_ = _e2313;
                }
                let _e2317 = phi_3308_;
                if ((((_e2317[0] * _e2317[0]) + (_e2317[1] * _e2317[1])) + (_e2317[2] * _e2317[2])) > 0.5f) {
                    phi_3325_ = _e2317;
                } else {
                    phi_3325_ = array<f32, 3>(1f, 0f, 0f);
                }
                let _e2331 = phi_3325_;
                let _e2334 = function_9(_e263[0], _e264[0], _e258);
                let _e2337 = function_9(_e263[1], _e264[1], _e258);
                let _e2340 = function_9(_e263[2], _e264[2], _e258);
                let _e2343 = function_9(_e263[3], _e264[3], _e258);
                if (_e179.member != 0u) {
                    let _e2380 = function_9(_e2334, _e2337, _e816.member);
                    let _e2381 = function_9(_e2340, _e2343, _e816.member_1);
                    phi_3381_ = _e2381;
                    phi_3382_ = _e2380;
                    phi_3383_ = array<f32, 4>((1f - _e816.member), _e816.member, (1f - _e816.member_1), _e816.member_1);
                } else {
                    let _e2346 = ((1f - _e816.member) - _e816.member_1);
                    if (_e2346 > 0f) {
                        phi_3353_ = _e2346;
                    } else {
                        phi_3353_ = 0f;
                    }
                    let _e2349 = phi_3353_;
                    let _e2376 = function_(array<f32, 4>(1f, _e2349, _e816.member, _e816.member_1), _e262);
                    phi_3381_ = array<f32, 3>((((_e2337[0] * _e2349) + (_e2340[0] * _e816.member)) + (_e2343[0] * _e816.member_1)), (((_e2337[1] * _e2349) + (_e2340[1] * _e816.member)) + (_e2343[1] * _e816.member_1)), (((_e2337[2] * _e2349) + (_e2340[2] * _e816.member)) + (_e2343[2] * _e816.member_1)));
                    phi_3382_ = _e2334;
                    phi_3383_ = _e2376;
                }
                let _e2383 = phi_3381_;
                let _e2385 = phi_3382_;
                let _e2387 = phi_3383_;
                let _e2388 = function_9(_e2385, _e2383, 0.5f);
                let _e2392 = params.member.member_2.member;
                let _e2395 = params.member.member_2.member_1;
                geometry.member[_e140] = type_34(array<f32, 3>(((_e2388[0] * _e2395) + _e2392[0]), ((_e2388[1] * _e2395) + _e2392[1]), ((_e2388[2] * _e2395) + _e2392[2])), ((_e880 / _e506) * _e2395), _e2331, _e147, _e2387, _e179.member_1);
            }
        }
        continue;
        continuing {
            phi_243_ = _e125;
            break if !(_e131);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn contact_geometry(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_12(id, n, lane);
}
