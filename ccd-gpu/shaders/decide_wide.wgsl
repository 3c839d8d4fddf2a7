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

struct type_21 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_24 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
    member_5: u32,
}

struct type_26 {
    member: u32,
    member_1: array<u32, 4>,
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

struct type_41 {
    member: array<array<array<f64, 3>, 4>, 2>,
    member_1: f64,
    member_2: f64,
}

struct type_42 {
    member: type_33,
    member_1: f64,
}

struct type_43 {
    member: u32,
    member_1: f64,
}

struct type_44 {
    member: type_43,
    member_1: u32,
}

struct type_45 {
    member: f64,
    member_1: f64,
    member_2: u32,
}

struct type_46 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_47 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_51 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> paths: type_23;
@group(0) @binding(4) 
var<storage> input: type_13;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> positions: type_30;
@group(0) @binding(3) 
var<storage> elements: type_13;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_51;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_51;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_251_: f64;
    var phi_229_: array<u32, 2>;
    var phi_252_: f64;
    var phi_294_: f64;
    var phi_272_: array<u32, 2>;
    var phi_295_: f64;
    var phi_337_: f64;
    var phi_315_: array<u32, 2>;
    var phi_338_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e21 = bitcast<u32>(param[0]);
        let _e22 = (_e21 & 2147483647u);
        if (_e22 < 8388608u) {
            phi_229_ = array<u32, 2>(0u, 0u);
        } else {
            phi_229_ = array<u32, 2>((_e21 << bitcast<u32>(29i)), ((_e21 ^ _e22) | ((_e22 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e33 = phi_229_;
        phi_252_ = bitcast<f64>(((u64(_e33[1]) * 4294967296lu) + u64(_e33[0])));
    } else {
        if (_e10 == _e11) {
            phi_251_ = (f64(_e11) * 1.401298464324817e-45lf);
        } else {
            phi_251_ = -((f64(_e11) * 1.401298464324817e-45lf));
        }
        let _e20 = phi_251_;
        phi_252_ = _e20;
    }
    let _e42 = phi_252_;
    let _e44 = bitcast<u32>(param[1]);
    let _e45 = (_e44 & 2147483647u);
    if (_e45 >= 8388608u) {
        let _e55 = bitcast<u32>(param[1]);
        let _e56 = (_e55 & 2147483647u);
        if (_e56 < 8388608u) {
            phi_272_ = array<u32, 2>(0u, 0u);
        } else {
            phi_272_ = array<u32, 2>((_e55 << bitcast<u32>(29i)), ((_e55 ^ _e56) | ((_e56 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e67 = phi_272_;
        phi_295_ = bitcast<f64>(((u64(_e67[1]) * 4294967296lu) + u64(_e67[0])));
    } else {
        if (_e44 == _e45) {
            phi_294_ = (f64(_e45) * 1.401298464324817e-45lf);
        } else {
            phi_294_ = -((f64(_e45) * 1.401298464324817e-45lf));
        }
        let _e54 = phi_294_;
        phi_295_ = _e54;
    }
    let _e76 = phi_295_;
    let _e78 = bitcast<u32>(param[2]);
    let _e79 = (_e78 & 2147483647u);
    if (_e79 >= 8388608u) {
        let _e89 = bitcast<u32>(param[2]);
        let _e90 = (_e89 & 2147483647u);
        if (_e90 < 8388608u) {
            phi_315_ = array<u32, 2>(0u, 0u);
        } else {
            phi_315_ = array<u32, 2>((_e89 << bitcast<u32>(29i)), ((_e89 ^ _e90) | ((_e90 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e101 = phi_315_;
        phi_338_ = bitcast<f64>(((u64(_e101[1]) * 4294967296lu) + u64(_e101[0])));
    } else {
        if (_e78 == _e79) {
            phi_337_ = (f64(_e79) * 1.401298464324817e-45lf);
        } else {
            phi_337_ = -((f64(_e79) * 1.401298464324817e-45lf));
        }
        let _e88 = phi_337_;
        phi_338_ = _e88;
    }
    let _e110 = phi_338_;
    return array<f64, 3>(_e42, _e76, _e110);
}

fn function_1(param_1: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_1);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_2(param_2: array<f64, 3>, param_3: array<f64, 3>) -> array<f64, 3> {
    var phi_16575_: array<f64, 3>;

    if ((((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])) < (((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2]))) {
        phi_16575_ = param_3;
    } else {
        phi_16575_ = param_2;
    }
    let _e26 = phi_16575_;
    return _e26;
}

fn function_3(param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: array<f64, 3>, param_7: u32) -> array<f64, 3> {
    var phi_16427_: f64;
    var phi_16429_: f64;
    var phi_16471_: f64;
    var phi_16473_: f64;
    var phi_16521_: f64;
    var phi_16523_: f64;
    var phi_16232_: f64;
    var phi_16234_: f64;
    var phi_16282_: f64;
    var phi_16284_: f64;
    var phi_16329_: f64;
    var phi_16331_: f64;
    var phi_16382_: f64;
    var phi_16384_: f64;
    var phi_16538_: array<array<f64, 3>, 4>;

    let _e9 = (param_4[0] - param_5[0]);
    let _e12 = (param_4[1] - param_5[1]);
    let _e15 = (param_4[2] - param_5[2]);
    if (param_7 != 0u) {
        let _e169 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e169 > f64(0f)) {
            if (_e169 < f64(1f)) {
                phi_16232_ = _e169;
            } else {
                phi_16232_ = f64(1f);
            }
            let _e177 = phi_16232_;
            phi_16234_ = _e177;
        } else {
            phi_16234_ = f64(0f);
        }
        let _e179 = phi_16234_;
        let _e215 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e215 > f64(0f)) {
            if (_e215 < f64(1f)) {
                phi_16282_ = _e215;
            } else {
                phi_16282_ = f64(1f);
            }
            let _e223 = phi_16282_;
            phi_16284_ = _e223;
        } else {
            phi_16284_ = f64(0f);
        }
        let _e225 = phi_16284_;
        let _e258 = ((((_e9 * param_6[0]) + (_e12 * param_6[1])) + (_e15 * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e258 > f64(0f)) {
            if (_e258 < f64(1f)) {
                phi_16329_ = _e258;
            } else {
                phi_16329_ = f64(1f);
            }
            let _e266 = phi_16329_;
            phi_16331_ = _e266;
        } else {
            phi_16331_ = f64(0f);
        }
        let _e268 = phi_16331_;
        let _e281 = (param_4[0] - param_6[0]);
        let _e284 = (param_4[1] - param_6[1]);
        let _e287 = (param_4[2] - param_6[2]);
        let _e307 = ((((_e281 * param_5[0]) + (_e284 * param_5[1])) + (_e287 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e307 > f64(0f)) {
            if (_e307 < f64(1f)) {
                phi_16382_ = _e307;
            } else {
                phi_16382_ = f64(1f);
            }
            let _e315 = phi_16382_;
            phi_16384_ = _e315;
        } else {
            phi_16384_ = f64(0f);
        }
        let _e317 = phi_16384_;
        phi_16538_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e179)), (param_4[1] - (param_5[1] * _e179)), (param_4[2] - (param_5[2] * _e179))), array<f64, 3>((param_4[0] - (param_6[0] * _e225)), (param_4[1] - (param_6[1] * _e225)), (param_4[2] - (param_6[2] * _e225))), array<f64, 3>((_e9 - (param_6[0] * _e268)), (_e12 - (param_6[1] * _e268)), (_e15 - (param_6[2] * _e268))), array<f64, 3>((_e281 - (param_5[0] * _e317)), (_e284 - (param_5[1] * _e317)), (_e287 - (param_5[2] * _e317))));
    } else {
        let _e19 = (param_6[0] - param_5[0]);
        let _e22 = (param_6[1] - param_5[1]);
        let _e25 = (param_6[2] - param_5[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > f64(0f)) {
            if (_e36 < f64(1f)) {
                phi_16427_ = _e36;
            } else {
                phi_16427_ = f64(1f);
            }
            let _e44 = phi_16427_;
            phi_16429_ = _e44;
        } else {
            phi_16429_ = f64(0f);
        }
        let _e46 = phi_16429_;
        let _e53 = array<f64, 3>((_e9 - (_e19 * _e46)), (_e12 - (_e22 * _e46)), (_e15 - (_e25 * _e46)));
        let _e76 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e76 > f64(0f)) {
            if (_e76 < f64(1f)) {
                phi_16471_ = _e76;
            } else {
                phi_16471_ = f64(1f);
            }
            let _e84 = phi_16471_;
            phi_16473_ = _e84;
        } else {
            phi_16473_ = f64(0f);
        }
        let _e86 = phi_16473_;
        let _e122 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e122 > f64(0f)) {
            if (_e122 < f64(1f)) {
                phi_16521_ = _e122;
            } else {
                phi_16521_ = f64(1f);
            }
            let _e130 = phi_16521_;
            phi_16523_ = _e130;
        } else {
            phi_16523_ = f64(0f);
        }
        let _e132 = phi_16523_;
        phi_16538_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e86)), (param_4[1] - (param_5[1] * _e86)), (param_4[2] - (param_5[2] * _e86))), array<f64, 3>((param_4[0] - (param_6[0] * _e132)), (param_4[1] - (param_6[1] * _e132)), (param_4[2] - (param_6[2] * _e132))), _e53, _e53);
    }
    let _e330 = phi_16538_;
    let _e333 = function_2(_e330[0], _e330[1]);
    let _e335 = function_2(_e333, _e330[2]);
    let _e337 = function_2(_e335, _e330[3]);
    return _e337;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_16129_: bool;
    var phi_16130_: bool;
    var phi_16131_: bool;
    var phi_16132_: bool;
    var phi_16136_: bool;
    var phi_16109_: bool;
    var phi_16110_: bool;
    var phi_16111_: bool;
    var phi_16112_: bool;
    var phi_16113_: bool;
    var phi_16114_: bool;
    var phi_16118_: bool;
    var phi_16137_: bool;
    var phi_16171_: array<f64, 3>;
    var phi_16172_: bool;
    var phi_16173_: array<f64, 3>;
    var phi_16174_: bool;
    var phi_16179_: array<f64, 3>;

    let _e23 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e34 = (((param_9[0] * param_10[0]) + (param_9[1] * param_10[1])) + (param_9[2] * param_10[2]));
    let _e45 = (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2]));
    let _e56 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e67 = (((param_8[0] * param_10[0]) + (param_8[1] * param_10[1])) + (param_8[2] * param_10[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e71 = f64(0f);
    let _e72 = f64(1f);
    let _e76 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e80 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_11 != 0u) {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                if (_e76 <= _e72) {
                    phi_16109_ = (_e80 <= _e72);
                    phi_16110_ = false;
                } else {
                    phi_16109_ = bool();
                    phi_16110_ = true;
                }
                let _e101 = phi_16109_;
                let _e103 = phi_16110_;
                phi_16111_ = _e101;
                phi_16112_ = _e103;
            } else {
                phi_16111_ = bool();
                phi_16112_ = true;
            }
            let _e105 = phi_16111_;
            let _e107 = phi_16112_;
            phi_16113_ = _e105;
            phi_16114_ = _e107;
        } else {
            phi_16113_ = bool();
            phi_16114_ = true;
        }
        let _e109 = phi_16113_;
        let _e111 = phi_16114_;
        if _e111 {
            phi_16118_ = false;
        } else {
            phi_16118_ = _e109;
        }
        let _e113 = phi_16118_;
        phi_16137_ = _e113;
    } else {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                phi_16129_ = ((_e76 + _e80) <= _e72);
                phi_16130_ = false;
            } else {
                phi_16129_ = bool();
                phi_16130_ = true;
            }
            let _e87 = phi_16129_;
            let _e89 = phi_16130_;
            phi_16131_ = _e87;
            phi_16132_ = _e89;
        } else {
            phi_16131_ = bool();
            phi_16132_ = true;
        }
        let _e91 = phi_16131_;
        let _e93 = phi_16132_;
        if _e93 {
            phi_16136_ = false;
        } else {
            phi_16136_ = _e91;
        }
        let _e95 = phi_16136_;
        phi_16137_ = _e95;
    }
    let _e115 = phi_16137_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e115 {
            phi_16171_ = array<f64, 3>((param_8[0] - ((param_9[0] * _e76) + (param_10[0] * _e80))), (param_8[1] - ((param_9[1] * _e76) + (param_10[1] * _e80))), (param_8[2] - ((param_9[2] * _e76) + (param_10[2] * _e80))));
            phi_16172_ = false;
        } else {
            phi_16171_ = array<f64, 3>();
            phi_16172_ = true;
        }
        let _e144 = phi_16171_;
        let _e146 = phi_16172_;
        phi_16173_ = _e144;
        phi_16174_ = _e146;
    } else {
        phi_16173_ = array<f64, 3>();
        phi_16174_ = true;
    }
    let _e148 = phi_16173_;
    let _e150 = phi_16174_;
    if _e150 {
        let _e151 = function_3(param_8, param_9, param_10, param_11);
        phi_16179_ = _e151;
    } else {
        phi_16179_ = _e148;
    }
    let _e153 = phi_16179_;
    return _e153;
}

fn function_5(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
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
    var local_12: array<f64, 4>;
    var local_13: array<f32, 3>;
    var local_14: type_41;
    var local_15: type_35;
    var local_16: type_35;
    var local_17: type_35;
    var local_18: type_33;
    var phi_399_: u32;
    var phi_409_: u32;
    var phi_416_: u32;
    var phi_432_: u32;
    var phi_453_: u32;
    var phi_454_: u32;
    var phi_457_: type_9;
    var phi_458_: type_9;
    var phi_481_: type_9;
    var phi_619_: type_26;
    var phi_823_: type_31;
    var phi_984_: type_33;
    var phi_1032_: f64;
    var phi_1039_: f64;
    var phi_1044_: f64;
    var phi_1051_: f64;
    var phi_1056_: f64;
    var phi_1064_: f64;
    var phi_1071_: f64;
    var phi_1076_: f64;
    var phi_1083_: f64;
    var phi_1088_: f64;
    var phi_1093_: f64;
    var phi_1103_: f64;
    var phi_1110_: f64;
    var phi_1115_: f64;
    var phi_1122_: f64;
    var phi_1127_: f64;
    var phi_1135_: f64;
    var phi_1142_: f64;
    var phi_1147_: f64;
    var phi_1154_: f64;
    var phi_1159_: f64;
    var phi_1164_: f64;
    var phi_1174_: f64;
    var phi_1181_: f64;
    var phi_1186_: f64;
    var phi_1193_: f64;
    var phi_1198_: f64;
    var phi_1206_: f64;
    var phi_1213_: f64;
    var phi_1218_: f64;
    var phi_1225_: f64;
    var phi_1230_: f64;
    var phi_1235_: f64;
    var phi_1242_: f64;
    var phi_1247_: f64;
    var phi_1256_: bool;
    var phi_1280_: u64;
    var phi_1292_: f64;
    var phi_1293_: f64;
    var phi_1352_: type_42;
    var phi_1353_: bool;
    var phi_1354_: type_42;
    var phi_1355_: bool;
    var phi_1356_: type_42;
    var phi_1357_: bool;
    var phi_1362_: type_42;
    var phi_8428_: f64;
    var phi_8435_: f64;
    var phi_8440_: f64;
    var phi_8447_: f64;
    var phi_8452_: f64;
    var phi_8465_: f64;
    var phi_8472_: f64;
    var phi_8477_: f64;
    var phi_8484_: f64;
    var phi_8489_: f64;
    var phi_8494_: f64;
    var phi_8511_: f64;
    var phi_8518_: f64;
    var phi_8523_: f64;
    var phi_8530_: f64;
    var phi_8535_: f64;
    var phi_8549_: f64;
    var phi_8556_: f64;
    var phi_8561_: f64;
    var phi_8568_: f64;
    var phi_8573_: f64;
    var phi_8578_: f64;
    var phi_8595_: f64;
    var phi_8602_: f64;
    var phi_8607_: f64;
    var phi_8614_: f64;
    var phi_8619_: f64;
    var phi_8633_: f64;
    var phi_8640_: f64;
    var phi_8645_: f64;
    var phi_8652_: f64;
    var phi_8657_: f64;
    var phi_8662_: f64;
    var phi_8699_: f64;
    var phi_8705_: f64;
    var phi_8712_: f64;
    var phi_8719_: f64;
    var phi_8725_: f64;
    var phi_8732_: f64;
    var phi_8738_: f64;
    var phi_8744_: f64;
    var phi_8750_: f64;
    var phi_8757_: f64;
    var phi_8764_: f64;
    var phi_8792_: f64;
    var phi_8797_: f64;
    var phi_8802_: f64;
    var phi_8807_: f64;
    var phi_8812_: f64;
    var phi_8817_: f64;
    var phi_8828_: f64;
    var phi_8842_: f64;
    var phi_8848_: f64;
    var phi_8853_: f64;
    var phi_8859_: f64;
    var phi_8865_: f64;
    var phi_8870_: f64;
    var phi_8875_: f64;
    var phi_8885_: bool;
    var phi_8892_: f64;
    var phi_8900_: f64;
    var phi_8908_: f64;
    var phi_8927_: f64;
    var phi_8989_: array<f64, 3>;
    var phi_9054_: array<f64, 3>;
    var phi_9076_: f64;
    var phi_9083_: f64;
    var phi_9088_: f64;
    var phi_9095_: f64;
    var phi_9100_: f64;
    var phi_9113_: f64;
    var phi_9120_: f64;
    var phi_9125_: f64;
    var phi_9132_: f64;
    var phi_9137_: f64;
    var phi_9142_: f64;
    var phi_9159_: f64;
    var phi_9166_: f64;
    var phi_9171_: f64;
    var phi_9178_: f64;
    var phi_9183_: f64;
    var phi_9197_: f64;
    var phi_9204_: f64;
    var phi_9209_: f64;
    var phi_9216_: f64;
    var phi_9221_: f64;
    var phi_9226_: f64;
    var phi_9243_: f64;
    var phi_9250_: f64;
    var phi_9255_: f64;
    var phi_9262_: f64;
    var phi_9267_: f64;
    var phi_9281_: f64;
    var phi_9288_: f64;
    var phi_9293_: f64;
    var phi_9300_: f64;
    var phi_9305_: f64;
    var phi_9310_: f64;
    var phi_9431_: f64;
    var phi_9438_: f64;
    var phi_9446_: f64;
    var phi_9492_: type_18;
    var phi_9495_: f64;
    var phi_9516_: bool;
    var phi_9522_: type_19;
    var phi_9493_: type_18;
    var phi_9536_: type_19;
    var phi_9496_: f64;
    var local_19: f64;
    var phi_9485_: f64;
    var phi_9549_: f64;
    var phi_9618_: f64;
    var phi_9624_: f64;
    var phi_9633_: f64;
    var phi_9639_: f64;
    var phi_9648_: f64;
    var phi_9654_: f64;
    var phi_9663_: f64;
    var phi_9669_: f64;
    var phi_9675_: type_35;
    var phi_9676_: bool;
    var phi_9677_: type_35;
    var phi_9678_: bool;
    var phi_9688_: type_35;
    var phi_9858_: bool;
    var phi_9859_: bool;
    var phi_9860_: bool;
    var phi_9861_: bool;
    var phi_9862_: bool;
    var phi_9863_: bool;
    var phi_9867_: bool;
    var phi_9895_: f64;
    var phi_9901_: f64;
    var phi_9908_: f64;
    var phi_9951_: type_18;
    var phi_9954_: f64;
    var phi_9975_: bool;
    var phi_9981_: type_19;
    var phi_9952_: type_18;
    var phi_9995_: type_19;
    var phi_9955_: f64;
    var local_20: f64;
    var phi_9944_: f64;
    var phi_10008_: f64;
    var phi_10077_: f64;
    var phi_10083_: f64;
    var phi_10092_: f64;
    var phi_10098_: f64;
    var phi_10107_: f64;
    var phi_10113_: f64;
    var phi_10122_: f64;
    var phi_10128_: f64;
    var phi_10134_: type_35;
    var phi_10135_: bool;
    var phi_10136_: type_35;
    var phi_10137_: bool;
    var phi_10147_: type_35;
    var phi_10317_: bool;
    var phi_10318_: bool;
    var phi_10319_: bool;
    var phi_10320_: bool;
    var phi_10321_: bool;
    var phi_10322_: bool;
    var phi_10326_: bool;
    var phi_10354_: f64;
    var phi_10360_: f64;
    var phi_10367_: f64;
    var phi_10410_: type_18;
    var phi_10413_: f64;
    var phi_10434_: bool;
    var phi_10440_: type_19;
    var phi_10411_: type_18;
    var phi_10454_: type_19;
    var phi_10414_: f64;
    var local_21: f64;
    var phi_10403_: f64;
    var phi_10467_: f64;
    var phi_10536_: f64;
    var phi_10542_: f64;
    var phi_10551_: f64;
    var phi_10557_: f64;
    var phi_10566_: f64;
    var phi_10572_: f64;
    var phi_10581_: f64;
    var phi_10587_: f64;
    var phi_10593_: type_35;
    var phi_10594_: bool;
    var phi_10595_: type_35;
    var phi_10596_: bool;
    var phi_10606_: type_35;
    var phi_10776_: bool;
    var phi_10777_: bool;
    var phi_10778_: bool;
    var phi_10779_: bool;
    var phi_10780_: bool;
    var phi_10781_: bool;
    var phi_10785_: bool;
    var phi_10813_: f64;
    var phi_10819_: f64;
    var phi_10826_: f64;
    var phi_10869_: type_18;
    var phi_10872_: f64;
    var phi_10893_: bool;
    var phi_10899_: type_19;
    var phi_10870_: type_18;
    var phi_10913_: type_19;
    var phi_10873_: f64;
    var local_22: f64;
    var phi_10862_: f64;
    var phi_10926_: f64;
    var phi_10995_: f64;
    var phi_11001_: f64;
    var phi_11010_: f64;
    var phi_11016_: f64;
    var phi_11025_: f64;
    var phi_11031_: f64;
    var phi_11040_: f64;
    var phi_11046_: f64;
    var phi_11052_: type_35;
    var phi_11053_: bool;
    var phi_11054_: type_35;
    var phi_11055_: bool;
    var phi_11065_: type_35;
    var phi_11235_: bool;
    var phi_11236_: bool;
    var phi_11237_: bool;
    var phi_11238_: bool;
    var phi_11239_: bool;
    var phi_11240_: bool;
    var phi_11244_: bool;
    var phi_11245_: bool;
    var phi_11246_: bool;
    var phi_11247_: bool;
    var phi_11248_: bool;
    var phi_11249_: bool;
    var phi_11253_: bool;
    var phi_11259_: type_43;
    var phi_11260_: bool;
    var phi_11261_: type_43;
    var phi_11262_: bool;
    var phi_11308_: type_18;
    var phi_11311_: f64;
    var phi_11332_: bool;
    var phi_11338_: type_19;
    var phi_11309_: type_18;
    var phi_11352_: type_19;
    var phi_11312_: f64;
    var local_23: f64;
    var phi_11301_: f64;
    var phi_11365_: f64;
    var phi_11371_: f64;
    var phi_11396_: type_9;
    var phi_11399_: u32;
    var phi_11397_: type_9;
    var phi_11422_: type_9;
    var phi_11466_: u32;
    var phi_11467_: u32;
    var phi_11400_: u32;
    var phi_11468_: u32;
    var phi_11488_: type_9;
    var phi_11489_: type_9;
    var phi_11512_: type_9;
    var phi_11531_: f64;
    var phi_11544_: f64;
    var phi_11580_: f64;
    var phi_11587_: f64;
    var phi_11599_: bool;
    var phi_11600_: bool;
    var phi_11601_: bool;
    var phi_11602_: bool;
    var phi_11606_: bool;
    var phi_11618_: type_46;
    var phi_11619_: type_46;
    var phi_11620_: bool;
    var phi_11621_: type_46;
    var phi_11622_: bool;
    var phi_11635_: f64;
    var phi_11647_: type_9;
    var phi_11650_: f64;
    var phi_11652_: f64;
    var phi_11654_: f64;
    var phi_11648_: type_9;
    var phi_11677_: type_9;
    var phi_11704_: f64;
    var phi_11705_: f64;
    var phi_11733_: f64;
    var phi_11749_: f64;
    var phi_11756_: bool;
    var phi_11757_: bool;
    var phi_11758_: bool;
    var phi_11764_: f64;
    var phi_11765_: f64;
    var phi_11766_: bool;
    var phi_11651_: f64;
    var phi_11653_: f64;
    var phi_11655_: f64;
    var phi_11767_: f64;
    var phi_11768_: bool;
    var phi_11769_: bool;
    var local_24: bool;
    var phi_11773_: f64;
    var phi_11774_: f64;
    var phi_11784_: f64;
    var phi_11788_: type_9;
    var phi_11791_: f64;
    var phi_11789_: type_9;
    var phi_11814_: type_9;
    var phi_11845_: f64;
    var phi_11846_: bool;
    var phi_11847_: f64;
    var phi_11848_: bool;
    var phi_11849_: bool;
    var phi_11850_: bool;
    var phi_11851_: f64;
    var phi_11792_: f64;
    var phi_11852_: bool;
    var phi_11853_: bool;
    var phi_11854_: bool;
    var phi_11855_: bool;
    var local_25: bool;
    var phi_11859_: bool;
    var phi_11860_: bool;
    var phi_11864_: bool;
    var phi_11868_: f64;
    var phi_11869_: f64;
    var phi_11871_: type_46;
    var phi_11902_: f64;
    var phi_11909_: f64;
    var phi_11914_: f64;
    var phi_11921_: f64;
    var phi_11926_: f64;
    var phi_11939_: f64;
    var phi_11946_: f64;
    var phi_11951_: f64;
    var phi_11958_: f64;
    var phi_11963_: f64;
    var phi_11968_: f64;
    var phi_12027_: f64;
    var phi_12033_: f64;
    var phi_12038_: f64;
    var phi_12044_: f64;
    var phi_12049_: f64;
    var phi_12063_: f64;
    var phi_12069_: f64;
    var phi_12074_: f64;
    var phi_12080_: f64;
    var phi_12085_: f64;
    var phi_12111_: f64;
    var phi_12118_: f64;
    var phi_12123_: f64;
    var phi_12130_: f64;
    var phi_12135_: f64;
    var phi_12148_: f64;
    var phi_12155_: f64;
    var phi_12160_: f64;
    var phi_12167_: f64;
    var phi_12172_: f64;
    var phi_12177_: f64;
    var phi_12236_: f64;
    var phi_12242_: f64;
    var phi_12247_: f64;
    var phi_12253_: f64;
    var phi_12258_: f64;
    var phi_12272_: f64;
    var phi_12278_: f64;
    var phi_12283_: f64;
    var phi_12289_: f64;
    var phi_12294_: f64;
    var phi_12320_: f64;
    var phi_12327_: f64;
    var phi_12332_: f64;
    var phi_12339_: f64;
    var phi_12344_: f64;
    var phi_12357_: f64;
    var phi_12364_: f64;
    var phi_12369_: f64;
    var phi_12376_: f64;
    var phi_12381_: f64;
    var phi_12386_: f64;
    var phi_12445_: f64;
    var phi_12451_: f64;
    var phi_12456_: f64;
    var phi_12462_: f64;
    var phi_12467_: f64;
    var phi_12481_: f64;
    var phi_12487_: f64;
    var phi_12492_: f64;
    var phi_12498_: f64;
    var phi_12503_: f64;
    var phi_12552_: f64;
    var phi_12558_: f64;
    var phi_12586_: f64;
    var phi_12592_: f64;
    var phi_12597_: u32;
    var phi_12598_: u32;
    var phi_12568_: f64;
    var phi_12574_: f64;
    var phi_12579_: u32;
    var phi_12580_: u32;
    var phi_12599_: u32;
    var phi_12600_: u32;
    var phi_12673_: f64;
    var phi_12685_: f64;
    var phi_12828_: f64;
    var phi_12834_: f64;
    var phi_12841_: f64;
    var phi_12877_: array<type_37, 4>;
    var phi_12897_: type_9;
    var phi_12900_: bool;
    var phi_12898_: type_9;
    var phi_12923_: type_9;
    var phi_12950_: bool;
    var phi_12951_: bool;
    var phi_12901_: bool;
    var phi_12952_: bool;
    var phi_12953_: bool;
    var local_26: bool;
    var phi_12957_: bool;
    var local_27: bool;
    var phi_12964_: u32;
    var phi_12965_: u32;
    var phi_12966_: bool;
    var phi_12967_: u32;
    var phi_12968_: u32;
    var phi_12969_: bool;
    var phi_12973_: u32;
    var phi_12983_: bool;
    var phi_12996_: bool;
    var phi_12997_: bool;
    var phi_13058_: array<f64, 3>;
    var phi_13123_: array<f64, 3>;
    var phi_13145_: f64;
    var phi_13152_: f64;
    var phi_13157_: f64;
    var phi_13164_: f64;
    var phi_13169_: f64;
    var phi_13182_: f64;
    var phi_13189_: f64;
    var phi_13194_: f64;
    var phi_13201_: f64;
    var phi_13206_: f64;
    var phi_13211_: f64;
    var phi_13228_: f64;
    var phi_13235_: f64;
    var phi_13240_: f64;
    var phi_13247_: f64;
    var phi_13252_: f64;
    var phi_13266_: f64;
    var phi_13273_: f64;
    var phi_13278_: f64;
    var phi_13285_: f64;
    var phi_13290_: f64;
    var phi_13295_: f64;
    var phi_13312_: f64;
    var phi_13319_: f64;
    var phi_13324_: f64;
    var phi_13331_: f64;
    var phi_13336_: f64;
    var phi_13350_: f64;
    var phi_13357_: f64;
    var phi_13362_: f64;
    var phi_13369_: f64;
    var phi_13374_: f64;
    var phi_13379_: f64;
    var phi_13426_: type_9;
    var phi_13429_: f64;
    var phi_13431_: f64;
    var phi_13433_: f64;
    var phi_13435_: f64;
    var phi_13437_: bool;
    var phi_13439_: u32;
    var phi_13427_: type_9;
    var phi_13462_: type_9;
    var phi_13577_: f64;
    var phi_13583_: f64;
    var phi_13589_: f64;
    var phi_13591_: array<f64, 3>;
    var phi_13598_: f64;
    var phi_13605_: f64;
    var phi_13613_: f64;
    var phi_13659_: type_18;
    var phi_13662_: f64;
    var phi_13683_: bool;
    var phi_13689_: type_19;
    var phi_13660_: type_18;
    var phi_13703_: type_19;
    var phi_13663_: f64;
    var local_28: f64;
    var phi_13652_: f64;
    var phi_13716_: f64;
    var phi_13785_: f64;
    var phi_13791_: f64;
    var phi_13800_: f64;
    var phi_13806_: f64;
    var phi_13815_: f64;
    var phi_13821_: f64;
    var phi_13830_: f64;
    var phi_13836_: f64;
    var phi_13842_: type_35;
    var phi_13843_: bool;
    var phi_13844_: type_35;
    var phi_13845_: bool;
    var phi_13855_: type_35;
    var phi_14027_: bool;
    var phi_14028_: bool;
    var phi_14029_: bool;
    var phi_14030_: bool;
    var phi_14031_: bool;
    var phi_14032_: bool;
    var phi_14036_: bool;
    var phi_14334_: bool;
    var phi_14335_: bool;
    var phi_14336_: bool;
    var phi_14337_: bool;
    var phi_14338_: bool;
    var phi_14339_: bool;
    var phi_14343_: bool;
    var phi_14347_: bool;
    var phi_14358_: bool;
    var phi_14359_: bool;
    var phi_14433_: bool;
    var phi_14434_: bool;
    var phi_14457_: f64;
    var phi_14458_: bool;
    var phi_14459_: f64;
    var phi_14460_: bool;
    var phi_14461_: f64;
    var phi_14462_: bool;
    var phi_14463_: bool;
    var phi_14468_: f64;
    var phi_14469_: bool;
    var phi_14473_: f64;
    var phi_14505_: bool;
    var phi_14506_: bool;
    var phi_14529_: f64;
    var phi_14530_: bool;
    var phi_14531_: f64;
    var phi_14532_: bool;
    var phi_14533_: f64;
    var phi_14534_: bool;
    var phi_14535_: bool;
    var phi_14540_: f64;
    var phi_14541_: bool;
    var phi_14545_: f64;
    var phi_14550_: f64;
    var phi_14582_: bool;
    var phi_14583_: bool;
    var phi_14606_: f64;
    var phi_14607_: bool;
    var phi_14608_: f64;
    var phi_14609_: bool;
    var phi_14610_: f64;
    var phi_14611_: bool;
    var phi_14612_: bool;
    var phi_14617_: f64;
    var phi_14618_: bool;
    var phi_14622_: f64;
    var phi_14654_: bool;
    var phi_14655_: bool;
    var phi_14678_: f64;
    var phi_14679_: bool;
    var phi_14680_: f64;
    var phi_14681_: bool;
    var phi_14682_: f64;
    var phi_14683_: bool;
    var phi_14684_: bool;
    var phi_14689_: f64;
    var phi_14690_: bool;
    var phi_14694_: f64;
    var phi_14699_: f64;
    var phi_14704_: f64;
    var phi_14709_: f64;
    var phi_14723_: f64;
    var phi_14861_: type_18;
    var phi_14864_: f64;
    var phi_14885_: bool;
    var phi_14891_: type_19;
    var phi_14862_: type_18;
    var phi_14905_: type_19;
    var phi_14865_: f64;
    var local_29: f64;
    var phi_14854_: f64;
    var phi_14918_: f64;
    var phi_14936_: f64;
    var phi_14943_: f64;
    var phi_14948_: f64;
    var phi_14955_: f64;
    var phi_14960_: f64;
    var phi_14973_: f64;
    var phi_14980_: f64;
    var phi_14985_: f64;
    var phi_14992_: f64;
    var phi_14997_: f64;
    var phi_15002_: f64;
    var phi_15019_: f64;
    var phi_15026_: f64;
    var phi_15031_: f64;
    var phi_15038_: f64;
    var phi_15043_: f64;
    var phi_15057_: f64;
    var phi_15064_: f64;
    var phi_15069_: f64;
    var phi_15076_: f64;
    var phi_15081_: f64;
    var phi_15086_: f64;
    var phi_15103_: f64;
    var phi_15110_: f64;
    var phi_15115_: f64;
    var phi_15122_: f64;
    var phi_15127_: f64;
    var phi_15141_: f64;
    var phi_15148_: f64;
    var phi_15153_: f64;
    var phi_15160_: f64;
    var phi_15165_: f64;
    var phi_15170_: f64;
    var phi_15194_: bool;
    var phi_15195_: bool;
    var phi_15196_: bool;
    var phi_15213_: f64;
    var phi_15214_: bool;
    var phi_15215_: f64;
    var phi_15216_: bool;
    var phi_15221_: f64;
    var phi_15223_: f64;
    var phi_15224_: f64;
    var phi_15225_: bool;
    var phi_15226_: f64;
    var phi_15227_: f64;
    var phi_15228_: bool;
    var phi_15229_: bool;
    var phi_15230_: f64;
    var phi_15231_: f64;
    var phi_15232_: f64;
    var phi_15233_: f64;
    var phi_15234_: bool;
    var phi_15235_: bool;
    var phi_15236_: bool;
    var phi_15237_: bool;
    var phi_15238_: f64;
    var phi_15239_: f64;
    var phi_15240_: f64;
    var phi_15241_: f64;
    var phi_15242_: bool;
    var phi_15243_: bool;
    var phi_15244_: bool;
    var phi_15245_: bool;
    var phi_15246_: bool;
    var phi_15247_: f64;
    var phi_15248_: f64;
    var phi_15249_: f64;
    var phi_15250_: f64;
    var phi_15251_: bool;
    var phi_15252_: bool;
    var phi_15253_: bool;
    var phi_15254_: bool;
    var phi_15255_: bool;
    var phi_15341_: f64;
    var phi_15414_: f64;
    var phi_15419_: f64;
    var phi_15492_: f64;
    var phi_15565_: f64;
    var phi_15570_: f64;
    var phi_15591_: f64;
    var phi_15592_: f64;
    var phi_15593_: f64;
    var phi_15268_: bool;
    var phi_15595_: u32;
    var phi_15596_: f64;
    var phi_15597_: bool;
    var phi_15598_: bool;
    var phi_15599_: bool;
    var phi_15600_: u32;
    var phi_15601_: f64;
    var phi_15602_: f64;
    var phi_15603_: f64;
    var phi_15604_: f64;
    var phi_15605_: bool;
    var phi_15606_: u32;
    var phi_15607_: bool;
    var phi_15608_: bool;
    var phi_15609_: bool;
    var phi_15610_: bool;
    var phi_15611_: bool;
    var phi_15612_: bool;
    var phi_15621_: f64;
    var phi_15626_: f64;
    var phi_15635_: bool;
    var phi_15639_: bool;
    var phi_15640_: f64;
    var phi_15641_: f64;
    var phi_15642_: f64;
    var phi_15643_: f64;
    var phi_15644_: bool;
    var phi_15645_: u32;
    var phi_15646_: bool;
    var phi_15647_: bool;
    var phi_15648_: bool;
    var phi_15649_: bool;
    var phi_15650_: bool;
    var phi_15651_: bool;
    var phi_13430_: f64;
    var phi_13432_: f64;
    var phi_13434_: f64;
    var phi_13436_: f64;
    var phi_13438_: bool;
    var phi_13440_: u32;
    var phi_15652_: f64;
    var phi_15653_: f64;
    var phi_15654_: bool;
    var phi_15655_: bool;
    var phi_15656_: bool;
    var phi_15657_: bool;
    var phi_15658_: bool;
    var phi_15659_: bool;
    var phi_15660_: bool;
    var local_30: bool;
    var phi_15664_: bool;
    var phi_15665_: bool;
    var phi_15666_: bool;
    var phi_15667_: bool;
    var phi_15668_: bool;
    var local_31: f64;
    var phi_15673_: type_43;
    var phi_15674_: bool;
    var phi_15675_: bool;
    var phi_15676_: bool;
    var phi_15677_: bool;
    var phi_15678_: bool;
    var phi_15683_: type_43;
    var phi_15684_: bool;
    var phi_15685_: bool;
    var phi_15686_: bool;
    var phi_15687_: bool;
    var phi_15688_: bool;
    var phi_15692_: f64;
    var phi_15693_: bool;
    var phi_15694_: bool;
    var phi_15695_: bool;
    var phi_15696_: bool;
    var phi_15700_: f64;
    var phi_15701_: bool;
    var phi_15702_: bool;
    var phi_15703_: bool;
    var phi_15708_: type_43;
    var phi_15709_: bool;
    var phi_15710_: bool;
    var phi_15715_: type_43;
    var phi_15716_: bool;
    var phi_15720_: type_43;
    var phi_15727_: bool;
    var phi_15728_: f64;
    var phi_15729_: bool;
    var phi_15730_: bool;
    var phi_15731_: bool;
    var phi_15732_: bool;
    var phi_15733_: f64;
    var phi_15734_: f64;
    var phi_15735_: bool;
    var phi_15736_: bool;
    var phi_15737_: bool;
    var phi_15738_: bool;
    var phi_15739_: f64;
    var phi_15740_: f64;
    var phi_15741_: bool;
    var phi_15742_: bool;
    var phi_15743_: bool;
    var phi_15744_: bool;
    var phi_15748_: bool;
    var phi_15749_: bool;
    var phi_15750_: bool;
    var phi_15751_: type_46;
    var phi_15752_: bool;
    var phi_15753_: f64;
    var phi_15754_: f64;
    var phi_15755_: type_46;
    var phi_15756_: bool;
    var phi_15757_: bool;
    var phi_15758_: bool;
    var phi_15759_: bool;
    var phi_15763_: bool;
    var phi_15764_: bool;
    var phi_15765_: bool;
    var phi_15766_: type_46;
    var phi_15767_: bool;
    var phi_15768_: f64;
    var phi_15769_: f64;
    var phi_15770_: type_46;
    var phi_15771_: bool;
    var phi_15772_: bool;
    var phi_15773_: bool;
    var phi_15774_: bool;
    var local_32: bool;
    var phi_15779_: type_43;
    var phi_15780_: bool;
    var phi_15781_: bool;
    var local_33: bool;
    var local_34: type_46;
    var local_35: f64;
    var local_36: f64;
    var local_37: f64;
    var phi_15795_: type_43;
    var phi_15796_: bool;
    var phi_15797_: type_43;
    var phi_15798_: bool;
    var local_38: f64;
    var phi_15803_: type_43;
    var phi_15804_: type_43;
    var phi_15805_: bool;
    var local_39: type_46;
    var phi_15811_: type_43;
    var phi_15812_: bool;
    var phi_15816_: type_43;
    var phi_15817_: type_43;
    var phi_15818_: bool;
    var phi_15822_: type_43;
    var phi_15823_: type_43;
    var phi_15824_: bool;
    var phi_15828_: type_43;
    var phi_15839_: bool;
    var phi_15840_: bool;
    var phi_15844_: bool;
    var phi_15848_: u32;
    var phi_1537_: type_18;
    var phi_1540_: f64;
    var phi_1561_: bool;
    var phi_1567_: type_19;
    var phi_1538_: type_18;
    var phi_1581_: type_19;
    var phi_1541_: f64;
    var local_40: f64;
    var phi_1530_: f64;
    var phi_1594_: f64;
    var phi_1612_: f64;
    var phi_1619_: f64;
    var phi_1624_: f64;
    var phi_1631_: f64;
    var phi_1636_: f64;
    var phi_1649_: f64;
    var phi_1656_: f64;
    var phi_1661_: f64;
    var phi_1668_: f64;
    var phi_1673_: f64;
    var phi_1678_: f64;
    var phi_1695_: f64;
    var phi_1702_: f64;
    var phi_1707_: f64;
    var phi_1714_: f64;
    var phi_1719_: f64;
    var phi_1733_: f64;
    var phi_1740_: f64;
    var phi_1745_: f64;
    var phi_1752_: f64;
    var phi_1757_: f64;
    var phi_1762_: f64;
    var phi_1779_: f64;
    var phi_1786_: f64;
    var phi_1791_: f64;
    var phi_1798_: f64;
    var phi_1803_: f64;
    var phi_1817_: f64;
    var phi_1824_: f64;
    var phi_1829_: f64;
    var phi_1836_: f64;
    var phi_1841_: f64;
    var phi_1846_: f64;
    var phi_2111_: f64;
    var phi_2118_: f64;
    var phi_2123_: f64;
    var phi_2130_: f64;
    var phi_2135_: f64;
    var phi_2148_: f64;
    var phi_2155_: f64;
    var phi_2160_: f64;
    var phi_2167_: f64;
    var phi_2172_: f64;
    var phi_2177_: f64;
    var phi_2194_: f64;
    var phi_2201_: f64;
    var phi_2206_: f64;
    var phi_2213_: f64;
    var phi_2218_: f64;
    var phi_2232_: f64;
    var phi_2239_: f64;
    var phi_2244_: f64;
    var phi_2251_: f64;
    var phi_2256_: f64;
    var phi_2261_: f64;
    var phi_2278_: f64;
    var phi_2285_: f64;
    var phi_2290_: f64;
    var phi_2297_: f64;
    var phi_2302_: f64;
    var phi_2316_: f64;
    var phi_2323_: f64;
    var phi_2328_: f64;
    var phi_2335_: f64;
    var phi_2340_: f64;
    var phi_2345_: f64;
    var phi_2382_: f64;
    var phi_2388_: f64;
    var phi_2395_: f64;
    var phi_2402_: f64;
    var phi_2408_: f64;
    var phi_2415_: f64;
    var phi_2421_: f64;
    var phi_2427_: f64;
    var phi_2433_: f64;
    var phi_2440_: f64;
    var phi_2447_: f64;
    var phi_2475_: f64;
    var phi_2480_: f64;
    var phi_2485_: f64;
    var phi_2490_: f64;
    var phi_2495_: f64;
    var phi_2500_: f64;
    var phi_2511_: f64;
    var phi_2521_: type_44;
    var phi_2522_: bool;
    var phi_2523_: type_44;
    var phi_2524_: bool;
    var phi_2530_: type_18;
    var phi_2533_: f64;
    var phi_2535_: u32;
    var phi_2537_: f64;
    var phi_2558_: bool;
    var phi_2564_: type_19;
    var phi_2531_: type_18;
    var phi_2578_: type_19;
    var phi_2593_: bool;
    var phi_2594_: bool;
    var phi_2653_: array<f64, 3>;
    var phi_2718_: array<f64, 3>;
    var phi_2740_: f64;
    var phi_2747_: f64;
    var phi_2752_: f64;
    var phi_2759_: f64;
    var phi_2764_: f64;
    var phi_2777_: f64;
    var phi_2784_: f64;
    var phi_2789_: f64;
    var phi_2796_: f64;
    var phi_2801_: f64;
    var phi_2806_: f64;
    var phi_2823_: f64;
    var phi_2830_: f64;
    var phi_2835_: f64;
    var phi_2842_: f64;
    var phi_2847_: f64;
    var phi_2861_: f64;
    var phi_2868_: f64;
    var phi_2873_: f64;
    var phi_2880_: f64;
    var phi_2885_: f64;
    var phi_2890_: f64;
    var phi_2907_: f64;
    var phi_2914_: f64;
    var phi_2919_: f64;
    var phi_2926_: f64;
    var phi_2931_: f64;
    var phi_2945_: f64;
    var phi_2952_: f64;
    var phi_2957_: f64;
    var phi_2964_: f64;
    var phi_2969_: f64;
    var phi_2974_: f64;
    var phi_3021_: type_9;
    var phi_3024_: f64;
    var phi_3026_: f64;
    var phi_3028_: f64;
    var phi_3030_: f64;
    var phi_3032_: bool;
    var phi_3034_: u32;
    var phi_3022_: type_9;
    var phi_3057_: type_9;
    var phi_3172_: f64;
    var phi_3178_: f64;
    var phi_3184_: f64;
    var phi_3186_: array<f64, 3>;
    var phi_3193_: f64;
    var phi_3200_: f64;
    var phi_3208_: f64;
    var phi_3254_: type_18;
    var phi_3257_: f64;
    var phi_3278_: bool;
    var phi_3284_: type_19;
    var phi_3255_: type_18;
    var phi_3298_: type_19;
    var phi_3258_: f64;
    var local_41: f64;
    var phi_3247_: f64;
    var phi_3311_: f64;
    var phi_3380_: f64;
    var phi_3386_: f64;
    var phi_3395_: f64;
    var phi_3401_: f64;
    var phi_3410_: f64;
    var phi_3416_: f64;
    var phi_3425_: f64;
    var phi_3431_: f64;
    var phi_3437_: type_35;
    var phi_3438_: bool;
    var phi_3439_: type_35;
    var phi_3440_: bool;
    var phi_3450_: type_35;
    var phi_3622_: bool;
    var phi_3623_: bool;
    var phi_3624_: bool;
    var phi_3625_: bool;
    var phi_3626_: bool;
    var phi_3627_: bool;
    var phi_3631_: bool;
    var phi_3929_: bool;
    var phi_3930_: bool;
    var phi_3931_: bool;
    var phi_3932_: bool;
    var phi_3933_: bool;
    var phi_3934_: bool;
    var phi_3938_: bool;
    var phi_3942_: bool;
    var phi_3953_: bool;
    var phi_3954_: bool;
    var phi_4028_: bool;
    var phi_4029_: bool;
    var phi_4052_: f64;
    var phi_4053_: bool;
    var phi_4054_: f64;
    var phi_4055_: bool;
    var phi_4056_: f64;
    var phi_4057_: bool;
    var phi_4058_: bool;
    var phi_4063_: f64;
    var phi_4064_: bool;
    var phi_4068_: f64;
    var phi_4100_: bool;
    var phi_4101_: bool;
    var phi_4124_: f64;
    var phi_4125_: bool;
    var phi_4126_: f64;
    var phi_4127_: bool;
    var phi_4128_: f64;
    var phi_4129_: bool;
    var phi_4130_: bool;
    var phi_4135_: f64;
    var phi_4136_: bool;
    var phi_4140_: f64;
    var phi_4145_: f64;
    var phi_4177_: bool;
    var phi_4178_: bool;
    var phi_4201_: f64;
    var phi_4202_: bool;
    var phi_4203_: f64;
    var phi_4204_: bool;
    var phi_4205_: f64;
    var phi_4206_: bool;
    var phi_4207_: bool;
    var phi_4212_: f64;
    var phi_4213_: bool;
    var phi_4217_: f64;
    var phi_4249_: bool;
    var phi_4250_: bool;
    var phi_4273_: f64;
    var phi_4274_: bool;
    var phi_4275_: f64;
    var phi_4276_: bool;
    var phi_4277_: f64;
    var phi_4278_: bool;
    var phi_4279_: bool;
    var phi_4284_: f64;
    var phi_4285_: bool;
    var phi_4289_: f64;
    var phi_4294_: f64;
    var phi_4299_: f64;
    var phi_4304_: f64;
    var phi_4318_: f64;
    var phi_4456_: type_18;
    var phi_4459_: f64;
    var phi_4480_: bool;
    var phi_4486_: type_19;
    var phi_4457_: type_18;
    var phi_4500_: type_19;
    var phi_4460_: f64;
    var local_42: f64;
    var phi_4449_: f64;
    var phi_4513_: f64;
    var phi_4531_: f64;
    var phi_4538_: f64;
    var phi_4543_: f64;
    var phi_4550_: f64;
    var phi_4555_: f64;
    var phi_4568_: f64;
    var phi_4575_: f64;
    var phi_4580_: f64;
    var phi_4587_: f64;
    var phi_4592_: f64;
    var phi_4597_: f64;
    var phi_4614_: f64;
    var phi_4621_: f64;
    var phi_4626_: f64;
    var phi_4633_: f64;
    var phi_4638_: f64;
    var phi_4652_: f64;
    var phi_4659_: f64;
    var phi_4664_: f64;
    var phi_4671_: f64;
    var phi_4676_: f64;
    var phi_4681_: f64;
    var phi_4698_: f64;
    var phi_4705_: f64;
    var phi_4710_: f64;
    var phi_4717_: f64;
    var phi_4722_: f64;
    var phi_4736_: f64;
    var phi_4743_: f64;
    var phi_4748_: f64;
    var phi_4755_: f64;
    var phi_4760_: f64;
    var phi_4765_: f64;
    var phi_4789_: bool;
    var phi_4790_: bool;
    var phi_4791_: bool;
    var phi_4808_: f64;
    var phi_4809_: bool;
    var phi_4810_: f64;
    var phi_4811_: bool;
    var phi_4816_: f64;
    var phi_4818_: f64;
    var phi_4819_: f64;
    var phi_4820_: bool;
    var phi_4821_: f64;
    var phi_4822_: f64;
    var phi_4823_: bool;
    var phi_4824_: bool;
    var phi_4825_: f64;
    var phi_4826_: f64;
    var phi_4827_: f64;
    var phi_4828_: f64;
    var phi_4829_: bool;
    var phi_4830_: bool;
    var phi_4831_: bool;
    var phi_4832_: bool;
    var phi_4833_: f64;
    var phi_4834_: f64;
    var phi_4835_: f64;
    var phi_4836_: f64;
    var phi_4837_: bool;
    var phi_4838_: bool;
    var phi_4839_: bool;
    var phi_4840_: bool;
    var phi_4841_: bool;
    var phi_4842_: f64;
    var phi_4843_: f64;
    var phi_4844_: f64;
    var phi_4845_: f64;
    var phi_4846_: bool;
    var phi_4847_: bool;
    var phi_4848_: bool;
    var phi_4849_: bool;
    var phi_4850_: bool;
    var phi_4936_: f64;
    var phi_5009_: f64;
    var phi_5014_: f64;
    var phi_5087_: f64;
    var phi_5160_: f64;
    var phi_5165_: f64;
    var phi_5186_: f64;
    var phi_5187_: f64;
    var phi_5188_: f64;
    var phi_4863_: bool;
    var phi_5190_: u32;
    var phi_5191_: f64;
    var phi_5192_: bool;
    var phi_5193_: bool;
    var phi_5194_: bool;
    var phi_5195_: u32;
    var phi_5196_: f64;
    var phi_5197_: f64;
    var phi_5198_: f64;
    var phi_5199_: f64;
    var phi_5200_: bool;
    var phi_5201_: u32;
    var phi_5202_: bool;
    var phi_5203_: bool;
    var phi_5204_: bool;
    var phi_5205_: bool;
    var phi_5206_: bool;
    var phi_5207_: bool;
    var phi_5216_: f64;
    var phi_5221_: f64;
    var phi_5230_: bool;
    var phi_5234_: bool;
    var phi_5235_: f64;
    var phi_5236_: f64;
    var phi_5237_: f64;
    var phi_5238_: f64;
    var phi_5239_: bool;
    var phi_5240_: u32;
    var phi_5241_: bool;
    var phi_5242_: bool;
    var phi_5243_: bool;
    var phi_5244_: bool;
    var phi_5245_: bool;
    var phi_5246_: bool;
    var phi_3025_: f64;
    var phi_3027_: f64;
    var phi_3029_: f64;
    var phi_3031_: f64;
    var phi_3033_: bool;
    var phi_3035_: u32;
    var phi_5247_: f64;
    var phi_5248_: f64;
    var phi_5249_: bool;
    var phi_5250_: bool;
    var phi_5251_: bool;
    var phi_5252_: bool;
    var phi_5253_: bool;
    var phi_5254_: bool;
    var phi_5255_: bool;
    var local_43: bool;
    var phi_5259_: bool;
    var phi_5260_: bool;
    var phi_5261_: bool;
    var phi_5262_: bool;
    var phi_5263_: bool;
    var local_44: f64;
    var phi_5268_: type_43;
    var phi_5269_: bool;
    var phi_5270_: bool;
    var phi_5271_: bool;
    var phi_5272_: bool;
    var phi_5273_: bool;
    var phi_5278_: type_43;
    var phi_5279_: bool;
    var phi_5280_: bool;
    var phi_5281_: bool;
    var phi_5282_: bool;
    var phi_5283_: bool;
    var phi_5287_: f64;
    var phi_5288_: bool;
    var phi_5289_: bool;
    var phi_5290_: bool;
    var phi_5291_: bool;
    var phi_5295_: f64;
    var phi_5296_: bool;
    var phi_5297_: bool;
    var phi_5298_: bool;
    var phi_5303_: type_43;
    var phi_5304_: bool;
    var phi_5305_: bool;
    var phi_5310_: type_43;
    var phi_5311_: bool;
    var phi_5315_: type_43;
    var phi_5322_: f64;
    var phi_5323_: bool;
    var phi_5436_: f64;
    var phi_5443_: f64;
    var phi_5451_: f64;
    var phi_5509_: array<f64, 3>;
    var phi_5577_: array<f64, 3>;
    var phi_5602_: f64;
    var phi_5609_: f64;
    var phi_5614_: f64;
    var phi_5621_: f64;
    var phi_5626_: f64;
    var phi_5639_: f64;
    var phi_5646_: f64;
    var phi_5651_: f64;
    var phi_5658_: f64;
    var phi_5663_: f64;
    var phi_5668_: f64;
    var phi_5685_: f64;
    var phi_5692_: f64;
    var phi_5697_: f64;
    var phi_5704_: f64;
    var phi_5709_: f64;
    var phi_5723_: f64;
    var phi_5730_: f64;
    var phi_5735_: f64;
    var phi_5742_: f64;
    var phi_5747_: f64;
    var phi_5752_: f64;
    var phi_5769_: f64;
    var phi_5776_: f64;
    var phi_5781_: f64;
    var phi_5788_: f64;
    var phi_5793_: f64;
    var phi_5807_: f64;
    var phi_5814_: f64;
    var phi_5819_: f64;
    var phi_5826_: f64;
    var phi_5831_: f64;
    var phi_5836_: f64;
    var phi_5948_: type_18;
    var phi_5951_: f64;
    var phi_5972_: bool;
    var phi_5978_: type_19;
    var phi_5949_: type_18;
    var phi_5992_: type_19;
    var phi_5952_: f64;
    var local_45: f64;
    var phi_5941_: f64;
    var phi_6005_: f64;
    var phi_6142_: f64;
    var phi_6148_: f64;
    var phi_6157_: f64;
    var phi_6163_: f64;
    var phi_6172_: f64;
    var phi_6178_: f64;
    var phi_6187_: f64;
    var phi_6193_: f64;
    var phi_6243_: type_18;
    var phi_6246_: f64;
    var phi_6267_: bool;
    var phi_6273_: type_19;
    var phi_6244_: type_18;
    var phi_6287_: type_19;
    var phi_6247_: f64;
    var local_46: f64;
    var phi_6236_: f64;
    var phi_6300_: f64;
    var phi_6332_: type_18;
    var phi_6335_: f64;
    var phi_6356_: bool;
    var phi_6362_: type_19;
    var phi_6333_: type_18;
    var phi_6376_: type_19;
    var phi_6336_: f64;
    var local_47: f64;
    var phi_6325_: f64;
    var phi_6389_: f64;
    var phi_6407_: f64;
    var phi_6414_: f64;
    var phi_6419_: f64;
    var phi_6426_: f64;
    var phi_6431_: f64;
    var phi_6444_: f64;
    var phi_6451_: f64;
    var phi_6456_: f64;
    var phi_6463_: f64;
    var phi_6468_: f64;
    var phi_6473_: f64;
    var phi_6490_: f64;
    var phi_6497_: f64;
    var phi_6502_: f64;
    var phi_6509_: f64;
    var phi_6514_: f64;
    var phi_6528_: f64;
    var phi_6535_: f64;
    var phi_6540_: f64;
    var phi_6547_: f64;
    var phi_6552_: f64;
    var phi_6557_: f64;
    var phi_6574_: f64;
    var phi_6581_: f64;
    var phi_6586_: f64;
    var phi_6593_: f64;
    var phi_6598_: f64;
    var phi_6612_: f64;
    var phi_6619_: f64;
    var phi_6624_: f64;
    var phi_6631_: f64;
    var phi_6636_: f64;
    var phi_6641_: f64;
    var phi_6689_: f64;
    var phi_6695_: f64;
    var phi_6707_: type_9;
    var phi_6710_: f64;
    var phi_6708_: type_9;
    var phi_6733_: type_9;
    var phi_6763_: f64;
    var phi_6769_: f64;
    var phi_6783_: f64;
    var phi_6711_: f64;
    var local_48: f64;
    var local_49: f64;
    var phi_6812_: type_18;
    var phi_6815_: f64;
    var phi_6836_: bool;
    var phi_6842_: type_19;
    var phi_6813_: type_18;
    var phi_6856_: type_19;
    var phi_6816_: f64;
    var local_50: f64;
    var phi_6805_: f64;
    var phi_6869_: f64;
    var phi_6876_: type_9;
    var phi_6879_: f64;
    var phi_6881_: bool;
    var phi_6883_: bool;
    var phi_6877_: type_9;
    var phi_6906_: type_9;
    var phi_6943_: f64;
    var phi_6950_: f64;
    var phi_6958_: f64;
    var phi_6966_: f64;
    var phi_6973_: f64;
    var phi_6981_: f64;
    var phi_6987_: f64;
    var phi_7007_: f64;
    var phi_7013_: f64;
    var phi_7020_: f64;
    var phi_7049_: f64;
    var phi_7055_: f64;
    var phi_7092_: bool;
    var phi_7099_: bool;
    var phi_7112_: f64;
    var phi_7118_: f64;
    var phi_7119_: f64;
    var phi_7120_: f64;
    var phi_6880_: f64;
    var phi_6882_: bool;
    var phi_6884_: bool;
    var local_51: f64;
    var phi_7126_: f64;
    var local_52: bool;
    var local_53: bool;
    var phi_7137_: type_45;
    var phi_7138_: type_45;
    var phi_7139_: bool;
    var local_54: bool;
    var phi_7157_: f64;
    var phi_7158_: f64;
    var phi_7161_: type_9;
    var phi_7164_: f64;
    var phi_7166_: f64;
    var phi_7162_: type_9;
    var phi_7189_: type_9;
    var phi_7275_: f64;
    var phi_7276_: f64;
    var phi_7277_: f64;
    var phi_7258_: f64;
    var phi_7278_: f64;
    var phi_7279_: f64;
    var phi_7165_: f64;
    var phi_7167_: f64;
    var local_55: f64;
    var local_56: f64;
    var local_57: f64;
    var phi_7442_: bool;
    var phi_7443_: bool;
    var phi_7444_: bool;
    var phi_7445_: bool;
    var phi_7446_: bool;
    var phi_7447_: bool;
    var phi_7451_: bool;
    var phi_7455_: bool;
    var phi_7456_: bool;
    var phi_7457_: bool;
    var phi_7462_: f64;
    var phi_7466_: type_45;
    var phi_7467_: type_45;
    var phi_7468_: bool;
    var phi_7469_: type_45;
    var phi_7470_: type_45;
    var phi_7471_: bool;
    var phi_7477_: type_45;
    var phi_7478_: type_45;
    var phi_7479_: bool;
    var phi_7483_: type_45;
    var phi_7484_: type_45;
    var phi_7485_: bool;
    var phi_7486_: bool;
    var phi_7487_: type_45;
    var phi_7488_: type_45;
    var phi_7489_: bool;
    var phi_7490_: bool;
    var phi_7496_: type_45;
    var phi_7497_: bool;
    var phi_7501_: type_45;
    var phi_7517_: f64;
    var phi_7518_: f64;
    var phi_7519_: bool;
    var phi_7520_: f64;
    var phi_7521_: f64;
    var phi_7522_: bool;
    var phi_7523_: bool;
    var phi_7524_: bool;
    var phi_7525_: f64;
    var phi_7526_: f64;
    var phi_7527_: bool;
    var phi_7528_: bool;
    var phi_7529_: bool;
    var phi_7530_: f64;
    var phi_7531_: u32;
    var phi_7532_: f64;
    var phi_7533_: type_45;
    var phi_7534_: u32;
    var phi_7535_: u32;
    var phi_7536_: bool;
    var phi_7537_: bool;
    var phi_7538_: bool;
    var phi_7539_: f64;
    var phi_7540_: u32;
    var phi_7541_: f64;
    var phi_7542_: type_45;
    var phi_7543_: u32;
    var phi_7544_: u32;
    var phi_7545_: bool;
    var phi_7546_: bool;
    var phi_7547_: bool;
    var phi_7548_: bool;
    var phi_7549_: bool;
    var phi_7550_: f64;
    var phi_2534_: f64;
    var phi_2536_: u32;
    var phi_2538_: f64;
    var phi_7551_: type_45;
    var phi_7552_: u32;
    var phi_7553_: f64;
    var phi_7554_: u32;
    var phi_7555_: bool;
    var phi_7556_: bool;
    var phi_7557_: bool;
    var phi_7558_: bool;
    var phi_7559_: bool;
    var phi_7560_: bool;
    var local_58: bool;
    var phi_7564_: bool;
    var phi_7565_: bool;
    var phi_7566_: bool;
    var phi_7567_: bool;
    var local_59: type_45;
    var local_60: type_45;
    var phi_7584_: u32;
    var local_61: type_45;
    var phi_7589_: type_44;
    var phi_7590_: type_44;
    var phi_7591_: bool;
    var phi_7592_: bool;
    var phi_7593_: bool;
    var phi_7594_: bool;
    var phi_7598_: u32;
    var phi_7599_: f64;
    var phi_7600_: bool;
    var phi_7601_: bool;
    var phi_7602_: bool;
    var phi_7603_: bool;
    var phi_7607_: f64;
    var phi_7608_: u32;
    var phi_7609_: bool;
    var phi_7610_: bool;
    var phi_7611_: bool;
    var phi_7625_: f64;
    var phi_7628_: type_9;
    var phi_7629_: type_9;
    var phi_7652_: type_9;
    var phi_7674_: f64;
    var phi_7804_: type_18;
    var phi_7807_: f64;
    var phi_7828_: bool;
    var phi_7834_: type_19;
    var phi_7805_: type_18;
    var phi_7848_: type_19;
    var phi_7808_: f64;
    var local_62: f64;
    var phi_7797_: f64;
    var phi_7861_: f64;
    var phi_7879_: f64;
    var phi_7886_: f64;
    var phi_7891_: f64;
    var phi_7898_: f64;
    var phi_7903_: f64;
    var phi_7916_: f64;
    var phi_7923_: f64;
    var phi_7928_: f64;
    var phi_7935_: f64;
    var phi_7940_: f64;
    var phi_7945_: f64;
    var phi_7962_: f64;
    var phi_7969_: f64;
    var phi_7974_: f64;
    var phi_7981_: f64;
    var phi_7986_: f64;
    var phi_8000_: f64;
    var phi_8007_: f64;
    var phi_8012_: f64;
    var phi_8019_: f64;
    var phi_8024_: f64;
    var phi_8029_: f64;
    var phi_8046_: f64;
    var phi_8053_: f64;
    var phi_8058_: f64;
    var phi_8065_: f64;
    var phi_8070_: f64;
    var phi_8084_: f64;
    var phi_8091_: f64;
    var phi_8096_: f64;
    var phi_8103_: f64;
    var phi_8108_: f64;
    var phi_8113_: f64;
    var phi_8137_: bool;
    var phi_8138_: bool;
    var phi_8139_: bool;
    var local_63: bool;
    var phi_8147_: u32;
    var phi_8151_: type_44;
    var phi_8152_: bool;
    var phi_8160_: u32;
    var phi_8164_: type_44;
    var phi_8165_: type_44;
    var phi_8166_: bool;
    var phi_8167_: bool;
    var phi_8174_: type_44;
    var phi_8175_: bool;
    var phi_8179_: type_44;
    var phi_8180_: type_44;
    var phi_8181_: bool;
    var phi_8185_: type_44;
    var phi_15852_: type_44;
    var phi_15870_: type_47;
    var phi_15888_: bool;
    var phi_15895_: bool;
    var phi_15896_: bool;
    var phi_15919_: u32;
    var phi_15923_: type_24;
    var phi_15924_: bool;
    var phi_15935_: u32;
    var phi_15995_: bool;
    var phi_15996_: bool;
    var local_64: u32;
    var local_65: f64;
    var local_66: f64;
    var local_67: bool;
    var local_68: bool;
    var local_69: f64;
    var local_70: bool;
    var local_71: bool;
    var local_72: bool;
    var local_73: bool;
    var local_74: bool;
    var local_75: bool;
    var local_76: f64;
    var local_77: f64;
    var local_78: f64;
    var local_79: bool;
    var local_80: bool;
    var local_81: bool;
    var local_82: bool;
    var local_83: bool;
    var local_84: bool;
    var local_85: bool;
    var local_86: bool;
    var local_87: f64;
    var local_88: f64;
    var local_89: f64;
    var local_90: f64;
    var local_91: bool;
    var local_92: bool;
    var local_93: bool;
    var local_94: bool;
    var local_95: bool;
    var local_96: u32;
    var local_97: bool;
    var local_98: u32;
    var local_99: u32;
    var local_100: f64;
    var local_101: f64;
    var local_102: f64;
    var local_103: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e121 = id_2;
    let _e122 = n_2;
    let _e123 = lane_2;
    let _e135 = ((_e121.y * _e122.x) + _e121.x);
    let _e138 = (_e122.x * _e122.y);
    let _e141 = params.member.member_1.member_2;
    let _e143 = input.member[0u];
    if (_e141 < _e143) {
        phi_399_ = _e141;
    } else {
        phi_399_ = _e143;
    }
    let _e146 = phi_399_;
    let _e148 = params.member.member_1.member_1;
    if (_e146 > _e148) {
        let _e151 = params.member.member_1.member_1;
        phi_409_ = (_e146 - _e151);
    } else {
        phi_409_ = 0u;
    }
    let _e154 = phi_409_;
    let _e156 = params.member.member_1.member;
    if (_e156 < _e154) {
        phi_416_ = _e156;
    } else {
        phi_416_ = _e154;
    }
    let _e159 = phi_416_;
    let _e160 = (_e159 / 64u);
    if ((_e159 % 64u) > 0u) {
        phi_432_ = (_e160 + 1u);
    } else {
        phi_432_ = _e160;
    }
    let _e165 = phi_432_;
    if (_e165 > _e135) {
        let _e167 = (_e165 - _e135);
        if (_e138 == 0u) {
            return;
        }
        let _e169 = (_e167 / _e138);
        if (_e138 == 0u) {
            return;
        }
        if ((_e167 % _e138) > 0u) {
            phi_453_ = (_e169 + 1u);
        } else {
            phi_453_ = _e169;
        }
        let _e175 = phi_453_;
        phi_454_ = _e175;
    } else {
        phi_454_ = 0u;
    }
    let _e177 = phi_454_;
    phi_457_ = type_9(0u, _e177);
    loop {
        let _e180 = phi_457_;
        if (_e180.member < _e180.member_1) {
            phi_458_ = type_9((_e180.member + 1u), _e180.member_1);
            phi_481_ = type_9(1u, _e180.member);
        } else {
            phi_458_ = _e180;
            phi_481_ = type_9(0u, type_9().member_1);
        }
        let _e192 = phi_458_;
        let _e194 = phi_481_;
        let _e198 = (bitcast<i32>(_e194.member) != 0i);
        if _e198 {
            let _e202 = (((_e135 + (_e194.member_1 * _e138)) * 64u) + _e123);
            let _e205 = params.member.member_2.member;
            let _e208 = params.member.member.member_1;
            let _e210 = ((_e208 & 16u) != 0u);
            if (_e202 < _e159) {
                let _e215 = params.member.member_1.member_1;
                let _e217 = (2u * (_e215 + _e202));
                let _e220 = input.member[(4u + _e217)];
                let _e223 = input.member[(_e217 + 5u)];
                if (_e205 == 0u) {
                    let _e240 = (3u * _e223);
                    let _e242 = elements.member[_e240];
                    let _e245 = elements.member[(_e240 + 1u)];
                    let _e248 = elements.member[(_e240 + 2u)];
                    phi_619_ = type_26(0u, array<u32, 4>(_e220, _e242, _e245, _e248));
                } else {
                    let _e226 = (2u * _e220);
                    let _e227 = (2u * _e223);
                    let _e229 = elements.member[_e226];
                    let _e231 = elements.member[_e227];
                    let _e234 = elements.member[(_e226 + 1u)];
                    let _e237 = elements.member[(_e227 + 1u)];
                    phi_619_ = type_26(1u, array<u32, 4>(_e229, _e234, _e231, _e237));
                }
                let _e252 = phi_619_;
                let _e256 = params.member.member.member_1;
                if ((_e256 & 8u) != 0u) {
                    let _e300 = paths.member[_e252.member_1[0]];
                    let _e303 = paths.member[_e252.member_1[1]];
                    let _e310 = paths.member[_e252.member_1[2]];
                    let _e313 = paths.member[_e252.member_1[3]];
                    let _e350 = function_(array<f32, 3>(_e300.member[0], _e300.member[1], _e300.member[2]));
                    let _e351 = function_(array<f32, 3>(_e303.member[0], _e303.member[1], _e303.member[2]));
                    let _e352 = function_(array<f32, 3>(_e310.member[0], _e310.member[1], _e310.member[2]));
                    let _e353 = function_(array<f32, 3>(_e313.member[0], _e313.member[1], _e313.member[2]));
                    let _e355 = function_(array<f32, 3>(_e300.member_1[0], _e300.member_1[1], _e300.member_1[2]));
                    let _e356 = function_(array<f32, 3>(_e303.member_1[0], _e303.member_1[1], _e303.member_1[2]));
                    let _e357 = function_(array<f32, 3>(_e310.member_1[0], _e310.member_1[1], _e310.member_1[2]));
                    let _e358 = function_(array<f32, 3>(_e313.member_1[0], _e313.member_1[1], _e313.member_1[2]));
                    phi_823_ = type_31(array<array<f64, 3>, 4>(_e350, _e351, _e352, _e353), array<array<f64, 3>, 4>(_e355, _e356, _e357, _e358));
                } else {
                    let _e261 = positions.member[_e252.member_1[0]];
                    let _e264 = params.member.member.member[0u];
                    let _e267 = positions.member[(_e264 + _e252.member_1[0])];
                    let _e270 = positions.member[_e252.member_1[1]];
                    let _e273 = params.member.member.member[0u];
                    let _e276 = positions.member[(_e273 + _e252.member_1[1])];
                    let _e279 = positions.member[_e252.member_1[2]];
                    let _e282 = params.member.member.member[0u];
                    let _e285 = positions.member[(_e282 + _e252.member_1[2])];
                    let _e288 = positions.member[_e252.member_1[3]];
                    let _e291 = params.member.member.member[0u];
                    let _e294 = positions.member[(_e291 + _e252.member_1[3])];
                    phi_823_ = type_31(array<array<f64, 3>, 4>(_e261, _e270, _e279, _e288), array<array<f64, 3>, 4>(_e267, _e276, _e285, _e294));
                }
                let _e362 = phi_823_;
                if (_e252.member != 0u) {
                    phi_984_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e362.member[2][0] - _e362.member[0][0]), (_e362.member[2][1] - _e362.member[0][1]), (_e362.member[2][2] - _e362.member[0][2])), array<f64, 3>((_e362.member_1[2][0] - _e362.member_1[0][0]), (_e362.member_1[2][1] - _e362.member_1[0][1]), (_e362.member_1[2][2] - _e362.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e362.member[1][0] - _e362.member[0][0]), (_e362.member[1][1] - _e362.member[0][1]), (_e362.member[1][2] - _e362.member[0][2])), array<f64, 3>((_e362.member_1[1][0] - _e362.member_1[0][0]), (_e362.member_1[1][1] - _e362.member_1[0][1]), (_e362.member_1[1][2] - _e362.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e362.member[2][0] - _e362.member[3][0]), (_e362.member[2][1] - _e362.member[3][1]), (_e362.member[2][2] - _e362.member[3][2])), array<f64, 3>((_e362.member_1[2][0] - _e362.member_1[3][0]), (_e362.member_1[2][1] - _e362.member_1[3][1]), (_e362.member_1[2][2] - _e362.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_984_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e362.member[0][0] - _e362.member[1][0]), (_e362.member[0][1] - _e362.member[1][1]), (_e362.member[0][2] - _e362.member[1][2])), array<f64, 3>((_e362.member_1[0][0] - _e362.member_1[1][0]), (_e362.member_1[0][1] - _e362.member_1[1][1]), (_e362.member_1[0][2] - _e362.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e362.member[2][0] - _e362.member[1][0]), (_e362.member[2][1] - _e362.member[1][1]), (_e362.member[2][2] - _e362.member[1][2])), array<f64, 3>((_e362.member_1[2][0] - _e362.member_1[1][0]), (_e362.member_1[2][1] - _e362.member_1[1][1]), (_e362.member_1[2][2] - _e362.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e362.member[3][0] - _e362.member[1][0]), (_e362.member[3][1] - _e362.member[1][1]), (_e362.member[3][2] - _e362.member[1][2])), array<f64, 3>((_e362.member_1[3][0] - _e362.member_1[1][0]), (_e362.member_1[3][1] - _e362.member_1[1][1]), (_e362.member_1[3][2] - _e362.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e521 = phi_984_;
                let _e523 = params.member.member.member_7;
                let _e530 = bitcast<f64>(((u64(_e523[1]) * 4294967296lu) + u64(_e523[0])));
                let _e532 = params.member.member.member_14;
                let _e539 = bitcast<f64>(((u64(_e532[1]) * 4294967296lu) + u64(_e532[0])));
                let _e541 = params.member.member.member_15;
                let _e548 = bitcast<f64>(((u64(_e541[1]) * 4294967296lu) + u64(_e541[0])));
                let _e550 = params.member.member.member_16;
                let _e557 = bitcast<f64>(((u64(_e550[1]) * 4294967296lu) + u64(_e550[0])));
                let _e559 = params.member.member.member_1;
                if (_e521.member[0][0] < 0.0lf) {
                    phi_1032_ = -(_e521.member[0][0]);
                } else {
                    phi_1032_ = _e521.member[0][0];
                }
                let _e568 = phi_1032_;
                if (_e521.member[0][1] < 0.0lf) {
                    phi_1039_ = -(_e521.member[0][1]);
                } else {
                    phi_1039_ = _e521.member[0][1];
                }
                let _e573 = phi_1039_;
                if (_e568 > _e573) {
                    phi_1044_ = _e568;
                } else {
                    phi_1044_ = _e573;
                }
                let _e576 = phi_1044_;
                if (_e521.member[0][2] < 0.0lf) {
                    phi_1051_ = -(_e521.member[0][2]);
                } else {
                    phi_1051_ = _e521.member[0][2];
                }
                let _e581 = phi_1051_;
                if (_e576 > _e581) {
                    phi_1056_ = _e576;
                } else {
                    phi_1056_ = _e581;
                }
                let _e584 = phi_1056_;
                if (_e521.member[1][0] < 0.0lf) {
                    phi_1064_ = -(_e521.member[1][0]);
                } else {
                    phi_1064_ = _e521.member[1][0];
                }
                let _e591 = phi_1064_;
                if (_e521.member[1][1] < 0.0lf) {
                    phi_1071_ = -(_e521.member[1][1]);
                } else {
                    phi_1071_ = _e521.member[1][1];
                }
                let _e596 = phi_1071_;
                if (_e591 > _e596) {
                    phi_1076_ = _e591;
                } else {
                    phi_1076_ = _e596;
                }
                let _e599 = phi_1076_;
                if (_e521.member[1][2] < 0.0lf) {
                    phi_1083_ = -(_e521.member[1][2]);
                } else {
                    phi_1083_ = _e521.member[1][2];
                }
                let _e604 = phi_1083_;
                if (_e599 > _e604) {
                    phi_1088_ = _e599;
                } else {
                    phi_1088_ = _e604;
                }
                let _e607 = phi_1088_;
                if (_e584 > _e607) {
                    phi_1093_ = _e584;
                } else {
                    phi_1093_ = _e607;
                }
                let _e610 = phi_1093_;
                let _e612 = (_e610 + _e521.member_3);
                if (_e521.member_1[0][0] < 0.0lf) {
                    phi_1103_ = -(_e521.member_1[0][0]);
                } else {
                    phi_1103_ = _e521.member_1[0][0];
                }
                let _e619 = phi_1103_;
                if (_e521.member_1[0][1] < 0.0lf) {
                    phi_1110_ = -(_e521.member_1[0][1]);
                } else {
                    phi_1110_ = _e521.member_1[0][1];
                }
                let _e624 = phi_1110_;
                if (_e619 > _e624) {
                    phi_1115_ = _e619;
                } else {
                    phi_1115_ = _e624;
                }
                let _e627 = phi_1115_;
                if (_e521.member_1[0][2] < 0.0lf) {
                    phi_1122_ = -(_e521.member_1[0][2]);
                } else {
                    phi_1122_ = _e521.member_1[0][2];
                }
                let _e632 = phi_1122_;
                if (_e627 > _e632) {
                    phi_1127_ = _e627;
                } else {
                    phi_1127_ = _e632;
                }
                let _e635 = phi_1127_;
                if (_e521.member_1[1][0] < 0.0lf) {
                    phi_1135_ = -(_e521.member_1[1][0]);
                } else {
                    phi_1135_ = _e521.member_1[1][0];
                }
                let _e642 = phi_1135_;
                if (_e521.member_1[1][1] < 0.0lf) {
                    phi_1142_ = -(_e521.member_1[1][1]);
                } else {
                    phi_1142_ = _e521.member_1[1][1];
                }
                let _e647 = phi_1142_;
                if (_e642 > _e647) {
                    phi_1147_ = _e642;
                } else {
                    phi_1147_ = _e647;
                }
                let _e650 = phi_1147_;
                if (_e521.member_1[1][2] < 0.0lf) {
                    phi_1154_ = -(_e521.member_1[1][2]);
                } else {
                    phi_1154_ = _e521.member_1[1][2];
                }
                let _e655 = phi_1154_;
                if (_e650 > _e655) {
                    phi_1159_ = _e650;
                } else {
                    phi_1159_ = _e655;
                }
                let _e658 = phi_1159_;
                if (_e635 > _e658) {
                    phi_1164_ = _e635;
                } else {
                    phi_1164_ = _e658;
                }
                let _e661 = phi_1164_;
                let _e663 = (_e661 + _e521.member_3);
                if (_e521.member_2[0][0] < 0.0lf) {
                    phi_1174_ = -(_e521.member_2[0][0]);
                } else {
                    phi_1174_ = _e521.member_2[0][0];
                }
                let _e670 = phi_1174_;
                if (_e521.member_2[0][1] < 0.0lf) {
                    phi_1181_ = -(_e521.member_2[0][1]);
                } else {
                    phi_1181_ = _e521.member_2[0][1];
                }
                let _e675 = phi_1181_;
                if (_e670 > _e675) {
                    phi_1186_ = _e670;
                } else {
                    phi_1186_ = _e675;
                }
                let _e678 = phi_1186_;
                if (_e521.member_2[0][2] < 0.0lf) {
                    phi_1193_ = -(_e521.member_2[0][2]);
                } else {
                    phi_1193_ = _e521.member_2[0][2];
                }
                let _e683 = phi_1193_;
                if (_e678 > _e683) {
                    phi_1198_ = _e678;
                } else {
                    phi_1198_ = _e683;
                }
                let _e686 = phi_1198_;
                if (_e521.member_2[1][0] < 0.0lf) {
                    phi_1206_ = -(_e521.member_2[1][0]);
                } else {
                    phi_1206_ = _e521.member_2[1][0];
                }
                let _e693 = phi_1206_;
                if (_e521.member_2[1][1] < 0.0lf) {
                    phi_1213_ = -(_e521.member_2[1][1]);
                } else {
                    phi_1213_ = _e521.member_2[1][1];
                }
                let _e698 = phi_1213_;
                if (_e693 > _e698) {
                    phi_1218_ = _e693;
                } else {
                    phi_1218_ = _e698;
                }
                let _e701 = phi_1218_;
                if (_e521.member_2[1][2] < 0.0lf) {
                    phi_1225_ = -(_e521.member_2[1][2]);
                } else {
                    phi_1225_ = _e521.member_2[1][2];
                }
                let _e706 = phi_1225_;
                if (_e701 > _e706) {
                    phi_1230_ = _e701;
                } else {
                    phi_1230_ = _e706;
                }
                let _e709 = phi_1230_;
                if (_e686 > _e709) {
                    phi_1235_ = _e686;
                } else {
                    phi_1235_ = _e709;
                }
                let _e712 = phi_1235_;
                let _e714 = (_e712 + _e521.member_3);
                if (_e612 > _e663) {
                    phi_1242_ = _e612;
                } else {
                    phi_1242_ = _e663;
                }
                let _e717 = phi_1242_;
                if (_e717 > _e714) {
                    phi_1247_ = _e717;
                } else {
                    phi_1247_ = _e714;
                }
                let _e720 = phi_1247_;
                if (_e720 <= f64(65536f)) {
                    phi_1256_ = (_e720 >= f64((1f / 65536f)));
                } else {
                    phi_1256_ = false;
                }
                let _e727 = phi_1256_;
                if _e727 {
                    phi_1356_ = type_42();
                    phi_1357_ = true;
                } else {
                    if (_e720 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e720) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e734 = (9214364837600034816lu - (bitcast<u64>(_e720) & 9218868437227405312lu));
                            if (_e734 > 4503599627370496lu) {
                                phi_1280_ = _e734;
                            } else {
                                phi_1280_ = 4503599627370496lu;
                            }
                            let _e737 = phi_1280_;
                            let _e738 = bitcast<f64>(_e737);
                            let _e739 = (_e530 * _e738);
                            if (_e530 > f64(0f)) {
                                if (_e739 > 2.2250738585072014e-308lf) {
                                    phi_1292_ = _e739;
                                } else {
                                    phi_1292_ = 2.2250738585072014e-308lf;
                                }
                                let _e744 = phi_1292_;
                                phi_1293_ = _e744;
                            } else {
                                phi_1293_ = _e739;
                            }
                            let _e746 = phi_1293_;
                            phi_1352_ = type_42(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e521.member[0][0] * _e738), (_e521.member[0][1] * _e738), (_e521.member[0][2] * _e738)), array<f64, 3>((_e521.member[1][0] * _e738), (_e521.member[1][1] * _e738), (_e521.member[1][2] * _e738))), array<array<f64, 3>, 2>(array<f64, 3>((_e521.member_1[0][0] * _e738), (_e521.member_1[0][1] * _e738), (_e521.member_1[0][2] * _e738)), array<f64, 3>((_e521.member_1[1][0] * _e738), (_e521.member_1[1][1] * _e738), (_e521.member_1[1][2] * _e738))), array<array<f64, 3>, 2>(array<f64, 3>((_e521.member_2[0][0] * _e738), (_e521.member_2[0][1] * _e738), (_e521.member_2[0][2] * _e738)), array<f64, 3>((_e521.member_2[1][0] * _e738), (_e521.member_2[1][1] * _e738), (_e521.member_2[1][2] * _e738))), ((_e521.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e738)), _e746);
                            phi_1353_ = false;
                        } else {
                            phi_1352_ = type_42();
                            phi_1353_ = true;
                        }
                        let _e812 = phi_1352_;
                        let _e814 = phi_1353_;
                        phi_1354_ = _e812;
                        phi_1355_ = _e814;
                    } else {
                        phi_1354_ = type_42();
                        phi_1355_ = true;
                    }
                    let _e816 = phi_1354_;
                    let _e818 = phi_1355_;
                    phi_1356_ = _e816;
                    phi_1357_ = _e818;
                }
                let _e820 = phi_1356_;
                let _e822 = phi_1357_;
                if _e822 {
                    phi_1362_ = type_42(_e521, _e530);
                } else {
                    phi_1362_ = _e820;
                }
                let _e825 = phi_1362_;
                local_18 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e825.member.member[0][0], _e825.member.member[0][1], _e825.member.member[0][2]), array<f64, 3>(_e825.member.member[1][0], _e825.member.member[1][1], _e825.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e825.member.member_1[0][0], _e825.member.member_1[0][1], _e825.member.member_1[0][2]), array<f64, 3>(_e825.member.member_1[1][0], _e825.member.member_1[1][1], _e825.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e825.member.member_2[0][0], _e825.member.member_2[0][1], _e825.member.member_2[0][2]), array<f64, 3>(_e825.member.member_2[1][0], _e825.member.member_2[1][1], _e825.member.member_2[1][2])), _e825.member.member_3);
                if (_e825.member_1 > f64(0f)) {
                    let _e6151 = local_18.member[0u];
                    let _e6157 = local_18.member[1u];
                    let _e6173 = local_18.member_1[0u];
                    let _e6179 = local_18.member_1[1u];
                    let _e6195 = local_18.member_2[0u];
                    let _e6201 = local_18.member_2[1u];
                    let _e6215 = function_4(array<f64, 3>((_e6151[0] + ((_e6157[0] - _e6151[0]) * _e548)), (_e6151[1] + ((_e6157[1] - _e6151[1]) * _e548)), (_e6151[2] + ((_e6157[2] - _e6151[2]) * _e548))), array<f64, 3>((_e6173[0] + ((_e6179[0] - _e6173[0]) * _e548)), (_e6173[1] + ((_e6179[1] - _e6173[1]) * _e548)), (_e6173[2] + ((_e6179[2] - _e6173[2]) * _e548))), array<f64, 3>((_e6195[0] + ((_e6201[0] - _e6195[0]) * _e548)), (_e6195[1] + ((_e6201[1] - _e6195[1]) * _e548)), (_e6195[2] + ((_e6201[2] - _e6195[2]) * _e548))), _e252.member);
                    let _e6226 = (((_e6215[0] * _e6215[0]) + (_e6215[1] * _e6215[1])) + (_e6215[2] * _e6215[2]));
                    if (_e6226 <= 2.2250738585072014e-308lf) {
                        if (_e6226 > 0.0lf) {
                            phi_1530_ = (1.464336215552873e-154lf * 2.0lf);
                        } else {
                            phi_1530_ = 0.0lf;
                        }
                        let _e6278 = phi_1530_;
                        phi_1594_ = _e6278;
                    } else {
                        phi_1537_ = type_18(0i, 5i);
                        phi_1540_ = bitcast<f64>(((bitcast<u64>(_e6226) / 2lu) + 2303426169912950784lu));
                        loop {
                            let _e6233 = phi_1537_;
                            let _e6235 = phi_1540_;
                            local_40 = _e6235;
                            if (_e6233.member < _e6233.member_1) {
                                let _e6242 = (_e6233.member + 1i);
                                if ((false == (_e6242 > _e6233.member)) != false) {
                                    phi_1561_ = true;
                                } else {
                                    phi_1561_ = false;
                                }
                                let _e6247 = phi_1561_;
                                if _e6247 {
                                    phi_1567_ = type_19(0u, type_19().member_1);
                                } else {
                                    phi_1567_ = type_19(1u, _e6242);
                                }
                                let _e6252 = phi_1567_;
                                phi_1538_ = type_18(_e6252.member_1, _e6233.member_1);
                                phi_1581_ = type_19(1u, _e6233.member);
                            } else {
                                phi_1538_ = _e6233;
                                phi_1581_ = type_19(0u, type_19().member_1);
                            }
                            let _e6258 = phi_1538_;
                            let _e6260 = phi_1581_;
                            let _e6263 = (bitcast<i32>(_e6260.member) != 0i);
                            if _e6263 {
                                phi_1541_ = (0.5lf * (_e6235 + (_e6226 / _e6235)));
                            } else {
                                phi_1541_ = f64();
                            }
                            let _e6268 = phi_1541_;
                            continue;
                            continuing {
                                phi_1537_ = _e6258;
                                phi_1540_ = _e6268;
                                break if !(_e6263);
                            }
                        }
                        let _e6273 = local_40;
                        phi_1594_ = (_e6273 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                    }
                    let _e6280 = phi_1594_;
                    let _e6288 = local_18.member[0u];
                    if (_e6288[0] < 0.0lf) {
                        phi_1612_ = -(_e6288[0]);
                    } else {
                        phi_1612_ = _e6288[0];
                    }
                    let _e6295 = phi_1612_;
                    if (_e6288[1] < 0.0lf) {
                        phi_1619_ = -(_e6288[1]);
                    } else {
                        phi_1619_ = _e6288[1];
                    }
                    let _e6299 = phi_1619_;
                    if (_e6295 > _e6299) {
                        phi_1624_ = _e6295;
                    } else {
                        phi_1624_ = _e6299;
                    }
                    let _e6302 = phi_1624_;
                    if (_e6288[2] < 0.0lf) {
                        phi_1631_ = -(_e6288[2]);
                    } else {
                        phi_1631_ = _e6288[2];
                    }
                    let _e6306 = phi_1631_;
                    if (_e6302 > _e6306) {
                        phi_1636_ = _e6302;
                    } else {
                        phi_1636_ = _e6306;
                    }
                    let _e6309 = phi_1636_;
                    let _e6312 = local_18.member[1u];
                    if (_e6312[0] < 0.0lf) {
                        phi_1649_ = -(_e6312[0]);
                    } else {
                        phi_1649_ = _e6312[0];
                    }
                    let _e6319 = phi_1649_;
                    if (_e6312[1] < 0.0lf) {
                        phi_1656_ = -(_e6312[1]);
                    } else {
                        phi_1656_ = _e6312[1];
                    }
                    let _e6323 = phi_1656_;
                    if (_e6319 > _e6323) {
                        phi_1661_ = _e6319;
                    } else {
                        phi_1661_ = _e6323;
                    }
                    let _e6326 = phi_1661_;
                    if (_e6312[2] < 0.0lf) {
                        phi_1668_ = -(_e6312[2]);
                    } else {
                        phi_1668_ = _e6312[2];
                    }
                    let _e6330 = phi_1668_;
                    if (_e6326 > _e6330) {
                        phi_1673_ = _e6326;
                    } else {
                        phi_1673_ = _e6330;
                    }
                    let _e6333 = phi_1673_;
                    if (_e6309 > _e6333) {
                        phi_1678_ = _e6309;
                    } else {
                        phi_1678_ = _e6333;
                    }
                    let _e6336 = phi_1678_;
                    let _e6338 = local_18.member_3;
                    let _e6342 = local_18.member_1[0u];
                    if (_e6342[0] < 0.0lf) {
                        phi_1695_ = -(_e6342[0]);
                    } else {
                        phi_1695_ = _e6342[0];
                    }
                    let _e6349 = phi_1695_;
                    if (_e6342[1] < 0.0lf) {
                        phi_1702_ = -(_e6342[1]);
                    } else {
                        phi_1702_ = _e6342[1];
                    }
                    let _e6353 = phi_1702_;
                    if (_e6349 > _e6353) {
                        phi_1707_ = _e6349;
                    } else {
                        phi_1707_ = _e6353;
                    }
                    let _e6356 = phi_1707_;
                    if (_e6342[2] < 0.0lf) {
                        phi_1714_ = -(_e6342[2]);
                    } else {
                        phi_1714_ = _e6342[2];
                    }
                    let _e6360 = phi_1714_;
                    if (_e6356 > _e6360) {
                        phi_1719_ = _e6356;
                    } else {
                        phi_1719_ = _e6360;
                    }
                    let _e6363 = phi_1719_;
                    let _e6366 = local_18.member_1[1u];
                    if (_e6366[0] < 0.0lf) {
                        phi_1733_ = -(_e6366[0]);
                    } else {
                        phi_1733_ = _e6366[0];
                    }
                    let _e6373 = phi_1733_;
                    if (_e6366[1] < 0.0lf) {
                        phi_1740_ = -(_e6366[1]);
                    } else {
                        phi_1740_ = _e6366[1];
                    }
                    let _e6377 = phi_1740_;
                    if (_e6373 > _e6377) {
                        phi_1745_ = _e6373;
                    } else {
                        phi_1745_ = _e6377;
                    }
                    let _e6380 = phi_1745_;
                    if (_e6366[2] < 0.0lf) {
                        phi_1752_ = -(_e6366[2]);
                    } else {
                        phi_1752_ = _e6366[2];
                    }
                    let _e6384 = phi_1752_;
                    if (_e6380 > _e6384) {
                        phi_1757_ = _e6380;
                    } else {
                        phi_1757_ = _e6384;
                    }
                    let _e6387 = phi_1757_;
                    if (_e6363 > _e6387) {
                        phi_1762_ = _e6363;
                    } else {
                        phi_1762_ = _e6387;
                    }
                    let _e6390 = phi_1762_;
                    let _e6392 = local_18.member_3;
                    let _e6396 = local_18.member_2[0u];
                    if (_e6396[0] < 0.0lf) {
                        phi_1779_ = -(_e6396[0]);
                    } else {
                        phi_1779_ = _e6396[0];
                    }
                    let _e6403 = phi_1779_;
                    if (_e6396[1] < 0.0lf) {
                        phi_1786_ = -(_e6396[1]);
                    } else {
                        phi_1786_ = _e6396[1];
                    }
                    let _e6407 = phi_1786_;
                    if (_e6403 > _e6407) {
                        phi_1791_ = _e6403;
                    } else {
                        phi_1791_ = _e6407;
                    }
                    let _e6410 = phi_1791_;
                    if (_e6396[2] < 0.0lf) {
                        phi_1798_ = -(_e6396[2]);
                    } else {
                        phi_1798_ = _e6396[2];
                    }
                    let _e6414 = phi_1798_;
                    if (_e6410 > _e6414) {
                        phi_1803_ = _e6410;
                    } else {
                        phi_1803_ = _e6414;
                    }
                    let _e6417 = phi_1803_;
                    let _e6420 = local_18.member_2[1u];
                    if (_e6420[0] < 0.0lf) {
                        phi_1817_ = -(_e6420[0]);
                    } else {
                        phi_1817_ = _e6420[0];
                    }
                    let _e6427 = phi_1817_;
                    if (_e6420[1] < 0.0lf) {
                        phi_1824_ = -(_e6420[1]);
                    } else {
                        phi_1824_ = _e6420[1];
                    }
                    let _e6431 = phi_1824_;
                    if (_e6427 > _e6431) {
                        phi_1829_ = _e6427;
                    } else {
                        phi_1829_ = _e6431;
                    }
                    let _e6434 = phi_1829_;
                    if (_e6420[2] < 0.0lf) {
                        phi_1836_ = -(_e6420[2]);
                    } else {
                        phi_1836_ = _e6420[2];
                    }
                    let _e6438 = phi_1836_;
                    if (_e6434 > _e6438) {
                        phi_1841_ = _e6434;
                    } else {
                        phi_1841_ = _e6438;
                    }
                    let _e6441 = phi_1841_;
                    if (_e6417 > _e6441) {
                        phi_1846_ = _e6417;
                    } else {
                        phi_1846_ = _e6441;
                    }
                    let _e6444 = phi_1846_;
                    let _e6446 = local_18.member_3;
                    let _e6454 = local_18.member_3;
                    let _e6464 = (((_e6280 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e6336 + _e6338) + (_e6390 + _e6392)) + (_e6444 + _e6446)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6454 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e825.member_1);
                    if _e6464 {
                        phi_2523_ = type_44();
                        phi_2524_ = true;
                    } else {
                        let _e6467 = local_18.member_1[0u];
                        let _e6473 = local_18.member_2[0u];
                        let _e6479 = ((_e6467[1] * _e6473[2]) - (_e6467[2] * _e6473[1]));
                        let _e6482 = ((_e6467[2] * _e6473[0]) - (_e6467[0] * _e6473[2]));
                        let _e6485 = ((_e6467[0] * _e6473[1]) - (_e6467[1] * _e6473[0]));
                        let _e6488 = local_18.member_1[1u];
                        let _e6494 = local_18.member_2[1u];
                        let _e6500 = ((_e6488[1] * _e6494[2]) - (_e6488[2] * _e6494[1]));
                        let _e6503 = ((_e6488[2] * _e6494[0]) - (_e6488[0] * _e6494[2]));
                        let _e6506 = ((_e6488[0] * _e6494[1]) - (_e6488[1] * _e6494[0]));
                        let _e6509 = local_18.member_1[0u];
                        let _e6515 = local_18.member_2[1u];
                        let _e6530 = local_18.member_1[1u];
                        let _e6536 = local_18.member_2[0u];
                        let _e6549 = (((_e6509[1] * _e6515[2]) - (_e6509[2] * _e6515[1])) + ((_e6530[1] * _e6536[2]) - (_e6530[2] * _e6536[1])));
                        let _e6550 = (((_e6509[2] * _e6515[0]) - (_e6509[0] * _e6515[2])) + ((_e6530[2] * _e6536[0]) - (_e6530[0] * _e6536[2])));
                        let _e6551 = (((_e6509[0] * _e6515[1]) - (_e6509[1] * _e6515[0])) + ((_e6530[0] * _e6536[1]) - (_e6530[1] * _e6536[0])));
                        let _e6554 = local_18.member[0u];
                        let _e6565 = local_18.member[1u];
                        let _e6576 = local_18.member[0u];
                        let _e6585 = ((((_e6565[0] * _e6479) + (_e6565[1] * _e6482)) + (_e6565[2] * _e6485)) + (((_e6576[0] * _e6549) + (_e6576[1] * _e6550)) + (_e6576[2] * _e6551)));
                        let _e6588 = local_18.member[0u];
                        let _e6599 = local_18.member[1u];
                        let _e6608 = ((((_e6588[0] * _e6500) + (_e6588[1] * _e6503)) + (_e6588[2] * _e6506)) + (((_e6599[0] * _e6549) + (_e6599[1] * _e6550)) + (_e6599[2] * _e6551)));
                        let _e6611 = local_18.member[1u];
                        let _e6622 = local_18.member[0u];
                        if (_e6622[0] < 0.0lf) {
                            phi_2111_ = -(_e6622[0]);
                        } else {
                            phi_2111_ = _e6622[0];
                        }
                        let _e6629 = phi_2111_;
                        if (_e6622[1] < 0.0lf) {
                            phi_2118_ = -(_e6622[1]);
                        } else {
                            phi_2118_ = _e6622[1];
                        }
                        let _e6633 = phi_2118_;
                        if (_e6629 > _e6633) {
                            phi_2123_ = _e6629;
                        } else {
                            phi_2123_ = _e6633;
                        }
                        let _e6636 = phi_2123_;
                        if (_e6622[2] < 0.0lf) {
                            phi_2130_ = -(_e6622[2]);
                        } else {
                            phi_2130_ = _e6622[2];
                        }
                        let _e6640 = phi_2130_;
                        if (_e6636 > _e6640) {
                            phi_2135_ = _e6636;
                        } else {
                            phi_2135_ = _e6640;
                        }
                        let _e6643 = phi_2135_;
                        let _e6646 = local_18.member[1u];
                        if (_e6646[0] < 0.0lf) {
                            phi_2148_ = -(_e6646[0]);
                        } else {
                            phi_2148_ = _e6646[0];
                        }
                        let _e6653 = phi_2148_;
                        if (_e6646[1] < 0.0lf) {
                            phi_2155_ = -(_e6646[1]);
                        } else {
                            phi_2155_ = _e6646[1];
                        }
                        let _e6657 = phi_2155_;
                        if (_e6653 > _e6657) {
                            phi_2160_ = _e6653;
                        } else {
                            phi_2160_ = _e6657;
                        }
                        let _e6660 = phi_2160_;
                        if (_e6646[2] < 0.0lf) {
                            phi_2167_ = -(_e6646[2]);
                        } else {
                            phi_2167_ = _e6646[2];
                        }
                        let _e6664 = phi_2167_;
                        if (_e6660 > _e6664) {
                            phi_2172_ = _e6660;
                        } else {
                            phi_2172_ = _e6664;
                        }
                        let _e6667 = phi_2172_;
                        if (_e6643 > _e6667) {
                            phi_2177_ = _e6643;
                        } else {
                            phi_2177_ = _e6667;
                        }
                        let _e6670 = phi_2177_;
                        let _e6672 = local_18.member_3;
                        let _e6673 = (_e6670 + _e6672);
                        let _e6676 = local_18.member_1[0u];
                        if (_e6676[0] < 0.0lf) {
                            phi_2194_ = -(_e6676[0]);
                        } else {
                            phi_2194_ = _e6676[0];
                        }
                        let _e6683 = phi_2194_;
                        if (_e6676[1] < 0.0lf) {
                            phi_2201_ = -(_e6676[1]);
                        } else {
                            phi_2201_ = _e6676[1];
                        }
                        let _e6687 = phi_2201_;
                        if (_e6683 > _e6687) {
                            phi_2206_ = _e6683;
                        } else {
                            phi_2206_ = _e6687;
                        }
                        let _e6690 = phi_2206_;
                        if (_e6676[2] < 0.0lf) {
                            phi_2213_ = -(_e6676[2]);
                        } else {
                            phi_2213_ = _e6676[2];
                        }
                        let _e6694 = phi_2213_;
                        if (_e6690 > _e6694) {
                            phi_2218_ = _e6690;
                        } else {
                            phi_2218_ = _e6694;
                        }
                        let _e6697 = phi_2218_;
                        let _e6700 = local_18.member_1[1u];
                        if (_e6700[0] < 0.0lf) {
                            phi_2232_ = -(_e6700[0]);
                        } else {
                            phi_2232_ = _e6700[0];
                        }
                        let _e6707 = phi_2232_;
                        if (_e6700[1] < 0.0lf) {
                            phi_2239_ = -(_e6700[1]);
                        } else {
                            phi_2239_ = _e6700[1];
                        }
                        let _e6711 = phi_2239_;
                        if (_e6707 > _e6711) {
                            phi_2244_ = _e6707;
                        } else {
                            phi_2244_ = _e6711;
                        }
                        let _e6714 = phi_2244_;
                        if (_e6700[2] < 0.0lf) {
                            phi_2251_ = -(_e6700[2]);
                        } else {
                            phi_2251_ = _e6700[2];
                        }
                        let _e6718 = phi_2251_;
                        if (_e6714 > _e6718) {
                            phi_2256_ = _e6714;
                        } else {
                            phi_2256_ = _e6718;
                        }
                        let _e6721 = phi_2256_;
                        if (_e6697 > _e6721) {
                            phi_2261_ = _e6697;
                        } else {
                            phi_2261_ = _e6721;
                        }
                        let _e6724 = phi_2261_;
                        let _e6726 = local_18.member_3;
                        let _e6727 = (_e6724 + _e6726);
                        let _e6730 = local_18.member_2[0u];
                        if (_e6730[0] < 0.0lf) {
                            phi_2278_ = -(_e6730[0]);
                        } else {
                            phi_2278_ = _e6730[0];
                        }
                        let _e6737 = phi_2278_;
                        if (_e6730[1] < 0.0lf) {
                            phi_2285_ = -(_e6730[1]);
                        } else {
                            phi_2285_ = _e6730[1];
                        }
                        let _e6741 = phi_2285_;
                        if (_e6737 > _e6741) {
                            phi_2290_ = _e6737;
                        } else {
                            phi_2290_ = _e6741;
                        }
                        let _e6744 = phi_2290_;
                        if (_e6730[2] < 0.0lf) {
                            phi_2297_ = -(_e6730[2]);
                        } else {
                            phi_2297_ = _e6730[2];
                        }
                        let _e6748 = phi_2297_;
                        if (_e6744 > _e6748) {
                            phi_2302_ = _e6744;
                        } else {
                            phi_2302_ = _e6748;
                        }
                        let _e6751 = phi_2302_;
                        let _e6754 = local_18.member_2[1u];
                        if (_e6754[0] < 0.0lf) {
                            phi_2316_ = -(_e6754[0]);
                        } else {
                            phi_2316_ = _e6754[0];
                        }
                        let _e6761 = phi_2316_;
                        if (_e6754[1] < 0.0lf) {
                            phi_2323_ = -(_e6754[1]);
                        } else {
                            phi_2323_ = _e6754[1];
                        }
                        let _e6765 = phi_2323_;
                        if (_e6761 > _e6765) {
                            phi_2328_ = _e6761;
                        } else {
                            phi_2328_ = _e6765;
                        }
                        let _e6768 = phi_2328_;
                        if (_e6754[2] < 0.0lf) {
                            phi_2335_ = -(_e6754[2]);
                        } else {
                            phi_2335_ = _e6754[2];
                        }
                        let _e6772 = phi_2335_;
                        if (_e6768 > _e6772) {
                            phi_2340_ = _e6768;
                        } else {
                            phi_2340_ = _e6772;
                        }
                        let _e6775 = phi_2340_;
                        if (_e6751 > _e6775) {
                            phi_2345_ = _e6751;
                        } else {
                            phi_2345_ = _e6775;
                        }
                        let _e6778 = phi_2345_;
                        let _e6780 = local_18.member_3;
                        let _e6781 = (_e6778 + _e6780);
                        let _e6782 = f64(1f);
                        let _e6783 = f64(8f);
                        let _e6785 = ((_e6727 * _e6783) * _e6781);
                        let _e6793 = local_18.member_3;
                        if (_e6479 < 0.0lf) {
                            phi_2382_ = -(_e6479);
                        } else {
                            phi_2382_ = _e6479;
                        }
                        let _e6813 = phi_2382_;
                        if (_e6482 < 0.0lf) {
                            phi_2388_ = -(_e6482);
                        } else {
                            phi_2388_ = _e6482;
                        }
                        let _e6817 = phi_2388_;
                        if (_e6485 < 0.0lf) {
                            phi_2395_ = -(_e6485);
                        } else {
                            phi_2395_ = _e6485;
                        }
                        let _e6822 = phi_2395_;
                        let _e6823 = ((_e6813 + _e6817) + _e6822);
                        if (_e6500 < 0.0lf) {
                            phi_2402_ = -(_e6500);
                        } else {
                            phi_2402_ = _e6500;
                        }
                        let _e6827 = phi_2402_;
                        if (_e6503 < 0.0lf) {
                            phi_2408_ = -(_e6503);
                        } else {
                            phi_2408_ = _e6503;
                        }
                        let _e6831 = phi_2408_;
                        if (_e6506 < 0.0lf) {
                            phi_2415_ = -(_e6506);
                        } else {
                            phi_2415_ = _e6506;
                        }
                        let _e6836 = phi_2415_;
                        let _e6837 = ((_e6827 + _e6831) + _e6836);
                        if (_e6823 > _e6837) {
                            phi_2421_ = _e6823;
                        } else {
                            phi_2421_ = _e6837;
                        }
                        let _e6840 = phi_2421_;
                        if (_e6549 < 0.0lf) {
                            phi_2427_ = -(_e6549);
                        } else {
                            phi_2427_ = _e6549;
                        }
                        let _e6844 = phi_2427_;
                        if (_e6550 < 0.0lf) {
                            phi_2433_ = -(_e6550);
                        } else {
                            phi_2433_ = _e6550;
                        }
                        let _e6848 = phi_2433_;
                        if (_e6551 < 0.0lf) {
                            phi_2440_ = -(_e6551);
                        } else {
                            phi_2440_ = _e6551;
                        }
                        let _e6853 = phi_2440_;
                        let _e6855 = (((_e6844 + _e6848) + _e6853) * f64(0.5f));
                        if (_e6840 > _e6855) {
                            phi_2447_ = _e6840;
                        } else {
                            phi_2447_ = _e6855;
                        }
                        let _e6858 = phi_2447_;
                        let _e6864 = local_18.member_3;
                        let _e6879 = f64(3f);
                        let _e6880 = ((((_e6554[0] * _e6479) + (_e6554[1] * _e6482)) + (_e6554[2] * _e6485)) * _e6879);
                        let _e6881 = ((((_e6611[0] * _e6500) + (_e6611[1] * _e6503)) + (_e6611[2] * _e6506)) * _e6879);
                        if (_e6880 < _e6881) {
                            phi_2475_ = _e6880;
                        } else {
                            phi_2475_ = _e6881;
                        }
                        let _e6884 = phi_2475_;
                        if (_e6585 < _e6608) {
                            phi_2480_ = _e6585;
                        } else {
                            phi_2480_ = _e6608;
                        }
                        let _e6887 = phi_2480_;
                        if (_e6884 < _e6887) {
                            phi_2485_ = _e6884;
                        } else {
                            phi_2485_ = _e6887;
                        }
                        let _e6890 = phi_2485_;
                        if (_e6880 > _e6881) {
                            phi_2490_ = _e6880;
                        } else {
                            phi_2490_ = _e6881;
                        }
                        let _e6893 = phi_2490_;
                        if (_e6585 > _e6608) {
                            phi_2495_ = _e6585;
                        } else {
                            phi_2495_ = _e6608;
                        }
                        let _e6896 = phi_2495_;
                        if (_e6893 > _e6896) {
                            phi_2500_ = _e6893;
                        } else {
                            phi_2500_ = _e6896;
                        }
                        let _e6899 = phi_2500_;
                        let _e6905 = -(_e6899);
                        if (_e6890 > _e6905) {
                            phi_2511_ = _e6890;
                        } else {
                            phi_2511_ = _e6905;
                        }
                        let _e6908 = phi_2511_;
                        if ((_e6908 - ((((((_e6673 * _e6783) * _e6785) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e6793 * f64(19f)) * ((_e6673 * (_e6727 + _e6781)) + (_e6727 * _e6781)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6782 + _e6673) * ((_e6782 + _e6727) * (_e6782 + _e6781))))) + ((_e825.member_1 * (((_e6858 + (_e6785 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e6864 * f64(6f)) * (_e6727 + _e6781))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6782 + _e6727) * (_e6782 + _e6781))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                            phi_2521_ = type_44(type_43(0u, f64()), 0u);
                            phi_2522_ = false;
                        } else {
                            phi_2521_ = type_44();
                            phi_2522_ = true;
                        }
                        let _e6915 = phi_2521_;
                        let _e6917 = phi_2522_;
                        phi_2523_ = _e6915;
                        phi_2524_ = _e6917;
                    }
                    let _e6919 = phi_2523_;
                    let _e6921 = phi_2524_;
                    if _e6921 {
                        phi_2530_ = type_18(0i, 2i);
                        phi_2533_ = _e548;
                        phi_2535_ = 0u;
                        phi_2537_ = _e548;
                        loop {
                            let _e6923 = phi_2530_;
                            let _e6925 = phi_2533_;
                            let _e6927 = phi_2535_;
                            let _e6929 = phi_2537_;
                            local_99 = _e6927;
                            local_102 = _e6925;
                            local_103 = _e6927;
                            if (_e6923.member < _e6923.member_1) {
                                let _e6936 = (_e6923.member + 1i);
                                if ((false == (_e6936 > _e6923.member)) != false) {
                                    phi_2558_ = true;
                                } else {
                                    phi_2558_ = false;
                                }
                                let _e6941 = phi_2558_;
                                if _e6941 {
                                    phi_2564_ = type_19(0u, type_19().member_1);
                                } else {
                                    phi_2564_ = type_19(1u, _e6936);
                                }
                                let _e6946 = phi_2564_;
                                phi_2531_ = type_18(_e6946.member_1, _e6923.member_1);
                                phi_2578_ = type_19(1u, _e6923.member);
                            } else {
                                phi_2531_ = _e6923;
                                phi_2578_ = type_19(0u, type_19().member_1);
                            }
                            let _e6952 = phi_2531_;
                            let _e6954 = phi_2578_;
                            if (bitcast<i32>(_e6954.member) != 0i) {
                                if (_e6954.member_1 > 0i) {
                                    phi_2594_ = true;
                                } else {
                                    if _e6464 {
                                        phi_2593_ = false;
                                    } else {
                                        phi_2593_ = true;
                                    }
                                    let _e6961 = phi_2593_;
                                    phi_2594_ = _e6961;
                                }
                                let _e6963 = phi_2594_;
                                if _e6963 {
                                    let _e6966 = local_18.member[0u];
                                    let _e6973 = local_18.member_1[0u];
                                    let _e6979 = local_18.member_2[0u];
                                    let _e6983 = (_e6966[0] - _e6973[0]);
                                    let _e6984 = (_e6966[1] - _e6973[1]);
                                    let _e6985 = (_e6966[2] - _e6973[2]);
                                    if (_e252.member == 0u) {
                                        phi_2653_ = array<f64, 3>(_e6966[0], _e6966[1], _e6966[2]);
                                    } else {
                                        phi_2653_ = array<f64, 3>((_e6983 - _e6979[0]), (_e6984 - _e6979[1]), (_e6985 - _e6979[2]));
                                    }
                                    let _e6992 = phi_2653_;
                                    let _e6998 = local_18.member[1u];
                                    let _e7005 = local_18.member_1[1u];
                                    let _e7011 = local_18.member_2[1u];
                                    let _e7015 = (_e6998[0] - _e7005[0]);
                                    let _e7016 = (_e6998[1] - _e7005[1]);
                                    let _e7017 = (_e6998[2] - _e7005[2]);
                                    if (_e252.member == 0u) {
                                        phi_2718_ = array<f64, 3>(_e6998[0], _e6998[1], _e6998[2]);
                                    } else {
                                        phi_2718_ = array<f64, 3>((_e7015 - _e7011[0]), (_e7016 - _e7011[1]), (_e7017 - _e7011[2]));
                                    }
                                    let _e7024 = phi_2718_;
                                    let _e7030 = local_18.member[0u];
                                    if (_e7030[0] < 0.0lf) {
                                        phi_2740_ = -(_e7030[0]);
                                    } else {
                                        phi_2740_ = _e7030[0];
                                    }
                                    let _e7037 = phi_2740_;
                                    if (_e7030[1] < 0.0lf) {
                                        phi_2747_ = -(_e7030[1]);
                                    } else {
                                        phi_2747_ = _e7030[1];
                                    }
                                    let _e7041 = phi_2747_;
                                    if (_e7037 > _e7041) {
                                        phi_2752_ = _e7037;
                                    } else {
                                        phi_2752_ = _e7041;
                                    }
                                    let _e7044 = phi_2752_;
                                    if (_e7030[2] < 0.0lf) {
                                        phi_2759_ = -(_e7030[2]);
                                    } else {
                                        phi_2759_ = _e7030[2];
                                    }
                                    let _e7048 = phi_2759_;
                                    if (_e7044 > _e7048) {
                                        phi_2764_ = _e7044;
                                    } else {
                                        phi_2764_ = _e7048;
                                    }
                                    let _e7051 = phi_2764_;
                                    let _e7054 = local_18.member[1u];
                                    if (_e7054[0] < 0.0lf) {
                                        phi_2777_ = -(_e7054[0]);
                                    } else {
                                        phi_2777_ = _e7054[0];
                                    }
                                    let _e7061 = phi_2777_;
                                    if (_e7054[1] < 0.0lf) {
                                        phi_2784_ = -(_e7054[1]);
                                    } else {
                                        phi_2784_ = _e7054[1];
                                    }
                                    let _e7065 = phi_2784_;
                                    if (_e7061 > _e7065) {
                                        phi_2789_ = _e7061;
                                    } else {
                                        phi_2789_ = _e7065;
                                    }
                                    let _e7068 = phi_2789_;
                                    if (_e7054[2] < 0.0lf) {
                                        phi_2796_ = -(_e7054[2]);
                                    } else {
                                        phi_2796_ = _e7054[2];
                                    }
                                    let _e7072 = phi_2796_;
                                    if (_e7068 > _e7072) {
                                        phi_2801_ = _e7068;
                                    } else {
                                        phi_2801_ = _e7072;
                                    }
                                    let _e7075 = phi_2801_;
                                    if (_e7051 > _e7075) {
                                        phi_2806_ = _e7051;
                                    } else {
                                        phi_2806_ = _e7075;
                                    }
                                    let _e7078 = phi_2806_;
                                    let _e7080 = local_18.member_3;
                                    let _e7084 = local_18.member_1[0u];
                                    if (_e7084[0] < 0.0lf) {
                                        phi_2823_ = -(_e7084[0]);
                                    } else {
                                        phi_2823_ = _e7084[0];
                                    }
                                    let _e7091 = phi_2823_;
                                    if (_e7084[1] < 0.0lf) {
                                        phi_2830_ = -(_e7084[1]);
                                    } else {
                                        phi_2830_ = _e7084[1];
                                    }
                                    let _e7095 = phi_2830_;
                                    if (_e7091 > _e7095) {
                                        phi_2835_ = _e7091;
                                    } else {
                                        phi_2835_ = _e7095;
                                    }
                                    let _e7098 = phi_2835_;
                                    if (_e7084[2] < 0.0lf) {
                                        phi_2842_ = -(_e7084[2]);
                                    } else {
                                        phi_2842_ = _e7084[2];
                                    }
                                    let _e7102 = phi_2842_;
                                    if (_e7098 > _e7102) {
                                        phi_2847_ = _e7098;
                                    } else {
                                        phi_2847_ = _e7102;
                                    }
                                    let _e7105 = phi_2847_;
                                    let _e7108 = local_18.member_1[1u];
                                    if (_e7108[0] < 0.0lf) {
                                        phi_2861_ = -(_e7108[0]);
                                    } else {
                                        phi_2861_ = _e7108[0];
                                    }
                                    let _e7115 = phi_2861_;
                                    if (_e7108[1] < 0.0lf) {
                                        phi_2868_ = -(_e7108[1]);
                                    } else {
                                        phi_2868_ = _e7108[1];
                                    }
                                    let _e7119 = phi_2868_;
                                    if (_e7115 > _e7119) {
                                        phi_2873_ = _e7115;
                                    } else {
                                        phi_2873_ = _e7119;
                                    }
                                    let _e7122 = phi_2873_;
                                    if (_e7108[2] < 0.0lf) {
                                        phi_2880_ = -(_e7108[2]);
                                    } else {
                                        phi_2880_ = _e7108[2];
                                    }
                                    let _e7126 = phi_2880_;
                                    if (_e7122 > _e7126) {
                                        phi_2885_ = _e7122;
                                    } else {
                                        phi_2885_ = _e7126;
                                    }
                                    let _e7129 = phi_2885_;
                                    if (_e7105 > _e7129) {
                                        phi_2890_ = _e7105;
                                    } else {
                                        phi_2890_ = _e7129;
                                    }
                                    let _e7132 = phi_2890_;
                                    let _e7134 = local_18.member_3;
                                    let _e7138 = local_18.member_2[0u];
                                    if (_e7138[0] < 0.0lf) {
                                        phi_2907_ = -(_e7138[0]);
                                    } else {
                                        phi_2907_ = _e7138[0];
                                    }
                                    let _e7145 = phi_2907_;
                                    if (_e7138[1] < 0.0lf) {
                                        phi_2914_ = -(_e7138[1]);
                                    } else {
                                        phi_2914_ = _e7138[1];
                                    }
                                    let _e7149 = phi_2914_;
                                    if (_e7145 > _e7149) {
                                        phi_2919_ = _e7145;
                                    } else {
                                        phi_2919_ = _e7149;
                                    }
                                    let _e7152 = phi_2919_;
                                    if (_e7138[2] < 0.0lf) {
                                        phi_2926_ = -(_e7138[2]);
                                    } else {
                                        phi_2926_ = _e7138[2];
                                    }
                                    let _e7156 = phi_2926_;
                                    if (_e7152 > _e7156) {
                                        phi_2931_ = _e7152;
                                    } else {
                                        phi_2931_ = _e7156;
                                    }
                                    let _e7159 = phi_2931_;
                                    let _e7162 = local_18.member_2[1u];
                                    if (_e7162[0] < 0.0lf) {
                                        phi_2945_ = -(_e7162[0]);
                                    } else {
                                        phi_2945_ = _e7162[0];
                                    }
                                    let _e7169 = phi_2945_;
                                    if (_e7162[1] < 0.0lf) {
                                        phi_2952_ = -(_e7162[1]);
                                    } else {
                                        phi_2952_ = _e7162[1];
                                    }
                                    let _e7173 = phi_2952_;
                                    if (_e7169 > _e7173) {
                                        phi_2957_ = _e7169;
                                    } else {
                                        phi_2957_ = _e7173;
                                    }
                                    let _e7176 = phi_2957_;
                                    if (_e7162[2] < 0.0lf) {
                                        phi_2964_ = -(_e7162[2]);
                                    } else {
                                        phi_2964_ = _e7162[2];
                                    }
                                    let _e7180 = phi_2964_;
                                    if (_e7176 > _e7180) {
                                        phi_2969_ = _e7176;
                                    } else {
                                        phi_2969_ = _e7180;
                                    }
                                    let _e7183 = phi_2969_;
                                    if (_e7159 > _e7183) {
                                        phi_2974_ = _e7159;
                                    } else {
                                        phi_2974_ = _e7183;
                                    }
                                    let _e7186 = phi_2974_;
                                    let _e7188 = local_18.member_3;
                                    let _e7196 = local_18.member_3;
                                    let _e7204 = (_e539 * f64(0.00390625f));
                                    let _e7205 = f64(0f);
                                    let _e7206 = f64(1f);
                                    local_16 = type_35(array<f64, 4>(_e7205, _e7205, _e7205, _e7205), array<f64, 4>(_e7205, _e7205, _e7205, _e7205), array<f64, 4>(_e7206, _e7206, _e7206, _e7206));
                                    phi_3021_ = type_9(0u, 96u);
                                    phi_3024_ = _e6929;
                                    phi_3026_ = _e6929;
                                    phi_3028_ = (_e557 - _e6929);
                                    phi_3030_ = _e6929;
                                    phi_3032_ = false;
                                    phi_3034_ = 0u;
                                    loop {
                                        let _e7213 = phi_3021_;
                                        let _e7215 = phi_3024_;
                                        let _e7217 = phi_3026_;
                                        let _e7219 = phi_3028_;
                                        let _e7221 = phi_3030_;
                                        let _e7223 = phi_3032_;
                                        let _e7225 = phi_3034_;
                                        local_44 = _e7215;
                                        local_89 = _e7217;
                                        if (_e7213.member < _e7213.member_1) {
                                            phi_3022_ = type_9((_e7213.member + 1u), _e7213.member_1);
                                            phi_3057_ = type_9(1u, _e7213.member);
                                        } else {
                                            phi_3022_ = _e7213;
                                            phi_3057_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e7237 = phi_3022_;
                                        let _e7239 = phi_3057_;
                                        if (bitcast<i32>(_e7239.member) != 0i) {
                                            let _e7245 = local_18.member[0u];
                                            let _e7251 = local_18.member[1u];
                                            let _e7267 = local_18.member_1[0u];
                                            let _e7273 = local_18.member_1[1u];
                                            let _e7289 = local_18.member_2[0u];
                                            let _e7295 = local_18.member_2[1u];
                                            let _e7309 = function_4(array<f64, 3>((_e7245[0] + ((_e7251[0] - _e7245[0]) * _e7215)), (_e7245[1] + ((_e7251[1] - _e7245[1]) * _e7215)), (_e7245[2] + ((_e7251[2] - _e7245[2]) * _e7215))), array<f64, 3>((_e7267[0] + ((_e7273[0] - _e7267[0]) * _e7215)), (_e7267[1] + ((_e7273[1] - _e7267[1]) * _e7215)), (_e7267[2] + ((_e7273[2] - _e7267[2]) * _e7215))), array<f64, 3>((_e7289[0] + ((_e7295[0] - _e7289[0]) * _e7215)), (_e7289[1] + ((_e7295[1] - _e7289[1]) * _e7215)), (_e7289[2] + ((_e7295[2] - _e7289[2]) * _e7215))), _e252.member);
                                            if (_e7225 == 0u) {
                                                phi_3186_ = _e7309;
                                            } else {
                                                let _e7311 = f64(0f);
                                                if (_e7225 == 1u) {
                                                    phi_3172_ = _e7309[0];
                                                } else {
                                                    phi_3172_ = _e7311;
                                                }
                                                let _e7315 = phi_3172_;
                                                if (_e7225 == 2u) {
                                                    phi_3178_ = _e7309[1];
                                                } else {
                                                    phi_3178_ = _e7311;
                                                }
                                                let _e7319 = phi_3178_;
                                                if (_e7225 == 3u) {
                                                    phi_3184_ = _e7309[2];
                                                } else {
                                                    phi_3184_ = _e7311;
                                                }
                                                let _e7323 = phi_3184_;
                                                phi_3186_ = array<f64, 3>(_e7315, _e7319, _e7323);
                                            }
                                            let _e7326 = phi_3186_;
                                            if (_e7326[0] < 0.0lf) {
                                                phi_3193_ = -(_e7326[0]);
                                            } else {
                                                phi_3193_ = _e7326[0];
                                            }
                                            let _e7331 = phi_3193_;
                                            if (_e7326[1] < 0.0lf) {
                                                phi_3200_ = -(_e7326[1]);
                                            } else {
                                                phi_3200_ = _e7326[1];
                                            }
                                            let _e7336 = phi_3200_;
                                            if (_e7326[2] < 0.0lf) {
                                                phi_3208_ = -(_e7326[2]);
                                            } else {
                                                phi_3208_ = _e7326[2];
                                            }
                                            let _e7342 = phi_3208_;
                                            let _e7343 = ((_e7331 + _e7336) + _e7342);
                                            if (_e7343 > f64(0f)) {
                                                if ((bitcast<u64>(_e7343) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                    let _e7350 = (f64(1f) / _e7343);
                                                    let _e7352 = (_e7326[0] * _e7350);
                                                    let _e7354 = (_e7326[1] * _e7350);
                                                    let _e7356 = (_e7326[2] * _e7350);
                                                    let _e7361 = (((_e7352 * _e7352) + (_e7354 * _e7354)) + (_e7356 * _e7356));
                                                    if (_e7361 <= 2.2250738585072014e-308lf) {
                                                        if (_e7361 > 0.0lf) {
                                                            phi_3247_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_3247_ = 0.0lf;
                                                        }
                                                        let _e7413 = phi_3247_;
                                                        phi_3311_ = _e7413;
                                                    } else {
                                                        phi_3254_ = type_18(0i, 5i);
                                                        phi_3257_ = bitcast<f64>(((bitcast<u64>(_e7361) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e7368 = phi_3254_;
                                                            let _e7370 = phi_3257_;
                                                            local_41 = _e7370;
                                                            if (_e7368.member < _e7368.member_1) {
                                                                let _e7377 = (_e7368.member + 1i);
                                                                if ((false == (_e7377 > _e7368.member)) != false) {
                                                                    phi_3278_ = true;
                                                                } else {
                                                                    phi_3278_ = false;
                                                                }
                                                                let _e7382 = phi_3278_;
                                                                if _e7382 {
                                                                    phi_3284_ = type_19(0u, type_19().member_1);
                                                                } else {
                                                                    phi_3284_ = type_19(1u, _e7377);
                                                                }
                                                                let _e7387 = phi_3284_;
                                                                phi_3255_ = type_18(_e7387.member_1, _e7368.member_1);
                                                                phi_3298_ = type_19(1u, _e7368.member);
                                                            } else {
                                                                phi_3255_ = _e7368;
                                                                phi_3298_ = type_19(0u, type_19().member_1);
                                                            }
                                                            let _e7393 = phi_3255_;
                                                            let _e7395 = phi_3298_;
                                                            let _e7398 = (bitcast<i32>(_e7395.member) != 0i);
                                                            if _e7398 {
                                                                phi_3258_ = (0.5lf * (_e7370 + (_e7361 / _e7370)));
                                                            } else {
                                                                phi_3258_ = f64();
                                                            }
                                                            let _e7403 = phi_3258_;
                                                            continue;
                                                            continuing {
                                                                phi_3254_ = _e7393;
                                                                phi_3257_ = _e7403;
                                                                break if !(_e7398);
                                                            }
                                                        }
                                                        let _e7408 = local_41;
                                                        phi_3311_ = (_e7408 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e7415 = phi_3311_;
                                                    let _e7417 = (1.1102230246251565e-16lf * f64(12f));
                                                    let _e7424 = ((((((((_e7078 + _e7080) + (_e7132 + _e7134)) + (_e7186 + _e7188)) * (1.1102230246251565e-16lf * f64(16f))) + (_e7196 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e825.member_1 * _e7415) * (f64(1f) + _e7417)));
                                                    let _e7429 = (((_e7352 * _e6966[0]) + (_e7354 * _e6966[1])) + (_e7356 * _e6966[2]));
                                                    let _e7434 = (((_e7352 * _e6983) + (_e7354 * _e6984)) + (_e7356 * _e6985));
                                                    let _e7439 = (((_e7352 * (_e6966[0] - _e6979[0])) + (_e7354 * (_e6966[1] - _e6979[1]))) + (_e7356 * (_e6966[2] - _e6979[2])));
                                                    let _e7447 = (((_e7352 * _e6992[0]) + (_e7354 * _e6992[1])) + (_e7356 * _e6992[2]));
                                                    let _e7453 = (((_e7352 * _e6998[0]) + (_e7354 * _e6998[1])) + (_e7356 * _e6998[2]));
                                                    let _e7458 = (((_e7352 * _e7015) + (_e7354 * _e7016)) + (_e7356 * _e7017));
                                                    let _e7463 = (((_e7352 * (_e6998[0] - _e7011[0])) + (_e7354 * (_e6998[1] - _e7011[1]))) + (_e7356 * (_e6998[2] - _e7011[2])));
                                                    let _e7471 = (((_e7352 * _e7024[0]) + (_e7354 * _e7024[1])) + (_e7356 * _e7024[2]));
                                                    if (_e7429 < 0.0lf) {
                                                        phi_3380_ = -(_e7429);
                                                    } else {
                                                        phi_3380_ = _e7429;
                                                    }
                                                    let _e7476 = phi_3380_;
                                                    if (_e7453 < 0.0lf) {
                                                        phi_3386_ = -(_e7453);
                                                    } else {
                                                        phi_3386_ = _e7453;
                                                    }
                                                    let _e7480 = phi_3386_;
                                                    if (_e7434 < 0.0lf) {
                                                        phi_3395_ = -(_e7434);
                                                    } else {
                                                        phi_3395_ = _e7434;
                                                    }
                                                    let _e7487 = phi_3395_;
                                                    if (_e7458 < 0.0lf) {
                                                        phi_3401_ = -(_e7458);
                                                    } else {
                                                        phi_3401_ = _e7458;
                                                    }
                                                    let _e7491 = phi_3401_;
                                                    if (_e7439 < 0.0lf) {
                                                        phi_3410_ = -(_e7439);
                                                    } else {
                                                        phi_3410_ = _e7439;
                                                    }
                                                    let _e7498 = phi_3410_;
                                                    if (_e7463 < 0.0lf) {
                                                        phi_3416_ = -(_e7463);
                                                    } else {
                                                        phi_3416_ = _e7463;
                                                    }
                                                    let _e7502 = phi_3416_;
                                                    if (_e7447 < 0.0lf) {
                                                        phi_3425_ = -(_e7447);
                                                    } else {
                                                        phi_3425_ = _e7447;
                                                    }
                                                    let _e7509 = phi_3425_;
                                                    if (_e7471 < 0.0lf) {
                                                        phi_3431_ = -(_e7471);
                                                    } else {
                                                        phi_3431_ = _e7471;
                                                    }
                                                    let _e7513 = phi_3431_;
                                                    phi_3437_ = type_35(array<f64, 4>(_e7429, _e7434, _e7439, _e7447), array<f64, 4>(_e7453, _e7458, _e7463, _e7471), array<f64, 4>((_e7424 + ((_e7476 + _e7480) * _e7417)), (_e7424 + ((_e7487 + _e7491) * _e7417)), (_e7424 + ((_e7498 + _e7502) * _e7417)), (_e7424 + ((_e7509 + _e7513) * _e7417))));
                                                    phi_3438_ = false;
                                                } else {
                                                    phi_3437_ = type_35();
                                                    phi_3438_ = true;
                                                }
                                                let _e7520 = phi_3437_;
                                                let _e7522 = phi_3438_;
                                                phi_3439_ = _e7520;
                                                phi_3440_ = _e7522;
                                            } else {
                                                phi_3439_ = type_35();
                                                phi_3440_ = true;
                                            }
                                            let _e7524 = phi_3439_;
                                            let _e7526 = phi_3440_;
                                            if _e7526 {
                                                let _e7527 = f64(0f);
                                                let _e7528 = f64(1f);
                                                phi_3450_ = type_35(array<f64, 4>(_e7527, _e7527, _e7527, _e7527), array<f64, 4>(_e7527, _e7527, _e7527, _e7527), array<f64, 4>(_e7528, _e7528, _e7528, _e7528));
                                            } else {
                                                phi_3450_ = _e7524;
                                            }
                                            let _e7534 = phi_3450_;
                                            local_17 = type_35(array<f64, 4>(_e7534.member[0], _e7534.member[1], _e7534.member[2], _e7534.member[3]), array<f64, 4>(_e7534.member_1[0], _e7534.member_1[1], _e7534.member_1[2], _e7534.member_1[3]), array<f64, 4>(_e7534.member_2[0], _e7534.member_2[1], _e7534.member_2[2], _e7534.member_2[3]));
                                            let _e7554 = (_e7215 - _e7221);
                                            let _e7556 = f64(0f);
                                            let _e7559 = local_17.member[0u];
                                            let _e7562 = local_17.member_1[0u];
                                            let _e7565 = local_17.member[0u];
                                            let _e7571 = local_17.member_2[0u];
                                            if (((_e7559 + ((_e7562 - _e7565) * _e7215)) - _e7571) > _e7556) {
                                                let _e7576 = local_17.member[1u];
                                                let _e7579 = local_17.member_1[1u];
                                                let _e7582 = local_17.member[1u];
                                                let _e7588 = local_17.member_2[1u];
                                                if (((_e7576 + ((_e7579 - _e7582) * _e7215)) - _e7588) > _e7556) {
                                                    let _e7593 = local_17.member[2u];
                                                    let _e7596 = local_17.member_1[2u];
                                                    let _e7599 = local_17.member[2u];
                                                    let _e7605 = local_17.member_2[2u];
                                                    if (((_e7593 + ((_e7596 - _e7599) * _e7215)) - _e7605) > _e7556) {
                                                        let _e7610 = local_17.member[3u];
                                                        let _e7613 = local_17.member_1[3u];
                                                        let _e7616 = local_17.member[3u];
                                                        let _e7622 = local_17.member_2[3u];
                                                        phi_3622_ = (((_e7610 + ((_e7613 - _e7616) * _e7215)) - _e7622) > _e7556);
                                                        phi_3623_ = false;
                                                    } else {
                                                        phi_3622_ = bool();
                                                        phi_3623_ = true;
                                                    }
                                                    let _e7626 = phi_3622_;
                                                    let _e7628 = phi_3623_;
                                                    phi_3624_ = _e7626;
                                                    phi_3625_ = _e7628;
                                                } else {
                                                    phi_3624_ = bool();
                                                    phi_3625_ = true;
                                                }
                                                let _e7630 = phi_3624_;
                                                let _e7632 = phi_3625_;
                                                phi_3626_ = _e7630;
                                                phi_3627_ = _e7632;
                                            } else {
                                                phi_3626_ = bool();
                                                phi_3627_ = true;
                                            }
                                            let _e7634 = phi_3626_;
                                            let _e7636 = phi_3627_;
                                            if _e7636 {
                                                phi_3631_ = false;
                                            } else {
                                                phi_3631_ = _e7634;
                                            }
                                            let _e7638 = phi_3631_;
                                            if _e7638 {
                                                if (_e7215 <= _e7217) {
                                                    phi_3942_ = true;
                                                } else {
                                                    let _e7640 = f64(0f);
                                                    let _e7643 = local_16.member[0u];
                                                    let _e7646 = local_16.member_1[0u];
                                                    let _e7649 = local_16.member[0u];
                                                    let _e7655 = local_16.member_2[0u];
                                                    let _e7659 = local_17.member[0u];
                                                    let _e7662 = local_17.member_1[0u];
                                                    let _e7665 = local_17.member[0u];
                                                    let _e7671 = local_17.member_2[0u];
                                                    if ((((_e7643 + ((_e7646 - _e7649) * _e7215)) - _e7655) + ((_e7659 + ((_e7662 - _e7665) * _e7221)) - _e7671)) > _e7640) {
                                                        let _e7677 = local_16.member[1u];
                                                        let _e7680 = local_16.member_1[1u];
                                                        let _e7683 = local_16.member[1u];
                                                        let _e7689 = local_16.member_2[1u];
                                                        let _e7693 = local_17.member[1u];
                                                        let _e7696 = local_17.member_1[1u];
                                                        let _e7699 = local_17.member[1u];
                                                        let _e7705 = local_17.member_2[1u];
                                                        if ((((_e7677 + ((_e7680 - _e7683) * _e7215)) - _e7689) + ((_e7693 + ((_e7696 - _e7699) * _e7221)) - _e7705)) > _e7640) {
                                                            let _e7711 = local_16.member[2u];
                                                            let _e7714 = local_16.member_1[2u];
                                                            let _e7717 = local_16.member[2u];
                                                            let _e7723 = local_16.member_2[2u];
                                                            let _e7727 = local_17.member[2u];
                                                            let _e7730 = local_17.member_1[2u];
                                                            let _e7733 = local_17.member[2u];
                                                            let _e7739 = local_17.member_2[2u];
                                                            if ((((_e7711 + ((_e7714 - _e7717) * _e7215)) - _e7723) + ((_e7727 + ((_e7730 - _e7733) * _e7221)) - _e7739)) > _e7640) {
                                                                let _e7745 = local_16.member[3u];
                                                                let _e7748 = local_16.member_1[3u];
                                                                let _e7751 = local_16.member[3u];
                                                                let _e7757 = local_16.member_2[3u];
                                                                let _e7761 = local_17.member[3u];
                                                                let _e7764 = local_17.member_1[3u];
                                                                let _e7767 = local_17.member[3u];
                                                                let _e7773 = local_17.member_2[3u];
                                                                phi_3929_ = ((((_e7745 + ((_e7748 - _e7751) * _e7215)) - _e7757) + ((_e7761 + ((_e7764 - _e7767) * _e7221)) - _e7773)) > _e7640);
                                                                phi_3930_ = false;
                                                            } else {
                                                                phi_3929_ = bool();
                                                                phi_3930_ = true;
                                                            }
                                                            let _e7778 = phi_3929_;
                                                            let _e7780 = phi_3930_;
                                                            phi_3931_ = _e7778;
                                                            phi_3932_ = _e7780;
                                                        } else {
                                                            phi_3931_ = bool();
                                                            phi_3932_ = true;
                                                        }
                                                        let _e7782 = phi_3931_;
                                                        let _e7784 = phi_3932_;
                                                        phi_3933_ = _e7782;
                                                        phi_3934_ = _e7784;
                                                    } else {
                                                        phi_3933_ = bool();
                                                        phi_3934_ = true;
                                                    }
                                                    let _e7786 = phi_3933_;
                                                    let _e7788 = phi_3934_;
                                                    if _e7788 {
                                                        phi_3938_ = false;
                                                    } else {
                                                        phi_3938_ = _e7786;
                                                    }
                                                    let _e7790 = phi_3938_;
                                                    phi_3942_ = _e7790;
                                                }
                                                let _e7792 = phi_3942_;
                                                if _e7792 {
                                                    if _e7223 {
                                                        if (_e7215 >= _e557) {
                                                            phi_3953_ = false;
                                                        } else {
                                                            phi_3953_ = true;
                                                        }
                                                        let _e7795 = phi_3953_;
                                                        phi_3954_ = _e7795;
                                                    } else {
                                                        phi_3954_ = true;
                                                    }
                                                    let _e7797 = phi_3954_;
                                                    if _e7797 {
                                                        local_16 = type_35(array<f64, 4>(_e7534.member[0], _e7534.member[1], _e7534.member[2], _e7534.member[3]), array<f64, 4>(_e7534.member_1[0], _e7534.member_1[1], _e7534.member_1[2], _e7534.member_1[3]), array<f64, 4>(_e7534.member_2[0], _e7534.member_2[1], _e7534.member_2[2], _e7534.member_2[3]));
                                                        let _e7819 = local_16.member[0u];
                                                        let _e7822 = local_16.member_1[0u];
                                                        let _e7825 = local_16.member_2[0u];
                                                        if (_e7819 > _e7825) {
                                                            if (_e7822 > _e7825) {
                                                                phi_4028_ = false;
                                                            } else {
                                                                phi_4028_ = true;
                                                            }
                                                            let _e7829 = phi_4028_;
                                                            phi_4029_ = _e7829;
                                                        } else {
                                                            phi_4029_ = true;
                                                        }
                                                        let _e7831 = phi_4029_;
                                                        if _e7831 {
                                                            let _e7832 = (_e7822 >= _e7819);
                                                            if _e7832 {
                                                                phi_4054_ = f64();
                                                                phi_4055_ = false;
                                                            } else {
                                                                if ((_e7819 - _e7822) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4052_ = (((_e7819 - _e7825) / (_e7819 - _e7822)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4053_ = false;
                                                                } else {
                                                                    phi_4052_ = f64();
                                                                    phi_4053_ = true;
                                                                }
                                                                let _e7846 = phi_4052_;
                                                                let _e7848 = phi_4053_;
                                                                phi_4054_ = _e7846;
                                                                phi_4055_ = _e7848;
                                                            }
                                                            let _e7850 = phi_4054_;
                                                            let _e7852 = phi_4055_;
                                                            phi_4056_ = _e7850;
                                                            phi_4057_ = _e7832;
                                                            phi_4058_ = _e7852;
                                                        } else {
                                                            phi_4056_ = f64();
                                                            phi_4057_ = true;
                                                            phi_4058_ = false;
                                                        }
                                                        let _e7854 = phi_4056_;
                                                        let _e7856 = phi_4057_;
                                                        let _e7858 = phi_4058_;
                                                        if _e7856 {
                                                            phi_4063_ = f64(2f);
                                                            phi_4064_ = true;
                                                        } else {
                                                            phi_4063_ = _e7215;
                                                            phi_4064_ = _e7858;
                                                        }
                                                        let _e7861 = phi_4063_;
                                                        let _e7863 = phi_4064_;
                                                        if _e7863 {
                                                            phi_4068_ = _e7861;
                                                        } else {
                                                            phi_4068_ = _e7854;
                                                        }
                                                        let _e7865 = phi_4068_;
                                                        let _e7868 = local_16.member[1u];
                                                        let _e7871 = local_16.member_1[1u];
                                                        let _e7874 = local_16.member_2[1u];
                                                        if (_e7868 > _e7874) {
                                                            if (_e7871 > _e7874) {
                                                                phi_4100_ = false;
                                                            } else {
                                                                phi_4100_ = true;
                                                            }
                                                            let _e7878 = phi_4100_;
                                                            phi_4101_ = _e7878;
                                                        } else {
                                                            phi_4101_ = true;
                                                        }
                                                        let _e7880 = phi_4101_;
                                                        if _e7880 {
                                                            let _e7881 = (_e7871 >= _e7868);
                                                            if _e7881 {
                                                                phi_4126_ = f64();
                                                                phi_4127_ = false;
                                                            } else {
                                                                if ((_e7868 - _e7871) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4124_ = (((_e7868 - _e7874) / (_e7868 - _e7871)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4125_ = false;
                                                                } else {
                                                                    phi_4124_ = f64();
                                                                    phi_4125_ = true;
                                                                }
                                                                let _e7895 = phi_4124_;
                                                                let _e7897 = phi_4125_;
                                                                phi_4126_ = _e7895;
                                                                phi_4127_ = _e7897;
                                                            }
                                                            let _e7899 = phi_4126_;
                                                            let _e7901 = phi_4127_;
                                                            phi_4128_ = _e7899;
                                                            phi_4129_ = _e7881;
                                                            phi_4130_ = _e7901;
                                                        } else {
                                                            phi_4128_ = f64();
                                                            phi_4129_ = true;
                                                            phi_4130_ = false;
                                                        }
                                                        let _e7903 = phi_4128_;
                                                        let _e7905 = phi_4129_;
                                                        let _e7907 = phi_4130_;
                                                        if _e7905 {
                                                            phi_4135_ = f64(2f);
                                                            phi_4136_ = true;
                                                        } else {
                                                            phi_4135_ = _e7215;
                                                            phi_4136_ = _e7907;
                                                        }
                                                        let _e7910 = phi_4135_;
                                                        let _e7912 = phi_4136_;
                                                        if _e7912 {
                                                            phi_4140_ = _e7910;
                                                        } else {
                                                            phi_4140_ = _e7903;
                                                        }
                                                        let _e7914 = phi_4140_;
                                                        if (_e7865 < _e7914) {
                                                            phi_4145_ = _e7865;
                                                        } else {
                                                            phi_4145_ = _e7914;
                                                        }
                                                        let _e7917 = phi_4145_;
                                                        let _e7920 = local_16.member[2u];
                                                        let _e7923 = local_16.member_1[2u];
                                                        let _e7926 = local_16.member_2[2u];
                                                        if (_e7920 > _e7926) {
                                                            if (_e7923 > _e7926) {
                                                                phi_4177_ = false;
                                                            } else {
                                                                phi_4177_ = true;
                                                            }
                                                            let _e7930 = phi_4177_;
                                                            phi_4178_ = _e7930;
                                                        } else {
                                                            phi_4178_ = true;
                                                        }
                                                        let _e7932 = phi_4178_;
                                                        if _e7932 {
                                                            let _e7933 = (_e7923 >= _e7920);
                                                            if _e7933 {
                                                                phi_4203_ = f64();
                                                                phi_4204_ = false;
                                                            } else {
                                                                if ((_e7920 - _e7923) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4201_ = (((_e7920 - _e7926) / (_e7920 - _e7923)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4202_ = false;
                                                                } else {
                                                                    phi_4201_ = f64();
                                                                    phi_4202_ = true;
                                                                }
                                                                let _e7947 = phi_4201_;
                                                                let _e7949 = phi_4202_;
                                                                phi_4203_ = _e7947;
                                                                phi_4204_ = _e7949;
                                                            }
                                                            let _e7951 = phi_4203_;
                                                            let _e7953 = phi_4204_;
                                                            phi_4205_ = _e7951;
                                                            phi_4206_ = _e7933;
                                                            phi_4207_ = _e7953;
                                                        } else {
                                                            phi_4205_ = f64();
                                                            phi_4206_ = true;
                                                            phi_4207_ = false;
                                                        }
                                                        let _e7955 = phi_4205_;
                                                        let _e7957 = phi_4206_;
                                                        let _e7959 = phi_4207_;
                                                        if _e7957 {
                                                            phi_4212_ = f64(2f);
                                                            phi_4213_ = true;
                                                        } else {
                                                            phi_4212_ = _e7215;
                                                            phi_4213_ = _e7959;
                                                        }
                                                        let _e7962 = phi_4212_;
                                                        let _e7964 = phi_4213_;
                                                        if _e7964 {
                                                            phi_4217_ = _e7962;
                                                        } else {
                                                            phi_4217_ = _e7955;
                                                        }
                                                        let _e7966 = phi_4217_;
                                                        let _e7969 = local_16.member[3u];
                                                        let _e7972 = local_16.member_1[3u];
                                                        let _e7975 = local_16.member_2[3u];
                                                        if (_e7969 > _e7975) {
                                                            if (_e7972 > _e7975) {
                                                                phi_4249_ = false;
                                                            } else {
                                                                phi_4249_ = true;
                                                            }
                                                            let _e7979 = phi_4249_;
                                                            phi_4250_ = _e7979;
                                                        } else {
                                                            phi_4250_ = true;
                                                        }
                                                        let _e7981 = phi_4250_;
                                                        if _e7981 {
                                                            let _e7982 = (_e7972 >= _e7969);
                                                            if _e7982 {
                                                                phi_4275_ = f64();
                                                                phi_4276_ = false;
                                                            } else {
                                                                if ((_e7969 - _e7972) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4273_ = (((_e7969 - _e7975) / (_e7969 - _e7972)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4274_ = false;
                                                                } else {
                                                                    phi_4273_ = f64();
                                                                    phi_4274_ = true;
                                                                }
                                                                let _e7996 = phi_4273_;
                                                                let _e7998 = phi_4274_;
                                                                phi_4275_ = _e7996;
                                                                phi_4276_ = _e7998;
                                                            }
                                                            let _e8000 = phi_4275_;
                                                            let _e8002 = phi_4276_;
                                                            phi_4277_ = _e8000;
                                                            phi_4278_ = _e7982;
                                                            phi_4279_ = _e8002;
                                                        } else {
                                                            phi_4277_ = f64();
                                                            phi_4278_ = true;
                                                            phi_4279_ = false;
                                                        }
                                                        let _e8004 = phi_4277_;
                                                        let _e8006 = phi_4278_;
                                                        let _e8008 = phi_4279_;
                                                        if _e8006 {
                                                            phi_4284_ = f64(2f);
                                                            phi_4285_ = true;
                                                        } else {
                                                            phi_4284_ = _e7215;
                                                            phi_4285_ = _e8008;
                                                        }
                                                        let _e8011 = phi_4284_;
                                                        let _e8013 = phi_4285_;
                                                        if _e8013 {
                                                            phi_4289_ = _e8011;
                                                        } else {
                                                            phi_4289_ = _e8004;
                                                        }
                                                        let _e8015 = phi_4289_;
                                                        if (_e7966 < _e8015) {
                                                            phi_4294_ = _e7966;
                                                        } else {
                                                            phi_4294_ = _e8015;
                                                        }
                                                        let _e8018 = phi_4294_;
                                                        if (_e7917 < _e8018) {
                                                            phi_4299_ = _e7917;
                                                        } else {
                                                            phi_4299_ = _e8018;
                                                        }
                                                        let _e8021 = phi_4299_;
                                                        if (_e8021 > _e7215) {
                                                            phi_4304_ = _e8021;
                                                        } else {
                                                            phi_4304_ = _e7215;
                                                        }
                                                        let _e8024 = phi_4304_;
                                                        let _e8025 = (_e8024 > _e557);
                                                        if _e8025 {
                                                            phi_4821_ = f64();
                                                            phi_4822_ = f64();
                                                            phi_4823_ = false;
                                                            phi_4824_ = false;
                                                        } else {
                                                            let _e8026 = (_e8024 - _e7215);
                                                            let _e8027 = (_e8026 <= _e7204);
                                                            let _e8030 = (_e8024 + (_e539 * f64(0.01f)));
                                                            if (_e8030 < _e557) {
                                                                phi_4318_ = _e8030;
                                                            } else {
                                                                phi_4318_ = _e557;
                                                            }
                                                            let _e8033 = phi_4318_;
                                                            if _e8027 {
                                                                if (_e825.member_1 > f64(0f)) {
                                                                    let _e8038 = local_18.member[0u];
                                                                    let _e8044 = local_18.member[1u];
                                                                    let _e8060 = local_18.member_1[0u];
                                                                    let _e8066 = local_18.member_1[1u];
                                                                    let _e8082 = local_18.member_2[0u];
                                                                    let _e8088 = local_18.member_2[1u];
                                                                    let _e8102 = function_4(array<f64, 3>((_e8038[0] + ((_e8044[0] - _e8038[0]) * _e8033)), (_e8038[1] + ((_e8044[1] - _e8038[1]) * _e8033)), (_e8038[2] + ((_e8044[2] - _e8038[2]) * _e8033))), array<f64, 3>((_e8060[0] + ((_e8066[0] - _e8060[0]) * _e8033)), (_e8060[1] + ((_e8066[1] - _e8060[1]) * _e8033)), (_e8060[2] + ((_e8066[2] - _e8060[2]) * _e8033))), array<f64, 3>((_e8082[0] + ((_e8088[0] - _e8082[0]) * _e8033)), (_e8082[1] + ((_e8088[1] - _e8082[1]) * _e8033)), (_e8082[2] + ((_e8088[2] - _e8082[2]) * _e8033))), _e252.member);
                                                                    let _e8113 = (((_e8102[0] * _e8102[0]) + (_e8102[1] * _e8102[1])) + (_e8102[2] * _e8102[2]));
                                                                    if (_e8113 <= 2.2250738585072014e-308lf) {
                                                                        if (_e8113 > 0.0lf) {
                                                                            phi_4449_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_4449_ = 0.0lf;
                                                                        }
                                                                        let _e8165 = phi_4449_;
                                                                        phi_4513_ = _e8165;
                                                                    } else {
                                                                        phi_4456_ = type_18(0i, 5i);
                                                                        phi_4459_ = bitcast<f64>(((bitcast<u64>(_e8113) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e8120 = phi_4456_;
                                                                            let _e8122 = phi_4459_;
                                                                            local_42 = _e8122;
                                                                            if (_e8120.member < _e8120.member_1) {
                                                                                let _e8129 = (_e8120.member + 1i);
                                                                                if ((false == (_e8129 > _e8120.member)) != false) {
                                                                                    phi_4480_ = true;
                                                                                } else {
                                                                                    phi_4480_ = false;
                                                                                }
                                                                                let _e8134 = phi_4480_;
                                                                                if _e8134 {
                                                                                    phi_4486_ = type_19(0u, type_19().member_1);
                                                                                } else {
                                                                                    phi_4486_ = type_19(1u, _e8129);
                                                                                }
                                                                                let _e8139 = phi_4486_;
                                                                                phi_4457_ = type_18(_e8139.member_1, _e8120.member_1);
                                                                                phi_4500_ = type_19(1u, _e8120.member);
                                                                            } else {
                                                                                phi_4457_ = _e8120;
                                                                                phi_4500_ = type_19(0u, type_19().member_1);
                                                                            }
                                                                            let _e8145 = phi_4457_;
                                                                            let _e8147 = phi_4500_;
                                                                            let _e8150 = (bitcast<i32>(_e8147.member) != 0i);
                                                                            if _e8150 {
                                                                                phi_4460_ = (0.5lf * (_e8122 + (_e8113 / _e8122)));
                                                                            } else {
                                                                                phi_4460_ = f64();
                                                                            }
                                                                            let _e8155 = phi_4460_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4456_ = _e8145;
                                                                                phi_4459_ = _e8155;
                                                                                break if !(_e8150);
                                                                            }
                                                                        }
                                                                        let _e8160 = local_42;
                                                                        phi_4513_ = (_e8160 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e8167 = phi_4513_;
                                                                    let _e8175 = local_18.member[0u];
                                                                    if (_e8175[0] < 0.0lf) {
                                                                        phi_4531_ = -(_e8175[0]);
                                                                    } else {
                                                                        phi_4531_ = _e8175[0];
                                                                    }
                                                                    let _e8182 = phi_4531_;
                                                                    if (_e8175[1] < 0.0lf) {
                                                                        phi_4538_ = -(_e8175[1]);
                                                                    } else {
                                                                        phi_4538_ = _e8175[1];
                                                                    }
                                                                    let _e8186 = phi_4538_;
                                                                    if (_e8182 > _e8186) {
                                                                        phi_4543_ = _e8182;
                                                                    } else {
                                                                        phi_4543_ = _e8186;
                                                                    }
                                                                    let _e8189 = phi_4543_;
                                                                    if (_e8175[2] < 0.0lf) {
                                                                        phi_4550_ = -(_e8175[2]);
                                                                    } else {
                                                                        phi_4550_ = _e8175[2];
                                                                    }
                                                                    let _e8193 = phi_4550_;
                                                                    if (_e8189 > _e8193) {
                                                                        phi_4555_ = _e8189;
                                                                    } else {
                                                                        phi_4555_ = _e8193;
                                                                    }
                                                                    let _e8196 = phi_4555_;
                                                                    let _e8199 = local_18.member[1u];
                                                                    if (_e8199[0] < 0.0lf) {
                                                                        phi_4568_ = -(_e8199[0]);
                                                                    } else {
                                                                        phi_4568_ = _e8199[0];
                                                                    }
                                                                    let _e8206 = phi_4568_;
                                                                    if (_e8199[1] < 0.0lf) {
                                                                        phi_4575_ = -(_e8199[1]);
                                                                    } else {
                                                                        phi_4575_ = _e8199[1];
                                                                    }
                                                                    let _e8210 = phi_4575_;
                                                                    if (_e8206 > _e8210) {
                                                                        phi_4580_ = _e8206;
                                                                    } else {
                                                                        phi_4580_ = _e8210;
                                                                    }
                                                                    let _e8213 = phi_4580_;
                                                                    if (_e8199[2] < 0.0lf) {
                                                                        phi_4587_ = -(_e8199[2]);
                                                                    } else {
                                                                        phi_4587_ = _e8199[2];
                                                                    }
                                                                    let _e8217 = phi_4587_;
                                                                    if (_e8213 > _e8217) {
                                                                        phi_4592_ = _e8213;
                                                                    } else {
                                                                        phi_4592_ = _e8217;
                                                                    }
                                                                    let _e8220 = phi_4592_;
                                                                    if (_e8196 > _e8220) {
                                                                        phi_4597_ = _e8196;
                                                                    } else {
                                                                        phi_4597_ = _e8220;
                                                                    }
                                                                    let _e8223 = phi_4597_;
                                                                    let _e8225 = local_18.member_3;
                                                                    let _e8229 = local_18.member_1[0u];
                                                                    if (_e8229[0] < 0.0lf) {
                                                                        phi_4614_ = -(_e8229[0]);
                                                                    } else {
                                                                        phi_4614_ = _e8229[0];
                                                                    }
                                                                    let _e8236 = phi_4614_;
                                                                    if (_e8229[1] < 0.0lf) {
                                                                        phi_4621_ = -(_e8229[1]);
                                                                    } else {
                                                                        phi_4621_ = _e8229[1];
                                                                    }
                                                                    let _e8240 = phi_4621_;
                                                                    if (_e8236 > _e8240) {
                                                                        phi_4626_ = _e8236;
                                                                    } else {
                                                                        phi_4626_ = _e8240;
                                                                    }
                                                                    let _e8243 = phi_4626_;
                                                                    if (_e8229[2] < 0.0lf) {
                                                                        phi_4633_ = -(_e8229[2]);
                                                                    } else {
                                                                        phi_4633_ = _e8229[2];
                                                                    }
                                                                    let _e8247 = phi_4633_;
                                                                    if (_e8243 > _e8247) {
                                                                        phi_4638_ = _e8243;
                                                                    } else {
                                                                        phi_4638_ = _e8247;
                                                                    }
                                                                    let _e8250 = phi_4638_;
                                                                    let _e8253 = local_18.member_1[1u];
                                                                    if (_e8253[0] < 0.0lf) {
                                                                        phi_4652_ = -(_e8253[0]);
                                                                    } else {
                                                                        phi_4652_ = _e8253[0];
                                                                    }
                                                                    let _e8260 = phi_4652_;
                                                                    if (_e8253[1] < 0.0lf) {
                                                                        phi_4659_ = -(_e8253[1]);
                                                                    } else {
                                                                        phi_4659_ = _e8253[1];
                                                                    }
                                                                    let _e8264 = phi_4659_;
                                                                    if (_e8260 > _e8264) {
                                                                        phi_4664_ = _e8260;
                                                                    } else {
                                                                        phi_4664_ = _e8264;
                                                                    }
                                                                    let _e8267 = phi_4664_;
                                                                    if (_e8253[2] < 0.0lf) {
                                                                        phi_4671_ = -(_e8253[2]);
                                                                    } else {
                                                                        phi_4671_ = _e8253[2];
                                                                    }
                                                                    let _e8271 = phi_4671_;
                                                                    if (_e8267 > _e8271) {
                                                                        phi_4676_ = _e8267;
                                                                    } else {
                                                                        phi_4676_ = _e8271;
                                                                    }
                                                                    let _e8274 = phi_4676_;
                                                                    if (_e8250 > _e8274) {
                                                                        phi_4681_ = _e8250;
                                                                    } else {
                                                                        phi_4681_ = _e8274;
                                                                    }
                                                                    let _e8277 = phi_4681_;
                                                                    let _e8279 = local_18.member_3;
                                                                    let _e8283 = local_18.member_2[0u];
                                                                    if (_e8283[0] < 0.0lf) {
                                                                        phi_4698_ = -(_e8283[0]);
                                                                    } else {
                                                                        phi_4698_ = _e8283[0];
                                                                    }
                                                                    let _e8290 = phi_4698_;
                                                                    if (_e8283[1] < 0.0lf) {
                                                                        phi_4705_ = -(_e8283[1]);
                                                                    } else {
                                                                        phi_4705_ = _e8283[1];
                                                                    }
                                                                    let _e8294 = phi_4705_;
                                                                    if (_e8290 > _e8294) {
                                                                        phi_4710_ = _e8290;
                                                                    } else {
                                                                        phi_4710_ = _e8294;
                                                                    }
                                                                    let _e8297 = phi_4710_;
                                                                    if (_e8283[2] < 0.0lf) {
                                                                        phi_4717_ = -(_e8283[2]);
                                                                    } else {
                                                                        phi_4717_ = _e8283[2];
                                                                    }
                                                                    let _e8301 = phi_4717_;
                                                                    if (_e8297 > _e8301) {
                                                                        phi_4722_ = _e8297;
                                                                    } else {
                                                                        phi_4722_ = _e8301;
                                                                    }
                                                                    let _e8304 = phi_4722_;
                                                                    let _e8307 = local_18.member_2[1u];
                                                                    if (_e8307[0] < 0.0lf) {
                                                                        phi_4736_ = -(_e8307[0]);
                                                                    } else {
                                                                        phi_4736_ = _e8307[0];
                                                                    }
                                                                    let _e8314 = phi_4736_;
                                                                    if (_e8307[1] < 0.0lf) {
                                                                        phi_4743_ = -(_e8307[1]);
                                                                    } else {
                                                                        phi_4743_ = _e8307[1];
                                                                    }
                                                                    let _e8318 = phi_4743_;
                                                                    if (_e8314 > _e8318) {
                                                                        phi_4748_ = _e8314;
                                                                    } else {
                                                                        phi_4748_ = _e8318;
                                                                    }
                                                                    let _e8321 = phi_4748_;
                                                                    if (_e8307[2] < 0.0lf) {
                                                                        phi_4755_ = -(_e8307[2]);
                                                                    } else {
                                                                        phi_4755_ = _e8307[2];
                                                                    }
                                                                    let _e8325 = phi_4755_;
                                                                    if (_e8321 > _e8325) {
                                                                        phi_4760_ = _e8321;
                                                                    } else {
                                                                        phi_4760_ = _e8325;
                                                                    }
                                                                    let _e8328 = phi_4760_;
                                                                    if (_e8304 > _e8328) {
                                                                        phi_4765_ = _e8304;
                                                                    } else {
                                                                        phi_4765_ = _e8328;
                                                                    }
                                                                    let _e8331 = phi_4765_;
                                                                    let _e8333 = local_18.member_3;
                                                                    let _e8341 = local_18.member_3;
                                                                    if (((_e8167 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e8223 + _e8225) + (_e8277 + _e8279)) + (_e8331 + _e8333)) * (1.1102230246251565e-16lf * f64(16f))) + (_e8341 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e825.member_1) {
                                                                        phi_4789_ = false;
                                                                    } else {
                                                                        phi_4789_ = true;
                                                                    }
                                                                    let _e8353 = phi_4789_;
                                                                    phi_4790_ = _e8353;
                                                                } else {
                                                                    phi_4790_ = true;
                                                                }
                                                                let _e8355 = phi_4790_;
                                                                phi_4791_ = _e8355;
                                                            } else {
                                                                phi_4791_ = true;
                                                            }
                                                            let _e8357 = phi_4791_;
                                                            if _e8357 {
                                                                if _e7223 {
                                                                    if _e8027 {
                                                                        phi_4810_ = f64();
                                                                        phi_4811_ = true;
                                                                    } else {
                                                                        if (_e8026 <= (_e7219 * f64(0.25f))) {
                                                                            phi_4808_ = f64(0f);
                                                                            phi_4809_ = false;
                                                                        } else {
                                                                            phi_4808_ = f64();
                                                                            phi_4809_ = true;
                                                                        }
                                                                        let _e8364 = phi_4808_;
                                                                        let _e8366 = phi_4809_;
                                                                        phi_4810_ = _e8364;
                                                                        phi_4811_ = _e8366;
                                                                    }
                                                                    let _e8368 = phi_4810_;
                                                                    let _e8370 = phi_4811_;
                                                                    if _e8370 {
                                                                        phi_4816_ = (_e7554 + _e7554);
                                                                    } else {
                                                                        phi_4816_ = _e8368;
                                                                    }
                                                                    let _e8373 = phi_4816_;
                                                                    phi_4818_ = _e8373;
                                                                } else {
                                                                    phi_4818_ = (_e557 - _e7215);
                                                                }
                                                                let _e8375 = phi_4818_;
                                                                phi_4819_ = _e8375;
                                                                phi_4820_ = false;
                                                            } else {
                                                                phi_4819_ = f64();
                                                                phi_4820_ = true;
                                                            }
                                                            let _e8377 = phi_4819_;
                                                            let _e8379 = phi_4820_;
                                                            phi_4821_ = _e8377;
                                                            phi_4822_ = _e8026;
                                                            phi_4823_ = _e8357;
                                                            phi_4824_ = _e8379;
                                                        }
                                                        let _e8381 = phi_4821_;
                                                        let _e8383 = phi_4822_;
                                                        let _e8385 = phi_4823_;
                                                        let _e8387 = phi_4824_;
                                                        phi_4825_ = _e8024;
                                                        phi_4826_ = _e8381;
                                                        phi_4827_ = _e8383;
                                                        phi_4828_ = _e8024;
                                                        phi_4829_ = _e8385;
                                                        phi_4830_ = _e8025;
                                                        phi_4831_ = _e8387;
                                                        phi_4832_ = false;
                                                    } else {
                                                        phi_4825_ = f64();
                                                        phi_4826_ = f64();
                                                        phi_4827_ = f64();
                                                        phi_4828_ = f64();
                                                        phi_4829_ = false;
                                                        phi_4830_ = false;
                                                        phi_4831_ = false;
                                                        phi_4832_ = true;
                                                    }
                                                    let _e8389 = phi_4825_;
                                                    let _e8391 = phi_4826_;
                                                    let _e8393 = phi_4827_;
                                                    let _e8395 = phi_4828_;
                                                    let _e8397 = phi_4829_;
                                                    let _e8399 = phi_4830_;
                                                    let _e8401 = phi_4831_;
                                                    let _e8403 = phi_4832_;
                                                    phi_4833_ = _e8389;
                                                    phi_4834_ = _e8391;
                                                    phi_4835_ = _e8393;
                                                    phi_4836_ = _e8395;
                                                    phi_4837_ = false;
                                                    phi_4838_ = _e8397;
                                                    phi_4839_ = _e8399;
                                                    phi_4840_ = _e8401;
                                                    phi_4841_ = _e8403;
                                                } else {
                                                    phi_4833_ = f64();
                                                    phi_4834_ = f64();
                                                    phi_4835_ = f64();
                                                    phi_4836_ = f64();
                                                    phi_4837_ = true;
                                                    phi_4838_ = false;
                                                    phi_4839_ = false;
                                                    phi_4840_ = false;
                                                    phi_4841_ = false;
                                                }
                                                let _e8405 = phi_4833_;
                                                let _e8407 = phi_4834_;
                                                let _e8409 = phi_4835_;
                                                let _e8411 = phi_4836_;
                                                let _e8413 = phi_4837_;
                                                let _e8415 = phi_4838_;
                                                let _e8417 = phi_4839_;
                                                let _e8419 = phi_4840_;
                                                let _e8421 = phi_4841_;
                                                phi_4842_ = _e8405;
                                                phi_4843_ = _e8407;
                                                phi_4844_ = _e8409;
                                                phi_4845_ = _e8411;
                                                phi_4846_ = _e8413;
                                                phi_4847_ = _e8415;
                                                phi_4848_ = _e8417;
                                                phi_4849_ = _e8419;
                                                phi_4850_ = _e8421;
                                            } else {
                                                phi_4842_ = f64();
                                                phi_4843_ = f64();
                                                phi_4844_ = f64();
                                                phi_4845_ = f64();
                                                phi_4846_ = true;
                                                phi_4847_ = false;
                                                phi_4848_ = false;
                                                phi_4849_ = false;
                                                phi_4850_ = false;
                                            }
                                            let _e8423 = phi_4842_;
                                            let _e8425 = phi_4843_;
                                            let _e8427 = phi_4844_;
                                            let _e8429 = phi_4845_;
                                            let _e8431 = phi_4846_;
                                            let _e8433 = phi_4847_;
                                            let _e8435 = phi_4848_;
                                            let _e8437 = phi_4849_;
                                            let _e8439 = phi_4850_;
                                            if _e8431 {
                                                if (_e7215 <= _e7217) {
                                                    let _e8605 = (_e7225 + 1u);
                                                    let _e8606 = (_e8605 > 3u);
                                                    if _e8606 {
                                                        phi_4863_ = false;
                                                    } else {
                                                        phi_4863_ = true;
                                                    }
                                                    let _e8608 = phi_4863_;
                                                    phi_5190_ = _e8605;
                                                    phi_5191_ = f64();
                                                    phi_5192_ = false;
                                                    phi_5193_ = _e8608;
                                                    phi_5194_ = _e8606;
                                                } else {
                                                    let _e8443 = local_16.member[0u];
                                                    let _e8446 = local_16.member_1[0u];
                                                    let _e8449 = local_16.member[0u];
                                                    let _e8455 = local_16.member_2[0u];
                                                    let _e8456 = ((_e8443 + ((_e8446 - _e8449) * _e7221)) - _e8455);
                                                    let _e8459 = local_16.member[1u];
                                                    let _e8462 = local_16.member_1[1u];
                                                    let _e8465 = local_16.member[1u];
                                                    let _e8471 = local_16.member_2[1u];
                                                    let _e8472 = ((_e8459 + ((_e8462 - _e8465) * _e7221)) - _e8471);
                                                    if (_e8456 < _e8472) {
                                                        phi_4936_ = _e8456;
                                                    } else {
                                                        phi_4936_ = _e8472;
                                                    }
                                                    let _e8475 = phi_4936_;
                                                    let _e8478 = local_16.member[2u];
                                                    let _e8481 = local_16.member_1[2u];
                                                    let _e8484 = local_16.member[2u];
                                                    let _e8490 = local_16.member_2[2u];
                                                    let _e8491 = ((_e8478 + ((_e8481 - _e8484) * _e7221)) - _e8490);
                                                    let _e8494 = local_16.member[3u];
                                                    let _e8497 = local_16.member_1[3u];
                                                    let _e8500 = local_16.member[3u];
                                                    let _e8506 = local_16.member_2[3u];
                                                    let _e8507 = ((_e8494 + ((_e8497 - _e8500) * _e7221)) - _e8506);
                                                    if (_e8491 < _e8507) {
                                                        phi_5009_ = _e8491;
                                                    } else {
                                                        phi_5009_ = _e8507;
                                                    }
                                                    let _e8510 = phi_5009_;
                                                    if (_e8475 < _e8510) {
                                                        phi_5014_ = _e8475;
                                                    } else {
                                                        phi_5014_ = _e8510;
                                                    }
                                                    let _e8513 = phi_5014_;
                                                    let _e8516 = local_17.member[0u];
                                                    let _e8519 = local_17.member_1[0u];
                                                    let _e8522 = local_17.member[0u];
                                                    let _e8528 = local_17.member_2[0u];
                                                    let _e8529 = ((_e8516 + ((_e8519 - _e8522) * _e7215)) - _e8528);
                                                    let _e8532 = local_17.member[1u];
                                                    let _e8535 = local_17.member_1[1u];
                                                    let _e8538 = local_17.member[1u];
                                                    let _e8544 = local_17.member_2[1u];
                                                    let _e8545 = ((_e8532 + ((_e8535 - _e8538) * _e7215)) - _e8544);
                                                    if (_e8529 < _e8545) {
                                                        phi_5087_ = _e8529;
                                                    } else {
                                                        phi_5087_ = _e8545;
                                                    }
                                                    let _e8548 = phi_5087_;
                                                    let _e8551 = local_17.member[2u];
                                                    let _e8554 = local_17.member_1[2u];
                                                    let _e8557 = local_17.member[2u];
                                                    let _e8563 = local_17.member_2[2u];
                                                    let _e8564 = ((_e8551 + ((_e8554 - _e8557) * _e7215)) - _e8563);
                                                    let _e8567 = local_17.member[3u];
                                                    let _e8570 = local_17.member_1[3u];
                                                    let _e8573 = local_17.member[3u];
                                                    let _e8579 = local_17.member_2[3u];
                                                    let _e8580 = ((_e8567 + ((_e8570 - _e8573) * _e7215)) - _e8579);
                                                    if (_e8564 < _e8580) {
                                                        phi_5160_ = _e8564;
                                                    } else {
                                                        phi_5160_ = _e8580;
                                                    }
                                                    let _e8583 = phi_5160_;
                                                    if (_e8548 < _e8583) {
                                                        phi_5165_ = _e8548;
                                                    } else {
                                                        phi_5165_ = _e8583;
                                                    }
                                                    let _e8586 = phi_5165_;
                                                    let _e8587 = f64(0.0625f);
                                                    let _e8589 = f64(0.9f);
                                                    if (_e8586 > f64(0f)) {
                                                        phi_5188_ = f64(0.5f);
                                                    } else {
                                                        let _e8595 = (f64(0.95f) * (_e8513 / (_e8513 - _e8586)));
                                                        if (_e8595 > _e8587) {
                                                            if (_e8595 < _e8589) {
                                                                phi_5186_ = _e8595;
                                                            } else {
                                                                phi_5186_ = _e8589;
                                                            }
                                                            let _e8599 = phi_5186_;
                                                            phi_5187_ = _e8599;
                                                        } else {
                                                            phi_5187_ = _e8587;
                                                        }
                                                        let _e8601 = phi_5187_;
                                                        phi_5188_ = _e8601;
                                                    }
                                                    let _e8603 = phi_5188_;
                                                    phi_5190_ = u32();
                                                    phi_5191_ = (_e7554 * _e8603);
                                                    phi_5192_ = true;
                                                    phi_5193_ = false;
                                                    phi_5194_ = false;
                                                }
                                                let _e8610 = phi_5190_;
                                                let _e8612 = phi_5191_;
                                                let _e8614 = phi_5192_;
                                                let _e8616 = phi_5193_;
                                                let _e8618 = phi_5194_;
                                                phi_5195_ = _e8610;
                                                phi_5196_ = _e7217;
                                                phi_5197_ = _e8612;
                                                phi_5198_ = _e7219;
                                                phi_5199_ = _e7221;
                                                phi_5200_ = _e7223;
                                                phi_5201_ = _e7225;
                                                phi_5202_ = _e8614;
                                                phi_5203_ = _e8616;
                                                phi_5204_ = _e8618;
                                                phi_5205_ = false;
                                                phi_5206_ = false;
                                                phi_5207_ = false;
                                            } else {
                                                phi_5195_ = u32();
                                                phi_5196_ = _e8423;
                                                phi_5197_ = _e8425;
                                                phi_5198_ = _e8427;
                                                phi_5199_ = _e7215;
                                                phi_5200_ = true;
                                                phi_5201_ = 0u;
                                                phi_5202_ = _e8433;
                                                phi_5203_ = false;
                                                phi_5204_ = false;
                                                phi_5205_ = _e8435;
                                                phi_5206_ = _e8437;
                                                phi_5207_ = _e8439;
                                            }
                                            let _e8620 = phi_5195_;
                                            let _e8622 = phi_5196_;
                                            let _e8624 = phi_5197_;
                                            let _e8626 = phi_5198_;
                                            let _e8628 = phi_5199_;
                                            let _e8630 = phi_5200_;
                                            let _e8632 = phi_5201_;
                                            let _e8634 = phi_5202_;
                                            let _e8636 = phi_5203_;
                                            let _e8638 = phi_5204_;
                                            let _e8640 = phi_5205_;
                                            let _e8642 = phi_5206_;
                                            let _e8644 = phi_5207_;
                                            if _e8634 {
                                                let _e8645 = (_e8628 + _e8624);
                                                if (_e8645 > _e8622) {
                                                    phi_5216_ = _e8645;
                                                } else {
                                                    phi_5216_ = _e8622;
                                                }
                                                let _e8648 = phi_5216_;
                                                if (_e8648 < _e557) {
                                                    phi_5221_ = _e8648;
                                                } else {
                                                    phi_5221_ = _e557;
                                                }
                                                let _e8651 = phi_5221_;
                                                if !(_e7223) {
                                                    phi_5230_ = true;
                                                } else {
                                                    phi_5230_ = ((_e8651 - _e8628) > _e7204);
                                                }
                                                let _e8655 = phi_5230_;
                                                if _e8655 {
                                                    phi_5234_ = false;
                                                } else {
                                                    phi_5234_ = true;
                                                }
                                                let _e8657 = phi_5234_;
                                                phi_5235_ = _e8651;
                                                phi_5236_ = _e8622;
                                                phi_5237_ = _e8626;
                                                phi_5238_ = _e8628;
                                                phi_5239_ = _e8630;
                                                phi_5240_ = _e8632;
                                                phi_5241_ = _e8655;
                                                phi_5242_ = _e8657;
                                                phi_5243_ = false;
                                                phi_5244_ = false;
                                                phi_5245_ = false;
                                                phi_5246_ = false;
                                            } else {
                                                phi_5235_ = _e7215;
                                                phi_5236_ = _e7217;
                                                phi_5237_ = _e7219;
                                                phi_5238_ = _e7221;
                                                phi_5239_ = _e7223;
                                                phi_5240_ = _e8620;
                                                phi_5241_ = _e8636;
                                                phi_5242_ = false;
                                                phi_5243_ = _e8638;
                                                phi_5244_ = _e8640;
                                                phi_5245_ = _e8642;
                                                phi_5246_ = _e8644;
                                            }
                                            let _e8659 = phi_5235_;
                                            let _e8661 = phi_5236_;
                                            let _e8663 = phi_5237_;
                                            let _e8665 = phi_5238_;
                                            let _e8667 = phi_5239_;
                                            let _e8669 = phi_5240_;
                                            let _e8671 = phi_5241_;
                                            let _e8673 = phi_5242_;
                                            let _e8675 = phi_5243_;
                                            let _e8677 = phi_5244_;
                                            let _e8679 = phi_5245_;
                                            let _e8681 = phi_5246_;
                                            phi_3025_ = _e8659;
                                            phi_3027_ = _e8661;
                                            phi_3029_ = _e8663;
                                            phi_3031_ = _e8665;
                                            phi_3033_ = _e8667;
                                            phi_3035_ = _e8669;
                                            phi_5247_ = _e8622;
                                            phi_5248_ = _e8429;
                                            phi_5249_ = _e8671;
                                            phi_5250_ = _e8673;
                                            phi_5251_ = _e8675;
                                            phi_5252_ = _e8677;
                                            phi_5253_ = _e8679;
                                            phi_5254_ = false;
                                            phi_5255_ = _e8681;
                                        } else {
                                            phi_3025_ = f64();
                                            phi_3027_ = f64();
                                            phi_3029_ = f64();
                                            phi_3031_ = f64();
                                            phi_3033_ = bool();
                                            phi_3035_ = u32();
                                            phi_5247_ = f64();
                                            phi_5248_ = f64();
                                            phi_5249_ = false;
                                            phi_5250_ = false;
                                            phi_5251_ = false;
                                            phi_5252_ = false;
                                            phi_5253_ = false;
                                            phi_5254_ = true;
                                            phi_5255_ = false;
                                        }
                                        let _e8683 = phi_3025_;
                                        let _e8685 = phi_3027_;
                                        let _e8687 = phi_3029_;
                                        let _e8689 = phi_3031_;
                                        let _e8691 = phi_3033_;
                                        let _e8693 = phi_3035_;
                                        let _e8695 = phi_5247_;
                                        let _e8697 = phi_5248_;
                                        let _e8699 = phi_5249_;
                                        let _e8701 = phi_5250_;
                                        let _e8703 = phi_5251_;
                                        let _e8705 = phi_5252_;
                                        let _e8707 = phi_5253_;
                                        let _e8709 = phi_5254_;
                                        let _e8711 = phi_5255_;
                                        local_43 = _e8701;
                                        local_81 = _e8703;
                                        local_82 = _e8705;
                                        local_83 = _e8707;
                                        local_84 = _e8709;
                                        local_85 = _e8711;
                                        local_86 = _e8701;
                                        local_87 = _e8697;
                                        local_88 = _e8695;
                                        continue;
                                        continuing {
                                            phi_3021_ = _e7237;
                                            phi_3024_ = _e8683;
                                            phi_3026_ = _e8685;
                                            phi_3028_ = _e8687;
                                            phi_3030_ = _e8689;
                                            phi_3032_ = _e8691;
                                            phi_3034_ = _e8693;
                                            break if !(_e8699);
                                        }
                                    }
                                    let _e8714 = local_43;
                                    if _e8714 {
                                        phi_5259_ = false;
                                        phi_5260_ = false;
                                        phi_5261_ = false;
                                        phi_5262_ = false;
                                        phi_5263_ = false;
                                    } else {
                                        let _e12241 = local_81;
                                        phi_5259_ = _e12241;
                                        let _e12244 = local_82;
                                        phi_5260_ = _e12244;
                                        let _e12247 = local_83;
                                        phi_5261_ = _e12247;
                                        let _e12250 = local_84;
                                        phi_5262_ = _e12250;
                                        let _e12253 = local_85;
                                        phi_5263_ = _e12253;
                                    }
                                    let _e8716 = phi_5259_;
                                    let _e8718 = phi_5260_;
                                    let _e8720 = phi_5261_;
                                    let _e8722 = phi_5262_;
                                    let _e8724 = phi_5263_;
                                    if _e8716 {
                                        let _e8726 = local_44;
                                        phi_5268_ = type_43(1u, _e8726);
                                        phi_5269_ = false;
                                        phi_5270_ = false;
                                        phi_5271_ = false;
                                        phi_5272_ = false;
                                        phi_5273_ = false;
                                    } else {
                                        phi_5268_ = type_43();
                                        phi_5269_ = _e8718;
                                        phi_5270_ = _e8720;
                                        let _e12260 = local_86;
                                        phi_5271_ = _e12260;
                                        phi_5272_ = _e8722;
                                        phi_5273_ = _e8724;
                                    }
                                    let _e8729 = phi_5268_;
                                    let _e8731 = phi_5269_;
                                    let _e8733 = phi_5270_;
                                    let _e8735 = phi_5271_;
                                    let _e8737 = phi_5272_;
                                    let _e8739 = phi_5273_;
                                    if _e8731 {
                                        phi_5278_ = type_43(0u, type_43().member_1);
                                        phi_5279_ = false;
                                        phi_5280_ = false;
                                        phi_5281_ = false;
                                        phi_5282_ = false;
                                        phi_5283_ = true;
                                    } else {
                                        phi_5278_ = _e8729;
                                        phi_5279_ = _e8733;
                                        phi_5280_ = _e8735;
                                        phi_5281_ = _e8737;
                                        phi_5282_ = _e8739;
                                        phi_5283_ = _e8716;
                                    }
                                    let _e8743 = phi_5278_;
                                    let _e8745 = phi_5279_;
                                    let _e8747 = phi_5280_;
                                    let _e8749 = phi_5281_;
                                    let _e8751 = phi_5282_;
                                    let _e8753 = phi_5283_;
                                    if _e8745 {
                                        let _e12271 = local_87;
                                        phi_5287_ = _e12271;
                                        phi_5288_ = true;
                                        phi_5289_ = false;
                                        phi_5290_ = false;
                                        phi_5291_ = false;
                                    } else {
                                        let _e12273 = local_88;
                                        phi_5287_ = _e12273;
                                        phi_5288_ = _e8747;
                                        phi_5289_ = _e8749;
                                        phi_5290_ = _e8751;
                                        phi_5291_ = _e8753;
                                    }
                                    let _e8755 = phi_5287_;
                                    let _e8757 = phi_5288_;
                                    let _e8759 = phi_5289_;
                                    let _e8761 = phi_5290_;
                                    let _e8763 = phi_5291_;
                                    if _e8757 {
                                        phi_5295_ = _e8755;
                                        phi_5296_ = true;
                                        phi_5297_ = false;
                                        phi_5298_ = false;
                                    } else {
                                        let _e12280 = local_89;
                                        phi_5295_ = _e12280;
                                        phi_5296_ = _e8759;
                                        phi_5297_ = _e8761;
                                        phi_5298_ = _e8763;
                                    }
                                    let _e8765 = phi_5295_;
                                    let _e8767 = phi_5296_;
                                    let _e8769 = phi_5297_;
                                    let _e8771 = phi_5298_;
                                    if _e8767 {
                                        phi_5303_ = type_43(1u, _e8765);
                                        phi_5304_ = false;
                                        phi_5305_ = false;
                                    } else {
                                        phi_5303_ = type_43();
                                        phi_5304_ = _e8769;
                                        phi_5305_ = _e8771;
                                    }
                                    let _e8774 = phi_5303_;
                                    let _e8776 = phi_5304_;
                                    let _e8778 = phi_5305_;
                                    if _e8776 {
                                        phi_5310_ = type_43(0u, type_43().member_1);
                                        phi_5311_ = true;
                                    } else {
                                        phi_5310_ = _e8743;
                                        phi_5311_ = _e8778;
                                    }
                                    let _e8782 = phi_5310_;
                                    let _e8784 = phi_5311_;
                                    if _e8784 {
                                        phi_5315_ = _e8782;
                                    } else {
                                        phi_5315_ = _e8774;
                                    }
                                    let _e8786 = phi_5315_;
                                    phi_5322_ = _e8786.member_1;
                                    phi_5323_ = (_e8786.member != 0u);
                                } else {
                                    phi_5322_ = _e6925;
                                    phi_5323_ = true;
                                }
                                let _e8791 = phi_5322_;
                                let _e8793 = phi_5323_;
                                if _e8793 {
                                    let _e8794 = (_e8791 > _e548);
                                    if _e8794 {
                                        phi_7530_ = f64();
                                        phi_7531_ = u32();
                                        phi_7532_ = f64();
                                        phi_7533_ = type_45();
                                        phi_7534_ = u32();
                                        phi_7535_ = u32();
                                        phi_7536_ = false;
                                        phi_7537_ = false;
                                        phi_7538_ = false;
                                    } else {
                                        let _e8798 = local_18.member[0u];
                                        let _e8804 = local_18.member[1u];
                                        let _e8820 = local_18.member_1[0u];
                                        let _e8826 = local_18.member_1[1u];
                                        let _e8842 = local_18.member_2[0u];
                                        let _e8848 = local_18.member_2[1u];
                                        let _e8862 = function_4(array<f64, 3>((_e8798[0] + ((_e8804[0] - _e8798[0]) * _e6929)), (_e8798[1] + ((_e8804[1] - _e8798[1]) * _e6929)), (_e8798[2] + ((_e8804[2] - _e8798[2]) * _e6929))), array<f64, 3>((_e8820[0] + ((_e8826[0] - _e8820[0]) * _e6929)), (_e8820[1] + ((_e8826[1] - _e8820[1]) * _e6929)), (_e8820[2] + ((_e8826[2] - _e8820[2]) * _e6929))), array<f64, 3>((_e8842[0] + ((_e8848[0] - _e8842[0]) * _e6929)), (_e8842[1] + ((_e8848[1] - _e8842[1]) * _e6929)), (_e8842[2] + ((_e8848[2] - _e8842[2]) * _e6929))), _e252.member);
                                        if (_e8862[0] < 0.0lf) {
                                            phi_5436_ = -(_e8862[0]);
                                        } else {
                                            phi_5436_ = _e8862[0];
                                        }
                                        let _e8867 = phi_5436_;
                                        if (_e8862[1] < 0.0lf) {
                                            phi_5443_ = -(_e8862[1]);
                                        } else {
                                            phi_5443_ = _e8862[1];
                                        }
                                        let _e8872 = phi_5443_;
                                        if (_e8862[2] < 0.0lf) {
                                            phi_5451_ = -(_e8862[2]);
                                        } else {
                                            phi_5451_ = _e8862[2];
                                        }
                                        let _e8878 = phi_5451_;
                                        let _e8879 = ((_e8867 + _e8872) + _e8878);
                                        let _e8882 = local_18.member[0u];
                                        let _e8889 = local_18.member_1[0u];
                                        let _e8895 = local_18.member_2[0u];
                                        let _e8899 = (_e8882[0] - _e8889[0]);
                                        let _e8900 = (_e8882[1] - _e8889[1]);
                                        let _e8901 = (_e8882[2] - _e8889[2]);
                                        if (_e252.member == 0u) {
                                            phi_5509_ = array<f64, 3>(_e8882[0], _e8882[1], _e8882[2]);
                                        } else {
                                            phi_5509_ = array<f64, 3>((_e8899 - _e8895[0]), (_e8900 - _e8895[1]), (_e8901 - _e8895[2]));
                                        }
                                        let _e8908 = phi_5509_;
                                        let _e8914 = local_18.member[1u];
                                        let _e8921 = local_18.member_1[1u];
                                        let _e8927 = local_18.member_2[1u];
                                        let _e8931 = (_e8914[0] - _e8921[0]);
                                        let _e8932 = (_e8914[1] - _e8921[1]);
                                        let _e8933 = (_e8914[2] - _e8921[2]);
                                        if (_e252.member == 0u) {
                                            phi_5577_ = array<f64, 3>(_e8914[0], _e8914[1], _e8914[2]);
                                        } else {
                                            phi_5577_ = array<f64, 3>((_e8931 - _e8927[0]), (_e8932 - _e8927[1]), (_e8933 - _e8927[2]));
                                        }
                                        let _e8940 = phi_5577_;
                                        let _e8946 = local_18.member[0u];
                                        if (_e8946[0] < 0.0lf) {
                                            phi_5602_ = -(_e8946[0]);
                                        } else {
                                            phi_5602_ = _e8946[0];
                                        }
                                        let _e8953 = phi_5602_;
                                        if (_e8946[1] < 0.0lf) {
                                            phi_5609_ = -(_e8946[1]);
                                        } else {
                                            phi_5609_ = _e8946[1];
                                        }
                                        let _e8957 = phi_5609_;
                                        if (_e8953 > _e8957) {
                                            phi_5614_ = _e8953;
                                        } else {
                                            phi_5614_ = _e8957;
                                        }
                                        let _e8960 = phi_5614_;
                                        if (_e8946[2] < 0.0lf) {
                                            phi_5621_ = -(_e8946[2]);
                                        } else {
                                            phi_5621_ = _e8946[2];
                                        }
                                        let _e8964 = phi_5621_;
                                        if (_e8960 > _e8964) {
                                            phi_5626_ = _e8960;
                                        } else {
                                            phi_5626_ = _e8964;
                                        }
                                        let _e8967 = phi_5626_;
                                        let _e8970 = local_18.member[1u];
                                        if (_e8970[0] < 0.0lf) {
                                            phi_5639_ = -(_e8970[0]);
                                        } else {
                                            phi_5639_ = _e8970[0];
                                        }
                                        let _e8977 = phi_5639_;
                                        if (_e8970[1] < 0.0lf) {
                                            phi_5646_ = -(_e8970[1]);
                                        } else {
                                            phi_5646_ = _e8970[1];
                                        }
                                        let _e8981 = phi_5646_;
                                        if (_e8977 > _e8981) {
                                            phi_5651_ = _e8977;
                                        } else {
                                            phi_5651_ = _e8981;
                                        }
                                        let _e8984 = phi_5651_;
                                        if (_e8970[2] < 0.0lf) {
                                            phi_5658_ = -(_e8970[2]);
                                        } else {
                                            phi_5658_ = _e8970[2];
                                        }
                                        let _e8988 = phi_5658_;
                                        if (_e8984 > _e8988) {
                                            phi_5663_ = _e8984;
                                        } else {
                                            phi_5663_ = _e8988;
                                        }
                                        let _e8991 = phi_5663_;
                                        if (_e8967 > _e8991) {
                                            phi_5668_ = _e8967;
                                        } else {
                                            phi_5668_ = _e8991;
                                        }
                                        let _e8994 = phi_5668_;
                                        let _e8996 = local_18.member_3;
                                        let _e9000 = local_18.member_1[0u];
                                        if (_e9000[0] < 0.0lf) {
                                            phi_5685_ = -(_e9000[0]);
                                        } else {
                                            phi_5685_ = _e9000[0];
                                        }
                                        let _e9007 = phi_5685_;
                                        if (_e9000[1] < 0.0lf) {
                                            phi_5692_ = -(_e9000[1]);
                                        } else {
                                            phi_5692_ = _e9000[1];
                                        }
                                        let _e9011 = phi_5692_;
                                        if (_e9007 > _e9011) {
                                            phi_5697_ = _e9007;
                                        } else {
                                            phi_5697_ = _e9011;
                                        }
                                        let _e9014 = phi_5697_;
                                        if (_e9000[2] < 0.0lf) {
                                            phi_5704_ = -(_e9000[2]);
                                        } else {
                                            phi_5704_ = _e9000[2];
                                        }
                                        let _e9018 = phi_5704_;
                                        if (_e9014 > _e9018) {
                                            phi_5709_ = _e9014;
                                        } else {
                                            phi_5709_ = _e9018;
                                        }
                                        let _e9021 = phi_5709_;
                                        let _e9024 = local_18.member_1[1u];
                                        if (_e9024[0] < 0.0lf) {
                                            phi_5723_ = -(_e9024[0]);
                                        } else {
                                            phi_5723_ = _e9024[0];
                                        }
                                        let _e9031 = phi_5723_;
                                        if (_e9024[1] < 0.0lf) {
                                            phi_5730_ = -(_e9024[1]);
                                        } else {
                                            phi_5730_ = _e9024[1];
                                        }
                                        let _e9035 = phi_5730_;
                                        if (_e9031 > _e9035) {
                                            phi_5735_ = _e9031;
                                        } else {
                                            phi_5735_ = _e9035;
                                        }
                                        let _e9038 = phi_5735_;
                                        if (_e9024[2] < 0.0lf) {
                                            phi_5742_ = -(_e9024[2]);
                                        } else {
                                            phi_5742_ = _e9024[2];
                                        }
                                        let _e9042 = phi_5742_;
                                        if (_e9038 > _e9042) {
                                            phi_5747_ = _e9038;
                                        } else {
                                            phi_5747_ = _e9042;
                                        }
                                        let _e9045 = phi_5747_;
                                        if (_e9021 > _e9045) {
                                            phi_5752_ = _e9021;
                                        } else {
                                            phi_5752_ = _e9045;
                                        }
                                        let _e9048 = phi_5752_;
                                        let _e9050 = local_18.member_3;
                                        let _e9054 = local_18.member_2[0u];
                                        if (_e9054[0] < 0.0lf) {
                                            phi_5769_ = -(_e9054[0]);
                                        } else {
                                            phi_5769_ = _e9054[0];
                                        }
                                        let _e9061 = phi_5769_;
                                        if (_e9054[1] < 0.0lf) {
                                            phi_5776_ = -(_e9054[1]);
                                        } else {
                                            phi_5776_ = _e9054[1];
                                        }
                                        let _e9065 = phi_5776_;
                                        if (_e9061 > _e9065) {
                                            phi_5781_ = _e9061;
                                        } else {
                                            phi_5781_ = _e9065;
                                        }
                                        let _e9068 = phi_5781_;
                                        if (_e9054[2] < 0.0lf) {
                                            phi_5788_ = -(_e9054[2]);
                                        } else {
                                            phi_5788_ = _e9054[2];
                                        }
                                        let _e9072 = phi_5788_;
                                        if (_e9068 > _e9072) {
                                            phi_5793_ = _e9068;
                                        } else {
                                            phi_5793_ = _e9072;
                                        }
                                        let _e9075 = phi_5793_;
                                        let _e9078 = local_18.member_2[1u];
                                        if (_e9078[0] < 0.0lf) {
                                            phi_5807_ = -(_e9078[0]);
                                        } else {
                                            phi_5807_ = _e9078[0];
                                        }
                                        let _e9085 = phi_5807_;
                                        if (_e9078[1] < 0.0lf) {
                                            phi_5814_ = -(_e9078[1]);
                                        } else {
                                            phi_5814_ = _e9078[1];
                                        }
                                        let _e9089 = phi_5814_;
                                        if (_e9085 > _e9089) {
                                            phi_5819_ = _e9085;
                                        } else {
                                            phi_5819_ = _e9089;
                                        }
                                        let _e9092 = phi_5819_;
                                        if (_e9078[2] < 0.0lf) {
                                            phi_5826_ = -(_e9078[2]);
                                        } else {
                                            phi_5826_ = _e9078[2];
                                        }
                                        let _e9096 = phi_5826_;
                                        if (_e9092 > _e9096) {
                                            phi_5831_ = _e9092;
                                        } else {
                                            phi_5831_ = _e9096;
                                        }
                                        let _e9099 = phi_5831_;
                                        if (_e9075 > _e9099) {
                                            phi_5836_ = _e9075;
                                        } else {
                                            phi_5836_ = _e9099;
                                        }
                                        let _e9102 = phi_5836_;
                                        let _e9104 = local_18.member_3;
                                        let _e9112 = local_18.member_3;
                                        local_14 = type_41(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e8882, array<f64, 3>(_e8899, _e8900, _e8901), array<f64, 3>((_e8882[0] - _e8895[0]), (_e8882[1] - _e8895[1]), (_e8882[2] - _e8895[2])), array<f64, 3>(_e8908[0], _e8908[1], _e8908[2])), array<array<f64, 3>, 4>(_e8914, array<f64, 3>(_e8931, _e8932, _e8933), array<f64, 3>((_e8914[0] - _e8927[0]), (_e8914[1] - _e8927[1]), (_e8914[2] - _e8927[2])), array<f64, 3>(_e8940[0], _e8940[1], _e8940[2]))), ((((((_e8994 + _e8996) + (_e9048 + _e9050)) + (_e9102 + _e9104)) * (1.1102230246251565e-16lf * f64(16f))) + (_e9112 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e825.member_1);
                                        let _e9136 = local_14.member_1;
                                        if (_e8879 > _e9136) {
                                            if ((bitcast<u64>(_e8879) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e9142 = (f64(1f) / _e8879);
                                                let _e9144 = (_e8862[0] * _e9142);
                                                let _e9146 = (_e8862[1] * _e9142);
                                                let _e9148 = (_e8862[2] * _e9142);
                                                let _e9153 = (((_e9144 * _e9144) + (_e9146 * _e9146)) + (_e9148 * _e9148));
                                                if (_e9153 <= 2.2250738585072014e-308lf) {
                                                    if (_e9153 > 0.0lf) {
                                                        phi_5941_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_5941_ = 0.0lf;
                                                    }
                                                    let _e9205 = phi_5941_;
                                                    phi_6005_ = _e9205;
                                                } else {
                                                    phi_5948_ = type_18(0i, 5i);
                                                    phi_5951_ = bitcast<f64>(((bitcast<u64>(_e9153) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9160 = phi_5948_;
                                                        let _e9162 = phi_5951_;
                                                        local_45 = _e9162;
                                                        if (_e9160.member < _e9160.member_1) {
                                                            let _e9169 = (_e9160.member + 1i);
                                                            if ((false == (_e9169 > _e9160.member)) != false) {
                                                                phi_5972_ = true;
                                                            } else {
                                                                phi_5972_ = false;
                                                            }
                                                            let _e9174 = phi_5972_;
                                                            if _e9174 {
                                                                phi_5978_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_5978_ = type_19(1u, _e9169);
                                                            }
                                                            let _e9179 = phi_5978_;
                                                            phi_5949_ = type_18(_e9179.member_1, _e9160.member_1);
                                                            phi_5992_ = type_19(1u, _e9160.member);
                                                        } else {
                                                            phi_5949_ = _e9160;
                                                            phi_5992_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e9185 = phi_5949_;
                                                        let _e9187 = phi_5992_;
                                                        let _e9190 = (bitcast<i32>(_e9187.member) != 0i);
                                                        if _e9190 {
                                                            phi_5952_ = (0.5lf * (_e9162 + (_e9153 / _e9162)));
                                                        } else {
                                                            phi_5952_ = f64();
                                                        }
                                                        let _e9195 = phi_5952_;
                                                        continue;
                                                        continuing {
                                                            phi_5948_ = _e9185;
                                                            phi_5951_ = _e9195;
                                                            break if !(_e9190);
                                                        }
                                                    }
                                                    let _e9200 = local_45;
                                                    phi_6005_ = (_e9200 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9207 = phi_6005_;
                                                let _e9209 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e9211 = local_14.member_1;
                                                let _e9215 = local_14.member_2;
                                                let _e9220 = ((_e9211 * f64(1.01f)) + ((_e9215 * _e9207) * (f64(1f) + _e9209)));
                                                let _e9224 = local_14.member[0u][0u];
                                                let _e9232 = (((_e9144 * _e9224[0]) + (_e9146 * _e9224[1])) + (_e9148 * _e9224[2]));
                                                let _e9236 = local_14.member[0u][1u];
                                                let _e9244 = (((_e9144 * _e9236[0]) + (_e9146 * _e9236[1])) + (_e9148 * _e9236[2]));
                                                let _e9248 = local_14.member[0u][2u];
                                                let _e9256 = (((_e9144 * _e9248[0]) + (_e9146 * _e9248[1])) + (_e9148 * _e9248[2]));
                                                let _e9260 = local_14.member[0u][3u];
                                                let _e9268 = (((_e9144 * _e9260[0]) + (_e9146 * _e9260[1])) + (_e9148 * _e9260[2]));
                                                let _e9272 = local_14.member[1u][0u];
                                                let _e9280 = (((_e9144 * _e9272[0]) + (_e9146 * _e9272[1])) + (_e9148 * _e9272[2]));
                                                let _e9284 = local_14.member[1u][1u];
                                                let _e9292 = (((_e9144 * _e9284[0]) + (_e9146 * _e9284[1])) + (_e9148 * _e9284[2]));
                                                let _e9296 = local_14.member[1u][2u];
                                                let _e9304 = (((_e9144 * _e9296[0]) + (_e9146 * _e9296[1])) + (_e9148 * _e9296[2]));
                                                let _e9308 = local_14.member[1u][3u];
                                                let _e9316 = (((_e9144 * _e9308[0]) + (_e9146 * _e9308[1])) + (_e9148 * _e9308[2]));
                                                if (_e9232 < 0.0lf) {
                                                    phi_6142_ = -(_e9232);
                                                } else {
                                                    phi_6142_ = _e9232;
                                                }
                                                let _e9320 = phi_6142_;
                                                if (_e9280 < 0.0lf) {
                                                    phi_6148_ = -(_e9280);
                                                } else {
                                                    phi_6148_ = _e9280;
                                                }
                                                let _e9324 = phi_6148_;
                                                if (_e9244 < 0.0lf) {
                                                    phi_6157_ = -(_e9244);
                                                } else {
                                                    phi_6157_ = _e9244;
                                                }
                                                let _e9331 = phi_6157_;
                                                if (_e9292 < 0.0lf) {
                                                    phi_6163_ = -(_e9292);
                                                } else {
                                                    phi_6163_ = _e9292;
                                                }
                                                let _e9335 = phi_6163_;
                                                if (_e9256 < 0.0lf) {
                                                    phi_6172_ = -(_e9256);
                                                } else {
                                                    phi_6172_ = _e9256;
                                                }
                                                let _e9342 = phi_6172_;
                                                if (_e9304 < 0.0lf) {
                                                    phi_6178_ = -(_e9304);
                                                } else {
                                                    phi_6178_ = _e9304;
                                                }
                                                let _e9346 = phi_6178_;
                                                if (_e9268 < 0.0lf) {
                                                    phi_6187_ = -(_e9268);
                                                } else {
                                                    phi_6187_ = _e9268;
                                                }
                                                let _e9353 = phi_6187_;
                                                if (_e9316 < 0.0lf) {
                                                    phi_6193_ = -(_e9316);
                                                } else {
                                                    phi_6193_ = _e9316;
                                                }
                                                let _e9357 = phi_6193_;
                                                local_15 = type_35(array<f64, 4>(_e9232, _e9244, _e9256, _e9268), array<f64, 4>(_e9280, _e9292, _e9304, _e9316), array<f64, 4>((_e9220 + ((_e9320 + _e9324) * _e9209)), (_e9220 + ((_e9331 + _e9335) * _e9209)), (_e9220 + ((_e9342 + _e9346) * _e9209)), (_e9220 + ((_e9353 + _e9357) * _e9209))));
                                                let _e9369 = (((_e9144 * _e9144) + (_e9146 * _e9146)) + (_e9148 * _e9148));
                                                if (_e9369 <= 2.2250738585072014e-308lf) {
                                                    if (_e9369 > 0.0lf) {
                                                        phi_6236_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6236_ = 0.0lf;
                                                    }
                                                    let _e9421 = phi_6236_;
                                                    phi_6300_ = _e9421;
                                                } else {
                                                    phi_6243_ = type_18(0i, 5i);
                                                    phi_6246_ = bitcast<f64>(((bitcast<u64>(_e9369) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9376 = phi_6243_;
                                                        let _e9378 = phi_6246_;
                                                        local_46 = _e9378;
                                                        if (_e9376.member < _e9376.member_1) {
                                                            let _e9385 = (_e9376.member + 1i);
                                                            if ((false == (_e9385 > _e9376.member)) != false) {
                                                                phi_6267_ = true;
                                                            } else {
                                                                phi_6267_ = false;
                                                            }
                                                            let _e9390 = phi_6267_;
                                                            if _e9390 {
                                                                phi_6273_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_6273_ = type_19(1u, _e9385);
                                                            }
                                                            let _e9395 = phi_6273_;
                                                            phi_6244_ = type_18(_e9395.member_1, _e9376.member_1);
                                                            phi_6287_ = type_19(1u, _e9376.member);
                                                        } else {
                                                            phi_6244_ = _e9376;
                                                            phi_6287_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e9401 = phi_6244_;
                                                        let _e9403 = phi_6287_;
                                                        let _e9406 = (bitcast<i32>(_e9403.member) != 0i);
                                                        if _e9406 {
                                                            phi_6247_ = (0.5lf * (_e9378 + (_e9369 / _e9378)));
                                                        } else {
                                                            phi_6247_ = f64();
                                                        }
                                                        let _e9411 = phi_6247_;
                                                        continue;
                                                        continuing {
                                                            phi_6243_ = _e9401;
                                                            phi_6246_ = _e9411;
                                                            break if !(_e9406);
                                                        }
                                                    }
                                                    let _e9416 = local_46;
                                                    phi_6300_ = (_e9416 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9423 = phi_6300_;
                                                let _e9434 = (((_e8862[0] * _e8862[0]) + (_e8862[1] * _e8862[1])) + (_e8862[2] * _e8862[2]));
                                                if (_e9434 <= 2.2250738585072014e-308lf) {
                                                    if (_e9434 > 0.0lf) {
                                                        phi_6325_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6325_ = 0.0lf;
                                                    }
                                                    let _e9486 = phi_6325_;
                                                    phi_6389_ = _e9486;
                                                } else {
                                                    phi_6332_ = type_18(0i, 5i);
                                                    phi_6335_ = bitcast<f64>(((bitcast<u64>(_e9434) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9441 = phi_6332_;
                                                        let _e9443 = phi_6335_;
                                                        local_47 = _e9443;
                                                        if (_e9441.member < _e9441.member_1) {
                                                            let _e9450 = (_e9441.member + 1i);
                                                            if ((false == (_e9450 > _e9441.member)) != false) {
                                                                phi_6356_ = true;
                                                            } else {
                                                                phi_6356_ = false;
                                                            }
                                                            let _e9455 = phi_6356_;
                                                            if _e9455 {
                                                                phi_6362_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_6362_ = type_19(1u, _e9450);
                                                            }
                                                            let _e9460 = phi_6362_;
                                                            phi_6333_ = type_18(_e9460.member_1, _e9441.member_1);
                                                            phi_6376_ = type_19(1u, _e9441.member);
                                                        } else {
                                                            phi_6333_ = _e9441;
                                                            phi_6376_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e9466 = phi_6333_;
                                                        let _e9468 = phi_6376_;
                                                        let _e9471 = (bitcast<i32>(_e9468.member) != 0i);
                                                        if _e9471 {
                                                            phi_6336_ = (0.5lf * (_e9443 + (_e9434 / _e9443)));
                                                        } else {
                                                            phi_6336_ = f64();
                                                        }
                                                        let _e9476 = phi_6336_;
                                                        continue;
                                                        continuing {
                                                            phi_6332_ = _e9466;
                                                            phi_6335_ = _e9476;
                                                            break if !(_e9471);
                                                        }
                                                    }
                                                    let _e9481 = local_47;
                                                    phi_6389_ = (_e9481 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9488 = phi_6389_;
                                                let _e9496 = local_18.member[0u];
                                                if (_e9496[0] < 0.0lf) {
                                                    phi_6407_ = -(_e9496[0]);
                                                } else {
                                                    phi_6407_ = _e9496[0];
                                                }
                                                let _e9503 = phi_6407_;
                                                if (_e9496[1] < 0.0lf) {
                                                    phi_6414_ = -(_e9496[1]);
                                                } else {
                                                    phi_6414_ = _e9496[1];
                                                }
                                                let _e9507 = phi_6414_;
                                                if (_e9503 > _e9507) {
                                                    phi_6419_ = _e9503;
                                                } else {
                                                    phi_6419_ = _e9507;
                                                }
                                                let _e9510 = phi_6419_;
                                                if (_e9496[2] < 0.0lf) {
                                                    phi_6426_ = -(_e9496[2]);
                                                } else {
                                                    phi_6426_ = _e9496[2];
                                                }
                                                let _e9514 = phi_6426_;
                                                if (_e9510 > _e9514) {
                                                    phi_6431_ = _e9510;
                                                } else {
                                                    phi_6431_ = _e9514;
                                                }
                                                let _e9517 = phi_6431_;
                                                let _e9520 = local_18.member[1u];
                                                if (_e9520[0] < 0.0lf) {
                                                    phi_6444_ = -(_e9520[0]);
                                                } else {
                                                    phi_6444_ = _e9520[0];
                                                }
                                                let _e9527 = phi_6444_;
                                                if (_e9520[1] < 0.0lf) {
                                                    phi_6451_ = -(_e9520[1]);
                                                } else {
                                                    phi_6451_ = _e9520[1];
                                                }
                                                let _e9531 = phi_6451_;
                                                if (_e9527 > _e9531) {
                                                    phi_6456_ = _e9527;
                                                } else {
                                                    phi_6456_ = _e9531;
                                                }
                                                let _e9534 = phi_6456_;
                                                if (_e9520[2] < 0.0lf) {
                                                    phi_6463_ = -(_e9520[2]);
                                                } else {
                                                    phi_6463_ = _e9520[2];
                                                }
                                                let _e9538 = phi_6463_;
                                                if (_e9534 > _e9538) {
                                                    phi_6468_ = _e9534;
                                                } else {
                                                    phi_6468_ = _e9538;
                                                }
                                                let _e9541 = phi_6468_;
                                                if (_e9517 > _e9541) {
                                                    phi_6473_ = _e9517;
                                                } else {
                                                    phi_6473_ = _e9541;
                                                }
                                                let _e9544 = phi_6473_;
                                                let _e9546 = local_18.member_3;
                                                let _e9550 = local_18.member_1[0u];
                                                if (_e9550[0] < 0.0lf) {
                                                    phi_6490_ = -(_e9550[0]);
                                                } else {
                                                    phi_6490_ = _e9550[0];
                                                }
                                                let _e9557 = phi_6490_;
                                                if (_e9550[1] < 0.0lf) {
                                                    phi_6497_ = -(_e9550[1]);
                                                } else {
                                                    phi_6497_ = _e9550[1];
                                                }
                                                let _e9561 = phi_6497_;
                                                if (_e9557 > _e9561) {
                                                    phi_6502_ = _e9557;
                                                } else {
                                                    phi_6502_ = _e9561;
                                                }
                                                let _e9564 = phi_6502_;
                                                if (_e9550[2] < 0.0lf) {
                                                    phi_6509_ = -(_e9550[2]);
                                                } else {
                                                    phi_6509_ = _e9550[2];
                                                }
                                                let _e9568 = phi_6509_;
                                                if (_e9564 > _e9568) {
                                                    phi_6514_ = _e9564;
                                                } else {
                                                    phi_6514_ = _e9568;
                                                }
                                                let _e9571 = phi_6514_;
                                                let _e9574 = local_18.member_1[1u];
                                                if (_e9574[0] < 0.0lf) {
                                                    phi_6528_ = -(_e9574[0]);
                                                } else {
                                                    phi_6528_ = _e9574[0];
                                                }
                                                let _e9581 = phi_6528_;
                                                if (_e9574[1] < 0.0lf) {
                                                    phi_6535_ = -(_e9574[1]);
                                                } else {
                                                    phi_6535_ = _e9574[1];
                                                }
                                                let _e9585 = phi_6535_;
                                                if (_e9581 > _e9585) {
                                                    phi_6540_ = _e9581;
                                                } else {
                                                    phi_6540_ = _e9585;
                                                }
                                                let _e9588 = phi_6540_;
                                                if (_e9574[2] < 0.0lf) {
                                                    phi_6547_ = -(_e9574[2]);
                                                } else {
                                                    phi_6547_ = _e9574[2];
                                                }
                                                let _e9592 = phi_6547_;
                                                if (_e9588 > _e9592) {
                                                    phi_6552_ = _e9588;
                                                } else {
                                                    phi_6552_ = _e9592;
                                                }
                                                let _e9595 = phi_6552_;
                                                if (_e9571 > _e9595) {
                                                    phi_6557_ = _e9571;
                                                } else {
                                                    phi_6557_ = _e9595;
                                                }
                                                let _e9598 = phi_6557_;
                                                let _e9600 = local_18.member_3;
                                                let _e9604 = local_18.member_2[0u];
                                                if (_e9604[0] < 0.0lf) {
                                                    phi_6574_ = -(_e9604[0]);
                                                } else {
                                                    phi_6574_ = _e9604[0];
                                                }
                                                let _e9611 = phi_6574_;
                                                if (_e9604[1] < 0.0lf) {
                                                    phi_6581_ = -(_e9604[1]);
                                                } else {
                                                    phi_6581_ = _e9604[1];
                                                }
                                                let _e9615 = phi_6581_;
                                                if (_e9611 > _e9615) {
                                                    phi_6586_ = _e9611;
                                                } else {
                                                    phi_6586_ = _e9615;
                                                }
                                                let _e9618 = phi_6586_;
                                                if (_e9604[2] < 0.0lf) {
                                                    phi_6593_ = -(_e9604[2]);
                                                } else {
                                                    phi_6593_ = _e9604[2];
                                                }
                                                let _e9622 = phi_6593_;
                                                if (_e9618 > _e9622) {
                                                    phi_6598_ = _e9618;
                                                } else {
                                                    phi_6598_ = _e9622;
                                                }
                                                let _e9625 = phi_6598_;
                                                let _e9628 = local_18.member_2[1u];
                                                if (_e9628[0] < 0.0lf) {
                                                    phi_6612_ = -(_e9628[0]);
                                                } else {
                                                    phi_6612_ = _e9628[0];
                                                }
                                                let _e9635 = phi_6612_;
                                                if (_e9628[1] < 0.0lf) {
                                                    phi_6619_ = -(_e9628[1]);
                                                } else {
                                                    phi_6619_ = _e9628[1];
                                                }
                                                let _e9639 = phi_6619_;
                                                if (_e9635 > _e9639) {
                                                    phi_6624_ = _e9635;
                                                } else {
                                                    phi_6624_ = _e9639;
                                                }
                                                let _e9642 = phi_6624_;
                                                if (_e9628[2] < 0.0lf) {
                                                    phi_6631_ = -(_e9628[2]);
                                                } else {
                                                    phi_6631_ = _e9628[2];
                                                }
                                                let _e9646 = phi_6631_;
                                                if (_e9642 > _e9646) {
                                                    phi_6636_ = _e9642;
                                                } else {
                                                    phi_6636_ = _e9646;
                                                }
                                                let _e9649 = phi_6636_;
                                                if (_e9625 > _e9649) {
                                                    phi_6641_ = _e9625;
                                                } else {
                                                    phi_6641_ = _e9649;
                                                }
                                                let _e9652 = phi_6641_;
                                                let _e9654 = local_18.member_3;
                                                let _e9662 = local_18.member_3;
                                                let _e9677 = ((((_e9488 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e9544 + _e9546) + (_e9598 + _e9600)) + (_e9652 + _e9654)) * (1.1102230246251565e-16lf * f64(16f))) + (_e9662 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e9423) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                                let _e9680 = local_15.member[0u];
                                                let _e9683 = local_15.member_1[0u];
                                                if (_e9680 < 0.0lf) {
                                                    phi_6689_ = -(_e9680);
                                                } else {
                                                    phi_6689_ = _e9680;
                                                }
                                                let _e9689 = phi_6689_;
                                                if (_e9683 < 0.0lf) {
                                                    phi_6695_ = -(_e9683);
                                                } else {
                                                    phi_6695_ = _e9683;
                                                }
                                                let _e9693 = phi_6695_;
                                                phi_6707_ = type_9(1u, 4u);
                                                phi_6710_ = ((_e9680 + ((_e9683 - _e9680) * _e6929)) - ((_e9136 * f64(1.01f)) + ((_e9689 + _e9693) * (1.1102230246251565e-16lf * f64(12f)))));
                                                loop {
                                                    let _e9704 = phi_6707_;
                                                    let _e9706 = phi_6710_;
                                                    local_48 = _e9706;
                                                    local_49 = _e9706;
                                                    if (_e9704.member < _e9704.member_1) {
                                                        phi_6708_ = type_9((_e9704.member + 1u), _e9704.member_1);
                                                        phi_6733_ = type_9(1u, _e9704.member);
                                                    } else {
                                                        phi_6708_ = _e9704;
                                                        phi_6733_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e9718 = phi_6708_;
                                                    let _e9720 = phi_6733_;
                                                    let _e9724 = (bitcast<i32>(_e9720.member) != 0i);
                                                    if _e9724 {
                                                        let _e9727 = local_15.member[_e9720.member_1];
                                                        let _e9730 = local_15.member_1[_e9720.member_1];
                                                        if (_e9727 < 0.0lf) {
                                                            phi_6763_ = -(_e9727);
                                                        } else {
                                                            phi_6763_ = _e9727;
                                                        }
                                                        let _e9736 = phi_6763_;
                                                        if (_e9730 < 0.0lf) {
                                                            phi_6769_ = -(_e9730);
                                                        } else {
                                                            phi_6769_ = _e9730;
                                                        }
                                                        let _e9740 = phi_6769_;
                                                        let _e9749 = ((_e9727 + ((_e9730 - _e9727) * _e6929)) - ((_e9136 * f64(1.01f)) + ((_e9736 + _e9740) * (1.1102230246251565e-16lf * f64(12f)))));
                                                        if (_e9706 < _e9749) {
                                                            phi_6783_ = _e9706;
                                                        } else {
                                                            phi_6783_ = _e9749;
                                                        }
                                                        let _e9752 = phi_6783_;
                                                        phi_6711_ = _e9752;
                                                    } else {
                                                        phi_6711_ = f64();
                                                    }
                                                    let _e9754 = phi_6711_;
                                                    continue;
                                                    continuing {
                                                        phi_6707_ = _e9718;
                                                        phi_6710_ = _e9754;
                                                        break if !(_e9724);
                                                    }
                                                }
                                                let _e9757 = local_48;
                                                if (_e9757 > f64(0f)) {
                                                    let _e9762 = local_49;
                                                    let _e9766 = (((_e9677 - _e9762) / _e9677) * f64(2.02f));
                                                    if (_e9766 <= 2.2250738585072014e-308lf) {
                                                        if (_e9766 > 0.0lf) {
                                                            phi_6805_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_6805_ = 0.0lf;
                                                        }
                                                        let _e9818 = phi_6805_;
                                                        phi_6869_ = _e9818;
                                                    } else {
                                                        phi_6812_ = type_18(0i, 5i);
                                                        phi_6815_ = bitcast<f64>(((bitcast<u64>(_e9766) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e9773 = phi_6812_;
                                                            let _e9775 = phi_6815_;
                                                            local_50 = _e9775;
                                                            if (_e9773.member < _e9773.member_1) {
                                                                let _e9782 = (_e9773.member + 1i);
                                                                if ((false == (_e9782 > _e9773.member)) != false) {
                                                                    phi_6836_ = true;
                                                                } else {
                                                                    phi_6836_ = false;
                                                                }
                                                                let _e9787 = phi_6836_;
                                                                if _e9787 {
                                                                    phi_6842_ = type_19(0u, type_19().member_1);
                                                                } else {
                                                                    phi_6842_ = type_19(1u, _e9782);
                                                                }
                                                                let _e9792 = phi_6842_;
                                                                phi_6813_ = type_18(_e9792.member_1, _e9773.member_1);
                                                                phi_6856_ = type_19(1u, _e9773.member);
                                                            } else {
                                                                phi_6813_ = _e9773;
                                                                phi_6856_ = type_19(0u, type_19().member_1);
                                                            }
                                                            let _e9798 = phi_6813_;
                                                            let _e9800 = phi_6856_;
                                                            let _e9803 = (bitcast<i32>(_e9800.member) != 0i);
                                                            if _e9803 {
                                                                phi_6816_ = (0.5lf * (_e9775 + (_e9766 / _e9775)));
                                                            } else {
                                                                phi_6816_ = f64();
                                                            }
                                                            let _e9808 = phi_6816_;
                                                            continue;
                                                            continuing {
                                                                phi_6812_ = _e9798;
                                                                phi_6815_ = _e9808;
                                                                break if !(_e9803);
                                                            }
                                                        }
                                                        let _e9813 = local_50;
                                                        phi_6869_ = (_e9813 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e9820 = phi_6869_;
                                                    let _e9823 = ((_e9820 * _e9423) * f64(1.01f));
                                                    phi_6876_ = type_9(0u, 4u);
                                                    phi_6879_ = f64(2f);
                                                    phi_6881_ = true;
                                                    phi_6883_ = true;
                                                    loop {
                                                        let _e9826 = phi_6876_;
                                                        let _e9828 = phi_6879_;
                                                        let _e9830 = phi_6881_;
                                                        let _e9832 = phi_6883_;
                                                        local_51 = _e9828;
                                                        local_90 = _e9828;
                                                        local_52 = _e9830;
                                                        local_53 = _e9832;
                                                        local_91 = _e9832;
                                                        local_54 = _e9832;
                                                        if (_e9826.member < _e9826.member_1) {
                                                            phi_6877_ = type_9((_e9826.member + 1u), _e9826.member_1);
                                                            phi_6906_ = type_9(1u, _e9826.member);
                                                        } else {
                                                            phi_6877_ = _e9826;
                                                            phi_6906_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e9844 = phi_6877_;
                                                        let _e9846 = phi_6906_;
                                                        let _e9850 = (bitcast<i32>(_e9846.member) != 0i);
                                                        if _e9850 {
                                                            let _e9854 = local_14.member[0u][_e9846.member_1];
                                                            let _e9861 = local_14.member[1u][_e9846.member_1];
                                                            if (_e9854[0] < 0.0lf) {
                                                                phi_6943_ = -(_e9854[0]);
                                                            } else {
                                                                phi_6943_ = _e9854[0];
                                                            }
                                                            let _e9868 = phi_6943_;
                                                            if (_e9854[1] < 0.0lf) {
                                                                phi_6950_ = -(_e9854[1]);
                                                            } else {
                                                                phi_6950_ = _e9854[1];
                                                            }
                                                            let _e9872 = phi_6950_;
                                                            if (_e9854[2] < 0.0lf) {
                                                                phi_6958_ = -(_e9854[2]);
                                                            } else {
                                                                phi_6958_ = _e9854[2];
                                                            }
                                                            let _e9877 = phi_6958_;
                                                            let _e9878 = ((_e9868 + _e9872) + _e9877);
                                                            if (_e9861[0] < 0.0lf) {
                                                                phi_6966_ = -(_e9861[0]);
                                                            } else {
                                                                phi_6966_ = _e9861[0];
                                                            }
                                                            let _e9882 = phi_6966_;
                                                            if (_e9861[1] < 0.0lf) {
                                                                phi_6973_ = -(_e9861[1]);
                                                            } else {
                                                                phi_6973_ = _e9861[1];
                                                            }
                                                            let _e9886 = phi_6973_;
                                                            if (_e9861[2] < 0.0lf) {
                                                                phi_6981_ = -(_e9861[2]);
                                                            } else {
                                                                phi_6981_ = _e9861[2];
                                                            }
                                                            let _e9891 = phi_6981_;
                                                            let _e9892 = ((_e9882 + _e9886) + _e9891);
                                                            if (_e9878 > _e9892) {
                                                                phi_6987_ = _e9878;
                                                            } else {
                                                                phi_6987_ = _e9892;
                                                            }
                                                            let _e9895 = phi_6987_;
                                                            let _e9901 = (_e9861[0] - _e9854[0]);
                                                            let _e9902 = (_e9861[1] - _e9854[1]);
                                                            let _e9903 = (_e9861[2] - _e9854[2]);
                                                            if (_e9901 < 0.0lf) {
                                                                phi_7007_ = -(_e9901);
                                                            } else {
                                                                phi_7007_ = _e9901;
                                                            }
                                                            let _e9907 = phi_7007_;
                                                            if (_e9902 < 0.0lf) {
                                                                phi_7013_ = -(_e9902);
                                                            } else {
                                                                phi_7013_ = _e9902;
                                                            }
                                                            let _e9911 = phi_7013_;
                                                            if (_e9903 < 0.0lf) {
                                                                phi_7020_ = -(_e9903);
                                                            } else {
                                                                phi_7020_ = _e9903;
                                                            }
                                                            let _e9916 = phi_7020_;
                                                            let _e9925 = local_15.member[_e9846.member_1];
                                                            let _e9928 = local_15.member_1[_e9846.member_1];
                                                            if (_e9925 < 0.0lf) {
                                                                phi_7049_ = -(_e9925);
                                                            } else {
                                                                phi_7049_ = _e9925;
                                                            }
                                                            let _e9934 = phi_7049_;
                                                            if (_e9928 < 0.0lf) {
                                                                phi_7055_ = -(_e9928);
                                                            } else {
                                                                phi_7055_ = _e9928;
                                                            }
                                                            let _e9938 = phi_7055_;
                                                            let _e9943 = ((_e9136 * f64(1.01f)) + ((_e9934 + _e9938) * (1.1102230246251565e-16lf * f64(12f))));
                                                            let _e9950 = local_15.member_1[_e9846.member_1];
                                                            let _e9953 = local_15.member[_e9846.member_1];
                                                            let _e9954 = (_e9950 - _e9953);
                                                            let _e9957 = ((_e9943 + _e9943) + (_e9823 * ((((_e9907 + _e9911) + _e9916) + (_e9136 * f64(6f))) * f64(1.01f))));
                                                            let _e9960 = ((((_e9925 + ((_e9928 - _e9925) * _e6929)) - _e9943) - (_e9823 * ((_e9895 + (_e9136 * f64(3f))) * f64(1.01f)))) - _e9677);
                                                            let _e9961 = (_e9960 > 2.2250738585072014e-308lf);
                                                            let _e9962 = (_e9954 > _e9957);
                                                            if _e9962 {
                                                                phi_7092_ = true;
                                                            } else {
                                                                phi_7092_ = _e9961;
                                                            }
                                                            let _e9964 = phi_7092_;
                                                            if (_e9954 < -(_e9957)) {
                                                                phi_7099_ = true;
                                                            } else {
                                                                phi_7099_ = _e9961;
                                                            }
                                                            let _e9969 = phi_7099_;
                                                            if _e9962 {
                                                                phi_7120_ = _e9828;
                                                            } else {
                                                                if _e9961 {
                                                                    let _e9971 = (_e9957 - _e9954);
                                                                    if (_e9971 > 2.2250738585072014e-308lf) {
                                                                        phi_7112_ = _e9971;
                                                                    } else {
                                                                        phi_7112_ = 2.2250738585072014e-308lf;
                                                                    }
                                                                    let _e9974 = phi_7112_;
                                                                    let _e9975 = (_e9960 / _e9974);
                                                                    if (_e9828 < _e9975) {
                                                                        phi_7118_ = _e9828;
                                                                    } else {
                                                                        phi_7118_ = _e9975;
                                                                    }
                                                                    let _e9978 = phi_7118_;
                                                                    phi_7119_ = _e9978;
                                                                } else {
                                                                    phi_7119_ = _e9828;
                                                                }
                                                                let _e9980 = phi_7119_;
                                                                phi_7120_ = _e9980;
                                                            }
                                                            let _e9982 = phi_7120_;
                                                            phi_6880_ = _e9982;
                                                            phi_6882_ = (_e9830 && _e9969);
                                                            phi_6884_ = (_e9832 && _e9964);
                                                        } else {
                                                            phi_6880_ = f64();
                                                            phi_6882_ = bool();
                                                            phi_6884_ = bool();
                                                        }
                                                        let _e9984 = phi_6880_;
                                                        let _e9986 = phi_6882_;
                                                        let _e9988 = phi_6884_;
                                                        continue;
                                                        continuing {
                                                            phi_6876_ = _e9844;
                                                            phi_6879_ = _e9984;
                                                            phi_6881_ = _e9986;
                                                            phi_6883_ = _e9988;
                                                            break if !(_e9850);
                                                        }
                                                    }
                                                    let _e9990 = f64(2f);
                                                    let _e9992 = local_51;
                                                    if (_e9992 < _e9990) {
                                                        let _e12453 = local_90;
                                                        phi_7126_ = _e12453;
                                                    } else {
                                                        phi_7126_ = _e9990;
                                                    }
                                                    let _e9995 = phi_7126_;
                                                    let _e9997 = (_e9995 * f64(0.999f));
                                                    let _e9999 = local_52;
                                                    if _e9999 {
                                                        let _e10001 = local_53;
                                                        if _e10001 {
                                                            phi_7137_ = type_45();
                                                        } else {
                                                            phi_7137_ = type_45(_e6929, f64(2f), 1u);
                                                        }
                                                        let _e10005 = phi_7137_;
                                                        phi_7138_ = _e10005;
                                                        let _e12460 = local_91;
                                                        phi_7139_ = _e12460;
                                                    } else {
                                                        phi_7138_ = type_45();
                                                        phi_7139_ = true;
                                                    }
                                                    let _e10007 = phi_7138_;
                                                    let _e10009 = phi_7139_;
                                                    if _e10009 {
                                                        let _e10011 = local_54;
                                                        if _e10011 {
                                                            if (_e9997 > (1.1102230246251565e-16lf * f64(4096f))) {
                                                                let _e10017 = (_e6929 + _e9997);
                                                                if (_e10017 < _e557) {
                                                                    phi_7157_ = _e10017;
                                                                } else {
                                                                    phi_7157_ = _e557;
                                                                }
                                                                let _e10020 = phi_7157_;
                                                                phi_7158_ = _e10020;
                                                            } else {
                                                                phi_7158_ = _e6929;
                                                            }
                                                            let _e10022 = phi_7158_;
                                                            phi_7161_ = type_9(0u, 4u);
                                                            phi_7164_ = _e10022;
                                                            phi_7166_ = _e6929;
                                                            loop {
                                                                let _e10024 = phi_7161_;
                                                                let _e10026 = phi_7164_;
                                                                let _e10028 = phi_7166_;
                                                                local_55 = _e10026;
                                                                local_56 = _e10028;
                                                                local_57 = _e10028;
                                                                if (_e10024.member < _e10024.member_1) {
                                                                    phi_7162_ = type_9((_e10024.member + 1u), _e10024.member_1);
                                                                    phi_7189_ = type_9(1u, _e10024.member);
                                                                } else {
                                                                    phi_7162_ = _e10024;
                                                                    phi_7189_ = type_9(0u, type_9().member_1);
                                                                }
                                                                let _e10040 = phi_7162_;
                                                                let _e10042 = phi_7189_;
                                                                let _e10046 = (bitcast<i32>(_e10042.member) != 0i);
                                                                if _e10046 {
                                                                    let _e10049 = local_15.member[_e10042.member_1];
                                                                    let _e10052 = local_15.member_1[_e10042.member_1];
                                                                    let _e10055 = local_15.member[_e10042.member_1];
                                                                    let _e10061 = local_15.member_2[_e10042.member_1];
                                                                    let _e10062 = ((_e10049 + ((_e10052 - _e10055) * _e6929)) - _e10061);
                                                                    let _e10065 = local_15.member_1[_e10042.member_1];
                                                                    let _e10068 = local_15.member[_e10042.member_1];
                                                                    let _e10069 = (_e10065 - _e10068);
                                                                    if (_e10069 > f64(0f)) {
                                                                        let _e10086 = (_e6929 - (_e10062 / _e10069));
                                                                        if (_e10028 > _e10086) {
                                                                            phi_7258_ = _e10028;
                                                                        } else {
                                                                            phi_7258_ = _e10086;
                                                                        }
                                                                        let _e10089 = phi_7258_;
                                                                        phi_7278_ = _e10026;
                                                                        phi_7279_ = _e10089;
                                                                    } else {
                                                                        if (_e10062 > f64(0f)) {
                                                                            if (_e10069 < f64(0f)) {
                                                                                let _e10077 = (_e6929 - (_e10062 / _e10069));
                                                                                if (_e10026 < _e10077) {
                                                                                    phi_7275_ = _e10026;
                                                                                } else {
                                                                                    phi_7275_ = _e10077;
                                                                                }
                                                                                let _e10080 = phi_7275_;
                                                                                phi_7276_ = _e10080;
                                                                            } else {
                                                                                phi_7276_ = _e10026;
                                                                            }
                                                                            let _e10082 = phi_7276_;
                                                                            phi_7277_ = _e10082;
                                                                        } else {
                                                                            phi_7277_ = _e10026;
                                                                        }
                                                                        let _e10084 = phi_7277_;
                                                                        phi_7278_ = _e10084;
                                                                        phi_7279_ = _e10028;
                                                                    }
                                                                    let _e10091 = phi_7278_;
                                                                    let _e10093 = phi_7279_;
                                                                    phi_7165_ = _e10091;
                                                                    phi_7167_ = _e10093;
                                                                } else {
                                                                    phi_7165_ = f64();
                                                                    phi_7167_ = f64();
                                                                }
                                                                let _e10095 = phi_7165_;
                                                                let _e10097 = phi_7167_;
                                                                continue;
                                                                continuing {
                                                                    phi_7161_ = _e10040;
                                                                    phi_7164_ = _e10095;
                                                                    phi_7166_ = _e10097;
                                                                    break if !(_e10046);
                                                                }
                                                            }
                                                            let _e10100 = local_55;
                                                            let _e10102 = local_56;
                                                            let _e10107 = local_57;
                                                            let _e10108 = (_e10107 + ((_e10100 - _e10102) * f64(0.5f)));
                                                            if (_e10108 > _e6929) {
                                                                if (_e10108 <= _e10022) {
                                                                    let _e10111 = f64(0f);
                                                                    let _e10114 = local_15.member[0u];
                                                                    let _e10117 = local_15.member_1[0u];
                                                                    let _e10120 = local_15.member[0u];
                                                                    let _e10126 = local_15.member_2[0u];
                                                                    if (((_e10114 + ((_e10117 - _e10120) * _e10108)) - _e10126) > _e10111) {
                                                                        let _e10131 = local_15.member[1u];
                                                                        let _e10134 = local_15.member_1[1u];
                                                                        let _e10137 = local_15.member[1u];
                                                                        let _e10143 = local_15.member_2[1u];
                                                                        if (((_e10131 + ((_e10134 - _e10137) * _e10108)) - _e10143) > _e10111) {
                                                                            let _e10148 = local_15.member[2u];
                                                                            let _e10151 = local_15.member_1[2u];
                                                                            let _e10154 = local_15.member[2u];
                                                                            let _e10160 = local_15.member_2[2u];
                                                                            if (((_e10148 + ((_e10151 - _e10154) * _e10108)) - _e10160) > _e10111) {
                                                                                let _e10165 = local_15.member[3u];
                                                                                let _e10168 = local_15.member_1[3u];
                                                                                let _e10171 = local_15.member[3u];
                                                                                let _e10177 = local_15.member_2[3u];
                                                                                phi_7442_ = (((_e10165 + ((_e10168 - _e10171) * _e10108)) - _e10177) > _e10111);
                                                                                phi_7443_ = false;
                                                                            } else {
                                                                                phi_7442_ = bool();
                                                                                phi_7443_ = true;
                                                                            }
                                                                            let _e10181 = phi_7442_;
                                                                            let _e10183 = phi_7443_;
                                                                            phi_7444_ = _e10181;
                                                                            phi_7445_ = _e10183;
                                                                        } else {
                                                                            phi_7444_ = bool();
                                                                            phi_7445_ = true;
                                                                        }
                                                                        let _e10185 = phi_7444_;
                                                                        let _e10187 = phi_7445_;
                                                                        phi_7446_ = _e10185;
                                                                        phi_7447_ = _e10187;
                                                                    } else {
                                                                        phi_7446_ = bool();
                                                                        phi_7447_ = true;
                                                                    }
                                                                    let _e10189 = phi_7446_;
                                                                    let _e10191 = phi_7447_;
                                                                    if _e10191 {
                                                                        phi_7451_ = false;
                                                                    } else {
                                                                        phi_7451_ = _e10189;
                                                                    }
                                                                    let _e10193 = phi_7451_;
                                                                    if _e10193 {
                                                                        phi_7455_ = false;
                                                                    } else {
                                                                        phi_7455_ = true;
                                                                    }
                                                                    let _e10195 = phi_7455_;
                                                                    phi_7456_ = _e10195;
                                                                } else {
                                                                    phi_7456_ = true;
                                                                }
                                                                let _e10197 = phi_7456_;
                                                                phi_7457_ = _e10197;
                                                            } else {
                                                                phi_7457_ = true;
                                                            }
                                                            let _e10199 = phi_7457_;
                                                            if _e10199 {
                                                                phi_7462_ = f64(2f);
                                                            } else {
                                                                phi_7462_ = _e10108;
                                                            }
                                                            let _e10202 = phi_7462_;
                                                            phi_7466_ = type_45(_e10022, _e10202, 2u);
                                                            phi_7467_ = type_45();
                                                            phi_7468_ = false;
                                                        } else {
                                                            phi_7466_ = type_45();
                                                            phi_7467_ = type_45(_e6929, f64(2f), 0u);
                                                            phi_7468_ = true;
                                                        }
                                                        let _e10205 = phi_7466_;
                                                        let _e10207 = phi_7467_;
                                                        let _e10209 = phi_7468_;
                                                        phi_7469_ = _e10205;
                                                        phi_7470_ = _e10207;
                                                        phi_7471_ = _e10209;
                                                    } else {
                                                        phi_7469_ = type_45();
                                                        phi_7470_ = _e10007;
                                                        phi_7471_ = true;
                                                    }
                                                    let _e10211 = phi_7469_;
                                                    let _e10213 = phi_7470_;
                                                    let _e10215 = phi_7471_;
                                                    phi_7477_ = _e10213;
                                                    phi_7478_ = _e10211;
                                                    phi_7479_ = _e10215;
                                                } else {
                                                    phi_7477_ = type_45(_e6929, f64(2f), 0u);
                                                    phi_7478_ = type_45();
                                                    phi_7479_ = true;
                                                }
                                                let _e10217 = phi_7477_;
                                                let _e10219 = phi_7478_;
                                                let _e10221 = phi_7479_;
                                                phi_7483_ = _e10217;
                                                phi_7484_ = _e10219;
                                                phi_7485_ = false;
                                                phi_7486_ = _e10221;
                                            } else {
                                                phi_7483_ = type_45();
                                                phi_7484_ = type_45();
                                                phi_7485_ = true;
                                                phi_7486_ = false;
                                            }
                                            let _e10223 = phi_7483_;
                                            let _e10225 = phi_7484_;
                                            let _e10227 = phi_7485_;
                                            let _e10229 = phi_7486_;
                                            phi_7487_ = _e10223;
                                            phi_7488_ = _e10225;
                                            phi_7489_ = _e10227;
                                            phi_7490_ = _e10229;
                                        } else {
                                            phi_7487_ = type_45();
                                            phi_7488_ = type_45();
                                            phi_7489_ = true;
                                            phi_7490_ = false;
                                        }
                                        let _e10231 = phi_7487_;
                                        let _e10233 = phi_7488_;
                                        let _e10235 = phi_7489_;
                                        let _e10237 = phi_7490_;
                                        if _e10235 {
                                            phi_7496_ = type_45(_e6929, f64(2f), 0u);
                                            phi_7497_ = true;
                                        } else {
                                            phi_7496_ = _e10231;
                                            phi_7497_ = _e10237;
                                        }
                                        let _e10241 = phi_7496_;
                                        let _e10243 = phi_7497_;
                                        if _e10243 {
                                            phi_7501_ = _e10241;
                                        } else {
                                            phi_7501_ = _e10233;
                                        }
                                        let _e10245 = phi_7501_;
                                        if ((_e559 & 64u) != 0u) {
                                            if (_e10245.member_2 == 2u) {
                                                let _e10249 = (_e10245.member_1 <= _e557);
                                                if _e10249 {
                                                    phi_7517_ = _e10245.member_1;
                                                    phi_7518_ = _e10245.member_1;
                                                    phi_7519_ = false;
                                                } else {
                                                    phi_7517_ = f64();
                                                    phi_7518_ = f64();
                                                    phi_7519_ = true;
                                                }
                                                let _e10253 = phi_7517_;
                                                let _e10255 = phi_7518_;
                                                let _e10257 = phi_7519_;
                                                phi_7520_ = _e10253;
                                                phi_7521_ = _e10255;
                                                phi_7522_ = _e10249;
                                                phi_7523_ = _e10257;
                                                phi_7524_ = false;
                                            } else {
                                                phi_7520_ = f64();
                                                phi_7521_ = f64();
                                                phi_7522_ = false;
                                                phi_7523_ = false;
                                                phi_7524_ = true;
                                            }
                                            let _e10259 = phi_7520_;
                                            let _e10261 = phi_7521_;
                                            let _e10263 = phi_7522_;
                                            let _e10265 = phi_7523_;
                                            let _e10267 = phi_7524_;
                                            phi_7525_ = _e10259;
                                            phi_7526_ = _e10261;
                                            phi_7527_ = _e10263;
                                            phi_7528_ = _e10265;
                                            phi_7529_ = _e10267;
                                        } else {
                                            phi_7525_ = f64();
                                            phi_7526_ = f64();
                                            phi_7527_ = false;
                                            phi_7528_ = false;
                                            phi_7529_ = true;
                                        }
                                        let _e10269 = phi_7525_;
                                        let _e10271 = phi_7526_;
                                        let _e10273 = phi_7527_;
                                        let _e10275 = phi_7528_;
                                        let _e10277 = phi_7529_;
                                        phi_7530_ = _e10269;
                                        phi_7531_ = _e10245.member_2;
                                        phi_7532_ = _e10271;
                                        phi_7533_ = _e10245;
                                        phi_7534_ = _e10245.member_2;
                                        phi_7535_ = _e10245.member_2;
                                        phi_7536_ = _e10273;
                                        phi_7537_ = _e10275;
                                        phi_7538_ = _e10277;
                                    }
                                    let _e10279 = phi_7530_;
                                    let _e10281 = phi_7531_;
                                    let _e10283 = phi_7532_;
                                    let _e10285 = phi_7533_;
                                    let _e10287 = phi_7534_;
                                    let _e10289 = phi_7535_;
                                    let _e10291 = phi_7536_;
                                    let _e10293 = phi_7537_;
                                    let _e10295 = phi_7538_;
                                    phi_7539_ = _e10279;
                                    phi_7540_ = _e10281;
                                    phi_7541_ = _e10283;
                                    phi_7542_ = _e10285;
                                    phi_7543_ = _e10287;
                                    phi_7544_ = _e10289;
                                    phi_7545_ = _e10291;
                                    phi_7546_ = _e8794;
                                    phi_7547_ = _e10293;
                                    phi_7548_ = _e10295;
                                    phi_7549_ = false;
                                } else {
                                    phi_7539_ = f64();
                                    phi_7540_ = u32();
                                    phi_7541_ = f64();
                                    phi_7542_ = type_45();
                                    phi_7543_ = u32();
                                    phi_7544_ = u32();
                                    phi_7545_ = false;
                                    phi_7546_ = false;
                                    phi_7547_ = false;
                                    phi_7548_ = false;
                                    phi_7549_ = true;
                                }
                                let _e10297 = phi_7539_;
                                let _e10299 = phi_7540_;
                                let _e10301 = phi_7541_;
                                let _e10303 = phi_7542_;
                                let _e10305 = phi_7543_;
                                let _e10307 = phi_7544_;
                                let _e10309 = phi_7545_;
                                let _e10311 = phi_7546_;
                                let _e10313 = phi_7547_;
                                let _e10315 = phi_7548_;
                                let _e10317 = phi_7549_;
                                phi_7550_ = _e8791;
                                phi_2534_ = _e10297;
                                phi_2536_ = _e10299;
                                phi_2538_ = _e10301;
                                phi_7551_ = _e10303;
                                phi_7552_ = _e10305;
                                phi_7553_ = _e8791;
                                phi_7554_ = _e10307;
                                phi_7555_ = _e10309;
                                phi_7556_ = _e10311;
                                phi_7557_ = _e10313;
                                phi_7558_ = _e10315;
                                phi_7559_ = false;
                                phi_7560_ = _e10317;
                            } else {
                                phi_7550_ = f64();
                                phi_2534_ = f64();
                                phi_2536_ = u32();
                                phi_2538_ = f64();
                                phi_7551_ = type_45();
                                phi_7552_ = u32();
                                phi_7553_ = f64();
                                phi_7554_ = u32();
                                phi_7555_ = false;
                                phi_7556_ = false;
                                phi_7557_ = false;
                                phi_7558_ = false;
                                phi_7559_ = true;
                                phi_7560_ = false;
                            }
                            let _e10319 = phi_7550_;
                            let _e10321 = phi_2534_;
                            let _e10323 = phi_2536_;
                            let _e10325 = phi_2538_;
                            let _e10327 = phi_7551_;
                            let _e10329 = phi_7552_;
                            let _e10331 = phi_7553_;
                            let _e10333 = phi_7554_;
                            let _e10335 = phi_7555_;
                            let _e10337 = phi_7556_;
                            let _e10339 = phi_7557_;
                            let _e10341 = phi_7558_;
                            let _e10343 = phi_7559_;
                            let _e10345 = phi_7560_;
                            local_58 = _e10337;
                            local_92 = _e10339;
                            local_93 = _e10341;
                            local_94 = _e10343;
                            local_95 = _e10345;
                            local_59 = _e10327;
                            local_60 = _e10327;
                            local_96 = _e10329;
                            local_61 = _e10327;
                            local_97 = _e10337;
                            local_98 = _e10333;
                            local_100 = _e10331;
                            local_101 = _e10319;
                            continue;
                            continuing {
                                phi_2530_ = _e6952;
                                phi_2533_ = _e10321;
                                phi_2535_ = _e10323;
                                phi_2537_ = _e10325;
                                break if !(_e10335);
                            }
                        }
                        let _e10348 = local_58;
                        if _e10348 {
                            phi_7564_ = false;
                            phi_7565_ = false;
                            phi_7566_ = false;
                            phi_7567_ = false;
                        } else {
                            let _e12561 = local_92;
                            phi_7564_ = _e12561;
                            let _e12564 = local_93;
                            phi_7565_ = _e12564;
                            let _e12567 = local_94;
                            phi_7566_ = _e12567;
                            let _e12570 = local_95;
                            phi_7567_ = _e12570;
                        }
                        let _e10350 = phi_7564_;
                        let _e10352 = phi_7565_;
                        let _e10354 = phi_7566_;
                        let _e10356 = phi_7567_;
                        if _e10350 {
                            let _e10358 = local_59;
                            if (_e10358.member >= _e557) {
                                phi_7589_ = type_44(type_43(0u, f64()), 0u);
                            } else {
                                let _e10362 = local_60;
                                if (_e10362.member > _e548) {
                                    phi_7584_ = 0u;
                                } else {
                                    let _e12575 = local_96;
                                    phi_7584_ = _e12575;
                                }
                                let _e10366 = phi_7584_;
                                let _e10368 = local_61;
                                phi_7589_ = type_44(type_43(2u, _e10368.member), _e10366);
                            }
                            let _e10375 = phi_7589_;
                            phi_7590_ = _e10375;
                            phi_7591_ = false;
                            phi_7592_ = false;
                            phi_7593_ = false;
                            phi_7594_ = false;
                        } else {
                            phi_7590_ = type_44();
                            phi_7591_ = _e10352;
                            let _e12582 = local_97;
                            phi_7592_ = _e12582;
                            phi_7593_ = _e10354;
                            phi_7594_ = _e10356;
                        }
                        let _e10377 = phi_7590_;
                        let _e10379 = phi_7591_;
                        let _e10381 = phi_7592_;
                        let _e10383 = phi_7593_;
                        let _e10385 = phi_7594_;
                        if _e10379 {
                            let _e12587 = local_98;
                            phi_7598_ = _e12587;
                            let _e12592 = local_100;
                            phi_7599_ = _e12592;
                            phi_7600_ = true;
                            phi_7601_ = false;
                            phi_7602_ = false;
                            phi_7603_ = false;
                        } else {
                            let _e12589 = local_99;
                            phi_7598_ = _e12589;
                            let _e12594 = local_101;
                            phi_7599_ = _e12594;
                            phi_7600_ = _e10381;
                            phi_7601_ = _e10383;
                            phi_7602_ = _e10385;
                            phi_7603_ = _e10350;
                        }
                        let _e10387 = phi_7598_;
                        let _e10389 = phi_7599_;
                        let _e10391 = phi_7600_;
                        let _e10393 = phi_7601_;
                        let _e10395 = phi_7602_;
                        let _e10397 = phi_7603_;
                        if _e10391 {
                            phi_7607_ = _e10389;
                            phi_7608_ = _e10387;
                            phi_7609_ = true;
                            phi_7610_ = false;
                            phi_7611_ = false;
                        } else {
                            let _e12601 = local_102;
                            phi_7607_ = _e12601;
                            let _e12604 = local_103;
                            phi_7608_ = _e12604;
                            phi_7609_ = _e10393;
                            phi_7610_ = _e10395;
                            phi_7611_ = _e10397;
                        }
                        let _e10399 = phi_7607_;
                        let _e10401 = phi_7608_;
                        let _e10403 = phi_7609_;
                        let _e10405 = phi_7610_;
                        let _e10407 = phi_7611_;
                        if _e10403 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e539 >= (1.1102230246251565e-16lf * f64(8f))) {
                                phi_7625_ = _e539;
                            } else {
                                phi_7625_ = f64(0f);
                            }
                            let _e10416 = phi_7625_;
                            phi_7628_ = type_9(0u, 3u);
                            loop {
                                let _e10418 = phi_7628_;
                                if (_e10418.member < _e10418.member_1) {
                                    phi_7629_ = type_9((_e10418.member + 1u), _e10418.member_1);
                                    phi_7652_ = type_9(1u, _e10418.member);
                                } else {
                                    phi_7629_ = _e10418;
                                    phi_7652_ = type_9(0u, type_9().member_1);
                                }
                                let _e10430 = phi_7629_;
                                let _e10432 = phi_7652_;
                                if (bitcast<i32>(_e10432.member) != 0i) {
                                    let _e10438 = local_13[_e10432.member_1];
                                    let _e10441 = (_e10399 + (_e10416 * f64(_e10438)));
                                    if (_e10441 < _e557) {
                                        phi_7674_ = _e10441;
                                    } else {
                                        phi_7674_ = _e557;
                                    }
                                    let _e10444 = phi_7674_;
                                    let _e10447 = local_18.member[0u];
                                    let _e10453 = local_18.member[1u];
                                    let _e10469 = local_18.member_1[0u];
                                    let _e10475 = local_18.member_1[1u];
                                    let _e10491 = local_18.member_2[0u];
                                    let _e10497 = local_18.member_2[1u];
                                    let _e10511 = function_4(array<f64, 3>((_e10447[0] + ((_e10453[0] - _e10447[0]) * _e10444)), (_e10447[1] + ((_e10453[1] - _e10447[1]) * _e10444)), (_e10447[2] + ((_e10453[2] - _e10447[2]) * _e10444))), array<f64, 3>((_e10469[0] + ((_e10475[0] - _e10469[0]) * _e10444)), (_e10469[1] + ((_e10475[1] - _e10469[1]) * _e10444)), (_e10469[2] + ((_e10475[2] - _e10469[2]) * _e10444))), array<f64, 3>((_e10491[0] + ((_e10497[0] - _e10491[0]) * _e10444)), (_e10491[1] + ((_e10497[1] - _e10491[1]) * _e10444)), (_e10491[2] + ((_e10497[2] - _e10491[2]) * _e10444))), _e252.member);
                                    let _e10522 = (((_e10511[0] * _e10511[0]) + (_e10511[1] * _e10511[1])) + (_e10511[2] * _e10511[2]));
                                    if (_e10522 <= 2.2250738585072014e-308lf) {
                                        if (_e10522 > 0.0lf) {
                                            phi_7797_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_7797_ = 0.0lf;
                                        }
                                        let _e10574 = phi_7797_;
                                        phi_7861_ = _e10574;
                                    } else {
                                        phi_7804_ = type_18(0i, 5i);
                                        phi_7807_ = bitcast<f64>(((bitcast<u64>(_e10522) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e10529 = phi_7804_;
                                            let _e10531 = phi_7807_;
                                            local_62 = _e10531;
                                            if (_e10529.member < _e10529.member_1) {
                                                let _e10538 = (_e10529.member + 1i);
                                                if ((false == (_e10538 > _e10529.member)) != false) {
                                                    phi_7828_ = true;
                                                } else {
                                                    phi_7828_ = false;
                                                }
                                                let _e10543 = phi_7828_;
                                                if _e10543 {
                                                    phi_7834_ = type_19(0u, type_19().member_1);
                                                } else {
                                                    phi_7834_ = type_19(1u, _e10538);
                                                }
                                                let _e10548 = phi_7834_;
                                                phi_7805_ = type_18(_e10548.member_1, _e10529.member_1);
                                                phi_7848_ = type_19(1u, _e10529.member);
                                            } else {
                                                phi_7805_ = _e10529;
                                                phi_7848_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e10554 = phi_7805_;
                                            let _e10556 = phi_7848_;
                                            let _e10559 = (bitcast<i32>(_e10556.member) != 0i);
                                            if _e10559 {
                                                phi_7808_ = (0.5lf * (_e10531 + (_e10522 / _e10531)));
                                            } else {
                                                phi_7808_ = f64();
                                            }
                                            let _e10564 = phi_7808_;
                                            continue;
                                            continuing {
                                                phi_7804_ = _e10554;
                                                phi_7807_ = _e10564;
                                                break if !(_e10559);
                                            }
                                        }
                                        let _e10569 = local_62;
                                        phi_7861_ = (_e10569 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e10576 = phi_7861_;
                                    let _e10584 = local_18.member[0u];
                                    if (_e10584[0] < 0.0lf) {
                                        phi_7879_ = -(_e10584[0]);
                                    } else {
                                        phi_7879_ = _e10584[0];
                                    }
                                    let _e10591 = phi_7879_;
                                    if (_e10584[1] < 0.0lf) {
                                        phi_7886_ = -(_e10584[1]);
                                    } else {
                                        phi_7886_ = _e10584[1];
                                    }
                                    let _e10595 = phi_7886_;
                                    if (_e10591 > _e10595) {
                                        phi_7891_ = _e10591;
                                    } else {
                                        phi_7891_ = _e10595;
                                    }
                                    let _e10598 = phi_7891_;
                                    if (_e10584[2] < 0.0lf) {
                                        phi_7898_ = -(_e10584[2]);
                                    } else {
                                        phi_7898_ = _e10584[2];
                                    }
                                    let _e10602 = phi_7898_;
                                    if (_e10598 > _e10602) {
                                        phi_7903_ = _e10598;
                                    } else {
                                        phi_7903_ = _e10602;
                                    }
                                    let _e10605 = phi_7903_;
                                    let _e10608 = local_18.member[1u];
                                    if (_e10608[0] < 0.0lf) {
                                        phi_7916_ = -(_e10608[0]);
                                    } else {
                                        phi_7916_ = _e10608[0];
                                    }
                                    let _e10615 = phi_7916_;
                                    if (_e10608[1] < 0.0lf) {
                                        phi_7923_ = -(_e10608[1]);
                                    } else {
                                        phi_7923_ = _e10608[1];
                                    }
                                    let _e10619 = phi_7923_;
                                    if (_e10615 > _e10619) {
                                        phi_7928_ = _e10615;
                                    } else {
                                        phi_7928_ = _e10619;
                                    }
                                    let _e10622 = phi_7928_;
                                    if (_e10608[2] < 0.0lf) {
                                        phi_7935_ = -(_e10608[2]);
                                    } else {
                                        phi_7935_ = _e10608[2];
                                    }
                                    let _e10626 = phi_7935_;
                                    if (_e10622 > _e10626) {
                                        phi_7940_ = _e10622;
                                    } else {
                                        phi_7940_ = _e10626;
                                    }
                                    let _e10629 = phi_7940_;
                                    if (_e10605 > _e10629) {
                                        phi_7945_ = _e10605;
                                    } else {
                                        phi_7945_ = _e10629;
                                    }
                                    let _e10632 = phi_7945_;
                                    let _e10634 = local_18.member_3;
                                    let _e10638 = local_18.member_1[0u];
                                    if (_e10638[0] < 0.0lf) {
                                        phi_7962_ = -(_e10638[0]);
                                    } else {
                                        phi_7962_ = _e10638[0];
                                    }
                                    let _e10645 = phi_7962_;
                                    if (_e10638[1] < 0.0lf) {
                                        phi_7969_ = -(_e10638[1]);
                                    } else {
                                        phi_7969_ = _e10638[1];
                                    }
                                    let _e10649 = phi_7969_;
                                    if (_e10645 > _e10649) {
                                        phi_7974_ = _e10645;
                                    } else {
                                        phi_7974_ = _e10649;
                                    }
                                    let _e10652 = phi_7974_;
                                    if (_e10638[2] < 0.0lf) {
                                        phi_7981_ = -(_e10638[2]);
                                    } else {
                                        phi_7981_ = _e10638[2];
                                    }
                                    let _e10656 = phi_7981_;
                                    if (_e10652 > _e10656) {
                                        phi_7986_ = _e10652;
                                    } else {
                                        phi_7986_ = _e10656;
                                    }
                                    let _e10659 = phi_7986_;
                                    let _e10662 = local_18.member_1[1u];
                                    if (_e10662[0] < 0.0lf) {
                                        phi_8000_ = -(_e10662[0]);
                                    } else {
                                        phi_8000_ = _e10662[0];
                                    }
                                    let _e10669 = phi_8000_;
                                    if (_e10662[1] < 0.0lf) {
                                        phi_8007_ = -(_e10662[1]);
                                    } else {
                                        phi_8007_ = _e10662[1];
                                    }
                                    let _e10673 = phi_8007_;
                                    if (_e10669 > _e10673) {
                                        phi_8012_ = _e10669;
                                    } else {
                                        phi_8012_ = _e10673;
                                    }
                                    let _e10676 = phi_8012_;
                                    if (_e10662[2] < 0.0lf) {
                                        phi_8019_ = -(_e10662[2]);
                                    } else {
                                        phi_8019_ = _e10662[2];
                                    }
                                    let _e10680 = phi_8019_;
                                    if (_e10676 > _e10680) {
                                        phi_8024_ = _e10676;
                                    } else {
                                        phi_8024_ = _e10680;
                                    }
                                    let _e10683 = phi_8024_;
                                    if (_e10659 > _e10683) {
                                        phi_8029_ = _e10659;
                                    } else {
                                        phi_8029_ = _e10683;
                                    }
                                    let _e10686 = phi_8029_;
                                    let _e10688 = local_18.member_3;
                                    let _e10692 = local_18.member_2[0u];
                                    if (_e10692[0] < 0.0lf) {
                                        phi_8046_ = -(_e10692[0]);
                                    } else {
                                        phi_8046_ = _e10692[0];
                                    }
                                    let _e10699 = phi_8046_;
                                    if (_e10692[1] < 0.0lf) {
                                        phi_8053_ = -(_e10692[1]);
                                    } else {
                                        phi_8053_ = _e10692[1];
                                    }
                                    let _e10703 = phi_8053_;
                                    if (_e10699 > _e10703) {
                                        phi_8058_ = _e10699;
                                    } else {
                                        phi_8058_ = _e10703;
                                    }
                                    let _e10706 = phi_8058_;
                                    if (_e10692[2] < 0.0lf) {
                                        phi_8065_ = -(_e10692[2]);
                                    } else {
                                        phi_8065_ = _e10692[2];
                                    }
                                    let _e10710 = phi_8065_;
                                    if (_e10706 > _e10710) {
                                        phi_8070_ = _e10706;
                                    } else {
                                        phi_8070_ = _e10710;
                                    }
                                    let _e10713 = phi_8070_;
                                    let _e10716 = local_18.member_2[1u];
                                    if (_e10716[0] < 0.0lf) {
                                        phi_8084_ = -(_e10716[0]);
                                    } else {
                                        phi_8084_ = _e10716[0];
                                    }
                                    let _e10723 = phi_8084_;
                                    if (_e10716[1] < 0.0lf) {
                                        phi_8091_ = -(_e10716[1]);
                                    } else {
                                        phi_8091_ = _e10716[1];
                                    }
                                    let _e10727 = phi_8091_;
                                    if (_e10723 > _e10727) {
                                        phi_8096_ = _e10723;
                                    } else {
                                        phi_8096_ = _e10727;
                                    }
                                    let _e10730 = phi_8096_;
                                    if (_e10716[2] < 0.0lf) {
                                        phi_8103_ = -(_e10716[2]);
                                    } else {
                                        phi_8103_ = _e10716[2];
                                    }
                                    let _e10734 = phi_8103_;
                                    if (_e10730 > _e10734) {
                                        phi_8108_ = _e10730;
                                    } else {
                                        phi_8108_ = _e10734;
                                    }
                                    let _e10737 = phi_8108_;
                                    if (_e10713 > _e10737) {
                                        phi_8113_ = _e10713;
                                    } else {
                                        phi_8113_ = _e10737;
                                    }
                                    let _e10740 = phi_8113_;
                                    let _e10742 = local_18.member_3;
                                    let _e10750 = local_18.member_3;
                                    let _e10760 = (((_e10576 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e10632 + _e10634) + (_e10686 + _e10688)) + (_e10740 + _e10742)) * (1.1102230246251565e-16lf * f64(16f))) + (_e10750 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e825.member_1);
                                    if _e10760 {
                                        phi_8137_ = false;
                                    } else {
                                        phi_8137_ = true;
                                    }
                                    let _e10762 = phi_8137_;
                                    phi_8138_ = _e10762;
                                    phi_8139_ = _e10760;
                                } else {
                                    phi_8138_ = false;
                                    phi_8139_ = false;
                                }
                                let _e10764 = phi_8138_;
                                let _e10766 = phi_8139_;
                                local_63 = _e10766;
                                continue;
                                continuing {
                                    phi_7628_ = _e10430;
                                    break if !(_e10764);
                                }
                            }
                            let _e10769 = local_63;
                            if _e10769 {
                                if (_e10399 > _e548) {
                                    phi_8147_ = 1u;
                                } else {
                                    phi_8147_ = _e10401;
                                }
                                let _e10772 = phi_8147_;
                                phi_8151_ = type_44(type_43(1u, _e10399), _e10772);
                                phi_8152_ = false;
                            } else {
                                phi_8151_ = type_44();
                                phi_8152_ = true;
                            }
                            let _e10776 = phi_8151_;
                            let _e10778 = phi_8152_;
                            if _e10778 {
                                if (_e10399 > _e548) {
                                    phi_8160_ = 0u;
                                } else {
                                    phi_8160_ = _e10401;
                                }
                                let _e10781 = phi_8160_;
                                phi_8164_ = type_44(type_43(2u, _e10399), _e10781);
                            } else {
                                phi_8164_ = _e10776;
                            }
                            let _e10785 = phi_8164_;
                            phi_8165_ = _e10785;
                            phi_8166_ = false;
                            phi_8167_ = false;
                        } else {
                            phi_8165_ = type_44();
                            phi_8166_ = _e10405;
                            phi_8167_ = _e10407;
                        }
                        let _e10787 = phi_8165_;
                        let _e10789 = phi_8166_;
                        let _e10791 = phi_8167_;
                        if _e10789 {
                            phi_8174_ = type_44(type_43(0u, f64()), 0u);
                            phi_8175_ = true;
                        } else {
                            phi_8174_ = _e10377;
                            phi_8175_ = _e10791;
                        }
                        let _e10795 = phi_8174_;
                        let _e10797 = phi_8175_;
                        phi_8179_ = _e10795;
                        phi_8180_ = _e10787;
                        phi_8181_ = _e10797;
                    } else {
                        phi_8179_ = _e6919;
                        phi_8180_ = type_44();
                        phi_8181_ = true;
                    }
                    let _e10799 = phi_8179_;
                    let _e10801 = phi_8180_;
                    let _e10803 = phi_8181_;
                    if _e10803 {
                        phi_8185_ = _e10799;
                    } else {
                        phi_8185_ = _e10801;
                    }
                    let _e10805 = phi_8185_;
                    phi_15852_ = _e10805;
                } else {
                    let _e868 = f64(0f);
                    let _e871 = local_18.member_1[0u];
                    let _e877 = local_18.member_2[0u];
                    let _e883 = ((_e871[1] * _e877[2]) - (_e871[2] * _e877[1]));
                    let _e886 = ((_e871[2] * _e877[0]) - (_e871[0] * _e877[2]));
                    let _e889 = ((_e871[0] * _e877[1]) - (_e871[1] * _e877[0]));
                    let _e892 = local_18.member_1[1u];
                    let _e898 = local_18.member_2[1u];
                    let _e904 = ((_e892[1] * _e898[2]) - (_e892[2] * _e898[1]));
                    let _e907 = ((_e892[2] * _e898[0]) - (_e892[0] * _e898[2]));
                    let _e910 = ((_e892[0] * _e898[1]) - (_e892[1] * _e898[0]));
                    let _e913 = local_18.member_1[0u];
                    let _e919 = local_18.member_2[1u];
                    let _e934 = local_18.member_1[1u];
                    let _e940 = local_18.member_2[0u];
                    let _e953 = (((_e913[1] * _e919[2]) - (_e913[2] * _e919[1])) + ((_e934[1] * _e940[2]) - (_e934[2] * _e940[1])));
                    let _e954 = (((_e913[2] * _e919[0]) - (_e913[0] * _e919[2])) + ((_e934[2] * _e940[0]) - (_e934[0] * _e940[2])));
                    let _e955 = (((_e913[0] * _e919[1]) - (_e913[1] * _e919[0])) + ((_e934[0] * _e940[1]) - (_e934[1] * _e940[0])));
                    let _e958 = local_18.member[0u];
                    let _e966 = (((_e958[0] * _e883) + (_e958[1] * _e886)) + (_e958[2] * _e889));
                    let _e969 = local_18.member[1u];
                    let _e980 = local_18.member[0u];
                    let _e989 = ((((_e969[0] * _e883) + (_e969[1] * _e886)) + (_e969[2] * _e889)) + (((_e980[0] * _e953) + (_e980[1] * _e954)) + (_e980[2] * _e955)));
                    let _e992 = local_18.member[0u];
                    let _e1003 = local_18.member[1u];
                    let _e1012 = ((((_e992[0] * _e904) + (_e992[1] * _e907)) + (_e992[2] * _e910)) + (((_e1003[0] * _e953) + (_e1003[1] * _e954)) + (_e1003[2] * _e955)));
                    let _e1015 = local_18.member[1u];
                    let _e1023 = (((_e1015[0] * _e904) + (_e1015[1] * _e907)) + (_e1015[2] * _e910));
                    let _e1026 = local_18.member[0u];
                    if (_e1026[0] < 0.0lf) {
                        phi_8428_ = -(_e1026[0]);
                    } else {
                        phi_8428_ = _e1026[0];
                    }
                    let _e1033 = phi_8428_;
                    if (_e1026[1] < 0.0lf) {
                        phi_8435_ = -(_e1026[1]);
                    } else {
                        phi_8435_ = _e1026[1];
                    }
                    let _e1037 = phi_8435_;
                    if (_e1033 > _e1037) {
                        phi_8440_ = _e1033;
                    } else {
                        phi_8440_ = _e1037;
                    }
                    let _e1040 = phi_8440_;
                    if (_e1026[2] < 0.0lf) {
                        phi_8447_ = -(_e1026[2]);
                    } else {
                        phi_8447_ = _e1026[2];
                    }
                    let _e1044 = phi_8447_;
                    if (_e1040 > _e1044) {
                        phi_8452_ = _e1040;
                    } else {
                        phi_8452_ = _e1044;
                    }
                    let _e1047 = phi_8452_;
                    let _e1050 = local_18.member[1u];
                    if (_e1050[0] < 0.0lf) {
                        phi_8465_ = -(_e1050[0]);
                    } else {
                        phi_8465_ = _e1050[0];
                    }
                    let _e1057 = phi_8465_;
                    if (_e1050[1] < 0.0lf) {
                        phi_8472_ = -(_e1050[1]);
                    } else {
                        phi_8472_ = _e1050[1];
                    }
                    let _e1061 = phi_8472_;
                    if (_e1057 > _e1061) {
                        phi_8477_ = _e1057;
                    } else {
                        phi_8477_ = _e1061;
                    }
                    let _e1064 = phi_8477_;
                    if (_e1050[2] < 0.0lf) {
                        phi_8484_ = -(_e1050[2]);
                    } else {
                        phi_8484_ = _e1050[2];
                    }
                    let _e1068 = phi_8484_;
                    if (_e1064 > _e1068) {
                        phi_8489_ = _e1064;
                    } else {
                        phi_8489_ = _e1068;
                    }
                    let _e1071 = phi_8489_;
                    if (_e1047 > _e1071) {
                        phi_8494_ = _e1047;
                    } else {
                        phi_8494_ = _e1071;
                    }
                    let _e1074 = phi_8494_;
                    let _e1076 = local_18.member_3;
                    let _e1077 = (_e1074 + _e1076);
                    let _e1080 = local_18.member_1[0u];
                    if (_e1080[0] < 0.0lf) {
                        phi_8511_ = -(_e1080[0]);
                    } else {
                        phi_8511_ = _e1080[0];
                    }
                    let _e1087 = phi_8511_;
                    if (_e1080[1] < 0.0lf) {
                        phi_8518_ = -(_e1080[1]);
                    } else {
                        phi_8518_ = _e1080[1];
                    }
                    let _e1091 = phi_8518_;
                    if (_e1087 > _e1091) {
                        phi_8523_ = _e1087;
                    } else {
                        phi_8523_ = _e1091;
                    }
                    let _e1094 = phi_8523_;
                    if (_e1080[2] < 0.0lf) {
                        phi_8530_ = -(_e1080[2]);
                    } else {
                        phi_8530_ = _e1080[2];
                    }
                    let _e1098 = phi_8530_;
                    if (_e1094 > _e1098) {
                        phi_8535_ = _e1094;
                    } else {
                        phi_8535_ = _e1098;
                    }
                    let _e1101 = phi_8535_;
                    let _e1104 = local_18.member_1[1u];
                    if (_e1104[0] < 0.0lf) {
                        phi_8549_ = -(_e1104[0]);
                    } else {
                        phi_8549_ = _e1104[0];
                    }
                    let _e1111 = phi_8549_;
                    if (_e1104[1] < 0.0lf) {
                        phi_8556_ = -(_e1104[1]);
                    } else {
                        phi_8556_ = _e1104[1];
                    }
                    let _e1115 = phi_8556_;
                    if (_e1111 > _e1115) {
                        phi_8561_ = _e1111;
                    } else {
                        phi_8561_ = _e1115;
                    }
                    let _e1118 = phi_8561_;
                    if (_e1104[2] < 0.0lf) {
                        phi_8568_ = -(_e1104[2]);
                    } else {
                        phi_8568_ = _e1104[2];
                    }
                    let _e1122 = phi_8568_;
                    if (_e1118 > _e1122) {
                        phi_8573_ = _e1118;
                    } else {
                        phi_8573_ = _e1122;
                    }
                    let _e1125 = phi_8573_;
                    if (_e1101 > _e1125) {
                        phi_8578_ = _e1101;
                    } else {
                        phi_8578_ = _e1125;
                    }
                    let _e1128 = phi_8578_;
                    let _e1130 = local_18.member_3;
                    let _e1131 = (_e1128 + _e1130);
                    let _e1134 = local_18.member_2[0u];
                    if (_e1134[0] < 0.0lf) {
                        phi_8595_ = -(_e1134[0]);
                    } else {
                        phi_8595_ = _e1134[0];
                    }
                    let _e1141 = phi_8595_;
                    if (_e1134[1] < 0.0lf) {
                        phi_8602_ = -(_e1134[1]);
                    } else {
                        phi_8602_ = _e1134[1];
                    }
                    let _e1145 = phi_8602_;
                    if (_e1141 > _e1145) {
                        phi_8607_ = _e1141;
                    } else {
                        phi_8607_ = _e1145;
                    }
                    let _e1148 = phi_8607_;
                    if (_e1134[2] < 0.0lf) {
                        phi_8614_ = -(_e1134[2]);
                    } else {
                        phi_8614_ = _e1134[2];
                    }
                    let _e1152 = phi_8614_;
                    if (_e1148 > _e1152) {
                        phi_8619_ = _e1148;
                    } else {
                        phi_8619_ = _e1152;
                    }
                    let _e1155 = phi_8619_;
                    let _e1158 = local_18.member_2[1u];
                    if (_e1158[0] < 0.0lf) {
                        phi_8633_ = -(_e1158[0]);
                    } else {
                        phi_8633_ = _e1158[0];
                    }
                    let _e1165 = phi_8633_;
                    if (_e1158[1] < 0.0lf) {
                        phi_8640_ = -(_e1158[1]);
                    } else {
                        phi_8640_ = _e1158[1];
                    }
                    let _e1169 = phi_8640_;
                    if (_e1165 > _e1169) {
                        phi_8645_ = _e1165;
                    } else {
                        phi_8645_ = _e1169;
                    }
                    let _e1172 = phi_8645_;
                    if (_e1158[2] < 0.0lf) {
                        phi_8652_ = -(_e1158[2]);
                    } else {
                        phi_8652_ = _e1158[2];
                    }
                    let _e1176 = phi_8652_;
                    if (_e1172 > _e1176) {
                        phi_8657_ = _e1172;
                    } else {
                        phi_8657_ = _e1176;
                    }
                    let _e1179 = phi_8657_;
                    if (_e1155 > _e1179) {
                        phi_8662_ = _e1155;
                    } else {
                        phi_8662_ = _e1179;
                    }
                    let _e1182 = phi_8662_;
                    let _e1184 = local_18.member_3;
                    let _e1185 = (_e1182 + _e1184);
                    let _e1186 = f64(1f);
                    let _e1187 = f64(8f);
                    let _e1189 = ((_e1131 * _e1187) * _e1185);
                    let _e1197 = local_18.member_3;
                    if (_e883 < 0.0lf) {
                        phi_8699_ = -(_e883);
                    } else {
                        phi_8699_ = _e883;
                    }
                    let _e1217 = phi_8699_;
                    if (_e886 < 0.0lf) {
                        phi_8705_ = -(_e886);
                    } else {
                        phi_8705_ = _e886;
                    }
                    let _e1221 = phi_8705_;
                    if (_e889 < 0.0lf) {
                        phi_8712_ = -(_e889);
                    } else {
                        phi_8712_ = _e889;
                    }
                    let _e1226 = phi_8712_;
                    let _e1227 = ((_e1217 + _e1221) + _e1226);
                    if (_e904 < 0.0lf) {
                        phi_8719_ = -(_e904);
                    } else {
                        phi_8719_ = _e904;
                    }
                    let _e1231 = phi_8719_;
                    if (_e907 < 0.0lf) {
                        phi_8725_ = -(_e907);
                    } else {
                        phi_8725_ = _e907;
                    }
                    let _e1235 = phi_8725_;
                    if (_e910 < 0.0lf) {
                        phi_8732_ = -(_e910);
                    } else {
                        phi_8732_ = _e910;
                    }
                    let _e1240 = phi_8732_;
                    let _e1241 = ((_e1231 + _e1235) + _e1240);
                    if (_e1227 > _e1241) {
                        phi_8738_ = _e1227;
                    } else {
                        phi_8738_ = _e1241;
                    }
                    let _e1244 = phi_8738_;
                    if (_e953 < 0.0lf) {
                        phi_8744_ = -(_e953);
                    } else {
                        phi_8744_ = _e953;
                    }
                    let _e1248 = phi_8744_;
                    if (_e954 < 0.0lf) {
                        phi_8750_ = -(_e954);
                    } else {
                        phi_8750_ = _e954;
                    }
                    let _e1252 = phi_8750_;
                    if (_e955 < 0.0lf) {
                        phi_8757_ = -(_e955);
                    } else {
                        phi_8757_ = _e955;
                    }
                    let _e1257 = phi_8757_;
                    let _e1259 = (((_e1248 + _e1252) + _e1257) * f64(0.5f));
                    if (_e1244 > _e1259) {
                        phi_8764_ = _e1244;
                    } else {
                        phi_8764_ = _e1259;
                    }
                    let _e1262 = phi_8764_;
                    let _e1268 = local_18.member_3;
                    let _e1282 = (((((_e1077 * _e1187) * _e1189) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1197 * f64(19f)) * ((_e1077 * (_e1131 + _e1185)) + (_e1131 * _e1185)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1186 + _e1077) * ((_e1186 + _e1131) * (_e1186 + _e1185)))));
                    let _e1283 = f64(3f);
                    let _e1284 = (_e966 * _e1283);
                    let _e1285 = (_e1023 * _e1283);
                    if (_e1284 < _e1285) {
                        phi_8792_ = _e1284;
                    } else {
                        phi_8792_ = _e1285;
                    }
                    let _e1288 = phi_8792_;
                    if (_e989 < _e1012) {
                        phi_8797_ = _e989;
                    } else {
                        phi_8797_ = _e1012;
                    }
                    let _e1291 = phi_8797_;
                    if (_e1288 < _e1291) {
                        phi_8802_ = _e1288;
                    } else {
                        phi_8802_ = _e1291;
                    }
                    let _e1294 = phi_8802_;
                    if (_e1284 > _e1285) {
                        phi_8807_ = _e1284;
                    } else {
                        phi_8807_ = _e1285;
                    }
                    let _e1297 = phi_8807_;
                    if (_e989 > _e1012) {
                        phi_8812_ = _e989;
                    } else {
                        phi_8812_ = _e1012;
                    }
                    let _e1300 = phi_8812_;
                    if (_e1297 > _e1300) {
                        phi_8817_ = _e1297;
                    } else {
                        phi_8817_ = _e1300;
                    }
                    let _e1303 = phi_8817_;
                    let _e1309 = -(_e1303);
                    if (_e1294 > _e1309) {
                        phi_8828_ = _e1294;
                    } else {
                        phi_8828_ = _e1309;
                    }
                    let _e1312 = phi_8828_;
                    if ((_e1312 - (_e1282 + ((_e868 * (((_e1262 + (_e1189 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1268 * f64(6f)) * (_e1131 + _e1185))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1186 + _e1131) * (_e1186 + _e1185))))) * f64((3f * 1.0001f))))) > _e868) {
                        phi_15822_ = type_43(0u, type_43().member_1);
                        phi_15823_ = type_43();
                        phi_15824_ = true;
                    } else {
                        if (_e966 < 0.0lf) {
                            phi_8842_ = -(_e966);
                        } else {
                            phi_8842_ = _e966;
                        }
                        let _e1320 = phi_8842_;
                        if (_e989 < 0.0lf) {
                            phi_8848_ = -(_e989);
                        } else {
                            phi_8848_ = _e989;
                        }
                        let _e1324 = phi_8848_;
                        if (_e1320 > _e1324) {
                            phi_8853_ = _e1320;
                        } else {
                            phi_8853_ = _e1324;
                        }
                        let _e1327 = phi_8853_;
                        if (_e1012 < 0.0lf) {
                            phi_8859_ = -(_e1012);
                        } else {
                            phi_8859_ = _e1012;
                        }
                        let _e1331 = phi_8859_;
                        if (_e1023 < 0.0lf) {
                            phi_8865_ = -(_e1023);
                        } else {
                            phi_8865_ = _e1023;
                        }
                        let _e1335 = phi_8865_;
                        if (_e1331 > _e1335) {
                            phi_8870_ = _e1331;
                        } else {
                            phi_8870_ = _e1335;
                        }
                        let _e1338 = phi_8870_;
                        if (_e1327 > _e1338) {
                            phi_8875_ = _e1327;
                        } else {
                            phi_8875_ = _e1338;
                        }
                        let _e1341 = phi_8875_;
                        let _e1343 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1344 = f64(1f);
                        if (_e1341 >= _e1343) {
                            phi_8885_ = (_e1341 <= (_e1344 / _e1343));
                        } else {
                            phi_8885_ = false;
                        }
                        let _e1349 = phi_8885_;
                        if _e1349 {
                            phi_8892_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_8892_ = f64(2f);
                        }
                        let _e1354 = phi_8892_;
                        let _e1356 = ((_e1282 * f64(0.34f)) + (_e1341 * _e1354));
                        if _e1349 {
                            phi_8900_ = (_e1344 / _e1341);
                        } else {
                            phi_8900_ = f64(0f);
                        }
                        let _e1360 = phi_8900_;
                        let _e1361 = f64(0.00000000000022737368f);
                        let _e1363 = (_e539 * f64(0.0625f));
                        if (_e1361 < _e1363) {
                            phi_8908_ = _e1361;
                        } else {
                            phi_8908_ = _e1363;
                        }
                        let _e1366 = phi_8908_;
                        let _e1368 = (f64(1f) - _e548);
                        let _e1379 = ((((_e966 * _e1368) + (_e989 * _e548)) * (_e1368 * _e1368)) + (((_e1012 * _e1368) + (_e1023 * _e548)) * (_e548 * _e548)));
                        if (_e1379 < 0.0lf) {
                            phi_8927_ = -(_e1379);
                        } else {
                            phi_8927_ = _e1379;
                        }
                        let _e1383 = phi_8927_;
                        if !((_e1383 > _e1356)) {
                            let _e1386 = f64(0f);
                            let _e1389 = local_18.member[0u];
                            let _e1396 = local_18.member_1[0u];
                            let _e1402 = local_18.member_2[0u];
                            let _e1406 = (_e1389[0] - _e1396[0]);
                            let _e1407 = (_e1389[1] - _e1396[1]);
                            let _e1408 = (_e1389[2] - _e1396[2]);
                            if (_e252.member == 0u) {
                                phi_8989_ = array<f64, 3>(_e1389[0], _e1389[1], _e1389[2]);
                            } else {
                                phi_8989_ = array<f64, 3>((_e1406 - _e1402[0]), (_e1407 - _e1402[1]), (_e1408 - _e1402[2]));
                            }
                            let _e1415 = phi_8989_;
                            let _e1416 = (_e1389[0] - _e1402[0]);
                            let _e1417 = (_e1389[1] - _e1402[1]);
                            let _e1418 = (_e1389[2] - _e1402[2]);
                            let _e1421 = local_18.member[1u];
                            let _e1428 = local_18.member_1[1u];
                            let _e1434 = local_18.member_2[1u];
                            let _e1438 = (_e1421[0] - _e1428[0]);
                            let _e1439 = (_e1421[1] - _e1428[1]);
                            let _e1440 = (_e1421[2] - _e1428[2]);
                            if (_e252.member == 0u) {
                                phi_9054_ = array<f64, 3>(_e1421[0], _e1421[1], _e1421[2]);
                            } else {
                                phi_9054_ = array<f64, 3>((_e1438 - _e1434[0]), (_e1439 - _e1434[1]), (_e1440 - _e1434[2]));
                            }
                            let _e1447 = phi_9054_;
                            let _e1448 = (_e1421[0] - _e1434[0]);
                            let _e1449 = (_e1421[1] - _e1434[1]);
                            let _e1450 = (_e1421[2] - _e1434[2]);
                            let _e1453 = local_18.member[0u];
                            if (_e1453[0] < 0.0lf) {
                                phi_9076_ = -(_e1453[0]);
                            } else {
                                phi_9076_ = _e1453[0];
                            }
                            let _e1460 = phi_9076_;
                            if (_e1453[1] < 0.0lf) {
                                phi_9083_ = -(_e1453[1]);
                            } else {
                                phi_9083_ = _e1453[1];
                            }
                            let _e1464 = phi_9083_;
                            if (_e1460 > _e1464) {
                                phi_9088_ = _e1460;
                            } else {
                                phi_9088_ = _e1464;
                            }
                            let _e1467 = phi_9088_;
                            if (_e1453[2] < 0.0lf) {
                                phi_9095_ = -(_e1453[2]);
                            } else {
                                phi_9095_ = _e1453[2];
                            }
                            let _e1471 = phi_9095_;
                            if (_e1467 > _e1471) {
                                phi_9100_ = _e1467;
                            } else {
                                phi_9100_ = _e1471;
                            }
                            let _e1474 = phi_9100_;
                            let _e1477 = local_18.member[1u];
                            if (_e1477[0] < 0.0lf) {
                                phi_9113_ = -(_e1477[0]);
                            } else {
                                phi_9113_ = _e1477[0];
                            }
                            let _e1484 = phi_9113_;
                            if (_e1477[1] < 0.0lf) {
                                phi_9120_ = -(_e1477[1]);
                            } else {
                                phi_9120_ = _e1477[1];
                            }
                            let _e1488 = phi_9120_;
                            if (_e1484 > _e1488) {
                                phi_9125_ = _e1484;
                            } else {
                                phi_9125_ = _e1488;
                            }
                            let _e1491 = phi_9125_;
                            if (_e1477[2] < 0.0lf) {
                                phi_9132_ = -(_e1477[2]);
                            } else {
                                phi_9132_ = _e1477[2];
                            }
                            let _e1495 = phi_9132_;
                            if (_e1491 > _e1495) {
                                phi_9137_ = _e1491;
                            } else {
                                phi_9137_ = _e1495;
                            }
                            let _e1498 = phi_9137_;
                            if (_e1474 > _e1498) {
                                phi_9142_ = _e1474;
                            } else {
                                phi_9142_ = _e1498;
                            }
                            let _e1501 = phi_9142_;
                            let _e1503 = local_18.member_3;
                            let _e1507 = local_18.member_1[0u];
                            if (_e1507[0] < 0.0lf) {
                                phi_9159_ = -(_e1507[0]);
                            } else {
                                phi_9159_ = _e1507[0];
                            }
                            let _e1514 = phi_9159_;
                            if (_e1507[1] < 0.0lf) {
                                phi_9166_ = -(_e1507[1]);
                            } else {
                                phi_9166_ = _e1507[1];
                            }
                            let _e1518 = phi_9166_;
                            if (_e1514 > _e1518) {
                                phi_9171_ = _e1514;
                            } else {
                                phi_9171_ = _e1518;
                            }
                            let _e1521 = phi_9171_;
                            if (_e1507[2] < 0.0lf) {
                                phi_9178_ = -(_e1507[2]);
                            } else {
                                phi_9178_ = _e1507[2];
                            }
                            let _e1525 = phi_9178_;
                            if (_e1521 > _e1525) {
                                phi_9183_ = _e1521;
                            } else {
                                phi_9183_ = _e1525;
                            }
                            let _e1528 = phi_9183_;
                            let _e1531 = local_18.member_1[1u];
                            if (_e1531[0] < 0.0lf) {
                                phi_9197_ = -(_e1531[0]);
                            } else {
                                phi_9197_ = _e1531[0];
                            }
                            let _e1538 = phi_9197_;
                            if (_e1531[1] < 0.0lf) {
                                phi_9204_ = -(_e1531[1]);
                            } else {
                                phi_9204_ = _e1531[1];
                            }
                            let _e1542 = phi_9204_;
                            if (_e1538 > _e1542) {
                                phi_9209_ = _e1538;
                            } else {
                                phi_9209_ = _e1542;
                            }
                            let _e1545 = phi_9209_;
                            if (_e1531[2] < 0.0lf) {
                                phi_9216_ = -(_e1531[2]);
                            } else {
                                phi_9216_ = _e1531[2];
                            }
                            let _e1549 = phi_9216_;
                            if (_e1545 > _e1549) {
                                phi_9221_ = _e1545;
                            } else {
                                phi_9221_ = _e1549;
                            }
                            let _e1552 = phi_9221_;
                            if (_e1528 > _e1552) {
                                phi_9226_ = _e1528;
                            } else {
                                phi_9226_ = _e1552;
                            }
                            let _e1555 = phi_9226_;
                            let _e1557 = local_18.member_3;
                            let _e1561 = local_18.member_2[0u];
                            if (_e1561[0] < 0.0lf) {
                                phi_9243_ = -(_e1561[0]);
                            } else {
                                phi_9243_ = _e1561[0];
                            }
                            let _e1568 = phi_9243_;
                            if (_e1561[1] < 0.0lf) {
                                phi_9250_ = -(_e1561[1]);
                            } else {
                                phi_9250_ = _e1561[1];
                            }
                            let _e1572 = phi_9250_;
                            if (_e1568 > _e1572) {
                                phi_9255_ = _e1568;
                            } else {
                                phi_9255_ = _e1572;
                            }
                            let _e1575 = phi_9255_;
                            if (_e1561[2] < 0.0lf) {
                                phi_9262_ = -(_e1561[2]);
                            } else {
                                phi_9262_ = _e1561[2];
                            }
                            let _e1579 = phi_9262_;
                            if (_e1575 > _e1579) {
                                phi_9267_ = _e1575;
                            } else {
                                phi_9267_ = _e1579;
                            }
                            let _e1582 = phi_9267_;
                            let _e1585 = local_18.member_2[1u];
                            if (_e1585[0] < 0.0lf) {
                                phi_9281_ = -(_e1585[0]);
                            } else {
                                phi_9281_ = _e1585[0];
                            }
                            let _e1592 = phi_9281_;
                            if (_e1585[1] < 0.0lf) {
                                phi_9288_ = -(_e1585[1]);
                            } else {
                                phi_9288_ = _e1585[1];
                            }
                            let _e1596 = phi_9288_;
                            if (_e1592 > _e1596) {
                                phi_9293_ = _e1592;
                            } else {
                                phi_9293_ = _e1596;
                            }
                            let _e1599 = phi_9293_;
                            if (_e1585[2] < 0.0lf) {
                                phi_9300_ = -(_e1585[2]);
                            } else {
                                phi_9300_ = _e1585[2];
                            }
                            let _e1603 = phi_9300_;
                            if (_e1599 > _e1603) {
                                phi_9305_ = _e1599;
                            } else {
                                phi_9305_ = _e1603;
                            }
                            let _e1606 = phi_9305_;
                            if (_e1582 > _e1606) {
                                phi_9310_ = _e1582;
                            } else {
                                phi_9310_ = _e1606;
                            }
                            let _e1609 = phi_9310_;
                            let _e1611 = local_18.member_3;
                            let _e1619 = local_18.member_3;
                            let _e1625 = ((((((_e1501 + _e1503) + (_e1555 + _e1557)) + (_e1609 + _e1611)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1619 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f)));
                            let _e1628 = local_18.member[0u];
                            let _e1634 = local_18.member[1u];
                            let _e1650 = local_18.member_1[0u];
                            let _e1656 = local_18.member_1[1u];
                            let _e1672 = local_18.member_2[0u];
                            let _e1678 = local_18.member_2[1u];
                            let _e1692 = function_4(array<f64, 3>((_e1628[0] + ((_e1634[0] - _e1628[0]) * _e548)), (_e1628[1] + ((_e1634[1] - _e1628[1]) * _e548)), (_e1628[2] + ((_e1634[2] - _e1628[2]) * _e548))), array<f64, 3>((_e1650[0] + ((_e1656[0] - _e1650[0]) * _e548)), (_e1650[1] + ((_e1656[1] - _e1650[1]) * _e548)), (_e1650[2] + ((_e1656[2] - _e1650[2]) * _e548))), array<f64, 3>((_e1672[0] + ((_e1678[0] - _e1672[0]) * _e548)), (_e1672[1] + ((_e1678[1] - _e1672[1]) * _e548)), (_e1672[2] + ((_e1678[2] - _e1672[2]) * _e548))), _e252.member);
                            if (_e1692[0] < 0.0lf) {
                                phi_9431_ = -(_e1692[0]);
                            } else {
                                phi_9431_ = _e1692[0];
                            }
                            let _e1697 = phi_9431_;
                            if (_e1692[1] < 0.0lf) {
                                phi_9438_ = -(_e1692[1]);
                            } else {
                                phi_9438_ = _e1692[1];
                            }
                            let _e1702 = phi_9438_;
                            if (_e1692[2] < 0.0lf) {
                                phi_9446_ = -(_e1692[2]);
                            } else {
                                phi_9446_ = _e1692[2];
                            }
                            let _e1708 = phi_9446_;
                            let _e1709 = ((_e1697 + _e1702) + _e1708);
                            if (_e1709 > f64(0f)) {
                                if ((bitcast<u64>(_e1709) & 9218868437227405312lu) != 9218868437227405312lu) {
                                    let _e1716 = (f64(1f) / _e1709);
                                    let _e1718 = (_e1692[0] * _e1716);
                                    let _e1720 = (_e1692[1] * _e1716);
                                    let _e1722 = (_e1692[2] * _e1716);
                                    let _e1727 = (((_e1718 * _e1718) + (_e1720 * _e1720)) + (_e1722 * _e1722));
                                    if (_e1727 <= 2.2250738585072014e-308lf) {
                                        if (_e1727 > 0.0lf) {
                                            phi_9485_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_9485_ = 0.0lf;
                                        }
                                        let _e1779 = phi_9485_;
                                        phi_9549_ = _e1779;
                                    } else {
                                        phi_9492_ = type_18(0i, 5i);
                                        phi_9495_ = bitcast<f64>(((bitcast<u64>(_e1727) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1734 = phi_9492_;
                                            let _e1736 = phi_9495_;
                                            local_19 = _e1736;
                                            if (_e1734.member < _e1734.member_1) {
                                                let _e1743 = (_e1734.member + 1i);
                                                if ((false == (_e1743 > _e1734.member)) != false) {
                                                    phi_9516_ = true;
                                                } else {
                                                    phi_9516_ = false;
                                                }
                                                let _e1748 = phi_9516_;
                                                if _e1748 {
                                                    phi_9522_ = type_19(0u, type_19().member_1);
                                                } else {
                                                    phi_9522_ = type_19(1u, _e1743);
                                                }
                                                let _e1753 = phi_9522_;
                                                phi_9493_ = type_18(_e1753.member_1, _e1734.member_1);
                                                phi_9536_ = type_19(1u, _e1734.member);
                                            } else {
                                                phi_9493_ = _e1734;
                                                phi_9536_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1759 = phi_9493_;
                                            let _e1761 = phi_9536_;
                                            let _e1764 = (bitcast<i32>(_e1761.member) != 0i);
                                            if _e1764 {
                                                phi_9496_ = (0.5lf * (_e1736 + (_e1727 / _e1736)));
                                            } else {
                                                phi_9496_ = f64();
                                            }
                                            let _e1769 = phi_9496_;
                                            continue;
                                            continuing {
                                                phi_9492_ = _e1759;
                                                phi_9495_ = _e1769;
                                                break if !(_e1764);
                                            }
                                        }
                                        let _e1774 = local_19;
                                        phi_9549_ = (_e1774 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1781 = phi_9549_;
                                    let _e1783 = (1.1102230246251565e-16lf * f64(12f));
                                    let _e1790 = ((_e1625 * f64(1.01f)) + ((_e1386 * _e1781) * (f64(1f) + _e1783)));
                                    let _e1795 = (((_e1718 * _e1389[0]) + (_e1720 * _e1389[1])) + (_e1722 * _e1389[2]));
                                    let _e1800 = (((_e1718 * _e1406) + (_e1720 * _e1407)) + (_e1722 * _e1408));
                                    let _e1805 = (((_e1718 * _e1416) + (_e1720 * _e1417)) + (_e1722 * _e1418));
                                    let _e1813 = (((_e1718 * _e1415[0]) + (_e1720 * _e1415[1])) + (_e1722 * _e1415[2]));
                                    let _e1819 = (((_e1718 * _e1421[0]) + (_e1720 * _e1421[1])) + (_e1722 * _e1421[2]));
                                    let _e1824 = (((_e1718 * _e1438) + (_e1720 * _e1439)) + (_e1722 * _e1440));
                                    let _e1829 = (((_e1718 * _e1448) + (_e1720 * _e1449)) + (_e1722 * _e1450));
                                    let _e1837 = (((_e1718 * _e1447[0]) + (_e1720 * _e1447[1])) + (_e1722 * _e1447[2]));
                                    if (_e1795 < 0.0lf) {
                                        phi_9618_ = -(_e1795);
                                    } else {
                                        phi_9618_ = _e1795;
                                    }
                                    let _e1842 = phi_9618_;
                                    if (_e1819 < 0.0lf) {
                                        phi_9624_ = -(_e1819);
                                    } else {
                                        phi_9624_ = _e1819;
                                    }
                                    let _e1846 = phi_9624_;
                                    if (_e1800 < 0.0lf) {
                                        phi_9633_ = -(_e1800);
                                    } else {
                                        phi_9633_ = _e1800;
                                    }
                                    let _e1853 = phi_9633_;
                                    if (_e1824 < 0.0lf) {
                                        phi_9639_ = -(_e1824);
                                    } else {
                                        phi_9639_ = _e1824;
                                    }
                                    let _e1857 = phi_9639_;
                                    if (_e1805 < 0.0lf) {
                                        phi_9648_ = -(_e1805);
                                    } else {
                                        phi_9648_ = _e1805;
                                    }
                                    let _e1864 = phi_9648_;
                                    if (_e1829 < 0.0lf) {
                                        phi_9654_ = -(_e1829);
                                    } else {
                                        phi_9654_ = _e1829;
                                    }
                                    let _e1868 = phi_9654_;
                                    if (_e1813 < 0.0lf) {
                                        phi_9663_ = -(_e1813);
                                    } else {
                                        phi_9663_ = _e1813;
                                    }
                                    let _e1875 = phi_9663_;
                                    if (_e1837 < 0.0lf) {
                                        phi_9669_ = -(_e1837);
                                    } else {
                                        phi_9669_ = _e1837;
                                    }
                                    let _e1879 = phi_9669_;
                                    phi_9675_ = type_35(array<f64, 4>(_e1795, _e1800, _e1805, _e1813), array<f64, 4>(_e1819, _e1824, _e1829, _e1837), array<f64, 4>((_e1790 + ((_e1842 + _e1846) * _e1783)), (_e1790 + ((_e1853 + _e1857) * _e1783)), (_e1790 + ((_e1864 + _e1868) * _e1783)), (_e1790 + ((_e1875 + _e1879) * _e1783))));
                                    phi_9676_ = false;
                                } else {
                                    phi_9675_ = type_35();
                                    phi_9676_ = true;
                                }
                                let _e1886 = phi_9675_;
                                let _e1888 = phi_9676_;
                                phi_9677_ = _e1886;
                                phi_9678_ = _e1888;
                            } else {
                                phi_9677_ = type_35();
                                phi_9678_ = true;
                            }
                            let _e1890 = phi_9677_;
                            let _e1892 = phi_9678_;
                            if _e1892 {
                                let _e1893 = f64(0f);
                                let _e1894 = f64(1f);
                                phi_9688_ = type_35(array<f64, 4>(_e1893, _e1893, _e1893, _e1893), array<f64, 4>(_e1893, _e1893, _e1893, _e1893), array<f64, 4>(_e1894, _e1894, _e1894, _e1894));
                            } else {
                                phi_9688_ = _e1890;
                            }
                            let _e1900 = phi_9688_;
                            local_8 = type_35(array<f64, 4>(_e1900.member[0], _e1900.member[1], _e1900.member[2], _e1900.member[3]), array<f64, 4>(_e1900.member_1[0], _e1900.member_1[1], _e1900.member_1[2], _e1900.member_1[3]), array<f64, 4>(_e1900.member_2[0], _e1900.member_2[1], _e1900.member_2[2], _e1900.member_2[3]));
                            let _e1920 = f64(0f);
                            let _e1923 = local_8.member[0u];
                            let _e1926 = local_8.member_1[0u];
                            let _e1929 = local_8.member[0u];
                            let _e1935 = local_8.member_2[0u];
                            if (((_e1923 + ((_e1926 - _e1929) * _e548)) - _e1935) > _e1920) {
                                let _e1940 = local_8.member[1u];
                                let _e1943 = local_8.member_1[1u];
                                let _e1946 = local_8.member[1u];
                                let _e1952 = local_8.member_2[1u];
                                if (((_e1940 + ((_e1943 - _e1946) * _e548)) - _e1952) > _e1920) {
                                    let _e1957 = local_8.member[2u];
                                    let _e1960 = local_8.member_1[2u];
                                    let _e1963 = local_8.member[2u];
                                    let _e1969 = local_8.member_2[2u];
                                    if (((_e1957 + ((_e1960 - _e1963) * _e548)) - _e1969) > _e1920) {
                                        let _e1974 = local_8.member[3u];
                                        let _e1977 = local_8.member_1[3u];
                                        let _e1980 = local_8.member[3u];
                                        let _e1986 = local_8.member_2[3u];
                                        phi_9858_ = (((_e1974 + ((_e1977 - _e1980) * _e548)) - _e1986) > _e1920);
                                        phi_9859_ = false;
                                    } else {
                                        phi_9858_ = bool();
                                        phi_9859_ = true;
                                    }
                                    let _e1990 = phi_9858_;
                                    let _e1992 = phi_9859_;
                                    phi_9860_ = _e1990;
                                    phi_9861_ = _e1992;
                                } else {
                                    phi_9860_ = bool();
                                    phi_9861_ = true;
                                }
                                let _e1994 = phi_9860_;
                                let _e1996 = phi_9861_;
                                phi_9862_ = _e1994;
                                phi_9863_ = _e1996;
                            } else {
                                phi_9862_ = bool();
                                phi_9863_ = true;
                            }
                            let _e1998 = phi_9862_;
                            let _e2000 = phi_9863_;
                            if _e2000 {
                                phi_9867_ = false;
                            } else {
                                phi_9867_ = _e1998;
                            }
                            let _e2002 = phi_9867_;
                            if _e2002 {
                                phi_11248_ = bool();
                                phi_11249_ = true;
                            } else {
                                let _e2003 = f64(0f);
                                if (_e1692[0] < 0.0lf) {
                                    phi_9895_ = -(_e1692[0]);
                                } else {
                                    phi_9895_ = _e1692[0];
                                }
                                let _e2008 = phi_9895_;
                                if (_e2003 < 0.0lf) {
                                    phi_9901_ = -(_e2003);
                                } else {
                                    phi_9901_ = _e2003;
                                }
                                let _e2012 = phi_9901_;
                                if (_e2003 < 0.0lf) {
                                    phi_9908_ = -(_e2003);
                                } else {
                                    phi_9908_ = _e2003;
                                }
                                let _e2017 = phi_9908_;
                                let _e2018 = ((_e2008 + _e2012) + _e2017);
                                if (_e2018 > f64(0f)) {
                                    if ((bitcast<u64>(_e2018) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e2025 = (f64(1f) / _e2018);
                                        let _e2026 = (_e1692[0] * _e2025);
                                        let _e2027 = (_e2003 * _e2025);
                                        let _e2028 = (_e2003 * _e2025);
                                        let _e2033 = (((_e2026 * _e2026) + (_e2027 * _e2027)) + (_e2028 * _e2028));
                                        if (_e2033 <= 2.2250738585072014e-308lf) {
                                            if (_e2033 > 0.0lf) {
                                                phi_9944_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_9944_ = 0.0lf;
                                            }
                                            let _e2085 = phi_9944_;
                                            phi_10008_ = _e2085;
                                        } else {
                                            phi_9951_ = type_18(0i, 5i);
                                            phi_9954_ = bitcast<f64>(((bitcast<u64>(_e2033) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e2040 = phi_9951_;
                                                let _e2042 = phi_9954_;
                                                local_20 = _e2042;
                                                if (_e2040.member < _e2040.member_1) {
                                                    let _e2049 = (_e2040.member + 1i);
                                                    if ((false == (_e2049 > _e2040.member)) != false) {
                                                        phi_9975_ = true;
                                                    } else {
                                                        phi_9975_ = false;
                                                    }
                                                    let _e2054 = phi_9975_;
                                                    if _e2054 {
                                                        phi_9981_ = type_19(0u, type_19().member_1);
                                                    } else {
                                                        phi_9981_ = type_19(1u, _e2049);
                                                    }
                                                    let _e2059 = phi_9981_;
                                                    phi_9952_ = type_18(_e2059.member_1, _e2040.member_1);
                                                    phi_9995_ = type_19(1u, _e2040.member);
                                                } else {
                                                    phi_9952_ = _e2040;
                                                    phi_9995_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2065 = phi_9952_;
                                                let _e2067 = phi_9995_;
                                                let _e2070 = (bitcast<i32>(_e2067.member) != 0i);
                                                if _e2070 {
                                                    phi_9955_ = (0.5lf * (_e2042 + (_e2033 / _e2042)));
                                                } else {
                                                    phi_9955_ = f64();
                                                }
                                                let _e2075 = phi_9955_;
                                                continue;
                                                continuing {
                                                    phi_9951_ = _e2065;
                                                    phi_9954_ = _e2075;
                                                    break if !(_e2070);
                                                }
                                            }
                                            let _e2080 = local_20;
                                            phi_10008_ = (_e2080 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e2087 = phi_10008_;
                                        let _e2089 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e2096 = ((_e1625 * f64(1.01f)) + ((_e1386 * _e2087) * (f64(1f) + _e2089)));
                                        let _e2101 = (((_e2026 * _e1389[0]) + (_e2027 * _e1389[1])) + (_e2028 * _e1389[2]));
                                        let _e2106 = (((_e2026 * _e1406) + (_e2027 * _e1407)) + (_e2028 * _e1408));
                                        let _e2111 = (((_e2026 * _e1416) + (_e2027 * _e1417)) + (_e2028 * _e1418));
                                        let _e2119 = (((_e2026 * _e1415[0]) + (_e2027 * _e1415[1])) + (_e2028 * _e1415[2]));
                                        let _e2125 = (((_e2026 * _e1421[0]) + (_e2027 * _e1421[1])) + (_e2028 * _e1421[2]));
                                        let _e2130 = (((_e2026 * _e1438) + (_e2027 * _e1439)) + (_e2028 * _e1440));
                                        let _e2135 = (((_e2026 * _e1448) + (_e2027 * _e1449)) + (_e2028 * _e1450));
                                        let _e2143 = (((_e2026 * _e1447[0]) + (_e2027 * _e1447[1])) + (_e2028 * _e1447[2]));
                                        if (_e2101 < 0.0lf) {
                                            phi_10077_ = -(_e2101);
                                        } else {
                                            phi_10077_ = _e2101;
                                        }
                                        let _e2148 = phi_10077_;
                                        if (_e2125 < 0.0lf) {
                                            phi_10083_ = -(_e2125);
                                        } else {
                                            phi_10083_ = _e2125;
                                        }
                                        let _e2152 = phi_10083_;
                                        if (_e2106 < 0.0lf) {
                                            phi_10092_ = -(_e2106);
                                        } else {
                                            phi_10092_ = _e2106;
                                        }
                                        let _e2159 = phi_10092_;
                                        if (_e2130 < 0.0lf) {
                                            phi_10098_ = -(_e2130);
                                        } else {
                                            phi_10098_ = _e2130;
                                        }
                                        let _e2163 = phi_10098_;
                                        if (_e2111 < 0.0lf) {
                                            phi_10107_ = -(_e2111);
                                        } else {
                                            phi_10107_ = _e2111;
                                        }
                                        let _e2170 = phi_10107_;
                                        if (_e2135 < 0.0lf) {
                                            phi_10113_ = -(_e2135);
                                        } else {
                                            phi_10113_ = _e2135;
                                        }
                                        let _e2174 = phi_10113_;
                                        if (_e2119 < 0.0lf) {
                                            phi_10122_ = -(_e2119);
                                        } else {
                                            phi_10122_ = _e2119;
                                        }
                                        let _e2181 = phi_10122_;
                                        if (_e2143 < 0.0lf) {
                                            phi_10128_ = -(_e2143);
                                        } else {
                                            phi_10128_ = _e2143;
                                        }
                                        let _e2185 = phi_10128_;
                                        phi_10134_ = type_35(array<f64, 4>(_e2101, _e2106, _e2111, _e2119), array<f64, 4>(_e2125, _e2130, _e2135, _e2143), array<f64, 4>((_e2096 + ((_e2148 + _e2152) * _e2089)), (_e2096 + ((_e2159 + _e2163) * _e2089)), (_e2096 + ((_e2170 + _e2174) * _e2089)), (_e2096 + ((_e2181 + _e2185) * _e2089))));
                                        phi_10135_ = false;
                                    } else {
                                        phi_10134_ = type_35();
                                        phi_10135_ = true;
                                    }
                                    let _e2192 = phi_10134_;
                                    let _e2194 = phi_10135_;
                                    phi_10136_ = _e2192;
                                    phi_10137_ = _e2194;
                                } else {
                                    phi_10136_ = type_35();
                                    phi_10137_ = true;
                                }
                                let _e2196 = phi_10136_;
                                let _e2198 = phi_10137_;
                                if _e2198 {
                                    let _e2199 = f64(0f);
                                    let _e2200 = f64(1f);
                                    phi_10147_ = type_35(array<f64, 4>(_e2199, _e2199, _e2199, _e2199), array<f64, 4>(_e2199, _e2199, _e2199, _e2199), array<f64, 4>(_e2200, _e2200, _e2200, _e2200));
                                } else {
                                    phi_10147_ = _e2196;
                                }
                                let _e2206 = phi_10147_;
                                local_9 = type_35(array<f64, 4>(_e2206.member[0], _e2206.member[1], _e2206.member[2], _e2206.member[3]), array<f64, 4>(_e2206.member_1[0], _e2206.member_1[1], _e2206.member_1[2], _e2206.member_1[3]), array<f64, 4>(_e2206.member_2[0], _e2206.member_2[1], _e2206.member_2[2], _e2206.member_2[3]));
                                let _e2226 = f64(0f);
                                let _e2229 = local_9.member[0u];
                                let _e2232 = local_9.member_1[0u];
                                let _e2235 = local_9.member[0u];
                                let _e2241 = local_9.member_2[0u];
                                if (((_e2229 + ((_e2232 - _e2235) * _e548)) - _e2241) > _e2226) {
                                    let _e2246 = local_9.member[1u];
                                    let _e2249 = local_9.member_1[1u];
                                    let _e2252 = local_9.member[1u];
                                    let _e2258 = local_9.member_2[1u];
                                    if (((_e2246 + ((_e2249 - _e2252) * _e548)) - _e2258) > _e2226) {
                                        let _e2263 = local_9.member[2u];
                                        let _e2266 = local_9.member_1[2u];
                                        let _e2269 = local_9.member[2u];
                                        let _e2275 = local_9.member_2[2u];
                                        if (((_e2263 + ((_e2266 - _e2269) * _e548)) - _e2275) > _e2226) {
                                            let _e2280 = local_9.member[3u];
                                            let _e2283 = local_9.member_1[3u];
                                            let _e2286 = local_9.member[3u];
                                            let _e2292 = local_9.member_2[3u];
                                            phi_10317_ = (((_e2280 + ((_e2283 - _e2286) * _e548)) - _e2292) > _e2226);
                                            phi_10318_ = false;
                                        } else {
                                            phi_10317_ = bool();
                                            phi_10318_ = true;
                                        }
                                        let _e2296 = phi_10317_;
                                        let _e2298 = phi_10318_;
                                        phi_10319_ = _e2296;
                                        phi_10320_ = _e2298;
                                    } else {
                                        phi_10319_ = bool();
                                        phi_10320_ = true;
                                    }
                                    let _e2300 = phi_10319_;
                                    let _e2302 = phi_10320_;
                                    phi_10321_ = _e2300;
                                    phi_10322_ = _e2302;
                                } else {
                                    phi_10321_ = bool();
                                    phi_10322_ = true;
                                }
                                let _e2304 = phi_10321_;
                                let _e2306 = phi_10322_;
                                if _e2306 {
                                    phi_10326_ = false;
                                } else {
                                    phi_10326_ = _e2304;
                                }
                                let _e2308 = phi_10326_;
                                if _e2308 {
                                    phi_11246_ = bool();
                                    phi_11247_ = true;
                                } else {
                                    let _e2309 = f64(0f);
                                    if (_e2309 < 0.0lf) {
                                        phi_10354_ = -(_e2309);
                                    } else {
                                        phi_10354_ = _e2309;
                                    }
                                    let _e2314 = phi_10354_;
                                    if (_e1692[1] < 0.0lf) {
                                        phi_10360_ = -(_e1692[1]);
                                    } else {
                                        phi_10360_ = _e1692[1];
                                    }
                                    let _e2318 = phi_10360_;
                                    if (_e2309 < 0.0lf) {
                                        phi_10367_ = -(_e2309);
                                    } else {
                                        phi_10367_ = _e2309;
                                    }
                                    let _e2323 = phi_10367_;
                                    let _e2324 = ((_e2314 + _e2318) + _e2323);
                                    if (_e2324 > f64(0f)) {
                                        if ((bitcast<u64>(_e2324) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e2331 = (f64(1f) / _e2324);
                                            let _e2332 = (_e2309 * _e2331);
                                            let _e2333 = (_e1692[1] * _e2331);
                                            let _e2334 = (_e2309 * _e2331);
                                            let _e2339 = (((_e2332 * _e2332) + (_e2333 * _e2333)) + (_e2334 * _e2334));
                                            if (_e2339 <= 2.2250738585072014e-308lf) {
                                                if (_e2339 > 0.0lf) {
                                                    phi_10403_ = (1.464336215552873e-154lf * 2.0lf);
                                                } else {
                                                    phi_10403_ = 0.0lf;
                                                }
                                                let _e2391 = phi_10403_;
                                                phi_10467_ = _e2391;
                                            } else {
                                                phi_10410_ = type_18(0i, 5i);
                                                phi_10413_ = bitcast<f64>(((bitcast<u64>(_e2339) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e2346 = phi_10410_;
                                                    let _e2348 = phi_10413_;
                                                    local_21 = _e2348;
                                                    if (_e2346.member < _e2346.member_1) {
                                                        let _e2355 = (_e2346.member + 1i);
                                                        if ((false == (_e2355 > _e2346.member)) != false) {
                                                            phi_10434_ = true;
                                                        } else {
                                                            phi_10434_ = false;
                                                        }
                                                        let _e2360 = phi_10434_;
                                                        if _e2360 {
                                                            phi_10440_ = type_19(0u, type_19().member_1);
                                                        } else {
                                                            phi_10440_ = type_19(1u, _e2355);
                                                        }
                                                        let _e2365 = phi_10440_;
                                                        phi_10411_ = type_18(_e2365.member_1, _e2346.member_1);
                                                        phi_10454_ = type_19(1u, _e2346.member);
                                                    } else {
                                                        phi_10411_ = _e2346;
                                                        phi_10454_ = type_19(0u, type_19().member_1);
                                                    }
                                                    let _e2371 = phi_10411_;
                                                    let _e2373 = phi_10454_;
                                                    let _e2376 = (bitcast<i32>(_e2373.member) != 0i);
                                                    if _e2376 {
                                                        phi_10414_ = (0.5lf * (_e2348 + (_e2339 / _e2348)));
                                                    } else {
                                                        phi_10414_ = f64();
                                                    }
                                                    let _e2381 = phi_10414_;
                                                    continue;
                                                    continuing {
                                                        phi_10410_ = _e2371;
                                                        phi_10413_ = _e2381;
                                                        break if !(_e2376);
                                                    }
                                                }
                                                let _e2386 = local_21;
                                                phi_10467_ = (_e2386 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e2393 = phi_10467_;
                                            let _e2395 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e2402 = ((_e1625 * f64(1.01f)) + ((_e1386 * _e2393) * (f64(1f) + _e2395)));
                                            let _e2407 = (((_e2332 * _e1389[0]) + (_e2333 * _e1389[1])) + (_e2334 * _e1389[2]));
                                            let _e2412 = (((_e2332 * _e1406) + (_e2333 * _e1407)) + (_e2334 * _e1408));
                                            let _e2417 = (((_e2332 * _e1416) + (_e2333 * _e1417)) + (_e2334 * _e1418));
                                            let _e2425 = (((_e2332 * _e1415[0]) + (_e2333 * _e1415[1])) + (_e2334 * _e1415[2]));
                                            let _e2431 = (((_e2332 * _e1421[0]) + (_e2333 * _e1421[1])) + (_e2334 * _e1421[2]));
                                            let _e2436 = (((_e2332 * _e1438) + (_e2333 * _e1439)) + (_e2334 * _e1440));
                                            let _e2441 = (((_e2332 * _e1448) + (_e2333 * _e1449)) + (_e2334 * _e1450));
                                            let _e2449 = (((_e2332 * _e1447[0]) + (_e2333 * _e1447[1])) + (_e2334 * _e1447[2]));
                                            if (_e2407 < 0.0lf) {
                                                phi_10536_ = -(_e2407);
                                            } else {
                                                phi_10536_ = _e2407;
                                            }
                                            let _e2454 = phi_10536_;
                                            if (_e2431 < 0.0lf) {
                                                phi_10542_ = -(_e2431);
                                            } else {
                                                phi_10542_ = _e2431;
                                            }
                                            let _e2458 = phi_10542_;
                                            if (_e2412 < 0.0lf) {
                                                phi_10551_ = -(_e2412);
                                            } else {
                                                phi_10551_ = _e2412;
                                            }
                                            let _e2465 = phi_10551_;
                                            if (_e2436 < 0.0lf) {
                                                phi_10557_ = -(_e2436);
                                            } else {
                                                phi_10557_ = _e2436;
                                            }
                                            let _e2469 = phi_10557_;
                                            if (_e2417 < 0.0lf) {
                                                phi_10566_ = -(_e2417);
                                            } else {
                                                phi_10566_ = _e2417;
                                            }
                                            let _e2476 = phi_10566_;
                                            if (_e2441 < 0.0lf) {
                                                phi_10572_ = -(_e2441);
                                            } else {
                                                phi_10572_ = _e2441;
                                            }
                                            let _e2480 = phi_10572_;
                                            if (_e2425 < 0.0lf) {
                                                phi_10581_ = -(_e2425);
                                            } else {
                                                phi_10581_ = _e2425;
                                            }
                                            let _e2487 = phi_10581_;
                                            if (_e2449 < 0.0lf) {
                                                phi_10587_ = -(_e2449);
                                            } else {
                                                phi_10587_ = _e2449;
                                            }
                                            let _e2491 = phi_10587_;
                                            phi_10593_ = type_35(array<f64, 4>(_e2407, _e2412, _e2417, _e2425), array<f64, 4>(_e2431, _e2436, _e2441, _e2449), array<f64, 4>((_e2402 + ((_e2454 + _e2458) * _e2395)), (_e2402 + ((_e2465 + _e2469) * _e2395)), (_e2402 + ((_e2476 + _e2480) * _e2395)), (_e2402 + ((_e2487 + _e2491) * _e2395))));
                                            phi_10594_ = false;
                                        } else {
                                            phi_10593_ = type_35();
                                            phi_10594_ = true;
                                        }
                                        let _e2498 = phi_10593_;
                                        let _e2500 = phi_10594_;
                                        phi_10595_ = _e2498;
                                        phi_10596_ = _e2500;
                                    } else {
                                        phi_10595_ = type_35();
                                        phi_10596_ = true;
                                    }
                                    let _e2502 = phi_10595_;
                                    let _e2504 = phi_10596_;
                                    if _e2504 {
                                        let _e2505 = f64(0f);
                                        let _e2506 = f64(1f);
                                        phi_10606_ = type_35(array<f64, 4>(_e2505, _e2505, _e2505, _e2505), array<f64, 4>(_e2505, _e2505, _e2505, _e2505), array<f64, 4>(_e2506, _e2506, _e2506, _e2506));
                                    } else {
                                        phi_10606_ = _e2502;
                                    }
                                    let _e2512 = phi_10606_;
                                    local_10 = type_35(array<f64, 4>(_e2512.member[0], _e2512.member[1], _e2512.member[2], _e2512.member[3]), array<f64, 4>(_e2512.member_1[0], _e2512.member_1[1], _e2512.member_1[2], _e2512.member_1[3]), array<f64, 4>(_e2512.member_2[0], _e2512.member_2[1], _e2512.member_2[2], _e2512.member_2[3]));
                                    let _e2532 = f64(0f);
                                    let _e2535 = local_10.member[0u];
                                    let _e2538 = local_10.member_1[0u];
                                    let _e2541 = local_10.member[0u];
                                    let _e2547 = local_10.member_2[0u];
                                    if (((_e2535 + ((_e2538 - _e2541) * _e548)) - _e2547) > _e2532) {
                                        let _e2552 = local_10.member[1u];
                                        let _e2555 = local_10.member_1[1u];
                                        let _e2558 = local_10.member[1u];
                                        let _e2564 = local_10.member_2[1u];
                                        if (((_e2552 + ((_e2555 - _e2558) * _e548)) - _e2564) > _e2532) {
                                            let _e2569 = local_10.member[2u];
                                            let _e2572 = local_10.member_1[2u];
                                            let _e2575 = local_10.member[2u];
                                            let _e2581 = local_10.member_2[2u];
                                            if (((_e2569 + ((_e2572 - _e2575) * _e548)) - _e2581) > _e2532) {
                                                let _e2586 = local_10.member[3u];
                                                let _e2589 = local_10.member_1[3u];
                                                let _e2592 = local_10.member[3u];
                                                let _e2598 = local_10.member_2[3u];
                                                phi_10776_ = (((_e2586 + ((_e2589 - _e2592) * _e548)) - _e2598) > _e2532);
                                                phi_10777_ = false;
                                            } else {
                                                phi_10776_ = bool();
                                                phi_10777_ = true;
                                            }
                                            let _e2602 = phi_10776_;
                                            let _e2604 = phi_10777_;
                                            phi_10778_ = _e2602;
                                            phi_10779_ = _e2604;
                                        } else {
                                            phi_10778_ = bool();
                                            phi_10779_ = true;
                                        }
                                        let _e2606 = phi_10778_;
                                        let _e2608 = phi_10779_;
                                        phi_10780_ = _e2606;
                                        phi_10781_ = _e2608;
                                    } else {
                                        phi_10780_ = bool();
                                        phi_10781_ = true;
                                    }
                                    let _e2610 = phi_10780_;
                                    let _e2612 = phi_10781_;
                                    if _e2612 {
                                        phi_10785_ = false;
                                    } else {
                                        phi_10785_ = _e2610;
                                    }
                                    let _e2614 = phi_10785_;
                                    if _e2614 {
                                        phi_11245_ = bool();
                                    } else {
                                        let _e2615 = f64(0f);
                                        if (_e2615 < 0.0lf) {
                                            phi_10813_ = -(_e2615);
                                        } else {
                                            phi_10813_ = _e2615;
                                        }
                                        let _e2620 = phi_10813_;
                                        if (_e2615 < 0.0lf) {
                                            phi_10819_ = -(_e2615);
                                        } else {
                                            phi_10819_ = _e2615;
                                        }
                                        let _e2624 = phi_10819_;
                                        if (_e1692[2] < 0.0lf) {
                                            phi_10826_ = -(_e1692[2]);
                                        } else {
                                            phi_10826_ = _e1692[2];
                                        }
                                        let _e2629 = phi_10826_;
                                        let _e2630 = ((_e2620 + _e2624) + _e2629);
                                        if (_e2630 > f64(0f)) {
                                            if ((bitcast<u64>(_e2630) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2637 = (f64(1f) / _e2630);
                                                let _e2638 = (_e2615 * _e2637);
                                                let _e2639 = (_e2615 * _e2637);
                                                let _e2640 = (_e1692[2] * _e2637);
                                                let _e2645 = (((_e2638 * _e2638) + (_e2639 * _e2639)) + (_e2640 * _e2640));
                                                if (_e2645 <= 2.2250738585072014e-308lf) {
                                                    if (_e2645 > 0.0lf) {
                                                        phi_10862_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_10862_ = 0.0lf;
                                                    }
                                                    let _e2697 = phi_10862_;
                                                    phi_10926_ = _e2697;
                                                } else {
                                                    phi_10869_ = type_18(0i, 5i);
                                                    phi_10872_ = bitcast<f64>(((bitcast<u64>(_e2645) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2652 = phi_10869_;
                                                        let _e2654 = phi_10872_;
                                                        local_22 = _e2654;
                                                        if (_e2652.member < _e2652.member_1) {
                                                            let _e2661 = (_e2652.member + 1i);
                                                            if ((false == (_e2661 > _e2652.member)) != false) {
                                                                phi_10893_ = true;
                                                            } else {
                                                                phi_10893_ = false;
                                                            }
                                                            let _e2666 = phi_10893_;
                                                            if _e2666 {
                                                                phi_10899_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_10899_ = type_19(1u, _e2661);
                                                            }
                                                            let _e2671 = phi_10899_;
                                                            phi_10870_ = type_18(_e2671.member_1, _e2652.member_1);
                                                            phi_10913_ = type_19(1u, _e2652.member);
                                                        } else {
                                                            phi_10870_ = _e2652;
                                                            phi_10913_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e2677 = phi_10870_;
                                                        let _e2679 = phi_10913_;
                                                        let _e2682 = (bitcast<i32>(_e2679.member) != 0i);
                                                        if _e2682 {
                                                            phi_10873_ = (0.5lf * (_e2654 + (_e2645 / _e2654)));
                                                        } else {
                                                            phi_10873_ = f64();
                                                        }
                                                        let _e2687 = phi_10873_;
                                                        continue;
                                                        continuing {
                                                            phi_10869_ = _e2677;
                                                            phi_10872_ = _e2687;
                                                            break if !(_e2682);
                                                        }
                                                    }
                                                    let _e2692 = local_22;
                                                    phi_10926_ = (_e2692 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2699 = phi_10926_;
                                                let _e2701 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2708 = ((_e1625 * f64(1.01f)) + ((_e1386 * _e2699) * (f64(1f) + _e2701)));
                                                let _e2713 = (((_e2638 * _e1389[0]) + (_e2639 * _e1389[1])) + (_e2640 * _e1389[2]));
                                                let _e2718 = (((_e2638 * _e1406) + (_e2639 * _e1407)) + (_e2640 * _e1408));
                                                let _e2723 = (((_e2638 * _e1416) + (_e2639 * _e1417)) + (_e2640 * _e1418));
                                                let _e2731 = (((_e2638 * _e1415[0]) + (_e2639 * _e1415[1])) + (_e2640 * _e1415[2]));
                                                let _e2737 = (((_e2638 * _e1421[0]) + (_e2639 * _e1421[1])) + (_e2640 * _e1421[2]));
                                                let _e2742 = (((_e2638 * _e1438) + (_e2639 * _e1439)) + (_e2640 * _e1440));
                                                let _e2747 = (((_e2638 * _e1448) + (_e2639 * _e1449)) + (_e2640 * _e1450));
                                                let _e2755 = (((_e2638 * _e1447[0]) + (_e2639 * _e1447[1])) + (_e2640 * _e1447[2]));
                                                if (_e2713 < 0.0lf) {
                                                    phi_10995_ = -(_e2713);
                                                } else {
                                                    phi_10995_ = _e2713;
                                                }
                                                let _e2760 = phi_10995_;
                                                if (_e2737 < 0.0lf) {
                                                    phi_11001_ = -(_e2737);
                                                } else {
                                                    phi_11001_ = _e2737;
                                                }
                                                let _e2764 = phi_11001_;
                                                if (_e2718 < 0.0lf) {
                                                    phi_11010_ = -(_e2718);
                                                } else {
                                                    phi_11010_ = _e2718;
                                                }
                                                let _e2771 = phi_11010_;
                                                if (_e2742 < 0.0lf) {
                                                    phi_11016_ = -(_e2742);
                                                } else {
                                                    phi_11016_ = _e2742;
                                                }
                                                let _e2775 = phi_11016_;
                                                if (_e2723 < 0.0lf) {
                                                    phi_11025_ = -(_e2723);
                                                } else {
                                                    phi_11025_ = _e2723;
                                                }
                                                let _e2782 = phi_11025_;
                                                if (_e2747 < 0.0lf) {
                                                    phi_11031_ = -(_e2747);
                                                } else {
                                                    phi_11031_ = _e2747;
                                                }
                                                let _e2786 = phi_11031_;
                                                if (_e2731 < 0.0lf) {
                                                    phi_11040_ = -(_e2731);
                                                } else {
                                                    phi_11040_ = _e2731;
                                                }
                                                let _e2793 = phi_11040_;
                                                if (_e2755 < 0.0lf) {
                                                    phi_11046_ = -(_e2755);
                                                } else {
                                                    phi_11046_ = _e2755;
                                                }
                                                let _e2797 = phi_11046_;
                                                phi_11052_ = type_35(array<f64, 4>(_e2713, _e2718, _e2723, _e2731), array<f64, 4>(_e2737, _e2742, _e2747, _e2755), array<f64, 4>((_e2708 + ((_e2760 + _e2764) * _e2701)), (_e2708 + ((_e2771 + _e2775) * _e2701)), (_e2708 + ((_e2782 + _e2786) * _e2701)), (_e2708 + ((_e2793 + _e2797) * _e2701))));
                                                phi_11053_ = false;
                                            } else {
                                                phi_11052_ = type_35();
                                                phi_11053_ = true;
                                            }
                                            let _e2804 = phi_11052_;
                                            let _e2806 = phi_11053_;
                                            phi_11054_ = _e2804;
                                            phi_11055_ = _e2806;
                                        } else {
                                            phi_11054_ = type_35();
                                            phi_11055_ = true;
                                        }
                                        let _e2808 = phi_11054_;
                                        let _e2810 = phi_11055_;
                                        if _e2810 {
                                            let _e2811 = f64(0f);
                                            let _e2812 = f64(1f);
                                            phi_11065_ = type_35(array<f64, 4>(_e2811, _e2811, _e2811, _e2811), array<f64, 4>(_e2811, _e2811, _e2811, _e2811), array<f64, 4>(_e2812, _e2812, _e2812, _e2812));
                                        } else {
                                            phi_11065_ = _e2808;
                                        }
                                        let _e2818 = phi_11065_;
                                        local_11 = type_35(array<f64, 4>(_e2818.member[0], _e2818.member[1], _e2818.member[2], _e2818.member[3]), array<f64, 4>(_e2818.member_1[0], _e2818.member_1[1], _e2818.member_1[2], _e2818.member_1[3]), array<f64, 4>(_e2818.member_2[0], _e2818.member_2[1], _e2818.member_2[2], _e2818.member_2[3]));
                                        let _e2838 = f64(0f);
                                        let _e2841 = local_11.member[0u];
                                        let _e2844 = local_11.member_1[0u];
                                        let _e2847 = local_11.member[0u];
                                        let _e2853 = local_11.member_2[0u];
                                        if (((_e2841 + ((_e2844 - _e2847) * _e548)) - _e2853) > _e2838) {
                                            let _e2858 = local_11.member[1u];
                                            let _e2861 = local_11.member_1[1u];
                                            let _e2864 = local_11.member[1u];
                                            let _e2870 = local_11.member_2[1u];
                                            if (((_e2858 + ((_e2861 - _e2864) * _e548)) - _e2870) > _e2838) {
                                                let _e2875 = local_11.member[2u];
                                                let _e2878 = local_11.member_1[2u];
                                                let _e2881 = local_11.member[2u];
                                                let _e2887 = local_11.member_2[2u];
                                                if (((_e2875 + ((_e2878 - _e2881) * _e548)) - _e2887) > _e2838) {
                                                    let _e2892 = local_11.member[3u];
                                                    let _e2895 = local_11.member_1[3u];
                                                    let _e2898 = local_11.member[3u];
                                                    let _e2904 = local_11.member_2[3u];
                                                    phi_11235_ = (((_e2892 + ((_e2895 - _e2898) * _e548)) - _e2904) > _e2838);
                                                    phi_11236_ = false;
                                                } else {
                                                    phi_11235_ = bool();
                                                    phi_11236_ = true;
                                                }
                                                let _e2908 = phi_11235_;
                                                let _e2910 = phi_11236_;
                                                phi_11237_ = _e2908;
                                                phi_11238_ = _e2910;
                                            } else {
                                                phi_11237_ = bool();
                                                phi_11238_ = true;
                                            }
                                            let _e2912 = phi_11237_;
                                            let _e2914 = phi_11238_;
                                            phi_11239_ = _e2912;
                                            phi_11240_ = _e2914;
                                        } else {
                                            phi_11239_ = bool();
                                            phi_11240_ = true;
                                        }
                                        let _e2916 = phi_11239_;
                                        let _e2918 = phi_11240_;
                                        if _e2918 {
                                            phi_11244_ = false;
                                        } else {
                                            phi_11244_ = _e2916;
                                        }
                                        let _e2920 = phi_11244_;
                                        phi_11245_ = _e2920;
                                    }
                                    let _e2922 = phi_11245_;
                                    phi_11246_ = _e2922;
                                    phi_11247_ = _e2614;
                                }
                                let _e2924 = phi_11246_;
                                let _e2926 = phi_11247_;
                                phi_11248_ = _e2924;
                                phi_11249_ = _e2926;
                            }
                            let _e2928 = phi_11248_;
                            let _e2930 = phi_11249_;
                            if _e2930 {
                                phi_11253_ = true;
                            } else {
                                phi_11253_ = _e2928;
                            }
                            let _e2932 = phi_11253_;
                            if !(_e2932) {
                                phi_11259_ = type_43(2u, _e548);
                                phi_11260_ = false;
                            } else {
                                phi_11259_ = type_43();
                                phi_11260_ = true;
                            }
                            let _e2936 = phi_11259_;
                            let _e2938 = phi_11260_;
                            phi_11261_ = _e2936;
                            phi_11262_ = _e2938;
                        } else {
                            phi_11261_ = type_43();
                            phi_11262_ = true;
                        }
                        let _e2940 = phi_11261_;
                        let _e2942 = phi_11262_;
                        if _e2942 {
                            let _e2943 = f64(0f);
                            let _e2944 = f64(1f);
                            let _e2945 = f64(3f);
                            let _e2951 = ((_e989 - (_e2945 * _e966)) * _e1360);
                            let _e2952 = ((_e1012 - _e989) * _e1360);
                            let _e2953 = (((_e2945 * _e1023) - _e1012) * _e1360);
                            local_6[0u] = _e2943;
                            local_6[1u] = _e2944;
                            local_6[2u] = _e2944;
                            local_6[3u] = _e2944;
                            let _e2960 = ((_e2952 * _e2952) - (_e2951 * _e2953));
                            if (_e2960 > _e2943) {
                                if (_e2960 <= 2.2250738585072014e-308lf) {
                                    if (_e2960 > 0.0lf) {
                                        phi_11301_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_11301_ = 0.0lf;
                                    }
                                    let _e3013 = phi_11301_;
                                    phi_11365_ = _e3013;
                                } else {
                                    phi_11308_ = type_18(0i, 5i);
                                    phi_11311_ = bitcast<f64>(((bitcast<u64>(_e2960) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2968 = phi_11308_;
                                        let _e2970 = phi_11311_;
                                        local_23 = _e2970;
                                        if (_e2968.member < _e2968.member_1) {
                                            let _e2977 = (_e2968.member + 1i);
                                            if ((false == (_e2977 > _e2968.member)) != false) {
                                                phi_11332_ = true;
                                            } else {
                                                phi_11332_ = false;
                                            }
                                            let _e2982 = phi_11332_;
                                            if _e2982 {
                                                phi_11338_ = type_19(0u, type_19().member_1);
                                            } else {
                                                phi_11338_ = type_19(1u, _e2977);
                                            }
                                            let _e2987 = phi_11338_;
                                            phi_11309_ = type_18(_e2987.member_1, _e2968.member_1);
                                            phi_11352_ = type_19(1u, _e2968.member);
                                        } else {
                                            phi_11309_ = _e2968;
                                            phi_11352_ = type_19(0u, type_19().member_1);
                                        }
                                        let _e2993 = phi_11309_;
                                        let _e2995 = phi_11352_;
                                        let _e2998 = (bitcast<i32>(_e2995.member) != 0i);
                                        if _e2998 {
                                            phi_11312_ = (0.5lf * (_e2970 + (_e2960 / _e2970)));
                                        } else {
                                            phi_11312_ = f64();
                                        }
                                        let _e3003 = phi_11312_;
                                        continue;
                                        continuing {
                                            phi_11308_ = _e2993;
                                            phi_11311_ = _e3003;
                                            break if !(_e2998);
                                        }
                                    }
                                    let _e3008 = local_23;
                                    phi_11365_ = (_e3008 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e3015 = phi_11365_;
                                if (_e2952 < _e2943) {
                                    phi_11371_ = -(_e3015);
                                } else {
                                    phi_11371_ = _e3015;
                                }
                                let _e3019 = phi_11371_;
                                let _e3021 = -((_e2952 + _e3019));
                                local_7[0u] = (_e3021 / (_e3021 + _e2953));
                                local_7[1u] = (_e2951 / (_e2951 + _e3021));
                                let _e3030 = local_7[1u];
                                let _e3031 = local_7[0u];
                                if (_e3030 < _e3031) {
                                    let _e3034 = local_7[1u];
                                    let _e3036 = local_7[0u];
                                    local_7[0u] = _e3034;
                                    local_7[1u] = _e3036;
                                }
                                phi_11396_ = type_9(0u, 2u);
                                phi_11399_ = 1u;
                                loop {
                                    let _e3040 = phi_11396_;
                                    let _e3042 = phi_11399_;
                                    local_64 = _e3042;
                                    if (_e3040.member < _e3040.member_1) {
                                        phi_11397_ = type_9((_e3040.member + 1u), _e3040.member_1);
                                        phi_11422_ = type_9(1u, _e3040.member);
                                    } else {
                                        phi_11397_ = _e3040;
                                        phi_11422_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e3054 = phi_11397_;
                                    let _e3056 = phi_11422_;
                                    let _e3060 = (bitcast<i32>(_e3056.member) != 0i);
                                    if _e3060 {
                                        let _e3062 = local_7[_e3056.member_1];
                                        if (_e3062 > _e2943) {
                                            let _e3065 = local_7[_e3056.member_1];
                                            if (_e3065 < _e2944) {
                                                let _e3068 = local_7[_e3056.member_1];
                                                local_6[_e3042] = _e3068;
                                                phi_11466_ = (_e3042 + 1u);
                                            } else {
                                                phi_11466_ = _e3042;
                                            }
                                            let _e3072 = phi_11466_;
                                            phi_11467_ = _e3072;
                                        } else {
                                            phi_11467_ = _e3042;
                                        }
                                        let _e3074 = phi_11467_;
                                        phi_11400_ = _e3074;
                                    } else {
                                        phi_11400_ = u32();
                                    }
                                    let _e3076 = phi_11400_;
                                    continue;
                                    continuing {
                                        phi_11396_ = _e3054;
                                        phi_11399_ = _e3076;
                                        break if !(_e3060);
                                    }
                                }
                                let _e11246 = local_64;
                                phi_11468_ = _e11246;
                            } else {
                                phi_11468_ = 1u;
                            }
                            let _e3079 = phi_11468_;
                            local_6[_e3079] = _e2944;
                            let _e3081 = local_6;
                            local_12 = _e3081;
                            phi_11488_ = type_9(0u, _e3079);
                            loop {
                                let _e3084 = phi_11488_;
                                if (_e3084.member < _e3084.member_1) {
                                    phi_11489_ = type_9((_e3084.member + 1u), _e3084.member_1);
                                    phi_11512_ = type_9(1u, _e3084.member);
                                } else {
                                    phi_11489_ = _e3084;
                                    phi_11512_ = type_9(0u, type_9().member_1);
                                }
                                let _e3096 = phi_11489_;
                                let _e3098 = phi_11512_;
                                if (bitcast<i32>(_e3098.member) != 0i) {
                                    let _e3104 = local_12[_e3098.member_1];
                                    if (_e3104 > _e548) {
                                        phi_11531_ = _e3104;
                                    } else {
                                        phi_11531_ = _e548;
                                    }
                                    let _e3107 = phi_11531_;
                                    let _e3110 = local_12[(_e3098.member_1 + 1u)];
                                    if (_e3110 < _e557) {
                                        phi_11544_ = _e3110;
                                    } else {
                                        phi_11544_ = _e557;
                                    }
                                    let _e3113 = phi_11544_;
                                    if (_e3107 <= _e3113) {
                                        let _e3116 = (f64(1f) - _e3107);
                                        let _e3127 = ((((_e966 * _e3116) + (_e989 * _e3107)) * (_e3116 * _e3116)) + (((_e1012 * _e3116) + (_e1023 * _e3107)) * (_e3107 * _e3107)));
                                        let _e3129 = (f64(1f) - _e3113);
                                        let _e3140 = ((((_e966 * _e3129) + (_e989 * _e3113)) * (_e3129 * _e3129)) + (((_e1012 * _e3129) + (_e1023 * _e3113)) * (_e3113 * _e3113)));
                                        if (_e3127 < 0.0lf) {
                                            phi_11580_ = -(_e3127);
                                        } else {
                                            phi_11580_ = _e3127;
                                        }
                                        let _e3144 = phi_11580_;
                                        let _e3145 = (_e3144 > _e1356);
                                        if (_e3140 < 0.0lf) {
                                            phi_11587_ = -(_e3140);
                                        } else {
                                            phi_11587_ = _e3140;
                                        }
                                        let _e3149 = phi_11587_;
                                        let _e3150 = (_e3149 > _e1356);
                                        let _e3151 = f64(0f);
                                        if _e3145 {
                                            if _e3150 {
                                                phi_11599_ = ((_e3127 > _e3151) != (_e3140 > _e3151));
                                                phi_11600_ = false;
                                            } else {
                                                phi_11599_ = bool();
                                                phi_11600_ = true;
                                            }
                                            let _e3156 = phi_11599_;
                                            let _e3158 = phi_11600_;
                                            phi_11601_ = _e3156;
                                            phi_11602_ = _e3158;
                                        } else {
                                            phi_11601_ = bool();
                                            phi_11602_ = true;
                                        }
                                        let _e3160 = phi_11601_;
                                        let _e3162 = phi_11602_;
                                        if _e3162 {
                                            phi_11606_ = false;
                                        } else {
                                            phi_11606_ = _e3160;
                                        }
                                        let _e3164 = phi_11606_;
                                        if _e3145 {
                                            if _e3150 {
                                                if _e3164 {
                                                    phi_11618_ = type_46();
                                                } else {
                                                    phi_11618_ = type_46(f64(1f), _e3151, _e3164);
                                                }
                                                let _e3168 = phi_11618_;
                                                phi_11619_ = _e3168;
                                                phi_11620_ = _e3164;
                                            } else {
                                                phi_11619_ = type_46();
                                                phi_11620_ = true;
                                            }
                                            let _e3170 = phi_11619_;
                                            let _e3172 = phi_11620_;
                                            phi_11621_ = _e3170;
                                            phi_11622_ = _e3172;
                                        } else {
                                            phi_11621_ = type_46();
                                            phi_11622_ = true;
                                        }
                                        let _e3174 = phi_11621_;
                                        let _e3176 = phi_11622_;
                                        if _e3176 {
                                            if _e3145 {
                                                if (_e3127 < _e3151) {
                                                    phi_11635_ = f64(-1f);
                                                } else {
                                                    phi_11635_ = f64(1f);
                                                }
                                                let _e3181 = phi_11635_;
                                                let _e3182 = f64(0.5f);
                                                let _e3183 = f64(3f);
                                                let _e3186 = (_e1012 - _e989);
                                                phi_11647_ = type_9(0u, 64u);
                                                phi_11650_ = _e3113;
                                                phi_11652_ = _e3107;
                                                phi_11654_ = (_e3182 * (_e3107 + _e3113));
                                                loop {
                                                    let _e3192 = phi_11647_;
                                                    let _e3194 = phi_11650_;
                                                    let _e3196 = phi_11652_;
                                                    let _e3198 = phi_11654_;
                                                    local_66 = _e3196;
                                                    if (_e3192.member < _e3192.member_1) {
                                                        phi_11648_ = type_9((_e3192.member + 1u), _e3192.member_1);
                                                        phi_11677_ = type_9(1u, _e3192.member);
                                                    } else {
                                                        phi_11648_ = _e3192;
                                                        phi_11677_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e3210 = phi_11648_;
                                                    let _e3212 = phi_11677_;
                                                    if (bitcast<i32>(_e3212.member) != 0i) {
                                                        let _e3217 = (f64(1f) - _e3198);
                                                        let _e3230 = ((_e3181 * ((((_e966 * _e3217) + (_e989 * _e3198)) * (_e3217 * _e3217)) + (((_e1012 * _e3217) + (_e1023 * _e3198)) * (_e3198 * _e3198)))) - _e1356);
                                                        if (_e3230 > f64(0f)) {
                                                            phi_11704_ = _e3194;
                                                            phi_11705_ = _e3198;
                                                        } else {
                                                            phi_11704_ = _e3198;
                                                            phi_11705_ = _e3196;
                                                        }
                                                        let _e3234 = phi_11704_;
                                                        let _e3236 = phi_11705_;
                                                        let _e3238 = ((_e3234 - _e3236) > _e1366);
                                                        if _e3238 {
                                                            let _e3240 = (f64(1f) - _e3198);
                                                            let _e3252 = (-(_e3230) / (_e3181 * (((((_e989 - (_e3183 * _e966)) * _e3240) + (_e3186 * _e3198)) * _e3240) + (((_e3186 * _e3240) + (((_e3183 * _e1023) - _e1012) * _e3198)) * _e3198))));
                                                            if (_e3230 > f64(0f)) {
                                                                phi_11733_ = (_e3182 * _e1366);
                                                            } else {
                                                                phi_11733_ = -((_e3182 * _e1366));
                                                            }
                                                            let _e3259 = phi_11733_;
                                                            let _e3261 = ((_e3198 + _e3252) + _e3259);
                                                            if (_e3261 > _e3236) {
                                                                if (_e3261 < _e3234) {
                                                                    if (_e3252 < 0.0lf) {
                                                                        phi_11749_ = -(_e3252);
                                                                    } else {
                                                                        phi_11749_ = _e3252;
                                                                    }
                                                                    let _e3267 = phi_11749_;
                                                                    if (_e3267 < (_e3182 * (_e3234 - _e3236))) {
                                                                        phi_11756_ = false;
                                                                    } else {
                                                                        phi_11756_ = true;
                                                                    }
                                                                    let _e3272 = phi_11756_;
                                                                    phi_11757_ = _e3272;
                                                                } else {
                                                                    phi_11757_ = true;
                                                                }
                                                                let _e3274 = phi_11757_;
                                                                phi_11758_ = _e3274;
                                                            } else {
                                                                phi_11758_ = true;
                                                            }
                                                            let _e3276 = phi_11758_;
                                                            if _e3276 {
                                                                phi_11764_ = (_e3182 * (_e3236 + _e3234));
                                                            } else {
                                                                phi_11764_ = _e3261;
                                                            }
                                                            let _e3280 = phi_11764_;
                                                            phi_11765_ = _e3280;
                                                            phi_11766_ = false;
                                                        } else {
                                                            phi_11765_ = f64();
                                                            phi_11766_ = true;
                                                        }
                                                        let _e3282 = phi_11765_;
                                                        let _e3284 = phi_11766_;
                                                        phi_11651_ = _e3234;
                                                        phi_11653_ = _e3236;
                                                        phi_11655_ = _e3282;
                                                        phi_11767_ = _e3236;
                                                        phi_11768_ = _e3238;
                                                        phi_11769_ = _e3284;
                                                    } else {
                                                        phi_11651_ = f64();
                                                        phi_11653_ = f64();
                                                        phi_11655_ = f64();
                                                        phi_11767_ = f64();
                                                        phi_11768_ = false;
                                                        phi_11769_ = false;
                                                    }
                                                    let _e3286 = phi_11651_;
                                                    let _e3288 = phi_11653_;
                                                    let _e3290 = phi_11655_;
                                                    let _e3292 = phi_11767_;
                                                    let _e3294 = phi_11768_;
                                                    let _e3296 = phi_11769_;
                                                    local_24 = _e3296;
                                                    local_65 = _e3292;
                                                    continue;
                                                    continuing {
                                                        phi_11647_ = _e3210;
                                                        phi_11650_ = _e3286;
                                                        phi_11652_ = _e3288;
                                                        phi_11654_ = _e3290;
                                                        break if !(_e3294);
                                                    }
                                                }
                                                let _e3299 = local_24;
                                                if _e3299 {
                                                    let _e11290 = local_65;
                                                    phi_11773_ = _e11290;
                                                } else {
                                                    let _e11292 = local_66;
                                                    phi_11773_ = _e11292;
                                                }
                                                let _e3301 = phi_11773_;
                                                phi_11774_ = _e3301;
                                            } else {
                                                phi_11774_ = _e3107;
                                            }
                                            let _e3303 = phi_11774_;
                                            if _e3150 {
                                                if (_e3140 < _e3151) {
                                                    phi_11784_ = f64(-1f);
                                                } else {
                                                    phi_11784_ = f64(1f);
                                                }
                                                let _e3308 = phi_11784_;
                                                phi_11788_ = type_9(0u, 64u);
                                                phi_11791_ = (_e1366 + _e1366);
                                                loop {
                                                    let _e3311 = phi_11788_;
                                                    let _e3313 = phi_11791_;
                                                    if (_e3311.member < _e3311.member_1) {
                                                        phi_11789_ = type_9((_e3311.member + 1u), _e3311.member_1);
                                                        phi_11814_ = type_9(1u, _e3311.member);
                                                    } else {
                                                        phi_11789_ = _e3311;
                                                        phi_11814_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e3325 = phi_11789_;
                                                    let _e3327 = phi_11814_;
                                                    if (bitcast<i32>(_e3327.member) != 0i) {
                                                        let _e3331 = (_e3303 + _e3313);
                                                        if (_e3331 < _e3113) {
                                                            let _e3334 = (f64(1f) - _e3331);
                                                            let _e3347 = ((_e3308 * ((((_e966 * _e3334) + (_e989 * _e3331)) * (_e3334 * _e3334)) + (((_e1012 * _e3334) + (_e1023 * _e3331)) * (_e3331 * _e3331)))) > _e1356);
                                                            if _e3347 {
                                                                phi_11845_ = f64();
                                                                phi_11846_ = false;
                                                            } else {
                                                                phi_11845_ = (_e3313 + _e3313);
                                                                phi_11846_ = true;
                                                            }
                                                            let _e3350 = phi_11845_;
                                                            let _e3352 = phi_11846_;
                                                            phi_11847_ = _e3350;
                                                            phi_11848_ = _e3352;
                                                            phi_11849_ = _e3347;
                                                            phi_11850_ = false;
                                                        } else {
                                                            phi_11847_ = f64();
                                                            phi_11848_ = false;
                                                            phi_11849_ = false;
                                                            phi_11850_ = true;
                                                        }
                                                        let _e3354 = phi_11847_;
                                                        let _e3356 = phi_11848_;
                                                        let _e3358 = phi_11849_;
                                                        let _e3360 = phi_11850_;
                                                        phi_11851_ = _e3331;
                                                        phi_11792_ = _e3354;
                                                        phi_11852_ = _e3356;
                                                        phi_11853_ = _e3358;
                                                        phi_11854_ = _e3360;
                                                        phi_11855_ = false;
                                                    } else {
                                                        phi_11851_ = f64();
                                                        phi_11792_ = f64();
                                                        phi_11852_ = false;
                                                        phi_11853_ = false;
                                                        phi_11854_ = false;
                                                        phi_11855_ = true;
                                                    }
                                                    let _e3362 = phi_11851_;
                                                    let _e3364 = phi_11792_;
                                                    let _e3366 = phi_11852_;
                                                    let _e3368 = phi_11853_;
                                                    let _e3370 = phi_11854_;
                                                    let _e3372 = phi_11855_;
                                                    local_25 = _e3368;
                                                    local_67 = _e3370;
                                                    local_68 = _e3372;
                                                    local_69 = _e3362;
                                                    continue;
                                                    continuing {
                                                        phi_11788_ = _e3325;
                                                        phi_11791_ = _e3364;
                                                        break if !(_e3366);
                                                    }
                                                }
                                                let _e3375 = local_25;
                                                if _e3375 {
                                                    phi_11859_ = false;
                                                    phi_11860_ = false;
                                                } else {
                                                    let _e11314 = local_67;
                                                    phi_11859_ = _e11314;
                                                    let _e11317 = local_68;
                                                    phi_11860_ = _e11317;
                                                }
                                                let _e3377 = phi_11859_;
                                                let _e3379 = phi_11860_;
                                                if _e3377 {
                                                    phi_11864_ = true;
                                                } else {
                                                    phi_11864_ = _e3379;
                                                }
                                                let _e3381 = phi_11864_;
                                                if _e3381 {
                                                    phi_11868_ = _e3113;
                                                } else {
                                                    let _e11321 = local_69;
                                                    phi_11868_ = _e11321;
                                                }
                                                let _e3383 = phi_11868_;
                                                phi_11869_ = _e3383;
                                            } else {
                                                phi_11869_ = _e3113;
                                            }
                                            let _e3385 = phi_11869_;
                                            phi_11871_ = type_46(_e3303, _e3385, _e3164);
                                        } else {
                                            phi_11871_ = _e3174;
                                        }
                                        let _e3388 = phi_11871_;
                                        if (_e3388.member > _e3388.member_1) {
                                            phi_15738_ = bool();
                                            phi_15739_ = f64();
                                            phi_15740_ = f64();
                                            phi_15741_ = true;
                                            phi_15742_ = false;
                                            phi_15743_ = false;
                                            phi_15744_ = false;
                                        } else {
                                            let _e3396 = ((_e3388.member_1 - _e3388.member) * f64(0.5f));
                                            let _e3397 = (_e3388.member + _e3396);
                                            let _e3400 = (_e3396 + (1.1102230246251565e-16lf * f64(4f)));
                                            let _e3402 = local_18.member_3;
                                            let _e3405 = local_18.member[0u];
                                            if (_e3405[0] < 0.0lf) {
                                                phi_11902_ = -(_e3405[0]);
                                            } else {
                                                phi_11902_ = _e3405[0];
                                            }
                                            let _e3412 = phi_11902_;
                                            if (_e3405[1] < 0.0lf) {
                                                phi_11909_ = -(_e3405[1]);
                                            } else {
                                                phi_11909_ = _e3405[1];
                                            }
                                            let _e3416 = phi_11909_;
                                            if (_e3412 > _e3416) {
                                                phi_11914_ = _e3412;
                                            } else {
                                                phi_11914_ = _e3416;
                                            }
                                            let _e3419 = phi_11914_;
                                            if (_e3405[2] < 0.0lf) {
                                                phi_11921_ = -(_e3405[2]);
                                            } else {
                                                phi_11921_ = _e3405[2];
                                            }
                                            let _e3423 = phi_11921_;
                                            if (_e3419 > _e3423) {
                                                phi_11926_ = _e3419;
                                            } else {
                                                phi_11926_ = _e3423;
                                            }
                                            let _e3426 = phi_11926_;
                                            let _e3428 = local_18.member[1u];
                                            if (_e3428[0] < 0.0lf) {
                                                phi_11939_ = -(_e3428[0]);
                                            } else {
                                                phi_11939_ = _e3428[0];
                                            }
                                            let _e3435 = phi_11939_;
                                            if (_e3428[1] < 0.0lf) {
                                                phi_11946_ = -(_e3428[1]);
                                            } else {
                                                phi_11946_ = _e3428[1];
                                            }
                                            let _e3439 = phi_11946_;
                                            if (_e3435 > _e3439) {
                                                phi_11951_ = _e3435;
                                            } else {
                                                phi_11951_ = _e3439;
                                            }
                                            let _e3442 = phi_11951_;
                                            if (_e3428[2] < 0.0lf) {
                                                phi_11958_ = -(_e3428[2]);
                                            } else {
                                                phi_11958_ = _e3428[2];
                                            }
                                            let _e3446 = phi_11958_;
                                            if (_e3442 > _e3446) {
                                                phi_11963_ = _e3442;
                                            } else {
                                                phi_11963_ = _e3446;
                                            }
                                            let _e3449 = phi_11963_;
                                            if (_e3426 > _e3449) {
                                                phi_11968_ = _e3426;
                                            } else {
                                                phi_11968_ = _e3449;
                                            }
                                            let _e3452 = phi_11968_;
                                            let _e3455 = local_18.member[0u];
                                            let _e3460 = local_18.member[1u];
                                            let _e3470 = (_e3455[0] + ((_e3460[0] - _e3455[0]) * _e3397));
                                            let _e3471 = (_e3455[1] + ((_e3460[1] - _e3455[1]) * _e3397));
                                            let _e3472 = (_e3455[2] + ((_e3460[2] - _e3455[2]) * _e3397));
                                            let _e3474 = local_18.member[1u];
                                            let _e3479 = local_18.member[0u];
                                            let _e3483 = (_e3474[0] - _e3479[0]);
                                            let _e3484 = (_e3474[1] - _e3479[1]);
                                            let _e3485 = (_e3474[2] - _e3479[2]);
                                            if (_e3483 < 0.0lf) {
                                                phi_12027_ = -(_e3483);
                                            } else {
                                                phi_12027_ = _e3483;
                                            }
                                            let _e3489 = phi_12027_;
                                            if (_e3484 < 0.0lf) {
                                                phi_12033_ = -(_e3484);
                                            } else {
                                                phi_12033_ = _e3484;
                                            }
                                            let _e3493 = phi_12033_;
                                            if (_e3489 > _e3493) {
                                                phi_12038_ = _e3489;
                                            } else {
                                                phi_12038_ = _e3493;
                                            }
                                            let _e3496 = phi_12038_;
                                            if (_e3485 < 0.0lf) {
                                                phi_12044_ = -(_e3485);
                                            } else {
                                                phi_12044_ = _e3485;
                                            }
                                            let _e3500 = phi_12044_;
                                            if (_e3496 > _e3500) {
                                                phi_12049_ = _e3496;
                                            } else {
                                                phi_12049_ = _e3500;
                                            }
                                            let _e3503 = phi_12049_;
                                            let _e3511 = ((((_e3400 * _e3503) * f64(1.01f)) + ((_e3452 + _e3402) * (1.1102230246251565e-16lf * f64(8f)))) + _e3402);
                                            if (_e3470 < 0.0lf) {
                                                phi_12063_ = -(_e3470);
                                            } else {
                                                phi_12063_ = _e3470;
                                            }
                                            let _e3515 = phi_12063_;
                                            if (_e3471 < 0.0lf) {
                                                phi_12069_ = -(_e3471);
                                            } else {
                                                phi_12069_ = _e3471;
                                            }
                                            let _e3519 = phi_12069_;
                                            if (_e3515 > _e3519) {
                                                phi_12074_ = _e3515;
                                            } else {
                                                phi_12074_ = _e3519;
                                            }
                                            let _e3522 = phi_12074_;
                                            if (_e3472 < 0.0lf) {
                                                phi_12080_ = -(_e3472);
                                            } else {
                                                phi_12080_ = _e3472;
                                            }
                                            let _e3526 = phi_12080_;
                                            if (_e3522 > _e3526) {
                                                phi_12085_ = _e3522;
                                            } else {
                                                phi_12085_ = _e3526;
                                            }
                                            let _e3529 = phi_12085_;
                                            local_2 = type_36(array<f64, 3>(_e3470, _e3471, _e3472), _e3511, (_e3529 + _e3511));
                                            let _e3535 = local_18.member_3;
                                            let _e3537 = local_18.member_1[0u];
                                            if (_e3537[0] < 0.0lf) {
                                                phi_12111_ = -(_e3537[0]);
                                            } else {
                                                phi_12111_ = _e3537[0];
                                            }
                                            let _e3544 = phi_12111_;
                                            if (_e3537[1] < 0.0lf) {
                                                phi_12118_ = -(_e3537[1]);
                                            } else {
                                                phi_12118_ = _e3537[1];
                                            }
                                            let _e3548 = phi_12118_;
                                            if (_e3544 > _e3548) {
                                                phi_12123_ = _e3544;
                                            } else {
                                                phi_12123_ = _e3548;
                                            }
                                            let _e3551 = phi_12123_;
                                            if (_e3537[2] < 0.0lf) {
                                                phi_12130_ = -(_e3537[2]);
                                            } else {
                                                phi_12130_ = _e3537[2];
                                            }
                                            let _e3555 = phi_12130_;
                                            if (_e3551 > _e3555) {
                                                phi_12135_ = _e3551;
                                            } else {
                                                phi_12135_ = _e3555;
                                            }
                                            let _e3558 = phi_12135_;
                                            let _e3560 = local_18.member_1[1u];
                                            if (_e3560[0] < 0.0lf) {
                                                phi_12148_ = -(_e3560[0]);
                                            } else {
                                                phi_12148_ = _e3560[0];
                                            }
                                            let _e3567 = phi_12148_;
                                            if (_e3560[1] < 0.0lf) {
                                                phi_12155_ = -(_e3560[1]);
                                            } else {
                                                phi_12155_ = _e3560[1];
                                            }
                                            let _e3571 = phi_12155_;
                                            if (_e3567 > _e3571) {
                                                phi_12160_ = _e3567;
                                            } else {
                                                phi_12160_ = _e3571;
                                            }
                                            let _e3574 = phi_12160_;
                                            if (_e3560[2] < 0.0lf) {
                                                phi_12167_ = -(_e3560[2]);
                                            } else {
                                                phi_12167_ = _e3560[2];
                                            }
                                            let _e3578 = phi_12167_;
                                            if (_e3574 > _e3578) {
                                                phi_12172_ = _e3574;
                                            } else {
                                                phi_12172_ = _e3578;
                                            }
                                            let _e3581 = phi_12172_;
                                            if (_e3558 > _e3581) {
                                                phi_12177_ = _e3558;
                                            } else {
                                                phi_12177_ = _e3581;
                                            }
                                            let _e3584 = phi_12177_;
                                            let _e3587 = local_18.member_1[0u];
                                            let _e3592 = local_18.member_1[1u];
                                            let _e3602 = (_e3587[0] + ((_e3592[0] - _e3587[0]) * _e3397));
                                            let _e3603 = (_e3587[1] + ((_e3592[1] - _e3587[1]) * _e3397));
                                            let _e3604 = (_e3587[2] + ((_e3592[2] - _e3587[2]) * _e3397));
                                            let _e3606 = local_18.member_1[1u];
                                            let _e3611 = local_18.member_1[0u];
                                            let _e3615 = (_e3606[0] - _e3611[0]);
                                            let _e3616 = (_e3606[1] - _e3611[1]);
                                            let _e3617 = (_e3606[2] - _e3611[2]);
                                            if (_e3615 < 0.0lf) {
                                                phi_12236_ = -(_e3615);
                                            } else {
                                                phi_12236_ = _e3615;
                                            }
                                            let _e3621 = phi_12236_;
                                            if (_e3616 < 0.0lf) {
                                                phi_12242_ = -(_e3616);
                                            } else {
                                                phi_12242_ = _e3616;
                                            }
                                            let _e3625 = phi_12242_;
                                            if (_e3621 > _e3625) {
                                                phi_12247_ = _e3621;
                                            } else {
                                                phi_12247_ = _e3625;
                                            }
                                            let _e3628 = phi_12247_;
                                            if (_e3617 < 0.0lf) {
                                                phi_12253_ = -(_e3617);
                                            } else {
                                                phi_12253_ = _e3617;
                                            }
                                            let _e3632 = phi_12253_;
                                            if (_e3628 > _e3632) {
                                                phi_12258_ = _e3628;
                                            } else {
                                                phi_12258_ = _e3632;
                                            }
                                            let _e3635 = phi_12258_;
                                            let _e3643 = ((((_e3400 * _e3635) * f64(1.01f)) + ((_e3584 + _e3535) * (1.1102230246251565e-16lf * f64(8f)))) + _e3535);
                                            if (_e3602 < 0.0lf) {
                                                phi_12272_ = -(_e3602);
                                            } else {
                                                phi_12272_ = _e3602;
                                            }
                                            let _e3647 = phi_12272_;
                                            if (_e3603 < 0.0lf) {
                                                phi_12278_ = -(_e3603);
                                            } else {
                                                phi_12278_ = _e3603;
                                            }
                                            let _e3651 = phi_12278_;
                                            if (_e3647 > _e3651) {
                                                phi_12283_ = _e3647;
                                            } else {
                                                phi_12283_ = _e3651;
                                            }
                                            let _e3654 = phi_12283_;
                                            if (_e3604 < 0.0lf) {
                                                phi_12289_ = -(_e3604);
                                            } else {
                                                phi_12289_ = _e3604;
                                            }
                                            let _e3658 = phi_12289_;
                                            if (_e3654 > _e3658) {
                                                phi_12294_ = _e3654;
                                            } else {
                                                phi_12294_ = _e3658;
                                            }
                                            let _e3661 = phi_12294_;
                                            local_3 = type_36(array<f64, 3>(_e3602, _e3603, _e3604), _e3643, (_e3661 + _e3643));
                                            let _e3667 = local_18.member_3;
                                            let _e3669 = local_18.member_2[0u];
                                            if (_e3669[0] < 0.0lf) {
                                                phi_12320_ = -(_e3669[0]);
                                            } else {
                                                phi_12320_ = _e3669[0];
                                            }
                                            let _e3676 = phi_12320_;
                                            if (_e3669[1] < 0.0lf) {
                                                phi_12327_ = -(_e3669[1]);
                                            } else {
                                                phi_12327_ = _e3669[1];
                                            }
                                            let _e3680 = phi_12327_;
                                            if (_e3676 > _e3680) {
                                                phi_12332_ = _e3676;
                                            } else {
                                                phi_12332_ = _e3680;
                                            }
                                            let _e3683 = phi_12332_;
                                            if (_e3669[2] < 0.0lf) {
                                                phi_12339_ = -(_e3669[2]);
                                            } else {
                                                phi_12339_ = _e3669[2];
                                            }
                                            let _e3687 = phi_12339_;
                                            if (_e3683 > _e3687) {
                                                phi_12344_ = _e3683;
                                            } else {
                                                phi_12344_ = _e3687;
                                            }
                                            let _e3690 = phi_12344_;
                                            let _e3692 = local_18.member_2[1u];
                                            if (_e3692[0] < 0.0lf) {
                                                phi_12357_ = -(_e3692[0]);
                                            } else {
                                                phi_12357_ = _e3692[0];
                                            }
                                            let _e3699 = phi_12357_;
                                            if (_e3692[1] < 0.0lf) {
                                                phi_12364_ = -(_e3692[1]);
                                            } else {
                                                phi_12364_ = _e3692[1];
                                            }
                                            let _e3703 = phi_12364_;
                                            if (_e3699 > _e3703) {
                                                phi_12369_ = _e3699;
                                            } else {
                                                phi_12369_ = _e3703;
                                            }
                                            let _e3706 = phi_12369_;
                                            if (_e3692[2] < 0.0lf) {
                                                phi_12376_ = -(_e3692[2]);
                                            } else {
                                                phi_12376_ = _e3692[2];
                                            }
                                            let _e3710 = phi_12376_;
                                            if (_e3706 > _e3710) {
                                                phi_12381_ = _e3706;
                                            } else {
                                                phi_12381_ = _e3710;
                                            }
                                            let _e3713 = phi_12381_;
                                            if (_e3690 > _e3713) {
                                                phi_12386_ = _e3690;
                                            } else {
                                                phi_12386_ = _e3713;
                                            }
                                            let _e3716 = phi_12386_;
                                            let _e3719 = local_18.member_2[0u];
                                            let _e3724 = local_18.member_2[1u];
                                            let _e3734 = (_e3719[0] + ((_e3724[0] - _e3719[0]) * _e3397));
                                            let _e3735 = (_e3719[1] + ((_e3724[1] - _e3719[1]) * _e3397));
                                            let _e3736 = (_e3719[2] + ((_e3724[2] - _e3719[2]) * _e3397));
                                            let _e3738 = local_18.member_2[1u];
                                            let _e3743 = local_18.member_2[0u];
                                            let _e3747 = (_e3738[0] - _e3743[0]);
                                            let _e3748 = (_e3738[1] - _e3743[1]);
                                            let _e3749 = (_e3738[2] - _e3743[2]);
                                            if (_e3747 < 0.0lf) {
                                                phi_12445_ = -(_e3747);
                                            } else {
                                                phi_12445_ = _e3747;
                                            }
                                            let _e3753 = phi_12445_;
                                            if (_e3748 < 0.0lf) {
                                                phi_12451_ = -(_e3748);
                                            } else {
                                                phi_12451_ = _e3748;
                                            }
                                            let _e3757 = phi_12451_;
                                            if (_e3753 > _e3757) {
                                                phi_12456_ = _e3753;
                                            } else {
                                                phi_12456_ = _e3757;
                                            }
                                            let _e3760 = phi_12456_;
                                            if (_e3749 < 0.0lf) {
                                                phi_12462_ = -(_e3749);
                                            } else {
                                                phi_12462_ = _e3749;
                                            }
                                            let _e3764 = phi_12462_;
                                            if (_e3760 > _e3764) {
                                                phi_12467_ = _e3760;
                                            } else {
                                                phi_12467_ = _e3764;
                                            }
                                            let _e3767 = phi_12467_;
                                            let _e3775 = ((((_e3400 * _e3767) * f64(1.01f)) + ((_e3716 + _e3667) * (1.1102230246251565e-16lf * f64(8f)))) + _e3667);
                                            if (_e3734 < 0.0lf) {
                                                phi_12481_ = -(_e3734);
                                            } else {
                                                phi_12481_ = _e3734;
                                            }
                                            let _e3779 = phi_12481_;
                                            if (_e3735 < 0.0lf) {
                                                phi_12487_ = -(_e3735);
                                            } else {
                                                phi_12487_ = _e3735;
                                            }
                                            let _e3783 = phi_12487_;
                                            if (_e3779 > _e3783) {
                                                phi_12492_ = _e3779;
                                            } else {
                                                phi_12492_ = _e3783;
                                            }
                                            let _e3786 = phi_12492_;
                                            if (_e3736 < 0.0lf) {
                                                phi_12498_ = -(_e3736);
                                            } else {
                                                phi_12498_ = _e3736;
                                            }
                                            let _e3790 = phi_12498_;
                                            if (_e3786 > _e3790) {
                                                phi_12503_ = _e3786;
                                            } else {
                                                phi_12503_ = _e3790;
                                            }
                                            let _e3793 = phi_12503_;
                                            local_4 = type_36(array<f64, 3>(_e3734, _e3735, _e3736), _e3775, (_e3793 + _e3775));
                                            let _e3798 = local_3.member;
                                            let _e3803 = local_4.member;
                                            let _e3809 = ((_e3798[1] * _e3803[2]) - (_e3798[2] * _e3803[1]));
                                            let _e3812 = ((_e3798[2] * _e3803[0]) - (_e3798[0] * _e3803[2]));
                                            let _e3815 = ((_e3798[0] * _e3803[1]) - (_e3798[1] * _e3803[0]));
                                            if (_e3809 < 0.0lf) {
                                                phi_12552_ = -(_e3809);
                                            } else {
                                                phi_12552_ = _e3809;
                                            }
                                            let _e3819 = phi_12552_;
                                            if (_e3812 < 0.0lf) {
                                                phi_12558_ = -(_e3812);
                                            } else {
                                                phi_12558_ = _e3812;
                                            }
                                            let _e3823 = phi_12558_;
                                            if (_e3819 > _e3823) {
                                                if (_e3809 < 0.0lf) {
                                                    phi_12568_ = -(_e3809);
                                                } else {
                                                    phi_12568_ = _e3809;
                                                }
                                                let _e3841 = phi_12568_;
                                                if (_e3815 < 0.0lf) {
                                                    phi_12574_ = -(_e3815);
                                                } else {
                                                    phi_12574_ = _e3815;
                                                }
                                                let _e3845 = phi_12574_;
                                                if (_e3841 > _e3845) {
                                                    phi_12579_ = 2u;
                                                    phi_12580_ = 1u;
                                                } else {
                                                    phi_12579_ = 1u;
                                                    phi_12580_ = 0u;
                                                }
                                                let _e3848 = phi_12579_;
                                                let _e3850 = phi_12580_;
                                                phi_12599_ = _e3848;
                                                phi_12600_ = _e3850;
                                            } else {
                                                if (_e3812 < 0.0lf) {
                                                    phi_12586_ = -(_e3812);
                                                } else {
                                                    phi_12586_ = _e3812;
                                                }
                                                let _e3828 = phi_12586_;
                                                if (_e3815 < 0.0lf) {
                                                    phi_12592_ = -(_e3815);
                                                } else {
                                                    phi_12592_ = _e3815;
                                                }
                                                let _e3832 = phi_12592_;
                                                if (_e3828 > _e3832) {
                                                    phi_12597_ = 0u;
                                                    phi_12598_ = 2u;
                                                } else {
                                                    phi_12597_ = 1u;
                                                    phi_12598_ = 0u;
                                                }
                                                let _e3835 = phi_12597_;
                                                let _e3837 = phi_12598_;
                                                phi_12599_ = _e3835;
                                                phi_12600_ = _e3837;
                                            }
                                            let _e3852 = phi_12599_;
                                            let _e3854 = phi_12600_;
                                            let _e3857 = local_3.member[_e3854];
                                            let _e3860 = local_4.member[_e3852];
                                            let _e3864 = local_3.member[_e3852];
                                            let _e3867 = local_4.member[_e3854];
                                            let _e3869 = ((_e3857 * _e3860) - (_e3864 * _e3867));
                                            let _e3870 = f64(1f);
                                            let _e3871 = f64(2f);
                                            let _e3873 = local_3.member_1;
                                            let _e3875 = local_4.member_2;
                                            let _e3878 = local_3.member_2;
                                            let _e3880 = local_4.member_1;
                                            let _e3886 = local_3.member_2;
                                            let _e3889 = local_4.member_2;
                                            let _e3898 = local_3.member_2;
                                            let _e3901 = local_4.member_2;
                                            let _e3905 = (((((_e3873 * _e3875) + (_e3878 * _e3880)) * f64(2.01f)) + (((_e3886 * _e3871) * (_e3889 * _e3871)) * (1.1102230246251565e-16lf * _e3871))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3870 + _e3898) * (_e3870 + _e3901))));
                                            if (_e3869 < 0.0lf) {
                                                phi_12673_ = -(_e3869);
                                            } else {
                                                phi_12673_ = _e3869;
                                            }
                                            let _e3909 = phi_12673_;
                                            if (_e3909 > _e3905) {
                                                if (_e3869 < f64(0f)) {
                                                    phi_12685_ = f64(-1f);
                                                } else {
                                                    phi_12685_ = f64(1f);
                                                }
                                                let _e3916 = phi_12685_;
                                                let _e3919 = local_2.member[_e3854];
                                                let _e3922 = local_4.member[_e3852];
                                                let _e3926 = local_2.member[_e3852];
                                                let _e3929 = local_4.member[_e3854];
                                                let _e3932 = f64(1f);
                                                let _e3933 = f64(2f);
                                                let _e3935 = local_2.member_1;
                                                let _e3937 = local_4.member_2;
                                                let _e3940 = local_2.member_2;
                                                let _e3942 = local_4.member_1;
                                                let _e3948 = local_2.member_2;
                                                let _e3951 = local_4.member_2;
                                                let _e3960 = local_2.member_2;
                                                let _e3963 = local_4.member_2;
                                                let _e3967 = (((((_e3935 * _e3937) + (_e3940 * _e3942)) * f64(2.01f)) + (((_e3948 * _e3933) * (_e3951 * _e3933)) * (1.1102230246251565e-16lf * _e3933))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3932 + _e3960) * (_e3932 + _e3963))));
                                                let _e3970 = local_3.member[_e3854];
                                                let _e3973 = local_2.member[_e3852];
                                                let _e3977 = local_3.member[_e3852];
                                                let _e3980 = local_2.member[_e3854];
                                                let _e3983 = f64(1f);
                                                let _e3984 = f64(2f);
                                                let _e3986 = local_3.member_1;
                                                let _e3988 = local_2.member_2;
                                                let _e3991 = local_3.member_2;
                                                let _e3993 = local_2.member_1;
                                                let _e3999 = local_3.member_2;
                                                let _e4002 = local_2.member_2;
                                                let _e4011 = local_3.member_2;
                                                let _e4014 = local_2.member_2;
                                                let _e4018 = (((((_e3986 * _e3988) + (_e3991 * _e3993)) * f64(2.01f)) + (((_e3999 * _e3984) * (_e4002 * _e3984)) * (1.1102230246251565e-16lf * _e3984))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3983 + _e4011) * (_e3983 + _e4014))));
                                                let _e4019 = (_e3869 * _e3916);
                                                let _e4020 = (((_e3919 * _e3922) - (_e3926 * _e3929)) * _e3916);
                                                let _e4021 = (((_e3970 * _e3973) - (_e3977 * _e3980)) * _e3916);
                                                if (_e4019 < 0.0lf) {
                                                    phi_12828_ = -(_e4019);
                                                } else {
                                                    phi_12828_ = _e4019;
                                                }
                                                let _e4025 = phi_12828_;
                                                if (_e4020 < 0.0lf) {
                                                    phi_12834_ = -(_e4020);
                                                } else {
                                                    phi_12834_ = _e4020;
                                                }
                                                let _e4029 = phi_12834_;
                                                if (_e4021 < 0.0lf) {
                                                    phi_12841_ = -(_e4021);
                                                } else {
                                                    phi_12841_ = _e4021;
                                                }
                                                let _e4034 = phi_12841_;
                                                let _e4038 = (((_e4025 + _e4029) + _e4034) * (1.1102230246251565e-16lf * f64(4f)));
                                                if (_e252.member != 0u) {
                                                    phi_12877_ = array<type_37, 4>(type_37(_e4020, _e3967), type_37(_e4021, _e4018), type_37((_e4019 - _e4020), ((_e3905 + _e3967) + _e4038)), type_37((_e4019 - _e4021), ((_e3905 + _e4018) + _e4038)));
                                                } else {
                                                    let _e4041 = ((_e4019 - _e4020) - _e4021);
                                                    let _e4044 = (((_e3905 + _e3967) + _e4018) + _e4038);
                                                    phi_12877_ = array<type_37, 4>(type_37(_e4020, _e3967), type_37(_e4021, _e4018), type_37(_e4041, _e4044), type_37(_e4041, _e4044));
                                                }
                                                let _e4062 = phi_12877_;
                                                local_5 = array<type_37, 4>(type_37(_e4062[0].member, _e4062[0].member_1), type_37(_e4062[1].member, _e4062[1].member_1), type_37(_e4062[2].member, _e4062[2].member_1), type_37(_e4062[3].member, _e4062[3].member_1));
                                                phi_12897_ = type_9(0u, 4u);
                                                phi_12900_ = true;
                                                loop {
                                                    let _e4081 = phi_12897_;
                                                    let _e4083 = phi_12900_;
                                                    local_27 = _e4083;
                                                    if (_e4081.member < _e4081.member_1) {
                                                        phi_12898_ = type_9((_e4081.member + 1u), _e4081.member_1);
                                                        phi_12923_ = type_9(1u, _e4081.member);
                                                    } else {
                                                        phi_12898_ = _e4081;
                                                        phi_12923_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e4095 = phi_12898_;
                                                    let _e4097 = phi_12923_;
                                                    if (bitcast<i32>(_e4097.member) != 0i) {
                                                        let _e4104 = local_5[_e4097.member_1].member;
                                                        let _e4107 = local_5[_e4097.member_1].member_1;
                                                        let _e4109 = (_e4104 < -(_e4107));
                                                        if _e4109 {
                                                            phi_12950_ = bool();
                                                            phi_12951_ = false;
                                                        } else {
                                                            phi_12950_ = (_e4083 && (_e4104 > _e4107));
                                                            phi_12951_ = true;
                                                        }
                                                        let _e4113 = phi_12950_;
                                                        let _e4115 = phi_12951_;
                                                        phi_12901_ = _e4113;
                                                        phi_12952_ = _e4115;
                                                        phi_12953_ = _e4109;
                                                    } else {
                                                        phi_12901_ = bool();
                                                        phi_12952_ = false;
                                                        phi_12953_ = false;
                                                    }
                                                    let _e4117 = phi_12901_;
                                                    let _e4119 = phi_12952_;
                                                    let _e4121 = phi_12953_;
                                                    local_26 = _e4121;
                                                    continue;
                                                    continuing {
                                                        phi_12897_ = _e4095;
                                                        phi_12900_ = _e4117;
                                                        break if !(_e4119);
                                                    }
                                                }
                                                let _e4124 = local_26;
                                                if _e4124 {
                                                    phi_12957_ = false;
                                                } else {
                                                    phi_12957_ = true;
                                                }
                                                let _e4126 = phi_12957_;
                                                if _e4126 {
                                                    let _e4128 = local_27;
                                                    if _e4128 {
                                                        phi_12964_ = 1u;
                                                    } else {
                                                        phi_12964_ = 2u;
                                                    }
                                                    let _e4130 = phi_12964_;
                                                    phi_12965_ = _e4130;
                                                    phi_12966_ = false;
                                                } else {
                                                    phi_12965_ = u32();
                                                    phi_12966_ = true;
                                                }
                                                let _e4132 = phi_12965_;
                                                let _e4134 = phi_12966_;
                                                phi_12967_ = _e4132;
                                                phi_12968_ = 0u;
                                                phi_12969_ = _e4134;
                                            } else {
                                                phi_12967_ = u32();
                                                phi_12968_ = 2u;
                                                phi_12969_ = true;
                                            }
                                            let _e4136 = phi_12967_;
                                            let _e4138 = phi_12968_;
                                            let _e4140 = phi_12969_;
                                            if _e4140 {
                                                phi_12973_ = _e4138;
                                            } else {
                                                phi_12973_ = _e4136;
                                            }
                                            let _e4142 = phi_12973_;
                                            let _e4143 = (_e4142 == 0u);
                                            if _e4143 {
                                                phi_15732_ = bool();
                                                phi_15733_ = f64();
                                                phi_15734_ = f64();
                                                phi_15735_ = false;
                                                phi_15736_ = false;
                                                phi_15737_ = false;
                                            } else {
                                                if (_e4142 == 1u) {
                                                    phi_12983_ = _e3388.member_2;
                                                } else {
                                                    phi_12983_ = false;
                                                }
                                                let _e4147 = phi_12983_;
                                                let _e4149 = (_e539 * f64(0.99f));
                                                if _e4147 {
                                                    if ((_e3388.member_1 - _e3388.member) <= _e4149) {
                                                        phi_12996_ = false;
                                                    } else {
                                                        phi_12996_ = true;
                                                    }
                                                    let _e4155 = phi_12996_;
                                                    phi_12997_ = _e4155;
                                                } else {
                                                    phi_12997_ = true;
                                                }
                                                let _e4157 = phi_12997_;
                                                if _e4157 {
                                                    let _e4162 = local_18.member[0u];
                                                    let _e4169 = local_18.member_1[0u];
                                                    let _e4175 = local_18.member_2[0u];
                                                    let _e4179 = (_e4162[0] - _e4169[0]);
                                                    let _e4180 = (_e4162[1] - _e4169[1]);
                                                    let _e4181 = (_e4162[2] - _e4169[2]);
                                                    if (_e252.member == 0u) {
                                                        phi_13058_ = array<f64, 3>(_e4162[0], _e4162[1], _e4162[2]);
                                                    } else {
                                                        phi_13058_ = array<f64, 3>((_e4179 - _e4175[0]), (_e4180 - _e4175[1]), (_e4181 - _e4175[2]));
                                                    }
                                                    let _e4188 = phi_13058_;
                                                    let _e4194 = local_18.member[1u];
                                                    let _e4201 = local_18.member_1[1u];
                                                    let _e4207 = local_18.member_2[1u];
                                                    let _e4211 = (_e4194[0] - _e4201[0]);
                                                    let _e4212 = (_e4194[1] - _e4201[1]);
                                                    let _e4213 = (_e4194[2] - _e4201[2]);
                                                    if (_e252.member == 0u) {
                                                        phi_13123_ = array<f64, 3>(_e4194[0], _e4194[1], _e4194[2]);
                                                    } else {
                                                        phi_13123_ = array<f64, 3>((_e4211 - _e4207[0]), (_e4212 - _e4207[1]), (_e4213 - _e4207[2]));
                                                    }
                                                    let _e4220 = phi_13123_;
                                                    let _e4226 = local_18.member[0u];
                                                    if (_e4226[0] < 0.0lf) {
                                                        phi_13145_ = -(_e4226[0]);
                                                    } else {
                                                        phi_13145_ = _e4226[0];
                                                    }
                                                    let _e4233 = phi_13145_;
                                                    if (_e4226[1] < 0.0lf) {
                                                        phi_13152_ = -(_e4226[1]);
                                                    } else {
                                                        phi_13152_ = _e4226[1];
                                                    }
                                                    let _e4237 = phi_13152_;
                                                    if (_e4233 > _e4237) {
                                                        phi_13157_ = _e4233;
                                                    } else {
                                                        phi_13157_ = _e4237;
                                                    }
                                                    let _e4240 = phi_13157_;
                                                    if (_e4226[2] < 0.0lf) {
                                                        phi_13164_ = -(_e4226[2]);
                                                    } else {
                                                        phi_13164_ = _e4226[2];
                                                    }
                                                    let _e4244 = phi_13164_;
                                                    if (_e4240 > _e4244) {
                                                        phi_13169_ = _e4240;
                                                    } else {
                                                        phi_13169_ = _e4244;
                                                    }
                                                    let _e4247 = phi_13169_;
                                                    let _e4250 = local_18.member[1u];
                                                    if (_e4250[0] < 0.0lf) {
                                                        phi_13182_ = -(_e4250[0]);
                                                    } else {
                                                        phi_13182_ = _e4250[0];
                                                    }
                                                    let _e4257 = phi_13182_;
                                                    if (_e4250[1] < 0.0lf) {
                                                        phi_13189_ = -(_e4250[1]);
                                                    } else {
                                                        phi_13189_ = _e4250[1];
                                                    }
                                                    let _e4261 = phi_13189_;
                                                    if (_e4257 > _e4261) {
                                                        phi_13194_ = _e4257;
                                                    } else {
                                                        phi_13194_ = _e4261;
                                                    }
                                                    let _e4264 = phi_13194_;
                                                    if (_e4250[2] < 0.0lf) {
                                                        phi_13201_ = -(_e4250[2]);
                                                    } else {
                                                        phi_13201_ = _e4250[2];
                                                    }
                                                    let _e4268 = phi_13201_;
                                                    if (_e4264 > _e4268) {
                                                        phi_13206_ = _e4264;
                                                    } else {
                                                        phi_13206_ = _e4268;
                                                    }
                                                    let _e4271 = phi_13206_;
                                                    if (_e4247 > _e4271) {
                                                        phi_13211_ = _e4247;
                                                    } else {
                                                        phi_13211_ = _e4271;
                                                    }
                                                    let _e4274 = phi_13211_;
                                                    let _e4276 = local_18.member_3;
                                                    let _e4280 = local_18.member_1[0u];
                                                    if (_e4280[0] < 0.0lf) {
                                                        phi_13228_ = -(_e4280[0]);
                                                    } else {
                                                        phi_13228_ = _e4280[0];
                                                    }
                                                    let _e4287 = phi_13228_;
                                                    if (_e4280[1] < 0.0lf) {
                                                        phi_13235_ = -(_e4280[1]);
                                                    } else {
                                                        phi_13235_ = _e4280[1];
                                                    }
                                                    let _e4291 = phi_13235_;
                                                    if (_e4287 > _e4291) {
                                                        phi_13240_ = _e4287;
                                                    } else {
                                                        phi_13240_ = _e4291;
                                                    }
                                                    let _e4294 = phi_13240_;
                                                    if (_e4280[2] < 0.0lf) {
                                                        phi_13247_ = -(_e4280[2]);
                                                    } else {
                                                        phi_13247_ = _e4280[2];
                                                    }
                                                    let _e4298 = phi_13247_;
                                                    if (_e4294 > _e4298) {
                                                        phi_13252_ = _e4294;
                                                    } else {
                                                        phi_13252_ = _e4298;
                                                    }
                                                    let _e4301 = phi_13252_;
                                                    let _e4304 = local_18.member_1[1u];
                                                    if (_e4304[0] < 0.0lf) {
                                                        phi_13266_ = -(_e4304[0]);
                                                    } else {
                                                        phi_13266_ = _e4304[0];
                                                    }
                                                    let _e4311 = phi_13266_;
                                                    if (_e4304[1] < 0.0lf) {
                                                        phi_13273_ = -(_e4304[1]);
                                                    } else {
                                                        phi_13273_ = _e4304[1];
                                                    }
                                                    let _e4315 = phi_13273_;
                                                    if (_e4311 > _e4315) {
                                                        phi_13278_ = _e4311;
                                                    } else {
                                                        phi_13278_ = _e4315;
                                                    }
                                                    let _e4318 = phi_13278_;
                                                    if (_e4304[2] < 0.0lf) {
                                                        phi_13285_ = -(_e4304[2]);
                                                    } else {
                                                        phi_13285_ = _e4304[2];
                                                    }
                                                    let _e4322 = phi_13285_;
                                                    if (_e4318 > _e4322) {
                                                        phi_13290_ = _e4318;
                                                    } else {
                                                        phi_13290_ = _e4322;
                                                    }
                                                    let _e4325 = phi_13290_;
                                                    if (_e4301 > _e4325) {
                                                        phi_13295_ = _e4301;
                                                    } else {
                                                        phi_13295_ = _e4325;
                                                    }
                                                    let _e4328 = phi_13295_;
                                                    let _e4330 = local_18.member_3;
                                                    let _e4334 = local_18.member_2[0u];
                                                    if (_e4334[0] < 0.0lf) {
                                                        phi_13312_ = -(_e4334[0]);
                                                    } else {
                                                        phi_13312_ = _e4334[0];
                                                    }
                                                    let _e4341 = phi_13312_;
                                                    if (_e4334[1] < 0.0lf) {
                                                        phi_13319_ = -(_e4334[1]);
                                                    } else {
                                                        phi_13319_ = _e4334[1];
                                                    }
                                                    let _e4345 = phi_13319_;
                                                    if (_e4341 > _e4345) {
                                                        phi_13324_ = _e4341;
                                                    } else {
                                                        phi_13324_ = _e4345;
                                                    }
                                                    let _e4348 = phi_13324_;
                                                    if (_e4334[2] < 0.0lf) {
                                                        phi_13331_ = -(_e4334[2]);
                                                    } else {
                                                        phi_13331_ = _e4334[2];
                                                    }
                                                    let _e4352 = phi_13331_;
                                                    if (_e4348 > _e4352) {
                                                        phi_13336_ = _e4348;
                                                    } else {
                                                        phi_13336_ = _e4352;
                                                    }
                                                    let _e4355 = phi_13336_;
                                                    let _e4358 = local_18.member_2[1u];
                                                    if (_e4358[0] < 0.0lf) {
                                                        phi_13350_ = -(_e4358[0]);
                                                    } else {
                                                        phi_13350_ = _e4358[0];
                                                    }
                                                    let _e4365 = phi_13350_;
                                                    if (_e4358[1] < 0.0lf) {
                                                        phi_13357_ = -(_e4358[1]);
                                                    } else {
                                                        phi_13357_ = _e4358[1];
                                                    }
                                                    let _e4369 = phi_13357_;
                                                    if (_e4365 > _e4369) {
                                                        phi_13362_ = _e4365;
                                                    } else {
                                                        phi_13362_ = _e4369;
                                                    }
                                                    let _e4372 = phi_13362_;
                                                    if (_e4358[2] < 0.0lf) {
                                                        phi_13369_ = -(_e4358[2]);
                                                    } else {
                                                        phi_13369_ = _e4358[2];
                                                    }
                                                    let _e4376 = phi_13369_;
                                                    if (_e4372 > _e4376) {
                                                        phi_13374_ = _e4372;
                                                    } else {
                                                        phi_13374_ = _e4376;
                                                    }
                                                    let _e4379 = phi_13374_;
                                                    if (_e4355 > _e4379) {
                                                        phi_13379_ = _e4355;
                                                    } else {
                                                        phi_13379_ = _e4379;
                                                    }
                                                    let _e4382 = phi_13379_;
                                                    let _e4384 = local_18.member_3;
                                                    let _e4392 = local_18.member_3;
                                                    let _e4400 = (_e539 * f64(0.00390625f));
                                                    let _e4401 = f64(0f);
                                                    let _e4402 = f64(1f);
                                                    local = type_35(array<f64, 4>(_e4401, _e4401, _e4401, _e4401), array<f64, 4>(_e4401, _e4401, _e4401, _e4401), array<f64, 4>(_e4402, _e4402, _e4402, _e4402));
                                                    phi_13426_ = type_9(0u, 96u);
                                                    phi_13429_ = _e3388.member;
                                                    phi_13431_ = _e3388.member;
                                                    phi_13433_ = (_e3388.member_1 - _e3388.member);
                                                    phi_13435_ = _e3388.member;
                                                    phi_13437_ = false;
                                                    phi_13439_ = 0u;
                                                    loop {
                                                        let _e4409 = phi_13426_;
                                                        let _e4411 = phi_13429_;
                                                        let _e4413 = phi_13431_;
                                                        let _e4415 = phi_13433_;
                                                        let _e4417 = phi_13435_;
                                                        let _e4419 = phi_13437_;
                                                        let _e4421 = phi_13439_;
                                                        local_31 = _e4411;
                                                        local_78 = _e4413;
                                                        if (_e4409.member < _e4409.member_1) {
                                                            phi_13427_ = type_9((_e4409.member + 1u), _e4409.member_1);
                                                            phi_13462_ = type_9(1u, _e4409.member);
                                                        } else {
                                                            phi_13427_ = _e4409;
                                                            phi_13462_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e4433 = phi_13427_;
                                                        let _e4435 = phi_13462_;
                                                        if (bitcast<i32>(_e4435.member) != 0i) {
                                                            let _e4441 = local_18.member[0u];
                                                            let _e4447 = local_18.member[1u];
                                                            let _e4463 = local_18.member_1[0u];
                                                            let _e4469 = local_18.member_1[1u];
                                                            let _e4485 = local_18.member_2[0u];
                                                            let _e4491 = local_18.member_2[1u];
                                                            let _e4505 = function_4(array<f64, 3>((_e4441[0] + ((_e4447[0] - _e4441[0]) * _e4411)), (_e4441[1] + ((_e4447[1] - _e4441[1]) * _e4411)), (_e4441[2] + ((_e4447[2] - _e4441[2]) * _e4411))), array<f64, 3>((_e4463[0] + ((_e4469[0] - _e4463[0]) * _e4411)), (_e4463[1] + ((_e4469[1] - _e4463[1]) * _e4411)), (_e4463[2] + ((_e4469[2] - _e4463[2]) * _e4411))), array<f64, 3>((_e4485[0] + ((_e4491[0] - _e4485[0]) * _e4411)), (_e4485[1] + ((_e4491[1] - _e4485[1]) * _e4411)), (_e4485[2] + ((_e4491[2] - _e4485[2]) * _e4411))), _e252.member);
                                                            if (_e4421 == 0u) {
                                                                phi_13591_ = _e4505;
                                                            } else {
                                                                let _e4507 = f64(0f);
                                                                if (_e4421 == 1u) {
                                                                    phi_13577_ = _e4505[0];
                                                                } else {
                                                                    phi_13577_ = _e4507;
                                                                }
                                                                let _e4511 = phi_13577_;
                                                                if (_e4421 == 2u) {
                                                                    phi_13583_ = _e4505[1];
                                                                } else {
                                                                    phi_13583_ = _e4507;
                                                                }
                                                                let _e4515 = phi_13583_;
                                                                if (_e4421 == 3u) {
                                                                    phi_13589_ = _e4505[2];
                                                                } else {
                                                                    phi_13589_ = _e4507;
                                                                }
                                                                let _e4519 = phi_13589_;
                                                                phi_13591_ = array<f64, 3>(_e4511, _e4515, _e4519);
                                                            }
                                                            let _e4522 = phi_13591_;
                                                            if (_e4522[0] < 0.0lf) {
                                                                phi_13598_ = -(_e4522[0]);
                                                            } else {
                                                                phi_13598_ = _e4522[0];
                                                            }
                                                            let _e4527 = phi_13598_;
                                                            if (_e4522[1] < 0.0lf) {
                                                                phi_13605_ = -(_e4522[1]);
                                                            } else {
                                                                phi_13605_ = _e4522[1];
                                                            }
                                                            let _e4532 = phi_13605_;
                                                            if (_e4522[2] < 0.0lf) {
                                                                phi_13613_ = -(_e4522[2]);
                                                            } else {
                                                                phi_13613_ = _e4522[2];
                                                            }
                                                            let _e4538 = phi_13613_;
                                                            let _e4539 = ((_e4527 + _e4532) + _e4538);
                                                            if (_e4539 > f64(0f)) {
                                                                if ((bitcast<u64>(_e4539) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                                    let _e4546 = (f64(1f) / _e4539);
                                                                    let _e4548 = (_e4522[0] * _e4546);
                                                                    let _e4550 = (_e4522[1] * _e4546);
                                                                    let _e4552 = (_e4522[2] * _e4546);
                                                                    let _e4557 = (((_e4548 * _e4548) + (_e4550 * _e4550)) + (_e4552 * _e4552));
                                                                    if (_e4557 <= 2.2250738585072014e-308lf) {
                                                                        if (_e4557 > 0.0lf) {
                                                                            phi_13652_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_13652_ = 0.0lf;
                                                                        }
                                                                        let _e4609 = phi_13652_;
                                                                        phi_13716_ = _e4609;
                                                                    } else {
                                                                        phi_13659_ = type_18(0i, 5i);
                                                                        phi_13662_ = bitcast<f64>(((bitcast<u64>(_e4557) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e4564 = phi_13659_;
                                                                            let _e4566 = phi_13662_;
                                                                            local_28 = _e4566;
                                                                            if (_e4564.member < _e4564.member_1) {
                                                                                let _e4573 = (_e4564.member + 1i);
                                                                                if ((false == (_e4573 > _e4564.member)) != false) {
                                                                                    phi_13683_ = true;
                                                                                } else {
                                                                                    phi_13683_ = false;
                                                                                }
                                                                                let _e4578 = phi_13683_;
                                                                                if _e4578 {
                                                                                    phi_13689_ = type_19(0u, type_19().member_1);
                                                                                } else {
                                                                                    phi_13689_ = type_19(1u, _e4573);
                                                                                }
                                                                                let _e4583 = phi_13689_;
                                                                                phi_13660_ = type_18(_e4583.member_1, _e4564.member_1);
                                                                                phi_13703_ = type_19(1u, _e4564.member);
                                                                            } else {
                                                                                phi_13660_ = _e4564;
                                                                                phi_13703_ = type_19(0u, type_19().member_1);
                                                                            }
                                                                            let _e4589 = phi_13660_;
                                                                            let _e4591 = phi_13703_;
                                                                            let _e4594 = (bitcast<i32>(_e4591.member) != 0i);
                                                                            if _e4594 {
                                                                                phi_13663_ = (0.5lf * (_e4566 + (_e4557 / _e4566)));
                                                                            } else {
                                                                                phi_13663_ = f64();
                                                                            }
                                                                            let _e4599 = phi_13663_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_13659_ = _e4589;
                                                                                phi_13662_ = _e4599;
                                                                                break if !(_e4594);
                                                                            }
                                                                        }
                                                                        let _e4604 = local_28;
                                                                        phi_13716_ = (_e4604 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e4611 = phi_13716_;
                                                                    let _e4613 = (1.1102230246251565e-16lf * f64(12f));
                                                                    let _e4620 = ((((((((_e4274 + _e4276) + (_e4328 + _e4330)) + (_e4382 + _e4384)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4392 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e868 * _e4611) * (f64(1f) + _e4613)));
                                                                    let _e4625 = (((_e4548 * _e4162[0]) + (_e4550 * _e4162[1])) + (_e4552 * _e4162[2]));
                                                                    let _e4630 = (((_e4548 * _e4179) + (_e4550 * _e4180)) + (_e4552 * _e4181));
                                                                    let _e4635 = (((_e4548 * (_e4162[0] - _e4175[0])) + (_e4550 * (_e4162[1] - _e4175[1]))) + (_e4552 * (_e4162[2] - _e4175[2])));
                                                                    let _e4643 = (((_e4548 * _e4188[0]) + (_e4550 * _e4188[1])) + (_e4552 * _e4188[2]));
                                                                    let _e4649 = (((_e4548 * _e4194[0]) + (_e4550 * _e4194[1])) + (_e4552 * _e4194[2]));
                                                                    let _e4654 = (((_e4548 * _e4211) + (_e4550 * _e4212)) + (_e4552 * _e4213));
                                                                    let _e4659 = (((_e4548 * (_e4194[0] - _e4207[0])) + (_e4550 * (_e4194[1] - _e4207[1]))) + (_e4552 * (_e4194[2] - _e4207[2])));
                                                                    let _e4667 = (((_e4548 * _e4220[0]) + (_e4550 * _e4220[1])) + (_e4552 * _e4220[2]));
                                                                    if (_e4625 < 0.0lf) {
                                                                        phi_13785_ = -(_e4625);
                                                                    } else {
                                                                        phi_13785_ = _e4625;
                                                                    }
                                                                    let _e4672 = phi_13785_;
                                                                    if (_e4649 < 0.0lf) {
                                                                        phi_13791_ = -(_e4649);
                                                                    } else {
                                                                        phi_13791_ = _e4649;
                                                                    }
                                                                    let _e4676 = phi_13791_;
                                                                    if (_e4630 < 0.0lf) {
                                                                        phi_13800_ = -(_e4630);
                                                                    } else {
                                                                        phi_13800_ = _e4630;
                                                                    }
                                                                    let _e4683 = phi_13800_;
                                                                    if (_e4654 < 0.0lf) {
                                                                        phi_13806_ = -(_e4654);
                                                                    } else {
                                                                        phi_13806_ = _e4654;
                                                                    }
                                                                    let _e4687 = phi_13806_;
                                                                    if (_e4635 < 0.0lf) {
                                                                        phi_13815_ = -(_e4635);
                                                                    } else {
                                                                        phi_13815_ = _e4635;
                                                                    }
                                                                    let _e4694 = phi_13815_;
                                                                    if (_e4659 < 0.0lf) {
                                                                        phi_13821_ = -(_e4659);
                                                                    } else {
                                                                        phi_13821_ = _e4659;
                                                                    }
                                                                    let _e4698 = phi_13821_;
                                                                    if (_e4643 < 0.0lf) {
                                                                        phi_13830_ = -(_e4643);
                                                                    } else {
                                                                        phi_13830_ = _e4643;
                                                                    }
                                                                    let _e4705 = phi_13830_;
                                                                    if (_e4667 < 0.0lf) {
                                                                        phi_13836_ = -(_e4667);
                                                                    } else {
                                                                        phi_13836_ = _e4667;
                                                                    }
                                                                    let _e4709 = phi_13836_;
                                                                    phi_13842_ = type_35(array<f64, 4>(_e4625, _e4630, _e4635, _e4643), array<f64, 4>(_e4649, _e4654, _e4659, _e4667), array<f64, 4>((_e4620 + ((_e4672 + _e4676) * _e4613)), (_e4620 + ((_e4683 + _e4687) * _e4613)), (_e4620 + ((_e4694 + _e4698) * _e4613)), (_e4620 + ((_e4705 + _e4709) * _e4613))));
                                                                    phi_13843_ = false;
                                                                } else {
                                                                    phi_13842_ = type_35();
                                                                    phi_13843_ = true;
                                                                }
                                                                let _e4716 = phi_13842_;
                                                                let _e4718 = phi_13843_;
                                                                phi_13844_ = _e4716;
                                                                phi_13845_ = _e4718;
                                                            } else {
                                                                phi_13844_ = type_35();
                                                                phi_13845_ = true;
                                                            }
                                                            let _e4720 = phi_13844_;
                                                            let _e4722 = phi_13845_;
                                                            if _e4722 {
                                                                let _e4723 = f64(0f);
                                                                let _e4724 = f64(1f);
                                                                phi_13855_ = type_35(array<f64, 4>(_e4723, _e4723, _e4723, _e4723), array<f64, 4>(_e4723, _e4723, _e4723, _e4723), array<f64, 4>(_e4724, _e4724, _e4724, _e4724));
                                                            } else {
                                                                phi_13855_ = _e4720;
                                                            }
                                                            let _e4730 = phi_13855_;
                                                            local_1 = type_35(array<f64, 4>(_e4730.member[0], _e4730.member[1], _e4730.member[2], _e4730.member[3]), array<f64, 4>(_e4730.member_1[0], _e4730.member_1[1], _e4730.member_1[2], _e4730.member_1[3]), array<f64, 4>(_e4730.member_2[0], _e4730.member_2[1], _e4730.member_2[2], _e4730.member_2[3]));
                                                            let _e4750 = (_e4411 - _e4417);
                                                            let _e4752 = f64(0f);
                                                            let _e4755 = local_1.member[0u];
                                                            let _e4758 = local_1.member_1[0u];
                                                            let _e4761 = local_1.member[0u];
                                                            let _e4767 = local_1.member_2[0u];
                                                            if (((_e4755 + ((_e4758 - _e4761) * _e4411)) - _e4767) > _e4752) {
                                                                let _e4772 = local_1.member[1u];
                                                                let _e4775 = local_1.member_1[1u];
                                                                let _e4778 = local_1.member[1u];
                                                                let _e4784 = local_1.member_2[1u];
                                                                if (((_e4772 + ((_e4775 - _e4778) * _e4411)) - _e4784) > _e4752) {
                                                                    let _e4789 = local_1.member[2u];
                                                                    let _e4792 = local_1.member_1[2u];
                                                                    let _e4795 = local_1.member[2u];
                                                                    let _e4801 = local_1.member_2[2u];
                                                                    if (((_e4789 + ((_e4792 - _e4795) * _e4411)) - _e4801) > _e4752) {
                                                                        let _e4806 = local_1.member[3u];
                                                                        let _e4809 = local_1.member_1[3u];
                                                                        let _e4812 = local_1.member[3u];
                                                                        let _e4818 = local_1.member_2[3u];
                                                                        phi_14027_ = (((_e4806 + ((_e4809 - _e4812) * _e4411)) - _e4818) > _e4752);
                                                                        phi_14028_ = false;
                                                                    } else {
                                                                        phi_14027_ = bool();
                                                                        phi_14028_ = true;
                                                                    }
                                                                    let _e4822 = phi_14027_;
                                                                    let _e4824 = phi_14028_;
                                                                    phi_14029_ = _e4822;
                                                                    phi_14030_ = _e4824;
                                                                } else {
                                                                    phi_14029_ = bool();
                                                                    phi_14030_ = true;
                                                                }
                                                                let _e4826 = phi_14029_;
                                                                let _e4828 = phi_14030_;
                                                                phi_14031_ = _e4826;
                                                                phi_14032_ = _e4828;
                                                            } else {
                                                                phi_14031_ = bool();
                                                                phi_14032_ = true;
                                                            }
                                                            let _e4830 = phi_14031_;
                                                            let _e4832 = phi_14032_;
                                                            if _e4832 {
                                                                phi_14036_ = false;
                                                            } else {
                                                                phi_14036_ = _e4830;
                                                            }
                                                            let _e4834 = phi_14036_;
                                                            if _e4834 {
                                                                if (_e4411 <= _e4413) {
                                                                    phi_14347_ = true;
                                                                } else {
                                                                    let _e4836 = f64(0f);
                                                                    let _e4839 = local.member[0u];
                                                                    let _e4842 = local.member_1[0u];
                                                                    let _e4845 = local.member[0u];
                                                                    let _e4851 = local.member_2[0u];
                                                                    let _e4855 = local_1.member[0u];
                                                                    let _e4858 = local_1.member_1[0u];
                                                                    let _e4861 = local_1.member[0u];
                                                                    let _e4867 = local_1.member_2[0u];
                                                                    if ((((_e4839 + ((_e4842 - _e4845) * _e4411)) - _e4851) + ((_e4855 + ((_e4858 - _e4861) * _e4417)) - _e4867)) > _e4836) {
                                                                        let _e4873 = local.member[1u];
                                                                        let _e4876 = local.member_1[1u];
                                                                        let _e4879 = local.member[1u];
                                                                        let _e4885 = local.member_2[1u];
                                                                        let _e4889 = local_1.member[1u];
                                                                        let _e4892 = local_1.member_1[1u];
                                                                        let _e4895 = local_1.member[1u];
                                                                        let _e4901 = local_1.member_2[1u];
                                                                        if ((((_e4873 + ((_e4876 - _e4879) * _e4411)) - _e4885) + ((_e4889 + ((_e4892 - _e4895) * _e4417)) - _e4901)) > _e4836) {
                                                                            let _e4907 = local.member[2u];
                                                                            let _e4910 = local.member_1[2u];
                                                                            let _e4913 = local.member[2u];
                                                                            let _e4919 = local.member_2[2u];
                                                                            let _e4923 = local_1.member[2u];
                                                                            let _e4926 = local_1.member_1[2u];
                                                                            let _e4929 = local_1.member[2u];
                                                                            let _e4935 = local_1.member_2[2u];
                                                                            if ((((_e4907 + ((_e4910 - _e4913) * _e4411)) - _e4919) + ((_e4923 + ((_e4926 - _e4929) * _e4417)) - _e4935)) > _e4836) {
                                                                                let _e4941 = local.member[3u];
                                                                                let _e4944 = local.member_1[3u];
                                                                                let _e4947 = local.member[3u];
                                                                                let _e4953 = local.member_2[3u];
                                                                                let _e4957 = local_1.member[3u];
                                                                                let _e4960 = local_1.member_1[3u];
                                                                                let _e4963 = local_1.member[3u];
                                                                                let _e4969 = local_1.member_2[3u];
                                                                                phi_14334_ = ((((_e4941 + ((_e4944 - _e4947) * _e4411)) - _e4953) + ((_e4957 + ((_e4960 - _e4963) * _e4417)) - _e4969)) > _e4836);
                                                                                phi_14335_ = false;
                                                                            } else {
                                                                                phi_14334_ = bool();
                                                                                phi_14335_ = true;
                                                                            }
                                                                            let _e4974 = phi_14334_;
                                                                            let _e4976 = phi_14335_;
                                                                            phi_14336_ = _e4974;
                                                                            phi_14337_ = _e4976;
                                                                        } else {
                                                                            phi_14336_ = bool();
                                                                            phi_14337_ = true;
                                                                        }
                                                                        let _e4978 = phi_14336_;
                                                                        let _e4980 = phi_14337_;
                                                                        phi_14338_ = _e4978;
                                                                        phi_14339_ = _e4980;
                                                                    } else {
                                                                        phi_14338_ = bool();
                                                                        phi_14339_ = true;
                                                                    }
                                                                    let _e4982 = phi_14338_;
                                                                    let _e4984 = phi_14339_;
                                                                    if _e4984 {
                                                                        phi_14343_ = false;
                                                                    } else {
                                                                        phi_14343_ = _e4982;
                                                                    }
                                                                    let _e4986 = phi_14343_;
                                                                    phi_14347_ = _e4986;
                                                                }
                                                                let _e4988 = phi_14347_;
                                                                if _e4988 {
                                                                    if _e4419 {
                                                                        if (_e4411 >= _e3388.member_1) {
                                                                            phi_14358_ = false;
                                                                        } else {
                                                                            phi_14358_ = true;
                                                                        }
                                                                        let _e4991 = phi_14358_;
                                                                        phi_14359_ = _e4991;
                                                                    } else {
                                                                        phi_14359_ = true;
                                                                    }
                                                                    let _e4993 = phi_14359_;
                                                                    if _e4993 {
                                                                        local = type_35(array<f64, 4>(_e4730.member[0], _e4730.member[1], _e4730.member[2], _e4730.member[3]), array<f64, 4>(_e4730.member_1[0], _e4730.member_1[1], _e4730.member_1[2], _e4730.member_1[3]), array<f64, 4>(_e4730.member_2[0], _e4730.member_2[1], _e4730.member_2[2], _e4730.member_2[3]));
                                                                        let _e5015 = local.member[0u];
                                                                        let _e5018 = local.member_1[0u];
                                                                        let _e5021 = local.member_2[0u];
                                                                        if (_e5015 > _e5021) {
                                                                            if (_e5018 > _e5021) {
                                                                                phi_14433_ = false;
                                                                            } else {
                                                                                phi_14433_ = true;
                                                                            }
                                                                            let _e5025 = phi_14433_;
                                                                            phi_14434_ = _e5025;
                                                                        } else {
                                                                            phi_14434_ = true;
                                                                        }
                                                                        let _e5027 = phi_14434_;
                                                                        if _e5027 {
                                                                            let _e5028 = (_e5018 >= _e5015);
                                                                            if _e5028 {
                                                                                phi_14459_ = f64();
                                                                                phi_14460_ = false;
                                                                            } else {
                                                                                if ((_e5015 - _e5018) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14457_ = (((_e5015 - _e5021) / (_e5015 - _e5018)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14458_ = false;
                                                                                } else {
                                                                                    phi_14457_ = f64();
                                                                                    phi_14458_ = true;
                                                                                }
                                                                                let _e5042 = phi_14457_;
                                                                                let _e5044 = phi_14458_;
                                                                                phi_14459_ = _e5042;
                                                                                phi_14460_ = _e5044;
                                                                            }
                                                                            let _e5046 = phi_14459_;
                                                                            let _e5048 = phi_14460_;
                                                                            phi_14461_ = _e5046;
                                                                            phi_14462_ = _e5028;
                                                                            phi_14463_ = _e5048;
                                                                        } else {
                                                                            phi_14461_ = f64();
                                                                            phi_14462_ = true;
                                                                            phi_14463_ = false;
                                                                        }
                                                                        let _e5050 = phi_14461_;
                                                                        let _e5052 = phi_14462_;
                                                                        let _e5054 = phi_14463_;
                                                                        if _e5052 {
                                                                            phi_14468_ = f64(2f);
                                                                            phi_14469_ = true;
                                                                        } else {
                                                                            phi_14468_ = _e4411;
                                                                            phi_14469_ = _e5054;
                                                                        }
                                                                        let _e5057 = phi_14468_;
                                                                        let _e5059 = phi_14469_;
                                                                        if _e5059 {
                                                                            phi_14473_ = _e5057;
                                                                        } else {
                                                                            phi_14473_ = _e5050;
                                                                        }
                                                                        let _e5061 = phi_14473_;
                                                                        let _e5064 = local.member[1u];
                                                                        let _e5067 = local.member_1[1u];
                                                                        let _e5070 = local.member_2[1u];
                                                                        if (_e5064 > _e5070) {
                                                                            if (_e5067 > _e5070) {
                                                                                phi_14505_ = false;
                                                                            } else {
                                                                                phi_14505_ = true;
                                                                            }
                                                                            let _e5074 = phi_14505_;
                                                                            phi_14506_ = _e5074;
                                                                        } else {
                                                                            phi_14506_ = true;
                                                                        }
                                                                        let _e5076 = phi_14506_;
                                                                        if _e5076 {
                                                                            let _e5077 = (_e5067 >= _e5064);
                                                                            if _e5077 {
                                                                                phi_14531_ = f64();
                                                                                phi_14532_ = false;
                                                                            } else {
                                                                                if ((_e5064 - _e5067) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14529_ = (((_e5064 - _e5070) / (_e5064 - _e5067)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14530_ = false;
                                                                                } else {
                                                                                    phi_14529_ = f64();
                                                                                    phi_14530_ = true;
                                                                                }
                                                                                let _e5091 = phi_14529_;
                                                                                let _e5093 = phi_14530_;
                                                                                phi_14531_ = _e5091;
                                                                                phi_14532_ = _e5093;
                                                                            }
                                                                            let _e5095 = phi_14531_;
                                                                            let _e5097 = phi_14532_;
                                                                            phi_14533_ = _e5095;
                                                                            phi_14534_ = _e5077;
                                                                            phi_14535_ = _e5097;
                                                                        } else {
                                                                            phi_14533_ = f64();
                                                                            phi_14534_ = true;
                                                                            phi_14535_ = false;
                                                                        }
                                                                        let _e5099 = phi_14533_;
                                                                        let _e5101 = phi_14534_;
                                                                        let _e5103 = phi_14535_;
                                                                        if _e5101 {
                                                                            phi_14540_ = f64(2f);
                                                                            phi_14541_ = true;
                                                                        } else {
                                                                            phi_14540_ = _e4411;
                                                                            phi_14541_ = _e5103;
                                                                        }
                                                                        let _e5106 = phi_14540_;
                                                                        let _e5108 = phi_14541_;
                                                                        if _e5108 {
                                                                            phi_14545_ = _e5106;
                                                                        } else {
                                                                            phi_14545_ = _e5099;
                                                                        }
                                                                        let _e5110 = phi_14545_;
                                                                        if (_e5061 < _e5110) {
                                                                            phi_14550_ = _e5061;
                                                                        } else {
                                                                            phi_14550_ = _e5110;
                                                                        }
                                                                        let _e5113 = phi_14550_;
                                                                        let _e5116 = local.member[2u];
                                                                        let _e5119 = local.member_1[2u];
                                                                        let _e5122 = local.member_2[2u];
                                                                        if (_e5116 > _e5122) {
                                                                            if (_e5119 > _e5122) {
                                                                                phi_14582_ = false;
                                                                            } else {
                                                                                phi_14582_ = true;
                                                                            }
                                                                            let _e5126 = phi_14582_;
                                                                            phi_14583_ = _e5126;
                                                                        } else {
                                                                            phi_14583_ = true;
                                                                        }
                                                                        let _e5128 = phi_14583_;
                                                                        if _e5128 {
                                                                            let _e5129 = (_e5119 >= _e5116);
                                                                            if _e5129 {
                                                                                phi_14608_ = f64();
                                                                                phi_14609_ = false;
                                                                            } else {
                                                                                if ((_e5116 - _e5119) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14606_ = (((_e5116 - _e5122) / (_e5116 - _e5119)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14607_ = false;
                                                                                } else {
                                                                                    phi_14606_ = f64();
                                                                                    phi_14607_ = true;
                                                                                }
                                                                                let _e5143 = phi_14606_;
                                                                                let _e5145 = phi_14607_;
                                                                                phi_14608_ = _e5143;
                                                                                phi_14609_ = _e5145;
                                                                            }
                                                                            let _e5147 = phi_14608_;
                                                                            let _e5149 = phi_14609_;
                                                                            phi_14610_ = _e5147;
                                                                            phi_14611_ = _e5129;
                                                                            phi_14612_ = _e5149;
                                                                        } else {
                                                                            phi_14610_ = f64();
                                                                            phi_14611_ = true;
                                                                            phi_14612_ = false;
                                                                        }
                                                                        let _e5151 = phi_14610_;
                                                                        let _e5153 = phi_14611_;
                                                                        let _e5155 = phi_14612_;
                                                                        if _e5153 {
                                                                            phi_14617_ = f64(2f);
                                                                            phi_14618_ = true;
                                                                        } else {
                                                                            phi_14617_ = _e4411;
                                                                            phi_14618_ = _e5155;
                                                                        }
                                                                        let _e5158 = phi_14617_;
                                                                        let _e5160 = phi_14618_;
                                                                        if _e5160 {
                                                                            phi_14622_ = _e5158;
                                                                        } else {
                                                                            phi_14622_ = _e5151;
                                                                        }
                                                                        let _e5162 = phi_14622_;
                                                                        let _e5165 = local.member[3u];
                                                                        let _e5168 = local.member_1[3u];
                                                                        let _e5171 = local.member_2[3u];
                                                                        if (_e5165 > _e5171) {
                                                                            if (_e5168 > _e5171) {
                                                                                phi_14654_ = false;
                                                                            } else {
                                                                                phi_14654_ = true;
                                                                            }
                                                                            let _e5175 = phi_14654_;
                                                                            phi_14655_ = _e5175;
                                                                        } else {
                                                                            phi_14655_ = true;
                                                                        }
                                                                        let _e5177 = phi_14655_;
                                                                        if _e5177 {
                                                                            let _e5178 = (_e5168 >= _e5165);
                                                                            if _e5178 {
                                                                                phi_14680_ = f64();
                                                                                phi_14681_ = false;
                                                                            } else {
                                                                                if ((_e5165 - _e5168) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14678_ = (((_e5165 - _e5171) / (_e5165 - _e5168)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14679_ = false;
                                                                                } else {
                                                                                    phi_14678_ = f64();
                                                                                    phi_14679_ = true;
                                                                                }
                                                                                let _e5192 = phi_14678_;
                                                                                let _e5194 = phi_14679_;
                                                                                phi_14680_ = _e5192;
                                                                                phi_14681_ = _e5194;
                                                                            }
                                                                            let _e5196 = phi_14680_;
                                                                            let _e5198 = phi_14681_;
                                                                            phi_14682_ = _e5196;
                                                                            phi_14683_ = _e5178;
                                                                            phi_14684_ = _e5198;
                                                                        } else {
                                                                            phi_14682_ = f64();
                                                                            phi_14683_ = true;
                                                                            phi_14684_ = false;
                                                                        }
                                                                        let _e5200 = phi_14682_;
                                                                        let _e5202 = phi_14683_;
                                                                        let _e5204 = phi_14684_;
                                                                        if _e5202 {
                                                                            phi_14689_ = f64(2f);
                                                                            phi_14690_ = true;
                                                                        } else {
                                                                            phi_14689_ = _e4411;
                                                                            phi_14690_ = _e5204;
                                                                        }
                                                                        let _e5207 = phi_14689_;
                                                                        let _e5209 = phi_14690_;
                                                                        if _e5209 {
                                                                            phi_14694_ = _e5207;
                                                                        } else {
                                                                            phi_14694_ = _e5200;
                                                                        }
                                                                        let _e5211 = phi_14694_;
                                                                        if (_e5162 < _e5211) {
                                                                            phi_14699_ = _e5162;
                                                                        } else {
                                                                            phi_14699_ = _e5211;
                                                                        }
                                                                        let _e5214 = phi_14699_;
                                                                        if (_e5113 < _e5214) {
                                                                            phi_14704_ = _e5113;
                                                                        } else {
                                                                            phi_14704_ = _e5214;
                                                                        }
                                                                        let _e5217 = phi_14704_;
                                                                        if (_e5217 > _e4411) {
                                                                            phi_14709_ = _e5217;
                                                                        } else {
                                                                            phi_14709_ = _e4411;
                                                                        }
                                                                        let _e5220 = phi_14709_;
                                                                        let _e5221 = (_e5220 > _e3388.member_1);
                                                                        if _e5221 {
                                                                            phi_15226_ = f64();
                                                                            phi_15227_ = f64();
                                                                            phi_15228_ = false;
                                                                            phi_15229_ = false;
                                                                        } else {
                                                                            let _e5222 = (_e5220 - _e4411);
                                                                            let _e5223 = (_e5222 <= _e4400);
                                                                            let _e5226 = (_e5220 + (_e539 * f64(0.01f)));
                                                                            if (_e5226 < _e3388.member_1) {
                                                                                phi_14723_ = _e5226;
                                                                            } else {
                                                                                phi_14723_ = _e3388.member_1;
                                                                            }
                                                                            let _e5229 = phi_14723_;
                                                                            if _e5223 {
                                                                                if (_e868 > f64(0f)) {
                                                                                    let _e5234 = local_18.member[0u];
                                                                                    let _e5240 = local_18.member[1u];
                                                                                    let _e5256 = local_18.member_1[0u];
                                                                                    let _e5262 = local_18.member_1[1u];
                                                                                    let _e5278 = local_18.member_2[0u];
                                                                                    let _e5284 = local_18.member_2[1u];
                                                                                    let _e5298 = function_4(array<f64, 3>((_e5234[0] + ((_e5240[0] - _e5234[0]) * _e5229)), (_e5234[1] + ((_e5240[1] - _e5234[1]) * _e5229)), (_e5234[2] + ((_e5240[2] - _e5234[2]) * _e5229))), array<f64, 3>((_e5256[0] + ((_e5262[0] - _e5256[0]) * _e5229)), (_e5256[1] + ((_e5262[1] - _e5256[1]) * _e5229)), (_e5256[2] + ((_e5262[2] - _e5256[2]) * _e5229))), array<f64, 3>((_e5278[0] + ((_e5284[0] - _e5278[0]) * _e5229)), (_e5278[1] + ((_e5284[1] - _e5278[1]) * _e5229)), (_e5278[2] + ((_e5284[2] - _e5278[2]) * _e5229))), _e252.member);
                                                                                    let _e5309 = (((_e5298[0] * _e5298[0]) + (_e5298[1] * _e5298[1])) + (_e5298[2] * _e5298[2]));
                                                                                    if (_e5309 <= 2.2250738585072014e-308lf) {
                                                                                        if (_e5309 > 0.0lf) {
                                                                                            phi_14854_ = (1.464336215552873e-154lf * 2.0lf);
                                                                                        } else {
                                                                                            phi_14854_ = 0.0lf;
                                                                                        }
                                                                                        let _e5361 = phi_14854_;
                                                                                        phi_14918_ = _e5361;
                                                                                    } else {
                                                                                        phi_14861_ = type_18(0i, 5i);
                                                                                        phi_14864_ = bitcast<f64>(((bitcast<u64>(_e5309) / 2lu) + 2303426169912950784lu));
                                                                                        loop {
                                                                                            let _e5316 = phi_14861_;
                                                                                            let _e5318 = phi_14864_;
                                                                                            local_29 = _e5318;
                                                                                            if (_e5316.member < _e5316.member_1) {
                                                                                                let _e5325 = (_e5316.member + 1i);
                                                                                                if ((false == (_e5325 > _e5316.member)) != false) {
                                                                                                    phi_14885_ = true;
                                                                                                } else {
                                                                                                    phi_14885_ = false;
                                                                                                }
                                                                                                let _e5330 = phi_14885_;
                                                                                                if _e5330 {
                                                                                                    phi_14891_ = type_19(0u, type_19().member_1);
                                                                                                } else {
                                                                                                    phi_14891_ = type_19(1u, _e5325);
                                                                                                }
                                                                                                let _e5335 = phi_14891_;
                                                                                                phi_14862_ = type_18(_e5335.member_1, _e5316.member_1);
                                                                                                phi_14905_ = type_19(1u, _e5316.member);
                                                                                            } else {
                                                                                                phi_14862_ = _e5316;
                                                                                                phi_14905_ = type_19(0u, type_19().member_1);
                                                                                            }
                                                                                            let _e5341 = phi_14862_;
                                                                                            let _e5343 = phi_14905_;
                                                                                            let _e5346 = (bitcast<i32>(_e5343.member) != 0i);
                                                                                            if _e5346 {
                                                                                                phi_14865_ = (0.5lf * (_e5318 + (_e5309 / _e5318)));
                                                                                            } else {
                                                                                                phi_14865_ = f64();
                                                                                            }
                                                                                            let _e5351 = phi_14865_;
                                                                                            continue;
                                                                                            continuing {
                                                                                                phi_14861_ = _e5341;
                                                                                                phi_14864_ = _e5351;
                                                                                                break if !(_e5346);
                                                                                            }
                                                                                        }
                                                                                        let _e5356 = local_29;
                                                                                        phi_14918_ = (_e5356 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                                    }
                                                                                    let _e5363 = phi_14918_;
                                                                                    let _e5371 = local_18.member[0u];
                                                                                    if (_e5371[0] < 0.0lf) {
                                                                                        phi_14936_ = -(_e5371[0]);
                                                                                    } else {
                                                                                        phi_14936_ = _e5371[0];
                                                                                    }
                                                                                    let _e5378 = phi_14936_;
                                                                                    if (_e5371[1] < 0.0lf) {
                                                                                        phi_14943_ = -(_e5371[1]);
                                                                                    } else {
                                                                                        phi_14943_ = _e5371[1];
                                                                                    }
                                                                                    let _e5382 = phi_14943_;
                                                                                    if (_e5378 > _e5382) {
                                                                                        phi_14948_ = _e5378;
                                                                                    } else {
                                                                                        phi_14948_ = _e5382;
                                                                                    }
                                                                                    let _e5385 = phi_14948_;
                                                                                    if (_e5371[2] < 0.0lf) {
                                                                                        phi_14955_ = -(_e5371[2]);
                                                                                    } else {
                                                                                        phi_14955_ = _e5371[2];
                                                                                    }
                                                                                    let _e5389 = phi_14955_;
                                                                                    if (_e5385 > _e5389) {
                                                                                        phi_14960_ = _e5385;
                                                                                    } else {
                                                                                        phi_14960_ = _e5389;
                                                                                    }
                                                                                    let _e5392 = phi_14960_;
                                                                                    let _e5395 = local_18.member[1u];
                                                                                    if (_e5395[0] < 0.0lf) {
                                                                                        phi_14973_ = -(_e5395[0]);
                                                                                    } else {
                                                                                        phi_14973_ = _e5395[0];
                                                                                    }
                                                                                    let _e5402 = phi_14973_;
                                                                                    if (_e5395[1] < 0.0lf) {
                                                                                        phi_14980_ = -(_e5395[1]);
                                                                                    } else {
                                                                                        phi_14980_ = _e5395[1];
                                                                                    }
                                                                                    let _e5406 = phi_14980_;
                                                                                    if (_e5402 > _e5406) {
                                                                                        phi_14985_ = _e5402;
                                                                                    } else {
                                                                                        phi_14985_ = _e5406;
                                                                                    }
                                                                                    let _e5409 = phi_14985_;
                                                                                    if (_e5395[2] < 0.0lf) {
                                                                                        phi_14992_ = -(_e5395[2]);
                                                                                    } else {
                                                                                        phi_14992_ = _e5395[2];
                                                                                    }
                                                                                    let _e5413 = phi_14992_;
                                                                                    if (_e5409 > _e5413) {
                                                                                        phi_14997_ = _e5409;
                                                                                    } else {
                                                                                        phi_14997_ = _e5413;
                                                                                    }
                                                                                    let _e5416 = phi_14997_;
                                                                                    if (_e5392 > _e5416) {
                                                                                        phi_15002_ = _e5392;
                                                                                    } else {
                                                                                        phi_15002_ = _e5416;
                                                                                    }
                                                                                    let _e5419 = phi_15002_;
                                                                                    let _e5421 = local_18.member_3;
                                                                                    let _e5425 = local_18.member_1[0u];
                                                                                    if (_e5425[0] < 0.0lf) {
                                                                                        phi_15019_ = -(_e5425[0]);
                                                                                    } else {
                                                                                        phi_15019_ = _e5425[0];
                                                                                    }
                                                                                    let _e5432 = phi_15019_;
                                                                                    if (_e5425[1] < 0.0lf) {
                                                                                        phi_15026_ = -(_e5425[1]);
                                                                                    } else {
                                                                                        phi_15026_ = _e5425[1];
                                                                                    }
                                                                                    let _e5436 = phi_15026_;
                                                                                    if (_e5432 > _e5436) {
                                                                                        phi_15031_ = _e5432;
                                                                                    } else {
                                                                                        phi_15031_ = _e5436;
                                                                                    }
                                                                                    let _e5439 = phi_15031_;
                                                                                    if (_e5425[2] < 0.0lf) {
                                                                                        phi_15038_ = -(_e5425[2]);
                                                                                    } else {
                                                                                        phi_15038_ = _e5425[2];
                                                                                    }
                                                                                    let _e5443 = phi_15038_;
                                                                                    if (_e5439 > _e5443) {
                                                                                        phi_15043_ = _e5439;
                                                                                    } else {
                                                                                        phi_15043_ = _e5443;
                                                                                    }
                                                                                    let _e5446 = phi_15043_;
                                                                                    let _e5449 = local_18.member_1[1u];
                                                                                    if (_e5449[0] < 0.0lf) {
                                                                                        phi_15057_ = -(_e5449[0]);
                                                                                    } else {
                                                                                        phi_15057_ = _e5449[0];
                                                                                    }
                                                                                    let _e5456 = phi_15057_;
                                                                                    if (_e5449[1] < 0.0lf) {
                                                                                        phi_15064_ = -(_e5449[1]);
                                                                                    } else {
                                                                                        phi_15064_ = _e5449[1];
                                                                                    }
                                                                                    let _e5460 = phi_15064_;
                                                                                    if (_e5456 > _e5460) {
                                                                                        phi_15069_ = _e5456;
                                                                                    } else {
                                                                                        phi_15069_ = _e5460;
                                                                                    }
                                                                                    let _e5463 = phi_15069_;
                                                                                    if (_e5449[2] < 0.0lf) {
                                                                                        phi_15076_ = -(_e5449[2]);
                                                                                    } else {
                                                                                        phi_15076_ = _e5449[2];
                                                                                    }
                                                                                    let _e5467 = phi_15076_;
                                                                                    if (_e5463 > _e5467) {
                                                                                        phi_15081_ = _e5463;
                                                                                    } else {
                                                                                        phi_15081_ = _e5467;
                                                                                    }
                                                                                    let _e5470 = phi_15081_;
                                                                                    if (_e5446 > _e5470) {
                                                                                        phi_15086_ = _e5446;
                                                                                    } else {
                                                                                        phi_15086_ = _e5470;
                                                                                    }
                                                                                    let _e5473 = phi_15086_;
                                                                                    let _e5475 = local_18.member_3;
                                                                                    let _e5479 = local_18.member_2[0u];
                                                                                    if (_e5479[0] < 0.0lf) {
                                                                                        phi_15103_ = -(_e5479[0]);
                                                                                    } else {
                                                                                        phi_15103_ = _e5479[0];
                                                                                    }
                                                                                    let _e5486 = phi_15103_;
                                                                                    if (_e5479[1] < 0.0lf) {
                                                                                        phi_15110_ = -(_e5479[1]);
                                                                                    } else {
                                                                                        phi_15110_ = _e5479[1];
                                                                                    }
                                                                                    let _e5490 = phi_15110_;
                                                                                    if (_e5486 > _e5490) {
                                                                                        phi_15115_ = _e5486;
                                                                                    } else {
                                                                                        phi_15115_ = _e5490;
                                                                                    }
                                                                                    let _e5493 = phi_15115_;
                                                                                    if (_e5479[2] < 0.0lf) {
                                                                                        phi_15122_ = -(_e5479[2]);
                                                                                    } else {
                                                                                        phi_15122_ = _e5479[2];
                                                                                    }
                                                                                    let _e5497 = phi_15122_;
                                                                                    if (_e5493 > _e5497) {
                                                                                        phi_15127_ = _e5493;
                                                                                    } else {
                                                                                        phi_15127_ = _e5497;
                                                                                    }
                                                                                    let _e5500 = phi_15127_;
                                                                                    let _e5503 = local_18.member_2[1u];
                                                                                    if (_e5503[0] < 0.0lf) {
                                                                                        phi_15141_ = -(_e5503[0]);
                                                                                    } else {
                                                                                        phi_15141_ = _e5503[0];
                                                                                    }
                                                                                    let _e5510 = phi_15141_;
                                                                                    if (_e5503[1] < 0.0lf) {
                                                                                        phi_15148_ = -(_e5503[1]);
                                                                                    } else {
                                                                                        phi_15148_ = _e5503[1];
                                                                                    }
                                                                                    let _e5514 = phi_15148_;
                                                                                    if (_e5510 > _e5514) {
                                                                                        phi_15153_ = _e5510;
                                                                                    } else {
                                                                                        phi_15153_ = _e5514;
                                                                                    }
                                                                                    let _e5517 = phi_15153_;
                                                                                    if (_e5503[2] < 0.0lf) {
                                                                                        phi_15160_ = -(_e5503[2]);
                                                                                    } else {
                                                                                        phi_15160_ = _e5503[2];
                                                                                    }
                                                                                    let _e5521 = phi_15160_;
                                                                                    if (_e5517 > _e5521) {
                                                                                        phi_15165_ = _e5517;
                                                                                    } else {
                                                                                        phi_15165_ = _e5521;
                                                                                    }
                                                                                    let _e5524 = phi_15165_;
                                                                                    if (_e5500 > _e5524) {
                                                                                        phi_15170_ = _e5500;
                                                                                    } else {
                                                                                        phi_15170_ = _e5524;
                                                                                    }
                                                                                    let _e5527 = phi_15170_;
                                                                                    let _e5529 = local_18.member_3;
                                                                                    let _e5537 = local_18.member_3;
                                                                                    if (((_e5363 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5419 + _e5421) + (_e5473 + _e5475)) + (_e5527 + _e5529)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5537 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e868) {
                                                                                        phi_15194_ = false;
                                                                                    } else {
                                                                                        phi_15194_ = true;
                                                                                    }
                                                                                    let _e5549 = phi_15194_;
                                                                                    phi_15195_ = _e5549;
                                                                                } else {
                                                                                    phi_15195_ = true;
                                                                                }
                                                                                let _e5551 = phi_15195_;
                                                                                phi_15196_ = _e5551;
                                                                            } else {
                                                                                phi_15196_ = true;
                                                                            }
                                                                            let _e5553 = phi_15196_;
                                                                            if _e5553 {
                                                                                if _e4419 {
                                                                                    if _e5223 {
                                                                                        phi_15215_ = f64();
                                                                                        phi_15216_ = true;
                                                                                    } else {
                                                                                        if (_e5222 <= (_e4415 * f64(0.25f))) {
                                                                                            phi_15213_ = f64(0f);
                                                                                            phi_15214_ = false;
                                                                                        } else {
                                                                                            phi_15213_ = f64();
                                                                                            phi_15214_ = true;
                                                                                        }
                                                                                        let _e5560 = phi_15213_;
                                                                                        let _e5562 = phi_15214_;
                                                                                        phi_15215_ = _e5560;
                                                                                        phi_15216_ = _e5562;
                                                                                    }
                                                                                    let _e5564 = phi_15215_;
                                                                                    let _e5566 = phi_15216_;
                                                                                    if _e5566 {
                                                                                        phi_15221_ = (_e4750 + _e4750);
                                                                                    } else {
                                                                                        phi_15221_ = _e5564;
                                                                                    }
                                                                                    let _e5569 = phi_15221_;
                                                                                    phi_15223_ = _e5569;
                                                                                } else {
                                                                                    phi_15223_ = (_e3388.member_1 - _e4411);
                                                                                }
                                                                                let _e5571 = phi_15223_;
                                                                                phi_15224_ = _e5571;
                                                                                phi_15225_ = false;
                                                                            } else {
                                                                                phi_15224_ = f64();
                                                                                phi_15225_ = true;
                                                                            }
                                                                            let _e5573 = phi_15224_;
                                                                            let _e5575 = phi_15225_;
                                                                            phi_15226_ = _e5573;
                                                                            phi_15227_ = _e5222;
                                                                            phi_15228_ = _e5553;
                                                                            phi_15229_ = _e5575;
                                                                        }
                                                                        let _e5577 = phi_15226_;
                                                                        let _e5579 = phi_15227_;
                                                                        let _e5581 = phi_15228_;
                                                                        let _e5583 = phi_15229_;
                                                                        phi_15230_ = _e5220;
                                                                        phi_15231_ = _e5577;
                                                                        phi_15232_ = _e5579;
                                                                        phi_15233_ = _e5220;
                                                                        phi_15234_ = _e5581;
                                                                        phi_15235_ = _e5221;
                                                                        phi_15236_ = _e5583;
                                                                        phi_15237_ = false;
                                                                    } else {
                                                                        phi_15230_ = f64();
                                                                        phi_15231_ = f64();
                                                                        phi_15232_ = f64();
                                                                        phi_15233_ = f64();
                                                                        phi_15234_ = false;
                                                                        phi_15235_ = false;
                                                                        phi_15236_ = false;
                                                                        phi_15237_ = true;
                                                                    }
                                                                    let _e5585 = phi_15230_;
                                                                    let _e5587 = phi_15231_;
                                                                    let _e5589 = phi_15232_;
                                                                    let _e5591 = phi_15233_;
                                                                    let _e5593 = phi_15234_;
                                                                    let _e5595 = phi_15235_;
                                                                    let _e5597 = phi_15236_;
                                                                    let _e5599 = phi_15237_;
                                                                    phi_15238_ = _e5585;
                                                                    phi_15239_ = _e5587;
                                                                    phi_15240_ = _e5589;
                                                                    phi_15241_ = _e5591;
                                                                    phi_15242_ = false;
                                                                    phi_15243_ = _e5593;
                                                                    phi_15244_ = _e5595;
                                                                    phi_15245_ = _e5597;
                                                                    phi_15246_ = _e5599;
                                                                } else {
                                                                    phi_15238_ = f64();
                                                                    phi_15239_ = f64();
                                                                    phi_15240_ = f64();
                                                                    phi_15241_ = f64();
                                                                    phi_15242_ = true;
                                                                    phi_15243_ = false;
                                                                    phi_15244_ = false;
                                                                    phi_15245_ = false;
                                                                    phi_15246_ = false;
                                                                }
                                                                let _e5601 = phi_15238_;
                                                                let _e5603 = phi_15239_;
                                                                let _e5605 = phi_15240_;
                                                                let _e5607 = phi_15241_;
                                                                let _e5609 = phi_15242_;
                                                                let _e5611 = phi_15243_;
                                                                let _e5613 = phi_15244_;
                                                                let _e5615 = phi_15245_;
                                                                let _e5617 = phi_15246_;
                                                                phi_15247_ = _e5601;
                                                                phi_15248_ = _e5603;
                                                                phi_15249_ = _e5605;
                                                                phi_15250_ = _e5607;
                                                                phi_15251_ = _e5609;
                                                                phi_15252_ = _e5611;
                                                                phi_15253_ = _e5613;
                                                                phi_15254_ = _e5615;
                                                                phi_15255_ = _e5617;
                                                            } else {
                                                                phi_15247_ = f64();
                                                                phi_15248_ = f64();
                                                                phi_15249_ = f64();
                                                                phi_15250_ = f64();
                                                                phi_15251_ = true;
                                                                phi_15252_ = false;
                                                                phi_15253_ = false;
                                                                phi_15254_ = false;
                                                                phi_15255_ = false;
                                                            }
                                                            let _e5619 = phi_15247_;
                                                            let _e5621 = phi_15248_;
                                                            let _e5623 = phi_15249_;
                                                            let _e5625 = phi_15250_;
                                                            let _e5627 = phi_15251_;
                                                            let _e5629 = phi_15252_;
                                                            let _e5631 = phi_15253_;
                                                            let _e5633 = phi_15254_;
                                                            let _e5635 = phi_15255_;
                                                            if _e5627 {
                                                                if (_e4411 <= _e4413) {
                                                                    let _e5801 = (_e4421 + 1u);
                                                                    let _e5802 = (_e5801 > 3u);
                                                                    if _e5802 {
                                                                        phi_15268_ = false;
                                                                    } else {
                                                                        phi_15268_ = true;
                                                                    }
                                                                    let _e5804 = phi_15268_;
                                                                    phi_15595_ = _e5801;
                                                                    phi_15596_ = f64();
                                                                    phi_15597_ = false;
                                                                    phi_15598_ = _e5804;
                                                                    phi_15599_ = _e5802;
                                                                } else {
                                                                    let _e5639 = local.member[0u];
                                                                    let _e5642 = local.member_1[0u];
                                                                    let _e5645 = local.member[0u];
                                                                    let _e5651 = local.member_2[0u];
                                                                    let _e5652 = ((_e5639 + ((_e5642 - _e5645) * _e4417)) - _e5651);
                                                                    let _e5655 = local.member[1u];
                                                                    let _e5658 = local.member_1[1u];
                                                                    let _e5661 = local.member[1u];
                                                                    let _e5667 = local.member_2[1u];
                                                                    let _e5668 = ((_e5655 + ((_e5658 - _e5661) * _e4417)) - _e5667);
                                                                    if (_e5652 < _e5668) {
                                                                        phi_15341_ = _e5652;
                                                                    } else {
                                                                        phi_15341_ = _e5668;
                                                                    }
                                                                    let _e5671 = phi_15341_;
                                                                    let _e5674 = local.member[2u];
                                                                    let _e5677 = local.member_1[2u];
                                                                    let _e5680 = local.member[2u];
                                                                    let _e5686 = local.member_2[2u];
                                                                    let _e5687 = ((_e5674 + ((_e5677 - _e5680) * _e4417)) - _e5686);
                                                                    let _e5690 = local.member[3u];
                                                                    let _e5693 = local.member_1[3u];
                                                                    let _e5696 = local.member[3u];
                                                                    let _e5702 = local.member_2[3u];
                                                                    let _e5703 = ((_e5690 + ((_e5693 - _e5696) * _e4417)) - _e5702);
                                                                    if (_e5687 < _e5703) {
                                                                        phi_15414_ = _e5687;
                                                                    } else {
                                                                        phi_15414_ = _e5703;
                                                                    }
                                                                    let _e5706 = phi_15414_;
                                                                    if (_e5671 < _e5706) {
                                                                        phi_15419_ = _e5671;
                                                                    } else {
                                                                        phi_15419_ = _e5706;
                                                                    }
                                                                    let _e5709 = phi_15419_;
                                                                    let _e5712 = local_1.member[0u];
                                                                    let _e5715 = local_1.member_1[0u];
                                                                    let _e5718 = local_1.member[0u];
                                                                    let _e5724 = local_1.member_2[0u];
                                                                    let _e5725 = ((_e5712 + ((_e5715 - _e5718) * _e4411)) - _e5724);
                                                                    let _e5728 = local_1.member[1u];
                                                                    let _e5731 = local_1.member_1[1u];
                                                                    let _e5734 = local_1.member[1u];
                                                                    let _e5740 = local_1.member_2[1u];
                                                                    let _e5741 = ((_e5728 + ((_e5731 - _e5734) * _e4411)) - _e5740);
                                                                    if (_e5725 < _e5741) {
                                                                        phi_15492_ = _e5725;
                                                                    } else {
                                                                        phi_15492_ = _e5741;
                                                                    }
                                                                    let _e5744 = phi_15492_;
                                                                    let _e5747 = local_1.member[2u];
                                                                    let _e5750 = local_1.member_1[2u];
                                                                    let _e5753 = local_1.member[2u];
                                                                    let _e5759 = local_1.member_2[2u];
                                                                    let _e5760 = ((_e5747 + ((_e5750 - _e5753) * _e4411)) - _e5759);
                                                                    let _e5763 = local_1.member[3u];
                                                                    let _e5766 = local_1.member_1[3u];
                                                                    let _e5769 = local_1.member[3u];
                                                                    let _e5775 = local_1.member_2[3u];
                                                                    let _e5776 = ((_e5763 + ((_e5766 - _e5769) * _e4411)) - _e5775);
                                                                    if (_e5760 < _e5776) {
                                                                        phi_15565_ = _e5760;
                                                                    } else {
                                                                        phi_15565_ = _e5776;
                                                                    }
                                                                    let _e5779 = phi_15565_;
                                                                    if (_e5744 < _e5779) {
                                                                        phi_15570_ = _e5744;
                                                                    } else {
                                                                        phi_15570_ = _e5779;
                                                                    }
                                                                    let _e5782 = phi_15570_;
                                                                    let _e5783 = f64(0.0625f);
                                                                    let _e5785 = f64(0.9f);
                                                                    if (_e5782 > f64(0f)) {
                                                                        phi_15593_ = f64(0.5f);
                                                                    } else {
                                                                        let _e5791 = (f64(0.95f) * (_e5709 / (_e5709 - _e5782)));
                                                                        if (_e5791 > _e5783) {
                                                                            if (_e5791 < _e5785) {
                                                                                phi_15591_ = _e5791;
                                                                            } else {
                                                                                phi_15591_ = _e5785;
                                                                            }
                                                                            let _e5795 = phi_15591_;
                                                                            phi_15592_ = _e5795;
                                                                        } else {
                                                                            phi_15592_ = _e5783;
                                                                        }
                                                                        let _e5797 = phi_15592_;
                                                                        phi_15593_ = _e5797;
                                                                    }
                                                                    let _e5799 = phi_15593_;
                                                                    phi_15595_ = u32();
                                                                    phi_15596_ = (_e4750 * _e5799);
                                                                    phi_15597_ = true;
                                                                    phi_15598_ = false;
                                                                    phi_15599_ = false;
                                                                }
                                                                let _e5806 = phi_15595_;
                                                                let _e5808 = phi_15596_;
                                                                let _e5810 = phi_15597_;
                                                                let _e5812 = phi_15598_;
                                                                let _e5814 = phi_15599_;
                                                                phi_15600_ = _e5806;
                                                                phi_15601_ = _e4413;
                                                                phi_15602_ = _e5808;
                                                                phi_15603_ = _e4415;
                                                                phi_15604_ = _e4417;
                                                                phi_15605_ = _e4419;
                                                                phi_15606_ = _e4421;
                                                                phi_15607_ = _e5810;
                                                                phi_15608_ = _e5812;
                                                                phi_15609_ = _e5814;
                                                                phi_15610_ = false;
                                                                phi_15611_ = false;
                                                                phi_15612_ = false;
                                                            } else {
                                                                phi_15600_ = u32();
                                                                phi_15601_ = _e5619;
                                                                phi_15602_ = _e5621;
                                                                phi_15603_ = _e5623;
                                                                phi_15604_ = _e4411;
                                                                phi_15605_ = true;
                                                                phi_15606_ = 0u;
                                                                phi_15607_ = _e5629;
                                                                phi_15608_ = false;
                                                                phi_15609_ = false;
                                                                phi_15610_ = _e5631;
                                                                phi_15611_ = _e5633;
                                                                phi_15612_ = _e5635;
                                                            }
                                                            let _e5816 = phi_15600_;
                                                            let _e5818 = phi_15601_;
                                                            let _e5820 = phi_15602_;
                                                            let _e5822 = phi_15603_;
                                                            let _e5824 = phi_15604_;
                                                            let _e5826 = phi_15605_;
                                                            let _e5828 = phi_15606_;
                                                            let _e5830 = phi_15607_;
                                                            let _e5832 = phi_15608_;
                                                            let _e5834 = phi_15609_;
                                                            let _e5836 = phi_15610_;
                                                            let _e5838 = phi_15611_;
                                                            let _e5840 = phi_15612_;
                                                            if _e5830 {
                                                                let _e5841 = (_e5824 + _e5820);
                                                                if (_e5841 > _e5818) {
                                                                    phi_15621_ = _e5841;
                                                                } else {
                                                                    phi_15621_ = _e5818;
                                                                }
                                                                let _e5844 = phi_15621_;
                                                                if (_e5844 < _e3388.member_1) {
                                                                    phi_15626_ = _e5844;
                                                                } else {
                                                                    phi_15626_ = _e3388.member_1;
                                                                }
                                                                let _e5847 = phi_15626_;
                                                                if !(_e4419) {
                                                                    phi_15635_ = true;
                                                                } else {
                                                                    phi_15635_ = ((_e5847 - _e5824) > _e4400);
                                                                }
                                                                let _e5851 = phi_15635_;
                                                                if _e5851 {
                                                                    phi_15639_ = false;
                                                                } else {
                                                                    phi_15639_ = true;
                                                                }
                                                                let _e5853 = phi_15639_;
                                                                phi_15640_ = _e5847;
                                                                phi_15641_ = _e5818;
                                                                phi_15642_ = _e5822;
                                                                phi_15643_ = _e5824;
                                                                phi_15644_ = _e5826;
                                                                phi_15645_ = _e5828;
                                                                phi_15646_ = _e5851;
                                                                phi_15647_ = _e5853;
                                                                phi_15648_ = false;
                                                                phi_15649_ = false;
                                                                phi_15650_ = false;
                                                                phi_15651_ = false;
                                                            } else {
                                                                phi_15640_ = _e4411;
                                                                phi_15641_ = _e4413;
                                                                phi_15642_ = _e4415;
                                                                phi_15643_ = _e4417;
                                                                phi_15644_ = _e4419;
                                                                phi_15645_ = _e5816;
                                                                phi_15646_ = _e5832;
                                                                phi_15647_ = false;
                                                                phi_15648_ = _e5834;
                                                                phi_15649_ = _e5836;
                                                                phi_15650_ = _e5838;
                                                                phi_15651_ = _e5840;
                                                            }
                                                            let _e5855 = phi_15640_;
                                                            let _e5857 = phi_15641_;
                                                            let _e5859 = phi_15642_;
                                                            let _e5861 = phi_15643_;
                                                            let _e5863 = phi_15644_;
                                                            let _e5865 = phi_15645_;
                                                            let _e5867 = phi_15646_;
                                                            let _e5869 = phi_15647_;
                                                            let _e5871 = phi_15648_;
                                                            let _e5873 = phi_15649_;
                                                            let _e5875 = phi_15650_;
                                                            let _e5877 = phi_15651_;
                                                            phi_13430_ = _e5855;
                                                            phi_13432_ = _e5857;
                                                            phi_13434_ = _e5859;
                                                            phi_13436_ = _e5861;
                                                            phi_13438_ = _e5863;
                                                            phi_13440_ = _e5865;
                                                            phi_15652_ = _e5818;
                                                            phi_15653_ = _e5625;
                                                            phi_15654_ = _e5867;
                                                            phi_15655_ = _e5869;
                                                            phi_15656_ = _e5871;
                                                            phi_15657_ = _e5873;
                                                            phi_15658_ = _e5875;
                                                            phi_15659_ = false;
                                                            phi_15660_ = _e5877;
                                                        } else {
                                                            phi_13430_ = f64();
                                                            phi_13432_ = f64();
                                                            phi_13434_ = f64();
                                                            phi_13436_ = f64();
                                                            phi_13438_ = bool();
                                                            phi_13440_ = u32();
                                                            phi_15652_ = f64();
                                                            phi_15653_ = f64();
                                                            phi_15654_ = false;
                                                            phi_15655_ = false;
                                                            phi_15656_ = false;
                                                            phi_15657_ = false;
                                                            phi_15658_ = false;
                                                            phi_15659_ = true;
                                                            phi_15660_ = false;
                                                        }
                                                        let _e5879 = phi_13430_;
                                                        let _e5881 = phi_13432_;
                                                        let _e5883 = phi_13434_;
                                                        let _e5885 = phi_13436_;
                                                        let _e5887 = phi_13438_;
                                                        let _e5889 = phi_13440_;
                                                        let _e5891 = phi_15652_;
                                                        let _e5893 = phi_15653_;
                                                        let _e5895 = phi_15654_;
                                                        let _e5897 = phi_15655_;
                                                        let _e5899 = phi_15656_;
                                                        let _e5901 = phi_15657_;
                                                        let _e5903 = phi_15658_;
                                                        let _e5905 = phi_15659_;
                                                        let _e5907 = phi_15660_;
                                                        local_30 = _e5897;
                                                        local_70 = _e5899;
                                                        local_71 = _e5901;
                                                        local_72 = _e5903;
                                                        local_73 = _e5905;
                                                        local_74 = _e5907;
                                                        local_75 = _e5897;
                                                        local_76 = _e5893;
                                                        local_77 = _e5891;
                                                        continue;
                                                        continuing {
                                                            phi_13426_ = _e4433;
                                                            phi_13429_ = _e5879;
                                                            phi_13431_ = _e5881;
                                                            phi_13433_ = _e5883;
                                                            phi_13435_ = _e5885;
                                                            phi_13437_ = _e5887;
                                                            phi_13439_ = _e5889;
                                                            break if !(_e5895);
                                                        }
                                                    }
                                                    let _e5910 = local_30;
                                                    if _e5910 {
                                                        phi_15664_ = false;
                                                        phi_15665_ = false;
                                                        phi_15666_ = false;
                                                        phi_15667_ = false;
                                                        phi_15668_ = false;
                                                    } else {
                                                        let _e11717 = local_70;
                                                        phi_15664_ = _e11717;
                                                        let _e11720 = local_71;
                                                        phi_15665_ = _e11720;
                                                        let _e11723 = local_72;
                                                        phi_15666_ = _e11723;
                                                        let _e11726 = local_73;
                                                        phi_15667_ = _e11726;
                                                        let _e11729 = local_74;
                                                        phi_15668_ = _e11729;
                                                    }
                                                    let _e5912 = phi_15664_;
                                                    let _e5914 = phi_15665_;
                                                    let _e5916 = phi_15666_;
                                                    let _e5918 = phi_15667_;
                                                    let _e5920 = phi_15668_;
                                                    if _e5912 {
                                                        let _e5922 = local_31;
                                                        phi_15673_ = type_43(1u, _e5922);
                                                        phi_15674_ = false;
                                                        phi_15675_ = false;
                                                        phi_15676_ = false;
                                                        phi_15677_ = false;
                                                        phi_15678_ = false;
                                                    } else {
                                                        phi_15673_ = type_43();
                                                        phi_15674_ = _e5914;
                                                        phi_15675_ = _e5916;
                                                        let _e11736 = local_75;
                                                        phi_15676_ = _e11736;
                                                        phi_15677_ = _e5918;
                                                        phi_15678_ = _e5920;
                                                    }
                                                    let _e5925 = phi_15673_;
                                                    let _e5927 = phi_15674_;
                                                    let _e5929 = phi_15675_;
                                                    let _e5931 = phi_15676_;
                                                    let _e5933 = phi_15677_;
                                                    let _e5935 = phi_15678_;
                                                    if _e5927 {
                                                        phi_15683_ = type_43(0u, type_43().member_1);
                                                        phi_15684_ = false;
                                                        phi_15685_ = false;
                                                        phi_15686_ = false;
                                                        phi_15687_ = false;
                                                        phi_15688_ = true;
                                                    } else {
                                                        phi_15683_ = _e5925;
                                                        phi_15684_ = _e5929;
                                                        phi_15685_ = _e5931;
                                                        phi_15686_ = _e5933;
                                                        phi_15687_ = _e5935;
                                                        phi_15688_ = _e5912;
                                                    }
                                                    let _e5939 = phi_15683_;
                                                    let _e5941 = phi_15684_;
                                                    let _e5943 = phi_15685_;
                                                    let _e5945 = phi_15686_;
                                                    let _e5947 = phi_15687_;
                                                    let _e5949 = phi_15688_;
                                                    if _e5941 {
                                                        let _e11747 = local_76;
                                                        phi_15692_ = _e11747;
                                                        phi_15693_ = true;
                                                        phi_15694_ = false;
                                                        phi_15695_ = false;
                                                        phi_15696_ = false;
                                                    } else {
                                                        let _e11749 = local_77;
                                                        phi_15692_ = _e11749;
                                                        phi_15693_ = _e5943;
                                                        phi_15694_ = _e5945;
                                                        phi_15695_ = _e5947;
                                                        phi_15696_ = _e5949;
                                                    }
                                                    let _e5951 = phi_15692_;
                                                    let _e5953 = phi_15693_;
                                                    let _e5955 = phi_15694_;
                                                    let _e5957 = phi_15695_;
                                                    let _e5959 = phi_15696_;
                                                    if _e5953 {
                                                        phi_15700_ = _e5951;
                                                        phi_15701_ = true;
                                                        phi_15702_ = false;
                                                        phi_15703_ = false;
                                                    } else {
                                                        let _e11756 = local_78;
                                                        phi_15700_ = _e11756;
                                                        phi_15701_ = _e5955;
                                                        phi_15702_ = _e5957;
                                                        phi_15703_ = _e5959;
                                                    }
                                                    let _e5961 = phi_15700_;
                                                    let _e5963 = phi_15701_;
                                                    let _e5965 = phi_15702_;
                                                    let _e5967 = phi_15703_;
                                                    if _e5963 {
                                                        phi_15708_ = type_43(1u, _e5961);
                                                        phi_15709_ = false;
                                                        phi_15710_ = false;
                                                    } else {
                                                        phi_15708_ = type_43();
                                                        phi_15709_ = _e5965;
                                                        phi_15710_ = _e5967;
                                                    }
                                                    let _e5970 = phi_15708_;
                                                    let _e5972 = phi_15709_;
                                                    let _e5974 = phi_15710_;
                                                    if _e5972 {
                                                        phi_15715_ = type_43(0u, type_43().member_1);
                                                        phi_15716_ = true;
                                                    } else {
                                                        phi_15715_ = _e5939;
                                                        phi_15716_ = _e5974;
                                                    }
                                                    let _e5978 = phi_15715_;
                                                    let _e5980 = phi_15716_;
                                                    if _e5980 {
                                                        phi_15720_ = _e5978;
                                                    } else {
                                                        phi_15720_ = _e5970;
                                                    }
                                                    let _e5982 = phi_15720_;
                                                    let _e5985 = (_e5982.member != 0u);
                                                    if _e5985 {
                                                        phi_15727_ = false;
                                                    } else {
                                                        phi_15727_ = true;
                                                    }
                                                    let _e5987 = phi_15727_;
                                                    phi_15728_ = _e5982.member_1;
                                                    phi_15729_ = _e5987;
                                                    phi_15730_ = _e5985;
                                                    phi_15731_ = false;
                                                } else {
                                                    phi_15728_ = f64();
                                                    phi_15729_ = false;
                                                    phi_15730_ = false;
                                                    phi_15731_ = true;
                                                }
                                                let _e5989 = phi_15728_;
                                                let _e5991 = phi_15729_;
                                                let _e5993 = phi_15730_;
                                                let _e5995 = phi_15731_;
                                                phi_15732_ = _e4147;
                                                phi_15733_ = _e4149;
                                                phi_15734_ = _e5989;
                                                phi_15735_ = _e5991;
                                                phi_15736_ = _e5993;
                                                phi_15737_ = _e5995;
                                            }
                                            let _e5997 = phi_15732_;
                                            let _e5999 = phi_15733_;
                                            let _e6001 = phi_15734_;
                                            let _e6003 = phi_15735_;
                                            let _e6005 = phi_15736_;
                                            let _e6007 = phi_15737_;
                                            phi_15738_ = _e5997;
                                            phi_15739_ = _e5999;
                                            phi_15740_ = _e6001;
                                            phi_15741_ = _e4143;
                                            phi_15742_ = _e6003;
                                            phi_15743_ = _e6005;
                                            phi_15744_ = _e6007;
                                        }
                                        let _e6009 = phi_15738_;
                                        let _e6011 = phi_15739_;
                                        let _e6013 = phi_15740_;
                                        let _e6015 = phi_15741_;
                                        let _e6017 = phi_15742_;
                                        let _e6019 = phi_15743_;
                                        let _e6021 = phi_15744_;
                                        if _e6015 {
                                            phi_15748_ = false;
                                            phi_15749_ = false;
                                            phi_15750_ = false;
                                        } else {
                                            phi_15748_ = _e6017;
                                            phi_15749_ = _e6019;
                                            phi_15750_ = _e6021;
                                        }
                                        let _e6023 = phi_15748_;
                                        let _e6025 = phi_15749_;
                                        let _e6027 = phi_15750_;
                                        phi_15751_ = _e3388;
                                        phi_15752_ = _e6009;
                                        phi_15753_ = _e6011;
                                        phi_15754_ = _e6013;
                                        phi_15755_ = _e3388;
                                        phi_15756_ = _e6015;
                                        phi_15757_ = _e6023;
                                        phi_15758_ = _e6025;
                                        phi_15759_ = _e6027;
                                    } else {
                                        phi_15751_ = type_46();
                                        phi_15752_ = bool();
                                        phi_15753_ = f64();
                                        phi_15754_ = f64();
                                        phi_15755_ = type_46();
                                        phi_15756_ = true;
                                        phi_15757_ = false;
                                        phi_15758_ = false;
                                        phi_15759_ = false;
                                    }
                                    let _e6029 = phi_15751_;
                                    let _e6031 = phi_15752_;
                                    let _e6033 = phi_15753_;
                                    let _e6035 = phi_15754_;
                                    let _e6037 = phi_15755_;
                                    let _e6039 = phi_15756_;
                                    let _e6041 = phi_15757_;
                                    let _e6043 = phi_15758_;
                                    let _e6045 = phi_15759_;
                                    if _e6039 {
                                        phi_15763_ = true;
                                        phi_15764_ = false;
                                        phi_15765_ = false;
                                    } else {
                                        phi_15763_ = _e6041;
                                        phi_15764_ = _e6043;
                                        phi_15765_ = _e6045;
                                    }
                                    let _e6047 = phi_15763_;
                                    let _e6049 = phi_15764_;
                                    let _e6051 = phi_15765_;
                                    phi_15766_ = _e6029;
                                    phi_15767_ = _e6031;
                                    phi_15768_ = _e6033;
                                    phi_15769_ = _e6035;
                                    phi_15770_ = _e6037;
                                    phi_15771_ = _e6047;
                                    phi_15772_ = false;
                                    phi_15773_ = _e6049;
                                    phi_15774_ = _e6051;
                                } else {
                                    phi_15766_ = type_46();
                                    phi_15767_ = bool();
                                    phi_15768_ = f64();
                                    phi_15769_ = f64();
                                    phi_15770_ = type_46();
                                    phi_15771_ = false;
                                    phi_15772_ = true;
                                    phi_15773_ = false;
                                    phi_15774_ = false;
                                }
                                let _e6053 = phi_15766_;
                                let _e6055 = phi_15767_;
                                let _e6057 = phi_15768_;
                                let _e6059 = phi_15769_;
                                let _e6061 = phi_15770_;
                                let _e6063 = phi_15771_;
                                let _e6065 = phi_15772_;
                                let _e6067 = phi_15773_;
                                let _e6069 = phi_15774_;
                                local_32 = _e6065;
                                local_79 = _e6067;
                                local_80 = _e6069;
                                local_33 = _e6055;
                                local_34 = _e6053;
                                local_35 = _e6059;
                                local_36 = _e6057;
                                local_37 = _e6059;
                                local_38 = _e6059;
                                local_39 = _e6061;
                                continue;
                                continuing {
                                    phi_11488_ = _e3096;
                                    break if !(_e6063);
                                }
                            }
                            let _e6072 = local_32;
                            if _e6072 {
                                phi_15779_ = type_43(0u, type_43().member_1);
                                phi_15780_ = false;
                                phi_15781_ = false;
                            } else {
                                phi_15779_ = type_43();
                                let _e11812 = local_79;
                                phi_15780_ = _e11812;
                                let _e11815 = local_80;
                                phi_15781_ = _e11815;
                            }
                            let _e6076 = phi_15779_;
                            let _e6078 = phi_15780_;
                            let _e6080 = phi_15781_;
                            if _e6078 {
                                let _e6082 = local_33;
                                if _e6082 {
                                    let _e6084 = local_34;
                                    let _e6087 = local_35;
                                    let _e6090 = local_36;
                                    if ((_e6084.member_1 - _e6087) <= _e6090) {
                                        let _e6093 = local_37;
                                        phi_15795_ = type_43(1u, _e6093);
                                        phi_15796_ = false;
                                    } else {
                                        phi_15795_ = type_43();
                                        phi_15796_ = true;
                                    }
                                    let _e6096 = phi_15795_;
                                    let _e6098 = phi_15796_;
                                    phi_15797_ = _e6096;
                                    phi_15798_ = _e6098;
                                } else {
                                    phi_15797_ = type_43();
                                    phi_15798_ = true;
                                }
                                let _e6100 = phi_15797_;
                                let _e6102 = phi_15798_;
                                if _e6102 {
                                    let _e6104 = local_38;
                                    phi_15803_ = type_43(2u, _e6104);
                                } else {
                                    phi_15803_ = _e6100;
                                }
                                let _e6107 = phi_15803_;
                                phi_15804_ = _e6107;
                                phi_15805_ = false;
                            } else {
                                phi_15804_ = type_43();
                                phi_15805_ = _e6080;
                            }
                            let _e6109 = phi_15804_;
                            let _e6111 = phi_15805_;
                            if _e6111 {
                                let _e6113 = local_39;
                                phi_15811_ = type_43(1u, _e6113.member);
                                phi_15812_ = true;
                            } else {
                                phi_15811_ = _e6109;
                                phi_15812_ = _e6078;
                            }
                            let _e6117 = phi_15811_;
                            let _e6119 = phi_15812_;
                            phi_15816_ = _e6117;
                            phi_15817_ = _e6076;
                            phi_15818_ = _e6119;
                        } else {
                            phi_15816_ = _e2940;
                            phi_15817_ = type_43();
                            phi_15818_ = true;
                        }
                        let _e6121 = phi_15816_;
                        let _e6123 = phi_15817_;
                        let _e6125 = phi_15818_;
                        phi_15822_ = _e6121;
                        phi_15823_ = _e6123;
                        phi_15824_ = _e6125;
                    }
                    let _e6129 = phi_15822_;
                    let _e6131 = phi_15823_;
                    let _e6133 = phi_15824_;
                    if _e6133 {
                        phi_15828_ = _e6129;
                    } else {
                        phi_15828_ = _e6131;
                    }
                    let _e6135 = phi_15828_;
                    if (_e6135.member == 1u) {
                        if (_e6135.member_1 > _e548) {
                            phi_15839_ = false;
                        } else {
                            phi_15839_ = true;
                        }
                        let _e6141 = phi_15839_;
                        phi_15840_ = _e6141;
                    } else {
                        phi_15840_ = true;
                    }
                    let _e6143 = phi_15840_;
                    if _e6143 {
                        phi_15844_ = false;
                    } else {
                        phi_15844_ = true;
                    }
                    let _e6145 = phi_15844_;
                    if _e6145 {
                        phi_15848_ = 1u;
                    } else {
                        phi_15848_ = 0u;
                    }
                    let _e6147 = phi_15848_;
                    phi_15852_ = type_44(_e6135, _e6147);
                }
                let _e10807 = phi_15852_;
                switch bitcast<i32>(_e10807.member.member) {
                    case 0: {
                        phi_15870_ = type_47(0u, _e10807.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e10818 = function_1(_e10807.member.member_1);
                        phi_15870_ = type_47(0u, _e10807.member_1, _e10818, true);
                        break;
                    }
                    case 2: {
                        let _e10814 = function_1(_e10807.member.member_1);
                        phi_15870_ = type_47(1u, _e10807.member_1, _e10814, true);
                        break;
                    }
                    default: {
                        phi_15870_ = type_47();
                        break;
                    }
                }
                let _e10822 = phi_15870_;
                if (_e10822.member == 0u) {
                    phi_15888_ = false;
                } else {
                    let _e10831 = params.member.member.member_7[0u];
                    let _e10834 = params.member.member.member_7[1u];
                    phi_15888_ = ((_e10831 | _e10834) == 0u);
                }
                let _e10838 = phi_15888_;
                if _e10822.member_3 {
                    if _e210 {
                        phi_15895_ = true;
                    } else {
                        phi_15895_ = _e10838;
                    }
                    let _e10840 = phi_15895_;
                    phi_15896_ = _e10840;
                } else {
                    phi_15896_ = false;
                }
                let _e10842 = phi_15896_;
                if _e10822.member_3 {
                    if _e10838 {
                    } else {
                        let _e10846 = (_e10822.member_2[1] >> bitcast<u32>(20i));
                        if (_e10846 <= 896u) {
                            phi_15919_ = 0u;
                        } else {
                            phi_15919_ = ((((_e10846 - 896u) << bitcast<u32>(23i)) | ((_e10822.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e10822.member_2[0] >> bitcast<u32>(29i)));
                        }
                        let _e10861 = phi_15919_;
                        let _e10863 = atomicMin((&earliest.member[0u]), _e10861);
                    }
                }
                phi_15923_ = type_24(_e205, _e10822.member, _e220, _e223, _e10822.member_2, _e10822.member_1);
                phi_15924_ = _e10842;
            } else {
                phi_15923_ = type_24(_e205, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_15924_ = false;
            }
            let _e10865 = phi_15923_;
            let _e10867 = phi_15924_;
            if (_e123 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e10867 {
                let _e10871 = atomicAdd((&counters[0u]), 1u);
                phi_15935_ = _e10871;
            } else {
                phi_15935_ = 0u;
            }
            let _e10873 = phi_15935_;
            workgroupBarrier();
            if (_e123 == 0u) {
                let _e10876 = atomicLoad((&counters[0u]));
                if (_e10876 > 0u) {
                    let _e10879 = atomicAdd((&contacts.member[0u]), _e10876);
                    atomicStore((&counters[1u]), _e10879);
                }
            }
            workgroupBarrier();
            let _e10882 = atomicLoad((&counters[1u]));
            let _e10883 = (_e10882 + _e10873);
            if _e10867 {
                if _e210 {
                    let _e10886 = params.member.member_1.member_3;
                    if (_e10883 < _e10886) {
                        let _e10888 = (7u * _e10883);
                        atomicStore((&contacts.member[(4u + _e10888)]), _e10865.member);
                        atomicStore((&contacts.member[(_e10888 + 5u)]), _e10865.member_1);
                        atomicStore((&contacts.member[(_e10888 + 6u)]), _e10865.member_2);
                        atomicStore((&contacts.member[(_e10888 + 7u)]), _e10865.member_3);
                        atomicStore((&contacts.member[(_e10888 + 8u)]), _e10865.member_4[0]);
                        atomicStore((&contacts.member[(_e10888 + 9u)]), _e10865.member_4[1]);
                        atomicStore((&contacts.member[(_e10888 + 10u)]), _e10865.member_5);
                    }
                    phi_15995_ = false;
                } else {
                    phi_15995_ = true;
                }
                let _e10913 = phi_15995_;
                phi_15996_ = _e10913;
            } else {
                phi_15996_ = true;
            }
            let _e10915 = phi_15996_;
            if _e10915 {
                if _e10867 {
                    let _e10920 = params.member.member_2.member_1;
                    if (_e10883 < _e10920) {
                        let _e10922 = (2u * _e10883);
                        atomicStore((&contacts.member[(4u + _e10922)]), _e10865.member_2);
                        atomicStore((&contacts.member[(_e10922 + 5u)]), _e10865.member_3);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_457_ = _e192;
            break if !(_e198);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
