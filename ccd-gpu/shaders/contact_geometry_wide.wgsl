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
    member: u32,
}

struct type_24 {
    member: type_7,
    member_1: type_8,
    member_2: type_23,
}

struct type_25 {
    member: type_24,
}

struct type_26 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 4>,
    member_5: array<u32, 4>,
}

struct type_29 {
    member: array<type_27>,
}

struct type_31 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
    member_2: array<f64, 3>,
    member_3: array<f64, 3>,
    member_4: f64,
    member_5: f64,
    member_6: f64,
}

struct type_36 {
    member: array<array<f64, 3>>,
}

struct type_37 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_39 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_40 {
    member: f64,
    member_1: f64,
    member_2: array<f64, 3>,
    member_3: f64,
}

@group(0) @binding(1) 
var<storage> paths: type_21;
@group(0) @binding(0) 
var<storage> params: type_25;
@group(0) @binding(2) 
var<storage> positions: type_36;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(4) 
var<storage> contacts: type_11;
@group(0) @binding(5) 
var<storage, read_write> geometry: type_29;

fn function_(param: array<f64, 3>) -> array<f32, 3> {
    return array<f32, 3>(f32(param[0]), f32(param[1]), f32(param[2]));
}

fn function_1(param_1: array<f64, 4>, param_2: u32) -> array<f64, 4> {
    var phi_4765_: array<f64, 4>;

    switch bitcast<i32>(param_2) {
        case 0: {
            phi_4765_ = param_1;
            break;
        }
        case 1: {
            phi_4765_ = array<f64, 4>(param_1[0], param_1[3], param_1[1], param_1[2]);
            break;
        }
        default: {
            phi_4765_ = array<f64, 4>(param_1[0], param_1[2], param_1[3], param_1[1]);
            break;
        }
    }
    let _e14 = phi_4765_;
    return _e14;
}

fn function_2(param_3: array<array<f64, 3>, 2>) -> array<f64, 3> {
    return array<f64, 3>((param_3[1][0] - param_3[0][0]), (param_3[1][1] - param_3[0][1]), (param_3[1][2] - param_3[0][2]));
}

fn function_3(param_4: type_40, param_5: type_40) -> type_40 {
    var phi_4733_: type_40;

    if (param_5.member_3 < param_4.member_3) {
        phi_4733_ = param_5;
    } else {
        phi_4733_ = param_4;
    }
    let _e6 = phi_4733_;
    return _e6;
}

fn function_4(param_6: f64, param_7: f64) -> f64 {
    let _e3 = f64(0f);
    let _e6 = select(param_7, param_6, (param_6 < param_7));
    return select(_e3, select(_e3, _e6, (_e6 > _e3)), (param_6 > _e3));
}

fn function_5(param_8: ptr<function, type_31>, param_9: f64, param_10: f64) -> f64 {
    let _e4 = (*param_8).member;
    let _e9 = (*param_8).member_2;
    let _e20 = (*param_8).member_1;
    let _e30 = (*param_8).member_1;
    let _e35 = (*param_8).member_1;
    let _e45 = function_4((((((_e4[0] - (_e9[0] * param_9)) * _e20[0]) + ((_e4[1] - (_e9[1] * param_9)) * _e20[1])) + ((_e4[2] - (_e9[2] * param_9)) * _e20[2])) / (((_e30[0] * _e35[0]) + (_e30[1] * _e35[1])) + (_e30[2] * _e35[2]))), param_10);
    return _e45;
}

fn function_6(param_11: ptr<function, type_31>, param_12: f64, param_13: f64) -> type_40 {
    let _e4 = (*param_11).member;
    let _e9 = (*param_11).member_1;
    let _e20 = (*param_11).member_2;
    let _e27 = ((_e4[0] - (_e9[0] * param_12)) - (_e20[0] * param_13));
    let _e28 = ((_e4[1] - (_e9[1] * param_12)) - (_e20[1] * param_13));
    let _e29 = ((_e4[2] - (_e9[2] * param_12)) - (_e20[2] * param_13));
    return type_40(param_12, param_13, array<f64, 3>(_e27, _e28, _e29), (((_e27 * _e27) + (_e28 * _e28)) + (_e29 * _e29)));
}

fn function_7(param_14: ptr<function, type_31>, param_15: f64, param_16: f64) -> f64 {
    let _e4 = (*param_14).member;
    let _e9 = (*param_14).member_1;
    let _e20 = (*param_14).member_2;
    let _e30 = (*param_14).member_2;
    let _e35 = (*param_14).member_2;
    let _e45 = function_4((((((_e4[0] - (_e9[0] * param_15)) * _e20[0]) + ((_e4[1] - (_e9[1] * param_15)) * _e20[1])) + ((_e4[2] - (_e9[2] * param_15)) * _e20[2])) / (((_e30[0] * _e35[0]) + (_e30[1] * _e35[1])) + (_e30[2] * _e35[2]))), param_16);
    return _e45;
}

fn function_8(param_17: ptr<function, type_31>, param_18: u32) -> type_40 {
    var phi_4450_: type_40;
    var phi_4451_: bool;
    var phi_4452_: type_40;
    var phi_4453_: bool;
    var phi_4334_: type_40;
    var phi_4335_: bool;
    var phi_4336_: type_40;
    var phi_4337_: bool;
    var phi_4338_: type_40;
    var phi_4339_: bool;
    var phi_4457_: type_40;
    var phi_4458_: bool;
    var phi_4533_: type_40;
    var phi_4534_: type_40;
    var phi_4535_: bool;
    var phi_4539_: type_40;

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
                    phi_4334_ = _e179;
                    phi_4335_ = false;
                } else {
                    phi_4334_ = type_40();
                    phi_4335_ = true;
                }
                let _e181 = phi_4334_;
                let _e183 = phi_4335_;
                phi_4336_ = _e181;
                phi_4337_ = _e183;
            } else {
                phi_4336_ = type_40();
                phi_4337_ = true;
            }
            let _e185 = phi_4336_;
            let _e187 = phi_4337_;
            phi_4338_ = _e185;
            phi_4339_ = _e187;
        } else {
            phi_4338_ = type_40();
            phi_4339_ = true;
        }
        let _e189 = phi_4338_;
        let _e191 = phi_4339_;
        phi_4457_ = _e189;
        phi_4458_ = _e191;
    } else {
        if _e11 {
            phi_4452_ = type_40();
            phi_4453_ = true;
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
                phi_4450_ = _e81;
                phi_4451_ = false;
            } else {
                phi_4450_ = type_40();
                phi_4451_ = true;
            }
            let _e83 = phi_4450_;
            let _e85 = phi_4451_;
            phi_4452_ = _e83;
            phi_4453_ = _e85;
        }
        let _e87 = phi_4452_;
        let _e89 = phi_4453_;
        phi_4457_ = _e87;
        phi_4458_ = _e89;
    }
    let _e193 = phi_4457_;
    let _e195 = phi_4458_;
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
            phi_4533_ = _e247;
        } else {
            let _e201 = function_7(param_17, _e10, _e10);
            let _e202 = function_6(param_17, _e10, _e201);
            let _e203 = function_5(param_17, _e10, _e10);
            let _e204 = function_6(param_17, _e203, _e10);
            let _e205 = function_3(_e202, _e204);
            let _e206 = function_3(_e200, _e205);
            phi_4533_ = _e206;
        }
        let _e249 = phi_4533_;
        phi_4534_ = _e249;
        phi_4535_ = false;
    } else {
        phi_4534_ = type_40();
        phi_4535_ = true;
    }
    let _e251 = phi_4534_;
    let _e253 = phi_4535_;
    if _e253 {
        phi_4539_ = _e193;
    } else {
        phi_4539_ = _e251;
    }
    let _e255 = phi_4539_;
    return _e255;
}

fn function_9(param_19: f64) -> f64 {
    var phi_4164_: f64;
    var phi_4166_: f64;

    if ((bitcast<u64>(param_19) & 9218868437227405312lu) != 9218868437227405312lu) {
        if (param_19 >= 2.2250738585072014e-308lf) {
            let _e15 = (9214364837600034816lu - (bitcast<u64>(param_19) & 9218868437227405312lu));
            phi_4164_ = bitcast<f64>(select(4503599627370496lu, _e15, (_e15 > 4503599627370496lu)));
        } else {
            phi_4164_ = (f64(1f) / 2.2250738585072014e-308lf);
        }
        let _e20 = phi_4164_;
        phi_4166_ = _e20;
    } else {
        phi_4166_ = f64(1f);
    }
    let _e22 = phi_4166_;
    return _e22;
}

fn function_10(param_20: array<f64, 3>, param_21: array<f64, 3>, param_22: f64) -> array<f64, 3> {
    let _e5 = (f64(1f) - param_22);
    return array<f64, 3>(((param_20[0] * _e5) + (param_21[0] * param_22)), ((param_20[1] * _e5) + (param_21[1] * param_22)), ((param_20[2] * _e5) + (param_21[2] * param_22)));
}

fn function_11(param_23: ptr<function, array<array<f64, 3>, 4>>, param_24: u32) -> array<array<f64, 3>, 4> {
    var phi_4137_: array<array<f64, 3>, 4>;

    switch bitcast<i32>(param_24) {
        case 0: {
            let _e32 = (*param_23);
            phi_4137_ = array<array<f64, 3>, 4>(array<f64, 3>(_e32[0][0], _e32[0][1], _e32[0][2]), array<f64, 3>(_e32[1][0], _e32[1][1], _e32[1][2]), array<f64, 3>(_e32[2][0], _e32[2][1], _e32[2][2]), array<f64, 3>(_e32[3][0], _e32[3][1], _e32[3][2]));
            break;
        }
        case 1: {
            let _e8 = (*param_23)[0u];
            let _e14 = (*param_23)[2u];
            let _e20 = (*param_23)[3u];
            let _e26 = (*param_23)[1u];
            phi_4137_ = array<array<f64, 3>, 4>(array<f64, 3>(_e8[0], _e8[1], _e8[2]), array<f64, 3>(_e14[0], _e14[1], _e14[2]), array<f64, 3>(_e20[0], _e20[1], _e20[2]), array<f64, 3>(_e26[0], _e26[1], _e26[2]));
            break;
        }
        default: {
            let _e55 = (*param_23)[0u];
            let _e61 = (*param_23)[3u];
            let _e67 = (*param_23)[1u];
            let _e73 = (*param_23)[2u];
            phi_4137_ = array<array<f64, 3>, 4>(array<f64, 3>(_e55[0], _e55[1], _e55[2]), array<f64, 3>(_e61[0], _e61[1], _e61[2]), array<f64, 3>(_e67[0], _e67[1], _e67[2]), array<f64, 3>(_e73[0], _e73[1], _e73[2]));
            break;
        }
    }
    let _e80 = phi_4137_;
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
    var phi_3702_: f64;
    var phi_3745_: f64;
    var phi_3788_: f64;

    let _e10 = bitcast<u32>(param_28[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e20 = bitcast<u32>(param_28[0]);
        let _e21 = (_e20 & 2147483647u);
        let _e22 = (_e21 < 8388608u);
        phi_3702_ = bitcast<f64>(((u64(select(((_e20 ^ _e21) | ((_e21 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e22)) * 4294967296lu) + u64(select((_e20 << bitcast<u32>(29i)), 0u, _e22))));
    } else {
        phi_3702_ = select(-((f64(_e11) * 1.401298464324817e-45lf)), (f64(_e11) * 1.401298464324817e-45lf), (_e10 == _e11));
    }
    let _e38 = phi_3702_;
    let _e40 = bitcast<u32>(param_28[1]);
    let _e41 = (_e40 & 2147483647u);
    if (_e41 >= 8388608u) {
        let _e50 = bitcast<u32>(param_28[1]);
        let _e51 = (_e50 & 2147483647u);
        let _e52 = (_e51 < 8388608u);
        phi_3745_ = bitcast<f64>(((u64(select(((_e50 ^ _e51) | ((_e51 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e52)) * 4294967296lu) + u64(select((_e50 << bitcast<u32>(29i)), 0u, _e52))));
    } else {
        phi_3745_ = select(-((f64(_e41) * 1.401298464324817e-45lf)), (f64(_e41) * 1.401298464324817e-45lf), (_e40 == _e41));
    }
    let _e68 = phi_3745_;
    let _e70 = bitcast<u32>(param_28[2]);
    let _e71 = (_e70 & 2147483647u);
    if (_e71 >= 8388608u) {
        let _e80 = bitcast<u32>(param_28[2]);
        let _e81 = (_e80 & 2147483647u);
        let _e82 = (_e81 < 8388608u);
        phi_3788_ = bitcast<f64>(((u64(select(((_e80 ^ _e81) | ((_e81 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e82)) * 4294967296lu) + u64(select((_e80 << bitcast<u32>(29i)), 0u, _e82))));
    } else {
        phi_3788_ = select(-((f64(_e71) * 1.401298464324817e-45lf)), (f64(_e71) * 1.401298464324817e-45lf), (_e70 == _e71));
    }
    let _e98 = phi_3788_;
    return array<f64, 3>(_e38, _e68, _e98);
}

fn function_14(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_31;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: array<array<f64, 3>, 4>;
    var phi_203_: u32;
    var phi_248_: u32;
    var phi_251_: type_9;
    var phi_463_: type_26;
    var phi_668_: type_37;
    var phi_725_: u32;
    var phi_886_: type_39;
    var phi_1344_: type_16;
    var phi_1347_: f64;
    var phi_1345_: type_16;
    var phi_1388_: type_17;
    var phi_1348_: f64;
    var local_3: f64;
    var phi_1401_: f64;
    var phi_1411_: f64;
    var phi_1467_: type_16;
    var phi_1470_: f64;
    var phi_1468_: type_16;
    var phi_1511_: type_17;
    var phi_1471_: f64;
    var local_4: f64;
    var phi_1524_: f64;
    var phi_1534_: f64;
    var phi_2239_: type_16;
    var phi_2242_: f64;
    var phi_2240_: type_16;
    var phi_2283_: type_17;
    var phi_2243_: f64;
    var local_5: f64;
    var phi_2296_: f64;
    var phi_2366_: array<f64, 3>;
    var phi_2367_: bool;
    var phi_2368_: array<f64, 3>;
    var phi_2369_: bool;
    var phi_2415_: array<f64, 3>;
    var phi_2416_: bool;
    var phi_2417_: array<f64, 3>;
    var phi_2418_: bool;
    var phi_2419_: array<f64, 3>;
    var phi_2420_: bool;
    var phi_2509_: bool;
    var phi_2519_: array<f64, 3>;
    var phi_2520_: bool;
    var phi_2521_: array<f64, 3>;
    var phi_2522_: bool;
    var phi_2536_: array<f64, 3>;
    var phi_2537_: array<f64, 3>;
    var phi_2538_: array<f64, 3>;
    var phi_2678_: type_16;
    var phi_2681_: f64;
    var phi_2679_: type_16;
    var phi_2722_: type_17;
    var phi_2682_: f64;
    var local_6: f64;
    var phi_2735_: f64;
    var phi_2764_: array<f64, 3>;
    var phi_2857_: type_16;
    var phi_2860_: f64;
    var phi_2858_: type_16;
    var phi_2901_: type_17;
    var phi_2861_: f64;
    var local_7: f64;
    var phi_2914_: f64;
    var phi_2932_: array<f64, 3>;
    var phi_2933_: bool;
    var phi_2934_: array<f64, 3>;
    var phi_2935_: bool;
    var phi_3223_: array<f64, 3>;
    var phi_3224_: bool;
    var phi_3235_: array<f64, 3>;
    var phi_3300_: type_16;
    var phi_3303_: f64;
    var phi_3301_: type_16;
    var phi_3344_: type_17;
    var phi_3304_: f64;
    var local_8: f64;
    var phi_3357_: f64;
    var phi_3447_: type_16;
    var phi_3450_: f64;
    var phi_3448_: type_16;
    var phi_3491_: type_17;
    var phi_3451_: f64;
    var local_9: f64;
    var phi_3504_: f64;
    var phi_3523_: array<f64, 3>;
    var phi_3000_: type_16;
    var phi_3003_: f64;
    var phi_3001_: type_16;
    var phi_3044_: type_17;
    var phi_3004_: f64;
    var local_10: f64;
    var phi_3057_: f64;
    var phi_3524_: array<f64, 3>;
    var phi_3546_: array<f64, 3>;
    var phi_3547_: bool;
    var phi_3548_: array<f64, 3>;
    var phi_3549_: array<f64, 3>;
    var phi_3550_: bool;
    var phi_1738_: type_16;
    var phi_1741_: f64;
    var phi_1739_: type_16;
    var phi_1782_: type_17;
    var phi_1742_: f64;
    var local_11: f64;
    var phi_1795_: f64;
    var phi_1813_: array<f64, 3>;
    var phi_1814_: bool;
    var phi_1815_: array<f64, 3>;
    var phi_1816_: bool;
    var phi_1817_: array<f64, 3>;
    var phi_1818_: bool;
    var phi_1880_: type_16;
    var phi_1883_: f64;
    var phi_1881_: type_16;
    var phi_1924_: type_17;
    var phi_1884_: f64;
    var local_12: f64;
    var phi_1937_: f64;
    var phi_1955_: array<f64, 3>;
    var phi_3554_: array<f64, 3>;
    var phi_3555_: array<f64, 3>;
    var phi_3556_: bool;
    var phi_3637_: array<f64, 3>;
    var phi_3638_: array<f64, 3>;
    var phi_3639_: array<f64, 4>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e52 = id_2;
    let _e53 = n_2;
    let _e54 = lane_2;
    let _e65 = ((_e52.y * _e53.x) + _e52.x);
    let _e68 = (_e53.x * _e53.y);
    let _e71 = params.member.member_1.member_2;
    let _e73 = contacts.member[0u];
    let _e75 = select(_e73, _e71, (_e71 < _e73));
    let _e77 = params.member.member_1.member_1;
    if (_e75 > _e77) {
        let _e80 = params.member.member_1.member_1;
        phi_203_ = (_e75 - _e80);
    } else {
        phi_203_ = 0u;
    }
    let _e83 = phi_203_;
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
        phi_248_ = select(_e96, (_e96 + 1u), ((_e94 % _e68) > 0u));
    } else {
        phi_248_ = 0u;
    }
    let _e103 = phi_248_;
    phi_251_ = type_9(0u, _e103);
    loop {
        let _e106 = phi_251_;
        let _e109 = (_e106.member < _e106.member_1);
        let _e122 = (bitcast<i32>(select(0u, 1u, _e109)) != 0i);
        if _e122 {
            let _e126 = (((_e65 + (select(type_9().member_1, _e106.member, _e109) * _e68)) * 64u) + _e54);
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
                    let _e169 = params.member.member.member[1u];
                    let _e172 = ((2u * _e169) + (3u * _e144));
                    let _e174 = elements.member[_e172];
                    let _e177 = elements.member[(_e172 + 1u)];
                    let _e180 = elements.member[(_e172 + 2u)];
                    phi_463_ = type_26(0u, array<u32, 4>(_e141, _e174, _e177, _e180));
                } else {
                    let _e153 = (2u * _e141);
                    let _e155 = elements.member[_e153];
                    let _e158 = elements.member[(_e153 + 1u)];
                    let _e159 = (2u * _e144);
                    let _e161 = elements.member[_e159];
                    let _e164 = elements.member[(_e159 + 1u)];
                    phi_463_ = type_26(1u, array<u32, 4>(_e155, _e158, _e161, _e164));
                }
                let _e184 = phi_463_;
                let _e189 = params.member.member.member_1;
                if ((_e189 & 8u) != 0u) {
                    let _e233 = paths.member[_e184.member_1[0]];
                    let _e236 = paths.member[_e184.member_1[1]];
                    let _e243 = paths.member[_e184.member_1[2]];
                    let _e246 = paths.member[_e184.member_1[3]];
                    let _e283 = function_13(array<f32, 3>(_e233.member[0], _e233.member[1], _e233.member[2]));
                    let _e284 = function_13(array<f32, 3>(_e236.member[0], _e236.member[1], _e236.member[2]));
                    let _e285 = function_13(array<f32, 3>(_e243.member[0], _e243.member[1], _e243.member[2]));
                    let _e286 = function_13(array<f32, 3>(_e246.member[0], _e246.member[1], _e246.member[2]));
                    let _e288 = function_13(array<f32, 3>(_e233.member_1[0], _e233.member_1[1], _e233.member_1[2]));
                    let _e289 = function_13(array<f32, 3>(_e236.member_1[0], _e236.member_1[1], _e236.member_1[2]));
                    let _e290 = function_13(array<f32, 3>(_e243.member_1[0], _e243.member_1[1], _e243.member_1[2]));
                    let _e291 = function_13(array<f32, 3>(_e246.member_1[0], _e246.member_1[1], _e246.member_1[2]));
                    phi_668_ = type_37(array<array<f64, 3>, 4>(_e283, _e284, _e285, _e286), array<array<f64, 3>, 4>(_e288, _e289, _e290, _e291));
                } else {
                    let _e194 = positions.member[_e184.member_1[0]];
                    let _e197 = params.member.member.member[0u];
                    let _e200 = positions.member[(_e197 + _e184.member_1[0])];
                    let _e203 = positions.member[_e184.member_1[1]];
                    let _e206 = params.member.member.member[0u];
                    let _e209 = positions.member[(_e206 + _e184.member_1[1])];
                    let _e212 = positions.member[_e184.member_1[2]];
                    let _e215 = params.member.member.member[0u];
                    let _e218 = positions.member[(_e215 + _e184.member_1[2])];
                    let _e221 = positions.member[_e184.member_1[3]];
                    let _e224 = params.member.member.member[0u];
                    let _e227 = positions.member[(_e224 + _e184.member_1[3])];
                    phi_668_ = type_37(array<array<f64, 3>, 4>(_e194, _e203, _e212, _e221), array<array<f64, 3>, 4>(_e200, _e209, _e218, _e227));
                }
                let _e295 = phi_668_;
                local_1 = array<array<f64, 3>, 4>(array<f64, 3>(_e295.member[0][0], _e295.member[0][1], _e295.member[0][2]), array<f64, 3>(_e295.member[1][0], _e295.member[1][1], _e295.member[1][2]), array<f64, 3>(_e295.member[2][0], _e295.member[2][1], _e295.member[2][2]), array<f64, 3>(_e295.member[3][0], _e295.member[3][1], _e295.member[3][2]));
                local_2 = array<array<f64, 3>, 4>(array<f64, 3>(_e295.member_1[0][0], _e295.member_1[0][1], _e295.member_1[0][2]), array<f64, 3>(_e295.member_1[1][0], _e295.member_1[1][1], _e295.member_1[1][2]), array<f64, 3>(_e295.member_1[2][0], _e295.member_1[2][1], _e295.member_1[2][2]), array<f64, 3>(_e295.member_1[3][0], _e295.member_1[3][1], _e295.member_1[3][2]));
                let _e345 = f64(1f);
                let _e346 = function_4(bitcast<f64>(((u64(_e150) * 4294967296lu) + u64(_e147))), _e345);
                if (_e184.member == 0u) {
                    let _e348 = function_12((&local_1), (&local_2), _e346);
                    phi_725_ = _e348;
                } else {
                    phi_725_ = 0u;
                }
                let _e350 = phi_725_;
                let _e351 = function_11((&local_1), _e350);
                let _e352 = function_11((&local_2), _e350);
                if (_e184.member != 0u) {
                    phi_886_ = type_39(array<array<f64, 3>, 2>(array<f64, 3>((_e351[2][0] - _e351[0][0]), (_e351[2][1] - _e351[0][1]), (_e351[2][2] - _e351[0][2])), array<f64, 3>((_e352[2][0] - _e352[0][0]), (_e352[2][1] - _e352[0][1]), (_e352[2][2] - _e352[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e351[1][0] - _e351[0][0]), (_e351[1][1] - _e351[0][1]), (_e351[1][2] - _e351[0][2])), array<f64, 3>((_e352[1][0] - _e352[0][0]), (_e352[1][1] - _e352[0][1]), (_e352[1][2] - _e352[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e351[2][0] - _e351[3][0]), (_e351[2][1] - _e351[3][1]), (_e351[2][2] - _e351[3][2])), array<f64, 3>((_e352[2][0] - _e352[3][0]), (_e352[2][1] - _e352[3][1]), (_e352[2][2] - _e352[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_886_ = type_39(array<array<f64, 3>, 2>(array<f64, 3>((_e351[0][0] - _e351[1][0]), (_e351[0][1] - _e351[1][1]), (_e351[0][2] - _e351[1][2])), array<f64, 3>((_e352[0][0] - _e352[1][0]), (_e352[0][1] - _e352[1][1]), (_e352[0][2] - _e352[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e351[2][0] - _e351[1][0]), (_e351[2][1] - _e351[1][1]), (_e351[2][2] - _e351[1][2])), array<f64, 3>((_e352[2][0] - _e352[1][0]), (_e352[2][1] - _e352[1][1]), (_e352[2][2] - _e352[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e351[3][0] - _e351[1][0]), (_e351[3][1] - _e351[1][1]), (_e351[3][2] - _e351[1][2])), array<f64, 3>((_e352[3][0] - _e352[1][0]), (_e352[3][1] - _e352[1][1]), (_e352[3][2] - _e352[1][2]))), (0.0lf + 0.0lf));
                }
                let _e509 = phi_886_;
                let _e514 = function_10(_e509.member[0], _e509.member[1], _e346);
                let _e519 = function_10(_e509.member_1[0], _e509.member_1[1], _e346);
                let _e524 = function_10(_e509.member_2[0], _e509.member_2[1], _e346);
                let _e528 = select(_e514[0], -(_e514[0]), (_e514[0] < 0.0lf));
                let _e532 = select(_e514[1], -(_e514[1]), (_e514[1] < 0.0lf));
                let _e534 = select(_e532, _e528, (_e528 > _e532));
                let _e538 = select(_e514[2], -(_e514[2]), (_e514[2] < 0.0lf));
                let _e540 = select(_e538, _e534, (_e534 > _e538));
                let _e544 = select(_e519[0], -(_e519[0]), (_e519[0] < 0.0lf));
                let _e548 = select(_e519[1], -(_e519[1]), (_e519[1] < 0.0lf));
                let _e550 = select(_e548, _e544, (_e544 > _e548));
                let _e554 = select(_e519[2], -(_e519[2]), (_e519[2] < 0.0lf));
                let _e556 = select(_e554, _e550, (_e550 > _e554));
                let _e558 = select(_e556, _e540, (_e540 > _e556));
                let _e562 = select(_e524[0], -(_e524[0]), (_e524[0] < 0.0lf));
                let _e566 = select(_e524[1], -(_e524[1]), (_e524[1] < 0.0lf));
                let _e568 = select(_e566, _e562, (_e562 > _e566));
                let _e572 = select(_e524[2], -(_e524[2]), (_e524[2] < 0.0lf));
                let _e574 = select(_e572, _e568, (_e568 > _e572));
                let _e577 = function_9(select(_e574, _e558, (_e558 > _e574)));
                let _e585 = (_e519[0] * _e577);
                let _e587 = (_e519[1] * _e577);
                let _e589 = (_e519[2] * _e577);
                let _e591 = (_e524[0] * _e577);
                let _e593 = (_e524[1] * _e577);
                let _e595 = (_e524[2] * _e577);
                let _e601 = select(_e509.member[0][0], -(_e509.member[0][0]), (_e509.member[0][0] < 0.0lf));
                let _e605 = select(_e509.member[0][1], -(_e509.member[0][1]), (_e509.member[0][1] < 0.0lf));
                let _e607 = select(_e605, _e601, (_e601 > _e605));
                let _e611 = select(_e509.member[0][2], -(_e509.member[0][2]), (_e509.member[0][2] < 0.0lf));
                let _e613 = select(_e611, _e607, (_e607 > _e611));
                let _e619 = select(_e509.member[1][0], -(_e509.member[1][0]), (_e509.member[1][0] < 0.0lf));
                let _e623 = select(_e509.member[1][1], -(_e509.member[1][1]), (_e509.member[1][1] < 0.0lf));
                let _e625 = select(_e623, _e619, (_e619 > _e623));
                let _e629 = select(_e509.member[1][2], -(_e509.member[1][2]), (_e509.member[1][2] < 0.0lf));
                let _e631 = select(_e629, _e625, (_e625 > _e629));
                let _e641 = select(_e509.member_1[0][0], -(_e509.member_1[0][0]), (_e509.member_1[0][0] < 0.0lf));
                let _e645 = select(_e509.member_1[0][1], -(_e509.member_1[0][1]), (_e509.member_1[0][1] < 0.0lf));
                let _e647 = select(_e645, _e641, (_e641 > _e645));
                let _e651 = select(_e509.member_1[0][2], -(_e509.member_1[0][2]), (_e509.member_1[0][2] < 0.0lf));
                let _e653 = select(_e651, _e647, (_e647 > _e651));
                let _e659 = select(_e509.member_1[1][0], -(_e509.member_1[1][0]), (_e509.member_1[1][0] < 0.0lf));
                let _e663 = select(_e509.member_1[1][1], -(_e509.member_1[1][1]), (_e509.member_1[1][1] < 0.0lf));
                let _e665 = select(_e663, _e659, (_e659 > _e663));
                let _e669 = select(_e509.member_1[1][2], -(_e509.member_1[1][2]), (_e509.member_1[1][2] < 0.0lf));
                let _e671 = select(_e669, _e665, (_e665 > _e669));
                let _e675 = (select(_e671, _e653, (_e653 > _e671)) + _e509.member_3);
                let _e681 = select(_e509.member_2[0][0], -(_e509.member_2[0][0]), (_e509.member_2[0][0] < 0.0lf));
                let _e685 = select(_e509.member_2[0][1], -(_e509.member_2[0][1]), (_e509.member_2[0][1] < 0.0lf));
                let _e687 = select(_e685, _e681, (_e681 > _e685));
                let _e691 = select(_e509.member_2[0][2], -(_e509.member_2[0][2]), (_e509.member_2[0][2] < 0.0lf));
                let _e693 = select(_e691, _e687, (_e687 > _e691));
                let _e699 = select(_e509.member_2[1][0], -(_e509.member_2[1][0]), (_e509.member_2[1][0] < 0.0lf));
                let _e703 = select(_e509.member_2[1][1], -(_e509.member_2[1][1]), (_e509.member_2[1][1] < 0.0lf));
                let _e705 = select(_e703, _e699, (_e699 > _e703));
                let _e709 = select(_e509.member_2[1][2], -(_e509.member_2[1][2]), (_e509.member_2[1][2] < 0.0lf));
                let _e711 = select(_e709, _e705, (_e705 > _e709));
                let _e715 = (select(_e711, _e693, (_e693 > _e711)) + _e509.member_3);
                let _e717 = (1.1102230246251565e-16lf * f64(16f));
                let _e720 = (_e509.member_3 * f64(4f));
                let _e728 = ((_e587 * _e595) - (_e589 * _e593));
                let _e731 = ((_e589 * _e591) - (_e585 * _e595));
                let _e734 = ((_e585 * _e593) - (_e587 * _e591));
                let _e742 = select(_e591, -(_e591), (_e591 < 0.0lf));
                let _e745 = select(_e593, -(_e593), (_e593 < 0.0lf));
                let _e747 = select(_e745, _e742, (_e742 > _e745));
                let _e750 = select(_e595, -(_e595), (_e595 < 0.0lf));
                let _e757 = select(_e585, -(_e585), (_e585 < 0.0lf));
                let _e760 = select(_e587, -(_e587), (_e587 < 0.0lf));
                let _e762 = select(_e760, _e757, (_e757 > _e760));
                let _e765 = select(_e589, -(_e589), (_e589 < 0.0lf));
                let _e769 = (((((_e675 * _e717) + _e720) * _e577) * select(_e750, _e747, (_e747 > _e750))) + ((((_e715 * _e717) + _e720) * _e577) * select(_e765, _e762, (_e762 > _e765))));
                let _e774 = (((_e728 * _e728) + (_e731 * _e731)) + (_e734 * _e734));
                if (_e774 <= 2.2250738585072014e-308lf) {
                    phi_1401_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e774 > 0.0lf));
                } else {
                    phi_1344_ = type_16(0i, 5i);
                    phi_1347_ = bitcast<f64>(((bitcast<u64>(_e774) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e781 = phi_1344_;
                        let _e783 = phi_1347_;
                        local_3 = _e783;
                        if (_e781.member < _e781.member_1) {
                            let _e790 = (_e781.member + 1i);
                            phi_1345_ = type_16(select(_e790, type_17().member_1, select(false, true, ((false == (_e790 > _e781.member)) != false))), _e781.member_1);
                            phi_1388_ = type_17(1u, _e781.member);
                        } else {
                            phi_1345_ = _e781;
                            phi_1388_ = type_17(0u, type_17().member_1);
                        }
                        let _e801 = phi_1345_;
                        let _e803 = phi_1388_;
                        let _e806 = (bitcast<i32>(_e803.member) != 0i);
                        if _e806 {
                            phi_1348_ = (0.5lf * (_e783 + (_e774 / _e783)));
                        } else {
                            phi_1348_ = f64();
                        }
                        let _e811 = phi_1348_;
                        continue;
                        continuing {
                            phi_1344_ = _e801;
                            phi_1347_ = _e811;
                            break if !(_e806);
                        }
                    }
                    let _e816 = local_3;
                    phi_1401_ = (_e816 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e822 = phi_1401_;
                if (_e822 > f64(0f)) {
                    phi_1411_ = ((_e822 + (_e774 / _e822)) * f64(0.5f));
                } else {
                    phi_1411_ = _e822;
                }
                let _e830 = phi_1411_;
                local = type_31(array<f64, 3>((_e514[0] * _e577), (_e514[1] * _e577), (_e514[2] * _e577)), array<f64, 3>(_e585, _e587, _e589), array<f64, 3>(_e591, _e593, _e595), array<f64, 3>(_e728, _e731, _e734), select(f64(0f), _e830, (_e830 > _e769)), _e769, ((((((select(_e631, _e613, (_e613 > _e631)) + _e509.member_3) + _e675) + _e715) * _e717) + _e720) * _e577));
                let _e839 = function_8((&local), _e184.member);
                if (_e839.member_3 <= 2.2250738585072014e-308lf) {
                    phi_1524_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e839.member_3 > 0.0lf));
                } else {
                    phi_1467_ = type_16(0i, 5i);
                    phi_1470_ = bitcast<f64>(((bitcast<u64>(_e839.member_3) / 2lu) + 2303426169912950784lu));
                    loop {
                        let _e849 = phi_1467_;
                        let _e851 = phi_1470_;
                        local_4 = _e851;
                        if (_e849.member < _e849.member_1) {
                            let _e858 = (_e849.member + 1i);
                            phi_1468_ = type_16(select(_e858, type_17().member_1, select(false, true, ((false == (_e858 > _e849.member)) != false))), _e849.member_1);
                            phi_1511_ = type_17(1u, _e849.member);
                        } else {
                            phi_1468_ = _e849;
                            phi_1511_ = type_17(0u, type_17().member_1);
                        }
                        let _e869 = phi_1468_;
                        let _e871 = phi_1511_;
                        let _e874 = (bitcast<i32>(_e871.member) != 0i);
                        if _e874 {
                            phi_1471_ = (0.5lf * (_e851 + (_e839.member_3 / _e851)));
                        } else {
                            phi_1471_ = f64();
                        }
                        let _e879 = phi_1471_;
                        continue;
                        continuing {
                            phi_1467_ = _e869;
                            phi_1470_ = _e879;
                            break if !(_e874);
                        }
                    }
                    let _e884 = local_4;
                    phi_1524_ = (_e884 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                }
                let _e890 = phi_1524_;
                if (_e890 > f64(0f)) {
                    phi_1534_ = ((_e890 + (_e839.member_3 / _e890)) * f64(0.5f));
                } else {
                    phi_1534_ = _e890;
                }
                let _e898 = phi_1534_;
                let _e901 = select(-(_e345), _e345, (_e184.member == 0u));
                let _e903 = function_2(_e509.member);
                let _e905 = function_2(_e509.member_1);
                let _e919 = function_2(_e509.member_2);
                let _e929 = (((_e903[0] - (_e905[0] * _e839.member)) - (_e919[0] * _e839.member_1)) * _e901);
                let _e930 = (((_e903[1] - (_e905[1] * _e839.member)) - (_e919[1] * _e839.member_1)) * _e901);
                let _e931 = (((_e903[2] - (_e905[2] * _e839.member)) - (_e919[2] * _e839.member_1)) * _e901);
                let _e933 = f64(0f);
                let _e934 = f64(1f);
                let _e939 = select(false, (_e839.member < _e934), (_e839.member > _e933));
                let _e942 = select(false, (_e839.member_1 < _e934), (_e839.member_1 > _e933));
                let _e943 = (_e901 > _e933);
                let _e954 = select(select(bool(), select(bool(), select(true, ((_e839.member + _e839.member_1) < (_e934 - (1.1102230246251565e-16lf * f64(4f)))), _e943), _e942), _e939), false, select(true, select(true, false, _e942), _e939));
                let _e956 = local.member_4;
                let _e957 = (_e956 > _e933);
                let _e959 = local.member_3;
                let _e963 = (_e959[0] * _e901);
                let _e964 = (_e959[1] * _e901);
                let _e965 = (_e959[2] * _e901);
                let _e967 = local.member_6;
                if (_e898 > _e967) {
                    let _e1986 = (_e839.member_2[0] * _e901);
                    let _e1988 = (_e839.member_2[1] * _e901);
                    let _e1990 = (_e839.member_2[2] * _e901);
                    if _e957 {
                        if _e954 {
                            let _e1992 = local.member_5;
                            let _e1995 = local.member_6;
                            let _e1997 = local.member_4;
                            if ((_e1992 * _e898) <= (_e1995 * _e1997)) {
                                let _e2005 = ((((_e1986 * _e963) + (_e1988 * _e964)) + (_e1990 * _e965)) >= _e933);
                                let _e2006 = -(_e934);
                                let _e2010 = select((_e963 * _e2006), _e963, _e2005);
                                let _e2011 = select((_e964 * _e2006), _e964, _e2005);
                                let _e2012 = select((_e965 * _e2006), _e965, _e2005);
                                let _e2015 = select(_e2010, -(_e2010), (_e2010 < 0.0lf));
                                let _e2018 = select(_e2011, -(_e2011), (_e2011 < 0.0lf));
                                let _e2020 = select(_e2018, _e2015, (_e2015 > _e2018));
                                let _e2023 = select(_e2012, -(_e2012), (_e2012 < 0.0lf));
                                let _e2026 = function_9(select(_e2023, _e2020, (_e2020 > _e2023)));
                                let _e2027 = (_e2010 * _e2026);
                                let _e2028 = (_e2011 * _e2026);
                                let _e2029 = (_e2012 * _e2026);
                                let _e2035 = (((_e2027 * _e2027) + (_e2028 * _e2028)) + (_e2029 * _e2029));
                                if (_e2035 <= 2.2250738585072014e-308lf) {
                                    phi_1795_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2035 > 0.0lf));
                                } else {
                                    phi_1738_ = type_16(0i, 5i);
                                    phi_1741_ = bitcast<f64>(((bitcast<u64>(_e2035) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2042 = phi_1738_;
                                        let _e2044 = phi_1741_;
                                        local_11 = _e2044;
                                        if (_e2042.member < _e2042.member_1) {
                                            let _e2051 = (_e2042.member + 1i);
                                            phi_1739_ = type_16(select(_e2051, type_17().member_1, select(false, true, ((false == (_e2051 > _e2042.member)) != false))), _e2042.member_1);
                                            phi_1782_ = type_17(1u, _e2042.member);
                                        } else {
                                            phi_1739_ = _e2042;
                                            phi_1782_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2062 = phi_1739_;
                                        let _e2064 = phi_1782_;
                                        let _e2067 = (bitcast<i32>(_e2064.member) != 0i);
                                        if _e2067 {
                                            phi_1742_ = (0.5lf * (_e2044 + (_e2035 / _e2044)));
                                        } else {
                                            phi_1742_ = f64();
                                        }
                                        let _e2072 = phi_1742_;
                                        continue;
                                        continuing {
                                            phi_1738_ = _e2062;
                                            phi_1741_ = _e2072;
                                            break if !(_e2067);
                                        }
                                    }
                                    let _e2077 = local_11;
                                    phi_1795_ = (_e2077 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e2083 = phi_1795_;
                                let _e2084 = (f64(1f) / _e2083);
                                let _e2085 = (_e2027 * _e2084);
                                let _e2086 = (_e2028 * _e2084);
                                let _e2087 = (_e2029 * _e2084);
                                let _e2096 = ((f64(3f) - (((_e2085 * _e2085) + (_e2086 * _e2086)) + (_e2087 * _e2087))) * f64(0.5f));
                                phi_1813_ = array<f64, 3>((_e2085 * _e2096), (_e2086 * _e2096), (_e2087 * _e2096));
                                phi_1814_ = false;
                            } else {
                                phi_1813_ = array<f64, 3>();
                                phi_1814_ = true;
                            }
                            let _e2102 = phi_1813_;
                            let _e2104 = phi_1814_;
                            phi_1815_ = _e2102;
                            phi_1816_ = _e2104;
                        } else {
                            phi_1815_ = array<f64, 3>();
                            phi_1816_ = true;
                        }
                        let _e2106 = phi_1815_;
                        let _e2108 = phi_1816_;
                        phi_1817_ = _e2106;
                        phi_1818_ = _e2108;
                    } else {
                        phi_1817_ = array<f64, 3>();
                        phi_1818_ = true;
                    }
                    let _e2110 = phi_1817_;
                    let _e2112 = phi_1818_;
                    if _e2112 {
                        let _e2115 = select(_e1986, -(_e1986), (_e1986 < 0.0lf));
                        let _e2118 = select(_e1988, -(_e1988), (_e1988 < 0.0lf));
                        let _e2120 = select(_e2118, _e2115, (_e2115 > _e2118));
                        let _e2123 = select(_e1990, -(_e1990), (_e1990 < 0.0lf));
                        let _e2126 = function_9(select(_e2123, _e2120, (_e2120 > _e2123)));
                        let _e2127 = (_e1986 * _e2126);
                        let _e2128 = (_e1988 * _e2126);
                        let _e2129 = (_e1990 * _e2126);
                        let _e2135 = (((_e2127 * _e2127) + (_e2128 * _e2128)) + (_e2129 * _e2129));
                        if (_e2135 <= 2.2250738585072014e-308lf) {
                            phi_1937_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e2135 > 0.0lf));
                        } else {
                            phi_1880_ = type_16(0i, 5i);
                            phi_1883_ = bitcast<f64>(((bitcast<u64>(_e2135) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e2142 = phi_1880_;
                                let _e2144 = phi_1883_;
                                local_12 = _e2144;
                                if (_e2142.member < _e2142.member_1) {
                                    let _e2151 = (_e2142.member + 1i);
                                    phi_1881_ = type_16(select(_e2151, type_17().member_1, select(false, true, ((false == (_e2151 > _e2142.member)) != false))), _e2142.member_1);
                                    phi_1924_ = type_17(1u, _e2142.member);
                                } else {
                                    phi_1881_ = _e2142;
                                    phi_1924_ = type_17(0u, type_17().member_1);
                                }
                                let _e2162 = phi_1881_;
                                let _e2164 = phi_1924_;
                                let _e2167 = (bitcast<i32>(_e2164.member) != 0i);
                                if _e2167 {
                                    phi_1884_ = (0.5lf * (_e2144 + (_e2135 / _e2144)));
                                } else {
                                    phi_1884_ = f64();
                                }
                                let _e2172 = phi_1884_;
                                continue;
                                continuing {
                                    phi_1880_ = _e2162;
                                    phi_1883_ = _e2172;
                                    break if !(_e2167);
                                }
                            }
                            let _e2177 = local_12;
                            phi_1937_ = (_e2177 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e2183 = phi_1937_;
                        let _e2184 = (f64(1f) / _e2183);
                        let _e2185 = (_e2127 * _e2184);
                        let _e2186 = (_e2128 * _e2184);
                        let _e2187 = (_e2129 * _e2184);
                        let _e2196 = ((f64(3f) - (((_e2185 * _e2185) + (_e2186 * _e2186)) + (_e2187 * _e2187))) * f64(0.5f));
                        phi_1955_ = array<f64, 3>((_e2185 * _e2196), (_e2186 * _e2196), (_e2187 * _e2196));
                    } else {
                        phi_1955_ = _e2110;
                    }
                    let _e2202 = phi_1955_;
                    phi_3554_ = _e2202;
                    phi_3555_ = array<f64, 3>();
                    phi_3556_ = true;
                } else {
                    let _e974 = select(_e509.member[0][0], -(_e509.member[0][0]), (_e509.member[0][0] < 0.0lf));
                    let _e978 = select(_e509.member[0][1], -(_e509.member[0][1]), (_e509.member[0][1] < 0.0lf));
                    let _e980 = select(_e978, _e974, (_e974 > _e978));
                    let _e984 = select(_e509.member[0][2], -(_e509.member[0][2]), (_e509.member[0][2] < 0.0lf));
                    let _e986 = select(_e984, _e980, (_e980 > _e984));
                    let _e992 = select(_e509.member[1][0], -(_e509.member[1][0]), (_e509.member[1][0] < 0.0lf));
                    let _e996 = select(_e509.member[1][1], -(_e509.member[1][1]), (_e509.member[1][1] < 0.0lf));
                    let _e998 = select(_e996, _e992, (_e992 > _e996));
                    let _e1002 = select(_e509.member[1][2], -(_e509.member[1][2]), (_e509.member[1][2] < 0.0lf));
                    let _e1004 = select(_e1002, _e998, (_e998 > _e1002));
                    let _e1014 = select(_e509.member_1[0][0], -(_e509.member_1[0][0]), (_e509.member_1[0][0] < 0.0lf));
                    let _e1018 = select(_e509.member_1[0][1], -(_e509.member_1[0][1]), (_e509.member_1[0][1] < 0.0lf));
                    let _e1020 = select(_e1018, _e1014, (_e1014 > _e1018));
                    let _e1024 = select(_e509.member_1[0][2], -(_e509.member_1[0][2]), (_e509.member_1[0][2] < 0.0lf));
                    let _e1026 = select(_e1024, _e1020, (_e1020 > _e1024));
                    let _e1032 = select(_e509.member_1[1][0], -(_e509.member_1[1][0]), (_e509.member_1[1][0] < 0.0lf));
                    let _e1036 = select(_e509.member_1[1][1], -(_e509.member_1[1][1]), (_e509.member_1[1][1] < 0.0lf));
                    let _e1038 = select(_e1036, _e1032, (_e1032 > _e1036));
                    let _e1042 = select(_e509.member_1[1][2], -(_e509.member_1[1][2]), (_e509.member_1[1][2] < 0.0lf));
                    let _e1044 = select(_e1042, _e1038, (_e1038 > _e1042));
                    let _e1054 = select(_e509.member_2[0][0], -(_e509.member_2[0][0]), (_e509.member_2[0][0] < 0.0lf));
                    let _e1058 = select(_e509.member_2[0][1], -(_e509.member_2[0][1]), (_e509.member_2[0][1] < 0.0lf));
                    let _e1060 = select(_e1058, _e1054, (_e1054 > _e1058));
                    let _e1064 = select(_e509.member_2[0][2], -(_e509.member_2[0][2]), (_e509.member_2[0][2] < 0.0lf));
                    let _e1066 = select(_e1064, _e1060, (_e1060 > _e1064));
                    let _e1072 = select(_e509.member_2[1][0], -(_e509.member_2[1][0]), (_e509.member_2[1][0] < 0.0lf));
                    let _e1076 = select(_e509.member_2[1][1], -(_e509.member_2[1][1]), (_e509.member_2[1][1] < 0.0lf));
                    let _e1078 = select(_e1076, _e1072, (_e1072 > _e1076));
                    let _e1082 = select(_e509.member_2[1][2], -(_e509.member_2[1][2]), (_e509.member_2[1][2] < 0.0lf));
                    let _e1084 = select(_e1082, _e1078, (_e1078 > _e1082));
                    let _e1097 = (((((select(_e1004, _e986, (_e986 > _e1004)) + _e509.member_3) + (select(_e1044, _e1026, (_e1026 > _e1044)) + _e509.member_3)) + (select(_e1084, _e1066, (_e1066 > _e1084)) + _e509.member_3)) * (1.1102230246251565e-16lf * f64(32f))) + (_e509.member_3 * f64(8f)));
                    if _e957 {
                        let _e1100 = select(_e963, -(_e963), (_e963 < 0.0lf));
                        let _e1103 = select(_e964, -(_e964), (_e964 < 0.0lf));
                        let _e1105 = select(_e1103, _e1100, (_e1100 > _e1103));
                        let _e1108 = select(_e965, -(_e965), (_e965 < 0.0lf));
                        let _e1111 = function_9(select(_e1108, _e1105, (_e1105 > _e1108)));
                        let _e1112 = (_e963 * _e1111);
                        let _e1113 = (_e964 * _e1111);
                        let _e1114 = (_e965 * _e1111);
                        let _e1120 = (((_e1112 * _e1112) + (_e1113 * _e1113)) + (_e1114 * _e1114));
                        if (_e1120 <= 2.2250738585072014e-308lf) {
                            phi_2296_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1120 > 0.0lf));
                        } else {
                            phi_2239_ = type_16(0i, 5i);
                            phi_2242_ = bitcast<f64>(((bitcast<u64>(_e1120) / 2lu) + 2303426169912950784lu));
                            loop {
                                let _e1127 = phi_2239_;
                                let _e1129 = phi_2242_;
                                local_5 = _e1129;
                                if (_e1127.member < _e1127.member_1) {
                                    let _e1136 = (_e1127.member + 1i);
                                    phi_2240_ = type_16(select(_e1136, type_17().member_1, select(false, true, ((false == (_e1136 > _e1127.member)) != false))), _e1127.member_1);
                                    phi_2283_ = type_17(1u, _e1127.member);
                                } else {
                                    phi_2240_ = _e1127;
                                    phi_2283_ = type_17(0u, type_17().member_1);
                                }
                                let _e1147 = phi_2240_;
                                let _e1149 = phi_2283_;
                                let _e1152 = (bitcast<i32>(_e1149.member) != 0i);
                                if _e1152 {
                                    phi_2243_ = (0.5lf * (_e1129 + (_e1120 / _e1129)));
                                } else {
                                    phi_2243_ = f64();
                                }
                                let _e1157 = phi_2243_;
                                continue;
                                continuing {
                                    phi_2239_ = _e1147;
                                    phi_2242_ = _e1157;
                                    break if !(_e1152);
                                }
                            }
                            let _e1162 = local_5;
                            phi_2296_ = (_e1162 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                        }
                        let _e1168 = phi_2296_;
                        let _e1169 = (f64(1f) / _e1168);
                        let _e1170 = (_e1112 * _e1169);
                        let _e1171 = (_e1113 * _e1169);
                        let _e1172 = (_e1114 * _e1169);
                        let _e1181 = ((f64(3f) - (((_e1170 * _e1170) + (_e1171 * _e1171)) + (_e1172 * _e1172))) * f64(0.5f));
                        let _e1182 = (_e1170 * _e1181);
                        let _e1183 = (_e1171 * _e1181);
                        let _e1184 = (_e1172 * _e1181);
                        let _e1189 = (((_e929 * _e1182) + (_e930 * _e1183)) + (_e931 * _e1184));
                        let _e1202 = local.member_5;
                        let _e1204 = local.member_4;
                        if (select(_e1189, -(_e1189), (_e1189 < 0.0lf)) > (_e1097 + (((select(_e929, -(_e929), (_e929 < 0.0lf)) + select(_e930, -(_e930), (_e930 < 0.0lf))) + select(_e931, -(_e931), (_e931 < 0.0lf))) * (_e1202 / _e1204)))) {
                            let _e1212 = (_e1189 < _e933);
                            let _e1213 = -(_e934);
                            phi_2366_ = array<f64, 3>(select((_e1182 * _e1213), _e1182, _e1212), select((_e1183 * _e1213), _e1183, _e1212), select((_e1184 * _e1213), _e1184, _e1212));
                            phi_2367_ = false;
                        } else {
                            phi_2366_ = array<f64, 3>();
                            phi_2367_ = true;
                        }
                        let _e1222 = phi_2366_;
                        let _e1224 = phi_2367_;
                        phi_2368_ = _e1222;
                        phi_2369_ = _e1224;
                    } else {
                        phi_2368_ = array<f64, 3>();
                        phi_2369_ = true;
                    }
                    let _e1226 = phi_2368_;
                    let _e1228 = phi_2369_;
                    if _e1228 {
                        if select(true, select(true, false, _e954), _e957) {
                            if _e943 {
                                if _e939 {
                                    if _e942 {
                                        let _e1232 = local.member_2;
                                        let _e1237 = local.member_1;
                                        phi_2415_ = array<f64, 3>((_e1232[0] - _e1237[0]), (_e1232[1] - _e1237[1]), (_e1232[2] - _e1237[2]));
                                        phi_2416_ = false;
                                    } else {
                                        phi_2415_ = array<f64, 3>();
                                        phi_2416_ = true;
                                    }
                                    let _e1246 = phi_2415_;
                                    let _e1248 = phi_2416_;
                                    phi_2417_ = _e1246;
                                    phi_2418_ = _e1248;
                                } else {
                                    phi_2417_ = array<f64, 3>();
                                    phi_2418_ = true;
                                }
                                let _e1250 = phi_2417_;
                                let _e1252 = phi_2418_;
                                phi_2419_ = _e1250;
                                phi_2420_ = _e1252;
                            } else {
                                phi_2419_ = array<f64, 3>();
                                phi_2420_ = true;
                            }
                            let _e1254 = phi_2419_;
                            let _e1256 = phi_2420_;
                            if _e1256 {
                                if _e939 {
                                    if _e942 {
                                        let _e1258 = local.member_2;
                                        let _e1264 = select(_e1258[0], -(_e1258[0]), (_e1258[0] < 0.0lf));
                                        let _e1267 = select(_e1258[1], -(_e1258[1]), (_e1258[1] < 0.0lf));
                                        let _e1269 = select(_e1267, _e1264, (_e1264 > _e1267));
                                        let _e1272 = select(_e1258[2], -(_e1258[2]), (_e1258[2] < 0.0lf));
                                        let _e1276 = local.member_1;
                                        let _e1282 = select(_e1276[0], -(_e1276[0]), (_e1276[0] < 0.0lf));
                                        let _e1285 = select(_e1276[1], -(_e1276[1]), (_e1276[1] < 0.0lf));
                                        let _e1287 = select(_e1285, _e1282, (_e1282 > _e1285));
                                        let _e1290 = select(_e1276[2], -(_e1276[2]), (_e1276[2] < 0.0lf));
                                        phi_2509_ = select(true, false, (select(_e1272, _e1269, (_e1269 > _e1272)) > select(_e1290, _e1287, (_e1287 > _e1290))));
                                    } else {
                                        phi_2509_ = true;
                                    }
                                    let _e1296 = phi_2509_;
                                    if _e1296 {
                                        let _e1298 = local.member_1;
                                        phi_2519_ = array<f64, 3>(_e1298[0], _e1298[1], _e1298[2]);
                                        phi_2520_ = false;
                                    } else {
                                        phi_2519_ = array<f64, 3>();
                                        phi_2520_ = true;
                                    }
                                    let _e1304 = phi_2519_;
                                    let _e1306 = phi_2520_;
                                    phi_2521_ = _e1304;
                                    phi_2522_ = _e1306;
                                } else {
                                    phi_2521_ = array<f64, 3>();
                                    phi_2522_ = true;
                                }
                                let _e1308 = phi_2521_;
                                let _e1310 = phi_2522_;
                                if _e1310 {
                                    if _e942 {
                                        let _e1313 = local.member_2;
                                        phi_2536_ = array<f64, 3>(_e1313[0], _e1313[1], _e1313[2]);
                                    } else {
                                        phi_2536_ = array<f64, 3>(_e933, _e933, _e933);
                                    }
                                    let _e1319 = phi_2536_;
                                    phi_2537_ = _e1319;
                                } else {
                                    phi_2537_ = _e1308;
                                }
                                let _e1321 = phi_2537_;
                                phi_2538_ = _e1321;
                            } else {
                                phi_2538_ = _e1254;
                            }
                            let _e1323 = phi_2538_;
                            let _e1327 = select(_e1323[0], -(_e1323[0]), (_e1323[0] < 0.0lf));
                            let _e1331 = select(_e1323[1], -(_e1323[1]), (_e1323[1] < 0.0lf));
                            let _e1333 = select(_e1331, _e1327, (_e1327 > _e1331));
                            let _e1337 = select(_e1323[2], -(_e1323[2]), (_e1323[2] < 0.0lf));
                            let _e1341 = local.member_6;
                            let _e1342 = (select(_e1337, _e1333, (_e1333 > _e1337)) > _e1341);
                            let _e1344 = select(_e933, _e1323[0], _e1342);
                            let _e1346 = select(_e933, _e1323[1], _e1342);
                            let _e1348 = select(_e933, _e1323[2], _e1342);
                            let _e1351 = select(_e1344, -(_e1344), (_e1344 < 0.0lf));
                            let _e1354 = select(_e1346, -(_e1346), (_e1346 < 0.0lf));
                            let _e1356 = select(_e1354, _e1351, (_e1351 > _e1354));
                            let _e1359 = select(_e1348, -(_e1348), (_e1348 < 0.0lf));
                            if (select(_e1359, _e1356, (_e1356 > _e1359)) > f64(0f)) {
                                let _e1366 = select(_e1344, -(_e1344), (_e1344 < 0.0lf));
                                let _e1369 = select(_e1346, -(_e1346), (_e1346 < 0.0lf));
                                let _e1371 = select(_e1369, _e1366, (_e1366 > _e1369));
                                let _e1374 = select(_e1348, -(_e1348), (_e1348 < 0.0lf));
                                let _e1377 = function_9(select(_e1374, _e1371, (_e1371 > _e1374)));
                                let _e1378 = (_e1344 * _e1377);
                                let _e1379 = (_e1346 * _e1377);
                                let _e1380 = (_e1348 * _e1377);
                                let _e1386 = (((_e1378 * _e1378) + (_e1379 * _e1379)) + (_e1380 * _e1380));
                                if (_e1386 <= 2.2250738585072014e-308lf) {
                                    phi_2735_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1386 > 0.0lf));
                                } else {
                                    phi_2678_ = type_16(0i, 5i);
                                    phi_2681_ = bitcast<f64>(((bitcast<u64>(_e1386) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1393 = phi_2678_;
                                        let _e1395 = phi_2681_;
                                        local_6 = _e1395;
                                        if (_e1393.member < _e1393.member_1) {
                                            let _e1402 = (_e1393.member + 1i);
                                            phi_2679_ = type_16(select(_e1402, type_17().member_1, select(false, true, ((false == (_e1402 > _e1393.member)) != false))), _e1393.member_1);
                                            phi_2722_ = type_17(1u, _e1393.member);
                                        } else {
                                            phi_2679_ = _e1393;
                                            phi_2722_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1413 = phi_2679_;
                                        let _e1415 = phi_2722_;
                                        let _e1418 = (bitcast<i32>(_e1415.member) != 0i);
                                        if _e1418 {
                                            phi_2682_ = (0.5lf * (_e1395 + (_e1386 / _e1395)));
                                        } else {
                                            phi_2682_ = f64();
                                        }
                                        let _e1423 = phi_2682_;
                                        continue;
                                        continuing {
                                            phi_2678_ = _e1413;
                                            phi_2681_ = _e1423;
                                            break if !(_e1418);
                                        }
                                    }
                                    let _e1428 = local_6;
                                    phi_2735_ = (_e1428 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1434 = phi_2735_;
                                let _e1435 = (f64(1f) / _e1434);
                                let _e1436 = (_e1378 * _e1435);
                                let _e1437 = (_e1379 * _e1435);
                                let _e1438 = (_e1380 * _e1435);
                                let _e1447 = ((f64(3f) - (((_e1436 * _e1436) + (_e1437 * _e1437)) + (_e1438 * _e1438))) * f64(0.5f));
                                let _e1448 = (_e1436 * _e1447);
                                let _e1449 = (_e1437 * _e1447);
                                let _e1450 = (_e1438 * _e1447);
                                let _e1455 = (((_e929 * _e1448) + (_e930 * _e1449)) + (_e931 * _e1450));
                                phi_2764_ = array<f64, 3>((_e929 - (_e1448 * _e1455)), (_e930 - (_e1449 * _e1455)), (_e931 - (_e1450 * _e1455)));
                            } else {
                                phi_2764_ = array<f64, 3>(_e929, _e930, _e931);
                            }
                            let _e1464 = phi_2764_;
                            if (((select(_e1464[0], -(_e1464[0]), (_e1464[0] < 0.0lf)) + select(_e1464[1], -(_e1464[1]), (_e1464[1] < 0.0lf))) + select(_e1464[2], -(_e1464[2]), (_e1464[2] < 0.0lf))) > _e1097) {
                                let _e1480 = -(_e934);
                                let _e1482 = (_e1464[0] * _e1480);
                                let _e1484 = (_e1464[1] * _e1480);
                                let _e1486 = (_e1464[2] * _e1480);
                                let _e1489 = select(_e1482, -(_e1482), (_e1482 < 0.0lf));
                                let _e1492 = select(_e1484, -(_e1484), (_e1484 < 0.0lf));
                                let _e1494 = select(_e1492, _e1489, (_e1489 > _e1492));
                                let _e1497 = select(_e1486, -(_e1486), (_e1486 < 0.0lf));
                                let _e1500 = function_9(select(_e1497, _e1494, (_e1494 > _e1497)));
                                let _e1501 = (_e1482 * _e1500);
                                let _e1502 = (_e1484 * _e1500);
                                let _e1503 = (_e1486 * _e1500);
                                let _e1509 = (((_e1501 * _e1501) + (_e1502 * _e1502)) + (_e1503 * _e1503));
                                if (_e1509 <= 2.2250738585072014e-308lf) {
                                    phi_2914_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1509 > 0.0lf));
                                } else {
                                    phi_2857_ = type_16(0i, 5i);
                                    phi_2860_ = bitcast<f64>(((bitcast<u64>(_e1509) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1516 = phi_2857_;
                                        let _e1518 = phi_2860_;
                                        local_7 = _e1518;
                                        if (_e1516.member < _e1516.member_1) {
                                            let _e1525 = (_e1516.member + 1i);
                                            phi_2858_ = type_16(select(_e1525, type_17().member_1, select(false, true, ((false == (_e1525 > _e1516.member)) != false))), _e1516.member_1);
                                            phi_2901_ = type_17(1u, _e1516.member);
                                        } else {
                                            phi_2858_ = _e1516;
                                            phi_2901_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1536 = phi_2858_;
                                        let _e1538 = phi_2901_;
                                        let _e1541 = (bitcast<i32>(_e1538.member) != 0i);
                                        if _e1541 {
                                            phi_2861_ = (0.5lf * (_e1518 + (_e1509 / _e1518)));
                                        } else {
                                            phi_2861_ = f64();
                                        }
                                        let _e1546 = phi_2861_;
                                        continue;
                                        continuing {
                                            phi_2857_ = _e1536;
                                            phi_2860_ = _e1546;
                                            break if !(_e1541);
                                        }
                                    }
                                    let _e1551 = local_7;
                                    phi_2914_ = (_e1551 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1557 = phi_2914_;
                                let _e1558 = (f64(1f) / _e1557);
                                let _e1559 = (_e1501 * _e1558);
                                let _e1560 = (_e1502 * _e1558);
                                let _e1561 = (_e1503 * _e1558);
                                let _e1570 = ((f64(3f) - (((_e1559 * _e1559) + (_e1560 * _e1560)) + (_e1561 * _e1561))) * f64(0.5f));
                                phi_2932_ = array<f64, 3>((_e1559 * _e1570), (_e1560 * _e1570), (_e1561 * _e1570));
                                phi_2933_ = false;
                            } else {
                                phi_2932_ = array<f64, 3>();
                                phi_2933_ = true;
                            }
                            let _e1576 = phi_2932_;
                            let _e1578 = phi_2933_;
                            phi_2934_ = _e1576;
                            phi_2935_ = _e1578;
                        } else {
                            phi_2934_ = array<f64, 3>();
                            phi_2935_ = true;
                        }
                        let _e1580 = phi_2934_;
                        let _e1582 = phi_2935_;
                        if _e1582 {
                            if _e957 {
                                let _e1863 = select(_e963, -(_e963), (_e963 < 0.0lf));
                                let _e1866 = select(_e964, -(_e964), (_e964 < 0.0lf));
                                let _e1868 = select(_e1866, _e1863, (_e1863 > _e1866));
                                let _e1871 = select(_e965, -(_e965), (_e965 < 0.0lf));
                                let _e1874 = function_9(select(_e1871, _e1868, (_e1868 > _e1871)));
                                let _e1875 = (_e963 * _e1874);
                                let _e1876 = (_e964 * _e1874);
                                let _e1877 = (_e965 * _e1874);
                                let _e1883 = (((_e1875 * _e1875) + (_e1876 * _e1876)) + (_e1877 * _e1877));
                                if (_e1883 <= 2.2250738585072014e-308lf) {
                                    phi_3057_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1883 > 0.0lf));
                                } else {
                                    phi_3000_ = type_16(0i, 5i);
                                    phi_3003_ = bitcast<f64>(((bitcast<u64>(_e1883) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e1890 = phi_3000_;
                                        let _e1892 = phi_3003_;
                                        local_10 = _e1892;
                                        if (_e1890.member < _e1890.member_1) {
                                            let _e1899 = (_e1890.member + 1i);
                                            phi_3001_ = type_16(select(_e1899, type_17().member_1, select(false, true, ((false == (_e1899 > _e1890.member)) != false))), _e1890.member_1);
                                            phi_3044_ = type_17(1u, _e1890.member);
                                        } else {
                                            phi_3001_ = _e1890;
                                            phi_3044_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e1910 = phi_3001_;
                                        let _e1912 = phi_3044_;
                                        let _e1915 = (bitcast<i32>(_e1912.member) != 0i);
                                        if _e1915 {
                                            phi_3004_ = (0.5lf * (_e1892 + (_e1883 / _e1892)));
                                        } else {
                                            phi_3004_ = f64();
                                        }
                                        let _e1920 = phi_3004_;
                                        continue;
                                        continuing {
                                            phi_3000_ = _e1910;
                                            phi_3003_ = _e1920;
                                            break if !(_e1915);
                                        }
                                    }
                                    let _e1925 = local_10;
                                    phi_3057_ = (_e1925 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e1931 = phi_3057_;
                                let _e1932 = (f64(1f) / _e1931);
                                let _e1933 = (_e1875 * _e1932);
                                let _e1934 = (_e1876 * _e1932);
                                let _e1935 = (_e1877 * _e1932);
                                let _e1944 = ((f64(3f) - (((_e1933 * _e1933) + (_e1934 * _e1934)) + (_e1935 * _e1935))) * f64(0.5f));
                                phi_3524_ = array<f64, 3>((_e1933 * _e1944), (_e1934 * _e1944), (_e1935 * _e1944));
                            } else {
                                let _e1584 = local.member_1;
                                let _e1589 = local.member_2;
                                let _e1593 = f64(0f);
                                let _e1594 = f64(1f);
                                let _e1597 = select(_e1589[0], -(_e1589[0]), (_e1589[0] < 0.0lf));
                                let _e1600 = select(_e1589[1], -(_e1589[1]), (_e1589[1] < 0.0lf));
                                let _e1602 = select(_e1600, _e1597, (_e1597 > _e1600));
                                let _e1605 = select(_e1589[2], -(_e1589[2]), (_e1589[2] < 0.0lf));
                                let _e1610 = select(_e1584[0], -(_e1584[0]), (_e1584[0] < 0.0lf));
                                let _e1613 = select(_e1584[1], -(_e1584[1]), (_e1584[1] < 0.0lf));
                                let _e1615 = select(_e1613, _e1610, (_e1610 > _e1613));
                                let _e1618 = select(_e1584[2], -(_e1584[2]), (_e1584[2] < 0.0lf));
                                let _e1621 = (select(_e1605, _e1602, (_e1602 > _e1605)) > select(_e1618, _e1615, (_e1615 > _e1618)));
                                let _e1622 = select(_e1584[0], _e1589[0], _e1621);
                                let _e1623 = select(_e1584[1], _e1589[1], _e1621);
                                let _e1624 = select(_e1584[2], _e1589[2], _e1621);
                                let _e1627 = select(_e1622, -(_e1622), (_e1622 < 0.0lf));
                                let _e1630 = select(_e1623, -(_e1623), (_e1623 < 0.0lf));
                                let _e1632 = select(_e1630, _e1627, (_e1627 > _e1630));
                                let _e1635 = select(_e1624, -(_e1624), (_e1624 < 0.0lf));
                                if (select(_e1635, _e1632, (_e1632 > _e1635)) > _e1593) {
                                    let _e1642 = select(_e1622, -(_e1622), (_e1622 < 0.0lf));
                                    let _e1645 = select(_e1623, -(_e1623), (_e1623 < 0.0lf));
                                    let _e1648 = select(_e1624, -(_e1624), (_e1624 < 0.0lf));
                                    if (_e1642 <= _e1645) {
                                        let _e1650 = (_e1642 <= _e1648);
                                        phi_3223_ = array<f64, 3>(select(array<f64, 3>()[0], _e1594, _e1650), select(array<f64, 3>()[1], _e1593, _e1650), select(array<f64, 3>()[2], _e1593, _e1650));
                                        phi_3224_ = select(true, false, _e1650);
                                    } else {
                                        phi_3223_ = array<f64, 3>();
                                        phi_3224_ = true;
                                    }
                                    let _e1660 = phi_3223_;
                                    let _e1662 = phi_3224_;
                                    if _e1662 {
                                        let _e1663 = (_e1645 <= _e1648);
                                        phi_3235_ = array<f64, 3>(_e1593, select(_e1593, _e1594, _e1663), select(_e1594, _e1593, _e1663));
                                    } else {
                                        phi_3235_ = _e1660;
                                    }
                                    let _e1668 = phi_3235_;
                                    let _e1671 = select(_e1622, -(_e1622), (_e1622 < 0.0lf));
                                    let _e1674 = select(_e1623, -(_e1623), (_e1623 < 0.0lf));
                                    let _e1676 = select(_e1674, _e1671, (_e1671 > _e1674));
                                    let _e1679 = select(_e1624, -(_e1624), (_e1624 < 0.0lf));
                                    let _e1682 = function_9(select(_e1679, _e1676, (_e1676 > _e1679)));
                                    let _e1683 = (_e1622 * _e1682);
                                    let _e1684 = (_e1623 * _e1682);
                                    let _e1685 = (_e1624 * _e1682);
                                    let _e1691 = (((_e1683 * _e1683) + (_e1684 * _e1684)) + (_e1685 * _e1685));
                                    if (_e1691 <= 2.2250738585072014e-308lf) {
                                        phi_3357_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1691 > 0.0lf));
                                    } else {
                                        phi_3300_ = type_16(0i, 5i);
                                        phi_3303_ = bitcast<f64>(((bitcast<u64>(_e1691) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1698 = phi_3300_;
                                            let _e1700 = phi_3303_;
                                            local_8 = _e1700;
                                            if (_e1698.member < _e1698.member_1) {
                                                let _e1707 = (_e1698.member + 1i);
                                                phi_3301_ = type_16(select(_e1707, type_17().member_1, select(false, true, ((false == (_e1707 > _e1698.member)) != false))), _e1698.member_1);
                                                phi_3344_ = type_17(1u, _e1698.member);
                                            } else {
                                                phi_3301_ = _e1698;
                                                phi_3344_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e1718 = phi_3301_;
                                            let _e1720 = phi_3344_;
                                            let _e1723 = (bitcast<i32>(_e1720.member) != 0i);
                                            if _e1723 {
                                                phi_3304_ = (0.5lf * (_e1700 + (_e1691 / _e1700)));
                                            } else {
                                                phi_3304_ = f64();
                                            }
                                            let _e1728 = phi_3304_;
                                            continue;
                                            continuing {
                                                phi_3300_ = _e1718;
                                                phi_3303_ = _e1728;
                                                break if !(_e1723);
                                            }
                                        }
                                        let _e1733 = local_8;
                                        phi_3357_ = (_e1733 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1739 = phi_3357_;
                                    let _e1740 = (f64(1f) / _e1739);
                                    let _e1741 = (_e1683 * _e1740);
                                    let _e1742 = (_e1684 * _e1740);
                                    let _e1743 = (_e1685 * _e1740);
                                    let _e1752 = ((f64(3f) - (((_e1741 * _e1741) + (_e1742 * _e1742)) + (_e1743 * _e1743))) * f64(0.5f));
                                    let _e1753 = (_e1741 * _e1752);
                                    let _e1754 = (_e1742 * _e1752);
                                    let _e1755 = (_e1743 * _e1752);
                                    let _e1760 = ((_e1754 * _e1668[2]) - (_e1755 * _e1668[1]));
                                    let _e1765 = ((_e1755 * _e1668[0]) - (_e1753 * _e1668[2]));
                                    let _e1770 = ((_e1753 * _e1668[1]) - (_e1754 * _e1668[0]));
                                    let _e1773 = select(_e1760, -(_e1760), (_e1760 < 0.0lf));
                                    let _e1776 = select(_e1765, -(_e1765), (_e1765 < 0.0lf));
                                    let _e1778 = select(_e1776, _e1773, (_e1773 > _e1776));
                                    let _e1781 = select(_e1770, -(_e1770), (_e1770 < 0.0lf));
                                    let _e1784 = function_9(select(_e1781, _e1778, (_e1778 > _e1781)));
                                    let _e1785 = (_e1760 * _e1784);
                                    let _e1786 = (_e1765 * _e1784);
                                    let _e1787 = (_e1770 * _e1784);
                                    let _e1793 = (((_e1785 * _e1785) + (_e1786 * _e1786)) + (_e1787 * _e1787));
                                    if (_e1793 <= 2.2250738585072014e-308lf) {
                                        phi_3504_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e1793 > 0.0lf));
                                    } else {
                                        phi_3447_ = type_16(0i, 5i);
                                        phi_3450_ = bitcast<f64>(((bitcast<u64>(_e1793) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1800 = phi_3447_;
                                            let _e1802 = phi_3450_;
                                            local_9 = _e1802;
                                            if (_e1800.member < _e1800.member_1) {
                                                let _e1809 = (_e1800.member + 1i);
                                                phi_3448_ = type_16(select(_e1809, type_17().member_1, select(false, true, ((false == (_e1809 > _e1800.member)) != false))), _e1800.member_1);
                                                phi_3491_ = type_17(1u, _e1800.member);
                                            } else {
                                                phi_3448_ = _e1800;
                                                phi_3491_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e1820 = phi_3448_;
                                            let _e1822 = phi_3491_;
                                            let _e1825 = (bitcast<i32>(_e1822.member) != 0i);
                                            if _e1825 {
                                                phi_3451_ = (0.5lf * (_e1802 + (_e1793 / _e1802)));
                                            } else {
                                                phi_3451_ = f64();
                                            }
                                            let _e1830 = phi_3451_;
                                            continue;
                                            continuing {
                                                phi_3447_ = _e1820;
                                                phi_3450_ = _e1830;
                                                break if !(_e1825);
                                            }
                                        }
                                        let _e1835 = local_9;
                                        phi_3504_ = (_e1835 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1841 = phi_3504_;
                                    let _e1842 = (f64(1f) / _e1841);
                                    let _e1843 = (_e1785 * _e1842);
                                    let _e1844 = (_e1786 * _e1842);
                                    let _e1845 = (_e1787 * _e1842);
                                    let _e1854 = ((f64(3f) - (((_e1843 * _e1843) + (_e1844 * _e1844)) + (_e1845 * _e1845))) * f64(0.5f));
                                    phi_3523_ = array<f64, 3>((_e1843 * _e1854), (_e1844 * _e1854), (_e1845 * _e1854));
                                } else {
                                    phi_3523_ = array<f64, 3>(_e1594, _e1593, _e1593);
                                }
                                let _e1860 = phi_3523_;
                                phi_3524_ = _e1860;
                            }
                            let _e1950 = phi_3524_;
                            let _e1959 = ((((_e929 * _e1950[0]) + (_e930 * _e1950[1])) + (_e931 * _e1950[2])) > _e1097);
                            let _e1960 = -(_e934);
                            phi_3546_ = array<f64, 3>(select(_e1950[0], (_e1950[0] * _e1960), _e1959), select(_e1950[1], (_e1950[1] * _e1960), _e1959), select(_e1950[2], (_e1950[2] * _e1960), _e1959));
                            phi_3547_ = false;
                        } else {
                            phi_3546_ = array<f64, 3>();
                            phi_3547_ = true;
                        }
                        let _e1975 = phi_3546_;
                        let _e1977 = phi_3547_;
                        phi_3548_ = _e1975;
                        phi_3549_ = _e1580;
                        phi_3550_ = _e1977;
                    } else {
                        phi_3548_ = array<f64, 3>();
                        phi_3549_ = _e1226;
                        phi_3550_ = true;
                    }
                    let _e1979 = phi_3548_;
                    let _e1981 = phi_3549_;
                    let _e1983 = phi_3550_;
                    phi_3554_ = _e1981;
                    phi_3555_ = _e1979;
                    phi_3556_ = _e1983;
                }
                let _e2204 = phi_3554_;
                let _e2206 = phi_3555_;
                let _e2208 = phi_3556_;
                let _e2211 = select(_e2206[0], _e2204[0], _e2208);
                let _e2214 = select(_e2206[1], _e2204[1], _e2208);
                let _e2217 = select(_e2206[2], _e2204[2], _e2208);
                let _e2224 = ((((_e2211 * _e2211) + (_e2214 * _e2214)) + (_e2217 * _e2217)) > f64(0.5f));
                let _e2233 = function_10(_e351[0], _e352[0], _e346);
                let _e2236 = function_10(_e351[1], _e352[1], _e346);
                let _e2239 = function_10(_e351[2], _e352[2], _e346);
                let _e2242 = function_10(_e351[3], _e352[3], _e346);
                if (_e184.member != 0u) {
                    let _e2279 = function_10(_e2233, _e2236, _e839.member);
                    let _e2280 = function_10(_e2239, _e2242, _e839.member_1);
                    phi_3637_ = _e2280;
                    phi_3638_ = _e2279;
                    phi_3639_ = array<f64, 4>((_e345 - _e839.member), _e839.member, (_e345 - _e839.member_1), _e839.member_1);
                } else {
                    let _e2245 = ((_e345 - _e839.member) - _e839.member_1);
                    let _e2246 = f64(0f);
                    let _e2248 = select(_e2246, _e2245, (_e2245 > _e2246));
                    let _e2275 = function_1(array<f64, 4>(_e345, _e2248, _e839.member, _e839.member_1), _e350);
                    phi_3637_ = array<f64, 3>((((_e2236[0] * _e2248) + (_e2239[0] * _e839.member)) + (_e2242[0] * _e839.member_1)), (((_e2236[1] * _e2248) + (_e2239[1] * _e839.member)) + (_e2242[1] * _e839.member_1)), (((_e2236[2] * _e2248) + (_e2239[2] * _e839.member)) + (_e2242[2] * _e839.member_1)));
                    phi_3638_ = _e2233;
                    phi_3639_ = _e2275;
                }
                let _e2282 = phi_3637_;
                let _e2284 = phi_3638_;
                let _e2286 = phi_3639_;
                let _e2288 = function_10(_e2284, _e2282, f64(0.5f));
                let _e2290 = function_(_e2288);
                let _e2292 = function_(array<f64, 3>(select(_e345, _e2211, _e2224), select(f64(0f), _e2214, _e2224), select(f64(0f), _e2217, _e2224)));
                geometry.member[_e131] = type_27(_e2290, f32((_e898 / _e577)), _e2292, _e138, array<f32, 4>(f32(_e2286[0]), f32(_e2286[1]), f32(_e2286[2]), f32(_e2286[3])), _e184.member_1);
            }
        }
        continue;
        continuing {
            phi_251_ = type_9(select(_e106.member, (_e106.member + 1u), _e109), select(_e106.member_1, _e106.member_1, _e109));
            break if !(_e122);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn contact_geometry_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_14(id, n, lane);
}
