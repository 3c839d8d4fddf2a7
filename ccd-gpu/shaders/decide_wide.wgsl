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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

struct type_18 {
    member: i32,
    member_1: i32,
}

struct type_19 {
    member: u32,
    member_1: i32,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
    member_5: u32,
}

struct type_23 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_26 {
    member: array<type_24>,
}

struct type_30 {
    member: array<array<f64, 3>>,
}

struct type_31 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_33 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_35 {
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_36 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_37 {
    member: f64,
    member_1: f64,
}

struct type_40 {
    member: array<f64, 4>,
    member_1: f64,
    member_2: f64,
    member_3: f64,
}

struct type_43 {
    member: array<array<array<f64, 3>, 4>, 2>,
    member_1: f64,
    member_2: f64,
}

struct type_44 {
    member: type_33,
    member_1: f64,
}

struct type_45 {
    member: u32,
    member_1: f64,
}

struct type_46 {
    member: type_45,
    member_1: u32,
}

struct type_47 {
    member: f64,
    member_1: f64,
    member_2: u32,
}

struct type_48 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_49 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_53 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(4) 
var<storage> input: type_13;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> positions: type_30;
@group(0) @binding(1) 
var<storage> paths: type_26;
@group(0) @binding(3) 
var<storage> elements: type_13;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_53;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_53;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_256_: f64;
    var phi_234_: array<u32, 2>;
    var phi_257_: f64;
    var phi_299_: f64;
    var phi_277_: array<u32, 2>;
    var phi_300_: f64;
    var phi_342_: f64;
    var phi_320_: array<u32, 2>;
    var phi_343_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e21 = bitcast<u32>(param[0]);
        let _e22 = (_e21 & 2147483647u);
        if (_e22 < 8388608u) {
            phi_234_ = array<u32, 2>(0u, 0u);
        } else {
            phi_234_ = array<u32, 2>((_e21 << bitcast<u32>(29i)), ((_e21 ^ _e22) | ((_e22 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e33 = phi_234_;
        phi_257_ = bitcast<f64>(((u64(_e33[1]) * 4294967296lu) + u64(_e33[0])));
    } else {
        if (_e10 == _e11) {
            phi_256_ = (f64(_e11) * 1.401298464324817e-45lf);
        } else {
            phi_256_ = -((f64(_e11) * 1.401298464324817e-45lf));
        }
        let _e20 = phi_256_;
        phi_257_ = _e20;
    }
    let _e42 = phi_257_;
    let _e44 = bitcast<u32>(param[1]);
    let _e45 = (_e44 & 2147483647u);
    if (_e45 >= 8388608u) {
        let _e55 = bitcast<u32>(param[1]);
        let _e56 = (_e55 & 2147483647u);
        if (_e56 < 8388608u) {
            phi_277_ = array<u32, 2>(0u, 0u);
        } else {
            phi_277_ = array<u32, 2>((_e55 << bitcast<u32>(29i)), ((_e55 ^ _e56) | ((_e56 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e67 = phi_277_;
        phi_300_ = bitcast<f64>(((u64(_e67[1]) * 4294967296lu) + u64(_e67[0])));
    } else {
        if (_e44 == _e45) {
            phi_299_ = (f64(_e45) * 1.401298464324817e-45lf);
        } else {
            phi_299_ = -((f64(_e45) * 1.401298464324817e-45lf));
        }
        let _e54 = phi_299_;
        phi_300_ = _e54;
    }
    let _e76 = phi_300_;
    let _e78 = bitcast<u32>(param[2]);
    let _e79 = (_e78 & 2147483647u);
    if (_e79 >= 8388608u) {
        let _e89 = bitcast<u32>(param[2]);
        let _e90 = (_e89 & 2147483647u);
        if (_e90 < 8388608u) {
            phi_320_ = array<u32, 2>(0u, 0u);
        } else {
            phi_320_ = array<u32, 2>((_e89 << bitcast<u32>(29i)), ((_e89 ^ _e90) | ((_e90 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e101 = phi_320_;
        phi_343_ = bitcast<f64>(((u64(_e101[1]) * 4294967296lu) + u64(_e101[0])));
    } else {
        if (_e78 == _e79) {
            phi_342_ = (f64(_e79) * 1.401298464324817e-45lf);
        } else {
            phi_342_ = -((f64(_e79) * 1.401298464324817e-45lf));
        }
        let _e88 = phi_342_;
        phi_343_ = _e88;
    }
    let _e110 = phi_343_;
    return array<f64, 3>(_e42, _e76, _e110);
}

fn function_1(param_1: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_1);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_2(param_2: ptr<function, type_40>, param_3: f64, param_4: f64, param_5: f64) -> bool {
    var phi_16780_: f64;
    var phi_16812_: f64;
    var phi_16824_: f64;
    var phi_16834_: bool;
    var phi_16835_: bool;
    var phi_16836_: bool;
    var phi_16837_: bool;
    var phi_16841_: bool;
    var phi_16842_: bool;

    let _e15 = (*param_2).member_3;
    let _e17 = (*param_2).member_3;
    let _e19 = (param_3 + (_e15 + _e17));
    if (_e19 < param_5) {
        let _e22 = (f64(1f) - param_4);
        let _e25 = (*param_2).member[0u];
        let _e28 = (*param_2).member[1u];
        let _e31 = (*param_2).member[2u];
        let _e34 = (*param_2).member[3u];
        let _e45 = ((((_e25 * _e22) + (_e28 * param_4)) * (_e22 * _e22)) + (((_e31 * _e22) + (_e34 * param_4)) * (param_4 * param_4)));
        if (_e19 > param_4) {
            phi_16780_ = _e19;
        } else {
            phi_16780_ = param_4;
        }
        let _e48 = phi_16780_;
        let _e50 = (f64(1f) - _e48);
        let _e53 = (*param_2).member[0u];
        let _e56 = (*param_2).member[1u];
        let _e59 = (*param_2).member[2u];
        let _e62 = (*param_2).member[3u];
        let _e73 = ((((_e53 * _e50) + (_e56 * _e48)) * (_e50 * _e50)) + (((_e59 * _e50) + (_e62 * _e48)) * (_e48 * _e48)));
        let _e75 = (*param_2).member_1;
        let _e77 = (*param_2).member_1;
        if (_e45 < 0.0lf) {
            phi_16812_ = -(_e45);
        } else {
            phi_16812_ = _e45;
        }
        let _e82 = phi_16812_;
        let _e84 = (*param_2).member_1;
        if (_e82 > _e84) {
            if (_e73 < 0.0lf) {
                phi_16824_ = -(_e73);
            } else {
                phi_16824_ = _e73;
            }
            let _e89 = phi_16824_;
            if (_e89 > (_e75 + _e77)) {
                phi_16834_ = ((_e45 > f64(0f)) == (_e73 > f64(0f)));
                phi_16835_ = false;
            } else {
                phi_16834_ = bool();
                phi_16835_ = true;
            }
            let _e97 = phi_16834_;
            let _e99 = phi_16835_;
            phi_16836_ = _e97;
            phi_16837_ = _e99;
        } else {
            phi_16836_ = bool();
            phi_16837_ = true;
        }
        let _e101 = phi_16836_;
        let _e103 = phi_16837_;
        if _e103 {
            phi_16841_ = false;
        } else {
            phi_16841_ = _e101;
        }
        let _e105 = phi_16841_;
        phi_16842_ = _e105;
    } else {
        phi_16842_ = false;
    }
    let _e107 = phi_16842_;
    return _e107;
}

fn function_3(param_6: array<f64, 3>, param_7: array<f64, 3>) -> array<f64, 3> {
    var phi_16739_: array<f64, 3>;

    if ((((param_7[0] * param_7[0]) + (param_7[1] * param_7[1])) + (param_7[2] * param_7[2])) < (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2]))) {
        phi_16739_ = param_7;
    } else {
        phi_16739_ = param_6;
    }
    let _e26 = phi_16739_;
    return _e26;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_16591_: f64;
    var phi_16593_: f64;
    var phi_16635_: f64;
    var phi_16637_: f64;
    var phi_16685_: f64;
    var phi_16687_: f64;
    var phi_16396_: f64;
    var phi_16398_: f64;
    var phi_16446_: f64;
    var phi_16448_: f64;
    var phi_16493_: f64;
    var phi_16495_: f64;
    var phi_16546_: f64;
    var phi_16548_: f64;
    var phi_16702_: array<array<f64, 3>, 4>;

    let _e9 = (param_8[0] - param_9[0]);
    let _e12 = (param_8[1] - param_9[1]);
    let _e15 = (param_8[2] - param_9[2]);
    if (param_11 != 0u) {
        let _e169 = ((((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2])) / (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2])));
        if (_e169 > f64(0f)) {
            if (_e169 < f64(1f)) {
                phi_16396_ = _e169;
            } else {
                phi_16396_ = f64(1f);
            }
            let _e177 = phi_16396_;
            phi_16398_ = _e177;
        } else {
            phi_16398_ = f64(0f);
        }
        let _e179 = phi_16398_;
        let _e215 = ((((param_8[0] * param_10[0]) + (param_8[1] * param_10[1])) + (param_8[2] * param_10[2])) / (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2])));
        if (_e215 > f64(0f)) {
            if (_e215 < f64(1f)) {
                phi_16446_ = _e215;
            } else {
                phi_16446_ = f64(1f);
            }
            let _e223 = phi_16446_;
            phi_16448_ = _e223;
        } else {
            phi_16448_ = f64(0f);
        }
        let _e225 = phi_16448_;
        let _e258 = ((((_e9 * param_10[0]) + (_e12 * param_10[1])) + (_e15 * param_10[2])) / (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2])));
        if (_e258 > f64(0f)) {
            if (_e258 < f64(1f)) {
                phi_16493_ = _e258;
            } else {
                phi_16493_ = f64(1f);
            }
            let _e266 = phi_16493_;
            phi_16495_ = _e266;
        } else {
            phi_16495_ = f64(0f);
        }
        let _e268 = phi_16495_;
        let _e281 = (param_8[0] - param_10[0]);
        let _e284 = (param_8[1] - param_10[1]);
        let _e287 = (param_8[2] - param_10[2]);
        let _e307 = ((((_e281 * param_9[0]) + (_e284 * param_9[1])) + (_e287 * param_9[2])) / (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2])));
        if (_e307 > f64(0f)) {
            if (_e307 < f64(1f)) {
                phi_16546_ = _e307;
            } else {
                phi_16546_ = f64(1f);
            }
            let _e315 = phi_16546_;
            phi_16548_ = _e315;
        } else {
            phi_16548_ = f64(0f);
        }
        let _e317 = phi_16548_;
        phi_16702_ = array<array<f64, 3>, 4>(array<f64, 3>((param_8[0] - (param_9[0] * _e179)), (param_8[1] - (param_9[1] * _e179)), (param_8[2] - (param_9[2] * _e179))), array<f64, 3>((param_8[0] - (param_10[0] * _e225)), (param_8[1] - (param_10[1] * _e225)), (param_8[2] - (param_10[2] * _e225))), array<f64, 3>((_e9 - (param_10[0] * _e268)), (_e12 - (param_10[1] * _e268)), (_e15 - (param_10[2] * _e268))), array<f64, 3>((_e281 - (param_9[0] * _e317)), (_e284 - (param_9[1] * _e317)), (_e287 - (param_9[2] * _e317))));
    } else {
        let _e19 = (param_10[0] - param_9[0]);
        let _e22 = (param_10[1] - param_9[1]);
        let _e25 = (param_10[2] - param_9[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > f64(0f)) {
            if (_e36 < f64(1f)) {
                phi_16591_ = _e36;
            } else {
                phi_16591_ = f64(1f);
            }
            let _e44 = phi_16591_;
            phi_16593_ = _e44;
        } else {
            phi_16593_ = f64(0f);
        }
        let _e46 = phi_16593_;
        let _e53 = array<f64, 3>((_e9 - (_e19 * _e46)), (_e12 - (_e22 * _e46)), (_e15 - (_e25 * _e46)));
        let _e76 = ((((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2])) / (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2])));
        if (_e76 > f64(0f)) {
            if (_e76 < f64(1f)) {
                phi_16635_ = _e76;
            } else {
                phi_16635_ = f64(1f);
            }
            let _e84 = phi_16635_;
            phi_16637_ = _e84;
        } else {
            phi_16637_ = f64(0f);
        }
        let _e86 = phi_16637_;
        let _e122 = ((((param_8[0] * param_10[0]) + (param_8[1] * param_10[1])) + (param_8[2] * param_10[2])) / (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2])));
        if (_e122 > f64(0f)) {
            if (_e122 < f64(1f)) {
                phi_16685_ = _e122;
            } else {
                phi_16685_ = f64(1f);
            }
            let _e130 = phi_16685_;
            phi_16687_ = _e130;
        } else {
            phi_16687_ = f64(0f);
        }
        let _e132 = phi_16687_;
        phi_16702_ = array<array<f64, 3>, 4>(array<f64, 3>((param_8[0] - (param_9[0] * _e86)), (param_8[1] - (param_9[1] * _e86)), (param_8[2] - (param_9[2] * _e86))), array<f64, 3>((param_8[0] - (param_10[0] * _e132)), (param_8[1] - (param_10[1] * _e132)), (param_8[2] - (param_10[2] * _e132))), _e53, _e53);
    }
    let _e330 = phi_16702_;
    let _e333 = function_3(_e330[0], _e330[1]);
    let _e335 = function_3(_e333, _e330[2]);
    let _e337 = function_3(_e335, _e330[3]);
    return _e337;
}

fn function_5(param_12: array<f64, 3>, param_13: array<f64, 3>, param_14: array<f64, 3>, param_15: u32) -> array<f64, 3> {
    var phi_16293_: bool;
    var phi_16294_: bool;
    var phi_16295_: bool;
    var phi_16296_: bool;
    var phi_16300_: bool;
    var phi_16273_: bool;
    var phi_16274_: bool;
    var phi_16275_: bool;
    var phi_16276_: bool;
    var phi_16277_: bool;
    var phi_16278_: bool;
    var phi_16282_: bool;
    var phi_16301_: bool;
    var phi_16335_: array<f64, 3>;
    var phi_16336_: bool;
    var phi_16337_: array<f64, 3>;
    var phi_16338_: bool;
    var phi_16343_: array<f64, 3>;

    let _e23 = (((param_13[0] * param_13[0]) + (param_13[1] * param_13[1])) + (param_13[2] * param_13[2]));
    let _e34 = (((param_13[0] * param_14[0]) + (param_13[1] * param_14[1])) + (param_13[2] * param_14[2]));
    let _e45 = (((param_14[0] * param_14[0]) + (param_14[1] * param_14[1])) + (param_14[2] * param_14[2]));
    let _e56 = (((param_12[0] * param_13[0]) + (param_12[1] * param_13[1])) + (param_12[2] * param_13[2]));
    let _e67 = (((param_12[0] * param_14[0]) + (param_12[1] * param_14[1])) + (param_12[2] * param_14[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e71 = f64(0f);
    let _e72 = f64(1f);
    let _e76 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e80 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_15 != 0u) {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                if (_e76 <= _e72) {
                    phi_16273_ = (_e80 <= _e72);
                    phi_16274_ = false;
                } else {
                    phi_16273_ = bool();
                    phi_16274_ = true;
                }
                let _e101 = phi_16273_;
                let _e103 = phi_16274_;
                phi_16275_ = _e101;
                phi_16276_ = _e103;
            } else {
                phi_16275_ = bool();
                phi_16276_ = true;
            }
            let _e105 = phi_16275_;
            let _e107 = phi_16276_;
            phi_16277_ = _e105;
            phi_16278_ = _e107;
        } else {
            phi_16277_ = bool();
            phi_16278_ = true;
        }
        let _e109 = phi_16277_;
        let _e111 = phi_16278_;
        if _e111 {
            phi_16282_ = false;
        } else {
            phi_16282_ = _e109;
        }
        let _e113 = phi_16282_;
        phi_16301_ = _e113;
    } else {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                phi_16293_ = ((_e76 + _e80) <= _e72);
                phi_16294_ = false;
            } else {
                phi_16293_ = bool();
                phi_16294_ = true;
            }
            let _e87 = phi_16293_;
            let _e89 = phi_16294_;
            phi_16295_ = _e87;
            phi_16296_ = _e89;
        } else {
            phi_16295_ = bool();
            phi_16296_ = true;
        }
        let _e91 = phi_16295_;
        let _e93 = phi_16296_;
        if _e93 {
            phi_16300_ = false;
        } else {
            phi_16300_ = _e91;
        }
        let _e95 = phi_16300_;
        phi_16301_ = _e95;
    }
    let _e115 = phi_16301_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e115 {
            phi_16335_ = array<f64, 3>((param_12[0] - ((param_13[0] * _e76) + (param_14[0] * _e80))), (param_12[1] - ((param_13[1] * _e76) + (param_14[1] * _e80))), (param_12[2] - ((param_13[2] * _e76) + (param_14[2] * _e80))));
            phi_16336_ = false;
        } else {
            phi_16335_ = array<f64, 3>();
            phi_16336_ = true;
        }
        let _e144 = phi_16335_;
        let _e146 = phi_16336_;
        phi_16337_ = _e144;
        phi_16338_ = _e146;
    } else {
        phi_16337_ = array<f64, 3>();
        phi_16338_ = true;
    }
    let _e148 = phi_16337_;
    let _e150 = phi_16338_;
    if _e150 {
        let _e151 = function_4(param_12, param_13, param_14, param_15);
        phi_16343_ = _e151;
    } else {
        phi_16343_ = _e148;
    }
    let _e153 = phi_16343_;
    return _e153;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_35;
    var local_1: type_35;
    var local_2: type_36;
    var local_3: type_36;
    var local_4: type_36;
    var local_5: array<type_37, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: type_35;
    var local_9: type_35;
    var local_10: type_35;
    var local_11: type_35;
    var local_12: type_40;
    var local_13: array<f64, 4>;
    var local_14: array<f32, 3>;
    var local_15: type_43;
    var local_16: type_35;
    var local_17: type_35;
    var local_18: type_35;
    var local_19: type_33;
    var phi_405_: u32;
    var phi_415_: u32;
    var phi_422_: u32;
    var phi_438_: u32;
    var phi_459_: u32;
    var phi_460_: u32;
    var phi_463_: type_9;
    var phi_464_: type_9;
    var phi_487_: type_9;
    var phi_625_: type_23;
    var phi_821_: type_31;
    var phi_982_: type_33;
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
    var phi_1181_: f64;
    var phi_1188_: f64;
    var phi_1193_: f64;
    var phi_1200_: f64;
    var phi_1205_: f64;
    var phi_1213_: f64;
    var phi_1220_: f64;
    var phi_1225_: f64;
    var phi_1232_: f64;
    var phi_1237_: f64;
    var phi_1242_: f64;
    var phi_1249_: f64;
    var phi_1254_: f64;
    var phi_1263_: bool;
    var phi_1287_: u64;
    var phi_1299_: f64;
    var phi_1300_: f64;
    var phi_1359_: type_44;
    var phi_1360_: bool;
    var phi_1361_: type_44;
    var phi_1362_: bool;
    var phi_1363_: type_44;
    var phi_1364_: bool;
    var phi_1369_: type_44;
    var phi_8436_: f64;
    var phi_8443_: f64;
    var phi_8448_: f64;
    var phi_8455_: f64;
    var phi_8460_: f64;
    var phi_8473_: f64;
    var phi_8480_: f64;
    var phi_8485_: f64;
    var phi_8492_: f64;
    var phi_8497_: f64;
    var phi_8502_: f64;
    var phi_8519_: f64;
    var phi_8526_: f64;
    var phi_8531_: f64;
    var phi_8538_: f64;
    var phi_8543_: f64;
    var phi_8557_: f64;
    var phi_8564_: f64;
    var phi_8569_: f64;
    var phi_8576_: f64;
    var phi_8581_: f64;
    var phi_8586_: f64;
    var phi_8603_: f64;
    var phi_8610_: f64;
    var phi_8615_: f64;
    var phi_8622_: f64;
    var phi_8627_: f64;
    var phi_8641_: f64;
    var phi_8648_: f64;
    var phi_8653_: f64;
    var phi_8660_: f64;
    var phi_8665_: f64;
    var phi_8670_: f64;
    var phi_8707_: f64;
    var phi_8713_: f64;
    var phi_8720_: f64;
    var phi_8727_: f64;
    var phi_8733_: f64;
    var phi_8740_: f64;
    var phi_8746_: f64;
    var phi_8752_: f64;
    var phi_8758_: f64;
    var phi_8765_: f64;
    var phi_8772_: f64;
    var phi_8800_: f64;
    var phi_8805_: f64;
    var phi_8810_: f64;
    var phi_8815_: f64;
    var phi_8820_: f64;
    var phi_8825_: f64;
    var phi_8836_: f64;
    var phi_8850_: f64;
    var phi_8856_: f64;
    var phi_8861_: f64;
    var phi_8867_: f64;
    var phi_8873_: f64;
    var phi_8878_: f64;
    var phi_8883_: f64;
    var phi_8893_: bool;
    var phi_8900_: f64;
    var phi_8908_: f64;
    var phi_8916_: f64;
    var phi_8954_: f64;
    var phi_9018_: array<f64, 3>;
    var phi_9083_: array<f64, 3>;
    var phi_9105_: f64;
    var phi_9112_: f64;
    var phi_9117_: f64;
    var phi_9124_: f64;
    var phi_9129_: f64;
    var phi_9142_: f64;
    var phi_9149_: f64;
    var phi_9154_: f64;
    var phi_9161_: f64;
    var phi_9166_: f64;
    var phi_9171_: f64;
    var phi_9188_: f64;
    var phi_9195_: f64;
    var phi_9200_: f64;
    var phi_9207_: f64;
    var phi_9212_: f64;
    var phi_9226_: f64;
    var phi_9233_: f64;
    var phi_9238_: f64;
    var phi_9245_: f64;
    var phi_9250_: f64;
    var phi_9255_: f64;
    var phi_9272_: f64;
    var phi_9279_: f64;
    var phi_9284_: f64;
    var phi_9291_: f64;
    var phi_9296_: f64;
    var phi_9310_: f64;
    var phi_9317_: f64;
    var phi_9322_: f64;
    var phi_9329_: f64;
    var phi_9334_: f64;
    var phi_9339_: f64;
    var phi_9460_: f64;
    var phi_9467_: f64;
    var phi_9475_: f64;
    var phi_9521_: type_18;
    var phi_9524_: f64;
    var phi_9545_: bool;
    var phi_9551_: type_19;
    var phi_9522_: type_18;
    var phi_9565_: type_19;
    var phi_9525_: f64;
    var local_20: f64;
    var phi_9514_: f64;
    var phi_9578_: f64;
    var phi_9647_: f64;
    var phi_9653_: f64;
    var phi_9662_: f64;
    var phi_9668_: f64;
    var phi_9677_: f64;
    var phi_9683_: f64;
    var phi_9692_: f64;
    var phi_9698_: f64;
    var phi_9704_: type_35;
    var phi_9705_: bool;
    var phi_9706_: type_35;
    var phi_9707_: bool;
    var phi_9717_: type_35;
    var phi_9887_: bool;
    var phi_9888_: bool;
    var phi_9889_: bool;
    var phi_9890_: bool;
    var phi_9891_: bool;
    var phi_9892_: bool;
    var phi_9896_: bool;
    var phi_9924_: f64;
    var phi_9930_: f64;
    var phi_9937_: f64;
    var phi_9980_: type_18;
    var phi_9983_: f64;
    var phi_10004_: bool;
    var phi_10010_: type_19;
    var phi_9981_: type_18;
    var phi_10024_: type_19;
    var phi_9984_: f64;
    var local_21: f64;
    var phi_9973_: f64;
    var phi_10037_: f64;
    var phi_10106_: f64;
    var phi_10112_: f64;
    var phi_10121_: f64;
    var phi_10127_: f64;
    var phi_10136_: f64;
    var phi_10142_: f64;
    var phi_10151_: f64;
    var phi_10157_: f64;
    var phi_10163_: type_35;
    var phi_10164_: bool;
    var phi_10165_: type_35;
    var phi_10166_: bool;
    var phi_10176_: type_35;
    var phi_10346_: bool;
    var phi_10347_: bool;
    var phi_10348_: bool;
    var phi_10349_: bool;
    var phi_10350_: bool;
    var phi_10351_: bool;
    var phi_10355_: bool;
    var phi_10383_: f64;
    var phi_10389_: f64;
    var phi_10396_: f64;
    var phi_10439_: type_18;
    var phi_10442_: f64;
    var phi_10463_: bool;
    var phi_10469_: type_19;
    var phi_10440_: type_18;
    var phi_10483_: type_19;
    var phi_10443_: f64;
    var local_22: f64;
    var phi_10432_: f64;
    var phi_10496_: f64;
    var phi_10565_: f64;
    var phi_10571_: f64;
    var phi_10580_: f64;
    var phi_10586_: f64;
    var phi_10595_: f64;
    var phi_10601_: f64;
    var phi_10610_: f64;
    var phi_10616_: f64;
    var phi_10622_: type_35;
    var phi_10623_: bool;
    var phi_10624_: type_35;
    var phi_10625_: bool;
    var phi_10635_: type_35;
    var phi_10805_: bool;
    var phi_10806_: bool;
    var phi_10807_: bool;
    var phi_10808_: bool;
    var phi_10809_: bool;
    var phi_10810_: bool;
    var phi_10814_: bool;
    var phi_10842_: f64;
    var phi_10848_: f64;
    var phi_10855_: f64;
    var phi_10898_: type_18;
    var phi_10901_: f64;
    var phi_10922_: bool;
    var phi_10928_: type_19;
    var phi_10899_: type_18;
    var phi_10942_: type_19;
    var phi_10902_: f64;
    var local_23: f64;
    var phi_10891_: f64;
    var phi_10955_: f64;
    var phi_11024_: f64;
    var phi_11030_: f64;
    var phi_11039_: f64;
    var phi_11045_: f64;
    var phi_11054_: f64;
    var phi_11060_: f64;
    var phi_11069_: f64;
    var phi_11075_: f64;
    var phi_11081_: type_35;
    var phi_11082_: bool;
    var phi_11083_: type_35;
    var phi_11084_: bool;
    var phi_11094_: type_35;
    var phi_11264_: bool;
    var phi_11265_: bool;
    var phi_11266_: bool;
    var phi_11267_: bool;
    var phi_11268_: bool;
    var phi_11269_: bool;
    var phi_11273_: bool;
    var phi_11274_: bool;
    var phi_11275_: bool;
    var phi_11276_: bool;
    var phi_11277_: bool;
    var phi_11278_: bool;
    var phi_11282_: bool;
    var phi_11288_: type_45;
    var phi_11289_: bool;
    var phi_11290_: type_45;
    var phi_11291_: bool;
    var phi_11351_: type_18;
    var phi_11354_: f64;
    var phi_11375_: bool;
    var phi_11381_: type_19;
    var phi_11352_: type_18;
    var phi_11395_: type_19;
    var phi_11355_: f64;
    var local_24: f64;
    var phi_11344_: f64;
    var phi_11408_: f64;
    var phi_11414_: f64;
    var phi_11439_: type_9;
    var phi_11442_: u32;
    var phi_11440_: type_9;
    var phi_11465_: type_9;
    var phi_11509_: u32;
    var phi_11510_: u32;
    var phi_11443_: u32;
    var phi_11511_: u32;
    var phi_11531_: type_9;
    var phi_11532_: type_9;
    var phi_11555_: type_9;
    var phi_11574_: f64;
    var phi_11587_: f64;
    var phi_11643_: f64;
    var phi_11652_: f64;
    var phi_11666_: bool;
    var phi_11667_: bool;
    var phi_11668_: bool;
    var phi_11669_: bool;
    var phi_11673_: bool;
    var phi_11685_: type_48;
    var phi_11686_: type_48;
    var phi_11687_: bool;
    var phi_11688_: type_48;
    var phi_11689_: bool;
    var phi_11702_: f64;
    var phi_11724_: type_9;
    var phi_11727_: f64;
    var phi_11729_: f64;
    var phi_11731_: f64;
    var phi_11725_: type_9;
    var phi_11754_: type_9;
    var phi_11791_: f64;
    var phi_11792_: f64;
    var phi_11820_: f64;
    var phi_11836_: f64;
    var phi_11843_: bool;
    var phi_11844_: bool;
    var phi_11845_: bool;
    var phi_11851_: f64;
    var phi_11852_: f64;
    var phi_11853_: bool;
    var phi_11728_: f64;
    var phi_11730_: f64;
    var phi_11732_: f64;
    var phi_11854_: f64;
    var phi_11855_: bool;
    var phi_11856_: bool;
    var local_25: bool;
    var phi_11860_: f64;
    var phi_11861_: f64;
    var phi_11871_: f64;
    var phi_11879_: type_9;
    var phi_11882_: f64;
    var phi_11880_: type_9;
    var phi_11905_: type_9;
    var phi_11946_: f64;
    var phi_11947_: bool;
    var phi_11948_: f64;
    var phi_11949_: bool;
    var phi_11950_: bool;
    var phi_11951_: bool;
    var phi_11952_: f64;
    var phi_11883_: f64;
    var phi_11953_: bool;
    var phi_11954_: bool;
    var phi_11955_: bool;
    var phi_11956_: bool;
    var local_26: bool;
    var phi_11960_: bool;
    var phi_11961_: bool;
    var phi_11965_: bool;
    var phi_11969_: f64;
    var phi_11970_: f64;
    var phi_11972_: type_48;
    var phi_12008_: f64;
    var phi_12015_: f64;
    var phi_12020_: f64;
    var phi_12027_: f64;
    var phi_12032_: f64;
    var phi_12045_: f64;
    var phi_12052_: f64;
    var phi_12057_: f64;
    var phi_12064_: f64;
    var phi_12069_: f64;
    var phi_12074_: f64;
    var phi_12133_: f64;
    var phi_12139_: f64;
    var phi_12144_: f64;
    var phi_12150_: f64;
    var phi_12155_: f64;
    var phi_12169_: f64;
    var phi_12175_: f64;
    var phi_12180_: f64;
    var phi_12186_: f64;
    var phi_12191_: f64;
    var phi_12217_: f64;
    var phi_12224_: f64;
    var phi_12229_: f64;
    var phi_12236_: f64;
    var phi_12241_: f64;
    var phi_12254_: f64;
    var phi_12261_: f64;
    var phi_12266_: f64;
    var phi_12273_: f64;
    var phi_12278_: f64;
    var phi_12283_: f64;
    var phi_12342_: f64;
    var phi_12348_: f64;
    var phi_12353_: f64;
    var phi_12359_: f64;
    var phi_12364_: f64;
    var phi_12378_: f64;
    var phi_12384_: f64;
    var phi_12389_: f64;
    var phi_12395_: f64;
    var phi_12400_: f64;
    var phi_12426_: f64;
    var phi_12433_: f64;
    var phi_12438_: f64;
    var phi_12445_: f64;
    var phi_12450_: f64;
    var phi_12463_: f64;
    var phi_12470_: f64;
    var phi_12475_: f64;
    var phi_12482_: f64;
    var phi_12487_: f64;
    var phi_12492_: f64;
    var phi_12551_: f64;
    var phi_12557_: f64;
    var phi_12562_: f64;
    var phi_12568_: f64;
    var phi_12573_: f64;
    var phi_12587_: f64;
    var phi_12593_: f64;
    var phi_12598_: f64;
    var phi_12604_: f64;
    var phi_12609_: f64;
    var phi_12658_: f64;
    var phi_12664_: f64;
    var phi_12692_: f64;
    var phi_12698_: f64;
    var phi_12703_: u32;
    var phi_12704_: u32;
    var phi_12674_: f64;
    var phi_12680_: f64;
    var phi_12685_: u32;
    var phi_12686_: u32;
    var phi_12705_: u32;
    var phi_12706_: u32;
    var phi_12779_: f64;
    var phi_12791_: f64;
    var phi_12934_: f64;
    var phi_12940_: f64;
    var phi_12947_: f64;
    var phi_12983_: array<type_37, 4>;
    var phi_13003_: type_9;
    var phi_13006_: bool;
    var phi_13004_: type_9;
    var phi_13029_: type_9;
    var phi_13056_: bool;
    var phi_13057_: bool;
    var phi_13007_: bool;
    var phi_13058_: bool;
    var phi_13059_: bool;
    var local_27: bool;
    var phi_13063_: bool;
    var local_28: bool;
    var phi_13070_: u32;
    var phi_13071_: u32;
    var phi_13072_: bool;
    var phi_13073_: u32;
    var phi_13074_: u32;
    var phi_13075_: bool;
    var phi_13079_: u32;
    var phi_13089_: bool;
    var phi_13102_: bool;
    var phi_13103_: bool;
    var phi_13164_: array<f64, 3>;
    var phi_13229_: array<f64, 3>;
    var phi_13251_: f64;
    var phi_13258_: f64;
    var phi_13263_: f64;
    var phi_13270_: f64;
    var phi_13275_: f64;
    var phi_13288_: f64;
    var phi_13295_: f64;
    var phi_13300_: f64;
    var phi_13307_: f64;
    var phi_13312_: f64;
    var phi_13317_: f64;
    var phi_13334_: f64;
    var phi_13341_: f64;
    var phi_13346_: f64;
    var phi_13353_: f64;
    var phi_13358_: f64;
    var phi_13372_: f64;
    var phi_13379_: f64;
    var phi_13384_: f64;
    var phi_13391_: f64;
    var phi_13396_: f64;
    var phi_13401_: f64;
    var phi_13418_: f64;
    var phi_13425_: f64;
    var phi_13430_: f64;
    var phi_13437_: f64;
    var phi_13442_: f64;
    var phi_13456_: f64;
    var phi_13463_: f64;
    var phi_13468_: f64;
    var phi_13475_: f64;
    var phi_13480_: f64;
    var phi_13485_: f64;
    var phi_13532_: type_9;
    var phi_13535_: f64;
    var phi_13537_: f64;
    var phi_13539_: f64;
    var phi_13541_: f64;
    var phi_13543_: bool;
    var phi_13545_: u32;
    var phi_13533_: type_9;
    var phi_13568_: type_9;
    var phi_13683_: f64;
    var phi_13689_: f64;
    var phi_13695_: f64;
    var phi_13697_: array<f64, 3>;
    var phi_13704_: f64;
    var phi_13711_: f64;
    var phi_13719_: f64;
    var phi_13765_: type_18;
    var phi_13768_: f64;
    var phi_13789_: bool;
    var phi_13795_: type_19;
    var phi_13766_: type_18;
    var phi_13809_: type_19;
    var phi_13769_: f64;
    var local_29: f64;
    var phi_13758_: f64;
    var phi_13822_: f64;
    var phi_13891_: f64;
    var phi_13897_: f64;
    var phi_13906_: f64;
    var phi_13912_: f64;
    var phi_13921_: f64;
    var phi_13927_: f64;
    var phi_13936_: f64;
    var phi_13942_: f64;
    var phi_13948_: type_35;
    var phi_13949_: bool;
    var phi_13950_: type_35;
    var phi_13951_: bool;
    var phi_13961_: type_35;
    var phi_14133_: bool;
    var phi_14134_: bool;
    var phi_14135_: bool;
    var phi_14136_: bool;
    var phi_14137_: bool;
    var phi_14138_: bool;
    var phi_14142_: bool;
    var phi_14440_: bool;
    var phi_14441_: bool;
    var phi_14442_: bool;
    var phi_14443_: bool;
    var phi_14444_: bool;
    var phi_14445_: bool;
    var phi_14449_: bool;
    var phi_14453_: bool;
    var phi_14464_: bool;
    var phi_14465_: bool;
    var phi_14539_: bool;
    var phi_14540_: bool;
    var phi_14563_: f64;
    var phi_14564_: bool;
    var phi_14565_: f64;
    var phi_14566_: bool;
    var phi_14567_: f64;
    var phi_14568_: bool;
    var phi_14569_: bool;
    var phi_14574_: f64;
    var phi_14575_: bool;
    var phi_14579_: f64;
    var phi_14611_: bool;
    var phi_14612_: bool;
    var phi_14635_: f64;
    var phi_14636_: bool;
    var phi_14637_: f64;
    var phi_14638_: bool;
    var phi_14639_: f64;
    var phi_14640_: bool;
    var phi_14641_: bool;
    var phi_14646_: f64;
    var phi_14647_: bool;
    var phi_14651_: f64;
    var phi_14656_: f64;
    var phi_14688_: bool;
    var phi_14689_: bool;
    var phi_14712_: f64;
    var phi_14713_: bool;
    var phi_14714_: f64;
    var phi_14715_: bool;
    var phi_14716_: f64;
    var phi_14717_: bool;
    var phi_14718_: bool;
    var phi_14723_: f64;
    var phi_14724_: bool;
    var phi_14728_: f64;
    var phi_14760_: bool;
    var phi_14761_: bool;
    var phi_14784_: f64;
    var phi_14785_: bool;
    var phi_14786_: f64;
    var phi_14787_: bool;
    var phi_14788_: f64;
    var phi_14789_: bool;
    var phi_14790_: bool;
    var phi_14795_: f64;
    var phi_14796_: bool;
    var phi_14800_: f64;
    var phi_14805_: f64;
    var phi_14810_: f64;
    var phi_14815_: f64;
    var phi_14829_: f64;
    var phi_14967_: type_18;
    var phi_14970_: f64;
    var phi_14991_: bool;
    var phi_14997_: type_19;
    var phi_14968_: type_18;
    var phi_15011_: type_19;
    var phi_14971_: f64;
    var local_30: f64;
    var phi_14960_: f64;
    var phi_15024_: f64;
    var phi_15042_: f64;
    var phi_15049_: f64;
    var phi_15054_: f64;
    var phi_15061_: f64;
    var phi_15066_: f64;
    var phi_15079_: f64;
    var phi_15086_: f64;
    var phi_15091_: f64;
    var phi_15098_: f64;
    var phi_15103_: f64;
    var phi_15108_: f64;
    var phi_15125_: f64;
    var phi_15132_: f64;
    var phi_15137_: f64;
    var phi_15144_: f64;
    var phi_15149_: f64;
    var phi_15163_: f64;
    var phi_15170_: f64;
    var phi_15175_: f64;
    var phi_15182_: f64;
    var phi_15187_: f64;
    var phi_15192_: f64;
    var phi_15209_: f64;
    var phi_15216_: f64;
    var phi_15221_: f64;
    var phi_15228_: f64;
    var phi_15233_: f64;
    var phi_15247_: f64;
    var phi_15254_: f64;
    var phi_15259_: f64;
    var phi_15266_: f64;
    var phi_15271_: f64;
    var phi_15276_: f64;
    var phi_15300_: bool;
    var phi_15301_: bool;
    var phi_15302_: bool;
    var phi_15319_: f64;
    var phi_15320_: bool;
    var phi_15321_: f64;
    var phi_15322_: bool;
    var phi_15327_: f64;
    var phi_15329_: f64;
    var phi_15330_: f64;
    var phi_15331_: bool;
    var phi_15332_: f64;
    var phi_15333_: f64;
    var phi_15334_: bool;
    var phi_15335_: bool;
    var phi_15336_: f64;
    var phi_15337_: f64;
    var phi_15338_: f64;
    var phi_15339_: f64;
    var phi_15340_: bool;
    var phi_15341_: bool;
    var phi_15342_: bool;
    var phi_15343_: bool;
    var phi_15344_: f64;
    var phi_15345_: f64;
    var phi_15346_: f64;
    var phi_15347_: f64;
    var phi_15348_: bool;
    var phi_15349_: bool;
    var phi_15350_: bool;
    var phi_15351_: bool;
    var phi_15352_: bool;
    var phi_15353_: f64;
    var phi_15354_: f64;
    var phi_15355_: f64;
    var phi_15356_: f64;
    var phi_15357_: bool;
    var phi_15358_: bool;
    var phi_15359_: bool;
    var phi_15360_: bool;
    var phi_15361_: bool;
    var phi_15447_: f64;
    var phi_15520_: f64;
    var phi_15525_: f64;
    var phi_15598_: f64;
    var phi_15671_: f64;
    var phi_15676_: f64;
    var phi_15697_: f64;
    var phi_15698_: f64;
    var phi_15699_: f64;
    var phi_15374_: bool;
    var phi_15701_: u32;
    var phi_15702_: f64;
    var phi_15703_: bool;
    var phi_15704_: bool;
    var phi_15705_: bool;
    var phi_15706_: u32;
    var phi_15707_: f64;
    var phi_15708_: f64;
    var phi_15709_: f64;
    var phi_15710_: f64;
    var phi_15711_: bool;
    var phi_15712_: u32;
    var phi_15713_: bool;
    var phi_15714_: bool;
    var phi_15715_: bool;
    var phi_15716_: bool;
    var phi_15717_: bool;
    var phi_15718_: bool;
    var phi_15727_: f64;
    var phi_15732_: f64;
    var phi_15741_: bool;
    var phi_15745_: bool;
    var phi_15746_: f64;
    var phi_15747_: f64;
    var phi_15748_: f64;
    var phi_15749_: f64;
    var phi_15750_: bool;
    var phi_15751_: u32;
    var phi_15752_: bool;
    var phi_15753_: bool;
    var phi_15754_: bool;
    var phi_15755_: bool;
    var phi_15756_: bool;
    var phi_15757_: bool;
    var phi_13536_: f64;
    var phi_13538_: f64;
    var phi_13540_: f64;
    var phi_13542_: f64;
    var phi_13544_: bool;
    var phi_13546_: u32;
    var phi_15758_: f64;
    var phi_15759_: f64;
    var phi_15760_: bool;
    var phi_15761_: bool;
    var phi_15762_: bool;
    var phi_15763_: bool;
    var phi_15764_: bool;
    var phi_15765_: bool;
    var phi_15766_: bool;
    var local_31: bool;
    var phi_15770_: bool;
    var phi_15771_: bool;
    var phi_15772_: bool;
    var phi_15773_: bool;
    var phi_15774_: bool;
    var local_32: f64;
    var phi_15779_: type_45;
    var phi_15780_: bool;
    var phi_15781_: bool;
    var phi_15782_: bool;
    var phi_15783_: bool;
    var phi_15784_: bool;
    var phi_15789_: type_45;
    var phi_15790_: bool;
    var phi_15791_: bool;
    var phi_15792_: bool;
    var phi_15793_: bool;
    var phi_15794_: bool;
    var phi_15798_: f64;
    var phi_15799_: bool;
    var phi_15800_: bool;
    var phi_15801_: bool;
    var phi_15802_: bool;
    var phi_15806_: f64;
    var phi_15807_: bool;
    var phi_15808_: bool;
    var phi_15809_: bool;
    var phi_15814_: type_45;
    var phi_15815_: bool;
    var phi_15816_: bool;
    var phi_15821_: type_45;
    var phi_15822_: bool;
    var phi_15826_: type_45;
    var phi_15833_: bool;
    var phi_15834_: f64;
    var phi_15835_: bool;
    var phi_15836_: bool;
    var phi_15837_: bool;
    var phi_15838_: bool;
    var phi_15839_: f64;
    var phi_15840_: f64;
    var phi_15841_: bool;
    var phi_15842_: bool;
    var phi_15843_: bool;
    var phi_15844_: bool;
    var phi_15845_: f64;
    var phi_15846_: f64;
    var phi_15847_: bool;
    var phi_15848_: bool;
    var phi_15849_: bool;
    var phi_15850_: bool;
    var phi_15851_: bool;
    var phi_15852_: f64;
    var phi_15853_: f64;
    var phi_15854_: bool;
    var phi_15855_: bool;
    var phi_15856_: bool;
    var phi_15857_: bool;
    var phi_15858_: bool;
    var phi_15862_: bool;
    var phi_15863_: bool;
    var phi_15864_: bool;
    var phi_15865_: bool;
    var phi_15866_: type_48;
    var phi_15867_: bool;
    var phi_15868_: f64;
    var phi_15869_: f64;
    var phi_15870_: type_48;
    var phi_15871_: bool;
    var phi_15872_: bool;
    var phi_15873_: bool;
    var phi_15874_: bool;
    var phi_15875_: bool;
    var phi_15876_: type_48;
    var phi_15877_: bool;
    var phi_15878_: f64;
    var phi_15879_: f64;
    var phi_15880_: type_48;
    var phi_15881_: bool;
    var phi_15882_: bool;
    var phi_15883_: bool;
    var phi_15884_: bool;
    var phi_15885_: bool;
    var phi_15886_: bool;
    var phi_15890_: bool;
    var phi_15891_: bool;
    var phi_15892_: bool;
    var phi_15893_: bool;
    var phi_15894_: bool;
    var phi_15895_: type_48;
    var phi_15896_: bool;
    var phi_15897_: f64;
    var phi_15898_: f64;
    var phi_15899_: type_48;
    var phi_15900_: bool;
    var phi_15901_: bool;
    var phi_15902_: bool;
    var phi_15903_: bool;
    var phi_15904_: bool;
    var phi_15905_: bool;
    var local_33: bool;
    var phi_15910_: type_45;
    var phi_15911_: bool;
    var phi_15912_: bool;
    var phi_15913_: bool;
    var phi_15914_: bool;
    var phi_15919_: type_45;
    var phi_15920_: bool;
    var phi_15921_: bool;
    var phi_15922_: bool;
    var phi_15927_: type_45;
    var phi_15928_: bool;
    var phi_15929_: bool;
    var phi_15930_: bool;
    var local_34: bool;
    var local_35: type_48;
    var local_36: f64;
    var local_37: f64;
    var local_38: f64;
    var phi_15944_: type_45;
    var phi_15945_: bool;
    var phi_15946_: type_45;
    var phi_15947_: bool;
    var local_39: f64;
    var phi_15952_: type_45;
    var phi_15953_: type_45;
    var phi_15954_: bool;
    var phi_15955_: bool;
    var phi_15956_: bool;
    var local_40: type_48;
    var phi_15962_: type_45;
    var phi_15963_: bool;
    var phi_15964_: bool;
    var phi_15965_: bool;
    var phi_15969_: type_45;
    var phi_15970_: bool;
    var phi_15971_: bool;
    var phi_15975_: type_45;
    var phi_15976_: bool;
    var phi_15980_: type_45;
    var phi_15981_: type_45;
    var phi_15982_: bool;
    var phi_15986_: type_45;
    var phi_15987_: type_45;
    var phi_15988_: bool;
    var phi_15992_: type_45;
    var phi_16003_: bool;
    var phi_16004_: bool;
    var phi_16008_: bool;
    var phi_16012_: u32;
    var phi_1544_: type_18;
    var phi_1547_: f64;
    var phi_1568_: bool;
    var phi_1574_: type_19;
    var phi_1545_: type_18;
    var phi_1588_: type_19;
    var phi_1548_: f64;
    var local_41: f64;
    var phi_1537_: f64;
    var phi_1601_: f64;
    var phi_1619_: f64;
    var phi_1626_: f64;
    var phi_1631_: f64;
    var phi_1638_: f64;
    var phi_1643_: f64;
    var phi_1656_: f64;
    var phi_1663_: f64;
    var phi_1668_: f64;
    var phi_1675_: f64;
    var phi_1680_: f64;
    var phi_1685_: f64;
    var phi_1702_: f64;
    var phi_1709_: f64;
    var phi_1714_: f64;
    var phi_1721_: f64;
    var phi_1726_: f64;
    var phi_1740_: f64;
    var phi_1747_: f64;
    var phi_1752_: f64;
    var phi_1759_: f64;
    var phi_1764_: f64;
    var phi_1769_: f64;
    var phi_1786_: f64;
    var phi_1793_: f64;
    var phi_1798_: f64;
    var phi_1805_: f64;
    var phi_1810_: f64;
    var phi_1824_: f64;
    var phi_1831_: f64;
    var phi_1836_: f64;
    var phi_1843_: f64;
    var phi_1848_: f64;
    var phi_1853_: f64;
    var phi_2118_: f64;
    var phi_2125_: f64;
    var phi_2130_: f64;
    var phi_2137_: f64;
    var phi_2142_: f64;
    var phi_2155_: f64;
    var phi_2162_: f64;
    var phi_2167_: f64;
    var phi_2174_: f64;
    var phi_2179_: f64;
    var phi_2184_: f64;
    var phi_2201_: f64;
    var phi_2208_: f64;
    var phi_2213_: f64;
    var phi_2220_: f64;
    var phi_2225_: f64;
    var phi_2239_: f64;
    var phi_2246_: f64;
    var phi_2251_: f64;
    var phi_2258_: f64;
    var phi_2263_: f64;
    var phi_2268_: f64;
    var phi_2285_: f64;
    var phi_2292_: f64;
    var phi_2297_: f64;
    var phi_2304_: f64;
    var phi_2309_: f64;
    var phi_2323_: f64;
    var phi_2330_: f64;
    var phi_2335_: f64;
    var phi_2342_: f64;
    var phi_2347_: f64;
    var phi_2352_: f64;
    var phi_2389_: f64;
    var phi_2395_: f64;
    var phi_2402_: f64;
    var phi_2409_: f64;
    var phi_2415_: f64;
    var phi_2422_: f64;
    var phi_2428_: f64;
    var phi_2434_: f64;
    var phi_2440_: f64;
    var phi_2447_: f64;
    var phi_2454_: f64;
    var phi_2482_: f64;
    var phi_2487_: f64;
    var phi_2492_: f64;
    var phi_2497_: f64;
    var phi_2502_: f64;
    var phi_2507_: f64;
    var phi_2518_: f64;
    var phi_2528_: type_46;
    var phi_2529_: bool;
    var phi_2530_: type_46;
    var phi_2531_: bool;
    var phi_2537_: type_18;
    var phi_2540_: f64;
    var phi_2542_: u32;
    var phi_2544_: f64;
    var phi_2565_: bool;
    var phi_2571_: type_19;
    var phi_2538_: type_18;
    var phi_2585_: type_19;
    var phi_2600_: bool;
    var phi_2601_: bool;
    var phi_2660_: array<f64, 3>;
    var phi_2725_: array<f64, 3>;
    var phi_2747_: f64;
    var phi_2754_: f64;
    var phi_2759_: f64;
    var phi_2766_: f64;
    var phi_2771_: f64;
    var phi_2784_: f64;
    var phi_2791_: f64;
    var phi_2796_: f64;
    var phi_2803_: f64;
    var phi_2808_: f64;
    var phi_2813_: f64;
    var phi_2830_: f64;
    var phi_2837_: f64;
    var phi_2842_: f64;
    var phi_2849_: f64;
    var phi_2854_: f64;
    var phi_2868_: f64;
    var phi_2875_: f64;
    var phi_2880_: f64;
    var phi_2887_: f64;
    var phi_2892_: f64;
    var phi_2897_: f64;
    var phi_2914_: f64;
    var phi_2921_: f64;
    var phi_2926_: f64;
    var phi_2933_: f64;
    var phi_2938_: f64;
    var phi_2952_: f64;
    var phi_2959_: f64;
    var phi_2964_: f64;
    var phi_2971_: f64;
    var phi_2976_: f64;
    var phi_2981_: f64;
    var phi_3028_: type_9;
    var phi_3031_: f64;
    var phi_3033_: f64;
    var phi_3035_: f64;
    var phi_3037_: f64;
    var phi_3039_: bool;
    var phi_3041_: u32;
    var phi_3029_: type_9;
    var phi_3064_: type_9;
    var phi_3179_: f64;
    var phi_3185_: f64;
    var phi_3191_: f64;
    var phi_3193_: array<f64, 3>;
    var phi_3200_: f64;
    var phi_3207_: f64;
    var phi_3215_: f64;
    var phi_3261_: type_18;
    var phi_3264_: f64;
    var phi_3285_: bool;
    var phi_3291_: type_19;
    var phi_3262_: type_18;
    var phi_3305_: type_19;
    var phi_3265_: f64;
    var local_42: f64;
    var phi_3254_: f64;
    var phi_3318_: f64;
    var phi_3387_: f64;
    var phi_3393_: f64;
    var phi_3402_: f64;
    var phi_3408_: f64;
    var phi_3417_: f64;
    var phi_3423_: f64;
    var phi_3432_: f64;
    var phi_3438_: f64;
    var phi_3444_: type_35;
    var phi_3445_: bool;
    var phi_3446_: type_35;
    var phi_3447_: bool;
    var phi_3457_: type_35;
    var phi_3629_: bool;
    var phi_3630_: bool;
    var phi_3631_: bool;
    var phi_3632_: bool;
    var phi_3633_: bool;
    var phi_3634_: bool;
    var phi_3638_: bool;
    var phi_3936_: bool;
    var phi_3937_: bool;
    var phi_3938_: bool;
    var phi_3939_: bool;
    var phi_3940_: bool;
    var phi_3941_: bool;
    var phi_3945_: bool;
    var phi_3949_: bool;
    var phi_3960_: bool;
    var phi_3961_: bool;
    var phi_4035_: bool;
    var phi_4036_: bool;
    var phi_4059_: f64;
    var phi_4060_: bool;
    var phi_4061_: f64;
    var phi_4062_: bool;
    var phi_4063_: f64;
    var phi_4064_: bool;
    var phi_4065_: bool;
    var phi_4070_: f64;
    var phi_4071_: bool;
    var phi_4075_: f64;
    var phi_4107_: bool;
    var phi_4108_: bool;
    var phi_4131_: f64;
    var phi_4132_: bool;
    var phi_4133_: f64;
    var phi_4134_: bool;
    var phi_4135_: f64;
    var phi_4136_: bool;
    var phi_4137_: bool;
    var phi_4142_: f64;
    var phi_4143_: bool;
    var phi_4147_: f64;
    var phi_4152_: f64;
    var phi_4184_: bool;
    var phi_4185_: bool;
    var phi_4208_: f64;
    var phi_4209_: bool;
    var phi_4210_: f64;
    var phi_4211_: bool;
    var phi_4212_: f64;
    var phi_4213_: bool;
    var phi_4214_: bool;
    var phi_4219_: f64;
    var phi_4220_: bool;
    var phi_4224_: f64;
    var phi_4256_: bool;
    var phi_4257_: bool;
    var phi_4280_: f64;
    var phi_4281_: bool;
    var phi_4282_: f64;
    var phi_4283_: bool;
    var phi_4284_: f64;
    var phi_4285_: bool;
    var phi_4286_: bool;
    var phi_4291_: f64;
    var phi_4292_: bool;
    var phi_4296_: f64;
    var phi_4301_: f64;
    var phi_4306_: f64;
    var phi_4311_: f64;
    var phi_4325_: f64;
    var phi_4463_: type_18;
    var phi_4466_: f64;
    var phi_4487_: bool;
    var phi_4493_: type_19;
    var phi_4464_: type_18;
    var phi_4507_: type_19;
    var phi_4467_: f64;
    var local_43: f64;
    var phi_4456_: f64;
    var phi_4520_: f64;
    var phi_4538_: f64;
    var phi_4545_: f64;
    var phi_4550_: f64;
    var phi_4557_: f64;
    var phi_4562_: f64;
    var phi_4575_: f64;
    var phi_4582_: f64;
    var phi_4587_: f64;
    var phi_4594_: f64;
    var phi_4599_: f64;
    var phi_4604_: f64;
    var phi_4621_: f64;
    var phi_4628_: f64;
    var phi_4633_: f64;
    var phi_4640_: f64;
    var phi_4645_: f64;
    var phi_4659_: f64;
    var phi_4666_: f64;
    var phi_4671_: f64;
    var phi_4678_: f64;
    var phi_4683_: f64;
    var phi_4688_: f64;
    var phi_4705_: f64;
    var phi_4712_: f64;
    var phi_4717_: f64;
    var phi_4724_: f64;
    var phi_4729_: f64;
    var phi_4743_: f64;
    var phi_4750_: f64;
    var phi_4755_: f64;
    var phi_4762_: f64;
    var phi_4767_: f64;
    var phi_4772_: f64;
    var phi_4796_: bool;
    var phi_4797_: bool;
    var phi_4798_: bool;
    var phi_4815_: f64;
    var phi_4816_: bool;
    var phi_4817_: f64;
    var phi_4818_: bool;
    var phi_4823_: f64;
    var phi_4825_: f64;
    var phi_4826_: f64;
    var phi_4827_: bool;
    var phi_4828_: f64;
    var phi_4829_: f64;
    var phi_4830_: bool;
    var phi_4831_: bool;
    var phi_4832_: f64;
    var phi_4833_: f64;
    var phi_4834_: f64;
    var phi_4835_: f64;
    var phi_4836_: bool;
    var phi_4837_: bool;
    var phi_4838_: bool;
    var phi_4839_: bool;
    var phi_4840_: f64;
    var phi_4841_: f64;
    var phi_4842_: f64;
    var phi_4843_: f64;
    var phi_4844_: bool;
    var phi_4845_: bool;
    var phi_4846_: bool;
    var phi_4847_: bool;
    var phi_4848_: bool;
    var phi_4849_: f64;
    var phi_4850_: f64;
    var phi_4851_: f64;
    var phi_4852_: f64;
    var phi_4853_: bool;
    var phi_4854_: bool;
    var phi_4855_: bool;
    var phi_4856_: bool;
    var phi_4857_: bool;
    var phi_4943_: f64;
    var phi_5016_: f64;
    var phi_5021_: f64;
    var phi_5094_: f64;
    var phi_5167_: f64;
    var phi_5172_: f64;
    var phi_5193_: f64;
    var phi_5194_: f64;
    var phi_5195_: f64;
    var phi_4870_: bool;
    var phi_5197_: u32;
    var phi_5198_: f64;
    var phi_5199_: bool;
    var phi_5200_: bool;
    var phi_5201_: bool;
    var phi_5202_: u32;
    var phi_5203_: f64;
    var phi_5204_: f64;
    var phi_5205_: f64;
    var phi_5206_: f64;
    var phi_5207_: bool;
    var phi_5208_: u32;
    var phi_5209_: bool;
    var phi_5210_: bool;
    var phi_5211_: bool;
    var phi_5212_: bool;
    var phi_5213_: bool;
    var phi_5214_: bool;
    var phi_5223_: f64;
    var phi_5228_: f64;
    var phi_5237_: bool;
    var phi_5241_: bool;
    var phi_5242_: f64;
    var phi_5243_: f64;
    var phi_5244_: f64;
    var phi_5245_: f64;
    var phi_5246_: bool;
    var phi_5247_: u32;
    var phi_5248_: bool;
    var phi_5249_: bool;
    var phi_5250_: bool;
    var phi_5251_: bool;
    var phi_5252_: bool;
    var phi_5253_: bool;
    var phi_3032_: f64;
    var phi_3034_: f64;
    var phi_3036_: f64;
    var phi_3038_: f64;
    var phi_3040_: bool;
    var phi_3042_: u32;
    var phi_5254_: f64;
    var phi_5255_: f64;
    var phi_5256_: bool;
    var phi_5257_: bool;
    var phi_5258_: bool;
    var phi_5259_: bool;
    var phi_5260_: bool;
    var phi_5261_: bool;
    var phi_5262_: bool;
    var local_44: bool;
    var phi_5266_: bool;
    var phi_5267_: bool;
    var phi_5268_: bool;
    var phi_5269_: bool;
    var phi_5270_: bool;
    var local_45: f64;
    var phi_5275_: type_45;
    var phi_5276_: bool;
    var phi_5277_: bool;
    var phi_5278_: bool;
    var phi_5279_: bool;
    var phi_5280_: bool;
    var phi_5285_: type_45;
    var phi_5286_: bool;
    var phi_5287_: bool;
    var phi_5288_: bool;
    var phi_5289_: bool;
    var phi_5290_: bool;
    var phi_5294_: f64;
    var phi_5295_: bool;
    var phi_5296_: bool;
    var phi_5297_: bool;
    var phi_5298_: bool;
    var phi_5302_: f64;
    var phi_5303_: bool;
    var phi_5304_: bool;
    var phi_5305_: bool;
    var phi_5310_: type_45;
    var phi_5311_: bool;
    var phi_5312_: bool;
    var phi_5317_: type_45;
    var phi_5318_: bool;
    var phi_5322_: type_45;
    var phi_5329_: f64;
    var phi_5330_: bool;
    var phi_5443_: f64;
    var phi_5450_: f64;
    var phi_5458_: f64;
    var phi_5516_: array<f64, 3>;
    var phi_5584_: array<f64, 3>;
    var phi_5609_: f64;
    var phi_5616_: f64;
    var phi_5621_: f64;
    var phi_5628_: f64;
    var phi_5633_: f64;
    var phi_5646_: f64;
    var phi_5653_: f64;
    var phi_5658_: f64;
    var phi_5665_: f64;
    var phi_5670_: f64;
    var phi_5675_: f64;
    var phi_5692_: f64;
    var phi_5699_: f64;
    var phi_5704_: f64;
    var phi_5711_: f64;
    var phi_5716_: f64;
    var phi_5730_: f64;
    var phi_5737_: f64;
    var phi_5742_: f64;
    var phi_5749_: f64;
    var phi_5754_: f64;
    var phi_5759_: f64;
    var phi_5776_: f64;
    var phi_5783_: f64;
    var phi_5788_: f64;
    var phi_5795_: f64;
    var phi_5800_: f64;
    var phi_5814_: f64;
    var phi_5821_: f64;
    var phi_5826_: f64;
    var phi_5833_: f64;
    var phi_5838_: f64;
    var phi_5843_: f64;
    var phi_5955_: type_18;
    var phi_5958_: f64;
    var phi_5979_: bool;
    var phi_5985_: type_19;
    var phi_5956_: type_18;
    var phi_5999_: type_19;
    var phi_5959_: f64;
    var local_46: f64;
    var phi_5948_: f64;
    var phi_6012_: f64;
    var phi_6149_: f64;
    var phi_6155_: f64;
    var phi_6164_: f64;
    var phi_6170_: f64;
    var phi_6179_: f64;
    var phi_6185_: f64;
    var phi_6194_: f64;
    var phi_6200_: f64;
    var phi_6250_: type_18;
    var phi_6253_: f64;
    var phi_6274_: bool;
    var phi_6280_: type_19;
    var phi_6251_: type_18;
    var phi_6294_: type_19;
    var phi_6254_: f64;
    var local_47: f64;
    var phi_6243_: f64;
    var phi_6307_: f64;
    var phi_6339_: type_18;
    var phi_6342_: f64;
    var phi_6363_: bool;
    var phi_6369_: type_19;
    var phi_6340_: type_18;
    var phi_6383_: type_19;
    var phi_6343_: f64;
    var local_48: f64;
    var phi_6332_: f64;
    var phi_6396_: f64;
    var phi_6414_: f64;
    var phi_6421_: f64;
    var phi_6426_: f64;
    var phi_6433_: f64;
    var phi_6438_: f64;
    var phi_6451_: f64;
    var phi_6458_: f64;
    var phi_6463_: f64;
    var phi_6470_: f64;
    var phi_6475_: f64;
    var phi_6480_: f64;
    var phi_6497_: f64;
    var phi_6504_: f64;
    var phi_6509_: f64;
    var phi_6516_: f64;
    var phi_6521_: f64;
    var phi_6535_: f64;
    var phi_6542_: f64;
    var phi_6547_: f64;
    var phi_6554_: f64;
    var phi_6559_: f64;
    var phi_6564_: f64;
    var phi_6581_: f64;
    var phi_6588_: f64;
    var phi_6593_: f64;
    var phi_6600_: f64;
    var phi_6605_: f64;
    var phi_6619_: f64;
    var phi_6626_: f64;
    var phi_6631_: f64;
    var phi_6638_: f64;
    var phi_6643_: f64;
    var phi_6648_: f64;
    var phi_6696_: f64;
    var phi_6702_: f64;
    var phi_6714_: type_9;
    var phi_6717_: f64;
    var phi_6715_: type_9;
    var phi_6740_: type_9;
    var phi_6770_: f64;
    var phi_6776_: f64;
    var phi_6790_: f64;
    var phi_6718_: f64;
    var local_49: f64;
    var local_50: f64;
    var phi_6819_: type_18;
    var phi_6822_: f64;
    var phi_6843_: bool;
    var phi_6849_: type_19;
    var phi_6820_: type_18;
    var phi_6863_: type_19;
    var phi_6823_: f64;
    var local_51: f64;
    var phi_6812_: f64;
    var phi_6876_: f64;
    var phi_6883_: type_9;
    var phi_6886_: f64;
    var phi_6888_: bool;
    var phi_6890_: bool;
    var phi_6884_: type_9;
    var phi_6913_: type_9;
    var phi_6950_: f64;
    var phi_6957_: f64;
    var phi_6965_: f64;
    var phi_6973_: f64;
    var phi_6980_: f64;
    var phi_6988_: f64;
    var phi_6994_: f64;
    var phi_7014_: f64;
    var phi_7020_: f64;
    var phi_7027_: f64;
    var phi_7056_: f64;
    var phi_7062_: f64;
    var phi_7099_: bool;
    var phi_7106_: bool;
    var phi_7119_: f64;
    var phi_7125_: f64;
    var phi_7126_: f64;
    var phi_7127_: f64;
    var phi_6887_: f64;
    var phi_6889_: bool;
    var phi_6891_: bool;
    var local_52: f64;
    var phi_7133_: f64;
    var local_53: bool;
    var local_54: bool;
    var phi_7144_: type_47;
    var phi_7145_: type_47;
    var phi_7146_: bool;
    var local_55: bool;
    var phi_7164_: f64;
    var phi_7165_: f64;
    var phi_7168_: type_9;
    var phi_7171_: f64;
    var phi_7173_: f64;
    var phi_7169_: type_9;
    var phi_7196_: type_9;
    var phi_7282_: f64;
    var phi_7283_: f64;
    var phi_7284_: f64;
    var phi_7265_: f64;
    var phi_7285_: f64;
    var phi_7286_: f64;
    var phi_7172_: f64;
    var phi_7174_: f64;
    var local_56: f64;
    var local_57: f64;
    var local_58: f64;
    var phi_7449_: bool;
    var phi_7450_: bool;
    var phi_7451_: bool;
    var phi_7452_: bool;
    var phi_7453_: bool;
    var phi_7454_: bool;
    var phi_7458_: bool;
    var phi_7462_: bool;
    var phi_7463_: bool;
    var phi_7464_: bool;
    var phi_7469_: f64;
    var phi_7473_: type_47;
    var phi_7474_: type_47;
    var phi_7475_: bool;
    var phi_7476_: type_47;
    var phi_7477_: type_47;
    var phi_7478_: bool;
    var phi_7484_: type_47;
    var phi_7485_: type_47;
    var phi_7486_: bool;
    var phi_7490_: type_47;
    var phi_7491_: type_47;
    var phi_7492_: bool;
    var phi_7493_: bool;
    var phi_7494_: type_47;
    var phi_7495_: type_47;
    var phi_7496_: bool;
    var phi_7497_: bool;
    var phi_7503_: type_47;
    var phi_7504_: bool;
    var phi_7508_: type_47;
    var phi_7524_: f64;
    var phi_7525_: f64;
    var phi_7526_: bool;
    var phi_7527_: f64;
    var phi_7528_: f64;
    var phi_7529_: bool;
    var phi_7530_: bool;
    var phi_7531_: bool;
    var phi_7532_: f64;
    var phi_7533_: f64;
    var phi_7534_: bool;
    var phi_7535_: bool;
    var phi_7536_: bool;
    var phi_7537_: f64;
    var phi_7538_: u32;
    var phi_7539_: f64;
    var phi_7540_: type_47;
    var phi_7541_: u32;
    var phi_7542_: u32;
    var phi_7543_: bool;
    var phi_7544_: bool;
    var phi_7545_: bool;
    var phi_7546_: f64;
    var phi_7547_: u32;
    var phi_7548_: f64;
    var phi_7549_: type_47;
    var phi_7550_: u32;
    var phi_7551_: u32;
    var phi_7552_: bool;
    var phi_7553_: bool;
    var phi_7554_: bool;
    var phi_7555_: bool;
    var phi_7556_: bool;
    var phi_7557_: f64;
    var phi_2541_: f64;
    var phi_2543_: u32;
    var phi_2545_: f64;
    var phi_7558_: type_47;
    var phi_7559_: u32;
    var phi_7560_: f64;
    var phi_7561_: u32;
    var phi_7562_: bool;
    var phi_7563_: bool;
    var phi_7564_: bool;
    var phi_7565_: bool;
    var phi_7566_: bool;
    var phi_7567_: bool;
    var local_59: bool;
    var phi_7571_: bool;
    var phi_7572_: bool;
    var phi_7573_: bool;
    var phi_7574_: bool;
    var local_60: type_47;
    var local_61: type_47;
    var phi_7591_: u32;
    var local_62: type_47;
    var phi_7596_: type_46;
    var phi_7597_: type_46;
    var phi_7598_: bool;
    var phi_7599_: bool;
    var phi_7600_: bool;
    var phi_7601_: bool;
    var phi_7605_: u32;
    var phi_7606_: f64;
    var phi_7607_: bool;
    var phi_7608_: bool;
    var phi_7609_: bool;
    var phi_7610_: bool;
    var phi_7614_: f64;
    var phi_7615_: u32;
    var phi_7616_: bool;
    var phi_7617_: bool;
    var phi_7618_: bool;
    var phi_7632_: f64;
    var phi_7635_: type_9;
    var phi_7636_: type_9;
    var phi_7659_: type_9;
    var phi_7681_: f64;
    var phi_7811_: type_18;
    var phi_7814_: f64;
    var phi_7835_: bool;
    var phi_7841_: type_19;
    var phi_7812_: type_18;
    var phi_7855_: type_19;
    var phi_7815_: f64;
    var local_63: f64;
    var phi_7804_: f64;
    var phi_7868_: f64;
    var phi_7886_: f64;
    var phi_7893_: f64;
    var phi_7898_: f64;
    var phi_7905_: f64;
    var phi_7910_: f64;
    var phi_7923_: f64;
    var phi_7930_: f64;
    var phi_7935_: f64;
    var phi_7942_: f64;
    var phi_7947_: f64;
    var phi_7952_: f64;
    var phi_7969_: f64;
    var phi_7976_: f64;
    var phi_7981_: f64;
    var phi_7988_: f64;
    var phi_7993_: f64;
    var phi_8007_: f64;
    var phi_8014_: f64;
    var phi_8019_: f64;
    var phi_8026_: f64;
    var phi_8031_: f64;
    var phi_8036_: f64;
    var phi_8053_: f64;
    var phi_8060_: f64;
    var phi_8065_: f64;
    var phi_8072_: f64;
    var phi_8077_: f64;
    var phi_8091_: f64;
    var phi_8098_: f64;
    var phi_8103_: f64;
    var phi_8110_: f64;
    var phi_8115_: f64;
    var phi_8120_: f64;
    var phi_8144_: bool;
    var phi_8145_: bool;
    var phi_8146_: bool;
    var local_64: bool;
    var phi_8154_: u32;
    var phi_8158_: type_46;
    var phi_8159_: bool;
    var phi_8167_: u32;
    var phi_8171_: type_46;
    var phi_8172_: type_46;
    var phi_8173_: bool;
    var phi_8174_: bool;
    var phi_8181_: type_46;
    var phi_8182_: bool;
    var phi_8186_: type_46;
    var phi_8187_: type_46;
    var phi_8188_: bool;
    var phi_8192_: type_46;
    var phi_16016_: type_46;
    var phi_16034_: type_49;
    var phi_16052_: bool;
    var phi_16059_: bool;
    var phi_16060_: bool;
    var phi_16083_: u32;
    var phi_16087_: type_20;
    var phi_16088_: bool;
    var phi_16099_: u32;
    var phi_16159_: bool;
    var phi_16160_: bool;
    var local_65: u32;
    var local_66: f64;
    var local_67: f64;
    var local_68: bool;
    var local_69: bool;
    var local_70: f64;
    var local_71: bool;
    var local_72: bool;
    var local_73: bool;
    var local_74: bool;
    var local_75: bool;
    var local_76: bool;
    var local_77: f64;
    var local_78: f64;
    var local_79: f64;
    var local_80: bool;
    var local_81: bool;
    var local_82: bool;
    var local_83: bool;
    var local_84: bool;
    var local_85: bool;
    var local_86: bool;
    var local_87: bool;
    var local_88: bool;
    var local_89: bool;
    var local_90: f64;
    var local_91: f64;
    var local_92: f64;
    var local_93: f64;
    var local_94: bool;
    var local_95: bool;
    var local_96: bool;
    var local_97: bool;
    var local_98: bool;
    var local_99: u32;
    var local_100: bool;
    var local_101: u32;
    var local_102: u32;
    var local_103: f64;
    var local_104: f64;
    var local_105: f64;
    var local_106: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e122 = id_2;
    let _e123 = n_2;
    let _e124 = lane_2;
    let _e136 = ((_e122.y * _e123.x) + _e122.x);
    let _e139 = (_e123.x * _e123.y);
    let _e142 = params.member.member_1.member_2;
    let _e144 = input.member[0u];
    if (_e142 < _e144) {
        phi_405_ = _e142;
    } else {
        phi_405_ = _e144;
    }
    let _e147 = phi_405_;
    let _e149 = params.member.member_1.member_1;
    if (_e147 > _e149) {
        let _e152 = params.member.member_1.member_1;
        phi_415_ = (_e147 - _e152);
    } else {
        phi_415_ = 0u;
    }
    let _e155 = phi_415_;
    let _e157 = params.member.member_1.member;
    if (_e157 < _e155) {
        phi_422_ = _e157;
    } else {
        phi_422_ = _e155;
    }
    let _e160 = phi_422_;
    let _e161 = (_e160 / 64u);
    if ((_e160 % 64u) > 0u) {
        phi_438_ = (_e161 + 1u);
    } else {
        phi_438_ = _e161;
    }
    let _e166 = phi_438_;
    if (_e166 > _e136) {
        let _e168 = (_e166 - _e136);
        if (_e139 == 0u) {
            return;
        }
        let _e170 = (_e168 / _e139);
        if (_e139 == 0u) {
            return;
        }
        if ((_e168 % _e139) > 0u) {
            phi_459_ = (_e170 + 1u);
        } else {
            phi_459_ = _e170;
        }
        let _e176 = phi_459_;
        phi_460_ = _e176;
    } else {
        phi_460_ = 0u;
    }
    let _e178 = phi_460_;
    phi_463_ = type_9(0u, _e178);
    loop {
        let _e181 = phi_463_;
        if (_e181.member < _e181.member_1) {
            phi_464_ = type_9((_e181.member + 1u), _e181.member_1);
            phi_487_ = type_9(1u, _e181.member);
        } else {
            phi_464_ = _e181;
            phi_487_ = type_9(0u, type_9().member_1);
        }
        let _e193 = phi_464_;
        let _e195 = phi_487_;
        let _e199 = (bitcast<i32>(_e195.member) != 0i);
        if _e199 {
            let _e203 = (((_e136 + (_e195.member_1 * _e139)) * 64u) + _e124);
            let _e206 = params.member.member_2.member;
            let _e209 = params.member.member.member_1;
            let _e211 = ((_e209 & 16u) != 0u);
            if (_e203 < _e160) {
                let _e216 = params.member.member_1.member_1;
                let _e218 = (2u * (_e216 + _e203));
                let _e221 = input.member[(4u + _e218)];
                let _e224 = input.member[(_e218 + 5u)];
                if (_e206 == 0u) {
                    let _e241 = (3u * _e224);
                    let _e243 = elements.member[_e241];
                    let _e246 = elements.member[(_e241 + 1u)];
                    let _e249 = elements.member[(_e241 + 2u)];
                    phi_625_ = type_23(0u, array<u32, 4>(_e221, _e243, _e246, _e249));
                } else {
                    let _e227 = (2u * _e221);
                    let _e228 = (2u * _e224);
                    let _e230 = elements.member[_e227];
                    let _e232 = elements.member[_e228];
                    let _e235 = elements.member[(_e227 + 1u)];
                    let _e238 = elements.member[(_e228 + 1u)];
                    phi_625_ = type_23(1u, array<u32, 4>(_e230, _e235, _e232, _e238));
                }
                let _e253 = phi_625_;
                let _e257 = params.member.member.member_1;
                if ((_e257 & 8u) != 0u) {
                    let _e301 = paths.member[_e253.member_1[0]];
                    let _e316 = paths.member[_e253.member_1[1]];
                    let _e331 = paths.member[_e253.member_1[2]];
                    let _e346 = paths.member[_e253.member_1[3]];
                    let _e367 = function_(array<f32, 3>(_e301.member.x, _e301.member.y, _e301.member.z));
                    let _e368 = function_(array<f32, 3>(_e316.member.x, _e316.member.y, _e316.member.z));
                    let _e369 = function_(array<f32, 3>(_e331.member.x, _e331.member.y, _e331.member.z));
                    let _e370 = function_(array<f32, 3>(_e346.member.x, _e346.member.y, _e346.member.z));
                    let _e372 = function_(array<f32, 3>(_e301.member_1.x, _e301.member_1.y, _e301.member_1.z));
                    let _e373 = function_(array<f32, 3>(_e316.member_1.x, _e316.member_1.y, _e316.member_1.z));
                    let _e374 = function_(array<f32, 3>(_e331.member_1.x, _e331.member_1.y, _e331.member_1.z));
                    let _e375 = function_(array<f32, 3>(_e346.member_1.x, _e346.member_1.y, _e346.member_1.z));
                    phi_821_ = type_31(array<array<f64, 3>, 4>(_e367, _e368, _e369, _e370), array<array<f64, 3>, 4>(_e372, _e373, _e374, _e375));
                } else {
                    let _e262 = positions.member[_e253.member_1[0]];
                    let _e265 = params.member.member.member[0u];
                    let _e268 = positions.member[(_e265 + _e253.member_1[0])];
                    let _e271 = positions.member[_e253.member_1[1]];
                    let _e274 = params.member.member.member[0u];
                    let _e277 = positions.member[(_e274 + _e253.member_1[1])];
                    let _e280 = positions.member[_e253.member_1[2]];
                    let _e283 = params.member.member.member[0u];
                    let _e286 = positions.member[(_e283 + _e253.member_1[2])];
                    let _e289 = positions.member[_e253.member_1[3]];
                    let _e292 = params.member.member.member[0u];
                    let _e295 = positions.member[(_e292 + _e253.member_1[3])];
                    phi_821_ = type_31(array<array<f64, 3>, 4>(_e262, _e271, _e280, _e289), array<array<f64, 3>, 4>(_e268, _e277, _e286, _e295));
                }
                let _e379 = phi_821_;
                if (_e253.member != 0u) {
                    phi_982_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e379.member[2][0] - _e379.member[0][0]), (_e379.member[2][1] - _e379.member[0][1]), (_e379.member[2][2] - _e379.member[0][2])), array<f64, 3>((_e379.member_1[2][0] - _e379.member_1[0][0]), (_e379.member_1[2][1] - _e379.member_1[0][1]), (_e379.member_1[2][2] - _e379.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e379.member[1][0] - _e379.member[0][0]), (_e379.member[1][1] - _e379.member[0][1]), (_e379.member[1][2] - _e379.member[0][2])), array<f64, 3>((_e379.member_1[1][0] - _e379.member_1[0][0]), (_e379.member_1[1][1] - _e379.member_1[0][1]), (_e379.member_1[1][2] - _e379.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e379.member[2][0] - _e379.member[3][0]), (_e379.member[2][1] - _e379.member[3][1]), (_e379.member[2][2] - _e379.member[3][2])), array<f64, 3>((_e379.member_1[2][0] - _e379.member_1[3][0]), (_e379.member_1[2][1] - _e379.member_1[3][1]), (_e379.member_1[2][2] - _e379.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_982_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e379.member[0][0] - _e379.member[1][0]), (_e379.member[0][1] - _e379.member[1][1]), (_e379.member[0][2] - _e379.member[1][2])), array<f64, 3>((_e379.member_1[0][0] - _e379.member_1[1][0]), (_e379.member_1[0][1] - _e379.member_1[1][1]), (_e379.member_1[0][2] - _e379.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e379.member[2][0] - _e379.member[1][0]), (_e379.member[2][1] - _e379.member[1][1]), (_e379.member[2][2] - _e379.member[1][2])), array<f64, 3>((_e379.member_1[2][0] - _e379.member_1[1][0]), (_e379.member_1[2][1] - _e379.member_1[1][1]), (_e379.member_1[2][2] - _e379.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e379.member[3][0] - _e379.member[1][0]), (_e379.member[3][1] - _e379.member[1][1]), (_e379.member[3][2] - _e379.member[1][2])), array<f64, 3>((_e379.member_1[3][0] - _e379.member_1[1][0]), (_e379.member_1[3][1] - _e379.member_1[1][1]), (_e379.member_1[3][2] - _e379.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e538 = phi_982_;
                let _e540 = params.member.member.member_7;
                let _e547 = bitcast<f64>(((u64(_e540[1]) * 4294967296lu) + u64(_e540[0])));
                let _e549 = params.member.member.member_14;
                let _e556 = bitcast<f64>(((u64(_e549[1]) * 4294967296lu) + u64(_e549[0])));
                let _e558 = params.member.member.member_15;
                let _e565 = bitcast<f64>(((u64(_e558[1]) * 4294967296lu) + u64(_e558[0])));
                let _e567 = params.member.member.member_16;
                let _e574 = bitcast<f64>(((u64(_e567[1]) * 4294967296lu) + u64(_e567[0])));
                let _e576 = params.member.member.member_16;
                let _e583 = bitcast<f64>(((u64(_e576[1]) * 4294967296lu) + u64(_e576[0])));
                let _e585 = params.member.member.member_1;
                if (_e538.member[0][0] < 0.0lf) {
                    phi_1039_ = -(_e538.member[0][0]);
                } else {
                    phi_1039_ = _e538.member[0][0];
                }
                let _e594 = phi_1039_;
                if (_e538.member[0][1] < 0.0lf) {
                    phi_1046_ = -(_e538.member[0][1]);
                } else {
                    phi_1046_ = _e538.member[0][1];
                }
                let _e599 = phi_1046_;
                if (_e594 > _e599) {
                    phi_1051_ = _e594;
                } else {
                    phi_1051_ = _e599;
                }
                let _e602 = phi_1051_;
                if (_e538.member[0][2] < 0.0lf) {
                    phi_1058_ = -(_e538.member[0][2]);
                } else {
                    phi_1058_ = _e538.member[0][2];
                }
                let _e607 = phi_1058_;
                if (_e602 > _e607) {
                    phi_1063_ = _e602;
                } else {
                    phi_1063_ = _e607;
                }
                let _e610 = phi_1063_;
                if (_e538.member[1][0] < 0.0lf) {
                    phi_1071_ = -(_e538.member[1][0]);
                } else {
                    phi_1071_ = _e538.member[1][0];
                }
                let _e617 = phi_1071_;
                if (_e538.member[1][1] < 0.0lf) {
                    phi_1078_ = -(_e538.member[1][1]);
                } else {
                    phi_1078_ = _e538.member[1][1];
                }
                let _e622 = phi_1078_;
                if (_e617 > _e622) {
                    phi_1083_ = _e617;
                } else {
                    phi_1083_ = _e622;
                }
                let _e625 = phi_1083_;
                if (_e538.member[1][2] < 0.0lf) {
                    phi_1090_ = -(_e538.member[1][2]);
                } else {
                    phi_1090_ = _e538.member[1][2];
                }
                let _e630 = phi_1090_;
                if (_e625 > _e630) {
                    phi_1095_ = _e625;
                } else {
                    phi_1095_ = _e630;
                }
                let _e633 = phi_1095_;
                if (_e610 > _e633) {
                    phi_1100_ = _e610;
                } else {
                    phi_1100_ = _e633;
                }
                let _e636 = phi_1100_;
                let _e638 = (_e636 + _e538.member_3);
                if (_e538.member_1[0][0] < 0.0lf) {
                    phi_1110_ = -(_e538.member_1[0][0]);
                } else {
                    phi_1110_ = _e538.member_1[0][0];
                }
                let _e645 = phi_1110_;
                if (_e538.member_1[0][1] < 0.0lf) {
                    phi_1117_ = -(_e538.member_1[0][1]);
                } else {
                    phi_1117_ = _e538.member_1[0][1];
                }
                let _e650 = phi_1117_;
                if (_e645 > _e650) {
                    phi_1122_ = _e645;
                } else {
                    phi_1122_ = _e650;
                }
                let _e653 = phi_1122_;
                if (_e538.member_1[0][2] < 0.0lf) {
                    phi_1129_ = -(_e538.member_1[0][2]);
                } else {
                    phi_1129_ = _e538.member_1[0][2];
                }
                let _e658 = phi_1129_;
                if (_e653 > _e658) {
                    phi_1134_ = _e653;
                } else {
                    phi_1134_ = _e658;
                }
                let _e661 = phi_1134_;
                if (_e538.member_1[1][0] < 0.0lf) {
                    phi_1142_ = -(_e538.member_1[1][0]);
                } else {
                    phi_1142_ = _e538.member_1[1][0];
                }
                let _e668 = phi_1142_;
                if (_e538.member_1[1][1] < 0.0lf) {
                    phi_1149_ = -(_e538.member_1[1][1]);
                } else {
                    phi_1149_ = _e538.member_1[1][1];
                }
                let _e673 = phi_1149_;
                if (_e668 > _e673) {
                    phi_1154_ = _e668;
                } else {
                    phi_1154_ = _e673;
                }
                let _e676 = phi_1154_;
                if (_e538.member_1[1][2] < 0.0lf) {
                    phi_1161_ = -(_e538.member_1[1][2]);
                } else {
                    phi_1161_ = _e538.member_1[1][2];
                }
                let _e681 = phi_1161_;
                if (_e676 > _e681) {
                    phi_1166_ = _e676;
                } else {
                    phi_1166_ = _e681;
                }
                let _e684 = phi_1166_;
                if (_e661 > _e684) {
                    phi_1171_ = _e661;
                } else {
                    phi_1171_ = _e684;
                }
                let _e687 = phi_1171_;
                let _e689 = (_e687 + _e538.member_3);
                if (_e538.member_2[0][0] < 0.0lf) {
                    phi_1181_ = -(_e538.member_2[0][0]);
                } else {
                    phi_1181_ = _e538.member_2[0][0];
                }
                let _e696 = phi_1181_;
                if (_e538.member_2[0][1] < 0.0lf) {
                    phi_1188_ = -(_e538.member_2[0][1]);
                } else {
                    phi_1188_ = _e538.member_2[0][1];
                }
                let _e701 = phi_1188_;
                if (_e696 > _e701) {
                    phi_1193_ = _e696;
                } else {
                    phi_1193_ = _e701;
                }
                let _e704 = phi_1193_;
                if (_e538.member_2[0][2] < 0.0lf) {
                    phi_1200_ = -(_e538.member_2[0][2]);
                } else {
                    phi_1200_ = _e538.member_2[0][2];
                }
                let _e709 = phi_1200_;
                if (_e704 > _e709) {
                    phi_1205_ = _e704;
                } else {
                    phi_1205_ = _e709;
                }
                let _e712 = phi_1205_;
                if (_e538.member_2[1][0] < 0.0lf) {
                    phi_1213_ = -(_e538.member_2[1][0]);
                } else {
                    phi_1213_ = _e538.member_2[1][0];
                }
                let _e719 = phi_1213_;
                if (_e538.member_2[1][1] < 0.0lf) {
                    phi_1220_ = -(_e538.member_2[1][1]);
                } else {
                    phi_1220_ = _e538.member_2[1][1];
                }
                let _e724 = phi_1220_;
                if (_e719 > _e724) {
                    phi_1225_ = _e719;
                } else {
                    phi_1225_ = _e724;
                }
                let _e727 = phi_1225_;
                if (_e538.member_2[1][2] < 0.0lf) {
                    phi_1232_ = -(_e538.member_2[1][2]);
                } else {
                    phi_1232_ = _e538.member_2[1][2];
                }
                let _e732 = phi_1232_;
                if (_e727 > _e732) {
                    phi_1237_ = _e727;
                } else {
                    phi_1237_ = _e732;
                }
                let _e735 = phi_1237_;
                if (_e712 > _e735) {
                    phi_1242_ = _e712;
                } else {
                    phi_1242_ = _e735;
                }
                let _e738 = phi_1242_;
                let _e740 = (_e738 + _e538.member_3);
                if (_e638 > _e689) {
                    phi_1249_ = _e638;
                } else {
                    phi_1249_ = _e689;
                }
                let _e743 = phi_1249_;
                if (_e743 > _e740) {
                    phi_1254_ = _e743;
                } else {
                    phi_1254_ = _e740;
                }
                let _e746 = phi_1254_;
                if (_e746 <= f64(65536f)) {
                    phi_1263_ = (_e746 >= f64((1f / 65536f)));
                } else {
                    phi_1263_ = false;
                }
                let _e753 = phi_1263_;
                if _e753 {
                    phi_1363_ = type_44();
                    phi_1364_ = true;
                } else {
                    if (_e746 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e746) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e760 = (9214364837600034816lu - (bitcast<u64>(_e746) & 9218868437227405312lu));
                            if (_e760 > 4503599627370496lu) {
                                phi_1287_ = _e760;
                            } else {
                                phi_1287_ = 4503599627370496lu;
                            }
                            let _e763 = phi_1287_;
                            let _e764 = bitcast<f64>(_e763);
                            let _e765 = (_e547 * _e764);
                            if (_e547 > f64(0f)) {
                                if (_e765 > 2.2250738585072014e-308lf) {
                                    phi_1299_ = _e765;
                                } else {
                                    phi_1299_ = 2.2250738585072014e-308lf;
                                }
                                let _e770 = phi_1299_;
                                phi_1300_ = _e770;
                            } else {
                                phi_1300_ = _e765;
                            }
                            let _e772 = phi_1300_;
                            phi_1359_ = type_44(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e538.member[0][0] * _e764), (_e538.member[0][1] * _e764), (_e538.member[0][2] * _e764)), array<f64, 3>((_e538.member[1][0] * _e764), (_e538.member[1][1] * _e764), (_e538.member[1][2] * _e764))), array<array<f64, 3>, 2>(array<f64, 3>((_e538.member_1[0][0] * _e764), (_e538.member_1[0][1] * _e764), (_e538.member_1[0][2] * _e764)), array<f64, 3>((_e538.member_1[1][0] * _e764), (_e538.member_1[1][1] * _e764), (_e538.member_1[1][2] * _e764))), array<array<f64, 3>, 2>(array<f64, 3>((_e538.member_2[0][0] * _e764), (_e538.member_2[0][1] * _e764), (_e538.member_2[0][2] * _e764)), array<f64, 3>((_e538.member_2[1][0] * _e764), (_e538.member_2[1][1] * _e764), (_e538.member_2[1][2] * _e764))), ((_e538.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e764)), _e772);
                            phi_1360_ = false;
                        } else {
                            phi_1359_ = type_44();
                            phi_1360_ = true;
                        }
                        let _e838 = phi_1359_;
                        let _e840 = phi_1360_;
                        phi_1361_ = _e838;
                        phi_1362_ = _e840;
                    } else {
                        phi_1361_ = type_44();
                        phi_1362_ = true;
                    }
                    let _e842 = phi_1361_;
                    let _e844 = phi_1362_;
                    phi_1363_ = _e842;
                    phi_1364_ = _e844;
                }
                let _e846 = phi_1363_;
                let _e848 = phi_1364_;
                if _e848 {
                    phi_1369_ = type_44(_e538, _e547);
                } else {
                    phi_1369_ = _e846;
                }
                let _e851 = phi_1369_;
                local_19 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e851.member.member[0][0], _e851.member.member[0][1], _e851.member.member[0][2]), array<f64, 3>(_e851.member.member[1][0], _e851.member.member[1][1], _e851.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e851.member.member_1[0][0], _e851.member.member_1[0][1], _e851.member.member_1[0][2]), array<f64, 3>(_e851.member.member_1[1][0], _e851.member.member_1[1][1], _e851.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e851.member.member_2[0][0], _e851.member.member_2[0][1], _e851.member.member_2[0][2]), array<f64, 3>(_e851.member.member_2[1][0], _e851.member.member_2[1][1], _e851.member.member_2[1][2])), _e851.member.member_3);
                if (_e851.member_1 > f64(0f)) {
                    let _e6380 = local_19.member[0u];
                    let _e6386 = local_19.member[1u];
                    let _e6402 = local_19.member_1[0u];
                    let _e6408 = local_19.member_1[1u];
                    let _e6424 = local_19.member_2[0u];
                    let _e6430 = local_19.member_2[1u];
                    let _e6444 = function_5(array<f64, 3>((_e6380[0] + ((_e6386[0] - _e6380[0]) * _e565)), (_e6380[1] + ((_e6386[1] - _e6380[1]) * _e565)), (_e6380[2] + ((_e6386[2] - _e6380[2]) * _e565))), array<f64, 3>((_e6402[0] + ((_e6408[0] - _e6402[0]) * _e565)), (_e6402[1] + ((_e6408[1] - _e6402[1]) * _e565)), (_e6402[2] + ((_e6408[2] - _e6402[2]) * _e565))), array<f64, 3>((_e6424[0] + ((_e6430[0] - _e6424[0]) * _e565)), (_e6424[1] + ((_e6430[1] - _e6424[1]) * _e565)), (_e6424[2] + ((_e6430[2] - _e6424[2]) * _e565))), _e253.member);
                    let _e6455 = (((_e6444[0] * _e6444[0]) + (_e6444[1] * _e6444[1])) + (_e6444[2] * _e6444[2]));
                    if (_e6455 <= 2.2250738585072014e-308lf) {
                        if (_e6455 > 0.0lf) {
                            phi_1537_ = (1.464336215552873e-154lf * 2.0lf);
                        } else {
                            phi_1537_ = 0.0lf;
                        }
                        let _e6507 = phi_1537_;
                        phi_1601_ = _e6507;
                    } else {
                        phi_1544_ = type_18(0i, 5i);
                        phi_1547_ = bitcast<f64>(((bitcast<u64>(_e6455) / 2lu) + 2303426169912950784lu));
                        loop {
                            let _e6462 = phi_1544_;
                            let _e6464 = phi_1547_;
                            local_41 = _e6464;
                            if (_e6462.member < _e6462.member_1) {
                                let _e6471 = (_e6462.member + 1i);
                                if ((false == (_e6471 > _e6462.member)) != false) {
                                    phi_1568_ = true;
                                } else {
                                    phi_1568_ = false;
                                }
                                let _e6476 = phi_1568_;
                                if _e6476 {
                                    phi_1574_ = type_19(0u, type_19().member_1);
                                } else {
                                    phi_1574_ = type_19(1u, _e6471);
                                }
                                let _e6481 = phi_1574_;
                                phi_1545_ = type_18(_e6481.member_1, _e6462.member_1);
                                phi_1588_ = type_19(1u, _e6462.member);
                            } else {
                                phi_1545_ = _e6462;
                                phi_1588_ = type_19(0u, type_19().member_1);
                            }
                            let _e6487 = phi_1545_;
                            let _e6489 = phi_1588_;
                            let _e6492 = (bitcast<i32>(_e6489.member) != 0i);
                            if _e6492 {
                                phi_1548_ = (0.5lf * (_e6464 + (_e6455 / _e6464)));
                            } else {
                                phi_1548_ = f64();
                            }
                            let _e6497 = phi_1548_;
                            continue;
                            continuing {
                                phi_1544_ = _e6487;
                                phi_1547_ = _e6497;
                                break if !(_e6492);
                            }
                        }
                        let _e6502 = local_41;
                        phi_1601_ = (_e6502 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                    }
                    let _e6509 = phi_1601_;
                    let _e6517 = local_19.member[0u];
                    if (_e6517[0] < 0.0lf) {
                        phi_1619_ = -(_e6517[0]);
                    } else {
                        phi_1619_ = _e6517[0];
                    }
                    let _e6524 = phi_1619_;
                    if (_e6517[1] < 0.0lf) {
                        phi_1626_ = -(_e6517[1]);
                    } else {
                        phi_1626_ = _e6517[1];
                    }
                    let _e6528 = phi_1626_;
                    if (_e6524 > _e6528) {
                        phi_1631_ = _e6524;
                    } else {
                        phi_1631_ = _e6528;
                    }
                    let _e6531 = phi_1631_;
                    if (_e6517[2] < 0.0lf) {
                        phi_1638_ = -(_e6517[2]);
                    } else {
                        phi_1638_ = _e6517[2];
                    }
                    let _e6535 = phi_1638_;
                    if (_e6531 > _e6535) {
                        phi_1643_ = _e6531;
                    } else {
                        phi_1643_ = _e6535;
                    }
                    let _e6538 = phi_1643_;
                    let _e6541 = local_19.member[1u];
                    if (_e6541[0] < 0.0lf) {
                        phi_1656_ = -(_e6541[0]);
                    } else {
                        phi_1656_ = _e6541[0];
                    }
                    let _e6548 = phi_1656_;
                    if (_e6541[1] < 0.0lf) {
                        phi_1663_ = -(_e6541[1]);
                    } else {
                        phi_1663_ = _e6541[1];
                    }
                    let _e6552 = phi_1663_;
                    if (_e6548 > _e6552) {
                        phi_1668_ = _e6548;
                    } else {
                        phi_1668_ = _e6552;
                    }
                    let _e6555 = phi_1668_;
                    if (_e6541[2] < 0.0lf) {
                        phi_1675_ = -(_e6541[2]);
                    } else {
                        phi_1675_ = _e6541[2];
                    }
                    let _e6559 = phi_1675_;
                    if (_e6555 > _e6559) {
                        phi_1680_ = _e6555;
                    } else {
                        phi_1680_ = _e6559;
                    }
                    let _e6562 = phi_1680_;
                    if (_e6538 > _e6562) {
                        phi_1685_ = _e6538;
                    } else {
                        phi_1685_ = _e6562;
                    }
                    let _e6565 = phi_1685_;
                    let _e6567 = local_19.member_3;
                    let _e6571 = local_19.member_1[0u];
                    if (_e6571[0] < 0.0lf) {
                        phi_1702_ = -(_e6571[0]);
                    } else {
                        phi_1702_ = _e6571[0];
                    }
                    let _e6578 = phi_1702_;
                    if (_e6571[1] < 0.0lf) {
                        phi_1709_ = -(_e6571[1]);
                    } else {
                        phi_1709_ = _e6571[1];
                    }
                    let _e6582 = phi_1709_;
                    if (_e6578 > _e6582) {
                        phi_1714_ = _e6578;
                    } else {
                        phi_1714_ = _e6582;
                    }
                    let _e6585 = phi_1714_;
                    if (_e6571[2] < 0.0lf) {
                        phi_1721_ = -(_e6571[2]);
                    } else {
                        phi_1721_ = _e6571[2];
                    }
                    let _e6589 = phi_1721_;
                    if (_e6585 > _e6589) {
                        phi_1726_ = _e6585;
                    } else {
                        phi_1726_ = _e6589;
                    }
                    let _e6592 = phi_1726_;
                    let _e6595 = local_19.member_1[1u];
                    if (_e6595[0] < 0.0lf) {
                        phi_1740_ = -(_e6595[0]);
                    } else {
                        phi_1740_ = _e6595[0];
                    }
                    let _e6602 = phi_1740_;
                    if (_e6595[1] < 0.0lf) {
                        phi_1747_ = -(_e6595[1]);
                    } else {
                        phi_1747_ = _e6595[1];
                    }
                    let _e6606 = phi_1747_;
                    if (_e6602 > _e6606) {
                        phi_1752_ = _e6602;
                    } else {
                        phi_1752_ = _e6606;
                    }
                    let _e6609 = phi_1752_;
                    if (_e6595[2] < 0.0lf) {
                        phi_1759_ = -(_e6595[2]);
                    } else {
                        phi_1759_ = _e6595[2];
                    }
                    let _e6613 = phi_1759_;
                    if (_e6609 > _e6613) {
                        phi_1764_ = _e6609;
                    } else {
                        phi_1764_ = _e6613;
                    }
                    let _e6616 = phi_1764_;
                    if (_e6592 > _e6616) {
                        phi_1769_ = _e6592;
                    } else {
                        phi_1769_ = _e6616;
                    }
                    let _e6619 = phi_1769_;
                    let _e6621 = local_19.member_3;
                    let _e6625 = local_19.member_2[0u];
                    if (_e6625[0] < 0.0lf) {
                        phi_1786_ = -(_e6625[0]);
                    } else {
                        phi_1786_ = _e6625[0];
                    }
                    let _e6632 = phi_1786_;
                    if (_e6625[1] < 0.0lf) {
                        phi_1793_ = -(_e6625[1]);
                    } else {
                        phi_1793_ = _e6625[1];
                    }
                    let _e6636 = phi_1793_;
                    if (_e6632 > _e6636) {
                        phi_1798_ = _e6632;
                    } else {
                        phi_1798_ = _e6636;
                    }
                    let _e6639 = phi_1798_;
                    if (_e6625[2] < 0.0lf) {
                        phi_1805_ = -(_e6625[2]);
                    } else {
                        phi_1805_ = _e6625[2];
                    }
                    let _e6643 = phi_1805_;
                    if (_e6639 > _e6643) {
                        phi_1810_ = _e6639;
                    } else {
                        phi_1810_ = _e6643;
                    }
                    let _e6646 = phi_1810_;
                    let _e6649 = local_19.member_2[1u];
                    if (_e6649[0] < 0.0lf) {
                        phi_1824_ = -(_e6649[0]);
                    } else {
                        phi_1824_ = _e6649[0];
                    }
                    let _e6656 = phi_1824_;
                    if (_e6649[1] < 0.0lf) {
                        phi_1831_ = -(_e6649[1]);
                    } else {
                        phi_1831_ = _e6649[1];
                    }
                    let _e6660 = phi_1831_;
                    if (_e6656 > _e6660) {
                        phi_1836_ = _e6656;
                    } else {
                        phi_1836_ = _e6660;
                    }
                    let _e6663 = phi_1836_;
                    if (_e6649[2] < 0.0lf) {
                        phi_1843_ = -(_e6649[2]);
                    } else {
                        phi_1843_ = _e6649[2];
                    }
                    let _e6667 = phi_1843_;
                    if (_e6663 > _e6667) {
                        phi_1848_ = _e6663;
                    } else {
                        phi_1848_ = _e6667;
                    }
                    let _e6670 = phi_1848_;
                    if (_e6646 > _e6670) {
                        phi_1853_ = _e6646;
                    } else {
                        phi_1853_ = _e6670;
                    }
                    let _e6673 = phi_1853_;
                    let _e6675 = local_19.member_3;
                    let _e6683 = local_19.member_3;
                    let _e6693 = (((_e6509 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e6565 + _e6567) + (_e6619 + _e6621)) + (_e6673 + _e6675)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6683 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e851.member_1);
                    if _e6693 {
                        phi_2530_ = type_46();
                        phi_2531_ = true;
                    } else {
                        let _e6696 = local_19.member_1[0u];
                        let _e6702 = local_19.member_2[0u];
                        let _e6708 = ((_e6696[1] * _e6702[2]) - (_e6696[2] * _e6702[1]));
                        let _e6711 = ((_e6696[2] * _e6702[0]) - (_e6696[0] * _e6702[2]));
                        let _e6714 = ((_e6696[0] * _e6702[1]) - (_e6696[1] * _e6702[0]));
                        let _e6717 = local_19.member_1[1u];
                        let _e6723 = local_19.member_2[1u];
                        let _e6729 = ((_e6717[1] * _e6723[2]) - (_e6717[2] * _e6723[1]));
                        let _e6732 = ((_e6717[2] * _e6723[0]) - (_e6717[0] * _e6723[2]));
                        let _e6735 = ((_e6717[0] * _e6723[1]) - (_e6717[1] * _e6723[0]));
                        let _e6738 = local_19.member_1[0u];
                        let _e6744 = local_19.member_2[1u];
                        let _e6759 = local_19.member_1[1u];
                        let _e6765 = local_19.member_2[0u];
                        let _e6778 = (((_e6738[1] * _e6744[2]) - (_e6738[2] * _e6744[1])) + ((_e6759[1] * _e6765[2]) - (_e6759[2] * _e6765[1])));
                        let _e6779 = (((_e6738[2] * _e6744[0]) - (_e6738[0] * _e6744[2])) + ((_e6759[2] * _e6765[0]) - (_e6759[0] * _e6765[2])));
                        let _e6780 = (((_e6738[0] * _e6744[1]) - (_e6738[1] * _e6744[0])) + ((_e6759[0] * _e6765[1]) - (_e6759[1] * _e6765[0])));
                        let _e6783 = local_19.member[0u];
                        let _e6794 = local_19.member[1u];
                        let _e6805 = local_19.member[0u];
                        let _e6814 = ((((_e6794[0] * _e6708) + (_e6794[1] * _e6711)) + (_e6794[2] * _e6714)) + (((_e6805[0] * _e6778) + (_e6805[1] * _e6779)) + (_e6805[2] * _e6780)));
                        let _e6817 = local_19.member[0u];
                        let _e6828 = local_19.member[1u];
                        let _e6837 = ((((_e6817[0] * _e6729) + (_e6817[1] * _e6732)) + (_e6817[2] * _e6735)) + (((_e6828[0] * _e6778) + (_e6828[1] * _e6779)) + (_e6828[2] * _e6780)));
                        let _e6840 = local_19.member[1u];
                        let _e6851 = local_19.member[0u];
                        if (_e6851[0] < 0.0lf) {
                            phi_2118_ = -(_e6851[0]);
                        } else {
                            phi_2118_ = _e6851[0];
                        }
                        let _e6858 = phi_2118_;
                        if (_e6851[1] < 0.0lf) {
                            phi_2125_ = -(_e6851[1]);
                        } else {
                            phi_2125_ = _e6851[1];
                        }
                        let _e6862 = phi_2125_;
                        if (_e6858 > _e6862) {
                            phi_2130_ = _e6858;
                        } else {
                            phi_2130_ = _e6862;
                        }
                        let _e6865 = phi_2130_;
                        if (_e6851[2] < 0.0lf) {
                            phi_2137_ = -(_e6851[2]);
                        } else {
                            phi_2137_ = _e6851[2];
                        }
                        let _e6869 = phi_2137_;
                        if (_e6865 > _e6869) {
                            phi_2142_ = _e6865;
                        } else {
                            phi_2142_ = _e6869;
                        }
                        let _e6872 = phi_2142_;
                        let _e6875 = local_19.member[1u];
                        if (_e6875[0] < 0.0lf) {
                            phi_2155_ = -(_e6875[0]);
                        } else {
                            phi_2155_ = _e6875[0];
                        }
                        let _e6882 = phi_2155_;
                        if (_e6875[1] < 0.0lf) {
                            phi_2162_ = -(_e6875[1]);
                        } else {
                            phi_2162_ = _e6875[1];
                        }
                        let _e6886 = phi_2162_;
                        if (_e6882 > _e6886) {
                            phi_2167_ = _e6882;
                        } else {
                            phi_2167_ = _e6886;
                        }
                        let _e6889 = phi_2167_;
                        if (_e6875[2] < 0.0lf) {
                            phi_2174_ = -(_e6875[2]);
                        } else {
                            phi_2174_ = _e6875[2];
                        }
                        let _e6893 = phi_2174_;
                        if (_e6889 > _e6893) {
                            phi_2179_ = _e6889;
                        } else {
                            phi_2179_ = _e6893;
                        }
                        let _e6896 = phi_2179_;
                        if (_e6872 > _e6896) {
                            phi_2184_ = _e6872;
                        } else {
                            phi_2184_ = _e6896;
                        }
                        let _e6899 = phi_2184_;
                        let _e6901 = local_19.member_3;
                        let _e6902 = (_e6899 + _e6901);
                        let _e6905 = local_19.member_1[0u];
                        if (_e6905[0] < 0.0lf) {
                            phi_2201_ = -(_e6905[0]);
                        } else {
                            phi_2201_ = _e6905[0];
                        }
                        let _e6912 = phi_2201_;
                        if (_e6905[1] < 0.0lf) {
                            phi_2208_ = -(_e6905[1]);
                        } else {
                            phi_2208_ = _e6905[1];
                        }
                        let _e6916 = phi_2208_;
                        if (_e6912 > _e6916) {
                            phi_2213_ = _e6912;
                        } else {
                            phi_2213_ = _e6916;
                        }
                        let _e6919 = phi_2213_;
                        if (_e6905[2] < 0.0lf) {
                            phi_2220_ = -(_e6905[2]);
                        } else {
                            phi_2220_ = _e6905[2];
                        }
                        let _e6923 = phi_2220_;
                        if (_e6919 > _e6923) {
                            phi_2225_ = _e6919;
                        } else {
                            phi_2225_ = _e6923;
                        }
                        let _e6926 = phi_2225_;
                        let _e6929 = local_19.member_1[1u];
                        if (_e6929[0] < 0.0lf) {
                            phi_2239_ = -(_e6929[0]);
                        } else {
                            phi_2239_ = _e6929[0];
                        }
                        let _e6936 = phi_2239_;
                        if (_e6929[1] < 0.0lf) {
                            phi_2246_ = -(_e6929[1]);
                        } else {
                            phi_2246_ = _e6929[1];
                        }
                        let _e6940 = phi_2246_;
                        if (_e6936 > _e6940) {
                            phi_2251_ = _e6936;
                        } else {
                            phi_2251_ = _e6940;
                        }
                        let _e6943 = phi_2251_;
                        if (_e6929[2] < 0.0lf) {
                            phi_2258_ = -(_e6929[2]);
                        } else {
                            phi_2258_ = _e6929[2];
                        }
                        let _e6947 = phi_2258_;
                        if (_e6943 > _e6947) {
                            phi_2263_ = _e6943;
                        } else {
                            phi_2263_ = _e6947;
                        }
                        let _e6950 = phi_2263_;
                        if (_e6926 > _e6950) {
                            phi_2268_ = _e6926;
                        } else {
                            phi_2268_ = _e6950;
                        }
                        let _e6953 = phi_2268_;
                        let _e6955 = local_19.member_3;
                        let _e6956 = (_e6953 + _e6955);
                        let _e6959 = local_19.member_2[0u];
                        if (_e6959[0] < 0.0lf) {
                            phi_2285_ = -(_e6959[0]);
                        } else {
                            phi_2285_ = _e6959[0];
                        }
                        let _e6966 = phi_2285_;
                        if (_e6959[1] < 0.0lf) {
                            phi_2292_ = -(_e6959[1]);
                        } else {
                            phi_2292_ = _e6959[1];
                        }
                        let _e6970 = phi_2292_;
                        if (_e6966 > _e6970) {
                            phi_2297_ = _e6966;
                        } else {
                            phi_2297_ = _e6970;
                        }
                        let _e6973 = phi_2297_;
                        if (_e6959[2] < 0.0lf) {
                            phi_2304_ = -(_e6959[2]);
                        } else {
                            phi_2304_ = _e6959[2];
                        }
                        let _e6977 = phi_2304_;
                        if (_e6973 > _e6977) {
                            phi_2309_ = _e6973;
                        } else {
                            phi_2309_ = _e6977;
                        }
                        let _e6980 = phi_2309_;
                        let _e6983 = local_19.member_2[1u];
                        if (_e6983[0] < 0.0lf) {
                            phi_2323_ = -(_e6983[0]);
                        } else {
                            phi_2323_ = _e6983[0];
                        }
                        let _e6990 = phi_2323_;
                        if (_e6983[1] < 0.0lf) {
                            phi_2330_ = -(_e6983[1]);
                        } else {
                            phi_2330_ = _e6983[1];
                        }
                        let _e6994 = phi_2330_;
                        if (_e6990 > _e6994) {
                            phi_2335_ = _e6990;
                        } else {
                            phi_2335_ = _e6994;
                        }
                        let _e6997 = phi_2335_;
                        if (_e6983[2] < 0.0lf) {
                            phi_2342_ = -(_e6983[2]);
                        } else {
                            phi_2342_ = _e6983[2];
                        }
                        let _e7001 = phi_2342_;
                        if (_e6997 > _e7001) {
                            phi_2347_ = _e6997;
                        } else {
                            phi_2347_ = _e7001;
                        }
                        let _e7004 = phi_2347_;
                        if (_e6980 > _e7004) {
                            phi_2352_ = _e6980;
                        } else {
                            phi_2352_ = _e7004;
                        }
                        let _e7007 = phi_2352_;
                        let _e7009 = local_19.member_3;
                        let _e7010 = (_e7007 + _e7009);
                        let _e7011 = f64(1f);
                        let _e7012 = f64(8f);
                        let _e7014 = ((_e6956 * _e7012) * _e7010);
                        let _e7022 = local_19.member_3;
                        if (_e6708 < 0.0lf) {
                            phi_2389_ = -(_e6708);
                        } else {
                            phi_2389_ = _e6708;
                        }
                        let _e7042 = phi_2389_;
                        if (_e6711 < 0.0lf) {
                            phi_2395_ = -(_e6711);
                        } else {
                            phi_2395_ = _e6711;
                        }
                        let _e7046 = phi_2395_;
                        if (_e6714 < 0.0lf) {
                            phi_2402_ = -(_e6714);
                        } else {
                            phi_2402_ = _e6714;
                        }
                        let _e7051 = phi_2402_;
                        let _e7052 = ((_e7042 + _e7046) + _e7051);
                        if (_e6729 < 0.0lf) {
                            phi_2409_ = -(_e6729);
                        } else {
                            phi_2409_ = _e6729;
                        }
                        let _e7056 = phi_2409_;
                        if (_e6732 < 0.0lf) {
                            phi_2415_ = -(_e6732);
                        } else {
                            phi_2415_ = _e6732;
                        }
                        let _e7060 = phi_2415_;
                        if (_e6735 < 0.0lf) {
                            phi_2422_ = -(_e6735);
                        } else {
                            phi_2422_ = _e6735;
                        }
                        let _e7065 = phi_2422_;
                        let _e7066 = ((_e7056 + _e7060) + _e7065);
                        if (_e7052 > _e7066) {
                            phi_2428_ = _e7052;
                        } else {
                            phi_2428_ = _e7066;
                        }
                        let _e7069 = phi_2428_;
                        if (_e6778 < 0.0lf) {
                            phi_2434_ = -(_e6778);
                        } else {
                            phi_2434_ = _e6778;
                        }
                        let _e7073 = phi_2434_;
                        if (_e6779 < 0.0lf) {
                            phi_2440_ = -(_e6779);
                        } else {
                            phi_2440_ = _e6779;
                        }
                        let _e7077 = phi_2440_;
                        if (_e6780 < 0.0lf) {
                            phi_2447_ = -(_e6780);
                        } else {
                            phi_2447_ = _e6780;
                        }
                        let _e7082 = phi_2447_;
                        let _e7084 = (((_e7073 + _e7077) + _e7082) * f64(0.5f));
                        if (_e7069 > _e7084) {
                            phi_2454_ = _e7069;
                        } else {
                            phi_2454_ = _e7084;
                        }
                        let _e7087 = phi_2454_;
                        let _e7093 = local_19.member_3;
                        let _e7108 = f64(3f);
                        let _e7109 = ((((_e6783[0] * _e6708) + (_e6783[1] * _e6711)) + (_e6783[2] * _e6714)) * _e7108);
                        let _e7110 = ((((_e6840[0] * _e6729) + (_e6840[1] * _e6732)) + (_e6840[2] * _e6735)) * _e7108);
                        if (_e7109 < _e7110) {
                            phi_2482_ = _e7109;
                        } else {
                            phi_2482_ = _e7110;
                        }
                        let _e7113 = phi_2482_;
                        if (_e6814 < _e6837) {
                            phi_2487_ = _e6814;
                        } else {
                            phi_2487_ = _e6837;
                        }
                        let _e7116 = phi_2487_;
                        if (_e7113 < _e7116) {
                            phi_2492_ = _e7113;
                        } else {
                            phi_2492_ = _e7116;
                        }
                        let _e7119 = phi_2492_;
                        if (_e7109 > _e7110) {
                            phi_2497_ = _e7109;
                        } else {
                            phi_2497_ = _e7110;
                        }
                        let _e7122 = phi_2497_;
                        if (_e6814 > _e6837) {
                            phi_2502_ = _e6814;
                        } else {
                            phi_2502_ = _e6837;
                        }
                        let _e7125 = phi_2502_;
                        if (_e7122 > _e7125) {
                            phi_2507_ = _e7122;
                        } else {
                            phi_2507_ = _e7125;
                        }
                        let _e7128 = phi_2507_;
                        let _e7134 = -(_e7128);
                        if (_e7119 > _e7134) {
                            phi_2518_ = _e7119;
                        } else {
                            phi_2518_ = _e7134;
                        }
                        let _e7137 = phi_2518_;
                        if ((_e7137 - ((((((_e6902 * _e7012) * _e7014) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e7022 * f64(19f)) * ((_e6902 * (_e6956 + _e7010)) + (_e6956 * _e7010)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e7011 + _e6902) * ((_e7011 + _e6956) * (_e7011 + _e7010))))) + ((_e851.member_1 * (((_e7087 + (_e7014 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e7093 * f64(6f)) * (_e6956 + _e7010))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e7011 + _e6956) * (_e7011 + _e7010))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                            phi_2528_ = type_46(type_45(0u, f64()), 0u);
                            phi_2529_ = false;
                        } else {
                            phi_2528_ = type_46();
                            phi_2529_ = true;
                        }
                        let _e7144 = phi_2528_;
                        let _e7146 = phi_2529_;
                        phi_2530_ = _e7144;
                        phi_2531_ = _e7146;
                    }
                    let _e7148 = phi_2530_;
                    let _e7150 = phi_2531_;
                    if _e7150 {
                        phi_2537_ = type_18(0i, 2i);
                        phi_2540_ = _e565;
                        phi_2542_ = 0u;
                        phi_2544_ = _e565;
                        loop {
                            let _e7152 = phi_2537_;
                            let _e7154 = phi_2540_;
                            let _e7156 = phi_2542_;
                            let _e7158 = phi_2544_;
                            local_102 = _e7156;
                            local_105 = _e7154;
                            local_106 = _e7156;
                            if (_e7152.member < _e7152.member_1) {
                                let _e7165 = (_e7152.member + 1i);
                                if ((false == (_e7165 > _e7152.member)) != false) {
                                    phi_2565_ = true;
                                } else {
                                    phi_2565_ = false;
                                }
                                let _e7170 = phi_2565_;
                                if _e7170 {
                                    phi_2571_ = type_19(0u, type_19().member_1);
                                } else {
                                    phi_2571_ = type_19(1u, _e7165);
                                }
                                let _e7175 = phi_2571_;
                                phi_2538_ = type_18(_e7175.member_1, _e7152.member_1);
                                phi_2585_ = type_19(1u, _e7152.member);
                            } else {
                                phi_2538_ = _e7152;
                                phi_2585_ = type_19(0u, type_19().member_1);
                            }
                            let _e7181 = phi_2538_;
                            let _e7183 = phi_2585_;
                            if (bitcast<i32>(_e7183.member) != 0i) {
                                if (_e7183.member_1 > 0i) {
                                    phi_2601_ = true;
                                } else {
                                    if _e6693 {
                                        phi_2600_ = false;
                                    } else {
                                        phi_2600_ = true;
                                    }
                                    let _e7190 = phi_2600_;
                                    phi_2601_ = _e7190;
                                }
                                let _e7192 = phi_2601_;
                                if _e7192 {
                                    let _e7195 = local_19.member[0u];
                                    let _e7202 = local_19.member_1[0u];
                                    let _e7208 = local_19.member_2[0u];
                                    let _e7212 = (_e7195[0] - _e7202[0]);
                                    let _e7213 = (_e7195[1] - _e7202[1]);
                                    let _e7214 = (_e7195[2] - _e7202[2]);
                                    if (_e253.member == 0u) {
                                        phi_2660_ = array<f64, 3>(_e7195[0], _e7195[1], _e7195[2]);
                                    } else {
                                        phi_2660_ = array<f64, 3>((_e7212 - _e7208[0]), (_e7213 - _e7208[1]), (_e7214 - _e7208[2]));
                                    }
                                    let _e7221 = phi_2660_;
                                    let _e7227 = local_19.member[1u];
                                    let _e7234 = local_19.member_1[1u];
                                    let _e7240 = local_19.member_2[1u];
                                    let _e7244 = (_e7227[0] - _e7234[0]);
                                    let _e7245 = (_e7227[1] - _e7234[1]);
                                    let _e7246 = (_e7227[2] - _e7234[2]);
                                    if (_e253.member == 0u) {
                                        phi_2725_ = array<f64, 3>(_e7227[0], _e7227[1], _e7227[2]);
                                    } else {
                                        phi_2725_ = array<f64, 3>((_e7244 - _e7240[0]), (_e7245 - _e7240[1]), (_e7246 - _e7240[2]));
                                    }
                                    let _e7253 = phi_2725_;
                                    let _e7259 = local_19.member[0u];
                                    if (_e7259[0] < 0.0lf) {
                                        phi_2747_ = -(_e7259[0]);
                                    } else {
                                        phi_2747_ = _e7259[0];
                                    }
                                    let _e7266 = phi_2747_;
                                    if (_e7259[1] < 0.0lf) {
                                        phi_2754_ = -(_e7259[1]);
                                    } else {
                                        phi_2754_ = _e7259[1];
                                    }
                                    let _e7270 = phi_2754_;
                                    if (_e7266 > _e7270) {
                                        phi_2759_ = _e7266;
                                    } else {
                                        phi_2759_ = _e7270;
                                    }
                                    let _e7273 = phi_2759_;
                                    if (_e7259[2] < 0.0lf) {
                                        phi_2766_ = -(_e7259[2]);
                                    } else {
                                        phi_2766_ = _e7259[2];
                                    }
                                    let _e7277 = phi_2766_;
                                    if (_e7273 > _e7277) {
                                        phi_2771_ = _e7273;
                                    } else {
                                        phi_2771_ = _e7277;
                                    }
                                    let _e7280 = phi_2771_;
                                    let _e7283 = local_19.member[1u];
                                    if (_e7283[0] < 0.0lf) {
                                        phi_2784_ = -(_e7283[0]);
                                    } else {
                                        phi_2784_ = _e7283[0];
                                    }
                                    let _e7290 = phi_2784_;
                                    if (_e7283[1] < 0.0lf) {
                                        phi_2791_ = -(_e7283[1]);
                                    } else {
                                        phi_2791_ = _e7283[1];
                                    }
                                    let _e7294 = phi_2791_;
                                    if (_e7290 > _e7294) {
                                        phi_2796_ = _e7290;
                                    } else {
                                        phi_2796_ = _e7294;
                                    }
                                    let _e7297 = phi_2796_;
                                    if (_e7283[2] < 0.0lf) {
                                        phi_2803_ = -(_e7283[2]);
                                    } else {
                                        phi_2803_ = _e7283[2];
                                    }
                                    let _e7301 = phi_2803_;
                                    if (_e7297 > _e7301) {
                                        phi_2808_ = _e7297;
                                    } else {
                                        phi_2808_ = _e7301;
                                    }
                                    let _e7304 = phi_2808_;
                                    if (_e7280 > _e7304) {
                                        phi_2813_ = _e7280;
                                    } else {
                                        phi_2813_ = _e7304;
                                    }
                                    let _e7307 = phi_2813_;
                                    let _e7309 = local_19.member_3;
                                    let _e7313 = local_19.member_1[0u];
                                    if (_e7313[0] < 0.0lf) {
                                        phi_2830_ = -(_e7313[0]);
                                    } else {
                                        phi_2830_ = _e7313[0];
                                    }
                                    let _e7320 = phi_2830_;
                                    if (_e7313[1] < 0.0lf) {
                                        phi_2837_ = -(_e7313[1]);
                                    } else {
                                        phi_2837_ = _e7313[1];
                                    }
                                    let _e7324 = phi_2837_;
                                    if (_e7320 > _e7324) {
                                        phi_2842_ = _e7320;
                                    } else {
                                        phi_2842_ = _e7324;
                                    }
                                    let _e7327 = phi_2842_;
                                    if (_e7313[2] < 0.0lf) {
                                        phi_2849_ = -(_e7313[2]);
                                    } else {
                                        phi_2849_ = _e7313[2];
                                    }
                                    let _e7331 = phi_2849_;
                                    if (_e7327 > _e7331) {
                                        phi_2854_ = _e7327;
                                    } else {
                                        phi_2854_ = _e7331;
                                    }
                                    let _e7334 = phi_2854_;
                                    let _e7337 = local_19.member_1[1u];
                                    if (_e7337[0] < 0.0lf) {
                                        phi_2868_ = -(_e7337[0]);
                                    } else {
                                        phi_2868_ = _e7337[0];
                                    }
                                    let _e7344 = phi_2868_;
                                    if (_e7337[1] < 0.0lf) {
                                        phi_2875_ = -(_e7337[1]);
                                    } else {
                                        phi_2875_ = _e7337[1];
                                    }
                                    let _e7348 = phi_2875_;
                                    if (_e7344 > _e7348) {
                                        phi_2880_ = _e7344;
                                    } else {
                                        phi_2880_ = _e7348;
                                    }
                                    let _e7351 = phi_2880_;
                                    if (_e7337[2] < 0.0lf) {
                                        phi_2887_ = -(_e7337[2]);
                                    } else {
                                        phi_2887_ = _e7337[2];
                                    }
                                    let _e7355 = phi_2887_;
                                    if (_e7351 > _e7355) {
                                        phi_2892_ = _e7351;
                                    } else {
                                        phi_2892_ = _e7355;
                                    }
                                    let _e7358 = phi_2892_;
                                    if (_e7334 > _e7358) {
                                        phi_2897_ = _e7334;
                                    } else {
                                        phi_2897_ = _e7358;
                                    }
                                    let _e7361 = phi_2897_;
                                    let _e7363 = local_19.member_3;
                                    let _e7367 = local_19.member_2[0u];
                                    if (_e7367[0] < 0.0lf) {
                                        phi_2914_ = -(_e7367[0]);
                                    } else {
                                        phi_2914_ = _e7367[0];
                                    }
                                    let _e7374 = phi_2914_;
                                    if (_e7367[1] < 0.0lf) {
                                        phi_2921_ = -(_e7367[1]);
                                    } else {
                                        phi_2921_ = _e7367[1];
                                    }
                                    let _e7378 = phi_2921_;
                                    if (_e7374 > _e7378) {
                                        phi_2926_ = _e7374;
                                    } else {
                                        phi_2926_ = _e7378;
                                    }
                                    let _e7381 = phi_2926_;
                                    if (_e7367[2] < 0.0lf) {
                                        phi_2933_ = -(_e7367[2]);
                                    } else {
                                        phi_2933_ = _e7367[2];
                                    }
                                    let _e7385 = phi_2933_;
                                    if (_e7381 > _e7385) {
                                        phi_2938_ = _e7381;
                                    } else {
                                        phi_2938_ = _e7385;
                                    }
                                    let _e7388 = phi_2938_;
                                    let _e7391 = local_19.member_2[1u];
                                    if (_e7391[0] < 0.0lf) {
                                        phi_2952_ = -(_e7391[0]);
                                    } else {
                                        phi_2952_ = _e7391[0];
                                    }
                                    let _e7398 = phi_2952_;
                                    if (_e7391[1] < 0.0lf) {
                                        phi_2959_ = -(_e7391[1]);
                                    } else {
                                        phi_2959_ = _e7391[1];
                                    }
                                    let _e7402 = phi_2959_;
                                    if (_e7398 > _e7402) {
                                        phi_2964_ = _e7398;
                                    } else {
                                        phi_2964_ = _e7402;
                                    }
                                    let _e7405 = phi_2964_;
                                    if (_e7391[2] < 0.0lf) {
                                        phi_2971_ = -(_e7391[2]);
                                    } else {
                                        phi_2971_ = _e7391[2];
                                    }
                                    let _e7409 = phi_2971_;
                                    if (_e7405 > _e7409) {
                                        phi_2976_ = _e7405;
                                    } else {
                                        phi_2976_ = _e7409;
                                    }
                                    let _e7412 = phi_2976_;
                                    if (_e7388 > _e7412) {
                                        phi_2981_ = _e7388;
                                    } else {
                                        phi_2981_ = _e7412;
                                    }
                                    let _e7415 = phi_2981_;
                                    let _e7417 = local_19.member_3;
                                    let _e7425 = local_19.member_3;
                                    let _e7433 = (_e556 * f64(0.00390625f));
                                    let _e7434 = f64(0f);
                                    let _e7435 = f64(1f);
                                    local_17 = type_35(array<f64, 4>(_e7434, _e7434, _e7434, _e7434), array<f64, 4>(_e7434, _e7434, _e7434, _e7434), array<f64, 4>(_e7435, _e7435, _e7435, _e7435));
                                    phi_3028_ = type_9(0u, 96u);
                                    phi_3031_ = _e7158;
                                    phi_3033_ = _e7158;
                                    phi_3035_ = (_e574 - _e7158);
                                    phi_3037_ = _e7158;
                                    phi_3039_ = false;
                                    phi_3041_ = 0u;
                                    loop {
                                        let _e7442 = phi_3028_;
                                        let _e7444 = phi_3031_;
                                        let _e7446 = phi_3033_;
                                        let _e7448 = phi_3035_;
                                        let _e7450 = phi_3037_;
                                        let _e7452 = phi_3039_;
                                        let _e7454 = phi_3041_;
                                        local_45 = _e7444;
                                        local_92 = _e7446;
                                        if (_e7442.member < _e7442.member_1) {
                                            phi_3029_ = type_9((_e7442.member + 1u), _e7442.member_1);
                                            phi_3064_ = type_9(1u, _e7442.member);
                                        } else {
                                            phi_3029_ = _e7442;
                                            phi_3064_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e7466 = phi_3029_;
                                        let _e7468 = phi_3064_;
                                        if (bitcast<i32>(_e7468.member) != 0i) {
                                            let _e7474 = local_19.member[0u];
                                            let _e7480 = local_19.member[1u];
                                            let _e7496 = local_19.member_1[0u];
                                            let _e7502 = local_19.member_1[1u];
                                            let _e7518 = local_19.member_2[0u];
                                            let _e7524 = local_19.member_2[1u];
                                            let _e7538 = function_5(array<f64, 3>((_e7474[0] + ((_e7480[0] - _e7474[0]) * _e7444)), (_e7474[1] + ((_e7480[1] - _e7474[1]) * _e7444)), (_e7474[2] + ((_e7480[2] - _e7474[2]) * _e7444))), array<f64, 3>((_e7496[0] + ((_e7502[0] - _e7496[0]) * _e7444)), (_e7496[1] + ((_e7502[1] - _e7496[1]) * _e7444)), (_e7496[2] + ((_e7502[2] - _e7496[2]) * _e7444))), array<f64, 3>((_e7518[0] + ((_e7524[0] - _e7518[0]) * _e7444)), (_e7518[1] + ((_e7524[1] - _e7518[1]) * _e7444)), (_e7518[2] + ((_e7524[2] - _e7518[2]) * _e7444))), _e253.member);
                                            if (_e7454 == 0u) {
                                                phi_3193_ = _e7538;
                                            } else {
                                                let _e7540 = f64(0f);
                                                if (_e7454 == 1u) {
                                                    phi_3179_ = _e7538[0];
                                                } else {
                                                    phi_3179_ = _e7540;
                                                }
                                                let _e7544 = phi_3179_;
                                                if (_e7454 == 2u) {
                                                    phi_3185_ = _e7538[1];
                                                } else {
                                                    phi_3185_ = _e7540;
                                                }
                                                let _e7548 = phi_3185_;
                                                if (_e7454 == 3u) {
                                                    phi_3191_ = _e7538[2];
                                                } else {
                                                    phi_3191_ = _e7540;
                                                }
                                                let _e7552 = phi_3191_;
                                                phi_3193_ = array<f64, 3>(_e7544, _e7548, _e7552);
                                            }
                                            let _e7555 = phi_3193_;
                                            if (_e7555[0] < 0.0lf) {
                                                phi_3200_ = -(_e7555[0]);
                                            } else {
                                                phi_3200_ = _e7555[0];
                                            }
                                            let _e7560 = phi_3200_;
                                            if (_e7555[1] < 0.0lf) {
                                                phi_3207_ = -(_e7555[1]);
                                            } else {
                                                phi_3207_ = _e7555[1];
                                            }
                                            let _e7565 = phi_3207_;
                                            if (_e7555[2] < 0.0lf) {
                                                phi_3215_ = -(_e7555[2]);
                                            } else {
                                                phi_3215_ = _e7555[2];
                                            }
                                            let _e7571 = phi_3215_;
                                            let _e7572 = ((_e7560 + _e7565) + _e7571);
                                            if (_e7572 > f64(0f)) {
                                                if ((bitcast<u64>(_e7572) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                    let _e7579 = (f64(1f) / _e7572);
                                                    let _e7581 = (_e7555[0] * _e7579);
                                                    let _e7583 = (_e7555[1] * _e7579);
                                                    let _e7585 = (_e7555[2] * _e7579);
                                                    let _e7590 = (((_e7581 * _e7581) + (_e7583 * _e7583)) + (_e7585 * _e7585));
                                                    if (_e7590 <= 2.2250738585072014e-308lf) {
                                                        if (_e7590 > 0.0lf) {
                                                            phi_3254_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_3254_ = 0.0lf;
                                                        }
                                                        let _e7642 = phi_3254_;
                                                        phi_3318_ = _e7642;
                                                    } else {
                                                        phi_3261_ = type_18(0i, 5i);
                                                        phi_3264_ = bitcast<f64>(((bitcast<u64>(_e7590) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e7597 = phi_3261_;
                                                            let _e7599 = phi_3264_;
                                                            local_42 = _e7599;
                                                            if (_e7597.member < _e7597.member_1) {
                                                                let _e7606 = (_e7597.member + 1i);
                                                                if ((false == (_e7606 > _e7597.member)) != false) {
                                                                    phi_3285_ = true;
                                                                } else {
                                                                    phi_3285_ = false;
                                                                }
                                                                let _e7611 = phi_3285_;
                                                                if _e7611 {
                                                                    phi_3291_ = type_19(0u, type_19().member_1);
                                                                } else {
                                                                    phi_3291_ = type_19(1u, _e7606);
                                                                }
                                                                let _e7616 = phi_3291_;
                                                                phi_3262_ = type_18(_e7616.member_1, _e7597.member_1);
                                                                phi_3305_ = type_19(1u, _e7597.member);
                                                            } else {
                                                                phi_3262_ = _e7597;
                                                                phi_3305_ = type_19(0u, type_19().member_1);
                                                            }
                                                            let _e7622 = phi_3262_;
                                                            let _e7624 = phi_3305_;
                                                            let _e7627 = (bitcast<i32>(_e7624.member) != 0i);
                                                            if _e7627 {
                                                                phi_3265_ = (0.5lf * (_e7599 + (_e7590 / _e7599)));
                                                            } else {
                                                                phi_3265_ = f64();
                                                            }
                                                            let _e7632 = phi_3265_;
                                                            continue;
                                                            continuing {
                                                                phi_3261_ = _e7622;
                                                                phi_3264_ = _e7632;
                                                                break if !(_e7627);
                                                            }
                                                        }
                                                        let _e7637 = local_42;
                                                        phi_3318_ = (_e7637 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e7644 = phi_3318_;
                                                    let _e7646 = (1.1102230246251565e-16lf * f64(12f));
                                                    let _e7653 = ((((((((_e7307 + _e7309) + (_e7361 + _e7363)) + (_e7415 + _e7417)) * (1.1102230246251565e-16lf * f64(16f))) + (_e7425 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e851.member_1 * _e7644) * (f64(1f) + _e7646)));
                                                    let _e7658 = (((_e7581 * _e7195[0]) + (_e7583 * _e7195[1])) + (_e7585 * _e7195[2]));
                                                    let _e7663 = (((_e7581 * _e7212) + (_e7583 * _e7213)) + (_e7585 * _e7214));
                                                    let _e7668 = (((_e7581 * (_e7195[0] - _e7208[0])) + (_e7583 * (_e7195[1] - _e7208[1]))) + (_e7585 * (_e7195[2] - _e7208[2])));
                                                    let _e7676 = (((_e7581 * _e7221[0]) + (_e7583 * _e7221[1])) + (_e7585 * _e7221[2]));
                                                    let _e7682 = (((_e7581 * _e7227[0]) + (_e7583 * _e7227[1])) + (_e7585 * _e7227[2]));
                                                    let _e7687 = (((_e7581 * _e7244) + (_e7583 * _e7245)) + (_e7585 * _e7246));
                                                    let _e7692 = (((_e7581 * (_e7227[0] - _e7240[0])) + (_e7583 * (_e7227[1] - _e7240[1]))) + (_e7585 * (_e7227[2] - _e7240[2])));
                                                    let _e7700 = (((_e7581 * _e7253[0]) + (_e7583 * _e7253[1])) + (_e7585 * _e7253[2]));
                                                    if (_e7658 < 0.0lf) {
                                                        phi_3387_ = -(_e7658);
                                                    } else {
                                                        phi_3387_ = _e7658;
                                                    }
                                                    let _e7705 = phi_3387_;
                                                    if (_e7682 < 0.0lf) {
                                                        phi_3393_ = -(_e7682);
                                                    } else {
                                                        phi_3393_ = _e7682;
                                                    }
                                                    let _e7709 = phi_3393_;
                                                    if (_e7663 < 0.0lf) {
                                                        phi_3402_ = -(_e7663);
                                                    } else {
                                                        phi_3402_ = _e7663;
                                                    }
                                                    let _e7716 = phi_3402_;
                                                    if (_e7687 < 0.0lf) {
                                                        phi_3408_ = -(_e7687);
                                                    } else {
                                                        phi_3408_ = _e7687;
                                                    }
                                                    let _e7720 = phi_3408_;
                                                    if (_e7668 < 0.0lf) {
                                                        phi_3417_ = -(_e7668);
                                                    } else {
                                                        phi_3417_ = _e7668;
                                                    }
                                                    let _e7727 = phi_3417_;
                                                    if (_e7692 < 0.0lf) {
                                                        phi_3423_ = -(_e7692);
                                                    } else {
                                                        phi_3423_ = _e7692;
                                                    }
                                                    let _e7731 = phi_3423_;
                                                    if (_e7676 < 0.0lf) {
                                                        phi_3432_ = -(_e7676);
                                                    } else {
                                                        phi_3432_ = _e7676;
                                                    }
                                                    let _e7738 = phi_3432_;
                                                    if (_e7700 < 0.0lf) {
                                                        phi_3438_ = -(_e7700);
                                                    } else {
                                                        phi_3438_ = _e7700;
                                                    }
                                                    let _e7742 = phi_3438_;
                                                    phi_3444_ = type_35(array<f64, 4>(_e7658, _e7663, _e7668, _e7676), array<f64, 4>(_e7682, _e7687, _e7692, _e7700), array<f64, 4>((_e7653 + ((_e7705 + _e7709) * _e7646)), (_e7653 + ((_e7716 + _e7720) * _e7646)), (_e7653 + ((_e7727 + _e7731) * _e7646)), (_e7653 + ((_e7738 + _e7742) * _e7646))));
                                                    phi_3445_ = false;
                                                } else {
                                                    phi_3444_ = type_35();
                                                    phi_3445_ = true;
                                                }
                                                let _e7749 = phi_3444_;
                                                let _e7751 = phi_3445_;
                                                phi_3446_ = _e7749;
                                                phi_3447_ = _e7751;
                                            } else {
                                                phi_3446_ = type_35();
                                                phi_3447_ = true;
                                            }
                                            let _e7753 = phi_3446_;
                                            let _e7755 = phi_3447_;
                                            if _e7755 {
                                                let _e7756 = f64(0f);
                                                let _e7757 = f64(1f);
                                                phi_3457_ = type_35(array<f64, 4>(_e7756, _e7756, _e7756, _e7756), array<f64, 4>(_e7756, _e7756, _e7756, _e7756), array<f64, 4>(_e7757, _e7757, _e7757, _e7757));
                                            } else {
                                                phi_3457_ = _e7753;
                                            }
                                            let _e7763 = phi_3457_;
                                            local_18 = type_35(array<f64, 4>(_e7763.member[0], _e7763.member[1], _e7763.member[2], _e7763.member[3]), array<f64, 4>(_e7763.member_1[0], _e7763.member_1[1], _e7763.member_1[2], _e7763.member_1[3]), array<f64, 4>(_e7763.member_2[0], _e7763.member_2[1], _e7763.member_2[2], _e7763.member_2[3]));
                                            let _e7783 = (_e7444 - _e7450);
                                            let _e7785 = f64(0f);
                                            let _e7788 = local_18.member[0u];
                                            let _e7791 = local_18.member_1[0u];
                                            let _e7794 = local_18.member[0u];
                                            let _e7800 = local_18.member_2[0u];
                                            if (((_e7788 + ((_e7791 - _e7794) * _e7444)) - _e7800) > _e7785) {
                                                let _e7805 = local_18.member[1u];
                                                let _e7808 = local_18.member_1[1u];
                                                let _e7811 = local_18.member[1u];
                                                let _e7817 = local_18.member_2[1u];
                                                if (((_e7805 + ((_e7808 - _e7811) * _e7444)) - _e7817) > _e7785) {
                                                    let _e7822 = local_18.member[2u];
                                                    let _e7825 = local_18.member_1[2u];
                                                    let _e7828 = local_18.member[2u];
                                                    let _e7834 = local_18.member_2[2u];
                                                    if (((_e7822 + ((_e7825 - _e7828) * _e7444)) - _e7834) > _e7785) {
                                                        let _e7839 = local_18.member[3u];
                                                        let _e7842 = local_18.member_1[3u];
                                                        let _e7845 = local_18.member[3u];
                                                        let _e7851 = local_18.member_2[3u];
                                                        phi_3629_ = (((_e7839 + ((_e7842 - _e7845) * _e7444)) - _e7851) > _e7785);
                                                        phi_3630_ = false;
                                                    } else {
                                                        phi_3629_ = bool();
                                                        phi_3630_ = true;
                                                    }
                                                    let _e7855 = phi_3629_;
                                                    let _e7857 = phi_3630_;
                                                    phi_3631_ = _e7855;
                                                    phi_3632_ = _e7857;
                                                } else {
                                                    phi_3631_ = bool();
                                                    phi_3632_ = true;
                                                }
                                                let _e7859 = phi_3631_;
                                                let _e7861 = phi_3632_;
                                                phi_3633_ = _e7859;
                                                phi_3634_ = _e7861;
                                            } else {
                                                phi_3633_ = bool();
                                                phi_3634_ = true;
                                            }
                                            let _e7863 = phi_3633_;
                                            let _e7865 = phi_3634_;
                                            if _e7865 {
                                                phi_3638_ = false;
                                            } else {
                                                phi_3638_ = _e7863;
                                            }
                                            let _e7867 = phi_3638_;
                                            if _e7867 {
                                                if (_e7444 <= _e7446) {
                                                    phi_3949_ = true;
                                                } else {
                                                    let _e7869 = f64(0f);
                                                    let _e7872 = local_17.member[0u];
                                                    let _e7875 = local_17.member_1[0u];
                                                    let _e7878 = local_17.member[0u];
                                                    let _e7884 = local_17.member_2[0u];
                                                    let _e7888 = local_18.member[0u];
                                                    let _e7891 = local_18.member_1[0u];
                                                    let _e7894 = local_18.member[0u];
                                                    let _e7900 = local_18.member_2[0u];
                                                    if ((((_e7872 + ((_e7875 - _e7878) * _e7444)) - _e7884) + ((_e7888 + ((_e7891 - _e7894) * _e7450)) - _e7900)) > _e7869) {
                                                        let _e7906 = local_17.member[1u];
                                                        let _e7909 = local_17.member_1[1u];
                                                        let _e7912 = local_17.member[1u];
                                                        let _e7918 = local_17.member_2[1u];
                                                        let _e7922 = local_18.member[1u];
                                                        let _e7925 = local_18.member_1[1u];
                                                        let _e7928 = local_18.member[1u];
                                                        let _e7934 = local_18.member_2[1u];
                                                        if ((((_e7906 + ((_e7909 - _e7912) * _e7444)) - _e7918) + ((_e7922 + ((_e7925 - _e7928) * _e7450)) - _e7934)) > _e7869) {
                                                            let _e7940 = local_17.member[2u];
                                                            let _e7943 = local_17.member_1[2u];
                                                            let _e7946 = local_17.member[2u];
                                                            let _e7952 = local_17.member_2[2u];
                                                            let _e7956 = local_18.member[2u];
                                                            let _e7959 = local_18.member_1[2u];
                                                            let _e7962 = local_18.member[2u];
                                                            let _e7968 = local_18.member_2[2u];
                                                            if ((((_e7940 + ((_e7943 - _e7946) * _e7444)) - _e7952) + ((_e7956 + ((_e7959 - _e7962) * _e7450)) - _e7968)) > _e7869) {
                                                                let _e7974 = local_17.member[3u];
                                                                let _e7977 = local_17.member_1[3u];
                                                                let _e7980 = local_17.member[3u];
                                                                let _e7986 = local_17.member_2[3u];
                                                                let _e7990 = local_18.member[3u];
                                                                let _e7993 = local_18.member_1[3u];
                                                                let _e7996 = local_18.member[3u];
                                                                let _e8002 = local_18.member_2[3u];
                                                                phi_3936_ = ((((_e7974 + ((_e7977 - _e7980) * _e7444)) - _e7986) + ((_e7990 + ((_e7993 - _e7996) * _e7450)) - _e8002)) > _e7869);
                                                                phi_3937_ = false;
                                                            } else {
                                                                phi_3936_ = bool();
                                                                phi_3937_ = true;
                                                            }
                                                            let _e8007 = phi_3936_;
                                                            let _e8009 = phi_3937_;
                                                            phi_3938_ = _e8007;
                                                            phi_3939_ = _e8009;
                                                        } else {
                                                            phi_3938_ = bool();
                                                            phi_3939_ = true;
                                                        }
                                                        let _e8011 = phi_3938_;
                                                        let _e8013 = phi_3939_;
                                                        phi_3940_ = _e8011;
                                                        phi_3941_ = _e8013;
                                                    } else {
                                                        phi_3940_ = bool();
                                                        phi_3941_ = true;
                                                    }
                                                    let _e8015 = phi_3940_;
                                                    let _e8017 = phi_3941_;
                                                    if _e8017 {
                                                        phi_3945_ = false;
                                                    } else {
                                                        phi_3945_ = _e8015;
                                                    }
                                                    let _e8019 = phi_3945_;
                                                    phi_3949_ = _e8019;
                                                }
                                                let _e8021 = phi_3949_;
                                                if _e8021 {
                                                    if _e7452 {
                                                        if (_e7444 >= _e574) {
                                                            phi_3960_ = false;
                                                        } else {
                                                            phi_3960_ = true;
                                                        }
                                                        let _e8024 = phi_3960_;
                                                        phi_3961_ = _e8024;
                                                    } else {
                                                        phi_3961_ = true;
                                                    }
                                                    let _e8026 = phi_3961_;
                                                    if _e8026 {
                                                        local_17 = type_35(array<f64, 4>(_e7763.member[0], _e7763.member[1], _e7763.member[2], _e7763.member[3]), array<f64, 4>(_e7763.member_1[0], _e7763.member_1[1], _e7763.member_1[2], _e7763.member_1[3]), array<f64, 4>(_e7763.member_2[0], _e7763.member_2[1], _e7763.member_2[2], _e7763.member_2[3]));
                                                        let _e8048 = local_17.member[0u];
                                                        let _e8051 = local_17.member_1[0u];
                                                        let _e8054 = local_17.member_2[0u];
                                                        if (_e8048 > _e8054) {
                                                            if (_e8051 > _e8054) {
                                                                phi_4035_ = false;
                                                            } else {
                                                                phi_4035_ = true;
                                                            }
                                                            let _e8058 = phi_4035_;
                                                            phi_4036_ = _e8058;
                                                        } else {
                                                            phi_4036_ = true;
                                                        }
                                                        let _e8060 = phi_4036_;
                                                        if _e8060 {
                                                            let _e8061 = (_e8051 >= _e8048);
                                                            if _e8061 {
                                                                phi_4061_ = f64();
                                                                phi_4062_ = false;
                                                            } else {
                                                                if ((_e8048 - _e8051) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4059_ = (((_e8048 - _e8054) / (_e8048 - _e8051)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4060_ = false;
                                                                } else {
                                                                    phi_4059_ = f64();
                                                                    phi_4060_ = true;
                                                                }
                                                                let _e8075 = phi_4059_;
                                                                let _e8077 = phi_4060_;
                                                                phi_4061_ = _e8075;
                                                                phi_4062_ = _e8077;
                                                            }
                                                            let _e8079 = phi_4061_;
                                                            let _e8081 = phi_4062_;
                                                            phi_4063_ = _e8079;
                                                            phi_4064_ = _e8061;
                                                            phi_4065_ = _e8081;
                                                        } else {
                                                            phi_4063_ = f64();
                                                            phi_4064_ = true;
                                                            phi_4065_ = false;
                                                        }
                                                        let _e8083 = phi_4063_;
                                                        let _e8085 = phi_4064_;
                                                        let _e8087 = phi_4065_;
                                                        if _e8085 {
                                                            phi_4070_ = f64(2f);
                                                            phi_4071_ = true;
                                                        } else {
                                                            phi_4070_ = _e7444;
                                                            phi_4071_ = _e8087;
                                                        }
                                                        let _e8090 = phi_4070_;
                                                        let _e8092 = phi_4071_;
                                                        if _e8092 {
                                                            phi_4075_ = _e8090;
                                                        } else {
                                                            phi_4075_ = _e8083;
                                                        }
                                                        let _e8094 = phi_4075_;
                                                        let _e8097 = local_17.member[1u];
                                                        let _e8100 = local_17.member_1[1u];
                                                        let _e8103 = local_17.member_2[1u];
                                                        if (_e8097 > _e8103) {
                                                            if (_e8100 > _e8103) {
                                                                phi_4107_ = false;
                                                            } else {
                                                                phi_4107_ = true;
                                                            }
                                                            let _e8107 = phi_4107_;
                                                            phi_4108_ = _e8107;
                                                        } else {
                                                            phi_4108_ = true;
                                                        }
                                                        let _e8109 = phi_4108_;
                                                        if _e8109 {
                                                            let _e8110 = (_e8100 >= _e8097);
                                                            if _e8110 {
                                                                phi_4133_ = f64();
                                                                phi_4134_ = false;
                                                            } else {
                                                                if ((_e8097 - _e8100) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4131_ = (((_e8097 - _e8103) / (_e8097 - _e8100)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4132_ = false;
                                                                } else {
                                                                    phi_4131_ = f64();
                                                                    phi_4132_ = true;
                                                                }
                                                                let _e8124 = phi_4131_;
                                                                let _e8126 = phi_4132_;
                                                                phi_4133_ = _e8124;
                                                                phi_4134_ = _e8126;
                                                            }
                                                            let _e8128 = phi_4133_;
                                                            let _e8130 = phi_4134_;
                                                            phi_4135_ = _e8128;
                                                            phi_4136_ = _e8110;
                                                            phi_4137_ = _e8130;
                                                        } else {
                                                            phi_4135_ = f64();
                                                            phi_4136_ = true;
                                                            phi_4137_ = false;
                                                        }
                                                        let _e8132 = phi_4135_;
                                                        let _e8134 = phi_4136_;
                                                        let _e8136 = phi_4137_;
                                                        if _e8134 {
                                                            phi_4142_ = f64(2f);
                                                            phi_4143_ = true;
                                                        } else {
                                                            phi_4142_ = _e7444;
                                                            phi_4143_ = _e8136;
                                                        }
                                                        let _e8139 = phi_4142_;
                                                        let _e8141 = phi_4143_;
                                                        if _e8141 {
                                                            phi_4147_ = _e8139;
                                                        } else {
                                                            phi_4147_ = _e8132;
                                                        }
                                                        let _e8143 = phi_4147_;
                                                        if (_e8094 < _e8143) {
                                                            phi_4152_ = _e8094;
                                                        } else {
                                                            phi_4152_ = _e8143;
                                                        }
                                                        let _e8146 = phi_4152_;
                                                        let _e8149 = local_17.member[2u];
                                                        let _e8152 = local_17.member_1[2u];
                                                        let _e8155 = local_17.member_2[2u];
                                                        if (_e8149 > _e8155) {
                                                            if (_e8152 > _e8155) {
                                                                phi_4184_ = false;
                                                            } else {
                                                                phi_4184_ = true;
                                                            }
                                                            let _e8159 = phi_4184_;
                                                            phi_4185_ = _e8159;
                                                        } else {
                                                            phi_4185_ = true;
                                                        }
                                                        let _e8161 = phi_4185_;
                                                        if _e8161 {
                                                            let _e8162 = (_e8152 >= _e8149);
                                                            if _e8162 {
                                                                phi_4210_ = f64();
                                                                phi_4211_ = false;
                                                            } else {
                                                                if ((_e8149 - _e8152) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4208_ = (((_e8149 - _e8155) / (_e8149 - _e8152)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4209_ = false;
                                                                } else {
                                                                    phi_4208_ = f64();
                                                                    phi_4209_ = true;
                                                                }
                                                                let _e8176 = phi_4208_;
                                                                let _e8178 = phi_4209_;
                                                                phi_4210_ = _e8176;
                                                                phi_4211_ = _e8178;
                                                            }
                                                            let _e8180 = phi_4210_;
                                                            let _e8182 = phi_4211_;
                                                            phi_4212_ = _e8180;
                                                            phi_4213_ = _e8162;
                                                            phi_4214_ = _e8182;
                                                        } else {
                                                            phi_4212_ = f64();
                                                            phi_4213_ = true;
                                                            phi_4214_ = false;
                                                        }
                                                        let _e8184 = phi_4212_;
                                                        let _e8186 = phi_4213_;
                                                        let _e8188 = phi_4214_;
                                                        if _e8186 {
                                                            phi_4219_ = f64(2f);
                                                            phi_4220_ = true;
                                                        } else {
                                                            phi_4219_ = _e7444;
                                                            phi_4220_ = _e8188;
                                                        }
                                                        let _e8191 = phi_4219_;
                                                        let _e8193 = phi_4220_;
                                                        if _e8193 {
                                                            phi_4224_ = _e8191;
                                                        } else {
                                                            phi_4224_ = _e8184;
                                                        }
                                                        let _e8195 = phi_4224_;
                                                        let _e8198 = local_17.member[3u];
                                                        let _e8201 = local_17.member_1[3u];
                                                        let _e8204 = local_17.member_2[3u];
                                                        if (_e8198 > _e8204) {
                                                            if (_e8201 > _e8204) {
                                                                phi_4256_ = false;
                                                            } else {
                                                                phi_4256_ = true;
                                                            }
                                                            let _e8208 = phi_4256_;
                                                            phi_4257_ = _e8208;
                                                        } else {
                                                            phi_4257_ = true;
                                                        }
                                                        let _e8210 = phi_4257_;
                                                        if _e8210 {
                                                            let _e8211 = (_e8201 >= _e8198);
                                                            if _e8211 {
                                                                phi_4282_ = f64();
                                                                phi_4283_ = false;
                                                            } else {
                                                                if ((_e8198 - _e8201) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4280_ = (((_e8198 - _e8204) / (_e8198 - _e8201)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4281_ = false;
                                                                } else {
                                                                    phi_4280_ = f64();
                                                                    phi_4281_ = true;
                                                                }
                                                                let _e8225 = phi_4280_;
                                                                let _e8227 = phi_4281_;
                                                                phi_4282_ = _e8225;
                                                                phi_4283_ = _e8227;
                                                            }
                                                            let _e8229 = phi_4282_;
                                                            let _e8231 = phi_4283_;
                                                            phi_4284_ = _e8229;
                                                            phi_4285_ = _e8211;
                                                            phi_4286_ = _e8231;
                                                        } else {
                                                            phi_4284_ = f64();
                                                            phi_4285_ = true;
                                                            phi_4286_ = false;
                                                        }
                                                        let _e8233 = phi_4284_;
                                                        let _e8235 = phi_4285_;
                                                        let _e8237 = phi_4286_;
                                                        if _e8235 {
                                                            phi_4291_ = f64(2f);
                                                            phi_4292_ = true;
                                                        } else {
                                                            phi_4291_ = _e7444;
                                                            phi_4292_ = _e8237;
                                                        }
                                                        let _e8240 = phi_4291_;
                                                        let _e8242 = phi_4292_;
                                                        if _e8242 {
                                                            phi_4296_ = _e8240;
                                                        } else {
                                                            phi_4296_ = _e8233;
                                                        }
                                                        let _e8244 = phi_4296_;
                                                        if (_e8195 < _e8244) {
                                                            phi_4301_ = _e8195;
                                                        } else {
                                                            phi_4301_ = _e8244;
                                                        }
                                                        let _e8247 = phi_4301_;
                                                        if (_e8146 < _e8247) {
                                                            phi_4306_ = _e8146;
                                                        } else {
                                                            phi_4306_ = _e8247;
                                                        }
                                                        let _e8250 = phi_4306_;
                                                        if (_e8250 > _e7444) {
                                                            phi_4311_ = _e8250;
                                                        } else {
                                                            phi_4311_ = _e7444;
                                                        }
                                                        let _e8253 = phi_4311_;
                                                        let _e8254 = (_e8253 > _e574);
                                                        if _e8254 {
                                                            phi_4828_ = f64();
                                                            phi_4829_ = f64();
                                                            phi_4830_ = false;
                                                            phi_4831_ = false;
                                                        } else {
                                                            let _e8255 = (_e8253 - _e7444);
                                                            let _e8256 = (_e8255 <= _e7433);
                                                            let _e8259 = (_e8253 + (_e556 * f64(0.01f)));
                                                            if (_e8259 < _e574) {
                                                                phi_4325_ = _e8259;
                                                            } else {
                                                                phi_4325_ = _e574;
                                                            }
                                                            let _e8262 = phi_4325_;
                                                            if _e8256 {
                                                                if (_e851.member_1 > f64(0f)) {
                                                                    let _e8267 = local_19.member[0u];
                                                                    let _e8273 = local_19.member[1u];
                                                                    let _e8289 = local_19.member_1[0u];
                                                                    let _e8295 = local_19.member_1[1u];
                                                                    let _e8311 = local_19.member_2[0u];
                                                                    let _e8317 = local_19.member_2[1u];
                                                                    let _e8331 = function_5(array<f64, 3>((_e8267[0] + ((_e8273[0] - _e8267[0]) * _e8262)), (_e8267[1] + ((_e8273[1] - _e8267[1]) * _e8262)), (_e8267[2] + ((_e8273[2] - _e8267[2]) * _e8262))), array<f64, 3>((_e8289[0] + ((_e8295[0] - _e8289[0]) * _e8262)), (_e8289[1] + ((_e8295[1] - _e8289[1]) * _e8262)), (_e8289[2] + ((_e8295[2] - _e8289[2]) * _e8262))), array<f64, 3>((_e8311[0] + ((_e8317[0] - _e8311[0]) * _e8262)), (_e8311[1] + ((_e8317[1] - _e8311[1]) * _e8262)), (_e8311[2] + ((_e8317[2] - _e8311[2]) * _e8262))), _e253.member);
                                                                    let _e8342 = (((_e8331[0] * _e8331[0]) + (_e8331[1] * _e8331[1])) + (_e8331[2] * _e8331[2]));
                                                                    if (_e8342 <= 2.2250738585072014e-308lf) {
                                                                        if (_e8342 > 0.0lf) {
                                                                            phi_4456_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_4456_ = 0.0lf;
                                                                        }
                                                                        let _e8394 = phi_4456_;
                                                                        phi_4520_ = _e8394;
                                                                    } else {
                                                                        phi_4463_ = type_18(0i, 5i);
                                                                        phi_4466_ = bitcast<f64>(((bitcast<u64>(_e8342) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e8349 = phi_4463_;
                                                                            let _e8351 = phi_4466_;
                                                                            local_43 = _e8351;
                                                                            if (_e8349.member < _e8349.member_1) {
                                                                                let _e8358 = (_e8349.member + 1i);
                                                                                if ((false == (_e8358 > _e8349.member)) != false) {
                                                                                    phi_4487_ = true;
                                                                                } else {
                                                                                    phi_4487_ = false;
                                                                                }
                                                                                let _e8363 = phi_4487_;
                                                                                if _e8363 {
                                                                                    phi_4493_ = type_19(0u, type_19().member_1);
                                                                                } else {
                                                                                    phi_4493_ = type_19(1u, _e8358);
                                                                                }
                                                                                let _e8368 = phi_4493_;
                                                                                phi_4464_ = type_18(_e8368.member_1, _e8349.member_1);
                                                                                phi_4507_ = type_19(1u, _e8349.member);
                                                                            } else {
                                                                                phi_4464_ = _e8349;
                                                                                phi_4507_ = type_19(0u, type_19().member_1);
                                                                            }
                                                                            let _e8374 = phi_4464_;
                                                                            let _e8376 = phi_4507_;
                                                                            let _e8379 = (bitcast<i32>(_e8376.member) != 0i);
                                                                            if _e8379 {
                                                                                phi_4467_ = (0.5lf * (_e8351 + (_e8342 / _e8351)));
                                                                            } else {
                                                                                phi_4467_ = f64();
                                                                            }
                                                                            let _e8384 = phi_4467_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4463_ = _e8374;
                                                                                phi_4466_ = _e8384;
                                                                                break if !(_e8379);
                                                                            }
                                                                        }
                                                                        let _e8389 = local_43;
                                                                        phi_4520_ = (_e8389 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e8396 = phi_4520_;
                                                                    let _e8404 = local_19.member[0u];
                                                                    if (_e8404[0] < 0.0lf) {
                                                                        phi_4538_ = -(_e8404[0]);
                                                                    } else {
                                                                        phi_4538_ = _e8404[0];
                                                                    }
                                                                    let _e8411 = phi_4538_;
                                                                    if (_e8404[1] < 0.0lf) {
                                                                        phi_4545_ = -(_e8404[1]);
                                                                    } else {
                                                                        phi_4545_ = _e8404[1];
                                                                    }
                                                                    let _e8415 = phi_4545_;
                                                                    if (_e8411 > _e8415) {
                                                                        phi_4550_ = _e8411;
                                                                    } else {
                                                                        phi_4550_ = _e8415;
                                                                    }
                                                                    let _e8418 = phi_4550_;
                                                                    if (_e8404[2] < 0.0lf) {
                                                                        phi_4557_ = -(_e8404[2]);
                                                                    } else {
                                                                        phi_4557_ = _e8404[2];
                                                                    }
                                                                    let _e8422 = phi_4557_;
                                                                    if (_e8418 > _e8422) {
                                                                        phi_4562_ = _e8418;
                                                                    } else {
                                                                        phi_4562_ = _e8422;
                                                                    }
                                                                    let _e8425 = phi_4562_;
                                                                    let _e8428 = local_19.member[1u];
                                                                    if (_e8428[0] < 0.0lf) {
                                                                        phi_4575_ = -(_e8428[0]);
                                                                    } else {
                                                                        phi_4575_ = _e8428[0];
                                                                    }
                                                                    let _e8435 = phi_4575_;
                                                                    if (_e8428[1] < 0.0lf) {
                                                                        phi_4582_ = -(_e8428[1]);
                                                                    } else {
                                                                        phi_4582_ = _e8428[1];
                                                                    }
                                                                    let _e8439 = phi_4582_;
                                                                    if (_e8435 > _e8439) {
                                                                        phi_4587_ = _e8435;
                                                                    } else {
                                                                        phi_4587_ = _e8439;
                                                                    }
                                                                    let _e8442 = phi_4587_;
                                                                    if (_e8428[2] < 0.0lf) {
                                                                        phi_4594_ = -(_e8428[2]);
                                                                    } else {
                                                                        phi_4594_ = _e8428[2];
                                                                    }
                                                                    let _e8446 = phi_4594_;
                                                                    if (_e8442 > _e8446) {
                                                                        phi_4599_ = _e8442;
                                                                    } else {
                                                                        phi_4599_ = _e8446;
                                                                    }
                                                                    let _e8449 = phi_4599_;
                                                                    if (_e8425 > _e8449) {
                                                                        phi_4604_ = _e8425;
                                                                    } else {
                                                                        phi_4604_ = _e8449;
                                                                    }
                                                                    let _e8452 = phi_4604_;
                                                                    let _e8454 = local_19.member_3;
                                                                    let _e8458 = local_19.member_1[0u];
                                                                    if (_e8458[0] < 0.0lf) {
                                                                        phi_4621_ = -(_e8458[0]);
                                                                    } else {
                                                                        phi_4621_ = _e8458[0];
                                                                    }
                                                                    let _e8465 = phi_4621_;
                                                                    if (_e8458[1] < 0.0lf) {
                                                                        phi_4628_ = -(_e8458[1]);
                                                                    } else {
                                                                        phi_4628_ = _e8458[1];
                                                                    }
                                                                    let _e8469 = phi_4628_;
                                                                    if (_e8465 > _e8469) {
                                                                        phi_4633_ = _e8465;
                                                                    } else {
                                                                        phi_4633_ = _e8469;
                                                                    }
                                                                    let _e8472 = phi_4633_;
                                                                    if (_e8458[2] < 0.0lf) {
                                                                        phi_4640_ = -(_e8458[2]);
                                                                    } else {
                                                                        phi_4640_ = _e8458[2];
                                                                    }
                                                                    let _e8476 = phi_4640_;
                                                                    if (_e8472 > _e8476) {
                                                                        phi_4645_ = _e8472;
                                                                    } else {
                                                                        phi_4645_ = _e8476;
                                                                    }
                                                                    let _e8479 = phi_4645_;
                                                                    let _e8482 = local_19.member_1[1u];
                                                                    if (_e8482[0] < 0.0lf) {
                                                                        phi_4659_ = -(_e8482[0]);
                                                                    } else {
                                                                        phi_4659_ = _e8482[0];
                                                                    }
                                                                    let _e8489 = phi_4659_;
                                                                    if (_e8482[1] < 0.0lf) {
                                                                        phi_4666_ = -(_e8482[1]);
                                                                    } else {
                                                                        phi_4666_ = _e8482[1];
                                                                    }
                                                                    let _e8493 = phi_4666_;
                                                                    if (_e8489 > _e8493) {
                                                                        phi_4671_ = _e8489;
                                                                    } else {
                                                                        phi_4671_ = _e8493;
                                                                    }
                                                                    let _e8496 = phi_4671_;
                                                                    if (_e8482[2] < 0.0lf) {
                                                                        phi_4678_ = -(_e8482[2]);
                                                                    } else {
                                                                        phi_4678_ = _e8482[2];
                                                                    }
                                                                    let _e8500 = phi_4678_;
                                                                    if (_e8496 > _e8500) {
                                                                        phi_4683_ = _e8496;
                                                                    } else {
                                                                        phi_4683_ = _e8500;
                                                                    }
                                                                    let _e8503 = phi_4683_;
                                                                    if (_e8479 > _e8503) {
                                                                        phi_4688_ = _e8479;
                                                                    } else {
                                                                        phi_4688_ = _e8503;
                                                                    }
                                                                    let _e8506 = phi_4688_;
                                                                    let _e8508 = local_19.member_3;
                                                                    let _e8512 = local_19.member_2[0u];
                                                                    if (_e8512[0] < 0.0lf) {
                                                                        phi_4705_ = -(_e8512[0]);
                                                                    } else {
                                                                        phi_4705_ = _e8512[0];
                                                                    }
                                                                    let _e8519 = phi_4705_;
                                                                    if (_e8512[1] < 0.0lf) {
                                                                        phi_4712_ = -(_e8512[1]);
                                                                    } else {
                                                                        phi_4712_ = _e8512[1];
                                                                    }
                                                                    let _e8523 = phi_4712_;
                                                                    if (_e8519 > _e8523) {
                                                                        phi_4717_ = _e8519;
                                                                    } else {
                                                                        phi_4717_ = _e8523;
                                                                    }
                                                                    let _e8526 = phi_4717_;
                                                                    if (_e8512[2] < 0.0lf) {
                                                                        phi_4724_ = -(_e8512[2]);
                                                                    } else {
                                                                        phi_4724_ = _e8512[2];
                                                                    }
                                                                    let _e8530 = phi_4724_;
                                                                    if (_e8526 > _e8530) {
                                                                        phi_4729_ = _e8526;
                                                                    } else {
                                                                        phi_4729_ = _e8530;
                                                                    }
                                                                    let _e8533 = phi_4729_;
                                                                    let _e8536 = local_19.member_2[1u];
                                                                    if (_e8536[0] < 0.0lf) {
                                                                        phi_4743_ = -(_e8536[0]);
                                                                    } else {
                                                                        phi_4743_ = _e8536[0];
                                                                    }
                                                                    let _e8543 = phi_4743_;
                                                                    if (_e8536[1] < 0.0lf) {
                                                                        phi_4750_ = -(_e8536[1]);
                                                                    } else {
                                                                        phi_4750_ = _e8536[1];
                                                                    }
                                                                    let _e8547 = phi_4750_;
                                                                    if (_e8543 > _e8547) {
                                                                        phi_4755_ = _e8543;
                                                                    } else {
                                                                        phi_4755_ = _e8547;
                                                                    }
                                                                    let _e8550 = phi_4755_;
                                                                    if (_e8536[2] < 0.0lf) {
                                                                        phi_4762_ = -(_e8536[2]);
                                                                    } else {
                                                                        phi_4762_ = _e8536[2];
                                                                    }
                                                                    let _e8554 = phi_4762_;
                                                                    if (_e8550 > _e8554) {
                                                                        phi_4767_ = _e8550;
                                                                    } else {
                                                                        phi_4767_ = _e8554;
                                                                    }
                                                                    let _e8557 = phi_4767_;
                                                                    if (_e8533 > _e8557) {
                                                                        phi_4772_ = _e8533;
                                                                    } else {
                                                                        phi_4772_ = _e8557;
                                                                    }
                                                                    let _e8560 = phi_4772_;
                                                                    let _e8562 = local_19.member_3;
                                                                    let _e8570 = local_19.member_3;
                                                                    if (((_e8396 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e8452 + _e8454) + (_e8506 + _e8508)) + (_e8560 + _e8562)) * (1.1102230246251565e-16lf * f64(16f))) + (_e8570 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e851.member_1) {
                                                                        phi_4796_ = false;
                                                                    } else {
                                                                        phi_4796_ = true;
                                                                    }
                                                                    let _e8582 = phi_4796_;
                                                                    phi_4797_ = _e8582;
                                                                } else {
                                                                    phi_4797_ = true;
                                                                }
                                                                let _e8584 = phi_4797_;
                                                                phi_4798_ = _e8584;
                                                            } else {
                                                                phi_4798_ = true;
                                                            }
                                                            let _e8586 = phi_4798_;
                                                            if _e8586 {
                                                                if _e7452 {
                                                                    if _e8256 {
                                                                        phi_4817_ = f64();
                                                                        phi_4818_ = true;
                                                                    } else {
                                                                        if (_e8255 <= (_e7448 * f64(0.25f))) {
                                                                            phi_4815_ = f64(0f);
                                                                            phi_4816_ = false;
                                                                        } else {
                                                                            phi_4815_ = f64();
                                                                            phi_4816_ = true;
                                                                        }
                                                                        let _e8593 = phi_4815_;
                                                                        let _e8595 = phi_4816_;
                                                                        phi_4817_ = _e8593;
                                                                        phi_4818_ = _e8595;
                                                                    }
                                                                    let _e8597 = phi_4817_;
                                                                    let _e8599 = phi_4818_;
                                                                    if _e8599 {
                                                                        phi_4823_ = (_e7783 + _e7783);
                                                                    } else {
                                                                        phi_4823_ = _e8597;
                                                                    }
                                                                    let _e8602 = phi_4823_;
                                                                    phi_4825_ = _e8602;
                                                                } else {
                                                                    phi_4825_ = (_e574 - _e7444);
                                                                }
                                                                let _e8604 = phi_4825_;
                                                                phi_4826_ = _e8604;
                                                                phi_4827_ = false;
                                                            } else {
                                                                phi_4826_ = f64();
                                                                phi_4827_ = true;
                                                            }
                                                            let _e8606 = phi_4826_;
                                                            let _e8608 = phi_4827_;
                                                            phi_4828_ = _e8606;
                                                            phi_4829_ = _e8255;
                                                            phi_4830_ = _e8586;
                                                            phi_4831_ = _e8608;
                                                        }
                                                        let _e8610 = phi_4828_;
                                                        let _e8612 = phi_4829_;
                                                        let _e8614 = phi_4830_;
                                                        let _e8616 = phi_4831_;
                                                        phi_4832_ = _e8253;
                                                        phi_4833_ = _e8610;
                                                        phi_4834_ = _e8612;
                                                        phi_4835_ = _e8253;
                                                        phi_4836_ = _e8614;
                                                        phi_4837_ = _e8254;
                                                        phi_4838_ = _e8616;
                                                        phi_4839_ = false;
                                                    } else {
                                                        phi_4832_ = f64();
                                                        phi_4833_ = f64();
                                                        phi_4834_ = f64();
                                                        phi_4835_ = f64();
                                                        phi_4836_ = false;
                                                        phi_4837_ = false;
                                                        phi_4838_ = false;
                                                        phi_4839_ = true;
                                                    }
                                                    let _e8618 = phi_4832_;
                                                    let _e8620 = phi_4833_;
                                                    let _e8622 = phi_4834_;
                                                    let _e8624 = phi_4835_;
                                                    let _e8626 = phi_4836_;
                                                    let _e8628 = phi_4837_;
                                                    let _e8630 = phi_4838_;
                                                    let _e8632 = phi_4839_;
                                                    phi_4840_ = _e8618;
                                                    phi_4841_ = _e8620;
                                                    phi_4842_ = _e8622;
                                                    phi_4843_ = _e8624;
                                                    phi_4844_ = false;
                                                    phi_4845_ = _e8626;
                                                    phi_4846_ = _e8628;
                                                    phi_4847_ = _e8630;
                                                    phi_4848_ = _e8632;
                                                } else {
                                                    phi_4840_ = f64();
                                                    phi_4841_ = f64();
                                                    phi_4842_ = f64();
                                                    phi_4843_ = f64();
                                                    phi_4844_ = true;
                                                    phi_4845_ = false;
                                                    phi_4846_ = false;
                                                    phi_4847_ = false;
                                                    phi_4848_ = false;
                                                }
                                                let _e8634 = phi_4840_;
                                                let _e8636 = phi_4841_;
                                                let _e8638 = phi_4842_;
                                                let _e8640 = phi_4843_;
                                                let _e8642 = phi_4844_;
                                                let _e8644 = phi_4845_;
                                                let _e8646 = phi_4846_;
                                                let _e8648 = phi_4847_;
                                                let _e8650 = phi_4848_;
                                                phi_4849_ = _e8634;
                                                phi_4850_ = _e8636;
                                                phi_4851_ = _e8638;
                                                phi_4852_ = _e8640;
                                                phi_4853_ = _e8642;
                                                phi_4854_ = _e8644;
                                                phi_4855_ = _e8646;
                                                phi_4856_ = _e8648;
                                                phi_4857_ = _e8650;
                                            } else {
                                                phi_4849_ = f64();
                                                phi_4850_ = f64();
                                                phi_4851_ = f64();
                                                phi_4852_ = f64();
                                                phi_4853_ = true;
                                                phi_4854_ = false;
                                                phi_4855_ = false;
                                                phi_4856_ = false;
                                                phi_4857_ = false;
                                            }
                                            let _e8652 = phi_4849_;
                                            let _e8654 = phi_4850_;
                                            let _e8656 = phi_4851_;
                                            let _e8658 = phi_4852_;
                                            let _e8660 = phi_4853_;
                                            let _e8662 = phi_4854_;
                                            let _e8664 = phi_4855_;
                                            let _e8666 = phi_4856_;
                                            let _e8668 = phi_4857_;
                                            if _e8660 {
                                                if (_e7444 <= _e7446) {
                                                    let _e8834 = (_e7454 + 1u);
                                                    let _e8835 = (_e8834 > 3u);
                                                    if _e8835 {
                                                        phi_4870_ = false;
                                                    } else {
                                                        phi_4870_ = true;
                                                    }
                                                    let _e8837 = phi_4870_;
                                                    phi_5197_ = _e8834;
                                                    phi_5198_ = f64();
                                                    phi_5199_ = false;
                                                    phi_5200_ = _e8837;
                                                    phi_5201_ = _e8835;
                                                } else {
                                                    let _e8672 = local_17.member[0u];
                                                    let _e8675 = local_17.member_1[0u];
                                                    let _e8678 = local_17.member[0u];
                                                    let _e8684 = local_17.member_2[0u];
                                                    let _e8685 = ((_e8672 + ((_e8675 - _e8678) * _e7450)) - _e8684);
                                                    let _e8688 = local_17.member[1u];
                                                    let _e8691 = local_17.member_1[1u];
                                                    let _e8694 = local_17.member[1u];
                                                    let _e8700 = local_17.member_2[1u];
                                                    let _e8701 = ((_e8688 + ((_e8691 - _e8694) * _e7450)) - _e8700);
                                                    if (_e8685 < _e8701) {
                                                        phi_4943_ = _e8685;
                                                    } else {
                                                        phi_4943_ = _e8701;
                                                    }
                                                    let _e8704 = phi_4943_;
                                                    let _e8707 = local_17.member[2u];
                                                    let _e8710 = local_17.member_1[2u];
                                                    let _e8713 = local_17.member[2u];
                                                    let _e8719 = local_17.member_2[2u];
                                                    let _e8720 = ((_e8707 + ((_e8710 - _e8713) * _e7450)) - _e8719);
                                                    let _e8723 = local_17.member[3u];
                                                    let _e8726 = local_17.member_1[3u];
                                                    let _e8729 = local_17.member[3u];
                                                    let _e8735 = local_17.member_2[3u];
                                                    let _e8736 = ((_e8723 + ((_e8726 - _e8729) * _e7450)) - _e8735);
                                                    if (_e8720 < _e8736) {
                                                        phi_5016_ = _e8720;
                                                    } else {
                                                        phi_5016_ = _e8736;
                                                    }
                                                    let _e8739 = phi_5016_;
                                                    if (_e8704 < _e8739) {
                                                        phi_5021_ = _e8704;
                                                    } else {
                                                        phi_5021_ = _e8739;
                                                    }
                                                    let _e8742 = phi_5021_;
                                                    let _e8745 = local_18.member[0u];
                                                    let _e8748 = local_18.member_1[0u];
                                                    let _e8751 = local_18.member[0u];
                                                    let _e8757 = local_18.member_2[0u];
                                                    let _e8758 = ((_e8745 + ((_e8748 - _e8751) * _e7444)) - _e8757);
                                                    let _e8761 = local_18.member[1u];
                                                    let _e8764 = local_18.member_1[1u];
                                                    let _e8767 = local_18.member[1u];
                                                    let _e8773 = local_18.member_2[1u];
                                                    let _e8774 = ((_e8761 + ((_e8764 - _e8767) * _e7444)) - _e8773);
                                                    if (_e8758 < _e8774) {
                                                        phi_5094_ = _e8758;
                                                    } else {
                                                        phi_5094_ = _e8774;
                                                    }
                                                    let _e8777 = phi_5094_;
                                                    let _e8780 = local_18.member[2u];
                                                    let _e8783 = local_18.member_1[2u];
                                                    let _e8786 = local_18.member[2u];
                                                    let _e8792 = local_18.member_2[2u];
                                                    let _e8793 = ((_e8780 + ((_e8783 - _e8786) * _e7444)) - _e8792);
                                                    let _e8796 = local_18.member[3u];
                                                    let _e8799 = local_18.member_1[3u];
                                                    let _e8802 = local_18.member[3u];
                                                    let _e8808 = local_18.member_2[3u];
                                                    let _e8809 = ((_e8796 + ((_e8799 - _e8802) * _e7444)) - _e8808);
                                                    if (_e8793 < _e8809) {
                                                        phi_5167_ = _e8793;
                                                    } else {
                                                        phi_5167_ = _e8809;
                                                    }
                                                    let _e8812 = phi_5167_;
                                                    if (_e8777 < _e8812) {
                                                        phi_5172_ = _e8777;
                                                    } else {
                                                        phi_5172_ = _e8812;
                                                    }
                                                    let _e8815 = phi_5172_;
                                                    let _e8816 = f64(0.0625f);
                                                    let _e8818 = f64(0.9f);
                                                    if (_e8815 > f64(0f)) {
                                                        phi_5195_ = f64(0.5f);
                                                    } else {
                                                        let _e8824 = (f64(0.95f) * (_e8742 / (_e8742 - _e8815)));
                                                        if (_e8824 > _e8816) {
                                                            if (_e8824 < _e8818) {
                                                                phi_5193_ = _e8824;
                                                            } else {
                                                                phi_5193_ = _e8818;
                                                            }
                                                            let _e8828 = phi_5193_;
                                                            phi_5194_ = _e8828;
                                                        } else {
                                                            phi_5194_ = _e8816;
                                                        }
                                                        let _e8830 = phi_5194_;
                                                        phi_5195_ = _e8830;
                                                    }
                                                    let _e8832 = phi_5195_;
                                                    phi_5197_ = u32();
                                                    phi_5198_ = (_e7783 * _e8832);
                                                    phi_5199_ = true;
                                                    phi_5200_ = false;
                                                    phi_5201_ = false;
                                                }
                                                let _e8839 = phi_5197_;
                                                let _e8841 = phi_5198_;
                                                let _e8843 = phi_5199_;
                                                let _e8845 = phi_5200_;
                                                let _e8847 = phi_5201_;
                                                phi_5202_ = _e8839;
                                                phi_5203_ = _e7446;
                                                phi_5204_ = _e8841;
                                                phi_5205_ = _e7448;
                                                phi_5206_ = _e7450;
                                                phi_5207_ = _e7452;
                                                phi_5208_ = _e7454;
                                                phi_5209_ = _e8843;
                                                phi_5210_ = _e8845;
                                                phi_5211_ = _e8847;
                                                phi_5212_ = false;
                                                phi_5213_ = false;
                                                phi_5214_ = false;
                                            } else {
                                                phi_5202_ = u32();
                                                phi_5203_ = _e8652;
                                                phi_5204_ = _e8654;
                                                phi_5205_ = _e8656;
                                                phi_5206_ = _e7444;
                                                phi_5207_ = true;
                                                phi_5208_ = 0u;
                                                phi_5209_ = _e8662;
                                                phi_5210_ = false;
                                                phi_5211_ = false;
                                                phi_5212_ = _e8664;
                                                phi_5213_ = _e8666;
                                                phi_5214_ = _e8668;
                                            }
                                            let _e8849 = phi_5202_;
                                            let _e8851 = phi_5203_;
                                            let _e8853 = phi_5204_;
                                            let _e8855 = phi_5205_;
                                            let _e8857 = phi_5206_;
                                            let _e8859 = phi_5207_;
                                            let _e8861 = phi_5208_;
                                            let _e8863 = phi_5209_;
                                            let _e8865 = phi_5210_;
                                            let _e8867 = phi_5211_;
                                            let _e8869 = phi_5212_;
                                            let _e8871 = phi_5213_;
                                            let _e8873 = phi_5214_;
                                            if _e8863 {
                                                let _e8874 = (_e8857 + _e8853);
                                                if (_e8874 > _e8851) {
                                                    phi_5223_ = _e8874;
                                                } else {
                                                    phi_5223_ = _e8851;
                                                }
                                                let _e8877 = phi_5223_;
                                                if (_e8877 < _e574) {
                                                    phi_5228_ = _e8877;
                                                } else {
                                                    phi_5228_ = _e574;
                                                }
                                                let _e8880 = phi_5228_;
                                                if !(_e7452) {
                                                    phi_5237_ = true;
                                                } else {
                                                    phi_5237_ = ((_e8880 - _e8857) > _e7433);
                                                }
                                                let _e8884 = phi_5237_;
                                                if _e8884 {
                                                    phi_5241_ = false;
                                                } else {
                                                    phi_5241_ = true;
                                                }
                                                let _e8886 = phi_5241_;
                                                phi_5242_ = _e8880;
                                                phi_5243_ = _e8851;
                                                phi_5244_ = _e8855;
                                                phi_5245_ = _e8857;
                                                phi_5246_ = _e8859;
                                                phi_5247_ = _e8861;
                                                phi_5248_ = _e8884;
                                                phi_5249_ = _e8886;
                                                phi_5250_ = false;
                                                phi_5251_ = false;
                                                phi_5252_ = false;
                                                phi_5253_ = false;
                                            } else {
                                                phi_5242_ = _e7444;
                                                phi_5243_ = _e7446;
                                                phi_5244_ = _e7448;
                                                phi_5245_ = _e7450;
                                                phi_5246_ = _e7452;
                                                phi_5247_ = _e8849;
                                                phi_5248_ = _e8865;
                                                phi_5249_ = false;
                                                phi_5250_ = _e8867;
                                                phi_5251_ = _e8869;
                                                phi_5252_ = _e8871;
                                                phi_5253_ = _e8873;
                                            }
                                            let _e8888 = phi_5242_;
                                            let _e8890 = phi_5243_;
                                            let _e8892 = phi_5244_;
                                            let _e8894 = phi_5245_;
                                            let _e8896 = phi_5246_;
                                            let _e8898 = phi_5247_;
                                            let _e8900 = phi_5248_;
                                            let _e8902 = phi_5249_;
                                            let _e8904 = phi_5250_;
                                            let _e8906 = phi_5251_;
                                            let _e8908 = phi_5252_;
                                            let _e8910 = phi_5253_;
                                            phi_3032_ = _e8888;
                                            phi_3034_ = _e8890;
                                            phi_3036_ = _e8892;
                                            phi_3038_ = _e8894;
                                            phi_3040_ = _e8896;
                                            phi_3042_ = _e8898;
                                            phi_5254_ = _e8851;
                                            phi_5255_ = _e8658;
                                            phi_5256_ = _e8900;
                                            phi_5257_ = _e8902;
                                            phi_5258_ = _e8904;
                                            phi_5259_ = _e8906;
                                            phi_5260_ = _e8908;
                                            phi_5261_ = false;
                                            phi_5262_ = _e8910;
                                        } else {
                                            phi_3032_ = f64();
                                            phi_3034_ = f64();
                                            phi_3036_ = f64();
                                            phi_3038_ = f64();
                                            phi_3040_ = bool();
                                            phi_3042_ = u32();
                                            phi_5254_ = f64();
                                            phi_5255_ = f64();
                                            phi_5256_ = false;
                                            phi_5257_ = false;
                                            phi_5258_ = false;
                                            phi_5259_ = false;
                                            phi_5260_ = false;
                                            phi_5261_ = true;
                                            phi_5262_ = false;
                                        }
                                        let _e8912 = phi_3032_;
                                        let _e8914 = phi_3034_;
                                        let _e8916 = phi_3036_;
                                        let _e8918 = phi_3038_;
                                        let _e8920 = phi_3040_;
                                        let _e8922 = phi_3042_;
                                        let _e8924 = phi_5254_;
                                        let _e8926 = phi_5255_;
                                        let _e8928 = phi_5256_;
                                        let _e8930 = phi_5257_;
                                        let _e8932 = phi_5258_;
                                        let _e8934 = phi_5259_;
                                        let _e8936 = phi_5260_;
                                        let _e8938 = phi_5261_;
                                        let _e8940 = phi_5262_;
                                        local_44 = _e8930;
                                        local_84 = _e8932;
                                        local_85 = _e8934;
                                        local_86 = _e8936;
                                        local_87 = _e8938;
                                        local_88 = _e8940;
                                        local_89 = _e8930;
                                        local_90 = _e8926;
                                        local_91 = _e8924;
                                        continue;
                                        continuing {
                                            phi_3028_ = _e7466;
                                            phi_3031_ = _e8912;
                                            phi_3033_ = _e8914;
                                            phi_3035_ = _e8916;
                                            phi_3037_ = _e8918;
                                            phi_3039_ = _e8920;
                                            phi_3041_ = _e8922;
                                            break if !(_e8928);
                                        }
                                    }
                                    let _e8943 = local_44;
                                    if _e8943 {
                                        phi_5266_ = false;
                                        phi_5267_ = false;
                                        phi_5268_ = false;
                                        phi_5269_ = false;
                                        phi_5270_ = false;
                                    } else {
                                        let _e12518 = local_84;
                                        phi_5266_ = _e12518;
                                        let _e12521 = local_85;
                                        phi_5267_ = _e12521;
                                        let _e12524 = local_86;
                                        phi_5268_ = _e12524;
                                        let _e12527 = local_87;
                                        phi_5269_ = _e12527;
                                        let _e12530 = local_88;
                                        phi_5270_ = _e12530;
                                    }
                                    let _e8945 = phi_5266_;
                                    let _e8947 = phi_5267_;
                                    let _e8949 = phi_5268_;
                                    let _e8951 = phi_5269_;
                                    let _e8953 = phi_5270_;
                                    if _e8945 {
                                        let _e8955 = local_45;
                                        phi_5275_ = type_45(1u, _e8955);
                                        phi_5276_ = false;
                                        phi_5277_ = false;
                                        phi_5278_ = false;
                                        phi_5279_ = false;
                                        phi_5280_ = false;
                                    } else {
                                        phi_5275_ = type_45();
                                        phi_5276_ = _e8947;
                                        phi_5277_ = _e8949;
                                        let _e12537 = local_89;
                                        phi_5278_ = _e12537;
                                        phi_5279_ = _e8951;
                                        phi_5280_ = _e8953;
                                    }
                                    let _e8958 = phi_5275_;
                                    let _e8960 = phi_5276_;
                                    let _e8962 = phi_5277_;
                                    let _e8964 = phi_5278_;
                                    let _e8966 = phi_5279_;
                                    let _e8968 = phi_5280_;
                                    if _e8960 {
                                        phi_5285_ = type_45(0u, type_45().member_1);
                                        phi_5286_ = false;
                                        phi_5287_ = false;
                                        phi_5288_ = false;
                                        phi_5289_ = false;
                                        phi_5290_ = true;
                                    } else {
                                        phi_5285_ = _e8958;
                                        phi_5286_ = _e8962;
                                        phi_5287_ = _e8964;
                                        phi_5288_ = _e8966;
                                        phi_5289_ = _e8968;
                                        phi_5290_ = _e8945;
                                    }
                                    let _e8972 = phi_5285_;
                                    let _e8974 = phi_5286_;
                                    let _e8976 = phi_5287_;
                                    let _e8978 = phi_5288_;
                                    let _e8980 = phi_5289_;
                                    let _e8982 = phi_5290_;
                                    if _e8974 {
                                        let _e12548 = local_90;
                                        phi_5294_ = _e12548;
                                        phi_5295_ = true;
                                        phi_5296_ = false;
                                        phi_5297_ = false;
                                        phi_5298_ = false;
                                    } else {
                                        let _e12550 = local_91;
                                        phi_5294_ = _e12550;
                                        phi_5295_ = _e8976;
                                        phi_5296_ = _e8978;
                                        phi_5297_ = _e8980;
                                        phi_5298_ = _e8982;
                                    }
                                    let _e8984 = phi_5294_;
                                    let _e8986 = phi_5295_;
                                    let _e8988 = phi_5296_;
                                    let _e8990 = phi_5297_;
                                    let _e8992 = phi_5298_;
                                    if _e8986 {
                                        phi_5302_ = _e8984;
                                        phi_5303_ = true;
                                        phi_5304_ = false;
                                        phi_5305_ = false;
                                    } else {
                                        let _e12557 = local_92;
                                        phi_5302_ = _e12557;
                                        phi_5303_ = _e8988;
                                        phi_5304_ = _e8990;
                                        phi_5305_ = _e8992;
                                    }
                                    let _e8994 = phi_5302_;
                                    let _e8996 = phi_5303_;
                                    let _e8998 = phi_5304_;
                                    let _e9000 = phi_5305_;
                                    if _e8996 {
                                        phi_5310_ = type_45(1u, _e8994);
                                        phi_5311_ = false;
                                        phi_5312_ = false;
                                    } else {
                                        phi_5310_ = type_45();
                                        phi_5311_ = _e8998;
                                        phi_5312_ = _e9000;
                                    }
                                    let _e9003 = phi_5310_;
                                    let _e9005 = phi_5311_;
                                    let _e9007 = phi_5312_;
                                    if _e9005 {
                                        phi_5317_ = type_45(0u, type_45().member_1);
                                        phi_5318_ = true;
                                    } else {
                                        phi_5317_ = _e8972;
                                        phi_5318_ = _e9007;
                                    }
                                    let _e9011 = phi_5317_;
                                    let _e9013 = phi_5318_;
                                    if _e9013 {
                                        phi_5322_ = _e9011;
                                    } else {
                                        phi_5322_ = _e9003;
                                    }
                                    let _e9015 = phi_5322_;
                                    phi_5329_ = _e9015.member_1;
                                    phi_5330_ = (_e9015.member != 0u);
                                } else {
                                    phi_5329_ = _e7154;
                                    phi_5330_ = true;
                                }
                                let _e9020 = phi_5329_;
                                let _e9022 = phi_5330_;
                                if _e9022 {
                                    let _e9023 = (_e9020 > _e565);
                                    if _e9023 {
                                        phi_7537_ = f64();
                                        phi_7538_ = u32();
                                        phi_7539_ = f64();
                                        phi_7540_ = type_47();
                                        phi_7541_ = u32();
                                        phi_7542_ = u32();
                                        phi_7543_ = false;
                                        phi_7544_ = false;
                                        phi_7545_ = false;
                                    } else {
                                        let _e9027 = local_19.member[0u];
                                        let _e9033 = local_19.member[1u];
                                        let _e9049 = local_19.member_1[0u];
                                        let _e9055 = local_19.member_1[1u];
                                        let _e9071 = local_19.member_2[0u];
                                        let _e9077 = local_19.member_2[1u];
                                        let _e9091 = function_5(array<f64, 3>((_e9027[0] + ((_e9033[0] - _e9027[0]) * _e7158)), (_e9027[1] + ((_e9033[1] - _e9027[1]) * _e7158)), (_e9027[2] + ((_e9033[2] - _e9027[2]) * _e7158))), array<f64, 3>((_e9049[0] + ((_e9055[0] - _e9049[0]) * _e7158)), (_e9049[1] + ((_e9055[1] - _e9049[1]) * _e7158)), (_e9049[2] + ((_e9055[2] - _e9049[2]) * _e7158))), array<f64, 3>((_e9071[0] + ((_e9077[0] - _e9071[0]) * _e7158)), (_e9071[1] + ((_e9077[1] - _e9071[1]) * _e7158)), (_e9071[2] + ((_e9077[2] - _e9071[2]) * _e7158))), _e253.member);
                                        if (_e9091[0] < 0.0lf) {
                                            phi_5443_ = -(_e9091[0]);
                                        } else {
                                            phi_5443_ = _e9091[0];
                                        }
                                        let _e9096 = phi_5443_;
                                        if (_e9091[1] < 0.0lf) {
                                            phi_5450_ = -(_e9091[1]);
                                        } else {
                                            phi_5450_ = _e9091[1];
                                        }
                                        let _e9101 = phi_5450_;
                                        if (_e9091[2] < 0.0lf) {
                                            phi_5458_ = -(_e9091[2]);
                                        } else {
                                            phi_5458_ = _e9091[2];
                                        }
                                        let _e9107 = phi_5458_;
                                        let _e9108 = ((_e9096 + _e9101) + _e9107);
                                        let _e9111 = local_19.member[0u];
                                        let _e9118 = local_19.member_1[0u];
                                        let _e9124 = local_19.member_2[0u];
                                        let _e9128 = (_e9111[0] - _e9118[0]);
                                        let _e9129 = (_e9111[1] - _e9118[1]);
                                        let _e9130 = (_e9111[2] - _e9118[2]);
                                        if (_e253.member == 0u) {
                                            phi_5516_ = array<f64, 3>(_e9111[0], _e9111[1], _e9111[2]);
                                        } else {
                                            phi_5516_ = array<f64, 3>((_e9128 - _e9124[0]), (_e9129 - _e9124[1]), (_e9130 - _e9124[2]));
                                        }
                                        let _e9137 = phi_5516_;
                                        let _e9143 = local_19.member[1u];
                                        let _e9150 = local_19.member_1[1u];
                                        let _e9156 = local_19.member_2[1u];
                                        let _e9160 = (_e9143[0] - _e9150[0]);
                                        let _e9161 = (_e9143[1] - _e9150[1]);
                                        let _e9162 = (_e9143[2] - _e9150[2]);
                                        if (_e253.member == 0u) {
                                            phi_5584_ = array<f64, 3>(_e9143[0], _e9143[1], _e9143[2]);
                                        } else {
                                            phi_5584_ = array<f64, 3>((_e9160 - _e9156[0]), (_e9161 - _e9156[1]), (_e9162 - _e9156[2]));
                                        }
                                        let _e9169 = phi_5584_;
                                        let _e9175 = local_19.member[0u];
                                        if (_e9175[0] < 0.0lf) {
                                            phi_5609_ = -(_e9175[0]);
                                        } else {
                                            phi_5609_ = _e9175[0];
                                        }
                                        let _e9182 = phi_5609_;
                                        if (_e9175[1] < 0.0lf) {
                                            phi_5616_ = -(_e9175[1]);
                                        } else {
                                            phi_5616_ = _e9175[1];
                                        }
                                        let _e9186 = phi_5616_;
                                        if (_e9182 > _e9186) {
                                            phi_5621_ = _e9182;
                                        } else {
                                            phi_5621_ = _e9186;
                                        }
                                        let _e9189 = phi_5621_;
                                        if (_e9175[2] < 0.0lf) {
                                            phi_5628_ = -(_e9175[2]);
                                        } else {
                                            phi_5628_ = _e9175[2];
                                        }
                                        let _e9193 = phi_5628_;
                                        if (_e9189 > _e9193) {
                                            phi_5633_ = _e9189;
                                        } else {
                                            phi_5633_ = _e9193;
                                        }
                                        let _e9196 = phi_5633_;
                                        let _e9199 = local_19.member[1u];
                                        if (_e9199[0] < 0.0lf) {
                                            phi_5646_ = -(_e9199[0]);
                                        } else {
                                            phi_5646_ = _e9199[0];
                                        }
                                        let _e9206 = phi_5646_;
                                        if (_e9199[1] < 0.0lf) {
                                            phi_5653_ = -(_e9199[1]);
                                        } else {
                                            phi_5653_ = _e9199[1];
                                        }
                                        let _e9210 = phi_5653_;
                                        if (_e9206 > _e9210) {
                                            phi_5658_ = _e9206;
                                        } else {
                                            phi_5658_ = _e9210;
                                        }
                                        let _e9213 = phi_5658_;
                                        if (_e9199[2] < 0.0lf) {
                                            phi_5665_ = -(_e9199[2]);
                                        } else {
                                            phi_5665_ = _e9199[2];
                                        }
                                        let _e9217 = phi_5665_;
                                        if (_e9213 > _e9217) {
                                            phi_5670_ = _e9213;
                                        } else {
                                            phi_5670_ = _e9217;
                                        }
                                        let _e9220 = phi_5670_;
                                        if (_e9196 > _e9220) {
                                            phi_5675_ = _e9196;
                                        } else {
                                            phi_5675_ = _e9220;
                                        }
                                        let _e9223 = phi_5675_;
                                        let _e9225 = local_19.member_3;
                                        let _e9229 = local_19.member_1[0u];
                                        if (_e9229[0] < 0.0lf) {
                                            phi_5692_ = -(_e9229[0]);
                                        } else {
                                            phi_5692_ = _e9229[0];
                                        }
                                        let _e9236 = phi_5692_;
                                        if (_e9229[1] < 0.0lf) {
                                            phi_5699_ = -(_e9229[1]);
                                        } else {
                                            phi_5699_ = _e9229[1];
                                        }
                                        let _e9240 = phi_5699_;
                                        if (_e9236 > _e9240) {
                                            phi_5704_ = _e9236;
                                        } else {
                                            phi_5704_ = _e9240;
                                        }
                                        let _e9243 = phi_5704_;
                                        if (_e9229[2] < 0.0lf) {
                                            phi_5711_ = -(_e9229[2]);
                                        } else {
                                            phi_5711_ = _e9229[2];
                                        }
                                        let _e9247 = phi_5711_;
                                        if (_e9243 > _e9247) {
                                            phi_5716_ = _e9243;
                                        } else {
                                            phi_5716_ = _e9247;
                                        }
                                        let _e9250 = phi_5716_;
                                        let _e9253 = local_19.member_1[1u];
                                        if (_e9253[0] < 0.0lf) {
                                            phi_5730_ = -(_e9253[0]);
                                        } else {
                                            phi_5730_ = _e9253[0];
                                        }
                                        let _e9260 = phi_5730_;
                                        if (_e9253[1] < 0.0lf) {
                                            phi_5737_ = -(_e9253[1]);
                                        } else {
                                            phi_5737_ = _e9253[1];
                                        }
                                        let _e9264 = phi_5737_;
                                        if (_e9260 > _e9264) {
                                            phi_5742_ = _e9260;
                                        } else {
                                            phi_5742_ = _e9264;
                                        }
                                        let _e9267 = phi_5742_;
                                        if (_e9253[2] < 0.0lf) {
                                            phi_5749_ = -(_e9253[2]);
                                        } else {
                                            phi_5749_ = _e9253[2];
                                        }
                                        let _e9271 = phi_5749_;
                                        if (_e9267 > _e9271) {
                                            phi_5754_ = _e9267;
                                        } else {
                                            phi_5754_ = _e9271;
                                        }
                                        let _e9274 = phi_5754_;
                                        if (_e9250 > _e9274) {
                                            phi_5759_ = _e9250;
                                        } else {
                                            phi_5759_ = _e9274;
                                        }
                                        let _e9277 = phi_5759_;
                                        let _e9279 = local_19.member_3;
                                        let _e9283 = local_19.member_2[0u];
                                        if (_e9283[0] < 0.0lf) {
                                            phi_5776_ = -(_e9283[0]);
                                        } else {
                                            phi_5776_ = _e9283[0];
                                        }
                                        let _e9290 = phi_5776_;
                                        if (_e9283[1] < 0.0lf) {
                                            phi_5783_ = -(_e9283[1]);
                                        } else {
                                            phi_5783_ = _e9283[1];
                                        }
                                        let _e9294 = phi_5783_;
                                        if (_e9290 > _e9294) {
                                            phi_5788_ = _e9290;
                                        } else {
                                            phi_5788_ = _e9294;
                                        }
                                        let _e9297 = phi_5788_;
                                        if (_e9283[2] < 0.0lf) {
                                            phi_5795_ = -(_e9283[2]);
                                        } else {
                                            phi_5795_ = _e9283[2];
                                        }
                                        let _e9301 = phi_5795_;
                                        if (_e9297 > _e9301) {
                                            phi_5800_ = _e9297;
                                        } else {
                                            phi_5800_ = _e9301;
                                        }
                                        let _e9304 = phi_5800_;
                                        let _e9307 = local_19.member_2[1u];
                                        if (_e9307[0] < 0.0lf) {
                                            phi_5814_ = -(_e9307[0]);
                                        } else {
                                            phi_5814_ = _e9307[0];
                                        }
                                        let _e9314 = phi_5814_;
                                        if (_e9307[1] < 0.0lf) {
                                            phi_5821_ = -(_e9307[1]);
                                        } else {
                                            phi_5821_ = _e9307[1];
                                        }
                                        let _e9318 = phi_5821_;
                                        if (_e9314 > _e9318) {
                                            phi_5826_ = _e9314;
                                        } else {
                                            phi_5826_ = _e9318;
                                        }
                                        let _e9321 = phi_5826_;
                                        if (_e9307[2] < 0.0lf) {
                                            phi_5833_ = -(_e9307[2]);
                                        } else {
                                            phi_5833_ = _e9307[2];
                                        }
                                        let _e9325 = phi_5833_;
                                        if (_e9321 > _e9325) {
                                            phi_5838_ = _e9321;
                                        } else {
                                            phi_5838_ = _e9325;
                                        }
                                        let _e9328 = phi_5838_;
                                        if (_e9304 > _e9328) {
                                            phi_5843_ = _e9304;
                                        } else {
                                            phi_5843_ = _e9328;
                                        }
                                        let _e9331 = phi_5843_;
                                        let _e9333 = local_19.member_3;
                                        let _e9341 = local_19.member_3;
                                        local_15 = type_43(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e9111, array<f64, 3>(_e9128, _e9129, _e9130), array<f64, 3>((_e9111[0] - _e9124[0]), (_e9111[1] - _e9124[1]), (_e9111[2] - _e9124[2])), array<f64, 3>(_e9137[0], _e9137[1], _e9137[2])), array<array<f64, 3>, 4>(_e9143, array<f64, 3>(_e9160, _e9161, _e9162), array<f64, 3>((_e9143[0] - _e9156[0]), (_e9143[1] - _e9156[1]), (_e9143[2] - _e9156[2])), array<f64, 3>(_e9169[0], _e9169[1], _e9169[2]))), ((((((_e9223 + _e9225) + (_e9277 + _e9279)) + (_e9331 + _e9333)) * (1.1102230246251565e-16lf * f64(16f))) + (_e9341 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e851.member_1);
                                        let _e9365 = local_15.member_1;
                                        if (_e9108 > _e9365) {
                                            if ((bitcast<u64>(_e9108) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e9371 = (f64(1f) / _e9108);
                                                let _e9373 = (_e9091[0] * _e9371);
                                                let _e9375 = (_e9091[1] * _e9371);
                                                let _e9377 = (_e9091[2] * _e9371);
                                                let _e9382 = (((_e9373 * _e9373) + (_e9375 * _e9375)) + (_e9377 * _e9377));
                                                if (_e9382 <= 2.2250738585072014e-308lf) {
                                                    if (_e9382 > 0.0lf) {
                                                        phi_5948_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_5948_ = 0.0lf;
                                                    }
                                                    let _e9434 = phi_5948_;
                                                    phi_6012_ = _e9434;
                                                } else {
                                                    phi_5955_ = type_18(0i, 5i);
                                                    phi_5958_ = bitcast<f64>(((bitcast<u64>(_e9382) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9389 = phi_5955_;
                                                        let _e9391 = phi_5958_;
                                                        local_46 = _e9391;
                                                        if (_e9389.member < _e9389.member_1) {
                                                            let _e9398 = (_e9389.member + 1i);
                                                            if ((false == (_e9398 > _e9389.member)) != false) {
                                                                phi_5979_ = true;
                                                            } else {
                                                                phi_5979_ = false;
                                                            }
                                                            let _e9403 = phi_5979_;
                                                            if _e9403 {
                                                                phi_5985_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_5985_ = type_19(1u, _e9398);
                                                            }
                                                            let _e9408 = phi_5985_;
                                                            phi_5956_ = type_18(_e9408.member_1, _e9389.member_1);
                                                            phi_5999_ = type_19(1u, _e9389.member);
                                                        } else {
                                                            phi_5956_ = _e9389;
                                                            phi_5999_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e9414 = phi_5956_;
                                                        let _e9416 = phi_5999_;
                                                        let _e9419 = (bitcast<i32>(_e9416.member) != 0i);
                                                        if _e9419 {
                                                            phi_5959_ = (0.5lf * (_e9391 + (_e9382 / _e9391)));
                                                        } else {
                                                            phi_5959_ = f64();
                                                        }
                                                        let _e9424 = phi_5959_;
                                                        continue;
                                                        continuing {
                                                            phi_5955_ = _e9414;
                                                            phi_5958_ = _e9424;
                                                            break if !(_e9419);
                                                        }
                                                    }
                                                    let _e9429 = local_46;
                                                    phi_6012_ = (_e9429 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9436 = phi_6012_;
                                                let _e9438 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e9440 = local_15.member_1;
                                                let _e9444 = local_15.member_2;
                                                let _e9449 = ((_e9440 * f64(1.01f)) + ((_e9444 * _e9436) * (f64(1f) + _e9438)));
                                                let _e9453 = local_15.member[0u][0u];
                                                let _e9461 = (((_e9373 * _e9453[0]) + (_e9375 * _e9453[1])) + (_e9377 * _e9453[2]));
                                                let _e9465 = local_15.member[0u][1u];
                                                let _e9473 = (((_e9373 * _e9465[0]) + (_e9375 * _e9465[1])) + (_e9377 * _e9465[2]));
                                                let _e9477 = local_15.member[0u][2u];
                                                let _e9485 = (((_e9373 * _e9477[0]) + (_e9375 * _e9477[1])) + (_e9377 * _e9477[2]));
                                                let _e9489 = local_15.member[0u][3u];
                                                let _e9497 = (((_e9373 * _e9489[0]) + (_e9375 * _e9489[1])) + (_e9377 * _e9489[2]));
                                                let _e9501 = local_15.member[1u][0u];
                                                let _e9509 = (((_e9373 * _e9501[0]) + (_e9375 * _e9501[1])) + (_e9377 * _e9501[2]));
                                                let _e9513 = local_15.member[1u][1u];
                                                let _e9521 = (((_e9373 * _e9513[0]) + (_e9375 * _e9513[1])) + (_e9377 * _e9513[2]));
                                                let _e9525 = local_15.member[1u][2u];
                                                let _e9533 = (((_e9373 * _e9525[0]) + (_e9375 * _e9525[1])) + (_e9377 * _e9525[2]));
                                                let _e9537 = local_15.member[1u][3u];
                                                let _e9545 = (((_e9373 * _e9537[0]) + (_e9375 * _e9537[1])) + (_e9377 * _e9537[2]));
                                                if (_e9461 < 0.0lf) {
                                                    phi_6149_ = -(_e9461);
                                                } else {
                                                    phi_6149_ = _e9461;
                                                }
                                                let _e9549 = phi_6149_;
                                                if (_e9509 < 0.0lf) {
                                                    phi_6155_ = -(_e9509);
                                                } else {
                                                    phi_6155_ = _e9509;
                                                }
                                                let _e9553 = phi_6155_;
                                                if (_e9473 < 0.0lf) {
                                                    phi_6164_ = -(_e9473);
                                                } else {
                                                    phi_6164_ = _e9473;
                                                }
                                                let _e9560 = phi_6164_;
                                                if (_e9521 < 0.0lf) {
                                                    phi_6170_ = -(_e9521);
                                                } else {
                                                    phi_6170_ = _e9521;
                                                }
                                                let _e9564 = phi_6170_;
                                                if (_e9485 < 0.0lf) {
                                                    phi_6179_ = -(_e9485);
                                                } else {
                                                    phi_6179_ = _e9485;
                                                }
                                                let _e9571 = phi_6179_;
                                                if (_e9533 < 0.0lf) {
                                                    phi_6185_ = -(_e9533);
                                                } else {
                                                    phi_6185_ = _e9533;
                                                }
                                                let _e9575 = phi_6185_;
                                                if (_e9497 < 0.0lf) {
                                                    phi_6194_ = -(_e9497);
                                                } else {
                                                    phi_6194_ = _e9497;
                                                }
                                                let _e9582 = phi_6194_;
                                                if (_e9545 < 0.0lf) {
                                                    phi_6200_ = -(_e9545);
                                                } else {
                                                    phi_6200_ = _e9545;
                                                }
                                                let _e9586 = phi_6200_;
                                                local_16 = type_35(array<f64, 4>(_e9461, _e9473, _e9485, _e9497), array<f64, 4>(_e9509, _e9521, _e9533, _e9545), array<f64, 4>((_e9449 + ((_e9549 + _e9553) * _e9438)), (_e9449 + ((_e9560 + _e9564) * _e9438)), (_e9449 + ((_e9571 + _e9575) * _e9438)), (_e9449 + ((_e9582 + _e9586) * _e9438))));
                                                let _e9598 = (((_e9373 * _e9373) + (_e9375 * _e9375)) + (_e9377 * _e9377));
                                                if (_e9598 <= 2.2250738585072014e-308lf) {
                                                    if (_e9598 > 0.0lf) {
                                                        phi_6243_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6243_ = 0.0lf;
                                                    }
                                                    let _e9650 = phi_6243_;
                                                    phi_6307_ = _e9650;
                                                } else {
                                                    phi_6250_ = type_18(0i, 5i);
                                                    phi_6253_ = bitcast<f64>(((bitcast<u64>(_e9598) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9605 = phi_6250_;
                                                        let _e9607 = phi_6253_;
                                                        local_47 = _e9607;
                                                        if (_e9605.member < _e9605.member_1) {
                                                            let _e9614 = (_e9605.member + 1i);
                                                            if ((false == (_e9614 > _e9605.member)) != false) {
                                                                phi_6274_ = true;
                                                            } else {
                                                                phi_6274_ = false;
                                                            }
                                                            let _e9619 = phi_6274_;
                                                            if _e9619 {
                                                                phi_6280_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_6280_ = type_19(1u, _e9614);
                                                            }
                                                            let _e9624 = phi_6280_;
                                                            phi_6251_ = type_18(_e9624.member_1, _e9605.member_1);
                                                            phi_6294_ = type_19(1u, _e9605.member);
                                                        } else {
                                                            phi_6251_ = _e9605;
                                                            phi_6294_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e9630 = phi_6251_;
                                                        let _e9632 = phi_6294_;
                                                        let _e9635 = (bitcast<i32>(_e9632.member) != 0i);
                                                        if _e9635 {
                                                            phi_6254_ = (0.5lf * (_e9607 + (_e9598 / _e9607)));
                                                        } else {
                                                            phi_6254_ = f64();
                                                        }
                                                        let _e9640 = phi_6254_;
                                                        continue;
                                                        continuing {
                                                            phi_6250_ = _e9630;
                                                            phi_6253_ = _e9640;
                                                            break if !(_e9635);
                                                        }
                                                    }
                                                    let _e9645 = local_47;
                                                    phi_6307_ = (_e9645 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9652 = phi_6307_;
                                                let _e9663 = (((_e9091[0] * _e9091[0]) + (_e9091[1] * _e9091[1])) + (_e9091[2] * _e9091[2]));
                                                if (_e9663 <= 2.2250738585072014e-308lf) {
                                                    if (_e9663 > 0.0lf) {
                                                        phi_6332_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6332_ = 0.0lf;
                                                    }
                                                    let _e9715 = phi_6332_;
                                                    phi_6396_ = _e9715;
                                                } else {
                                                    phi_6339_ = type_18(0i, 5i);
                                                    phi_6342_ = bitcast<f64>(((bitcast<u64>(_e9663) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9670 = phi_6339_;
                                                        let _e9672 = phi_6342_;
                                                        local_48 = _e9672;
                                                        if (_e9670.member < _e9670.member_1) {
                                                            let _e9679 = (_e9670.member + 1i);
                                                            if ((false == (_e9679 > _e9670.member)) != false) {
                                                                phi_6363_ = true;
                                                            } else {
                                                                phi_6363_ = false;
                                                            }
                                                            let _e9684 = phi_6363_;
                                                            if _e9684 {
                                                                phi_6369_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_6369_ = type_19(1u, _e9679);
                                                            }
                                                            let _e9689 = phi_6369_;
                                                            phi_6340_ = type_18(_e9689.member_1, _e9670.member_1);
                                                            phi_6383_ = type_19(1u, _e9670.member);
                                                        } else {
                                                            phi_6340_ = _e9670;
                                                            phi_6383_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e9695 = phi_6340_;
                                                        let _e9697 = phi_6383_;
                                                        let _e9700 = (bitcast<i32>(_e9697.member) != 0i);
                                                        if _e9700 {
                                                            phi_6343_ = (0.5lf * (_e9672 + (_e9663 / _e9672)));
                                                        } else {
                                                            phi_6343_ = f64();
                                                        }
                                                        let _e9705 = phi_6343_;
                                                        continue;
                                                        continuing {
                                                            phi_6339_ = _e9695;
                                                            phi_6342_ = _e9705;
                                                            break if !(_e9700);
                                                        }
                                                    }
                                                    let _e9710 = local_48;
                                                    phi_6396_ = (_e9710 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9717 = phi_6396_;
                                                let _e9725 = local_19.member[0u];
                                                if (_e9725[0] < 0.0lf) {
                                                    phi_6414_ = -(_e9725[0]);
                                                } else {
                                                    phi_6414_ = _e9725[0];
                                                }
                                                let _e9732 = phi_6414_;
                                                if (_e9725[1] < 0.0lf) {
                                                    phi_6421_ = -(_e9725[1]);
                                                } else {
                                                    phi_6421_ = _e9725[1];
                                                }
                                                let _e9736 = phi_6421_;
                                                if (_e9732 > _e9736) {
                                                    phi_6426_ = _e9732;
                                                } else {
                                                    phi_6426_ = _e9736;
                                                }
                                                let _e9739 = phi_6426_;
                                                if (_e9725[2] < 0.0lf) {
                                                    phi_6433_ = -(_e9725[2]);
                                                } else {
                                                    phi_6433_ = _e9725[2];
                                                }
                                                let _e9743 = phi_6433_;
                                                if (_e9739 > _e9743) {
                                                    phi_6438_ = _e9739;
                                                } else {
                                                    phi_6438_ = _e9743;
                                                }
                                                let _e9746 = phi_6438_;
                                                let _e9749 = local_19.member[1u];
                                                if (_e9749[0] < 0.0lf) {
                                                    phi_6451_ = -(_e9749[0]);
                                                } else {
                                                    phi_6451_ = _e9749[0];
                                                }
                                                let _e9756 = phi_6451_;
                                                if (_e9749[1] < 0.0lf) {
                                                    phi_6458_ = -(_e9749[1]);
                                                } else {
                                                    phi_6458_ = _e9749[1];
                                                }
                                                let _e9760 = phi_6458_;
                                                if (_e9756 > _e9760) {
                                                    phi_6463_ = _e9756;
                                                } else {
                                                    phi_6463_ = _e9760;
                                                }
                                                let _e9763 = phi_6463_;
                                                if (_e9749[2] < 0.0lf) {
                                                    phi_6470_ = -(_e9749[2]);
                                                } else {
                                                    phi_6470_ = _e9749[2];
                                                }
                                                let _e9767 = phi_6470_;
                                                if (_e9763 > _e9767) {
                                                    phi_6475_ = _e9763;
                                                } else {
                                                    phi_6475_ = _e9767;
                                                }
                                                let _e9770 = phi_6475_;
                                                if (_e9746 > _e9770) {
                                                    phi_6480_ = _e9746;
                                                } else {
                                                    phi_6480_ = _e9770;
                                                }
                                                let _e9773 = phi_6480_;
                                                let _e9775 = local_19.member_3;
                                                let _e9779 = local_19.member_1[0u];
                                                if (_e9779[0] < 0.0lf) {
                                                    phi_6497_ = -(_e9779[0]);
                                                } else {
                                                    phi_6497_ = _e9779[0];
                                                }
                                                let _e9786 = phi_6497_;
                                                if (_e9779[1] < 0.0lf) {
                                                    phi_6504_ = -(_e9779[1]);
                                                } else {
                                                    phi_6504_ = _e9779[1];
                                                }
                                                let _e9790 = phi_6504_;
                                                if (_e9786 > _e9790) {
                                                    phi_6509_ = _e9786;
                                                } else {
                                                    phi_6509_ = _e9790;
                                                }
                                                let _e9793 = phi_6509_;
                                                if (_e9779[2] < 0.0lf) {
                                                    phi_6516_ = -(_e9779[2]);
                                                } else {
                                                    phi_6516_ = _e9779[2];
                                                }
                                                let _e9797 = phi_6516_;
                                                if (_e9793 > _e9797) {
                                                    phi_6521_ = _e9793;
                                                } else {
                                                    phi_6521_ = _e9797;
                                                }
                                                let _e9800 = phi_6521_;
                                                let _e9803 = local_19.member_1[1u];
                                                if (_e9803[0] < 0.0lf) {
                                                    phi_6535_ = -(_e9803[0]);
                                                } else {
                                                    phi_6535_ = _e9803[0];
                                                }
                                                let _e9810 = phi_6535_;
                                                if (_e9803[1] < 0.0lf) {
                                                    phi_6542_ = -(_e9803[1]);
                                                } else {
                                                    phi_6542_ = _e9803[1];
                                                }
                                                let _e9814 = phi_6542_;
                                                if (_e9810 > _e9814) {
                                                    phi_6547_ = _e9810;
                                                } else {
                                                    phi_6547_ = _e9814;
                                                }
                                                let _e9817 = phi_6547_;
                                                if (_e9803[2] < 0.0lf) {
                                                    phi_6554_ = -(_e9803[2]);
                                                } else {
                                                    phi_6554_ = _e9803[2];
                                                }
                                                let _e9821 = phi_6554_;
                                                if (_e9817 > _e9821) {
                                                    phi_6559_ = _e9817;
                                                } else {
                                                    phi_6559_ = _e9821;
                                                }
                                                let _e9824 = phi_6559_;
                                                if (_e9800 > _e9824) {
                                                    phi_6564_ = _e9800;
                                                } else {
                                                    phi_6564_ = _e9824;
                                                }
                                                let _e9827 = phi_6564_;
                                                let _e9829 = local_19.member_3;
                                                let _e9833 = local_19.member_2[0u];
                                                if (_e9833[0] < 0.0lf) {
                                                    phi_6581_ = -(_e9833[0]);
                                                } else {
                                                    phi_6581_ = _e9833[0];
                                                }
                                                let _e9840 = phi_6581_;
                                                if (_e9833[1] < 0.0lf) {
                                                    phi_6588_ = -(_e9833[1]);
                                                } else {
                                                    phi_6588_ = _e9833[1];
                                                }
                                                let _e9844 = phi_6588_;
                                                if (_e9840 > _e9844) {
                                                    phi_6593_ = _e9840;
                                                } else {
                                                    phi_6593_ = _e9844;
                                                }
                                                let _e9847 = phi_6593_;
                                                if (_e9833[2] < 0.0lf) {
                                                    phi_6600_ = -(_e9833[2]);
                                                } else {
                                                    phi_6600_ = _e9833[2];
                                                }
                                                let _e9851 = phi_6600_;
                                                if (_e9847 > _e9851) {
                                                    phi_6605_ = _e9847;
                                                } else {
                                                    phi_6605_ = _e9851;
                                                }
                                                let _e9854 = phi_6605_;
                                                let _e9857 = local_19.member_2[1u];
                                                if (_e9857[0] < 0.0lf) {
                                                    phi_6619_ = -(_e9857[0]);
                                                } else {
                                                    phi_6619_ = _e9857[0];
                                                }
                                                let _e9864 = phi_6619_;
                                                if (_e9857[1] < 0.0lf) {
                                                    phi_6626_ = -(_e9857[1]);
                                                } else {
                                                    phi_6626_ = _e9857[1];
                                                }
                                                let _e9868 = phi_6626_;
                                                if (_e9864 > _e9868) {
                                                    phi_6631_ = _e9864;
                                                } else {
                                                    phi_6631_ = _e9868;
                                                }
                                                let _e9871 = phi_6631_;
                                                if (_e9857[2] < 0.0lf) {
                                                    phi_6638_ = -(_e9857[2]);
                                                } else {
                                                    phi_6638_ = _e9857[2];
                                                }
                                                let _e9875 = phi_6638_;
                                                if (_e9871 > _e9875) {
                                                    phi_6643_ = _e9871;
                                                } else {
                                                    phi_6643_ = _e9875;
                                                }
                                                let _e9878 = phi_6643_;
                                                if (_e9854 > _e9878) {
                                                    phi_6648_ = _e9854;
                                                } else {
                                                    phi_6648_ = _e9878;
                                                }
                                                let _e9881 = phi_6648_;
                                                let _e9883 = local_19.member_3;
                                                let _e9891 = local_19.member_3;
                                                let _e9906 = ((((_e9717 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e9773 + _e9775) + (_e9827 + _e9829)) + (_e9881 + _e9883)) * (1.1102230246251565e-16lf * f64(16f))) + (_e9891 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e9652) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                                let _e9909 = local_16.member[0u];
                                                let _e9912 = local_16.member_1[0u];
                                                if (_e9909 < 0.0lf) {
                                                    phi_6696_ = -(_e9909);
                                                } else {
                                                    phi_6696_ = _e9909;
                                                }
                                                let _e9918 = phi_6696_;
                                                if (_e9912 < 0.0lf) {
                                                    phi_6702_ = -(_e9912);
                                                } else {
                                                    phi_6702_ = _e9912;
                                                }
                                                let _e9922 = phi_6702_;
                                                phi_6714_ = type_9(1u, 4u);
                                                phi_6717_ = ((_e9909 + ((_e9912 - _e9909) * _e7158)) - ((_e9365 * f64(1.01f)) + ((_e9918 + _e9922) * (1.1102230246251565e-16lf * f64(12f)))));
                                                loop {
                                                    let _e9933 = phi_6714_;
                                                    let _e9935 = phi_6717_;
                                                    local_49 = _e9935;
                                                    local_50 = _e9935;
                                                    if (_e9933.member < _e9933.member_1) {
                                                        phi_6715_ = type_9((_e9933.member + 1u), _e9933.member_1);
                                                        phi_6740_ = type_9(1u, _e9933.member);
                                                    } else {
                                                        phi_6715_ = _e9933;
                                                        phi_6740_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e9947 = phi_6715_;
                                                    let _e9949 = phi_6740_;
                                                    let _e9953 = (bitcast<i32>(_e9949.member) != 0i);
                                                    if _e9953 {
                                                        let _e9956 = local_16.member[_e9949.member_1];
                                                        let _e9959 = local_16.member_1[_e9949.member_1];
                                                        if (_e9956 < 0.0lf) {
                                                            phi_6770_ = -(_e9956);
                                                        } else {
                                                            phi_6770_ = _e9956;
                                                        }
                                                        let _e9965 = phi_6770_;
                                                        if (_e9959 < 0.0lf) {
                                                            phi_6776_ = -(_e9959);
                                                        } else {
                                                            phi_6776_ = _e9959;
                                                        }
                                                        let _e9969 = phi_6776_;
                                                        let _e9978 = ((_e9956 + ((_e9959 - _e9956) * _e7158)) - ((_e9365 * f64(1.01f)) + ((_e9965 + _e9969) * (1.1102230246251565e-16lf * f64(12f)))));
                                                        if (_e9935 < _e9978) {
                                                            phi_6790_ = _e9935;
                                                        } else {
                                                            phi_6790_ = _e9978;
                                                        }
                                                        let _e9981 = phi_6790_;
                                                        phi_6718_ = _e9981;
                                                    } else {
                                                        phi_6718_ = f64();
                                                    }
                                                    let _e9983 = phi_6718_;
                                                    continue;
                                                    continuing {
                                                        phi_6714_ = _e9947;
                                                        phi_6717_ = _e9983;
                                                        break if !(_e9953);
                                                    }
                                                }
                                                let _e9986 = local_49;
                                                if (_e9986 > f64(0f)) {
                                                    let _e9991 = local_50;
                                                    let _e9995 = (((_e9906 - _e9991) / _e9906) * f64(2.02f));
                                                    if (_e9995 <= 2.2250738585072014e-308lf) {
                                                        if (_e9995 > 0.0lf) {
                                                            phi_6812_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_6812_ = 0.0lf;
                                                        }
                                                        let _e10047 = phi_6812_;
                                                        phi_6876_ = _e10047;
                                                    } else {
                                                        phi_6819_ = type_18(0i, 5i);
                                                        phi_6822_ = bitcast<f64>(((bitcast<u64>(_e9995) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e10002 = phi_6819_;
                                                            let _e10004 = phi_6822_;
                                                            local_51 = _e10004;
                                                            if (_e10002.member < _e10002.member_1) {
                                                                let _e10011 = (_e10002.member + 1i);
                                                                if ((false == (_e10011 > _e10002.member)) != false) {
                                                                    phi_6843_ = true;
                                                                } else {
                                                                    phi_6843_ = false;
                                                                }
                                                                let _e10016 = phi_6843_;
                                                                if _e10016 {
                                                                    phi_6849_ = type_19(0u, type_19().member_1);
                                                                } else {
                                                                    phi_6849_ = type_19(1u, _e10011);
                                                                }
                                                                let _e10021 = phi_6849_;
                                                                phi_6820_ = type_18(_e10021.member_1, _e10002.member_1);
                                                                phi_6863_ = type_19(1u, _e10002.member);
                                                            } else {
                                                                phi_6820_ = _e10002;
                                                                phi_6863_ = type_19(0u, type_19().member_1);
                                                            }
                                                            let _e10027 = phi_6820_;
                                                            let _e10029 = phi_6863_;
                                                            let _e10032 = (bitcast<i32>(_e10029.member) != 0i);
                                                            if _e10032 {
                                                                phi_6823_ = (0.5lf * (_e10004 + (_e9995 / _e10004)));
                                                            } else {
                                                                phi_6823_ = f64();
                                                            }
                                                            let _e10037 = phi_6823_;
                                                            continue;
                                                            continuing {
                                                                phi_6819_ = _e10027;
                                                                phi_6822_ = _e10037;
                                                                break if !(_e10032);
                                                            }
                                                        }
                                                        let _e10042 = local_51;
                                                        phi_6876_ = (_e10042 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e10049 = phi_6876_;
                                                    let _e10052 = ((_e10049 * _e9652) * f64(1.01f));
                                                    phi_6883_ = type_9(0u, 4u);
                                                    phi_6886_ = f64(2f);
                                                    phi_6888_ = true;
                                                    phi_6890_ = true;
                                                    loop {
                                                        let _e10055 = phi_6883_;
                                                        let _e10057 = phi_6886_;
                                                        let _e10059 = phi_6888_;
                                                        let _e10061 = phi_6890_;
                                                        local_52 = _e10057;
                                                        local_93 = _e10057;
                                                        local_53 = _e10059;
                                                        local_54 = _e10061;
                                                        local_94 = _e10061;
                                                        local_55 = _e10061;
                                                        if (_e10055.member < _e10055.member_1) {
                                                            phi_6884_ = type_9((_e10055.member + 1u), _e10055.member_1);
                                                            phi_6913_ = type_9(1u, _e10055.member);
                                                        } else {
                                                            phi_6884_ = _e10055;
                                                            phi_6913_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e10073 = phi_6884_;
                                                        let _e10075 = phi_6913_;
                                                        let _e10079 = (bitcast<i32>(_e10075.member) != 0i);
                                                        if _e10079 {
                                                            let _e10083 = local_15.member[0u][_e10075.member_1];
                                                            let _e10090 = local_15.member[1u][_e10075.member_1];
                                                            if (_e10083[0] < 0.0lf) {
                                                                phi_6950_ = -(_e10083[0]);
                                                            } else {
                                                                phi_6950_ = _e10083[0];
                                                            }
                                                            let _e10097 = phi_6950_;
                                                            if (_e10083[1] < 0.0lf) {
                                                                phi_6957_ = -(_e10083[1]);
                                                            } else {
                                                                phi_6957_ = _e10083[1];
                                                            }
                                                            let _e10101 = phi_6957_;
                                                            if (_e10083[2] < 0.0lf) {
                                                                phi_6965_ = -(_e10083[2]);
                                                            } else {
                                                                phi_6965_ = _e10083[2];
                                                            }
                                                            let _e10106 = phi_6965_;
                                                            let _e10107 = ((_e10097 + _e10101) + _e10106);
                                                            if (_e10090[0] < 0.0lf) {
                                                                phi_6973_ = -(_e10090[0]);
                                                            } else {
                                                                phi_6973_ = _e10090[0];
                                                            }
                                                            let _e10111 = phi_6973_;
                                                            if (_e10090[1] < 0.0lf) {
                                                                phi_6980_ = -(_e10090[1]);
                                                            } else {
                                                                phi_6980_ = _e10090[1];
                                                            }
                                                            let _e10115 = phi_6980_;
                                                            if (_e10090[2] < 0.0lf) {
                                                                phi_6988_ = -(_e10090[2]);
                                                            } else {
                                                                phi_6988_ = _e10090[2];
                                                            }
                                                            let _e10120 = phi_6988_;
                                                            let _e10121 = ((_e10111 + _e10115) + _e10120);
                                                            if (_e10107 > _e10121) {
                                                                phi_6994_ = _e10107;
                                                            } else {
                                                                phi_6994_ = _e10121;
                                                            }
                                                            let _e10124 = phi_6994_;
                                                            let _e10130 = (_e10090[0] - _e10083[0]);
                                                            let _e10131 = (_e10090[1] - _e10083[1]);
                                                            let _e10132 = (_e10090[2] - _e10083[2]);
                                                            if (_e10130 < 0.0lf) {
                                                                phi_7014_ = -(_e10130);
                                                            } else {
                                                                phi_7014_ = _e10130;
                                                            }
                                                            let _e10136 = phi_7014_;
                                                            if (_e10131 < 0.0lf) {
                                                                phi_7020_ = -(_e10131);
                                                            } else {
                                                                phi_7020_ = _e10131;
                                                            }
                                                            let _e10140 = phi_7020_;
                                                            if (_e10132 < 0.0lf) {
                                                                phi_7027_ = -(_e10132);
                                                            } else {
                                                                phi_7027_ = _e10132;
                                                            }
                                                            let _e10145 = phi_7027_;
                                                            let _e10154 = local_16.member[_e10075.member_1];
                                                            let _e10157 = local_16.member_1[_e10075.member_1];
                                                            if (_e10154 < 0.0lf) {
                                                                phi_7056_ = -(_e10154);
                                                            } else {
                                                                phi_7056_ = _e10154;
                                                            }
                                                            let _e10163 = phi_7056_;
                                                            if (_e10157 < 0.0lf) {
                                                                phi_7062_ = -(_e10157);
                                                            } else {
                                                                phi_7062_ = _e10157;
                                                            }
                                                            let _e10167 = phi_7062_;
                                                            let _e10172 = ((_e9365 * f64(1.01f)) + ((_e10163 + _e10167) * (1.1102230246251565e-16lf * f64(12f))));
                                                            let _e10179 = local_16.member_1[_e10075.member_1];
                                                            let _e10182 = local_16.member[_e10075.member_1];
                                                            let _e10183 = (_e10179 - _e10182);
                                                            let _e10186 = ((_e10172 + _e10172) + (_e10052 * ((((_e10136 + _e10140) + _e10145) + (_e9365 * f64(6f))) * f64(1.01f))));
                                                            let _e10189 = ((((_e10154 + ((_e10157 - _e10154) * _e7158)) - _e10172) - (_e10052 * ((_e10124 + (_e9365 * f64(3f))) * f64(1.01f)))) - _e9906);
                                                            let _e10190 = (_e10189 > 2.2250738585072014e-308lf);
                                                            let _e10191 = (_e10183 > _e10186);
                                                            if _e10191 {
                                                                phi_7099_ = true;
                                                            } else {
                                                                phi_7099_ = _e10190;
                                                            }
                                                            let _e10193 = phi_7099_;
                                                            if (_e10183 < -(_e10186)) {
                                                                phi_7106_ = true;
                                                            } else {
                                                                phi_7106_ = _e10190;
                                                            }
                                                            let _e10198 = phi_7106_;
                                                            if _e10191 {
                                                                phi_7127_ = _e10057;
                                                            } else {
                                                                if _e10190 {
                                                                    let _e10200 = (_e10186 - _e10183);
                                                                    if (_e10200 > 2.2250738585072014e-308lf) {
                                                                        phi_7119_ = _e10200;
                                                                    } else {
                                                                        phi_7119_ = 2.2250738585072014e-308lf;
                                                                    }
                                                                    let _e10203 = phi_7119_;
                                                                    let _e10204 = (_e10189 / _e10203);
                                                                    if (_e10057 < _e10204) {
                                                                        phi_7125_ = _e10057;
                                                                    } else {
                                                                        phi_7125_ = _e10204;
                                                                    }
                                                                    let _e10207 = phi_7125_;
                                                                    phi_7126_ = _e10207;
                                                                } else {
                                                                    phi_7126_ = _e10057;
                                                                }
                                                                let _e10209 = phi_7126_;
                                                                phi_7127_ = _e10209;
                                                            }
                                                            let _e10211 = phi_7127_;
                                                            phi_6887_ = _e10211;
                                                            phi_6889_ = (_e10059 && _e10198);
                                                            phi_6891_ = (_e10061 && _e10193);
                                                        } else {
                                                            phi_6887_ = f64();
                                                            phi_6889_ = bool();
                                                            phi_6891_ = bool();
                                                        }
                                                        let _e10213 = phi_6887_;
                                                        let _e10215 = phi_6889_;
                                                        let _e10217 = phi_6891_;
                                                        continue;
                                                        continuing {
                                                            phi_6883_ = _e10073;
                                                            phi_6886_ = _e10213;
                                                            phi_6888_ = _e10215;
                                                            phi_6890_ = _e10217;
                                                            break if !(_e10079);
                                                        }
                                                    }
                                                    let _e10219 = f64(2f);
                                                    let _e10221 = local_52;
                                                    if (_e10221 < _e10219) {
                                                        let _e12730 = local_93;
                                                        phi_7133_ = _e12730;
                                                    } else {
                                                        phi_7133_ = _e10219;
                                                    }
                                                    let _e10224 = phi_7133_;
                                                    let _e10226 = (_e10224 * f64(0.999f));
                                                    let _e10228 = local_53;
                                                    if _e10228 {
                                                        let _e10230 = local_54;
                                                        if _e10230 {
                                                            phi_7144_ = type_47();
                                                        } else {
                                                            phi_7144_ = type_47(_e7158, f64(2f), 1u);
                                                        }
                                                        let _e10234 = phi_7144_;
                                                        phi_7145_ = _e10234;
                                                        let _e12737 = local_94;
                                                        phi_7146_ = _e12737;
                                                    } else {
                                                        phi_7145_ = type_47();
                                                        phi_7146_ = true;
                                                    }
                                                    let _e10236 = phi_7145_;
                                                    let _e10238 = phi_7146_;
                                                    if _e10238 {
                                                        let _e10240 = local_55;
                                                        if _e10240 {
                                                            if (_e10226 > (1.1102230246251565e-16lf * f64(4096f))) {
                                                                let _e10246 = (_e7158 + _e10226);
                                                                if (_e10246 < _e574) {
                                                                    phi_7164_ = _e10246;
                                                                } else {
                                                                    phi_7164_ = _e574;
                                                                }
                                                                let _e10249 = phi_7164_;
                                                                phi_7165_ = _e10249;
                                                            } else {
                                                                phi_7165_ = _e7158;
                                                            }
                                                            let _e10251 = phi_7165_;
                                                            phi_7168_ = type_9(0u, 4u);
                                                            phi_7171_ = _e10251;
                                                            phi_7173_ = _e7158;
                                                            loop {
                                                                let _e10253 = phi_7168_;
                                                                let _e10255 = phi_7171_;
                                                                let _e10257 = phi_7173_;
                                                                local_56 = _e10255;
                                                                local_57 = _e10257;
                                                                local_58 = _e10257;
                                                                if (_e10253.member < _e10253.member_1) {
                                                                    phi_7169_ = type_9((_e10253.member + 1u), _e10253.member_1);
                                                                    phi_7196_ = type_9(1u, _e10253.member);
                                                                } else {
                                                                    phi_7169_ = _e10253;
                                                                    phi_7196_ = type_9(0u, type_9().member_1);
                                                                }
                                                                let _e10269 = phi_7169_;
                                                                let _e10271 = phi_7196_;
                                                                let _e10275 = (bitcast<i32>(_e10271.member) != 0i);
                                                                if _e10275 {
                                                                    let _e10278 = local_16.member[_e10271.member_1];
                                                                    let _e10281 = local_16.member_1[_e10271.member_1];
                                                                    let _e10284 = local_16.member[_e10271.member_1];
                                                                    let _e10290 = local_16.member_2[_e10271.member_1];
                                                                    let _e10291 = ((_e10278 + ((_e10281 - _e10284) * _e7158)) - _e10290);
                                                                    let _e10294 = local_16.member_1[_e10271.member_1];
                                                                    let _e10297 = local_16.member[_e10271.member_1];
                                                                    let _e10298 = (_e10294 - _e10297);
                                                                    if (_e10298 > f64(0f)) {
                                                                        let _e10315 = (_e7158 - (_e10291 / _e10298));
                                                                        if (_e10257 > _e10315) {
                                                                            phi_7265_ = _e10257;
                                                                        } else {
                                                                            phi_7265_ = _e10315;
                                                                        }
                                                                        let _e10318 = phi_7265_;
                                                                        phi_7285_ = _e10255;
                                                                        phi_7286_ = _e10318;
                                                                    } else {
                                                                        if (_e10291 > f64(0f)) {
                                                                            if (_e10298 < f64(0f)) {
                                                                                let _e10306 = (_e7158 - (_e10291 / _e10298));
                                                                                if (_e10255 < _e10306) {
                                                                                    phi_7282_ = _e10255;
                                                                                } else {
                                                                                    phi_7282_ = _e10306;
                                                                                }
                                                                                let _e10309 = phi_7282_;
                                                                                phi_7283_ = _e10309;
                                                                            } else {
                                                                                phi_7283_ = _e10255;
                                                                            }
                                                                            let _e10311 = phi_7283_;
                                                                            phi_7284_ = _e10311;
                                                                        } else {
                                                                            phi_7284_ = _e10255;
                                                                        }
                                                                        let _e10313 = phi_7284_;
                                                                        phi_7285_ = _e10313;
                                                                        phi_7286_ = _e10257;
                                                                    }
                                                                    let _e10320 = phi_7285_;
                                                                    let _e10322 = phi_7286_;
                                                                    phi_7172_ = _e10320;
                                                                    phi_7174_ = _e10322;
                                                                } else {
                                                                    phi_7172_ = f64();
                                                                    phi_7174_ = f64();
                                                                }
                                                                let _e10324 = phi_7172_;
                                                                let _e10326 = phi_7174_;
                                                                continue;
                                                                continuing {
                                                                    phi_7168_ = _e10269;
                                                                    phi_7171_ = _e10324;
                                                                    phi_7173_ = _e10326;
                                                                    break if !(_e10275);
                                                                }
                                                            }
                                                            let _e10329 = local_56;
                                                            let _e10331 = local_57;
                                                            let _e10336 = local_58;
                                                            let _e10337 = (_e10336 + ((_e10329 - _e10331) * f64(0.5f)));
                                                            if (_e10337 > _e7158) {
                                                                if (_e10337 <= _e10251) {
                                                                    let _e10340 = f64(0f);
                                                                    let _e10343 = local_16.member[0u];
                                                                    let _e10346 = local_16.member_1[0u];
                                                                    let _e10349 = local_16.member[0u];
                                                                    let _e10355 = local_16.member_2[0u];
                                                                    if (((_e10343 + ((_e10346 - _e10349) * _e10337)) - _e10355) > _e10340) {
                                                                        let _e10360 = local_16.member[1u];
                                                                        let _e10363 = local_16.member_1[1u];
                                                                        let _e10366 = local_16.member[1u];
                                                                        let _e10372 = local_16.member_2[1u];
                                                                        if (((_e10360 + ((_e10363 - _e10366) * _e10337)) - _e10372) > _e10340) {
                                                                            let _e10377 = local_16.member[2u];
                                                                            let _e10380 = local_16.member_1[2u];
                                                                            let _e10383 = local_16.member[2u];
                                                                            let _e10389 = local_16.member_2[2u];
                                                                            if (((_e10377 + ((_e10380 - _e10383) * _e10337)) - _e10389) > _e10340) {
                                                                                let _e10394 = local_16.member[3u];
                                                                                let _e10397 = local_16.member_1[3u];
                                                                                let _e10400 = local_16.member[3u];
                                                                                let _e10406 = local_16.member_2[3u];
                                                                                phi_7449_ = (((_e10394 + ((_e10397 - _e10400) * _e10337)) - _e10406) > _e10340);
                                                                                phi_7450_ = false;
                                                                            } else {
                                                                                phi_7449_ = bool();
                                                                                phi_7450_ = true;
                                                                            }
                                                                            let _e10410 = phi_7449_;
                                                                            let _e10412 = phi_7450_;
                                                                            phi_7451_ = _e10410;
                                                                            phi_7452_ = _e10412;
                                                                        } else {
                                                                            phi_7451_ = bool();
                                                                            phi_7452_ = true;
                                                                        }
                                                                        let _e10414 = phi_7451_;
                                                                        let _e10416 = phi_7452_;
                                                                        phi_7453_ = _e10414;
                                                                        phi_7454_ = _e10416;
                                                                    } else {
                                                                        phi_7453_ = bool();
                                                                        phi_7454_ = true;
                                                                    }
                                                                    let _e10418 = phi_7453_;
                                                                    let _e10420 = phi_7454_;
                                                                    if _e10420 {
                                                                        phi_7458_ = false;
                                                                    } else {
                                                                        phi_7458_ = _e10418;
                                                                    }
                                                                    let _e10422 = phi_7458_;
                                                                    if _e10422 {
                                                                        phi_7462_ = false;
                                                                    } else {
                                                                        phi_7462_ = true;
                                                                    }
                                                                    let _e10424 = phi_7462_;
                                                                    phi_7463_ = _e10424;
                                                                } else {
                                                                    phi_7463_ = true;
                                                                }
                                                                let _e10426 = phi_7463_;
                                                                phi_7464_ = _e10426;
                                                            } else {
                                                                phi_7464_ = true;
                                                            }
                                                            let _e10428 = phi_7464_;
                                                            if _e10428 {
                                                                phi_7469_ = f64(2f);
                                                            } else {
                                                                phi_7469_ = _e10337;
                                                            }
                                                            let _e10431 = phi_7469_;
                                                            phi_7473_ = type_47(_e10251, _e10431, 2u);
                                                            phi_7474_ = type_47();
                                                            phi_7475_ = false;
                                                        } else {
                                                            phi_7473_ = type_47();
                                                            phi_7474_ = type_47(_e7158, f64(2f), 0u);
                                                            phi_7475_ = true;
                                                        }
                                                        let _e10434 = phi_7473_;
                                                        let _e10436 = phi_7474_;
                                                        let _e10438 = phi_7475_;
                                                        phi_7476_ = _e10434;
                                                        phi_7477_ = _e10436;
                                                        phi_7478_ = _e10438;
                                                    } else {
                                                        phi_7476_ = type_47();
                                                        phi_7477_ = _e10236;
                                                        phi_7478_ = true;
                                                    }
                                                    let _e10440 = phi_7476_;
                                                    let _e10442 = phi_7477_;
                                                    let _e10444 = phi_7478_;
                                                    phi_7484_ = _e10442;
                                                    phi_7485_ = _e10440;
                                                    phi_7486_ = _e10444;
                                                } else {
                                                    phi_7484_ = type_47(_e7158, f64(2f), 0u);
                                                    phi_7485_ = type_47();
                                                    phi_7486_ = true;
                                                }
                                                let _e10446 = phi_7484_;
                                                let _e10448 = phi_7485_;
                                                let _e10450 = phi_7486_;
                                                phi_7490_ = _e10446;
                                                phi_7491_ = _e10448;
                                                phi_7492_ = false;
                                                phi_7493_ = _e10450;
                                            } else {
                                                phi_7490_ = type_47();
                                                phi_7491_ = type_47();
                                                phi_7492_ = true;
                                                phi_7493_ = false;
                                            }
                                            let _e10452 = phi_7490_;
                                            let _e10454 = phi_7491_;
                                            let _e10456 = phi_7492_;
                                            let _e10458 = phi_7493_;
                                            phi_7494_ = _e10452;
                                            phi_7495_ = _e10454;
                                            phi_7496_ = _e10456;
                                            phi_7497_ = _e10458;
                                        } else {
                                            phi_7494_ = type_47();
                                            phi_7495_ = type_47();
                                            phi_7496_ = true;
                                            phi_7497_ = false;
                                        }
                                        let _e10460 = phi_7494_;
                                        let _e10462 = phi_7495_;
                                        let _e10464 = phi_7496_;
                                        let _e10466 = phi_7497_;
                                        if _e10464 {
                                            phi_7503_ = type_47(_e7158, f64(2f), 0u);
                                            phi_7504_ = true;
                                        } else {
                                            phi_7503_ = _e10460;
                                            phi_7504_ = _e10466;
                                        }
                                        let _e10470 = phi_7503_;
                                        let _e10472 = phi_7504_;
                                        if _e10472 {
                                            phi_7508_ = _e10470;
                                        } else {
                                            phi_7508_ = _e10462;
                                        }
                                        let _e10474 = phi_7508_;
                                        if ((_e585 & 64u) != 0u) {
                                            if (_e10474.member_2 == 2u) {
                                                let _e10478 = (_e10474.member_1 <= _e574);
                                                if _e10478 {
                                                    phi_7524_ = _e10474.member_1;
                                                    phi_7525_ = _e10474.member_1;
                                                    phi_7526_ = false;
                                                } else {
                                                    phi_7524_ = f64();
                                                    phi_7525_ = f64();
                                                    phi_7526_ = true;
                                                }
                                                let _e10482 = phi_7524_;
                                                let _e10484 = phi_7525_;
                                                let _e10486 = phi_7526_;
                                                phi_7527_ = _e10482;
                                                phi_7528_ = _e10484;
                                                phi_7529_ = _e10478;
                                                phi_7530_ = _e10486;
                                                phi_7531_ = false;
                                            } else {
                                                phi_7527_ = f64();
                                                phi_7528_ = f64();
                                                phi_7529_ = false;
                                                phi_7530_ = false;
                                                phi_7531_ = true;
                                            }
                                            let _e10488 = phi_7527_;
                                            let _e10490 = phi_7528_;
                                            let _e10492 = phi_7529_;
                                            let _e10494 = phi_7530_;
                                            let _e10496 = phi_7531_;
                                            phi_7532_ = _e10488;
                                            phi_7533_ = _e10490;
                                            phi_7534_ = _e10492;
                                            phi_7535_ = _e10494;
                                            phi_7536_ = _e10496;
                                        } else {
                                            phi_7532_ = f64();
                                            phi_7533_ = f64();
                                            phi_7534_ = false;
                                            phi_7535_ = false;
                                            phi_7536_ = true;
                                        }
                                        let _e10498 = phi_7532_;
                                        let _e10500 = phi_7533_;
                                        let _e10502 = phi_7534_;
                                        let _e10504 = phi_7535_;
                                        let _e10506 = phi_7536_;
                                        phi_7537_ = _e10498;
                                        phi_7538_ = _e10474.member_2;
                                        phi_7539_ = _e10500;
                                        phi_7540_ = _e10474;
                                        phi_7541_ = _e10474.member_2;
                                        phi_7542_ = _e10474.member_2;
                                        phi_7543_ = _e10502;
                                        phi_7544_ = _e10504;
                                        phi_7545_ = _e10506;
                                    }
                                    let _e10508 = phi_7537_;
                                    let _e10510 = phi_7538_;
                                    let _e10512 = phi_7539_;
                                    let _e10514 = phi_7540_;
                                    let _e10516 = phi_7541_;
                                    let _e10518 = phi_7542_;
                                    let _e10520 = phi_7543_;
                                    let _e10522 = phi_7544_;
                                    let _e10524 = phi_7545_;
                                    phi_7546_ = _e10508;
                                    phi_7547_ = _e10510;
                                    phi_7548_ = _e10512;
                                    phi_7549_ = _e10514;
                                    phi_7550_ = _e10516;
                                    phi_7551_ = _e10518;
                                    phi_7552_ = _e10520;
                                    phi_7553_ = _e9023;
                                    phi_7554_ = _e10522;
                                    phi_7555_ = _e10524;
                                    phi_7556_ = false;
                                } else {
                                    phi_7546_ = f64();
                                    phi_7547_ = u32();
                                    phi_7548_ = f64();
                                    phi_7549_ = type_47();
                                    phi_7550_ = u32();
                                    phi_7551_ = u32();
                                    phi_7552_ = false;
                                    phi_7553_ = false;
                                    phi_7554_ = false;
                                    phi_7555_ = false;
                                    phi_7556_ = true;
                                }
                                let _e10526 = phi_7546_;
                                let _e10528 = phi_7547_;
                                let _e10530 = phi_7548_;
                                let _e10532 = phi_7549_;
                                let _e10534 = phi_7550_;
                                let _e10536 = phi_7551_;
                                let _e10538 = phi_7552_;
                                let _e10540 = phi_7553_;
                                let _e10542 = phi_7554_;
                                let _e10544 = phi_7555_;
                                let _e10546 = phi_7556_;
                                phi_7557_ = _e9020;
                                phi_2541_ = _e10526;
                                phi_2543_ = _e10528;
                                phi_2545_ = _e10530;
                                phi_7558_ = _e10532;
                                phi_7559_ = _e10534;
                                phi_7560_ = _e9020;
                                phi_7561_ = _e10536;
                                phi_7562_ = _e10538;
                                phi_7563_ = _e10540;
                                phi_7564_ = _e10542;
                                phi_7565_ = _e10544;
                                phi_7566_ = false;
                                phi_7567_ = _e10546;
                            } else {
                                phi_7557_ = f64();
                                phi_2541_ = f64();
                                phi_2543_ = u32();
                                phi_2545_ = f64();
                                phi_7558_ = type_47();
                                phi_7559_ = u32();
                                phi_7560_ = f64();
                                phi_7561_ = u32();
                                phi_7562_ = false;
                                phi_7563_ = false;
                                phi_7564_ = false;
                                phi_7565_ = false;
                                phi_7566_ = true;
                                phi_7567_ = false;
                            }
                            let _e10548 = phi_7557_;
                            let _e10550 = phi_2541_;
                            let _e10552 = phi_2543_;
                            let _e10554 = phi_2545_;
                            let _e10556 = phi_7558_;
                            let _e10558 = phi_7559_;
                            let _e10560 = phi_7560_;
                            let _e10562 = phi_7561_;
                            let _e10564 = phi_7562_;
                            let _e10566 = phi_7563_;
                            let _e10568 = phi_7564_;
                            let _e10570 = phi_7565_;
                            let _e10572 = phi_7566_;
                            let _e10574 = phi_7567_;
                            local_59 = _e10566;
                            local_95 = _e10568;
                            local_96 = _e10570;
                            local_97 = _e10572;
                            local_98 = _e10574;
                            local_60 = _e10556;
                            local_61 = _e10556;
                            local_99 = _e10558;
                            local_62 = _e10556;
                            local_100 = _e10566;
                            local_101 = _e10562;
                            local_103 = _e10560;
                            local_104 = _e10548;
                            continue;
                            continuing {
                                phi_2537_ = _e7181;
                                phi_2540_ = _e10550;
                                phi_2542_ = _e10552;
                                phi_2544_ = _e10554;
                                break if !(_e10564);
                            }
                        }
                        let _e10577 = local_59;
                        if _e10577 {
                            phi_7571_ = false;
                            phi_7572_ = false;
                            phi_7573_ = false;
                            phi_7574_ = false;
                        } else {
                            let _e12838 = local_95;
                            phi_7571_ = _e12838;
                            let _e12841 = local_96;
                            phi_7572_ = _e12841;
                            let _e12844 = local_97;
                            phi_7573_ = _e12844;
                            let _e12847 = local_98;
                            phi_7574_ = _e12847;
                        }
                        let _e10579 = phi_7571_;
                        let _e10581 = phi_7572_;
                        let _e10583 = phi_7573_;
                        let _e10585 = phi_7574_;
                        if _e10579 {
                            let _e10587 = local_60;
                            if (_e10587.member >= _e574) {
                                phi_7596_ = type_46(type_45(0u, f64()), 0u);
                            } else {
                                let _e10591 = local_61;
                                if (_e10591.member > _e565) {
                                    phi_7591_ = 0u;
                                } else {
                                    let _e12852 = local_99;
                                    phi_7591_ = _e12852;
                                }
                                let _e10595 = phi_7591_;
                                let _e10597 = local_62;
                                phi_7596_ = type_46(type_45(2u, _e10597.member), _e10595);
                            }
                            let _e10604 = phi_7596_;
                            phi_7597_ = _e10604;
                            phi_7598_ = false;
                            phi_7599_ = false;
                            phi_7600_ = false;
                            phi_7601_ = false;
                        } else {
                            phi_7597_ = type_46();
                            phi_7598_ = _e10581;
                            let _e12859 = local_100;
                            phi_7599_ = _e12859;
                            phi_7600_ = _e10583;
                            phi_7601_ = _e10585;
                        }
                        let _e10606 = phi_7597_;
                        let _e10608 = phi_7598_;
                        let _e10610 = phi_7599_;
                        let _e10612 = phi_7600_;
                        let _e10614 = phi_7601_;
                        if _e10608 {
                            let _e12864 = local_101;
                            phi_7605_ = _e12864;
                            let _e12869 = local_103;
                            phi_7606_ = _e12869;
                            phi_7607_ = true;
                            phi_7608_ = false;
                            phi_7609_ = false;
                            phi_7610_ = false;
                        } else {
                            let _e12866 = local_102;
                            phi_7605_ = _e12866;
                            let _e12871 = local_104;
                            phi_7606_ = _e12871;
                            phi_7607_ = _e10610;
                            phi_7608_ = _e10612;
                            phi_7609_ = _e10614;
                            phi_7610_ = _e10579;
                        }
                        let _e10616 = phi_7605_;
                        let _e10618 = phi_7606_;
                        let _e10620 = phi_7607_;
                        let _e10622 = phi_7608_;
                        let _e10624 = phi_7609_;
                        let _e10626 = phi_7610_;
                        if _e10620 {
                            phi_7614_ = _e10618;
                            phi_7615_ = _e10616;
                            phi_7616_ = true;
                            phi_7617_ = false;
                            phi_7618_ = false;
                        } else {
                            let _e12878 = local_105;
                            phi_7614_ = _e12878;
                            let _e12881 = local_106;
                            phi_7615_ = _e12881;
                            phi_7616_ = _e10622;
                            phi_7617_ = _e10624;
                            phi_7618_ = _e10626;
                        }
                        let _e10628 = phi_7614_;
                        let _e10630 = phi_7615_;
                        let _e10632 = phi_7616_;
                        let _e10634 = phi_7617_;
                        let _e10636 = phi_7618_;
                        if _e10632 {
                            local_14[0u] = 0.01f;
                            local_14[1u] = 0f;
                            local_14[2u] = 0.8f;
                            if (_e556 >= (1.1102230246251565e-16lf * f64(8f))) {
                                phi_7632_ = _e556;
                            } else {
                                phi_7632_ = f64(0f);
                            }
                            let _e10645 = phi_7632_;
                            phi_7635_ = type_9(0u, 3u);
                            loop {
                                let _e10647 = phi_7635_;
                                if (_e10647.member < _e10647.member_1) {
                                    phi_7636_ = type_9((_e10647.member + 1u), _e10647.member_1);
                                    phi_7659_ = type_9(1u, _e10647.member);
                                } else {
                                    phi_7636_ = _e10647;
                                    phi_7659_ = type_9(0u, type_9().member_1);
                                }
                                let _e10659 = phi_7636_;
                                let _e10661 = phi_7659_;
                                if (bitcast<i32>(_e10661.member) != 0i) {
                                    let _e10667 = local_14[_e10661.member_1];
                                    let _e10670 = (_e10628 + (_e10645 * f64(_e10667)));
                                    if (_e10670 < _e574) {
                                        phi_7681_ = _e10670;
                                    } else {
                                        phi_7681_ = _e574;
                                    }
                                    let _e10673 = phi_7681_;
                                    let _e10676 = local_19.member[0u];
                                    let _e10682 = local_19.member[1u];
                                    let _e10698 = local_19.member_1[0u];
                                    let _e10704 = local_19.member_1[1u];
                                    let _e10720 = local_19.member_2[0u];
                                    let _e10726 = local_19.member_2[1u];
                                    let _e10740 = function_5(array<f64, 3>((_e10676[0] + ((_e10682[0] - _e10676[0]) * _e10673)), (_e10676[1] + ((_e10682[1] - _e10676[1]) * _e10673)), (_e10676[2] + ((_e10682[2] - _e10676[2]) * _e10673))), array<f64, 3>((_e10698[0] + ((_e10704[0] - _e10698[0]) * _e10673)), (_e10698[1] + ((_e10704[1] - _e10698[1]) * _e10673)), (_e10698[2] + ((_e10704[2] - _e10698[2]) * _e10673))), array<f64, 3>((_e10720[0] + ((_e10726[0] - _e10720[0]) * _e10673)), (_e10720[1] + ((_e10726[1] - _e10720[1]) * _e10673)), (_e10720[2] + ((_e10726[2] - _e10720[2]) * _e10673))), _e253.member);
                                    let _e10751 = (((_e10740[0] * _e10740[0]) + (_e10740[1] * _e10740[1])) + (_e10740[2] * _e10740[2]));
                                    if (_e10751 <= 2.2250738585072014e-308lf) {
                                        if (_e10751 > 0.0lf) {
                                            phi_7804_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_7804_ = 0.0lf;
                                        }
                                        let _e10803 = phi_7804_;
                                        phi_7868_ = _e10803;
                                    } else {
                                        phi_7811_ = type_18(0i, 5i);
                                        phi_7814_ = bitcast<f64>(((bitcast<u64>(_e10751) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e10758 = phi_7811_;
                                            let _e10760 = phi_7814_;
                                            local_63 = _e10760;
                                            if (_e10758.member < _e10758.member_1) {
                                                let _e10767 = (_e10758.member + 1i);
                                                if ((false == (_e10767 > _e10758.member)) != false) {
                                                    phi_7835_ = true;
                                                } else {
                                                    phi_7835_ = false;
                                                }
                                                let _e10772 = phi_7835_;
                                                if _e10772 {
                                                    phi_7841_ = type_19(0u, type_19().member_1);
                                                } else {
                                                    phi_7841_ = type_19(1u, _e10767);
                                                }
                                                let _e10777 = phi_7841_;
                                                phi_7812_ = type_18(_e10777.member_1, _e10758.member_1);
                                                phi_7855_ = type_19(1u, _e10758.member);
                                            } else {
                                                phi_7812_ = _e10758;
                                                phi_7855_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e10783 = phi_7812_;
                                            let _e10785 = phi_7855_;
                                            let _e10788 = (bitcast<i32>(_e10785.member) != 0i);
                                            if _e10788 {
                                                phi_7815_ = (0.5lf * (_e10760 + (_e10751 / _e10760)));
                                            } else {
                                                phi_7815_ = f64();
                                            }
                                            let _e10793 = phi_7815_;
                                            continue;
                                            continuing {
                                                phi_7811_ = _e10783;
                                                phi_7814_ = _e10793;
                                                break if !(_e10788);
                                            }
                                        }
                                        let _e10798 = local_63;
                                        phi_7868_ = (_e10798 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e10805 = phi_7868_;
                                    let _e10813 = local_19.member[0u];
                                    if (_e10813[0] < 0.0lf) {
                                        phi_7886_ = -(_e10813[0]);
                                    } else {
                                        phi_7886_ = _e10813[0];
                                    }
                                    let _e10820 = phi_7886_;
                                    if (_e10813[1] < 0.0lf) {
                                        phi_7893_ = -(_e10813[1]);
                                    } else {
                                        phi_7893_ = _e10813[1];
                                    }
                                    let _e10824 = phi_7893_;
                                    if (_e10820 > _e10824) {
                                        phi_7898_ = _e10820;
                                    } else {
                                        phi_7898_ = _e10824;
                                    }
                                    let _e10827 = phi_7898_;
                                    if (_e10813[2] < 0.0lf) {
                                        phi_7905_ = -(_e10813[2]);
                                    } else {
                                        phi_7905_ = _e10813[2];
                                    }
                                    let _e10831 = phi_7905_;
                                    if (_e10827 > _e10831) {
                                        phi_7910_ = _e10827;
                                    } else {
                                        phi_7910_ = _e10831;
                                    }
                                    let _e10834 = phi_7910_;
                                    let _e10837 = local_19.member[1u];
                                    if (_e10837[0] < 0.0lf) {
                                        phi_7923_ = -(_e10837[0]);
                                    } else {
                                        phi_7923_ = _e10837[0];
                                    }
                                    let _e10844 = phi_7923_;
                                    if (_e10837[1] < 0.0lf) {
                                        phi_7930_ = -(_e10837[1]);
                                    } else {
                                        phi_7930_ = _e10837[1];
                                    }
                                    let _e10848 = phi_7930_;
                                    if (_e10844 > _e10848) {
                                        phi_7935_ = _e10844;
                                    } else {
                                        phi_7935_ = _e10848;
                                    }
                                    let _e10851 = phi_7935_;
                                    if (_e10837[2] < 0.0lf) {
                                        phi_7942_ = -(_e10837[2]);
                                    } else {
                                        phi_7942_ = _e10837[2];
                                    }
                                    let _e10855 = phi_7942_;
                                    if (_e10851 > _e10855) {
                                        phi_7947_ = _e10851;
                                    } else {
                                        phi_7947_ = _e10855;
                                    }
                                    let _e10858 = phi_7947_;
                                    if (_e10834 > _e10858) {
                                        phi_7952_ = _e10834;
                                    } else {
                                        phi_7952_ = _e10858;
                                    }
                                    let _e10861 = phi_7952_;
                                    let _e10863 = local_19.member_3;
                                    let _e10867 = local_19.member_1[0u];
                                    if (_e10867[0] < 0.0lf) {
                                        phi_7969_ = -(_e10867[0]);
                                    } else {
                                        phi_7969_ = _e10867[0];
                                    }
                                    let _e10874 = phi_7969_;
                                    if (_e10867[1] < 0.0lf) {
                                        phi_7976_ = -(_e10867[1]);
                                    } else {
                                        phi_7976_ = _e10867[1];
                                    }
                                    let _e10878 = phi_7976_;
                                    if (_e10874 > _e10878) {
                                        phi_7981_ = _e10874;
                                    } else {
                                        phi_7981_ = _e10878;
                                    }
                                    let _e10881 = phi_7981_;
                                    if (_e10867[2] < 0.0lf) {
                                        phi_7988_ = -(_e10867[2]);
                                    } else {
                                        phi_7988_ = _e10867[2];
                                    }
                                    let _e10885 = phi_7988_;
                                    if (_e10881 > _e10885) {
                                        phi_7993_ = _e10881;
                                    } else {
                                        phi_7993_ = _e10885;
                                    }
                                    let _e10888 = phi_7993_;
                                    let _e10891 = local_19.member_1[1u];
                                    if (_e10891[0] < 0.0lf) {
                                        phi_8007_ = -(_e10891[0]);
                                    } else {
                                        phi_8007_ = _e10891[0];
                                    }
                                    let _e10898 = phi_8007_;
                                    if (_e10891[1] < 0.0lf) {
                                        phi_8014_ = -(_e10891[1]);
                                    } else {
                                        phi_8014_ = _e10891[1];
                                    }
                                    let _e10902 = phi_8014_;
                                    if (_e10898 > _e10902) {
                                        phi_8019_ = _e10898;
                                    } else {
                                        phi_8019_ = _e10902;
                                    }
                                    let _e10905 = phi_8019_;
                                    if (_e10891[2] < 0.0lf) {
                                        phi_8026_ = -(_e10891[2]);
                                    } else {
                                        phi_8026_ = _e10891[2];
                                    }
                                    let _e10909 = phi_8026_;
                                    if (_e10905 > _e10909) {
                                        phi_8031_ = _e10905;
                                    } else {
                                        phi_8031_ = _e10909;
                                    }
                                    let _e10912 = phi_8031_;
                                    if (_e10888 > _e10912) {
                                        phi_8036_ = _e10888;
                                    } else {
                                        phi_8036_ = _e10912;
                                    }
                                    let _e10915 = phi_8036_;
                                    let _e10917 = local_19.member_3;
                                    let _e10921 = local_19.member_2[0u];
                                    if (_e10921[0] < 0.0lf) {
                                        phi_8053_ = -(_e10921[0]);
                                    } else {
                                        phi_8053_ = _e10921[0];
                                    }
                                    let _e10928 = phi_8053_;
                                    if (_e10921[1] < 0.0lf) {
                                        phi_8060_ = -(_e10921[1]);
                                    } else {
                                        phi_8060_ = _e10921[1];
                                    }
                                    let _e10932 = phi_8060_;
                                    if (_e10928 > _e10932) {
                                        phi_8065_ = _e10928;
                                    } else {
                                        phi_8065_ = _e10932;
                                    }
                                    let _e10935 = phi_8065_;
                                    if (_e10921[2] < 0.0lf) {
                                        phi_8072_ = -(_e10921[2]);
                                    } else {
                                        phi_8072_ = _e10921[2];
                                    }
                                    let _e10939 = phi_8072_;
                                    if (_e10935 > _e10939) {
                                        phi_8077_ = _e10935;
                                    } else {
                                        phi_8077_ = _e10939;
                                    }
                                    let _e10942 = phi_8077_;
                                    let _e10945 = local_19.member_2[1u];
                                    if (_e10945[0] < 0.0lf) {
                                        phi_8091_ = -(_e10945[0]);
                                    } else {
                                        phi_8091_ = _e10945[0];
                                    }
                                    let _e10952 = phi_8091_;
                                    if (_e10945[1] < 0.0lf) {
                                        phi_8098_ = -(_e10945[1]);
                                    } else {
                                        phi_8098_ = _e10945[1];
                                    }
                                    let _e10956 = phi_8098_;
                                    if (_e10952 > _e10956) {
                                        phi_8103_ = _e10952;
                                    } else {
                                        phi_8103_ = _e10956;
                                    }
                                    let _e10959 = phi_8103_;
                                    if (_e10945[2] < 0.0lf) {
                                        phi_8110_ = -(_e10945[2]);
                                    } else {
                                        phi_8110_ = _e10945[2];
                                    }
                                    let _e10963 = phi_8110_;
                                    if (_e10959 > _e10963) {
                                        phi_8115_ = _e10959;
                                    } else {
                                        phi_8115_ = _e10963;
                                    }
                                    let _e10966 = phi_8115_;
                                    if (_e10942 > _e10966) {
                                        phi_8120_ = _e10942;
                                    } else {
                                        phi_8120_ = _e10966;
                                    }
                                    let _e10969 = phi_8120_;
                                    let _e10971 = local_19.member_3;
                                    let _e10979 = local_19.member_3;
                                    let _e10989 = (((_e10805 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e10861 + _e10863) + (_e10915 + _e10917)) + (_e10969 + _e10971)) * (1.1102230246251565e-16lf * f64(16f))) + (_e10979 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e851.member_1);
                                    if _e10989 {
                                        phi_8144_ = false;
                                    } else {
                                        phi_8144_ = true;
                                    }
                                    let _e10991 = phi_8144_;
                                    phi_8145_ = _e10991;
                                    phi_8146_ = _e10989;
                                } else {
                                    phi_8145_ = false;
                                    phi_8146_ = false;
                                }
                                let _e10993 = phi_8145_;
                                let _e10995 = phi_8146_;
                                local_64 = _e10995;
                                continue;
                                continuing {
                                    phi_7635_ = _e10659;
                                    break if !(_e10993);
                                }
                            }
                            let _e10998 = local_64;
                            if _e10998 {
                                if (_e10628 > _e565) {
                                    phi_8154_ = 1u;
                                } else {
                                    phi_8154_ = _e10630;
                                }
                                let _e11001 = phi_8154_;
                                phi_8158_ = type_46(type_45(1u, _e10628), _e11001);
                                phi_8159_ = false;
                            } else {
                                phi_8158_ = type_46();
                                phi_8159_ = true;
                            }
                            let _e11005 = phi_8158_;
                            let _e11007 = phi_8159_;
                            if _e11007 {
                                if (_e10628 > _e565) {
                                    phi_8167_ = 0u;
                                } else {
                                    phi_8167_ = _e10630;
                                }
                                let _e11010 = phi_8167_;
                                phi_8171_ = type_46(type_45(2u, _e10628), _e11010);
                            } else {
                                phi_8171_ = _e11005;
                            }
                            let _e11014 = phi_8171_;
                            phi_8172_ = _e11014;
                            phi_8173_ = false;
                            phi_8174_ = false;
                        } else {
                            phi_8172_ = type_46();
                            phi_8173_ = _e10634;
                            phi_8174_ = _e10636;
                        }
                        let _e11016 = phi_8172_;
                        let _e11018 = phi_8173_;
                        let _e11020 = phi_8174_;
                        if _e11018 {
                            phi_8181_ = type_46(type_45(0u, f64()), 0u);
                            phi_8182_ = true;
                        } else {
                            phi_8181_ = _e10606;
                            phi_8182_ = _e11020;
                        }
                        let _e11024 = phi_8181_;
                        let _e11026 = phi_8182_;
                        phi_8186_ = _e11024;
                        phi_8187_ = _e11016;
                        phi_8188_ = _e11026;
                    } else {
                        phi_8186_ = _e7148;
                        phi_8187_ = type_46();
                        phi_8188_ = true;
                    }
                    let _e11028 = phi_8186_;
                    let _e11030 = phi_8187_;
                    let _e11032 = phi_8188_;
                    if _e11032 {
                        phi_8192_ = _e11028;
                    } else {
                        phi_8192_ = _e11030;
                    }
                    let _e11034 = phi_8192_;
                    phi_16016_ = _e11034;
                } else {
                    let _e894 = f64(0f);
                    let _e897 = local_19.member_1[0u];
                    let _e903 = local_19.member_2[0u];
                    let _e909 = ((_e897[1] * _e903[2]) - (_e897[2] * _e903[1]));
                    let _e912 = ((_e897[2] * _e903[0]) - (_e897[0] * _e903[2]));
                    let _e915 = ((_e897[0] * _e903[1]) - (_e897[1] * _e903[0]));
                    let _e918 = local_19.member_1[1u];
                    let _e924 = local_19.member_2[1u];
                    let _e930 = ((_e918[1] * _e924[2]) - (_e918[2] * _e924[1]));
                    let _e933 = ((_e918[2] * _e924[0]) - (_e918[0] * _e924[2]));
                    let _e936 = ((_e918[0] * _e924[1]) - (_e918[1] * _e924[0]));
                    let _e939 = local_19.member_1[0u];
                    let _e945 = local_19.member_2[1u];
                    let _e960 = local_19.member_1[1u];
                    let _e966 = local_19.member_2[0u];
                    let _e979 = (((_e939[1] * _e945[2]) - (_e939[2] * _e945[1])) + ((_e960[1] * _e966[2]) - (_e960[2] * _e966[1])));
                    let _e980 = (((_e939[2] * _e945[0]) - (_e939[0] * _e945[2])) + ((_e960[2] * _e966[0]) - (_e960[0] * _e966[2])));
                    let _e981 = (((_e939[0] * _e945[1]) - (_e939[1] * _e945[0])) + ((_e960[0] * _e966[1]) - (_e960[1] * _e966[0])));
                    let _e984 = local_19.member[0u];
                    let _e992 = (((_e984[0] * _e909) + (_e984[1] * _e912)) + (_e984[2] * _e915));
                    let _e995 = local_19.member[1u];
                    let _e1006 = local_19.member[0u];
                    let _e1015 = ((((_e995[0] * _e909) + (_e995[1] * _e912)) + (_e995[2] * _e915)) + (((_e1006[0] * _e979) + (_e1006[1] * _e980)) + (_e1006[2] * _e981)));
                    let _e1018 = local_19.member[0u];
                    let _e1029 = local_19.member[1u];
                    let _e1038 = ((((_e1018[0] * _e930) + (_e1018[1] * _e933)) + (_e1018[2] * _e936)) + (((_e1029[0] * _e979) + (_e1029[1] * _e980)) + (_e1029[2] * _e981)));
                    let _e1041 = local_19.member[1u];
                    let _e1049 = (((_e1041[0] * _e930) + (_e1041[1] * _e933)) + (_e1041[2] * _e936));
                    let _e1052 = local_19.member[0u];
                    if (_e1052[0] < 0.0lf) {
                        phi_8436_ = -(_e1052[0]);
                    } else {
                        phi_8436_ = _e1052[0];
                    }
                    let _e1059 = phi_8436_;
                    if (_e1052[1] < 0.0lf) {
                        phi_8443_ = -(_e1052[1]);
                    } else {
                        phi_8443_ = _e1052[1];
                    }
                    let _e1063 = phi_8443_;
                    if (_e1059 > _e1063) {
                        phi_8448_ = _e1059;
                    } else {
                        phi_8448_ = _e1063;
                    }
                    let _e1066 = phi_8448_;
                    if (_e1052[2] < 0.0lf) {
                        phi_8455_ = -(_e1052[2]);
                    } else {
                        phi_8455_ = _e1052[2];
                    }
                    let _e1070 = phi_8455_;
                    if (_e1066 > _e1070) {
                        phi_8460_ = _e1066;
                    } else {
                        phi_8460_ = _e1070;
                    }
                    let _e1073 = phi_8460_;
                    let _e1076 = local_19.member[1u];
                    if (_e1076[0] < 0.0lf) {
                        phi_8473_ = -(_e1076[0]);
                    } else {
                        phi_8473_ = _e1076[0];
                    }
                    let _e1083 = phi_8473_;
                    if (_e1076[1] < 0.0lf) {
                        phi_8480_ = -(_e1076[1]);
                    } else {
                        phi_8480_ = _e1076[1];
                    }
                    let _e1087 = phi_8480_;
                    if (_e1083 > _e1087) {
                        phi_8485_ = _e1083;
                    } else {
                        phi_8485_ = _e1087;
                    }
                    let _e1090 = phi_8485_;
                    if (_e1076[2] < 0.0lf) {
                        phi_8492_ = -(_e1076[2]);
                    } else {
                        phi_8492_ = _e1076[2];
                    }
                    let _e1094 = phi_8492_;
                    if (_e1090 > _e1094) {
                        phi_8497_ = _e1090;
                    } else {
                        phi_8497_ = _e1094;
                    }
                    let _e1097 = phi_8497_;
                    if (_e1073 > _e1097) {
                        phi_8502_ = _e1073;
                    } else {
                        phi_8502_ = _e1097;
                    }
                    let _e1100 = phi_8502_;
                    let _e1102 = local_19.member_3;
                    let _e1103 = (_e1100 + _e1102);
                    let _e1106 = local_19.member_1[0u];
                    if (_e1106[0] < 0.0lf) {
                        phi_8519_ = -(_e1106[0]);
                    } else {
                        phi_8519_ = _e1106[0];
                    }
                    let _e1113 = phi_8519_;
                    if (_e1106[1] < 0.0lf) {
                        phi_8526_ = -(_e1106[1]);
                    } else {
                        phi_8526_ = _e1106[1];
                    }
                    let _e1117 = phi_8526_;
                    if (_e1113 > _e1117) {
                        phi_8531_ = _e1113;
                    } else {
                        phi_8531_ = _e1117;
                    }
                    let _e1120 = phi_8531_;
                    if (_e1106[2] < 0.0lf) {
                        phi_8538_ = -(_e1106[2]);
                    } else {
                        phi_8538_ = _e1106[2];
                    }
                    let _e1124 = phi_8538_;
                    if (_e1120 > _e1124) {
                        phi_8543_ = _e1120;
                    } else {
                        phi_8543_ = _e1124;
                    }
                    let _e1127 = phi_8543_;
                    let _e1130 = local_19.member_1[1u];
                    if (_e1130[0] < 0.0lf) {
                        phi_8557_ = -(_e1130[0]);
                    } else {
                        phi_8557_ = _e1130[0];
                    }
                    let _e1137 = phi_8557_;
                    if (_e1130[1] < 0.0lf) {
                        phi_8564_ = -(_e1130[1]);
                    } else {
                        phi_8564_ = _e1130[1];
                    }
                    let _e1141 = phi_8564_;
                    if (_e1137 > _e1141) {
                        phi_8569_ = _e1137;
                    } else {
                        phi_8569_ = _e1141;
                    }
                    let _e1144 = phi_8569_;
                    if (_e1130[2] < 0.0lf) {
                        phi_8576_ = -(_e1130[2]);
                    } else {
                        phi_8576_ = _e1130[2];
                    }
                    let _e1148 = phi_8576_;
                    if (_e1144 > _e1148) {
                        phi_8581_ = _e1144;
                    } else {
                        phi_8581_ = _e1148;
                    }
                    let _e1151 = phi_8581_;
                    if (_e1127 > _e1151) {
                        phi_8586_ = _e1127;
                    } else {
                        phi_8586_ = _e1151;
                    }
                    let _e1154 = phi_8586_;
                    let _e1156 = local_19.member_3;
                    let _e1157 = (_e1154 + _e1156);
                    let _e1160 = local_19.member_2[0u];
                    if (_e1160[0] < 0.0lf) {
                        phi_8603_ = -(_e1160[0]);
                    } else {
                        phi_8603_ = _e1160[0];
                    }
                    let _e1167 = phi_8603_;
                    if (_e1160[1] < 0.0lf) {
                        phi_8610_ = -(_e1160[1]);
                    } else {
                        phi_8610_ = _e1160[1];
                    }
                    let _e1171 = phi_8610_;
                    if (_e1167 > _e1171) {
                        phi_8615_ = _e1167;
                    } else {
                        phi_8615_ = _e1171;
                    }
                    let _e1174 = phi_8615_;
                    if (_e1160[2] < 0.0lf) {
                        phi_8622_ = -(_e1160[2]);
                    } else {
                        phi_8622_ = _e1160[2];
                    }
                    let _e1178 = phi_8622_;
                    if (_e1174 > _e1178) {
                        phi_8627_ = _e1174;
                    } else {
                        phi_8627_ = _e1178;
                    }
                    let _e1181 = phi_8627_;
                    let _e1184 = local_19.member_2[1u];
                    if (_e1184[0] < 0.0lf) {
                        phi_8641_ = -(_e1184[0]);
                    } else {
                        phi_8641_ = _e1184[0];
                    }
                    let _e1191 = phi_8641_;
                    if (_e1184[1] < 0.0lf) {
                        phi_8648_ = -(_e1184[1]);
                    } else {
                        phi_8648_ = _e1184[1];
                    }
                    let _e1195 = phi_8648_;
                    if (_e1191 > _e1195) {
                        phi_8653_ = _e1191;
                    } else {
                        phi_8653_ = _e1195;
                    }
                    let _e1198 = phi_8653_;
                    if (_e1184[2] < 0.0lf) {
                        phi_8660_ = -(_e1184[2]);
                    } else {
                        phi_8660_ = _e1184[2];
                    }
                    let _e1202 = phi_8660_;
                    if (_e1198 > _e1202) {
                        phi_8665_ = _e1198;
                    } else {
                        phi_8665_ = _e1202;
                    }
                    let _e1205 = phi_8665_;
                    if (_e1181 > _e1205) {
                        phi_8670_ = _e1181;
                    } else {
                        phi_8670_ = _e1205;
                    }
                    let _e1208 = phi_8670_;
                    let _e1210 = local_19.member_3;
                    let _e1211 = (_e1208 + _e1210);
                    let _e1212 = f64(1f);
                    let _e1213 = f64(8f);
                    let _e1215 = ((_e1157 * _e1213) * _e1211);
                    let _e1223 = local_19.member_3;
                    if (_e909 < 0.0lf) {
                        phi_8707_ = -(_e909);
                    } else {
                        phi_8707_ = _e909;
                    }
                    let _e1243 = phi_8707_;
                    if (_e912 < 0.0lf) {
                        phi_8713_ = -(_e912);
                    } else {
                        phi_8713_ = _e912;
                    }
                    let _e1247 = phi_8713_;
                    if (_e915 < 0.0lf) {
                        phi_8720_ = -(_e915);
                    } else {
                        phi_8720_ = _e915;
                    }
                    let _e1252 = phi_8720_;
                    let _e1253 = ((_e1243 + _e1247) + _e1252);
                    if (_e930 < 0.0lf) {
                        phi_8727_ = -(_e930);
                    } else {
                        phi_8727_ = _e930;
                    }
                    let _e1257 = phi_8727_;
                    if (_e933 < 0.0lf) {
                        phi_8733_ = -(_e933);
                    } else {
                        phi_8733_ = _e933;
                    }
                    let _e1261 = phi_8733_;
                    if (_e936 < 0.0lf) {
                        phi_8740_ = -(_e936);
                    } else {
                        phi_8740_ = _e936;
                    }
                    let _e1266 = phi_8740_;
                    let _e1267 = ((_e1257 + _e1261) + _e1266);
                    if (_e1253 > _e1267) {
                        phi_8746_ = _e1253;
                    } else {
                        phi_8746_ = _e1267;
                    }
                    let _e1270 = phi_8746_;
                    if (_e979 < 0.0lf) {
                        phi_8752_ = -(_e979);
                    } else {
                        phi_8752_ = _e979;
                    }
                    let _e1274 = phi_8752_;
                    if (_e980 < 0.0lf) {
                        phi_8758_ = -(_e980);
                    } else {
                        phi_8758_ = _e980;
                    }
                    let _e1278 = phi_8758_;
                    if (_e981 < 0.0lf) {
                        phi_8765_ = -(_e981);
                    } else {
                        phi_8765_ = _e981;
                    }
                    let _e1283 = phi_8765_;
                    let _e1285 = (((_e1274 + _e1278) + _e1283) * f64(0.5f));
                    if (_e1270 > _e1285) {
                        phi_8772_ = _e1270;
                    } else {
                        phi_8772_ = _e1285;
                    }
                    let _e1288 = phi_8772_;
                    let _e1294 = local_19.member_3;
                    let _e1308 = (((((_e1103 * _e1213) * _e1215) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1223 * f64(19f)) * ((_e1103 * (_e1157 + _e1211)) + (_e1157 * _e1211)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1212 + _e1103) * ((_e1212 + _e1157) * (_e1212 + _e1211)))));
                    let _e1309 = f64(3f);
                    let _e1310 = (_e992 * _e1309);
                    let _e1311 = (_e1049 * _e1309);
                    if (_e1310 < _e1311) {
                        phi_8800_ = _e1310;
                    } else {
                        phi_8800_ = _e1311;
                    }
                    let _e1314 = phi_8800_;
                    if (_e1015 < _e1038) {
                        phi_8805_ = _e1015;
                    } else {
                        phi_8805_ = _e1038;
                    }
                    let _e1317 = phi_8805_;
                    if (_e1314 < _e1317) {
                        phi_8810_ = _e1314;
                    } else {
                        phi_8810_ = _e1317;
                    }
                    let _e1320 = phi_8810_;
                    if (_e1310 > _e1311) {
                        phi_8815_ = _e1310;
                    } else {
                        phi_8815_ = _e1311;
                    }
                    let _e1323 = phi_8815_;
                    if (_e1015 > _e1038) {
                        phi_8820_ = _e1015;
                    } else {
                        phi_8820_ = _e1038;
                    }
                    let _e1326 = phi_8820_;
                    if (_e1323 > _e1326) {
                        phi_8825_ = _e1323;
                    } else {
                        phi_8825_ = _e1326;
                    }
                    let _e1329 = phi_8825_;
                    let _e1335 = -(_e1329);
                    if (_e1320 > _e1335) {
                        phi_8836_ = _e1320;
                    } else {
                        phi_8836_ = _e1335;
                    }
                    let _e1338 = phi_8836_;
                    if ((_e1338 - (_e1308 + ((_e894 * (((_e1288 + (_e1215 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1294 * f64(6f)) * (_e1157 + _e1211))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1212 + _e1157) * (_e1212 + _e1211))))) * f64((3f * 1.0001f))))) > _e894) {
                        phi_15986_ = type_45(0u, type_45().member_1);
                        phi_15987_ = type_45();
                        phi_15988_ = true;
                    } else {
                        if (_e992 < 0.0lf) {
                            phi_8850_ = -(_e992);
                        } else {
                            phi_8850_ = _e992;
                        }
                        let _e1346 = phi_8850_;
                        if (_e1015 < 0.0lf) {
                            phi_8856_ = -(_e1015);
                        } else {
                            phi_8856_ = _e1015;
                        }
                        let _e1350 = phi_8856_;
                        if (_e1346 > _e1350) {
                            phi_8861_ = _e1346;
                        } else {
                            phi_8861_ = _e1350;
                        }
                        let _e1353 = phi_8861_;
                        if (_e1038 < 0.0lf) {
                            phi_8867_ = -(_e1038);
                        } else {
                            phi_8867_ = _e1038;
                        }
                        let _e1357 = phi_8867_;
                        if (_e1049 < 0.0lf) {
                            phi_8873_ = -(_e1049);
                        } else {
                            phi_8873_ = _e1049;
                        }
                        let _e1361 = phi_8873_;
                        if (_e1357 > _e1361) {
                            phi_8878_ = _e1357;
                        } else {
                            phi_8878_ = _e1361;
                        }
                        let _e1364 = phi_8878_;
                        if (_e1353 > _e1364) {
                            phi_8883_ = _e1353;
                        } else {
                            phi_8883_ = _e1364;
                        }
                        let _e1367 = phi_8883_;
                        let _e1369 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1370 = f64(1f);
                        if (_e1367 >= _e1369) {
                            phi_8893_ = (_e1367 <= (_e1370 / _e1369));
                        } else {
                            phi_8893_ = false;
                        }
                        let _e1375 = phi_8893_;
                        if _e1375 {
                            phi_8900_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_8900_ = f64(2f);
                        }
                        let _e1380 = phi_8900_;
                        if _e1375 {
                            phi_8908_ = (_e1370 / _e1367);
                        } else {
                            phi_8908_ = f64(0f);
                        }
                        let _e1386 = phi_8908_;
                        let _e1387 = f64(0.00000000000022737368f);
                        let _e1389 = (_e556 * f64(0.0625f));
                        if (_e1387 < _e1389) {
                            phi_8916_ = _e1387;
                        } else {
                            phi_8916_ = _e1389;
                        }
                        let _e1392 = phi_8916_;
                        local_12 = type_40(array<f64, 4>(_e992, _e1015, _e1038, _e1049), ((_e1308 * f64(0.34f)) + (_e1367 * _e1380)), _e1386, _e1392);
                        let _e1396 = (f64(1f) - _e565);
                        let _e1399 = local_12.member[0u];
                        let _e1402 = local_12.member[1u];
                        let _e1405 = local_12.member[2u];
                        let _e1408 = local_12.member[3u];
                        let _e1419 = ((((_e1399 * _e1396) + (_e1402 * _e565)) * (_e1396 * _e1396)) + (((_e1405 * _e1396) + (_e1408 * _e565)) * (_e565 * _e565)));
                        if (_e1419 < 0.0lf) {
                            phi_8954_ = -(_e1419);
                        } else {
                            phi_8954_ = _e1419;
                        }
                        let _e1423 = phi_8954_;
                        let _e1425 = local_12.member_1;
                        if !((_e1423 > _e1425)) {
                            let _e1428 = f64(0f);
                            let _e1431 = local_19.member[0u];
                            let _e1438 = local_19.member_1[0u];
                            let _e1444 = local_19.member_2[0u];
                            let _e1448 = (_e1431[0] - _e1438[0]);
                            let _e1449 = (_e1431[1] - _e1438[1]);
                            let _e1450 = (_e1431[2] - _e1438[2]);
                            if (_e253.member == 0u) {
                                phi_9018_ = array<f64, 3>(_e1431[0], _e1431[1], _e1431[2]);
                            } else {
                                phi_9018_ = array<f64, 3>((_e1448 - _e1444[0]), (_e1449 - _e1444[1]), (_e1450 - _e1444[2]));
                            }
                            let _e1457 = phi_9018_;
                            let _e1458 = (_e1431[0] - _e1444[0]);
                            let _e1459 = (_e1431[1] - _e1444[1]);
                            let _e1460 = (_e1431[2] - _e1444[2]);
                            let _e1463 = local_19.member[1u];
                            let _e1470 = local_19.member_1[1u];
                            let _e1476 = local_19.member_2[1u];
                            let _e1480 = (_e1463[0] - _e1470[0]);
                            let _e1481 = (_e1463[1] - _e1470[1]);
                            let _e1482 = (_e1463[2] - _e1470[2]);
                            if (_e253.member == 0u) {
                                phi_9083_ = array<f64, 3>(_e1463[0], _e1463[1], _e1463[2]);
                            } else {
                                phi_9083_ = array<f64, 3>((_e1480 - _e1476[0]), (_e1481 - _e1476[1]), (_e1482 - _e1476[2]));
                            }
                            let _e1489 = phi_9083_;
                            let _e1490 = (_e1463[0] - _e1476[0]);
                            let _e1491 = (_e1463[1] - _e1476[1]);
                            let _e1492 = (_e1463[2] - _e1476[2]);
                            let _e1495 = local_19.member[0u];
                            if (_e1495[0] < 0.0lf) {
                                phi_9105_ = -(_e1495[0]);
                            } else {
                                phi_9105_ = _e1495[0];
                            }
                            let _e1502 = phi_9105_;
                            if (_e1495[1] < 0.0lf) {
                                phi_9112_ = -(_e1495[1]);
                            } else {
                                phi_9112_ = _e1495[1];
                            }
                            let _e1506 = phi_9112_;
                            if (_e1502 > _e1506) {
                                phi_9117_ = _e1502;
                            } else {
                                phi_9117_ = _e1506;
                            }
                            let _e1509 = phi_9117_;
                            if (_e1495[2] < 0.0lf) {
                                phi_9124_ = -(_e1495[2]);
                            } else {
                                phi_9124_ = _e1495[2];
                            }
                            let _e1513 = phi_9124_;
                            if (_e1509 > _e1513) {
                                phi_9129_ = _e1509;
                            } else {
                                phi_9129_ = _e1513;
                            }
                            let _e1516 = phi_9129_;
                            let _e1519 = local_19.member[1u];
                            if (_e1519[0] < 0.0lf) {
                                phi_9142_ = -(_e1519[0]);
                            } else {
                                phi_9142_ = _e1519[0];
                            }
                            let _e1526 = phi_9142_;
                            if (_e1519[1] < 0.0lf) {
                                phi_9149_ = -(_e1519[1]);
                            } else {
                                phi_9149_ = _e1519[1];
                            }
                            let _e1530 = phi_9149_;
                            if (_e1526 > _e1530) {
                                phi_9154_ = _e1526;
                            } else {
                                phi_9154_ = _e1530;
                            }
                            let _e1533 = phi_9154_;
                            if (_e1519[2] < 0.0lf) {
                                phi_9161_ = -(_e1519[2]);
                            } else {
                                phi_9161_ = _e1519[2];
                            }
                            let _e1537 = phi_9161_;
                            if (_e1533 > _e1537) {
                                phi_9166_ = _e1533;
                            } else {
                                phi_9166_ = _e1537;
                            }
                            let _e1540 = phi_9166_;
                            if (_e1516 > _e1540) {
                                phi_9171_ = _e1516;
                            } else {
                                phi_9171_ = _e1540;
                            }
                            let _e1543 = phi_9171_;
                            let _e1545 = local_19.member_3;
                            let _e1549 = local_19.member_1[0u];
                            if (_e1549[0] < 0.0lf) {
                                phi_9188_ = -(_e1549[0]);
                            } else {
                                phi_9188_ = _e1549[0];
                            }
                            let _e1556 = phi_9188_;
                            if (_e1549[1] < 0.0lf) {
                                phi_9195_ = -(_e1549[1]);
                            } else {
                                phi_9195_ = _e1549[1];
                            }
                            let _e1560 = phi_9195_;
                            if (_e1556 > _e1560) {
                                phi_9200_ = _e1556;
                            } else {
                                phi_9200_ = _e1560;
                            }
                            let _e1563 = phi_9200_;
                            if (_e1549[2] < 0.0lf) {
                                phi_9207_ = -(_e1549[2]);
                            } else {
                                phi_9207_ = _e1549[2];
                            }
                            let _e1567 = phi_9207_;
                            if (_e1563 > _e1567) {
                                phi_9212_ = _e1563;
                            } else {
                                phi_9212_ = _e1567;
                            }
                            let _e1570 = phi_9212_;
                            let _e1573 = local_19.member_1[1u];
                            if (_e1573[0] < 0.0lf) {
                                phi_9226_ = -(_e1573[0]);
                            } else {
                                phi_9226_ = _e1573[0];
                            }
                            let _e1580 = phi_9226_;
                            if (_e1573[1] < 0.0lf) {
                                phi_9233_ = -(_e1573[1]);
                            } else {
                                phi_9233_ = _e1573[1];
                            }
                            let _e1584 = phi_9233_;
                            if (_e1580 > _e1584) {
                                phi_9238_ = _e1580;
                            } else {
                                phi_9238_ = _e1584;
                            }
                            let _e1587 = phi_9238_;
                            if (_e1573[2] < 0.0lf) {
                                phi_9245_ = -(_e1573[2]);
                            } else {
                                phi_9245_ = _e1573[2];
                            }
                            let _e1591 = phi_9245_;
                            if (_e1587 > _e1591) {
                                phi_9250_ = _e1587;
                            } else {
                                phi_9250_ = _e1591;
                            }
                            let _e1594 = phi_9250_;
                            if (_e1570 > _e1594) {
                                phi_9255_ = _e1570;
                            } else {
                                phi_9255_ = _e1594;
                            }
                            let _e1597 = phi_9255_;
                            let _e1599 = local_19.member_3;
                            let _e1603 = local_19.member_2[0u];
                            if (_e1603[0] < 0.0lf) {
                                phi_9272_ = -(_e1603[0]);
                            } else {
                                phi_9272_ = _e1603[0];
                            }
                            let _e1610 = phi_9272_;
                            if (_e1603[1] < 0.0lf) {
                                phi_9279_ = -(_e1603[1]);
                            } else {
                                phi_9279_ = _e1603[1];
                            }
                            let _e1614 = phi_9279_;
                            if (_e1610 > _e1614) {
                                phi_9284_ = _e1610;
                            } else {
                                phi_9284_ = _e1614;
                            }
                            let _e1617 = phi_9284_;
                            if (_e1603[2] < 0.0lf) {
                                phi_9291_ = -(_e1603[2]);
                            } else {
                                phi_9291_ = _e1603[2];
                            }
                            let _e1621 = phi_9291_;
                            if (_e1617 > _e1621) {
                                phi_9296_ = _e1617;
                            } else {
                                phi_9296_ = _e1621;
                            }
                            let _e1624 = phi_9296_;
                            let _e1627 = local_19.member_2[1u];
                            if (_e1627[0] < 0.0lf) {
                                phi_9310_ = -(_e1627[0]);
                            } else {
                                phi_9310_ = _e1627[0];
                            }
                            let _e1634 = phi_9310_;
                            if (_e1627[1] < 0.0lf) {
                                phi_9317_ = -(_e1627[1]);
                            } else {
                                phi_9317_ = _e1627[1];
                            }
                            let _e1638 = phi_9317_;
                            if (_e1634 > _e1638) {
                                phi_9322_ = _e1634;
                            } else {
                                phi_9322_ = _e1638;
                            }
                            let _e1641 = phi_9322_;
                            if (_e1627[2] < 0.0lf) {
                                phi_9329_ = -(_e1627[2]);
                            } else {
                                phi_9329_ = _e1627[2];
                            }
                            let _e1645 = phi_9329_;
                            if (_e1641 > _e1645) {
                                phi_9334_ = _e1641;
                            } else {
                                phi_9334_ = _e1645;
                            }
                            let _e1648 = phi_9334_;
                            if (_e1624 > _e1648) {
                                phi_9339_ = _e1624;
                            } else {
                                phi_9339_ = _e1648;
                            }
                            let _e1651 = phi_9339_;
                            let _e1653 = local_19.member_3;
                            let _e1661 = local_19.member_3;
                            let _e1667 = ((((((_e1543 + _e1545) + (_e1597 + _e1599)) + (_e1651 + _e1653)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1661 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f)));
                            let _e1670 = local_19.member[0u];
                            let _e1676 = local_19.member[1u];
                            let _e1692 = local_19.member_1[0u];
                            let _e1698 = local_19.member_1[1u];
                            let _e1714 = local_19.member_2[0u];
                            let _e1720 = local_19.member_2[1u];
                            let _e1734 = function_5(array<f64, 3>((_e1670[0] + ((_e1676[0] - _e1670[0]) * _e565)), (_e1670[1] + ((_e1676[1] - _e1670[1]) * _e565)), (_e1670[2] + ((_e1676[2] - _e1670[2]) * _e565))), array<f64, 3>((_e1692[0] + ((_e1698[0] - _e1692[0]) * _e565)), (_e1692[1] + ((_e1698[1] - _e1692[1]) * _e565)), (_e1692[2] + ((_e1698[2] - _e1692[2]) * _e565))), array<f64, 3>((_e1714[0] + ((_e1720[0] - _e1714[0]) * _e565)), (_e1714[1] + ((_e1720[1] - _e1714[1]) * _e565)), (_e1714[2] + ((_e1720[2] - _e1714[2]) * _e565))), _e253.member);
                            if (_e1734[0] < 0.0lf) {
                                phi_9460_ = -(_e1734[0]);
                            } else {
                                phi_9460_ = _e1734[0];
                            }
                            let _e1739 = phi_9460_;
                            if (_e1734[1] < 0.0lf) {
                                phi_9467_ = -(_e1734[1]);
                            } else {
                                phi_9467_ = _e1734[1];
                            }
                            let _e1744 = phi_9467_;
                            if (_e1734[2] < 0.0lf) {
                                phi_9475_ = -(_e1734[2]);
                            } else {
                                phi_9475_ = _e1734[2];
                            }
                            let _e1750 = phi_9475_;
                            let _e1751 = ((_e1739 + _e1744) + _e1750);
                            if (_e1751 > f64(0f)) {
                                if ((bitcast<u64>(_e1751) & 9218868437227405312lu) != 9218868437227405312lu) {
                                    let _e1758 = (f64(1f) / _e1751);
                                    let _e1760 = (_e1734[0] * _e1758);
                                    let _e1762 = (_e1734[1] * _e1758);
                                    let _e1764 = (_e1734[2] * _e1758);
                                    let _e1769 = (((_e1760 * _e1760) + (_e1762 * _e1762)) + (_e1764 * _e1764));
                                    if (_e1769 <= 2.2250738585072014e-308lf) {
                                        if (_e1769 > 0.0lf) {
                                            phi_9514_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_9514_ = 0.0lf;
                                        }
                                        let _e1821 = phi_9514_;
                                        phi_9578_ = _e1821;
                                    } else {
                                        phi_9521_ = type_18(0i, 5i);
                                        phi_9524_ = bitcast<f64>(((bitcast<u64>(_e1769) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1776 = phi_9521_;
                                            let _e1778 = phi_9524_;
                                            local_20 = _e1778;
                                            if (_e1776.member < _e1776.member_1) {
                                                let _e1785 = (_e1776.member + 1i);
                                                if ((false == (_e1785 > _e1776.member)) != false) {
                                                    phi_9545_ = true;
                                                } else {
                                                    phi_9545_ = false;
                                                }
                                                let _e1790 = phi_9545_;
                                                if _e1790 {
                                                    phi_9551_ = type_19(0u, type_19().member_1);
                                                } else {
                                                    phi_9551_ = type_19(1u, _e1785);
                                                }
                                                let _e1795 = phi_9551_;
                                                phi_9522_ = type_18(_e1795.member_1, _e1776.member_1);
                                                phi_9565_ = type_19(1u, _e1776.member);
                                            } else {
                                                phi_9522_ = _e1776;
                                                phi_9565_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1801 = phi_9522_;
                                            let _e1803 = phi_9565_;
                                            let _e1806 = (bitcast<i32>(_e1803.member) != 0i);
                                            if _e1806 {
                                                phi_9525_ = (0.5lf * (_e1778 + (_e1769 / _e1778)));
                                            } else {
                                                phi_9525_ = f64();
                                            }
                                            let _e1811 = phi_9525_;
                                            continue;
                                            continuing {
                                                phi_9521_ = _e1801;
                                                phi_9524_ = _e1811;
                                                break if !(_e1806);
                                            }
                                        }
                                        let _e1816 = local_20;
                                        phi_9578_ = (_e1816 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1823 = phi_9578_;
                                    let _e1825 = (1.1102230246251565e-16lf * f64(12f));
                                    let _e1832 = ((_e1667 * f64(1.01f)) + ((_e1428 * _e1823) * (f64(1f) + _e1825)));
                                    let _e1837 = (((_e1760 * _e1431[0]) + (_e1762 * _e1431[1])) + (_e1764 * _e1431[2]));
                                    let _e1842 = (((_e1760 * _e1448) + (_e1762 * _e1449)) + (_e1764 * _e1450));
                                    let _e1847 = (((_e1760 * _e1458) + (_e1762 * _e1459)) + (_e1764 * _e1460));
                                    let _e1855 = (((_e1760 * _e1457[0]) + (_e1762 * _e1457[1])) + (_e1764 * _e1457[2]));
                                    let _e1861 = (((_e1760 * _e1463[0]) + (_e1762 * _e1463[1])) + (_e1764 * _e1463[2]));
                                    let _e1866 = (((_e1760 * _e1480) + (_e1762 * _e1481)) + (_e1764 * _e1482));
                                    let _e1871 = (((_e1760 * _e1490) + (_e1762 * _e1491)) + (_e1764 * _e1492));
                                    let _e1879 = (((_e1760 * _e1489[0]) + (_e1762 * _e1489[1])) + (_e1764 * _e1489[2]));
                                    if (_e1837 < 0.0lf) {
                                        phi_9647_ = -(_e1837);
                                    } else {
                                        phi_9647_ = _e1837;
                                    }
                                    let _e1884 = phi_9647_;
                                    if (_e1861 < 0.0lf) {
                                        phi_9653_ = -(_e1861);
                                    } else {
                                        phi_9653_ = _e1861;
                                    }
                                    let _e1888 = phi_9653_;
                                    if (_e1842 < 0.0lf) {
                                        phi_9662_ = -(_e1842);
                                    } else {
                                        phi_9662_ = _e1842;
                                    }
                                    let _e1895 = phi_9662_;
                                    if (_e1866 < 0.0lf) {
                                        phi_9668_ = -(_e1866);
                                    } else {
                                        phi_9668_ = _e1866;
                                    }
                                    let _e1899 = phi_9668_;
                                    if (_e1847 < 0.0lf) {
                                        phi_9677_ = -(_e1847);
                                    } else {
                                        phi_9677_ = _e1847;
                                    }
                                    let _e1906 = phi_9677_;
                                    if (_e1871 < 0.0lf) {
                                        phi_9683_ = -(_e1871);
                                    } else {
                                        phi_9683_ = _e1871;
                                    }
                                    let _e1910 = phi_9683_;
                                    if (_e1855 < 0.0lf) {
                                        phi_9692_ = -(_e1855);
                                    } else {
                                        phi_9692_ = _e1855;
                                    }
                                    let _e1917 = phi_9692_;
                                    if (_e1879 < 0.0lf) {
                                        phi_9698_ = -(_e1879);
                                    } else {
                                        phi_9698_ = _e1879;
                                    }
                                    let _e1921 = phi_9698_;
                                    phi_9704_ = type_35(array<f64, 4>(_e1837, _e1842, _e1847, _e1855), array<f64, 4>(_e1861, _e1866, _e1871, _e1879), array<f64, 4>((_e1832 + ((_e1884 + _e1888) * _e1825)), (_e1832 + ((_e1895 + _e1899) * _e1825)), (_e1832 + ((_e1906 + _e1910) * _e1825)), (_e1832 + ((_e1917 + _e1921) * _e1825))));
                                    phi_9705_ = false;
                                } else {
                                    phi_9704_ = type_35();
                                    phi_9705_ = true;
                                }
                                let _e1928 = phi_9704_;
                                let _e1930 = phi_9705_;
                                phi_9706_ = _e1928;
                                phi_9707_ = _e1930;
                            } else {
                                phi_9706_ = type_35();
                                phi_9707_ = true;
                            }
                            let _e1932 = phi_9706_;
                            let _e1934 = phi_9707_;
                            if _e1934 {
                                let _e1935 = f64(0f);
                                let _e1936 = f64(1f);
                                phi_9717_ = type_35(array<f64, 4>(_e1935, _e1935, _e1935, _e1935), array<f64, 4>(_e1935, _e1935, _e1935, _e1935), array<f64, 4>(_e1936, _e1936, _e1936, _e1936));
                            } else {
                                phi_9717_ = _e1932;
                            }
                            let _e1942 = phi_9717_;
                            local_8 = type_35(array<f64, 4>(_e1942.member[0], _e1942.member[1], _e1942.member[2], _e1942.member[3]), array<f64, 4>(_e1942.member_1[0], _e1942.member_1[1], _e1942.member_1[2], _e1942.member_1[3]), array<f64, 4>(_e1942.member_2[0], _e1942.member_2[1], _e1942.member_2[2], _e1942.member_2[3]));
                            let _e1962 = f64(0f);
                            let _e1965 = local_8.member[0u];
                            let _e1968 = local_8.member_1[0u];
                            let _e1971 = local_8.member[0u];
                            let _e1977 = local_8.member_2[0u];
                            if (((_e1965 + ((_e1968 - _e1971) * _e565)) - _e1977) > _e1962) {
                                let _e1982 = local_8.member[1u];
                                let _e1985 = local_8.member_1[1u];
                                let _e1988 = local_8.member[1u];
                                let _e1994 = local_8.member_2[1u];
                                if (((_e1982 + ((_e1985 - _e1988) * _e565)) - _e1994) > _e1962) {
                                    let _e1999 = local_8.member[2u];
                                    let _e2002 = local_8.member_1[2u];
                                    let _e2005 = local_8.member[2u];
                                    let _e2011 = local_8.member_2[2u];
                                    if (((_e1999 + ((_e2002 - _e2005) * _e565)) - _e2011) > _e1962) {
                                        let _e2016 = local_8.member[3u];
                                        let _e2019 = local_8.member_1[3u];
                                        let _e2022 = local_8.member[3u];
                                        let _e2028 = local_8.member_2[3u];
                                        phi_9887_ = (((_e2016 + ((_e2019 - _e2022) * _e565)) - _e2028) > _e1962);
                                        phi_9888_ = false;
                                    } else {
                                        phi_9887_ = bool();
                                        phi_9888_ = true;
                                    }
                                    let _e2032 = phi_9887_;
                                    let _e2034 = phi_9888_;
                                    phi_9889_ = _e2032;
                                    phi_9890_ = _e2034;
                                } else {
                                    phi_9889_ = bool();
                                    phi_9890_ = true;
                                }
                                let _e2036 = phi_9889_;
                                let _e2038 = phi_9890_;
                                phi_9891_ = _e2036;
                                phi_9892_ = _e2038;
                            } else {
                                phi_9891_ = bool();
                                phi_9892_ = true;
                            }
                            let _e2040 = phi_9891_;
                            let _e2042 = phi_9892_;
                            if _e2042 {
                                phi_9896_ = false;
                            } else {
                                phi_9896_ = _e2040;
                            }
                            let _e2044 = phi_9896_;
                            if _e2044 {
                                phi_11277_ = bool();
                                phi_11278_ = true;
                            } else {
                                let _e2045 = f64(0f);
                                if (_e1734[0] < 0.0lf) {
                                    phi_9924_ = -(_e1734[0]);
                                } else {
                                    phi_9924_ = _e1734[0];
                                }
                                let _e2050 = phi_9924_;
                                if (_e2045 < 0.0lf) {
                                    phi_9930_ = -(_e2045);
                                } else {
                                    phi_9930_ = _e2045;
                                }
                                let _e2054 = phi_9930_;
                                if (_e2045 < 0.0lf) {
                                    phi_9937_ = -(_e2045);
                                } else {
                                    phi_9937_ = _e2045;
                                }
                                let _e2059 = phi_9937_;
                                let _e2060 = ((_e2050 + _e2054) + _e2059);
                                if (_e2060 > f64(0f)) {
                                    if ((bitcast<u64>(_e2060) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e2067 = (f64(1f) / _e2060);
                                        let _e2068 = (_e1734[0] * _e2067);
                                        let _e2069 = (_e2045 * _e2067);
                                        let _e2070 = (_e2045 * _e2067);
                                        let _e2075 = (((_e2068 * _e2068) + (_e2069 * _e2069)) + (_e2070 * _e2070));
                                        if (_e2075 <= 2.2250738585072014e-308lf) {
                                            if (_e2075 > 0.0lf) {
                                                phi_9973_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_9973_ = 0.0lf;
                                            }
                                            let _e2127 = phi_9973_;
                                            phi_10037_ = _e2127;
                                        } else {
                                            phi_9980_ = type_18(0i, 5i);
                                            phi_9983_ = bitcast<f64>(((bitcast<u64>(_e2075) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e2082 = phi_9980_;
                                                let _e2084 = phi_9983_;
                                                local_21 = _e2084;
                                                if (_e2082.member < _e2082.member_1) {
                                                    let _e2091 = (_e2082.member + 1i);
                                                    if ((false == (_e2091 > _e2082.member)) != false) {
                                                        phi_10004_ = true;
                                                    } else {
                                                        phi_10004_ = false;
                                                    }
                                                    let _e2096 = phi_10004_;
                                                    if _e2096 {
                                                        phi_10010_ = type_19(0u, type_19().member_1);
                                                    } else {
                                                        phi_10010_ = type_19(1u, _e2091);
                                                    }
                                                    let _e2101 = phi_10010_;
                                                    phi_9981_ = type_18(_e2101.member_1, _e2082.member_1);
                                                    phi_10024_ = type_19(1u, _e2082.member);
                                                } else {
                                                    phi_9981_ = _e2082;
                                                    phi_10024_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2107 = phi_9981_;
                                                let _e2109 = phi_10024_;
                                                let _e2112 = (bitcast<i32>(_e2109.member) != 0i);
                                                if _e2112 {
                                                    phi_9984_ = (0.5lf * (_e2084 + (_e2075 / _e2084)));
                                                } else {
                                                    phi_9984_ = f64();
                                                }
                                                let _e2117 = phi_9984_;
                                                continue;
                                                continuing {
                                                    phi_9980_ = _e2107;
                                                    phi_9983_ = _e2117;
                                                    break if !(_e2112);
                                                }
                                            }
                                            let _e2122 = local_21;
                                            phi_10037_ = (_e2122 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e2129 = phi_10037_;
                                        let _e2131 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e2138 = ((_e1667 * f64(1.01f)) + ((_e1428 * _e2129) * (f64(1f) + _e2131)));
                                        let _e2143 = (((_e2068 * _e1431[0]) + (_e2069 * _e1431[1])) + (_e2070 * _e1431[2]));
                                        let _e2148 = (((_e2068 * _e1448) + (_e2069 * _e1449)) + (_e2070 * _e1450));
                                        let _e2153 = (((_e2068 * _e1458) + (_e2069 * _e1459)) + (_e2070 * _e1460));
                                        let _e2161 = (((_e2068 * _e1457[0]) + (_e2069 * _e1457[1])) + (_e2070 * _e1457[2]));
                                        let _e2167 = (((_e2068 * _e1463[0]) + (_e2069 * _e1463[1])) + (_e2070 * _e1463[2]));
                                        let _e2172 = (((_e2068 * _e1480) + (_e2069 * _e1481)) + (_e2070 * _e1482));
                                        let _e2177 = (((_e2068 * _e1490) + (_e2069 * _e1491)) + (_e2070 * _e1492));
                                        let _e2185 = (((_e2068 * _e1489[0]) + (_e2069 * _e1489[1])) + (_e2070 * _e1489[2]));
                                        if (_e2143 < 0.0lf) {
                                            phi_10106_ = -(_e2143);
                                        } else {
                                            phi_10106_ = _e2143;
                                        }
                                        let _e2190 = phi_10106_;
                                        if (_e2167 < 0.0lf) {
                                            phi_10112_ = -(_e2167);
                                        } else {
                                            phi_10112_ = _e2167;
                                        }
                                        let _e2194 = phi_10112_;
                                        if (_e2148 < 0.0lf) {
                                            phi_10121_ = -(_e2148);
                                        } else {
                                            phi_10121_ = _e2148;
                                        }
                                        let _e2201 = phi_10121_;
                                        if (_e2172 < 0.0lf) {
                                            phi_10127_ = -(_e2172);
                                        } else {
                                            phi_10127_ = _e2172;
                                        }
                                        let _e2205 = phi_10127_;
                                        if (_e2153 < 0.0lf) {
                                            phi_10136_ = -(_e2153);
                                        } else {
                                            phi_10136_ = _e2153;
                                        }
                                        let _e2212 = phi_10136_;
                                        if (_e2177 < 0.0lf) {
                                            phi_10142_ = -(_e2177);
                                        } else {
                                            phi_10142_ = _e2177;
                                        }
                                        let _e2216 = phi_10142_;
                                        if (_e2161 < 0.0lf) {
                                            phi_10151_ = -(_e2161);
                                        } else {
                                            phi_10151_ = _e2161;
                                        }
                                        let _e2223 = phi_10151_;
                                        if (_e2185 < 0.0lf) {
                                            phi_10157_ = -(_e2185);
                                        } else {
                                            phi_10157_ = _e2185;
                                        }
                                        let _e2227 = phi_10157_;
                                        phi_10163_ = type_35(array<f64, 4>(_e2143, _e2148, _e2153, _e2161), array<f64, 4>(_e2167, _e2172, _e2177, _e2185), array<f64, 4>((_e2138 + ((_e2190 + _e2194) * _e2131)), (_e2138 + ((_e2201 + _e2205) * _e2131)), (_e2138 + ((_e2212 + _e2216) * _e2131)), (_e2138 + ((_e2223 + _e2227) * _e2131))));
                                        phi_10164_ = false;
                                    } else {
                                        phi_10163_ = type_35();
                                        phi_10164_ = true;
                                    }
                                    let _e2234 = phi_10163_;
                                    let _e2236 = phi_10164_;
                                    phi_10165_ = _e2234;
                                    phi_10166_ = _e2236;
                                } else {
                                    phi_10165_ = type_35();
                                    phi_10166_ = true;
                                }
                                let _e2238 = phi_10165_;
                                let _e2240 = phi_10166_;
                                if _e2240 {
                                    let _e2241 = f64(0f);
                                    let _e2242 = f64(1f);
                                    phi_10176_ = type_35(array<f64, 4>(_e2241, _e2241, _e2241, _e2241), array<f64, 4>(_e2241, _e2241, _e2241, _e2241), array<f64, 4>(_e2242, _e2242, _e2242, _e2242));
                                } else {
                                    phi_10176_ = _e2238;
                                }
                                let _e2248 = phi_10176_;
                                local_9 = type_35(array<f64, 4>(_e2248.member[0], _e2248.member[1], _e2248.member[2], _e2248.member[3]), array<f64, 4>(_e2248.member_1[0], _e2248.member_1[1], _e2248.member_1[2], _e2248.member_1[3]), array<f64, 4>(_e2248.member_2[0], _e2248.member_2[1], _e2248.member_2[2], _e2248.member_2[3]));
                                let _e2268 = f64(0f);
                                let _e2271 = local_9.member[0u];
                                let _e2274 = local_9.member_1[0u];
                                let _e2277 = local_9.member[0u];
                                let _e2283 = local_9.member_2[0u];
                                if (((_e2271 + ((_e2274 - _e2277) * _e565)) - _e2283) > _e2268) {
                                    let _e2288 = local_9.member[1u];
                                    let _e2291 = local_9.member_1[1u];
                                    let _e2294 = local_9.member[1u];
                                    let _e2300 = local_9.member_2[1u];
                                    if (((_e2288 + ((_e2291 - _e2294) * _e565)) - _e2300) > _e2268) {
                                        let _e2305 = local_9.member[2u];
                                        let _e2308 = local_9.member_1[2u];
                                        let _e2311 = local_9.member[2u];
                                        let _e2317 = local_9.member_2[2u];
                                        if (((_e2305 + ((_e2308 - _e2311) * _e565)) - _e2317) > _e2268) {
                                            let _e2322 = local_9.member[3u];
                                            let _e2325 = local_9.member_1[3u];
                                            let _e2328 = local_9.member[3u];
                                            let _e2334 = local_9.member_2[3u];
                                            phi_10346_ = (((_e2322 + ((_e2325 - _e2328) * _e565)) - _e2334) > _e2268);
                                            phi_10347_ = false;
                                        } else {
                                            phi_10346_ = bool();
                                            phi_10347_ = true;
                                        }
                                        let _e2338 = phi_10346_;
                                        let _e2340 = phi_10347_;
                                        phi_10348_ = _e2338;
                                        phi_10349_ = _e2340;
                                    } else {
                                        phi_10348_ = bool();
                                        phi_10349_ = true;
                                    }
                                    let _e2342 = phi_10348_;
                                    let _e2344 = phi_10349_;
                                    phi_10350_ = _e2342;
                                    phi_10351_ = _e2344;
                                } else {
                                    phi_10350_ = bool();
                                    phi_10351_ = true;
                                }
                                let _e2346 = phi_10350_;
                                let _e2348 = phi_10351_;
                                if _e2348 {
                                    phi_10355_ = false;
                                } else {
                                    phi_10355_ = _e2346;
                                }
                                let _e2350 = phi_10355_;
                                if _e2350 {
                                    phi_11275_ = bool();
                                    phi_11276_ = true;
                                } else {
                                    let _e2351 = f64(0f);
                                    if (_e2351 < 0.0lf) {
                                        phi_10383_ = -(_e2351);
                                    } else {
                                        phi_10383_ = _e2351;
                                    }
                                    let _e2356 = phi_10383_;
                                    if (_e1734[1] < 0.0lf) {
                                        phi_10389_ = -(_e1734[1]);
                                    } else {
                                        phi_10389_ = _e1734[1];
                                    }
                                    let _e2360 = phi_10389_;
                                    if (_e2351 < 0.0lf) {
                                        phi_10396_ = -(_e2351);
                                    } else {
                                        phi_10396_ = _e2351;
                                    }
                                    let _e2365 = phi_10396_;
                                    let _e2366 = ((_e2356 + _e2360) + _e2365);
                                    if (_e2366 > f64(0f)) {
                                        if ((bitcast<u64>(_e2366) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e2373 = (f64(1f) / _e2366);
                                            let _e2374 = (_e2351 * _e2373);
                                            let _e2375 = (_e1734[1] * _e2373);
                                            let _e2376 = (_e2351 * _e2373);
                                            let _e2381 = (((_e2374 * _e2374) + (_e2375 * _e2375)) + (_e2376 * _e2376));
                                            if (_e2381 <= 2.2250738585072014e-308lf) {
                                                if (_e2381 > 0.0lf) {
                                                    phi_10432_ = (1.464336215552873e-154lf * 2.0lf);
                                                } else {
                                                    phi_10432_ = 0.0lf;
                                                }
                                                let _e2433 = phi_10432_;
                                                phi_10496_ = _e2433;
                                            } else {
                                                phi_10439_ = type_18(0i, 5i);
                                                phi_10442_ = bitcast<f64>(((bitcast<u64>(_e2381) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e2388 = phi_10439_;
                                                    let _e2390 = phi_10442_;
                                                    local_22 = _e2390;
                                                    if (_e2388.member < _e2388.member_1) {
                                                        let _e2397 = (_e2388.member + 1i);
                                                        if ((false == (_e2397 > _e2388.member)) != false) {
                                                            phi_10463_ = true;
                                                        } else {
                                                            phi_10463_ = false;
                                                        }
                                                        let _e2402 = phi_10463_;
                                                        if _e2402 {
                                                            phi_10469_ = type_19(0u, type_19().member_1);
                                                        } else {
                                                            phi_10469_ = type_19(1u, _e2397);
                                                        }
                                                        let _e2407 = phi_10469_;
                                                        phi_10440_ = type_18(_e2407.member_1, _e2388.member_1);
                                                        phi_10483_ = type_19(1u, _e2388.member);
                                                    } else {
                                                        phi_10440_ = _e2388;
                                                        phi_10483_ = type_19(0u, type_19().member_1);
                                                    }
                                                    let _e2413 = phi_10440_;
                                                    let _e2415 = phi_10483_;
                                                    let _e2418 = (bitcast<i32>(_e2415.member) != 0i);
                                                    if _e2418 {
                                                        phi_10443_ = (0.5lf * (_e2390 + (_e2381 / _e2390)));
                                                    } else {
                                                        phi_10443_ = f64();
                                                    }
                                                    let _e2423 = phi_10443_;
                                                    continue;
                                                    continuing {
                                                        phi_10439_ = _e2413;
                                                        phi_10442_ = _e2423;
                                                        break if !(_e2418);
                                                    }
                                                }
                                                let _e2428 = local_22;
                                                phi_10496_ = (_e2428 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e2435 = phi_10496_;
                                            let _e2437 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e2444 = ((_e1667 * f64(1.01f)) + ((_e1428 * _e2435) * (f64(1f) + _e2437)));
                                            let _e2449 = (((_e2374 * _e1431[0]) + (_e2375 * _e1431[1])) + (_e2376 * _e1431[2]));
                                            let _e2454 = (((_e2374 * _e1448) + (_e2375 * _e1449)) + (_e2376 * _e1450));
                                            let _e2459 = (((_e2374 * _e1458) + (_e2375 * _e1459)) + (_e2376 * _e1460));
                                            let _e2467 = (((_e2374 * _e1457[0]) + (_e2375 * _e1457[1])) + (_e2376 * _e1457[2]));
                                            let _e2473 = (((_e2374 * _e1463[0]) + (_e2375 * _e1463[1])) + (_e2376 * _e1463[2]));
                                            let _e2478 = (((_e2374 * _e1480) + (_e2375 * _e1481)) + (_e2376 * _e1482));
                                            let _e2483 = (((_e2374 * _e1490) + (_e2375 * _e1491)) + (_e2376 * _e1492));
                                            let _e2491 = (((_e2374 * _e1489[0]) + (_e2375 * _e1489[1])) + (_e2376 * _e1489[2]));
                                            if (_e2449 < 0.0lf) {
                                                phi_10565_ = -(_e2449);
                                            } else {
                                                phi_10565_ = _e2449;
                                            }
                                            let _e2496 = phi_10565_;
                                            if (_e2473 < 0.0lf) {
                                                phi_10571_ = -(_e2473);
                                            } else {
                                                phi_10571_ = _e2473;
                                            }
                                            let _e2500 = phi_10571_;
                                            if (_e2454 < 0.0lf) {
                                                phi_10580_ = -(_e2454);
                                            } else {
                                                phi_10580_ = _e2454;
                                            }
                                            let _e2507 = phi_10580_;
                                            if (_e2478 < 0.0lf) {
                                                phi_10586_ = -(_e2478);
                                            } else {
                                                phi_10586_ = _e2478;
                                            }
                                            let _e2511 = phi_10586_;
                                            if (_e2459 < 0.0lf) {
                                                phi_10595_ = -(_e2459);
                                            } else {
                                                phi_10595_ = _e2459;
                                            }
                                            let _e2518 = phi_10595_;
                                            if (_e2483 < 0.0lf) {
                                                phi_10601_ = -(_e2483);
                                            } else {
                                                phi_10601_ = _e2483;
                                            }
                                            let _e2522 = phi_10601_;
                                            if (_e2467 < 0.0lf) {
                                                phi_10610_ = -(_e2467);
                                            } else {
                                                phi_10610_ = _e2467;
                                            }
                                            let _e2529 = phi_10610_;
                                            if (_e2491 < 0.0lf) {
                                                phi_10616_ = -(_e2491);
                                            } else {
                                                phi_10616_ = _e2491;
                                            }
                                            let _e2533 = phi_10616_;
                                            phi_10622_ = type_35(array<f64, 4>(_e2449, _e2454, _e2459, _e2467), array<f64, 4>(_e2473, _e2478, _e2483, _e2491), array<f64, 4>((_e2444 + ((_e2496 + _e2500) * _e2437)), (_e2444 + ((_e2507 + _e2511) * _e2437)), (_e2444 + ((_e2518 + _e2522) * _e2437)), (_e2444 + ((_e2529 + _e2533) * _e2437))));
                                            phi_10623_ = false;
                                        } else {
                                            phi_10622_ = type_35();
                                            phi_10623_ = true;
                                        }
                                        let _e2540 = phi_10622_;
                                        let _e2542 = phi_10623_;
                                        phi_10624_ = _e2540;
                                        phi_10625_ = _e2542;
                                    } else {
                                        phi_10624_ = type_35();
                                        phi_10625_ = true;
                                    }
                                    let _e2544 = phi_10624_;
                                    let _e2546 = phi_10625_;
                                    if _e2546 {
                                        let _e2547 = f64(0f);
                                        let _e2548 = f64(1f);
                                        phi_10635_ = type_35(array<f64, 4>(_e2547, _e2547, _e2547, _e2547), array<f64, 4>(_e2547, _e2547, _e2547, _e2547), array<f64, 4>(_e2548, _e2548, _e2548, _e2548));
                                    } else {
                                        phi_10635_ = _e2544;
                                    }
                                    let _e2554 = phi_10635_;
                                    local_10 = type_35(array<f64, 4>(_e2554.member[0], _e2554.member[1], _e2554.member[2], _e2554.member[3]), array<f64, 4>(_e2554.member_1[0], _e2554.member_1[1], _e2554.member_1[2], _e2554.member_1[3]), array<f64, 4>(_e2554.member_2[0], _e2554.member_2[1], _e2554.member_2[2], _e2554.member_2[3]));
                                    let _e2574 = f64(0f);
                                    let _e2577 = local_10.member[0u];
                                    let _e2580 = local_10.member_1[0u];
                                    let _e2583 = local_10.member[0u];
                                    let _e2589 = local_10.member_2[0u];
                                    if (((_e2577 + ((_e2580 - _e2583) * _e565)) - _e2589) > _e2574) {
                                        let _e2594 = local_10.member[1u];
                                        let _e2597 = local_10.member_1[1u];
                                        let _e2600 = local_10.member[1u];
                                        let _e2606 = local_10.member_2[1u];
                                        if (((_e2594 + ((_e2597 - _e2600) * _e565)) - _e2606) > _e2574) {
                                            let _e2611 = local_10.member[2u];
                                            let _e2614 = local_10.member_1[2u];
                                            let _e2617 = local_10.member[2u];
                                            let _e2623 = local_10.member_2[2u];
                                            if (((_e2611 + ((_e2614 - _e2617) * _e565)) - _e2623) > _e2574) {
                                                let _e2628 = local_10.member[3u];
                                                let _e2631 = local_10.member_1[3u];
                                                let _e2634 = local_10.member[3u];
                                                let _e2640 = local_10.member_2[3u];
                                                phi_10805_ = (((_e2628 + ((_e2631 - _e2634) * _e565)) - _e2640) > _e2574);
                                                phi_10806_ = false;
                                            } else {
                                                phi_10805_ = bool();
                                                phi_10806_ = true;
                                            }
                                            let _e2644 = phi_10805_;
                                            let _e2646 = phi_10806_;
                                            phi_10807_ = _e2644;
                                            phi_10808_ = _e2646;
                                        } else {
                                            phi_10807_ = bool();
                                            phi_10808_ = true;
                                        }
                                        let _e2648 = phi_10807_;
                                        let _e2650 = phi_10808_;
                                        phi_10809_ = _e2648;
                                        phi_10810_ = _e2650;
                                    } else {
                                        phi_10809_ = bool();
                                        phi_10810_ = true;
                                    }
                                    let _e2652 = phi_10809_;
                                    let _e2654 = phi_10810_;
                                    if _e2654 {
                                        phi_10814_ = false;
                                    } else {
                                        phi_10814_ = _e2652;
                                    }
                                    let _e2656 = phi_10814_;
                                    if _e2656 {
                                        phi_11274_ = bool();
                                    } else {
                                        let _e2657 = f64(0f);
                                        if (_e2657 < 0.0lf) {
                                            phi_10842_ = -(_e2657);
                                        } else {
                                            phi_10842_ = _e2657;
                                        }
                                        let _e2662 = phi_10842_;
                                        if (_e2657 < 0.0lf) {
                                            phi_10848_ = -(_e2657);
                                        } else {
                                            phi_10848_ = _e2657;
                                        }
                                        let _e2666 = phi_10848_;
                                        if (_e1734[2] < 0.0lf) {
                                            phi_10855_ = -(_e1734[2]);
                                        } else {
                                            phi_10855_ = _e1734[2];
                                        }
                                        let _e2671 = phi_10855_;
                                        let _e2672 = ((_e2662 + _e2666) + _e2671);
                                        if (_e2672 > f64(0f)) {
                                            if ((bitcast<u64>(_e2672) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2679 = (f64(1f) / _e2672);
                                                let _e2680 = (_e2657 * _e2679);
                                                let _e2681 = (_e2657 * _e2679);
                                                let _e2682 = (_e1734[2] * _e2679);
                                                let _e2687 = (((_e2680 * _e2680) + (_e2681 * _e2681)) + (_e2682 * _e2682));
                                                if (_e2687 <= 2.2250738585072014e-308lf) {
                                                    if (_e2687 > 0.0lf) {
                                                        phi_10891_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_10891_ = 0.0lf;
                                                    }
                                                    let _e2739 = phi_10891_;
                                                    phi_10955_ = _e2739;
                                                } else {
                                                    phi_10898_ = type_18(0i, 5i);
                                                    phi_10901_ = bitcast<f64>(((bitcast<u64>(_e2687) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2694 = phi_10898_;
                                                        let _e2696 = phi_10901_;
                                                        local_23 = _e2696;
                                                        if (_e2694.member < _e2694.member_1) {
                                                            let _e2703 = (_e2694.member + 1i);
                                                            if ((false == (_e2703 > _e2694.member)) != false) {
                                                                phi_10922_ = true;
                                                            } else {
                                                                phi_10922_ = false;
                                                            }
                                                            let _e2708 = phi_10922_;
                                                            if _e2708 {
                                                                phi_10928_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_10928_ = type_19(1u, _e2703);
                                                            }
                                                            let _e2713 = phi_10928_;
                                                            phi_10899_ = type_18(_e2713.member_1, _e2694.member_1);
                                                            phi_10942_ = type_19(1u, _e2694.member);
                                                        } else {
                                                            phi_10899_ = _e2694;
                                                            phi_10942_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e2719 = phi_10899_;
                                                        let _e2721 = phi_10942_;
                                                        let _e2724 = (bitcast<i32>(_e2721.member) != 0i);
                                                        if _e2724 {
                                                            phi_10902_ = (0.5lf * (_e2696 + (_e2687 / _e2696)));
                                                        } else {
                                                            phi_10902_ = f64();
                                                        }
                                                        let _e2729 = phi_10902_;
                                                        continue;
                                                        continuing {
                                                            phi_10898_ = _e2719;
                                                            phi_10901_ = _e2729;
                                                            break if !(_e2724);
                                                        }
                                                    }
                                                    let _e2734 = local_23;
                                                    phi_10955_ = (_e2734 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2741 = phi_10955_;
                                                let _e2743 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2750 = ((_e1667 * f64(1.01f)) + ((_e1428 * _e2741) * (f64(1f) + _e2743)));
                                                let _e2755 = (((_e2680 * _e1431[0]) + (_e2681 * _e1431[1])) + (_e2682 * _e1431[2]));
                                                let _e2760 = (((_e2680 * _e1448) + (_e2681 * _e1449)) + (_e2682 * _e1450));
                                                let _e2765 = (((_e2680 * _e1458) + (_e2681 * _e1459)) + (_e2682 * _e1460));
                                                let _e2773 = (((_e2680 * _e1457[0]) + (_e2681 * _e1457[1])) + (_e2682 * _e1457[2]));
                                                let _e2779 = (((_e2680 * _e1463[0]) + (_e2681 * _e1463[1])) + (_e2682 * _e1463[2]));
                                                let _e2784 = (((_e2680 * _e1480) + (_e2681 * _e1481)) + (_e2682 * _e1482));
                                                let _e2789 = (((_e2680 * _e1490) + (_e2681 * _e1491)) + (_e2682 * _e1492));
                                                let _e2797 = (((_e2680 * _e1489[0]) + (_e2681 * _e1489[1])) + (_e2682 * _e1489[2]));
                                                if (_e2755 < 0.0lf) {
                                                    phi_11024_ = -(_e2755);
                                                } else {
                                                    phi_11024_ = _e2755;
                                                }
                                                let _e2802 = phi_11024_;
                                                if (_e2779 < 0.0lf) {
                                                    phi_11030_ = -(_e2779);
                                                } else {
                                                    phi_11030_ = _e2779;
                                                }
                                                let _e2806 = phi_11030_;
                                                if (_e2760 < 0.0lf) {
                                                    phi_11039_ = -(_e2760);
                                                } else {
                                                    phi_11039_ = _e2760;
                                                }
                                                let _e2813 = phi_11039_;
                                                if (_e2784 < 0.0lf) {
                                                    phi_11045_ = -(_e2784);
                                                } else {
                                                    phi_11045_ = _e2784;
                                                }
                                                let _e2817 = phi_11045_;
                                                if (_e2765 < 0.0lf) {
                                                    phi_11054_ = -(_e2765);
                                                } else {
                                                    phi_11054_ = _e2765;
                                                }
                                                let _e2824 = phi_11054_;
                                                if (_e2789 < 0.0lf) {
                                                    phi_11060_ = -(_e2789);
                                                } else {
                                                    phi_11060_ = _e2789;
                                                }
                                                let _e2828 = phi_11060_;
                                                if (_e2773 < 0.0lf) {
                                                    phi_11069_ = -(_e2773);
                                                } else {
                                                    phi_11069_ = _e2773;
                                                }
                                                let _e2835 = phi_11069_;
                                                if (_e2797 < 0.0lf) {
                                                    phi_11075_ = -(_e2797);
                                                } else {
                                                    phi_11075_ = _e2797;
                                                }
                                                let _e2839 = phi_11075_;
                                                phi_11081_ = type_35(array<f64, 4>(_e2755, _e2760, _e2765, _e2773), array<f64, 4>(_e2779, _e2784, _e2789, _e2797), array<f64, 4>((_e2750 + ((_e2802 + _e2806) * _e2743)), (_e2750 + ((_e2813 + _e2817) * _e2743)), (_e2750 + ((_e2824 + _e2828) * _e2743)), (_e2750 + ((_e2835 + _e2839) * _e2743))));
                                                phi_11082_ = false;
                                            } else {
                                                phi_11081_ = type_35();
                                                phi_11082_ = true;
                                            }
                                            let _e2846 = phi_11081_;
                                            let _e2848 = phi_11082_;
                                            phi_11083_ = _e2846;
                                            phi_11084_ = _e2848;
                                        } else {
                                            phi_11083_ = type_35();
                                            phi_11084_ = true;
                                        }
                                        let _e2850 = phi_11083_;
                                        let _e2852 = phi_11084_;
                                        if _e2852 {
                                            let _e2853 = f64(0f);
                                            let _e2854 = f64(1f);
                                            phi_11094_ = type_35(array<f64, 4>(_e2853, _e2853, _e2853, _e2853), array<f64, 4>(_e2853, _e2853, _e2853, _e2853), array<f64, 4>(_e2854, _e2854, _e2854, _e2854));
                                        } else {
                                            phi_11094_ = _e2850;
                                        }
                                        let _e2860 = phi_11094_;
                                        local_11 = type_35(array<f64, 4>(_e2860.member[0], _e2860.member[1], _e2860.member[2], _e2860.member[3]), array<f64, 4>(_e2860.member_1[0], _e2860.member_1[1], _e2860.member_1[2], _e2860.member_1[3]), array<f64, 4>(_e2860.member_2[0], _e2860.member_2[1], _e2860.member_2[2], _e2860.member_2[3]));
                                        let _e2880 = f64(0f);
                                        let _e2883 = local_11.member[0u];
                                        let _e2886 = local_11.member_1[0u];
                                        let _e2889 = local_11.member[0u];
                                        let _e2895 = local_11.member_2[0u];
                                        if (((_e2883 + ((_e2886 - _e2889) * _e565)) - _e2895) > _e2880) {
                                            let _e2900 = local_11.member[1u];
                                            let _e2903 = local_11.member_1[1u];
                                            let _e2906 = local_11.member[1u];
                                            let _e2912 = local_11.member_2[1u];
                                            if (((_e2900 + ((_e2903 - _e2906) * _e565)) - _e2912) > _e2880) {
                                                let _e2917 = local_11.member[2u];
                                                let _e2920 = local_11.member_1[2u];
                                                let _e2923 = local_11.member[2u];
                                                let _e2929 = local_11.member_2[2u];
                                                if (((_e2917 + ((_e2920 - _e2923) * _e565)) - _e2929) > _e2880) {
                                                    let _e2934 = local_11.member[3u];
                                                    let _e2937 = local_11.member_1[3u];
                                                    let _e2940 = local_11.member[3u];
                                                    let _e2946 = local_11.member_2[3u];
                                                    phi_11264_ = (((_e2934 + ((_e2937 - _e2940) * _e565)) - _e2946) > _e2880);
                                                    phi_11265_ = false;
                                                } else {
                                                    phi_11264_ = bool();
                                                    phi_11265_ = true;
                                                }
                                                let _e2950 = phi_11264_;
                                                let _e2952 = phi_11265_;
                                                phi_11266_ = _e2950;
                                                phi_11267_ = _e2952;
                                            } else {
                                                phi_11266_ = bool();
                                                phi_11267_ = true;
                                            }
                                            let _e2954 = phi_11266_;
                                            let _e2956 = phi_11267_;
                                            phi_11268_ = _e2954;
                                            phi_11269_ = _e2956;
                                        } else {
                                            phi_11268_ = bool();
                                            phi_11269_ = true;
                                        }
                                        let _e2958 = phi_11268_;
                                        let _e2960 = phi_11269_;
                                        if _e2960 {
                                            phi_11273_ = false;
                                        } else {
                                            phi_11273_ = _e2958;
                                        }
                                        let _e2962 = phi_11273_;
                                        phi_11274_ = _e2962;
                                    }
                                    let _e2964 = phi_11274_;
                                    phi_11275_ = _e2964;
                                    phi_11276_ = _e2656;
                                }
                                let _e2966 = phi_11275_;
                                let _e2968 = phi_11276_;
                                phi_11277_ = _e2966;
                                phi_11278_ = _e2968;
                            }
                            let _e2970 = phi_11277_;
                            let _e2972 = phi_11278_;
                            if _e2972 {
                                phi_11282_ = true;
                            } else {
                                phi_11282_ = _e2970;
                            }
                            let _e2974 = phi_11282_;
                            if !(_e2974) {
                                phi_11288_ = type_45(2u, _e565);
                                phi_11289_ = false;
                            } else {
                                phi_11288_ = type_45();
                                phi_11289_ = true;
                            }
                            let _e2978 = phi_11288_;
                            let _e2980 = phi_11289_;
                            phi_11290_ = _e2978;
                            phi_11291_ = _e2980;
                        } else {
                            phi_11290_ = type_45();
                            phi_11291_ = true;
                        }
                        let _e2982 = phi_11290_;
                        let _e2984 = phi_11291_;
                        if _e2984 {
                            let _e2985 = f64(0f);
                            let _e2986 = f64(1f);
                            let _e2987 = f64(3f);
                            let _e2990 = local_12.member[0u];
                            let _e2993 = local_12.member[1u];
                            let _e2996 = local_12.member[2u];
                            let _e2999 = local_12.member[3u];
                            let _e3006 = local_12.member_2;
                            let _e3007 = ((_e2993 - (_e2987 * _e2990)) * _e3006);
                            let _e3009 = local_12.member_2;
                            let _e3010 = ((_e2996 - _e2993) * _e3009);
                            let _e3012 = local_12.member_2;
                            let _e3013 = (((_e2987 * _e2999) - _e2996) * _e3012);
                            local_6[0u] = _e2985;
                            local_6[1u] = _e2986;
                            local_6[2u] = _e2986;
                            local_6[3u] = _e2986;
                            let _e3020 = ((_e3010 * _e3010) - (_e3007 * _e3013));
                            if (_e3020 > _e2985) {
                                if (_e3020 <= 2.2250738585072014e-308lf) {
                                    if (_e3020 > 0.0lf) {
                                        phi_11344_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_11344_ = 0.0lf;
                                    }
                                    let _e3073 = phi_11344_;
                                    phi_11408_ = _e3073;
                                } else {
                                    phi_11351_ = type_18(0i, 5i);
                                    phi_11354_ = bitcast<f64>(((bitcast<u64>(_e3020) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e3028 = phi_11351_;
                                        let _e3030 = phi_11354_;
                                        local_24 = _e3030;
                                        if (_e3028.member < _e3028.member_1) {
                                            let _e3037 = (_e3028.member + 1i);
                                            if ((false == (_e3037 > _e3028.member)) != false) {
                                                phi_11375_ = true;
                                            } else {
                                                phi_11375_ = false;
                                            }
                                            let _e3042 = phi_11375_;
                                            if _e3042 {
                                                phi_11381_ = type_19(0u, type_19().member_1);
                                            } else {
                                                phi_11381_ = type_19(1u, _e3037);
                                            }
                                            let _e3047 = phi_11381_;
                                            phi_11352_ = type_18(_e3047.member_1, _e3028.member_1);
                                            phi_11395_ = type_19(1u, _e3028.member);
                                        } else {
                                            phi_11352_ = _e3028;
                                            phi_11395_ = type_19(0u, type_19().member_1);
                                        }
                                        let _e3053 = phi_11352_;
                                        let _e3055 = phi_11395_;
                                        let _e3058 = (bitcast<i32>(_e3055.member) != 0i);
                                        if _e3058 {
                                            phi_11355_ = (0.5lf * (_e3030 + (_e3020 / _e3030)));
                                        } else {
                                            phi_11355_ = f64();
                                        }
                                        let _e3063 = phi_11355_;
                                        continue;
                                        continuing {
                                            phi_11351_ = _e3053;
                                            phi_11354_ = _e3063;
                                            break if !(_e3058);
                                        }
                                    }
                                    let _e3068 = local_24;
                                    phi_11408_ = (_e3068 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e3075 = phi_11408_;
                                if (_e3010 < _e2985) {
                                    phi_11414_ = -(_e3075);
                                } else {
                                    phi_11414_ = _e3075;
                                }
                                let _e3079 = phi_11414_;
                                let _e3081 = -((_e3010 + _e3079));
                                local_7[0u] = (_e3081 / (_e3081 + _e3013));
                                local_7[1u] = (_e3007 / (_e3007 + _e3081));
                                let _e3090 = local_7[1u];
                                let _e3091 = local_7[0u];
                                if (_e3090 < _e3091) {
                                    let _e3094 = local_7[1u];
                                    let _e3096 = local_7[0u];
                                    local_7[0u] = _e3094;
                                    local_7[1u] = _e3096;
                                }
                                phi_11439_ = type_9(0u, 2u);
                                phi_11442_ = 1u;
                                loop {
                                    let _e3100 = phi_11439_;
                                    let _e3102 = phi_11442_;
                                    local_65 = _e3102;
                                    if (_e3100.member < _e3100.member_1) {
                                        phi_11440_ = type_9((_e3100.member + 1u), _e3100.member_1);
                                        phi_11465_ = type_9(1u, _e3100.member);
                                    } else {
                                        phi_11440_ = _e3100;
                                        phi_11465_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e3114 = phi_11440_;
                                    let _e3116 = phi_11465_;
                                    let _e3120 = (bitcast<i32>(_e3116.member) != 0i);
                                    if _e3120 {
                                        let _e3122 = local_7[_e3116.member_1];
                                        if (_e3122 > _e2985) {
                                            let _e3125 = local_7[_e3116.member_1];
                                            if (_e3125 < _e2986) {
                                                let _e3128 = local_7[_e3116.member_1];
                                                local_6[_e3102] = _e3128;
                                                phi_11509_ = (_e3102 + 1u);
                                            } else {
                                                phi_11509_ = _e3102;
                                            }
                                            let _e3132 = phi_11509_;
                                            phi_11510_ = _e3132;
                                        } else {
                                            phi_11510_ = _e3102;
                                        }
                                        let _e3134 = phi_11510_;
                                        phi_11443_ = _e3134;
                                    } else {
                                        phi_11443_ = u32();
                                    }
                                    let _e3136 = phi_11443_;
                                    continue;
                                    continuing {
                                        phi_11439_ = _e3114;
                                        phi_11442_ = _e3136;
                                        break if !(_e3120);
                                    }
                                }
                                let _e11475 = local_65;
                                phi_11511_ = _e11475;
                            } else {
                                phi_11511_ = 1u;
                            }
                            let _e3139 = phi_11511_;
                            local_6[_e3139] = _e2986;
                            let _e3141 = local_6;
                            local_13 = _e3141;
                            phi_11531_ = type_9(0u, _e3139);
                            loop {
                                let _e3144 = phi_11531_;
                                if (_e3144.member < _e3144.member_1) {
                                    phi_11532_ = type_9((_e3144.member + 1u), _e3144.member_1);
                                    phi_11555_ = type_9(1u, _e3144.member);
                                } else {
                                    phi_11532_ = _e3144;
                                    phi_11555_ = type_9(0u, type_9().member_1);
                                }
                                let _e3156 = phi_11532_;
                                let _e3158 = phi_11555_;
                                if (bitcast<i32>(_e3158.member) != 0i) {
                                    let _e3164 = local_13[_e3158.member_1];
                                    if (_e3164 > _e565) {
                                        phi_11574_ = _e3164;
                                    } else {
                                        phi_11574_ = _e565;
                                    }
                                    let _e3167 = phi_11574_;
                                    let _e3170 = local_13[(_e3158.member_1 + 1u)];
                                    if (_e3170 < _e574) {
                                        phi_11587_ = _e3170;
                                    } else {
                                        phi_11587_ = _e574;
                                    }
                                    let _e3173 = phi_11587_;
                                    if (_e3167 <= _e3173) {
                                        let _e3175 = function_2((&local_12), _e583, _e3167, _e3173);
                                        if _e3175 {
                                            phi_15866_ = type_48();
                                            phi_15867_ = bool();
                                            phi_15868_ = f64();
                                            phi_15869_ = f64();
                                            phi_15870_ = type_48();
                                            phi_15871_ = false;
                                            phi_15872_ = false;
                                            phi_15873_ = false;
                                            phi_15874_ = false;
                                            phi_15875_ = false;
                                        } else {
                                            let _e3177 = (f64(1f) - _e3167);
                                            let _e3180 = local_12.member[0u];
                                            let _e3183 = local_12.member[1u];
                                            let _e3186 = local_12.member[2u];
                                            let _e3189 = local_12.member[3u];
                                            let _e3200 = ((((_e3180 * _e3177) + (_e3183 * _e3167)) * (_e3177 * _e3177)) + (((_e3186 * _e3177) + (_e3189 * _e3167)) * (_e3167 * _e3167)));
                                            let _e3202 = (f64(1f) - _e3173);
                                            let _e3205 = local_12.member[0u];
                                            let _e3208 = local_12.member[1u];
                                            let _e3211 = local_12.member[2u];
                                            let _e3214 = local_12.member[3u];
                                            let _e3225 = ((((_e3205 * _e3202) + (_e3208 * _e3173)) * (_e3202 * _e3202)) + (((_e3211 * _e3202) + (_e3214 * _e3173)) * (_e3173 * _e3173)));
                                            if (_e3200 < 0.0lf) {
                                                phi_11643_ = -(_e3200);
                                            } else {
                                                phi_11643_ = _e3200;
                                            }
                                            let _e3229 = phi_11643_;
                                            let _e3231 = local_12.member_1;
                                            let _e3232 = (_e3229 > _e3231);
                                            if (_e3225 < 0.0lf) {
                                                phi_11652_ = -(_e3225);
                                            } else {
                                                phi_11652_ = _e3225;
                                            }
                                            let _e3236 = phi_11652_;
                                            let _e3238 = local_12.member_1;
                                            let _e3239 = (_e3236 > _e3238);
                                            let _e3240 = f64(0f);
                                            if _e3232 {
                                                if _e3239 {
                                                    phi_11666_ = ((_e3200 > _e3240) != (_e3225 > _e3240));
                                                    phi_11667_ = false;
                                                } else {
                                                    phi_11666_ = bool();
                                                    phi_11667_ = true;
                                                }
                                                let _e3245 = phi_11666_;
                                                let _e3247 = phi_11667_;
                                                phi_11668_ = _e3245;
                                                phi_11669_ = _e3247;
                                            } else {
                                                phi_11668_ = bool();
                                                phi_11669_ = true;
                                            }
                                            let _e3249 = phi_11668_;
                                            let _e3251 = phi_11669_;
                                            if _e3251 {
                                                phi_11673_ = false;
                                            } else {
                                                phi_11673_ = _e3249;
                                            }
                                            let _e3253 = phi_11673_;
                                            if _e3232 {
                                                if _e3239 {
                                                    if _e3253 {
                                                        phi_11685_ = type_48();
                                                    } else {
                                                        phi_11685_ = type_48(f64(1f), _e3240, _e3253);
                                                    }
                                                    let _e3257 = phi_11685_;
                                                    phi_11686_ = _e3257;
                                                    phi_11687_ = _e3253;
                                                } else {
                                                    phi_11686_ = type_48();
                                                    phi_11687_ = true;
                                                }
                                                let _e3259 = phi_11686_;
                                                let _e3261 = phi_11687_;
                                                phi_11688_ = _e3259;
                                                phi_11689_ = _e3261;
                                            } else {
                                                phi_11688_ = type_48();
                                                phi_11689_ = true;
                                            }
                                            let _e3263 = phi_11688_;
                                            let _e3265 = phi_11689_;
                                            if _e3265 {
                                                if _e3232 {
                                                    if (_e3200 < _e3240) {
                                                        phi_11702_ = f64(-1f);
                                                    } else {
                                                        phi_11702_ = f64(1f);
                                                    }
                                                    let _e3270 = phi_11702_;
                                                    let _e3272 = local_12.member_3;
                                                    let _e3273 = f64(0.5f);
                                                    let _e3274 = f64(3f);
                                                    let _e3277 = local_12.member[0u];
                                                    let _e3280 = local_12.member[1u];
                                                    let _e3283 = local_12.member[2u];
                                                    let _e3286 = local_12.member[3u];
                                                    let _e3289 = (_e3283 - _e3280);
                                                    phi_11724_ = type_9(0u, 64u);
                                                    phi_11727_ = _e3173;
                                                    phi_11729_ = _e3167;
                                                    phi_11731_ = (_e3273 * (_e3167 + _e3173));
                                                    loop {
                                                        let _e3295 = phi_11724_;
                                                        let _e3297 = phi_11727_;
                                                        let _e3299 = phi_11729_;
                                                        let _e3301 = phi_11731_;
                                                        local_67 = _e3299;
                                                        if (_e3295.member < _e3295.member_1) {
                                                            phi_11725_ = type_9((_e3295.member + 1u), _e3295.member_1);
                                                            phi_11754_ = type_9(1u, _e3295.member);
                                                        } else {
                                                            phi_11725_ = _e3295;
                                                            phi_11754_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e3313 = phi_11725_;
                                                        let _e3315 = phi_11754_;
                                                        if (bitcast<i32>(_e3315.member) != 0i) {
                                                            let _e3320 = (f64(1f) - _e3301);
                                                            let _e3323 = local_12.member[0u];
                                                            let _e3326 = local_12.member[1u];
                                                            let _e3329 = local_12.member[2u];
                                                            let _e3332 = local_12.member[3u];
                                                            let _e3346 = local_12.member_1;
                                                            let _e3347 = ((_e3270 * ((((_e3323 * _e3320) + (_e3326 * _e3301)) * (_e3320 * _e3320)) + (((_e3329 * _e3320) + (_e3332 * _e3301)) * (_e3301 * _e3301)))) - _e3346);
                                                            if (_e3347 > f64(0f)) {
                                                                phi_11791_ = _e3297;
                                                                phi_11792_ = _e3301;
                                                            } else {
                                                                phi_11791_ = _e3301;
                                                                phi_11792_ = _e3299;
                                                            }
                                                            let _e3351 = phi_11791_;
                                                            let _e3353 = phi_11792_;
                                                            let _e3355 = ((_e3351 - _e3353) > _e3272);
                                                            if _e3355 {
                                                                let _e3357 = (f64(1f) - _e3301);
                                                                let _e3369 = (-(_e3347) / (_e3270 * (((((_e3280 - (_e3274 * _e3277)) * _e3357) + (_e3289 * _e3301)) * _e3357) + (((_e3289 * _e3357) + (((_e3274 * _e3286) - _e3283) * _e3301)) * _e3301))));
                                                                if (_e3347 > f64(0f)) {
                                                                    phi_11820_ = (_e3273 * _e3272);
                                                                } else {
                                                                    phi_11820_ = -((_e3273 * _e3272));
                                                                }
                                                                let _e3376 = phi_11820_;
                                                                let _e3378 = ((_e3301 + _e3369) + _e3376);
                                                                if (_e3378 > _e3353) {
                                                                    if (_e3378 < _e3351) {
                                                                        if (_e3369 < 0.0lf) {
                                                                            phi_11836_ = -(_e3369);
                                                                        } else {
                                                                            phi_11836_ = _e3369;
                                                                        }
                                                                        let _e3384 = phi_11836_;
                                                                        if (_e3384 < (_e3273 * (_e3351 - _e3353))) {
                                                                            phi_11843_ = false;
                                                                        } else {
                                                                            phi_11843_ = true;
                                                                        }
                                                                        let _e3389 = phi_11843_;
                                                                        phi_11844_ = _e3389;
                                                                    } else {
                                                                        phi_11844_ = true;
                                                                    }
                                                                    let _e3391 = phi_11844_;
                                                                    phi_11845_ = _e3391;
                                                                } else {
                                                                    phi_11845_ = true;
                                                                }
                                                                let _e3393 = phi_11845_;
                                                                if _e3393 {
                                                                    phi_11851_ = (_e3273 * (_e3353 + _e3351));
                                                                } else {
                                                                    phi_11851_ = _e3378;
                                                                }
                                                                let _e3397 = phi_11851_;
                                                                phi_11852_ = _e3397;
                                                                phi_11853_ = false;
                                                            } else {
                                                                phi_11852_ = f64();
                                                                phi_11853_ = true;
                                                            }
                                                            let _e3399 = phi_11852_;
                                                            let _e3401 = phi_11853_;
                                                            phi_11728_ = _e3351;
                                                            phi_11730_ = _e3353;
                                                            phi_11732_ = _e3399;
                                                            phi_11854_ = _e3353;
                                                            phi_11855_ = _e3355;
                                                            phi_11856_ = _e3401;
                                                        } else {
                                                            phi_11728_ = f64();
                                                            phi_11730_ = f64();
                                                            phi_11732_ = f64();
                                                            phi_11854_ = f64();
                                                            phi_11855_ = false;
                                                            phi_11856_ = false;
                                                        }
                                                        let _e3403 = phi_11728_;
                                                        let _e3405 = phi_11730_;
                                                        let _e3407 = phi_11732_;
                                                        let _e3409 = phi_11854_;
                                                        let _e3411 = phi_11855_;
                                                        let _e3413 = phi_11856_;
                                                        local_25 = _e3413;
                                                        local_66 = _e3409;
                                                        continue;
                                                        continuing {
                                                            phi_11724_ = _e3313;
                                                            phi_11727_ = _e3403;
                                                            phi_11729_ = _e3405;
                                                            phi_11731_ = _e3407;
                                                            break if !(_e3411);
                                                        }
                                                    }
                                                    let _e3416 = local_25;
                                                    if _e3416 {
                                                        let _e11519 = local_66;
                                                        phi_11860_ = _e11519;
                                                    } else {
                                                        let _e11521 = local_67;
                                                        phi_11860_ = _e11521;
                                                    }
                                                    let _e3418 = phi_11860_;
                                                    phi_11861_ = _e3418;
                                                } else {
                                                    phi_11861_ = _e3167;
                                                }
                                                let _e3420 = phi_11861_;
                                                if _e3239 {
                                                    if (_e3225 < _e3240) {
                                                        phi_11871_ = f64(-1f);
                                                    } else {
                                                        phi_11871_ = f64(1f);
                                                    }
                                                    let _e3425 = phi_11871_;
                                                    let _e3427 = local_12.member_3;
                                                    let _e3429 = local_12.member_3;
                                                    phi_11879_ = type_9(0u, 64u);
                                                    phi_11882_ = (_e3427 + _e3429);
                                                    loop {
                                                        let _e3432 = phi_11879_;
                                                        let _e3434 = phi_11882_;
                                                        if (_e3432.member < _e3432.member_1) {
                                                            phi_11880_ = type_9((_e3432.member + 1u), _e3432.member_1);
                                                            phi_11905_ = type_9(1u, _e3432.member);
                                                        } else {
                                                            phi_11880_ = _e3432;
                                                            phi_11905_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e3446 = phi_11880_;
                                                        let _e3448 = phi_11905_;
                                                        if (bitcast<i32>(_e3448.member) != 0i) {
                                                            let _e3452 = (_e3420 + _e3434);
                                                            if (_e3452 < _e3173) {
                                                                let _e3455 = (f64(1f) - _e3452);
                                                                let _e3458 = local_12.member[0u];
                                                                let _e3461 = local_12.member[1u];
                                                                let _e3464 = local_12.member[2u];
                                                                let _e3467 = local_12.member[3u];
                                                                let _e3481 = local_12.member_1;
                                                                let _e3482 = ((_e3425 * ((((_e3458 * _e3455) + (_e3461 * _e3452)) * (_e3455 * _e3455)) + (((_e3464 * _e3455) + (_e3467 * _e3452)) * (_e3452 * _e3452)))) > _e3481);
                                                                if _e3482 {
                                                                    phi_11946_ = f64();
                                                                    phi_11947_ = false;
                                                                } else {
                                                                    phi_11946_ = (_e3434 + _e3434);
                                                                    phi_11947_ = true;
                                                                }
                                                                let _e3485 = phi_11946_;
                                                                let _e3487 = phi_11947_;
                                                                phi_11948_ = _e3485;
                                                                phi_11949_ = _e3487;
                                                                phi_11950_ = _e3482;
                                                                phi_11951_ = false;
                                                            } else {
                                                                phi_11948_ = f64();
                                                                phi_11949_ = false;
                                                                phi_11950_ = false;
                                                                phi_11951_ = true;
                                                            }
                                                            let _e3489 = phi_11948_;
                                                            let _e3491 = phi_11949_;
                                                            let _e3493 = phi_11950_;
                                                            let _e3495 = phi_11951_;
                                                            phi_11952_ = _e3452;
                                                            phi_11883_ = _e3489;
                                                            phi_11953_ = _e3491;
                                                            phi_11954_ = _e3493;
                                                            phi_11955_ = _e3495;
                                                            phi_11956_ = false;
                                                        } else {
                                                            phi_11952_ = f64();
                                                            phi_11883_ = f64();
                                                            phi_11953_ = false;
                                                            phi_11954_ = false;
                                                            phi_11955_ = false;
                                                            phi_11956_ = true;
                                                        }
                                                        let _e3497 = phi_11952_;
                                                        let _e3499 = phi_11883_;
                                                        let _e3501 = phi_11953_;
                                                        let _e3503 = phi_11954_;
                                                        let _e3505 = phi_11955_;
                                                        let _e3507 = phi_11956_;
                                                        local_26 = _e3503;
                                                        local_68 = _e3505;
                                                        local_69 = _e3507;
                                                        local_70 = _e3497;
                                                        continue;
                                                        continuing {
                                                            phi_11879_ = _e3446;
                                                            phi_11882_ = _e3499;
                                                            break if !(_e3501);
                                                        }
                                                    }
                                                    let _e3510 = local_26;
                                                    if _e3510 {
                                                        phi_11960_ = false;
                                                        phi_11961_ = false;
                                                    } else {
                                                        let _e11543 = local_68;
                                                        phi_11960_ = _e11543;
                                                        let _e11546 = local_69;
                                                        phi_11961_ = _e11546;
                                                    }
                                                    let _e3512 = phi_11960_;
                                                    let _e3514 = phi_11961_;
                                                    if _e3512 {
                                                        phi_11965_ = true;
                                                    } else {
                                                        phi_11965_ = _e3514;
                                                    }
                                                    let _e3516 = phi_11965_;
                                                    if _e3516 {
                                                        phi_11969_ = _e3173;
                                                    } else {
                                                        let _e11550 = local_70;
                                                        phi_11969_ = _e11550;
                                                    }
                                                    let _e3518 = phi_11969_;
                                                    phi_11970_ = _e3518;
                                                } else {
                                                    phi_11970_ = _e3173;
                                                }
                                                let _e3520 = phi_11970_;
                                                phi_11972_ = type_48(_e3420, _e3520, _e3253);
                                            } else {
                                                phi_11972_ = _e3263;
                                            }
                                            let _e3523 = phi_11972_;
                                            if (_e3523.member > _e3523.member_1) {
                                                phi_15851_ = bool();
                                                phi_15852_ = f64();
                                                phi_15853_ = f64();
                                                phi_15854_ = true;
                                                phi_15855_ = false;
                                                phi_15856_ = false;
                                                phi_15857_ = false;
                                                phi_15858_ = false;
                                            } else {
                                                let _e3528 = (_e3523.member > _e583);
                                                if _e3528 {
                                                    phi_15844_ = bool();
                                                    phi_15845_ = f64();
                                                    phi_15846_ = f64();
                                                    phi_15847_ = false;
                                                    phi_15848_ = false;
                                                    phi_15849_ = false;
                                                    phi_15850_ = false;
                                                } else {
                                                    let _e3533 = ((_e3523.member_1 - _e3523.member) * f64(0.5f));
                                                    let _e3534 = (_e3523.member + _e3533);
                                                    let _e3537 = (_e3533 + (1.1102230246251565e-16lf * f64(4f)));
                                                    let _e3539 = local_19.member_3;
                                                    let _e3542 = local_19.member[0u];
                                                    if (_e3542[0] < 0.0lf) {
                                                        phi_12008_ = -(_e3542[0]);
                                                    } else {
                                                        phi_12008_ = _e3542[0];
                                                    }
                                                    let _e3549 = phi_12008_;
                                                    if (_e3542[1] < 0.0lf) {
                                                        phi_12015_ = -(_e3542[1]);
                                                    } else {
                                                        phi_12015_ = _e3542[1];
                                                    }
                                                    let _e3553 = phi_12015_;
                                                    if (_e3549 > _e3553) {
                                                        phi_12020_ = _e3549;
                                                    } else {
                                                        phi_12020_ = _e3553;
                                                    }
                                                    let _e3556 = phi_12020_;
                                                    if (_e3542[2] < 0.0lf) {
                                                        phi_12027_ = -(_e3542[2]);
                                                    } else {
                                                        phi_12027_ = _e3542[2];
                                                    }
                                                    let _e3560 = phi_12027_;
                                                    if (_e3556 > _e3560) {
                                                        phi_12032_ = _e3556;
                                                    } else {
                                                        phi_12032_ = _e3560;
                                                    }
                                                    let _e3563 = phi_12032_;
                                                    let _e3565 = local_19.member[1u];
                                                    if (_e3565[0] < 0.0lf) {
                                                        phi_12045_ = -(_e3565[0]);
                                                    } else {
                                                        phi_12045_ = _e3565[0];
                                                    }
                                                    let _e3572 = phi_12045_;
                                                    if (_e3565[1] < 0.0lf) {
                                                        phi_12052_ = -(_e3565[1]);
                                                    } else {
                                                        phi_12052_ = _e3565[1];
                                                    }
                                                    let _e3576 = phi_12052_;
                                                    if (_e3572 > _e3576) {
                                                        phi_12057_ = _e3572;
                                                    } else {
                                                        phi_12057_ = _e3576;
                                                    }
                                                    let _e3579 = phi_12057_;
                                                    if (_e3565[2] < 0.0lf) {
                                                        phi_12064_ = -(_e3565[2]);
                                                    } else {
                                                        phi_12064_ = _e3565[2];
                                                    }
                                                    let _e3583 = phi_12064_;
                                                    if (_e3579 > _e3583) {
                                                        phi_12069_ = _e3579;
                                                    } else {
                                                        phi_12069_ = _e3583;
                                                    }
                                                    let _e3586 = phi_12069_;
                                                    if (_e3563 > _e3586) {
                                                        phi_12074_ = _e3563;
                                                    } else {
                                                        phi_12074_ = _e3586;
                                                    }
                                                    let _e3589 = phi_12074_;
                                                    let _e3592 = local_19.member[0u];
                                                    let _e3597 = local_19.member[1u];
                                                    let _e3607 = (_e3592[0] + ((_e3597[0] - _e3592[0]) * _e3534));
                                                    let _e3608 = (_e3592[1] + ((_e3597[1] - _e3592[1]) * _e3534));
                                                    let _e3609 = (_e3592[2] + ((_e3597[2] - _e3592[2]) * _e3534));
                                                    let _e3611 = local_19.member[1u];
                                                    let _e3616 = local_19.member[0u];
                                                    let _e3620 = (_e3611[0] - _e3616[0]);
                                                    let _e3621 = (_e3611[1] - _e3616[1]);
                                                    let _e3622 = (_e3611[2] - _e3616[2]);
                                                    if (_e3620 < 0.0lf) {
                                                        phi_12133_ = -(_e3620);
                                                    } else {
                                                        phi_12133_ = _e3620;
                                                    }
                                                    let _e3626 = phi_12133_;
                                                    if (_e3621 < 0.0lf) {
                                                        phi_12139_ = -(_e3621);
                                                    } else {
                                                        phi_12139_ = _e3621;
                                                    }
                                                    let _e3630 = phi_12139_;
                                                    if (_e3626 > _e3630) {
                                                        phi_12144_ = _e3626;
                                                    } else {
                                                        phi_12144_ = _e3630;
                                                    }
                                                    let _e3633 = phi_12144_;
                                                    if (_e3622 < 0.0lf) {
                                                        phi_12150_ = -(_e3622);
                                                    } else {
                                                        phi_12150_ = _e3622;
                                                    }
                                                    let _e3637 = phi_12150_;
                                                    if (_e3633 > _e3637) {
                                                        phi_12155_ = _e3633;
                                                    } else {
                                                        phi_12155_ = _e3637;
                                                    }
                                                    let _e3640 = phi_12155_;
                                                    let _e3648 = ((((_e3537 * _e3640) * f64(1.01f)) + ((_e3589 + _e3539) * (1.1102230246251565e-16lf * f64(8f)))) + _e3539);
                                                    if (_e3607 < 0.0lf) {
                                                        phi_12169_ = -(_e3607);
                                                    } else {
                                                        phi_12169_ = _e3607;
                                                    }
                                                    let _e3652 = phi_12169_;
                                                    if (_e3608 < 0.0lf) {
                                                        phi_12175_ = -(_e3608);
                                                    } else {
                                                        phi_12175_ = _e3608;
                                                    }
                                                    let _e3656 = phi_12175_;
                                                    if (_e3652 > _e3656) {
                                                        phi_12180_ = _e3652;
                                                    } else {
                                                        phi_12180_ = _e3656;
                                                    }
                                                    let _e3659 = phi_12180_;
                                                    if (_e3609 < 0.0lf) {
                                                        phi_12186_ = -(_e3609);
                                                    } else {
                                                        phi_12186_ = _e3609;
                                                    }
                                                    let _e3663 = phi_12186_;
                                                    if (_e3659 > _e3663) {
                                                        phi_12191_ = _e3659;
                                                    } else {
                                                        phi_12191_ = _e3663;
                                                    }
                                                    let _e3666 = phi_12191_;
                                                    local_2 = type_36(array<f64, 3>(_e3607, _e3608, _e3609), _e3648, (_e3666 + _e3648));
                                                    let _e3672 = local_19.member_3;
                                                    let _e3674 = local_19.member_1[0u];
                                                    if (_e3674[0] < 0.0lf) {
                                                        phi_12217_ = -(_e3674[0]);
                                                    } else {
                                                        phi_12217_ = _e3674[0];
                                                    }
                                                    let _e3681 = phi_12217_;
                                                    if (_e3674[1] < 0.0lf) {
                                                        phi_12224_ = -(_e3674[1]);
                                                    } else {
                                                        phi_12224_ = _e3674[1];
                                                    }
                                                    let _e3685 = phi_12224_;
                                                    if (_e3681 > _e3685) {
                                                        phi_12229_ = _e3681;
                                                    } else {
                                                        phi_12229_ = _e3685;
                                                    }
                                                    let _e3688 = phi_12229_;
                                                    if (_e3674[2] < 0.0lf) {
                                                        phi_12236_ = -(_e3674[2]);
                                                    } else {
                                                        phi_12236_ = _e3674[2];
                                                    }
                                                    let _e3692 = phi_12236_;
                                                    if (_e3688 > _e3692) {
                                                        phi_12241_ = _e3688;
                                                    } else {
                                                        phi_12241_ = _e3692;
                                                    }
                                                    let _e3695 = phi_12241_;
                                                    let _e3697 = local_19.member_1[1u];
                                                    if (_e3697[0] < 0.0lf) {
                                                        phi_12254_ = -(_e3697[0]);
                                                    } else {
                                                        phi_12254_ = _e3697[0];
                                                    }
                                                    let _e3704 = phi_12254_;
                                                    if (_e3697[1] < 0.0lf) {
                                                        phi_12261_ = -(_e3697[1]);
                                                    } else {
                                                        phi_12261_ = _e3697[1];
                                                    }
                                                    let _e3708 = phi_12261_;
                                                    if (_e3704 > _e3708) {
                                                        phi_12266_ = _e3704;
                                                    } else {
                                                        phi_12266_ = _e3708;
                                                    }
                                                    let _e3711 = phi_12266_;
                                                    if (_e3697[2] < 0.0lf) {
                                                        phi_12273_ = -(_e3697[2]);
                                                    } else {
                                                        phi_12273_ = _e3697[2];
                                                    }
                                                    let _e3715 = phi_12273_;
                                                    if (_e3711 > _e3715) {
                                                        phi_12278_ = _e3711;
                                                    } else {
                                                        phi_12278_ = _e3715;
                                                    }
                                                    let _e3718 = phi_12278_;
                                                    if (_e3695 > _e3718) {
                                                        phi_12283_ = _e3695;
                                                    } else {
                                                        phi_12283_ = _e3718;
                                                    }
                                                    let _e3721 = phi_12283_;
                                                    let _e3724 = local_19.member_1[0u];
                                                    let _e3729 = local_19.member_1[1u];
                                                    let _e3739 = (_e3724[0] + ((_e3729[0] - _e3724[0]) * _e3534));
                                                    let _e3740 = (_e3724[1] + ((_e3729[1] - _e3724[1]) * _e3534));
                                                    let _e3741 = (_e3724[2] + ((_e3729[2] - _e3724[2]) * _e3534));
                                                    let _e3743 = local_19.member_1[1u];
                                                    let _e3748 = local_19.member_1[0u];
                                                    let _e3752 = (_e3743[0] - _e3748[0]);
                                                    let _e3753 = (_e3743[1] - _e3748[1]);
                                                    let _e3754 = (_e3743[2] - _e3748[2]);
                                                    if (_e3752 < 0.0lf) {
                                                        phi_12342_ = -(_e3752);
                                                    } else {
                                                        phi_12342_ = _e3752;
                                                    }
                                                    let _e3758 = phi_12342_;
                                                    if (_e3753 < 0.0lf) {
                                                        phi_12348_ = -(_e3753);
                                                    } else {
                                                        phi_12348_ = _e3753;
                                                    }
                                                    let _e3762 = phi_12348_;
                                                    if (_e3758 > _e3762) {
                                                        phi_12353_ = _e3758;
                                                    } else {
                                                        phi_12353_ = _e3762;
                                                    }
                                                    let _e3765 = phi_12353_;
                                                    if (_e3754 < 0.0lf) {
                                                        phi_12359_ = -(_e3754);
                                                    } else {
                                                        phi_12359_ = _e3754;
                                                    }
                                                    let _e3769 = phi_12359_;
                                                    if (_e3765 > _e3769) {
                                                        phi_12364_ = _e3765;
                                                    } else {
                                                        phi_12364_ = _e3769;
                                                    }
                                                    let _e3772 = phi_12364_;
                                                    let _e3780 = ((((_e3537 * _e3772) * f64(1.01f)) + ((_e3721 + _e3672) * (1.1102230246251565e-16lf * f64(8f)))) + _e3672);
                                                    if (_e3739 < 0.0lf) {
                                                        phi_12378_ = -(_e3739);
                                                    } else {
                                                        phi_12378_ = _e3739;
                                                    }
                                                    let _e3784 = phi_12378_;
                                                    if (_e3740 < 0.0lf) {
                                                        phi_12384_ = -(_e3740);
                                                    } else {
                                                        phi_12384_ = _e3740;
                                                    }
                                                    let _e3788 = phi_12384_;
                                                    if (_e3784 > _e3788) {
                                                        phi_12389_ = _e3784;
                                                    } else {
                                                        phi_12389_ = _e3788;
                                                    }
                                                    let _e3791 = phi_12389_;
                                                    if (_e3741 < 0.0lf) {
                                                        phi_12395_ = -(_e3741);
                                                    } else {
                                                        phi_12395_ = _e3741;
                                                    }
                                                    let _e3795 = phi_12395_;
                                                    if (_e3791 > _e3795) {
                                                        phi_12400_ = _e3791;
                                                    } else {
                                                        phi_12400_ = _e3795;
                                                    }
                                                    let _e3798 = phi_12400_;
                                                    local_3 = type_36(array<f64, 3>(_e3739, _e3740, _e3741), _e3780, (_e3798 + _e3780));
                                                    let _e3804 = local_19.member_3;
                                                    let _e3806 = local_19.member_2[0u];
                                                    if (_e3806[0] < 0.0lf) {
                                                        phi_12426_ = -(_e3806[0]);
                                                    } else {
                                                        phi_12426_ = _e3806[0];
                                                    }
                                                    let _e3813 = phi_12426_;
                                                    if (_e3806[1] < 0.0lf) {
                                                        phi_12433_ = -(_e3806[1]);
                                                    } else {
                                                        phi_12433_ = _e3806[1];
                                                    }
                                                    let _e3817 = phi_12433_;
                                                    if (_e3813 > _e3817) {
                                                        phi_12438_ = _e3813;
                                                    } else {
                                                        phi_12438_ = _e3817;
                                                    }
                                                    let _e3820 = phi_12438_;
                                                    if (_e3806[2] < 0.0lf) {
                                                        phi_12445_ = -(_e3806[2]);
                                                    } else {
                                                        phi_12445_ = _e3806[2];
                                                    }
                                                    let _e3824 = phi_12445_;
                                                    if (_e3820 > _e3824) {
                                                        phi_12450_ = _e3820;
                                                    } else {
                                                        phi_12450_ = _e3824;
                                                    }
                                                    let _e3827 = phi_12450_;
                                                    let _e3829 = local_19.member_2[1u];
                                                    if (_e3829[0] < 0.0lf) {
                                                        phi_12463_ = -(_e3829[0]);
                                                    } else {
                                                        phi_12463_ = _e3829[0];
                                                    }
                                                    let _e3836 = phi_12463_;
                                                    if (_e3829[1] < 0.0lf) {
                                                        phi_12470_ = -(_e3829[1]);
                                                    } else {
                                                        phi_12470_ = _e3829[1];
                                                    }
                                                    let _e3840 = phi_12470_;
                                                    if (_e3836 > _e3840) {
                                                        phi_12475_ = _e3836;
                                                    } else {
                                                        phi_12475_ = _e3840;
                                                    }
                                                    let _e3843 = phi_12475_;
                                                    if (_e3829[2] < 0.0lf) {
                                                        phi_12482_ = -(_e3829[2]);
                                                    } else {
                                                        phi_12482_ = _e3829[2];
                                                    }
                                                    let _e3847 = phi_12482_;
                                                    if (_e3843 > _e3847) {
                                                        phi_12487_ = _e3843;
                                                    } else {
                                                        phi_12487_ = _e3847;
                                                    }
                                                    let _e3850 = phi_12487_;
                                                    if (_e3827 > _e3850) {
                                                        phi_12492_ = _e3827;
                                                    } else {
                                                        phi_12492_ = _e3850;
                                                    }
                                                    let _e3853 = phi_12492_;
                                                    let _e3856 = local_19.member_2[0u];
                                                    let _e3861 = local_19.member_2[1u];
                                                    let _e3871 = (_e3856[0] + ((_e3861[0] - _e3856[0]) * _e3534));
                                                    let _e3872 = (_e3856[1] + ((_e3861[1] - _e3856[1]) * _e3534));
                                                    let _e3873 = (_e3856[2] + ((_e3861[2] - _e3856[2]) * _e3534));
                                                    let _e3875 = local_19.member_2[1u];
                                                    let _e3880 = local_19.member_2[0u];
                                                    let _e3884 = (_e3875[0] - _e3880[0]);
                                                    let _e3885 = (_e3875[1] - _e3880[1]);
                                                    let _e3886 = (_e3875[2] - _e3880[2]);
                                                    if (_e3884 < 0.0lf) {
                                                        phi_12551_ = -(_e3884);
                                                    } else {
                                                        phi_12551_ = _e3884;
                                                    }
                                                    let _e3890 = phi_12551_;
                                                    if (_e3885 < 0.0lf) {
                                                        phi_12557_ = -(_e3885);
                                                    } else {
                                                        phi_12557_ = _e3885;
                                                    }
                                                    let _e3894 = phi_12557_;
                                                    if (_e3890 > _e3894) {
                                                        phi_12562_ = _e3890;
                                                    } else {
                                                        phi_12562_ = _e3894;
                                                    }
                                                    let _e3897 = phi_12562_;
                                                    if (_e3886 < 0.0lf) {
                                                        phi_12568_ = -(_e3886);
                                                    } else {
                                                        phi_12568_ = _e3886;
                                                    }
                                                    let _e3901 = phi_12568_;
                                                    if (_e3897 > _e3901) {
                                                        phi_12573_ = _e3897;
                                                    } else {
                                                        phi_12573_ = _e3901;
                                                    }
                                                    let _e3904 = phi_12573_;
                                                    let _e3912 = ((((_e3537 * _e3904) * f64(1.01f)) + ((_e3853 + _e3804) * (1.1102230246251565e-16lf * f64(8f)))) + _e3804);
                                                    if (_e3871 < 0.0lf) {
                                                        phi_12587_ = -(_e3871);
                                                    } else {
                                                        phi_12587_ = _e3871;
                                                    }
                                                    let _e3916 = phi_12587_;
                                                    if (_e3872 < 0.0lf) {
                                                        phi_12593_ = -(_e3872);
                                                    } else {
                                                        phi_12593_ = _e3872;
                                                    }
                                                    let _e3920 = phi_12593_;
                                                    if (_e3916 > _e3920) {
                                                        phi_12598_ = _e3916;
                                                    } else {
                                                        phi_12598_ = _e3920;
                                                    }
                                                    let _e3923 = phi_12598_;
                                                    if (_e3873 < 0.0lf) {
                                                        phi_12604_ = -(_e3873);
                                                    } else {
                                                        phi_12604_ = _e3873;
                                                    }
                                                    let _e3927 = phi_12604_;
                                                    if (_e3923 > _e3927) {
                                                        phi_12609_ = _e3923;
                                                    } else {
                                                        phi_12609_ = _e3927;
                                                    }
                                                    let _e3930 = phi_12609_;
                                                    local_4 = type_36(array<f64, 3>(_e3871, _e3872, _e3873), _e3912, (_e3930 + _e3912));
                                                    let _e3935 = local_3.member;
                                                    let _e3940 = local_4.member;
                                                    let _e3946 = ((_e3935[1] * _e3940[2]) - (_e3935[2] * _e3940[1]));
                                                    let _e3949 = ((_e3935[2] * _e3940[0]) - (_e3935[0] * _e3940[2]));
                                                    let _e3952 = ((_e3935[0] * _e3940[1]) - (_e3935[1] * _e3940[0]));
                                                    if (_e3946 < 0.0lf) {
                                                        phi_12658_ = -(_e3946);
                                                    } else {
                                                        phi_12658_ = _e3946;
                                                    }
                                                    let _e3956 = phi_12658_;
                                                    if (_e3949 < 0.0lf) {
                                                        phi_12664_ = -(_e3949);
                                                    } else {
                                                        phi_12664_ = _e3949;
                                                    }
                                                    let _e3960 = phi_12664_;
                                                    if (_e3956 > _e3960) {
                                                        if (_e3946 < 0.0lf) {
                                                            phi_12674_ = -(_e3946);
                                                        } else {
                                                            phi_12674_ = _e3946;
                                                        }
                                                        let _e3978 = phi_12674_;
                                                        if (_e3952 < 0.0lf) {
                                                            phi_12680_ = -(_e3952);
                                                        } else {
                                                            phi_12680_ = _e3952;
                                                        }
                                                        let _e3982 = phi_12680_;
                                                        if (_e3978 > _e3982) {
                                                            phi_12685_ = 2u;
                                                            phi_12686_ = 1u;
                                                        } else {
                                                            phi_12685_ = 1u;
                                                            phi_12686_ = 0u;
                                                        }
                                                        let _e3985 = phi_12685_;
                                                        let _e3987 = phi_12686_;
                                                        phi_12705_ = _e3985;
                                                        phi_12706_ = _e3987;
                                                    } else {
                                                        if (_e3949 < 0.0lf) {
                                                            phi_12692_ = -(_e3949);
                                                        } else {
                                                            phi_12692_ = _e3949;
                                                        }
                                                        let _e3965 = phi_12692_;
                                                        if (_e3952 < 0.0lf) {
                                                            phi_12698_ = -(_e3952);
                                                        } else {
                                                            phi_12698_ = _e3952;
                                                        }
                                                        let _e3969 = phi_12698_;
                                                        if (_e3965 > _e3969) {
                                                            phi_12703_ = 0u;
                                                            phi_12704_ = 2u;
                                                        } else {
                                                            phi_12703_ = 1u;
                                                            phi_12704_ = 0u;
                                                        }
                                                        let _e3972 = phi_12703_;
                                                        let _e3974 = phi_12704_;
                                                        phi_12705_ = _e3972;
                                                        phi_12706_ = _e3974;
                                                    }
                                                    let _e3989 = phi_12705_;
                                                    let _e3991 = phi_12706_;
                                                    let _e3994 = local_3.member[_e3991];
                                                    let _e3997 = local_4.member[_e3989];
                                                    let _e4001 = local_3.member[_e3989];
                                                    let _e4004 = local_4.member[_e3991];
                                                    let _e4006 = ((_e3994 * _e3997) - (_e4001 * _e4004));
                                                    let _e4007 = f64(1f);
                                                    let _e4008 = f64(2f);
                                                    let _e4010 = local_3.member_1;
                                                    let _e4012 = local_4.member_2;
                                                    let _e4015 = local_3.member_2;
                                                    let _e4017 = local_4.member_1;
                                                    let _e4023 = local_3.member_2;
                                                    let _e4026 = local_4.member_2;
                                                    let _e4035 = local_3.member_2;
                                                    let _e4038 = local_4.member_2;
                                                    let _e4042 = (((((_e4010 * _e4012) + (_e4015 * _e4017)) * f64(2.01f)) + (((_e4023 * _e4008) * (_e4026 * _e4008)) * (1.1102230246251565e-16lf * _e4008))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e4007 + _e4035) * (_e4007 + _e4038))));
                                                    if (_e4006 < 0.0lf) {
                                                        phi_12779_ = -(_e4006);
                                                    } else {
                                                        phi_12779_ = _e4006;
                                                    }
                                                    let _e4046 = phi_12779_;
                                                    if (_e4046 > _e4042) {
                                                        if (_e4006 < f64(0f)) {
                                                            phi_12791_ = f64(-1f);
                                                        } else {
                                                            phi_12791_ = f64(1f);
                                                        }
                                                        let _e4053 = phi_12791_;
                                                        let _e4056 = local_2.member[_e3991];
                                                        let _e4059 = local_4.member[_e3989];
                                                        let _e4063 = local_2.member[_e3989];
                                                        let _e4066 = local_4.member[_e3991];
                                                        let _e4069 = f64(1f);
                                                        let _e4070 = f64(2f);
                                                        let _e4072 = local_2.member_1;
                                                        let _e4074 = local_4.member_2;
                                                        let _e4077 = local_2.member_2;
                                                        let _e4079 = local_4.member_1;
                                                        let _e4085 = local_2.member_2;
                                                        let _e4088 = local_4.member_2;
                                                        let _e4097 = local_2.member_2;
                                                        let _e4100 = local_4.member_2;
                                                        let _e4104 = (((((_e4072 * _e4074) + (_e4077 * _e4079)) * f64(2.01f)) + (((_e4085 * _e4070) * (_e4088 * _e4070)) * (1.1102230246251565e-16lf * _e4070))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e4069 + _e4097) * (_e4069 + _e4100))));
                                                        let _e4107 = local_3.member[_e3991];
                                                        let _e4110 = local_2.member[_e3989];
                                                        let _e4114 = local_3.member[_e3989];
                                                        let _e4117 = local_2.member[_e3991];
                                                        let _e4120 = f64(1f);
                                                        let _e4121 = f64(2f);
                                                        let _e4123 = local_3.member_1;
                                                        let _e4125 = local_2.member_2;
                                                        let _e4128 = local_3.member_2;
                                                        let _e4130 = local_2.member_1;
                                                        let _e4136 = local_3.member_2;
                                                        let _e4139 = local_2.member_2;
                                                        let _e4148 = local_3.member_2;
                                                        let _e4151 = local_2.member_2;
                                                        let _e4155 = (((((_e4123 * _e4125) + (_e4128 * _e4130)) * f64(2.01f)) + (((_e4136 * _e4121) * (_e4139 * _e4121)) * (1.1102230246251565e-16lf * _e4121))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e4120 + _e4148) * (_e4120 + _e4151))));
                                                        let _e4156 = (_e4006 * _e4053);
                                                        let _e4157 = (((_e4056 * _e4059) - (_e4063 * _e4066)) * _e4053);
                                                        let _e4158 = (((_e4107 * _e4110) - (_e4114 * _e4117)) * _e4053);
                                                        if (_e4156 < 0.0lf) {
                                                            phi_12934_ = -(_e4156);
                                                        } else {
                                                            phi_12934_ = _e4156;
                                                        }
                                                        let _e4162 = phi_12934_;
                                                        if (_e4157 < 0.0lf) {
                                                            phi_12940_ = -(_e4157);
                                                        } else {
                                                            phi_12940_ = _e4157;
                                                        }
                                                        let _e4166 = phi_12940_;
                                                        if (_e4158 < 0.0lf) {
                                                            phi_12947_ = -(_e4158);
                                                        } else {
                                                            phi_12947_ = _e4158;
                                                        }
                                                        let _e4171 = phi_12947_;
                                                        let _e4175 = (((_e4162 + _e4166) + _e4171) * (1.1102230246251565e-16lf * f64(4f)));
                                                        if (_e253.member != 0u) {
                                                            phi_12983_ = array<type_37, 4>(type_37(_e4157, _e4104), type_37(_e4158, _e4155), type_37((_e4156 - _e4157), ((_e4042 + _e4104) + _e4175)), type_37((_e4156 - _e4158), ((_e4042 + _e4155) + _e4175)));
                                                        } else {
                                                            let _e4178 = ((_e4156 - _e4157) - _e4158);
                                                            let _e4181 = (((_e4042 + _e4104) + _e4155) + _e4175);
                                                            phi_12983_ = array<type_37, 4>(type_37(_e4157, _e4104), type_37(_e4158, _e4155), type_37(_e4178, _e4181), type_37(_e4178, _e4181));
                                                        }
                                                        let _e4199 = phi_12983_;
                                                        local_5 = array<type_37, 4>(type_37(_e4199[0].member, _e4199[0].member_1), type_37(_e4199[1].member, _e4199[1].member_1), type_37(_e4199[2].member, _e4199[2].member_1), type_37(_e4199[3].member, _e4199[3].member_1));
                                                        phi_13003_ = type_9(0u, 4u);
                                                        phi_13006_ = true;
                                                        loop {
                                                            let _e4218 = phi_13003_;
                                                            let _e4220 = phi_13006_;
                                                            local_28 = _e4220;
                                                            if (_e4218.member < _e4218.member_1) {
                                                                phi_13004_ = type_9((_e4218.member + 1u), _e4218.member_1);
                                                                phi_13029_ = type_9(1u, _e4218.member);
                                                            } else {
                                                                phi_13004_ = _e4218;
                                                                phi_13029_ = type_9(0u, type_9().member_1);
                                                            }
                                                            let _e4232 = phi_13004_;
                                                            let _e4234 = phi_13029_;
                                                            if (bitcast<i32>(_e4234.member) != 0i) {
                                                                let _e4241 = local_5[_e4234.member_1].member;
                                                                let _e4244 = local_5[_e4234.member_1].member_1;
                                                                let _e4246 = (_e4241 < -(_e4244));
                                                                if _e4246 {
                                                                    phi_13056_ = bool();
                                                                    phi_13057_ = false;
                                                                } else {
                                                                    phi_13056_ = (_e4220 && (_e4241 > _e4244));
                                                                    phi_13057_ = true;
                                                                }
                                                                let _e4250 = phi_13056_;
                                                                let _e4252 = phi_13057_;
                                                                phi_13007_ = _e4250;
                                                                phi_13058_ = _e4252;
                                                                phi_13059_ = _e4246;
                                                            } else {
                                                                phi_13007_ = bool();
                                                                phi_13058_ = false;
                                                                phi_13059_ = false;
                                                            }
                                                            let _e4254 = phi_13007_;
                                                            let _e4256 = phi_13058_;
                                                            let _e4258 = phi_13059_;
                                                            local_27 = _e4258;
                                                            continue;
                                                            continuing {
                                                                phi_13003_ = _e4232;
                                                                phi_13006_ = _e4254;
                                                                break if !(_e4256);
                                                            }
                                                        }
                                                        let _e4261 = local_27;
                                                        if _e4261 {
                                                            phi_13063_ = false;
                                                        } else {
                                                            phi_13063_ = true;
                                                        }
                                                        let _e4263 = phi_13063_;
                                                        if _e4263 {
                                                            let _e4265 = local_28;
                                                            if _e4265 {
                                                                phi_13070_ = 1u;
                                                            } else {
                                                                phi_13070_ = 2u;
                                                            }
                                                            let _e4267 = phi_13070_;
                                                            phi_13071_ = _e4267;
                                                            phi_13072_ = false;
                                                        } else {
                                                            phi_13071_ = u32();
                                                            phi_13072_ = true;
                                                        }
                                                        let _e4269 = phi_13071_;
                                                        let _e4271 = phi_13072_;
                                                        phi_13073_ = _e4269;
                                                        phi_13074_ = 0u;
                                                        phi_13075_ = _e4271;
                                                    } else {
                                                        phi_13073_ = u32();
                                                        phi_13074_ = 2u;
                                                        phi_13075_ = true;
                                                    }
                                                    let _e4273 = phi_13073_;
                                                    let _e4275 = phi_13074_;
                                                    let _e4277 = phi_13075_;
                                                    if _e4277 {
                                                        phi_13079_ = _e4275;
                                                    } else {
                                                        phi_13079_ = _e4273;
                                                    }
                                                    let _e4279 = phi_13079_;
                                                    let _e4280 = (_e4279 == 0u);
                                                    if _e4280 {
                                                        phi_15838_ = bool();
                                                        phi_15839_ = f64();
                                                        phi_15840_ = f64();
                                                        phi_15841_ = false;
                                                        phi_15842_ = false;
                                                        phi_15843_ = false;
                                                    } else {
                                                        if (_e4279 == 1u) {
                                                            phi_13089_ = _e3523.member_2;
                                                        } else {
                                                            phi_13089_ = false;
                                                        }
                                                        let _e4284 = phi_13089_;
                                                        let _e4286 = (_e556 * f64(0.99f));
                                                        if _e4284 {
                                                            if ((_e3523.member_1 - _e3523.member) <= _e4286) {
                                                                phi_13102_ = false;
                                                            } else {
                                                                phi_13102_ = true;
                                                            }
                                                            let _e4292 = phi_13102_;
                                                            phi_13103_ = _e4292;
                                                        } else {
                                                            phi_13103_ = true;
                                                        }
                                                        let _e4294 = phi_13103_;
                                                        if _e4294 {
                                                            let _e4299 = local_19.member[0u];
                                                            let _e4306 = local_19.member_1[0u];
                                                            let _e4312 = local_19.member_2[0u];
                                                            let _e4316 = (_e4299[0] - _e4306[0]);
                                                            let _e4317 = (_e4299[1] - _e4306[1]);
                                                            let _e4318 = (_e4299[2] - _e4306[2]);
                                                            if (_e253.member == 0u) {
                                                                phi_13164_ = array<f64, 3>(_e4299[0], _e4299[1], _e4299[2]);
                                                            } else {
                                                                phi_13164_ = array<f64, 3>((_e4316 - _e4312[0]), (_e4317 - _e4312[1]), (_e4318 - _e4312[2]));
                                                            }
                                                            let _e4325 = phi_13164_;
                                                            let _e4331 = local_19.member[1u];
                                                            let _e4338 = local_19.member_1[1u];
                                                            let _e4344 = local_19.member_2[1u];
                                                            let _e4348 = (_e4331[0] - _e4338[0]);
                                                            let _e4349 = (_e4331[1] - _e4338[1]);
                                                            let _e4350 = (_e4331[2] - _e4338[2]);
                                                            if (_e253.member == 0u) {
                                                                phi_13229_ = array<f64, 3>(_e4331[0], _e4331[1], _e4331[2]);
                                                            } else {
                                                                phi_13229_ = array<f64, 3>((_e4348 - _e4344[0]), (_e4349 - _e4344[1]), (_e4350 - _e4344[2]));
                                                            }
                                                            let _e4357 = phi_13229_;
                                                            let _e4363 = local_19.member[0u];
                                                            if (_e4363[0] < 0.0lf) {
                                                                phi_13251_ = -(_e4363[0]);
                                                            } else {
                                                                phi_13251_ = _e4363[0];
                                                            }
                                                            let _e4370 = phi_13251_;
                                                            if (_e4363[1] < 0.0lf) {
                                                                phi_13258_ = -(_e4363[1]);
                                                            } else {
                                                                phi_13258_ = _e4363[1];
                                                            }
                                                            let _e4374 = phi_13258_;
                                                            if (_e4370 > _e4374) {
                                                                phi_13263_ = _e4370;
                                                            } else {
                                                                phi_13263_ = _e4374;
                                                            }
                                                            let _e4377 = phi_13263_;
                                                            if (_e4363[2] < 0.0lf) {
                                                                phi_13270_ = -(_e4363[2]);
                                                            } else {
                                                                phi_13270_ = _e4363[2];
                                                            }
                                                            let _e4381 = phi_13270_;
                                                            if (_e4377 > _e4381) {
                                                                phi_13275_ = _e4377;
                                                            } else {
                                                                phi_13275_ = _e4381;
                                                            }
                                                            let _e4384 = phi_13275_;
                                                            let _e4387 = local_19.member[1u];
                                                            if (_e4387[0] < 0.0lf) {
                                                                phi_13288_ = -(_e4387[0]);
                                                            } else {
                                                                phi_13288_ = _e4387[0];
                                                            }
                                                            let _e4394 = phi_13288_;
                                                            if (_e4387[1] < 0.0lf) {
                                                                phi_13295_ = -(_e4387[1]);
                                                            } else {
                                                                phi_13295_ = _e4387[1];
                                                            }
                                                            let _e4398 = phi_13295_;
                                                            if (_e4394 > _e4398) {
                                                                phi_13300_ = _e4394;
                                                            } else {
                                                                phi_13300_ = _e4398;
                                                            }
                                                            let _e4401 = phi_13300_;
                                                            if (_e4387[2] < 0.0lf) {
                                                                phi_13307_ = -(_e4387[2]);
                                                            } else {
                                                                phi_13307_ = _e4387[2];
                                                            }
                                                            let _e4405 = phi_13307_;
                                                            if (_e4401 > _e4405) {
                                                                phi_13312_ = _e4401;
                                                            } else {
                                                                phi_13312_ = _e4405;
                                                            }
                                                            let _e4408 = phi_13312_;
                                                            if (_e4384 > _e4408) {
                                                                phi_13317_ = _e4384;
                                                            } else {
                                                                phi_13317_ = _e4408;
                                                            }
                                                            let _e4411 = phi_13317_;
                                                            let _e4413 = local_19.member_3;
                                                            let _e4417 = local_19.member_1[0u];
                                                            if (_e4417[0] < 0.0lf) {
                                                                phi_13334_ = -(_e4417[0]);
                                                            } else {
                                                                phi_13334_ = _e4417[0];
                                                            }
                                                            let _e4424 = phi_13334_;
                                                            if (_e4417[1] < 0.0lf) {
                                                                phi_13341_ = -(_e4417[1]);
                                                            } else {
                                                                phi_13341_ = _e4417[1];
                                                            }
                                                            let _e4428 = phi_13341_;
                                                            if (_e4424 > _e4428) {
                                                                phi_13346_ = _e4424;
                                                            } else {
                                                                phi_13346_ = _e4428;
                                                            }
                                                            let _e4431 = phi_13346_;
                                                            if (_e4417[2] < 0.0lf) {
                                                                phi_13353_ = -(_e4417[2]);
                                                            } else {
                                                                phi_13353_ = _e4417[2];
                                                            }
                                                            let _e4435 = phi_13353_;
                                                            if (_e4431 > _e4435) {
                                                                phi_13358_ = _e4431;
                                                            } else {
                                                                phi_13358_ = _e4435;
                                                            }
                                                            let _e4438 = phi_13358_;
                                                            let _e4441 = local_19.member_1[1u];
                                                            if (_e4441[0] < 0.0lf) {
                                                                phi_13372_ = -(_e4441[0]);
                                                            } else {
                                                                phi_13372_ = _e4441[0];
                                                            }
                                                            let _e4448 = phi_13372_;
                                                            if (_e4441[1] < 0.0lf) {
                                                                phi_13379_ = -(_e4441[1]);
                                                            } else {
                                                                phi_13379_ = _e4441[1];
                                                            }
                                                            let _e4452 = phi_13379_;
                                                            if (_e4448 > _e4452) {
                                                                phi_13384_ = _e4448;
                                                            } else {
                                                                phi_13384_ = _e4452;
                                                            }
                                                            let _e4455 = phi_13384_;
                                                            if (_e4441[2] < 0.0lf) {
                                                                phi_13391_ = -(_e4441[2]);
                                                            } else {
                                                                phi_13391_ = _e4441[2];
                                                            }
                                                            let _e4459 = phi_13391_;
                                                            if (_e4455 > _e4459) {
                                                                phi_13396_ = _e4455;
                                                            } else {
                                                                phi_13396_ = _e4459;
                                                            }
                                                            let _e4462 = phi_13396_;
                                                            if (_e4438 > _e4462) {
                                                                phi_13401_ = _e4438;
                                                            } else {
                                                                phi_13401_ = _e4462;
                                                            }
                                                            let _e4465 = phi_13401_;
                                                            let _e4467 = local_19.member_3;
                                                            let _e4471 = local_19.member_2[0u];
                                                            if (_e4471[0] < 0.0lf) {
                                                                phi_13418_ = -(_e4471[0]);
                                                            } else {
                                                                phi_13418_ = _e4471[0];
                                                            }
                                                            let _e4478 = phi_13418_;
                                                            if (_e4471[1] < 0.0lf) {
                                                                phi_13425_ = -(_e4471[1]);
                                                            } else {
                                                                phi_13425_ = _e4471[1];
                                                            }
                                                            let _e4482 = phi_13425_;
                                                            if (_e4478 > _e4482) {
                                                                phi_13430_ = _e4478;
                                                            } else {
                                                                phi_13430_ = _e4482;
                                                            }
                                                            let _e4485 = phi_13430_;
                                                            if (_e4471[2] < 0.0lf) {
                                                                phi_13437_ = -(_e4471[2]);
                                                            } else {
                                                                phi_13437_ = _e4471[2];
                                                            }
                                                            let _e4489 = phi_13437_;
                                                            if (_e4485 > _e4489) {
                                                                phi_13442_ = _e4485;
                                                            } else {
                                                                phi_13442_ = _e4489;
                                                            }
                                                            let _e4492 = phi_13442_;
                                                            let _e4495 = local_19.member_2[1u];
                                                            if (_e4495[0] < 0.0lf) {
                                                                phi_13456_ = -(_e4495[0]);
                                                            } else {
                                                                phi_13456_ = _e4495[0];
                                                            }
                                                            let _e4502 = phi_13456_;
                                                            if (_e4495[1] < 0.0lf) {
                                                                phi_13463_ = -(_e4495[1]);
                                                            } else {
                                                                phi_13463_ = _e4495[1];
                                                            }
                                                            let _e4506 = phi_13463_;
                                                            if (_e4502 > _e4506) {
                                                                phi_13468_ = _e4502;
                                                            } else {
                                                                phi_13468_ = _e4506;
                                                            }
                                                            let _e4509 = phi_13468_;
                                                            if (_e4495[2] < 0.0lf) {
                                                                phi_13475_ = -(_e4495[2]);
                                                            } else {
                                                                phi_13475_ = _e4495[2];
                                                            }
                                                            let _e4513 = phi_13475_;
                                                            if (_e4509 > _e4513) {
                                                                phi_13480_ = _e4509;
                                                            } else {
                                                                phi_13480_ = _e4513;
                                                            }
                                                            let _e4516 = phi_13480_;
                                                            if (_e4492 > _e4516) {
                                                                phi_13485_ = _e4492;
                                                            } else {
                                                                phi_13485_ = _e4516;
                                                            }
                                                            let _e4519 = phi_13485_;
                                                            let _e4521 = local_19.member_3;
                                                            let _e4529 = local_19.member_3;
                                                            let _e4537 = (_e556 * f64(0.00390625f));
                                                            let _e4538 = f64(0f);
                                                            let _e4539 = f64(1f);
                                                            local = type_35(array<f64, 4>(_e4538, _e4538, _e4538, _e4538), array<f64, 4>(_e4538, _e4538, _e4538, _e4538), array<f64, 4>(_e4539, _e4539, _e4539, _e4539));
                                                            phi_13532_ = type_9(0u, 96u);
                                                            phi_13535_ = _e3523.member;
                                                            phi_13537_ = _e3523.member;
                                                            phi_13539_ = (_e3523.member_1 - _e3523.member);
                                                            phi_13541_ = _e3523.member;
                                                            phi_13543_ = false;
                                                            phi_13545_ = 0u;
                                                            loop {
                                                                let _e4546 = phi_13532_;
                                                                let _e4548 = phi_13535_;
                                                                let _e4550 = phi_13537_;
                                                                let _e4552 = phi_13539_;
                                                                let _e4554 = phi_13541_;
                                                                let _e4556 = phi_13543_;
                                                                let _e4558 = phi_13545_;
                                                                local_32 = _e4548;
                                                                local_79 = _e4550;
                                                                if (_e4546.member < _e4546.member_1) {
                                                                    phi_13533_ = type_9((_e4546.member + 1u), _e4546.member_1);
                                                                    phi_13568_ = type_9(1u, _e4546.member);
                                                                } else {
                                                                    phi_13533_ = _e4546;
                                                                    phi_13568_ = type_9(0u, type_9().member_1);
                                                                }
                                                                let _e4570 = phi_13533_;
                                                                let _e4572 = phi_13568_;
                                                                if (bitcast<i32>(_e4572.member) != 0i) {
                                                                    let _e4578 = local_19.member[0u];
                                                                    let _e4584 = local_19.member[1u];
                                                                    let _e4600 = local_19.member_1[0u];
                                                                    let _e4606 = local_19.member_1[1u];
                                                                    let _e4622 = local_19.member_2[0u];
                                                                    let _e4628 = local_19.member_2[1u];
                                                                    let _e4642 = function_5(array<f64, 3>((_e4578[0] + ((_e4584[0] - _e4578[0]) * _e4548)), (_e4578[1] + ((_e4584[1] - _e4578[1]) * _e4548)), (_e4578[2] + ((_e4584[2] - _e4578[2]) * _e4548))), array<f64, 3>((_e4600[0] + ((_e4606[0] - _e4600[0]) * _e4548)), (_e4600[1] + ((_e4606[1] - _e4600[1]) * _e4548)), (_e4600[2] + ((_e4606[2] - _e4600[2]) * _e4548))), array<f64, 3>((_e4622[0] + ((_e4628[0] - _e4622[0]) * _e4548)), (_e4622[1] + ((_e4628[1] - _e4622[1]) * _e4548)), (_e4622[2] + ((_e4628[2] - _e4622[2]) * _e4548))), _e253.member);
                                                                    if (_e4558 == 0u) {
                                                                        phi_13697_ = _e4642;
                                                                    } else {
                                                                        let _e4644 = f64(0f);
                                                                        if (_e4558 == 1u) {
                                                                            phi_13683_ = _e4642[0];
                                                                        } else {
                                                                            phi_13683_ = _e4644;
                                                                        }
                                                                        let _e4648 = phi_13683_;
                                                                        if (_e4558 == 2u) {
                                                                            phi_13689_ = _e4642[1];
                                                                        } else {
                                                                            phi_13689_ = _e4644;
                                                                        }
                                                                        let _e4652 = phi_13689_;
                                                                        if (_e4558 == 3u) {
                                                                            phi_13695_ = _e4642[2];
                                                                        } else {
                                                                            phi_13695_ = _e4644;
                                                                        }
                                                                        let _e4656 = phi_13695_;
                                                                        phi_13697_ = array<f64, 3>(_e4648, _e4652, _e4656);
                                                                    }
                                                                    let _e4659 = phi_13697_;
                                                                    if (_e4659[0] < 0.0lf) {
                                                                        phi_13704_ = -(_e4659[0]);
                                                                    } else {
                                                                        phi_13704_ = _e4659[0];
                                                                    }
                                                                    let _e4664 = phi_13704_;
                                                                    if (_e4659[1] < 0.0lf) {
                                                                        phi_13711_ = -(_e4659[1]);
                                                                    } else {
                                                                        phi_13711_ = _e4659[1];
                                                                    }
                                                                    let _e4669 = phi_13711_;
                                                                    if (_e4659[2] < 0.0lf) {
                                                                        phi_13719_ = -(_e4659[2]);
                                                                    } else {
                                                                        phi_13719_ = _e4659[2];
                                                                    }
                                                                    let _e4675 = phi_13719_;
                                                                    let _e4676 = ((_e4664 + _e4669) + _e4675);
                                                                    if (_e4676 > f64(0f)) {
                                                                        if ((bitcast<u64>(_e4676) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                                            let _e4683 = (f64(1f) / _e4676);
                                                                            let _e4685 = (_e4659[0] * _e4683);
                                                                            let _e4687 = (_e4659[1] * _e4683);
                                                                            let _e4689 = (_e4659[2] * _e4683);
                                                                            let _e4694 = (((_e4685 * _e4685) + (_e4687 * _e4687)) + (_e4689 * _e4689));
                                                                            if (_e4694 <= 2.2250738585072014e-308lf) {
                                                                                if (_e4694 > 0.0lf) {
                                                                                    phi_13758_ = (1.464336215552873e-154lf * 2.0lf);
                                                                                } else {
                                                                                    phi_13758_ = 0.0lf;
                                                                                }
                                                                                let _e4746 = phi_13758_;
                                                                                phi_13822_ = _e4746;
                                                                            } else {
                                                                                phi_13765_ = type_18(0i, 5i);
                                                                                phi_13768_ = bitcast<f64>(((bitcast<u64>(_e4694) / 2lu) + 2303426169912950784lu));
                                                                                loop {
                                                                                    let _e4701 = phi_13765_;
                                                                                    let _e4703 = phi_13768_;
                                                                                    local_29 = _e4703;
                                                                                    if (_e4701.member < _e4701.member_1) {
                                                                                        let _e4710 = (_e4701.member + 1i);
                                                                                        if ((false == (_e4710 > _e4701.member)) != false) {
                                                                                            phi_13789_ = true;
                                                                                        } else {
                                                                                            phi_13789_ = false;
                                                                                        }
                                                                                        let _e4715 = phi_13789_;
                                                                                        if _e4715 {
                                                                                            phi_13795_ = type_19(0u, type_19().member_1);
                                                                                        } else {
                                                                                            phi_13795_ = type_19(1u, _e4710);
                                                                                        }
                                                                                        let _e4720 = phi_13795_;
                                                                                        phi_13766_ = type_18(_e4720.member_1, _e4701.member_1);
                                                                                        phi_13809_ = type_19(1u, _e4701.member);
                                                                                    } else {
                                                                                        phi_13766_ = _e4701;
                                                                                        phi_13809_ = type_19(0u, type_19().member_1);
                                                                                    }
                                                                                    let _e4726 = phi_13766_;
                                                                                    let _e4728 = phi_13809_;
                                                                                    let _e4731 = (bitcast<i32>(_e4728.member) != 0i);
                                                                                    if _e4731 {
                                                                                        phi_13769_ = (0.5lf * (_e4703 + (_e4694 / _e4703)));
                                                                                    } else {
                                                                                        phi_13769_ = f64();
                                                                                    }
                                                                                    let _e4736 = phi_13769_;
                                                                                    continue;
                                                                                    continuing {
                                                                                        phi_13765_ = _e4726;
                                                                                        phi_13768_ = _e4736;
                                                                                        break if !(_e4731);
                                                                                    }
                                                                                }
                                                                                let _e4741 = local_29;
                                                                                phi_13822_ = (_e4741 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                            }
                                                                            let _e4748 = phi_13822_;
                                                                            let _e4750 = (1.1102230246251565e-16lf * f64(12f));
                                                                            let _e4757 = ((((((((_e4411 + _e4413) + (_e4465 + _e4467)) + (_e4519 + _e4521)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4529 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e894 * _e4748) * (f64(1f) + _e4750)));
                                                                            let _e4762 = (((_e4685 * _e4299[0]) + (_e4687 * _e4299[1])) + (_e4689 * _e4299[2]));
                                                                            let _e4767 = (((_e4685 * _e4316) + (_e4687 * _e4317)) + (_e4689 * _e4318));
                                                                            let _e4772 = (((_e4685 * (_e4299[0] - _e4312[0])) + (_e4687 * (_e4299[1] - _e4312[1]))) + (_e4689 * (_e4299[2] - _e4312[2])));
                                                                            let _e4780 = (((_e4685 * _e4325[0]) + (_e4687 * _e4325[1])) + (_e4689 * _e4325[2]));
                                                                            let _e4786 = (((_e4685 * _e4331[0]) + (_e4687 * _e4331[1])) + (_e4689 * _e4331[2]));
                                                                            let _e4791 = (((_e4685 * _e4348) + (_e4687 * _e4349)) + (_e4689 * _e4350));
                                                                            let _e4796 = (((_e4685 * (_e4331[0] - _e4344[0])) + (_e4687 * (_e4331[1] - _e4344[1]))) + (_e4689 * (_e4331[2] - _e4344[2])));
                                                                            let _e4804 = (((_e4685 * _e4357[0]) + (_e4687 * _e4357[1])) + (_e4689 * _e4357[2]));
                                                                            if (_e4762 < 0.0lf) {
                                                                                phi_13891_ = -(_e4762);
                                                                            } else {
                                                                                phi_13891_ = _e4762;
                                                                            }
                                                                            let _e4809 = phi_13891_;
                                                                            if (_e4786 < 0.0lf) {
                                                                                phi_13897_ = -(_e4786);
                                                                            } else {
                                                                                phi_13897_ = _e4786;
                                                                            }
                                                                            let _e4813 = phi_13897_;
                                                                            if (_e4767 < 0.0lf) {
                                                                                phi_13906_ = -(_e4767);
                                                                            } else {
                                                                                phi_13906_ = _e4767;
                                                                            }
                                                                            let _e4820 = phi_13906_;
                                                                            if (_e4791 < 0.0lf) {
                                                                                phi_13912_ = -(_e4791);
                                                                            } else {
                                                                                phi_13912_ = _e4791;
                                                                            }
                                                                            let _e4824 = phi_13912_;
                                                                            if (_e4772 < 0.0lf) {
                                                                                phi_13921_ = -(_e4772);
                                                                            } else {
                                                                                phi_13921_ = _e4772;
                                                                            }
                                                                            let _e4831 = phi_13921_;
                                                                            if (_e4796 < 0.0lf) {
                                                                                phi_13927_ = -(_e4796);
                                                                            } else {
                                                                                phi_13927_ = _e4796;
                                                                            }
                                                                            let _e4835 = phi_13927_;
                                                                            if (_e4780 < 0.0lf) {
                                                                                phi_13936_ = -(_e4780);
                                                                            } else {
                                                                                phi_13936_ = _e4780;
                                                                            }
                                                                            let _e4842 = phi_13936_;
                                                                            if (_e4804 < 0.0lf) {
                                                                                phi_13942_ = -(_e4804);
                                                                            } else {
                                                                                phi_13942_ = _e4804;
                                                                            }
                                                                            let _e4846 = phi_13942_;
                                                                            phi_13948_ = type_35(array<f64, 4>(_e4762, _e4767, _e4772, _e4780), array<f64, 4>(_e4786, _e4791, _e4796, _e4804), array<f64, 4>((_e4757 + ((_e4809 + _e4813) * _e4750)), (_e4757 + ((_e4820 + _e4824) * _e4750)), (_e4757 + ((_e4831 + _e4835) * _e4750)), (_e4757 + ((_e4842 + _e4846) * _e4750))));
                                                                            phi_13949_ = false;
                                                                        } else {
                                                                            phi_13948_ = type_35();
                                                                            phi_13949_ = true;
                                                                        }
                                                                        let _e4853 = phi_13948_;
                                                                        let _e4855 = phi_13949_;
                                                                        phi_13950_ = _e4853;
                                                                        phi_13951_ = _e4855;
                                                                    } else {
                                                                        phi_13950_ = type_35();
                                                                        phi_13951_ = true;
                                                                    }
                                                                    let _e4857 = phi_13950_;
                                                                    let _e4859 = phi_13951_;
                                                                    if _e4859 {
                                                                        let _e4860 = f64(0f);
                                                                        let _e4861 = f64(1f);
                                                                        phi_13961_ = type_35(array<f64, 4>(_e4860, _e4860, _e4860, _e4860), array<f64, 4>(_e4860, _e4860, _e4860, _e4860), array<f64, 4>(_e4861, _e4861, _e4861, _e4861));
                                                                    } else {
                                                                        phi_13961_ = _e4857;
                                                                    }
                                                                    let _e4867 = phi_13961_;
                                                                    local_1 = type_35(array<f64, 4>(_e4867.member[0], _e4867.member[1], _e4867.member[2], _e4867.member[3]), array<f64, 4>(_e4867.member_1[0], _e4867.member_1[1], _e4867.member_1[2], _e4867.member_1[3]), array<f64, 4>(_e4867.member_2[0], _e4867.member_2[1], _e4867.member_2[2], _e4867.member_2[3]));
                                                                    let _e4887 = (_e4548 - _e4554);
                                                                    let _e4889 = f64(0f);
                                                                    let _e4892 = local_1.member[0u];
                                                                    let _e4895 = local_1.member_1[0u];
                                                                    let _e4898 = local_1.member[0u];
                                                                    let _e4904 = local_1.member_2[0u];
                                                                    if (((_e4892 + ((_e4895 - _e4898) * _e4548)) - _e4904) > _e4889) {
                                                                        let _e4909 = local_1.member[1u];
                                                                        let _e4912 = local_1.member_1[1u];
                                                                        let _e4915 = local_1.member[1u];
                                                                        let _e4921 = local_1.member_2[1u];
                                                                        if (((_e4909 + ((_e4912 - _e4915) * _e4548)) - _e4921) > _e4889) {
                                                                            let _e4926 = local_1.member[2u];
                                                                            let _e4929 = local_1.member_1[2u];
                                                                            let _e4932 = local_1.member[2u];
                                                                            let _e4938 = local_1.member_2[2u];
                                                                            if (((_e4926 + ((_e4929 - _e4932) * _e4548)) - _e4938) > _e4889) {
                                                                                let _e4943 = local_1.member[3u];
                                                                                let _e4946 = local_1.member_1[3u];
                                                                                let _e4949 = local_1.member[3u];
                                                                                let _e4955 = local_1.member_2[3u];
                                                                                phi_14133_ = (((_e4943 + ((_e4946 - _e4949) * _e4548)) - _e4955) > _e4889);
                                                                                phi_14134_ = false;
                                                                            } else {
                                                                                phi_14133_ = bool();
                                                                                phi_14134_ = true;
                                                                            }
                                                                            let _e4959 = phi_14133_;
                                                                            let _e4961 = phi_14134_;
                                                                            phi_14135_ = _e4959;
                                                                            phi_14136_ = _e4961;
                                                                        } else {
                                                                            phi_14135_ = bool();
                                                                            phi_14136_ = true;
                                                                        }
                                                                        let _e4963 = phi_14135_;
                                                                        let _e4965 = phi_14136_;
                                                                        phi_14137_ = _e4963;
                                                                        phi_14138_ = _e4965;
                                                                    } else {
                                                                        phi_14137_ = bool();
                                                                        phi_14138_ = true;
                                                                    }
                                                                    let _e4967 = phi_14137_;
                                                                    let _e4969 = phi_14138_;
                                                                    if _e4969 {
                                                                        phi_14142_ = false;
                                                                    } else {
                                                                        phi_14142_ = _e4967;
                                                                    }
                                                                    let _e4971 = phi_14142_;
                                                                    if _e4971 {
                                                                        if (_e4548 <= _e4550) {
                                                                            phi_14453_ = true;
                                                                        } else {
                                                                            let _e4973 = f64(0f);
                                                                            let _e4976 = local.member[0u];
                                                                            let _e4979 = local.member_1[0u];
                                                                            let _e4982 = local.member[0u];
                                                                            let _e4988 = local.member_2[0u];
                                                                            let _e4992 = local_1.member[0u];
                                                                            let _e4995 = local_1.member_1[0u];
                                                                            let _e4998 = local_1.member[0u];
                                                                            let _e5004 = local_1.member_2[0u];
                                                                            if ((((_e4976 + ((_e4979 - _e4982) * _e4548)) - _e4988) + ((_e4992 + ((_e4995 - _e4998) * _e4554)) - _e5004)) > _e4973) {
                                                                                let _e5010 = local.member[1u];
                                                                                let _e5013 = local.member_1[1u];
                                                                                let _e5016 = local.member[1u];
                                                                                let _e5022 = local.member_2[1u];
                                                                                let _e5026 = local_1.member[1u];
                                                                                let _e5029 = local_1.member_1[1u];
                                                                                let _e5032 = local_1.member[1u];
                                                                                let _e5038 = local_1.member_2[1u];
                                                                                if ((((_e5010 + ((_e5013 - _e5016) * _e4548)) - _e5022) + ((_e5026 + ((_e5029 - _e5032) * _e4554)) - _e5038)) > _e4973) {
                                                                                    let _e5044 = local.member[2u];
                                                                                    let _e5047 = local.member_1[2u];
                                                                                    let _e5050 = local.member[2u];
                                                                                    let _e5056 = local.member_2[2u];
                                                                                    let _e5060 = local_1.member[2u];
                                                                                    let _e5063 = local_1.member_1[2u];
                                                                                    let _e5066 = local_1.member[2u];
                                                                                    let _e5072 = local_1.member_2[2u];
                                                                                    if ((((_e5044 + ((_e5047 - _e5050) * _e4548)) - _e5056) + ((_e5060 + ((_e5063 - _e5066) * _e4554)) - _e5072)) > _e4973) {
                                                                                        let _e5078 = local.member[3u];
                                                                                        let _e5081 = local.member_1[3u];
                                                                                        let _e5084 = local.member[3u];
                                                                                        let _e5090 = local.member_2[3u];
                                                                                        let _e5094 = local_1.member[3u];
                                                                                        let _e5097 = local_1.member_1[3u];
                                                                                        let _e5100 = local_1.member[3u];
                                                                                        let _e5106 = local_1.member_2[3u];
                                                                                        phi_14440_ = ((((_e5078 + ((_e5081 - _e5084) * _e4548)) - _e5090) + ((_e5094 + ((_e5097 - _e5100) * _e4554)) - _e5106)) > _e4973);
                                                                                        phi_14441_ = false;
                                                                                    } else {
                                                                                        phi_14440_ = bool();
                                                                                        phi_14441_ = true;
                                                                                    }
                                                                                    let _e5111 = phi_14440_;
                                                                                    let _e5113 = phi_14441_;
                                                                                    phi_14442_ = _e5111;
                                                                                    phi_14443_ = _e5113;
                                                                                } else {
                                                                                    phi_14442_ = bool();
                                                                                    phi_14443_ = true;
                                                                                }
                                                                                let _e5115 = phi_14442_;
                                                                                let _e5117 = phi_14443_;
                                                                                phi_14444_ = _e5115;
                                                                                phi_14445_ = _e5117;
                                                                            } else {
                                                                                phi_14444_ = bool();
                                                                                phi_14445_ = true;
                                                                            }
                                                                            let _e5119 = phi_14444_;
                                                                            let _e5121 = phi_14445_;
                                                                            if _e5121 {
                                                                                phi_14449_ = false;
                                                                            } else {
                                                                                phi_14449_ = _e5119;
                                                                            }
                                                                            let _e5123 = phi_14449_;
                                                                            phi_14453_ = _e5123;
                                                                        }
                                                                        let _e5125 = phi_14453_;
                                                                        if _e5125 {
                                                                            if _e4556 {
                                                                                if (_e4548 >= _e3523.member_1) {
                                                                                    phi_14464_ = false;
                                                                                } else {
                                                                                    phi_14464_ = true;
                                                                                }
                                                                                let _e5128 = phi_14464_;
                                                                                phi_14465_ = _e5128;
                                                                            } else {
                                                                                phi_14465_ = true;
                                                                            }
                                                                            let _e5130 = phi_14465_;
                                                                            if _e5130 {
                                                                                local = type_35(array<f64, 4>(_e4867.member[0], _e4867.member[1], _e4867.member[2], _e4867.member[3]), array<f64, 4>(_e4867.member_1[0], _e4867.member_1[1], _e4867.member_1[2], _e4867.member_1[3]), array<f64, 4>(_e4867.member_2[0], _e4867.member_2[1], _e4867.member_2[2], _e4867.member_2[3]));
                                                                                let _e5152 = local.member[0u];
                                                                                let _e5155 = local.member_1[0u];
                                                                                let _e5158 = local.member_2[0u];
                                                                                if (_e5152 > _e5158) {
                                                                                    if (_e5155 > _e5158) {
                                                                                        phi_14539_ = false;
                                                                                    } else {
                                                                                        phi_14539_ = true;
                                                                                    }
                                                                                    let _e5162 = phi_14539_;
                                                                                    phi_14540_ = _e5162;
                                                                                } else {
                                                                                    phi_14540_ = true;
                                                                                }
                                                                                let _e5164 = phi_14540_;
                                                                                if _e5164 {
                                                                                    let _e5165 = (_e5155 >= _e5152);
                                                                                    if _e5165 {
                                                                                        phi_14565_ = f64();
                                                                                        phi_14566_ = false;
                                                                                    } else {
                                                                                        if ((_e5152 - _e5155) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                            phi_14563_ = (((_e5152 - _e5158) / (_e5152 - _e5155)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                            phi_14564_ = false;
                                                                                        } else {
                                                                                            phi_14563_ = f64();
                                                                                            phi_14564_ = true;
                                                                                        }
                                                                                        let _e5179 = phi_14563_;
                                                                                        let _e5181 = phi_14564_;
                                                                                        phi_14565_ = _e5179;
                                                                                        phi_14566_ = _e5181;
                                                                                    }
                                                                                    let _e5183 = phi_14565_;
                                                                                    let _e5185 = phi_14566_;
                                                                                    phi_14567_ = _e5183;
                                                                                    phi_14568_ = _e5165;
                                                                                    phi_14569_ = _e5185;
                                                                                } else {
                                                                                    phi_14567_ = f64();
                                                                                    phi_14568_ = true;
                                                                                    phi_14569_ = false;
                                                                                }
                                                                                let _e5187 = phi_14567_;
                                                                                let _e5189 = phi_14568_;
                                                                                let _e5191 = phi_14569_;
                                                                                if _e5189 {
                                                                                    phi_14574_ = f64(2f);
                                                                                    phi_14575_ = true;
                                                                                } else {
                                                                                    phi_14574_ = _e4548;
                                                                                    phi_14575_ = _e5191;
                                                                                }
                                                                                let _e5194 = phi_14574_;
                                                                                let _e5196 = phi_14575_;
                                                                                if _e5196 {
                                                                                    phi_14579_ = _e5194;
                                                                                } else {
                                                                                    phi_14579_ = _e5187;
                                                                                }
                                                                                let _e5198 = phi_14579_;
                                                                                let _e5201 = local.member[1u];
                                                                                let _e5204 = local.member_1[1u];
                                                                                let _e5207 = local.member_2[1u];
                                                                                if (_e5201 > _e5207) {
                                                                                    if (_e5204 > _e5207) {
                                                                                        phi_14611_ = false;
                                                                                    } else {
                                                                                        phi_14611_ = true;
                                                                                    }
                                                                                    let _e5211 = phi_14611_;
                                                                                    phi_14612_ = _e5211;
                                                                                } else {
                                                                                    phi_14612_ = true;
                                                                                }
                                                                                let _e5213 = phi_14612_;
                                                                                if _e5213 {
                                                                                    let _e5214 = (_e5204 >= _e5201);
                                                                                    if _e5214 {
                                                                                        phi_14637_ = f64();
                                                                                        phi_14638_ = false;
                                                                                    } else {
                                                                                        if ((_e5201 - _e5204) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                            phi_14635_ = (((_e5201 - _e5207) / (_e5201 - _e5204)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                            phi_14636_ = false;
                                                                                        } else {
                                                                                            phi_14635_ = f64();
                                                                                            phi_14636_ = true;
                                                                                        }
                                                                                        let _e5228 = phi_14635_;
                                                                                        let _e5230 = phi_14636_;
                                                                                        phi_14637_ = _e5228;
                                                                                        phi_14638_ = _e5230;
                                                                                    }
                                                                                    let _e5232 = phi_14637_;
                                                                                    let _e5234 = phi_14638_;
                                                                                    phi_14639_ = _e5232;
                                                                                    phi_14640_ = _e5214;
                                                                                    phi_14641_ = _e5234;
                                                                                } else {
                                                                                    phi_14639_ = f64();
                                                                                    phi_14640_ = true;
                                                                                    phi_14641_ = false;
                                                                                }
                                                                                let _e5236 = phi_14639_;
                                                                                let _e5238 = phi_14640_;
                                                                                let _e5240 = phi_14641_;
                                                                                if _e5238 {
                                                                                    phi_14646_ = f64(2f);
                                                                                    phi_14647_ = true;
                                                                                } else {
                                                                                    phi_14646_ = _e4548;
                                                                                    phi_14647_ = _e5240;
                                                                                }
                                                                                let _e5243 = phi_14646_;
                                                                                let _e5245 = phi_14647_;
                                                                                if _e5245 {
                                                                                    phi_14651_ = _e5243;
                                                                                } else {
                                                                                    phi_14651_ = _e5236;
                                                                                }
                                                                                let _e5247 = phi_14651_;
                                                                                if (_e5198 < _e5247) {
                                                                                    phi_14656_ = _e5198;
                                                                                } else {
                                                                                    phi_14656_ = _e5247;
                                                                                }
                                                                                let _e5250 = phi_14656_;
                                                                                let _e5253 = local.member[2u];
                                                                                let _e5256 = local.member_1[2u];
                                                                                let _e5259 = local.member_2[2u];
                                                                                if (_e5253 > _e5259) {
                                                                                    if (_e5256 > _e5259) {
                                                                                        phi_14688_ = false;
                                                                                    } else {
                                                                                        phi_14688_ = true;
                                                                                    }
                                                                                    let _e5263 = phi_14688_;
                                                                                    phi_14689_ = _e5263;
                                                                                } else {
                                                                                    phi_14689_ = true;
                                                                                }
                                                                                let _e5265 = phi_14689_;
                                                                                if _e5265 {
                                                                                    let _e5266 = (_e5256 >= _e5253);
                                                                                    if _e5266 {
                                                                                        phi_14714_ = f64();
                                                                                        phi_14715_ = false;
                                                                                    } else {
                                                                                        if ((_e5253 - _e5256) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                            phi_14712_ = (((_e5253 - _e5259) / (_e5253 - _e5256)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                            phi_14713_ = false;
                                                                                        } else {
                                                                                            phi_14712_ = f64();
                                                                                            phi_14713_ = true;
                                                                                        }
                                                                                        let _e5280 = phi_14712_;
                                                                                        let _e5282 = phi_14713_;
                                                                                        phi_14714_ = _e5280;
                                                                                        phi_14715_ = _e5282;
                                                                                    }
                                                                                    let _e5284 = phi_14714_;
                                                                                    let _e5286 = phi_14715_;
                                                                                    phi_14716_ = _e5284;
                                                                                    phi_14717_ = _e5266;
                                                                                    phi_14718_ = _e5286;
                                                                                } else {
                                                                                    phi_14716_ = f64();
                                                                                    phi_14717_ = true;
                                                                                    phi_14718_ = false;
                                                                                }
                                                                                let _e5288 = phi_14716_;
                                                                                let _e5290 = phi_14717_;
                                                                                let _e5292 = phi_14718_;
                                                                                if _e5290 {
                                                                                    phi_14723_ = f64(2f);
                                                                                    phi_14724_ = true;
                                                                                } else {
                                                                                    phi_14723_ = _e4548;
                                                                                    phi_14724_ = _e5292;
                                                                                }
                                                                                let _e5295 = phi_14723_;
                                                                                let _e5297 = phi_14724_;
                                                                                if _e5297 {
                                                                                    phi_14728_ = _e5295;
                                                                                } else {
                                                                                    phi_14728_ = _e5288;
                                                                                }
                                                                                let _e5299 = phi_14728_;
                                                                                let _e5302 = local.member[3u];
                                                                                let _e5305 = local.member_1[3u];
                                                                                let _e5308 = local.member_2[3u];
                                                                                if (_e5302 > _e5308) {
                                                                                    if (_e5305 > _e5308) {
                                                                                        phi_14760_ = false;
                                                                                    } else {
                                                                                        phi_14760_ = true;
                                                                                    }
                                                                                    let _e5312 = phi_14760_;
                                                                                    phi_14761_ = _e5312;
                                                                                } else {
                                                                                    phi_14761_ = true;
                                                                                }
                                                                                let _e5314 = phi_14761_;
                                                                                if _e5314 {
                                                                                    let _e5315 = (_e5305 >= _e5302);
                                                                                    if _e5315 {
                                                                                        phi_14786_ = f64();
                                                                                        phi_14787_ = false;
                                                                                    } else {
                                                                                        if ((_e5302 - _e5305) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                            phi_14784_ = (((_e5302 - _e5308) / (_e5302 - _e5305)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                            phi_14785_ = false;
                                                                                        } else {
                                                                                            phi_14784_ = f64();
                                                                                            phi_14785_ = true;
                                                                                        }
                                                                                        let _e5329 = phi_14784_;
                                                                                        let _e5331 = phi_14785_;
                                                                                        phi_14786_ = _e5329;
                                                                                        phi_14787_ = _e5331;
                                                                                    }
                                                                                    let _e5333 = phi_14786_;
                                                                                    let _e5335 = phi_14787_;
                                                                                    phi_14788_ = _e5333;
                                                                                    phi_14789_ = _e5315;
                                                                                    phi_14790_ = _e5335;
                                                                                } else {
                                                                                    phi_14788_ = f64();
                                                                                    phi_14789_ = true;
                                                                                    phi_14790_ = false;
                                                                                }
                                                                                let _e5337 = phi_14788_;
                                                                                let _e5339 = phi_14789_;
                                                                                let _e5341 = phi_14790_;
                                                                                if _e5339 {
                                                                                    phi_14795_ = f64(2f);
                                                                                    phi_14796_ = true;
                                                                                } else {
                                                                                    phi_14795_ = _e4548;
                                                                                    phi_14796_ = _e5341;
                                                                                }
                                                                                let _e5344 = phi_14795_;
                                                                                let _e5346 = phi_14796_;
                                                                                if _e5346 {
                                                                                    phi_14800_ = _e5344;
                                                                                } else {
                                                                                    phi_14800_ = _e5337;
                                                                                }
                                                                                let _e5348 = phi_14800_;
                                                                                if (_e5299 < _e5348) {
                                                                                    phi_14805_ = _e5299;
                                                                                } else {
                                                                                    phi_14805_ = _e5348;
                                                                                }
                                                                                let _e5351 = phi_14805_;
                                                                                if (_e5250 < _e5351) {
                                                                                    phi_14810_ = _e5250;
                                                                                } else {
                                                                                    phi_14810_ = _e5351;
                                                                                }
                                                                                let _e5354 = phi_14810_;
                                                                                if (_e5354 > _e4548) {
                                                                                    phi_14815_ = _e5354;
                                                                                } else {
                                                                                    phi_14815_ = _e4548;
                                                                                }
                                                                                let _e5357 = phi_14815_;
                                                                                let _e5358 = (_e5357 > _e3523.member_1);
                                                                                if _e5358 {
                                                                                    phi_15332_ = f64();
                                                                                    phi_15333_ = f64();
                                                                                    phi_15334_ = false;
                                                                                    phi_15335_ = false;
                                                                                } else {
                                                                                    let _e5359 = (_e5357 - _e4548);
                                                                                    let _e5360 = (_e5359 <= _e4537);
                                                                                    let _e5363 = (_e5357 + (_e556 * f64(0.01f)));
                                                                                    if (_e5363 < _e3523.member_1) {
                                                                                        phi_14829_ = _e5363;
                                                                                    } else {
                                                                                        phi_14829_ = _e3523.member_1;
                                                                                    }
                                                                                    let _e5366 = phi_14829_;
                                                                                    if _e5360 {
                                                                                        if (_e894 > f64(0f)) {
                                                                                            let _e5371 = local_19.member[0u];
                                                                                            let _e5377 = local_19.member[1u];
                                                                                            let _e5393 = local_19.member_1[0u];
                                                                                            let _e5399 = local_19.member_1[1u];
                                                                                            let _e5415 = local_19.member_2[0u];
                                                                                            let _e5421 = local_19.member_2[1u];
                                                                                            let _e5435 = function_5(array<f64, 3>((_e5371[0] + ((_e5377[0] - _e5371[0]) * _e5366)), (_e5371[1] + ((_e5377[1] - _e5371[1]) * _e5366)), (_e5371[2] + ((_e5377[2] - _e5371[2]) * _e5366))), array<f64, 3>((_e5393[0] + ((_e5399[0] - _e5393[0]) * _e5366)), (_e5393[1] + ((_e5399[1] - _e5393[1]) * _e5366)), (_e5393[2] + ((_e5399[2] - _e5393[2]) * _e5366))), array<f64, 3>((_e5415[0] + ((_e5421[0] - _e5415[0]) * _e5366)), (_e5415[1] + ((_e5421[1] - _e5415[1]) * _e5366)), (_e5415[2] + ((_e5421[2] - _e5415[2]) * _e5366))), _e253.member);
                                                                                            let _e5446 = (((_e5435[0] * _e5435[0]) + (_e5435[1] * _e5435[1])) + (_e5435[2] * _e5435[2]));
                                                                                            if (_e5446 <= 2.2250738585072014e-308lf) {
                                                                                                if (_e5446 > 0.0lf) {
                                                                                                    phi_14960_ = (1.464336215552873e-154lf * 2.0lf);
                                                                                                } else {
                                                                                                    phi_14960_ = 0.0lf;
                                                                                                }
                                                                                                let _e5498 = phi_14960_;
                                                                                                phi_15024_ = _e5498;
                                                                                            } else {
                                                                                                phi_14967_ = type_18(0i, 5i);
                                                                                                phi_14970_ = bitcast<f64>(((bitcast<u64>(_e5446) / 2lu) + 2303426169912950784lu));
                                                                                                loop {
                                                                                                    let _e5453 = phi_14967_;
                                                                                                    let _e5455 = phi_14970_;
                                                                                                    local_30 = _e5455;
                                                                                                    if (_e5453.member < _e5453.member_1) {
                                                                                                        let _e5462 = (_e5453.member + 1i);
                                                                                                        if ((false == (_e5462 > _e5453.member)) != false) {
                                                                                                            phi_14991_ = true;
                                                                                                        } else {
                                                                                                            phi_14991_ = false;
                                                                                                        }
                                                                                                        let _e5467 = phi_14991_;
                                                                                                        if _e5467 {
                                                                                                            phi_14997_ = type_19(0u, type_19().member_1);
                                                                                                        } else {
                                                                                                            phi_14997_ = type_19(1u, _e5462);
                                                                                                        }
                                                                                                        let _e5472 = phi_14997_;
                                                                                                        phi_14968_ = type_18(_e5472.member_1, _e5453.member_1);
                                                                                                        phi_15011_ = type_19(1u, _e5453.member);
                                                                                                    } else {
                                                                                                        phi_14968_ = _e5453;
                                                                                                        phi_15011_ = type_19(0u, type_19().member_1);
                                                                                                    }
                                                                                                    let _e5478 = phi_14968_;
                                                                                                    let _e5480 = phi_15011_;
                                                                                                    let _e5483 = (bitcast<i32>(_e5480.member) != 0i);
                                                                                                    if _e5483 {
                                                                                                        phi_14971_ = (0.5lf * (_e5455 + (_e5446 / _e5455)));
                                                                                                    } else {
                                                                                                        phi_14971_ = f64();
                                                                                                    }
                                                                                                    let _e5488 = phi_14971_;
                                                                                                    continue;
                                                                                                    continuing {
                                                                                                        phi_14967_ = _e5478;
                                                                                                        phi_14970_ = _e5488;
                                                                                                        break if !(_e5483);
                                                                                                    }
                                                                                                }
                                                                                                let _e5493 = local_30;
                                                                                                phi_15024_ = (_e5493 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                                            }
                                                                                            let _e5500 = phi_15024_;
                                                                                            let _e5508 = local_19.member[0u];
                                                                                            if (_e5508[0] < 0.0lf) {
                                                                                                phi_15042_ = -(_e5508[0]);
                                                                                            } else {
                                                                                                phi_15042_ = _e5508[0];
                                                                                            }
                                                                                            let _e5515 = phi_15042_;
                                                                                            if (_e5508[1] < 0.0lf) {
                                                                                                phi_15049_ = -(_e5508[1]);
                                                                                            } else {
                                                                                                phi_15049_ = _e5508[1];
                                                                                            }
                                                                                            let _e5519 = phi_15049_;
                                                                                            if (_e5515 > _e5519) {
                                                                                                phi_15054_ = _e5515;
                                                                                            } else {
                                                                                                phi_15054_ = _e5519;
                                                                                            }
                                                                                            let _e5522 = phi_15054_;
                                                                                            if (_e5508[2] < 0.0lf) {
                                                                                                phi_15061_ = -(_e5508[2]);
                                                                                            } else {
                                                                                                phi_15061_ = _e5508[2];
                                                                                            }
                                                                                            let _e5526 = phi_15061_;
                                                                                            if (_e5522 > _e5526) {
                                                                                                phi_15066_ = _e5522;
                                                                                            } else {
                                                                                                phi_15066_ = _e5526;
                                                                                            }
                                                                                            let _e5529 = phi_15066_;
                                                                                            let _e5532 = local_19.member[1u];
                                                                                            if (_e5532[0] < 0.0lf) {
                                                                                                phi_15079_ = -(_e5532[0]);
                                                                                            } else {
                                                                                                phi_15079_ = _e5532[0];
                                                                                            }
                                                                                            let _e5539 = phi_15079_;
                                                                                            if (_e5532[1] < 0.0lf) {
                                                                                                phi_15086_ = -(_e5532[1]);
                                                                                            } else {
                                                                                                phi_15086_ = _e5532[1];
                                                                                            }
                                                                                            let _e5543 = phi_15086_;
                                                                                            if (_e5539 > _e5543) {
                                                                                                phi_15091_ = _e5539;
                                                                                            } else {
                                                                                                phi_15091_ = _e5543;
                                                                                            }
                                                                                            let _e5546 = phi_15091_;
                                                                                            if (_e5532[2] < 0.0lf) {
                                                                                                phi_15098_ = -(_e5532[2]);
                                                                                            } else {
                                                                                                phi_15098_ = _e5532[2];
                                                                                            }
                                                                                            let _e5550 = phi_15098_;
                                                                                            if (_e5546 > _e5550) {
                                                                                                phi_15103_ = _e5546;
                                                                                            } else {
                                                                                                phi_15103_ = _e5550;
                                                                                            }
                                                                                            let _e5553 = phi_15103_;
                                                                                            if (_e5529 > _e5553) {
                                                                                                phi_15108_ = _e5529;
                                                                                            } else {
                                                                                                phi_15108_ = _e5553;
                                                                                            }
                                                                                            let _e5556 = phi_15108_;
                                                                                            let _e5558 = local_19.member_3;
                                                                                            let _e5562 = local_19.member_1[0u];
                                                                                            if (_e5562[0] < 0.0lf) {
                                                                                                phi_15125_ = -(_e5562[0]);
                                                                                            } else {
                                                                                                phi_15125_ = _e5562[0];
                                                                                            }
                                                                                            let _e5569 = phi_15125_;
                                                                                            if (_e5562[1] < 0.0lf) {
                                                                                                phi_15132_ = -(_e5562[1]);
                                                                                            } else {
                                                                                                phi_15132_ = _e5562[1];
                                                                                            }
                                                                                            let _e5573 = phi_15132_;
                                                                                            if (_e5569 > _e5573) {
                                                                                                phi_15137_ = _e5569;
                                                                                            } else {
                                                                                                phi_15137_ = _e5573;
                                                                                            }
                                                                                            let _e5576 = phi_15137_;
                                                                                            if (_e5562[2] < 0.0lf) {
                                                                                                phi_15144_ = -(_e5562[2]);
                                                                                            } else {
                                                                                                phi_15144_ = _e5562[2];
                                                                                            }
                                                                                            let _e5580 = phi_15144_;
                                                                                            if (_e5576 > _e5580) {
                                                                                                phi_15149_ = _e5576;
                                                                                            } else {
                                                                                                phi_15149_ = _e5580;
                                                                                            }
                                                                                            let _e5583 = phi_15149_;
                                                                                            let _e5586 = local_19.member_1[1u];
                                                                                            if (_e5586[0] < 0.0lf) {
                                                                                                phi_15163_ = -(_e5586[0]);
                                                                                            } else {
                                                                                                phi_15163_ = _e5586[0];
                                                                                            }
                                                                                            let _e5593 = phi_15163_;
                                                                                            if (_e5586[1] < 0.0lf) {
                                                                                                phi_15170_ = -(_e5586[1]);
                                                                                            } else {
                                                                                                phi_15170_ = _e5586[1];
                                                                                            }
                                                                                            let _e5597 = phi_15170_;
                                                                                            if (_e5593 > _e5597) {
                                                                                                phi_15175_ = _e5593;
                                                                                            } else {
                                                                                                phi_15175_ = _e5597;
                                                                                            }
                                                                                            let _e5600 = phi_15175_;
                                                                                            if (_e5586[2] < 0.0lf) {
                                                                                                phi_15182_ = -(_e5586[2]);
                                                                                            } else {
                                                                                                phi_15182_ = _e5586[2];
                                                                                            }
                                                                                            let _e5604 = phi_15182_;
                                                                                            if (_e5600 > _e5604) {
                                                                                                phi_15187_ = _e5600;
                                                                                            } else {
                                                                                                phi_15187_ = _e5604;
                                                                                            }
                                                                                            let _e5607 = phi_15187_;
                                                                                            if (_e5583 > _e5607) {
                                                                                                phi_15192_ = _e5583;
                                                                                            } else {
                                                                                                phi_15192_ = _e5607;
                                                                                            }
                                                                                            let _e5610 = phi_15192_;
                                                                                            let _e5612 = local_19.member_3;
                                                                                            let _e5616 = local_19.member_2[0u];
                                                                                            if (_e5616[0] < 0.0lf) {
                                                                                                phi_15209_ = -(_e5616[0]);
                                                                                            } else {
                                                                                                phi_15209_ = _e5616[0];
                                                                                            }
                                                                                            let _e5623 = phi_15209_;
                                                                                            if (_e5616[1] < 0.0lf) {
                                                                                                phi_15216_ = -(_e5616[1]);
                                                                                            } else {
                                                                                                phi_15216_ = _e5616[1];
                                                                                            }
                                                                                            let _e5627 = phi_15216_;
                                                                                            if (_e5623 > _e5627) {
                                                                                                phi_15221_ = _e5623;
                                                                                            } else {
                                                                                                phi_15221_ = _e5627;
                                                                                            }
                                                                                            let _e5630 = phi_15221_;
                                                                                            if (_e5616[2] < 0.0lf) {
                                                                                                phi_15228_ = -(_e5616[2]);
                                                                                            } else {
                                                                                                phi_15228_ = _e5616[2];
                                                                                            }
                                                                                            let _e5634 = phi_15228_;
                                                                                            if (_e5630 > _e5634) {
                                                                                                phi_15233_ = _e5630;
                                                                                            } else {
                                                                                                phi_15233_ = _e5634;
                                                                                            }
                                                                                            let _e5637 = phi_15233_;
                                                                                            let _e5640 = local_19.member_2[1u];
                                                                                            if (_e5640[0] < 0.0lf) {
                                                                                                phi_15247_ = -(_e5640[0]);
                                                                                            } else {
                                                                                                phi_15247_ = _e5640[0];
                                                                                            }
                                                                                            let _e5647 = phi_15247_;
                                                                                            if (_e5640[1] < 0.0lf) {
                                                                                                phi_15254_ = -(_e5640[1]);
                                                                                            } else {
                                                                                                phi_15254_ = _e5640[1];
                                                                                            }
                                                                                            let _e5651 = phi_15254_;
                                                                                            if (_e5647 > _e5651) {
                                                                                                phi_15259_ = _e5647;
                                                                                            } else {
                                                                                                phi_15259_ = _e5651;
                                                                                            }
                                                                                            let _e5654 = phi_15259_;
                                                                                            if (_e5640[2] < 0.0lf) {
                                                                                                phi_15266_ = -(_e5640[2]);
                                                                                            } else {
                                                                                                phi_15266_ = _e5640[2];
                                                                                            }
                                                                                            let _e5658 = phi_15266_;
                                                                                            if (_e5654 > _e5658) {
                                                                                                phi_15271_ = _e5654;
                                                                                            } else {
                                                                                                phi_15271_ = _e5658;
                                                                                            }
                                                                                            let _e5661 = phi_15271_;
                                                                                            if (_e5637 > _e5661) {
                                                                                                phi_15276_ = _e5637;
                                                                                            } else {
                                                                                                phi_15276_ = _e5661;
                                                                                            }
                                                                                            let _e5664 = phi_15276_;
                                                                                            let _e5666 = local_19.member_3;
                                                                                            let _e5674 = local_19.member_3;
                                                                                            if (((_e5500 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5556 + _e5558) + (_e5610 + _e5612)) + (_e5664 + _e5666)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5674 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e894) {
                                                                                                phi_15300_ = false;
                                                                                            } else {
                                                                                                phi_15300_ = true;
                                                                                            }
                                                                                            let _e5686 = phi_15300_;
                                                                                            phi_15301_ = _e5686;
                                                                                        } else {
                                                                                            phi_15301_ = true;
                                                                                        }
                                                                                        let _e5688 = phi_15301_;
                                                                                        phi_15302_ = _e5688;
                                                                                    } else {
                                                                                        phi_15302_ = true;
                                                                                    }
                                                                                    let _e5690 = phi_15302_;
                                                                                    if _e5690 {
                                                                                        if _e4556 {
                                                                                            if _e5360 {
                                                                                                phi_15321_ = f64();
                                                                                                phi_15322_ = true;
                                                                                            } else {
                                                                                                if (_e5359 <= (_e4552 * f64(0.25f))) {
                                                                                                    phi_15319_ = f64(0f);
                                                                                                    phi_15320_ = false;
                                                                                                } else {
                                                                                                    phi_15319_ = f64();
                                                                                                    phi_15320_ = true;
                                                                                                }
                                                                                                let _e5697 = phi_15319_;
                                                                                                let _e5699 = phi_15320_;
                                                                                                phi_15321_ = _e5697;
                                                                                                phi_15322_ = _e5699;
                                                                                            }
                                                                                            let _e5701 = phi_15321_;
                                                                                            let _e5703 = phi_15322_;
                                                                                            if _e5703 {
                                                                                                phi_15327_ = (_e4887 + _e4887);
                                                                                            } else {
                                                                                                phi_15327_ = _e5701;
                                                                                            }
                                                                                            let _e5706 = phi_15327_;
                                                                                            phi_15329_ = _e5706;
                                                                                        } else {
                                                                                            phi_15329_ = (_e3523.member_1 - _e4548);
                                                                                        }
                                                                                        let _e5708 = phi_15329_;
                                                                                        phi_15330_ = _e5708;
                                                                                        phi_15331_ = false;
                                                                                    } else {
                                                                                        phi_15330_ = f64();
                                                                                        phi_15331_ = true;
                                                                                    }
                                                                                    let _e5710 = phi_15330_;
                                                                                    let _e5712 = phi_15331_;
                                                                                    phi_15332_ = _e5710;
                                                                                    phi_15333_ = _e5359;
                                                                                    phi_15334_ = _e5690;
                                                                                    phi_15335_ = _e5712;
                                                                                }
                                                                                let _e5714 = phi_15332_;
                                                                                let _e5716 = phi_15333_;
                                                                                let _e5718 = phi_15334_;
                                                                                let _e5720 = phi_15335_;
                                                                                phi_15336_ = _e5357;
                                                                                phi_15337_ = _e5714;
                                                                                phi_15338_ = _e5716;
                                                                                phi_15339_ = _e5357;
                                                                                phi_15340_ = _e5718;
                                                                                phi_15341_ = _e5358;
                                                                                phi_15342_ = _e5720;
                                                                                phi_15343_ = false;
                                                                            } else {
                                                                                phi_15336_ = f64();
                                                                                phi_15337_ = f64();
                                                                                phi_15338_ = f64();
                                                                                phi_15339_ = f64();
                                                                                phi_15340_ = false;
                                                                                phi_15341_ = false;
                                                                                phi_15342_ = false;
                                                                                phi_15343_ = true;
                                                                            }
                                                                            let _e5722 = phi_15336_;
                                                                            let _e5724 = phi_15337_;
                                                                            let _e5726 = phi_15338_;
                                                                            let _e5728 = phi_15339_;
                                                                            let _e5730 = phi_15340_;
                                                                            let _e5732 = phi_15341_;
                                                                            let _e5734 = phi_15342_;
                                                                            let _e5736 = phi_15343_;
                                                                            phi_15344_ = _e5722;
                                                                            phi_15345_ = _e5724;
                                                                            phi_15346_ = _e5726;
                                                                            phi_15347_ = _e5728;
                                                                            phi_15348_ = false;
                                                                            phi_15349_ = _e5730;
                                                                            phi_15350_ = _e5732;
                                                                            phi_15351_ = _e5734;
                                                                            phi_15352_ = _e5736;
                                                                        } else {
                                                                            phi_15344_ = f64();
                                                                            phi_15345_ = f64();
                                                                            phi_15346_ = f64();
                                                                            phi_15347_ = f64();
                                                                            phi_15348_ = true;
                                                                            phi_15349_ = false;
                                                                            phi_15350_ = false;
                                                                            phi_15351_ = false;
                                                                            phi_15352_ = false;
                                                                        }
                                                                        let _e5738 = phi_15344_;
                                                                        let _e5740 = phi_15345_;
                                                                        let _e5742 = phi_15346_;
                                                                        let _e5744 = phi_15347_;
                                                                        let _e5746 = phi_15348_;
                                                                        let _e5748 = phi_15349_;
                                                                        let _e5750 = phi_15350_;
                                                                        let _e5752 = phi_15351_;
                                                                        let _e5754 = phi_15352_;
                                                                        phi_15353_ = _e5738;
                                                                        phi_15354_ = _e5740;
                                                                        phi_15355_ = _e5742;
                                                                        phi_15356_ = _e5744;
                                                                        phi_15357_ = _e5746;
                                                                        phi_15358_ = _e5748;
                                                                        phi_15359_ = _e5750;
                                                                        phi_15360_ = _e5752;
                                                                        phi_15361_ = _e5754;
                                                                    } else {
                                                                        phi_15353_ = f64();
                                                                        phi_15354_ = f64();
                                                                        phi_15355_ = f64();
                                                                        phi_15356_ = f64();
                                                                        phi_15357_ = true;
                                                                        phi_15358_ = false;
                                                                        phi_15359_ = false;
                                                                        phi_15360_ = false;
                                                                        phi_15361_ = false;
                                                                    }
                                                                    let _e5756 = phi_15353_;
                                                                    let _e5758 = phi_15354_;
                                                                    let _e5760 = phi_15355_;
                                                                    let _e5762 = phi_15356_;
                                                                    let _e5764 = phi_15357_;
                                                                    let _e5766 = phi_15358_;
                                                                    let _e5768 = phi_15359_;
                                                                    let _e5770 = phi_15360_;
                                                                    let _e5772 = phi_15361_;
                                                                    if _e5764 {
                                                                        if (_e4548 <= _e4550) {
                                                                            let _e5938 = (_e4558 + 1u);
                                                                            let _e5939 = (_e5938 > 3u);
                                                                            if _e5939 {
                                                                                phi_15374_ = false;
                                                                            } else {
                                                                                phi_15374_ = true;
                                                                            }
                                                                            let _e5941 = phi_15374_;
                                                                            phi_15701_ = _e5938;
                                                                            phi_15702_ = f64();
                                                                            phi_15703_ = false;
                                                                            phi_15704_ = _e5941;
                                                                            phi_15705_ = _e5939;
                                                                        } else {
                                                                            let _e5776 = local.member[0u];
                                                                            let _e5779 = local.member_1[0u];
                                                                            let _e5782 = local.member[0u];
                                                                            let _e5788 = local.member_2[0u];
                                                                            let _e5789 = ((_e5776 + ((_e5779 - _e5782) * _e4554)) - _e5788);
                                                                            let _e5792 = local.member[1u];
                                                                            let _e5795 = local.member_1[1u];
                                                                            let _e5798 = local.member[1u];
                                                                            let _e5804 = local.member_2[1u];
                                                                            let _e5805 = ((_e5792 + ((_e5795 - _e5798) * _e4554)) - _e5804);
                                                                            if (_e5789 < _e5805) {
                                                                                phi_15447_ = _e5789;
                                                                            } else {
                                                                                phi_15447_ = _e5805;
                                                                            }
                                                                            let _e5808 = phi_15447_;
                                                                            let _e5811 = local.member[2u];
                                                                            let _e5814 = local.member_1[2u];
                                                                            let _e5817 = local.member[2u];
                                                                            let _e5823 = local.member_2[2u];
                                                                            let _e5824 = ((_e5811 + ((_e5814 - _e5817) * _e4554)) - _e5823);
                                                                            let _e5827 = local.member[3u];
                                                                            let _e5830 = local.member_1[3u];
                                                                            let _e5833 = local.member[3u];
                                                                            let _e5839 = local.member_2[3u];
                                                                            let _e5840 = ((_e5827 + ((_e5830 - _e5833) * _e4554)) - _e5839);
                                                                            if (_e5824 < _e5840) {
                                                                                phi_15520_ = _e5824;
                                                                            } else {
                                                                                phi_15520_ = _e5840;
                                                                            }
                                                                            let _e5843 = phi_15520_;
                                                                            if (_e5808 < _e5843) {
                                                                                phi_15525_ = _e5808;
                                                                            } else {
                                                                                phi_15525_ = _e5843;
                                                                            }
                                                                            let _e5846 = phi_15525_;
                                                                            let _e5849 = local_1.member[0u];
                                                                            let _e5852 = local_1.member_1[0u];
                                                                            let _e5855 = local_1.member[0u];
                                                                            let _e5861 = local_1.member_2[0u];
                                                                            let _e5862 = ((_e5849 + ((_e5852 - _e5855) * _e4548)) - _e5861);
                                                                            let _e5865 = local_1.member[1u];
                                                                            let _e5868 = local_1.member_1[1u];
                                                                            let _e5871 = local_1.member[1u];
                                                                            let _e5877 = local_1.member_2[1u];
                                                                            let _e5878 = ((_e5865 + ((_e5868 - _e5871) * _e4548)) - _e5877);
                                                                            if (_e5862 < _e5878) {
                                                                                phi_15598_ = _e5862;
                                                                            } else {
                                                                                phi_15598_ = _e5878;
                                                                            }
                                                                            let _e5881 = phi_15598_;
                                                                            let _e5884 = local_1.member[2u];
                                                                            let _e5887 = local_1.member_1[2u];
                                                                            let _e5890 = local_1.member[2u];
                                                                            let _e5896 = local_1.member_2[2u];
                                                                            let _e5897 = ((_e5884 + ((_e5887 - _e5890) * _e4548)) - _e5896);
                                                                            let _e5900 = local_1.member[3u];
                                                                            let _e5903 = local_1.member_1[3u];
                                                                            let _e5906 = local_1.member[3u];
                                                                            let _e5912 = local_1.member_2[3u];
                                                                            let _e5913 = ((_e5900 + ((_e5903 - _e5906) * _e4548)) - _e5912);
                                                                            if (_e5897 < _e5913) {
                                                                                phi_15671_ = _e5897;
                                                                            } else {
                                                                                phi_15671_ = _e5913;
                                                                            }
                                                                            let _e5916 = phi_15671_;
                                                                            if (_e5881 < _e5916) {
                                                                                phi_15676_ = _e5881;
                                                                            } else {
                                                                                phi_15676_ = _e5916;
                                                                            }
                                                                            let _e5919 = phi_15676_;
                                                                            let _e5920 = f64(0.0625f);
                                                                            let _e5922 = f64(0.9f);
                                                                            if (_e5919 > f64(0f)) {
                                                                                phi_15699_ = f64(0.5f);
                                                                            } else {
                                                                                let _e5928 = (f64(0.95f) * (_e5846 / (_e5846 - _e5919)));
                                                                                if (_e5928 > _e5920) {
                                                                                    if (_e5928 < _e5922) {
                                                                                        phi_15697_ = _e5928;
                                                                                    } else {
                                                                                        phi_15697_ = _e5922;
                                                                                    }
                                                                                    let _e5932 = phi_15697_;
                                                                                    phi_15698_ = _e5932;
                                                                                } else {
                                                                                    phi_15698_ = _e5920;
                                                                                }
                                                                                let _e5934 = phi_15698_;
                                                                                phi_15699_ = _e5934;
                                                                            }
                                                                            let _e5936 = phi_15699_;
                                                                            phi_15701_ = u32();
                                                                            phi_15702_ = (_e4887 * _e5936);
                                                                            phi_15703_ = true;
                                                                            phi_15704_ = false;
                                                                            phi_15705_ = false;
                                                                        }
                                                                        let _e5943 = phi_15701_;
                                                                        let _e5945 = phi_15702_;
                                                                        let _e5947 = phi_15703_;
                                                                        let _e5949 = phi_15704_;
                                                                        let _e5951 = phi_15705_;
                                                                        phi_15706_ = _e5943;
                                                                        phi_15707_ = _e4550;
                                                                        phi_15708_ = _e5945;
                                                                        phi_15709_ = _e4552;
                                                                        phi_15710_ = _e4554;
                                                                        phi_15711_ = _e4556;
                                                                        phi_15712_ = _e4558;
                                                                        phi_15713_ = _e5947;
                                                                        phi_15714_ = _e5949;
                                                                        phi_15715_ = _e5951;
                                                                        phi_15716_ = false;
                                                                        phi_15717_ = false;
                                                                        phi_15718_ = false;
                                                                    } else {
                                                                        phi_15706_ = u32();
                                                                        phi_15707_ = _e5756;
                                                                        phi_15708_ = _e5758;
                                                                        phi_15709_ = _e5760;
                                                                        phi_15710_ = _e4548;
                                                                        phi_15711_ = true;
                                                                        phi_15712_ = 0u;
                                                                        phi_15713_ = _e5766;
                                                                        phi_15714_ = false;
                                                                        phi_15715_ = false;
                                                                        phi_15716_ = _e5768;
                                                                        phi_15717_ = _e5770;
                                                                        phi_15718_ = _e5772;
                                                                    }
                                                                    let _e5953 = phi_15706_;
                                                                    let _e5955 = phi_15707_;
                                                                    let _e5957 = phi_15708_;
                                                                    let _e5959 = phi_15709_;
                                                                    let _e5961 = phi_15710_;
                                                                    let _e5963 = phi_15711_;
                                                                    let _e5965 = phi_15712_;
                                                                    let _e5967 = phi_15713_;
                                                                    let _e5969 = phi_15714_;
                                                                    let _e5971 = phi_15715_;
                                                                    let _e5973 = phi_15716_;
                                                                    let _e5975 = phi_15717_;
                                                                    let _e5977 = phi_15718_;
                                                                    if _e5967 {
                                                                        let _e5978 = (_e5961 + _e5957);
                                                                        if (_e5978 > _e5955) {
                                                                            phi_15727_ = _e5978;
                                                                        } else {
                                                                            phi_15727_ = _e5955;
                                                                        }
                                                                        let _e5981 = phi_15727_;
                                                                        if (_e5981 < _e3523.member_1) {
                                                                            phi_15732_ = _e5981;
                                                                        } else {
                                                                            phi_15732_ = _e3523.member_1;
                                                                        }
                                                                        let _e5984 = phi_15732_;
                                                                        if !(_e4556) {
                                                                            phi_15741_ = true;
                                                                        } else {
                                                                            phi_15741_ = ((_e5984 - _e5961) > _e4537);
                                                                        }
                                                                        let _e5988 = phi_15741_;
                                                                        if _e5988 {
                                                                            phi_15745_ = false;
                                                                        } else {
                                                                            phi_15745_ = true;
                                                                        }
                                                                        let _e5990 = phi_15745_;
                                                                        phi_15746_ = _e5984;
                                                                        phi_15747_ = _e5955;
                                                                        phi_15748_ = _e5959;
                                                                        phi_15749_ = _e5961;
                                                                        phi_15750_ = _e5963;
                                                                        phi_15751_ = _e5965;
                                                                        phi_15752_ = _e5988;
                                                                        phi_15753_ = _e5990;
                                                                        phi_15754_ = false;
                                                                        phi_15755_ = false;
                                                                        phi_15756_ = false;
                                                                        phi_15757_ = false;
                                                                    } else {
                                                                        phi_15746_ = _e4548;
                                                                        phi_15747_ = _e4550;
                                                                        phi_15748_ = _e4552;
                                                                        phi_15749_ = _e4554;
                                                                        phi_15750_ = _e4556;
                                                                        phi_15751_ = _e5953;
                                                                        phi_15752_ = _e5969;
                                                                        phi_15753_ = false;
                                                                        phi_15754_ = _e5971;
                                                                        phi_15755_ = _e5973;
                                                                        phi_15756_ = _e5975;
                                                                        phi_15757_ = _e5977;
                                                                    }
                                                                    let _e5992 = phi_15746_;
                                                                    let _e5994 = phi_15747_;
                                                                    let _e5996 = phi_15748_;
                                                                    let _e5998 = phi_15749_;
                                                                    let _e6000 = phi_15750_;
                                                                    let _e6002 = phi_15751_;
                                                                    let _e6004 = phi_15752_;
                                                                    let _e6006 = phi_15753_;
                                                                    let _e6008 = phi_15754_;
                                                                    let _e6010 = phi_15755_;
                                                                    let _e6012 = phi_15756_;
                                                                    let _e6014 = phi_15757_;
                                                                    phi_13536_ = _e5992;
                                                                    phi_13538_ = _e5994;
                                                                    phi_13540_ = _e5996;
                                                                    phi_13542_ = _e5998;
                                                                    phi_13544_ = _e6000;
                                                                    phi_13546_ = _e6002;
                                                                    phi_15758_ = _e5955;
                                                                    phi_15759_ = _e5762;
                                                                    phi_15760_ = _e6004;
                                                                    phi_15761_ = _e6006;
                                                                    phi_15762_ = _e6008;
                                                                    phi_15763_ = _e6010;
                                                                    phi_15764_ = _e6012;
                                                                    phi_15765_ = false;
                                                                    phi_15766_ = _e6014;
                                                                } else {
                                                                    phi_13536_ = f64();
                                                                    phi_13538_ = f64();
                                                                    phi_13540_ = f64();
                                                                    phi_13542_ = f64();
                                                                    phi_13544_ = bool();
                                                                    phi_13546_ = u32();
                                                                    phi_15758_ = f64();
                                                                    phi_15759_ = f64();
                                                                    phi_15760_ = false;
                                                                    phi_15761_ = false;
                                                                    phi_15762_ = false;
                                                                    phi_15763_ = false;
                                                                    phi_15764_ = false;
                                                                    phi_15765_ = true;
                                                                    phi_15766_ = false;
                                                                }
                                                                let _e6016 = phi_13536_;
                                                                let _e6018 = phi_13538_;
                                                                let _e6020 = phi_13540_;
                                                                let _e6022 = phi_13542_;
                                                                let _e6024 = phi_13544_;
                                                                let _e6026 = phi_13546_;
                                                                let _e6028 = phi_15758_;
                                                                let _e6030 = phi_15759_;
                                                                let _e6032 = phi_15760_;
                                                                let _e6034 = phi_15761_;
                                                                let _e6036 = phi_15762_;
                                                                let _e6038 = phi_15763_;
                                                                let _e6040 = phi_15764_;
                                                                let _e6042 = phi_15765_;
                                                                let _e6044 = phi_15766_;
                                                                local_31 = _e6034;
                                                                local_71 = _e6036;
                                                                local_72 = _e6038;
                                                                local_73 = _e6040;
                                                                local_74 = _e6042;
                                                                local_75 = _e6044;
                                                                local_76 = _e6034;
                                                                local_77 = _e6030;
                                                                local_78 = _e6028;
                                                                continue;
                                                                continuing {
                                                                    phi_13532_ = _e4570;
                                                                    phi_13535_ = _e6016;
                                                                    phi_13537_ = _e6018;
                                                                    phi_13539_ = _e6020;
                                                                    phi_13541_ = _e6022;
                                                                    phi_13543_ = _e6024;
                                                                    phi_13545_ = _e6026;
                                                                    break if !(_e6032);
                                                                }
                                                            }
                                                            let _e6047 = local_31;
                                                            if _e6047 {
                                                                phi_15770_ = false;
                                                                phi_15771_ = false;
                                                                phi_15772_ = false;
                                                                phi_15773_ = false;
                                                                phi_15774_ = false;
                                                            } else {
                                                                let _e11946 = local_71;
                                                                phi_15770_ = _e11946;
                                                                let _e11949 = local_72;
                                                                phi_15771_ = _e11949;
                                                                let _e11952 = local_73;
                                                                phi_15772_ = _e11952;
                                                                let _e11955 = local_74;
                                                                phi_15773_ = _e11955;
                                                                let _e11958 = local_75;
                                                                phi_15774_ = _e11958;
                                                            }
                                                            let _e6049 = phi_15770_;
                                                            let _e6051 = phi_15771_;
                                                            let _e6053 = phi_15772_;
                                                            let _e6055 = phi_15773_;
                                                            let _e6057 = phi_15774_;
                                                            if _e6049 {
                                                                let _e6059 = local_32;
                                                                phi_15779_ = type_45(1u, _e6059);
                                                                phi_15780_ = false;
                                                                phi_15781_ = false;
                                                                phi_15782_ = false;
                                                                phi_15783_ = false;
                                                                phi_15784_ = false;
                                                            } else {
                                                                phi_15779_ = type_45();
                                                                phi_15780_ = _e6051;
                                                                phi_15781_ = _e6053;
                                                                let _e11965 = local_76;
                                                                phi_15782_ = _e11965;
                                                                phi_15783_ = _e6055;
                                                                phi_15784_ = _e6057;
                                                            }
                                                            let _e6062 = phi_15779_;
                                                            let _e6064 = phi_15780_;
                                                            let _e6066 = phi_15781_;
                                                            let _e6068 = phi_15782_;
                                                            let _e6070 = phi_15783_;
                                                            let _e6072 = phi_15784_;
                                                            if _e6064 {
                                                                phi_15789_ = type_45(0u, type_45().member_1);
                                                                phi_15790_ = false;
                                                                phi_15791_ = false;
                                                                phi_15792_ = false;
                                                                phi_15793_ = false;
                                                                phi_15794_ = true;
                                                            } else {
                                                                phi_15789_ = _e6062;
                                                                phi_15790_ = _e6066;
                                                                phi_15791_ = _e6068;
                                                                phi_15792_ = _e6070;
                                                                phi_15793_ = _e6072;
                                                                phi_15794_ = _e6049;
                                                            }
                                                            let _e6076 = phi_15789_;
                                                            let _e6078 = phi_15790_;
                                                            let _e6080 = phi_15791_;
                                                            let _e6082 = phi_15792_;
                                                            let _e6084 = phi_15793_;
                                                            let _e6086 = phi_15794_;
                                                            if _e6078 {
                                                                let _e11976 = local_77;
                                                                phi_15798_ = _e11976;
                                                                phi_15799_ = true;
                                                                phi_15800_ = false;
                                                                phi_15801_ = false;
                                                                phi_15802_ = false;
                                                            } else {
                                                                let _e11978 = local_78;
                                                                phi_15798_ = _e11978;
                                                                phi_15799_ = _e6080;
                                                                phi_15800_ = _e6082;
                                                                phi_15801_ = _e6084;
                                                                phi_15802_ = _e6086;
                                                            }
                                                            let _e6088 = phi_15798_;
                                                            let _e6090 = phi_15799_;
                                                            let _e6092 = phi_15800_;
                                                            let _e6094 = phi_15801_;
                                                            let _e6096 = phi_15802_;
                                                            if _e6090 {
                                                                phi_15806_ = _e6088;
                                                                phi_15807_ = true;
                                                                phi_15808_ = false;
                                                                phi_15809_ = false;
                                                            } else {
                                                                let _e11985 = local_79;
                                                                phi_15806_ = _e11985;
                                                                phi_15807_ = _e6092;
                                                                phi_15808_ = _e6094;
                                                                phi_15809_ = _e6096;
                                                            }
                                                            let _e6098 = phi_15806_;
                                                            let _e6100 = phi_15807_;
                                                            let _e6102 = phi_15808_;
                                                            let _e6104 = phi_15809_;
                                                            if _e6100 {
                                                                phi_15814_ = type_45(1u, _e6098);
                                                                phi_15815_ = false;
                                                                phi_15816_ = false;
                                                            } else {
                                                                phi_15814_ = type_45();
                                                                phi_15815_ = _e6102;
                                                                phi_15816_ = _e6104;
                                                            }
                                                            let _e6107 = phi_15814_;
                                                            let _e6109 = phi_15815_;
                                                            let _e6111 = phi_15816_;
                                                            if _e6109 {
                                                                phi_15821_ = type_45(0u, type_45().member_1);
                                                                phi_15822_ = true;
                                                            } else {
                                                                phi_15821_ = _e6076;
                                                                phi_15822_ = _e6111;
                                                            }
                                                            let _e6115 = phi_15821_;
                                                            let _e6117 = phi_15822_;
                                                            if _e6117 {
                                                                phi_15826_ = _e6115;
                                                            } else {
                                                                phi_15826_ = _e6107;
                                                            }
                                                            let _e6119 = phi_15826_;
                                                            let _e6122 = (_e6119.member != 0u);
                                                            if _e6122 {
                                                                phi_15833_ = false;
                                                            } else {
                                                                phi_15833_ = true;
                                                            }
                                                            let _e6124 = phi_15833_;
                                                            phi_15834_ = _e6119.member_1;
                                                            phi_15835_ = _e6124;
                                                            phi_15836_ = _e6122;
                                                            phi_15837_ = false;
                                                        } else {
                                                            phi_15834_ = f64();
                                                            phi_15835_ = false;
                                                            phi_15836_ = false;
                                                            phi_15837_ = true;
                                                        }
                                                        let _e6126 = phi_15834_;
                                                        let _e6128 = phi_15835_;
                                                        let _e6130 = phi_15836_;
                                                        let _e6132 = phi_15837_;
                                                        phi_15838_ = _e4284;
                                                        phi_15839_ = _e4286;
                                                        phi_15840_ = _e6126;
                                                        phi_15841_ = _e6128;
                                                        phi_15842_ = _e6130;
                                                        phi_15843_ = _e6132;
                                                    }
                                                    let _e6134 = phi_15838_;
                                                    let _e6136 = phi_15839_;
                                                    let _e6138 = phi_15840_;
                                                    let _e6140 = phi_15841_;
                                                    let _e6142 = phi_15842_;
                                                    let _e6144 = phi_15843_;
                                                    phi_15844_ = _e6134;
                                                    phi_15845_ = _e6136;
                                                    phi_15846_ = _e6138;
                                                    phi_15847_ = _e4280;
                                                    phi_15848_ = _e6140;
                                                    phi_15849_ = _e6142;
                                                    phi_15850_ = _e6144;
                                                }
                                                let _e6146 = phi_15844_;
                                                let _e6148 = phi_15845_;
                                                let _e6150 = phi_15846_;
                                                let _e6152 = phi_15847_;
                                                let _e6154 = phi_15848_;
                                                let _e6156 = phi_15849_;
                                                let _e6158 = phi_15850_;
                                                phi_15851_ = _e6146;
                                                phi_15852_ = _e6148;
                                                phi_15853_ = _e6150;
                                                phi_15854_ = _e6152;
                                                phi_15855_ = _e6154;
                                                phi_15856_ = _e3528;
                                                phi_15857_ = _e6156;
                                                phi_15858_ = _e6158;
                                            }
                                            let _e6160 = phi_15851_;
                                            let _e6162 = phi_15852_;
                                            let _e6164 = phi_15853_;
                                            let _e6166 = phi_15854_;
                                            let _e6168 = phi_15855_;
                                            let _e6170 = phi_15856_;
                                            let _e6172 = phi_15857_;
                                            let _e6174 = phi_15858_;
                                            if _e6166 {
                                                phi_15862_ = false;
                                                phi_15863_ = false;
                                                phi_15864_ = false;
                                                phi_15865_ = false;
                                            } else {
                                                phi_15862_ = _e6168;
                                                phi_15863_ = _e6170;
                                                phi_15864_ = _e6172;
                                                phi_15865_ = _e6174;
                                            }
                                            let _e6176 = phi_15862_;
                                            let _e6178 = phi_15863_;
                                            let _e6180 = phi_15864_;
                                            let _e6182 = phi_15865_;
                                            phi_15866_ = _e3523;
                                            phi_15867_ = _e6160;
                                            phi_15868_ = _e6162;
                                            phi_15869_ = _e6164;
                                            phi_15870_ = _e3523;
                                            phi_15871_ = _e6166;
                                            phi_15872_ = _e6176;
                                            phi_15873_ = _e6178;
                                            phi_15874_ = _e6180;
                                            phi_15875_ = _e6182;
                                        }
                                        let _e6184 = phi_15866_;
                                        let _e6186 = phi_15867_;
                                        let _e6188 = phi_15868_;
                                        let _e6190 = phi_15869_;
                                        let _e6192 = phi_15870_;
                                        let _e6194 = phi_15871_;
                                        let _e6196 = phi_15872_;
                                        let _e6198 = phi_15873_;
                                        let _e6200 = phi_15874_;
                                        let _e6202 = phi_15875_;
                                        phi_15876_ = _e6184;
                                        phi_15877_ = _e6186;
                                        phi_15878_ = _e6188;
                                        phi_15879_ = _e6190;
                                        phi_15880_ = _e6192;
                                        phi_15881_ = _e6194;
                                        phi_15882_ = _e6196;
                                        phi_15883_ = _e3175;
                                        phi_15884_ = _e6198;
                                        phi_15885_ = _e6200;
                                        phi_15886_ = _e6202;
                                    } else {
                                        phi_15876_ = type_48();
                                        phi_15877_ = bool();
                                        phi_15878_ = f64();
                                        phi_15879_ = f64();
                                        phi_15880_ = type_48();
                                        phi_15881_ = true;
                                        phi_15882_ = false;
                                        phi_15883_ = false;
                                        phi_15884_ = false;
                                        phi_15885_ = false;
                                        phi_15886_ = false;
                                    }
                                    let _e6204 = phi_15876_;
                                    let _e6206 = phi_15877_;
                                    let _e6208 = phi_15878_;
                                    let _e6210 = phi_15879_;
                                    let _e6212 = phi_15880_;
                                    let _e6214 = phi_15881_;
                                    let _e6216 = phi_15882_;
                                    let _e6218 = phi_15883_;
                                    let _e6220 = phi_15884_;
                                    let _e6222 = phi_15885_;
                                    let _e6224 = phi_15886_;
                                    if _e6214 {
                                        phi_15890_ = true;
                                        phi_15891_ = false;
                                        phi_15892_ = false;
                                        phi_15893_ = false;
                                        phi_15894_ = false;
                                    } else {
                                        phi_15890_ = _e6216;
                                        phi_15891_ = _e6218;
                                        phi_15892_ = _e6220;
                                        phi_15893_ = _e6222;
                                        phi_15894_ = _e6224;
                                    }
                                    let _e6226 = phi_15890_;
                                    let _e6228 = phi_15891_;
                                    let _e6230 = phi_15892_;
                                    let _e6232 = phi_15893_;
                                    let _e6234 = phi_15894_;
                                    phi_15895_ = _e6204;
                                    phi_15896_ = _e6206;
                                    phi_15897_ = _e6208;
                                    phi_15898_ = _e6210;
                                    phi_15899_ = _e6212;
                                    phi_15900_ = _e6226;
                                    phi_15901_ = false;
                                    phi_15902_ = _e6228;
                                    phi_15903_ = _e6230;
                                    phi_15904_ = _e6232;
                                    phi_15905_ = _e6234;
                                } else {
                                    phi_15895_ = type_48();
                                    phi_15896_ = bool();
                                    phi_15897_ = f64();
                                    phi_15898_ = f64();
                                    phi_15899_ = type_48();
                                    phi_15900_ = false;
                                    phi_15901_ = true;
                                    phi_15902_ = false;
                                    phi_15903_ = false;
                                    phi_15904_ = false;
                                    phi_15905_ = false;
                                }
                                let _e6236 = phi_15895_;
                                let _e6238 = phi_15896_;
                                let _e6240 = phi_15897_;
                                let _e6242 = phi_15898_;
                                let _e6244 = phi_15899_;
                                let _e6246 = phi_15900_;
                                let _e6248 = phi_15901_;
                                let _e6250 = phi_15902_;
                                let _e6252 = phi_15903_;
                                let _e6254 = phi_15904_;
                                let _e6256 = phi_15905_;
                                local_33 = _e6248;
                                local_80 = _e6250;
                                local_81 = _e6252;
                                local_82 = _e6254;
                                local_83 = _e6256;
                                local_34 = _e6238;
                                local_35 = _e6236;
                                local_36 = _e6242;
                                local_37 = _e6240;
                                local_38 = _e6242;
                                local_39 = _e6242;
                                local_40 = _e6244;
                                continue;
                                continuing {
                                    phi_11531_ = _e3156;
                                    break if !(_e6246);
                                }
                            }
                            let _e6259 = local_33;
                            if _e6259 {
                                phi_15910_ = type_45(0u, type_45().member_1);
                                phi_15911_ = false;
                                phi_15912_ = false;
                                phi_15913_ = false;
                                phi_15914_ = false;
                            } else {
                                phi_15910_ = type_45();
                                let _e12066 = local_80;
                                phi_15911_ = _e12066;
                                let _e12069 = local_81;
                                phi_15912_ = _e12069;
                                let _e12072 = local_82;
                                phi_15913_ = _e12072;
                                let _e12075 = local_83;
                                phi_15914_ = _e12075;
                            }
                            let _e6263 = phi_15910_;
                            let _e6265 = phi_15911_;
                            let _e6267 = phi_15912_;
                            let _e6269 = phi_15913_;
                            let _e6271 = phi_15914_;
                            if _e6265 {
                                phi_15919_ = type_45(0u, type_45().member_1);
                                phi_15920_ = false;
                                phi_15921_ = false;
                                phi_15922_ = false;
                            } else {
                                phi_15919_ = type_45();
                                phi_15920_ = _e6267;
                                phi_15921_ = _e6269;
                                phi_15922_ = _e6271;
                            }
                            let _e6275 = phi_15919_;
                            let _e6277 = phi_15920_;
                            let _e6279 = phi_15921_;
                            let _e6281 = phi_15922_;
                            if _e6277 {
                                phi_15927_ = type_45(0u, type_45().member_1);
                                phi_15928_ = false;
                                phi_15929_ = false;
                                phi_15930_ = false;
                            } else {
                                phi_15927_ = type_45();
                                phi_15928_ = _e6279;
                                phi_15929_ = _e6281;
                                phi_15930_ = _e6265;
                            }
                            let _e6285 = phi_15927_;
                            let _e6287 = phi_15928_;
                            let _e6289 = phi_15929_;
                            let _e6291 = phi_15930_;
                            if _e6287 {
                                let _e6293 = local_34;
                                if _e6293 {
                                    let _e6295 = local_35;
                                    let _e6298 = local_36;
                                    let _e6301 = local_37;
                                    if ((_e6295.member_1 - _e6298) <= _e6301) {
                                        let _e6304 = local_38;
                                        phi_15944_ = type_45(1u, _e6304);
                                        phi_15945_ = false;
                                    } else {
                                        phi_15944_ = type_45();
                                        phi_15945_ = true;
                                    }
                                    let _e6307 = phi_15944_;
                                    let _e6309 = phi_15945_;
                                    phi_15946_ = _e6307;
                                    phi_15947_ = _e6309;
                                } else {
                                    phi_15946_ = type_45();
                                    phi_15947_ = true;
                                }
                                let _e6311 = phi_15946_;
                                let _e6313 = phi_15947_;
                                if _e6313 {
                                    let _e6315 = local_39;
                                    phi_15952_ = type_45(2u, _e6315);
                                } else {
                                    phi_15952_ = _e6311;
                                }
                                let _e6318 = phi_15952_;
                                phi_15953_ = _e6318;
                                phi_15954_ = false;
                                phi_15955_ = false;
                                phi_15956_ = false;
                            } else {
                                phi_15953_ = type_45();
                                phi_15954_ = _e6289;
                                phi_15955_ = _e6277;
                                phi_15956_ = _e6291;
                            }
                            let _e6320 = phi_15953_;
                            let _e6322 = phi_15954_;
                            let _e6324 = phi_15955_;
                            let _e6326 = phi_15956_;
                            if _e6322 {
                                let _e6328 = local_40;
                                phi_15962_ = type_45(1u, _e6328.member);
                                phi_15963_ = true;
                                phi_15964_ = false;
                                phi_15965_ = false;
                            } else {
                                phi_15962_ = _e6320;
                                phi_15963_ = _e6287;
                                phi_15964_ = _e6324;
                                phi_15965_ = _e6326;
                            }
                            let _e6332 = phi_15962_;
                            let _e6334 = phi_15963_;
                            let _e6336 = phi_15964_;
                            let _e6338 = phi_15965_;
                            if _e6334 {
                                phi_15969_ = _e6332;
                                phi_15970_ = true;
                                phi_15971_ = false;
                            } else {
                                phi_15969_ = _e6285;
                                phi_15970_ = _e6336;
                                phi_15971_ = _e6338;
                            }
                            let _e6340 = phi_15969_;
                            let _e6342 = phi_15970_;
                            let _e6344 = phi_15971_;
                            if _e6342 {
                                phi_15975_ = _e6340;
                                phi_15976_ = true;
                            } else {
                                phi_15975_ = _e6275;
                                phi_15976_ = _e6344;
                            }
                            let _e6346 = phi_15975_;
                            let _e6348 = phi_15976_;
                            phi_15980_ = _e6346;
                            phi_15981_ = _e6263;
                            phi_15982_ = _e6348;
                        } else {
                            phi_15980_ = _e2982;
                            phi_15981_ = type_45();
                            phi_15982_ = true;
                        }
                        let _e6350 = phi_15980_;
                        let _e6352 = phi_15981_;
                        let _e6354 = phi_15982_;
                        phi_15986_ = _e6350;
                        phi_15987_ = _e6352;
                        phi_15988_ = _e6354;
                    }
                    let _e6358 = phi_15986_;
                    let _e6360 = phi_15987_;
                    let _e6362 = phi_15988_;
                    if _e6362 {
                        phi_15992_ = _e6358;
                    } else {
                        phi_15992_ = _e6360;
                    }
                    let _e6364 = phi_15992_;
                    if (_e6364.member == 1u) {
                        if (_e6364.member_1 > _e565) {
                            phi_16003_ = false;
                        } else {
                            phi_16003_ = true;
                        }
                        let _e6370 = phi_16003_;
                        phi_16004_ = _e6370;
                    } else {
                        phi_16004_ = true;
                    }
                    let _e6372 = phi_16004_;
                    if _e6372 {
                        phi_16008_ = false;
                    } else {
                        phi_16008_ = true;
                    }
                    let _e6374 = phi_16008_;
                    if _e6374 {
                        phi_16012_ = 1u;
                    } else {
                        phi_16012_ = 0u;
                    }
                    let _e6376 = phi_16012_;
                    phi_16016_ = type_46(_e6364, _e6376);
                }
                let _e11036 = phi_16016_;
                switch bitcast<i32>(_e11036.member.member) {
                    case 0: {
                        phi_16034_ = type_49(0u, _e11036.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e11047 = function_1(_e11036.member.member_1);
                        phi_16034_ = type_49(0u, _e11036.member_1, _e11047, true);
                        break;
                    }
                    case 2: {
                        let _e11043 = function_1(_e11036.member.member_1);
                        phi_16034_ = type_49(1u, _e11036.member_1, _e11043, true);
                        break;
                    }
                    default: {
                        phi_16034_ = type_49();
                        break;
                    }
                }
                let _e11051 = phi_16034_;
                if (_e11051.member == 0u) {
                    phi_16052_ = false;
                } else {
                    let _e11060 = params.member.member.member_7[0u];
                    let _e11063 = params.member.member.member_7[1u];
                    phi_16052_ = ((_e11060 | _e11063) == 0u);
                }
                let _e11067 = phi_16052_;
                if _e11051.member_3 {
                    if _e211 {
                        phi_16059_ = true;
                    } else {
                        phi_16059_ = _e11067;
                    }
                    let _e11069 = phi_16059_;
                    phi_16060_ = _e11069;
                } else {
                    phi_16060_ = false;
                }
                let _e11071 = phi_16060_;
                if _e11051.member_3 {
                    if _e11067 {
                    } else {
                        let _e11075 = (_e11051.member_2[1] >> bitcast<u32>(20i));
                        if (_e11075 <= 896u) {
                            phi_16083_ = 0u;
                        } else {
                            phi_16083_ = ((((_e11075 - 896u) << bitcast<u32>(23i)) | ((_e11051.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e11051.member_2[0] >> bitcast<u32>(29i)));
                        }
                        let _e11090 = phi_16083_;
                        let _e11092 = atomicMin((&earliest.member[0u]), _e11090);
                    }
                }
                phi_16087_ = type_20(_e206, _e11051.member, _e221, _e224, _e11051.member_2, _e11051.member_1);
                phi_16088_ = _e11071;
            } else {
                phi_16087_ = type_20(_e206, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_16088_ = false;
            }
            let _e11094 = phi_16087_;
            let _e11096 = phi_16088_;
            if (_e124 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e11096 {
                let _e11100 = atomicAdd((&counters[0u]), 1u);
                phi_16099_ = _e11100;
            } else {
                phi_16099_ = 0u;
            }
            let _e11102 = phi_16099_;
            workgroupBarrier();
            if (_e124 == 0u) {
                let _e11105 = atomicLoad((&counters[0u]));
                if (_e11105 > 0u) {
                    let _e11108 = atomicAdd((&contacts.member[0u]), _e11105);
                    atomicStore((&counters[1u]), _e11108);
                }
            }
            workgroupBarrier();
            let _e11111 = atomicLoad((&counters[1u]));
            let _e11112 = (_e11111 + _e11102);
            if _e11096 {
                if _e211 {
                    let _e11115 = params.member.member_1.member_3;
                    if (_e11112 < _e11115) {
                        let _e11117 = (7u * _e11112);
                        atomicStore((&contacts.member[(4u + _e11117)]), _e11094.member);
                        atomicStore((&contacts.member[(_e11117 + 5u)]), _e11094.member_1);
                        atomicStore((&contacts.member[(_e11117 + 6u)]), _e11094.member_2);
                        atomicStore((&contacts.member[(_e11117 + 7u)]), _e11094.member_3);
                        atomicStore((&contacts.member[(_e11117 + 8u)]), _e11094.member_4[0]);
                        atomicStore((&contacts.member[(_e11117 + 9u)]), _e11094.member_4[1]);
                        atomicStore((&contacts.member[(_e11117 + 10u)]), _e11094.member_5);
                    }
                    phi_16159_ = false;
                } else {
                    phi_16159_ = true;
                }
                let _e11142 = phi_16159_;
                phi_16160_ = _e11142;
            } else {
                phi_16160_ = true;
            }
            let _e11144 = phi_16160_;
            if _e11144 {
                if _e11096 {
                    let _e11149 = params.member.member_2.member_1;
                    if (_e11112 < _e11149) {
                        let _e11151 = (2u * _e11112);
                        atomicStore((&contacts.member[(4u + _e11151)]), _e11094.member_2);
                        atomicStore((&contacts.member[(_e11151 + 5u)]), _e11094.member_3);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_463_ = _e193;
            break if !(_e199);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
