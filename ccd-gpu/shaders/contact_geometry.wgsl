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
    var phi_4373_: array<f32, 4>;

    switch bitcast<i32>(param_1) {
        case 0: {
            phi_4373_ = param;
            break;
        }
        case 1: {
            phi_4373_ = array<f32, 4>(param[0], param[3], param[1], param[2]);
            break;
        }
        default: {
            phi_4373_ = array<f32, 4>(param[0], param[2], param[3], param[1]);
            break;
        }
    }
    let _e14 = phi_4373_;
    return _e14;
}

fn function_1(param_2: array<array<f32, 3>, 2>) -> array<f32, 3> {
    return array<f32, 3>((param_2[1][0] - param_2[0][0]), (param_2[1][1] - param_2[0][1]), (param_2[1][2] - param_2[0][2]));
}

fn function_2(param_3: type_38, param_4: type_38) -> type_38 {
    var phi_4341_: type_38;

    if (param_4.member_3 < param_3.member_3) {
        phi_4341_ = param_4;
    } else {
        phi_4341_ = param_3;
    }
    let _e6 = phi_4341_;
    return _e6;
}

fn function_3(param_5: f32, param_6: f32) -> f32 {
    var phi_3416_: f32;
    var phi_3421_: f32;
    var phi_3422_: f32;

    if (param_5 > 0f) {
        if (param_5 < param_6) {
            phi_3416_ = param_5;
        } else {
            phi_3416_ = param_6;
        }
        let _e6 = phi_3416_;
        if (_e6 > 0f) {
            phi_3421_ = _e6;
        } else {
            phi_3421_ = 0f;
        }
        let _e9 = phi_3421_;
        phi_3422_ = _e9;
    } else {
        phi_3422_ = 0f;
    }
    let _e11 = phi_3422_;
    return _e11;
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
    var phi_4040_: f32;
    var phi_4047_: f32;
    var phi_4058_: type_38;
    var phi_4059_: bool;
    var phi_4060_: type_38;
    var phi_4061_: bool;
    var phi_3917_: bool;
    var phi_3918_: bool;
    var phi_3934_: f32;
    var phi_3940_: f32;
    var phi_3943_: type_38;
    var phi_3944_: bool;
    var phi_3945_: type_38;
    var phi_3946_: bool;
    var phi_3947_: type_38;
    var phi_3948_: bool;
    var phi_4065_: type_38;
    var phi_4066_: bool;
    var phi_4141_: type_38;
    var phi_4142_: type_38;
    var phi_4143_: bool;
    var phi_4147_: type_38;

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
            phi_3918_ = ((_e133 + _e163) <= 1f);
        } else {
            if (_e133 <= 1f) {
                phi_3917_ = (_e163 <= 1f);
            } else {
                phi_3917_ = false;
            }
            let _e167 = phi_3917_;
            phi_3918_ = _e167;
        }
        let _e171 = phi_3918_;
        if (_e133 >= 0f) {
            if (_e163 >= 0f) {
                if _e171 {
                    if _e9 {
                        phi_3934_ = (1f - _e133);
                    } else {
                        phi_3934_ = 1f;
                    }
                    let _e176 = phi_3934_;
                    let _e177 = function_6(param_16, _e133, _e176);
                    if _e9 {
                        phi_3940_ = (1f - _e177);
                    } else {
                        phi_3940_ = 1f;
                    }
                    let _e180 = phi_3940_;
                    let _e181 = function_4(param_16, _e177, _e180);
                    let _e182 = function_5(param_16, _e181, _e177);
                    phi_3943_ = _e182;
                    phi_3944_ = false;
                } else {
                    phi_3943_ = type_38();
                    phi_3944_ = true;
                }
                let _e184 = phi_3943_;
                let _e186 = phi_3944_;
                phi_3945_ = _e184;
                phi_3946_ = _e186;
            } else {
                phi_3945_ = type_38();
                phi_3946_ = true;
            }
            let _e188 = phi_3945_;
            let _e190 = phi_3946_;
            phi_3947_ = _e188;
            phi_3948_ = _e190;
        } else {
            phi_3947_ = type_38();
            phi_3948_ = true;
        }
        let _e192 = phi_3947_;
        let _e194 = phi_3948_;
        phi_4065_ = _e192;
        phi_4066_ = _e194;
    } else {
        if _e9 {
            phi_4060_ = type_38();
            phi_4061_ = true;
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
                phi_4040_ = _e27;
            } else {
                phi_4040_ = _e50;
            }
            let _e68 = phi_4040_;
            let _e70 = function_3((_e68 / _e65), 1f);
            if (_e27 > _e50) {
                phi_4047_ = _e27;
            } else {
                phi_4047_ = _e50;
            }
            let _e73 = phi_4047_;
            let _e75 = function_3((_e73 / _e65), 1f);
            if (_e70 < _e75) {
                let _e78 = ((_e70 + _e75) * 0.5f);
                let _e79 = function_6(param_16, _e78, 1f);
                let _e80 = function_5(param_16, _e78, _e79);
                phi_4058_ = _e80;
                phi_4059_ = false;
            } else {
                phi_4058_ = type_38();
                phi_4059_ = true;
            }
            let _e82 = phi_4058_;
            let _e84 = phi_4059_;
            phi_4060_ = _e82;
            phi_4061_ = _e84;
        }
        let _e86 = phi_4060_;
        let _e88 = phi_4061_;
        phi_4065_ = _e86;
        phi_4066_ = _e88;
    }
    let _e196 = phi_4065_;
    let _e198 = phi_4066_;
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
            phi_4141_ = _e250;
        } else {
            let _e204 = function_6(param_16, 1f, 1f);
            let _e205 = function_5(param_16, 1f, _e204);
            let _e206 = function_4(param_16, 1f, 1f);
            let _e207 = function_5(param_16, _e206, 1f);
            let _e208 = function_2(_e205, _e207);
            let _e209 = function_2(_e203, _e208);
            phi_4141_ = _e209;
        }
        let _e252 = phi_4141_;
        phi_4142_ = _e252;
        phi_4143_ = false;
    } else {
        phi_4142_ = type_38();
        phi_4143_ = true;
    }
    let _e254 = phi_4142_;
    let _e256 = phi_4143_;
    if _e256 {
        phi_4147_ = _e196;
    } else {
        phi_4147_ = _e254;
    }
    let _e258 = phi_4147_;
    return _e258;
}

fn function_8(param_18: f32) -> f32 {
    var phi_3773_: u32;
    var phi_3776_: f32;
    var phi_3777_: f32;

    if ((bitcast<u32>(param_18) & 2139095040u) != 2139095040u) {
        if (param_18 >= 0.000000000000000000000000000000000000011754944f) {
            let _e13 = (2130706432u - (bitcast<u32>(param_18) & 2139095040u));
            if (_e13 > 8388608u) {
                phi_3773_ = _e13;
            } else {
                phi_3773_ = 8388608u;
            }
            let _e16 = phi_3773_;
            phi_3776_ = bitcast<f32>(_e16);
        } else {
            phi_3776_ = (1f / 0.000000000000000000000000000000000000011754944f);
        }
        let _e19 = phi_3776_;
        phi_3777_ = _e19;
    } else {
        phi_3777_ = 1f;
    }
    let _e21 = phi_3777_;
    return _e21;
}

fn function_9(param_19: array<f32, 3>, param_20: array<f32, 3>, param_21: f32) -> array<f32, 3> {
    let _e4 = (1f - param_21);
    return array<f32, 3>(((param_19[0] * _e4) + (param_20[0] * param_21)), ((param_19[1] * _e4) + (param_20[1] * param_21)), ((param_19[2] * _e4) + (param_20[2] * param_21)));
}

fn function_10(param_22: ptr<function, array<array<f32, 3>, 4>>, param_23: u32) -> array<array<f32, 3>, 4> {
    var phi_3750_: array<array<f32, 3>, 4>;

    switch bitcast<i32>(param_23) {
        case 0: {
            let _e32 = (*param_22);
            phi_3750_ = array<array<f32, 3>, 4>(array<f32, 3>(_e32[0][0], _e32[0][1], _e32[0][2]), array<f32, 3>(_e32[1][0], _e32[1][1], _e32[1][2]), array<f32, 3>(_e32[2][0], _e32[2][1], _e32[2][2]), array<f32, 3>(_e32[3][0], _e32[3][1], _e32[3][2]));
            break;
        }
        case 1: {
            let _e8 = (*param_22)[0u];
            let _e14 = (*param_22)[2u];
            let _e20 = (*param_22)[3u];
            let _e26 = (*param_22)[1u];
            phi_3750_ = array<array<f32, 3>, 4>(array<f32, 3>(_e8[0], _e8[1], _e8[2]), array<f32, 3>(_e14[0], _e14[1], _e14[2]), array<f32, 3>(_e20[0], _e20[1], _e20[2]), array<f32, 3>(_e26[0], _e26[1], _e26[2]));
            break;
        }
        default: {
            let _e55 = (*param_22)[0u];
            let _e61 = (*param_22)[3u];
            let _e67 = (*param_22)[1u];
            let _e73 = (*param_22)[2u];
            phi_3750_ = array<array<f32, 3>, 4>(array<f32, 3>(_e55[0], _e55[1], _e55[2]), array<f32, 3>(_e61[0], _e61[1], _e61[2]), array<f32, 3>(_e67[0], _e67[1], _e67[2]), array<f32, 3>(_e73[0], _e73[1], _e73[2]));
            break;
        }
    }
    let _e80 = phi_3750_;
    return _e80;
}

fn function_11(param_24: ptr<function, array<array<f32, 3>, 4>>, param_25: ptr<function, array<array<f32, 3>, 4>>, param_26: f32) -> u32 {
    var phi_3478_: f32;
    var phi_3485_: f32;
    var phi_3493_: f32;
    var phi_3546_: f32;
    var phi_3553_: f32;
    var phi_3561_: f32;
    var phi_3614_: f32;
    var phi_3621_: f32;
    var phi_3629_: f32;
    var phi_3639_: bool;
    var phi_3640_: bool;
    var phi_3648_: u32;
    var phi_3649_: u32;

    let _e11 = (*param_24)[3u];
    let _e16 = (*param_24)[2u];
    let _e25 = (*param_25)[3u];
    let _e30 = (*param_25)[2u];
    let _e38 = function_9(array<f32, 3>((_e11[0] - _e16[0]), (_e11[1] - _e16[1]), (_e11[2] - _e16[2])), array<f32, 3>((_e25[0] - _e30[0]), (_e25[1] - _e30[1]), (_e25[2] - _e30[2])), param_26);
    if (_e38[0] < 0f) {
        phi_3478_ = -(_e38[0]);
    } else {
        phi_3478_ = _e38[0];
    }
    let _e43 = phi_3478_;
    if (_e38[1] < 0f) {
        phi_3485_ = -(_e38[1]);
    } else {
        phi_3485_ = _e38[1];
    }
    let _e48 = phi_3485_;
    if (_e38[2] < 0f) {
        phi_3493_ = -(_e38[2]);
    } else {
        phi_3493_ = _e38[2];
    }
    let _e54 = phi_3493_;
    let _e55 = ((_e43 + _e48) + _e54);
    let _e57 = (*param_24)[1u];
    let _e62 = (*param_24)[3u];
    let _e71 = (*param_25)[1u];
    let _e76 = (*param_25)[3u];
    let _e84 = function_9(array<f32, 3>((_e57[0] - _e62[0]), (_e57[1] - _e62[1]), (_e57[2] - _e62[2])), array<f32, 3>((_e71[0] - _e76[0]), (_e71[1] - _e76[1]), (_e71[2] - _e76[2])), param_26);
    if (_e84[0] < 0f) {
        phi_3546_ = -(_e84[0]);
    } else {
        phi_3546_ = _e84[0];
    }
    let _e89 = phi_3546_;
    if (_e84[1] < 0f) {
        phi_3553_ = -(_e84[1]);
    } else {
        phi_3553_ = _e84[1];
    }
    let _e94 = phi_3553_;
    if (_e84[2] < 0f) {
        phi_3561_ = -(_e84[2]);
    } else {
        phi_3561_ = _e84[2];
    }
    let _e100 = phi_3561_;
    let _e101 = ((_e89 + _e94) + _e100);
    let _e103 = (*param_24)[2u];
    let _e108 = (*param_24)[1u];
    let _e117 = (*param_25)[2u];
    let _e122 = (*param_25)[1u];
    let _e130 = function_9(array<f32, 3>((_e103[0] - _e108[0]), (_e103[1] - _e108[1]), (_e103[2] - _e108[2])), array<f32, 3>((_e117[0] - _e122[0]), (_e117[1] - _e122[1]), (_e117[2] - _e122[2])), param_26);
    if (_e130[0] < 0f) {
        phi_3614_ = -(_e130[0]);
    } else {
        phi_3614_ = _e130[0];
    }
    let _e135 = phi_3614_;
    if (_e130[1] < 0f) {
        phi_3621_ = -(_e130[1]);
    } else {
        phi_3621_ = _e130[1];
    }
    let _e140 = phi_3621_;
    if (_e130[2] < 0f) {
        phi_3629_ = -(_e130[2]);
    } else {
        phi_3629_ = _e130[2];
    }
    let _e146 = phi_3629_;
    let _e147 = ((_e135 + _e140) + _e146);
    if (_e55 >= _e101) {
        if (_e55 >= _e147) {
            phi_3639_ = false;
        } else {
            phi_3639_ = true;
        }
        let _e151 = phi_3639_;
        phi_3640_ = _e151;
    } else {
        phi_3640_ = true;
    }
    let _e153 = phi_3640_;
    if _e153 {
        if (_e101 >= _e147) {
            phi_3648_ = 1u;
        } else {
            phi_3648_ = 2u;
        }
        let _e156 = phi_3648_;
        phi_3649_ = _e156;
    } else {
        phi_3649_ = 0u;
    }
    let _e158 = phi_3649_;
    return _e158;
}

fn function_12(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var phi_185_: u32;
    var phi_195_: u32;
    var phi_202_: u32;
    var phi_218_: u32;
    var phi_239_: u32;
    var phi_240_: u32;
    var phi_243_: type_9;
    var phi_244_: type_9;
    var phi_267_: type_9;
    var phi_410_: type_23;
    var phi_553_: u32;
    var phi_559_: f32;
    var phi_568_: u32;
    var phi_729_: type_37;
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
    var phi_1105_: f32;
    var phi_1111_: f32;
    var phi_1116_: f32;
    var phi_1122_: f32;
    var phi_1127_: f32;
    var phi_1135_: f32;
    var phi_1141_: f32;
    var phi_1146_: f32;
    var phi_1152_: f32;
    var phi_1157_: f32;
    var phi_1185_: type_14;
    var phi_1188_: f32;
    var phi_1209_: bool;
    var phi_1215_: type_15;
    var phi_1186_: type_14;
    var phi_1229_: type_15;
    var phi_1189_: f32;
    var local_3: f32;
    var phi_1178_: f32;
    var phi_1242_: f32;
    var phi_1250_: f32;
    var phi_1255_: f32;
    var phi_1305_: type_14;
    var phi_1308_: f32;
    var phi_1329_: bool;
    var phi_1335_: type_15;
    var phi_1306_: type_14;
    var phi_1349_: type_15;
    var phi_1309_: f32;
    var local_4: f32;
    var phi_1298_: f32;
    var phi_1362_: f32;
    var phi_1370_: f32;
    var phi_1376_: f32;
    var phi_1415_: bool;
    var phi_1421_: bool;
    var phi_1436_: bool;
    var phi_1437_: bool;
    var phi_1438_: bool;
    var phi_1439_: bool;
    var phi_1440_: bool;
    var phi_1444_: bool;
    var phi_1790_: f32;
    var phi_1797_: f32;
    var phi_1802_: f32;
    var phi_1809_: f32;
    var phi_1814_: f32;
    var phi_1822_: f32;
    var phi_1829_: f32;
    var phi_1834_: f32;
    var phi_1841_: f32;
    var phi_1846_: f32;
    var phi_1851_: f32;
    var phi_1861_: f32;
    var phi_1868_: f32;
    var phi_1873_: f32;
    var phi_1880_: f32;
    var phi_1885_: f32;
    var phi_1893_: f32;
    var phi_1900_: f32;
    var phi_1905_: f32;
    var phi_1912_: f32;
    var phi_1917_: f32;
    var phi_1922_: f32;
    var phi_1932_: f32;
    var phi_1939_: f32;
    var phi_1944_: f32;
    var phi_1951_: f32;
    var phi_1956_: f32;
    var phi_1964_: f32;
    var phi_1971_: f32;
    var phi_1976_: f32;
    var phi_1983_: f32;
    var phi_1988_: f32;
    var phi_1993_: f32;
    var phi_2011_: f32;
    var phi_2017_: f32;
    var phi_2022_: f32;
    var phi_2028_: f32;
    var phi_2033_: f32;
    var phi_2063_: type_14;
    var phi_2066_: f32;
    var phi_2087_: bool;
    var phi_2093_: type_15;
    var phi_2064_: type_14;
    var phi_2107_: type_15;
    var phi_2067_: f32;
    var local_5: f32;
    var phi_2056_: f32;
    var phi_2120_: f32;
    var phi_2146_: f32;
    var phi_2152_: f32;
    var phi_2159_: f32;
    var phi_2173_: f32;
    var phi_2187_: array<f32, 3>;
    var phi_2188_: array<f32, 3>;
    var phi_2189_: bool;
    var phi_2190_: array<f32, 3>;
    var phi_2191_: bool;
    var phi_2201_: bool;
    var phi_2202_: bool;
    var phi_2237_: array<f32, 3>;
    var phi_2238_: bool;
    var phi_2239_: array<f32, 3>;
    var phi_2240_: bool;
    var phi_2241_: array<f32, 3>;
    var phi_2242_: bool;
    var phi_2264_: f32;
    var phi_2271_: f32;
    var phi_2276_: f32;
    var phi_2283_: f32;
    var phi_2288_: f32;
    var phi_2301_: f32;
    var phi_2308_: f32;
    var phi_2313_: f32;
    var phi_2320_: f32;
    var phi_2325_: f32;
    var phi_2330_: bool;
    var phi_2331_: bool;
    var phi_2341_: array<f32, 3>;
    var phi_2342_: bool;
    var phi_2343_: array<f32, 3>;
    var phi_2344_: bool;
    var phi_2358_: array<f32, 3>;
    var phi_2359_: array<f32, 3>;
    var phi_2360_: array<f32, 3>;
    var phi_2367_: f32;
    var phi_2374_: f32;
    var phi_2379_: f32;
    var phi_2386_: f32;
    var phi_2391_: f32;
    var phi_2402_: f32;
    var phi_2409_: f32;
    var phi_2414_: f32;
    var phi_2421_: f32;
    var phi_2426_: f32;
    var phi_2459_: type_14;
    var phi_2462_: f32;
    var phi_2483_: bool;
    var phi_2489_: type_15;
    var phi_2460_: type_14;
    var phi_2503_: type_15;
    var phi_2463_: f32;
    var local_6: f32;
    var phi_2452_: f32;
    var phi_2516_: f32;
    var phi_2543_: array<f32, 3>;
    var phi_2550_: f32;
    var phi_2557_: f32;
    var phi_2565_: f32;
    var phi_2583_: f32;
    var phi_2589_: f32;
    var phi_2594_: f32;
    var phi_2600_: f32;
    var phi_2605_: f32;
    var phi_2635_: type_14;
    var phi_2638_: f32;
    var phi_2659_: bool;
    var phi_2665_: type_15;
    var phi_2636_: type_14;
    var phi_2679_: type_15;
    var phi_2639_: f32;
    var local_7: f32;
    var phi_2628_: f32;
    var phi_2692_: f32;
    var phi_2708_: array<f32, 3>;
    var phi_2709_: bool;
    var phi_2710_: array<f32, 3>;
    var phi_2711_: bool;
    var phi_2866_: f32;
    var phi_2873_: f32;
    var phi_2878_: f32;
    var phi_2885_: f32;
    var phi_2890_: f32;
    var phi_2897_: f32;
    var phi_2904_: f32;
    var phi_2909_: f32;
    var phi_2916_: f32;
    var phi_2921_: f32;
    var phi_2926_: array<f32, 3>;
    var phi_2933_: f32;
    var phi_2940_: f32;
    var phi_2945_: f32;
    var phi_2952_: f32;
    var phi_2957_: f32;
    var phi_2968_: f32;
    var phi_2975_: f32;
    var phi_2982_: f32;
    var phi_2992_: array<f32, 3>;
    var phi_2993_: bool;
    var phi_2994_: array<f32, 3>;
    var phi_2995_: bool;
    var phi_3005_: array<f32, 3>;
    var phi_3006_: array<f32, 3>;
    var phi_3013_: f32;
    var phi_3020_: f32;
    var phi_3025_: f32;
    var phi_3032_: f32;
    var phi_3037_: f32;
    var phi_3070_: type_14;
    var phi_3073_: f32;
    var phi_3094_: bool;
    var phi_3100_: type_15;
    var phi_3071_: type_14;
    var phi_3114_: type_15;
    var phi_3074_: f32;
    var local_8: f32;
    var phi_3063_: f32;
    var phi_3127_: f32;
    var phi_3162_: f32;
    var phi_3168_: f32;
    var phi_3173_: f32;
    var phi_3179_: f32;
    var phi_3184_: f32;
    var phi_3214_: type_14;
    var phi_3217_: f32;
    var phi_3238_: bool;
    var phi_3244_: type_15;
    var phi_3215_: type_14;
    var phi_3258_: type_15;
    var phi_3218_: f32;
    var local_9: f32;
    var phi_3207_: f32;
    var phi_3271_: f32;
    var phi_3288_: array<f32, 3>;
    var phi_2723_: f32;
    var phi_2729_: f32;
    var phi_2734_: f32;
    var phi_2740_: f32;
    var phi_2745_: f32;
    var phi_2775_: type_14;
    var phi_2778_: f32;
    var phi_2799_: bool;
    var phi_2805_: type_15;
    var phi_2776_: type_14;
    var phi_2819_: type_15;
    var phi_2779_: f32;
    var local_10: f32;
    var phi_2768_: f32;
    var phi_2832_: f32;
    var phi_3289_: array<f32, 3>;
    var phi_3290_: array<f32, 3>;
    var phi_3291_: bool;
    var phi_3292_: array<f32, 3>;
    var phi_3293_: array<f32, 3>;
    var phi_3294_: bool;
    var phi_1506_: array<f32, 3>;
    var phi_1513_: f32;
    var phi_1520_: f32;
    var phi_1525_: f32;
    var phi_1532_: f32;
    var phi_1537_: f32;
    var phi_1570_: type_14;
    var phi_1573_: f32;
    var phi_1594_: bool;
    var phi_1600_: type_15;
    var phi_1571_: type_14;
    var phi_1614_: type_15;
    var phi_1574_: f32;
    var local_11: f32;
    var phi_1563_: f32;
    var phi_1627_: f32;
    var phi_1643_: array<f32, 3>;
    var phi_1644_: bool;
    var phi_1645_: array<f32, 3>;
    var phi_1646_: bool;
    var phi_1647_: array<f32, 3>;
    var phi_1648_: bool;
    var phi_1657_: f32;
    var phi_1663_: f32;
    var phi_1668_: f32;
    var phi_1674_: f32;
    var phi_1679_: f32;
    var phi_1709_: type_14;
    var phi_1712_: f32;
    var phi_1733_: bool;
    var phi_1739_: type_15;
    var phi_1710_: type_14;
    var phi_1753_: type_15;
    var phi_1713_: f32;
    var local_12: f32;
    var phi_1702_: f32;
    var phi_1766_: f32;
    var phi_1782_: array<f32, 3>;
    var phi_3298_: array<f32, 3>;
    var phi_3299_: array<f32, 3>;
    var phi_3300_: bool;
    var phi_3304_: array<f32, 3>;
    var phi_3321_: array<f32, 3>;
    var phi_3349_: f32;
    var phi_3377_: array<f32, 3>;
    var phi_3378_: array<f32, 3>;
    var phi_3379_: array<f32, 4>;
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
    phi_243_ = type_9(0u, _e110);
    loop {
        let _e113 = phi_243_;
        if (_e113.member < _e113.member_1) {
            phi_244_ = type_9((_e113.member + 1u), _e113.member_1);
            phi_267_ = type_9(1u, _e113.member);
        } else {
            phi_244_ = _e113;
            phi_267_ = type_9(0u, type_9().member_1);
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
                    phi_410_ = type_23(0u, array<u32, 4>(_e150, _e172[0], _e172[1], _e172[2]));
                } else {
                    let _e162 = edges.member[_e150];
                    let _e164 = edges.member[_e153];
                    phi_410_ = type_23(1u, array<u32, 4>(_e162[0], _e162[1], _e164[0], _e164[1]));
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
                    phi_729_ = type_37(array<array<f32, 3>, 2>(array<f32, 3>((_e263[2][0] - _e263[0][0]), (_e263[2][1] - _e263[0][1]), (_e263[2][2] - _e263[0][2])), array<f32, 3>((_e264[2][0] - _e264[0][0]), (_e264[2][1] - _e264[0][1]), (_e264[2][2] - _e264[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263[1][0] - _e263[0][0]), (_e263[1][1] - _e263[0][1]), (_e263[1][2] - _e263[0][2])), array<f32, 3>((_e264[1][0] - _e264[0][0]), (_e264[1][1] - _e264[0][1]), (_e264[1][2] - _e264[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263[2][0] - _e263[3][0]), (_e263[2][1] - _e263[3][1]), (_e263[2][2] - _e263[3][2])), array<f32, 3>((_e264[2][0] - _e264[3][0]), (_e264[2][1] - _e264[3][1]), (_e264[2][2] - _e264[3][2]))), (_e257 + _e257));
                } else {
                    phi_729_ = type_37(array<array<f32, 3>, 2>(array<f32, 3>((_e263[0][0] - _e263[1][0]), (_e263[0][1] - _e263[1][1]), (_e263[0][2] - _e263[1][2])), array<f32, 3>((_e264[0][0] - _e264[1][0]), (_e264[0][1] - _e264[1][1]), (_e264[0][2] - _e264[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263[2][0] - _e263[1][0]), (_e263[2][1] - _e263[1][1]), (_e263[2][2] - _e263[1][2])), array<f32, 3>((_e264[2][0] - _e264[1][0]), (_e264[2][1] - _e264[1][1]), (_e264[2][2] - _e264[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263[3][0] - _e263[1][0]), (_e263[3][1] - _e263[1][1]), (_e263[3][2] - _e263[1][2])), array<f32, 3>((_e264[3][0] - _e264[1][0]), (_e264[3][1] - _e264[1][1]), (_e264[3][2] - _e264[1][2]))), (_e257 + _e257));
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
                let _e680 = (_e421.member_3 * 4f);
                let _e688 = ((_e516 * _e524) - (_e518 * _e522));
                let _e691 = ((_e518 * _e520) - (_e514 * _e524));
                let _e694 = ((_e514 * _e522) - (_e516 * _e520));
                if (_e520 < 0f) {
                    phi_1105_ = -(_e520);
                } else {
                    phi_1105_ = _e520;
                }
                let _e703 = phi_1105_;
                if (_e522 < 0f) {
                    phi_1111_ = -(_e522);
                } else {
                    phi_1111_ = _e522;
                }
                let _e707 = phi_1111_;
                if (_e703 > _e707) {
                    phi_1116_ = _e703;
                } else {
                    phi_1116_ = _e707;
                }
                let _e710 = phi_1116_;
                if (_e524 < 0f) {
                    phi_1122_ = -(_e524);
                } else {
                    phi_1122_ = _e524;
                }
                let _e714 = phi_1122_;
                if (_e710 > _e714) {
                    phi_1127_ = _e710;
                } else {
                    phi_1127_ = _e714;
                }
                let _e717 = phi_1127_;
                if (_e514 < 0f) {
                    phi_1135_ = -(_e514);
                } else {
                    phi_1135_ = _e514;
                }
                let _e723 = phi_1135_;
                if (_e516 < 0f) {
                    phi_1141_ = -(_e516);
                } else {
                    phi_1141_ = _e516;
                }
                let _e727 = phi_1141_;
                if (_e723 > _e727) {
                    phi_1146_ = _e723;
                } else {
                    phi_1146_ = _e727;
                }
                let _e730 = phi_1146_;
                if (_e518 < 0f) {
                    phi_1152_ = -(_e518);
                } else {
                    phi_1152_ = _e518;
                }
                let _e734 = phi_1152_;
                if (_e730 > _e734) {
                    phi_1157_ = _e730;
                } else {
                    phi_1157_ = _e734;
                }
                let _e737 = phi_1157_;
                let _e739 = (((((_e626 * _e678) + _e680) * _e506) * _e717) + ((((_e677 * _e678) + _e680) * _e506) * _e737));
                let _e744 = (((_e688 * _e688) + (_e691 * _e691)) + (_e694 * _e694));
                if (_e744 <= 0.000000000000000000000000000000000000011754944f) {
                    if (_e744 > 0f) {
                        phi_1178_ = (0.000000000000000000106433627f * 2f);
                    } else {
                        phi_1178_ = 0f;
                    }
                    let _e797 = phi_1178_;
                    phi_1242_ = _e797;
                } else {
                    phi_1185_ = type_14(0i, 5i);
                    phi_1188_ = bitcast<f32>(((bitcast<u32>(_e744) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e752 = phi_1185_;
                        let _e754 = phi_1188_;
                        local_3 = _e754;
                        if (_e752.member < _e752.member_1) {
                            let _e761 = (_e752.member + 1i);
                            if ((false == (_e761 > _e752.member)) != false) {
                                phi_1209_ = true;
                            } else {
                                phi_1209_ = false;
                            }
                            let _e766 = phi_1209_;
                            if _e766 {
                                phi_1215_ = type_15(0u, type_15().member_1);
                            } else {
                                phi_1215_ = type_15(1u, _e761);
                            }
                            let _e771 = phi_1215_;
                            phi_1186_ = type_14(_e771.member_1, _e752.member_1);
                            phi_1229_ = type_15(1u, _e752.member);
                        } else {
                            phi_1186_ = _e752;
                            phi_1229_ = type_15(0u, type_15().member_1);
                        }
                        let _e777 = phi_1186_;
                        let _e779 = phi_1229_;
                        let _e782 = (bitcast<i32>(_e779.member) != 0i);
                        if _e782 {
                            phi_1189_ = (0.5f * (_e754 + (_e744 / _e754)));
                        } else {
                            phi_1189_ = f32();
                        }
                        let _e787 = phi_1189_;
                        continue;
                        continuing {
                            phi_1185_ = _e777;
                            phi_1188_ = _e787;
                            break if !(_e782);
                        }
                    }
                    let _e792 = local_3;
                    phi_1242_ = (_e792 * (1f + (8f * 0.000000059604645f)));
                }
                let _e799 = phi_1242_;
                if (_e799 > 0f) {
                    phi_1250_ = ((_e799 + (_e744 / _e799)) * 0.5f);
                } else {
                    phi_1250_ = _e799;
                }
                let _e805 = phi_1250_;
                if (_e805 > _e739) {
                    phi_1255_ = _e805;
                } else {
                    phi_1255_ = 0f;
                }
                let _e808 = phi_1255_;
                local = type_26(array<f32, 3>((_e426[0] * _e506), (_e426[1] * _e506), (_e426[2] * _e506)), array<f32, 3>(_e514, _e516, _e518), array<f32, 3>(_e520, _e522, _e524), array<f32, 3>(_e688, _e691, _e694), _e808, _e739, ((((((_e573 + _e421.member_3) + _e626) + _e677) * _e678) + _e680) * _e506));
                let _e814 = function_7((&local), _e179.member);
                if (_e814.member_3 <= 0.000000000000000000000000000000000000011754944f) {
                    if (_e814.member_3 > 0f) {
                        phi_1298_ = (0.000000000000000000106433627f * 2f);
                    } else {
                        phi_1298_ = 0f;
                    }
                    let _e870 = phi_1298_;
                    phi_1362_ = _e870;
                } else {
                    phi_1305_ = type_14(0i, 5i);
                    phi_1308_ = bitcast<f32>(((bitcast<u32>(_e814.member_3) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e825 = phi_1305_;
                        let _e827 = phi_1308_;
                        local_4 = _e827;
                        if (_e825.member < _e825.member_1) {
                            let _e834 = (_e825.member + 1i);
                            if ((false == (_e834 > _e825.member)) != false) {
                                phi_1329_ = true;
                            } else {
                                phi_1329_ = false;
                            }
                            let _e839 = phi_1329_;
                            if _e839 {
                                phi_1335_ = type_15(0u, type_15().member_1);
                            } else {
                                phi_1335_ = type_15(1u, _e834);
                            }
                            let _e844 = phi_1335_;
                            phi_1306_ = type_14(_e844.member_1, _e825.member_1);
                            phi_1349_ = type_15(1u, _e825.member);
                        } else {
                            phi_1306_ = _e825;
                            phi_1349_ = type_15(0u, type_15().member_1);
                        }
                        let _e850 = phi_1306_;
                        let _e852 = phi_1349_;
                        let _e855 = (bitcast<i32>(_e852.member) != 0i);
                        if _e855 {
                            phi_1309_ = (0.5f * (_e827 + (_e814.member_3 / _e827)));
                        } else {
                            phi_1309_ = f32();
                        }
                        let _e860 = phi_1309_;
                        continue;
                        continuing {
                            phi_1305_ = _e850;
                            phi_1308_ = _e860;
                            break if !(_e855);
                        }
                    }
                    let _e865 = local_4;
                    phi_1362_ = (_e865 * (1f + (8f * 0.000000059604645f)));
                }
                let _e872 = phi_1362_;
                if (_e872 > 0f) {
                    phi_1370_ = ((_e872 + (_e814.member_3 / _e872)) * 0.5f);
                } else {
                    phi_1370_ = _e872;
                }
                let _e878 = phi_1370_;
                if (_e179.member == 0u) {
                    phi_1376_ = 1f;
                } else {
                    phi_1376_ = -(1f);
                }
                let _e882 = phi_1376_;
                let _e884 = function_1(_e421.member);
                let _e886 = function_1(_e421.member_1);
                let _e900 = function_1(_e421.member_2);
                let _e910 = (((_e884[0] - (_e886[0] * _e814.member)) - (_e900[0] * _e814.member_1)) * _e882);
                let _e911 = (((_e884[1] - (_e886[1] * _e814.member)) - (_e900[1] * _e814.member_1)) * _e882);
                let _e912 = (((_e884[2] - (_e886[2] * _e814.member)) - (_e900[2] * _e814.member_1)) * _e882);
                if (_e814.member > 0f) {
                    phi_1415_ = (_e814.member < 1f);
                } else {
                    phi_1415_ = false;
                }
                let _e919 = phi_1415_;
                if (_e814.member_1 > 0f) {
                    phi_1421_ = (_e814.member_1 < 1f);
                } else {
                    phi_1421_ = false;
                }
                let _e923 = phi_1421_;
                let _e924 = (_e882 > 0f);
                if _e919 {
                    if _e923 {
                        if _e924 {
                            phi_1436_ = ((_e814.member + _e814.member_1) < (1f - (0.000000059604645f * 4f)));
                        } else {
                            phi_1436_ = true;
                        }
                        let _e930 = phi_1436_;
                        phi_1437_ = _e930;
                        phi_1438_ = false;
                    } else {
                        phi_1437_ = bool();
                        phi_1438_ = true;
                    }
                    let _e932 = phi_1437_;
                    let _e934 = phi_1438_;
                    phi_1439_ = _e932;
                    phi_1440_ = _e934;
                } else {
                    phi_1439_ = bool();
                    phi_1440_ = true;
                }
                let _e936 = phi_1439_;
                let _e938 = phi_1440_;
                if _e938 {
                    phi_1444_ = false;
                } else {
                    phi_1444_ = _e936;
                }
                let _e940 = phi_1444_;
                let _e942 = local.member_4;
                let _e943 = (_e942 > 0f);
                let _e945 = local.member_3;
                let _e949 = (_e945[0] * _e882);
                let _e950 = (_e945[1] * _e882);
                let _e951 = (_e945[2] * _e882);
                let _e954 = local.member_6;
                if (_e878 > _e954) {
                    let _e2065 = (_e814.member_2[0] * _e882);
                    let _e2067 = (_e814.member_2[1] * _e882);
                    let _e2069 = (_e814.member_2[2] * _e882);
                    if _e943 {
                        if _e940 {
                            let _e2071 = local.member_5;
                            let _e2074 = local.member_6;
                            let _e2076 = local.member_4;
                            if ((_e2071 * _e878) <= (_e2074 * _e2076)) {
                                if ((((_e2065 * _e949) + (_e2067 * _e950)) + (_e2069 * _e951)) >= 0f) {
                                    phi_1506_ = array<f32, 3>(_e949, _e950, _e951);
                                } else {
                                    let _e2085 = -(1f);
                                    phi_1506_ = array<f32, 3>((_e949 * _e2085), (_e950 * _e2085), (_e951 * _e2085));
                                }
                                let _e2091 = phi_1506_;
                                if (_e2091[0] < 0f) {
                                    phi_1513_ = -(_e2091[0]);
                                } else {
                                    phi_1513_ = _e2091[0];
                                }
                                let _e2096 = phi_1513_;
                                if (_e2091[1] < 0f) {
                                    phi_1520_ = -(_e2091[1]);
                                } else {
                                    phi_1520_ = _e2091[1];
                                }
                                let _e2101 = phi_1520_;
                                if (_e2096 > _e2101) {
                                    phi_1525_ = _e2096;
                                } else {
                                    phi_1525_ = _e2101;
                                }
                                let _e2104 = phi_1525_;
                                if (_e2091[2] < 0f) {
                                    phi_1532_ = -(_e2091[2]);
                                } else {
                                    phi_1532_ = _e2091[2];
                                }
                                let _e2109 = phi_1532_;
                                if (_e2104 > _e2109) {
                                    phi_1537_ = _e2104;
                                } else {
                                    phi_1537_ = _e2109;
                                }
                                let _e2112 = phi_1537_;
                                let _e2113 = function_8(_e2112);
                                let _e2115 = (_e2091[0] * _e2113);
                                let _e2117 = (_e2091[1] * _e2113);
                                let _e2119 = (_e2091[2] * _e2113);
                                let _e2124 = (((_e2115 * _e2115) + (_e2117 * _e2117)) + (_e2119 * _e2119));
                                if (_e2124 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e2124 > 0f) {
                                        phi_1563_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_1563_ = 0f;
                                    }
                                    let _e2177 = phi_1563_;
                                    phi_1627_ = _e2177;
                                } else {
                                    phi_1570_ = type_14(0i, 5i);
                                    phi_1573_ = bitcast<f32>(((bitcast<u32>(_e2124) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e2132 = phi_1570_;
                                        let _e2134 = phi_1573_;
                                        local_11 = _e2134;
                                        if (_e2132.member < _e2132.member_1) {
                                            let _e2141 = (_e2132.member + 1i);
                                            if ((false == (_e2141 > _e2132.member)) != false) {
                                                phi_1594_ = true;
                                            } else {
                                                phi_1594_ = false;
                                            }
                                            let _e2146 = phi_1594_;
                                            if _e2146 {
                                                phi_1600_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_1600_ = type_15(1u, _e2141);
                                            }
                                            let _e2151 = phi_1600_;
                                            phi_1571_ = type_14(_e2151.member_1, _e2132.member_1);
                                            phi_1614_ = type_15(1u, _e2132.member);
                                        } else {
                                            phi_1571_ = _e2132;
                                            phi_1614_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2157 = phi_1571_;
                                        let _e2159 = phi_1614_;
                                        let _e2162 = (bitcast<i32>(_e2159.member) != 0i);
                                        if _e2162 {
                                            phi_1574_ = (0.5f * (_e2134 + (_e2124 / _e2134)));
                                        } else {
                                            phi_1574_ = f32();
                                        }
                                        let _e2167 = phi_1574_;
                                        continue;
                                        continuing {
                                            phi_1570_ = _e2157;
                                            phi_1573_ = _e2167;
                                            break if !(_e2162);
                                        }
                                    }
                                    let _e2172 = local_11;
                                    phi_1627_ = (_e2172 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2179 = phi_1627_;
                                let _e2180 = (1f / _e2179);
                                let _e2181 = (_e2115 * _e2180);
                                let _e2182 = (_e2117 * _e2180);
                                let _e2183 = (_e2119 * _e2180);
                                let _e2190 = ((3f - (((_e2181 * _e2181) + (_e2182 * _e2182)) + (_e2183 * _e2183))) * 0.5f);
                                phi_1643_ = array<f32, 3>((_e2181 * _e2190), (_e2182 * _e2190), (_e2183 * _e2190));
                                phi_1644_ = false;
                            } else {
                                phi_1643_ = array<f32, 3>();
                                phi_1644_ = true;
                            }
                            let _e2196 = phi_1643_;
                            let _e2198 = phi_1644_;
                            phi_1645_ = _e2196;
                            phi_1646_ = _e2198;
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
                    if _e2206 {
                        if (_e2065 < 0f) {
                            phi_1657_ = -(_e2065);
                        } else {
                            phi_1657_ = _e2065;
                        }
                        let _e2210 = phi_1657_;
                        if (_e2067 < 0f) {
                            phi_1663_ = -(_e2067);
                        } else {
                            phi_1663_ = _e2067;
                        }
                        let _e2214 = phi_1663_;
                        if (_e2210 > _e2214) {
                            phi_1668_ = _e2210;
                        } else {
                            phi_1668_ = _e2214;
                        }
                        let _e2217 = phi_1668_;
                        if (_e2069 < 0f) {
                            phi_1674_ = -(_e2069);
                        } else {
                            phi_1674_ = _e2069;
                        }
                        let _e2221 = phi_1674_;
                        if (_e2217 > _e2221) {
                            phi_1679_ = _e2217;
                        } else {
                            phi_1679_ = _e2221;
                        }
                        let _e2224 = phi_1679_;
                        let _e2225 = function_8(_e2224);
                        let _e2226 = (_e2065 * _e2225);
                        let _e2227 = (_e2067 * _e2225);
                        let _e2228 = (_e2069 * _e2225);
                        let _e2233 = (((_e2226 * _e2226) + (_e2227 * _e2227)) + (_e2228 * _e2228));
                        if (_e2233 <= 0.000000000000000000000000000000000000011754944f) {
                            if (_e2233 > 0f) {
                                phi_1702_ = (0.000000000000000000106433627f * 2f);
                            } else {
                                phi_1702_ = 0f;
                            }
                            let _e2286 = phi_1702_;
                            phi_1766_ = _e2286;
                        } else {
                            phi_1709_ = type_14(0i, 5i);
                            phi_1712_ = bitcast<f32>(((bitcast<u32>(_e2233) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e2241 = phi_1709_;
                                let _e2243 = phi_1712_;
                                local_12 = _e2243;
                                if (_e2241.member < _e2241.member_1) {
                                    let _e2250 = (_e2241.member + 1i);
                                    if ((false == (_e2250 > _e2241.member)) != false) {
                                        phi_1733_ = true;
                                    } else {
                                        phi_1733_ = false;
                                    }
                                    let _e2255 = phi_1733_;
                                    if _e2255 {
                                        phi_1739_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_1739_ = type_15(1u, _e2250);
                                    }
                                    let _e2260 = phi_1739_;
                                    phi_1710_ = type_14(_e2260.member_1, _e2241.member_1);
                                    phi_1753_ = type_15(1u, _e2241.member);
                                } else {
                                    phi_1710_ = _e2241;
                                    phi_1753_ = type_15(0u, type_15().member_1);
                                }
                                let _e2266 = phi_1710_;
                                let _e2268 = phi_1753_;
                                let _e2271 = (bitcast<i32>(_e2268.member) != 0i);
                                if _e2271 {
                                    phi_1713_ = (0.5f * (_e2243 + (_e2233 / _e2243)));
                                } else {
                                    phi_1713_ = f32();
                                }
                                let _e2276 = phi_1713_;
                                continue;
                                continuing {
                                    phi_1709_ = _e2266;
                                    phi_1712_ = _e2276;
                                    break if !(_e2271);
                                }
                            }
                            let _e2281 = local_12;
                            phi_1766_ = (_e2281 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e2288 = phi_1766_;
                        let _e2289 = (1f / _e2288);
                        let _e2290 = (_e2226 * _e2289);
                        let _e2291 = (_e2227 * _e2289);
                        let _e2292 = (_e2228 * _e2289);
                        let _e2299 = ((3f - (((_e2290 * _e2290) + (_e2291 * _e2291)) + (_e2292 * _e2292))) * 0.5f);
                        phi_1782_ = array<f32, 3>((_e2290 * _e2299), (_e2291 * _e2299), (_e2292 * _e2299));
                    } else {
                        phi_1782_ = _e2204;
                    }
                    let _e2305 = phi_1782_;
                    phi_3298_ = _e2305;
                    phi_3299_ = array<f32, 3>();
                    phi_3300_ = true;
                } else {
                    if (_e421.member[0][0] < 0f) {
                        phi_1790_ = -(_e421.member[0][0]);
                    } else {
                        phi_1790_ = _e421.member[0][0];
                    }
                    let _e962 = phi_1790_;
                    if (_e421.member[0][1] < 0f) {
                        phi_1797_ = -(_e421.member[0][1]);
                    } else {
                        phi_1797_ = _e421.member[0][1];
                    }
                    let _e967 = phi_1797_;
                    if (_e962 > _e967) {
                        phi_1802_ = _e962;
                    } else {
                        phi_1802_ = _e967;
                    }
                    let _e970 = phi_1802_;
                    if (_e421.member[0][2] < 0f) {
                        phi_1809_ = -(_e421.member[0][2]);
                    } else {
                        phi_1809_ = _e421.member[0][2];
                    }
                    let _e975 = phi_1809_;
                    if (_e970 > _e975) {
                        phi_1814_ = _e970;
                    } else {
                        phi_1814_ = _e975;
                    }
                    let _e978 = phi_1814_;
                    if (_e421.member[1][0] < 0f) {
                        phi_1822_ = -(_e421.member[1][0]);
                    } else {
                        phi_1822_ = _e421.member[1][0];
                    }
                    let _e985 = phi_1822_;
                    if (_e421.member[1][1] < 0f) {
                        phi_1829_ = -(_e421.member[1][1]);
                    } else {
                        phi_1829_ = _e421.member[1][1];
                    }
                    let _e990 = phi_1829_;
                    if (_e985 > _e990) {
                        phi_1834_ = _e985;
                    } else {
                        phi_1834_ = _e990;
                    }
                    let _e993 = phi_1834_;
                    if (_e421.member[1][2] < 0f) {
                        phi_1841_ = -(_e421.member[1][2]);
                    } else {
                        phi_1841_ = _e421.member[1][2];
                    }
                    let _e998 = phi_1841_;
                    if (_e993 > _e998) {
                        phi_1846_ = _e993;
                    } else {
                        phi_1846_ = _e998;
                    }
                    let _e1001 = phi_1846_;
                    if (_e978 > _e1001) {
                        phi_1851_ = _e978;
                    } else {
                        phi_1851_ = _e1001;
                    }
                    let _e1004 = phi_1851_;
                    if (_e421.member_1[0][0] < 0f) {
                        phi_1861_ = -(_e421.member_1[0][0]);
                    } else {
                        phi_1861_ = _e421.member_1[0][0];
                    }
                    let _e1013 = phi_1861_;
                    if (_e421.member_1[0][1] < 0f) {
                        phi_1868_ = -(_e421.member_1[0][1]);
                    } else {
                        phi_1868_ = _e421.member_1[0][1];
                    }
                    let _e1018 = phi_1868_;
                    if (_e1013 > _e1018) {
                        phi_1873_ = _e1013;
                    } else {
                        phi_1873_ = _e1018;
                    }
                    let _e1021 = phi_1873_;
                    if (_e421.member_1[0][2] < 0f) {
                        phi_1880_ = -(_e421.member_1[0][2]);
                    } else {
                        phi_1880_ = _e421.member_1[0][2];
                    }
                    let _e1026 = phi_1880_;
                    if (_e1021 > _e1026) {
                        phi_1885_ = _e1021;
                    } else {
                        phi_1885_ = _e1026;
                    }
                    let _e1029 = phi_1885_;
                    if (_e421.member_1[1][0] < 0f) {
                        phi_1893_ = -(_e421.member_1[1][0]);
                    } else {
                        phi_1893_ = _e421.member_1[1][0];
                    }
                    let _e1036 = phi_1893_;
                    if (_e421.member_1[1][1] < 0f) {
                        phi_1900_ = -(_e421.member_1[1][1]);
                    } else {
                        phi_1900_ = _e421.member_1[1][1];
                    }
                    let _e1041 = phi_1900_;
                    if (_e1036 > _e1041) {
                        phi_1905_ = _e1036;
                    } else {
                        phi_1905_ = _e1041;
                    }
                    let _e1044 = phi_1905_;
                    if (_e421.member_1[1][2] < 0f) {
                        phi_1912_ = -(_e421.member_1[1][2]);
                    } else {
                        phi_1912_ = _e421.member_1[1][2];
                    }
                    let _e1049 = phi_1912_;
                    if (_e1044 > _e1049) {
                        phi_1917_ = _e1044;
                    } else {
                        phi_1917_ = _e1049;
                    }
                    let _e1052 = phi_1917_;
                    if (_e1029 > _e1052) {
                        phi_1922_ = _e1029;
                    } else {
                        phi_1922_ = _e1052;
                    }
                    let _e1055 = phi_1922_;
                    if (_e421.member_2[0][0] < 0f) {
                        phi_1932_ = -(_e421.member_2[0][0]);
                    } else {
                        phi_1932_ = _e421.member_2[0][0];
                    }
                    let _e1064 = phi_1932_;
                    if (_e421.member_2[0][1] < 0f) {
                        phi_1939_ = -(_e421.member_2[0][1]);
                    } else {
                        phi_1939_ = _e421.member_2[0][1];
                    }
                    let _e1069 = phi_1939_;
                    if (_e1064 > _e1069) {
                        phi_1944_ = _e1064;
                    } else {
                        phi_1944_ = _e1069;
                    }
                    let _e1072 = phi_1944_;
                    if (_e421.member_2[0][2] < 0f) {
                        phi_1951_ = -(_e421.member_2[0][2]);
                    } else {
                        phi_1951_ = _e421.member_2[0][2];
                    }
                    let _e1077 = phi_1951_;
                    if (_e1072 > _e1077) {
                        phi_1956_ = _e1072;
                    } else {
                        phi_1956_ = _e1077;
                    }
                    let _e1080 = phi_1956_;
                    if (_e421.member_2[1][0] < 0f) {
                        phi_1964_ = -(_e421.member_2[1][0]);
                    } else {
                        phi_1964_ = _e421.member_2[1][0];
                    }
                    let _e1087 = phi_1964_;
                    if (_e421.member_2[1][1] < 0f) {
                        phi_1971_ = -(_e421.member_2[1][1]);
                    } else {
                        phi_1971_ = _e421.member_2[1][1];
                    }
                    let _e1092 = phi_1971_;
                    if (_e1087 > _e1092) {
                        phi_1976_ = _e1087;
                    } else {
                        phi_1976_ = _e1092;
                    }
                    let _e1095 = phi_1976_;
                    if (_e421.member_2[1][2] < 0f) {
                        phi_1983_ = -(_e421.member_2[1][2]);
                    } else {
                        phi_1983_ = _e421.member_2[1][2];
                    }
                    let _e1100 = phi_1983_;
                    if (_e1095 > _e1100) {
                        phi_1988_ = _e1095;
                    } else {
                        phi_1988_ = _e1100;
                    }
                    let _e1103 = phi_1988_;
                    if (_e1080 > _e1103) {
                        phi_1993_ = _e1080;
                    } else {
                        phi_1993_ = _e1103;
                    }
                    let _e1106 = phi_1993_;
                    let _e1115 = (((((_e1004 + _e421.member_3) + (_e1055 + _e421.member_3)) + (_e1106 + _e421.member_3)) * (0.000000059604645f * 32f)) + (_e421.member_3 * 8f));
                    if _e943 {
                        if (_e949 < 0f) {
                            phi_2011_ = -(_e949);
                        } else {
                            phi_2011_ = _e949;
                        }
                        let _e1119 = phi_2011_;
                        if (_e950 < 0f) {
                            phi_2017_ = -(_e950);
                        } else {
                            phi_2017_ = _e950;
                        }
                        let _e1123 = phi_2017_;
                        if (_e1119 > _e1123) {
                            phi_2022_ = _e1119;
                        } else {
                            phi_2022_ = _e1123;
                        }
                        let _e1126 = phi_2022_;
                        if (_e951 < 0f) {
                            phi_2028_ = -(_e951);
                        } else {
                            phi_2028_ = _e951;
                        }
                        let _e1130 = phi_2028_;
                        if (_e1126 > _e1130) {
                            phi_2033_ = _e1126;
                        } else {
                            phi_2033_ = _e1130;
                        }
                        let _e1133 = phi_2033_;
                        let _e1134 = function_8(_e1133);
                        let _e1135 = (_e949 * _e1134);
                        let _e1136 = (_e950 * _e1134);
                        let _e1137 = (_e951 * _e1134);
                        let _e1142 = (((_e1135 * _e1135) + (_e1136 * _e1136)) + (_e1137 * _e1137));
                        if (_e1142 <= 0.000000000000000000000000000000000000011754944f) {
                            if (_e1142 > 0f) {
                                phi_2056_ = (0.000000000000000000106433627f * 2f);
                            } else {
                                phi_2056_ = 0f;
                            }
                            let _e1195 = phi_2056_;
                            phi_2120_ = _e1195;
                        } else {
                            phi_2063_ = type_14(0i, 5i);
                            phi_2066_ = bitcast<f32>(((bitcast<u32>(_e1142) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e1150 = phi_2063_;
                                let _e1152 = phi_2066_;
                                local_5 = _e1152;
                                if (_e1150.member < _e1150.member_1) {
                                    let _e1159 = (_e1150.member + 1i);
                                    if ((false == (_e1159 > _e1150.member)) != false) {
                                        phi_2087_ = true;
                                    } else {
                                        phi_2087_ = false;
                                    }
                                    let _e1164 = phi_2087_;
                                    if _e1164 {
                                        phi_2093_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_2093_ = type_15(1u, _e1159);
                                    }
                                    let _e1169 = phi_2093_;
                                    phi_2064_ = type_14(_e1169.member_1, _e1150.member_1);
                                    phi_2107_ = type_15(1u, _e1150.member);
                                } else {
                                    phi_2064_ = _e1150;
                                    phi_2107_ = type_15(0u, type_15().member_1);
                                }
                                let _e1175 = phi_2064_;
                                let _e1177 = phi_2107_;
                                let _e1180 = (bitcast<i32>(_e1177.member) != 0i);
                                if _e1180 {
                                    phi_2067_ = (0.5f * (_e1152 + (_e1142 / _e1152)));
                                } else {
                                    phi_2067_ = f32();
                                }
                                let _e1185 = phi_2067_;
                                continue;
                                continuing {
                                    phi_2063_ = _e1175;
                                    phi_2066_ = _e1185;
                                    break if !(_e1180);
                                }
                            }
                            let _e1190 = local_5;
                            phi_2120_ = (_e1190 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e1197 = phi_2120_;
                        let _e1198 = (1f / _e1197);
                        let _e1199 = (_e1135 * _e1198);
                        let _e1200 = (_e1136 * _e1198);
                        let _e1201 = (_e1137 * _e1198);
                        let _e1208 = ((3f - (((_e1199 * _e1199) + (_e1200 * _e1200)) + (_e1201 * _e1201))) * 0.5f);
                        let _e1209 = (_e1199 * _e1208);
                        let _e1210 = (_e1200 * _e1208);
                        let _e1211 = (_e1201 * _e1208);
                        let _e1217 = (((_e910 * _e1209) + (_e911 * _e1210)) + (_e912 * _e1211));
                        if (_e910 < 0f) {
                            phi_2146_ = -(_e910);
                        } else {
                            phi_2146_ = _e910;
                        }
                        let _e1221 = phi_2146_;
                        if (_e911 < 0f) {
                            phi_2152_ = -(_e911);
                        } else {
                            phi_2152_ = _e911;
                        }
                        let _e1225 = phi_2152_;
                        if (_e912 < 0f) {
                            phi_2159_ = -(_e912);
                        } else {
                            phi_2159_ = _e912;
                        }
                        let _e1230 = phi_2159_;
                        let _e1233 = local.member_5;
                        let _e1235 = local.member_4;
                        if (_e1217 < 0f) {
                            phi_2173_ = -(_e1217);
                        } else {
                            phi_2173_ = _e1217;
                        }
                        let _e1242 = phi_2173_;
                        if (_e1242 > (_e1115 + (((_e1221 + _e1225) + _e1230) * (_e1233 / _e1235)))) {
                            if (_e1217 < 0f) {
                                phi_2187_ = array<f32, 3>(_e1209, _e1210, _e1211);
                            } else {
                                let _e1245 = -(1f);
                                phi_2187_ = array<f32, 3>((_e1209 * _e1245), (_e1210 * _e1245), (_e1211 * _e1245));
                            }
                            let _e1251 = phi_2187_;
                            phi_2188_ = _e1251;
                            phi_2189_ = false;
                        } else {
                            phi_2188_ = array<f32, 3>();
                            phi_2189_ = true;
                        }
                        let _e1253 = phi_2188_;
                        let _e1255 = phi_2189_;
                        phi_2190_ = _e1253;
                        phi_2191_ = _e1255;
                    } else {
                        phi_2190_ = array<f32, 3>();
                        phi_2191_ = true;
                    }
                    let _e1257 = phi_2190_;
                    let _e1259 = phi_2191_;
                    if _e1259 {
                        if _e943 {
                            if _e940 {
                                phi_2201_ = false;
                            } else {
                                phi_2201_ = true;
                            }
                            let _e1261 = phi_2201_;
                            phi_2202_ = _e1261;
                        } else {
                            phi_2202_ = true;
                        }
                        let _e1263 = phi_2202_;
                        if _e1263 {
                            if _e924 {
                                if _e919 {
                                    if _e923 {
                                        let _e1265 = local.member_2;
                                        let _e1270 = local.member_1;
                                        phi_2237_ = array<f32, 3>((_e1265[0] - _e1270[0]), (_e1265[1] - _e1270[1]), (_e1265[2] - _e1270[2]));
                                        phi_2238_ = false;
                                    } else {
                                        phi_2237_ = array<f32, 3>();
                                        phi_2238_ = true;
                                    }
                                    let _e1279 = phi_2237_;
                                    let _e1281 = phi_2238_;
                                    phi_2239_ = _e1279;
                                    phi_2240_ = _e1281;
                                } else {
                                    phi_2239_ = array<f32, 3>();
                                    phi_2240_ = true;
                                }
                                let _e1283 = phi_2239_;
                                let _e1285 = phi_2240_;
                                phi_2241_ = _e1283;
                                phi_2242_ = _e1285;
                            } else {
                                phi_2241_ = array<f32, 3>();
                                phi_2242_ = true;
                            }
                            let _e1287 = phi_2241_;
                            let _e1289 = phi_2242_;
                            if _e1289 {
                                if _e919 {
                                    if _e923 {
                                        let _e1291 = local.member_2;
                                        if (_e1291[0] < 0f) {
                                            phi_2264_ = -(_e1291[0]);
                                        } else {
                                            phi_2264_ = _e1291[0];
                                        }
                                        let _e1298 = phi_2264_;
                                        if (_e1291[1] < 0f) {
                                            phi_2271_ = -(_e1291[1]);
                                        } else {
                                            phi_2271_ = _e1291[1];
                                        }
                                        let _e1302 = phi_2271_;
                                        if (_e1298 > _e1302) {
                                            phi_2276_ = _e1298;
                                        } else {
                                            phi_2276_ = _e1302;
                                        }
                                        let _e1305 = phi_2276_;
                                        if (_e1291[2] < 0f) {
                                            phi_2283_ = -(_e1291[2]);
                                        } else {
                                            phi_2283_ = _e1291[2];
                                        }
                                        let _e1309 = phi_2283_;
                                        if (_e1305 > _e1309) {
                                            phi_2288_ = _e1305;
                                        } else {
                                            phi_2288_ = _e1309;
                                        }
                                        let _e1312 = phi_2288_;
                                        let _e1314 = local.member_1;
                                        if (_e1314[0] < 0f) {
                                            phi_2301_ = -(_e1314[0]);
                                        } else {
                                            phi_2301_ = _e1314[0];
                                        }
                                        let _e1321 = phi_2301_;
                                        if (_e1314[1] < 0f) {
                                            phi_2308_ = -(_e1314[1]);
                                        } else {
                                            phi_2308_ = _e1314[1];
                                        }
                                        let _e1325 = phi_2308_;
                                        if (_e1321 > _e1325) {
                                            phi_2313_ = _e1321;
                                        } else {
                                            phi_2313_ = _e1325;
                                        }
                                        let _e1328 = phi_2313_;
                                        if (_e1314[2] < 0f) {
                                            phi_2320_ = -(_e1314[2]);
                                        } else {
                                            phi_2320_ = _e1314[2];
                                        }
                                        let _e1332 = phi_2320_;
                                        if (_e1328 > _e1332) {
                                            phi_2325_ = _e1328;
                                        } else {
                                            phi_2325_ = _e1332;
                                        }
                                        let _e1335 = phi_2325_;
                                        if (_e1312 > _e1335) {
                                            phi_2330_ = false;
                                        } else {
                                            phi_2330_ = true;
                                        }
                                        let _e1338 = phi_2330_;
                                        phi_2331_ = _e1338;
                                    } else {
                                        phi_2331_ = true;
                                    }
                                    let _e1340 = phi_2331_;
                                    if _e1340 {
                                        let _e1342 = local.member_1;
                                        phi_2341_ = array<f32, 3>(_e1342[0], _e1342[1], _e1342[2]);
                                        phi_2342_ = false;
                                    } else {
                                        phi_2341_ = array<f32, 3>();
                                        phi_2342_ = true;
                                    }
                                    let _e1348 = phi_2341_;
                                    let _e1350 = phi_2342_;
                                    phi_2343_ = _e1348;
                                    phi_2344_ = _e1350;
                                } else {
                                    phi_2343_ = array<f32, 3>();
                                    phi_2344_ = true;
                                }
                                let _e1352 = phi_2343_;
                                let _e1354 = phi_2344_;
                                if _e1354 {
                                    if _e923 {
                                        let _e1356 = local.member_2;
                                        phi_2358_ = array<f32, 3>(_e1356[0], _e1356[1], _e1356[2]);
                                    } else {
                                        phi_2358_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e1362 = phi_2358_;
                                    phi_2359_ = _e1362;
                                } else {
                                    phi_2359_ = _e1352;
                                }
                                let _e1364 = phi_2359_;
                                phi_2360_ = _e1364;
                            } else {
                                phi_2360_ = _e1287;
                            }
                            let _e1366 = phi_2360_;
                            if (_e1366[0] < 0f) {
                                phi_2367_ = -(_e1366[0]);
                            } else {
                                phi_2367_ = _e1366[0];
                            }
                            let _e1371 = phi_2367_;
                            if (_e1366[1] < 0f) {
                                phi_2374_ = -(_e1366[1]);
                            } else {
                                phi_2374_ = _e1366[1];
                            }
                            let _e1376 = phi_2374_;
                            if (_e1371 > _e1376) {
                                phi_2379_ = _e1371;
                            } else {
                                phi_2379_ = _e1376;
                            }
                            let _e1379 = phi_2379_;
                            if (_e1366[2] < 0f) {
                                phi_2386_ = -(_e1366[2]);
                            } else {
                                phi_2386_ = _e1366[2];
                            }
                            let _e1384 = phi_2386_;
                            if (_e1379 > _e1384) {
                                phi_2391_ = _e1379;
                            } else {
                                phi_2391_ = _e1384;
                            }
                            let _e1387 = phi_2391_;
                            if (_e1387 > 0f) {
                                if (_e1366[0] < 0f) {
                                    phi_2402_ = -(_e1366[0]);
                                } else {
                                    phi_2402_ = _e1366[0];
                                }
                                let _e1393 = phi_2402_;
                                if (_e1366[1] < 0f) {
                                    phi_2409_ = -(_e1366[1]);
                                } else {
                                    phi_2409_ = _e1366[1];
                                }
                                let _e1398 = phi_2409_;
                                if (_e1393 > _e1398) {
                                    phi_2414_ = _e1393;
                                } else {
                                    phi_2414_ = _e1398;
                                }
                                let _e1401 = phi_2414_;
                                if (_e1366[2] < 0f) {
                                    phi_2421_ = -(_e1366[2]);
                                } else {
                                    phi_2421_ = _e1366[2];
                                }
                                let _e1406 = phi_2421_;
                                if (_e1401 > _e1406) {
                                    phi_2426_ = _e1401;
                                } else {
                                    phi_2426_ = _e1406;
                                }
                                let _e1409 = phi_2426_;
                                let _e1410 = function_8(_e1409);
                                let _e1412 = (_e1366[0] * _e1410);
                                let _e1414 = (_e1366[1] * _e1410);
                                let _e1416 = (_e1366[2] * _e1410);
                                let _e1421 = (((_e1412 * _e1412) + (_e1414 * _e1414)) + (_e1416 * _e1416));
                                if (_e1421 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e1421 > 0f) {
                                        phi_2452_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_2452_ = 0f;
                                    }
                                    let _e1474 = phi_2452_;
                                    phi_2516_ = _e1474;
                                } else {
                                    phi_2459_ = type_14(0i, 5i);
                                    phi_2462_ = bitcast<f32>(((bitcast<u32>(_e1421) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1429 = phi_2459_;
                                        let _e1431 = phi_2462_;
                                        local_6 = _e1431;
                                        if (_e1429.member < _e1429.member_1) {
                                            let _e1438 = (_e1429.member + 1i);
                                            if ((false == (_e1438 > _e1429.member)) != false) {
                                                phi_2483_ = true;
                                            } else {
                                                phi_2483_ = false;
                                            }
                                            let _e1443 = phi_2483_;
                                            if _e1443 {
                                                phi_2489_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_2489_ = type_15(1u, _e1438);
                                            }
                                            let _e1448 = phi_2489_;
                                            phi_2460_ = type_14(_e1448.member_1, _e1429.member_1);
                                            phi_2503_ = type_15(1u, _e1429.member);
                                        } else {
                                            phi_2460_ = _e1429;
                                            phi_2503_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1454 = phi_2460_;
                                        let _e1456 = phi_2503_;
                                        let _e1459 = (bitcast<i32>(_e1456.member) != 0i);
                                        if _e1459 {
                                            phi_2463_ = (0.5f * (_e1431 + (_e1421 / _e1431)));
                                        } else {
                                            phi_2463_ = f32();
                                        }
                                        let _e1464 = phi_2463_;
                                        continue;
                                        continuing {
                                            phi_2459_ = _e1454;
                                            phi_2462_ = _e1464;
                                            break if !(_e1459);
                                        }
                                    }
                                    let _e1469 = local_6;
                                    phi_2516_ = (_e1469 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1476 = phi_2516_;
                                let _e1477 = (1f / _e1476);
                                let _e1478 = (_e1412 * _e1477);
                                let _e1479 = (_e1414 * _e1477);
                                let _e1480 = (_e1416 * _e1477);
                                let _e1487 = ((3f - (((_e1478 * _e1478) + (_e1479 * _e1479)) + (_e1480 * _e1480))) * 0.5f);
                                let _e1488 = (_e1478 * _e1487);
                                let _e1489 = (_e1479 * _e1487);
                                let _e1490 = (_e1480 * _e1487);
                                let _e1495 = (((_e910 * _e1488) + (_e911 * _e1489)) + (_e912 * _e1490));
                                phi_2543_ = array<f32, 3>((_e910 - (_e1488 * _e1495)), (_e911 - (_e1489 * _e1495)), (_e912 - (_e1490 * _e1495)));
                            } else {
                                phi_2543_ = array<f32, 3>(_e910, _e911, _e912);
                            }
                            let _e1504 = phi_2543_;
                            if (_e1504[0] < 0f) {
                                phi_2550_ = -(_e1504[0]);
                            } else {
                                phi_2550_ = _e1504[0];
                            }
                            let _e1509 = phi_2550_;
                            if (_e1504[1] < 0f) {
                                phi_2557_ = -(_e1504[1]);
                            } else {
                                phi_2557_ = _e1504[1];
                            }
                            let _e1514 = phi_2557_;
                            if (_e1504[2] < 0f) {
                                phi_2565_ = -(_e1504[2]);
                            } else {
                                phi_2565_ = _e1504[2];
                            }
                            let _e1520 = phi_2565_;
                            if (((_e1509 + _e1514) + _e1520) > _e1115) {
                                let _e1523 = -(1f);
                                let _e1525 = (_e1504[0] * _e1523);
                                let _e1527 = (_e1504[1] * _e1523);
                                let _e1529 = (_e1504[2] * _e1523);
                                if (_e1525 < 0f) {
                                    phi_2583_ = -(_e1525);
                                } else {
                                    phi_2583_ = _e1525;
                                }
                                let _e1533 = phi_2583_;
                                if (_e1527 < 0f) {
                                    phi_2589_ = -(_e1527);
                                } else {
                                    phi_2589_ = _e1527;
                                }
                                let _e1537 = phi_2589_;
                                if (_e1533 > _e1537) {
                                    phi_2594_ = _e1533;
                                } else {
                                    phi_2594_ = _e1537;
                                }
                                let _e1540 = phi_2594_;
                                if (_e1529 < 0f) {
                                    phi_2600_ = -(_e1529);
                                } else {
                                    phi_2600_ = _e1529;
                                }
                                let _e1544 = phi_2600_;
                                if (_e1540 > _e1544) {
                                    phi_2605_ = _e1540;
                                } else {
                                    phi_2605_ = _e1544;
                                }
                                let _e1547 = phi_2605_;
                                let _e1548 = function_8(_e1547);
                                let _e1549 = (_e1525 * _e1548);
                                let _e1550 = (_e1527 * _e1548);
                                let _e1551 = (_e1529 * _e1548);
                                let _e1556 = (((_e1549 * _e1549) + (_e1550 * _e1550)) + (_e1551 * _e1551));
                                if (_e1556 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e1556 > 0f) {
                                        phi_2628_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_2628_ = 0f;
                                    }
                                    let _e1609 = phi_2628_;
                                    phi_2692_ = _e1609;
                                } else {
                                    phi_2635_ = type_14(0i, 5i);
                                    phi_2638_ = bitcast<f32>(((bitcast<u32>(_e1556) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1564 = phi_2635_;
                                        let _e1566 = phi_2638_;
                                        local_7 = _e1566;
                                        if (_e1564.member < _e1564.member_1) {
                                            let _e1573 = (_e1564.member + 1i);
                                            if ((false == (_e1573 > _e1564.member)) != false) {
                                                phi_2659_ = true;
                                            } else {
                                                phi_2659_ = false;
                                            }
                                            let _e1578 = phi_2659_;
                                            if _e1578 {
                                                phi_2665_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_2665_ = type_15(1u, _e1573);
                                            }
                                            let _e1583 = phi_2665_;
                                            phi_2636_ = type_14(_e1583.member_1, _e1564.member_1);
                                            phi_2679_ = type_15(1u, _e1564.member);
                                        } else {
                                            phi_2636_ = _e1564;
                                            phi_2679_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1589 = phi_2636_;
                                        let _e1591 = phi_2679_;
                                        let _e1594 = (bitcast<i32>(_e1591.member) != 0i);
                                        if _e1594 {
                                            phi_2639_ = (0.5f * (_e1566 + (_e1556 / _e1566)));
                                        } else {
                                            phi_2639_ = f32();
                                        }
                                        let _e1599 = phi_2639_;
                                        continue;
                                        continuing {
                                            phi_2635_ = _e1589;
                                            phi_2638_ = _e1599;
                                            break if !(_e1594);
                                        }
                                    }
                                    let _e1604 = local_7;
                                    phi_2692_ = (_e1604 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1611 = phi_2692_;
                                let _e1612 = (1f / _e1611);
                                let _e1613 = (_e1549 * _e1612);
                                let _e1614 = (_e1550 * _e1612);
                                let _e1615 = (_e1551 * _e1612);
                                let _e1622 = ((3f - (((_e1613 * _e1613) + (_e1614 * _e1614)) + (_e1615 * _e1615))) * 0.5f);
                                phi_2708_ = array<f32, 3>((_e1613 * _e1622), (_e1614 * _e1622), (_e1615 * _e1622));
                                phi_2709_ = false;
                            } else {
                                phi_2708_ = array<f32, 3>();
                                phi_2709_ = true;
                            }
                            let _e1628 = phi_2708_;
                            let _e1630 = phi_2709_;
                            phi_2710_ = _e1628;
                            phi_2711_ = _e1630;
                        } else {
                            phi_2710_ = array<f32, 3>();
                            phi_2711_ = true;
                        }
                        let _e1632 = phi_2710_;
                        let _e1634 = phi_2711_;
                        if _e1634 {
                            if _e943 {
                                if (_e949 < 0f) {
                                    phi_2723_ = -(_e949);
                                } else {
                                    phi_2723_ = _e949;
                                }
                                let _e1957 = phi_2723_;
                                if (_e950 < 0f) {
                                    phi_2729_ = -(_e950);
                                } else {
                                    phi_2729_ = _e950;
                                }
                                let _e1961 = phi_2729_;
                                if (_e1957 > _e1961) {
                                    phi_2734_ = _e1957;
                                } else {
                                    phi_2734_ = _e1961;
                                }
                                let _e1964 = phi_2734_;
                                if (_e951 < 0f) {
                                    phi_2740_ = -(_e951);
                                } else {
                                    phi_2740_ = _e951;
                                }
                                let _e1968 = phi_2740_;
                                if (_e1964 > _e1968) {
                                    phi_2745_ = _e1964;
                                } else {
                                    phi_2745_ = _e1968;
                                }
                                let _e1971 = phi_2745_;
                                let _e1972 = function_8(_e1971);
                                let _e1973 = (_e949 * _e1972);
                                let _e1974 = (_e950 * _e1972);
                                let _e1975 = (_e951 * _e1972);
                                let _e1980 = (((_e1973 * _e1973) + (_e1974 * _e1974)) + (_e1975 * _e1975));
                                if (_e1980 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e1980 > 0f) {
                                        phi_2768_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_2768_ = 0f;
                                    }
                                    let _e2033 = phi_2768_;
                                    phi_2832_ = _e2033;
                                } else {
                                    phi_2775_ = type_14(0i, 5i);
                                    phi_2778_ = bitcast<f32>(((bitcast<u32>(_e1980) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1988 = phi_2775_;
                                        let _e1990 = phi_2778_;
                                        local_10 = _e1990;
                                        if (_e1988.member < _e1988.member_1) {
                                            let _e1997 = (_e1988.member + 1i);
                                            if ((false == (_e1997 > _e1988.member)) != false) {
                                                phi_2799_ = true;
                                            } else {
                                                phi_2799_ = false;
                                            }
                                            let _e2002 = phi_2799_;
                                            if _e2002 {
                                                phi_2805_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_2805_ = type_15(1u, _e1997);
                                            }
                                            let _e2007 = phi_2805_;
                                            phi_2776_ = type_14(_e2007.member_1, _e1988.member_1);
                                            phi_2819_ = type_15(1u, _e1988.member);
                                        } else {
                                            phi_2776_ = _e1988;
                                            phi_2819_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2013 = phi_2776_;
                                        let _e2015 = phi_2819_;
                                        let _e2018 = (bitcast<i32>(_e2015.member) != 0i);
                                        if _e2018 {
                                            phi_2779_ = (0.5f * (_e1990 + (_e1980 / _e1990)));
                                        } else {
                                            phi_2779_ = f32();
                                        }
                                        let _e2023 = phi_2779_;
                                        continue;
                                        continuing {
                                            phi_2775_ = _e2013;
                                            phi_2778_ = _e2023;
                                            break if !(_e2018);
                                        }
                                    }
                                    let _e2028 = local_10;
                                    phi_2832_ = (_e2028 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2035 = phi_2832_;
                                let _e2036 = (1f / _e2035);
                                let _e2037 = (_e1973 * _e2036);
                                let _e2038 = (_e1974 * _e2036);
                                let _e2039 = (_e1975 * _e2036);
                                let _e2046 = ((3f - (((_e2037 * _e2037) + (_e2038 * _e2038)) + (_e2039 * _e2039))) * 0.5f);
                                phi_3289_ = array<f32, 3>((_e2037 * _e2046), (_e2038 * _e2046), (_e2039 * _e2046));
                            } else {
                                let _e1636 = local.member_1;
                                let _e1642 = local.member_2;
                                if (_e1642[0] < 0f) {
                                    phi_2866_ = -(_e1642[0]);
                                } else {
                                    phi_2866_ = _e1642[0];
                                }
                                let _e1650 = phi_2866_;
                                if (_e1642[1] < 0f) {
                                    phi_2873_ = -(_e1642[1]);
                                } else {
                                    phi_2873_ = _e1642[1];
                                }
                                let _e1654 = phi_2873_;
                                if (_e1650 > _e1654) {
                                    phi_2878_ = _e1650;
                                } else {
                                    phi_2878_ = _e1654;
                                }
                                let _e1657 = phi_2878_;
                                if (_e1642[2] < 0f) {
                                    phi_2885_ = -(_e1642[2]);
                                } else {
                                    phi_2885_ = _e1642[2];
                                }
                                let _e1661 = phi_2885_;
                                if (_e1657 > _e1661) {
                                    phi_2890_ = _e1657;
                                } else {
                                    phi_2890_ = _e1661;
                                }
                                let _e1664 = phi_2890_;
                                if (_e1636[0] < 0f) {
                                    phi_2897_ = -(_e1636[0]);
                                } else {
                                    phi_2897_ = _e1636[0];
                                }
                                let _e1668 = phi_2897_;
                                if (_e1636[1] < 0f) {
                                    phi_2904_ = -(_e1636[1]);
                                } else {
                                    phi_2904_ = _e1636[1];
                                }
                                let _e1672 = phi_2904_;
                                if (_e1668 > _e1672) {
                                    phi_2909_ = _e1668;
                                } else {
                                    phi_2909_ = _e1672;
                                }
                                let _e1675 = phi_2909_;
                                if (_e1636[2] < 0f) {
                                    phi_2916_ = -(_e1636[2]);
                                } else {
                                    phi_2916_ = _e1636[2];
                                }
                                let _e1679 = phi_2916_;
                                if (_e1675 > _e1679) {
                                    phi_2921_ = _e1675;
                                } else {
                                    phi_2921_ = _e1679;
                                }
                                let _e1682 = phi_2921_;
                                if (_e1664 > _e1682) {
                                    phi_2926_ = array<f32, 3>(_e1642[0], _e1642[1], _e1642[2]);
                                } else {
                                    phi_2926_ = array<f32, 3>(_e1636[0], _e1636[1], _e1636[2]);
                                }
                                let _e1685 = phi_2926_;
                                if (_e1685[0] < 0f) {
                                    phi_2933_ = -(_e1685[0]);
                                } else {
                                    phi_2933_ = _e1685[0];
                                }
                                let _e1690 = phi_2933_;
                                if (_e1685[1] < 0f) {
                                    phi_2940_ = -(_e1685[1]);
                                } else {
                                    phi_2940_ = _e1685[1];
                                }
                                let _e1695 = phi_2940_;
                                if (_e1690 > _e1695) {
                                    phi_2945_ = _e1690;
                                } else {
                                    phi_2945_ = _e1695;
                                }
                                let _e1698 = phi_2945_;
                                if (_e1685[2] < 0f) {
                                    phi_2952_ = -(_e1685[2]);
                                } else {
                                    phi_2952_ = _e1685[2];
                                }
                                let _e1703 = phi_2952_;
                                if (_e1698 > _e1703) {
                                    phi_2957_ = _e1698;
                                } else {
                                    phi_2957_ = _e1703;
                                }
                                let _e1706 = phi_2957_;
                                if (_e1706 > 0f) {
                                    if (_e1685[0] < 0f) {
                                        phi_2968_ = -(_e1685[0]);
                                    } else {
                                        phi_2968_ = _e1685[0];
                                    }
                                    let _e1712 = phi_2968_;
                                    if (_e1685[1] < 0f) {
                                        phi_2975_ = -(_e1685[1]);
                                    } else {
                                        phi_2975_ = _e1685[1];
                                    }
                                    let _e1717 = phi_2975_;
                                    if (_e1685[2] < 0f) {
                                        phi_2982_ = -(_e1685[2]);
                                    } else {
                                        phi_2982_ = _e1685[2];
                                    }
                                    let _e1722 = phi_2982_;
                                    if (_e1712 <= _e1717) {
                                        if (_e1712 <= _e1722) {
                                            phi_2992_ = array<f32, 3>(1f, 0f, 0f);
                                            phi_2993_ = false;
                                        } else {
                                            phi_2992_ = array<f32, 3>();
                                            phi_2993_ = true;
                                        }
                                        let _e1726 = phi_2992_;
                                        let _e1728 = phi_2993_;
                                        phi_2994_ = _e1726;
                                        phi_2995_ = _e1728;
                                    } else {
                                        phi_2994_ = array<f32, 3>();
                                        phi_2995_ = true;
                                    }
                                    let _e1730 = phi_2994_;
                                    let _e1732 = phi_2995_;
                                    if _e1732 {
                                        if (_e1717 <= _e1722) {
                                            phi_3005_ = array<f32, 3>(0f, 1f, 0f);
                                        } else {
                                            phi_3005_ = array<f32, 3>(0f, 0f, 1f);
                                        }
                                        let _e1735 = phi_3005_;
                                        phi_3006_ = _e1735;
                                    } else {
                                        phi_3006_ = _e1730;
                                    }
                                    let _e1737 = phi_3006_;
                                    if (_e1685[0] < 0f) {
                                        phi_3013_ = -(_e1685[0]);
                                    } else {
                                        phi_3013_ = _e1685[0];
                                    }
                                    let _e1742 = phi_3013_;
                                    if (_e1685[1] < 0f) {
                                        phi_3020_ = -(_e1685[1]);
                                    } else {
                                        phi_3020_ = _e1685[1];
                                    }
                                    let _e1747 = phi_3020_;
                                    if (_e1742 > _e1747) {
                                        phi_3025_ = _e1742;
                                    } else {
                                        phi_3025_ = _e1747;
                                    }
                                    let _e1750 = phi_3025_;
                                    if (_e1685[2] < 0f) {
                                        phi_3032_ = -(_e1685[2]);
                                    } else {
                                        phi_3032_ = _e1685[2];
                                    }
                                    let _e1755 = phi_3032_;
                                    if (_e1750 > _e1755) {
                                        phi_3037_ = _e1750;
                                    } else {
                                        phi_3037_ = _e1755;
                                    }
                                    let _e1758 = phi_3037_;
                                    let _e1759 = function_8(_e1758);
                                    let _e1761 = (_e1685[0] * _e1759);
                                    let _e1763 = (_e1685[1] * _e1759);
                                    let _e1765 = (_e1685[2] * _e1759);
                                    let _e1770 = (((_e1761 * _e1761) + (_e1763 * _e1763)) + (_e1765 * _e1765));
                                    if (_e1770 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1770 > 0f) {
                                            phi_3063_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3063_ = 0f;
                                        }
                                        let _e1823 = phi_3063_;
                                        phi_3127_ = _e1823;
                                    } else {
                                        phi_3070_ = type_14(0i, 5i);
                                        phi_3073_ = bitcast<f32>(((bitcast<u32>(_e1770) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1778 = phi_3070_;
                                            let _e1780 = phi_3073_;
                                            local_8 = _e1780;
                                            if (_e1778.member < _e1778.member_1) {
                                                let _e1787 = (_e1778.member + 1i);
                                                if ((false == (_e1787 > _e1778.member)) != false) {
                                                    phi_3094_ = true;
                                                } else {
                                                    phi_3094_ = false;
                                                }
                                                let _e1792 = phi_3094_;
                                                if _e1792 {
                                                    phi_3100_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_3100_ = type_15(1u, _e1787);
                                                }
                                                let _e1797 = phi_3100_;
                                                phi_3071_ = type_14(_e1797.member_1, _e1778.member_1);
                                                phi_3114_ = type_15(1u, _e1778.member);
                                            } else {
                                                phi_3071_ = _e1778;
                                                phi_3114_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1803 = phi_3071_;
                                            let _e1805 = phi_3114_;
                                            let _e1808 = (bitcast<i32>(_e1805.member) != 0i);
                                            if _e1808 {
                                                phi_3074_ = (0.5f * (_e1780 + (_e1770 / _e1780)));
                                            } else {
                                                phi_3074_ = f32();
                                            }
                                            let _e1813 = phi_3074_;
                                            continue;
                                            continuing {
                                                phi_3070_ = _e1803;
                                                phi_3073_ = _e1813;
                                                break if !(_e1808);
                                            }
                                        }
                                        let _e1818 = local_8;
                                        phi_3127_ = (_e1818 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1825 = phi_3127_;
                                    let _e1826 = (1f / _e1825);
                                    let _e1827 = (_e1761 * _e1826);
                                    let _e1828 = (_e1763 * _e1826);
                                    let _e1829 = (_e1765 * _e1826);
                                    let _e1836 = ((3f - (((_e1827 * _e1827) + (_e1828 * _e1828)) + (_e1829 * _e1829))) * 0.5f);
                                    let _e1837 = (_e1827 * _e1836);
                                    let _e1838 = (_e1828 * _e1836);
                                    let _e1839 = (_e1829 * _e1836);
                                    let _e1844 = ((_e1838 * _e1737[2]) - (_e1839 * _e1737[1]));
                                    let _e1849 = ((_e1839 * _e1737[0]) - (_e1837 * _e1737[2]));
                                    let _e1854 = ((_e1837 * _e1737[1]) - (_e1838 * _e1737[0]));
                                    if (_e1844 < 0f) {
                                        phi_3162_ = -(_e1844);
                                    } else {
                                        phi_3162_ = _e1844;
                                    }
                                    let _e1858 = phi_3162_;
                                    if (_e1849 < 0f) {
                                        phi_3168_ = -(_e1849);
                                    } else {
                                        phi_3168_ = _e1849;
                                    }
                                    let _e1862 = phi_3168_;
                                    if (_e1858 > _e1862) {
                                        phi_3173_ = _e1858;
                                    } else {
                                        phi_3173_ = _e1862;
                                    }
                                    let _e1865 = phi_3173_;
                                    if (_e1854 < 0f) {
                                        phi_3179_ = -(_e1854);
                                    } else {
                                        phi_3179_ = _e1854;
                                    }
                                    let _e1869 = phi_3179_;
                                    if (_e1865 > _e1869) {
                                        phi_3184_ = _e1865;
                                    } else {
                                        phi_3184_ = _e1869;
                                    }
                                    let _e1872 = phi_3184_;
                                    let _e1873 = function_8(_e1872);
                                    let _e1874 = (_e1844 * _e1873);
                                    let _e1875 = (_e1849 * _e1873);
                                    let _e1876 = (_e1854 * _e1873);
                                    let _e1881 = (((_e1874 * _e1874) + (_e1875 * _e1875)) + (_e1876 * _e1876));
                                    if (_e1881 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1881 > 0f) {
                                            phi_3207_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3207_ = 0f;
                                        }
                                        let _e1934 = phi_3207_;
                                        phi_3271_ = _e1934;
                                    } else {
                                        phi_3214_ = type_14(0i, 5i);
                                        phi_3217_ = bitcast<f32>(((bitcast<u32>(_e1881) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1889 = phi_3214_;
                                            let _e1891 = phi_3217_;
                                            local_9 = _e1891;
                                            if (_e1889.member < _e1889.member_1) {
                                                let _e1898 = (_e1889.member + 1i);
                                                if ((false == (_e1898 > _e1889.member)) != false) {
                                                    phi_3238_ = true;
                                                } else {
                                                    phi_3238_ = false;
                                                }
                                                let _e1903 = phi_3238_;
                                                if _e1903 {
                                                    phi_3244_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_3244_ = type_15(1u, _e1898);
                                                }
                                                let _e1908 = phi_3244_;
                                                phi_3215_ = type_14(_e1908.member_1, _e1889.member_1);
                                                phi_3258_ = type_15(1u, _e1889.member);
                                            } else {
                                                phi_3215_ = _e1889;
                                                phi_3258_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1914 = phi_3215_;
                                            let _e1916 = phi_3258_;
                                            let _e1919 = (bitcast<i32>(_e1916.member) != 0i);
                                            if _e1919 {
                                                phi_3218_ = (0.5f * (_e1891 + (_e1881 / _e1891)));
                                            } else {
                                                phi_3218_ = f32();
                                            }
                                            let _e1924 = phi_3218_;
                                            continue;
                                            continuing {
                                                phi_3214_ = _e1914;
                                                phi_3217_ = _e1924;
                                                break if !(_e1919);
                                            }
                                        }
                                        let _e1929 = local_9;
                                        phi_3271_ = (_e1929 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1936 = phi_3271_;
                                    let _e1937 = (1f / _e1936);
                                    let _e1938 = (_e1874 * _e1937);
                                    let _e1939 = (_e1875 * _e1937);
                                    let _e1940 = (_e1876 * _e1937);
                                    let _e1947 = ((3f - (((_e1938 * _e1938) + (_e1939 * _e1939)) + (_e1940 * _e1940))) * 0.5f);
                                    phi_3288_ = array<f32, 3>((_e1938 * _e1947), (_e1939 * _e1947), (_e1940 * _e1947));
                                } else {
                                    phi_3288_ = array<f32, 3>(1f, 0f, 0f);
                                }
                                let _e1953 = phi_3288_;
                                phi_3289_ = _e1953;
                            }
                            let _e2052 = phi_3289_;
                            phi_3290_ = _e2052;
                            phi_3291_ = false;
                        } else {
                            phi_3290_ = array<f32, 3>();
                            phi_3291_ = true;
                        }
                        let _e2054 = phi_3290_;
                        let _e2056 = phi_3291_;
                        phi_3292_ = _e2054;
                        phi_3293_ = _e1632;
                        phi_3294_ = _e2056;
                    } else {
                        phi_3292_ = array<f32, 3>();
                        phi_3293_ = _e1257;
                        phi_3294_ = true;
                    }
                    let _e2058 = phi_3292_;
                    let _e2060 = phi_3293_;
                    let _e2062 = phi_3294_;
                    phi_3298_ = _e2060;
                    phi_3299_ = _e2058;
                    phi_3300_ = _e2062;
                }
                let _e2307 = phi_3298_;
                let _e2309 = phi_3299_;
                let _e2311 = phi_3300_;
                if _e2311 {
                    phi_3304_ = _e2307;
                } else {
                    phi_3304_ = _e2309;
                }
                let _e2313 = phi_3304_;
                if ((((_e2313[0] * _e2313[0]) + (_e2313[1] * _e2313[1])) + (_e2313[2] * _e2313[2])) > 0.5f) {
                    phi_3321_ = _e2313;
                } else {
                    phi_3321_ = array<f32, 3>(1f, 0f, 0f);
                }
                let _e2327 = phi_3321_;
                let _e2330 = function_9(_e263[0], _e264[0], _e258);
                let _e2333 = function_9(_e263[1], _e264[1], _e258);
                let _e2336 = function_9(_e263[2], _e264[2], _e258);
                let _e2339 = function_9(_e263[3], _e264[3], _e258);
                if (_e179.member != 0u) {
                    let _e2376 = function_9(_e2330, _e2333, _e814.member);
                    let _e2377 = function_9(_e2336, _e2339, _e814.member_1);
                    phi_3377_ = _e2377;
                    phi_3378_ = _e2376;
                    phi_3379_ = array<f32, 4>((1f - _e814.member), _e814.member, (1f - _e814.member_1), _e814.member_1);
                } else {
                    let _e2342 = ((1f - _e814.member) - _e814.member_1);
                    if (_e2342 > 0f) {
                        phi_3349_ = _e2342;
                    } else {
                        phi_3349_ = 0f;
                    }
                    let _e2345 = phi_3349_;
                    let _e2372 = function_(array<f32, 4>(1f, _e2345, _e814.member, _e814.member_1), _e262);
                    phi_3377_ = array<f32, 3>((((_e2333[0] * _e2345) + (_e2336[0] * _e814.member)) + (_e2339[0] * _e814.member_1)), (((_e2333[1] * _e2345) + (_e2336[1] * _e814.member)) + (_e2339[1] * _e814.member_1)), (((_e2333[2] * _e2345) + (_e2336[2] * _e814.member)) + (_e2339[2] * _e814.member_1)));
                    phi_3378_ = _e2330;
                    phi_3379_ = _e2372;
                }
                let _e2379 = phi_3377_;
                let _e2381 = phi_3378_;
                let _e2383 = phi_3379_;
                let _e2384 = function_9(_e2381, _e2379, 0.5f);
                let _e2388 = params.member.member_2.member;
                let _e2391 = params.member.member_2.member_1;
                geometry.member[_e140] = type_33(array<f32, 3>(((_e2384[0] * _e2391) + _e2388[0]), ((_e2384[1] * _e2391) + _e2388[1]), ((_e2384[2] * _e2391) + _e2388[2])), ((_e878 / _e506) * _e2391), _e2327, _e147, _e2383, _e179.member_1);
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
