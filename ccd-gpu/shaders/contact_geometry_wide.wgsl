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
    var phi_4522_: array<f64, 4>;

    switch bitcast<i32>(param_2) {
        case 0: {
            phi_4522_ = param_1;
            break;
        }
        case 1: {
            phi_4522_ = array<f64, 4>(param_1[0], param_1[3], param_1[1], param_1[2]);
            break;
        }
        default: {
            phi_4522_ = array<f64, 4>(param_1[0], param_1[2], param_1[3], param_1[1]);
            break;
        }
    }
    let _e14 = phi_4522_;
    return _e14;
}

fn function_2(param_3: array<array<f64, 3>, 2>) -> array<f64, 3> {
    return array<f64, 3>((param_3[1][0] - param_3[0][0]), (param_3[1][1] - param_3[0][1]), (param_3[1][2] - param_3[0][2]));
}

fn function_3(param_4: type_44, param_5: type_44) -> type_44 {
    var phi_4490_: type_44;

    if (param_5.member_3 < param_4.member_3) {
        phi_4490_ = param_5;
    } else {
        phi_4490_ = param_4;
    }
    let _e6 = phi_4490_;
    return _e6;
}

fn function_4(param_6: f64, param_7: f64) -> f64 {
    var phi_3559_: f64;
    var phi_3564_: f64;
    var phi_3565_: f64;

    let _e3 = f64(0f);
    if (param_6 > _e3) {
        if (param_6 < param_7) {
            phi_3559_ = param_6;
        } else {
            phi_3559_ = param_7;
        }
        let _e7 = phi_3559_;
        if (_e7 > _e3) {
            phi_3564_ = _e7;
        } else {
            phi_3564_ = _e3;
        }
        let _e10 = phi_3564_;
        phi_3565_ = _e10;
    } else {
        phi_3565_ = _e3;
    }
    let _e12 = phi_3565_;
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
    var phi_4188_: f64;
    var phi_4195_: f64;
    var phi_4207_: type_44;
    var phi_4208_: bool;
    var phi_4209_: type_44;
    var phi_4210_: bool;
    var phi_4065_: bool;
    var phi_4066_: bool;
    var phi_4082_: f64;
    var phi_4088_: f64;
    var phi_4091_: type_44;
    var phi_4092_: bool;
    var phi_4093_: type_44;
    var phi_4094_: bool;
    var phi_4095_: type_44;
    var phi_4096_: bool;
    var phi_4214_: type_44;
    var phi_4215_: bool;
    var phi_4290_: type_44;
    var phi_4291_: type_44;
    var phi_4292_: bool;
    var phi_4296_: type_44;

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
            phi_4066_ = ((_e136 + _e166) <= _e10);
        } else {
            if (_e136 <= _e10) {
                phi_4065_ = (_e166 <= _e10);
            } else {
                phi_4065_ = false;
            }
            let _e170 = phi_4065_;
            phi_4066_ = _e170;
        }
        let _e174 = phi_4066_;
        if (_e136 >= _e9) {
            if (_e166 >= _e9) {
                if _e174 {
                    if _e11 {
                        phi_4082_ = (_e10 - _e136);
                    } else {
                        phi_4082_ = _e10;
                    }
                    let _e179 = phi_4082_;
                    let _e180 = function_7(param_17, _e136, _e179);
                    if _e11 {
                        phi_4088_ = (_e10 - _e180);
                    } else {
                        phi_4088_ = _e10;
                    }
                    let _e183 = phi_4088_;
                    let _e184 = function_5(param_17, _e180, _e183);
                    let _e185 = function_6(param_17, _e184, _e180);
                    phi_4091_ = _e185;
                    phi_4092_ = false;
                } else {
                    phi_4091_ = type_44();
                    phi_4092_ = true;
                }
                let _e187 = phi_4091_;
                let _e189 = phi_4092_;
                phi_4093_ = _e187;
                phi_4094_ = _e189;
            } else {
                phi_4093_ = type_44();
                phi_4094_ = true;
            }
            let _e191 = phi_4093_;
            let _e193 = phi_4094_;
            phi_4095_ = _e191;
            phi_4096_ = _e193;
        } else {
            phi_4095_ = type_44();
            phi_4096_ = true;
        }
        let _e195 = phi_4095_;
        let _e197 = phi_4096_;
        phi_4214_ = _e195;
        phi_4215_ = _e197;
    } else {
        if _e11 {
            phi_4209_ = type_44();
            phi_4210_ = true;
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
                phi_4188_ = _e29;
            } else {
                phi_4188_ = _e52;
            }
            let _e70 = phi_4188_;
            let _e72 = function_4((_e70 / _e67), _e10);
            if (_e29 > _e52) {
                phi_4195_ = _e29;
            } else {
                phi_4195_ = _e52;
            }
            let _e75 = phi_4195_;
            let _e77 = function_4((_e75 / _e67), _e10);
            if (_e72 < _e77) {
                let _e81 = ((_e72 + _e77) * f64(0.5f));
                let _e82 = function_7(param_17, _e81, _e10);
                let _e83 = function_6(param_17, _e81, _e82);
                phi_4207_ = _e83;
                phi_4208_ = false;
            } else {
                phi_4207_ = type_44();
                phi_4208_ = true;
            }
            let _e85 = phi_4207_;
            let _e87 = phi_4208_;
            phi_4209_ = _e85;
            phi_4210_ = _e87;
        }
        let _e89 = phi_4209_;
        let _e91 = phi_4210_;
        phi_4214_ = _e89;
        phi_4215_ = _e91;
    }
    let _e199 = phi_4214_;
    let _e201 = phi_4215_;
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
            phi_4290_ = _e253;
        } else {
            let _e207 = function_7(param_17, _e10, _e10);
            let _e208 = function_6(param_17, _e10, _e207);
            let _e209 = function_5(param_17, _e10, _e10);
            let _e210 = function_6(param_17, _e209, _e10);
            let _e211 = function_3(_e208, _e210);
            let _e212 = function_3(_e206, _e211);
            phi_4290_ = _e212;
        }
        let _e255 = phi_4290_;
        phi_4291_ = _e255;
        phi_4292_ = false;
    } else {
        phi_4291_ = type_44();
        phi_4292_ = true;
    }
    let _e257 = phi_4291_;
    let _e259 = phi_4292_;
    if _e259 {
        phi_4296_ = _e199;
    } else {
        phi_4296_ = _e257;
    }
    let _e261 = phi_4296_;
    return _e261;
}

fn function_9(param_19: f64) -> f64 {
    var phi_3917_: u64;
    var phi_3921_: f64;
    var phi_3923_: f64;

    if ((bitcast<u64>(param_19) & 9218868437227405312lu) != 9218868437227405312lu) {
        if (param_19 >= 2.2250738585072014e-308lf) {
            let _e15 = (9214364837600034816lu - (bitcast<u64>(param_19) & 9218868437227405312lu));
            if (_e15 > 4503599627370496lu) {
                phi_3917_ = _e15;
            } else {
                phi_3917_ = 4503599627370496lu;
            }
            let _e18 = phi_3917_;
            phi_3921_ = bitcast<f64>(_e18);
        } else {
            phi_3921_ = (f64(1f) / 2.2250738585072014e-308lf);
        }
        let _e21 = phi_3921_;
        phi_3923_ = _e21;
    } else {
        phi_3923_ = f64(1f);
    }
    let _e23 = phi_3923_;
    return _e23;
}

fn function_10(param_20: array<f64, 3>, param_21: array<f64, 3>, param_22: f64) -> array<f64, 3> {
    let _e5 = (f64(1f) - param_22);
    return array<f64, 3>(((param_20[0] * _e5) + (param_21[0] * param_22)), ((param_20[1] * _e5) + (param_21[1] * param_22)), ((param_20[2] * _e5) + (param_21[2] * param_22)));
}

fn function_11(param_23: ptr<function, array<array<f64, 3>, 4>>, param_24: u32) -> array<array<f64, 3>, 4> {
    var phi_3894_: array<array<f64, 3>, 4>;

    switch bitcast<i32>(param_24) {
        case 0: {
            let _e32 = (*param_23);
            phi_3894_ = array<array<f64, 3>, 4>(array<f64, 3>(_e32[0][0], _e32[0][1], _e32[0][2]), array<f64, 3>(_e32[1][0], _e32[1][1], _e32[1][2]), array<f64, 3>(_e32[2][0], _e32[2][1], _e32[2][2]), array<f64, 3>(_e32[3][0], _e32[3][1], _e32[3][2]));
            break;
        }
        case 1: {
            let _e8 = (*param_23)[0u];
            let _e14 = (*param_23)[2u];
            let _e20 = (*param_23)[3u];
            let _e26 = (*param_23)[1u];
            phi_3894_ = array<array<f64, 3>, 4>(array<f64, 3>(_e8[0], _e8[1], _e8[2]), array<f64, 3>(_e14[0], _e14[1], _e14[2]), array<f64, 3>(_e20[0], _e20[1], _e20[2]), array<f64, 3>(_e26[0], _e26[1], _e26[2]));
            break;
        }
        default: {
            let _e55 = (*param_23)[0u];
            let _e61 = (*param_23)[3u];
            let _e67 = (*param_23)[1u];
            let _e73 = (*param_23)[2u];
            phi_3894_ = array<array<f64, 3>, 4>(array<f64, 3>(_e55[0], _e55[1], _e55[2]), array<f64, 3>(_e61[0], _e61[1], _e61[2]), array<f64, 3>(_e67[0], _e67[1], _e67[2]), array<f64, 3>(_e73[0], _e73[1], _e73[2]));
            break;
        }
    }
    let _e80 = phi_3894_;
    return _e80;
}

fn function_12(param_25: ptr<function, array<array<f64, 3>, 4>>, param_26: ptr<function, array<array<f64, 3>, 4>>, param_27: f64) -> u32 {
    var phi_3621_: f64;
    var phi_3628_: f64;
    var phi_3636_: f64;
    var phi_3689_: f64;
    var phi_3696_: f64;
    var phi_3704_: f64;
    var phi_3757_: f64;
    var phi_3764_: f64;
    var phi_3772_: f64;
    var phi_3782_: bool;
    var phi_3783_: bool;
    var phi_3791_: u32;
    var phi_3792_: u32;

    let _e11 = (*param_25)[3u];
    let _e16 = (*param_25)[2u];
    let _e25 = (*param_26)[3u];
    let _e30 = (*param_26)[2u];
    let _e38 = function_10(array<f64, 3>((_e11[0] - _e16[0]), (_e11[1] - _e16[1]), (_e11[2] - _e16[2])), array<f64, 3>((_e25[0] - _e30[0]), (_e25[1] - _e30[1]), (_e25[2] - _e30[2])), param_27);
    if (_e38[0] < 0.0lf) {
        phi_3621_ = -(_e38[0]);
    } else {
        phi_3621_ = _e38[0];
    }
    let _e43 = phi_3621_;
    if (_e38[1] < 0.0lf) {
        phi_3628_ = -(_e38[1]);
    } else {
        phi_3628_ = _e38[1];
    }
    let _e48 = phi_3628_;
    if (_e38[2] < 0.0lf) {
        phi_3636_ = -(_e38[2]);
    } else {
        phi_3636_ = _e38[2];
    }
    let _e54 = phi_3636_;
    let _e55 = ((_e43 + _e48) + _e54);
    let _e57 = (*param_25)[1u];
    let _e62 = (*param_25)[3u];
    let _e71 = (*param_26)[1u];
    let _e76 = (*param_26)[3u];
    let _e84 = function_10(array<f64, 3>((_e57[0] - _e62[0]), (_e57[1] - _e62[1]), (_e57[2] - _e62[2])), array<f64, 3>((_e71[0] - _e76[0]), (_e71[1] - _e76[1]), (_e71[2] - _e76[2])), param_27);
    if (_e84[0] < 0.0lf) {
        phi_3689_ = -(_e84[0]);
    } else {
        phi_3689_ = _e84[0];
    }
    let _e89 = phi_3689_;
    if (_e84[1] < 0.0lf) {
        phi_3696_ = -(_e84[1]);
    } else {
        phi_3696_ = _e84[1];
    }
    let _e94 = phi_3696_;
    if (_e84[2] < 0.0lf) {
        phi_3704_ = -(_e84[2]);
    } else {
        phi_3704_ = _e84[2];
    }
    let _e100 = phi_3704_;
    let _e101 = ((_e89 + _e94) + _e100);
    let _e103 = (*param_25)[2u];
    let _e108 = (*param_25)[1u];
    let _e117 = (*param_26)[2u];
    let _e122 = (*param_26)[1u];
    let _e130 = function_10(array<f64, 3>((_e103[0] - _e108[0]), (_e103[1] - _e108[1]), (_e103[2] - _e108[2])), array<f64, 3>((_e117[0] - _e122[0]), (_e117[1] - _e122[1]), (_e117[2] - _e122[2])), param_27);
    if (_e130[0] < 0.0lf) {
        phi_3757_ = -(_e130[0]);
    } else {
        phi_3757_ = _e130[0];
    }
    let _e135 = phi_3757_;
    if (_e130[1] < 0.0lf) {
        phi_3764_ = -(_e130[1]);
    } else {
        phi_3764_ = _e130[1];
    }
    let _e140 = phi_3764_;
    if (_e130[2] < 0.0lf) {
        phi_3772_ = -(_e130[2]);
    } else {
        phi_3772_ = _e130[2];
    }
    let _e146 = phi_3772_;
    let _e147 = ((_e135 + _e140) + _e146);
    if (_e55 >= _e101) {
        if (_e55 >= _e147) {
            phi_3782_ = false;
        } else {
            phi_3782_ = true;
        }
        let _e151 = phi_3782_;
        phi_3783_ = _e151;
    } else {
        phi_3783_ = true;
    }
    let _e153 = phi_3783_;
    if _e153 {
        if (_e101 >= _e147) {
            phi_3791_ = 1u;
        } else {
            phi_3791_ = 2u;
        }
        let _e156 = phi_3791_;
        phi_3792_ = _e156;
    } else {
        phi_3792_ = 0u;
    }
    let _e158 = phi_3792_;
    return _e158;
}

fn function_13(param_28: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param_28[0]), f64(param_28[1]), f64(param_28[2]));
}

fn function_14(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_35;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: array<array<f64, 3>, 4>;
    var phi_199_: u32;
    var phi_215_: u32;
    var phi_236_: u32;
    var phi_237_: u32;
    var phi_240_: type_12;
    var phi_241_: type_12;
    var phi_264_: type_12;
    var phi_403_: type_33;
    var phi_608_: type_41;
    var phi_665_: u32;
    var phi_826_: type_43;
    var phi_842_: f64;
    var phi_849_: f64;
    var phi_854_: f64;
    var phi_861_: f64;
    var phi_866_: f64;
    var phi_873_: f64;
    var phi_880_: f64;
    var phi_885_: f64;
    var phi_892_: f64;
    var phi_897_: f64;
    var phi_902_: f64;
    var phi_909_: f64;
    var phi_916_: f64;
    var phi_921_: f64;
    var phi_928_: f64;
    var phi_933_: f64;
    var phi_938_: f64;
    var phi_968_: f64;
    var phi_975_: f64;
    var phi_980_: f64;
    var phi_987_: f64;
    var phi_992_: f64;
    var phi_1000_: f64;
    var phi_1007_: f64;
    var phi_1012_: f64;
    var phi_1019_: f64;
    var phi_1024_: f64;
    var phi_1029_: f64;
    var phi_1039_: f64;
    var phi_1046_: f64;
    var phi_1051_: f64;
    var phi_1058_: f64;
    var phi_1063_: f64;
    var phi_1071_: f64;
    var phi_1078_: f64;
    var phi_1083_: f64;
    var phi_1090_: f64;
    var phi_1095_: f64;
    var phi_1100_: f64;
    var phi_1110_: f64;
    var phi_1117_: f64;
    var phi_1122_: f64;
    var phi_1129_: f64;
    var phi_1134_: f64;
    var phi_1142_: f64;
    var phi_1149_: f64;
    var phi_1154_: f64;
    var phi_1161_: f64;
    var phi_1166_: f64;
    var phi_1171_: f64;
    var phi_1204_: f64;
    var phi_1210_: f64;
    var phi_1215_: f64;
    var phi_1221_: f64;
    var phi_1226_: f64;
    var phi_1234_: f64;
    var phi_1240_: f64;
    var phi_1245_: f64;
    var phi_1251_: f64;
    var phi_1256_: f64;
    var phi_1284_: type_16;
    var phi_1287_: f64;
    var phi_1308_: bool;
    var phi_1314_: type_17;
    var phi_1285_: type_16;
    var phi_1328_: type_17;
    var phi_1288_: f64;
    var local_3: f64;
    var phi_1277_: f64;
    var phi_1341_: f64;
    var phi_1351_: f64;
    var phi_1357_: f64;
    var phi_1407_: type_16;
    var phi_1410_: f64;
    var phi_1431_: bool;
    var phi_1437_: type_17;
    var phi_1408_: type_16;
    var phi_1451_: type_17;
    var phi_1411_: f64;
    var local_4: f64;
    var phi_1400_: f64;
    var phi_1464_: f64;
    var phi_1474_: f64;
    var phi_1480_: f64;
    var phi_1521_: bool;
    var phi_1527_: bool;
    var phi_1543_: bool;
    var phi_1544_: bool;
    var phi_1545_: bool;
    var phi_1546_: bool;
    var phi_1547_: bool;
    var phi_1551_: bool;
    var phi_1903_: f64;
    var phi_1910_: f64;
    var phi_1915_: f64;
    var phi_1922_: f64;
    var phi_1927_: f64;
    var phi_1935_: f64;
    var phi_1942_: f64;
    var phi_1947_: f64;
    var phi_1954_: f64;
    var phi_1959_: f64;
    var phi_1964_: f64;
    var phi_1974_: f64;
    var phi_1981_: f64;
    var phi_1986_: f64;
    var phi_1993_: f64;
    var phi_1998_: f64;
    var phi_2006_: f64;
    var phi_2013_: f64;
    var phi_2018_: f64;
    var phi_2025_: f64;
    var phi_2030_: f64;
    var phi_2035_: f64;
    var phi_2045_: f64;
    var phi_2052_: f64;
    var phi_2057_: f64;
    var phi_2064_: f64;
    var phi_2069_: f64;
    var phi_2077_: f64;
    var phi_2084_: f64;
    var phi_2089_: f64;
    var phi_2096_: f64;
    var phi_2101_: f64;
    var phi_2106_: f64;
    var phi_2126_: f64;
    var phi_2132_: f64;
    var phi_2137_: f64;
    var phi_2143_: f64;
    var phi_2148_: f64;
    var phi_2179_: type_16;
    var phi_2182_: f64;
    var phi_2203_: bool;
    var phi_2209_: type_17;
    var phi_2180_: type_16;
    var phi_2223_: type_17;
    var phi_2183_: f64;
    var local_5: f64;
    var phi_2172_: f64;
    var phi_2236_: f64;
    var phi_2264_: f64;
    var phi_2270_: f64;
    var phi_2277_: f64;
    var phi_2291_: f64;
    var phi_2305_: array<f64, 3>;
    var phi_2306_: array<f64, 3>;
    var phi_2307_: bool;
    var phi_2308_: array<f64, 3>;
    var phi_2309_: bool;
    var phi_2319_: bool;
    var phi_2320_: bool;
    var phi_2355_: array<f64, 3>;
    var phi_2356_: bool;
    var phi_2357_: array<f64, 3>;
    var phi_2358_: bool;
    var phi_2359_: array<f64, 3>;
    var phi_2360_: bool;
    var phi_2382_: f64;
    var phi_2389_: f64;
    var phi_2394_: f64;
    var phi_2401_: f64;
    var phi_2406_: f64;
    var phi_2419_: f64;
    var phi_2426_: f64;
    var phi_2431_: f64;
    var phi_2438_: f64;
    var phi_2443_: f64;
    var phi_2448_: bool;
    var phi_2449_: bool;
    var phi_2459_: array<f64, 3>;
    var phi_2460_: bool;
    var phi_2461_: array<f64, 3>;
    var phi_2462_: bool;
    var phi_2476_: array<f64, 3>;
    var phi_2477_: array<f64, 3>;
    var phi_2478_: array<f64, 3>;
    var phi_2485_: f64;
    var phi_2492_: f64;
    var phi_2497_: f64;
    var phi_2504_: f64;
    var phi_2509_: f64;
    var phi_2521_: f64;
    var phi_2528_: f64;
    var phi_2533_: f64;
    var phi_2540_: f64;
    var phi_2545_: f64;
    var phi_2579_: type_16;
    var phi_2582_: f64;
    var phi_2603_: bool;
    var phi_2609_: type_17;
    var phi_2580_: type_16;
    var phi_2623_: type_17;
    var phi_2583_: f64;
    var local_6: f64;
    var phi_2572_: f64;
    var phi_2636_: f64;
    var phi_2665_: array<f64, 3>;
    var phi_2672_: f64;
    var phi_2679_: f64;
    var phi_2687_: f64;
    var phi_2705_: f64;
    var phi_2711_: f64;
    var phi_2716_: f64;
    var phi_2722_: f64;
    var phi_2727_: f64;
    var phi_2758_: type_16;
    var phi_2761_: f64;
    var phi_2782_: bool;
    var phi_2788_: type_17;
    var phi_2759_: type_16;
    var phi_2802_: type_17;
    var phi_2762_: f64;
    var local_7: f64;
    var phi_2751_: f64;
    var phi_2815_: f64;
    var phi_2833_: array<f64, 3>;
    var phi_2834_: bool;
    var phi_2835_: array<f64, 3>;
    var phi_2836_: bool;
    var phi_2996_: f64;
    var phi_3003_: f64;
    var phi_3008_: f64;
    var phi_3015_: f64;
    var phi_3020_: f64;
    var phi_3027_: f64;
    var phi_3034_: f64;
    var phi_3039_: f64;
    var phi_3046_: f64;
    var phi_3051_: f64;
    var phi_3056_: array<f64, 3>;
    var phi_3063_: f64;
    var phi_3070_: f64;
    var phi_3075_: f64;
    var phi_3082_: f64;
    var phi_3087_: f64;
    var phi_3098_: f64;
    var phi_3105_: f64;
    var phi_3112_: f64;
    var phi_3122_: array<f64, 3>;
    var phi_3123_: bool;
    var phi_3124_: array<f64, 3>;
    var phi_3125_: bool;
    var phi_3135_: array<f64, 3>;
    var phi_3136_: array<f64, 3>;
    var phi_3143_: f64;
    var phi_3150_: f64;
    var phi_3155_: f64;
    var phi_3162_: f64;
    var phi_3167_: f64;
    var phi_3201_: type_16;
    var phi_3204_: f64;
    var phi_3225_: bool;
    var phi_3231_: type_17;
    var phi_3202_: type_16;
    var phi_3245_: type_17;
    var phi_3205_: f64;
    var local_8: f64;
    var phi_3194_: f64;
    var phi_3258_: f64;
    var phi_3295_: f64;
    var phi_3301_: f64;
    var phi_3306_: f64;
    var phi_3312_: f64;
    var phi_3317_: f64;
    var phi_3348_: type_16;
    var phi_3351_: f64;
    var phi_3372_: bool;
    var phi_3378_: type_17;
    var phi_3349_: type_16;
    var phi_3392_: type_17;
    var phi_3352_: f64;
    var local_9: f64;
    var phi_3341_: f64;
    var phi_3405_: f64;
    var phi_3424_: array<f64, 3>;
    var phi_2848_: f64;
    var phi_2854_: f64;
    var phi_2859_: f64;
    var phi_2865_: f64;
    var phi_2870_: f64;
    var phi_2901_: type_16;
    var phi_2904_: f64;
    var phi_2925_: bool;
    var phi_2931_: type_17;
    var phi_2902_: type_16;
    var phi_2945_: type_17;
    var phi_2905_: f64;
    var local_10: f64;
    var phi_2894_: f64;
    var phi_2958_: f64;
    var phi_3425_: array<f64, 3>;
    var phi_3426_: array<f64, 3>;
    var phi_3427_: bool;
    var phi_3428_: array<f64, 3>;
    var phi_3429_: array<f64, 3>;
    var phi_3430_: bool;
    var phi_1613_: array<f64, 3>;
    var phi_1620_: f64;
    var phi_1627_: f64;
    var phi_1632_: f64;
    var phi_1639_: f64;
    var phi_1644_: f64;
    var phi_1678_: type_16;
    var phi_1681_: f64;
    var phi_1702_: bool;
    var phi_1708_: type_17;
    var phi_1679_: type_16;
    var phi_1722_: type_17;
    var phi_1682_: f64;
    var local_11: f64;
    var phi_1671_: f64;
    var phi_1735_: f64;
    var phi_1753_: array<f64, 3>;
    var phi_1754_: bool;
    var phi_1755_: array<f64, 3>;
    var phi_1756_: bool;
    var phi_1757_: array<f64, 3>;
    var phi_1758_: bool;
    var phi_1767_: f64;
    var phi_1773_: f64;
    var phi_1778_: f64;
    var phi_1784_: f64;
    var phi_1789_: f64;
    var phi_1820_: type_16;
    var phi_1823_: f64;
    var phi_1844_: bool;
    var phi_1850_: type_17;
    var phi_1821_: type_16;
    var phi_1864_: type_17;
    var phi_1824_: f64;
    var local_12: f64;
    var phi_1813_: f64;
    var phi_1877_: f64;
    var phi_1895_: array<f64, 3>;
    var phi_3434_: array<f64, 3>;
    var phi_3435_: array<f64, 3>;
    var phi_3436_: bool;
    var phi_3440_: array<f64, 3>;
    var phi_3460_: array<f64, 3>;
    var phi_3489_: f64;
    var phi_3517_: array<f64, 3>;
    var phi_3518_: array<f64, 3>;
    var phi_3519_: array<f64, 4>;
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
        phi_199_ = _e71;
    } else {
        phi_199_ = _e73;
    }
    let _e76 = phi_199_;
    let _e77 = (_e76 / 64u);
    if ((_e76 % 64u) > 0u) {
        phi_215_ = (_e77 + 1u);
    } else {
        phi_215_ = _e77;
    }
    let _e82 = phi_215_;
    if (_e82 > _e65) {
        let _e84 = (_e82 - _e65);
        if (_e68 == 0u) {
            return;
        }
        let _e86 = (_e84 / _e68);
        if (_e68 == 0u) {
            return;
        }
        if ((_e84 % _e68) > 0u) {
            phi_236_ = (_e86 + 1u);
        } else {
            phi_236_ = _e86;
        }
        let _e92 = phi_236_;
        phi_237_ = _e92;
    } else {
        phi_237_ = 0u;
    }
    let _e94 = phi_237_;
    phi_240_ = type_12(0u, _e94);
    loop {
        let _e97 = phi_240_;
        if (_e97.member < _e97.member_1) {
            phi_241_ = type_12((_e97.member + 1u), _e97.member_1);
            phi_264_ = type_12(1u, _e97.member);
        } else {
            phi_241_ = _e97;
            phi_264_ = type_12(0u, type_12().member_1);
        }
        let _e109 = phi_241_;
        let _e111 = phi_264_;
        let _e115 = (bitcast<i32>(_e111.member) != 0i);
        if _e115 {
            let _e119 = (((_e65 + (_e111.member_1 * _e68)) * 64u) + _e53);
            if (_e119 < _e76) {
                let _e121 = (7u * _e119);
                let _e124 = contacts.member[(4u + _e121)];
                let _e127 = contacts.member[(_e121 + 5u)];
                let _e130 = contacts.member[(_e121 + 6u)];
                let _e133 = contacts.member[(_e121 + 7u)];
                let _e136 = contacts.member[(_e121 + 8u)];
                let _e139 = contacts.member[(_e121 + 9u)];
                if (_e124 == 0u) {
                    let _e152 = faces.member[_e133];
                    phi_403_ = type_33(0u, array<u32, 4>(_e130, _e152[0], _e152[1], _e152[2]));
                } else {
                    let _e142 = edges.member[_e130];
                    let _e144 = edges.member[_e133];
                    phi_403_ = type_33(1u, array<u32, 4>(_e142[0], _e142[1], _e144[0], _e144[1]));
                }
                let _e159 = phi_403_;
                let _e164 = params.member.member.member_1;
                if ((_e164 & 8u) != 0u) {
                    let _e208 = paths.member[_e159.member_1[0]];
                    let _e211 = paths.member[_e159.member_1[1]];
                    let _e218 = paths.member[_e159.member_1[2]];
                    let _e221 = paths.member[_e159.member_1[3]];
                    let _e258 = function_13(array<f32, 3>(_e208.member[0], _e208.member[1], _e208.member[2]));
                    let _e259 = function_13(array<f32, 3>(_e211.member[0], _e211.member[1], _e211.member[2]));
                    let _e260 = function_13(array<f32, 3>(_e218.member[0], _e218.member[1], _e218.member[2]));
                    let _e261 = function_13(array<f32, 3>(_e221.member[0], _e221.member[1], _e221.member[2]));
                    let _e263 = function_13(array<f32, 3>(_e208.member_1[0], _e208.member_1[1], _e208.member_1[2]));
                    let _e264 = function_13(array<f32, 3>(_e211.member_1[0], _e211.member_1[1], _e211.member_1[2]));
                    let _e265 = function_13(array<f32, 3>(_e218.member_1[0], _e218.member_1[1], _e218.member_1[2]));
                    let _e266 = function_13(array<f32, 3>(_e221.member_1[0], _e221.member_1[1], _e221.member_1[2]));
                    phi_608_ = type_41(array<array<f64, 3>, 4>(_e258, _e259, _e260, _e261), array<array<f64, 3>, 4>(_e263, _e264, _e265, _e266));
                } else {
                    let _e169 = positions.member[_e159.member_1[0]];
                    let _e172 = params.member.member.member[0u];
                    let _e175 = positions.member[(_e172 + _e159.member_1[0])];
                    let _e178 = positions.member[_e159.member_1[1]];
                    let _e181 = params.member.member.member[0u];
                    let _e184 = positions.member[(_e181 + _e159.member_1[1])];
                    let _e187 = positions.member[_e159.member_1[2]];
                    let _e190 = params.member.member.member[0u];
                    let _e193 = positions.member[(_e190 + _e159.member_1[2])];
                    let _e196 = positions.member[_e159.member_1[3]];
                    let _e199 = params.member.member.member[0u];
                    let _e202 = positions.member[(_e199 + _e159.member_1[3])];
                    phi_608_ = type_41(array<array<f64, 3>, 4>(_e169, _e178, _e187, _e196), array<array<f64, 3>, 4>(_e175, _e184, _e193, _e202));
                }
                let _e270 = phi_608_;
                local_1 = array<array<f64, 3>, 4>(array<f64, 3>(_e270.member[0][0], _e270.member[0][1], _e270.member[0][2]), array<f64, 3>(_e270.member[1][0], _e270.member[1][1], _e270.member[1][2]), array<f64, 3>(_e270.member[2][0], _e270.member[2][1], _e270.member[2][2]), array<f64, 3>(_e270.member[3][0], _e270.member[3][1], _e270.member[3][2]));
                local_2 = array<array<f64, 3>, 4>(array<f64, 3>(_e270.member_1[0][0], _e270.member_1[0][1], _e270.member_1[0][2]), array<f64, 3>(_e270.member_1[1][0], _e270.member_1[1][1], _e270.member_1[1][2]), array<f64, 3>(_e270.member_1[2][0], _e270.member_1[2][1], _e270.member_1[2][2]), array<f64, 3>(_e270.member_1[3][0], _e270.member_1[3][1], _e270.member_1[3][2]));
                let _e320 = f64(1f);
                let _e321 = function_4(bitcast<f64>(((u64(_e139) * 4294967296lu) + u64(_e136))), _e320);
                if (_e159.member == 0u) {
                    let _e323 = function_12((&local_1), (&local_2), _e321);
                    phi_665_ = _e323;
                } else {
                    phi_665_ = 0u;
                }
                let _e325 = phi_665_;
                let _e326 = function_11((&local_1), _e325);
                let _e327 = function_11((&local_2), _e325);
                if (_e159.member != 0u) {
                    phi_826_ = type_43(array<array<f64, 3>, 2>(array<f64, 3>((_e326[2][0] - _e326[0][0]), (_e326[2][1] - _e326[0][1]), (_e326[2][2] - _e326[0][2])), array<f64, 3>((_e327[2][0] - _e327[0][0]), (_e327[2][1] - _e327[0][1]), (_e327[2][2] - _e327[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e326[1][0] - _e326[0][0]), (_e326[1][1] - _e326[0][1]), (_e326[1][2] - _e326[0][2])), array<f64, 3>((_e327[1][0] - _e327[0][0]), (_e327[1][1] - _e327[0][1]), (_e327[1][2] - _e327[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e326[2][0] - _e326[3][0]), (_e326[2][1] - _e326[3][1]), (_e326[2][2] - _e326[3][2])), array<f64, 3>((_e327[2][0] - _e327[3][0]), (_e327[2][1] - _e327[3][1]), (_e327[2][2] - _e327[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_826_ = type_43(array<array<f64, 3>, 2>(array<f64, 3>((_e326[0][0] - _e326[1][0]), (_e326[0][1] - _e326[1][1]), (_e326[0][2] - _e326[1][2])), array<f64, 3>((_e327[0][0] - _e327[1][0]), (_e327[0][1] - _e327[1][1]), (_e327[0][2] - _e327[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e326[2][0] - _e326[1][0]), (_e326[2][1] - _e326[1][1]), (_e326[2][2] - _e326[1][2])), array<f64, 3>((_e327[2][0] - _e327[1][0]), (_e327[2][1] - _e327[1][1]), (_e327[2][2] - _e327[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e326[3][0] - _e326[1][0]), (_e326[3][1] - _e326[1][1]), (_e326[3][2] - _e326[1][2])), array<f64, 3>((_e327[3][0] - _e327[1][0]), (_e327[3][1] - _e327[1][1]), (_e327[3][2] - _e327[1][2]))), (0.0lf + 0.0lf));
                }
                let _e484 = phi_826_;
                let _e489 = function_10(_e484.member[0], _e484.member[1], _e321);
                let _e494 = function_10(_e484.member_1[0], _e484.member_1[1], _e321);
                let _e499 = function_10(_e484.member_2[0], _e484.member_2[1], _e321);
                if (_e489[0] < 0.0lf) {
                    phi_842_ = -(_e489[0]);
                } else {
                    phi_842_ = _e489[0];
                }
                let _e504 = phi_842_;
                if (_e489[1] < 0.0lf) {
                    phi_849_ = -(_e489[1]);
                } else {
                    phi_849_ = _e489[1];
                }
                let _e509 = phi_849_;
                if (_e504 > _e509) {
                    phi_854_ = _e504;
                } else {
                    phi_854_ = _e509;
                }
                let _e512 = phi_854_;
                if (_e489[2] < 0.0lf) {
                    phi_861_ = -(_e489[2]);
                } else {
                    phi_861_ = _e489[2];
                }
                let _e517 = phi_861_;
                if (_e512 > _e517) {
                    phi_866_ = _e512;
                } else {
                    phi_866_ = _e517;
                }
                let _e520 = phi_866_;
                if (_e494[0] < 0.0lf) {
                    phi_873_ = -(_e494[0]);
                } else {
                    phi_873_ = _e494[0];
                }
                let _e525 = phi_873_;
                if (_e494[1] < 0.0lf) {
                    phi_880_ = -(_e494[1]);
                } else {
                    phi_880_ = _e494[1];
                }
                let _e530 = phi_880_;
                if (_e525 > _e530) {
                    phi_885_ = _e525;
                } else {
                    phi_885_ = _e530;
                }
                let _e533 = phi_885_;
                if (_e494[2] < 0.0lf) {
                    phi_892_ = -(_e494[2]);
                } else {
                    phi_892_ = _e494[2];
                }
                let _e538 = phi_892_;
                if (_e533 > _e538) {
                    phi_897_ = _e533;
                } else {
                    phi_897_ = _e538;
                }
                let _e541 = phi_897_;
                if (_e520 > _e541) {
                    phi_902_ = _e520;
                } else {
                    phi_902_ = _e541;
                }
                let _e544 = phi_902_;
                if (_e499[0] < 0.0lf) {
                    phi_909_ = -(_e499[0]);
                } else {
                    phi_909_ = _e499[0];
                }
                let _e549 = phi_909_;
                if (_e499[1] < 0.0lf) {
                    phi_916_ = -(_e499[1]);
                } else {
                    phi_916_ = _e499[1];
                }
                let _e554 = phi_916_;
                if (_e549 > _e554) {
                    phi_921_ = _e549;
                } else {
                    phi_921_ = _e554;
                }
                let _e557 = phi_921_;
                if (_e499[2] < 0.0lf) {
                    phi_928_ = -(_e499[2]);
                } else {
                    phi_928_ = _e499[2];
                }
                let _e562 = phi_928_;
                if (_e557 > _e562) {
                    phi_933_ = _e557;
                } else {
                    phi_933_ = _e562;
                }
                let _e565 = phi_933_;
                if (_e544 > _e565) {
                    phi_938_ = _e544;
                } else {
                    phi_938_ = _e565;
                }
                let _e568 = phi_938_;
                let _e569 = function_9(_e568);
                let _e577 = (_e494[0] * _e569);
                let _e579 = (_e494[1] * _e569);
                let _e581 = (_e494[2] * _e569);
                let _e583 = (_e499[0] * _e569);
                let _e585 = (_e499[1] * _e569);
                let _e587 = (_e499[2] * _e569);
                if (_e484.member[0][0] < 0.0lf) {
                    phi_968_ = -(_e484.member[0][0]);
                } else {
                    phi_968_ = _e484.member[0][0];
                }
                let _e594 = phi_968_;
                if (_e484.member[0][1] < 0.0lf) {
                    phi_975_ = -(_e484.member[0][1]);
                } else {
                    phi_975_ = _e484.member[0][1];
                }
                let _e599 = phi_975_;
                if (_e594 > _e599) {
                    phi_980_ = _e594;
                } else {
                    phi_980_ = _e599;
                }
                let _e602 = phi_980_;
                if (_e484.member[0][2] < 0.0lf) {
                    phi_987_ = -(_e484.member[0][2]);
                } else {
                    phi_987_ = _e484.member[0][2];
                }
                let _e607 = phi_987_;
                if (_e602 > _e607) {
                    phi_992_ = _e602;
                } else {
                    phi_992_ = _e607;
                }
                let _e610 = phi_992_;
                if (_e484.member[1][0] < 0.0lf) {
                    phi_1000_ = -(_e484.member[1][0]);
                } else {
                    phi_1000_ = _e484.member[1][0];
                }
                let _e617 = phi_1000_;
                if (_e484.member[1][1] < 0.0lf) {
                    phi_1007_ = -(_e484.member[1][1]);
                } else {
                    phi_1007_ = _e484.member[1][1];
                }
                let _e622 = phi_1007_;
                if (_e617 > _e622) {
                    phi_1012_ = _e617;
                } else {
                    phi_1012_ = _e622;
                }
                let _e625 = phi_1012_;
                if (_e484.member[1][2] < 0.0lf) {
                    phi_1019_ = -(_e484.member[1][2]);
                } else {
                    phi_1019_ = _e484.member[1][2];
                }
                let _e630 = phi_1019_;
                if (_e625 > _e630) {
                    phi_1024_ = _e625;
                } else {
                    phi_1024_ = _e630;
                }
                let _e633 = phi_1024_;
                if (_e610 > _e633) {
                    phi_1029_ = _e610;
                } else {
                    phi_1029_ = _e633;
                }
                let _e636 = phi_1029_;
                if (_e484.member_1[0][0] < 0.0lf) {
                    phi_1039_ = -(_e484.member_1[0][0]);
                } else {
                    phi_1039_ = _e484.member_1[0][0];
                }
                let _e645 = phi_1039_;
                if (_e484.member_1[0][1] < 0.0lf) {
                    phi_1046_ = -(_e484.member_1[0][1]);
                } else {
                    phi_1046_ = _e484.member_1[0][1];
                }
                let _e650 = phi_1046_;
                if (_e645 > _e650) {
                    phi_1051_ = _e645;
                } else {
                    phi_1051_ = _e650;
                }
                let _e653 = phi_1051_;
                if (_e484.member_1[0][2] < 0.0lf) {
                    phi_1058_ = -(_e484.member_1[0][2]);
                } else {
                    phi_1058_ = _e484.member_1[0][2];
                }
                let _e658 = phi_1058_;
                if (_e653 > _e658) {
                    phi_1063_ = _e653;
                } else {
                    phi_1063_ = _e658;
                }
                let _e661 = phi_1063_;
                if (_e484.member_1[1][0] < 0.0lf) {
                    phi_1071_ = -(_e484.member_1[1][0]);
                } else {
                    phi_1071_ = _e484.member_1[1][0];
                }
                let _e668 = phi_1071_;
                if (_e484.member_1[1][1] < 0.0lf) {
                    phi_1078_ = -(_e484.member_1[1][1]);
                } else {
                    phi_1078_ = _e484.member_1[1][1];
                }
                let _e673 = phi_1078_;
                if (_e668 > _e673) {
                    phi_1083_ = _e668;
                } else {
                    phi_1083_ = _e673;
                }
                let _e676 = phi_1083_;
                if (_e484.member_1[1][2] < 0.0lf) {
                    phi_1090_ = -(_e484.member_1[1][2]);
                } else {
                    phi_1090_ = _e484.member_1[1][2];
                }
                let _e681 = phi_1090_;
                if (_e676 > _e681) {
                    phi_1095_ = _e676;
                } else {
                    phi_1095_ = _e681;
                }
                let _e684 = phi_1095_;
                if (_e661 > _e684) {
                    phi_1100_ = _e661;
                } else {
                    phi_1100_ = _e684;
                }
                let _e687 = phi_1100_;
                let _e689 = (_e687 + _e484.member_3);
                if (_e484.member_2[0][0] < 0.0lf) {
                    phi_1110_ = -(_e484.member_2[0][0]);
                } else {
                    phi_1110_ = _e484.member_2[0][0];
                }
                let _e696 = phi_1110_;
                if (_e484.member_2[0][1] < 0.0lf) {
                    phi_1117_ = -(_e484.member_2[0][1]);
                } else {
                    phi_1117_ = _e484.member_2[0][1];
                }
                let _e701 = phi_1117_;
                if (_e696 > _e701) {
                    phi_1122_ = _e696;
                } else {
                    phi_1122_ = _e701;
                }
                let _e704 = phi_1122_;
                if (_e484.member_2[0][2] < 0.0lf) {
                    phi_1129_ = -(_e484.member_2[0][2]);
                } else {
                    phi_1129_ = _e484.member_2[0][2];
                }
                let _e709 = phi_1129_;
                if (_e704 > _e709) {
                    phi_1134_ = _e704;
                } else {
                    phi_1134_ = _e709;
                }
                let _e712 = phi_1134_;
                if (_e484.member_2[1][0] < 0.0lf) {
                    phi_1142_ = -(_e484.member_2[1][0]);
                } else {
                    phi_1142_ = _e484.member_2[1][0];
                }
                let _e719 = phi_1142_;
                if (_e484.member_2[1][1] < 0.0lf) {
                    phi_1149_ = -(_e484.member_2[1][1]);
                } else {
                    phi_1149_ = _e484.member_2[1][1];
                }
                let _e724 = phi_1149_;
                if (_e719 > _e724) {
                    phi_1154_ = _e719;
                } else {
                    phi_1154_ = _e724;
                }
                let _e727 = phi_1154_;
                if (_e484.member_2[1][2] < 0.0lf) {
                    phi_1161_ = -(_e484.member_2[1][2]);
                } else {
                    phi_1161_ = _e484.member_2[1][2];
                }
                let _e732 = phi_1161_;
                if (_e727 > _e732) {
                    phi_1166_ = _e727;
                } else {
                    phi_1166_ = _e732;
                }
                let _e735 = phi_1166_;
                if (_e712 > _e735) {
                    phi_1171_ = _e712;
                } else {
                    phi_1171_ = _e735;
                }
                let _e738 = phi_1171_;
                let _e740 = (_e738 + _e484.member_3);
                let _e742 = (1.1102230246251565e-16lf * f64(16f));
                let _e745 = (_e484.member_3 * f64(4f));
                let _e753 = ((_e579 * _e587) - (_e581 * _e585));
                let _e756 = ((_e581 * _e583) - (_e577 * _e587));
                let _e759 = ((_e577 * _e585) - (_e579 * _e583));
                if (_e583 < 0.0lf) {
                    phi_1204_ = -(_e583);
                } else {
                    phi_1204_ = _e583;
                }
                let _e768 = phi_1204_;
                if (_e585 < 0.0lf) {
                    phi_1210_ = -(_e585);
                } else {
                    phi_1210_ = _e585;
                }
                let _e772 = phi_1210_;
                if (_e768 > _e772) {
                    phi_1215_ = _e768;
                } else {
                    phi_1215_ = _e772;
                }
                let _e775 = phi_1215_;
                if (_e587 < 0.0lf) {
                    phi_1221_ = -(_e587);
                } else {
                    phi_1221_ = _e587;
                }
                let _e779 = phi_1221_;
                if (_e775 > _e779) {
                    phi_1226_ = _e775;
                } else {
                    phi_1226_ = _e779;
                }
                let _e782 = phi_1226_;
                if (_e577 < 0.0lf) {
                    phi_1234_ = -(_e577);
                } else {
                    phi_1234_ = _e577;
                }
                let _e788 = phi_1234_;
                if (_e579 < 0.0lf) {
                    phi_1240_ = -(_e579);
                } else {
                    phi_1240_ = _e579;
                }
                let _e792 = phi_1240_;
                if (_e788 > _e792) {
                    phi_1245_ = _e788;
                } else {
                    phi_1245_ = _e792;
                }
                let _e795 = phi_1245_;
                if (_e581 < 0.0lf) {
                    phi_1251_ = -(_e581);
                } else {
                    phi_1251_ = _e581;
                }
                let _e799 = phi_1251_;
                if (_e795 > _e799) {
                    phi_1256_ = _e795;
                } else {
                    phi_1256_ = _e799;
                }
                let _e802 = phi_1256_;
                let _e804 = (((((_e689 * _e742) + _e745) * _e569) * _e782) + ((((_e740 * _e742) + _e745) * _e569) * _e802));
                let _e809 = (((_e753 * _e753) + (_e756 * _e756)) + (_e759 * _e759));
                if (_e809 <= 2.2250738585072014e-308lf) {
                    if (_e809 > 0.0lf) {
                        phi_1277_ = (1.464336215552873e-154lf * 2.0lf);
                    } else {
                        phi_1277_ = 0.0lf;
                    }
                    let _e861 = phi_1277_;
                    phi_1341_ = _e861;
                } else {
                    phi_1284_ = type_16(0i, 5i);
                    phi_1287_ = bitcast<f64>(((bitcast<u64>(_e809) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e816 = phi_1284_;
                        let _e818 = phi_1287_;
                        local_3 = _e818;
                        if (_e816.member < _e816.member_1) {
                            let _e825 = (_e816.member + 1i);
                            if ((false == (_e825 > _e816.member)) != false) {
                                phi_1308_ = true;
                            } else {
                                phi_1308_ = false;
                            }
                            let _e830 = phi_1308_;
                            if _e830 {
                                phi_1314_ = type_17(0u, type_17().member_1);
                            } else {
                                phi_1314_ = type_17(1u, _e825);
                            }
                            let _e835 = phi_1314_;
                            phi_1285_ = type_16(_e835.member_1, _e816.member_1);
                            phi_1328_ = type_17(1u, _e816.member);
                        } else {
                            phi_1285_ = _e816;
                            phi_1328_ = type_17(0u, type_17().member_1);
                        }
                        let _e841 = phi_1285_;
                        let _e843 = phi_1328_;
                        let _e846 = (bitcast<i32>(_e843.member) != 0i);
                        if _e846 {
                            phi_1288_ = (0.5lf * (_e818 + (_e809 / _e818)));
                        } else {
                            phi_1288_ = f64();
                        }
                        let _e851 = phi_1288_;
                        continue;
                        continuing {
                            phi_1284_ = _e841;
                            phi_1287_ = _e851;
                            break if !(_e846);
                        }
                    }
                    let _e856 = local_3;
                    phi_1341_ = (_e856 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e863 = phi_1341_;
                if (_e863 > f64(0f)) {
                    phi_1351_ = ((_e863 + (_e809 / _e863)) * f64(0.5f));
                } else {
                    phi_1351_ = _e863;
                }
                let _e871 = phi_1351_;
                if (_e871 > _e804) {
                    phi_1357_ = _e871;
                } else {
                    phi_1357_ = f64(0f);
                }
                let _e875 = phi_1357_;
                local = type_35(array<f64, 3>((_e489[0] * _e569), (_e489[1] * _e569), (_e489[2] * _e569)), array<f64, 3>(_e577, _e579, _e581), array<f64, 3>(_e583, _e585, _e587), array<f64, 3>(_e753, _e756, _e759), _e875, _e804, ((((((_e636 + _e484.member_3) + _e689) + _e740) * _e742) + _e745) * _e569));
                let _e881 = function_8((&local), _e159.member);
                if (_e881.member_3 <= 2.2250738585072014e-308lf) {
                    if (_e881.member_3 > 0.0lf) {
                        phi_1400_ = (1.464336215552873e-154lf * 2.0lf);
                    } else {
                        phi_1400_ = 0.0lf;
                    }
                    let _e936 = phi_1400_;
                    phi_1464_ = _e936;
                } else {
                    phi_1407_ = type_16(0i, 5i);
                    phi_1410_ = bitcast<f64>(((bitcast<u64>(_e881.member_3) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e891 = phi_1407_;
                        let _e893 = phi_1410_;
                        local_4 = _e893;
                        if (_e891.member < _e891.member_1) {
                            let _e900 = (_e891.member + 1i);
                            if ((false == (_e900 > _e891.member)) != false) {
                                phi_1431_ = true;
                            } else {
                                phi_1431_ = false;
                            }
                            let _e905 = phi_1431_;
                            if _e905 {
                                phi_1437_ = type_17(0u, type_17().member_1);
                            } else {
                                phi_1437_ = type_17(1u, _e900);
                            }
                            let _e910 = phi_1437_;
                            phi_1408_ = type_16(_e910.member_1, _e891.member_1);
                            phi_1451_ = type_17(1u, _e891.member);
                        } else {
                            phi_1408_ = _e891;
                            phi_1451_ = type_17(0u, type_17().member_1);
                        }
                        let _e916 = phi_1408_;
                        let _e918 = phi_1451_;
                        let _e921 = (bitcast<i32>(_e918.member) != 0i);
                        if _e921 {
                            phi_1411_ = (0.5lf * (_e893 + (_e881.member_3 / _e893)));
                        } else {
                            phi_1411_ = f64();
                        }
                        let _e926 = phi_1411_;
                        continue;
                        continuing {
                            phi_1407_ = _e916;
                            phi_1410_ = _e926;
                            break if !(_e921);
                        }
                    }
                    let _e931 = local_4;
                    phi_1464_ = (_e931 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e938 = phi_1464_;
                if (_e938 > f64(0f)) {
                    phi_1474_ = ((_e938 + (_e881.member_3 / _e938)) * f64(0.5f));
                } else {
                    phi_1474_ = _e938;
                }
                let _e946 = phi_1474_;
                if (_e159.member == 0u) {
                    phi_1480_ = _e320;
                } else {
                    phi_1480_ = -(_e320);
                }
                let _e950 = phi_1480_;
                let _e952 = function_2(_e484.member);
                let _e954 = function_2(_e484.member_1);
                let _e968 = function_2(_e484.member_2);
                let _e978 = (((_e952[0] - (_e954[0] * _e881.member)) - (_e968[0] * _e881.member_1)) * _e950);
                let _e979 = (((_e952[1] - (_e954[1] * _e881.member)) - (_e968[1] * _e881.member_1)) * _e950);
                let _e980 = (((_e952[2] - (_e954[2] * _e881.member)) - (_e968[2] * _e881.member_1)) * _e950);
                let _e982 = f64(0f);
                let _e983 = f64(1f);
                if (_e881.member > _e982) {
                    phi_1521_ = (_e881.member < _e983);
                } else {
                    phi_1521_ = false;
                }
                let _e989 = phi_1521_;
                if (_e881.member_1 > _e982) {
                    phi_1527_ = (_e881.member_1 < _e983);
                } else {
                    phi_1527_ = false;
                }
                let _e993 = phi_1527_;
                let _e994 = (_e950 > _e982);
                if _e989 {
                    if _e993 {
                        if _e994 {
                            phi_1543_ = ((_e881.member + _e881.member_1) < (_e983 - (1.1102230246251565e-16lf * f64(4f))));
                        } else {
                            phi_1543_ = true;
                        }
                        let _e1001 = phi_1543_;
                        phi_1544_ = _e1001;
                        phi_1545_ = false;
                    } else {
                        phi_1544_ = bool();
                        phi_1545_ = true;
                    }
                    let _e1003 = phi_1544_;
                    let _e1005 = phi_1545_;
                    phi_1546_ = _e1003;
                    phi_1547_ = _e1005;
                } else {
                    phi_1546_ = bool();
                    phi_1547_ = true;
                }
                let _e1007 = phi_1546_;
                let _e1009 = phi_1547_;
                if _e1009 {
                    phi_1551_ = false;
                } else {
                    phi_1551_ = _e1007;
                }
                let _e1011 = phi_1551_;
                let _e1013 = local.member_4;
                let _e1014 = (_e1013 > _e982);
                let _e1016 = local.member_3;
                let _e1020 = (_e1016[0] * _e950);
                let _e1021 = (_e1016[1] * _e950);
                let _e1022 = (_e1016[2] * _e950);
                let _e1025 = local.member_6;
                if (_e946 > _e1025) {
                    let _e2158 = (_e881.member_2[0] * _e950);
                    let _e2160 = (_e881.member_2[1] * _e950);
                    let _e2162 = (_e881.member_2[2] * _e950);
                    if _e1014 {
                        if _e1011 {
                            let _e2164 = local.member_5;
                            let _e2167 = local.member_6;
                            let _e2169 = local.member_4;
                            if ((_e2164 * _e946) <= (_e2167 * _e2169)) {
                                if ((((_e2158 * _e1020) + (_e2160 * _e1021)) + (_e2162 * _e1022)) >= _e982) {
                                    phi_1613_ = array<f64, 3>(_e1020, _e1021, _e1022);
                                } else {
                                    let _e2178 = -(_e983);
                                    phi_1613_ = array<f64, 3>((_e1020 * _e2178), (_e1021 * _e2178), (_e1022 * _e2178));
                                }
                                let _e2184 = phi_1613_;
                                if (_e2184[0] < 0.0lf) {
                                    phi_1620_ = -(_e2184[0]);
                                } else {
                                    phi_1620_ = _e2184[0];
                                }
                                let _e2189 = phi_1620_;
                                if (_e2184[1] < 0.0lf) {
                                    phi_1627_ = -(_e2184[1]);
                                } else {
                                    phi_1627_ = _e2184[1];
                                }
                                let _e2194 = phi_1627_;
                                if (_e2189 > _e2194) {
                                    phi_1632_ = _e2189;
                                } else {
                                    phi_1632_ = _e2194;
                                }
                                let _e2197 = phi_1632_;
                                if (_e2184[2] < 0.0lf) {
                                    phi_1639_ = -(_e2184[2]);
                                } else {
                                    phi_1639_ = _e2184[2];
                                }
                                let _e2202 = phi_1639_;
                                if (_e2197 > _e2202) {
                                    phi_1644_ = _e2197;
                                } else {
                                    phi_1644_ = _e2202;
                                }
                                let _e2205 = phi_1644_;
                                let _e2206 = function_9(_e2205);
                                let _e2208 = (_e2184[0] * _e2206);
                                let _e2210 = (_e2184[1] * _e2206);
                                let _e2212 = (_e2184[2] * _e2206);
                                let _e2218 = (((_e2208 * _e2208) + (_e2210 * _e2210)) + (_e2212 * _e2212));
                                if (_e2218 <= 2.2250738585072014e-308lf) {
                                    if (_e2218 > 0.0lf) {
                                        phi_1671_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_1671_ = 0.0lf;
                                    }
                                    let _e2270 = phi_1671_;
                                    phi_1735_ = _e2270;
                                } else {
                                    phi_1678_ = type_16(0i, 5i);
                                    phi_1681_ = bitcast<f64>(((bitcast<u64>(_e2218) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2225 = phi_1678_;
                                        let _e2227 = phi_1681_;
                                        local_11 = _e2227;
                                        if (_e2225.member < _e2225.member_1) {
                                            let _e2234 = (_e2225.member + 1i);
                                            if ((false == (_e2234 > _e2225.member)) != false) {
                                                phi_1702_ = true;
                                            } else {
                                                phi_1702_ = false;
                                            }
                                            let _e2239 = phi_1702_;
                                            if _e2239 {
                                                phi_1708_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_1708_ = type_17(1u, _e2234);
                                            }
                                            let _e2244 = phi_1708_;
                                            phi_1679_ = type_16(_e2244.member_1, _e2225.member_1);
                                            phi_1722_ = type_17(1u, _e2225.member);
                                        } else {
                                            phi_1679_ = _e2225;
                                            phi_1722_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2250 = phi_1679_;
                                        let _e2252 = phi_1722_;
                                        let _e2255 = (bitcast<i32>(_e2252.member) != 0i);
                                        if _e2255 {
                                            phi_1682_ = (0.5lf * (_e2227 + (_e2218 / _e2227)));
                                        } else {
                                            phi_1682_ = f64();
                                        }
                                        let _e2260 = phi_1682_;
                                        continue;
                                        continuing {
                                            phi_1678_ = _e2250;
                                            phi_1681_ = _e2260;
                                            break if !(_e2255);
                                        }
                                    }
                                    let _e2265 = local_11;
                                    phi_1735_ = (_e2265 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e2272 = phi_1735_;
                                let _e2273 = (f64(1f) / _e2272);
                                let _e2274 = (_e2208 * _e2273);
                                let _e2275 = (_e2210 * _e2273);
                                let _e2276 = (_e2212 * _e2273);
                                let _e2285 = ((f64(3f) - (((_e2274 * _e2274) + (_e2275 * _e2275)) + (_e2276 * _e2276))) * f64(0.5f));
                                phi_1753_ = array<f64, 3>((_e2274 * _e2285), (_e2275 * _e2285), (_e2276 * _e2285));
                                phi_1754_ = false;
                            } else {
                                phi_1753_ = array<f64, 3>();
                                phi_1754_ = true;
                            }
                            let _e2291 = phi_1753_;
                            let _e2293 = phi_1754_;
                            phi_1755_ = _e2291;
                            phi_1756_ = _e2293;
                        } else {
                            phi_1755_ = array<f64, 3>();
                            phi_1756_ = true;
                        }
                        let _e2295 = phi_1755_;
                        let _e2297 = phi_1756_;
                        phi_1757_ = _e2295;
                        phi_1758_ = _e2297;
                    } else {
                        phi_1757_ = array<f64, 3>();
                        phi_1758_ = true;
                    }
                    let _e2299 = phi_1757_;
                    let _e2301 = phi_1758_;
                    if _e2301 {
                        if (_e2158 < 0.0lf) {
                            phi_1767_ = -(_e2158);
                        } else {
                            phi_1767_ = _e2158;
                        }
                        let _e2305 = phi_1767_;
                        if (_e2160 < 0.0lf) {
                            phi_1773_ = -(_e2160);
                        } else {
                            phi_1773_ = _e2160;
                        }
                        let _e2309 = phi_1773_;
                        if (_e2305 > _e2309) {
                            phi_1778_ = _e2305;
                        } else {
                            phi_1778_ = _e2309;
                        }
                        let _e2312 = phi_1778_;
                        if (_e2162 < 0.0lf) {
                            phi_1784_ = -(_e2162);
                        } else {
                            phi_1784_ = _e2162;
                        }
                        let _e2316 = phi_1784_;
                        if (_e2312 > _e2316) {
                            phi_1789_ = _e2312;
                        } else {
                            phi_1789_ = _e2316;
                        }
                        let _e2319 = phi_1789_;
                        let _e2320 = function_9(_e2319);
                        let _e2321 = (_e2158 * _e2320);
                        let _e2322 = (_e2160 * _e2320);
                        let _e2323 = (_e2162 * _e2320);
                        let _e2329 = (((_e2321 * _e2321) + (_e2322 * _e2322)) + (_e2323 * _e2323));
                        if (_e2329 <= 2.2250738585072014e-308lf) {
                            if (_e2329 > 0.0lf) {
                                phi_1813_ = (1.464336215552873e-154lf * 2.0lf);
                            } else {
                                phi_1813_ = 0.0lf;
                            }
                            let _e2381 = phi_1813_;
                            phi_1877_ = _e2381;
                        } else {
                            phi_1820_ = type_16(0i, 5i);
                            phi_1823_ = bitcast<f64>(((bitcast<u64>(_e2329) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e2336 = phi_1820_;
                                let _e2338 = phi_1823_;
                                local_12 = _e2338;
                                if (_e2336.member < _e2336.member_1) {
                                    let _e2345 = (_e2336.member + 1i);
                                    if ((false == (_e2345 > _e2336.member)) != false) {
                                        phi_1844_ = true;
                                    } else {
                                        phi_1844_ = false;
                                    }
                                    let _e2350 = phi_1844_;
                                    if _e2350 {
                                        phi_1850_ = type_17(0u, type_17().member_1);
                                    } else {
                                        phi_1850_ = type_17(1u, _e2345);
                                    }
                                    let _e2355 = phi_1850_;
                                    phi_1821_ = type_16(_e2355.member_1, _e2336.member_1);
                                    phi_1864_ = type_17(1u, _e2336.member);
                                } else {
                                    phi_1821_ = _e2336;
                                    phi_1864_ = type_17(0u, type_17().member_1);
                                }
                                let _e2361 = phi_1821_;
                                let _e2363 = phi_1864_;
                                let _e2366 = (bitcast<i32>(_e2363.member) != 0i);
                                if _e2366 {
                                    phi_1824_ = (0.5lf * (_e2338 + (_e2329 / _e2338)));
                                } else {
                                    phi_1824_ = f64();
                                }
                                let _e2371 = phi_1824_;
                                continue;
                                continuing {
                                    phi_1820_ = _e2361;
                                    phi_1823_ = _e2371;
                                    break if !(_e2366);
                                }
                            }
                            let _e2376 = local_12;
                            phi_1877_ = (_e2376 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e2383 = phi_1877_;
                        let _e2384 = (f64(1f) / _e2383);
                        let _e2385 = (_e2321 * _e2384);
                        let _e2386 = (_e2322 * _e2384);
                        let _e2387 = (_e2323 * _e2384);
                        let _e2396 = ((f64(3f) - (((_e2385 * _e2385) + (_e2386 * _e2386)) + (_e2387 * _e2387))) * f64(0.5f));
                        phi_1895_ = array<f64, 3>((_e2385 * _e2396), (_e2386 * _e2396), (_e2387 * _e2396));
                    } else {
                        phi_1895_ = _e2299;
                    }
                    let _e2402 = phi_1895_;
                    phi_3434_ = _e2402;
                    phi_3435_ = array<f64, 3>();
                    phi_3436_ = true;
                } else {
                    if (_e484.member[0][0] < 0.0lf) {
                        phi_1903_ = -(_e484.member[0][0]);
                    } else {
                        phi_1903_ = _e484.member[0][0];
                    }
                    let _e1033 = phi_1903_;
                    if (_e484.member[0][1] < 0.0lf) {
                        phi_1910_ = -(_e484.member[0][1]);
                    } else {
                        phi_1910_ = _e484.member[0][1];
                    }
                    let _e1038 = phi_1910_;
                    if (_e1033 > _e1038) {
                        phi_1915_ = _e1033;
                    } else {
                        phi_1915_ = _e1038;
                    }
                    let _e1041 = phi_1915_;
                    if (_e484.member[0][2] < 0.0lf) {
                        phi_1922_ = -(_e484.member[0][2]);
                    } else {
                        phi_1922_ = _e484.member[0][2];
                    }
                    let _e1046 = phi_1922_;
                    if (_e1041 > _e1046) {
                        phi_1927_ = _e1041;
                    } else {
                        phi_1927_ = _e1046;
                    }
                    let _e1049 = phi_1927_;
                    if (_e484.member[1][0] < 0.0lf) {
                        phi_1935_ = -(_e484.member[1][0]);
                    } else {
                        phi_1935_ = _e484.member[1][0];
                    }
                    let _e1056 = phi_1935_;
                    if (_e484.member[1][1] < 0.0lf) {
                        phi_1942_ = -(_e484.member[1][1]);
                    } else {
                        phi_1942_ = _e484.member[1][1];
                    }
                    let _e1061 = phi_1942_;
                    if (_e1056 > _e1061) {
                        phi_1947_ = _e1056;
                    } else {
                        phi_1947_ = _e1061;
                    }
                    let _e1064 = phi_1947_;
                    if (_e484.member[1][2] < 0.0lf) {
                        phi_1954_ = -(_e484.member[1][2]);
                    } else {
                        phi_1954_ = _e484.member[1][2];
                    }
                    let _e1069 = phi_1954_;
                    if (_e1064 > _e1069) {
                        phi_1959_ = _e1064;
                    } else {
                        phi_1959_ = _e1069;
                    }
                    let _e1072 = phi_1959_;
                    if (_e1049 > _e1072) {
                        phi_1964_ = _e1049;
                    } else {
                        phi_1964_ = _e1072;
                    }
                    let _e1075 = phi_1964_;
                    if (_e484.member_1[0][0] < 0.0lf) {
                        phi_1974_ = -(_e484.member_1[0][0]);
                    } else {
                        phi_1974_ = _e484.member_1[0][0];
                    }
                    let _e1084 = phi_1974_;
                    if (_e484.member_1[0][1] < 0.0lf) {
                        phi_1981_ = -(_e484.member_1[0][1]);
                    } else {
                        phi_1981_ = _e484.member_1[0][1];
                    }
                    let _e1089 = phi_1981_;
                    if (_e1084 > _e1089) {
                        phi_1986_ = _e1084;
                    } else {
                        phi_1986_ = _e1089;
                    }
                    let _e1092 = phi_1986_;
                    if (_e484.member_1[0][2] < 0.0lf) {
                        phi_1993_ = -(_e484.member_1[0][2]);
                    } else {
                        phi_1993_ = _e484.member_1[0][2];
                    }
                    let _e1097 = phi_1993_;
                    if (_e1092 > _e1097) {
                        phi_1998_ = _e1092;
                    } else {
                        phi_1998_ = _e1097;
                    }
                    let _e1100 = phi_1998_;
                    if (_e484.member_1[1][0] < 0.0lf) {
                        phi_2006_ = -(_e484.member_1[1][0]);
                    } else {
                        phi_2006_ = _e484.member_1[1][0];
                    }
                    let _e1107 = phi_2006_;
                    if (_e484.member_1[1][1] < 0.0lf) {
                        phi_2013_ = -(_e484.member_1[1][1]);
                    } else {
                        phi_2013_ = _e484.member_1[1][1];
                    }
                    let _e1112 = phi_2013_;
                    if (_e1107 > _e1112) {
                        phi_2018_ = _e1107;
                    } else {
                        phi_2018_ = _e1112;
                    }
                    let _e1115 = phi_2018_;
                    if (_e484.member_1[1][2] < 0.0lf) {
                        phi_2025_ = -(_e484.member_1[1][2]);
                    } else {
                        phi_2025_ = _e484.member_1[1][2];
                    }
                    let _e1120 = phi_2025_;
                    if (_e1115 > _e1120) {
                        phi_2030_ = _e1115;
                    } else {
                        phi_2030_ = _e1120;
                    }
                    let _e1123 = phi_2030_;
                    if (_e1100 > _e1123) {
                        phi_2035_ = _e1100;
                    } else {
                        phi_2035_ = _e1123;
                    }
                    let _e1126 = phi_2035_;
                    if (_e484.member_2[0][0] < 0.0lf) {
                        phi_2045_ = -(_e484.member_2[0][0]);
                    } else {
                        phi_2045_ = _e484.member_2[0][0];
                    }
                    let _e1135 = phi_2045_;
                    if (_e484.member_2[0][1] < 0.0lf) {
                        phi_2052_ = -(_e484.member_2[0][1]);
                    } else {
                        phi_2052_ = _e484.member_2[0][1];
                    }
                    let _e1140 = phi_2052_;
                    if (_e1135 > _e1140) {
                        phi_2057_ = _e1135;
                    } else {
                        phi_2057_ = _e1140;
                    }
                    let _e1143 = phi_2057_;
                    if (_e484.member_2[0][2] < 0.0lf) {
                        phi_2064_ = -(_e484.member_2[0][2]);
                    } else {
                        phi_2064_ = _e484.member_2[0][2];
                    }
                    let _e1148 = phi_2064_;
                    if (_e1143 > _e1148) {
                        phi_2069_ = _e1143;
                    } else {
                        phi_2069_ = _e1148;
                    }
                    let _e1151 = phi_2069_;
                    if (_e484.member_2[1][0] < 0.0lf) {
                        phi_2077_ = -(_e484.member_2[1][0]);
                    } else {
                        phi_2077_ = _e484.member_2[1][0];
                    }
                    let _e1158 = phi_2077_;
                    if (_e484.member_2[1][1] < 0.0lf) {
                        phi_2084_ = -(_e484.member_2[1][1]);
                    } else {
                        phi_2084_ = _e484.member_2[1][1];
                    }
                    let _e1163 = phi_2084_;
                    if (_e1158 > _e1163) {
                        phi_2089_ = _e1158;
                    } else {
                        phi_2089_ = _e1163;
                    }
                    let _e1166 = phi_2089_;
                    if (_e484.member_2[1][2] < 0.0lf) {
                        phi_2096_ = -(_e484.member_2[1][2]);
                    } else {
                        phi_2096_ = _e484.member_2[1][2];
                    }
                    let _e1171 = phi_2096_;
                    if (_e1166 > _e1171) {
                        phi_2101_ = _e1166;
                    } else {
                        phi_2101_ = _e1171;
                    }
                    let _e1174 = phi_2101_;
                    if (_e1151 > _e1174) {
                        phi_2106_ = _e1151;
                    } else {
                        phi_2106_ = _e1174;
                    }
                    let _e1177 = phi_2106_;
                    let _e1188 = (((((_e1075 + _e484.member_3) + (_e1126 + _e484.member_3)) + (_e1177 + _e484.member_3)) * (1.1102230246251565e-16lf * f64(32f))) + (_e484.member_3 * f64(8f)));
                    if _e1014 {
                        if (_e1020 < 0.0lf) {
                            phi_2126_ = -(_e1020);
                        } else {
                            phi_2126_ = _e1020;
                        }
                        let _e1192 = phi_2126_;
                        if (_e1021 < 0.0lf) {
                            phi_2132_ = -(_e1021);
                        } else {
                            phi_2132_ = _e1021;
                        }
                        let _e1196 = phi_2132_;
                        if (_e1192 > _e1196) {
                            phi_2137_ = _e1192;
                        } else {
                            phi_2137_ = _e1196;
                        }
                        let _e1199 = phi_2137_;
                        if (_e1022 < 0.0lf) {
                            phi_2143_ = -(_e1022);
                        } else {
                            phi_2143_ = _e1022;
                        }
                        let _e1203 = phi_2143_;
                        if (_e1199 > _e1203) {
                            phi_2148_ = _e1199;
                        } else {
                            phi_2148_ = _e1203;
                        }
                        let _e1206 = phi_2148_;
                        let _e1207 = function_9(_e1206);
                        let _e1208 = (_e1020 * _e1207);
                        let _e1209 = (_e1021 * _e1207);
                        let _e1210 = (_e1022 * _e1207);
                        let _e1216 = (((_e1208 * _e1208) + (_e1209 * _e1209)) + (_e1210 * _e1210));
                        if (_e1216 <= 2.2250738585072014e-308lf) {
                            if (_e1216 > 0.0lf) {
                                phi_2172_ = (1.464336215552873e-154lf * 2.0lf);
                            } else {
                                phi_2172_ = 0.0lf;
                            }
                            let _e1268 = phi_2172_;
                            phi_2236_ = _e1268;
                        } else {
                            phi_2179_ = type_16(0i, 5i);
                            phi_2182_ = bitcast<f64>(((bitcast<u64>(_e1216) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1223 = phi_2179_;
                                let _e1225 = phi_2182_;
                                local_5 = _e1225;
                                if (_e1223.member < _e1223.member_1) {
                                    let _e1232 = (_e1223.member + 1i);
                                    if ((false == (_e1232 > _e1223.member)) != false) {
                                        phi_2203_ = true;
                                    } else {
                                        phi_2203_ = false;
                                    }
                                    let _e1237 = phi_2203_;
                                    if _e1237 {
                                        phi_2209_ = type_17(0u, type_17().member_1);
                                    } else {
                                        phi_2209_ = type_17(1u, _e1232);
                                    }
                                    let _e1242 = phi_2209_;
                                    phi_2180_ = type_16(_e1242.member_1, _e1223.member_1);
                                    phi_2223_ = type_17(1u, _e1223.member);
                                } else {
                                    phi_2180_ = _e1223;
                                    phi_2223_ = type_17(0u, type_17().member_1);
                                }
                                let _e1248 = phi_2180_;
                                let _e1250 = phi_2223_;
                                let _e1253 = (bitcast<i32>(_e1250.member) != 0i);
                                if _e1253 {
                                    phi_2183_ = (0.5lf * (_e1225 + (_e1216 / _e1225)));
                                } else {
                                    phi_2183_ = f64();
                                }
                                let _e1258 = phi_2183_;
                                continue;
                                continuing {
                                    phi_2179_ = _e1248;
                                    phi_2182_ = _e1258;
                                    break if !(_e1253);
                                }
                            }
                            let _e1263 = local_5;
                            phi_2236_ = (_e1263 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1270 = phi_2236_;
                        let _e1271 = (f64(1f) / _e1270);
                        let _e1272 = (_e1208 * _e1271);
                        let _e1273 = (_e1209 * _e1271);
                        let _e1274 = (_e1210 * _e1271);
                        let _e1283 = ((f64(3f) - (((_e1272 * _e1272) + (_e1273 * _e1273)) + (_e1274 * _e1274))) * f64(0.5f));
                        let _e1284 = (_e1272 * _e1283);
                        let _e1285 = (_e1273 * _e1283);
                        let _e1286 = (_e1274 * _e1283);
                        let _e1292 = (((_e978 * _e1284) + (_e979 * _e1285)) + (_e980 * _e1286));
                        if (_e978 < 0.0lf) {
                            phi_2264_ = -(_e978);
                        } else {
                            phi_2264_ = _e978;
                        }
                        let _e1296 = phi_2264_;
                        if (_e979 < 0.0lf) {
                            phi_2270_ = -(_e979);
                        } else {
                            phi_2270_ = _e979;
                        }
                        let _e1300 = phi_2270_;
                        if (_e980 < 0.0lf) {
                            phi_2277_ = -(_e980);
                        } else {
                            phi_2277_ = _e980;
                        }
                        let _e1305 = phi_2277_;
                        let _e1308 = local.member_5;
                        let _e1310 = local.member_4;
                        if (_e1292 < 0.0lf) {
                            phi_2291_ = -(_e1292);
                        } else {
                            phi_2291_ = _e1292;
                        }
                        let _e1317 = phi_2291_;
                        if (_e1317 > (_e1188 + (((_e1296 + _e1300) + _e1305) * (_e1308 / _e1310)))) {
                            if (_e1292 < _e982) {
                                phi_2305_ = array<f64, 3>(_e1284, _e1285, _e1286);
                            } else {
                                let _e1320 = -(_e983);
                                phi_2305_ = array<f64, 3>((_e1284 * _e1320), (_e1285 * _e1320), (_e1286 * _e1320));
                            }
                            let _e1326 = phi_2305_;
                            phi_2306_ = _e1326;
                            phi_2307_ = false;
                        } else {
                            phi_2306_ = array<f64, 3>();
                            phi_2307_ = true;
                        }
                        let _e1328 = phi_2306_;
                        let _e1330 = phi_2307_;
                        phi_2308_ = _e1328;
                        phi_2309_ = _e1330;
                    } else {
                        phi_2308_ = array<f64, 3>();
                        phi_2309_ = true;
                    }
                    let _e1332 = phi_2308_;
                    let _e1334 = phi_2309_;
                    if _e1334 {
                        if _e1014 {
                            if _e1011 {
                                phi_2319_ = false;
                            } else {
                                phi_2319_ = true;
                            }
                            let _e1336 = phi_2319_;
                            phi_2320_ = _e1336;
                        } else {
                            phi_2320_ = true;
                        }
                        let _e1338 = phi_2320_;
                        if _e1338 {
                            if _e994 {
                                if _e989 {
                                    if _e993 {
                                        let _e1340 = local.member_2;
                                        let _e1345 = local.member_1;
                                        phi_2355_ = array<f64, 3>((_e1340[0] - _e1345[0]), (_e1340[1] - _e1345[1]), (_e1340[2] - _e1345[2]));
                                        phi_2356_ = false;
                                    } else {
                                        phi_2355_ = array<f64, 3>();
                                        phi_2356_ = true;
                                    }
                                    let _e1354 = phi_2355_;
                                    let _e1356 = phi_2356_;
                                    phi_2357_ = _e1354;
                                    phi_2358_ = _e1356;
                                } else {
                                    phi_2357_ = array<f64, 3>();
                                    phi_2358_ = true;
                                }
                                let _e1358 = phi_2357_;
                                let _e1360 = phi_2358_;
                                phi_2359_ = _e1358;
                                phi_2360_ = _e1360;
                            } else {
                                phi_2359_ = array<f64, 3>();
                                phi_2360_ = true;
                            }
                            let _e1362 = phi_2359_;
                            let _e1364 = phi_2360_;
                            if _e1364 {
                                if _e989 {
                                    if _e993 {
                                        let _e1366 = local.member_2;
                                        if (_e1366[0] < 0.0lf) {
                                            phi_2382_ = -(_e1366[0]);
                                        } else {
                                            phi_2382_ = _e1366[0];
                                        }
                                        let _e1373 = phi_2382_;
                                        if (_e1366[1] < 0.0lf) {
                                            phi_2389_ = -(_e1366[1]);
                                        } else {
                                            phi_2389_ = _e1366[1];
                                        }
                                        let _e1377 = phi_2389_;
                                        if (_e1373 > _e1377) {
                                            phi_2394_ = _e1373;
                                        } else {
                                            phi_2394_ = _e1377;
                                        }
                                        let _e1380 = phi_2394_;
                                        if (_e1366[2] < 0.0lf) {
                                            phi_2401_ = -(_e1366[2]);
                                        } else {
                                            phi_2401_ = _e1366[2];
                                        }
                                        let _e1384 = phi_2401_;
                                        if (_e1380 > _e1384) {
                                            phi_2406_ = _e1380;
                                        } else {
                                            phi_2406_ = _e1384;
                                        }
                                        let _e1387 = phi_2406_;
                                        let _e1389 = local.member_1;
                                        if (_e1389[0] < 0.0lf) {
                                            phi_2419_ = -(_e1389[0]);
                                        } else {
                                            phi_2419_ = _e1389[0];
                                        }
                                        let _e1396 = phi_2419_;
                                        if (_e1389[1] < 0.0lf) {
                                            phi_2426_ = -(_e1389[1]);
                                        } else {
                                            phi_2426_ = _e1389[1];
                                        }
                                        let _e1400 = phi_2426_;
                                        if (_e1396 > _e1400) {
                                            phi_2431_ = _e1396;
                                        } else {
                                            phi_2431_ = _e1400;
                                        }
                                        let _e1403 = phi_2431_;
                                        if (_e1389[2] < 0.0lf) {
                                            phi_2438_ = -(_e1389[2]);
                                        } else {
                                            phi_2438_ = _e1389[2];
                                        }
                                        let _e1407 = phi_2438_;
                                        if (_e1403 > _e1407) {
                                            phi_2443_ = _e1403;
                                        } else {
                                            phi_2443_ = _e1407;
                                        }
                                        let _e1410 = phi_2443_;
                                        if (_e1387 > _e1410) {
                                            phi_2448_ = false;
                                        } else {
                                            phi_2448_ = true;
                                        }
                                        let _e1413 = phi_2448_;
                                        phi_2449_ = _e1413;
                                    } else {
                                        phi_2449_ = true;
                                    }
                                    let _e1415 = phi_2449_;
                                    if _e1415 {
                                        let _e1417 = local.member_1;
                                        phi_2459_ = array<f64, 3>(_e1417[0], _e1417[1], _e1417[2]);
                                        phi_2460_ = false;
                                    } else {
                                        phi_2459_ = array<f64, 3>();
                                        phi_2460_ = true;
                                    }
                                    let _e1423 = phi_2459_;
                                    let _e1425 = phi_2460_;
                                    phi_2461_ = _e1423;
                                    phi_2462_ = _e1425;
                                } else {
                                    phi_2461_ = array<f64, 3>();
                                    phi_2462_ = true;
                                }
                                let _e1427 = phi_2461_;
                                let _e1429 = phi_2462_;
                                if _e1429 {
                                    if _e993 {
                                        let _e1432 = local.member_2;
                                        phi_2476_ = array<f64, 3>(_e1432[0], _e1432[1], _e1432[2]);
                                    } else {
                                        phi_2476_ = array<f64, 3>(_e982, _e982, _e982);
                                    }
                                    let _e1438 = phi_2476_;
                                    phi_2477_ = _e1438;
                                } else {
                                    phi_2477_ = _e1427;
                                }
                                let _e1440 = phi_2477_;
                                phi_2478_ = _e1440;
                            } else {
                                phi_2478_ = _e1362;
                            }
                            let _e1442 = phi_2478_;
                            if (_e1442[0] < 0.0lf) {
                                phi_2485_ = -(_e1442[0]);
                            } else {
                                phi_2485_ = _e1442[0];
                            }
                            let _e1447 = phi_2485_;
                            if (_e1442[1] < 0.0lf) {
                                phi_2492_ = -(_e1442[1]);
                            } else {
                                phi_2492_ = _e1442[1];
                            }
                            let _e1452 = phi_2492_;
                            if (_e1447 > _e1452) {
                                phi_2497_ = _e1447;
                            } else {
                                phi_2497_ = _e1452;
                            }
                            let _e1455 = phi_2497_;
                            if (_e1442[2] < 0.0lf) {
                                phi_2504_ = -(_e1442[2]);
                            } else {
                                phi_2504_ = _e1442[2];
                            }
                            let _e1460 = phi_2504_;
                            if (_e1455 > _e1460) {
                                phi_2509_ = _e1455;
                            } else {
                                phi_2509_ = _e1460;
                            }
                            let _e1463 = phi_2509_;
                            if (_e1463 > f64(0f)) {
                                if (_e1442[0] < 0.0lf) {
                                    phi_2521_ = -(_e1442[0]);
                                } else {
                                    phi_2521_ = _e1442[0];
                                }
                                let _e1470 = phi_2521_;
                                if (_e1442[1] < 0.0lf) {
                                    phi_2528_ = -(_e1442[1]);
                                } else {
                                    phi_2528_ = _e1442[1];
                                }
                                let _e1475 = phi_2528_;
                                if (_e1470 > _e1475) {
                                    phi_2533_ = _e1470;
                                } else {
                                    phi_2533_ = _e1475;
                                }
                                let _e1478 = phi_2533_;
                                if (_e1442[2] < 0.0lf) {
                                    phi_2540_ = -(_e1442[2]);
                                } else {
                                    phi_2540_ = _e1442[2];
                                }
                                let _e1483 = phi_2540_;
                                if (_e1478 > _e1483) {
                                    phi_2545_ = _e1478;
                                } else {
                                    phi_2545_ = _e1483;
                                }
                                let _e1486 = phi_2545_;
                                let _e1487 = function_9(_e1486);
                                let _e1489 = (_e1442[0] * _e1487);
                                let _e1491 = (_e1442[1] * _e1487);
                                let _e1493 = (_e1442[2] * _e1487);
                                let _e1499 = (((_e1489 * _e1489) + (_e1491 * _e1491)) + (_e1493 * _e1493));
                                if (_e1499 <= 2.2250738585072014e-308lf) {
                                    if (_e1499 > 0.0lf) {
                                        phi_2572_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_2572_ = 0.0lf;
                                    }
                                    let _e1551 = phi_2572_;
                                    phi_2636_ = _e1551;
                                } else {
                                    phi_2579_ = type_16(0i, 5i);
                                    phi_2582_ = bitcast<f64>(((bitcast<u64>(_e1499) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1506 = phi_2579_;
                                        let _e1508 = phi_2582_;
                                        local_6 = _e1508;
                                        if (_e1506.member < _e1506.member_1) {
                                            let _e1515 = (_e1506.member + 1i);
                                            if ((false == (_e1515 > _e1506.member)) != false) {
                                                phi_2603_ = true;
                                            } else {
                                                phi_2603_ = false;
                                            }
                                            let _e1520 = phi_2603_;
                                            if _e1520 {
                                                phi_2609_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_2609_ = type_17(1u, _e1515);
                                            }
                                            let _e1525 = phi_2609_;
                                            phi_2580_ = type_16(_e1525.member_1, _e1506.member_1);
                                            phi_2623_ = type_17(1u, _e1506.member);
                                        } else {
                                            phi_2580_ = _e1506;
                                            phi_2623_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1531 = phi_2580_;
                                        let _e1533 = phi_2623_;
                                        let _e1536 = (bitcast<i32>(_e1533.member) != 0i);
                                        if _e1536 {
                                            phi_2583_ = (0.5lf * (_e1508 + (_e1499 / _e1508)));
                                        } else {
                                            phi_2583_ = f64();
                                        }
                                        let _e1541 = phi_2583_;
                                        continue;
                                        continuing {
                                            phi_2579_ = _e1531;
                                            phi_2582_ = _e1541;
                                            break if !(_e1536);
                                        }
                                    }
                                    let _e1546 = local_6;
                                    phi_2636_ = (_e1546 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1553 = phi_2636_;
                                let _e1554 = (f64(1f) / _e1553);
                                let _e1555 = (_e1489 * _e1554);
                                let _e1556 = (_e1491 * _e1554);
                                let _e1557 = (_e1493 * _e1554);
                                let _e1566 = ((f64(3f) - (((_e1555 * _e1555) + (_e1556 * _e1556)) + (_e1557 * _e1557))) * f64(0.5f));
                                let _e1567 = (_e1555 * _e1566);
                                let _e1568 = (_e1556 * _e1566);
                                let _e1569 = (_e1557 * _e1566);
                                let _e1574 = (((_e978 * _e1567) + (_e979 * _e1568)) + (_e980 * _e1569));
                                phi_2665_ = array<f64, 3>((_e978 - (_e1567 * _e1574)), (_e979 - (_e1568 * _e1574)), (_e980 - (_e1569 * _e1574)));
                            } else {
                                phi_2665_ = array<f64, 3>(_e978, _e979, _e980);
                            }
                            let _e1583 = phi_2665_;
                            if (_e1583[0] < 0.0lf) {
                                phi_2672_ = -(_e1583[0]);
                            } else {
                                phi_2672_ = _e1583[0];
                            }
                            let _e1588 = phi_2672_;
                            if (_e1583[1] < 0.0lf) {
                                phi_2679_ = -(_e1583[1]);
                            } else {
                                phi_2679_ = _e1583[1];
                            }
                            let _e1593 = phi_2679_;
                            if (_e1583[2] < 0.0lf) {
                                phi_2687_ = -(_e1583[2]);
                            } else {
                                phi_2687_ = _e1583[2];
                            }
                            let _e1599 = phi_2687_;
                            if (((_e1588 + _e1593) + _e1599) > _e1188) {
                                let _e1602 = -(_e983);
                                let _e1604 = (_e1583[0] * _e1602);
                                let _e1606 = (_e1583[1] * _e1602);
                                let _e1608 = (_e1583[2] * _e1602);
                                if (_e1604 < 0.0lf) {
                                    phi_2705_ = -(_e1604);
                                } else {
                                    phi_2705_ = _e1604;
                                }
                                let _e1612 = phi_2705_;
                                if (_e1606 < 0.0lf) {
                                    phi_2711_ = -(_e1606);
                                } else {
                                    phi_2711_ = _e1606;
                                }
                                let _e1616 = phi_2711_;
                                if (_e1612 > _e1616) {
                                    phi_2716_ = _e1612;
                                } else {
                                    phi_2716_ = _e1616;
                                }
                                let _e1619 = phi_2716_;
                                if (_e1608 < 0.0lf) {
                                    phi_2722_ = -(_e1608);
                                } else {
                                    phi_2722_ = _e1608;
                                }
                                let _e1623 = phi_2722_;
                                if (_e1619 > _e1623) {
                                    phi_2727_ = _e1619;
                                } else {
                                    phi_2727_ = _e1623;
                                }
                                let _e1626 = phi_2727_;
                                let _e1627 = function_9(_e1626);
                                let _e1628 = (_e1604 * _e1627);
                                let _e1629 = (_e1606 * _e1627);
                                let _e1630 = (_e1608 * _e1627);
                                let _e1636 = (((_e1628 * _e1628) + (_e1629 * _e1629)) + (_e1630 * _e1630));
                                if (_e1636 <= 2.2250738585072014e-308lf) {
                                    if (_e1636 > 0.0lf) {
                                        phi_2751_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_2751_ = 0.0lf;
                                    }
                                    let _e1688 = phi_2751_;
                                    phi_2815_ = _e1688;
                                } else {
                                    phi_2758_ = type_16(0i, 5i);
                                    phi_2761_ = bitcast<f64>(((bitcast<u64>(_e1636) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1643 = phi_2758_;
                                        let _e1645 = phi_2761_;
                                        local_7 = _e1645;
                                        if (_e1643.member < _e1643.member_1) {
                                            let _e1652 = (_e1643.member + 1i);
                                            if ((false == (_e1652 > _e1643.member)) != false) {
                                                phi_2782_ = true;
                                            } else {
                                                phi_2782_ = false;
                                            }
                                            let _e1657 = phi_2782_;
                                            if _e1657 {
                                                phi_2788_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_2788_ = type_17(1u, _e1652);
                                            }
                                            let _e1662 = phi_2788_;
                                            phi_2759_ = type_16(_e1662.member_1, _e1643.member_1);
                                            phi_2802_ = type_17(1u, _e1643.member);
                                        } else {
                                            phi_2759_ = _e1643;
                                            phi_2802_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1668 = phi_2759_;
                                        let _e1670 = phi_2802_;
                                        let _e1673 = (bitcast<i32>(_e1670.member) != 0i);
                                        if _e1673 {
                                            phi_2762_ = (0.5lf * (_e1645 + (_e1636 / _e1645)));
                                        } else {
                                            phi_2762_ = f64();
                                        }
                                        let _e1678 = phi_2762_;
                                        continue;
                                        continuing {
                                            phi_2758_ = _e1668;
                                            phi_2761_ = _e1678;
                                            break if !(_e1673);
                                        }
                                    }
                                    let _e1683 = local_7;
                                    phi_2815_ = (_e1683 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1690 = phi_2815_;
                                let _e1691 = (f64(1f) / _e1690);
                                let _e1692 = (_e1628 * _e1691);
                                let _e1693 = (_e1629 * _e1691);
                                let _e1694 = (_e1630 * _e1691);
                                let _e1703 = ((f64(3f) - (((_e1692 * _e1692) + (_e1693 * _e1693)) + (_e1694 * _e1694))) * f64(0.5f));
                                phi_2833_ = array<f64, 3>((_e1692 * _e1703), (_e1693 * _e1703), (_e1694 * _e1703));
                                phi_2834_ = false;
                            } else {
                                phi_2833_ = array<f64, 3>();
                                phi_2834_ = true;
                            }
                            let _e1709 = phi_2833_;
                            let _e1711 = phi_2834_;
                            phi_2835_ = _e1709;
                            phi_2836_ = _e1711;
                        } else {
                            phi_2835_ = array<f64, 3>();
                            phi_2836_ = true;
                        }
                        let _e1713 = phi_2835_;
                        let _e1715 = phi_2836_;
                        if _e1715 {
                            if _e1014 {
                                if (_e1020 < 0.0lf) {
                                    phi_2848_ = -(_e1020);
                                } else {
                                    phi_2848_ = _e1020;
                                }
                                let _e2048 = phi_2848_;
                                if (_e1021 < 0.0lf) {
                                    phi_2854_ = -(_e1021);
                                } else {
                                    phi_2854_ = _e1021;
                                }
                                let _e2052 = phi_2854_;
                                if (_e2048 > _e2052) {
                                    phi_2859_ = _e2048;
                                } else {
                                    phi_2859_ = _e2052;
                                }
                                let _e2055 = phi_2859_;
                                if (_e1022 < 0.0lf) {
                                    phi_2865_ = -(_e1022);
                                } else {
                                    phi_2865_ = _e1022;
                                }
                                let _e2059 = phi_2865_;
                                if (_e2055 > _e2059) {
                                    phi_2870_ = _e2055;
                                } else {
                                    phi_2870_ = _e2059;
                                }
                                let _e2062 = phi_2870_;
                                let _e2063 = function_9(_e2062);
                                let _e2064 = (_e1020 * _e2063);
                                let _e2065 = (_e1021 * _e2063);
                                let _e2066 = (_e1022 * _e2063);
                                let _e2072 = (((_e2064 * _e2064) + (_e2065 * _e2065)) + (_e2066 * _e2066));
                                if (_e2072 <= 2.2250738585072014e-308lf) {
                                    if (_e2072 > 0.0lf) {
                                        phi_2894_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_2894_ = 0.0lf;
                                    }
                                    let _e2124 = phi_2894_;
                                    phi_2958_ = _e2124;
                                } else {
                                    phi_2901_ = type_16(0i, 5i);
                                    phi_2904_ = bitcast<f64>(((bitcast<u64>(_e2072) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2079 = phi_2901_;
                                        let _e2081 = phi_2904_;
                                        local_10 = _e2081;
                                        if (_e2079.member < _e2079.member_1) {
                                            let _e2088 = (_e2079.member + 1i);
                                            if ((false == (_e2088 > _e2079.member)) != false) {
                                                phi_2925_ = true;
                                            } else {
                                                phi_2925_ = false;
                                            }
                                            let _e2093 = phi_2925_;
                                            if _e2093 {
                                                phi_2931_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_2931_ = type_17(1u, _e2088);
                                            }
                                            let _e2098 = phi_2931_;
                                            phi_2902_ = type_16(_e2098.member_1, _e2079.member_1);
                                            phi_2945_ = type_17(1u, _e2079.member);
                                        } else {
                                            phi_2902_ = _e2079;
                                            phi_2945_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2104 = phi_2902_;
                                        let _e2106 = phi_2945_;
                                        let _e2109 = (bitcast<i32>(_e2106.member) != 0i);
                                        if _e2109 {
                                            phi_2905_ = (0.5lf * (_e2081 + (_e2072 / _e2081)));
                                        } else {
                                            phi_2905_ = f64();
                                        }
                                        let _e2114 = phi_2905_;
                                        continue;
                                        continuing {
                                            phi_2901_ = _e2104;
                                            phi_2904_ = _e2114;
                                            break if !(_e2109);
                                        }
                                    }
                                    let _e2119 = local_10;
                                    phi_2958_ = (_e2119 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e2126 = phi_2958_;
                                let _e2127 = (f64(1f) / _e2126);
                                let _e2128 = (_e2064 * _e2127);
                                let _e2129 = (_e2065 * _e2127);
                                let _e2130 = (_e2066 * _e2127);
                                let _e2139 = ((f64(3f) - (((_e2128 * _e2128) + (_e2129 * _e2129)) + (_e2130 * _e2130))) * f64(0.5f));
                                phi_3425_ = array<f64, 3>((_e2128 * _e2139), (_e2129 * _e2139), (_e2130 * _e2139));
                            } else {
                                let _e1717 = local.member_1;
                                let _e1723 = local.member_2;
                                let _e1728 = f64(0f);
                                let _e1729 = f64(1f);
                                if (_e1723[0] < 0.0lf) {
                                    phi_2996_ = -(_e1723[0]);
                                } else {
                                    phi_2996_ = _e1723[0];
                                }
                                let _e1733 = phi_2996_;
                                if (_e1723[1] < 0.0lf) {
                                    phi_3003_ = -(_e1723[1]);
                                } else {
                                    phi_3003_ = _e1723[1];
                                }
                                let _e1737 = phi_3003_;
                                if (_e1733 > _e1737) {
                                    phi_3008_ = _e1733;
                                } else {
                                    phi_3008_ = _e1737;
                                }
                                let _e1740 = phi_3008_;
                                if (_e1723[2] < 0.0lf) {
                                    phi_3015_ = -(_e1723[2]);
                                } else {
                                    phi_3015_ = _e1723[2];
                                }
                                let _e1744 = phi_3015_;
                                if (_e1740 > _e1744) {
                                    phi_3020_ = _e1740;
                                } else {
                                    phi_3020_ = _e1744;
                                }
                                let _e1747 = phi_3020_;
                                if (_e1717[0] < 0.0lf) {
                                    phi_3027_ = -(_e1717[0]);
                                } else {
                                    phi_3027_ = _e1717[0];
                                }
                                let _e1751 = phi_3027_;
                                if (_e1717[1] < 0.0lf) {
                                    phi_3034_ = -(_e1717[1]);
                                } else {
                                    phi_3034_ = _e1717[1];
                                }
                                let _e1755 = phi_3034_;
                                if (_e1751 > _e1755) {
                                    phi_3039_ = _e1751;
                                } else {
                                    phi_3039_ = _e1755;
                                }
                                let _e1758 = phi_3039_;
                                if (_e1717[2] < 0.0lf) {
                                    phi_3046_ = -(_e1717[2]);
                                } else {
                                    phi_3046_ = _e1717[2];
                                }
                                let _e1762 = phi_3046_;
                                if (_e1758 > _e1762) {
                                    phi_3051_ = _e1758;
                                } else {
                                    phi_3051_ = _e1762;
                                }
                                let _e1765 = phi_3051_;
                                if (_e1747 > _e1765) {
                                    phi_3056_ = array<f64, 3>(_e1723[0], _e1723[1], _e1723[2]);
                                } else {
                                    phi_3056_ = array<f64, 3>(_e1717[0], _e1717[1], _e1717[2]);
                                }
                                let _e1768 = phi_3056_;
                                if (_e1768[0] < 0.0lf) {
                                    phi_3063_ = -(_e1768[0]);
                                } else {
                                    phi_3063_ = _e1768[0];
                                }
                                let _e1773 = phi_3063_;
                                if (_e1768[1] < 0.0lf) {
                                    phi_3070_ = -(_e1768[1]);
                                } else {
                                    phi_3070_ = _e1768[1];
                                }
                                let _e1778 = phi_3070_;
                                if (_e1773 > _e1778) {
                                    phi_3075_ = _e1773;
                                } else {
                                    phi_3075_ = _e1778;
                                }
                                let _e1781 = phi_3075_;
                                if (_e1768[2] < 0.0lf) {
                                    phi_3082_ = -(_e1768[2]);
                                } else {
                                    phi_3082_ = _e1768[2];
                                }
                                let _e1786 = phi_3082_;
                                if (_e1781 > _e1786) {
                                    phi_3087_ = _e1781;
                                } else {
                                    phi_3087_ = _e1786;
                                }
                                let _e1789 = phi_3087_;
                                if (_e1789 > _e1728) {
                                    if (_e1768[0] < 0.0lf) {
                                        phi_3098_ = -(_e1768[0]);
                                    } else {
                                        phi_3098_ = _e1768[0];
                                    }
                                    let _e1796 = phi_3098_;
                                    if (_e1768[1] < 0.0lf) {
                                        phi_3105_ = -(_e1768[1]);
                                    } else {
                                        phi_3105_ = _e1768[1];
                                    }
                                    let _e1801 = phi_3105_;
                                    if (_e1768[2] < 0.0lf) {
                                        phi_3112_ = -(_e1768[2]);
                                    } else {
                                        phi_3112_ = _e1768[2];
                                    }
                                    let _e1806 = phi_3112_;
                                    if (_e1796 <= _e1801) {
                                        if (_e1796 <= _e1806) {
                                            phi_3122_ = array<f64, 3>(_e1729, _e1728, _e1728);
                                            phi_3123_ = false;
                                        } else {
                                            phi_3122_ = array<f64, 3>();
                                            phi_3123_ = true;
                                        }
                                        let _e1811 = phi_3122_;
                                        let _e1813 = phi_3123_;
                                        phi_3124_ = _e1811;
                                        phi_3125_ = _e1813;
                                    } else {
                                        phi_3124_ = array<f64, 3>();
                                        phi_3125_ = true;
                                    }
                                    let _e1815 = phi_3124_;
                                    let _e1817 = phi_3125_;
                                    if _e1817 {
                                        if (_e1801 <= _e1806) {
                                            phi_3135_ = array<f64, 3>(_e1728, _e1729, _e1728);
                                        } else {
                                            phi_3135_ = array<f64, 3>(_e1728, _e1728, _e1729);
                                        }
                                        let _e1822 = phi_3135_;
                                        phi_3136_ = _e1822;
                                    } else {
                                        phi_3136_ = _e1815;
                                    }
                                    let _e1824 = phi_3136_;
                                    if (_e1768[0] < 0.0lf) {
                                        phi_3143_ = -(_e1768[0]);
                                    } else {
                                        phi_3143_ = _e1768[0];
                                    }
                                    let _e1829 = phi_3143_;
                                    if (_e1768[1] < 0.0lf) {
                                        phi_3150_ = -(_e1768[1]);
                                    } else {
                                        phi_3150_ = _e1768[1];
                                    }
                                    let _e1834 = phi_3150_;
                                    if (_e1829 > _e1834) {
                                        phi_3155_ = _e1829;
                                    } else {
                                        phi_3155_ = _e1834;
                                    }
                                    let _e1837 = phi_3155_;
                                    if (_e1768[2] < 0.0lf) {
                                        phi_3162_ = -(_e1768[2]);
                                    } else {
                                        phi_3162_ = _e1768[2];
                                    }
                                    let _e1842 = phi_3162_;
                                    if (_e1837 > _e1842) {
                                        phi_3167_ = _e1837;
                                    } else {
                                        phi_3167_ = _e1842;
                                    }
                                    let _e1845 = phi_3167_;
                                    let _e1846 = function_9(_e1845);
                                    let _e1848 = (_e1768[0] * _e1846);
                                    let _e1850 = (_e1768[1] * _e1846);
                                    let _e1852 = (_e1768[2] * _e1846);
                                    let _e1858 = (((_e1848 * _e1848) + (_e1850 * _e1850)) + (_e1852 * _e1852));
                                    if (_e1858 <= 2.2250738585072014e-308lf) {
                                        if (_e1858 > 0.0lf) {
                                            phi_3194_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3194_ = 0.0lf;
                                        }
                                        let _e1910 = phi_3194_;
                                        phi_3258_ = _e1910;
                                    } else {
                                        phi_3201_ = type_16(0i, 5i);
                                        phi_3204_ = bitcast<f64>(((bitcast<u64>(_e1858) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1865 = phi_3201_;
                                            let _e1867 = phi_3204_;
                                            local_8 = _e1867;
                                            if (_e1865.member < _e1865.member_1) {
                                                let _e1874 = (_e1865.member + 1i);
                                                if ((false == (_e1874 > _e1865.member)) != false) {
                                                    phi_3225_ = true;
                                                } else {
                                                    phi_3225_ = false;
                                                }
                                                let _e1879 = phi_3225_;
                                                if _e1879 {
                                                    phi_3231_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_3231_ = type_17(1u, _e1874);
                                                }
                                                let _e1884 = phi_3231_;
                                                phi_3202_ = type_16(_e1884.member_1, _e1865.member_1);
                                                phi_3245_ = type_17(1u, _e1865.member);
                                            } else {
                                                phi_3202_ = _e1865;
                                                phi_3245_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e1890 = phi_3202_;
                                            let _e1892 = phi_3245_;
                                            let _e1895 = (bitcast<i32>(_e1892.member) != 0i);
                                            if _e1895 {
                                                phi_3205_ = (0.5lf * (_e1867 + (_e1858 / _e1867)));
                                            } else {
                                                phi_3205_ = f64();
                                            }
                                            let _e1900 = phi_3205_;
                                            continue;
                                            continuing {
                                                phi_3201_ = _e1890;
                                                phi_3204_ = _e1900;
                                                break if !(_e1895);
                                            }
                                        }
                                        let _e1905 = local_8;
                                        phi_3258_ = (_e1905 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1912 = phi_3258_;
                                    let _e1913 = (f64(1f) / _e1912);
                                    let _e1914 = (_e1848 * _e1913);
                                    let _e1915 = (_e1850 * _e1913);
                                    let _e1916 = (_e1852 * _e1913);
                                    let _e1925 = ((f64(3f) - (((_e1914 * _e1914) + (_e1915 * _e1915)) + (_e1916 * _e1916))) * f64(0.5f));
                                    let _e1926 = (_e1914 * _e1925);
                                    let _e1927 = (_e1915 * _e1925);
                                    let _e1928 = (_e1916 * _e1925);
                                    let _e1933 = ((_e1927 * _e1824[2]) - (_e1928 * _e1824[1]));
                                    let _e1938 = ((_e1928 * _e1824[0]) - (_e1926 * _e1824[2]));
                                    let _e1943 = ((_e1926 * _e1824[1]) - (_e1927 * _e1824[0]));
                                    if (_e1933 < 0.0lf) {
                                        phi_3295_ = -(_e1933);
                                    } else {
                                        phi_3295_ = _e1933;
                                    }
                                    let _e1947 = phi_3295_;
                                    if (_e1938 < 0.0lf) {
                                        phi_3301_ = -(_e1938);
                                    } else {
                                        phi_3301_ = _e1938;
                                    }
                                    let _e1951 = phi_3301_;
                                    if (_e1947 > _e1951) {
                                        phi_3306_ = _e1947;
                                    } else {
                                        phi_3306_ = _e1951;
                                    }
                                    let _e1954 = phi_3306_;
                                    if (_e1943 < 0.0lf) {
                                        phi_3312_ = -(_e1943);
                                    } else {
                                        phi_3312_ = _e1943;
                                    }
                                    let _e1958 = phi_3312_;
                                    if (_e1954 > _e1958) {
                                        phi_3317_ = _e1954;
                                    } else {
                                        phi_3317_ = _e1958;
                                    }
                                    let _e1961 = phi_3317_;
                                    let _e1962 = function_9(_e1961);
                                    let _e1963 = (_e1933 * _e1962);
                                    let _e1964 = (_e1938 * _e1962);
                                    let _e1965 = (_e1943 * _e1962);
                                    let _e1971 = (((_e1963 * _e1963) + (_e1964 * _e1964)) + (_e1965 * _e1965));
                                    if (_e1971 <= 2.2250738585072014e-308lf) {
                                        if (_e1971 > 0.0lf) {
                                            phi_3341_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3341_ = 0.0lf;
                                        }
                                        let _e2023 = phi_3341_;
                                        phi_3405_ = _e2023;
                                    } else {
                                        phi_3348_ = type_16(0i, 5i);
                                        phi_3351_ = bitcast<f64>(((bitcast<u64>(_e1971) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1978 = phi_3348_;
                                            let _e1980 = phi_3351_;
                                            local_9 = _e1980;
                                            if (_e1978.member < _e1978.member_1) {
                                                let _e1987 = (_e1978.member + 1i);
                                                if ((false == (_e1987 > _e1978.member)) != false) {
                                                    phi_3372_ = true;
                                                } else {
                                                    phi_3372_ = false;
                                                }
                                                let _e1992 = phi_3372_;
                                                if _e1992 {
                                                    phi_3378_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_3378_ = type_17(1u, _e1987);
                                                }
                                                let _e1997 = phi_3378_;
                                                phi_3349_ = type_16(_e1997.member_1, _e1978.member_1);
                                                phi_3392_ = type_17(1u, _e1978.member);
                                            } else {
                                                phi_3349_ = _e1978;
                                                phi_3392_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e2003 = phi_3349_;
                                            let _e2005 = phi_3392_;
                                            let _e2008 = (bitcast<i32>(_e2005.member) != 0i);
                                            if _e2008 {
                                                phi_3352_ = (0.5lf * (_e1980 + (_e1971 / _e1980)));
                                            } else {
                                                phi_3352_ = f64();
                                            }
                                            let _e2013 = phi_3352_;
                                            continue;
                                            continuing {
                                                phi_3348_ = _e2003;
                                                phi_3351_ = _e2013;
                                                break if !(_e2008);
                                            }
                                        }
                                        let _e2018 = local_9;
                                        phi_3405_ = (_e2018 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e2025 = phi_3405_;
                                    let _e2026 = (f64(1f) / _e2025);
                                    let _e2027 = (_e1963 * _e2026);
                                    let _e2028 = (_e1964 * _e2026);
                                    let _e2029 = (_e1965 * _e2026);
                                    let _e2038 = ((f64(3f) - (((_e2027 * _e2027) + (_e2028 * _e2028)) + (_e2029 * _e2029))) * f64(0.5f));
                                    phi_3424_ = array<f64, 3>((_e2027 * _e2038), (_e2028 * _e2038), (_e2029 * _e2038));
                                } else {
                                    phi_3424_ = array<f64, 3>(_e1729, _e1728, _e1728);
                                }
                                let _e2044 = phi_3424_;
                                phi_3425_ = _e2044;
                            }
                            let _e2145 = phi_3425_;
                            phi_3426_ = _e2145;
                            phi_3427_ = false;
                        } else {
                            phi_3426_ = array<f64, 3>();
                            phi_3427_ = true;
                        }
                        let _e2147 = phi_3426_;
                        let _e2149 = phi_3427_;
                        phi_3428_ = _e2147;
                        phi_3429_ = _e1713;
                        phi_3430_ = _e2149;
                    } else {
                        phi_3428_ = array<f64, 3>();
                        phi_3429_ = _e1332;
                        phi_3430_ = true;
                    }
                    let _e2151 = phi_3428_;
                    let _e2153 = phi_3429_;
                    let _e2155 = phi_3430_;
                    phi_3434_ = _e2153;
                    phi_3435_ = _e2151;
                    phi_3436_ = _e2155;
                }
                let _e2404 = phi_3434_;
                let _e2406 = phi_3435_;
                let _e2408 = phi_3436_;
                if _e2408 {
                    phi_3440_ = _e2404;
                } else {
                    phi_3440_ = _e2406;
                }
                let _e2410 = phi_3440_;
                if ((((_e2410[0] * _e2410[0]) + (_e2410[1] * _e2410[1])) + (_e2410[2] * _e2410[2])) > f64(0.5f)) {
                    phi_3460_ = _e2410;
                } else {
                    phi_3460_ = array<f64, 3>(_e320, f64(0f), f64(0f));
                }
                let _e2428 = phi_3460_;
                let _e2431 = function_10(_e326[0], _e327[0], _e321);
                let _e2434 = function_10(_e326[1], _e327[1], _e321);
                let _e2437 = function_10(_e326[2], _e327[2], _e321);
                let _e2440 = function_10(_e326[3], _e327[3], _e321);
                if (_e159.member != 0u) {
                    let _e2478 = function_10(_e2431, _e2434, _e881.member);
                    let _e2479 = function_10(_e2437, _e2440, _e881.member_1);
                    phi_3517_ = _e2479;
                    phi_3518_ = _e2478;
                    phi_3519_ = array<f64, 4>((_e320 - _e881.member), _e881.member, (_e320 - _e881.member_1), _e881.member_1);
                } else {
                    let _e2443 = ((_e320 - _e881.member) - _e881.member_1);
                    let _e2444 = f64(0f);
                    if (_e2443 > _e2444) {
                        phi_3489_ = _e2443;
                    } else {
                        phi_3489_ = _e2444;
                    }
                    let _e2447 = phi_3489_;
                    let _e2474 = function_1(array<f64, 4>(_e320, _e2447, _e881.member, _e881.member_1), _e325);
                    phi_3517_ = array<f64, 3>((((_e2434[0] * _e2447) + (_e2437[0] * _e881.member)) + (_e2440[0] * _e881.member_1)), (((_e2434[1] * _e2447) + (_e2437[1] * _e881.member)) + (_e2440[1] * _e881.member_1)), (((_e2434[2] * _e2447) + (_e2437[2] * _e881.member)) + (_e2440[2] * _e881.member_1)));
                    phi_3518_ = _e2431;
                    phi_3519_ = _e2474;
                }
                let _e2481 = phi_3517_;
                let _e2483 = phi_3518_;
                let _e2485 = phi_3519_;
                let _e2487 = function_10(_e2483, _e2481, f64(0.5f));
                let _e2489 = function_(_e2487);
                let _e2491 = function_(_e2428);
                geometry.member[_e119] = type_30(_e2489, f32((_e946 / _e569)), _e2491, _e127, array<f32, 4>(f32(_e2485[0]), f32(_e2485[1]), f32(_e2485[2]), f32(_e2485[3])), _e159.member_1);
            }
        }
        continue;
        continuing {
            phi_240_ = _e109;
            break if !(_e115);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn contact_geometry_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_14(id, n, lane);
}
