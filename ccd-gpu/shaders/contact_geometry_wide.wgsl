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

struct type_28 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_30 {
    member: array<array<u32, 3>>,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 4>,
    member_5: array<u32, 4>,
}

struct type_33 {
    member: array<type_31>,
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
var<storage> faces: type_30;
@group(0) @binding(2) 
var<storage> positions: type_40;
@group(0) @binding(5) 
var<storage> contacts: type_11;
@group(0) @binding(6) 
var<storage, read_write> geometry: type_33;

fn function_(param: array<f64, 3>) -> array<f32, 3> {
    return array<f32, 3>(f32(param[0]), f32(param[1]), f32(param[2]));
}

fn function_1(param_1: array<f64, 4>, param_2: u32) -> array<f64, 4> {
    var phi_4733_: array<f64, 4>;

    switch bitcast<i32>(param_2) {
        case 0: {
            phi_4733_ = param_1;
            break;
        }
        case 1: {
            phi_4733_ = array<f64, 4>(param_1[0], param_1[3], param_1[1], param_1[2]);
            break;
        }
        default: {
            phi_4733_ = array<f64, 4>(param_1[0], param_1[2], param_1[3], param_1[1]);
            break;
        }
    }
    let _e14 = phi_4733_;
    return _e14;
}

fn function_2(param_3: array<array<f64, 3>, 2>) -> array<f64, 3> {
    return array<f64, 3>((param_3[1][0] - param_3[0][0]), (param_3[1][1] - param_3[0][1]), (param_3[1][2] - param_3[0][2]));
}

fn function_3(param_4: type_44, param_5: type_44) -> type_44 {
    var phi_4701_: type_44;

    if (param_5.member_3 < param_4.member_3) {
        phi_4701_ = param_5;
    } else {
        phi_4701_ = param_4;
    }
    let _e6 = phi_4701_;
    return _e6;
}

fn function_4(param_6: f64, param_7: f64) -> f64 {
    var phi_3770_: f64;
    var phi_3775_: f64;
    var phi_3776_: f64;

    let _e3 = f64(0f);
    if (param_6 > _e3) {
        if (param_6 < param_7) {
            phi_3770_ = param_6;
        } else {
            phi_3770_ = param_7;
        }
        let _e7 = phi_3770_;
        if (_e7 > _e3) {
            phi_3775_ = _e7;
        } else {
            phi_3775_ = _e3;
        }
        let _e10 = phi_3775_;
        phi_3776_ = _e10;
    } else {
        phi_3776_ = _e3;
    }
    let _e12 = phi_3776_;
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
    var phi_4399_: f64;
    var phi_4406_: f64;
    var phi_4418_: type_44;
    var phi_4419_: bool;
    var phi_4420_: type_44;
    var phi_4421_: bool;
    var phi_4276_: bool;
    var phi_4277_: bool;
    var phi_4293_: f64;
    var phi_4299_: f64;
    var phi_4302_: type_44;
    var phi_4303_: bool;
    var phi_4304_: type_44;
    var phi_4305_: bool;
    var phi_4306_: type_44;
    var phi_4307_: bool;
    var phi_4425_: type_44;
    var phi_4426_: bool;
    var phi_4501_: type_44;
    var phi_4502_: type_44;
    var phi_4503_: bool;
    var phi_4507_: type_44;

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
            phi_4277_ = ((_e136 + _e166) <= _e10);
        } else {
            if (_e136 <= _e10) {
                phi_4276_ = (_e166 <= _e10);
            } else {
                phi_4276_ = false;
            }
            let _e170 = phi_4276_;
            phi_4277_ = _e170;
        }
        let _e174 = phi_4277_;
        if (_e136 >= _e9) {
            if (_e166 >= _e9) {
                if _e174 {
                    if _e11 {
                        phi_4293_ = (_e10 - _e136);
                    } else {
                        phi_4293_ = _e10;
                    }
                    let _e179 = phi_4293_;
                    let _e180 = function_7(param_17, _e136, _e179);
                    if _e11 {
                        phi_4299_ = (_e10 - _e180);
                    } else {
                        phi_4299_ = _e10;
                    }
                    let _e183 = phi_4299_;
                    let _e184 = function_5(param_17, _e180, _e183);
                    let _e185 = function_6(param_17, _e184, _e180);
                    phi_4302_ = _e185;
                    phi_4303_ = false;
                } else {
                    phi_4302_ = type_44();
                    phi_4303_ = true;
                }
                let _e187 = phi_4302_;
                let _e189 = phi_4303_;
                phi_4304_ = _e187;
                phi_4305_ = _e189;
            } else {
                phi_4304_ = type_44();
                phi_4305_ = true;
            }
            let _e191 = phi_4304_;
            let _e193 = phi_4305_;
            phi_4306_ = _e191;
            phi_4307_ = _e193;
        } else {
            phi_4306_ = type_44();
            phi_4307_ = true;
        }
        let _e195 = phi_4306_;
        let _e197 = phi_4307_;
        phi_4425_ = _e195;
        phi_4426_ = _e197;
    } else {
        if _e11 {
            phi_4420_ = type_44();
            phi_4421_ = true;
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
                phi_4399_ = _e29;
            } else {
                phi_4399_ = _e52;
            }
            let _e70 = phi_4399_;
            let _e72 = function_4((_e70 / _e67), _e10);
            if (_e29 > _e52) {
                phi_4406_ = _e29;
            } else {
                phi_4406_ = _e52;
            }
            let _e75 = phi_4406_;
            let _e77 = function_4((_e75 / _e67), _e10);
            if (_e72 < _e77) {
                let _e81 = ((_e72 + _e77) * f64(0.5f));
                let _e82 = function_7(param_17, _e81, _e10);
                let _e83 = function_6(param_17, _e81, _e82);
                phi_4418_ = _e83;
                phi_4419_ = false;
            } else {
                phi_4418_ = type_44();
                phi_4419_ = true;
            }
            let _e85 = phi_4418_;
            let _e87 = phi_4419_;
            phi_4420_ = _e85;
            phi_4421_ = _e87;
        }
        let _e89 = phi_4420_;
        let _e91 = phi_4421_;
        phi_4425_ = _e89;
        phi_4426_ = _e91;
    }
    let _e199 = phi_4425_;
    let _e201 = phi_4426_;
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
            phi_4501_ = _e253;
        } else {
            let _e207 = function_7(param_17, _e10, _e10);
            let _e208 = function_6(param_17, _e10, _e207);
            let _e209 = function_5(param_17, _e10, _e10);
            let _e210 = function_6(param_17, _e209, _e10);
            let _e211 = function_3(_e208, _e210);
            let _e212 = function_3(_e206, _e211);
            phi_4501_ = _e212;
        }
        let _e255 = phi_4501_;
        phi_4502_ = _e255;
        phi_4503_ = false;
    } else {
        phi_4502_ = type_44();
        phi_4503_ = true;
    }
    let _e257 = phi_4502_;
    let _e259 = phi_4503_;
    if _e259 {
        phi_4507_ = _e199;
    } else {
        phi_4507_ = _e257;
    }
    let _e261 = phi_4507_;
    return _e261;
}

fn function_9(param_19: f64) -> f64 {
    var phi_4128_: u64;
    var phi_4132_: f64;
    var phi_4134_: f64;

    if ((bitcast<u64>(param_19) & 9218868437227405312lu) != 9218868437227405312lu) {
        if (param_19 >= 2.2250738585072014e-308lf) {
            let _e15 = (9214364837600034816lu - (bitcast<u64>(param_19) & 9218868437227405312lu));
            if (_e15 > 4503599627370496lu) {
                phi_4128_ = _e15;
            } else {
                phi_4128_ = 4503599627370496lu;
            }
            let _e18 = phi_4128_;
            phi_4132_ = bitcast<f64>(_e18);
        } else {
            phi_4132_ = (f64(1f) / 2.2250738585072014e-308lf);
        }
        let _e21 = phi_4132_;
        phi_4134_ = _e21;
    } else {
        phi_4134_ = f64(1f);
    }
    let _e23 = phi_4134_;
    return _e23;
}

fn function_10(param_20: array<f64, 3>, param_21: array<f64, 3>, param_22: f64) -> array<f64, 3> {
    let _e5 = (f64(1f) - param_22);
    return array<f64, 3>(((param_20[0] * _e5) + (param_21[0] * param_22)), ((param_20[1] * _e5) + (param_21[1] * param_22)), ((param_20[2] * _e5) + (param_21[2] * param_22)));
}

fn function_11(param_23: ptr<function, array<array<f64, 3>, 4>>, param_24: u32) -> array<array<f64, 3>, 4> {
    var phi_4105_: array<array<f64, 3>, 4>;

    switch bitcast<i32>(param_24) {
        case 0: {
            let _e32 = (*param_23);
            phi_4105_ = array<array<f64, 3>, 4>(array<f64, 3>(_e32[0][0], _e32[0][1], _e32[0][2]), array<f64, 3>(_e32[1][0], _e32[1][1], _e32[1][2]), array<f64, 3>(_e32[2][0], _e32[2][1], _e32[2][2]), array<f64, 3>(_e32[3][0], _e32[3][1], _e32[3][2]));
            break;
        }
        case 1: {
            let _e8 = (*param_23)[0u];
            let _e14 = (*param_23)[2u];
            let _e20 = (*param_23)[3u];
            let _e26 = (*param_23)[1u];
            phi_4105_ = array<array<f64, 3>, 4>(array<f64, 3>(_e8[0], _e8[1], _e8[2]), array<f64, 3>(_e14[0], _e14[1], _e14[2]), array<f64, 3>(_e20[0], _e20[1], _e20[2]), array<f64, 3>(_e26[0], _e26[1], _e26[2]));
            break;
        }
        default: {
            let _e55 = (*param_23)[0u];
            let _e61 = (*param_23)[3u];
            let _e67 = (*param_23)[1u];
            let _e73 = (*param_23)[2u];
            phi_4105_ = array<array<f64, 3>, 4>(array<f64, 3>(_e55[0], _e55[1], _e55[2]), array<f64, 3>(_e61[0], _e61[1], _e61[2]), array<f64, 3>(_e67[0], _e67[1], _e67[2]), array<f64, 3>(_e73[0], _e73[1], _e73[2]));
            break;
        }
    }
    let _e80 = phi_4105_;
    return _e80;
}

fn function_12(param_25: ptr<function, array<array<f64, 3>, 4>>, param_26: ptr<function, array<array<f64, 3>, 4>>, param_27: f64) -> u32 {
    var phi_3832_: f64;
    var phi_3839_: f64;
    var phi_3847_: f64;
    var phi_3900_: f64;
    var phi_3907_: f64;
    var phi_3915_: f64;
    var phi_3968_: f64;
    var phi_3975_: f64;
    var phi_3983_: f64;
    var phi_3993_: bool;
    var phi_3994_: bool;
    var phi_4002_: u32;
    var phi_4003_: u32;

    let _e11 = (*param_25)[3u];
    let _e16 = (*param_25)[2u];
    let _e25 = (*param_26)[3u];
    let _e30 = (*param_26)[2u];
    let _e38 = function_10(array<f64, 3>((_e11[0] - _e16[0]), (_e11[1] - _e16[1]), (_e11[2] - _e16[2])), array<f64, 3>((_e25[0] - _e30[0]), (_e25[1] - _e30[1]), (_e25[2] - _e30[2])), param_27);
    if (_e38[0] < 0.0lf) {
        phi_3832_ = -(_e38[0]);
    } else {
        phi_3832_ = _e38[0];
    }
    let _e43 = phi_3832_;
    if (_e38[1] < 0.0lf) {
        phi_3839_ = -(_e38[1]);
    } else {
        phi_3839_ = _e38[1];
    }
    let _e48 = phi_3839_;
    if (_e38[2] < 0.0lf) {
        phi_3847_ = -(_e38[2]);
    } else {
        phi_3847_ = _e38[2];
    }
    let _e54 = phi_3847_;
    let _e55 = ((_e43 + _e48) + _e54);
    let _e57 = (*param_25)[1u];
    let _e62 = (*param_25)[3u];
    let _e71 = (*param_26)[1u];
    let _e76 = (*param_26)[3u];
    let _e84 = function_10(array<f64, 3>((_e57[0] - _e62[0]), (_e57[1] - _e62[1]), (_e57[2] - _e62[2])), array<f64, 3>((_e71[0] - _e76[0]), (_e71[1] - _e76[1]), (_e71[2] - _e76[2])), param_27);
    if (_e84[0] < 0.0lf) {
        phi_3900_ = -(_e84[0]);
    } else {
        phi_3900_ = _e84[0];
    }
    let _e89 = phi_3900_;
    if (_e84[1] < 0.0lf) {
        phi_3907_ = -(_e84[1]);
    } else {
        phi_3907_ = _e84[1];
    }
    let _e94 = phi_3907_;
    if (_e84[2] < 0.0lf) {
        phi_3915_ = -(_e84[2]);
    } else {
        phi_3915_ = _e84[2];
    }
    let _e100 = phi_3915_;
    let _e101 = ((_e89 + _e94) + _e100);
    let _e103 = (*param_25)[2u];
    let _e108 = (*param_25)[1u];
    let _e117 = (*param_26)[2u];
    let _e122 = (*param_26)[1u];
    let _e130 = function_10(array<f64, 3>((_e103[0] - _e108[0]), (_e103[1] - _e108[1]), (_e103[2] - _e108[2])), array<f64, 3>((_e117[0] - _e122[0]), (_e117[1] - _e122[1]), (_e117[2] - _e122[2])), param_27);
    if (_e130[0] < 0.0lf) {
        phi_3968_ = -(_e130[0]);
    } else {
        phi_3968_ = _e130[0];
    }
    let _e135 = phi_3968_;
    if (_e130[1] < 0.0lf) {
        phi_3975_ = -(_e130[1]);
    } else {
        phi_3975_ = _e130[1];
    }
    let _e140 = phi_3975_;
    if (_e130[2] < 0.0lf) {
        phi_3983_ = -(_e130[2]);
    } else {
        phi_3983_ = _e130[2];
    }
    let _e146 = phi_3983_;
    let _e147 = ((_e135 + _e140) + _e146);
    if (_e55 >= _e101) {
        if (_e55 >= _e147) {
            phi_3993_ = false;
        } else {
            phi_3993_ = true;
        }
        let _e151 = phi_3993_;
        phi_3994_ = _e151;
    } else {
        phi_3994_ = true;
    }
    let _e153 = phi_3994_;
    if _e153 {
        if (_e101 >= _e147) {
            phi_4002_ = 1u;
        } else {
            phi_4002_ = 2u;
        }
        let _e156 = phi_4002_;
        phi_4003_ = _e156;
    } else {
        phi_4003_ = 0u;
    }
    let _e158 = phi_4003_;
    return _e158;
}

fn function_13(param_28: array<f32, 3>) -> array<f64, 3> {
    var phi_3669_: f64;
    var phi_3647_: array<u32, 2>;
    var phi_3670_: f64;
    var phi_3712_: f64;
    var phi_3690_: array<u32, 2>;
    var phi_3713_: f64;
    var phi_3755_: f64;
    var phi_3733_: array<u32, 2>;
    var phi_3756_: f64;

    let _e10 = bitcast<u32>(param_28[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e21 = bitcast<u32>(param_28[0]);
        let _e22 = (_e21 & 2147483647u);
        if (_e22 < 8388608u) {
            phi_3647_ = array<u32, 2>(0u, 0u);
        } else {
            phi_3647_ = array<u32, 2>((_e21 << bitcast<u32>(29i)), ((_e21 ^ _e22) | ((_e22 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e33 = phi_3647_;
        phi_3670_ = bitcast<f64>(((u64(_e33[1]) * 4294967296lu) + u64(_e33[0])));
    } else {
        if (_e10 == _e11) {
            phi_3669_ = (f64(_e11) * 1.401298464324817e-45lf);
        } else {
            phi_3669_ = -((f64(_e11) * 1.401298464324817e-45lf));
        }
        let _e20 = phi_3669_;
        phi_3670_ = _e20;
    }
    let _e42 = phi_3670_;
    let _e44 = bitcast<u32>(param_28[1]);
    let _e45 = (_e44 & 2147483647u);
    if (_e45 >= 8388608u) {
        let _e55 = bitcast<u32>(param_28[1]);
        let _e56 = (_e55 & 2147483647u);
        if (_e56 < 8388608u) {
            phi_3690_ = array<u32, 2>(0u, 0u);
        } else {
            phi_3690_ = array<u32, 2>((_e55 << bitcast<u32>(29i)), ((_e55 ^ _e56) | ((_e56 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e67 = phi_3690_;
        phi_3713_ = bitcast<f64>(((u64(_e67[1]) * 4294967296lu) + u64(_e67[0])));
    } else {
        if (_e44 == _e45) {
            phi_3712_ = (f64(_e45) * 1.401298464324817e-45lf);
        } else {
            phi_3712_ = -((f64(_e45) * 1.401298464324817e-45lf));
        }
        let _e54 = phi_3712_;
        phi_3713_ = _e54;
    }
    let _e76 = phi_3713_;
    let _e78 = bitcast<u32>(param_28[2]);
    let _e79 = (_e78 & 2147483647u);
    if (_e79 >= 8388608u) {
        let _e89 = bitcast<u32>(param_28[2]);
        let _e90 = (_e89 & 2147483647u);
        if (_e90 < 8388608u) {
            phi_3733_ = array<u32, 2>(0u, 0u);
        } else {
            phi_3733_ = array<u32, 2>((_e89 << bitcast<u32>(29i)), ((_e89 ^ _e90) | ((_e90 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e101 = phi_3733_;
        phi_3756_ = bitcast<f64>(((u64(_e101[1]) * 4294967296lu) + u64(_e101[0])));
    } else {
        if (_e78 == _e79) {
            phi_3755_ = (f64(_e79) * 1.401298464324817e-45lf);
        } else {
            phi_3755_ = -((f64(_e79) * 1.401298464324817e-45lf));
        }
        let _e88 = phi_3755_;
        phi_3756_ = _e88;
    }
    let _e110 = phi_3756_;
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
    var phi_264_: type_9;
    var phi_265_: type_9;
    var phi_288_: type_9;
    var phi_431_: type_28;
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
    var phi_1232_: f64;
    var phi_1238_: f64;
    var phi_1243_: f64;
    var phi_1249_: f64;
    var phi_1254_: f64;
    var phi_1262_: f64;
    var phi_1268_: f64;
    var phi_1273_: f64;
    var phi_1279_: f64;
    var phi_1284_: f64;
    var phi_1312_: type_16;
    var phi_1315_: f64;
    var phi_1336_: bool;
    var phi_1342_: type_17;
    var phi_1313_: type_16;
    var phi_1356_: type_17;
    var phi_1316_: f64;
    var local_3: f64;
    var phi_1305_: f64;
    var phi_1369_: f64;
    var phi_1379_: f64;
    var phi_1385_: f64;
    var phi_1435_: type_16;
    var phi_1438_: f64;
    var phi_1459_: bool;
    var phi_1465_: type_17;
    var phi_1436_: type_16;
    var phi_1479_: type_17;
    var phi_1439_: f64;
    var local_4: f64;
    var phi_1428_: f64;
    var phi_1492_: f64;
    var phi_1502_: f64;
    var phi_1508_: f64;
    var phi_1549_: bool;
    var phi_1555_: bool;
    var phi_1571_: bool;
    var phi_1572_: bool;
    var phi_1573_: bool;
    var phi_1574_: bool;
    var phi_1575_: bool;
    var phi_1579_: bool;
    var phi_1931_: f64;
    var phi_1938_: f64;
    var phi_1943_: f64;
    var phi_1950_: f64;
    var phi_1955_: f64;
    var phi_1963_: f64;
    var phi_1970_: f64;
    var phi_1975_: f64;
    var phi_1982_: f64;
    var phi_1987_: f64;
    var phi_1992_: f64;
    var phi_2002_: f64;
    var phi_2009_: f64;
    var phi_2014_: f64;
    var phi_2021_: f64;
    var phi_2026_: f64;
    var phi_2034_: f64;
    var phi_2041_: f64;
    var phi_2046_: f64;
    var phi_2053_: f64;
    var phi_2058_: f64;
    var phi_2063_: f64;
    var phi_2073_: f64;
    var phi_2080_: f64;
    var phi_2085_: f64;
    var phi_2092_: f64;
    var phi_2097_: f64;
    var phi_2105_: f64;
    var phi_2112_: f64;
    var phi_2117_: f64;
    var phi_2124_: f64;
    var phi_2129_: f64;
    var phi_2134_: f64;
    var phi_2154_: f64;
    var phi_2160_: f64;
    var phi_2165_: f64;
    var phi_2171_: f64;
    var phi_2176_: f64;
    var phi_2207_: type_16;
    var phi_2210_: f64;
    var phi_2231_: bool;
    var phi_2237_: type_17;
    var phi_2208_: type_16;
    var phi_2251_: type_17;
    var phi_2211_: f64;
    var local_5: f64;
    var phi_2200_: f64;
    var phi_2264_: f64;
    var phi_2292_: f64;
    var phi_2298_: f64;
    var phi_2305_: f64;
    var phi_2319_: f64;
    var phi_2333_: array<f64, 3>;
    var phi_2334_: array<f64, 3>;
    var phi_2335_: bool;
    var phi_2336_: array<f64, 3>;
    var phi_2337_: bool;
    var phi_2347_: bool;
    var phi_2348_: bool;
    var phi_2383_: array<f64, 3>;
    var phi_2384_: bool;
    var phi_2385_: array<f64, 3>;
    var phi_2386_: bool;
    var phi_2387_: array<f64, 3>;
    var phi_2388_: bool;
    var phi_2410_: f64;
    var phi_2417_: f64;
    var phi_2422_: f64;
    var phi_2429_: f64;
    var phi_2434_: f64;
    var phi_2447_: f64;
    var phi_2454_: f64;
    var phi_2459_: f64;
    var phi_2466_: f64;
    var phi_2471_: f64;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2487_: array<f64, 3>;
    var phi_2488_: bool;
    var phi_2489_: array<f64, 3>;
    var phi_2490_: bool;
    var phi_2504_: array<f64, 3>;
    var phi_2505_: array<f64, 3>;
    var phi_2506_: array<f64, 3>;
    var phi_2513_: f64;
    var phi_2520_: f64;
    var phi_2525_: f64;
    var phi_2532_: f64;
    var phi_2537_: f64;
    var phi_2545_: array<f64, 3>;
    var phi_2552_: f64;
    var phi_2559_: f64;
    var phi_2564_: f64;
    var phi_2571_: f64;
    var phi_2576_: f64;
    var phi_2588_: f64;
    var phi_2595_: f64;
    var phi_2600_: f64;
    var phi_2607_: f64;
    var phi_2612_: f64;
    var phi_2646_: type_16;
    var phi_2649_: f64;
    var phi_2670_: bool;
    var phi_2676_: type_17;
    var phi_2647_: type_16;
    var phi_2690_: type_17;
    var phi_2650_: f64;
    var local_6: f64;
    var phi_2639_: f64;
    var phi_2703_: f64;
    var phi_2732_: array<f64, 3>;
    var phi_2739_: f64;
    var phi_2746_: f64;
    var phi_2754_: f64;
    var phi_2772_: f64;
    var phi_2778_: f64;
    var phi_2783_: f64;
    var phi_2789_: f64;
    var phi_2794_: f64;
    var phi_2825_: type_16;
    var phi_2828_: f64;
    var phi_2849_: bool;
    var phi_2855_: type_17;
    var phi_2826_: type_16;
    var phi_2869_: type_17;
    var phi_2829_: f64;
    var local_7: f64;
    var phi_2818_: f64;
    var phi_2882_: f64;
    var phi_2900_: array<f64, 3>;
    var phi_2901_: bool;
    var phi_2902_: array<f64, 3>;
    var phi_2903_: bool;
    var phi_3063_: f64;
    var phi_3070_: f64;
    var phi_3075_: f64;
    var phi_3082_: f64;
    var phi_3087_: f64;
    var phi_3094_: f64;
    var phi_3101_: f64;
    var phi_3106_: f64;
    var phi_3113_: f64;
    var phi_3118_: f64;
    var phi_3123_: array<f64, 3>;
    var phi_3130_: f64;
    var phi_3137_: f64;
    var phi_3142_: f64;
    var phi_3149_: f64;
    var phi_3154_: f64;
    var phi_3165_: f64;
    var phi_3172_: f64;
    var phi_3179_: f64;
    var phi_3189_: array<f64, 3>;
    var phi_3190_: bool;
    var phi_3191_: array<f64, 3>;
    var phi_3192_: bool;
    var phi_3202_: array<f64, 3>;
    var phi_3203_: array<f64, 3>;
    var phi_3210_: f64;
    var phi_3217_: f64;
    var phi_3222_: f64;
    var phi_3229_: f64;
    var phi_3234_: f64;
    var phi_3268_: type_16;
    var phi_3271_: f64;
    var phi_3292_: bool;
    var phi_3298_: type_17;
    var phi_3269_: type_16;
    var phi_3312_: type_17;
    var phi_3272_: f64;
    var local_8: f64;
    var phi_3261_: f64;
    var phi_3325_: f64;
    var phi_3362_: f64;
    var phi_3368_: f64;
    var phi_3373_: f64;
    var phi_3379_: f64;
    var phi_3384_: f64;
    var phi_3415_: type_16;
    var phi_3418_: f64;
    var phi_3439_: bool;
    var phi_3445_: type_17;
    var phi_3416_: type_16;
    var phi_3459_: type_17;
    var phi_3419_: f64;
    var local_9: f64;
    var phi_3408_: f64;
    var phi_3472_: f64;
    var phi_3491_: array<f64, 3>;
    var phi_2915_: f64;
    var phi_2921_: f64;
    var phi_2926_: f64;
    var phi_2932_: f64;
    var phi_2937_: f64;
    var phi_2968_: type_16;
    var phi_2971_: f64;
    var phi_2992_: bool;
    var phi_2998_: type_17;
    var phi_2969_: type_16;
    var phi_3012_: type_17;
    var phi_2972_: f64;
    var local_10: f64;
    var phi_2961_: f64;
    var phi_3025_: f64;
    var phi_3492_: array<f64, 3>;
    var phi_3513_: array<f64, 3>;
    var phi_3514_: array<f64, 3>;
    var phi_3515_: bool;
    var phi_3516_: array<f64, 3>;
    var phi_3517_: array<f64, 3>;
    var phi_3518_: bool;
    var phi_1641_: array<f64, 3>;
    var phi_1648_: f64;
    var phi_1655_: f64;
    var phi_1660_: f64;
    var phi_1667_: f64;
    var phi_1672_: f64;
    var phi_1706_: type_16;
    var phi_1709_: f64;
    var phi_1730_: bool;
    var phi_1736_: type_17;
    var phi_1707_: type_16;
    var phi_1750_: type_17;
    var phi_1710_: f64;
    var local_11: f64;
    var phi_1699_: f64;
    var phi_1763_: f64;
    var phi_1781_: array<f64, 3>;
    var phi_1782_: bool;
    var phi_1783_: array<f64, 3>;
    var phi_1784_: bool;
    var phi_1785_: array<f64, 3>;
    var phi_1786_: bool;
    var phi_1795_: f64;
    var phi_1801_: f64;
    var phi_1806_: f64;
    var phi_1812_: f64;
    var phi_1817_: f64;
    var phi_1848_: type_16;
    var phi_1851_: f64;
    var phi_1872_: bool;
    var phi_1878_: type_17;
    var phi_1849_: type_16;
    var phi_1892_: type_17;
    var phi_1852_: f64;
    var local_12: f64;
    var phi_1841_: f64;
    var phi_1905_: f64;
    var phi_1923_: array<f64, 3>;
    var phi_3522_: array<f64, 3>;
    var phi_3523_: array<f64, 3>;
    var phi_3524_: bool;
    var phi_3528_: array<f64, 3>;
    var phi_3548_: array<f64, 3>;
    var phi_3577_: f64;
    var phi_3605_: array<f64, 3>;
    var phi_3606_: array<f64, 3>;
    var phi_3607_: array<f64, 4>;
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
    phi_264_ = type_9(0u, _e107);
    loop {
        let _e110 = phi_264_;
        if (_e110.member < _e110.member_1) {
            phi_265_ = type_9((_e110.member + 1u), _e110.member_1);
            phi_288_ = type_9(1u, _e110.member);
        } else {
            phi_265_ = _e110;
            phi_288_ = type_9(0u, type_9().member_1);
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
                    phi_431_ = type_28(0u, array<u32, 4>(_e147, _e169[0], _e169[1], _e169[2]));
                } else {
                    let _e159 = edges.member[_e147];
                    let _e161 = edges.member[_e150];
                    phi_431_ = type_28(1u, array<u32, 4>(_e159[0], _e159[1], _e161[0], _e161[1]));
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
                let _e762 = (_e501.member_3 * f64(4f));
                let _e770 = ((_e596 * _e604) - (_e598 * _e602));
                let _e773 = ((_e598 * _e600) - (_e594 * _e604));
                let _e776 = ((_e594 * _e602) - (_e596 * _e600));
                if (_e600 < 0.0lf) {
                    phi_1232_ = -(_e600);
                } else {
                    phi_1232_ = _e600;
                }
                let _e785 = phi_1232_;
                if (_e602 < 0.0lf) {
                    phi_1238_ = -(_e602);
                } else {
                    phi_1238_ = _e602;
                }
                let _e789 = phi_1238_;
                if (_e785 > _e789) {
                    phi_1243_ = _e785;
                } else {
                    phi_1243_ = _e789;
                }
                let _e792 = phi_1243_;
                if (_e604 < 0.0lf) {
                    phi_1249_ = -(_e604);
                } else {
                    phi_1249_ = _e604;
                }
                let _e796 = phi_1249_;
                if (_e792 > _e796) {
                    phi_1254_ = _e792;
                } else {
                    phi_1254_ = _e796;
                }
                let _e799 = phi_1254_;
                if (_e594 < 0.0lf) {
                    phi_1262_ = -(_e594);
                } else {
                    phi_1262_ = _e594;
                }
                let _e805 = phi_1262_;
                if (_e596 < 0.0lf) {
                    phi_1268_ = -(_e596);
                } else {
                    phi_1268_ = _e596;
                }
                let _e809 = phi_1268_;
                if (_e805 > _e809) {
                    phi_1273_ = _e805;
                } else {
                    phi_1273_ = _e809;
                }
                let _e812 = phi_1273_;
                if (_e598 < 0.0lf) {
                    phi_1279_ = -(_e598);
                } else {
                    phi_1279_ = _e598;
                }
                let _e816 = phi_1279_;
                if (_e812 > _e816) {
                    phi_1284_ = _e812;
                } else {
                    phi_1284_ = _e816;
                }
                let _e819 = phi_1284_;
                let _e821 = (((((_e706 * _e759) + _e762) * _e586) * _e799) + ((((_e757 * _e759) + _e762) * _e586) * _e819));
                let _e826 = (((_e770 * _e770) + (_e773 * _e773)) + (_e776 * _e776));
                if (_e826 <= 2.2250738585072014e-308lf) {
                    if (_e826 > 0.0lf) {
                        phi_1305_ = (1.464336215552873e-154lf * 2.0lf);
                    } else {
                        phi_1305_ = 0.0lf;
                    }
                    let _e878 = phi_1305_;
                    phi_1369_ = _e878;
                } else {
                    phi_1312_ = type_16(0i, 5i);
                    phi_1315_ = bitcast<f64>(((bitcast<u64>(_e826) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e833 = phi_1312_;
                        let _e835 = phi_1315_;
                        local_3 = _e835;
                        if (_e833.member < _e833.member_1) {
                            let _e842 = (_e833.member + 1i);
                            if ((false == (_e842 > _e833.member)) != false) {
                                phi_1336_ = true;
                            } else {
                                phi_1336_ = false;
                            }
                            let _e847 = phi_1336_;
                            if _e847 {
                                phi_1342_ = type_17(0u, type_17().member_1);
                            } else {
                                phi_1342_ = type_17(1u, _e842);
                            }
                            let _e852 = phi_1342_;
                            phi_1313_ = type_16(_e852.member_1, _e833.member_1);
                            phi_1356_ = type_17(1u, _e833.member);
                        } else {
                            phi_1313_ = _e833;
                            phi_1356_ = type_17(0u, type_17().member_1);
                        }
                        let _e858 = phi_1313_;
                        let _e860 = phi_1356_;
                        let _e863 = (bitcast<i32>(_e860.member) != 0i);
                        if _e863 {
                            phi_1316_ = (0.5lf * (_e835 + (_e826 / _e835)));
                        } else {
                            phi_1316_ = f64();
                        }
                        let _e868 = phi_1316_;
                        continue;
                        continuing {
                            phi_1312_ = _e858;
                            phi_1315_ = _e868;
                            break if !(_e863);
                        }
                    }
                    let _e873 = local_3;
                    phi_1369_ = (_e873 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e880 = phi_1369_;
                if (_e880 > f64(0f)) {
                    phi_1379_ = ((_e880 + (_e826 / _e880)) * f64(0.5f));
                } else {
                    phi_1379_ = _e880;
                }
                let _e888 = phi_1379_;
                if (_e888 > _e821) {
                    phi_1385_ = _e888;
                } else {
                    phi_1385_ = f64(0f);
                }
                let _e892 = phi_1385_;
                local = type_35(array<f64, 3>((_e506[0] * _e586), (_e506[1] * _e586), (_e506[2] * _e586)), array<f64, 3>(_e594, _e596, _e598), array<f64, 3>(_e600, _e602, _e604), array<f64, 3>(_e770, _e773, _e776), _e892, _e821, ((((((_e653 + _e501.member_3) + _e706) + _e757) * _e759) + _e762) * _e586));
                let _e898 = function_8((&local), _e176.member);
                if (_e898.member_3 <= 2.2250738585072014e-308lf) {
                    if (_e898.member_3 > 0.0lf) {
                        phi_1428_ = (1.464336215552873e-154lf * 2.0lf);
                    } else {
                        phi_1428_ = 0.0lf;
                    }
                    let _e953 = phi_1428_;
                    phi_1492_ = _e953;
                } else {
                    phi_1435_ = type_16(0i, 5i);
                    phi_1438_ = bitcast<f64>(((bitcast<u64>(_e898.member_3) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e908 = phi_1435_;
                        let _e910 = phi_1438_;
                        local_4 = _e910;
                        if (_e908.member < _e908.member_1) {
                            let _e917 = (_e908.member + 1i);
                            if ((false == (_e917 > _e908.member)) != false) {
                                phi_1459_ = true;
                            } else {
                                phi_1459_ = false;
                            }
                            let _e922 = phi_1459_;
                            if _e922 {
                                phi_1465_ = type_17(0u, type_17().member_1);
                            } else {
                                phi_1465_ = type_17(1u, _e917);
                            }
                            let _e927 = phi_1465_;
                            phi_1436_ = type_16(_e927.member_1, _e908.member_1);
                            phi_1479_ = type_17(1u, _e908.member);
                        } else {
                            phi_1436_ = _e908;
                            phi_1479_ = type_17(0u, type_17().member_1);
                        }
                        let _e933 = phi_1436_;
                        let _e935 = phi_1479_;
                        let _e938 = (bitcast<i32>(_e935.member) != 0i);
                        if _e938 {
                            phi_1439_ = (0.5lf * (_e910 + (_e898.member_3 / _e910)));
                        } else {
                            phi_1439_ = f64();
                        }
                        let _e943 = phi_1439_;
                        continue;
                        continuing {
                            phi_1435_ = _e933;
                            phi_1438_ = _e943;
                            break if !(_e938);
                        }
                    }
                    let _e948 = local_4;
                    phi_1492_ = (_e948 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e955 = phi_1492_;
                if (_e955 > f64(0f)) {
                    phi_1502_ = ((_e955 + (_e898.member_3 / _e955)) * f64(0.5f));
                } else {
                    phi_1502_ = _e955;
                }
                let _e963 = phi_1502_;
                if (_e176.member == 0u) {
                    phi_1508_ = _e337;
                } else {
                    phi_1508_ = -(_e337);
                }
                let _e967 = phi_1508_;
                let _e969 = function_2(_e501.member);
                let _e971 = function_2(_e501.member_1);
                let _e985 = function_2(_e501.member_2);
                let _e995 = (((_e969[0] - (_e971[0] * _e898.member)) - (_e985[0] * _e898.member_1)) * _e967);
                let _e996 = (((_e969[1] - (_e971[1] * _e898.member)) - (_e985[1] * _e898.member_1)) * _e967);
                let _e997 = (((_e969[2] - (_e971[2] * _e898.member)) - (_e985[2] * _e898.member_1)) * _e967);
                let _e999 = f64(0f);
                let _e1000 = f64(1f);
                if (_e898.member > _e999) {
                    phi_1549_ = (_e898.member < _e1000);
                } else {
                    phi_1549_ = false;
                }
                let _e1006 = phi_1549_;
                if (_e898.member_1 > _e999) {
                    phi_1555_ = (_e898.member_1 < _e1000);
                } else {
                    phi_1555_ = false;
                }
                let _e1010 = phi_1555_;
                let _e1011 = (_e967 > _e999);
                if _e1006 {
                    if _e1010 {
                        if _e1011 {
                            phi_1571_ = ((_e898.member + _e898.member_1) < (_e1000 - (1.1102230246251565e-16lf * f64(4f))));
                        } else {
                            phi_1571_ = true;
                        }
                        let _e1018 = phi_1571_;
                        phi_1572_ = _e1018;
                        phi_1573_ = false;
                    } else {
                        phi_1572_ = bool();
                        phi_1573_ = true;
                    }
                    let _e1020 = phi_1572_;
                    let _e1022 = phi_1573_;
                    phi_1574_ = _e1020;
                    phi_1575_ = _e1022;
                } else {
                    phi_1574_ = bool();
                    phi_1575_ = true;
                }
                let _e1024 = phi_1574_;
                let _e1026 = phi_1575_;
                if _e1026 {
                    phi_1579_ = false;
                } else {
                    phi_1579_ = _e1024;
                }
                let _e1028 = phi_1579_;
                let _e1030 = local.member_4;
                let _e1031 = (_e1030 > _e999);
                let _e1033 = local.member_3;
                let _e1037 = (_e1033[0] * _e967);
                let _e1038 = (_e1033[1] * _e967);
                let _e1039 = (_e1033[2] * _e967);
                let _e1042 = local.member_6;
                if (_e963 > _e1042) {
                    let _e2221 = (_e898.member_2[0] * _e967);
                    let _e2223 = (_e898.member_2[1] * _e967);
                    let _e2225 = (_e898.member_2[2] * _e967);
                    if _e1031 {
                        if _e1028 {
                            let _e2227 = local.member_5;
                            let _e2230 = local.member_6;
                            let _e2232 = local.member_4;
                            if ((_e2227 * _e963) <= (_e2230 * _e2232)) {
                                if ((((_e2221 * _e1037) + (_e2223 * _e1038)) + (_e2225 * _e1039)) >= _e999) {
                                    phi_1641_ = array<f64, 3>(_e1037, _e1038, _e1039);
                                } else {
                                    let _e2241 = -(_e1000);
                                    phi_1641_ = array<f64, 3>((_e1037 * _e2241), (_e1038 * _e2241), (_e1039 * _e2241));
                                }
                                let _e2247 = phi_1641_;
                                if (_e2247[0] < 0.0lf) {
                                    phi_1648_ = -(_e2247[0]);
                                } else {
                                    phi_1648_ = _e2247[0];
                                }
                                let _e2252 = phi_1648_;
                                if (_e2247[1] < 0.0lf) {
                                    phi_1655_ = -(_e2247[1]);
                                } else {
                                    phi_1655_ = _e2247[1];
                                }
                                let _e2257 = phi_1655_;
                                if (_e2252 > _e2257) {
                                    phi_1660_ = _e2252;
                                } else {
                                    phi_1660_ = _e2257;
                                }
                                let _e2260 = phi_1660_;
                                if (_e2247[2] < 0.0lf) {
                                    phi_1667_ = -(_e2247[2]);
                                } else {
                                    phi_1667_ = _e2247[2];
                                }
                                let _e2265 = phi_1667_;
                                if (_e2260 > _e2265) {
                                    phi_1672_ = _e2260;
                                } else {
                                    phi_1672_ = _e2265;
                                }
                                let _e2268 = phi_1672_;
                                let _e2269 = function_9(_e2268);
                                let _e2271 = (_e2247[0] * _e2269);
                                let _e2273 = (_e2247[1] * _e2269);
                                let _e2275 = (_e2247[2] * _e2269);
                                let _e2281 = (((_e2271 * _e2271) + (_e2273 * _e2273)) + (_e2275 * _e2275));
                                if (_e2281 <= 2.2250738585072014e-308lf) {
                                    if (_e2281 > 0.0lf) {
                                        phi_1699_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_1699_ = 0.0lf;
                                    }
                                    let _e2333 = phi_1699_;
                                    phi_1763_ = _e2333;
                                } else {
                                    phi_1706_ = type_16(0i, 5i);
                                    phi_1709_ = bitcast<f64>(((bitcast<u64>(_e2281) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2288 = phi_1706_;
                                        let _e2290 = phi_1709_;
                                        local_11 = _e2290;
                                        if (_e2288.member < _e2288.member_1) {
                                            let _e2297 = (_e2288.member + 1i);
                                            if ((false == (_e2297 > _e2288.member)) != false) {
                                                phi_1730_ = true;
                                            } else {
                                                phi_1730_ = false;
                                            }
                                            let _e2302 = phi_1730_;
                                            if _e2302 {
                                                phi_1736_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_1736_ = type_17(1u, _e2297);
                                            }
                                            let _e2307 = phi_1736_;
                                            phi_1707_ = type_16(_e2307.member_1, _e2288.member_1);
                                            phi_1750_ = type_17(1u, _e2288.member);
                                        } else {
                                            phi_1707_ = _e2288;
                                            phi_1750_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2313 = phi_1707_;
                                        let _e2315 = phi_1750_;
                                        let _e2318 = (bitcast<i32>(_e2315.member) != 0i);
                                        if _e2318 {
                                            phi_1710_ = (0.5lf * (_e2290 + (_e2281 / _e2290)));
                                        } else {
                                            phi_1710_ = f64();
                                        }
                                        let _e2323 = phi_1710_;
                                        continue;
                                        continuing {
                                            phi_1706_ = _e2313;
                                            phi_1709_ = _e2323;
                                            break if !(_e2318);
                                        }
                                    }
                                    let _e2328 = local_11;
                                    phi_1763_ = (_e2328 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e2335 = phi_1763_;
                                let _e2336 = (f64(1f) / _e2335);
                                let _e2337 = (_e2271 * _e2336);
                                let _e2338 = (_e2273 * _e2336);
                                let _e2339 = (_e2275 * _e2336);
                                let _e2348 = ((f64(3f) - (((_e2337 * _e2337) + (_e2338 * _e2338)) + (_e2339 * _e2339))) * f64(0.5f));
                                phi_1781_ = array<f64, 3>((_e2337 * _e2348), (_e2338 * _e2348), (_e2339 * _e2348));
                                phi_1782_ = false;
                            } else {
                                phi_1781_ = array<f64, 3>();
                                phi_1782_ = true;
                            }
                            let _e2354 = phi_1781_;
                            let _e2356 = phi_1782_;
                            phi_1783_ = _e2354;
                            phi_1784_ = _e2356;
                        } else {
                            phi_1783_ = array<f64, 3>();
                            phi_1784_ = true;
                        }
                        let _e2358 = phi_1783_;
                        let _e2360 = phi_1784_;
                        phi_1785_ = _e2358;
                        phi_1786_ = _e2360;
                    } else {
                        phi_1785_ = array<f64, 3>();
                        phi_1786_ = true;
                    }
                    let _e2362 = phi_1785_;
                    let _e2364 = phi_1786_;
                    if _e2364 {
                        if (_e2221 < 0.0lf) {
                            phi_1795_ = -(_e2221);
                        } else {
                            phi_1795_ = _e2221;
                        }
                        let _e2368 = phi_1795_;
                        if (_e2223 < 0.0lf) {
                            phi_1801_ = -(_e2223);
                        } else {
                            phi_1801_ = _e2223;
                        }
                        let _e2372 = phi_1801_;
                        if (_e2368 > _e2372) {
                            phi_1806_ = _e2368;
                        } else {
                            phi_1806_ = _e2372;
                        }
                        let _e2375 = phi_1806_;
                        if (_e2225 < 0.0lf) {
                            phi_1812_ = -(_e2225);
                        } else {
                            phi_1812_ = _e2225;
                        }
                        let _e2379 = phi_1812_;
                        if (_e2375 > _e2379) {
                            phi_1817_ = _e2375;
                        } else {
                            phi_1817_ = _e2379;
                        }
                        let _e2382 = phi_1817_;
                        let _e2383 = function_9(_e2382);
                        let _e2384 = (_e2221 * _e2383);
                        let _e2385 = (_e2223 * _e2383);
                        let _e2386 = (_e2225 * _e2383);
                        let _e2392 = (((_e2384 * _e2384) + (_e2385 * _e2385)) + (_e2386 * _e2386));
                        if (_e2392 <= 2.2250738585072014e-308lf) {
                            if (_e2392 > 0.0lf) {
                                phi_1841_ = (1.464336215552873e-154lf * 2.0lf);
                            } else {
                                phi_1841_ = 0.0lf;
                            }
                            let _e2444 = phi_1841_;
                            phi_1905_ = _e2444;
                        } else {
                            phi_1848_ = type_16(0i, 5i);
                            phi_1851_ = bitcast<f64>(((bitcast<u64>(_e2392) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e2399 = phi_1848_;
                                let _e2401 = phi_1851_;
                                local_12 = _e2401;
                                if (_e2399.member < _e2399.member_1) {
                                    let _e2408 = (_e2399.member + 1i);
                                    if ((false == (_e2408 > _e2399.member)) != false) {
                                        phi_1872_ = true;
                                    } else {
                                        phi_1872_ = false;
                                    }
                                    let _e2413 = phi_1872_;
                                    if _e2413 {
                                        phi_1878_ = type_17(0u, type_17().member_1);
                                    } else {
                                        phi_1878_ = type_17(1u, _e2408);
                                    }
                                    let _e2418 = phi_1878_;
                                    phi_1849_ = type_16(_e2418.member_1, _e2399.member_1);
                                    phi_1892_ = type_17(1u, _e2399.member);
                                } else {
                                    phi_1849_ = _e2399;
                                    phi_1892_ = type_17(0u, type_17().member_1);
                                }
                                let _e2424 = phi_1849_;
                                let _e2426 = phi_1892_;
                                let _e2429 = (bitcast<i32>(_e2426.member) != 0i);
                                if _e2429 {
                                    phi_1852_ = (0.5lf * (_e2401 + (_e2392 / _e2401)));
                                } else {
                                    phi_1852_ = f64();
                                }
                                let _e2434 = phi_1852_;
                                continue;
                                continuing {
                                    phi_1848_ = _e2424;
                                    phi_1851_ = _e2434;
                                    break if !(_e2429);
                                }
                            }
                            let _e2439 = local_12;
                            phi_1905_ = (_e2439 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e2446 = phi_1905_;
                        let _e2447 = (f64(1f) / _e2446);
                        let _e2448 = (_e2384 * _e2447);
                        let _e2449 = (_e2385 * _e2447);
                        let _e2450 = (_e2386 * _e2447);
                        let _e2459 = ((f64(3f) - (((_e2448 * _e2448) + (_e2449 * _e2449)) + (_e2450 * _e2450))) * f64(0.5f));
                        phi_1923_ = array<f64, 3>((_e2448 * _e2459), (_e2449 * _e2459), (_e2450 * _e2459));
                    } else {
                        phi_1923_ = _e2362;
                    }
                    let _e2465 = phi_1923_;
                    phi_3522_ = _e2465;
                    phi_3523_ = array<f64, 3>();
                    phi_3524_ = true;
                } else {
                    if (_e501.member[0][0] < 0.0lf) {
                        phi_1931_ = -(_e501.member[0][0]);
                    } else {
                        phi_1931_ = _e501.member[0][0];
                    }
                    let _e1050 = phi_1931_;
                    if (_e501.member[0][1] < 0.0lf) {
                        phi_1938_ = -(_e501.member[0][1]);
                    } else {
                        phi_1938_ = _e501.member[0][1];
                    }
                    let _e1055 = phi_1938_;
                    if (_e1050 > _e1055) {
                        phi_1943_ = _e1050;
                    } else {
                        phi_1943_ = _e1055;
                    }
                    let _e1058 = phi_1943_;
                    if (_e501.member[0][2] < 0.0lf) {
                        phi_1950_ = -(_e501.member[0][2]);
                    } else {
                        phi_1950_ = _e501.member[0][2];
                    }
                    let _e1063 = phi_1950_;
                    if (_e1058 > _e1063) {
                        phi_1955_ = _e1058;
                    } else {
                        phi_1955_ = _e1063;
                    }
                    let _e1066 = phi_1955_;
                    if (_e501.member[1][0] < 0.0lf) {
                        phi_1963_ = -(_e501.member[1][0]);
                    } else {
                        phi_1963_ = _e501.member[1][0];
                    }
                    let _e1073 = phi_1963_;
                    if (_e501.member[1][1] < 0.0lf) {
                        phi_1970_ = -(_e501.member[1][1]);
                    } else {
                        phi_1970_ = _e501.member[1][1];
                    }
                    let _e1078 = phi_1970_;
                    if (_e1073 > _e1078) {
                        phi_1975_ = _e1073;
                    } else {
                        phi_1975_ = _e1078;
                    }
                    let _e1081 = phi_1975_;
                    if (_e501.member[1][2] < 0.0lf) {
                        phi_1982_ = -(_e501.member[1][2]);
                    } else {
                        phi_1982_ = _e501.member[1][2];
                    }
                    let _e1086 = phi_1982_;
                    if (_e1081 > _e1086) {
                        phi_1987_ = _e1081;
                    } else {
                        phi_1987_ = _e1086;
                    }
                    let _e1089 = phi_1987_;
                    if (_e1066 > _e1089) {
                        phi_1992_ = _e1066;
                    } else {
                        phi_1992_ = _e1089;
                    }
                    let _e1092 = phi_1992_;
                    if (_e501.member_1[0][0] < 0.0lf) {
                        phi_2002_ = -(_e501.member_1[0][0]);
                    } else {
                        phi_2002_ = _e501.member_1[0][0];
                    }
                    let _e1101 = phi_2002_;
                    if (_e501.member_1[0][1] < 0.0lf) {
                        phi_2009_ = -(_e501.member_1[0][1]);
                    } else {
                        phi_2009_ = _e501.member_1[0][1];
                    }
                    let _e1106 = phi_2009_;
                    if (_e1101 > _e1106) {
                        phi_2014_ = _e1101;
                    } else {
                        phi_2014_ = _e1106;
                    }
                    let _e1109 = phi_2014_;
                    if (_e501.member_1[0][2] < 0.0lf) {
                        phi_2021_ = -(_e501.member_1[0][2]);
                    } else {
                        phi_2021_ = _e501.member_1[0][2];
                    }
                    let _e1114 = phi_2021_;
                    if (_e1109 > _e1114) {
                        phi_2026_ = _e1109;
                    } else {
                        phi_2026_ = _e1114;
                    }
                    let _e1117 = phi_2026_;
                    if (_e501.member_1[1][0] < 0.0lf) {
                        phi_2034_ = -(_e501.member_1[1][0]);
                    } else {
                        phi_2034_ = _e501.member_1[1][0];
                    }
                    let _e1124 = phi_2034_;
                    if (_e501.member_1[1][1] < 0.0lf) {
                        phi_2041_ = -(_e501.member_1[1][1]);
                    } else {
                        phi_2041_ = _e501.member_1[1][1];
                    }
                    let _e1129 = phi_2041_;
                    if (_e1124 > _e1129) {
                        phi_2046_ = _e1124;
                    } else {
                        phi_2046_ = _e1129;
                    }
                    let _e1132 = phi_2046_;
                    if (_e501.member_1[1][2] < 0.0lf) {
                        phi_2053_ = -(_e501.member_1[1][2]);
                    } else {
                        phi_2053_ = _e501.member_1[1][2];
                    }
                    let _e1137 = phi_2053_;
                    if (_e1132 > _e1137) {
                        phi_2058_ = _e1132;
                    } else {
                        phi_2058_ = _e1137;
                    }
                    let _e1140 = phi_2058_;
                    if (_e1117 > _e1140) {
                        phi_2063_ = _e1117;
                    } else {
                        phi_2063_ = _e1140;
                    }
                    let _e1143 = phi_2063_;
                    if (_e501.member_2[0][0] < 0.0lf) {
                        phi_2073_ = -(_e501.member_2[0][0]);
                    } else {
                        phi_2073_ = _e501.member_2[0][0];
                    }
                    let _e1152 = phi_2073_;
                    if (_e501.member_2[0][1] < 0.0lf) {
                        phi_2080_ = -(_e501.member_2[0][1]);
                    } else {
                        phi_2080_ = _e501.member_2[0][1];
                    }
                    let _e1157 = phi_2080_;
                    if (_e1152 > _e1157) {
                        phi_2085_ = _e1152;
                    } else {
                        phi_2085_ = _e1157;
                    }
                    let _e1160 = phi_2085_;
                    if (_e501.member_2[0][2] < 0.0lf) {
                        phi_2092_ = -(_e501.member_2[0][2]);
                    } else {
                        phi_2092_ = _e501.member_2[0][2];
                    }
                    let _e1165 = phi_2092_;
                    if (_e1160 > _e1165) {
                        phi_2097_ = _e1160;
                    } else {
                        phi_2097_ = _e1165;
                    }
                    let _e1168 = phi_2097_;
                    if (_e501.member_2[1][0] < 0.0lf) {
                        phi_2105_ = -(_e501.member_2[1][0]);
                    } else {
                        phi_2105_ = _e501.member_2[1][0];
                    }
                    let _e1175 = phi_2105_;
                    if (_e501.member_2[1][1] < 0.0lf) {
                        phi_2112_ = -(_e501.member_2[1][1]);
                    } else {
                        phi_2112_ = _e501.member_2[1][1];
                    }
                    let _e1180 = phi_2112_;
                    if (_e1175 > _e1180) {
                        phi_2117_ = _e1175;
                    } else {
                        phi_2117_ = _e1180;
                    }
                    let _e1183 = phi_2117_;
                    if (_e501.member_2[1][2] < 0.0lf) {
                        phi_2124_ = -(_e501.member_2[1][2]);
                    } else {
                        phi_2124_ = _e501.member_2[1][2];
                    }
                    let _e1188 = phi_2124_;
                    if (_e1183 > _e1188) {
                        phi_2129_ = _e1183;
                    } else {
                        phi_2129_ = _e1188;
                    }
                    let _e1191 = phi_2129_;
                    if (_e1168 > _e1191) {
                        phi_2134_ = _e1168;
                    } else {
                        phi_2134_ = _e1191;
                    }
                    let _e1194 = phi_2134_;
                    let _e1205 = (((((_e1092 + _e501.member_3) + (_e1143 + _e501.member_3)) + (_e1194 + _e501.member_3)) * (1.1102230246251565e-16lf * f64(32f))) + (_e501.member_3 * f64(8f)));
                    if _e1031 {
                        if (_e1037 < 0.0lf) {
                            phi_2154_ = -(_e1037);
                        } else {
                            phi_2154_ = _e1037;
                        }
                        let _e1209 = phi_2154_;
                        if (_e1038 < 0.0lf) {
                            phi_2160_ = -(_e1038);
                        } else {
                            phi_2160_ = _e1038;
                        }
                        let _e1213 = phi_2160_;
                        if (_e1209 > _e1213) {
                            phi_2165_ = _e1209;
                        } else {
                            phi_2165_ = _e1213;
                        }
                        let _e1216 = phi_2165_;
                        if (_e1039 < 0.0lf) {
                            phi_2171_ = -(_e1039);
                        } else {
                            phi_2171_ = _e1039;
                        }
                        let _e1220 = phi_2171_;
                        if (_e1216 > _e1220) {
                            phi_2176_ = _e1216;
                        } else {
                            phi_2176_ = _e1220;
                        }
                        let _e1223 = phi_2176_;
                        let _e1224 = function_9(_e1223);
                        let _e1225 = (_e1037 * _e1224);
                        let _e1226 = (_e1038 * _e1224);
                        let _e1227 = (_e1039 * _e1224);
                        let _e1233 = (((_e1225 * _e1225) + (_e1226 * _e1226)) + (_e1227 * _e1227));
                        if (_e1233 <= 2.2250738585072014e-308lf) {
                            if (_e1233 > 0.0lf) {
                                phi_2200_ = (1.464336215552873e-154lf * 2.0lf);
                            } else {
                                phi_2200_ = 0.0lf;
                            }
                            let _e1285 = phi_2200_;
                            phi_2264_ = _e1285;
                        } else {
                            phi_2207_ = type_16(0i, 5i);
                            phi_2210_ = bitcast<f64>(((bitcast<u64>(_e1233) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1240 = phi_2207_;
                                let _e1242 = phi_2210_;
                                local_5 = _e1242;
                                if (_e1240.member < _e1240.member_1) {
                                    let _e1249 = (_e1240.member + 1i);
                                    if ((false == (_e1249 > _e1240.member)) != false) {
                                        phi_2231_ = true;
                                    } else {
                                        phi_2231_ = false;
                                    }
                                    let _e1254 = phi_2231_;
                                    if _e1254 {
                                        phi_2237_ = type_17(0u, type_17().member_1);
                                    } else {
                                        phi_2237_ = type_17(1u, _e1249);
                                    }
                                    let _e1259 = phi_2237_;
                                    phi_2208_ = type_16(_e1259.member_1, _e1240.member_1);
                                    phi_2251_ = type_17(1u, _e1240.member);
                                } else {
                                    phi_2208_ = _e1240;
                                    phi_2251_ = type_17(0u, type_17().member_1);
                                }
                                let _e1265 = phi_2208_;
                                let _e1267 = phi_2251_;
                                let _e1270 = (bitcast<i32>(_e1267.member) != 0i);
                                if _e1270 {
                                    phi_2211_ = (0.5lf * (_e1242 + (_e1233 / _e1242)));
                                } else {
                                    phi_2211_ = f64();
                                }
                                let _e1275 = phi_2211_;
                                continue;
                                continuing {
                                    phi_2207_ = _e1265;
                                    phi_2210_ = _e1275;
                                    break if !(_e1270);
                                }
                            }
                            let _e1280 = local_5;
                            phi_2264_ = (_e1280 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1287 = phi_2264_;
                        let _e1288 = (f64(1f) / _e1287);
                        let _e1289 = (_e1225 * _e1288);
                        let _e1290 = (_e1226 * _e1288);
                        let _e1291 = (_e1227 * _e1288);
                        let _e1300 = ((f64(3f) - (((_e1289 * _e1289) + (_e1290 * _e1290)) + (_e1291 * _e1291))) * f64(0.5f));
                        let _e1301 = (_e1289 * _e1300);
                        let _e1302 = (_e1290 * _e1300);
                        let _e1303 = (_e1291 * _e1300);
                        let _e1309 = (((_e995 * _e1301) + (_e996 * _e1302)) + (_e997 * _e1303));
                        if (_e995 < 0.0lf) {
                            phi_2292_ = -(_e995);
                        } else {
                            phi_2292_ = _e995;
                        }
                        let _e1313 = phi_2292_;
                        if (_e996 < 0.0lf) {
                            phi_2298_ = -(_e996);
                        } else {
                            phi_2298_ = _e996;
                        }
                        let _e1317 = phi_2298_;
                        if (_e997 < 0.0lf) {
                            phi_2305_ = -(_e997);
                        } else {
                            phi_2305_ = _e997;
                        }
                        let _e1322 = phi_2305_;
                        let _e1325 = local.member_5;
                        let _e1327 = local.member_4;
                        if (_e1309 < 0.0lf) {
                            phi_2319_ = -(_e1309);
                        } else {
                            phi_2319_ = _e1309;
                        }
                        let _e1334 = phi_2319_;
                        if (_e1334 > (_e1205 + (((_e1313 + _e1317) + _e1322) * (_e1325 / _e1327)))) {
                            if (_e1309 < _e999) {
                                phi_2333_ = array<f64, 3>(_e1301, _e1302, _e1303);
                            } else {
                                let _e1337 = -(_e1000);
                                phi_2333_ = array<f64, 3>((_e1301 * _e1337), (_e1302 * _e1337), (_e1303 * _e1337));
                            }
                            let _e1343 = phi_2333_;
                            phi_2334_ = _e1343;
                            phi_2335_ = false;
                        } else {
                            phi_2334_ = array<f64, 3>();
                            phi_2335_ = true;
                        }
                        let _e1345 = phi_2334_;
                        let _e1347 = phi_2335_;
                        phi_2336_ = _e1345;
                        phi_2337_ = _e1347;
                    } else {
                        phi_2336_ = array<f64, 3>();
                        phi_2337_ = true;
                    }
                    let _e1349 = phi_2336_;
                    let _e1351 = phi_2337_;
                    if _e1351 {
                        if _e1031 {
                            if _e1028 {
                                phi_2347_ = false;
                            } else {
                                phi_2347_ = true;
                            }
                            let _e1353 = phi_2347_;
                            phi_2348_ = _e1353;
                        } else {
                            phi_2348_ = true;
                        }
                        let _e1355 = phi_2348_;
                        if _e1355 {
                            if _e1011 {
                                if _e1006 {
                                    if _e1010 {
                                        let _e1357 = local.member_2;
                                        let _e1362 = local.member_1;
                                        phi_2383_ = array<f64, 3>((_e1357[0] - _e1362[0]), (_e1357[1] - _e1362[1]), (_e1357[2] - _e1362[2]));
                                        phi_2384_ = false;
                                    } else {
                                        phi_2383_ = array<f64, 3>();
                                        phi_2384_ = true;
                                    }
                                    let _e1371 = phi_2383_;
                                    let _e1373 = phi_2384_;
                                    phi_2385_ = _e1371;
                                    phi_2386_ = _e1373;
                                } else {
                                    phi_2385_ = array<f64, 3>();
                                    phi_2386_ = true;
                                }
                                let _e1375 = phi_2385_;
                                let _e1377 = phi_2386_;
                                phi_2387_ = _e1375;
                                phi_2388_ = _e1377;
                            } else {
                                phi_2387_ = array<f64, 3>();
                                phi_2388_ = true;
                            }
                            let _e1379 = phi_2387_;
                            let _e1381 = phi_2388_;
                            if _e1381 {
                                if _e1006 {
                                    if _e1010 {
                                        let _e1383 = local.member_2;
                                        if (_e1383[0] < 0.0lf) {
                                            phi_2410_ = -(_e1383[0]);
                                        } else {
                                            phi_2410_ = _e1383[0];
                                        }
                                        let _e1390 = phi_2410_;
                                        if (_e1383[1] < 0.0lf) {
                                            phi_2417_ = -(_e1383[1]);
                                        } else {
                                            phi_2417_ = _e1383[1];
                                        }
                                        let _e1394 = phi_2417_;
                                        if (_e1390 > _e1394) {
                                            phi_2422_ = _e1390;
                                        } else {
                                            phi_2422_ = _e1394;
                                        }
                                        let _e1397 = phi_2422_;
                                        if (_e1383[2] < 0.0lf) {
                                            phi_2429_ = -(_e1383[2]);
                                        } else {
                                            phi_2429_ = _e1383[2];
                                        }
                                        let _e1401 = phi_2429_;
                                        if (_e1397 > _e1401) {
                                            phi_2434_ = _e1397;
                                        } else {
                                            phi_2434_ = _e1401;
                                        }
                                        let _e1404 = phi_2434_;
                                        let _e1406 = local.member_1;
                                        if (_e1406[0] < 0.0lf) {
                                            phi_2447_ = -(_e1406[0]);
                                        } else {
                                            phi_2447_ = _e1406[0];
                                        }
                                        let _e1413 = phi_2447_;
                                        if (_e1406[1] < 0.0lf) {
                                            phi_2454_ = -(_e1406[1]);
                                        } else {
                                            phi_2454_ = _e1406[1];
                                        }
                                        let _e1417 = phi_2454_;
                                        if (_e1413 > _e1417) {
                                            phi_2459_ = _e1413;
                                        } else {
                                            phi_2459_ = _e1417;
                                        }
                                        let _e1420 = phi_2459_;
                                        if (_e1406[2] < 0.0lf) {
                                            phi_2466_ = -(_e1406[2]);
                                        } else {
                                            phi_2466_ = _e1406[2];
                                        }
                                        let _e1424 = phi_2466_;
                                        if (_e1420 > _e1424) {
                                            phi_2471_ = _e1420;
                                        } else {
                                            phi_2471_ = _e1424;
                                        }
                                        let _e1427 = phi_2471_;
                                        if (_e1404 > _e1427) {
                                            phi_2476_ = false;
                                        } else {
                                            phi_2476_ = true;
                                        }
                                        let _e1430 = phi_2476_;
                                        phi_2477_ = _e1430;
                                    } else {
                                        phi_2477_ = true;
                                    }
                                    let _e1432 = phi_2477_;
                                    if _e1432 {
                                        let _e1434 = local.member_1;
                                        phi_2487_ = array<f64, 3>(_e1434[0], _e1434[1], _e1434[2]);
                                        phi_2488_ = false;
                                    } else {
                                        phi_2487_ = array<f64, 3>();
                                        phi_2488_ = true;
                                    }
                                    let _e1440 = phi_2487_;
                                    let _e1442 = phi_2488_;
                                    phi_2489_ = _e1440;
                                    phi_2490_ = _e1442;
                                } else {
                                    phi_2489_ = array<f64, 3>();
                                    phi_2490_ = true;
                                }
                                let _e1444 = phi_2489_;
                                let _e1446 = phi_2490_;
                                if _e1446 {
                                    if _e1010 {
                                        let _e1449 = local.member_2;
                                        phi_2504_ = array<f64, 3>(_e1449[0], _e1449[1], _e1449[2]);
                                    } else {
                                        phi_2504_ = array<f64, 3>(_e999, _e999, _e999);
                                    }
                                    let _e1455 = phi_2504_;
                                    phi_2505_ = _e1455;
                                } else {
                                    phi_2505_ = _e1444;
                                }
                                let _e1457 = phi_2505_;
                                phi_2506_ = _e1457;
                            } else {
                                phi_2506_ = _e1379;
                            }
                            let _e1459 = phi_2506_;
                            if (_e1459[0] < 0.0lf) {
                                phi_2513_ = -(_e1459[0]);
                            } else {
                                phi_2513_ = _e1459[0];
                            }
                            let _e1464 = phi_2513_;
                            if (_e1459[1] < 0.0lf) {
                                phi_2520_ = -(_e1459[1]);
                            } else {
                                phi_2520_ = _e1459[1];
                            }
                            let _e1469 = phi_2520_;
                            if (_e1464 > _e1469) {
                                phi_2525_ = _e1464;
                            } else {
                                phi_2525_ = _e1469;
                            }
                            let _e1472 = phi_2525_;
                            if (_e1459[2] < 0.0lf) {
                                phi_2532_ = -(_e1459[2]);
                            } else {
                                phi_2532_ = _e1459[2];
                            }
                            let _e1477 = phi_2532_;
                            if (_e1472 > _e1477) {
                                phi_2537_ = _e1472;
                            } else {
                                phi_2537_ = _e1477;
                            }
                            let _e1480 = phi_2537_;
                            let _e1482 = local.member_6;
                            if (_e1480 > _e1482) {
                                phi_2545_ = _e1459;
                            } else {
                                phi_2545_ = array<f64, 3>(_e999, _e999, _e999);
                            }
                            let _e1486 = phi_2545_;
                            if (_e1486[0] < 0.0lf) {
                                phi_2552_ = -(_e1486[0]);
                            } else {
                                phi_2552_ = _e1486[0];
                            }
                            let _e1491 = phi_2552_;
                            if (_e1486[1] < 0.0lf) {
                                phi_2559_ = -(_e1486[1]);
                            } else {
                                phi_2559_ = _e1486[1];
                            }
                            let _e1496 = phi_2559_;
                            if (_e1491 > _e1496) {
                                phi_2564_ = _e1491;
                            } else {
                                phi_2564_ = _e1496;
                            }
                            let _e1499 = phi_2564_;
                            if (_e1486[2] < 0.0lf) {
                                phi_2571_ = -(_e1486[2]);
                            } else {
                                phi_2571_ = _e1486[2];
                            }
                            let _e1504 = phi_2571_;
                            if (_e1499 > _e1504) {
                                phi_2576_ = _e1499;
                            } else {
                                phi_2576_ = _e1504;
                            }
                            let _e1507 = phi_2576_;
                            if (_e1507 > f64(0f)) {
                                if (_e1486[0] < 0.0lf) {
                                    phi_2588_ = -(_e1486[0]);
                                } else {
                                    phi_2588_ = _e1486[0];
                                }
                                let _e1514 = phi_2588_;
                                if (_e1486[1] < 0.0lf) {
                                    phi_2595_ = -(_e1486[1]);
                                } else {
                                    phi_2595_ = _e1486[1];
                                }
                                let _e1519 = phi_2595_;
                                if (_e1514 > _e1519) {
                                    phi_2600_ = _e1514;
                                } else {
                                    phi_2600_ = _e1519;
                                }
                                let _e1522 = phi_2600_;
                                if (_e1486[2] < 0.0lf) {
                                    phi_2607_ = -(_e1486[2]);
                                } else {
                                    phi_2607_ = _e1486[2];
                                }
                                let _e1527 = phi_2607_;
                                if (_e1522 > _e1527) {
                                    phi_2612_ = _e1522;
                                } else {
                                    phi_2612_ = _e1527;
                                }
                                let _e1530 = phi_2612_;
                                let _e1531 = function_9(_e1530);
                                let _e1533 = (_e1486[0] * _e1531);
                                let _e1535 = (_e1486[1] * _e1531);
                                let _e1537 = (_e1486[2] * _e1531);
                                let _e1543 = (((_e1533 * _e1533) + (_e1535 * _e1535)) + (_e1537 * _e1537));
                                if (_e1543 <= 2.2250738585072014e-308lf) {
                                    if (_e1543 > 0.0lf) {
                                        phi_2639_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_2639_ = 0.0lf;
                                    }
                                    let _e1595 = phi_2639_;
                                    phi_2703_ = _e1595;
                                } else {
                                    phi_2646_ = type_16(0i, 5i);
                                    phi_2649_ = bitcast<f64>(((bitcast<u64>(_e1543) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1550 = phi_2646_;
                                        let _e1552 = phi_2649_;
                                        local_6 = _e1552;
                                        if (_e1550.member < _e1550.member_1) {
                                            let _e1559 = (_e1550.member + 1i);
                                            if ((false == (_e1559 > _e1550.member)) != false) {
                                                phi_2670_ = true;
                                            } else {
                                                phi_2670_ = false;
                                            }
                                            let _e1564 = phi_2670_;
                                            if _e1564 {
                                                phi_2676_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_2676_ = type_17(1u, _e1559);
                                            }
                                            let _e1569 = phi_2676_;
                                            phi_2647_ = type_16(_e1569.member_1, _e1550.member_1);
                                            phi_2690_ = type_17(1u, _e1550.member);
                                        } else {
                                            phi_2647_ = _e1550;
                                            phi_2690_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1575 = phi_2647_;
                                        let _e1577 = phi_2690_;
                                        let _e1580 = (bitcast<i32>(_e1577.member) != 0i);
                                        if _e1580 {
                                            phi_2650_ = (0.5lf * (_e1552 + (_e1543 / _e1552)));
                                        } else {
                                            phi_2650_ = f64();
                                        }
                                        let _e1585 = phi_2650_;
                                        continue;
                                        continuing {
                                            phi_2646_ = _e1575;
                                            phi_2649_ = _e1585;
                                            break if !(_e1580);
                                        }
                                    }
                                    let _e1590 = local_6;
                                    phi_2703_ = (_e1590 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1597 = phi_2703_;
                                let _e1598 = (f64(1f) / _e1597);
                                let _e1599 = (_e1533 * _e1598);
                                let _e1600 = (_e1535 * _e1598);
                                let _e1601 = (_e1537 * _e1598);
                                let _e1610 = ((f64(3f) - (((_e1599 * _e1599) + (_e1600 * _e1600)) + (_e1601 * _e1601))) * f64(0.5f));
                                let _e1611 = (_e1599 * _e1610);
                                let _e1612 = (_e1600 * _e1610);
                                let _e1613 = (_e1601 * _e1610);
                                let _e1618 = (((_e995 * _e1611) + (_e996 * _e1612)) + (_e997 * _e1613));
                                phi_2732_ = array<f64, 3>((_e995 - (_e1611 * _e1618)), (_e996 - (_e1612 * _e1618)), (_e997 - (_e1613 * _e1618)));
                            } else {
                                phi_2732_ = array<f64, 3>(_e995, _e996, _e997);
                            }
                            let _e1627 = phi_2732_;
                            if (_e1627[0] < 0.0lf) {
                                phi_2739_ = -(_e1627[0]);
                            } else {
                                phi_2739_ = _e1627[0];
                            }
                            let _e1632 = phi_2739_;
                            if (_e1627[1] < 0.0lf) {
                                phi_2746_ = -(_e1627[1]);
                            } else {
                                phi_2746_ = _e1627[1];
                            }
                            let _e1637 = phi_2746_;
                            if (_e1627[2] < 0.0lf) {
                                phi_2754_ = -(_e1627[2]);
                            } else {
                                phi_2754_ = _e1627[2];
                            }
                            let _e1643 = phi_2754_;
                            if (((_e1632 + _e1637) + _e1643) > _e1205) {
                                let _e1646 = -(_e1000);
                                let _e1648 = (_e1627[0] * _e1646);
                                let _e1650 = (_e1627[1] * _e1646);
                                let _e1652 = (_e1627[2] * _e1646);
                                if (_e1648 < 0.0lf) {
                                    phi_2772_ = -(_e1648);
                                } else {
                                    phi_2772_ = _e1648;
                                }
                                let _e1656 = phi_2772_;
                                if (_e1650 < 0.0lf) {
                                    phi_2778_ = -(_e1650);
                                } else {
                                    phi_2778_ = _e1650;
                                }
                                let _e1660 = phi_2778_;
                                if (_e1656 > _e1660) {
                                    phi_2783_ = _e1656;
                                } else {
                                    phi_2783_ = _e1660;
                                }
                                let _e1663 = phi_2783_;
                                if (_e1652 < 0.0lf) {
                                    phi_2789_ = -(_e1652);
                                } else {
                                    phi_2789_ = _e1652;
                                }
                                let _e1667 = phi_2789_;
                                if (_e1663 > _e1667) {
                                    phi_2794_ = _e1663;
                                } else {
                                    phi_2794_ = _e1667;
                                }
                                let _e1670 = phi_2794_;
                                let _e1671 = function_9(_e1670);
                                let _e1672 = (_e1648 * _e1671);
                                let _e1673 = (_e1650 * _e1671);
                                let _e1674 = (_e1652 * _e1671);
                                let _e1680 = (((_e1672 * _e1672) + (_e1673 * _e1673)) + (_e1674 * _e1674));
                                if (_e1680 <= 2.2250738585072014e-308lf) {
                                    if (_e1680 > 0.0lf) {
                                        phi_2818_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_2818_ = 0.0lf;
                                    }
                                    let _e1732 = phi_2818_;
                                    phi_2882_ = _e1732;
                                } else {
                                    phi_2825_ = type_16(0i, 5i);
                                    phi_2828_ = bitcast<f64>(((bitcast<u64>(_e1680) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1687 = phi_2825_;
                                        let _e1689 = phi_2828_;
                                        local_7 = _e1689;
                                        if (_e1687.member < _e1687.member_1) {
                                            let _e1696 = (_e1687.member + 1i);
                                            if ((false == (_e1696 > _e1687.member)) != false) {
                                                phi_2849_ = true;
                                            } else {
                                                phi_2849_ = false;
                                            }
                                            let _e1701 = phi_2849_;
                                            if _e1701 {
                                                phi_2855_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_2855_ = type_17(1u, _e1696);
                                            }
                                            let _e1706 = phi_2855_;
                                            phi_2826_ = type_16(_e1706.member_1, _e1687.member_1);
                                            phi_2869_ = type_17(1u, _e1687.member);
                                        } else {
                                            phi_2826_ = _e1687;
                                            phi_2869_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1712 = phi_2826_;
                                        let _e1714 = phi_2869_;
                                        let _e1717 = (bitcast<i32>(_e1714.member) != 0i);
                                        if _e1717 {
                                            phi_2829_ = (0.5lf * (_e1689 + (_e1680 / _e1689)));
                                        } else {
                                            phi_2829_ = f64();
                                        }
                                        let _e1722 = phi_2829_;
                                        continue;
                                        continuing {
                                            phi_2825_ = _e1712;
                                            phi_2828_ = _e1722;
                                            break if !(_e1717);
                                        }
                                    }
                                    let _e1727 = local_7;
                                    phi_2882_ = (_e1727 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1734 = phi_2882_;
                                let _e1735 = (f64(1f) / _e1734);
                                let _e1736 = (_e1672 * _e1735);
                                let _e1737 = (_e1673 * _e1735);
                                let _e1738 = (_e1674 * _e1735);
                                let _e1747 = ((f64(3f) - (((_e1736 * _e1736) + (_e1737 * _e1737)) + (_e1738 * _e1738))) * f64(0.5f));
                                phi_2900_ = array<f64, 3>((_e1736 * _e1747), (_e1737 * _e1747), (_e1738 * _e1747));
                                phi_2901_ = false;
                            } else {
                                phi_2900_ = array<f64, 3>();
                                phi_2901_ = true;
                            }
                            let _e1753 = phi_2900_;
                            let _e1755 = phi_2901_;
                            phi_2902_ = _e1753;
                            phi_2903_ = _e1755;
                        } else {
                            phi_2902_ = array<f64, 3>();
                            phi_2903_ = true;
                        }
                        let _e1757 = phi_2902_;
                        let _e1759 = phi_2903_;
                        if _e1759 {
                            if _e1031 {
                                if (_e1037 < 0.0lf) {
                                    phi_2915_ = -(_e1037);
                                } else {
                                    phi_2915_ = _e1037;
                                }
                                let _e2092 = phi_2915_;
                                if (_e1038 < 0.0lf) {
                                    phi_2921_ = -(_e1038);
                                } else {
                                    phi_2921_ = _e1038;
                                }
                                let _e2096 = phi_2921_;
                                if (_e2092 > _e2096) {
                                    phi_2926_ = _e2092;
                                } else {
                                    phi_2926_ = _e2096;
                                }
                                let _e2099 = phi_2926_;
                                if (_e1039 < 0.0lf) {
                                    phi_2932_ = -(_e1039);
                                } else {
                                    phi_2932_ = _e1039;
                                }
                                let _e2103 = phi_2932_;
                                if (_e2099 > _e2103) {
                                    phi_2937_ = _e2099;
                                } else {
                                    phi_2937_ = _e2103;
                                }
                                let _e2106 = phi_2937_;
                                let _e2107 = function_9(_e2106);
                                let _e2108 = (_e1037 * _e2107);
                                let _e2109 = (_e1038 * _e2107);
                                let _e2110 = (_e1039 * _e2107);
                                let _e2116 = (((_e2108 * _e2108) + (_e2109 * _e2109)) + (_e2110 * _e2110));
                                if (_e2116 <= 2.2250738585072014e-308lf) {
                                    if (_e2116 > 0.0lf) {
                                        phi_2961_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_2961_ = 0.0lf;
                                    }
                                    let _e2168 = phi_2961_;
                                    phi_3025_ = _e2168;
                                } else {
                                    phi_2968_ = type_16(0i, 5i);
                                    phi_2971_ = bitcast<f64>(((bitcast<u64>(_e2116) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2123 = phi_2968_;
                                        let _e2125 = phi_2971_;
                                        local_10 = _e2125;
                                        if (_e2123.member < _e2123.member_1) {
                                            let _e2132 = (_e2123.member + 1i);
                                            if ((false == (_e2132 > _e2123.member)) != false) {
                                                phi_2992_ = true;
                                            } else {
                                                phi_2992_ = false;
                                            }
                                            let _e2137 = phi_2992_;
                                            if _e2137 {
                                                phi_2998_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_2998_ = type_17(1u, _e2132);
                                            }
                                            let _e2142 = phi_2998_;
                                            phi_2969_ = type_16(_e2142.member_1, _e2123.member_1);
                                            phi_3012_ = type_17(1u, _e2123.member);
                                        } else {
                                            phi_2969_ = _e2123;
                                            phi_3012_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2148 = phi_2969_;
                                        let _e2150 = phi_3012_;
                                        let _e2153 = (bitcast<i32>(_e2150.member) != 0i);
                                        if _e2153 {
                                            phi_2972_ = (0.5lf * (_e2125 + (_e2116 / _e2125)));
                                        } else {
                                            phi_2972_ = f64();
                                        }
                                        let _e2158 = phi_2972_;
                                        continue;
                                        continuing {
                                            phi_2968_ = _e2148;
                                            phi_2971_ = _e2158;
                                            break if !(_e2153);
                                        }
                                    }
                                    let _e2163 = local_10;
                                    phi_3025_ = (_e2163 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e2170 = phi_3025_;
                                let _e2171 = (f64(1f) / _e2170);
                                let _e2172 = (_e2108 * _e2171);
                                let _e2173 = (_e2109 * _e2171);
                                let _e2174 = (_e2110 * _e2171);
                                let _e2183 = ((f64(3f) - (((_e2172 * _e2172) + (_e2173 * _e2173)) + (_e2174 * _e2174))) * f64(0.5f));
                                phi_3492_ = array<f64, 3>((_e2172 * _e2183), (_e2173 * _e2183), (_e2174 * _e2183));
                            } else {
                                let _e1761 = local.member_1;
                                let _e1767 = local.member_2;
                                let _e1772 = f64(0f);
                                let _e1773 = f64(1f);
                                if (_e1767[0] < 0.0lf) {
                                    phi_3063_ = -(_e1767[0]);
                                } else {
                                    phi_3063_ = _e1767[0];
                                }
                                let _e1777 = phi_3063_;
                                if (_e1767[1] < 0.0lf) {
                                    phi_3070_ = -(_e1767[1]);
                                } else {
                                    phi_3070_ = _e1767[1];
                                }
                                let _e1781 = phi_3070_;
                                if (_e1777 > _e1781) {
                                    phi_3075_ = _e1777;
                                } else {
                                    phi_3075_ = _e1781;
                                }
                                let _e1784 = phi_3075_;
                                if (_e1767[2] < 0.0lf) {
                                    phi_3082_ = -(_e1767[2]);
                                } else {
                                    phi_3082_ = _e1767[2];
                                }
                                let _e1788 = phi_3082_;
                                if (_e1784 > _e1788) {
                                    phi_3087_ = _e1784;
                                } else {
                                    phi_3087_ = _e1788;
                                }
                                let _e1791 = phi_3087_;
                                if (_e1761[0] < 0.0lf) {
                                    phi_3094_ = -(_e1761[0]);
                                } else {
                                    phi_3094_ = _e1761[0];
                                }
                                let _e1795 = phi_3094_;
                                if (_e1761[1] < 0.0lf) {
                                    phi_3101_ = -(_e1761[1]);
                                } else {
                                    phi_3101_ = _e1761[1];
                                }
                                let _e1799 = phi_3101_;
                                if (_e1795 > _e1799) {
                                    phi_3106_ = _e1795;
                                } else {
                                    phi_3106_ = _e1799;
                                }
                                let _e1802 = phi_3106_;
                                if (_e1761[2] < 0.0lf) {
                                    phi_3113_ = -(_e1761[2]);
                                } else {
                                    phi_3113_ = _e1761[2];
                                }
                                let _e1806 = phi_3113_;
                                if (_e1802 > _e1806) {
                                    phi_3118_ = _e1802;
                                } else {
                                    phi_3118_ = _e1806;
                                }
                                let _e1809 = phi_3118_;
                                if (_e1791 > _e1809) {
                                    phi_3123_ = array<f64, 3>(_e1767[0], _e1767[1], _e1767[2]);
                                } else {
                                    phi_3123_ = array<f64, 3>(_e1761[0], _e1761[1], _e1761[2]);
                                }
                                let _e1812 = phi_3123_;
                                if (_e1812[0] < 0.0lf) {
                                    phi_3130_ = -(_e1812[0]);
                                } else {
                                    phi_3130_ = _e1812[0];
                                }
                                let _e1817 = phi_3130_;
                                if (_e1812[1] < 0.0lf) {
                                    phi_3137_ = -(_e1812[1]);
                                } else {
                                    phi_3137_ = _e1812[1];
                                }
                                let _e1822 = phi_3137_;
                                if (_e1817 > _e1822) {
                                    phi_3142_ = _e1817;
                                } else {
                                    phi_3142_ = _e1822;
                                }
                                let _e1825 = phi_3142_;
                                if (_e1812[2] < 0.0lf) {
                                    phi_3149_ = -(_e1812[2]);
                                } else {
                                    phi_3149_ = _e1812[2];
                                }
                                let _e1830 = phi_3149_;
                                if (_e1825 > _e1830) {
                                    phi_3154_ = _e1825;
                                } else {
                                    phi_3154_ = _e1830;
                                }
                                let _e1833 = phi_3154_;
                                if (_e1833 > _e1772) {
                                    if (_e1812[0] < 0.0lf) {
                                        phi_3165_ = -(_e1812[0]);
                                    } else {
                                        phi_3165_ = _e1812[0];
                                    }
                                    let _e1840 = phi_3165_;
                                    if (_e1812[1] < 0.0lf) {
                                        phi_3172_ = -(_e1812[1]);
                                    } else {
                                        phi_3172_ = _e1812[1];
                                    }
                                    let _e1845 = phi_3172_;
                                    if (_e1812[2] < 0.0lf) {
                                        phi_3179_ = -(_e1812[2]);
                                    } else {
                                        phi_3179_ = _e1812[2];
                                    }
                                    let _e1850 = phi_3179_;
                                    if (_e1840 <= _e1845) {
                                        if (_e1840 <= _e1850) {
                                            phi_3189_ = array<f64, 3>(_e1773, _e1772, _e1772);
                                            phi_3190_ = false;
                                        } else {
                                            phi_3189_ = array<f64, 3>();
                                            phi_3190_ = true;
                                        }
                                        let _e1855 = phi_3189_;
                                        let _e1857 = phi_3190_;
                                        phi_3191_ = _e1855;
                                        phi_3192_ = _e1857;
                                    } else {
                                        phi_3191_ = array<f64, 3>();
                                        phi_3192_ = true;
                                    }
                                    let _e1859 = phi_3191_;
                                    let _e1861 = phi_3192_;
                                    if _e1861 {
                                        if (_e1845 <= _e1850) {
                                            phi_3202_ = array<f64, 3>(_e1772, _e1773, _e1772);
                                        } else {
                                            phi_3202_ = array<f64, 3>(_e1772, _e1772, _e1773);
                                        }
                                        let _e1866 = phi_3202_;
                                        phi_3203_ = _e1866;
                                    } else {
                                        phi_3203_ = _e1859;
                                    }
                                    let _e1868 = phi_3203_;
                                    if (_e1812[0] < 0.0lf) {
                                        phi_3210_ = -(_e1812[0]);
                                    } else {
                                        phi_3210_ = _e1812[0];
                                    }
                                    let _e1873 = phi_3210_;
                                    if (_e1812[1] < 0.0lf) {
                                        phi_3217_ = -(_e1812[1]);
                                    } else {
                                        phi_3217_ = _e1812[1];
                                    }
                                    let _e1878 = phi_3217_;
                                    if (_e1873 > _e1878) {
                                        phi_3222_ = _e1873;
                                    } else {
                                        phi_3222_ = _e1878;
                                    }
                                    let _e1881 = phi_3222_;
                                    if (_e1812[2] < 0.0lf) {
                                        phi_3229_ = -(_e1812[2]);
                                    } else {
                                        phi_3229_ = _e1812[2];
                                    }
                                    let _e1886 = phi_3229_;
                                    if (_e1881 > _e1886) {
                                        phi_3234_ = _e1881;
                                    } else {
                                        phi_3234_ = _e1886;
                                    }
                                    let _e1889 = phi_3234_;
                                    let _e1890 = function_9(_e1889);
                                    let _e1892 = (_e1812[0] * _e1890);
                                    let _e1894 = (_e1812[1] * _e1890);
                                    let _e1896 = (_e1812[2] * _e1890);
                                    let _e1902 = (((_e1892 * _e1892) + (_e1894 * _e1894)) + (_e1896 * _e1896));
                                    if (_e1902 <= 2.2250738585072014e-308lf) {
                                        if (_e1902 > 0.0lf) {
                                            phi_3261_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3261_ = 0.0lf;
                                        }
                                        let _e1954 = phi_3261_;
                                        phi_3325_ = _e1954;
                                    } else {
                                        phi_3268_ = type_16(0i, 5i);
                                        phi_3271_ = bitcast<f64>(((bitcast<u64>(_e1902) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1909 = phi_3268_;
                                            let _e1911 = phi_3271_;
                                            local_8 = _e1911;
                                            if (_e1909.member < _e1909.member_1) {
                                                let _e1918 = (_e1909.member + 1i);
                                                if ((false == (_e1918 > _e1909.member)) != false) {
                                                    phi_3292_ = true;
                                                } else {
                                                    phi_3292_ = false;
                                                }
                                                let _e1923 = phi_3292_;
                                                if _e1923 {
                                                    phi_3298_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_3298_ = type_17(1u, _e1918);
                                                }
                                                let _e1928 = phi_3298_;
                                                phi_3269_ = type_16(_e1928.member_1, _e1909.member_1);
                                                phi_3312_ = type_17(1u, _e1909.member);
                                            } else {
                                                phi_3269_ = _e1909;
                                                phi_3312_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e1934 = phi_3269_;
                                            let _e1936 = phi_3312_;
                                            let _e1939 = (bitcast<i32>(_e1936.member) != 0i);
                                            if _e1939 {
                                                phi_3272_ = (0.5lf * (_e1911 + (_e1902 / _e1911)));
                                            } else {
                                                phi_3272_ = f64();
                                            }
                                            let _e1944 = phi_3272_;
                                            continue;
                                            continuing {
                                                phi_3268_ = _e1934;
                                                phi_3271_ = _e1944;
                                                break if !(_e1939);
                                            }
                                        }
                                        let _e1949 = local_8;
                                        phi_3325_ = (_e1949 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1956 = phi_3325_;
                                    let _e1957 = (f64(1f) / _e1956);
                                    let _e1958 = (_e1892 * _e1957);
                                    let _e1959 = (_e1894 * _e1957);
                                    let _e1960 = (_e1896 * _e1957);
                                    let _e1969 = ((f64(3f) - (((_e1958 * _e1958) + (_e1959 * _e1959)) + (_e1960 * _e1960))) * f64(0.5f));
                                    let _e1970 = (_e1958 * _e1969);
                                    let _e1971 = (_e1959 * _e1969);
                                    let _e1972 = (_e1960 * _e1969);
                                    let _e1977 = ((_e1971 * _e1868[2]) - (_e1972 * _e1868[1]));
                                    let _e1982 = ((_e1972 * _e1868[0]) - (_e1970 * _e1868[2]));
                                    let _e1987 = ((_e1970 * _e1868[1]) - (_e1971 * _e1868[0]));
                                    if (_e1977 < 0.0lf) {
                                        phi_3362_ = -(_e1977);
                                    } else {
                                        phi_3362_ = _e1977;
                                    }
                                    let _e1991 = phi_3362_;
                                    if (_e1982 < 0.0lf) {
                                        phi_3368_ = -(_e1982);
                                    } else {
                                        phi_3368_ = _e1982;
                                    }
                                    let _e1995 = phi_3368_;
                                    if (_e1991 > _e1995) {
                                        phi_3373_ = _e1991;
                                    } else {
                                        phi_3373_ = _e1995;
                                    }
                                    let _e1998 = phi_3373_;
                                    if (_e1987 < 0.0lf) {
                                        phi_3379_ = -(_e1987);
                                    } else {
                                        phi_3379_ = _e1987;
                                    }
                                    let _e2002 = phi_3379_;
                                    if (_e1998 > _e2002) {
                                        phi_3384_ = _e1998;
                                    } else {
                                        phi_3384_ = _e2002;
                                    }
                                    let _e2005 = phi_3384_;
                                    let _e2006 = function_9(_e2005);
                                    let _e2007 = (_e1977 * _e2006);
                                    let _e2008 = (_e1982 * _e2006);
                                    let _e2009 = (_e1987 * _e2006);
                                    let _e2015 = (((_e2007 * _e2007) + (_e2008 * _e2008)) + (_e2009 * _e2009));
                                    if (_e2015 <= 2.2250738585072014e-308lf) {
                                        if (_e2015 > 0.0lf) {
                                            phi_3408_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3408_ = 0.0lf;
                                        }
                                        let _e2067 = phi_3408_;
                                        phi_3472_ = _e2067;
                                    } else {
                                        phi_3415_ = type_16(0i, 5i);
                                        phi_3418_ = bitcast<f64>(((bitcast<u64>(_e2015) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e2022 = phi_3415_;
                                            let _e2024 = phi_3418_;
                                            local_9 = _e2024;
                                            if (_e2022.member < _e2022.member_1) {
                                                let _e2031 = (_e2022.member + 1i);
                                                if ((false == (_e2031 > _e2022.member)) != false) {
                                                    phi_3439_ = true;
                                                } else {
                                                    phi_3439_ = false;
                                                }
                                                let _e2036 = phi_3439_;
                                                if _e2036 {
                                                    phi_3445_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_3445_ = type_17(1u, _e2031);
                                                }
                                                let _e2041 = phi_3445_;
                                                phi_3416_ = type_16(_e2041.member_1, _e2022.member_1);
                                                phi_3459_ = type_17(1u, _e2022.member);
                                            } else {
                                                phi_3416_ = _e2022;
                                                phi_3459_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e2047 = phi_3416_;
                                            let _e2049 = phi_3459_;
                                            let _e2052 = (bitcast<i32>(_e2049.member) != 0i);
                                            if _e2052 {
                                                phi_3419_ = (0.5lf * (_e2024 + (_e2015 / _e2024)));
                                            } else {
                                                phi_3419_ = f64();
                                            }
                                            let _e2057 = phi_3419_;
                                            continue;
                                            continuing {
                                                phi_3415_ = _e2047;
                                                phi_3418_ = _e2057;
                                                break if !(_e2052);
                                            }
                                        }
                                        let _e2062 = local_9;
                                        phi_3472_ = (_e2062 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e2069 = phi_3472_;
                                    let _e2070 = (f64(1f) / _e2069);
                                    let _e2071 = (_e2007 * _e2070);
                                    let _e2072 = (_e2008 * _e2070);
                                    let _e2073 = (_e2009 * _e2070);
                                    let _e2082 = ((f64(3f) - (((_e2071 * _e2071) + (_e2072 * _e2072)) + (_e2073 * _e2073))) * f64(0.5f));
                                    phi_3491_ = array<f64, 3>((_e2071 * _e2082), (_e2072 * _e2082), (_e2073 * _e2082));
                                } else {
                                    phi_3491_ = array<f64, 3>(_e1773, _e1772, _e1772);
                                }
                                let _e2088 = phi_3491_;
                                phi_3492_ = _e2088;
                            }
                            let _e2189 = phi_3492_;
                            if ((((_e995 * _e2189[0]) + (_e996 * _e2189[1])) + (_e997 * _e2189[2])) > _e1205) {
                                let _e2199 = -(_e1000);
                                phi_3513_ = array<f64, 3>((_e2189[0] * _e2199), (_e2189[1] * _e2199), (_e2189[2] * _e2199));
                            } else {
                                phi_3513_ = _e2189;
                            }
                            let _e2208 = phi_3513_;
                            phi_3514_ = _e2208;
                            phi_3515_ = false;
                        } else {
                            phi_3514_ = array<f64, 3>();
                            phi_3515_ = true;
                        }
                        let _e2210 = phi_3514_;
                        let _e2212 = phi_3515_;
                        phi_3516_ = _e2210;
                        phi_3517_ = _e1757;
                        phi_3518_ = _e2212;
                    } else {
                        phi_3516_ = array<f64, 3>();
                        phi_3517_ = _e1349;
                        phi_3518_ = true;
                    }
                    let _e2214 = phi_3516_;
                    let _e2216 = phi_3517_;
                    let _e2218 = phi_3518_;
                    phi_3522_ = _e2216;
                    phi_3523_ = _e2214;
                    phi_3524_ = _e2218;
                }
                let _e2467 = phi_3522_;
                let _e2469 = phi_3523_;
                let _e2471 = phi_3524_;
                if _e2471 {
                    phi_3528_ = _e2467;
                } else {
                    phi_3528_ = _e2469;
                }
                let _e2473 = phi_3528_;
                if ((((_e2473[0] * _e2473[0]) + (_e2473[1] * _e2473[1])) + (_e2473[2] * _e2473[2])) > f64(0.5f)) {
                    phi_3548_ = _e2473;
                } else {
                    phi_3548_ = array<f64, 3>(_e337, f64(0f), f64(0f));
                }
                let _e2491 = phi_3548_;
                let _e2494 = function_10(_e343[0], _e344[0], _e338);
                let _e2497 = function_10(_e343[1], _e344[1], _e338);
                let _e2500 = function_10(_e343[2], _e344[2], _e338);
                let _e2503 = function_10(_e343[3], _e344[3], _e338);
                if (_e176.member != 0u) {
                    let _e2541 = function_10(_e2494, _e2497, _e898.member);
                    let _e2542 = function_10(_e2500, _e2503, _e898.member_1);
                    phi_3605_ = _e2542;
                    phi_3606_ = _e2541;
                    phi_3607_ = array<f64, 4>((_e337 - _e898.member), _e898.member, (_e337 - _e898.member_1), _e898.member_1);
                } else {
                    let _e2506 = ((_e337 - _e898.member) - _e898.member_1);
                    let _e2507 = f64(0f);
                    if (_e2506 > _e2507) {
                        phi_3577_ = _e2506;
                    } else {
                        phi_3577_ = _e2507;
                    }
                    let _e2510 = phi_3577_;
                    let _e2537 = function_1(array<f64, 4>(_e337, _e2510, _e898.member, _e898.member_1), _e342);
                    phi_3605_ = array<f64, 3>((((_e2497[0] * _e2510) + (_e2500[0] * _e898.member)) + (_e2503[0] * _e898.member_1)), (((_e2497[1] * _e2510) + (_e2500[1] * _e898.member)) + (_e2503[1] * _e898.member_1)), (((_e2497[2] * _e2510) + (_e2500[2] * _e898.member)) + (_e2503[2] * _e898.member_1)));
                    phi_3606_ = _e2494;
                    phi_3607_ = _e2537;
                }
                let _e2544 = phi_3605_;
                let _e2546 = phi_3606_;
                let _e2548 = phi_3607_;
                let _e2550 = function_10(_e2546, _e2544, f64(0.5f));
                let _e2552 = function_(_e2550);
                let _e2554 = function_(_e2491);
                geometry.member[_e137] = type_31(_e2552, f32((_e963 / _e586)), _e2554, _e144, array<f32, 4>(f32(_e2548[0]), f32(_e2548[1]), f32(_e2548[2]), f32(_e2548[3])), _e176.member_1);
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
