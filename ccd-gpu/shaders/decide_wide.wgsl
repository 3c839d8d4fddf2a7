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
    var phi_250_: f64;
    var phi_228_: array<u32, 2>;
    var phi_251_: f64;
    var phi_293_: f64;
    var phi_271_: array<u32, 2>;
    var phi_294_: f64;
    var phi_336_: f64;
    var phi_314_: array<u32, 2>;
    var phi_337_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e21 = bitcast<u32>(param[0]);
        let _e22 = (_e21 & 2147483647u);
        if (_e22 < 8388608u) {
            phi_228_ = array<u32, 2>(0u, 0u);
        } else {
            phi_228_ = array<u32, 2>((_e21 << bitcast<u32>(29i)), ((_e21 ^ _e22) | ((_e22 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e33 = phi_228_;
        phi_251_ = bitcast<f64>(((u64(_e33[1]) * 4294967296lu) + u64(_e33[0])));
    } else {
        if (_e10 == _e11) {
            phi_250_ = (f64(_e11) * 1.401298464324817e-45lf);
        } else {
            phi_250_ = -((f64(_e11) * 1.401298464324817e-45lf));
        }
        let _e20 = phi_250_;
        phi_251_ = _e20;
    }
    let _e42 = phi_251_;
    let _e44 = bitcast<u32>(param[1]);
    let _e45 = (_e44 & 2147483647u);
    if (_e45 >= 8388608u) {
        let _e55 = bitcast<u32>(param[1]);
        let _e56 = (_e55 & 2147483647u);
        if (_e56 < 8388608u) {
            phi_271_ = array<u32, 2>(0u, 0u);
        } else {
            phi_271_ = array<u32, 2>((_e55 << bitcast<u32>(29i)), ((_e55 ^ _e56) | ((_e56 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e67 = phi_271_;
        phi_294_ = bitcast<f64>(((u64(_e67[1]) * 4294967296lu) + u64(_e67[0])));
    } else {
        if (_e44 == _e45) {
            phi_293_ = (f64(_e45) * 1.401298464324817e-45lf);
        } else {
            phi_293_ = -((f64(_e45) * 1.401298464324817e-45lf));
        }
        let _e54 = phi_293_;
        phi_294_ = _e54;
    }
    let _e76 = phi_294_;
    let _e78 = bitcast<u32>(param[2]);
    let _e79 = (_e78 & 2147483647u);
    if (_e79 >= 8388608u) {
        let _e89 = bitcast<u32>(param[2]);
        let _e90 = (_e89 & 2147483647u);
        if (_e90 < 8388608u) {
            phi_314_ = array<u32, 2>(0u, 0u);
        } else {
            phi_314_ = array<u32, 2>((_e89 << bitcast<u32>(29i)), ((_e89 ^ _e90) | ((_e90 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e101 = phi_314_;
        phi_337_ = bitcast<f64>(((u64(_e101[1]) * 4294967296lu) + u64(_e101[0])));
    } else {
        if (_e78 == _e79) {
            phi_336_ = (f64(_e79) * 1.401298464324817e-45lf);
        } else {
            phi_336_ = -((f64(_e79) * 1.401298464324817e-45lf));
        }
        let _e88 = phi_336_;
        phi_337_ = _e88;
    }
    let _e110 = phi_337_;
    return array<f64, 3>(_e42, _e76, _e110);
}

fn function_1(param_1: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_1);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_2(param_2: array<f64, 3>, param_3: array<f64, 3>) -> array<f64, 3> {
    var phi_16522_: array<f64, 3>;

    if ((((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])) < (((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2]))) {
        phi_16522_ = param_3;
    } else {
        phi_16522_ = param_2;
    }
    let _e26 = phi_16522_;
    return _e26;
}

fn function_3(param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: array<f64, 3>, param_7: u32) -> array<f64, 3> {
    var phi_16374_: f64;
    var phi_16376_: f64;
    var phi_16418_: f64;
    var phi_16420_: f64;
    var phi_16468_: f64;
    var phi_16470_: f64;
    var phi_16179_: f64;
    var phi_16181_: f64;
    var phi_16229_: f64;
    var phi_16231_: f64;
    var phi_16276_: f64;
    var phi_16278_: f64;
    var phi_16329_: f64;
    var phi_16331_: f64;
    var phi_16485_: array<array<f64, 3>, 4>;

    let _e9 = (param_4[0] - param_5[0]);
    let _e12 = (param_4[1] - param_5[1]);
    let _e15 = (param_4[2] - param_5[2]);
    if (param_7 != 0u) {
        let _e169 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e169 > f64(0f)) {
            if (_e169 < f64(1f)) {
                phi_16179_ = _e169;
            } else {
                phi_16179_ = f64(1f);
            }
            let _e177 = phi_16179_;
            phi_16181_ = _e177;
        } else {
            phi_16181_ = f64(0f);
        }
        let _e179 = phi_16181_;
        let _e215 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e215 > f64(0f)) {
            if (_e215 < f64(1f)) {
                phi_16229_ = _e215;
            } else {
                phi_16229_ = f64(1f);
            }
            let _e223 = phi_16229_;
            phi_16231_ = _e223;
        } else {
            phi_16231_ = f64(0f);
        }
        let _e225 = phi_16231_;
        let _e258 = ((((_e9 * param_6[0]) + (_e12 * param_6[1])) + (_e15 * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e258 > f64(0f)) {
            if (_e258 < f64(1f)) {
                phi_16276_ = _e258;
            } else {
                phi_16276_ = f64(1f);
            }
            let _e266 = phi_16276_;
            phi_16278_ = _e266;
        } else {
            phi_16278_ = f64(0f);
        }
        let _e268 = phi_16278_;
        let _e281 = (param_4[0] - param_6[0]);
        let _e284 = (param_4[1] - param_6[1]);
        let _e287 = (param_4[2] - param_6[2]);
        let _e307 = ((((_e281 * param_5[0]) + (_e284 * param_5[1])) + (_e287 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e307 > f64(0f)) {
            if (_e307 < f64(1f)) {
                phi_16329_ = _e307;
            } else {
                phi_16329_ = f64(1f);
            }
            let _e315 = phi_16329_;
            phi_16331_ = _e315;
        } else {
            phi_16331_ = f64(0f);
        }
        let _e317 = phi_16331_;
        phi_16485_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e179)), (param_4[1] - (param_5[1] * _e179)), (param_4[2] - (param_5[2] * _e179))), array<f64, 3>((param_4[0] - (param_6[0] * _e225)), (param_4[1] - (param_6[1] * _e225)), (param_4[2] - (param_6[2] * _e225))), array<f64, 3>((_e9 - (param_6[0] * _e268)), (_e12 - (param_6[1] * _e268)), (_e15 - (param_6[2] * _e268))), array<f64, 3>((_e281 - (param_5[0] * _e317)), (_e284 - (param_5[1] * _e317)), (_e287 - (param_5[2] * _e317))));
    } else {
        let _e19 = (param_6[0] - param_5[0]);
        let _e22 = (param_6[1] - param_5[1]);
        let _e25 = (param_6[2] - param_5[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > f64(0f)) {
            if (_e36 < f64(1f)) {
                phi_16374_ = _e36;
            } else {
                phi_16374_ = f64(1f);
            }
            let _e44 = phi_16374_;
            phi_16376_ = _e44;
        } else {
            phi_16376_ = f64(0f);
        }
        let _e46 = phi_16376_;
        let _e53 = array<f64, 3>((_e9 - (_e19 * _e46)), (_e12 - (_e22 * _e46)), (_e15 - (_e25 * _e46)));
        let _e76 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e76 > f64(0f)) {
            if (_e76 < f64(1f)) {
                phi_16418_ = _e76;
            } else {
                phi_16418_ = f64(1f);
            }
            let _e84 = phi_16418_;
            phi_16420_ = _e84;
        } else {
            phi_16420_ = f64(0f);
        }
        let _e86 = phi_16420_;
        let _e122 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e122 > f64(0f)) {
            if (_e122 < f64(1f)) {
                phi_16468_ = _e122;
            } else {
                phi_16468_ = f64(1f);
            }
            let _e130 = phi_16468_;
            phi_16470_ = _e130;
        } else {
            phi_16470_ = f64(0f);
        }
        let _e132 = phi_16470_;
        phi_16485_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e86)), (param_4[1] - (param_5[1] * _e86)), (param_4[2] - (param_5[2] * _e86))), array<f64, 3>((param_4[0] - (param_6[0] * _e132)), (param_4[1] - (param_6[1] * _e132)), (param_4[2] - (param_6[2] * _e132))), _e53, _e53);
    }
    let _e330 = phi_16485_;
    let _e333 = function_2(_e330[0], _e330[1]);
    let _e335 = function_2(_e333, _e330[2]);
    let _e337 = function_2(_e335, _e330[3]);
    return _e337;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_16076_: bool;
    var phi_16077_: bool;
    var phi_16078_: bool;
    var phi_16079_: bool;
    var phi_16083_: bool;
    var phi_16056_: bool;
    var phi_16057_: bool;
    var phi_16058_: bool;
    var phi_16059_: bool;
    var phi_16060_: bool;
    var phi_16061_: bool;
    var phi_16065_: bool;
    var phi_16084_: bool;
    var phi_16118_: array<f64, 3>;
    var phi_16119_: bool;
    var phi_16120_: array<f64, 3>;
    var phi_16121_: bool;
    var phi_16126_: array<f64, 3>;

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
                    phi_16056_ = (_e80 <= _e72);
                    phi_16057_ = false;
                } else {
                    phi_16056_ = bool();
                    phi_16057_ = true;
                }
                let _e101 = phi_16056_;
                let _e103 = phi_16057_;
                phi_16058_ = _e101;
                phi_16059_ = _e103;
            } else {
                phi_16058_ = bool();
                phi_16059_ = true;
            }
            let _e105 = phi_16058_;
            let _e107 = phi_16059_;
            phi_16060_ = _e105;
            phi_16061_ = _e107;
        } else {
            phi_16060_ = bool();
            phi_16061_ = true;
        }
        let _e109 = phi_16060_;
        let _e111 = phi_16061_;
        if _e111 {
            phi_16065_ = false;
        } else {
            phi_16065_ = _e109;
        }
        let _e113 = phi_16065_;
        phi_16084_ = _e113;
    } else {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                phi_16076_ = ((_e76 + _e80) <= _e72);
                phi_16077_ = false;
            } else {
                phi_16076_ = bool();
                phi_16077_ = true;
            }
            let _e87 = phi_16076_;
            let _e89 = phi_16077_;
            phi_16078_ = _e87;
            phi_16079_ = _e89;
        } else {
            phi_16078_ = bool();
            phi_16079_ = true;
        }
        let _e91 = phi_16078_;
        let _e93 = phi_16079_;
        if _e93 {
            phi_16083_ = false;
        } else {
            phi_16083_ = _e91;
        }
        let _e95 = phi_16083_;
        phi_16084_ = _e95;
    }
    let _e115 = phi_16084_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e115 {
            phi_16118_ = array<f64, 3>((param_8[0] - ((param_9[0] * _e76) + (param_10[0] * _e80))), (param_8[1] - ((param_9[1] * _e76) + (param_10[1] * _e80))), (param_8[2] - ((param_9[2] * _e76) + (param_10[2] * _e80))));
            phi_16119_ = false;
        } else {
            phi_16118_ = array<f64, 3>();
            phi_16119_ = true;
        }
        let _e144 = phi_16118_;
        let _e146 = phi_16119_;
        phi_16120_ = _e144;
        phi_16121_ = _e146;
    } else {
        phi_16120_ = array<f64, 3>();
        phi_16121_ = true;
    }
    let _e148 = phi_16120_;
    let _e150 = phi_16121_;
    if _e150 {
        let _e151 = function_3(param_8, param_9, param_10, param_11);
        phi_16126_ = _e151;
    } else {
        phi_16126_ = _e148;
    }
    let _e153 = phi_16126_;
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
    var phi_398_: u32;
    var phi_408_: u32;
    var phi_415_: u32;
    var phi_431_: u32;
    var phi_452_: u32;
    var phi_453_: u32;
    var phi_456_: type_9;
    var phi_457_: type_9;
    var phi_480_: type_9;
    var phi_613_: type_26;
    var phi_817_: type_31;
    var phi_978_: type_33;
    var phi_1026_: f64;
    var phi_1033_: f64;
    var phi_1038_: f64;
    var phi_1045_: f64;
    var phi_1050_: f64;
    var phi_1058_: f64;
    var phi_1065_: f64;
    var phi_1070_: f64;
    var phi_1077_: f64;
    var phi_1082_: f64;
    var phi_1087_: f64;
    var phi_1097_: f64;
    var phi_1104_: f64;
    var phi_1109_: f64;
    var phi_1116_: f64;
    var phi_1121_: f64;
    var phi_1129_: f64;
    var phi_1136_: f64;
    var phi_1141_: f64;
    var phi_1148_: f64;
    var phi_1153_: f64;
    var phi_1158_: f64;
    var phi_1168_: f64;
    var phi_1175_: f64;
    var phi_1180_: f64;
    var phi_1187_: f64;
    var phi_1192_: f64;
    var phi_1200_: f64;
    var phi_1207_: f64;
    var phi_1212_: f64;
    var phi_1219_: f64;
    var phi_1224_: f64;
    var phi_1229_: f64;
    var phi_1236_: f64;
    var phi_1241_: f64;
    var phi_1250_: bool;
    var phi_1274_: u64;
    var phi_1286_: f64;
    var phi_1287_: f64;
    var phi_1346_: type_42;
    var phi_1347_: bool;
    var phi_1348_: type_42;
    var phi_1349_: bool;
    var phi_1350_: type_42;
    var phi_1351_: bool;
    var phi_1356_: type_42;
    var phi_8422_: f64;
    var phi_8429_: f64;
    var phi_8434_: f64;
    var phi_8441_: f64;
    var phi_8446_: f64;
    var phi_8459_: f64;
    var phi_8466_: f64;
    var phi_8471_: f64;
    var phi_8478_: f64;
    var phi_8483_: f64;
    var phi_8488_: f64;
    var phi_8505_: f64;
    var phi_8512_: f64;
    var phi_8517_: f64;
    var phi_8524_: f64;
    var phi_8529_: f64;
    var phi_8543_: f64;
    var phi_8550_: f64;
    var phi_8555_: f64;
    var phi_8562_: f64;
    var phi_8567_: f64;
    var phi_8572_: f64;
    var phi_8589_: f64;
    var phi_8596_: f64;
    var phi_8601_: f64;
    var phi_8608_: f64;
    var phi_8613_: f64;
    var phi_8627_: f64;
    var phi_8634_: f64;
    var phi_8639_: f64;
    var phi_8646_: f64;
    var phi_8651_: f64;
    var phi_8656_: f64;
    var phi_8693_: f64;
    var phi_8699_: f64;
    var phi_8706_: f64;
    var phi_8713_: f64;
    var phi_8719_: f64;
    var phi_8726_: f64;
    var phi_8732_: f64;
    var phi_8738_: f64;
    var phi_8744_: f64;
    var phi_8751_: f64;
    var phi_8758_: f64;
    var phi_8786_: f64;
    var phi_8791_: f64;
    var phi_8796_: f64;
    var phi_8801_: f64;
    var phi_8806_: f64;
    var phi_8811_: f64;
    var phi_8822_: f64;
    var phi_8836_: f64;
    var phi_8842_: f64;
    var phi_8847_: f64;
    var phi_8853_: f64;
    var phi_8859_: f64;
    var phi_8864_: f64;
    var phi_8869_: f64;
    var phi_8879_: bool;
    var phi_8886_: f64;
    var phi_8894_: f64;
    var phi_8902_: f64;
    var phi_8921_: f64;
    var phi_8983_: array<f64, 3>;
    var phi_9048_: array<f64, 3>;
    var phi_9070_: f64;
    var phi_9077_: f64;
    var phi_9082_: f64;
    var phi_9089_: f64;
    var phi_9094_: f64;
    var phi_9107_: f64;
    var phi_9114_: f64;
    var phi_9119_: f64;
    var phi_9126_: f64;
    var phi_9131_: f64;
    var phi_9136_: f64;
    var phi_9153_: f64;
    var phi_9160_: f64;
    var phi_9165_: f64;
    var phi_9172_: f64;
    var phi_9177_: f64;
    var phi_9191_: f64;
    var phi_9198_: f64;
    var phi_9203_: f64;
    var phi_9210_: f64;
    var phi_9215_: f64;
    var phi_9220_: f64;
    var phi_9237_: f64;
    var phi_9244_: f64;
    var phi_9249_: f64;
    var phi_9256_: f64;
    var phi_9261_: f64;
    var phi_9275_: f64;
    var phi_9282_: f64;
    var phi_9287_: f64;
    var phi_9294_: f64;
    var phi_9299_: f64;
    var phi_9304_: f64;
    var phi_9425_: f64;
    var phi_9432_: f64;
    var phi_9440_: f64;
    var phi_9486_: type_18;
    var phi_9489_: f64;
    var phi_9510_: bool;
    var phi_9516_: type_19;
    var phi_9487_: type_18;
    var phi_9530_: type_19;
    var phi_9490_: f64;
    var local_19: f64;
    var phi_9479_: f64;
    var phi_9543_: f64;
    var phi_9612_: f64;
    var phi_9618_: f64;
    var phi_9627_: f64;
    var phi_9633_: f64;
    var phi_9642_: f64;
    var phi_9648_: f64;
    var phi_9657_: f64;
    var phi_9663_: f64;
    var phi_9669_: type_35;
    var phi_9670_: bool;
    var phi_9671_: type_35;
    var phi_9672_: bool;
    var phi_9682_: type_35;
    var phi_9852_: bool;
    var phi_9853_: bool;
    var phi_9854_: bool;
    var phi_9855_: bool;
    var phi_9856_: bool;
    var phi_9857_: bool;
    var phi_9861_: bool;
    var phi_9889_: f64;
    var phi_9895_: f64;
    var phi_9902_: f64;
    var phi_9945_: type_18;
    var phi_9948_: f64;
    var phi_9969_: bool;
    var phi_9975_: type_19;
    var phi_9946_: type_18;
    var phi_9989_: type_19;
    var phi_9949_: f64;
    var local_20: f64;
    var phi_9938_: f64;
    var phi_10002_: f64;
    var phi_10071_: f64;
    var phi_10077_: f64;
    var phi_10086_: f64;
    var phi_10092_: f64;
    var phi_10101_: f64;
    var phi_10107_: f64;
    var phi_10116_: f64;
    var phi_10122_: f64;
    var phi_10128_: type_35;
    var phi_10129_: bool;
    var phi_10130_: type_35;
    var phi_10131_: bool;
    var phi_10141_: type_35;
    var phi_10311_: bool;
    var phi_10312_: bool;
    var phi_10313_: bool;
    var phi_10314_: bool;
    var phi_10315_: bool;
    var phi_10316_: bool;
    var phi_10320_: bool;
    var phi_10348_: f64;
    var phi_10354_: f64;
    var phi_10361_: f64;
    var phi_10404_: type_18;
    var phi_10407_: f64;
    var phi_10428_: bool;
    var phi_10434_: type_19;
    var phi_10405_: type_18;
    var phi_10448_: type_19;
    var phi_10408_: f64;
    var local_21: f64;
    var phi_10397_: f64;
    var phi_10461_: f64;
    var phi_10530_: f64;
    var phi_10536_: f64;
    var phi_10545_: f64;
    var phi_10551_: f64;
    var phi_10560_: f64;
    var phi_10566_: f64;
    var phi_10575_: f64;
    var phi_10581_: f64;
    var phi_10587_: type_35;
    var phi_10588_: bool;
    var phi_10589_: type_35;
    var phi_10590_: bool;
    var phi_10600_: type_35;
    var phi_10770_: bool;
    var phi_10771_: bool;
    var phi_10772_: bool;
    var phi_10773_: bool;
    var phi_10774_: bool;
    var phi_10775_: bool;
    var phi_10779_: bool;
    var phi_10807_: f64;
    var phi_10813_: f64;
    var phi_10820_: f64;
    var phi_10863_: type_18;
    var phi_10866_: f64;
    var phi_10887_: bool;
    var phi_10893_: type_19;
    var phi_10864_: type_18;
    var phi_10907_: type_19;
    var phi_10867_: f64;
    var local_22: f64;
    var phi_10856_: f64;
    var phi_10920_: f64;
    var phi_10989_: f64;
    var phi_10995_: f64;
    var phi_11004_: f64;
    var phi_11010_: f64;
    var phi_11019_: f64;
    var phi_11025_: f64;
    var phi_11034_: f64;
    var phi_11040_: f64;
    var phi_11046_: type_35;
    var phi_11047_: bool;
    var phi_11048_: type_35;
    var phi_11049_: bool;
    var phi_11059_: type_35;
    var phi_11229_: bool;
    var phi_11230_: bool;
    var phi_11231_: bool;
    var phi_11232_: bool;
    var phi_11233_: bool;
    var phi_11234_: bool;
    var phi_11238_: bool;
    var phi_11239_: bool;
    var phi_11240_: bool;
    var phi_11241_: bool;
    var phi_11242_: bool;
    var phi_11243_: bool;
    var phi_11247_: bool;
    var phi_11253_: type_43;
    var phi_11254_: bool;
    var phi_11255_: type_43;
    var phi_11256_: bool;
    var phi_11302_: type_18;
    var phi_11305_: f64;
    var phi_11326_: bool;
    var phi_11332_: type_19;
    var phi_11303_: type_18;
    var phi_11346_: type_19;
    var phi_11306_: f64;
    var local_23: f64;
    var phi_11295_: f64;
    var phi_11359_: f64;
    var phi_11365_: f64;
    var phi_11390_: type_9;
    var phi_11393_: u32;
    var phi_11391_: type_9;
    var phi_11416_: type_9;
    var phi_11460_: u32;
    var phi_11461_: u32;
    var phi_11394_: u32;
    var phi_11462_: u32;
    var phi_11482_: type_9;
    var phi_11483_: type_9;
    var phi_11506_: type_9;
    var phi_11525_: f64;
    var phi_11538_: f64;
    var phi_11574_: f64;
    var phi_11581_: f64;
    var phi_11593_: bool;
    var phi_11594_: bool;
    var phi_11595_: bool;
    var phi_11596_: bool;
    var phi_11600_: bool;
    var phi_11612_: type_46;
    var phi_11613_: type_46;
    var phi_11614_: bool;
    var phi_11615_: type_46;
    var phi_11616_: bool;
    var phi_11629_: f64;
    var phi_11641_: type_9;
    var phi_11644_: f64;
    var phi_11646_: f64;
    var phi_11648_: f64;
    var phi_11642_: type_9;
    var phi_11671_: type_9;
    var phi_11698_: f64;
    var phi_11699_: f64;
    var phi_11727_: f64;
    var phi_11743_: f64;
    var phi_11750_: bool;
    var phi_11751_: bool;
    var phi_11752_: bool;
    var phi_11758_: f64;
    var phi_11759_: f64;
    var phi_11760_: bool;
    var phi_11645_: f64;
    var phi_11647_: f64;
    var phi_11649_: f64;
    var phi_11761_: f64;
    var phi_11762_: bool;
    var phi_11763_: bool;
    var local_24: bool;
    var phi_11767_: f64;
    var phi_11768_: f64;
    var phi_11778_: f64;
    var phi_11782_: type_9;
    var phi_11785_: f64;
    var phi_11783_: type_9;
    var phi_11808_: type_9;
    var phi_11839_: f64;
    var phi_11840_: bool;
    var phi_11841_: f64;
    var phi_11842_: bool;
    var phi_11843_: bool;
    var phi_11844_: bool;
    var phi_11845_: f64;
    var phi_11786_: f64;
    var phi_11846_: bool;
    var phi_11847_: bool;
    var phi_11848_: bool;
    var phi_11849_: bool;
    var local_25: bool;
    var phi_11853_: bool;
    var phi_11854_: bool;
    var phi_11858_: bool;
    var phi_11862_: f64;
    var phi_11863_: f64;
    var phi_11865_: type_46;
    var phi_11896_: f64;
    var phi_11903_: f64;
    var phi_11908_: f64;
    var phi_11915_: f64;
    var phi_11920_: f64;
    var phi_11933_: f64;
    var phi_11940_: f64;
    var phi_11945_: f64;
    var phi_11952_: f64;
    var phi_11957_: f64;
    var phi_11962_: f64;
    var phi_12021_: f64;
    var phi_12027_: f64;
    var phi_12032_: f64;
    var phi_12038_: f64;
    var phi_12043_: f64;
    var phi_12057_: f64;
    var phi_12063_: f64;
    var phi_12068_: f64;
    var phi_12074_: f64;
    var phi_12079_: f64;
    var phi_12105_: f64;
    var phi_12112_: f64;
    var phi_12117_: f64;
    var phi_12124_: f64;
    var phi_12129_: f64;
    var phi_12142_: f64;
    var phi_12149_: f64;
    var phi_12154_: f64;
    var phi_12161_: f64;
    var phi_12166_: f64;
    var phi_12171_: f64;
    var phi_12230_: f64;
    var phi_12236_: f64;
    var phi_12241_: f64;
    var phi_12247_: f64;
    var phi_12252_: f64;
    var phi_12266_: f64;
    var phi_12272_: f64;
    var phi_12277_: f64;
    var phi_12283_: f64;
    var phi_12288_: f64;
    var phi_12314_: f64;
    var phi_12321_: f64;
    var phi_12326_: f64;
    var phi_12333_: f64;
    var phi_12338_: f64;
    var phi_12351_: f64;
    var phi_12358_: f64;
    var phi_12363_: f64;
    var phi_12370_: f64;
    var phi_12375_: f64;
    var phi_12380_: f64;
    var phi_12439_: f64;
    var phi_12445_: f64;
    var phi_12450_: f64;
    var phi_12456_: f64;
    var phi_12461_: f64;
    var phi_12475_: f64;
    var phi_12481_: f64;
    var phi_12486_: f64;
    var phi_12492_: f64;
    var phi_12497_: f64;
    var phi_12546_: f64;
    var phi_12552_: f64;
    var phi_12580_: f64;
    var phi_12586_: f64;
    var phi_12591_: u32;
    var phi_12592_: u32;
    var phi_12562_: f64;
    var phi_12568_: f64;
    var phi_12573_: u32;
    var phi_12574_: u32;
    var phi_12593_: u32;
    var phi_12594_: u32;
    var phi_12667_: f64;
    var phi_12679_: f64;
    var phi_12822_: f64;
    var phi_12828_: f64;
    var phi_12835_: f64;
    var phi_12871_: array<type_37, 4>;
    var phi_12891_: type_9;
    var phi_12894_: bool;
    var phi_12892_: type_9;
    var phi_12917_: type_9;
    var phi_12944_: bool;
    var phi_12945_: bool;
    var phi_12895_: bool;
    var phi_12946_: bool;
    var phi_12947_: bool;
    var local_26: bool;
    var phi_12951_: bool;
    var local_27: bool;
    var phi_12958_: u32;
    var phi_12959_: u32;
    var phi_12960_: bool;
    var phi_12961_: u32;
    var phi_12962_: u32;
    var phi_12963_: bool;
    var phi_12967_: u32;
    var phi_12977_: bool;
    var phi_12990_: bool;
    var phi_12991_: bool;
    var phi_13052_: array<f64, 3>;
    var phi_13117_: array<f64, 3>;
    var phi_13139_: f64;
    var phi_13146_: f64;
    var phi_13151_: f64;
    var phi_13158_: f64;
    var phi_13163_: f64;
    var phi_13176_: f64;
    var phi_13183_: f64;
    var phi_13188_: f64;
    var phi_13195_: f64;
    var phi_13200_: f64;
    var phi_13205_: f64;
    var phi_13222_: f64;
    var phi_13229_: f64;
    var phi_13234_: f64;
    var phi_13241_: f64;
    var phi_13246_: f64;
    var phi_13260_: f64;
    var phi_13267_: f64;
    var phi_13272_: f64;
    var phi_13279_: f64;
    var phi_13284_: f64;
    var phi_13289_: f64;
    var phi_13306_: f64;
    var phi_13313_: f64;
    var phi_13318_: f64;
    var phi_13325_: f64;
    var phi_13330_: f64;
    var phi_13344_: f64;
    var phi_13351_: f64;
    var phi_13356_: f64;
    var phi_13363_: f64;
    var phi_13368_: f64;
    var phi_13373_: f64;
    var phi_13420_: type_9;
    var phi_13423_: f64;
    var phi_13425_: f64;
    var phi_13427_: f64;
    var phi_13429_: f64;
    var phi_13431_: bool;
    var phi_13433_: u32;
    var phi_13421_: type_9;
    var phi_13456_: type_9;
    var phi_13571_: f64;
    var phi_13577_: f64;
    var phi_13583_: f64;
    var phi_13585_: array<f64, 3>;
    var phi_13592_: f64;
    var phi_13599_: f64;
    var phi_13607_: f64;
    var phi_13653_: type_18;
    var phi_13656_: f64;
    var phi_13677_: bool;
    var phi_13683_: type_19;
    var phi_13654_: type_18;
    var phi_13697_: type_19;
    var phi_13657_: f64;
    var local_28: f64;
    var phi_13646_: f64;
    var phi_13710_: f64;
    var phi_13779_: f64;
    var phi_13785_: f64;
    var phi_13794_: f64;
    var phi_13800_: f64;
    var phi_13809_: f64;
    var phi_13815_: f64;
    var phi_13824_: f64;
    var phi_13830_: f64;
    var phi_13836_: type_35;
    var phi_13837_: bool;
    var phi_13838_: type_35;
    var phi_13839_: bool;
    var phi_13849_: type_35;
    var phi_14021_: bool;
    var phi_14022_: bool;
    var phi_14023_: bool;
    var phi_14024_: bool;
    var phi_14025_: bool;
    var phi_14026_: bool;
    var phi_14030_: bool;
    var phi_14328_: bool;
    var phi_14329_: bool;
    var phi_14330_: bool;
    var phi_14331_: bool;
    var phi_14332_: bool;
    var phi_14333_: bool;
    var phi_14337_: bool;
    var phi_14341_: bool;
    var phi_14352_: bool;
    var phi_14353_: bool;
    var phi_14427_: bool;
    var phi_14428_: bool;
    var phi_14451_: f64;
    var phi_14452_: bool;
    var phi_14453_: f64;
    var phi_14454_: bool;
    var phi_14455_: f64;
    var phi_14456_: bool;
    var phi_14457_: bool;
    var phi_14462_: f64;
    var phi_14463_: bool;
    var phi_14467_: f64;
    var phi_14499_: bool;
    var phi_14500_: bool;
    var phi_14523_: f64;
    var phi_14524_: bool;
    var phi_14525_: f64;
    var phi_14526_: bool;
    var phi_14527_: f64;
    var phi_14528_: bool;
    var phi_14529_: bool;
    var phi_14534_: f64;
    var phi_14535_: bool;
    var phi_14539_: f64;
    var phi_14544_: f64;
    var phi_14576_: bool;
    var phi_14577_: bool;
    var phi_14600_: f64;
    var phi_14601_: bool;
    var phi_14602_: f64;
    var phi_14603_: bool;
    var phi_14604_: f64;
    var phi_14605_: bool;
    var phi_14606_: bool;
    var phi_14611_: f64;
    var phi_14612_: bool;
    var phi_14616_: f64;
    var phi_14648_: bool;
    var phi_14649_: bool;
    var phi_14672_: f64;
    var phi_14673_: bool;
    var phi_14674_: f64;
    var phi_14675_: bool;
    var phi_14676_: f64;
    var phi_14677_: bool;
    var phi_14678_: bool;
    var phi_14683_: f64;
    var phi_14684_: bool;
    var phi_14688_: f64;
    var phi_14693_: f64;
    var phi_14698_: f64;
    var phi_14703_: f64;
    var phi_14717_: f64;
    var phi_14855_: type_18;
    var phi_14858_: f64;
    var phi_14879_: bool;
    var phi_14885_: type_19;
    var phi_14856_: type_18;
    var phi_14899_: type_19;
    var phi_14859_: f64;
    var local_29: f64;
    var phi_14848_: f64;
    var phi_14912_: f64;
    var phi_14930_: f64;
    var phi_14937_: f64;
    var phi_14942_: f64;
    var phi_14949_: f64;
    var phi_14954_: f64;
    var phi_14967_: f64;
    var phi_14974_: f64;
    var phi_14979_: f64;
    var phi_14986_: f64;
    var phi_14991_: f64;
    var phi_14996_: f64;
    var phi_15013_: f64;
    var phi_15020_: f64;
    var phi_15025_: f64;
    var phi_15032_: f64;
    var phi_15037_: f64;
    var phi_15051_: f64;
    var phi_15058_: f64;
    var phi_15063_: f64;
    var phi_15070_: f64;
    var phi_15075_: f64;
    var phi_15080_: f64;
    var phi_15097_: f64;
    var phi_15104_: f64;
    var phi_15109_: f64;
    var phi_15116_: f64;
    var phi_15121_: f64;
    var phi_15135_: f64;
    var phi_15142_: f64;
    var phi_15147_: f64;
    var phi_15154_: f64;
    var phi_15159_: f64;
    var phi_15164_: f64;
    var phi_15188_: bool;
    var phi_15189_: bool;
    var phi_15190_: bool;
    var phi_15207_: f64;
    var phi_15208_: bool;
    var phi_15209_: f64;
    var phi_15210_: bool;
    var phi_15215_: f64;
    var phi_15217_: f64;
    var phi_15218_: f64;
    var phi_15219_: bool;
    var phi_15220_: f64;
    var phi_15221_: f64;
    var phi_15222_: bool;
    var phi_15223_: bool;
    var phi_15224_: f64;
    var phi_15225_: f64;
    var phi_15226_: f64;
    var phi_15227_: f64;
    var phi_15228_: bool;
    var phi_15229_: bool;
    var phi_15230_: bool;
    var phi_15231_: bool;
    var phi_15232_: f64;
    var phi_15233_: f64;
    var phi_15234_: f64;
    var phi_15235_: f64;
    var phi_15236_: bool;
    var phi_15237_: bool;
    var phi_15238_: bool;
    var phi_15239_: bool;
    var phi_15240_: bool;
    var phi_15241_: f64;
    var phi_15242_: f64;
    var phi_15243_: f64;
    var phi_15244_: f64;
    var phi_15245_: bool;
    var phi_15246_: bool;
    var phi_15247_: bool;
    var phi_15248_: bool;
    var phi_15249_: bool;
    var phi_15335_: f64;
    var phi_15408_: f64;
    var phi_15413_: f64;
    var phi_15486_: f64;
    var phi_15559_: f64;
    var phi_15564_: f64;
    var phi_15585_: f64;
    var phi_15586_: f64;
    var phi_15587_: f64;
    var phi_15262_: bool;
    var phi_15589_: u32;
    var phi_15590_: f64;
    var phi_15591_: bool;
    var phi_15592_: bool;
    var phi_15593_: bool;
    var phi_15594_: u32;
    var phi_15595_: f64;
    var phi_15596_: f64;
    var phi_15597_: f64;
    var phi_15598_: f64;
    var phi_15599_: bool;
    var phi_15600_: u32;
    var phi_15601_: bool;
    var phi_15602_: bool;
    var phi_15603_: bool;
    var phi_15604_: bool;
    var phi_15605_: bool;
    var phi_15606_: bool;
    var phi_15615_: f64;
    var phi_15620_: f64;
    var phi_15629_: bool;
    var phi_15633_: bool;
    var phi_15634_: f64;
    var phi_15635_: f64;
    var phi_15636_: f64;
    var phi_15637_: f64;
    var phi_15638_: bool;
    var phi_15639_: u32;
    var phi_15640_: bool;
    var phi_15641_: bool;
    var phi_15642_: bool;
    var phi_15643_: bool;
    var phi_15644_: bool;
    var phi_15645_: bool;
    var phi_13424_: f64;
    var phi_13426_: f64;
    var phi_13428_: f64;
    var phi_13430_: f64;
    var phi_13432_: bool;
    var phi_13434_: u32;
    var phi_15646_: f64;
    var phi_15647_: f64;
    var phi_15648_: bool;
    var phi_15649_: bool;
    var phi_15650_: bool;
    var phi_15651_: bool;
    var phi_15652_: bool;
    var phi_15653_: bool;
    var phi_15654_: bool;
    var local_30: bool;
    var phi_15658_: bool;
    var phi_15659_: bool;
    var phi_15660_: bool;
    var phi_15661_: bool;
    var phi_15662_: bool;
    var local_31: f64;
    var phi_15667_: type_43;
    var phi_15668_: bool;
    var phi_15669_: bool;
    var phi_15670_: bool;
    var phi_15671_: bool;
    var phi_15672_: bool;
    var phi_15677_: type_43;
    var phi_15678_: bool;
    var phi_15679_: bool;
    var phi_15680_: bool;
    var phi_15681_: bool;
    var phi_15682_: bool;
    var phi_15686_: f64;
    var phi_15687_: bool;
    var phi_15688_: bool;
    var phi_15689_: bool;
    var phi_15690_: bool;
    var phi_15694_: f64;
    var phi_15695_: bool;
    var phi_15696_: bool;
    var phi_15697_: bool;
    var phi_15702_: type_43;
    var phi_15703_: bool;
    var phi_15704_: bool;
    var phi_15709_: type_43;
    var phi_15710_: bool;
    var phi_15714_: type_43;
    var phi_15721_: bool;
    var phi_15722_: f64;
    var phi_15723_: bool;
    var phi_15724_: bool;
    var phi_15725_: bool;
    var phi_15726_: bool;
    var phi_15727_: f64;
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
    var phi_15742_: bool;
    var phi_15743_: bool;
    var phi_15744_: bool;
    var phi_15745_: type_46;
    var phi_15746_: bool;
    var phi_15747_: f64;
    var phi_15748_: f64;
    var phi_15749_: type_46;
    var phi_15750_: bool;
    var phi_15751_: bool;
    var phi_15752_: bool;
    var phi_15753_: bool;
    var phi_15757_: bool;
    var phi_15758_: bool;
    var phi_15759_: bool;
    var phi_15760_: type_46;
    var phi_15761_: bool;
    var phi_15762_: f64;
    var phi_15763_: f64;
    var phi_15764_: type_46;
    var phi_15765_: bool;
    var phi_15766_: bool;
    var phi_15767_: bool;
    var phi_15768_: bool;
    var local_32: bool;
    var phi_15773_: type_43;
    var phi_15774_: bool;
    var phi_15775_: bool;
    var local_33: bool;
    var local_34: type_46;
    var local_35: f64;
    var local_36: f64;
    var local_37: f64;
    var phi_15789_: type_43;
    var phi_15790_: bool;
    var phi_15791_: type_43;
    var phi_15792_: bool;
    var local_38: f64;
    var phi_15797_: type_43;
    var phi_15798_: type_43;
    var phi_15799_: bool;
    var local_39: type_46;
    var phi_15805_: type_43;
    var phi_15806_: bool;
    var phi_15810_: type_43;
    var phi_15811_: type_43;
    var phi_15812_: bool;
    var phi_15816_: type_43;
    var phi_15817_: type_43;
    var phi_15818_: bool;
    var phi_15822_: type_43;
    var phi_15833_: bool;
    var phi_15834_: bool;
    var phi_15838_: bool;
    var phi_15842_: u32;
    var phi_1531_: type_18;
    var phi_1534_: f64;
    var phi_1555_: bool;
    var phi_1561_: type_19;
    var phi_1532_: type_18;
    var phi_1575_: type_19;
    var phi_1535_: f64;
    var local_40: f64;
    var phi_1524_: f64;
    var phi_1588_: f64;
    var phi_1606_: f64;
    var phi_1613_: f64;
    var phi_1618_: f64;
    var phi_1625_: f64;
    var phi_1630_: f64;
    var phi_1643_: f64;
    var phi_1650_: f64;
    var phi_1655_: f64;
    var phi_1662_: f64;
    var phi_1667_: f64;
    var phi_1672_: f64;
    var phi_1689_: f64;
    var phi_1696_: f64;
    var phi_1701_: f64;
    var phi_1708_: f64;
    var phi_1713_: f64;
    var phi_1727_: f64;
    var phi_1734_: f64;
    var phi_1739_: f64;
    var phi_1746_: f64;
    var phi_1751_: f64;
    var phi_1756_: f64;
    var phi_1773_: f64;
    var phi_1780_: f64;
    var phi_1785_: f64;
    var phi_1792_: f64;
    var phi_1797_: f64;
    var phi_1811_: f64;
    var phi_1818_: f64;
    var phi_1823_: f64;
    var phi_1830_: f64;
    var phi_1835_: f64;
    var phi_1840_: f64;
    var phi_2105_: f64;
    var phi_2112_: f64;
    var phi_2117_: f64;
    var phi_2124_: f64;
    var phi_2129_: f64;
    var phi_2142_: f64;
    var phi_2149_: f64;
    var phi_2154_: f64;
    var phi_2161_: f64;
    var phi_2166_: f64;
    var phi_2171_: f64;
    var phi_2188_: f64;
    var phi_2195_: f64;
    var phi_2200_: f64;
    var phi_2207_: f64;
    var phi_2212_: f64;
    var phi_2226_: f64;
    var phi_2233_: f64;
    var phi_2238_: f64;
    var phi_2245_: f64;
    var phi_2250_: f64;
    var phi_2255_: f64;
    var phi_2272_: f64;
    var phi_2279_: f64;
    var phi_2284_: f64;
    var phi_2291_: f64;
    var phi_2296_: f64;
    var phi_2310_: f64;
    var phi_2317_: f64;
    var phi_2322_: f64;
    var phi_2329_: f64;
    var phi_2334_: f64;
    var phi_2339_: f64;
    var phi_2376_: f64;
    var phi_2382_: f64;
    var phi_2389_: f64;
    var phi_2396_: f64;
    var phi_2402_: f64;
    var phi_2409_: f64;
    var phi_2415_: f64;
    var phi_2421_: f64;
    var phi_2427_: f64;
    var phi_2434_: f64;
    var phi_2441_: f64;
    var phi_2469_: f64;
    var phi_2474_: f64;
    var phi_2479_: f64;
    var phi_2484_: f64;
    var phi_2489_: f64;
    var phi_2494_: f64;
    var phi_2505_: f64;
    var phi_2515_: type_44;
    var phi_2516_: bool;
    var phi_2517_: type_44;
    var phi_2518_: bool;
    var phi_2524_: type_18;
    var phi_2527_: f64;
    var phi_2529_: u32;
    var phi_2531_: f64;
    var phi_2552_: bool;
    var phi_2558_: type_19;
    var phi_2525_: type_18;
    var phi_2572_: type_19;
    var phi_2587_: bool;
    var phi_2588_: bool;
    var phi_2647_: array<f64, 3>;
    var phi_2712_: array<f64, 3>;
    var phi_2734_: f64;
    var phi_2741_: f64;
    var phi_2746_: f64;
    var phi_2753_: f64;
    var phi_2758_: f64;
    var phi_2771_: f64;
    var phi_2778_: f64;
    var phi_2783_: f64;
    var phi_2790_: f64;
    var phi_2795_: f64;
    var phi_2800_: f64;
    var phi_2817_: f64;
    var phi_2824_: f64;
    var phi_2829_: f64;
    var phi_2836_: f64;
    var phi_2841_: f64;
    var phi_2855_: f64;
    var phi_2862_: f64;
    var phi_2867_: f64;
    var phi_2874_: f64;
    var phi_2879_: f64;
    var phi_2884_: f64;
    var phi_2901_: f64;
    var phi_2908_: f64;
    var phi_2913_: f64;
    var phi_2920_: f64;
    var phi_2925_: f64;
    var phi_2939_: f64;
    var phi_2946_: f64;
    var phi_2951_: f64;
    var phi_2958_: f64;
    var phi_2963_: f64;
    var phi_2968_: f64;
    var phi_3015_: type_9;
    var phi_3018_: f64;
    var phi_3020_: f64;
    var phi_3022_: f64;
    var phi_3024_: f64;
    var phi_3026_: bool;
    var phi_3028_: u32;
    var phi_3016_: type_9;
    var phi_3051_: type_9;
    var phi_3166_: f64;
    var phi_3172_: f64;
    var phi_3178_: f64;
    var phi_3180_: array<f64, 3>;
    var phi_3187_: f64;
    var phi_3194_: f64;
    var phi_3202_: f64;
    var phi_3248_: type_18;
    var phi_3251_: f64;
    var phi_3272_: bool;
    var phi_3278_: type_19;
    var phi_3249_: type_18;
    var phi_3292_: type_19;
    var phi_3252_: f64;
    var local_41: f64;
    var phi_3241_: f64;
    var phi_3305_: f64;
    var phi_3374_: f64;
    var phi_3380_: f64;
    var phi_3389_: f64;
    var phi_3395_: f64;
    var phi_3404_: f64;
    var phi_3410_: f64;
    var phi_3419_: f64;
    var phi_3425_: f64;
    var phi_3431_: type_35;
    var phi_3432_: bool;
    var phi_3433_: type_35;
    var phi_3434_: bool;
    var phi_3444_: type_35;
    var phi_3616_: bool;
    var phi_3617_: bool;
    var phi_3618_: bool;
    var phi_3619_: bool;
    var phi_3620_: bool;
    var phi_3621_: bool;
    var phi_3625_: bool;
    var phi_3923_: bool;
    var phi_3924_: bool;
    var phi_3925_: bool;
    var phi_3926_: bool;
    var phi_3927_: bool;
    var phi_3928_: bool;
    var phi_3932_: bool;
    var phi_3936_: bool;
    var phi_3947_: bool;
    var phi_3948_: bool;
    var phi_4022_: bool;
    var phi_4023_: bool;
    var phi_4046_: f64;
    var phi_4047_: bool;
    var phi_4048_: f64;
    var phi_4049_: bool;
    var phi_4050_: f64;
    var phi_4051_: bool;
    var phi_4052_: bool;
    var phi_4057_: f64;
    var phi_4058_: bool;
    var phi_4062_: f64;
    var phi_4094_: bool;
    var phi_4095_: bool;
    var phi_4118_: f64;
    var phi_4119_: bool;
    var phi_4120_: f64;
    var phi_4121_: bool;
    var phi_4122_: f64;
    var phi_4123_: bool;
    var phi_4124_: bool;
    var phi_4129_: f64;
    var phi_4130_: bool;
    var phi_4134_: f64;
    var phi_4139_: f64;
    var phi_4171_: bool;
    var phi_4172_: bool;
    var phi_4195_: f64;
    var phi_4196_: bool;
    var phi_4197_: f64;
    var phi_4198_: bool;
    var phi_4199_: f64;
    var phi_4200_: bool;
    var phi_4201_: bool;
    var phi_4206_: f64;
    var phi_4207_: bool;
    var phi_4211_: f64;
    var phi_4243_: bool;
    var phi_4244_: bool;
    var phi_4267_: f64;
    var phi_4268_: bool;
    var phi_4269_: f64;
    var phi_4270_: bool;
    var phi_4271_: f64;
    var phi_4272_: bool;
    var phi_4273_: bool;
    var phi_4278_: f64;
    var phi_4279_: bool;
    var phi_4283_: f64;
    var phi_4288_: f64;
    var phi_4293_: f64;
    var phi_4298_: f64;
    var phi_4312_: f64;
    var phi_4450_: type_18;
    var phi_4453_: f64;
    var phi_4474_: bool;
    var phi_4480_: type_19;
    var phi_4451_: type_18;
    var phi_4494_: type_19;
    var phi_4454_: f64;
    var local_42: f64;
    var phi_4443_: f64;
    var phi_4507_: f64;
    var phi_4525_: f64;
    var phi_4532_: f64;
    var phi_4537_: f64;
    var phi_4544_: f64;
    var phi_4549_: f64;
    var phi_4562_: f64;
    var phi_4569_: f64;
    var phi_4574_: f64;
    var phi_4581_: f64;
    var phi_4586_: f64;
    var phi_4591_: f64;
    var phi_4608_: f64;
    var phi_4615_: f64;
    var phi_4620_: f64;
    var phi_4627_: f64;
    var phi_4632_: f64;
    var phi_4646_: f64;
    var phi_4653_: f64;
    var phi_4658_: f64;
    var phi_4665_: f64;
    var phi_4670_: f64;
    var phi_4675_: f64;
    var phi_4692_: f64;
    var phi_4699_: f64;
    var phi_4704_: f64;
    var phi_4711_: f64;
    var phi_4716_: f64;
    var phi_4730_: f64;
    var phi_4737_: f64;
    var phi_4742_: f64;
    var phi_4749_: f64;
    var phi_4754_: f64;
    var phi_4759_: f64;
    var phi_4783_: bool;
    var phi_4784_: bool;
    var phi_4785_: bool;
    var phi_4802_: f64;
    var phi_4803_: bool;
    var phi_4804_: f64;
    var phi_4805_: bool;
    var phi_4810_: f64;
    var phi_4812_: f64;
    var phi_4813_: f64;
    var phi_4814_: bool;
    var phi_4815_: f64;
    var phi_4816_: f64;
    var phi_4817_: bool;
    var phi_4818_: bool;
    var phi_4819_: f64;
    var phi_4820_: f64;
    var phi_4821_: f64;
    var phi_4822_: f64;
    var phi_4823_: bool;
    var phi_4824_: bool;
    var phi_4825_: bool;
    var phi_4826_: bool;
    var phi_4827_: f64;
    var phi_4828_: f64;
    var phi_4829_: f64;
    var phi_4830_: f64;
    var phi_4831_: bool;
    var phi_4832_: bool;
    var phi_4833_: bool;
    var phi_4834_: bool;
    var phi_4835_: bool;
    var phi_4836_: f64;
    var phi_4837_: f64;
    var phi_4838_: f64;
    var phi_4839_: f64;
    var phi_4840_: bool;
    var phi_4841_: bool;
    var phi_4842_: bool;
    var phi_4843_: bool;
    var phi_4844_: bool;
    var phi_4930_: f64;
    var phi_5003_: f64;
    var phi_5008_: f64;
    var phi_5081_: f64;
    var phi_5154_: f64;
    var phi_5159_: f64;
    var phi_5180_: f64;
    var phi_5181_: f64;
    var phi_5182_: f64;
    var phi_4857_: bool;
    var phi_5184_: u32;
    var phi_5185_: f64;
    var phi_5186_: bool;
    var phi_5187_: bool;
    var phi_5188_: bool;
    var phi_5189_: u32;
    var phi_5190_: f64;
    var phi_5191_: f64;
    var phi_5192_: f64;
    var phi_5193_: f64;
    var phi_5194_: bool;
    var phi_5195_: u32;
    var phi_5196_: bool;
    var phi_5197_: bool;
    var phi_5198_: bool;
    var phi_5199_: bool;
    var phi_5200_: bool;
    var phi_5201_: bool;
    var phi_5210_: f64;
    var phi_5215_: f64;
    var phi_5224_: bool;
    var phi_5228_: bool;
    var phi_5229_: f64;
    var phi_5230_: f64;
    var phi_5231_: f64;
    var phi_5232_: f64;
    var phi_5233_: bool;
    var phi_5234_: u32;
    var phi_5235_: bool;
    var phi_5236_: bool;
    var phi_5237_: bool;
    var phi_5238_: bool;
    var phi_5239_: bool;
    var phi_5240_: bool;
    var phi_3019_: f64;
    var phi_3021_: f64;
    var phi_3023_: f64;
    var phi_3025_: f64;
    var phi_3027_: bool;
    var phi_3029_: u32;
    var phi_5241_: f64;
    var phi_5242_: f64;
    var phi_5243_: bool;
    var phi_5244_: bool;
    var phi_5245_: bool;
    var phi_5246_: bool;
    var phi_5247_: bool;
    var phi_5248_: bool;
    var phi_5249_: bool;
    var local_43: bool;
    var phi_5253_: bool;
    var phi_5254_: bool;
    var phi_5255_: bool;
    var phi_5256_: bool;
    var phi_5257_: bool;
    var local_44: f64;
    var phi_5262_: type_43;
    var phi_5263_: bool;
    var phi_5264_: bool;
    var phi_5265_: bool;
    var phi_5266_: bool;
    var phi_5267_: bool;
    var phi_5272_: type_43;
    var phi_5273_: bool;
    var phi_5274_: bool;
    var phi_5275_: bool;
    var phi_5276_: bool;
    var phi_5277_: bool;
    var phi_5281_: f64;
    var phi_5282_: bool;
    var phi_5283_: bool;
    var phi_5284_: bool;
    var phi_5285_: bool;
    var phi_5289_: f64;
    var phi_5290_: bool;
    var phi_5291_: bool;
    var phi_5292_: bool;
    var phi_5297_: type_43;
    var phi_5298_: bool;
    var phi_5299_: bool;
    var phi_5304_: type_43;
    var phi_5305_: bool;
    var phi_5309_: type_43;
    var phi_5316_: f64;
    var phi_5317_: bool;
    var phi_5430_: f64;
    var phi_5437_: f64;
    var phi_5445_: f64;
    var phi_5503_: array<f64, 3>;
    var phi_5571_: array<f64, 3>;
    var phi_5596_: f64;
    var phi_5603_: f64;
    var phi_5608_: f64;
    var phi_5615_: f64;
    var phi_5620_: f64;
    var phi_5633_: f64;
    var phi_5640_: f64;
    var phi_5645_: f64;
    var phi_5652_: f64;
    var phi_5657_: f64;
    var phi_5662_: f64;
    var phi_5679_: f64;
    var phi_5686_: f64;
    var phi_5691_: f64;
    var phi_5698_: f64;
    var phi_5703_: f64;
    var phi_5717_: f64;
    var phi_5724_: f64;
    var phi_5729_: f64;
    var phi_5736_: f64;
    var phi_5741_: f64;
    var phi_5746_: f64;
    var phi_5763_: f64;
    var phi_5770_: f64;
    var phi_5775_: f64;
    var phi_5782_: f64;
    var phi_5787_: f64;
    var phi_5801_: f64;
    var phi_5808_: f64;
    var phi_5813_: f64;
    var phi_5820_: f64;
    var phi_5825_: f64;
    var phi_5830_: f64;
    var phi_5942_: type_18;
    var phi_5945_: f64;
    var phi_5966_: bool;
    var phi_5972_: type_19;
    var phi_5943_: type_18;
    var phi_5986_: type_19;
    var phi_5946_: f64;
    var local_45: f64;
    var phi_5935_: f64;
    var phi_5999_: f64;
    var phi_6136_: f64;
    var phi_6142_: f64;
    var phi_6151_: f64;
    var phi_6157_: f64;
    var phi_6166_: f64;
    var phi_6172_: f64;
    var phi_6181_: f64;
    var phi_6187_: f64;
    var phi_6237_: type_18;
    var phi_6240_: f64;
    var phi_6261_: bool;
    var phi_6267_: type_19;
    var phi_6238_: type_18;
    var phi_6281_: type_19;
    var phi_6241_: f64;
    var local_46: f64;
    var phi_6230_: f64;
    var phi_6294_: f64;
    var phi_6326_: type_18;
    var phi_6329_: f64;
    var phi_6350_: bool;
    var phi_6356_: type_19;
    var phi_6327_: type_18;
    var phi_6370_: type_19;
    var phi_6330_: f64;
    var local_47: f64;
    var phi_6319_: f64;
    var phi_6383_: f64;
    var phi_6401_: f64;
    var phi_6408_: f64;
    var phi_6413_: f64;
    var phi_6420_: f64;
    var phi_6425_: f64;
    var phi_6438_: f64;
    var phi_6445_: f64;
    var phi_6450_: f64;
    var phi_6457_: f64;
    var phi_6462_: f64;
    var phi_6467_: f64;
    var phi_6484_: f64;
    var phi_6491_: f64;
    var phi_6496_: f64;
    var phi_6503_: f64;
    var phi_6508_: f64;
    var phi_6522_: f64;
    var phi_6529_: f64;
    var phi_6534_: f64;
    var phi_6541_: f64;
    var phi_6546_: f64;
    var phi_6551_: f64;
    var phi_6568_: f64;
    var phi_6575_: f64;
    var phi_6580_: f64;
    var phi_6587_: f64;
    var phi_6592_: f64;
    var phi_6606_: f64;
    var phi_6613_: f64;
    var phi_6618_: f64;
    var phi_6625_: f64;
    var phi_6630_: f64;
    var phi_6635_: f64;
    var phi_6683_: f64;
    var phi_6689_: f64;
    var phi_6701_: type_9;
    var phi_6704_: f64;
    var phi_6702_: type_9;
    var phi_6727_: type_9;
    var phi_6757_: f64;
    var phi_6763_: f64;
    var phi_6777_: f64;
    var phi_6705_: f64;
    var local_48: f64;
    var local_49: f64;
    var phi_6806_: type_18;
    var phi_6809_: f64;
    var phi_6830_: bool;
    var phi_6836_: type_19;
    var phi_6807_: type_18;
    var phi_6850_: type_19;
    var phi_6810_: f64;
    var local_50: f64;
    var phi_6799_: f64;
    var phi_6863_: f64;
    var phi_6870_: type_9;
    var phi_6873_: f64;
    var phi_6875_: bool;
    var phi_6877_: bool;
    var phi_6871_: type_9;
    var phi_6900_: type_9;
    var phi_6937_: f64;
    var phi_6944_: f64;
    var phi_6952_: f64;
    var phi_6960_: f64;
    var phi_6967_: f64;
    var phi_6975_: f64;
    var phi_6981_: f64;
    var phi_7001_: f64;
    var phi_7007_: f64;
    var phi_7014_: f64;
    var phi_7043_: f64;
    var phi_7049_: f64;
    var phi_7086_: bool;
    var phi_7093_: bool;
    var phi_7106_: f64;
    var phi_7112_: f64;
    var phi_7113_: f64;
    var phi_7114_: f64;
    var phi_6874_: f64;
    var phi_6876_: bool;
    var phi_6878_: bool;
    var local_51: f64;
    var phi_7120_: f64;
    var local_52: bool;
    var local_53: bool;
    var phi_7131_: type_45;
    var phi_7132_: type_45;
    var phi_7133_: bool;
    var local_54: bool;
    var phi_7151_: f64;
    var phi_7152_: f64;
    var phi_7155_: type_9;
    var phi_7158_: f64;
    var phi_7160_: f64;
    var phi_7156_: type_9;
    var phi_7183_: type_9;
    var phi_7269_: f64;
    var phi_7270_: f64;
    var phi_7271_: f64;
    var phi_7252_: f64;
    var phi_7272_: f64;
    var phi_7273_: f64;
    var phi_7159_: f64;
    var phi_7161_: f64;
    var local_55: f64;
    var local_56: f64;
    var local_57: f64;
    var phi_7436_: bool;
    var phi_7437_: bool;
    var phi_7438_: bool;
    var phi_7439_: bool;
    var phi_7440_: bool;
    var phi_7441_: bool;
    var phi_7445_: bool;
    var phi_7449_: bool;
    var phi_7450_: bool;
    var phi_7451_: bool;
    var phi_7456_: f64;
    var phi_7460_: type_45;
    var phi_7461_: type_45;
    var phi_7462_: bool;
    var phi_7463_: type_45;
    var phi_7464_: type_45;
    var phi_7465_: bool;
    var phi_7471_: type_45;
    var phi_7472_: type_45;
    var phi_7473_: bool;
    var phi_7477_: type_45;
    var phi_7478_: type_45;
    var phi_7479_: bool;
    var phi_7480_: bool;
    var phi_7481_: type_45;
    var phi_7482_: type_45;
    var phi_7483_: bool;
    var phi_7484_: bool;
    var phi_7490_: type_45;
    var phi_7491_: bool;
    var phi_7495_: type_45;
    var phi_7511_: f64;
    var phi_7512_: f64;
    var phi_7513_: bool;
    var phi_7514_: f64;
    var phi_7515_: f64;
    var phi_7516_: bool;
    var phi_7517_: bool;
    var phi_7518_: bool;
    var phi_7519_: f64;
    var phi_7520_: f64;
    var phi_7521_: bool;
    var phi_7522_: bool;
    var phi_7523_: bool;
    var phi_7524_: f64;
    var phi_7525_: u32;
    var phi_7526_: f64;
    var phi_7527_: type_45;
    var phi_7528_: u32;
    var phi_7529_: u32;
    var phi_7530_: bool;
    var phi_7531_: bool;
    var phi_7532_: bool;
    var phi_7533_: f64;
    var phi_7534_: u32;
    var phi_7535_: f64;
    var phi_7536_: type_45;
    var phi_7537_: u32;
    var phi_7538_: u32;
    var phi_7539_: bool;
    var phi_7540_: bool;
    var phi_7541_: bool;
    var phi_7542_: bool;
    var phi_7543_: bool;
    var phi_7544_: f64;
    var phi_2528_: f64;
    var phi_2530_: u32;
    var phi_2532_: f64;
    var phi_7545_: type_45;
    var phi_7546_: u32;
    var phi_7547_: f64;
    var phi_7548_: u32;
    var phi_7549_: bool;
    var phi_7550_: bool;
    var phi_7551_: bool;
    var phi_7552_: bool;
    var phi_7553_: bool;
    var phi_7554_: bool;
    var local_58: bool;
    var phi_7558_: bool;
    var phi_7559_: bool;
    var phi_7560_: bool;
    var phi_7561_: bool;
    var local_59: type_45;
    var local_60: type_45;
    var phi_7578_: u32;
    var local_61: type_45;
    var phi_7583_: type_44;
    var phi_7584_: type_44;
    var phi_7585_: bool;
    var phi_7586_: bool;
    var phi_7587_: bool;
    var phi_7588_: bool;
    var phi_7592_: u32;
    var phi_7593_: f64;
    var phi_7594_: bool;
    var phi_7595_: bool;
    var phi_7596_: bool;
    var phi_7597_: bool;
    var phi_7601_: f64;
    var phi_7602_: u32;
    var phi_7603_: bool;
    var phi_7604_: bool;
    var phi_7605_: bool;
    var phi_7619_: f64;
    var phi_7622_: type_9;
    var phi_7623_: type_9;
    var phi_7646_: type_9;
    var phi_7668_: f64;
    var phi_7798_: type_18;
    var phi_7801_: f64;
    var phi_7822_: bool;
    var phi_7828_: type_19;
    var phi_7799_: type_18;
    var phi_7842_: type_19;
    var phi_7802_: f64;
    var local_62: f64;
    var phi_7791_: f64;
    var phi_7855_: f64;
    var phi_7873_: f64;
    var phi_7880_: f64;
    var phi_7885_: f64;
    var phi_7892_: f64;
    var phi_7897_: f64;
    var phi_7910_: f64;
    var phi_7917_: f64;
    var phi_7922_: f64;
    var phi_7929_: f64;
    var phi_7934_: f64;
    var phi_7939_: f64;
    var phi_7956_: f64;
    var phi_7963_: f64;
    var phi_7968_: f64;
    var phi_7975_: f64;
    var phi_7980_: f64;
    var phi_7994_: f64;
    var phi_8001_: f64;
    var phi_8006_: f64;
    var phi_8013_: f64;
    var phi_8018_: f64;
    var phi_8023_: f64;
    var phi_8040_: f64;
    var phi_8047_: f64;
    var phi_8052_: f64;
    var phi_8059_: f64;
    var phi_8064_: f64;
    var phi_8078_: f64;
    var phi_8085_: f64;
    var phi_8090_: f64;
    var phi_8097_: f64;
    var phi_8102_: f64;
    var phi_8107_: f64;
    var phi_8131_: bool;
    var phi_8132_: bool;
    var phi_8133_: bool;
    var local_63: bool;
    var phi_8141_: u32;
    var phi_8145_: type_44;
    var phi_8146_: bool;
    var phi_8154_: u32;
    var phi_8158_: type_44;
    var phi_8159_: type_44;
    var phi_8160_: bool;
    var phi_8161_: bool;
    var phi_8168_: type_44;
    var phi_8169_: bool;
    var phi_8173_: type_44;
    var phi_8174_: type_44;
    var phi_8175_: bool;
    var phi_8179_: type_44;
    var phi_15846_: type_44;
    var phi_15861_: type_47;
    var phi_15885_: u32;
    var phi_15889_: type_24;
    var phi_15890_: bool;
    var phi_15909_: u32;
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
        phi_398_ = _e141;
    } else {
        phi_398_ = _e143;
    }
    let _e146 = phi_398_;
    let _e148 = params.member.member_1.member_1;
    if (_e146 > _e148) {
        let _e151 = params.member.member_1.member_1;
        phi_408_ = (_e146 - _e151);
    } else {
        phi_408_ = 0u;
    }
    let _e154 = phi_408_;
    let _e156 = params.member.member_1.member;
    if (_e156 < _e154) {
        phi_415_ = _e156;
    } else {
        phi_415_ = _e154;
    }
    let _e159 = phi_415_;
    let _e160 = (_e159 / 64u);
    if ((_e159 % 64u) > 0u) {
        phi_431_ = (_e160 + 1u);
    } else {
        phi_431_ = _e160;
    }
    let _e165 = phi_431_;
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
            phi_452_ = (_e169 + 1u);
        } else {
            phi_452_ = _e169;
        }
        let _e175 = phi_452_;
        phi_453_ = _e175;
    } else {
        phi_453_ = 0u;
    }
    let _e177 = phi_453_;
    phi_456_ = type_9(0u, _e177);
    loop {
        let _e180 = phi_456_;
        if (_e180.member < _e180.member_1) {
            phi_457_ = type_9((_e180.member + 1u), _e180.member_1);
            phi_480_ = type_9(1u, _e180.member);
        } else {
            phi_457_ = _e180;
            phi_480_ = type_9(0u, type_9().member_1);
        }
        let _e192 = phi_457_;
        let _e194 = phi_480_;
        let _e198 = (bitcast<i32>(_e194.member) != 0i);
        if _e198 {
            let _e202 = (((_e135 + (_e194.member_1 * _e138)) * 64u) + _e123);
            let _e205 = params.member.member_2.member;
            if (_e202 < _e159) {
                let _e210 = params.member.member_1.member_1;
                let _e212 = (2u * (_e210 + _e202));
                let _e215 = input.member[(4u + _e212)];
                let _e218 = input.member[(_e212 + 5u)];
                if (_e205 == 0u) {
                    let _e235 = (3u * _e218);
                    let _e237 = elements.member[_e235];
                    let _e240 = elements.member[(_e235 + 1u)];
                    let _e243 = elements.member[(_e235 + 2u)];
                    phi_613_ = type_26(0u, array<u32, 4>(_e215, _e237, _e240, _e243));
                } else {
                    let _e221 = (2u * _e215);
                    let _e222 = (2u * _e218);
                    let _e224 = elements.member[_e221];
                    let _e226 = elements.member[_e222];
                    let _e229 = elements.member[(_e221 + 1u)];
                    let _e232 = elements.member[(_e222 + 1u)];
                    phi_613_ = type_26(1u, array<u32, 4>(_e224, _e229, _e226, _e232));
                }
                let _e247 = phi_613_;
                let _e251 = params.member.member.member_1;
                if ((_e251 & 8u) != 0u) {
                    let _e295 = paths.member[_e247.member_1[0]];
                    let _e298 = paths.member[_e247.member_1[1]];
                    let _e305 = paths.member[_e247.member_1[2]];
                    let _e308 = paths.member[_e247.member_1[3]];
                    let _e345 = function_(array<f32, 3>(_e295.member[0], _e295.member[1], _e295.member[2]));
                    let _e346 = function_(array<f32, 3>(_e298.member[0], _e298.member[1], _e298.member[2]));
                    let _e347 = function_(array<f32, 3>(_e305.member[0], _e305.member[1], _e305.member[2]));
                    let _e348 = function_(array<f32, 3>(_e308.member[0], _e308.member[1], _e308.member[2]));
                    let _e350 = function_(array<f32, 3>(_e295.member_1[0], _e295.member_1[1], _e295.member_1[2]));
                    let _e351 = function_(array<f32, 3>(_e298.member_1[0], _e298.member_1[1], _e298.member_1[2]));
                    let _e352 = function_(array<f32, 3>(_e305.member_1[0], _e305.member_1[1], _e305.member_1[2]));
                    let _e353 = function_(array<f32, 3>(_e308.member_1[0], _e308.member_1[1], _e308.member_1[2]));
                    phi_817_ = type_31(array<array<f64, 3>, 4>(_e345, _e346, _e347, _e348), array<array<f64, 3>, 4>(_e350, _e351, _e352, _e353));
                } else {
                    let _e256 = positions.member[_e247.member_1[0]];
                    let _e259 = params.member.member.member[0u];
                    let _e262 = positions.member[(_e259 + _e247.member_1[0])];
                    let _e265 = positions.member[_e247.member_1[1]];
                    let _e268 = params.member.member.member[0u];
                    let _e271 = positions.member[(_e268 + _e247.member_1[1])];
                    let _e274 = positions.member[_e247.member_1[2]];
                    let _e277 = params.member.member.member[0u];
                    let _e280 = positions.member[(_e277 + _e247.member_1[2])];
                    let _e283 = positions.member[_e247.member_1[3]];
                    let _e286 = params.member.member.member[0u];
                    let _e289 = positions.member[(_e286 + _e247.member_1[3])];
                    phi_817_ = type_31(array<array<f64, 3>, 4>(_e256, _e265, _e274, _e283), array<array<f64, 3>, 4>(_e262, _e271, _e280, _e289));
                }
                let _e357 = phi_817_;
                if (_e247.member != 0u) {
                    phi_978_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[2][0] - _e357.member[0][0]), (_e357.member[2][1] - _e357.member[0][1]), (_e357.member[2][2] - _e357.member[0][2])), array<f64, 3>((_e357.member_1[2][0] - _e357.member_1[0][0]), (_e357.member_1[2][1] - _e357.member_1[0][1]), (_e357.member_1[2][2] - _e357.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[1][0] - _e357.member[0][0]), (_e357.member[1][1] - _e357.member[0][1]), (_e357.member[1][2] - _e357.member[0][2])), array<f64, 3>((_e357.member_1[1][0] - _e357.member_1[0][0]), (_e357.member_1[1][1] - _e357.member_1[0][1]), (_e357.member_1[1][2] - _e357.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[2][0] - _e357.member[3][0]), (_e357.member[2][1] - _e357.member[3][1]), (_e357.member[2][2] - _e357.member[3][2])), array<f64, 3>((_e357.member_1[2][0] - _e357.member_1[3][0]), (_e357.member_1[2][1] - _e357.member_1[3][1]), (_e357.member_1[2][2] - _e357.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_978_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[0][0] - _e357.member[1][0]), (_e357.member[0][1] - _e357.member[1][1]), (_e357.member[0][2] - _e357.member[1][2])), array<f64, 3>((_e357.member_1[0][0] - _e357.member_1[1][0]), (_e357.member_1[0][1] - _e357.member_1[1][1]), (_e357.member_1[0][2] - _e357.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[2][0] - _e357.member[1][0]), (_e357.member[2][1] - _e357.member[1][1]), (_e357.member[2][2] - _e357.member[1][2])), array<f64, 3>((_e357.member_1[2][0] - _e357.member_1[1][0]), (_e357.member_1[2][1] - _e357.member_1[1][1]), (_e357.member_1[2][2] - _e357.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e357.member[3][0] - _e357.member[1][0]), (_e357.member[3][1] - _e357.member[1][1]), (_e357.member[3][2] - _e357.member[1][2])), array<f64, 3>((_e357.member_1[3][0] - _e357.member_1[1][0]), (_e357.member_1[3][1] - _e357.member_1[1][1]), (_e357.member_1[3][2] - _e357.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e516 = phi_978_;
                let _e518 = params.member.member.member_7;
                let _e525 = bitcast<f64>(((u64(_e518[1]) * 4294967296lu) + u64(_e518[0])));
                let _e527 = params.member.member.member_14;
                let _e534 = bitcast<f64>(((u64(_e527[1]) * 4294967296lu) + u64(_e527[0])));
                let _e536 = params.member.member.member_15;
                let _e543 = bitcast<f64>(((u64(_e536[1]) * 4294967296lu) + u64(_e536[0])));
                let _e545 = params.member.member.member_16;
                let _e552 = bitcast<f64>(((u64(_e545[1]) * 4294967296lu) + u64(_e545[0])));
                let _e554 = params.member.member.member_1;
                if (_e516.member[0][0] < 0.0lf) {
                    phi_1026_ = -(_e516.member[0][0]);
                } else {
                    phi_1026_ = _e516.member[0][0];
                }
                let _e563 = phi_1026_;
                if (_e516.member[0][1] < 0.0lf) {
                    phi_1033_ = -(_e516.member[0][1]);
                } else {
                    phi_1033_ = _e516.member[0][1];
                }
                let _e568 = phi_1033_;
                if (_e563 > _e568) {
                    phi_1038_ = _e563;
                } else {
                    phi_1038_ = _e568;
                }
                let _e571 = phi_1038_;
                if (_e516.member[0][2] < 0.0lf) {
                    phi_1045_ = -(_e516.member[0][2]);
                } else {
                    phi_1045_ = _e516.member[0][2];
                }
                let _e576 = phi_1045_;
                if (_e571 > _e576) {
                    phi_1050_ = _e571;
                } else {
                    phi_1050_ = _e576;
                }
                let _e579 = phi_1050_;
                if (_e516.member[1][0] < 0.0lf) {
                    phi_1058_ = -(_e516.member[1][0]);
                } else {
                    phi_1058_ = _e516.member[1][0];
                }
                let _e586 = phi_1058_;
                if (_e516.member[1][1] < 0.0lf) {
                    phi_1065_ = -(_e516.member[1][1]);
                } else {
                    phi_1065_ = _e516.member[1][1];
                }
                let _e591 = phi_1065_;
                if (_e586 > _e591) {
                    phi_1070_ = _e586;
                } else {
                    phi_1070_ = _e591;
                }
                let _e594 = phi_1070_;
                if (_e516.member[1][2] < 0.0lf) {
                    phi_1077_ = -(_e516.member[1][2]);
                } else {
                    phi_1077_ = _e516.member[1][2];
                }
                let _e599 = phi_1077_;
                if (_e594 > _e599) {
                    phi_1082_ = _e594;
                } else {
                    phi_1082_ = _e599;
                }
                let _e602 = phi_1082_;
                if (_e579 > _e602) {
                    phi_1087_ = _e579;
                } else {
                    phi_1087_ = _e602;
                }
                let _e605 = phi_1087_;
                let _e607 = (_e605 + _e516.member_3);
                if (_e516.member_1[0][0] < 0.0lf) {
                    phi_1097_ = -(_e516.member_1[0][0]);
                } else {
                    phi_1097_ = _e516.member_1[0][0];
                }
                let _e614 = phi_1097_;
                if (_e516.member_1[0][1] < 0.0lf) {
                    phi_1104_ = -(_e516.member_1[0][1]);
                } else {
                    phi_1104_ = _e516.member_1[0][1];
                }
                let _e619 = phi_1104_;
                if (_e614 > _e619) {
                    phi_1109_ = _e614;
                } else {
                    phi_1109_ = _e619;
                }
                let _e622 = phi_1109_;
                if (_e516.member_1[0][2] < 0.0lf) {
                    phi_1116_ = -(_e516.member_1[0][2]);
                } else {
                    phi_1116_ = _e516.member_1[0][2];
                }
                let _e627 = phi_1116_;
                if (_e622 > _e627) {
                    phi_1121_ = _e622;
                } else {
                    phi_1121_ = _e627;
                }
                let _e630 = phi_1121_;
                if (_e516.member_1[1][0] < 0.0lf) {
                    phi_1129_ = -(_e516.member_1[1][0]);
                } else {
                    phi_1129_ = _e516.member_1[1][0];
                }
                let _e637 = phi_1129_;
                if (_e516.member_1[1][1] < 0.0lf) {
                    phi_1136_ = -(_e516.member_1[1][1]);
                } else {
                    phi_1136_ = _e516.member_1[1][1];
                }
                let _e642 = phi_1136_;
                if (_e637 > _e642) {
                    phi_1141_ = _e637;
                } else {
                    phi_1141_ = _e642;
                }
                let _e645 = phi_1141_;
                if (_e516.member_1[1][2] < 0.0lf) {
                    phi_1148_ = -(_e516.member_1[1][2]);
                } else {
                    phi_1148_ = _e516.member_1[1][2];
                }
                let _e650 = phi_1148_;
                if (_e645 > _e650) {
                    phi_1153_ = _e645;
                } else {
                    phi_1153_ = _e650;
                }
                let _e653 = phi_1153_;
                if (_e630 > _e653) {
                    phi_1158_ = _e630;
                } else {
                    phi_1158_ = _e653;
                }
                let _e656 = phi_1158_;
                let _e658 = (_e656 + _e516.member_3);
                if (_e516.member_2[0][0] < 0.0lf) {
                    phi_1168_ = -(_e516.member_2[0][0]);
                } else {
                    phi_1168_ = _e516.member_2[0][0];
                }
                let _e665 = phi_1168_;
                if (_e516.member_2[0][1] < 0.0lf) {
                    phi_1175_ = -(_e516.member_2[0][1]);
                } else {
                    phi_1175_ = _e516.member_2[0][1];
                }
                let _e670 = phi_1175_;
                if (_e665 > _e670) {
                    phi_1180_ = _e665;
                } else {
                    phi_1180_ = _e670;
                }
                let _e673 = phi_1180_;
                if (_e516.member_2[0][2] < 0.0lf) {
                    phi_1187_ = -(_e516.member_2[0][2]);
                } else {
                    phi_1187_ = _e516.member_2[0][2];
                }
                let _e678 = phi_1187_;
                if (_e673 > _e678) {
                    phi_1192_ = _e673;
                } else {
                    phi_1192_ = _e678;
                }
                let _e681 = phi_1192_;
                if (_e516.member_2[1][0] < 0.0lf) {
                    phi_1200_ = -(_e516.member_2[1][0]);
                } else {
                    phi_1200_ = _e516.member_2[1][0];
                }
                let _e688 = phi_1200_;
                if (_e516.member_2[1][1] < 0.0lf) {
                    phi_1207_ = -(_e516.member_2[1][1]);
                } else {
                    phi_1207_ = _e516.member_2[1][1];
                }
                let _e693 = phi_1207_;
                if (_e688 > _e693) {
                    phi_1212_ = _e688;
                } else {
                    phi_1212_ = _e693;
                }
                let _e696 = phi_1212_;
                if (_e516.member_2[1][2] < 0.0lf) {
                    phi_1219_ = -(_e516.member_2[1][2]);
                } else {
                    phi_1219_ = _e516.member_2[1][2];
                }
                let _e701 = phi_1219_;
                if (_e696 > _e701) {
                    phi_1224_ = _e696;
                } else {
                    phi_1224_ = _e701;
                }
                let _e704 = phi_1224_;
                if (_e681 > _e704) {
                    phi_1229_ = _e681;
                } else {
                    phi_1229_ = _e704;
                }
                let _e707 = phi_1229_;
                let _e709 = (_e707 + _e516.member_3);
                if (_e607 > _e658) {
                    phi_1236_ = _e607;
                } else {
                    phi_1236_ = _e658;
                }
                let _e712 = phi_1236_;
                if (_e712 > _e709) {
                    phi_1241_ = _e712;
                } else {
                    phi_1241_ = _e709;
                }
                let _e715 = phi_1241_;
                if (_e715 <= f64(65536f)) {
                    phi_1250_ = (_e715 >= f64((1f / 65536f)));
                } else {
                    phi_1250_ = false;
                }
                let _e722 = phi_1250_;
                if _e722 {
                    phi_1350_ = type_42();
                    phi_1351_ = true;
                } else {
                    if (_e715 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e715) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e729 = (9214364837600034816lu - (bitcast<u64>(_e715) & 9218868437227405312lu));
                            if (_e729 > 4503599627370496lu) {
                                phi_1274_ = _e729;
                            } else {
                                phi_1274_ = 4503599627370496lu;
                            }
                            let _e732 = phi_1274_;
                            let _e733 = bitcast<f64>(_e732);
                            let _e734 = (_e525 * _e733);
                            if (_e525 > f64(0f)) {
                                if (_e734 > 2.2250738585072014e-308lf) {
                                    phi_1286_ = _e734;
                                } else {
                                    phi_1286_ = 2.2250738585072014e-308lf;
                                }
                                let _e739 = phi_1286_;
                                phi_1287_ = _e739;
                            } else {
                                phi_1287_ = _e734;
                            }
                            let _e741 = phi_1287_;
                            phi_1346_ = type_42(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e516.member[0][0] * _e733), (_e516.member[0][1] * _e733), (_e516.member[0][2] * _e733)), array<f64, 3>((_e516.member[1][0] * _e733), (_e516.member[1][1] * _e733), (_e516.member[1][2] * _e733))), array<array<f64, 3>, 2>(array<f64, 3>((_e516.member_1[0][0] * _e733), (_e516.member_1[0][1] * _e733), (_e516.member_1[0][2] * _e733)), array<f64, 3>((_e516.member_1[1][0] * _e733), (_e516.member_1[1][1] * _e733), (_e516.member_1[1][2] * _e733))), array<array<f64, 3>, 2>(array<f64, 3>((_e516.member_2[0][0] * _e733), (_e516.member_2[0][1] * _e733), (_e516.member_2[0][2] * _e733)), array<f64, 3>((_e516.member_2[1][0] * _e733), (_e516.member_2[1][1] * _e733), (_e516.member_2[1][2] * _e733))), ((_e516.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e733)), _e741);
                            phi_1347_ = false;
                        } else {
                            phi_1346_ = type_42();
                            phi_1347_ = true;
                        }
                        let _e807 = phi_1346_;
                        let _e809 = phi_1347_;
                        phi_1348_ = _e807;
                        phi_1349_ = _e809;
                    } else {
                        phi_1348_ = type_42();
                        phi_1349_ = true;
                    }
                    let _e811 = phi_1348_;
                    let _e813 = phi_1349_;
                    phi_1350_ = _e811;
                    phi_1351_ = _e813;
                }
                let _e815 = phi_1350_;
                let _e817 = phi_1351_;
                if _e817 {
                    phi_1356_ = type_42(_e516, _e525);
                } else {
                    phi_1356_ = _e815;
                }
                let _e820 = phi_1356_;
                local_18 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e820.member.member[0][0], _e820.member.member[0][1], _e820.member.member[0][2]), array<f64, 3>(_e820.member.member[1][0], _e820.member.member[1][1], _e820.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e820.member.member_1[0][0], _e820.member.member_1[0][1], _e820.member.member_1[0][2]), array<f64, 3>(_e820.member.member_1[1][0], _e820.member.member_1[1][1], _e820.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e820.member.member_2[0][0], _e820.member.member_2[0][1], _e820.member.member_2[0][2]), array<f64, 3>(_e820.member.member_2[1][0], _e820.member.member_2[1][1], _e820.member.member_2[1][2])), _e820.member.member_3);
                if (_e820.member_1 > f64(0f)) {
                    let _e6146 = local_18.member[0u];
                    let _e6152 = local_18.member[1u];
                    let _e6168 = local_18.member_1[0u];
                    let _e6174 = local_18.member_1[1u];
                    let _e6190 = local_18.member_2[0u];
                    let _e6196 = local_18.member_2[1u];
                    let _e6210 = function_4(array<f64, 3>((_e6146[0] + ((_e6152[0] - _e6146[0]) * _e543)), (_e6146[1] + ((_e6152[1] - _e6146[1]) * _e543)), (_e6146[2] + ((_e6152[2] - _e6146[2]) * _e543))), array<f64, 3>((_e6168[0] + ((_e6174[0] - _e6168[0]) * _e543)), (_e6168[1] + ((_e6174[1] - _e6168[1]) * _e543)), (_e6168[2] + ((_e6174[2] - _e6168[2]) * _e543))), array<f64, 3>((_e6190[0] + ((_e6196[0] - _e6190[0]) * _e543)), (_e6190[1] + ((_e6196[1] - _e6190[1]) * _e543)), (_e6190[2] + ((_e6196[2] - _e6190[2]) * _e543))), _e247.member);
                    let _e6221 = (((_e6210[0] * _e6210[0]) + (_e6210[1] * _e6210[1])) + (_e6210[2] * _e6210[2]));
                    if (_e6221 <= 2.2250738585072014e-308lf) {
                        if (_e6221 > 0.0lf) {
                            phi_1524_ = (1.464336215552873e-154lf * 2.0lf);
                        } else {
                            phi_1524_ = 0.0lf;
                        }
                        let _e6273 = phi_1524_;
                        phi_1588_ = _e6273;
                    } else {
                        phi_1531_ = type_18(0i, 5i);
                        phi_1534_ = bitcast<f64>(((bitcast<u64>(_e6221) / 2lu) + 2303426169912950784lu));
                        loop {
                            let _e6228 = phi_1531_;
                            let _e6230 = phi_1534_;
                            local_40 = _e6230;
                            if (_e6228.member < _e6228.member_1) {
                                let _e6237 = (_e6228.member + 1i);
                                if ((false == (_e6237 > _e6228.member)) != false) {
                                    phi_1555_ = true;
                                } else {
                                    phi_1555_ = false;
                                }
                                let _e6242 = phi_1555_;
                                if _e6242 {
                                    phi_1561_ = type_19(0u, type_19().member_1);
                                } else {
                                    phi_1561_ = type_19(1u, _e6237);
                                }
                                let _e6247 = phi_1561_;
                                phi_1532_ = type_18(_e6247.member_1, _e6228.member_1);
                                phi_1575_ = type_19(1u, _e6228.member);
                            } else {
                                phi_1532_ = _e6228;
                                phi_1575_ = type_19(0u, type_19().member_1);
                            }
                            let _e6253 = phi_1532_;
                            let _e6255 = phi_1575_;
                            let _e6258 = (bitcast<i32>(_e6255.member) != 0i);
                            if _e6258 {
                                phi_1535_ = (0.5lf * (_e6230 + (_e6221 / _e6230)));
                            } else {
                                phi_1535_ = f64();
                            }
                            let _e6263 = phi_1535_;
                            continue;
                            continuing {
                                phi_1531_ = _e6253;
                                phi_1534_ = _e6263;
                                break if !(_e6258);
                            }
                        }
                        let _e6268 = local_40;
                        phi_1588_ = (_e6268 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                    }
                    let _e6275 = phi_1588_;
                    let _e6283 = local_18.member[0u];
                    if (_e6283[0] < 0.0lf) {
                        phi_1606_ = -(_e6283[0]);
                    } else {
                        phi_1606_ = _e6283[0];
                    }
                    let _e6290 = phi_1606_;
                    if (_e6283[1] < 0.0lf) {
                        phi_1613_ = -(_e6283[1]);
                    } else {
                        phi_1613_ = _e6283[1];
                    }
                    let _e6294 = phi_1613_;
                    if (_e6290 > _e6294) {
                        phi_1618_ = _e6290;
                    } else {
                        phi_1618_ = _e6294;
                    }
                    let _e6297 = phi_1618_;
                    if (_e6283[2] < 0.0lf) {
                        phi_1625_ = -(_e6283[2]);
                    } else {
                        phi_1625_ = _e6283[2];
                    }
                    let _e6301 = phi_1625_;
                    if (_e6297 > _e6301) {
                        phi_1630_ = _e6297;
                    } else {
                        phi_1630_ = _e6301;
                    }
                    let _e6304 = phi_1630_;
                    let _e6307 = local_18.member[1u];
                    if (_e6307[0] < 0.0lf) {
                        phi_1643_ = -(_e6307[0]);
                    } else {
                        phi_1643_ = _e6307[0];
                    }
                    let _e6314 = phi_1643_;
                    if (_e6307[1] < 0.0lf) {
                        phi_1650_ = -(_e6307[1]);
                    } else {
                        phi_1650_ = _e6307[1];
                    }
                    let _e6318 = phi_1650_;
                    if (_e6314 > _e6318) {
                        phi_1655_ = _e6314;
                    } else {
                        phi_1655_ = _e6318;
                    }
                    let _e6321 = phi_1655_;
                    if (_e6307[2] < 0.0lf) {
                        phi_1662_ = -(_e6307[2]);
                    } else {
                        phi_1662_ = _e6307[2];
                    }
                    let _e6325 = phi_1662_;
                    if (_e6321 > _e6325) {
                        phi_1667_ = _e6321;
                    } else {
                        phi_1667_ = _e6325;
                    }
                    let _e6328 = phi_1667_;
                    if (_e6304 > _e6328) {
                        phi_1672_ = _e6304;
                    } else {
                        phi_1672_ = _e6328;
                    }
                    let _e6331 = phi_1672_;
                    let _e6333 = local_18.member_3;
                    let _e6337 = local_18.member_1[0u];
                    if (_e6337[0] < 0.0lf) {
                        phi_1689_ = -(_e6337[0]);
                    } else {
                        phi_1689_ = _e6337[0];
                    }
                    let _e6344 = phi_1689_;
                    if (_e6337[1] < 0.0lf) {
                        phi_1696_ = -(_e6337[1]);
                    } else {
                        phi_1696_ = _e6337[1];
                    }
                    let _e6348 = phi_1696_;
                    if (_e6344 > _e6348) {
                        phi_1701_ = _e6344;
                    } else {
                        phi_1701_ = _e6348;
                    }
                    let _e6351 = phi_1701_;
                    if (_e6337[2] < 0.0lf) {
                        phi_1708_ = -(_e6337[2]);
                    } else {
                        phi_1708_ = _e6337[2];
                    }
                    let _e6355 = phi_1708_;
                    if (_e6351 > _e6355) {
                        phi_1713_ = _e6351;
                    } else {
                        phi_1713_ = _e6355;
                    }
                    let _e6358 = phi_1713_;
                    let _e6361 = local_18.member_1[1u];
                    if (_e6361[0] < 0.0lf) {
                        phi_1727_ = -(_e6361[0]);
                    } else {
                        phi_1727_ = _e6361[0];
                    }
                    let _e6368 = phi_1727_;
                    if (_e6361[1] < 0.0lf) {
                        phi_1734_ = -(_e6361[1]);
                    } else {
                        phi_1734_ = _e6361[1];
                    }
                    let _e6372 = phi_1734_;
                    if (_e6368 > _e6372) {
                        phi_1739_ = _e6368;
                    } else {
                        phi_1739_ = _e6372;
                    }
                    let _e6375 = phi_1739_;
                    if (_e6361[2] < 0.0lf) {
                        phi_1746_ = -(_e6361[2]);
                    } else {
                        phi_1746_ = _e6361[2];
                    }
                    let _e6379 = phi_1746_;
                    if (_e6375 > _e6379) {
                        phi_1751_ = _e6375;
                    } else {
                        phi_1751_ = _e6379;
                    }
                    let _e6382 = phi_1751_;
                    if (_e6358 > _e6382) {
                        phi_1756_ = _e6358;
                    } else {
                        phi_1756_ = _e6382;
                    }
                    let _e6385 = phi_1756_;
                    let _e6387 = local_18.member_3;
                    let _e6391 = local_18.member_2[0u];
                    if (_e6391[0] < 0.0lf) {
                        phi_1773_ = -(_e6391[0]);
                    } else {
                        phi_1773_ = _e6391[0];
                    }
                    let _e6398 = phi_1773_;
                    if (_e6391[1] < 0.0lf) {
                        phi_1780_ = -(_e6391[1]);
                    } else {
                        phi_1780_ = _e6391[1];
                    }
                    let _e6402 = phi_1780_;
                    if (_e6398 > _e6402) {
                        phi_1785_ = _e6398;
                    } else {
                        phi_1785_ = _e6402;
                    }
                    let _e6405 = phi_1785_;
                    if (_e6391[2] < 0.0lf) {
                        phi_1792_ = -(_e6391[2]);
                    } else {
                        phi_1792_ = _e6391[2];
                    }
                    let _e6409 = phi_1792_;
                    if (_e6405 > _e6409) {
                        phi_1797_ = _e6405;
                    } else {
                        phi_1797_ = _e6409;
                    }
                    let _e6412 = phi_1797_;
                    let _e6415 = local_18.member_2[1u];
                    if (_e6415[0] < 0.0lf) {
                        phi_1811_ = -(_e6415[0]);
                    } else {
                        phi_1811_ = _e6415[0];
                    }
                    let _e6422 = phi_1811_;
                    if (_e6415[1] < 0.0lf) {
                        phi_1818_ = -(_e6415[1]);
                    } else {
                        phi_1818_ = _e6415[1];
                    }
                    let _e6426 = phi_1818_;
                    if (_e6422 > _e6426) {
                        phi_1823_ = _e6422;
                    } else {
                        phi_1823_ = _e6426;
                    }
                    let _e6429 = phi_1823_;
                    if (_e6415[2] < 0.0lf) {
                        phi_1830_ = -(_e6415[2]);
                    } else {
                        phi_1830_ = _e6415[2];
                    }
                    let _e6433 = phi_1830_;
                    if (_e6429 > _e6433) {
                        phi_1835_ = _e6429;
                    } else {
                        phi_1835_ = _e6433;
                    }
                    let _e6436 = phi_1835_;
                    if (_e6412 > _e6436) {
                        phi_1840_ = _e6412;
                    } else {
                        phi_1840_ = _e6436;
                    }
                    let _e6439 = phi_1840_;
                    let _e6441 = local_18.member_3;
                    let _e6449 = local_18.member_3;
                    let _e6459 = (((_e6275 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e6331 + _e6333) + (_e6385 + _e6387)) + (_e6439 + _e6441)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6449 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e820.member_1);
                    if _e6459 {
                        phi_2517_ = type_44();
                        phi_2518_ = true;
                    } else {
                        let _e6462 = local_18.member_1[0u];
                        let _e6468 = local_18.member_2[0u];
                        let _e6474 = ((_e6462[1] * _e6468[2]) - (_e6462[2] * _e6468[1]));
                        let _e6477 = ((_e6462[2] * _e6468[0]) - (_e6462[0] * _e6468[2]));
                        let _e6480 = ((_e6462[0] * _e6468[1]) - (_e6462[1] * _e6468[0]));
                        let _e6483 = local_18.member_1[1u];
                        let _e6489 = local_18.member_2[1u];
                        let _e6495 = ((_e6483[1] * _e6489[2]) - (_e6483[2] * _e6489[1]));
                        let _e6498 = ((_e6483[2] * _e6489[0]) - (_e6483[0] * _e6489[2]));
                        let _e6501 = ((_e6483[0] * _e6489[1]) - (_e6483[1] * _e6489[0]));
                        let _e6504 = local_18.member_1[0u];
                        let _e6510 = local_18.member_2[1u];
                        let _e6525 = local_18.member_1[1u];
                        let _e6531 = local_18.member_2[0u];
                        let _e6544 = (((_e6504[1] * _e6510[2]) - (_e6504[2] * _e6510[1])) + ((_e6525[1] * _e6531[2]) - (_e6525[2] * _e6531[1])));
                        let _e6545 = (((_e6504[2] * _e6510[0]) - (_e6504[0] * _e6510[2])) + ((_e6525[2] * _e6531[0]) - (_e6525[0] * _e6531[2])));
                        let _e6546 = (((_e6504[0] * _e6510[1]) - (_e6504[1] * _e6510[0])) + ((_e6525[0] * _e6531[1]) - (_e6525[1] * _e6531[0])));
                        let _e6549 = local_18.member[0u];
                        let _e6560 = local_18.member[1u];
                        let _e6571 = local_18.member[0u];
                        let _e6580 = ((((_e6560[0] * _e6474) + (_e6560[1] * _e6477)) + (_e6560[2] * _e6480)) + (((_e6571[0] * _e6544) + (_e6571[1] * _e6545)) + (_e6571[2] * _e6546)));
                        let _e6583 = local_18.member[0u];
                        let _e6594 = local_18.member[1u];
                        let _e6603 = ((((_e6583[0] * _e6495) + (_e6583[1] * _e6498)) + (_e6583[2] * _e6501)) + (((_e6594[0] * _e6544) + (_e6594[1] * _e6545)) + (_e6594[2] * _e6546)));
                        let _e6606 = local_18.member[1u];
                        let _e6617 = local_18.member[0u];
                        if (_e6617[0] < 0.0lf) {
                            phi_2105_ = -(_e6617[0]);
                        } else {
                            phi_2105_ = _e6617[0];
                        }
                        let _e6624 = phi_2105_;
                        if (_e6617[1] < 0.0lf) {
                            phi_2112_ = -(_e6617[1]);
                        } else {
                            phi_2112_ = _e6617[1];
                        }
                        let _e6628 = phi_2112_;
                        if (_e6624 > _e6628) {
                            phi_2117_ = _e6624;
                        } else {
                            phi_2117_ = _e6628;
                        }
                        let _e6631 = phi_2117_;
                        if (_e6617[2] < 0.0lf) {
                            phi_2124_ = -(_e6617[2]);
                        } else {
                            phi_2124_ = _e6617[2];
                        }
                        let _e6635 = phi_2124_;
                        if (_e6631 > _e6635) {
                            phi_2129_ = _e6631;
                        } else {
                            phi_2129_ = _e6635;
                        }
                        let _e6638 = phi_2129_;
                        let _e6641 = local_18.member[1u];
                        if (_e6641[0] < 0.0lf) {
                            phi_2142_ = -(_e6641[0]);
                        } else {
                            phi_2142_ = _e6641[0];
                        }
                        let _e6648 = phi_2142_;
                        if (_e6641[1] < 0.0lf) {
                            phi_2149_ = -(_e6641[1]);
                        } else {
                            phi_2149_ = _e6641[1];
                        }
                        let _e6652 = phi_2149_;
                        if (_e6648 > _e6652) {
                            phi_2154_ = _e6648;
                        } else {
                            phi_2154_ = _e6652;
                        }
                        let _e6655 = phi_2154_;
                        if (_e6641[2] < 0.0lf) {
                            phi_2161_ = -(_e6641[2]);
                        } else {
                            phi_2161_ = _e6641[2];
                        }
                        let _e6659 = phi_2161_;
                        if (_e6655 > _e6659) {
                            phi_2166_ = _e6655;
                        } else {
                            phi_2166_ = _e6659;
                        }
                        let _e6662 = phi_2166_;
                        if (_e6638 > _e6662) {
                            phi_2171_ = _e6638;
                        } else {
                            phi_2171_ = _e6662;
                        }
                        let _e6665 = phi_2171_;
                        let _e6667 = local_18.member_3;
                        let _e6668 = (_e6665 + _e6667);
                        let _e6671 = local_18.member_1[0u];
                        if (_e6671[0] < 0.0lf) {
                            phi_2188_ = -(_e6671[0]);
                        } else {
                            phi_2188_ = _e6671[0];
                        }
                        let _e6678 = phi_2188_;
                        if (_e6671[1] < 0.0lf) {
                            phi_2195_ = -(_e6671[1]);
                        } else {
                            phi_2195_ = _e6671[1];
                        }
                        let _e6682 = phi_2195_;
                        if (_e6678 > _e6682) {
                            phi_2200_ = _e6678;
                        } else {
                            phi_2200_ = _e6682;
                        }
                        let _e6685 = phi_2200_;
                        if (_e6671[2] < 0.0lf) {
                            phi_2207_ = -(_e6671[2]);
                        } else {
                            phi_2207_ = _e6671[2];
                        }
                        let _e6689 = phi_2207_;
                        if (_e6685 > _e6689) {
                            phi_2212_ = _e6685;
                        } else {
                            phi_2212_ = _e6689;
                        }
                        let _e6692 = phi_2212_;
                        let _e6695 = local_18.member_1[1u];
                        if (_e6695[0] < 0.0lf) {
                            phi_2226_ = -(_e6695[0]);
                        } else {
                            phi_2226_ = _e6695[0];
                        }
                        let _e6702 = phi_2226_;
                        if (_e6695[1] < 0.0lf) {
                            phi_2233_ = -(_e6695[1]);
                        } else {
                            phi_2233_ = _e6695[1];
                        }
                        let _e6706 = phi_2233_;
                        if (_e6702 > _e6706) {
                            phi_2238_ = _e6702;
                        } else {
                            phi_2238_ = _e6706;
                        }
                        let _e6709 = phi_2238_;
                        if (_e6695[2] < 0.0lf) {
                            phi_2245_ = -(_e6695[2]);
                        } else {
                            phi_2245_ = _e6695[2];
                        }
                        let _e6713 = phi_2245_;
                        if (_e6709 > _e6713) {
                            phi_2250_ = _e6709;
                        } else {
                            phi_2250_ = _e6713;
                        }
                        let _e6716 = phi_2250_;
                        if (_e6692 > _e6716) {
                            phi_2255_ = _e6692;
                        } else {
                            phi_2255_ = _e6716;
                        }
                        let _e6719 = phi_2255_;
                        let _e6721 = local_18.member_3;
                        let _e6722 = (_e6719 + _e6721);
                        let _e6725 = local_18.member_2[0u];
                        if (_e6725[0] < 0.0lf) {
                            phi_2272_ = -(_e6725[0]);
                        } else {
                            phi_2272_ = _e6725[0];
                        }
                        let _e6732 = phi_2272_;
                        if (_e6725[1] < 0.0lf) {
                            phi_2279_ = -(_e6725[1]);
                        } else {
                            phi_2279_ = _e6725[1];
                        }
                        let _e6736 = phi_2279_;
                        if (_e6732 > _e6736) {
                            phi_2284_ = _e6732;
                        } else {
                            phi_2284_ = _e6736;
                        }
                        let _e6739 = phi_2284_;
                        if (_e6725[2] < 0.0lf) {
                            phi_2291_ = -(_e6725[2]);
                        } else {
                            phi_2291_ = _e6725[2];
                        }
                        let _e6743 = phi_2291_;
                        if (_e6739 > _e6743) {
                            phi_2296_ = _e6739;
                        } else {
                            phi_2296_ = _e6743;
                        }
                        let _e6746 = phi_2296_;
                        let _e6749 = local_18.member_2[1u];
                        if (_e6749[0] < 0.0lf) {
                            phi_2310_ = -(_e6749[0]);
                        } else {
                            phi_2310_ = _e6749[0];
                        }
                        let _e6756 = phi_2310_;
                        if (_e6749[1] < 0.0lf) {
                            phi_2317_ = -(_e6749[1]);
                        } else {
                            phi_2317_ = _e6749[1];
                        }
                        let _e6760 = phi_2317_;
                        if (_e6756 > _e6760) {
                            phi_2322_ = _e6756;
                        } else {
                            phi_2322_ = _e6760;
                        }
                        let _e6763 = phi_2322_;
                        if (_e6749[2] < 0.0lf) {
                            phi_2329_ = -(_e6749[2]);
                        } else {
                            phi_2329_ = _e6749[2];
                        }
                        let _e6767 = phi_2329_;
                        if (_e6763 > _e6767) {
                            phi_2334_ = _e6763;
                        } else {
                            phi_2334_ = _e6767;
                        }
                        let _e6770 = phi_2334_;
                        if (_e6746 > _e6770) {
                            phi_2339_ = _e6746;
                        } else {
                            phi_2339_ = _e6770;
                        }
                        let _e6773 = phi_2339_;
                        let _e6775 = local_18.member_3;
                        let _e6776 = (_e6773 + _e6775);
                        let _e6777 = f64(1f);
                        let _e6778 = f64(8f);
                        let _e6780 = ((_e6722 * _e6778) * _e6776);
                        let _e6788 = local_18.member_3;
                        if (_e6474 < 0.0lf) {
                            phi_2376_ = -(_e6474);
                        } else {
                            phi_2376_ = _e6474;
                        }
                        let _e6808 = phi_2376_;
                        if (_e6477 < 0.0lf) {
                            phi_2382_ = -(_e6477);
                        } else {
                            phi_2382_ = _e6477;
                        }
                        let _e6812 = phi_2382_;
                        if (_e6480 < 0.0lf) {
                            phi_2389_ = -(_e6480);
                        } else {
                            phi_2389_ = _e6480;
                        }
                        let _e6817 = phi_2389_;
                        let _e6818 = ((_e6808 + _e6812) + _e6817);
                        if (_e6495 < 0.0lf) {
                            phi_2396_ = -(_e6495);
                        } else {
                            phi_2396_ = _e6495;
                        }
                        let _e6822 = phi_2396_;
                        if (_e6498 < 0.0lf) {
                            phi_2402_ = -(_e6498);
                        } else {
                            phi_2402_ = _e6498;
                        }
                        let _e6826 = phi_2402_;
                        if (_e6501 < 0.0lf) {
                            phi_2409_ = -(_e6501);
                        } else {
                            phi_2409_ = _e6501;
                        }
                        let _e6831 = phi_2409_;
                        let _e6832 = ((_e6822 + _e6826) + _e6831);
                        if (_e6818 > _e6832) {
                            phi_2415_ = _e6818;
                        } else {
                            phi_2415_ = _e6832;
                        }
                        let _e6835 = phi_2415_;
                        if (_e6544 < 0.0lf) {
                            phi_2421_ = -(_e6544);
                        } else {
                            phi_2421_ = _e6544;
                        }
                        let _e6839 = phi_2421_;
                        if (_e6545 < 0.0lf) {
                            phi_2427_ = -(_e6545);
                        } else {
                            phi_2427_ = _e6545;
                        }
                        let _e6843 = phi_2427_;
                        if (_e6546 < 0.0lf) {
                            phi_2434_ = -(_e6546);
                        } else {
                            phi_2434_ = _e6546;
                        }
                        let _e6848 = phi_2434_;
                        let _e6850 = (((_e6839 + _e6843) + _e6848) * f64(0.5f));
                        if (_e6835 > _e6850) {
                            phi_2441_ = _e6835;
                        } else {
                            phi_2441_ = _e6850;
                        }
                        let _e6853 = phi_2441_;
                        let _e6859 = local_18.member_3;
                        let _e6874 = f64(3f);
                        let _e6875 = ((((_e6549[0] * _e6474) + (_e6549[1] * _e6477)) + (_e6549[2] * _e6480)) * _e6874);
                        let _e6876 = ((((_e6606[0] * _e6495) + (_e6606[1] * _e6498)) + (_e6606[2] * _e6501)) * _e6874);
                        if (_e6875 < _e6876) {
                            phi_2469_ = _e6875;
                        } else {
                            phi_2469_ = _e6876;
                        }
                        let _e6879 = phi_2469_;
                        if (_e6580 < _e6603) {
                            phi_2474_ = _e6580;
                        } else {
                            phi_2474_ = _e6603;
                        }
                        let _e6882 = phi_2474_;
                        if (_e6879 < _e6882) {
                            phi_2479_ = _e6879;
                        } else {
                            phi_2479_ = _e6882;
                        }
                        let _e6885 = phi_2479_;
                        if (_e6875 > _e6876) {
                            phi_2484_ = _e6875;
                        } else {
                            phi_2484_ = _e6876;
                        }
                        let _e6888 = phi_2484_;
                        if (_e6580 > _e6603) {
                            phi_2489_ = _e6580;
                        } else {
                            phi_2489_ = _e6603;
                        }
                        let _e6891 = phi_2489_;
                        if (_e6888 > _e6891) {
                            phi_2494_ = _e6888;
                        } else {
                            phi_2494_ = _e6891;
                        }
                        let _e6894 = phi_2494_;
                        let _e6900 = -(_e6894);
                        if (_e6885 > _e6900) {
                            phi_2505_ = _e6885;
                        } else {
                            phi_2505_ = _e6900;
                        }
                        let _e6903 = phi_2505_;
                        if ((_e6903 - ((((((_e6668 * _e6778) * _e6780) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e6788 * f64(19f)) * ((_e6668 * (_e6722 + _e6776)) + (_e6722 * _e6776)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6777 + _e6668) * ((_e6777 + _e6722) * (_e6777 + _e6776))))) + ((_e820.member_1 * (((_e6853 + (_e6780 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e6859 * f64(6f)) * (_e6722 + _e6776))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6777 + _e6722) * (_e6777 + _e6776))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                            phi_2515_ = type_44(type_43(0u, f64()), 0u);
                            phi_2516_ = false;
                        } else {
                            phi_2515_ = type_44();
                            phi_2516_ = true;
                        }
                        let _e6910 = phi_2515_;
                        let _e6912 = phi_2516_;
                        phi_2517_ = _e6910;
                        phi_2518_ = _e6912;
                    }
                    let _e6914 = phi_2517_;
                    let _e6916 = phi_2518_;
                    if _e6916 {
                        phi_2524_ = type_18(0i, 2i);
                        phi_2527_ = _e543;
                        phi_2529_ = 0u;
                        phi_2531_ = _e543;
                        loop {
                            let _e6918 = phi_2524_;
                            let _e6920 = phi_2527_;
                            let _e6922 = phi_2529_;
                            let _e6924 = phi_2531_;
                            local_99 = _e6922;
                            local_102 = _e6920;
                            local_103 = _e6922;
                            if (_e6918.member < _e6918.member_1) {
                                let _e6931 = (_e6918.member + 1i);
                                if ((false == (_e6931 > _e6918.member)) != false) {
                                    phi_2552_ = true;
                                } else {
                                    phi_2552_ = false;
                                }
                                let _e6936 = phi_2552_;
                                if _e6936 {
                                    phi_2558_ = type_19(0u, type_19().member_1);
                                } else {
                                    phi_2558_ = type_19(1u, _e6931);
                                }
                                let _e6941 = phi_2558_;
                                phi_2525_ = type_18(_e6941.member_1, _e6918.member_1);
                                phi_2572_ = type_19(1u, _e6918.member);
                            } else {
                                phi_2525_ = _e6918;
                                phi_2572_ = type_19(0u, type_19().member_1);
                            }
                            let _e6947 = phi_2525_;
                            let _e6949 = phi_2572_;
                            if (bitcast<i32>(_e6949.member) != 0i) {
                                if (_e6949.member_1 > 0i) {
                                    phi_2588_ = true;
                                } else {
                                    if _e6459 {
                                        phi_2587_ = false;
                                    } else {
                                        phi_2587_ = true;
                                    }
                                    let _e6956 = phi_2587_;
                                    phi_2588_ = _e6956;
                                }
                                let _e6958 = phi_2588_;
                                if _e6958 {
                                    let _e6961 = local_18.member[0u];
                                    let _e6968 = local_18.member_1[0u];
                                    let _e6974 = local_18.member_2[0u];
                                    let _e6978 = (_e6961[0] - _e6968[0]);
                                    let _e6979 = (_e6961[1] - _e6968[1]);
                                    let _e6980 = (_e6961[2] - _e6968[2]);
                                    if (_e247.member == 0u) {
                                        phi_2647_ = array<f64, 3>(_e6961[0], _e6961[1], _e6961[2]);
                                    } else {
                                        phi_2647_ = array<f64, 3>((_e6978 - _e6974[0]), (_e6979 - _e6974[1]), (_e6980 - _e6974[2]));
                                    }
                                    let _e6987 = phi_2647_;
                                    let _e6993 = local_18.member[1u];
                                    let _e7000 = local_18.member_1[1u];
                                    let _e7006 = local_18.member_2[1u];
                                    let _e7010 = (_e6993[0] - _e7000[0]);
                                    let _e7011 = (_e6993[1] - _e7000[1]);
                                    let _e7012 = (_e6993[2] - _e7000[2]);
                                    if (_e247.member == 0u) {
                                        phi_2712_ = array<f64, 3>(_e6993[0], _e6993[1], _e6993[2]);
                                    } else {
                                        phi_2712_ = array<f64, 3>((_e7010 - _e7006[0]), (_e7011 - _e7006[1]), (_e7012 - _e7006[2]));
                                    }
                                    let _e7019 = phi_2712_;
                                    let _e7025 = local_18.member[0u];
                                    if (_e7025[0] < 0.0lf) {
                                        phi_2734_ = -(_e7025[0]);
                                    } else {
                                        phi_2734_ = _e7025[0];
                                    }
                                    let _e7032 = phi_2734_;
                                    if (_e7025[1] < 0.0lf) {
                                        phi_2741_ = -(_e7025[1]);
                                    } else {
                                        phi_2741_ = _e7025[1];
                                    }
                                    let _e7036 = phi_2741_;
                                    if (_e7032 > _e7036) {
                                        phi_2746_ = _e7032;
                                    } else {
                                        phi_2746_ = _e7036;
                                    }
                                    let _e7039 = phi_2746_;
                                    if (_e7025[2] < 0.0lf) {
                                        phi_2753_ = -(_e7025[2]);
                                    } else {
                                        phi_2753_ = _e7025[2];
                                    }
                                    let _e7043 = phi_2753_;
                                    if (_e7039 > _e7043) {
                                        phi_2758_ = _e7039;
                                    } else {
                                        phi_2758_ = _e7043;
                                    }
                                    let _e7046 = phi_2758_;
                                    let _e7049 = local_18.member[1u];
                                    if (_e7049[0] < 0.0lf) {
                                        phi_2771_ = -(_e7049[0]);
                                    } else {
                                        phi_2771_ = _e7049[0];
                                    }
                                    let _e7056 = phi_2771_;
                                    if (_e7049[1] < 0.0lf) {
                                        phi_2778_ = -(_e7049[1]);
                                    } else {
                                        phi_2778_ = _e7049[1];
                                    }
                                    let _e7060 = phi_2778_;
                                    if (_e7056 > _e7060) {
                                        phi_2783_ = _e7056;
                                    } else {
                                        phi_2783_ = _e7060;
                                    }
                                    let _e7063 = phi_2783_;
                                    if (_e7049[2] < 0.0lf) {
                                        phi_2790_ = -(_e7049[2]);
                                    } else {
                                        phi_2790_ = _e7049[2];
                                    }
                                    let _e7067 = phi_2790_;
                                    if (_e7063 > _e7067) {
                                        phi_2795_ = _e7063;
                                    } else {
                                        phi_2795_ = _e7067;
                                    }
                                    let _e7070 = phi_2795_;
                                    if (_e7046 > _e7070) {
                                        phi_2800_ = _e7046;
                                    } else {
                                        phi_2800_ = _e7070;
                                    }
                                    let _e7073 = phi_2800_;
                                    let _e7075 = local_18.member_3;
                                    let _e7079 = local_18.member_1[0u];
                                    if (_e7079[0] < 0.0lf) {
                                        phi_2817_ = -(_e7079[0]);
                                    } else {
                                        phi_2817_ = _e7079[0];
                                    }
                                    let _e7086 = phi_2817_;
                                    if (_e7079[1] < 0.0lf) {
                                        phi_2824_ = -(_e7079[1]);
                                    } else {
                                        phi_2824_ = _e7079[1];
                                    }
                                    let _e7090 = phi_2824_;
                                    if (_e7086 > _e7090) {
                                        phi_2829_ = _e7086;
                                    } else {
                                        phi_2829_ = _e7090;
                                    }
                                    let _e7093 = phi_2829_;
                                    if (_e7079[2] < 0.0lf) {
                                        phi_2836_ = -(_e7079[2]);
                                    } else {
                                        phi_2836_ = _e7079[2];
                                    }
                                    let _e7097 = phi_2836_;
                                    if (_e7093 > _e7097) {
                                        phi_2841_ = _e7093;
                                    } else {
                                        phi_2841_ = _e7097;
                                    }
                                    let _e7100 = phi_2841_;
                                    let _e7103 = local_18.member_1[1u];
                                    if (_e7103[0] < 0.0lf) {
                                        phi_2855_ = -(_e7103[0]);
                                    } else {
                                        phi_2855_ = _e7103[0];
                                    }
                                    let _e7110 = phi_2855_;
                                    if (_e7103[1] < 0.0lf) {
                                        phi_2862_ = -(_e7103[1]);
                                    } else {
                                        phi_2862_ = _e7103[1];
                                    }
                                    let _e7114 = phi_2862_;
                                    if (_e7110 > _e7114) {
                                        phi_2867_ = _e7110;
                                    } else {
                                        phi_2867_ = _e7114;
                                    }
                                    let _e7117 = phi_2867_;
                                    if (_e7103[2] < 0.0lf) {
                                        phi_2874_ = -(_e7103[2]);
                                    } else {
                                        phi_2874_ = _e7103[2];
                                    }
                                    let _e7121 = phi_2874_;
                                    if (_e7117 > _e7121) {
                                        phi_2879_ = _e7117;
                                    } else {
                                        phi_2879_ = _e7121;
                                    }
                                    let _e7124 = phi_2879_;
                                    if (_e7100 > _e7124) {
                                        phi_2884_ = _e7100;
                                    } else {
                                        phi_2884_ = _e7124;
                                    }
                                    let _e7127 = phi_2884_;
                                    let _e7129 = local_18.member_3;
                                    let _e7133 = local_18.member_2[0u];
                                    if (_e7133[0] < 0.0lf) {
                                        phi_2901_ = -(_e7133[0]);
                                    } else {
                                        phi_2901_ = _e7133[0];
                                    }
                                    let _e7140 = phi_2901_;
                                    if (_e7133[1] < 0.0lf) {
                                        phi_2908_ = -(_e7133[1]);
                                    } else {
                                        phi_2908_ = _e7133[1];
                                    }
                                    let _e7144 = phi_2908_;
                                    if (_e7140 > _e7144) {
                                        phi_2913_ = _e7140;
                                    } else {
                                        phi_2913_ = _e7144;
                                    }
                                    let _e7147 = phi_2913_;
                                    if (_e7133[2] < 0.0lf) {
                                        phi_2920_ = -(_e7133[2]);
                                    } else {
                                        phi_2920_ = _e7133[2];
                                    }
                                    let _e7151 = phi_2920_;
                                    if (_e7147 > _e7151) {
                                        phi_2925_ = _e7147;
                                    } else {
                                        phi_2925_ = _e7151;
                                    }
                                    let _e7154 = phi_2925_;
                                    let _e7157 = local_18.member_2[1u];
                                    if (_e7157[0] < 0.0lf) {
                                        phi_2939_ = -(_e7157[0]);
                                    } else {
                                        phi_2939_ = _e7157[0];
                                    }
                                    let _e7164 = phi_2939_;
                                    if (_e7157[1] < 0.0lf) {
                                        phi_2946_ = -(_e7157[1]);
                                    } else {
                                        phi_2946_ = _e7157[1];
                                    }
                                    let _e7168 = phi_2946_;
                                    if (_e7164 > _e7168) {
                                        phi_2951_ = _e7164;
                                    } else {
                                        phi_2951_ = _e7168;
                                    }
                                    let _e7171 = phi_2951_;
                                    if (_e7157[2] < 0.0lf) {
                                        phi_2958_ = -(_e7157[2]);
                                    } else {
                                        phi_2958_ = _e7157[2];
                                    }
                                    let _e7175 = phi_2958_;
                                    if (_e7171 > _e7175) {
                                        phi_2963_ = _e7171;
                                    } else {
                                        phi_2963_ = _e7175;
                                    }
                                    let _e7178 = phi_2963_;
                                    if (_e7154 > _e7178) {
                                        phi_2968_ = _e7154;
                                    } else {
                                        phi_2968_ = _e7178;
                                    }
                                    let _e7181 = phi_2968_;
                                    let _e7183 = local_18.member_3;
                                    let _e7191 = local_18.member_3;
                                    let _e7199 = (_e534 * f64(0.00390625f));
                                    let _e7200 = f64(0f);
                                    let _e7201 = f64(1f);
                                    local_16 = type_35(array<f64, 4>(_e7200, _e7200, _e7200, _e7200), array<f64, 4>(_e7200, _e7200, _e7200, _e7200), array<f64, 4>(_e7201, _e7201, _e7201, _e7201));
                                    phi_3015_ = type_9(0u, 96u);
                                    phi_3018_ = _e6924;
                                    phi_3020_ = _e6924;
                                    phi_3022_ = (_e552 - _e6924);
                                    phi_3024_ = _e6924;
                                    phi_3026_ = false;
                                    phi_3028_ = 0u;
                                    loop {
                                        let _e7208 = phi_3015_;
                                        let _e7210 = phi_3018_;
                                        let _e7212 = phi_3020_;
                                        let _e7214 = phi_3022_;
                                        let _e7216 = phi_3024_;
                                        let _e7218 = phi_3026_;
                                        let _e7220 = phi_3028_;
                                        local_44 = _e7210;
                                        local_89 = _e7212;
                                        if (_e7208.member < _e7208.member_1) {
                                            phi_3016_ = type_9((_e7208.member + 1u), _e7208.member_1);
                                            phi_3051_ = type_9(1u, _e7208.member);
                                        } else {
                                            phi_3016_ = _e7208;
                                            phi_3051_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e7232 = phi_3016_;
                                        let _e7234 = phi_3051_;
                                        if (bitcast<i32>(_e7234.member) != 0i) {
                                            let _e7240 = local_18.member[0u];
                                            let _e7246 = local_18.member[1u];
                                            let _e7262 = local_18.member_1[0u];
                                            let _e7268 = local_18.member_1[1u];
                                            let _e7284 = local_18.member_2[0u];
                                            let _e7290 = local_18.member_2[1u];
                                            let _e7304 = function_4(array<f64, 3>((_e7240[0] + ((_e7246[0] - _e7240[0]) * _e7210)), (_e7240[1] + ((_e7246[1] - _e7240[1]) * _e7210)), (_e7240[2] + ((_e7246[2] - _e7240[2]) * _e7210))), array<f64, 3>((_e7262[0] + ((_e7268[0] - _e7262[0]) * _e7210)), (_e7262[1] + ((_e7268[1] - _e7262[1]) * _e7210)), (_e7262[2] + ((_e7268[2] - _e7262[2]) * _e7210))), array<f64, 3>((_e7284[0] + ((_e7290[0] - _e7284[0]) * _e7210)), (_e7284[1] + ((_e7290[1] - _e7284[1]) * _e7210)), (_e7284[2] + ((_e7290[2] - _e7284[2]) * _e7210))), _e247.member);
                                            if (_e7220 == 0u) {
                                                phi_3180_ = _e7304;
                                            } else {
                                                let _e7306 = f64(0f);
                                                if (_e7220 == 1u) {
                                                    phi_3166_ = _e7304[0];
                                                } else {
                                                    phi_3166_ = _e7306;
                                                }
                                                let _e7310 = phi_3166_;
                                                if (_e7220 == 2u) {
                                                    phi_3172_ = _e7304[1];
                                                } else {
                                                    phi_3172_ = _e7306;
                                                }
                                                let _e7314 = phi_3172_;
                                                if (_e7220 == 3u) {
                                                    phi_3178_ = _e7304[2];
                                                } else {
                                                    phi_3178_ = _e7306;
                                                }
                                                let _e7318 = phi_3178_;
                                                phi_3180_ = array<f64, 3>(_e7310, _e7314, _e7318);
                                            }
                                            let _e7321 = phi_3180_;
                                            if (_e7321[0] < 0.0lf) {
                                                phi_3187_ = -(_e7321[0]);
                                            } else {
                                                phi_3187_ = _e7321[0];
                                            }
                                            let _e7326 = phi_3187_;
                                            if (_e7321[1] < 0.0lf) {
                                                phi_3194_ = -(_e7321[1]);
                                            } else {
                                                phi_3194_ = _e7321[1];
                                            }
                                            let _e7331 = phi_3194_;
                                            if (_e7321[2] < 0.0lf) {
                                                phi_3202_ = -(_e7321[2]);
                                            } else {
                                                phi_3202_ = _e7321[2];
                                            }
                                            let _e7337 = phi_3202_;
                                            let _e7338 = ((_e7326 + _e7331) + _e7337);
                                            if (_e7338 > f64(0f)) {
                                                if ((bitcast<u64>(_e7338) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                    let _e7345 = (f64(1f) / _e7338);
                                                    let _e7347 = (_e7321[0] * _e7345);
                                                    let _e7349 = (_e7321[1] * _e7345);
                                                    let _e7351 = (_e7321[2] * _e7345);
                                                    let _e7356 = (((_e7347 * _e7347) + (_e7349 * _e7349)) + (_e7351 * _e7351));
                                                    if (_e7356 <= 2.2250738585072014e-308lf) {
                                                        if (_e7356 > 0.0lf) {
                                                            phi_3241_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_3241_ = 0.0lf;
                                                        }
                                                        let _e7408 = phi_3241_;
                                                        phi_3305_ = _e7408;
                                                    } else {
                                                        phi_3248_ = type_18(0i, 5i);
                                                        phi_3251_ = bitcast<f64>(((bitcast<u64>(_e7356) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e7363 = phi_3248_;
                                                            let _e7365 = phi_3251_;
                                                            local_41 = _e7365;
                                                            if (_e7363.member < _e7363.member_1) {
                                                                let _e7372 = (_e7363.member + 1i);
                                                                if ((false == (_e7372 > _e7363.member)) != false) {
                                                                    phi_3272_ = true;
                                                                } else {
                                                                    phi_3272_ = false;
                                                                }
                                                                let _e7377 = phi_3272_;
                                                                if _e7377 {
                                                                    phi_3278_ = type_19(0u, type_19().member_1);
                                                                } else {
                                                                    phi_3278_ = type_19(1u, _e7372);
                                                                }
                                                                let _e7382 = phi_3278_;
                                                                phi_3249_ = type_18(_e7382.member_1, _e7363.member_1);
                                                                phi_3292_ = type_19(1u, _e7363.member);
                                                            } else {
                                                                phi_3249_ = _e7363;
                                                                phi_3292_ = type_19(0u, type_19().member_1);
                                                            }
                                                            let _e7388 = phi_3249_;
                                                            let _e7390 = phi_3292_;
                                                            let _e7393 = (bitcast<i32>(_e7390.member) != 0i);
                                                            if _e7393 {
                                                                phi_3252_ = (0.5lf * (_e7365 + (_e7356 / _e7365)));
                                                            } else {
                                                                phi_3252_ = f64();
                                                            }
                                                            let _e7398 = phi_3252_;
                                                            continue;
                                                            continuing {
                                                                phi_3248_ = _e7388;
                                                                phi_3251_ = _e7398;
                                                                break if !(_e7393);
                                                            }
                                                        }
                                                        let _e7403 = local_41;
                                                        phi_3305_ = (_e7403 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e7410 = phi_3305_;
                                                    let _e7412 = (1.1102230246251565e-16lf * f64(12f));
                                                    let _e7419 = ((((((((_e7073 + _e7075) + (_e7127 + _e7129)) + (_e7181 + _e7183)) * (1.1102230246251565e-16lf * f64(16f))) + (_e7191 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e820.member_1 * _e7410) * (f64(1f) + _e7412)));
                                                    let _e7424 = (((_e7347 * _e6961[0]) + (_e7349 * _e6961[1])) + (_e7351 * _e6961[2]));
                                                    let _e7429 = (((_e7347 * _e6978) + (_e7349 * _e6979)) + (_e7351 * _e6980));
                                                    let _e7434 = (((_e7347 * (_e6961[0] - _e6974[0])) + (_e7349 * (_e6961[1] - _e6974[1]))) + (_e7351 * (_e6961[2] - _e6974[2])));
                                                    let _e7442 = (((_e7347 * _e6987[0]) + (_e7349 * _e6987[1])) + (_e7351 * _e6987[2]));
                                                    let _e7448 = (((_e7347 * _e6993[0]) + (_e7349 * _e6993[1])) + (_e7351 * _e6993[2]));
                                                    let _e7453 = (((_e7347 * _e7010) + (_e7349 * _e7011)) + (_e7351 * _e7012));
                                                    let _e7458 = (((_e7347 * (_e6993[0] - _e7006[0])) + (_e7349 * (_e6993[1] - _e7006[1]))) + (_e7351 * (_e6993[2] - _e7006[2])));
                                                    let _e7466 = (((_e7347 * _e7019[0]) + (_e7349 * _e7019[1])) + (_e7351 * _e7019[2]));
                                                    if (_e7424 < 0.0lf) {
                                                        phi_3374_ = -(_e7424);
                                                    } else {
                                                        phi_3374_ = _e7424;
                                                    }
                                                    let _e7471 = phi_3374_;
                                                    if (_e7448 < 0.0lf) {
                                                        phi_3380_ = -(_e7448);
                                                    } else {
                                                        phi_3380_ = _e7448;
                                                    }
                                                    let _e7475 = phi_3380_;
                                                    if (_e7429 < 0.0lf) {
                                                        phi_3389_ = -(_e7429);
                                                    } else {
                                                        phi_3389_ = _e7429;
                                                    }
                                                    let _e7482 = phi_3389_;
                                                    if (_e7453 < 0.0lf) {
                                                        phi_3395_ = -(_e7453);
                                                    } else {
                                                        phi_3395_ = _e7453;
                                                    }
                                                    let _e7486 = phi_3395_;
                                                    if (_e7434 < 0.0lf) {
                                                        phi_3404_ = -(_e7434);
                                                    } else {
                                                        phi_3404_ = _e7434;
                                                    }
                                                    let _e7493 = phi_3404_;
                                                    if (_e7458 < 0.0lf) {
                                                        phi_3410_ = -(_e7458);
                                                    } else {
                                                        phi_3410_ = _e7458;
                                                    }
                                                    let _e7497 = phi_3410_;
                                                    if (_e7442 < 0.0lf) {
                                                        phi_3419_ = -(_e7442);
                                                    } else {
                                                        phi_3419_ = _e7442;
                                                    }
                                                    let _e7504 = phi_3419_;
                                                    if (_e7466 < 0.0lf) {
                                                        phi_3425_ = -(_e7466);
                                                    } else {
                                                        phi_3425_ = _e7466;
                                                    }
                                                    let _e7508 = phi_3425_;
                                                    phi_3431_ = type_35(array<f64, 4>(_e7424, _e7429, _e7434, _e7442), array<f64, 4>(_e7448, _e7453, _e7458, _e7466), array<f64, 4>((_e7419 + ((_e7471 + _e7475) * _e7412)), (_e7419 + ((_e7482 + _e7486) * _e7412)), (_e7419 + ((_e7493 + _e7497) * _e7412)), (_e7419 + ((_e7504 + _e7508) * _e7412))));
                                                    phi_3432_ = false;
                                                } else {
                                                    phi_3431_ = type_35();
                                                    phi_3432_ = true;
                                                }
                                                let _e7515 = phi_3431_;
                                                let _e7517 = phi_3432_;
                                                phi_3433_ = _e7515;
                                                phi_3434_ = _e7517;
                                            } else {
                                                phi_3433_ = type_35();
                                                phi_3434_ = true;
                                            }
                                            let _e7519 = phi_3433_;
                                            let _e7521 = phi_3434_;
                                            if _e7521 {
                                                let _e7522 = f64(0f);
                                                let _e7523 = f64(1f);
                                                phi_3444_ = type_35(array<f64, 4>(_e7522, _e7522, _e7522, _e7522), array<f64, 4>(_e7522, _e7522, _e7522, _e7522), array<f64, 4>(_e7523, _e7523, _e7523, _e7523));
                                            } else {
                                                phi_3444_ = _e7519;
                                            }
                                            let _e7529 = phi_3444_;
                                            local_17 = type_35(array<f64, 4>(_e7529.member[0], _e7529.member[1], _e7529.member[2], _e7529.member[3]), array<f64, 4>(_e7529.member_1[0], _e7529.member_1[1], _e7529.member_1[2], _e7529.member_1[3]), array<f64, 4>(_e7529.member_2[0], _e7529.member_2[1], _e7529.member_2[2], _e7529.member_2[3]));
                                            let _e7549 = (_e7210 - _e7216);
                                            let _e7551 = f64(0f);
                                            let _e7554 = local_17.member[0u];
                                            let _e7557 = local_17.member_1[0u];
                                            let _e7560 = local_17.member[0u];
                                            let _e7566 = local_17.member_2[0u];
                                            if (((_e7554 + ((_e7557 - _e7560) * _e7210)) - _e7566) > _e7551) {
                                                let _e7571 = local_17.member[1u];
                                                let _e7574 = local_17.member_1[1u];
                                                let _e7577 = local_17.member[1u];
                                                let _e7583 = local_17.member_2[1u];
                                                if (((_e7571 + ((_e7574 - _e7577) * _e7210)) - _e7583) > _e7551) {
                                                    let _e7588 = local_17.member[2u];
                                                    let _e7591 = local_17.member_1[2u];
                                                    let _e7594 = local_17.member[2u];
                                                    let _e7600 = local_17.member_2[2u];
                                                    if (((_e7588 + ((_e7591 - _e7594) * _e7210)) - _e7600) > _e7551) {
                                                        let _e7605 = local_17.member[3u];
                                                        let _e7608 = local_17.member_1[3u];
                                                        let _e7611 = local_17.member[3u];
                                                        let _e7617 = local_17.member_2[3u];
                                                        phi_3616_ = (((_e7605 + ((_e7608 - _e7611) * _e7210)) - _e7617) > _e7551);
                                                        phi_3617_ = false;
                                                    } else {
                                                        phi_3616_ = bool();
                                                        phi_3617_ = true;
                                                    }
                                                    let _e7621 = phi_3616_;
                                                    let _e7623 = phi_3617_;
                                                    phi_3618_ = _e7621;
                                                    phi_3619_ = _e7623;
                                                } else {
                                                    phi_3618_ = bool();
                                                    phi_3619_ = true;
                                                }
                                                let _e7625 = phi_3618_;
                                                let _e7627 = phi_3619_;
                                                phi_3620_ = _e7625;
                                                phi_3621_ = _e7627;
                                            } else {
                                                phi_3620_ = bool();
                                                phi_3621_ = true;
                                            }
                                            let _e7629 = phi_3620_;
                                            let _e7631 = phi_3621_;
                                            if _e7631 {
                                                phi_3625_ = false;
                                            } else {
                                                phi_3625_ = _e7629;
                                            }
                                            let _e7633 = phi_3625_;
                                            if _e7633 {
                                                if (_e7210 <= _e7212) {
                                                    phi_3936_ = true;
                                                } else {
                                                    let _e7635 = f64(0f);
                                                    let _e7638 = local_16.member[0u];
                                                    let _e7641 = local_16.member_1[0u];
                                                    let _e7644 = local_16.member[0u];
                                                    let _e7650 = local_16.member_2[0u];
                                                    let _e7654 = local_17.member[0u];
                                                    let _e7657 = local_17.member_1[0u];
                                                    let _e7660 = local_17.member[0u];
                                                    let _e7666 = local_17.member_2[0u];
                                                    if ((((_e7638 + ((_e7641 - _e7644) * _e7210)) - _e7650) + ((_e7654 + ((_e7657 - _e7660) * _e7216)) - _e7666)) > _e7635) {
                                                        let _e7672 = local_16.member[1u];
                                                        let _e7675 = local_16.member_1[1u];
                                                        let _e7678 = local_16.member[1u];
                                                        let _e7684 = local_16.member_2[1u];
                                                        let _e7688 = local_17.member[1u];
                                                        let _e7691 = local_17.member_1[1u];
                                                        let _e7694 = local_17.member[1u];
                                                        let _e7700 = local_17.member_2[1u];
                                                        if ((((_e7672 + ((_e7675 - _e7678) * _e7210)) - _e7684) + ((_e7688 + ((_e7691 - _e7694) * _e7216)) - _e7700)) > _e7635) {
                                                            let _e7706 = local_16.member[2u];
                                                            let _e7709 = local_16.member_1[2u];
                                                            let _e7712 = local_16.member[2u];
                                                            let _e7718 = local_16.member_2[2u];
                                                            let _e7722 = local_17.member[2u];
                                                            let _e7725 = local_17.member_1[2u];
                                                            let _e7728 = local_17.member[2u];
                                                            let _e7734 = local_17.member_2[2u];
                                                            if ((((_e7706 + ((_e7709 - _e7712) * _e7210)) - _e7718) + ((_e7722 + ((_e7725 - _e7728) * _e7216)) - _e7734)) > _e7635) {
                                                                let _e7740 = local_16.member[3u];
                                                                let _e7743 = local_16.member_1[3u];
                                                                let _e7746 = local_16.member[3u];
                                                                let _e7752 = local_16.member_2[3u];
                                                                let _e7756 = local_17.member[3u];
                                                                let _e7759 = local_17.member_1[3u];
                                                                let _e7762 = local_17.member[3u];
                                                                let _e7768 = local_17.member_2[3u];
                                                                phi_3923_ = ((((_e7740 + ((_e7743 - _e7746) * _e7210)) - _e7752) + ((_e7756 + ((_e7759 - _e7762) * _e7216)) - _e7768)) > _e7635);
                                                                phi_3924_ = false;
                                                            } else {
                                                                phi_3923_ = bool();
                                                                phi_3924_ = true;
                                                            }
                                                            let _e7773 = phi_3923_;
                                                            let _e7775 = phi_3924_;
                                                            phi_3925_ = _e7773;
                                                            phi_3926_ = _e7775;
                                                        } else {
                                                            phi_3925_ = bool();
                                                            phi_3926_ = true;
                                                        }
                                                        let _e7777 = phi_3925_;
                                                        let _e7779 = phi_3926_;
                                                        phi_3927_ = _e7777;
                                                        phi_3928_ = _e7779;
                                                    } else {
                                                        phi_3927_ = bool();
                                                        phi_3928_ = true;
                                                    }
                                                    let _e7781 = phi_3927_;
                                                    let _e7783 = phi_3928_;
                                                    if _e7783 {
                                                        phi_3932_ = false;
                                                    } else {
                                                        phi_3932_ = _e7781;
                                                    }
                                                    let _e7785 = phi_3932_;
                                                    phi_3936_ = _e7785;
                                                }
                                                let _e7787 = phi_3936_;
                                                if _e7787 {
                                                    if _e7218 {
                                                        if (_e7210 >= _e552) {
                                                            phi_3947_ = false;
                                                        } else {
                                                            phi_3947_ = true;
                                                        }
                                                        let _e7790 = phi_3947_;
                                                        phi_3948_ = _e7790;
                                                    } else {
                                                        phi_3948_ = true;
                                                    }
                                                    let _e7792 = phi_3948_;
                                                    if _e7792 {
                                                        local_16 = type_35(array<f64, 4>(_e7529.member[0], _e7529.member[1], _e7529.member[2], _e7529.member[3]), array<f64, 4>(_e7529.member_1[0], _e7529.member_1[1], _e7529.member_1[2], _e7529.member_1[3]), array<f64, 4>(_e7529.member_2[0], _e7529.member_2[1], _e7529.member_2[2], _e7529.member_2[3]));
                                                        let _e7814 = local_16.member[0u];
                                                        let _e7817 = local_16.member_1[0u];
                                                        let _e7820 = local_16.member_2[0u];
                                                        if (_e7814 > _e7820) {
                                                            if (_e7817 > _e7820) {
                                                                phi_4022_ = false;
                                                            } else {
                                                                phi_4022_ = true;
                                                            }
                                                            let _e7824 = phi_4022_;
                                                            phi_4023_ = _e7824;
                                                        } else {
                                                            phi_4023_ = true;
                                                        }
                                                        let _e7826 = phi_4023_;
                                                        if _e7826 {
                                                            let _e7827 = (_e7817 >= _e7814);
                                                            if _e7827 {
                                                                phi_4048_ = f64();
                                                                phi_4049_ = false;
                                                            } else {
                                                                if ((_e7814 - _e7817) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4046_ = (((_e7814 - _e7820) / (_e7814 - _e7817)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4047_ = false;
                                                                } else {
                                                                    phi_4046_ = f64();
                                                                    phi_4047_ = true;
                                                                }
                                                                let _e7841 = phi_4046_;
                                                                let _e7843 = phi_4047_;
                                                                phi_4048_ = _e7841;
                                                                phi_4049_ = _e7843;
                                                            }
                                                            let _e7845 = phi_4048_;
                                                            let _e7847 = phi_4049_;
                                                            phi_4050_ = _e7845;
                                                            phi_4051_ = _e7827;
                                                            phi_4052_ = _e7847;
                                                        } else {
                                                            phi_4050_ = f64();
                                                            phi_4051_ = true;
                                                            phi_4052_ = false;
                                                        }
                                                        let _e7849 = phi_4050_;
                                                        let _e7851 = phi_4051_;
                                                        let _e7853 = phi_4052_;
                                                        if _e7851 {
                                                            phi_4057_ = f64(2f);
                                                            phi_4058_ = true;
                                                        } else {
                                                            phi_4057_ = _e7210;
                                                            phi_4058_ = _e7853;
                                                        }
                                                        let _e7856 = phi_4057_;
                                                        let _e7858 = phi_4058_;
                                                        if _e7858 {
                                                            phi_4062_ = _e7856;
                                                        } else {
                                                            phi_4062_ = _e7849;
                                                        }
                                                        let _e7860 = phi_4062_;
                                                        let _e7863 = local_16.member[1u];
                                                        let _e7866 = local_16.member_1[1u];
                                                        let _e7869 = local_16.member_2[1u];
                                                        if (_e7863 > _e7869) {
                                                            if (_e7866 > _e7869) {
                                                                phi_4094_ = false;
                                                            } else {
                                                                phi_4094_ = true;
                                                            }
                                                            let _e7873 = phi_4094_;
                                                            phi_4095_ = _e7873;
                                                        } else {
                                                            phi_4095_ = true;
                                                        }
                                                        let _e7875 = phi_4095_;
                                                        if _e7875 {
                                                            let _e7876 = (_e7866 >= _e7863);
                                                            if _e7876 {
                                                                phi_4120_ = f64();
                                                                phi_4121_ = false;
                                                            } else {
                                                                if ((_e7863 - _e7866) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4118_ = (((_e7863 - _e7869) / (_e7863 - _e7866)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4119_ = false;
                                                                } else {
                                                                    phi_4118_ = f64();
                                                                    phi_4119_ = true;
                                                                }
                                                                let _e7890 = phi_4118_;
                                                                let _e7892 = phi_4119_;
                                                                phi_4120_ = _e7890;
                                                                phi_4121_ = _e7892;
                                                            }
                                                            let _e7894 = phi_4120_;
                                                            let _e7896 = phi_4121_;
                                                            phi_4122_ = _e7894;
                                                            phi_4123_ = _e7876;
                                                            phi_4124_ = _e7896;
                                                        } else {
                                                            phi_4122_ = f64();
                                                            phi_4123_ = true;
                                                            phi_4124_ = false;
                                                        }
                                                        let _e7898 = phi_4122_;
                                                        let _e7900 = phi_4123_;
                                                        let _e7902 = phi_4124_;
                                                        if _e7900 {
                                                            phi_4129_ = f64(2f);
                                                            phi_4130_ = true;
                                                        } else {
                                                            phi_4129_ = _e7210;
                                                            phi_4130_ = _e7902;
                                                        }
                                                        let _e7905 = phi_4129_;
                                                        let _e7907 = phi_4130_;
                                                        if _e7907 {
                                                            phi_4134_ = _e7905;
                                                        } else {
                                                            phi_4134_ = _e7898;
                                                        }
                                                        let _e7909 = phi_4134_;
                                                        if (_e7860 < _e7909) {
                                                            phi_4139_ = _e7860;
                                                        } else {
                                                            phi_4139_ = _e7909;
                                                        }
                                                        let _e7912 = phi_4139_;
                                                        let _e7915 = local_16.member[2u];
                                                        let _e7918 = local_16.member_1[2u];
                                                        let _e7921 = local_16.member_2[2u];
                                                        if (_e7915 > _e7921) {
                                                            if (_e7918 > _e7921) {
                                                                phi_4171_ = false;
                                                            } else {
                                                                phi_4171_ = true;
                                                            }
                                                            let _e7925 = phi_4171_;
                                                            phi_4172_ = _e7925;
                                                        } else {
                                                            phi_4172_ = true;
                                                        }
                                                        let _e7927 = phi_4172_;
                                                        if _e7927 {
                                                            let _e7928 = (_e7918 >= _e7915);
                                                            if _e7928 {
                                                                phi_4197_ = f64();
                                                                phi_4198_ = false;
                                                            } else {
                                                                if ((_e7915 - _e7918) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4195_ = (((_e7915 - _e7921) / (_e7915 - _e7918)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4196_ = false;
                                                                } else {
                                                                    phi_4195_ = f64();
                                                                    phi_4196_ = true;
                                                                }
                                                                let _e7942 = phi_4195_;
                                                                let _e7944 = phi_4196_;
                                                                phi_4197_ = _e7942;
                                                                phi_4198_ = _e7944;
                                                            }
                                                            let _e7946 = phi_4197_;
                                                            let _e7948 = phi_4198_;
                                                            phi_4199_ = _e7946;
                                                            phi_4200_ = _e7928;
                                                            phi_4201_ = _e7948;
                                                        } else {
                                                            phi_4199_ = f64();
                                                            phi_4200_ = true;
                                                            phi_4201_ = false;
                                                        }
                                                        let _e7950 = phi_4199_;
                                                        let _e7952 = phi_4200_;
                                                        let _e7954 = phi_4201_;
                                                        if _e7952 {
                                                            phi_4206_ = f64(2f);
                                                            phi_4207_ = true;
                                                        } else {
                                                            phi_4206_ = _e7210;
                                                            phi_4207_ = _e7954;
                                                        }
                                                        let _e7957 = phi_4206_;
                                                        let _e7959 = phi_4207_;
                                                        if _e7959 {
                                                            phi_4211_ = _e7957;
                                                        } else {
                                                            phi_4211_ = _e7950;
                                                        }
                                                        let _e7961 = phi_4211_;
                                                        let _e7964 = local_16.member[3u];
                                                        let _e7967 = local_16.member_1[3u];
                                                        let _e7970 = local_16.member_2[3u];
                                                        if (_e7964 > _e7970) {
                                                            if (_e7967 > _e7970) {
                                                                phi_4243_ = false;
                                                            } else {
                                                                phi_4243_ = true;
                                                            }
                                                            let _e7974 = phi_4243_;
                                                            phi_4244_ = _e7974;
                                                        } else {
                                                            phi_4244_ = true;
                                                        }
                                                        let _e7976 = phi_4244_;
                                                        if _e7976 {
                                                            let _e7977 = (_e7967 >= _e7964);
                                                            if _e7977 {
                                                                phi_4269_ = f64();
                                                                phi_4270_ = false;
                                                            } else {
                                                                if ((_e7964 - _e7967) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4267_ = (((_e7964 - _e7970) / (_e7964 - _e7967)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4268_ = false;
                                                                } else {
                                                                    phi_4267_ = f64();
                                                                    phi_4268_ = true;
                                                                }
                                                                let _e7991 = phi_4267_;
                                                                let _e7993 = phi_4268_;
                                                                phi_4269_ = _e7991;
                                                                phi_4270_ = _e7993;
                                                            }
                                                            let _e7995 = phi_4269_;
                                                            let _e7997 = phi_4270_;
                                                            phi_4271_ = _e7995;
                                                            phi_4272_ = _e7977;
                                                            phi_4273_ = _e7997;
                                                        } else {
                                                            phi_4271_ = f64();
                                                            phi_4272_ = true;
                                                            phi_4273_ = false;
                                                        }
                                                        let _e7999 = phi_4271_;
                                                        let _e8001 = phi_4272_;
                                                        let _e8003 = phi_4273_;
                                                        if _e8001 {
                                                            phi_4278_ = f64(2f);
                                                            phi_4279_ = true;
                                                        } else {
                                                            phi_4278_ = _e7210;
                                                            phi_4279_ = _e8003;
                                                        }
                                                        let _e8006 = phi_4278_;
                                                        let _e8008 = phi_4279_;
                                                        if _e8008 {
                                                            phi_4283_ = _e8006;
                                                        } else {
                                                            phi_4283_ = _e7999;
                                                        }
                                                        let _e8010 = phi_4283_;
                                                        if (_e7961 < _e8010) {
                                                            phi_4288_ = _e7961;
                                                        } else {
                                                            phi_4288_ = _e8010;
                                                        }
                                                        let _e8013 = phi_4288_;
                                                        if (_e7912 < _e8013) {
                                                            phi_4293_ = _e7912;
                                                        } else {
                                                            phi_4293_ = _e8013;
                                                        }
                                                        let _e8016 = phi_4293_;
                                                        if (_e8016 > _e7210) {
                                                            phi_4298_ = _e8016;
                                                        } else {
                                                            phi_4298_ = _e7210;
                                                        }
                                                        let _e8019 = phi_4298_;
                                                        let _e8020 = (_e8019 > _e552);
                                                        if _e8020 {
                                                            phi_4815_ = f64();
                                                            phi_4816_ = f64();
                                                            phi_4817_ = false;
                                                            phi_4818_ = false;
                                                        } else {
                                                            let _e8021 = (_e8019 - _e7210);
                                                            let _e8022 = (_e8021 <= _e7199);
                                                            let _e8025 = (_e8019 + (_e534 * f64(0.01f)));
                                                            if (_e8025 < _e552) {
                                                                phi_4312_ = _e8025;
                                                            } else {
                                                                phi_4312_ = _e552;
                                                            }
                                                            let _e8028 = phi_4312_;
                                                            if _e8022 {
                                                                if (_e820.member_1 > f64(0f)) {
                                                                    let _e8033 = local_18.member[0u];
                                                                    let _e8039 = local_18.member[1u];
                                                                    let _e8055 = local_18.member_1[0u];
                                                                    let _e8061 = local_18.member_1[1u];
                                                                    let _e8077 = local_18.member_2[0u];
                                                                    let _e8083 = local_18.member_2[1u];
                                                                    let _e8097 = function_4(array<f64, 3>((_e8033[0] + ((_e8039[0] - _e8033[0]) * _e8028)), (_e8033[1] + ((_e8039[1] - _e8033[1]) * _e8028)), (_e8033[2] + ((_e8039[2] - _e8033[2]) * _e8028))), array<f64, 3>((_e8055[0] + ((_e8061[0] - _e8055[0]) * _e8028)), (_e8055[1] + ((_e8061[1] - _e8055[1]) * _e8028)), (_e8055[2] + ((_e8061[2] - _e8055[2]) * _e8028))), array<f64, 3>((_e8077[0] + ((_e8083[0] - _e8077[0]) * _e8028)), (_e8077[1] + ((_e8083[1] - _e8077[1]) * _e8028)), (_e8077[2] + ((_e8083[2] - _e8077[2]) * _e8028))), _e247.member);
                                                                    let _e8108 = (((_e8097[0] * _e8097[0]) + (_e8097[1] * _e8097[1])) + (_e8097[2] * _e8097[2]));
                                                                    if (_e8108 <= 2.2250738585072014e-308lf) {
                                                                        if (_e8108 > 0.0lf) {
                                                                            phi_4443_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_4443_ = 0.0lf;
                                                                        }
                                                                        let _e8160 = phi_4443_;
                                                                        phi_4507_ = _e8160;
                                                                    } else {
                                                                        phi_4450_ = type_18(0i, 5i);
                                                                        phi_4453_ = bitcast<f64>(((bitcast<u64>(_e8108) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e8115 = phi_4450_;
                                                                            let _e8117 = phi_4453_;
                                                                            local_42 = _e8117;
                                                                            if (_e8115.member < _e8115.member_1) {
                                                                                let _e8124 = (_e8115.member + 1i);
                                                                                if ((false == (_e8124 > _e8115.member)) != false) {
                                                                                    phi_4474_ = true;
                                                                                } else {
                                                                                    phi_4474_ = false;
                                                                                }
                                                                                let _e8129 = phi_4474_;
                                                                                if _e8129 {
                                                                                    phi_4480_ = type_19(0u, type_19().member_1);
                                                                                } else {
                                                                                    phi_4480_ = type_19(1u, _e8124);
                                                                                }
                                                                                let _e8134 = phi_4480_;
                                                                                phi_4451_ = type_18(_e8134.member_1, _e8115.member_1);
                                                                                phi_4494_ = type_19(1u, _e8115.member);
                                                                            } else {
                                                                                phi_4451_ = _e8115;
                                                                                phi_4494_ = type_19(0u, type_19().member_1);
                                                                            }
                                                                            let _e8140 = phi_4451_;
                                                                            let _e8142 = phi_4494_;
                                                                            let _e8145 = (bitcast<i32>(_e8142.member) != 0i);
                                                                            if _e8145 {
                                                                                phi_4454_ = (0.5lf * (_e8117 + (_e8108 / _e8117)));
                                                                            } else {
                                                                                phi_4454_ = f64();
                                                                            }
                                                                            let _e8150 = phi_4454_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4450_ = _e8140;
                                                                                phi_4453_ = _e8150;
                                                                                break if !(_e8145);
                                                                            }
                                                                        }
                                                                        let _e8155 = local_42;
                                                                        phi_4507_ = (_e8155 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e8162 = phi_4507_;
                                                                    let _e8170 = local_18.member[0u];
                                                                    if (_e8170[0] < 0.0lf) {
                                                                        phi_4525_ = -(_e8170[0]);
                                                                    } else {
                                                                        phi_4525_ = _e8170[0];
                                                                    }
                                                                    let _e8177 = phi_4525_;
                                                                    if (_e8170[1] < 0.0lf) {
                                                                        phi_4532_ = -(_e8170[1]);
                                                                    } else {
                                                                        phi_4532_ = _e8170[1];
                                                                    }
                                                                    let _e8181 = phi_4532_;
                                                                    if (_e8177 > _e8181) {
                                                                        phi_4537_ = _e8177;
                                                                    } else {
                                                                        phi_4537_ = _e8181;
                                                                    }
                                                                    let _e8184 = phi_4537_;
                                                                    if (_e8170[2] < 0.0lf) {
                                                                        phi_4544_ = -(_e8170[2]);
                                                                    } else {
                                                                        phi_4544_ = _e8170[2];
                                                                    }
                                                                    let _e8188 = phi_4544_;
                                                                    if (_e8184 > _e8188) {
                                                                        phi_4549_ = _e8184;
                                                                    } else {
                                                                        phi_4549_ = _e8188;
                                                                    }
                                                                    let _e8191 = phi_4549_;
                                                                    let _e8194 = local_18.member[1u];
                                                                    if (_e8194[0] < 0.0lf) {
                                                                        phi_4562_ = -(_e8194[0]);
                                                                    } else {
                                                                        phi_4562_ = _e8194[0];
                                                                    }
                                                                    let _e8201 = phi_4562_;
                                                                    if (_e8194[1] < 0.0lf) {
                                                                        phi_4569_ = -(_e8194[1]);
                                                                    } else {
                                                                        phi_4569_ = _e8194[1];
                                                                    }
                                                                    let _e8205 = phi_4569_;
                                                                    if (_e8201 > _e8205) {
                                                                        phi_4574_ = _e8201;
                                                                    } else {
                                                                        phi_4574_ = _e8205;
                                                                    }
                                                                    let _e8208 = phi_4574_;
                                                                    if (_e8194[2] < 0.0lf) {
                                                                        phi_4581_ = -(_e8194[2]);
                                                                    } else {
                                                                        phi_4581_ = _e8194[2];
                                                                    }
                                                                    let _e8212 = phi_4581_;
                                                                    if (_e8208 > _e8212) {
                                                                        phi_4586_ = _e8208;
                                                                    } else {
                                                                        phi_4586_ = _e8212;
                                                                    }
                                                                    let _e8215 = phi_4586_;
                                                                    if (_e8191 > _e8215) {
                                                                        phi_4591_ = _e8191;
                                                                    } else {
                                                                        phi_4591_ = _e8215;
                                                                    }
                                                                    let _e8218 = phi_4591_;
                                                                    let _e8220 = local_18.member_3;
                                                                    let _e8224 = local_18.member_1[0u];
                                                                    if (_e8224[0] < 0.0lf) {
                                                                        phi_4608_ = -(_e8224[0]);
                                                                    } else {
                                                                        phi_4608_ = _e8224[0];
                                                                    }
                                                                    let _e8231 = phi_4608_;
                                                                    if (_e8224[1] < 0.0lf) {
                                                                        phi_4615_ = -(_e8224[1]);
                                                                    } else {
                                                                        phi_4615_ = _e8224[1];
                                                                    }
                                                                    let _e8235 = phi_4615_;
                                                                    if (_e8231 > _e8235) {
                                                                        phi_4620_ = _e8231;
                                                                    } else {
                                                                        phi_4620_ = _e8235;
                                                                    }
                                                                    let _e8238 = phi_4620_;
                                                                    if (_e8224[2] < 0.0lf) {
                                                                        phi_4627_ = -(_e8224[2]);
                                                                    } else {
                                                                        phi_4627_ = _e8224[2];
                                                                    }
                                                                    let _e8242 = phi_4627_;
                                                                    if (_e8238 > _e8242) {
                                                                        phi_4632_ = _e8238;
                                                                    } else {
                                                                        phi_4632_ = _e8242;
                                                                    }
                                                                    let _e8245 = phi_4632_;
                                                                    let _e8248 = local_18.member_1[1u];
                                                                    if (_e8248[0] < 0.0lf) {
                                                                        phi_4646_ = -(_e8248[0]);
                                                                    } else {
                                                                        phi_4646_ = _e8248[0];
                                                                    }
                                                                    let _e8255 = phi_4646_;
                                                                    if (_e8248[1] < 0.0lf) {
                                                                        phi_4653_ = -(_e8248[1]);
                                                                    } else {
                                                                        phi_4653_ = _e8248[1];
                                                                    }
                                                                    let _e8259 = phi_4653_;
                                                                    if (_e8255 > _e8259) {
                                                                        phi_4658_ = _e8255;
                                                                    } else {
                                                                        phi_4658_ = _e8259;
                                                                    }
                                                                    let _e8262 = phi_4658_;
                                                                    if (_e8248[2] < 0.0lf) {
                                                                        phi_4665_ = -(_e8248[2]);
                                                                    } else {
                                                                        phi_4665_ = _e8248[2];
                                                                    }
                                                                    let _e8266 = phi_4665_;
                                                                    if (_e8262 > _e8266) {
                                                                        phi_4670_ = _e8262;
                                                                    } else {
                                                                        phi_4670_ = _e8266;
                                                                    }
                                                                    let _e8269 = phi_4670_;
                                                                    if (_e8245 > _e8269) {
                                                                        phi_4675_ = _e8245;
                                                                    } else {
                                                                        phi_4675_ = _e8269;
                                                                    }
                                                                    let _e8272 = phi_4675_;
                                                                    let _e8274 = local_18.member_3;
                                                                    let _e8278 = local_18.member_2[0u];
                                                                    if (_e8278[0] < 0.0lf) {
                                                                        phi_4692_ = -(_e8278[0]);
                                                                    } else {
                                                                        phi_4692_ = _e8278[0];
                                                                    }
                                                                    let _e8285 = phi_4692_;
                                                                    if (_e8278[1] < 0.0lf) {
                                                                        phi_4699_ = -(_e8278[1]);
                                                                    } else {
                                                                        phi_4699_ = _e8278[1];
                                                                    }
                                                                    let _e8289 = phi_4699_;
                                                                    if (_e8285 > _e8289) {
                                                                        phi_4704_ = _e8285;
                                                                    } else {
                                                                        phi_4704_ = _e8289;
                                                                    }
                                                                    let _e8292 = phi_4704_;
                                                                    if (_e8278[2] < 0.0lf) {
                                                                        phi_4711_ = -(_e8278[2]);
                                                                    } else {
                                                                        phi_4711_ = _e8278[2];
                                                                    }
                                                                    let _e8296 = phi_4711_;
                                                                    if (_e8292 > _e8296) {
                                                                        phi_4716_ = _e8292;
                                                                    } else {
                                                                        phi_4716_ = _e8296;
                                                                    }
                                                                    let _e8299 = phi_4716_;
                                                                    let _e8302 = local_18.member_2[1u];
                                                                    if (_e8302[0] < 0.0lf) {
                                                                        phi_4730_ = -(_e8302[0]);
                                                                    } else {
                                                                        phi_4730_ = _e8302[0];
                                                                    }
                                                                    let _e8309 = phi_4730_;
                                                                    if (_e8302[1] < 0.0lf) {
                                                                        phi_4737_ = -(_e8302[1]);
                                                                    } else {
                                                                        phi_4737_ = _e8302[1];
                                                                    }
                                                                    let _e8313 = phi_4737_;
                                                                    if (_e8309 > _e8313) {
                                                                        phi_4742_ = _e8309;
                                                                    } else {
                                                                        phi_4742_ = _e8313;
                                                                    }
                                                                    let _e8316 = phi_4742_;
                                                                    if (_e8302[2] < 0.0lf) {
                                                                        phi_4749_ = -(_e8302[2]);
                                                                    } else {
                                                                        phi_4749_ = _e8302[2];
                                                                    }
                                                                    let _e8320 = phi_4749_;
                                                                    if (_e8316 > _e8320) {
                                                                        phi_4754_ = _e8316;
                                                                    } else {
                                                                        phi_4754_ = _e8320;
                                                                    }
                                                                    let _e8323 = phi_4754_;
                                                                    if (_e8299 > _e8323) {
                                                                        phi_4759_ = _e8299;
                                                                    } else {
                                                                        phi_4759_ = _e8323;
                                                                    }
                                                                    let _e8326 = phi_4759_;
                                                                    let _e8328 = local_18.member_3;
                                                                    let _e8336 = local_18.member_3;
                                                                    if (((_e8162 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e8218 + _e8220) + (_e8272 + _e8274)) + (_e8326 + _e8328)) * (1.1102230246251565e-16lf * f64(16f))) + (_e8336 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e820.member_1) {
                                                                        phi_4783_ = false;
                                                                    } else {
                                                                        phi_4783_ = true;
                                                                    }
                                                                    let _e8348 = phi_4783_;
                                                                    phi_4784_ = _e8348;
                                                                } else {
                                                                    phi_4784_ = true;
                                                                }
                                                                let _e8350 = phi_4784_;
                                                                phi_4785_ = _e8350;
                                                            } else {
                                                                phi_4785_ = true;
                                                            }
                                                            let _e8352 = phi_4785_;
                                                            if _e8352 {
                                                                if _e7218 {
                                                                    if _e8022 {
                                                                        phi_4804_ = f64();
                                                                        phi_4805_ = true;
                                                                    } else {
                                                                        if (_e8021 <= (_e7214 * f64(0.25f))) {
                                                                            phi_4802_ = f64(0f);
                                                                            phi_4803_ = false;
                                                                        } else {
                                                                            phi_4802_ = f64();
                                                                            phi_4803_ = true;
                                                                        }
                                                                        let _e8359 = phi_4802_;
                                                                        let _e8361 = phi_4803_;
                                                                        phi_4804_ = _e8359;
                                                                        phi_4805_ = _e8361;
                                                                    }
                                                                    let _e8363 = phi_4804_;
                                                                    let _e8365 = phi_4805_;
                                                                    if _e8365 {
                                                                        phi_4810_ = (_e7549 + _e7549);
                                                                    } else {
                                                                        phi_4810_ = _e8363;
                                                                    }
                                                                    let _e8368 = phi_4810_;
                                                                    phi_4812_ = _e8368;
                                                                } else {
                                                                    phi_4812_ = (_e552 - _e7210);
                                                                }
                                                                let _e8370 = phi_4812_;
                                                                phi_4813_ = _e8370;
                                                                phi_4814_ = false;
                                                            } else {
                                                                phi_4813_ = f64();
                                                                phi_4814_ = true;
                                                            }
                                                            let _e8372 = phi_4813_;
                                                            let _e8374 = phi_4814_;
                                                            phi_4815_ = _e8372;
                                                            phi_4816_ = _e8021;
                                                            phi_4817_ = _e8352;
                                                            phi_4818_ = _e8374;
                                                        }
                                                        let _e8376 = phi_4815_;
                                                        let _e8378 = phi_4816_;
                                                        let _e8380 = phi_4817_;
                                                        let _e8382 = phi_4818_;
                                                        phi_4819_ = _e8019;
                                                        phi_4820_ = _e8376;
                                                        phi_4821_ = _e8378;
                                                        phi_4822_ = _e8019;
                                                        phi_4823_ = _e8380;
                                                        phi_4824_ = _e8020;
                                                        phi_4825_ = _e8382;
                                                        phi_4826_ = false;
                                                    } else {
                                                        phi_4819_ = f64();
                                                        phi_4820_ = f64();
                                                        phi_4821_ = f64();
                                                        phi_4822_ = f64();
                                                        phi_4823_ = false;
                                                        phi_4824_ = false;
                                                        phi_4825_ = false;
                                                        phi_4826_ = true;
                                                    }
                                                    let _e8384 = phi_4819_;
                                                    let _e8386 = phi_4820_;
                                                    let _e8388 = phi_4821_;
                                                    let _e8390 = phi_4822_;
                                                    let _e8392 = phi_4823_;
                                                    let _e8394 = phi_4824_;
                                                    let _e8396 = phi_4825_;
                                                    let _e8398 = phi_4826_;
                                                    phi_4827_ = _e8384;
                                                    phi_4828_ = _e8386;
                                                    phi_4829_ = _e8388;
                                                    phi_4830_ = _e8390;
                                                    phi_4831_ = false;
                                                    phi_4832_ = _e8392;
                                                    phi_4833_ = _e8394;
                                                    phi_4834_ = _e8396;
                                                    phi_4835_ = _e8398;
                                                } else {
                                                    phi_4827_ = f64();
                                                    phi_4828_ = f64();
                                                    phi_4829_ = f64();
                                                    phi_4830_ = f64();
                                                    phi_4831_ = true;
                                                    phi_4832_ = false;
                                                    phi_4833_ = false;
                                                    phi_4834_ = false;
                                                    phi_4835_ = false;
                                                }
                                                let _e8400 = phi_4827_;
                                                let _e8402 = phi_4828_;
                                                let _e8404 = phi_4829_;
                                                let _e8406 = phi_4830_;
                                                let _e8408 = phi_4831_;
                                                let _e8410 = phi_4832_;
                                                let _e8412 = phi_4833_;
                                                let _e8414 = phi_4834_;
                                                let _e8416 = phi_4835_;
                                                phi_4836_ = _e8400;
                                                phi_4837_ = _e8402;
                                                phi_4838_ = _e8404;
                                                phi_4839_ = _e8406;
                                                phi_4840_ = _e8408;
                                                phi_4841_ = _e8410;
                                                phi_4842_ = _e8412;
                                                phi_4843_ = _e8414;
                                                phi_4844_ = _e8416;
                                            } else {
                                                phi_4836_ = f64();
                                                phi_4837_ = f64();
                                                phi_4838_ = f64();
                                                phi_4839_ = f64();
                                                phi_4840_ = true;
                                                phi_4841_ = false;
                                                phi_4842_ = false;
                                                phi_4843_ = false;
                                                phi_4844_ = false;
                                            }
                                            let _e8418 = phi_4836_;
                                            let _e8420 = phi_4837_;
                                            let _e8422 = phi_4838_;
                                            let _e8424 = phi_4839_;
                                            let _e8426 = phi_4840_;
                                            let _e8428 = phi_4841_;
                                            let _e8430 = phi_4842_;
                                            let _e8432 = phi_4843_;
                                            let _e8434 = phi_4844_;
                                            if _e8426 {
                                                if (_e7210 <= _e7212) {
                                                    let _e8600 = (_e7220 + 1u);
                                                    let _e8601 = (_e8600 > 3u);
                                                    if _e8601 {
                                                        phi_4857_ = false;
                                                    } else {
                                                        phi_4857_ = true;
                                                    }
                                                    let _e8603 = phi_4857_;
                                                    phi_5184_ = _e8600;
                                                    phi_5185_ = f64();
                                                    phi_5186_ = false;
                                                    phi_5187_ = _e8603;
                                                    phi_5188_ = _e8601;
                                                } else {
                                                    let _e8438 = local_16.member[0u];
                                                    let _e8441 = local_16.member_1[0u];
                                                    let _e8444 = local_16.member[0u];
                                                    let _e8450 = local_16.member_2[0u];
                                                    let _e8451 = ((_e8438 + ((_e8441 - _e8444) * _e7216)) - _e8450);
                                                    let _e8454 = local_16.member[1u];
                                                    let _e8457 = local_16.member_1[1u];
                                                    let _e8460 = local_16.member[1u];
                                                    let _e8466 = local_16.member_2[1u];
                                                    let _e8467 = ((_e8454 + ((_e8457 - _e8460) * _e7216)) - _e8466);
                                                    if (_e8451 < _e8467) {
                                                        phi_4930_ = _e8451;
                                                    } else {
                                                        phi_4930_ = _e8467;
                                                    }
                                                    let _e8470 = phi_4930_;
                                                    let _e8473 = local_16.member[2u];
                                                    let _e8476 = local_16.member_1[2u];
                                                    let _e8479 = local_16.member[2u];
                                                    let _e8485 = local_16.member_2[2u];
                                                    let _e8486 = ((_e8473 + ((_e8476 - _e8479) * _e7216)) - _e8485);
                                                    let _e8489 = local_16.member[3u];
                                                    let _e8492 = local_16.member_1[3u];
                                                    let _e8495 = local_16.member[3u];
                                                    let _e8501 = local_16.member_2[3u];
                                                    let _e8502 = ((_e8489 + ((_e8492 - _e8495) * _e7216)) - _e8501);
                                                    if (_e8486 < _e8502) {
                                                        phi_5003_ = _e8486;
                                                    } else {
                                                        phi_5003_ = _e8502;
                                                    }
                                                    let _e8505 = phi_5003_;
                                                    if (_e8470 < _e8505) {
                                                        phi_5008_ = _e8470;
                                                    } else {
                                                        phi_5008_ = _e8505;
                                                    }
                                                    let _e8508 = phi_5008_;
                                                    let _e8511 = local_17.member[0u];
                                                    let _e8514 = local_17.member_1[0u];
                                                    let _e8517 = local_17.member[0u];
                                                    let _e8523 = local_17.member_2[0u];
                                                    let _e8524 = ((_e8511 + ((_e8514 - _e8517) * _e7210)) - _e8523);
                                                    let _e8527 = local_17.member[1u];
                                                    let _e8530 = local_17.member_1[1u];
                                                    let _e8533 = local_17.member[1u];
                                                    let _e8539 = local_17.member_2[1u];
                                                    let _e8540 = ((_e8527 + ((_e8530 - _e8533) * _e7210)) - _e8539);
                                                    if (_e8524 < _e8540) {
                                                        phi_5081_ = _e8524;
                                                    } else {
                                                        phi_5081_ = _e8540;
                                                    }
                                                    let _e8543 = phi_5081_;
                                                    let _e8546 = local_17.member[2u];
                                                    let _e8549 = local_17.member_1[2u];
                                                    let _e8552 = local_17.member[2u];
                                                    let _e8558 = local_17.member_2[2u];
                                                    let _e8559 = ((_e8546 + ((_e8549 - _e8552) * _e7210)) - _e8558);
                                                    let _e8562 = local_17.member[3u];
                                                    let _e8565 = local_17.member_1[3u];
                                                    let _e8568 = local_17.member[3u];
                                                    let _e8574 = local_17.member_2[3u];
                                                    let _e8575 = ((_e8562 + ((_e8565 - _e8568) * _e7210)) - _e8574);
                                                    if (_e8559 < _e8575) {
                                                        phi_5154_ = _e8559;
                                                    } else {
                                                        phi_5154_ = _e8575;
                                                    }
                                                    let _e8578 = phi_5154_;
                                                    if (_e8543 < _e8578) {
                                                        phi_5159_ = _e8543;
                                                    } else {
                                                        phi_5159_ = _e8578;
                                                    }
                                                    let _e8581 = phi_5159_;
                                                    let _e8582 = f64(0.0625f);
                                                    let _e8584 = f64(0.9f);
                                                    if (_e8581 > f64(0f)) {
                                                        phi_5182_ = f64(0.5f);
                                                    } else {
                                                        let _e8590 = (f64(0.95f) * (_e8508 / (_e8508 - _e8581)));
                                                        if (_e8590 > _e8582) {
                                                            if (_e8590 < _e8584) {
                                                                phi_5180_ = _e8590;
                                                            } else {
                                                                phi_5180_ = _e8584;
                                                            }
                                                            let _e8594 = phi_5180_;
                                                            phi_5181_ = _e8594;
                                                        } else {
                                                            phi_5181_ = _e8582;
                                                        }
                                                        let _e8596 = phi_5181_;
                                                        phi_5182_ = _e8596;
                                                    }
                                                    let _e8598 = phi_5182_;
                                                    phi_5184_ = u32();
                                                    phi_5185_ = (_e7549 * _e8598);
                                                    phi_5186_ = true;
                                                    phi_5187_ = false;
                                                    phi_5188_ = false;
                                                }
                                                let _e8605 = phi_5184_;
                                                let _e8607 = phi_5185_;
                                                let _e8609 = phi_5186_;
                                                let _e8611 = phi_5187_;
                                                let _e8613 = phi_5188_;
                                                phi_5189_ = _e8605;
                                                phi_5190_ = _e7212;
                                                phi_5191_ = _e8607;
                                                phi_5192_ = _e7214;
                                                phi_5193_ = _e7216;
                                                phi_5194_ = _e7218;
                                                phi_5195_ = _e7220;
                                                phi_5196_ = _e8609;
                                                phi_5197_ = _e8611;
                                                phi_5198_ = _e8613;
                                                phi_5199_ = false;
                                                phi_5200_ = false;
                                                phi_5201_ = false;
                                            } else {
                                                phi_5189_ = u32();
                                                phi_5190_ = _e8418;
                                                phi_5191_ = _e8420;
                                                phi_5192_ = _e8422;
                                                phi_5193_ = _e7210;
                                                phi_5194_ = true;
                                                phi_5195_ = 0u;
                                                phi_5196_ = _e8428;
                                                phi_5197_ = false;
                                                phi_5198_ = false;
                                                phi_5199_ = _e8430;
                                                phi_5200_ = _e8432;
                                                phi_5201_ = _e8434;
                                            }
                                            let _e8615 = phi_5189_;
                                            let _e8617 = phi_5190_;
                                            let _e8619 = phi_5191_;
                                            let _e8621 = phi_5192_;
                                            let _e8623 = phi_5193_;
                                            let _e8625 = phi_5194_;
                                            let _e8627 = phi_5195_;
                                            let _e8629 = phi_5196_;
                                            let _e8631 = phi_5197_;
                                            let _e8633 = phi_5198_;
                                            let _e8635 = phi_5199_;
                                            let _e8637 = phi_5200_;
                                            let _e8639 = phi_5201_;
                                            if _e8629 {
                                                let _e8640 = (_e8623 + _e8619);
                                                if (_e8640 > _e8617) {
                                                    phi_5210_ = _e8640;
                                                } else {
                                                    phi_5210_ = _e8617;
                                                }
                                                let _e8643 = phi_5210_;
                                                if (_e8643 < _e552) {
                                                    phi_5215_ = _e8643;
                                                } else {
                                                    phi_5215_ = _e552;
                                                }
                                                let _e8646 = phi_5215_;
                                                if !(_e7218) {
                                                    phi_5224_ = true;
                                                } else {
                                                    phi_5224_ = ((_e8646 - _e8623) > _e7199);
                                                }
                                                let _e8650 = phi_5224_;
                                                if _e8650 {
                                                    phi_5228_ = false;
                                                } else {
                                                    phi_5228_ = true;
                                                }
                                                let _e8652 = phi_5228_;
                                                phi_5229_ = _e8646;
                                                phi_5230_ = _e8617;
                                                phi_5231_ = _e8621;
                                                phi_5232_ = _e8623;
                                                phi_5233_ = _e8625;
                                                phi_5234_ = _e8627;
                                                phi_5235_ = _e8650;
                                                phi_5236_ = _e8652;
                                                phi_5237_ = false;
                                                phi_5238_ = false;
                                                phi_5239_ = false;
                                                phi_5240_ = false;
                                            } else {
                                                phi_5229_ = _e7210;
                                                phi_5230_ = _e7212;
                                                phi_5231_ = _e7214;
                                                phi_5232_ = _e7216;
                                                phi_5233_ = _e7218;
                                                phi_5234_ = _e8615;
                                                phi_5235_ = _e8631;
                                                phi_5236_ = false;
                                                phi_5237_ = _e8633;
                                                phi_5238_ = _e8635;
                                                phi_5239_ = _e8637;
                                                phi_5240_ = _e8639;
                                            }
                                            let _e8654 = phi_5229_;
                                            let _e8656 = phi_5230_;
                                            let _e8658 = phi_5231_;
                                            let _e8660 = phi_5232_;
                                            let _e8662 = phi_5233_;
                                            let _e8664 = phi_5234_;
                                            let _e8666 = phi_5235_;
                                            let _e8668 = phi_5236_;
                                            let _e8670 = phi_5237_;
                                            let _e8672 = phi_5238_;
                                            let _e8674 = phi_5239_;
                                            let _e8676 = phi_5240_;
                                            phi_3019_ = _e8654;
                                            phi_3021_ = _e8656;
                                            phi_3023_ = _e8658;
                                            phi_3025_ = _e8660;
                                            phi_3027_ = _e8662;
                                            phi_3029_ = _e8664;
                                            phi_5241_ = _e8617;
                                            phi_5242_ = _e8424;
                                            phi_5243_ = _e8666;
                                            phi_5244_ = _e8668;
                                            phi_5245_ = _e8670;
                                            phi_5246_ = _e8672;
                                            phi_5247_ = _e8674;
                                            phi_5248_ = false;
                                            phi_5249_ = _e8676;
                                        } else {
                                            phi_3019_ = f64();
                                            phi_3021_ = f64();
                                            phi_3023_ = f64();
                                            phi_3025_ = f64();
                                            phi_3027_ = bool();
                                            phi_3029_ = u32();
                                            phi_5241_ = f64();
                                            phi_5242_ = f64();
                                            phi_5243_ = false;
                                            phi_5244_ = false;
                                            phi_5245_ = false;
                                            phi_5246_ = false;
                                            phi_5247_ = false;
                                            phi_5248_ = true;
                                            phi_5249_ = false;
                                        }
                                        let _e8678 = phi_3019_;
                                        let _e8680 = phi_3021_;
                                        let _e8682 = phi_3023_;
                                        let _e8684 = phi_3025_;
                                        let _e8686 = phi_3027_;
                                        let _e8688 = phi_3029_;
                                        let _e8690 = phi_5241_;
                                        let _e8692 = phi_5242_;
                                        let _e8694 = phi_5243_;
                                        let _e8696 = phi_5244_;
                                        let _e8698 = phi_5245_;
                                        let _e8700 = phi_5246_;
                                        let _e8702 = phi_5247_;
                                        let _e8704 = phi_5248_;
                                        let _e8706 = phi_5249_;
                                        local_43 = _e8696;
                                        local_81 = _e8698;
                                        local_82 = _e8700;
                                        local_83 = _e8702;
                                        local_84 = _e8704;
                                        local_85 = _e8706;
                                        local_86 = _e8696;
                                        local_87 = _e8692;
                                        local_88 = _e8690;
                                        continue;
                                        continuing {
                                            phi_3015_ = _e7232;
                                            phi_3018_ = _e8678;
                                            phi_3020_ = _e8680;
                                            phi_3022_ = _e8682;
                                            phi_3024_ = _e8684;
                                            phi_3026_ = _e8686;
                                            phi_3028_ = _e8688;
                                            break if !(_e8694);
                                        }
                                    }
                                    let _e8709 = local_43;
                                    if _e8709 {
                                        phi_5253_ = false;
                                        phi_5254_ = false;
                                        phi_5255_ = false;
                                        phi_5256_ = false;
                                        phi_5257_ = false;
                                    } else {
                                        let _e12210 = local_81;
                                        phi_5253_ = _e12210;
                                        let _e12213 = local_82;
                                        phi_5254_ = _e12213;
                                        let _e12216 = local_83;
                                        phi_5255_ = _e12216;
                                        let _e12219 = local_84;
                                        phi_5256_ = _e12219;
                                        let _e12222 = local_85;
                                        phi_5257_ = _e12222;
                                    }
                                    let _e8711 = phi_5253_;
                                    let _e8713 = phi_5254_;
                                    let _e8715 = phi_5255_;
                                    let _e8717 = phi_5256_;
                                    let _e8719 = phi_5257_;
                                    if _e8711 {
                                        let _e8721 = local_44;
                                        phi_5262_ = type_43(1u, _e8721);
                                        phi_5263_ = false;
                                        phi_5264_ = false;
                                        phi_5265_ = false;
                                        phi_5266_ = false;
                                        phi_5267_ = false;
                                    } else {
                                        phi_5262_ = type_43();
                                        phi_5263_ = _e8713;
                                        phi_5264_ = _e8715;
                                        let _e12229 = local_86;
                                        phi_5265_ = _e12229;
                                        phi_5266_ = _e8717;
                                        phi_5267_ = _e8719;
                                    }
                                    let _e8724 = phi_5262_;
                                    let _e8726 = phi_5263_;
                                    let _e8728 = phi_5264_;
                                    let _e8730 = phi_5265_;
                                    let _e8732 = phi_5266_;
                                    let _e8734 = phi_5267_;
                                    if _e8726 {
                                        phi_5272_ = type_43(0u, type_43().member_1);
                                        phi_5273_ = false;
                                        phi_5274_ = false;
                                        phi_5275_ = false;
                                        phi_5276_ = false;
                                        phi_5277_ = true;
                                    } else {
                                        phi_5272_ = _e8724;
                                        phi_5273_ = _e8728;
                                        phi_5274_ = _e8730;
                                        phi_5275_ = _e8732;
                                        phi_5276_ = _e8734;
                                        phi_5277_ = _e8711;
                                    }
                                    let _e8738 = phi_5272_;
                                    let _e8740 = phi_5273_;
                                    let _e8742 = phi_5274_;
                                    let _e8744 = phi_5275_;
                                    let _e8746 = phi_5276_;
                                    let _e8748 = phi_5277_;
                                    if _e8740 {
                                        let _e12240 = local_87;
                                        phi_5281_ = _e12240;
                                        phi_5282_ = true;
                                        phi_5283_ = false;
                                        phi_5284_ = false;
                                        phi_5285_ = false;
                                    } else {
                                        let _e12242 = local_88;
                                        phi_5281_ = _e12242;
                                        phi_5282_ = _e8742;
                                        phi_5283_ = _e8744;
                                        phi_5284_ = _e8746;
                                        phi_5285_ = _e8748;
                                    }
                                    let _e8750 = phi_5281_;
                                    let _e8752 = phi_5282_;
                                    let _e8754 = phi_5283_;
                                    let _e8756 = phi_5284_;
                                    let _e8758 = phi_5285_;
                                    if _e8752 {
                                        phi_5289_ = _e8750;
                                        phi_5290_ = true;
                                        phi_5291_ = false;
                                        phi_5292_ = false;
                                    } else {
                                        let _e12249 = local_89;
                                        phi_5289_ = _e12249;
                                        phi_5290_ = _e8754;
                                        phi_5291_ = _e8756;
                                        phi_5292_ = _e8758;
                                    }
                                    let _e8760 = phi_5289_;
                                    let _e8762 = phi_5290_;
                                    let _e8764 = phi_5291_;
                                    let _e8766 = phi_5292_;
                                    if _e8762 {
                                        phi_5297_ = type_43(1u, _e8760);
                                        phi_5298_ = false;
                                        phi_5299_ = false;
                                    } else {
                                        phi_5297_ = type_43();
                                        phi_5298_ = _e8764;
                                        phi_5299_ = _e8766;
                                    }
                                    let _e8769 = phi_5297_;
                                    let _e8771 = phi_5298_;
                                    let _e8773 = phi_5299_;
                                    if _e8771 {
                                        phi_5304_ = type_43(0u, type_43().member_1);
                                        phi_5305_ = true;
                                    } else {
                                        phi_5304_ = _e8738;
                                        phi_5305_ = _e8773;
                                    }
                                    let _e8777 = phi_5304_;
                                    let _e8779 = phi_5305_;
                                    if _e8779 {
                                        phi_5309_ = _e8777;
                                    } else {
                                        phi_5309_ = _e8769;
                                    }
                                    let _e8781 = phi_5309_;
                                    phi_5316_ = _e8781.member_1;
                                    phi_5317_ = (_e8781.member != 0u);
                                } else {
                                    phi_5316_ = _e6920;
                                    phi_5317_ = true;
                                }
                                let _e8786 = phi_5316_;
                                let _e8788 = phi_5317_;
                                if _e8788 {
                                    let _e8789 = (_e8786 > _e543);
                                    if _e8789 {
                                        phi_7524_ = f64();
                                        phi_7525_ = u32();
                                        phi_7526_ = f64();
                                        phi_7527_ = type_45();
                                        phi_7528_ = u32();
                                        phi_7529_ = u32();
                                        phi_7530_ = false;
                                        phi_7531_ = false;
                                        phi_7532_ = false;
                                    } else {
                                        let _e8793 = local_18.member[0u];
                                        let _e8799 = local_18.member[1u];
                                        let _e8815 = local_18.member_1[0u];
                                        let _e8821 = local_18.member_1[1u];
                                        let _e8837 = local_18.member_2[0u];
                                        let _e8843 = local_18.member_2[1u];
                                        let _e8857 = function_4(array<f64, 3>((_e8793[0] + ((_e8799[0] - _e8793[0]) * _e6924)), (_e8793[1] + ((_e8799[1] - _e8793[1]) * _e6924)), (_e8793[2] + ((_e8799[2] - _e8793[2]) * _e6924))), array<f64, 3>((_e8815[0] + ((_e8821[0] - _e8815[0]) * _e6924)), (_e8815[1] + ((_e8821[1] - _e8815[1]) * _e6924)), (_e8815[2] + ((_e8821[2] - _e8815[2]) * _e6924))), array<f64, 3>((_e8837[0] + ((_e8843[0] - _e8837[0]) * _e6924)), (_e8837[1] + ((_e8843[1] - _e8837[1]) * _e6924)), (_e8837[2] + ((_e8843[2] - _e8837[2]) * _e6924))), _e247.member);
                                        if (_e8857[0] < 0.0lf) {
                                            phi_5430_ = -(_e8857[0]);
                                        } else {
                                            phi_5430_ = _e8857[0];
                                        }
                                        let _e8862 = phi_5430_;
                                        if (_e8857[1] < 0.0lf) {
                                            phi_5437_ = -(_e8857[1]);
                                        } else {
                                            phi_5437_ = _e8857[1];
                                        }
                                        let _e8867 = phi_5437_;
                                        if (_e8857[2] < 0.0lf) {
                                            phi_5445_ = -(_e8857[2]);
                                        } else {
                                            phi_5445_ = _e8857[2];
                                        }
                                        let _e8873 = phi_5445_;
                                        let _e8874 = ((_e8862 + _e8867) + _e8873);
                                        let _e8877 = local_18.member[0u];
                                        let _e8884 = local_18.member_1[0u];
                                        let _e8890 = local_18.member_2[0u];
                                        let _e8894 = (_e8877[0] - _e8884[0]);
                                        let _e8895 = (_e8877[1] - _e8884[1]);
                                        let _e8896 = (_e8877[2] - _e8884[2]);
                                        if (_e247.member == 0u) {
                                            phi_5503_ = array<f64, 3>(_e8877[0], _e8877[1], _e8877[2]);
                                        } else {
                                            phi_5503_ = array<f64, 3>((_e8894 - _e8890[0]), (_e8895 - _e8890[1]), (_e8896 - _e8890[2]));
                                        }
                                        let _e8903 = phi_5503_;
                                        let _e8909 = local_18.member[1u];
                                        let _e8916 = local_18.member_1[1u];
                                        let _e8922 = local_18.member_2[1u];
                                        let _e8926 = (_e8909[0] - _e8916[0]);
                                        let _e8927 = (_e8909[1] - _e8916[1]);
                                        let _e8928 = (_e8909[2] - _e8916[2]);
                                        if (_e247.member == 0u) {
                                            phi_5571_ = array<f64, 3>(_e8909[0], _e8909[1], _e8909[2]);
                                        } else {
                                            phi_5571_ = array<f64, 3>((_e8926 - _e8922[0]), (_e8927 - _e8922[1]), (_e8928 - _e8922[2]));
                                        }
                                        let _e8935 = phi_5571_;
                                        let _e8941 = local_18.member[0u];
                                        if (_e8941[0] < 0.0lf) {
                                            phi_5596_ = -(_e8941[0]);
                                        } else {
                                            phi_5596_ = _e8941[0];
                                        }
                                        let _e8948 = phi_5596_;
                                        if (_e8941[1] < 0.0lf) {
                                            phi_5603_ = -(_e8941[1]);
                                        } else {
                                            phi_5603_ = _e8941[1];
                                        }
                                        let _e8952 = phi_5603_;
                                        if (_e8948 > _e8952) {
                                            phi_5608_ = _e8948;
                                        } else {
                                            phi_5608_ = _e8952;
                                        }
                                        let _e8955 = phi_5608_;
                                        if (_e8941[2] < 0.0lf) {
                                            phi_5615_ = -(_e8941[2]);
                                        } else {
                                            phi_5615_ = _e8941[2];
                                        }
                                        let _e8959 = phi_5615_;
                                        if (_e8955 > _e8959) {
                                            phi_5620_ = _e8955;
                                        } else {
                                            phi_5620_ = _e8959;
                                        }
                                        let _e8962 = phi_5620_;
                                        let _e8965 = local_18.member[1u];
                                        if (_e8965[0] < 0.0lf) {
                                            phi_5633_ = -(_e8965[0]);
                                        } else {
                                            phi_5633_ = _e8965[0];
                                        }
                                        let _e8972 = phi_5633_;
                                        if (_e8965[1] < 0.0lf) {
                                            phi_5640_ = -(_e8965[1]);
                                        } else {
                                            phi_5640_ = _e8965[1];
                                        }
                                        let _e8976 = phi_5640_;
                                        if (_e8972 > _e8976) {
                                            phi_5645_ = _e8972;
                                        } else {
                                            phi_5645_ = _e8976;
                                        }
                                        let _e8979 = phi_5645_;
                                        if (_e8965[2] < 0.0lf) {
                                            phi_5652_ = -(_e8965[2]);
                                        } else {
                                            phi_5652_ = _e8965[2];
                                        }
                                        let _e8983 = phi_5652_;
                                        if (_e8979 > _e8983) {
                                            phi_5657_ = _e8979;
                                        } else {
                                            phi_5657_ = _e8983;
                                        }
                                        let _e8986 = phi_5657_;
                                        if (_e8962 > _e8986) {
                                            phi_5662_ = _e8962;
                                        } else {
                                            phi_5662_ = _e8986;
                                        }
                                        let _e8989 = phi_5662_;
                                        let _e8991 = local_18.member_3;
                                        let _e8995 = local_18.member_1[0u];
                                        if (_e8995[0] < 0.0lf) {
                                            phi_5679_ = -(_e8995[0]);
                                        } else {
                                            phi_5679_ = _e8995[0];
                                        }
                                        let _e9002 = phi_5679_;
                                        if (_e8995[1] < 0.0lf) {
                                            phi_5686_ = -(_e8995[1]);
                                        } else {
                                            phi_5686_ = _e8995[1];
                                        }
                                        let _e9006 = phi_5686_;
                                        if (_e9002 > _e9006) {
                                            phi_5691_ = _e9002;
                                        } else {
                                            phi_5691_ = _e9006;
                                        }
                                        let _e9009 = phi_5691_;
                                        if (_e8995[2] < 0.0lf) {
                                            phi_5698_ = -(_e8995[2]);
                                        } else {
                                            phi_5698_ = _e8995[2];
                                        }
                                        let _e9013 = phi_5698_;
                                        if (_e9009 > _e9013) {
                                            phi_5703_ = _e9009;
                                        } else {
                                            phi_5703_ = _e9013;
                                        }
                                        let _e9016 = phi_5703_;
                                        let _e9019 = local_18.member_1[1u];
                                        if (_e9019[0] < 0.0lf) {
                                            phi_5717_ = -(_e9019[0]);
                                        } else {
                                            phi_5717_ = _e9019[0];
                                        }
                                        let _e9026 = phi_5717_;
                                        if (_e9019[1] < 0.0lf) {
                                            phi_5724_ = -(_e9019[1]);
                                        } else {
                                            phi_5724_ = _e9019[1];
                                        }
                                        let _e9030 = phi_5724_;
                                        if (_e9026 > _e9030) {
                                            phi_5729_ = _e9026;
                                        } else {
                                            phi_5729_ = _e9030;
                                        }
                                        let _e9033 = phi_5729_;
                                        if (_e9019[2] < 0.0lf) {
                                            phi_5736_ = -(_e9019[2]);
                                        } else {
                                            phi_5736_ = _e9019[2];
                                        }
                                        let _e9037 = phi_5736_;
                                        if (_e9033 > _e9037) {
                                            phi_5741_ = _e9033;
                                        } else {
                                            phi_5741_ = _e9037;
                                        }
                                        let _e9040 = phi_5741_;
                                        if (_e9016 > _e9040) {
                                            phi_5746_ = _e9016;
                                        } else {
                                            phi_5746_ = _e9040;
                                        }
                                        let _e9043 = phi_5746_;
                                        let _e9045 = local_18.member_3;
                                        let _e9049 = local_18.member_2[0u];
                                        if (_e9049[0] < 0.0lf) {
                                            phi_5763_ = -(_e9049[0]);
                                        } else {
                                            phi_5763_ = _e9049[0];
                                        }
                                        let _e9056 = phi_5763_;
                                        if (_e9049[1] < 0.0lf) {
                                            phi_5770_ = -(_e9049[1]);
                                        } else {
                                            phi_5770_ = _e9049[1];
                                        }
                                        let _e9060 = phi_5770_;
                                        if (_e9056 > _e9060) {
                                            phi_5775_ = _e9056;
                                        } else {
                                            phi_5775_ = _e9060;
                                        }
                                        let _e9063 = phi_5775_;
                                        if (_e9049[2] < 0.0lf) {
                                            phi_5782_ = -(_e9049[2]);
                                        } else {
                                            phi_5782_ = _e9049[2];
                                        }
                                        let _e9067 = phi_5782_;
                                        if (_e9063 > _e9067) {
                                            phi_5787_ = _e9063;
                                        } else {
                                            phi_5787_ = _e9067;
                                        }
                                        let _e9070 = phi_5787_;
                                        let _e9073 = local_18.member_2[1u];
                                        if (_e9073[0] < 0.0lf) {
                                            phi_5801_ = -(_e9073[0]);
                                        } else {
                                            phi_5801_ = _e9073[0];
                                        }
                                        let _e9080 = phi_5801_;
                                        if (_e9073[1] < 0.0lf) {
                                            phi_5808_ = -(_e9073[1]);
                                        } else {
                                            phi_5808_ = _e9073[1];
                                        }
                                        let _e9084 = phi_5808_;
                                        if (_e9080 > _e9084) {
                                            phi_5813_ = _e9080;
                                        } else {
                                            phi_5813_ = _e9084;
                                        }
                                        let _e9087 = phi_5813_;
                                        if (_e9073[2] < 0.0lf) {
                                            phi_5820_ = -(_e9073[2]);
                                        } else {
                                            phi_5820_ = _e9073[2];
                                        }
                                        let _e9091 = phi_5820_;
                                        if (_e9087 > _e9091) {
                                            phi_5825_ = _e9087;
                                        } else {
                                            phi_5825_ = _e9091;
                                        }
                                        let _e9094 = phi_5825_;
                                        if (_e9070 > _e9094) {
                                            phi_5830_ = _e9070;
                                        } else {
                                            phi_5830_ = _e9094;
                                        }
                                        let _e9097 = phi_5830_;
                                        let _e9099 = local_18.member_3;
                                        let _e9107 = local_18.member_3;
                                        local_14 = type_41(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e8877, array<f64, 3>(_e8894, _e8895, _e8896), array<f64, 3>((_e8877[0] - _e8890[0]), (_e8877[1] - _e8890[1]), (_e8877[2] - _e8890[2])), array<f64, 3>(_e8903[0], _e8903[1], _e8903[2])), array<array<f64, 3>, 4>(_e8909, array<f64, 3>(_e8926, _e8927, _e8928), array<f64, 3>((_e8909[0] - _e8922[0]), (_e8909[1] - _e8922[1]), (_e8909[2] - _e8922[2])), array<f64, 3>(_e8935[0], _e8935[1], _e8935[2]))), ((((((_e8989 + _e8991) + (_e9043 + _e9045)) + (_e9097 + _e9099)) * (1.1102230246251565e-16lf * f64(16f))) + (_e9107 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e820.member_1);
                                        let _e9131 = local_14.member_1;
                                        if (_e8874 > _e9131) {
                                            if ((bitcast<u64>(_e8874) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e9137 = (f64(1f) / _e8874);
                                                let _e9139 = (_e8857[0] * _e9137);
                                                let _e9141 = (_e8857[1] * _e9137);
                                                let _e9143 = (_e8857[2] * _e9137);
                                                let _e9148 = (((_e9139 * _e9139) + (_e9141 * _e9141)) + (_e9143 * _e9143));
                                                if (_e9148 <= 2.2250738585072014e-308lf) {
                                                    if (_e9148 > 0.0lf) {
                                                        phi_5935_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_5935_ = 0.0lf;
                                                    }
                                                    let _e9200 = phi_5935_;
                                                    phi_5999_ = _e9200;
                                                } else {
                                                    phi_5942_ = type_18(0i, 5i);
                                                    phi_5945_ = bitcast<f64>(((bitcast<u64>(_e9148) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9155 = phi_5942_;
                                                        let _e9157 = phi_5945_;
                                                        local_45 = _e9157;
                                                        if (_e9155.member < _e9155.member_1) {
                                                            let _e9164 = (_e9155.member + 1i);
                                                            if ((false == (_e9164 > _e9155.member)) != false) {
                                                                phi_5966_ = true;
                                                            } else {
                                                                phi_5966_ = false;
                                                            }
                                                            let _e9169 = phi_5966_;
                                                            if _e9169 {
                                                                phi_5972_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_5972_ = type_19(1u, _e9164);
                                                            }
                                                            let _e9174 = phi_5972_;
                                                            phi_5943_ = type_18(_e9174.member_1, _e9155.member_1);
                                                            phi_5986_ = type_19(1u, _e9155.member);
                                                        } else {
                                                            phi_5943_ = _e9155;
                                                            phi_5986_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e9180 = phi_5943_;
                                                        let _e9182 = phi_5986_;
                                                        let _e9185 = (bitcast<i32>(_e9182.member) != 0i);
                                                        if _e9185 {
                                                            phi_5946_ = (0.5lf * (_e9157 + (_e9148 / _e9157)));
                                                        } else {
                                                            phi_5946_ = f64();
                                                        }
                                                        let _e9190 = phi_5946_;
                                                        continue;
                                                        continuing {
                                                            phi_5942_ = _e9180;
                                                            phi_5945_ = _e9190;
                                                            break if !(_e9185);
                                                        }
                                                    }
                                                    let _e9195 = local_45;
                                                    phi_5999_ = (_e9195 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9202 = phi_5999_;
                                                let _e9204 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e9206 = local_14.member_1;
                                                let _e9210 = local_14.member_2;
                                                let _e9215 = ((_e9206 * f64(1.01f)) + ((_e9210 * _e9202) * (f64(1f) + _e9204)));
                                                let _e9219 = local_14.member[0u][0u];
                                                let _e9227 = (((_e9139 * _e9219[0]) + (_e9141 * _e9219[1])) + (_e9143 * _e9219[2]));
                                                let _e9231 = local_14.member[0u][1u];
                                                let _e9239 = (((_e9139 * _e9231[0]) + (_e9141 * _e9231[1])) + (_e9143 * _e9231[2]));
                                                let _e9243 = local_14.member[0u][2u];
                                                let _e9251 = (((_e9139 * _e9243[0]) + (_e9141 * _e9243[1])) + (_e9143 * _e9243[2]));
                                                let _e9255 = local_14.member[0u][3u];
                                                let _e9263 = (((_e9139 * _e9255[0]) + (_e9141 * _e9255[1])) + (_e9143 * _e9255[2]));
                                                let _e9267 = local_14.member[1u][0u];
                                                let _e9275 = (((_e9139 * _e9267[0]) + (_e9141 * _e9267[1])) + (_e9143 * _e9267[2]));
                                                let _e9279 = local_14.member[1u][1u];
                                                let _e9287 = (((_e9139 * _e9279[0]) + (_e9141 * _e9279[1])) + (_e9143 * _e9279[2]));
                                                let _e9291 = local_14.member[1u][2u];
                                                let _e9299 = (((_e9139 * _e9291[0]) + (_e9141 * _e9291[1])) + (_e9143 * _e9291[2]));
                                                let _e9303 = local_14.member[1u][3u];
                                                let _e9311 = (((_e9139 * _e9303[0]) + (_e9141 * _e9303[1])) + (_e9143 * _e9303[2]));
                                                if (_e9227 < 0.0lf) {
                                                    phi_6136_ = -(_e9227);
                                                } else {
                                                    phi_6136_ = _e9227;
                                                }
                                                let _e9315 = phi_6136_;
                                                if (_e9275 < 0.0lf) {
                                                    phi_6142_ = -(_e9275);
                                                } else {
                                                    phi_6142_ = _e9275;
                                                }
                                                let _e9319 = phi_6142_;
                                                if (_e9239 < 0.0lf) {
                                                    phi_6151_ = -(_e9239);
                                                } else {
                                                    phi_6151_ = _e9239;
                                                }
                                                let _e9326 = phi_6151_;
                                                if (_e9287 < 0.0lf) {
                                                    phi_6157_ = -(_e9287);
                                                } else {
                                                    phi_6157_ = _e9287;
                                                }
                                                let _e9330 = phi_6157_;
                                                if (_e9251 < 0.0lf) {
                                                    phi_6166_ = -(_e9251);
                                                } else {
                                                    phi_6166_ = _e9251;
                                                }
                                                let _e9337 = phi_6166_;
                                                if (_e9299 < 0.0lf) {
                                                    phi_6172_ = -(_e9299);
                                                } else {
                                                    phi_6172_ = _e9299;
                                                }
                                                let _e9341 = phi_6172_;
                                                if (_e9263 < 0.0lf) {
                                                    phi_6181_ = -(_e9263);
                                                } else {
                                                    phi_6181_ = _e9263;
                                                }
                                                let _e9348 = phi_6181_;
                                                if (_e9311 < 0.0lf) {
                                                    phi_6187_ = -(_e9311);
                                                } else {
                                                    phi_6187_ = _e9311;
                                                }
                                                let _e9352 = phi_6187_;
                                                local_15 = type_35(array<f64, 4>(_e9227, _e9239, _e9251, _e9263), array<f64, 4>(_e9275, _e9287, _e9299, _e9311), array<f64, 4>((_e9215 + ((_e9315 + _e9319) * _e9204)), (_e9215 + ((_e9326 + _e9330) * _e9204)), (_e9215 + ((_e9337 + _e9341) * _e9204)), (_e9215 + ((_e9348 + _e9352) * _e9204))));
                                                let _e9364 = (((_e9139 * _e9139) + (_e9141 * _e9141)) + (_e9143 * _e9143));
                                                if (_e9364 <= 2.2250738585072014e-308lf) {
                                                    if (_e9364 > 0.0lf) {
                                                        phi_6230_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6230_ = 0.0lf;
                                                    }
                                                    let _e9416 = phi_6230_;
                                                    phi_6294_ = _e9416;
                                                } else {
                                                    phi_6237_ = type_18(0i, 5i);
                                                    phi_6240_ = bitcast<f64>(((bitcast<u64>(_e9364) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9371 = phi_6237_;
                                                        let _e9373 = phi_6240_;
                                                        local_46 = _e9373;
                                                        if (_e9371.member < _e9371.member_1) {
                                                            let _e9380 = (_e9371.member + 1i);
                                                            if ((false == (_e9380 > _e9371.member)) != false) {
                                                                phi_6261_ = true;
                                                            } else {
                                                                phi_6261_ = false;
                                                            }
                                                            let _e9385 = phi_6261_;
                                                            if _e9385 {
                                                                phi_6267_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_6267_ = type_19(1u, _e9380);
                                                            }
                                                            let _e9390 = phi_6267_;
                                                            phi_6238_ = type_18(_e9390.member_1, _e9371.member_1);
                                                            phi_6281_ = type_19(1u, _e9371.member);
                                                        } else {
                                                            phi_6238_ = _e9371;
                                                            phi_6281_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e9396 = phi_6238_;
                                                        let _e9398 = phi_6281_;
                                                        let _e9401 = (bitcast<i32>(_e9398.member) != 0i);
                                                        if _e9401 {
                                                            phi_6241_ = (0.5lf * (_e9373 + (_e9364 / _e9373)));
                                                        } else {
                                                            phi_6241_ = f64();
                                                        }
                                                        let _e9406 = phi_6241_;
                                                        continue;
                                                        continuing {
                                                            phi_6237_ = _e9396;
                                                            phi_6240_ = _e9406;
                                                            break if !(_e9401);
                                                        }
                                                    }
                                                    let _e9411 = local_46;
                                                    phi_6294_ = (_e9411 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9418 = phi_6294_;
                                                let _e9429 = (((_e8857[0] * _e8857[0]) + (_e8857[1] * _e8857[1])) + (_e8857[2] * _e8857[2]));
                                                if (_e9429 <= 2.2250738585072014e-308lf) {
                                                    if (_e9429 > 0.0lf) {
                                                        phi_6319_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6319_ = 0.0lf;
                                                    }
                                                    let _e9481 = phi_6319_;
                                                    phi_6383_ = _e9481;
                                                } else {
                                                    phi_6326_ = type_18(0i, 5i);
                                                    phi_6329_ = bitcast<f64>(((bitcast<u64>(_e9429) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9436 = phi_6326_;
                                                        let _e9438 = phi_6329_;
                                                        local_47 = _e9438;
                                                        if (_e9436.member < _e9436.member_1) {
                                                            let _e9445 = (_e9436.member + 1i);
                                                            if ((false == (_e9445 > _e9436.member)) != false) {
                                                                phi_6350_ = true;
                                                            } else {
                                                                phi_6350_ = false;
                                                            }
                                                            let _e9450 = phi_6350_;
                                                            if _e9450 {
                                                                phi_6356_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_6356_ = type_19(1u, _e9445);
                                                            }
                                                            let _e9455 = phi_6356_;
                                                            phi_6327_ = type_18(_e9455.member_1, _e9436.member_1);
                                                            phi_6370_ = type_19(1u, _e9436.member);
                                                        } else {
                                                            phi_6327_ = _e9436;
                                                            phi_6370_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e9461 = phi_6327_;
                                                        let _e9463 = phi_6370_;
                                                        let _e9466 = (bitcast<i32>(_e9463.member) != 0i);
                                                        if _e9466 {
                                                            phi_6330_ = (0.5lf * (_e9438 + (_e9429 / _e9438)));
                                                        } else {
                                                            phi_6330_ = f64();
                                                        }
                                                        let _e9471 = phi_6330_;
                                                        continue;
                                                        continuing {
                                                            phi_6326_ = _e9461;
                                                            phi_6329_ = _e9471;
                                                            break if !(_e9466);
                                                        }
                                                    }
                                                    let _e9476 = local_47;
                                                    phi_6383_ = (_e9476 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9483 = phi_6383_;
                                                let _e9491 = local_18.member[0u];
                                                if (_e9491[0] < 0.0lf) {
                                                    phi_6401_ = -(_e9491[0]);
                                                } else {
                                                    phi_6401_ = _e9491[0];
                                                }
                                                let _e9498 = phi_6401_;
                                                if (_e9491[1] < 0.0lf) {
                                                    phi_6408_ = -(_e9491[1]);
                                                } else {
                                                    phi_6408_ = _e9491[1];
                                                }
                                                let _e9502 = phi_6408_;
                                                if (_e9498 > _e9502) {
                                                    phi_6413_ = _e9498;
                                                } else {
                                                    phi_6413_ = _e9502;
                                                }
                                                let _e9505 = phi_6413_;
                                                if (_e9491[2] < 0.0lf) {
                                                    phi_6420_ = -(_e9491[2]);
                                                } else {
                                                    phi_6420_ = _e9491[2];
                                                }
                                                let _e9509 = phi_6420_;
                                                if (_e9505 > _e9509) {
                                                    phi_6425_ = _e9505;
                                                } else {
                                                    phi_6425_ = _e9509;
                                                }
                                                let _e9512 = phi_6425_;
                                                let _e9515 = local_18.member[1u];
                                                if (_e9515[0] < 0.0lf) {
                                                    phi_6438_ = -(_e9515[0]);
                                                } else {
                                                    phi_6438_ = _e9515[0];
                                                }
                                                let _e9522 = phi_6438_;
                                                if (_e9515[1] < 0.0lf) {
                                                    phi_6445_ = -(_e9515[1]);
                                                } else {
                                                    phi_6445_ = _e9515[1];
                                                }
                                                let _e9526 = phi_6445_;
                                                if (_e9522 > _e9526) {
                                                    phi_6450_ = _e9522;
                                                } else {
                                                    phi_6450_ = _e9526;
                                                }
                                                let _e9529 = phi_6450_;
                                                if (_e9515[2] < 0.0lf) {
                                                    phi_6457_ = -(_e9515[2]);
                                                } else {
                                                    phi_6457_ = _e9515[2];
                                                }
                                                let _e9533 = phi_6457_;
                                                if (_e9529 > _e9533) {
                                                    phi_6462_ = _e9529;
                                                } else {
                                                    phi_6462_ = _e9533;
                                                }
                                                let _e9536 = phi_6462_;
                                                if (_e9512 > _e9536) {
                                                    phi_6467_ = _e9512;
                                                } else {
                                                    phi_6467_ = _e9536;
                                                }
                                                let _e9539 = phi_6467_;
                                                let _e9541 = local_18.member_3;
                                                let _e9545 = local_18.member_1[0u];
                                                if (_e9545[0] < 0.0lf) {
                                                    phi_6484_ = -(_e9545[0]);
                                                } else {
                                                    phi_6484_ = _e9545[0];
                                                }
                                                let _e9552 = phi_6484_;
                                                if (_e9545[1] < 0.0lf) {
                                                    phi_6491_ = -(_e9545[1]);
                                                } else {
                                                    phi_6491_ = _e9545[1];
                                                }
                                                let _e9556 = phi_6491_;
                                                if (_e9552 > _e9556) {
                                                    phi_6496_ = _e9552;
                                                } else {
                                                    phi_6496_ = _e9556;
                                                }
                                                let _e9559 = phi_6496_;
                                                if (_e9545[2] < 0.0lf) {
                                                    phi_6503_ = -(_e9545[2]);
                                                } else {
                                                    phi_6503_ = _e9545[2];
                                                }
                                                let _e9563 = phi_6503_;
                                                if (_e9559 > _e9563) {
                                                    phi_6508_ = _e9559;
                                                } else {
                                                    phi_6508_ = _e9563;
                                                }
                                                let _e9566 = phi_6508_;
                                                let _e9569 = local_18.member_1[1u];
                                                if (_e9569[0] < 0.0lf) {
                                                    phi_6522_ = -(_e9569[0]);
                                                } else {
                                                    phi_6522_ = _e9569[0];
                                                }
                                                let _e9576 = phi_6522_;
                                                if (_e9569[1] < 0.0lf) {
                                                    phi_6529_ = -(_e9569[1]);
                                                } else {
                                                    phi_6529_ = _e9569[1];
                                                }
                                                let _e9580 = phi_6529_;
                                                if (_e9576 > _e9580) {
                                                    phi_6534_ = _e9576;
                                                } else {
                                                    phi_6534_ = _e9580;
                                                }
                                                let _e9583 = phi_6534_;
                                                if (_e9569[2] < 0.0lf) {
                                                    phi_6541_ = -(_e9569[2]);
                                                } else {
                                                    phi_6541_ = _e9569[2];
                                                }
                                                let _e9587 = phi_6541_;
                                                if (_e9583 > _e9587) {
                                                    phi_6546_ = _e9583;
                                                } else {
                                                    phi_6546_ = _e9587;
                                                }
                                                let _e9590 = phi_6546_;
                                                if (_e9566 > _e9590) {
                                                    phi_6551_ = _e9566;
                                                } else {
                                                    phi_6551_ = _e9590;
                                                }
                                                let _e9593 = phi_6551_;
                                                let _e9595 = local_18.member_3;
                                                let _e9599 = local_18.member_2[0u];
                                                if (_e9599[0] < 0.0lf) {
                                                    phi_6568_ = -(_e9599[0]);
                                                } else {
                                                    phi_6568_ = _e9599[0];
                                                }
                                                let _e9606 = phi_6568_;
                                                if (_e9599[1] < 0.0lf) {
                                                    phi_6575_ = -(_e9599[1]);
                                                } else {
                                                    phi_6575_ = _e9599[1];
                                                }
                                                let _e9610 = phi_6575_;
                                                if (_e9606 > _e9610) {
                                                    phi_6580_ = _e9606;
                                                } else {
                                                    phi_6580_ = _e9610;
                                                }
                                                let _e9613 = phi_6580_;
                                                if (_e9599[2] < 0.0lf) {
                                                    phi_6587_ = -(_e9599[2]);
                                                } else {
                                                    phi_6587_ = _e9599[2];
                                                }
                                                let _e9617 = phi_6587_;
                                                if (_e9613 > _e9617) {
                                                    phi_6592_ = _e9613;
                                                } else {
                                                    phi_6592_ = _e9617;
                                                }
                                                let _e9620 = phi_6592_;
                                                let _e9623 = local_18.member_2[1u];
                                                if (_e9623[0] < 0.0lf) {
                                                    phi_6606_ = -(_e9623[0]);
                                                } else {
                                                    phi_6606_ = _e9623[0];
                                                }
                                                let _e9630 = phi_6606_;
                                                if (_e9623[1] < 0.0lf) {
                                                    phi_6613_ = -(_e9623[1]);
                                                } else {
                                                    phi_6613_ = _e9623[1];
                                                }
                                                let _e9634 = phi_6613_;
                                                if (_e9630 > _e9634) {
                                                    phi_6618_ = _e9630;
                                                } else {
                                                    phi_6618_ = _e9634;
                                                }
                                                let _e9637 = phi_6618_;
                                                if (_e9623[2] < 0.0lf) {
                                                    phi_6625_ = -(_e9623[2]);
                                                } else {
                                                    phi_6625_ = _e9623[2];
                                                }
                                                let _e9641 = phi_6625_;
                                                if (_e9637 > _e9641) {
                                                    phi_6630_ = _e9637;
                                                } else {
                                                    phi_6630_ = _e9641;
                                                }
                                                let _e9644 = phi_6630_;
                                                if (_e9620 > _e9644) {
                                                    phi_6635_ = _e9620;
                                                } else {
                                                    phi_6635_ = _e9644;
                                                }
                                                let _e9647 = phi_6635_;
                                                let _e9649 = local_18.member_3;
                                                let _e9657 = local_18.member_3;
                                                let _e9672 = ((((_e9483 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e9539 + _e9541) + (_e9593 + _e9595)) + (_e9647 + _e9649)) * (1.1102230246251565e-16lf * f64(16f))) + (_e9657 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e9418) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                                let _e9675 = local_15.member[0u];
                                                let _e9678 = local_15.member_1[0u];
                                                if (_e9675 < 0.0lf) {
                                                    phi_6683_ = -(_e9675);
                                                } else {
                                                    phi_6683_ = _e9675;
                                                }
                                                let _e9684 = phi_6683_;
                                                if (_e9678 < 0.0lf) {
                                                    phi_6689_ = -(_e9678);
                                                } else {
                                                    phi_6689_ = _e9678;
                                                }
                                                let _e9688 = phi_6689_;
                                                phi_6701_ = type_9(1u, 4u);
                                                phi_6704_ = ((_e9675 + ((_e9678 - _e9675) * _e6924)) - ((_e9131 * f64(1.01f)) + ((_e9684 + _e9688) * (1.1102230246251565e-16lf * f64(12f)))));
                                                loop {
                                                    let _e9699 = phi_6701_;
                                                    let _e9701 = phi_6704_;
                                                    local_48 = _e9701;
                                                    local_49 = _e9701;
                                                    if (_e9699.member < _e9699.member_1) {
                                                        phi_6702_ = type_9((_e9699.member + 1u), _e9699.member_1);
                                                        phi_6727_ = type_9(1u, _e9699.member);
                                                    } else {
                                                        phi_6702_ = _e9699;
                                                        phi_6727_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e9713 = phi_6702_;
                                                    let _e9715 = phi_6727_;
                                                    let _e9719 = (bitcast<i32>(_e9715.member) != 0i);
                                                    if _e9719 {
                                                        let _e9722 = local_15.member[_e9715.member_1];
                                                        let _e9725 = local_15.member_1[_e9715.member_1];
                                                        if (_e9722 < 0.0lf) {
                                                            phi_6757_ = -(_e9722);
                                                        } else {
                                                            phi_6757_ = _e9722;
                                                        }
                                                        let _e9731 = phi_6757_;
                                                        if (_e9725 < 0.0lf) {
                                                            phi_6763_ = -(_e9725);
                                                        } else {
                                                            phi_6763_ = _e9725;
                                                        }
                                                        let _e9735 = phi_6763_;
                                                        let _e9744 = ((_e9722 + ((_e9725 - _e9722) * _e6924)) - ((_e9131 * f64(1.01f)) + ((_e9731 + _e9735) * (1.1102230246251565e-16lf * f64(12f)))));
                                                        if (_e9701 < _e9744) {
                                                            phi_6777_ = _e9701;
                                                        } else {
                                                            phi_6777_ = _e9744;
                                                        }
                                                        let _e9747 = phi_6777_;
                                                        phi_6705_ = _e9747;
                                                    } else {
                                                        phi_6705_ = f64();
                                                    }
                                                    let _e9749 = phi_6705_;
                                                    continue;
                                                    continuing {
                                                        phi_6701_ = _e9713;
                                                        phi_6704_ = _e9749;
                                                        break if !(_e9719);
                                                    }
                                                }
                                                let _e9752 = local_48;
                                                if (_e9752 > f64(0f)) {
                                                    let _e9757 = local_49;
                                                    let _e9761 = (((_e9672 - _e9757) / _e9672) * f64(2.02f));
                                                    if (_e9761 <= 2.2250738585072014e-308lf) {
                                                        if (_e9761 > 0.0lf) {
                                                            phi_6799_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_6799_ = 0.0lf;
                                                        }
                                                        let _e9813 = phi_6799_;
                                                        phi_6863_ = _e9813;
                                                    } else {
                                                        phi_6806_ = type_18(0i, 5i);
                                                        phi_6809_ = bitcast<f64>(((bitcast<u64>(_e9761) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e9768 = phi_6806_;
                                                            let _e9770 = phi_6809_;
                                                            local_50 = _e9770;
                                                            if (_e9768.member < _e9768.member_1) {
                                                                let _e9777 = (_e9768.member + 1i);
                                                                if ((false == (_e9777 > _e9768.member)) != false) {
                                                                    phi_6830_ = true;
                                                                } else {
                                                                    phi_6830_ = false;
                                                                }
                                                                let _e9782 = phi_6830_;
                                                                if _e9782 {
                                                                    phi_6836_ = type_19(0u, type_19().member_1);
                                                                } else {
                                                                    phi_6836_ = type_19(1u, _e9777);
                                                                }
                                                                let _e9787 = phi_6836_;
                                                                phi_6807_ = type_18(_e9787.member_1, _e9768.member_1);
                                                                phi_6850_ = type_19(1u, _e9768.member);
                                                            } else {
                                                                phi_6807_ = _e9768;
                                                                phi_6850_ = type_19(0u, type_19().member_1);
                                                            }
                                                            let _e9793 = phi_6807_;
                                                            let _e9795 = phi_6850_;
                                                            let _e9798 = (bitcast<i32>(_e9795.member) != 0i);
                                                            if _e9798 {
                                                                phi_6810_ = (0.5lf * (_e9770 + (_e9761 / _e9770)));
                                                            } else {
                                                                phi_6810_ = f64();
                                                            }
                                                            let _e9803 = phi_6810_;
                                                            continue;
                                                            continuing {
                                                                phi_6806_ = _e9793;
                                                                phi_6809_ = _e9803;
                                                                break if !(_e9798);
                                                            }
                                                        }
                                                        let _e9808 = local_50;
                                                        phi_6863_ = (_e9808 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e9815 = phi_6863_;
                                                    let _e9818 = ((_e9815 * _e9418) * f64(1.01f));
                                                    phi_6870_ = type_9(0u, 4u);
                                                    phi_6873_ = f64(2f);
                                                    phi_6875_ = true;
                                                    phi_6877_ = true;
                                                    loop {
                                                        let _e9821 = phi_6870_;
                                                        let _e9823 = phi_6873_;
                                                        let _e9825 = phi_6875_;
                                                        let _e9827 = phi_6877_;
                                                        local_51 = _e9823;
                                                        local_90 = _e9823;
                                                        local_52 = _e9825;
                                                        local_53 = _e9827;
                                                        local_91 = _e9827;
                                                        local_54 = _e9827;
                                                        if (_e9821.member < _e9821.member_1) {
                                                            phi_6871_ = type_9((_e9821.member + 1u), _e9821.member_1);
                                                            phi_6900_ = type_9(1u, _e9821.member);
                                                        } else {
                                                            phi_6871_ = _e9821;
                                                            phi_6900_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e9839 = phi_6871_;
                                                        let _e9841 = phi_6900_;
                                                        let _e9845 = (bitcast<i32>(_e9841.member) != 0i);
                                                        if _e9845 {
                                                            let _e9849 = local_14.member[0u][_e9841.member_1];
                                                            let _e9856 = local_14.member[1u][_e9841.member_1];
                                                            if (_e9849[0] < 0.0lf) {
                                                                phi_6937_ = -(_e9849[0]);
                                                            } else {
                                                                phi_6937_ = _e9849[0];
                                                            }
                                                            let _e9863 = phi_6937_;
                                                            if (_e9849[1] < 0.0lf) {
                                                                phi_6944_ = -(_e9849[1]);
                                                            } else {
                                                                phi_6944_ = _e9849[1];
                                                            }
                                                            let _e9867 = phi_6944_;
                                                            if (_e9849[2] < 0.0lf) {
                                                                phi_6952_ = -(_e9849[2]);
                                                            } else {
                                                                phi_6952_ = _e9849[2];
                                                            }
                                                            let _e9872 = phi_6952_;
                                                            let _e9873 = ((_e9863 + _e9867) + _e9872);
                                                            if (_e9856[0] < 0.0lf) {
                                                                phi_6960_ = -(_e9856[0]);
                                                            } else {
                                                                phi_6960_ = _e9856[0];
                                                            }
                                                            let _e9877 = phi_6960_;
                                                            if (_e9856[1] < 0.0lf) {
                                                                phi_6967_ = -(_e9856[1]);
                                                            } else {
                                                                phi_6967_ = _e9856[1];
                                                            }
                                                            let _e9881 = phi_6967_;
                                                            if (_e9856[2] < 0.0lf) {
                                                                phi_6975_ = -(_e9856[2]);
                                                            } else {
                                                                phi_6975_ = _e9856[2];
                                                            }
                                                            let _e9886 = phi_6975_;
                                                            let _e9887 = ((_e9877 + _e9881) + _e9886);
                                                            if (_e9873 > _e9887) {
                                                                phi_6981_ = _e9873;
                                                            } else {
                                                                phi_6981_ = _e9887;
                                                            }
                                                            let _e9890 = phi_6981_;
                                                            let _e9896 = (_e9856[0] - _e9849[0]);
                                                            let _e9897 = (_e9856[1] - _e9849[1]);
                                                            let _e9898 = (_e9856[2] - _e9849[2]);
                                                            if (_e9896 < 0.0lf) {
                                                                phi_7001_ = -(_e9896);
                                                            } else {
                                                                phi_7001_ = _e9896;
                                                            }
                                                            let _e9902 = phi_7001_;
                                                            if (_e9897 < 0.0lf) {
                                                                phi_7007_ = -(_e9897);
                                                            } else {
                                                                phi_7007_ = _e9897;
                                                            }
                                                            let _e9906 = phi_7007_;
                                                            if (_e9898 < 0.0lf) {
                                                                phi_7014_ = -(_e9898);
                                                            } else {
                                                                phi_7014_ = _e9898;
                                                            }
                                                            let _e9911 = phi_7014_;
                                                            let _e9920 = local_15.member[_e9841.member_1];
                                                            let _e9923 = local_15.member_1[_e9841.member_1];
                                                            if (_e9920 < 0.0lf) {
                                                                phi_7043_ = -(_e9920);
                                                            } else {
                                                                phi_7043_ = _e9920;
                                                            }
                                                            let _e9929 = phi_7043_;
                                                            if (_e9923 < 0.0lf) {
                                                                phi_7049_ = -(_e9923);
                                                            } else {
                                                                phi_7049_ = _e9923;
                                                            }
                                                            let _e9933 = phi_7049_;
                                                            let _e9938 = ((_e9131 * f64(1.01f)) + ((_e9929 + _e9933) * (1.1102230246251565e-16lf * f64(12f))));
                                                            let _e9945 = local_15.member_1[_e9841.member_1];
                                                            let _e9948 = local_15.member[_e9841.member_1];
                                                            let _e9949 = (_e9945 - _e9948);
                                                            let _e9952 = ((_e9938 + _e9938) + (_e9818 * ((((_e9902 + _e9906) + _e9911) + (_e9131 * f64(6f))) * f64(1.01f))));
                                                            let _e9955 = ((((_e9920 + ((_e9923 - _e9920) * _e6924)) - _e9938) - (_e9818 * ((_e9890 + (_e9131 * f64(3f))) * f64(1.01f)))) - _e9672);
                                                            let _e9956 = (_e9955 > 2.2250738585072014e-308lf);
                                                            let _e9957 = (_e9949 > _e9952);
                                                            if _e9957 {
                                                                phi_7086_ = true;
                                                            } else {
                                                                phi_7086_ = _e9956;
                                                            }
                                                            let _e9959 = phi_7086_;
                                                            if (_e9949 < -(_e9952)) {
                                                                phi_7093_ = true;
                                                            } else {
                                                                phi_7093_ = _e9956;
                                                            }
                                                            let _e9964 = phi_7093_;
                                                            if _e9957 {
                                                                phi_7114_ = _e9823;
                                                            } else {
                                                                if _e9956 {
                                                                    let _e9966 = (_e9952 - _e9949);
                                                                    if (_e9966 > 2.2250738585072014e-308lf) {
                                                                        phi_7106_ = _e9966;
                                                                    } else {
                                                                        phi_7106_ = 2.2250738585072014e-308lf;
                                                                    }
                                                                    let _e9969 = phi_7106_;
                                                                    let _e9970 = (_e9955 / _e9969);
                                                                    if (_e9823 < _e9970) {
                                                                        phi_7112_ = _e9823;
                                                                    } else {
                                                                        phi_7112_ = _e9970;
                                                                    }
                                                                    let _e9973 = phi_7112_;
                                                                    phi_7113_ = _e9973;
                                                                } else {
                                                                    phi_7113_ = _e9823;
                                                                }
                                                                let _e9975 = phi_7113_;
                                                                phi_7114_ = _e9975;
                                                            }
                                                            let _e9977 = phi_7114_;
                                                            phi_6874_ = _e9977;
                                                            phi_6876_ = (_e9825 && _e9964);
                                                            phi_6878_ = (_e9827 && _e9959);
                                                        } else {
                                                            phi_6874_ = f64();
                                                            phi_6876_ = bool();
                                                            phi_6878_ = bool();
                                                        }
                                                        let _e9979 = phi_6874_;
                                                        let _e9981 = phi_6876_;
                                                        let _e9983 = phi_6878_;
                                                        continue;
                                                        continuing {
                                                            phi_6870_ = _e9839;
                                                            phi_6873_ = _e9979;
                                                            phi_6875_ = _e9981;
                                                            phi_6877_ = _e9983;
                                                            break if !(_e9845);
                                                        }
                                                    }
                                                    let _e9985 = f64(2f);
                                                    let _e9987 = local_51;
                                                    if (_e9987 < _e9985) {
                                                        let _e12422 = local_90;
                                                        phi_7120_ = _e12422;
                                                    } else {
                                                        phi_7120_ = _e9985;
                                                    }
                                                    let _e9990 = phi_7120_;
                                                    let _e9992 = (_e9990 * f64(0.999f));
                                                    let _e9994 = local_52;
                                                    if _e9994 {
                                                        let _e9996 = local_53;
                                                        if _e9996 {
                                                            phi_7131_ = type_45();
                                                        } else {
                                                            phi_7131_ = type_45(_e6924, f64(2f), 1u);
                                                        }
                                                        let _e10000 = phi_7131_;
                                                        phi_7132_ = _e10000;
                                                        let _e12429 = local_91;
                                                        phi_7133_ = _e12429;
                                                    } else {
                                                        phi_7132_ = type_45();
                                                        phi_7133_ = true;
                                                    }
                                                    let _e10002 = phi_7132_;
                                                    let _e10004 = phi_7133_;
                                                    if _e10004 {
                                                        let _e10006 = local_54;
                                                        if _e10006 {
                                                            if (_e9992 > (1.1102230246251565e-16lf * f64(4096f))) {
                                                                let _e10012 = (_e6924 + _e9992);
                                                                if (_e10012 < _e552) {
                                                                    phi_7151_ = _e10012;
                                                                } else {
                                                                    phi_7151_ = _e552;
                                                                }
                                                                let _e10015 = phi_7151_;
                                                                phi_7152_ = _e10015;
                                                            } else {
                                                                phi_7152_ = _e6924;
                                                            }
                                                            let _e10017 = phi_7152_;
                                                            phi_7155_ = type_9(0u, 4u);
                                                            phi_7158_ = _e10017;
                                                            phi_7160_ = _e6924;
                                                            loop {
                                                                let _e10019 = phi_7155_;
                                                                let _e10021 = phi_7158_;
                                                                let _e10023 = phi_7160_;
                                                                local_55 = _e10021;
                                                                local_56 = _e10023;
                                                                local_57 = _e10023;
                                                                if (_e10019.member < _e10019.member_1) {
                                                                    phi_7156_ = type_9((_e10019.member + 1u), _e10019.member_1);
                                                                    phi_7183_ = type_9(1u, _e10019.member);
                                                                } else {
                                                                    phi_7156_ = _e10019;
                                                                    phi_7183_ = type_9(0u, type_9().member_1);
                                                                }
                                                                let _e10035 = phi_7156_;
                                                                let _e10037 = phi_7183_;
                                                                let _e10041 = (bitcast<i32>(_e10037.member) != 0i);
                                                                if _e10041 {
                                                                    let _e10044 = local_15.member[_e10037.member_1];
                                                                    let _e10047 = local_15.member_1[_e10037.member_1];
                                                                    let _e10050 = local_15.member[_e10037.member_1];
                                                                    let _e10056 = local_15.member_2[_e10037.member_1];
                                                                    let _e10057 = ((_e10044 + ((_e10047 - _e10050) * _e6924)) - _e10056);
                                                                    let _e10060 = local_15.member_1[_e10037.member_1];
                                                                    let _e10063 = local_15.member[_e10037.member_1];
                                                                    let _e10064 = (_e10060 - _e10063);
                                                                    if (_e10064 > f64(0f)) {
                                                                        let _e10081 = (_e6924 - (_e10057 / _e10064));
                                                                        if (_e10023 > _e10081) {
                                                                            phi_7252_ = _e10023;
                                                                        } else {
                                                                            phi_7252_ = _e10081;
                                                                        }
                                                                        let _e10084 = phi_7252_;
                                                                        phi_7272_ = _e10021;
                                                                        phi_7273_ = _e10084;
                                                                    } else {
                                                                        if (_e10057 > f64(0f)) {
                                                                            if (_e10064 < f64(0f)) {
                                                                                let _e10072 = (_e6924 - (_e10057 / _e10064));
                                                                                if (_e10021 < _e10072) {
                                                                                    phi_7269_ = _e10021;
                                                                                } else {
                                                                                    phi_7269_ = _e10072;
                                                                                }
                                                                                let _e10075 = phi_7269_;
                                                                                phi_7270_ = _e10075;
                                                                            } else {
                                                                                phi_7270_ = _e10021;
                                                                            }
                                                                            let _e10077 = phi_7270_;
                                                                            phi_7271_ = _e10077;
                                                                        } else {
                                                                            phi_7271_ = _e10021;
                                                                        }
                                                                        let _e10079 = phi_7271_;
                                                                        phi_7272_ = _e10079;
                                                                        phi_7273_ = _e10023;
                                                                    }
                                                                    let _e10086 = phi_7272_;
                                                                    let _e10088 = phi_7273_;
                                                                    phi_7159_ = _e10086;
                                                                    phi_7161_ = _e10088;
                                                                } else {
                                                                    phi_7159_ = f64();
                                                                    phi_7161_ = f64();
                                                                }
                                                                let _e10090 = phi_7159_;
                                                                let _e10092 = phi_7161_;
                                                                continue;
                                                                continuing {
                                                                    phi_7155_ = _e10035;
                                                                    phi_7158_ = _e10090;
                                                                    phi_7160_ = _e10092;
                                                                    break if !(_e10041);
                                                                }
                                                            }
                                                            let _e10095 = local_55;
                                                            let _e10097 = local_56;
                                                            let _e10102 = local_57;
                                                            let _e10103 = (_e10102 + ((_e10095 - _e10097) * f64(0.5f)));
                                                            if (_e10103 > _e6924) {
                                                                if (_e10103 <= _e10017) {
                                                                    let _e10106 = f64(0f);
                                                                    let _e10109 = local_15.member[0u];
                                                                    let _e10112 = local_15.member_1[0u];
                                                                    let _e10115 = local_15.member[0u];
                                                                    let _e10121 = local_15.member_2[0u];
                                                                    if (((_e10109 + ((_e10112 - _e10115) * _e10103)) - _e10121) > _e10106) {
                                                                        let _e10126 = local_15.member[1u];
                                                                        let _e10129 = local_15.member_1[1u];
                                                                        let _e10132 = local_15.member[1u];
                                                                        let _e10138 = local_15.member_2[1u];
                                                                        if (((_e10126 + ((_e10129 - _e10132) * _e10103)) - _e10138) > _e10106) {
                                                                            let _e10143 = local_15.member[2u];
                                                                            let _e10146 = local_15.member_1[2u];
                                                                            let _e10149 = local_15.member[2u];
                                                                            let _e10155 = local_15.member_2[2u];
                                                                            if (((_e10143 + ((_e10146 - _e10149) * _e10103)) - _e10155) > _e10106) {
                                                                                let _e10160 = local_15.member[3u];
                                                                                let _e10163 = local_15.member_1[3u];
                                                                                let _e10166 = local_15.member[3u];
                                                                                let _e10172 = local_15.member_2[3u];
                                                                                phi_7436_ = (((_e10160 + ((_e10163 - _e10166) * _e10103)) - _e10172) > _e10106);
                                                                                phi_7437_ = false;
                                                                            } else {
                                                                                phi_7436_ = bool();
                                                                                phi_7437_ = true;
                                                                            }
                                                                            let _e10176 = phi_7436_;
                                                                            let _e10178 = phi_7437_;
                                                                            phi_7438_ = _e10176;
                                                                            phi_7439_ = _e10178;
                                                                        } else {
                                                                            phi_7438_ = bool();
                                                                            phi_7439_ = true;
                                                                        }
                                                                        let _e10180 = phi_7438_;
                                                                        let _e10182 = phi_7439_;
                                                                        phi_7440_ = _e10180;
                                                                        phi_7441_ = _e10182;
                                                                    } else {
                                                                        phi_7440_ = bool();
                                                                        phi_7441_ = true;
                                                                    }
                                                                    let _e10184 = phi_7440_;
                                                                    let _e10186 = phi_7441_;
                                                                    if _e10186 {
                                                                        phi_7445_ = false;
                                                                    } else {
                                                                        phi_7445_ = _e10184;
                                                                    }
                                                                    let _e10188 = phi_7445_;
                                                                    if _e10188 {
                                                                        phi_7449_ = false;
                                                                    } else {
                                                                        phi_7449_ = true;
                                                                    }
                                                                    let _e10190 = phi_7449_;
                                                                    phi_7450_ = _e10190;
                                                                } else {
                                                                    phi_7450_ = true;
                                                                }
                                                                let _e10192 = phi_7450_;
                                                                phi_7451_ = _e10192;
                                                            } else {
                                                                phi_7451_ = true;
                                                            }
                                                            let _e10194 = phi_7451_;
                                                            if _e10194 {
                                                                phi_7456_ = f64(2f);
                                                            } else {
                                                                phi_7456_ = _e10103;
                                                            }
                                                            let _e10197 = phi_7456_;
                                                            phi_7460_ = type_45(_e10017, _e10197, 2u);
                                                            phi_7461_ = type_45();
                                                            phi_7462_ = false;
                                                        } else {
                                                            phi_7460_ = type_45();
                                                            phi_7461_ = type_45(_e6924, f64(2f), 0u);
                                                            phi_7462_ = true;
                                                        }
                                                        let _e10200 = phi_7460_;
                                                        let _e10202 = phi_7461_;
                                                        let _e10204 = phi_7462_;
                                                        phi_7463_ = _e10200;
                                                        phi_7464_ = _e10202;
                                                        phi_7465_ = _e10204;
                                                    } else {
                                                        phi_7463_ = type_45();
                                                        phi_7464_ = _e10002;
                                                        phi_7465_ = true;
                                                    }
                                                    let _e10206 = phi_7463_;
                                                    let _e10208 = phi_7464_;
                                                    let _e10210 = phi_7465_;
                                                    phi_7471_ = _e10208;
                                                    phi_7472_ = _e10206;
                                                    phi_7473_ = _e10210;
                                                } else {
                                                    phi_7471_ = type_45(_e6924, f64(2f), 0u);
                                                    phi_7472_ = type_45();
                                                    phi_7473_ = true;
                                                }
                                                let _e10212 = phi_7471_;
                                                let _e10214 = phi_7472_;
                                                let _e10216 = phi_7473_;
                                                phi_7477_ = _e10212;
                                                phi_7478_ = _e10214;
                                                phi_7479_ = false;
                                                phi_7480_ = _e10216;
                                            } else {
                                                phi_7477_ = type_45();
                                                phi_7478_ = type_45();
                                                phi_7479_ = true;
                                                phi_7480_ = false;
                                            }
                                            let _e10218 = phi_7477_;
                                            let _e10220 = phi_7478_;
                                            let _e10222 = phi_7479_;
                                            let _e10224 = phi_7480_;
                                            phi_7481_ = _e10218;
                                            phi_7482_ = _e10220;
                                            phi_7483_ = _e10222;
                                            phi_7484_ = _e10224;
                                        } else {
                                            phi_7481_ = type_45();
                                            phi_7482_ = type_45();
                                            phi_7483_ = true;
                                            phi_7484_ = false;
                                        }
                                        let _e10226 = phi_7481_;
                                        let _e10228 = phi_7482_;
                                        let _e10230 = phi_7483_;
                                        let _e10232 = phi_7484_;
                                        if _e10230 {
                                            phi_7490_ = type_45(_e6924, f64(2f), 0u);
                                            phi_7491_ = true;
                                        } else {
                                            phi_7490_ = _e10226;
                                            phi_7491_ = _e10232;
                                        }
                                        let _e10236 = phi_7490_;
                                        let _e10238 = phi_7491_;
                                        if _e10238 {
                                            phi_7495_ = _e10236;
                                        } else {
                                            phi_7495_ = _e10228;
                                        }
                                        let _e10240 = phi_7495_;
                                        if ((_e554 & 64u) != 0u) {
                                            if (_e10240.member_2 == 2u) {
                                                let _e10244 = (_e10240.member_1 <= _e552);
                                                if _e10244 {
                                                    phi_7511_ = _e10240.member_1;
                                                    phi_7512_ = _e10240.member_1;
                                                    phi_7513_ = false;
                                                } else {
                                                    phi_7511_ = f64();
                                                    phi_7512_ = f64();
                                                    phi_7513_ = true;
                                                }
                                                let _e10248 = phi_7511_;
                                                let _e10250 = phi_7512_;
                                                let _e10252 = phi_7513_;
                                                phi_7514_ = _e10248;
                                                phi_7515_ = _e10250;
                                                phi_7516_ = _e10244;
                                                phi_7517_ = _e10252;
                                                phi_7518_ = false;
                                            } else {
                                                phi_7514_ = f64();
                                                phi_7515_ = f64();
                                                phi_7516_ = false;
                                                phi_7517_ = false;
                                                phi_7518_ = true;
                                            }
                                            let _e10254 = phi_7514_;
                                            let _e10256 = phi_7515_;
                                            let _e10258 = phi_7516_;
                                            let _e10260 = phi_7517_;
                                            let _e10262 = phi_7518_;
                                            phi_7519_ = _e10254;
                                            phi_7520_ = _e10256;
                                            phi_7521_ = _e10258;
                                            phi_7522_ = _e10260;
                                            phi_7523_ = _e10262;
                                        } else {
                                            phi_7519_ = f64();
                                            phi_7520_ = f64();
                                            phi_7521_ = false;
                                            phi_7522_ = false;
                                            phi_7523_ = true;
                                        }
                                        let _e10264 = phi_7519_;
                                        let _e10266 = phi_7520_;
                                        let _e10268 = phi_7521_;
                                        let _e10270 = phi_7522_;
                                        let _e10272 = phi_7523_;
                                        phi_7524_ = _e10264;
                                        phi_7525_ = _e10240.member_2;
                                        phi_7526_ = _e10266;
                                        phi_7527_ = _e10240;
                                        phi_7528_ = _e10240.member_2;
                                        phi_7529_ = _e10240.member_2;
                                        phi_7530_ = _e10268;
                                        phi_7531_ = _e10270;
                                        phi_7532_ = _e10272;
                                    }
                                    let _e10274 = phi_7524_;
                                    let _e10276 = phi_7525_;
                                    let _e10278 = phi_7526_;
                                    let _e10280 = phi_7527_;
                                    let _e10282 = phi_7528_;
                                    let _e10284 = phi_7529_;
                                    let _e10286 = phi_7530_;
                                    let _e10288 = phi_7531_;
                                    let _e10290 = phi_7532_;
                                    phi_7533_ = _e10274;
                                    phi_7534_ = _e10276;
                                    phi_7535_ = _e10278;
                                    phi_7536_ = _e10280;
                                    phi_7537_ = _e10282;
                                    phi_7538_ = _e10284;
                                    phi_7539_ = _e10286;
                                    phi_7540_ = _e8789;
                                    phi_7541_ = _e10288;
                                    phi_7542_ = _e10290;
                                    phi_7543_ = false;
                                } else {
                                    phi_7533_ = f64();
                                    phi_7534_ = u32();
                                    phi_7535_ = f64();
                                    phi_7536_ = type_45();
                                    phi_7537_ = u32();
                                    phi_7538_ = u32();
                                    phi_7539_ = false;
                                    phi_7540_ = false;
                                    phi_7541_ = false;
                                    phi_7542_ = false;
                                    phi_7543_ = true;
                                }
                                let _e10292 = phi_7533_;
                                let _e10294 = phi_7534_;
                                let _e10296 = phi_7535_;
                                let _e10298 = phi_7536_;
                                let _e10300 = phi_7537_;
                                let _e10302 = phi_7538_;
                                let _e10304 = phi_7539_;
                                let _e10306 = phi_7540_;
                                let _e10308 = phi_7541_;
                                let _e10310 = phi_7542_;
                                let _e10312 = phi_7543_;
                                phi_7544_ = _e8786;
                                phi_2528_ = _e10292;
                                phi_2530_ = _e10294;
                                phi_2532_ = _e10296;
                                phi_7545_ = _e10298;
                                phi_7546_ = _e10300;
                                phi_7547_ = _e8786;
                                phi_7548_ = _e10302;
                                phi_7549_ = _e10304;
                                phi_7550_ = _e10306;
                                phi_7551_ = _e10308;
                                phi_7552_ = _e10310;
                                phi_7553_ = false;
                                phi_7554_ = _e10312;
                            } else {
                                phi_7544_ = f64();
                                phi_2528_ = f64();
                                phi_2530_ = u32();
                                phi_2532_ = f64();
                                phi_7545_ = type_45();
                                phi_7546_ = u32();
                                phi_7547_ = f64();
                                phi_7548_ = u32();
                                phi_7549_ = false;
                                phi_7550_ = false;
                                phi_7551_ = false;
                                phi_7552_ = false;
                                phi_7553_ = true;
                                phi_7554_ = false;
                            }
                            let _e10314 = phi_7544_;
                            let _e10316 = phi_2528_;
                            let _e10318 = phi_2530_;
                            let _e10320 = phi_2532_;
                            let _e10322 = phi_7545_;
                            let _e10324 = phi_7546_;
                            let _e10326 = phi_7547_;
                            let _e10328 = phi_7548_;
                            let _e10330 = phi_7549_;
                            let _e10332 = phi_7550_;
                            let _e10334 = phi_7551_;
                            let _e10336 = phi_7552_;
                            let _e10338 = phi_7553_;
                            let _e10340 = phi_7554_;
                            local_58 = _e10332;
                            local_92 = _e10334;
                            local_93 = _e10336;
                            local_94 = _e10338;
                            local_95 = _e10340;
                            local_59 = _e10322;
                            local_60 = _e10322;
                            local_96 = _e10324;
                            local_61 = _e10322;
                            local_97 = _e10332;
                            local_98 = _e10328;
                            local_100 = _e10326;
                            local_101 = _e10314;
                            continue;
                            continuing {
                                phi_2524_ = _e6947;
                                phi_2527_ = _e10316;
                                phi_2529_ = _e10318;
                                phi_2531_ = _e10320;
                                break if !(_e10330);
                            }
                        }
                        let _e10343 = local_58;
                        if _e10343 {
                            phi_7558_ = false;
                            phi_7559_ = false;
                            phi_7560_ = false;
                            phi_7561_ = false;
                        } else {
                            let _e12530 = local_92;
                            phi_7558_ = _e12530;
                            let _e12533 = local_93;
                            phi_7559_ = _e12533;
                            let _e12536 = local_94;
                            phi_7560_ = _e12536;
                            let _e12539 = local_95;
                            phi_7561_ = _e12539;
                        }
                        let _e10345 = phi_7558_;
                        let _e10347 = phi_7559_;
                        let _e10349 = phi_7560_;
                        let _e10351 = phi_7561_;
                        if _e10345 {
                            let _e10353 = local_59;
                            if (_e10353.member >= _e552) {
                                phi_7583_ = type_44(type_43(0u, f64()), 0u);
                            } else {
                                let _e10357 = local_60;
                                if (_e10357.member > _e543) {
                                    phi_7578_ = 0u;
                                } else {
                                    let _e12544 = local_96;
                                    phi_7578_ = _e12544;
                                }
                                let _e10361 = phi_7578_;
                                let _e10363 = local_61;
                                phi_7583_ = type_44(type_43(2u, _e10363.member), _e10361);
                            }
                            let _e10370 = phi_7583_;
                            phi_7584_ = _e10370;
                            phi_7585_ = false;
                            phi_7586_ = false;
                            phi_7587_ = false;
                            phi_7588_ = false;
                        } else {
                            phi_7584_ = type_44();
                            phi_7585_ = _e10347;
                            let _e12551 = local_97;
                            phi_7586_ = _e12551;
                            phi_7587_ = _e10349;
                            phi_7588_ = _e10351;
                        }
                        let _e10372 = phi_7584_;
                        let _e10374 = phi_7585_;
                        let _e10376 = phi_7586_;
                        let _e10378 = phi_7587_;
                        let _e10380 = phi_7588_;
                        if _e10374 {
                            let _e12556 = local_98;
                            phi_7592_ = _e12556;
                            let _e12561 = local_100;
                            phi_7593_ = _e12561;
                            phi_7594_ = true;
                            phi_7595_ = false;
                            phi_7596_ = false;
                            phi_7597_ = false;
                        } else {
                            let _e12558 = local_99;
                            phi_7592_ = _e12558;
                            let _e12563 = local_101;
                            phi_7593_ = _e12563;
                            phi_7594_ = _e10376;
                            phi_7595_ = _e10378;
                            phi_7596_ = _e10380;
                            phi_7597_ = _e10345;
                        }
                        let _e10382 = phi_7592_;
                        let _e10384 = phi_7593_;
                        let _e10386 = phi_7594_;
                        let _e10388 = phi_7595_;
                        let _e10390 = phi_7596_;
                        let _e10392 = phi_7597_;
                        if _e10386 {
                            phi_7601_ = _e10384;
                            phi_7602_ = _e10382;
                            phi_7603_ = true;
                            phi_7604_ = false;
                            phi_7605_ = false;
                        } else {
                            let _e12570 = local_102;
                            phi_7601_ = _e12570;
                            let _e12573 = local_103;
                            phi_7602_ = _e12573;
                            phi_7603_ = _e10388;
                            phi_7604_ = _e10390;
                            phi_7605_ = _e10392;
                        }
                        let _e10394 = phi_7601_;
                        let _e10396 = phi_7602_;
                        let _e10398 = phi_7603_;
                        let _e10400 = phi_7604_;
                        let _e10402 = phi_7605_;
                        if _e10398 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e534 >= (1.1102230246251565e-16lf * f64(8f))) {
                                phi_7619_ = _e534;
                            } else {
                                phi_7619_ = f64(0f);
                            }
                            let _e10411 = phi_7619_;
                            phi_7622_ = type_9(0u, 3u);
                            loop {
                                let _e10413 = phi_7622_;
                                if (_e10413.member < _e10413.member_1) {
                                    phi_7623_ = type_9((_e10413.member + 1u), _e10413.member_1);
                                    phi_7646_ = type_9(1u, _e10413.member);
                                } else {
                                    phi_7623_ = _e10413;
                                    phi_7646_ = type_9(0u, type_9().member_1);
                                }
                                let _e10425 = phi_7623_;
                                let _e10427 = phi_7646_;
                                if (bitcast<i32>(_e10427.member) != 0i) {
                                    let _e10433 = local_13[_e10427.member_1];
                                    let _e10436 = (_e10394 + (_e10411 * f64(_e10433)));
                                    if (_e10436 < _e552) {
                                        phi_7668_ = _e10436;
                                    } else {
                                        phi_7668_ = _e552;
                                    }
                                    let _e10439 = phi_7668_;
                                    let _e10442 = local_18.member[0u];
                                    let _e10448 = local_18.member[1u];
                                    let _e10464 = local_18.member_1[0u];
                                    let _e10470 = local_18.member_1[1u];
                                    let _e10486 = local_18.member_2[0u];
                                    let _e10492 = local_18.member_2[1u];
                                    let _e10506 = function_4(array<f64, 3>((_e10442[0] + ((_e10448[0] - _e10442[0]) * _e10439)), (_e10442[1] + ((_e10448[1] - _e10442[1]) * _e10439)), (_e10442[2] + ((_e10448[2] - _e10442[2]) * _e10439))), array<f64, 3>((_e10464[0] + ((_e10470[0] - _e10464[0]) * _e10439)), (_e10464[1] + ((_e10470[1] - _e10464[1]) * _e10439)), (_e10464[2] + ((_e10470[2] - _e10464[2]) * _e10439))), array<f64, 3>((_e10486[0] + ((_e10492[0] - _e10486[0]) * _e10439)), (_e10486[1] + ((_e10492[1] - _e10486[1]) * _e10439)), (_e10486[2] + ((_e10492[2] - _e10486[2]) * _e10439))), _e247.member);
                                    let _e10517 = (((_e10506[0] * _e10506[0]) + (_e10506[1] * _e10506[1])) + (_e10506[2] * _e10506[2]));
                                    if (_e10517 <= 2.2250738585072014e-308lf) {
                                        if (_e10517 > 0.0lf) {
                                            phi_7791_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_7791_ = 0.0lf;
                                        }
                                        let _e10569 = phi_7791_;
                                        phi_7855_ = _e10569;
                                    } else {
                                        phi_7798_ = type_18(0i, 5i);
                                        phi_7801_ = bitcast<f64>(((bitcast<u64>(_e10517) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e10524 = phi_7798_;
                                            let _e10526 = phi_7801_;
                                            local_62 = _e10526;
                                            if (_e10524.member < _e10524.member_1) {
                                                let _e10533 = (_e10524.member + 1i);
                                                if ((false == (_e10533 > _e10524.member)) != false) {
                                                    phi_7822_ = true;
                                                } else {
                                                    phi_7822_ = false;
                                                }
                                                let _e10538 = phi_7822_;
                                                if _e10538 {
                                                    phi_7828_ = type_19(0u, type_19().member_1);
                                                } else {
                                                    phi_7828_ = type_19(1u, _e10533);
                                                }
                                                let _e10543 = phi_7828_;
                                                phi_7799_ = type_18(_e10543.member_1, _e10524.member_1);
                                                phi_7842_ = type_19(1u, _e10524.member);
                                            } else {
                                                phi_7799_ = _e10524;
                                                phi_7842_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e10549 = phi_7799_;
                                            let _e10551 = phi_7842_;
                                            let _e10554 = (bitcast<i32>(_e10551.member) != 0i);
                                            if _e10554 {
                                                phi_7802_ = (0.5lf * (_e10526 + (_e10517 / _e10526)));
                                            } else {
                                                phi_7802_ = f64();
                                            }
                                            let _e10559 = phi_7802_;
                                            continue;
                                            continuing {
                                                phi_7798_ = _e10549;
                                                phi_7801_ = _e10559;
                                                break if !(_e10554);
                                            }
                                        }
                                        let _e10564 = local_62;
                                        phi_7855_ = (_e10564 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e10571 = phi_7855_;
                                    let _e10579 = local_18.member[0u];
                                    if (_e10579[0] < 0.0lf) {
                                        phi_7873_ = -(_e10579[0]);
                                    } else {
                                        phi_7873_ = _e10579[0];
                                    }
                                    let _e10586 = phi_7873_;
                                    if (_e10579[1] < 0.0lf) {
                                        phi_7880_ = -(_e10579[1]);
                                    } else {
                                        phi_7880_ = _e10579[1];
                                    }
                                    let _e10590 = phi_7880_;
                                    if (_e10586 > _e10590) {
                                        phi_7885_ = _e10586;
                                    } else {
                                        phi_7885_ = _e10590;
                                    }
                                    let _e10593 = phi_7885_;
                                    if (_e10579[2] < 0.0lf) {
                                        phi_7892_ = -(_e10579[2]);
                                    } else {
                                        phi_7892_ = _e10579[2];
                                    }
                                    let _e10597 = phi_7892_;
                                    if (_e10593 > _e10597) {
                                        phi_7897_ = _e10593;
                                    } else {
                                        phi_7897_ = _e10597;
                                    }
                                    let _e10600 = phi_7897_;
                                    let _e10603 = local_18.member[1u];
                                    if (_e10603[0] < 0.0lf) {
                                        phi_7910_ = -(_e10603[0]);
                                    } else {
                                        phi_7910_ = _e10603[0];
                                    }
                                    let _e10610 = phi_7910_;
                                    if (_e10603[1] < 0.0lf) {
                                        phi_7917_ = -(_e10603[1]);
                                    } else {
                                        phi_7917_ = _e10603[1];
                                    }
                                    let _e10614 = phi_7917_;
                                    if (_e10610 > _e10614) {
                                        phi_7922_ = _e10610;
                                    } else {
                                        phi_7922_ = _e10614;
                                    }
                                    let _e10617 = phi_7922_;
                                    if (_e10603[2] < 0.0lf) {
                                        phi_7929_ = -(_e10603[2]);
                                    } else {
                                        phi_7929_ = _e10603[2];
                                    }
                                    let _e10621 = phi_7929_;
                                    if (_e10617 > _e10621) {
                                        phi_7934_ = _e10617;
                                    } else {
                                        phi_7934_ = _e10621;
                                    }
                                    let _e10624 = phi_7934_;
                                    if (_e10600 > _e10624) {
                                        phi_7939_ = _e10600;
                                    } else {
                                        phi_7939_ = _e10624;
                                    }
                                    let _e10627 = phi_7939_;
                                    let _e10629 = local_18.member_3;
                                    let _e10633 = local_18.member_1[0u];
                                    if (_e10633[0] < 0.0lf) {
                                        phi_7956_ = -(_e10633[0]);
                                    } else {
                                        phi_7956_ = _e10633[0];
                                    }
                                    let _e10640 = phi_7956_;
                                    if (_e10633[1] < 0.0lf) {
                                        phi_7963_ = -(_e10633[1]);
                                    } else {
                                        phi_7963_ = _e10633[1];
                                    }
                                    let _e10644 = phi_7963_;
                                    if (_e10640 > _e10644) {
                                        phi_7968_ = _e10640;
                                    } else {
                                        phi_7968_ = _e10644;
                                    }
                                    let _e10647 = phi_7968_;
                                    if (_e10633[2] < 0.0lf) {
                                        phi_7975_ = -(_e10633[2]);
                                    } else {
                                        phi_7975_ = _e10633[2];
                                    }
                                    let _e10651 = phi_7975_;
                                    if (_e10647 > _e10651) {
                                        phi_7980_ = _e10647;
                                    } else {
                                        phi_7980_ = _e10651;
                                    }
                                    let _e10654 = phi_7980_;
                                    let _e10657 = local_18.member_1[1u];
                                    if (_e10657[0] < 0.0lf) {
                                        phi_7994_ = -(_e10657[0]);
                                    } else {
                                        phi_7994_ = _e10657[0];
                                    }
                                    let _e10664 = phi_7994_;
                                    if (_e10657[1] < 0.0lf) {
                                        phi_8001_ = -(_e10657[1]);
                                    } else {
                                        phi_8001_ = _e10657[1];
                                    }
                                    let _e10668 = phi_8001_;
                                    if (_e10664 > _e10668) {
                                        phi_8006_ = _e10664;
                                    } else {
                                        phi_8006_ = _e10668;
                                    }
                                    let _e10671 = phi_8006_;
                                    if (_e10657[2] < 0.0lf) {
                                        phi_8013_ = -(_e10657[2]);
                                    } else {
                                        phi_8013_ = _e10657[2];
                                    }
                                    let _e10675 = phi_8013_;
                                    if (_e10671 > _e10675) {
                                        phi_8018_ = _e10671;
                                    } else {
                                        phi_8018_ = _e10675;
                                    }
                                    let _e10678 = phi_8018_;
                                    if (_e10654 > _e10678) {
                                        phi_8023_ = _e10654;
                                    } else {
                                        phi_8023_ = _e10678;
                                    }
                                    let _e10681 = phi_8023_;
                                    let _e10683 = local_18.member_3;
                                    let _e10687 = local_18.member_2[0u];
                                    if (_e10687[0] < 0.0lf) {
                                        phi_8040_ = -(_e10687[0]);
                                    } else {
                                        phi_8040_ = _e10687[0];
                                    }
                                    let _e10694 = phi_8040_;
                                    if (_e10687[1] < 0.0lf) {
                                        phi_8047_ = -(_e10687[1]);
                                    } else {
                                        phi_8047_ = _e10687[1];
                                    }
                                    let _e10698 = phi_8047_;
                                    if (_e10694 > _e10698) {
                                        phi_8052_ = _e10694;
                                    } else {
                                        phi_8052_ = _e10698;
                                    }
                                    let _e10701 = phi_8052_;
                                    if (_e10687[2] < 0.0lf) {
                                        phi_8059_ = -(_e10687[2]);
                                    } else {
                                        phi_8059_ = _e10687[2];
                                    }
                                    let _e10705 = phi_8059_;
                                    if (_e10701 > _e10705) {
                                        phi_8064_ = _e10701;
                                    } else {
                                        phi_8064_ = _e10705;
                                    }
                                    let _e10708 = phi_8064_;
                                    let _e10711 = local_18.member_2[1u];
                                    if (_e10711[0] < 0.0lf) {
                                        phi_8078_ = -(_e10711[0]);
                                    } else {
                                        phi_8078_ = _e10711[0];
                                    }
                                    let _e10718 = phi_8078_;
                                    if (_e10711[1] < 0.0lf) {
                                        phi_8085_ = -(_e10711[1]);
                                    } else {
                                        phi_8085_ = _e10711[1];
                                    }
                                    let _e10722 = phi_8085_;
                                    if (_e10718 > _e10722) {
                                        phi_8090_ = _e10718;
                                    } else {
                                        phi_8090_ = _e10722;
                                    }
                                    let _e10725 = phi_8090_;
                                    if (_e10711[2] < 0.0lf) {
                                        phi_8097_ = -(_e10711[2]);
                                    } else {
                                        phi_8097_ = _e10711[2];
                                    }
                                    let _e10729 = phi_8097_;
                                    if (_e10725 > _e10729) {
                                        phi_8102_ = _e10725;
                                    } else {
                                        phi_8102_ = _e10729;
                                    }
                                    let _e10732 = phi_8102_;
                                    if (_e10708 > _e10732) {
                                        phi_8107_ = _e10708;
                                    } else {
                                        phi_8107_ = _e10732;
                                    }
                                    let _e10735 = phi_8107_;
                                    let _e10737 = local_18.member_3;
                                    let _e10745 = local_18.member_3;
                                    let _e10755 = (((_e10571 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e10627 + _e10629) + (_e10681 + _e10683)) + (_e10735 + _e10737)) * (1.1102230246251565e-16lf * f64(16f))) + (_e10745 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e820.member_1);
                                    if _e10755 {
                                        phi_8131_ = false;
                                    } else {
                                        phi_8131_ = true;
                                    }
                                    let _e10757 = phi_8131_;
                                    phi_8132_ = _e10757;
                                    phi_8133_ = _e10755;
                                } else {
                                    phi_8132_ = false;
                                    phi_8133_ = false;
                                }
                                let _e10759 = phi_8132_;
                                let _e10761 = phi_8133_;
                                local_63 = _e10761;
                                continue;
                                continuing {
                                    phi_7622_ = _e10425;
                                    break if !(_e10759);
                                }
                            }
                            let _e10764 = local_63;
                            if _e10764 {
                                if (_e10394 > _e543) {
                                    phi_8141_ = 1u;
                                } else {
                                    phi_8141_ = _e10396;
                                }
                                let _e10767 = phi_8141_;
                                phi_8145_ = type_44(type_43(1u, _e10394), _e10767);
                                phi_8146_ = false;
                            } else {
                                phi_8145_ = type_44();
                                phi_8146_ = true;
                            }
                            let _e10771 = phi_8145_;
                            let _e10773 = phi_8146_;
                            if _e10773 {
                                if (_e10394 > _e543) {
                                    phi_8154_ = 0u;
                                } else {
                                    phi_8154_ = _e10396;
                                }
                                let _e10776 = phi_8154_;
                                phi_8158_ = type_44(type_43(2u, _e10394), _e10776);
                            } else {
                                phi_8158_ = _e10771;
                            }
                            let _e10780 = phi_8158_;
                            phi_8159_ = _e10780;
                            phi_8160_ = false;
                            phi_8161_ = false;
                        } else {
                            phi_8159_ = type_44();
                            phi_8160_ = _e10400;
                            phi_8161_ = _e10402;
                        }
                        let _e10782 = phi_8159_;
                        let _e10784 = phi_8160_;
                        let _e10786 = phi_8161_;
                        if _e10784 {
                            phi_8168_ = type_44(type_43(0u, f64()), 0u);
                            phi_8169_ = true;
                        } else {
                            phi_8168_ = _e10372;
                            phi_8169_ = _e10786;
                        }
                        let _e10790 = phi_8168_;
                        let _e10792 = phi_8169_;
                        phi_8173_ = _e10790;
                        phi_8174_ = _e10782;
                        phi_8175_ = _e10792;
                    } else {
                        phi_8173_ = _e6914;
                        phi_8174_ = type_44();
                        phi_8175_ = true;
                    }
                    let _e10794 = phi_8173_;
                    let _e10796 = phi_8174_;
                    let _e10798 = phi_8175_;
                    if _e10798 {
                        phi_8179_ = _e10794;
                    } else {
                        phi_8179_ = _e10796;
                    }
                    let _e10800 = phi_8179_;
                    phi_15846_ = _e10800;
                } else {
                    let _e863 = f64(0f);
                    let _e866 = local_18.member_1[0u];
                    let _e872 = local_18.member_2[0u];
                    let _e878 = ((_e866[1] * _e872[2]) - (_e866[2] * _e872[1]));
                    let _e881 = ((_e866[2] * _e872[0]) - (_e866[0] * _e872[2]));
                    let _e884 = ((_e866[0] * _e872[1]) - (_e866[1] * _e872[0]));
                    let _e887 = local_18.member_1[1u];
                    let _e893 = local_18.member_2[1u];
                    let _e899 = ((_e887[1] * _e893[2]) - (_e887[2] * _e893[1]));
                    let _e902 = ((_e887[2] * _e893[0]) - (_e887[0] * _e893[2]));
                    let _e905 = ((_e887[0] * _e893[1]) - (_e887[1] * _e893[0]));
                    let _e908 = local_18.member_1[0u];
                    let _e914 = local_18.member_2[1u];
                    let _e929 = local_18.member_1[1u];
                    let _e935 = local_18.member_2[0u];
                    let _e948 = (((_e908[1] * _e914[2]) - (_e908[2] * _e914[1])) + ((_e929[1] * _e935[2]) - (_e929[2] * _e935[1])));
                    let _e949 = (((_e908[2] * _e914[0]) - (_e908[0] * _e914[2])) + ((_e929[2] * _e935[0]) - (_e929[0] * _e935[2])));
                    let _e950 = (((_e908[0] * _e914[1]) - (_e908[1] * _e914[0])) + ((_e929[0] * _e935[1]) - (_e929[1] * _e935[0])));
                    let _e953 = local_18.member[0u];
                    let _e961 = (((_e953[0] * _e878) + (_e953[1] * _e881)) + (_e953[2] * _e884));
                    let _e964 = local_18.member[1u];
                    let _e975 = local_18.member[0u];
                    let _e984 = ((((_e964[0] * _e878) + (_e964[1] * _e881)) + (_e964[2] * _e884)) + (((_e975[0] * _e948) + (_e975[1] * _e949)) + (_e975[2] * _e950)));
                    let _e987 = local_18.member[0u];
                    let _e998 = local_18.member[1u];
                    let _e1007 = ((((_e987[0] * _e899) + (_e987[1] * _e902)) + (_e987[2] * _e905)) + (((_e998[0] * _e948) + (_e998[1] * _e949)) + (_e998[2] * _e950)));
                    let _e1010 = local_18.member[1u];
                    let _e1018 = (((_e1010[0] * _e899) + (_e1010[1] * _e902)) + (_e1010[2] * _e905));
                    let _e1021 = local_18.member[0u];
                    if (_e1021[0] < 0.0lf) {
                        phi_8422_ = -(_e1021[0]);
                    } else {
                        phi_8422_ = _e1021[0];
                    }
                    let _e1028 = phi_8422_;
                    if (_e1021[1] < 0.0lf) {
                        phi_8429_ = -(_e1021[1]);
                    } else {
                        phi_8429_ = _e1021[1];
                    }
                    let _e1032 = phi_8429_;
                    if (_e1028 > _e1032) {
                        phi_8434_ = _e1028;
                    } else {
                        phi_8434_ = _e1032;
                    }
                    let _e1035 = phi_8434_;
                    if (_e1021[2] < 0.0lf) {
                        phi_8441_ = -(_e1021[2]);
                    } else {
                        phi_8441_ = _e1021[2];
                    }
                    let _e1039 = phi_8441_;
                    if (_e1035 > _e1039) {
                        phi_8446_ = _e1035;
                    } else {
                        phi_8446_ = _e1039;
                    }
                    let _e1042 = phi_8446_;
                    let _e1045 = local_18.member[1u];
                    if (_e1045[0] < 0.0lf) {
                        phi_8459_ = -(_e1045[0]);
                    } else {
                        phi_8459_ = _e1045[0];
                    }
                    let _e1052 = phi_8459_;
                    if (_e1045[1] < 0.0lf) {
                        phi_8466_ = -(_e1045[1]);
                    } else {
                        phi_8466_ = _e1045[1];
                    }
                    let _e1056 = phi_8466_;
                    if (_e1052 > _e1056) {
                        phi_8471_ = _e1052;
                    } else {
                        phi_8471_ = _e1056;
                    }
                    let _e1059 = phi_8471_;
                    if (_e1045[2] < 0.0lf) {
                        phi_8478_ = -(_e1045[2]);
                    } else {
                        phi_8478_ = _e1045[2];
                    }
                    let _e1063 = phi_8478_;
                    if (_e1059 > _e1063) {
                        phi_8483_ = _e1059;
                    } else {
                        phi_8483_ = _e1063;
                    }
                    let _e1066 = phi_8483_;
                    if (_e1042 > _e1066) {
                        phi_8488_ = _e1042;
                    } else {
                        phi_8488_ = _e1066;
                    }
                    let _e1069 = phi_8488_;
                    let _e1071 = local_18.member_3;
                    let _e1072 = (_e1069 + _e1071);
                    let _e1075 = local_18.member_1[0u];
                    if (_e1075[0] < 0.0lf) {
                        phi_8505_ = -(_e1075[0]);
                    } else {
                        phi_8505_ = _e1075[0];
                    }
                    let _e1082 = phi_8505_;
                    if (_e1075[1] < 0.0lf) {
                        phi_8512_ = -(_e1075[1]);
                    } else {
                        phi_8512_ = _e1075[1];
                    }
                    let _e1086 = phi_8512_;
                    if (_e1082 > _e1086) {
                        phi_8517_ = _e1082;
                    } else {
                        phi_8517_ = _e1086;
                    }
                    let _e1089 = phi_8517_;
                    if (_e1075[2] < 0.0lf) {
                        phi_8524_ = -(_e1075[2]);
                    } else {
                        phi_8524_ = _e1075[2];
                    }
                    let _e1093 = phi_8524_;
                    if (_e1089 > _e1093) {
                        phi_8529_ = _e1089;
                    } else {
                        phi_8529_ = _e1093;
                    }
                    let _e1096 = phi_8529_;
                    let _e1099 = local_18.member_1[1u];
                    if (_e1099[0] < 0.0lf) {
                        phi_8543_ = -(_e1099[0]);
                    } else {
                        phi_8543_ = _e1099[0];
                    }
                    let _e1106 = phi_8543_;
                    if (_e1099[1] < 0.0lf) {
                        phi_8550_ = -(_e1099[1]);
                    } else {
                        phi_8550_ = _e1099[1];
                    }
                    let _e1110 = phi_8550_;
                    if (_e1106 > _e1110) {
                        phi_8555_ = _e1106;
                    } else {
                        phi_8555_ = _e1110;
                    }
                    let _e1113 = phi_8555_;
                    if (_e1099[2] < 0.0lf) {
                        phi_8562_ = -(_e1099[2]);
                    } else {
                        phi_8562_ = _e1099[2];
                    }
                    let _e1117 = phi_8562_;
                    if (_e1113 > _e1117) {
                        phi_8567_ = _e1113;
                    } else {
                        phi_8567_ = _e1117;
                    }
                    let _e1120 = phi_8567_;
                    if (_e1096 > _e1120) {
                        phi_8572_ = _e1096;
                    } else {
                        phi_8572_ = _e1120;
                    }
                    let _e1123 = phi_8572_;
                    let _e1125 = local_18.member_3;
                    let _e1126 = (_e1123 + _e1125);
                    let _e1129 = local_18.member_2[0u];
                    if (_e1129[0] < 0.0lf) {
                        phi_8589_ = -(_e1129[0]);
                    } else {
                        phi_8589_ = _e1129[0];
                    }
                    let _e1136 = phi_8589_;
                    if (_e1129[1] < 0.0lf) {
                        phi_8596_ = -(_e1129[1]);
                    } else {
                        phi_8596_ = _e1129[1];
                    }
                    let _e1140 = phi_8596_;
                    if (_e1136 > _e1140) {
                        phi_8601_ = _e1136;
                    } else {
                        phi_8601_ = _e1140;
                    }
                    let _e1143 = phi_8601_;
                    if (_e1129[2] < 0.0lf) {
                        phi_8608_ = -(_e1129[2]);
                    } else {
                        phi_8608_ = _e1129[2];
                    }
                    let _e1147 = phi_8608_;
                    if (_e1143 > _e1147) {
                        phi_8613_ = _e1143;
                    } else {
                        phi_8613_ = _e1147;
                    }
                    let _e1150 = phi_8613_;
                    let _e1153 = local_18.member_2[1u];
                    if (_e1153[0] < 0.0lf) {
                        phi_8627_ = -(_e1153[0]);
                    } else {
                        phi_8627_ = _e1153[0];
                    }
                    let _e1160 = phi_8627_;
                    if (_e1153[1] < 0.0lf) {
                        phi_8634_ = -(_e1153[1]);
                    } else {
                        phi_8634_ = _e1153[1];
                    }
                    let _e1164 = phi_8634_;
                    if (_e1160 > _e1164) {
                        phi_8639_ = _e1160;
                    } else {
                        phi_8639_ = _e1164;
                    }
                    let _e1167 = phi_8639_;
                    if (_e1153[2] < 0.0lf) {
                        phi_8646_ = -(_e1153[2]);
                    } else {
                        phi_8646_ = _e1153[2];
                    }
                    let _e1171 = phi_8646_;
                    if (_e1167 > _e1171) {
                        phi_8651_ = _e1167;
                    } else {
                        phi_8651_ = _e1171;
                    }
                    let _e1174 = phi_8651_;
                    if (_e1150 > _e1174) {
                        phi_8656_ = _e1150;
                    } else {
                        phi_8656_ = _e1174;
                    }
                    let _e1177 = phi_8656_;
                    let _e1179 = local_18.member_3;
                    let _e1180 = (_e1177 + _e1179);
                    let _e1181 = f64(1f);
                    let _e1182 = f64(8f);
                    let _e1184 = ((_e1126 * _e1182) * _e1180);
                    let _e1192 = local_18.member_3;
                    if (_e878 < 0.0lf) {
                        phi_8693_ = -(_e878);
                    } else {
                        phi_8693_ = _e878;
                    }
                    let _e1212 = phi_8693_;
                    if (_e881 < 0.0lf) {
                        phi_8699_ = -(_e881);
                    } else {
                        phi_8699_ = _e881;
                    }
                    let _e1216 = phi_8699_;
                    if (_e884 < 0.0lf) {
                        phi_8706_ = -(_e884);
                    } else {
                        phi_8706_ = _e884;
                    }
                    let _e1221 = phi_8706_;
                    let _e1222 = ((_e1212 + _e1216) + _e1221);
                    if (_e899 < 0.0lf) {
                        phi_8713_ = -(_e899);
                    } else {
                        phi_8713_ = _e899;
                    }
                    let _e1226 = phi_8713_;
                    if (_e902 < 0.0lf) {
                        phi_8719_ = -(_e902);
                    } else {
                        phi_8719_ = _e902;
                    }
                    let _e1230 = phi_8719_;
                    if (_e905 < 0.0lf) {
                        phi_8726_ = -(_e905);
                    } else {
                        phi_8726_ = _e905;
                    }
                    let _e1235 = phi_8726_;
                    let _e1236 = ((_e1226 + _e1230) + _e1235);
                    if (_e1222 > _e1236) {
                        phi_8732_ = _e1222;
                    } else {
                        phi_8732_ = _e1236;
                    }
                    let _e1239 = phi_8732_;
                    if (_e948 < 0.0lf) {
                        phi_8738_ = -(_e948);
                    } else {
                        phi_8738_ = _e948;
                    }
                    let _e1243 = phi_8738_;
                    if (_e949 < 0.0lf) {
                        phi_8744_ = -(_e949);
                    } else {
                        phi_8744_ = _e949;
                    }
                    let _e1247 = phi_8744_;
                    if (_e950 < 0.0lf) {
                        phi_8751_ = -(_e950);
                    } else {
                        phi_8751_ = _e950;
                    }
                    let _e1252 = phi_8751_;
                    let _e1254 = (((_e1243 + _e1247) + _e1252) * f64(0.5f));
                    if (_e1239 > _e1254) {
                        phi_8758_ = _e1239;
                    } else {
                        phi_8758_ = _e1254;
                    }
                    let _e1257 = phi_8758_;
                    let _e1263 = local_18.member_3;
                    let _e1277 = (((((_e1072 * _e1182) * _e1184) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1192 * f64(19f)) * ((_e1072 * (_e1126 + _e1180)) + (_e1126 * _e1180)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1181 + _e1072) * ((_e1181 + _e1126) * (_e1181 + _e1180)))));
                    let _e1278 = f64(3f);
                    let _e1279 = (_e961 * _e1278);
                    let _e1280 = (_e1018 * _e1278);
                    if (_e1279 < _e1280) {
                        phi_8786_ = _e1279;
                    } else {
                        phi_8786_ = _e1280;
                    }
                    let _e1283 = phi_8786_;
                    if (_e984 < _e1007) {
                        phi_8791_ = _e984;
                    } else {
                        phi_8791_ = _e1007;
                    }
                    let _e1286 = phi_8791_;
                    if (_e1283 < _e1286) {
                        phi_8796_ = _e1283;
                    } else {
                        phi_8796_ = _e1286;
                    }
                    let _e1289 = phi_8796_;
                    if (_e1279 > _e1280) {
                        phi_8801_ = _e1279;
                    } else {
                        phi_8801_ = _e1280;
                    }
                    let _e1292 = phi_8801_;
                    if (_e984 > _e1007) {
                        phi_8806_ = _e984;
                    } else {
                        phi_8806_ = _e1007;
                    }
                    let _e1295 = phi_8806_;
                    if (_e1292 > _e1295) {
                        phi_8811_ = _e1292;
                    } else {
                        phi_8811_ = _e1295;
                    }
                    let _e1298 = phi_8811_;
                    let _e1304 = -(_e1298);
                    if (_e1289 > _e1304) {
                        phi_8822_ = _e1289;
                    } else {
                        phi_8822_ = _e1304;
                    }
                    let _e1307 = phi_8822_;
                    if ((_e1307 - (_e1277 + ((_e863 * (((_e1257 + (_e1184 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1263 * f64(6f)) * (_e1126 + _e1180))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1181 + _e1126) * (_e1181 + _e1180))))) * f64((3f * 1.0001f))))) > _e863) {
                        phi_15816_ = type_43(0u, type_43().member_1);
                        phi_15817_ = type_43();
                        phi_15818_ = true;
                    } else {
                        if (_e961 < 0.0lf) {
                            phi_8836_ = -(_e961);
                        } else {
                            phi_8836_ = _e961;
                        }
                        let _e1315 = phi_8836_;
                        if (_e984 < 0.0lf) {
                            phi_8842_ = -(_e984);
                        } else {
                            phi_8842_ = _e984;
                        }
                        let _e1319 = phi_8842_;
                        if (_e1315 > _e1319) {
                            phi_8847_ = _e1315;
                        } else {
                            phi_8847_ = _e1319;
                        }
                        let _e1322 = phi_8847_;
                        if (_e1007 < 0.0lf) {
                            phi_8853_ = -(_e1007);
                        } else {
                            phi_8853_ = _e1007;
                        }
                        let _e1326 = phi_8853_;
                        if (_e1018 < 0.0lf) {
                            phi_8859_ = -(_e1018);
                        } else {
                            phi_8859_ = _e1018;
                        }
                        let _e1330 = phi_8859_;
                        if (_e1326 > _e1330) {
                            phi_8864_ = _e1326;
                        } else {
                            phi_8864_ = _e1330;
                        }
                        let _e1333 = phi_8864_;
                        if (_e1322 > _e1333) {
                            phi_8869_ = _e1322;
                        } else {
                            phi_8869_ = _e1333;
                        }
                        let _e1336 = phi_8869_;
                        let _e1338 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1339 = f64(1f);
                        if (_e1336 >= _e1338) {
                            phi_8879_ = (_e1336 <= (_e1339 / _e1338));
                        } else {
                            phi_8879_ = false;
                        }
                        let _e1344 = phi_8879_;
                        if _e1344 {
                            phi_8886_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_8886_ = f64(2f);
                        }
                        let _e1349 = phi_8886_;
                        let _e1351 = ((_e1277 * f64(0.34f)) + (_e1336 * _e1349));
                        if _e1344 {
                            phi_8894_ = (_e1339 / _e1336);
                        } else {
                            phi_8894_ = f64(0f);
                        }
                        let _e1355 = phi_8894_;
                        let _e1356 = f64(0.00000000000022737368f);
                        let _e1358 = (_e534 * f64(0.0625f));
                        if (_e1356 < _e1358) {
                            phi_8902_ = _e1356;
                        } else {
                            phi_8902_ = _e1358;
                        }
                        let _e1361 = phi_8902_;
                        let _e1363 = (f64(1f) - _e543);
                        let _e1374 = ((((_e961 * _e1363) + (_e984 * _e543)) * (_e1363 * _e1363)) + (((_e1007 * _e1363) + (_e1018 * _e543)) * (_e543 * _e543)));
                        if (_e1374 < 0.0lf) {
                            phi_8921_ = -(_e1374);
                        } else {
                            phi_8921_ = _e1374;
                        }
                        let _e1378 = phi_8921_;
                        if !((_e1378 > _e1351)) {
                            let _e1381 = f64(0f);
                            let _e1384 = local_18.member[0u];
                            let _e1391 = local_18.member_1[0u];
                            let _e1397 = local_18.member_2[0u];
                            let _e1401 = (_e1384[0] - _e1391[0]);
                            let _e1402 = (_e1384[1] - _e1391[1]);
                            let _e1403 = (_e1384[2] - _e1391[2]);
                            if (_e247.member == 0u) {
                                phi_8983_ = array<f64, 3>(_e1384[0], _e1384[1], _e1384[2]);
                            } else {
                                phi_8983_ = array<f64, 3>((_e1401 - _e1397[0]), (_e1402 - _e1397[1]), (_e1403 - _e1397[2]));
                            }
                            let _e1410 = phi_8983_;
                            let _e1411 = (_e1384[0] - _e1397[0]);
                            let _e1412 = (_e1384[1] - _e1397[1]);
                            let _e1413 = (_e1384[2] - _e1397[2]);
                            let _e1416 = local_18.member[1u];
                            let _e1423 = local_18.member_1[1u];
                            let _e1429 = local_18.member_2[1u];
                            let _e1433 = (_e1416[0] - _e1423[0]);
                            let _e1434 = (_e1416[1] - _e1423[1]);
                            let _e1435 = (_e1416[2] - _e1423[2]);
                            if (_e247.member == 0u) {
                                phi_9048_ = array<f64, 3>(_e1416[0], _e1416[1], _e1416[2]);
                            } else {
                                phi_9048_ = array<f64, 3>((_e1433 - _e1429[0]), (_e1434 - _e1429[1]), (_e1435 - _e1429[2]));
                            }
                            let _e1442 = phi_9048_;
                            let _e1443 = (_e1416[0] - _e1429[0]);
                            let _e1444 = (_e1416[1] - _e1429[1]);
                            let _e1445 = (_e1416[2] - _e1429[2]);
                            let _e1448 = local_18.member[0u];
                            if (_e1448[0] < 0.0lf) {
                                phi_9070_ = -(_e1448[0]);
                            } else {
                                phi_9070_ = _e1448[0];
                            }
                            let _e1455 = phi_9070_;
                            if (_e1448[1] < 0.0lf) {
                                phi_9077_ = -(_e1448[1]);
                            } else {
                                phi_9077_ = _e1448[1];
                            }
                            let _e1459 = phi_9077_;
                            if (_e1455 > _e1459) {
                                phi_9082_ = _e1455;
                            } else {
                                phi_9082_ = _e1459;
                            }
                            let _e1462 = phi_9082_;
                            if (_e1448[2] < 0.0lf) {
                                phi_9089_ = -(_e1448[2]);
                            } else {
                                phi_9089_ = _e1448[2];
                            }
                            let _e1466 = phi_9089_;
                            if (_e1462 > _e1466) {
                                phi_9094_ = _e1462;
                            } else {
                                phi_9094_ = _e1466;
                            }
                            let _e1469 = phi_9094_;
                            let _e1472 = local_18.member[1u];
                            if (_e1472[0] < 0.0lf) {
                                phi_9107_ = -(_e1472[0]);
                            } else {
                                phi_9107_ = _e1472[0];
                            }
                            let _e1479 = phi_9107_;
                            if (_e1472[1] < 0.0lf) {
                                phi_9114_ = -(_e1472[1]);
                            } else {
                                phi_9114_ = _e1472[1];
                            }
                            let _e1483 = phi_9114_;
                            if (_e1479 > _e1483) {
                                phi_9119_ = _e1479;
                            } else {
                                phi_9119_ = _e1483;
                            }
                            let _e1486 = phi_9119_;
                            if (_e1472[2] < 0.0lf) {
                                phi_9126_ = -(_e1472[2]);
                            } else {
                                phi_9126_ = _e1472[2];
                            }
                            let _e1490 = phi_9126_;
                            if (_e1486 > _e1490) {
                                phi_9131_ = _e1486;
                            } else {
                                phi_9131_ = _e1490;
                            }
                            let _e1493 = phi_9131_;
                            if (_e1469 > _e1493) {
                                phi_9136_ = _e1469;
                            } else {
                                phi_9136_ = _e1493;
                            }
                            let _e1496 = phi_9136_;
                            let _e1498 = local_18.member_3;
                            let _e1502 = local_18.member_1[0u];
                            if (_e1502[0] < 0.0lf) {
                                phi_9153_ = -(_e1502[0]);
                            } else {
                                phi_9153_ = _e1502[0];
                            }
                            let _e1509 = phi_9153_;
                            if (_e1502[1] < 0.0lf) {
                                phi_9160_ = -(_e1502[1]);
                            } else {
                                phi_9160_ = _e1502[1];
                            }
                            let _e1513 = phi_9160_;
                            if (_e1509 > _e1513) {
                                phi_9165_ = _e1509;
                            } else {
                                phi_9165_ = _e1513;
                            }
                            let _e1516 = phi_9165_;
                            if (_e1502[2] < 0.0lf) {
                                phi_9172_ = -(_e1502[2]);
                            } else {
                                phi_9172_ = _e1502[2];
                            }
                            let _e1520 = phi_9172_;
                            if (_e1516 > _e1520) {
                                phi_9177_ = _e1516;
                            } else {
                                phi_9177_ = _e1520;
                            }
                            let _e1523 = phi_9177_;
                            let _e1526 = local_18.member_1[1u];
                            if (_e1526[0] < 0.0lf) {
                                phi_9191_ = -(_e1526[0]);
                            } else {
                                phi_9191_ = _e1526[0];
                            }
                            let _e1533 = phi_9191_;
                            if (_e1526[1] < 0.0lf) {
                                phi_9198_ = -(_e1526[1]);
                            } else {
                                phi_9198_ = _e1526[1];
                            }
                            let _e1537 = phi_9198_;
                            if (_e1533 > _e1537) {
                                phi_9203_ = _e1533;
                            } else {
                                phi_9203_ = _e1537;
                            }
                            let _e1540 = phi_9203_;
                            if (_e1526[2] < 0.0lf) {
                                phi_9210_ = -(_e1526[2]);
                            } else {
                                phi_9210_ = _e1526[2];
                            }
                            let _e1544 = phi_9210_;
                            if (_e1540 > _e1544) {
                                phi_9215_ = _e1540;
                            } else {
                                phi_9215_ = _e1544;
                            }
                            let _e1547 = phi_9215_;
                            if (_e1523 > _e1547) {
                                phi_9220_ = _e1523;
                            } else {
                                phi_9220_ = _e1547;
                            }
                            let _e1550 = phi_9220_;
                            let _e1552 = local_18.member_3;
                            let _e1556 = local_18.member_2[0u];
                            if (_e1556[0] < 0.0lf) {
                                phi_9237_ = -(_e1556[0]);
                            } else {
                                phi_9237_ = _e1556[0];
                            }
                            let _e1563 = phi_9237_;
                            if (_e1556[1] < 0.0lf) {
                                phi_9244_ = -(_e1556[1]);
                            } else {
                                phi_9244_ = _e1556[1];
                            }
                            let _e1567 = phi_9244_;
                            if (_e1563 > _e1567) {
                                phi_9249_ = _e1563;
                            } else {
                                phi_9249_ = _e1567;
                            }
                            let _e1570 = phi_9249_;
                            if (_e1556[2] < 0.0lf) {
                                phi_9256_ = -(_e1556[2]);
                            } else {
                                phi_9256_ = _e1556[2];
                            }
                            let _e1574 = phi_9256_;
                            if (_e1570 > _e1574) {
                                phi_9261_ = _e1570;
                            } else {
                                phi_9261_ = _e1574;
                            }
                            let _e1577 = phi_9261_;
                            let _e1580 = local_18.member_2[1u];
                            if (_e1580[0] < 0.0lf) {
                                phi_9275_ = -(_e1580[0]);
                            } else {
                                phi_9275_ = _e1580[0];
                            }
                            let _e1587 = phi_9275_;
                            if (_e1580[1] < 0.0lf) {
                                phi_9282_ = -(_e1580[1]);
                            } else {
                                phi_9282_ = _e1580[1];
                            }
                            let _e1591 = phi_9282_;
                            if (_e1587 > _e1591) {
                                phi_9287_ = _e1587;
                            } else {
                                phi_9287_ = _e1591;
                            }
                            let _e1594 = phi_9287_;
                            if (_e1580[2] < 0.0lf) {
                                phi_9294_ = -(_e1580[2]);
                            } else {
                                phi_9294_ = _e1580[2];
                            }
                            let _e1598 = phi_9294_;
                            if (_e1594 > _e1598) {
                                phi_9299_ = _e1594;
                            } else {
                                phi_9299_ = _e1598;
                            }
                            let _e1601 = phi_9299_;
                            if (_e1577 > _e1601) {
                                phi_9304_ = _e1577;
                            } else {
                                phi_9304_ = _e1601;
                            }
                            let _e1604 = phi_9304_;
                            let _e1606 = local_18.member_3;
                            let _e1614 = local_18.member_3;
                            let _e1620 = ((((((_e1496 + _e1498) + (_e1550 + _e1552)) + (_e1604 + _e1606)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1614 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f)));
                            let _e1623 = local_18.member[0u];
                            let _e1629 = local_18.member[1u];
                            let _e1645 = local_18.member_1[0u];
                            let _e1651 = local_18.member_1[1u];
                            let _e1667 = local_18.member_2[0u];
                            let _e1673 = local_18.member_2[1u];
                            let _e1687 = function_4(array<f64, 3>((_e1623[0] + ((_e1629[0] - _e1623[0]) * _e543)), (_e1623[1] + ((_e1629[1] - _e1623[1]) * _e543)), (_e1623[2] + ((_e1629[2] - _e1623[2]) * _e543))), array<f64, 3>((_e1645[0] + ((_e1651[0] - _e1645[0]) * _e543)), (_e1645[1] + ((_e1651[1] - _e1645[1]) * _e543)), (_e1645[2] + ((_e1651[2] - _e1645[2]) * _e543))), array<f64, 3>((_e1667[0] + ((_e1673[0] - _e1667[0]) * _e543)), (_e1667[1] + ((_e1673[1] - _e1667[1]) * _e543)), (_e1667[2] + ((_e1673[2] - _e1667[2]) * _e543))), _e247.member);
                            if (_e1687[0] < 0.0lf) {
                                phi_9425_ = -(_e1687[0]);
                            } else {
                                phi_9425_ = _e1687[0];
                            }
                            let _e1692 = phi_9425_;
                            if (_e1687[1] < 0.0lf) {
                                phi_9432_ = -(_e1687[1]);
                            } else {
                                phi_9432_ = _e1687[1];
                            }
                            let _e1697 = phi_9432_;
                            if (_e1687[2] < 0.0lf) {
                                phi_9440_ = -(_e1687[2]);
                            } else {
                                phi_9440_ = _e1687[2];
                            }
                            let _e1703 = phi_9440_;
                            let _e1704 = ((_e1692 + _e1697) + _e1703);
                            if (_e1704 > f64(0f)) {
                                if ((bitcast<u64>(_e1704) & 9218868437227405312lu) != 9218868437227405312lu) {
                                    let _e1711 = (f64(1f) / _e1704);
                                    let _e1713 = (_e1687[0] * _e1711);
                                    let _e1715 = (_e1687[1] * _e1711);
                                    let _e1717 = (_e1687[2] * _e1711);
                                    let _e1722 = (((_e1713 * _e1713) + (_e1715 * _e1715)) + (_e1717 * _e1717));
                                    if (_e1722 <= 2.2250738585072014e-308lf) {
                                        if (_e1722 > 0.0lf) {
                                            phi_9479_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_9479_ = 0.0lf;
                                        }
                                        let _e1774 = phi_9479_;
                                        phi_9543_ = _e1774;
                                    } else {
                                        phi_9486_ = type_18(0i, 5i);
                                        phi_9489_ = bitcast<f64>(((bitcast<u64>(_e1722) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1729 = phi_9486_;
                                            let _e1731 = phi_9489_;
                                            local_19 = _e1731;
                                            if (_e1729.member < _e1729.member_1) {
                                                let _e1738 = (_e1729.member + 1i);
                                                if ((false == (_e1738 > _e1729.member)) != false) {
                                                    phi_9510_ = true;
                                                } else {
                                                    phi_9510_ = false;
                                                }
                                                let _e1743 = phi_9510_;
                                                if _e1743 {
                                                    phi_9516_ = type_19(0u, type_19().member_1);
                                                } else {
                                                    phi_9516_ = type_19(1u, _e1738);
                                                }
                                                let _e1748 = phi_9516_;
                                                phi_9487_ = type_18(_e1748.member_1, _e1729.member_1);
                                                phi_9530_ = type_19(1u, _e1729.member);
                                            } else {
                                                phi_9487_ = _e1729;
                                                phi_9530_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1754 = phi_9487_;
                                            let _e1756 = phi_9530_;
                                            let _e1759 = (bitcast<i32>(_e1756.member) != 0i);
                                            if _e1759 {
                                                phi_9490_ = (0.5lf * (_e1731 + (_e1722 / _e1731)));
                                            } else {
                                                phi_9490_ = f64();
                                            }
                                            let _e1764 = phi_9490_;
                                            continue;
                                            continuing {
                                                phi_9486_ = _e1754;
                                                phi_9489_ = _e1764;
                                                break if !(_e1759);
                                            }
                                        }
                                        let _e1769 = local_19;
                                        phi_9543_ = (_e1769 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1776 = phi_9543_;
                                    let _e1778 = (1.1102230246251565e-16lf * f64(12f));
                                    let _e1785 = ((_e1620 * f64(1.01f)) + ((_e1381 * _e1776) * (f64(1f) + _e1778)));
                                    let _e1790 = (((_e1713 * _e1384[0]) + (_e1715 * _e1384[1])) + (_e1717 * _e1384[2]));
                                    let _e1795 = (((_e1713 * _e1401) + (_e1715 * _e1402)) + (_e1717 * _e1403));
                                    let _e1800 = (((_e1713 * _e1411) + (_e1715 * _e1412)) + (_e1717 * _e1413));
                                    let _e1808 = (((_e1713 * _e1410[0]) + (_e1715 * _e1410[1])) + (_e1717 * _e1410[2]));
                                    let _e1814 = (((_e1713 * _e1416[0]) + (_e1715 * _e1416[1])) + (_e1717 * _e1416[2]));
                                    let _e1819 = (((_e1713 * _e1433) + (_e1715 * _e1434)) + (_e1717 * _e1435));
                                    let _e1824 = (((_e1713 * _e1443) + (_e1715 * _e1444)) + (_e1717 * _e1445));
                                    let _e1832 = (((_e1713 * _e1442[0]) + (_e1715 * _e1442[1])) + (_e1717 * _e1442[2]));
                                    if (_e1790 < 0.0lf) {
                                        phi_9612_ = -(_e1790);
                                    } else {
                                        phi_9612_ = _e1790;
                                    }
                                    let _e1837 = phi_9612_;
                                    if (_e1814 < 0.0lf) {
                                        phi_9618_ = -(_e1814);
                                    } else {
                                        phi_9618_ = _e1814;
                                    }
                                    let _e1841 = phi_9618_;
                                    if (_e1795 < 0.0lf) {
                                        phi_9627_ = -(_e1795);
                                    } else {
                                        phi_9627_ = _e1795;
                                    }
                                    let _e1848 = phi_9627_;
                                    if (_e1819 < 0.0lf) {
                                        phi_9633_ = -(_e1819);
                                    } else {
                                        phi_9633_ = _e1819;
                                    }
                                    let _e1852 = phi_9633_;
                                    if (_e1800 < 0.0lf) {
                                        phi_9642_ = -(_e1800);
                                    } else {
                                        phi_9642_ = _e1800;
                                    }
                                    let _e1859 = phi_9642_;
                                    if (_e1824 < 0.0lf) {
                                        phi_9648_ = -(_e1824);
                                    } else {
                                        phi_9648_ = _e1824;
                                    }
                                    let _e1863 = phi_9648_;
                                    if (_e1808 < 0.0lf) {
                                        phi_9657_ = -(_e1808);
                                    } else {
                                        phi_9657_ = _e1808;
                                    }
                                    let _e1870 = phi_9657_;
                                    if (_e1832 < 0.0lf) {
                                        phi_9663_ = -(_e1832);
                                    } else {
                                        phi_9663_ = _e1832;
                                    }
                                    let _e1874 = phi_9663_;
                                    phi_9669_ = type_35(array<f64, 4>(_e1790, _e1795, _e1800, _e1808), array<f64, 4>(_e1814, _e1819, _e1824, _e1832), array<f64, 4>((_e1785 + ((_e1837 + _e1841) * _e1778)), (_e1785 + ((_e1848 + _e1852) * _e1778)), (_e1785 + ((_e1859 + _e1863) * _e1778)), (_e1785 + ((_e1870 + _e1874) * _e1778))));
                                    phi_9670_ = false;
                                } else {
                                    phi_9669_ = type_35();
                                    phi_9670_ = true;
                                }
                                let _e1881 = phi_9669_;
                                let _e1883 = phi_9670_;
                                phi_9671_ = _e1881;
                                phi_9672_ = _e1883;
                            } else {
                                phi_9671_ = type_35();
                                phi_9672_ = true;
                            }
                            let _e1885 = phi_9671_;
                            let _e1887 = phi_9672_;
                            if _e1887 {
                                let _e1888 = f64(0f);
                                let _e1889 = f64(1f);
                                phi_9682_ = type_35(array<f64, 4>(_e1888, _e1888, _e1888, _e1888), array<f64, 4>(_e1888, _e1888, _e1888, _e1888), array<f64, 4>(_e1889, _e1889, _e1889, _e1889));
                            } else {
                                phi_9682_ = _e1885;
                            }
                            let _e1895 = phi_9682_;
                            local_8 = type_35(array<f64, 4>(_e1895.member[0], _e1895.member[1], _e1895.member[2], _e1895.member[3]), array<f64, 4>(_e1895.member_1[0], _e1895.member_1[1], _e1895.member_1[2], _e1895.member_1[3]), array<f64, 4>(_e1895.member_2[0], _e1895.member_2[1], _e1895.member_2[2], _e1895.member_2[3]));
                            let _e1915 = f64(0f);
                            let _e1918 = local_8.member[0u];
                            let _e1921 = local_8.member_1[0u];
                            let _e1924 = local_8.member[0u];
                            let _e1930 = local_8.member_2[0u];
                            if (((_e1918 + ((_e1921 - _e1924) * _e543)) - _e1930) > _e1915) {
                                let _e1935 = local_8.member[1u];
                                let _e1938 = local_8.member_1[1u];
                                let _e1941 = local_8.member[1u];
                                let _e1947 = local_8.member_2[1u];
                                if (((_e1935 + ((_e1938 - _e1941) * _e543)) - _e1947) > _e1915) {
                                    let _e1952 = local_8.member[2u];
                                    let _e1955 = local_8.member_1[2u];
                                    let _e1958 = local_8.member[2u];
                                    let _e1964 = local_8.member_2[2u];
                                    if (((_e1952 + ((_e1955 - _e1958) * _e543)) - _e1964) > _e1915) {
                                        let _e1969 = local_8.member[3u];
                                        let _e1972 = local_8.member_1[3u];
                                        let _e1975 = local_8.member[3u];
                                        let _e1981 = local_8.member_2[3u];
                                        phi_9852_ = (((_e1969 + ((_e1972 - _e1975) * _e543)) - _e1981) > _e1915);
                                        phi_9853_ = false;
                                    } else {
                                        phi_9852_ = bool();
                                        phi_9853_ = true;
                                    }
                                    let _e1985 = phi_9852_;
                                    let _e1987 = phi_9853_;
                                    phi_9854_ = _e1985;
                                    phi_9855_ = _e1987;
                                } else {
                                    phi_9854_ = bool();
                                    phi_9855_ = true;
                                }
                                let _e1989 = phi_9854_;
                                let _e1991 = phi_9855_;
                                phi_9856_ = _e1989;
                                phi_9857_ = _e1991;
                            } else {
                                phi_9856_ = bool();
                                phi_9857_ = true;
                            }
                            let _e1993 = phi_9856_;
                            let _e1995 = phi_9857_;
                            if _e1995 {
                                phi_9861_ = false;
                            } else {
                                phi_9861_ = _e1993;
                            }
                            let _e1997 = phi_9861_;
                            if _e1997 {
                                phi_11242_ = bool();
                                phi_11243_ = true;
                            } else {
                                let _e1998 = f64(0f);
                                if (_e1687[0] < 0.0lf) {
                                    phi_9889_ = -(_e1687[0]);
                                } else {
                                    phi_9889_ = _e1687[0];
                                }
                                let _e2003 = phi_9889_;
                                if (_e1998 < 0.0lf) {
                                    phi_9895_ = -(_e1998);
                                } else {
                                    phi_9895_ = _e1998;
                                }
                                let _e2007 = phi_9895_;
                                if (_e1998 < 0.0lf) {
                                    phi_9902_ = -(_e1998);
                                } else {
                                    phi_9902_ = _e1998;
                                }
                                let _e2012 = phi_9902_;
                                let _e2013 = ((_e2003 + _e2007) + _e2012);
                                if (_e2013 > f64(0f)) {
                                    if ((bitcast<u64>(_e2013) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e2020 = (f64(1f) / _e2013);
                                        let _e2021 = (_e1687[0] * _e2020);
                                        let _e2022 = (_e1998 * _e2020);
                                        let _e2023 = (_e1998 * _e2020);
                                        let _e2028 = (((_e2021 * _e2021) + (_e2022 * _e2022)) + (_e2023 * _e2023));
                                        if (_e2028 <= 2.2250738585072014e-308lf) {
                                            if (_e2028 > 0.0lf) {
                                                phi_9938_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_9938_ = 0.0lf;
                                            }
                                            let _e2080 = phi_9938_;
                                            phi_10002_ = _e2080;
                                        } else {
                                            phi_9945_ = type_18(0i, 5i);
                                            phi_9948_ = bitcast<f64>(((bitcast<u64>(_e2028) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e2035 = phi_9945_;
                                                let _e2037 = phi_9948_;
                                                local_20 = _e2037;
                                                if (_e2035.member < _e2035.member_1) {
                                                    let _e2044 = (_e2035.member + 1i);
                                                    if ((false == (_e2044 > _e2035.member)) != false) {
                                                        phi_9969_ = true;
                                                    } else {
                                                        phi_9969_ = false;
                                                    }
                                                    let _e2049 = phi_9969_;
                                                    if _e2049 {
                                                        phi_9975_ = type_19(0u, type_19().member_1);
                                                    } else {
                                                        phi_9975_ = type_19(1u, _e2044);
                                                    }
                                                    let _e2054 = phi_9975_;
                                                    phi_9946_ = type_18(_e2054.member_1, _e2035.member_1);
                                                    phi_9989_ = type_19(1u, _e2035.member);
                                                } else {
                                                    phi_9946_ = _e2035;
                                                    phi_9989_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2060 = phi_9946_;
                                                let _e2062 = phi_9989_;
                                                let _e2065 = (bitcast<i32>(_e2062.member) != 0i);
                                                if _e2065 {
                                                    phi_9949_ = (0.5lf * (_e2037 + (_e2028 / _e2037)));
                                                } else {
                                                    phi_9949_ = f64();
                                                }
                                                let _e2070 = phi_9949_;
                                                continue;
                                                continuing {
                                                    phi_9945_ = _e2060;
                                                    phi_9948_ = _e2070;
                                                    break if !(_e2065);
                                                }
                                            }
                                            let _e2075 = local_20;
                                            phi_10002_ = (_e2075 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e2082 = phi_10002_;
                                        let _e2084 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e2091 = ((_e1620 * f64(1.01f)) + ((_e1381 * _e2082) * (f64(1f) + _e2084)));
                                        let _e2096 = (((_e2021 * _e1384[0]) + (_e2022 * _e1384[1])) + (_e2023 * _e1384[2]));
                                        let _e2101 = (((_e2021 * _e1401) + (_e2022 * _e1402)) + (_e2023 * _e1403));
                                        let _e2106 = (((_e2021 * _e1411) + (_e2022 * _e1412)) + (_e2023 * _e1413));
                                        let _e2114 = (((_e2021 * _e1410[0]) + (_e2022 * _e1410[1])) + (_e2023 * _e1410[2]));
                                        let _e2120 = (((_e2021 * _e1416[0]) + (_e2022 * _e1416[1])) + (_e2023 * _e1416[2]));
                                        let _e2125 = (((_e2021 * _e1433) + (_e2022 * _e1434)) + (_e2023 * _e1435));
                                        let _e2130 = (((_e2021 * _e1443) + (_e2022 * _e1444)) + (_e2023 * _e1445));
                                        let _e2138 = (((_e2021 * _e1442[0]) + (_e2022 * _e1442[1])) + (_e2023 * _e1442[2]));
                                        if (_e2096 < 0.0lf) {
                                            phi_10071_ = -(_e2096);
                                        } else {
                                            phi_10071_ = _e2096;
                                        }
                                        let _e2143 = phi_10071_;
                                        if (_e2120 < 0.0lf) {
                                            phi_10077_ = -(_e2120);
                                        } else {
                                            phi_10077_ = _e2120;
                                        }
                                        let _e2147 = phi_10077_;
                                        if (_e2101 < 0.0lf) {
                                            phi_10086_ = -(_e2101);
                                        } else {
                                            phi_10086_ = _e2101;
                                        }
                                        let _e2154 = phi_10086_;
                                        if (_e2125 < 0.0lf) {
                                            phi_10092_ = -(_e2125);
                                        } else {
                                            phi_10092_ = _e2125;
                                        }
                                        let _e2158 = phi_10092_;
                                        if (_e2106 < 0.0lf) {
                                            phi_10101_ = -(_e2106);
                                        } else {
                                            phi_10101_ = _e2106;
                                        }
                                        let _e2165 = phi_10101_;
                                        if (_e2130 < 0.0lf) {
                                            phi_10107_ = -(_e2130);
                                        } else {
                                            phi_10107_ = _e2130;
                                        }
                                        let _e2169 = phi_10107_;
                                        if (_e2114 < 0.0lf) {
                                            phi_10116_ = -(_e2114);
                                        } else {
                                            phi_10116_ = _e2114;
                                        }
                                        let _e2176 = phi_10116_;
                                        if (_e2138 < 0.0lf) {
                                            phi_10122_ = -(_e2138);
                                        } else {
                                            phi_10122_ = _e2138;
                                        }
                                        let _e2180 = phi_10122_;
                                        phi_10128_ = type_35(array<f64, 4>(_e2096, _e2101, _e2106, _e2114), array<f64, 4>(_e2120, _e2125, _e2130, _e2138), array<f64, 4>((_e2091 + ((_e2143 + _e2147) * _e2084)), (_e2091 + ((_e2154 + _e2158) * _e2084)), (_e2091 + ((_e2165 + _e2169) * _e2084)), (_e2091 + ((_e2176 + _e2180) * _e2084))));
                                        phi_10129_ = false;
                                    } else {
                                        phi_10128_ = type_35();
                                        phi_10129_ = true;
                                    }
                                    let _e2187 = phi_10128_;
                                    let _e2189 = phi_10129_;
                                    phi_10130_ = _e2187;
                                    phi_10131_ = _e2189;
                                } else {
                                    phi_10130_ = type_35();
                                    phi_10131_ = true;
                                }
                                let _e2191 = phi_10130_;
                                let _e2193 = phi_10131_;
                                if _e2193 {
                                    let _e2194 = f64(0f);
                                    let _e2195 = f64(1f);
                                    phi_10141_ = type_35(array<f64, 4>(_e2194, _e2194, _e2194, _e2194), array<f64, 4>(_e2194, _e2194, _e2194, _e2194), array<f64, 4>(_e2195, _e2195, _e2195, _e2195));
                                } else {
                                    phi_10141_ = _e2191;
                                }
                                let _e2201 = phi_10141_;
                                local_9 = type_35(array<f64, 4>(_e2201.member[0], _e2201.member[1], _e2201.member[2], _e2201.member[3]), array<f64, 4>(_e2201.member_1[0], _e2201.member_1[1], _e2201.member_1[2], _e2201.member_1[3]), array<f64, 4>(_e2201.member_2[0], _e2201.member_2[1], _e2201.member_2[2], _e2201.member_2[3]));
                                let _e2221 = f64(0f);
                                let _e2224 = local_9.member[0u];
                                let _e2227 = local_9.member_1[0u];
                                let _e2230 = local_9.member[0u];
                                let _e2236 = local_9.member_2[0u];
                                if (((_e2224 + ((_e2227 - _e2230) * _e543)) - _e2236) > _e2221) {
                                    let _e2241 = local_9.member[1u];
                                    let _e2244 = local_9.member_1[1u];
                                    let _e2247 = local_9.member[1u];
                                    let _e2253 = local_9.member_2[1u];
                                    if (((_e2241 + ((_e2244 - _e2247) * _e543)) - _e2253) > _e2221) {
                                        let _e2258 = local_9.member[2u];
                                        let _e2261 = local_9.member_1[2u];
                                        let _e2264 = local_9.member[2u];
                                        let _e2270 = local_9.member_2[2u];
                                        if (((_e2258 + ((_e2261 - _e2264) * _e543)) - _e2270) > _e2221) {
                                            let _e2275 = local_9.member[3u];
                                            let _e2278 = local_9.member_1[3u];
                                            let _e2281 = local_9.member[3u];
                                            let _e2287 = local_9.member_2[3u];
                                            phi_10311_ = (((_e2275 + ((_e2278 - _e2281) * _e543)) - _e2287) > _e2221);
                                            phi_10312_ = false;
                                        } else {
                                            phi_10311_ = bool();
                                            phi_10312_ = true;
                                        }
                                        let _e2291 = phi_10311_;
                                        let _e2293 = phi_10312_;
                                        phi_10313_ = _e2291;
                                        phi_10314_ = _e2293;
                                    } else {
                                        phi_10313_ = bool();
                                        phi_10314_ = true;
                                    }
                                    let _e2295 = phi_10313_;
                                    let _e2297 = phi_10314_;
                                    phi_10315_ = _e2295;
                                    phi_10316_ = _e2297;
                                } else {
                                    phi_10315_ = bool();
                                    phi_10316_ = true;
                                }
                                let _e2299 = phi_10315_;
                                let _e2301 = phi_10316_;
                                if _e2301 {
                                    phi_10320_ = false;
                                } else {
                                    phi_10320_ = _e2299;
                                }
                                let _e2303 = phi_10320_;
                                if _e2303 {
                                    phi_11240_ = bool();
                                    phi_11241_ = true;
                                } else {
                                    let _e2304 = f64(0f);
                                    if (_e2304 < 0.0lf) {
                                        phi_10348_ = -(_e2304);
                                    } else {
                                        phi_10348_ = _e2304;
                                    }
                                    let _e2309 = phi_10348_;
                                    if (_e1687[1] < 0.0lf) {
                                        phi_10354_ = -(_e1687[1]);
                                    } else {
                                        phi_10354_ = _e1687[1];
                                    }
                                    let _e2313 = phi_10354_;
                                    if (_e2304 < 0.0lf) {
                                        phi_10361_ = -(_e2304);
                                    } else {
                                        phi_10361_ = _e2304;
                                    }
                                    let _e2318 = phi_10361_;
                                    let _e2319 = ((_e2309 + _e2313) + _e2318);
                                    if (_e2319 > f64(0f)) {
                                        if ((bitcast<u64>(_e2319) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e2326 = (f64(1f) / _e2319);
                                            let _e2327 = (_e2304 * _e2326);
                                            let _e2328 = (_e1687[1] * _e2326);
                                            let _e2329 = (_e2304 * _e2326);
                                            let _e2334 = (((_e2327 * _e2327) + (_e2328 * _e2328)) + (_e2329 * _e2329));
                                            if (_e2334 <= 2.2250738585072014e-308lf) {
                                                if (_e2334 > 0.0lf) {
                                                    phi_10397_ = (1.464336215552873e-154lf * 2.0lf);
                                                } else {
                                                    phi_10397_ = 0.0lf;
                                                }
                                                let _e2386 = phi_10397_;
                                                phi_10461_ = _e2386;
                                            } else {
                                                phi_10404_ = type_18(0i, 5i);
                                                phi_10407_ = bitcast<f64>(((bitcast<u64>(_e2334) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e2341 = phi_10404_;
                                                    let _e2343 = phi_10407_;
                                                    local_21 = _e2343;
                                                    if (_e2341.member < _e2341.member_1) {
                                                        let _e2350 = (_e2341.member + 1i);
                                                        if ((false == (_e2350 > _e2341.member)) != false) {
                                                            phi_10428_ = true;
                                                        } else {
                                                            phi_10428_ = false;
                                                        }
                                                        let _e2355 = phi_10428_;
                                                        if _e2355 {
                                                            phi_10434_ = type_19(0u, type_19().member_1);
                                                        } else {
                                                            phi_10434_ = type_19(1u, _e2350);
                                                        }
                                                        let _e2360 = phi_10434_;
                                                        phi_10405_ = type_18(_e2360.member_1, _e2341.member_1);
                                                        phi_10448_ = type_19(1u, _e2341.member);
                                                    } else {
                                                        phi_10405_ = _e2341;
                                                        phi_10448_ = type_19(0u, type_19().member_1);
                                                    }
                                                    let _e2366 = phi_10405_;
                                                    let _e2368 = phi_10448_;
                                                    let _e2371 = (bitcast<i32>(_e2368.member) != 0i);
                                                    if _e2371 {
                                                        phi_10408_ = (0.5lf * (_e2343 + (_e2334 / _e2343)));
                                                    } else {
                                                        phi_10408_ = f64();
                                                    }
                                                    let _e2376 = phi_10408_;
                                                    continue;
                                                    continuing {
                                                        phi_10404_ = _e2366;
                                                        phi_10407_ = _e2376;
                                                        break if !(_e2371);
                                                    }
                                                }
                                                let _e2381 = local_21;
                                                phi_10461_ = (_e2381 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e2388 = phi_10461_;
                                            let _e2390 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e2397 = ((_e1620 * f64(1.01f)) + ((_e1381 * _e2388) * (f64(1f) + _e2390)));
                                            let _e2402 = (((_e2327 * _e1384[0]) + (_e2328 * _e1384[1])) + (_e2329 * _e1384[2]));
                                            let _e2407 = (((_e2327 * _e1401) + (_e2328 * _e1402)) + (_e2329 * _e1403));
                                            let _e2412 = (((_e2327 * _e1411) + (_e2328 * _e1412)) + (_e2329 * _e1413));
                                            let _e2420 = (((_e2327 * _e1410[0]) + (_e2328 * _e1410[1])) + (_e2329 * _e1410[2]));
                                            let _e2426 = (((_e2327 * _e1416[0]) + (_e2328 * _e1416[1])) + (_e2329 * _e1416[2]));
                                            let _e2431 = (((_e2327 * _e1433) + (_e2328 * _e1434)) + (_e2329 * _e1435));
                                            let _e2436 = (((_e2327 * _e1443) + (_e2328 * _e1444)) + (_e2329 * _e1445));
                                            let _e2444 = (((_e2327 * _e1442[0]) + (_e2328 * _e1442[1])) + (_e2329 * _e1442[2]));
                                            if (_e2402 < 0.0lf) {
                                                phi_10530_ = -(_e2402);
                                            } else {
                                                phi_10530_ = _e2402;
                                            }
                                            let _e2449 = phi_10530_;
                                            if (_e2426 < 0.0lf) {
                                                phi_10536_ = -(_e2426);
                                            } else {
                                                phi_10536_ = _e2426;
                                            }
                                            let _e2453 = phi_10536_;
                                            if (_e2407 < 0.0lf) {
                                                phi_10545_ = -(_e2407);
                                            } else {
                                                phi_10545_ = _e2407;
                                            }
                                            let _e2460 = phi_10545_;
                                            if (_e2431 < 0.0lf) {
                                                phi_10551_ = -(_e2431);
                                            } else {
                                                phi_10551_ = _e2431;
                                            }
                                            let _e2464 = phi_10551_;
                                            if (_e2412 < 0.0lf) {
                                                phi_10560_ = -(_e2412);
                                            } else {
                                                phi_10560_ = _e2412;
                                            }
                                            let _e2471 = phi_10560_;
                                            if (_e2436 < 0.0lf) {
                                                phi_10566_ = -(_e2436);
                                            } else {
                                                phi_10566_ = _e2436;
                                            }
                                            let _e2475 = phi_10566_;
                                            if (_e2420 < 0.0lf) {
                                                phi_10575_ = -(_e2420);
                                            } else {
                                                phi_10575_ = _e2420;
                                            }
                                            let _e2482 = phi_10575_;
                                            if (_e2444 < 0.0lf) {
                                                phi_10581_ = -(_e2444);
                                            } else {
                                                phi_10581_ = _e2444;
                                            }
                                            let _e2486 = phi_10581_;
                                            phi_10587_ = type_35(array<f64, 4>(_e2402, _e2407, _e2412, _e2420), array<f64, 4>(_e2426, _e2431, _e2436, _e2444), array<f64, 4>((_e2397 + ((_e2449 + _e2453) * _e2390)), (_e2397 + ((_e2460 + _e2464) * _e2390)), (_e2397 + ((_e2471 + _e2475) * _e2390)), (_e2397 + ((_e2482 + _e2486) * _e2390))));
                                            phi_10588_ = false;
                                        } else {
                                            phi_10587_ = type_35();
                                            phi_10588_ = true;
                                        }
                                        let _e2493 = phi_10587_;
                                        let _e2495 = phi_10588_;
                                        phi_10589_ = _e2493;
                                        phi_10590_ = _e2495;
                                    } else {
                                        phi_10589_ = type_35();
                                        phi_10590_ = true;
                                    }
                                    let _e2497 = phi_10589_;
                                    let _e2499 = phi_10590_;
                                    if _e2499 {
                                        let _e2500 = f64(0f);
                                        let _e2501 = f64(1f);
                                        phi_10600_ = type_35(array<f64, 4>(_e2500, _e2500, _e2500, _e2500), array<f64, 4>(_e2500, _e2500, _e2500, _e2500), array<f64, 4>(_e2501, _e2501, _e2501, _e2501));
                                    } else {
                                        phi_10600_ = _e2497;
                                    }
                                    let _e2507 = phi_10600_;
                                    local_10 = type_35(array<f64, 4>(_e2507.member[0], _e2507.member[1], _e2507.member[2], _e2507.member[3]), array<f64, 4>(_e2507.member_1[0], _e2507.member_1[1], _e2507.member_1[2], _e2507.member_1[3]), array<f64, 4>(_e2507.member_2[0], _e2507.member_2[1], _e2507.member_2[2], _e2507.member_2[3]));
                                    let _e2527 = f64(0f);
                                    let _e2530 = local_10.member[0u];
                                    let _e2533 = local_10.member_1[0u];
                                    let _e2536 = local_10.member[0u];
                                    let _e2542 = local_10.member_2[0u];
                                    if (((_e2530 + ((_e2533 - _e2536) * _e543)) - _e2542) > _e2527) {
                                        let _e2547 = local_10.member[1u];
                                        let _e2550 = local_10.member_1[1u];
                                        let _e2553 = local_10.member[1u];
                                        let _e2559 = local_10.member_2[1u];
                                        if (((_e2547 + ((_e2550 - _e2553) * _e543)) - _e2559) > _e2527) {
                                            let _e2564 = local_10.member[2u];
                                            let _e2567 = local_10.member_1[2u];
                                            let _e2570 = local_10.member[2u];
                                            let _e2576 = local_10.member_2[2u];
                                            if (((_e2564 + ((_e2567 - _e2570) * _e543)) - _e2576) > _e2527) {
                                                let _e2581 = local_10.member[3u];
                                                let _e2584 = local_10.member_1[3u];
                                                let _e2587 = local_10.member[3u];
                                                let _e2593 = local_10.member_2[3u];
                                                phi_10770_ = (((_e2581 + ((_e2584 - _e2587) * _e543)) - _e2593) > _e2527);
                                                phi_10771_ = false;
                                            } else {
                                                phi_10770_ = bool();
                                                phi_10771_ = true;
                                            }
                                            let _e2597 = phi_10770_;
                                            let _e2599 = phi_10771_;
                                            phi_10772_ = _e2597;
                                            phi_10773_ = _e2599;
                                        } else {
                                            phi_10772_ = bool();
                                            phi_10773_ = true;
                                        }
                                        let _e2601 = phi_10772_;
                                        let _e2603 = phi_10773_;
                                        phi_10774_ = _e2601;
                                        phi_10775_ = _e2603;
                                    } else {
                                        phi_10774_ = bool();
                                        phi_10775_ = true;
                                    }
                                    let _e2605 = phi_10774_;
                                    let _e2607 = phi_10775_;
                                    if _e2607 {
                                        phi_10779_ = false;
                                    } else {
                                        phi_10779_ = _e2605;
                                    }
                                    let _e2609 = phi_10779_;
                                    if _e2609 {
                                        phi_11239_ = bool();
                                    } else {
                                        let _e2610 = f64(0f);
                                        if (_e2610 < 0.0lf) {
                                            phi_10807_ = -(_e2610);
                                        } else {
                                            phi_10807_ = _e2610;
                                        }
                                        let _e2615 = phi_10807_;
                                        if (_e2610 < 0.0lf) {
                                            phi_10813_ = -(_e2610);
                                        } else {
                                            phi_10813_ = _e2610;
                                        }
                                        let _e2619 = phi_10813_;
                                        if (_e1687[2] < 0.0lf) {
                                            phi_10820_ = -(_e1687[2]);
                                        } else {
                                            phi_10820_ = _e1687[2];
                                        }
                                        let _e2624 = phi_10820_;
                                        let _e2625 = ((_e2615 + _e2619) + _e2624);
                                        if (_e2625 > f64(0f)) {
                                            if ((bitcast<u64>(_e2625) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2632 = (f64(1f) / _e2625);
                                                let _e2633 = (_e2610 * _e2632);
                                                let _e2634 = (_e2610 * _e2632);
                                                let _e2635 = (_e1687[2] * _e2632);
                                                let _e2640 = (((_e2633 * _e2633) + (_e2634 * _e2634)) + (_e2635 * _e2635));
                                                if (_e2640 <= 2.2250738585072014e-308lf) {
                                                    if (_e2640 > 0.0lf) {
                                                        phi_10856_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_10856_ = 0.0lf;
                                                    }
                                                    let _e2692 = phi_10856_;
                                                    phi_10920_ = _e2692;
                                                } else {
                                                    phi_10863_ = type_18(0i, 5i);
                                                    phi_10866_ = bitcast<f64>(((bitcast<u64>(_e2640) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2647 = phi_10863_;
                                                        let _e2649 = phi_10866_;
                                                        local_22 = _e2649;
                                                        if (_e2647.member < _e2647.member_1) {
                                                            let _e2656 = (_e2647.member + 1i);
                                                            if ((false == (_e2656 > _e2647.member)) != false) {
                                                                phi_10887_ = true;
                                                            } else {
                                                                phi_10887_ = false;
                                                            }
                                                            let _e2661 = phi_10887_;
                                                            if _e2661 {
                                                                phi_10893_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_10893_ = type_19(1u, _e2656);
                                                            }
                                                            let _e2666 = phi_10893_;
                                                            phi_10864_ = type_18(_e2666.member_1, _e2647.member_1);
                                                            phi_10907_ = type_19(1u, _e2647.member);
                                                        } else {
                                                            phi_10864_ = _e2647;
                                                            phi_10907_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e2672 = phi_10864_;
                                                        let _e2674 = phi_10907_;
                                                        let _e2677 = (bitcast<i32>(_e2674.member) != 0i);
                                                        if _e2677 {
                                                            phi_10867_ = (0.5lf * (_e2649 + (_e2640 / _e2649)));
                                                        } else {
                                                            phi_10867_ = f64();
                                                        }
                                                        let _e2682 = phi_10867_;
                                                        continue;
                                                        continuing {
                                                            phi_10863_ = _e2672;
                                                            phi_10866_ = _e2682;
                                                            break if !(_e2677);
                                                        }
                                                    }
                                                    let _e2687 = local_22;
                                                    phi_10920_ = (_e2687 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2694 = phi_10920_;
                                                let _e2696 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2703 = ((_e1620 * f64(1.01f)) + ((_e1381 * _e2694) * (f64(1f) + _e2696)));
                                                let _e2708 = (((_e2633 * _e1384[0]) + (_e2634 * _e1384[1])) + (_e2635 * _e1384[2]));
                                                let _e2713 = (((_e2633 * _e1401) + (_e2634 * _e1402)) + (_e2635 * _e1403));
                                                let _e2718 = (((_e2633 * _e1411) + (_e2634 * _e1412)) + (_e2635 * _e1413));
                                                let _e2726 = (((_e2633 * _e1410[0]) + (_e2634 * _e1410[1])) + (_e2635 * _e1410[2]));
                                                let _e2732 = (((_e2633 * _e1416[0]) + (_e2634 * _e1416[1])) + (_e2635 * _e1416[2]));
                                                let _e2737 = (((_e2633 * _e1433) + (_e2634 * _e1434)) + (_e2635 * _e1435));
                                                let _e2742 = (((_e2633 * _e1443) + (_e2634 * _e1444)) + (_e2635 * _e1445));
                                                let _e2750 = (((_e2633 * _e1442[0]) + (_e2634 * _e1442[1])) + (_e2635 * _e1442[2]));
                                                if (_e2708 < 0.0lf) {
                                                    phi_10989_ = -(_e2708);
                                                } else {
                                                    phi_10989_ = _e2708;
                                                }
                                                let _e2755 = phi_10989_;
                                                if (_e2732 < 0.0lf) {
                                                    phi_10995_ = -(_e2732);
                                                } else {
                                                    phi_10995_ = _e2732;
                                                }
                                                let _e2759 = phi_10995_;
                                                if (_e2713 < 0.0lf) {
                                                    phi_11004_ = -(_e2713);
                                                } else {
                                                    phi_11004_ = _e2713;
                                                }
                                                let _e2766 = phi_11004_;
                                                if (_e2737 < 0.0lf) {
                                                    phi_11010_ = -(_e2737);
                                                } else {
                                                    phi_11010_ = _e2737;
                                                }
                                                let _e2770 = phi_11010_;
                                                if (_e2718 < 0.0lf) {
                                                    phi_11019_ = -(_e2718);
                                                } else {
                                                    phi_11019_ = _e2718;
                                                }
                                                let _e2777 = phi_11019_;
                                                if (_e2742 < 0.0lf) {
                                                    phi_11025_ = -(_e2742);
                                                } else {
                                                    phi_11025_ = _e2742;
                                                }
                                                let _e2781 = phi_11025_;
                                                if (_e2726 < 0.0lf) {
                                                    phi_11034_ = -(_e2726);
                                                } else {
                                                    phi_11034_ = _e2726;
                                                }
                                                let _e2788 = phi_11034_;
                                                if (_e2750 < 0.0lf) {
                                                    phi_11040_ = -(_e2750);
                                                } else {
                                                    phi_11040_ = _e2750;
                                                }
                                                let _e2792 = phi_11040_;
                                                phi_11046_ = type_35(array<f64, 4>(_e2708, _e2713, _e2718, _e2726), array<f64, 4>(_e2732, _e2737, _e2742, _e2750), array<f64, 4>((_e2703 + ((_e2755 + _e2759) * _e2696)), (_e2703 + ((_e2766 + _e2770) * _e2696)), (_e2703 + ((_e2777 + _e2781) * _e2696)), (_e2703 + ((_e2788 + _e2792) * _e2696))));
                                                phi_11047_ = false;
                                            } else {
                                                phi_11046_ = type_35();
                                                phi_11047_ = true;
                                            }
                                            let _e2799 = phi_11046_;
                                            let _e2801 = phi_11047_;
                                            phi_11048_ = _e2799;
                                            phi_11049_ = _e2801;
                                        } else {
                                            phi_11048_ = type_35();
                                            phi_11049_ = true;
                                        }
                                        let _e2803 = phi_11048_;
                                        let _e2805 = phi_11049_;
                                        if _e2805 {
                                            let _e2806 = f64(0f);
                                            let _e2807 = f64(1f);
                                            phi_11059_ = type_35(array<f64, 4>(_e2806, _e2806, _e2806, _e2806), array<f64, 4>(_e2806, _e2806, _e2806, _e2806), array<f64, 4>(_e2807, _e2807, _e2807, _e2807));
                                        } else {
                                            phi_11059_ = _e2803;
                                        }
                                        let _e2813 = phi_11059_;
                                        local_11 = type_35(array<f64, 4>(_e2813.member[0], _e2813.member[1], _e2813.member[2], _e2813.member[3]), array<f64, 4>(_e2813.member_1[0], _e2813.member_1[1], _e2813.member_1[2], _e2813.member_1[3]), array<f64, 4>(_e2813.member_2[0], _e2813.member_2[1], _e2813.member_2[2], _e2813.member_2[3]));
                                        let _e2833 = f64(0f);
                                        let _e2836 = local_11.member[0u];
                                        let _e2839 = local_11.member_1[0u];
                                        let _e2842 = local_11.member[0u];
                                        let _e2848 = local_11.member_2[0u];
                                        if (((_e2836 + ((_e2839 - _e2842) * _e543)) - _e2848) > _e2833) {
                                            let _e2853 = local_11.member[1u];
                                            let _e2856 = local_11.member_1[1u];
                                            let _e2859 = local_11.member[1u];
                                            let _e2865 = local_11.member_2[1u];
                                            if (((_e2853 + ((_e2856 - _e2859) * _e543)) - _e2865) > _e2833) {
                                                let _e2870 = local_11.member[2u];
                                                let _e2873 = local_11.member_1[2u];
                                                let _e2876 = local_11.member[2u];
                                                let _e2882 = local_11.member_2[2u];
                                                if (((_e2870 + ((_e2873 - _e2876) * _e543)) - _e2882) > _e2833) {
                                                    let _e2887 = local_11.member[3u];
                                                    let _e2890 = local_11.member_1[3u];
                                                    let _e2893 = local_11.member[3u];
                                                    let _e2899 = local_11.member_2[3u];
                                                    phi_11229_ = (((_e2887 + ((_e2890 - _e2893) * _e543)) - _e2899) > _e2833);
                                                    phi_11230_ = false;
                                                } else {
                                                    phi_11229_ = bool();
                                                    phi_11230_ = true;
                                                }
                                                let _e2903 = phi_11229_;
                                                let _e2905 = phi_11230_;
                                                phi_11231_ = _e2903;
                                                phi_11232_ = _e2905;
                                            } else {
                                                phi_11231_ = bool();
                                                phi_11232_ = true;
                                            }
                                            let _e2907 = phi_11231_;
                                            let _e2909 = phi_11232_;
                                            phi_11233_ = _e2907;
                                            phi_11234_ = _e2909;
                                        } else {
                                            phi_11233_ = bool();
                                            phi_11234_ = true;
                                        }
                                        let _e2911 = phi_11233_;
                                        let _e2913 = phi_11234_;
                                        if _e2913 {
                                            phi_11238_ = false;
                                        } else {
                                            phi_11238_ = _e2911;
                                        }
                                        let _e2915 = phi_11238_;
                                        phi_11239_ = _e2915;
                                    }
                                    let _e2917 = phi_11239_;
                                    phi_11240_ = _e2917;
                                    phi_11241_ = _e2609;
                                }
                                let _e2919 = phi_11240_;
                                let _e2921 = phi_11241_;
                                phi_11242_ = _e2919;
                                phi_11243_ = _e2921;
                            }
                            let _e2923 = phi_11242_;
                            let _e2925 = phi_11243_;
                            if _e2925 {
                                phi_11247_ = true;
                            } else {
                                phi_11247_ = _e2923;
                            }
                            let _e2927 = phi_11247_;
                            if !(_e2927) {
                                phi_11253_ = type_43(2u, _e543);
                                phi_11254_ = false;
                            } else {
                                phi_11253_ = type_43();
                                phi_11254_ = true;
                            }
                            let _e2931 = phi_11253_;
                            let _e2933 = phi_11254_;
                            phi_11255_ = _e2931;
                            phi_11256_ = _e2933;
                        } else {
                            phi_11255_ = type_43();
                            phi_11256_ = true;
                        }
                        let _e2935 = phi_11255_;
                        let _e2937 = phi_11256_;
                        if _e2937 {
                            let _e2938 = f64(0f);
                            let _e2939 = f64(1f);
                            let _e2940 = f64(3f);
                            let _e2946 = ((_e984 - (_e2940 * _e961)) * _e1355);
                            let _e2947 = ((_e1007 - _e984) * _e1355);
                            let _e2948 = (((_e2940 * _e1018) - _e1007) * _e1355);
                            local_6[0u] = _e2938;
                            local_6[1u] = _e2939;
                            local_6[2u] = _e2939;
                            local_6[3u] = _e2939;
                            let _e2955 = ((_e2947 * _e2947) - (_e2946 * _e2948));
                            if (_e2955 > _e2938) {
                                if (_e2955 <= 2.2250738585072014e-308lf) {
                                    if (_e2955 > 0.0lf) {
                                        phi_11295_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_11295_ = 0.0lf;
                                    }
                                    let _e3008 = phi_11295_;
                                    phi_11359_ = _e3008;
                                } else {
                                    phi_11302_ = type_18(0i, 5i);
                                    phi_11305_ = bitcast<f64>(((bitcast<u64>(_e2955) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2963 = phi_11302_;
                                        let _e2965 = phi_11305_;
                                        local_23 = _e2965;
                                        if (_e2963.member < _e2963.member_1) {
                                            let _e2972 = (_e2963.member + 1i);
                                            if ((false == (_e2972 > _e2963.member)) != false) {
                                                phi_11326_ = true;
                                            } else {
                                                phi_11326_ = false;
                                            }
                                            let _e2977 = phi_11326_;
                                            if _e2977 {
                                                phi_11332_ = type_19(0u, type_19().member_1);
                                            } else {
                                                phi_11332_ = type_19(1u, _e2972);
                                            }
                                            let _e2982 = phi_11332_;
                                            phi_11303_ = type_18(_e2982.member_1, _e2963.member_1);
                                            phi_11346_ = type_19(1u, _e2963.member);
                                        } else {
                                            phi_11303_ = _e2963;
                                            phi_11346_ = type_19(0u, type_19().member_1);
                                        }
                                        let _e2988 = phi_11303_;
                                        let _e2990 = phi_11346_;
                                        let _e2993 = (bitcast<i32>(_e2990.member) != 0i);
                                        if _e2993 {
                                            phi_11306_ = (0.5lf * (_e2965 + (_e2955 / _e2965)));
                                        } else {
                                            phi_11306_ = f64();
                                        }
                                        let _e2998 = phi_11306_;
                                        continue;
                                        continuing {
                                            phi_11302_ = _e2988;
                                            phi_11305_ = _e2998;
                                            break if !(_e2993);
                                        }
                                    }
                                    let _e3003 = local_23;
                                    phi_11359_ = (_e3003 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e3010 = phi_11359_;
                                if (_e2947 < _e2938) {
                                    phi_11365_ = -(_e3010);
                                } else {
                                    phi_11365_ = _e3010;
                                }
                                let _e3014 = phi_11365_;
                                let _e3016 = -((_e2947 + _e3014));
                                local_7[0u] = (_e3016 / (_e3016 + _e2948));
                                local_7[1u] = (_e2946 / (_e2946 + _e3016));
                                let _e3025 = local_7[1u];
                                let _e3026 = local_7[0u];
                                if (_e3025 < _e3026) {
                                    let _e3029 = local_7[1u];
                                    let _e3031 = local_7[0u];
                                    local_7[0u] = _e3029;
                                    local_7[1u] = _e3031;
                                }
                                phi_11390_ = type_9(0u, 2u);
                                phi_11393_ = 1u;
                                loop {
                                    let _e3035 = phi_11390_;
                                    let _e3037 = phi_11393_;
                                    local_64 = _e3037;
                                    if (_e3035.member < _e3035.member_1) {
                                        phi_11391_ = type_9((_e3035.member + 1u), _e3035.member_1);
                                        phi_11416_ = type_9(1u, _e3035.member);
                                    } else {
                                        phi_11391_ = _e3035;
                                        phi_11416_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e3049 = phi_11391_;
                                    let _e3051 = phi_11416_;
                                    let _e3055 = (bitcast<i32>(_e3051.member) != 0i);
                                    if _e3055 {
                                        let _e3057 = local_7[_e3051.member_1];
                                        if (_e3057 > _e2938) {
                                            let _e3060 = local_7[_e3051.member_1];
                                            if (_e3060 < _e2939) {
                                                let _e3063 = local_7[_e3051.member_1];
                                                local_6[_e3037] = _e3063;
                                                phi_11460_ = (_e3037 + 1u);
                                            } else {
                                                phi_11460_ = _e3037;
                                            }
                                            let _e3067 = phi_11460_;
                                            phi_11461_ = _e3067;
                                        } else {
                                            phi_11461_ = _e3037;
                                        }
                                        let _e3069 = phi_11461_;
                                        phi_11394_ = _e3069;
                                    } else {
                                        phi_11394_ = u32();
                                    }
                                    let _e3071 = phi_11394_;
                                    continue;
                                    continuing {
                                        phi_11390_ = _e3049;
                                        phi_11393_ = _e3071;
                                        break if !(_e3055);
                                    }
                                }
                                let _e11215 = local_64;
                                phi_11462_ = _e11215;
                            } else {
                                phi_11462_ = 1u;
                            }
                            let _e3074 = phi_11462_;
                            local_6[_e3074] = _e2939;
                            let _e3076 = local_6;
                            local_12 = _e3076;
                            phi_11482_ = type_9(0u, _e3074);
                            loop {
                                let _e3079 = phi_11482_;
                                if (_e3079.member < _e3079.member_1) {
                                    phi_11483_ = type_9((_e3079.member + 1u), _e3079.member_1);
                                    phi_11506_ = type_9(1u, _e3079.member);
                                } else {
                                    phi_11483_ = _e3079;
                                    phi_11506_ = type_9(0u, type_9().member_1);
                                }
                                let _e3091 = phi_11483_;
                                let _e3093 = phi_11506_;
                                if (bitcast<i32>(_e3093.member) != 0i) {
                                    let _e3099 = local_12[_e3093.member_1];
                                    if (_e3099 > _e543) {
                                        phi_11525_ = _e3099;
                                    } else {
                                        phi_11525_ = _e543;
                                    }
                                    let _e3102 = phi_11525_;
                                    let _e3105 = local_12[(_e3093.member_1 + 1u)];
                                    if (_e3105 < _e552) {
                                        phi_11538_ = _e3105;
                                    } else {
                                        phi_11538_ = _e552;
                                    }
                                    let _e3108 = phi_11538_;
                                    if (_e3102 <= _e3108) {
                                        let _e3111 = (f64(1f) - _e3102);
                                        let _e3122 = ((((_e961 * _e3111) + (_e984 * _e3102)) * (_e3111 * _e3111)) + (((_e1007 * _e3111) + (_e1018 * _e3102)) * (_e3102 * _e3102)));
                                        let _e3124 = (f64(1f) - _e3108);
                                        let _e3135 = ((((_e961 * _e3124) + (_e984 * _e3108)) * (_e3124 * _e3124)) + (((_e1007 * _e3124) + (_e1018 * _e3108)) * (_e3108 * _e3108)));
                                        if (_e3122 < 0.0lf) {
                                            phi_11574_ = -(_e3122);
                                        } else {
                                            phi_11574_ = _e3122;
                                        }
                                        let _e3139 = phi_11574_;
                                        let _e3140 = (_e3139 > _e1351);
                                        if (_e3135 < 0.0lf) {
                                            phi_11581_ = -(_e3135);
                                        } else {
                                            phi_11581_ = _e3135;
                                        }
                                        let _e3144 = phi_11581_;
                                        let _e3145 = (_e3144 > _e1351);
                                        let _e3146 = f64(0f);
                                        if _e3140 {
                                            if _e3145 {
                                                phi_11593_ = ((_e3122 > _e3146) != (_e3135 > _e3146));
                                                phi_11594_ = false;
                                            } else {
                                                phi_11593_ = bool();
                                                phi_11594_ = true;
                                            }
                                            let _e3151 = phi_11593_;
                                            let _e3153 = phi_11594_;
                                            phi_11595_ = _e3151;
                                            phi_11596_ = _e3153;
                                        } else {
                                            phi_11595_ = bool();
                                            phi_11596_ = true;
                                        }
                                        let _e3155 = phi_11595_;
                                        let _e3157 = phi_11596_;
                                        if _e3157 {
                                            phi_11600_ = false;
                                        } else {
                                            phi_11600_ = _e3155;
                                        }
                                        let _e3159 = phi_11600_;
                                        if _e3140 {
                                            if _e3145 {
                                                if _e3159 {
                                                    phi_11612_ = type_46();
                                                } else {
                                                    phi_11612_ = type_46(f64(1f), _e3146, _e3159);
                                                }
                                                let _e3163 = phi_11612_;
                                                phi_11613_ = _e3163;
                                                phi_11614_ = _e3159;
                                            } else {
                                                phi_11613_ = type_46();
                                                phi_11614_ = true;
                                            }
                                            let _e3165 = phi_11613_;
                                            let _e3167 = phi_11614_;
                                            phi_11615_ = _e3165;
                                            phi_11616_ = _e3167;
                                        } else {
                                            phi_11615_ = type_46();
                                            phi_11616_ = true;
                                        }
                                        let _e3169 = phi_11615_;
                                        let _e3171 = phi_11616_;
                                        if _e3171 {
                                            if _e3140 {
                                                if (_e3122 < _e3146) {
                                                    phi_11629_ = f64(-1f);
                                                } else {
                                                    phi_11629_ = f64(1f);
                                                }
                                                let _e3176 = phi_11629_;
                                                let _e3177 = f64(0.5f);
                                                let _e3178 = f64(3f);
                                                let _e3181 = (_e1007 - _e984);
                                                phi_11641_ = type_9(0u, 64u);
                                                phi_11644_ = _e3108;
                                                phi_11646_ = _e3102;
                                                phi_11648_ = (_e3177 * (_e3102 + _e3108));
                                                loop {
                                                    let _e3187 = phi_11641_;
                                                    let _e3189 = phi_11644_;
                                                    let _e3191 = phi_11646_;
                                                    let _e3193 = phi_11648_;
                                                    local_66 = _e3191;
                                                    if (_e3187.member < _e3187.member_1) {
                                                        phi_11642_ = type_9((_e3187.member + 1u), _e3187.member_1);
                                                        phi_11671_ = type_9(1u, _e3187.member);
                                                    } else {
                                                        phi_11642_ = _e3187;
                                                        phi_11671_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e3205 = phi_11642_;
                                                    let _e3207 = phi_11671_;
                                                    if (bitcast<i32>(_e3207.member) != 0i) {
                                                        let _e3212 = (f64(1f) - _e3193);
                                                        let _e3225 = ((_e3176 * ((((_e961 * _e3212) + (_e984 * _e3193)) * (_e3212 * _e3212)) + (((_e1007 * _e3212) + (_e1018 * _e3193)) * (_e3193 * _e3193)))) - _e1351);
                                                        if (_e3225 > f64(0f)) {
                                                            phi_11698_ = _e3189;
                                                            phi_11699_ = _e3193;
                                                        } else {
                                                            phi_11698_ = _e3193;
                                                            phi_11699_ = _e3191;
                                                        }
                                                        let _e3229 = phi_11698_;
                                                        let _e3231 = phi_11699_;
                                                        let _e3233 = ((_e3229 - _e3231) > _e1361);
                                                        if _e3233 {
                                                            let _e3235 = (f64(1f) - _e3193);
                                                            let _e3247 = (-(_e3225) / (_e3176 * (((((_e984 - (_e3178 * _e961)) * _e3235) + (_e3181 * _e3193)) * _e3235) + (((_e3181 * _e3235) + (((_e3178 * _e1018) - _e1007) * _e3193)) * _e3193))));
                                                            if (_e3225 > f64(0f)) {
                                                                phi_11727_ = (_e3177 * _e1361);
                                                            } else {
                                                                phi_11727_ = -((_e3177 * _e1361));
                                                            }
                                                            let _e3254 = phi_11727_;
                                                            let _e3256 = ((_e3193 + _e3247) + _e3254);
                                                            if (_e3256 > _e3231) {
                                                                if (_e3256 < _e3229) {
                                                                    if (_e3247 < 0.0lf) {
                                                                        phi_11743_ = -(_e3247);
                                                                    } else {
                                                                        phi_11743_ = _e3247;
                                                                    }
                                                                    let _e3262 = phi_11743_;
                                                                    if (_e3262 < (_e3177 * (_e3229 - _e3231))) {
                                                                        phi_11750_ = false;
                                                                    } else {
                                                                        phi_11750_ = true;
                                                                    }
                                                                    let _e3267 = phi_11750_;
                                                                    phi_11751_ = _e3267;
                                                                } else {
                                                                    phi_11751_ = true;
                                                                }
                                                                let _e3269 = phi_11751_;
                                                                phi_11752_ = _e3269;
                                                            } else {
                                                                phi_11752_ = true;
                                                            }
                                                            let _e3271 = phi_11752_;
                                                            if _e3271 {
                                                                phi_11758_ = (_e3177 * (_e3231 + _e3229));
                                                            } else {
                                                                phi_11758_ = _e3256;
                                                            }
                                                            let _e3275 = phi_11758_;
                                                            phi_11759_ = _e3275;
                                                            phi_11760_ = false;
                                                        } else {
                                                            phi_11759_ = f64();
                                                            phi_11760_ = true;
                                                        }
                                                        let _e3277 = phi_11759_;
                                                        let _e3279 = phi_11760_;
                                                        phi_11645_ = _e3229;
                                                        phi_11647_ = _e3231;
                                                        phi_11649_ = _e3277;
                                                        phi_11761_ = _e3231;
                                                        phi_11762_ = _e3233;
                                                        phi_11763_ = _e3279;
                                                    } else {
                                                        phi_11645_ = f64();
                                                        phi_11647_ = f64();
                                                        phi_11649_ = f64();
                                                        phi_11761_ = f64();
                                                        phi_11762_ = false;
                                                        phi_11763_ = false;
                                                    }
                                                    let _e3281 = phi_11645_;
                                                    let _e3283 = phi_11647_;
                                                    let _e3285 = phi_11649_;
                                                    let _e3287 = phi_11761_;
                                                    let _e3289 = phi_11762_;
                                                    let _e3291 = phi_11763_;
                                                    local_24 = _e3291;
                                                    local_65 = _e3287;
                                                    continue;
                                                    continuing {
                                                        phi_11641_ = _e3205;
                                                        phi_11644_ = _e3281;
                                                        phi_11646_ = _e3283;
                                                        phi_11648_ = _e3285;
                                                        break if !(_e3289);
                                                    }
                                                }
                                                let _e3294 = local_24;
                                                if _e3294 {
                                                    let _e11259 = local_65;
                                                    phi_11767_ = _e11259;
                                                } else {
                                                    let _e11261 = local_66;
                                                    phi_11767_ = _e11261;
                                                }
                                                let _e3296 = phi_11767_;
                                                phi_11768_ = _e3296;
                                            } else {
                                                phi_11768_ = _e3102;
                                            }
                                            let _e3298 = phi_11768_;
                                            if _e3145 {
                                                if (_e3135 < _e3146) {
                                                    phi_11778_ = f64(-1f);
                                                } else {
                                                    phi_11778_ = f64(1f);
                                                }
                                                let _e3303 = phi_11778_;
                                                phi_11782_ = type_9(0u, 64u);
                                                phi_11785_ = (_e1361 + _e1361);
                                                loop {
                                                    let _e3306 = phi_11782_;
                                                    let _e3308 = phi_11785_;
                                                    if (_e3306.member < _e3306.member_1) {
                                                        phi_11783_ = type_9((_e3306.member + 1u), _e3306.member_1);
                                                        phi_11808_ = type_9(1u, _e3306.member);
                                                    } else {
                                                        phi_11783_ = _e3306;
                                                        phi_11808_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e3320 = phi_11783_;
                                                    let _e3322 = phi_11808_;
                                                    if (bitcast<i32>(_e3322.member) != 0i) {
                                                        let _e3326 = (_e3298 + _e3308);
                                                        if (_e3326 < _e3108) {
                                                            let _e3329 = (f64(1f) - _e3326);
                                                            let _e3342 = ((_e3303 * ((((_e961 * _e3329) + (_e984 * _e3326)) * (_e3329 * _e3329)) + (((_e1007 * _e3329) + (_e1018 * _e3326)) * (_e3326 * _e3326)))) > _e1351);
                                                            if _e3342 {
                                                                phi_11839_ = f64();
                                                                phi_11840_ = false;
                                                            } else {
                                                                phi_11839_ = (_e3308 + _e3308);
                                                                phi_11840_ = true;
                                                            }
                                                            let _e3345 = phi_11839_;
                                                            let _e3347 = phi_11840_;
                                                            phi_11841_ = _e3345;
                                                            phi_11842_ = _e3347;
                                                            phi_11843_ = _e3342;
                                                            phi_11844_ = false;
                                                        } else {
                                                            phi_11841_ = f64();
                                                            phi_11842_ = false;
                                                            phi_11843_ = false;
                                                            phi_11844_ = true;
                                                        }
                                                        let _e3349 = phi_11841_;
                                                        let _e3351 = phi_11842_;
                                                        let _e3353 = phi_11843_;
                                                        let _e3355 = phi_11844_;
                                                        phi_11845_ = _e3326;
                                                        phi_11786_ = _e3349;
                                                        phi_11846_ = _e3351;
                                                        phi_11847_ = _e3353;
                                                        phi_11848_ = _e3355;
                                                        phi_11849_ = false;
                                                    } else {
                                                        phi_11845_ = f64();
                                                        phi_11786_ = f64();
                                                        phi_11846_ = false;
                                                        phi_11847_ = false;
                                                        phi_11848_ = false;
                                                        phi_11849_ = true;
                                                    }
                                                    let _e3357 = phi_11845_;
                                                    let _e3359 = phi_11786_;
                                                    let _e3361 = phi_11846_;
                                                    let _e3363 = phi_11847_;
                                                    let _e3365 = phi_11848_;
                                                    let _e3367 = phi_11849_;
                                                    local_25 = _e3363;
                                                    local_67 = _e3365;
                                                    local_68 = _e3367;
                                                    local_69 = _e3357;
                                                    continue;
                                                    continuing {
                                                        phi_11782_ = _e3320;
                                                        phi_11785_ = _e3359;
                                                        break if !(_e3361);
                                                    }
                                                }
                                                let _e3370 = local_25;
                                                if _e3370 {
                                                    phi_11853_ = false;
                                                    phi_11854_ = false;
                                                } else {
                                                    let _e11283 = local_67;
                                                    phi_11853_ = _e11283;
                                                    let _e11286 = local_68;
                                                    phi_11854_ = _e11286;
                                                }
                                                let _e3372 = phi_11853_;
                                                let _e3374 = phi_11854_;
                                                if _e3372 {
                                                    phi_11858_ = true;
                                                } else {
                                                    phi_11858_ = _e3374;
                                                }
                                                let _e3376 = phi_11858_;
                                                if _e3376 {
                                                    phi_11862_ = _e3108;
                                                } else {
                                                    let _e11290 = local_69;
                                                    phi_11862_ = _e11290;
                                                }
                                                let _e3378 = phi_11862_;
                                                phi_11863_ = _e3378;
                                            } else {
                                                phi_11863_ = _e3108;
                                            }
                                            let _e3380 = phi_11863_;
                                            phi_11865_ = type_46(_e3298, _e3380, _e3159);
                                        } else {
                                            phi_11865_ = _e3169;
                                        }
                                        let _e3383 = phi_11865_;
                                        if (_e3383.member > _e3383.member_1) {
                                            phi_15732_ = bool();
                                            phi_15733_ = f64();
                                            phi_15734_ = f64();
                                            phi_15735_ = true;
                                            phi_15736_ = false;
                                            phi_15737_ = false;
                                            phi_15738_ = false;
                                        } else {
                                            let _e3391 = ((_e3383.member_1 - _e3383.member) * f64(0.5f));
                                            let _e3392 = (_e3383.member + _e3391);
                                            let _e3395 = (_e3391 + (1.1102230246251565e-16lf * f64(4f)));
                                            let _e3397 = local_18.member_3;
                                            let _e3400 = local_18.member[0u];
                                            if (_e3400[0] < 0.0lf) {
                                                phi_11896_ = -(_e3400[0]);
                                            } else {
                                                phi_11896_ = _e3400[0];
                                            }
                                            let _e3407 = phi_11896_;
                                            if (_e3400[1] < 0.0lf) {
                                                phi_11903_ = -(_e3400[1]);
                                            } else {
                                                phi_11903_ = _e3400[1];
                                            }
                                            let _e3411 = phi_11903_;
                                            if (_e3407 > _e3411) {
                                                phi_11908_ = _e3407;
                                            } else {
                                                phi_11908_ = _e3411;
                                            }
                                            let _e3414 = phi_11908_;
                                            if (_e3400[2] < 0.0lf) {
                                                phi_11915_ = -(_e3400[2]);
                                            } else {
                                                phi_11915_ = _e3400[2];
                                            }
                                            let _e3418 = phi_11915_;
                                            if (_e3414 > _e3418) {
                                                phi_11920_ = _e3414;
                                            } else {
                                                phi_11920_ = _e3418;
                                            }
                                            let _e3421 = phi_11920_;
                                            let _e3423 = local_18.member[1u];
                                            if (_e3423[0] < 0.0lf) {
                                                phi_11933_ = -(_e3423[0]);
                                            } else {
                                                phi_11933_ = _e3423[0];
                                            }
                                            let _e3430 = phi_11933_;
                                            if (_e3423[1] < 0.0lf) {
                                                phi_11940_ = -(_e3423[1]);
                                            } else {
                                                phi_11940_ = _e3423[1];
                                            }
                                            let _e3434 = phi_11940_;
                                            if (_e3430 > _e3434) {
                                                phi_11945_ = _e3430;
                                            } else {
                                                phi_11945_ = _e3434;
                                            }
                                            let _e3437 = phi_11945_;
                                            if (_e3423[2] < 0.0lf) {
                                                phi_11952_ = -(_e3423[2]);
                                            } else {
                                                phi_11952_ = _e3423[2];
                                            }
                                            let _e3441 = phi_11952_;
                                            if (_e3437 > _e3441) {
                                                phi_11957_ = _e3437;
                                            } else {
                                                phi_11957_ = _e3441;
                                            }
                                            let _e3444 = phi_11957_;
                                            if (_e3421 > _e3444) {
                                                phi_11962_ = _e3421;
                                            } else {
                                                phi_11962_ = _e3444;
                                            }
                                            let _e3447 = phi_11962_;
                                            let _e3450 = local_18.member[0u];
                                            let _e3455 = local_18.member[1u];
                                            let _e3465 = (_e3450[0] + ((_e3455[0] - _e3450[0]) * _e3392));
                                            let _e3466 = (_e3450[1] + ((_e3455[1] - _e3450[1]) * _e3392));
                                            let _e3467 = (_e3450[2] + ((_e3455[2] - _e3450[2]) * _e3392));
                                            let _e3469 = local_18.member[1u];
                                            let _e3474 = local_18.member[0u];
                                            let _e3478 = (_e3469[0] - _e3474[0]);
                                            let _e3479 = (_e3469[1] - _e3474[1]);
                                            let _e3480 = (_e3469[2] - _e3474[2]);
                                            if (_e3478 < 0.0lf) {
                                                phi_12021_ = -(_e3478);
                                            } else {
                                                phi_12021_ = _e3478;
                                            }
                                            let _e3484 = phi_12021_;
                                            if (_e3479 < 0.0lf) {
                                                phi_12027_ = -(_e3479);
                                            } else {
                                                phi_12027_ = _e3479;
                                            }
                                            let _e3488 = phi_12027_;
                                            if (_e3484 > _e3488) {
                                                phi_12032_ = _e3484;
                                            } else {
                                                phi_12032_ = _e3488;
                                            }
                                            let _e3491 = phi_12032_;
                                            if (_e3480 < 0.0lf) {
                                                phi_12038_ = -(_e3480);
                                            } else {
                                                phi_12038_ = _e3480;
                                            }
                                            let _e3495 = phi_12038_;
                                            if (_e3491 > _e3495) {
                                                phi_12043_ = _e3491;
                                            } else {
                                                phi_12043_ = _e3495;
                                            }
                                            let _e3498 = phi_12043_;
                                            let _e3506 = ((((_e3395 * _e3498) * f64(1.01f)) + ((_e3447 + _e3397) * (1.1102230246251565e-16lf * f64(8f)))) + _e3397);
                                            if (_e3465 < 0.0lf) {
                                                phi_12057_ = -(_e3465);
                                            } else {
                                                phi_12057_ = _e3465;
                                            }
                                            let _e3510 = phi_12057_;
                                            if (_e3466 < 0.0lf) {
                                                phi_12063_ = -(_e3466);
                                            } else {
                                                phi_12063_ = _e3466;
                                            }
                                            let _e3514 = phi_12063_;
                                            if (_e3510 > _e3514) {
                                                phi_12068_ = _e3510;
                                            } else {
                                                phi_12068_ = _e3514;
                                            }
                                            let _e3517 = phi_12068_;
                                            if (_e3467 < 0.0lf) {
                                                phi_12074_ = -(_e3467);
                                            } else {
                                                phi_12074_ = _e3467;
                                            }
                                            let _e3521 = phi_12074_;
                                            if (_e3517 > _e3521) {
                                                phi_12079_ = _e3517;
                                            } else {
                                                phi_12079_ = _e3521;
                                            }
                                            let _e3524 = phi_12079_;
                                            local_2 = type_36(array<f64, 3>(_e3465, _e3466, _e3467), _e3506, (_e3524 + _e3506));
                                            let _e3530 = local_18.member_3;
                                            let _e3532 = local_18.member_1[0u];
                                            if (_e3532[0] < 0.0lf) {
                                                phi_12105_ = -(_e3532[0]);
                                            } else {
                                                phi_12105_ = _e3532[0];
                                            }
                                            let _e3539 = phi_12105_;
                                            if (_e3532[1] < 0.0lf) {
                                                phi_12112_ = -(_e3532[1]);
                                            } else {
                                                phi_12112_ = _e3532[1];
                                            }
                                            let _e3543 = phi_12112_;
                                            if (_e3539 > _e3543) {
                                                phi_12117_ = _e3539;
                                            } else {
                                                phi_12117_ = _e3543;
                                            }
                                            let _e3546 = phi_12117_;
                                            if (_e3532[2] < 0.0lf) {
                                                phi_12124_ = -(_e3532[2]);
                                            } else {
                                                phi_12124_ = _e3532[2];
                                            }
                                            let _e3550 = phi_12124_;
                                            if (_e3546 > _e3550) {
                                                phi_12129_ = _e3546;
                                            } else {
                                                phi_12129_ = _e3550;
                                            }
                                            let _e3553 = phi_12129_;
                                            let _e3555 = local_18.member_1[1u];
                                            if (_e3555[0] < 0.0lf) {
                                                phi_12142_ = -(_e3555[0]);
                                            } else {
                                                phi_12142_ = _e3555[0];
                                            }
                                            let _e3562 = phi_12142_;
                                            if (_e3555[1] < 0.0lf) {
                                                phi_12149_ = -(_e3555[1]);
                                            } else {
                                                phi_12149_ = _e3555[1];
                                            }
                                            let _e3566 = phi_12149_;
                                            if (_e3562 > _e3566) {
                                                phi_12154_ = _e3562;
                                            } else {
                                                phi_12154_ = _e3566;
                                            }
                                            let _e3569 = phi_12154_;
                                            if (_e3555[2] < 0.0lf) {
                                                phi_12161_ = -(_e3555[2]);
                                            } else {
                                                phi_12161_ = _e3555[2];
                                            }
                                            let _e3573 = phi_12161_;
                                            if (_e3569 > _e3573) {
                                                phi_12166_ = _e3569;
                                            } else {
                                                phi_12166_ = _e3573;
                                            }
                                            let _e3576 = phi_12166_;
                                            if (_e3553 > _e3576) {
                                                phi_12171_ = _e3553;
                                            } else {
                                                phi_12171_ = _e3576;
                                            }
                                            let _e3579 = phi_12171_;
                                            let _e3582 = local_18.member_1[0u];
                                            let _e3587 = local_18.member_1[1u];
                                            let _e3597 = (_e3582[0] + ((_e3587[0] - _e3582[0]) * _e3392));
                                            let _e3598 = (_e3582[1] + ((_e3587[1] - _e3582[1]) * _e3392));
                                            let _e3599 = (_e3582[2] + ((_e3587[2] - _e3582[2]) * _e3392));
                                            let _e3601 = local_18.member_1[1u];
                                            let _e3606 = local_18.member_1[0u];
                                            let _e3610 = (_e3601[0] - _e3606[0]);
                                            let _e3611 = (_e3601[1] - _e3606[1]);
                                            let _e3612 = (_e3601[2] - _e3606[2]);
                                            if (_e3610 < 0.0lf) {
                                                phi_12230_ = -(_e3610);
                                            } else {
                                                phi_12230_ = _e3610;
                                            }
                                            let _e3616 = phi_12230_;
                                            if (_e3611 < 0.0lf) {
                                                phi_12236_ = -(_e3611);
                                            } else {
                                                phi_12236_ = _e3611;
                                            }
                                            let _e3620 = phi_12236_;
                                            if (_e3616 > _e3620) {
                                                phi_12241_ = _e3616;
                                            } else {
                                                phi_12241_ = _e3620;
                                            }
                                            let _e3623 = phi_12241_;
                                            if (_e3612 < 0.0lf) {
                                                phi_12247_ = -(_e3612);
                                            } else {
                                                phi_12247_ = _e3612;
                                            }
                                            let _e3627 = phi_12247_;
                                            if (_e3623 > _e3627) {
                                                phi_12252_ = _e3623;
                                            } else {
                                                phi_12252_ = _e3627;
                                            }
                                            let _e3630 = phi_12252_;
                                            let _e3638 = ((((_e3395 * _e3630) * f64(1.01f)) + ((_e3579 + _e3530) * (1.1102230246251565e-16lf * f64(8f)))) + _e3530);
                                            if (_e3597 < 0.0lf) {
                                                phi_12266_ = -(_e3597);
                                            } else {
                                                phi_12266_ = _e3597;
                                            }
                                            let _e3642 = phi_12266_;
                                            if (_e3598 < 0.0lf) {
                                                phi_12272_ = -(_e3598);
                                            } else {
                                                phi_12272_ = _e3598;
                                            }
                                            let _e3646 = phi_12272_;
                                            if (_e3642 > _e3646) {
                                                phi_12277_ = _e3642;
                                            } else {
                                                phi_12277_ = _e3646;
                                            }
                                            let _e3649 = phi_12277_;
                                            if (_e3599 < 0.0lf) {
                                                phi_12283_ = -(_e3599);
                                            } else {
                                                phi_12283_ = _e3599;
                                            }
                                            let _e3653 = phi_12283_;
                                            if (_e3649 > _e3653) {
                                                phi_12288_ = _e3649;
                                            } else {
                                                phi_12288_ = _e3653;
                                            }
                                            let _e3656 = phi_12288_;
                                            local_3 = type_36(array<f64, 3>(_e3597, _e3598, _e3599), _e3638, (_e3656 + _e3638));
                                            let _e3662 = local_18.member_3;
                                            let _e3664 = local_18.member_2[0u];
                                            if (_e3664[0] < 0.0lf) {
                                                phi_12314_ = -(_e3664[0]);
                                            } else {
                                                phi_12314_ = _e3664[0];
                                            }
                                            let _e3671 = phi_12314_;
                                            if (_e3664[1] < 0.0lf) {
                                                phi_12321_ = -(_e3664[1]);
                                            } else {
                                                phi_12321_ = _e3664[1];
                                            }
                                            let _e3675 = phi_12321_;
                                            if (_e3671 > _e3675) {
                                                phi_12326_ = _e3671;
                                            } else {
                                                phi_12326_ = _e3675;
                                            }
                                            let _e3678 = phi_12326_;
                                            if (_e3664[2] < 0.0lf) {
                                                phi_12333_ = -(_e3664[2]);
                                            } else {
                                                phi_12333_ = _e3664[2];
                                            }
                                            let _e3682 = phi_12333_;
                                            if (_e3678 > _e3682) {
                                                phi_12338_ = _e3678;
                                            } else {
                                                phi_12338_ = _e3682;
                                            }
                                            let _e3685 = phi_12338_;
                                            let _e3687 = local_18.member_2[1u];
                                            if (_e3687[0] < 0.0lf) {
                                                phi_12351_ = -(_e3687[0]);
                                            } else {
                                                phi_12351_ = _e3687[0];
                                            }
                                            let _e3694 = phi_12351_;
                                            if (_e3687[1] < 0.0lf) {
                                                phi_12358_ = -(_e3687[1]);
                                            } else {
                                                phi_12358_ = _e3687[1];
                                            }
                                            let _e3698 = phi_12358_;
                                            if (_e3694 > _e3698) {
                                                phi_12363_ = _e3694;
                                            } else {
                                                phi_12363_ = _e3698;
                                            }
                                            let _e3701 = phi_12363_;
                                            if (_e3687[2] < 0.0lf) {
                                                phi_12370_ = -(_e3687[2]);
                                            } else {
                                                phi_12370_ = _e3687[2];
                                            }
                                            let _e3705 = phi_12370_;
                                            if (_e3701 > _e3705) {
                                                phi_12375_ = _e3701;
                                            } else {
                                                phi_12375_ = _e3705;
                                            }
                                            let _e3708 = phi_12375_;
                                            if (_e3685 > _e3708) {
                                                phi_12380_ = _e3685;
                                            } else {
                                                phi_12380_ = _e3708;
                                            }
                                            let _e3711 = phi_12380_;
                                            let _e3714 = local_18.member_2[0u];
                                            let _e3719 = local_18.member_2[1u];
                                            let _e3729 = (_e3714[0] + ((_e3719[0] - _e3714[0]) * _e3392));
                                            let _e3730 = (_e3714[1] + ((_e3719[1] - _e3714[1]) * _e3392));
                                            let _e3731 = (_e3714[2] + ((_e3719[2] - _e3714[2]) * _e3392));
                                            let _e3733 = local_18.member_2[1u];
                                            let _e3738 = local_18.member_2[0u];
                                            let _e3742 = (_e3733[0] - _e3738[0]);
                                            let _e3743 = (_e3733[1] - _e3738[1]);
                                            let _e3744 = (_e3733[2] - _e3738[2]);
                                            if (_e3742 < 0.0lf) {
                                                phi_12439_ = -(_e3742);
                                            } else {
                                                phi_12439_ = _e3742;
                                            }
                                            let _e3748 = phi_12439_;
                                            if (_e3743 < 0.0lf) {
                                                phi_12445_ = -(_e3743);
                                            } else {
                                                phi_12445_ = _e3743;
                                            }
                                            let _e3752 = phi_12445_;
                                            if (_e3748 > _e3752) {
                                                phi_12450_ = _e3748;
                                            } else {
                                                phi_12450_ = _e3752;
                                            }
                                            let _e3755 = phi_12450_;
                                            if (_e3744 < 0.0lf) {
                                                phi_12456_ = -(_e3744);
                                            } else {
                                                phi_12456_ = _e3744;
                                            }
                                            let _e3759 = phi_12456_;
                                            if (_e3755 > _e3759) {
                                                phi_12461_ = _e3755;
                                            } else {
                                                phi_12461_ = _e3759;
                                            }
                                            let _e3762 = phi_12461_;
                                            let _e3770 = ((((_e3395 * _e3762) * f64(1.01f)) + ((_e3711 + _e3662) * (1.1102230246251565e-16lf * f64(8f)))) + _e3662);
                                            if (_e3729 < 0.0lf) {
                                                phi_12475_ = -(_e3729);
                                            } else {
                                                phi_12475_ = _e3729;
                                            }
                                            let _e3774 = phi_12475_;
                                            if (_e3730 < 0.0lf) {
                                                phi_12481_ = -(_e3730);
                                            } else {
                                                phi_12481_ = _e3730;
                                            }
                                            let _e3778 = phi_12481_;
                                            if (_e3774 > _e3778) {
                                                phi_12486_ = _e3774;
                                            } else {
                                                phi_12486_ = _e3778;
                                            }
                                            let _e3781 = phi_12486_;
                                            if (_e3731 < 0.0lf) {
                                                phi_12492_ = -(_e3731);
                                            } else {
                                                phi_12492_ = _e3731;
                                            }
                                            let _e3785 = phi_12492_;
                                            if (_e3781 > _e3785) {
                                                phi_12497_ = _e3781;
                                            } else {
                                                phi_12497_ = _e3785;
                                            }
                                            let _e3788 = phi_12497_;
                                            local_4 = type_36(array<f64, 3>(_e3729, _e3730, _e3731), _e3770, (_e3788 + _e3770));
                                            let _e3793 = local_3.member;
                                            let _e3798 = local_4.member;
                                            let _e3804 = ((_e3793[1] * _e3798[2]) - (_e3793[2] * _e3798[1]));
                                            let _e3807 = ((_e3793[2] * _e3798[0]) - (_e3793[0] * _e3798[2]));
                                            let _e3810 = ((_e3793[0] * _e3798[1]) - (_e3793[1] * _e3798[0]));
                                            if (_e3804 < 0.0lf) {
                                                phi_12546_ = -(_e3804);
                                            } else {
                                                phi_12546_ = _e3804;
                                            }
                                            let _e3814 = phi_12546_;
                                            if (_e3807 < 0.0lf) {
                                                phi_12552_ = -(_e3807);
                                            } else {
                                                phi_12552_ = _e3807;
                                            }
                                            let _e3818 = phi_12552_;
                                            if (_e3814 > _e3818) {
                                                if (_e3804 < 0.0lf) {
                                                    phi_12562_ = -(_e3804);
                                                } else {
                                                    phi_12562_ = _e3804;
                                                }
                                                let _e3836 = phi_12562_;
                                                if (_e3810 < 0.0lf) {
                                                    phi_12568_ = -(_e3810);
                                                } else {
                                                    phi_12568_ = _e3810;
                                                }
                                                let _e3840 = phi_12568_;
                                                if (_e3836 > _e3840) {
                                                    phi_12573_ = 2u;
                                                    phi_12574_ = 1u;
                                                } else {
                                                    phi_12573_ = 1u;
                                                    phi_12574_ = 0u;
                                                }
                                                let _e3843 = phi_12573_;
                                                let _e3845 = phi_12574_;
                                                phi_12593_ = _e3843;
                                                phi_12594_ = _e3845;
                                            } else {
                                                if (_e3807 < 0.0lf) {
                                                    phi_12580_ = -(_e3807);
                                                } else {
                                                    phi_12580_ = _e3807;
                                                }
                                                let _e3823 = phi_12580_;
                                                if (_e3810 < 0.0lf) {
                                                    phi_12586_ = -(_e3810);
                                                } else {
                                                    phi_12586_ = _e3810;
                                                }
                                                let _e3827 = phi_12586_;
                                                if (_e3823 > _e3827) {
                                                    phi_12591_ = 0u;
                                                    phi_12592_ = 2u;
                                                } else {
                                                    phi_12591_ = 1u;
                                                    phi_12592_ = 0u;
                                                }
                                                let _e3830 = phi_12591_;
                                                let _e3832 = phi_12592_;
                                                phi_12593_ = _e3830;
                                                phi_12594_ = _e3832;
                                            }
                                            let _e3847 = phi_12593_;
                                            let _e3849 = phi_12594_;
                                            let _e3852 = local_3.member[_e3849];
                                            let _e3855 = local_4.member[_e3847];
                                            let _e3859 = local_3.member[_e3847];
                                            let _e3862 = local_4.member[_e3849];
                                            let _e3864 = ((_e3852 * _e3855) - (_e3859 * _e3862));
                                            let _e3865 = f64(1f);
                                            let _e3866 = f64(2f);
                                            let _e3868 = local_3.member_1;
                                            let _e3870 = local_4.member_2;
                                            let _e3873 = local_3.member_2;
                                            let _e3875 = local_4.member_1;
                                            let _e3881 = local_3.member_2;
                                            let _e3884 = local_4.member_2;
                                            let _e3893 = local_3.member_2;
                                            let _e3896 = local_4.member_2;
                                            let _e3900 = (((((_e3868 * _e3870) + (_e3873 * _e3875)) * f64(2.01f)) + (((_e3881 * _e3866) * (_e3884 * _e3866)) * (1.1102230246251565e-16lf * _e3866))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3865 + _e3893) * (_e3865 + _e3896))));
                                            if (_e3864 < 0.0lf) {
                                                phi_12667_ = -(_e3864);
                                            } else {
                                                phi_12667_ = _e3864;
                                            }
                                            let _e3904 = phi_12667_;
                                            if (_e3904 > _e3900) {
                                                if (_e3864 < f64(0f)) {
                                                    phi_12679_ = f64(-1f);
                                                } else {
                                                    phi_12679_ = f64(1f);
                                                }
                                                let _e3911 = phi_12679_;
                                                let _e3914 = local_2.member[_e3849];
                                                let _e3917 = local_4.member[_e3847];
                                                let _e3921 = local_2.member[_e3847];
                                                let _e3924 = local_4.member[_e3849];
                                                let _e3927 = f64(1f);
                                                let _e3928 = f64(2f);
                                                let _e3930 = local_2.member_1;
                                                let _e3932 = local_4.member_2;
                                                let _e3935 = local_2.member_2;
                                                let _e3937 = local_4.member_1;
                                                let _e3943 = local_2.member_2;
                                                let _e3946 = local_4.member_2;
                                                let _e3955 = local_2.member_2;
                                                let _e3958 = local_4.member_2;
                                                let _e3962 = (((((_e3930 * _e3932) + (_e3935 * _e3937)) * f64(2.01f)) + (((_e3943 * _e3928) * (_e3946 * _e3928)) * (1.1102230246251565e-16lf * _e3928))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3927 + _e3955) * (_e3927 + _e3958))));
                                                let _e3965 = local_3.member[_e3849];
                                                let _e3968 = local_2.member[_e3847];
                                                let _e3972 = local_3.member[_e3847];
                                                let _e3975 = local_2.member[_e3849];
                                                let _e3978 = f64(1f);
                                                let _e3979 = f64(2f);
                                                let _e3981 = local_3.member_1;
                                                let _e3983 = local_2.member_2;
                                                let _e3986 = local_3.member_2;
                                                let _e3988 = local_2.member_1;
                                                let _e3994 = local_3.member_2;
                                                let _e3997 = local_2.member_2;
                                                let _e4006 = local_3.member_2;
                                                let _e4009 = local_2.member_2;
                                                let _e4013 = (((((_e3981 * _e3983) + (_e3986 * _e3988)) * f64(2.01f)) + (((_e3994 * _e3979) * (_e3997 * _e3979)) * (1.1102230246251565e-16lf * _e3979))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3978 + _e4006) * (_e3978 + _e4009))));
                                                let _e4014 = (_e3864 * _e3911);
                                                let _e4015 = (((_e3914 * _e3917) - (_e3921 * _e3924)) * _e3911);
                                                let _e4016 = (((_e3965 * _e3968) - (_e3972 * _e3975)) * _e3911);
                                                if (_e4014 < 0.0lf) {
                                                    phi_12822_ = -(_e4014);
                                                } else {
                                                    phi_12822_ = _e4014;
                                                }
                                                let _e4020 = phi_12822_;
                                                if (_e4015 < 0.0lf) {
                                                    phi_12828_ = -(_e4015);
                                                } else {
                                                    phi_12828_ = _e4015;
                                                }
                                                let _e4024 = phi_12828_;
                                                if (_e4016 < 0.0lf) {
                                                    phi_12835_ = -(_e4016);
                                                } else {
                                                    phi_12835_ = _e4016;
                                                }
                                                let _e4029 = phi_12835_;
                                                let _e4033 = (((_e4020 + _e4024) + _e4029) * (1.1102230246251565e-16lf * f64(4f)));
                                                if (_e247.member != 0u) {
                                                    phi_12871_ = array<type_37, 4>(type_37(_e4015, _e3962), type_37(_e4016, _e4013), type_37((_e4014 - _e4015), ((_e3900 + _e3962) + _e4033)), type_37((_e4014 - _e4016), ((_e3900 + _e4013) + _e4033)));
                                                } else {
                                                    let _e4036 = ((_e4014 - _e4015) - _e4016);
                                                    let _e4039 = (((_e3900 + _e3962) + _e4013) + _e4033);
                                                    phi_12871_ = array<type_37, 4>(type_37(_e4015, _e3962), type_37(_e4016, _e4013), type_37(_e4036, _e4039), type_37(_e4036, _e4039));
                                                }
                                                let _e4057 = phi_12871_;
                                                local_5 = array<type_37, 4>(type_37(_e4057[0].member, _e4057[0].member_1), type_37(_e4057[1].member, _e4057[1].member_1), type_37(_e4057[2].member, _e4057[2].member_1), type_37(_e4057[3].member, _e4057[3].member_1));
                                                phi_12891_ = type_9(0u, 4u);
                                                phi_12894_ = true;
                                                loop {
                                                    let _e4076 = phi_12891_;
                                                    let _e4078 = phi_12894_;
                                                    local_27 = _e4078;
                                                    if (_e4076.member < _e4076.member_1) {
                                                        phi_12892_ = type_9((_e4076.member + 1u), _e4076.member_1);
                                                        phi_12917_ = type_9(1u, _e4076.member);
                                                    } else {
                                                        phi_12892_ = _e4076;
                                                        phi_12917_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e4090 = phi_12892_;
                                                    let _e4092 = phi_12917_;
                                                    if (bitcast<i32>(_e4092.member) != 0i) {
                                                        let _e4099 = local_5[_e4092.member_1].member;
                                                        let _e4102 = local_5[_e4092.member_1].member_1;
                                                        let _e4104 = (_e4099 < -(_e4102));
                                                        if _e4104 {
                                                            phi_12944_ = bool();
                                                            phi_12945_ = false;
                                                        } else {
                                                            phi_12944_ = (_e4078 && (_e4099 > _e4102));
                                                            phi_12945_ = true;
                                                        }
                                                        let _e4108 = phi_12944_;
                                                        let _e4110 = phi_12945_;
                                                        phi_12895_ = _e4108;
                                                        phi_12946_ = _e4110;
                                                        phi_12947_ = _e4104;
                                                    } else {
                                                        phi_12895_ = bool();
                                                        phi_12946_ = false;
                                                        phi_12947_ = false;
                                                    }
                                                    let _e4112 = phi_12895_;
                                                    let _e4114 = phi_12946_;
                                                    let _e4116 = phi_12947_;
                                                    local_26 = _e4116;
                                                    continue;
                                                    continuing {
                                                        phi_12891_ = _e4090;
                                                        phi_12894_ = _e4112;
                                                        break if !(_e4114);
                                                    }
                                                }
                                                let _e4119 = local_26;
                                                if _e4119 {
                                                    phi_12951_ = false;
                                                } else {
                                                    phi_12951_ = true;
                                                }
                                                let _e4121 = phi_12951_;
                                                if _e4121 {
                                                    let _e4123 = local_27;
                                                    if _e4123 {
                                                        phi_12958_ = 1u;
                                                    } else {
                                                        phi_12958_ = 2u;
                                                    }
                                                    let _e4125 = phi_12958_;
                                                    phi_12959_ = _e4125;
                                                    phi_12960_ = false;
                                                } else {
                                                    phi_12959_ = u32();
                                                    phi_12960_ = true;
                                                }
                                                let _e4127 = phi_12959_;
                                                let _e4129 = phi_12960_;
                                                phi_12961_ = _e4127;
                                                phi_12962_ = 0u;
                                                phi_12963_ = _e4129;
                                            } else {
                                                phi_12961_ = u32();
                                                phi_12962_ = 2u;
                                                phi_12963_ = true;
                                            }
                                            let _e4131 = phi_12961_;
                                            let _e4133 = phi_12962_;
                                            let _e4135 = phi_12963_;
                                            if _e4135 {
                                                phi_12967_ = _e4133;
                                            } else {
                                                phi_12967_ = _e4131;
                                            }
                                            let _e4137 = phi_12967_;
                                            let _e4138 = (_e4137 == 0u);
                                            if _e4138 {
                                                phi_15726_ = bool();
                                                phi_15727_ = f64();
                                                phi_15728_ = f64();
                                                phi_15729_ = false;
                                                phi_15730_ = false;
                                                phi_15731_ = false;
                                            } else {
                                                if (_e4137 == 1u) {
                                                    phi_12977_ = _e3383.member_2;
                                                } else {
                                                    phi_12977_ = false;
                                                }
                                                let _e4142 = phi_12977_;
                                                let _e4144 = (_e534 * f64(0.99f));
                                                if _e4142 {
                                                    if ((_e3383.member_1 - _e3383.member) <= _e4144) {
                                                        phi_12990_ = false;
                                                    } else {
                                                        phi_12990_ = true;
                                                    }
                                                    let _e4150 = phi_12990_;
                                                    phi_12991_ = _e4150;
                                                } else {
                                                    phi_12991_ = true;
                                                }
                                                let _e4152 = phi_12991_;
                                                if _e4152 {
                                                    let _e4157 = local_18.member[0u];
                                                    let _e4164 = local_18.member_1[0u];
                                                    let _e4170 = local_18.member_2[0u];
                                                    let _e4174 = (_e4157[0] - _e4164[0]);
                                                    let _e4175 = (_e4157[1] - _e4164[1]);
                                                    let _e4176 = (_e4157[2] - _e4164[2]);
                                                    if (_e247.member == 0u) {
                                                        phi_13052_ = array<f64, 3>(_e4157[0], _e4157[1], _e4157[2]);
                                                    } else {
                                                        phi_13052_ = array<f64, 3>((_e4174 - _e4170[0]), (_e4175 - _e4170[1]), (_e4176 - _e4170[2]));
                                                    }
                                                    let _e4183 = phi_13052_;
                                                    let _e4189 = local_18.member[1u];
                                                    let _e4196 = local_18.member_1[1u];
                                                    let _e4202 = local_18.member_2[1u];
                                                    let _e4206 = (_e4189[0] - _e4196[0]);
                                                    let _e4207 = (_e4189[1] - _e4196[1]);
                                                    let _e4208 = (_e4189[2] - _e4196[2]);
                                                    if (_e247.member == 0u) {
                                                        phi_13117_ = array<f64, 3>(_e4189[0], _e4189[1], _e4189[2]);
                                                    } else {
                                                        phi_13117_ = array<f64, 3>((_e4206 - _e4202[0]), (_e4207 - _e4202[1]), (_e4208 - _e4202[2]));
                                                    }
                                                    let _e4215 = phi_13117_;
                                                    let _e4221 = local_18.member[0u];
                                                    if (_e4221[0] < 0.0lf) {
                                                        phi_13139_ = -(_e4221[0]);
                                                    } else {
                                                        phi_13139_ = _e4221[0];
                                                    }
                                                    let _e4228 = phi_13139_;
                                                    if (_e4221[1] < 0.0lf) {
                                                        phi_13146_ = -(_e4221[1]);
                                                    } else {
                                                        phi_13146_ = _e4221[1];
                                                    }
                                                    let _e4232 = phi_13146_;
                                                    if (_e4228 > _e4232) {
                                                        phi_13151_ = _e4228;
                                                    } else {
                                                        phi_13151_ = _e4232;
                                                    }
                                                    let _e4235 = phi_13151_;
                                                    if (_e4221[2] < 0.0lf) {
                                                        phi_13158_ = -(_e4221[2]);
                                                    } else {
                                                        phi_13158_ = _e4221[2];
                                                    }
                                                    let _e4239 = phi_13158_;
                                                    if (_e4235 > _e4239) {
                                                        phi_13163_ = _e4235;
                                                    } else {
                                                        phi_13163_ = _e4239;
                                                    }
                                                    let _e4242 = phi_13163_;
                                                    let _e4245 = local_18.member[1u];
                                                    if (_e4245[0] < 0.0lf) {
                                                        phi_13176_ = -(_e4245[0]);
                                                    } else {
                                                        phi_13176_ = _e4245[0];
                                                    }
                                                    let _e4252 = phi_13176_;
                                                    if (_e4245[1] < 0.0lf) {
                                                        phi_13183_ = -(_e4245[1]);
                                                    } else {
                                                        phi_13183_ = _e4245[1];
                                                    }
                                                    let _e4256 = phi_13183_;
                                                    if (_e4252 > _e4256) {
                                                        phi_13188_ = _e4252;
                                                    } else {
                                                        phi_13188_ = _e4256;
                                                    }
                                                    let _e4259 = phi_13188_;
                                                    if (_e4245[2] < 0.0lf) {
                                                        phi_13195_ = -(_e4245[2]);
                                                    } else {
                                                        phi_13195_ = _e4245[2];
                                                    }
                                                    let _e4263 = phi_13195_;
                                                    if (_e4259 > _e4263) {
                                                        phi_13200_ = _e4259;
                                                    } else {
                                                        phi_13200_ = _e4263;
                                                    }
                                                    let _e4266 = phi_13200_;
                                                    if (_e4242 > _e4266) {
                                                        phi_13205_ = _e4242;
                                                    } else {
                                                        phi_13205_ = _e4266;
                                                    }
                                                    let _e4269 = phi_13205_;
                                                    let _e4271 = local_18.member_3;
                                                    let _e4275 = local_18.member_1[0u];
                                                    if (_e4275[0] < 0.0lf) {
                                                        phi_13222_ = -(_e4275[0]);
                                                    } else {
                                                        phi_13222_ = _e4275[0];
                                                    }
                                                    let _e4282 = phi_13222_;
                                                    if (_e4275[1] < 0.0lf) {
                                                        phi_13229_ = -(_e4275[1]);
                                                    } else {
                                                        phi_13229_ = _e4275[1];
                                                    }
                                                    let _e4286 = phi_13229_;
                                                    if (_e4282 > _e4286) {
                                                        phi_13234_ = _e4282;
                                                    } else {
                                                        phi_13234_ = _e4286;
                                                    }
                                                    let _e4289 = phi_13234_;
                                                    if (_e4275[2] < 0.0lf) {
                                                        phi_13241_ = -(_e4275[2]);
                                                    } else {
                                                        phi_13241_ = _e4275[2];
                                                    }
                                                    let _e4293 = phi_13241_;
                                                    if (_e4289 > _e4293) {
                                                        phi_13246_ = _e4289;
                                                    } else {
                                                        phi_13246_ = _e4293;
                                                    }
                                                    let _e4296 = phi_13246_;
                                                    let _e4299 = local_18.member_1[1u];
                                                    if (_e4299[0] < 0.0lf) {
                                                        phi_13260_ = -(_e4299[0]);
                                                    } else {
                                                        phi_13260_ = _e4299[0];
                                                    }
                                                    let _e4306 = phi_13260_;
                                                    if (_e4299[1] < 0.0lf) {
                                                        phi_13267_ = -(_e4299[1]);
                                                    } else {
                                                        phi_13267_ = _e4299[1];
                                                    }
                                                    let _e4310 = phi_13267_;
                                                    if (_e4306 > _e4310) {
                                                        phi_13272_ = _e4306;
                                                    } else {
                                                        phi_13272_ = _e4310;
                                                    }
                                                    let _e4313 = phi_13272_;
                                                    if (_e4299[2] < 0.0lf) {
                                                        phi_13279_ = -(_e4299[2]);
                                                    } else {
                                                        phi_13279_ = _e4299[2];
                                                    }
                                                    let _e4317 = phi_13279_;
                                                    if (_e4313 > _e4317) {
                                                        phi_13284_ = _e4313;
                                                    } else {
                                                        phi_13284_ = _e4317;
                                                    }
                                                    let _e4320 = phi_13284_;
                                                    if (_e4296 > _e4320) {
                                                        phi_13289_ = _e4296;
                                                    } else {
                                                        phi_13289_ = _e4320;
                                                    }
                                                    let _e4323 = phi_13289_;
                                                    let _e4325 = local_18.member_3;
                                                    let _e4329 = local_18.member_2[0u];
                                                    if (_e4329[0] < 0.0lf) {
                                                        phi_13306_ = -(_e4329[0]);
                                                    } else {
                                                        phi_13306_ = _e4329[0];
                                                    }
                                                    let _e4336 = phi_13306_;
                                                    if (_e4329[1] < 0.0lf) {
                                                        phi_13313_ = -(_e4329[1]);
                                                    } else {
                                                        phi_13313_ = _e4329[1];
                                                    }
                                                    let _e4340 = phi_13313_;
                                                    if (_e4336 > _e4340) {
                                                        phi_13318_ = _e4336;
                                                    } else {
                                                        phi_13318_ = _e4340;
                                                    }
                                                    let _e4343 = phi_13318_;
                                                    if (_e4329[2] < 0.0lf) {
                                                        phi_13325_ = -(_e4329[2]);
                                                    } else {
                                                        phi_13325_ = _e4329[2];
                                                    }
                                                    let _e4347 = phi_13325_;
                                                    if (_e4343 > _e4347) {
                                                        phi_13330_ = _e4343;
                                                    } else {
                                                        phi_13330_ = _e4347;
                                                    }
                                                    let _e4350 = phi_13330_;
                                                    let _e4353 = local_18.member_2[1u];
                                                    if (_e4353[0] < 0.0lf) {
                                                        phi_13344_ = -(_e4353[0]);
                                                    } else {
                                                        phi_13344_ = _e4353[0];
                                                    }
                                                    let _e4360 = phi_13344_;
                                                    if (_e4353[1] < 0.0lf) {
                                                        phi_13351_ = -(_e4353[1]);
                                                    } else {
                                                        phi_13351_ = _e4353[1];
                                                    }
                                                    let _e4364 = phi_13351_;
                                                    if (_e4360 > _e4364) {
                                                        phi_13356_ = _e4360;
                                                    } else {
                                                        phi_13356_ = _e4364;
                                                    }
                                                    let _e4367 = phi_13356_;
                                                    if (_e4353[2] < 0.0lf) {
                                                        phi_13363_ = -(_e4353[2]);
                                                    } else {
                                                        phi_13363_ = _e4353[2];
                                                    }
                                                    let _e4371 = phi_13363_;
                                                    if (_e4367 > _e4371) {
                                                        phi_13368_ = _e4367;
                                                    } else {
                                                        phi_13368_ = _e4371;
                                                    }
                                                    let _e4374 = phi_13368_;
                                                    if (_e4350 > _e4374) {
                                                        phi_13373_ = _e4350;
                                                    } else {
                                                        phi_13373_ = _e4374;
                                                    }
                                                    let _e4377 = phi_13373_;
                                                    let _e4379 = local_18.member_3;
                                                    let _e4387 = local_18.member_3;
                                                    let _e4395 = (_e534 * f64(0.00390625f));
                                                    let _e4396 = f64(0f);
                                                    let _e4397 = f64(1f);
                                                    local = type_35(array<f64, 4>(_e4396, _e4396, _e4396, _e4396), array<f64, 4>(_e4396, _e4396, _e4396, _e4396), array<f64, 4>(_e4397, _e4397, _e4397, _e4397));
                                                    phi_13420_ = type_9(0u, 96u);
                                                    phi_13423_ = _e3383.member;
                                                    phi_13425_ = _e3383.member;
                                                    phi_13427_ = (_e3383.member_1 - _e3383.member);
                                                    phi_13429_ = _e3383.member;
                                                    phi_13431_ = false;
                                                    phi_13433_ = 0u;
                                                    loop {
                                                        let _e4404 = phi_13420_;
                                                        let _e4406 = phi_13423_;
                                                        let _e4408 = phi_13425_;
                                                        let _e4410 = phi_13427_;
                                                        let _e4412 = phi_13429_;
                                                        let _e4414 = phi_13431_;
                                                        let _e4416 = phi_13433_;
                                                        local_31 = _e4406;
                                                        local_78 = _e4408;
                                                        if (_e4404.member < _e4404.member_1) {
                                                            phi_13421_ = type_9((_e4404.member + 1u), _e4404.member_1);
                                                            phi_13456_ = type_9(1u, _e4404.member);
                                                        } else {
                                                            phi_13421_ = _e4404;
                                                            phi_13456_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e4428 = phi_13421_;
                                                        let _e4430 = phi_13456_;
                                                        if (bitcast<i32>(_e4430.member) != 0i) {
                                                            let _e4436 = local_18.member[0u];
                                                            let _e4442 = local_18.member[1u];
                                                            let _e4458 = local_18.member_1[0u];
                                                            let _e4464 = local_18.member_1[1u];
                                                            let _e4480 = local_18.member_2[0u];
                                                            let _e4486 = local_18.member_2[1u];
                                                            let _e4500 = function_4(array<f64, 3>((_e4436[0] + ((_e4442[0] - _e4436[0]) * _e4406)), (_e4436[1] + ((_e4442[1] - _e4436[1]) * _e4406)), (_e4436[2] + ((_e4442[2] - _e4436[2]) * _e4406))), array<f64, 3>((_e4458[0] + ((_e4464[0] - _e4458[0]) * _e4406)), (_e4458[1] + ((_e4464[1] - _e4458[1]) * _e4406)), (_e4458[2] + ((_e4464[2] - _e4458[2]) * _e4406))), array<f64, 3>((_e4480[0] + ((_e4486[0] - _e4480[0]) * _e4406)), (_e4480[1] + ((_e4486[1] - _e4480[1]) * _e4406)), (_e4480[2] + ((_e4486[2] - _e4480[2]) * _e4406))), _e247.member);
                                                            if (_e4416 == 0u) {
                                                                phi_13585_ = _e4500;
                                                            } else {
                                                                let _e4502 = f64(0f);
                                                                if (_e4416 == 1u) {
                                                                    phi_13571_ = _e4500[0];
                                                                } else {
                                                                    phi_13571_ = _e4502;
                                                                }
                                                                let _e4506 = phi_13571_;
                                                                if (_e4416 == 2u) {
                                                                    phi_13577_ = _e4500[1];
                                                                } else {
                                                                    phi_13577_ = _e4502;
                                                                }
                                                                let _e4510 = phi_13577_;
                                                                if (_e4416 == 3u) {
                                                                    phi_13583_ = _e4500[2];
                                                                } else {
                                                                    phi_13583_ = _e4502;
                                                                }
                                                                let _e4514 = phi_13583_;
                                                                phi_13585_ = array<f64, 3>(_e4506, _e4510, _e4514);
                                                            }
                                                            let _e4517 = phi_13585_;
                                                            if (_e4517[0] < 0.0lf) {
                                                                phi_13592_ = -(_e4517[0]);
                                                            } else {
                                                                phi_13592_ = _e4517[0];
                                                            }
                                                            let _e4522 = phi_13592_;
                                                            if (_e4517[1] < 0.0lf) {
                                                                phi_13599_ = -(_e4517[1]);
                                                            } else {
                                                                phi_13599_ = _e4517[1];
                                                            }
                                                            let _e4527 = phi_13599_;
                                                            if (_e4517[2] < 0.0lf) {
                                                                phi_13607_ = -(_e4517[2]);
                                                            } else {
                                                                phi_13607_ = _e4517[2];
                                                            }
                                                            let _e4533 = phi_13607_;
                                                            let _e4534 = ((_e4522 + _e4527) + _e4533);
                                                            if (_e4534 > f64(0f)) {
                                                                if ((bitcast<u64>(_e4534) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                                    let _e4541 = (f64(1f) / _e4534);
                                                                    let _e4543 = (_e4517[0] * _e4541);
                                                                    let _e4545 = (_e4517[1] * _e4541);
                                                                    let _e4547 = (_e4517[2] * _e4541);
                                                                    let _e4552 = (((_e4543 * _e4543) + (_e4545 * _e4545)) + (_e4547 * _e4547));
                                                                    if (_e4552 <= 2.2250738585072014e-308lf) {
                                                                        if (_e4552 > 0.0lf) {
                                                                            phi_13646_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_13646_ = 0.0lf;
                                                                        }
                                                                        let _e4604 = phi_13646_;
                                                                        phi_13710_ = _e4604;
                                                                    } else {
                                                                        phi_13653_ = type_18(0i, 5i);
                                                                        phi_13656_ = bitcast<f64>(((bitcast<u64>(_e4552) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e4559 = phi_13653_;
                                                                            let _e4561 = phi_13656_;
                                                                            local_28 = _e4561;
                                                                            if (_e4559.member < _e4559.member_1) {
                                                                                let _e4568 = (_e4559.member + 1i);
                                                                                if ((false == (_e4568 > _e4559.member)) != false) {
                                                                                    phi_13677_ = true;
                                                                                } else {
                                                                                    phi_13677_ = false;
                                                                                }
                                                                                let _e4573 = phi_13677_;
                                                                                if _e4573 {
                                                                                    phi_13683_ = type_19(0u, type_19().member_1);
                                                                                } else {
                                                                                    phi_13683_ = type_19(1u, _e4568);
                                                                                }
                                                                                let _e4578 = phi_13683_;
                                                                                phi_13654_ = type_18(_e4578.member_1, _e4559.member_1);
                                                                                phi_13697_ = type_19(1u, _e4559.member);
                                                                            } else {
                                                                                phi_13654_ = _e4559;
                                                                                phi_13697_ = type_19(0u, type_19().member_1);
                                                                            }
                                                                            let _e4584 = phi_13654_;
                                                                            let _e4586 = phi_13697_;
                                                                            let _e4589 = (bitcast<i32>(_e4586.member) != 0i);
                                                                            if _e4589 {
                                                                                phi_13657_ = (0.5lf * (_e4561 + (_e4552 / _e4561)));
                                                                            } else {
                                                                                phi_13657_ = f64();
                                                                            }
                                                                            let _e4594 = phi_13657_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_13653_ = _e4584;
                                                                                phi_13656_ = _e4594;
                                                                                break if !(_e4589);
                                                                            }
                                                                        }
                                                                        let _e4599 = local_28;
                                                                        phi_13710_ = (_e4599 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e4606 = phi_13710_;
                                                                    let _e4608 = (1.1102230246251565e-16lf * f64(12f));
                                                                    let _e4615 = ((((((((_e4269 + _e4271) + (_e4323 + _e4325)) + (_e4377 + _e4379)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4387 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e863 * _e4606) * (f64(1f) + _e4608)));
                                                                    let _e4620 = (((_e4543 * _e4157[0]) + (_e4545 * _e4157[1])) + (_e4547 * _e4157[2]));
                                                                    let _e4625 = (((_e4543 * _e4174) + (_e4545 * _e4175)) + (_e4547 * _e4176));
                                                                    let _e4630 = (((_e4543 * (_e4157[0] - _e4170[0])) + (_e4545 * (_e4157[1] - _e4170[1]))) + (_e4547 * (_e4157[2] - _e4170[2])));
                                                                    let _e4638 = (((_e4543 * _e4183[0]) + (_e4545 * _e4183[1])) + (_e4547 * _e4183[2]));
                                                                    let _e4644 = (((_e4543 * _e4189[0]) + (_e4545 * _e4189[1])) + (_e4547 * _e4189[2]));
                                                                    let _e4649 = (((_e4543 * _e4206) + (_e4545 * _e4207)) + (_e4547 * _e4208));
                                                                    let _e4654 = (((_e4543 * (_e4189[0] - _e4202[0])) + (_e4545 * (_e4189[1] - _e4202[1]))) + (_e4547 * (_e4189[2] - _e4202[2])));
                                                                    let _e4662 = (((_e4543 * _e4215[0]) + (_e4545 * _e4215[1])) + (_e4547 * _e4215[2]));
                                                                    if (_e4620 < 0.0lf) {
                                                                        phi_13779_ = -(_e4620);
                                                                    } else {
                                                                        phi_13779_ = _e4620;
                                                                    }
                                                                    let _e4667 = phi_13779_;
                                                                    if (_e4644 < 0.0lf) {
                                                                        phi_13785_ = -(_e4644);
                                                                    } else {
                                                                        phi_13785_ = _e4644;
                                                                    }
                                                                    let _e4671 = phi_13785_;
                                                                    if (_e4625 < 0.0lf) {
                                                                        phi_13794_ = -(_e4625);
                                                                    } else {
                                                                        phi_13794_ = _e4625;
                                                                    }
                                                                    let _e4678 = phi_13794_;
                                                                    if (_e4649 < 0.0lf) {
                                                                        phi_13800_ = -(_e4649);
                                                                    } else {
                                                                        phi_13800_ = _e4649;
                                                                    }
                                                                    let _e4682 = phi_13800_;
                                                                    if (_e4630 < 0.0lf) {
                                                                        phi_13809_ = -(_e4630);
                                                                    } else {
                                                                        phi_13809_ = _e4630;
                                                                    }
                                                                    let _e4689 = phi_13809_;
                                                                    if (_e4654 < 0.0lf) {
                                                                        phi_13815_ = -(_e4654);
                                                                    } else {
                                                                        phi_13815_ = _e4654;
                                                                    }
                                                                    let _e4693 = phi_13815_;
                                                                    if (_e4638 < 0.0lf) {
                                                                        phi_13824_ = -(_e4638);
                                                                    } else {
                                                                        phi_13824_ = _e4638;
                                                                    }
                                                                    let _e4700 = phi_13824_;
                                                                    if (_e4662 < 0.0lf) {
                                                                        phi_13830_ = -(_e4662);
                                                                    } else {
                                                                        phi_13830_ = _e4662;
                                                                    }
                                                                    let _e4704 = phi_13830_;
                                                                    phi_13836_ = type_35(array<f64, 4>(_e4620, _e4625, _e4630, _e4638), array<f64, 4>(_e4644, _e4649, _e4654, _e4662), array<f64, 4>((_e4615 + ((_e4667 + _e4671) * _e4608)), (_e4615 + ((_e4678 + _e4682) * _e4608)), (_e4615 + ((_e4689 + _e4693) * _e4608)), (_e4615 + ((_e4700 + _e4704) * _e4608))));
                                                                    phi_13837_ = false;
                                                                } else {
                                                                    phi_13836_ = type_35();
                                                                    phi_13837_ = true;
                                                                }
                                                                let _e4711 = phi_13836_;
                                                                let _e4713 = phi_13837_;
                                                                phi_13838_ = _e4711;
                                                                phi_13839_ = _e4713;
                                                            } else {
                                                                phi_13838_ = type_35();
                                                                phi_13839_ = true;
                                                            }
                                                            let _e4715 = phi_13838_;
                                                            let _e4717 = phi_13839_;
                                                            if _e4717 {
                                                                let _e4718 = f64(0f);
                                                                let _e4719 = f64(1f);
                                                                phi_13849_ = type_35(array<f64, 4>(_e4718, _e4718, _e4718, _e4718), array<f64, 4>(_e4718, _e4718, _e4718, _e4718), array<f64, 4>(_e4719, _e4719, _e4719, _e4719));
                                                            } else {
                                                                phi_13849_ = _e4715;
                                                            }
                                                            let _e4725 = phi_13849_;
                                                            local_1 = type_35(array<f64, 4>(_e4725.member[0], _e4725.member[1], _e4725.member[2], _e4725.member[3]), array<f64, 4>(_e4725.member_1[0], _e4725.member_1[1], _e4725.member_1[2], _e4725.member_1[3]), array<f64, 4>(_e4725.member_2[0], _e4725.member_2[1], _e4725.member_2[2], _e4725.member_2[3]));
                                                            let _e4745 = (_e4406 - _e4412);
                                                            let _e4747 = f64(0f);
                                                            let _e4750 = local_1.member[0u];
                                                            let _e4753 = local_1.member_1[0u];
                                                            let _e4756 = local_1.member[0u];
                                                            let _e4762 = local_1.member_2[0u];
                                                            if (((_e4750 + ((_e4753 - _e4756) * _e4406)) - _e4762) > _e4747) {
                                                                let _e4767 = local_1.member[1u];
                                                                let _e4770 = local_1.member_1[1u];
                                                                let _e4773 = local_1.member[1u];
                                                                let _e4779 = local_1.member_2[1u];
                                                                if (((_e4767 + ((_e4770 - _e4773) * _e4406)) - _e4779) > _e4747) {
                                                                    let _e4784 = local_1.member[2u];
                                                                    let _e4787 = local_1.member_1[2u];
                                                                    let _e4790 = local_1.member[2u];
                                                                    let _e4796 = local_1.member_2[2u];
                                                                    if (((_e4784 + ((_e4787 - _e4790) * _e4406)) - _e4796) > _e4747) {
                                                                        let _e4801 = local_1.member[3u];
                                                                        let _e4804 = local_1.member_1[3u];
                                                                        let _e4807 = local_1.member[3u];
                                                                        let _e4813 = local_1.member_2[3u];
                                                                        phi_14021_ = (((_e4801 + ((_e4804 - _e4807) * _e4406)) - _e4813) > _e4747);
                                                                        phi_14022_ = false;
                                                                    } else {
                                                                        phi_14021_ = bool();
                                                                        phi_14022_ = true;
                                                                    }
                                                                    let _e4817 = phi_14021_;
                                                                    let _e4819 = phi_14022_;
                                                                    phi_14023_ = _e4817;
                                                                    phi_14024_ = _e4819;
                                                                } else {
                                                                    phi_14023_ = bool();
                                                                    phi_14024_ = true;
                                                                }
                                                                let _e4821 = phi_14023_;
                                                                let _e4823 = phi_14024_;
                                                                phi_14025_ = _e4821;
                                                                phi_14026_ = _e4823;
                                                            } else {
                                                                phi_14025_ = bool();
                                                                phi_14026_ = true;
                                                            }
                                                            let _e4825 = phi_14025_;
                                                            let _e4827 = phi_14026_;
                                                            if _e4827 {
                                                                phi_14030_ = false;
                                                            } else {
                                                                phi_14030_ = _e4825;
                                                            }
                                                            let _e4829 = phi_14030_;
                                                            if _e4829 {
                                                                if (_e4406 <= _e4408) {
                                                                    phi_14341_ = true;
                                                                } else {
                                                                    let _e4831 = f64(0f);
                                                                    let _e4834 = local.member[0u];
                                                                    let _e4837 = local.member_1[0u];
                                                                    let _e4840 = local.member[0u];
                                                                    let _e4846 = local.member_2[0u];
                                                                    let _e4850 = local_1.member[0u];
                                                                    let _e4853 = local_1.member_1[0u];
                                                                    let _e4856 = local_1.member[0u];
                                                                    let _e4862 = local_1.member_2[0u];
                                                                    if ((((_e4834 + ((_e4837 - _e4840) * _e4406)) - _e4846) + ((_e4850 + ((_e4853 - _e4856) * _e4412)) - _e4862)) > _e4831) {
                                                                        let _e4868 = local.member[1u];
                                                                        let _e4871 = local.member_1[1u];
                                                                        let _e4874 = local.member[1u];
                                                                        let _e4880 = local.member_2[1u];
                                                                        let _e4884 = local_1.member[1u];
                                                                        let _e4887 = local_1.member_1[1u];
                                                                        let _e4890 = local_1.member[1u];
                                                                        let _e4896 = local_1.member_2[1u];
                                                                        if ((((_e4868 + ((_e4871 - _e4874) * _e4406)) - _e4880) + ((_e4884 + ((_e4887 - _e4890) * _e4412)) - _e4896)) > _e4831) {
                                                                            let _e4902 = local.member[2u];
                                                                            let _e4905 = local.member_1[2u];
                                                                            let _e4908 = local.member[2u];
                                                                            let _e4914 = local.member_2[2u];
                                                                            let _e4918 = local_1.member[2u];
                                                                            let _e4921 = local_1.member_1[2u];
                                                                            let _e4924 = local_1.member[2u];
                                                                            let _e4930 = local_1.member_2[2u];
                                                                            if ((((_e4902 + ((_e4905 - _e4908) * _e4406)) - _e4914) + ((_e4918 + ((_e4921 - _e4924) * _e4412)) - _e4930)) > _e4831) {
                                                                                let _e4936 = local.member[3u];
                                                                                let _e4939 = local.member_1[3u];
                                                                                let _e4942 = local.member[3u];
                                                                                let _e4948 = local.member_2[3u];
                                                                                let _e4952 = local_1.member[3u];
                                                                                let _e4955 = local_1.member_1[3u];
                                                                                let _e4958 = local_1.member[3u];
                                                                                let _e4964 = local_1.member_2[3u];
                                                                                phi_14328_ = ((((_e4936 + ((_e4939 - _e4942) * _e4406)) - _e4948) + ((_e4952 + ((_e4955 - _e4958) * _e4412)) - _e4964)) > _e4831);
                                                                                phi_14329_ = false;
                                                                            } else {
                                                                                phi_14328_ = bool();
                                                                                phi_14329_ = true;
                                                                            }
                                                                            let _e4969 = phi_14328_;
                                                                            let _e4971 = phi_14329_;
                                                                            phi_14330_ = _e4969;
                                                                            phi_14331_ = _e4971;
                                                                        } else {
                                                                            phi_14330_ = bool();
                                                                            phi_14331_ = true;
                                                                        }
                                                                        let _e4973 = phi_14330_;
                                                                        let _e4975 = phi_14331_;
                                                                        phi_14332_ = _e4973;
                                                                        phi_14333_ = _e4975;
                                                                    } else {
                                                                        phi_14332_ = bool();
                                                                        phi_14333_ = true;
                                                                    }
                                                                    let _e4977 = phi_14332_;
                                                                    let _e4979 = phi_14333_;
                                                                    if _e4979 {
                                                                        phi_14337_ = false;
                                                                    } else {
                                                                        phi_14337_ = _e4977;
                                                                    }
                                                                    let _e4981 = phi_14337_;
                                                                    phi_14341_ = _e4981;
                                                                }
                                                                let _e4983 = phi_14341_;
                                                                if _e4983 {
                                                                    if _e4414 {
                                                                        if (_e4406 >= _e3383.member_1) {
                                                                            phi_14352_ = false;
                                                                        } else {
                                                                            phi_14352_ = true;
                                                                        }
                                                                        let _e4986 = phi_14352_;
                                                                        phi_14353_ = _e4986;
                                                                    } else {
                                                                        phi_14353_ = true;
                                                                    }
                                                                    let _e4988 = phi_14353_;
                                                                    if _e4988 {
                                                                        local = type_35(array<f64, 4>(_e4725.member[0], _e4725.member[1], _e4725.member[2], _e4725.member[3]), array<f64, 4>(_e4725.member_1[0], _e4725.member_1[1], _e4725.member_1[2], _e4725.member_1[3]), array<f64, 4>(_e4725.member_2[0], _e4725.member_2[1], _e4725.member_2[2], _e4725.member_2[3]));
                                                                        let _e5010 = local.member[0u];
                                                                        let _e5013 = local.member_1[0u];
                                                                        let _e5016 = local.member_2[0u];
                                                                        if (_e5010 > _e5016) {
                                                                            if (_e5013 > _e5016) {
                                                                                phi_14427_ = false;
                                                                            } else {
                                                                                phi_14427_ = true;
                                                                            }
                                                                            let _e5020 = phi_14427_;
                                                                            phi_14428_ = _e5020;
                                                                        } else {
                                                                            phi_14428_ = true;
                                                                        }
                                                                        let _e5022 = phi_14428_;
                                                                        if _e5022 {
                                                                            let _e5023 = (_e5013 >= _e5010);
                                                                            if _e5023 {
                                                                                phi_14453_ = f64();
                                                                                phi_14454_ = false;
                                                                            } else {
                                                                                if ((_e5010 - _e5013) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14451_ = (((_e5010 - _e5016) / (_e5010 - _e5013)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14452_ = false;
                                                                                } else {
                                                                                    phi_14451_ = f64();
                                                                                    phi_14452_ = true;
                                                                                }
                                                                                let _e5037 = phi_14451_;
                                                                                let _e5039 = phi_14452_;
                                                                                phi_14453_ = _e5037;
                                                                                phi_14454_ = _e5039;
                                                                            }
                                                                            let _e5041 = phi_14453_;
                                                                            let _e5043 = phi_14454_;
                                                                            phi_14455_ = _e5041;
                                                                            phi_14456_ = _e5023;
                                                                            phi_14457_ = _e5043;
                                                                        } else {
                                                                            phi_14455_ = f64();
                                                                            phi_14456_ = true;
                                                                            phi_14457_ = false;
                                                                        }
                                                                        let _e5045 = phi_14455_;
                                                                        let _e5047 = phi_14456_;
                                                                        let _e5049 = phi_14457_;
                                                                        if _e5047 {
                                                                            phi_14462_ = f64(2f);
                                                                            phi_14463_ = true;
                                                                        } else {
                                                                            phi_14462_ = _e4406;
                                                                            phi_14463_ = _e5049;
                                                                        }
                                                                        let _e5052 = phi_14462_;
                                                                        let _e5054 = phi_14463_;
                                                                        if _e5054 {
                                                                            phi_14467_ = _e5052;
                                                                        } else {
                                                                            phi_14467_ = _e5045;
                                                                        }
                                                                        let _e5056 = phi_14467_;
                                                                        let _e5059 = local.member[1u];
                                                                        let _e5062 = local.member_1[1u];
                                                                        let _e5065 = local.member_2[1u];
                                                                        if (_e5059 > _e5065) {
                                                                            if (_e5062 > _e5065) {
                                                                                phi_14499_ = false;
                                                                            } else {
                                                                                phi_14499_ = true;
                                                                            }
                                                                            let _e5069 = phi_14499_;
                                                                            phi_14500_ = _e5069;
                                                                        } else {
                                                                            phi_14500_ = true;
                                                                        }
                                                                        let _e5071 = phi_14500_;
                                                                        if _e5071 {
                                                                            let _e5072 = (_e5062 >= _e5059);
                                                                            if _e5072 {
                                                                                phi_14525_ = f64();
                                                                                phi_14526_ = false;
                                                                            } else {
                                                                                if ((_e5059 - _e5062) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14523_ = (((_e5059 - _e5065) / (_e5059 - _e5062)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14524_ = false;
                                                                                } else {
                                                                                    phi_14523_ = f64();
                                                                                    phi_14524_ = true;
                                                                                }
                                                                                let _e5086 = phi_14523_;
                                                                                let _e5088 = phi_14524_;
                                                                                phi_14525_ = _e5086;
                                                                                phi_14526_ = _e5088;
                                                                            }
                                                                            let _e5090 = phi_14525_;
                                                                            let _e5092 = phi_14526_;
                                                                            phi_14527_ = _e5090;
                                                                            phi_14528_ = _e5072;
                                                                            phi_14529_ = _e5092;
                                                                        } else {
                                                                            phi_14527_ = f64();
                                                                            phi_14528_ = true;
                                                                            phi_14529_ = false;
                                                                        }
                                                                        let _e5094 = phi_14527_;
                                                                        let _e5096 = phi_14528_;
                                                                        let _e5098 = phi_14529_;
                                                                        if _e5096 {
                                                                            phi_14534_ = f64(2f);
                                                                            phi_14535_ = true;
                                                                        } else {
                                                                            phi_14534_ = _e4406;
                                                                            phi_14535_ = _e5098;
                                                                        }
                                                                        let _e5101 = phi_14534_;
                                                                        let _e5103 = phi_14535_;
                                                                        if _e5103 {
                                                                            phi_14539_ = _e5101;
                                                                        } else {
                                                                            phi_14539_ = _e5094;
                                                                        }
                                                                        let _e5105 = phi_14539_;
                                                                        if (_e5056 < _e5105) {
                                                                            phi_14544_ = _e5056;
                                                                        } else {
                                                                            phi_14544_ = _e5105;
                                                                        }
                                                                        let _e5108 = phi_14544_;
                                                                        let _e5111 = local.member[2u];
                                                                        let _e5114 = local.member_1[2u];
                                                                        let _e5117 = local.member_2[2u];
                                                                        if (_e5111 > _e5117) {
                                                                            if (_e5114 > _e5117) {
                                                                                phi_14576_ = false;
                                                                            } else {
                                                                                phi_14576_ = true;
                                                                            }
                                                                            let _e5121 = phi_14576_;
                                                                            phi_14577_ = _e5121;
                                                                        } else {
                                                                            phi_14577_ = true;
                                                                        }
                                                                        let _e5123 = phi_14577_;
                                                                        if _e5123 {
                                                                            let _e5124 = (_e5114 >= _e5111);
                                                                            if _e5124 {
                                                                                phi_14602_ = f64();
                                                                                phi_14603_ = false;
                                                                            } else {
                                                                                if ((_e5111 - _e5114) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14600_ = (((_e5111 - _e5117) / (_e5111 - _e5114)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14601_ = false;
                                                                                } else {
                                                                                    phi_14600_ = f64();
                                                                                    phi_14601_ = true;
                                                                                }
                                                                                let _e5138 = phi_14600_;
                                                                                let _e5140 = phi_14601_;
                                                                                phi_14602_ = _e5138;
                                                                                phi_14603_ = _e5140;
                                                                            }
                                                                            let _e5142 = phi_14602_;
                                                                            let _e5144 = phi_14603_;
                                                                            phi_14604_ = _e5142;
                                                                            phi_14605_ = _e5124;
                                                                            phi_14606_ = _e5144;
                                                                        } else {
                                                                            phi_14604_ = f64();
                                                                            phi_14605_ = true;
                                                                            phi_14606_ = false;
                                                                        }
                                                                        let _e5146 = phi_14604_;
                                                                        let _e5148 = phi_14605_;
                                                                        let _e5150 = phi_14606_;
                                                                        if _e5148 {
                                                                            phi_14611_ = f64(2f);
                                                                            phi_14612_ = true;
                                                                        } else {
                                                                            phi_14611_ = _e4406;
                                                                            phi_14612_ = _e5150;
                                                                        }
                                                                        let _e5153 = phi_14611_;
                                                                        let _e5155 = phi_14612_;
                                                                        if _e5155 {
                                                                            phi_14616_ = _e5153;
                                                                        } else {
                                                                            phi_14616_ = _e5146;
                                                                        }
                                                                        let _e5157 = phi_14616_;
                                                                        let _e5160 = local.member[3u];
                                                                        let _e5163 = local.member_1[3u];
                                                                        let _e5166 = local.member_2[3u];
                                                                        if (_e5160 > _e5166) {
                                                                            if (_e5163 > _e5166) {
                                                                                phi_14648_ = false;
                                                                            } else {
                                                                                phi_14648_ = true;
                                                                            }
                                                                            let _e5170 = phi_14648_;
                                                                            phi_14649_ = _e5170;
                                                                        } else {
                                                                            phi_14649_ = true;
                                                                        }
                                                                        let _e5172 = phi_14649_;
                                                                        if _e5172 {
                                                                            let _e5173 = (_e5163 >= _e5160);
                                                                            if _e5173 {
                                                                                phi_14674_ = f64();
                                                                                phi_14675_ = false;
                                                                            } else {
                                                                                if ((_e5160 - _e5163) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14672_ = (((_e5160 - _e5166) / (_e5160 - _e5163)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14673_ = false;
                                                                                } else {
                                                                                    phi_14672_ = f64();
                                                                                    phi_14673_ = true;
                                                                                }
                                                                                let _e5187 = phi_14672_;
                                                                                let _e5189 = phi_14673_;
                                                                                phi_14674_ = _e5187;
                                                                                phi_14675_ = _e5189;
                                                                            }
                                                                            let _e5191 = phi_14674_;
                                                                            let _e5193 = phi_14675_;
                                                                            phi_14676_ = _e5191;
                                                                            phi_14677_ = _e5173;
                                                                            phi_14678_ = _e5193;
                                                                        } else {
                                                                            phi_14676_ = f64();
                                                                            phi_14677_ = true;
                                                                            phi_14678_ = false;
                                                                        }
                                                                        let _e5195 = phi_14676_;
                                                                        let _e5197 = phi_14677_;
                                                                        let _e5199 = phi_14678_;
                                                                        if _e5197 {
                                                                            phi_14683_ = f64(2f);
                                                                            phi_14684_ = true;
                                                                        } else {
                                                                            phi_14683_ = _e4406;
                                                                            phi_14684_ = _e5199;
                                                                        }
                                                                        let _e5202 = phi_14683_;
                                                                        let _e5204 = phi_14684_;
                                                                        if _e5204 {
                                                                            phi_14688_ = _e5202;
                                                                        } else {
                                                                            phi_14688_ = _e5195;
                                                                        }
                                                                        let _e5206 = phi_14688_;
                                                                        if (_e5157 < _e5206) {
                                                                            phi_14693_ = _e5157;
                                                                        } else {
                                                                            phi_14693_ = _e5206;
                                                                        }
                                                                        let _e5209 = phi_14693_;
                                                                        if (_e5108 < _e5209) {
                                                                            phi_14698_ = _e5108;
                                                                        } else {
                                                                            phi_14698_ = _e5209;
                                                                        }
                                                                        let _e5212 = phi_14698_;
                                                                        if (_e5212 > _e4406) {
                                                                            phi_14703_ = _e5212;
                                                                        } else {
                                                                            phi_14703_ = _e4406;
                                                                        }
                                                                        let _e5215 = phi_14703_;
                                                                        let _e5216 = (_e5215 > _e3383.member_1);
                                                                        if _e5216 {
                                                                            phi_15220_ = f64();
                                                                            phi_15221_ = f64();
                                                                            phi_15222_ = false;
                                                                            phi_15223_ = false;
                                                                        } else {
                                                                            let _e5217 = (_e5215 - _e4406);
                                                                            let _e5218 = (_e5217 <= _e4395);
                                                                            let _e5221 = (_e5215 + (_e534 * f64(0.01f)));
                                                                            if (_e5221 < _e3383.member_1) {
                                                                                phi_14717_ = _e5221;
                                                                            } else {
                                                                                phi_14717_ = _e3383.member_1;
                                                                            }
                                                                            let _e5224 = phi_14717_;
                                                                            if _e5218 {
                                                                                if (_e863 > f64(0f)) {
                                                                                    let _e5229 = local_18.member[0u];
                                                                                    let _e5235 = local_18.member[1u];
                                                                                    let _e5251 = local_18.member_1[0u];
                                                                                    let _e5257 = local_18.member_1[1u];
                                                                                    let _e5273 = local_18.member_2[0u];
                                                                                    let _e5279 = local_18.member_2[1u];
                                                                                    let _e5293 = function_4(array<f64, 3>((_e5229[0] + ((_e5235[0] - _e5229[0]) * _e5224)), (_e5229[1] + ((_e5235[1] - _e5229[1]) * _e5224)), (_e5229[2] + ((_e5235[2] - _e5229[2]) * _e5224))), array<f64, 3>((_e5251[0] + ((_e5257[0] - _e5251[0]) * _e5224)), (_e5251[1] + ((_e5257[1] - _e5251[1]) * _e5224)), (_e5251[2] + ((_e5257[2] - _e5251[2]) * _e5224))), array<f64, 3>((_e5273[0] + ((_e5279[0] - _e5273[0]) * _e5224)), (_e5273[1] + ((_e5279[1] - _e5273[1]) * _e5224)), (_e5273[2] + ((_e5279[2] - _e5273[2]) * _e5224))), _e247.member);
                                                                                    let _e5304 = (((_e5293[0] * _e5293[0]) + (_e5293[1] * _e5293[1])) + (_e5293[2] * _e5293[2]));
                                                                                    if (_e5304 <= 2.2250738585072014e-308lf) {
                                                                                        if (_e5304 > 0.0lf) {
                                                                                            phi_14848_ = (1.464336215552873e-154lf * 2.0lf);
                                                                                        } else {
                                                                                            phi_14848_ = 0.0lf;
                                                                                        }
                                                                                        let _e5356 = phi_14848_;
                                                                                        phi_14912_ = _e5356;
                                                                                    } else {
                                                                                        phi_14855_ = type_18(0i, 5i);
                                                                                        phi_14858_ = bitcast<f64>(((bitcast<u64>(_e5304) / 2lu) + 2303426169912950784lu));
                                                                                        loop {
                                                                                            let _e5311 = phi_14855_;
                                                                                            let _e5313 = phi_14858_;
                                                                                            local_29 = _e5313;
                                                                                            if (_e5311.member < _e5311.member_1) {
                                                                                                let _e5320 = (_e5311.member + 1i);
                                                                                                if ((false == (_e5320 > _e5311.member)) != false) {
                                                                                                    phi_14879_ = true;
                                                                                                } else {
                                                                                                    phi_14879_ = false;
                                                                                                }
                                                                                                let _e5325 = phi_14879_;
                                                                                                if _e5325 {
                                                                                                    phi_14885_ = type_19(0u, type_19().member_1);
                                                                                                } else {
                                                                                                    phi_14885_ = type_19(1u, _e5320);
                                                                                                }
                                                                                                let _e5330 = phi_14885_;
                                                                                                phi_14856_ = type_18(_e5330.member_1, _e5311.member_1);
                                                                                                phi_14899_ = type_19(1u, _e5311.member);
                                                                                            } else {
                                                                                                phi_14856_ = _e5311;
                                                                                                phi_14899_ = type_19(0u, type_19().member_1);
                                                                                            }
                                                                                            let _e5336 = phi_14856_;
                                                                                            let _e5338 = phi_14899_;
                                                                                            let _e5341 = (bitcast<i32>(_e5338.member) != 0i);
                                                                                            if _e5341 {
                                                                                                phi_14859_ = (0.5lf * (_e5313 + (_e5304 / _e5313)));
                                                                                            } else {
                                                                                                phi_14859_ = f64();
                                                                                            }
                                                                                            let _e5346 = phi_14859_;
                                                                                            continue;
                                                                                            continuing {
                                                                                                phi_14855_ = _e5336;
                                                                                                phi_14858_ = _e5346;
                                                                                                break if !(_e5341);
                                                                                            }
                                                                                        }
                                                                                        let _e5351 = local_29;
                                                                                        phi_14912_ = (_e5351 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                                    }
                                                                                    let _e5358 = phi_14912_;
                                                                                    let _e5366 = local_18.member[0u];
                                                                                    if (_e5366[0] < 0.0lf) {
                                                                                        phi_14930_ = -(_e5366[0]);
                                                                                    } else {
                                                                                        phi_14930_ = _e5366[0];
                                                                                    }
                                                                                    let _e5373 = phi_14930_;
                                                                                    if (_e5366[1] < 0.0lf) {
                                                                                        phi_14937_ = -(_e5366[1]);
                                                                                    } else {
                                                                                        phi_14937_ = _e5366[1];
                                                                                    }
                                                                                    let _e5377 = phi_14937_;
                                                                                    if (_e5373 > _e5377) {
                                                                                        phi_14942_ = _e5373;
                                                                                    } else {
                                                                                        phi_14942_ = _e5377;
                                                                                    }
                                                                                    let _e5380 = phi_14942_;
                                                                                    if (_e5366[2] < 0.0lf) {
                                                                                        phi_14949_ = -(_e5366[2]);
                                                                                    } else {
                                                                                        phi_14949_ = _e5366[2];
                                                                                    }
                                                                                    let _e5384 = phi_14949_;
                                                                                    if (_e5380 > _e5384) {
                                                                                        phi_14954_ = _e5380;
                                                                                    } else {
                                                                                        phi_14954_ = _e5384;
                                                                                    }
                                                                                    let _e5387 = phi_14954_;
                                                                                    let _e5390 = local_18.member[1u];
                                                                                    if (_e5390[0] < 0.0lf) {
                                                                                        phi_14967_ = -(_e5390[0]);
                                                                                    } else {
                                                                                        phi_14967_ = _e5390[0];
                                                                                    }
                                                                                    let _e5397 = phi_14967_;
                                                                                    if (_e5390[1] < 0.0lf) {
                                                                                        phi_14974_ = -(_e5390[1]);
                                                                                    } else {
                                                                                        phi_14974_ = _e5390[1];
                                                                                    }
                                                                                    let _e5401 = phi_14974_;
                                                                                    if (_e5397 > _e5401) {
                                                                                        phi_14979_ = _e5397;
                                                                                    } else {
                                                                                        phi_14979_ = _e5401;
                                                                                    }
                                                                                    let _e5404 = phi_14979_;
                                                                                    if (_e5390[2] < 0.0lf) {
                                                                                        phi_14986_ = -(_e5390[2]);
                                                                                    } else {
                                                                                        phi_14986_ = _e5390[2];
                                                                                    }
                                                                                    let _e5408 = phi_14986_;
                                                                                    if (_e5404 > _e5408) {
                                                                                        phi_14991_ = _e5404;
                                                                                    } else {
                                                                                        phi_14991_ = _e5408;
                                                                                    }
                                                                                    let _e5411 = phi_14991_;
                                                                                    if (_e5387 > _e5411) {
                                                                                        phi_14996_ = _e5387;
                                                                                    } else {
                                                                                        phi_14996_ = _e5411;
                                                                                    }
                                                                                    let _e5414 = phi_14996_;
                                                                                    let _e5416 = local_18.member_3;
                                                                                    let _e5420 = local_18.member_1[0u];
                                                                                    if (_e5420[0] < 0.0lf) {
                                                                                        phi_15013_ = -(_e5420[0]);
                                                                                    } else {
                                                                                        phi_15013_ = _e5420[0];
                                                                                    }
                                                                                    let _e5427 = phi_15013_;
                                                                                    if (_e5420[1] < 0.0lf) {
                                                                                        phi_15020_ = -(_e5420[1]);
                                                                                    } else {
                                                                                        phi_15020_ = _e5420[1];
                                                                                    }
                                                                                    let _e5431 = phi_15020_;
                                                                                    if (_e5427 > _e5431) {
                                                                                        phi_15025_ = _e5427;
                                                                                    } else {
                                                                                        phi_15025_ = _e5431;
                                                                                    }
                                                                                    let _e5434 = phi_15025_;
                                                                                    if (_e5420[2] < 0.0lf) {
                                                                                        phi_15032_ = -(_e5420[2]);
                                                                                    } else {
                                                                                        phi_15032_ = _e5420[2];
                                                                                    }
                                                                                    let _e5438 = phi_15032_;
                                                                                    if (_e5434 > _e5438) {
                                                                                        phi_15037_ = _e5434;
                                                                                    } else {
                                                                                        phi_15037_ = _e5438;
                                                                                    }
                                                                                    let _e5441 = phi_15037_;
                                                                                    let _e5444 = local_18.member_1[1u];
                                                                                    if (_e5444[0] < 0.0lf) {
                                                                                        phi_15051_ = -(_e5444[0]);
                                                                                    } else {
                                                                                        phi_15051_ = _e5444[0];
                                                                                    }
                                                                                    let _e5451 = phi_15051_;
                                                                                    if (_e5444[1] < 0.0lf) {
                                                                                        phi_15058_ = -(_e5444[1]);
                                                                                    } else {
                                                                                        phi_15058_ = _e5444[1];
                                                                                    }
                                                                                    let _e5455 = phi_15058_;
                                                                                    if (_e5451 > _e5455) {
                                                                                        phi_15063_ = _e5451;
                                                                                    } else {
                                                                                        phi_15063_ = _e5455;
                                                                                    }
                                                                                    let _e5458 = phi_15063_;
                                                                                    if (_e5444[2] < 0.0lf) {
                                                                                        phi_15070_ = -(_e5444[2]);
                                                                                    } else {
                                                                                        phi_15070_ = _e5444[2];
                                                                                    }
                                                                                    let _e5462 = phi_15070_;
                                                                                    if (_e5458 > _e5462) {
                                                                                        phi_15075_ = _e5458;
                                                                                    } else {
                                                                                        phi_15075_ = _e5462;
                                                                                    }
                                                                                    let _e5465 = phi_15075_;
                                                                                    if (_e5441 > _e5465) {
                                                                                        phi_15080_ = _e5441;
                                                                                    } else {
                                                                                        phi_15080_ = _e5465;
                                                                                    }
                                                                                    let _e5468 = phi_15080_;
                                                                                    let _e5470 = local_18.member_3;
                                                                                    let _e5474 = local_18.member_2[0u];
                                                                                    if (_e5474[0] < 0.0lf) {
                                                                                        phi_15097_ = -(_e5474[0]);
                                                                                    } else {
                                                                                        phi_15097_ = _e5474[0];
                                                                                    }
                                                                                    let _e5481 = phi_15097_;
                                                                                    if (_e5474[1] < 0.0lf) {
                                                                                        phi_15104_ = -(_e5474[1]);
                                                                                    } else {
                                                                                        phi_15104_ = _e5474[1];
                                                                                    }
                                                                                    let _e5485 = phi_15104_;
                                                                                    if (_e5481 > _e5485) {
                                                                                        phi_15109_ = _e5481;
                                                                                    } else {
                                                                                        phi_15109_ = _e5485;
                                                                                    }
                                                                                    let _e5488 = phi_15109_;
                                                                                    if (_e5474[2] < 0.0lf) {
                                                                                        phi_15116_ = -(_e5474[2]);
                                                                                    } else {
                                                                                        phi_15116_ = _e5474[2];
                                                                                    }
                                                                                    let _e5492 = phi_15116_;
                                                                                    if (_e5488 > _e5492) {
                                                                                        phi_15121_ = _e5488;
                                                                                    } else {
                                                                                        phi_15121_ = _e5492;
                                                                                    }
                                                                                    let _e5495 = phi_15121_;
                                                                                    let _e5498 = local_18.member_2[1u];
                                                                                    if (_e5498[0] < 0.0lf) {
                                                                                        phi_15135_ = -(_e5498[0]);
                                                                                    } else {
                                                                                        phi_15135_ = _e5498[0];
                                                                                    }
                                                                                    let _e5505 = phi_15135_;
                                                                                    if (_e5498[1] < 0.0lf) {
                                                                                        phi_15142_ = -(_e5498[1]);
                                                                                    } else {
                                                                                        phi_15142_ = _e5498[1];
                                                                                    }
                                                                                    let _e5509 = phi_15142_;
                                                                                    if (_e5505 > _e5509) {
                                                                                        phi_15147_ = _e5505;
                                                                                    } else {
                                                                                        phi_15147_ = _e5509;
                                                                                    }
                                                                                    let _e5512 = phi_15147_;
                                                                                    if (_e5498[2] < 0.0lf) {
                                                                                        phi_15154_ = -(_e5498[2]);
                                                                                    } else {
                                                                                        phi_15154_ = _e5498[2];
                                                                                    }
                                                                                    let _e5516 = phi_15154_;
                                                                                    if (_e5512 > _e5516) {
                                                                                        phi_15159_ = _e5512;
                                                                                    } else {
                                                                                        phi_15159_ = _e5516;
                                                                                    }
                                                                                    let _e5519 = phi_15159_;
                                                                                    if (_e5495 > _e5519) {
                                                                                        phi_15164_ = _e5495;
                                                                                    } else {
                                                                                        phi_15164_ = _e5519;
                                                                                    }
                                                                                    let _e5522 = phi_15164_;
                                                                                    let _e5524 = local_18.member_3;
                                                                                    let _e5532 = local_18.member_3;
                                                                                    if (((_e5358 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5414 + _e5416) + (_e5468 + _e5470)) + (_e5522 + _e5524)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5532 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e863) {
                                                                                        phi_15188_ = false;
                                                                                    } else {
                                                                                        phi_15188_ = true;
                                                                                    }
                                                                                    let _e5544 = phi_15188_;
                                                                                    phi_15189_ = _e5544;
                                                                                } else {
                                                                                    phi_15189_ = true;
                                                                                }
                                                                                let _e5546 = phi_15189_;
                                                                                phi_15190_ = _e5546;
                                                                            } else {
                                                                                phi_15190_ = true;
                                                                            }
                                                                            let _e5548 = phi_15190_;
                                                                            if _e5548 {
                                                                                if _e4414 {
                                                                                    if _e5218 {
                                                                                        phi_15209_ = f64();
                                                                                        phi_15210_ = true;
                                                                                    } else {
                                                                                        if (_e5217 <= (_e4410 * f64(0.25f))) {
                                                                                            phi_15207_ = f64(0f);
                                                                                            phi_15208_ = false;
                                                                                        } else {
                                                                                            phi_15207_ = f64();
                                                                                            phi_15208_ = true;
                                                                                        }
                                                                                        let _e5555 = phi_15207_;
                                                                                        let _e5557 = phi_15208_;
                                                                                        phi_15209_ = _e5555;
                                                                                        phi_15210_ = _e5557;
                                                                                    }
                                                                                    let _e5559 = phi_15209_;
                                                                                    let _e5561 = phi_15210_;
                                                                                    if _e5561 {
                                                                                        phi_15215_ = (_e4745 + _e4745);
                                                                                    } else {
                                                                                        phi_15215_ = _e5559;
                                                                                    }
                                                                                    let _e5564 = phi_15215_;
                                                                                    phi_15217_ = _e5564;
                                                                                } else {
                                                                                    phi_15217_ = (_e3383.member_1 - _e4406);
                                                                                }
                                                                                let _e5566 = phi_15217_;
                                                                                phi_15218_ = _e5566;
                                                                                phi_15219_ = false;
                                                                            } else {
                                                                                phi_15218_ = f64();
                                                                                phi_15219_ = true;
                                                                            }
                                                                            let _e5568 = phi_15218_;
                                                                            let _e5570 = phi_15219_;
                                                                            phi_15220_ = _e5568;
                                                                            phi_15221_ = _e5217;
                                                                            phi_15222_ = _e5548;
                                                                            phi_15223_ = _e5570;
                                                                        }
                                                                        let _e5572 = phi_15220_;
                                                                        let _e5574 = phi_15221_;
                                                                        let _e5576 = phi_15222_;
                                                                        let _e5578 = phi_15223_;
                                                                        phi_15224_ = _e5215;
                                                                        phi_15225_ = _e5572;
                                                                        phi_15226_ = _e5574;
                                                                        phi_15227_ = _e5215;
                                                                        phi_15228_ = _e5576;
                                                                        phi_15229_ = _e5216;
                                                                        phi_15230_ = _e5578;
                                                                        phi_15231_ = false;
                                                                    } else {
                                                                        phi_15224_ = f64();
                                                                        phi_15225_ = f64();
                                                                        phi_15226_ = f64();
                                                                        phi_15227_ = f64();
                                                                        phi_15228_ = false;
                                                                        phi_15229_ = false;
                                                                        phi_15230_ = false;
                                                                        phi_15231_ = true;
                                                                    }
                                                                    let _e5580 = phi_15224_;
                                                                    let _e5582 = phi_15225_;
                                                                    let _e5584 = phi_15226_;
                                                                    let _e5586 = phi_15227_;
                                                                    let _e5588 = phi_15228_;
                                                                    let _e5590 = phi_15229_;
                                                                    let _e5592 = phi_15230_;
                                                                    let _e5594 = phi_15231_;
                                                                    phi_15232_ = _e5580;
                                                                    phi_15233_ = _e5582;
                                                                    phi_15234_ = _e5584;
                                                                    phi_15235_ = _e5586;
                                                                    phi_15236_ = false;
                                                                    phi_15237_ = _e5588;
                                                                    phi_15238_ = _e5590;
                                                                    phi_15239_ = _e5592;
                                                                    phi_15240_ = _e5594;
                                                                } else {
                                                                    phi_15232_ = f64();
                                                                    phi_15233_ = f64();
                                                                    phi_15234_ = f64();
                                                                    phi_15235_ = f64();
                                                                    phi_15236_ = true;
                                                                    phi_15237_ = false;
                                                                    phi_15238_ = false;
                                                                    phi_15239_ = false;
                                                                    phi_15240_ = false;
                                                                }
                                                                let _e5596 = phi_15232_;
                                                                let _e5598 = phi_15233_;
                                                                let _e5600 = phi_15234_;
                                                                let _e5602 = phi_15235_;
                                                                let _e5604 = phi_15236_;
                                                                let _e5606 = phi_15237_;
                                                                let _e5608 = phi_15238_;
                                                                let _e5610 = phi_15239_;
                                                                let _e5612 = phi_15240_;
                                                                phi_15241_ = _e5596;
                                                                phi_15242_ = _e5598;
                                                                phi_15243_ = _e5600;
                                                                phi_15244_ = _e5602;
                                                                phi_15245_ = _e5604;
                                                                phi_15246_ = _e5606;
                                                                phi_15247_ = _e5608;
                                                                phi_15248_ = _e5610;
                                                                phi_15249_ = _e5612;
                                                            } else {
                                                                phi_15241_ = f64();
                                                                phi_15242_ = f64();
                                                                phi_15243_ = f64();
                                                                phi_15244_ = f64();
                                                                phi_15245_ = true;
                                                                phi_15246_ = false;
                                                                phi_15247_ = false;
                                                                phi_15248_ = false;
                                                                phi_15249_ = false;
                                                            }
                                                            let _e5614 = phi_15241_;
                                                            let _e5616 = phi_15242_;
                                                            let _e5618 = phi_15243_;
                                                            let _e5620 = phi_15244_;
                                                            let _e5622 = phi_15245_;
                                                            let _e5624 = phi_15246_;
                                                            let _e5626 = phi_15247_;
                                                            let _e5628 = phi_15248_;
                                                            let _e5630 = phi_15249_;
                                                            if _e5622 {
                                                                if (_e4406 <= _e4408) {
                                                                    let _e5796 = (_e4416 + 1u);
                                                                    let _e5797 = (_e5796 > 3u);
                                                                    if _e5797 {
                                                                        phi_15262_ = false;
                                                                    } else {
                                                                        phi_15262_ = true;
                                                                    }
                                                                    let _e5799 = phi_15262_;
                                                                    phi_15589_ = _e5796;
                                                                    phi_15590_ = f64();
                                                                    phi_15591_ = false;
                                                                    phi_15592_ = _e5799;
                                                                    phi_15593_ = _e5797;
                                                                } else {
                                                                    let _e5634 = local.member[0u];
                                                                    let _e5637 = local.member_1[0u];
                                                                    let _e5640 = local.member[0u];
                                                                    let _e5646 = local.member_2[0u];
                                                                    let _e5647 = ((_e5634 + ((_e5637 - _e5640) * _e4412)) - _e5646);
                                                                    let _e5650 = local.member[1u];
                                                                    let _e5653 = local.member_1[1u];
                                                                    let _e5656 = local.member[1u];
                                                                    let _e5662 = local.member_2[1u];
                                                                    let _e5663 = ((_e5650 + ((_e5653 - _e5656) * _e4412)) - _e5662);
                                                                    if (_e5647 < _e5663) {
                                                                        phi_15335_ = _e5647;
                                                                    } else {
                                                                        phi_15335_ = _e5663;
                                                                    }
                                                                    let _e5666 = phi_15335_;
                                                                    let _e5669 = local.member[2u];
                                                                    let _e5672 = local.member_1[2u];
                                                                    let _e5675 = local.member[2u];
                                                                    let _e5681 = local.member_2[2u];
                                                                    let _e5682 = ((_e5669 + ((_e5672 - _e5675) * _e4412)) - _e5681);
                                                                    let _e5685 = local.member[3u];
                                                                    let _e5688 = local.member_1[3u];
                                                                    let _e5691 = local.member[3u];
                                                                    let _e5697 = local.member_2[3u];
                                                                    let _e5698 = ((_e5685 + ((_e5688 - _e5691) * _e4412)) - _e5697);
                                                                    if (_e5682 < _e5698) {
                                                                        phi_15408_ = _e5682;
                                                                    } else {
                                                                        phi_15408_ = _e5698;
                                                                    }
                                                                    let _e5701 = phi_15408_;
                                                                    if (_e5666 < _e5701) {
                                                                        phi_15413_ = _e5666;
                                                                    } else {
                                                                        phi_15413_ = _e5701;
                                                                    }
                                                                    let _e5704 = phi_15413_;
                                                                    let _e5707 = local_1.member[0u];
                                                                    let _e5710 = local_1.member_1[0u];
                                                                    let _e5713 = local_1.member[0u];
                                                                    let _e5719 = local_1.member_2[0u];
                                                                    let _e5720 = ((_e5707 + ((_e5710 - _e5713) * _e4406)) - _e5719);
                                                                    let _e5723 = local_1.member[1u];
                                                                    let _e5726 = local_1.member_1[1u];
                                                                    let _e5729 = local_1.member[1u];
                                                                    let _e5735 = local_1.member_2[1u];
                                                                    let _e5736 = ((_e5723 + ((_e5726 - _e5729) * _e4406)) - _e5735);
                                                                    if (_e5720 < _e5736) {
                                                                        phi_15486_ = _e5720;
                                                                    } else {
                                                                        phi_15486_ = _e5736;
                                                                    }
                                                                    let _e5739 = phi_15486_;
                                                                    let _e5742 = local_1.member[2u];
                                                                    let _e5745 = local_1.member_1[2u];
                                                                    let _e5748 = local_1.member[2u];
                                                                    let _e5754 = local_1.member_2[2u];
                                                                    let _e5755 = ((_e5742 + ((_e5745 - _e5748) * _e4406)) - _e5754);
                                                                    let _e5758 = local_1.member[3u];
                                                                    let _e5761 = local_1.member_1[3u];
                                                                    let _e5764 = local_1.member[3u];
                                                                    let _e5770 = local_1.member_2[3u];
                                                                    let _e5771 = ((_e5758 + ((_e5761 - _e5764) * _e4406)) - _e5770);
                                                                    if (_e5755 < _e5771) {
                                                                        phi_15559_ = _e5755;
                                                                    } else {
                                                                        phi_15559_ = _e5771;
                                                                    }
                                                                    let _e5774 = phi_15559_;
                                                                    if (_e5739 < _e5774) {
                                                                        phi_15564_ = _e5739;
                                                                    } else {
                                                                        phi_15564_ = _e5774;
                                                                    }
                                                                    let _e5777 = phi_15564_;
                                                                    let _e5778 = f64(0.0625f);
                                                                    let _e5780 = f64(0.9f);
                                                                    if (_e5777 > f64(0f)) {
                                                                        phi_15587_ = f64(0.5f);
                                                                    } else {
                                                                        let _e5786 = (f64(0.95f) * (_e5704 / (_e5704 - _e5777)));
                                                                        if (_e5786 > _e5778) {
                                                                            if (_e5786 < _e5780) {
                                                                                phi_15585_ = _e5786;
                                                                            } else {
                                                                                phi_15585_ = _e5780;
                                                                            }
                                                                            let _e5790 = phi_15585_;
                                                                            phi_15586_ = _e5790;
                                                                        } else {
                                                                            phi_15586_ = _e5778;
                                                                        }
                                                                        let _e5792 = phi_15586_;
                                                                        phi_15587_ = _e5792;
                                                                    }
                                                                    let _e5794 = phi_15587_;
                                                                    phi_15589_ = u32();
                                                                    phi_15590_ = (_e4745 * _e5794);
                                                                    phi_15591_ = true;
                                                                    phi_15592_ = false;
                                                                    phi_15593_ = false;
                                                                }
                                                                let _e5801 = phi_15589_;
                                                                let _e5803 = phi_15590_;
                                                                let _e5805 = phi_15591_;
                                                                let _e5807 = phi_15592_;
                                                                let _e5809 = phi_15593_;
                                                                phi_15594_ = _e5801;
                                                                phi_15595_ = _e4408;
                                                                phi_15596_ = _e5803;
                                                                phi_15597_ = _e4410;
                                                                phi_15598_ = _e4412;
                                                                phi_15599_ = _e4414;
                                                                phi_15600_ = _e4416;
                                                                phi_15601_ = _e5805;
                                                                phi_15602_ = _e5807;
                                                                phi_15603_ = _e5809;
                                                                phi_15604_ = false;
                                                                phi_15605_ = false;
                                                                phi_15606_ = false;
                                                            } else {
                                                                phi_15594_ = u32();
                                                                phi_15595_ = _e5614;
                                                                phi_15596_ = _e5616;
                                                                phi_15597_ = _e5618;
                                                                phi_15598_ = _e4406;
                                                                phi_15599_ = true;
                                                                phi_15600_ = 0u;
                                                                phi_15601_ = _e5624;
                                                                phi_15602_ = false;
                                                                phi_15603_ = false;
                                                                phi_15604_ = _e5626;
                                                                phi_15605_ = _e5628;
                                                                phi_15606_ = _e5630;
                                                            }
                                                            let _e5811 = phi_15594_;
                                                            let _e5813 = phi_15595_;
                                                            let _e5815 = phi_15596_;
                                                            let _e5817 = phi_15597_;
                                                            let _e5819 = phi_15598_;
                                                            let _e5821 = phi_15599_;
                                                            let _e5823 = phi_15600_;
                                                            let _e5825 = phi_15601_;
                                                            let _e5827 = phi_15602_;
                                                            let _e5829 = phi_15603_;
                                                            let _e5831 = phi_15604_;
                                                            let _e5833 = phi_15605_;
                                                            let _e5835 = phi_15606_;
                                                            if _e5825 {
                                                                let _e5836 = (_e5819 + _e5815);
                                                                if (_e5836 > _e5813) {
                                                                    phi_15615_ = _e5836;
                                                                } else {
                                                                    phi_15615_ = _e5813;
                                                                }
                                                                let _e5839 = phi_15615_;
                                                                if (_e5839 < _e3383.member_1) {
                                                                    phi_15620_ = _e5839;
                                                                } else {
                                                                    phi_15620_ = _e3383.member_1;
                                                                }
                                                                let _e5842 = phi_15620_;
                                                                if !(_e4414) {
                                                                    phi_15629_ = true;
                                                                } else {
                                                                    phi_15629_ = ((_e5842 - _e5819) > _e4395);
                                                                }
                                                                let _e5846 = phi_15629_;
                                                                if _e5846 {
                                                                    phi_15633_ = false;
                                                                } else {
                                                                    phi_15633_ = true;
                                                                }
                                                                let _e5848 = phi_15633_;
                                                                phi_15634_ = _e5842;
                                                                phi_15635_ = _e5813;
                                                                phi_15636_ = _e5817;
                                                                phi_15637_ = _e5819;
                                                                phi_15638_ = _e5821;
                                                                phi_15639_ = _e5823;
                                                                phi_15640_ = _e5846;
                                                                phi_15641_ = _e5848;
                                                                phi_15642_ = false;
                                                                phi_15643_ = false;
                                                                phi_15644_ = false;
                                                                phi_15645_ = false;
                                                            } else {
                                                                phi_15634_ = _e4406;
                                                                phi_15635_ = _e4408;
                                                                phi_15636_ = _e4410;
                                                                phi_15637_ = _e4412;
                                                                phi_15638_ = _e4414;
                                                                phi_15639_ = _e5811;
                                                                phi_15640_ = _e5827;
                                                                phi_15641_ = false;
                                                                phi_15642_ = _e5829;
                                                                phi_15643_ = _e5831;
                                                                phi_15644_ = _e5833;
                                                                phi_15645_ = _e5835;
                                                            }
                                                            let _e5850 = phi_15634_;
                                                            let _e5852 = phi_15635_;
                                                            let _e5854 = phi_15636_;
                                                            let _e5856 = phi_15637_;
                                                            let _e5858 = phi_15638_;
                                                            let _e5860 = phi_15639_;
                                                            let _e5862 = phi_15640_;
                                                            let _e5864 = phi_15641_;
                                                            let _e5866 = phi_15642_;
                                                            let _e5868 = phi_15643_;
                                                            let _e5870 = phi_15644_;
                                                            let _e5872 = phi_15645_;
                                                            phi_13424_ = _e5850;
                                                            phi_13426_ = _e5852;
                                                            phi_13428_ = _e5854;
                                                            phi_13430_ = _e5856;
                                                            phi_13432_ = _e5858;
                                                            phi_13434_ = _e5860;
                                                            phi_15646_ = _e5813;
                                                            phi_15647_ = _e5620;
                                                            phi_15648_ = _e5862;
                                                            phi_15649_ = _e5864;
                                                            phi_15650_ = _e5866;
                                                            phi_15651_ = _e5868;
                                                            phi_15652_ = _e5870;
                                                            phi_15653_ = false;
                                                            phi_15654_ = _e5872;
                                                        } else {
                                                            phi_13424_ = f64();
                                                            phi_13426_ = f64();
                                                            phi_13428_ = f64();
                                                            phi_13430_ = f64();
                                                            phi_13432_ = bool();
                                                            phi_13434_ = u32();
                                                            phi_15646_ = f64();
                                                            phi_15647_ = f64();
                                                            phi_15648_ = false;
                                                            phi_15649_ = false;
                                                            phi_15650_ = false;
                                                            phi_15651_ = false;
                                                            phi_15652_ = false;
                                                            phi_15653_ = true;
                                                            phi_15654_ = false;
                                                        }
                                                        let _e5874 = phi_13424_;
                                                        let _e5876 = phi_13426_;
                                                        let _e5878 = phi_13428_;
                                                        let _e5880 = phi_13430_;
                                                        let _e5882 = phi_13432_;
                                                        let _e5884 = phi_13434_;
                                                        let _e5886 = phi_15646_;
                                                        let _e5888 = phi_15647_;
                                                        let _e5890 = phi_15648_;
                                                        let _e5892 = phi_15649_;
                                                        let _e5894 = phi_15650_;
                                                        let _e5896 = phi_15651_;
                                                        let _e5898 = phi_15652_;
                                                        let _e5900 = phi_15653_;
                                                        let _e5902 = phi_15654_;
                                                        local_30 = _e5892;
                                                        local_70 = _e5894;
                                                        local_71 = _e5896;
                                                        local_72 = _e5898;
                                                        local_73 = _e5900;
                                                        local_74 = _e5902;
                                                        local_75 = _e5892;
                                                        local_76 = _e5888;
                                                        local_77 = _e5886;
                                                        continue;
                                                        continuing {
                                                            phi_13420_ = _e4428;
                                                            phi_13423_ = _e5874;
                                                            phi_13425_ = _e5876;
                                                            phi_13427_ = _e5878;
                                                            phi_13429_ = _e5880;
                                                            phi_13431_ = _e5882;
                                                            phi_13433_ = _e5884;
                                                            break if !(_e5890);
                                                        }
                                                    }
                                                    let _e5905 = local_30;
                                                    if _e5905 {
                                                        phi_15658_ = false;
                                                        phi_15659_ = false;
                                                        phi_15660_ = false;
                                                        phi_15661_ = false;
                                                        phi_15662_ = false;
                                                    } else {
                                                        let _e11686 = local_70;
                                                        phi_15658_ = _e11686;
                                                        let _e11689 = local_71;
                                                        phi_15659_ = _e11689;
                                                        let _e11692 = local_72;
                                                        phi_15660_ = _e11692;
                                                        let _e11695 = local_73;
                                                        phi_15661_ = _e11695;
                                                        let _e11698 = local_74;
                                                        phi_15662_ = _e11698;
                                                    }
                                                    let _e5907 = phi_15658_;
                                                    let _e5909 = phi_15659_;
                                                    let _e5911 = phi_15660_;
                                                    let _e5913 = phi_15661_;
                                                    let _e5915 = phi_15662_;
                                                    if _e5907 {
                                                        let _e5917 = local_31;
                                                        phi_15667_ = type_43(1u, _e5917);
                                                        phi_15668_ = false;
                                                        phi_15669_ = false;
                                                        phi_15670_ = false;
                                                        phi_15671_ = false;
                                                        phi_15672_ = false;
                                                    } else {
                                                        phi_15667_ = type_43();
                                                        phi_15668_ = _e5909;
                                                        phi_15669_ = _e5911;
                                                        let _e11705 = local_75;
                                                        phi_15670_ = _e11705;
                                                        phi_15671_ = _e5913;
                                                        phi_15672_ = _e5915;
                                                    }
                                                    let _e5920 = phi_15667_;
                                                    let _e5922 = phi_15668_;
                                                    let _e5924 = phi_15669_;
                                                    let _e5926 = phi_15670_;
                                                    let _e5928 = phi_15671_;
                                                    let _e5930 = phi_15672_;
                                                    if _e5922 {
                                                        phi_15677_ = type_43(0u, type_43().member_1);
                                                        phi_15678_ = false;
                                                        phi_15679_ = false;
                                                        phi_15680_ = false;
                                                        phi_15681_ = false;
                                                        phi_15682_ = true;
                                                    } else {
                                                        phi_15677_ = _e5920;
                                                        phi_15678_ = _e5924;
                                                        phi_15679_ = _e5926;
                                                        phi_15680_ = _e5928;
                                                        phi_15681_ = _e5930;
                                                        phi_15682_ = _e5907;
                                                    }
                                                    let _e5934 = phi_15677_;
                                                    let _e5936 = phi_15678_;
                                                    let _e5938 = phi_15679_;
                                                    let _e5940 = phi_15680_;
                                                    let _e5942 = phi_15681_;
                                                    let _e5944 = phi_15682_;
                                                    if _e5936 {
                                                        let _e11716 = local_76;
                                                        phi_15686_ = _e11716;
                                                        phi_15687_ = true;
                                                        phi_15688_ = false;
                                                        phi_15689_ = false;
                                                        phi_15690_ = false;
                                                    } else {
                                                        let _e11718 = local_77;
                                                        phi_15686_ = _e11718;
                                                        phi_15687_ = _e5938;
                                                        phi_15688_ = _e5940;
                                                        phi_15689_ = _e5942;
                                                        phi_15690_ = _e5944;
                                                    }
                                                    let _e5946 = phi_15686_;
                                                    let _e5948 = phi_15687_;
                                                    let _e5950 = phi_15688_;
                                                    let _e5952 = phi_15689_;
                                                    let _e5954 = phi_15690_;
                                                    if _e5948 {
                                                        phi_15694_ = _e5946;
                                                        phi_15695_ = true;
                                                        phi_15696_ = false;
                                                        phi_15697_ = false;
                                                    } else {
                                                        let _e11725 = local_78;
                                                        phi_15694_ = _e11725;
                                                        phi_15695_ = _e5950;
                                                        phi_15696_ = _e5952;
                                                        phi_15697_ = _e5954;
                                                    }
                                                    let _e5956 = phi_15694_;
                                                    let _e5958 = phi_15695_;
                                                    let _e5960 = phi_15696_;
                                                    let _e5962 = phi_15697_;
                                                    if _e5958 {
                                                        phi_15702_ = type_43(1u, _e5956);
                                                        phi_15703_ = false;
                                                        phi_15704_ = false;
                                                    } else {
                                                        phi_15702_ = type_43();
                                                        phi_15703_ = _e5960;
                                                        phi_15704_ = _e5962;
                                                    }
                                                    let _e5965 = phi_15702_;
                                                    let _e5967 = phi_15703_;
                                                    let _e5969 = phi_15704_;
                                                    if _e5967 {
                                                        phi_15709_ = type_43(0u, type_43().member_1);
                                                        phi_15710_ = true;
                                                    } else {
                                                        phi_15709_ = _e5934;
                                                        phi_15710_ = _e5969;
                                                    }
                                                    let _e5973 = phi_15709_;
                                                    let _e5975 = phi_15710_;
                                                    if _e5975 {
                                                        phi_15714_ = _e5973;
                                                    } else {
                                                        phi_15714_ = _e5965;
                                                    }
                                                    let _e5977 = phi_15714_;
                                                    let _e5980 = (_e5977.member != 0u);
                                                    if _e5980 {
                                                        phi_15721_ = false;
                                                    } else {
                                                        phi_15721_ = true;
                                                    }
                                                    let _e5982 = phi_15721_;
                                                    phi_15722_ = _e5977.member_1;
                                                    phi_15723_ = _e5982;
                                                    phi_15724_ = _e5980;
                                                    phi_15725_ = false;
                                                } else {
                                                    phi_15722_ = f64();
                                                    phi_15723_ = false;
                                                    phi_15724_ = false;
                                                    phi_15725_ = true;
                                                }
                                                let _e5984 = phi_15722_;
                                                let _e5986 = phi_15723_;
                                                let _e5988 = phi_15724_;
                                                let _e5990 = phi_15725_;
                                                phi_15726_ = _e4142;
                                                phi_15727_ = _e4144;
                                                phi_15728_ = _e5984;
                                                phi_15729_ = _e5986;
                                                phi_15730_ = _e5988;
                                                phi_15731_ = _e5990;
                                            }
                                            let _e5992 = phi_15726_;
                                            let _e5994 = phi_15727_;
                                            let _e5996 = phi_15728_;
                                            let _e5998 = phi_15729_;
                                            let _e6000 = phi_15730_;
                                            let _e6002 = phi_15731_;
                                            phi_15732_ = _e5992;
                                            phi_15733_ = _e5994;
                                            phi_15734_ = _e5996;
                                            phi_15735_ = _e4138;
                                            phi_15736_ = _e5998;
                                            phi_15737_ = _e6000;
                                            phi_15738_ = _e6002;
                                        }
                                        let _e6004 = phi_15732_;
                                        let _e6006 = phi_15733_;
                                        let _e6008 = phi_15734_;
                                        let _e6010 = phi_15735_;
                                        let _e6012 = phi_15736_;
                                        let _e6014 = phi_15737_;
                                        let _e6016 = phi_15738_;
                                        if _e6010 {
                                            phi_15742_ = false;
                                            phi_15743_ = false;
                                            phi_15744_ = false;
                                        } else {
                                            phi_15742_ = _e6012;
                                            phi_15743_ = _e6014;
                                            phi_15744_ = _e6016;
                                        }
                                        let _e6018 = phi_15742_;
                                        let _e6020 = phi_15743_;
                                        let _e6022 = phi_15744_;
                                        phi_15745_ = _e3383;
                                        phi_15746_ = _e6004;
                                        phi_15747_ = _e6006;
                                        phi_15748_ = _e6008;
                                        phi_15749_ = _e3383;
                                        phi_15750_ = _e6010;
                                        phi_15751_ = _e6018;
                                        phi_15752_ = _e6020;
                                        phi_15753_ = _e6022;
                                    } else {
                                        phi_15745_ = type_46();
                                        phi_15746_ = bool();
                                        phi_15747_ = f64();
                                        phi_15748_ = f64();
                                        phi_15749_ = type_46();
                                        phi_15750_ = true;
                                        phi_15751_ = false;
                                        phi_15752_ = false;
                                        phi_15753_ = false;
                                    }
                                    let _e6024 = phi_15745_;
                                    let _e6026 = phi_15746_;
                                    let _e6028 = phi_15747_;
                                    let _e6030 = phi_15748_;
                                    let _e6032 = phi_15749_;
                                    let _e6034 = phi_15750_;
                                    let _e6036 = phi_15751_;
                                    let _e6038 = phi_15752_;
                                    let _e6040 = phi_15753_;
                                    if _e6034 {
                                        phi_15757_ = true;
                                        phi_15758_ = false;
                                        phi_15759_ = false;
                                    } else {
                                        phi_15757_ = _e6036;
                                        phi_15758_ = _e6038;
                                        phi_15759_ = _e6040;
                                    }
                                    let _e6042 = phi_15757_;
                                    let _e6044 = phi_15758_;
                                    let _e6046 = phi_15759_;
                                    phi_15760_ = _e6024;
                                    phi_15761_ = _e6026;
                                    phi_15762_ = _e6028;
                                    phi_15763_ = _e6030;
                                    phi_15764_ = _e6032;
                                    phi_15765_ = _e6042;
                                    phi_15766_ = false;
                                    phi_15767_ = _e6044;
                                    phi_15768_ = _e6046;
                                } else {
                                    phi_15760_ = type_46();
                                    phi_15761_ = bool();
                                    phi_15762_ = f64();
                                    phi_15763_ = f64();
                                    phi_15764_ = type_46();
                                    phi_15765_ = false;
                                    phi_15766_ = true;
                                    phi_15767_ = false;
                                    phi_15768_ = false;
                                }
                                let _e6048 = phi_15760_;
                                let _e6050 = phi_15761_;
                                let _e6052 = phi_15762_;
                                let _e6054 = phi_15763_;
                                let _e6056 = phi_15764_;
                                let _e6058 = phi_15765_;
                                let _e6060 = phi_15766_;
                                let _e6062 = phi_15767_;
                                let _e6064 = phi_15768_;
                                local_32 = _e6060;
                                local_79 = _e6062;
                                local_80 = _e6064;
                                local_33 = _e6050;
                                local_34 = _e6048;
                                local_35 = _e6054;
                                local_36 = _e6052;
                                local_37 = _e6054;
                                local_38 = _e6054;
                                local_39 = _e6056;
                                continue;
                                continuing {
                                    phi_11482_ = _e3091;
                                    break if !(_e6058);
                                }
                            }
                            let _e6067 = local_32;
                            if _e6067 {
                                phi_15773_ = type_43(0u, type_43().member_1);
                                phi_15774_ = false;
                                phi_15775_ = false;
                            } else {
                                phi_15773_ = type_43();
                                let _e11781 = local_79;
                                phi_15774_ = _e11781;
                                let _e11784 = local_80;
                                phi_15775_ = _e11784;
                            }
                            let _e6071 = phi_15773_;
                            let _e6073 = phi_15774_;
                            let _e6075 = phi_15775_;
                            if _e6073 {
                                let _e6077 = local_33;
                                if _e6077 {
                                    let _e6079 = local_34;
                                    let _e6082 = local_35;
                                    let _e6085 = local_36;
                                    if ((_e6079.member_1 - _e6082) <= _e6085) {
                                        let _e6088 = local_37;
                                        phi_15789_ = type_43(1u, _e6088);
                                        phi_15790_ = false;
                                    } else {
                                        phi_15789_ = type_43();
                                        phi_15790_ = true;
                                    }
                                    let _e6091 = phi_15789_;
                                    let _e6093 = phi_15790_;
                                    phi_15791_ = _e6091;
                                    phi_15792_ = _e6093;
                                } else {
                                    phi_15791_ = type_43();
                                    phi_15792_ = true;
                                }
                                let _e6095 = phi_15791_;
                                let _e6097 = phi_15792_;
                                if _e6097 {
                                    let _e6099 = local_38;
                                    phi_15797_ = type_43(2u, _e6099);
                                } else {
                                    phi_15797_ = _e6095;
                                }
                                let _e6102 = phi_15797_;
                                phi_15798_ = _e6102;
                                phi_15799_ = false;
                            } else {
                                phi_15798_ = type_43();
                                phi_15799_ = _e6075;
                            }
                            let _e6104 = phi_15798_;
                            let _e6106 = phi_15799_;
                            if _e6106 {
                                let _e6108 = local_39;
                                phi_15805_ = type_43(1u, _e6108.member);
                                phi_15806_ = true;
                            } else {
                                phi_15805_ = _e6104;
                                phi_15806_ = _e6073;
                            }
                            let _e6112 = phi_15805_;
                            let _e6114 = phi_15806_;
                            phi_15810_ = _e6112;
                            phi_15811_ = _e6071;
                            phi_15812_ = _e6114;
                        } else {
                            phi_15810_ = _e2935;
                            phi_15811_ = type_43();
                            phi_15812_ = true;
                        }
                        let _e6116 = phi_15810_;
                        let _e6118 = phi_15811_;
                        let _e6120 = phi_15812_;
                        phi_15816_ = _e6116;
                        phi_15817_ = _e6118;
                        phi_15818_ = _e6120;
                    }
                    let _e6124 = phi_15816_;
                    let _e6126 = phi_15817_;
                    let _e6128 = phi_15818_;
                    if _e6128 {
                        phi_15822_ = _e6124;
                    } else {
                        phi_15822_ = _e6126;
                    }
                    let _e6130 = phi_15822_;
                    if (_e6130.member == 1u) {
                        if (_e6130.member_1 > _e543) {
                            phi_15833_ = false;
                        } else {
                            phi_15833_ = true;
                        }
                        let _e6136 = phi_15833_;
                        phi_15834_ = _e6136;
                    } else {
                        phi_15834_ = true;
                    }
                    let _e6138 = phi_15834_;
                    if _e6138 {
                        phi_15838_ = false;
                    } else {
                        phi_15838_ = true;
                    }
                    let _e6140 = phi_15838_;
                    if _e6140 {
                        phi_15842_ = 1u;
                    } else {
                        phi_15842_ = 0u;
                    }
                    let _e6142 = phi_15842_;
                    phi_15846_ = type_44(_e6130, _e6142);
                }
                let _e10802 = phi_15846_;
                switch bitcast<i32>(_e10802.member.member) {
                    case 0: {
                        phi_15861_ = type_47(0u, _e10802.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e10813 = function_1(_e10802.member.member_1);
                        phi_15861_ = type_47(0u, _e10802.member_1, _e10813, true);
                        break;
                    }
                    case 2: {
                        let _e10809 = function_1(_e10802.member.member_1);
                        phi_15861_ = type_47(1u, _e10802.member_1, _e10809, true);
                        break;
                    }
                    default: {
                        phi_15861_ = type_47();
                        break;
                    }
                }
                let _e10817 = phi_15861_;
                if _e10817.member_3 {
                    let _e10825 = (_e10817.member_2[1] >> bitcast<u32>(20i));
                    if (_e10825 <= 896u) {
                        phi_15885_ = 0u;
                    } else {
                        phi_15885_ = ((((_e10825 - 896u) << bitcast<u32>(23i)) | ((_e10817.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e10817.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e10840 = phi_15885_;
                    let _e10842 = atomicMin((&earliest.member[0u]), _e10840);
                }
                phi_15889_ = type_24(_e205, _e10817.member, _e215, _e218, _e10817.member_2, _e10817.member_1);
                phi_15890_ = _e10817.member_3;
            } else {
                phi_15889_ = type_24(_e205, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_15890_ = false;
            }
            let _e10844 = phi_15889_;
            let _e10846 = phi_15890_;
            let _e10849 = params.member.member.member_1;
            if ((_e10849 & 16u) != 0u) {
                if (_e123 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e10846 {
                    let _e10855 = atomicAdd((&counters[0u]), 1u);
                    phi_15909_ = _e10855;
                } else {
                    phi_15909_ = 0u;
                }
                let _e10857 = phi_15909_;
                workgroupBarrier();
                if (_e123 == 0u) {
                    let _e10860 = atomicLoad((&counters[0u]));
                    if (_e10860 > 0u) {
                        let _e10863 = atomicAdd((&contacts.member[0u]), _e10860);
                        atomicStore((&counters[1u]), _e10863);
                    }
                }
                workgroupBarrier();
                let _e10866 = atomicLoad((&counters[1u]));
                let _e10867 = (_e10866 + _e10857);
                if _e10846 {
                    let _e10870 = params.member.member_1.member_3;
                    if (_e10867 < _e10870) {
                        let _e10872 = (7u * _e10867);
                        atomicStore((&contacts.member[(4u + _e10872)]), _e10844.member);
                        atomicStore((&contacts.member[(_e10872 + 5u)]), _e10844.member_1);
                        atomicStore((&contacts.member[(_e10872 + 6u)]), _e10844.member_2);
                        atomicStore((&contacts.member[(_e10872 + 7u)]), _e10844.member_3);
                        atomicStore((&contacts.member[(_e10872 + 8u)]), _e10844.member_4[0]);
                        atomicStore((&contacts.member[(_e10872 + 9u)]), _e10844.member_4[1]);
                        atomicStore((&contacts.member[(_e10872 + 10u)]), _e10844.member_5);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_456_ = _e192;
            break if !(_e198);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
