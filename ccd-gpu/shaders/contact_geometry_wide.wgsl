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
    let _e3 = f64(0f);
    let _e6 = select(param_7, param_6, (param_6 < param_7));
    return select(_e3, select(_e3, _e6, (_e6 > _e3)), (param_6 > _e3));
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
    var phi_4418_: type_44;
    var phi_4419_: bool;
    var phi_4420_: type_44;
    var phi_4421_: bool;
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
        let _e91 = (*param_17).member_3;
        let _e96 = (*param_17).member_3;
        let _e104 = (((_e91[0] * _e96[0]) + (_e91[1] * _e96[1])) + (_e91[2] * _e96[2]));
        let _e106 = (*param_17).member;
        let _e111 = (*param_17).member_2;
        let _e125 = (*param_17).member_3;
        let _e134 = ((((((_e106[1] * _e111[2]) - (_e106[2] * _e111[1])) * _e125[0]) + (((_e106[2] * _e111[0]) - (_e106[0] * _e111[2])) * _e125[1])) + (((_e106[0] * _e111[1]) - (_e106[1] * _e111[0])) * _e125[2])) / _e104);
        let _e136 = (*param_17).member_1;
        let _e141 = (*param_17).member;
        let _e155 = (*param_17).member_3;
        let _e164 = ((((((_e136[1] * _e141[2]) - (_e136[2] * _e141[1])) * _e155[0]) + (((_e136[2] * _e141[0]) - (_e136[0] * _e141[2])) * _e155[1])) + (((_e136[0] * _e141[1]) - (_e136[1] * _e141[0])) * _e155[2])) / _e104);
        if (_e134 >= _e9) {
            if (_e164 >= _e9) {
                if select(select(false, (_e164 <= _e10), (_e134 <= _e10)), ((_e134 + _e164) <= _e10), _e11) {
                    let _e175 = function_7(param_17, _e134, select(_e10, (_e10 - _e134), _e11));
                    let _e178 = function_5(param_17, _e175, select(_e10, (_e10 - _e175), _e11));
                    let _e179 = function_6(param_17, _e178, _e175);
                    phi_4302_ = _e179;
                    phi_4303_ = false;
                } else {
                    phi_4302_ = type_44();
                    phi_4303_ = true;
                }
                let _e181 = phi_4302_;
                let _e183 = phi_4303_;
                phi_4304_ = _e181;
                phi_4305_ = _e183;
            } else {
                phi_4304_ = type_44();
                phi_4305_ = true;
            }
            let _e185 = phi_4304_;
            let _e187 = phi_4305_;
            phi_4306_ = _e185;
            phi_4307_ = _e187;
        } else {
            phi_4306_ = type_44();
            phi_4307_ = true;
        }
        let _e189 = phi_4306_;
        let _e191 = phi_4307_;
        phi_4425_ = _e189;
        phi_4426_ = _e191;
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
            let _e71 = function_4((select(_e52, _e29, (_e29 < _e52)) / _e67), _e10);
            let _e75 = function_4((select(_e52, _e29, (_e29 > _e52)) / _e67), _e10);
            if (_e71 < _e75) {
                let _e79 = ((_e71 + _e75) * f64(0.5f));
                let _e80 = function_7(param_17, _e79, _e10);
                let _e81 = function_6(param_17, _e79, _e80);
                phi_4418_ = _e81;
                phi_4419_ = false;
            } else {
                phi_4418_ = type_44();
                phi_4419_ = true;
            }
            let _e83 = phi_4418_;
            let _e85 = phi_4419_;
            phi_4420_ = _e83;
            phi_4421_ = _e85;
        }
        let _e87 = phi_4420_;
        let _e89 = phi_4421_;
        phi_4425_ = _e87;
        phi_4426_ = _e89;
    }
    let _e193 = phi_4425_;
    let _e195 = phi_4426_;
    if _e195 {
        let _e196 = function_5(param_17, _e9, _e10);
        let _e197 = function_6(param_17, _e196, _e9);
        let _e198 = function_7(param_17, _e9, _e10);
        let _e199 = function_6(param_17, _e9, _e198);
        let _e200 = function_3(_e197, _e199);
        if _e11 {
            let _e208 = (*param_17).member_2;
            let _e213 = (*param_17).member_1;
            let _e217 = (_e208[0] - _e213[0]);
            let _e218 = (_e208[1] - _e213[1]);
            let _e219 = (_e208[2] - _e213[2]);
            let _e221 = (*param_17).member;
            let _e226 = (*param_17).member_1;
            let _e244 = function_4((((((_e221[0] - _e226[0]) * _e217) + ((_e221[1] - _e226[1]) * _e218)) + ((_e221[2] - _e226[2]) * _e219)) / (((_e217 * _e217) + (_e218 * _e218)) + (_e219 * _e219))), _e10);
            let _e246 = function_6(param_17, (_e10 - _e244), _e244);
            let _e247 = function_3(_e200, _e246);
            phi_4501_ = _e247;
        } else {
            let _e201 = function_7(param_17, _e10, _e10);
            let _e202 = function_6(param_17, _e10, _e201);
            let _e203 = function_5(param_17, _e10, _e10);
            let _e204 = function_6(param_17, _e203, _e10);
            let _e205 = function_3(_e202, _e204);
            let _e206 = function_3(_e200, _e205);
            phi_4501_ = _e206;
        }
        let _e249 = phi_4501_;
        phi_4502_ = _e249;
        phi_4503_ = false;
    } else {
        phi_4502_ = type_44();
        phi_4503_ = true;
    }
    let _e251 = phi_4502_;
    let _e253 = phi_4503_;
    if _e253 {
        phi_4507_ = _e193;
    } else {
        phi_4507_ = _e251;
    }
    let _e255 = phi_4507_;
    return _e255;
}

fn function_9(param_19: f64) -> f64 {
    var phi_4132_: f64;
    var phi_4134_: f64;

    if ((bitcast<u64>(param_19) & 9218868437227405312lu) != 9218868437227405312lu) {
        if (param_19 >= 2.2250738585072014e-308lf) {
            let _e15 = (9214364837600034816lu - (bitcast<u64>(param_19) & 9218868437227405312lu));
            phi_4132_ = bitcast<f64>(select(4503599627370496lu, _e15, (_e15 > 4503599627370496lu)));
        } else {
            phi_4132_ = (f64(1f) / 2.2250738585072014e-308lf);
        }
        let _e20 = phi_4132_;
        phi_4134_ = _e20;
    } else {
        phi_4134_ = f64(1f);
    }
    let _e22 = phi_4134_;
    return _e22;
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
    let _e11 = (*param_25)[3u];
    let _e16 = (*param_25)[2u];
    let _e25 = (*param_26)[3u];
    let _e30 = (*param_26)[2u];
    let _e38 = function_10(array<f64, 3>((_e11[0] - _e16[0]), (_e11[1] - _e16[1]), (_e11[2] - _e16[2])), array<f64, 3>((_e25[0] - _e30[0]), (_e25[1] - _e30[1]), (_e25[2] - _e30[2])), param_27);
    let _e52 = ((select(_e38[0], -(_e38[0]), (_e38[0] < 0.0lf)) + select(_e38[1], -(_e38[1]), (_e38[1] < 0.0lf))) + select(_e38[2], -(_e38[2]), (_e38[2] < 0.0lf)));
    let _e54 = (*param_25)[1u];
    let _e59 = (*param_25)[3u];
    let _e68 = (*param_26)[1u];
    let _e73 = (*param_26)[3u];
    let _e81 = function_10(array<f64, 3>((_e54[0] - _e59[0]), (_e54[1] - _e59[1]), (_e54[2] - _e59[2])), array<f64, 3>((_e68[0] - _e73[0]), (_e68[1] - _e73[1]), (_e68[2] - _e73[2])), param_27);
    let _e95 = ((select(_e81[0], -(_e81[0]), (_e81[0] < 0.0lf)) + select(_e81[1], -(_e81[1]), (_e81[1] < 0.0lf))) + select(_e81[2], -(_e81[2]), (_e81[2] < 0.0lf)));
    let _e97 = (*param_25)[2u];
    let _e102 = (*param_25)[1u];
    let _e111 = (*param_26)[2u];
    let _e116 = (*param_26)[1u];
    let _e124 = function_10(array<f64, 3>((_e97[0] - _e102[0]), (_e97[1] - _e102[1]), (_e97[2] - _e102[2])), array<f64, 3>((_e111[0] - _e116[0]), (_e111[1] - _e116[1]), (_e111[2] - _e116[2])), param_27);
    let _e138 = ((select(_e124[0], -(_e124[0]), (_e124[0] < 0.0lf)) + select(_e124[1], -(_e124[1]), (_e124[1] < 0.0lf))) + select(_e124[2], -(_e124[2]), (_e124[2] < 0.0lf)));
    return select(0u, select(2u, 1u, (_e95 >= _e138)), select(true, select(true, false, (_e52 >= _e138)), (_e52 >= _e95)));
}

fn function_13(param_28: array<f32, 3>) -> array<f64, 3> {
    var phi_3670_: f64;
    var phi_3713_: f64;
    var phi_3756_: f64;

    let _e10 = bitcast<u32>(param_28[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param_28[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_3670_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_3670_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_3670_;
    let _e40 = bitcast<u32>(param_28[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param_28[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_3713_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_3713_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_3713_;
    let _e70 = bitcast<u32>(param_28[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param_28[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_3756_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_3756_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_3756_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_14(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_35;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: array<array<f64, 3>, 4>;
    var phi_216_: u32;
    var phi_261_: u32;
    var phi_264_: type_9;
    var phi_431_: type_28;
    var phi_636_: type_41;
    var phi_693_: u32;
    var phi_854_: type_43;
    var phi_1312_: type_16;
    var phi_1315_: f64;
    var phi_1313_: type_16;
    var phi_1356_: type_17;
    var phi_1316_: f64;
    var local_3: f64;
    var phi_1369_: f64;
    var phi_1379_: f64;
    var phi_1435_: type_16;
    var phi_1438_: f64;
    var phi_1436_: type_16;
    var phi_1479_: type_17;
    var phi_1439_: f64;
    var local_4: f64;
    var phi_1492_: f64;
    var phi_1502_: f64;
    var phi_2207_: type_16;
    var phi_2210_: f64;
    var phi_2208_: type_16;
    var phi_2251_: type_17;
    var phi_2211_: f64;
    var local_5: f64;
    var phi_2264_: f64;
    var phi_2334_: array<f64, 3>;
    var phi_2335_: bool;
    var phi_2336_: array<f64, 3>;
    var phi_2337_: bool;
    var phi_2383_: array<f64, 3>;
    var phi_2384_: bool;
    var phi_2385_: array<f64, 3>;
    var phi_2386_: bool;
    var phi_2387_: array<f64, 3>;
    var phi_2388_: bool;
    var phi_2477_: bool;
    var phi_2487_: array<f64, 3>;
    var phi_2488_: bool;
    var phi_2489_: array<f64, 3>;
    var phi_2490_: bool;
    var phi_2504_: array<f64, 3>;
    var phi_2505_: array<f64, 3>;
    var phi_2506_: array<f64, 3>;
    var phi_2646_: type_16;
    var phi_2649_: f64;
    var phi_2647_: type_16;
    var phi_2690_: type_17;
    var phi_2650_: f64;
    var local_6: f64;
    var phi_2703_: f64;
    var phi_2732_: array<f64, 3>;
    var phi_2825_: type_16;
    var phi_2828_: f64;
    var phi_2826_: type_16;
    var phi_2869_: type_17;
    var phi_2829_: f64;
    var local_7: f64;
    var phi_2882_: f64;
    var phi_2900_: array<f64, 3>;
    var phi_2901_: bool;
    var phi_2902_: array<f64, 3>;
    var phi_2903_: bool;
    var phi_3191_: array<f64, 3>;
    var phi_3192_: bool;
    var phi_3203_: array<f64, 3>;
    var phi_3268_: type_16;
    var phi_3271_: f64;
    var phi_3269_: type_16;
    var phi_3312_: type_17;
    var phi_3272_: f64;
    var local_8: f64;
    var phi_3325_: f64;
    var phi_3415_: type_16;
    var phi_3418_: f64;
    var phi_3416_: type_16;
    var phi_3459_: type_17;
    var phi_3419_: f64;
    var local_9: f64;
    var phi_3472_: f64;
    var phi_3491_: array<f64, 3>;
    var phi_2968_: type_16;
    var phi_2971_: f64;
    var phi_2969_: type_16;
    var phi_3012_: type_17;
    var phi_2972_: f64;
    var local_10: f64;
    var phi_3025_: f64;
    var phi_3492_: array<f64, 3>;
    var phi_3514_: array<f64, 3>;
    var phi_3515_: bool;
    var phi_3516_: array<f64, 3>;
    var phi_3517_: array<f64, 3>;
    var phi_3518_: bool;
    var phi_1706_: type_16;
    var phi_1709_: f64;
    var phi_1707_: type_16;
    var phi_1750_: type_17;
    var phi_1710_: f64;
    var local_11: f64;
    var phi_1763_: f64;
    var phi_1781_: array<f64, 3>;
    var phi_1782_: bool;
    var phi_1783_: array<f64, 3>;
    var phi_1784_: bool;
    var phi_1785_: array<f64, 3>;
    var phi_1786_: bool;
    var phi_1848_: type_16;
    var phi_1851_: f64;
    var phi_1849_: type_16;
    var phi_1892_: type_17;
    var phi_1852_: f64;
    var local_12: f64;
    var phi_1905_: f64;
    var phi_1923_: array<f64, 3>;
    var phi_3522_: array<f64, 3>;
    var phi_3523_: array<f64, 3>;
    var phi_3524_: bool;
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
    let _e75 = select(_e73, _e71, (_e71 < _e73));
    let _e77 = params.member.member_1.member_1;
    if (_e75 > _e77) {
        let _e80 = params.member.member_1.member_1;
        phi_216_ = (_e75 - _e80);
    } else {
        phi_216_ = 0u;
    }
    let _e83 = phi_216_;
    let _e85 = params.member.member_1.member;
    let _e87 = select(_e83, _e85, (_e85 < _e83));
    let _e88 = (_e87 / 64u);
    let _e92 = select(_e88, (_e88 + 1u), ((_e87 % 64u) > 0u));
    if (_e92 > _e65) {
        let _e94 = (_e92 - _e65);
        if (_e68 == 0u) {
            return;
        }
        let _e96 = (_e94 / _e68);
        if (_e68 == 0u) {
            return;
        }
        phi_261_ = select(_e96, (_e96 + 1u), ((_e94 % _e68) > 0u));
    } else {
        phi_261_ = 0u;
    }
    let _e103 = phi_261_;
    phi_264_ = type_9(0u, _e103);
    loop {
        let _e106 = phi_264_;
        let _e109 = (_e106.member < _e106.member_1);
        let _e122 = (bitcast<i32>(select(0u, 1u, _e109)) != 0i);
        if _e122 {
            let _e126 = (((_e65 + (select(type_9().member_1, _e106.member, _e109) * _e68)) * 64u) + _e53);
            if (_e126 < _e87) {
                let _e130 = params.member.member_1.member_1;
                let _e131 = (_e130 + _e126);
                let _e132 = (7u * _e131);
                let _e135 = contacts.member[(4u + _e132)];
                let _e138 = contacts.member[(_e132 + 5u)];
                let _e141 = contacts.member[(_e132 + 6u)];
                let _e144 = contacts.member[(_e132 + 7u)];
                let _e147 = contacts.member[(_e132 + 8u)];
                let _e150 = contacts.member[(_e132 + 9u)];
                if (_e135 == 0u) {
                    let _e163 = faces.member[_e144];
                    phi_431_ = type_28(0u, array<u32, 4>(_e141, _e163[0], _e163[1], _e163[2]));
                } else {
                    let _e153 = edges.member[_e141];
                    let _e155 = edges.member[_e144];
                    phi_431_ = type_28(1u, array<u32, 4>(_e153[0], _e153[1], _e155[0], _e155[1]));
                }
                let _e170 = phi_431_;
                let _e175 = params.member.member.member_1;
                if ((_e175 & 8u) != 0u) {
                    let _e219 = paths.member[_e170.member_1[0]];
                    let _e222 = paths.member[_e170.member_1[1]];
                    let _e229 = paths.member[_e170.member_1[2]];
                    let _e232 = paths.member[_e170.member_1[3]];
                    let _e269 = function_13(array<f32, 3>(_e219.member[0], _e219.member[1], _e219.member[2]));
                    let _e270 = function_13(array<f32, 3>(_e222.member[0], _e222.member[1], _e222.member[2]));
                    let _e271 = function_13(array<f32, 3>(_e229.member[0], _e229.member[1], _e229.member[2]));
                    let _e272 = function_13(array<f32, 3>(_e232.member[0], _e232.member[1], _e232.member[2]));
                    let _e274 = function_13(array<f32, 3>(_e219.member_1[0], _e219.member_1[1], _e219.member_1[2]));
                    let _e275 = function_13(array<f32, 3>(_e222.member_1[0], _e222.member_1[1], _e222.member_1[2]));
                    let _e276 = function_13(array<f32, 3>(_e229.member_1[0], _e229.member_1[1], _e229.member_1[2]));
                    let _e277 = function_13(array<f32, 3>(_e232.member_1[0], _e232.member_1[1], _e232.member_1[2]));
                    phi_636_ = type_41(array<array<f64, 3>, 4>(_e269, _e270, _e271, _e272), array<array<f64, 3>, 4>(_e274, _e275, _e276, _e277));
                } else {
                    let _e180 = positions.member[_e170.member_1[0]];
                    let _e183 = params.member.member.member[0u];
                    let _e186 = positions.member[(_e183 + _e170.member_1[0])];
                    let _e189 = positions.member[_e170.member_1[1]];
                    let _e192 = params.member.member.member[0u];
                    let _e195 = positions.member[(_e192 + _e170.member_1[1])];
                    let _e198 = positions.member[_e170.member_1[2]];
                    let _e201 = params.member.member.member[0u];
                    let _e204 = positions.member[(_e201 + _e170.member_1[2])];
                    let _e207 = positions.member[_e170.member_1[3]];
                    let _e210 = params.member.member.member[0u];
                    let _e213 = positions.member[(_e210 + _e170.member_1[3])];
                    phi_636_ = type_41(array<array<f64, 3>, 4>(_e180, _e189, _e198, _e207), array<array<f64, 3>, 4>(_e186, _e195, _e204, _e213));
                }
                let _e281 = phi_636_;
                local_1 = array<array<f64, 3>, 4>(array<f64, 3>(_e281.member[0][0], _e281.member[0][1], _e281.member[0][2]), array<f64, 3>(_e281.member[1][0], _e281.member[1][1], _e281.member[1][2]), array<f64, 3>(_e281.member[2][0], _e281.member[2][1], _e281.member[2][2]), array<f64, 3>(_e281.member[3][0], _e281.member[3][1], _e281.member[3][2]));
                local_2 = array<array<f64, 3>, 4>(array<f64, 3>(_e281.member_1[0][0], _e281.member_1[0][1], _e281.member_1[0][2]), array<f64, 3>(_e281.member_1[1][0], _e281.member_1[1][1], _e281.member_1[1][2]), array<f64, 3>(_e281.member_1[2][0], _e281.member_1[2][1], _e281.member_1[2][2]), array<f64, 3>(_e281.member_1[3][0], _e281.member_1[3][1], _e281.member_1[3][2]));
                let _e331 = f64(1f);
                let _e332 = function_4(bitcast<f64>(((u64(_e150) * 4294967296lu) + u64(_e147))), _e331);
                if (_e170.member == 0u) {
                    let _e334 = function_12((&local_1), (&local_2), _e332);
                    phi_693_ = _e334;
                } else {
                    phi_693_ = 0u;
                }
                let _e336 = phi_693_;
                let _e337 = function_11((&local_1), _e336);
                let _e338 = function_11((&local_2), _e336);
                if (_e170.member != 0u) {
                    phi_854_ = type_43(array<array<f64, 3>, 2>(array<f64, 3>((_e337[2][0] - _e337[0][0]), (_e337[2][1] - _e337[0][1]), (_e337[2][2] - _e337[0][2])), array<f64, 3>((_e338[2][0] - _e338[0][0]), (_e338[2][1] - _e338[0][1]), (_e338[2][2] - _e338[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e337[1][0] - _e337[0][0]), (_e337[1][1] - _e337[0][1]), (_e337[1][2] - _e337[0][2])), array<f64, 3>((_e338[1][0] - _e338[0][0]), (_e338[1][1] - _e338[0][1]), (_e338[1][2] - _e338[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e337[2][0] - _e337[3][0]), (_e337[2][1] - _e337[3][1]), (_e337[2][2] - _e337[3][2])), array<f64, 3>((_e338[2][0] - _e338[3][0]), (_e338[2][1] - _e338[3][1]), (_e338[2][2] - _e338[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_854_ = type_43(array<array<f64, 3>, 2>(array<f64, 3>((_e337[0][0] - _e337[1][0]), (_e337[0][1] - _e337[1][1]), (_e337[0][2] - _e337[1][2])), array<f64, 3>((_e338[0][0] - _e338[1][0]), (_e338[0][1] - _e338[1][1]), (_e338[0][2] - _e338[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e337[2][0] - _e337[1][0]), (_e337[2][1] - _e337[1][1]), (_e337[2][2] - _e337[1][2])), array<f64, 3>((_e338[2][0] - _e338[1][0]), (_e338[2][1] - _e338[1][1]), (_e338[2][2] - _e338[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e337[3][0] - _e337[1][0]), (_e337[3][1] - _e337[1][1]), (_e337[3][2] - _e337[1][2])), array<f64, 3>((_e338[3][0] - _e338[1][0]), (_e338[3][1] - _e338[1][1]), (_e338[3][2] - _e338[1][2]))), (0.0lf + 0.0lf));
                }
                let _e495 = phi_854_;
                let _e500 = function_10(_e495.member[0], _e495.member[1], _e332);
                let _e505 = function_10(_e495.member_1[0], _e495.member_1[1], _e332);
                let _e510 = function_10(_e495.member_2[0], _e495.member_2[1], _e332);
                let _e514 = select(_e500[0], -(_e500[0]), (_e500[0] < 0.0lf));
                let _e518 = select(_e500[1], -(_e500[1]), (_e500[1] < 0.0lf));
                let _e520 = select(_e518, _e514, (_e514 > _e518));
                let _e524 = select(_e500[2], -(_e500[2]), (_e500[2] < 0.0lf));
                let _e526 = select(_e524, _e520, (_e520 > _e524));
                let _e530 = select(_e505[0], -(_e505[0]), (_e505[0] < 0.0lf));
                let _e534 = select(_e505[1], -(_e505[1]), (_e505[1] < 0.0lf));
                let _e536 = select(_e534, _e530, (_e530 > _e534));
                let _e540 = select(_e505[2], -(_e505[2]), (_e505[2] < 0.0lf));
                let _e542 = select(_e540, _e536, (_e536 > _e540));
                let _e544 = select(_e542, _e526, (_e526 > _e542));
                let _e548 = select(_e510[0], -(_e510[0]), (_e510[0] < 0.0lf));
                let _e552 = select(_e510[1], -(_e510[1]), (_e510[1] < 0.0lf));
                let _e554 = select(_e552, _e548, (_e548 > _e552));
                let _e558 = select(_e510[2], -(_e510[2]), (_e510[2] < 0.0lf));
                let _e560 = select(_e558, _e554, (_e554 > _e558));
                let _e563 = function_9(select(_e560, _e544, (_e544 > _e560)));
                let _e571 = (_e505[0] * _e563);
                let _e573 = (_e505[1] * _e563);
                let _e575 = (_e505[2] * _e563);
                let _e577 = (_e510[0] * _e563);
                let _e579 = (_e510[1] * _e563);
                let _e581 = (_e510[2] * _e563);
                let _e587 = select(_e495.member[0][0], -(_e495.member[0][0]), (_e495.member[0][0] < 0.0lf));
                let _e591 = select(_e495.member[0][1], -(_e495.member[0][1]), (_e495.member[0][1] < 0.0lf));
                let _e593 = select(_e591, _e587, (_e587 > _e591));
                let _e597 = select(_e495.member[0][2], -(_e495.member[0][2]), (_e495.member[0][2] < 0.0lf));
                let _e599 = select(_e597, _e593, (_e593 > _e597));
                let _e605 = select(_e495.member[1][0], -(_e495.member[1][0]), (_e495.member[1][0] < 0.0lf));
                let _e609 = select(_e495.member[1][1], -(_e495.member[1][1]), (_e495.member[1][1] < 0.0lf));
                let _e611 = select(_e609, _e605, (_e605 > _e609));
                let _e615 = select(_e495.member[1][2], -(_e495.member[1][2]), (_e495.member[1][2] < 0.0lf));
                let _e617 = select(_e615, _e611, (_e611 > _e615));
                let _e627 = select(_e495.member_1[0][0], -(_e495.member_1[0][0]), (_e495.member_1[0][0] < 0.0lf));
                let _e631 = select(_e495.member_1[0][1], -(_e495.member_1[0][1]), (_e495.member_1[0][1] < 0.0lf));
                let _e633 = select(_e631, _e627, (_e627 > _e631));
                let _e637 = select(_e495.member_1[0][2], -(_e495.member_1[0][2]), (_e495.member_1[0][2] < 0.0lf));
                let _e639 = select(_e637, _e633, (_e633 > _e637));
                let _e645 = select(_e495.member_1[1][0], -(_e495.member_1[1][0]), (_e495.member_1[1][0] < 0.0lf));
                let _e649 = select(_e495.member_1[1][1], -(_e495.member_1[1][1]), (_e495.member_1[1][1] < 0.0lf));
                let _e651 = select(_e649, _e645, (_e645 > _e649));
                let _e655 = select(_e495.member_1[1][2], -(_e495.member_1[1][2]), (_e495.member_1[1][2] < 0.0lf));
                let _e657 = select(_e655, _e651, (_e651 > _e655));
                let _e661 = (select(_e657, _e639, (_e639 > _e657)) + _e495.member_3);
                let _e667 = select(_e495.member_2[0][0], -(_e495.member_2[0][0]), (_e495.member_2[0][0] < 0.0lf));
                let _e671 = select(_e495.member_2[0][1], -(_e495.member_2[0][1]), (_e495.member_2[0][1] < 0.0lf));
                let _e673 = select(_e671, _e667, (_e667 > _e671));
                let _e677 = select(_e495.member_2[0][2], -(_e495.member_2[0][2]), (_e495.member_2[0][2] < 0.0lf));
                let _e679 = select(_e677, _e673, (_e673 > _e677));
                let _e685 = select(_e495.member_2[1][0], -(_e495.member_2[1][0]), (_e495.member_2[1][0] < 0.0lf));
                let _e689 = select(_e495.member_2[1][1], -(_e495.member_2[1][1]), (_e495.member_2[1][1] < 0.0lf));
                let _e691 = select(_e689, _e685, (_e685 > _e689));
                let _e695 = select(_e495.member_2[1][2], -(_e495.member_2[1][2]), (_e495.member_2[1][2] < 0.0lf));
                let _e697 = select(_e695, _e691, (_e691 > _e695));
                let _e701 = (select(_e697, _e679, (_e679 > _e697)) + _e495.member_3);
                let _e703 = (1.1102230246251565e-16lf * f64(16f));
                let _e706 = (_e495.member_3 * f64(4f));
                let _e714 = ((_e573 * _e581) - (_e575 * _e579));
                let _e717 = ((_e575 * _e577) - (_e571 * _e581));
                let _e720 = ((_e571 * _e579) - (_e573 * _e577));
                let _e728 = select(_e577, -(_e577), (_e577 < 0.0lf));
                let _e731 = select(_e579, -(_e579), (_e579 < 0.0lf));
                let _e733 = select(_e731, _e728, (_e728 > _e731));
                let _e736 = select(_e581, -(_e581), (_e581 < 0.0lf));
                let _e743 = select(_e571, -(_e571), (_e571 < 0.0lf));
                let _e746 = select(_e573, -(_e573), (_e573 < 0.0lf));
                let _e748 = select(_e746, _e743, (_e743 > _e746));
                let _e751 = select(_e575, -(_e575), (_e575 < 0.0lf));
                let _e755 = (((((_e661 * _e703) + _e706) * _e563) * select(_e736, _e733, (_e733 > _e736))) + ((((_e701 * _e703) + _e706) * _e563) * select(_e751, _e748, (_e748 > _e751))));
                let _e760 = (((_e714 * _e714) + (_e717 * _e717)) + (_e720 * _e720));
                if (_e760 <= 2.2250738585072014e-308lf) {
                    phi_1369_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e760 > 0.0lf));
                } else {
                    phi_1312_ = type_16(0i, 5i);
                    phi_1315_ = bitcast<f64>(((bitcast<u64>(_e760) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e767 = phi_1312_;
                        let _e769 = phi_1315_;
                        local_3 = _e769;
                        if (_e767.member < _e767.member_1) {
                            let _e776 = (_e767.member + 1i);
                            phi_1313_ = type_16(select(_e776, type_17().member_1, select(false, true, ((false == (_e776 > _e767.member)) != false))), _e767.member_1);
                            phi_1356_ = type_17(1u, _e767.member);
                        } else {
                            phi_1313_ = _e767;
                            phi_1356_ = type_17(0u, type_17().member_1);
                        }
                        let _e787 = phi_1313_;
                        let _e789 = phi_1356_;
                        let _e792 = (bitcast<i32>(_e789.member) != 0i);
                        if _e792 {
                            phi_1316_ = (0.5lf * (_e769 + (_e760 / _e769)));
                        } else {
                            phi_1316_ = f64();
                        }
                        let _e797 = phi_1316_;
                        continue;
                        continuing {
                            phi_1312_ = _e787;
                            phi_1315_ = _e797;
                            break if !(_e792);
                        }
                    }
                    let _e802 = local_3;
                    phi_1369_ = (_e802 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e808 = phi_1369_;
                if (_e808 > f64(0f)) {
                    phi_1379_ = ((_e808 + (_e760 / _e808)) * f64(0.5f));
                } else {
                    phi_1379_ = _e808;
                }
                let _e816 = phi_1379_;
                local = type_35(array<f64, 3>((_e500[0] * _e563), (_e500[1] * _e563), (_e500[2] * _e563)), array<f64, 3>(_e571, _e573, _e575), array<f64, 3>(_e577, _e579, _e581), array<f64, 3>(_e714, _e717, _e720), select(f64(0f), _e816, (_e816 > _e755)), _e755, ((((((select(_e617, _e599, (_e599 > _e617)) + _e495.member_3) + _e661) + _e701) * _e703) + _e706) * _e563));
                let _e825 = function_8((&local), _e170.member);
                if (_e825.member_3 <= 2.2250738585072014e-308lf) {
                    phi_1492_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e825.member_3 > 0.0lf));
                } else {
                    phi_1435_ = type_16(0i, 5i);
                    phi_1438_ = bitcast<f64>(((bitcast<u64>(_e825.member_3) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e835 = phi_1435_;
                        let _e837 = phi_1438_;
                        local_4 = _e837;
                        if (_e835.member < _e835.member_1) {
                            let _e844 = (_e835.member + 1i);
                            phi_1436_ = type_16(select(_e844, type_17().member_1, select(false, true, ((false == (_e844 > _e835.member)) != false))), _e835.member_1);
                            phi_1479_ = type_17(1u, _e835.member);
                        } else {
                            phi_1436_ = _e835;
                            phi_1479_ = type_17(0u, type_17().member_1);
                        }
                        let _e855 = phi_1436_;
                        let _e857 = phi_1479_;
                        let _e860 = (bitcast<i32>(_e857.member) != 0i);
                        if _e860 {
                            phi_1439_ = (0.5lf * (_e837 + (_e825.member_3 / _e837)));
                        } else {
                            phi_1439_ = f64();
                        }
                        let _e865 = phi_1439_;
                        continue;
                        continuing {
                            phi_1435_ = _e855;
                            phi_1438_ = _e865;
                            break if !(_e860);
                        }
                    }
                    let _e870 = local_4;
                    phi_1492_ = (_e870 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e876 = phi_1492_;
                if (_e876 > f64(0f)) {
                    phi_1502_ = ((_e876 + (_e825.member_3 / _e876)) * f64(0.5f));
                } else {
                    phi_1502_ = _e876;
                }
                let _e884 = phi_1502_;
                let _e887 = select(-(_e331), _e331, (_e170.member == 0u));
                let _e889 = function_2(_e495.member);
                let _e891 = function_2(_e495.member_1);
                let _e905 = function_2(_e495.member_2);
                let _e915 = (((_e889[0] - (_e891[0] * _e825.member)) - (_e905[0] * _e825.member_1)) * _e887);
                let _e916 = (((_e889[1] - (_e891[1] * _e825.member)) - (_e905[1] * _e825.member_1)) * _e887);
                let _e917 = (((_e889[2] - (_e891[2] * _e825.member)) - (_e905[2] * _e825.member_1)) * _e887);
                let _e919 = f64(0f);
                let _e920 = f64(1f);
                let _e925 = select(false, (_e825.member < _e920), (_e825.member > _e919));
                let _e928 = select(false, (_e825.member_1 < _e920), (_e825.member_1 > _e919));
                let _e929 = (_e887 > _e919);
                let _e940 = select(select(bool(), select(bool(), select(true, ((_e825.member + _e825.member_1) < (_e920 - (1.1102230246251565e-16lf * f64(4f)))), _e929), _e928), _e925), false, select(true, select(true, false, _e928), _e925));
                let _e942 = local.member_4;
                let _e943 = (_e942 > _e919);
                let _e945 = local.member_3;
                let _e949 = (_e945[0] * _e887);
                let _e950 = (_e945[1] * _e887);
                let _e951 = (_e945[2] * _e887);
                let _e953 = local.member_6;
                if (_e884 > _e953) {
                    let _e1972 = (_e825.member_2[0] * _e887);
                    let _e1974 = (_e825.member_2[1] * _e887);
                    let _e1976 = (_e825.member_2[2] * _e887);
                    if _e943 {
                        if _e940 {
                            let _e1978 = local.member_5;
                            let _e1981 = local.member_6;
                            let _e1983 = local.member_4;
                            if ((_e1978 * _e884) <= (_e1981 * _e1983)) {
                                let _e1991 = ((((_e1972 * _e949) + (_e1974 * _e950)) + (_e1976 * _e951)) >= _e919);
                                let _e1992 = -(_e920);
                                let _e1996 = select((_e949 * _e1992), _e949, _e1991);
                                let _e1997 = select((_e950 * _e1992), _e950, _e1991);
                                let _e1998 = select((_e951 * _e1992), _e951, _e1991);
                                let _e2001 = select(_e1996, -(_e1996), (_e1996 < 0.0lf));
                                let _e2004 = select(_e1997, -(_e1997), (_e1997 < 0.0lf));
                                let _e2006 = select(_e2004, _e2001, (_e2001 > _e2004));
                                let _e2009 = select(_e1998, -(_e1998), (_e1998 < 0.0lf));
                                let _e2012 = function_9(select(_e2009, _e2006, (_e2006 > _e2009)));
                                let _e2013 = (_e1996 * _e2012);
                                let _e2014 = (_e1997 * _e2012);
                                let _e2015 = (_e1998 * _e2012);
                                let _e2021 = (((_e2013 * _e2013) + (_e2014 * _e2014)) + (_e2015 * _e2015));
                                if (_e2021 <= 2.2250738585072014e-308lf) {
                                    phi_1763_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2021 > 0.0lf));
                                } else {
                                    phi_1706_ = type_16(0i, 5i);
                                    phi_1709_ = bitcast<f64>(((bitcast<u64>(_e2021) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2028 = phi_1706_;
                                        let _e2030 = phi_1709_;
                                        local_11 = _e2030;
                                        if (_e2028.member < _e2028.member_1) {
                                            let _e2037 = (_e2028.member + 1i);
                                            phi_1707_ = type_16(select(_e2037, type_17().member_1, select(false, true, ((false == (_e2037 > _e2028.member)) != false))), _e2028.member_1);
                                            phi_1750_ = type_17(1u, _e2028.member);
                                        } else {
                                            phi_1707_ = _e2028;
                                            phi_1750_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2048 = phi_1707_;
                                        let _e2050 = phi_1750_;
                                        let _e2053 = (bitcast<i32>(_e2050.member) != 0i);
                                        if _e2053 {
                                            phi_1710_ = (0.5lf * (_e2030 + (_e2021 / _e2030)));
                                        } else {
                                            phi_1710_ = f64();
                                        }
                                        let _e2058 = phi_1710_;
                                        continue;
                                        continuing {
                                            phi_1706_ = _e2048;
                                            phi_1709_ = _e2058;
                                            break if !(_e2053);
                                        }
                                    }
                                    let _e2063 = local_11;
                                    phi_1763_ = (_e2063 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e2069 = phi_1763_;
                                let _e2070 = (f64(1f) / _e2069);
                                let _e2071 = (_e2013 * _e2070);
                                let _e2072 = (_e2014 * _e2070);
                                let _e2073 = (_e2015 * _e2070);
                                let _e2082 = ((f64(3f) - (((_e2071 * _e2071) + (_e2072 * _e2072)) + (_e2073 * _e2073))) * f64(0.5f));
                                phi_1781_ = array<f64, 3>((_e2071 * _e2082), (_e2072 * _e2082), (_e2073 * _e2082));
                                phi_1782_ = false;
                            } else {
                                phi_1781_ = array<f64, 3>();
                                phi_1782_ = true;
                            }
                            let _e2088 = phi_1781_;
                            let _e2090 = phi_1782_;
                            phi_1783_ = _e2088;
                            phi_1784_ = _e2090;
                        } else {
                            phi_1783_ = array<f64, 3>();
                            phi_1784_ = true;
                        }
                        let _e2092 = phi_1783_;
                        let _e2094 = phi_1784_;
                        phi_1785_ = _e2092;
                        phi_1786_ = _e2094;
                    } else {
                        phi_1785_ = array<f64, 3>();
                        phi_1786_ = true;
                    }
                    let _e2096 = phi_1785_;
                    let _e2098 = phi_1786_;
                    if _e2098 {
                        let _e2101 = select(_e1972, -(_e1972), (_e1972 < 0.0lf));
                        let _e2104 = select(_e1974, -(_e1974), (_e1974 < 0.0lf));
                        let _e2106 = select(_e2104, _e2101, (_e2101 > _e2104));
                        let _e2109 = select(_e1976, -(_e1976), (_e1976 < 0.0lf));
                        let _e2112 = function_9(select(_e2109, _e2106, (_e2106 > _e2109)));
                        let _e2113 = (_e1972 * _e2112);
                        let _e2114 = (_e1974 * _e2112);
                        let _e2115 = (_e1976 * _e2112);
                        let _e2121 = (((_e2113 * _e2113) + (_e2114 * _e2114)) + (_e2115 * _e2115));
                        if (_e2121 <= 2.2250738585072014e-308lf) {
                            phi_1905_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2121 > 0.0lf));
                        } else {
                            phi_1848_ = type_16(0i, 5i);
                            phi_1851_ = bitcast<f64>(((bitcast<u64>(_e2121) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e2128 = phi_1848_;
                                let _e2130 = phi_1851_;
                                local_12 = _e2130;
                                if (_e2128.member < _e2128.member_1) {
                                    let _e2137 = (_e2128.member + 1i);
                                    phi_1849_ = type_16(select(_e2137, type_17().member_1, select(false, true, ((false == (_e2137 > _e2128.member)) != false))), _e2128.member_1);
                                    phi_1892_ = type_17(1u, _e2128.member);
                                } else {
                                    phi_1849_ = _e2128;
                                    phi_1892_ = type_17(0u, type_17().member_1);
                                }
                                let _e2148 = phi_1849_;
                                let _e2150 = phi_1892_;
                                let _e2153 = (bitcast<i32>(_e2150.member) != 0i);
                                if _e2153 {
                                    phi_1852_ = (0.5lf * (_e2130 + (_e2121 / _e2130)));
                                } else {
                                    phi_1852_ = f64();
                                }
                                let _e2158 = phi_1852_;
                                continue;
                                continuing {
                                    phi_1848_ = _e2148;
                                    phi_1851_ = _e2158;
                                    break if !(_e2153);
                                }
                            }
                            let _e2163 = local_12;
                            phi_1905_ = (_e2163 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e2169 = phi_1905_;
                        let _e2170 = (f64(1f) / _e2169);
                        let _e2171 = (_e2113 * _e2170);
                        let _e2172 = (_e2114 * _e2170);
                        let _e2173 = (_e2115 * _e2170);
                        let _e2182 = ((f64(3f) - (((_e2171 * _e2171) + (_e2172 * _e2172)) + (_e2173 * _e2173))) * f64(0.5f));
                        phi_1923_ = array<f64, 3>((_e2171 * _e2182), (_e2172 * _e2182), (_e2173 * _e2182));
                    } else {
                        phi_1923_ = _e2096;
                    }
                    let _e2188 = phi_1923_;
                    phi_3522_ = _e2188;
                    phi_3523_ = array<f64, 3>();
                    phi_3524_ = true;
                } else {
                    let _e960 = select(_e495.member[0][0], -(_e495.member[0][0]), (_e495.member[0][0] < 0.0lf));
                    let _e964 = select(_e495.member[0][1], -(_e495.member[0][1]), (_e495.member[0][1] < 0.0lf));
                    let _e966 = select(_e964, _e960, (_e960 > _e964));
                    let _e970 = select(_e495.member[0][2], -(_e495.member[0][2]), (_e495.member[0][2] < 0.0lf));
                    let _e972 = select(_e970, _e966, (_e966 > _e970));
                    let _e978 = select(_e495.member[1][0], -(_e495.member[1][0]), (_e495.member[1][0] < 0.0lf));
                    let _e982 = select(_e495.member[1][1], -(_e495.member[1][1]), (_e495.member[1][1] < 0.0lf));
                    let _e984 = select(_e982, _e978, (_e978 > _e982));
                    let _e988 = select(_e495.member[1][2], -(_e495.member[1][2]), (_e495.member[1][2] < 0.0lf));
                    let _e990 = select(_e988, _e984, (_e984 > _e988));
                    let _e1000 = select(_e495.member_1[0][0], -(_e495.member_1[0][0]), (_e495.member_1[0][0] < 0.0lf));
                    let _e1004 = select(_e495.member_1[0][1], -(_e495.member_1[0][1]), (_e495.member_1[0][1] < 0.0lf));
                    let _e1006 = select(_e1004, _e1000, (_e1000 > _e1004));
                    let _e1010 = select(_e495.member_1[0][2], -(_e495.member_1[0][2]), (_e495.member_1[0][2] < 0.0lf));
                    let _e1012 = select(_e1010, _e1006, (_e1006 > _e1010));
                    let _e1018 = select(_e495.member_1[1][0], -(_e495.member_1[1][0]), (_e495.member_1[1][0] < 0.0lf));
                    let _e1022 = select(_e495.member_1[1][1], -(_e495.member_1[1][1]), (_e495.member_1[1][1] < 0.0lf));
                    let _e1024 = select(_e1022, _e1018, (_e1018 > _e1022));
                    let _e1028 = select(_e495.member_1[1][2], -(_e495.member_1[1][2]), (_e495.member_1[1][2] < 0.0lf));
                    let _e1030 = select(_e1028, _e1024, (_e1024 > _e1028));
                    let _e1040 = select(_e495.member_2[0][0], -(_e495.member_2[0][0]), (_e495.member_2[0][0] < 0.0lf));
                    let _e1044 = select(_e495.member_2[0][1], -(_e495.member_2[0][1]), (_e495.member_2[0][1] < 0.0lf));
                    let _e1046 = select(_e1044, _e1040, (_e1040 > _e1044));
                    let _e1050 = select(_e495.member_2[0][2], -(_e495.member_2[0][2]), (_e495.member_2[0][2] < 0.0lf));
                    let _e1052 = select(_e1050, _e1046, (_e1046 > _e1050));
                    let _e1058 = select(_e495.member_2[1][0], -(_e495.member_2[1][0]), (_e495.member_2[1][0] < 0.0lf));
                    let _e1062 = select(_e495.member_2[1][1], -(_e495.member_2[1][1]), (_e495.member_2[1][1] < 0.0lf));
                    let _e1064 = select(_e1062, _e1058, (_e1058 > _e1062));
                    let _e1068 = select(_e495.member_2[1][2], -(_e495.member_2[1][2]), (_e495.member_2[1][2] < 0.0lf));
                    let _e1070 = select(_e1068, _e1064, (_e1064 > _e1068));
                    let _e1083 = (((((select(_e990, _e972, (_e972 > _e990)) + _e495.member_3) + (select(_e1030, _e1012, (_e1012 > _e1030)) + _e495.member_3)) + (select(_e1070, _e1052, (_e1052 > _e1070)) + _e495.member_3)) * (1.1102230246251565e-16lf * f64(32f))) + (_e495.member_3 * f64(8f)));
                    if _e943 {
                        let _e1086 = select(_e949, -(_e949), (_e949 < 0.0lf));
                        let _e1089 = select(_e950, -(_e950), (_e950 < 0.0lf));
                        let _e1091 = select(_e1089, _e1086, (_e1086 > _e1089));
                        let _e1094 = select(_e951, -(_e951), (_e951 < 0.0lf));
                        let _e1097 = function_9(select(_e1094, _e1091, (_e1091 > _e1094)));
                        let _e1098 = (_e949 * _e1097);
                        let _e1099 = (_e950 * _e1097);
                        let _e1100 = (_e951 * _e1097);
                        let _e1106 = (((_e1098 * _e1098) + (_e1099 * _e1099)) + (_e1100 * _e1100));
                        if (_e1106 <= 2.2250738585072014e-308lf) {
                            phi_2264_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1106 > 0.0lf));
                        } else {
                            phi_2207_ = type_16(0i, 5i);
                            phi_2210_ = bitcast<f64>(((bitcast<u64>(_e1106) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1113 = phi_2207_;
                                let _e1115 = phi_2210_;
                                local_5 = _e1115;
                                if (_e1113.member < _e1113.member_1) {
                                    let _e1122 = (_e1113.member + 1i);
                                    phi_2208_ = type_16(select(_e1122, type_17().member_1, select(false, true, ((false == (_e1122 > _e1113.member)) != false))), _e1113.member_1);
                                    phi_2251_ = type_17(1u, _e1113.member);
                                } else {
                                    phi_2208_ = _e1113;
                                    phi_2251_ = type_17(0u, type_17().member_1);
                                }
                                let _e1133 = phi_2208_;
                                let _e1135 = phi_2251_;
                                let _e1138 = (bitcast<i32>(_e1135.member) != 0i);
                                if _e1138 {
                                    phi_2211_ = (0.5lf * (_e1115 + (_e1106 / _e1115)));
                                } else {
                                    phi_2211_ = f64();
                                }
                                let _e1143 = phi_2211_;
                                continue;
                                continuing {
                                    phi_2207_ = _e1133;
                                    phi_2210_ = _e1143;
                                    break if !(_e1138);
                                }
                            }
                            let _e1148 = local_5;
                            phi_2264_ = (_e1148 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1154 = phi_2264_;
                        let _e1155 = (f64(1f) / _e1154);
                        let _e1156 = (_e1098 * _e1155);
                        let _e1157 = (_e1099 * _e1155);
                        let _e1158 = (_e1100 * _e1155);
                        let _e1167 = ((f64(3f) - (((_e1156 * _e1156) + (_e1157 * _e1157)) + (_e1158 * _e1158))) * f64(0.5f));
                        let _e1168 = (_e1156 * _e1167);
                        let _e1169 = (_e1157 * _e1167);
                        let _e1170 = (_e1158 * _e1167);
                        let _e1175 = (((_e915 * _e1168) + (_e916 * _e1169)) + (_e917 * _e1170));
                        let _e1188 = local.member_5;
                        let _e1190 = local.member_4;
                        if (select(_e1175, -(_e1175), (_e1175 < 0.0lf)) > (_e1083 + (((select(_e915, -(_e915), (_e915 < 0.0lf)) + select(_e916, -(_e916), (_e916 < 0.0lf))) + select(_e917, -(_e917), (_e917 < 0.0lf))) * (_e1188 / _e1190)))) {
                            let _e1198 = (_e1175 < _e919);
                            let _e1199 = -(_e920);
                            phi_2334_ = array<f64, 3>(select((_e1168 * _e1199), _e1168, _e1198), select((_e1169 * _e1199), _e1169, _e1198), select((_e1170 * _e1199), _e1170, _e1198));
                            phi_2335_ = false;
                        } else {
                            phi_2334_ = array<f64, 3>();
                            phi_2335_ = true;
                        }
                        let _e1208 = phi_2334_;
                        let _e1210 = phi_2335_;
                        phi_2336_ = _e1208;
                        phi_2337_ = _e1210;
                    } else {
                        phi_2336_ = array<f64, 3>();
                        phi_2337_ = true;
                    }
                    let _e1212 = phi_2336_;
                    let _e1214 = phi_2337_;
                    if _e1214 {
                        if select(true, select(true, false, _e940), _e943) {
                            if _e929 {
                                if _e925 {
                                    if _e928 {
                                        let _e1218 = local.member_2;
                                        let _e1223 = local.member_1;
                                        phi_2383_ = array<f64, 3>((_e1218[0] - _e1223[0]), (_e1218[1] - _e1223[1]), (_e1218[2] - _e1223[2]));
                                        phi_2384_ = false;
                                    } else {
                                        phi_2383_ = array<f64, 3>();
                                        phi_2384_ = true;
                                    }
                                    let _e1232 = phi_2383_;
                                    let _e1234 = phi_2384_;
                                    phi_2385_ = _e1232;
                                    phi_2386_ = _e1234;
                                } else {
                                    phi_2385_ = array<f64, 3>();
                                    phi_2386_ = true;
                                }
                                let _e1236 = phi_2385_;
                                let _e1238 = phi_2386_;
                                phi_2387_ = _e1236;
                                phi_2388_ = _e1238;
                            } else {
                                phi_2387_ = array<f64, 3>();
                                phi_2388_ = true;
                            }
                            let _e1240 = phi_2387_;
                            let _e1242 = phi_2388_;
                            if _e1242 {
                                if _e925 {
                                    if _e928 {
                                        let _e1244 = local.member_2;
                                        let _e1250 = select(_e1244[0], -(_e1244[0]), (_e1244[0] < 0.0lf));
                                        let _e1253 = select(_e1244[1], -(_e1244[1]), (_e1244[1] < 0.0lf));
                                        let _e1255 = select(_e1253, _e1250, (_e1250 > _e1253));
                                        let _e1258 = select(_e1244[2], -(_e1244[2]), (_e1244[2] < 0.0lf));
                                        let _e1262 = local.member_1;
                                        let _e1268 = select(_e1262[0], -(_e1262[0]), (_e1262[0] < 0.0lf));
                                        let _e1271 = select(_e1262[1], -(_e1262[1]), (_e1262[1] < 0.0lf));
                                        let _e1273 = select(_e1271, _e1268, (_e1268 > _e1271));
                                        let _e1276 = select(_e1262[2], -(_e1262[2]), (_e1262[2] < 0.0lf));
                                        phi_2477_ = select(true, false, (select(_e1258, _e1255, (_e1255 > _e1258)) > select(_e1276, _e1273, (_e1273 > _e1276))));
                                    } else {
                                        phi_2477_ = true;
                                    }
                                    let _e1282 = phi_2477_;
                                    if _e1282 {
                                        let _e1284 = local.member_1;
                                        phi_2487_ = array<f64, 3>(_e1284[0], _e1284[1], _e1284[2]);
                                        phi_2488_ = false;
                                    } else {
                                        phi_2487_ = array<f64, 3>();
                                        phi_2488_ = true;
                                    }
                                    let _e1290 = phi_2487_;
                                    let _e1292 = phi_2488_;
                                    phi_2489_ = _e1290;
                                    phi_2490_ = _e1292;
                                } else {
                                    phi_2489_ = array<f64, 3>();
                                    phi_2490_ = true;
                                }
                                let _e1294 = phi_2489_;
                                let _e1296 = phi_2490_;
                                if _e1296 {
                                    if _e928 {
                                        let _e1299 = local.member_2;
                                        phi_2504_ = array<f64, 3>(_e1299[0], _e1299[1], _e1299[2]);
                                    } else {
                                        phi_2504_ = array<f64, 3>(_e919, _e919, _e919);
                                    }
                                    let _e1305 = phi_2504_;
                                    phi_2505_ = _e1305;
                                } else {
                                    phi_2505_ = _e1294;
                                }
                                let _e1307 = phi_2505_;
                                phi_2506_ = _e1307;
                            } else {
                                phi_2506_ = _e1240;
                            }
                            let _e1309 = phi_2506_;
                            let _e1313 = select(_e1309[0], -(_e1309[0]), (_e1309[0] < 0.0lf));
                            let _e1317 = select(_e1309[1], -(_e1309[1]), (_e1309[1] < 0.0lf));
                            let _e1319 = select(_e1317, _e1313, (_e1313 > _e1317));
                            let _e1323 = select(_e1309[2], -(_e1309[2]), (_e1309[2] < 0.0lf));
                            let _e1327 = local.member_6;
                            let _e1328 = (select(_e1323, _e1319, (_e1319 > _e1323)) > _e1327);
                            let _e1330 = select(_e919, _e1309[0], _e1328);
                            let _e1332 = select(_e919, _e1309[1], _e1328);
                            let _e1334 = select(_e919, _e1309[2], _e1328);
                            let _e1337 = select(_e1330, -(_e1330), (_e1330 < 0.0lf));
                            let _e1340 = select(_e1332, -(_e1332), (_e1332 < 0.0lf));
                            let _e1342 = select(_e1340, _e1337, (_e1337 > _e1340));
                            let _e1345 = select(_e1334, -(_e1334), (_e1334 < 0.0lf));
                            if (select(_e1345, _e1342, (_e1342 > _e1345)) > f64(0f)) {
                                let _e1352 = select(_e1330, -(_e1330), (_e1330 < 0.0lf));
                                let _e1355 = select(_e1332, -(_e1332), (_e1332 < 0.0lf));
                                let _e1357 = select(_e1355, _e1352, (_e1352 > _e1355));
                                let _e1360 = select(_e1334, -(_e1334), (_e1334 < 0.0lf));
                                let _e1363 = function_9(select(_e1360, _e1357, (_e1357 > _e1360)));
                                let _e1364 = (_e1330 * _e1363);
                                let _e1365 = (_e1332 * _e1363);
                                let _e1366 = (_e1334 * _e1363);
                                let _e1372 = (((_e1364 * _e1364) + (_e1365 * _e1365)) + (_e1366 * _e1366));
                                if (_e1372 <= 2.2250738585072014e-308lf) {
                                    phi_2703_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1372 > 0.0lf));
                                } else {
                                    phi_2646_ = type_16(0i, 5i);
                                    phi_2649_ = bitcast<f64>(((bitcast<u64>(_e1372) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1379 = phi_2646_;
                                        let _e1381 = phi_2649_;
                                        local_6 = _e1381;
                                        if (_e1379.member < _e1379.member_1) {
                                            let _e1388 = (_e1379.member + 1i);
                                            phi_2647_ = type_16(select(_e1388, type_17().member_1, select(false, true, ((false == (_e1388 > _e1379.member)) != false))), _e1379.member_1);
                                            phi_2690_ = type_17(1u, _e1379.member);
                                        } else {
                                            phi_2647_ = _e1379;
                                            phi_2690_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1399 = phi_2647_;
                                        let _e1401 = phi_2690_;
                                        let _e1404 = (bitcast<i32>(_e1401.member) != 0i);
                                        if _e1404 {
                                            phi_2650_ = (0.5lf * (_e1381 + (_e1372 / _e1381)));
                                        } else {
                                            phi_2650_ = f64();
                                        }
                                        let _e1409 = phi_2650_;
                                        continue;
                                        continuing {
                                            phi_2646_ = _e1399;
                                            phi_2649_ = _e1409;
                                            break if !(_e1404);
                                        }
                                    }
                                    let _e1414 = local_6;
                                    phi_2703_ = (_e1414 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1420 = phi_2703_;
                                let _e1421 = (f64(1f) / _e1420);
                                let _e1422 = (_e1364 * _e1421);
                                let _e1423 = (_e1365 * _e1421);
                                let _e1424 = (_e1366 * _e1421);
                                let _e1433 = ((f64(3f) - (((_e1422 * _e1422) + (_e1423 * _e1423)) + (_e1424 * _e1424))) * f64(0.5f));
                                let _e1434 = (_e1422 * _e1433);
                                let _e1435 = (_e1423 * _e1433);
                                let _e1436 = (_e1424 * _e1433);
                                let _e1441 = (((_e915 * _e1434) + (_e916 * _e1435)) + (_e917 * _e1436));
                                phi_2732_ = array<f64, 3>((_e915 - (_e1434 * _e1441)), (_e916 - (_e1435 * _e1441)), (_e917 - (_e1436 * _e1441)));
                            } else {
                                phi_2732_ = array<f64, 3>(_e915, _e916, _e917);
                            }
                            let _e1450 = phi_2732_;
                            if (((select(_e1450[0], -(_e1450[0]), (_e1450[0] < 0.0lf)) + select(_e1450[1], -(_e1450[1]), (_e1450[1] < 0.0lf))) + select(_e1450[2], -(_e1450[2]), (_e1450[2] < 0.0lf))) > _e1083) {
                                let _e1466 = -(_e920);
                                let _e1468 = (_e1450[0] * _e1466);
                                let _e1470 = (_e1450[1] * _e1466);
                                let _e1472 = (_e1450[2] * _e1466);
                                let _e1475 = select(_e1468, -(_e1468), (_e1468 < 0.0lf));
                                let _e1478 = select(_e1470, -(_e1470), (_e1470 < 0.0lf));
                                let _e1480 = select(_e1478, _e1475, (_e1475 > _e1478));
                                let _e1483 = select(_e1472, -(_e1472), (_e1472 < 0.0lf));
                                let _e1486 = function_9(select(_e1483, _e1480, (_e1480 > _e1483)));
                                let _e1487 = (_e1468 * _e1486);
                                let _e1488 = (_e1470 * _e1486);
                                let _e1489 = (_e1472 * _e1486);
                                let _e1495 = (((_e1487 * _e1487) + (_e1488 * _e1488)) + (_e1489 * _e1489));
                                if (_e1495 <= 2.2250738585072014e-308lf) {
                                    phi_2882_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1495 > 0.0lf));
                                } else {
                                    phi_2825_ = type_16(0i, 5i);
                                    phi_2828_ = bitcast<f64>(((bitcast<u64>(_e1495) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1502 = phi_2825_;
                                        let _e1504 = phi_2828_;
                                        local_7 = _e1504;
                                        if (_e1502.member < _e1502.member_1) {
                                            let _e1511 = (_e1502.member + 1i);
                                            phi_2826_ = type_16(select(_e1511, type_17().member_1, select(false, true, ((false == (_e1511 > _e1502.member)) != false))), _e1502.member_1);
                                            phi_2869_ = type_17(1u, _e1502.member);
                                        } else {
                                            phi_2826_ = _e1502;
                                            phi_2869_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1522 = phi_2826_;
                                        let _e1524 = phi_2869_;
                                        let _e1527 = (bitcast<i32>(_e1524.member) != 0i);
                                        if _e1527 {
                                            phi_2829_ = (0.5lf * (_e1504 + (_e1495 / _e1504)));
                                        } else {
                                            phi_2829_ = f64();
                                        }
                                        let _e1532 = phi_2829_;
                                        continue;
                                        continuing {
                                            phi_2825_ = _e1522;
                                            phi_2828_ = _e1532;
                                            break if !(_e1527);
                                        }
                                    }
                                    let _e1537 = local_7;
                                    phi_2882_ = (_e1537 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1543 = phi_2882_;
                                let _e1544 = (f64(1f) / _e1543);
                                let _e1545 = (_e1487 * _e1544);
                                let _e1546 = (_e1488 * _e1544);
                                let _e1547 = (_e1489 * _e1544);
                                let _e1556 = ((f64(3f) - (((_e1545 * _e1545) + (_e1546 * _e1546)) + (_e1547 * _e1547))) * f64(0.5f));
                                phi_2900_ = array<f64, 3>((_e1545 * _e1556), (_e1546 * _e1556), (_e1547 * _e1556));
                                phi_2901_ = false;
                            } else {
                                phi_2900_ = array<f64, 3>();
                                phi_2901_ = true;
                            }
                            let _e1562 = phi_2900_;
                            let _e1564 = phi_2901_;
                            phi_2902_ = _e1562;
                            phi_2903_ = _e1564;
                        } else {
                            phi_2902_ = array<f64, 3>();
                            phi_2903_ = true;
                        }
                        let _e1566 = phi_2902_;
                        let _e1568 = phi_2903_;
                        if _e1568 {
                            if _e943 {
                                let _e1849 = select(_e949, -(_e949), (_e949 < 0.0lf));
                                let _e1852 = select(_e950, -(_e950), (_e950 < 0.0lf));
                                let _e1854 = select(_e1852, _e1849, (_e1849 > _e1852));
                                let _e1857 = select(_e951, -(_e951), (_e951 < 0.0lf));
                                let _e1860 = function_9(select(_e1857, _e1854, (_e1854 > _e1857)));
                                let _e1861 = (_e949 * _e1860);
                                let _e1862 = (_e950 * _e1860);
                                let _e1863 = (_e951 * _e1860);
                                let _e1869 = (((_e1861 * _e1861) + (_e1862 * _e1862)) + (_e1863 * _e1863));
                                if (_e1869 <= 2.2250738585072014e-308lf) {
                                    phi_3025_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1869 > 0.0lf));
                                } else {
                                    phi_2968_ = type_16(0i, 5i);
                                    phi_2971_ = bitcast<f64>(((bitcast<u64>(_e1869) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1876 = phi_2968_;
                                        let _e1878 = phi_2971_;
                                        local_10 = _e1878;
                                        if (_e1876.member < _e1876.member_1) {
                                            let _e1885 = (_e1876.member + 1i);
                                            phi_2969_ = type_16(select(_e1885, type_17().member_1, select(false, true, ((false == (_e1885 > _e1876.member)) != false))), _e1876.member_1);
                                            phi_3012_ = type_17(1u, _e1876.member);
                                        } else {
                                            phi_2969_ = _e1876;
                                            phi_3012_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1896 = phi_2969_;
                                        let _e1898 = phi_3012_;
                                        let _e1901 = (bitcast<i32>(_e1898.member) != 0i);
                                        if _e1901 {
                                            phi_2972_ = (0.5lf * (_e1878 + (_e1869 / _e1878)));
                                        } else {
                                            phi_2972_ = f64();
                                        }
                                        let _e1906 = phi_2972_;
                                        continue;
                                        continuing {
                                            phi_2968_ = _e1896;
                                            phi_2971_ = _e1906;
                                            break if !(_e1901);
                                        }
                                    }
                                    let _e1911 = local_10;
                                    phi_3025_ = (_e1911 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1917 = phi_3025_;
                                let _e1918 = (f64(1f) / _e1917);
                                let _e1919 = (_e1861 * _e1918);
                                let _e1920 = (_e1862 * _e1918);
                                let _e1921 = (_e1863 * _e1918);
                                let _e1930 = ((f64(3f) - (((_e1919 * _e1919) + (_e1920 * _e1920)) + (_e1921 * _e1921))) * f64(0.5f));
                                phi_3492_ = array<f64, 3>((_e1919 * _e1930), (_e1920 * _e1930), (_e1921 * _e1930));
                            } else {
                                let _e1570 = local.member_1;
                                let _e1575 = local.member_2;
                                let _e1579 = f64(0f);
                                let _e1580 = f64(1f);
                                let _e1583 = select(_e1575[0], -(_e1575[0]), (_e1575[0] < 0.0lf));
                                let _e1586 = select(_e1575[1], -(_e1575[1]), (_e1575[1] < 0.0lf));
                                let _e1588 = select(_e1586, _e1583, (_e1583 > _e1586));
                                let _e1591 = select(_e1575[2], -(_e1575[2]), (_e1575[2] < 0.0lf));
                                let _e1596 = select(_e1570[0], -(_e1570[0]), (_e1570[0] < 0.0lf));
                                let _e1599 = select(_e1570[1], -(_e1570[1]), (_e1570[1] < 0.0lf));
                                let _e1601 = select(_e1599, _e1596, (_e1596 > _e1599));
                                let _e1604 = select(_e1570[2], -(_e1570[2]), (_e1570[2] < 0.0lf));
                                let _e1607 = (select(_e1591, _e1588, (_e1588 > _e1591)) > select(_e1604, _e1601, (_e1601 > _e1604)));
                                let _e1608 = select(_e1570[0], _e1575[0], _e1607);
                                let _e1609 = select(_e1570[1], _e1575[1], _e1607);
                                let _e1610 = select(_e1570[2], _e1575[2], _e1607);
                                let _e1613 = select(_e1608, -(_e1608), (_e1608 < 0.0lf));
                                let _e1616 = select(_e1609, -(_e1609), (_e1609 < 0.0lf));
                                let _e1618 = select(_e1616, _e1613, (_e1613 > _e1616));
                                let _e1621 = select(_e1610, -(_e1610), (_e1610 < 0.0lf));
                                if (select(_e1621, _e1618, (_e1618 > _e1621)) > _e1579) {
                                    let _e1628 = select(_e1608, -(_e1608), (_e1608 < 0.0lf));
                                    let _e1631 = select(_e1609, -(_e1609), (_e1609 < 0.0lf));
                                    let _e1634 = select(_e1610, -(_e1610), (_e1610 < 0.0lf));
                                    if (_e1628 <= _e1631) {
                                        let _e1636 = (_e1628 <= _e1634);
                                        phi_3191_ = array<f64, 3>(select(array<f64, 3>()[0], _e1580, _e1636), select(array<f64, 3>()[1], _e1579, _e1636), select(array<f64, 3>()[2], _e1579, _e1636));
                                        phi_3192_ = select(true, false, _e1636);
                                    } else {
                                        phi_3191_ = array<f64, 3>();
                                        phi_3192_ = true;
                                    }
                                    let _e1646 = phi_3191_;
                                    let _e1648 = phi_3192_;
                                    if _e1648 {
                                        let _e1649 = (_e1631 <= _e1634);
                                        phi_3203_ = array<f64, 3>(_e1579, select(_e1579, _e1580, _e1649), select(_e1580, _e1579, _e1649));
                                    } else {
                                        phi_3203_ = _e1646;
                                    }
                                    let _e1654 = phi_3203_;
                                    let _e1657 = select(_e1608, -(_e1608), (_e1608 < 0.0lf));
                                    let _e1660 = select(_e1609, -(_e1609), (_e1609 < 0.0lf));
                                    let _e1662 = select(_e1660, _e1657, (_e1657 > _e1660));
                                    let _e1665 = select(_e1610, -(_e1610), (_e1610 < 0.0lf));
                                    let _e1668 = function_9(select(_e1665, _e1662, (_e1662 > _e1665)));
                                    let _e1669 = (_e1608 * _e1668);
                                    let _e1670 = (_e1609 * _e1668);
                                    let _e1671 = (_e1610 * _e1668);
                                    let _e1677 = (((_e1669 * _e1669) + (_e1670 * _e1670)) + (_e1671 * _e1671));
                                    if (_e1677 <= 2.2250738585072014e-308lf) {
                                        phi_3325_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1677 > 0.0lf));
                                    } else {
                                        phi_3268_ = type_16(0i, 5i);
                                        phi_3271_ = bitcast<f64>(((bitcast<u64>(_e1677) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1684 = phi_3268_;
                                            let _e1686 = phi_3271_;
                                            local_8 = _e1686;
                                            if (_e1684.member < _e1684.member_1) {
                                                let _e1693 = (_e1684.member + 1i);
                                                phi_3269_ = type_16(select(_e1693, type_17().member_1, select(false, true, ((false == (_e1693 > _e1684.member)) != false))), _e1684.member_1);
                                                phi_3312_ = type_17(1u, _e1684.member);
                                            } else {
                                                phi_3269_ = _e1684;
                                                phi_3312_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e1704 = phi_3269_;
                                            let _e1706 = phi_3312_;
                                            let _e1709 = (bitcast<i32>(_e1706.member) != 0i);
                                            if _e1709 {
                                                phi_3272_ = (0.5lf * (_e1686 + (_e1677 / _e1686)));
                                            } else {
                                                phi_3272_ = f64();
                                            }
                                            let _e1714 = phi_3272_;
                                            continue;
                                            continuing {
                                                phi_3268_ = _e1704;
                                                phi_3271_ = _e1714;
                                                break if !(_e1709);
                                            }
                                        }
                                        let _e1719 = local_8;
                                        phi_3325_ = (_e1719 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1725 = phi_3325_;
                                    let _e1726 = (f64(1f) / _e1725);
                                    let _e1727 = (_e1669 * _e1726);
                                    let _e1728 = (_e1670 * _e1726);
                                    let _e1729 = (_e1671 * _e1726);
                                    let _e1738 = ((f64(3f) - (((_e1727 * _e1727) + (_e1728 * _e1728)) + (_e1729 * _e1729))) * f64(0.5f));
                                    let _e1739 = (_e1727 * _e1738);
                                    let _e1740 = (_e1728 * _e1738);
                                    let _e1741 = (_e1729 * _e1738);
                                    let _e1746 = ((_e1740 * _e1654[2]) - (_e1741 * _e1654[1]));
                                    let _e1751 = ((_e1741 * _e1654[0]) - (_e1739 * _e1654[2]));
                                    let _e1756 = ((_e1739 * _e1654[1]) - (_e1740 * _e1654[0]));
                                    let _e1759 = select(_e1746, -(_e1746), (_e1746 < 0.0lf));
                                    let _e1762 = select(_e1751, -(_e1751), (_e1751 < 0.0lf));
                                    let _e1764 = select(_e1762, _e1759, (_e1759 > _e1762));
                                    let _e1767 = select(_e1756, -(_e1756), (_e1756 < 0.0lf));
                                    let _e1770 = function_9(select(_e1767, _e1764, (_e1764 > _e1767)));
                                    let _e1771 = (_e1746 * _e1770);
                                    let _e1772 = (_e1751 * _e1770);
                                    let _e1773 = (_e1756 * _e1770);
                                    let _e1779 = (((_e1771 * _e1771) + (_e1772 * _e1772)) + (_e1773 * _e1773));
                                    if (_e1779 <= 2.2250738585072014e-308lf) {
                                        phi_3472_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1779 > 0.0lf));
                                    } else {
                                        phi_3415_ = type_16(0i, 5i);
                                        phi_3418_ = bitcast<f64>(((bitcast<u64>(_e1779) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1786 = phi_3415_;
                                            let _e1788 = phi_3418_;
                                            local_9 = _e1788;
                                            if (_e1786.member < _e1786.member_1) {
                                                let _e1795 = (_e1786.member + 1i);
                                                phi_3416_ = type_16(select(_e1795, type_17().member_1, select(false, true, ((false == (_e1795 > _e1786.member)) != false))), _e1786.member_1);
                                                phi_3459_ = type_17(1u, _e1786.member);
                                            } else {
                                                phi_3416_ = _e1786;
                                                phi_3459_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e1806 = phi_3416_;
                                            let _e1808 = phi_3459_;
                                            let _e1811 = (bitcast<i32>(_e1808.member) != 0i);
                                            if _e1811 {
                                                phi_3419_ = (0.5lf * (_e1788 + (_e1779 / _e1788)));
                                            } else {
                                                phi_3419_ = f64();
                                            }
                                            let _e1816 = phi_3419_;
                                            continue;
                                            continuing {
                                                phi_3415_ = _e1806;
                                                phi_3418_ = _e1816;
                                                break if !(_e1811);
                                            }
                                        }
                                        let _e1821 = local_9;
                                        phi_3472_ = (_e1821 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1827 = phi_3472_;
                                    let _e1828 = (f64(1f) / _e1827);
                                    let _e1829 = (_e1771 * _e1828);
                                    let _e1830 = (_e1772 * _e1828);
                                    let _e1831 = (_e1773 * _e1828);
                                    let _e1840 = ((f64(3f) - (((_e1829 * _e1829) + (_e1830 * _e1830)) + (_e1831 * _e1831))) * f64(0.5f));
                                    phi_3491_ = array<f64, 3>((_e1829 * _e1840), (_e1830 * _e1840), (_e1831 * _e1840));
                                } else {
                                    phi_3491_ = array<f64, 3>(_e1580, _e1579, _e1579);
                                }
                                let _e1846 = phi_3491_;
                                phi_3492_ = _e1846;
                            }
                            let _e1936 = phi_3492_;
                            let _e1945 = ((((_e915 * _e1936[0]) + (_e916 * _e1936[1])) + (_e917 * _e1936[2])) > _e1083);
                            let _e1946 = -(_e920);
                            phi_3514_ = array<f64, 3>(select(_e1936[0], (_e1936[0] * _e1946), _e1945), select(_e1936[1], (_e1936[1] * _e1946), _e1945), select(_e1936[2], (_e1936[2] * _e1946), _e1945));
                            phi_3515_ = false;
                        } else {
                            phi_3514_ = array<f64, 3>();
                            phi_3515_ = true;
                        }
                        let _e1961 = phi_3514_;
                        let _e1963 = phi_3515_;
                        phi_3516_ = _e1961;
                        phi_3517_ = _e1566;
                        phi_3518_ = _e1963;
                    } else {
                        phi_3516_ = array<f64, 3>();
                        phi_3517_ = _e1212;
                        phi_3518_ = true;
                    }
                    let _e1965 = phi_3516_;
                    let _e1967 = phi_3517_;
                    let _e1969 = phi_3518_;
                    phi_3522_ = _e1967;
                    phi_3523_ = _e1965;
                    phi_3524_ = _e1969;
                }
                let _e2190 = phi_3522_;
                let _e2192 = phi_3523_;
                let _e2194 = phi_3524_;
                let _e2197 = select(_e2192[0], _e2190[0], _e2194);
                let _e2200 = select(_e2192[1], _e2190[1], _e2194);
                let _e2203 = select(_e2192[2], _e2190[2], _e2194);
                let _e2210 = ((((_e2197 * _e2197) + (_e2200 * _e2200)) + (_e2203 * _e2203)) > f64(0.5f));
                let _e2219 = function_10(_e337[0], _e338[0], _e332);
                let _e2222 = function_10(_e337[1], _e338[1], _e332);
                let _e2225 = function_10(_e337[2], _e338[2], _e332);
                let _e2228 = function_10(_e337[3], _e338[3], _e332);
                if (_e170.member != 0u) {
                    let _e2265 = function_10(_e2219, _e2222, _e825.member);
                    let _e2266 = function_10(_e2225, _e2228, _e825.member_1);
                    phi_3605_ = _e2266;
                    phi_3606_ = _e2265;
                    phi_3607_ = array<f64, 4>((_e331 - _e825.member), _e825.member, (_e331 - _e825.member_1), _e825.member_1);
                } else {
                    let _e2231 = ((_e331 - _e825.member) - _e825.member_1);
                    let _e2232 = f64(0f);
                    let _e2234 = select(_e2232, _e2231, (_e2231 > _e2232));
                    let _e2261 = function_1(array<f64, 4>(_e331, _e2234, _e825.member, _e825.member_1), _e336);
                    phi_3605_ = array<f64, 3>((((_e2222[0] * _e2234) + (_e2225[0] * _e825.member)) + (_e2228[0] * _e825.member_1)), (((_e2222[1] * _e2234) + (_e2225[1] * _e825.member)) + (_e2228[1] * _e825.member_1)), (((_e2222[2] * _e2234) + (_e2225[2] * _e825.member)) + (_e2228[2] * _e825.member_1)));
                    phi_3606_ = _e2219;
                    phi_3607_ = _e2261;
                }
                let _e2268 = phi_3605_;
                let _e2270 = phi_3606_;
                let _e2272 = phi_3607_;
                let _e2274 = function_10(_e2270, _e2268, f64(0.5f));
                let _e2276 = function_(_e2274);
                let _e2278 = function_(array<f64, 3>(select(_e331, _e2197, _e2210), select(f64(0f), _e2200, _e2210), select(f64(0f), _e2203, _e2210)));
                geometry.member[_e131] = type_31(_e2276, f32((_e884 / _e563)), _e2278, _e138, array<f32, 4>(f32(_e2272[0]), f32(_e2272[1]), f32(_e2272[2]), f32(_e2272[3])), _e170.member_1);
            }
        }
        continue;
        continuing {
            phi_264_ = type_9(select(_e106.member, (_e106.member + 1u), _e109), select(_e106.member_1, _e106.member_1, _e109));
            break if !(_e122);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn contact_geometry_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_14(id, n, lane);
}
