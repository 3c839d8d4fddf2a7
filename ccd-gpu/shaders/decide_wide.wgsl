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
    var phi_16567_: array<f64, 3>;

    if ((((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])) < (((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2]))) {
        phi_16567_ = param_3;
    } else {
        phi_16567_ = param_2;
    }
    let _e26 = phi_16567_;
    return _e26;
}

fn function_3(param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: array<f64, 3>, param_7: u32) -> array<f64, 3> {
    var phi_16419_: f64;
    var phi_16421_: f64;
    var phi_16463_: f64;
    var phi_16465_: f64;
    var phi_16513_: f64;
    var phi_16515_: f64;
    var phi_16224_: f64;
    var phi_16226_: f64;
    var phi_16274_: f64;
    var phi_16276_: f64;
    var phi_16321_: f64;
    var phi_16323_: f64;
    var phi_16374_: f64;
    var phi_16376_: f64;
    var phi_16530_: array<array<f64, 3>, 4>;

    let _e9 = (param_4[0] - param_5[0]);
    let _e12 = (param_4[1] - param_5[1]);
    let _e15 = (param_4[2] - param_5[2]);
    if (param_7 != 0u) {
        let _e169 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e169 > f64(0f)) {
            if (_e169 < f64(1f)) {
                phi_16224_ = _e169;
            } else {
                phi_16224_ = f64(1f);
            }
            let _e177 = phi_16224_;
            phi_16226_ = _e177;
        } else {
            phi_16226_ = f64(0f);
        }
        let _e179 = phi_16226_;
        let _e215 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e215 > f64(0f)) {
            if (_e215 < f64(1f)) {
                phi_16274_ = _e215;
            } else {
                phi_16274_ = f64(1f);
            }
            let _e223 = phi_16274_;
            phi_16276_ = _e223;
        } else {
            phi_16276_ = f64(0f);
        }
        let _e225 = phi_16276_;
        let _e258 = ((((_e9 * param_6[0]) + (_e12 * param_6[1])) + (_e15 * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e258 > f64(0f)) {
            if (_e258 < f64(1f)) {
                phi_16321_ = _e258;
            } else {
                phi_16321_ = f64(1f);
            }
            let _e266 = phi_16321_;
            phi_16323_ = _e266;
        } else {
            phi_16323_ = f64(0f);
        }
        let _e268 = phi_16323_;
        let _e281 = (param_4[0] - param_6[0]);
        let _e284 = (param_4[1] - param_6[1]);
        let _e287 = (param_4[2] - param_6[2]);
        let _e307 = ((((_e281 * param_5[0]) + (_e284 * param_5[1])) + (_e287 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e307 > f64(0f)) {
            if (_e307 < f64(1f)) {
                phi_16374_ = _e307;
            } else {
                phi_16374_ = f64(1f);
            }
            let _e315 = phi_16374_;
            phi_16376_ = _e315;
        } else {
            phi_16376_ = f64(0f);
        }
        let _e317 = phi_16376_;
        phi_16530_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e179)), (param_4[1] - (param_5[1] * _e179)), (param_4[2] - (param_5[2] * _e179))), array<f64, 3>((param_4[0] - (param_6[0] * _e225)), (param_4[1] - (param_6[1] * _e225)), (param_4[2] - (param_6[2] * _e225))), array<f64, 3>((_e9 - (param_6[0] * _e268)), (_e12 - (param_6[1] * _e268)), (_e15 - (param_6[2] * _e268))), array<f64, 3>((_e281 - (param_5[0] * _e317)), (_e284 - (param_5[1] * _e317)), (_e287 - (param_5[2] * _e317))));
    } else {
        let _e19 = (param_6[0] - param_5[0]);
        let _e22 = (param_6[1] - param_5[1]);
        let _e25 = (param_6[2] - param_5[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > f64(0f)) {
            if (_e36 < f64(1f)) {
                phi_16419_ = _e36;
            } else {
                phi_16419_ = f64(1f);
            }
            let _e44 = phi_16419_;
            phi_16421_ = _e44;
        } else {
            phi_16421_ = f64(0f);
        }
        let _e46 = phi_16421_;
        let _e53 = array<f64, 3>((_e9 - (_e19 * _e46)), (_e12 - (_e22 * _e46)), (_e15 - (_e25 * _e46)));
        let _e76 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e76 > f64(0f)) {
            if (_e76 < f64(1f)) {
                phi_16463_ = _e76;
            } else {
                phi_16463_ = f64(1f);
            }
            let _e84 = phi_16463_;
            phi_16465_ = _e84;
        } else {
            phi_16465_ = f64(0f);
        }
        let _e86 = phi_16465_;
        let _e122 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e122 > f64(0f)) {
            if (_e122 < f64(1f)) {
                phi_16513_ = _e122;
            } else {
                phi_16513_ = f64(1f);
            }
            let _e130 = phi_16513_;
            phi_16515_ = _e130;
        } else {
            phi_16515_ = f64(0f);
        }
        let _e132 = phi_16515_;
        phi_16530_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e86)), (param_4[1] - (param_5[1] * _e86)), (param_4[2] - (param_5[2] * _e86))), array<f64, 3>((param_4[0] - (param_6[0] * _e132)), (param_4[1] - (param_6[1] * _e132)), (param_4[2] - (param_6[2] * _e132))), _e53, _e53);
    }
    let _e330 = phi_16530_;
    let _e333 = function_2(_e330[0], _e330[1]);
    let _e335 = function_2(_e333, _e330[2]);
    let _e337 = function_2(_e335, _e330[3]);
    return _e337;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_16121_: bool;
    var phi_16122_: bool;
    var phi_16123_: bool;
    var phi_16124_: bool;
    var phi_16128_: bool;
    var phi_16101_: bool;
    var phi_16102_: bool;
    var phi_16103_: bool;
    var phi_16104_: bool;
    var phi_16105_: bool;
    var phi_16106_: bool;
    var phi_16110_: bool;
    var phi_16129_: bool;
    var phi_16163_: array<f64, 3>;
    var phi_16164_: bool;
    var phi_16165_: array<f64, 3>;
    var phi_16166_: bool;
    var phi_16171_: array<f64, 3>;

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
                    phi_16101_ = (_e80 <= _e72);
                    phi_16102_ = false;
                } else {
                    phi_16101_ = bool();
                    phi_16102_ = true;
                }
                let _e101 = phi_16101_;
                let _e103 = phi_16102_;
                phi_16103_ = _e101;
                phi_16104_ = _e103;
            } else {
                phi_16103_ = bool();
                phi_16104_ = true;
            }
            let _e105 = phi_16103_;
            let _e107 = phi_16104_;
            phi_16105_ = _e105;
            phi_16106_ = _e107;
        } else {
            phi_16105_ = bool();
            phi_16106_ = true;
        }
        let _e109 = phi_16105_;
        let _e111 = phi_16106_;
        if _e111 {
            phi_16110_ = false;
        } else {
            phi_16110_ = _e109;
        }
        let _e113 = phi_16110_;
        phi_16129_ = _e113;
    } else {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                phi_16121_ = ((_e76 + _e80) <= _e72);
                phi_16122_ = false;
            } else {
                phi_16121_ = bool();
                phi_16122_ = true;
            }
            let _e87 = phi_16121_;
            let _e89 = phi_16122_;
            phi_16123_ = _e87;
            phi_16124_ = _e89;
        } else {
            phi_16123_ = bool();
            phi_16124_ = true;
        }
        let _e91 = phi_16123_;
        let _e93 = phi_16124_;
        if _e93 {
            phi_16128_ = false;
        } else {
            phi_16128_ = _e91;
        }
        let _e95 = phi_16128_;
        phi_16129_ = _e95;
    }
    let _e115 = phi_16129_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e115 {
            phi_16163_ = array<f64, 3>((param_8[0] - ((param_9[0] * _e76) + (param_10[0] * _e80))), (param_8[1] - ((param_9[1] * _e76) + (param_10[1] * _e80))), (param_8[2] - ((param_9[2] * _e76) + (param_10[2] * _e80))));
            phi_16164_ = false;
        } else {
            phi_16163_ = array<f64, 3>();
            phi_16164_ = true;
        }
        let _e144 = phi_16163_;
        let _e146 = phi_16164_;
        phi_16165_ = _e144;
        phi_16166_ = _e146;
    } else {
        phi_16165_ = array<f64, 3>();
        phi_16166_ = true;
    }
    let _e148 = phi_16165_;
    let _e150 = phi_16166_;
    if _e150 {
        let _e151 = function_3(param_8, param_9, param_10, param_11);
        phi_16171_ = _e151;
    } else {
        phi_16171_ = _e148;
    }
    let _e153 = phi_16171_;
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
    var phi_619_: type_23;
    var phi_815_: type_31;
    var phi_976_: type_33;
    var phi_1024_: f64;
    var phi_1031_: f64;
    var phi_1036_: f64;
    var phi_1043_: f64;
    var phi_1048_: f64;
    var phi_1056_: f64;
    var phi_1063_: f64;
    var phi_1068_: f64;
    var phi_1075_: f64;
    var phi_1080_: f64;
    var phi_1085_: f64;
    var phi_1095_: f64;
    var phi_1102_: f64;
    var phi_1107_: f64;
    var phi_1114_: f64;
    var phi_1119_: f64;
    var phi_1127_: f64;
    var phi_1134_: f64;
    var phi_1139_: f64;
    var phi_1146_: f64;
    var phi_1151_: f64;
    var phi_1156_: f64;
    var phi_1166_: f64;
    var phi_1173_: f64;
    var phi_1178_: f64;
    var phi_1185_: f64;
    var phi_1190_: f64;
    var phi_1198_: f64;
    var phi_1205_: f64;
    var phi_1210_: f64;
    var phi_1217_: f64;
    var phi_1222_: f64;
    var phi_1227_: f64;
    var phi_1234_: f64;
    var phi_1239_: f64;
    var phi_1248_: bool;
    var phi_1272_: u64;
    var phi_1284_: f64;
    var phi_1285_: f64;
    var phi_1344_: type_42;
    var phi_1345_: bool;
    var phi_1346_: type_42;
    var phi_1347_: bool;
    var phi_1348_: type_42;
    var phi_1349_: bool;
    var phi_1354_: type_42;
    var phi_8420_: f64;
    var phi_8427_: f64;
    var phi_8432_: f64;
    var phi_8439_: f64;
    var phi_8444_: f64;
    var phi_8457_: f64;
    var phi_8464_: f64;
    var phi_8469_: f64;
    var phi_8476_: f64;
    var phi_8481_: f64;
    var phi_8486_: f64;
    var phi_8503_: f64;
    var phi_8510_: f64;
    var phi_8515_: f64;
    var phi_8522_: f64;
    var phi_8527_: f64;
    var phi_8541_: f64;
    var phi_8548_: f64;
    var phi_8553_: f64;
    var phi_8560_: f64;
    var phi_8565_: f64;
    var phi_8570_: f64;
    var phi_8587_: f64;
    var phi_8594_: f64;
    var phi_8599_: f64;
    var phi_8606_: f64;
    var phi_8611_: f64;
    var phi_8625_: f64;
    var phi_8632_: f64;
    var phi_8637_: f64;
    var phi_8644_: f64;
    var phi_8649_: f64;
    var phi_8654_: f64;
    var phi_8691_: f64;
    var phi_8697_: f64;
    var phi_8704_: f64;
    var phi_8711_: f64;
    var phi_8717_: f64;
    var phi_8724_: f64;
    var phi_8730_: f64;
    var phi_8736_: f64;
    var phi_8742_: f64;
    var phi_8749_: f64;
    var phi_8756_: f64;
    var phi_8784_: f64;
    var phi_8789_: f64;
    var phi_8794_: f64;
    var phi_8799_: f64;
    var phi_8804_: f64;
    var phi_8809_: f64;
    var phi_8820_: f64;
    var phi_8834_: f64;
    var phi_8840_: f64;
    var phi_8845_: f64;
    var phi_8851_: f64;
    var phi_8857_: f64;
    var phi_8862_: f64;
    var phi_8867_: f64;
    var phi_8877_: bool;
    var phi_8884_: f64;
    var phi_8892_: f64;
    var phi_8900_: f64;
    var phi_8919_: f64;
    var phi_8981_: array<f64, 3>;
    var phi_9046_: array<f64, 3>;
    var phi_9068_: f64;
    var phi_9075_: f64;
    var phi_9080_: f64;
    var phi_9087_: f64;
    var phi_9092_: f64;
    var phi_9105_: f64;
    var phi_9112_: f64;
    var phi_9117_: f64;
    var phi_9124_: f64;
    var phi_9129_: f64;
    var phi_9134_: f64;
    var phi_9151_: f64;
    var phi_9158_: f64;
    var phi_9163_: f64;
    var phi_9170_: f64;
    var phi_9175_: f64;
    var phi_9189_: f64;
    var phi_9196_: f64;
    var phi_9201_: f64;
    var phi_9208_: f64;
    var phi_9213_: f64;
    var phi_9218_: f64;
    var phi_9235_: f64;
    var phi_9242_: f64;
    var phi_9247_: f64;
    var phi_9254_: f64;
    var phi_9259_: f64;
    var phi_9273_: f64;
    var phi_9280_: f64;
    var phi_9285_: f64;
    var phi_9292_: f64;
    var phi_9297_: f64;
    var phi_9302_: f64;
    var phi_9423_: f64;
    var phi_9430_: f64;
    var phi_9438_: f64;
    var phi_9484_: type_18;
    var phi_9487_: f64;
    var phi_9508_: bool;
    var phi_9514_: type_19;
    var phi_9485_: type_18;
    var phi_9528_: type_19;
    var phi_9488_: f64;
    var local_19: f64;
    var phi_9477_: f64;
    var phi_9541_: f64;
    var phi_9610_: f64;
    var phi_9616_: f64;
    var phi_9625_: f64;
    var phi_9631_: f64;
    var phi_9640_: f64;
    var phi_9646_: f64;
    var phi_9655_: f64;
    var phi_9661_: f64;
    var phi_9667_: type_35;
    var phi_9668_: bool;
    var phi_9669_: type_35;
    var phi_9670_: bool;
    var phi_9680_: type_35;
    var phi_9850_: bool;
    var phi_9851_: bool;
    var phi_9852_: bool;
    var phi_9853_: bool;
    var phi_9854_: bool;
    var phi_9855_: bool;
    var phi_9859_: bool;
    var phi_9887_: f64;
    var phi_9893_: f64;
    var phi_9900_: f64;
    var phi_9943_: type_18;
    var phi_9946_: f64;
    var phi_9967_: bool;
    var phi_9973_: type_19;
    var phi_9944_: type_18;
    var phi_9987_: type_19;
    var phi_9947_: f64;
    var local_20: f64;
    var phi_9936_: f64;
    var phi_10000_: f64;
    var phi_10069_: f64;
    var phi_10075_: f64;
    var phi_10084_: f64;
    var phi_10090_: f64;
    var phi_10099_: f64;
    var phi_10105_: f64;
    var phi_10114_: f64;
    var phi_10120_: f64;
    var phi_10126_: type_35;
    var phi_10127_: bool;
    var phi_10128_: type_35;
    var phi_10129_: bool;
    var phi_10139_: type_35;
    var phi_10309_: bool;
    var phi_10310_: bool;
    var phi_10311_: bool;
    var phi_10312_: bool;
    var phi_10313_: bool;
    var phi_10314_: bool;
    var phi_10318_: bool;
    var phi_10346_: f64;
    var phi_10352_: f64;
    var phi_10359_: f64;
    var phi_10402_: type_18;
    var phi_10405_: f64;
    var phi_10426_: bool;
    var phi_10432_: type_19;
    var phi_10403_: type_18;
    var phi_10446_: type_19;
    var phi_10406_: f64;
    var local_21: f64;
    var phi_10395_: f64;
    var phi_10459_: f64;
    var phi_10528_: f64;
    var phi_10534_: f64;
    var phi_10543_: f64;
    var phi_10549_: f64;
    var phi_10558_: f64;
    var phi_10564_: f64;
    var phi_10573_: f64;
    var phi_10579_: f64;
    var phi_10585_: type_35;
    var phi_10586_: bool;
    var phi_10587_: type_35;
    var phi_10588_: bool;
    var phi_10598_: type_35;
    var phi_10768_: bool;
    var phi_10769_: bool;
    var phi_10770_: bool;
    var phi_10771_: bool;
    var phi_10772_: bool;
    var phi_10773_: bool;
    var phi_10777_: bool;
    var phi_10805_: f64;
    var phi_10811_: f64;
    var phi_10818_: f64;
    var phi_10861_: type_18;
    var phi_10864_: f64;
    var phi_10885_: bool;
    var phi_10891_: type_19;
    var phi_10862_: type_18;
    var phi_10905_: type_19;
    var phi_10865_: f64;
    var local_22: f64;
    var phi_10854_: f64;
    var phi_10918_: f64;
    var phi_10987_: f64;
    var phi_10993_: f64;
    var phi_11002_: f64;
    var phi_11008_: f64;
    var phi_11017_: f64;
    var phi_11023_: f64;
    var phi_11032_: f64;
    var phi_11038_: f64;
    var phi_11044_: type_35;
    var phi_11045_: bool;
    var phi_11046_: type_35;
    var phi_11047_: bool;
    var phi_11057_: type_35;
    var phi_11227_: bool;
    var phi_11228_: bool;
    var phi_11229_: bool;
    var phi_11230_: bool;
    var phi_11231_: bool;
    var phi_11232_: bool;
    var phi_11236_: bool;
    var phi_11237_: bool;
    var phi_11238_: bool;
    var phi_11239_: bool;
    var phi_11240_: bool;
    var phi_11241_: bool;
    var phi_11245_: bool;
    var phi_11251_: type_43;
    var phi_11252_: bool;
    var phi_11253_: type_43;
    var phi_11254_: bool;
    var phi_11300_: type_18;
    var phi_11303_: f64;
    var phi_11324_: bool;
    var phi_11330_: type_19;
    var phi_11301_: type_18;
    var phi_11344_: type_19;
    var phi_11304_: f64;
    var local_23: f64;
    var phi_11293_: f64;
    var phi_11357_: f64;
    var phi_11363_: f64;
    var phi_11388_: type_9;
    var phi_11391_: u32;
    var phi_11389_: type_9;
    var phi_11414_: type_9;
    var phi_11458_: u32;
    var phi_11459_: u32;
    var phi_11392_: u32;
    var phi_11460_: u32;
    var phi_11480_: type_9;
    var phi_11481_: type_9;
    var phi_11504_: type_9;
    var phi_11523_: f64;
    var phi_11536_: f64;
    var phi_11572_: f64;
    var phi_11579_: f64;
    var phi_11591_: bool;
    var phi_11592_: bool;
    var phi_11593_: bool;
    var phi_11594_: bool;
    var phi_11598_: bool;
    var phi_11610_: type_46;
    var phi_11611_: type_46;
    var phi_11612_: bool;
    var phi_11613_: type_46;
    var phi_11614_: bool;
    var phi_11627_: f64;
    var phi_11639_: type_9;
    var phi_11642_: f64;
    var phi_11644_: f64;
    var phi_11646_: f64;
    var phi_11640_: type_9;
    var phi_11669_: type_9;
    var phi_11696_: f64;
    var phi_11697_: f64;
    var phi_11725_: f64;
    var phi_11741_: f64;
    var phi_11748_: bool;
    var phi_11749_: bool;
    var phi_11750_: bool;
    var phi_11756_: f64;
    var phi_11757_: f64;
    var phi_11758_: bool;
    var phi_11643_: f64;
    var phi_11645_: f64;
    var phi_11647_: f64;
    var phi_11759_: f64;
    var phi_11760_: bool;
    var phi_11761_: bool;
    var local_24: bool;
    var phi_11765_: f64;
    var phi_11766_: f64;
    var phi_11776_: f64;
    var phi_11780_: type_9;
    var phi_11783_: f64;
    var phi_11781_: type_9;
    var phi_11806_: type_9;
    var phi_11837_: f64;
    var phi_11838_: bool;
    var phi_11839_: f64;
    var phi_11840_: bool;
    var phi_11841_: bool;
    var phi_11842_: bool;
    var phi_11843_: f64;
    var phi_11784_: f64;
    var phi_11844_: bool;
    var phi_11845_: bool;
    var phi_11846_: bool;
    var phi_11847_: bool;
    var local_25: bool;
    var phi_11851_: bool;
    var phi_11852_: bool;
    var phi_11856_: bool;
    var phi_11860_: f64;
    var phi_11861_: f64;
    var phi_11863_: type_46;
    var phi_11894_: f64;
    var phi_11901_: f64;
    var phi_11906_: f64;
    var phi_11913_: f64;
    var phi_11918_: f64;
    var phi_11931_: f64;
    var phi_11938_: f64;
    var phi_11943_: f64;
    var phi_11950_: f64;
    var phi_11955_: f64;
    var phi_11960_: f64;
    var phi_12019_: f64;
    var phi_12025_: f64;
    var phi_12030_: f64;
    var phi_12036_: f64;
    var phi_12041_: f64;
    var phi_12055_: f64;
    var phi_12061_: f64;
    var phi_12066_: f64;
    var phi_12072_: f64;
    var phi_12077_: f64;
    var phi_12103_: f64;
    var phi_12110_: f64;
    var phi_12115_: f64;
    var phi_12122_: f64;
    var phi_12127_: f64;
    var phi_12140_: f64;
    var phi_12147_: f64;
    var phi_12152_: f64;
    var phi_12159_: f64;
    var phi_12164_: f64;
    var phi_12169_: f64;
    var phi_12228_: f64;
    var phi_12234_: f64;
    var phi_12239_: f64;
    var phi_12245_: f64;
    var phi_12250_: f64;
    var phi_12264_: f64;
    var phi_12270_: f64;
    var phi_12275_: f64;
    var phi_12281_: f64;
    var phi_12286_: f64;
    var phi_12312_: f64;
    var phi_12319_: f64;
    var phi_12324_: f64;
    var phi_12331_: f64;
    var phi_12336_: f64;
    var phi_12349_: f64;
    var phi_12356_: f64;
    var phi_12361_: f64;
    var phi_12368_: f64;
    var phi_12373_: f64;
    var phi_12378_: f64;
    var phi_12437_: f64;
    var phi_12443_: f64;
    var phi_12448_: f64;
    var phi_12454_: f64;
    var phi_12459_: f64;
    var phi_12473_: f64;
    var phi_12479_: f64;
    var phi_12484_: f64;
    var phi_12490_: f64;
    var phi_12495_: f64;
    var phi_12544_: f64;
    var phi_12550_: f64;
    var phi_12578_: f64;
    var phi_12584_: f64;
    var phi_12589_: u32;
    var phi_12590_: u32;
    var phi_12560_: f64;
    var phi_12566_: f64;
    var phi_12571_: u32;
    var phi_12572_: u32;
    var phi_12591_: u32;
    var phi_12592_: u32;
    var phi_12665_: f64;
    var phi_12677_: f64;
    var phi_12820_: f64;
    var phi_12826_: f64;
    var phi_12833_: f64;
    var phi_12869_: array<type_37, 4>;
    var phi_12889_: type_9;
    var phi_12892_: bool;
    var phi_12890_: type_9;
    var phi_12915_: type_9;
    var phi_12942_: bool;
    var phi_12943_: bool;
    var phi_12893_: bool;
    var phi_12944_: bool;
    var phi_12945_: bool;
    var local_26: bool;
    var phi_12949_: bool;
    var local_27: bool;
    var phi_12956_: u32;
    var phi_12957_: u32;
    var phi_12958_: bool;
    var phi_12959_: u32;
    var phi_12960_: u32;
    var phi_12961_: bool;
    var phi_12965_: u32;
    var phi_12975_: bool;
    var phi_12988_: bool;
    var phi_12989_: bool;
    var phi_13050_: array<f64, 3>;
    var phi_13115_: array<f64, 3>;
    var phi_13137_: f64;
    var phi_13144_: f64;
    var phi_13149_: f64;
    var phi_13156_: f64;
    var phi_13161_: f64;
    var phi_13174_: f64;
    var phi_13181_: f64;
    var phi_13186_: f64;
    var phi_13193_: f64;
    var phi_13198_: f64;
    var phi_13203_: f64;
    var phi_13220_: f64;
    var phi_13227_: f64;
    var phi_13232_: f64;
    var phi_13239_: f64;
    var phi_13244_: f64;
    var phi_13258_: f64;
    var phi_13265_: f64;
    var phi_13270_: f64;
    var phi_13277_: f64;
    var phi_13282_: f64;
    var phi_13287_: f64;
    var phi_13304_: f64;
    var phi_13311_: f64;
    var phi_13316_: f64;
    var phi_13323_: f64;
    var phi_13328_: f64;
    var phi_13342_: f64;
    var phi_13349_: f64;
    var phi_13354_: f64;
    var phi_13361_: f64;
    var phi_13366_: f64;
    var phi_13371_: f64;
    var phi_13418_: type_9;
    var phi_13421_: f64;
    var phi_13423_: f64;
    var phi_13425_: f64;
    var phi_13427_: f64;
    var phi_13429_: bool;
    var phi_13431_: u32;
    var phi_13419_: type_9;
    var phi_13454_: type_9;
    var phi_13569_: f64;
    var phi_13575_: f64;
    var phi_13581_: f64;
    var phi_13583_: array<f64, 3>;
    var phi_13590_: f64;
    var phi_13597_: f64;
    var phi_13605_: f64;
    var phi_13651_: type_18;
    var phi_13654_: f64;
    var phi_13675_: bool;
    var phi_13681_: type_19;
    var phi_13652_: type_18;
    var phi_13695_: type_19;
    var phi_13655_: f64;
    var local_28: f64;
    var phi_13644_: f64;
    var phi_13708_: f64;
    var phi_13777_: f64;
    var phi_13783_: f64;
    var phi_13792_: f64;
    var phi_13798_: f64;
    var phi_13807_: f64;
    var phi_13813_: f64;
    var phi_13822_: f64;
    var phi_13828_: f64;
    var phi_13834_: type_35;
    var phi_13835_: bool;
    var phi_13836_: type_35;
    var phi_13837_: bool;
    var phi_13847_: type_35;
    var phi_14019_: bool;
    var phi_14020_: bool;
    var phi_14021_: bool;
    var phi_14022_: bool;
    var phi_14023_: bool;
    var phi_14024_: bool;
    var phi_14028_: bool;
    var phi_14326_: bool;
    var phi_14327_: bool;
    var phi_14328_: bool;
    var phi_14329_: bool;
    var phi_14330_: bool;
    var phi_14331_: bool;
    var phi_14335_: bool;
    var phi_14339_: bool;
    var phi_14350_: bool;
    var phi_14351_: bool;
    var phi_14425_: bool;
    var phi_14426_: bool;
    var phi_14449_: f64;
    var phi_14450_: bool;
    var phi_14451_: f64;
    var phi_14452_: bool;
    var phi_14453_: f64;
    var phi_14454_: bool;
    var phi_14455_: bool;
    var phi_14460_: f64;
    var phi_14461_: bool;
    var phi_14465_: f64;
    var phi_14497_: bool;
    var phi_14498_: bool;
    var phi_14521_: f64;
    var phi_14522_: bool;
    var phi_14523_: f64;
    var phi_14524_: bool;
    var phi_14525_: f64;
    var phi_14526_: bool;
    var phi_14527_: bool;
    var phi_14532_: f64;
    var phi_14533_: bool;
    var phi_14537_: f64;
    var phi_14542_: f64;
    var phi_14574_: bool;
    var phi_14575_: bool;
    var phi_14598_: f64;
    var phi_14599_: bool;
    var phi_14600_: f64;
    var phi_14601_: bool;
    var phi_14602_: f64;
    var phi_14603_: bool;
    var phi_14604_: bool;
    var phi_14609_: f64;
    var phi_14610_: bool;
    var phi_14614_: f64;
    var phi_14646_: bool;
    var phi_14647_: bool;
    var phi_14670_: f64;
    var phi_14671_: bool;
    var phi_14672_: f64;
    var phi_14673_: bool;
    var phi_14674_: f64;
    var phi_14675_: bool;
    var phi_14676_: bool;
    var phi_14681_: f64;
    var phi_14682_: bool;
    var phi_14686_: f64;
    var phi_14691_: f64;
    var phi_14696_: f64;
    var phi_14701_: f64;
    var phi_14715_: f64;
    var phi_14853_: type_18;
    var phi_14856_: f64;
    var phi_14877_: bool;
    var phi_14883_: type_19;
    var phi_14854_: type_18;
    var phi_14897_: type_19;
    var phi_14857_: f64;
    var local_29: f64;
    var phi_14846_: f64;
    var phi_14910_: f64;
    var phi_14928_: f64;
    var phi_14935_: f64;
    var phi_14940_: f64;
    var phi_14947_: f64;
    var phi_14952_: f64;
    var phi_14965_: f64;
    var phi_14972_: f64;
    var phi_14977_: f64;
    var phi_14984_: f64;
    var phi_14989_: f64;
    var phi_14994_: f64;
    var phi_15011_: f64;
    var phi_15018_: f64;
    var phi_15023_: f64;
    var phi_15030_: f64;
    var phi_15035_: f64;
    var phi_15049_: f64;
    var phi_15056_: f64;
    var phi_15061_: f64;
    var phi_15068_: f64;
    var phi_15073_: f64;
    var phi_15078_: f64;
    var phi_15095_: f64;
    var phi_15102_: f64;
    var phi_15107_: f64;
    var phi_15114_: f64;
    var phi_15119_: f64;
    var phi_15133_: f64;
    var phi_15140_: f64;
    var phi_15145_: f64;
    var phi_15152_: f64;
    var phi_15157_: f64;
    var phi_15162_: f64;
    var phi_15186_: bool;
    var phi_15187_: bool;
    var phi_15188_: bool;
    var phi_15205_: f64;
    var phi_15206_: bool;
    var phi_15207_: f64;
    var phi_15208_: bool;
    var phi_15213_: f64;
    var phi_15215_: f64;
    var phi_15216_: f64;
    var phi_15217_: bool;
    var phi_15218_: f64;
    var phi_15219_: f64;
    var phi_15220_: bool;
    var phi_15221_: bool;
    var phi_15222_: f64;
    var phi_15223_: f64;
    var phi_15224_: f64;
    var phi_15225_: f64;
    var phi_15226_: bool;
    var phi_15227_: bool;
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
    var phi_15238_: bool;
    var phi_15239_: f64;
    var phi_15240_: f64;
    var phi_15241_: f64;
    var phi_15242_: f64;
    var phi_15243_: bool;
    var phi_15244_: bool;
    var phi_15245_: bool;
    var phi_15246_: bool;
    var phi_15247_: bool;
    var phi_15333_: f64;
    var phi_15406_: f64;
    var phi_15411_: f64;
    var phi_15484_: f64;
    var phi_15557_: f64;
    var phi_15562_: f64;
    var phi_15583_: f64;
    var phi_15584_: f64;
    var phi_15585_: f64;
    var phi_15260_: bool;
    var phi_15587_: u32;
    var phi_15588_: f64;
    var phi_15589_: bool;
    var phi_15590_: bool;
    var phi_15591_: bool;
    var phi_15592_: u32;
    var phi_15593_: f64;
    var phi_15594_: f64;
    var phi_15595_: f64;
    var phi_15596_: f64;
    var phi_15597_: bool;
    var phi_15598_: u32;
    var phi_15599_: bool;
    var phi_15600_: bool;
    var phi_15601_: bool;
    var phi_15602_: bool;
    var phi_15603_: bool;
    var phi_15604_: bool;
    var phi_15613_: f64;
    var phi_15618_: f64;
    var phi_15627_: bool;
    var phi_15631_: bool;
    var phi_15632_: f64;
    var phi_15633_: f64;
    var phi_15634_: f64;
    var phi_15635_: f64;
    var phi_15636_: bool;
    var phi_15637_: u32;
    var phi_15638_: bool;
    var phi_15639_: bool;
    var phi_15640_: bool;
    var phi_15641_: bool;
    var phi_15642_: bool;
    var phi_15643_: bool;
    var phi_13422_: f64;
    var phi_13424_: f64;
    var phi_13426_: f64;
    var phi_13428_: f64;
    var phi_13430_: bool;
    var phi_13432_: u32;
    var phi_15644_: f64;
    var phi_15645_: f64;
    var phi_15646_: bool;
    var phi_15647_: bool;
    var phi_15648_: bool;
    var phi_15649_: bool;
    var phi_15650_: bool;
    var phi_15651_: bool;
    var phi_15652_: bool;
    var local_30: bool;
    var phi_15656_: bool;
    var phi_15657_: bool;
    var phi_15658_: bool;
    var phi_15659_: bool;
    var phi_15660_: bool;
    var local_31: f64;
    var phi_15665_: type_43;
    var phi_15666_: bool;
    var phi_15667_: bool;
    var phi_15668_: bool;
    var phi_15669_: bool;
    var phi_15670_: bool;
    var phi_15675_: type_43;
    var phi_15676_: bool;
    var phi_15677_: bool;
    var phi_15678_: bool;
    var phi_15679_: bool;
    var phi_15680_: bool;
    var phi_15684_: f64;
    var phi_15685_: bool;
    var phi_15686_: bool;
    var phi_15687_: bool;
    var phi_15688_: bool;
    var phi_15692_: f64;
    var phi_15693_: bool;
    var phi_15694_: bool;
    var phi_15695_: bool;
    var phi_15700_: type_43;
    var phi_15701_: bool;
    var phi_15702_: bool;
    var phi_15707_: type_43;
    var phi_15708_: bool;
    var phi_15712_: type_43;
    var phi_15719_: bool;
    var phi_15720_: f64;
    var phi_15721_: bool;
    var phi_15722_: bool;
    var phi_15723_: bool;
    var phi_15724_: bool;
    var phi_15725_: f64;
    var phi_15726_: f64;
    var phi_15727_: bool;
    var phi_15728_: bool;
    var phi_15729_: bool;
    var phi_15730_: bool;
    var phi_15731_: f64;
    var phi_15732_: f64;
    var phi_15733_: bool;
    var phi_15734_: bool;
    var phi_15735_: bool;
    var phi_15736_: bool;
    var phi_15740_: bool;
    var phi_15741_: bool;
    var phi_15742_: bool;
    var phi_15743_: type_46;
    var phi_15744_: bool;
    var phi_15745_: f64;
    var phi_15746_: f64;
    var phi_15747_: type_46;
    var phi_15748_: bool;
    var phi_15749_: bool;
    var phi_15750_: bool;
    var phi_15751_: bool;
    var phi_15755_: bool;
    var phi_15756_: bool;
    var phi_15757_: bool;
    var phi_15758_: type_46;
    var phi_15759_: bool;
    var phi_15760_: f64;
    var phi_15761_: f64;
    var phi_15762_: type_46;
    var phi_15763_: bool;
    var phi_15764_: bool;
    var phi_15765_: bool;
    var phi_15766_: bool;
    var local_32: bool;
    var phi_15771_: type_43;
    var phi_15772_: bool;
    var phi_15773_: bool;
    var local_33: bool;
    var local_34: type_46;
    var local_35: f64;
    var local_36: f64;
    var local_37: f64;
    var phi_15787_: type_43;
    var phi_15788_: bool;
    var phi_15789_: type_43;
    var phi_15790_: bool;
    var local_38: f64;
    var phi_15795_: type_43;
    var phi_15796_: type_43;
    var phi_15797_: bool;
    var local_39: type_46;
    var phi_15803_: type_43;
    var phi_15804_: bool;
    var phi_15808_: type_43;
    var phi_15809_: type_43;
    var phi_15810_: bool;
    var phi_15814_: type_43;
    var phi_15815_: type_43;
    var phi_15816_: bool;
    var phi_15820_: type_43;
    var phi_15831_: bool;
    var phi_15832_: bool;
    var phi_15836_: bool;
    var phi_15840_: u32;
    var phi_1529_: type_18;
    var phi_1532_: f64;
    var phi_1553_: bool;
    var phi_1559_: type_19;
    var phi_1530_: type_18;
    var phi_1573_: type_19;
    var phi_1533_: f64;
    var local_40: f64;
    var phi_1522_: f64;
    var phi_1586_: f64;
    var phi_1604_: f64;
    var phi_1611_: f64;
    var phi_1616_: f64;
    var phi_1623_: f64;
    var phi_1628_: f64;
    var phi_1641_: f64;
    var phi_1648_: f64;
    var phi_1653_: f64;
    var phi_1660_: f64;
    var phi_1665_: f64;
    var phi_1670_: f64;
    var phi_1687_: f64;
    var phi_1694_: f64;
    var phi_1699_: f64;
    var phi_1706_: f64;
    var phi_1711_: f64;
    var phi_1725_: f64;
    var phi_1732_: f64;
    var phi_1737_: f64;
    var phi_1744_: f64;
    var phi_1749_: f64;
    var phi_1754_: f64;
    var phi_1771_: f64;
    var phi_1778_: f64;
    var phi_1783_: f64;
    var phi_1790_: f64;
    var phi_1795_: f64;
    var phi_1809_: f64;
    var phi_1816_: f64;
    var phi_1821_: f64;
    var phi_1828_: f64;
    var phi_1833_: f64;
    var phi_1838_: f64;
    var phi_2103_: f64;
    var phi_2110_: f64;
    var phi_2115_: f64;
    var phi_2122_: f64;
    var phi_2127_: f64;
    var phi_2140_: f64;
    var phi_2147_: f64;
    var phi_2152_: f64;
    var phi_2159_: f64;
    var phi_2164_: f64;
    var phi_2169_: f64;
    var phi_2186_: f64;
    var phi_2193_: f64;
    var phi_2198_: f64;
    var phi_2205_: f64;
    var phi_2210_: f64;
    var phi_2224_: f64;
    var phi_2231_: f64;
    var phi_2236_: f64;
    var phi_2243_: f64;
    var phi_2248_: f64;
    var phi_2253_: f64;
    var phi_2270_: f64;
    var phi_2277_: f64;
    var phi_2282_: f64;
    var phi_2289_: f64;
    var phi_2294_: f64;
    var phi_2308_: f64;
    var phi_2315_: f64;
    var phi_2320_: f64;
    var phi_2327_: f64;
    var phi_2332_: f64;
    var phi_2337_: f64;
    var phi_2374_: f64;
    var phi_2380_: f64;
    var phi_2387_: f64;
    var phi_2394_: f64;
    var phi_2400_: f64;
    var phi_2407_: f64;
    var phi_2413_: f64;
    var phi_2419_: f64;
    var phi_2425_: f64;
    var phi_2432_: f64;
    var phi_2439_: f64;
    var phi_2467_: f64;
    var phi_2472_: f64;
    var phi_2477_: f64;
    var phi_2482_: f64;
    var phi_2487_: f64;
    var phi_2492_: f64;
    var phi_2503_: f64;
    var phi_2513_: type_44;
    var phi_2514_: bool;
    var phi_2515_: type_44;
    var phi_2516_: bool;
    var phi_2522_: type_18;
    var phi_2525_: f64;
    var phi_2527_: u32;
    var phi_2529_: f64;
    var phi_2550_: bool;
    var phi_2556_: type_19;
    var phi_2523_: type_18;
    var phi_2570_: type_19;
    var phi_2585_: bool;
    var phi_2586_: bool;
    var phi_2645_: array<f64, 3>;
    var phi_2710_: array<f64, 3>;
    var phi_2732_: f64;
    var phi_2739_: f64;
    var phi_2744_: f64;
    var phi_2751_: f64;
    var phi_2756_: f64;
    var phi_2769_: f64;
    var phi_2776_: f64;
    var phi_2781_: f64;
    var phi_2788_: f64;
    var phi_2793_: f64;
    var phi_2798_: f64;
    var phi_2815_: f64;
    var phi_2822_: f64;
    var phi_2827_: f64;
    var phi_2834_: f64;
    var phi_2839_: f64;
    var phi_2853_: f64;
    var phi_2860_: f64;
    var phi_2865_: f64;
    var phi_2872_: f64;
    var phi_2877_: f64;
    var phi_2882_: f64;
    var phi_2899_: f64;
    var phi_2906_: f64;
    var phi_2911_: f64;
    var phi_2918_: f64;
    var phi_2923_: f64;
    var phi_2937_: f64;
    var phi_2944_: f64;
    var phi_2949_: f64;
    var phi_2956_: f64;
    var phi_2961_: f64;
    var phi_2966_: f64;
    var phi_3013_: type_9;
    var phi_3016_: f64;
    var phi_3018_: f64;
    var phi_3020_: f64;
    var phi_3022_: f64;
    var phi_3024_: bool;
    var phi_3026_: u32;
    var phi_3014_: type_9;
    var phi_3049_: type_9;
    var phi_3164_: f64;
    var phi_3170_: f64;
    var phi_3176_: f64;
    var phi_3178_: array<f64, 3>;
    var phi_3185_: f64;
    var phi_3192_: f64;
    var phi_3200_: f64;
    var phi_3246_: type_18;
    var phi_3249_: f64;
    var phi_3270_: bool;
    var phi_3276_: type_19;
    var phi_3247_: type_18;
    var phi_3290_: type_19;
    var phi_3250_: f64;
    var local_41: f64;
    var phi_3239_: f64;
    var phi_3303_: f64;
    var phi_3372_: f64;
    var phi_3378_: f64;
    var phi_3387_: f64;
    var phi_3393_: f64;
    var phi_3402_: f64;
    var phi_3408_: f64;
    var phi_3417_: f64;
    var phi_3423_: f64;
    var phi_3429_: type_35;
    var phi_3430_: bool;
    var phi_3431_: type_35;
    var phi_3432_: bool;
    var phi_3442_: type_35;
    var phi_3614_: bool;
    var phi_3615_: bool;
    var phi_3616_: bool;
    var phi_3617_: bool;
    var phi_3618_: bool;
    var phi_3619_: bool;
    var phi_3623_: bool;
    var phi_3921_: bool;
    var phi_3922_: bool;
    var phi_3923_: bool;
    var phi_3924_: bool;
    var phi_3925_: bool;
    var phi_3926_: bool;
    var phi_3930_: bool;
    var phi_3934_: bool;
    var phi_3945_: bool;
    var phi_3946_: bool;
    var phi_4020_: bool;
    var phi_4021_: bool;
    var phi_4044_: f64;
    var phi_4045_: bool;
    var phi_4046_: f64;
    var phi_4047_: bool;
    var phi_4048_: f64;
    var phi_4049_: bool;
    var phi_4050_: bool;
    var phi_4055_: f64;
    var phi_4056_: bool;
    var phi_4060_: f64;
    var phi_4092_: bool;
    var phi_4093_: bool;
    var phi_4116_: f64;
    var phi_4117_: bool;
    var phi_4118_: f64;
    var phi_4119_: bool;
    var phi_4120_: f64;
    var phi_4121_: bool;
    var phi_4122_: bool;
    var phi_4127_: f64;
    var phi_4128_: bool;
    var phi_4132_: f64;
    var phi_4137_: f64;
    var phi_4169_: bool;
    var phi_4170_: bool;
    var phi_4193_: f64;
    var phi_4194_: bool;
    var phi_4195_: f64;
    var phi_4196_: bool;
    var phi_4197_: f64;
    var phi_4198_: bool;
    var phi_4199_: bool;
    var phi_4204_: f64;
    var phi_4205_: bool;
    var phi_4209_: f64;
    var phi_4241_: bool;
    var phi_4242_: bool;
    var phi_4265_: f64;
    var phi_4266_: bool;
    var phi_4267_: f64;
    var phi_4268_: bool;
    var phi_4269_: f64;
    var phi_4270_: bool;
    var phi_4271_: bool;
    var phi_4276_: f64;
    var phi_4277_: bool;
    var phi_4281_: f64;
    var phi_4286_: f64;
    var phi_4291_: f64;
    var phi_4296_: f64;
    var phi_4310_: f64;
    var phi_4448_: type_18;
    var phi_4451_: f64;
    var phi_4472_: bool;
    var phi_4478_: type_19;
    var phi_4449_: type_18;
    var phi_4492_: type_19;
    var phi_4452_: f64;
    var local_42: f64;
    var phi_4441_: f64;
    var phi_4505_: f64;
    var phi_4523_: f64;
    var phi_4530_: f64;
    var phi_4535_: f64;
    var phi_4542_: f64;
    var phi_4547_: f64;
    var phi_4560_: f64;
    var phi_4567_: f64;
    var phi_4572_: f64;
    var phi_4579_: f64;
    var phi_4584_: f64;
    var phi_4589_: f64;
    var phi_4606_: f64;
    var phi_4613_: f64;
    var phi_4618_: f64;
    var phi_4625_: f64;
    var phi_4630_: f64;
    var phi_4644_: f64;
    var phi_4651_: f64;
    var phi_4656_: f64;
    var phi_4663_: f64;
    var phi_4668_: f64;
    var phi_4673_: f64;
    var phi_4690_: f64;
    var phi_4697_: f64;
    var phi_4702_: f64;
    var phi_4709_: f64;
    var phi_4714_: f64;
    var phi_4728_: f64;
    var phi_4735_: f64;
    var phi_4740_: f64;
    var phi_4747_: f64;
    var phi_4752_: f64;
    var phi_4757_: f64;
    var phi_4781_: bool;
    var phi_4782_: bool;
    var phi_4783_: bool;
    var phi_4800_: f64;
    var phi_4801_: bool;
    var phi_4802_: f64;
    var phi_4803_: bool;
    var phi_4808_: f64;
    var phi_4810_: f64;
    var phi_4811_: f64;
    var phi_4812_: bool;
    var phi_4813_: f64;
    var phi_4814_: f64;
    var phi_4815_: bool;
    var phi_4816_: bool;
    var phi_4817_: f64;
    var phi_4818_: f64;
    var phi_4819_: f64;
    var phi_4820_: f64;
    var phi_4821_: bool;
    var phi_4822_: bool;
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
    var phi_4833_: bool;
    var phi_4834_: f64;
    var phi_4835_: f64;
    var phi_4836_: f64;
    var phi_4837_: f64;
    var phi_4838_: bool;
    var phi_4839_: bool;
    var phi_4840_: bool;
    var phi_4841_: bool;
    var phi_4842_: bool;
    var phi_4928_: f64;
    var phi_5001_: f64;
    var phi_5006_: f64;
    var phi_5079_: f64;
    var phi_5152_: f64;
    var phi_5157_: f64;
    var phi_5178_: f64;
    var phi_5179_: f64;
    var phi_5180_: f64;
    var phi_4855_: bool;
    var phi_5182_: u32;
    var phi_5183_: f64;
    var phi_5184_: bool;
    var phi_5185_: bool;
    var phi_5186_: bool;
    var phi_5187_: u32;
    var phi_5188_: f64;
    var phi_5189_: f64;
    var phi_5190_: f64;
    var phi_5191_: f64;
    var phi_5192_: bool;
    var phi_5193_: u32;
    var phi_5194_: bool;
    var phi_5195_: bool;
    var phi_5196_: bool;
    var phi_5197_: bool;
    var phi_5198_: bool;
    var phi_5199_: bool;
    var phi_5208_: f64;
    var phi_5213_: f64;
    var phi_5222_: bool;
    var phi_5226_: bool;
    var phi_5227_: f64;
    var phi_5228_: f64;
    var phi_5229_: f64;
    var phi_5230_: f64;
    var phi_5231_: bool;
    var phi_5232_: u32;
    var phi_5233_: bool;
    var phi_5234_: bool;
    var phi_5235_: bool;
    var phi_5236_: bool;
    var phi_5237_: bool;
    var phi_5238_: bool;
    var phi_3017_: f64;
    var phi_3019_: f64;
    var phi_3021_: f64;
    var phi_3023_: f64;
    var phi_3025_: bool;
    var phi_3027_: u32;
    var phi_5239_: f64;
    var phi_5240_: f64;
    var phi_5241_: bool;
    var phi_5242_: bool;
    var phi_5243_: bool;
    var phi_5244_: bool;
    var phi_5245_: bool;
    var phi_5246_: bool;
    var phi_5247_: bool;
    var local_43: bool;
    var phi_5251_: bool;
    var phi_5252_: bool;
    var phi_5253_: bool;
    var phi_5254_: bool;
    var phi_5255_: bool;
    var local_44: f64;
    var phi_5260_: type_43;
    var phi_5261_: bool;
    var phi_5262_: bool;
    var phi_5263_: bool;
    var phi_5264_: bool;
    var phi_5265_: bool;
    var phi_5270_: type_43;
    var phi_5271_: bool;
    var phi_5272_: bool;
    var phi_5273_: bool;
    var phi_5274_: bool;
    var phi_5275_: bool;
    var phi_5279_: f64;
    var phi_5280_: bool;
    var phi_5281_: bool;
    var phi_5282_: bool;
    var phi_5283_: bool;
    var phi_5287_: f64;
    var phi_5288_: bool;
    var phi_5289_: bool;
    var phi_5290_: bool;
    var phi_5295_: type_43;
    var phi_5296_: bool;
    var phi_5297_: bool;
    var phi_5302_: type_43;
    var phi_5303_: bool;
    var phi_5307_: type_43;
    var phi_5314_: f64;
    var phi_5315_: bool;
    var phi_5428_: f64;
    var phi_5435_: f64;
    var phi_5443_: f64;
    var phi_5501_: array<f64, 3>;
    var phi_5569_: array<f64, 3>;
    var phi_5594_: f64;
    var phi_5601_: f64;
    var phi_5606_: f64;
    var phi_5613_: f64;
    var phi_5618_: f64;
    var phi_5631_: f64;
    var phi_5638_: f64;
    var phi_5643_: f64;
    var phi_5650_: f64;
    var phi_5655_: f64;
    var phi_5660_: f64;
    var phi_5677_: f64;
    var phi_5684_: f64;
    var phi_5689_: f64;
    var phi_5696_: f64;
    var phi_5701_: f64;
    var phi_5715_: f64;
    var phi_5722_: f64;
    var phi_5727_: f64;
    var phi_5734_: f64;
    var phi_5739_: f64;
    var phi_5744_: f64;
    var phi_5761_: f64;
    var phi_5768_: f64;
    var phi_5773_: f64;
    var phi_5780_: f64;
    var phi_5785_: f64;
    var phi_5799_: f64;
    var phi_5806_: f64;
    var phi_5811_: f64;
    var phi_5818_: f64;
    var phi_5823_: f64;
    var phi_5828_: f64;
    var phi_5940_: type_18;
    var phi_5943_: f64;
    var phi_5964_: bool;
    var phi_5970_: type_19;
    var phi_5941_: type_18;
    var phi_5984_: type_19;
    var phi_5944_: f64;
    var local_45: f64;
    var phi_5933_: f64;
    var phi_5997_: f64;
    var phi_6134_: f64;
    var phi_6140_: f64;
    var phi_6149_: f64;
    var phi_6155_: f64;
    var phi_6164_: f64;
    var phi_6170_: f64;
    var phi_6179_: f64;
    var phi_6185_: f64;
    var phi_6235_: type_18;
    var phi_6238_: f64;
    var phi_6259_: bool;
    var phi_6265_: type_19;
    var phi_6236_: type_18;
    var phi_6279_: type_19;
    var phi_6239_: f64;
    var local_46: f64;
    var phi_6228_: f64;
    var phi_6292_: f64;
    var phi_6324_: type_18;
    var phi_6327_: f64;
    var phi_6348_: bool;
    var phi_6354_: type_19;
    var phi_6325_: type_18;
    var phi_6368_: type_19;
    var phi_6328_: f64;
    var local_47: f64;
    var phi_6317_: f64;
    var phi_6381_: f64;
    var phi_6399_: f64;
    var phi_6406_: f64;
    var phi_6411_: f64;
    var phi_6418_: f64;
    var phi_6423_: f64;
    var phi_6436_: f64;
    var phi_6443_: f64;
    var phi_6448_: f64;
    var phi_6455_: f64;
    var phi_6460_: f64;
    var phi_6465_: f64;
    var phi_6482_: f64;
    var phi_6489_: f64;
    var phi_6494_: f64;
    var phi_6501_: f64;
    var phi_6506_: f64;
    var phi_6520_: f64;
    var phi_6527_: f64;
    var phi_6532_: f64;
    var phi_6539_: f64;
    var phi_6544_: f64;
    var phi_6549_: f64;
    var phi_6566_: f64;
    var phi_6573_: f64;
    var phi_6578_: f64;
    var phi_6585_: f64;
    var phi_6590_: f64;
    var phi_6604_: f64;
    var phi_6611_: f64;
    var phi_6616_: f64;
    var phi_6623_: f64;
    var phi_6628_: f64;
    var phi_6633_: f64;
    var phi_6681_: f64;
    var phi_6687_: f64;
    var phi_6699_: type_9;
    var phi_6702_: f64;
    var phi_6700_: type_9;
    var phi_6725_: type_9;
    var phi_6755_: f64;
    var phi_6761_: f64;
    var phi_6775_: f64;
    var phi_6703_: f64;
    var local_48: f64;
    var local_49: f64;
    var phi_6804_: type_18;
    var phi_6807_: f64;
    var phi_6828_: bool;
    var phi_6834_: type_19;
    var phi_6805_: type_18;
    var phi_6848_: type_19;
    var phi_6808_: f64;
    var local_50: f64;
    var phi_6797_: f64;
    var phi_6861_: f64;
    var phi_6868_: type_9;
    var phi_6871_: f64;
    var phi_6873_: bool;
    var phi_6875_: bool;
    var phi_6869_: type_9;
    var phi_6898_: type_9;
    var phi_6935_: f64;
    var phi_6942_: f64;
    var phi_6950_: f64;
    var phi_6958_: f64;
    var phi_6965_: f64;
    var phi_6973_: f64;
    var phi_6979_: f64;
    var phi_6999_: f64;
    var phi_7005_: f64;
    var phi_7012_: f64;
    var phi_7041_: f64;
    var phi_7047_: f64;
    var phi_7084_: bool;
    var phi_7091_: bool;
    var phi_7104_: f64;
    var phi_7110_: f64;
    var phi_7111_: f64;
    var phi_7112_: f64;
    var phi_6872_: f64;
    var phi_6874_: bool;
    var phi_6876_: bool;
    var local_51: f64;
    var phi_7118_: f64;
    var local_52: bool;
    var local_53: bool;
    var phi_7129_: type_45;
    var phi_7130_: type_45;
    var phi_7131_: bool;
    var local_54: bool;
    var phi_7149_: f64;
    var phi_7150_: f64;
    var phi_7153_: type_9;
    var phi_7156_: f64;
    var phi_7158_: f64;
    var phi_7154_: type_9;
    var phi_7181_: type_9;
    var phi_7267_: f64;
    var phi_7268_: f64;
    var phi_7269_: f64;
    var phi_7250_: f64;
    var phi_7270_: f64;
    var phi_7271_: f64;
    var phi_7157_: f64;
    var phi_7159_: f64;
    var local_55: f64;
    var local_56: f64;
    var local_57: f64;
    var phi_7434_: bool;
    var phi_7435_: bool;
    var phi_7436_: bool;
    var phi_7437_: bool;
    var phi_7438_: bool;
    var phi_7439_: bool;
    var phi_7443_: bool;
    var phi_7447_: bool;
    var phi_7448_: bool;
    var phi_7449_: bool;
    var phi_7454_: f64;
    var phi_7458_: type_45;
    var phi_7459_: type_45;
    var phi_7460_: bool;
    var phi_7461_: type_45;
    var phi_7462_: type_45;
    var phi_7463_: bool;
    var phi_7469_: type_45;
    var phi_7470_: type_45;
    var phi_7471_: bool;
    var phi_7475_: type_45;
    var phi_7476_: type_45;
    var phi_7477_: bool;
    var phi_7478_: bool;
    var phi_7479_: type_45;
    var phi_7480_: type_45;
    var phi_7481_: bool;
    var phi_7482_: bool;
    var phi_7488_: type_45;
    var phi_7489_: bool;
    var phi_7493_: type_45;
    var phi_7509_: f64;
    var phi_7510_: f64;
    var phi_7511_: bool;
    var phi_7512_: f64;
    var phi_7513_: f64;
    var phi_7514_: bool;
    var phi_7515_: bool;
    var phi_7516_: bool;
    var phi_7517_: f64;
    var phi_7518_: f64;
    var phi_7519_: bool;
    var phi_7520_: bool;
    var phi_7521_: bool;
    var phi_7522_: f64;
    var phi_7523_: u32;
    var phi_7524_: f64;
    var phi_7525_: type_45;
    var phi_7526_: u32;
    var phi_7527_: u32;
    var phi_7528_: bool;
    var phi_7529_: bool;
    var phi_7530_: bool;
    var phi_7531_: f64;
    var phi_7532_: u32;
    var phi_7533_: f64;
    var phi_7534_: type_45;
    var phi_7535_: u32;
    var phi_7536_: u32;
    var phi_7537_: bool;
    var phi_7538_: bool;
    var phi_7539_: bool;
    var phi_7540_: bool;
    var phi_7541_: bool;
    var phi_7542_: f64;
    var phi_2526_: f64;
    var phi_2528_: u32;
    var phi_2530_: f64;
    var phi_7543_: type_45;
    var phi_7544_: u32;
    var phi_7545_: f64;
    var phi_7546_: u32;
    var phi_7547_: bool;
    var phi_7548_: bool;
    var phi_7549_: bool;
    var phi_7550_: bool;
    var phi_7551_: bool;
    var phi_7552_: bool;
    var local_58: bool;
    var phi_7556_: bool;
    var phi_7557_: bool;
    var phi_7558_: bool;
    var phi_7559_: bool;
    var local_59: type_45;
    var local_60: type_45;
    var phi_7576_: u32;
    var local_61: type_45;
    var phi_7581_: type_44;
    var phi_7582_: type_44;
    var phi_7583_: bool;
    var phi_7584_: bool;
    var phi_7585_: bool;
    var phi_7586_: bool;
    var phi_7590_: u32;
    var phi_7591_: f64;
    var phi_7592_: bool;
    var phi_7593_: bool;
    var phi_7594_: bool;
    var phi_7595_: bool;
    var phi_7599_: f64;
    var phi_7600_: u32;
    var phi_7601_: bool;
    var phi_7602_: bool;
    var phi_7603_: bool;
    var phi_7617_: f64;
    var phi_7620_: type_9;
    var phi_7621_: type_9;
    var phi_7644_: type_9;
    var phi_7666_: f64;
    var phi_7796_: type_18;
    var phi_7799_: f64;
    var phi_7820_: bool;
    var phi_7826_: type_19;
    var phi_7797_: type_18;
    var phi_7840_: type_19;
    var phi_7800_: f64;
    var local_62: f64;
    var phi_7789_: f64;
    var phi_7853_: f64;
    var phi_7871_: f64;
    var phi_7878_: f64;
    var phi_7883_: f64;
    var phi_7890_: f64;
    var phi_7895_: f64;
    var phi_7908_: f64;
    var phi_7915_: f64;
    var phi_7920_: f64;
    var phi_7927_: f64;
    var phi_7932_: f64;
    var phi_7937_: f64;
    var phi_7954_: f64;
    var phi_7961_: f64;
    var phi_7966_: f64;
    var phi_7973_: f64;
    var phi_7978_: f64;
    var phi_7992_: f64;
    var phi_7999_: f64;
    var phi_8004_: f64;
    var phi_8011_: f64;
    var phi_8016_: f64;
    var phi_8021_: f64;
    var phi_8038_: f64;
    var phi_8045_: f64;
    var phi_8050_: f64;
    var phi_8057_: f64;
    var phi_8062_: f64;
    var phi_8076_: f64;
    var phi_8083_: f64;
    var phi_8088_: f64;
    var phi_8095_: f64;
    var phi_8100_: f64;
    var phi_8105_: f64;
    var phi_8129_: bool;
    var phi_8130_: bool;
    var phi_8131_: bool;
    var local_63: bool;
    var phi_8139_: u32;
    var phi_8143_: type_44;
    var phi_8144_: bool;
    var phi_8152_: u32;
    var phi_8156_: type_44;
    var phi_8157_: type_44;
    var phi_8158_: bool;
    var phi_8159_: bool;
    var phi_8166_: type_44;
    var phi_8167_: bool;
    var phi_8171_: type_44;
    var phi_8172_: type_44;
    var phi_8173_: bool;
    var phi_8177_: type_44;
    var phi_15844_: type_44;
    var phi_15862_: type_47;
    var phi_15880_: bool;
    var phi_15887_: bool;
    var phi_15888_: bool;
    var phi_15911_: u32;
    var phi_15915_: type_20;
    var phi_15916_: bool;
    var phi_15927_: u32;
    var phi_15987_: bool;
    var phi_15988_: bool;
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
                    phi_619_ = type_23(0u, array<u32, 4>(_e220, _e242, _e245, _e248));
                } else {
                    let _e226 = (2u * _e220);
                    let _e227 = (2u * _e223);
                    let _e229 = elements.member[_e226];
                    let _e231 = elements.member[_e227];
                    let _e234 = elements.member[(_e226 + 1u)];
                    let _e237 = elements.member[(_e227 + 1u)];
                    phi_619_ = type_23(1u, array<u32, 4>(_e229, _e234, _e231, _e237));
                }
                let _e252 = phi_619_;
                let _e256 = params.member.member.member_1;
                if ((_e256 & 8u) != 0u) {
                    let _e300 = paths.member[_e252.member_1[0]];
                    let _e315 = paths.member[_e252.member_1[1]];
                    let _e330 = paths.member[_e252.member_1[2]];
                    let _e345 = paths.member[_e252.member_1[3]];
                    let _e366 = function_(array<f32, 3>(_e300.member.x, _e300.member.y, _e300.member.z));
                    let _e367 = function_(array<f32, 3>(_e315.member.x, _e315.member.y, _e315.member.z));
                    let _e368 = function_(array<f32, 3>(_e330.member.x, _e330.member.y, _e330.member.z));
                    let _e369 = function_(array<f32, 3>(_e345.member.x, _e345.member.y, _e345.member.z));
                    let _e371 = function_(array<f32, 3>(_e300.member_1.x, _e300.member_1.y, _e300.member_1.z));
                    let _e372 = function_(array<f32, 3>(_e315.member_1.x, _e315.member_1.y, _e315.member_1.z));
                    let _e373 = function_(array<f32, 3>(_e330.member_1.x, _e330.member_1.y, _e330.member_1.z));
                    let _e374 = function_(array<f32, 3>(_e345.member_1.x, _e345.member_1.y, _e345.member_1.z));
                    phi_815_ = type_31(array<array<f64, 3>, 4>(_e366, _e367, _e368, _e369), array<array<f64, 3>, 4>(_e371, _e372, _e373, _e374));
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
                    phi_815_ = type_31(array<array<f64, 3>, 4>(_e261, _e270, _e279, _e288), array<array<f64, 3>, 4>(_e267, _e276, _e285, _e294));
                }
                let _e378 = phi_815_;
                if (_e252.member != 0u) {
                    phi_976_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e378.member[2][0] - _e378.member[0][0]), (_e378.member[2][1] - _e378.member[0][1]), (_e378.member[2][2] - _e378.member[0][2])), array<f64, 3>((_e378.member_1[2][0] - _e378.member_1[0][0]), (_e378.member_1[2][1] - _e378.member_1[0][1]), (_e378.member_1[2][2] - _e378.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e378.member[1][0] - _e378.member[0][0]), (_e378.member[1][1] - _e378.member[0][1]), (_e378.member[1][2] - _e378.member[0][2])), array<f64, 3>((_e378.member_1[1][0] - _e378.member_1[0][0]), (_e378.member_1[1][1] - _e378.member_1[0][1]), (_e378.member_1[1][2] - _e378.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e378.member[2][0] - _e378.member[3][0]), (_e378.member[2][1] - _e378.member[3][1]), (_e378.member[2][2] - _e378.member[3][2])), array<f64, 3>((_e378.member_1[2][0] - _e378.member_1[3][0]), (_e378.member_1[2][1] - _e378.member_1[3][1]), (_e378.member_1[2][2] - _e378.member_1[3][2]))), (0.0lf + 0.0lf));
                } else {
                    phi_976_ = type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e378.member[0][0] - _e378.member[1][0]), (_e378.member[0][1] - _e378.member[1][1]), (_e378.member[0][2] - _e378.member[1][2])), array<f64, 3>((_e378.member_1[0][0] - _e378.member_1[1][0]), (_e378.member_1[0][1] - _e378.member_1[1][1]), (_e378.member_1[0][2] - _e378.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e378.member[2][0] - _e378.member[1][0]), (_e378.member[2][1] - _e378.member[1][1]), (_e378.member[2][2] - _e378.member[1][2])), array<f64, 3>((_e378.member_1[2][0] - _e378.member_1[1][0]), (_e378.member_1[2][1] - _e378.member_1[1][1]), (_e378.member_1[2][2] - _e378.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e378.member[3][0] - _e378.member[1][0]), (_e378.member[3][1] - _e378.member[1][1]), (_e378.member[3][2] - _e378.member[1][2])), array<f64, 3>((_e378.member_1[3][0] - _e378.member_1[1][0]), (_e378.member_1[3][1] - _e378.member_1[1][1]), (_e378.member_1[3][2] - _e378.member_1[1][2]))), (0.0lf + 0.0lf));
                }
                let _e537 = phi_976_;
                let _e539 = params.member.member.member_7;
                let _e546 = bitcast<f64>(((u64(_e539[1]) * 4294967296lu) + u64(_e539[0])));
                let _e548 = params.member.member.member_14;
                let _e555 = bitcast<f64>(((u64(_e548[1]) * 4294967296lu) + u64(_e548[0])));
                let _e557 = params.member.member.member_15;
                let _e564 = bitcast<f64>(((u64(_e557[1]) * 4294967296lu) + u64(_e557[0])));
                let _e566 = params.member.member.member_16;
                let _e573 = bitcast<f64>(((u64(_e566[1]) * 4294967296lu) + u64(_e566[0])));
                let _e575 = params.member.member.member_1;
                if (_e537.member[0][0] < 0.0lf) {
                    phi_1024_ = -(_e537.member[0][0]);
                } else {
                    phi_1024_ = _e537.member[0][0];
                }
                let _e584 = phi_1024_;
                if (_e537.member[0][1] < 0.0lf) {
                    phi_1031_ = -(_e537.member[0][1]);
                } else {
                    phi_1031_ = _e537.member[0][1];
                }
                let _e589 = phi_1031_;
                if (_e584 > _e589) {
                    phi_1036_ = _e584;
                } else {
                    phi_1036_ = _e589;
                }
                let _e592 = phi_1036_;
                if (_e537.member[0][2] < 0.0lf) {
                    phi_1043_ = -(_e537.member[0][2]);
                } else {
                    phi_1043_ = _e537.member[0][2];
                }
                let _e597 = phi_1043_;
                if (_e592 > _e597) {
                    phi_1048_ = _e592;
                } else {
                    phi_1048_ = _e597;
                }
                let _e600 = phi_1048_;
                if (_e537.member[1][0] < 0.0lf) {
                    phi_1056_ = -(_e537.member[1][0]);
                } else {
                    phi_1056_ = _e537.member[1][0];
                }
                let _e607 = phi_1056_;
                if (_e537.member[1][1] < 0.0lf) {
                    phi_1063_ = -(_e537.member[1][1]);
                } else {
                    phi_1063_ = _e537.member[1][1];
                }
                let _e612 = phi_1063_;
                if (_e607 > _e612) {
                    phi_1068_ = _e607;
                } else {
                    phi_1068_ = _e612;
                }
                let _e615 = phi_1068_;
                if (_e537.member[1][2] < 0.0lf) {
                    phi_1075_ = -(_e537.member[1][2]);
                } else {
                    phi_1075_ = _e537.member[1][2];
                }
                let _e620 = phi_1075_;
                if (_e615 > _e620) {
                    phi_1080_ = _e615;
                } else {
                    phi_1080_ = _e620;
                }
                let _e623 = phi_1080_;
                if (_e600 > _e623) {
                    phi_1085_ = _e600;
                } else {
                    phi_1085_ = _e623;
                }
                let _e626 = phi_1085_;
                let _e628 = (_e626 + _e537.member_3);
                if (_e537.member_1[0][0] < 0.0lf) {
                    phi_1095_ = -(_e537.member_1[0][0]);
                } else {
                    phi_1095_ = _e537.member_1[0][0];
                }
                let _e635 = phi_1095_;
                if (_e537.member_1[0][1] < 0.0lf) {
                    phi_1102_ = -(_e537.member_1[0][1]);
                } else {
                    phi_1102_ = _e537.member_1[0][1];
                }
                let _e640 = phi_1102_;
                if (_e635 > _e640) {
                    phi_1107_ = _e635;
                } else {
                    phi_1107_ = _e640;
                }
                let _e643 = phi_1107_;
                if (_e537.member_1[0][2] < 0.0lf) {
                    phi_1114_ = -(_e537.member_1[0][2]);
                } else {
                    phi_1114_ = _e537.member_1[0][2];
                }
                let _e648 = phi_1114_;
                if (_e643 > _e648) {
                    phi_1119_ = _e643;
                } else {
                    phi_1119_ = _e648;
                }
                let _e651 = phi_1119_;
                if (_e537.member_1[1][0] < 0.0lf) {
                    phi_1127_ = -(_e537.member_1[1][0]);
                } else {
                    phi_1127_ = _e537.member_1[1][0];
                }
                let _e658 = phi_1127_;
                if (_e537.member_1[1][1] < 0.0lf) {
                    phi_1134_ = -(_e537.member_1[1][1]);
                } else {
                    phi_1134_ = _e537.member_1[1][1];
                }
                let _e663 = phi_1134_;
                if (_e658 > _e663) {
                    phi_1139_ = _e658;
                } else {
                    phi_1139_ = _e663;
                }
                let _e666 = phi_1139_;
                if (_e537.member_1[1][2] < 0.0lf) {
                    phi_1146_ = -(_e537.member_1[1][2]);
                } else {
                    phi_1146_ = _e537.member_1[1][2];
                }
                let _e671 = phi_1146_;
                if (_e666 > _e671) {
                    phi_1151_ = _e666;
                } else {
                    phi_1151_ = _e671;
                }
                let _e674 = phi_1151_;
                if (_e651 > _e674) {
                    phi_1156_ = _e651;
                } else {
                    phi_1156_ = _e674;
                }
                let _e677 = phi_1156_;
                let _e679 = (_e677 + _e537.member_3);
                if (_e537.member_2[0][0] < 0.0lf) {
                    phi_1166_ = -(_e537.member_2[0][0]);
                } else {
                    phi_1166_ = _e537.member_2[0][0];
                }
                let _e686 = phi_1166_;
                if (_e537.member_2[0][1] < 0.0lf) {
                    phi_1173_ = -(_e537.member_2[0][1]);
                } else {
                    phi_1173_ = _e537.member_2[0][1];
                }
                let _e691 = phi_1173_;
                if (_e686 > _e691) {
                    phi_1178_ = _e686;
                } else {
                    phi_1178_ = _e691;
                }
                let _e694 = phi_1178_;
                if (_e537.member_2[0][2] < 0.0lf) {
                    phi_1185_ = -(_e537.member_2[0][2]);
                } else {
                    phi_1185_ = _e537.member_2[0][2];
                }
                let _e699 = phi_1185_;
                if (_e694 > _e699) {
                    phi_1190_ = _e694;
                } else {
                    phi_1190_ = _e699;
                }
                let _e702 = phi_1190_;
                if (_e537.member_2[1][0] < 0.0lf) {
                    phi_1198_ = -(_e537.member_2[1][0]);
                } else {
                    phi_1198_ = _e537.member_2[1][0];
                }
                let _e709 = phi_1198_;
                if (_e537.member_2[1][1] < 0.0lf) {
                    phi_1205_ = -(_e537.member_2[1][1]);
                } else {
                    phi_1205_ = _e537.member_2[1][1];
                }
                let _e714 = phi_1205_;
                if (_e709 > _e714) {
                    phi_1210_ = _e709;
                } else {
                    phi_1210_ = _e714;
                }
                let _e717 = phi_1210_;
                if (_e537.member_2[1][2] < 0.0lf) {
                    phi_1217_ = -(_e537.member_2[1][2]);
                } else {
                    phi_1217_ = _e537.member_2[1][2];
                }
                let _e722 = phi_1217_;
                if (_e717 > _e722) {
                    phi_1222_ = _e717;
                } else {
                    phi_1222_ = _e722;
                }
                let _e725 = phi_1222_;
                if (_e702 > _e725) {
                    phi_1227_ = _e702;
                } else {
                    phi_1227_ = _e725;
                }
                let _e728 = phi_1227_;
                let _e730 = (_e728 + _e537.member_3);
                if (_e628 > _e679) {
                    phi_1234_ = _e628;
                } else {
                    phi_1234_ = _e679;
                }
                let _e733 = phi_1234_;
                if (_e733 > _e730) {
                    phi_1239_ = _e733;
                } else {
                    phi_1239_ = _e730;
                }
                let _e736 = phi_1239_;
                if (_e736 <= f64(65536f)) {
                    phi_1248_ = (_e736 >= f64((1f / 65536f)));
                } else {
                    phi_1248_ = false;
                }
                let _e743 = phi_1248_;
                if _e743 {
                    phi_1348_ = type_42();
                    phi_1349_ = true;
                } else {
                    if (_e736 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e736) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e750 = (9214364837600034816lu - (bitcast<u64>(_e736) & 9218868437227405312lu));
                            if (_e750 > 4503599627370496lu) {
                                phi_1272_ = _e750;
                            } else {
                                phi_1272_ = 4503599627370496lu;
                            }
                            let _e753 = phi_1272_;
                            let _e754 = bitcast<f64>(_e753);
                            let _e755 = (_e546 * _e754);
                            if (_e546 > f64(0f)) {
                                if (_e755 > 2.2250738585072014e-308lf) {
                                    phi_1284_ = _e755;
                                } else {
                                    phi_1284_ = 2.2250738585072014e-308lf;
                                }
                                let _e760 = phi_1284_;
                                phi_1285_ = _e760;
                            } else {
                                phi_1285_ = _e755;
                            }
                            let _e762 = phi_1285_;
                            phi_1344_ = type_42(type_33(array<array<f64, 3>, 2>(array<f64, 3>((_e537.member[0][0] * _e754), (_e537.member[0][1] * _e754), (_e537.member[0][2] * _e754)), array<f64, 3>((_e537.member[1][0] * _e754), (_e537.member[1][1] * _e754), (_e537.member[1][2] * _e754))), array<array<f64, 3>, 2>(array<f64, 3>((_e537.member_1[0][0] * _e754), (_e537.member_1[0][1] * _e754), (_e537.member_1[0][2] * _e754)), array<f64, 3>((_e537.member_1[1][0] * _e754), (_e537.member_1[1][1] * _e754), (_e537.member_1[1][2] * _e754))), array<array<f64, 3>, 2>(array<f64, 3>((_e537.member_2[0][0] * _e754), (_e537.member_2[0][1] * _e754), (_e537.member_2[0][2] * _e754)), array<f64, 3>((_e537.member_2[1][0] * _e754), (_e537.member_2[1][1] * _e754), (_e537.member_2[1][2] * _e754))), ((_e537.member_3 + (2.2250738585072014e-308lf * f64(8f))) * _e754)), _e762);
                            phi_1345_ = false;
                        } else {
                            phi_1344_ = type_42();
                            phi_1345_ = true;
                        }
                        let _e828 = phi_1344_;
                        let _e830 = phi_1345_;
                        phi_1346_ = _e828;
                        phi_1347_ = _e830;
                    } else {
                        phi_1346_ = type_42();
                        phi_1347_ = true;
                    }
                    let _e832 = phi_1346_;
                    let _e834 = phi_1347_;
                    phi_1348_ = _e832;
                    phi_1349_ = _e834;
                }
                let _e836 = phi_1348_;
                let _e838 = phi_1349_;
                if _e838 {
                    phi_1354_ = type_42(_e537, _e546);
                } else {
                    phi_1354_ = _e836;
                }
                let _e841 = phi_1354_;
                local_18 = type_33(array<array<f64, 3>, 2>(array<f64, 3>(_e841.member.member[0][0], _e841.member.member[0][1], _e841.member.member[0][2]), array<f64, 3>(_e841.member.member[1][0], _e841.member.member[1][1], _e841.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e841.member.member_1[0][0], _e841.member.member_1[0][1], _e841.member.member_1[0][2]), array<f64, 3>(_e841.member.member_1[1][0], _e841.member.member_1[1][1], _e841.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e841.member.member_2[0][0], _e841.member.member_2[0][1], _e841.member.member_2[0][2]), array<f64, 3>(_e841.member.member_2[1][0], _e841.member.member_2[1][1], _e841.member.member_2[1][2])), _e841.member.member_3);
                if (_e841.member_1 > f64(0f)) {
                    let _e6167 = local_18.member[0u];
                    let _e6173 = local_18.member[1u];
                    let _e6189 = local_18.member_1[0u];
                    let _e6195 = local_18.member_1[1u];
                    let _e6211 = local_18.member_2[0u];
                    let _e6217 = local_18.member_2[1u];
                    let _e6231 = function_4(array<f64, 3>((_e6167[0] + ((_e6173[0] - _e6167[0]) * _e564)), (_e6167[1] + ((_e6173[1] - _e6167[1]) * _e564)), (_e6167[2] + ((_e6173[2] - _e6167[2]) * _e564))), array<f64, 3>((_e6189[0] + ((_e6195[0] - _e6189[0]) * _e564)), (_e6189[1] + ((_e6195[1] - _e6189[1]) * _e564)), (_e6189[2] + ((_e6195[2] - _e6189[2]) * _e564))), array<f64, 3>((_e6211[0] + ((_e6217[0] - _e6211[0]) * _e564)), (_e6211[1] + ((_e6217[1] - _e6211[1]) * _e564)), (_e6211[2] + ((_e6217[2] - _e6211[2]) * _e564))), _e252.member);
                    let _e6242 = (((_e6231[0] * _e6231[0]) + (_e6231[1] * _e6231[1])) + (_e6231[2] * _e6231[2]));
                    if (_e6242 <= 2.2250738585072014e-308lf) {
                        if (_e6242 > 0.0lf) {
                            phi_1522_ = (1.464336215552873e-154lf * 2.0lf);
                        } else {
                            phi_1522_ = 0.0lf;
                        }
                        let _e6294 = phi_1522_;
                        phi_1586_ = _e6294;
                    } else {
                        phi_1529_ = type_18(0i, 5i);
                        phi_1532_ = bitcast<f64>(((bitcast<u64>(_e6242) / 2lu) + 2303426169912950784lu));
                        loop {
                            let _e6249 = phi_1529_;
                            let _e6251 = phi_1532_;
                            local_40 = _e6251;
                            if (_e6249.member < _e6249.member_1) {
                                let _e6258 = (_e6249.member + 1i);
                                if ((false == (_e6258 > _e6249.member)) != false) {
                                    phi_1553_ = true;
                                } else {
                                    phi_1553_ = false;
                                }
                                let _e6263 = phi_1553_;
                                if _e6263 {
                                    phi_1559_ = type_19(0u, type_19().member_1);
                                } else {
                                    phi_1559_ = type_19(1u, _e6258);
                                }
                                let _e6268 = phi_1559_;
                                phi_1530_ = type_18(_e6268.member_1, _e6249.member_1);
                                phi_1573_ = type_19(1u, _e6249.member);
                            } else {
                                phi_1530_ = _e6249;
                                phi_1573_ = type_19(0u, type_19().member_1);
                            }
                            let _e6274 = phi_1530_;
                            let _e6276 = phi_1573_;
                            let _e6279 = (bitcast<i32>(_e6276.member) != 0i);
                            if _e6279 {
                                phi_1533_ = (0.5lf * (_e6251 + (_e6242 / _e6251)));
                            } else {
                                phi_1533_ = f64();
                            }
                            let _e6284 = phi_1533_;
                            continue;
                            continuing {
                                phi_1529_ = _e6274;
                                phi_1532_ = _e6284;
                                break if !(_e6279);
                            }
                        }
                        let _e6289 = local_40;
                        phi_1586_ = (_e6289 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                    }
                    let _e6296 = phi_1586_;
                    let _e6304 = local_18.member[0u];
                    if (_e6304[0] < 0.0lf) {
                        phi_1604_ = -(_e6304[0]);
                    } else {
                        phi_1604_ = _e6304[0];
                    }
                    let _e6311 = phi_1604_;
                    if (_e6304[1] < 0.0lf) {
                        phi_1611_ = -(_e6304[1]);
                    } else {
                        phi_1611_ = _e6304[1];
                    }
                    let _e6315 = phi_1611_;
                    if (_e6311 > _e6315) {
                        phi_1616_ = _e6311;
                    } else {
                        phi_1616_ = _e6315;
                    }
                    let _e6318 = phi_1616_;
                    if (_e6304[2] < 0.0lf) {
                        phi_1623_ = -(_e6304[2]);
                    } else {
                        phi_1623_ = _e6304[2];
                    }
                    let _e6322 = phi_1623_;
                    if (_e6318 > _e6322) {
                        phi_1628_ = _e6318;
                    } else {
                        phi_1628_ = _e6322;
                    }
                    let _e6325 = phi_1628_;
                    let _e6328 = local_18.member[1u];
                    if (_e6328[0] < 0.0lf) {
                        phi_1641_ = -(_e6328[0]);
                    } else {
                        phi_1641_ = _e6328[0];
                    }
                    let _e6335 = phi_1641_;
                    if (_e6328[1] < 0.0lf) {
                        phi_1648_ = -(_e6328[1]);
                    } else {
                        phi_1648_ = _e6328[1];
                    }
                    let _e6339 = phi_1648_;
                    if (_e6335 > _e6339) {
                        phi_1653_ = _e6335;
                    } else {
                        phi_1653_ = _e6339;
                    }
                    let _e6342 = phi_1653_;
                    if (_e6328[2] < 0.0lf) {
                        phi_1660_ = -(_e6328[2]);
                    } else {
                        phi_1660_ = _e6328[2];
                    }
                    let _e6346 = phi_1660_;
                    if (_e6342 > _e6346) {
                        phi_1665_ = _e6342;
                    } else {
                        phi_1665_ = _e6346;
                    }
                    let _e6349 = phi_1665_;
                    if (_e6325 > _e6349) {
                        phi_1670_ = _e6325;
                    } else {
                        phi_1670_ = _e6349;
                    }
                    let _e6352 = phi_1670_;
                    let _e6354 = local_18.member_3;
                    let _e6358 = local_18.member_1[0u];
                    if (_e6358[0] < 0.0lf) {
                        phi_1687_ = -(_e6358[0]);
                    } else {
                        phi_1687_ = _e6358[0];
                    }
                    let _e6365 = phi_1687_;
                    if (_e6358[1] < 0.0lf) {
                        phi_1694_ = -(_e6358[1]);
                    } else {
                        phi_1694_ = _e6358[1];
                    }
                    let _e6369 = phi_1694_;
                    if (_e6365 > _e6369) {
                        phi_1699_ = _e6365;
                    } else {
                        phi_1699_ = _e6369;
                    }
                    let _e6372 = phi_1699_;
                    if (_e6358[2] < 0.0lf) {
                        phi_1706_ = -(_e6358[2]);
                    } else {
                        phi_1706_ = _e6358[2];
                    }
                    let _e6376 = phi_1706_;
                    if (_e6372 > _e6376) {
                        phi_1711_ = _e6372;
                    } else {
                        phi_1711_ = _e6376;
                    }
                    let _e6379 = phi_1711_;
                    let _e6382 = local_18.member_1[1u];
                    if (_e6382[0] < 0.0lf) {
                        phi_1725_ = -(_e6382[0]);
                    } else {
                        phi_1725_ = _e6382[0];
                    }
                    let _e6389 = phi_1725_;
                    if (_e6382[1] < 0.0lf) {
                        phi_1732_ = -(_e6382[1]);
                    } else {
                        phi_1732_ = _e6382[1];
                    }
                    let _e6393 = phi_1732_;
                    if (_e6389 > _e6393) {
                        phi_1737_ = _e6389;
                    } else {
                        phi_1737_ = _e6393;
                    }
                    let _e6396 = phi_1737_;
                    if (_e6382[2] < 0.0lf) {
                        phi_1744_ = -(_e6382[2]);
                    } else {
                        phi_1744_ = _e6382[2];
                    }
                    let _e6400 = phi_1744_;
                    if (_e6396 > _e6400) {
                        phi_1749_ = _e6396;
                    } else {
                        phi_1749_ = _e6400;
                    }
                    let _e6403 = phi_1749_;
                    if (_e6379 > _e6403) {
                        phi_1754_ = _e6379;
                    } else {
                        phi_1754_ = _e6403;
                    }
                    let _e6406 = phi_1754_;
                    let _e6408 = local_18.member_3;
                    let _e6412 = local_18.member_2[0u];
                    if (_e6412[0] < 0.0lf) {
                        phi_1771_ = -(_e6412[0]);
                    } else {
                        phi_1771_ = _e6412[0];
                    }
                    let _e6419 = phi_1771_;
                    if (_e6412[1] < 0.0lf) {
                        phi_1778_ = -(_e6412[1]);
                    } else {
                        phi_1778_ = _e6412[1];
                    }
                    let _e6423 = phi_1778_;
                    if (_e6419 > _e6423) {
                        phi_1783_ = _e6419;
                    } else {
                        phi_1783_ = _e6423;
                    }
                    let _e6426 = phi_1783_;
                    if (_e6412[2] < 0.0lf) {
                        phi_1790_ = -(_e6412[2]);
                    } else {
                        phi_1790_ = _e6412[2];
                    }
                    let _e6430 = phi_1790_;
                    if (_e6426 > _e6430) {
                        phi_1795_ = _e6426;
                    } else {
                        phi_1795_ = _e6430;
                    }
                    let _e6433 = phi_1795_;
                    let _e6436 = local_18.member_2[1u];
                    if (_e6436[0] < 0.0lf) {
                        phi_1809_ = -(_e6436[0]);
                    } else {
                        phi_1809_ = _e6436[0];
                    }
                    let _e6443 = phi_1809_;
                    if (_e6436[1] < 0.0lf) {
                        phi_1816_ = -(_e6436[1]);
                    } else {
                        phi_1816_ = _e6436[1];
                    }
                    let _e6447 = phi_1816_;
                    if (_e6443 > _e6447) {
                        phi_1821_ = _e6443;
                    } else {
                        phi_1821_ = _e6447;
                    }
                    let _e6450 = phi_1821_;
                    if (_e6436[2] < 0.0lf) {
                        phi_1828_ = -(_e6436[2]);
                    } else {
                        phi_1828_ = _e6436[2];
                    }
                    let _e6454 = phi_1828_;
                    if (_e6450 > _e6454) {
                        phi_1833_ = _e6450;
                    } else {
                        phi_1833_ = _e6454;
                    }
                    let _e6457 = phi_1833_;
                    if (_e6433 > _e6457) {
                        phi_1838_ = _e6433;
                    } else {
                        phi_1838_ = _e6457;
                    }
                    let _e6460 = phi_1838_;
                    let _e6462 = local_18.member_3;
                    let _e6470 = local_18.member_3;
                    let _e6480 = (((_e6296 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e6352 + _e6354) + (_e6406 + _e6408)) + (_e6460 + _e6462)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6470 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e841.member_1);
                    if _e6480 {
                        phi_2515_ = type_44();
                        phi_2516_ = true;
                    } else {
                        let _e6483 = local_18.member_1[0u];
                        let _e6489 = local_18.member_2[0u];
                        let _e6495 = ((_e6483[1] * _e6489[2]) - (_e6483[2] * _e6489[1]));
                        let _e6498 = ((_e6483[2] * _e6489[0]) - (_e6483[0] * _e6489[2]));
                        let _e6501 = ((_e6483[0] * _e6489[1]) - (_e6483[1] * _e6489[0]));
                        let _e6504 = local_18.member_1[1u];
                        let _e6510 = local_18.member_2[1u];
                        let _e6516 = ((_e6504[1] * _e6510[2]) - (_e6504[2] * _e6510[1]));
                        let _e6519 = ((_e6504[2] * _e6510[0]) - (_e6504[0] * _e6510[2]));
                        let _e6522 = ((_e6504[0] * _e6510[1]) - (_e6504[1] * _e6510[0]));
                        let _e6525 = local_18.member_1[0u];
                        let _e6531 = local_18.member_2[1u];
                        let _e6546 = local_18.member_1[1u];
                        let _e6552 = local_18.member_2[0u];
                        let _e6565 = (((_e6525[1] * _e6531[2]) - (_e6525[2] * _e6531[1])) + ((_e6546[1] * _e6552[2]) - (_e6546[2] * _e6552[1])));
                        let _e6566 = (((_e6525[2] * _e6531[0]) - (_e6525[0] * _e6531[2])) + ((_e6546[2] * _e6552[0]) - (_e6546[0] * _e6552[2])));
                        let _e6567 = (((_e6525[0] * _e6531[1]) - (_e6525[1] * _e6531[0])) + ((_e6546[0] * _e6552[1]) - (_e6546[1] * _e6552[0])));
                        let _e6570 = local_18.member[0u];
                        let _e6581 = local_18.member[1u];
                        let _e6592 = local_18.member[0u];
                        let _e6601 = ((((_e6581[0] * _e6495) + (_e6581[1] * _e6498)) + (_e6581[2] * _e6501)) + (((_e6592[0] * _e6565) + (_e6592[1] * _e6566)) + (_e6592[2] * _e6567)));
                        let _e6604 = local_18.member[0u];
                        let _e6615 = local_18.member[1u];
                        let _e6624 = ((((_e6604[0] * _e6516) + (_e6604[1] * _e6519)) + (_e6604[2] * _e6522)) + (((_e6615[0] * _e6565) + (_e6615[1] * _e6566)) + (_e6615[2] * _e6567)));
                        let _e6627 = local_18.member[1u];
                        let _e6638 = local_18.member[0u];
                        if (_e6638[0] < 0.0lf) {
                            phi_2103_ = -(_e6638[0]);
                        } else {
                            phi_2103_ = _e6638[0];
                        }
                        let _e6645 = phi_2103_;
                        if (_e6638[1] < 0.0lf) {
                            phi_2110_ = -(_e6638[1]);
                        } else {
                            phi_2110_ = _e6638[1];
                        }
                        let _e6649 = phi_2110_;
                        if (_e6645 > _e6649) {
                            phi_2115_ = _e6645;
                        } else {
                            phi_2115_ = _e6649;
                        }
                        let _e6652 = phi_2115_;
                        if (_e6638[2] < 0.0lf) {
                            phi_2122_ = -(_e6638[2]);
                        } else {
                            phi_2122_ = _e6638[2];
                        }
                        let _e6656 = phi_2122_;
                        if (_e6652 > _e6656) {
                            phi_2127_ = _e6652;
                        } else {
                            phi_2127_ = _e6656;
                        }
                        let _e6659 = phi_2127_;
                        let _e6662 = local_18.member[1u];
                        if (_e6662[0] < 0.0lf) {
                            phi_2140_ = -(_e6662[0]);
                        } else {
                            phi_2140_ = _e6662[0];
                        }
                        let _e6669 = phi_2140_;
                        if (_e6662[1] < 0.0lf) {
                            phi_2147_ = -(_e6662[1]);
                        } else {
                            phi_2147_ = _e6662[1];
                        }
                        let _e6673 = phi_2147_;
                        if (_e6669 > _e6673) {
                            phi_2152_ = _e6669;
                        } else {
                            phi_2152_ = _e6673;
                        }
                        let _e6676 = phi_2152_;
                        if (_e6662[2] < 0.0lf) {
                            phi_2159_ = -(_e6662[2]);
                        } else {
                            phi_2159_ = _e6662[2];
                        }
                        let _e6680 = phi_2159_;
                        if (_e6676 > _e6680) {
                            phi_2164_ = _e6676;
                        } else {
                            phi_2164_ = _e6680;
                        }
                        let _e6683 = phi_2164_;
                        if (_e6659 > _e6683) {
                            phi_2169_ = _e6659;
                        } else {
                            phi_2169_ = _e6683;
                        }
                        let _e6686 = phi_2169_;
                        let _e6688 = local_18.member_3;
                        let _e6689 = (_e6686 + _e6688);
                        let _e6692 = local_18.member_1[0u];
                        if (_e6692[0] < 0.0lf) {
                            phi_2186_ = -(_e6692[0]);
                        } else {
                            phi_2186_ = _e6692[0];
                        }
                        let _e6699 = phi_2186_;
                        if (_e6692[1] < 0.0lf) {
                            phi_2193_ = -(_e6692[1]);
                        } else {
                            phi_2193_ = _e6692[1];
                        }
                        let _e6703 = phi_2193_;
                        if (_e6699 > _e6703) {
                            phi_2198_ = _e6699;
                        } else {
                            phi_2198_ = _e6703;
                        }
                        let _e6706 = phi_2198_;
                        if (_e6692[2] < 0.0lf) {
                            phi_2205_ = -(_e6692[2]);
                        } else {
                            phi_2205_ = _e6692[2];
                        }
                        let _e6710 = phi_2205_;
                        if (_e6706 > _e6710) {
                            phi_2210_ = _e6706;
                        } else {
                            phi_2210_ = _e6710;
                        }
                        let _e6713 = phi_2210_;
                        let _e6716 = local_18.member_1[1u];
                        if (_e6716[0] < 0.0lf) {
                            phi_2224_ = -(_e6716[0]);
                        } else {
                            phi_2224_ = _e6716[0];
                        }
                        let _e6723 = phi_2224_;
                        if (_e6716[1] < 0.0lf) {
                            phi_2231_ = -(_e6716[1]);
                        } else {
                            phi_2231_ = _e6716[1];
                        }
                        let _e6727 = phi_2231_;
                        if (_e6723 > _e6727) {
                            phi_2236_ = _e6723;
                        } else {
                            phi_2236_ = _e6727;
                        }
                        let _e6730 = phi_2236_;
                        if (_e6716[2] < 0.0lf) {
                            phi_2243_ = -(_e6716[2]);
                        } else {
                            phi_2243_ = _e6716[2];
                        }
                        let _e6734 = phi_2243_;
                        if (_e6730 > _e6734) {
                            phi_2248_ = _e6730;
                        } else {
                            phi_2248_ = _e6734;
                        }
                        let _e6737 = phi_2248_;
                        if (_e6713 > _e6737) {
                            phi_2253_ = _e6713;
                        } else {
                            phi_2253_ = _e6737;
                        }
                        let _e6740 = phi_2253_;
                        let _e6742 = local_18.member_3;
                        let _e6743 = (_e6740 + _e6742);
                        let _e6746 = local_18.member_2[0u];
                        if (_e6746[0] < 0.0lf) {
                            phi_2270_ = -(_e6746[0]);
                        } else {
                            phi_2270_ = _e6746[0];
                        }
                        let _e6753 = phi_2270_;
                        if (_e6746[1] < 0.0lf) {
                            phi_2277_ = -(_e6746[1]);
                        } else {
                            phi_2277_ = _e6746[1];
                        }
                        let _e6757 = phi_2277_;
                        if (_e6753 > _e6757) {
                            phi_2282_ = _e6753;
                        } else {
                            phi_2282_ = _e6757;
                        }
                        let _e6760 = phi_2282_;
                        if (_e6746[2] < 0.0lf) {
                            phi_2289_ = -(_e6746[2]);
                        } else {
                            phi_2289_ = _e6746[2];
                        }
                        let _e6764 = phi_2289_;
                        if (_e6760 > _e6764) {
                            phi_2294_ = _e6760;
                        } else {
                            phi_2294_ = _e6764;
                        }
                        let _e6767 = phi_2294_;
                        let _e6770 = local_18.member_2[1u];
                        if (_e6770[0] < 0.0lf) {
                            phi_2308_ = -(_e6770[0]);
                        } else {
                            phi_2308_ = _e6770[0];
                        }
                        let _e6777 = phi_2308_;
                        if (_e6770[1] < 0.0lf) {
                            phi_2315_ = -(_e6770[1]);
                        } else {
                            phi_2315_ = _e6770[1];
                        }
                        let _e6781 = phi_2315_;
                        if (_e6777 > _e6781) {
                            phi_2320_ = _e6777;
                        } else {
                            phi_2320_ = _e6781;
                        }
                        let _e6784 = phi_2320_;
                        if (_e6770[2] < 0.0lf) {
                            phi_2327_ = -(_e6770[2]);
                        } else {
                            phi_2327_ = _e6770[2];
                        }
                        let _e6788 = phi_2327_;
                        if (_e6784 > _e6788) {
                            phi_2332_ = _e6784;
                        } else {
                            phi_2332_ = _e6788;
                        }
                        let _e6791 = phi_2332_;
                        if (_e6767 > _e6791) {
                            phi_2337_ = _e6767;
                        } else {
                            phi_2337_ = _e6791;
                        }
                        let _e6794 = phi_2337_;
                        let _e6796 = local_18.member_3;
                        let _e6797 = (_e6794 + _e6796);
                        let _e6798 = f64(1f);
                        let _e6799 = f64(8f);
                        let _e6801 = ((_e6743 * _e6799) * _e6797);
                        let _e6809 = local_18.member_3;
                        if (_e6495 < 0.0lf) {
                            phi_2374_ = -(_e6495);
                        } else {
                            phi_2374_ = _e6495;
                        }
                        let _e6829 = phi_2374_;
                        if (_e6498 < 0.0lf) {
                            phi_2380_ = -(_e6498);
                        } else {
                            phi_2380_ = _e6498;
                        }
                        let _e6833 = phi_2380_;
                        if (_e6501 < 0.0lf) {
                            phi_2387_ = -(_e6501);
                        } else {
                            phi_2387_ = _e6501;
                        }
                        let _e6838 = phi_2387_;
                        let _e6839 = ((_e6829 + _e6833) + _e6838);
                        if (_e6516 < 0.0lf) {
                            phi_2394_ = -(_e6516);
                        } else {
                            phi_2394_ = _e6516;
                        }
                        let _e6843 = phi_2394_;
                        if (_e6519 < 0.0lf) {
                            phi_2400_ = -(_e6519);
                        } else {
                            phi_2400_ = _e6519;
                        }
                        let _e6847 = phi_2400_;
                        if (_e6522 < 0.0lf) {
                            phi_2407_ = -(_e6522);
                        } else {
                            phi_2407_ = _e6522;
                        }
                        let _e6852 = phi_2407_;
                        let _e6853 = ((_e6843 + _e6847) + _e6852);
                        if (_e6839 > _e6853) {
                            phi_2413_ = _e6839;
                        } else {
                            phi_2413_ = _e6853;
                        }
                        let _e6856 = phi_2413_;
                        if (_e6565 < 0.0lf) {
                            phi_2419_ = -(_e6565);
                        } else {
                            phi_2419_ = _e6565;
                        }
                        let _e6860 = phi_2419_;
                        if (_e6566 < 0.0lf) {
                            phi_2425_ = -(_e6566);
                        } else {
                            phi_2425_ = _e6566;
                        }
                        let _e6864 = phi_2425_;
                        if (_e6567 < 0.0lf) {
                            phi_2432_ = -(_e6567);
                        } else {
                            phi_2432_ = _e6567;
                        }
                        let _e6869 = phi_2432_;
                        let _e6871 = (((_e6860 + _e6864) + _e6869) * f64(0.5f));
                        if (_e6856 > _e6871) {
                            phi_2439_ = _e6856;
                        } else {
                            phi_2439_ = _e6871;
                        }
                        let _e6874 = phi_2439_;
                        let _e6880 = local_18.member_3;
                        let _e6895 = f64(3f);
                        let _e6896 = ((((_e6570[0] * _e6495) + (_e6570[1] * _e6498)) + (_e6570[2] * _e6501)) * _e6895);
                        let _e6897 = ((((_e6627[0] * _e6516) + (_e6627[1] * _e6519)) + (_e6627[2] * _e6522)) * _e6895);
                        if (_e6896 < _e6897) {
                            phi_2467_ = _e6896;
                        } else {
                            phi_2467_ = _e6897;
                        }
                        let _e6900 = phi_2467_;
                        if (_e6601 < _e6624) {
                            phi_2472_ = _e6601;
                        } else {
                            phi_2472_ = _e6624;
                        }
                        let _e6903 = phi_2472_;
                        if (_e6900 < _e6903) {
                            phi_2477_ = _e6900;
                        } else {
                            phi_2477_ = _e6903;
                        }
                        let _e6906 = phi_2477_;
                        if (_e6896 > _e6897) {
                            phi_2482_ = _e6896;
                        } else {
                            phi_2482_ = _e6897;
                        }
                        let _e6909 = phi_2482_;
                        if (_e6601 > _e6624) {
                            phi_2487_ = _e6601;
                        } else {
                            phi_2487_ = _e6624;
                        }
                        let _e6912 = phi_2487_;
                        if (_e6909 > _e6912) {
                            phi_2492_ = _e6909;
                        } else {
                            phi_2492_ = _e6912;
                        }
                        let _e6915 = phi_2492_;
                        let _e6921 = -(_e6915);
                        if (_e6906 > _e6921) {
                            phi_2503_ = _e6906;
                        } else {
                            phi_2503_ = _e6921;
                        }
                        let _e6924 = phi_2503_;
                        if ((_e6924 - ((((((_e6689 * _e6799) * _e6801) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e6809 * f64(19f)) * ((_e6689 * (_e6743 + _e6797)) + (_e6743 * _e6797)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6798 + _e6689) * ((_e6798 + _e6743) * (_e6798 + _e6797))))) + ((_e841.member_1 * (((_e6874 + (_e6801 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e6880 * f64(6f)) * (_e6743 + _e6797))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6798 + _e6743) * (_e6798 + _e6797))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                            phi_2513_ = type_44(type_43(0u, f64()), 0u);
                            phi_2514_ = false;
                        } else {
                            phi_2513_ = type_44();
                            phi_2514_ = true;
                        }
                        let _e6931 = phi_2513_;
                        let _e6933 = phi_2514_;
                        phi_2515_ = _e6931;
                        phi_2516_ = _e6933;
                    }
                    let _e6935 = phi_2515_;
                    let _e6937 = phi_2516_;
                    if _e6937 {
                        phi_2522_ = type_18(0i, 2i);
                        phi_2525_ = _e564;
                        phi_2527_ = 0u;
                        phi_2529_ = _e564;
                        loop {
                            let _e6939 = phi_2522_;
                            let _e6941 = phi_2525_;
                            let _e6943 = phi_2527_;
                            let _e6945 = phi_2529_;
                            local_99 = _e6943;
                            local_102 = _e6941;
                            local_103 = _e6943;
                            if (_e6939.member < _e6939.member_1) {
                                let _e6952 = (_e6939.member + 1i);
                                if ((false == (_e6952 > _e6939.member)) != false) {
                                    phi_2550_ = true;
                                } else {
                                    phi_2550_ = false;
                                }
                                let _e6957 = phi_2550_;
                                if _e6957 {
                                    phi_2556_ = type_19(0u, type_19().member_1);
                                } else {
                                    phi_2556_ = type_19(1u, _e6952);
                                }
                                let _e6962 = phi_2556_;
                                phi_2523_ = type_18(_e6962.member_1, _e6939.member_1);
                                phi_2570_ = type_19(1u, _e6939.member);
                            } else {
                                phi_2523_ = _e6939;
                                phi_2570_ = type_19(0u, type_19().member_1);
                            }
                            let _e6968 = phi_2523_;
                            let _e6970 = phi_2570_;
                            if (bitcast<i32>(_e6970.member) != 0i) {
                                if (_e6970.member_1 > 0i) {
                                    phi_2586_ = true;
                                } else {
                                    if _e6480 {
                                        phi_2585_ = false;
                                    } else {
                                        phi_2585_ = true;
                                    }
                                    let _e6977 = phi_2585_;
                                    phi_2586_ = _e6977;
                                }
                                let _e6979 = phi_2586_;
                                if _e6979 {
                                    let _e6982 = local_18.member[0u];
                                    let _e6989 = local_18.member_1[0u];
                                    let _e6995 = local_18.member_2[0u];
                                    let _e6999 = (_e6982[0] - _e6989[0]);
                                    let _e7000 = (_e6982[1] - _e6989[1]);
                                    let _e7001 = (_e6982[2] - _e6989[2]);
                                    if (_e252.member == 0u) {
                                        phi_2645_ = array<f64, 3>(_e6982[0], _e6982[1], _e6982[2]);
                                    } else {
                                        phi_2645_ = array<f64, 3>((_e6999 - _e6995[0]), (_e7000 - _e6995[1]), (_e7001 - _e6995[2]));
                                    }
                                    let _e7008 = phi_2645_;
                                    let _e7014 = local_18.member[1u];
                                    let _e7021 = local_18.member_1[1u];
                                    let _e7027 = local_18.member_2[1u];
                                    let _e7031 = (_e7014[0] - _e7021[0]);
                                    let _e7032 = (_e7014[1] - _e7021[1]);
                                    let _e7033 = (_e7014[2] - _e7021[2]);
                                    if (_e252.member == 0u) {
                                        phi_2710_ = array<f64, 3>(_e7014[0], _e7014[1], _e7014[2]);
                                    } else {
                                        phi_2710_ = array<f64, 3>((_e7031 - _e7027[0]), (_e7032 - _e7027[1]), (_e7033 - _e7027[2]));
                                    }
                                    let _e7040 = phi_2710_;
                                    let _e7046 = local_18.member[0u];
                                    if (_e7046[0] < 0.0lf) {
                                        phi_2732_ = -(_e7046[0]);
                                    } else {
                                        phi_2732_ = _e7046[0];
                                    }
                                    let _e7053 = phi_2732_;
                                    if (_e7046[1] < 0.0lf) {
                                        phi_2739_ = -(_e7046[1]);
                                    } else {
                                        phi_2739_ = _e7046[1];
                                    }
                                    let _e7057 = phi_2739_;
                                    if (_e7053 > _e7057) {
                                        phi_2744_ = _e7053;
                                    } else {
                                        phi_2744_ = _e7057;
                                    }
                                    let _e7060 = phi_2744_;
                                    if (_e7046[2] < 0.0lf) {
                                        phi_2751_ = -(_e7046[2]);
                                    } else {
                                        phi_2751_ = _e7046[2];
                                    }
                                    let _e7064 = phi_2751_;
                                    if (_e7060 > _e7064) {
                                        phi_2756_ = _e7060;
                                    } else {
                                        phi_2756_ = _e7064;
                                    }
                                    let _e7067 = phi_2756_;
                                    let _e7070 = local_18.member[1u];
                                    if (_e7070[0] < 0.0lf) {
                                        phi_2769_ = -(_e7070[0]);
                                    } else {
                                        phi_2769_ = _e7070[0];
                                    }
                                    let _e7077 = phi_2769_;
                                    if (_e7070[1] < 0.0lf) {
                                        phi_2776_ = -(_e7070[1]);
                                    } else {
                                        phi_2776_ = _e7070[1];
                                    }
                                    let _e7081 = phi_2776_;
                                    if (_e7077 > _e7081) {
                                        phi_2781_ = _e7077;
                                    } else {
                                        phi_2781_ = _e7081;
                                    }
                                    let _e7084 = phi_2781_;
                                    if (_e7070[2] < 0.0lf) {
                                        phi_2788_ = -(_e7070[2]);
                                    } else {
                                        phi_2788_ = _e7070[2];
                                    }
                                    let _e7088 = phi_2788_;
                                    if (_e7084 > _e7088) {
                                        phi_2793_ = _e7084;
                                    } else {
                                        phi_2793_ = _e7088;
                                    }
                                    let _e7091 = phi_2793_;
                                    if (_e7067 > _e7091) {
                                        phi_2798_ = _e7067;
                                    } else {
                                        phi_2798_ = _e7091;
                                    }
                                    let _e7094 = phi_2798_;
                                    let _e7096 = local_18.member_3;
                                    let _e7100 = local_18.member_1[0u];
                                    if (_e7100[0] < 0.0lf) {
                                        phi_2815_ = -(_e7100[0]);
                                    } else {
                                        phi_2815_ = _e7100[0];
                                    }
                                    let _e7107 = phi_2815_;
                                    if (_e7100[1] < 0.0lf) {
                                        phi_2822_ = -(_e7100[1]);
                                    } else {
                                        phi_2822_ = _e7100[1];
                                    }
                                    let _e7111 = phi_2822_;
                                    if (_e7107 > _e7111) {
                                        phi_2827_ = _e7107;
                                    } else {
                                        phi_2827_ = _e7111;
                                    }
                                    let _e7114 = phi_2827_;
                                    if (_e7100[2] < 0.0lf) {
                                        phi_2834_ = -(_e7100[2]);
                                    } else {
                                        phi_2834_ = _e7100[2];
                                    }
                                    let _e7118 = phi_2834_;
                                    if (_e7114 > _e7118) {
                                        phi_2839_ = _e7114;
                                    } else {
                                        phi_2839_ = _e7118;
                                    }
                                    let _e7121 = phi_2839_;
                                    let _e7124 = local_18.member_1[1u];
                                    if (_e7124[0] < 0.0lf) {
                                        phi_2853_ = -(_e7124[0]);
                                    } else {
                                        phi_2853_ = _e7124[0];
                                    }
                                    let _e7131 = phi_2853_;
                                    if (_e7124[1] < 0.0lf) {
                                        phi_2860_ = -(_e7124[1]);
                                    } else {
                                        phi_2860_ = _e7124[1];
                                    }
                                    let _e7135 = phi_2860_;
                                    if (_e7131 > _e7135) {
                                        phi_2865_ = _e7131;
                                    } else {
                                        phi_2865_ = _e7135;
                                    }
                                    let _e7138 = phi_2865_;
                                    if (_e7124[2] < 0.0lf) {
                                        phi_2872_ = -(_e7124[2]);
                                    } else {
                                        phi_2872_ = _e7124[2];
                                    }
                                    let _e7142 = phi_2872_;
                                    if (_e7138 > _e7142) {
                                        phi_2877_ = _e7138;
                                    } else {
                                        phi_2877_ = _e7142;
                                    }
                                    let _e7145 = phi_2877_;
                                    if (_e7121 > _e7145) {
                                        phi_2882_ = _e7121;
                                    } else {
                                        phi_2882_ = _e7145;
                                    }
                                    let _e7148 = phi_2882_;
                                    let _e7150 = local_18.member_3;
                                    let _e7154 = local_18.member_2[0u];
                                    if (_e7154[0] < 0.0lf) {
                                        phi_2899_ = -(_e7154[0]);
                                    } else {
                                        phi_2899_ = _e7154[0];
                                    }
                                    let _e7161 = phi_2899_;
                                    if (_e7154[1] < 0.0lf) {
                                        phi_2906_ = -(_e7154[1]);
                                    } else {
                                        phi_2906_ = _e7154[1];
                                    }
                                    let _e7165 = phi_2906_;
                                    if (_e7161 > _e7165) {
                                        phi_2911_ = _e7161;
                                    } else {
                                        phi_2911_ = _e7165;
                                    }
                                    let _e7168 = phi_2911_;
                                    if (_e7154[2] < 0.0lf) {
                                        phi_2918_ = -(_e7154[2]);
                                    } else {
                                        phi_2918_ = _e7154[2];
                                    }
                                    let _e7172 = phi_2918_;
                                    if (_e7168 > _e7172) {
                                        phi_2923_ = _e7168;
                                    } else {
                                        phi_2923_ = _e7172;
                                    }
                                    let _e7175 = phi_2923_;
                                    let _e7178 = local_18.member_2[1u];
                                    if (_e7178[0] < 0.0lf) {
                                        phi_2937_ = -(_e7178[0]);
                                    } else {
                                        phi_2937_ = _e7178[0];
                                    }
                                    let _e7185 = phi_2937_;
                                    if (_e7178[1] < 0.0lf) {
                                        phi_2944_ = -(_e7178[1]);
                                    } else {
                                        phi_2944_ = _e7178[1];
                                    }
                                    let _e7189 = phi_2944_;
                                    if (_e7185 > _e7189) {
                                        phi_2949_ = _e7185;
                                    } else {
                                        phi_2949_ = _e7189;
                                    }
                                    let _e7192 = phi_2949_;
                                    if (_e7178[2] < 0.0lf) {
                                        phi_2956_ = -(_e7178[2]);
                                    } else {
                                        phi_2956_ = _e7178[2];
                                    }
                                    let _e7196 = phi_2956_;
                                    if (_e7192 > _e7196) {
                                        phi_2961_ = _e7192;
                                    } else {
                                        phi_2961_ = _e7196;
                                    }
                                    let _e7199 = phi_2961_;
                                    if (_e7175 > _e7199) {
                                        phi_2966_ = _e7175;
                                    } else {
                                        phi_2966_ = _e7199;
                                    }
                                    let _e7202 = phi_2966_;
                                    let _e7204 = local_18.member_3;
                                    let _e7212 = local_18.member_3;
                                    let _e7220 = (_e555 * f64(0.00390625f));
                                    let _e7221 = f64(0f);
                                    let _e7222 = f64(1f);
                                    local_16 = type_35(array<f64, 4>(_e7221, _e7221, _e7221, _e7221), array<f64, 4>(_e7221, _e7221, _e7221, _e7221), array<f64, 4>(_e7222, _e7222, _e7222, _e7222));
                                    phi_3013_ = type_9(0u, 96u);
                                    phi_3016_ = _e6945;
                                    phi_3018_ = _e6945;
                                    phi_3020_ = (_e573 - _e6945);
                                    phi_3022_ = _e6945;
                                    phi_3024_ = false;
                                    phi_3026_ = 0u;
                                    loop {
                                        let _e7229 = phi_3013_;
                                        let _e7231 = phi_3016_;
                                        let _e7233 = phi_3018_;
                                        let _e7235 = phi_3020_;
                                        let _e7237 = phi_3022_;
                                        let _e7239 = phi_3024_;
                                        let _e7241 = phi_3026_;
                                        local_44 = _e7231;
                                        local_89 = _e7233;
                                        if (_e7229.member < _e7229.member_1) {
                                            phi_3014_ = type_9((_e7229.member + 1u), _e7229.member_1);
                                            phi_3049_ = type_9(1u, _e7229.member);
                                        } else {
                                            phi_3014_ = _e7229;
                                            phi_3049_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e7253 = phi_3014_;
                                        let _e7255 = phi_3049_;
                                        if (bitcast<i32>(_e7255.member) != 0i) {
                                            let _e7261 = local_18.member[0u];
                                            let _e7267 = local_18.member[1u];
                                            let _e7283 = local_18.member_1[0u];
                                            let _e7289 = local_18.member_1[1u];
                                            let _e7305 = local_18.member_2[0u];
                                            let _e7311 = local_18.member_2[1u];
                                            let _e7325 = function_4(array<f64, 3>((_e7261[0] + ((_e7267[0] - _e7261[0]) * _e7231)), (_e7261[1] + ((_e7267[1] - _e7261[1]) * _e7231)), (_e7261[2] + ((_e7267[2] - _e7261[2]) * _e7231))), array<f64, 3>((_e7283[0] + ((_e7289[0] - _e7283[0]) * _e7231)), (_e7283[1] + ((_e7289[1] - _e7283[1]) * _e7231)), (_e7283[2] + ((_e7289[2] - _e7283[2]) * _e7231))), array<f64, 3>((_e7305[0] + ((_e7311[0] - _e7305[0]) * _e7231)), (_e7305[1] + ((_e7311[1] - _e7305[1]) * _e7231)), (_e7305[2] + ((_e7311[2] - _e7305[2]) * _e7231))), _e252.member);
                                            if (_e7241 == 0u) {
                                                phi_3178_ = _e7325;
                                            } else {
                                                let _e7327 = f64(0f);
                                                if (_e7241 == 1u) {
                                                    phi_3164_ = _e7325[0];
                                                } else {
                                                    phi_3164_ = _e7327;
                                                }
                                                let _e7331 = phi_3164_;
                                                if (_e7241 == 2u) {
                                                    phi_3170_ = _e7325[1];
                                                } else {
                                                    phi_3170_ = _e7327;
                                                }
                                                let _e7335 = phi_3170_;
                                                if (_e7241 == 3u) {
                                                    phi_3176_ = _e7325[2];
                                                } else {
                                                    phi_3176_ = _e7327;
                                                }
                                                let _e7339 = phi_3176_;
                                                phi_3178_ = array<f64, 3>(_e7331, _e7335, _e7339);
                                            }
                                            let _e7342 = phi_3178_;
                                            if (_e7342[0] < 0.0lf) {
                                                phi_3185_ = -(_e7342[0]);
                                            } else {
                                                phi_3185_ = _e7342[0];
                                            }
                                            let _e7347 = phi_3185_;
                                            if (_e7342[1] < 0.0lf) {
                                                phi_3192_ = -(_e7342[1]);
                                            } else {
                                                phi_3192_ = _e7342[1];
                                            }
                                            let _e7352 = phi_3192_;
                                            if (_e7342[2] < 0.0lf) {
                                                phi_3200_ = -(_e7342[2]);
                                            } else {
                                                phi_3200_ = _e7342[2];
                                            }
                                            let _e7358 = phi_3200_;
                                            let _e7359 = ((_e7347 + _e7352) + _e7358);
                                            if (_e7359 > f64(0f)) {
                                                if ((bitcast<u64>(_e7359) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                    let _e7366 = (f64(1f) / _e7359);
                                                    let _e7368 = (_e7342[0] * _e7366);
                                                    let _e7370 = (_e7342[1] * _e7366);
                                                    let _e7372 = (_e7342[2] * _e7366);
                                                    let _e7377 = (((_e7368 * _e7368) + (_e7370 * _e7370)) + (_e7372 * _e7372));
                                                    if (_e7377 <= 2.2250738585072014e-308lf) {
                                                        if (_e7377 > 0.0lf) {
                                                            phi_3239_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_3239_ = 0.0lf;
                                                        }
                                                        let _e7429 = phi_3239_;
                                                        phi_3303_ = _e7429;
                                                    } else {
                                                        phi_3246_ = type_18(0i, 5i);
                                                        phi_3249_ = bitcast<f64>(((bitcast<u64>(_e7377) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e7384 = phi_3246_;
                                                            let _e7386 = phi_3249_;
                                                            local_41 = _e7386;
                                                            if (_e7384.member < _e7384.member_1) {
                                                                let _e7393 = (_e7384.member + 1i);
                                                                if ((false == (_e7393 > _e7384.member)) != false) {
                                                                    phi_3270_ = true;
                                                                } else {
                                                                    phi_3270_ = false;
                                                                }
                                                                let _e7398 = phi_3270_;
                                                                if _e7398 {
                                                                    phi_3276_ = type_19(0u, type_19().member_1);
                                                                } else {
                                                                    phi_3276_ = type_19(1u, _e7393);
                                                                }
                                                                let _e7403 = phi_3276_;
                                                                phi_3247_ = type_18(_e7403.member_1, _e7384.member_1);
                                                                phi_3290_ = type_19(1u, _e7384.member);
                                                            } else {
                                                                phi_3247_ = _e7384;
                                                                phi_3290_ = type_19(0u, type_19().member_1);
                                                            }
                                                            let _e7409 = phi_3247_;
                                                            let _e7411 = phi_3290_;
                                                            let _e7414 = (bitcast<i32>(_e7411.member) != 0i);
                                                            if _e7414 {
                                                                phi_3250_ = (0.5lf * (_e7386 + (_e7377 / _e7386)));
                                                            } else {
                                                                phi_3250_ = f64();
                                                            }
                                                            let _e7419 = phi_3250_;
                                                            continue;
                                                            continuing {
                                                                phi_3246_ = _e7409;
                                                                phi_3249_ = _e7419;
                                                                break if !(_e7414);
                                                            }
                                                        }
                                                        let _e7424 = local_41;
                                                        phi_3303_ = (_e7424 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e7431 = phi_3303_;
                                                    let _e7433 = (1.1102230246251565e-16lf * f64(12f));
                                                    let _e7440 = ((((((((_e7094 + _e7096) + (_e7148 + _e7150)) + (_e7202 + _e7204)) * (1.1102230246251565e-16lf * f64(16f))) + (_e7212 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e841.member_1 * _e7431) * (f64(1f) + _e7433)));
                                                    let _e7445 = (((_e7368 * _e6982[0]) + (_e7370 * _e6982[1])) + (_e7372 * _e6982[2]));
                                                    let _e7450 = (((_e7368 * _e6999) + (_e7370 * _e7000)) + (_e7372 * _e7001));
                                                    let _e7455 = (((_e7368 * (_e6982[0] - _e6995[0])) + (_e7370 * (_e6982[1] - _e6995[1]))) + (_e7372 * (_e6982[2] - _e6995[2])));
                                                    let _e7463 = (((_e7368 * _e7008[0]) + (_e7370 * _e7008[1])) + (_e7372 * _e7008[2]));
                                                    let _e7469 = (((_e7368 * _e7014[0]) + (_e7370 * _e7014[1])) + (_e7372 * _e7014[2]));
                                                    let _e7474 = (((_e7368 * _e7031) + (_e7370 * _e7032)) + (_e7372 * _e7033));
                                                    let _e7479 = (((_e7368 * (_e7014[0] - _e7027[0])) + (_e7370 * (_e7014[1] - _e7027[1]))) + (_e7372 * (_e7014[2] - _e7027[2])));
                                                    let _e7487 = (((_e7368 * _e7040[0]) + (_e7370 * _e7040[1])) + (_e7372 * _e7040[2]));
                                                    if (_e7445 < 0.0lf) {
                                                        phi_3372_ = -(_e7445);
                                                    } else {
                                                        phi_3372_ = _e7445;
                                                    }
                                                    let _e7492 = phi_3372_;
                                                    if (_e7469 < 0.0lf) {
                                                        phi_3378_ = -(_e7469);
                                                    } else {
                                                        phi_3378_ = _e7469;
                                                    }
                                                    let _e7496 = phi_3378_;
                                                    if (_e7450 < 0.0lf) {
                                                        phi_3387_ = -(_e7450);
                                                    } else {
                                                        phi_3387_ = _e7450;
                                                    }
                                                    let _e7503 = phi_3387_;
                                                    if (_e7474 < 0.0lf) {
                                                        phi_3393_ = -(_e7474);
                                                    } else {
                                                        phi_3393_ = _e7474;
                                                    }
                                                    let _e7507 = phi_3393_;
                                                    if (_e7455 < 0.0lf) {
                                                        phi_3402_ = -(_e7455);
                                                    } else {
                                                        phi_3402_ = _e7455;
                                                    }
                                                    let _e7514 = phi_3402_;
                                                    if (_e7479 < 0.0lf) {
                                                        phi_3408_ = -(_e7479);
                                                    } else {
                                                        phi_3408_ = _e7479;
                                                    }
                                                    let _e7518 = phi_3408_;
                                                    if (_e7463 < 0.0lf) {
                                                        phi_3417_ = -(_e7463);
                                                    } else {
                                                        phi_3417_ = _e7463;
                                                    }
                                                    let _e7525 = phi_3417_;
                                                    if (_e7487 < 0.0lf) {
                                                        phi_3423_ = -(_e7487);
                                                    } else {
                                                        phi_3423_ = _e7487;
                                                    }
                                                    let _e7529 = phi_3423_;
                                                    phi_3429_ = type_35(array<f64, 4>(_e7445, _e7450, _e7455, _e7463), array<f64, 4>(_e7469, _e7474, _e7479, _e7487), array<f64, 4>((_e7440 + ((_e7492 + _e7496) * _e7433)), (_e7440 + ((_e7503 + _e7507) * _e7433)), (_e7440 + ((_e7514 + _e7518) * _e7433)), (_e7440 + ((_e7525 + _e7529) * _e7433))));
                                                    phi_3430_ = false;
                                                } else {
                                                    phi_3429_ = type_35();
                                                    phi_3430_ = true;
                                                }
                                                let _e7536 = phi_3429_;
                                                let _e7538 = phi_3430_;
                                                phi_3431_ = _e7536;
                                                phi_3432_ = _e7538;
                                            } else {
                                                phi_3431_ = type_35();
                                                phi_3432_ = true;
                                            }
                                            let _e7540 = phi_3431_;
                                            let _e7542 = phi_3432_;
                                            if _e7542 {
                                                let _e7543 = f64(0f);
                                                let _e7544 = f64(1f);
                                                phi_3442_ = type_35(array<f64, 4>(_e7543, _e7543, _e7543, _e7543), array<f64, 4>(_e7543, _e7543, _e7543, _e7543), array<f64, 4>(_e7544, _e7544, _e7544, _e7544));
                                            } else {
                                                phi_3442_ = _e7540;
                                            }
                                            let _e7550 = phi_3442_;
                                            local_17 = type_35(array<f64, 4>(_e7550.member[0], _e7550.member[1], _e7550.member[2], _e7550.member[3]), array<f64, 4>(_e7550.member_1[0], _e7550.member_1[1], _e7550.member_1[2], _e7550.member_1[3]), array<f64, 4>(_e7550.member_2[0], _e7550.member_2[1], _e7550.member_2[2], _e7550.member_2[3]));
                                            let _e7570 = (_e7231 - _e7237);
                                            let _e7572 = f64(0f);
                                            let _e7575 = local_17.member[0u];
                                            let _e7578 = local_17.member_1[0u];
                                            let _e7581 = local_17.member[0u];
                                            let _e7587 = local_17.member_2[0u];
                                            if (((_e7575 + ((_e7578 - _e7581) * _e7231)) - _e7587) > _e7572) {
                                                let _e7592 = local_17.member[1u];
                                                let _e7595 = local_17.member_1[1u];
                                                let _e7598 = local_17.member[1u];
                                                let _e7604 = local_17.member_2[1u];
                                                if (((_e7592 + ((_e7595 - _e7598) * _e7231)) - _e7604) > _e7572) {
                                                    let _e7609 = local_17.member[2u];
                                                    let _e7612 = local_17.member_1[2u];
                                                    let _e7615 = local_17.member[2u];
                                                    let _e7621 = local_17.member_2[2u];
                                                    if (((_e7609 + ((_e7612 - _e7615) * _e7231)) - _e7621) > _e7572) {
                                                        let _e7626 = local_17.member[3u];
                                                        let _e7629 = local_17.member_1[3u];
                                                        let _e7632 = local_17.member[3u];
                                                        let _e7638 = local_17.member_2[3u];
                                                        phi_3614_ = (((_e7626 + ((_e7629 - _e7632) * _e7231)) - _e7638) > _e7572);
                                                        phi_3615_ = false;
                                                    } else {
                                                        phi_3614_ = bool();
                                                        phi_3615_ = true;
                                                    }
                                                    let _e7642 = phi_3614_;
                                                    let _e7644 = phi_3615_;
                                                    phi_3616_ = _e7642;
                                                    phi_3617_ = _e7644;
                                                } else {
                                                    phi_3616_ = bool();
                                                    phi_3617_ = true;
                                                }
                                                let _e7646 = phi_3616_;
                                                let _e7648 = phi_3617_;
                                                phi_3618_ = _e7646;
                                                phi_3619_ = _e7648;
                                            } else {
                                                phi_3618_ = bool();
                                                phi_3619_ = true;
                                            }
                                            let _e7650 = phi_3618_;
                                            let _e7652 = phi_3619_;
                                            if _e7652 {
                                                phi_3623_ = false;
                                            } else {
                                                phi_3623_ = _e7650;
                                            }
                                            let _e7654 = phi_3623_;
                                            if _e7654 {
                                                if (_e7231 <= _e7233) {
                                                    phi_3934_ = true;
                                                } else {
                                                    let _e7656 = f64(0f);
                                                    let _e7659 = local_16.member[0u];
                                                    let _e7662 = local_16.member_1[0u];
                                                    let _e7665 = local_16.member[0u];
                                                    let _e7671 = local_16.member_2[0u];
                                                    let _e7675 = local_17.member[0u];
                                                    let _e7678 = local_17.member_1[0u];
                                                    let _e7681 = local_17.member[0u];
                                                    let _e7687 = local_17.member_2[0u];
                                                    if ((((_e7659 + ((_e7662 - _e7665) * _e7231)) - _e7671) + ((_e7675 + ((_e7678 - _e7681) * _e7237)) - _e7687)) > _e7656) {
                                                        let _e7693 = local_16.member[1u];
                                                        let _e7696 = local_16.member_1[1u];
                                                        let _e7699 = local_16.member[1u];
                                                        let _e7705 = local_16.member_2[1u];
                                                        let _e7709 = local_17.member[1u];
                                                        let _e7712 = local_17.member_1[1u];
                                                        let _e7715 = local_17.member[1u];
                                                        let _e7721 = local_17.member_2[1u];
                                                        if ((((_e7693 + ((_e7696 - _e7699) * _e7231)) - _e7705) + ((_e7709 + ((_e7712 - _e7715) * _e7237)) - _e7721)) > _e7656) {
                                                            let _e7727 = local_16.member[2u];
                                                            let _e7730 = local_16.member_1[2u];
                                                            let _e7733 = local_16.member[2u];
                                                            let _e7739 = local_16.member_2[2u];
                                                            let _e7743 = local_17.member[2u];
                                                            let _e7746 = local_17.member_1[2u];
                                                            let _e7749 = local_17.member[2u];
                                                            let _e7755 = local_17.member_2[2u];
                                                            if ((((_e7727 + ((_e7730 - _e7733) * _e7231)) - _e7739) + ((_e7743 + ((_e7746 - _e7749) * _e7237)) - _e7755)) > _e7656) {
                                                                let _e7761 = local_16.member[3u];
                                                                let _e7764 = local_16.member_1[3u];
                                                                let _e7767 = local_16.member[3u];
                                                                let _e7773 = local_16.member_2[3u];
                                                                let _e7777 = local_17.member[3u];
                                                                let _e7780 = local_17.member_1[3u];
                                                                let _e7783 = local_17.member[3u];
                                                                let _e7789 = local_17.member_2[3u];
                                                                phi_3921_ = ((((_e7761 + ((_e7764 - _e7767) * _e7231)) - _e7773) + ((_e7777 + ((_e7780 - _e7783) * _e7237)) - _e7789)) > _e7656);
                                                                phi_3922_ = false;
                                                            } else {
                                                                phi_3921_ = bool();
                                                                phi_3922_ = true;
                                                            }
                                                            let _e7794 = phi_3921_;
                                                            let _e7796 = phi_3922_;
                                                            phi_3923_ = _e7794;
                                                            phi_3924_ = _e7796;
                                                        } else {
                                                            phi_3923_ = bool();
                                                            phi_3924_ = true;
                                                        }
                                                        let _e7798 = phi_3923_;
                                                        let _e7800 = phi_3924_;
                                                        phi_3925_ = _e7798;
                                                        phi_3926_ = _e7800;
                                                    } else {
                                                        phi_3925_ = bool();
                                                        phi_3926_ = true;
                                                    }
                                                    let _e7802 = phi_3925_;
                                                    let _e7804 = phi_3926_;
                                                    if _e7804 {
                                                        phi_3930_ = false;
                                                    } else {
                                                        phi_3930_ = _e7802;
                                                    }
                                                    let _e7806 = phi_3930_;
                                                    phi_3934_ = _e7806;
                                                }
                                                let _e7808 = phi_3934_;
                                                if _e7808 {
                                                    if _e7239 {
                                                        if (_e7231 >= _e573) {
                                                            phi_3945_ = false;
                                                        } else {
                                                            phi_3945_ = true;
                                                        }
                                                        let _e7811 = phi_3945_;
                                                        phi_3946_ = _e7811;
                                                    } else {
                                                        phi_3946_ = true;
                                                    }
                                                    let _e7813 = phi_3946_;
                                                    if _e7813 {
                                                        local_16 = type_35(array<f64, 4>(_e7550.member[0], _e7550.member[1], _e7550.member[2], _e7550.member[3]), array<f64, 4>(_e7550.member_1[0], _e7550.member_1[1], _e7550.member_1[2], _e7550.member_1[3]), array<f64, 4>(_e7550.member_2[0], _e7550.member_2[1], _e7550.member_2[2], _e7550.member_2[3]));
                                                        let _e7835 = local_16.member[0u];
                                                        let _e7838 = local_16.member_1[0u];
                                                        let _e7841 = local_16.member_2[0u];
                                                        if (_e7835 > _e7841) {
                                                            if (_e7838 > _e7841) {
                                                                phi_4020_ = false;
                                                            } else {
                                                                phi_4020_ = true;
                                                            }
                                                            let _e7845 = phi_4020_;
                                                            phi_4021_ = _e7845;
                                                        } else {
                                                            phi_4021_ = true;
                                                        }
                                                        let _e7847 = phi_4021_;
                                                        if _e7847 {
                                                            let _e7848 = (_e7838 >= _e7835);
                                                            if _e7848 {
                                                                phi_4046_ = f64();
                                                                phi_4047_ = false;
                                                            } else {
                                                                if ((_e7835 - _e7838) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4044_ = (((_e7835 - _e7841) / (_e7835 - _e7838)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4045_ = false;
                                                                } else {
                                                                    phi_4044_ = f64();
                                                                    phi_4045_ = true;
                                                                }
                                                                let _e7862 = phi_4044_;
                                                                let _e7864 = phi_4045_;
                                                                phi_4046_ = _e7862;
                                                                phi_4047_ = _e7864;
                                                            }
                                                            let _e7866 = phi_4046_;
                                                            let _e7868 = phi_4047_;
                                                            phi_4048_ = _e7866;
                                                            phi_4049_ = _e7848;
                                                            phi_4050_ = _e7868;
                                                        } else {
                                                            phi_4048_ = f64();
                                                            phi_4049_ = true;
                                                            phi_4050_ = false;
                                                        }
                                                        let _e7870 = phi_4048_;
                                                        let _e7872 = phi_4049_;
                                                        let _e7874 = phi_4050_;
                                                        if _e7872 {
                                                            phi_4055_ = f64(2f);
                                                            phi_4056_ = true;
                                                        } else {
                                                            phi_4055_ = _e7231;
                                                            phi_4056_ = _e7874;
                                                        }
                                                        let _e7877 = phi_4055_;
                                                        let _e7879 = phi_4056_;
                                                        if _e7879 {
                                                            phi_4060_ = _e7877;
                                                        } else {
                                                            phi_4060_ = _e7870;
                                                        }
                                                        let _e7881 = phi_4060_;
                                                        let _e7884 = local_16.member[1u];
                                                        let _e7887 = local_16.member_1[1u];
                                                        let _e7890 = local_16.member_2[1u];
                                                        if (_e7884 > _e7890) {
                                                            if (_e7887 > _e7890) {
                                                                phi_4092_ = false;
                                                            } else {
                                                                phi_4092_ = true;
                                                            }
                                                            let _e7894 = phi_4092_;
                                                            phi_4093_ = _e7894;
                                                        } else {
                                                            phi_4093_ = true;
                                                        }
                                                        let _e7896 = phi_4093_;
                                                        if _e7896 {
                                                            let _e7897 = (_e7887 >= _e7884);
                                                            if _e7897 {
                                                                phi_4118_ = f64();
                                                                phi_4119_ = false;
                                                            } else {
                                                                if ((_e7884 - _e7887) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4116_ = (((_e7884 - _e7890) / (_e7884 - _e7887)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4117_ = false;
                                                                } else {
                                                                    phi_4116_ = f64();
                                                                    phi_4117_ = true;
                                                                }
                                                                let _e7911 = phi_4116_;
                                                                let _e7913 = phi_4117_;
                                                                phi_4118_ = _e7911;
                                                                phi_4119_ = _e7913;
                                                            }
                                                            let _e7915 = phi_4118_;
                                                            let _e7917 = phi_4119_;
                                                            phi_4120_ = _e7915;
                                                            phi_4121_ = _e7897;
                                                            phi_4122_ = _e7917;
                                                        } else {
                                                            phi_4120_ = f64();
                                                            phi_4121_ = true;
                                                            phi_4122_ = false;
                                                        }
                                                        let _e7919 = phi_4120_;
                                                        let _e7921 = phi_4121_;
                                                        let _e7923 = phi_4122_;
                                                        if _e7921 {
                                                            phi_4127_ = f64(2f);
                                                            phi_4128_ = true;
                                                        } else {
                                                            phi_4127_ = _e7231;
                                                            phi_4128_ = _e7923;
                                                        }
                                                        let _e7926 = phi_4127_;
                                                        let _e7928 = phi_4128_;
                                                        if _e7928 {
                                                            phi_4132_ = _e7926;
                                                        } else {
                                                            phi_4132_ = _e7919;
                                                        }
                                                        let _e7930 = phi_4132_;
                                                        if (_e7881 < _e7930) {
                                                            phi_4137_ = _e7881;
                                                        } else {
                                                            phi_4137_ = _e7930;
                                                        }
                                                        let _e7933 = phi_4137_;
                                                        let _e7936 = local_16.member[2u];
                                                        let _e7939 = local_16.member_1[2u];
                                                        let _e7942 = local_16.member_2[2u];
                                                        if (_e7936 > _e7942) {
                                                            if (_e7939 > _e7942) {
                                                                phi_4169_ = false;
                                                            } else {
                                                                phi_4169_ = true;
                                                            }
                                                            let _e7946 = phi_4169_;
                                                            phi_4170_ = _e7946;
                                                        } else {
                                                            phi_4170_ = true;
                                                        }
                                                        let _e7948 = phi_4170_;
                                                        if _e7948 {
                                                            let _e7949 = (_e7939 >= _e7936);
                                                            if _e7949 {
                                                                phi_4195_ = f64();
                                                                phi_4196_ = false;
                                                            } else {
                                                                if ((_e7936 - _e7939) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4193_ = (((_e7936 - _e7942) / (_e7936 - _e7939)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4194_ = false;
                                                                } else {
                                                                    phi_4193_ = f64();
                                                                    phi_4194_ = true;
                                                                }
                                                                let _e7963 = phi_4193_;
                                                                let _e7965 = phi_4194_;
                                                                phi_4195_ = _e7963;
                                                                phi_4196_ = _e7965;
                                                            }
                                                            let _e7967 = phi_4195_;
                                                            let _e7969 = phi_4196_;
                                                            phi_4197_ = _e7967;
                                                            phi_4198_ = _e7949;
                                                            phi_4199_ = _e7969;
                                                        } else {
                                                            phi_4197_ = f64();
                                                            phi_4198_ = true;
                                                            phi_4199_ = false;
                                                        }
                                                        let _e7971 = phi_4197_;
                                                        let _e7973 = phi_4198_;
                                                        let _e7975 = phi_4199_;
                                                        if _e7973 {
                                                            phi_4204_ = f64(2f);
                                                            phi_4205_ = true;
                                                        } else {
                                                            phi_4204_ = _e7231;
                                                            phi_4205_ = _e7975;
                                                        }
                                                        let _e7978 = phi_4204_;
                                                        let _e7980 = phi_4205_;
                                                        if _e7980 {
                                                            phi_4209_ = _e7978;
                                                        } else {
                                                            phi_4209_ = _e7971;
                                                        }
                                                        let _e7982 = phi_4209_;
                                                        let _e7985 = local_16.member[3u];
                                                        let _e7988 = local_16.member_1[3u];
                                                        let _e7991 = local_16.member_2[3u];
                                                        if (_e7985 > _e7991) {
                                                            if (_e7988 > _e7991) {
                                                                phi_4241_ = false;
                                                            } else {
                                                                phi_4241_ = true;
                                                            }
                                                            let _e7995 = phi_4241_;
                                                            phi_4242_ = _e7995;
                                                        } else {
                                                            phi_4242_ = true;
                                                        }
                                                        let _e7997 = phi_4242_;
                                                        if _e7997 {
                                                            let _e7998 = (_e7988 >= _e7985);
                                                            if _e7998 {
                                                                phi_4267_ = f64();
                                                                phi_4268_ = false;
                                                            } else {
                                                                if ((_e7985 - _e7988) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4265_ = (((_e7985 - _e7991) / (_e7985 - _e7988)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4266_ = false;
                                                                } else {
                                                                    phi_4265_ = f64();
                                                                    phi_4266_ = true;
                                                                }
                                                                let _e8012 = phi_4265_;
                                                                let _e8014 = phi_4266_;
                                                                phi_4267_ = _e8012;
                                                                phi_4268_ = _e8014;
                                                            }
                                                            let _e8016 = phi_4267_;
                                                            let _e8018 = phi_4268_;
                                                            phi_4269_ = _e8016;
                                                            phi_4270_ = _e7998;
                                                            phi_4271_ = _e8018;
                                                        } else {
                                                            phi_4269_ = f64();
                                                            phi_4270_ = true;
                                                            phi_4271_ = false;
                                                        }
                                                        let _e8020 = phi_4269_;
                                                        let _e8022 = phi_4270_;
                                                        let _e8024 = phi_4271_;
                                                        if _e8022 {
                                                            phi_4276_ = f64(2f);
                                                            phi_4277_ = true;
                                                        } else {
                                                            phi_4276_ = _e7231;
                                                            phi_4277_ = _e8024;
                                                        }
                                                        let _e8027 = phi_4276_;
                                                        let _e8029 = phi_4277_;
                                                        if _e8029 {
                                                            phi_4281_ = _e8027;
                                                        } else {
                                                            phi_4281_ = _e8020;
                                                        }
                                                        let _e8031 = phi_4281_;
                                                        if (_e7982 < _e8031) {
                                                            phi_4286_ = _e7982;
                                                        } else {
                                                            phi_4286_ = _e8031;
                                                        }
                                                        let _e8034 = phi_4286_;
                                                        if (_e7933 < _e8034) {
                                                            phi_4291_ = _e7933;
                                                        } else {
                                                            phi_4291_ = _e8034;
                                                        }
                                                        let _e8037 = phi_4291_;
                                                        if (_e8037 > _e7231) {
                                                            phi_4296_ = _e8037;
                                                        } else {
                                                            phi_4296_ = _e7231;
                                                        }
                                                        let _e8040 = phi_4296_;
                                                        let _e8041 = (_e8040 > _e573);
                                                        if _e8041 {
                                                            phi_4813_ = f64();
                                                            phi_4814_ = f64();
                                                            phi_4815_ = false;
                                                            phi_4816_ = false;
                                                        } else {
                                                            let _e8042 = (_e8040 - _e7231);
                                                            let _e8043 = (_e8042 <= _e7220);
                                                            let _e8046 = (_e8040 + (_e555 * f64(0.01f)));
                                                            if (_e8046 < _e573) {
                                                                phi_4310_ = _e8046;
                                                            } else {
                                                                phi_4310_ = _e573;
                                                            }
                                                            let _e8049 = phi_4310_;
                                                            if _e8043 {
                                                                if (_e841.member_1 > f64(0f)) {
                                                                    let _e8054 = local_18.member[0u];
                                                                    let _e8060 = local_18.member[1u];
                                                                    let _e8076 = local_18.member_1[0u];
                                                                    let _e8082 = local_18.member_1[1u];
                                                                    let _e8098 = local_18.member_2[0u];
                                                                    let _e8104 = local_18.member_2[1u];
                                                                    let _e8118 = function_4(array<f64, 3>((_e8054[0] + ((_e8060[0] - _e8054[0]) * _e8049)), (_e8054[1] + ((_e8060[1] - _e8054[1]) * _e8049)), (_e8054[2] + ((_e8060[2] - _e8054[2]) * _e8049))), array<f64, 3>((_e8076[0] + ((_e8082[0] - _e8076[0]) * _e8049)), (_e8076[1] + ((_e8082[1] - _e8076[1]) * _e8049)), (_e8076[2] + ((_e8082[2] - _e8076[2]) * _e8049))), array<f64, 3>((_e8098[0] + ((_e8104[0] - _e8098[0]) * _e8049)), (_e8098[1] + ((_e8104[1] - _e8098[1]) * _e8049)), (_e8098[2] + ((_e8104[2] - _e8098[2]) * _e8049))), _e252.member);
                                                                    let _e8129 = (((_e8118[0] * _e8118[0]) + (_e8118[1] * _e8118[1])) + (_e8118[2] * _e8118[2]));
                                                                    if (_e8129 <= 2.2250738585072014e-308lf) {
                                                                        if (_e8129 > 0.0lf) {
                                                                            phi_4441_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_4441_ = 0.0lf;
                                                                        }
                                                                        let _e8181 = phi_4441_;
                                                                        phi_4505_ = _e8181;
                                                                    } else {
                                                                        phi_4448_ = type_18(0i, 5i);
                                                                        phi_4451_ = bitcast<f64>(((bitcast<u64>(_e8129) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e8136 = phi_4448_;
                                                                            let _e8138 = phi_4451_;
                                                                            local_42 = _e8138;
                                                                            if (_e8136.member < _e8136.member_1) {
                                                                                let _e8145 = (_e8136.member + 1i);
                                                                                if ((false == (_e8145 > _e8136.member)) != false) {
                                                                                    phi_4472_ = true;
                                                                                } else {
                                                                                    phi_4472_ = false;
                                                                                }
                                                                                let _e8150 = phi_4472_;
                                                                                if _e8150 {
                                                                                    phi_4478_ = type_19(0u, type_19().member_1);
                                                                                } else {
                                                                                    phi_4478_ = type_19(1u, _e8145);
                                                                                }
                                                                                let _e8155 = phi_4478_;
                                                                                phi_4449_ = type_18(_e8155.member_1, _e8136.member_1);
                                                                                phi_4492_ = type_19(1u, _e8136.member);
                                                                            } else {
                                                                                phi_4449_ = _e8136;
                                                                                phi_4492_ = type_19(0u, type_19().member_1);
                                                                            }
                                                                            let _e8161 = phi_4449_;
                                                                            let _e8163 = phi_4492_;
                                                                            let _e8166 = (bitcast<i32>(_e8163.member) != 0i);
                                                                            if _e8166 {
                                                                                phi_4452_ = (0.5lf * (_e8138 + (_e8129 / _e8138)));
                                                                            } else {
                                                                                phi_4452_ = f64();
                                                                            }
                                                                            let _e8171 = phi_4452_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4448_ = _e8161;
                                                                                phi_4451_ = _e8171;
                                                                                break if !(_e8166);
                                                                            }
                                                                        }
                                                                        let _e8176 = local_42;
                                                                        phi_4505_ = (_e8176 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e8183 = phi_4505_;
                                                                    let _e8191 = local_18.member[0u];
                                                                    if (_e8191[0] < 0.0lf) {
                                                                        phi_4523_ = -(_e8191[0]);
                                                                    } else {
                                                                        phi_4523_ = _e8191[0];
                                                                    }
                                                                    let _e8198 = phi_4523_;
                                                                    if (_e8191[1] < 0.0lf) {
                                                                        phi_4530_ = -(_e8191[1]);
                                                                    } else {
                                                                        phi_4530_ = _e8191[1];
                                                                    }
                                                                    let _e8202 = phi_4530_;
                                                                    if (_e8198 > _e8202) {
                                                                        phi_4535_ = _e8198;
                                                                    } else {
                                                                        phi_4535_ = _e8202;
                                                                    }
                                                                    let _e8205 = phi_4535_;
                                                                    if (_e8191[2] < 0.0lf) {
                                                                        phi_4542_ = -(_e8191[2]);
                                                                    } else {
                                                                        phi_4542_ = _e8191[2];
                                                                    }
                                                                    let _e8209 = phi_4542_;
                                                                    if (_e8205 > _e8209) {
                                                                        phi_4547_ = _e8205;
                                                                    } else {
                                                                        phi_4547_ = _e8209;
                                                                    }
                                                                    let _e8212 = phi_4547_;
                                                                    let _e8215 = local_18.member[1u];
                                                                    if (_e8215[0] < 0.0lf) {
                                                                        phi_4560_ = -(_e8215[0]);
                                                                    } else {
                                                                        phi_4560_ = _e8215[0];
                                                                    }
                                                                    let _e8222 = phi_4560_;
                                                                    if (_e8215[1] < 0.0lf) {
                                                                        phi_4567_ = -(_e8215[1]);
                                                                    } else {
                                                                        phi_4567_ = _e8215[1];
                                                                    }
                                                                    let _e8226 = phi_4567_;
                                                                    if (_e8222 > _e8226) {
                                                                        phi_4572_ = _e8222;
                                                                    } else {
                                                                        phi_4572_ = _e8226;
                                                                    }
                                                                    let _e8229 = phi_4572_;
                                                                    if (_e8215[2] < 0.0lf) {
                                                                        phi_4579_ = -(_e8215[2]);
                                                                    } else {
                                                                        phi_4579_ = _e8215[2];
                                                                    }
                                                                    let _e8233 = phi_4579_;
                                                                    if (_e8229 > _e8233) {
                                                                        phi_4584_ = _e8229;
                                                                    } else {
                                                                        phi_4584_ = _e8233;
                                                                    }
                                                                    let _e8236 = phi_4584_;
                                                                    if (_e8212 > _e8236) {
                                                                        phi_4589_ = _e8212;
                                                                    } else {
                                                                        phi_4589_ = _e8236;
                                                                    }
                                                                    let _e8239 = phi_4589_;
                                                                    let _e8241 = local_18.member_3;
                                                                    let _e8245 = local_18.member_1[0u];
                                                                    if (_e8245[0] < 0.0lf) {
                                                                        phi_4606_ = -(_e8245[0]);
                                                                    } else {
                                                                        phi_4606_ = _e8245[0];
                                                                    }
                                                                    let _e8252 = phi_4606_;
                                                                    if (_e8245[1] < 0.0lf) {
                                                                        phi_4613_ = -(_e8245[1]);
                                                                    } else {
                                                                        phi_4613_ = _e8245[1];
                                                                    }
                                                                    let _e8256 = phi_4613_;
                                                                    if (_e8252 > _e8256) {
                                                                        phi_4618_ = _e8252;
                                                                    } else {
                                                                        phi_4618_ = _e8256;
                                                                    }
                                                                    let _e8259 = phi_4618_;
                                                                    if (_e8245[2] < 0.0lf) {
                                                                        phi_4625_ = -(_e8245[2]);
                                                                    } else {
                                                                        phi_4625_ = _e8245[2];
                                                                    }
                                                                    let _e8263 = phi_4625_;
                                                                    if (_e8259 > _e8263) {
                                                                        phi_4630_ = _e8259;
                                                                    } else {
                                                                        phi_4630_ = _e8263;
                                                                    }
                                                                    let _e8266 = phi_4630_;
                                                                    let _e8269 = local_18.member_1[1u];
                                                                    if (_e8269[0] < 0.0lf) {
                                                                        phi_4644_ = -(_e8269[0]);
                                                                    } else {
                                                                        phi_4644_ = _e8269[0];
                                                                    }
                                                                    let _e8276 = phi_4644_;
                                                                    if (_e8269[1] < 0.0lf) {
                                                                        phi_4651_ = -(_e8269[1]);
                                                                    } else {
                                                                        phi_4651_ = _e8269[1];
                                                                    }
                                                                    let _e8280 = phi_4651_;
                                                                    if (_e8276 > _e8280) {
                                                                        phi_4656_ = _e8276;
                                                                    } else {
                                                                        phi_4656_ = _e8280;
                                                                    }
                                                                    let _e8283 = phi_4656_;
                                                                    if (_e8269[2] < 0.0lf) {
                                                                        phi_4663_ = -(_e8269[2]);
                                                                    } else {
                                                                        phi_4663_ = _e8269[2];
                                                                    }
                                                                    let _e8287 = phi_4663_;
                                                                    if (_e8283 > _e8287) {
                                                                        phi_4668_ = _e8283;
                                                                    } else {
                                                                        phi_4668_ = _e8287;
                                                                    }
                                                                    let _e8290 = phi_4668_;
                                                                    if (_e8266 > _e8290) {
                                                                        phi_4673_ = _e8266;
                                                                    } else {
                                                                        phi_4673_ = _e8290;
                                                                    }
                                                                    let _e8293 = phi_4673_;
                                                                    let _e8295 = local_18.member_3;
                                                                    let _e8299 = local_18.member_2[0u];
                                                                    if (_e8299[0] < 0.0lf) {
                                                                        phi_4690_ = -(_e8299[0]);
                                                                    } else {
                                                                        phi_4690_ = _e8299[0];
                                                                    }
                                                                    let _e8306 = phi_4690_;
                                                                    if (_e8299[1] < 0.0lf) {
                                                                        phi_4697_ = -(_e8299[1]);
                                                                    } else {
                                                                        phi_4697_ = _e8299[1];
                                                                    }
                                                                    let _e8310 = phi_4697_;
                                                                    if (_e8306 > _e8310) {
                                                                        phi_4702_ = _e8306;
                                                                    } else {
                                                                        phi_4702_ = _e8310;
                                                                    }
                                                                    let _e8313 = phi_4702_;
                                                                    if (_e8299[2] < 0.0lf) {
                                                                        phi_4709_ = -(_e8299[2]);
                                                                    } else {
                                                                        phi_4709_ = _e8299[2];
                                                                    }
                                                                    let _e8317 = phi_4709_;
                                                                    if (_e8313 > _e8317) {
                                                                        phi_4714_ = _e8313;
                                                                    } else {
                                                                        phi_4714_ = _e8317;
                                                                    }
                                                                    let _e8320 = phi_4714_;
                                                                    let _e8323 = local_18.member_2[1u];
                                                                    if (_e8323[0] < 0.0lf) {
                                                                        phi_4728_ = -(_e8323[0]);
                                                                    } else {
                                                                        phi_4728_ = _e8323[0];
                                                                    }
                                                                    let _e8330 = phi_4728_;
                                                                    if (_e8323[1] < 0.0lf) {
                                                                        phi_4735_ = -(_e8323[1]);
                                                                    } else {
                                                                        phi_4735_ = _e8323[1];
                                                                    }
                                                                    let _e8334 = phi_4735_;
                                                                    if (_e8330 > _e8334) {
                                                                        phi_4740_ = _e8330;
                                                                    } else {
                                                                        phi_4740_ = _e8334;
                                                                    }
                                                                    let _e8337 = phi_4740_;
                                                                    if (_e8323[2] < 0.0lf) {
                                                                        phi_4747_ = -(_e8323[2]);
                                                                    } else {
                                                                        phi_4747_ = _e8323[2];
                                                                    }
                                                                    let _e8341 = phi_4747_;
                                                                    if (_e8337 > _e8341) {
                                                                        phi_4752_ = _e8337;
                                                                    } else {
                                                                        phi_4752_ = _e8341;
                                                                    }
                                                                    let _e8344 = phi_4752_;
                                                                    if (_e8320 > _e8344) {
                                                                        phi_4757_ = _e8320;
                                                                    } else {
                                                                        phi_4757_ = _e8344;
                                                                    }
                                                                    let _e8347 = phi_4757_;
                                                                    let _e8349 = local_18.member_3;
                                                                    let _e8357 = local_18.member_3;
                                                                    if (((_e8183 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e8239 + _e8241) + (_e8293 + _e8295)) + (_e8347 + _e8349)) * (1.1102230246251565e-16lf * f64(16f))) + (_e8357 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e841.member_1) {
                                                                        phi_4781_ = false;
                                                                    } else {
                                                                        phi_4781_ = true;
                                                                    }
                                                                    let _e8369 = phi_4781_;
                                                                    phi_4782_ = _e8369;
                                                                } else {
                                                                    phi_4782_ = true;
                                                                }
                                                                let _e8371 = phi_4782_;
                                                                phi_4783_ = _e8371;
                                                            } else {
                                                                phi_4783_ = true;
                                                            }
                                                            let _e8373 = phi_4783_;
                                                            if _e8373 {
                                                                if _e7239 {
                                                                    if _e8043 {
                                                                        phi_4802_ = f64();
                                                                        phi_4803_ = true;
                                                                    } else {
                                                                        if (_e8042 <= (_e7235 * f64(0.25f))) {
                                                                            phi_4800_ = f64(0f);
                                                                            phi_4801_ = false;
                                                                        } else {
                                                                            phi_4800_ = f64();
                                                                            phi_4801_ = true;
                                                                        }
                                                                        let _e8380 = phi_4800_;
                                                                        let _e8382 = phi_4801_;
                                                                        phi_4802_ = _e8380;
                                                                        phi_4803_ = _e8382;
                                                                    }
                                                                    let _e8384 = phi_4802_;
                                                                    let _e8386 = phi_4803_;
                                                                    if _e8386 {
                                                                        phi_4808_ = (_e7570 + _e7570);
                                                                    } else {
                                                                        phi_4808_ = _e8384;
                                                                    }
                                                                    let _e8389 = phi_4808_;
                                                                    phi_4810_ = _e8389;
                                                                } else {
                                                                    phi_4810_ = (_e573 - _e7231);
                                                                }
                                                                let _e8391 = phi_4810_;
                                                                phi_4811_ = _e8391;
                                                                phi_4812_ = false;
                                                            } else {
                                                                phi_4811_ = f64();
                                                                phi_4812_ = true;
                                                            }
                                                            let _e8393 = phi_4811_;
                                                            let _e8395 = phi_4812_;
                                                            phi_4813_ = _e8393;
                                                            phi_4814_ = _e8042;
                                                            phi_4815_ = _e8373;
                                                            phi_4816_ = _e8395;
                                                        }
                                                        let _e8397 = phi_4813_;
                                                        let _e8399 = phi_4814_;
                                                        let _e8401 = phi_4815_;
                                                        let _e8403 = phi_4816_;
                                                        phi_4817_ = _e8040;
                                                        phi_4818_ = _e8397;
                                                        phi_4819_ = _e8399;
                                                        phi_4820_ = _e8040;
                                                        phi_4821_ = _e8401;
                                                        phi_4822_ = _e8041;
                                                        phi_4823_ = _e8403;
                                                        phi_4824_ = false;
                                                    } else {
                                                        phi_4817_ = f64();
                                                        phi_4818_ = f64();
                                                        phi_4819_ = f64();
                                                        phi_4820_ = f64();
                                                        phi_4821_ = false;
                                                        phi_4822_ = false;
                                                        phi_4823_ = false;
                                                        phi_4824_ = true;
                                                    }
                                                    let _e8405 = phi_4817_;
                                                    let _e8407 = phi_4818_;
                                                    let _e8409 = phi_4819_;
                                                    let _e8411 = phi_4820_;
                                                    let _e8413 = phi_4821_;
                                                    let _e8415 = phi_4822_;
                                                    let _e8417 = phi_4823_;
                                                    let _e8419 = phi_4824_;
                                                    phi_4825_ = _e8405;
                                                    phi_4826_ = _e8407;
                                                    phi_4827_ = _e8409;
                                                    phi_4828_ = _e8411;
                                                    phi_4829_ = false;
                                                    phi_4830_ = _e8413;
                                                    phi_4831_ = _e8415;
                                                    phi_4832_ = _e8417;
                                                    phi_4833_ = _e8419;
                                                } else {
                                                    phi_4825_ = f64();
                                                    phi_4826_ = f64();
                                                    phi_4827_ = f64();
                                                    phi_4828_ = f64();
                                                    phi_4829_ = true;
                                                    phi_4830_ = false;
                                                    phi_4831_ = false;
                                                    phi_4832_ = false;
                                                    phi_4833_ = false;
                                                }
                                                let _e8421 = phi_4825_;
                                                let _e8423 = phi_4826_;
                                                let _e8425 = phi_4827_;
                                                let _e8427 = phi_4828_;
                                                let _e8429 = phi_4829_;
                                                let _e8431 = phi_4830_;
                                                let _e8433 = phi_4831_;
                                                let _e8435 = phi_4832_;
                                                let _e8437 = phi_4833_;
                                                phi_4834_ = _e8421;
                                                phi_4835_ = _e8423;
                                                phi_4836_ = _e8425;
                                                phi_4837_ = _e8427;
                                                phi_4838_ = _e8429;
                                                phi_4839_ = _e8431;
                                                phi_4840_ = _e8433;
                                                phi_4841_ = _e8435;
                                                phi_4842_ = _e8437;
                                            } else {
                                                phi_4834_ = f64();
                                                phi_4835_ = f64();
                                                phi_4836_ = f64();
                                                phi_4837_ = f64();
                                                phi_4838_ = true;
                                                phi_4839_ = false;
                                                phi_4840_ = false;
                                                phi_4841_ = false;
                                                phi_4842_ = false;
                                            }
                                            let _e8439 = phi_4834_;
                                            let _e8441 = phi_4835_;
                                            let _e8443 = phi_4836_;
                                            let _e8445 = phi_4837_;
                                            let _e8447 = phi_4838_;
                                            let _e8449 = phi_4839_;
                                            let _e8451 = phi_4840_;
                                            let _e8453 = phi_4841_;
                                            let _e8455 = phi_4842_;
                                            if _e8447 {
                                                if (_e7231 <= _e7233) {
                                                    let _e8621 = (_e7241 + 1u);
                                                    let _e8622 = (_e8621 > 3u);
                                                    if _e8622 {
                                                        phi_4855_ = false;
                                                    } else {
                                                        phi_4855_ = true;
                                                    }
                                                    let _e8624 = phi_4855_;
                                                    phi_5182_ = _e8621;
                                                    phi_5183_ = f64();
                                                    phi_5184_ = false;
                                                    phi_5185_ = _e8624;
                                                    phi_5186_ = _e8622;
                                                } else {
                                                    let _e8459 = local_16.member[0u];
                                                    let _e8462 = local_16.member_1[0u];
                                                    let _e8465 = local_16.member[0u];
                                                    let _e8471 = local_16.member_2[0u];
                                                    let _e8472 = ((_e8459 + ((_e8462 - _e8465) * _e7237)) - _e8471);
                                                    let _e8475 = local_16.member[1u];
                                                    let _e8478 = local_16.member_1[1u];
                                                    let _e8481 = local_16.member[1u];
                                                    let _e8487 = local_16.member_2[1u];
                                                    let _e8488 = ((_e8475 + ((_e8478 - _e8481) * _e7237)) - _e8487);
                                                    if (_e8472 < _e8488) {
                                                        phi_4928_ = _e8472;
                                                    } else {
                                                        phi_4928_ = _e8488;
                                                    }
                                                    let _e8491 = phi_4928_;
                                                    let _e8494 = local_16.member[2u];
                                                    let _e8497 = local_16.member_1[2u];
                                                    let _e8500 = local_16.member[2u];
                                                    let _e8506 = local_16.member_2[2u];
                                                    let _e8507 = ((_e8494 + ((_e8497 - _e8500) * _e7237)) - _e8506);
                                                    let _e8510 = local_16.member[3u];
                                                    let _e8513 = local_16.member_1[3u];
                                                    let _e8516 = local_16.member[3u];
                                                    let _e8522 = local_16.member_2[3u];
                                                    let _e8523 = ((_e8510 + ((_e8513 - _e8516) * _e7237)) - _e8522);
                                                    if (_e8507 < _e8523) {
                                                        phi_5001_ = _e8507;
                                                    } else {
                                                        phi_5001_ = _e8523;
                                                    }
                                                    let _e8526 = phi_5001_;
                                                    if (_e8491 < _e8526) {
                                                        phi_5006_ = _e8491;
                                                    } else {
                                                        phi_5006_ = _e8526;
                                                    }
                                                    let _e8529 = phi_5006_;
                                                    let _e8532 = local_17.member[0u];
                                                    let _e8535 = local_17.member_1[0u];
                                                    let _e8538 = local_17.member[0u];
                                                    let _e8544 = local_17.member_2[0u];
                                                    let _e8545 = ((_e8532 + ((_e8535 - _e8538) * _e7231)) - _e8544);
                                                    let _e8548 = local_17.member[1u];
                                                    let _e8551 = local_17.member_1[1u];
                                                    let _e8554 = local_17.member[1u];
                                                    let _e8560 = local_17.member_2[1u];
                                                    let _e8561 = ((_e8548 + ((_e8551 - _e8554) * _e7231)) - _e8560);
                                                    if (_e8545 < _e8561) {
                                                        phi_5079_ = _e8545;
                                                    } else {
                                                        phi_5079_ = _e8561;
                                                    }
                                                    let _e8564 = phi_5079_;
                                                    let _e8567 = local_17.member[2u];
                                                    let _e8570 = local_17.member_1[2u];
                                                    let _e8573 = local_17.member[2u];
                                                    let _e8579 = local_17.member_2[2u];
                                                    let _e8580 = ((_e8567 + ((_e8570 - _e8573) * _e7231)) - _e8579);
                                                    let _e8583 = local_17.member[3u];
                                                    let _e8586 = local_17.member_1[3u];
                                                    let _e8589 = local_17.member[3u];
                                                    let _e8595 = local_17.member_2[3u];
                                                    let _e8596 = ((_e8583 + ((_e8586 - _e8589) * _e7231)) - _e8595);
                                                    if (_e8580 < _e8596) {
                                                        phi_5152_ = _e8580;
                                                    } else {
                                                        phi_5152_ = _e8596;
                                                    }
                                                    let _e8599 = phi_5152_;
                                                    if (_e8564 < _e8599) {
                                                        phi_5157_ = _e8564;
                                                    } else {
                                                        phi_5157_ = _e8599;
                                                    }
                                                    let _e8602 = phi_5157_;
                                                    let _e8603 = f64(0.0625f);
                                                    let _e8605 = f64(0.9f);
                                                    if (_e8602 > f64(0f)) {
                                                        phi_5180_ = f64(0.5f);
                                                    } else {
                                                        let _e8611 = (f64(0.95f) * (_e8529 / (_e8529 - _e8602)));
                                                        if (_e8611 > _e8603) {
                                                            if (_e8611 < _e8605) {
                                                                phi_5178_ = _e8611;
                                                            } else {
                                                                phi_5178_ = _e8605;
                                                            }
                                                            let _e8615 = phi_5178_;
                                                            phi_5179_ = _e8615;
                                                        } else {
                                                            phi_5179_ = _e8603;
                                                        }
                                                        let _e8617 = phi_5179_;
                                                        phi_5180_ = _e8617;
                                                    }
                                                    let _e8619 = phi_5180_;
                                                    phi_5182_ = u32();
                                                    phi_5183_ = (_e7570 * _e8619);
                                                    phi_5184_ = true;
                                                    phi_5185_ = false;
                                                    phi_5186_ = false;
                                                }
                                                let _e8626 = phi_5182_;
                                                let _e8628 = phi_5183_;
                                                let _e8630 = phi_5184_;
                                                let _e8632 = phi_5185_;
                                                let _e8634 = phi_5186_;
                                                phi_5187_ = _e8626;
                                                phi_5188_ = _e7233;
                                                phi_5189_ = _e8628;
                                                phi_5190_ = _e7235;
                                                phi_5191_ = _e7237;
                                                phi_5192_ = _e7239;
                                                phi_5193_ = _e7241;
                                                phi_5194_ = _e8630;
                                                phi_5195_ = _e8632;
                                                phi_5196_ = _e8634;
                                                phi_5197_ = false;
                                                phi_5198_ = false;
                                                phi_5199_ = false;
                                            } else {
                                                phi_5187_ = u32();
                                                phi_5188_ = _e8439;
                                                phi_5189_ = _e8441;
                                                phi_5190_ = _e8443;
                                                phi_5191_ = _e7231;
                                                phi_5192_ = true;
                                                phi_5193_ = 0u;
                                                phi_5194_ = _e8449;
                                                phi_5195_ = false;
                                                phi_5196_ = false;
                                                phi_5197_ = _e8451;
                                                phi_5198_ = _e8453;
                                                phi_5199_ = _e8455;
                                            }
                                            let _e8636 = phi_5187_;
                                            let _e8638 = phi_5188_;
                                            let _e8640 = phi_5189_;
                                            let _e8642 = phi_5190_;
                                            let _e8644 = phi_5191_;
                                            let _e8646 = phi_5192_;
                                            let _e8648 = phi_5193_;
                                            let _e8650 = phi_5194_;
                                            let _e8652 = phi_5195_;
                                            let _e8654 = phi_5196_;
                                            let _e8656 = phi_5197_;
                                            let _e8658 = phi_5198_;
                                            let _e8660 = phi_5199_;
                                            if _e8650 {
                                                let _e8661 = (_e8644 + _e8640);
                                                if (_e8661 > _e8638) {
                                                    phi_5208_ = _e8661;
                                                } else {
                                                    phi_5208_ = _e8638;
                                                }
                                                let _e8664 = phi_5208_;
                                                if (_e8664 < _e573) {
                                                    phi_5213_ = _e8664;
                                                } else {
                                                    phi_5213_ = _e573;
                                                }
                                                let _e8667 = phi_5213_;
                                                if !(_e7239) {
                                                    phi_5222_ = true;
                                                } else {
                                                    phi_5222_ = ((_e8667 - _e8644) > _e7220);
                                                }
                                                let _e8671 = phi_5222_;
                                                if _e8671 {
                                                    phi_5226_ = false;
                                                } else {
                                                    phi_5226_ = true;
                                                }
                                                let _e8673 = phi_5226_;
                                                phi_5227_ = _e8667;
                                                phi_5228_ = _e8638;
                                                phi_5229_ = _e8642;
                                                phi_5230_ = _e8644;
                                                phi_5231_ = _e8646;
                                                phi_5232_ = _e8648;
                                                phi_5233_ = _e8671;
                                                phi_5234_ = _e8673;
                                                phi_5235_ = false;
                                                phi_5236_ = false;
                                                phi_5237_ = false;
                                                phi_5238_ = false;
                                            } else {
                                                phi_5227_ = _e7231;
                                                phi_5228_ = _e7233;
                                                phi_5229_ = _e7235;
                                                phi_5230_ = _e7237;
                                                phi_5231_ = _e7239;
                                                phi_5232_ = _e8636;
                                                phi_5233_ = _e8652;
                                                phi_5234_ = false;
                                                phi_5235_ = _e8654;
                                                phi_5236_ = _e8656;
                                                phi_5237_ = _e8658;
                                                phi_5238_ = _e8660;
                                            }
                                            let _e8675 = phi_5227_;
                                            let _e8677 = phi_5228_;
                                            let _e8679 = phi_5229_;
                                            let _e8681 = phi_5230_;
                                            let _e8683 = phi_5231_;
                                            let _e8685 = phi_5232_;
                                            let _e8687 = phi_5233_;
                                            let _e8689 = phi_5234_;
                                            let _e8691 = phi_5235_;
                                            let _e8693 = phi_5236_;
                                            let _e8695 = phi_5237_;
                                            let _e8697 = phi_5238_;
                                            phi_3017_ = _e8675;
                                            phi_3019_ = _e8677;
                                            phi_3021_ = _e8679;
                                            phi_3023_ = _e8681;
                                            phi_3025_ = _e8683;
                                            phi_3027_ = _e8685;
                                            phi_5239_ = _e8638;
                                            phi_5240_ = _e8445;
                                            phi_5241_ = _e8687;
                                            phi_5242_ = _e8689;
                                            phi_5243_ = _e8691;
                                            phi_5244_ = _e8693;
                                            phi_5245_ = _e8695;
                                            phi_5246_ = false;
                                            phi_5247_ = _e8697;
                                        } else {
                                            phi_3017_ = f64();
                                            phi_3019_ = f64();
                                            phi_3021_ = f64();
                                            phi_3023_ = f64();
                                            phi_3025_ = bool();
                                            phi_3027_ = u32();
                                            phi_5239_ = f64();
                                            phi_5240_ = f64();
                                            phi_5241_ = false;
                                            phi_5242_ = false;
                                            phi_5243_ = false;
                                            phi_5244_ = false;
                                            phi_5245_ = false;
                                            phi_5246_ = true;
                                            phi_5247_ = false;
                                        }
                                        let _e8699 = phi_3017_;
                                        let _e8701 = phi_3019_;
                                        let _e8703 = phi_3021_;
                                        let _e8705 = phi_3023_;
                                        let _e8707 = phi_3025_;
                                        let _e8709 = phi_3027_;
                                        let _e8711 = phi_5239_;
                                        let _e8713 = phi_5240_;
                                        let _e8715 = phi_5241_;
                                        let _e8717 = phi_5242_;
                                        let _e8719 = phi_5243_;
                                        let _e8721 = phi_5244_;
                                        let _e8723 = phi_5245_;
                                        let _e8725 = phi_5246_;
                                        let _e8727 = phi_5247_;
                                        local_43 = _e8717;
                                        local_81 = _e8719;
                                        local_82 = _e8721;
                                        local_83 = _e8723;
                                        local_84 = _e8725;
                                        local_85 = _e8727;
                                        local_86 = _e8717;
                                        local_87 = _e8713;
                                        local_88 = _e8711;
                                        continue;
                                        continuing {
                                            phi_3013_ = _e7253;
                                            phi_3016_ = _e8699;
                                            phi_3018_ = _e8701;
                                            phi_3020_ = _e8703;
                                            phi_3022_ = _e8705;
                                            phi_3024_ = _e8707;
                                            phi_3026_ = _e8709;
                                            break if !(_e8715);
                                        }
                                    }
                                    let _e8730 = local_43;
                                    if _e8730 {
                                        phi_5251_ = false;
                                        phi_5252_ = false;
                                        phi_5253_ = false;
                                        phi_5254_ = false;
                                        phi_5255_ = false;
                                    } else {
                                        let _e12257 = local_81;
                                        phi_5251_ = _e12257;
                                        let _e12260 = local_82;
                                        phi_5252_ = _e12260;
                                        let _e12263 = local_83;
                                        phi_5253_ = _e12263;
                                        let _e12266 = local_84;
                                        phi_5254_ = _e12266;
                                        let _e12269 = local_85;
                                        phi_5255_ = _e12269;
                                    }
                                    let _e8732 = phi_5251_;
                                    let _e8734 = phi_5252_;
                                    let _e8736 = phi_5253_;
                                    let _e8738 = phi_5254_;
                                    let _e8740 = phi_5255_;
                                    if _e8732 {
                                        let _e8742 = local_44;
                                        phi_5260_ = type_43(1u, _e8742);
                                        phi_5261_ = false;
                                        phi_5262_ = false;
                                        phi_5263_ = false;
                                        phi_5264_ = false;
                                        phi_5265_ = false;
                                    } else {
                                        phi_5260_ = type_43();
                                        phi_5261_ = _e8734;
                                        phi_5262_ = _e8736;
                                        let _e12276 = local_86;
                                        phi_5263_ = _e12276;
                                        phi_5264_ = _e8738;
                                        phi_5265_ = _e8740;
                                    }
                                    let _e8745 = phi_5260_;
                                    let _e8747 = phi_5261_;
                                    let _e8749 = phi_5262_;
                                    let _e8751 = phi_5263_;
                                    let _e8753 = phi_5264_;
                                    let _e8755 = phi_5265_;
                                    if _e8747 {
                                        phi_5270_ = type_43(0u, type_43().member_1);
                                        phi_5271_ = false;
                                        phi_5272_ = false;
                                        phi_5273_ = false;
                                        phi_5274_ = false;
                                        phi_5275_ = true;
                                    } else {
                                        phi_5270_ = _e8745;
                                        phi_5271_ = _e8749;
                                        phi_5272_ = _e8751;
                                        phi_5273_ = _e8753;
                                        phi_5274_ = _e8755;
                                        phi_5275_ = _e8732;
                                    }
                                    let _e8759 = phi_5270_;
                                    let _e8761 = phi_5271_;
                                    let _e8763 = phi_5272_;
                                    let _e8765 = phi_5273_;
                                    let _e8767 = phi_5274_;
                                    let _e8769 = phi_5275_;
                                    if _e8761 {
                                        let _e12287 = local_87;
                                        phi_5279_ = _e12287;
                                        phi_5280_ = true;
                                        phi_5281_ = false;
                                        phi_5282_ = false;
                                        phi_5283_ = false;
                                    } else {
                                        let _e12289 = local_88;
                                        phi_5279_ = _e12289;
                                        phi_5280_ = _e8763;
                                        phi_5281_ = _e8765;
                                        phi_5282_ = _e8767;
                                        phi_5283_ = _e8769;
                                    }
                                    let _e8771 = phi_5279_;
                                    let _e8773 = phi_5280_;
                                    let _e8775 = phi_5281_;
                                    let _e8777 = phi_5282_;
                                    let _e8779 = phi_5283_;
                                    if _e8773 {
                                        phi_5287_ = _e8771;
                                        phi_5288_ = true;
                                        phi_5289_ = false;
                                        phi_5290_ = false;
                                    } else {
                                        let _e12296 = local_89;
                                        phi_5287_ = _e12296;
                                        phi_5288_ = _e8775;
                                        phi_5289_ = _e8777;
                                        phi_5290_ = _e8779;
                                    }
                                    let _e8781 = phi_5287_;
                                    let _e8783 = phi_5288_;
                                    let _e8785 = phi_5289_;
                                    let _e8787 = phi_5290_;
                                    if _e8783 {
                                        phi_5295_ = type_43(1u, _e8781);
                                        phi_5296_ = false;
                                        phi_5297_ = false;
                                    } else {
                                        phi_5295_ = type_43();
                                        phi_5296_ = _e8785;
                                        phi_5297_ = _e8787;
                                    }
                                    let _e8790 = phi_5295_;
                                    let _e8792 = phi_5296_;
                                    let _e8794 = phi_5297_;
                                    if _e8792 {
                                        phi_5302_ = type_43(0u, type_43().member_1);
                                        phi_5303_ = true;
                                    } else {
                                        phi_5302_ = _e8759;
                                        phi_5303_ = _e8794;
                                    }
                                    let _e8798 = phi_5302_;
                                    let _e8800 = phi_5303_;
                                    if _e8800 {
                                        phi_5307_ = _e8798;
                                    } else {
                                        phi_5307_ = _e8790;
                                    }
                                    let _e8802 = phi_5307_;
                                    phi_5314_ = _e8802.member_1;
                                    phi_5315_ = (_e8802.member != 0u);
                                } else {
                                    phi_5314_ = _e6941;
                                    phi_5315_ = true;
                                }
                                let _e8807 = phi_5314_;
                                let _e8809 = phi_5315_;
                                if _e8809 {
                                    let _e8810 = (_e8807 > _e564);
                                    if _e8810 {
                                        phi_7522_ = f64();
                                        phi_7523_ = u32();
                                        phi_7524_ = f64();
                                        phi_7525_ = type_45();
                                        phi_7526_ = u32();
                                        phi_7527_ = u32();
                                        phi_7528_ = false;
                                        phi_7529_ = false;
                                        phi_7530_ = false;
                                    } else {
                                        let _e8814 = local_18.member[0u];
                                        let _e8820 = local_18.member[1u];
                                        let _e8836 = local_18.member_1[0u];
                                        let _e8842 = local_18.member_1[1u];
                                        let _e8858 = local_18.member_2[0u];
                                        let _e8864 = local_18.member_2[1u];
                                        let _e8878 = function_4(array<f64, 3>((_e8814[0] + ((_e8820[0] - _e8814[0]) * _e6945)), (_e8814[1] + ((_e8820[1] - _e8814[1]) * _e6945)), (_e8814[2] + ((_e8820[2] - _e8814[2]) * _e6945))), array<f64, 3>((_e8836[0] + ((_e8842[0] - _e8836[0]) * _e6945)), (_e8836[1] + ((_e8842[1] - _e8836[1]) * _e6945)), (_e8836[2] + ((_e8842[2] - _e8836[2]) * _e6945))), array<f64, 3>((_e8858[0] + ((_e8864[0] - _e8858[0]) * _e6945)), (_e8858[1] + ((_e8864[1] - _e8858[1]) * _e6945)), (_e8858[2] + ((_e8864[2] - _e8858[2]) * _e6945))), _e252.member);
                                        if (_e8878[0] < 0.0lf) {
                                            phi_5428_ = -(_e8878[0]);
                                        } else {
                                            phi_5428_ = _e8878[0];
                                        }
                                        let _e8883 = phi_5428_;
                                        if (_e8878[1] < 0.0lf) {
                                            phi_5435_ = -(_e8878[1]);
                                        } else {
                                            phi_5435_ = _e8878[1];
                                        }
                                        let _e8888 = phi_5435_;
                                        if (_e8878[2] < 0.0lf) {
                                            phi_5443_ = -(_e8878[2]);
                                        } else {
                                            phi_5443_ = _e8878[2];
                                        }
                                        let _e8894 = phi_5443_;
                                        let _e8895 = ((_e8883 + _e8888) + _e8894);
                                        let _e8898 = local_18.member[0u];
                                        let _e8905 = local_18.member_1[0u];
                                        let _e8911 = local_18.member_2[0u];
                                        let _e8915 = (_e8898[0] - _e8905[0]);
                                        let _e8916 = (_e8898[1] - _e8905[1]);
                                        let _e8917 = (_e8898[2] - _e8905[2]);
                                        if (_e252.member == 0u) {
                                            phi_5501_ = array<f64, 3>(_e8898[0], _e8898[1], _e8898[2]);
                                        } else {
                                            phi_5501_ = array<f64, 3>((_e8915 - _e8911[0]), (_e8916 - _e8911[1]), (_e8917 - _e8911[2]));
                                        }
                                        let _e8924 = phi_5501_;
                                        let _e8930 = local_18.member[1u];
                                        let _e8937 = local_18.member_1[1u];
                                        let _e8943 = local_18.member_2[1u];
                                        let _e8947 = (_e8930[0] - _e8937[0]);
                                        let _e8948 = (_e8930[1] - _e8937[1]);
                                        let _e8949 = (_e8930[2] - _e8937[2]);
                                        if (_e252.member == 0u) {
                                            phi_5569_ = array<f64, 3>(_e8930[0], _e8930[1], _e8930[2]);
                                        } else {
                                            phi_5569_ = array<f64, 3>((_e8947 - _e8943[0]), (_e8948 - _e8943[1]), (_e8949 - _e8943[2]));
                                        }
                                        let _e8956 = phi_5569_;
                                        let _e8962 = local_18.member[0u];
                                        if (_e8962[0] < 0.0lf) {
                                            phi_5594_ = -(_e8962[0]);
                                        } else {
                                            phi_5594_ = _e8962[0];
                                        }
                                        let _e8969 = phi_5594_;
                                        if (_e8962[1] < 0.0lf) {
                                            phi_5601_ = -(_e8962[1]);
                                        } else {
                                            phi_5601_ = _e8962[1];
                                        }
                                        let _e8973 = phi_5601_;
                                        if (_e8969 > _e8973) {
                                            phi_5606_ = _e8969;
                                        } else {
                                            phi_5606_ = _e8973;
                                        }
                                        let _e8976 = phi_5606_;
                                        if (_e8962[2] < 0.0lf) {
                                            phi_5613_ = -(_e8962[2]);
                                        } else {
                                            phi_5613_ = _e8962[2];
                                        }
                                        let _e8980 = phi_5613_;
                                        if (_e8976 > _e8980) {
                                            phi_5618_ = _e8976;
                                        } else {
                                            phi_5618_ = _e8980;
                                        }
                                        let _e8983 = phi_5618_;
                                        let _e8986 = local_18.member[1u];
                                        if (_e8986[0] < 0.0lf) {
                                            phi_5631_ = -(_e8986[0]);
                                        } else {
                                            phi_5631_ = _e8986[0];
                                        }
                                        let _e8993 = phi_5631_;
                                        if (_e8986[1] < 0.0lf) {
                                            phi_5638_ = -(_e8986[1]);
                                        } else {
                                            phi_5638_ = _e8986[1];
                                        }
                                        let _e8997 = phi_5638_;
                                        if (_e8993 > _e8997) {
                                            phi_5643_ = _e8993;
                                        } else {
                                            phi_5643_ = _e8997;
                                        }
                                        let _e9000 = phi_5643_;
                                        if (_e8986[2] < 0.0lf) {
                                            phi_5650_ = -(_e8986[2]);
                                        } else {
                                            phi_5650_ = _e8986[2];
                                        }
                                        let _e9004 = phi_5650_;
                                        if (_e9000 > _e9004) {
                                            phi_5655_ = _e9000;
                                        } else {
                                            phi_5655_ = _e9004;
                                        }
                                        let _e9007 = phi_5655_;
                                        if (_e8983 > _e9007) {
                                            phi_5660_ = _e8983;
                                        } else {
                                            phi_5660_ = _e9007;
                                        }
                                        let _e9010 = phi_5660_;
                                        let _e9012 = local_18.member_3;
                                        let _e9016 = local_18.member_1[0u];
                                        if (_e9016[0] < 0.0lf) {
                                            phi_5677_ = -(_e9016[0]);
                                        } else {
                                            phi_5677_ = _e9016[0];
                                        }
                                        let _e9023 = phi_5677_;
                                        if (_e9016[1] < 0.0lf) {
                                            phi_5684_ = -(_e9016[1]);
                                        } else {
                                            phi_5684_ = _e9016[1];
                                        }
                                        let _e9027 = phi_5684_;
                                        if (_e9023 > _e9027) {
                                            phi_5689_ = _e9023;
                                        } else {
                                            phi_5689_ = _e9027;
                                        }
                                        let _e9030 = phi_5689_;
                                        if (_e9016[2] < 0.0lf) {
                                            phi_5696_ = -(_e9016[2]);
                                        } else {
                                            phi_5696_ = _e9016[2];
                                        }
                                        let _e9034 = phi_5696_;
                                        if (_e9030 > _e9034) {
                                            phi_5701_ = _e9030;
                                        } else {
                                            phi_5701_ = _e9034;
                                        }
                                        let _e9037 = phi_5701_;
                                        let _e9040 = local_18.member_1[1u];
                                        if (_e9040[0] < 0.0lf) {
                                            phi_5715_ = -(_e9040[0]);
                                        } else {
                                            phi_5715_ = _e9040[0];
                                        }
                                        let _e9047 = phi_5715_;
                                        if (_e9040[1] < 0.0lf) {
                                            phi_5722_ = -(_e9040[1]);
                                        } else {
                                            phi_5722_ = _e9040[1];
                                        }
                                        let _e9051 = phi_5722_;
                                        if (_e9047 > _e9051) {
                                            phi_5727_ = _e9047;
                                        } else {
                                            phi_5727_ = _e9051;
                                        }
                                        let _e9054 = phi_5727_;
                                        if (_e9040[2] < 0.0lf) {
                                            phi_5734_ = -(_e9040[2]);
                                        } else {
                                            phi_5734_ = _e9040[2];
                                        }
                                        let _e9058 = phi_5734_;
                                        if (_e9054 > _e9058) {
                                            phi_5739_ = _e9054;
                                        } else {
                                            phi_5739_ = _e9058;
                                        }
                                        let _e9061 = phi_5739_;
                                        if (_e9037 > _e9061) {
                                            phi_5744_ = _e9037;
                                        } else {
                                            phi_5744_ = _e9061;
                                        }
                                        let _e9064 = phi_5744_;
                                        let _e9066 = local_18.member_3;
                                        let _e9070 = local_18.member_2[0u];
                                        if (_e9070[0] < 0.0lf) {
                                            phi_5761_ = -(_e9070[0]);
                                        } else {
                                            phi_5761_ = _e9070[0];
                                        }
                                        let _e9077 = phi_5761_;
                                        if (_e9070[1] < 0.0lf) {
                                            phi_5768_ = -(_e9070[1]);
                                        } else {
                                            phi_5768_ = _e9070[1];
                                        }
                                        let _e9081 = phi_5768_;
                                        if (_e9077 > _e9081) {
                                            phi_5773_ = _e9077;
                                        } else {
                                            phi_5773_ = _e9081;
                                        }
                                        let _e9084 = phi_5773_;
                                        if (_e9070[2] < 0.0lf) {
                                            phi_5780_ = -(_e9070[2]);
                                        } else {
                                            phi_5780_ = _e9070[2];
                                        }
                                        let _e9088 = phi_5780_;
                                        if (_e9084 > _e9088) {
                                            phi_5785_ = _e9084;
                                        } else {
                                            phi_5785_ = _e9088;
                                        }
                                        let _e9091 = phi_5785_;
                                        let _e9094 = local_18.member_2[1u];
                                        if (_e9094[0] < 0.0lf) {
                                            phi_5799_ = -(_e9094[0]);
                                        } else {
                                            phi_5799_ = _e9094[0];
                                        }
                                        let _e9101 = phi_5799_;
                                        if (_e9094[1] < 0.0lf) {
                                            phi_5806_ = -(_e9094[1]);
                                        } else {
                                            phi_5806_ = _e9094[1];
                                        }
                                        let _e9105 = phi_5806_;
                                        if (_e9101 > _e9105) {
                                            phi_5811_ = _e9101;
                                        } else {
                                            phi_5811_ = _e9105;
                                        }
                                        let _e9108 = phi_5811_;
                                        if (_e9094[2] < 0.0lf) {
                                            phi_5818_ = -(_e9094[2]);
                                        } else {
                                            phi_5818_ = _e9094[2];
                                        }
                                        let _e9112 = phi_5818_;
                                        if (_e9108 > _e9112) {
                                            phi_5823_ = _e9108;
                                        } else {
                                            phi_5823_ = _e9112;
                                        }
                                        let _e9115 = phi_5823_;
                                        if (_e9091 > _e9115) {
                                            phi_5828_ = _e9091;
                                        } else {
                                            phi_5828_ = _e9115;
                                        }
                                        let _e9118 = phi_5828_;
                                        let _e9120 = local_18.member_3;
                                        let _e9128 = local_18.member_3;
                                        local_14 = type_41(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e8898, array<f64, 3>(_e8915, _e8916, _e8917), array<f64, 3>((_e8898[0] - _e8911[0]), (_e8898[1] - _e8911[1]), (_e8898[2] - _e8911[2])), array<f64, 3>(_e8924[0], _e8924[1], _e8924[2])), array<array<f64, 3>, 4>(_e8930, array<f64, 3>(_e8947, _e8948, _e8949), array<f64, 3>((_e8930[0] - _e8943[0]), (_e8930[1] - _e8943[1]), (_e8930[2] - _e8943[2])), array<f64, 3>(_e8956[0], _e8956[1], _e8956[2]))), ((((((_e9010 + _e9012) + (_e9064 + _e9066)) + (_e9118 + _e9120)) * (1.1102230246251565e-16lf * f64(16f))) + (_e9128 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e841.member_1);
                                        let _e9152 = local_14.member_1;
                                        if (_e8895 > _e9152) {
                                            if ((bitcast<u64>(_e8895) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e9158 = (f64(1f) / _e8895);
                                                let _e9160 = (_e8878[0] * _e9158);
                                                let _e9162 = (_e8878[1] * _e9158);
                                                let _e9164 = (_e8878[2] * _e9158);
                                                let _e9169 = (((_e9160 * _e9160) + (_e9162 * _e9162)) + (_e9164 * _e9164));
                                                if (_e9169 <= 2.2250738585072014e-308lf) {
                                                    if (_e9169 > 0.0lf) {
                                                        phi_5933_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_5933_ = 0.0lf;
                                                    }
                                                    let _e9221 = phi_5933_;
                                                    phi_5997_ = _e9221;
                                                } else {
                                                    phi_5940_ = type_18(0i, 5i);
                                                    phi_5943_ = bitcast<f64>(((bitcast<u64>(_e9169) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9176 = phi_5940_;
                                                        let _e9178 = phi_5943_;
                                                        local_45 = _e9178;
                                                        if (_e9176.member < _e9176.member_1) {
                                                            let _e9185 = (_e9176.member + 1i);
                                                            if ((false == (_e9185 > _e9176.member)) != false) {
                                                                phi_5964_ = true;
                                                            } else {
                                                                phi_5964_ = false;
                                                            }
                                                            let _e9190 = phi_5964_;
                                                            if _e9190 {
                                                                phi_5970_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_5970_ = type_19(1u, _e9185);
                                                            }
                                                            let _e9195 = phi_5970_;
                                                            phi_5941_ = type_18(_e9195.member_1, _e9176.member_1);
                                                            phi_5984_ = type_19(1u, _e9176.member);
                                                        } else {
                                                            phi_5941_ = _e9176;
                                                            phi_5984_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e9201 = phi_5941_;
                                                        let _e9203 = phi_5984_;
                                                        let _e9206 = (bitcast<i32>(_e9203.member) != 0i);
                                                        if _e9206 {
                                                            phi_5944_ = (0.5lf * (_e9178 + (_e9169 / _e9178)));
                                                        } else {
                                                            phi_5944_ = f64();
                                                        }
                                                        let _e9211 = phi_5944_;
                                                        continue;
                                                        continuing {
                                                            phi_5940_ = _e9201;
                                                            phi_5943_ = _e9211;
                                                            break if !(_e9206);
                                                        }
                                                    }
                                                    let _e9216 = local_45;
                                                    phi_5997_ = (_e9216 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9223 = phi_5997_;
                                                let _e9225 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e9227 = local_14.member_1;
                                                let _e9231 = local_14.member_2;
                                                let _e9236 = ((_e9227 * f64(1.01f)) + ((_e9231 * _e9223) * (f64(1f) + _e9225)));
                                                let _e9240 = local_14.member[0u][0u];
                                                let _e9248 = (((_e9160 * _e9240[0]) + (_e9162 * _e9240[1])) + (_e9164 * _e9240[2]));
                                                let _e9252 = local_14.member[0u][1u];
                                                let _e9260 = (((_e9160 * _e9252[0]) + (_e9162 * _e9252[1])) + (_e9164 * _e9252[2]));
                                                let _e9264 = local_14.member[0u][2u];
                                                let _e9272 = (((_e9160 * _e9264[0]) + (_e9162 * _e9264[1])) + (_e9164 * _e9264[2]));
                                                let _e9276 = local_14.member[0u][3u];
                                                let _e9284 = (((_e9160 * _e9276[0]) + (_e9162 * _e9276[1])) + (_e9164 * _e9276[2]));
                                                let _e9288 = local_14.member[1u][0u];
                                                let _e9296 = (((_e9160 * _e9288[0]) + (_e9162 * _e9288[1])) + (_e9164 * _e9288[2]));
                                                let _e9300 = local_14.member[1u][1u];
                                                let _e9308 = (((_e9160 * _e9300[0]) + (_e9162 * _e9300[1])) + (_e9164 * _e9300[2]));
                                                let _e9312 = local_14.member[1u][2u];
                                                let _e9320 = (((_e9160 * _e9312[0]) + (_e9162 * _e9312[1])) + (_e9164 * _e9312[2]));
                                                let _e9324 = local_14.member[1u][3u];
                                                let _e9332 = (((_e9160 * _e9324[0]) + (_e9162 * _e9324[1])) + (_e9164 * _e9324[2]));
                                                if (_e9248 < 0.0lf) {
                                                    phi_6134_ = -(_e9248);
                                                } else {
                                                    phi_6134_ = _e9248;
                                                }
                                                let _e9336 = phi_6134_;
                                                if (_e9296 < 0.0lf) {
                                                    phi_6140_ = -(_e9296);
                                                } else {
                                                    phi_6140_ = _e9296;
                                                }
                                                let _e9340 = phi_6140_;
                                                if (_e9260 < 0.0lf) {
                                                    phi_6149_ = -(_e9260);
                                                } else {
                                                    phi_6149_ = _e9260;
                                                }
                                                let _e9347 = phi_6149_;
                                                if (_e9308 < 0.0lf) {
                                                    phi_6155_ = -(_e9308);
                                                } else {
                                                    phi_6155_ = _e9308;
                                                }
                                                let _e9351 = phi_6155_;
                                                if (_e9272 < 0.0lf) {
                                                    phi_6164_ = -(_e9272);
                                                } else {
                                                    phi_6164_ = _e9272;
                                                }
                                                let _e9358 = phi_6164_;
                                                if (_e9320 < 0.0lf) {
                                                    phi_6170_ = -(_e9320);
                                                } else {
                                                    phi_6170_ = _e9320;
                                                }
                                                let _e9362 = phi_6170_;
                                                if (_e9284 < 0.0lf) {
                                                    phi_6179_ = -(_e9284);
                                                } else {
                                                    phi_6179_ = _e9284;
                                                }
                                                let _e9369 = phi_6179_;
                                                if (_e9332 < 0.0lf) {
                                                    phi_6185_ = -(_e9332);
                                                } else {
                                                    phi_6185_ = _e9332;
                                                }
                                                let _e9373 = phi_6185_;
                                                local_15 = type_35(array<f64, 4>(_e9248, _e9260, _e9272, _e9284), array<f64, 4>(_e9296, _e9308, _e9320, _e9332), array<f64, 4>((_e9236 + ((_e9336 + _e9340) * _e9225)), (_e9236 + ((_e9347 + _e9351) * _e9225)), (_e9236 + ((_e9358 + _e9362) * _e9225)), (_e9236 + ((_e9369 + _e9373) * _e9225))));
                                                let _e9385 = (((_e9160 * _e9160) + (_e9162 * _e9162)) + (_e9164 * _e9164));
                                                if (_e9385 <= 2.2250738585072014e-308lf) {
                                                    if (_e9385 > 0.0lf) {
                                                        phi_6228_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6228_ = 0.0lf;
                                                    }
                                                    let _e9437 = phi_6228_;
                                                    phi_6292_ = _e9437;
                                                } else {
                                                    phi_6235_ = type_18(0i, 5i);
                                                    phi_6238_ = bitcast<f64>(((bitcast<u64>(_e9385) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9392 = phi_6235_;
                                                        let _e9394 = phi_6238_;
                                                        local_46 = _e9394;
                                                        if (_e9392.member < _e9392.member_1) {
                                                            let _e9401 = (_e9392.member + 1i);
                                                            if ((false == (_e9401 > _e9392.member)) != false) {
                                                                phi_6259_ = true;
                                                            } else {
                                                                phi_6259_ = false;
                                                            }
                                                            let _e9406 = phi_6259_;
                                                            if _e9406 {
                                                                phi_6265_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_6265_ = type_19(1u, _e9401);
                                                            }
                                                            let _e9411 = phi_6265_;
                                                            phi_6236_ = type_18(_e9411.member_1, _e9392.member_1);
                                                            phi_6279_ = type_19(1u, _e9392.member);
                                                        } else {
                                                            phi_6236_ = _e9392;
                                                            phi_6279_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e9417 = phi_6236_;
                                                        let _e9419 = phi_6279_;
                                                        let _e9422 = (bitcast<i32>(_e9419.member) != 0i);
                                                        if _e9422 {
                                                            phi_6239_ = (0.5lf * (_e9394 + (_e9385 / _e9394)));
                                                        } else {
                                                            phi_6239_ = f64();
                                                        }
                                                        let _e9427 = phi_6239_;
                                                        continue;
                                                        continuing {
                                                            phi_6235_ = _e9417;
                                                            phi_6238_ = _e9427;
                                                            break if !(_e9422);
                                                        }
                                                    }
                                                    let _e9432 = local_46;
                                                    phi_6292_ = (_e9432 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9439 = phi_6292_;
                                                let _e9450 = (((_e8878[0] * _e8878[0]) + (_e8878[1] * _e8878[1])) + (_e8878[2] * _e8878[2]));
                                                if (_e9450 <= 2.2250738585072014e-308lf) {
                                                    if (_e9450 > 0.0lf) {
                                                        phi_6317_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6317_ = 0.0lf;
                                                    }
                                                    let _e9502 = phi_6317_;
                                                    phi_6381_ = _e9502;
                                                } else {
                                                    phi_6324_ = type_18(0i, 5i);
                                                    phi_6327_ = bitcast<f64>(((bitcast<u64>(_e9450) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9457 = phi_6324_;
                                                        let _e9459 = phi_6327_;
                                                        local_47 = _e9459;
                                                        if (_e9457.member < _e9457.member_1) {
                                                            let _e9466 = (_e9457.member + 1i);
                                                            if ((false == (_e9466 > _e9457.member)) != false) {
                                                                phi_6348_ = true;
                                                            } else {
                                                                phi_6348_ = false;
                                                            }
                                                            let _e9471 = phi_6348_;
                                                            if _e9471 {
                                                                phi_6354_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_6354_ = type_19(1u, _e9466);
                                                            }
                                                            let _e9476 = phi_6354_;
                                                            phi_6325_ = type_18(_e9476.member_1, _e9457.member_1);
                                                            phi_6368_ = type_19(1u, _e9457.member);
                                                        } else {
                                                            phi_6325_ = _e9457;
                                                            phi_6368_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e9482 = phi_6325_;
                                                        let _e9484 = phi_6368_;
                                                        let _e9487 = (bitcast<i32>(_e9484.member) != 0i);
                                                        if _e9487 {
                                                            phi_6328_ = (0.5lf * (_e9459 + (_e9450 / _e9459)));
                                                        } else {
                                                            phi_6328_ = f64();
                                                        }
                                                        let _e9492 = phi_6328_;
                                                        continue;
                                                        continuing {
                                                            phi_6324_ = _e9482;
                                                            phi_6327_ = _e9492;
                                                            break if !(_e9487);
                                                        }
                                                    }
                                                    let _e9497 = local_47;
                                                    phi_6381_ = (_e9497 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9504 = phi_6381_;
                                                let _e9512 = local_18.member[0u];
                                                if (_e9512[0] < 0.0lf) {
                                                    phi_6399_ = -(_e9512[0]);
                                                } else {
                                                    phi_6399_ = _e9512[0];
                                                }
                                                let _e9519 = phi_6399_;
                                                if (_e9512[1] < 0.0lf) {
                                                    phi_6406_ = -(_e9512[1]);
                                                } else {
                                                    phi_6406_ = _e9512[1];
                                                }
                                                let _e9523 = phi_6406_;
                                                if (_e9519 > _e9523) {
                                                    phi_6411_ = _e9519;
                                                } else {
                                                    phi_6411_ = _e9523;
                                                }
                                                let _e9526 = phi_6411_;
                                                if (_e9512[2] < 0.0lf) {
                                                    phi_6418_ = -(_e9512[2]);
                                                } else {
                                                    phi_6418_ = _e9512[2];
                                                }
                                                let _e9530 = phi_6418_;
                                                if (_e9526 > _e9530) {
                                                    phi_6423_ = _e9526;
                                                } else {
                                                    phi_6423_ = _e9530;
                                                }
                                                let _e9533 = phi_6423_;
                                                let _e9536 = local_18.member[1u];
                                                if (_e9536[0] < 0.0lf) {
                                                    phi_6436_ = -(_e9536[0]);
                                                } else {
                                                    phi_6436_ = _e9536[0];
                                                }
                                                let _e9543 = phi_6436_;
                                                if (_e9536[1] < 0.0lf) {
                                                    phi_6443_ = -(_e9536[1]);
                                                } else {
                                                    phi_6443_ = _e9536[1];
                                                }
                                                let _e9547 = phi_6443_;
                                                if (_e9543 > _e9547) {
                                                    phi_6448_ = _e9543;
                                                } else {
                                                    phi_6448_ = _e9547;
                                                }
                                                let _e9550 = phi_6448_;
                                                if (_e9536[2] < 0.0lf) {
                                                    phi_6455_ = -(_e9536[2]);
                                                } else {
                                                    phi_6455_ = _e9536[2];
                                                }
                                                let _e9554 = phi_6455_;
                                                if (_e9550 > _e9554) {
                                                    phi_6460_ = _e9550;
                                                } else {
                                                    phi_6460_ = _e9554;
                                                }
                                                let _e9557 = phi_6460_;
                                                if (_e9533 > _e9557) {
                                                    phi_6465_ = _e9533;
                                                } else {
                                                    phi_6465_ = _e9557;
                                                }
                                                let _e9560 = phi_6465_;
                                                let _e9562 = local_18.member_3;
                                                let _e9566 = local_18.member_1[0u];
                                                if (_e9566[0] < 0.0lf) {
                                                    phi_6482_ = -(_e9566[0]);
                                                } else {
                                                    phi_6482_ = _e9566[0];
                                                }
                                                let _e9573 = phi_6482_;
                                                if (_e9566[1] < 0.0lf) {
                                                    phi_6489_ = -(_e9566[1]);
                                                } else {
                                                    phi_6489_ = _e9566[1];
                                                }
                                                let _e9577 = phi_6489_;
                                                if (_e9573 > _e9577) {
                                                    phi_6494_ = _e9573;
                                                } else {
                                                    phi_6494_ = _e9577;
                                                }
                                                let _e9580 = phi_6494_;
                                                if (_e9566[2] < 0.0lf) {
                                                    phi_6501_ = -(_e9566[2]);
                                                } else {
                                                    phi_6501_ = _e9566[2];
                                                }
                                                let _e9584 = phi_6501_;
                                                if (_e9580 > _e9584) {
                                                    phi_6506_ = _e9580;
                                                } else {
                                                    phi_6506_ = _e9584;
                                                }
                                                let _e9587 = phi_6506_;
                                                let _e9590 = local_18.member_1[1u];
                                                if (_e9590[0] < 0.0lf) {
                                                    phi_6520_ = -(_e9590[0]);
                                                } else {
                                                    phi_6520_ = _e9590[0];
                                                }
                                                let _e9597 = phi_6520_;
                                                if (_e9590[1] < 0.0lf) {
                                                    phi_6527_ = -(_e9590[1]);
                                                } else {
                                                    phi_6527_ = _e9590[1];
                                                }
                                                let _e9601 = phi_6527_;
                                                if (_e9597 > _e9601) {
                                                    phi_6532_ = _e9597;
                                                } else {
                                                    phi_6532_ = _e9601;
                                                }
                                                let _e9604 = phi_6532_;
                                                if (_e9590[2] < 0.0lf) {
                                                    phi_6539_ = -(_e9590[2]);
                                                } else {
                                                    phi_6539_ = _e9590[2];
                                                }
                                                let _e9608 = phi_6539_;
                                                if (_e9604 > _e9608) {
                                                    phi_6544_ = _e9604;
                                                } else {
                                                    phi_6544_ = _e9608;
                                                }
                                                let _e9611 = phi_6544_;
                                                if (_e9587 > _e9611) {
                                                    phi_6549_ = _e9587;
                                                } else {
                                                    phi_6549_ = _e9611;
                                                }
                                                let _e9614 = phi_6549_;
                                                let _e9616 = local_18.member_3;
                                                let _e9620 = local_18.member_2[0u];
                                                if (_e9620[0] < 0.0lf) {
                                                    phi_6566_ = -(_e9620[0]);
                                                } else {
                                                    phi_6566_ = _e9620[0];
                                                }
                                                let _e9627 = phi_6566_;
                                                if (_e9620[1] < 0.0lf) {
                                                    phi_6573_ = -(_e9620[1]);
                                                } else {
                                                    phi_6573_ = _e9620[1];
                                                }
                                                let _e9631 = phi_6573_;
                                                if (_e9627 > _e9631) {
                                                    phi_6578_ = _e9627;
                                                } else {
                                                    phi_6578_ = _e9631;
                                                }
                                                let _e9634 = phi_6578_;
                                                if (_e9620[2] < 0.0lf) {
                                                    phi_6585_ = -(_e9620[2]);
                                                } else {
                                                    phi_6585_ = _e9620[2];
                                                }
                                                let _e9638 = phi_6585_;
                                                if (_e9634 > _e9638) {
                                                    phi_6590_ = _e9634;
                                                } else {
                                                    phi_6590_ = _e9638;
                                                }
                                                let _e9641 = phi_6590_;
                                                let _e9644 = local_18.member_2[1u];
                                                if (_e9644[0] < 0.0lf) {
                                                    phi_6604_ = -(_e9644[0]);
                                                } else {
                                                    phi_6604_ = _e9644[0];
                                                }
                                                let _e9651 = phi_6604_;
                                                if (_e9644[1] < 0.0lf) {
                                                    phi_6611_ = -(_e9644[1]);
                                                } else {
                                                    phi_6611_ = _e9644[1];
                                                }
                                                let _e9655 = phi_6611_;
                                                if (_e9651 > _e9655) {
                                                    phi_6616_ = _e9651;
                                                } else {
                                                    phi_6616_ = _e9655;
                                                }
                                                let _e9658 = phi_6616_;
                                                if (_e9644[2] < 0.0lf) {
                                                    phi_6623_ = -(_e9644[2]);
                                                } else {
                                                    phi_6623_ = _e9644[2];
                                                }
                                                let _e9662 = phi_6623_;
                                                if (_e9658 > _e9662) {
                                                    phi_6628_ = _e9658;
                                                } else {
                                                    phi_6628_ = _e9662;
                                                }
                                                let _e9665 = phi_6628_;
                                                if (_e9641 > _e9665) {
                                                    phi_6633_ = _e9641;
                                                } else {
                                                    phi_6633_ = _e9665;
                                                }
                                                let _e9668 = phi_6633_;
                                                let _e9670 = local_18.member_3;
                                                let _e9678 = local_18.member_3;
                                                let _e9693 = ((((_e9504 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e9560 + _e9562) + (_e9614 + _e9616)) + (_e9668 + _e9670)) * (1.1102230246251565e-16lf * f64(16f))) + (_e9678 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e9439) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                                let _e9696 = local_15.member[0u];
                                                let _e9699 = local_15.member_1[0u];
                                                if (_e9696 < 0.0lf) {
                                                    phi_6681_ = -(_e9696);
                                                } else {
                                                    phi_6681_ = _e9696;
                                                }
                                                let _e9705 = phi_6681_;
                                                if (_e9699 < 0.0lf) {
                                                    phi_6687_ = -(_e9699);
                                                } else {
                                                    phi_6687_ = _e9699;
                                                }
                                                let _e9709 = phi_6687_;
                                                phi_6699_ = type_9(1u, 4u);
                                                phi_6702_ = ((_e9696 + ((_e9699 - _e9696) * _e6945)) - ((_e9152 * f64(1.01f)) + ((_e9705 + _e9709) * (1.1102230246251565e-16lf * f64(12f)))));
                                                loop {
                                                    let _e9720 = phi_6699_;
                                                    let _e9722 = phi_6702_;
                                                    local_48 = _e9722;
                                                    local_49 = _e9722;
                                                    if (_e9720.member < _e9720.member_1) {
                                                        phi_6700_ = type_9((_e9720.member + 1u), _e9720.member_1);
                                                        phi_6725_ = type_9(1u, _e9720.member);
                                                    } else {
                                                        phi_6700_ = _e9720;
                                                        phi_6725_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e9734 = phi_6700_;
                                                    let _e9736 = phi_6725_;
                                                    let _e9740 = (bitcast<i32>(_e9736.member) != 0i);
                                                    if _e9740 {
                                                        let _e9743 = local_15.member[_e9736.member_1];
                                                        let _e9746 = local_15.member_1[_e9736.member_1];
                                                        if (_e9743 < 0.0lf) {
                                                            phi_6755_ = -(_e9743);
                                                        } else {
                                                            phi_6755_ = _e9743;
                                                        }
                                                        let _e9752 = phi_6755_;
                                                        if (_e9746 < 0.0lf) {
                                                            phi_6761_ = -(_e9746);
                                                        } else {
                                                            phi_6761_ = _e9746;
                                                        }
                                                        let _e9756 = phi_6761_;
                                                        let _e9765 = ((_e9743 + ((_e9746 - _e9743) * _e6945)) - ((_e9152 * f64(1.01f)) + ((_e9752 + _e9756) * (1.1102230246251565e-16lf * f64(12f)))));
                                                        if (_e9722 < _e9765) {
                                                            phi_6775_ = _e9722;
                                                        } else {
                                                            phi_6775_ = _e9765;
                                                        }
                                                        let _e9768 = phi_6775_;
                                                        phi_6703_ = _e9768;
                                                    } else {
                                                        phi_6703_ = f64();
                                                    }
                                                    let _e9770 = phi_6703_;
                                                    continue;
                                                    continuing {
                                                        phi_6699_ = _e9734;
                                                        phi_6702_ = _e9770;
                                                        break if !(_e9740);
                                                    }
                                                }
                                                let _e9773 = local_48;
                                                if (_e9773 > f64(0f)) {
                                                    let _e9778 = local_49;
                                                    let _e9782 = (((_e9693 - _e9778) / _e9693) * f64(2.02f));
                                                    if (_e9782 <= 2.2250738585072014e-308lf) {
                                                        if (_e9782 > 0.0lf) {
                                                            phi_6797_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_6797_ = 0.0lf;
                                                        }
                                                        let _e9834 = phi_6797_;
                                                        phi_6861_ = _e9834;
                                                    } else {
                                                        phi_6804_ = type_18(0i, 5i);
                                                        phi_6807_ = bitcast<f64>(((bitcast<u64>(_e9782) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e9789 = phi_6804_;
                                                            let _e9791 = phi_6807_;
                                                            local_50 = _e9791;
                                                            if (_e9789.member < _e9789.member_1) {
                                                                let _e9798 = (_e9789.member + 1i);
                                                                if ((false == (_e9798 > _e9789.member)) != false) {
                                                                    phi_6828_ = true;
                                                                } else {
                                                                    phi_6828_ = false;
                                                                }
                                                                let _e9803 = phi_6828_;
                                                                if _e9803 {
                                                                    phi_6834_ = type_19(0u, type_19().member_1);
                                                                } else {
                                                                    phi_6834_ = type_19(1u, _e9798);
                                                                }
                                                                let _e9808 = phi_6834_;
                                                                phi_6805_ = type_18(_e9808.member_1, _e9789.member_1);
                                                                phi_6848_ = type_19(1u, _e9789.member);
                                                            } else {
                                                                phi_6805_ = _e9789;
                                                                phi_6848_ = type_19(0u, type_19().member_1);
                                                            }
                                                            let _e9814 = phi_6805_;
                                                            let _e9816 = phi_6848_;
                                                            let _e9819 = (bitcast<i32>(_e9816.member) != 0i);
                                                            if _e9819 {
                                                                phi_6808_ = (0.5lf * (_e9791 + (_e9782 / _e9791)));
                                                            } else {
                                                                phi_6808_ = f64();
                                                            }
                                                            let _e9824 = phi_6808_;
                                                            continue;
                                                            continuing {
                                                                phi_6804_ = _e9814;
                                                                phi_6807_ = _e9824;
                                                                break if !(_e9819);
                                                            }
                                                        }
                                                        let _e9829 = local_50;
                                                        phi_6861_ = (_e9829 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e9836 = phi_6861_;
                                                    let _e9839 = ((_e9836 * _e9439) * f64(1.01f));
                                                    phi_6868_ = type_9(0u, 4u);
                                                    phi_6871_ = f64(2f);
                                                    phi_6873_ = true;
                                                    phi_6875_ = true;
                                                    loop {
                                                        let _e9842 = phi_6868_;
                                                        let _e9844 = phi_6871_;
                                                        let _e9846 = phi_6873_;
                                                        let _e9848 = phi_6875_;
                                                        local_51 = _e9844;
                                                        local_90 = _e9844;
                                                        local_52 = _e9846;
                                                        local_53 = _e9848;
                                                        local_91 = _e9848;
                                                        local_54 = _e9848;
                                                        if (_e9842.member < _e9842.member_1) {
                                                            phi_6869_ = type_9((_e9842.member + 1u), _e9842.member_1);
                                                            phi_6898_ = type_9(1u, _e9842.member);
                                                        } else {
                                                            phi_6869_ = _e9842;
                                                            phi_6898_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e9860 = phi_6869_;
                                                        let _e9862 = phi_6898_;
                                                        let _e9866 = (bitcast<i32>(_e9862.member) != 0i);
                                                        if _e9866 {
                                                            let _e9870 = local_14.member[0u][_e9862.member_1];
                                                            let _e9877 = local_14.member[1u][_e9862.member_1];
                                                            if (_e9870[0] < 0.0lf) {
                                                                phi_6935_ = -(_e9870[0]);
                                                            } else {
                                                                phi_6935_ = _e9870[0];
                                                            }
                                                            let _e9884 = phi_6935_;
                                                            if (_e9870[1] < 0.0lf) {
                                                                phi_6942_ = -(_e9870[1]);
                                                            } else {
                                                                phi_6942_ = _e9870[1];
                                                            }
                                                            let _e9888 = phi_6942_;
                                                            if (_e9870[2] < 0.0lf) {
                                                                phi_6950_ = -(_e9870[2]);
                                                            } else {
                                                                phi_6950_ = _e9870[2];
                                                            }
                                                            let _e9893 = phi_6950_;
                                                            let _e9894 = ((_e9884 + _e9888) + _e9893);
                                                            if (_e9877[0] < 0.0lf) {
                                                                phi_6958_ = -(_e9877[0]);
                                                            } else {
                                                                phi_6958_ = _e9877[0];
                                                            }
                                                            let _e9898 = phi_6958_;
                                                            if (_e9877[1] < 0.0lf) {
                                                                phi_6965_ = -(_e9877[1]);
                                                            } else {
                                                                phi_6965_ = _e9877[1];
                                                            }
                                                            let _e9902 = phi_6965_;
                                                            if (_e9877[2] < 0.0lf) {
                                                                phi_6973_ = -(_e9877[2]);
                                                            } else {
                                                                phi_6973_ = _e9877[2];
                                                            }
                                                            let _e9907 = phi_6973_;
                                                            let _e9908 = ((_e9898 + _e9902) + _e9907);
                                                            if (_e9894 > _e9908) {
                                                                phi_6979_ = _e9894;
                                                            } else {
                                                                phi_6979_ = _e9908;
                                                            }
                                                            let _e9911 = phi_6979_;
                                                            let _e9917 = (_e9877[0] - _e9870[0]);
                                                            let _e9918 = (_e9877[1] - _e9870[1]);
                                                            let _e9919 = (_e9877[2] - _e9870[2]);
                                                            if (_e9917 < 0.0lf) {
                                                                phi_6999_ = -(_e9917);
                                                            } else {
                                                                phi_6999_ = _e9917;
                                                            }
                                                            let _e9923 = phi_6999_;
                                                            if (_e9918 < 0.0lf) {
                                                                phi_7005_ = -(_e9918);
                                                            } else {
                                                                phi_7005_ = _e9918;
                                                            }
                                                            let _e9927 = phi_7005_;
                                                            if (_e9919 < 0.0lf) {
                                                                phi_7012_ = -(_e9919);
                                                            } else {
                                                                phi_7012_ = _e9919;
                                                            }
                                                            let _e9932 = phi_7012_;
                                                            let _e9941 = local_15.member[_e9862.member_1];
                                                            let _e9944 = local_15.member_1[_e9862.member_1];
                                                            if (_e9941 < 0.0lf) {
                                                                phi_7041_ = -(_e9941);
                                                            } else {
                                                                phi_7041_ = _e9941;
                                                            }
                                                            let _e9950 = phi_7041_;
                                                            if (_e9944 < 0.0lf) {
                                                                phi_7047_ = -(_e9944);
                                                            } else {
                                                                phi_7047_ = _e9944;
                                                            }
                                                            let _e9954 = phi_7047_;
                                                            let _e9959 = ((_e9152 * f64(1.01f)) + ((_e9950 + _e9954) * (1.1102230246251565e-16lf * f64(12f))));
                                                            let _e9966 = local_15.member_1[_e9862.member_1];
                                                            let _e9969 = local_15.member[_e9862.member_1];
                                                            let _e9970 = (_e9966 - _e9969);
                                                            let _e9973 = ((_e9959 + _e9959) + (_e9839 * ((((_e9923 + _e9927) + _e9932) + (_e9152 * f64(6f))) * f64(1.01f))));
                                                            let _e9976 = ((((_e9941 + ((_e9944 - _e9941) * _e6945)) - _e9959) - (_e9839 * ((_e9911 + (_e9152 * f64(3f))) * f64(1.01f)))) - _e9693);
                                                            let _e9977 = (_e9976 > 2.2250738585072014e-308lf);
                                                            let _e9978 = (_e9970 > _e9973);
                                                            if _e9978 {
                                                                phi_7084_ = true;
                                                            } else {
                                                                phi_7084_ = _e9977;
                                                            }
                                                            let _e9980 = phi_7084_;
                                                            if (_e9970 < -(_e9973)) {
                                                                phi_7091_ = true;
                                                            } else {
                                                                phi_7091_ = _e9977;
                                                            }
                                                            let _e9985 = phi_7091_;
                                                            if _e9978 {
                                                                phi_7112_ = _e9844;
                                                            } else {
                                                                if _e9977 {
                                                                    let _e9987 = (_e9973 - _e9970);
                                                                    if (_e9987 > 2.2250738585072014e-308lf) {
                                                                        phi_7104_ = _e9987;
                                                                    } else {
                                                                        phi_7104_ = 2.2250738585072014e-308lf;
                                                                    }
                                                                    let _e9990 = phi_7104_;
                                                                    let _e9991 = (_e9976 / _e9990);
                                                                    if (_e9844 < _e9991) {
                                                                        phi_7110_ = _e9844;
                                                                    } else {
                                                                        phi_7110_ = _e9991;
                                                                    }
                                                                    let _e9994 = phi_7110_;
                                                                    phi_7111_ = _e9994;
                                                                } else {
                                                                    phi_7111_ = _e9844;
                                                                }
                                                                let _e9996 = phi_7111_;
                                                                phi_7112_ = _e9996;
                                                            }
                                                            let _e9998 = phi_7112_;
                                                            phi_6872_ = _e9998;
                                                            phi_6874_ = (_e9846 && _e9985);
                                                            phi_6876_ = (_e9848 && _e9980);
                                                        } else {
                                                            phi_6872_ = f64();
                                                            phi_6874_ = bool();
                                                            phi_6876_ = bool();
                                                        }
                                                        let _e10000 = phi_6872_;
                                                        let _e10002 = phi_6874_;
                                                        let _e10004 = phi_6876_;
                                                        continue;
                                                        continuing {
                                                            phi_6868_ = _e9860;
                                                            phi_6871_ = _e10000;
                                                            phi_6873_ = _e10002;
                                                            phi_6875_ = _e10004;
                                                            break if !(_e9866);
                                                        }
                                                    }
                                                    let _e10006 = f64(2f);
                                                    let _e10008 = local_51;
                                                    if (_e10008 < _e10006) {
                                                        let _e12469 = local_90;
                                                        phi_7118_ = _e12469;
                                                    } else {
                                                        phi_7118_ = _e10006;
                                                    }
                                                    let _e10011 = phi_7118_;
                                                    let _e10013 = (_e10011 * f64(0.999f));
                                                    let _e10015 = local_52;
                                                    if _e10015 {
                                                        let _e10017 = local_53;
                                                        if _e10017 {
                                                            phi_7129_ = type_45();
                                                        } else {
                                                            phi_7129_ = type_45(_e6945, f64(2f), 1u);
                                                        }
                                                        let _e10021 = phi_7129_;
                                                        phi_7130_ = _e10021;
                                                        let _e12476 = local_91;
                                                        phi_7131_ = _e12476;
                                                    } else {
                                                        phi_7130_ = type_45();
                                                        phi_7131_ = true;
                                                    }
                                                    let _e10023 = phi_7130_;
                                                    let _e10025 = phi_7131_;
                                                    if _e10025 {
                                                        let _e10027 = local_54;
                                                        if _e10027 {
                                                            if (_e10013 > (1.1102230246251565e-16lf * f64(4096f))) {
                                                                let _e10033 = (_e6945 + _e10013);
                                                                if (_e10033 < _e573) {
                                                                    phi_7149_ = _e10033;
                                                                } else {
                                                                    phi_7149_ = _e573;
                                                                }
                                                                let _e10036 = phi_7149_;
                                                                phi_7150_ = _e10036;
                                                            } else {
                                                                phi_7150_ = _e6945;
                                                            }
                                                            let _e10038 = phi_7150_;
                                                            phi_7153_ = type_9(0u, 4u);
                                                            phi_7156_ = _e10038;
                                                            phi_7158_ = _e6945;
                                                            loop {
                                                                let _e10040 = phi_7153_;
                                                                let _e10042 = phi_7156_;
                                                                let _e10044 = phi_7158_;
                                                                local_55 = _e10042;
                                                                local_56 = _e10044;
                                                                local_57 = _e10044;
                                                                if (_e10040.member < _e10040.member_1) {
                                                                    phi_7154_ = type_9((_e10040.member + 1u), _e10040.member_1);
                                                                    phi_7181_ = type_9(1u, _e10040.member);
                                                                } else {
                                                                    phi_7154_ = _e10040;
                                                                    phi_7181_ = type_9(0u, type_9().member_1);
                                                                }
                                                                let _e10056 = phi_7154_;
                                                                let _e10058 = phi_7181_;
                                                                let _e10062 = (bitcast<i32>(_e10058.member) != 0i);
                                                                if _e10062 {
                                                                    let _e10065 = local_15.member[_e10058.member_1];
                                                                    let _e10068 = local_15.member_1[_e10058.member_1];
                                                                    let _e10071 = local_15.member[_e10058.member_1];
                                                                    let _e10077 = local_15.member_2[_e10058.member_1];
                                                                    let _e10078 = ((_e10065 + ((_e10068 - _e10071) * _e6945)) - _e10077);
                                                                    let _e10081 = local_15.member_1[_e10058.member_1];
                                                                    let _e10084 = local_15.member[_e10058.member_1];
                                                                    let _e10085 = (_e10081 - _e10084);
                                                                    if (_e10085 > f64(0f)) {
                                                                        let _e10102 = (_e6945 - (_e10078 / _e10085));
                                                                        if (_e10044 > _e10102) {
                                                                            phi_7250_ = _e10044;
                                                                        } else {
                                                                            phi_7250_ = _e10102;
                                                                        }
                                                                        let _e10105 = phi_7250_;
                                                                        phi_7270_ = _e10042;
                                                                        phi_7271_ = _e10105;
                                                                    } else {
                                                                        if (_e10078 > f64(0f)) {
                                                                            if (_e10085 < f64(0f)) {
                                                                                let _e10093 = (_e6945 - (_e10078 / _e10085));
                                                                                if (_e10042 < _e10093) {
                                                                                    phi_7267_ = _e10042;
                                                                                } else {
                                                                                    phi_7267_ = _e10093;
                                                                                }
                                                                                let _e10096 = phi_7267_;
                                                                                phi_7268_ = _e10096;
                                                                            } else {
                                                                                phi_7268_ = _e10042;
                                                                            }
                                                                            let _e10098 = phi_7268_;
                                                                            phi_7269_ = _e10098;
                                                                        } else {
                                                                            phi_7269_ = _e10042;
                                                                        }
                                                                        let _e10100 = phi_7269_;
                                                                        phi_7270_ = _e10100;
                                                                        phi_7271_ = _e10044;
                                                                    }
                                                                    let _e10107 = phi_7270_;
                                                                    let _e10109 = phi_7271_;
                                                                    phi_7157_ = _e10107;
                                                                    phi_7159_ = _e10109;
                                                                } else {
                                                                    phi_7157_ = f64();
                                                                    phi_7159_ = f64();
                                                                }
                                                                let _e10111 = phi_7157_;
                                                                let _e10113 = phi_7159_;
                                                                continue;
                                                                continuing {
                                                                    phi_7153_ = _e10056;
                                                                    phi_7156_ = _e10111;
                                                                    phi_7158_ = _e10113;
                                                                    break if !(_e10062);
                                                                }
                                                            }
                                                            let _e10116 = local_55;
                                                            let _e10118 = local_56;
                                                            let _e10123 = local_57;
                                                            let _e10124 = (_e10123 + ((_e10116 - _e10118) * f64(0.5f)));
                                                            if (_e10124 > _e6945) {
                                                                if (_e10124 <= _e10038) {
                                                                    let _e10127 = f64(0f);
                                                                    let _e10130 = local_15.member[0u];
                                                                    let _e10133 = local_15.member_1[0u];
                                                                    let _e10136 = local_15.member[0u];
                                                                    let _e10142 = local_15.member_2[0u];
                                                                    if (((_e10130 + ((_e10133 - _e10136) * _e10124)) - _e10142) > _e10127) {
                                                                        let _e10147 = local_15.member[1u];
                                                                        let _e10150 = local_15.member_1[1u];
                                                                        let _e10153 = local_15.member[1u];
                                                                        let _e10159 = local_15.member_2[1u];
                                                                        if (((_e10147 + ((_e10150 - _e10153) * _e10124)) - _e10159) > _e10127) {
                                                                            let _e10164 = local_15.member[2u];
                                                                            let _e10167 = local_15.member_1[2u];
                                                                            let _e10170 = local_15.member[2u];
                                                                            let _e10176 = local_15.member_2[2u];
                                                                            if (((_e10164 + ((_e10167 - _e10170) * _e10124)) - _e10176) > _e10127) {
                                                                                let _e10181 = local_15.member[3u];
                                                                                let _e10184 = local_15.member_1[3u];
                                                                                let _e10187 = local_15.member[3u];
                                                                                let _e10193 = local_15.member_2[3u];
                                                                                phi_7434_ = (((_e10181 + ((_e10184 - _e10187) * _e10124)) - _e10193) > _e10127);
                                                                                phi_7435_ = false;
                                                                            } else {
                                                                                phi_7434_ = bool();
                                                                                phi_7435_ = true;
                                                                            }
                                                                            let _e10197 = phi_7434_;
                                                                            let _e10199 = phi_7435_;
                                                                            phi_7436_ = _e10197;
                                                                            phi_7437_ = _e10199;
                                                                        } else {
                                                                            phi_7436_ = bool();
                                                                            phi_7437_ = true;
                                                                        }
                                                                        let _e10201 = phi_7436_;
                                                                        let _e10203 = phi_7437_;
                                                                        phi_7438_ = _e10201;
                                                                        phi_7439_ = _e10203;
                                                                    } else {
                                                                        phi_7438_ = bool();
                                                                        phi_7439_ = true;
                                                                    }
                                                                    let _e10205 = phi_7438_;
                                                                    let _e10207 = phi_7439_;
                                                                    if _e10207 {
                                                                        phi_7443_ = false;
                                                                    } else {
                                                                        phi_7443_ = _e10205;
                                                                    }
                                                                    let _e10209 = phi_7443_;
                                                                    if _e10209 {
                                                                        phi_7447_ = false;
                                                                    } else {
                                                                        phi_7447_ = true;
                                                                    }
                                                                    let _e10211 = phi_7447_;
                                                                    phi_7448_ = _e10211;
                                                                } else {
                                                                    phi_7448_ = true;
                                                                }
                                                                let _e10213 = phi_7448_;
                                                                phi_7449_ = _e10213;
                                                            } else {
                                                                phi_7449_ = true;
                                                            }
                                                            let _e10215 = phi_7449_;
                                                            if _e10215 {
                                                                phi_7454_ = f64(2f);
                                                            } else {
                                                                phi_7454_ = _e10124;
                                                            }
                                                            let _e10218 = phi_7454_;
                                                            phi_7458_ = type_45(_e10038, _e10218, 2u);
                                                            phi_7459_ = type_45();
                                                            phi_7460_ = false;
                                                        } else {
                                                            phi_7458_ = type_45();
                                                            phi_7459_ = type_45(_e6945, f64(2f), 0u);
                                                            phi_7460_ = true;
                                                        }
                                                        let _e10221 = phi_7458_;
                                                        let _e10223 = phi_7459_;
                                                        let _e10225 = phi_7460_;
                                                        phi_7461_ = _e10221;
                                                        phi_7462_ = _e10223;
                                                        phi_7463_ = _e10225;
                                                    } else {
                                                        phi_7461_ = type_45();
                                                        phi_7462_ = _e10023;
                                                        phi_7463_ = true;
                                                    }
                                                    let _e10227 = phi_7461_;
                                                    let _e10229 = phi_7462_;
                                                    let _e10231 = phi_7463_;
                                                    phi_7469_ = _e10229;
                                                    phi_7470_ = _e10227;
                                                    phi_7471_ = _e10231;
                                                } else {
                                                    phi_7469_ = type_45(_e6945, f64(2f), 0u);
                                                    phi_7470_ = type_45();
                                                    phi_7471_ = true;
                                                }
                                                let _e10233 = phi_7469_;
                                                let _e10235 = phi_7470_;
                                                let _e10237 = phi_7471_;
                                                phi_7475_ = _e10233;
                                                phi_7476_ = _e10235;
                                                phi_7477_ = false;
                                                phi_7478_ = _e10237;
                                            } else {
                                                phi_7475_ = type_45();
                                                phi_7476_ = type_45();
                                                phi_7477_ = true;
                                                phi_7478_ = false;
                                            }
                                            let _e10239 = phi_7475_;
                                            let _e10241 = phi_7476_;
                                            let _e10243 = phi_7477_;
                                            let _e10245 = phi_7478_;
                                            phi_7479_ = _e10239;
                                            phi_7480_ = _e10241;
                                            phi_7481_ = _e10243;
                                            phi_7482_ = _e10245;
                                        } else {
                                            phi_7479_ = type_45();
                                            phi_7480_ = type_45();
                                            phi_7481_ = true;
                                            phi_7482_ = false;
                                        }
                                        let _e10247 = phi_7479_;
                                        let _e10249 = phi_7480_;
                                        let _e10251 = phi_7481_;
                                        let _e10253 = phi_7482_;
                                        if _e10251 {
                                            phi_7488_ = type_45(_e6945, f64(2f), 0u);
                                            phi_7489_ = true;
                                        } else {
                                            phi_7488_ = _e10247;
                                            phi_7489_ = _e10253;
                                        }
                                        let _e10257 = phi_7488_;
                                        let _e10259 = phi_7489_;
                                        if _e10259 {
                                            phi_7493_ = _e10257;
                                        } else {
                                            phi_7493_ = _e10249;
                                        }
                                        let _e10261 = phi_7493_;
                                        if ((_e575 & 64u) != 0u) {
                                            if (_e10261.member_2 == 2u) {
                                                let _e10265 = (_e10261.member_1 <= _e573);
                                                if _e10265 {
                                                    phi_7509_ = _e10261.member_1;
                                                    phi_7510_ = _e10261.member_1;
                                                    phi_7511_ = false;
                                                } else {
                                                    phi_7509_ = f64();
                                                    phi_7510_ = f64();
                                                    phi_7511_ = true;
                                                }
                                                let _e10269 = phi_7509_;
                                                let _e10271 = phi_7510_;
                                                let _e10273 = phi_7511_;
                                                phi_7512_ = _e10269;
                                                phi_7513_ = _e10271;
                                                phi_7514_ = _e10265;
                                                phi_7515_ = _e10273;
                                                phi_7516_ = false;
                                            } else {
                                                phi_7512_ = f64();
                                                phi_7513_ = f64();
                                                phi_7514_ = false;
                                                phi_7515_ = false;
                                                phi_7516_ = true;
                                            }
                                            let _e10275 = phi_7512_;
                                            let _e10277 = phi_7513_;
                                            let _e10279 = phi_7514_;
                                            let _e10281 = phi_7515_;
                                            let _e10283 = phi_7516_;
                                            phi_7517_ = _e10275;
                                            phi_7518_ = _e10277;
                                            phi_7519_ = _e10279;
                                            phi_7520_ = _e10281;
                                            phi_7521_ = _e10283;
                                        } else {
                                            phi_7517_ = f64();
                                            phi_7518_ = f64();
                                            phi_7519_ = false;
                                            phi_7520_ = false;
                                            phi_7521_ = true;
                                        }
                                        let _e10285 = phi_7517_;
                                        let _e10287 = phi_7518_;
                                        let _e10289 = phi_7519_;
                                        let _e10291 = phi_7520_;
                                        let _e10293 = phi_7521_;
                                        phi_7522_ = _e10285;
                                        phi_7523_ = _e10261.member_2;
                                        phi_7524_ = _e10287;
                                        phi_7525_ = _e10261;
                                        phi_7526_ = _e10261.member_2;
                                        phi_7527_ = _e10261.member_2;
                                        phi_7528_ = _e10289;
                                        phi_7529_ = _e10291;
                                        phi_7530_ = _e10293;
                                    }
                                    let _e10295 = phi_7522_;
                                    let _e10297 = phi_7523_;
                                    let _e10299 = phi_7524_;
                                    let _e10301 = phi_7525_;
                                    let _e10303 = phi_7526_;
                                    let _e10305 = phi_7527_;
                                    let _e10307 = phi_7528_;
                                    let _e10309 = phi_7529_;
                                    let _e10311 = phi_7530_;
                                    phi_7531_ = _e10295;
                                    phi_7532_ = _e10297;
                                    phi_7533_ = _e10299;
                                    phi_7534_ = _e10301;
                                    phi_7535_ = _e10303;
                                    phi_7536_ = _e10305;
                                    phi_7537_ = _e10307;
                                    phi_7538_ = _e8810;
                                    phi_7539_ = _e10309;
                                    phi_7540_ = _e10311;
                                    phi_7541_ = false;
                                } else {
                                    phi_7531_ = f64();
                                    phi_7532_ = u32();
                                    phi_7533_ = f64();
                                    phi_7534_ = type_45();
                                    phi_7535_ = u32();
                                    phi_7536_ = u32();
                                    phi_7537_ = false;
                                    phi_7538_ = false;
                                    phi_7539_ = false;
                                    phi_7540_ = false;
                                    phi_7541_ = true;
                                }
                                let _e10313 = phi_7531_;
                                let _e10315 = phi_7532_;
                                let _e10317 = phi_7533_;
                                let _e10319 = phi_7534_;
                                let _e10321 = phi_7535_;
                                let _e10323 = phi_7536_;
                                let _e10325 = phi_7537_;
                                let _e10327 = phi_7538_;
                                let _e10329 = phi_7539_;
                                let _e10331 = phi_7540_;
                                let _e10333 = phi_7541_;
                                phi_7542_ = _e8807;
                                phi_2526_ = _e10313;
                                phi_2528_ = _e10315;
                                phi_2530_ = _e10317;
                                phi_7543_ = _e10319;
                                phi_7544_ = _e10321;
                                phi_7545_ = _e8807;
                                phi_7546_ = _e10323;
                                phi_7547_ = _e10325;
                                phi_7548_ = _e10327;
                                phi_7549_ = _e10329;
                                phi_7550_ = _e10331;
                                phi_7551_ = false;
                                phi_7552_ = _e10333;
                            } else {
                                phi_7542_ = f64();
                                phi_2526_ = f64();
                                phi_2528_ = u32();
                                phi_2530_ = f64();
                                phi_7543_ = type_45();
                                phi_7544_ = u32();
                                phi_7545_ = f64();
                                phi_7546_ = u32();
                                phi_7547_ = false;
                                phi_7548_ = false;
                                phi_7549_ = false;
                                phi_7550_ = false;
                                phi_7551_ = true;
                                phi_7552_ = false;
                            }
                            let _e10335 = phi_7542_;
                            let _e10337 = phi_2526_;
                            let _e10339 = phi_2528_;
                            let _e10341 = phi_2530_;
                            let _e10343 = phi_7543_;
                            let _e10345 = phi_7544_;
                            let _e10347 = phi_7545_;
                            let _e10349 = phi_7546_;
                            let _e10351 = phi_7547_;
                            let _e10353 = phi_7548_;
                            let _e10355 = phi_7549_;
                            let _e10357 = phi_7550_;
                            let _e10359 = phi_7551_;
                            let _e10361 = phi_7552_;
                            local_58 = _e10353;
                            local_92 = _e10355;
                            local_93 = _e10357;
                            local_94 = _e10359;
                            local_95 = _e10361;
                            local_59 = _e10343;
                            local_60 = _e10343;
                            local_96 = _e10345;
                            local_61 = _e10343;
                            local_97 = _e10353;
                            local_98 = _e10349;
                            local_100 = _e10347;
                            local_101 = _e10335;
                            continue;
                            continuing {
                                phi_2522_ = _e6968;
                                phi_2525_ = _e10337;
                                phi_2527_ = _e10339;
                                phi_2529_ = _e10341;
                                break if !(_e10351);
                            }
                        }
                        let _e10364 = local_58;
                        if _e10364 {
                            phi_7556_ = false;
                            phi_7557_ = false;
                            phi_7558_ = false;
                            phi_7559_ = false;
                        } else {
                            let _e12577 = local_92;
                            phi_7556_ = _e12577;
                            let _e12580 = local_93;
                            phi_7557_ = _e12580;
                            let _e12583 = local_94;
                            phi_7558_ = _e12583;
                            let _e12586 = local_95;
                            phi_7559_ = _e12586;
                        }
                        let _e10366 = phi_7556_;
                        let _e10368 = phi_7557_;
                        let _e10370 = phi_7558_;
                        let _e10372 = phi_7559_;
                        if _e10366 {
                            let _e10374 = local_59;
                            if (_e10374.member >= _e573) {
                                phi_7581_ = type_44(type_43(0u, f64()), 0u);
                            } else {
                                let _e10378 = local_60;
                                if (_e10378.member > _e564) {
                                    phi_7576_ = 0u;
                                } else {
                                    let _e12591 = local_96;
                                    phi_7576_ = _e12591;
                                }
                                let _e10382 = phi_7576_;
                                let _e10384 = local_61;
                                phi_7581_ = type_44(type_43(2u, _e10384.member), _e10382);
                            }
                            let _e10391 = phi_7581_;
                            phi_7582_ = _e10391;
                            phi_7583_ = false;
                            phi_7584_ = false;
                            phi_7585_ = false;
                            phi_7586_ = false;
                        } else {
                            phi_7582_ = type_44();
                            phi_7583_ = _e10368;
                            let _e12598 = local_97;
                            phi_7584_ = _e12598;
                            phi_7585_ = _e10370;
                            phi_7586_ = _e10372;
                        }
                        let _e10393 = phi_7582_;
                        let _e10395 = phi_7583_;
                        let _e10397 = phi_7584_;
                        let _e10399 = phi_7585_;
                        let _e10401 = phi_7586_;
                        if _e10395 {
                            let _e12603 = local_98;
                            phi_7590_ = _e12603;
                            let _e12608 = local_100;
                            phi_7591_ = _e12608;
                            phi_7592_ = true;
                            phi_7593_ = false;
                            phi_7594_ = false;
                            phi_7595_ = false;
                        } else {
                            let _e12605 = local_99;
                            phi_7590_ = _e12605;
                            let _e12610 = local_101;
                            phi_7591_ = _e12610;
                            phi_7592_ = _e10397;
                            phi_7593_ = _e10399;
                            phi_7594_ = _e10401;
                            phi_7595_ = _e10366;
                        }
                        let _e10403 = phi_7590_;
                        let _e10405 = phi_7591_;
                        let _e10407 = phi_7592_;
                        let _e10409 = phi_7593_;
                        let _e10411 = phi_7594_;
                        let _e10413 = phi_7595_;
                        if _e10407 {
                            phi_7599_ = _e10405;
                            phi_7600_ = _e10403;
                            phi_7601_ = true;
                            phi_7602_ = false;
                            phi_7603_ = false;
                        } else {
                            let _e12617 = local_102;
                            phi_7599_ = _e12617;
                            let _e12620 = local_103;
                            phi_7600_ = _e12620;
                            phi_7601_ = _e10409;
                            phi_7602_ = _e10411;
                            phi_7603_ = _e10413;
                        }
                        let _e10415 = phi_7599_;
                        let _e10417 = phi_7600_;
                        let _e10419 = phi_7601_;
                        let _e10421 = phi_7602_;
                        let _e10423 = phi_7603_;
                        if _e10419 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e555 >= (1.1102230246251565e-16lf * f64(8f))) {
                                phi_7617_ = _e555;
                            } else {
                                phi_7617_ = f64(0f);
                            }
                            let _e10432 = phi_7617_;
                            phi_7620_ = type_9(0u, 3u);
                            loop {
                                let _e10434 = phi_7620_;
                                if (_e10434.member < _e10434.member_1) {
                                    phi_7621_ = type_9((_e10434.member + 1u), _e10434.member_1);
                                    phi_7644_ = type_9(1u, _e10434.member);
                                } else {
                                    phi_7621_ = _e10434;
                                    phi_7644_ = type_9(0u, type_9().member_1);
                                }
                                let _e10446 = phi_7621_;
                                let _e10448 = phi_7644_;
                                if (bitcast<i32>(_e10448.member) != 0i) {
                                    let _e10454 = local_13[_e10448.member_1];
                                    let _e10457 = (_e10415 + (_e10432 * f64(_e10454)));
                                    if (_e10457 < _e573) {
                                        phi_7666_ = _e10457;
                                    } else {
                                        phi_7666_ = _e573;
                                    }
                                    let _e10460 = phi_7666_;
                                    let _e10463 = local_18.member[0u];
                                    let _e10469 = local_18.member[1u];
                                    let _e10485 = local_18.member_1[0u];
                                    let _e10491 = local_18.member_1[1u];
                                    let _e10507 = local_18.member_2[0u];
                                    let _e10513 = local_18.member_2[1u];
                                    let _e10527 = function_4(array<f64, 3>((_e10463[0] + ((_e10469[0] - _e10463[0]) * _e10460)), (_e10463[1] + ((_e10469[1] - _e10463[1]) * _e10460)), (_e10463[2] + ((_e10469[2] - _e10463[2]) * _e10460))), array<f64, 3>((_e10485[0] + ((_e10491[0] - _e10485[0]) * _e10460)), (_e10485[1] + ((_e10491[1] - _e10485[1]) * _e10460)), (_e10485[2] + ((_e10491[2] - _e10485[2]) * _e10460))), array<f64, 3>((_e10507[0] + ((_e10513[0] - _e10507[0]) * _e10460)), (_e10507[1] + ((_e10513[1] - _e10507[1]) * _e10460)), (_e10507[2] + ((_e10513[2] - _e10507[2]) * _e10460))), _e252.member);
                                    let _e10538 = (((_e10527[0] * _e10527[0]) + (_e10527[1] * _e10527[1])) + (_e10527[2] * _e10527[2]));
                                    if (_e10538 <= 2.2250738585072014e-308lf) {
                                        if (_e10538 > 0.0lf) {
                                            phi_7789_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_7789_ = 0.0lf;
                                        }
                                        let _e10590 = phi_7789_;
                                        phi_7853_ = _e10590;
                                    } else {
                                        phi_7796_ = type_18(0i, 5i);
                                        phi_7799_ = bitcast<f64>(((bitcast<u64>(_e10538) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e10545 = phi_7796_;
                                            let _e10547 = phi_7799_;
                                            local_62 = _e10547;
                                            if (_e10545.member < _e10545.member_1) {
                                                let _e10554 = (_e10545.member + 1i);
                                                if ((false == (_e10554 > _e10545.member)) != false) {
                                                    phi_7820_ = true;
                                                } else {
                                                    phi_7820_ = false;
                                                }
                                                let _e10559 = phi_7820_;
                                                if _e10559 {
                                                    phi_7826_ = type_19(0u, type_19().member_1);
                                                } else {
                                                    phi_7826_ = type_19(1u, _e10554);
                                                }
                                                let _e10564 = phi_7826_;
                                                phi_7797_ = type_18(_e10564.member_1, _e10545.member_1);
                                                phi_7840_ = type_19(1u, _e10545.member);
                                            } else {
                                                phi_7797_ = _e10545;
                                                phi_7840_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e10570 = phi_7797_;
                                            let _e10572 = phi_7840_;
                                            let _e10575 = (bitcast<i32>(_e10572.member) != 0i);
                                            if _e10575 {
                                                phi_7800_ = (0.5lf * (_e10547 + (_e10538 / _e10547)));
                                            } else {
                                                phi_7800_ = f64();
                                            }
                                            let _e10580 = phi_7800_;
                                            continue;
                                            continuing {
                                                phi_7796_ = _e10570;
                                                phi_7799_ = _e10580;
                                                break if !(_e10575);
                                            }
                                        }
                                        let _e10585 = local_62;
                                        phi_7853_ = (_e10585 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e10592 = phi_7853_;
                                    let _e10600 = local_18.member[0u];
                                    if (_e10600[0] < 0.0lf) {
                                        phi_7871_ = -(_e10600[0]);
                                    } else {
                                        phi_7871_ = _e10600[0];
                                    }
                                    let _e10607 = phi_7871_;
                                    if (_e10600[1] < 0.0lf) {
                                        phi_7878_ = -(_e10600[1]);
                                    } else {
                                        phi_7878_ = _e10600[1];
                                    }
                                    let _e10611 = phi_7878_;
                                    if (_e10607 > _e10611) {
                                        phi_7883_ = _e10607;
                                    } else {
                                        phi_7883_ = _e10611;
                                    }
                                    let _e10614 = phi_7883_;
                                    if (_e10600[2] < 0.0lf) {
                                        phi_7890_ = -(_e10600[2]);
                                    } else {
                                        phi_7890_ = _e10600[2];
                                    }
                                    let _e10618 = phi_7890_;
                                    if (_e10614 > _e10618) {
                                        phi_7895_ = _e10614;
                                    } else {
                                        phi_7895_ = _e10618;
                                    }
                                    let _e10621 = phi_7895_;
                                    let _e10624 = local_18.member[1u];
                                    if (_e10624[0] < 0.0lf) {
                                        phi_7908_ = -(_e10624[0]);
                                    } else {
                                        phi_7908_ = _e10624[0];
                                    }
                                    let _e10631 = phi_7908_;
                                    if (_e10624[1] < 0.0lf) {
                                        phi_7915_ = -(_e10624[1]);
                                    } else {
                                        phi_7915_ = _e10624[1];
                                    }
                                    let _e10635 = phi_7915_;
                                    if (_e10631 > _e10635) {
                                        phi_7920_ = _e10631;
                                    } else {
                                        phi_7920_ = _e10635;
                                    }
                                    let _e10638 = phi_7920_;
                                    if (_e10624[2] < 0.0lf) {
                                        phi_7927_ = -(_e10624[2]);
                                    } else {
                                        phi_7927_ = _e10624[2];
                                    }
                                    let _e10642 = phi_7927_;
                                    if (_e10638 > _e10642) {
                                        phi_7932_ = _e10638;
                                    } else {
                                        phi_7932_ = _e10642;
                                    }
                                    let _e10645 = phi_7932_;
                                    if (_e10621 > _e10645) {
                                        phi_7937_ = _e10621;
                                    } else {
                                        phi_7937_ = _e10645;
                                    }
                                    let _e10648 = phi_7937_;
                                    let _e10650 = local_18.member_3;
                                    let _e10654 = local_18.member_1[0u];
                                    if (_e10654[0] < 0.0lf) {
                                        phi_7954_ = -(_e10654[0]);
                                    } else {
                                        phi_7954_ = _e10654[0];
                                    }
                                    let _e10661 = phi_7954_;
                                    if (_e10654[1] < 0.0lf) {
                                        phi_7961_ = -(_e10654[1]);
                                    } else {
                                        phi_7961_ = _e10654[1];
                                    }
                                    let _e10665 = phi_7961_;
                                    if (_e10661 > _e10665) {
                                        phi_7966_ = _e10661;
                                    } else {
                                        phi_7966_ = _e10665;
                                    }
                                    let _e10668 = phi_7966_;
                                    if (_e10654[2] < 0.0lf) {
                                        phi_7973_ = -(_e10654[2]);
                                    } else {
                                        phi_7973_ = _e10654[2];
                                    }
                                    let _e10672 = phi_7973_;
                                    if (_e10668 > _e10672) {
                                        phi_7978_ = _e10668;
                                    } else {
                                        phi_7978_ = _e10672;
                                    }
                                    let _e10675 = phi_7978_;
                                    let _e10678 = local_18.member_1[1u];
                                    if (_e10678[0] < 0.0lf) {
                                        phi_7992_ = -(_e10678[0]);
                                    } else {
                                        phi_7992_ = _e10678[0];
                                    }
                                    let _e10685 = phi_7992_;
                                    if (_e10678[1] < 0.0lf) {
                                        phi_7999_ = -(_e10678[1]);
                                    } else {
                                        phi_7999_ = _e10678[1];
                                    }
                                    let _e10689 = phi_7999_;
                                    if (_e10685 > _e10689) {
                                        phi_8004_ = _e10685;
                                    } else {
                                        phi_8004_ = _e10689;
                                    }
                                    let _e10692 = phi_8004_;
                                    if (_e10678[2] < 0.0lf) {
                                        phi_8011_ = -(_e10678[2]);
                                    } else {
                                        phi_8011_ = _e10678[2];
                                    }
                                    let _e10696 = phi_8011_;
                                    if (_e10692 > _e10696) {
                                        phi_8016_ = _e10692;
                                    } else {
                                        phi_8016_ = _e10696;
                                    }
                                    let _e10699 = phi_8016_;
                                    if (_e10675 > _e10699) {
                                        phi_8021_ = _e10675;
                                    } else {
                                        phi_8021_ = _e10699;
                                    }
                                    let _e10702 = phi_8021_;
                                    let _e10704 = local_18.member_3;
                                    let _e10708 = local_18.member_2[0u];
                                    if (_e10708[0] < 0.0lf) {
                                        phi_8038_ = -(_e10708[0]);
                                    } else {
                                        phi_8038_ = _e10708[0];
                                    }
                                    let _e10715 = phi_8038_;
                                    if (_e10708[1] < 0.0lf) {
                                        phi_8045_ = -(_e10708[1]);
                                    } else {
                                        phi_8045_ = _e10708[1];
                                    }
                                    let _e10719 = phi_8045_;
                                    if (_e10715 > _e10719) {
                                        phi_8050_ = _e10715;
                                    } else {
                                        phi_8050_ = _e10719;
                                    }
                                    let _e10722 = phi_8050_;
                                    if (_e10708[2] < 0.0lf) {
                                        phi_8057_ = -(_e10708[2]);
                                    } else {
                                        phi_8057_ = _e10708[2];
                                    }
                                    let _e10726 = phi_8057_;
                                    if (_e10722 > _e10726) {
                                        phi_8062_ = _e10722;
                                    } else {
                                        phi_8062_ = _e10726;
                                    }
                                    let _e10729 = phi_8062_;
                                    let _e10732 = local_18.member_2[1u];
                                    if (_e10732[0] < 0.0lf) {
                                        phi_8076_ = -(_e10732[0]);
                                    } else {
                                        phi_8076_ = _e10732[0];
                                    }
                                    let _e10739 = phi_8076_;
                                    if (_e10732[1] < 0.0lf) {
                                        phi_8083_ = -(_e10732[1]);
                                    } else {
                                        phi_8083_ = _e10732[1];
                                    }
                                    let _e10743 = phi_8083_;
                                    if (_e10739 > _e10743) {
                                        phi_8088_ = _e10739;
                                    } else {
                                        phi_8088_ = _e10743;
                                    }
                                    let _e10746 = phi_8088_;
                                    if (_e10732[2] < 0.0lf) {
                                        phi_8095_ = -(_e10732[2]);
                                    } else {
                                        phi_8095_ = _e10732[2];
                                    }
                                    let _e10750 = phi_8095_;
                                    if (_e10746 > _e10750) {
                                        phi_8100_ = _e10746;
                                    } else {
                                        phi_8100_ = _e10750;
                                    }
                                    let _e10753 = phi_8100_;
                                    if (_e10729 > _e10753) {
                                        phi_8105_ = _e10729;
                                    } else {
                                        phi_8105_ = _e10753;
                                    }
                                    let _e10756 = phi_8105_;
                                    let _e10758 = local_18.member_3;
                                    let _e10766 = local_18.member_3;
                                    let _e10776 = (((_e10592 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e10648 + _e10650) + (_e10702 + _e10704)) + (_e10756 + _e10758)) * (1.1102230246251565e-16lf * f64(16f))) + (_e10766 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e841.member_1);
                                    if _e10776 {
                                        phi_8129_ = false;
                                    } else {
                                        phi_8129_ = true;
                                    }
                                    let _e10778 = phi_8129_;
                                    phi_8130_ = _e10778;
                                    phi_8131_ = _e10776;
                                } else {
                                    phi_8130_ = false;
                                    phi_8131_ = false;
                                }
                                let _e10780 = phi_8130_;
                                let _e10782 = phi_8131_;
                                local_63 = _e10782;
                                continue;
                                continuing {
                                    phi_7620_ = _e10446;
                                    break if !(_e10780);
                                }
                            }
                            let _e10785 = local_63;
                            if _e10785 {
                                if (_e10415 > _e564) {
                                    phi_8139_ = 1u;
                                } else {
                                    phi_8139_ = _e10417;
                                }
                                let _e10788 = phi_8139_;
                                phi_8143_ = type_44(type_43(1u, _e10415), _e10788);
                                phi_8144_ = false;
                            } else {
                                phi_8143_ = type_44();
                                phi_8144_ = true;
                            }
                            let _e10792 = phi_8143_;
                            let _e10794 = phi_8144_;
                            if _e10794 {
                                if (_e10415 > _e564) {
                                    phi_8152_ = 0u;
                                } else {
                                    phi_8152_ = _e10417;
                                }
                                let _e10797 = phi_8152_;
                                phi_8156_ = type_44(type_43(2u, _e10415), _e10797);
                            } else {
                                phi_8156_ = _e10792;
                            }
                            let _e10801 = phi_8156_;
                            phi_8157_ = _e10801;
                            phi_8158_ = false;
                            phi_8159_ = false;
                        } else {
                            phi_8157_ = type_44();
                            phi_8158_ = _e10421;
                            phi_8159_ = _e10423;
                        }
                        let _e10803 = phi_8157_;
                        let _e10805 = phi_8158_;
                        let _e10807 = phi_8159_;
                        if _e10805 {
                            phi_8166_ = type_44(type_43(0u, f64()), 0u);
                            phi_8167_ = true;
                        } else {
                            phi_8166_ = _e10393;
                            phi_8167_ = _e10807;
                        }
                        let _e10811 = phi_8166_;
                        let _e10813 = phi_8167_;
                        phi_8171_ = _e10811;
                        phi_8172_ = _e10803;
                        phi_8173_ = _e10813;
                    } else {
                        phi_8171_ = _e6935;
                        phi_8172_ = type_44();
                        phi_8173_ = true;
                    }
                    let _e10815 = phi_8171_;
                    let _e10817 = phi_8172_;
                    let _e10819 = phi_8173_;
                    if _e10819 {
                        phi_8177_ = _e10815;
                    } else {
                        phi_8177_ = _e10817;
                    }
                    let _e10821 = phi_8177_;
                    phi_15844_ = _e10821;
                } else {
                    let _e884 = f64(0f);
                    let _e887 = local_18.member_1[0u];
                    let _e893 = local_18.member_2[0u];
                    let _e899 = ((_e887[1] * _e893[2]) - (_e887[2] * _e893[1]));
                    let _e902 = ((_e887[2] * _e893[0]) - (_e887[0] * _e893[2]));
                    let _e905 = ((_e887[0] * _e893[1]) - (_e887[1] * _e893[0]));
                    let _e908 = local_18.member_1[1u];
                    let _e914 = local_18.member_2[1u];
                    let _e920 = ((_e908[1] * _e914[2]) - (_e908[2] * _e914[1]));
                    let _e923 = ((_e908[2] * _e914[0]) - (_e908[0] * _e914[2]));
                    let _e926 = ((_e908[0] * _e914[1]) - (_e908[1] * _e914[0]));
                    let _e929 = local_18.member_1[0u];
                    let _e935 = local_18.member_2[1u];
                    let _e950 = local_18.member_1[1u];
                    let _e956 = local_18.member_2[0u];
                    let _e969 = (((_e929[1] * _e935[2]) - (_e929[2] * _e935[1])) + ((_e950[1] * _e956[2]) - (_e950[2] * _e956[1])));
                    let _e970 = (((_e929[2] * _e935[0]) - (_e929[0] * _e935[2])) + ((_e950[2] * _e956[0]) - (_e950[0] * _e956[2])));
                    let _e971 = (((_e929[0] * _e935[1]) - (_e929[1] * _e935[0])) + ((_e950[0] * _e956[1]) - (_e950[1] * _e956[0])));
                    let _e974 = local_18.member[0u];
                    let _e982 = (((_e974[0] * _e899) + (_e974[1] * _e902)) + (_e974[2] * _e905));
                    let _e985 = local_18.member[1u];
                    let _e996 = local_18.member[0u];
                    let _e1005 = ((((_e985[0] * _e899) + (_e985[1] * _e902)) + (_e985[2] * _e905)) + (((_e996[0] * _e969) + (_e996[1] * _e970)) + (_e996[2] * _e971)));
                    let _e1008 = local_18.member[0u];
                    let _e1019 = local_18.member[1u];
                    let _e1028 = ((((_e1008[0] * _e920) + (_e1008[1] * _e923)) + (_e1008[2] * _e926)) + (((_e1019[0] * _e969) + (_e1019[1] * _e970)) + (_e1019[2] * _e971)));
                    let _e1031 = local_18.member[1u];
                    let _e1039 = (((_e1031[0] * _e920) + (_e1031[1] * _e923)) + (_e1031[2] * _e926));
                    let _e1042 = local_18.member[0u];
                    if (_e1042[0] < 0.0lf) {
                        phi_8420_ = -(_e1042[0]);
                    } else {
                        phi_8420_ = _e1042[0];
                    }
                    let _e1049 = phi_8420_;
                    if (_e1042[1] < 0.0lf) {
                        phi_8427_ = -(_e1042[1]);
                    } else {
                        phi_8427_ = _e1042[1];
                    }
                    let _e1053 = phi_8427_;
                    if (_e1049 > _e1053) {
                        phi_8432_ = _e1049;
                    } else {
                        phi_8432_ = _e1053;
                    }
                    let _e1056 = phi_8432_;
                    if (_e1042[2] < 0.0lf) {
                        phi_8439_ = -(_e1042[2]);
                    } else {
                        phi_8439_ = _e1042[2];
                    }
                    let _e1060 = phi_8439_;
                    if (_e1056 > _e1060) {
                        phi_8444_ = _e1056;
                    } else {
                        phi_8444_ = _e1060;
                    }
                    let _e1063 = phi_8444_;
                    let _e1066 = local_18.member[1u];
                    if (_e1066[0] < 0.0lf) {
                        phi_8457_ = -(_e1066[0]);
                    } else {
                        phi_8457_ = _e1066[0];
                    }
                    let _e1073 = phi_8457_;
                    if (_e1066[1] < 0.0lf) {
                        phi_8464_ = -(_e1066[1]);
                    } else {
                        phi_8464_ = _e1066[1];
                    }
                    let _e1077 = phi_8464_;
                    if (_e1073 > _e1077) {
                        phi_8469_ = _e1073;
                    } else {
                        phi_8469_ = _e1077;
                    }
                    let _e1080 = phi_8469_;
                    if (_e1066[2] < 0.0lf) {
                        phi_8476_ = -(_e1066[2]);
                    } else {
                        phi_8476_ = _e1066[2];
                    }
                    let _e1084 = phi_8476_;
                    if (_e1080 > _e1084) {
                        phi_8481_ = _e1080;
                    } else {
                        phi_8481_ = _e1084;
                    }
                    let _e1087 = phi_8481_;
                    if (_e1063 > _e1087) {
                        phi_8486_ = _e1063;
                    } else {
                        phi_8486_ = _e1087;
                    }
                    let _e1090 = phi_8486_;
                    let _e1092 = local_18.member_3;
                    let _e1093 = (_e1090 + _e1092);
                    let _e1096 = local_18.member_1[0u];
                    if (_e1096[0] < 0.0lf) {
                        phi_8503_ = -(_e1096[0]);
                    } else {
                        phi_8503_ = _e1096[0];
                    }
                    let _e1103 = phi_8503_;
                    if (_e1096[1] < 0.0lf) {
                        phi_8510_ = -(_e1096[1]);
                    } else {
                        phi_8510_ = _e1096[1];
                    }
                    let _e1107 = phi_8510_;
                    if (_e1103 > _e1107) {
                        phi_8515_ = _e1103;
                    } else {
                        phi_8515_ = _e1107;
                    }
                    let _e1110 = phi_8515_;
                    if (_e1096[2] < 0.0lf) {
                        phi_8522_ = -(_e1096[2]);
                    } else {
                        phi_8522_ = _e1096[2];
                    }
                    let _e1114 = phi_8522_;
                    if (_e1110 > _e1114) {
                        phi_8527_ = _e1110;
                    } else {
                        phi_8527_ = _e1114;
                    }
                    let _e1117 = phi_8527_;
                    let _e1120 = local_18.member_1[1u];
                    if (_e1120[0] < 0.0lf) {
                        phi_8541_ = -(_e1120[0]);
                    } else {
                        phi_8541_ = _e1120[0];
                    }
                    let _e1127 = phi_8541_;
                    if (_e1120[1] < 0.0lf) {
                        phi_8548_ = -(_e1120[1]);
                    } else {
                        phi_8548_ = _e1120[1];
                    }
                    let _e1131 = phi_8548_;
                    if (_e1127 > _e1131) {
                        phi_8553_ = _e1127;
                    } else {
                        phi_8553_ = _e1131;
                    }
                    let _e1134 = phi_8553_;
                    if (_e1120[2] < 0.0lf) {
                        phi_8560_ = -(_e1120[2]);
                    } else {
                        phi_8560_ = _e1120[2];
                    }
                    let _e1138 = phi_8560_;
                    if (_e1134 > _e1138) {
                        phi_8565_ = _e1134;
                    } else {
                        phi_8565_ = _e1138;
                    }
                    let _e1141 = phi_8565_;
                    if (_e1117 > _e1141) {
                        phi_8570_ = _e1117;
                    } else {
                        phi_8570_ = _e1141;
                    }
                    let _e1144 = phi_8570_;
                    let _e1146 = local_18.member_3;
                    let _e1147 = (_e1144 + _e1146);
                    let _e1150 = local_18.member_2[0u];
                    if (_e1150[0] < 0.0lf) {
                        phi_8587_ = -(_e1150[0]);
                    } else {
                        phi_8587_ = _e1150[0];
                    }
                    let _e1157 = phi_8587_;
                    if (_e1150[1] < 0.0lf) {
                        phi_8594_ = -(_e1150[1]);
                    } else {
                        phi_8594_ = _e1150[1];
                    }
                    let _e1161 = phi_8594_;
                    if (_e1157 > _e1161) {
                        phi_8599_ = _e1157;
                    } else {
                        phi_8599_ = _e1161;
                    }
                    let _e1164 = phi_8599_;
                    if (_e1150[2] < 0.0lf) {
                        phi_8606_ = -(_e1150[2]);
                    } else {
                        phi_8606_ = _e1150[2];
                    }
                    let _e1168 = phi_8606_;
                    if (_e1164 > _e1168) {
                        phi_8611_ = _e1164;
                    } else {
                        phi_8611_ = _e1168;
                    }
                    let _e1171 = phi_8611_;
                    let _e1174 = local_18.member_2[1u];
                    if (_e1174[0] < 0.0lf) {
                        phi_8625_ = -(_e1174[0]);
                    } else {
                        phi_8625_ = _e1174[0];
                    }
                    let _e1181 = phi_8625_;
                    if (_e1174[1] < 0.0lf) {
                        phi_8632_ = -(_e1174[1]);
                    } else {
                        phi_8632_ = _e1174[1];
                    }
                    let _e1185 = phi_8632_;
                    if (_e1181 > _e1185) {
                        phi_8637_ = _e1181;
                    } else {
                        phi_8637_ = _e1185;
                    }
                    let _e1188 = phi_8637_;
                    if (_e1174[2] < 0.0lf) {
                        phi_8644_ = -(_e1174[2]);
                    } else {
                        phi_8644_ = _e1174[2];
                    }
                    let _e1192 = phi_8644_;
                    if (_e1188 > _e1192) {
                        phi_8649_ = _e1188;
                    } else {
                        phi_8649_ = _e1192;
                    }
                    let _e1195 = phi_8649_;
                    if (_e1171 > _e1195) {
                        phi_8654_ = _e1171;
                    } else {
                        phi_8654_ = _e1195;
                    }
                    let _e1198 = phi_8654_;
                    let _e1200 = local_18.member_3;
                    let _e1201 = (_e1198 + _e1200);
                    let _e1202 = f64(1f);
                    let _e1203 = f64(8f);
                    let _e1205 = ((_e1147 * _e1203) * _e1201);
                    let _e1213 = local_18.member_3;
                    if (_e899 < 0.0lf) {
                        phi_8691_ = -(_e899);
                    } else {
                        phi_8691_ = _e899;
                    }
                    let _e1233 = phi_8691_;
                    if (_e902 < 0.0lf) {
                        phi_8697_ = -(_e902);
                    } else {
                        phi_8697_ = _e902;
                    }
                    let _e1237 = phi_8697_;
                    if (_e905 < 0.0lf) {
                        phi_8704_ = -(_e905);
                    } else {
                        phi_8704_ = _e905;
                    }
                    let _e1242 = phi_8704_;
                    let _e1243 = ((_e1233 + _e1237) + _e1242);
                    if (_e920 < 0.0lf) {
                        phi_8711_ = -(_e920);
                    } else {
                        phi_8711_ = _e920;
                    }
                    let _e1247 = phi_8711_;
                    if (_e923 < 0.0lf) {
                        phi_8717_ = -(_e923);
                    } else {
                        phi_8717_ = _e923;
                    }
                    let _e1251 = phi_8717_;
                    if (_e926 < 0.0lf) {
                        phi_8724_ = -(_e926);
                    } else {
                        phi_8724_ = _e926;
                    }
                    let _e1256 = phi_8724_;
                    let _e1257 = ((_e1247 + _e1251) + _e1256);
                    if (_e1243 > _e1257) {
                        phi_8730_ = _e1243;
                    } else {
                        phi_8730_ = _e1257;
                    }
                    let _e1260 = phi_8730_;
                    if (_e969 < 0.0lf) {
                        phi_8736_ = -(_e969);
                    } else {
                        phi_8736_ = _e969;
                    }
                    let _e1264 = phi_8736_;
                    if (_e970 < 0.0lf) {
                        phi_8742_ = -(_e970);
                    } else {
                        phi_8742_ = _e970;
                    }
                    let _e1268 = phi_8742_;
                    if (_e971 < 0.0lf) {
                        phi_8749_ = -(_e971);
                    } else {
                        phi_8749_ = _e971;
                    }
                    let _e1273 = phi_8749_;
                    let _e1275 = (((_e1264 + _e1268) + _e1273) * f64(0.5f));
                    if (_e1260 > _e1275) {
                        phi_8756_ = _e1260;
                    } else {
                        phi_8756_ = _e1275;
                    }
                    let _e1278 = phi_8756_;
                    let _e1284 = local_18.member_3;
                    let _e1298 = (((((_e1093 * _e1203) * _e1205) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1213 * f64(19f)) * ((_e1093 * (_e1147 + _e1201)) + (_e1147 * _e1201)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1202 + _e1093) * ((_e1202 + _e1147) * (_e1202 + _e1201)))));
                    let _e1299 = f64(3f);
                    let _e1300 = (_e982 * _e1299);
                    let _e1301 = (_e1039 * _e1299);
                    if (_e1300 < _e1301) {
                        phi_8784_ = _e1300;
                    } else {
                        phi_8784_ = _e1301;
                    }
                    let _e1304 = phi_8784_;
                    if (_e1005 < _e1028) {
                        phi_8789_ = _e1005;
                    } else {
                        phi_8789_ = _e1028;
                    }
                    let _e1307 = phi_8789_;
                    if (_e1304 < _e1307) {
                        phi_8794_ = _e1304;
                    } else {
                        phi_8794_ = _e1307;
                    }
                    let _e1310 = phi_8794_;
                    if (_e1300 > _e1301) {
                        phi_8799_ = _e1300;
                    } else {
                        phi_8799_ = _e1301;
                    }
                    let _e1313 = phi_8799_;
                    if (_e1005 > _e1028) {
                        phi_8804_ = _e1005;
                    } else {
                        phi_8804_ = _e1028;
                    }
                    let _e1316 = phi_8804_;
                    if (_e1313 > _e1316) {
                        phi_8809_ = _e1313;
                    } else {
                        phi_8809_ = _e1316;
                    }
                    let _e1319 = phi_8809_;
                    let _e1325 = -(_e1319);
                    if (_e1310 > _e1325) {
                        phi_8820_ = _e1310;
                    } else {
                        phi_8820_ = _e1325;
                    }
                    let _e1328 = phi_8820_;
                    if ((_e1328 - (_e1298 + ((_e884 * (((_e1278 + (_e1205 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1284 * f64(6f)) * (_e1147 + _e1201))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1202 + _e1147) * (_e1202 + _e1201))))) * f64((3f * 1.0001f))))) > _e884) {
                        phi_15814_ = type_43(0u, type_43().member_1);
                        phi_15815_ = type_43();
                        phi_15816_ = true;
                    } else {
                        if (_e982 < 0.0lf) {
                            phi_8834_ = -(_e982);
                        } else {
                            phi_8834_ = _e982;
                        }
                        let _e1336 = phi_8834_;
                        if (_e1005 < 0.0lf) {
                            phi_8840_ = -(_e1005);
                        } else {
                            phi_8840_ = _e1005;
                        }
                        let _e1340 = phi_8840_;
                        if (_e1336 > _e1340) {
                            phi_8845_ = _e1336;
                        } else {
                            phi_8845_ = _e1340;
                        }
                        let _e1343 = phi_8845_;
                        if (_e1028 < 0.0lf) {
                            phi_8851_ = -(_e1028);
                        } else {
                            phi_8851_ = _e1028;
                        }
                        let _e1347 = phi_8851_;
                        if (_e1039 < 0.0lf) {
                            phi_8857_ = -(_e1039);
                        } else {
                            phi_8857_ = _e1039;
                        }
                        let _e1351 = phi_8857_;
                        if (_e1347 > _e1351) {
                            phi_8862_ = _e1347;
                        } else {
                            phi_8862_ = _e1351;
                        }
                        let _e1354 = phi_8862_;
                        if (_e1343 > _e1354) {
                            phi_8867_ = _e1343;
                        } else {
                            phi_8867_ = _e1354;
                        }
                        let _e1357 = phi_8867_;
                        let _e1359 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1360 = f64(1f);
                        if (_e1357 >= _e1359) {
                            phi_8877_ = (_e1357 <= (_e1360 / _e1359));
                        } else {
                            phi_8877_ = false;
                        }
                        let _e1365 = phi_8877_;
                        if _e1365 {
                            phi_8884_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_8884_ = f64(2f);
                        }
                        let _e1370 = phi_8884_;
                        let _e1372 = ((_e1298 * f64(0.34f)) + (_e1357 * _e1370));
                        if _e1365 {
                            phi_8892_ = (_e1360 / _e1357);
                        } else {
                            phi_8892_ = f64(0f);
                        }
                        let _e1376 = phi_8892_;
                        let _e1377 = f64(0.00000000000022737368f);
                        let _e1379 = (_e555 * f64(0.0625f));
                        if (_e1377 < _e1379) {
                            phi_8900_ = _e1377;
                        } else {
                            phi_8900_ = _e1379;
                        }
                        let _e1382 = phi_8900_;
                        let _e1384 = (f64(1f) - _e564);
                        let _e1395 = ((((_e982 * _e1384) + (_e1005 * _e564)) * (_e1384 * _e1384)) + (((_e1028 * _e1384) + (_e1039 * _e564)) * (_e564 * _e564)));
                        if (_e1395 < 0.0lf) {
                            phi_8919_ = -(_e1395);
                        } else {
                            phi_8919_ = _e1395;
                        }
                        let _e1399 = phi_8919_;
                        if !((_e1399 > _e1372)) {
                            let _e1402 = f64(0f);
                            let _e1405 = local_18.member[0u];
                            let _e1412 = local_18.member_1[0u];
                            let _e1418 = local_18.member_2[0u];
                            let _e1422 = (_e1405[0] - _e1412[0]);
                            let _e1423 = (_e1405[1] - _e1412[1]);
                            let _e1424 = (_e1405[2] - _e1412[2]);
                            if (_e252.member == 0u) {
                                phi_8981_ = array<f64, 3>(_e1405[0], _e1405[1], _e1405[2]);
                            } else {
                                phi_8981_ = array<f64, 3>((_e1422 - _e1418[0]), (_e1423 - _e1418[1]), (_e1424 - _e1418[2]));
                            }
                            let _e1431 = phi_8981_;
                            let _e1432 = (_e1405[0] - _e1418[0]);
                            let _e1433 = (_e1405[1] - _e1418[1]);
                            let _e1434 = (_e1405[2] - _e1418[2]);
                            let _e1437 = local_18.member[1u];
                            let _e1444 = local_18.member_1[1u];
                            let _e1450 = local_18.member_2[1u];
                            let _e1454 = (_e1437[0] - _e1444[0]);
                            let _e1455 = (_e1437[1] - _e1444[1]);
                            let _e1456 = (_e1437[2] - _e1444[2]);
                            if (_e252.member == 0u) {
                                phi_9046_ = array<f64, 3>(_e1437[0], _e1437[1], _e1437[2]);
                            } else {
                                phi_9046_ = array<f64, 3>((_e1454 - _e1450[0]), (_e1455 - _e1450[1]), (_e1456 - _e1450[2]));
                            }
                            let _e1463 = phi_9046_;
                            let _e1464 = (_e1437[0] - _e1450[0]);
                            let _e1465 = (_e1437[1] - _e1450[1]);
                            let _e1466 = (_e1437[2] - _e1450[2]);
                            let _e1469 = local_18.member[0u];
                            if (_e1469[0] < 0.0lf) {
                                phi_9068_ = -(_e1469[0]);
                            } else {
                                phi_9068_ = _e1469[0];
                            }
                            let _e1476 = phi_9068_;
                            if (_e1469[1] < 0.0lf) {
                                phi_9075_ = -(_e1469[1]);
                            } else {
                                phi_9075_ = _e1469[1];
                            }
                            let _e1480 = phi_9075_;
                            if (_e1476 > _e1480) {
                                phi_9080_ = _e1476;
                            } else {
                                phi_9080_ = _e1480;
                            }
                            let _e1483 = phi_9080_;
                            if (_e1469[2] < 0.0lf) {
                                phi_9087_ = -(_e1469[2]);
                            } else {
                                phi_9087_ = _e1469[2];
                            }
                            let _e1487 = phi_9087_;
                            if (_e1483 > _e1487) {
                                phi_9092_ = _e1483;
                            } else {
                                phi_9092_ = _e1487;
                            }
                            let _e1490 = phi_9092_;
                            let _e1493 = local_18.member[1u];
                            if (_e1493[0] < 0.0lf) {
                                phi_9105_ = -(_e1493[0]);
                            } else {
                                phi_9105_ = _e1493[0];
                            }
                            let _e1500 = phi_9105_;
                            if (_e1493[1] < 0.0lf) {
                                phi_9112_ = -(_e1493[1]);
                            } else {
                                phi_9112_ = _e1493[1];
                            }
                            let _e1504 = phi_9112_;
                            if (_e1500 > _e1504) {
                                phi_9117_ = _e1500;
                            } else {
                                phi_9117_ = _e1504;
                            }
                            let _e1507 = phi_9117_;
                            if (_e1493[2] < 0.0lf) {
                                phi_9124_ = -(_e1493[2]);
                            } else {
                                phi_9124_ = _e1493[2];
                            }
                            let _e1511 = phi_9124_;
                            if (_e1507 > _e1511) {
                                phi_9129_ = _e1507;
                            } else {
                                phi_9129_ = _e1511;
                            }
                            let _e1514 = phi_9129_;
                            if (_e1490 > _e1514) {
                                phi_9134_ = _e1490;
                            } else {
                                phi_9134_ = _e1514;
                            }
                            let _e1517 = phi_9134_;
                            let _e1519 = local_18.member_3;
                            let _e1523 = local_18.member_1[0u];
                            if (_e1523[0] < 0.0lf) {
                                phi_9151_ = -(_e1523[0]);
                            } else {
                                phi_9151_ = _e1523[0];
                            }
                            let _e1530 = phi_9151_;
                            if (_e1523[1] < 0.0lf) {
                                phi_9158_ = -(_e1523[1]);
                            } else {
                                phi_9158_ = _e1523[1];
                            }
                            let _e1534 = phi_9158_;
                            if (_e1530 > _e1534) {
                                phi_9163_ = _e1530;
                            } else {
                                phi_9163_ = _e1534;
                            }
                            let _e1537 = phi_9163_;
                            if (_e1523[2] < 0.0lf) {
                                phi_9170_ = -(_e1523[2]);
                            } else {
                                phi_9170_ = _e1523[2];
                            }
                            let _e1541 = phi_9170_;
                            if (_e1537 > _e1541) {
                                phi_9175_ = _e1537;
                            } else {
                                phi_9175_ = _e1541;
                            }
                            let _e1544 = phi_9175_;
                            let _e1547 = local_18.member_1[1u];
                            if (_e1547[0] < 0.0lf) {
                                phi_9189_ = -(_e1547[0]);
                            } else {
                                phi_9189_ = _e1547[0];
                            }
                            let _e1554 = phi_9189_;
                            if (_e1547[1] < 0.0lf) {
                                phi_9196_ = -(_e1547[1]);
                            } else {
                                phi_9196_ = _e1547[1];
                            }
                            let _e1558 = phi_9196_;
                            if (_e1554 > _e1558) {
                                phi_9201_ = _e1554;
                            } else {
                                phi_9201_ = _e1558;
                            }
                            let _e1561 = phi_9201_;
                            if (_e1547[2] < 0.0lf) {
                                phi_9208_ = -(_e1547[2]);
                            } else {
                                phi_9208_ = _e1547[2];
                            }
                            let _e1565 = phi_9208_;
                            if (_e1561 > _e1565) {
                                phi_9213_ = _e1561;
                            } else {
                                phi_9213_ = _e1565;
                            }
                            let _e1568 = phi_9213_;
                            if (_e1544 > _e1568) {
                                phi_9218_ = _e1544;
                            } else {
                                phi_9218_ = _e1568;
                            }
                            let _e1571 = phi_9218_;
                            let _e1573 = local_18.member_3;
                            let _e1577 = local_18.member_2[0u];
                            if (_e1577[0] < 0.0lf) {
                                phi_9235_ = -(_e1577[0]);
                            } else {
                                phi_9235_ = _e1577[0];
                            }
                            let _e1584 = phi_9235_;
                            if (_e1577[1] < 0.0lf) {
                                phi_9242_ = -(_e1577[1]);
                            } else {
                                phi_9242_ = _e1577[1];
                            }
                            let _e1588 = phi_9242_;
                            if (_e1584 > _e1588) {
                                phi_9247_ = _e1584;
                            } else {
                                phi_9247_ = _e1588;
                            }
                            let _e1591 = phi_9247_;
                            if (_e1577[2] < 0.0lf) {
                                phi_9254_ = -(_e1577[2]);
                            } else {
                                phi_9254_ = _e1577[2];
                            }
                            let _e1595 = phi_9254_;
                            if (_e1591 > _e1595) {
                                phi_9259_ = _e1591;
                            } else {
                                phi_9259_ = _e1595;
                            }
                            let _e1598 = phi_9259_;
                            let _e1601 = local_18.member_2[1u];
                            if (_e1601[0] < 0.0lf) {
                                phi_9273_ = -(_e1601[0]);
                            } else {
                                phi_9273_ = _e1601[0];
                            }
                            let _e1608 = phi_9273_;
                            if (_e1601[1] < 0.0lf) {
                                phi_9280_ = -(_e1601[1]);
                            } else {
                                phi_9280_ = _e1601[1];
                            }
                            let _e1612 = phi_9280_;
                            if (_e1608 > _e1612) {
                                phi_9285_ = _e1608;
                            } else {
                                phi_9285_ = _e1612;
                            }
                            let _e1615 = phi_9285_;
                            if (_e1601[2] < 0.0lf) {
                                phi_9292_ = -(_e1601[2]);
                            } else {
                                phi_9292_ = _e1601[2];
                            }
                            let _e1619 = phi_9292_;
                            if (_e1615 > _e1619) {
                                phi_9297_ = _e1615;
                            } else {
                                phi_9297_ = _e1619;
                            }
                            let _e1622 = phi_9297_;
                            if (_e1598 > _e1622) {
                                phi_9302_ = _e1598;
                            } else {
                                phi_9302_ = _e1622;
                            }
                            let _e1625 = phi_9302_;
                            let _e1627 = local_18.member_3;
                            let _e1635 = local_18.member_3;
                            let _e1641 = ((((((_e1517 + _e1519) + (_e1571 + _e1573)) + (_e1625 + _e1627)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1635 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f)));
                            let _e1644 = local_18.member[0u];
                            let _e1650 = local_18.member[1u];
                            let _e1666 = local_18.member_1[0u];
                            let _e1672 = local_18.member_1[1u];
                            let _e1688 = local_18.member_2[0u];
                            let _e1694 = local_18.member_2[1u];
                            let _e1708 = function_4(array<f64, 3>((_e1644[0] + ((_e1650[0] - _e1644[0]) * _e564)), (_e1644[1] + ((_e1650[1] - _e1644[1]) * _e564)), (_e1644[2] + ((_e1650[2] - _e1644[2]) * _e564))), array<f64, 3>((_e1666[0] + ((_e1672[0] - _e1666[0]) * _e564)), (_e1666[1] + ((_e1672[1] - _e1666[1]) * _e564)), (_e1666[2] + ((_e1672[2] - _e1666[2]) * _e564))), array<f64, 3>((_e1688[0] + ((_e1694[0] - _e1688[0]) * _e564)), (_e1688[1] + ((_e1694[1] - _e1688[1]) * _e564)), (_e1688[2] + ((_e1694[2] - _e1688[2]) * _e564))), _e252.member);
                            if (_e1708[0] < 0.0lf) {
                                phi_9423_ = -(_e1708[0]);
                            } else {
                                phi_9423_ = _e1708[0];
                            }
                            let _e1713 = phi_9423_;
                            if (_e1708[1] < 0.0lf) {
                                phi_9430_ = -(_e1708[1]);
                            } else {
                                phi_9430_ = _e1708[1];
                            }
                            let _e1718 = phi_9430_;
                            if (_e1708[2] < 0.0lf) {
                                phi_9438_ = -(_e1708[2]);
                            } else {
                                phi_9438_ = _e1708[2];
                            }
                            let _e1724 = phi_9438_;
                            let _e1725 = ((_e1713 + _e1718) + _e1724);
                            if (_e1725 > f64(0f)) {
                                if ((bitcast<u64>(_e1725) & 9218868437227405312lu) != 9218868437227405312lu) {
                                    let _e1732 = (f64(1f) / _e1725);
                                    let _e1734 = (_e1708[0] * _e1732);
                                    let _e1736 = (_e1708[1] * _e1732);
                                    let _e1738 = (_e1708[2] * _e1732);
                                    let _e1743 = (((_e1734 * _e1734) + (_e1736 * _e1736)) + (_e1738 * _e1738));
                                    if (_e1743 <= 2.2250738585072014e-308lf) {
                                        if (_e1743 > 0.0lf) {
                                            phi_9477_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_9477_ = 0.0lf;
                                        }
                                        let _e1795 = phi_9477_;
                                        phi_9541_ = _e1795;
                                    } else {
                                        phi_9484_ = type_18(0i, 5i);
                                        phi_9487_ = bitcast<f64>(((bitcast<u64>(_e1743) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1750 = phi_9484_;
                                            let _e1752 = phi_9487_;
                                            local_19 = _e1752;
                                            if (_e1750.member < _e1750.member_1) {
                                                let _e1759 = (_e1750.member + 1i);
                                                if ((false == (_e1759 > _e1750.member)) != false) {
                                                    phi_9508_ = true;
                                                } else {
                                                    phi_9508_ = false;
                                                }
                                                let _e1764 = phi_9508_;
                                                if _e1764 {
                                                    phi_9514_ = type_19(0u, type_19().member_1);
                                                } else {
                                                    phi_9514_ = type_19(1u, _e1759);
                                                }
                                                let _e1769 = phi_9514_;
                                                phi_9485_ = type_18(_e1769.member_1, _e1750.member_1);
                                                phi_9528_ = type_19(1u, _e1750.member);
                                            } else {
                                                phi_9485_ = _e1750;
                                                phi_9528_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1775 = phi_9485_;
                                            let _e1777 = phi_9528_;
                                            let _e1780 = (bitcast<i32>(_e1777.member) != 0i);
                                            if _e1780 {
                                                phi_9488_ = (0.5lf * (_e1752 + (_e1743 / _e1752)));
                                            } else {
                                                phi_9488_ = f64();
                                            }
                                            let _e1785 = phi_9488_;
                                            continue;
                                            continuing {
                                                phi_9484_ = _e1775;
                                                phi_9487_ = _e1785;
                                                break if !(_e1780);
                                            }
                                        }
                                        let _e1790 = local_19;
                                        phi_9541_ = (_e1790 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1797 = phi_9541_;
                                    let _e1799 = (1.1102230246251565e-16lf * f64(12f));
                                    let _e1806 = ((_e1641 * f64(1.01f)) + ((_e1402 * _e1797) * (f64(1f) + _e1799)));
                                    let _e1811 = (((_e1734 * _e1405[0]) + (_e1736 * _e1405[1])) + (_e1738 * _e1405[2]));
                                    let _e1816 = (((_e1734 * _e1422) + (_e1736 * _e1423)) + (_e1738 * _e1424));
                                    let _e1821 = (((_e1734 * _e1432) + (_e1736 * _e1433)) + (_e1738 * _e1434));
                                    let _e1829 = (((_e1734 * _e1431[0]) + (_e1736 * _e1431[1])) + (_e1738 * _e1431[2]));
                                    let _e1835 = (((_e1734 * _e1437[0]) + (_e1736 * _e1437[1])) + (_e1738 * _e1437[2]));
                                    let _e1840 = (((_e1734 * _e1454) + (_e1736 * _e1455)) + (_e1738 * _e1456));
                                    let _e1845 = (((_e1734 * _e1464) + (_e1736 * _e1465)) + (_e1738 * _e1466));
                                    let _e1853 = (((_e1734 * _e1463[0]) + (_e1736 * _e1463[1])) + (_e1738 * _e1463[2]));
                                    if (_e1811 < 0.0lf) {
                                        phi_9610_ = -(_e1811);
                                    } else {
                                        phi_9610_ = _e1811;
                                    }
                                    let _e1858 = phi_9610_;
                                    if (_e1835 < 0.0lf) {
                                        phi_9616_ = -(_e1835);
                                    } else {
                                        phi_9616_ = _e1835;
                                    }
                                    let _e1862 = phi_9616_;
                                    if (_e1816 < 0.0lf) {
                                        phi_9625_ = -(_e1816);
                                    } else {
                                        phi_9625_ = _e1816;
                                    }
                                    let _e1869 = phi_9625_;
                                    if (_e1840 < 0.0lf) {
                                        phi_9631_ = -(_e1840);
                                    } else {
                                        phi_9631_ = _e1840;
                                    }
                                    let _e1873 = phi_9631_;
                                    if (_e1821 < 0.0lf) {
                                        phi_9640_ = -(_e1821);
                                    } else {
                                        phi_9640_ = _e1821;
                                    }
                                    let _e1880 = phi_9640_;
                                    if (_e1845 < 0.0lf) {
                                        phi_9646_ = -(_e1845);
                                    } else {
                                        phi_9646_ = _e1845;
                                    }
                                    let _e1884 = phi_9646_;
                                    if (_e1829 < 0.0lf) {
                                        phi_9655_ = -(_e1829);
                                    } else {
                                        phi_9655_ = _e1829;
                                    }
                                    let _e1891 = phi_9655_;
                                    if (_e1853 < 0.0lf) {
                                        phi_9661_ = -(_e1853);
                                    } else {
                                        phi_9661_ = _e1853;
                                    }
                                    let _e1895 = phi_9661_;
                                    phi_9667_ = type_35(array<f64, 4>(_e1811, _e1816, _e1821, _e1829), array<f64, 4>(_e1835, _e1840, _e1845, _e1853), array<f64, 4>((_e1806 + ((_e1858 + _e1862) * _e1799)), (_e1806 + ((_e1869 + _e1873) * _e1799)), (_e1806 + ((_e1880 + _e1884) * _e1799)), (_e1806 + ((_e1891 + _e1895) * _e1799))));
                                    phi_9668_ = false;
                                } else {
                                    phi_9667_ = type_35();
                                    phi_9668_ = true;
                                }
                                let _e1902 = phi_9667_;
                                let _e1904 = phi_9668_;
                                phi_9669_ = _e1902;
                                phi_9670_ = _e1904;
                            } else {
                                phi_9669_ = type_35();
                                phi_9670_ = true;
                            }
                            let _e1906 = phi_9669_;
                            let _e1908 = phi_9670_;
                            if _e1908 {
                                let _e1909 = f64(0f);
                                let _e1910 = f64(1f);
                                phi_9680_ = type_35(array<f64, 4>(_e1909, _e1909, _e1909, _e1909), array<f64, 4>(_e1909, _e1909, _e1909, _e1909), array<f64, 4>(_e1910, _e1910, _e1910, _e1910));
                            } else {
                                phi_9680_ = _e1906;
                            }
                            let _e1916 = phi_9680_;
                            local_8 = type_35(array<f64, 4>(_e1916.member[0], _e1916.member[1], _e1916.member[2], _e1916.member[3]), array<f64, 4>(_e1916.member_1[0], _e1916.member_1[1], _e1916.member_1[2], _e1916.member_1[3]), array<f64, 4>(_e1916.member_2[0], _e1916.member_2[1], _e1916.member_2[2], _e1916.member_2[3]));
                            let _e1936 = f64(0f);
                            let _e1939 = local_8.member[0u];
                            let _e1942 = local_8.member_1[0u];
                            let _e1945 = local_8.member[0u];
                            let _e1951 = local_8.member_2[0u];
                            if (((_e1939 + ((_e1942 - _e1945) * _e564)) - _e1951) > _e1936) {
                                let _e1956 = local_8.member[1u];
                                let _e1959 = local_8.member_1[1u];
                                let _e1962 = local_8.member[1u];
                                let _e1968 = local_8.member_2[1u];
                                if (((_e1956 + ((_e1959 - _e1962) * _e564)) - _e1968) > _e1936) {
                                    let _e1973 = local_8.member[2u];
                                    let _e1976 = local_8.member_1[2u];
                                    let _e1979 = local_8.member[2u];
                                    let _e1985 = local_8.member_2[2u];
                                    if (((_e1973 + ((_e1976 - _e1979) * _e564)) - _e1985) > _e1936) {
                                        let _e1990 = local_8.member[3u];
                                        let _e1993 = local_8.member_1[3u];
                                        let _e1996 = local_8.member[3u];
                                        let _e2002 = local_8.member_2[3u];
                                        phi_9850_ = (((_e1990 + ((_e1993 - _e1996) * _e564)) - _e2002) > _e1936);
                                        phi_9851_ = false;
                                    } else {
                                        phi_9850_ = bool();
                                        phi_9851_ = true;
                                    }
                                    let _e2006 = phi_9850_;
                                    let _e2008 = phi_9851_;
                                    phi_9852_ = _e2006;
                                    phi_9853_ = _e2008;
                                } else {
                                    phi_9852_ = bool();
                                    phi_9853_ = true;
                                }
                                let _e2010 = phi_9852_;
                                let _e2012 = phi_9853_;
                                phi_9854_ = _e2010;
                                phi_9855_ = _e2012;
                            } else {
                                phi_9854_ = bool();
                                phi_9855_ = true;
                            }
                            let _e2014 = phi_9854_;
                            let _e2016 = phi_9855_;
                            if _e2016 {
                                phi_9859_ = false;
                            } else {
                                phi_9859_ = _e2014;
                            }
                            let _e2018 = phi_9859_;
                            if _e2018 {
                                phi_11240_ = bool();
                                phi_11241_ = true;
                            } else {
                                let _e2019 = f64(0f);
                                if (_e1708[0] < 0.0lf) {
                                    phi_9887_ = -(_e1708[0]);
                                } else {
                                    phi_9887_ = _e1708[0];
                                }
                                let _e2024 = phi_9887_;
                                if (_e2019 < 0.0lf) {
                                    phi_9893_ = -(_e2019);
                                } else {
                                    phi_9893_ = _e2019;
                                }
                                let _e2028 = phi_9893_;
                                if (_e2019 < 0.0lf) {
                                    phi_9900_ = -(_e2019);
                                } else {
                                    phi_9900_ = _e2019;
                                }
                                let _e2033 = phi_9900_;
                                let _e2034 = ((_e2024 + _e2028) + _e2033);
                                if (_e2034 > f64(0f)) {
                                    if ((bitcast<u64>(_e2034) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e2041 = (f64(1f) / _e2034);
                                        let _e2042 = (_e1708[0] * _e2041);
                                        let _e2043 = (_e2019 * _e2041);
                                        let _e2044 = (_e2019 * _e2041);
                                        let _e2049 = (((_e2042 * _e2042) + (_e2043 * _e2043)) + (_e2044 * _e2044));
                                        if (_e2049 <= 2.2250738585072014e-308lf) {
                                            if (_e2049 > 0.0lf) {
                                                phi_9936_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_9936_ = 0.0lf;
                                            }
                                            let _e2101 = phi_9936_;
                                            phi_10000_ = _e2101;
                                        } else {
                                            phi_9943_ = type_18(0i, 5i);
                                            phi_9946_ = bitcast<f64>(((bitcast<u64>(_e2049) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e2056 = phi_9943_;
                                                let _e2058 = phi_9946_;
                                                local_20 = _e2058;
                                                if (_e2056.member < _e2056.member_1) {
                                                    let _e2065 = (_e2056.member + 1i);
                                                    if ((false == (_e2065 > _e2056.member)) != false) {
                                                        phi_9967_ = true;
                                                    } else {
                                                        phi_9967_ = false;
                                                    }
                                                    let _e2070 = phi_9967_;
                                                    if _e2070 {
                                                        phi_9973_ = type_19(0u, type_19().member_1);
                                                    } else {
                                                        phi_9973_ = type_19(1u, _e2065);
                                                    }
                                                    let _e2075 = phi_9973_;
                                                    phi_9944_ = type_18(_e2075.member_1, _e2056.member_1);
                                                    phi_9987_ = type_19(1u, _e2056.member);
                                                } else {
                                                    phi_9944_ = _e2056;
                                                    phi_9987_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2081 = phi_9944_;
                                                let _e2083 = phi_9987_;
                                                let _e2086 = (bitcast<i32>(_e2083.member) != 0i);
                                                if _e2086 {
                                                    phi_9947_ = (0.5lf * (_e2058 + (_e2049 / _e2058)));
                                                } else {
                                                    phi_9947_ = f64();
                                                }
                                                let _e2091 = phi_9947_;
                                                continue;
                                                continuing {
                                                    phi_9943_ = _e2081;
                                                    phi_9946_ = _e2091;
                                                    break if !(_e2086);
                                                }
                                            }
                                            let _e2096 = local_20;
                                            phi_10000_ = (_e2096 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e2103 = phi_10000_;
                                        let _e2105 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e2112 = ((_e1641 * f64(1.01f)) + ((_e1402 * _e2103) * (f64(1f) + _e2105)));
                                        let _e2117 = (((_e2042 * _e1405[0]) + (_e2043 * _e1405[1])) + (_e2044 * _e1405[2]));
                                        let _e2122 = (((_e2042 * _e1422) + (_e2043 * _e1423)) + (_e2044 * _e1424));
                                        let _e2127 = (((_e2042 * _e1432) + (_e2043 * _e1433)) + (_e2044 * _e1434));
                                        let _e2135 = (((_e2042 * _e1431[0]) + (_e2043 * _e1431[1])) + (_e2044 * _e1431[2]));
                                        let _e2141 = (((_e2042 * _e1437[0]) + (_e2043 * _e1437[1])) + (_e2044 * _e1437[2]));
                                        let _e2146 = (((_e2042 * _e1454) + (_e2043 * _e1455)) + (_e2044 * _e1456));
                                        let _e2151 = (((_e2042 * _e1464) + (_e2043 * _e1465)) + (_e2044 * _e1466));
                                        let _e2159 = (((_e2042 * _e1463[0]) + (_e2043 * _e1463[1])) + (_e2044 * _e1463[2]));
                                        if (_e2117 < 0.0lf) {
                                            phi_10069_ = -(_e2117);
                                        } else {
                                            phi_10069_ = _e2117;
                                        }
                                        let _e2164 = phi_10069_;
                                        if (_e2141 < 0.0lf) {
                                            phi_10075_ = -(_e2141);
                                        } else {
                                            phi_10075_ = _e2141;
                                        }
                                        let _e2168 = phi_10075_;
                                        if (_e2122 < 0.0lf) {
                                            phi_10084_ = -(_e2122);
                                        } else {
                                            phi_10084_ = _e2122;
                                        }
                                        let _e2175 = phi_10084_;
                                        if (_e2146 < 0.0lf) {
                                            phi_10090_ = -(_e2146);
                                        } else {
                                            phi_10090_ = _e2146;
                                        }
                                        let _e2179 = phi_10090_;
                                        if (_e2127 < 0.0lf) {
                                            phi_10099_ = -(_e2127);
                                        } else {
                                            phi_10099_ = _e2127;
                                        }
                                        let _e2186 = phi_10099_;
                                        if (_e2151 < 0.0lf) {
                                            phi_10105_ = -(_e2151);
                                        } else {
                                            phi_10105_ = _e2151;
                                        }
                                        let _e2190 = phi_10105_;
                                        if (_e2135 < 0.0lf) {
                                            phi_10114_ = -(_e2135);
                                        } else {
                                            phi_10114_ = _e2135;
                                        }
                                        let _e2197 = phi_10114_;
                                        if (_e2159 < 0.0lf) {
                                            phi_10120_ = -(_e2159);
                                        } else {
                                            phi_10120_ = _e2159;
                                        }
                                        let _e2201 = phi_10120_;
                                        phi_10126_ = type_35(array<f64, 4>(_e2117, _e2122, _e2127, _e2135), array<f64, 4>(_e2141, _e2146, _e2151, _e2159), array<f64, 4>((_e2112 + ((_e2164 + _e2168) * _e2105)), (_e2112 + ((_e2175 + _e2179) * _e2105)), (_e2112 + ((_e2186 + _e2190) * _e2105)), (_e2112 + ((_e2197 + _e2201) * _e2105))));
                                        phi_10127_ = false;
                                    } else {
                                        phi_10126_ = type_35();
                                        phi_10127_ = true;
                                    }
                                    let _e2208 = phi_10126_;
                                    let _e2210 = phi_10127_;
                                    phi_10128_ = _e2208;
                                    phi_10129_ = _e2210;
                                } else {
                                    phi_10128_ = type_35();
                                    phi_10129_ = true;
                                }
                                let _e2212 = phi_10128_;
                                let _e2214 = phi_10129_;
                                if _e2214 {
                                    let _e2215 = f64(0f);
                                    let _e2216 = f64(1f);
                                    phi_10139_ = type_35(array<f64, 4>(_e2215, _e2215, _e2215, _e2215), array<f64, 4>(_e2215, _e2215, _e2215, _e2215), array<f64, 4>(_e2216, _e2216, _e2216, _e2216));
                                } else {
                                    phi_10139_ = _e2212;
                                }
                                let _e2222 = phi_10139_;
                                local_9 = type_35(array<f64, 4>(_e2222.member[0], _e2222.member[1], _e2222.member[2], _e2222.member[3]), array<f64, 4>(_e2222.member_1[0], _e2222.member_1[1], _e2222.member_1[2], _e2222.member_1[3]), array<f64, 4>(_e2222.member_2[0], _e2222.member_2[1], _e2222.member_2[2], _e2222.member_2[3]));
                                let _e2242 = f64(0f);
                                let _e2245 = local_9.member[0u];
                                let _e2248 = local_9.member_1[0u];
                                let _e2251 = local_9.member[0u];
                                let _e2257 = local_9.member_2[0u];
                                if (((_e2245 + ((_e2248 - _e2251) * _e564)) - _e2257) > _e2242) {
                                    let _e2262 = local_9.member[1u];
                                    let _e2265 = local_9.member_1[1u];
                                    let _e2268 = local_9.member[1u];
                                    let _e2274 = local_9.member_2[1u];
                                    if (((_e2262 + ((_e2265 - _e2268) * _e564)) - _e2274) > _e2242) {
                                        let _e2279 = local_9.member[2u];
                                        let _e2282 = local_9.member_1[2u];
                                        let _e2285 = local_9.member[2u];
                                        let _e2291 = local_9.member_2[2u];
                                        if (((_e2279 + ((_e2282 - _e2285) * _e564)) - _e2291) > _e2242) {
                                            let _e2296 = local_9.member[3u];
                                            let _e2299 = local_9.member_1[3u];
                                            let _e2302 = local_9.member[3u];
                                            let _e2308 = local_9.member_2[3u];
                                            phi_10309_ = (((_e2296 + ((_e2299 - _e2302) * _e564)) - _e2308) > _e2242);
                                            phi_10310_ = false;
                                        } else {
                                            phi_10309_ = bool();
                                            phi_10310_ = true;
                                        }
                                        let _e2312 = phi_10309_;
                                        let _e2314 = phi_10310_;
                                        phi_10311_ = _e2312;
                                        phi_10312_ = _e2314;
                                    } else {
                                        phi_10311_ = bool();
                                        phi_10312_ = true;
                                    }
                                    let _e2316 = phi_10311_;
                                    let _e2318 = phi_10312_;
                                    phi_10313_ = _e2316;
                                    phi_10314_ = _e2318;
                                } else {
                                    phi_10313_ = bool();
                                    phi_10314_ = true;
                                }
                                let _e2320 = phi_10313_;
                                let _e2322 = phi_10314_;
                                if _e2322 {
                                    phi_10318_ = false;
                                } else {
                                    phi_10318_ = _e2320;
                                }
                                let _e2324 = phi_10318_;
                                if _e2324 {
                                    phi_11238_ = bool();
                                    phi_11239_ = true;
                                } else {
                                    let _e2325 = f64(0f);
                                    if (_e2325 < 0.0lf) {
                                        phi_10346_ = -(_e2325);
                                    } else {
                                        phi_10346_ = _e2325;
                                    }
                                    let _e2330 = phi_10346_;
                                    if (_e1708[1] < 0.0lf) {
                                        phi_10352_ = -(_e1708[1]);
                                    } else {
                                        phi_10352_ = _e1708[1];
                                    }
                                    let _e2334 = phi_10352_;
                                    if (_e2325 < 0.0lf) {
                                        phi_10359_ = -(_e2325);
                                    } else {
                                        phi_10359_ = _e2325;
                                    }
                                    let _e2339 = phi_10359_;
                                    let _e2340 = ((_e2330 + _e2334) + _e2339);
                                    if (_e2340 > f64(0f)) {
                                        if ((bitcast<u64>(_e2340) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e2347 = (f64(1f) / _e2340);
                                            let _e2348 = (_e2325 * _e2347);
                                            let _e2349 = (_e1708[1] * _e2347);
                                            let _e2350 = (_e2325 * _e2347);
                                            let _e2355 = (((_e2348 * _e2348) + (_e2349 * _e2349)) + (_e2350 * _e2350));
                                            if (_e2355 <= 2.2250738585072014e-308lf) {
                                                if (_e2355 > 0.0lf) {
                                                    phi_10395_ = (1.464336215552873e-154lf * 2.0lf);
                                                } else {
                                                    phi_10395_ = 0.0lf;
                                                }
                                                let _e2407 = phi_10395_;
                                                phi_10459_ = _e2407;
                                            } else {
                                                phi_10402_ = type_18(0i, 5i);
                                                phi_10405_ = bitcast<f64>(((bitcast<u64>(_e2355) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e2362 = phi_10402_;
                                                    let _e2364 = phi_10405_;
                                                    local_21 = _e2364;
                                                    if (_e2362.member < _e2362.member_1) {
                                                        let _e2371 = (_e2362.member + 1i);
                                                        if ((false == (_e2371 > _e2362.member)) != false) {
                                                            phi_10426_ = true;
                                                        } else {
                                                            phi_10426_ = false;
                                                        }
                                                        let _e2376 = phi_10426_;
                                                        if _e2376 {
                                                            phi_10432_ = type_19(0u, type_19().member_1);
                                                        } else {
                                                            phi_10432_ = type_19(1u, _e2371);
                                                        }
                                                        let _e2381 = phi_10432_;
                                                        phi_10403_ = type_18(_e2381.member_1, _e2362.member_1);
                                                        phi_10446_ = type_19(1u, _e2362.member);
                                                    } else {
                                                        phi_10403_ = _e2362;
                                                        phi_10446_ = type_19(0u, type_19().member_1);
                                                    }
                                                    let _e2387 = phi_10403_;
                                                    let _e2389 = phi_10446_;
                                                    let _e2392 = (bitcast<i32>(_e2389.member) != 0i);
                                                    if _e2392 {
                                                        phi_10406_ = (0.5lf * (_e2364 + (_e2355 / _e2364)));
                                                    } else {
                                                        phi_10406_ = f64();
                                                    }
                                                    let _e2397 = phi_10406_;
                                                    continue;
                                                    continuing {
                                                        phi_10402_ = _e2387;
                                                        phi_10405_ = _e2397;
                                                        break if !(_e2392);
                                                    }
                                                }
                                                let _e2402 = local_21;
                                                phi_10459_ = (_e2402 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e2409 = phi_10459_;
                                            let _e2411 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e2418 = ((_e1641 * f64(1.01f)) + ((_e1402 * _e2409) * (f64(1f) + _e2411)));
                                            let _e2423 = (((_e2348 * _e1405[0]) + (_e2349 * _e1405[1])) + (_e2350 * _e1405[2]));
                                            let _e2428 = (((_e2348 * _e1422) + (_e2349 * _e1423)) + (_e2350 * _e1424));
                                            let _e2433 = (((_e2348 * _e1432) + (_e2349 * _e1433)) + (_e2350 * _e1434));
                                            let _e2441 = (((_e2348 * _e1431[0]) + (_e2349 * _e1431[1])) + (_e2350 * _e1431[2]));
                                            let _e2447 = (((_e2348 * _e1437[0]) + (_e2349 * _e1437[1])) + (_e2350 * _e1437[2]));
                                            let _e2452 = (((_e2348 * _e1454) + (_e2349 * _e1455)) + (_e2350 * _e1456));
                                            let _e2457 = (((_e2348 * _e1464) + (_e2349 * _e1465)) + (_e2350 * _e1466));
                                            let _e2465 = (((_e2348 * _e1463[0]) + (_e2349 * _e1463[1])) + (_e2350 * _e1463[2]));
                                            if (_e2423 < 0.0lf) {
                                                phi_10528_ = -(_e2423);
                                            } else {
                                                phi_10528_ = _e2423;
                                            }
                                            let _e2470 = phi_10528_;
                                            if (_e2447 < 0.0lf) {
                                                phi_10534_ = -(_e2447);
                                            } else {
                                                phi_10534_ = _e2447;
                                            }
                                            let _e2474 = phi_10534_;
                                            if (_e2428 < 0.0lf) {
                                                phi_10543_ = -(_e2428);
                                            } else {
                                                phi_10543_ = _e2428;
                                            }
                                            let _e2481 = phi_10543_;
                                            if (_e2452 < 0.0lf) {
                                                phi_10549_ = -(_e2452);
                                            } else {
                                                phi_10549_ = _e2452;
                                            }
                                            let _e2485 = phi_10549_;
                                            if (_e2433 < 0.0lf) {
                                                phi_10558_ = -(_e2433);
                                            } else {
                                                phi_10558_ = _e2433;
                                            }
                                            let _e2492 = phi_10558_;
                                            if (_e2457 < 0.0lf) {
                                                phi_10564_ = -(_e2457);
                                            } else {
                                                phi_10564_ = _e2457;
                                            }
                                            let _e2496 = phi_10564_;
                                            if (_e2441 < 0.0lf) {
                                                phi_10573_ = -(_e2441);
                                            } else {
                                                phi_10573_ = _e2441;
                                            }
                                            let _e2503 = phi_10573_;
                                            if (_e2465 < 0.0lf) {
                                                phi_10579_ = -(_e2465);
                                            } else {
                                                phi_10579_ = _e2465;
                                            }
                                            let _e2507 = phi_10579_;
                                            phi_10585_ = type_35(array<f64, 4>(_e2423, _e2428, _e2433, _e2441), array<f64, 4>(_e2447, _e2452, _e2457, _e2465), array<f64, 4>((_e2418 + ((_e2470 + _e2474) * _e2411)), (_e2418 + ((_e2481 + _e2485) * _e2411)), (_e2418 + ((_e2492 + _e2496) * _e2411)), (_e2418 + ((_e2503 + _e2507) * _e2411))));
                                            phi_10586_ = false;
                                        } else {
                                            phi_10585_ = type_35();
                                            phi_10586_ = true;
                                        }
                                        let _e2514 = phi_10585_;
                                        let _e2516 = phi_10586_;
                                        phi_10587_ = _e2514;
                                        phi_10588_ = _e2516;
                                    } else {
                                        phi_10587_ = type_35();
                                        phi_10588_ = true;
                                    }
                                    let _e2518 = phi_10587_;
                                    let _e2520 = phi_10588_;
                                    if _e2520 {
                                        let _e2521 = f64(0f);
                                        let _e2522 = f64(1f);
                                        phi_10598_ = type_35(array<f64, 4>(_e2521, _e2521, _e2521, _e2521), array<f64, 4>(_e2521, _e2521, _e2521, _e2521), array<f64, 4>(_e2522, _e2522, _e2522, _e2522));
                                    } else {
                                        phi_10598_ = _e2518;
                                    }
                                    let _e2528 = phi_10598_;
                                    local_10 = type_35(array<f64, 4>(_e2528.member[0], _e2528.member[1], _e2528.member[2], _e2528.member[3]), array<f64, 4>(_e2528.member_1[0], _e2528.member_1[1], _e2528.member_1[2], _e2528.member_1[3]), array<f64, 4>(_e2528.member_2[0], _e2528.member_2[1], _e2528.member_2[2], _e2528.member_2[3]));
                                    let _e2548 = f64(0f);
                                    let _e2551 = local_10.member[0u];
                                    let _e2554 = local_10.member_1[0u];
                                    let _e2557 = local_10.member[0u];
                                    let _e2563 = local_10.member_2[0u];
                                    if (((_e2551 + ((_e2554 - _e2557) * _e564)) - _e2563) > _e2548) {
                                        let _e2568 = local_10.member[1u];
                                        let _e2571 = local_10.member_1[1u];
                                        let _e2574 = local_10.member[1u];
                                        let _e2580 = local_10.member_2[1u];
                                        if (((_e2568 + ((_e2571 - _e2574) * _e564)) - _e2580) > _e2548) {
                                            let _e2585 = local_10.member[2u];
                                            let _e2588 = local_10.member_1[2u];
                                            let _e2591 = local_10.member[2u];
                                            let _e2597 = local_10.member_2[2u];
                                            if (((_e2585 + ((_e2588 - _e2591) * _e564)) - _e2597) > _e2548) {
                                                let _e2602 = local_10.member[3u];
                                                let _e2605 = local_10.member_1[3u];
                                                let _e2608 = local_10.member[3u];
                                                let _e2614 = local_10.member_2[3u];
                                                phi_10768_ = (((_e2602 + ((_e2605 - _e2608) * _e564)) - _e2614) > _e2548);
                                                phi_10769_ = false;
                                            } else {
                                                phi_10768_ = bool();
                                                phi_10769_ = true;
                                            }
                                            let _e2618 = phi_10768_;
                                            let _e2620 = phi_10769_;
                                            phi_10770_ = _e2618;
                                            phi_10771_ = _e2620;
                                        } else {
                                            phi_10770_ = bool();
                                            phi_10771_ = true;
                                        }
                                        let _e2622 = phi_10770_;
                                        let _e2624 = phi_10771_;
                                        phi_10772_ = _e2622;
                                        phi_10773_ = _e2624;
                                    } else {
                                        phi_10772_ = bool();
                                        phi_10773_ = true;
                                    }
                                    let _e2626 = phi_10772_;
                                    let _e2628 = phi_10773_;
                                    if _e2628 {
                                        phi_10777_ = false;
                                    } else {
                                        phi_10777_ = _e2626;
                                    }
                                    let _e2630 = phi_10777_;
                                    if _e2630 {
                                        phi_11237_ = bool();
                                    } else {
                                        let _e2631 = f64(0f);
                                        if (_e2631 < 0.0lf) {
                                            phi_10805_ = -(_e2631);
                                        } else {
                                            phi_10805_ = _e2631;
                                        }
                                        let _e2636 = phi_10805_;
                                        if (_e2631 < 0.0lf) {
                                            phi_10811_ = -(_e2631);
                                        } else {
                                            phi_10811_ = _e2631;
                                        }
                                        let _e2640 = phi_10811_;
                                        if (_e1708[2] < 0.0lf) {
                                            phi_10818_ = -(_e1708[2]);
                                        } else {
                                            phi_10818_ = _e1708[2];
                                        }
                                        let _e2645 = phi_10818_;
                                        let _e2646 = ((_e2636 + _e2640) + _e2645);
                                        if (_e2646 > f64(0f)) {
                                            if ((bitcast<u64>(_e2646) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2653 = (f64(1f) / _e2646);
                                                let _e2654 = (_e2631 * _e2653);
                                                let _e2655 = (_e2631 * _e2653);
                                                let _e2656 = (_e1708[2] * _e2653);
                                                let _e2661 = (((_e2654 * _e2654) + (_e2655 * _e2655)) + (_e2656 * _e2656));
                                                if (_e2661 <= 2.2250738585072014e-308lf) {
                                                    if (_e2661 > 0.0lf) {
                                                        phi_10854_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_10854_ = 0.0lf;
                                                    }
                                                    let _e2713 = phi_10854_;
                                                    phi_10918_ = _e2713;
                                                } else {
                                                    phi_10861_ = type_18(0i, 5i);
                                                    phi_10864_ = bitcast<f64>(((bitcast<u64>(_e2661) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2668 = phi_10861_;
                                                        let _e2670 = phi_10864_;
                                                        local_22 = _e2670;
                                                        if (_e2668.member < _e2668.member_1) {
                                                            let _e2677 = (_e2668.member + 1i);
                                                            if ((false == (_e2677 > _e2668.member)) != false) {
                                                                phi_10885_ = true;
                                                            } else {
                                                                phi_10885_ = false;
                                                            }
                                                            let _e2682 = phi_10885_;
                                                            if _e2682 {
                                                                phi_10891_ = type_19(0u, type_19().member_1);
                                                            } else {
                                                                phi_10891_ = type_19(1u, _e2677);
                                                            }
                                                            let _e2687 = phi_10891_;
                                                            phi_10862_ = type_18(_e2687.member_1, _e2668.member_1);
                                                            phi_10905_ = type_19(1u, _e2668.member);
                                                        } else {
                                                            phi_10862_ = _e2668;
                                                            phi_10905_ = type_19(0u, type_19().member_1);
                                                        }
                                                        let _e2693 = phi_10862_;
                                                        let _e2695 = phi_10905_;
                                                        let _e2698 = (bitcast<i32>(_e2695.member) != 0i);
                                                        if _e2698 {
                                                            phi_10865_ = (0.5lf * (_e2670 + (_e2661 / _e2670)));
                                                        } else {
                                                            phi_10865_ = f64();
                                                        }
                                                        let _e2703 = phi_10865_;
                                                        continue;
                                                        continuing {
                                                            phi_10861_ = _e2693;
                                                            phi_10864_ = _e2703;
                                                            break if !(_e2698);
                                                        }
                                                    }
                                                    let _e2708 = local_22;
                                                    phi_10918_ = (_e2708 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2715 = phi_10918_;
                                                let _e2717 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2724 = ((_e1641 * f64(1.01f)) + ((_e1402 * _e2715) * (f64(1f) + _e2717)));
                                                let _e2729 = (((_e2654 * _e1405[0]) + (_e2655 * _e1405[1])) + (_e2656 * _e1405[2]));
                                                let _e2734 = (((_e2654 * _e1422) + (_e2655 * _e1423)) + (_e2656 * _e1424));
                                                let _e2739 = (((_e2654 * _e1432) + (_e2655 * _e1433)) + (_e2656 * _e1434));
                                                let _e2747 = (((_e2654 * _e1431[0]) + (_e2655 * _e1431[1])) + (_e2656 * _e1431[2]));
                                                let _e2753 = (((_e2654 * _e1437[0]) + (_e2655 * _e1437[1])) + (_e2656 * _e1437[2]));
                                                let _e2758 = (((_e2654 * _e1454) + (_e2655 * _e1455)) + (_e2656 * _e1456));
                                                let _e2763 = (((_e2654 * _e1464) + (_e2655 * _e1465)) + (_e2656 * _e1466));
                                                let _e2771 = (((_e2654 * _e1463[0]) + (_e2655 * _e1463[1])) + (_e2656 * _e1463[2]));
                                                if (_e2729 < 0.0lf) {
                                                    phi_10987_ = -(_e2729);
                                                } else {
                                                    phi_10987_ = _e2729;
                                                }
                                                let _e2776 = phi_10987_;
                                                if (_e2753 < 0.0lf) {
                                                    phi_10993_ = -(_e2753);
                                                } else {
                                                    phi_10993_ = _e2753;
                                                }
                                                let _e2780 = phi_10993_;
                                                if (_e2734 < 0.0lf) {
                                                    phi_11002_ = -(_e2734);
                                                } else {
                                                    phi_11002_ = _e2734;
                                                }
                                                let _e2787 = phi_11002_;
                                                if (_e2758 < 0.0lf) {
                                                    phi_11008_ = -(_e2758);
                                                } else {
                                                    phi_11008_ = _e2758;
                                                }
                                                let _e2791 = phi_11008_;
                                                if (_e2739 < 0.0lf) {
                                                    phi_11017_ = -(_e2739);
                                                } else {
                                                    phi_11017_ = _e2739;
                                                }
                                                let _e2798 = phi_11017_;
                                                if (_e2763 < 0.0lf) {
                                                    phi_11023_ = -(_e2763);
                                                } else {
                                                    phi_11023_ = _e2763;
                                                }
                                                let _e2802 = phi_11023_;
                                                if (_e2747 < 0.0lf) {
                                                    phi_11032_ = -(_e2747);
                                                } else {
                                                    phi_11032_ = _e2747;
                                                }
                                                let _e2809 = phi_11032_;
                                                if (_e2771 < 0.0lf) {
                                                    phi_11038_ = -(_e2771);
                                                } else {
                                                    phi_11038_ = _e2771;
                                                }
                                                let _e2813 = phi_11038_;
                                                phi_11044_ = type_35(array<f64, 4>(_e2729, _e2734, _e2739, _e2747), array<f64, 4>(_e2753, _e2758, _e2763, _e2771), array<f64, 4>((_e2724 + ((_e2776 + _e2780) * _e2717)), (_e2724 + ((_e2787 + _e2791) * _e2717)), (_e2724 + ((_e2798 + _e2802) * _e2717)), (_e2724 + ((_e2809 + _e2813) * _e2717))));
                                                phi_11045_ = false;
                                            } else {
                                                phi_11044_ = type_35();
                                                phi_11045_ = true;
                                            }
                                            let _e2820 = phi_11044_;
                                            let _e2822 = phi_11045_;
                                            phi_11046_ = _e2820;
                                            phi_11047_ = _e2822;
                                        } else {
                                            phi_11046_ = type_35();
                                            phi_11047_ = true;
                                        }
                                        let _e2824 = phi_11046_;
                                        let _e2826 = phi_11047_;
                                        if _e2826 {
                                            let _e2827 = f64(0f);
                                            let _e2828 = f64(1f);
                                            phi_11057_ = type_35(array<f64, 4>(_e2827, _e2827, _e2827, _e2827), array<f64, 4>(_e2827, _e2827, _e2827, _e2827), array<f64, 4>(_e2828, _e2828, _e2828, _e2828));
                                        } else {
                                            phi_11057_ = _e2824;
                                        }
                                        let _e2834 = phi_11057_;
                                        local_11 = type_35(array<f64, 4>(_e2834.member[0], _e2834.member[1], _e2834.member[2], _e2834.member[3]), array<f64, 4>(_e2834.member_1[0], _e2834.member_1[1], _e2834.member_1[2], _e2834.member_1[3]), array<f64, 4>(_e2834.member_2[0], _e2834.member_2[1], _e2834.member_2[2], _e2834.member_2[3]));
                                        let _e2854 = f64(0f);
                                        let _e2857 = local_11.member[0u];
                                        let _e2860 = local_11.member_1[0u];
                                        let _e2863 = local_11.member[0u];
                                        let _e2869 = local_11.member_2[0u];
                                        if (((_e2857 + ((_e2860 - _e2863) * _e564)) - _e2869) > _e2854) {
                                            let _e2874 = local_11.member[1u];
                                            let _e2877 = local_11.member_1[1u];
                                            let _e2880 = local_11.member[1u];
                                            let _e2886 = local_11.member_2[1u];
                                            if (((_e2874 + ((_e2877 - _e2880) * _e564)) - _e2886) > _e2854) {
                                                let _e2891 = local_11.member[2u];
                                                let _e2894 = local_11.member_1[2u];
                                                let _e2897 = local_11.member[2u];
                                                let _e2903 = local_11.member_2[2u];
                                                if (((_e2891 + ((_e2894 - _e2897) * _e564)) - _e2903) > _e2854) {
                                                    let _e2908 = local_11.member[3u];
                                                    let _e2911 = local_11.member_1[3u];
                                                    let _e2914 = local_11.member[3u];
                                                    let _e2920 = local_11.member_2[3u];
                                                    phi_11227_ = (((_e2908 + ((_e2911 - _e2914) * _e564)) - _e2920) > _e2854);
                                                    phi_11228_ = false;
                                                } else {
                                                    phi_11227_ = bool();
                                                    phi_11228_ = true;
                                                }
                                                let _e2924 = phi_11227_;
                                                let _e2926 = phi_11228_;
                                                phi_11229_ = _e2924;
                                                phi_11230_ = _e2926;
                                            } else {
                                                phi_11229_ = bool();
                                                phi_11230_ = true;
                                            }
                                            let _e2928 = phi_11229_;
                                            let _e2930 = phi_11230_;
                                            phi_11231_ = _e2928;
                                            phi_11232_ = _e2930;
                                        } else {
                                            phi_11231_ = bool();
                                            phi_11232_ = true;
                                        }
                                        let _e2932 = phi_11231_;
                                        let _e2934 = phi_11232_;
                                        if _e2934 {
                                            phi_11236_ = false;
                                        } else {
                                            phi_11236_ = _e2932;
                                        }
                                        let _e2936 = phi_11236_;
                                        phi_11237_ = _e2936;
                                    }
                                    let _e2938 = phi_11237_;
                                    phi_11238_ = _e2938;
                                    phi_11239_ = _e2630;
                                }
                                let _e2940 = phi_11238_;
                                let _e2942 = phi_11239_;
                                phi_11240_ = _e2940;
                                phi_11241_ = _e2942;
                            }
                            let _e2944 = phi_11240_;
                            let _e2946 = phi_11241_;
                            if _e2946 {
                                phi_11245_ = true;
                            } else {
                                phi_11245_ = _e2944;
                            }
                            let _e2948 = phi_11245_;
                            if !(_e2948) {
                                phi_11251_ = type_43(2u, _e564);
                                phi_11252_ = false;
                            } else {
                                phi_11251_ = type_43();
                                phi_11252_ = true;
                            }
                            let _e2952 = phi_11251_;
                            let _e2954 = phi_11252_;
                            phi_11253_ = _e2952;
                            phi_11254_ = _e2954;
                        } else {
                            phi_11253_ = type_43();
                            phi_11254_ = true;
                        }
                        let _e2956 = phi_11253_;
                        let _e2958 = phi_11254_;
                        if _e2958 {
                            let _e2959 = f64(0f);
                            let _e2960 = f64(1f);
                            let _e2961 = f64(3f);
                            let _e2967 = ((_e1005 - (_e2961 * _e982)) * _e1376);
                            let _e2968 = ((_e1028 - _e1005) * _e1376);
                            let _e2969 = (((_e2961 * _e1039) - _e1028) * _e1376);
                            local_6[0u] = _e2959;
                            local_6[1u] = _e2960;
                            local_6[2u] = _e2960;
                            local_6[3u] = _e2960;
                            let _e2976 = ((_e2968 * _e2968) - (_e2967 * _e2969));
                            if (_e2976 > _e2959) {
                                if (_e2976 <= 2.2250738585072014e-308lf) {
                                    if (_e2976 > 0.0lf) {
                                        phi_11293_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_11293_ = 0.0lf;
                                    }
                                    let _e3029 = phi_11293_;
                                    phi_11357_ = _e3029;
                                } else {
                                    phi_11300_ = type_18(0i, 5i);
                                    phi_11303_ = bitcast<f64>(((bitcast<u64>(_e2976) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2984 = phi_11300_;
                                        let _e2986 = phi_11303_;
                                        local_23 = _e2986;
                                        if (_e2984.member < _e2984.member_1) {
                                            let _e2993 = (_e2984.member + 1i);
                                            if ((false == (_e2993 > _e2984.member)) != false) {
                                                phi_11324_ = true;
                                            } else {
                                                phi_11324_ = false;
                                            }
                                            let _e2998 = phi_11324_;
                                            if _e2998 {
                                                phi_11330_ = type_19(0u, type_19().member_1);
                                            } else {
                                                phi_11330_ = type_19(1u, _e2993);
                                            }
                                            let _e3003 = phi_11330_;
                                            phi_11301_ = type_18(_e3003.member_1, _e2984.member_1);
                                            phi_11344_ = type_19(1u, _e2984.member);
                                        } else {
                                            phi_11301_ = _e2984;
                                            phi_11344_ = type_19(0u, type_19().member_1);
                                        }
                                        let _e3009 = phi_11301_;
                                        let _e3011 = phi_11344_;
                                        let _e3014 = (bitcast<i32>(_e3011.member) != 0i);
                                        if _e3014 {
                                            phi_11304_ = (0.5lf * (_e2986 + (_e2976 / _e2986)));
                                        } else {
                                            phi_11304_ = f64();
                                        }
                                        let _e3019 = phi_11304_;
                                        continue;
                                        continuing {
                                            phi_11300_ = _e3009;
                                            phi_11303_ = _e3019;
                                            break if !(_e3014);
                                        }
                                    }
                                    let _e3024 = local_23;
                                    phi_11357_ = (_e3024 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e3031 = phi_11357_;
                                if (_e2968 < _e2959) {
                                    phi_11363_ = -(_e3031);
                                } else {
                                    phi_11363_ = _e3031;
                                }
                                let _e3035 = phi_11363_;
                                let _e3037 = -((_e2968 + _e3035));
                                local_7[0u] = (_e3037 / (_e3037 + _e2969));
                                local_7[1u] = (_e2967 / (_e2967 + _e3037));
                                let _e3046 = local_7[1u];
                                let _e3047 = local_7[0u];
                                if (_e3046 < _e3047) {
                                    let _e3050 = local_7[1u];
                                    let _e3052 = local_7[0u];
                                    local_7[0u] = _e3050;
                                    local_7[1u] = _e3052;
                                }
                                phi_11388_ = type_9(0u, 2u);
                                phi_11391_ = 1u;
                                loop {
                                    let _e3056 = phi_11388_;
                                    let _e3058 = phi_11391_;
                                    local_64 = _e3058;
                                    if (_e3056.member < _e3056.member_1) {
                                        phi_11389_ = type_9((_e3056.member + 1u), _e3056.member_1);
                                        phi_11414_ = type_9(1u, _e3056.member);
                                    } else {
                                        phi_11389_ = _e3056;
                                        phi_11414_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e3070 = phi_11389_;
                                    let _e3072 = phi_11414_;
                                    let _e3076 = (bitcast<i32>(_e3072.member) != 0i);
                                    if _e3076 {
                                        let _e3078 = local_7[_e3072.member_1];
                                        if (_e3078 > _e2959) {
                                            let _e3081 = local_7[_e3072.member_1];
                                            if (_e3081 < _e2960) {
                                                let _e3084 = local_7[_e3072.member_1];
                                                local_6[_e3058] = _e3084;
                                                phi_11458_ = (_e3058 + 1u);
                                            } else {
                                                phi_11458_ = _e3058;
                                            }
                                            let _e3088 = phi_11458_;
                                            phi_11459_ = _e3088;
                                        } else {
                                            phi_11459_ = _e3058;
                                        }
                                        let _e3090 = phi_11459_;
                                        phi_11392_ = _e3090;
                                    } else {
                                        phi_11392_ = u32();
                                    }
                                    let _e3092 = phi_11392_;
                                    continue;
                                    continuing {
                                        phi_11388_ = _e3070;
                                        phi_11391_ = _e3092;
                                        break if !(_e3076);
                                    }
                                }
                                let _e11262 = local_64;
                                phi_11460_ = _e11262;
                            } else {
                                phi_11460_ = 1u;
                            }
                            let _e3095 = phi_11460_;
                            local_6[_e3095] = _e2960;
                            let _e3097 = local_6;
                            local_12 = _e3097;
                            phi_11480_ = type_9(0u, _e3095);
                            loop {
                                let _e3100 = phi_11480_;
                                if (_e3100.member < _e3100.member_1) {
                                    phi_11481_ = type_9((_e3100.member + 1u), _e3100.member_1);
                                    phi_11504_ = type_9(1u, _e3100.member);
                                } else {
                                    phi_11481_ = _e3100;
                                    phi_11504_ = type_9(0u, type_9().member_1);
                                }
                                let _e3112 = phi_11481_;
                                let _e3114 = phi_11504_;
                                if (bitcast<i32>(_e3114.member) != 0i) {
                                    let _e3120 = local_12[_e3114.member_1];
                                    if (_e3120 > _e564) {
                                        phi_11523_ = _e3120;
                                    } else {
                                        phi_11523_ = _e564;
                                    }
                                    let _e3123 = phi_11523_;
                                    let _e3126 = local_12[(_e3114.member_1 + 1u)];
                                    if (_e3126 < _e573) {
                                        phi_11536_ = _e3126;
                                    } else {
                                        phi_11536_ = _e573;
                                    }
                                    let _e3129 = phi_11536_;
                                    if (_e3123 <= _e3129) {
                                        let _e3132 = (f64(1f) - _e3123);
                                        let _e3143 = ((((_e982 * _e3132) + (_e1005 * _e3123)) * (_e3132 * _e3132)) + (((_e1028 * _e3132) + (_e1039 * _e3123)) * (_e3123 * _e3123)));
                                        let _e3145 = (f64(1f) - _e3129);
                                        let _e3156 = ((((_e982 * _e3145) + (_e1005 * _e3129)) * (_e3145 * _e3145)) + (((_e1028 * _e3145) + (_e1039 * _e3129)) * (_e3129 * _e3129)));
                                        if (_e3143 < 0.0lf) {
                                            phi_11572_ = -(_e3143);
                                        } else {
                                            phi_11572_ = _e3143;
                                        }
                                        let _e3160 = phi_11572_;
                                        let _e3161 = (_e3160 > _e1372);
                                        if (_e3156 < 0.0lf) {
                                            phi_11579_ = -(_e3156);
                                        } else {
                                            phi_11579_ = _e3156;
                                        }
                                        let _e3165 = phi_11579_;
                                        let _e3166 = (_e3165 > _e1372);
                                        let _e3167 = f64(0f);
                                        if _e3161 {
                                            if _e3166 {
                                                phi_11591_ = ((_e3143 > _e3167) != (_e3156 > _e3167));
                                                phi_11592_ = false;
                                            } else {
                                                phi_11591_ = bool();
                                                phi_11592_ = true;
                                            }
                                            let _e3172 = phi_11591_;
                                            let _e3174 = phi_11592_;
                                            phi_11593_ = _e3172;
                                            phi_11594_ = _e3174;
                                        } else {
                                            phi_11593_ = bool();
                                            phi_11594_ = true;
                                        }
                                        let _e3176 = phi_11593_;
                                        let _e3178 = phi_11594_;
                                        if _e3178 {
                                            phi_11598_ = false;
                                        } else {
                                            phi_11598_ = _e3176;
                                        }
                                        let _e3180 = phi_11598_;
                                        if _e3161 {
                                            if _e3166 {
                                                if _e3180 {
                                                    phi_11610_ = type_46();
                                                } else {
                                                    phi_11610_ = type_46(f64(1f), _e3167, _e3180);
                                                }
                                                let _e3184 = phi_11610_;
                                                phi_11611_ = _e3184;
                                                phi_11612_ = _e3180;
                                            } else {
                                                phi_11611_ = type_46();
                                                phi_11612_ = true;
                                            }
                                            let _e3186 = phi_11611_;
                                            let _e3188 = phi_11612_;
                                            phi_11613_ = _e3186;
                                            phi_11614_ = _e3188;
                                        } else {
                                            phi_11613_ = type_46();
                                            phi_11614_ = true;
                                        }
                                        let _e3190 = phi_11613_;
                                        let _e3192 = phi_11614_;
                                        if _e3192 {
                                            if _e3161 {
                                                if (_e3143 < _e3167) {
                                                    phi_11627_ = f64(-1f);
                                                } else {
                                                    phi_11627_ = f64(1f);
                                                }
                                                let _e3197 = phi_11627_;
                                                let _e3198 = f64(0.5f);
                                                let _e3199 = f64(3f);
                                                let _e3202 = (_e1028 - _e1005);
                                                phi_11639_ = type_9(0u, 64u);
                                                phi_11642_ = _e3129;
                                                phi_11644_ = _e3123;
                                                phi_11646_ = (_e3198 * (_e3123 + _e3129));
                                                loop {
                                                    let _e3208 = phi_11639_;
                                                    let _e3210 = phi_11642_;
                                                    let _e3212 = phi_11644_;
                                                    let _e3214 = phi_11646_;
                                                    local_66 = _e3212;
                                                    if (_e3208.member < _e3208.member_1) {
                                                        phi_11640_ = type_9((_e3208.member + 1u), _e3208.member_1);
                                                        phi_11669_ = type_9(1u, _e3208.member);
                                                    } else {
                                                        phi_11640_ = _e3208;
                                                        phi_11669_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e3226 = phi_11640_;
                                                    let _e3228 = phi_11669_;
                                                    if (bitcast<i32>(_e3228.member) != 0i) {
                                                        let _e3233 = (f64(1f) - _e3214);
                                                        let _e3246 = ((_e3197 * ((((_e982 * _e3233) + (_e1005 * _e3214)) * (_e3233 * _e3233)) + (((_e1028 * _e3233) + (_e1039 * _e3214)) * (_e3214 * _e3214)))) - _e1372);
                                                        if (_e3246 > f64(0f)) {
                                                            phi_11696_ = _e3210;
                                                            phi_11697_ = _e3214;
                                                        } else {
                                                            phi_11696_ = _e3214;
                                                            phi_11697_ = _e3212;
                                                        }
                                                        let _e3250 = phi_11696_;
                                                        let _e3252 = phi_11697_;
                                                        let _e3254 = ((_e3250 - _e3252) > _e1382);
                                                        if _e3254 {
                                                            let _e3256 = (f64(1f) - _e3214);
                                                            let _e3268 = (-(_e3246) / (_e3197 * (((((_e1005 - (_e3199 * _e982)) * _e3256) + (_e3202 * _e3214)) * _e3256) + (((_e3202 * _e3256) + (((_e3199 * _e1039) - _e1028) * _e3214)) * _e3214))));
                                                            if (_e3246 > f64(0f)) {
                                                                phi_11725_ = (_e3198 * _e1382);
                                                            } else {
                                                                phi_11725_ = -((_e3198 * _e1382));
                                                            }
                                                            let _e3275 = phi_11725_;
                                                            let _e3277 = ((_e3214 + _e3268) + _e3275);
                                                            if (_e3277 > _e3252) {
                                                                if (_e3277 < _e3250) {
                                                                    if (_e3268 < 0.0lf) {
                                                                        phi_11741_ = -(_e3268);
                                                                    } else {
                                                                        phi_11741_ = _e3268;
                                                                    }
                                                                    let _e3283 = phi_11741_;
                                                                    if (_e3283 < (_e3198 * (_e3250 - _e3252))) {
                                                                        phi_11748_ = false;
                                                                    } else {
                                                                        phi_11748_ = true;
                                                                    }
                                                                    let _e3288 = phi_11748_;
                                                                    phi_11749_ = _e3288;
                                                                } else {
                                                                    phi_11749_ = true;
                                                                }
                                                                let _e3290 = phi_11749_;
                                                                phi_11750_ = _e3290;
                                                            } else {
                                                                phi_11750_ = true;
                                                            }
                                                            let _e3292 = phi_11750_;
                                                            if _e3292 {
                                                                phi_11756_ = (_e3198 * (_e3252 + _e3250));
                                                            } else {
                                                                phi_11756_ = _e3277;
                                                            }
                                                            let _e3296 = phi_11756_;
                                                            phi_11757_ = _e3296;
                                                            phi_11758_ = false;
                                                        } else {
                                                            phi_11757_ = f64();
                                                            phi_11758_ = true;
                                                        }
                                                        let _e3298 = phi_11757_;
                                                        let _e3300 = phi_11758_;
                                                        phi_11643_ = _e3250;
                                                        phi_11645_ = _e3252;
                                                        phi_11647_ = _e3298;
                                                        phi_11759_ = _e3252;
                                                        phi_11760_ = _e3254;
                                                        phi_11761_ = _e3300;
                                                    } else {
                                                        phi_11643_ = f64();
                                                        phi_11645_ = f64();
                                                        phi_11647_ = f64();
                                                        phi_11759_ = f64();
                                                        phi_11760_ = false;
                                                        phi_11761_ = false;
                                                    }
                                                    let _e3302 = phi_11643_;
                                                    let _e3304 = phi_11645_;
                                                    let _e3306 = phi_11647_;
                                                    let _e3308 = phi_11759_;
                                                    let _e3310 = phi_11760_;
                                                    let _e3312 = phi_11761_;
                                                    local_24 = _e3312;
                                                    local_65 = _e3308;
                                                    continue;
                                                    continuing {
                                                        phi_11639_ = _e3226;
                                                        phi_11642_ = _e3302;
                                                        phi_11644_ = _e3304;
                                                        phi_11646_ = _e3306;
                                                        break if !(_e3310);
                                                    }
                                                }
                                                let _e3315 = local_24;
                                                if _e3315 {
                                                    let _e11306 = local_65;
                                                    phi_11765_ = _e11306;
                                                } else {
                                                    let _e11308 = local_66;
                                                    phi_11765_ = _e11308;
                                                }
                                                let _e3317 = phi_11765_;
                                                phi_11766_ = _e3317;
                                            } else {
                                                phi_11766_ = _e3123;
                                            }
                                            let _e3319 = phi_11766_;
                                            if _e3166 {
                                                if (_e3156 < _e3167) {
                                                    phi_11776_ = f64(-1f);
                                                } else {
                                                    phi_11776_ = f64(1f);
                                                }
                                                let _e3324 = phi_11776_;
                                                phi_11780_ = type_9(0u, 64u);
                                                phi_11783_ = (_e1382 + _e1382);
                                                loop {
                                                    let _e3327 = phi_11780_;
                                                    let _e3329 = phi_11783_;
                                                    if (_e3327.member < _e3327.member_1) {
                                                        phi_11781_ = type_9((_e3327.member + 1u), _e3327.member_1);
                                                        phi_11806_ = type_9(1u, _e3327.member);
                                                    } else {
                                                        phi_11781_ = _e3327;
                                                        phi_11806_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e3341 = phi_11781_;
                                                    let _e3343 = phi_11806_;
                                                    if (bitcast<i32>(_e3343.member) != 0i) {
                                                        let _e3347 = (_e3319 + _e3329);
                                                        if (_e3347 < _e3129) {
                                                            let _e3350 = (f64(1f) - _e3347);
                                                            let _e3363 = ((_e3324 * ((((_e982 * _e3350) + (_e1005 * _e3347)) * (_e3350 * _e3350)) + (((_e1028 * _e3350) + (_e1039 * _e3347)) * (_e3347 * _e3347)))) > _e1372);
                                                            if _e3363 {
                                                                phi_11837_ = f64();
                                                                phi_11838_ = false;
                                                            } else {
                                                                phi_11837_ = (_e3329 + _e3329);
                                                                phi_11838_ = true;
                                                            }
                                                            let _e3366 = phi_11837_;
                                                            let _e3368 = phi_11838_;
                                                            phi_11839_ = _e3366;
                                                            phi_11840_ = _e3368;
                                                            phi_11841_ = _e3363;
                                                            phi_11842_ = false;
                                                        } else {
                                                            phi_11839_ = f64();
                                                            phi_11840_ = false;
                                                            phi_11841_ = false;
                                                            phi_11842_ = true;
                                                        }
                                                        let _e3370 = phi_11839_;
                                                        let _e3372 = phi_11840_;
                                                        let _e3374 = phi_11841_;
                                                        let _e3376 = phi_11842_;
                                                        phi_11843_ = _e3347;
                                                        phi_11784_ = _e3370;
                                                        phi_11844_ = _e3372;
                                                        phi_11845_ = _e3374;
                                                        phi_11846_ = _e3376;
                                                        phi_11847_ = false;
                                                    } else {
                                                        phi_11843_ = f64();
                                                        phi_11784_ = f64();
                                                        phi_11844_ = false;
                                                        phi_11845_ = false;
                                                        phi_11846_ = false;
                                                        phi_11847_ = true;
                                                    }
                                                    let _e3378 = phi_11843_;
                                                    let _e3380 = phi_11784_;
                                                    let _e3382 = phi_11844_;
                                                    let _e3384 = phi_11845_;
                                                    let _e3386 = phi_11846_;
                                                    let _e3388 = phi_11847_;
                                                    local_25 = _e3384;
                                                    local_67 = _e3386;
                                                    local_68 = _e3388;
                                                    local_69 = _e3378;
                                                    continue;
                                                    continuing {
                                                        phi_11780_ = _e3341;
                                                        phi_11783_ = _e3380;
                                                        break if !(_e3382);
                                                    }
                                                }
                                                let _e3391 = local_25;
                                                if _e3391 {
                                                    phi_11851_ = false;
                                                    phi_11852_ = false;
                                                } else {
                                                    let _e11330 = local_67;
                                                    phi_11851_ = _e11330;
                                                    let _e11333 = local_68;
                                                    phi_11852_ = _e11333;
                                                }
                                                let _e3393 = phi_11851_;
                                                let _e3395 = phi_11852_;
                                                if _e3393 {
                                                    phi_11856_ = true;
                                                } else {
                                                    phi_11856_ = _e3395;
                                                }
                                                let _e3397 = phi_11856_;
                                                if _e3397 {
                                                    phi_11860_ = _e3129;
                                                } else {
                                                    let _e11337 = local_69;
                                                    phi_11860_ = _e11337;
                                                }
                                                let _e3399 = phi_11860_;
                                                phi_11861_ = _e3399;
                                            } else {
                                                phi_11861_ = _e3129;
                                            }
                                            let _e3401 = phi_11861_;
                                            phi_11863_ = type_46(_e3319, _e3401, _e3180);
                                        } else {
                                            phi_11863_ = _e3190;
                                        }
                                        let _e3404 = phi_11863_;
                                        if (_e3404.member > _e3404.member_1) {
                                            phi_15730_ = bool();
                                            phi_15731_ = f64();
                                            phi_15732_ = f64();
                                            phi_15733_ = true;
                                            phi_15734_ = false;
                                            phi_15735_ = false;
                                            phi_15736_ = false;
                                        } else {
                                            let _e3412 = ((_e3404.member_1 - _e3404.member) * f64(0.5f));
                                            let _e3413 = (_e3404.member + _e3412);
                                            let _e3416 = (_e3412 + (1.1102230246251565e-16lf * f64(4f)));
                                            let _e3418 = local_18.member_3;
                                            let _e3421 = local_18.member[0u];
                                            if (_e3421[0] < 0.0lf) {
                                                phi_11894_ = -(_e3421[0]);
                                            } else {
                                                phi_11894_ = _e3421[0];
                                            }
                                            let _e3428 = phi_11894_;
                                            if (_e3421[1] < 0.0lf) {
                                                phi_11901_ = -(_e3421[1]);
                                            } else {
                                                phi_11901_ = _e3421[1];
                                            }
                                            let _e3432 = phi_11901_;
                                            if (_e3428 > _e3432) {
                                                phi_11906_ = _e3428;
                                            } else {
                                                phi_11906_ = _e3432;
                                            }
                                            let _e3435 = phi_11906_;
                                            if (_e3421[2] < 0.0lf) {
                                                phi_11913_ = -(_e3421[2]);
                                            } else {
                                                phi_11913_ = _e3421[2];
                                            }
                                            let _e3439 = phi_11913_;
                                            if (_e3435 > _e3439) {
                                                phi_11918_ = _e3435;
                                            } else {
                                                phi_11918_ = _e3439;
                                            }
                                            let _e3442 = phi_11918_;
                                            let _e3444 = local_18.member[1u];
                                            if (_e3444[0] < 0.0lf) {
                                                phi_11931_ = -(_e3444[0]);
                                            } else {
                                                phi_11931_ = _e3444[0];
                                            }
                                            let _e3451 = phi_11931_;
                                            if (_e3444[1] < 0.0lf) {
                                                phi_11938_ = -(_e3444[1]);
                                            } else {
                                                phi_11938_ = _e3444[1];
                                            }
                                            let _e3455 = phi_11938_;
                                            if (_e3451 > _e3455) {
                                                phi_11943_ = _e3451;
                                            } else {
                                                phi_11943_ = _e3455;
                                            }
                                            let _e3458 = phi_11943_;
                                            if (_e3444[2] < 0.0lf) {
                                                phi_11950_ = -(_e3444[2]);
                                            } else {
                                                phi_11950_ = _e3444[2];
                                            }
                                            let _e3462 = phi_11950_;
                                            if (_e3458 > _e3462) {
                                                phi_11955_ = _e3458;
                                            } else {
                                                phi_11955_ = _e3462;
                                            }
                                            let _e3465 = phi_11955_;
                                            if (_e3442 > _e3465) {
                                                phi_11960_ = _e3442;
                                            } else {
                                                phi_11960_ = _e3465;
                                            }
                                            let _e3468 = phi_11960_;
                                            let _e3471 = local_18.member[0u];
                                            let _e3476 = local_18.member[1u];
                                            let _e3486 = (_e3471[0] + ((_e3476[0] - _e3471[0]) * _e3413));
                                            let _e3487 = (_e3471[1] + ((_e3476[1] - _e3471[1]) * _e3413));
                                            let _e3488 = (_e3471[2] + ((_e3476[2] - _e3471[2]) * _e3413));
                                            let _e3490 = local_18.member[1u];
                                            let _e3495 = local_18.member[0u];
                                            let _e3499 = (_e3490[0] - _e3495[0]);
                                            let _e3500 = (_e3490[1] - _e3495[1]);
                                            let _e3501 = (_e3490[2] - _e3495[2]);
                                            if (_e3499 < 0.0lf) {
                                                phi_12019_ = -(_e3499);
                                            } else {
                                                phi_12019_ = _e3499;
                                            }
                                            let _e3505 = phi_12019_;
                                            if (_e3500 < 0.0lf) {
                                                phi_12025_ = -(_e3500);
                                            } else {
                                                phi_12025_ = _e3500;
                                            }
                                            let _e3509 = phi_12025_;
                                            if (_e3505 > _e3509) {
                                                phi_12030_ = _e3505;
                                            } else {
                                                phi_12030_ = _e3509;
                                            }
                                            let _e3512 = phi_12030_;
                                            if (_e3501 < 0.0lf) {
                                                phi_12036_ = -(_e3501);
                                            } else {
                                                phi_12036_ = _e3501;
                                            }
                                            let _e3516 = phi_12036_;
                                            if (_e3512 > _e3516) {
                                                phi_12041_ = _e3512;
                                            } else {
                                                phi_12041_ = _e3516;
                                            }
                                            let _e3519 = phi_12041_;
                                            let _e3527 = ((((_e3416 * _e3519) * f64(1.01f)) + ((_e3468 + _e3418) * (1.1102230246251565e-16lf * f64(8f)))) + _e3418);
                                            if (_e3486 < 0.0lf) {
                                                phi_12055_ = -(_e3486);
                                            } else {
                                                phi_12055_ = _e3486;
                                            }
                                            let _e3531 = phi_12055_;
                                            if (_e3487 < 0.0lf) {
                                                phi_12061_ = -(_e3487);
                                            } else {
                                                phi_12061_ = _e3487;
                                            }
                                            let _e3535 = phi_12061_;
                                            if (_e3531 > _e3535) {
                                                phi_12066_ = _e3531;
                                            } else {
                                                phi_12066_ = _e3535;
                                            }
                                            let _e3538 = phi_12066_;
                                            if (_e3488 < 0.0lf) {
                                                phi_12072_ = -(_e3488);
                                            } else {
                                                phi_12072_ = _e3488;
                                            }
                                            let _e3542 = phi_12072_;
                                            if (_e3538 > _e3542) {
                                                phi_12077_ = _e3538;
                                            } else {
                                                phi_12077_ = _e3542;
                                            }
                                            let _e3545 = phi_12077_;
                                            local_2 = type_36(array<f64, 3>(_e3486, _e3487, _e3488), _e3527, (_e3545 + _e3527));
                                            let _e3551 = local_18.member_3;
                                            let _e3553 = local_18.member_1[0u];
                                            if (_e3553[0] < 0.0lf) {
                                                phi_12103_ = -(_e3553[0]);
                                            } else {
                                                phi_12103_ = _e3553[0];
                                            }
                                            let _e3560 = phi_12103_;
                                            if (_e3553[1] < 0.0lf) {
                                                phi_12110_ = -(_e3553[1]);
                                            } else {
                                                phi_12110_ = _e3553[1];
                                            }
                                            let _e3564 = phi_12110_;
                                            if (_e3560 > _e3564) {
                                                phi_12115_ = _e3560;
                                            } else {
                                                phi_12115_ = _e3564;
                                            }
                                            let _e3567 = phi_12115_;
                                            if (_e3553[2] < 0.0lf) {
                                                phi_12122_ = -(_e3553[2]);
                                            } else {
                                                phi_12122_ = _e3553[2];
                                            }
                                            let _e3571 = phi_12122_;
                                            if (_e3567 > _e3571) {
                                                phi_12127_ = _e3567;
                                            } else {
                                                phi_12127_ = _e3571;
                                            }
                                            let _e3574 = phi_12127_;
                                            let _e3576 = local_18.member_1[1u];
                                            if (_e3576[0] < 0.0lf) {
                                                phi_12140_ = -(_e3576[0]);
                                            } else {
                                                phi_12140_ = _e3576[0];
                                            }
                                            let _e3583 = phi_12140_;
                                            if (_e3576[1] < 0.0lf) {
                                                phi_12147_ = -(_e3576[1]);
                                            } else {
                                                phi_12147_ = _e3576[1];
                                            }
                                            let _e3587 = phi_12147_;
                                            if (_e3583 > _e3587) {
                                                phi_12152_ = _e3583;
                                            } else {
                                                phi_12152_ = _e3587;
                                            }
                                            let _e3590 = phi_12152_;
                                            if (_e3576[2] < 0.0lf) {
                                                phi_12159_ = -(_e3576[2]);
                                            } else {
                                                phi_12159_ = _e3576[2];
                                            }
                                            let _e3594 = phi_12159_;
                                            if (_e3590 > _e3594) {
                                                phi_12164_ = _e3590;
                                            } else {
                                                phi_12164_ = _e3594;
                                            }
                                            let _e3597 = phi_12164_;
                                            if (_e3574 > _e3597) {
                                                phi_12169_ = _e3574;
                                            } else {
                                                phi_12169_ = _e3597;
                                            }
                                            let _e3600 = phi_12169_;
                                            let _e3603 = local_18.member_1[0u];
                                            let _e3608 = local_18.member_1[1u];
                                            let _e3618 = (_e3603[0] + ((_e3608[0] - _e3603[0]) * _e3413));
                                            let _e3619 = (_e3603[1] + ((_e3608[1] - _e3603[1]) * _e3413));
                                            let _e3620 = (_e3603[2] + ((_e3608[2] - _e3603[2]) * _e3413));
                                            let _e3622 = local_18.member_1[1u];
                                            let _e3627 = local_18.member_1[0u];
                                            let _e3631 = (_e3622[0] - _e3627[0]);
                                            let _e3632 = (_e3622[1] - _e3627[1]);
                                            let _e3633 = (_e3622[2] - _e3627[2]);
                                            if (_e3631 < 0.0lf) {
                                                phi_12228_ = -(_e3631);
                                            } else {
                                                phi_12228_ = _e3631;
                                            }
                                            let _e3637 = phi_12228_;
                                            if (_e3632 < 0.0lf) {
                                                phi_12234_ = -(_e3632);
                                            } else {
                                                phi_12234_ = _e3632;
                                            }
                                            let _e3641 = phi_12234_;
                                            if (_e3637 > _e3641) {
                                                phi_12239_ = _e3637;
                                            } else {
                                                phi_12239_ = _e3641;
                                            }
                                            let _e3644 = phi_12239_;
                                            if (_e3633 < 0.0lf) {
                                                phi_12245_ = -(_e3633);
                                            } else {
                                                phi_12245_ = _e3633;
                                            }
                                            let _e3648 = phi_12245_;
                                            if (_e3644 > _e3648) {
                                                phi_12250_ = _e3644;
                                            } else {
                                                phi_12250_ = _e3648;
                                            }
                                            let _e3651 = phi_12250_;
                                            let _e3659 = ((((_e3416 * _e3651) * f64(1.01f)) + ((_e3600 + _e3551) * (1.1102230246251565e-16lf * f64(8f)))) + _e3551);
                                            if (_e3618 < 0.0lf) {
                                                phi_12264_ = -(_e3618);
                                            } else {
                                                phi_12264_ = _e3618;
                                            }
                                            let _e3663 = phi_12264_;
                                            if (_e3619 < 0.0lf) {
                                                phi_12270_ = -(_e3619);
                                            } else {
                                                phi_12270_ = _e3619;
                                            }
                                            let _e3667 = phi_12270_;
                                            if (_e3663 > _e3667) {
                                                phi_12275_ = _e3663;
                                            } else {
                                                phi_12275_ = _e3667;
                                            }
                                            let _e3670 = phi_12275_;
                                            if (_e3620 < 0.0lf) {
                                                phi_12281_ = -(_e3620);
                                            } else {
                                                phi_12281_ = _e3620;
                                            }
                                            let _e3674 = phi_12281_;
                                            if (_e3670 > _e3674) {
                                                phi_12286_ = _e3670;
                                            } else {
                                                phi_12286_ = _e3674;
                                            }
                                            let _e3677 = phi_12286_;
                                            local_3 = type_36(array<f64, 3>(_e3618, _e3619, _e3620), _e3659, (_e3677 + _e3659));
                                            let _e3683 = local_18.member_3;
                                            let _e3685 = local_18.member_2[0u];
                                            if (_e3685[0] < 0.0lf) {
                                                phi_12312_ = -(_e3685[0]);
                                            } else {
                                                phi_12312_ = _e3685[0];
                                            }
                                            let _e3692 = phi_12312_;
                                            if (_e3685[1] < 0.0lf) {
                                                phi_12319_ = -(_e3685[1]);
                                            } else {
                                                phi_12319_ = _e3685[1];
                                            }
                                            let _e3696 = phi_12319_;
                                            if (_e3692 > _e3696) {
                                                phi_12324_ = _e3692;
                                            } else {
                                                phi_12324_ = _e3696;
                                            }
                                            let _e3699 = phi_12324_;
                                            if (_e3685[2] < 0.0lf) {
                                                phi_12331_ = -(_e3685[2]);
                                            } else {
                                                phi_12331_ = _e3685[2];
                                            }
                                            let _e3703 = phi_12331_;
                                            if (_e3699 > _e3703) {
                                                phi_12336_ = _e3699;
                                            } else {
                                                phi_12336_ = _e3703;
                                            }
                                            let _e3706 = phi_12336_;
                                            let _e3708 = local_18.member_2[1u];
                                            if (_e3708[0] < 0.0lf) {
                                                phi_12349_ = -(_e3708[0]);
                                            } else {
                                                phi_12349_ = _e3708[0];
                                            }
                                            let _e3715 = phi_12349_;
                                            if (_e3708[1] < 0.0lf) {
                                                phi_12356_ = -(_e3708[1]);
                                            } else {
                                                phi_12356_ = _e3708[1];
                                            }
                                            let _e3719 = phi_12356_;
                                            if (_e3715 > _e3719) {
                                                phi_12361_ = _e3715;
                                            } else {
                                                phi_12361_ = _e3719;
                                            }
                                            let _e3722 = phi_12361_;
                                            if (_e3708[2] < 0.0lf) {
                                                phi_12368_ = -(_e3708[2]);
                                            } else {
                                                phi_12368_ = _e3708[2];
                                            }
                                            let _e3726 = phi_12368_;
                                            if (_e3722 > _e3726) {
                                                phi_12373_ = _e3722;
                                            } else {
                                                phi_12373_ = _e3726;
                                            }
                                            let _e3729 = phi_12373_;
                                            if (_e3706 > _e3729) {
                                                phi_12378_ = _e3706;
                                            } else {
                                                phi_12378_ = _e3729;
                                            }
                                            let _e3732 = phi_12378_;
                                            let _e3735 = local_18.member_2[0u];
                                            let _e3740 = local_18.member_2[1u];
                                            let _e3750 = (_e3735[0] + ((_e3740[0] - _e3735[0]) * _e3413));
                                            let _e3751 = (_e3735[1] + ((_e3740[1] - _e3735[1]) * _e3413));
                                            let _e3752 = (_e3735[2] + ((_e3740[2] - _e3735[2]) * _e3413));
                                            let _e3754 = local_18.member_2[1u];
                                            let _e3759 = local_18.member_2[0u];
                                            let _e3763 = (_e3754[0] - _e3759[0]);
                                            let _e3764 = (_e3754[1] - _e3759[1]);
                                            let _e3765 = (_e3754[2] - _e3759[2]);
                                            if (_e3763 < 0.0lf) {
                                                phi_12437_ = -(_e3763);
                                            } else {
                                                phi_12437_ = _e3763;
                                            }
                                            let _e3769 = phi_12437_;
                                            if (_e3764 < 0.0lf) {
                                                phi_12443_ = -(_e3764);
                                            } else {
                                                phi_12443_ = _e3764;
                                            }
                                            let _e3773 = phi_12443_;
                                            if (_e3769 > _e3773) {
                                                phi_12448_ = _e3769;
                                            } else {
                                                phi_12448_ = _e3773;
                                            }
                                            let _e3776 = phi_12448_;
                                            if (_e3765 < 0.0lf) {
                                                phi_12454_ = -(_e3765);
                                            } else {
                                                phi_12454_ = _e3765;
                                            }
                                            let _e3780 = phi_12454_;
                                            if (_e3776 > _e3780) {
                                                phi_12459_ = _e3776;
                                            } else {
                                                phi_12459_ = _e3780;
                                            }
                                            let _e3783 = phi_12459_;
                                            let _e3791 = ((((_e3416 * _e3783) * f64(1.01f)) + ((_e3732 + _e3683) * (1.1102230246251565e-16lf * f64(8f)))) + _e3683);
                                            if (_e3750 < 0.0lf) {
                                                phi_12473_ = -(_e3750);
                                            } else {
                                                phi_12473_ = _e3750;
                                            }
                                            let _e3795 = phi_12473_;
                                            if (_e3751 < 0.0lf) {
                                                phi_12479_ = -(_e3751);
                                            } else {
                                                phi_12479_ = _e3751;
                                            }
                                            let _e3799 = phi_12479_;
                                            if (_e3795 > _e3799) {
                                                phi_12484_ = _e3795;
                                            } else {
                                                phi_12484_ = _e3799;
                                            }
                                            let _e3802 = phi_12484_;
                                            if (_e3752 < 0.0lf) {
                                                phi_12490_ = -(_e3752);
                                            } else {
                                                phi_12490_ = _e3752;
                                            }
                                            let _e3806 = phi_12490_;
                                            if (_e3802 > _e3806) {
                                                phi_12495_ = _e3802;
                                            } else {
                                                phi_12495_ = _e3806;
                                            }
                                            let _e3809 = phi_12495_;
                                            local_4 = type_36(array<f64, 3>(_e3750, _e3751, _e3752), _e3791, (_e3809 + _e3791));
                                            let _e3814 = local_3.member;
                                            let _e3819 = local_4.member;
                                            let _e3825 = ((_e3814[1] * _e3819[2]) - (_e3814[2] * _e3819[1]));
                                            let _e3828 = ((_e3814[2] * _e3819[0]) - (_e3814[0] * _e3819[2]));
                                            let _e3831 = ((_e3814[0] * _e3819[1]) - (_e3814[1] * _e3819[0]));
                                            if (_e3825 < 0.0lf) {
                                                phi_12544_ = -(_e3825);
                                            } else {
                                                phi_12544_ = _e3825;
                                            }
                                            let _e3835 = phi_12544_;
                                            if (_e3828 < 0.0lf) {
                                                phi_12550_ = -(_e3828);
                                            } else {
                                                phi_12550_ = _e3828;
                                            }
                                            let _e3839 = phi_12550_;
                                            if (_e3835 > _e3839) {
                                                if (_e3825 < 0.0lf) {
                                                    phi_12560_ = -(_e3825);
                                                } else {
                                                    phi_12560_ = _e3825;
                                                }
                                                let _e3857 = phi_12560_;
                                                if (_e3831 < 0.0lf) {
                                                    phi_12566_ = -(_e3831);
                                                } else {
                                                    phi_12566_ = _e3831;
                                                }
                                                let _e3861 = phi_12566_;
                                                if (_e3857 > _e3861) {
                                                    phi_12571_ = 2u;
                                                    phi_12572_ = 1u;
                                                } else {
                                                    phi_12571_ = 1u;
                                                    phi_12572_ = 0u;
                                                }
                                                let _e3864 = phi_12571_;
                                                let _e3866 = phi_12572_;
                                                phi_12591_ = _e3864;
                                                phi_12592_ = _e3866;
                                            } else {
                                                if (_e3828 < 0.0lf) {
                                                    phi_12578_ = -(_e3828);
                                                } else {
                                                    phi_12578_ = _e3828;
                                                }
                                                let _e3844 = phi_12578_;
                                                if (_e3831 < 0.0lf) {
                                                    phi_12584_ = -(_e3831);
                                                } else {
                                                    phi_12584_ = _e3831;
                                                }
                                                let _e3848 = phi_12584_;
                                                if (_e3844 > _e3848) {
                                                    phi_12589_ = 0u;
                                                    phi_12590_ = 2u;
                                                } else {
                                                    phi_12589_ = 1u;
                                                    phi_12590_ = 0u;
                                                }
                                                let _e3851 = phi_12589_;
                                                let _e3853 = phi_12590_;
                                                phi_12591_ = _e3851;
                                                phi_12592_ = _e3853;
                                            }
                                            let _e3868 = phi_12591_;
                                            let _e3870 = phi_12592_;
                                            let _e3873 = local_3.member[_e3870];
                                            let _e3876 = local_4.member[_e3868];
                                            let _e3880 = local_3.member[_e3868];
                                            let _e3883 = local_4.member[_e3870];
                                            let _e3885 = ((_e3873 * _e3876) - (_e3880 * _e3883));
                                            let _e3886 = f64(1f);
                                            let _e3887 = f64(2f);
                                            let _e3889 = local_3.member_1;
                                            let _e3891 = local_4.member_2;
                                            let _e3894 = local_3.member_2;
                                            let _e3896 = local_4.member_1;
                                            let _e3902 = local_3.member_2;
                                            let _e3905 = local_4.member_2;
                                            let _e3914 = local_3.member_2;
                                            let _e3917 = local_4.member_2;
                                            let _e3921 = (((((_e3889 * _e3891) + (_e3894 * _e3896)) * f64(2.01f)) + (((_e3902 * _e3887) * (_e3905 * _e3887)) * (1.1102230246251565e-16lf * _e3887))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3886 + _e3914) * (_e3886 + _e3917))));
                                            if (_e3885 < 0.0lf) {
                                                phi_12665_ = -(_e3885);
                                            } else {
                                                phi_12665_ = _e3885;
                                            }
                                            let _e3925 = phi_12665_;
                                            if (_e3925 > _e3921) {
                                                if (_e3885 < f64(0f)) {
                                                    phi_12677_ = f64(-1f);
                                                } else {
                                                    phi_12677_ = f64(1f);
                                                }
                                                let _e3932 = phi_12677_;
                                                let _e3935 = local_2.member[_e3870];
                                                let _e3938 = local_4.member[_e3868];
                                                let _e3942 = local_2.member[_e3868];
                                                let _e3945 = local_4.member[_e3870];
                                                let _e3948 = f64(1f);
                                                let _e3949 = f64(2f);
                                                let _e3951 = local_2.member_1;
                                                let _e3953 = local_4.member_2;
                                                let _e3956 = local_2.member_2;
                                                let _e3958 = local_4.member_1;
                                                let _e3964 = local_2.member_2;
                                                let _e3967 = local_4.member_2;
                                                let _e3976 = local_2.member_2;
                                                let _e3979 = local_4.member_2;
                                                let _e3983 = (((((_e3951 * _e3953) + (_e3956 * _e3958)) * f64(2.01f)) + (((_e3964 * _e3949) * (_e3967 * _e3949)) * (1.1102230246251565e-16lf * _e3949))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3948 + _e3976) * (_e3948 + _e3979))));
                                                let _e3986 = local_3.member[_e3870];
                                                let _e3989 = local_2.member[_e3868];
                                                let _e3993 = local_3.member[_e3868];
                                                let _e3996 = local_2.member[_e3870];
                                                let _e3999 = f64(1f);
                                                let _e4000 = f64(2f);
                                                let _e4002 = local_3.member_1;
                                                let _e4004 = local_2.member_2;
                                                let _e4007 = local_3.member_2;
                                                let _e4009 = local_2.member_1;
                                                let _e4015 = local_3.member_2;
                                                let _e4018 = local_2.member_2;
                                                let _e4027 = local_3.member_2;
                                                let _e4030 = local_2.member_2;
                                                let _e4034 = (((((_e4002 * _e4004) + (_e4007 * _e4009)) * f64(2.01f)) + (((_e4015 * _e4000) * (_e4018 * _e4000)) * (1.1102230246251565e-16lf * _e4000))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3999 + _e4027) * (_e3999 + _e4030))));
                                                let _e4035 = (_e3885 * _e3932);
                                                let _e4036 = (((_e3935 * _e3938) - (_e3942 * _e3945)) * _e3932);
                                                let _e4037 = (((_e3986 * _e3989) - (_e3993 * _e3996)) * _e3932);
                                                if (_e4035 < 0.0lf) {
                                                    phi_12820_ = -(_e4035);
                                                } else {
                                                    phi_12820_ = _e4035;
                                                }
                                                let _e4041 = phi_12820_;
                                                if (_e4036 < 0.0lf) {
                                                    phi_12826_ = -(_e4036);
                                                } else {
                                                    phi_12826_ = _e4036;
                                                }
                                                let _e4045 = phi_12826_;
                                                if (_e4037 < 0.0lf) {
                                                    phi_12833_ = -(_e4037);
                                                } else {
                                                    phi_12833_ = _e4037;
                                                }
                                                let _e4050 = phi_12833_;
                                                let _e4054 = (((_e4041 + _e4045) + _e4050) * (1.1102230246251565e-16lf * f64(4f)));
                                                if (_e252.member != 0u) {
                                                    phi_12869_ = array<type_37, 4>(type_37(_e4036, _e3983), type_37(_e4037, _e4034), type_37((_e4035 - _e4036), ((_e3921 + _e3983) + _e4054)), type_37((_e4035 - _e4037), ((_e3921 + _e4034) + _e4054)));
                                                } else {
                                                    let _e4057 = ((_e4035 - _e4036) - _e4037);
                                                    let _e4060 = (((_e3921 + _e3983) + _e4034) + _e4054);
                                                    phi_12869_ = array<type_37, 4>(type_37(_e4036, _e3983), type_37(_e4037, _e4034), type_37(_e4057, _e4060), type_37(_e4057, _e4060));
                                                }
                                                let _e4078 = phi_12869_;
                                                local_5 = array<type_37, 4>(type_37(_e4078[0].member, _e4078[0].member_1), type_37(_e4078[1].member, _e4078[1].member_1), type_37(_e4078[2].member, _e4078[2].member_1), type_37(_e4078[3].member, _e4078[3].member_1));
                                                phi_12889_ = type_9(0u, 4u);
                                                phi_12892_ = true;
                                                loop {
                                                    let _e4097 = phi_12889_;
                                                    let _e4099 = phi_12892_;
                                                    local_27 = _e4099;
                                                    if (_e4097.member < _e4097.member_1) {
                                                        phi_12890_ = type_9((_e4097.member + 1u), _e4097.member_1);
                                                        phi_12915_ = type_9(1u, _e4097.member);
                                                    } else {
                                                        phi_12890_ = _e4097;
                                                        phi_12915_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e4111 = phi_12890_;
                                                    let _e4113 = phi_12915_;
                                                    if (bitcast<i32>(_e4113.member) != 0i) {
                                                        let _e4120 = local_5[_e4113.member_1].member;
                                                        let _e4123 = local_5[_e4113.member_1].member_1;
                                                        let _e4125 = (_e4120 < -(_e4123));
                                                        if _e4125 {
                                                            phi_12942_ = bool();
                                                            phi_12943_ = false;
                                                        } else {
                                                            phi_12942_ = (_e4099 && (_e4120 > _e4123));
                                                            phi_12943_ = true;
                                                        }
                                                        let _e4129 = phi_12942_;
                                                        let _e4131 = phi_12943_;
                                                        phi_12893_ = _e4129;
                                                        phi_12944_ = _e4131;
                                                        phi_12945_ = _e4125;
                                                    } else {
                                                        phi_12893_ = bool();
                                                        phi_12944_ = false;
                                                        phi_12945_ = false;
                                                    }
                                                    let _e4133 = phi_12893_;
                                                    let _e4135 = phi_12944_;
                                                    let _e4137 = phi_12945_;
                                                    local_26 = _e4137;
                                                    continue;
                                                    continuing {
                                                        phi_12889_ = _e4111;
                                                        phi_12892_ = _e4133;
                                                        break if !(_e4135);
                                                    }
                                                }
                                                let _e4140 = local_26;
                                                if _e4140 {
                                                    phi_12949_ = false;
                                                } else {
                                                    phi_12949_ = true;
                                                }
                                                let _e4142 = phi_12949_;
                                                if _e4142 {
                                                    let _e4144 = local_27;
                                                    if _e4144 {
                                                        phi_12956_ = 1u;
                                                    } else {
                                                        phi_12956_ = 2u;
                                                    }
                                                    let _e4146 = phi_12956_;
                                                    phi_12957_ = _e4146;
                                                    phi_12958_ = false;
                                                } else {
                                                    phi_12957_ = u32();
                                                    phi_12958_ = true;
                                                }
                                                let _e4148 = phi_12957_;
                                                let _e4150 = phi_12958_;
                                                phi_12959_ = _e4148;
                                                phi_12960_ = 0u;
                                                phi_12961_ = _e4150;
                                            } else {
                                                phi_12959_ = u32();
                                                phi_12960_ = 2u;
                                                phi_12961_ = true;
                                            }
                                            let _e4152 = phi_12959_;
                                            let _e4154 = phi_12960_;
                                            let _e4156 = phi_12961_;
                                            if _e4156 {
                                                phi_12965_ = _e4154;
                                            } else {
                                                phi_12965_ = _e4152;
                                            }
                                            let _e4158 = phi_12965_;
                                            let _e4159 = (_e4158 == 0u);
                                            if _e4159 {
                                                phi_15724_ = bool();
                                                phi_15725_ = f64();
                                                phi_15726_ = f64();
                                                phi_15727_ = false;
                                                phi_15728_ = false;
                                                phi_15729_ = false;
                                            } else {
                                                if (_e4158 == 1u) {
                                                    phi_12975_ = _e3404.member_2;
                                                } else {
                                                    phi_12975_ = false;
                                                }
                                                let _e4163 = phi_12975_;
                                                let _e4165 = (_e555 * f64(0.99f));
                                                if _e4163 {
                                                    if ((_e3404.member_1 - _e3404.member) <= _e4165) {
                                                        phi_12988_ = false;
                                                    } else {
                                                        phi_12988_ = true;
                                                    }
                                                    let _e4171 = phi_12988_;
                                                    phi_12989_ = _e4171;
                                                } else {
                                                    phi_12989_ = true;
                                                }
                                                let _e4173 = phi_12989_;
                                                if _e4173 {
                                                    let _e4178 = local_18.member[0u];
                                                    let _e4185 = local_18.member_1[0u];
                                                    let _e4191 = local_18.member_2[0u];
                                                    let _e4195 = (_e4178[0] - _e4185[0]);
                                                    let _e4196 = (_e4178[1] - _e4185[1]);
                                                    let _e4197 = (_e4178[2] - _e4185[2]);
                                                    if (_e252.member == 0u) {
                                                        phi_13050_ = array<f64, 3>(_e4178[0], _e4178[1], _e4178[2]);
                                                    } else {
                                                        phi_13050_ = array<f64, 3>((_e4195 - _e4191[0]), (_e4196 - _e4191[1]), (_e4197 - _e4191[2]));
                                                    }
                                                    let _e4204 = phi_13050_;
                                                    let _e4210 = local_18.member[1u];
                                                    let _e4217 = local_18.member_1[1u];
                                                    let _e4223 = local_18.member_2[1u];
                                                    let _e4227 = (_e4210[0] - _e4217[0]);
                                                    let _e4228 = (_e4210[1] - _e4217[1]);
                                                    let _e4229 = (_e4210[2] - _e4217[2]);
                                                    if (_e252.member == 0u) {
                                                        phi_13115_ = array<f64, 3>(_e4210[0], _e4210[1], _e4210[2]);
                                                    } else {
                                                        phi_13115_ = array<f64, 3>((_e4227 - _e4223[0]), (_e4228 - _e4223[1]), (_e4229 - _e4223[2]));
                                                    }
                                                    let _e4236 = phi_13115_;
                                                    let _e4242 = local_18.member[0u];
                                                    if (_e4242[0] < 0.0lf) {
                                                        phi_13137_ = -(_e4242[0]);
                                                    } else {
                                                        phi_13137_ = _e4242[0];
                                                    }
                                                    let _e4249 = phi_13137_;
                                                    if (_e4242[1] < 0.0lf) {
                                                        phi_13144_ = -(_e4242[1]);
                                                    } else {
                                                        phi_13144_ = _e4242[1];
                                                    }
                                                    let _e4253 = phi_13144_;
                                                    if (_e4249 > _e4253) {
                                                        phi_13149_ = _e4249;
                                                    } else {
                                                        phi_13149_ = _e4253;
                                                    }
                                                    let _e4256 = phi_13149_;
                                                    if (_e4242[2] < 0.0lf) {
                                                        phi_13156_ = -(_e4242[2]);
                                                    } else {
                                                        phi_13156_ = _e4242[2];
                                                    }
                                                    let _e4260 = phi_13156_;
                                                    if (_e4256 > _e4260) {
                                                        phi_13161_ = _e4256;
                                                    } else {
                                                        phi_13161_ = _e4260;
                                                    }
                                                    let _e4263 = phi_13161_;
                                                    let _e4266 = local_18.member[1u];
                                                    if (_e4266[0] < 0.0lf) {
                                                        phi_13174_ = -(_e4266[0]);
                                                    } else {
                                                        phi_13174_ = _e4266[0];
                                                    }
                                                    let _e4273 = phi_13174_;
                                                    if (_e4266[1] < 0.0lf) {
                                                        phi_13181_ = -(_e4266[1]);
                                                    } else {
                                                        phi_13181_ = _e4266[1];
                                                    }
                                                    let _e4277 = phi_13181_;
                                                    if (_e4273 > _e4277) {
                                                        phi_13186_ = _e4273;
                                                    } else {
                                                        phi_13186_ = _e4277;
                                                    }
                                                    let _e4280 = phi_13186_;
                                                    if (_e4266[2] < 0.0lf) {
                                                        phi_13193_ = -(_e4266[2]);
                                                    } else {
                                                        phi_13193_ = _e4266[2];
                                                    }
                                                    let _e4284 = phi_13193_;
                                                    if (_e4280 > _e4284) {
                                                        phi_13198_ = _e4280;
                                                    } else {
                                                        phi_13198_ = _e4284;
                                                    }
                                                    let _e4287 = phi_13198_;
                                                    if (_e4263 > _e4287) {
                                                        phi_13203_ = _e4263;
                                                    } else {
                                                        phi_13203_ = _e4287;
                                                    }
                                                    let _e4290 = phi_13203_;
                                                    let _e4292 = local_18.member_3;
                                                    let _e4296 = local_18.member_1[0u];
                                                    if (_e4296[0] < 0.0lf) {
                                                        phi_13220_ = -(_e4296[0]);
                                                    } else {
                                                        phi_13220_ = _e4296[0];
                                                    }
                                                    let _e4303 = phi_13220_;
                                                    if (_e4296[1] < 0.0lf) {
                                                        phi_13227_ = -(_e4296[1]);
                                                    } else {
                                                        phi_13227_ = _e4296[1];
                                                    }
                                                    let _e4307 = phi_13227_;
                                                    if (_e4303 > _e4307) {
                                                        phi_13232_ = _e4303;
                                                    } else {
                                                        phi_13232_ = _e4307;
                                                    }
                                                    let _e4310 = phi_13232_;
                                                    if (_e4296[2] < 0.0lf) {
                                                        phi_13239_ = -(_e4296[2]);
                                                    } else {
                                                        phi_13239_ = _e4296[2];
                                                    }
                                                    let _e4314 = phi_13239_;
                                                    if (_e4310 > _e4314) {
                                                        phi_13244_ = _e4310;
                                                    } else {
                                                        phi_13244_ = _e4314;
                                                    }
                                                    let _e4317 = phi_13244_;
                                                    let _e4320 = local_18.member_1[1u];
                                                    if (_e4320[0] < 0.0lf) {
                                                        phi_13258_ = -(_e4320[0]);
                                                    } else {
                                                        phi_13258_ = _e4320[0];
                                                    }
                                                    let _e4327 = phi_13258_;
                                                    if (_e4320[1] < 0.0lf) {
                                                        phi_13265_ = -(_e4320[1]);
                                                    } else {
                                                        phi_13265_ = _e4320[1];
                                                    }
                                                    let _e4331 = phi_13265_;
                                                    if (_e4327 > _e4331) {
                                                        phi_13270_ = _e4327;
                                                    } else {
                                                        phi_13270_ = _e4331;
                                                    }
                                                    let _e4334 = phi_13270_;
                                                    if (_e4320[2] < 0.0lf) {
                                                        phi_13277_ = -(_e4320[2]);
                                                    } else {
                                                        phi_13277_ = _e4320[2];
                                                    }
                                                    let _e4338 = phi_13277_;
                                                    if (_e4334 > _e4338) {
                                                        phi_13282_ = _e4334;
                                                    } else {
                                                        phi_13282_ = _e4338;
                                                    }
                                                    let _e4341 = phi_13282_;
                                                    if (_e4317 > _e4341) {
                                                        phi_13287_ = _e4317;
                                                    } else {
                                                        phi_13287_ = _e4341;
                                                    }
                                                    let _e4344 = phi_13287_;
                                                    let _e4346 = local_18.member_3;
                                                    let _e4350 = local_18.member_2[0u];
                                                    if (_e4350[0] < 0.0lf) {
                                                        phi_13304_ = -(_e4350[0]);
                                                    } else {
                                                        phi_13304_ = _e4350[0];
                                                    }
                                                    let _e4357 = phi_13304_;
                                                    if (_e4350[1] < 0.0lf) {
                                                        phi_13311_ = -(_e4350[1]);
                                                    } else {
                                                        phi_13311_ = _e4350[1];
                                                    }
                                                    let _e4361 = phi_13311_;
                                                    if (_e4357 > _e4361) {
                                                        phi_13316_ = _e4357;
                                                    } else {
                                                        phi_13316_ = _e4361;
                                                    }
                                                    let _e4364 = phi_13316_;
                                                    if (_e4350[2] < 0.0lf) {
                                                        phi_13323_ = -(_e4350[2]);
                                                    } else {
                                                        phi_13323_ = _e4350[2];
                                                    }
                                                    let _e4368 = phi_13323_;
                                                    if (_e4364 > _e4368) {
                                                        phi_13328_ = _e4364;
                                                    } else {
                                                        phi_13328_ = _e4368;
                                                    }
                                                    let _e4371 = phi_13328_;
                                                    let _e4374 = local_18.member_2[1u];
                                                    if (_e4374[0] < 0.0lf) {
                                                        phi_13342_ = -(_e4374[0]);
                                                    } else {
                                                        phi_13342_ = _e4374[0];
                                                    }
                                                    let _e4381 = phi_13342_;
                                                    if (_e4374[1] < 0.0lf) {
                                                        phi_13349_ = -(_e4374[1]);
                                                    } else {
                                                        phi_13349_ = _e4374[1];
                                                    }
                                                    let _e4385 = phi_13349_;
                                                    if (_e4381 > _e4385) {
                                                        phi_13354_ = _e4381;
                                                    } else {
                                                        phi_13354_ = _e4385;
                                                    }
                                                    let _e4388 = phi_13354_;
                                                    if (_e4374[2] < 0.0lf) {
                                                        phi_13361_ = -(_e4374[2]);
                                                    } else {
                                                        phi_13361_ = _e4374[2];
                                                    }
                                                    let _e4392 = phi_13361_;
                                                    if (_e4388 > _e4392) {
                                                        phi_13366_ = _e4388;
                                                    } else {
                                                        phi_13366_ = _e4392;
                                                    }
                                                    let _e4395 = phi_13366_;
                                                    if (_e4371 > _e4395) {
                                                        phi_13371_ = _e4371;
                                                    } else {
                                                        phi_13371_ = _e4395;
                                                    }
                                                    let _e4398 = phi_13371_;
                                                    let _e4400 = local_18.member_3;
                                                    let _e4408 = local_18.member_3;
                                                    let _e4416 = (_e555 * f64(0.00390625f));
                                                    let _e4417 = f64(0f);
                                                    let _e4418 = f64(1f);
                                                    local = type_35(array<f64, 4>(_e4417, _e4417, _e4417, _e4417), array<f64, 4>(_e4417, _e4417, _e4417, _e4417), array<f64, 4>(_e4418, _e4418, _e4418, _e4418));
                                                    phi_13418_ = type_9(0u, 96u);
                                                    phi_13421_ = _e3404.member;
                                                    phi_13423_ = _e3404.member;
                                                    phi_13425_ = (_e3404.member_1 - _e3404.member);
                                                    phi_13427_ = _e3404.member;
                                                    phi_13429_ = false;
                                                    phi_13431_ = 0u;
                                                    loop {
                                                        let _e4425 = phi_13418_;
                                                        let _e4427 = phi_13421_;
                                                        let _e4429 = phi_13423_;
                                                        let _e4431 = phi_13425_;
                                                        let _e4433 = phi_13427_;
                                                        let _e4435 = phi_13429_;
                                                        let _e4437 = phi_13431_;
                                                        local_31 = _e4427;
                                                        local_78 = _e4429;
                                                        if (_e4425.member < _e4425.member_1) {
                                                            phi_13419_ = type_9((_e4425.member + 1u), _e4425.member_1);
                                                            phi_13454_ = type_9(1u, _e4425.member);
                                                        } else {
                                                            phi_13419_ = _e4425;
                                                            phi_13454_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e4449 = phi_13419_;
                                                        let _e4451 = phi_13454_;
                                                        if (bitcast<i32>(_e4451.member) != 0i) {
                                                            let _e4457 = local_18.member[0u];
                                                            let _e4463 = local_18.member[1u];
                                                            let _e4479 = local_18.member_1[0u];
                                                            let _e4485 = local_18.member_1[1u];
                                                            let _e4501 = local_18.member_2[0u];
                                                            let _e4507 = local_18.member_2[1u];
                                                            let _e4521 = function_4(array<f64, 3>((_e4457[0] + ((_e4463[0] - _e4457[0]) * _e4427)), (_e4457[1] + ((_e4463[1] - _e4457[1]) * _e4427)), (_e4457[2] + ((_e4463[2] - _e4457[2]) * _e4427))), array<f64, 3>((_e4479[0] + ((_e4485[0] - _e4479[0]) * _e4427)), (_e4479[1] + ((_e4485[1] - _e4479[1]) * _e4427)), (_e4479[2] + ((_e4485[2] - _e4479[2]) * _e4427))), array<f64, 3>((_e4501[0] + ((_e4507[0] - _e4501[0]) * _e4427)), (_e4501[1] + ((_e4507[1] - _e4501[1]) * _e4427)), (_e4501[2] + ((_e4507[2] - _e4501[2]) * _e4427))), _e252.member);
                                                            if (_e4437 == 0u) {
                                                                phi_13583_ = _e4521;
                                                            } else {
                                                                let _e4523 = f64(0f);
                                                                if (_e4437 == 1u) {
                                                                    phi_13569_ = _e4521[0];
                                                                } else {
                                                                    phi_13569_ = _e4523;
                                                                }
                                                                let _e4527 = phi_13569_;
                                                                if (_e4437 == 2u) {
                                                                    phi_13575_ = _e4521[1];
                                                                } else {
                                                                    phi_13575_ = _e4523;
                                                                }
                                                                let _e4531 = phi_13575_;
                                                                if (_e4437 == 3u) {
                                                                    phi_13581_ = _e4521[2];
                                                                } else {
                                                                    phi_13581_ = _e4523;
                                                                }
                                                                let _e4535 = phi_13581_;
                                                                phi_13583_ = array<f64, 3>(_e4527, _e4531, _e4535);
                                                            }
                                                            let _e4538 = phi_13583_;
                                                            if (_e4538[0] < 0.0lf) {
                                                                phi_13590_ = -(_e4538[0]);
                                                            } else {
                                                                phi_13590_ = _e4538[0];
                                                            }
                                                            let _e4543 = phi_13590_;
                                                            if (_e4538[1] < 0.0lf) {
                                                                phi_13597_ = -(_e4538[1]);
                                                            } else {
                                                                phi_13597_ = _e4538[1];
                                                            }
                                                            let _e4548 = phi_13597_;
                                                            if (_e4538[2] < 0.0lf) {
                                                                phi_13605_ = -(_e4538[2]);
                                                            } else {
                                                                phi_13605_ = _e4538[2];
                                                            }
                                                            let _e4554 = phi_13605_;
                                                            let _e4555 = ((_e4543 + _e4548) + _e4554);
                                                            if (_e4555 > f64(0f)) {
                                                                if ((bitcast<u64>(_e4555) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                                    let _e4562 = (f64(1f) / _e4555);
                                                                    let _e4564 = (_e4538[0] * _e4562);
                                                                    let _e4566 = (_e4538[1] * _e4562);
                                                                    let _e4568 = (_e4538[2] * _e4562);
                                                                    let _e4573 = (((_e4564 * _e4564) + (_e4566 * _e4566)) + (_e4568 * _e4568));
                                                                    if (_e4573 <= 2.2250738585072014e-308lf) {
                                                                        if (_e4573 > 0.0lf) {
                                                                            phi_13644_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_13644_ = 0.0lf;
                                                                        }
                                                                        let _e4625 = phi_13644_;
                                                                        phi_13708_ = _e4625;
                                                                    } else {
                                                                        phi_13651_ = type_18(0i, 5i);
                                                                        phi_13654_ = bitcast<f64>(((bitcast<u64>(_e4573) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e4580 = phi_13651_;
                                                                            let _e4582 = phi_13654_;
                                                                            local_28 = _e4582;
                                                                            if (_e4580.member < _e4580.member_1) {
                                                                                let _e4589 = (_e4580.member + 1i);
                                                                                if ((false == (_e4589 > _e4580.member)) != false) {
                                                                                    phi_13675_ = true;
                                                                                } else {
                                                                                    phi_13675_ = false;
                                                                                }
                                                                                let _e4594 = phi_13675_;
                                                                                if _e4594 {
                                                                                    phi_13681_ = type_19(0u, type_19().member_1);
                                                                                } else {
                                                                                    phi_13681_ = type_19(1u, _e4589);
                                                                                }
                                                                                let _e4599 = phi_13681_;
                                                                                phi_13652_ = type_18(_e4599.member_1, _e4580.member_1);
                                                                                phi_13695_ = type_19(1u, _e4580.member);
                                                                            } else {
                                                                                phi_13652_ = _e4580;
                                                                                phi_13695_ = type_19(0u, type_19().member_1);
                                                                            }
                                                                            let _e4605 = phi_13652_;
                                                                            let _e4607 = phi_13695_;
                                                                            let _e4610 = (bitcast<i32>(_e4607.member) != 0i);
                                                                            if _e4610 {
                                                                                phi_13655_ = (0.5lf * (_e4582 + (_e4573 / _e4582)));
                                                                            } else {
                                                                                phi_13655_ = f64();
                                                                            }
                                                                            let _e4615 = phi_13655_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_13651_ = _e4605;
                                                                                phi_13654_ = _e4615;
                                                                                break if !(_e4610);
                                                                            }
                                                                        }
                                                                        let _e4620 = local_28;
                                                                        phi_13708_ = (_e4620 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e4627 = phi_13708_;
                                                                    let _e4629 = (1.1102230246251565e-16lf * f64(12f));
                                                                    let _e4636 = ((((((((_e4290 + _e4292) + (_e4344 + _e4346)) + (_e4398 + _e4400)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4408 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e884 * _e4627) * (f64(1f) + _e4629)));
                                                                    let _e4641 = (((_e4564 * _e4178[0]) + (_e4566 * _e4178[1])) + (_e4568 * _e4178[2]));
                                                                    let _e4646 = (((_e4564 * _e4195) + (_e4566 * _e4196)) + (_e4568 * _e4197));
                                                                    let _e4651 = (((_e4564 * (_e4178[0] - _e4191[0])) + (_e4566 * (_e4178[1] - _e4191[1]))) + (_e4568 * (_e4178[2] - _e4191[2])));
                                                                    let _e4659 = (((_e4564 * _e4204[0]) + (_e4566 * _e4204[1])) + (_e4568 * _e4204[2]));
                                                                    let _e4665 = (((_e4564 * _e4210[0]) + (_e4566 * _e4210[1])) + (_e4568 * _e4210[2]));
                                                                    let _e4670 = (((_e4564 * _e4227) + (_e4566 * _e4228)) + (_e4568 * _e4229));
                                                                    let _e4675 = (((_e4564 * (_e4210[0] - _e4223[0])) + (_e4566 * (_e4210[1] - _e4223[1]))) + (_e4568 * (_e4210[2] - _e4223[2])));
                                                                    let _e4683 = (((_e4564 * _e4236[0]) + (_e4566 * _e4236[1])) + (_e4568 * _e4236[2]));
                                                                    if (_e4641 < 0.0lf) {
                                                                        phi_13777_ = -(_e4641);
                                                                    } else {
                                                                        phi_13777_ = _e4641;
                                                                    }
                                                                    let _e4688 = phi_13777_;
                                                                    if (_e4665 < 0.0lf) {
                                                                        phi_13783_ = -(_e4665);
                                                                    } else {
                                                                        phi_13783_ = _e4665;
                                                                    }
                                                                    let _e4692 = phi_13783_;
                                                                    if (_e4646 < 0.0lf) {
                                                                        phi_13792_ = -(_e4646);
                                                                    } else {
                                                                        phi_13792_ = _e4646;
                                                                    }
                                                                    let _e4699 = phi_13792_;
                                                                    if (_e4670 < 0.0lf) {
                                                                        phi_13798_ = -(_e4670);
                                                                    } else {
                                                                        phi_13798_ = _e4670;
                                                                    }
                                                                    let _e4703 = phi_13798_;
                                                                    if (_e4651 < 0.0lf) {
                                                                        phi_13807_ = -(_e4651);
                                                                    } else {
                                                                        phi_13807_ = _e4651;
                                                                    }
                                                                    let _e4710 = phi_13807_;
                                                                    if (_e4675 < 0.0lf) {
                                                                        phi_13813_ = -(_e4675);
                                                                    } else {
                                                                        phi_13813_ = _e4675;
                                                                    }
                                                                    let _e4714 = phi_13813_;
                                                                    if (_e4659 < 0.0lf) {
                                                                        phi_13822_ = -(_e4659);
                                                                    } else {
                                                                        phi_13822_ = _e4659;
                                                                    }
                                                                    let _e4721 = phi_13822_;
                                                                    if (_e4683 < 0.0lf) {
                                                                        phi_13828_ = -(_e4683);
                                                                    } else {
                                                                        phi_13828_ = _e4683;
                                                                    }
                                                                    let _e4725 = phi_13828_;
                                                                    phi_13834_ = type_35(array<f64, 4>(_e4641, _e4646, _e4651, _e4659), array<f64, 4>(_e4665, _e4670, _e4675, _e4683), array<f64, 4>((_e4636 + ((_e4688 + _e4692) * _e4629)), (_e4636 + ((_e4699 + _e4703) * _e4629)), (_e4636 + ((_e4710 + _e4714) * _e4629)), (_e4636 + ((_e4721 + _e4725) * _e4629))));
                                                                    phi_13835_ = false;
                                                                } else {
                                                                    phi_13834_ = type_35();
                                                                    phi_13835_ = true;
                                                                }
                                                                let _e4732 = phi_13834_;
                                                                let _e4734 = phi_13835_;
                                                                phi_13836_ = _e4732;
                                                                phi_13837_ = _e4734;
                                                            } else {
                                                                phi_13836_ = type_35();
                                                                phi_13837_ = true;
                                                            }
                                                            let _e4736 = phi_13836_;
                                                            let _e4738 = phi_13837_;
                                                            if _e4738 {
                                                                let _e4739 = f64(0f);
                                                                let _e4740 = f64(1f);
                                                                phi_13847_ = type_35(array<f64, 4>(_e4739, _e4739, _e4739, _e4739), array<f64, 4>(_e4739, _e4739, _e4739, _e4739), array<f64, 4>(_e4740, _e4740, _e4740, _e4740));
                                                            } else {
                                                                phi_13847_ = _e4736;
                                                            }
                                                            let _e4746 = phi_13847_;
                                                            local_1 = type_35(array<f64, 4>(_e4746.member[0], _e4746.member[1], _e4746.member[2], _e4746.member[3]), array<f64, 4>(_e4746.member_1[0], _e4746.member_1[1], _e4746.member_1[2], _e4746.member_1[3]), array<f64, 4>(_e4746.member_2[0], _e4746.member_2[1], _e4746.member_2[2], _e4746.member_2[3]));
                                                            let _e4766 = (_e4427 - _e4433);
                                                            let _e4768 = f64(0f);
                                                            let _e4771 = local_1.member[0u];
                                                            let _e4774 = local_1.member_1[0u];
                                                            let _e4777 = local_1.member[0u];
                                                            let _e4783 = local_1.member_2[0u];
                                                            if (((_e4771 + ((_e4774 - _e4777) * _e4427)) - _e4783) > _e4768) {
                                                                let _e4788 = local_1.member[1u];
                                                                let _e4791 = local_1.member_1[1u];
                                                                let _e4794 = local_1.member[1u];
                                                                let _e4800 = local_1.member_2[1u];
                                                                if (((_e4788 + ((_e4791 - _e4794) * _e4427)) - _e4800) > _e4768) {
                                                                    let _e4805 = local_1.member[2u];
                                                                    let _e4808 = local_1.member_1[2u];
                                                                    let _e4811 = local_1.member[2u];
                                                                    let _e4817 = local_1.member_2[2u];
                                                                    if (((_e4805 + ((_e4808 - _e4811) * _e4427)) - _e4817) > _e4768) {
                                                                        let _e4822 = local_1.member[3u];
                                                                        let _e4825 = local_1.member_1[3u];
                                                                        let _e4828 = local_1.member[3u];
                                                                        let _e4834 = local_1.member_2[3u];
                                                                        phi_14019_ = (((_e4822 + ((_e4825 - _e4828) * _e4427)) - _e4834) > _e4768);
                                                                        phi_14020_ = false;
                                                                    } else {
                                                                        phi_14019_ = bool();
                                                                        phi_14020_ = true;
                                                                    }
                                                                    let _e4838 = phi_14019_;
                                                                    let _e4840 = phi_14020_;
                                                                    phi_14021_ = _e4838;
                                                                    phi_14022_ = _e4840;
                                                                } else {
                                                                    phi_14021_ = bool();
                                                                    phi_14022_ = true;
                                                                }
                                                                let _e4842 = phi_14021_;
                                                                let _e4844 = phi_14022_;
                                                                phi_14023_ = _e4842;
                                                                phi_14024_ = _e4844;
                                                            } else {
                                                                phi_14023_ = bool();
                                                                phi_14024_ = true;
                                                            }
                                                            let _e4846 = phi_14023_;
                                                            let _e4848 = phi_14024_;
                                                            if _e4848 {
                                                                phi_14028_ = false;
                                                            } else {
                                                                phi_14028_ = _e4846;
                                                            }
                                                            let _e4850 = phi_14028_;
                                                            if _e4850 {
                                                                if (_e4427 <= _e4429) {
                                                                    phi_14339_ = true;
                                                                } else {
                                                                    let _e4852 = f64(0f);
                                                                    let _e4855 = local.member[0u];
                                                                    let _e4858 = local.member_1[0u];
                                                                    let _e4861 = local.member[0u];
                                                                    let _e4867 = local.member_2[0u];
                                                                    let _e4871 = local_1.member[0u];
                                                                    let _e4874 = local_1.member_1[0u];
                                                                    let _e4877 = local_1.member[0u];
                                                                    let _e4883 = local_1.member_2[0u];
                                                                    if ((((_e4855 + ((_e4858 - _e4861) * _e4427)) - _e4867) + ((_e4871 + ((_e4874 - _e4877) * _e4433)) - _e4883)) > _e4852) {
                                                                        let _e4889 = local.member[1u];
                                                                        let _e4892 = local.member_1[1u];
                                                                        let _e4895 = local.member[1u];
                                                                        let _e4901 = local.member_2[1u];
                                                                        let _e4905 = local_1.member[1u];
                                                                        let _e4908 = local_1.member_1[1u];
                                                                        let _e4911 = local_1.member[1u];
                                                                        let _e4917 = local_1.member_2[1u];
                                                                        if ((((_e4889 + ((_e4892 - _e4895) * _e4427)) - _e4901) + ((_e4905 + ((_e4908 - _e4911) * _e4433)) - _e4917)) > _e4852) {
                                                                            let _e4923 = local.member[2u];
                                                                            let _e4926 = local.member_1[2u];
                                                                            let _e4929 = local.member[2u];
                                                                            let _e4935 = local.member_2[2u];
                                                                            let _e4939 = local_1.member[2u];
                                                                            let _e4942 = local_1.member_1[2u];
                                                                            let _e4945 = local_1.member[2u];
                                                                            let _e4951 = local_1.member_2[2u];
                                                                            if ((((_e4923 + ((_e4926 - _e4929) * _e4427)) - _e4935) + ((_e4939 + ((_e4942 - _e4945) * _e4433)) - _e4951)) > _e4852) {
                                                                                let _e4957 = local.member[3u];
                                                                                let _e4960 = local.member_1[3u];
                                                                                let _e4963 = local.member[3u];
                                                                                let _e4969 = local.member_2[3u];
                                                                                let _e4973 = local_1.member[3u];
                                                                                let _e4976 = local_1.member_1[3u];
                                                                                let _e4979 = local_1.member[3u];
                                                                                let _e4985 = local_1.member_2[3u];
                                                                                phi_14326_ = ((((_e4957 + ((_e4960 - _e4963) * _e4427)) - _e4969) + ((_e4973 + ((_e4976 - _e4979) * _e4433)) - _e4985)) > _e4852);
                                                                                phi_14327_ = false;
                                                                            } else {
                                                                                phi_14326_ = bool();
                                                                                phi_14327_ = true;
                                                                            }
                                                                            let _e4990 = phi_14326_;
                                                                            let _e4992 = phi_14327_;
                                                                            phi_14328_ = _e4990;
                                                                            phi_14329_ = _e4992;
                                                                        } else {
                                                                            phi_14328_ = bool();
                                                                            phi_14329_ = true;
                                                                        }
                                                                        let _e4994 = phi_14328_;
                                                                        let _e4996 = phi_14329_;
                                                                        phi_14330_ = _e4994;
                                                                        phi_14331_ = _e4996;
                                                                    } else {
                                                                        phi_14330_ = bool();
                                                                        phi_14331_ = true;
                                                                    }
                                                                    let _e4998 = phi_14330_;
                                                                    let _e5000 = phi_14331_;
                                                                    if _e5000 {
                                                                        phi_14335_ = false;
                                                                    } else {
                                                                        phi_14335_ = _e4998;
                                                                    }
                                                                    let _e5002 = phi_14335_;
                                                                    phi_14339_ = _e5002;
                                                                }
                                                                let _e5004 = phi_14339_;
                                                                if _e5004 {
                                                                    if _e4435 {
                                                                        if (_e4427 >= _e3404.member_1) {
                                                                            phi_14350_ = false;
                                                                        } else {
                                                                            phi_14350_ = true;
                                                                        }
                                                                        let _e5007 = phi_14350_;
                                                                        phi_14351_ = _e5007;
                                                                    } else {
                                                                        phi_14351_ = true;
                                                                    }
                                                                    let _e5009 = phi_14351_;
                                                                    if _e5009 {
                                                                        local = type_35(array<f64, 4>(_e4746.member[0], _e4746.member[1], _e4746.member[2], _e4746.member[3]), array<f64, 4>(_e4746.member_1[0], _e4746.member_1[1], _e4746.member_1[2], _e4746.member_1[3]), array<f64, 4>(_e4746.member_2[0], _e4746.member_2[1], _e4746.member_2[2], _e4746.member_2[3]));
                                                                        let _e5031 = local.member[0u];
                                                                        let _e5034 = local.member_1[0u];
                                                                        let _e5037 = local.member_2[0u];
                                                                        if (_e5031 > _e5037) {
                                                                            if (_e5034 > _e5037) {
                                                                                phi_14425_ = false;
                                                                            } else {
                                                                                phi_14425_ = true;
                                                                            }
                                                                            let _e5041 = phi_14425_;
                                                                            phi_14426_ = _e5041;
                                                                        } else {
                                                                            phi_14426_ = true;
                                                                        }
                                                                        let _e5043 = phi_14426_;
                                                                        if _e5043 {
                                                                            let _e5044 = (_e5034 >= _e5031);
                                                                            if _e5044 {
                                                                                phi_14451_ = f64();
                                                                                phi_14452_ = false;
                                                                            } else {
                                                                                if ((_e5031 - _e5034) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14449_ = (((_e5031 - _e5037) / (_e5031 - _e5034)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14450_ = false;
                                                                                } else {
                                                                                    phi_14449_ = f64();
                                                                                    phi_14450_ = true;
                                                                                }
                                                                                let _e5058 = phi_14449_;
                                                                                let _e5060 = phi_14450_;
                                                                                phi_14451_ = _e5058;
                                                                                phi_14452_ = _e5060;
                                                                            }
                                                                            let _e5062 = phi_14451_;
                                                                            let _e5064 = phi_14452_;
                                                                            phi_14453_ = _e5062;
                                                                            phi_14454_ = _e5044;
                                                                            phi_14455_ = _e5064;
                                                                        } else {
                                                                            phi_14453_ = f64();
                                                                            phi_14454_ = true;
                                                                            phi_14455_ = false;
                                                                        }
                                                                        let _e5066 = phi_14453_;
                                                                        let _e5068 = phi_14454_;
                                                                        let _e5070 = phi_14455_;
                                                                        if _e5068 {
                                                                            phi_14460_ = f64(2f);
                                                                            phi_14461_ = true;
                                                                        } else {
                                                                            phi_14460_ = _e4427;
                                                                            phi_14461_ = _e5070;
                                                                        }
                                                                        let _e5073 = phi_14460_;
                                                                        let _e5075 = phi_14461_;
                                                                        if _e5075 {
                                                                            phi_14465_ = _e5073;
                                                                        } else {
                                                                            phi_14465_ = _e5066;
                                                                        }
                                                                        let _e5077 = phi_14465_;
                                                                        let _e5080 = local.member[1u];
                                                                        let _e5083 = local.member_1[1u];
                                                                        let _e5086 = local.member_2[1u];
                                                                        if (_e5080 > _e5086) {
                                                                            if (_e5083 > _e5086) {
                                                                                phi_14497_ = false;
                                                                            } else {
                                                                                phi_14497_ = true;
                                                                            }
                                                                            let _e5090 = phi_14497_;
                                                                            phi_14498_ = _e5090;
                                                                        } else {
                                                                            phi_14498_ = true;
                                                                        }
                                                                        let _e5092 = phi_14498_;
                                                                        if _e5092 {
                                                                            let _e5093 = (_e5083 >= _e5080);
                                                                            if _e5093 {
                                                                                phi_14523_ = f64();
                                                                                phi_14524_ = false;
                                                                            } else {
                                                                                if ((_e5080 - _e5083) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14521_ = (((_e5080 - _e5086) / (_e5080 - _e5083)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14522_ = false;
                                                                                } else {
                                                                                    phi_14521_ = f64();
                                                                                    phi_14522_ = true;
                                                                                }
                                                                                let _e5107 = phi_14521_;
                                                                                let _e5109 = phi_14522_;
                                                                                phi_14523_ = _e5107;
                                                                                phi_14524_ = _e5109;
                                                                            }
                                                                            let _e5111 = phi_14523_;
                                                                            let _e5113 = phi_14524_;
                                                                            phi_14525_ = _e5111;
                                                                            phi_14526_ = _e5093;
                                                                            phi_14527_ = _e5113;
                                                                        } else {
                                                                            phi_14525_ = f64();
                                                                            phi_14526_ = true;
                                                                            phi_14527_ = false;
                                                                        }
                                                                        let _e5115 = phi_14525_;
                                                                        let _e5117 = phi_14526_;
                                                                        let _e5119 = phi_14527_;
                                                                        if _e5117 {
                                                                            phi_14532_ = f64(2f);
                                                                            phi_14533_ = true;
                                                                        } else {
                                                                            phi_14532_ = _e4427;
                                                                            phi_14533_ = _e5119;
                                                                        }
                                                                        let _e5122 = phi_14532_;
                                                                        let _e5124 = phi_14533_;
                                                                        if _e5124 {
                                                                            phi_14537_ = _e5122;
                                                                        } else {
                                                                            phi_14537_ = _e5115;
                                                                        }
                                                                        let _e5126 = phi_14537_;
                                                                        if (_e5077 < _e5126) {
                                                                            phi_14542_ = _e5077;
                                                                        } else {
                                                                            phi_14542_ = _e5126;
                                                                        }
                                                                        let _e5129 = phi_14542_;
                                                                        let _e5132 = local.member[2u];
                                                                        let _e5135 = local.member_1[2u];
                                                                        let _e5138 = local.member_2[2u];
                                                                        if (_e5132 > _e5138) {
                                                                            if (_e5135 > _e5138) {
                                                                                phi_14574_ = false;
                                                                            } else {
                                                                                phi_14574_ = true;
                                                                            }
                                                                            let _e5142 = phi_14574_;
                                                                            phi_14575_ = _e5142;
                                                                        } else {
                                                                            phi_14575_ = true;
                                                                        }
                                                                        let _e5144 = phi_14575_;
                                                                        if _e5144 {
                                                                            let _e5145 = (_e5135 >= _e5132);
                                                                            if _e5145 {
                                                                                phi_14600_ = f64();
                                                                                phi_14601_ = false;
                                                                            } else {
                                                                                if ((_e5132 - _e5135) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14598_ = (((_e5132 - _e5138) / (_e5132 - _e5135)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14599_ = false;
                                                                                } else {
                                                                                    phi_14598_ = f64();
                                                                                    phi_14599_ = true;
                                                                                }
                                                                                let _e5159 = phi_14598_;
                                                                                let _e5161 = phi_14599_;
                                                                                phi_14600_ = _e5159;
                                                                                phi_14601_ = _e5161;
                                                                            }
                                                                            let _e5163 = phi_14600_;
                                                                            let _e5165 = phi_14601_;
                                                                            phi_14602_ = _e5163;
                                                                            phi_14603_ = _e5145;
                                                                            phi_14604_ = _e5165;
                                                                        } else {
                                                                            phi_14602_ = f64();
                                                                            phi_14603_ = true;
                                                                            phi_14604_ = false;
                                                                        }
                                                                        let _e5167 = phi_14602_;
                                                                        let _e5169 = phi_14603_;
                                                                        let _e5171 = phi_14604_;
                                                                        if _e5169 {
                                                                            phi_14609_ = f64(2f);
                                                                            phi_14610_ = true;
                                                                        } else {
                                                                            phi_14609_ = _e4427;
                                                                            phi_14610_ = _e5171;
                                                                        }
                                                                        let _e5174 = phi_14609_;
                                                                        let _e5176 = phi_14610_;
                                                                        if _e5176 {
                                                                            phi_14614_ = _e5174;
                                                                        } else {
                                                                            phi_14614_ = _e5167;
                                                                        }
                                                                        let _e5178 = phi_14614_;
                                                                        let _e5181 = local.member[3u];
                                                                        let _e5184 = local.member_1[3u];
                                                                        let _e5187 = local.member_2[3u];
                                                                        if (_e5181 > _e5187) {
                                                                            if (_e5184 > _e5187) {
                                                                                phi_14646_ = false;
                                                                            } else {
                                                                                phi_14646_ = true;
                                                                            }
                                                                            let _e5191 = phi_14646_;
                                                                            phi_14647_ = _e5191;
                                                                        } else {
                                                                            phi_14647_ = true;
                                                                        }
                                                                        let _e5193 = phi_14647_;
                                                                        if _e5193 {
                                                                            let _e5194 = (_e5184 >= _e5181);
                                                                            if _e5194 {
                                                                                phi_14672_ = f64();
                                                                                phi_14673_ = false;
                                                                            } else {
                                                                                if ((_e5181 - _e5184) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14670_ = (((_e5181 - _e5187) / (_e5181 - _e5184)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14671_ = false;
                                                                                } else {
                                                                                    phi_14670_ = f64();
                                                                                    phi_14671_ = true;
                                                                                }
                                                                                let _e5208 = phi_14670_;
                                                                                let _e5210 = phi_14671_;
                                                                                phi_14672_ = _e5208;
                                                                                phi_14673_ = _e5210;
                                                                            }
                                                                            let _e5212 = phi_14672_;
                                                                            let _e5214 = phi_14673_;
                                                                            phi_14674_ = _e5212;
                                                                            phi_14675_ = _e5194;
                                                                            phi_14676_ = _e5214;
                                                                        } else {
                                                                            phi_14674_ = f64();
                                                                            phi_14675_ = true;
                                                                            phi_14676_ = false;
                                                                        }
                                                                        let _e5216 = phi_14674_;
                                                                        let _e5218 = phi_14675_;
                                                                        let _e5220 = phi_14676_;
                                                                        if _e5218 {
                                                                            phi_14681_ = f64(2f);
                                                                            phi_14682_ = true;
                                                                        } else {
                                                                            phi_14681_ = _e4427;
                                                                            phi_14682_ = _e5220;
                                                                        }
                                                                        let _e5223 = phi_14681_;
                                                                        let _e5225 = phi_14682_;
                                                                        if _e5225 {
                                                                            phi_14686_ = _e5223;
                                                                        } else {
                                                                            phi_14686_ = _e5216;
                                                                        }
                                                                        let _e5227 = phi_14686_;
                                                                        if (_e5178 < _e5227) {
                                                                            phi_14691_ = _e5178;
                                                                        } else {
                                                                            phi_14691_ = _e5227;
                                                                        }
                                                                        let _e5230 = phi_14691_;
                                                                        if (_e5129 < _e5230) {
                                                                            phi_14696_ = _e5129;
                                                                        } else {
                                                                            phi_14696_ = _e5230;
                                                                        }
                                                                        let _e5233 = phi_14696_;
                                                                        if (_e5233 > _e4427) {
                                                                            phi_14701_ = _e5233;
                                                                        } else {
                                                                            phi_14701_ = _e4427;
                                                                        }
                                                                        let _e5236 = phi_14701_;
                                                                        let _e5237 = (_e5236 > _e3404.member_1);
                                                                        if _e5237 {
                                                                            phi_15218_ = f64();
                                                                            phi_15219_ = f64();
                                                                            phi_15220_ = false;
                                                                            phi_15221_ = false;
                                                                        } else {
                                                                            let _e5238 = (_e5236 - _e4427);
                                                                            let _e5239 = (_e5238 <= _e4416);
                                                                            let _e5242 = (_e5236 + (_e555 * f64(0.01f)));
                                                                            if (_e5242 < _e3404.member_1) {
                                                                                phi_14715_ = _e5242;
                                                                            } else {
                                                                                phi_14715_ = _e3404.member_1;
                                                                            }
                                                                            let _e5245 = phi_14715_;
                                                                            if _e5239 {
                                                                                if (_e884 > f64(0f)) {
                                                                                    let _e5250 = local_18.member[0u];
                                                                                    let _e5256 = local_18.member[1u];
                                                                                    let _e5272 = local_18.member_1[0u];
                                                                                    let _e5278 = local_18.member_1[1u];
                                                                                    let _e5294 = local_18.member_2[0u];
                                                                                    let _e5300 = local_18.member_2[1u];
                                                                                    let _e5314 = function_4(array<f64, 3>((_e5250[0] + ((_e5256[0] - _e5250[0]) * _e5245)), (_e5250[1] + ((_e5256[1] - _e5250[1]) * _e5245)), (_e5250[2] + ((_e5256[2] - _e5250[2]) * _e5245))), array<f64, 3>((_e5272[0] + ((_e5278[0] - _e5272[0]) * _e5245)), (_e5272[1] + ((_e5278[1] - _e5272[1]) * _e5245)), (_e5272[2] + ((_e5278[2] - _e5272[2]) * _e5245))), array<f64, 3>((_e5294[0] + ((_e5300[0] - _e5294[0]) * _e5245)), (_e5294[1] + ((_e5300[1] - _e5294[1]) * _e5245)), (_e5294[2] + ((_e5300[2] - _e5294[2]) * _e5245))), _e252.member);
                                                                                    let _e5325 = (((_e5314[0] * _e5314[0]) + (_e5314[1] * _e5314[1])) + (_e5314[2] * _e5314[2]));
                                                                                    if (_e5325 <= 2.2250738585072014e-308lf) {
                                                                                        if (_e5325 > 0.0lf) {
                                                                                            phi_14846_ = (1.464336215552873e-154lf * 2.0lf);
                                                                                        } else {
                                                                                            phi_14846_ = 0.0lf;
                                                                                        }
                                                                                        let _e5377 = phi_14846_;
                                                                                        phi_14910_ = _e5377;
                                                                                    } else {
                                                                                        phi_14853_ = type_18(0i, 5i);
                                                                                        phi_14856_ = bitcast<f64>(((bitcast<u64>(_e5325) / 2lu) + 2303426169912950784lu));
                                                                                        loop {
                                                                                            let _e5332 = phi_14853_;
                                                                                            let _e5334 = phi_14856_;
                                                                                            local_29 = _e5334;
                                                                                            if (_e5332.member < _e5332.member_1) {
                                                                                                let _e5341 = (_e5332.member + 1i);
                                                                                                if ((false == (_e5341 > _e5332.member)) != false) {
                                                                                                    phi_14877_ = true;
                                                                                                } else {
                                                                                                    phi_14877_ = false;
                                                                                                }
                                                                                                let _e5346 = phi_14877_;
                                                                                                if _e5346 {
                                                                                                    phi_14883_ = type_19(0u, type_19().member_1);
                                                                                                } else {
                                                                                                    phi_14883_ = type_19(1u, _e5341);
                                                                                                }
                                                                                                let _e5351 = phi_14883_;
                                                                                                phi_14854_ = type_18(_e5351.member_1, _e5332.member_1);
                                                                                                phi_14897_ = type_19(1u, _e5332.member);
                                                                                            } else {
                                                                                                phi_14854_ = _e5332;
                                                                                                phi_14897_ = type_19(0u, type_19().member_1);
                                                                                            }
                                                                                            let _e5357 = phi_14854_;
                                                                                            let _e5359 = phi_14897_;
                                                                                            let _e5362 = (bitcast<i32>(_e5359.member) != 0i);
                                                                                            if _e5362 {
                                                                                                phi_14857_ = (0.5lf * (_e5334 + (_e5325 / _e5334)));
                                                                                            } else {
                                                                                                phi_14857_ = f64();
                                                                                            }
                                                                                            let _e5367 = phi_14857_;
                                                                                            continue;
                                                                                            continuing {
                                                                                                phi_14853_ = _e5357;
                                                                                                phi_14856_ = _e5367;
                                                                                                break if !(_e5362);
                                                                                            }
                                                                                        }
                                                                                        let _e5372 = local_29;
                                                                                        phi_14910_ = (_e5372 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                                    }
                                                                                    let _e5379 = phi_14910_;
                                                                                    let _e5387 = local_18.member[0u];
                                                                                    if (_e5387[0] < 0.0lf) {
                                                                                        phi_14928_ = -(_e5387[0]);
                                                                                    } else {
                                                                                        phi_14928_ = _e5387[0];
                                                                                    }
                                                                                    let _e5394 = phi_14928_;
                                                                                    if (_e5387[1] < 0.0lf) {
                                                                                        phi_14935_ = -(_e5387[1]);
                                                                                    } else {
                                                                                        phi_14935_ = _e5387[1];
                                                                                    }
                                                                                    let _e5398 = phi_14935_;
                                                                                    if (_e5394 > _e5398) {
                                                                                        phi_14940_ = _e5394;
                                                                                    } else {
                                                                                        phi_14940_ = _e5398;
                                                                                    }
                                                                                    let _e5401 = phi_14940_;
                                                                                    if (_e5387[2] < 0.0lf) {
                                                                                        phi_14947_ = -(_e5387[2]);
                                                                                    } else {
                                                                                        phi_14947_ = _e5387[2];
                                                                                    }
                                                                                    let _e5405 = phi_14947_;
                                                                                    if (_e5401 > _e5405) {
                                                                                        phi_14952_ = _e5401;
                                                                                    } else {
                                                                                        phi_14952_ = _e5405;
                                                                                    }
                                                                                    let _e5408 = phi_14952_;
                                                                                    let _e5411 = local_18.member[1u];
                                                                                    if (_e5411[0] < 0.0lf) {
                                                                                        phi_14965_ = -(_e5411[0]);
                                                                                    } else {
                                                                                        phi_14965_ = _e5411[0];
                                                                                    }
                                                                                    let _e5418 = phi_14965_;
                                                                                    if (_e5411[1] < 0.0lf) {
                                                                                        phi_14972_ = -(_e5411[1]);
                                                                                    } else {
                                                                                        phi_14972_ = _e5411[1];
                                                                                    }
                                                                                    let _e5422 = phi_14972_;
                                                                                    if (_e5418 > _e5422) {
                                                                                        phi_14977_ = _e5418;
                                                                                    } else {
                                                                                        phi_14977_ = _e5422;
                                                                                    }
                                                                                    let _e5425 = phi_14977_;
                                                                                    if (_e5411[2] < 0.0lf) {
                                                                                        phi_14984_ = -(_e5411[2]);
                                                                                    } else {
                                                                                        phi_14984_ = _e5411[2];
                                                                                    }
                                                                                    let _e5429 = phi_14984_;
                                                                                    if (_e5425 > _e5429) {
                                                                                        phi_14989_ = _e5425;
                                                                                    } else {
                                                                                        phi_14989_ = _e5429;
                                                                                    }
                                                                                    let _e5432 = phi_14989_;
                                                                                    if (_e5408 > _e5432) {
                                                                                        phi_14994_ = _e5408;
                                                                                    } else {
                                                                                        phi_14994_ = _e5432;
                                                                                    }
                                                                                    let _e5435 = phi_14994_;
                                                                                    let _e5437 = local_18.member_3;
                                                                                    let _e5441 = local_18.member_1[0u];
                                                                                    if (_e5441[0] < 0.0lf) {
                                                                                        phi_15011_ = -(_e5441[0]);
                                                                                    } else {
                                                                                        phi_15011_ = _e5441[0];
                                                                                    }
                                                                                    let _e5448 = phi_15011_;
                                                                                    if (_e5441[1] < 0.0lf) {
                                                                                        phi_15018_ = -(_e5441[1]);
                                                                                    } else {
                                                                                        phi_15018_ = _e5441[1];
                                                                                    }
                                                                                    let _e5452 = phi_15018_;
                                                                                    if (_e5448 > _e5452) {
                                                                                        phi_15023_ = _e5448;
                                                                                    } else {
                                                                                        phi_15023_ = _e5452;
                                                                                    }
                                                                                    let _e5455 = phi_15023_;
                                                                                    if (_e5441[2] < 0.0lf) {
                                                                                        phi_15030_ = -(_e5441[2]);
                                                                                    } else {
                                                                                        phi_15030_ = _e5441[2];
                                                                                    }
                                                                                    let _e5459 = phi_15030_;
                                                                                    if (_e5455 > _e5459) {
                                                                                        phi_15035_ = _e5455;
                                                                                    } else {
                                                                                        phi_15035_ = _e5459;
                                                                                    }
                                                                                    let _e5462 = phi_15035_;
                                                                                    let _e5465 = local_18.member_1[1u];
                                                                                    if (_e5465[0] < 0.0lf) {
                                                                                        phi_15049_ = -(_e5465[0]);
                                                                                    } else {
                                                                                        phi_15049_ = _e5465[0];
                                                                                    }
                                                                                    let _e5472 = phi_15049_;
                                                                                    if (_e5465[1] < 0.0lf) {
                                                                                        phi_15056_ = -(_e5465[1]);
                                                                                    } else {
                                                                                        phi_15056_ = _e5465[1];
                                                                                    }
                                                                                    let _e5476 = phi_15056_;
                                                                                    if (_e5472 > _e5476) {
                                                                                        phi_15061_ = _e5472;
                                                                                    } else {
                                                                                        phi_15061_ = _e5476;
                                                                                    }
                                                                                    let _e5479 = phi_15061_;
                                                                                    if (_e5465[2] < 0.0lf) {
                                                                                        phi_15068_ = -(_e5465[2]);
                                                                                    } else {
                                                                                        phi_15068_ = _e5465[2];
                                                                                    }
                                                                                    let _e5483 = phi_15068_;
                                                                                    if (_e5479 > _e5483) {
                                                                                        phi_15073_ = _e5479;
                                                                                    } else {
                                                                                        phi_15073_ = _e5483;
                                                                                    }
                                                                                    let _e5486 = phi_15073_;
                                                                                    if (_e5462 > _e5486) {
                                                                                        phi_15078_ = _e5462;
                                                                                    } else {
                                                                                        phi_15078_ = _e5486;
                                                                                    }
                                                                                    let _e5489 = phi_15078_;
                                                                                    let _e5491 = local_18.member_3;
                                                                                    let _e5495 = local_18.member_2[0u];
                                                                                    if (_e5495[0] < 0.0lf) {
                                                                                        phi_15095_ = -(_e5495[0]);
                                                                                    } else {
                                                                                        phi_15095_ = _e5495[0];
                                                                                    }
                                                                                    let _e5502 = phi_15095_;
                                                                                    if (_e5495[1] < 0.0lf) {
                                                                                        phi_15102_ = -(_e5495[1]);
                                                                                    } else {
                                                                                        phi_15102_ = _e5495[1];
                                                                                    }
                                                                                    let _e5506 = phi_15102_;
                                                                                    if (_e5502 > _e5506) {
                                                                                        phi_15107_ = _e5502;
                                                                                    } else {
                                                                                        phi_15107_ = _e5506;
                                                                                    }
                                                                                    let _e5509 = phi_15107_;
                                                                                    if (_e5495[2] < 0.0lf) {
                                                                                        phi_15114_ = -(_e5495[2]);
                                                                                    } else {
                                                                                        phi_15114_ = _e5495[2];
                                                                                    }
                                                                                    let _e5513 = phi_15114_;
                                                                                    if (_e5509 > _e5513) {
                                                                                        phi_15119_ = _e5509;
                                                                                    } else {
                                                                                        phi_15119_ = _e5513;
                                                                                    }
                                                                                    let _e5516 = phi_15119_;
                                                                                    let _e5519 = local_18.member_2[1u];
                                                                                    if (_e5519[0] < 0.0lf) {
                                                                                        phi_15133_ = -(_e5519[0]);
                                                                                    } else {
                                                                                        phi_15133_ = _e5519[0];
                                                                                    }
                                                                                    let _e5526 = phi_15133_;
                                                                                    if (_e5519[1] < 0.0lf) {
                                                                                        phi_15140_ = -(_e5519[1]);
                                                                                    } else {
                                                                                        phi_15140_ = _e5519[1];
                                                                                    }
                                                                                    let _e5530 = phi_15140_;
                                                                                    if (_e5526 > _e5530) {
                                                                                        phi_15145_ = _e5526;
                                                                                    } else {
                                                                                        phi_15145_ = _e5530;
                                                                                    }
                                                                                    let _e5533 = phi_15145_;
                                                                                    if (_e5519[2] < 0.0lf) {
                                                                                        phi_15152_ = -(_e5519[2]);
                                                                                    } else {
                                                                                        phi_15152_ = _e5519[2];
                                                                                    }
                                                                                    let _e5537 = phi_15152_;
                                                                                    if (_e5533 > _e5537) {
                                                                                        phi_15157_ = _e5533;
                                                                                    } else {
                                                                                        phi_15157_ = _e5537;
                                                                                    }
                                                                                    let _e5540 = phi_15157_;
                                                                                    if (_e5516 > _e5540) {
                                                                                        phi_15162_ = _e5516;
                                                                                    } else {
                                                                                        phi_15162_ = _e5540;
                                                                                    }
                                                                                    let _e5543 = phi_15162_;
                                                                                    let _e5545 = local_18.member_3;
                                                                                    let _e5553 = local_18.member_3;
                                                                                    if (((_e5379 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5435 + _e5437) + (_e5489 + _e5491)) + (_e5543 + _e5545)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5553 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e884) {
                                                                                        phi_15186_ = false;
                                                                                    } else {
                                                                                        phi_15186_ = true;
                                                                                    }
                                                                                    let _e5565 = phi_15186_;
                                                                                    phi_15187_ = _e5565;
                                                                                } else {
                                                                                    phi_15187_ = true;
                                                                                }
                                                                                let _e5567 = phi_15187_;
                                                                                phi_15188_ = _e5567;
                                                                            } else {
                                                                                phi_15188_ = true;
                                                                            }
                                                                            let _e5569 = phi_15188_;
                                                                            if _e5569 {
                                                                                if _e4435 {
                                                                                    if _e5239 {
                                                                                        phi_15207_ = f64();
                                                                                        phi_15208_ = true;
                                                                                    } else {
                                                                                        if (_e5238 <= (_e4431 * f64(0.25f))) {
                                                                                            phi_15205_ = f64(0f);
                                                                                            phi_15206_ = false;
                                                                                        } else {
                                                                                            phi_15205_ = f64();
                                                                                            phi_15206_ = true;
                                                                                        }
                                                                                        let _e5576 = phi_15205_;
                                                                                        let _e5578 = phi_15206_;
                                                                                        phi_15207_ = _e5576;
                                                                                        phi_15208_ = _e5578;
                                                                                    }
                                                                                    let _e5580 = phi_15207_;
                                                                                    let _e5582 = phi_15208_;
                                                                                    if _e5582 {
                                                                                        phi_15213_ = (_e4766 + _e4766);
                                                                                    } else {
                                                                                        phi_15213_ = _e5580;
                                                                                    }
                                                                                    let _e5585 = phi_15213_;
                                                                                    phi_15215_ = _e5585;
                                                                                } else {
                                                                                    phi_15215_ = (_e3404.member_1 - _e4427);
                                                                                }
                                                                                let _e5587 = phi_15215_;
                                                                                phi_15216_ = _e5587;
                                                                                phi_15217_ = false;
                                                                            } else {
                                                                                phi_15216_ = f64();
                                                                                phi_15217_ = true;
                                                                            }
                                                                            let _e5589 = phi_15216_;
                                                                            let _e5591 = phi_15217_;
                                                                            phi_15218_ = _e5589;
                                                                            phi_15219_ = _e5238;
                                                                            phi_15220_ = _e5569;
                                                                            phi_15221_ = _e5591;
                                                                        }
                                                                        let _e5593 = phi_15218_;
                                                                        let _e5595 = phi_15219_;
                                                                        let _e5597 = phi_15220_;
                                                                        let _e5599 = phi_15221_;
                                                                        phi_15222_ = _e5236;
                                                                        phi_15223_ = _e5593;
                                                                        phi_15224_ = _e5595;
                                                                        phi_15225_ = _e5236;
                                                                        phi_15226_ = _e5597;
                                                                        phi_15227_ = _e5237;
                                                                        phi_15228_ = _e5599;
                                                                        phi_15229_ = false;
                                                                    } else {
                                                                        phi_15222_ = f64();
                                                                        phi_15223_ = f64();
                                                                        phi_15224_ = f64();
                                                                        phi_15225_ = f64();
                                                                        phi_15226_ = false;
                                                                        phi_15227_ = false;
                                                                        phi_15228_ = false;
                                                                        phi_15229_ = true;
                                                                    }
                                                                    let _e5601 = phi_15222_;
                                                                    let _e5603 = phi_15223_;
                                                                    let _e5605 = phi_15224_;
                                                                    let _e5607 = phi_15225_;
                                                                    let _e5609 = phi_15226_;
                                                                    let _e5611 = phi_15227_;
                                                                    let _e5613 = phi_15228_;
                                                                    let _e5615 = phi_15229_;
                                                                    phi_15230_ = _e5601;
                                                                    phi_15231_ = _e5603;
                                                                    phi_15232_ = _e5605;
                                                                    phi_15233_ = _e5607;
                                                                    phi_15234_ = false;
                                                                    phi_15235_ = _e5609;
                                                                    phi_15236_ = _e5611;
                                                                    phi_15237_ = _e5613;
                                                                    phi_15238_ = _e5615;
                                                                } else {
                                                                    phi_15230_ = f64();
                                                                    phi_15231_ = f64();
                                                                    phi_15232_ = f64();
                                                                    phi_15233_ = f64();
                                                                    phi_15234_ = true;
                                                                    phi_15235_ = false;
                                                                    phi_15236_ = false;
                                                                    phi_15237_ = false;
                                                                    phi_15238_ = false;
                                                                }
                                                                let _e5617 = phi_15230_;
                                                                let _e5619 = phi_15231_;
                                                                let _e5621 = phi_15232_;
                                                                let _e5623 = phi_15233_;
                                                                let _e5625 = phi_15234_;
                                                                let _e5627 = phi_15235_;
                                                                let _e5629 = phi_15236_;
                                                                let _e5631 = phi_15237_;
                                                                let _e5633 = phi_15238_;
                                                                phi_15239_ = _e5617;
                                                                phi_15240_ = _e5619;
                                                                phi_15241_ = _e5621;
                                                                phi_15242_ = _e5623;
                                                                phi_15243_ = _e5625;
                                                                phi_15244_ = _e5627;
                                                                phi_15245_ = _e5629;
                                                                phi_15246_ = _e5631;
                                                                phi_15247_ = _e5633;
                                                            } else {
                                                                phi_15239_ = f64();
                                                                phi_15240_ = f64();
                                                                phi_15241_ = f64();
                                                                phi_15242_ = f64();
                                                                phi_15243_ = true;
                                                                phi_15244_ = false;
                                                                phi_15245_ = false;
                                                                phi_15246_ = false;
                                                                phi_15247_ = false;
                                                            }
                                                            let _e5635 = phi_15239_;
                                                            let _e5637 = phi_15240_;
                                                            let _e5639 = phi_15241_;
                                                            let _e5641 = phi_15242_;
                                                            let _e5643 = phi_15243_;
                                                            let _e5645 = phi_15244_;
                                                            let _e5647 = phi_15245_;
                                                            let _e5649 = phi_15246_;
                                                            let _e5651 = phi_15247_;
                                                            if _e5643 {
                                                                if (_e4427 <= _e4429) {
                                                                    let _e5817 = (_e4437 + 1u);
                                                                    let _e5818 = (_e5817 > 3u);
                                                                    if _e5818 {
                                                                        phi_15260_ = false;
                                                                    } else {
                                                                        phi_15260_ = true;
                                                                    }
                                                                    let _e5820 = phi_15260_;
                                                                    phi_15587_ = _e5817;
                                                                    phi_15588_ = f64();
                                                                    phi_15589_ = false;
                                                                    phi_15590_ = _e5820;
                                                                    phi_15591_ = _e5818;
                                                                } else {
                                                                    let _e5655 = local.member[0u];
                                                                    let _e5658 = local.member_1[0u];
                                                                    let _e5661 = local.member[0u];
                                                                    let _e5667 = local.member_2[0u];
                                                                    let _e5668 = ((_e5655 + ((_e5658 - _e5661) * _e4433)) - _e5667);
                                                                    let _e5671 = local.member[1u];
                                                                    let _e5674 = local.member_1[1u];
                                                                    let _e5677 = local.member[1u];
                                                                    let _e5683 = local.member_2[1u];
                                                                    let _e5684 = ((_e5671 + ((_e5674 - _e5677) * _e4433)) - _e5683);
                                                                    if (_e5668 < _e5684) {
                                                                        phi_15333_ = _e5668;
                                                                    } else {
                                                                        phi_15333_ = _e5684;
                                                                    }
                                                                    let _e5687 = phi_15333_;
                                                                    let _e5690 = local.member[2u];
                                                                    let _e5693 = local.member_1[2u];
                                                                    let _e5696 = local.member[2u];
                                                                    let _e5702 = local.member_2[2u];
                                                                    let _e5703 = ((_e5690 + ((_e5693 - _e5696) * _e4433)) - _e5702);
                                                                    let _e5706 = local.member[3u];
                                                                    let _e5709 = local.member_1[3u];
                                                                    let _e5712 = local.member[3u];
                                                                    let _e5718 = local.member_2[3u];
                                                                    let _e5719 = ((_e5706 + ((_e5709 - _e5712) * _e4433)) - _e5718);
                                                                    if (_e5703 < _e5719) {
                                                                        phi_15406_ = _e5703;
                                                                    } else {
                                                                        phi_15406_ = _e5719;
                                                                    }
                                                                    let _e5722 = phi_15406_;
                                                                    if (_e5687 < _e5722) {
                                                                        phi_15411_ = _e5687;
                                                                    } else {
                                                                        phi_15411_ = _e5722;
                                                                    }
                                                                    let _e5725 = phi_15411_;
                                                                    let _e5728 = local_1.member[0u];
                                                                    let _e5731 = local_1.member_1[0u];
                                                                    let _e5734 = local_1.member[0u];
                                                                    let _e5740 = local_1.member_2[0u];
                                                                    let _e5741 = ((_e5728 + ((_e5731 - _e5734) * _e4427)) - _e5740);
                                                                    let _e5744 = local_1.member[1u];
                                                                    let _e5747 = local_1.member_1[1u];
                                                                    let _e5750 = local_1.member[1u];
                                                                    let _e5756 = local_1.member_2[1u];
                                                                    let _e5757 = ((_e5744 + ((_e5747 - _e5750) * _e4427)) - _e5756);
                                                                    if (_e5741 < _e5757) {
                                                                        phi_15484_ = _e5741;
                                                                    } else {
                                                                        phi_15484_ = _e5757;
                                                                    }
                                                                    let _e5760 = phi_15484_;
                                                                    let _e5763 = local_1.member[2u];
                                                                    let _e5766 = local_1.member_1[2u];
                                                                    let _e5769 = local_1.member[2u];
                                                                    let _e5775 = local_1.member_2[2u];
                                                                    let _e5776 = ((_e5763 + ((_e5766 - _e5769) * _e4427)) - _e5775);
                                                                    let _e5779 = local_1.member[3u];
                                                                    let _e5782 = local_1.member_1[3u];
                                                                    let _e5785 = local_1.member[3u];
                                                                    let _e5791 = local_1.member_2[3u];
                                                                    let _e5792 = ((_e5779 + ((_e5782 - _e5785) * _e4427)) - _e5791);
                                                                    if (_e5776 < _e5792) {
                                                                        phi_15557_ = _e5776;
                                                                    } else {
                                                                        phi_15557_ = _e5792;
                                                                    }
                                                                    let _e5795 = phi_15557_;
                                                                    if (_e5760 < _e5795) {
                                                                        phi_15562_ = _e5760;
                                                                    } else {
                                                                        phi_15562_ = _e5795;
                                                                    }
                                                                    let _e5798 = phi_15562_;
                                                                    let _e5799 = f64(0.0625f);
                                                                    let _e5801 = f64(0.9f);
                                                                    if (_e5798 > f64(0f)) {
                                                                        phi_15585_ = f64(0.5f);
                                                                    } else {
                                                                        let _e5807 = (f64(0.95f) * (_e5725 / (_e5725 - _e5798)));
                                                                        if (_e5807 > _e5799) {
                                                                            if (_e5807 < _e5801) {
                                                                                phi_15583_ = _e5807;
                                                                            } else {
                                                                                phi_15583_ = _e5801;
                                                                            }
                                                                            let _e5811 = phi_15583_;
                                                                            phi_15584_ = _e5811;
                                                                        } else {
                                                                            phi_15584_ = _e5799;
                                                                        }
                                                                        let _e5813 = phi_15584_;
                                                                        phi_15585_ = _e5813;
                                                                    }
                                                                    let _e5815 = phi_15585_;
                                                                    phi_15587_ = u32();
                                                                    phi_15588_ = (_e4766 * _e5815);
                                                                    phi_15589_ = true;
                                                                    phi_15590_ = false;
                                                                    phi_15591_ = false;
                                                                }
                                                                let _e5822 = phi_15587_;
                                                                let _e5824 = phi_15588_;
                                                                let _e5826 = phi_15589_;
                                                                let _e5828 = phi_15590_;
                                                                let _e5830 = phi_15591_;
                                                                phi_15592_ = _e5822;
                                                                phi_15593_ = _e4429;
                                                                phi_15594_ = _e5824;
                                                                phi_15595_ = _e4431;
                                                                phi_15596_ = _e4433;
                                                                phi_15597_ = _e4435;
                                                                phi_15598_ = _e4437;
                                                                phi_15599_ = _e5826;
                                                                phi_15600_ = _e5828;
                                                                phi_15601_ = _e5830;
                                                                phi_15602_ = false;
                                                                phi_15603_ = false;
                                                                phi_15604_ = false;
                                                            } else {
                                                                phi_15592_ = u32();
                                                                phi_15593_ = _e5635;
                                                                phi_15594_ = _e5637;
                                                                phi_15595_ = _e5639;
                                                                phi_15596_ = _e4427;
                                                                phi_15597_ = true;
                                                                phi_15598_ = 0u;
                                                                phi_15599_ = _e5645;
                                                                phi_15600_ = false;
                                                                phi_15601_ = false;
                                                                phi_15602_ = _e5647;
                                                                phi_15603_ = _e5649;
                                                                phi_15604_ = _e5651;
                                                            }
                                                            let _e5832 = phi_15592_;
                                                            let _e5834 = phi_15593_;
                                                            let _e5836 = phi_15594_;
                                                            let _e5838 = phi_15595_;
                                                            let _e5840 = phi_15596_;
                                                            let _e5842 = phi_15597_;
                                                            let _e5844 = phi_15598_;
                                                            let _e5846 = phi_15599_;
                                                            let _e5848 = phi_15600_;
                                                            let _e5850 = phi_15601_;
                                                            let _e5852 = phi_15602_;
                                                            let _e5854 = phi_15603_;
                                                            let _e5856 = phi_15604_;
                                                            if _e5846 {
                                                                let _e5857 = (_e5840 + _e5836);
                                                                if (_e5857 > _e5834) {
                                                                    phi_15613_ = _e5857;
                                                                } else {
                                                                    phi_15613_ = _e5834;
                                                                }
                                                                let _e5860 = phi_15613_;
                                                                if (_e5860 < _e3404.member_1) {
                                                                    phi_15618_ = _e5860;
                                                                } else {
                                                                    phi_15618_ = _e3404.member_1;
                                                                }
                                                                let _e5863 = phi_15618_;
                                                                if !(_e4435) {
                                                                    phi_15627_ = true;
                                                                } else {
                                                                    phi_15627_ = ((_e5863 - _e5840) > _e4416);
                                                                }
                                                                let _e5867 = phi_15627_;
                                                                if _e5867 {
                                                                    phi_15631_ = false;
                                                                } else {
                                                                    phi_15631_ = true;
                                                                }
                                                                let _e5869 = phi_15631_;
                                                                phi_15632_ = _e5863;
                                                                phi_15633_ = _e5834;
                                                                phi_15634_ = _e5838;
                                                                phi_15635_ = _e5840;
                                                                phi_15636_ = _e5842;
                                                                phi_15637_ = _e5844;
                                                                phi_15638_ = _e5867;
                                                                phi_15639_ = _e5869;
                                                                phi_15640_ = false;
                                                                phi_15641_ = false;
                                                                phi_15642_ = false;
                                                                phi_15643_ = false;
                                                            } else {
                                                                phi_15632_ = _e4427;
                                                                phi_15633_ = _e4429;
                                                                phi_15634_ = _e4431;
                                                                phi_15635_ = _e4433;
                                                                phi_15636_ = _e4435;
                                                                phi_15637_ = _e5832;
                                                                phi_15638_ = _e5848;
                                                                phi_15639_ = false;
                                                                phi_15640_ = _e5850;
                                                                phi_15641_ = _e5852;
                                                                phi_15642_ = _e5854;
                                                                phi_15643_ = _e5856;
                                                            }
                                                            let _e5871 = phi_15632_;
                                                            let _e5873 = phi_15633_;
                                                            let _e5875 = phi_15634_;
                                                            let _e5877 = phi_15635_;
                                                            let _e5879 = phi_15636_;
                                                            let _e5881 = phi_15637_;
                                                            let _e5883 = phi_15638_;
                                                            let _e5885 = phi_15639_;
                                                            let _e5887 = phi_15640_;
                                                            let _e5889 = phi_15641_;
                                                            let _e5891 = phi_15642_;
                                                            let _e5893 = phi_15643_;
                                                            phi_13422_ = _e5871;
                                                            phi_13424_ = _e5873;
                                                            phi_13426_ = _e5875;
                                                            phi_13428_ = _e5877;
                                                            phi_13430_ = _e5879;
                                                            phi_13432_ = _e5881;
                                                            phi_15644_ = _e5834;
                                                            phi_15645_ = _e5641;
                                                            phi_15646_ = _e5883;
                                                            phi_15647_ = _e5885;
                                                            phi_15648_ = _e5887;
                                                            phi_15649_ = _e5889;
                                                            phi_15650_ = _e5891;
                                                            phi_15651_ = false;
                                                            phi_15652_ = _e5893;
                                                        } else {
                                                            phi_13422_ = f64();
                                                            phi_13424_ = f64();
                                                            phi_13426_ = f64();
                                                            phi_13428_ = f64();
                                                            phi_13430_ = bool();
                                                            phi_13432_ = u32();
                                                            phi_15644_ = f64();
                                                            phi_15645_ = f64();
                                                            phi_15646_ = false;
                                                            phi_15647_ = false;
                                                            phi_15648_ = false;
                                                            phi_15649_ = false;
                                                            phi_15650_ = false;
                                                            phi_15651_ = true;
                                                            phi_15652_ = false;
                                                        }
                                                        let _e5895 = phi_13422_;
                                                        let _e5897 = phi_13424_;
                                                        let _e5899 = phi_13426_;
                                                        let _e5901 = phi_13428_;
                                                        let _e5903 = phi_13430_;
                                                        let _e5905 = phi_13432_;
                                                        let _e5907 = phi_15644_;
                                                        let _e5909 = phi_15645_;
                                                        let _e5911 = phi_15646_;
                                                        let _e5913 = phi_15647_;
                                                        let _e5915 = phi_15648_;
                                                        let _e5917 = phi_15649_;
                                                        let _e5919 = phi_15650_;
                                                        let _e5921 = phi_15651_;
                                                        let _e5923 = phi_15652_;
                                                        local_30 = _e5913;
                                                        local_70 = _e5915;
                                                        local_71 = _e5917;
                                                        local_72 = _e5919;
                                                        local_73 = _e5921;
                                                        local_74 = _e5923;
                                                        local_75 = _e5913;
                                                        local_76 = _e5909;
                                                        local_77 = _e5907;
                                                        continue;
                                                        continuing {
                                                            phi_13418_ = _e4449;
                                                            phi_13421_ = _e5895;
                                                            phi_13423_ = _e5897;
                                                            phi_13425_ = _e5899;
                                                            phi_13427_ = _e5901;
                                                            phi_13429_ = _e5903;
                                                            phi_13431_ = _e5905;
                                                            break if !(_e5911);
                                                        }
                                                    }
                                                    let _e5926 = local_30;
                                                    if _e5926 {
                                                        phi_15656_ = false;
                                                        phi_15657_ = false;
                                                        phi_15658_ = false;
                                                        phi_15659_ = false;
                                                        phi_15660_ = false;
                                                    } else {
                                                        let _e11733 = local_70;
                                                        phi_15656_ = _e11733;
                                                        let _e11736 = local_71;
                                                        phi_15657_ = _e11736;
                                                        let _e11739 = local_72;
                                                        phi_15658_ = _e11739;
                                                        let _e11742 = local_73;
                                                        phi_15659_ = _e11742;
                                                        let _e11745 = local_74;
                                                        phi_15660_ = _e11745;
                                                    }
                                                    let _e5928 = phi_15656_;
                                                    let _e5930 = phi_15657_;
                                                    let _e5932 = phi_15658_;
                                                    let _e5934 = phi_15659_;
                                                    let _e5936 = phi_15660_;
                                                    if _e5928 {
                                                        let _e5938 = local_31;
                                                        phi_15665_ = type_43(1u, _e5938);
                                                        phi_15666_ = false;
                                                        phi_15667_ = false;
                                                        phi_15668_ = false;
                                                        phi_15669_ = false;
                                                        phi_15670_ = false;
                                                    } else {
                                                        phi_15665_ = type_43();
                                                        phi_15666_ = _e5930;
                                                        phi_15667_ = _e5932;
                                                        let _e11752 = local_75;
                                                        phi_15668_ = _e11752;
                                                        phi_15669_ = _e5934;
                                                        phi_15670_ = _e5936;
                                                    }
                                                    let _e5941 = phi_15665_;
                                                    let _e5943 = phi_15666_;
                                                    let _e5945 = phi_15667_;
                                                    let _e5947 = phi_15668_;
                                                    let _e5949 = phi_15669_;
                                                    let _e5951 = phi_15670_;
                                                    if _e5943 {
                                                        phi_15675_ = type_43(0u, type_43().member_1);
                                                        phi_15676_ = false;
                                                        phi_15677_ = false;
                                                        phi_15678_ = false;
                                                        phi_15679_ = false;
                                                        phi_15680_ = true;
                                                    } else {
                                                        phi_15675_ = _e5941;
                                                        phi_15676_ = _e5945;
                                                        phi_15677_ = _e5947;
                                                        phi_15678_ = _e5949;
                                                        phi_15679_ = _e5951;
                                                        phi_15680_ = _e5928;
                                                    }
                                                    let _e5955 = phi_15675_;
                                                    let _e5957 = phi_15676_;
                                                    let _e5959 = phi_15677_;
                                                    let _e5961 = phi_15678_;
                                                    let _e5963 = phi_15679_;
                                                    let _e5965 = phi_15680_;
                                                    if _e5957 {
                                                        let _e11763 = local_76;
                                                        phi_15684_ = _e11763;
                                                        phi_15685_ = true;
                                                        phi_15686_ = false;
                                                        phi_15687_ = false;
                                                        phi_15688_ = false;
                                                    } else {
                                                        let _e11765 = local_77;
                                                        phi_15684_ = _e11765;
                                                        phi_15685_ = _e5959;
                                                        phi_15686_ = _e5961;
                                                        phi_15687_ = _e5963;
                                                        phi_15688_ = _e5965;
                                                    }
                                                    let _e5967 = phi_15684_;
                                                    let _e5969 = phi_15685_;
                                                    let _e5971 = phi_15686_;
                                                    let _e5973 = phi_15687_;
                                                    let _e5975 = phi_15688_;
                                                    if _e5969 {
                                                        phi_15692_ = _e5967;
                                                        phi_15693_ = true;
                                                        phi_15694_ = false;
                                                        phi_15695_ = false;
                                                    } else {
                                                        let _e11772 = local_78;
                                                        phi_15692_ = _e11772;
                                                        phi_15693_ = _e5971;
                                                        phi_15694_ = _e5973;
                                                        phi_15695_ = _e5975;
                                                    }
                                                    let _e5977 = phi_15692_;
                                                    let _e5979 = phi_15693_;
                                                    let _e5981 = phi_15694_;
                                                    let _e5983 = phi_15695_;
                                                    if _e5979 {
                                                        phi_15700_ = type_43(1u, _e5977);
                                                        phi_15701_ = false;
                                                        phi_15702_ = false;
                                                    } else {
                                                        phi_15700_ = type_43();
                                                        phi_15701_ = _e5981;
                                                        phi_15702_ = _e5983;
                                                    }
                                                    let _e5986 = phi_15700_;
                                                    let _e5988 = phi_15701_;
                                                    let _e5990 = phi_15702_;
                                                    if _e5988 {
                                                        phi_15707_ = type_43(0u, type_43().member_1);
                                                        phi_15708_ = true;
                                                    } else {
                                                        phi_15707_ = _e5955;
                                                        phi_15708_ = _e5990;
                                                    }
                                                    let _e5994 = phi_15707_;
                                                    let _e5996 = phi_15708_;
                                                    if _e5996 {
                                                        phi_15712_ = _e5994;
                                                    } else {
                                                        phi_15712_ = _e5986;
                                                    }
                                                    let _e5998 = phi_15712_;
                                                    let _e6001 = (_e5998.member != 0u);
                                                    if _e6001 {
                                                        phi_15719_ = false;
                                                    } else {
                                                        phi_15719_ = true;
                                                    }
                                                    let _e6003 = phi_15719_;
                                                    phi_15720_ = _e5998.member_1;
                                                    phi_15721_ = _e6003;
                                                    phi_15722_ = _e6001;
                                                    phi_15723_ = false;
                                                } else {
                                                    phi_15720_ = f64();
                                                    phi_15721_ = false;
                                                    phi_15722_ = false;
                                                    phi_15723_ = true;
                                                }
                                                let _e6005 = phi_15720_;
                                                let _e6007 = phi_15721_;
                                                let _e6009 = phi_15722_;
                                                let _e6011 = phi_15723_;
                                                phi_15724_ = _e4163;
                                                phi_15725_ = _e4165;
                                                phi_15726_ = _e6005;
                                                phi_15727_ = _e6007;
                                                phi_15728_ = _e6009;
                                                phi_15729_ = _e6011;
                                            }
                                            let _e6013 = phi_15724_;
                                            let _e6015 = phi_15725_;
                                            let _e6017 = phi_15726_;
                                            let _e6019 = phi_15727_;
                                            let _e6021 = phi_15728_;
                                            let _e6023 = phi_15729_;
                                            phi_15730_ = _e6013;
                                            phi_15731_ = _e6015;
                                            phi_15732_ = _e6017;
                                            phi_15733_ = _e4159;
                                            phi_15734_ = _e6019;
                                            phi_15735_ = _e6021;
                                            phi_15736_ = _e6023;
                                        }
                                        let _e6025 = phi_15730_;
                                        let _e6027 = phi_15731_;
                                        let _e6029 = phi_15732_;
                                        let _e6031 = phi_15733_;
                                        let _e6033 = phi_15734_;
                                        let _e6035 = phi_15735_;
                                        let _e6037 = phi_15736_;
                                        if _e6031 {
                                            phi_15740_ = false;
                                            phi_15741_ = false;
                                            phi_15742_ = false;
                                        } else {
                                            phi_15740_ = _e6033;
                                            phi_15741_ = _e6035;
                                            phi_15742_ = _e6037;
                                        }
                                        let _e6039 = phi_15740_;
                                        let _e6041 = phi_15741_;
                                        let _e6043 = phi_15742_;
                                        phi_15743_ = _e3404;
                                        phi_15744_ = _e6025;
                                        phi_15745_ = _e6027;
                                        phi_15746_ = _e6029;
                                        phi_15747_ = _e3404;
                                        phi_15748_ = _e6031;
                                        phi_15749_ = _e6039;
                                        phi_15750_ = _e6041;
                                        phi_15751_ = _e6043;
                                    } else {
                                        phi_15743_ = type_46();
                                        phi_15744_ = bool();
                                        phi_15745_ = f64();
                                        phi_15746_ = f64();
                                        phi_15747_ = type_46();
                                        phi_15748_ = true;
                                        phi_15749_ = false;
                                        phi_15750_ = false;
                                        phi_15751_ = false;
                                    }
                                    let _e6045 = phi_15743_;
                                    let _e6047 = phi_15744_;
                                    let _e6049 = phi_15745_;
                                    let _e6051 = phi_15746_;
                                    let _e6053 = phi_15747_;
                                    let _e6055 = phi_15748_;
                                    let _e6057 = phi_15749_;
                                    let _e6059 = phi_15750_;
                                    let _e6061 = phi_15751_;
                                    if _e6055 {
                                        phi_15755_ = true;
                                        phi_15756_ = false;
                                        phi_15757_ = false;
                                    } else {
                                        phi_15755_ = _e6057;
                                        phi_15756_ = _e6059;
                                        phi_15757_ = _e6061;
                                    }
                                    let _e6063 = phi_15755_;
                                    let _e6065 = phi_15756_;
                                    let _e6067 = phi_15757_;
                                    phi_15758_ = _e6045;
                                    phi_15759_ = _e6047;
                                    phi_15760_ = _e6049;
                                    phi_15761_ = _e6051;
                                    phi_15762_ = _e6053;
                                    phi_15763_ = _e6063;
                                    phi_15764_ = false;
                                    phi_15765_ = _e6065;
                                    phi_15766_ = _e6067;
                                } else {
                                    phi_15758_ = type_46();
                                    phi_15759_ = bool();
                                    phi_15760_ = f64();
                                    phi_15761_ = f64();
                                    phi_15762_ = type_46();
                                    phi_15763_ = false;
                                    phi_15764_ = true;
                                    phi_15765_ = false;
                                    phi_15766_ = false;
                                }
                                let _e6069 = phi_15758_;
                                let _e6071 = phi_15759_;
                                let _e6073 = phi_15760_;
                                let _e6075 = phi_15761_;
                                let _e6077 = phi_15762_;
                                let _e6079 = phi_15763_;
                                let _e6081 = phi_15764_;
                                let _e6083 = phi_15765_;
                                let _e6085 = phi_15766_;
                                local_32 = _e6081;
                                local_79 = _e6083;
                                local_80 = _e6085;
                                local_33 = _e6071;
                                local_34 = _e6069;
                                local_35 = _e6075;
                                local_36 = _e6073;
                                local_37 = _e6075;
                                local_38 = _e6075;
                                local_39 = _e6077;
                                continue;
                                continuing {
                                    phi_11480_ = _e3112;
                                    break if !(_e6079);
                                }
                            }
                            let _e6088 = local_32;
                            if _e6088 {
                                phi_15771_ = type_43(0u, type_43().member_1);
                                phi_15772_ = false;
                                phi_15773_ = false;
                            } else {
                                phi_15771_ = type_43();
                                let _e11828 = local_79;
                                phi_15772_ = _e11828;
                                let _e11831 = local_80;
                                phi_15773_ = _e11831;
                            }
                            let _e6092 = phi_15771_;
                            let _e6094 = phi_15772_;
                            let _e6096 = phi_15773_;
                            if _e6094 {
                                let _e6098 = local_33;
                                if _e6098 {
                                    let _e6100 = local_34;
                                    let _e6103 = local_35;
                                    let _e6106 = local_36;
                                    if ((_e6100.member_1 - _e6103) <= _e6106) {
                                        let _e6109 = local_37;
                                        phi_15787_ = type_43(1u, _e6109);
                                        phi_15788_ = false;
                                    } else {
                                        phi_15787_ = type_43();
                                        phi_15788_ = true;
                                    }
                                    let _e6112 = phi_15787_;
                                    let _e6114 = phi_15788_;
                                    phi_15789_ = _e6112;
                                    phi_15790_ = _e6114;
                                } else {
                                    phi_15789_ = type_43();
                                    phi_15790_ = true;
                                }
                                let _e6116 = phi_15789_;
                                let _e6118 = phi_15790_;
                                if _e6118 {
                                    let _e6120 = local_38;
                                    phi_15795_ = type_43(2u, _e6120);
                                } else {
                                    phi_15795_ = _e6116;
                                }
                                let _e6123 = phi_15795_;
                                phi_15796_ = _e6123;
                                phi_15797_ = false;
                            } else {
                                phi_15796_ = type_43();
                                phi_15797_ = _e6096;
                            }
                            let _e6125 = phi_15796_;
                            let _e6127 = phi_15797_;
                            if _e6127 {
                                let _e6129 = local_39;
                                phi_15803_ = type_43(1u, _e6129.member);
                                phi_15804_ = true;
                            } else {
                                phi_15803_ = _e6125;
                                phi_15804_ = _e6094;
                            }
                            let _e6133 = phi_15803_;
                            let _e6135 = phi_15804_;
                            phi_15808_ = _e6133;
                            phi_15809_ = _e6092;
                            phi_15810_ = _e6135;
                        } else {
                            phi_15808_ = _e2956;
                            phi_15809_ = type_43();
                            phi_15810_ = true;
                        }
                        let _e6137 = phi_15808_;
                        let _e6139 = phi_15809_;
                        let _e6141 = phi_15810_;
                        phi_15814_ = _e6137;
                        phi_15815_ = _e6139;
                        phi_15816_ = _e6141;
                    }
                    let _e6145 = phi_15814_;
                    let _e6147 = phi_15815_;
                    let _e6149 = phi_15816_;
                    if _e6149 {
                        phi_15820_ = _e6145;
                    } else {
                        phi_15820_ = _e6147;
                    }
                    let _e6151 = phi_15820_;
                    if (_e6151.member == 1u) {
                        if (_e6151.member_1 > _e564) {
                            phi_15831_ = false;
                        } else {
                            phi_15831_ = true;
                        }
                        let _e6157 = phi_15831_;
                        phi_15832_ = _e6157;
                    } else {
                        phi_15832_ = true;
                    }
                    let _e6159 = phi_15832_;
                    if _e6159 {
                        phi_15836_ = false;
                    } else {
                        phi_15836_ = true;
                    }
                    let _e6161 = phi_15836_;
                    if _e6161 {
                        phi_15840_ = 1u;
                    } else {
                        phi_15840_ = 0u;
                    }
                    let _e6163 = phi_15840_;
                    phi_15844_ = type_44(_e6151, _e6163);
                }
                let _e10823 = phi_15844_;
                switch bitcast<i32>(_e10823.member.member) {
                    case 0: {
                        phi_15862_ = type_47(0u, _e10823.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e10834 = function_1(_e10823.member.member_1);
                        phi_15862_ = type_47(0u, _e10823.member_1, _e10834, true);
                        break;
                    }
                    case 2: {
                        let _e10830 = function_1(_e10823.member.member_1);
                        phi_15862_ = type_47(1u, _e10823.member_1, _e10830, true);
                        break;
                    }
                    default: {
                        phi_15862_ = type_47();
                        break;
                    }
                }
                let _e10838 = phi_15862_;
                if (_e10838.member == 0u) {
                    phi_15880_ = false;
                } else {
                    let _e10847 = params.member.member.member_7[0u];
                    let _e10850 = params.member.member.member_7[1u];
                    phi_15880_ = ((_e10847 | _e10850) == 0u);
                }
                let _e10854 = phi_15880_;
                if _e10838.member_3 {
                    if _e210 {
                        phi_15887_ = true;
                    } else {
                        phi_15887_ = _e10854;
                    }
                    let _e10856 = phi_15887_;
                    phi_15888_ = _e10856;
                } else {
                    phi_15888_ = false;
                }
                let _e10858 = phi_15888_;
                if _e10838.member_3 {
                    if _e10854 {
                    } else {
                        let _e10862 = (_e10838.member_2[1] >> bitcast<u32>(20i));
                        if (_e10862 <= 896u) {
                            phi_15911_ = 0u;
                        } else {
                            phi_15911_ = ((((_e10862 - 896u) << bitcast<u32>(23i)) | ((_e10838.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e10838.member_2[0] >> bitcast<u32>(29i)));
                        }
                        let _e10877 = phi_15911_;
                        let _e10879 = atomicMin((&earliest.member[0u]), _e10877);
                    }
                }
                phi_15915_ = type_20(_e205, _e10838.member, _e220, _e223, _e10838.member_2, _e10838.member_1);
                phi_15916_ = _e10858;
            } else {
                phi_15915_ = type_20(_e205, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_15916_ = false;
            }
            let _e10881 = phi_15915_;
            let _e10883 = phi_15916_;
            if (_e123 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e10883 {
                let _e10887 = atomicAdd((&counters[0u]), 1u);
                phi_15927_ = _e10887;
            } else {
                phi_15927_ = 0u;
            }
            let _e10889 = phi_15927_;
            workgroupBarrier();
            if (_e123 == 0u) {
                let _e10892 = atomicLoad((&counters[0u]));
                if (_e10892 > 0u) {
                    let _e10895 = atomicAdd((&contacts.member[0u]), _e10892);
                    atomicStore((&counters[1u]), _e10895);
                }
            }
            workgroupBarrier();
            let _e10898 = atomicLoad((&counters[1u]));
            let _e10899 = (_e10898 + _e10889);
            if _e10883 {
                if _e210 {
                    let _e10902 = params.member.member_1.member_3;
                    if (_e10899 < _e10902) {
                        let _e10904 = (7u * _e10899);
                        atomicStore((&contacts.member[(4u + _e10904)]), _e10881.member);
                        atomicStore((&contacts.member[(_e10904 + 5u)]), _e10881.member_1);
                        atomicStore((&contacts.member[(_e10904 + 6u)]), _e10881.member_2);
                        atomicStore((&contacts.member[(_e10904 + 7u)]), _e10881.member_3);
                        atomicStore((&contacts.member[(_e10904 + 8u)]), _e10881.member_4[0]);
                        atomicStore((&contacts.member[(_e10904 + 9u)]), _e10881.member_4[1]);
                        atomicStore((&contacts.member[(_e10904 + 10u)]), _e10881.member_5);
                    }
                    phi_15987_ = false;
                } else {
                    phi_15987_ = true;
                }
                let _e10929 = phi_15987_;
                phi_15988_ = _e10929;
            } else {
                phi_15988_ = true;
            }
            let _e10931 = phi_15988_;
            if _e10931 {
                if _e10883 {
                    let _e10936 = params.member.member_2.member_1;
                    if (_e10899 < _e10936) {
                        let _e10938 = (2u * _e10899);
                        atomicStore((&contacts.member[(4u + _e10938)]), _e10881.member_2);
                        atomicStore((&contacts.member[(_e10938 + 5u)]), _e10881.member_3);
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
