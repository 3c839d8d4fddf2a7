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

struct type_16 {
    member: i32,
    member_1: i32,
}

struct type_17 {
    member: u32,
    member_1: i32,
}

struct type_19 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<array<u32, 2>>,
}

struct type_25 {
    member: u32,
}

struct type_26 {
    member: type_7,
    member_1: type_8,
    member_2: type_25,
}

struct type_27 {
    member: type_26,
}

struct type_29 {
    member: array<array<u32, 3>>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 4>,
    member_5: array<u32, 4>,
}

struct type_32 {
    member: array<type_30>,
}

struct type_33 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_35 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
    member_2: array<f64, 3>,
    member_3: array<f64, 3>,
    member_4: f64,
    member_5: f64,
    member_6: f64,
}

struct type_40 {
    member: array<array<f64, 3>>,
}

struct type_41 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_43 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_44 {
    member: f64,
    member_1: f64,
    member_2: array<f64, 3>,
    member_3: f64,
}

@group(0) @binding(1) 
var<storage> paths: type_21;
@group(0) @binding(0) 
var<storage> params: type_27;
@group(0) @binding(3) 
var<storage> edges: type_23;
@group(0) @binding(4) 
var<storage> faces: type_29;
@group(0) @binding(2) 
var<storage> positions: type_40;
@group(0) @binding(5) 
var<storage> contacts: type_10;
@group(0) @binding(6) 
var<storage, read_write> geometry: type_32;

fn function_(param: array<f64, 3>) -> array<f32, 3> {
    return array<f32, 3>(f32(param[0]), f32(param[1]), f32(param[2]));
}

fn function_1(param_1: array<f64, 4>, param_2: u32) -> array<f64, 4> {
    var phi_4679_: array<f64, 4>;

    switch bitcast<i32>(param_2) {
        case 0: {
            phi_4679_ = param_1;
            break;
        }
        case 1: {
            phi_4679_ = array<f64, 4>(param_1[0], param_1[3], param_1[1], param_1[2]);
            break;
        }
        default: {
            phi_4679_ = array<f64, 4>(param_1[0], param_1[2], param_1[3], param_1[1]);
            break;
        }
    }
    let _e14 = phi_4679_;
    return _e14;
}

fn function_2(param_3: array<array<f64, 3>, 2>) -> array<f64, 3> {
    return array<f64, 3>((param_3[1][0] - param_3[0][0]), (param_3[1][1] - param_3[0][1]), (param_3[1][2] - param_3[0][2]));
}

fn function_3(param_4: type_44, param_5: type_44) -> type_44 {
    var phi_4647_: type_44;

    if (param_5.member_3 < param_4.member_3) {
        phi_4647_ = param_5;
    } else {
        phi_4647_ = param_4;
    }
    let _e6 = phi_4647_;
    return _e6;
}

fn function_4(param_6: f64, param_7: f64) -> f64 {
    var phi_3716_: f64;
    var phi_3721_: f64;
    var phi_3722_: f64;

    let _e3 = f64(0f);
    if (param_6 > _e3) {
        if (param_6 < param_7) {
            phi_3716_ = param_6;
        } else {
            phi_3716_ = param_7;
        }
        let _e7 = phi_3716_;
        if (_e7 > _e3) {
            phi_3721_ = _e7;
        } else {
            phi_3721_ = _e3;
        }
        let _e10 = phi_3721_;
        phi_3722_ = _e10;
    } else {
        phi_3722_ = _e3;
    }
    let _e12 = phi_3722_;
    return _e12;
}

fn function_5(param_8: ptr<function, type_35>, param_9: f64, param_10: f64) -> f64 {
    let _e4 = (*param_8).member;
    let _e9 = (*param_8).member_2;
    let _e20 = (*param_8).member_1;
    let _e30 = (*param_8).member_1;
    let _e35 = (*param_8).member_1;
    let _e45 = function_4((((((_e4[0] - (_e9[0] * param_9)) * _e20[0]) + ((_e4[1] - (_e9[1] * param_9)) * _e20[1])) + ((_e4[2] - (_e9[2] * param_9)) * _e20[2])) / (((_e30[0] * _e35[0]) + (_e30[1] * _e35[1])) + (_e30[2] * _e35[2]))), param_10);
    return _e45;
}

fn function_6(param_11: ptr<function, type_35>, param_12: f64, param_13: f64) -> type_44 {
    let _e4 = (*param_11).member;
    let _e9 = (*param_11).member_1;
    let _e20 = (*param_11).member_2;
    let _e27 = ((_e4[0] - (_e9[0] * param_12)) - (_e20[0] * param_13));
    let _e28 = ((_e4[1] - (_e9[1] * param_12)) - (_e20[1] * param_13));
    let _e29 = ((_e4[2] - (_e9[2] * param_12)) - (_e20[2] * param_13));
    return type_44(param_12, param_13, array<f64, 3>(_e27, _e28, _e29), (((_e27 * _e27) + (_e28 * _e28)) + (_e29 * _e29)));
}

fn function_7(param_14: ptr<function, type_35>, param_15: f64, param_16: f64) -> f64 {
    let _e4 = (*param_14).member;
    let _e9 = (*param_14).member_1;
    let _e20 = (*param_14).member_2;
    let _e30 = (*param_14).member_2;
    let _e35 = (*param_14).member_2;
    let _e45 = function_4((((((_e4[0] - (_e9[0] * param_15)) * _e20[0]) + ((_e4[1] - (_e9[1] * param_15)) * _e20[1])) + ((_e4[2] - (_e9[2] * param_15)) * _e20[2])) / (((_e30[0] * _e35[0]) + (_e30[1] * _e35[1])) + (_e30[2] * _e35[2]))), param_16);
    return _e45;
}

fn function_8(param_17: ptr<function, type_35>, param_18: u32) -> type_44 {
    var phi_4345_: f64;
    var phi_4352_: f64;
    var phi_4364_: type_44;
    var phi_4365_: bool;
    var phi_4366_: type_44;
    var phi_4367_: bool;
    var phi_4222_: bool;
    var phi_4223_: bool;
    var phi_4239_: f64;
    var phi_4245_: f64;
    var phi_4248_: type_44;
    var phi_4249_: bool;
    var phi_4250_: type_44;
    var phi_4251_: bool;
    var phi_4252_: type_44;
    var phi_4253_: bool;
    var phi_4371_: type_44;
    var phi_4372_: bool;
    var phi_4447_: type_44;
    var phi_4448_: type_44;
    var phi_4449_: bool;
    var phi_4453_: type_44;

    let _e9 = f64(0f);
    let _e10 = f64(1f);
    let _e11 = (param_18 == 0u);
    let _e13 = (*param_17).member_4;
    if (_e13 > _e9) {
        let _e93 = (*param_17).member_3;
        let _e98 = (*param_17).member_3;
        let _e106 = (((_e93[0] * _e98[0]) + (_e93[1] * _e98[1])) + (_e93[2] * _e98[2]));
        let _e108 = (*param_17).member;
        let _e113 = (*param_17).member_2;
        let _e127 = (*param_17).member_3;
        let _e136 = ((((((_e108[1] * _e113[2]) - (_e108[2] * _e113[1])) * _e127[0]) + (((_e108[2] * _e113[0]) - (_e108[0] * _e113[2])) * _e127[1])) + (((_e108[0] * _e113[1]) - (_e108[1] * _e113[0])) * _e127[2])) / _e106);
        let _e138 = (*param_17).member_1;
        let _e143 = (*param_17).member;
        let _e157 = (*param_17).member_3;
        let _e166 = ((((((_e138[1] * _e143[2]) - (_e138[2] * _e143[1])) * _e157[0]) + (((_e138[2] * _e143[0]) - (_e138[0] * _e143[2])) * _e157[1])) + (((_e138[0] * _e143[1]) - (_e138[1] * _e143[0])) * _e157[2])) / _e106);
        if _e11 {
            phi_4223_ = ((_e136 + _e166) <= _e10);
        } else {
            if (_e136 <= _e10) {
                phi_4222_ = (_e166 <= _e10);
            } else {
                phi_4222_ = false;
            }
            let _e170 = phi_4222_;
            phi_4223_ = _e170;
        }
        let _e174 = phi_4223_;
        if (_e136 >= _e9) {
            if (_e166 >= _e9) {
                if _e174 {
                    if _e11 {
                        phi_4239_ = (_e10 - _e136);
                    } else {
                        phi_4239_ = _e10;
                    }
                    let _e179 = phi_4239_;
                    let _e180 = function_7(param_17, _e136, _e179);
                    if _e11 {
                        phi_4245_ = (_e10 - _e180);
                    } else {
                        phi_4245_ = _e10;
                    }
                    let _e183 = phi_4245_;
                    let _e184 = function_5(param_17, _e180, _e183);
                    let _e185 = function_6(param_17, _e184, _e180);
                    phi_4248_ = _e185;
                    phi_4249_ = false;
                } else {
                    phi_4248_ = type_44();
                    phi_4249_ = true;
                }
                let _e187 = phi_4248_;
                let _e189 = phi_4249_;
                phi_4250_ = _e187;
                phi_4251_ = _e189;
            } else {
                phi_4250_ = type_44();
                phi_4251_ = true;
            }
            let _e191 = phi_4250_;
            let _e193 = phi_4251_;
            phi_4252_ = _e191;
            phi_4253_ = _e193;
        } else {
            phi_4252_ = type_44();
            phi_4253_ = true;
        }
        let _e195 = phi_4252_;
        let _e197 = phi_4253_;
        phi_4371_ = _e195;
        phi_4372_ = _e197;
    } else {
        if _e11 {
            phi_4366_ = type_44();
            phi_4367_ = true;
        } else {
            let _e16 = (*param_17).member;
            let _e21 = (*param_17).member_1;
            let _e29 = (((_e16[0] * _e21[0]) + (_e16[1] * _e21[1])) + (_e16[2] * _e21[2]));
            let _e31 = (*param_17).member;
            let _e36 = (*param_17).member_2;
            let _e44 = (*param_17).member_1;
            let _e52 = ((((_e31[0] - _e36[0]) * _e44[0]) + ((_e31[1] - _e36[1]) * _e44[1])) + ((_e31[2] - _e36[2]) * _e44[2]));
            let _e54 = (*param_17).member_1;
            let _e59 = (*param_17).member_1;
            let _e67 = (((_e54[0] * _e59[0]) + (_e54[1] * _e59[1])) + (_e54[2] * _e59[2]));
            if (_e29 < _e52) {
                phi_4345_ = _e29;
            } else {
                phi_4345_ = _e52;
            }
            let _e70 = phi_4345_;
            let _e72 = function_4((_e70 / _e67), _e10);
            if (_e29 > _e52) {
                phi_4352_ = _e29;
            } else {
                phi_4352_ = _e52;
            }
            let _e75 = phi_4352_;
            let _e77 = function_4((_e75 / _e67), _e10);
            if (_e72 < _e77) {
                let _e81 = ((_e72 + _e77) * f64(0.5f));
                let _e82 = function_7(param_17, _e81, _e10);
                let _e83 = function_6(param_17, _e81, _e82);
                phi_4364_ = _e83;
                phi_4365_ = false;
            } else {
                phi_4364_ = type_44();
                phi_4365_ = true;
            }
            let _e85 = phi_4364_;
            let _e87 = phi_4365_;
            phi_4366_ = _e85;
            phi_4367_ = _e87;
        }
        let _e89 = phi_4366_;
        let _e91 = phi_4367_;
        phi_4371_ = _e89;
        phi_4372_ = _e91;
    }
    let _e199 = phi_4371_;
    let _e201 = phi_4372_;
    if _e201 {
        let _e202 = function_5(param_17, _e9, _e10);
        let _e203 = function_6(param_17, _e202, _e9);
        let _e204 = function_7(param_17, _e9, _e10);
        let _e205 = function_6(param_17, _e9, _e204);
        let _e206 = function_3(_e203, _e205);
        if _e11 {
            let _e214 = (*param_17).member_2;
            let _e219 = (*param_17).member_1;
            let _e223 = (_e214[0] - _e219[0]);
            let _e224 = (_e214[1] - _e219[1]);
            let _e225 = (_e214[2] - _e219[2]);
            let _e227 = (*param_17).member;
            let _e232 = (*param_17).member_1;
            let _e250 = function_4((((((_e227[0] - _e232[0]) * _e223) + ((_e227[1] - _e232[1]) * _e224)) + ((_e227[2] - _e232[2]) * _e225)) / (((_e223 * _e223) + (_e224 * _e224)) + (_e225 * _e225))), _e10);
            let _e252 = function_6(param_17, (_e10 - _e250), _e250);
            let _e253 = function_3(_e206, _e252);
            phi_4447_ = _e253;
        } else {
            let _e207 = function_7(param_17, _e10, _e10);
            let _e208 = function_6(param_17, _e10, _e207);
            let _e209 = function_5(param_17, _e10, _e10);
            let _e210 = function_6(param_17, _e209, _e10);
            let _e211 = function_3(_e208, _e210);
            let _e212 = function_3(_e206, _e211);
            phi_4447_ = _e212;
        }
        let _e255 = phi_4447_;
        phi_4448_ = _e255;
        phi_4449_ = false;
    } else {
        phi_4448_ = type_44();
        phi_4449_ = true;
    }
    let _e257 = phi_4448_;
    let _e259 = phi_4449_;
    if _e259 {
        phi_4453_ = _e199;
    } else {
        phi_4453_ = _e257;
    }
    let _e261 = phi_4453_;
    return _e261;
}

fn function_9(param_19: f64) -> f64 {
    var phi_4074_: u64;
    var phi_4078_: f64;
    var phi_4080_: f64;

    if ((bitcast<u64>(param_19) & 9218868437227405312lu) != 9218868437227405312lu) {
        if (param_19 >= 2.2250738585072014e-308lf) {
            let _e15 = (9214364837600034816lu - (bitcast<u64>(param_19) & 9218868437227405312lu));
            if (_e15 > 4503599627370496lu) {
                phi_4074_ = _e15;
            } else {
                phi_4074_ = 4503599627370496lu;
            }
            let _e18 = phi_4074_;
            phi_4078_ = bitcast<f64>(_e18);
        } else {
            phi_4078_ = (f64(1f) / 2.2250738585072014e-308lf);
        }
        let _e21 = phi_4078_;
        phi_4080_ = _e21;
    } else {
        phi_4080_ = f64(1f);
    }
    let _e23 = phi_4080_;
    return _e23;
}

fn function_10(param_20: array<f64, 3>, param_21: array<f64, 3>, param_22: f64) -> array<f64, 3> {
    let _e5 = (f64(1f) - param_22);
    return array<f64, 3>(((param_20[0] * _e5) + (param_21[0] * param_22)), ((param_20[1] * _e5) + (param_21[1] * param_22)), ((param_20[2] * _e5) + (param_21[2] * param_22)));
}

fn function_11(param_23: ptr<function, array<array<f64, 3>, 4>>, param_24: u32) -> array<array<f64, 3>, 4> {
    var phi_4051_: array<array<f64, 3>, 4>;

    switch bitcast<i32>(param_24) {
        case 0: {
            let _e32 = (*param_23);
            phi_4051_ = array<array<f64, 3>, 4>(array<f64, 3>(_e32[0][0], _e32[0][1], _e32[0][2]), array<f64, 3>(_e32[1][0], _e32[1][1], _e32[1][2]), array<f64, 3>(_e32[2][0], _e32[2][1], _e32[2][2]), array<f64, 3>(_e32[3][0], _e32[3][1], _e32[3][2]));
            break;
        }
        case 1: {
            let _e8 = (*param_23)[0u];
            let _e14 = (*param_23)[2u];
            let _e20 = (*param_23)[3u];
            let _e26 = (*param_23)[1u];
            phi_4051_ = array<array<f64, 3>, 4>(array<f64, 3>(_e8[0], _e8[1], _e8[2]), array<f64, 3>(_e14[0], _e14[1], _e14[2]), array<f64, 3>(_e20[0], _e20[1], _e20[2]), array<f64, 3>(_e26[0], _e26[1], _e26[2]));
            break;
        }
        default: {
            let _e55 = (*param_23)[0u];
            let _e61 = (*param_23)[3u];
            let _e67 = (*param_23)[1u];
            let _e73 = (*param_23)[2u];
            phi_4051_ = array<array<f64, 3>, 4>(array<f64, 3>(_e55[0], _e55[1], _e55[2]), array<f64, 3>(_e61[0], _e61[1], _e61[2]), array<f64, 3>(_e67[0], _e67[1], _e67[2]), array<f64, 3>(_e73[0], _e73[1], _e73[2]));
            break;
        }
    }
    let _e80 = phi_4051_;
    return _e80;
}

fn function_12(param_25: ptr<function, array<array<f64, 3>, 4>>, param_26: ptr<function, array<array<f64, 3>, 4>>, param_27: f64) -> u32 {
    var phi_3778_: f64;
    var phi_3785_: f64;
    var phi_3793_: f64;
    var phi_3846_: f64;
    var phi_3853_: f64;
    var phi_3861_: f64;
    var phi_3914_: f64;
    var phi_3921_: f64;
    var phi_3929_: f64;
    var phi_3939_: bool;
    var phi_3940_: bool;
    var phi_3948_: u32;
    var phi_3949_: u32;

    let _e11 = (*param_25)[3u];
    let _e16 = (*param_25)[2u];
    let _e25 = (*param_26)[3u];
    let _e30 = (*param_26)[2u];
    let _e38 = function_10(array<f64, 3>((_e11[0] - _e16[0]), (_e11[1] - _e16[1]), (_e11[2] - _e16[2])), array<f64, 3>((_e25[0] - _e30[0]), (_e25[1] - _e30[1]), (_e25[2] - _e30[2])), param_27);
    if (_e38[0] < 0.0lf) {
        phi_3778_ = -(_e38[0]);
    } else {
        phi_3778_ = _e38[0];
    }
    let _e43 = phi_3778_;
    if (_e38[1] < 0.0lf) {
        phi_3785_ = -(_e38[1]);
    } else {
        phi_3785_ = _e38[1];
    }
    let _e48 = phi_3785_;
    if (_e38[2] < 0.0lf) {
        phi_3793_ = -(_e38[2]);
    } else {
        phi_3793_ = _e38[2];
    }
    let _e54 = phi_3793_;
    let _e55 = ((_e43 + _e48) + _e54);
    let _e57 = (*param_25)[1u];
    let _e62 = (*param_25)[3u];
    let _e71 = (*param_26)[1u];
    let _e76 = (*param_26)[3u];
    let _e84 = function_10(array<f64, 3>((_e57[0] - _e62[0]), (_e57[1] - _e62[1]), (_e57[2] - _e62[2])), array<f64, 3>((_e71[0] - _e76[0]), (_e71[1] - _e76[1]), (_e71[2] - _e76[2])), param_27);
    if (_e84[0] < 0.0lf) {
        phi_3846_ = -(_e84[0]);
    } else {
        phi_3846_ = _e84[0];
    }
    let _e89 = phi_3846_;
    if (_e84[1] < 0.0lf) {
        phi_3853_ = -(_e84[1]);
    } else {
        phi_3853_ = _e84[1];
    }
    let _e94 = phi_3853_;
    if (_e84[2] < 0.0lf) {
        phi_3861_ = -(_e84[2]);
    } else {
        phi_3861_ = _e84[2];
    }
    let _e100 = phi_3861_;
    let _e101 = ((_e89 + _e94) + _e100);
    let _e103 = (*param_25)[2u];
    let _e108 = (*param_25)[1u];
    let _e117 = (*param_26)[2u];
    let _e122 = (*param_26)[1u];
    let _e130 = function_10(array<f64, 3>((_e103[0] - _e108[0]), (_e103[1] - _e108[1]), (_e103[2] - _e108[2])), array<f64, 3>((_e117[0] - _e122[0]), (_e117[1] - _e122[1]), (_e117[2] - _e122[2])), param_27);
    if (_e130[0] < 0.0lf) {
        phi_3914_ = -(_e130[0]);
    } else {
        phi_3914_ = _e130[0];
    }
    let _e135 = phi_3914_;
    if (_e130[1] < 0.0lf) {
        phi_3921_ = -(_e130[1]);
    } else {
        phi_3921_ = _e130[1];
    }
    let _e140 = phi_3921_;
    if (_e130[2] < 0.0lf) {
        phi_3929_ = -(_e130[2]);
    } else {
        phi_3929_ = _e130[2];
    }
    let _e146 = phi_3929_;
    let _e147 = ((_e135 + _e140) + _e146);
    if (_e55 >= _e101) {
        if (_e55 >= _e147) {
            phi_3939_ = false;
        } else {
            phi_3939_ = true;
        }
        let _e151 = phi_3939_;
        phi_3940_ = _e151;
    } else {
        phi_3940_ = true;
    }
    let _e153 = phi_3940_;
    if _e153 {
        if (_e101 >= _e147) {
            phi_3948_ = 1u;
        } else {
            phi_3948_ = 2u;
        }
        let _e156 = phi_3948_;
        phi_3949_ = _e156;
    } else {
        phi_3949_ = 0u;
    }
    let _e158 = phi_3949_;
    return _e158;
}

fn function_13(param_28: array<f32, 3>) -> array<f64, 3> {
    var phi_3615_: f64;
    var phi_3593_: array<u32, 2>;
    var phi_3616_: f64;
    var phi_3658_: f64;
    var phi_3636_: array<u32, 2>;
    var phi_3659_: f64;
    var phi_3701_: f64;
    var phi_3679_: array<u32, 2>;
    var phi_3702_: f64;

    let _e10 = bitcast<u32>(param_28[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e21 = bitcast<u32>(param_28[0]);
        let _e22 = (_e21 & 2147483647u);
        if (_e22 < 8388608u) {
            phi_3593_ = array<u32, 2>(0u, 0u);
        } else {
            phi_3593_ = array<u32, 2>((_e21 << bitcast<u32>(29i)), ((_e21 ^ _e22) | ((_e22 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e33 = phi_3593_;
        phi_3616_ = bitcast<f64>(((u64(_e33[1]) * 4294967296lu) + u64(_e33[0])));
    } else {
        if (_e10 == _e11) {
            phi_3615_ = (f64(_e11) * 1.401298464324817e-45lf);
        } else {
            phi_3615_ = -((f64(_e11) * 1.401298464324817e-45lf));
        }
        let _e20 = phi_3615_;
        phi_3616_ = _e20;
    }
    let _e42 = phi_3616_;
    let _e44 = bitcast<u32>(param_28[1]);
    let _e45 = (_e44 & 2147483647u);
    if (_e45 >= 8388608u) {
        let _e55 = bitcast<u32>(param_28[1]);
        let _e56 = (_e55 & 2147483647u);
        if (_e56 < 8388608u) {
            phi_3636_ = array<u32, 2>(0u, 0u);
        } else {
            phi_3636_ = array<u32, 2>((_e55 << bitcast<u32>(29i)), ((_e55 ^ _e56) | ((_e56 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e67 = phi_3636_;
        phi_3659_ = bitcast<f64>(((u64(_e67[1]) * 4294967296lu) + u64(_e67[0])));
    } else {
        if (_e44 == _e45) {
            phi_3658_ = (f64(_e45) * 1.401298464324817e-45lf);
        } else {
            phi_3658_ = -((f64(_e45) * 1.401298464324817e-45lf));
        }
        let _e54 = phi_3658_;
        phi_3659_ = _e54;
    }
    let _e76 = phi_3659_;
    let _e78 = bitcast<u32>(param_28[2]);
    let _e79 = (_e78 & 2147483647u);
    if (_e79 >= 8388608u) {
        let _e89 = bitcast<u32>(param_28[2]);
        let _e90 = (_e89 & 2147483647u);
        if (_e90 < 8388608u) {
            phi_3679_ = array<u32, 2>(0u, 0u);
        } else {
            phi_3679_ = array<u32, 2>((_e89 << bitcast<u32>(29i)), ((_e89 ^ _e90) | ((_e90 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e101 = phi_3679_;
        phi_3702_ = bitcast<f64>(((u64(_e101[1]) * 4294967296lu) + u64(_e101[0])));
    } else {
        if (_e78 == _e79) {
            phi_3701_ = (f64(_e79) * 1.401298464324817e-45lf);
        } else {
            phi_3701_ = -((f64(_e79) * 1.401298464324817e-45lf));
        }
        let _e88 = phi_3701_;
        phi_3702_ = _e88;
    }
    let _e110 = phi_3702_;
    return array<f64, 3>(_e42, _e76, _e110);
}

fn function_14(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_35;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: array<array<f64, 3>, 4>;
    var phi_206_: u32;
    var phi_216_: u32;
    var phi_223_: u32;
    var phi_239_: u32;
    var phi_260_: u32;
    var phi_261_: u32;
    var phi_264_: type_12;
    var phi_265_: type_12;
    var phi_288_: type_12;
    var phi_431_: type_33;
    var phi_636_: type_41;
    var phi_693_: u32;
    var phi_854_: type_43;
    var phi_870_: f64;
    var phi_877_: f64;
    var phi_882_: f64;
    var phi_889_: f64;
    var phi_894_: f64;
    var phi_901_: f64;
    var phi_908_: f64;
    var phi_913_: f64;
    var phi_920_: f64;
    var phi_925_: f64;
    var phi_930_: f64;
    var phi_937_: f64;
    var phi_944_: f64;
    var phi_949_: f64;
    var phi_956_: f64;
    var phi_961_: f64;
    var phi_966_: f64;
    var phi_996_: f64;
    var phi_1003_: f64;
    var phi_1008_: f64;
    var phi_1015_: f64;
    var phi_1020_: f64;
    var phi_1028_: f64;
    var phi_1035_: f64;
    var phi_1040_: f64;
    var phi_1047_: f64;
    var phi_1052_: f64;
    var phi_1057_: f64;
    var phi_1067_: f64;
    var phi_1074_: f64;
    var phi_1079_: f64;
    var phi_1086_: f64;
    var phi_1091_: f64;
    var phi_1099_: f64;
    var phi_1106_: f64;
    var phi_1111_: f64;
    var phi_1118_: f64;
    var phi_1123_: f64;
    var phi_1128_: f64;
    var phi_1138_: f64;
    var phi_1145_: f64;
    var phi_1150_: f64;
    var phi_1157_: f64;
    var phi_1162_: f64;
    var phi_1170_: f64;
    var phi_1177_: f64;
    var phi_1182_: f64;
    var phi_1189_: f64;
    var phi_1194_: f64;
    var phi_1199_: f64;
    var phi_1235_: f64;
    var phi_1241_: f64;
    var phi_1246_: f64;
    var phi_1252_: f64;
    var phi_1257_: f64;
    var phi_1265_: f64;
    var phi_1271_: f64;
    var phi_1276_: f64;
    var phi_1282_: f64;
    var phi_1287_: f64;
    var phi_1315_: type_16;
    var phi_1318_: f64;
    var phi_1339_: bool;
    var phi_1345_: type_17;
    var phi_1316_: type_16;
    var phi_1359_: type_17;
    var phi_1319_: f64;
    var local_3: f64;
    var phi_1308_: f64;
    var phi_1372_: f64;
    var phi_1382_: f64;
    var phi_1388_: f64;
    var phi_1438_: type_16;
    var phi_1441_: f64;
    var phi_1462_: bool;
    var phi_1468_: type_17;
    var phi_1439_: type_16;
    var phi_1482_: type_17;
    var phi_1442_: f64;
    var local_4: f64;
    var phi_1431_: f64;
    var phi_1495_: f64;
    var phi_1505_: f64;
    var phi_1511_: f64;
    var phi_1552_: bool;
    var phi_1558_: bool;
    var phi_1574_: bool;
    var phi_1575_: bool;
    var phi_1576_: bool;
    var phi_1577_: bool;
    var phi_1578_: bool;
    var phi_1582_: bool;
    var phi_1934_: f64;
    var phi_1941_: f64;
    var phi_1946_: f64;
    var phi_1953_: f64;
    var phi_1958_: f64;
    var phi_1966_: f64;
    var phi_1973_: f64;
    var phi_1978_: f64;
    var phi_1985_: f64;
    var phi_1990_: f64;
    var phi_1995_: f64;
    var phi_2005_: f64;
    var phi_2012_: f64;
    var phi_2017_: f64;
    var phi_2024_: f64;
    var phi_2029_: f64;
    var phi_2037_: f64;
    var phi_2044_: f64;
    var phi_2049_: f64;
    var phi_2056_: f64;
    var phi_2061_: f64;
    var phi_2066_: f64;
    var phi_2076_: f64;
    var phi_2083_: f64;
    var phi_2088_: f64;
    var phi_2095_: f64;
    var phi_2100_: f64;
    var phi_2108_: f64;
    var phi_2115_: f64;
    var phi_2120_: f64;
    var phi_2127_: f64;
    var phi_2132_: f64;
    var phi_2137_: f64;
    var phi_2160_: f64;
    var phi_2166_: f64;
    var phi_2171_: f64;
    var phi_2177_: f64;
    var phi_2182_: f64;
    var phi_2213_: type_16;
    var phi_2216_: f64;
    var phi_2237_: bool;
    var phi_2243_: type_17;
    var phi_2214_: type_16;
    var phi_2257_: type_17;
    var phi_2217_: f64;
    var local_5: f64;
    var phi_2206_: f64;
    var phi_2270_: f64;
    var phi_2298_: f64;
    var phi_2304_: f64;
    var phi_2311_: f64;
    var phi_2325_: f64;
    var phi_2339_: array<f64, 3>;
    var phi_2340_: array<f64, 3>;
    var phi_2341_: bool;
    var phi_2342_: array<f64, 3>;
    var phi_2343_: bool;
    var phi_2353_: bool;
    var phi_2354_: bool;
    var phi_2389_: array<f64, 3>;
    var phi_2390_: bool;
    var phi_2391_: array<f64, 3>;
    var phi_2392_: bool;
    var phi_2393_: array<f64, 3>;
    var phi_2394_: bool;
    var phi_2416_: f64;
    var phi_2423_: f64;
    var phi_2428_: f64;
    var phi_2435_: f64;
    var phi_2440_: f64;
    var phi_2453_: f64;
    var phi_2460_: f64;
    var phi_2465_: f64;
    var phi_2472_: f64;
    var phi_2477_: f64;
    var phi_2482_: bool;
    var phi_2483_: bool;
    var phi_2493_: array<f64, 3>;
    var phi_2494_: bool;
    var phi_2495_: array<f64, 3>;
    var phi_2496_: bool;
    var phi_2510_: array<f64, 3>;
    var phi_2511_: array<f64, 3>;
    var phi_2512_: array<f64, 3>;
    var phi_2519_: f64;
    var phi_2526_: f64;
    var phi_2531_: f64;
    var phi_2538_: f64;
    var phi_2543_: f64;
    var phi_2555_: f64;
    var phi_2562_: f64;
    var phi_2567_: f64;
    var phi_2574_: f64;
    var phi_2579_: f64;
    var phi_2613_: type_16;
    var phi_2616_: f64;
    var phi_2637_: bool;
    var phi_2643_: type_17;
    var phi_2614_: type_16;
    var phi_2657_: type_17;
    var phi_2617_: f64;
    var local_6: f64;
    var phi_2606_: f64;
    var phi_2670_: f64;
    var phi_2699_: array<f64, 3>;
    var phi_2706_: f64;
    var phi_2713_: f64;
    var phi_2721_: f64;
    var phi_2739_: f64;
    var phi_2745_: f64;
    var phi_2750_: f64;
    var phi_2756_: f64;
    var phi_2761_: f64;
    var phi_2792_: type_16;
    var phi_2795_: f64;
    var phi_2816_: bool;
    var phi_2822_: type_17;
    var phi_2793_: type_16;
    var phi_2836_: type_17;
    var phi_2796_: f64;
    var local_7: f64;
    var phi_2785_: f64;
    var phi_2849_: f64;
    var phi_2867_: array<f64, 3>;
    var phi_2868_: bool;
    var phi_2869_: array<f64, 3>;
    var phi_2870_: bool;
    var phi_3030_: f64;
    var phi_3037_: f64;
    var phi_3042_: f64;
    var phi_3049_: f64;
    var phi_3054_: f64;
    var phi_3061_: f64;
    var phi_3068_: f64;
    var phi_3073_: f64;
    var phi_3080_: f64;
    var phi_3085_: f64;
    var phi_3090_: array<f64, 3>;
    var phi_3097_: f64;
    var phi_3104_: f64;
    var phi_3109_: f64;
    var phi_3116_: f64;
    var phi_3121_: f64;
    var phi_3132_: f64;
    var phi_3139_: f64;
    var phi_3146_: f64;
    var phi_3156_: array<f64, 3>;
    var phi_3157_: bool;
    var phi_3158_: array<f64, 3>;
    var phi_3159_: bool;
    var phi_3169_: array<f64, 3>;
    var phi_3170_: array<f64, 3>;
    var phi_3177_: f64;
    var phi_3184_: f64;
    var phi_3189_: f64;
    var phi_3196_: f64;
    var phi_3201_: f64;
    var phi_3235_: type_16;
    var phi_3238_: f64;
    var phi_3259_: bool;
    var phi_3265_: type_17;
    var phi_3236_: type_16;
    var phi_3279_: type_17;
    var phi_3239_: f64;
    var local_8: f64;
    var phi_3228_: f64;
    var phi_3292_: f64;
    var phi_3329_: f64;
    var phi_3335_: f64;
    var phi_3340_: f64;
    var phi_3346_: f64;
    var phi_3351_: f64;
    var phi_3382_: type_16;
    var phi_3385_: f64;
    var phi_3406_: bool;
    var phi_3412_: type_17;
    var phi_3383_: type_16;
    var phi_3426_: type_17;
    var phi_3386_: f64;
    var local_9: f64;
    var phi_3375_: f64;
    var phi_3439_: f64;
    var phi_3458_: array<f64, 3>;
    var phi_2882_: f64;
    var phi_2888_: f64;
    var phi_2893_: f64;
    var phi_2899_: f64;
    var phi_2904_: f64;
    var phi_2935_: type_16;
    var phi_2938_: f64;
    var phi_2959_: bool;
    var phi_2965_: type_17;
    var phi_2936_: type_16;
    var phi_2979_: type_17;
    var phi_2939_: f64;
    var local_10: f64;
    var phi_2928_: f64;
    var phi_2992_: f64;
    var phi_3459_: array<f64, 3>;
    var phi_3460_: array<f64, 3>;
    var phi_3461_: bool;
    var phi_3462_: array<f64, 3>;
    var phi_3463_: array<f64, 3>;
    var phi_3464_: bool;
    var phi_1644_: array<f64, 3>;
    var phi_1651_: f64;
    var phi_1658_: f64;
    var phi_1663_: f64;
    var phi_1670_: f64;
    var phi_1675_: f64;
    var phi_1709_: type_16;
    var phi_1712_: f64;
    var phi_1733_: bool;
    var phi_1739_: type_17;
    var phi_1710_: type_16;
    var phi_1753_: type_17;
    var phi_1713_: f64;
    var local_11: f64;
    var phi_1702_: f64;
    var phi_1766_: f64;
    var phi_1784_: array<f64, 3>;
    var phi_1785_: bool;
    var phi_1786_: array<f64, 3>;
    var phi_1787_: bool;
    var phi_1788_: array<f64, 3>;
    var phi_1789_: bool;
    var phi_1798_: f64;
    var phi_1804_: f64;
    var phi_1809_: f64;
    var phi_1815_: f64;
    var phi_1820_: f64;
    var phi_1851_: type_16;
    var phi_1854_: f64;
    var phi_1875_: bool;
    var phi_1881_: type_17;
    var phi_1852_: type_16;
    var phi_1895_: type_17;
    var phi_1855_: f64;
    var local_12: f64;
    var phi_1844_: f64;
    var phi_1908_: f64;
    var phi_1926_: array<f64, 3>;
    var phi_3468_: array<f64, 3>;
    var phi_3469_: array<f64, 3>;
    var phi_3470_: bool;
    var phi_3474_: array<f64, 3>;
    var phi_3494_: array<f64, 3>;
    var phi_3523_: f64;
    var phi_3551_: array<f64, 3>;
    var phi_3552_: array<f64, 3>;
    var phi_3553_: array<f64, 4>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e51 = id_2;
    let _e52 = n_2;
    let _e53 = lane_2;
    let _e65 = ((_e51.y * _e52.x) + _e51.x);
    let _e68 = (_e52.x * _e52.y);
    let _e71 = params.member.member_1.member_2;
    let _e73 = contacts.member[0u];
    if (_e71 < _e73) {
        phi_206_ = _e71;
    } else {
        phi_206_ = _e73;
    }
    let _e76 = phi_206_;
    let _e78 = params.member.member_1.member_1;
    if (_e76 > _e78) {
        let _e81 = params.member.member_1.member_1;
        phi_216_ = (_e76 - _e81);
    } else {
        phi_216_ = 0u;
    }
    let _e84 = phi_216_;
    let _e86 = params.member.member_1.member;
    if (_e86 < _e84) {
        phi_223_ = _e86;
    } else {
        phi_223_ = _e84;
    }
    let _e89 = phi_223_;
    let _e90 = (_e89 / 64u);
    if ((_e89 % 64u) > 0u) {
        phi_239_ = (_e90 + 1u);
    } else {
        phi_239_ = _e90;
    }
    let _e95 = phi_239_;
    if (_e95 > _e65) {
        let _e97 = (_e95 - _e65);
        if (_e68 == 0u) {
            return;
        }
        let _e99 = (_e97 / _e68);
        if (_e68 == 0u) {
            return;
        }
        if ((_e97 % _e68) > 0u) {
            phi_260_ = (_e99 + 1u);
        } else {
            phi_260_ = _e99;
        }
        let _e105 = phi_260_;
        phi_261_ = _e105;
    } else {
        phi_261_ = 0u;
    }
    let _e107 = phi_261_;
    phi_264_ = type_12(0u, _e107);
    loop {
        let _e110 = phi_264_;
        if (_e110.member < _e110.member_1) {
            phi_265_ = type_12((_e110.member + 1u), _e110.member_1);
            phi_288_ = type_12(1u, _e110.member);
        } else {
            phi_265_ = _e110;
            phi_288_ = type_12(0u, type_12().member_1);
        }
        let _e122 = phi_265_;
        let _e124 = phi_288_;
        let _e128 = (bitcast<i32>(_e124.member) != 0i);
        if _e128 {
            let _e132 = (((_e65 + (_e124.member_1 * _e68)) * 64u) + _e53);
            if (_e132 < _e89) {
                let _e136 = params.member.member_1.member_1;
                let _e137 = (_e136 + _e132);
                let _e138 = (7u * _e137);
                let _e141 = contacts.member[(4u + _e138)];
                let _e144 = contacts.member[(_e138 + 5u)];
                let _e147 = contacts.member[(_e138 + 6u)];
                let _e150 = contacts.member[(_e138 + 7u)];
                let _e153 = contacts.member[(_e138 + 8u)];
                let _e156 = contacts.member[(_e138 + 9u)];
                if (_e141 == 0u) {
                    let _e169 = faces.member[_e150];
                    phi_431_ = type_33(0u, array<u32, 4>(_e147, _e169[0], _e169[1], _e169[2]));
                } else {
                    let _e159 = edges.member[_e147];
                    let _e161 = edges.member[_e150];
                    phi_431_ = type_33(1u, array<u32, 4>(_e159[0], _e159[1], _e161[0], _e161[1]));
                }
                let _e176 = phi_431_;
                let _e181 = params.member.member.member_1;
                if ((_e181 & 8u) != 0u) {
                    let _e225 = paths.member[_e176.member_1[0]];
                    let _e228 = paths.member[_e176.member_1[1]];
                    let _e235 = paths.member[_e176.member_1[2]];
                    let _e238 = paths.member[_e176.member_1[3]];
                    let _e275 = function_13(array<f32, 3>(_e225.member[0], _e225.member[1], _e225.member[2]));
                    let _e276 = function_13(array<f32, 3>(_e228.member[0], _e228.member[1], _e228.member[2]));
                    let _e277 = function_13(array<f32, 3>(_e235.member[0], _e235.member[1], _e235.member[2]));
                    let _e278 = function_13(array<f32, 3>(_e238.member[0], _e238.member[1], _e238.member[2]));
                    let _e280 = function_13(array<f32, 3>(_e225.member_1[0], _e225.member_1[1], _e225.member_1[2]));
                    let _e281 = function_13(array<f32, 3>(_e228.member_1[0], _e228.member_1[1], _e228.member_1[2]));
                    let _e282 = function_13(array<f32, 3>(_e235.member_1[0], _e235.member_1[1], _e235.member_1[2]));
                    let _e283 = function_13(array<f32, 3>(_e238.member_1[0], _e238.member_1[1], _e238.member_1[2]));
                    phi_636_ = type_41(array<array<f64, 3>, 4>(_e275, _e276, _e277, _e278), array<array<f64, 3>, 4>(_e280, _e281, _e282, _e283));
                } else {
                    let _e186 = positions.member[_e176.member_1[0]];
                    let _e189 = params.member.member.member[0u];
                    let _e192 = positions.member[(_e189 + _e176.member_1[0])];
                    let _e195 = positions.member[_e176.member_1[1]];
                    let _e198 = params.member.member.member[0u];
                    let _e201 = positions.member[(_e198 + _e176.member_1[1])];
                    let _e204 = positions.member[_e176.member_1[2]];
                    let _e207 = params.member.member.member[0u];
                    let _e210 = positions.member[(_e207 + _e176.member_1[2])];
                    let _e213 = positions.member[_e176.member_1[3]];
                    let _e216 = params.member.member.member[0u];
                    let _e219 = positions.member[(_e216 + _e176.member_1[3])];
                    phi_636_ = type_41(array<array<f64, 3>, 4>(_e186, _e195, _e204, _e213), array<array<f64, 3>, 4>(_e192, _e201, _e210, _e219));
                }
                let _e287 = phi_636_;
                local_1 = array<array<f64, 3>, 4>(array<f64, 3>(_e287.member[0][0], _e287.member[0][1], _e287.member[0][2]), array<f64, 3>(_e287.member[1][0], _e287.member[1][1], _e287.member[1][2]), array<f64, 3>(_e287.member[2][0], _e287.member[2][1], _e287.member[2][2]), array<f64, 3>(_e287.member[3][0], _e287.member[3][1], _e287.member[3][2]));
                local_2 = array<array<f64, 3>, 4>(array<f64, 3>(_e287.member_1[0][0], _e287.member_1[0][1], _e287.member_1[0][2]), array<f64, 3>(_e287.member_1[1][0], _e287.member_1[1][1], _e287.member_1[1][2]), array<f64, 3>(_e287.member_1[2][0], _e287.member_1[2][1], _e287.member_1[2][2]), array<f64, 3>(_e287.member_1[3][0], _e287.member_1[3][1], _e287.member_1[3][2]));
                let _e337 = f64(1f);
                let _e338 = function_4(bitcast<f64>(((u64(_e156) * 4294967296lu) + u64(_e153))), _e337);
                if (_e176.member == 0u) {
                    let _e340 = function_12((&local_1), (&local_2), _e338);
                    phi_693_ = _e340;
                } else {
                    phi_693_ = 0u;
                }
                let _e342 = phi_693_;
                let _e343 = function_11((&local_1), _e342);
                let _e344 = function_11((&local_2), _e342);
                if (_e176.member != 0u) {
                    phi_854_ = type_43(array<array<f64, 3>, 2>(array<f64, 3>((_e343[2][0] - _e343[0][0]), (_e343[2][1] - _e343[0][1]), (_e343[2][2] - _e343[0][2])), array<f64, 3>((_e344[2][0] - _e344[0][0]), (_e344[2][1] - _e344[0][1]), (_e344[2][2] - _e344[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e343[1][0] - _e343[0][0]), (_e343[1][1] - _e343[0][1]), (_e343[1][2] - _e343[0][2])), array<f64, 3>((_e344[1][0] - _e344[0][0]), (_e344[1][1] - _e344[0][1]), (_e344[1][2] - _e344[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e343[2][0] - _e343[3][0]), (_e343[2][1] - _e343[3][1]), (_e343[2][2] - _e343[3][2])), array<f64, 3>((_e344[2][0] - _e344[3][0]), (_e344[2][1] - _e344[3][1]), (_e344[2][2] - _e344[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_854_ = type_43(array<array<f64, 3>, 2>(array<f64, 3>((_e343[0][0] - _e343[1][0]), (_e343[0][1] - _e343[1][1]), (_e343[0][2] - _e343[1][2])), array<f64, 3>((_e344[0][0] - _e344[1][0]), (_e344[0][1] - _e344[1][1]), (_e344[0][2] - _e344[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e343[2][0] - _e343[1][0]), (_e343[2][1] - _e343[1][1]), (_e343[2][2] - _e343[1][2])), array<f64, 3>((_e344[2][0] - _e344[1][0]), (_e344[2][1] - _e344[1][1]), (_e344[2][2] - _e344[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e343[3][0] - _e343[1][0]), (_e343[3][1] - _e343[1][1]), (_e343[3][2] - _e343[1][2])), array<f64, 3>((_e344[3][0] - _e344[1][0]), (_e344[3][1] - _e344[1][1]), (_e344[3][2] - _e344[1][2]))), (0.0lf + 0.0lf));
                }
                let _e501 = phi_854_;
                let _e506 = function_10(_e501.member[0], _e501.member[1], _e338);
                let _e511 = function_10(_e501.member_1[0], _e501.member_1[1], _e338);
                let _e516 = function_10(_e501.member_2[0], _e501.member_2[1], _e338);
                if (_e506[0] < 0.0lf) {
                    phi_870_ = -(_e506[0]);
                } else {
                    phi_870_ = _e506[0];
                }
                let _e521 = phi_870_;
                if (_e506[1] < 0.0lf) {
                    phi_877_ = -(_e506[1]);
                } else {
                    phi_877_ = _e506[1];
                }
                let _e526 = phi_877_;
                if (_e521 > _e526) {
                    phi_882_ = _e521;
                } else {
                    phi_882_ = _e526;
                }
                let _e529 = phi_882_;
                if (_e506[2] < 0.0lf) {
                    phi_889_ = -(_e506[2]);
                } else {
                    phi_889_ = _e506[2];
                }
                let _e534 = phi_889_;
                if (_e529 > _e534) {
                    phi_894_ = _e529;
                } else {
                    phi_894_ = _e534;
                }
                let _e537 = phi_894_;
                if (_e511[0] < 0.0lf) {
                    phi_901_ = -(_e511[0]);
                } else {
                    phi_901_ = _e511[0];
                }
                let _e542 = phi_901_;
                if (_e511[1] < 0.0lf) {
                    phi_908_ = -(_e511[1]);
                } else {
                    phi_908_ = _e511[1];
                }
                let _e547 = phi_908_;
                if (_e542 > _e547) {
                    phi_913_ = _e542;
                } else {
                    phi_913_ = _e547;
                }
                let _e550 = phi_913_;
                if (_e511[2] < 0.0lf) {
                    phi_920_ = -(_e511[2]);
                } else {
                    phi_920_ = _e511[2];
                }
                let _e555 = phi_920_;
                if (_e550 > _e555) {
                    phi_925_ = _e550;
                } else {
                    phi_925_ = _e555;
                }
                let _e558 = phi_925_;
                if (_e537 > _e558) {
                    phi_930_ = _e537;
                } else {
                    phi_930_ = _e558;
                }
                let _e561 = phi_930_;
                if (_e516[0] < 0.0lf) {
                    phi_937_ = -(_e516[0]);
                } else {
                    phi_937_ = _e516[0];
                }
                let _e566 = phi_937_;
                if (_e516[1] < 0.0lf) {
                    phi_944_ = -(_e516[1]);
                } else {
                    phi_944_ = _e516[1];
                }
                let _e571 = phi_944_;
                if (_e566 > _e571) {
                    phi_949_ = _e566;
                } else {
                    phi_949_ = _e571;
                }
                let _e574 = phi_949_;
                if (_e516[2] < 0.0lf) {
                    phi_956_ = -(_e516[2]);
                } else {
                    phi_956_ = _e516[2];
                }
                let _e579 = phi_956_;
                if (_e574 > _e579) {
                    phi_961_ = _e574;
                } else {
                    phi_961_ = _e579;
                }
                let _e582 = phi_961_;
                if (_e561 > _e582) {
                    phi_966_ = _e561;
                } else {
                    phi_966_ = _e582;
                }
                let _e585 = phi_966_;
                let _e586 = function_9(_e585);
                let _e594 = (_e511[0] * _e586);
                let _e596 = (_e511[1] * _e586);
                let _e598 = (_e511[2] * _e586);
                let _e600 = (_e516[0] * _e586);
                let _e602 = (_e516[1] * _e586);
                let _e604 = (_e516[2] * _e586);
                if (_e501.member[0][0] < 0.0lf) {
                    phi_996_ = -(_e501.member[0][0]);
                } else {
                    phi_996_ = _e501.member[0][0];
                }
                let _e611 = phi_996_;
                if (_e501.member[0][1] < 0.0lf) {
                    phi_1003_ = -(_e501.member[0][1]);
                } else {
                    phi_1003_ = _e501.member[0][1];
                }
                let _e616 = phi_1003_;
                if (_e611 > _e616) {
                    phi_1008_ = _e611;
                } else {
                    phi_1008_ = _e616;
                }
                let _e619 = phi_1008_;
                if (_e501.member[0][2] < 0.0lf) {
                    phi_1015_ = -(_e501.member[0][2]);
                } else {
                    phi_1015_ = _e501.member[0][2];
                }
                let _e624 = phi_1015_;
                if (_e619 > _e624) {
                    phi_1020_ = _e619;
                } else {
                    phi_1020_ = _e624;
                }
                let _e627 = phi_1020_;
                if (_e501.member[1][0] < 0.0lf) {
                    phi_1028_ = -(_e501.member[1][0]);
                } else {
                    phi_1028_ = _e501.member[1][0];
                }
                let _e634 = phi_1028_;
                if (_e501.member[1][1] < 0.0lf) {
                    phi_1035_ = -(_e501.member[1][1]);
                } else {
                    phi_1035_ = _e501.member[1][1];
                }
                let _e639 = phi_1035_;
                if (_e634 > _e639) {
                    phi_1040_ = _e634;
                } else {
                    phi_1040_ = _e639;
                }
                let _e642 = phi_1040_;
                if (_e501.member[1][2] < 0.0lf) {
                    phi_1047_ = -(_e501.member[1][2]);
                } else {
                    phi_1047_ = _e501.member[1][2];
                }
                let _e647 = phi_1047_;
                if (_e642 > _e647) {
                    phi_1052_ = _e642;
                } else {
                    phi_1052_ = _e647;
                }
                let _e650 = phi_1052_;
                if (_e627 > _e650) {
                    phi_1057_ = _e627;
                } else {
                    phi_1057_ = _e650;
                }
                let _e653 = phi_1057_;
                if (_e501.member_1[0][0] < 0.0lf) {
                    phi_1067_ = -(_e501.member_1[0][0]);
                } else {
                    phi_1067_ = _e501.member_1[0][0];
                }
                let _e662 = phi_1067_;
                if (_e501.member_1[0][1] < 0.0lf) {
                    phi_1074_ = -(_e501.member_1[0][1]);
                } else {
                    phi_1074_ = _e501.member_1[0][1];
                }
                let _e667 = phi_1074_;
                if (_e662 > _e667) {
                    phi_1079_ = _e662;
                } else {
                    phi_1079_ = _e667;
                }
                let _e670 = phi_1079_;
                if (_e501.member_1[0][2] < 0.0lf) {
                    phi_1086_ = -(_e501.member_1[0][2]);
                } else {
                    phi_1086_ = _e501.member_1[0][2];
                }
                let _e675 = phi_1086_;
                if (_e670 > _e675) {
                    phi_1091_ = _e670;
                } else {
                    phi_1091_ = _e675;
                }
                let _e678 = phi_1091_;
                if (_e501.member_1[1][0] < 0.0lf) {
                    phi_1099_ = -(_e501.member_1[1][0]);
                } else {
                    phi_1099_ = _e501.member_1[1][0];
                }
                let _e685 = phi_1099_;
                if (_e501.member_1[1][1] < 0.0lf) {
                    phi_1106_ = -(_e501.member_1[1][1]);
                } else {
                    phi_1106_ = _e501.member_1[1][1];
                }
                let _e690 = phi_1106_;
                if (_e685 > _e690) {
                    phi_1111_ = _e685;
                } else {
                    phi_1111_ = _e690;
                }
                let _e693 = phi_1111_;
                if (_e501.member_1[1][2] < 0.0lf) {
                    phi_1118_ = -(_e501.member_1[1][2]);
                } else {
                    phi_1118_ = _e501.member_1[1][2];
                }
                let _e698 = phi_1118_;
                if (_e693 > _e698) {
                    phi_1123_ = _e693;
                } else {
                    phi_1123_ = _e698;
                }
                let _e701 = phi_1123_;
                if (_e678 > _e701) {
                    phi_1128_ = _e678;
                } else {
                    phi_1128_ = _e701;
                }
                let _e704 = phi_1128_;
                let _e706 = (_e704 + _e501.member_3);
                if (_e501.member_2[0][0] < 0.0lf) {
                    phi_1138_ = -(_e501.member_2[0][0]);
                } else {
                    phi_1138_ = _e501.member_2[0][0];
                }
                let _e713 = phi_1138_;
                if (_e501.member_2[0][1] < 0.0lf) {
                    phi_1145_ = -(_e501.member_2[0][1]);
                } else {
                    phi_1145_ = _e501.member_2[0][1];
                }
                let _e718 = phi_1145_;
                if (_e713 > _e718) {
                    phi_1150_ = _e713;
                } else {
                    phi_1150_ = _e718;
                }
                let _e721 = phi_1150_;
                if (_e501.member_2[0][2] < 0.0lf) {
                    phi_1157_ = -(_e501.member_2[0][2]);
                } else {
                    phi_1157_ = _e501.member_2[0][2];
                }
                let _e726 = phi_1157_;
                if (_e721 > _e726) {
                    phi_1162_ = _e721;
                } else {
                    phi_1162_ = _e726;
                }
                let _e729 = phi_1162_;
                if (_e501.member_2[1][0] < 0.0lf) {
                    phi_1170_ = -(_e501.member_2[1][0]);
                } else {
                    phi_1170_ = _e501.member_2[1][0];
                }
                let _e736 = phi_1170_;
                if (_e501.member_2[1][1] < 0.0lf) {
                    phi_1177_ = -(_e501.member_2[1][1]);
                } else {
                    phi_1177_ = _e501.member_2[1][1];
                }
                let _e741 = phi_1177_;
                if (_e736 > _e741) {
                    phi_1182_ = _e736;
                } else {
                    phi_1182_ = _e741;
                }
                let _e744 = phi_1182_;
                if (_e501.member_2[1][2] < 0.0lf) {
                    phi_1189_ = -(_e501.member_2[1][2]);
                } else {
                    phi_1189_ = _e501.member_2[1][2];
                }
                let _e749 = phi_1189_;
                if (_e744 > _e749) {
                    phi_1194_ = _e744;
                } else {
                    phi_1194_ = _e749;
                }
                let _e752 = phi_1194_;
                if (_e729 > _e752) {
                    phi_1199_ = _e729;
                } else {
                    phi_1199_ = _e752;
                }
                let _e755 = phi_1199_;
                let _e757 = (_e755 + _e501.member_3);
                let _e759 = (1.1102230246251565e-16lf * f64(16f));
                let _e765 = ((_e501.member_3 + (2.2250738585072014e-308lf * f64(8f))) * f64(4f));
                let _e773 = ((_e596 * _e604) - (_e598 * _e602));
                let _e776 = ((_e598 * _e600) - (_e594 * _e604));
                let _e779 = ((_e594 * _e602) - (_e596 * _e600));
                if (_e600 < 0.0lf) {
                    phi_1235_ = -(_e600);
                } else {
                    phi_1235_ = _e600;
                }
                let _e788 = phi_1235_;
                if (_e602 < 0.0lf) {
                    phi_1241_ = -(_e602);
                } else {
                    phi_1241_ = _e602;
                }
                let _e792 = phi_1241_;
                if (_e788 > _e792) {
                    phi_1246_ = _e788;
                } else {
                    phi_1246_ = _e792;
                }
                let _e795 = phi_1246_;
                if (_e604 < 0.0lf) {
                    phi_1252_ = -(_e604);
                } else {
                    phi_1252_ = _e604;
                }
                let _e799 = phi_1252_;
                if (_e795 > _e799) {
                    phi_1257_ = _e795;
                } else {
                    phi_1257_ = _e799;
                }
                let _e802 = phi_1257_;
                if (_e594 < 0.0lf) {
                    phi_1265_ = -(_e594);
                } else {
                    phi_1265_ = _e594;
                }
                let _e808 = phi_1265_;
                if (_e596 < 0.0lf) {
                    phi_1271_ = -(_e596);
                } else {
                    phi_1271_ = _e596;
                }
                let _e812 = phi_1271_;
                if (_e808 > _e812) {
                    phi_1276_ = _e808;
                } else {
                    phi_1276_ = _e812;
                }
                let _e815 = phi_1276_;
                if (_e598 < 0.0lf) {
                    phi_1282_ = -(_e598);
                } else {
                    phi_1282_ = _e598;
                }
                let _e819 = phi_1282_;
                if (_e815 > _e819) {
                    phi_1287_ = _e815;
                } else {
                    phi_1287_ = _e819;
                }
                let _e822 = phi_1287_;
                let _e824 = (((((_e706 * _e759) + _e765) * _e586) * _e802) + ((((_e757 * _e759) + _e765) * _e586) * _e822));
                let _e829 = (((_e773 * _e773) + (_e776 * _e776)) + (_e779 * _e779));
                if (_e829 <= 2.2250738585072014e-308lf) {
                    if (_e829 > 0.0lf) {
                        phi_1308_ = (1.464336215552873e-154lf * 2.0lf);
                    } else {
                        phi_1308_ = 0.0lf;
                    }
                    let _e881 = phi_1308_;
                    phi_1372_ = _e881;
                } else {
                    phi_1315_ = type_16(0i, 5i);
                    phi_1318_ = bitcast<f64>(((bitcast<u64>(_e829) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e836 = phi_1315_;
                        let _e838 = phi_1318_;
                        local_3 = _e838;
                        if (_e836.member < _e836.member_1) {
                            let _e845 = (_e836.member + 1i);
                            if ((false == (_e845 > _e836.member)) != false) {
                                phi_1339_ = true;
                            } else {
                                phi_1339_ = false;
                            }
                            let _e850 = phi_1339_;
                            if _e850 {
                                phi_1345_ = type_17(0u, type_17().member_1);
                            } else {
                                phi_1345_ = type_17(1u, _e845);
                            }
                            let _e855 = phi_1345_;
                            phi_1316_ = type_16(_e855.member_1, _e836.member_1);
                            phi_1359_ = type_17(1u, _e836.member);
                        } else {
                            phi_1316_ = _e836;
                            phi_1359_ = type_17(0u, type_17().member_1);
                        }
                        let _e861 = phi_1316_;
                        let _e863 = phi_1359_;
                        let _e866 = (bitcast<i32>(_e863.member) != 0i);
                        if _e866 {
                            phi_1319_ = (0.5lf * (_e838 + (_e829 / _e838)));
                        } else {
                            phi_1319_ = f64();
                        }
                        let _e871 = phi_1319_;
                        continue;
                        continuing {
                            phi_1315_ = _e861;
                            phi_1318_ = _e871;
                            break if !(_e866);
                        }
                    }
                    let _e876 = local_3;
                    phi_1372_ = (_e876 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e883 = phi_1372_;
                if (_e883 > f64(0f)) {
                    phi_1382_ = ((_e883 + (_e829 / _e883)) * f64(0.5f));
                } else {
                    phi_1382_ = _e883;
                }
                let _e891 = phi_1382_;
                if (_e891 > _e824) {
                    phi_1388_ = _e891;
                } else {
                    phi_1388_ = f64(0f);
                }
                let _e895 = phi_1388_;
                local = type_35(array<f64, 3>((_e506[0] * _e586), (_e506[1] * _e586), (_e506[2] * _e586)), array<f64, 3>(_e594, _e596, _e598), array<f64, 3>(_e600, _e602, _e604), array<f64, 3>(_e773, _e776, _e779), _e895, _e824, ((((((_e653 + _e501.member_3) + _e706) + _e757) * _e759) + _e765) * _e586));
                let _e901 = function_8((&local), _e176.member);
                if (_e901.member_3 <= 2.2250738585072014e-308lf) {
                    if (_e901.member_3 > 0.0lf) {
                        phi_1431_ = (1.464336215552873e-154lf * 2.0lf);
                    } else {
                        phi_1431_ = 0.0lf;
                    }
                    let _e956 = phi_1431_;
                    phi_1495_ = _e956;
                } else {
                    phi_1438_ = type_16(0i, 5i);
                    phi_1441_ = bitcast<f64>(((bitcast<u64>(_e901.member_3) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e911 = phi_1438_;
                        let _e913 = phi_1441_;
                        local_4 = _e913;
                        if (_e911.member < _e911.member_1) {
                            let _e920 = (_e911.member + 1i);
                            if ((false == (_e920 > _e911.member)) != false) {
                                phi_1462_ = true;
                            } else {
                                phi_1462_ = false;
                            }
                            let _e925 = phi_1462_;
                            if _e925 {
                                phi_1468_ = type_17(0u, type_17().member_1);
                            } else {
                                phi_1468_ = type_17(1u, _e920);
                            }
                            let _e930 = phi_1468_;
                            phi_1439_ = type_16(_e930.member_1, _e911.member_1);
                            phi_1482_ = type_17(1u, _e911.member);
                        } else {
                            phi_1439_ = _e911;
                            phi_1482_ = type_17(0u, type_17().member_1);
                        }
                        let _e936 = phi_1439_;
                        let _e938 = phi_1482_;
                        let _e941 = (bitcast<i32>(_e938.member) != 0i);
                        if _e941 {
                            phi_1442_ = (0.5lf * (_e913 + (_e901.member_3 / _e913)));
                        } else {
                            phi_1442_ = f64();
                        }
                        let _e946 = phi_1442_;
                        continue;
                        continuing {
                            phi_1438_ = _e936;
                            phi_1441_ = _e946;
                            break if !(_e941);
                        }
                    }
                    let _e951 = local_4;
                    phi_1495_ = (_e951 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e958 = phi_1495_;
                if (_e958 > f64(0f)) {
                    phi_1505_ = ((_e958 + (_e901.member_3 / _e958)) * f64(0.5f));
                } else {
                    phi_1505_ = _e958;
                }
                let _e966 = phi_1505_;
                if (_e176.member == 0u) {
                    phi_1511_ = _e337;
                } else {
                    phi_1511_ = -(_e337);
                }
                let _e970 = phi_1511_;
                let _e972 = function_2(_e501.member);
                let _e974 = function_2(_e501.member_1);
                let _e988 = function_2(_e501.member_2);
                let _e998 = (((_e972[0] - (_e974[0] * _e901.member)) - (_e988[0] * _e901.member_1)) * _e970);
                let _e999 = (((_e972[1] - (_e974[1] * _e901.member)) - (_e988[1] * _e901.member_1)) * _e970);
                let _e1000 = (((_e972[2] - (_e974[2] * _e901.member)) - (_e988[2] * _e901.member_1)) * _e970);
                let _e1002 = f64(0f);
                let _e1003 = f64(1f);
                if (_e901.member > _e1002) {
                    phi_1552_ = (_e901.member < _e1003);
                } else {
                    phi_1552_ = false;
                }
                let _e1009 = phi_1552_;
                if (_e901.member_1 > _e1002) {
                    phi_1558_ = (_e901.member_1 < _e1003);
                } else {
                    phi_1558_ = false;
                }
                let _e1013 = phi_1558_;
                let _e1014 = (_e970 > _e1002);
                if _e1009 {
                    if _e1013 {
                        if _e1014 {
                            phi_1574_ = ((_e901.member + _e901.member_1) < (_e1003 - (1.1102230246251565e-16lf * f64(4f))));
                        } else {
                            phi_1574_ = true;
                        }
                        let _e1021 = phi_1574_;
                        phi_1575_ = _e1021;
                        phi_1576_ = false;
                    } else {
                        phi_1575_ = bool();
                        phi_1576_ = true;
                    }
                    let _e1023 = phi_1575_;
                    let _e1025 = phi_1576_;
                    phi_1577_ = _e1023;
                    phi_1578_ = _e1025;
                } else {
                    phi_1577_ = bool();
                    phi_1578_ = true;
                }
                let _e1027 = phi_1577_;
                let _e1029 = phi_1578_;
                if _e1029 {
                    phi_1582_ = false;
                } else {
                    phi_1582_ = _e1027;
                }
                let _e1031 = phi_1582_;
                let _e1033 = local.member_4;
                let _e1034 = (_e1033 > _e1002);
                let _e1036 = local.member_3;
                let _e1040 = (_e1036[0] * _e970);
                let _e1041 = (_e1036[1] * _e970);
                let _e1042 = (_e1036[2] * _e970);
                let _e1045 = local.member_6;
                if (_e966 > _e1045) {
                    let _e2181 = (_e901.member_2[0] * _e970);
                    let _e2183 = (_e901.member_2[1] * _e970);
                    let _e2185 = (_e901.member_2[2] * _e970);
                    if _e1034 {
                        if _e1031 {
                            let _e2187 = local.member_5;
                            let _e2190 = local.member_6;
                            let _e2192 = local.member_4;
                            if ((_e2187 * _e966) <= (_e2190 * _e2192)) {
                                if ((((_e2181 * _e1040) + (_e2183 * _e1041)) + (_e2185 * _e1042)) >= _e1002) {
                                    phi_1644_ = array<f64, 3>(_e1040, _e1041, _e1042);
                                } else {
                                    let _e2201 = -(_e1003);
                                    phi_1644_ = array<f64, 3>((_e1040 * _e2201), (_e1041 * _e2201), (_e1042 * _e2201));
                                }
                                let _e2207 = phi_1644_;
                                if (_e2207[0] < 0.0lf) {
                                    phi_1651_ = -(_e2207[0]);
                                } else {
                                    phi_1651_ = _e2207[0];
                                }
                                let _e2212 = phi_1651_;
                                if (_e2207[1] < 0.0lf) {
                                    phi_1658_ = -(_e2207[1]);
                                } else {
                                    phi_1658_ = _e2207[1];
                                }
                                let _e2217 = phi_1658_;
                                if (_e2212 > _e2217) {
                                    phi_1663_ = _e2212;
                                } else {
                                    phi_1663_ = _e2217;
                                }
                                let _e2220 = phi_1663_;
                                if (_e2207[2] < 0.0lf) {
                                    phi_1670_ = -(_e2207[2]);
                                } else {
                                    phi_1670_ = _e2207[2];
                                }
                                let _e2225 = phi_1670_;
                                if (_e2220 > _e2225) {
                                    phi_1675_ = _e2220;
                                } else {
                                    phi_1675_ = _e2225;
                                }
                                let _e2228 = phi_1675_;
                                let _e2229 = function_9(_e2228);
                                let _e2231 = (_e2207[0] * _e2229);
                                let _e2233 = (_e2207[1] * _e2229);
                                let _e2235 = (_e2207[2] * _e2229);
                                let _e2241 = (((_e2231 * _e2231) + (_e2233 * _e2233)) + (_e2235 * _e2235));
                                if (_e2241 <= 2.2250738585072014e-308lf) {
                                    if (_e2241 > 0.0lf) {
                                        phi_1702_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_1702_ = 0.0lf;
                                    }
                                    let _e2293 = phi_1702_;
                                    phi_1766_ = _e2293;
                                } else {
                                    phi_1709_ = type_16(0i, 5i);
                                    phi_1712_ = bitcast<f64>(((bitcast<u64>(_e2241) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2248 = phi_1709_;
                                        let _e2250 = phi_1712_;
                                        local_11 = _e2250;
                                        if (_e2248.member < _e2248.member_1) {
                                            let _e2257 = (_e2248.member + 1i);
                                            if ((false == (_e2257 > _e2248.member)) != false) {
                                                phi_1733_ = true;
                                            } else {
                                                phi_1733_ = false;
                                            }
                                            let _e2262 = phi_1733_;
                                            if _e2262 {
                                                phi_1739_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_1739_ = type_17(1u, _e2257);
                                            }
                                            let _e2267 = phi_1739_;
                                            phi_1710_ = type_16(_e2267.member_1, _e2248.member_1);
                                            phi_1753_ = type_17(1u, _e2248.member);
                                        } else {
                                            phi_1710_ = _e2248;
                                            phi_1753_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2273 = phi_1710_;
                                        let _e2275 = phi_1753_;
                                        let _e2278 = (bitcast<i32>(_e2275.member) != 0i);
                                        if _e2278 {
                                            phi_1713_ = (0.5lf * (_e2250 + (_e2241 / _e2250)));
                                        } else {
                                            phi_1713_ = f64();
                                        }
                                        let _e2283 = phi_1713_;
                                        continue;
                                        continuing {
                                            phi_1709_ = _e2273;
                                            phi_1712_ = _e2283;
                                            break if !(_e2278);
                                        }
                                    }
                                    let _e2288 = local_11;
                                    phi_1766_ = (_e2288 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e2295 = phi_1766_;
                                let _e2296 = (f64(1f) / _e2295);
                                let _e2297 = (_e2231 * _e2296);
                                let _e2298 = (_e2233 * _e2296);
                                let _e2299 = (_e2235 * _e2296);
                                let _e2308 = ((f64(3f) - (((_e2297 * _e2297) + (_e2298 * _e2298)) + (_e2299 * _e2299))) * f64(0.5f));
                                phi_1784_ = array<f64, 3>((_e2297 * _e2308), (_e2298 * _e2308), (_e2299 * _e2308));
                                phi_1785_ = false;
                            } else {
                                phi_1784_ = array<f64, 3>();
                                phi_1785_ = true;
                            }
                            let _e2314 = phi_1784_;
                            let _e2316 = phi_1785_;
                            phi_1786_ = _e2314;
                            phi_1787_ = _e2316;
                        } else {
                            phi_1786_ = array<f64, 3>();
                            phi_1787_ = true;
                        }
                        let _e2318 = phi_1786_;
                        let _e2320 = phi_1787_;
                        phi_1788_ = _e2318;
                        phi_1789_ = _e2320;
                    } else {
                        phi_1788_ = array<f64, 3>();
                        phi_1789_ = true;
                    }
                    let _e2322 = phi_1788_;
                    let _e2324 = phi_1789_;
                    if _e2324 {
                        if (_e2181 < 0.0lf) {
                            phi_1798_ = -(_e2181);
                        } else {
                            phi_1798_ = _e2181;
                        }
                        let _e2328 = phi_1798_;
                        if (_e2183 < 0.0lf) {
                            phi_1804_ = -(_e2183);
                        } else {
                            phi_1804_ = _e2183;
                        }
                        let _e2332 = phi_1804_;
                        if (_e2328 > _e2332) {
                            phi_1809_ = _e2328;
                        } else {
                            phi_1809_ = _e2332;
                        }
                        let _e2335 = phi_1809_;
                        if (_e2185 < 0.0lf) {
                            phi_1815_ = -(_e2185);
                        } else {
                            phi_1815_ = _e2185;
                        }
                        let _e2339 = phi_1815_;
                        if (_e2335 > _e2339) {
                            phi_1820_ = _e2335;
                        } else {
                            phi_1820_ = _e2339;
                        }
                        let _e2342 = phi_1820_;
                        let _e2343 = function_9(_e2342);
                        let _e2344 = (_e2181 * _e2343);
                        let _e2345 = (_e2183 * _e2343);
                        let _e2346 = (_e2185 * _e2343);
                        let _e2352 = (((_e2344 * _e2344) + (_e2345 * _e2345)) + (_e2346 * _e2346));
                        if (_e2352 <= 2.2250738585072014e-308lf) {
                            if (_e2352 > 0.0lf) {
                                phi_1844_ = (1.464336215552873e-154lf * 2.0lf);
                            } else {
                                phi_1844_ = 0.0lf;
                            }
                            let _e2404 = phi_1844_;
                            phi_1908_ = _e2404;
                        } else {
                            phi_1851_ = type_16(0i, 5i);
                            phi_1854_ = bitcast<f64>(((bitcast<u64>(_e2352) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e2359 = phi_1851_;
                                let _e2361 = phi_1854_;
                                local_12 = _e2361;
                                if (_e2359.member < _e2359.member_1) {
                                    let _e2368 = (_e2359.member + 1i);
                                    if ((false == (_e2368 > _e2359.member)) != false) {
                                        phi_1875_ = true;
                                    } else {
                                        phi_1875_ = false;
                                    }
                                    let _e2373 = phi_1875_;
                                    if _e2373 {
                                        phi_1881_ = type_17(0u, type_17().member_1);
                                    } else {
                                        phi_1881_ = type_17(1u, _e2368);
                                    }
                                    let _e2378 = phi_1881_;
                                    phi_1852_ = type_16(_e2378.member_1, _e2359.member_1);
                                    phi_1895_ = type_17(1u, _e2359.member);
                                } else {
                                    phi_1852_ = _e2359;
                                    phi_1895_ = type_17(0u, type_17().member_1);
                                }
                                let _e2384 = phi_1852_;
                                let _e2386 = phi_1895_;
                                let _e2389 = (bitcast<i32>(_e2386.member) != 0i);
                                if _e2389 {
                                    phi_1855_ = (0.5lf * (_e2361 + (_e2352 / _e2361)));
                                } else {
                                    phi_1855_ = f64();
                                }
                                let _e2394 = phi_1855_;
                                continue;
                                continuing {
                                    phi_1851_ = _e2384;
                                    phi_1854_ = _e2394;
                                    break if !(_e2389);
                                }
                            }
                            let _e2399 = local_12;
                            phi_1908_ = (_e2399 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e2406 = phi_1908_;
                        let _e2407 = (f64(1f) / _e2406);
                        let _e2408 = (_e2344 * _e2407);
                        let _e2409 = (_e2345 * _e2407);
                        let _e2410 = (_e2346 * _e2407);
                        let _e2419 = ((f64(3f) - (((_e2408 * _e2408) + (_e2409 * _e2409)) + (_e2410 * _e2410))) * f64(0.5f));
                        phi_1926_ = array<f64, 3>((_e2408 * _e2419), (_e2409 * _e2419), (_e2410 * _e2419));
                    } else {
                        phi_1926_ = _e2322;
                    }
                    let _e2425 = phi_1926_;
                    phi_3468_ = _e2425;
                    phi_3469_ = array<f64, 3>();
                    phi_3470_ = true;
                } else {
                    if (_e501.member[0][0] < 0.0lf) {
                        phi_1934_ = -(_e501.member[0][0]);
                    } else {
                        phi_1934_ = _e501.member[0][0];
                    }
                    let _e1053 = phi_1934_;
                    if (_e501.member[0][1] < 0.0lf) {
                        phi_1941_ = -(_e501.member[0][1]);
                    } else {
                        phi_1941_ = _e501.member[0][1];
                    }
                    let _e1058 = phi_1941_;
                    if (_e1053 > _e1058) {
                        phi_1946_ = _e1053;
                    } else {
                        phi_1946_ = _e1058;
                    }
                    let _e1061 = phi_1946_;
                    if (_e501.member[0][2] < 0.0lf) {
                        phi_1953_ = -(_e501.member[0][2]);
                    } else {
                        phi_1953_ = _e501.member[0][2];
                    }
                    let _e1066 = phi_1953_;
                    if (_e1061 > _e1066) {
                        phi_1958_ = _e1061;
                    } else {
                        phi_1958_ = _e1066;
                    }
                    let _e1069 = phi_1958_;
                    if (_e501.member[1][0] < 0.0lf) {
                        phi_1966_ = -(_e501.member[1][0]);
                    } else {
                        phi_1966_ = _e501.member[1][0];
                    }
                    let _e1076 = phi_1966_;
                    if (_e501.member[1][1] < 0.0lf) {
                        phi_1973_ = -(_e501.member[1][1]);
                    } else {
                        phi_1973_ = _e501.member[1][1];
                    }
                    let _e1081 = phi_1973_;
                    if (_e1076 > _e1081) {
                        phi_1978_ = _e1076;
                    } else {
                        phi_1978_ = _e1081;
                    }
                    let _e1084 = phi_1978_;
                    if (_e501.member[1][2] < 0.0lf) {
                        phi_1985_ = -(_e501.member[1][2]);
                    } else {
                        phi_1985_ = _e501.member[1][2];
                    }
                    let _e1089 = phi_1985_;
                    if (_e1084 > _e1089) {
                        phi_1990_ = _e1084;
                    } else {
                        phi_1990_ = _e1089;
                    }
                    let _e1092 = phi_1990_;
                    if (_e1069 > _e1092) {
                        phi_1995_ = _e1069;
                    } else {
                        phi_1995_ = _e1092;
                    }
                    let _e1095 = phi_1995_;
                    if (_e501.member_1[0][0] < 0.0lf) {
                        phi_2005_ = -(_e501.member_1[0][0]);
                    } else {
                        phi_2005_ = _e501.member_1[0][0];
                    }
                    let _e1104 = phi_2005_;
                    if (_e501.member_1[0][1] < 0.0lf) {
                        phi_2012_ = -(_e501.member_1[0][1]);
                    } else {
                        phi_2012_ = _e501.member_1[0][1];
                    }
                    let _e1109 = phi_2012_;
                    if (_e1104 > _e1109) {
                        phi_2017_ = _e1104;
                    } else {
                        phi_2017_ = _e1109;
                    }
                    let _e1112 = phi_2017_;
                    if (_e501.member_1[0][2] < 0.0lf) {
                        phi_2024_ = -(_e501.member_1[0][2]);
                    } else {
                        phi_2024_ = _e501.member_1[0][2];
                    }
                    let _e1117 = phi_2024_;
                    if (_e1112 > _e1117) {
                        phi_2029_ = _e1112;
                    } else {
                        phi_2029_ = _e1117;
                    }
                    let _e1120 = phi_2029_;
                    if (_e501.member_1[1][0] < 0.0lf) {
                        phi_2037_ = -(_e501.member_1[1][0]);
                    } else {
                        phi_2037_ = _e501.member_1[1][0];
                    }
                    let _e1127 = phi_2037_;
                    if (_e501.member_1[1][1] < 0.0lf) {
                        phi_2044_ = -(_e501.member_1[1][1]);
                    } else {
                        phi_2044_ = _e501.member_1[1][1];
                    }
                    let _e1132 = phi_2044_;
                    if (_e1127 > _e1132) {
                        phi_2049_ = _e1127;
                    } else {
                        phi_2049_ = _e1132;
                    }
                    let _e1135 = phi_2049_;
                    if (_e501.member_1[1][2] < 0.0lf) {
                        phi_2056_ = -(_e501.member_1[1][2]);
                    } else {
                        phi_2056_ = _e501.member_1[1][2];
                    }
                    let _e1140 = phi_2056_;
                    if (_e1135 > _e1140) {
                        phi_2061_ = _e1135;
                    } else {
                        phi_2061_ = _e1140;
                    }
                    let _e1143 = phi_2061_;
                    if (_e1120 > _e1143) {
                        phi_2066_ = _e1120;
                    } else {
                        phi_2066_ = _e1143;
                    }
                    let _e1146 = phi_2066_;
                    if (_e501.member_2[0][0] < 0.0lf) {
                        phi_2076_ = -(_e501.member_2[0][0]);
                    } else {
                        phi_2076_ = _e501.member_2[0][0];
                    }
                    let _e1155 = phi_2076_;
                    if (_e501.member_2[0][1] < 0.0lf) {
                        phi_2083_ = -(_e501.member_2[0][1]);
                    } else {
                        phi_2083_ = _e501.member_2[0][1];
                    }
                    let _e1160 = phi_2083_;
                    if (_e1155 > _e1160) {
                        phi_2088_ = _e1155;
                    } else {
                        phi_2088_ = _e1160;
                    }
                    let _e1163 = phi_2088_;
                    if (_e501.member_2[0][2] < 0.0lf) {
                        phi_2095_ = -(_e501.member_2[0][2]);
                    } else {
                        phi_2095_ = _e501.member_2[0][2];
                    }
                    let _e1168 = phi_2095_;
                    if (_e1163 > _e1168) {
                        phi_2100_ = _e1163;
                    } else {
                        phi_2100_ = _e1168;
                    }
                    let _e1171 = phi_2100_;
                    if (_e501.member_2[1][0] < 0.0lf) {
                        phi_2108_ = -(_e501.member_2[1][0]);
                    } else {
                        phi_2108_ = _e501.member_2[1][0];
                    }
                    let _e1178 = phi_2108_;
                    if (_e501.member_2[1][1] < 0.0lf) {
                        phi_2115_ = -(_e501.member_2[1][1]);
                    } else {
                        phi_2115_ = _e501.member_2[1][1];
                    }
                    let _e1183 = phi_2115_;
                    if (_e1178 > _e1183) {
                        phi_2120_ = _e1178;
                    } else {
                        phi_2120_ = _e1183;
                    }
                    let _e1186 = phi_2120_;
                    if (_e501.member_2[1][2] < 0.0lf) {
                        phi_2127_ = -(_e501.member_2[1][2]);
                    } else {
                        phi_2127_ = _e501.member_2[1][2];
                    }
                    let _e1191 = phi_2127_;
                    if (_e1186 > _e1191) {
                        phi_2132_ = _e1186;
                    } else {
                        phi_2132_ = _e1191;
                    }
                    let _e1194 = phi_2132_;
                    if (_e1171 > _e1194) {
                        phi_2137_ = _e1171;
                    } else {
                        phi_2137_ = _e1194;
                    }
                    let _e1197 = phi_2137_;
                    let _e1211 = (((((_e1095 + _e501.member_3) + (_e1146 + _e501.member_3)) + (_e1197 + _e501.member_3)) * (1.1102230246251565e-16lf * f64(32f))) + ((_e501.member_3 + (2.2250738585072014e-308lf * f64(8f))) * f64(8f)));
                    if _e1034 {
                        if (_e1040 < 0.0lf) {
                            phi_2160_ = -(_e1040);
                        } else {
                            phi_2160_ = _e1040;
                        }
                        let _e1215 = phi_2160_;
                        if (_e1041 < 0.0lf) {
                            phi_2166_ = -(_e1041);
                        } else {
                            phi_2166_ = _e1041;
                        }
                        let _e1219 = phi_2166_;
                        if (_e1215 > _e1219) {
                            phi_2171_ = _e1215;
                        } else {
                            phi_2171_ = _e1219;
                        }
                        let _e1222 = phi_2171_;
                        if (_e1042 < 0.0lf) {
                            phi_2177_ = -(_e1042);
                        } else {
                            phi_2177_ = _e1042;
                        }
                        let _e1226 = phi_2177_;
                        if (_e1222 > _e1226) {
                            phi_2182_ = _e1222;
                        } else {
                            phi_2182_ = _e1226;
                        }
                        let _e1229 = phi_2182_;
                        let _e1230 = function_9(_e1229);
                        let _e1231 = (_e1040 * _e1230);
                        let _e1232 = (_e1041 * _e1230);
                        let _e1233 = (_e1042 * _e1230);
                        let _e1239 = (((_e1231 * _e1231) + (_e1232 * _e1232)) + (_e1233 * _e1233));
                        if (_e1239 <= 2.2250738585072014e-308lf) {
                            if (_e1239 > 0.0lf) {
                                phi_2206_ = (1.464336215552873e-154lf * 2.0lf);
                            } else {
                                phi_2206_ = 0.0lf;
                            }
                            let _e1291 = phi_2206_;
                            phi_2270_ = _e1291;
                        } else {
                            phi_2213_ = type_16(0i, 5i);
                            phi_2216_ = bitcast<f64>(((bitcast<u64>(_e1239) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1246 = phi_2213_;
                                let _e1248 = phi_2216_;
                                local_5 = _e1248;
                                if (_e1246.member < _e1246.member_1) {
                                    let _e1255 = (_e1246.member + 1i);
                                    if ((false == (_e1255 > _e1246.member)) != false) {
                                        phi_2237_ = true;
                                    } else {
                                        phi_2237_ = false;
                                    }
                                    let _e1260 = phi_2237_;
                                    if _e1260 {
                                        phi_2243_ = type_17(0u, type_17().member_1);
                                    } else {
                                        phi_2243_ = type_17(1u, _e1255);
                                    }
                                    let _e1265 = phi_2243_;
                                    phi_2214_ = type_16(_e1265.member_1, _e1246.member_1);
                                    phi_2257_ = type_17(1u, _e1246.member);
                                } else {
                                    phi_2214_ = _e1246;
                                    phi_2257_ = type_17(0u, type_17().member_1);
                                }
                                let _e1271 = phi_2214_;
                                let _e1273 = phi_2257_;
                                let _e1276 = (bitcast<i32>(_e1273.member) != 0i);
                                if _e1276 {
                                    phi_2217_ = (0.5lf * (_e1248 + (_e1239 / _e1248)));
                                } else {
                                    phi_2217_ = f64();
                                }
                                let _e1281 = phi_2217_;
                                continue;
                                continuing {
                                    phi_2213_ = _e1271;
                                    phi_2216_ = _e1281;
                                    break if !(_e1276);
                                }
                            }
                            let _e1286 = local_5;
                            phi_2270_ = (_e1286 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1293 = phi_2270_;
                        let _e1294 = (f64(1f) / _e1293);
                        let _e1295 = (_e1231 * _e1294);
                        let _e1296 = (_e1232 * _e1294);
                        let _e1297 = (_e1233 * _e1294);
                        let _e1306 = ((f64(3f) - (((_e1295 * _e1295) + (_e1296 * _e1296)) + (_e1297 * _e1297))) * f64(0.5f));
                        let _e1307 = (_e1295 * _e1306);
                        let _e1308 = (_e1296 * _e1306);
                        let _e1309 = (_e1297 * _e1306);
                        let _e1315 = (((_e998 * _e1307) + (_e999 * _e1308)) + (_e1000 * _e1309));
                        if (_e998 < 0.0lf) {
                            phi_2298_ = -(_e998);
                        } else {
                            phi_2298_ = _e998;
                        }
                        let _e1319 = phi_2298_;
                        if (_e999 < 0.0lf) {
                            phi_2304_ = -(_e999);
                        } else {
                            phi_2304_ = _e999;
                        }
                        let _e1323 = phi_2304_;
                        if (_e1000 < 0.0lf) {
                            phi_2311_ = -(_e1000);
                        } else {
                            phi_2311_ = _e1000;
                        }
                        let _e1328 = phi_2311_;
                        let _e1331 = local.member_5;
                        let _e1333 = local.member_4;
                        if (_e1315 < 0.0lf) {
                            phi_2325_ = -(_e1315);
                        } else {
                            phi_2325_ = _e1315;
                        }
                        let _e1340 = phi_2325_;
                        if (_e1340 > (_e1211 + (((_e1319 + _e1323) + _e1328) * (_e1331 / _e1333)))) {
                            if (_e1315 < _e1002) {
                                phi_2339_ = array<f64, 3>(_e1307, _e1308, _e1309);
                            } else {
                                let _e1343 = -(_e1003);
                                phi_2339_ = array<f64, 3>((_e1307 * _e1343), (_e1308 * _e1343), (_e1309 * _e1343));
                            }
                            let _e1349 = phi_2339_;
                            phi_2340_ = _e1349;
                            phi_2341_ = false;
                        } else {
                            phi_2340_ = array<f64, 3>();
                            phi_2341_ = true;
                        }
                        let _e1351 = phi_2340_;
                        let _e1353 = phi_2341_;
                        phi_2342_ = _e1351;
                        phi_2343_ = _e1353;
                    } else {
                        phi_2342_ = array<f64, 3>();
                        phi_2343_ = true;
                    }
                    let _e1355 = phi_2342_;
                    let _e1357 = phi_2343_;
                    if _e1357 {
                        if _e1034 {
                            if _e1031 {
                                phi_2353_ = false;
                            } else {
                                phi_2353_ = true;
                            }
                            let _e1359 = phi_2353_;
                            phi_2354_ = _e1359;
                        } else {
                            phi_2354_ = true;
                        }
                        let _e1361 = phi_2354_;
                        if _e1361 {
                            if _e1014 {
                                if _e1009 {
                                    if _e1013 {
                                        let _e1363 = local.member_2;
                                        let _e1368 = local.member_1;
                                        phi_2389_ = array<f64, 3>((_e1363[0] - _e1368[0]), (_e1363[1] - _e1368[1]), (_e1363[2] - _e1368[2]));
                                        phi_2390_ = false;
                                    } else {
                                        phi_2389_ = array<f64, 3>();
                                        phi_2390_ = true;
                                    }
                                    let _e1377 = phi_2389_;
                                    let _e1379 = phi_2390_;
                                    phi_2391_ = _e1377;
                                    phi_2392_ = _e1379;
                                } else {
                                    phi_2391_ = array<f64, 3>();
                                    phi_2392_ = true;
                                }
                                let _e1381 = phi_2391_;
                                let _e1383 = phi_2392_;
                                phi_2393_ = _e1381;
                                phi_2394_ = _e1383;
                            } else {
                                phi_2393_ = array<f64, 3>();
                                phi_2394_ = true;
                            }
                            let _e1385 = phi_2393_;
                            let _e1387 = phi_2394_;
                            if _e1387 {
                                if _e1009 {
                                    if _e1013 {
                                        let _e1389 = local.member_2;
                                        if (_e1389[0] < 0.0lf) {
                                            phi_2416_ = -(_e1389[0]);
                                        } else {
                                            phi_2416_ = _e1389[0];
                                        }
                                        let _e1396 = phi_2416_;
                                        if (_e1389[1] < 0.0lf) {
                                            phi_2423_ = -(_e1389[1]);
                                        } else {
                                            phi_2423_ = _e1389[1];
                                        }
                                        let _e1400 = phi_2423_;
                                        if (_e1396 > _e1400) {
                                            phi_2428_ = _e1396;
                                        } else {
                                            phi_2428_ = _e1400;
                                        }
                                        let _e1403 = phi_2428_;
                                        if (_e1389[2] < 0.0lf) {
                                            phi_2435_ = -(_e1389[2]);
                                        } else {
                                            phi_2435_ = _e1389[2];
                                        }
                                        let _e1407 = phi_2435_;
                                        if (_e1403 > _e1407) {
                                            phi_2440_ = _e1403;
                                        } else {
                                            phi_2440_ = _e1407;
                                        }
                                        let _e1410 = phi_2440_;
                                        let _e1412 = local.member_1;
                                        if (_e1412[0] < 0.0lf) {
                                            phi_2453_ = -(_e1412[0]);
                                        } else {
                                            phi_2453_ = _e1412[0];
                                        }
                                        let _e1419 = phi_2453_;
                                        if (_e1412[1] < 0.0lf) {
                                            phi_2460_ = -(_e1412[1]);
                                        } else {
                                            phi_2460_ = _e1412[1];
                                        }
                                        let _e1423 = phi_2460_;
                                        if (_e1419 > _e1423) {
                                            phi_2465_ = _e1419;
                                        } else {
                                            phi_2465_ = _e1423;
                                        }
                                        let _e1426 = phi_2465_;
                                        if (_e1412[2] < 0.0lf) {
                                            phi_2472_ = -(_e1412[2]);
                                        } else {
                                            phi_2472_ = _e1412[2];
                                        }
                                        let _e1430 = phi_2472_;
                                        if (_e1426 > _e1430) {
                                            phi_2477_ = _e1426;
                                        } else {
                                            phi_2477_ = _e1430;
                                        }
                                        let _e1433 = phi_2477_;
                                        if (_e1410 > _e1433) {
                                            phi_2482_ = false;
                                        } else {
                                            phi_2482_ = true;
                                        }
                                        let _e1436 = phi_2482_;
                                        phi_2483_ = _e1436;
                                    } else {
                                        phi_2483_ = true;
                                    }
                                    let _e1438 = phi_2483_;
                                    if _e1438 {
                                        let _e1440 = local.member_1;
                                        phi_2493_ = array<f64, 3>(_e1440[0], _e1440[1], _e1440[2]);
                                        phi_2494_ = false;
                                    } else {
                                        phi_2493_ = array<f64, 3>();
                                        phi_2494_ = true;
                                    }
                                    let _e1446 = phi_2493_;
                                    let _e1448 = phi_2494_;
                                    phi_2495_ = _e1446;
                                    phi_2496_ = _e1448;
                                } else {
                                    phi_2495_ = array<f64, 3>();
                                    phi_2496_ = true;
                                }
                                let _e1450 = phi_2495_;
                                let _e1452 = phi_2496_;
                                if _e1452 {
                                    if _e1013 {
                                        let _e1455 = local.member_2;
                                        phi_2510_ = array<f64, 3>(_e1455[0], _e1455[1], _e1455[2]);
                                    } else {
                                        phi_2510_ = array<f64, 3>(_e1002, _e1002, _e1002);
                                    }
                                    let _e1461 = phi_2510_;
                                    phi_2511_ = _e1461;
                                } else {
                                    phi_2511_ = _e1450;
                                }
                                let _e1463 = phi_2511_;
                                phi_2512_ = _e1463;
                            } else {
                                phi_2512_ = _e1385;
                            }
                            let _e1465 = phi_2512_;
                            if (_e1465[0] < 0.0lf) {
                                phi_2519_ = -(_e1465[0]);
                            } else {
                                phi_2519_ = _e1465[0];
                            }
                            let _e1470 = phi_2519_;
                            if (_e1465[1] < 0.0lf) {
                                phi_2526_ = -(_e1465[1]);
                            } else {
                                phi_2526_ = _e1465[1];
                            }
                            let _e1475 = phi_2526_;
                            if (_e1470 > _e1475) {
                                phi_2531_ = _e1470;
                            } else {
                                phi_2531_ = _e1475;
                            }
                            let _e1478 = phi_2531_;
                            if (_e1465[2] < 0.0lf) {
                                phi_2538_ = -(_e1465[2]);
                            } else {
                                phi_2538_ = _e1465[2];
                            }
                            let _e1483 = phi_2538_;
                            if (_e1478 > _e1483) {
                                phi_2543_ = _e1478;
                            } else {
                                phi_2543_ = _e1483;
                            }
                            let _e1486 = phi_2543_;
                            if (_e1486 > f64(0f)) {
                                if (_e1465[0] < 0.0lf) {
                                    phi_2555_ = -(_e1465[0]);
                                } else {
                                    phi_2555_ = _e1465[0];
                                }
                                let _e1493 = phi_2555_;
                                if (_e1465[1] < 0.0lf) {
                                    phi_2562_ = -(_e1465[1]);
                                } else {
                                    phi_2562_ = _e1465[1];
                                }
                                let _e1498 = phi_2562_;
                                if (_e1493 > _e1498) {
                                    phi_2567_ = _e1493;
                                } else {
                                    phi_2567_ = _e1498;
                                }
                                let _e1501 = phi_2567_;
                                if (_e1465[2] < 0.0lf) {
                                    phi_2574_ = -(_e1465[2]);
                                } else {
                                    phi_2574_ = _e1465[2];
                                }
                                let _e1506 = phi_2574_;
                                if (_e1501 > _e1506) {
                                    phi_2579_ = _e1501;
                                } else {
                                    phi_2579_ = _e1506;
                                }
                                let _e1509 = phi_2579_;
                                let _e1510 = function_9(_e1509);
                                let _e1512 = (_e1465[0] * _e1510);
                                let _e1514 = (_e1465[1] * _e1510);
                                let _e1516 = (_e1465[2] * _e1510);
                                let _e1522 = (((_e1512 * _e1512) + (_e1514 * _e1514)) + (_e1516 * _e1516));
                                if (_e1522 <= 2.2250738585072014e-308lf) {
                                    if (_e1522 > 0.0lf) {
                                        phi_2606_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_2606_ = 0.0lf;
                                    }
                                    let _e1574 = phi_2606_;
                                    phi_2670_ = _e1574;
                                } else {
                                    phi_2613_ = type_16(0i, 5i);
                                    phi_2616_ = bitcast<f64>(((bitcast<u64>(_e1522) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1529 = phi_2613_;
                                        let _e1531 = phi_2616_;
                                        local_6 = _e1531;
                                        if (_e1529.member < _e1529.member_1) {
                                            let _e1538 = (_e1529.member + 1i);
                                            if ((false == (_e1538 > _e1529.member)) != false) {
                                                phi_2637_ = true;
                                            } else {
                                                phi_2637_ = false;
                                            }
                                            let _e1543 = phi_2637_;
                                            if _e1543 {
                                                phi_2643_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_2643_ = type_17(1u, _e1538);
                                            }
                                            let _e1548 = phi_2643_;
                                            phi_2614_ = type_16(_e1548.member_1, _e1529.member_1);
                                            phi_2657_ = type_17(1u, _e1529.member);
                                        } else {
                                            phi_2614_ = _e1529;
                                            phi_2657_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1554 = phi_2614_;
                                        let _e1556 = phi_2657_;
                                        let _e1559 = (bitcast<i32>(_e1556.member) != 0i);
                                        if _e1559 {
                                            phi_2617_ = (0.5lf * (_e1531 + (_e1522 / _e1531)));
                                        } else {
                                            phi_2617_ = f64();
                                        }
                                        let _e1564 = phi_2617_;
                                        continue;
                                        continuing {
                                            phi_2613_ = _e1554;
                                            phi_2616_ = _e1564;
                                            break if !(_e1559);
                                        }
                                    }
                                    let _e1569 = local_6;
                                    phi_2670_ = (_e1569 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1576 = phi_2670_;
                                let _e1577 = (f64(1f) / _e1576);
                                let _e1578 = (_e1512 * _e1577);
                                let _e1579 = (_e1514 * _e1577);
                                let _e1580 = (_e1516 * _e1577);
                                let _e1589 = ((f64(3f) - (((_e1578 * _e1578) + (_e1579 * _e1579)) + (_e1580 * _e1580))) * f64(0.5f));
                                let _e1590 = (_e1578 * _e1589);
                                let _e1591 = (_e1579 * _e1589);
                                let _e1592 = (_e1580 * _e1589);
                                let _e1597 = (((_e998 * _e1590) + (_e999 * _e1591)) + (_e1000 * _e1592));
                                phi_2699_ = array<f64, 3>((_e998 - (_e1590 * _e1597)), (_e999 - (_e1591 * _e1597)), (_e1000 - (_e1592 * _e1597)));
                            } else {
                                phi_2699_ = array<f64, 3>(_e998, _e999, _e1000);
                            }
                            let _e1606 = phi_2699_;
                            if (_e1606[0] < 0.0lf) {
                                phi_2706_ = -(_e1606[0]);
                            } else {
                                phi_2706_ = _e1606[0];
                            }
                            let _e1611 = phi_2706_;
                            if (_e1606[1] < 0.0lf) {
                                phi_2713_ = -(_e1606[1]);
                            } else {
                                phi_2713_ = _e1606[1];
                            }
                            let _e1616 = phi_2713_;
                            if (_e1606[2] < 0.0lf) {
                                phi_2721_ = -(_e1606[2]);
                            } else {
                                phi_2721_ = _e1606[2];
                            }
                            let _e1622 = phi_2721_;
                            if (((_e1611 + _e1616) + _e1622) > _e1211) {
                                let _e1625 = -(_e1003);
                                let _e1627 = (_e1606[0] * _e1625);
                                let _e1629 = (_e1606[1] * _e1625);
                                let _e1631 = (_e1606[2] * _e1625);
                                if (_e1627 < 0.0lf) {
                                    phi_2739_ = -(_e1627);
                                } else {
                                    phi_2739_ = _e1627;
                                }
                                let _e1635 = phi_2739_;
                                if (_e1629 < 0.0lf) {
                                    phi_2745_ = -(_e1629);
                                } else {
                                    phi_2745_ = _e1629;
                                }
                                let _e1639 = phi_2745_;
                                if (_e1635 > _e1639) {
                                    phi_2750_ = _e1635;
                                } else {
                                    phi_2750_ = _e1639;
                                }
                                let _e1642 = phi_2750_;
                                if (_e1631 < 0.0lf) {
                                    phi_2756_ = -(_e1631);
                                } else {
                                    phi_2756_ = _e1631;
                                }
                                let _e1646 = phi_2756_;
                                if (_e1642 > _e1646) {
                                    phi_2761_ = _e1642;
                                } else {
                                    phi_2761_ = _e1646;
                                }
                                let _e1649 = phi_2761_;
                                let _e1650 = function_9(_e1649);
                                let _e1651 = (_e1627 * _e1650);
                                let _e1652 = (_e1629 * _e1650);
                                let _e1653 = (_e1631 * _e1650);
                                let _e1659 = (((_e1651 * _e1651) + (_e1652 * _e1652)) + (_e1653 * _e1653));
                                if (_e1659 <= 2.2250738585072014e-308lf) {
                                    if (_e1659 > 0.0lf) {
                                        phi_2785_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_2785_ = 0.0lf;
                                    }
                                    let _e1711 = phi_2785_;
                                    phi_2849_ = _e1711;
                                } else {
                                    phi_2792_ = type_16(0i, 5i);
                                    phi_2795_ = bitcast<f64>(((bitcast<u64>(_e1659) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1666 = phi_2792_;
                                        let _e1668 = phi_2795_;
                                        local_7 = _e1668;
                                        if (_e1666.member < _e1666.member_1) {
                                            let _e1675 = (_e1666.member + 1i);
                                            if ((false == (_e1675 > _e1666.member)) != false) {
                                                phi_2816_ = true;
                                            } else {
                                                phi_2816_ = false;
                                            }
                                            let _e1680 = phi_2816_;
                                            if _e1680 {
                                                phi_2822_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_2822_ = type_17(1u, _e1675);
                                            }
                                            let _e1685 = phi_2822_;
                                            phi_2793_ = type_16(_e1685.member_1, _e1666.member_1);
                                            phi_2836_ = type_17(1u, _e1666.member);
                                        } else {
                                            phi_2793_ = _e1666;
                                            phi_2836_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1691 = phi_2793_;
                                        let _e1693 = phi_2836_;
                                        let _e1696 = (bitcast<i32>(_e1693.member) != 0i);
                                        if _e1696 {
                                            phi_2796_ = (0.5lf * (_e1668 + (_e1659 / _e1668)));
                                        } else {
                                            phi_2796_ = f64();
                                        }
                                        let _e1701 = phi_2796_;
                                        continue;
                                        continuing {
                                            phi_2792_ = _e1691;
                                            phi_2795_ = _e1701;
                                            break if !(_e1696);
                                        }
                                    }
                                    let _e1706 = local_7;
                                    phi_2849_ = (_e1706 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1713 = phi_2849_;
                                let _e1714 = (f64(1f) / _e1713);
                                let _e1715 = (_e1651 * _e1714);
                                let _e1716 = (_e1652 * _e1714);
                                let _e1717 = (_e1653 * _e1714);
                                let _e1726 = ((f64(3f) - (((_e1715 * _e1715) + (_e1716 * _e1716)) + (_e1717 * _e1717))) * f64(0.5f));
                                phi_2867_ = array<f64, 3>((_e1715 * _e1726), (_e1716 * _e1726), (_e1717 * _e1726));
                                phi_2868_ = false;
                            } else {
                                phi_2867_ = array<f64, 3>();
                                phi_2868_ = true;
                            }
                            let _e1732 = phi_2867_;
                            let _e1734 = phi_2868_;
                            phi_2869_ = _e1732;
                            phi_2870_ = _e1734;
                        } else {
                            phi_2869_ = array<f64, 3>();
                            phi_2870_ = true;
                        }
                        let _e1736 = phi_2869_;
                        let _e1738 = phi_2870_;
                        if _e1738 {
                            if _e1034 {
                                if (_e1040 < 0.0lf) {
                                    phi_2882_ = -(_e1040);
                                } else {
                                    phi_2882_ = _e1040;
                                }
                                let _e2071 = phi_2882_;
                                if (_e1041 < 0.0lf) {
                                    phi_2888_ = -(_e1041);
                                } else {
                                    phi_2888_ = _e1041;
                                }
                                let _e2075 = phi_2888_;
                                if (_e2071 > _e2075) {
                                    phi_2893_ = _e2071;
                                } else {
                                    phi_2893_ = _e2075;
                                }
                                let _e2078 = phi_2893_;
                                if (_e1042 < 0.0lf) {
                                    phi_2899_ = -(_e1042);
                                } else {
                                    phi_2899_ = _e1042;
                                }
                                let _e2082 = phi_2899_;
                                if (_e2078 > _e2082) {
                                    phi_2904_ = _e2078;
                                } else {
                                    phi_2904_ = _e2082;
                                }
                                let _e2085 = phi_2904_;
                                let _e2086 = function_9(_e2085);
                                let _e2087 = (_e1040 * _e2086);
                                let _e2088 = (_e1041 * _e2086);
                                let _e2089 = (_e1042 * _e2086);
                                let _e2095 = (((_e2087 * _e2087) + (_e2088 * _e2088)) + (_e2089 * _e2089));
                                if (_e2095 <= 2.2250738585072014e-308lf) {
                                    if (_e2095 > 0.0lf) {
                                        phi_2928_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_2928_ = 0.0lf;
                                    }
                                    let _e2147 = phi_2928_;
                                    phi_2992_ = _e2147;
                                } else {
                                    phi_2935_ = type_16(0i, 5i);
                                    phi_2938_ = bitcast<f64>(((bitcast<u64>(_e2095) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2102 = phi_2935_;
                                        let _e2104 = phi_2938_;
                                        local_10 = _e2104;
                                        if (_e2102.member < _e2102.member_1) {
                                            let _e2111 = (_e2102.member + 1i);
                                            if ((false == (_e2111 > _e2102.member)) != false) {
                                                phi_2959_ = true;
                                            } else {
                                                phi_2959_ = false;
                                            }
                                            let _e2116 = phi_2959_;
                                            if _e2116 {
                                                phi_2965_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_2965_ = type_17(1u, _e2111);
                                            }
                                            let _e2121 = phi_2965_;
                                            phi_2936_ = type_16(_e2121.member_1, _e2102.member_1);
                                            phi_2979_ = type_17(1u, _e2102.member);
                                        } else {
                                            phi_2936_ = _e2102;
                                            phi_2979_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2127 = phi_2936_;
                                        let _e2129 = phi_2979_;
                                        let _e2132 = (bitcast<i32>(_e2129.member) != 0i);
                                        if _e2132 {
                                            phi_2939_ = (0.5lf * (_e2104 + (_e2095 / _e2104)));
                                        } else {
                                            phi_2939_ = f64();
                                        }
                                        let _e2137 = phi_2939_;
                                        continue;
                                        continuing {
                                            phi_2935_ = _e2127;
                                            phi_2938_ = _e2137;
                                            break if !(_e2132);
                                        }
                                    }
                                    let _e2142 = local_10;
                                    phi_2992_ = (_e2142 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e2149 = phi_2992_;
                                let _e2150 = (f64(1f) / _e2149);
                                let _e2151 = (_e2087 * _e2150);
                                let _e2152 = (_e2088 * _e2150);
                                let _e2153 = (_e2089 * _e2150);
                                let _e2162 = ((f64(3f) - (((_e2151 * _e2151) + (_e2152 * _e2152)) + (_e2153 * _e2153))) * f64(0.5f));
                                phi_3459_ = array<f64, 3>((_e2151 * _e2162), (_e2152 * _e2162), (_e2153 * _e2162));
                            } else {
                                let _e1740 = local.member_1;
                                let _e1746 = local.member_2;
                                let _e1751 = f64(0f);
                                let _e1752 = f64(1f);
                                if (_e1746[0] < 0.0lf) {
                                    phi_3030_ = -(_e1746[0]);
                                } else {
                                    phi_3030_ = _e1746[0];
                                }
                                let _e1756 = phi_3030_;
                                if (_e1746[1] < 0.0lf) {
                                    phi_3037_ = -(_e1746[1]);
                                } else {
                                    phi_3037_ = _e1746[1];
                                }
                                let _e1760 = phi_3037_;
                                if (_e1756 > _e1760) {
                                    phi_3042_ = _e1756;
                                } else {
                                    phi_3042_ = _e1760;
                                }
                                let _e1763 = phi_3042_;
                                if (_e1746[2] < 0.0lf) {
                                    phi_3049_ = -(_e1746[2]);
                                } else {
                                    phi_3049_ = _e1746[2];
                                }
                                let _e1767 = phi_3049_;
                                if (_e1763 > _e1767) {
                                    phi_3054_ = _e1763;
                                } else {
                                    phi_3054_ = _e1767;
                                }
                                let _e1770 = phi_3054_;
                                if (_e1740[0] < 0.0lf) {
                                    phi_3061_ = -(_e1740[0]);
                                } else {
                                    phi_3061_ = _e1740[0];
                                }
                                let _e1774 = phi_3061_;
                                if (_e1740[1] < 0.0lf) {
                                    phi_3068_ = -(_e1740[1]);
                                } else {
                                    phi_3068_ = _e1740[1];
                                }
                                let _e1778 = phi_3068_;
                                if (_e1774 > _e1778) {
                                    phi_3073_ = _e1774;
                                } else {
                                    phi_3073_ = _e1778;
                                }
                                let _e1781 = phi_3073_;
                                if (_e1740[2] < 0.0lf) {
                                    phi_3080_ = -(_e1740[2]);
                                } else {
                                    phi_3080_ = _e1740[2];
                                }
                                let _e1785 = phi_3080_;
                                if (_e1781 > _e1785) {
                                    phi_3085_ = _e1781;
                                } else {
                                    phi_3085_ = _e1785;
                                }
                                let _e1788 = phi_3085_;
                                if (_e1770 > _e1788) {
                                    phi_3090_ = array<f64, 3>(_e1746[0], _e1746[1], _e1746[2]);
                                } else {
                                    phi_3090_ = array<f64, 3>(_e1740[0], _e1740[1], _e1740[2]);
                                }
                                let _e1791 = phi_3090_;
                                if (_e1791[0] < 0.0lf) {
                                    phi_3097_ = -(_e1791[0]);
                                } else {
                                    phi_3097_ = _e1791[0];
                                }
                                let _e1796 = phi_3097_;
                                if (_e1791[1] < 0.0lf) {
                                    phi_3104_ = -(_e1791[1]);
                                } else {
                                    phi_3104_ = _e1791[1];
                                }
                                let _e1801 = phi_3104_;
                                if (_e1796 > _e1801) {
                                    phi_3109_ = _e1796;
                                } else {
                                    phi_3109_ = _e1801;
                                }
                                let _e1804 = phi_3109_;
                                if (_e1791[2] < 0.0lf) {
                                    phi_3116_ = -(_e1791[2]);
                                } else {
                                    phi_3116_ = _e1791[2];
                                }
                                let _e1809 = phi_3116_;
                                if (_e1804 > _e1809) {
                                    phi_3121_ = _e1804;
                                } else {
                                    phi_3121_ = _e1809;
                                }
                                let _e1812 = phi_3121_;
                                if (_e1812 > _e1751) {
                                    if (_e1791[0] < 0.0lf) {
                                        phi_3132_ = -(_e1791[0]);
                                    } else {
                                        phi_3132_ = _e1791[0];
                                    }
                                    let _e1819 = phi_3132_;
                                    if (_e1791[1] < 0.0lf) {
                                        phi_3139_ = -(_e1791[1]);
                                    } else {
                                        phi_3139_ = _e1791[1];
                                    }
                                    let _e1824 = phi_3139_;
                                    if (_e1791[2] < 0.0lf) {
                                        phi_3146_ = -(_e1791[2]);
                                    } else {
                                        phi_3146_ = _e1791[2];
                                    }
                                    let _e1829 = phi_3146_;
                                    if (_e1819 <= _e1824) {
                                        if (_e1819 <= _e1829) {
                                            phi_3156_ = array<f64, 3>(_e1752, _e1751, _e1751);
                                            phi_3157_ = false;
                                        } else {
                                            phi_3156_ = array<f64, 3>();
                                            phi_3157_ = true;
                                        }
                                        let _e1834 = phi_3156_;
                                        let _e1836 = phi_3157_;
                                        phi_3158_ = _e1834;
                                        phi_3159_ = _e1836;
                                    } else {
                                        phi_3158_ = array<f64, 3>();
                                        phi_3159_ = true;
                                    }
                                    let _e1838 = phi_3158_;
                                    let _e1840 = phi_3159_;
                                    if _e1840 {
                                        if (_e1824 <= _e1829) {
                                            phi_3169_ = array<f64, 3>(_e1751, _e1752, _e1751);
                                        } else {
                                            phi_3169_ = array<f64, 3>(_e1751, _e1751, _e1752);
                                        }
                                        let _e1845 = phi_3169_;
                                        phi_3170_ = _e1845;
                                    } else {
                                        phi_3170_ = _e1838;
                                    }
                                    let _e1847 = phi_3170_;
                                    if (_e1791[0] < 0.0lf) {
                                        phi_3177_ = -(_e1791[0]);
                                    } else {
                                        phi_3177_ = _e1791[0];
                                    }
                                    let _e1852 = phi_3177_;
                                    if (_e1791[1] < 0.0lf) {
                                        phi_3184_ = -(_e1791[1]);
                                    } else {
                                        phi_3184_ = _e1791[1];
                                    }
                                    let _e1857 = phi_3184_;
                                    if (_e1852 > _e1857) {
                                        phi_3189_ = _e1852;
                                    } else {
                                        phi_3189_ = _e1857;
                                    }
                                    let _e1860 = phi_3189_;
                                    if (_e1791[2] < 0.0lf) {
                                        phi_3196_ = -(_e1791[2]);
                                    } else {
                                        phi_3196_ = _e1791[2];
                                    }
                                    let _e1865 = phi_3196_;
                                    if (_e1860 > _e1865) {
                                        phi_3201_ = _e1860;
                                    } else {
                                        phi_3201_ = _e1865;
                                    }
                                    let _e1868 = phi_3201_;
                                    let _e1869 = function_9(_e1868);
                                    let _e1871 = (_e1791[0] * _e1869);
                                    let _e1873 = (_e1791[1] * _e1869);
                                    let _e1875 = (_e1791[2] * _e1869);
                                    let _e1881 = (((_e1871 * _e1871) + (_e1873 * _e1873)) + (_e1875 * _e1875));
                                    if (_e1881 <= 2.2250738585072014e-308lf) {
                                        if (_e1881 > 0.0lf) {
                                            phi_3228_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3228_ = 0.0lf;
                                        }
                                        let _e1933 = phi_3228_;
                                        phi_3292_ = _e1933;
                                    } else {
                                        phi_3235_ = type_16(0i, 5i);
                                        phi_3238_ = bitcast<f64>(((bitcast<u64>(_e1881) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1888 = phi_3235_;
                                            let _e1890 = phi_3238_;
                                            local_8 = _e1890;
                                            if (_e1888.member < _e1888.member_1) {
                                                let _e1897 = (_e1888.member + 1i);
                                                if ((false == (_e1897 > _e1888.member)) != false) {
                                                    phi_3259_ = true;
                                                } else {
                                                    phi_3259_ = false;
                                                }
                                                let _e1902 = phi_3259_;
                                                if _e1902 {
                                                    phi_3265_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_3265_ = type_17(1u, _e1897);
                                                }
                                                let _e1907 = phi_3265_;
                                                phi_3236_ = type_16(_e1907.member_1, _e1888.member_1);
                                                phi_3279_ = type_17(1u, _e1888.member);
                                            } else {
                                                phi_3236_ = _e1888;
                                                phi_3279_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e1913 = phi_3236_;
                                            let _e1915 = phi_3279_;
                                            let _e1918 = (bitcast<i32>(_e1915.member) != 0i);
                                            if _e1918 {
                                                phi_3239_ = (0.5lf * (_e1890 + (_e1881 / _e1890)));
                                            } else {
                                                phi_3239_ = f64();
                                            }
                                            let _e1923 = phi_3239_;
                                            continue;
                                            continuing {
                                                phi_3235_ = _e1913;
                                                phi_3238_ = _e1923;
                                                break if !(_e1918);
                                            }
                                        }
                                        let _e1928 = local_8;
                                        phi_3292_ = (_e1928 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1935 = phi_3292_;
                                    let _e1936 = (f64(1f) / _e1935);
                                    let _e1937 = (_e1871 * _e1936);
                                    let _e1938 = (_e1873 * _e1936);
                                    let _e1939 = (_e1875 * _e1936);
                                    let _e1948 = ((f64(3f) - (((_e1937 * _e1937) + (_e1938 * _e1938)) + (_e1939 * _e1939))) * f64(0.5f));
                                    let _e1949 = (_e1937 * _e1948);
                                    let _e1950 = (_e1938 * _e1948);
                                    let _e1951 = (_e1939 * _e1948);
                                    let _e1956 = ((_e1950 * _e1847[2]) - (_e1951 * _e1847[1]));
                                    let _e1961 = ((_e1951 * _e1847[0]) - (_e1949 * _e1847[2]));
                                    let _e1966 = ((_e1949 * _e1847[1]) - (_e1950 * _e1847[0]));
                                    if (_e1956 < 0.0lf) {
                                        phi_3329_ = -(_e1956);
                                    } else {
                                        phi_3329_ = _e1956;
                                    }
                                    let _e1970 = phi_3329_;
                                    if (_e1961 < 0.0lf) {
                                        phi_3335_ = -(_e1961);
                                    } else {
                                        phi_3335_ = _e1961;
                                    }
                                    let _e1974 = phi_3335_;
                                    if (_e1970 > _e1974) {
                                        phi_3340_ = _e1970;
                                    } else {
                                        phi_3340_ = _e1974;
                                    }
                                    let _e1977 = phi_3340_;
                                    if (_e1966 < 0.0lf) {
                                        phi_3346_ = -(_e1966);
                                    } else {
                                        phi_3346_ = _e1966;
                                    }
                                    let _e1981 = phi_3346_;
                                    if (_e1977 > _e1981) {
                                        phi_3351_ = _e1977;
                                    } else {
                                        phi_3351_ = _e1981;
                                    }
                                    let _e1984 = phi_3351_;
                                    let _e1985 = function_9(_e1984);
                                    let _e1986 = (_e1956 * _e1985);
                                    let _e1987 = (_e1961 * _e1985);
                                    let _e1988 = (_e1966 * _e1985);
                                    let _e1994 = (((_e1986 * _e1986) + (_e1987 * _e1987)) + (_e1988 * _e1988));
                                    if (_e1994 <= 2.2250738585072014e-308lf) {
                                        if (_e1994 > 0.0lf) {
                                            phi_3375_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3375_ = 0.0lf;
                                        }
                                        let _e2046 = phi_3375_;
                                        phi_3439_ = _e2046;
                                    } else {
                                        phi_3382_ = type_16(0i, 5i);
                                        phi_3385_ = bitcast<f64>(((bitcast<u64>(_e1994) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e2001 = phi_3382_;
                                            let _e2003 = phi_3385_;
                                            local_9 = _e2003;
                                            if (_e2001.member < _e2001.member_1) {
                                                let _e2010 = (_e2001.member + 1i);
                                                if ((false == (_e2010 > _e2001.member)) != false) {
                                                    phi_3406_ = true;
                                                } else {
                                                    phi_3406_ = false;
                                                }
                                                let _e2015 = phi_3406_;
                                                if _e2015 {
                                                    phi_3412_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_3412_ = type_17(1u, _e2010);
                                                }
                                                let _e2020 = phi_3412_;
                                                phi_3383_ = type_16(_e2020.member_1, _e2001.member_1);
                                                phi_3426_ = type_17(1u, _e2001.member);
                                            } else {
                                                phi_3383_ = _e2001;
                                                phi_3426_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e2026 = phi_3383_;
                                            let _e2028 = phi_3426_;
                                            let _e2031 = (bitcast<i32>(_e2028.member) != 0i);
                                            if _e2031 {
                                                phi_3386_ = (0.5lf * (_e2003 + (_e1994 / _e2003)));
                                            } else {
                                                phi_3386_ = f64();
                                            }
                                            let _e2036 = phi_3386_;
                                            continue;
                                            continuing {
                                                phi_3382_ = _e2026;
                                                phi_3385_ = _e2036;
                                                break if !(_e2031);
                                            }
                                        }
                                        let _e2041 = local_9;
                                        phi_3439_ = (_e2041 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e2048 = phi_3439_;
                                    let _e2049 = (f64(1f) / _e2048);
                                    let _e2050 = (_e1986 * _e2049);
                                    let _e2051 = (_e1987 * _e2049);
                                    let _e2052 = (_e1988 * _e2049);
                                    let _e2061 = ((f64(3f) - (((_e2050 * _e2050) + (_e2051 * _e2051)) + (_e2052 * _e2052))) * f64(0.5f));
                                    phi_3458_ = array<f64, 3>((_e2050 * _e2061), (_e2051 * _e2061), (_e2052 * _e2061));
                                } else {
                                    phi_3458_ = array<f64, 3>(_e1752, _e1751, _e1751);
                                }
                                let _e2067 = phi_3458_;
                                phi_3459_ = _e2067;
                            }
                            let _e2168 = phi_3459_;
                            phi_3460_ = _e2168;
                            phi_3461_ = false;
                        } else {
                            phi_3460_ = array<f64, 3>();
                            phi_3461_ = true;
                        }
                        let _e2170 = phi_3460_;
                        let _e2172 = phi_3461_;
                        phi_3462_ = _e2170;
                        phi_3463_ = _e1736;
                        phi_3464_ = _e2172;
                    } else {
                        phi_3462_ = array<f64, 3>();
                        phi_3463_ = _e1355;
                        phi_3464_ = true;
                    }
                    let _e2174 = phi_3462_;
                    let _e2176 = phi_3463_;
                    let _e2178 = phi_3464_;
                    phi_3468_ = _e2176;
                    phi_3469_ = _e2174;
                    phi_3470_ = _e2178;
                }
                let _e2427 = phi_3468_;
                let _e2429 = phi_3469_;
                let _e2431 = phi_3470_;
                if _e2431 {
                    phi_3474_ = _e2427;
                } else {
                    phi_3474_ = _e2429;
                }
                let _e2433 = phi_3474_;
                if ((((_e2433[0] * _e2433[0]) + (_e2433[1] * _e2433[1])) + (_e2433[2] * _e2433[2])) > f64(0.5f)) {
                    phi_3494_ = _e2433;
                } else {
                    phi_3494_ = array<f64, 3>(_e337, f64(0f), f64(0f));
                }
                let _e2451 = phi_3494_;
                let _e2454 = function_10(_e343[0], _e344[0], _e338);
                let _e2457 = function_10(_e343[1], _e344[1], _e338);
                let _e2460 = function_10(_e343[2], _e344[2], _e338);
                let _e2463 = function_10(_e343[3], _e344[3], _e338);
                if (_e176.member != 0u) {
                    let _e2501 = function_10(_e2454, _e2457, _e901.member);
                    let _e2502 = function_10(_e2460, _e2463, _e901.member_1);
                    phi_3551_ = _e2502;
                    phi_3552_ = _e2501;
                    phi_3553_ = array<f64, 4>((_e337 - _e901.member), _e901.member, (_e337 - _e901.member_1), _e901.member_1);
                } else {
                    let _e2466 = ((_e337 - _e901.member) - _e901.member_1);
                    let _e2467 = f64(0f);
                    if (_e2466 > _e2467) {
                        phi_3523_ = _e2466;
                    } else {
                        phi_3523_ = _e2467;
                    }
                    let _e2470 = phi_3523_;
                    let _e2497 = function_1(array<f64, 4>(_e337, _e2470, _e901.member, _e901.member_1), _e342);
                    phi_3551_ = array<f64, 3>((((_e2457[0] * _e2470) + (_e2460[0] * _e901.member)) + (_e2463[0] * _e901.member_1)), (((_e2457[1] * _e2470) + (_e2460[1] * _e901.member)) + (_e2463[1] * _e901.member_1)), (((_e2457[2] * _e2470) + (_e2460[2] * _e901.member)) + (_e2463[2] * _e901.member_1)));
                    phi_3552_ = _e2454;
                    phi_3553_ = _e2497;
                }
                let _e2504 = phi_3551_;
                let _e2506 = phi_3552_;
                let _e2508 = phi_3553_;
                let _e2510 = function_10(_e2506, _e2504, f64(0.5f));
                let _e2512 = function_(_e2510);
                let _e2514 = function_(_e2451);
                geometry.member[_e137] = type_30(_e2512, f32((_e966 / _e586)), _e2514, _e144, array<f32, 4>(f32(_e2508[0]), f32(_e2508[1]), f32(_e2508[2]), f32(_e2508[3])), _e176.member_1);
            }
        }
        continue;
        continuing {
            phi_264_ = _e122;
            break if !(_e128);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn contact_geometry_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_14(id, n, lane);
}
