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

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
    member_5: u32,
}

struct type_23 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
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
    member_1: f32,
}

struct type_30 {
    member: array<array<u32, 3>>,
}

struct type_32 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_33 {
    member: f32,
    member_1: f32,
}

struct type_37 {
    member: array<array<array<f32, 3>, 4>, 2>,
    member_1: f32,
    member_2: f32,
}

struct type_38 {
    member: type_23,
    member_1: f32,
}

struct type_39 {
    member: type_28,
    member_1: u32,
}

struct type_40 {
    member: u32,
    member_1: f32,
    member_2: f32,
}

struct type_41 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_42 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_46 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_19;
@group(0) @binding(3) 
var<storage> input: type_10;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_27;
@group(0) @binding(2) 
var<storage> elements: type_30;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_46;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_46;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_46;

fn function_(param: array<f32, 3>, param_1: array<f32, 3>) -> array<f32, 3> {
    var phi_719_: array<f32, 3>;

    if ((((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])) < (((param[0] * param[0]) + (param[1] * param[1])) + (param[2] * param[2]))) {
        phi_719_ = param_1;
    } else {
        phi_719_ = param;
    }
    let _e26 = phi_719_;
    return _e26;
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: u32) -> array<f32, 3> {
    var phi_580_: f32;
    var phi_581_: f32;
    var phi_620_: f32;
    var phi_621_: f32;
    var phi_666_: f32;
    var phi_667_: f32;
    var phi_401_: f32;
    var phi_402_: f32;
    var phi_447_: f32;
    var phi_448_: f32;
    var phi_490_: f32;
    var phi_491_: f32;
    var phi_539_: f32;
    var phi_540_: f32;
    var phi_682_: array<array<f32, 3>, 4>;

    let _e9 = (param_2[0] - param_3[0]);
    let _e12 = (param_2[1] - param_3[1]);
    let _e15 = (param_2[2] - param_3[2]);
    if (param_5 != 0u) {
        let _e157 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
        if (_e157 > 0f) {
            if (_e157 < 1f) {
                phi_401_ = _e157;
            } else {
                phi_401_ = 1f;
            }
            let _e161 = phi_401_;
            phi_402_ = _e161;
        } else {
            phi_402_ = 0f;
        }
        let _e163 = phi_402_;
        let _e199 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e199 > 0f) {
            if (_e199 < 1f) {
                phi_447_ = _e199;
            } else {
                phi_447_ = 1f;
            }
            let _e203 = phi_447_;
            phi_448_ = _e203;
        } else {
            phi_448_ = 0f;
        }
        let _e205 = phi_448_;
        let _e238 = ((((_e9 * param_4[0]) + (_e12 * param_4[1])) + (_e15 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e238 > 0f) {
            if (_e238 < 1f) {
                phi_490_ = _e238;
            } else {
                phi_490_ = 1f;
            }
            let _e242 = phi_490_;
            phi_491_ = _e242;
        } else {
            phi_491_ = 0f;
        }
        let _e244 = phi_491_;
        let _e257 = (param_2[0] - param_4[0]);
        let _e260 = (param_2[1] - param_4[1]);
        let _e263 = (param_2[2] - param_4[2]);
        let _e283 = ((((_e257 * param_3[0]) + (_e260 * param_3[1])) + (_e263 * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
        if (_e283 > 0f) {
            if (_e283 < 1f) {
                phi_539_ = _e283;
            } else {
                phi_539_ = 1f;
            }
            let _e287 = phi_539_;
            phi_540_ = _e287;
        } else {
            phi_540_ = 0f;
        }
        let _e289 = phi_540_;
        phi_682_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e163)), (param_2[1] - (param_3[1] * _e163)), (param_2[2] - (param_3[2] * _e163))), array<f32, 3>((param_2[0] - (param_4[0] * _e205)), (param_2[1] - (param_4[1] * _e205)), (param_2[2] - (param_4[2] * _e205))), array<f32, 3>((_e9 - (param_4[0] * _e244)), (_e12 - (param_4[1] * _e244)), (_e15 - (param_4[2] * _e244))), array<f32, 3>((_e257 - (param_3[0] * _e289)), (_e260 - (param_3[1] * _e289)), (_e263 - (param_3[2] * _e289))));
    } else {
        let _e19 = (param_4[0] - param_3[0]);
        let _e22 = (param_4[1] - param_3[1]);
        let _e25 = (param_4[2] - param_3[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > 0f) {
            if (_e36 < 1f) {
                phi_580_ = _e36;
            } else {
                phi_580_ = 1f;
            }
            let _e40 = phi_580_;
            phi_581_ = _e40;
        } else {
            phi_581_ = 0f;
        }
        let _e42 = phi_581_;
        let _e49 = array<f32, 3>((_e9 - (_e19 * _e42)), (_e12 - (_e22 * _e42)), (_e15 - (_e25 * _e42)));
        let _e72 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
        if (_e72 > 0f) {
            if (_e72 < 1f) {
                phi_620_ = _e72;
            } else {
                phi_620_ = 1f;
            }
            let _e76 = phi_620_;
            phi_621_ = _e76;
        } else {
            phi_621_ = 0f;
        }
        let _e78 = phi_621_;
        let _e114 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e114 > 0f) {
            if (_e114 < 1f) {
                phi_666_ = _e114;
            } else {
                phi_666_ = 1f;
            }
            let _e118 = phi_666_;
            phi_667_ = _e118;
        } else {
            phi_667_ = 0f;
        }
        let _e120 = phi_667_;
        phi_682_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e78)), (param_2[1] - (param_3[1] * _e78)), (param_2[2] - (param_3[2] * _e78))), array<f32, 3>((param_2[0] - (param_4[0] * _e120)), (param_2[1] - (param_4[1] * _e120)), (param_2[2] - (param_4[2] * _e120))), _e49, _e49);
    }
    let _e302 = phi_682_;
    let _e305 = function_(_e302[0], _e302[1]);
    let _e307 = function_(_e305, _e302[2]);
    let _e309 = function_(_e307, _e302[3]);
    return _e309;
}

fn function_2(param_6: array<f32, 3>, param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: u32) -> array<f32, 3> {
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
    var phi_305_: bool;
    var phi_309_: bool;
    var phi_282_: bool;
    var phi_283_: bool;
    var phi_284_: bool;
    var phi_285_: bool;
    var phi_286_: bool;
    var phi_287_: bool;
    var phi_291_: bool;
    var phi_310_: bool;
    var phi_343_: array<f32, 3>;
    var phi_344_: bool;
    var phi_345_: array<f32, 3>;
    var phi_346_: bool;
    var phi_351_: array<f32, 3>;

    let _e23 = (((param_7[0] * param_7[0]) + (param_7[1] * param_7[1])) + (param_7[2] * param_7[2]));
    let _e34 = (((param_7[0] * param_8[0]) + (param_7[1] * param_8[1])) + (param_7[2] * param_8[2]));
    let _e45 = (((param_8[0] * param_8[0]) + (param_8[1] * param_8[1])) + (param_8[2] * param_8[2]));
    let _e56 = (((param_6[0] * param_7[0]) + (param_6[1] * param_7[1])) + (param_6[2] * param_7[2]));
    let _e67 = (((param_6[0] * param_8[0]) + (param_6[1] * param_8[1])) + (param_6[2] * param_8[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e74 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e78 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_9 != 0u) {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                if (_e74 <= 1f) {
                    phi_282_ = (_e78 <= 1f);
                    phi_283_ = false;
                } else {
                    phi_282_ = bool();
                    phi_283_ = true;
                }
                let _e99 = phi_282_;
                let _e101 = phi_283_;
                phi_284_ = _e99;
                phi_285_ = _e101;
            } else {
                phi_284_ = bool();
                phi_285_ = true;
            }
            let _e103 = phi_284_;
            let _e105 = phi_285_;
            phi_286_ = _e103;
            phi_287_ = _e105;
        } else {
            phi_286_ = bool();
            phi_287_ = true;
        }
        let _e107 = phi_286_;
        let _e109 = phi_287_;
        if _e109 {
            phi_291_ = false;
        } else {
            phi_291_ = _e107;
        }
        let _e111 = phi_291_;
        phi_310_ = _e111;
    } else {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                phi_302_ = ((_e74 + _e78) <= 1f);
                phi_303_ = false;
            } else {
                phi_302_ = bool();
                phi_303_ = true;
            }
            let _e85 = phi_302_;
            let _e87 = phi_303_;
            phi_304_ = _e85;
            phi_305_ = _e87;
        } else {
            phi_304_ = bool();
            phi_305_ = true;
        }
        let _e89 = phi_304_;
        let _e91 = phi_305_;
        if _e91 {
            phi_309_ = false;
        } else {
            phi_309_ = _e89;
        }
        let _e93 = phi_309_;
        phi_310_ = _e93;
    }
    let _e113 = phi_310_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e113 {
            phi_343_ = array<f32, 3>((param_6[0] - ((param_7[0] * _e74) + (param_8[0] * _e78))), (param_6[1] - ((param_7[1] * _e74) + (param_8[1] * _e78))), (param_6[2] - ((param_7[2] * _e74) + (param_8[2] * _e78))));
            phi_344_ = false;
        } else {
            phi_343_ = array<f32, 3>();
            phi_344_ = true;
        }
        let _e141 = phi_343_;
        let _e143 = phi_344_;
        phi_345_ = _e141;
        phi_346_ = _e143;
    } else {
        phi_345_ = array<f32, 3>();
        phi_346_ = true;
    }
    let _e145 = phi_345_;
    let _e147 = phi_346_;
    if _e147 {
        let _e148 = function_1(param_6, param_7, param_8, param_9);
        phi_351_ = _e148;
    } else {
        phi_351_ = _e145;
    }
    let _e150 = phi_351_;
    return _e150;
}

fn function_3(param_10: f32) -> array<u32, 2> {
    var phi_740_: array<u32, 2>;
    var phi_741_: array<u32, 2>;
    var phi_742_: bool;
    var phi_746_: array<u32, 2>;

    let _e13 = bitcast<u32>(param_10);
    if (_e13 < 8388608u) {
        phi_741_ = array<u32, 2>();
        phi_742_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_740_ = array<u32, 2>();
        } else {
            phi_740_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_740_;
        phi_741_ = _e31;
        phi_742_ = _e17;
    }
    let _e33 = phi_741_;
    let _e35 = phi_742_;
    if _e35 {
        phi_746_ = array<u32, 2>(0u, 0u);
    } else {
        phi_746_ = _e33;
    }
    let _e37 = phi_746_;
    return _e37;
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_32;
    var local_1: type_32;
    var local_2: type_24;
    var local_3: type_24;
    var local_4: type_24;
    var local_5: array<type_33, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: type_32;
    var local_9: type_32;
    var local_10: type_32;
    var local_11: type_32;
    var local_12: array<f32, 4>;
    var local_13: array<f32, 3>;
    var local_14: type_37;
    var local_15: type_32;
    var local_16: type_32;
    var local_17: type_32;
    var local_18: type_23;
    var phi_805_: u32;
    var phi_821_: u32;
    var phi_842_: u32;
    var phi_843_: u32;
    var phi_846_: type_12;
    var phi_847_: type_12;
    var phi_870_: type_12;
    var phi_1047_: array<u32, 2>;
    var phi_1048_: array<u32, 2>;
    var phi_1049_: bool;
    var phi_1053_: array<u32, 2>;
    var phi_1067_: bool;
    var phi_1083_: bool;
    var phi_1089_: f32;
    var phi_1095_: f32;
    var phi_1100_: f32;
    var phi_1106_: f32;
    var phi_1111_: f32;
    var phi_1117_: f32;
    var phi_1123_: f32;
    var phi_1128_: f32;
    var phi_1134_: f32;
    var phi_1139_: f32;
    var phi_1144_: f32;
    var phi_1151_: f32;
    var phi_1157_: f32;
    var phi_1162_: f32;
    var phi_1168_: f32;
    var phi_1173_: f32;
    var phi_1179_: f32;
    var phi_1185_: f32;
    var phi_1190_: f32;
    var phi_1196_: f32;
    var phi_1201_: f32;
    var phi_1206_: f32;
    var phi_1213_: f32;
    var phi_1219_: f32;
    var phi_1224_: f32;
    var phi_1230_: f32;
    var phi_1235_: f32;
    var phi_1241_: f32;
    var phi_1247_: f32;
    var phi_1252_: f32;
    var phi_1258_: f32;
    var phi_1263_: f32;
    var phi_1268_: f32;
    var phi_1274_: f32;
    var phi_1279_: f32;
    var phi_1286_: bool;
    var phi_1310_: u32;
    var phi_1321_: f32;
    var phi_1322_: f32;
    var phi_1353_: type_38;
    var phi_1354_: bool;
    var phi_1355_: type_38;
    var phi_1356_: bool;
    var phi_1357_: type_38;
    var phi_1358_: bool;
    var phi_1363_: type_38;
    var phi_8309_: f32;
    var phi_8316_: f32;
    var phi_8321_: f32;
    var phi_8328_: f32;
    var phi_8333_: f32;
    var phi_8346_: f32;
    var phi_8353_: f32;
    var phi_8358_: f32;
    var phi_8365_: f32;
    var phi_8370_: f32;
    var phi_8375_: f32;
    var phi_8392_: f32;
    var phi_8399_: f32;
    var phi_8404_: f32;
    var phi_8411_: f32;
    var phi_8416_: f32;
    var phi_8430_: f32;
    var phi_8437_: f32;
    var phi_8442_: f32;
    var phi_8449_: f32;
    var phi_8454_: f32;
    var phi_8459_: f32;
    var phi_8476_: f32;
    var phi_8483_: f32;
    var phi_8488_: f32;
    var phi_8495_: f32;
    var phi_8500_: f32;
    var phi_8514_: f32;
    var phi_8521_: f32;
    var phi_8526_: f32;
    var phi_8533_: f32;
    var phi_8538_: f32;
    var phi_8543_: f32;
    var phi_8574_: f32;
    var phi_8580_: f32;
    var phi_8587_: f32;
    var phi_8594_: f32;
    var phi_8600_: f32;
    var phi_8607_: f32;
    var phi_8613_: f32;
    var phi_8619_: f32;
    var phi_8625_: f32;
    var phi_8632_: f32;
    var phi_8639_: f32;
    var phi_8663_: f32;
    var phi_8668_: f32;
    var phi_8673_: f32;
    var phi_8678_: f32;
    var phi_8683_: f32;
    var phi_8688_: f32;
    var phi_8698_: f32;
    var phi_8711_: f32;
    var phi_8717_: f32;
    var phi_8722_: f32;
    var phi_8728_: f32;
    var phi_8734_: f32;
    var phi_8739_: f32;
    var phi_8744_: f32;
    var phi_8752_: bool;
    var phi_8757_: f32;
    var phi_8764_: f32;
    var phi_8770_: f32;
    var phi_8788_: f32;
    var phi_8936_: f32;
    var phi_8943_: f32;
    var phi_8948_: f32;
    var phi_8955_: f32;
    var phi_8960_: f32;
    var phi_8973_: f32;
    var phi_8980_: f32;
    var phi_8985_: f32;
    var phi_8992_: f32;
    var phi_8997_: f32;
    var phi_9002_: f32;
    var phi_9019_: f32;
    var phi_9026_: f32;
    var phi_9031_: f32;
    var phi_9038_: f32;
    var phi_9043_: f32;
    var phi_9057_: f32;
    var phi_9064_: f32;
    var phi_9069_: f32;
    var phi_9076_: f32;
    var phi_9081_: f32;
    var phi_9086_: f32;
    var phi_9103_: f32;
    var phi_9110_: f32;
    var phi_9115_: f32;
    var phi_9122_: f32;
    var phi_9127_: f32;
    var phi_9141_: f32;
    var phi_9148_: f32;
    var phi_9153_: f32;
    var phi_9160_: f32;
    var phi_9165_: f32;
    var phi_9170_: f32;
    var phi_9288_: f32;
    var phi_9295_: f32;
    var phi_9303_: f32;
    var phi_9347_: type_14;
    var phi_9350_: f32;
    var phi_9371_: bool;
    var phi_9377_: type_15;
    var phi_9348_: type_14;
    var phi_9391_: type_15;
    var phi_9351_: f32;
    var local_19: f32;
    var phi_9340_: f32;
    var phi_9404_: f32;
    var phi_9470_: f32;
    var phi_9476_: f32;
    var phi_9485_: f32;
    var phi_9491_: f32;
    var phi_9500_: f32;
    var phi_9506_: f32;
    var phi_9515_: f32;
    var phi_9521_: f32;
    var phi_9527_: type_32;
    var phi_9528_: bool;
    var phi_9529_: type_32;
    var phi_9530_: bool;
    var phi_9538_: type_32;
    var phi_9707_: bool;
    var phi_9708_: bool;
    var phi_9709_: bool;
    var phi_9710_: bool;
    var phi_9711_: bool;
    var phi_9712_: bool;
    var phi_9716_: bool;
    var phi_9743_: f32;
    var phi_9797_: type_14;
    var phi_9800_: f32;
    var phi_9821_: bool;
    var phi_9827_: type_15;
    var phi_9798_: type_14;
    var phi_9841_: type_15;
    var phi_9801_: f32;
    var local_20: f32;
    var phi_9790_: f32;
    var phi_9854_: f32;
    var phi_9920_: f32;
    var phi_9926_: f32;
    var phi_9935_: f32;
    var phi_9941_: f32;
    var phi_9950_: f32;
    var phi_9956_: f32;
    var phi_9965_: f32;
    var phi_9971_: f32;
    var phi_9977_: type_32;
    var phi_9978_: bool;
    var phi_9979_: type_32;
    var phi_9980_: bool;
    var phi_9988_: type_32;
    var phi_10157_: bool;
    var phi_10158_: bool;
    var phi_10159_: bool;
    var phi_10160_: bool;
    var phi_10161_: bool;
    var phi_10162_: bool;
    var phi_10166_: bool;
    var phi_10199_: f32;
    var phi_10247_: type_14;
    var phi_10250_: f32;
    var phi_10271_: bool;
    var phi_10277_: type_15;
    var phi_10248_: type_14;
    var phi_10291_: type_15;
    var phi_10251_: f32;
    var local_21: f32;
    var phi_10240_: f32;
    var phi_10304_: f32;
    var phi_10370_: f32;
    var phi_10376_: f32;
    var phi_10385_: f32;
    var phi_10391_: f32;
    var phi_10400_: f32;
    var phi_10406_: f32;
    var phi_10415_: f32;
    var phi_10421_: f32;
    var phi_10427_: type_32;
    var phi_10428_: bool;
    var phi_10429_: type_32;
    var phi_10430_: bool;
    var phi_10438_: type_32;
    var phi_10607_: bool;
    var phi_10608_: bool;
    var phi_10609_: bool;
    var phi_10610_: bool;
    var phi_10611_: bool;
    var phi_10612_: bool;
    var phi_10616_: bool;
    var phi_10656_: f32;
    var phi_10697_: type_14;
    var phi_10700_: f32;
    var phi_10721_: bool;
    var phi_10727_: type_15;
    var phi_10698_: type_14;
    var phi_10741_: type_15;
    var phi_10701_: f32;
    var local_22: f32;
    var phi_10690_: f32;
    var phi_10754_: f32;
    var phi_10820_: f32;
    var phi_10826_: f32;
    var phi_10835_: f32;
    var phi_10841_: f32;
    var phi_10850_: f32;
    var phi_10856_: f32;
    var phi_10865_: f32;
    var phi_10871_: f32;
    var phi_10877_: type_32;
    var phi_10878_: bool;
    var phi_10879_: type_32;
    var phi_10880_: bool;
    var phi_10888_: type_32;
    var phi_11057_: bool;
    var phi_11058_: bool;
    var phi_11059_: bool;
    var phi_11060_: bool;
    var phi_11061_: bool;
    var phi_11062_: bool;
    var phi_11066_: bool;
    var phi_11067_: bool;
    var phi_11068_: bool;
    var phi_11069_: bool;
    var phi_11070_: bool;
    var phi_11071_: bool;
    var phi_11075_: bool;
    var phi_11081_: type_28;
    var phi_11082_: bool;
    var phi_11083_: type_28;
    var phi_11084_: bool;
    var phi_11127_: type_14;
    var phi_11130_: f32;
    var phi_11151_: bool;
    var phi_11157_: type_15;
    var phi_11128_: type_14;
    var phi_11171_: type_15;
    var phi_11131_: f32;
    var local_23: f32;
    var phi_11120_: f32;
    var phi_11184_: f32;
    var phi_11190_: f32;
    var phi_11215_: type_12;
    var phi_11218_: u32;
    var phi_11216_: type_12;
    var phi_11241_: type_12;
    var phi_11285_: u32;
    var phi_11286_: u32;
    var phi_11219_: u32;
    var phi_11287_: u32;
    var phi_11307_: type_12;
    var phi_11308_: type_12;
    var phi_11331_: type_12;
    var phi_11350_: f32;
    var phi_11363_: f32;
    var phi_11397_: f32;
    var phi_11404_: f32;
    var phi_11415_: bool;
    var phi_11416_: bool;
    var phi_11417_: bool;
    var phi_11418_: bool;
    var phi_11422_: bool;
    var phi_11433_: type_41;
    var phi_11434_: type_41;
    var phi_11435_: bool;
    var phi_11436_: type_41;
    var phi_11437_: bool;
    var phi_11448_: f32;
    var phi_11458_: type_12;
    var phi_11461_: f32;
    var phi_11463_: f32;
    var phi_11465_: f32;
    var phi_11459_: type_12;
    var phi_11488_: type_12;
    var phi_11513_: f32;
    var phi_11514_: f32;
    var phi_11540_: f32;
    var phi_11556_: f32;
    var phi_11563_: bool;
    var phi_11564_: bool;
    var phi_11565_: bool;
    var phi_11571_: f32;
    var phi_11572_: f32;
    var phi_11573_: bool;
    var phi_11462_: f32;
    var phi_11464_: f32;
    var phi_11466_: f32;
    var phi_11574_: f32;
    var phi_11575_: bool;
    var phi_11576_: bool;
    var local_24: bool;
    var phi_11580_: f32;
    var phi_11581_: f32;
    var phi_11589_: f32;
    var phi_11593_: type_12;
    var phi_11596_: f32;
    var phi_11594_: type_12;
    var phi_11619_: type_12;
    var phi_11649_: f32;
    var phi_11650_: bool;
    var phi_11651_: f32;
    var phi_11652_: bool;
    var phi_11653_: bool;
    var phi_11654_: bool;
    var phi_11655_: f32;
    var phi_11597_: f32;
    var phi_11656_: bool;
    var phi_11657_: bool;
    var phi_11658_: bool;
    var phi_11659_: bool;
    var local_25: bool;
    var phi_11663_: bool;
    var phi_11664_: bool;
    var phi_11668_: bool;
    var phi_11672_: f32;
    var phi_11673_: f32;
    var phi_11675_: type_41;
    var phi_11704_: f32;
    var phi_11711_: f32;
    var phi_11716_: f32;
    var phi_11723_: f32;
    var phi_11728_: f32;
    var phi_11741_: f32;
    var phi_11748_: f32;
    var phi_11753_: f32;
    var phi_11760_: f32;
    var phi_11765_: f32;
    var phi_11770_: f32;
    var phi_11829_: f32;
    var phi_11835_: f32;
    var phi_11840_: f32;
    var phi_11846_: f32;
    var phi_11851_: f32;
    var phi_11863_: f32;
    var phi_11869_: f32;
    var phi_11874_: f32;
    var phi_11880_: f32;
    var phi_11885_: f32;
    var phi_11911_: f32;
    var phi_11918_: f32;
    var phi_11923_: f32;
    var phi_11930_: f32;
    var phi_11935_: f32;
    var phi_11948_: f32;
    var phi_11955_: f32;
    var phi_11960_: f32;
    var phi_11967_: f32;
    var phi_11972_: f32;
    var phi_11977_: f32;
    var phi_12036_: f32;
    var phi_12042_: f32;
    var phi_12047_: f32;
    var phi_12053_: f32;
    var phi_12058_: f32;
    var phi_12070_: f32;
    var phi_12076_: f32;
    var phi_12081_: f32;
    var phi_12087_: f32;
    var phi_12092_: f32;
    var phi_12118_: f32;
    var phi_12125_: f32;
    var phi_12130_: f32;
    var phi_12137_: f32;
    var phi_12142_: f32;
    var phi_12155_: f32;
    var phi_12162_: f32;
    var phi_12167_: f32;
    var phi_12174_: f32;
    var phi_12179_: f32;
    var phi_12184_: f32;
    var phi_12243_: f32;
    var phi_12249_: f32;
    var phi_12254_: f32;
    var phi_12260_: f32;
    var phi_12265_: f32;
    var phi_12277_: f32;
    var phi_12283_: f32;
    var phi_12288_: f32;
    var phi_12294_: f32;
    var phi_12299_: f32;
    var phi_12348_: f32;
    var phi_12354_: f32;
    var phi_12382_: f32;
    var phi_12388_: f32;
    var phi_12393_: u32;
    var phi_12394_: u32;
    var phi_12364_: f32;
    var phi_12370_: f32;
    var phi_12375_: u32;
    var phi_12376_: u32;
    var phi_12395_: u32;
    var phi_12396_: u32;
    var phi_12465_: f32;
    var phi_12474_: f32;
    var phi_12609_: f32;
    var phi_12615_: f32;
    var phi_12622_: f32;
    var phi_12677_: type_12;
    var phi_12680_: bool;
    var phi_12678_: type_12;
    var phi_12703_: type_12;
    var phi_12730_: bool;
    var phi_12731_: bool;
    var phi_12681_: bool;
    var phi_12732_: bool;
    var phi_12733_: bool;
    var local_26: bool;
    var phi_12737_: bool;
    var local_27: bool;
    var phi_12744_: u32;
    var phi_12745_: u32;
    var phi_12746_: bool;
    var phi_12747_: u32;
    var phi_12748_: u32;
    var phi_12749_: bool;
    var phi_12753_: u32;
    var phi_12763_: bool;
    var phi_12775_: bool;
    var phi_12776_: bool;
    var phi_12924_: f32;
    var phi_12931_: f32;
    var phi_12936_: f32;
    var phi_12943_: f32;
    var phi_12948_: f32;
    var phi_12961_: f32;
    var phi_12968_: f32;
    var phi_12973_: f32;
    var phi_12980_: f32;
    var phi_12985_: f32;
    var phi_12990_: f32;
    var phi_13007_: f32;
    var phi_13014_: f32;
    var phi_13019_: f32;
    var phi_13026_: f32;
    var phi_13031_: f32;
    var phi_13045_: f32;
    var phi_13052_: f32;
    var phi_13057_: f32;
    var phi_13064_: f32;
    var phi_13069_: f32;
    var phi_13074_: f32;
    var phi_13091_: f32;
    var phi_13098_: f32;
    var phi_13103_: f32;
    var phi_13110_: f32;
    var phi_13115_: f32;
    var phi_13129_: f32;
    var phi_13136_: f32;
    var phi_13141_: f32;
    var phi_13148_: f32;
    var phi_13153_: f32;
    var phi_13158_: f32;
    var phi_13199_: type_12;
    var phi_13202_: f32;
    var phi_13204_: f32;
    var phi_13206_: f32;
    var phi_13208_: f32;
    var phi_13210_: bool;
    var phi_13212_: u32;
    var phi_13200_: type_12;
    var phi_13235_: type_12;
    var phi_13349_: f32;
    var phi_13355_: f32;
    var phi_13361_: f32;
    var phi_13363_: array<f32, 3>;
    var phi_13370_: f32;
    var phi_13377_: f32;
    var phi_13385_: f32;
    var phi_13429_: type_14;
    var phi_13432_: f32;
    var phi_13453_: bool;
    var phi_13459_: type_15;
    var phi_13430_: type_14;
    var phi_13473_: type_15;
    var phi_13433_: f32;
    var local_28: f32;
    var phi_13422_: f32;
    var phi_13486_: f32;
    var phi_13552_: f32;
    var phi_13558_: f32;
    var phi_13567_: f32;
    var phi_13573_: f32;
    var phi_13582_: f32;
    var phi_13588_: f32;
    var phi_13597_: f32;
    var phi_13603_: f32;
    var phi_13609_: type_32;
    var phi_13610_: bool;
    var phi_13611_: type_32;
    var phi_13612_: bool;
    var phi_13620_: type_32;
    var phi_13791_: bool;
    var phi_13792_: bool;
    var phi_13793_: bool;
    var phi_13794_: bool;
    var phi_13795_: bool;
    var phi_13796_: bool;
    var phi_13800_: bool;
    var phi_14097_: bool;
    var phi_14098_: bool;
    var phi_14099_: bool;
    var phi_14100_: bool;
    var phi_14101_: bool;
    var phi_14102_: bool;
    var phi_14106_: bool;
    var phi_14110_: bool;
    var phi_14121_: bool;
    var phi_14122_: bool;
    var phi_14196_: bool;
    var phi_14197_: bool;
    var phi_14217_: f32;
    var phi_14218_: bool;
    var phi_14219_: f32;
    var phi_14220_: bool;
    var phi_14221_: f32;
    var phi_14222_: bool;
    var phi_14223_: bool;
    var phi_14227_: f32;
    var phi_14228_: bool;
    var phi_14232_: f32;
    var phi_14264_: bool;
    var phi_14265_: bool;
    var phi_14285_: f32;
    var phi_14286_: bool;
    var phi_14287_: f32;
    var phi_14288_: bool;
    var phi_14289_: f32;
    var phi_14290_: bool;
    var phi_14291_: bool;
    var phi_14295_: f32;
    var phi_14296_: bool;
    var phi_14300_: f32;
    var phi_14305_: f32;
    var phi_14337_: bool;
    var phi_14338_: bool;
    var phi_14358_: f32;
    var phi_14359_: bool;
    var phi_14360_: f32;
    var phi_14361_: bool;
    var phi_14362_: f32;
    var phi_14363_: bool;
    var phi_14364_: bool;
    var phi_14368_: f32;
    var phi_14369_: bool;
    var phi_14373_: f32;
    var phi_14405_: bool;
    var phi_14406_: bool;
    var phi_14426_: f32;
    var phi_14427_: bool;
    var phi_14428_: f32;
    var phi_14429_: bool;
    var phi_14430_: f32;
    var phi_14431_: bool;
    var phi_14432_: bool;
    var phi_14436_: f32;
    var phi_14437_: bool;
    var phi_14441_: f32;
    var phi_14446_: f32;
    var phi_14451_: f32;
    var phi_14456_: f32;
    var phi_14950_: bool;
    var phi_14951_: bool;
    var phi_14956_: f32;
    var phi_14958_: f32;
    var phi_14961_: f32;
    var phi_14962_: f32;
    var phi_14963_: bool;
    var phi_14965_: f32;
    var phi_14966_: f32;
    var phi_14967_: f32;
    var phi_14969_: bool;
    var phi_14970_: bool;
    var phi_14972_: bool;
    var phi_14973_: f32;
    var phi_14974_: f32;
    var phi_14975_: f32;
    var phi_14977_: bool;
    var phi_14978_: bool;
    var phi_14979_: bool;
    var phi_14981_: bool;
    var phi_14982_: f32;
    var phi_14983_: f32;
    var phi_14984_: f32;
    var phi_14986_: bool;
    var phi_14987_: bool;
    var phi_14988_: bool;
    var phi_14990_: bool;
    var phi_15076_: f32;
    var phi_15149_: f32;
    var phi_15154_: f32;
    var phi_15227_: f32;
    var phi_15300_: f32;
    var phi_15305_: f32;
    var phi_15321_: f32;
    var phi_15322_: f32;
    var phi_15323_: f32;
    var phi_15003_: bool;
    var phi_15325_: u32;
    var phi_15326_: f32;
    var phi_15327_: bool;
    var phi_15328_: bool;
    var phi_15329_: bool;
    var phi_15330_: u32;
    var phi_15331_: f32;
    var phi_15332_: f32;
    var phi_15333_: f32;
    var phi_15334_: f32;
    var phi_15335_: bool;
    var phi_15336_: u32;
    var phi_15337_: bool;
    var phi_15338_: bool;
    var phi_15339_: bool;
    var phi_15340_: bool;
    var phi_15342_: bool;
    var phi_15351_: f32;
    var phi_15356_: f32;
    var phi_15365_: bool;
    var phi_15369_: bool;
    var phi_15370_: f32;
    var phi_15371_: f32;
    var phi_15372_: f32;
    var phi_15373_: f32;
    var phi_15374_: bool;
    var phi_15375_: u32;
    var phi_15376_: bool;
    var phi_15377_: bool;
    var phi_15378_: bool;
    var phi_15379_: bool;
    var phi_15381_: bool;
    var phi_13203_: f32;
    var phi_13205_: f32;
    var phi_13207_: f32;
    var phi_13209_: f32;
    var phi_13211_: bool;
    var phi_13213_: u32;
    var phi_15382_: f32;
    var phi_15384_: bool;
    var phi_15385_: bool;
    var phi_15386_: bool;
    var phi_15387_: bool;
    var phi_15389_: bool;
    var phi_15390_: bool;
    var local_29: bool;
    var phi_15394_: bool;
    var phi_15395_: bool;
    var phi_15397_: bool;
    var phi_15398_: bool;
    var local_30: f32;
    var phi_15403_: type_28;
    var phi_15404_: bool;
    var phi_15406_: bool;
    var phi_15407_: bool;
    var phi_15408_: bool;
    var phi_15413_: type_28;
    var phi_15415_: bool;
    var phi_15416_: bool;
    var phi_15417_: bool;
    var phi_15418_: bool;
    var phi_15430_: f32;
    var phi_15431_: bool;
    var phi_15432_: bool;
    var phi_15433_: bool;
    var phi_15438_: type_28;
    var phi_15439_: bool;
    var phi_15440_: bool;
    var phi_15445_: type_28;
    var phi_15446_: bool;
    var phi_15450_: type_28;
    var phi_15457_: bool;
    var phi_15458_: f32;
    var phi_15459_: bool;
    var phi_15460_: bool;
    var phi_15461_: bool;
    var phi_15462_: bool;
    var phi_15463_: f32;
    var phi_15464_: f32;
    var phi_15465_: bool;
    var phi_15466_: bool;
    var phi_15467_: bool;
    var phi_15468_: bool;
    var phi_15469_: f32;
    var phi_15470_: f32;
    var phi_15471_: bool;
    var phi_15472_: bool;
    var phi_15473_: bool;
    var phi_15474_: bool;
    var phi_15478_: bool;
    var phi_15479_: bool;
    var phi_15480_: bool;
    var phi_15481_: type_41;
    var phi_15482_: bool;
    var phi_15483_: f32;
    var phi_15484_: f32;
    var phi_15485_: type_41;
    var phi_15486_: bool;
    var phi_15487_: bool;
    var phi_15488_: bool;
    var phi_15489_: bool;
    var phi_15493_: bool;
    var phi_15494_: bool;
    var phi_15495_: bool;
    var phi_15496_: type_41;
    var phi_15497_: bool;
    var phi_15498_: f32;
    var phi_15499_: f32;
    var phi_15500_: type_41;
    var phi_15501_: bool;
    var phi_15502_: bool;
    var phi_15503_: bool;
    var phi_15504_: bool;
    var local_31: bool;
    var phi_15509_: type_28;
    var phi_15510_: bool;
    var phi_15511_: bool;
    var local_32: bool;
    var local_33: type_41;
    var local_34: f32;
    var local_35: f32;
    var local_36: f32;
    var phi_15525_: type_28;
    var phi_15526_: bool;
    var phi_15527_: type_28;
    var phi_15528_: bool;
    var local_37: f32;
    var phi_15533_: type_28;
    var phi_15534_: type_28;
    var phi_15535_: bool;
    var local_38: type_41;
    var phi_15541_: type_28;
    var phi_15542_: bool;
    var phi_15546_: type_28;
    var phi_15547_: type_28;
    var phi_15548_: bool;
    var phi_15552_: type_28;
    var phi_15553_: type_28;
    var phi_15554_: bool;
    var phi_15558_: type_28;
    var phi_15569_: bool;
    var phi_15570_: bool;
    var phi_15574_: bool;
    var phi_15578_: u32;
    var phi_1537_: type_14;
    var phi_1540_: f32;
    var phi_1561_: bool;
    var phi_1567_: type_15;
    var phi_1538_: type_14;
    var phi_1581_: type_15;
    var phi_1541_: f32;
    var local_39: f32;
    var phi_1530_: f32;
    var phi_1594_: f32;
    var phi_1610_: f32;
    var phi_1617_: f32;
    var phi_1622_: f32;
    var phi_1629_: f32;
    var phi_1634_: f32;
    var phi_1647_: f32;
    var phi_1654_: f32;
    var phi_1659_: f32;
    var phi_1666_: f32;
    var phi_1671_: f32;
    var phi_1676_: f32;
    var phi_1693_: f32;
    var phi_1700_: f32;
    var phi_1705_: f32;
    var phi_1712_: f32;
    var phi_1717_: f32;
    var phi_1731_: f32;
    var phi_1738_: f32;
    var phi_1743_: f32;
    var phi_1750_: f32;
    var phi_1755_: f32;
    var phi_1760_: f32;
    var phi_1777_: f32;
    var phi_1784_: f32;
    var phi_1789_: f32;
    var phi_1796_: f32;
    var phi_1801_: f32;
    var phi_1815_: f32;
    var phi_1822_: f32;
    var phi_1827_: f32;
    var phi_1834_: f32;
    var phi_1839_: f32;
    var phi_1844_: f32;
    var phi_2105_: f32;
    var phi_2112_: f32;
    var phi_2117_: f32;
    var phi_2124_: f32;
    var phi_2129_: f32;
    var phi_2142_: f32;
    var phi_2149_: f32;
    var phi_2154_: f32;
    var phi_2161_: f32;
    var phi_2166_: f32;
    var phi_2171_: f32;
    var phi_2188_: f32;
    var phi_2195_: f32;
    var phi_2200_: f32;
    var phi_2207_: f32;
    var phi_2212_: f32;
    var phi_2226_: f32;
    var phi_2233_: f32;
    var phi_2238_: f32;
    var phi_2245_: f32;
    var phi_2250_: f32;
    var phi_2255_: f32;
    var phi_2272_: f32;
    var phi_2279_: f32;
    var phi_2284_: f32;
    var phi_2291_: f32;
    var phi_2296_: f32;
    var phi_2310_: f32;
    var phi_2317_: f32;
    var phi_2322_: f32;
    var phi_2329_: f32;
    var phi_2334_: f32;
    var phi_2339_: f32;
    var phi_2370_: f32;
    var phi_2376_: f32;
    var phi_2383_: f32;
    var phi_2390_: f32;
    var phi_2396_: f32;
    var phi_2403_: f32;
    var phi_2409_: f32;
    var phi_2415_: f32;
    var phi_2421_: f32;
    var phi_2428_: f32;
    var phi_2435_: f32;
    var phi_2459_: f32;
    var phi_2464_: f32;
    var phi_2469_: f32;
    var phi_2474_: f32;
    var phi_2479_: f32;
    var phi_2484_: f32;
    var phi_2494_: f32;
    var phi_2503_: type_39;
    var phi_2504_: bool;
    var phi_2505_: type_39;
    var phi_2506_: bool;
    var phi_2512_: type_14;
    var phi_2515_: f32;
    var phi_2517_: u32;
    var phi_2519_: f32;
    var phi_2540_: bool;
    var phi_2546_: type_15;
    var phi_2513_: type_14;
    var phi_2560_: type_15;
    var phi_2575_: bool;
    var phi_2576_: bool;
    var phi_2722_: f32;
    var phi_2729_: f32;
    var phi_2734_: f32;
    var phi_2741_: f32;
    var phi_2746_: f32;
    var phi_2759_: f32;
    var phi_2766_: f32;
    var phi_2771_: f32;
    var phi_2778_: f32;
    var phi_2783_: f32;
    var phi_2788_: f32;
    var phi_2805_: f32;
    var phi_2812_: f32;
    var phi_2817_: f32;
    var phi_2824_: f32;
    var phi_2829_: f32;
    var phi_2843_: f32;
    var phi_2850_: f32;
    var phi_2855_: f32;
    var phi_2862_: f32;
    var phi_2867_: f32;
    var phi_2872_: f32;
    var phi_2889_: f32;
    var phi_2896_: f32;
    var phi_2901_: f32;
    var phi_2908_: f32;
    var phi_2913_: f32;
    var phi_2927_: f32;
    var phi_2934_: f32;
    var phi_2939_: f32;
    var phi_2946_: f32;
    var phi_2951_: f32;
    var phi_2956_: f32;
    var phi_2997_: type_12;
    var phi_3000_: f32;
    var phi_3002_: f32;
    var phi_3004_: f32;
    var phi_3006_: f32;
    var phi_3008_: bool;
    var phi_3010_: u32;
    var phi_2998_: type_12;
    var phi_3033_: type_12;
    var phi_3147_: f32;
    var phi_3153_: f32;
    var phi_3159_: f32;
    var phi_3161_: array<f32, 3>;
    var phi_3168_: f32;
    var phi_3175_: f32;
    var phi_3183_: f32;
    var phi_3227_: type_14;
    var phi_3230_: f32;
    var phi_3251_: bool;
    var phi_3257_: type_15;
    var phi_3228_: type_14;
    var phi_3271_: type_15;
    var phi_3231_: f32;
    var local_40: f32;
    var phi_3220_: f32;
    var phi_3284_: f32;
    var phi_3350_: f32;
    var phi_3356_: f32;
    var phi_3365_: f32;
    var phi_3371_: f32;
    var phi_3380_: f32;
    var phi_3386_: f32;
    var phi_3395_: f32;
    var phi_3401_: f32;
    var phi_3407_: type_32;
    var phi_3408_: bool;
    var phi_3409_: type_32;
    var phi_3410_: bool;
    var phi_3418_: type_32;
    var phi_3589_: bool;
    var phi_3590_: bool;
    var phi_3591_: bool;
    var phi_3592_: bool;
    var phi_3593_: bool;
    var phi_3594_: bool;
    var phi_3598_: bool;
    var phi_3895_: bool;
    var phi_3896_: bool;
    var phi_3897_: bool;
    var phi_3898_: bool;
    var phi_3899_: bool;
    var phi_3900_: bool;
    var phi_3904_: bool;
    var phi_3908_: bool;
    var phi_3919_: bool;
    var phi_3920_: bool;
    var phi_3994_: bool;
    var phi_3995_: bool;
    var phi_4015_: f32;
    var phi_4016_: bool;
    var phi_4017_: f32;
    var phi_4018_: bool;
    var phi_4019_: f32;
    var phi_4020_: bool;
    var phi_4021_: bool;
    var phi_4025_: f32;
    var phi_4026_: bool;
    var phi_4030_: f32;
    var phi_4062_: bool;
    var phi_4063_: bool;
    var phi_4083_: f32;
    var phi_4084_: bool;
    var phi_4085_: f32;
    var phi_4086_: bool;
    var phi_4087_: f32;
    var phi_4088_: bool;
    var phi_4089_: bool;
    var phi_4093_: f32;
    var phi_4094_: bool;
    var phi_4098_: f32;
    var phi_4103_: f32;
    var phi_4135_: bool;
    var phi_4136_: bool;
    var phi_4156_: f32;
    var phi_4157_: bool;
    var phi_4158_: f32;
    var phi_4159_: bool;
    var phi_4160_: f32;
    var phi_4161_: bool;
    var phi_4162_: bool;
    var phi_4166_: f32;
    var phi_4167_: bool;
    var phi_4171_: f32;
    var phi_4203_: bool;
    var phi_4204_: bool;
    var phi_4224_: f32;
    var phi_4225_: bool;
    var phi_4226_: f32;
    var phi_4227_: bool;
    var phi_4228_: f32;
    var phi_4229_: bool;
    var phi_4230_: bool;
    var phi_4234_: f32;
    var phi_4235_: bool;
    var phi_4239_: f32;
    var phi_4244_: f32;
    var phi_4249_: f32;
    var phi_4254_: f32;
    var phi_4267_: f32;
    var phi_4404_: type_14;
    var phi_4407_: f32;
    var phi_4428_: bool;
    var phi_4434_: type_15;
    var phi_4405_: type_14;
    var phi_4448_: type_15;
    var phi_4408_: f32;
    var local_41: f32;
    var phi_4397_: f32;
    var phi_4461_: f32;
    var phi_4477_: f32;
    var phi_4484_: f32;
    var phi_4489_: f32;
    var phi_4496_: f32;
    var phi_4501_: f32;
    var phi_4514_: f32;
    var phi_4521_: f32;
    var phi_4526_: f32;
    var phi_4533_: f32;
    var phi_4538_: f32;
    var phi_4543_: f32;
    var phi_4560_: f32;
    var phi_4567_: f32;
    var phi_4572_: f32;
    var phi_4579_: f32;
    var phi_4584_: f32;
    var phi_4598_: f32;
    var phi_4605_: f32;
    var phi_4610_: f32;
    var phi_4617_: f32;
    var phi_4622_: f32;
    var phi_4627_: f32;
    var phi_4644_: f32;
    var phi_4651_: f32;
    var phi_4656_: f32;
    var phi_4663_: f32;
    var phi_4668_: f32;
    var phi_4682_: f32;
    var phi_4689_: f32;
    var phi_4694_: f32;
    var phi_4701_: f32;
    var phi_4706_: f32;
    var phi_4711_: f32;
    var phi_4731_: bool;
    var phi_4732_: bool;
    var phi_4733_: bool;
    var phi_4748_: bool;
    var phi_4749_: bool;
    var phi_4754_: f32;
    var phi_4756_: f32;
    var phi_4757_: f32;
    var phi_4758_: bool;
    var phi_4759_: f32;
    var phi_4760_: f32;
    var phi_4761_: bool;
    var phi_4762_: bool;
    var phi_4763_: f32;
    var phi_4764_: f32;
    var phi_4765_: f32;
    var phi_4766_: f32;
    var phi_4767_: bool;
    var phi_4768_: bool;
    var phi_4769_: bool;
    var phi_4770_: bool;
    var phi_4771_: f32;
    var phi_4772_: f32;
    var phi_4773_: f32;
    var phi_4774_: f32;
    var phi_4775_: bool;
    var phi_4776_: bool;
    var phi_4777_: bool;
    var phi_4778_: bool;
    var phi_4779_: bool;
    var phi_4780_: f32;
    var phi_4781_: f32;
    var phi_4782_: f32;
    var phi_4783_: f32;
    var phi_4784_: bool;
    var phi_4785_: bool;
    var phi_4786_: bool;
    var phi_4787_: bool;
    var phi_4788_: bool;
    var phi_4874_: f32;
    var phi_4947_: f32;
    var phi_4952_: f32;
    var phi_5025_: f32;
    var phi_5098_: f32;
    var phi_5103_: f32;
    var phi_5119_: f32;
    var phi_5120_: f32;
    var phi_5121_: f32;
    var phi_4801_: bool;
    var phi_5123_: u32;
    var phi_5124_: f32;
    var phi_5125_: bool;
    var phi_5126_: bool;
    var phi_5127_: bool;
    var phi_5128_: u32;
    var phi_5129_: f32;
    var phi_5130_: f32;
    var phi_5131_: f32;
    var phi_5132_: f32;
    var phi_5133_: bool;
    var phi_5134_: u32;
    var phi_5135_: bool;
    var phi_5136_: bool;
    var phi_5137_: bool;
    var phi_5138_: bool;
    var phi_5139_: bool;
    var phi_5140_: bool;
    var phi_5149_: f32;
    var phi_5154_: f32;
    var phi_5163_: bool;
    var phi_5167_: bool;
    var phi_5168_: f32;
    var phi_5169_: f32;
    var phi_5170_: f32;
    var phi_5171_: f32;
    var phi_5172_: bool;
    var phi_5173_: u32;
    var phi_5174_: bool;
    var phi_5175_: bool;
    var phi_5176_: bool;
    var phi_5177_: bool;
    var phi_5178_: bool;
    var phi_5179_: bool;
    var phi_3001_: f32;
    var phi_3003_: f32;
    var phi_3005_: f32;
    var phi_3007_: f32;
    var phi_3009_: bool;
    var phi_3011_: u32;
    var phi_5180_: f32;
    var phi_5181_: f32;
    var phi_5182_: bool;
    var phi_5183_: bool;
    var phi_5184_: bool;
    var phi_5185_: bool;
    var phi_5186_: bool;
    var phi_5187_: bool;
    var phi_5188_: bool;
    var local_42: bool;
    var phi_5192_: bool;
    var phi_5193_: bool;
    var phi_5194_: bool;
    var phi_5195_: bool;
    var phi_5196_: bool;
    var local_43: f32;
    var phi_5201_: type_28;
    var phi_5202_: bool;
    var phi_5203_: bool;
    var phi_5204_: bool;
    var phi_5205_: bool;
    var phi_5206_: bool;
    var phi_5211_: type_28;
    var phi_5212_: bool;
    var phi_5213_: bool;
    var phi_5214_: bool;
    var phi_5215_: bool;
    var phi_5216_: bool;
    var phi_5220_: f32;
    var phi_5221_: bool;
    var phi_5222_: bool;
    var phi_5223_: bool;
    var phi_5224_: bool;
    var phi_5228_: f32;
    var phi_5229_: bool;
    var phi_5230_: bool;
    var phi_5231_: bool;
    var phi_5236_: type_28;
    var phi_5237_: bool;
    var phi_5238_: bool;
    var phi_5243_: type_28;
    var phi_5244_: bool;
    var phi_5248_: type_28;
    var phi_5255_: f32;
    var phi_5256_: bool;
    var phi_5368_: f32;
    var phi_5375_: f32;
    var phi_5383_: f32;
    var phi_5534_: f32;
    var phi_5541_: f32;
    var phi_5546_: f32;
    var phi_5553_: f32;
    var phi_5558_: f32;
    var phi_5571_: f32;
    var phi_5578_: f32;
    var phi_5583_: f32;
    var phi_5590_: f32;
    var phi_5595_: f32;
    var phi_5600_: f32;
    var phi_5617_: f32;
    var phi_5624_: f32;
    var phi_5629_: f32;
    var phi_5636_: f32;
    var phi_5641_: f32;
    var phi_5655_: f32;
    var phi_5662_: f32;
    var phi_5667_: f32;
    var phi_5674_: f32;
    var phi_5679_: f32;
    var phi_5684_: f32;
    var phi_5701_: f32;
    var phi_5708_: f32;
    var phi_5713_: f32;
    var phi_5720_: f32;
    var phi_5725_: f32;
    var phi_5739_: f32;
    var phi_5746_: f32;
    var phi_5751_: f32;
    var phi_5758_: f32;
    var phi_5763_: f32;
    var phi_5768_: f32;
    var phi_5876_: type_14;
    var phi_5879_: f32;
    var phi_5900_: bool;
    var phi_5906_: type_15;
    var phi_5877_: type_14;
    var phi_5920_: type_15;
    var phi_5880_: f32;
    var local_44: f32;
    var phi_5869_: f32;
    var phi_5933_: f32;
    var phi_6067_: f32;
    var phi_6073_: f32;
    var phi_6082_: f32;
    var phi_6088_: f32;
    var phi_6097_: f32;
    var phi_6103_: f32;
    var phi_6112_: f32;
    var phi_6118_: f32;
    var phi_6168_: type_14;
    var phi_6171_: f32;
    var phi_6192_: bool;
    var phi_6198_: type_15;
    var phi_6169_: type_14;
    var phi_6212_: type_15;
    var phi_6172_: f32;
    var local_45: f32;
    var phi_6161_: f32;
    var phi_6225_: f32;
    var phi_6257_: type_14;
    var phi_6260_: f32;
    var phi_6281_: bool;
    var phi_6287_: type_15;
    var phi_6258_: type_14;
    var phi_6301_: type_15;
    var phi_6261_: f32;
    var local_46: f32;
    var phi_6250_: f32;
    var phi_6314_: f32;
    var phi_6330_: f32;
    var phi_6337_: f32;
    var phi_6342_: f32;
    var phi_6349_: f32;
    var phi_6354_: f32;
    var phi_6367_: f32;
    var phi_6374_: f32;
    var phi_6379_: f32;
    var phi_6386_: f32;
    var phi_6391_: f32;
    var phi_6396_: f32;
    var phi_6413_: f32;
    var phi_6420_: f32;
    var phi_6425_: f32;
    var phi_6432_: f32;
    var phi_6437_: f32;
    var phi_6451_: f32;
    var phi_6458_: f32;
    var phi_6463_: f32;
    var phi_6470_: f32;
    var phi_6475_: f32;
    var phi_6480_: f32;
    var phi_6497_: f32;
    var phi_6504_: f32;
    var phi_6509_: f32;
    var phi_6516_: f32;
    var phi_6521_: f32;
    var phi_6535_: f32;
    var phi_6542_: f32;
    var phi_6547_: f32;
    var phi_6554_: f32;
    var phi_6559_: f32;
    var phi_6564_: f32;
    var phi_6605_: f32;
    var phi_6611_: f32;
    var phi_6622_: type_12;
    var phi_6625_: f32;
    var phi_6623_: type_12;
    var phi_6648_: type_12;
    var phi_6677_: f32;
    var phi_6683_: f32;
    var phi_6696_: f32;
    var phi_6626_: f32;
    var local_47: f32;
    var local_48: f32;
    var phi_6724_: type_14;
    var phi_6727_: f32;
    var phi_6748_: bool;
    var phi_6754_: type_15;
    var phi_6725_: type_14;
    var phi_6768_: type_15;
    var phi_6728_: f32;
    var local_49: f32;
    var phi_6717_: f32;
    var phi_6781_: f32;
    var phi_6786_: type_12;
    var phi_6789_: f32;
    var phi_6791_: bool;
    var phi_6793_: bool;
    var phi_6787_: type_12;
    var phi_6816_: type_12;
    var phi_6853_: f32;
    var phi_6860_: f32;
    var phi_6868_: f32;
    var phi_6876_: f32;
    var phi_6883_: f32;
    var phi_6891_: f32;
    var phi_6897_: f32;
    var phi_6915_: f32;
    var phi_6921_: f32;
    var phi_6928_: f32;
    var phi_6954_: f32;
    var phi_6960_: f32;
    var phi_6996_: bool;
    var phi_7003_: bool;
    var phi_7016_: f32;
    var phi_7022_: f32;
    var phi_7023_: f32;
    var phi_7024_: f32;
    var phi_6790_: f32;
    var phi_6792_: bool;
    var phi_6794_: bool;
    var local_50: f32;
    var phi_7029_: f32;
    var local_51: bool;
    var local_52: bool;
    var phi_7038_: type_40;
    var phi_7039_: type_40;
    var phi_7040_: bool;
    var local_53: bool;
    var phi_7057_: f32;
    var phi_7058_: f32;
    var phi_7061_: type_12;
    var phi_7064_: f32;
    var phi_7066_: f32;
    var phi_7062_: type_12;
    var phi_7089_: type_12;
    var phi_7172_: f32;
    var phi_7173_: f32;
    var phi_7174_: f32;
    var phi_7157_: f32;
    var phi_7175_: f32;
    var phi_7176_: f32;
    var phi_7065_: f32;
    var phi_7067_: f32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var phi_7337_: bool;
    var phi_7338_: bool;
    var phi_7339_: bool;
    var phi_7340_: bool;
    var phi_7341_: bool;
    var phi_7342_: bool;
    var phi_7346_: bool;
    var phi_7350_: bool;
    var phi_7351_: bool;
    var phi_7352_: bool;
    var phi_7356_: f32;
    var phi_7359_: type_40;
    var phi_7360_: type_40;
    var phi_7361_: bool;
    var phi_7362_: type_40;
    var phi_7363_: type_40;
    var phi_7364_: bool;
    var phi_7369_: type_40;
    var phi_7370_: type_40;
    var phi_7371_: bool;
    var phi_7375_: type_40;
    var phi_7376_: type_40;
    var phi_7377_: bool;
    var phi_7378_: bool;
    var phi_7379_: type_40;
    var phi_7380_: type_40;
    var phi_7381_: bool;
    var phi_7382_: bool;
    var phi_7387_: type_40;
    var phi_7388_: bool;
    var phi_7392_: type_40;
    var phi_7408_: f32;
    var phi_7409_: f32;
    var phi_7410_: bool;
    var phi_7411_: f32;
    var phi_7412_: f32;
    var phi_7413_: bool;
    var phi_7414_: bool;
    var phi_7415_: bool;
    var phi_7416_: f32;
    var phi_7417_: f32;
    var phi_7418_: bool;
    var phi_7419_: bool;
    var phi_7420_: bool;
    var phi_7421_: f32;
    var phi_7422_: u32;
    var phi_7423_: f32;
    var phi_7424_: type_40;
    var phi_7425_: u32;
    var phi_7426_: u32;
    var phi_7427_: bool;
    var phi_7428_: bool;
    var phi_7429_: bool;
    var phi_7430_: f32;
    var phi_7431_: u32;
    var phi_7432_: f32;
    var phi_7433_: type_40;
    var phi_7434_: u32;
    var phi_7435_: u32;
    var phi_7436_: bool;
    var phi_7437_: bool;
    var phi_7438_: bool;
    var phi_7439_: bool;
    var phi_7440_: bool;
    var phi_7441_: f32;
    var phi_2516_: f32;
    var phi_2518_: u32;
    var phi_2520_: f32;
    var phi_7442_: type_40;
    var phi_7443_: u32;
    var phi_7444_: f32;
    var phi_7445_: u32;
    var phi_7446_: bool;
    var phi_7447_: bool;
    var phi_7448_: bool;
    var phi_7449_: bool;
    var phi_7450_: bool;
    var phi_7451_: bool;
    var local_57: bool;
    var phi_7455_: bool;
    var phi_7456_: bool;
    var phi_7457_: bool;
    var phi_7458_: bool;
    var local_58: type_40;
    var local_59: type_40;
    var phi_7475_: u32;
    var local_60: type_40;
    var phi_7480_: type_39;
    var phi_7481_: type_39;
    var phi_7482_: bool;
    var phi_7483_: bool;
    var phi_7484_: bool;
    var phi_7485_: bool;
    var phi_7489_: u32;
    var phi_7490_: f32;
    var phi_7491_: bool;
    var phi_7492_: bool;
    var phi_7493_: bool;
    var phi_7494_: bool;
    var phi_7498_: f32;
    var phi_7499_: u32;
    var phi_7500_: bool;
    var phi_7501_: bool;
    var phi_7502_: bool;
    var phi_7514_: f32;
    var phi_7517_: type_12;
    var phi_7518_: type_12;
    var phi_7541_: type_12;
    var phi_7562_: f32;
    var phi_7692_: type_14;
    var phi_7695_: f32;
    var phi_7716_: bool;
    var phi_7722_: type_15;
    var phi_7693_: type_14;
    var phi_7736_: type_15;
    var phi_7696_: f32;
    var local_61: f32;
    var phi_7685_: f32;
    var phi_7749_: f32;
    var phi_7765_: f32;
    var phi_7772_: f32;
    var phi_7777_: f32;
    var phi_7784_: f32;
    var phi_7789_: f32;
    var phi_7802_: f32;
    var phi_7809_: f32;
    var phi_7814_: f32;
    var phi_7821_: f32;
    var phi_7826_: f32;
    var phi_7831_: f32;
    var phi_7848_: f32;
    var phi_7855_: f32;
    var phi_7860_: f32;
    var phi_7867_: f32;
    var phi_7872_: f32;
    var phi_7886_: f32;
    var phi_7893_: f32;
    var phi_7898_: f32;
    var phi_7905_: f32;
    var phi_7910_: f32;
    var phi_7915_: f32;
    var phi_7932_: f32;
    var phi_7939_: f32;
    var phi_7944_: f32;
    var phi_7951_: f32;
    var phi_7956_: f32;
    var phi_7970_: f32;
    var phi_7977_: f32;
    var phi_7982_: f32;
    var phi_7989_: f32;
    var phi_7994_: f32;
    var phi_7999_: f32;
    var phi_8019_: bool;
    var phi_8020_: bool;
    var phi_8021_: bool;
    var local_62: bool;
    var phi_8029_: u32;
    var phi_8033_: type_39;
    var phi_8034_: bool;
    var phi_8042_: u32;
    var phi_8046_: type_39;
    var phi_8047_: type_39;
    var phi_8048_: bool;
    var phi_8049_: bool;
    var phi_8056_: type_39;
    var phi_8057_: bool;
    var phi_8061_: type_39;
    var phi_8062_: type_39;
    var phi_8063_: bool;
    var phi_8067_: type_39;
    var phi_15582_: type_39;
    var phi_15597_: type_42;
    var phi_15619_: array<u32, 2>;
    var phi_15620_: array<u32, 2>;
    var phi_15621_: bool;
    var phi_15625_: array<u32, 2>;
    var phi_15652_: array<u32, 2>;
    var phi_15653_: array<u32, 2>;
    var phi_15654_: bool;
    var phi_15658_: array<u32, 2>;
    var phi_15661_: bool;
    var phi_15676_: bool;
    var phi_15677_: bool;
    var phi_15685_: bool;
    var phi_15686_: bool;
    var phi_15691_: u32;
    var phi_15699_: bool;
    var phi_15720_: u32;
    var phi_15724_: type_20;
    var phi_15725_: bool;
    var phi_15726_: bool;
    var phi_15745_: u32;
    var phi_15812_: u32;
    var local_63: u32;
    var local_64: f32;
    var local_65: f32;
    var local_66: bool;
    var local_67: bool;
    var local_68: f32;
    var local_69: bool;
    var local_70: bool;
    var local_71: bool;
    var local_72: bool;
    var local_73: bool;
    var local_74: f32;
    var local_75: f32;
    var local_76: bool;
    var local_77: bool;
    var local_78: bool;
    var local_79: bool;
    var local_80: bool;
    var local_81: bool;
    var local_82: bool;
    var local_83: bool;
    var local_84: f32;
    var local_85: f32;
    var local_86: f32;
    var local_87: f32;
    var local_88: bool;
    var local_89: bool;
    var local_90: bool;
    var local_91: bool;
    var local_92: bool;
    var local_93: u32;
    var local_94: bool;
    var local_95: u32;
    var local_96: u32;
    var local_97: f32;
    var local_98: f32;
    var local_99: f32;
    var local_100: u32;
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
        phi_805_ = _e141;
    } else {
        phi_805_ = _e143;
    }
    let _e146 = phi_805_;
    let _e147 = (_e146 / 64u);
    if ((_e146 % 64u) > 0u) {
        phi_821_ = (_e147 + 1u);
    } else {
        phi_821_ = _e147;
    }
    let _e152 = phi_821_;
    if (_e152 > _e135) {
        let _e154 = (_e152 - _e135);
        if (_e138 == 0u) {
            return;
        }
        let _e156 = (_e154 / _e138);
        if (_e138 == 0u) {
            return;
        }
        if ((_e154 % _e138) > 0u) {
            phi_842_ = (_e156 + 1u);
        } else {
            phi_842_ = _e156;
        }
        let _e162 = phi_842_;
        phi_843_ = _e162;
    } else {
        phi_843_ = 0u;
    }
    let _e164 = phi_843_;
    phi_846_ = type_12(0u, _e164);
    loop {
        let _e167 = phi_846_;
        if (_e167.member < _e167.member_1) {
            phi_847_ = type_12((_e167.member + 1u), _e167.member_1);
            phi_870_ = type_12(1u, _e167.member);
        } else {
            phi_847_ = _e167;
            phi_870_ = type_12(0u, type_12().member_1);
        }
        let _e179 = phi_847_;
        let _e181 = phi_870_;
        let _e185 = (bitcast<i32>(_e181.member) != 0i);
        if _e185 {
            let _e189 = (((_e135 + (_e181.member_1 * _e138)) * 64u) + _e123);
            if (_e189 < _e146) {
                let _e191 = (2u * _e189);
                let _e194 = input.member[(4u + _e191)];
                let _e197 = input.member[(_e191 + 5u)];
                let _e200 = elements.member[_e197];
                let _e205 = paths.member[_e194];
                let _e207 = paths.member[_e200[0]];
                let _e213 = paths.member[_e200[1]];
                let _e215 = paths.member[_e200[2]];
                let _e245 = params.member.member.member_4;
                let _e246 = (_e205.member[0] - _e207.member[0]);
                let _e247 = (_e205.member[1] - _e207.member[1]);
                let _e248 = (_e205.member[2] - _e207.member[2]);
                let _e250 = (_e205.member_1[0] - _e207.member_1[0]);
                let _e251 = (_e205.member_1[1] - _e207.member_1[1]);
                let _e252 = (_e205.member_1[2] - _e207.member_1[2]);
                let _e255 = (_e213.member[0] - _e207.member[0]);
                let _e256 = (_e213.member[1] - _e207.member[1]);
                let _e257 = (_e213.member[2] - _e207.member[2]);
                let _e259 = (_e213.member_1[0] - _e207.member_1[0]);
                let _e260 = (_e213.member_1[1] - _e207.member_1[1]);
                let _e261 = (_e213.member_1[2] - _e207.member_1[2]);
                let _e264 = (_e215.member[0] - _e207.member[0]);
                let _e265 = (_e215.member[1] - _e207.member[1]);
                let _e266 = (_e215.member[2] - _e207.member[2]);
                let _e268 = (_e215.member_1[0] - _e207.member_1[0]);
                let _e269 = (_e215.member_1[1] - _e207.member_1[1]);
                let _e270 = (_e215.member_1[2] - _e207.member_1[2]);
                let _e273 = (_e245 + _e245);
                let _e276 = params.member.member.member_12;
                let _e277 = bitcast<u32>(_e276);
                if (_e277 < 8388608u) {
                    phi_1048_ = array<u32, 2>();
                    phi_1049_ = true;
                } else {
                    let _e281 = ((_e277 >> bitcast<u32>(31i)) == 1u);
                    if _e281 {
                        phi_1047_ = array<u32, 2>();
                    } else {
                        phi_1047_ = array<u32, 2>((_e277 << bitcast<u32>(29i)), ((((_e277 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e277 & 8388607u) >> bitcast<u32>(3i))));
                    }
                    let _e295 = phi_1047_;
                    phi_1048_ = _e295;
                    phi_1049_ = _e281;
                }
                let _e297 = phi_1048_;
                let _e299 = phi_1049_;
                if _e299 {
                    phi_1053_ = array<u32, 2>(0u, 0u);
                } else {
                    phi_1053_ = _e297;
                }
                let _e301 = phi_1053_;
                let _e305 = params.member.member.member_15[0u];
                if (_e301[0] == _e305) {
                    let _e310 = params.member.member.member_15[1u];
                    phi_1067_ = (_e301[1] == _e310);
                } else {
                    phi_1067_ = false;
                }
                let _e313 = phi_1067_;
                let _e315 = params.member.member.member_5;
                let _e317 = params.member.member.member_11;
                let _e319 = params.member.member.member_12;
                let _e321 = params.member.member.member_13;
                let _e323 = params.member.member.member_1;
                if ((_e323 & 64u) != 0u) {
                    phi_1083_ = _e313;
                } else {
                    phi_1083_ = false;
                }
                let _e327 = phi_1083_;
                if (_e246 < 0f) {
                    phi_1089_ = -(_e246);
                } else {
                    phi_1089_ = _e246;
                }
                let _e331 = phi_1089_;
                if (_e247 < 0f) {
                    phi_1095_ = -(_e247);
                } else {
                    phi_1095_ = _e247;
                }
                let _e335 = phi_1095_;
                if (_e331 > _e335) {
                    phi_1100_ = _e331;
                } else {
                    phi_1100_ = _e335;
                }
                let _e338 = phi_1100_;
                if (_e248 < 0f) {
                    phi_1106_ = -(_e248);
                } else {
                    phi_1106_ = _e248;
                }
                let _e342 = phi_1106_;
                if (_e338 > _e342) {
                    phi_1111_ = _e338;
                } else {
                    phi_1111_ = _e342;
                }
                let _e345 = phi_1111_;
                if (_e250 < 0f) {
                    phi_1117_ = -(_e250);
                } else {
                    phi_1117_ = _e250;
                }
                let _e349 = phi_1117_;
                if (_e251 < 0f) {
                    phi_1123_ = -(_e251);
                } else {
                    phi_1123_ = _e251;
                }
                let _e353 = phi_1123_;
                if (_e349 > _e353) {
                    phi_1128_ = _e349;
                } else {
                    phi_1128_ = _e353;
                }
                let _e356 = phi_1128_;
                if (_e252 < 0f) {
                    phi_1134_ = -(_e252);
                } else {
                    phi_1134_ = _e252;
                }
                let _e360 = phi_1134_;
                if (_e356 > _e360) {
                    phi_1139_ = _e356;
                } else {
                    phi_1139_ = _e360;
                }
                let _e363 = phi_1139_;
                if (_e345 > _e363) {
                    phi_1144_ = _e345;
                } else {
                    phi_1144_ = _e363;
                }
                let _e366 = phi_1144_;
                let _e367 = (_e366 + _e273);
                if (_e255 < 0f) {
                    phi_1151_ = -(_e255);
                } else {
                    phi_1151_ = _e255;
                }
                let _e371 = phi_1151_;
                if (_e256 < 0f) {
                    phi_1157_ = -(_e256);
                } else {
                    phi_1157_ = _e256;
                }
                let _e375 = phi_1157_;
                if (_e371 > _e375) {
                    phi_1162_ = _e371;
                } else {
                    phi_1162_ = _e375;
                }
                let _e378 = phi_1162_;
                if (_e257 < 0f) {
                    phi_1168_ = -(_e257);
                } else {
                    phi_1168_ = _e257;
                }
                let _e382 = phi_1168_;
                if (_e378 > _e382) {
                    phi_1173_ = _e378;
                } else {
                    phi_1173_ = _e382;
                }
                let _e385 = phi_1173_;
                if (_e259 < 0f) {
                    phi_1179_ = -(_e259);
                } else {
                    phi_1179_ = _e259;
                }
                let _e389 = phi_1179_;
                if (_e260 < 0f) {
                    phi_1185_ = -(_e260);
                } else {
                    phi_1185_ = _e260;
                }
                let _e393 = phi_1185_;
                if (_e389 > _e393) {
                    phi_1190_ = _e389;
                } else {
                    phi_1190_ = _e393;
                }
                let _e396 = phi_1190_;
                if (_e261 < 0f) {
                    phi_1196_ = -(_e261);
                } else {
                    phi_1196_ = _e261;
                }
                let _e400 = phi_1196_;
                if (_e396 > _e400) {
                    phi_1201_ = _e396;
                } else {
                    phi_1201_ = _e400;
                }
                let _e403 = phi_1201_;
                if (_e385 > _e403) {
                    phi_1206_ = _e385;
                } else {
                    phi_1206_ = _e403;
                }
                let _e406 = phi_1206_;
                let _e407 = (_e406 + _e273);
                if (_e264 < 0f) {
                    phi_1213_ = -(_e264);
                } else {
                    phi_1213_ = _e264;
                }
                let _e411 = phi_1213_;
                if (_e265 < 0f) {
                    phi_1219_ = -(_e265);
                } else {
                    phi_1219_ = _e265;
                }
                let _e415 = phi_1219_;
                if (_e411 > _e415) {
                    phi_1224_ = _e411;
                } else {
                    phi_1224_ = _e415;
                }
                let _e418 = phi_1224_;
                if (_e266 < 0f) {
                    phi_1230_ = -(_e266);
                } else {
                    phi_1230_ = _e266;
                }
                let _e422 = phi_1230_;
                if (_e418 > _e422) {
                    phi_1235_ = _e418;
                } else {
                    phi_1235_ = _e422;
                }
                let _e425 = phi_1235_;
                if (_e268 < 0f) {
                    phi_1241_ = -(_e268);
                } else {
                    phi_1241_ = _e268;
                }
                let _e429 = phi_1241_;
                if (_e269 < 0f) {
                    phi_1247_ = -(_e269);
                } else {
                    phi_1247_ = _e269;
                }
                let _e433 = phi_1247_;
                if (_e429 > _e433) {
                    phi_1252_ = _e429;
                } else {
                    phi_1252_ = _e433;
                }
                let _e436 = phi_1252_;
                if (_e270 < 0f) {
                    phi_1258_ = -(_e270);
                } else {
                    phi_1258_ = _e270;
                }
                let _e440 = phi_1258_;
                if (_e436 > _e440) {
                    phi_1263_ = _e436;
                } else {
                    phi_1263_ = _e440;
                }
                let _e443 = phi_1263_;
                if (_e425 > _e443) {
                    phi_1268_ = _e425;
                } else {
                    phi_1268_ = _e443;
                }
                let _e446 = phi_1268_;
                let _e447 = (_e446 + _e273);
                if (_e367 > _e407) {
                    phi_1274_ = _e367;
                } else {
                    phi_1274_ = _e407;
                }
                let _e450 = phi_1274_;
                if (_e450 > _e447) {
                    phi_1279_ = _e450;
                } else {
                    phi_1279_ = _e447;
                }
                let _e453 = phi_1279_;
                if (_e453 <= 65536f) {
                    phi_1286_ = (_e453 >= (1f / 65536f));
                } else {
                    phi_1286_ = false;
                }
                let _e458 = phi_1286_;
                if _e458 {
                    phi_1357_ = type_38();
                    phi_1358_ = true;
                } else {
                    if (_e453 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e453) & 2139095040u) != 2139095040u) {
                            let _e465 = (2130706432u - (bitcast<u32>(_e453) & 2139095040u));
                            if (_e465 > 8388608u) {
                                phi_1310_ = _e465;
                            } else {
                                phi_1310_ = 8388608u;
                            }
                            let _e468 = phi_1310_;
                            let _e469 = bitcast<f32>(_e468);
                            let _e470 = (_e315 * _e469);
                            if (_e315 > 0f) {
                                if (_e470 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_1321_ = _e470;
                                } else {
                                    phi_1321_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e474 = phi_1321_;
                                phi_1322_ = _e474;
                            } else {
                                phi_1322_ = _e470;
                            }
                            let _e476 = phi_1322_;
                            phi_1353_ = type_38(type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e246 * _e469), (_e247 * _e469), (_e248 * _e469)), array<f32, 3>((_e250 * _e469), (_e251 * _e469), (_e252 * _e469))), array<array<f32, 3>, 2>(array<f32, 3>((_e255 * _e469), (_e256 * _e469), (_e257 * _e469)), array<f32, 3>((_e259 * _e469), (_e260 * _e469), (_e261 * _e469))), array<array<f32, 3>, 2>(array<f32, 3>((_e264 * _e469), (_e265 * _e469), (_e266 * _e469)), array<f32, 3>((_e268 * _e469), (_e269 * _e469), (_e270 * _e469))), (_e273 * _e469)), _e476);
                            phi_1354_ = false;
                        } else {
                            phi_1353_ = type_38();
                            phi_1354_ = true;
                        }
                        let _e508 = phi_1353_;
                        let _e510 = phi_1354_;
                        phi_1355_ = _e508;
                        phi_1356_ = _e510;
                    } else {
                        phi_1355_ = type_38();
                        phi_1356_ = true;
                    }
                    let _e512 = phi_1355_;
                    let _e514 = phi_1356_;
                    phi_1357_ = _e512;
                    phi_1358_ = _e514;
                }
                let _e516 = phi_1357_;
                let _e518 = phi_1358_;
                if _e518 {
                    phi_1363_ = type_38(type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e246, _e247, _e248), array<f32, 3>(_e250, _e251, _e252)), array<array<f32, 3>, 2>(array<f32, 3>(_e255, _e256, _e257), array<f32, 3>(_e259, _e260, _e261)), array<array<f32, 3>, 2>(array<f32, 3>(_e264, _e265, _e266), array<f32, 3>(_e268, _e269, _e270)), _e273), _e315);
                } else {
                    phi_1363_ = _e516;
                }
                let _e521 = phi_1363_;
                local_18 = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e521.member.member[0][0], _e521.member.member[0][1], _e521.member.member[0][2]), array<f32, 3>(_e521.member.member[1][0], _e521.member.member[1][1], _e521.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e521.member.member_1[0][0], _e521.member.member_1[0][1], _e521.member.member_1[0][2]), array<f32, 3>(_e521.member.member_1[1][0], _e521.member.member_1[1][1], _e521.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e521.member.member_2[0][0], _e521.member.member_2[0][1], _e521.member.member_2[0][2]), array<f32, 3>(_e521.member.member_2[1][0], _e521.member.member_2[1][1], _e521.member.member_2[1][2])), _e521.member.member_3);
                if (_e521.member_1 > 0f) {
                    let _e5193 = local_18.member[0u];
                    let _e5199 = local_18.member[1u];
                    let _e5215 = local_18.member_1[0u];
                    let _e5221 = local_18.member_1[1u];
                    let _e5237 = local_18.member_2[0u];
                    let _e5243 = local_18.member_2[1u];
                    let _e5257 = function_2(array<f32, 3>((_e5193[0] + ((_e5199[0] - _e5193[0]) * _e319)), (_e5193[1] + ((_e5199[1] - _e5193[1]) * _e319)), (_e5193[2] + ((_e5199[2] - _e5193[2]) * _e319))), array<f32, 3>((_e5215[0] + ((_e5221[0] - _e5215[0]) * _e319)), (_e5215[1] + ((_e5221[1] - _e5215[1]) * _e319)), (_e5215[2] + ((_e5221[2] - _e5215[2]) * _e319))), array<f32, 3>((_e5237[0] + ((_e5243[0] - _e5237[0]) * _e319)), (_e5237[1] + ((_e5243[1] - _e5237[1]) * _e319)), (_e5237[2] + ((_e5243[2] - _e5237[2]) * _e319))), 0u);
                    let _e5268 = (((_e5257[0] * _e5257[0]) + (_e5257[1] * _e5257[1])) + (_e5257[2] * _e5257[2]));
                    if (_e5268 <= 0.000000000000000000000000000000000000011754944f) {
                        if (_e5268 > 0f) {
                            phi_1530_ = (0.000000000000000000106433627f * 2f);
                        } else {
                            phi_1530_ = 0f;
                        }
                        let _e5321 = phi_1530_;
                        phi_1594_ = _e5321;
                    } else {
                        phi_1537_ = type_14(0i, 5i);
                        phi_1540_ = bitcast<f32>(((bitcast<u32>(_e5268) >> bitcast<u32>(1i)) + 532369198u));
                        loop {
                            let _e5276 = phi_1537_;
                            let _e5278 = phi_1540_;
                            local_39 = _e5278;
                            if (_e5276.member < _e5276.member_1) {
                                let _e5285 = (_e5276.member + 1i);
                                if ((false == (_e5285 > _e5276.member)) != false) {
                                    phi_1561_ = true;
                                } else {
                                    phi_1561_ = false;
                                }
                                let _e5290 = phi_1561_;
                                if _e5290 {
                                    phi_1567_ = type_15(0u, type_15().member_1);
                                } else {
                                    phi_1567_ = type_15(1u, _e5285);
                                }
                                let _e5295 = phi_1567_;
                                phi_1538_ = type_14(_e5295.member_1, _e5276.member_1);
                                phi_1581_ = type_15(1u, _e5276.member);
                            } else {
                                phi_1538_ = _e5276;
                                phi_1581_ = type_15(0u, type_15().member_1);
                            }
                            let _e5301 = phi_1538_;
                            let _e5303 = phi_1581_;
                            let _e5306 = (bitcast<i32>(_e5303.member) != 0i);
                            if _e5306 {
                                phi_1541_ = (0.5f * (_e5278 + (_e5268 / _e5278)));
                            } else {
                                phi_1541_ = f32();
                            }
                            let _e5311 = phi_1541_;
                            continue;
                            continuing {
                                phi_1537_ = _e5301;
                                phi_1540_ = _e5311;
                                break if !(_e5306);
                            }
                        }
                        let _e5316 = local_39;
                        phi_1594_ = (_e5316 * (1f + (8f * 0.000000059604645f)));
                    }
                    let _e5323 = phi_1594_;
                    let _e5329 = local_18.member[0u];
                    if (_e5329[0] < 0f) {
                        phi_1610_ = -(_e5329[0]);
                    } else {
                        phi_1610_ = _e5329[0];
                    }
                    let _e5336 = phi_1610_;
                    if (_e5329[1] < 0f) {
                        phi_1617_ = -(_e5329[1]);
                    } else {
                        phi_1617_ = _e5329[1];
                    }
                    let _e5340 = phi_1617_;
                    if (_e5336 > _e5340) {
                        phi_1622_ = _e5336;
                    } else {
                        phi_1622_ = _e5340;
                    }
                    let _e5343 = phi_1622_;
                    if (_e5329[2] < 0f) {
                        phi_1629_ = -(_e5329[2]);
                    } else {
                        phi_1629_ = _e5329[2];
                    }
                    let _e5347 = phi_1629_;
                    if (_e5343 > _e5347) {
                        phi_1634_ = _e5343;
                    } else {
                        phi_1634_ = _e5347;
                    }
                    let _e5350 = phi_1634_;
                    let _e5353 = local_18.member[1u];
                    if (_e5353[0] < 0f) {
                        phi_1647_ = -(_e5353[0]);
                    } else {
                        phi_1647_ = _e5353[0];
                    }
                    let _e5360 = phi_1647_;
                    if (_e5353[1] < 0f) {
                        phi_1654_ = -(_e5353[1]);
                    } else {
                        phi_1654_ = _e5353[1];
                    }
                    let _e5364 = phi_1654_;
                    if (_e5360 > _e5364) {
                        phi_1659_ = _e5360;
                    } else {
                        phi_1659_ = _e5364;
                    }
                    let _e5367 = phi_1659_;
                    if (_e5353[2] < 0f) {
                        phi_1666_ = -(_e5353[2]);
                    } else {
                        phi_1666_ = _e5353[2];
                    }
                    let _e5371 = phi_1666_;
                    if (_e5367 > _e5371) {
                        phi_1671_ = _e5367;
                    } else {
                        phi_1671_ = _e5371;
                    }
                    let _e5374 = phi_1671_;
                    if (_e5350 > _e5374) {
                        phi_1676_ = _e5350;
                    } else {
                        phi_1676_ = _e5374;
                    }
                    let _e5377 = phi_1676_;
                    let _e5379 = local_18.member_3;
                    let _e5383 = local_18.member_1[0u];
                    if (_e5383[0] < 0f) {
                        phi_1693_ = -(_e5383[0]);
                    } else {
                        phi_1693_ = _e5383[0];
                    }
                    let _e5390 = phi_1693_;
                    if (_e5383[1] < 0f) {
                        phi_1700_ = -(_e5383[1]);
                    } else {
                        phi_1700_ = _e5383[1];
                    }
                    let _e5394 = phi_1700_;
                    if (_e5390 > _e5394) {
                        phi_1705_ = _e5390;
                    } else {
                        phi_1705_ = _e5394;
                    }
                    let _e5397 = phi_1705_;
                    if (_e5383[2] < 0f) {
                        phi_1712_ = -(_e5383[2]);
                    } else {
                        phi_1712_ = _e5383[2];
                    }
                    let _e5401 = phi_1712_;
                    if (_e5397 > _e5401) {
                        phi_1717_ = _e5397;
                    } else {
                        phi_1717_ = _e5401;
                    }
                    let _e5404 = phi_1717_;
                    let _e5407 = local_18.member_1[1u];
                    if (_e5407[0] < 0f) {
                        phi_1731_ = -(_e5407[0]);
                    } else {
                        phi_1731_ = _e5407[0];
                    }
                    let _e5414 = phi_1731_;
                    if (_e5407[1] < 0f) {
                        phi_1738_ = -(_e5407[1]);
                    } else {
                        phi_1738_ = _e5407[1];
                    }
                    let _e5418 = phi_1738_;
                    if (_e5414 > _e5418) {
                        phi_1743_ = _e5414;
                    } else {
                        phi_1743_ = _e5418;
                    }
                    let _e5421 = phi_1743_;
                    if (_e5407[2] < 0f) {
                        phi_1750_ = -(_e5407[2]);
                    } else {
                        phi_1750_ = _e5407[2];
                    }
                    let _e5425 = phi_1750_;
                    if (_e5421 > _e5425) {
                        phi_1755_ = _e5421;
                    } else {
                        phi_1755_ = _e5425;
                    }
                    let _e5428 = phi_1755_;
                    if (_e5404 > _e5428) {
                        phi_1760_ = _e5404;
                    } else {
                        phi_1760_ = _e5428;
                    }
                    let _e5431 = phi_1760_;
                    let _e5433 = local_18.member_3;
                    let _e5437 = local_18.member_2[0u];
                    if (_e5437[0] < 0f) {
                        phi_1777_ = -(_e5437[0]);
                    } else {
                        phi_1777_ = _e5437[0];
                    }
                    let _e5444 = phi_1777_;
                    if (_e5437[1] < 0f) {
                        phi_1784_ = -(_e5437[1]);
                    } else {
                        phi_1784_ = _e5437[1];
                    }
                    let _e5448 = phi_1784_;
                    if (_e5444 > _e5448) {
                        phi_1789_ = _e5444;
                    } else {
                        phi_1789_ = _e5448;
                    }
                    let _e5451 = phi_1789_;
                    if (_e5437[2] < 0f) {
                        phi_1796_ = -(_e5437[2]);
                    } else {
                        phi_1796_ = _e5437[2];
                    }
                    let _e5455 = phi_1796_;
                    if (_e5451 > _e5455) {
                        phi_1801_ = _e5451;
                    } else {
                        phi_1801_ = _e5455;
                    }
                    let _e5458 = phi_1801_;
                    let _e5461 = local_18.member_2[1u];
                    if (_e5461[0] < 0f) {
                        phi_1815_ = -(_e5461[0]);
                    } else {
                        phi_1815_ = _e5461[0];
                    }
                    let _e5468 = phi_1815_;
                    if (_e5461[1] < 0f) {
                        phi_1822_ = -(_e5461[1]);
                    } else {
                        phi_1822_ = _e5461[1];
                    }
                    let _e5472 = phi_1822_;
                    if (_e5468 > _e5472) {
                        phi_1827_ = _e5468;
                    } else {
                        phi_1827_ = _e5472;
                    }
                    let _e5475 = phi_1827_;
                    if (_e5461[2] < 0f) {
                        phi_1834_ = -(_e5461[2]);
                    } else {
                        phi_1834_ = _e5461[2];
                    }
                    let _e5479 = phi_1834_;
                    if (_e5475 > _e5479) {
                        phi_1839_ = _e5475;
                    } else {
                        phi_1839_ = _e5479;
                    }
                    let _e5482 = phi_1839_;
                    if (_e5458 > _e5482) {
                        phi_1844_ = _e5458;
                    } else {
                        phi_1844_ = _e5482;
                    }
                    let _e5485 = phi_1844_;
                    let _e5487 = local_18.member_3;
                    let _e5494 = local_18.member_3;
                    let _e5501 = (((_e5323 * (1f + (0.000000059604645f * 8f))) + (((((((_e5377 + _e5379) + (_e5431 + _e5433)) + (_e5485 + _e5487)) * (0.000000059604645f * 16f)) + (_e5494 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e521.member_1);
                    if _e5501 {
                        phi_2505_ = type_39();
                        phi_2506_ = true;
                    } else {
                        let _e5504 = local_18.member_1[0u];
                        let _e5510 = local_18.member_2[0u];
                        let _e5516 = ((_e5504[1] * _e5510[2]) - (_e5504[2] * _e5510[1]));
                        let _e5519 = ((_e5504[2] * _e5510[0]) - (_e5504[0] * _e5510[2]));
                        let _e5522 = ((_e5504[0] * _e5510[1]) - (_e5504[1] * _e5510[0]));
                        let _e5525 = local_18.member_1[1u];
                        let _e5531 = local_18.member_2[1u];
                        let _e5537 = ((_e5525[1] * _e5531[2]) - (_e5525[2] * _e5531[1]));
                        let _e5540 = ((_e5525[2] * _e5531[0]) - (_e5525[0] * _e5531[2]));
                        let _e5543 = ((_e5525[0] * _e5531[1]) - (_e5525[1] * _e5531[0]));
                        let _e5546 = local_18.member_1[0u];
                        let _e5552 = local_18.member_2[1u];
                        let _e5567 = local_18.member_1[1u];
                        let _e5573 = local_18.member_2[0u];
                        let _e5586 = (((_e5546[1] * _e5552[2]) - (_e5546[2] * _e5552[1])) + ((_e5567[1] * _e5573[2]) - (_e5567[2] * _e5573[1])));
                        let _e5587 = (((_e5546[2] * _e5552[0]) - (_e5546[0] * _e5552[2])) + ((_e5567[2] * _e5573[0]) - (_e5567[0] * _e5573[2])));
                        let _e5588 = (((_e5546[0] * _e5552[1]) - (_e5546[1] * _e5552[0])) + ((_e5567[0] * _e5573[1]) - (_e5567[1] * _e5573[0])));
                        let _e5591 = local_18.member[0u];
                        let _e5602 = local_18.member[1u];
                        let _e5613 = local_18.member[0u];
                        let _e5622 = ((((_e5602[0] * _e5516) + (_e5602[1] * _e5519)) + (_e5602[2] * _e5522)) + (((_e5613[0] * _e5586) + (_e5613[1] * _e5587)) + (_e5613[2] * _e5588)));
                        let _e5625 = local_18.member[0u];
                        let _e5636 = local_18.member[1u];
                        let _e5645 = ((((_e5625[0] * _e5537) + (_e5625[1] * _e5540)) + (_e5625[2] * _e5543)) + (((_e5636[0] * _e5586) + (_e5636[1] * _e5587)) + (_e5636[2] * _e5588)));
                        let _e5648 = local_18.member[1u];
                        let _e5659 = local_18.member[0u];
                        if (_e5659[0] < 0f) {
                            phi_2105_ = -(_e5659[0]);
                        } else {
                            phi_2105_ = _e5659[0];
                        }
                        let _e5666 = phi_2105_;
                        if (_e5659[1] < 0f) {
                            phi_2112_ = -(_e5659[1]);
                        } else {
                            phi_2112_ = _e5659[1];
                        }
                        let _e5670 = phi_2112_;
                        if (_e5666 > _e5670) {
                            phi_2117_ = _e5666;
                        } else {
                            phi_2117_ = _e5670;
                        }
                        let _e5673 = phi_2117_;
                        if (_e5659[2] < 0f) {
                            phi_2124_ = -(_e5659[2]);
                        } else {
                            phi_2124_ = _e5659[2];
                        }
                        let _e5677 = phi_2124_;
                        if (_e5673 > _e5677) {
                            phi_2129_ = _e5673;
                        } else {
                            phi_2129_ = _e5677;
                        }
                        let _e5680 = phi_2129_;
                        let _e5683 = local_18.member[1u];
                        if (_e5683[0] < 0f) {
                            phi_2142_ = -(_e5683[0]);
                        } else {
                            phi_2142_ = _e5683[0];
                        }
                        let _e5690 = phi_2142_;
                        if (_e5683[1] < 0f) {
                            phi_2149_ = -(_e5683[1]);
                        } else {
                            phi_2149_ = _e5683[1];
                        }
                        let _e5694 = phi_2149_;
                        if (_e5690 > _e5694) {
                            phi_2154_ = _e5690;
                        } else {
                            phi_2154_ = _e5694;
                        }
                        let _e5697 = phi_2154_;
                        if (_e5683[2] < 0f) {
                            phi_2161_ = -(_e5683[2]);
                        } else {
                            phi_2161_ = _e5683[2];
                        }
                        let _e5701 = phi_2161_;
                        if (_e5697 > _e5701) {
                            phi_2166_ = _e5697;
                        } else {
                            phi_2166_ = _e5701;
                        }
                        let _e5704 = phi_2166_;
                        if (_e5680 > _e5704) {
                            phi_2171_ = _e5680;
                        } else {
                            phi_2171_ = _e5704;
                        }
                        let _e5707 = phi_2171_;
                        let _e5709 = local_18.member_3;
                        let _e5710 = (_e5707 + _e5709);
                        let _e5713 = local_18.member_1[0u];
                        if (_e5713[0] < 0f) {
                            phi_2188_ = -(_e5713[0]);
                        } else {
                            phi_2188_ = _e5713[0];
                        }
                        let _e5720 = phi_2188_;
                        if (_e5713[1] < 0f) {
                            phi_2195_ = -(_e5713[1]);
                        } else {
                            phi_2195_ = _e5713[1];
                        }
                        let _e5724 = phi_2195_;
                        if (_e5720 > _e5724) {
                            phi_2200_ = _e5720;
                        } else {
                            phi_2200_ = _e5724;
                        }
                        let _e5727 = phi_2200_;
                        if (_e5713[2] < 0f) {
                            phi_2207_ = -(_e5713[2]);
                        } else {
                            phi_2207_ = _e5713[2];
                        }
                        let _e5731 = phi_2207_;
                        if (_e5727 > _e5731) {
                            phi_2212_ = _e5727;
                        } else {
                            phi_2212_ = _e5731;
                        }
                        let _e5734 = phi_2212_;
                        let _e5737 = local_18.member_1[1u];
                        if (_e5737[0] < 0f) {
                            phi_2226_ = -(_e5737[0]);
                        } else {
                            phi_2226_ = _e5737[0];
                        }
                        let _e5744 = phi_2226_;
                        if (_e5737[1] < 0f) {
                            phi_2233_ = -(_e5737[1]);
                        } else {
                            phi_2233_ = _e5737[1];
                        }
                        let _e5748 = phi_2233_;
                        if (_e5744 > _e5748) {
                            phi_2238_ = _e5744;
                        } else {
                            phi_2238_ = _e5748;
                        }
                        let _e5751 = phi_2238_;
                        if (_e5737[2] < 0f) {
                            phi_2245_ = -(_e5737[2]);
                        } else {
                            phi_2245_ = _e5737[2];
                        }
                        let _e5755 = phi_2245_;
                        if (_e5751 > _e5755) {
                            phi_2250_ = _e5751;
                        } else {
                            phi_2250_ = _e5755;
                        }
                        let _e5758 = phi_2250_;
                        if (_e5734 > _e5758) {
                            phi_2255_ = _e5734;
                        } else {
                            phi_2255_ = _e5758;
                        }
                        let _e5761 = phi_2255_;
                        let _e5763 = local_18.member_3;
                        let _e5764 = (_e5761 + _e5763);
                        let _e5767 = local_18.member_2[0u];
                        if (_e5767[0] < 0f) {
                            phi_2272_ = -(_e5767[0]);
                        } else {
                            phi_2272_ = _e5767[0];
                        }
                        let _e5774 = phi_2272_;
                        if (_e5767[1] < 0f) {
                            phi_2279_ = -(_e5767[1]);
                        } else {
                            phi_2279_ = _e5767[1];
                        }
                        let _e5778 = phi_2279_;
                        if (_e5774 > _e5778) {
                            phi_2284_ = _e5774;
                        } else {
                            phi_2284_ = _e5778;
                        }
                        let _e5781 = phi_2284_;
                        if (_e5767[2] < 0f) {
                            phi_2291_ = -(_e5767[2]);
                        } else {
                            phi_2291_ = _e5767[2];
                        }
                        let _e5785 = phi_2291_;
                        if (_e5781 > _e5785) {
                            phi_2296_ = _e5781;
                        } else {
                            phi_2296_ = _e5785;
                        }
                        let _e5788 = phi_2296_;
                        let _e5791 = local_18.member_2[1u];
                        if (_e5791[0] < 0f) {
                            phi_2310_ = -(_e5791[0]);
                        } else {
                            phi_2310_ = _e5791[0];
                        }
                        let _e5798 = phi_2310_;
                        if (_e5791[1] < 0f) {
                            phi_2317_ = -(_e5791[1]);
                        } else {
                            phi_2317_ = _e5791[1];
                        }
                        let _e5802 = phi_2317_;
                        if (_e5798 > _e5802) {
                            phi_2322_ = _e5798;
                        } else {
                            phi_2322_ = _e5802;
                        }
                        let _e5805 = phi_2322_;
                        if (_e5791[2] < 0f) {
                            phi_2329_ = -(_e5791[2]);
                        } else {
                            phi_2329_ = _e5791[2];
                        }
                        let _e5809 = phi_2329_;
                        if (_e5805 > _e5809) {
                            phi_2334_ = _e5805;
                        } else {
                            phi_2334_ = _e5809;
                        }
                        let _e5812 = phi_2334_;
                        if (_e5788 > _e5812) {
                            phi_2339_ = _e5788;
                        } else {
                            phi_2339_ = _e5812;
                        }
                        let _e5815 = phi_2339_;
                        let _e5817 = local_18.member_3;
                        let _e5818 = (_e5815 + _e5817);
                        let _e5820 = ((_e5764 * 8f) * _e5818);
                        let _e5827 = local_18.member_3;
                        if (_e5516 < 0f) {
                            phi_2370_ = -(_e5516);
                        } else {
                            phi_2370_ = _e5516;
                        }
                        let _e5844 = phi_2370_;
                        if (_e5519 < 0f) {
                            phi_2376_ = -(_e5519);
                        } else {
                            phi_2376_ = _e5519;
                        }
                        let _e5848 = phi_2376_;
                        if (_e5522 < 0f) {
                            phi_2383_ = -(_e5522);
                        } else {
                            phi_2383_ = _e5522;
                        }
                        let _e5853 = phi_2383_;
                        let _e5854 = ((_e5844 + _e5848) + _e5853);
                        if (_e5537 < 0f) {
                            phi_2390_ = -(_e5537);
                        } else {
                            phi_2390_ = _e5537;
                        }
                        let _e5858 = phi_2390_;
                        if (_e5540 < 0f) {
                            phi_2396_ = -(_e5540);
                        } else {
                            phi_2396_ = _e5540;
                        }
                        let _e5862 = phi_2396_;
                        if (_e5543 < 0f) {
                            phi_2403_ = -(_e5543);
                        } else {
                            phi_2403_ = _e5543;
                        }
                        let _e5867 = phi_2403_;
                        let _e5868 = ((_e5858 + _e5862) + _e5867);
                        if (_e5854 > _e5868) {
                            phi_2409_ = _e5854;
                        } else {
                            phi_2409_ = _e5868;
                        }
                        let _e5871 = phi_2409_;
                        if (_e5586 < 0f) {
                            phi_2415_ = -(_e5586);
                        } else {
                            phi_2415_ = _e5586;
                        }
                        let _e5875 = phi_2415_;
                        if (_e5587 < 0f) {
                            phi_2421_ = -(_e5587);
                        } else {
                            phi_2421_ = _e5587;
                        }
                        let _e5879 = phi_2421_;
                        if (_e5588 < 0f) {
                            phi_2428_ = -(_e5588);
                        } else {
                            phi_2428_ = _e5588;
                        }
                        let _e5884 = phi_2428_;
                        let _e5886 = (((_e5875 + _e5879) + _e5884) * 0.5f);
                        if (_e5871 > _e5886) {
                            phi_2435_ = _e5871;
                        } else {
                            phi_2435_ = _e5886;
                        }
                        let _e5889 = phi_2435_;
                        let _e5894 = local_18.member_3;
                        let _e5907 = ((((_e5591[0] * _e5516) + (_e5591[1] * _e5519)) + (_e5591[2] * _e5522)) * 3f);
                        let _e5908 = ((((_e5648[0] * _e5537) + (_e5648[1] * _e5540)) + (_e5648[2] * _e5543)) * 3f);
                        if (_e5907 < _e5908) {
                            phi_2459_ = _e5907;
                        } else {
                            phi_2459_ = _e5908;
                        }
                        let _e5911 = phi_2459_;
                        if (_e5622 < _e5645) {
                            phi_2464_ = _e5622;
                        } else {
                            phi_2464_ = _e5645;
                        }
                        let _e5914 = phi_2464_;
                        if (_e5911 < _e5914) {
                            phi_2469_ = _e5911;
                        } else {
                            phi_2469_ = _e5914;
                        }
                        let _e5917 = phi_2469_;
                        if (_e5907 > _e5908) {
                            phi_2474_ = _e5907;
                        } else {
                            phi_2474_ = _e5908;
                        }
                        let _e5920 = phi_2474_;
                        if (_e5622 > _e5645) {
                            phi_2479_ = _e5622;
                        } else {
                            phi_2479_ = _e5645;
                        }
                        let _e5923 = phi_2479_;
                        if (_e5920 > _e5923) {
                            phi_2484_ = _e5920;
                        } else {
                            phi_2484_ = _e5923;
                        }
                        let _e5926 = phi_2484_;
                        let _e5931 = -(_e5926);
                        if (_e5917 > _e5931) {
                            phi_2494_ = _e5917;
                        } else {
                            phi_2494_ = _e5931;
                        }
                        let _e5934 = phi_2494_;
                        if ((_e5934 - ((((((_e5710 * 8f) * _e5820) * (0.000000059604645f * (524f / 64f))) + ((_e5827 * 19f) * ((_e5710 * (_e5764 + _e5818)) + (_e5764 * _e5818)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5710) * ((1f + _e5764) * (1f + _e5818))))) + ((_e521.member_1 * (((_e5889 + (_e5820 * (0.000000059604645f * 8f))) + ((_e5894 * 6f) * (_e5764 + _e5818))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5764) * (1f + _e5818))))) * (3f * 1.0001f)))) > 0f) {
                            phi_2503_ = type_39(type_28(0u, f32()), 0u);
                            phi_2504_ = false;
                        } else {
                            phi_2503_ = type_39();
                            phi_2504_ = true;
                        }
                        let _e5940 = phi_2503_;
                        let _e5942 = phi_2504_;
                        phi_2505_ = _e5940;
                        phi_2506_ = _e5942;
                    }
                    let _e5944 = phi_2505_;
                    let _e5946 = phi_2506_;
                    if _e5946 {
                        phi_2512_ = type_14(0i, 2i);
                        phi_2515_ = _e319;
                        phi_2517_ = 0u;
                        phi_2519_ = _e319;
                        loop {
                            let _e5948 = phi_2512_;
                            let _e5950 = phi_2515_;
                            let _e5952 = phi_2517_;
                            let _e5954 = phi_2519_;
                            local_96 = _e5952;
                            local_99 = _e5950;
                            local_100 = _e5952;
                            if (_e5948.member < _e5948.member_1) {
                                let _e5961 = (_e5948.member + 1i);
                                if ((false == (_e5961 > _e5948.member)) != false) {
                                    phi_2540_ = true;
                                } else {
                                    phi_2540_ = false;
                                }
                                let _e5966 = phi_2540_;
                                if _e5966 {
                                    phi_2546_ = type_15(0u, type_15().member_1);
                                } else {
                                    phi_2546_ = type_15(1u, _e5961);
                                }
                                let _e5971 = phi_2546_;
                                phi_2513_ = type_14(_e5971.member_1, _e5948.member_1);
                                phi_2560_ = type_15(1u, _e5948.member);
                            } else {
                                phi_2513_ = _e5948;
                                phi_2560_ = type_15(0u, type_15().member_1);
                            }
                            let _e5977 = phi_2513_;
                            let _e5979 = phi_2560_;
                            if (bitcast<i32>(_e5979.member) != 0i) {
                                if (_e5979.member_1 > 0i) {
                                    phi_2576_ = true;
                                } else {
                                    if _e5501 {
                                        phi_2575_ = false;
                                    } else {
                                        phi_2575_ = true;
                                    }
                                    let _e5986 = phi_2575_;
                                    phi_2576_ = _e5986;
                                }
                                let _e5988 = phi_2576_;
                                if _e5988 {
                                    let _e5991 = local_18.member[0u];
                                    let _e5997 = local_18.member_1[0u];
                                    let _e6003 = local_18.member_2[0u];
                                    let _e6015 = local_18.member[1u];
                                    let _e6021 = local_18.member_1[1u];
                                    let _e6027 = local_18.member_2[1u];
                                    let _e6039 = local_18.member[0u];
                                    if (_e6039[0] < 0f) {
                                        phi_2722_ = -(_e6039[0]);
                                    } else {
                                        phi_2722_ = _e6039[0];
                                    }
                                    let _e6046 = phi_2722_;
                                    if (_e6039[1] < 0f) {
                                        phi_2729_ = -(_e6039[1]);
                                    } else {
                                        phi_2729_ = _e6039[1];
                                    }
                                    let _e6050 = phi_2729_;
                                    if (_e6046 > _e6050) {
                                        phi_2734_ = _e6046;
                                    } else {
                                        phi_2734_ = _e6050;
                                    }
                                    let _e6053 = phi_2734_;
                                    if (_e6039[2] < 0f) {
                                        phi_2741_ = -(_e6039[2]);
                                    } else {
                                        phi_2741_ = _e6039[2];
                                    }
                                    let _e6057 = phi_2741_;
                                    if (_e6053 > _e6057) {
                                        phi_2746_ = _e6053;
                                    } else {
                                        phi_2746_ = _e6057;
                                    }
                                    let _e6060 = phi_2746_;
                                    let _e6063 = local_18.member[1u];
                                    if (_e6063[0] < 0f) {
                                        phi_2759_ = -(_e6063[0]);
                                    } else {
                                        phi_2759_ = _e6063[0];
                                    }
                                    let _e6070 = phi_2759_;
                                    if (_e6063[1] < 0f) {
                                        phi_2766_ = -(_e6063[1]);
                                    } else {
                                        phi_2766_ = _e6063[1];
                                    }
                                    let _e6074 = phi_2766_;
                                    if (_e6070 > _e6074) {
                                        phi_2771_ = _e6070;
                                    } else {
                                        phi_2771_ = _e6074;
                                    }
                                    let _e6077 = phi_2771_;
                                    if (_e6063[2] < 0f) {
                                        phi_2778_ = -(_e6063[2]);
                                    } else {
                                        phi_2778_ = _e6063[2];
                                    }
                                    let _e6081 = phi_2778_;
                                    if (_e6077 > _e6081) {
                                        phi_2783_ = _e6077;
                                    } else {
                                        phi_2783_ = _e6081;
                                    }
                                    let _e6084 = phi_2783_;
                                    if (_e6060 > _e6084) {
                                        phi_2788_ = _e6060;
                                    } else {
                                        phi_2788_ = _e6084;
                                    }
                                    let _e6087 = phi_2788_;
                                    let _e6089 = local_18.member_3;
                                    let _e6093 = local_18.member_1[0u];
                                    if (_e6093[0] < 0f) {
                                        phi_2805_ = -(_e6093[0]);
                                    } else {
                                        phi_2805_ = _e6093[0];
                                    }
                                    let _e6100 = phi_2805_;
                                    if (_e6093[1] < 0f) {
                                        phi_2812_ = -(_e6093[1]);
                                    } else {
                                        phi_2812_ = _e6093[1];
                                    }
                                    let _e6104 = phi_2812_;
                                    if (_e6100 > _e6104) {
                                        phi_2817_ = _e6100;
                                    } else {
                                        phi_2817_ = _e6104;
                                    }
                                    let _e6107 = phi_2817_;
                                    if (_e6093[2] < 0f) {
                                        phi_2824_ = -(_e6093[2]);
                                    } else {
                                        phi_2824_ = _e6093[2];
                                    }
                                    let _e6111 = phi_2824_;
                                    if (_e6107 > _e6111) {
                                        phi_2829_ = _e6107;
                                    } else {
                                        phi_2829_ = _e6111;
                                    }
                                    let _e6114 = phi_2829_;
                                    let _e6117 = local_18.member_1[1u];
                                    if (_e6117[0] < 0f) {
                                        phi_2843_ = -(_e6117[0]);
                                    } else {
                                        phi_2843_ = _e6117[0];
                                    }
                                    let _e6124 = phi_2843_;
                                    if (_e6117[1] < 0f) {
                                        phi_2850_ = -(_e6117[1]);
                                    } else {
                                        phi_2850_ = _e6117[1];
                                    }
                                    let _e6128 = phi_2850_;
                                    if (_e6124 > _e6128) {
                                        phi_2855_ = _e6124;
                                    } else {
                                        phi_2855_ = _e6128;
                                    }
                                    let _e6131 = phi_2855_;
                                    if (_e6117[2] < 0f) {
                                        phi_2862_ = -(_e6117[2]);
                                    } else {
                                        phi_2862_ = _e6117[2];
                                    }
                                    let _e6135 = phi_2862_;
                                    if (_e6131 > _e6135) {
                                        phi_2867_ = _e6131;
                                    } else {
                                        phi_2867_ = _e6135;
                                    }
                                    let _e6138 = phi_2867_;
                                    if (_e6114 > _e6138) {
                                        phi_2872_ = _e6114;
                                    } else {
                                        phi_2872_ = _e6138;
                                    }
                                    let _e6141 = phi_2872_;
                                    let _e6143 = local_18.member_3;
                                    let _e6147 = local_18.member_2[0u];
                                    if (_e6147[0] < 0f) {
                                        phi_2889_ = -(_e6147[0]);
                                    } else {
                                        phi_2889_ = _e6147[0];
                                    }
                                    let _e6154 = phi_2889_;
                                    if (_e6147[1] < 0f) {
                                        phi_2896_ = -(_e6147[1]);
                                    } else {
                                        phi_2896_ = _e6147[1];
                                    }
                                    let _e6158 = phi_2896_;
                                    if (_e6154 > _e6158) {
                                        phi_2901_ = _e6154;
                                    } else {
                                        phi_2901_ = _e6158;
                                    }
                                    let _e6161 = phi_2901_;
                                    if (_e6147[2] < 0f) {
                                        phi_2908_ = -(_e6147[2]);
                                    } else {
                                        phi_2908_ = _e6147[2];
                                    }
                                    let _e6165 = phi_2908_;
                                    if (_e6161 > _e6165) {
                                        phi_2913_ = _e6161;
                                    } else {
                                        phi_2913_ = _e6165;
                                    }
                                    let _e6168 = phi_2913_;
                                    let _e6171 = local_18.member_2[1u];
                                    if (_e6171[0] < 0f) {
                                        phi_2927_ = -(_e6171[0]);
                                    } else {
                                        phi_2927_ = _e6171[0];
                                    }
                                    let _e6178 = phi_2927_;
                                    if (_e6171[1] < 0f) {
                                        phi_2934_ = -(_e6171[1]);
                                    } else {
                                        phi_2934_ = _e6171[1];
                                    }
                                    let _e6182 = phi_2934_;
                                    if (_e6178 > _e6182) {
                                        phi_2939_ = _e6178;
                                    } else {
                                        phi_2939_ = _e6182;
                                    }
                                    let _e6185 = phi_2939_;
                                    if (_e6171[2] < 0f) {
                                        phi_2946_ = -(_e6171[2]);
                                    } else {
                                        phi_2946_ = _e6171[2];
                                    }
                                    let _e6189 = phi_2946_;
                                    if (_e6185 > _e6189) {
                                        phi_2951_ = _e6185;
                                    } else {
                                        phi_2951_ = _e6189;
                                    }
                                    let _e6192 = phi_2951_;
                                    if (_e6168 > _e6192) {
                                        phi_2956_ = _e6168;
                                    } else {
                                        phi_2956_ = _e6192;
                                    }
                                    let _e6195 = phi_2956_;
                                    let _e6197 = local_18.member_3;
                                    let _e6204 = local_18.member_3;
                                    let _e6209 = (_e317 * 0.00390625f);
                                    local_16 = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_2997_ = type_12(0u, 96u);
                                    phi_3000_ = _e5954;
                                    phi_3002_ = _e5954;
                                    phi_3004_ = (_e321 - _e5954);
                                    phi_3006_ = _e5954;
                                    phi_3008_ = false;
                                    phi_3010_ = 0u;
                                    loop {
                                        let _e6212 = phi_2997_;
                                        let _e6214 = phi_3000_;
                                        let _e6216 = phi_3002_;
                                        let _e6218 = phi_3004_;
                                        let _e6220 = phi_3006_;
                                        let _e6222 = phi_3008_;
                                        let _e6224 = phi_3010_;
                                        local_43 = _e6214;
                                        local_86 = _e6216;
                                        if (_e6212.member < _e6212.member_1) {
                                            phi_2998_ = type_12((_e6212.member + 1u), _e6212.member_1);
                                            phi_3033_ = type_12(1u, _e6212.member);
                                        } else {
                                            phi_2998_ = _e6212;
                                            phi_3033_ = type_12(0u, type_12().member_1);
                                        }
                                        let _e6236 = phi_2998_;
                                        let _e6238 = phi_3033_;
                                        if (bitcast<i32>(_e6238.member) != 0i) {
                                            let _e6244 = local_18.member[0u];
                                            let _e6250 = local_18.member[1u];
                                            let _e6266 = local_18.member_1[0u];
                                            let _e6272 = local_18.member_1[1u];
                                            let _e6288 = local_18.member_2[0u];
                                            let _e6294 = local_18.member_2[1u];
                                            let _e6308 = function_2(array<f32, 3>((_e6244[0] + ((_e6250[0] - _e6244[0]) * _e6214)), (_e6244[1] + ((_e6250[1] - _e6244[1]) * _e6214)), (_e6244[2] + ((_e6250[2] - _e6244[2]) * _e6214))), array<f32, 3>((_e6266[0] + ((_e6272[0] - _e6266[0]) * _e6214)), (_e6266[1] + ((_e6272[1] - _e6266[1]) * _e6214)), (_e6266[2] + ((_e6272[2] - _e6266[2]) * _e6214))), array<f32, 3>((_e6288[0] + ((_e6294[0] - _e6288[0]) * _e6214)), (_e6288[1] + ((_e6294[1] - _e6288[1]) * _e6214)), (_e6288[2] + ((_e6294[2] - _e6288[2]) * _e6214))), 0u);
                                            if (_e6224 == 0u) {
                                                phi_3161_ = _e6308;
                                            } else {
                                                if (_e6224 == 1u) {
                                                    phi_3147_ = _e6308[0];
                                                } else {
                                                    phi_3147_ = 0f;
                                                }
                                                let _e6313 = phi_3147_;
                                                if (_e6224 == 2u) {
                                                    phi_3153_ = _e6308[1];
                                                } else {
                                                    phi_3153_ = 0f;
                                                }
                                                let _e6317 = phi_3153_;
                                                if (_e6224 == 3u) {
                                                    phi_3159_ = _e6308[2];
                                                } else {
                                                    phi_3159_ = 0f;
                                                }
                                                let _e6321 = phi_3159_;
                                                phi_3161_ = array<f32, 3>(_e6313, _e6317, _e6321);
                                            }
                                            let _e6324 = phi_3161_;
                                            if (_e6324[0] < 0f) {
                                                phi_3168_ = -(_e6324[0]);
                                            } else {
                                                phi_3168_ = _e6324[0];
                                            }
                                            let _e6329 = phi_3168_;
                                            if (_e6324[1] < 0f) {
                                                phi_3175_ = -(_e6324[1]);
                                            } else {
                                                phi_3175_ = _e6324[1];
                                            }
                                            let _e6334 = phi_3175_;
                                            if (_e6324[2] < 0f) {
                                                phi_3183_ = -(_e6324[2]);
                                            } else {
                                                phi_3183_ = _e6324[2];
                                            }
                                            let _e6340 = phi_3183_;
                                            let _e6341 = ((_e6329 + _e6334) + _e6340);
                                            if (_e6341 > 0f) {
                                                if ((bitcast<u32>(_e6341) & 2139095040u) != 2139095040u) {
                                                    let _e6346 = (1f / _e6341);
                                                    let _e6348 = (_e6324[0] * _e6346);
                                                    let _e6350 = (_e6324[1] * _e6346);
                                                    let _e6352 = (_e6324[2] * _e6346);
                                                    let _e6357 = (((_e6348 * _e6348) + (_e6350 * _e6350)) + (_e6352 * _e6352));
                                                    if (_e6357 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e6357 > 0f) {
                                                            phi_3220_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_3220_ = 0f;
                                                        }
                                                        let _e6410 = phi_3220_;
                                                        phi_3284_ = _e6410;
                                                    } else {
                                                        phi_3227_ = type_14(0i, 5i);
                                                        phi_3230_ = bitcast<f32>(((bitcast<u32>(_e6357) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e6365 = phi_3227_;
                                                            let _e6367 = phi_3230_;
                                                            local_40 = _e6367;
                                                            if (_e6365.member < _e6365.member_1) {
                                                                let _e6374 = (_e6365.member + 1i);
                                                                if ((false == (_e6374 > _e6365.member)) != false) {
                                                                    phi_3251_ = true;
                                                                } else {
                                                                    phi_3251_ = false;
                                                                }
                                                                let _e6379 = phi_3251_;
                                                                if _e6379 {
                                                                    phi_3257_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_3257_ = type_15(1u, _e6374);
                                                                }
                                                                let _e6384 = phi_3257_;
                                                                phi_3228_ = type_14(_e6384.member_1, _e6365.member_1);
                                                                phi_3271_ = type_15(1u, _e6365.member);
                                                            } else {
                                                                phi_3228_ = _e6365;
                                                                phi_3271_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e6390 = phi_3228_;
                                                            let _e6392 = phi_3271_;
                                                            let _e6395 = (bitcast<i32>(_e6392.member) != 0i);
                                                            if _e6395 {
                                                                phi_3231_ = (0.5f * (_e6367 + (_e6357 / _e6367)));
                                                            } else {
                                                                phi_3231_ = f32();
                                                            }
                                                            let _e6400 = phi_3231_;
                                                            continue;
                                                            continuing {
                                                                phi_3227_ = _e6390;
                                                                phi_3230_ = _e6400;
                                                                break if !(_e6395);
                                                            }
                                                        }
                                                        let _e6405 = local_40;
                                                        phi_3284_ = (_e6405 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e6412 = phi_3284_;
                                                    let _e6413 = (0.000000059604645f * 12f);
                                                    let _e6418 = ((((((((_e6087 + _e6089) + (_e6141 + _e6143)) + (_e6195 + _e6197)) * (0.000000059604645f * 16f)) + (_e6204 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e521.member_1 * _e6412) * (1f + _e6413)));
                                                    let _e6423 = (((_e6348 * _e5991[0]) + (_e6350 * _e5991[1])) + (_e6352 * _e5991[2]));
                                                    let _e6428 = (((_e6348 * (_e5991[0] - _e5997[0])) + (_e6350 * (_e5991[1] - _e5997[1]))) + (_e6352 * (_e5991[2] - _e5997[2])));
                                                    let _e6433 = (((_e6348 * (_e5991[0] - _e6003[0])) + (_e6350 * (_e5991[1] - _e6003[1]))) + (_e6352 * (_e5991[2] - _e6003[2])));
                                                    let _e6438 = (((_e6348 * _e5991[0]) + (_e6350 * _e5991[1])) + (_e6352 * _e5991[2]));
                                                    let _e6444 = (((_e6348 * _e6015[0]) + (_e6350 * _e6015[1])) + (_e6352 * _e6015[2]));
                                                    let _e6449 = (((_e6348 * (_e6015[0] - _e6021[0])) + (_e6350 * (_e6015[1] - _e6021[1]))) + (_e6352 * (_e6015[2] - _e6021[2])));
                                                    let _e6454 = (((_e6348 * (_e6015[0] - _e6027[0])) + (_e6350 * (_e6015[1] - _e6027[1]))) + (_e6352 * (_e6015[2] - _e6027[2])));
                                                    let _e6459 = (((_e6348 * _e6015[0]) + (_e6350 * _e6015[1])) + (_e6352 * _e6015[2]));
                                                    if (_e6423 < 0f) {
                                                        phi_3350_ = -(_e6423);
                                                    } else {
                                                        phi_3350_ = _e6423;
                                                    }
                                                    let _e6464 = phi_3350_;
                                                    if (_e6444 < 0f) {
                                                        phi_3356_ = -(_e6444);
                                                    } else {
                                                        phi_3356_ = _e6444;
                                                    }
                                                    let _e6468 = phi_3356_;
                                                    if (_e6428 < 0f) {
                                                        phi_3365_ = -(_e6428);
                                                    } else {
                                                        phi_3365_ = _e6428;
                                                    }
                                                    let _e6475 = phi_3365_;
                                                    if (_e6449 < 0f) {
                                                        phi_3371_ = -(_e6449);
                                                    } else {
                                                        phi_3371_ = _e6449;
                                                    }
                                                    let _e6479 = phi_3371_;
                                                    if (_e6433 < 0f) {
                                                        phi_3380_ = -(_e6433);
                                                    } else {
                                                        phi_3380_ = _e6433;
                                                    }
                                                    let _e6486 = phi_3380_;
                                                    if (_e6454 < 0f) {
                                                        phi_3386_ = -(_e6454);
                                                    } else {
                                                        phi_3386_ = _e6454;
                                                    }
                                                    let _e6490 = phi_3386_;
                                                    if (_e6438 < 0f) {
                                                        phi_3395_ = -(_e6438);
                                                    } else {
                                                        phi_3395_ = _e6438;
                                                    }
                                                    let _e6497 = phi_3395_;
                                                    if (_e6459 < 0f) {
                                                        phi_3401_ = -(_e6459);
                                                    } else {
                                                        phi_3401_ = _e6459;
                                                    }
                                                    let _e6501 = phi_3401_;
                                                    phi_3407_ = type_32(array<f32, 4>(_e6423, _e6428, _e6433, _e6438), array<f32, 4>(_e6444, _e6449, _e6454, _e6459), array<f32, 4>((_e6418 + ((_e6464 + _e6468) * _e6413)), (_e6418 + ((_e6475 + _e6479) * _e6413)), (_e6418 + ((_e6486 + _e6490) * _e6413)), (_e6418 + ((_e6497 + _e6501) * _e6413))));
                                                    phi_3408_ = false;
                                                } else {
                                                    phi_3407_ = type_32();
                                                    phi_3408_ = true;
                                                }
                                                let _e6508 = phi_3407_;
                                                let _e6510 = phi_3408_;
                                                phi_3409_ = _e6508;
                                                phi_3410_ = _e6510;
                                            } else {
                                                phi_3409_ = type_32();
                                                phi_3410_ = true;
                                            }
                                            let _e6512 = phi_3409_;
                                            let _e6514 = phi_3410_;
                                            if _e6514 {
                                                phi_3418_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_3418_ = _e6512;
                                            }
                                            let _e6516 = phi_3418_;
                                            local_17 = type_32(array<f32, 4>(_e6516.member[0], _e6516.member[1], _e6516.member[2], _e6516.member[3]), array<f32, 4>(_e6516.member_1[0], _e6516.member_1[1], _e6516.member_1[2], _e6516.member_1[3]), array<f32, 4>(_e6516.member_2[0], _e6516.member_2[1], _e6516.member_2[2], _e6516.member_2[3]));
                                            let _e6536 = (_e6214 - _e6220);
                                            let _e6540 = local_17.member[0u];
                                            let _e6543 = local_17.member_1[0u];
                                            let _e6546 = local_17.member[0u];
                                            let _e6552 = local_17.member_2[0u];
                                            if (((_e6540 + ((_e6543 - _e6546) * _e6214)) - _e6552) > 0f) {
                                                let _e6557 = local_17.member[1u];
                                                let _e6560 = local_17.member_1[1u];
                                                let _e6563 = local_17.member[1u];
                                                let _e6569 = local_17.member_2[1u];
                                                if (((_e6557 + ((_e6560 - _e6563) * _e6214)) - _e6569) > 0f) {
                                                    let _e6574 = local_17.member[2u];
                                                    let _e6577 = local_17.member_1[2u];
                                                    let _e6580 = local_17.member[2u];
                                                    let _e6586 = local_17.member_2[2u];
                                                    if (((_e6574 + ((_e6577 - _e6580) * _e6214)) - _e6586) > 0f) {
                                                        let _e6591 = local_17.member[3u];
                                                        let _e6594 = local_17.member_1[3u];
                                                        let _e6597 = local_17.member[3u];
                                                        let _e6603 = local_17.member_2[3u];
                                                        phi_3589_ = (((_e6591 + ((_e6594 - _e6597) * _e6214)) - _e6603) > 0f);
                                                        phi_3590_ = false;
                                                    } else {
                                                        phi_3589_ = bool();
                                                        phi_3590_ = true;
                                                    }
                                                    let _e6607 = phi_3589_;
                                                    let _e6609 = phi_3590_;
                                                    phi_3591_ = _e6607;
                                                    phi_3592_ = _e6609;
                                                } else {
                                                    phi_3591_ = bool();
                                                    phi_3592_ = true;
                                                }
                                                let _e6611 = phi_3591_;
                                                let _e6613 = phi_3592_;
                                                phi_3593_ = _e6611;
                                                phi_3594_ = _e6613;
                                            } else {
                                                phi_3593_ = bool();
                                                phi_3594_ = true;
                                            }
                                            let _e6615 = phi_3593_;
                                            let _e6617 = phi_3594_;
                                            if _e6617 {
                                                phi_3598_ = false;
                                            } else {
                                                phi_3598_ = _e6615;
                                            }
                                            let _e6619 = phi_3598_;
                                            if _e6619 {
                                                if (_e6214 <= _e6216) {
                                                    phi_3908_ = true;
                                                } else {
                                                    let _e6623 = local_16.member[0u];
                                                    let _e6626 = local_16.member_1[0u];
                                                    let _e6629 = local_16.member[0u];
                                                    let _e6635 = local_16.member_2[0u];
                                                    let _e6639 = local_17.member[0u];
                                                    let _e6642 = local_17.member_1[0u];
                                                    let _e6645 = local_17.member[0u];
                                                    let _e6651 = local_17.member_2[0u];
                                                    if ((((_e6623 + ((_e6626 - _e6629) * _e6214)) - _e6635) + ((_e6639 + ((_e6642 - _e6645) * _e6220)) - _e6651)) > 0f) {
                                                        let _e6657 = local_16.member[1u];
                                                        let _e6660 = local_16.member_1[1u];
                                                        let _e6663 = local_16.member[1u];
                                                        let _e6669 = local_16.member_2[1u];
                                                        let _e6673 = local_17.member[1u];
                                                        let _e6676 = local_17.member_1[1u];
                                                        let _e6679 = local_17.member[1u];
                                                        let _e6685 = local_17.member_2[1u];
                                                        if ((((_e6657 + ((_e6660 - _e6663) * _e6214)) - _e6669) + ((_e6673 + ((_e6676 - _e6679) * _e6220)) - _e6685)) > 0f) {
                                                            let _e6691 = local_16.member[2u];
                                                            let _e6694 = local_16.member_1[2u];
                                                            let _e6697 = local_16.member[2u];
                                                            let _e6703 = local_16.member_2[2u];
                                                            let _e6707 = local_17.member[2u];
                                                            let _e6710 = local_17.member_1[2u];
                                                            let _e6713 = local_17.member[2u];
                                                            let _e6719 = local_17.member_2[2u];
                                                            if ((((_e6691 + ((_e6694 - _e6697) * _e6214)) - _e6703) + ((_e6707 + ((_e6710 - _e6713) * _e6220)) - _e6719)) > 0f) {
                                                                let _e6725 = local_16.member[3u];
                                                                let _e6728 = local_16.member_1[3u];
                                                                let _e6731 = local_16.member[3u];
                                                                let _e6737 = local_16.member_2[3u];
                                                                let _e6741 = local_17.member[3u];
                                                                let _e6744 = local_17.member_1[3u];
                                                                let _e6747 = local_17.member[3u];
                                                                let _e6753 = local_17.member_2[3u];
                                                                phi_3895_ = ((((_e6725 + ((_e6728 - _e6731) * _e6214)) - _e6737) + ((_e6741 + ((_e6744 - _e6747) * _e6220)) - _e6753)) > 0f);
                                                                phi_3896_ = false;
                                                            } else {
                                                                phi_3895_ = bool();
                                                                phi_3896_ = true;
                                                            }
                                                            let _e6758 = phi_3895_;
                                                            let _e6760 = phi_3896_;
                                                            phi_3897_ = _e6758;
                                                            phi_3898_ = _e6760;
                                                        } else {
                                                            phi_3897_ = bool();
                                                            phi_3898_ = true;
                                                        }
                                                        let _e6762 = phi_3897_;
                                                        let _e6764 = phi_3898_;
                                                        phi_3899_ = _e6762;
                                                        phi_3900_ = _e6764;
                                                    } else {
                                                        phi_3899_ = bool();
                                                        phi_3900_ = true;
                                                    }
                                                    let _e6766 = phi_3899_;
                                                    let _e6768 = phi_3900_;
                                                    if _e6768 {
                                                        phi_3904_ = false;
                                                    } else {
                                                        phi_3904_ = _e6766;
                                                    }
                                                    let _e6770 = phi_3904_;
                                                    phi_3908_ = _e6770;
                                                }
                                                let _e6772 = phi_3908_;
                                                if _e6772 {
                                                    if _e6222 {
                                                        if (_e6214 >= _e321) {
                                                            phi_3919_ = false;
                                                        } else {
                                                            phi_3919_ = true;
                                                        }
                                                        let _e6775 = phi_3919_;
                                                        phi_3920_ = _e6775;
                                                    } else {
                                                        phi_3920_ = true;
                                                    }
                                                    let _e6777 = phi_3920_;
                                                    if _e6777 {
                                                        local_16 = type_32(array<f32, 4>(_e6516.member[0], _e6516.member[1], _e6516.member[2], _e6516.member[3]), array<f32, 4>(_e6516.member_1[0], _e6516.member_1[1], _e6516.member_1[2], _e6516.member_1[3]), array<f32, 4>(_e6516.member_2[0], _e6516.member_2[1], _e6516.member_2[2], _e6516.member_2[3]));
                                                        let _e6799 = local_16.member[0u];
                                                        let _e6802 = local_16.member_1[0u];
                                                        let _e6805 = local_16.member_2[0u];
                                                        if (_e6799 > _e6805) {
                                                            if (_e6802 > _e6805) {
                                                                phi_3994_ = false;
                                                            } else {
                                                                phi_3994_ = true;
                                                            }
                                                            let _e6809 = phi_3994_;
                                                            phi_3995_ = _e6809;
                                                        } else {
                                                            phi_3995_ = true;
                                                        }
                                                        let _e6811 = phi_3995_;
                                                        if _e6811 {
                                                            let _e6812 = (_e6802 >= _e6799);
                                                            if _e6812 {
                                                                phi_4017_ = f32();
                                                                phi_4018_ = false;
                                                            } else {
                                                                if ((_e6799 - _e6802) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_4015_ = (((_e6799 - _e6805) / (_e6799 - _e6802)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_4016_ = false;
                                                                } else {
                                                                    phi_4015_ = f32();
                                                                    phi_4016_ = true;
                                                                }
                                                                let _e6823 = phi_4015_;
                                                                let _e6825 = phi_4016_;
                                                                phi_4017_ = _e6823;
                                                                phi_4018_ = _e6825;
                                                            }
                                                            let _e6827 = phi_4017_;
                                                            let _e6829 = phi_4018_;
                                                            phi_4019_ = _e6827;
                                                            phi_4020_ = _e6812;
                                                            phi_4021_ = _e6829;
                                                        } else {
                                                            phi_4019_ = f32();
                                                            phi_4020_ = true;
                                                            phi_4021_ = false;
                                                        }
                                                        let _e6831 = phi_4019_;
                                                        let _e6833 = phi_4020_;
                                                        let _e6835 = phi_4021_;
                                                        if _e6833 {
                                                            phi_4025_ = 2f;
                                                            phi_4026_ = true;
                                                        } else {
                                                            phi_4025_ = _e6214;
                                                            phi_4026_ = _e6835;
                                                        }
                                                        let _e6837 = phi_4025_;
                                                        let _e6839 = phi_4026_;
                                                        if _e6839 {
                                                            phi_4030_ = _e6837;
                                                        } else {
                                                            phi_4030_ = _e6831;
                                                        }
                                                        let _e6841 = phi_4030_;
                                                        let _e6844 = local_16.member[1u];
                                                        let _e6847 = local_16.member_1[1u];
                                                        let _e6850 = local_16.member_2[1u];
                                                        if (_e6844 > _e6850) {
                                                            if (_e6847 > _e6850) {
                                                                phi_4062_ = false;
                                                            } else {
                                                                phi_4062_ = true;
                                                            }
                                                            let _e6854 = phi_4062_;
                                                            phi_4063_ = _e6854;
                                                        } else {
                                                            phi_4063_ = true;
                                                        }
                                                        let _e6856 = phi_4063_;
                                                        if _e6856 {
                                                            let _e6857 = (_e6847 >= _e6844);
                                                            if _e6857 {
                                                                phi_4085_ = f32();
                                                                phi_4086_ = false;
                                                            } else {
                                                                if ((_e6844 - _e6847) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_4083_ = (((_e6844 - _e6850) / (_e6844 - _e6847)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_4084_ = false;
                                                                } else {
                                                                    phi_4083_ = f32();
                                                                    phi_4084_ = true;
                                                                }
                                                                let _e6868 = phi_4083_;
                                                                let _e6870 = phi_4084_;
                                                                phi_4085_ = _e6868;
                                                                phi_4086_ = _e6870;
                                                            }
                                                            let _e6872 = phi_4085_;
                                                            let _e6874 = phi_4086_;
                                                            phi_4087_ = _e6872;
                                                            phi_4088_ = _e6857;
                                                            phi_4089_ = _e6874;
                                                        } else {
                                                            phi_4087_ = f32();
                                                            phi_4088_ = true;
                                                            phi_4089_ = false;
                                                        }
                                                        let _e6876 = phi_4087_;
                                                        let _e6878 = phi_4088_;
                                                        let _e6880 = phi_4089_;
                                                        if _e6878 {
                                                            phi_4093_ = 2f;
                                                            phi_4094_ = true;
                                                        } else {
                                                            phi_4093_ = _e6214;
                                                            phi_4094_ = _e6880;
                                                        }
                                                        let _e6882 = phi_4093_;
                                                        let _e6884 = phi_4094_;
                                                        if _e6884 {
                                                            phi_4098_ = _e6882;
                                                        } else {
                                                            phi_4098_ = _e6876;
                                                        }
                                                        let _e6886 = phi_4098_;
                                                        if (_e6841 < _e6886) {
                                                            phi_4103_ = _e6841;
                                                        } else {
                                                            phi_4103_ = _e6886;
                                                        }
                                                        let _e6889 = phi_4103_;
                                                        let _e6892 = local_16.member[2u];
                                                        let _e6895 = local_16.member_1[2u];
                                                        let _e6898 = local_16.member_2[2u];
                                                        if (_e6892 > _e6898) {
                                                            if (_e6895 > _e6898) {
                                                                phi_4135_ = false;
                                                            } else {
                                                                phi_4135_ = true;
                                                            }
                                                            let _e6902 = phi_4135_;
                                                            phi_4136_ = _e6902;
                                                        } else {
                                                            phi_4136_ = true;
                                                        }
                                                        let _e6904 = phi_4136_;
                                                        if _e6904 {
                                                            let _e6905 = (_e6895 >= _e6892);
                                                            if _e6905 {
                                                                phi_4158_ = f32();
                                                                phi_4159_ = false;
                                                            } else {
                                                                if ((_e6892 - _e6895) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_4156_ = (((_e6892 - _e6898) / (_e6892 - _e6895)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_4157_ = false;
                                                                } else {
                                                                    phi_4156_ = f32();
                                                                    phi_4157_ = true;
                                                                }
                                                                let _e6916 = phi_4156_;
                                                                let _e6918 = phi_4157_;
                                                                phi_4158_ = _e6916;
                                                                phi_4159_ = _e6918;
                                                            }
                                                            let _e6920 = phi_4158_;
                                                            let _e6922 = phi_4159_;
                                                            phi_4160_ = _e6920;
                                                            phi_4161_ = _e6905;
                                                            phi_4162_ = _e6922;
                                                        } else {
                                                            phi_4160_ = f32();
                                                            phi_4161_ = true;
                                                            phi_4162_ = false;
                                                        }
                                                        let _e6924 = phi_4160_;
                                                        let _e6926 = phi_4161_;
                                                        let _e6928 = phi_4162_;
                                                        if _e6926 {
                                                            phi_4166_ = 2f;
                                                            phi_4167_ = true;
                                                        } else {
                                                            phi_4166_ = _e6214;
                                                            phi_4167_ = _e6928;
                                                        }
                                                        let _e6930 = phi_4166_;
                                                        let _e6932 = phi_4167_;
                                                        if _e6932 {
                                                            phi_4171_ = _e6930;
                                                        } else {
                                                            phi_4171_ = _e6924;
                                                        }
                                                        let _e6934 = phi_4171_;
                                                        let _e6937 = local_16.member[3u];
                                                        let _e6940 = local_16.member_1[3u];
                                                        let _e6943 = local_16.member_2[3u];
                                                        if (_e6937 > _e6943) {
                                                            if (_e6940 > _e6943) {
                                                                phi_4203_ = false;
                                                            } else {
                                                                phi_4203_ = true;
                                                            }
                                                            let _e6947 = phi_4203_;
                                                            phi_4204_ = _e6947;
                                                        } else {
                                                            phi_4204_ = true;
                                                        }
                                                        let _e6949 = phi_4204_;
                                                        if _e6949 {
                                                            let _e6950 = (_e6940 >= _e6937);
                                                            if _e6950 {
                                                                phi_4226_ = f32();
                                                                phi_4227_ = false;
                                                            } else {
                                                                if ((_e6937 - _e6940) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_4224_ = (((_e6937 - _e6943) / (_e6937 - _e6940)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_4225_ = false;
                                                                } else {
                                                                    phi_4224_ = f32();
                                                                    phi_4225_ = true;
                                                                }
                                                                let _e6961 = phi_4224_;
                                                                let _e6963 = phi_4225_;
                                                                phi_4226_ = _e6961;
                                                                phi_4227_ = _e6963;
                                                            }
                                                            let _e6965 = phi_4226_;
                                                            let _e6967 = phi_4227_;
                                                            phi_4228_ = _e6965;
                                                            phi_4229_ = _e6950;
                                                            phi_4230_ = _e6967;
                                                        } else {
                                                            phi_4228_ = f32();
                                                            phi_4229_ = true;
                                                            phi_4230_ = false;
                                                        }
                                                        let _e6969 = phi_4228_;
                                                        let _e6971 = phi_4229_;
                                                        let _e6973 = phi_4230_;
                                                        if _e6971 {
                                                            phi_4234_ = 2f;
                                                            phi_4235_ = true;
                                                        } else {
                                                            phi_4234_ = _e6214;
                                                            phi_4235_ = _e6973;
                                                        }
                                                        let _e6975 = phi_4234_;
                                                        let _e6977 = phi_4235_;
                                                        if _e6977 {
                                                            phi_4239_ = _e6975;
                                                        } else {
                                                            phi_4239_ = _e6969;
                                                        }
                                                        let _e6979 = phi_4239_;
                                                        if (_e6934 < _e6979) {
                                                            phi_4244_ = _e6934;
                                                        } else {
                                                            phi_4244_ = _e6979;
                                                        }
                                                        let _e6982 = phi_4244_;
                                                        if (_e6889 < _e6982) {
                                                            phi_4249_ = _e6889;
                                                        } else {
                                                            phi_4249_ = _e6982;
                                                        }
                                                        let _e6985 = phi_4249_;
                                                        if (_e6985 > _e6214) {
                                                            phi_4254_ = _e6985;
                                                        } else {
                                                            phi_4254_ = _e6214;
                                                        }
                                                        let _e6988 = phi_4254_;
                                                        let _e6989 = (_e6988 > _e321);
                                                        if _e6989 {
                                                            phi_4759_ = f32();
                                                            phi_4760_ = f32();
                                                            phi_4761_ = false;
                                                            phi_4762_ = false;
                                                        } else {
                                                            let _e6990 = (_e6988 - _e6214);
                                                            let _e6991 = (_e6990 <= _e6209);
                                                            let _e6993 = (_e6988 + (_e317 * 0.01f));
                                                            if (_e6993 < _e321) {
                                                                phi_4267_ = _e6993;
                                                            } else {
                                                                phi_4267_ = _e321;
                                                            }
                                                            let _e6996 = phi_4267_;
                                                            if _e6991 {
                                                                if (_e521.member_1 > 0f) {
                                                                    let _e7000 = local_18.member[0u];
                                                                    let _e7006 = local_18.member[1u];
                                                                    let _e7022 = local_18.member_1[0u];
                                                                    let _e7028 = local_18.member_1[1u];
                                                                    let _e7044 = local_18.member_2[0u];
                                                                    let _e7050 = local_18.member_2[1u];
                                                                    let _e7064 = function_2(array<f32, 3>((_e7000[0] + ((_e7006[0] - _e7000[0]) * _e6996)), (_e7000[1] + ((_e7006[1] - _e7000[1]) * _e6996)), (_e7000[2] + ((_e7006[2] - _e7000[2]) * _e6996))), array<f32, 3>((_e7022[0] + ((_e7028[0] - _e7022[0]) * _e6996)), (_e7022[1] + ((_e7028[1] - _e7022[1]) * _e6996)), (_e7022[2] + ((_e7028[2] - _e7022[2]) * _e6996))), array<f32, 3>((_e7044[0] + ((_e7050[0] - _e7044[0]) * _e6996)), (_e7044[1] + ((_e7050[1] - _e7044[1]) * _e6996)), (_e7044[2] + ((_e7050[2] - _e7044[2]) * _e6996))), 0u);
                                                                    let _e7075 = (((_e7064[0] * _e7064[0]) + (_e7064[1] * _e7064[1])) + (_e7064[2] * _e7064[2]));
                                                                    if (_e7075 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e7075 > 0f) {
                                                                            phi_4397_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_4397_ = 0f;
                                                                        }
                                                                        let _e7128 = phi_4397_;
                                                                        phi_4461_ = _e7128;
                                                                    } else {
                                                                        phi_4404_ = type_14(0i, 5i);
                                                                        phi_4407_ = bitcast<f32>(((bitcast<u32>(_e7075) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e7083 = phi_4404_;
                                                                            let _e7085 = phi_4407_;
                                                                            local_41 = _e7085;
                                                                            if (_e7083.member < _e7083.member_1) {
                                                                                let _e7092 = (_e7083.member + 1i);
                                                                                if ((false == (_e7092 > _e7083.member)) != false) {
                                                                                    phi_4428_ = true;
                                                                                } else {
                                                                                    phi_4428_ = false;
                                                                                }
                                                                                let _e7097 = phi_4428_;
                                                                                if _e7097 {
                                                                                    phi_4434_ = type_15(0u, type_15().member_1);
                                                                                } else {
                                                                                    phi_4434_ = type_15(1u, _e7092);
                                                                                }
                                                                                let _e7102 = phi_4434_;
                                                                                phi_4405_ = type_14(_e7102.member_1, _e7083.member_1);
                                                                                phi_4448_ = type_15(1u, _e7083.member);
                                                                            } else {
                                                                                phi_4405_ = _e7083;
                                                                                phi_4448_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e7108 = phi_4405_;
                                                                            let _e7110 = phi_4448_;
                                                                            let _e7113 = (bitcast<i32>(_e7110.member) != 0i);
                                                                            if _e7113 {
                                                                                phi_4408_ = (0.5f * (_e7085 + (_e7075 / _e7085)));
                                                                            } else {
                                                                                phi_4408_ = f32();
                                                                            }
                                                                            let _e7118 = phi_4408_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4404_ = _e7108;
                                                                                phi_4407_ = _e7118;
                                                                                break if !(_e7113);
                                                                            }
                                                                        }
                                                                        let _e7123 = local_41;
                                                                        phi_4461_ = (_e7123 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e7130 = phi_4461_;
                                                                    let _e7136 = local_18.member[0u];
                                                                    if (_e7136[0] < 0f) {
                                                                        phi_4477_ = -(_e7136[0]);
                                                                    } else {
                                                                        phi_4477_ = _e7136[0];
                                                                    }
                                                                    let _e7143 = phi_4477_;
                                                                    if (_e7136[1] < 0f) {
                                                                        phi_4484_ = -(_e7136[1]);
                                                                    } else {
                                                                        phi_4484_ = _e7136[1];
                                                                    }
                                                                    let _e7147 = phi_4484_;
                                                                    if (_e7143 > _e7147) {
                                                                        phi_4489_ = _e7143;
                                                                    } else {
                                                                        phi_4489_ = _e7147;
                                                                    }
                                                                    let _e7150 = phi_4489_;
                                                                    if (_e7136[2] < 0f) {
                                                                        phi_4496_ = -(_e7136[2]);
                                                                    } else {
                                                                        phi_4496_ = _e7136[2];
                                                                    }
                                                                    let _e7154 = phi_4496_;
                                                                    if (_e7150 > _e7154) {
                                                                        phi_4501_ = _e7150;
                                                                    } else {
                                                                        phi_4501_ = _e7154;
                                                                    }
                                                                    let _e7157 = phi_4501_;
                                                                    let _e7160 = local_18.member[1u];
                                                                    if (_e7160[0] < 0f) {
                                                                        phi_4514_ = -(_e7160[0]);
                                                                    } else {
                                                                        phi_4514_ = _e7160[0];
                                                                    }
                                                                    let _e7167 = phi_4514_;
                                                                    if (_e7160[1] < 0f) {
                                                                        phi_4521_ = -(_e7160[1]);
                                                                    } else {
                                                                        phi_4521_ = _e7160[1];
                                                                    }
                                                                    let _e7171 = phi_4521_;
                                                                    if (_e7167 > _e7171) {
                                                                        phi_4526_ = _e7167;
                                                                    } else {
                                                                        phi_4526_ = _e7171;
                                                                    }
                                                                    let _e7174 = phi_4526_;
                                                                    if (_e7160[2] < 0f) {
                                                                        phi_4533_ = -(_e7160[2]);
                                                                    } else {
                                                                        phi_4533_ = _e7160[2];
                                                                    }
                                                                    let _e7178 = phi_4533_;
                                                                    if (_e7174 > _e7178) {
                                                                        phi_4538_ = _e7174;
                                                                    } else {
                                                                        phi_4538_ = _e7178;
                                                                    }
                                                                    let _e7181 = phi_4538_;
                                                                    if (_e7157 > _e7181) {
                                                                        phi_4543_ = _e7157;
                                                                    } else {
                                                                        phi_4543_ = _e7181;
                                                                    }
                                                                    let _e7184 = phi_4543_;
                                                                    let _e7186 = local_18.member_3;
                                                                    let _e7190 = local_18.member_1[0u];
                                                                    if (_e7190[0] < 0f) {
                                                                        phi_4560_ = -(_e7190[0]);
                                                                    } else {
                                                                        phi_4560_ = _e7190[0];
                                                                    }
                                                                    let _e7197 = phi_4560_;
                                                                    if (_e7190[1] < 0f) {
                                                                        phi_4567_ = -(_e7190[1]);
                                                                    } else {
                                                                        phi_4567_ = _e7190[1];
                                                                    }
                                                                    let _e7201 = phi_4567_;
                                                                    if (_e7197 > _e7201) {
                                                                        phi_4572_ = _e7197;
                                                                    } else {
                                                                        phi_4572_ = _e7201;
                                                                    }
                                                                    let _e7204 = phi_4572_;
                                                                    if (_e7190[2] < 0f) {
                                                                        phi_4579_ = -(_e7190[2]);
                                                                    } else {
                                                                        phi_4579_ = _e7190[2];
                                                                    }
                                                                    let _e7208 = phi_4579_;
                                                                    if (_e7204 > _e7208) {
                                                                        phi_4584_ = _e7204;
                                                                    } else {
                                                                        phi_4584_ = _e7208;
                                                                    }
                                                                    let _e7211 = phi_4584_;
                                                                    let _e7214 = local_18.member_1[1u];
                                                                    if (_e7214[0] < 0f) {
                                                                        phi_4598_ = -(_e7214[0]);
                                                                    } else {
                                                                        phi_4598_ = _e7214[0];
                                                                    }
                                                                    let _e7221 = phi_4598_;
                                                                    if (_e7214[1] < 0f) {
                                                                        phi_4605_ = -(_e7214[1]);
                                                                    } else {
                                                                        phi_4605_ = _e7214[1];
                                                                    }
                                                                    let _e7225 = phi_4605_;
                                                                    if (_e7221 > _e7225) {
                                                                        phi_4610_ = _e7221;
                                                                    } else {
                                                                        phi_4610_ = _e7225;
                                                                    }
                                                                    let _e7228 = phi_4610_;
                                                                    if (_e7214[2] < 0f) {
                                                                        phi_4617_ = -(_e7214[2]);
                                                                    } else {
                                                                        phi_4617_ = _e7214[2];
                                                                    }
                                                                    let _e7232 = phi_4617_;
                                                                    if (_e7228 > _e7232) {
                                                                        phi_4622_ = _e7228;
                                                                    } else {
                                                                        phi_4622_ = _e7232;
                                                                    }
                                                                    let _e7235 = phi_4622_;
                                                                    if (_e7211 > _e7235) {
                                                                        phi_4627_ = _e7211;
                                                                    } else {
                                                                        phi_4627_ = _e7235;
                                                                    }
                                                                    let _e7238 = phi_4627_;
                                                                    let _e7240 = local_18.member_3;
                                                                    let _e7244 = local_18.member_2[0u];
                                                                    if (_e7244[0] < 0f) {
                                                                        phi_4644_ = -(_e7244[0]);
                                                                    } else {
                                                                        phi_4644_ = _e7244[0];
                                                                    }
                                                                    let _e7251 = phi_4644_;
                                                                    if (_e7244[1] < 0f) {
                                                                        phi_4651_ = -(_e7244[1]);
                                                                    } else {
                                                                        phi_4651_ = _e7244[1];
                                                                    }
                                                                    let _e7255 = phi_4651_;
                                                                    if (_e7251 > _e7255) {
                                                                        phi_4656_ = _e7251;
                                                                    } else {
                                                                        phi_4656_ = _e7255;
                                                                    }
                                                                    let _e7258 = phi_4656_;
                                                                    if (_e7244[2] < 0f) {
                                                                        phi_4663_ = -(_e7244[2]);
                                                                    } else {
                                                                        phi_4663_ = _e7244[2];
                                                                    }
                                                                    let _e7262 = phi_4663_;
                                                                    if (_e7258 > _e7262) {
                                                                        phi_4668_ = _e7258;
                                                                    } else {
                                                                        phi_4668_ = _e7262;
                                                                    }
                                                                    let _e7265 = phi_4668_;
                                                                    let _e7268 = local_18.member_2[1u];
                                                                    if (_e7268[0] < 0f) {
                                                                        phi_4682_ = -(_e7268[0]);
                                                                    } else {
                                                                        phi_4682_ = _e7268[0];
                                                                    }
                                                                    let _e7275 = phi_4682_;
                                                                    if (_e7268[1] < 0f) {
                                                                        phi_4689_ = -(_e7268[1]);
                                                                    } else {
                                                                        phi_4689_ = _e7268[1];
                                                                    }
                                                                    let _e7279 = phi_4689_;
                                                                    if (_e7275 > _e7279) {
                                                                        phi_4694_ = _e7275;
                                                                    } else {
                                                                        phi_4694_ = _e7279;
                                                                    }
                                                                    let _e7282 = phi_4694_;
                                                                    if (_e7268[2] < 0f) {
                                                                        phi_4701_ = -(_e7268[2]);
                                                                    } else {
                                                                        phi_4701_ = _e7268[2];
                                                                    }
                                                                    let _e7286 = phi_4701_;
                                                                    if (_e7282 > _e7286) {
                                                                        phi_4706_ = _e7282;
                                                                    } else {
                                                                        phi_4706_ = _e7286;
                                                                    }
                                                                    let _e7289 = phi_4706_;
                                                                    if (_e7265 > _e7289) {
                                                                        phi_4711_ = _e7265;
                                                                    } else {
                                                                        phi_4711_ = _e7289;
                                                                    }
                                                                    let _e7292 = phi_4711_;
                                                                    let _e7294 = local_18.member_3;
                                                                    let _e7301 = local_18.member_3;
                                                                    if (((_e7130 * (1f + (0.000000059604645f * 8f))) + (((((((_e7184 + _e7186) + (_e7238 + _e7240)) + (_e7292 + _e7294)) * (0.000000059604645f * 16f)) + (_e7301 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e521.member_1) {
                                                                        phi_4731_ = false;
                                                                    } else {
                                                                        phi_4731_ = true;
                                                                    }
                                                                    let _e7310 = phi_4731_;
                                                                    phi_4732_ = _e7310;
                                                                } else {
                                                                    phi_4732_ = true;
                                                                }
                                                                let _e7312 = phi_4732_;
                                                                phi_4733_ = _e7312;
                                                            } else {
                                                                phi_4733_ = true;
                                                            }
                                                            let _e7314 = phi_4733_;
                                                            if _e7314 {
                                                                if _e6222 {
                                                                    if _e6991 {
                                                                        phi_4749_ = true;
                                                                    } else {
                                                                        if (_e6990 <= (_e6218 * 0.25f)) {
                                                                            phi_4748_ = false;
                                                                        } else {
                                                                            phi_4748_ = true;
                                                                        }
                                                                        let _e7319 = phi_4748_;
                                                                        phi_4749_ = _e7319;
                                                                    }
                                                                    let _e7321 = phi_4749_;
                                                                    if _e7321 {
                                                                        phi_4754_ = (_e6536 + _e6536);
                                                                    } else {
                                                                        phi_4754_ = 0f;
                                                                    }
                                                                    let _e7324 = phi_4754_;
                                                                    phi_4756_ = _e7324;
                                                                } else {
                                                                    phi_4756_ = (_e321 - _e6214);
                                                                }
                                                                let _e7326 = phi_4756_;
                                                                phi_4757_ = _e7326;
                                                                phi_4758_ = false;
                                                            } else {
                                                                phi_4757_ = f32();
                                                                phi_4758_ = true;
                                                            }
                                                            let _e7328 = phi_4757_;
                                                            let _e7330 = phi_4758_;
                                                            phi_4759_ = _e7328;
                                                            phi_4760_ = _e6990;
                                                            phi_4761_ = _e7314;
                                                            phi_4762_ = _e7330;
                                                        }
                                                        let _e7332 = phi_4759_;
                                                        let _e7334 = phi_4760_;
                                                        let _e7336 = phi_4761_;
                                                        let _e7338 = phi_4762_;
                                                        phi_4763_ = _e6988;
                                                        phi_4764_ = _e7332;
                                                        phi_4765_ = _e7334;
                                                        phi_4766_ = _e6988;
                                                        phi_4767_ = _e7336;
                                                        phi_4768_ = _e6989;
                                                        phi_4769_ = _e7338;
                                                        phi_4770_ = false;
                                                    } else {
                                                        phi_4763_ = f32();
                                                        phi_4764_ = f32();
                                                        phi_4765_ = f32();
                                                        phi_4766_ = f32();
                                                        phi_4767_ = false;
                                                        phi_4768_ = false;
                                                        phi_4769_ = false;
                                                        phi_4770_ = true;
                                                    }
                                                    let _e7340 = phi_4763_;
                                                    let _e7342 = phi_4764_;
                                                    let _e7344 = phi_4765_;
                                                    let _e7346 = phi_4766_;
                                                    let _e7348 = phi_4767_;
                                                    let _e7350 = phi_4768_;
                                                    let _e7352 = phi_4769_;
                                                    let _e7354 = phi_4770_;
                                                    phi_4771_ = _e7340;
                                                    phi_4772_ = _e7342;
                                                    phi_4773_ = _e7344;
                                                    phi_4774_ = _e7346;
                                                    phi_4775_ = false;
                                                    phi_4776_ = _e7348;
                                                    phi_4777_ = _e7350;
                                                    phi_4778_ = _e7352;
                                                    phi_4779_ = _e7354;
                                                } else {
                                                    phi_4771_ = f32();
                                                    phi_4772_ = f32();
                                                    phi_4773_ = f32();
                                                    phi_4774_ = f32();
                                                    phi_4775_ = true;
                                                    phi_4776_ = false;
                                                    phi_4777_ = false;
                                                    phi_4778_ = false;
                                                    phi_4779_ = false;
                                                }
                                                let _e7356 = phi_4771_;
                                                let _e7358 = phi_4772_;
                                                let _e7360 = phi_4773_;
                                                let _e7362 = phi_4774_;
                                                let _e7364 = phi_4775_;
                                                let _e7366 = phi_4776_;
                                                let _e7368 = phi_4777_;
                                                let _e7370 = phi_4778_;
                                                let _e7372 = phi_4779_;
                                                phi_4780_ = _e7356;
                                                phi_4781_ = _e7358;
                                                phi_4782_ = _e7360;
                                                phi_4783_ = _e7362;
                                                phi_4784_ = _e7364;
                                                phi_4785_ = _e7366;
                                                phi_4786_ = _e7368;
                                                phi_4787_ = _e7370;
                                                phi_4788_ = _e7372;
                                            } else {
                                                phi_4780_ = f32();
                                                phi_4781_ = f32();
                                                phi_4782_ = f32();
                                                phi_4783_ = f32();
                                                phi_4784_ = true;
                                                phi_4785_ = false;
                                                phi_4786_ = false;
                                                phi_4787_ = false;
                                                phi_4788_ = false;
                                            }
                                            let _e7374 = phi_4780_;
                                            let _e7376 = phi_4781_;
                                            let _e7378 = phi_4782_;
                                            let _e7380 = phi_4783_;
                                            let _e7382 = phi_4784_;
                                            let _e7384 = phi_4785_;
                                            let _e7386 = phi_4786_;
                                            let _e7388 = phi_4787_;
                                            let _e7390 = phi_4788_;
                                            if _e7382 {
                                                if (_e6214 <= _e6216) {
                                                    let _e7551 = (_e6224 + 1u);
                                                    let _e7552 = (_e7551 > 3u);
                                                    if _e7552 {
                                                        phi_4801_ = false;
                                                    } else {
                                                        phi_4801_ = true;
                                                    }
                                                    let _e7554 = phi_4801_;
                                                    phi_5123_ = _e7551;
                                                    phi_5124_ = f32();
                                                    phi_5125_ = false;
                                                    phi_5126_ = _e7554;
                                                    phi_5127_ = _e7552;
                                                } else {
                                                    let _e7394 = local_16.member[0u];
                                                    let _e7397 = local_16.member_1[0u];
                                                    let _e7400 = local_16.member[0u];
                                                    let _e7406 = local_16.member_2[0u];
                                                    let _e7407 = ((_e7394 + ((_e7397 - _e7400) * _e6220)) - _e7406);
                                                    let _e7410 = local_16.member[1u];
                                                    let _e7413 = local_16.member_1[1u];
                                                    let _e7416 = local_16.member[1u];
                                                    let _e7422 = local_16.member_2[1u];
                                                    let _e7423 = ((_e7410 + ((_e7413 - _e7416) * _e6220)) - _e7422);
                                                    if (_e7407 < _e7423) {
                                                        phi_4874_ = _e7407;
                                                    } else {
                                                        phi_4874_ = _e7423;
                                                    }
                                                    let _e7426 = phi_4874_;
                                                    let _e7429 = local_16.member[2u];
                                                    let _e7432 = local_16.member_1[2u];
                                                    let _e7435 = local_16.member[2u];
                                                    let _e7441 = local_16.member_2[2u];
                                                    let _e7442 = ((_e7429 + ((_e7432 - _e7435) * _e6220)) - _e7441);
                                                    let _e7445 = local_16.member[3u];
                                                    let _e7448 = local_16.member_1[3u];
                                                    let _e7451 = local_16.member[3u];
                                                    let _e7457 = local_16.member_2[3u];
                                                    let _e7458 = ((_e7445 + ((_e7448 - _e7451) * _e6220)) - _e7457);
                                                    if (_e7442 < _e7458) {
                                                        phi_4947_ = _e7442;
                                                    } else {
                                                        phi_4947_ = _e7458;
                                                    }
                                                    let _e7461 = phi_4947_;
                                                    if (_e7426 < _e7461) {
                                                        phi_4952_ = _e7426;
                                                    } else {
                                                        phi_4952_ = _e7461;
                                                    }
                                                    let _e7464 = phi_4952_;
                                                    let _e7467 = local_17.member[0u];
                                                    let _e7470 = local_17.member_1[0u];
                                                    let _e7473 = local_17.member[0u];
                                                    let _e7479 = local_17.member_2[0u];
                                                    let _e7480 = ((_e7467 + ((_e7470 - _e7473) * _e6214)) - _e7479);
                                                    let _e7483 = local_17.member[1u];
                                                    let _e7486 = local_17.member_1[1u];
                                                    let _e7489 = local_17.member[1u];
                                                    let _e7495 = local_17.member_2[1u];
                                                    let _e7496 = ((_e7483 + ((_e7486 - _e7489) * _e6214)) - _e7495);
                                                    if (_e7480 < _e7496) {
                                                        phi_5025_ = _e7480;
                                                    } else {
                                                        phi_5025_ = _e7496;
                                                    }
                                                    let _e7499 = phi_5025_;
                                                    let _e7502 = local_17.member[2u];
                                                    let _e7505 = local_17.member_1[2u];
                                                    let _e7508 = local_17.member[2u];
                                                    let _e7514 = local_17.member_2[2u];
                                                    let _e7515 = ((_e7502 + ((_e7505 - _e7508) * _e6214)) - _e7514);
                                                    let _e7518 = local_17.member[3u];
                                                    let _e7521 = local_17.member_1[3u];
                                                    let _e7524 = local_17.member[3u];
                                                    let _e7530 = local_17.member_2[3u];
                                                    let _e7531 = ((_e7518 + ((_e7521 - _e7524) * _e6214)) - _e7530);
                                                    if (_e7515 < _e7531) {
                                                        phi_5098_ = _e7515;
                                                    } else {
                                                        phi_5098_ = _e7531;
                                                    }
                                                    let _e7534 = phi_5098_;
                                                    if (_e7499 < _e7534) {
                                                        phi_5103_ = _e7499;
                                                    } else {
                                                        phi_5103_ = _e7534;
                                                    }
                                                    let _e7537 = phi_5103_;
                                                    if (_e7537 > 0f) {
                                                        phi_5121_ = 0.5f;
                                                    } else {
                                                        let _e7541 = (0.95f * (_e7464 / (_e7464 - _e7537)));
                                                        if (_e7541 > 0.0625f) {
                                                            if (_e7541 < 0.9f) {
                                                                phi_5119_ = _e7541;
                                                            } else {
                                                                phi_5119_ = 0.9f;
                                                            }
                                                            let _e7545 = phi_5119_;
                                                            phi_5120_ = _e7545;
                                                        } else {
                                                            phi_5120_ = 0.0625f;
                                                        }
                                                        let _e7547 = phi_5120_;
                                                        phi_5121_ = _e7547;
                                                    }
                                                    let _e7549 = phi_5121_;
                                                    phi_5123_ = u32();
                                                    phi_5124_ = (_e6536 * _e7549);
                                                    phi_5125_ = true;
                                                    phi_5126_ = false;
                                                    phi_5127_ = false;
                                                }
                                                let _e7556 = phi_5123_;
                                                let _e7558 = phi_5124_;
                                                let _e7560 = phi_5125_;
                                                let _e7562 = phi_5126_;
                                                let _e7564 = phi_5127_;
                                                phi_5128_ = _e7556;
                                                phi_5129_ = _e6216;
                                                phi_5130_ = _e7558;
                                                phi_5131_ = _e6218;
                                                phi_5132_ = _e6220;
                                                phi_5133_ = _e6222;
                                                phi_5134_ = _e6224;
                                                phi_5135_ = _e7560;
                                                phi_5136_ = _e7562;
                                                phi_5137_ = _e7564;
                                                phi_5138_ = false;
                                                phi_5139_ = false;
                                                phi_5140_ = false;
                                            } else {
                                                phi_5128_ = u32();
                                                phi_5129_ = _e7374;
                                                phi_5130_ = _e7376;
                                                phi_5131_ = _e7378;
                                                phi_5132_ = _e6214;
                                                phi_5133_ = true;
                                                phi_5134_ = 0u;
                                                phi_5135_ = _e7384;
                                                phi_5136_ = false;
                                                phi_5137_ = false;
                                                phi_5138_ = _e7386;
                                                phi_5139_ = _e7388;
                                                phi_5140_ = _e7390;
                                            }
                                            let _e7566 = phi_5128_;
                                            let _e7568 = phi_5129_;
                                            let _e7570 = phi_5130_;
                                            let _e7572 = phi_5131_;
                                            let _e7574 = phi_5132_;
                                            let _e7576 = phi_5133_;
                                            let _e7578 = phi_5134_;
                                            let _e7580 = phi_5135_;
                                            let _e7582 = phi_5136_;
                                            let _e7584 = phi_5137_;
                                            let _e7586 = phi_5138_;
                                            let _e7588 = phi_5139_;
                                            let _e7590 = phi_5140_;
                                            if _e7580 {
                                                let _e7591 = (_e7574 + _e7570);
                                                if (_e7591 > _e7568) {
                                                    phi_5149_ = _e7591;
                                                } else {
                                                    phi_5149_ = _e7568;
                                                }
                                                let _e7594 = phi_5149_;
                                                if (_e7594 < _e321) {
                                                    phi_5154_ = _e7594;
                                                } else {
                                                    phi_5154_ = _e321;
                                                }
                                                let _e7597 = phi_5154_;
                                                if !(_e6222) {
                                                    phi_5163_ = true;
                                                } else {
                                                    phi_5163_ = ((_e7597 - _e7574) > _e6209);
                                                }
                                                let _e7601 = phi_5163_;
                                                if _e7601 {
                                                    phi_5167_ = false;
                                                } else {
                                                    phi_5167_ = true;
                                                }
                                                let _e7603 = phi_5167_;
                                                phi_5168_ = _e7597;
                                                phi_5169_ = _e7568;
                                                phi_5170_ = _e7572;
                                                phi_5171_ = _e7574;
                                                phi_5172_ = _e7576;
                                                phi_5173_ = _e7578;
                                                phi_5174_ = _e7601;
                                                phi_5175_ = _e7603;
                                                phi_5176_ = false;
                                                phi_5177_ = false;
                                                phi_5178_ = false;
                                                phi_5179_ = false;
                                            } else {
                                                phi_5168_ = _e6214;
                                                phi_5169_ = _e6216;
                                                phi_5170_ = _e6218;
                                                phi_5171_ = _e6220;
                                                phi_5172_ = _e6222;
                                                phi_5173_ = _e7566;
                                                phi_5174_ = _e7582;
                                                phi_5175_ = false;
                                                phi_5176_ = _e7584;
                                                phi_5177_ = _e7586;
                                                phi_5178_ = _e7588;
                                                phi_5179_ = _e7590;
                                            }
                                            let _e7605 = phi_5168_;
                                            let _e7607 = phi_5169_;
                                            let _e7609 = phi_5170_;
                                            let _e7611 = phi_5171_;
                                            let _e7613 = phi_5172_;
                                            let _e7615 = phi_5173_;
                                            let _e7617 = phi_5174_;
                                            let _e7619 = phi_5175_;
                                            let _e7621 = phi_5176_;
                                            let _e7623 = phi_5177_;
                                            let _e7625 = phi_5178_;
                                            let _e7627 = phi_5179_;
                                            phi_3001_ = _e7605;
                                            phi_3003_ = _e7607;
                                            phi_3005_ = _e7609;
                                            phi_3007_ = _e7611;
                                            phi_3009_ = _e7613;
                                            phi_3011_ = _e7615;
                                            phi_5180_ = _e7568;
                                            phi_5181_ = _e7380;
                                            phi_5182_ = _e7617;
                                            phi_5183_ = _e7619;
                                            phi_5184_ = _e7621;
                                            phi_5185_ = _e7623;
                                            phi_5186_ = _e7625;
                                            phi_5187_ = false;
                                            phi_5188_ = _e7627;
                                        } else {
                                            phi_3001_ = f32();
                                            phi_3003_ = f32();
                                            phi_3005_ = f32();
                                            phi_3007_ = f32();
                                            phi_3009_ = bool();
                                            phi_3011_ = u32();
                                            phi_5180_ = f32();
                                            phi_5181_ = f32();
                                            phi_5182_ = false;
                                            phi_5183_ = false;
                                            phi_5184_ = false;
                                            phi_5185_ = false;
                                            phi_5186_ = false;
                                            phi_5187_ = true;
                                            phi_5188_ = false;
                                        }
                                        let _e7629 = phi_3001_;
                                        let _e7631 = phi_3003_;
                                        let _e7633 = phi_3005_;
                                        let _e7635 = phi_3007_;
                                        let _e7637 = phi_3009_;
                                        let _e7639 = phi_3011_;
                                        let _e7641 = phi_5180_;
                                        let _e7643 = phi_5181_;
                                        let _e7645 = phi_5182_;
                                        let _e7647 = phi_5183_;
                                        let _e7649 = phi_5184_;
                                        let _e7651 = phi_5185_;
                                        let _e7653 = phi_5186_;
                                        let _e7655 = phi_5187_;
                                        let _e7657 = phi_5188_;
                                        local_42 = _e7647;
                                        local_78 = _e7649;
                                        local_79 = _e7651;
                                        local_80 = _e7653;
                                        local_81 = _e7655;
                                        local_82 = _e7657;
                                        local_83 = _e7647;
                                        local_84 = _e7643;
                                        local_85 = _e7641;
                                        continue;
                                        continuing {
                                            phi_2997_ = _e6236;
                                            phi_3000_ = _e7629;
                                            phi_3002_ = _e7631;
                                            phi_3004_ = _e7633;
                                            phi_3006_ = _e7635;
                                            phi_3008_ = _e7637;
                                            phi_3010_ = _e7639;
                                            break if !(_e7645);
                                        }
                                    }
                                    let _e7660 = local_42;
                                    if _e7660 {
                                        phi_5192_ = false;
                                        phi_5193_ = false;
                                        phi_5194_ = false;
                                        phi_5195_ = false;
                                        phi_5196_ = false;
                                    } else {
                                        let _e11119 = local_78;
                                        phi_5192_ = _e11119;
                                        let _e11122 = local_79;
                                        phi_5193_ = _e11122;
                                        let _e11125 = local_80;
                                        phi_5194_ = _e11125;
                                        let _e11128 = local_81;
                                        phi_5195_ = _e11128;
                                        let _e11131 = local_82;
                                        phi_5196_ = _e11131;
                                    }
                                    let _e7662 = phi_5192_;
                                    let _e7664 = phi_5193_;
                                    let _e7666 = phi_5194_;
                                    let _e7668 = phi_5195_;
                                    let _e7670 = phi_5196_;
                                    if _e7662 {
                                        let _e7672 = local_43;
                                        phi_5201_ = type_28(1u, _e7672);
                                        phi_5202_ = false;
                                        phi_5203_ = false;
                                        phi_5204_ = false;
                                        phi_5205_ = false;
                                        phi_5206_ = false;
                                    } else {
                                        phi_5201_ = type_28();
                                        phi_5202_ = _e7664;
                                        phi_5203_ = _e7666;
                                        let _e11138 = local_83;
                                        phi_5204_ = _e11138;
                                        phi_5205_ = _e7668;
                                        phi_5206_ = _e7670;
                                    }
                                    let _e7675 = phi_5201_;
                                    let _e7677 = phi_5202_;
                                    let _e7679 = phi_5203_;
                                    let _e7681 = phi_5204_;
                                    let _e7683 = phi_5205_;
                                    let _e7685 = phi_5206_;
                                    if _e7677 {
                                        phi_5211_ = type_28(0u, type_28().member_1);
                                        phi_5212_ = false;
                                        phi_5213_ = false;
                                        phi_5214_ = false;
                                        phi_5215_ = false;
                                        phi_5216_ = true;
                                    } else {
                                        phi_5211_ = _e7675;
                                        phi_5212_ = _e7679;
                                        phi_5213_ = _e7681;
                                        phi_5214_ = _e7683;
                                        phi_5215_ = _e7685;
                                        phi_5216_ = _e7662;
                                    }
                                    let _e7689 = phi_5211_;
                                    let _e7691 = phi_5212_;
                                    let _e7693 = phi_5213_;
                                    let _e7695 = phi_5214_;
                                    let _e7697 = phi_5215_;
                                    let _e7699 = phi_5216_;
                                    if _e7691 {
                                        let _e11149 = local_84;
                                        phi_5220_ = _e11149;
                                        phi_5221_ = true;
                                        phi_5222_ = false;
                                        phi_5223_ = false;
                                        phi_5224_ = false;
                                    } else {
                                        let _e11151 = local_85;
                                        phi_5220_ = _e11151;
                                        phi_5221_ = _e7693;
                                        phi_5222_ = _e7695;
                                        phi_5223_ = _e7697;
                                        phi_5224_ = _e7699;
                                    }
                                    let _e7701 = phi_5220_;
                                    let _e7703 = phi_5221_;
                                    let _e7705 = phi_5222_;
                                    let _e7707 = phi_5223_;
                                    let _e7709 = phi_5224_;
                                    if _e7703 {
                                        phi_5228_ = _e7701;
                                        phi_5229_ = true;
                                        phi_5230_ = false;
                                        phi_5231_ = false;
                                    } else {
                                        let _e11158 = local_86;
                                        phi_5228_ = _e11158;
                                        phi_5229_ = _e7705;
                                        phi_5230_ = _e7707;
                                        phi_5231_ = _e7709;
                                    }
                                    let _e7711 = phi_5228_;
                                    let _e7713 = phi_5229_;
                                    let _e7715 = phi_5230_;
                                    let _e7717 = phi_5231_;
                                    if _e7713 {
                                        phi_5236_ = type_28(1u, _e7711);
                                        phi_5237_ = false;
                                        phi_5238_ = false;
                                    } else {
                                        phi_5236_ = type_28();
                                        phi_5237_ = _e7715;
                                        phi_5238_ = _e7717;
                                    }
                                    let _e7720 = phi_5236_;
                                    let _e7722 = phi_5237_;
                                    let _e7724 = phi_5238_;
                                    if _e7722 {
                                        phi_5243_ = type_28(0u, type_28().member_1);
                                        phi_5244_ = true;
                                    } else {
                                        phi_5243_ = _e7689;
                                        phi_5244_ = _e7724;
                                    }
                                    let _e7728 = phi_5243_;
                                    let _e7730 = phi_5244_;
                                    if _e7730 {
                                        phi_5248_ = _e7728;
                                    } else {
                                        phi_5248_ = _e7720;
                                    }
                                    let _e7732 = phi_5248_;
                                    phi_5255_ = _e7732.member_1;
                                    phi_5256_ = (_e7732.member != 0u);
                                } else {
                                    phi_5255_ = _e5950;
                                    phi_5256_ = true;
                                }
                                let _e7737 = phi_5255_;
                                let _e7739 = phi_5256_;
                                if _e7739 {
                                    let _e7740 = (_e7737 > _e319);
                                    if _e7740 {
                                        phi_7421_ = f32();
                                        phi_7422_ = u32();
                                        phi_7423_ = f32();
                                        phi_7424_ = type_40();
                                        phi_7425_ = u32();
                                        phi_7426_ = u32();
                                        phi_7427_ = false;
                                        phi_7428_ = false;
                                        phi_7429_ = false;
                                    } else {
                                        let _e7743 = local_18.member[0u];
                                        let _e7749 = local_18.member[1u];
                                        let _e7765 = local_18.member_1[0u];
                                        let _e7771 = local_18.member_1[1u];
                                        let _e7787 = local_18.member_2[0u];
                                        let _e7793 = local_18.member_2[1u];
                                        let _e7807 = function_2(array<f32, 3>((_e7743[0] + ((_e7749[0] - _e7743[0]) * _e5954)), (_e7743[1] + ((_e7749[1] - _e7743[1]) * _e5954)), (_e7743[2] + ((_e7749[2] - _e7743[2]) * _e5954))), array<f32, 3>((_e7765[0] + ((_e7771[0] - _e7765[0]) * _e5954)), (_e7765[1] + ((_e7771[1] - _e7765[1]) * _e5954)), (_e7765[2] + ((_e7771[2] - _e7765[2]) * _e5954))), array<f32, 3>((_e7787[0] + ((_e7793[0] - _e7787[0]) * _e5954)), (_e7787[1] + ((_e7793[1] - _e7787[1]) * _e5954)), (_e7787[2] + ((_e7793[2] - _e7787[2]) * _e5954))), 0u);
                                        if (_e7807[0] < 0f) {
                                            phi_5368_ = -(_e7807[0]);
                                        } else {
                                            phi_5368_ = _e7807[0];
                                        }
                                        let _e7812 = phi_5368_;
                                        if (_e7807[1] < 0f) {
                                            phi_5375_ = -(_e7807[1]);
                                        } else {
                                            phi_5375_ = _e7807[1];
                                        }
                                        let _e7817 = phi_5375_;
                                        if (_e7807[2] < 0f) {
                                            phi_5383_ = -(_e7807[2]);
                                        } else {
                                            phi_5383_ = _e7807[2];
                                        }
                                        let _e7823 = phi_5383_;
                                        let _e7824 = ((_e7812 + _e7817) + _e7823);
                                        let _e7827 = local_18.member[0u];
                                        let _e7833 = local_18.member_1[0u];
                                        let _e7839 = local_18.member_2[0u];
                                        let _e7851 = local_18.member[1u];
                                        let _e7857 = local_18.member_1[1u];
                                        let _e7863 = local_18.member_2[1u];
                                        let _e7875 = local_18.member[0u];
                                        if (_e7875[0] < 0f) {
                                            phi_5534_ = -(_e7875[0]);
                                        } else {
                                            phi_5534_ = _e7875[0];
                                        }
                                        let _e7882 = phi_5534_;
                                        if (_e7875[1] < 0f) {
                                            phi_5541_ = -(_e7875[1]);
                                        } else {
                                            phi_5541_ = _e7875[1];
                                        }
                                        let _e7886 = phi_5541_;
                                        if (_e7882 > _e7886) {
                                            phi_5546_ = _e7882;
                                        } else {
                                            phi_5546_ = _e7886;
                                        }
                                        let _e7889 = phi_5546_;
                                        if (_e7875[2] < 0f) {
                                            phi_5553_ = -(_e7875[2]);
                                        } else {
                                            phi_5553_ = _e7875[2];
                                        }
                                        let _e7893 = phi_5553_;
                                        if (_e7889 > _e7893) {
                                            phi_5558_ = _e7889;
                                        } else {
                                            phi_5558_ = _e7893;
                                        }
                                        let _e7896 = phi_5558_;
                                        let _e7899 = local_18.member[1u];
                                        if (_e7899[0] < 0f) {
                                            phi_5571_ = -(_e7899[0]);
                                        } else {
                                            phi_5571_ = _e7899[0];
                                        }
                                        let _e7906 = phi_5571_;
                                        if (_e7899[1] < 0f) {
                                            phi_5578_ = -(_e7899[1]);
                                        } else {
                                            phi_5578_ = _e7899[1];
                                        }
                                        let _e7910 = phi_5578_;
                                        if (_e7906 > _e7910) {
                                            phi_5583_ = _e7906;
                                        } else {
                                            phi_5583_ = _e7910;
                                        }
                                        let _e7913 = phi_5583_;
                                        if (_e7899[2] < 0f) {
                                            phi_5590_ = -(_e7899[2]);
                                        } else {
                                            phi_5590_ = _e7899[2];
                                        }
                                        let _e7917 = phi_5590_;
                                        if (_e7913 > _e7917) {
                                            phi_5595_ = _e7913;
                                        } else {
                                            phi_5595_ = _e7917;
                                        }
                                        let _e7920 = phi_5595_;
                                        if (_e7896 > _e7920) {
                                            phi_5600_ = _e7896;
                                        } else {
                                            phi_5600_ = _e7920;
                                        }
                                        let _e7923 = phi_5600_;
                                        let _e7925 = local_18.member_3;
                                        let _e7929 = local_18.member_1[0u];
                                        if (_e7929[0] < 0f) {
                                            phi_5617_ = -(_e7929[0]);
                                        } else {
                                            phi_5617_ = _e7929[0];
                                        }
                                        let _e7936 = phi_5617_;
                                        if (_e7929[1] < 0f) {
                                            phi_5624_ = -(_e7929[1]);
                                        } else {
                                            phi_5624_ = _e7929[1];
                                        }
                                        let _e7940 = phi_5624_;
                                        if (_e7936 > _e7940) {
                                            phi_5629_ = _e7936;
                                        } else {
                                            phi_5629_ = _e7940;
                                        }
                                        let _e7943 = phi_5629_;
                                        if (_e7929[2] < 0f) {
                                            phi_5636_ = -(_e7929[2]);
                                        } else {
                                            phi_5636_ = _e7929[2];
                                        }
                                        let _e7947 = phi_5636_;
                                        if (_e7943 > _e7947) {
                                            phi_5641_ = _e7943;
                                        } else {
                                            phi_5641_ = _e7947;
                                        }
                                        let _e7950 = phi_5641_;
                                        let _e7953 = local_18.member_1[1u];
                                        if (_e7953[0] < 0f) {
                                            phi_5655_ = -(_e7953[0]);
                                        } else {
                                            phi_5655_ = _e7953[0];
                                        }
                                        let _e7960 = phi_5655_;
                                        if (_e7953[1] < 0f) {
                                            phi_5662_ = -(_e7953[1]);
                                        } else {
                                            phi_5662_ = _e7953[1];
                                        }
                                        let _e7964 = phi_5662_;
                                        if (_e7960 > _e7964) {
                                            phi_5667_ = _e7960;
                                        } else {
                                            phi_5667_ = _e7964;
                                        }
                                        let _e7967 = phi_5667_;
                                        if (_e7953[2] < 0f) {
                                            phi_5674_ = -(_e7953[2]);
                                        } else {
                                            phi_5674_ = _e7953[2];
                                        }
                                        let _e7971 = phi_5674_;
                                        if (_e7967 > _e7971) {
                                            phi_5679_ = _e7967;
                                        } else {
                                            phi_5679_ = _e7971;
                                        }
                                        let _e7974 = phi_5679_;
                                        if (_e7950 > _e7974) {
                                            phi_5684_ = _e7950;
                                        } else {
                                            phi_5684_ = _e7974;
                                        }
                                        let _e7977 = phi_5684_;
                                        let _e7979 = local_18.member_3;
                                        let _e7983 = local_18.member_2[0u];
                                        if (_e7983[0] < 0f) {
                                            phi_5701_ = -(_e7983[0]);
                                        } else {
                                            phi_5701_ = _e7983[0];
                                        }
                                        let _e7990 = phi_5701_;
                                        if (_e7983[1] < 0f) {
                                            phi_5708_ = -(_e7983[1]);
                                        } else {
                                            phi_5708_ = _e7983[1];
                                        }
                                        let _e7994 = phi_5708_;
                                        if (_e7990 > _e7994) {
                                            phi_5713_ = _e7990;
                                        } else {
                                            phi_5713_ = _e7994;
                                        }
                                        let _e7997 = phi_5713_;
                                        if (_e7983[2] < 0f) {
                                            phi_5720_ = -(_e7983[2]);
                                        } else {
                                            phi_5720_ = _e7983[2];
                                        }
                                        let _e8001 = phi_5720_;
                                        if (_e7997 > _e8001) {
                                            phi_5725_ = _e7997;
                                        } else {
                                            phi_5725_ = _e8001;
                                        }
                                        let _e8004 = phi_5725_;
                                        let _e8007 = local_18.member_2[1u];
                                        if (_e8007[0] < 0f) {
                                            phi_5739_ = -(_e8007[0]);
                                        } else {
                                            phi_5739_ = _e8007[0];
                                        }
                                        let _e8014 = phi_5739_;
                                        if (_e8007[1] < 0f) {
                                            phi_5746_ = -(_e8007[1]);
                                        } else {
                                            phi_5746_ = _e8007[1];
                                        }
                                        let _e8018 = phi_5746_;
                                        if (_e8014 > _e8018) {
                                            phi_5751_ = _e8014;
                                        } else {
                                            phi_5751_ = _e8018;
                                        }
                                        let _e8021 = phi_5751_;
                                        if (_e8007[2] < 0f) {
                                            phi_5758_ = -(_e8007[2]);
                                        } else {
                                            phi_5758_ = _e8007[2];
                                        }
                                        let _e8025 = phi_5758_;
                                        if (_e8021 > _e8025) {
                                            phi_5763_ = _e8021;
                                        } else {
                                            phi_5763_ = _e8025;
                                        }
                                        let _e8028 = phi_5763_;
                                        if (_e8004 > _e8028) {
                                            phi_5768_ = _e8004;
                                        } else {
                                            phi_5768_ = _e8028;
                                        }
                                        let _e8031 = phi_5768_;
                                        let _e8033 = local_18.member_3;
                                        let _e8040 = local_18.member_3;
                                        local_14 = type_37(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e7827, array<f32, 3>((_e7827[0] - _e7833[0]), (_e7827[1] - _e7833[1]), (_e7827[2] - _e7833[2])), array<f32, 3>((_e7827[0] - _e7839[0]), (_e7827[1] - _e7839[1]), (_e7827[2] - _e7839[2])), _e7827), array<array<f32, 3>, 4>(_e7851, array<f32, 3>((_e7851[0] - _e7857[0]), (_e7851[1] - _e7857[1]), (_e7851[2] - _e7857[2])), array<f32, 3>((_e7851[0] - _e7863[0]), (_e7851[1] - _e7863[1]), (_e7851[2] - _e7863[2])), _e7851)), ((((((_e7923 + _e7925) + (_e7977 + _e7979)) + (_e8031 + _e8033)) * (0.000000059604645f * 16f)) + (_e8040 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e521.member_1);
                                        let _e8054 = local_14.member_1;
                                        if (_e7824 > _e8054) {
                                            if ((bitcast<u32>(_e7824) & 2139095040u) != 2139095040u) {
                                                let _e8059 = (1f / _e7824);
                                                let _e8061 = (_e7807[0] * _e8059);
                                                let _e8063 = (_e7807[1] * _e8059);
                                                let _e8065 = (_e7807[2] * _e8059);
                                                let _e8070 = (((_e8061 * _e8061) + (_e8063 * _e8063)) + (_e8065 * _e8065));
                                                if (_e8070 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8070 > 0f) {
                                                        phi_5869_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5869_ = 0f;
                                                    }
                                                    let _e8123 = phi_5869_;
                                                    phi_5933_ = _e8123;
                                                } else {
                                                    phi_5876_ = type_14(0i, 5i);
                                                    phi_5879_ = bitcast<f32>(((bitcast<u32>(_e8070) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8078 = phi_5876_;
                                                        let _e8080 = phi_5879_;
                                                        local_44 = _e8080;
                                                        if (_e8078.member < _e8078.member_1) {
                                                            let _e8087 = (_e8078.member + 1i);
                                                            if ((false == (_e8087 > _e8078.member)) != false) {
                                                                phi_5900_ = true;
                                                            } else {
                                                                phi_5900_ = false;
                                                            }
                                                            let _e8092 = phi_5900_;
                                                            if _e8092 {
                                                                phi_5906_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_5906_ = type_15(1u, _e8087);
                                                            }
                                                            let _e8097 = phi_5906_;
                                                            phi_5877_ = type_14(_e8097.member_1, _e8078.member_1);
                                                            phi_5920_ = type_15(1u, _e8078.member);
                                                        } else {
                                                            phi_5877_ = _e8078;
                                                            phi_5920_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8103 = phi_5877_;
                                                        let _e8105 = phi_5920_;
                                                        let _e8108 = (bitcast<i32>(_e8105.member) != 0i);
                                                        if _e8108 {
                                                            phi_5880_ = (0.5f * (_e8080 + (_e8070 / _e8080)));
                                                        } else {
                                                            phi_5880_ = f32();
                                                        }
                                                        let _e8113 = phi_5880_;
                                                        continue;
                                                        continuing {
                                                            phi_5876_ = _e8103;
                                                            phi_5879_ = _e8113;
                                                            break if !(_e8108);
                                                        }
                                                    }
                                                    let _e8118 = local_44;
                                                    phi_5933_ = (_e8118 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8125 = phi_5933_;
                                                let _e8126 = (0.000000059604645f * 12f);
                                                let _e8128 = local_14.member_1;
                                                let _e8131 = local_14.member_2;
                                                let _e8135 = ((_e8128 * 1.01f) + ((_e8131 * _e8125) * (1f + _e8126)));
                                                let _e8139 = local_14.member[0u][0u];
                                                let _e8147 = (((_e8061 * _e8139[0]) + (_e8063 * _e8139[1])) + (_e8065 * _e8139[2]));
                                                let _e8151 = local_14.member[0u][1u];
                                                let _e8159 = (((_e8061 * _e8151[0]) + (_e8063 * _e8151[1])) + (_e8065 * _e8151[2]));
                                                let _e8163 = local_14.member[0u][2u];
                                                let _e8171 = (((_e8061 * _e8163[0]) + (_e8063 * _e8163[1])) + (_e8065 * _e8163[2]));
                                                let _e8175 = local_14.member[0u][3u];
                                                let _e8183 = (((_e8061 * _e8175[0]) + (_e8063 * _e8175[1])) + (_e8065 * _e8175[2]));
                                                let _e8187 = local_14.member[1u][0u];
                                                let _e8195 = (((_e8061 * _e8187[0]) + (_e8063 * _e8187[1])) + (_e8065 * _e8187[2]));
                                                let _e8199 = local_14.member[1u][1u];
                                                let _e8207 = (((_e8061 * _e8199[0]) + (_e8063 * _e8199[1])) + (_e8065 * _e8199[2]));
                                                let _e8211 = local_14.member[1u][2u];
                                                let _e8219 = (((_e8061 * _e8211[0]) + (_e8063 * _e8211[1])) + (_e8065 * _e8211[2]));
                                                let _e8223 = local_14.member[1u][3u];
                                                let _e8231 = (((_e8061 * _e8223[0]) + (_e8063 * _e8223[1])) + (_e8065 * _e8223[2]));
                                                if (_e8147 < 0f) {
                                                    phi_6067_ = -(_e8147);
                                                } else {
                                                    phi_6067_ = _e8147;
                                                }
                                                let _e8235 = phi_6067_;
                                                if (_e8195 < 0f) {
                                                    phi_6073_ = -(_e8195);
                                                } else {
                                                    phi_6073_ = _e8195;
                                                }
                                                let _e8239 = phi_6073_;
                                                if (_e8159 < 0f) {
                                                    phi_6082_ = -(_e8159);
                                                } else {
                                                    phi_6082_ = _e8159;
                                                }
                                                let _e8246 = phi_6082_;
                                                if (_e8207 < 0f) {
                                                    phi_6088_ = -(_e8207);
                                                } else {
                                                    phi_6088_ = _e8207;
                                                }
                                                let _e8250 = phi_6088_;
                                                if (_e8171 < 0f) {
                                                    phi_6097_ = -(_e8171);
                                                } else {
                                                    phi_6097_ = _e8171;
                                                }
                                                let _e8257 = phi_6097_;
                                                if (_e8219 < 0f) {
                                                    phi_6103_ = -(_e8219);
                                                } else {
                                                    phi_6103_ = _e8219;
                                                }
                                                let _e8261 = phi_6103_;
                                                if (_e8183 < 0f) {
                                                    phi_6112_ = -(_e8183);
                                                } else {
                                                    phi_6112_ = _e8183;
                                                }
                                                let _e8268 = phi_6112_;
                                                if (_e8231 < 0f) {
                                                    phi_6118_ = -(_e8231);
                                                } else {
                                                    phi_6118_ = _e8231;
                                                }
                                                let _e8272 = phi_6118_;
                                                local_15 = type_32(array<f32, 4>(_e8147, _e8159, _e8171, _e8183), array<f32, 4>(_e8195, _e8207, _e8219, _e8231), array<f32, 4>((_e8135 + ((_e8235 + _e8239) * _e8126)), (_e8135 + ((_e8246 + _e8250) * _e8126)), (_e8135 + ((_e8257 + _e8261) * _e8126)), (_e8135 + ((_e8268 + _e8272) * _e8126))));
                                                let _e8284 = (((_e8061 * _e8061) + (_e8063 * _e8063)) + (_e8065 * _e8065));
                                                if (_e8284 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8284 > 0f) {
                                                        phi_6161_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_6161_ = 0f;
                                                    }
                                                    let _e8337 = phi_6161_;
                                                    phi_6225_ = _e8337;
                                                } else {
                                                    phi_6168_ = type_14(0i, 5i);
                                                    phi_6171_ = bitcast<f32>(((bitcast<u32>(_e8284) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8292 = phi_6168_;
                                                        let _e8294 = phi_6171_;
                                                        local_45 = _e8294;
                                                        if (_e8292.member < _e8292.member_1) {
                                                            let _e8301 = (_e8292.member + 1i);
                                                            if ((false == (_e8301 > _e8292.member)) != false) {
                                                                phi_6192_ = true;
                                                            } else {
                                                                phi_6192_ = false;
                                                            }
                                                            let _e8306 = phi_6192_;
                                                            if _e8306 {
                                                                phi_6198_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_6198_ = type_15(1u, _e8301);
                                                            }
                                                            let _e8311 = phi_6198_;
                                                            phi_6169_ = type_14(_e8311.member_1, _e8292.member_1);
                                                            phi_6212_ = type_15(1u, _e8292.member);
                                                        } else {
                                                            phi_6169_ = _e8292;
                                                            phi_6212_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8317 = phi_6169_;
                                                        let _e8319 = phi_6212_;
                                                        let _e8322 = (bitcast<i32>(_e8319.member) != 0i);
                                                        if _e8322 {
                                                            phi_6172_ = (0.5f * (_e8294 + (_e8284 / _e8294)));
                                                        } else {
                                                            phi_6172_ = f32();
                                                        }
                                                        let _e8327 = phi_6172_;
                                                        continue;
                                                        continuing {
                                                            phi_6168_ = _e8317;
                                                            phi_6171_ = _e8327;
                                                            break if !(_e8322);
                                                        }
                                                    }
                                                    let _e8332 = local_45;
                                                    phi_6225_ = (_e8332 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8339 = phi_6225_;
                                                let _e8350 = (((_e7807[0] * _e7807[0]) + (_e7807[1] * _e7807[1])) + (_e7807[2] * _e7807[2]));
                                                if (_e8350 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8350 > 0f) {
                                                        phi_6250_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_6250_ = 0f;
                                                    }
                                                    let _e8403 = phi_6250_;
                                                    phi_6314_ = _e8403;
                                                } else {
                                                    phi_6257_ = type_14(0i, 5i);
                                                    phi_6260_ = bitcast<f32>(((bitcast<u32>(_e8350) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8358 = phi_6257_;
                                                        let _e8360 = phi_6260_;
                                                        local_46 = _e8360;
                                                        if (_e8358.member < _e8358.member_1) {
                                                            let _e8367 = (_e8358.member + 1i);
                                                            if ((false == (_e8367 > _e8358.member)) != false) {
                                                                phi_6281_ = true;
                                                            } else {
                                                                phi_6281_ = false;
                                                            }
                                                            let _e8372 = phi_6281_;
                                                            if _e8372 {
                                                                phi_6287_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_6287_ = type_15(1u, _e8367);
                                                            }
                                                            let _e8377 = phi_6287_;
                                                            phi_6258_ = type_14(_e8377.member_1, _e8358.member_1);
                                                            phi_6301_ = type_15(1u, _e8358.member);
                                                        } else {
                                                            phi_6258_ = _e8358;
                                                            phi_6301_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8383 = phi_6258_;
                                                        let _e8385 = phi_6301_;
                                                        let _e8388 = (bitcast<i32>(_e8385.member) != 0i);
                                                        if _e8388 {
                                                            phi_6261_ = (0.5f * (_e8360 + (_e8350 / _e8360)));
                                                        } else {
                                                            phi_6261_ = f32();
                                                        }
                                                        let _e8393 = phi_6261_;
                                                        continue;
                                                        continuing {
                                                            phi_6257_ = _e8383;
                                                            phi_6260_ = _e8393;
                                                            break if !(_e8388);
                                                        }
                                                    }
                                                    let _e8398 = local_46;
                                                    phi_6314_ = (_e8398 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8405 = phi_6314_;
                                                let _e8411 = local_18.member[0u];
                                                if (_e8411[0] < 0f) {
                                                    phi_6330_ = -(_e8411[0]);
                                                } else {
                                                    phi_6330_ = _e8411[0];
                                                }
                                                let _e8418 = phi_6330_;
                                                if (_e8411[1] < 0f) {
                                                    phi_6337_ = -(_e8411[1]);
                                                } else {
                                                    phi_6337_ = _e8411[1];
                                                }
                                                let _e8422 = phi_6337_;
                                                if (_e8418 > _e8422) {
                                                    phi_6342_ = _e8418;
                                                } else {
                                                    phi_6342_ = _e8422;
                                                }
                                                let _e8425 = phi_6342_;
                                                if (_e8411[2] < 0f) {
                                                    phi_6349_ = -(_e8411[2]);
                                                } else {
                                                    phi_6349_ = _e8411[2];
                                                }
                                                let _e8429 = phi_6349_;
                                                if (_e8425 > _e8429) {
                                                    phi_6354_ = _e8425;
                                                } else {
                                                    phi_6354_ = _e8429;
                                                }
                                                let _e8432 = phi_6354_;
                                                let _e8435 = local_18.member[1u];
                                                if (_e8435[0] < 0f) {
                                                    phi_6367_ = -(_e8435[0]);
                                                } else {
                                                    phi_6367_ = _e8435[0];
                                                }
                                                let _e8442 = phi_6367_;
                                                if (_e8435[1] < 0f) {
                                                    phi_6374_ = -(_e8435[1]);
                                                } else {
                                                    phi_6374_ = _e8435[1];
                                                }
                                                let _e8446 = phi_6374_;
                                                if (_e8442 > _e8446) {
                                                    phi_6379_ = _e8442;
                                                } else {
                                                    phi_6379_ = _e8446;
                                                }
                                                let _e8449 = phi_6379_;
                                                if (_e8435[2] < 0f) {
                                                    phi_6386_ = -(_e8435[2]);
                                                } else {
                                                    phi_6386_ = _e8435[2];
                                                }
                                                let _e8453 = phi_6386_;
                                                if (_e8449 > _e8453) {
                                                    phi_6391_ = _e8449;
                                                } else {
                                                    phi_6391_ = _e8453;
                                                }
                                                let _e8456 = phi_6391_;
                                                if (_e8432 > _e8456) {
                                                    phi_6396_ = _e8432;
                                                } else {
                                                    phi_6396_ = _e8456;
                                                }
                                                let _e8459 = phi_6396_;
                                                let _e8461 = local_18.member_3;
                                                let _e8465 = local_18.member_1[0u];
                                                if (_e8465[0] < 0f) {
                                                    phi_6413_ = -(_e8465[0]);
                                                } else {
                                                    phi_6413_ = _e8465[0];
                                                }
                                                let _e8472 = phi_6413_;
                                                if (_e8465[1] < 0f) {
                                                    phi_6420_ = -(_e8465[1]);
                                                } else {
                                                    phi_6420_ = _e8465[1];
                                                }
                                                let _e8476 = phi_6420_;
                                                if (_e8472 > _e8476) {
                                                    phi_6425_ = _e8472;
                                                } else {
                                                    phi_6425_ = _e8476;
                                                }
                                                let _e8479 = phi_6425_;
                                                if (_e8465[2] < 0f) {
                                                    phi_6432_ = -(_e8465[2]);
                                                } else {
                                                    phi_6432_ = _e8465[2];
                                                }
                                                let _e8483 = phi_6432_;
                                                if (_e8479 > _e8483) {
                                                    phi_6437_ = _e8479;
                                                } else {
                                                    phi_6437_ = _e8483;
                                                }
                                                let _e8486 = phi_6437_;
                                                let _e8489 = local_18.member_1[1u];
                                                if (_e8489[0] < 0f) {
                                                    phi_6451_ = -(_e8489[0]);
                                                } else {
                                                    phi_6451_ = _e8489[0];
                                                }
                                                let _e8496 = phi_6451_;
                                                if (_e8489[1] < 0f) {
                                                    phi_6458_ = -(_e8489[1]);
                                                } else {
                                                    phi_6458_ = _e8489[1];
                                                }
                                                let _e8500 = phi_6458_;
                                                if (_e8496 > _e8500) {
                                                    phi_6463_ = _e8496;
                                                } else {
                                                    phi_6463_ = _e8500;
                                                }
                                                let _e8503 = phi_6463_;
                                                if (_e8489[2] < 0f) {
                                                    phi_6470_ = -(_e8489[2]);
                                                } else {
                                                    phi_6470_ = _e8489[2];
                                                }
                                                let _e8507 = phi_6470_;
                                                if (_e8503 > _e8507) {
                                                    phi_6475_ = _e8503;
                                                } else {
                                                    phi_6475_ = _e8507;
                                                }
                                                let _e8510 = phi_6475_;
                                                if (_e8486 > _e8510) {
                                                    phi_6480_ = _e8486;
                                                } else {
                                                    phi_6480_ = _e8510;
                                                }
                                                let _e8513 = phi_6480_;
                                                let _e8515 = local_18.member_3;
                                                let _e8519 = local_18.member_2[0u];
                                                if (_e8519[0] < 0f) {
                                                    phi_6497_ = -(_e8519[0]);
                                                } else {
                                                    phi_6497_ = _e8519[0];
                                                }
                                                let _e8526 = phi_6497_;
                                                if (_e8519[1] < 0f) {
                                                    phi_6504_ = -(_e8519[1]);
                                                } else {
                                                    phi_6504_ = _e8519[1];
                                                }
                                                let _e8530 = phi_6504_;
                                                if (_e8526 > _e8530) {
                                                    phi_6509_ = _e8526;
                                                } else {
                                                    phi_6509_ = _e8530;
                                                }
                                                let _e8533 = phi_6509_;
                                                if (_e8519[2] < 0f) {
                                                    phi_6516_ = -(_e8519[2]);
                                                } else {
                                                    phi_6516_ = _e8519[2];
                                                }
                                                let _e8537 = phi_6516_;
                                                if (_e8533 > _e8537) {
                                                    phi_6521_ = _e8533;
                                                } else {
                                                    phi_6521_ = _e8537;
                                                }
                                                let _e8540 = phi_6521_;
                                                let _e8543 = local_18.member_2[1u];
                                                if (_e8543[0] < 0f) {
                                                    phi_6535_ = -(_e8543[0]);
                                                } else {
                                                    phi_6535_ = _e8543[0];
                                                }
                                                let _e8550 = phi_6535_;
                                                if (_e8543[1] < 0f) {
                                                    phi_6542_ = -(_e8543[1]);
                                                } else {
                                                    phi_6542_ = _e8543[1];
                                                }
                                                let _e8554 = phi_6542_;
                                                if (_e8550 > _e8554) {
                                                    phi_6547_ = _e8550;
                                                } else {
                                                    phi_6547_ = _e8554;
                                                }
                                                let _e8557 = phi_6547_;
                                                if (_e8543[2] < 0f) {
                                                    phi_6554_ = -(_e8543[2]);
                                                } else {
                                                    phi_6554_ = _e8543[2];
                                                }
                                                let _e8561 = phi_6554_;
                                                if (_e8557 > _e8561) {
                                                    phi_6559_ = _e8557;
                                                } else {
                                                    phi_6559_ = _e8561;
                                                }
                                                let _e8564 = phi_6559_;
                                                if (_e8540 > _e8564) {
                                                    phi_6564_ = _e8540;
                                                } else {
                                                    phi_6564_ = _e8564;
                                                }
                                                let _e8567 = phi_6564_;
                                                let _e8569 = local_18.member_3;
                                                let _e8576 = local_18.member_3;
                                                let _e8586 = ((((_e8405 * (1f + (0.000000059604645f * 8f))) + (((((((_e8459 + _e8461) + (_e8513 + _e8515)) + (_e8567 + _e8569)) * (0.000000059604645f * 16f)) + (_e8576 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e8339) * (1f + (0.000000059604645f * 64f)));
                                                let _e8589 = local_15.member[0u];
                                                let _e8592 = local_15.member_1[0u];
                                                if (_e8589 < 0f) {
                                                    phi_6605_ = -(_e8589);
                                                } else {
                                                    phi_6605_ = _e8589;
                                                }
                                                let _e8597 = phi_6605_;
                                                if (_e8592 < 0f) {
                                                    phi_6611_ = -(_e8592);
                                                } else {
                                                    phi_6611_ = _e8592;
                                                }
                                                let _e8601 = phi_6611_;
                                                phi_6622_ = type_12(1u, 4u);
                                                phi_6625_ = ((_e8589 + ((_e8592 - _e8589) * _e5954)) - ((_e8054 * 1.01f) + ((_e8597 + _e8601) * (0.000000059604645f * 12f))));
                                                loop {
                                                    let _e8611 = phi_6622_;
                                                    let _e8613 = phi_6625_;
                                                    local_47 = _e8613;
                                                    local_48 = _e8613;
                                                    if (_e8611.member < _e8611.member_1) {
                                                        phi_6623_ = type_12((_e8611.member + 1u), _e8611.member_1);
                                                        phi_6648_ = type_12(1u, _e8611.member);
                                                    } else {
                                                        phi_6623_ = _e8611;
                                                        phi_6648_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e8625 = phi_6623_;
                                                    let _e8627 = phi_6648_;
                                                    let _e8631 = (bitcast<i32>(_e8627.member) != 0i);
                                                    if _e8631 {
                                                        let _e8634 = local_15.member[_e8627.member_1];
                                                        let _e8637 = local_15.member_1[_e8627.member_1];
                                                        if (_e8634 < 0f) {
                                                            phi_6677_ = -(_e8634);
                                                        } else {
                                                            phi_6677_ = _e8634;
                                                        }
                                                        let _e8642 = phi_6677_;
                                                        if (_e8637 < 0f) {
                                                            phi_6683_ = -(_e8637);
                                                        } else {
                                                            phi_6683_ = _e8637;
                                                        }
                                                        let _e8646 = phi_6683_;
                                                        let _e8654 = ((_e8634 + ((_e8637 - _e8634) * _e5954)) - ((_e8054 * 1.01f) + ((_e8642 + _e8646) * (0.000000059604645f * 12f))));
                                                        if (_e8613 < _e8654) {
                                                            phi_6696_ = _e8613;
                                                        } else {
                                                            phi_6696_ = _e8654;
                                                        }
                                                        let _e8657 = phi_6696_;
                                                        phi_6626_ = _e8657;
                                                    } else {
                                                        phi_6626_ = f32();
                                                    }
                                                    let _e8659 = phi_6626_;
                                                    continue;
                                                    continuing {
                                                        phi_6622_ = _e8625;
                                                        phi_6625_ = _e8659;
                                                        break if !(_e8631);
                                                    }
                                                }
                                                let _e8662 = local_47;
                                                if (_e8662 > 0f) {
                                                    let _e8666 = local_48;
                                                    let _e8669 = (((_e8586 - _e8666) / _e8586) * 2.02f);
                                                    if (_e8669 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e8669 > 0f) {
                                                            phi_6717_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_6717_ = 0f;
                                                        }
                                                        let _e8722 = phi_6717_;
                                                        phi_6781_ = _e8722;
                                                    } else {
                                                        phi_6724_ = type_14(0i, 5i);
                                                        phi_6727_ = bitcast<f32>(((bitcast<u32>(_e8669) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e8677 = phi_6724_;
                                                            let _e8679 = phi_6727_;
                                                            local_49 = _e8679;
                                                            if (_e8677.member < _e8677.member_1) {
                                                                let _e8686 = (_e8677.member + 1i);
                                                                if ((false == (_e8686 > _e8677.member)) != false) {
                                                                    phi_6748_ = true;
                                                                } else {
                                                                    phi_6748_ = false;
                                                                }
                                                                let _e8691 = phi_6748_;
                                                                if _e8691 {
                                                                    phi_6754_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_6754_ = type_15(1u, _e8686);
                                                                }
                                                                let _e8696 = phi_6754_;
                                                                phi_6725_ = type_14(_e8696.member_1, _e8677.member_1);
                                                                phi_6768_ = type_15(1u, _e8677.member);
                                                            } else {
                                                                phi_6725_ = _e8677;
                                                                phi_6768_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e8702 = phi_6725_;
                                                            let _e8704 = phi_6768_;
                                                            let _e8707 = (bitcast<i32>(_e8704.member) != 0i);
                                                            if _e8707 {
                                                                phi_6728_ = (0.5f * (_e8679 + (_e8669 / _e8679)));
                                                            } else {
                                                                phi_6728_ = f32();
                                                            }
                                                            let _e8712 = phi_6728_;
                                                            continue;
                                                            continuing {
                                                                phi_6724_ = _e8702;
                                                                phi_6727_ = _e8712;
                                                                break if !(_e8707);
                                                            }
                                                        }
                                                        let _e8717 = local_49;
                                                        phi_6781_ = (_e8717 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e8724 = phi_6781_;
                                                    let _e8726 = ((_e8724 * _e8339) * 1.01f);
                                                    phi_6786_ = type_12(0u, 4u);
                                                    phi_6789_ = 2f;
                                                    phi_6791_ = true;
                                                    phi_6793_ = true;
                                                    loop {
                                                        let _e8728 = phi_6786_;
                                                        let _e8730 = phi_6789_;
                                                        let _e8732 = phi_6791_;
                                                        let _e8734 = phi_6793_;
                                                        local_50 = _e8730;
                                                        local_87 = _e8730;
                                                        local_51 = _e8732;
                                                        local_52 = _e8734;
                                                        local_88 = _e8734;
                                                        local_53 = _e8734;
                                                        if (_e8728.member < _e8728.member_1) {
                                                            phi_6787_ = type_12((_e8728.member + 1u), _e8728.member_1);
                                                            phi_6816_ = type_12(1u, _e8728.member);
                                                        } else {
                                                            phi_6787_ = _e8728;
                                                            phi_6816_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e8746 = phi_6787_;
                                                        let _e8748 = phi_6816_;
                                                        let _e8752 = (bitcast<i32>(_e8748.member) != 0i);
                                                        if _e8752 {
                                                            let _e8756 = local_14.member[0u][_e8748.member_1];
                                                            let _e8763 = local_14.member[1u][_e8748.member_1];
                                                            if (_e8756[0] < 0f) {
                                                                phi_6853_ = -(_e8756[0]);
                                                            } else {
                                                                phi_6853_ = _e8756[0];
                                                            }
                                                            let _e8770 = phi_6853_;
                                                            if (_e8756[1] < 0f) {
                                                                phi_6860_ = -(_e8756[1]);
                                                            } else {
                                                                phi_6860_ = _e8756[1];
                                                            }
                                                            let _e8774 = phi_6860_;
                                                            if (_e8756[2] < 0f) {
                                                                phi_6868_ = -(_e8756[2]);
                                                            } else {
                                                                phi_6868_ = _e8756[2];
                                                            }
                                                            let _e8779 = phi_6868_;
                                                            let _e8780 = ((_e8770 + _e8774) + _e8779);
                                                            if (_e8763[0] < 0f) {
                                                                phi_6876_ = -(_e8763[0]);
                                                            } else {
                                                                phi_6876_ = _e8763[0];
                                                            }
                                                            let _e8784 = phi_6876_;
                                                            if (_e8763[1] < 0f) {
                                                                phi_6883_ = -(_e8763[1]);
                                                            } else {
                                                                phi_6883_ = _e8763[1];
                                                            }
                                                            let _e8788 = phi_6883_;
                                                            if (_e8763[2] < 0f) {
                                                                phi_6891_ = -(_e8763[2]);
                                                            } else {
                                                                phi_6891_ = _e8763[2];
                                                            }
                                                            let _e8793 = phi_6891_;
                                                            let _e8794 = ((_e8784 + _e8788) + _e8793);
                                                            if (_e8780 > _e8794) {
                                                                phi_6897_ = _e8780;
                                                            } else {
                                                                phi_6897_ = _e8794;
                                                            }
                                                            let _e8797 = phi_6897_;
                                                            let _e8801 = (_e8763[0] - _e8756[0]);
                                                            let _e8802 = (_e8763[1] - _e8756[1]);
                                                            let _e8803 = (_e8763[2] - _e8756[2]);
                                                            if (_e8801 < 0f) {
                                                                phi_6915_ = -(_e8801);
                                                            } else {
                                                                phi_6915_ = _e8801;
                                                            }
                                                            let _e8807 = phi_6915_;
                                                            if (_e8802 < 0f) {
                                                                phi_6921_ = -(_e8802);
                                                            } else {
                                                                phi_6921_ = _e8802;
                                                            }
                                                            let _e8811 = phi_6921_;
                                                            if (_e8803 < 0f) {
                                                                phi_6928_ = -(_e8803);
                                                            } else {
                                                                phi_6928_ = _e8803;
                                                            }
                                                            let _e8816 = phi_6928_;
                                                            let _e8823 = local_15.member[_e8748.member_1];
                                                            let _e8826 = local_15.member_1[_e8748.member_1];
                                                            if (_e8823 < 0f) {
                                                                phi_6954_ = -(_e8823);
                                                            } else {
                                                                phi_6954_ = _e8823;
                                                            }
                                                            let _e8831 = phi_6954_;
                                                            if (_e8826 < 0f) {
                                                                phi_6960_ = -(_e8826);
                                                            } else {
                                                                phi_6960_ = _e8826;
                                                            }
                                                            let _e8835 = phi_6960_;
                                                            let _e8839 = ((_e8054 * 1.01f) + ((_e8831 + _e8835) * (0.000000059604645f * 12f)));
                                                            let _e8846 = local_15.member_1[_e8748.member_1];
                                                            let _e8849 = local_15.member[_e8748.member_1];
                                                            let _e8850 = (_e8846 - _e8849);
                                                            let _e8853 = ((_e8839 + _e8839) + (_e8726 * ((((_e8807 + _e8811) + _e8816) + (_e8054 * 6f)) * 1.01f)));
                                                            let _e8856 = ((((_e8823 + ((_e8826 - _e8823) * _e5954)) - _e8839) - (_e8726 * ((_e8797 + (_e8054 * 3f)) * 1.01f))) - _e8586);
                                                            let _e8857 = (_e8856 > 0.000000000000000000000000000000000000011754944f);
                                                            let _e8858 = (_e8850 > _e8853);
                                                            if _e8858 {
                                                                phi_6996_ = true;
                                                            } else {
                                                                phi_6996_ = _e8857;
                                                            }
                                                            let _e8860 = phi_6996_;
                                                            if (_e8850 < -(_e8853)) {
                                                                phi_7003_ = true;
                                                            } else {
                                                                phi_7003_ = _e8857;
                                                            }
                                                            let _e8865 = phi_7003_;
                                                            if _e8858 {
                                                                phi_7024_ = _e8730;
                                                            } else {
                                                                if _e8857 {
                                                                    let _e8867 = (_e8853 - _e8850);
                                                                    if (_e8867 > 0.000000000000000000000000000000000000011754944f) {
                                                                        phi_7016_ = _e8867;
                                                                    } else {
                                                                        phi_7016_ = 0.000000000000000000000000000000000000011754944f;
                                                                    }
                                                                    let _e8870 = phi_7016_;
                                                                    let _e8871 = (_e8856 / _e8870);
                                                                    if (_e8730 < _e8871) {
                                                                        phi_7022_ = _e8730;
                                                                    } else {
                                                                        phi_7022_ = _e8871;
                                                                    }
                                                                    let _e8874 = phi_7022_;
                                                                    phi_7023_ = _e8874;
                                                                } else {
                                                                    phi_7023_ = _e8730;
                                                                }
                                                                let _e8876 = phi_7023_;
                                                                phi_7024_ = _e8876;
                                                            }
                                                            let _e8878 = phi_7024_;
                                                            phi_6790_ = _e8878;
                                                            phi_6792_ = (_e8732 && _e8865);
                                                            phi_6794_ = (_e8734 && _e8860);
                                                        } else {
                                                            phi_6790_ = f32();
                                                            phi_6792_ = bool();
                                                            phi_6794_ = bool();
                                                        }
                                                        let _e8880 = phi_6790_;
                                                        let _e8882 = phi_6792_;
                                                        let _e8884 = phi_6794_;
                                                        continue;
                                                        continuing {
                                                            phi_6786_ = _e8746;
                                                            phi_6789_ = _e8880;
                                                            phi_6791_ = _e8882;
                                                            phi_6793_ = _e8884;
                                                            break if !(_e8752);
                                                        }
                                                    }
                                                    let _e8887 = local_50;
                                                    if (_e8887 < 2f) {
                                                        let _e11329 = local_87;
                                                        phi_7029_ = _e11329;
                                                    } else {
                                                        phi_7029_ = 2f;
                                                    }
                                                    let _e8890 = phi_7029_;
                                                    let _e8891 = (_e8890 * 0.999f);
                                                    let _e8893 = local_51;
                                                    if _e8893 {
                                                        let _e8895 = local_52;
                                                        if _e8895 {
                                                            phi_7038_ = type_40();
                                                        } else {
                                                            phi_7038_ = type_40(1u, _e5954, 2f);
                                                        }
                                                        let _e8898 = phi_7038_;
                                                        phi_7039_ = _e8898;
                                                        let _e11336 = local_88;
                                                        phi_7040_ = _e11336;
                                                    } else {
                                                        phi_7039_ = type_40();
                                                        phi_7040_ = true;
                                                    }
                                                    let _e8900 = phi_7039_;
                                                    let _e8902 = phi_7040_;
                                                    if _e8902 {
                                                        let _e8904 = local_53;
                                                        if _e8904 {
                                                            if (_e8891 > (0.000000059604645f * 4096f)) {
                                                                let _e8908 = (_e5954 + _e8891);
                                                                if (_e8908 < _e321) {
                                                                    phi_7057_ = _e8908;
                                                                } else {
                                                                    phi_7057_ = _e321;
                                                                }
                                                                let _e8911 = phi_7057_;
                                                                phi_7058_ = _e8911;
                                                            } else {
                                                                phi_7058_ = _e5954;
                                                            }
                                                            let _e8913 = phi_7058_;
                                                            phi_7061_ = type_12(0u, 4u);
                                                            phi_7064_ = _e8913;
                                                            phi_7066_ = _e5954;
                                                            loop {
                                                                let _e8915 = phi_7061_;
                                                                let _e8917 = phi_7064_;
                                                                let _e8919 = phi_7066_;
                                                                local_54 = _e8917;
                                                                local_55 = _e8919;
                                                                local_56 = _e8919;
                                                                if (_e8915.member < _e8915.member_1) {
                                                                    phi_7062_ = type_12((_e8915.member + 1u), _e8915.member_1);
                                                                    phi_7089_ = type_12(1u, _e8915.member);
                                                                } else {
                                                                    phi_7062_ = _e8915;
                                                                    phi_7089_ = type_12(0u, type_12().member_1);
                                                                }
                                                                let _e8931 = phi_7062_;
                                                                let _e8933 = phi_7089_;
                                                                let _e8937 = (bitcast<i32>(_e8933.member) != 0i);
                                                                if _e8937 {
                                                                    let _e8940 = local_15.member[_e8933.member_1];
                                                                    let _e8943 = local_15.member_1[_e8933.member_1];
                                                                    let _e8946 = local_15.member[_e8933.member_1];
                                                                    let _e8952 = local_15.member_2[_e8933.member_1];
                                                                    let _e8953 = ((_e8940 + ((_e8943 - _e8946) * _e5954)) - _e8952);
                                                                    let _e8956 = local_15.member_1[_e8933.member_1];
                                                                    let _e8959 = local_15.member[_e8933.member_1];
                                                                    let _e8960 = (_e8956 - _e8959);
                                                                    if (_e8960 > 0f) {
                                                                        let _e8974 = (_e5954 - (_e8953 / _e8960));
                                                                        if (_e8919 > _e8974) {
                                                                            phi_7157_ = _e8919;
                                                                        } else {
                                                                            phi_7157_ = _e8974;
                                                                        }
                                                                        let _e8977 = phi_7157_;
                                                                        phi_7175_ = _e8917;
                                                                        phi_7176_ = _e8977;
                                                                    } else {
                                                                        if (_e8953 > 0f) {
                                                                            if (_e8960 < 0f) {
                                                                                let _e8965 = (_e5954 - (_e8953 / _e8960));
                                                                                if (_e8917 < _e8965) {
                                                                                    phi_7172_ = _e8917;
                                                                                } else {
                                                                                    phi_7172_ = _e8965;
                                                                                }
                                                                                let _e8968 = phi_7172_;
                                                                                phi_7173_ = _e8968;
                                                                            } else {
                                                                                phi_7173_ = _e8917;
                                                                            }
                                                                            let _e8970 = phi_7173_;
                                                                            phi_7174_ = _e8970;
                                                                        } else {
                                                                            phi_7174_ = _e8917;
                                                                        }
                                                                        let _e8972 = phi_7174_;
                                                                        phi_7175_ = _e8972;
                                                                        phi_7176_ = _e8919;
                                                                    }
                                                                    let _e8979 = phi_7175_;
                                                                    let _e8981 = phi_7176_;
                                                                    phi_7065_ = _e8979;
                                                                    phi_7067_ = _e8981;
                                                                } else {
                                                                    phi_7065_ = f32();
                                                                    phi_7067_ = f32();
                                                                }
                                                                let _e8983 = phi_7065_;
                                                                let _e8985 = phi_7067_;
                                                                continue;
                                                                continuing {
                                                                    phi_7061_ = _e8931;
                                                                    phi_7064_ = _e8983;
                                                                    phi_7066_ = _e8985;
                                                                    break if !(_e8937);
                                                                }
                                                            }
                                                            let _e8988 = local_54;
                                                            let _e8990 = local_55;
                                                            let _e8994 = local_56;
                                                            let _e8995 = (_e8994 + ((_e8988 - _e8990) * 0.5f));
                                                            if (_e8995 > _e5954) {
                                                                if (_e8995 <= _e8913) {
                                                                    let _e9000 = local_15.member[0u];
                                                                    let _e9003 = local_15.member_1[0u];
                                                                    let _e9006 = local_15.member[0u];
                                                                    let _e9012 = local_15.member_2[0u];
                                                                    if (((_e9000 + ((_e9003 - _e9006) * _e8995)) - _e9012) > 0f) {
                                                                        let _e9017 = local_15.member[1u];
                                                                        let _e9020 = local_15.member_1[1u];
                                                                        let _e9023 = local_15.member[1u];
                                                                        let _e9029 = local_15.member_2[1u];
                                                                        if (((_e9017 + ((_e9020 - _e9023) * _e8995)) - _e9029) > 0f) {
                                                                            let _e9034 = local_15.member[2u];
                                                                            let _e9037 = local_15.member_1[2u];
                                                                            let _e9040 = local_15.member[2u];
                                                                            let _e9046 = local_15.member_2[2u];
                                                                            if (((_e9034 + ((_e9037 - _e9040) * _e8995)) - _e9046) > 0f) {
                                                                                let _e9051 = local_15.member[3u];
                                                                                let _e9054 = local_15.member_1[3u];
                                                                                let _e9057 = local_15.member[3u];
                                                                                let _e9063 = local_15.member_2[3u];
                                                                                phi_7337_ = (((_e9051 + ((_e9054 - _e9057) * _e8995)) - _e9063) > 0f);
                                                                                phi_7338_ = false;
                                                                            } else {
                                                                                phi_7337_ = bool();
                                                                                phi_7338_ = true;
                                                                            }
                                                                            let _e9067 = phi_7337_;
                                                                            let _e9069 = phi_7338_;
                                                                            phi_7339_ = _e9067;
                                                                            phi_7340_ = _e9069;
                                                                        } else {
                                                                            phi_7339_ = bool();
                                                                            phi_7340_ = true;
                                                                        }
                                                                        let _e9071 = phi_7339_;
                                                                        let _e9073 = phi_7340_;
                                                                        phi_7341_ = _e9071;
                                                                        phi_7342_ = _e9073;
                                                                    } else {
                                                                        phi_7341_ = bool();
                                                                        phi_7342_ = true;
                                                                    }
                                                                    let _e9075 = phi_7341_;
                                                                    let _e9077 = phi_7342_;
                                                                    if _e9077 {
                                                                        phi_7346_ = false;
                                                                    } else {
                                                                        phi_7346_ = _e9075;
                                                                    }
                                                                    let _e9079 = phi_7346_;
                                                                    if _e9079 {
                                                                        phi_7350_ = false;
                                                                    } else {
                                                                        phi_7350_ = true;
                                                                    }
                                                                    let _e9081 = phi_7350_;
                                                                    phi_7351_ = _e9081;
                                                                } else {
                                                                    phi_7351_ = true;
                                                                }
                                                                let _e9083 = phi_7351_;
                                                                phi_7352_ = _e9083;
                                                            } else {
                                                                phi_7352_ = true;
                                                            }
                                                            let _e9085 = phi_7352_;
                                                            if _e9085 {
                                                                phi_7356_ = 2f;
                                                            } else {
                                                                phi_7356_ = _e8995;
                                                            }
                                                            let _e9087 = phi_7356_;
                                                            phi_7359_ = type_40(2u, _e8913, _e9087);
                                                            phi_7360_ = type_40();
                                                            phi_7361_ = false;
                                                        } else {
                                                            phi_7359_ = type_40();
                                                            phi_7360_ = type_40(0u, _e5954, 2f);
                                                            phi_7361_ = true;
                                                        }
                                                        let _e9090 = phi_7359_;
                                                        let _e9092 = phi_7360_;
                                                        let _e9094 = phi_7361_;
                                                        phi_7362_ = _e9090;
                                                        phi_7363_ = _e9092;
                                                        phi_7364_ = _e9094;
                                                    } else {
                                                        phi_7362_ = type_40();
                                                        phi_7363_ = _e8900;
                                                        phi_7364_ = true;
                                                    }
                                                    let _e9096 = phi_7362_;
                                                    let _e9098 = phi_7363_;
                                                    let _e9100 = phi_7364_;
                                                    phi_7369_ = _e9098;
                                                    phi_7370_ = _e9096;
                                                    phi_7371_ = _e9100;
                                                } else {
                                                    phi_7369_ = type_40(0u, _e5954, 2f);
                                                    phi_7370_ = type_40();
                                                    phi_7371_ = true;
                                                }
                                                let _e9102 = phi_7369_;
                                                let _e9104 = phi_7370_;
                                                let _e9106 = phi_7371_;
                                                phi_7375_ = _e9102;
                                                phi_7376_ = _e9104;
                                                phi_7377_ = false;
                                                phi_7378_ = _e9106;
                                            } else {
                                                phi_7375_ = type_40();
                                                phi_7376_ = type_40();
                                                phi_7377_ = true;
                                                phi_7378_ = false;
                                            }
                                            let _e9108 = phi_7375_;
                                            let _e9110 = phi_7376_;
                                            let _e9112 = phi_7377_;
                                            let _e9114 = phi_7378_;
                                            phi_7379_ = _e9108;
                                            phi_7380_ = _e9110;
                                            phi_7381_ = _e9112;
                                            phi_7382_ = _e9114;
                                        } else {
                                            phi_7379_ = type_40();
                                            phi_7380_ = type_40();
                                            phi_7381_ = true;
                                            phi_7382_ = false;
                                        }
                                        let _e9116 = phi_7379_;
                                        let _e9118 = phi_7380_;
                                        let _e9120 = phi_7381_;
                                        let _e9122 = phi_7382_;
                                        if _e9120 {
                                            phi_7387_ = type_40(0u, _e5954, 2f);
                                            phi_7388_ = true;
                                        } else {
                                            phi_7387_ = _e9116;
                                            phi_7388_ = _e9122;
                                        }
                                        let _e9125 = phi_7387_;
                                        let _e9127 = phi_7388_;
                                        if _e9127 {
                                            phi_7392_ = _e9125;
                                        } else {
                                            phi_7392_ = _e9118;
                                        }
                                        let _e9129 = phi_7392_;
                                        if _e327 {
                                            if (_e9129.member == 2u) {
                                                let _e9133 = (_e9129.member_2 <= _e321);
                                                if _e9133 {
                                                    phi_7408_ = _e9129.member_2;
                                                    phi_7409_ = _e9129.member_2;
                                                    phi_7410_ = false;
                                                } else {
                                                    phi_7408_ = f32();
                                                    phi_7409_ = f32();
                                                    phi_7410_ = true;
                                                }
                                                let _e9137 = phi_7408_;
                                                let _e9139 = phi_7409_;
                                                let _e9141 = phi_7410_;
                                                phi_7411_ = _e9137;
                                                phi_7412_ = _e9139;
                                                phi_7413_ = _e9133;
                                                phi_7414_ = _e9141;
                                                phi_7415_ = false;
                                            } else {
                                                phi_7411_ = f32();
                                                phi_7412_ = f32();
                                                phi_7413_ = false;
                                                phi_7414_ = false;
                                                phi_7415_ = true;
                                            }
                                            let _e9143 = phi_7411_;
                                            let _e9145 = phi_7412_;
                                            let _e9147 = phi_7413_;
                                            let _e9149 = phi_7414_;
                                            let _e9151 = phi_7415_;
                                            phi_7416_ = _e9143;
                                            phi_7417_ = _e9145;
                                            phi_7418_ = _e9147;
                                            phi_7419_ = _e9149;
                                            phi_7420_ = _e9151;
                                        } else {
                                            phi_7416_ = f32();
                                            phi_7417_ = f32();
                                            phi_7418_ = false;
                                            phi_7419_ = false;
                                            phi_7420_ = true;
                                        }
                                        let _e9153 = phi_7416_;
                                        let _e9155 = phi_7417_;
                                        let _e9157 = phi_7418_;
                                        let _e9159 = phi_7419_;
                                        let _e9161 = phi_7420_;
                                        phi_7421_ = _e9153;
                                        phi_7422_ = _e9129.member;
                                        phi_7423_ = _e9155;
                                        phi_7424_ = _e9129;
                                        phi_7425_ = _e9129.member;
                                        phi_7426_ = _e9129.member;
                                        phi_7427_ = _e9157;
                                        phi_7428_ = _e9159;
                                        phi_7429_ = _e9161;
                                    }
                                    let _e9163 = phi_7421_;
                                    let _e9165 = phi_7422_;
                                    let _e9167 = phi_7423_;
                                    let _e9169 = phi_7424_;
                                    let _e9171 = phi_7425_;
                                    let _e9173 = phi_7426_;
                                    let _e9175 = phi_7427_;
                                    let _e9177 = phi_7428_;
                                    let _e9179 = phi_7429_;
                                    phi_7430_ = _e9163;
                                    phi_7431_ = _e9165;
                                    phi_7432_ = _e9167;
                                    phi_7433_ = _e9169;
                                    phi_7434_ = _e9171;
                                    phi_7435_ = _e9173;
                                    phi_7436_ = _e9175;
                                    phi_7437_ = _e7740;
                                    phi_7438_ = _e9177;
                                    phi_7439_ = _e9179;
                                    phi_7440_ = false;
                                } else {
                                    phi_7430_ = f32();
                                    phi_7431_ = u32();
                                    phi_7432_ = f32();
                                    phi_7433_ = type_40();
                                    phi_7434_ = u32();
                                    phi_7435_ = u32();
                                    phi_7436_ = false;
                                    phi_7437_ = false;
                                    phi_7438_ = false;
                                    phi_7439_ = false;
                                    phi_7440_ = true;
                                }
                                let _e9181 = phi_7430_;
                                let _e9183 = phi_7431_;
                                let _e9185 = phi_7432_;
                                let _e9187 = phi_7433_;
                                let _e9189 = phi_7434_;
                                let _e9191 = phi_7435_;
                                let _e9193 = phi_7436_;
                                let _e9195 = phi_7437_;
                                let _e9197 = phi_7438_;
                                let _e9199 = phi_7439_;
                                let _e9201 = phi_7440_;
                                phi_7441_ = _e7737;
                                phi_2516_ = _e9181;
                                phi_2518_ = _e9183;
                                phi_2520_ = _e9185;
                                phi_7442_ = _e9187;
                                phi_7443_ = _e9189;
                                phi_7444_ = _e7737;
                                phi_7445_ = _e9191;
                                phi_7446_ = _e9193;
                                phi_7447_ = _e9195;
                                phi_7448_ = _e9197;
                                phi_7449_ = _e9199;
                                phi_7450_ = false;
                                phi_7451_ = _e9201;
                            } else {
                                phi_7441_ = f32();
                                phi_2516_ = f32();
                                phi_2518_ = u32();
                                phi_2520_ = f32();
                                phi_7442_ = type_40();
                                phi_7443_ = u32();
                                phi_7444_ = f32();
                                phi_7445_ = u32();
                                phi_7446_ = false;
                                phi_7447_ = false;
                                phi_7448_ = false;
                                phi_7449_ = false;
                                phi_7450_ = true;
                                phi_7451_ = false;
                            }
                            let _e9203 = phi_7441_;
                            let _e9205 = phi_2516_;
                            let _e9207 = phi_2518_;
                            let _e9209 = phi_2520_;
                            let _e9211 = phi_7442_;
                            let _e9213 = phi_7443_;
                            let _e9215 = phi_7444_;
                            let _e9217 = phi_7445_;
                            let _e9219 = phi_7446_;
                            let _e9221 = phi_7447_;
                            let _e9223 = phi_7448_;
                            let _e9225 = phi_7449_;
                            let _e9227 = phi_7450_;
                            let _e9229 = phi_7451_;
                            local_57 = _e9221;
                            local_89 = _e9223;
                            local_90 = _e9225;
                            local_91 = _e9227;
                            local_92 = _e9229;
                            local_58 = _e9211;
                            local_59 = _e9211;
                            local_93 = _e9213;
                            local_60 = _e9211;
                            local_94 = _e9221;
                            local_95 = _e9217;
                            local_97 = _e9215;
                            local_98 = _e9203;
                            continue;
                            continuing {
                                phi_2512_ = _e5977;
                                phi_2515_ = _e9205;
                                phi_2517_ = _e9207;
                                phi_2519_ = _e9209;
                                break if !(_e9219);
                            }
                        }
                        let _e9232 = local_57;
                        if _e9232 {
                            phi_7455_ = false;
                            phi_7456_ = false;
                            phi_7457_ = false;
                            phi_7458_ = false;
                        } else {
                            let _e11437 = local_89;
                            phi_7455_ = _e11437;
                            let _e11440 = local_90;
                            phi_7456_ = _e11440;
                            let _e11443 = local_91;
                            phi_7457_ = _e11443;
                            let _e11446 = local_92;
                            phi_7458_ = _e11446;
                        }
                        let _e9234 = phi_7455_;
                        let _e9236 = phi_7456_;
                        let _e9238 = phi_7457_;
                        let _e9240 = phi_7458_;
                        if _e9234 {
                            let _e9242 = local_58;
                            if (_e9242.member_1 >= _e321) {
                                phi_7480_ = type_39(type_28(0u, f32()), 0u);
                            } else {
                                let _e9246 = local_59;
                                if (_e9246.member_1 > _e319) {
                                    phi_7475_ = 0u;
                                } else {
                                    let _e11451 = local_93;
                                    phi_7475_ = _e11451;
                                }
                                let _e9250 = phi_7475_;
                                let _e9252 = local_60;
                                phi_7480_ = type_39(type_28(2u, _e9252.member_1), _e9250);
                            }
                            let _e9259 = phi_7480_;
                            phi_7481_ = _e9259;
                            phi_7482_ = false;
                            phi_7483_ = false;
                            phi_7484_ = false;
                            phi_7485_ = false;
                        } else {
                            phi_7481_ = type_39();
                            phi_7482_ = _e9236;
                            let _e11458 = local_94;
                            phi_7483_ = _e11458;
                            phi_7484_ = _e9238;
                            phi_7485_ = _e9240;
                        }
                        let _e9261 = phi_7481_;
                        let _e9263 = phi_7482_;
                        let _e9265 = phi_7483_;
                        let _e9267 = phi_7484_;
                        let _e9269 = phi_7485_;
                        if _e9263 {
                            let _e11463 = local_95;
                            phi_7489_ = _e11463;
                            let _e11468 = local_97;
                            phi_7490_ = _e11468;
                            phi_7491_ = true;
                            phi_7492_ = false;
                            phi_7493_ = false;
                            phi_7494_ = false;
                        } else {
                            let _e11465 = local_96;
                            phi_7489_ = _e11465;
                            let _e11470 = local_98;
                            phi_7490_ = _e11470;
                            phi_7491_ = _e9265;
                            phi_7492_ = _e9267;
                            phi_7493_ = _e9269;
                            phi_7494_ = _e9234;
                        }
                        let _e9271 = phi_7489_;
                        let _e9273 = phi_7490_;
                        let _e9275 = phi_7491_;
                        let _e9277 = phi_7492_;
                        let _e9279 = phi_7493_;
                        let _e9281 = phi_7494_;
                        if _e9275 {
                            phi_7498_ = _e9273;
                            phi_7499_ = _e9271;
                            phi_7500_ = true;
                            phi_7501_ = false;
                            phi_7502_ = false;
                        } else {
                            let _e11477 = local_99;
                            phi_7498_ = _e11477;
                            let _e11480 = local_100;
                            phi_7499_ = _e11480;
                            phi_7500_ = _e9277;
                            phi_7501_ = _e9279;
                            phi_7502_ = _e9281;
                        }
                        let _e9283 = phi_7498_;
                        let _e9285 = phi_7499_;
                        let _e9287 = phi_7500_;
                        let _e9289 = phi_7501_;
                        let _e9291 = phi_7502_;
                        if _e9287 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e317 >= (0.000000059604645f * 8f)) {
                                phi_7514_ = _e317;
                            } else {
                                phi_7514_ = 0f;
                            }
                            let _e9298 = phi_7514_;
                            phi_7517_ = type_12(0u, 3u);
                            loop {
                                let _e9300 = phi_7517_;
                                if (_e9300.member < _e9300.member_1) {
                                    phi_7518_ = type_12((_e9300.member + 1u), _e9300.member_1);
                                    phi_7541_ = type_12(1u, _e9300.member);
                                } else {
                                    phi_7518_ = _e9300;
                                    phi_7541_ = type_12(0u, type_12().member_1);
                                }
                                let _e9312 = phi_7518_;
                                let _e9314 = phi_7541_;
                                if (bitcast<i32>(_e9314.member) != 0i) {
                                    let _e9320 = local_13[_e9314.member_1];
                                    let _e9322 = (_e9283 + (_e9298 * _e9320));
                                    if (_e9322 < _e321) {
                                        phi_7562_ = _e9322;
                                    } else {
                                        phi_7562_ = _e321;
                                    }
                                    let _e9325 = phi_7562_;
                                    let _e9328 = local_18.member[0u];
                                    let _e9334 = local_18.member[1u];
                                    let _e9350 = local_18.member_1[0u];
                                    let _e9356 = local_18.member_1[1u];
                                    let _e9372 = local_18.member_2[0u];
                                    let _e9378 = local_18.member_2[1u];
                                    let _e9392 = function_2(array<f32, 3>((_e9328[0] + ((_e9334[0] - _e9328[0]) * _e9325)), (_e9328[1] + ((_e9334[1] - _e9328[1]) * _e9325)), (_e9328[2] + ((_e9334[2] - _e9328[2]) * _e9325))), array<f32, 3>((_e9350[0] + ((_e9356[0] - _e9350[0]) * _e9325)), (_e9350[1] + ((_e9356[1] - _e9350[1]) * _e9325)), (_e9350[2] + ((_e9356[2] - _e9350[2]) * _e9325))), array<f32, 3>((_e9372[0] + ((_e9378[0] - _e9372[0]) * _e9325)), (_e9372[1] + ((_e9378[1] - _e9372[1]) * _e9325)), (_e9372[2] + ((_e9378[2] - _e9372[2]) * _e9325))), 0u);
                                    let _e9403 = (((_e9392[0] * _e9392[0]) + (_e9392[1] * _e9392[1])) + (_e9392[2] * _e9392[2]));
                                    if (_e9403 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e9403 > 0f) {
                                            phi_7685_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_7685_ = 0f;
                                        }
                                        let _e9456 = phi_7685_;
                                        phi_7749_ = _e9456;
                                    } else {
                                        phi_7692_ = type_14(0i, 5i);
                                        phi_7695_ = bitcast<f32>(((bitcast<u32>(_e9403) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e9411 = phi_7692_;
                                            let _e9413 = phi_7695_;
                                            local_61 = _e9413;
                                            if (_e9411.member < _e9411.member_1) {
                                                let _e9420 = (_e9411.member + 1i);
                                                if ((false == (_e9420 > _e9411.member)) != false) {
                                                    phi_7716_ = true;
                                                } else {
                                                    phi_7716_ = false;
                                                }
                                                let _e9425 = phi_7716_;
                                                if _e9425 {
                                                    phi_7722_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_7722_ = type_15(1u, _e9420);
                                                }
                                                let _e9430 = phi_7722_;
                                                phi_7693_ = type_14(_e9430.member_1, _e9411.member_1);
                                                phi_7736_ = type_15(1u, _e9411.member);
                                            } else {
                                                phi_7693_ = _e9411;
                                                phi_7736_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e9436 = phi_7693_;
                                            let _e9438 = phi_7736_;
                                            let _e9441 = (bitcast<i32>(_e9438.member) != 0i);
                                            if _e9441 {
                                                phi_7696_ = (0.5f * (_e9413 + (_e9403 / _e9413)));
                                            } else {
                                                phi_7696_ = f32();
                                            }
                                            let _e9446 = phi_7696_;
                                            continue;
                                            continuing {
                                                phi_7692_ = _e9436;
                                                phi_7695_ = _e9446;
                                                break if !(_e9441);
                                            }
                                        }
                                        let _e9451 = local_61;
                                        phi_7749_ = (_e9451 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e9458 = phi_7749_;
                                    let _e9464 = local_18.member[0u];
                                    if (_e9464[0] < 0f) {
                                        phi_7765_ = -(_e9464[0]);
                                    } else {
                                        phi_7765_ = _e9464[0];
                                    }
                                    let _e9471 = phi_7765_;
                                    if (_e9464[1] < 0f) {
                                        phi_7772_ = -(_e9464[1]);
                                    } else {
                                        phi_7772_ = _e9464[1];
                                    }
                                    let _e9475 = phi_7772_;
                                    if (_e9471 > _e9475) {
                                        phi_7777_ = _e9471;
                                    } else {
                                        phi_7777_ = _e9475;
                                    }
                                    let _e9478 = phi_7777_;
                                    if (_e9464[2] < 0f) {
                                        phi_7784_ = -(_e9464[2]);
                                    } else {
                                        phi_7784_ = _e9464[2];
                                    }
                                    let _e9482 = phi_7784_;
                                    if (_e9478 > _e9482) {
                                        phi_7789_ = _e9478;
                                    } else {
                                        phi_7789_ = _e9482;
                                    }
                                    let _e9485 = phi_7789_;
                                    let _e9488 = local_18.member[1u];
                                    if (_e9488[0] < 0f) {
                                        phi_7802_ = -(_e9488[0]);
                                    } else {
                                        phi_7802_ = _e9488[0];
                                    }
                                    let _e9495 = phi_7802_;
                                    if (_e9488[1] < 0f) {
                                        phi_7809_ = -(_e9488[1]);
                                    } else {
                                        phi_7809_ = _e9488[1];
                                    }
                                    let _e9499 = phi_7809_;
                                    if (_e9495 > _e9499) {
                                        phi_7814_ = _e9495;
                                    } else {
                                        phi_7814_ = _e9499;
                                    }
                                    let _e9502 = phi_7814_;
                                    if (_e9488[2] < 0f) {
                                        phi_7821_ = -(_e9488[2]);
                                    } else {
                                        phi_7821_ = _e9488[2];
                                    }
                                    let _e9506 = phi_7821_;
                                    if (_e9502 > _e9506) {
                                        phi_7826_ = _e9502;
                                    } else {
                                        phi_7826_ = _e9506;
                                    }
                                    let _e9509 = phi_7826_;
                                    if (_e9485 > _e9509) {
                                        phi_7831_ = _e9485;
                                    } else {
                                        phi_7831_ = _e9509;
                                    }
                                    let _e9512 = phi_7831_;
                                    let _e9514 = local_18.member_3;
                                    let _e9518 = local_18.member_1[0u];
                                    if (_e9518[0] < 0f) {
                                        phi_7848_ = -(_e9518[0]);
                                    } else {
                                        phi_7848_ = _e9518[0];
                                    }
                                    let _e9525 = phi_7848_;
                                    if (_e9518[1] < 0f) {
                                        phi_7855_ = -(_e9518[1]);
                                    } else {
                                        phi_7855_ = _e9518[1];
                                    }
                                    let _e9529 = phi_7855_;
                                    if (_e9525 > _e9529) {
                                        phi_7860_ = _e9525;
                                    } else {
                                        phi_7860_ = _e9529;
                                    }
                                    let _e9532 = phi_7860_;
                                    if (_e9518[2] < 0f) {
                                        phi_7867_ = -(_e9518[2]);
                                    } else {
                                        phi_7867_ = _e9518[2];
                                    }
                                    let _e9536 = phi_7867_;
                                    if (_e9532 > _e9536) {
                                        phi_7872_ = _e9532;
                                    } else {
                                        phi_7872_ = _e9536;
                                    }
                                    let _e9539 = phi_7872_;
                                    let _e9542 = local_18.member_1[1u];
                                    if (_e9542[0] < 0f) {
                                        phi_7886_ = -(_e9542[0]);
                                    } else {
                                        phi_7886_ = _e9542[0];
                                    }
                                    let _e9549 = phi_7886_;
                                    if (_e9542[1] < 0f) {
                                        phi_7893_ = -(_e9542[1]);
                                    } else {
                                        phi_7893_ = _e9542[1];
                                    }
                                    let _e9553 = phi_7893_;
                                    if (_e9549 > _e9553) {
                                        phi_7898_ = _e9549;
                                    } else {
                                        phi_7898_ = _e9553;
                                    }
                                    let _e9556 = phi_7898_;
                                    if (_e9542[2] < 0f) {
                                        phi_7905_ = -(_e9542[2]);
                                    } else {
                                        phi_7905_ = _e9542[2];
                                    }
                                    let _e9560 = phi_7905_;
                                    if (_e9556 > _e9560) {
                                        phi_7910_ = _e9556;
                                    } else {
                                        phi_7910_ = _e9560;
                                    }
                                    let _e9563 = phi_7910_;
                                    if (_e9539 > _e9563) {
                                        phi_7915_ = _e9539;
                                    } else {
                                        phi_7915_ = _e9563;
                                    }
                                    let _e9566 = phi_7915_;
                                    let _e9568 = local_18.member_3;
                                    let _e9572 = local_18.member_2[0u];
                                    if (_e9572[0] < 0f) {
                                        phi_7932_ = -(_e9572[0]);
                                    } else {
                                        phi_7932_ = _e9572[0];
                                    }
                                    let _e9579 = phi_7932_;
                                    if (_e9572[1] < 0f) {
                                        phi_7939_ = -(_e9572[1]);
                                    } else {
                                        phi_7939_ = _e9572[1];
                                    }
                                    let _e9583 = phi_7939_;
                                    if (_e9579 > _e9583) {
                                        phi_7944_ = _e9579;
                                    } else {
                                        phi_7944_ = _e9583;
                                    }
                                    let _e9586 = phi_7944_;
                                    if (_e9572[2] < 0f) {
                                        phi_7951_ = -(_e9572[2]);
                                    } else {
                                        phi_7951_ = _e9572[2];
                                    }
                                    let _e9590 = phi_7951_;
                                    if (_e9586 > _e9590) {
                                        phi_7956_ = _e9586;
                                    } else {
                                        phi_7956_ = _e9590;
                                    }
                                    let _e9593 = phi_7956_;
                                    let _e9596 = local_18.member_2[1u];
                                    if (_e9596[0] < 0f) {
                                        phi_7970_ = -(_e9596[0]);
                                    } else {
                                        phi_7970_ = _e9596[0];
                                    }
                                    let _e9603 = phi_7970_;
                                    if (_e9596[1] < 0f) {
                                        phi_7977_ = -(_e9596[1]);
                                    } else {
                                        phi_7977_ = _e9596[1];
                                    }
                                    let _e9607 = phi_7977_;
                                    if (_e9603 > _e9607) {
                                        phi_7982_ = _e9603;
                                    } else {
                                        phi_7982_ = _e9607;
                                    }
                                    let _e9610 = phi_7982_;
                                    if (_e9596[2] < 0f) {
                                        phi_7989_ = -(_e9596[2]);
                                    } else {
                                        phi_7989_ = _e9596[2];
                                    }
                                    let _e9614 = phi_7989_;
                                    if (_e9610 > _e9614) {
                                        phi_7994_ = _e9610;
                                    } else {
                                        phi_7994_ = _e9614;
                                    }
                                    let _e9617 = phi_7994_;
                                    if (_e9593 > _e9617) {
                                        phi_7999_ = _e9593;
                                    } else {
                                        phi_7999_ = _e9617;
                                    }
                                    let _e9620 = phi_7999_;
                                    let _e9622 = local_18.member_3;
                                    let _e9629 = local_18.member_3;
                                    let _e9636 = (((_e9458 * (1f + (0.000000059604645f * 8f))) + (((((((_e9512 + _e9514) + (_e9566 + _e9568)) + (_e9620 + _e9622)) * (0.000000059604645f * 16f)) + (_e9629 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e521.member_1);
                                    if _e9636 {
                                        phi_8019_ = false;
                                    } else {
                                        phi_8019_ = true;
                                    }
                                    let _e9638 = phi_8019_;
                                    phi_8020_ = _e9638;
                                    phi_8021_ = _e9636;
                                } else {
                                    phi_8020_ = false;
                                    phi_8021_ = false;
                                }
                                let _e9640 = phi_8020_;
                                let _e9642 = phi_8021_;
                                local_62 = _e9642;
                                continue;
                                continuing {
                                    phi_7517_ = _e9312;
                                    break if !(_e9640);
                                }
                            }
                            let _e9645 = local_62;
                            if _e9645 {
                                if (_e9283 > _e319) {
                                    phi_8029_ = 1u;
                                } else {
                                    phi_8029_ = _e9285;
                                }
                                let _e9648 = phi_8029_;
                                phi_8033_ = type_39(type_28(1u, _e9283), _e9648);
                                phi_8034_ = false;
                            } else {
                                phi_8033_ = type_39();
                                phi_8034_ = true;
                            }
                            let _e9652 = phi_8033_;
                            let _e9654 = phi_8034_;
                            if _e9654 {
                                if (_e9283 > _e319) {
                                    phi_8042_ = 0u;
                                } else {
                                    phi_8042_ = _e9285;
                                }
                                let _e9657 = phi_8042_;
                                phi_8046_ = type_39(type_28(2u, _e9283), _e9657);
                            } else {
                                phi_8046_ = _e9652;
                            }
                            let _e9661 = phi_8046_;
                            phi_8047_ = _e9661;
                            phi_8048_ = false;
                            phi_8049_ = false;
                        } else {
                            phi_8047_ = type_39();
                            phi_8048_ = _e9289;
                            phi_8049_ = _e9291;
                        }
                        let _e9663 = phi_8047_;
                        let _e9665 = phi_8048_;
                        let _e9667 = phi_8049_;
                        if _e9665 {
                            phi_8056_ = type_39(type_28(0u, f32()), 0u);
                            phi_8057_ = true;
                        } else {
                            phi_8056_ = _e9261;
                            phi_8057_ = _e9667;
                        }
                        let _e9671 = phi_8056_;
                        let _e9673 = phi_8057_;
                        phi_8061_ = _e9671;
                        phi_8062_ = _e9663;
                        phi_8063_ = _e9673;
                    } else {
                        phi_8061_ = _e5944;
                        phi_8062_ = type_39();
                        phi_8063_ = true;
                    }
                    let _e9675 = phi_8061_;
                    let _e9677 = phi_8062_;
                    let _e9679 = phi_8063_;
                    if _e9679 {
                        phi_8067_ = _e9675;
                    } else {
                        phi_8067_ = _e9677;
                    }
                    let _e9681 = phi_8067_;
                    phi_15582_ = _e9681;
                } else {
                    let _e565 = local_18.member_1[0u];
                    let _e571 = local_18.member_2[0u];
                    let _e577 = ((_e565[1] * _e571[2]) - (_e565[2] * _e571[1]));
                    let _e580 = ((_e565[2] * _e571[0]) - (_e565[0] * _e571[2]));
                    let _e583 = ((_e565[0] * _e571[1]) - (_e565[1] * _e571[0]));
                    let _e586 = local_18.member_1[1u];
                    let _e592 = local_18.member_2[1u];
                    let _e598 = ((_e586[1] * _e592[2]) - (_e586[2] * _e592[1]));
                    let _e601 = ((_e586[2] * _e592[0]) - (_e586[0] * _e592[2]));
                    let _e604 = ((_e586[0] * _e592[1]) - (_e586[1] * _e592[0]));
                    let _e607 = local_18.member_1[0u];
                    let _e613 = local_18.member_2[1u];
                    let _e628 = local_18.member_1[1u];
                    let _e634 = local_18.member_2[0u];
                    let _e647 = (((_e607[1] * _e613[2]) - (_e607[2] * _e613[1])) + ((_e628[1] * _e634[2]) - (_e628[2] * _e634[1])));
                    let _e648 = (((_e607[2] * _e613[0]) - (_e607[0] * _e613[2])) + ((_e628[2] * _e634[0]) - (_e628[0] * _e634[2])));
                    let _e649 = (((_e607[0] * _e613[1]) - (_e607[1] * _e613[0])) + ((_e628[0] * _e634[1]) - (_e628[1] * _e634[0])));
                    let _e652 = local_18.member[0u];
                    let _e660 = (((_e652[0] * _e577) + (_e652[1] * _e580)) + (_e652[2] * _e583));
                    let _e663 = local_18.member[1u];
                    let _e674 = local_18.member[0u];
                    let _e683 = ((((_e663[0] * _e577) + (_e663[1] * _e580)) + (_e663[2] * _e583)) + (((_e674[0] * _e647) + (_e674[1] * _e648)) + (_e674[2] * _e649)));
                    let _e686 = local_18.member[0u];
                    let _e697 = local_18.member[1u];
                    let _e706 = ((((_e686[0] * _e598) + (_e686[1] * _e601)) + (_e686[2] * _e604)) + (((_e697[0] * _e647) + (_e697[1] * _e648)) + (_e697[2] * _e649)));
                    let _e709 = local_18.member[1u];
                    let _e717 = (((_e709[0] * _e598) + (_e709[1] * _e601)) + (_e709[2] * _e604));
                    let _e720 = local_18.member[0u];
                    if (_e720[0] < 0f) {
                        phi_8309_ = -(_e720[0]);
                    } else {
                        phi_8309_ = _e720[0];
                    }
                    let _e727 = phi_8309_;
                    if (_e720[1] < 0f) {
                        phi_8316_ = -(_e720[1]);
                    } else {
                        phi_8316_ = _e720[1];
                    }
                    let _e731 = phi_8316_;
                    if (_e727 > _e731) {
                        phi_8321_ = _e727;
                    } else {
                        phi_8321_ = _e731;
                    }
                    let _e734 = phi_8321_;
                    if (_e720[2] < 0f) {
                        phi_8328_ = -(_e720[2]);
                    } else {
                        phi_8328_ = _e720[2];
                    }
                    let _e738 = phi_8328_;
                    if (_e734 > _e738) {
                        phi_8333_ = _e734;
                    } else {
                        phi_8333_ = _e738;
                    }
                    let _e741 = phi_8333_;
                    let _e744 = local_18.member[1u];
                    if (_e744[0] < 0f) {
                        phi_8346_ = -(_e744[0]);
                    } else {
                        phi_8346_ = _e744[0];
                    }
                    let _e751 = phi_8346_;
                    if (_e744[1] < 0f) {
                        phi_8353_ = -(_e744[1]);
                    } else {
                        phi_8353_ = _e744[1];
                    }
                    let _e755 = phi_8353_;
                    if (_e751 > _e755) {
                        phi_8358_ = _e751;
                    } else {
                        phi_8358_ = _e755;
                    }
                    let _e758 = phi_8358_;
                    if (_e744[2] < 0f) {
                        phi_8365_ = -(_e744[2]);
                    } else {
                        phi_8365_ = _e744[2];
                    }
                    let _e762 = phi_8365_;
                    if (_e758 > _e762) {
                        phi_8370_ = _e758;
                    } else {
                        phi_8370_ = _e762;
                    }
                    let _e765 = phi_8370_;
                    if (_e741 > _e765) {
                        phi_8375_ = _e741;
                    } else {
                        phi_8375_ = _e765;
                    }
                    let _e768 = phi_8375_;
                    let _e770 = local_18.member_3;
                    let _e771 = (_e768 + _e770);
                    let _e774 = local_18.member_1[0u];
                    if (_e774[0] < 0f) {
                        phi_8392_ = -(_e774[0]);
                    } else {
                        phi_8392_ = _e774[0];
                    }
                    let _e781 = phi_8392_;
                    if (_e774[1] < 0f) {
                        phi_8399_ = -(_e774[1]);
                    } else {
                        phi_8399_ = _e774[1];
                    }
                    let _e785 = phi_8399_;
                    if (_e781 > _e785) {
                        phi_8404_ = _e781;
                    } else {
                        phi_8404_ = _e785;
                    }
                    let _e788 = phi_8404_;
                    if (_e774[2] < 0f) {
                        phi_8411_ = -(_e774[2]);
                    } else {
                        phi_8411_ = _e774[2];
                    }
                    let _e792 = phi_8411_;
                    if (_e788 > _e792) {
                        phi_8416_ = _e788;
                    } else {
                        phi_8416_ = _e792;
                    }
                    let _e795 = phi_8416_;
                    let _e798 = local_18.member_1[1u];
                    if (_e798[0] < 0f) {
                        phi_8430_ = -(_e798[0]);
                    } else {
                        phi_8430_ = _e798[0];
                    }
                    let _e805 = phi_8430_;
                    if (_e798[1] < 0f) {
                        phi_8437_ = -(_e798[1]);
                    } else {
                        phi_8437_ = _e798[1];
                    }
                    let _e809 = phi_8437_;
                    if (_e805 > _e809) {
                        phi_8442_ = _e805;
                    } else {
                        phi_8442_ = _e809;
                    }
                    let _e812 = phi_8442_;
                    if (_e798[2] < 0f) {
                        phi_8449_ = -(_e798[2]);
                    } else {
                        phi_8449_ = _e798[2];
                    }
                    let _e816 = phi_8449_;
                    if (_e812 > _e816) {
                        phi_8454_ = _e812;
                    } else {
                        phi_8454_ = _e816;
                    }
                    let _e819 = phi_8454_;
                    if (_e795 > _e819) {
                        phi_8459_ = _e795;
                    } else {
                        phi_8459_ = _e819;
                    }
                    let _e822 = phi_8459_;
                    let _e824 = local_18.member_3;
                    let _e825 = (_e822 + _e824);
                    let _e828 = local_18.member_2[0u];
                    if (_e828[0] < 0f) {
                        phi_8476_ = -(_e828[0]);
                    } else {
                        phi_8476_ = _e828[0];
                    }
                    let _e835 = phi_8476_;
                    if (_e828[1] < 0f) {
                        phi_8483_ = -(_e828[1]);
                    } else {
                        phi_8483_ = _e828[1];
                    }
                    let _e839 = phi_8483_;
                    if (_e835 > _e839) {
                        phi_8488_ = _e835;
                    } else {
                        phi_8488_ = _e839;
                    }
                    let _e842 = phi_8488_;
                    if (_e828[2] < 0f) {
                        phi_8495_ = -(_e828[2]);
                    } else {
                        phi_8495_ = _e828[2];
                    }
                    let _e846 = phi_8495_;
                    if (_e842 > _e846) {
                        phi_8500_ = _e842;
                    } else {
                        phi_8500_ = _e846;
                    }
                    let _e849 = phi_8500_;
                    let _e852 = local_18.member_2[1u];
                    if (_e852[0] < 0f) {
                        phi_8514_ = -(_e852[0]);
                    } else {
                        phi_8514_ = _e852[0];
                    }
                    let _e859 = phi_8514_;
                    if (_e852[1] < 0f) {
                        phi_8521_ = -(_e852[1]);
                    } else {
                        phi_8521_ = _e852[1];
                    }
                    let _e863 = phi_8521_;
                    if (_e859 > _e863) {
                        phi_8526_ = _e859;
                    } else {
                        phi_8526_ = _e863;
                    }
                    let _e866 = phi_8526_;
                    if (_e852[2] < 0f) {
                        phi_8533_ = -(_e852[2]);
                    } else {
                        phi_8533_ = _e852[2];
                    }
                    let _e870 = phi_8533_;
                    if (_e866 > _e870) {
                        phi_8538_ = _e866;
                    } else {
                        phi_8538_ = _e870;
                    }
                    let _e873 = phi_8538_;
                    if (_e849 > _e873) {
                        phi_8543_ = _e849;
                    } else {
                        phi_8543_ = _e873;
                    }
                    let _e876 = phi_8543_;
                    let _e878 = local_18.member_3;
                    let _e879 = (_e876 + _e878);
                    let _e881 = ((_e825 * 8f) * _e879);
                    let _e888 = local_18.member_3;
                    if (_e577 < 0f) {
                        phi_8574_ = -(_e577);
                    } else {
                        phi_8574_ = _e577;
                    }
                    let _e905 = phi_8574_;
                    if (_e580 < 0f) {
                        phi_8580_ = -(_e580);
                    } else {
                        phi_8580_ = _e580;
                    }
                    let _e909 = phi_8580_;
                    if (_e583 < 0f) {
                        phi_8587_ = -(_e583);
                    } else {
                        phi_8587_ = _e583;
                    }
                    let _e914 = phi_8587_;
                    let _e915 = ((_e905 + _e909) + _e914);
                    if (_e598 < 0f) {
                        phi_8594_ = -(_e598);
                    } else {
                        phi_8594_ = _e598;
                    }
                    let _e919 = phi_8594_;
                    if (_e601 < 0f) {
                        phi_8600_ = -(_e601);
                    } else {
                        phi_8600_ = _e601;
                    }
                    let _e923 = phi_8600_;
                    if (_e604 < 0f) {
                        phi_8607_ = -(_e604);
                    } else {
                        phi_8607_ = _e604;
                    }
                    let _e928 = phi_8607_;
                    let _e929 = ((_e919 + _e923) + _e928);
                    if (_e915 > _e929) {
                        phi_8613_ = _e915;
                    } else {
                        phi_8613_ = _e929;
                    }
                    let _e932 = phi_8613_;
                    if (_e647 < 0f) {
                        phi_8619_ = -(_e647);
                    } else {
                        phi_8619_ = _e647;
                    }
                    let _e936 = phi_8619_;
                    if (_e648 < 0f) {
                        phi_8625_ = -(_e648);
                    } else {
                        phi_8625_ = _e648;
                    }
                    let _e940 = phi_8625_;
                    if (_e649 < 0f) {
                        phi_8632_ = -(_e649);
                    } else {
                        phi_8632_ = _e649;
                    }
                    let _e945 = phi_8632_;
                    let _e947 = (((_e936 + _e940) + _e945) * 0.5f);
                    if (_e932 > _e947) {
                        phi_8639_ = _e932;
                    } else {
                        phi_8639_ = _e947;
                    }
                    let _e950 = phi_8639_;
                    let _e955 = local_18.member_3;
                    let _e967 = (((((_e771 * 8f) * _e881) * (0.000000059604645f * (524f / 64f))) + ((_e888 * 19f) * ((_e771 * (_e825 + _e879)) + (_e825 * _e879)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e771) * ((1f + _e825) * (1f + _e879)))));
                    let _e968 = (_e660 * 3f);
                    let _e969 = (_e717 * 3f);
                    if (_e968 < _e969) {
                        phi_8663_ = _e968;
                    } else {
                        phi_8663_ = _e969;
                    }
                    let _e972 = phi_8663_;
                    if (_e683 < _e706) {
                        phi_8668_ = _e683;
                    } else {
                        phi_8668_ = _e706;
                    }
                    let _e975 = phi_8668_;
                    if (_e972 < _e975) {
                        phi_8673_ = _e972;
                    } else {
                        phi_8673_ = _e975;
                    }
                    let _e978 = phi_8673_;
                    if (_e968 > _e969) {
                        phi_8678_ = _e968;
                    } else {
                        phi_8678_ = _e969;
                    }
                    let _e981 = phi_8678_;
                    if (_e683 > _e706) {
                        phi_8683_ = _e683;
                    } else {
                        phi_8683_ = _e706;
                    }
                    let _e984 = phi_8683_;
                    if (_e981 > _e984) {
                        phi_8688_ = _e981;
                    } else {
                        phi_8688_ = _e984;
                    }
                    let _e987 = phi_8688_;
                    let _e992 = -(_e987);
                    if (_e978 > _e992) {
                        phi_8698_ = _e978;
                    } else {
                        phi_8698_ = _e992;
                    }
                    let _e995 = phi_8698_;
                    if ((_e995 - (_e967 + ((0f * (((_e950 + (_e881 * (0.000000059604645f * 8f))) + ((_e955 * 6f) * (_e825 + _e879))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e825) * (1f + _e879))))) * (3f * 1.0001f)))) > 0f) {
                        phi_15552_ = type_28(0u, type_28().member_1);
                        phi_15553_ = type_28();
                        phi_15554_ = true;
                    } else {
                        if (_e660 < 0f) {
                            phi_8711_ = -(_e660);
                        } else {
                            phi_8711_ = _e660;
                        }
                        let _e1002 = phi_8711_;
                        if (_e683 < 0f) {
                            phi_8717_ = -(_e683);
                        } else {
                            phi_8717_ = _e683;
                        }
                        let _e1006 = phi_8717_;
                        if (_e1002 > _e1006) {
                            phi_8722_ = _e1002;
                        } else {
                            phi_8722_ = _e1006;
                        }
                        let _e1009 = phi_8722_;
                        if (_e706 < 0f) {
                            phi_8728_ = -(_e706);
                        } else {
                            phi_8728_ = _e706;
                        }
                        let _e1013 = phi_8728_;
                        if (_e717 < 0f) {
                            phi_8734_ = -(_e717);
                        } else {
                            phi_8734_ = _e717;
                        }
                        let _e1017 = phi_8734_;
                        if (_e1013 > _e1017) {
                            phi_8739_ = _e1013;
                        } else {
                            phi_8739_ = _e1017;
                        }
                        let _e1020 = phi_8739_;
                        if (_e1009 > _e1020) {
                            phi_8744_ = _e1009;
                        } else {
                            phi_8744_ = _e1020;
                        }
                        let _e1023 = phi_8744_;
                        let _e1024 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e1023 >= _e1024) {
                            phi_8752_ = (_e1023 <= (1f / _e1024));
                        } else {
                            phi_8752_ = false;
                        }
                        let _e1029 = phi_8752_;
                        if _e1029 {
                            phi_8757_ = (0.000000059604645f * 256f);
                        } else {
                            phi_8757_ = 2f;
                        }
                        let _e1032 = phi_8757_;
                        let _e1034 = ((_e967 * 0.34f) + (_e1023 * _e1032));
                        if _e1029 {
                            phi_8764_ = (1f / _e1023);
                        } else {
                            phi_8764_ = 0f;
                        }
                        let _e1037 = phi_8764_;
                        let _e1038 = (_e317 * 0.0625f);
                        if (0.00000000000022737368f < _e1038) {
                            phi_8770_ = 0.00000000000022737368f;
                        } else {
                            phi_8770_ = _e1038;
                        }
                        let _e1041 = phi_8770_;
                        let _e1042 = (1f - _e319);
                        let _e1053 = ((((_e660 * _e1042) + (_e683 * _e319)) * (_e1042 * _e1042)) + (((_e706 * _e1042) + (_e717 * _e319)) * (_e319 * _e319)));
                        if (_e1053 < 0f) {
                            phi_8788_ = -(_e1053);
                        } else {
                            phi_8788_ = _e1053;
                        }
                        let _e1057 = phi_8788_;
                        if !((_e1057 > _e1034)) {
                            let _e1062 = local_18.member[0u];
                            let _e1068 = local_18.member_1[0u];
                            let _e1074 = local_18.member_2[0u];
                            let _e1078 = (_e1062[0] - _e1068[0]);
                            let _e1079 = (_e1062[1] - _e1068[1]);
                            let _e1080 = (_e1062[2] - _e1068[2]);
                            let _e1081 = (_e1062[0] - _e1074[0]);
                            let _e1082 = (_e1062[1] - _e1074[1]);
                            let _e1083 = (_e1062[2] - _e1074[2]);
                            let _e1086 = local_18.member[1u];
                            let _e1092 = local_18.member_1[1u];
                            let _e1098 = local_18.member_2[1u];
                            let _e1102 = (_e1086[0] - _e1092[0]);
                            let _e1103 = (_e1086[1] - _e1092[1]);
                            let _e1104 = (_e1086[2] - _e1092[2]);
                            let _e1105 = (_e1086[0] - _e1098[0]);
                            let _e1106 = (_e1086[1] - _e1098[1]);
                            let _e1107 = (_e1086[2] - _e1098[2]);
                            let _e1110 = local_18.member[0u];
                            if (_e1110[0] < 0f) {
                                phi_8936_ = -(_e1110[0]);
                            } else {
                                phi_8936_ = _e1110[0];
                            }
                            let _e1117 = phi_8936_;
                            if (_e1110[1] < 0f) {
                                phi_8943_ = -(_e1110[1]);
                            } else {
                                phi_8943_ = _e1110[1];
                            }
                            let _e1121 = phi_8943_;
                            if (_e1117 > _e1121) {
                                phi_8948_ = _e1117;
                            } else {
                                phi_8948_ = _e1121;
                            }
                            let _e1124 = phi_8948_;
                            if (_e1110[2] < 0f) {
                                phi_8955_ = -(_e1110[2]);
                            } else {
                                phi_8955_ = _e1110[2];
                            }
                            let _e1128 = phi_8955_;
                            if (_e1124 > _e1128) {
                                phi_8960_ = _e1124;
                            } else {
                                phi_8960_ = _e1128;
                            }
                            let _e1131 = phi_8960_;
                            let _e1134 = local_18.member[1u];
                            if (_e1134[0] < 0f) {
                                phi_8973_ = -(_e1134[0]);
                            } else {
                                phi_8973_ = _e1134[0];
                            }
                            let _e1141 = phi_8973_;
                            if (_e1134[1] < 0f) {
                                phi_8980_ = -(_e1134[1]);
                            } else {
                                phi_8980_ = _e1134[1];
                            }
                            let _e1145 = phi_8980_;
                            if (_e1141 > _e1145) {
                                phi_8985_ = _e1141;
                            } else {
                                phi_8985_ = _e1145;
                            }
                            let _e1148 = phi_8985_;
                            if (_e1134[2] < 0f) {
                                phi_8992_ = -(_e1134[2]);
                            } else {
                                phi_8992_ = _e1134[2];
                            }
                            let _e1152 = phi_8992_;
                            if (_e1148 > _e1152) {
                                phi_8997_ = _e1148;
                            } else {
                                phi_8997_ = _e1152;
                            }
                            let _e1155 = phi_8997_;
                            if (_e1131 > _e1155) {
                                phi_9002_ = _e1131;
                            } else {
                                phi_9002_ = _e1155;
                            }
                            let _e1158 = phi_9002_;
                            let _e1160 = local_18.member_3;
                            let _e1164 = local_18.member_1[0u];
                            if (_e1164[0] < 0f) {
                                phi_9019_ = -(_e1164[0]);
                            } else {
                                phi_9019_ = _e1164[0];
                            }
                            let _e1171 = phi_9019_;
                            if (_e1164[1] < 0f) {
                                phi_9026_ = -(_e1164[1]);
                            } else {
                                phi_9026_ = _e1164[1];
                            }
                            let _e1175 = phi_9026_;
                            if (_e1171 > _e1175) {
                                phi_9031_ = _e1171;
                            } else {
                                phi_9031_ = _e1175;
                            }
                            let _e1178 = phi_9031_;
                            if (_e1164[2] < 0f) {
                                phi_9038_ = -(_e1164[2]);
                            } else {
                                phi_9038_ = _e1164[2];
                            }
                            let _e1182 = phi_9038_;
                            if (_e1178 > _e1182) {
                                phi_9043_ = _e1178;
                            } else {
                                phi_9043_ = _e1182;
                            }
                            let _e1185 = phi_9043_;
                            let _e1188 = local_18.member_1[1u];
                            if (_e1188[0] < 0f) {
                                phi_9057_ = -(_e1188[0]);
                            } else {
                                phi_9057_ = _e1188[0];
                            }
                            let _e1195 = phi_9057_;
                            if (_e1188[1] < 0f) {
                                phi_9064_ = -(_e1188[1]);
                            } else {
                                phi_9064_ = _e1188[1];
                            }
                            let _e1199 = phi_9064_;
                            if (_e1195 > _e1199) {
                                phi_9069_ = _e1195;
                            } else {
                                phi_9069_ = _e1199;
                            }
                            let _e1202 = phi_9069_;
                            if (_e1188[2] < 0f) {
                                phi_9076_ = -(_e1188[2]);
                            } else {
                                phi_9076_ = _e1188[2];
                            }
                            let _e1206 = phi_9076_;
                            if (_e1202 > _e1206) {
                                phi_9081_ = _e1202;
                            } else {
                                phi_9081_ = _e1206;
                            }
                            let _e1209 = phi_9081_;
                            if (_e1185 > _e1209) {
                                phi_9086_ = _e1185;
                            } else {
                                phi_9086_ = _e1209;
                            }
                            let _e1212 = phi_9086_;
                            let _e1214 = local_18.member_3;
                            let _e1218 = local_18.member_2[0u];
                            if (_e1218[0] < 0f) {
                                phi_9103_ = -(_e1218[0]);
                            } else {
                                phi_9103_ = _e1218[0];
                            }
                            let _e1225 = phi_9103_;
                            if (_e1218[1] < 0f) {
                                phi_9110_ = -(_e1218[1]);
                            } else {
                                phi_9110_ = _e1218[1];
                            }
                            let _e1229 = phi_9110_;
                            if (_e1225 > _e1229) {
                                phi_9115_ = _e1225;
                            } else {
                                phi_9115_ = _e1229;
                            }
                            let _e1232 = phi_9115_;
                            if (_e1218[2] < 0f) {
                                phi_9122_ = -(_e1218[2]);
                            } else {
                                phi_9122_ = _e1218[2];
                            }
                            let _e1236 = phi_9122_;
                            if (_e1232 > _e1236) {
                                phi_9127_ = _e1232;
                            } else {
                                phi_9127_ = _e1236;
                            }
                            let _e1239 = phi_9127_;
                            let _e1242 = local_18.member_2[1u];
                            if (_e1242[0] < 0f) {
                                phi_9141_ = -(_e1242[0]);
                            } else {
                                phi_9141_ = _e1242[0];
                            }
                            let _e1249 = phi_9141_;
                            if (_e1242[1] < 0f) {
                                phi_9148_ = -(_e1242[1]);
                            } else {
                                phi_9148_ = _e1242[1];
                            }
                            let _e1253 = phi_9148_;
                            if (_e1249 > _e1253) {
                                phi_9153_ = _e1249;
                            } else {
                                phi_9153_ = _e1253;
                            }
                            let _e1256 = phi_9153_;
                            if (_e1242[2] < 0f) {
                                phi_9160_ = -(_e1242[2]);
                            } else {
                                phi_9160_ = _e1242[2];
                            }
                            let _e1260 = phi_9160_;
                            if (_e1256 > _e1260) {
                                phi_9165_ = _e1256;
                            } else {
                                phi_9165_ = _e1260;
                            }
                            let _e1263 = phi_9165_;
                            if (_e1239 > _e1263) {
                                phi_9170_ = _e1239;
                            } else {
                                phi_9170_ = _e1263;
                            }
                            let _e1266 = phi_9170_;
                            let _e1268 = local_18.member_3;
                            let _e1275 = local_18.member_3;
                            let _e1279 = ((((((_e1158 + _e1160) + (_e1212 + _e1214)) + (_e1266 + _e1268)) * (0.000000059604645f * 16f)) + (_e1275 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e1282 = local_18.member[0u];
                            let _e1288 = local_18.member[1u];
                            let _e1304 = local_18.member_1[0u];
                            let _e1310 = local_18.member_1[1u];
                            let _e1326 = local_18.member_2[0u];
                            let _e1332 = local_18.member_2[1u];
                            let _e1346 = function_2(array<f32, 3>((_e1282[0] + ((_e1288[0] - _e1282[0]) * _e319)), (_e1282[1] + ((_e1288[1] - _e1282[1]) * _e319)), (_e1282[2] + ((_e1288[2] - _e1282[2]) * _e319))), array<f32, 3>((_e1304[0] + ((_e1310[0] - _e1304[0]) * _e319)), (_e1304[1] + ((_e1310[1] - _e1304[1]) * _e319)), (_e1304[2] + ((_e1310[2] - _e1304[2]) * _e319))), array<f32, 3>((_e1326[0] + ((_e1332[0] - _e1326[0]) * _e319)), (_e1326[1] + ((_e1332[1] - _e1326[1]) * _e319)), (_e1326[2] + ((_e1332[2] - _e1326[2]) * _e319))), 0u);
                            if (_e1346[0] < 0f) {
                                phi_9288_ = -(_e1346[0]);
                            } else {
                                phi_9288_ = _e1346[0];
                            }
                            let _e1351 = phi_9288_;
                            if (_e1346[1] < 0f) {
                                phi_9295_ = -(_e1346[1]);
                            } else {
                                phi_9295_ = _e1346[1];
                            }
                            let _e1356 = phi_9295_;
                            if (_e1346[2] < 0f) {
                                phi_9303_ = -(_e1346[2]);
                            } else {
                                phi_9303_ = _e1346[2];
                            }
                            let _e1362 = phi_9303_;
                            let _e1363 = ((_e1351 + _e1356) + _e1362);
                            if (_e1363 > 0f) {
                                if ((bitcast<u32>(_e1363) & 2139095040u) != 2139095040u) {
                                    let _e1368 = (1f / _e1363);
                                    let _e1370 = (_e1346[0] * _e1368);
                                    let _e1372 = (_e1346[1] * _e1368);
                                    let _e1374 = (_e1346[2] * _e1368);
                                    let _e1379 = (((_e1370 * _e1370) + (_e1372 * _e1372)) + (_e1374 * _e1374));
                                    if (_e1379 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1379 > 0f) {
                                            phi_9340_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_9340_ = 0f;
                                        }
                                        let _e1432 = phi_9340_;
                                        phi_9404_ = _e1432;
                                    } else {
                                        phi_9347_ = type_14(0i, 5i);
                                        phi_9350_ = bitcast<f32>(((bitcast<u32>(_e1379) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1387 = phi_9347_;
                                            let _e1389 = phi_9350_;
                                            local_19 = _e1389;
                                            if (_e1387.member < _e1387.member_1) {
                                                let _e1396 = (_e1387.member + 1i);
                                                if ((false == (_e1396 > _e1387.member)) != false) {
                                                    phi_9371_ = true;
                                                } else {
                                                    phi_9371_ = false;
                                                }
                                                let _e1401 = phi_9371_;
                                                if _e1401 {
                                                    phi_9377_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_9377_ = type_15(1u, _e1396);
                                                }
                                                let _e1406 = phi_9377_;
                                                phi_9348_ = type_14(_e1406.member_1, _e1387.member_1);
                                                phi_9391_ = type_15(1u, _e1387.member);
                                            } else {
                                                phi_9348_ = _e1387;
                                                phi_9391_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1412 = phi_9348_;
                                            let _e1414 = phi_9391_;
                                            let _e1417 = (bitcast<i32>(_e1414.member) != 0i);
                                            if _e1417 {
                                                phi_9351_ = (0.5f * (_e1389 + (_e1379 / _e1389)));
                                            } else {
                                                phi_9351_ = f32();
                                            }
                                            let _e1422 = phi_9351_;
                                            continue;
                                            continuing {
                                                phi_9347_ = _e1412;
                                                phi_9350_ = _e1422;
                                                break if !(_e1417);
                                            }
                                        }
                                        let _e1427 = local_19;
                                        phi_9404_ = (_e1427 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1434 = phi_9404_;
                                    let _e1435 = (0.000000059604645f * 12f);
                                    let _e1440 = ((_e1279 * 1.01f) + ((0f * _e1434) * (1f + _e1435)));
                                    let _e1445 = (((_e1370 * _e1062[0]) + (_e1372 * _e1062[1])) + (_e1374 * _e1062[2]));
                                    let _e1450 = (((_e1370 * _e1078) + (_e1372 * _e1079)) + (_e1374 * _e1080));
                                    let _e1455 = (((_e1370 * _e1081) + (_e1372 * _e1082)) + (_e1374 * _e1083));
                                    let _e1460 = (((_e1370 * _e1062[0]) + (_e1372 * _e1062[1])) + (_e1374 * _e1062[2]));
                                    let _e1466 = (((_e1370 * _e1086[0]) + (_e1372 * _e1086[1])) + (_e1374 * _e1086[2]));
                                    let _e1471 = (((_e1370 * _e1102) + (_e1372 * _e1103)) + (_e1374 * _e1104));
                                    let _e1476 = (((_e1370 * _e1105) + (_e1372 * _e1106)) + (_e1374 * _e1107));
                                    let _e1481 = (((_e1370 * _e1086[0]) + (_e1372 * _e1086[1])) + (_e1374 * _e1086[2]));
                                    if (_e1445 < 0f) {
                                        phi_9470_ = -(_e1445);
                                    } else {
                                        phi_9470_ = _e1445;
                                    }
                                    let _e1486 = phi_9470_;
                                    if (_e1466 < 0f) {
                                        phi_9476_ = -(_e1466);
                                    } else {
                                        phi_9476_ = _e1466;
                                    }
                                    let _e1490 = phi_9476_;
                                    if (_e1450 < 0f) {
                                        phi_9485_ = -(_e1450);
                                    } else {
                                        phi_9485_ = _e1450;
                                    }
                                    let _e1497 = phi_9485_;
                                    if (_e1471 < 0f) {
                                        phi_9491_ = -(_e1471);
                                    } else {
                                        phi_9491_ = _e1471;
                                    }
                                    let _e1501 = phi_9491_;
                                    if (_e1455 < 0f) {
                                        phi_9500_ = -(_e1455);
                                    } else {
                                        phi_9500_ = _e1455;
                                    }
                                    let _e1508 = phi_9500_;
                                    if (_e1476 < 0f) {
                                        phi_9506_ = -(_e1476);
                                    } else {
                                        phi_9506_ = _e1476;
                                    }
                                    let _e1512 = phi_9506_;
                                    if (_e1460 < 0f) {
                                        phi_9515_ = -(_e1460);
                                    } else {
                                        phi_9515_ = _e1460;
                                    }
                                    let _e1519 = phi_9515_;
                                    if (_e1481 < 0f) {
                                        phi_9521_ = -(_e1481);
                                    } else {
                                        phi_9521_ = _e1481;
                                    }
                                    let _e1523 = phi_9521_;
                                    phi_9527_ = type_32(array<f32, 4>(_e1445, _e1450, _e1455, _e1460), array<f32, 4>(_e1466, _e1471, _e1476, _e1481), array<f32, 4>((_e1440 + ((_e1486 + _e1490) * _e1435)), (_e1440 + ((_e1497 + _e1501) * _e1435)), (_e1440 + ((_e1508 + _e1512) * _e1435)), (_e1440 + ((_e1519 + _e1523) * _e1435))));
                                    phi_9528_ = false;
                                } else {
                                    phi_9527_ = type_32();
                                    phi_9528_ = true;
                                }
                                let _e1530 = phi_9527_;
                                let _e1532 = phi_9528_;
                                phi_9529_ = _e1530;
                                phi_9530_ = _e1532;
                            } else {
                                phi_9529_ = type_32();
                                phi_9530_ = true;
                            }
                            let _e1534 = phi_9529_;
                            let _e1536 = phi_9530_;
                            if _e1536 {
                                phi_9538_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                            } else {
                                phi_9538_ = _e1534;
                            }
                            let _e1538 = phi_9538_;
                            local_8 = type_32(array<f32, 4>(_e1538.member[0], _e1538.member[1], _e1538.member[2], _e1538.member[3]), array<f32, 4>(_e1538.member_1[0], _e1538.member_1[1], _e1538.member_1[2], _e1538.member_1[3]), array<f32, 4>(_e1538.member_2[0], _e1538.member_2[1], _e1538.member_2[2], _e1538.member_2[3]));
                            let _e1560 = local_8.member[0u];
                            let _e1563 = local_8.member_1[0u];
                            let _e1566 = local_8.member[0u];
                            let _e1572 = local_8.member_2[0u];
                            if (((_e1560 + ((_e1563 - _e1566) * _e319)) - _e1572) > 0f) {
                                let _e1577 = local_8.member[1u];
                                let _e1580 = local_8.member_1[1u];
                                let _e1583 = local_8.member[1u];
                                let _e1589 = local_8.member_2[1u];
                                if (((_e1577 + ((_e1580 - _e1583) * _e319)) - _e1589) > 0f) {
                                    let _e1594 = local_8.member[2u];
                                    let _e1597 = local_8.member_1[2u];
                                    let _e1600 = local_8.member[2u];
                                    let _e1606 = local_8.member_2[2u];
                                    if (((_e1594 + ((_e1597 - _e1600) * _e319)) - _e1606) > 0f) {
                                        let _e1611 = local_8.member[3u];
                                        let _e1614 = local_8.member_1[3u];
                                        let _e1617 = local_8.member[3u];
                                        let _e1623 = local_8.member_2[3u];
                                        phi_9707_ = (((_e1611 + ((_e1614 - _e1617) * _e319)) - _e1623) > 0f);
                                        phi_9708_ = false;
                                    } else {
                                        phi_9707_ = bool();
                                        phi_9708_ = true;
                                    }
                                    let _e1627 = phi_9707_;
                                    let _e1629 = phi_9708_;
                                    phi_9709_ = _e1627;
                                    phi_9710_ = _e1629;
                                } else {
                                    phi_9709_ = bool();
                                    phi_9710_ = true;
                                }
                                let _e1631 = phi_9709_;
                                let _e1633 = phi_9710_;
                                phi_9711_ = _e1631;
                                phi_9712_ = _e1633;
                            } else {
                                phi_9711_ = bool();
                                phi_9712_ = true;
                            }
                            let _e1635 = phi_9711_;
                            let _e1637 = phi_9712_;
                            if _e1637 {
                                phi_9716_ = false;
                            } else {
                                phi_9716_ = _e1635;
                            }
                            let _e1639 = phi_9716_;
                            if _e1639 {
                                phi_11070_ = bool();
                                phi_11071_ = true;
                            } else {
                                if (_e1346[0] < 0f) {
                                    phi_9743_ = -(_e1346[0]);
                                } else {
                                    phi_9743_ = _e1346[0];
                                }
                                let _e1644 = phi_9743_;
                                let _e1646 = ((_e1644 + 0f) + 0f);
                                if (_e1646 > 0f) {
                                    if ((bitcast<u32>(_e1646) & 2139095040u) != 2139095040u) {
                                        let _e1651 = (1f / _e1646);
                                        let _e1652 = (_e1346[0] * _e1651);
                                        let _e1653 = (0f * _e1651);
                                        let _e1654 = (0f * _e1651);
                                        let _e1659 = (((_e1652 * _e1652) + (_e1653 * _e1653)) + (_e1654 * _e1654));
                                        if (_e1659 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e1659 > 0f) {
                                                phi_9790_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_9790_ = 0f;
                                            }
                                            let _e1712 = phi_9790_;
                                            phi_9854_ = _e1712;
                                        } else {
                                            phi_9797_ = type_14(0i, 5i);
                                            phi_9800_ = bitcast<f32>(((bitcast<u32>(_e1659) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e1667 = phi_9797_;
                                                let _e1669 = phi_9800_;
                                                local_20 = _e1669;
                                                if (_e1667.member < _e1667.member_1) {
                                                    let _e1676 = (_e1667.member + 1i);
                                                    if ((false == (_e1676 > _e1667.member)) != false) {
                                                        phi_9821_ = true;
                                                    } else {
                                                        phi_9821_ = false;
                                                    }
                                                    let _e1681 = phi_9821_;
                                                    if _e1681 {
                                                        phi_9827_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_9827_ = type_15(1u, _e1676);
                                                    }
                                                    let _e1686 = phi_9827_;
                                                    phi_9798_ = type_14(_e1686.member_1, _e1667.member_1);
                                                    phi_9841_ = type_15(1u, _e1667.member);
                                                } else {
                                                    phi_9798_ = _e1667;
                                                    phi_9841_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e1692 = phi_9798_;
                                                let _e1694 = phi_9841_;
                                                let _e1697 = (bitcast<i32>(_e1694.member) != 0i);
                                                if _e1697 {
                                                    phi_9801_ = (0.5f * (_e1669 + (_e1659 / _e1669)));
                                                } else {
                                                    phi_9801_ = f32();
                                                }
                                                let _e1702 = phi_9801_;
                                                continue;
                                                continuing {
                                                    phi_9797_ = _e1692;
                                                    phi_9800_ = _e1702;
                                                    break if !(_e1697);
                                                }
                                            }
                                            let _e1707 = local_20;
                                            phi_9854_ = (_e1707 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e1714 = phi_9854_;
                                        let _e1715 = (0.000000059604645f * 12f);
                                        let _e1720 = ((_e1279 * 1.01f) + ((0f * _e1714) * (1f + _e1715)));
                                        let _e1725 = (((_e1652 * _e1062[0]) + (_e1653 * _e1062[1])) + (_e1654 * _e1062[2]));
                                        let _e1730 = (((_e1652 * _e1078) + (_e1653 * _e1079)) + (_e1654 * _e1080));
                                        let _e1735 = (((_e1652 * _e1081) + (_e1653 * _e1082)) + (_e1654 * _e1083));
                                        let _e1740 = (((_e1652 * _e1062[0]) + (_e1653 * _e1062[1])) + (_e1654 * _e1062[2]));
                                        let _e1746 = (((_e1652 * _e1086[0]) + (_e1653 * _e1086[1])) + (_e1654 * _e1086[2]));
                                        let _e1751 = (((_e1652 * _e1102) + (_e1653 * _e1103)) + (_e1654 * _e1104));
                                        let _e1756 = (((_e1652 * _e1105) + (_e1653 * _e1106)) + (_e1654 * _e1107));
                                        let _e1761 = (((_e1652 * _e1086[0]) + (_e1653 * _e1086[1])) + (_e1654 * _e1086[2]));
                                        if (_e1725 < 0f) {
                                            phi_9920_ = -(_e1725);
                                        } else {
                                            phi_9920_ = _e1725;
                                        }
                                        let _e1766 = phi_9920_;
                                        if (_e1746 < 0f) {
                                            phi_9926_ = -(_e1746);
                                        } else {
                                            phi_9926_ = _e1746;
                                        }
                                        let _e1770 = phi_9926_;
                                        if (_e1730 < 0f) {
                                            phi_9935_ = -(_e1730);
                                        } else {
                                            phi_9935_ = _e1730;
                                        }
                                        let _e1777 = phi_9935_;
                                        if (_e1751 < 0f) {
                                            phi_9941_ = -(_e1751);
                                        } else {
                                            phi_9941_ = _e1751;
                                        }
                                        let _e1781 = phi_9941_;
                                        if (_e1735 < 0f) {
                                            phi_9950_ = -(_e1735);
                                        } else {
                                            phi_9950_ = _e1735;
                                        }
                                        let _e1788 = phi_9950_;
                                        if (_e1756 < 0f) {
                                            phi_9956_ = -(_e1756);
                                        } else {
                                            phi_9956_ = _e1756;
                                        }
                                        let _e1792 = phi_9956_;
                                        if (_e1740 < 0f) {
                                            phi_9965_ = -(_e1740);
                                        } else {
                                            phi_9965_ = _e1740;
                                        }
                                        let _e1799 = phi_9965_;
                                        if (_e1761 < 0f) {
                                            phi_9971_ = -(_e1761);
                                        } else {
                                            phi_9971_ = _e1761;
                                        }
                                        let _e1803 = phi_9971_;
                                        phi_9977_ = type_32(array<f32, 4>(_e1725, _e1730, _e1735, _e1740), array<f32, 4>(_e1746, _e1751, _e1756, _e1761), array<f32, 4>((_e1720 + ((_e1766 + _e1770) * _e1715)), (_e1720 + ((_e1777 + _e1781) * _e1715)), (_e1720 + ((_e1788 + _e1792) * _e1715)), (_e1720 + ((_e1799 + _e1803) * _e1715))));
                                        phi_9978_ = false;
                                    } else {
                                        phi_9977_ = type_32();
                                        phi_9978_ = true;
                                    }
                                    let _e1810 = phi_9977_;
                                    let _e1812 = phi_9978_;
                                    phi_9979_ = _e1810;
                                    phi_9980_ = _e1812;
                                } else {
                                    phi_9979_ = type_32();
                                    phi_9980_ = true;
                                }
                                let _e1814 = phi_9979_;
                                let _e1816 = phi_9980_;
                                if _e1816 {
                                    phi_9988_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_9988_ = _e1814;
                                }
                                let _e1818 = phi_9988_;
                                local_9 = type_32(array<f32, 4>(_e1818.member[0], _e1818.member[1], _e1818.member[2], _e1818.member[3]), array<f32, 4>(_e1818.member_1[0], _e1818.member_1[1], _e1818.member_1[2], _e1818.member_1[3]), array<f32, 4>(_e1818.member_2[0], _e1818.member_2[1], _e1818.member_2[2], _e1818.member_2[3]));
                                let _e1840 = local_9.member[0u];
                                let _e1843 = local_9.member_1[0u];
                                let _e1846 = local_9.member[0u];
                                let _e1852 = local_9.member_2[0u];
                                if (((_e1840 + ((_e1843 - _e1846) * _e319)) - _e1852) > 0f) {
                                    let _e1857 = local_9.member[1u];
                                    let _e1860 = local_9.member_1[1u];
                                    let _e1863 = local_9.member[1u];
                                    let _e1869 = local_9.member_2[1u];
                                    if (((_e1857 + ((_e1860 - _e1863) * _e319)) - _e1869) > 0f) {
                                        let _e1874 = local_9.member[2u];
                                        let _e1877 = local_9.member_1[2u];
                                        let _e1880 = local_9.member[2u];
                                        let _e1886 = local_9.member_2[2u];
                                        if (((_e1874 + ((_e1877 - _e1880) * _e319)) - _e1886) > 0f) {
                                            let _e1891 = local_9.member[3u];
                                            let _e1894 = local_9.member_1[3u];
                                            let _e1897 = local_9.member[3u];
                                            let _e1903 = local_9.member_2[3u];
                                            phi_10157_ = (((_e1891 + ((_e1894 - _e1897) * _e319)) - _e1903) > 0f);
                                            phi_10158_ = false;
                                        } else {
                                            phi_10157_ = bool();
                                            phi_10158_ = true;
                                        }
                                        let _e1907 = phi_10157_;
                                        let _e1909 = phi_10158_;
                                        phi_10159_ = _e1907;
                                        phi_10160_ = _e1909;
                                    } else {
                                        phi_10159_ = bool();
                                        phi_10160_ = true;
                                    }
                                    let _e1911 = phi_10159_;
                                    let _e1913 = phi_10160_;
                                    phi_10161_ = _e1911;
                                    phi_10162_ = _e1913;
                                } else {
                                    phi_10161_ = bool();
                                    phi_10162_ = true;
                                }
                                let _e1915 = phi_10161_;
                                let _e1917 = phi_10162_;
                                if _e1917 {
                                    phi_10166_ = false;
                                } else {
                                    phi_10166_ = _e1915;
                                }
                                let _e1919 = phi_10166_;
                                if _e1919 {
                                    phi_11068_ = bool();
                                    phi_11069_ = true;
                                } else {
                                    if (_e1346[1] < 0f) {
                                        phi_10199_ = -(_e1346[1]);
                                    } else {
                                        phi_10199_ = _e1346[1];
                                    }
                                    let _e1924 = phi_10199_;
                                    let _e1926 = ((0f + _e1924) + 0f);
                                    if (_e1926 > 0f) {
                                        if ((bitcast<u32>(_e1926) & 2139095040u) != 2139095040u) {
                                            let _e1931 = (1f / _e1926);
                                            let _e1932 = (0f * _e1931);
                                            let _e1933 = (_e1346[1] * _e1931);
                                            let _e1934 = (0f * _e1931);
                                            let _e1939 = (((_e1932 * _e1932) + (_e1933 * _e1933)) + (_e1934 * _e1934));
                                            if (_e1939 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e1939 > 0f) {
                                                    phi_10240_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_10240_ = 0f;
                                                }
                                                let _e1992 = phi_10240_;
                                                phi_10304_ = _e1992;
                                            } else {
                                                phi_10247_ = type_14(0i, 5i);
                                                phi_10250_ = bitcast<f32>(((bitcast<u32>(_e1939) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1947 = phi_10247_;
                                                    let _e1949 = phi_10250_;
                                                    local_21 = _e1949;
                                                    if (_e1947.member < _e1947.member_1) {
                                                        let _e1956 = (_e1947.member + 1i);
                                                        if ((false == (_e1956 > _e1947.member)) != false) {
                                                            phi_10271_ = true;
                                                        } else {
                                                            phi_10271_ = false;
                                                        }
                                                        let _e1961 = phi_10271_;
                                                        if _e1961 {
                                                            phi_10277_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_10277_ = type_15(1u, _e1956);
                                                        }
                                                        let _e1966 = phi_10277_;
                                                        phi_10248_ = type_14(_e1966.member_1, _e1947.member_1);
                                                        phi_10291_ = type_15(1u, _e1947.member);
                                                    } else {
                                                        phi_10248_ = _e1947;
                                                        phi_10291_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1972 = phi_10248_;
                                                    let _e1974 = phi_10291_;
                                                    let _e1977 = (bitcast<i32>(_e1974.member) != 0i);
                                                    if _e1977 {
                                                        phi_10251_ = (0.5f * (_e1949 + (_e1939 / _e1949)));
                                                    } else {
                                                        phi_10251_ = f32();
                                                    }
                                                    let _e1982 = phi_10251_;
                                                    continue;
                                                    continuing {
                                                        phi_10247_ = _e1972;
                                                        phi_10250_ = _e1982;
                                                        break if !(_e1977);
                                                    }
                                                }
                                                let _e1987 = local_21;
                                                phi_10304_ = (_e1987 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1994 = phi_10304_;
                                            let _e1995 = (0.000000059604645f * 12f);
                                            let _e2000 = ((_e1279 * 1.01f) + ((0f * _e1994) * (1f + _e1995)));
                                            let _e2005 = (((_e1932 * _e1062[0]) + (_e1933 * _e1062[1])) + (_e1934 * _e1062[2]));
                                            let _e2010 = (((_e1932 * _e1078) + (_e1933 * _e1079)) + (_e1934 * _e1080));
                                            let _e2015 = (((_e1932 * _e1081) + (_e1933 * _e1082)) + (_e1934 * _e1083));
                                            let _e2020 = (((_e1932 * _e1062[0]) + (_e1933 * _e1062[1])) + (_e1934 * _e1062[2]));
                                            let _e2026 = (((_e1932 * _e1086[0]) + (_e1933 * _e1086[1])) + (_e1934 * _e1086[2]));
                                            let _e2031 = (((_e1932 * _e1102) + (_e1933 * _e1103)) + (_e1934 * _e1104));
                                            let _e2036 = (((_e1932 * _e1105) + (_e1933 * _e1106)) + (_e1934 * _e1107));
                                            let _e2041 = (((_e1932 * _e1086[0]) + (_e1933 * _e1086[1])) + (_e1934 * _e1086[2]));
                                            if (_e2005 < 0f) {
                                                phi_10370_ = -(_e2005);
                                            } else {
                                                phi_10370_ = _e2005;
                                            }
                                            let _e2046 = phi_10370_;
                                            if (_e2026 < 0f) {
                                                phi_10376_ = -(_e2026);
                                            } else {
                                                phi_10376_ = _e2026;
                                            }
                                            let _e2050 = phi_10376_;
                                            if (_e2010 < 0f) {
                                                phi_10385_ = -(_e2010);
                                            } else {
                                                phi_10385_ = _e2010;
                                            }
                                            let _e2057 = phi_10385_;
                                            if (_e2031 < 0f) {
                                                phi_10391_ = -(_e2031);
                                            } else {
                                                phi_10391_ = _e2031;
                                            }
                                            let _e2061 = phi_10391_;
                                            if (_e2015 < 0f) {
                                                phi_10400_ = -(_e2015);
                                            } else {
                                                phi_10400_ = _e2015;
                                            }
                                            let _e2068 = phi_10400_;
                                            if (_e2036 < 0f) {
                                                phi_10406_ = -(_e2036);
                                            } else {
                                                phi_10406_ = _e2036;
                                            }
                                            let _e2072 = phi_10406_;
                                            if (_e2020 < 0f) {
                                                phi_10415_ = -(_e2020);
                                            } else {
                                                phi_10415_ = _e2020;
                                            }
                                            let _e2079 = phi_10415_;
                                            if (_e2041 < 0f) {
                                                phi_10421_ = -(_e2041);
                                            } else {
                                                phi_10421_ = _e2041;
                                            }
                                            let _e2083 = phi_10421_;
                                            phi_10427_ = type_32(array<f32, 4>(_e2005, _e2010, _e2015, _e2020), array<f32, 4>(_e2026, _e2031, _e2036, _e2041), array<f32, 4>((_e2000 + ((_e2046 + _e2050) * _e1995)), (_e2000 + ((_e2057 + _e2061) * _e1995)), (_e2000 + ((_e2068 + _e2072) * _e1995)), (_e2000 + ((_e2079 + _e2083) * _e1995))));
                                            phi_10428_ = false;
                                        } else {
                                            phi_10427_ = type_32();
                                            phi_10428_ = true;
                                        }
                                        let _e2090 = phi_10427_;
                                        let _e2092 = phi_10428_;
                                        phi_10429_ = _e2090;
                                        phi_10430_ = _e2092;
                                    } else {
                                        phi_10429_ = type_32();
                                        phi_10430_ = true;
                                    }
                                    let _e2094 = phi_10429_;
                                    let _e2096 = phi_10430_;
                                    if _e2096 {
                                        phi_10438_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    } else {
                                        phi_10438_ = _e2094;
                                    }
                                    let _e2098 = phi_10438_;
                                    local_10 = type_32(array<f32, 4>(_e2098.member[0], _e2098.member[1], _e2098.member[2], _e2098.member[3]), array<f32, 4>(_e2098.member_1[0], _e2098.member_1[1], _e2098.member_1[2], _e2098.member_1[3]), array<f32, 4>(_e2098.member_2[0], _e2098.member_2[1], _e2098.member_2[2], _e2098.member_2[3]));
                                    let _e2120 = local_10.member[0u];
                                    let _e2123 = local_10.member_1[0u];
                                    let _e2126 = local_10.member[0u];
                                    let _e2132 = local_10.member_2[0u];
                                    if (((_e2120 + ((_e2123 - _e2126) * _e319)) - _e2132) > 0f) {
                                        let _e2137 = local_10.member[1u];
                                        let _e2140 = local_10.member_1[1u];
                                        let _e2143 = local_10.member[1u];
                                        let _e2149 = local_10.member_2[1u];
                                        if (((_e2137 + ((_e2140 - _e2143) * _e319)) - _e2149) > 0f) {
                                            let _e2154 = local_10.member[2u];
                                            let _e2157 = local_10.member_1[2u];
                                            let _e2160 = local_10.member[2u];
                                            let _e2166 = local_10.member_2[2u];
                                            if (((_e2154 + ((_e2157 - _e2160) * _e319)) - _e2166) > 0f) {
                                                let _e2171 = local_10.member[3u];
                                                let _e2174 = local_10.member_1[3u];
                                                let _e2177 = local_10.member[3u];
                                                let _e2183 = local_10.member_2[3u];
                                                phi_10607_ = (((_e2171 + ((_e2174 - _e2177) * _e319)) - _e2183) > 0f);
                                                phi_10608_ = false;
                                            } else {
                                                phi_10607_ = bool();
                                                phi_10608_ = true;
                                            }
                                            let _e2187 = phi_10607_;
                                            let _e2189 = phi_10608_;
                                            phi_10609_ = _e2187;
                                            phi_10610_ = _e2189;
                                        } else {
                                            phi_10609_ = bool();
                                            phi_10610_ = true;
                                        }
                                        let _e2191 = phi_10609_;
                                        let _e2193 = phi_10610_;
                                        phi_10611_ = _e2191;
                                        phi_10612_ = _e2193;
                                    } else {
                                        phi_10611_ = bool();
                                        phi_10612_ = true;
                                    }
                                    let _e2195 = phi_10611_;
                                    let _e2197 = phi_10612_;
                                    if _e2197 {
                                        phi_10616_ = false;
                                    } else {
                                        phi_10616_ = _e2195;
                                    }
                                    let _e2199 = phi_10616_;
                                    if _e2199 {
                                        phi_11067_ = bool();
                                    } else {
                                        if (_e1346[2] < 0f) {
                                            phi_10656_ = -(_e1346[2]);
                                        } else {
                                            phi_10656_ = _e1346[2];
                                        }
                                        let _e2205 = phi_10656_;
                                        let _e2206 = ((0f + 0f) + _e2205);
                                        if (_e2206 > 0f) {
                                            if ((bitcast<u32>(_e2206) & 2139095040u) != 2139095040u) {
                                                let _e2211 = (1f / _e2206);
                                                let _e2212 = (0f * _e2211);
                                                let _e2213 = (0f * _e2211);
                                                let _e2214 = (_e1346[2] * _e2211);
                                                let _e2219 = (((_e2212 * _e2212) + (_e2213 * _e2213)) + (_e2214 * _e2214));
                                                if (_e2219 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e2219 > 0f) {
                                                        phi_10690_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_10690_ = 0f;
                                                    }
                                                    let _e2272 = phi_10690_;
                                                    phi_10754_ = _e2272;
                                                } else {
                                                    phi_10697_ = type_14(0i, 5i);
                                                    phi_10700_ = bitcast<f32>(((bitcast<u32>(_e2219) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e2227 = phi_10697_;
                                                        let _e2229 = phi_10700_;
                                                        local_22 = _e2229;
                                                        if (_e2227.member < _e2227.member_1) {
                                                            let _e2236 = (_e2227.member + 1i);
                                                            if ((false == (_e2236 > _e2227.member)) != false) {
                                                                phi_10721_ = true;
                                                            } else {
                                                                phi_10721_ = false;
                                                            }
                                                            let _e2241 = phi_10721_;
                                                            if _e2241 {
                                                                phi_10727_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_10727_ = type_15(1u, _e2236);
                                                            }
                                                            let _e2246 = phi_10727_;
                                                            phi_10698_ = type_14(_e2246.member_1, _e2227.member_1);
                                                            phi_10741_ = type_15(1u, _e2227.member);
                                                        } else {
                                                            phi_10698_ = _e2227;
                                                            phi_10741_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e2252 = phi_10698_;
                                                        let _e2254 = phi_10741_;
                                                        let _e2257 = (bitcast<i32>(_e2254.member) != 0i);
                                                        if _e2257 {
                                                            phi_10701_ = (0.5f * (_e2229 + (_e2219 / _e2229)));
                                                        } else {
                                                            phi_10701_ = f32();
                                                        }
                                                        let _e2262 = phi_10701_;
                                                        continue;
                                                        continuing {
                                                            phi_10697_ = _e2252;
                                                            phi_10700_ = _e2262;
                                                            break if !(_e2257);
                                                        }
                                                    }
                                                    let _e2267 = local_22;
                                                    phi_10754_ = (_e2267 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e2274 = phi_10754_;
                                                let _e2275 = (0.000000059604645f * 12f);
                                                let _e2280 = ((_e1279 * 1.01f) + ((0f * _e2274) * (1f + _e2275)));
                                                let _e2285 = (((_e2212 * _e1062[0]) + (_e2213 * _e1062[1])) + (_e2214 * _e1062[2]));
                                                let _e2290 = (((_e2212 * _e1078) + (_e2213 * _e1079)) + (_e2214 * _e1080));
                                                let _e2295 = (((_e2212 * _e1081) + (_e2213 * _e1082)) + (_e2214 * _e1083));
                                                let _e2300 = (((_e2212 * _e1062[0]) + (_e2213 * _e1062[1])) + (_e2214 * _e1062[2]));
                                                let _e2306 = (((_e2212 * _e1086[0]) + (_e2213 * _e1086[1])) + (_e2214 * _e1086[2]));
                                                let _e2311 = (((_e2212 * _e1102) + (_e2213 * _e1103)) + (_e2214 * _e1104));
                                                let _e2316 = (((_e2212 * _e1105) + (_e2213 * _e1106)) + (_e2214 * _e1107));
                                                let _e2321 = (((_e2212 * _e1086[0]) + (_e2213 * _e1086[1])) + (_e2214 * _e1086[2]));
                                                if (_e2285 < 0f) {
                                                    phi_10820_ = -(_e2285);
                                                } else {
                                                    phi_10820_ = _e2285;
                                                }
                                                let _e2326 = phi_10820_;
                                                if (_e2306 < 0f) {
                                                    phi_10826_ = -(_e2306);
                                                } else {
                                                    phi_10826_ = _e2306;
                                                }
                                                let _e2330 = phi_10826_;
                                                if (_e2290 < 0f) {
                                                    phi_10835_ = -(_e2290);
                                                } else {
                                                    phi_10835_ = _e2290;
                                                }
                                                let _e2337 = phi_10835_;
                                                if (_e2311 < 0f) {
                                                    phi_10841_ = -(_e2311);
                                                } else {
                                                    phi_10841_ = _e2311;
                                                }
                                                let _e2341 = phi_10841_;
                                                if (_e2295 < 0f) {
                                                    phi_10850_ = -(_e2295);
                                                } else {
                                                    phi_10850_ = _e2295;
                                                }
                                                let _e2348 = phi_10850_;
                                                if (_e2316 < 0f) {
                                                    phi_10856_ = -(_e2316);
                                                } else {
                                                    phi_10856_ = _e2316;
                                                }
                                                let _e2352 = phi_10856_;
                                                if (_e2300 < 0f) {
                                                    phi_10865_ = -(_e2300);
                                                } else {
                                                    phi_10865_ = _e2300;
                                                }
                                                let _e2359 = phi_10865_;
                                                if (_e2321 < 0f) {
                                                    phi_10871_ = -(_e2321);
                                                } else {
                                                    phi_10871_ = _e2321;
                                                }
                                                let _e2363 = phi_10871_;
                                                phi_10877_ = type_32(array<f32, 4>(_e2285, _e2290, _e2295, _e2300), array<f32, 4>(_e2306, _e2311, _e2316, _e2321), array<f32, 4>((_e2280 + ((_e2326 + _e2330) * _e2275)), (_e2280 + ((_e2337 + _e2341) * _e2275)), (_e2280 + ((_e2348 + _e2352) * _e2275)), (_e2280 + ((_e2359 + _e2363) * _e2275))));
                                                phi_10878_ = false;
                                            } else {
                                                phi_10877_ = type_32();
                                                phi_10878_ = true;
                                            }
                                            let _e2370 = phi_10877_;
                                            let _e2372 = phi_10878_;
                                            phi_10879_ = _e2370;
                                            phi_10880_ = _e2372;
                                        } else {
                                            phi_10879_ = type_32();
                                            phi_10880_ = true;
                                        }
                                        let _e2374 = phi_10879_;
                                        let _e2376 = phi_10880_;
                                        if _e2376 {
                                            phi_10888_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_10888_ = _e2374;
                                        }
                                        let _e2378 = phi_10888_;
                                        local_11 = type_32(array<f32, 4>(_e2378.member[0], _e2378.member[1], _e2378.member[2], _e2378.member[3]), array<f32, 4>(_e2378.member_1[0], _e2378.member_1[1], _e2378.member_1[2], _e2378.member_1[3]), array<f32, 4>(_e2378.member_2[0], _e2378.member_2[1], _e2378.member_2[2], _e2378.member_2[3]));
                                        let _e2400 = local_11.member[0u];
                                        let _e2403 = local_11.member_1[0u];
                                        let _e2406 = local_11.member[0u];
                                        let _e2412 = local_11.member_2[0u];
                                        if (((_e2400 + ((_e2403 - _e2406) * _e319)) - _e2412) > 0f) {
                                            let _e2417 = local_11.member[1u];
                                            let _e2420 = local_11.member_1[1u];
                                            let _e2423 = local_11.member[1u];
                                            let _e2429 = local_11.member_2[1u];
                                            if (((_e2417 + ((_e2420 - _e2423) * _e319)) - _e2429) > 0f) {
                                                let _e2434 = local_11.member[2u];
                                                let _e2437 = local_11.member_1[2u];
                                                let _e2440 = local_11.member[2u];
                                                let _e2446 = local_11.member_2[2u];
                                                if (((_e2434 + ((_e2437 - _e2440) * _e319)) - _e2446) > 0f) {
                                                    let _e2451 = local_11.member[3u];
                                                    let _e2454 = local_11.member_1[3u];
                                                    let _e2457 = local_11.member[3u];
                                                    let _e2463 = local_11.member_2[3u];
                                                    phi_11057_ = (((_e2451 + ((_e2454 - _e2457) * _e319)) - _e2463) > 0f);
                                                    phi_11058_ = false;
                                                } else {
                                                    phi_11057_ = bool();
                                                    phi_11058_ = true;
                                                }
                                                let _e2467 = phi_11057_;
                                                let _e2469 = phi_11058_;
                                                phi_11059_ = _e2467;
                                                phi_11060_ = _e2469;
                                            } else {
                                                phi_11059_ = bool();
                                                phi_11060_ = true;
                                            }
                                            let _e2471 = phi_11059_;
                                            let _e2473 = phi_11060_;
                                            phi_11061_ = _e2471;
                                            phi_11062_ = _e2473;
                                        } else {
                                            phi_11061_ = bool();
                                            phi_11062_ = true;
                                        }
                                        let _e2475 = phi_11061_;
                                        let _e2477 = phi_11062_;
                                        if _e2477 {
                                            phi_11066_ = false;
                                        } else {
                                            phi_11066_ = _e2475;
                                        }
                                        let _e2479 = phi_11066_;
                                        phi_11067_ = _e2479;
                                    }
                                    let _e2481 = phi_11067_;
                                    phi_11068_ = _e2481;
                                    phi_11069_ = _e2199;
                                }
                                let _e2483 = phi_11068_;
                                let _e2485 = phi_11069_;
                                phi_11070_ = _e2483;
                                phi_11071_ = _e2485;
                            }
                            let _e2487 = phi_11070_;
                            let _e2489 = phi_11071_;
                            if _e2489 {
                                phi_11075_ = true;
                            } else {
                                phi_11075_ = _e2487;
                            }
                            let _e2491 = phi_11075_;
                            if !(_e2491) {
                                phi_11081_ = type_28(2u, _e319);
                                phi_11082_ = false;
                            } else {
                                phi_11081_ = type_28();
                                phi_11082_ = true;
                            }
                            let _e2495 = phi_11081_;
                            let _e2497 = phi_11082_;
                            phi_11083_ = _e2495;
                            phi_11084_ = _e2497;
                        } else {
                            phi_11083_ = type_28();
                            phi_11084_ = true;
                        }
                        let _e2499 = phi_11083_;
                        let _e2501 = phi_11084_;
                        if _e2501 {
                            let _e2507 = ((_e683 - (3f * _e660)) * _e1037);
                            let _e2508 = ((_e706 - _e683) * _e1037);
                            let _e2509 = (((3f * _e717) - _e706) * _e1037);
                            local_6[0u] = 0f;
                            local_6[1u] = 1f;
                            local_6[2u] = 1f;
                            local_6[3u] = 1f;
                            let _e2516 = ((_e2508 * _e2508) - (_e2507 * _e2509));
                            if (_e2516 > 0f) {
                                if (_e2516 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e2516 > 0f) {
                                        phi_11120_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_11120_ = 0f;
                                    }
                                    let _e2570 = phi_11120_;
                                    phi_11184_ = _e2570;
                                } else {
                                    phi_11127_ = type_14(0i, 5i);
                                    phi_11130_ = bitcast<f32>(((bitcast<u32>(_e2516) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e2525 = phi_11127_;
                                        let _e2527 = phi_11130_;
                                        local_23 = _e2527;
                                        if (_e2525.member < _e2525.member_1) {
                                            let _e2534 = (_e2525.member + 1i);
                                            if ((false == (_e2534 > _e2525.member)) != false) {
                                                phi_11151_ = true;
                                            } else {
                                                phi_11151_ = false;
                                            }
                                            let _e2539 = phi_11151_;
                                            if _e2539 {
                                                phi_11157_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_11157_ = type_15(1u, _e2534);
                                            }
                                            let _e2544 = phi_11157_;
                                            phi_11128_ = type_14(_e2544.member_1, _e2525.member_1);
                                            phi_11171_ = type_15(1u, _e2525.member);
                                        } else {
                                            phi_11128_ = _e2525;
                                            phi_11171_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2550 = phi_11128_;
                                        let _e2552 = phi_11171_;
                                        let _e2555 = (bitcast<i32>(_e2552.member) != 0i);
                                        if _e2555 {
                                            phi_11131_ = (0.5f * (_e2527 + (_e2516 / _e2527)));
                                        } else {
                                            phi_11131_ = f32();
                                        }
                                        let _e2560 = phi_11131_;
                                        continue;
                                        continuing {
                                            phi_11127_ = _e2550;
                                            phi_11130_ = _e2560;
                                            break if !(_e2555);
                                        }
                                    }
                                    let _e2565 = local_23;
                                    phi_11184_ = (_e2565 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2572 = phi_11184_;
                                if (_e2508 < 0f) {
                                    phi_11190_ = -(_e2572);
                                } else {
                                    phi_11190_ = _e2572;
                                }
                                let _e2576 = phi_11190_;
                                let _e2578 = -((_e2508 + _e2576));
                                local_7[0u] = (_e2578 / (_e2578 + _e2509));
                                local_7[1u] = (_e2507 / (_e2507 + _e2578));
                                let _e2587 = local_7[1u];
                                let _e2588 = local_7[0u];
                                if (_e2587 < _e2588) {
                                    let _e2591 = local_7[1u];
                                    let _e2593 = local_7[0u];
                                    local_7[0u] = _e2591;
                                    local_7[1u] = _e2593;
                                }
                                phi_11215_ = type_12(0u, 2u);
                                phi_11218_ = 1u;
                                loop {
                                    let _e2597 = phi_11215_;
                                    let _e2599 = phi_11218_;
                                    local_63 = _e2599;
                                    if (_e2597.member < _e2597.member_1) {
                                        phi_11216_ = type_12((_e2597.member + 1u), _e2597.member_1);
                                        phi_11241_ = type_12(1u, _e2597.member);
                                    } else {
                                        phi_11216_ = _e2597;
                                        phi_11241_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2611 = phi_11216_;
                                    let _e2613 = phi_11241_;
                                    let _e2617 = (bitcast<i32>(_e2613.member) != 0i);
                                    if _e2617 {
                                        let _e2619 = local_7[_e2613.member_1];
                                        if (_e2619 > 0f) {
                                            let _e2622 = local_7[_e2613.member_1];
                                            if (_e2622 < 1f) {
                                                let _e2625 = local_7[_e2613.member_1];
                                                local_6[_e2599] = _e2625;
                                                phi_11285_ = (_e2599 + 1u);
                                            } else {
                                                phi_11285_ = _e2599;
                                            }
                                            let _e2629 = phi_11285_;
                                            phi_11286_ = _e2629;
                                        } else {
                                            phi_11286_ = _e2599;
                                        }
                                        let _e2631 = phi_11286_;
                                        phi_11219_ = _e2631;
                                    } else {
                                        phi_11219_ = u32();
                                    }
                                    let _e2633 = phi_11219_;
                                    continue;
                                    continuing {
                                        phi_11215_ = _e2611;
                                        phi_11218_ = _e2633;
                                        break if !(_e2617);
                                    }
                                }
                                let _e10205 = local_63;
                                phi_11287_ = _e10205;
                            } else {
                                phi_11287_ = 1u;
                            }
                            let _e2636 = phi_11287_;
                            local_6[_e2636] = 1f;
                            let _e2638 = local_6;
                            local_12 = _e2638;
                            phi_11307_ = type_12(0u, _e2636);
                            loop {
                                let _e2641 = phi_11307_;
                                if (_e2641.member < _e2641.member_1) {
                                    phi_11308_ = type_12((_e2641.member + 1u), _e2641.member_1);
                                    phi_11331_ = type_12(1u, _e2641.member);
                                } else {
                                    phi_11308_ = _e2641;
                                    phi_11331_ = type_12(0u, type_12().member_1);
                                }
                                let _e2653 = phi_11308_;
                                let _e2655 = phi_11331_;
                                if (bitcast<i32>(_e2655.member) != 0i) {
                                    let _e2661 = local_12[_e2655.member_1];
                                    if (_e2661 > _e319) {
                                        phi_11350_ = _e2661;
                                    } else {
                                        phi_11350_ = _e319;
                                    }
                                    let _e2664 = phi_11350_;
                                    let _e2667 = local_12[(_e2655.member_1 + 1u)];
                                    if (_e2667 < _e321) {
                                        phi_11363_ = _e2667;
                                    } else {
                                        phi_11363_ = _e321;
                                    }
                                    let _e2670 = phi_11363_;
                                    if (_e2664 <= _e2670) {
                                        let _e2672 = (1f - _e2664);
                                        let _e2683 = ((((_e660 * _e2672) + (_e683 * _e2664)) * (_e2672 * _e2672)) + (((_e706 * _e2672) + (_e717 * _e2664)) * (_e2664 * _e2664)));
                                        let _e2684 = (1f - _e2670);
                                        let _e2695 = ((((_e660 * _e2684) + (_e683 * _e2670)) * (_e2684 * _e2684)) + (((_e706 * _e2684) + (_e717 * _e2670)) * (_e2670 * _e2670)));
                                        if (_e2683 < 0f) {
                                            phi_11397_ = -(_e2683);
                                        } else {
                                            phi_11397_ = _e2683;
                                        }
                                        let _e2699 = phi_11397_;
                                        let _e2700 = (_e2699 > _e1034);
                                        if (_e2695 < 0f) {
                                            phi_11404_ = -(_e2695);
                                        } else {
                                            phi_11404_ = _e2695;
                                        }
                                        let _e2704 = phi_11404_;
                                        let _e2705 = (_e2704 > _e1034);
                                        if _e2700 {
                                            if _e2705 {
                                                phi_11415_ = ((_e2683 > 0f) != (_e2695 > 0f));
                                                phi_11416_ = false;
                                            } else {
                                                phi_11415_ = bool();
                                                phi_11416_ = true;
                                            }
                                            let _e2710 = phi_11415_;
                                            let _e2712 = phi_11416_;
                                            phi_11417_ = _e2710;
                                            phi_11418_ = _e2712;
                                        } else {
                                            phi_11417_ = bool();
                                            phi_11418_ = true;
                                        }
                                        let _e2714 = phi_11417_;
                                        let _e2716 = phi_11418_;
                                        if _e2716 {
                                            phi_11422_ = false;
                                        } else {
                                            phi_11422_ = _e2714;
                                        }
                                        let _e2718 = phi_11422_;
                                        if _e2700 {
                                            if _e2705 {
                                                if _e2718 {
                                                    phi_11433_ = type_41();
                                                } else {
                                                    phi_11433_ = type_41(1f, 0f, _e2718);
                                                }
                                                let _e2721 = phi_11433_;
                                                phi_11434_ = _e2721;
                                                phi_11435_ = _e2718;
                                            } else {
                                                phi_11434_ = type_41();
                                                phi_11435_ = true;
                                            }
                                            let _e2723 = phi_11434_;
                                            let _e2725 = phi_11435_;
                                            phi_11436_ = _e2723;
                                            phi_11437_ = _e2725;
                                        } else {
                                            phi_11436_ = type_41();
                                            phi_11437_ = true;
                                        }
                                        let _e2727 = phi_11436_;
                                        let _e2729 = phi_11437_;
                                        if _e2729 {
                                            if _e2700 {
                                                if (_e2683 < 0f) {
                                                    phi_11448_ = -1f;
                                                } else {
                                                    phi_11448_ = 1f;
                                                }
                                                let _e2732 = phi_11448_;
                                                let _e2735 = (_e706 - _e683);
                                                phi_11458_ = type_12(0u, 64u);
                                                phi_11461_ = _e2670;
                                                phi_11463_ = _e2664;
                                                phi_11465_ = (0.5f * (_e2664 + _e2670));
                                                loop {
                                                    let _e2741 = phi_11458_;
                                                    let _e2743 = phi_11461_;
                                                    let _e2745 = phi_11463_;
                                                    let _e2747 = phi_11465_;
                                                    local_65 = _e2745;
                                                    if (_e2741.member < _e2741.member_1) {
                                                        phi_11459_ = type_12((_e2741.member + 1u), _e2741.member_1);
                                                        phi_11488_ = type_12(1u, _e2741.member);
                                                    } else {
                                                        phi_11459_ = _e2741;
                                                        phi_11488_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2759 = phi_11459_;
                                                    let _e2761 = phi_11488_;
                                                    if (bitcast<i32>(_e2761.member) != 0i) {
                                                        let _e2765 = (1f - _e2747);
                                                        let _e2778 = ((_e2732 * ((((_e660 * _e2765) + (_e683 * _e2747)) * (_e2765 * _e2765)) + (((_e706 * _e2765) + (_e717 * _e2747)) * (_e2747 * _e2747)))) - _e1034);
                                                        if (_e2778 > 0f) {
                                                            phi_11513_ = _e2743;
                                                            phi_11514_ = _e2747;
                                                        } else {
                                                            phi_11513_ = _e2747;
                                                            phi_11514_ = _e2745;
                                                        }
                                                        let _e2781 = phi_11513_;
                                                        let _e2783 = phi_11514_;
                                                        let _e2785 = ((_e2781 - _e2783) > _e1041);
                                                        if _e2785 {
                                                            let _e2786 = (1f - _e2747);
                                                            let _e2798 = (-(_e2778) / (_e2732 * (((((_e683 - (3f * _e660)) * _e2786) + (_e2735 * _e2747)) * _e2786) + (((_e2735 * _e2786) + (((3f * _e717) - _e706) * _e2747)) * _e2747))));
                                                            if (_e2778 > 0f) {
                                                                phi_11540_ = (0.5f * _e1041);
                                                            } else {
                                                                phi_11540_ = -((0.5f * _e1041));
                                                            }
                                                            let _e2804 = phi_11540_;
                                                            let _e2806 = ((_e2747 + _e2798) + _e2804);
                                                            if (_e2806 > _e2783) {
                                                                if (_e2806 < _e2781) {
                                                                    if (_e2798 < 0f) {
                                                                        phi_11556_ = -(_e2798);
                                                                    } else {
                                                                        phi_11556_ = _e2798;
                                                                    }
                                                                    let _e2812 = phi_11556_;
                                                                    if (_e2812 < (0.5f * (_e2781 - _e2783))) {
                                                                        phi_11563_ = false;
                                                                    } else {
                                                                        phi_11563_ = true;
                                                                    }
                                                                    let _e2817 = phi_11563_;
                                                                    phi_11564_ = _e2817;
                                                                } else {
                                                                    phi_11564_ = true;
                                                                }
                                                                let _e2819 = phi_11564_;
                                                                phi_11565_ = _e2819;
                                                            } else {
                                                                phi_11565_ = true;
                                                            }
                                                            let _e2821 = phi_11565_;
                                                            if _e2821 {
                                                                phi_11571_ = (0.5f * (_e2783 + _e2781));
                                                            } else {
                                                                phi_11571_ = _e2806;
                                                            }
                                                            let _e2825 = phi_11571_;
                                                            phi_11572_ = _e2825;
                                                            phi_11573_ = false;
                                                        } else {
                                                            phi_11572_ = f32();
                                                            phi_11573_ = true;
                                                        }
                                                        let _e2827 = phi_11572_;
                                                        let _e2829 = phi_11573_;
                                                        phi_11462_ = _e2781;
                                                        phi_11464_ = _e2783;
                                                        phi_11466_ = _e2827;
                                                        phi_11574_ = _e2783;
                                                        phi_11575_ = _e2785;
                                                        phi_11576_ = _e2829;
                                                    } else {
                                                        phi_11462_ = f32();
                                                        phi_11464_ = f32();
                                                        phi_11466_ = f32();
                                                        phi_11574_ = f32();
                                                        phi_11575_ = false;
                                                        phi_11576_ = false;
                                                    }
                                                    let _e2831 = phi_11462_;
                                                    let _e2833 = phi_11464_;
                                                    let _e2835 = phi_11466_;
                                                    let _e2837 = phi_11574_;
                                                    let _e2839 = phi_11575_;
                                                    let _e2841 = phi_11576_;
                                                    local_24 = _e2841;
                                                    local_64 = _e2837;
                                                    continue;
                                                    continuing {
                                                        phi_11458_ = _e2759;
                                                        phi_11461_ = _e2831;
                                                        phi_11463_ = _e2833;
                                                        phi_11465_ = _e2835;
                                                        break if !(_e2839);
                                                    }
                                                }
                                                let _e2844 = local_24;
                                                if _e2844 {
                                                    let _e10249 = local_64;
                                                    phi_11580_ = _e10249;
                                                } else {
                                                    let _e10251 = local_65;
                                                    phi_11580_ = _e10251;
                                                }
                                                let _e2846 = phi_11580_;
                                                phi_11581_ = _e2846;
                                            } else {
                                                phi_11581_ = _e2664;
                                            }
                                            let _e2848 = phi_11581_;
                                            if _e2705 {
                                                if (_e2695 < 0f) {
                                                    phi_11589_ = -1f;
                                                } else {
                                                    phi_11589_ = 1f;
                                                }
                                                let _e2851 = phi_11589_;
                                                phi_11593_ = type_12(0u, 64u);
                                                phi_11596_ = (_e1041 + _e1041);
                                                loop {
                                                    let _e2854 = phi_11593_;
                                                    let _e2856 = phi_11596_;
                                                    if (_e2854.member < _e2854.member_1) {
                                                        phi_11594_ = type_12((_e2854.member + 1u), _e2854.member_1);
                                                        phi_11619_ = type_12(1u, _e2854.member);
                                                    } else {
                                                        phi_11594_ = _e2854;
                                                        phi_11619_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2868 = phi_11594_;
                                                    let _e2870 = phi_11619_;
                                                    if (bitcast<i32>(_e2870.member) != 0i) {
                                                        let _e2874 = (_e2848 + _e2856);
                                                        if (_e2874 < _e2670) {
                                                            let _e2876 = (1f - _e2874);
                                                            let _e2889 = ((_e2851 * ((((_e660 * _e2876) + (_e683 * _e2874)) * (_e2876 * _e2876)) + (((_e706 * _e2876) + (_e717 * _e2874)) * (_e2874 * _e2874)))) > _e1034);
                                                            if _e2889 {
                                                                phi_11649_ = f32();
                                                                phi_11650_ = false;
                                                            } else {
                                                                phi_11649_ = (_e2856 + _e2856);
                                                                phi_11650_ = true;
                                                            }
                                                            let _e2892 = phi_11649_;
                                                            let _e2894 = phi_11650_;
                                                            phi_11651_ = _e2892;
                                                            phi_11652_ = _e2894;
                                                            phi_11653_ = _e2889;
                                                            phi_11654_ = false;
                                                        } else {
                                                            phi_11651_ = f32();
                                                            phi_11652_ = false;
                                                            phi_11653_ = false;
                                                            phi_11654_ = true;
                                                        }
                                                        let _e2896 = phi_11651_;
                                                        let _e2898 = phi_11652_;
                                                        let _e2900 = phi_11653_;
                                                        let _e2902 = phi_11654_;
                                                        phi_11655_ = _e2874;
                                                        phi_11597_ = _e2896;
                                                        phi_11656_ = _e2898;
                                                        phi_11657_ = _e2900;
                                                        phi_11658_ = _e2902;
                                                        phi_11659_ = false;
                                                    } else {
                                                        phi_11655_ = f32();
                                                        phi_11597_ = f32();
                                                        phi_11656_ = false;
                                                        phi_11657_ = false;
                                                        phi_11658_ = false;
                                                        phi_11659_ = true;
                                                    }
                                                    let _e2904 = phi_11655_;
                                                    let _e2906 = phi_11597_;
                                                    let _e2908 = phi_11656_;
                                                    let _e2910 = phi_11657_;
                                                    let _e2912 = phi_11658_;
                                                    let _e2914 = phi_11659_;
                                                    local_25 = _e2910;
                                                    local_66 = _e2912;
                                                    local_67 = _e2914;
                                                    local_68 = _e2904;
                                                    continue;
                                                    continuing {
                                                        phi_11593_ = _e2868;
                                                        phi_11596_ = _e2906;
                                                        break if !(_e2908);
                                                    }
                                                }
                                                let _e2917 = local_25;
                                                if _e2917 {
                                                    phi_11663_ = false;
                                                    phi_11664_ = false;
                                                } else {
                                                    let _e10273 = local_66;
                                                    phi_11663_ = _e10273;
                                                    let _e10276 = local_67;
                                                    phi_11664_ = _e10276;
                                                }
                                                let _e2919 = phi_11663_;
                                                let _e2921 = phi_11664_;
                                                if _e2919 {
                                                    phi_11668_ = true;
                                                } else {
                                                    phi_11668_ = _e2921;
                                                }
                                                let _e2923 = phi_11668_;
                                                if _e2923 {
                                                    phi_11672_ = _e2670;
                                                } else {
                                                    let _e10280 = local_68;
                                                    phi_11672_ = _e10280;
                                                }
                                                let _e2925 = phi_11672_;
                                                phi_11673_ = _e2925;
                                            } else {
                                                phi_11673_ = _e2670;
                                            }
                                            let _e2927 = phi_11673_;
                                            phi_11675_ = type_41(_e2848, _e2927, _e2718);
                                        } else {
                                            phi_11675_ = _e2727;
                                        }
                                        let _e2930 = phi_11675_;
                                        if (_e2930.member > _e2930.member_1) {
                                            phi_15468_ = bool();
                                            phi_15469_ = f32();
                                            phi_15470_ = f32();
                                            phi_15471_ = true;
                                            phi_15472_ = false;
                                            phi_15473_ = false;
                                            phi_15474_ = false;
                                        } else {
                                            let _e2937 = ((_e2930.member_1 - _e2930.member) * 0.5f);
                                            let _e2938 = (_e2930.member + _e2937);
                                            let _e2940 = (_e2937 + (0.000000059604645f * 4f));
                                            let _e2942 = local_18.member_3;
                                            let _e2945 = local_18.member[0u];
                                            if (_e2945[0] < 0f) {
                                                phi_11704_ = -(_e2945[0]);
                                            } else {
                                                phi_11704_ = _e2945[0];
                                            }
                                            let _e2952 = phi_11704_;
                                            if (_e2945[1] < 0f) {
                                                phi_11711_ = -(_e2945[1]);
                                            } else {
                                                phi_11711_ = _e2945[1];
                                            }
                                            let _e2956 = phi_11711_;
                                            if (_e2952 > _e2956) {
                                                phi_11716_ = _e2952;
                                            } else {
                                                phi_11716_ = _e2956;
                                            }
                                            let _e2959 = phi_11716_;
                                            if (_e2945[2] < 0f) {
                                                phi_11723_ = -(_e2945[2]);
                                            } else {
                                                phi_11723_ = _e2945[2];
                                            }
                                            let _e2963 = phi_11723_;
                                            if (_e2959 > _e2963) {
                                                phi_11728_ = _e2959;
                                            } else {
                                                phi_11728_ = _e2963;
                                            }
                                            let _e2966 = phi_11728_;
                                            let _e2968 = local_18.member[1u];
                                            if (_e2968[0] < 0f) {
                                                phi_11741_ = -(_e2968[0]);
                                            } else {
                                                phi_11741_ = _e2968[0];
                                            }
                                            let _e2975 = phi_11741_;
                                            if (_e2968[1] < 0f) {
                                                phi_11748_ = -(_e2968[1]);
                                            } else {
                                                phi_11748_ = _e2968[1];
                                            }
                                            let _e2979 = phi_11748_;
                                            if (_e2975 > _e2979) {
                                                phi_11753_ = _e2975;
                                            } else {
                                                phi_11753_ = _e2979;
                                            }
                                            let _e2982 = phi_11753_;
                                            if (_e2968[2] < 0f) {
                                                phi_11760_ = -(_e2968[2]);
                                            } else {
                                                phi_11760_ = _e2968[2];
                                            }
                                            let _e2986 = phi_11760_;
                                            if (_e2982 > _e2986) {
                                                phi_11765_ = _e2982;
                                            } else {
                                                phi_11765_ = _e2986;
                                            }
                                            let _e2989 = phi_11765_;
                                            if (_e2966 > _e2989) {
                                                phi_11770_ = _e2966;
                                            } else {
                                                phi_11770_ = _e2989;
                                            }
                                            let _e2992 = phi_11770_;
                                            let _e2995 = local_18.member[0u];
                                            let _e3000 = local_18.member[1u];
                                            let _e3010 = (_e2995[0] + ((_e3000[0] - _e2995[0]) * _e2938));
                                            let _e3011 = (_e2995[1] + ((_e3000[1] - _e2995[1]) * _e2938));
                                            let _e3012 = (_e2995[2] + ((_e3000[2] - _e2995[2]) * _e2938));
                                            let _e3014 = local_18.member[1u];
                                            let _e3019 = local_18.member[0u];
                                            let _e3023 = (_e3014[0] - _e3019[0]);
                                            let _e3024 = (_e3014[1] - _e3019[1]);
                                            let _e3025 = (_e3014[2] - _e3019[2]);
                                            if (_e3023 < 0f) {
                                                phi_11829_ = -(_e3023);
                                            } else {
                                                phi_11829_ = _e3023;
                                            }
                                            let _e3029 = phi_11829_;
                                            if (_e3024 < 0f) {
                                                phi_11835_ = -(_e3024);
                                            } else {
                                                phi_11835_ = _e3024;
                                            }
                                            let _e3033 = phi_11835_;
                                            if (_e3029 > _e3033) {
                                                phi_11840_ = _e3029;
                                            } else {
                                                phi_11840_ = _e3033;
                                            }
                                            let _e3036 = phi_11840_;
                                            if (_e3025 < 0f) {
                                                phi_11846_ = -(_e3025);
                                            } else {
                                                phi_11846_ = _e3025;
                                            }
                                            let _e3040 = phi_11846_;
                                            if (_e3036 > _e3040) {
                                                phi_11851_ = _e3036;
                                            } else {
                                                phi_11851_ = _e3040;
                                            }
                                            let _e3043 = phi_11851_;
                                            let _e3049 = ((((_e2940 * _e3043) * 1.01f) + ((_e2992 + _e2942) * (0.000000059604645f * 8f))) + _e2942);
                                            if (_e3010 < 0f) {
                                                phi_11863_ = -(_e3010);
                                            } else {
                                                phi_11863_ = _e3010;
                                            }
                                            let _e3053 = phi_11863_;
                                            if (_e3011 < 0f) {
                                                phi_11869_ = -(_e3011);
                                            } else {
                                                phi_11869_ = _e3011;
                                            }
                                            let _e3057 = phi_11869_;
                                            if (_e3053 > _e3057) {
                                                phi_11874_ = _e3053;
                                            } else {
                                                phi_11874_ = _e3057;
                                            }
                                            let _e3060 = phi_11874_;
                                            if (_e3012 < 0f) {
                                                phi_11880_ = -(_e3012);
                                            } else {
                                                phi_11880_ = _e3012;
                                            }
                                            let _e3064 = phi_11880_;
                                            if (_e3060 > _e3064) {
                                                phi_11885_ = _e3060;
                                            } else {
                                                phi_11885_ = _e3064;
                                            }
                                            let _e3067 = phi_11885_;
                                            local_2 = type_24(array<f32, 3>(_e3010, _e3011, _e3012), _e3049, (_e3067 + _e3049));
                                            let _e3073 = local_18.member_3;
                                            let _e3075 = local_18.member_1[0u];
                                            if (_e3075[0] < 0f) {
                                                phi_11911_ = -(_e3075[0]);
                                            } else {
                                                phi_11911_ = _e3075[0];
                                            }
                                            let _e3082 = phi_11911_;
                                            if (_e3075[1] < 0f) {
                                                phi_11918_ = -(_e3075[1]);
                                            } else {
                                                phi_11918_ = _e3075[1];
                                            }
                                            let _e3086 = phi_11918_;
                                            if (_e3082 > _e3086) {
                                                phi_11923_ = _e3082;
                                            } else {
                                                phi_11923_ = _e3086;
                                            }
                                            let _e3089 = phi_11923_;
                                            if (_e3075[2] < 0f) {
                                                phi_11930_ = -(_e3075[2]);
                                            } else {
                                                phi_11930_ = _e3075[2];
                                            }
                                            let _e3093 = phi_11930_;
                                            if (_e3089 > _e3093) {
                                                phi_11935_ = _e3089;
                                            } else {
                                                phi_11935_ = _e3093;
                                            }
                                            let _e3096 = phi_11935_;
                                            let _e3098 = local_18.member_1[1u];
                                            if (_e3098[0] < 0f) {
                                                phi_11948_ = -(_e3098[0]);
                                            } else {
                                                phi_11948_ = _e3098[0];
                                            }
                                            let _e3105 = phi_11948_;
                                            if (_e3098[1] < 0f) {
                                                phi_11955_ = -(_e3098[1]);
                                            } else {
                                                phi_11955_ = _e3098[1];
                                            }
                                            let _e3109 = phi_11955_;
                                            if (_e3105 > _e3109) {
                                                phi_11960_ = _e3105;
                                            } else {
                                                phi_11960_ = _e3109;
                                            }
                                            let _e3112 = phi_11960_;
                                            if (_e3098[2] < 0f) {
                                                phi_11967_ = -(_e3098[2]);
                                            } else {
                                                phi_11967_ = _e3098[2];
                                            }
                                            let _e3116 = phi_11967_;
                                            if (_e3112 > _e3116) {
                                                phi_11972_ = _e3112;
                                            } else {
                                                phi_11972_ = _e3116;
                                            }
                                            let _e3119 = phi_11972_;
                                            if (_e3096 > _e3119) {
                                                phi_11977_ = _e3096;
                                            } else {
                                                phi_11977_ = _e3119;
                                            }
                                            let _e3122 = phi_11977_;
                                            let _e3125 = local_18.member_1[0u];
                                            let _e3130 = local_18.member_1[1u];
                                            let _e3140 = (_e3125[0] + ((_e3130[0] - _e3125[0]) * _e2938));
                                            let _e3141 = (_e3125[1] + ((_e3130[1] - _e3125[1]) * _e2938));
                                            let _e3142 = (_e3125[2] + ((_e3130[2] - _e3125[2]) * _e2938));
                                            let _e3144 = local_18.member_1[1u];
                                            let _e3149 = local_18.member_1[0u];
                                            let _e3153 = (_e3144[0] - _e3149[0]);
                                            let _e3154 = (_e3144[1] - _e3149[1]);
                                            let _e3155 = (_e3144[2] - _e3149[2]);
                                            if (_e3153 < 0f) {
                                                phi_12036_ = -(_e3153);
                                            } else {
                                                phi_12036_ = _e3153;
                                            }
                                            let _e3159 = phi_12036_;
                                            if (_e3154 < 0f) {
                                                phi_12042_ = -(_e3154);
                                            } else {
                                                phi_12042_ = _e3154;
                                            }
                                            let _e3163 = phi_12042_;
                                            if (_e3159 > _e3163) {
                                                phi_12047_ = _e3159;
                                            } else {
                                                phi_12047_ = _e3163;
                                            }
                                            let _e3166 = phi_12047_;
                                            if (_e3155 < 0f) {
                                                phi_12053_ = -(_e3155);
                                            } else {
                                                phi_12053_ = _e3155;
                                            }
                                            let _e3170 = phi_12053_;
                                            if (_e3166 > _e3170) {
                                                phi_12058_ = _e3166;
                                            } else {
                                                phi_12058_ = _e3170;
                                            }
                                            let _e3173 = phi_12058_;
                                            let _e3179 = ((((_e2940 * _e3173) * 1.01f) + ((_e3122 + _e3073) * (0.000000059604645f * 8f))) + _e3073);
                                            if (_e3140 < 0f) {
                                                phi_12070_ = -(_e3140);
                                            } else {
                                                phi_12070_ = _e3140;
                                            }
                                            let _e3183 = phi_12070_;
                                            if (_e3141 < 0f) {
                                                phi_12076_ = -(_e3141);
                                            } else {
                                                phi_12076_ = _e3141;
                                            }
                                            let _e3187 = phi_12076_;
                                            if (_e3183 > _e3187) {
                                                phi_12081_ = _e3183;
                                            } else {
                                                phi_12081_ = _e3187;
                                            }
                                            let _e3190 = phi_12081_;
                                            if (_e3142 < 0f) {
                                                phi_12087_ = -(_e3142);
                                            } else {
                                                phi_12087_ = _e3142;
                                            }
                                            let _e3194 = phi_12087_;
                                            if (_e3190 > _e3194) {
                                                phi_12092_ = _e3190;
                                            } else {
                                                phi_12092_ = _e3194;
                                            }
                                            let _e3197 = phi_12092_;
                                            local_3 = type_24(array<f32, 3>(_e3140, _e3141, _e3142), _e3179, (_e3197 + _e3179));
                                            let _e3203 = local_18.member_3;
                                            let _e3205 = local_18.member_2[0u];
                                            if (_e3205[0] < 0f) {
                                                phi_12118_ = -(_e3205[0]);
                                            } else {
                                                phi_12118_ = _e3205[0];
                                            }
                                            let _e3212 = phi_12118_;
                                            if (_e3205[1] < 0f) {
                                                phi_12125_ = -(_e3205[1]);
                                            } else {
                                                phi_12125_ = _e3205[1];
                                            }
                                            let _e3216 = phi_12125_;
                                            if (_e3212 > _e3216) {
                                                phi_12130_ = _e3212;
                                            } else {
                                                phi_12130_ = _e3216;
                                            }
                                            let _e3219 = phi_12130_;
                                            if (_e3205[2] < 0f) {
                                                phi_12137_ = -(_e3205[2]);
                                            } else {
                                                phi_12137_ = _e3205[2];
                                            }
                                            let _e3223 = phi_12137_;
                                            if (_e3219 > _e3223) {
                                                phi_12142_ = _e3219;
                                            } else {
                                                phi_12142_ = _e3223;
                                            }
                                            let _e3226 = phi_12142_;
                                            let _e3228 = local_18.member_2[1u];
                                            if (_e3228[0] < 0f) {
                                                phi_12155_ = -(_e3228[0]);
                                            } else {
                                                phi_12155_ = _e3228[0];
                                            }
                                            let _e3235 = phi_12155_;
                                            if (_e3228[1] < 0f) {
                                                phi_12162_ = -(_e3228[1]);
                                            } else {
                                                phi_12162_ = _e3228[1];
                                            }
                                            let _e3239 = phi_12162_;
                                            if (_e3235 > _e3239) {
                                                phi_12167_ = _e3235;
                                            } else {
                                                phi_12167_ = _e3239;
                                            }
                                            let _e3242 = phi_12167_;
                                            if (_e3228[2] < 0f) {
                                                phi_12174_ = -(_e3228[2]);
                                            } else {
                                                phi_12174_ = _e3228[2];
                                            }
                                            let _e3246 = phi_12174_;
                                            if (_e3242 > _e3246) {
                                                phi_12179_ = _e3242;
                                            } else {
                                                phi_12179_ = _e3246;
                                            }
                                            let _e3249 = phi_12179_;
                                            if (_e3226 > _e3249) {
                                                phi_12184_ = _e3226;
                                            } else {
                                                phi_12184_ = _e3249;
                                            }
                                            let _e3252 = phi_12184_;
                                            let _e3255 = local_18.member_2[0u];
                                            let _e3260 = local_18.member_2[1u];
                                            let _e3270 = (_e3255[0] + ((_e3260[0] - _e3255[0]) * _e2938));
                                            let _e3271 = (_e3255[1] + ((_e3260[1] - _e3255[1]) * _e2938));
                                            let _e3272 = (_e3255[2] + ((_e3260[2] - _e3255[2]) * _e2938));
                                            let _e3274 = local_18.member_2[1u];
                                            let _e3279 = local_18.member_2[0u];
                                            let _e3283 = (_e3274[0] - _e3279[0]);
                                            let _e3284 = (_e3274[1] - _e3279[1]);
                                            let _e3285 = (_e3274[2] - _e3279[2]);
                                            if (_e3283 < 0f) {
                                                phi_12243_ = -(_e3283);
                                            } else {
                                                phi_12243_ = _e3283;
                                            }
                                            let _e3289 = phi_12243_;
                                            if (_e3284 < 0f) {
                                                phi_12249_ = -(_e3284);
                                            } else {
                                                phi_12249_ = _e3284;
                                            }
                                            let _e3293 = phi_12249_;
                                            if (_e3289 > _e3293) {
                                                phi_12254_ = _e3289;
                                            } else {
                                                phi_12254_ = _e3293;
                                            }
                                            let _e3296 = phi_12254_;
                                            if (_e3285 < 0f) {
                                                phi_12260_ = -(_e3285);
                                            } else {
                                                phi_12260_ = _e3285;
                                            }
                                            let _e3300 = phi_12260_;
                                            if (_e3296 > _e3300) {
                                                phi_12265_ = _e3296;
                                            } else {
                                                phi_12265_ = _e3300;
                                            }
                                            let _e3303 = phi_12265_;
                                            let _e3309 = ((((_e2940 * _e3303) * 1.01f) + ((_e3252 + _e3203) * (0.000000059604645f * 8f))) + _e3203);
                                            if (_e3270 < 0f) {
                                                phi_12277_ = -(_e3270);
                                            } else {
                                                phi_12277_ = _e3270;
                                            }
                                            let _e3313 = phi_12277_;
                                            if (_e3271 < 0f) {
                                                phi_12283_ = -(_e3271);
                                            } else {
                                                phi_12283_ = _e3271;
                                            }
                                            let _e3317 = phi_12283_;
                                            if (_e3313 > _e3317) {
                                                phi_12288_ = _e3313;
                                            } else {
                                                phi_12288_ = _e3317;
                                            }
                                            let _e3320 = phi_12288_;
                                            if (_e3272 < 0f) {
                                                phi_12294_ = -(_e3272);
                                            } else {
                                                phi_12294_ = _e3272;
                                            }
                                            let _e3324 = phi_12294_;
                                            if (_e3320 > _e3324) {
                                                phi_12299_ = _e3320;
                                            } else {
                                                phi_12299_ = _e3324;
                                            }
                                            let _e3327 = phi_12299_;
                                            local_4 = type_24(array<f32, 3>(_e3270, _e3271, _e3272), _e3309, (_e3327 + _e3309));
                                            let _e3332 = local_3.member;
                                            let _e3337 = local_4.member;
                                            let _e3343 = ((_e3332[1] * _e3337[2]) - (_e3332[2] * _e3337[1]));
                                            let _e3346 = ((_e3332[2] * _e3337[0]) - (_e3332[0] * _e3337[2]));
                                            let _e3349 = ((_e3332[0] * _e3337[1]) - (_e3332[1] * _e3337[0]));
                                            if (_e3343 < 0f) {
                                                phi_12348_ = -(_e3343);
                                            } else {
                                                phi_12348_ = _e3343;
                                            }
                                            let _e3353 = phi_12348_;
                                            if (_e3346 < 0f) {
                                                phi_12354_ = -(_e3346);
                                            } else {
                                                phi_12354_ = _e3346;
                                            }
                                            let _e3357 = phi_12354_;
                                            if (_e3353 > _e3357) {
                                                if (_e3343 < 0f) {
                                                    phi_12364_ = -(_e3343);
                                                } else {
                                                    phi_12364_ = _e3343;
                                                }
                                                let _e3375 = phi_12364_;
                                                if (_e3349 < 0f) {
                                                    phi_12370_ = -(_e3349);
                                                } else {
                                                    phi_12370_ = _e3349;
                                                }
                                                let _e3379 = phi_12370_;
                                                if (_e3375 > _e3379) {
                                                    phi_12375_ = 2u;
                                                    phi_12376_ = 1u;
                                                } else {
                                                    phi_12375_ = 1u;
                                                    phi_12376_ = 0u;
                                                }
                                                let _e3382 = phi_12375_;
                                                let _e3384 = phi_12376_;
                                                phi_12395_ = _e3382;
                                                phi_12396_ = _e3384;
                                            } else {
                                                if (_e3346 < 0f) {
                                                    phi_12382_ = -(_e3346);
                                                } else {
                                                    phi_12382_ = _e3346;
                                                }
                                                let _e3362 = phi_12382_;
                                                if (_e3349 < 0f) {
                                                    phi_12388_ = -(_e3349);
                                                } else {
                                                    phi_12388_ = _e3349;
                                                }
                                                let _e3366 = phi_12388_;
                                                if (_e3362 > _e3366) {
                                                    phi_12393_ = 0u;
                                                    phi_12394_ = 2u;
                                                } else {
                                                    phi_12393_ = 1u;
                                                    phi_12394_ = 0u;
                                                }
                                                let _e3369 = phi_12393_;
                                                let _e3371 = phi_12394_;
                                                phi_12395_ = _e3369;
                                                phi_12396_ = _e3371;
                                            }
                                            let _e3386 = phi_12395_;
                                            let _e3388 = phi_12396_;
                                            let _e3391 = local_3.member[_e3388];
                                            let _e3394 = local_4.member[_e3386];
                                            let _e3398 = local_3.member[_e3386];
                                            let _e3401 = local_4.member[_e3388];
                                            let _e3403 = ((_e3391 * _e3394) - (_e3398 * _e3401));
                                            let _e3405 = local_3.member_1;
                                            let _e3407 = local_4.member_2;
                                            let _e3410 = local_3.member_2;
                                            let _e3412 = local_4.member_1;
                                            let _e3417 = local_3.member_2;
                                            let _e3420 = local_4.member_2;
                                            let _e3428 = local_3.member_2;
                                            let _e3431 = local_4.member_2;
                                            let _e3435 = (((((_e3405 * _e3407) + (_e3410 * _e3412)) * 2.01f) + (((_e3417 * 2f) * (_e3420 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3428) * (1f + _e3431))));
                                            if (_e3403 < 0f) {
                                                phi_12465_ = -(_e3403);
                                            } else {
                                                phi_12465_ = _e3403;
                                            }
                                            let _e3439 = phi_12465_;
                                            if (_e3439 > _e3435) {
                                                if (_e3403 < 0f) {
                                                    phi_12474_ = -1f;
                                                } else {
                                                    phi_12474_ = 1f;
                                                }
                                                let _e3443 = phi_12474_;
                                                let _e3446 = local_2.member[_e3388];
                                                let _e3449 = local_4.member[_e3386];
                                                let _e3453 = local_2.member[_e3386];
                                                let _e3456 = local_4.member[_e3388];
                                                let _e3460 = local_2.member_1;
                                                let _e3462 = local_4.member_2;
                                                let _e3465 = local_2.member_2;
                                                let _e3467 = local_4.member_1;
                                                let _e3472 = local_2.member_2;
                                                let _e3475 = local_4.member_2;
                                                let _e3483 = local_2.member_2;
                                                let _e3486 = local_4.member_2;
                                                let _e3490 = (((((_e3460 * _e3462) + (_e3465 * _e3467)) * 2.01f) + (((_e3472 * 2f) * (_e3475 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3483) * (1f + _e3486))));
                                                let _e3493 = local_3.member[_e3388];
                                                let _e3496 = local_2.member[_e3386];
                                                let _e3500 = local_3.member[_e3386];
                                                let _e3503 = local_2.member[_e3388];
                                                let _e3507 = local_3.member_1;
                                                let _e3509 = local_2.member_2;
                                                let _e3512 = local_3.member_2;
                                                let _e3514 = local_2.member_1;
                                                let _e3519 = local_3.member_2;
                                                let _e3522 = local_2.member_2;
                                                let _e3530 = local_3.member_2;
                                                let _e3533 = local_2.member_2;
                                                let _e3537 = (((((_e3507 * _e3509) + (_e3512 * _e3514)) * 2.01f) + (((_e3519 * 2f) * (_e3522 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3530) * (1f + _e3533))));
                                                let _e3538 = (_e3403 * _e3443);
                                                let _e3539 = (((_e3446 * _e3449) - (_e3453 * _e3456)) * _e3443);
                                                let _e3540 = (((_e3493 * _e3496) - (_e3500 * _e3503)) * _e3443);
                                                if (_e3538 < 0f) {
                                                    phi_12609_ = -(_e3538);
                                                } else {
                                                    phi_12609_ = _e3538;
                                                }
                                                let _e3544 = phi_12609_;
                                                if (_e3539 < 0f) {
                                                    phi_12615_ = -(_e3539);
                                                } else {
                                                    phi_12615_ = _e3539;
                                                }
                                                let _e3548 = phi_12615_;
                                                if (_e3540 < 0f) {
                                                    phi_12622_ = -(_e3540);
                                                } else {
                                                    phi_12622_ = _e3540;
                                                }
                                                let _e3553 = phi_12622_;
                                                let _e3558 = ((_e3538 - _e3539) - _e3540);
                                                let _e3561 = (((_e3435 + _e3490) + _e3537) + (((_e3544 + _e3548) + _e3553) * (0.000000059604645f * 4f)));
                                                local_5 = array<type_33, 4>(type_33(_e3539, _e3490), type_33(_e3540, _e3537), type_33(_e3558, _e3561), type_33(_e3558, _e3561));
                                                phi_12677_ = type_12(0u, 4u);
                                                phi_12680_ = true;
                                                loop {
                                                    let _e3568 = phi_12677_;
                                                    let _e3570 = phi_12680_;
                                                    local_27 = _e3570;
                                                    if (_e3568.member < _e3568.member_1) {
                                                        phi_12678_ = type_12((_e3568.member + 1u), _e3568.member_1);
                                                        phi_12703_ = type_12(1u, _e3568.member);
                                                    } else {
                                                        phi_12678_ = _e3568;
                                                        phi_12703_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3582 = phi_12678_;
                                                    let _e3584 = phi_12703_;
                                                    if (bitcast<i32>(_e3584.member) != 0i) {
                                                        let _e3591 = local_5[_e3584.member_1].member;
                                                        let _e3594 = local_5[_e3584.member_1].member_1;
                                                        let _e3596 = (_e3591 < -(_e3594));
                                                        if _e3596 {
                                                            phi_12730_ = bool();
                                                            phi_12731_ = false;
                                                        } else {
                                                            phi_12730_ = (_e3570 && (_e3591 > _e3594));
                                                            phi_12731_ = true;
                                                        }
                                                        let _e3600 = phi_12730_;
                                                        let _e3602 = phi_12731_;
                                                        phi_12681_ = _e3600;
                                                        phi_12732_ = _e3602;
                                                        phi_12733_ = _e3596;
                                                    } else {
                                                        phi_12681_ = bool();
                                                        phi_12732_ = false;
                                                        phi_12733_ = false;
                                                    }
                                                    let _e3604 = phi_12681_;
                                                    let _e3606 = phi_12732_;
                                                    let _e3608 = phi_12733_;
                                                    local_26 = _e3608;
                                                    continue;
                                                    continuing {
                                                        phi_12677_ = _e3582;
                                                        phi_12680_ = _e3604;
                                                        break if !(_e3606);
                                                    }
                                                }
                                                let _e3611 = local_26;
                                                if _e3611 {
                                                    phi_12737_ = false;
                                                } else {
                                                    phi_12737_ = true;
                                                }
                                                let _e3613 = phi_12737_;
                                                if _e3613 {
                                                    let _e3615 = local_27;
                                                    if _e3615 {
                                                        phi_12744_ = 1u;
                                                    } else {
                                                        phi_12744_ = 2u;
                                                    }
                                                    let _e3617 = phi_12744_;
                                                    phi_12745_ = _e3617;
                                                    phi_12746_ = false;
                                                } else {
                                                    phi_12745_ = u32();
                                                    phi_12746_ = true;
                                                }
                                                let _e3619 = phi_12745_;
                                                let _e3621 = phi_12746_;
                                                phi_12747_ = _e3619;
                                                phi_12748_ = 0u;
                                                phi_12749_ = _e3621;
                                            } else {
                                                phi_12747_ = u32();
                                                phi_12748_ = 2u;
                                                phi_12749_ = true;
                                            }
                                            let _e3623 = phi_12747_;
                                            let _e3625 = phi_12748_;
                                            let _e3627 = phi_12749_;
                                            if _e3627 {
                                                phi_12753_ = _e3625;
                                            } else {
                                                phi_12753_ = _e3623;
                                            }
                                            let _e3629 = phi_12753_;
                                            let _e3630 = (_e3629 == 0u);
                                            if _e3630 {
                                                phi_15462_ = bool();
                                                phi_15463_ = f32();
                                                phi_15464_ = f32();
                                                phi_15465_ = false;
                                                phi_15466_ = false;
                                                phi_15467_ = false;
                                            } else {
                                                if (_e3629 == 1u) {
                                                    phi_12763_ = _e2930.member_2;
                                                } else {
                                                    phi_12763_ = false;
                                                }
                                                let _e3634 = phi_12763_;
                                                let _e3635 = (_e317 * 0.99f);
                                                if _e3634 {
                                                    if ((_e2930.member_1 - _e2930.member) <= _e3635) {
                                                        phi_12775_ = false;
                                                    } else {
                                                        phi_12775_ = true;
                                                    }
                                                    let _e3641 = phi_12775_;
                                                    phi_12776_ = _e3641;
                                                } else {
                                                    phi_12776_ = true;
                                                }
                                                let _e3643 = phi_12776_;
                                                if _e3643 {
                                                    let _e3648 = local_18.member[0u];
                                                    let _e3654 = local_18.member_1[0u];
                                                    let _e3660 = local_18.member_2[0u];
                                                    let _e3672 = local_18.member[1u];
                                                    let _e3678 = local_18.member_1[1u];
                                                    let _e3684 = local_18.member_2[1u];
                                                    let _e3696 = local_18.member[0u];
                                                    if (_e3696[0] < 0f) {
                                                        phi_12924_ = -(_e3696[0]);
                                                    } else {
                                                        phi_12924_ = _e3696[0];
                                                    }
                                                    let _e3703 = phi_12924_;
                                                    if (_e3696[1] < 0f) {
                                                        phi_12931_ = -(_e3696[1]);
                                                    } else {
                                                        phi_12931_ = _e3696[1];
                                                    }
                                                    let _e3707 = phi_12931_;
                                                    if (_e3703 > _e3707) {
                                                        phi_12936_ = _e3703;
                                                    } else {
                                                        phi_12936_ = _e3707;
                                                    }
                                                    let _e3710 = phi_12936_;
                                                    if (_e3696[2] < 0f) {
                                                        phi_12943_ = -(_e3696[2]);
                                                    } else {
                                                        phi_12943_ = _e3696[2];
                                                    }
                                                    let _e3714 = phi_12943_;
                                                    if (_e3710 > _e3714) {
                                                        phi_12948_ = _e3710;
                                                    } else {
                                                        phi_12948_ = _e3714;
                                                    }
                                                    let _e3717 = phi_12948_;
                                                    let _e3720 = local_18.member[1u];
                                                    if (_e3720[0] < 0f) {
                                                        phi_12961_ = -(_e3720[0]);
                                                    } else {
                                                        phi_12961_ = _e3720[0];
                                                    }
                                                    let _e3727 = phi_12961_;
                                                    if (_e3720[1] < 0f) {
                                                        phi_12968_ = -(_e3720[1]);
                                                    } else {
                                                        phi_12968_ = _e3720[1];
                                                    }
                                                    let _e3731 = phi_12968_;
                                                    if (_e3727 > _e3731) {
                                                        phi_12973_ = _e3727;
                                                    } else {
                                                        phi_12973_ = _e3731;
                                                    }
                                                    let _e3734 = phi_12973_;
                                                    if (_e3720[2] < 0f) {
                                                        phi_12980_ = -(_e3720[2]);
                                                    } else {
                                                        phi_12980_ = _e3720[2];
                                                    }
                                                    let _e3738 = phi_12980_;
                                                    if (_e3734 > _e3738) {
                                                        phi_12985_ = _e3734;
                                                    } else {
                                                        phi_12985_ = _e3738;
                                                    }
                                                    let _e3741 = phi_12985_;
                                                    if (_e3717 > _e3741) {
                                                        phi_12990_ = _e3717;
                                                    } else {
                                                        phi_12990_ = _e3741;
                                                    }
                                                    let _e3744 = phi_12990_;
                                                    let _e3746 = local_18.member_3;
                                                    let _e3750 = local_18.member_1[0u];
                                                    if (_e3750[0] < 0f) {
                                                        phi_13007_ = -(_e3750[0]);
                                                    } else {
                                                        phi_13007_ = _e3750[0];
                                                    }
                                                    let _e3757 = phi_13007_;
                                                    if (_e3750[1] < 0f) {
                                                        phi_13014_ = -(_e3750[1]);
                                                    } else {
                                                        phi_13014_ = _e3750[1];
                                                    }
                                                    let _e3761 = phi_13014_;
                                                    if (_e3757 > _e3761) {
                                                        phi_13019_ = _e3757;
                                                    } else {
                                                        phi_13019_ = _e3761;
                                                    }
                                                    let _e3764 = phi_13019_;
                                                    if (_e3750[2] < 0f) {
                                                        phi_13026_ = -(_e3750[2]);
                                                    } else {
                                                        phi_13026_ = _e3750[2];
                                                    }
                                                    let _e3768 = phi_13026_;
                                                    if (_e3764 > _e3768) {
                                                        phi_13031_ = _e3764;
                                                    } else {
                                                        phi_13031_ = _e3768;
                                                    }
                                                    let _e3771 = phi_13031_;
                                                    let _e3774 = local_18.member_1[1u];
                                                    if (_e3774[0] < 0f) {
                                                        phi_13045_ = -(_e3774[0]);
                                                    } else {
                                                        phi_13045_ = _e3774[0];
                                                    }
                                                    let _e3781 = phi_13045_;
                                                    if (_e3774[1] < 0f) {
                                                        phi_13052_ = -(_e3774[1]);
                                                    } else {
                                                        phi_13052_ = _e3774[1];
                                                    }
                                                    let _e3785 = phi_13052_;
                                                    if (_e3781 > _e3785) {
                                                        phi_13057_ = _e3781;
                                                    } else {
                                                        phi_13057_ = _e3785;
                                                    }
                                                    let _e3788 = phi_13057_;
                                                    if (_e3774[2] < 0f) {
                                                        phi_13064_ = -(_e3774[2]);
                                                    } else {
                                                        phi_13064_ = _e3774[2];
                                                    }
                                                    let _e3792 = phi_13064_;
                                                    if (_e3788 > _e3792) {
                                                        phi_13069_ = _e3788;
                                                    } else {
                                                        phi_13069_ = _e3792;
                                                    }
                                                    let _e3795 = phi_13069_;
                                                    if (_e3771 > _e3795) {
                                                        phi_13074_ = _e3771;
                                                    } else {
                                                        phi_13074_ = _e3795;
                                                    }
                                                    let _e3798 = phi_13074_;
                                                    let _e3800 = local_18.member_3;
                                                    let _e3804 = local_18.member_2[0u];
                                                    if (_e3804[0] < 0f) {
                                                        phi_13091_ = -(_e3804[0]);
                                                    } else {
                                                        phi_13091_ = _e3804[0];
                                                    }
                                                    let _e3811 = phi_13091_;
                                                    if (_e3804[1] < 0f) {
                                                        phi_13098_ = -(_e3804[1]);
                                                    } else {
                                                        phi_13098_ = _e3804[1];
                                                    }
                                                    let _e3815 = phi_13098_;
                                                    if (_e3811 > _e3815) {
                                                        phi_13103_ = _e3811;
                                                    } else {
                                                        phi_13103_ = _e3815;
                                                    }
                                                    let _e3818 = phi_13103_;
                                                    if (_e3804[2] < 0f) {
                                                        phi_13110_ = -(_e3804[2]);
                                                    } else {
                                                        phi_13110_ = _e3804[2];
                                                    }
                                                    let _e3822 = phi_13110_;
                                                    if (_e3818 > _e3822) {
                                                        phi_13115_ = _e3818;
                                                    } else {
                                                        phi_13115_ = _e3822;
                                                    }
                                                    let _e3825 = phi_13115_;
                                                    let _e3828 = local_18.member_2[1u];
                                                    if (_e3828[0] < 0f) {
                                                        phi_13129_ = -(_e3828[0]);
                                                    } else {
                                                        phi_13129_ = _e3828[0];
                                                    }
                                                    let _e3835 = phi_13129_;
                                                    if (_e3828[1] < 0f) {
                                                        phi_13136_ = -(_e3828[1]);
                                                    } else {
                                                        phi_13136_ = _e3828[1];
                                                    }
                                                    let _e3839 = phi_13136_;
                                                    if (_e3835 > _e3839) {
                                                        phi_13141_ = _e3835;
                                                    } else {
                                                        phi_13141_ = _e3839;
                                                    }
                                                    let _e3842 = phi_13141_;
                                                    if (_e3828[2] < 0f) {
                                                        phi_13148_ = -(_e3828[2]);
                                                    } else {
                                                        phi_13148_ = _e3828[2];
                                                    }
                                                    let _e3846 = phi_13148_;
                                                    if (_e3842 > _e3846) {
                                                        phi_13153_ = _e3842;
                                                    } else {
                                                        phi_13153_ = _e3846;
                                                    }
                                                    let _e3849 = phi_13153_;
                                                    if (_e3825 > _e3849) {
                                                        phi_13158_ = _e3825;
                                                    } else {
                                                        phi_13158_ = _e3849;
                                                    }
                                                    let _e3852 = phi_13158_;
                                                    let _e3854 = local_18.member_3;
                                                    let _e3861 = local_18.member_3;
                                                    let _e3866 = (_e317 * 0.00390625f);
                                                    local = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    phi_13199_ = type_12(0u, 96u);
                                                    phi_13202_ = _e2930.member;
                                                    phi_13204_ = _e2930.member;
                                                    phi_13206_ = (_e2930.member_1 - _e2930.member);
                                                    phi_13208_ = _e2930.member;
                                                    phi_13210_ = false;
                                                    phi_13212_ = 0u;
                                                    loop {
                                                        let _e3869 = phi_13199_;
                                                        let _e3871 = phi_13202_;
                                                        let _e3873 = phi_13204_;
                                                        let _e3875 = phi_13206_;
                                                        let _e3877 = phi_13208_;
                                                        let _e3879 = phi_13210_;
                                                        let _e3881 = phi_13212_;
                                                        local_30 = _e3871;
                                                        local_75 = _e3873;
                                                        if (_e3869.member < _e3869.member_1) {
                                                            phi_13200_ = type_12((_e3869.member + 1u), _e3869.member_1);
                                                            phi_13235_ = type_12(1u, _e3869.member);
                                                        } else {
                                                            phi_13200_ = _e3869;
                                                            phi_13235_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e3893 = phi_13200_;
                                                        let _e3895 = phi_13235_;
                                                        if (bitcast<i32>(_e3895.member) != 0i) {
                                                            let _e3901 = local_18.member[0u];
                                                            let _e3907 = local_18.member[1u];
                                                            let _e3923 = local_18.member_1[0u];
                                                            let _e3929 = local_18.member_1[1u];
                                                            let _e3945 = local_18.member_2[0u];
                                                            let _e3951 = local_18.member_2[1u];
                                                            let _e3965 = function_2(array<f32, 3>((_e3901[0] + ((_e3907[0] - _e3901[0]) * _e3871)), (_e3901[1] + ((_e3907[1] - _e3901[1]) * _e3871)), (_e3901[2] + ((_e3907[2] - _e3901[2]) * _e3871))), array<f32, 3>((_e3923[0] + ((_e3929[0] - _e3923[0]) * _e3871)), (_e3923[1] + ((_e3929[1] - _e3923[1]) * _e3871)), (_e3923[2] + ((_e3929[2] - _e3923[2]) * _e3871))), array<f32, 3>((_e3945[0] + ((_e3951[0] - _e3945[0]) * _e3871)), (_e3945[1] + ((_e3951[1] - _e3945[1]) * _e3871)), (_e3945[2] + ((_e3951[2] - _e3945[2]) * _e3871))), 0u);
                                                            if (_e3881 == 0u) {
                                                                phi_13363_ = _e3965;
                                                            } else {
                                                                if (_e3881 == 1u) {
                                                                    phi_13349_ = _e3965[0];
                                                                } else {
                                                                    phi_13349_ = 0f;
                                                                }
                                                                let _e3970 = phi_13349_;
                                                                if (_e3881 == 2u) {
                                                                    phi_13355_ = _e3965[1];
                                                                } else {
                                                                    phi_13355_ = 0f;
                                                                }
                                                                let _e3974 = phi_13355_;
                                                                if (_e3881 == 3u) {
                                                                    phi_13361_ = _e3965[2];
                                                                } else {
                                                                    phi_13361_ = 0f;
                                                                }
                                                                let _e3978 = phi_13361_;
                                                                phi_13363_ = array<f32, 3>(_e3970, _e3974, _e3978);
                                                            }
                                                            let _e3981 = phi_13363_;
                                                            if (_e3981[0] < 0f) {
                                                                phi_13370_ = -(_e3981[0]);
                                                            } else {
                                                                phi_13370_ = _e3981[0];
                                                            }
                                                            let _e3986 = phi_13370_;
                                                            if (_e3981[1] < 0f) {
                                                                phi_13377_ = -(_e3981[1]);
                                                            } else {
                                                                phi_13377_ = _e3981[1];
                                                            }
                                                            let _e3991 = phi_13377_;
                                                            if (_e3981[2] < 0f) {
                                                                phi_13385_ = -(_e3981[2]);
                                                            } else {
                                                                phi_13385_ = _e3981[2];
                                                            }
                                                            let _e3997 = phi_13385_;
                                                            let _e3998 = ((_e3986 + _e3991) + _e3997);
                                                            if (_e3998 > 0f) {
                                                                if ((bitcast<u32>(_e3998) & 2139095040u) != 2139095040u) {
                                                                    let _e4003 = (1f / _e3998);
                                                                    let _e4005 = (_e3981[0] * _e4003);
                                                                    let _e4007 = (_e3981[1] * _e4003);
                                                                    let _e4009 = (_e3981[2] * _e4003);
                                                                    let _e4014 = (((_e4005 * _e4005) + (_e4007 * _e4007)) + (_e4009 * _e4009));
                                                                    if (_e4014 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e4014 > 0f) {
                                                                            phi_13422_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_13422_ = 0f;
                                                                        }
                                                                        let _e4067 = phi_13422_;
                                                                        phi_13486_ = _e4067;
                                                                    } else {
                                                                        phi_13429_ = type_14(0i, 5i);
                                                                        phi_13432_ = bitcast<f32>(((bitcast<u32>(_e4014) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e4022 = phi_13429_;
                                                                            let _e4024 = phi_13432_;
                                                                            local_28 = _e4024;
                                                                            if (_e4022.member < _e4022.member_1) {
                                                                                let _e4031 = (_e4022.member + 1i);
                                                                                if ((false == (_e4031 > _e4022.member)) != false) {
                                                                                    phi_13453_ = true;
                                                                                } else {
                                                                                    phi_13453_ = false;
                                                                                }
                                                                                let _e4036 = phi_13453_;
                                                                                if _e4036 {
                                                                                    phi_13459_ = type_15(0u, type_15().member_1);
                                                                                } else {
                                                                                    phi_13459_ = type_15(1u, _e4031);
                                                                                }
                                                                                let _e4041 = phi_13459_;
                                                                                phi_13430_ = type_14(_e4041.member_1, _e4022.member_1);
                                                                                phi_13473_ = type_15(1u, _e4022.member);
                                                                            } else {
                                                                                phi_13430_ = _e4022;
                                                                                phi_13473_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e4047 = phi_13430_;
                                                                            let _e4049 = phi_13473_;
                                                                            let _e4052 = (bitcast<i32>(_e4049.member) != 0i);
                                                                            if _e4052 {
                                                                                phi_13433_ = (0.5f * (_e4024 + (_e4014 / _e4024)));
                                                                            } else {
                                                                                phi_13433_ = f32();
                                                                            }
                                                                            let _e4057 = phi_13433_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_13429_ = _e4047;
                                                                                phi_13432_ = _e4057;
                                                                                break if !(_e4052);
                                                                            }
                                                                        }
                                                                        let _e4062 = local_28;
                                                                        phi_13486_ = (_e4062 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e4069 = phi_13486_;
                                                                    let _e4070 = (0.000000059604645f * 12f);
                                                                    let _e4075 = ((((((((_e3744 + _e3746) + (_e3798 + _e3800)) + (_e3852 + _e3854)) * (0.000000059604645f * 16f)) + (_e3861 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e4069) * (1f + _e4070)));
                                                                    let _e4080 = (((_e4005 * _e3648[0]) + (_e4007 * _e3648[1])) + (_e4009 * _e3648[2]));
                                                                    let _e4085 = (((_e4005 * (_e3648[0] - _e3654[0])) + (_e4007 * (_e3648[1] - _e3654[1]))) + (_e4009 * (_e3648[2] - _e3654[2])));
                                                                    let _e4090 = (((_e4005 * (_e3648[0] - _e3660[0])) + (_e4007 * (_e3648[1] - _e3660[1]))) + (_e4009 * (_e3648[2] - _e3660[2])));
                                                                    let _e4095 = (((_e4005 * _e3648[0]) + (_e4007 * _e3648[1])) + (_e4009 * _e3648[2]));
                                                                    let _e4101 = (((_e4005 * _e3672[0]) + (_e4007 * _e3672[1])) + (_e4009 * _e3672[2]));
                                                                    let _e4106 = (((_e4005 * (_e3672[0] - _e3678[0])) + (_e4007 * (_e3672[1] - _e3678[1]))) + (_e4009 * (_e3672[2] - _e3678[2])));
                                                                    let _e4111 = (((_e4005 * (_e3672[0] - _e3684[0])) + (_e4007 * (_e3672[1] - _e3684[1]))) + (_e4009 * (_e3672[2] - _e3684[2])));
                                                                    let _e4116 = (((_e4005 * _e3672[0]) + (_e4007 * _e3672[1])) + (_e4009 * _e3672[2]));
                                                                    if (_e4080 < 0f) {
                                                                        phi_13552_ = -(_e4080);
                                                                    } else {
                                                                        phi_13552_ = _e4080;
                                                                    }
                                                                    let _e4121 = phi_13552_;
                                                                    if (_e4101 < 0f) {
                                                                        phi_13558_ = -(_e4101);
                                                                    } else {
                                                                        phi_13558_ = _e4101;
                                                                    }
                                                                    let _e4125 = phi_13558_;
                                                                    if (_e4085 < 0f) {
                                                                        phi_13567_ = -(_e4085);
                                                                    } else {
                                                                        phi_13567_ = _e4085;
                                                                    }
                                                                    let _e4132 = phi_13567_;
                                                                    if (_e4106 < 0f) {
                                                                        phi_13573_ = -(_e4106);
                                                                    } else {
                                                                        phi_13573_ = _e4106;
                                                                    }
                                                                    let _e4136 = phi_13573_;
                                                                    if (_e4090 < 0f) {
                                                                        phi_13582_ = -(_e4090);
                                                                    } else {
                                                                        phi_13582_ = _e4090;
                                                                    }
                                                                    let _e4143 = phi_13582_;
                                                                    if (_e4111 < 0f) {
                                                                        phi_13588_ = -(_e4111);
                                                                    } else {
                                                                        phi_13588_ = _e4111;
                                                                    }
                                                                    let _e4147 = phi_13588_;
                                                                    if (_e4095 < 0f) {
                                                                        phi_13597_ = -(_e4095);
                                                                    } else {
                                                                        phi_13597_ = _e4095;
                                                                    }
                                                                    let _e4154 = phi_13597_;
                                                                    if (_e4116 < 0f) {
                                                                        phi_13603_ = -(_e4116);
                                                                    } else {
                                                                        phi_13603_ = _e4116;
                                                                    }
                                                                    let _e4158 = phi_13603_;
                                                                    phi_13609_ = type_32(array<f32, 4>(_e4080, _e4085, _e4090, _e4095), array<f32, 4>(_e4101, _e4106, _e4111, _e4116), array<f32, 4>((_e4075 + ((_e4121 + _e4125) * _e4070)), (_e4075 + ((_e4132 + _e4136) * _e4070)), (_e4075 + ((_e4143 + _e4147) * _e4070)), (_e4075 + ((_e4154 + _e4158) * _e4070))));
                                                                    phi_13610_ = false;
                                                                } else {
                                                                    phi_13609_ = type_32();
                                                                    phi_13610_ = true;
                                                                }
                                                                let _e4165 = phi_13609_;
                                                                let _e4167 = phi_13610_;
                                                                phi_13611_ = _e4165;
                                                                phi_13612_ = _e4167;
                                                            } else {
                                                                phi_13611_ = type_32();
                                                                phi_13612_ = true;
                                                            }
                                                            let _e4169 = phi_13611_;
                                                            let _e4171 = phi_13612_;
                                                            if _e4171 {
                                                                phi_13620_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                            } else {
                                                                phi_13620_ = _e4169;
                                                            }
                                                            let _e4173 = phi_13620_;
                                                            local_1 = type_32(array<f32, 4>(_e4173.member[0], _e4173.member[1], _e4173.member[2], _e4173.member[3]), array<f32, 4>(_e4173.member_1[0], _e4173.member_1[1], _e4173.member_1[2], _e4173.member_1[3]), array<f32, 4>(_e4173.member_2[0], _e4173.member_2[1], _e4173.member_2[2], _e4173.member_2[3]));
                                                            let _e4193 = (_e3871 - _e3877);
                                                            let _e4197 = local_1.member[0u];
                                                            let _e4200 = local_1.member_1[0u];
                                                            let _e4203 = local_1.member[0u];
                                                            let _e4209 = local_1.member_2[0u];
                                                            if (((_e4197 + ((_e4200 - _e4203) * _e3871)) - _e4209) > 0f) {
                                                                let _e4214 = local_1.member[1u];
                                                                let _e4217 = local_1.member_1[1u];
                                                                let _e4220 = local_1.member[1u];
                                                                let _e4226 = local_1.member_2[1u];
                                                                if (((_e4214 + ((_e4217 - _e4220) * _e3871)) - _e4226) > 0f) {
                                                                    let _e4231 = local_1.member[2u];
                                                                    let _e4234 = local_1.member_1[2u];
                                                                    let _e4237 = local_1.member[2u];
                                                                    let _e4243 = local_1.member_2[2u];
                                                                    if (((_e4231 + ((_e4234 - _e4237) * _e3871)) - _e4243) > 0f) {
                                                                        let _e4248 = local_1.member[3u];
                                                                        let _e4251 = local_1.member_1[3u];
                                                                        let _e4254 = local_1.member[3u];
                                                                        let _e4260 = local_1.member_2[3u];
                                                                        phi_13791_ = (((_e4248 + ((_e4251 - _e4254) * _e3871)) - _e4260) > 0f);
                                                                        phi_13792_ = false;
                                                                    } else {
                                                                        phi_13791_ = bool();
                                                                        phi_13792_ = true;
                                                                    }
                                                                    let _e4264 = phi_13791_;
                                                                    let _e4266 = phi_13792_;
                                                                    phi_13793_ = _e4264;
                                                                    phi_13794_ = _e4266;
                                                                } else {
                                                                    phi_13793_ = bool();
                                                                    phi_13794_ = true;
                                                                }
                                                                let _e4268 = phi_13793_;
                                                                let _e4270 = phi_13794_;
                                                                phi_13795_ = _e4268;
                                                                phi_13796_ = _e4270;
                                                            } else {
                                                                phi_13795_ = bool();
                                                                phi_13796_ = true;
                                                            }
                                                            let _e4272 = phi_13795_;
                                                            let _e4274 = phi_13796_;
                                                            if _e4274 {
                                                                phi_13800_ = false;
                                                            } else {
                                                                phi_13800_ = _e4272;
                                                            }
                                                            let _e4276 = phi_13800_;
                                                            if _e4276 {
                                                                if (_e3871 <= _e3873) {
                                                                    phi_14110_ = true;
                                                                } else {
                                                                    let _e4280 = local.member[0u];
                                                                    let _e4283 = local.member_1[0u];
                                                                    let _e4286 = local.member[0u];
                                                                    let _e4292 = local.member_2[0u];
                                                                    let _e4296 = local_1.member[0u];
                                                                    let _e4299 = local_1.member_1[0u];
                                                                    let _e4302 = local_1.member[0u];
                                                                    let _e4308 = local_1.member_2[0u];
                                                                    if ((((_e4280 + ((_e4283 - _e4286) * _e3871)) - _e4292) + ((_e4296 + ((_e4299 - _e4302) * _e3877)) - _e4308)) > 0f) {
                                                                        let _e4314 = local.member[1u];
                                                                        let _e4317 = local.member_1[1u];
                                                                        let _e4320 = local.member[1u];
                                                                        let _e4326 = local.member_2[1u];
                                                                        let _e4330 = local_1.member[1u];
                                                                        let _e4333 = local_1.member_1[1u];
                                                                        let _e4336 = local_1.member[1u];
                                                                        let _e4342 = local_1.member_2[1u];
                                                                        if ((((_e4314 + ((_e4317 - _e4320) * _e3871)) - _e4326) + ((_e4330 + ((_e4333 - _e4336) * _e3877)) - _e4342)) > 0f) {
                                                                            let _e4348 = local.member[2u];
                                                                            let _e4351 = local.member_1[2u];
                                                                            let _e4354 = local.member[2u];
                                                                            let _e4360 = local.member_2[2u];
                                                                            let _e4364 = local_1.member[2u];
                                                                            let _e4367 = local_1.member_1[2u];
                                                                            let _e4370 = local_1.member[2u];
                                                                            let _e4376 = local_1.member_2[2u];
                                                                            if ((((_e4348 + ((_e4351 - _e4354) * _e3871)) - _e4360) + ((_e4364 + ((_e4367 - _e4370) * _e3877)) - _e4376)) > 0f) {
                                                                                let _e4382 = local.member[3u];
                                                                                let _e4385 = local.member_1[3u];
                                                                                let _e4388 = local.member[3u];
                                                                                let _e4394 = local.member_2[3u];
                                                                                let _e4398 = local_1.member[3u];
                                                                                let _e4401 = local_1.member_1[3u];
                                                                                let _e4404 = local_1.member[3u];
                                                                                let _e4410 = local_1.member_2[3u];
                                                                                phi_14097_ = ((((_e4382 + ((_e4385 - _e4388) * _e3871)) - _e4394) + ((_e4398 + ((_e4401 - _e4404) * _e3877)) - _e4410)) > 0f);
                                                                                phi_14098_ = false;
                                                                            } else {
                                                                                phi_14097_ = bool();
                                                                                phi_14098_ = true;
                                                                            }
                                                                            let _e4415 = phi_14097_;
                                                                            let _e4417 = phi_14098_;
                                                                            phi_14099_ = _e4415;
                                                                            phi_14100_ = _e4417;
                                                                        } else {
                                                                            phi_14099_ = bool();
                                                                            phi_14100_ = true;
                                                                        }
                                                                        let _e4419 = phi_14099_;
                                                                        let _e4421 = phi_14100_;
                                                                        phi_14101_ = _e4419;
                                                                        phi_14102_ = _e4421;
                                                                    } else {
                                                                        phi_14101_ = bool();
                                                                        phi_14102_ = true;
                                                                    }
                                                                    let _e4423 = phi_14101_;
                                                                    let _e4425 = phi_14102_;
                                                                    if _e4425 {
                                                                        phi_14106_ = false;
                                                                    } else {
                                                                        phi_14106_ = _e4423;
                                                                    }
                                                                    let _e4427 = phi_14106_;
                                                                    phi_14110_ = _e4427;
                                                                }
                                                                let _e4429 = phi_14110_;
                                                                if _e4429 {
                                                                    if _e3879 {
                                                                        if (_e3871 >= _e2930.member_1) {
                                                                            phi_14121_ = false;
                                                                        } else {
                                                                            phi_14121_ = true;
                                                                        }
                                                                        let _e4432 = phi_14121_;
                                                                        phi_14122_ = _e4432;
                                                                    } else {
                                                                        phi_14122_ = true;
                                                                    }
                                                                    let _e4434 = phi_14122_;
                                                                    if _e4434 {
                                                                        local = type_32(array<f32, 4>(_e4173.member[0], _e4173.member[1], _e4173.member[2], _e4173.member[3]), array<f32, 4>(_e4173.member_1[0], _e4173.member_1[1], _e4173.member_1[2], _e4173.member_1[3]), array<f32, 4>(_e4173.member_2[0], _e4173.member_2[1], _e4173.member_2[2], _e4173.member_2[3]));
                                                                        let _e4456 = local.member[0u];
                                                                        let _e4459 = local.member_1[0u];
                                                                        let _e4462 = local.member_2[0u];
                                                                        if (_e4456 > _e4462) {
                                                                            if (_e4459 > _e4462) {
                                                                                phi_14196_ = false;
                                                                            } else {
                                                                                phi_14196_ = true;
                                                                            }
                                                                            let _e4466 = phi_14196_;
                                                                            phi_14197_ = _e4466;
                                                                        } else {
                                                                            phi_14197_ = true;
                                                                        }
                                                                        let _e4468 = phi_14197_;
                                                                        if _e4468 {
                                                                            let _e4469 = (_e4459 >= _e4456);
                                                                            if _e4469 {
                                                                                phi_14219_ = f32();
                                                                                phi_14220_ = false;
                                                                            } else {
                                                                                if ((_e4456 - _e4459) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14217_ = (((_e4456 - _e4462) / (_e4456 - _e4459)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14218_ = false;
                                                                                } else {
                                                                                    phi_14217_ = f32();
                                                                                    phi_14218_ = true;
                                                                                }
                                                                                let _e4480 = phi_14217_;
                                                                                let _e4482 = phi_14218_;
                                                                                phi_14219_ = _e4480;
                                                                                phi_14220_ = _e4482;
                                                                            }
                                                                            let _e4484 = phi_14219_;
                                                                            let _e4486 = phi_14220_;
                                                                            phi_14221_ = _e4484;
                                                                            phi_14222_ = _e4469;
                                                                            phi_14223_ = _e4486;
                                                                        } else {
                                                                            phi_14221_ = f32();
                                                                            phi_14222_ = true;
                                                                            phi_14223_ = false;
                                                                        }
                                                                        let _e4488 = phi_14221_;
                                                                        let _e4490 = phi_14222_;
                                                                        let _e4492 = phi_14223_;
                                                                        if _e4490 {
                                                                            phi_14227_ = 2f;
                                                                            phi_14228_ = true;
                                                                        } else {
                                                                            phi_14227_ = _e3871;
                                                                            phi_14228_ = _e4492;
                                                                        }
                                                                        let _e4494 = phi_14227_;
                                                                        let _e4496 = phi_14228_;
                                                                        if _e4496 {
                                                                            phi_14232_ = _e4494;
                                                                        } else {
                                                                            phi_14232_ = _e4488;
                                                                        }
                                                                        let _e4498 = phi_14232_;
                                                                        let _e4501 = local.member[1u];
                                                                        let _e4504 = local.member_1[1u];
                                                                        let _e4507 = local.member_2[1u];
                                                                        if (_e4501 > _e4507) {
                                                                            if (_e4504 > _e4507) {
                                                                                phi_14264_ = false;
                                                                            } else {
                                                                                phi_14264_ = true;
                                                                            }
                                                                            let _e4511 = phi_14264_;
                                                                            phi_14265_ = _e4511;
                                                                        } else {
                                                                            phi_14265_ = true;
                                                                        }
                                                                        let _e4513 = phi_14265_;
                                                                        if _e4513 {
                                                                            let _e4514 = (_e4504 >= _e4501);
                                                                            if _e4514 {
                                                                                phi_14287_ = f32();
                                                                                phi_14288_ = false;
                                                                            } else {
                                                                                if ((_e4501 - _e4504) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14285_ = (((_e4501 - _e4507) / (_e4501 - _e4504)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14286_ = false;
                                                                                } else {
                                                                                    phi_14285_ = f32();
                                                                                    phi_14286_ = true;
                                                                                }
                                                                                let _e4525 = phi_14285_;
                                                                                let _e4527 = phi_14286_;
                                                                                phi_14287_ = _e4525;
                                                                                phi_14288_ = _e4527;
                                                                            }
                                                                            let _e4529 = phi_14287_;
                                                                            let _e4531 = phi_14288_;
                                                                            phi_14289_ = _e4529;
                                                                            phi_14290_ = _e4514;
                                                                            phi_14291_ = _e4531;
                                                                        } else {
                                                                            phi_14289_ = f32();
                                                                            phi_14290_ = true;
                                                                            phi_14291_ = false;
                                                                        }
                                                                        let _e4533 = phi_14289_;
                                                                        let _e4535 = phi_14290_;
                                                                        let _e4537 = phi_14291_;
                                                                        if _e4535 {
                                                                            phi_14295_ = 2f;
                                                                            phi_14296_ = true;
                                                                        } else {
                                                                            phi_14295_ = _e3871;
                                                                            phi_14296_ = _e4537;
                                                                        }
                                                                        let _e4539 = phi_14295_;
                                                                        let _e4541 = phi_14296_;
                                                                        if _e4541 {
                                                                            phi_14300_ = _e4539;
                                                                        } else {
                                                                            phi_14300_ = _e4533;
                                                                        }
                                                                        let _e4543 = phi_14300_;
                                                                        if (_e4498 < _e4543) {
                                                                            phi_14305_ = _e4498;
                                                                        } else {
                                                                            phi_14305_ = _e4543;
                                                                        }
                                                                        let _e4546 = phi_14305_;
                                                                        let _e4549 = local.member[2u];
                                                                        let _e4552 = local.member_1[2u];
                                                                        let _e4555 = local.member_2[2u];
                                                                        if (_e4549 > _e4555) {
                                                                            if (_e4552 > _e4555) {
                                                                                phi_14337_ = false;
                                                                            } else {
                                                                                phi_14337_ = true;
                                                                            }
                                                                            let _e4559 = phi_14337_;
                                                                            phi_14338_ = _e4559;
                                                                        } else {
                                                                            phi_14338_ = true;
                                                                        }
                                                                        let _e4561 = phi_14338_;
                                                                        if _e4561 {
                                                                            let _e4562 = (_e4552 >= _e4549);
                                                                            if _e4562 {
                                                                                phi_14360_ = f32();
                                                                                phi_14361_ = false;
                                                                            } else {
                                                                                if ((_e4549 - _e4552) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14358_ = (((_e4549 - _e4555) / (_e4549 - _e4552)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14359_ = false;
                                                                                } else {
                                                                                    phi_14358_ = f32();
                                                                                    phi_14359_ = true;
                                                                                }
                                                                                let _e4573 = phi_14358_;
                                                                                let _e4575 = phi_14359_;
                                                                                phi_14360_ = _e4573;
                                                                                phi_14361_ = _e4575;
                                                                            }
                                                                            let _e4577 = phi_14360_;
                                                                            let _e4579 = phi_14361_;
                                                                            phi_14362_ = _e4577;
                                                                            phi_14363_ = _e4562;
                                                                            phi_14364_ = _e4579;
                                                                        } else {
                                                                            phi_14362_ = f32();
                                                                            phi_14363_ = true;
                                                                            phi_14364_ = false;
                                                                        }
                                                                        let _e4581 = phi_14362_;
                                                                        let _e4583 = phi_14363_;
                                                                        let _e4585 = phi_14364_;
                                                                        if _e4583 {
                                                                            phi_14368_ = 2f;
                                                                            phi_14369_ = true;
                                                                        } else {
                                                                            phi_14368_ = _e3871;
                                                                            phi_14369_ = _e4585;
                                                                        }
                                                                        let _e4587 = phi_14368_;
                                                                        let _e4589 = phi_14369_;
                                                                        if _e4589 {
                                                                            phi_14373_ = _e4587;
                                                                        } else {
                                                                            phi_14373_ = _e4581;
                                                                        }
                                                                        let _e4591 = phi_14373_;
                                                                        let _e4594 = local.member[3u];
                                                                        let _e4597 = local.member_1[3u];
                                                                        let _e4600 = local.member_2[3u];
                                                                        if (_e4594 > _e4600) {
                                                                            if (_e4597 > _e4600) {
                                                                                phi_14405_ = false;
                                                                            } else {
                                                                                phi_14405_ = true;
                                                                            }
                                                                            let _e4604 = phi_14405_;
                                                                            phi_14406_ = _e4604;
                                                                        } else {
                                                                            phi_14406_ = true;
                                                                        }
                                                                        let _e4606 = phi_14406_;
                                                                        if _e4606 {
                                                                            let _e4607 = (_e4597 >= _e4594);
                                                                            if _e4607 {
                                                                                phi_14428_ = f32();
                                                                                phi_14429_ = false;
                                                                            } else {
                                                                                if ((_e4594 - _e4597) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14426_ = (((_e4594 - _e4600) / (_e4594 - _e4597)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14427_ = false;
                                                                                } else {
                                                                                    phi_14426_ = f32();
                                                                                    phi_14427_ = true;
                                                                                }
                                                                                let _e4618 = phi_14426_;
                                                                                let _e4620 = phi_14427_;
                                                                                phi_14428_ = _e4618;
                                                                                phi_14429_ = _e4620;
                                                                            }
                                                                            let _e4622 = phi_14428_;
                                                                            let _e4624 = phi_14429_;
                                                                            phi_14430_ = _e4622;
                                                                            phi_14431_ = _e4607;
                                                                            phi_14432_ = _e4624;
                                                                        } else {
                                                                            phi_14430_ = f32();
                                                                            phi_14431_ = true;
                                                                            phi_14432_ = false;
                                                                        }
                                                                        let _e4626 = phi_14430_;
                                                                        let _e4628 = phi_14431_;
                                                                        let _e4630 = phi_14432_;
                                                                        if _e4628 {
                                                                            phi_14436_ = 2f;
                                                                            phi_14437_ = true;
                                                                        } else {
                                                                            phi_14436_ = _e3871;
                                                                            phi_14437_ = _e4630;
                                                                        }
                                                                        let _e4632 = phi_14436_;
                                                                        let _e4634 = phi_14437_;
                                                                        if _e4634 {
                                                                            phi_14441_ = _e4632;
                                                                        } else {
                                                                            phi_14441_ = _e4626;
                                                                        }
                                                                        let _e4636 = phi_14441_;
                                                                        if (_e4591 < _e4636) {
                                                                            phi_14446_ = _e4591;
                                                                        } else {
                                                                            phi_14446_ = _e4636;
                                                                        }
                                                                        let _e4639 = phi_14446_;
                                                                        if (_e4546 < _e4639) {
                                                                            phi_14451_ = _e4546;
                                                                        } else {
                                                                            phi_14451_ = _e4639;
                                                                        }
                                                                        let _e4642 = phi_14451_;
                                                                        if (_e4642 > _e3871) {
                                                                            phi_14456_ = _e4642;
                                                                        } else {
                                                                            phi_14456_ = _e3871;
                                                                        }
                                                                        let _e4645 = phi_14456_;
                                                                        let _e4646 = (_e4645 > _e2930.member_1);
                                                                        if _e4646 {
                                                                            phi_14961_ = f32();
                                                                            phi_14962_ = f32();
                                                                            phi_14963_ = false;
                                                                        } else {
                                                                            let _e4647 = (_e4645 - _e3871);
                                                                            if _e3879 {
                                                                                if (_e4647 <= _e3866) {
                                                                                    phi_14951_ = true;
                                                                                } else {
                                                                                    if (_e4647 <= (_e3875 * 0.25f)) {
                                                                                        phi_14950_ = false;
                                                                                    } else {
                                                                                        phi_14950_ = true;
                                                                                    }
                                                                                    let _e4653 = phi_14950_;
                                                                                    phi_14951_ = _e4653;
                                                                                }
                                                                                let _e4655 = phi_14951_;
                                                                                if _e4655 {
                                                                                    phi_14956_ = (_e4193 + _e4193);
                                                                                } else {
                                                                                    phi_14956_ = 0f;
                                                                                }
                                                                                let _e4658 = phi_14956_;
                                                                                phi_14958_ = _e4658;
                                                                            } else {
                                                                                phi_14958_ = (_e2930.member_1 - _e3871);
                                                                            }
                                                                            let _e4660 = phi_14958_;
                                                                            phi_14961_ = _e4660;
                                                                            phi_14962_ = _e4647;
                                                                            phi_14963_ = true;
                                                                        }
                                                                        let _e4662 = phi_14961_;
                                                                        let _e4664 = phi_14962_;
                                                                        let _e4666 = phi_14963_;
                                                                        phi_14965_ = _e4645;
                                                                        phi_14966_ = _e4662;
                                                                        phi_14967_ = _e4664;
                                                                        phi_14969_ = _e4666;
                                                                        phi_14970_ = _e4646;
                                                                        phi_14972_ = false;
                                                                    } else {
                                                                        phi_14965_ = f32();
                                                                        phi_14966_ = f32();
                                                                        phi_14967_ = f32();
                                                                        phi_14969_ = false;
                                                                        phi_14970_ = false;
                                                                        phi_14972_ = true;
                                                                    }
                                                                    let _e4668 = phi_14965_;
                                                                    let _e4670 = phi_14966_;
                                                                    let _e4672 = phi_14967_;
                                                                    let _e4674 = phi_14969_;
                                                                    let _e4676 = phi_14970_;
                                                                    let _e4678 = phi_14972_;
                                                                    phi_14973_ = _e4668;
                                                                    phi_14974_ = _e4670;
                                                                    phi_14975_ = _e4672;
                                                                    phi_14977_ = false;
                                                                    phi_14978_ = _e4674;
                                                                    phi_14979_ = _e4676;
                                                                    phi_14981_ = _e4678;
                                                                } else {
                                                                    phi_14973_ = f32();
                                                                    phi_14974_ = f32();
                                                                    phi_14975_ = f32();
                                                                    phi_14977_ = true;
                                                                    phi_14978_ = false;
                                                                    phi_14979_ = false;
                                                                    phi_14981_ = false;
                                                                }
                                                                let _e4680 = phi_14973_;
                                                                let _e4682 = phi_14974_;
                                                                let _e4684 = phi_14975_;
                                                                let _e4686 = phi_14977_;
                                                                let _e4688 = phi_14978_;
                                                                let _e4690 = phi_14979_;
                                                                let _e4692 = phi_14981_;
                                                                phi_14982_ = _e4680;
                                                                phi_14983_ = _e4682;
                                                                phi_14984_ = _e4684;
                                                                phi_14986_ = _e4686;
                                                                phi_14987_ = _e4688;
                                                                phi_14988_ = _e4690;
                                                                phi_14990_ = _e4692;
                                                            } else {
                                                                phi_14982_ = f32();
                                                                phi_14983_ = f32();
                                                                phi_14984_ = f32();
                                                                phi_14986_ = true;
                                                                phi_14987_ = false;
                                                                phi_14988_ = false;
                                                                phi_14990_ = false;
                                                            }
                                                            let _e4694 = phi_14982_;
                                                            let _e4696 = phi_14983_;
                                                            let _e4698 = phi_14984_;
                                                            let _e4700 = phi_14986_;
                                                            let _e4702 = phi_14987_;
                                                            let _e4704 = phi_14988_;
                                                            let _e4706 = phi_14990_;
                                                            if _e4700 {
                                                                if (_e3871 <= _e3873) {
                                                                    let _e4867 = (_e3881 + 1u);
                                                                    let _e4868 = (_e4867 > 3u);
                                                                    if _e4868 {
                                                                        phi_15003_ = false;
                                                                    } else {
                                                                        phi_15003_ = true;
                                                                    }
                                                                    let _e4870 = phi_15003_;
                                                                    phi_15325_ = _e4867;
                                                                    phi_15326_ = f32();
                                                                    phi_15327_ = false;
                                                                    phi_15328_ = _e4870;
                                                                    phi_15329_ = _e4868;
                                                                } else {
                                                                    let _e4710 = local.member[0u];
                                                                    let _e4713 = local.member_1[0u];
                                                                    let _e4716 = local.member[0u];
                                                                    let _e4722 = local.member_2[0u];
                                                                    let _e4723 = ((_e4710 + ((_e4713 - _e4716) * _e3877)) - _e4722);
                                                                    let _e4726 = local.member[1u];
                                                                    let _e4729 = local.member_1[1u];
                                                                    let _e4732 = local.member[1u];
                                                                    let _e4738 = local.member_2[1u];
                                                                    let _e4739 = ((_e4726 + ((_e4729 - _e4732) * _e3877)) - _e4738);
                                                                    if (_e4723 < _e4739) {
                                                                        phi_15076_ = _e4723;
                                                                    } else {
                                                                        phi_15076_ = _e4739;
                                                                    }
                                                                    let _e4742 = phi_15076_;
                                                                    let _e4745 = local.member[2u];
                                                                    let _e4748 = local.member_1[2u];
                                                                    let _e4751 = local.member[2u];
                                                                    let _e4757 = local.member_2[2u];
                                                                    let _e4758 = ((_e4745 + ((_e4748 - _e4751) * _e3877)) - _e4757);
                                                                    let _e4761 = local.member[3u];
                                                                    let _e4764 = local.member_1[3u];
                                                                    let _e4767 = local.member[3u];
                                                                    let _e4773 = local.member_2[3u];
                                                                    let _e4774 = ((_e4761 + ((_e4764 - _e4767) * _e3877)) - _e4773);
                                                                    if (_e4758 < _e4774) {
                                                                        phi_15149_ = _e4758;
                                                                    } else {
                                                                        phi_15149_ = _e4774;
                                                                    }
                                                                    let _e4777 = phi_15149_;
                                                                    if (_e4742 < _e4777) {
                                                                        phi_15154_ = _e4742;
                                                                    } else {
                                                                        phi_15154_ = _e4777;
                                                                    }
                                                                    let _e4780 = phi_15154_;
                                                                    let _e4783 = local_1.member[0u];
                                                                    let _e4786 = local_1.member_1[0u];
                                                                    let _e4789 = local_1.member[0u];
                                                                    let _e4795 = local_1.member_2[0u];
                                                                    let _e4796 = ((_e4783 + ((_e4786 - _e4789) * _e3871)) - _e4795);
                                                                    let _e4799 = local_1.member[1u];
                                                                    let _e4802 = local_1.member_1[1u];
                                                                    let _e4805 = local_1.member[1u];
                                                                    let _e4811 = local_1.member_2[1u];
                                                                    let _e4812 = ((_e4799 + ((_e4802 - _e4805) * _e3871)) - _e4811);
                                                                    if (_e4796 < _e4812) {
                                                                        phi_15227_ = _e4796;
                                                                    } else {
                                                                        phi_15227_ = _e4812;
                                                                    }
                                                                    let _e4815 = phi_15227_;
                                                                    let _e4818 = local_1.member[2u];
                                                                    let _e4821 = local_1.member_1[2u];
                                                                    let _e4824 = local_1.member[2u];
                                                                    let _e4830 = local_1.member_2[2u];
                                                                    let _e4831 = ((_e4818 + ((_e4821 - _e4824) * _e3871)) - _e4830);
                                                                    let _e4834 = local_1.member[3u];
                                                                    let _e4837 = local_1.member_1[3u];
                                                                    let _e4840 = local_1.member[3u];
                                                                    let _e4846 = local_1.member_2[3u];
                                                                    let _e4847 = ((_e4834 + ((_e4837 - _e4840) * _e3871)) - _e4846);
                                                                    if (_e4831 < _e4847) {
                                                                        phi_15300_ = _e4831;
                                                                    } else {
                                                                        phi_15300_ = _e4847;
                                                                    }
                                                                    let _e4850 = phi_15300_;
                                                                    if (_e4815 < _e4850) {
                                                                        phi_15305_ = _e4815;
                                                                    } else {
                                                                        phi_15305_ = _e4850;
                                                                    }
                                                                    let _e4853 = phi_15305_;
                                                                    if (_e4853 > 0f) {
                                                                        phi_15323_ = 0.5f;
                                                                    } else {
                                                                        let _e4857 = (0.95f * (_e4780 / (_e4780 - _e4853)));
                                                                        if (_e4857 > 0.0625f) {
                                                                            if (_e4857 < 0.9f) {
                                                                                phi_15321_ = _e4857;
                                                                            } else {
                                                                                phi_15321_ = 0.9f;
                                                                            }
                                                                            let _e4861 = phi_15321_;
                                                                            phi_15322_ = _e4861;
                                                                        } else {
                                                                            phi_15322_ = 0.0625f;
                                                                        }
                                                                        let _e4863 = phi_15322_;
                                                                        phi_15323_ = _e4863;
                                                                    }
                                                                    let _e4865 = phi_15323_;
                                                                    phi_15325_ = u32();
                                                                    phi_15326_ = (_e4193 * _e4865);
                                                                    phi_15327_ = true;
                                                                    phi_15328_ = false;
                                                                    phi_15329_ = false;
                                                                }
                                                                let _e4872 = phi_15325_;
                                                                let _e4874 = phi_15326_;
                                                                let _e4876 = phi_15327_;
                                                                let _e4878 = phi_15328_;
                                                                let _e4880 = phi_15329_;
                                                                phi_15330_ = _e4872;
                                                                phi_15331_ = _e3873;
                                                                phi_15332_ = _e4874;
                                                                phi_15333_ = _e3875;
                                                                phi_15334_ = _e3877;
                                                                phi_15335_ = _e3879;
                                                                phi_15336_ = _e3881;
                                                                phi_15337_ = _e4876;
                                                                phi_15338_ = _e4878;
                                                                phi_15339_ = _e4880;
                                                                phi_15340_ = false;
                                                                phi_15342_ = false;
                                                            } else {
                                                                phi_15330_ = u32();
                                                                phi_15331_ = _e4694;
                                                                phi_15332_ = _e4696;
                                                                phi_15333_ = _e4698;
                                                                phi_15334_ = _e3871;
                                                                phi_15335_ = true;
                                                                phi_15336_ = 0u;
                                                                phi_15337_ = _e4702;
                                                                phi_15338_ = false;
                                                                phi_15339_ = false;
                                                                phi_15340_ = _e4704;
                                                                phi_15342_ = _e4706;
                                                            }
                                                            let _e4882 = phi_15330_;
                                                            let _e4884 = phi_15331_;
                                                            let _e4886 = phi_15332_;
                                                            let _e4888 = phi_15333_;
                                                            let _e4890 = phi_15334_;
                                                            let _e4892 = phi_15335_;
                                                            let _e4894 = phi_15336_;
                                                            let _e4896 = phi_15337_;
                                                            let _e4898 = phi_15338_;
                                                            let _e4900 = phi_15339_;
                                                            let _e4902 = phi_15340_;
                                                            let _e4904 = phi_15342_;
                                                            if _e4896 {
                                                                let _e4905 = (_e4890 + _e4886);
                                                                if (_e4905 > _e4884) {
                                                                    phi_15351_ = _e4905;
                                                                } else {
                                                                    phi_15351_ = _e4884;
                                                                }
                                                                let _e4908 = phi_15351_;
                                                                if (_e4908 < _e2930.member_1) {
                                                                    phi_15356_ = _e4908;
                                                                } else {
                                                                    phi_15356_ = _e2930.member_1;
                                                                }
                                                                let _e4911 = phi_15356_;
                                                                if !(_e3879) {
                                                                    phi_15365_ = true;
                                                                } else {
                                                                    phi_15365_ = ((_e4911 - _e4890) > _e3866);
                                                                }
                                                                let _e4915 = phi_15365_;
                                                                if _e4915 {
                                                                    phi_15369_ = false;
                                                                } else {
                                                                    phi_15369_ = true;
                                                                }
                                                                let _e4917 = phi_15369_;
                                                                phi_15370_ = _e4911;
                                                                phi_15371_ = _e4884;
                                                                phi_15372_ = _e4888;
                                                                phi_15373_ = _e4890;
                                                                phi_15374_ = _e4892;
                                                                phi_15375_ = _e4894;
                                                                phi_15376_ = _e4915;
                                                                phi_15377_ = _e4917;
                                                                phi_15378_ = false;
                                                                phi_15379_ = false;
                                                                phi_15381_ = false;
                                                            } else {
                                                                phi_15370_ = _e3871;
                                                                phi_15371_ = _e3873;
                                                                phi_15372_ = _e3875;
                                                                phi_15373_ = _e3877;
                                                                phi_15374_ = _e3879;
                                                                phi_15375_ = _e4882;
                                                                phi_15376_ = _e4898;
                                                                phi_15377_ = false;
                                                                phi_15378_ = _e4900;
                                                                phi_15379_ = _e4902;
                                                                phi_15381_ = _e4904;
                                                            }
                                                            let _e4919 = phi_15370_;
                                                            let _e4921 = phi_15371_;
                                                            let _e4923 = phi_15372_;
                                                            let _e4925 = phi_15373_;
                                                            let _e4927 = phi_15374_;
                                                            let _e4929 = phi_15375_;
                                                            let _e4931 = phi_15376_;
                                                            let _e4933 = phi_15377_;
                                                            let _e4935 = phi_15378_;
                                                            let _e4937 = phi_15379_;
                                                            let _e4939 = phi_15381_;
                                                            phi_13203_ = _e4919;
                                                            phi_13205_ = _e4921;
                                                            phi_13207_ = _e4923;
                                                            phi_13209_ = _e4925;
                                                            phi_13211_ = _e4927;
                                                            phi_13213_ = _e4929;
                                                            phi_15382_ = _e4884;
                                                            phi_15384_ = _e4931;
                                                            phi_15385_ = _e4933;
                                                            phi_15386_ = _e4935;
                                                            phi_15387_ = _e4937;
                                                            phi_15389_ = false;
                                                            phi_15390_ = _e4939;
                                                        } else {
                                                            phi_13203_ = f32();
                                                            phi_13205_ = f32();
                                                            phi_13207_ = f32();
                                                            phi_13209_ = f32();
                                                            phi_13211_ = bool();
                                                            phi_13213_ = u32();
                                                            phi_15382_ = f32();
                                                            phi_15384_ = false;
                                                            phi_15385_ = false;
                                                            phi_15386_ = false;
                                                            phi_15387_ = false;
                                                            phi_15389_ = true;
                                                            phi_15390_ = false;
                                                        }
                                                        let _e4941 = phi_13203_;
                                                        let _e4943 = phi_13205_;
                                                        let _e4945 = phi_13207_;
                                                        let _e4947 = phi_13209_;
                                                        let _e4949 = phi_13211_;
                                                        let _e4951 = phi_13213_;
                                                        let _e4953 = phi_15382_;
                                                        let _e4955 = phi_15384_;
                                                        let _e4957 = phi_15385_;
                                                        let _e4959 = phi_15386_;
                                                        let _e4961 = phi_15387_;
                                                        let _e4963 = phi_15389_;
                                                        let _e4965 = phi_15390_;
                                                        local_29 = _e4957;
                                                        local_69 = _e4959;
                                                        local_70 = _e4961;
                                                        local_71 = _e4963;
                                                        local_72 = _e4965;
                                                        local_73 = _e4957;
                                                        local_74 = _e4953;
                                                        continue;
                                                        continuing {
                                                            phi_13199_ = _e3893;
                                                            phi_13202_ = _e4941;
                                                            phi_13204_ = _e4943;
                                                            phi_13206_ = _e4945;
                                                            phi_13208_ = _e4947;
                                                            phi_13210_ = _e4949;
                                                            phi_13212_ = _e4951;
                                                            break if !(_e4955);
                                                        }
                                                    }
                                                    let _e4968 = local_29;
                                                    if _e4968 {
                                                        phi_15394_ = false;
                                                        phi_15395_ = false;
                                                        phi_15397_ = false;
                                                        phi_15398_ = false;
                                                    } else {
                                                        let _e10611 = local_69;
                                                        phi_15394_ = _e10611;
                                                        let _e10614 = local_70;
                                                        phi_15395_ = _e10614;
                                                        let _e10617 = local_71;
                                                        phi_15397_ = _e10617;
                                                        let _e10620 = local_72;
                                                        phi_15398_ = _e10620;
                                                    }
                                                    let _e4970 = phi_15394_;
                                                    let _e4972 = phi_15395_;
                                                    let _e4974 = phi_15397_;
                                                    let _e4976 = phi_15398_;
                                                    if _e4970 {
                                                        let _e4978 = local_30;
                                                        phi_15403_ = type_28(1u, _e4978);
                                                        phi_15404_ = false;
                                                        phi_15406_ = false;
                                                        phi_15407_ = false;
                                                        phi_15408_ = false;
                                                    } else {
                                                        phi_15403_ = type_28();
                                                        phi_15404_ = _e4972;
                                                        let _e10626 = local_73;
                                                        phi_15406_ = _e10626;
                                                        phi_15407_ = _e4974;
                                                        phi_15408_ = _e4976;
                                                    }
                                                    let _e4981 = phi_15403_;
                                                    let _e4983 = phi_15404_;
                                                    let _e4985 = phi_15406_;
                                                    let _e4987 = phi_15407_;
                                                    let _e4989 = phi_15408_;
                                                    if _e4983 {
                                                        phi_15413_ = type_28(0u, type_28().member_1);
                                                        phi_15415_ = false;
                                                        phi_15416_ = false;
                                                        phi_15417_ = false;
                                                        phi_15418_ = true;
                                                    } else {
                                                        phi_15413_ = _e4981;
                                                        phi_15415_ = _e4985;
                                                        phi_15416_ = _e4987;
                                                        phi_15417_ = _e4989;
                                                        phi_15418_ = _e4970;
                                                    }
                                                    let _e4993 = phi_15413_;
                                                    let _e4995 = phi_15415_;
                                                    let _e4997 = phi_15416_;
                                                    let _e4999 = phi_15417_;
                                                    let _e5001 = phi_15418_;
                                                    if _e4995 {
                                                        let _e10636 = local_74;
                                                        phi_15430_ = _e10636;
                                                        phi_15431_ = true;
                                                        phi_15432_ = false;
                                                        phi_15433_ = false;
                                                    } else {
                                                        let _e10638 = local_75;
                                                        phi_15430_ = _e10638;
                                                        phi_15431_ = _e4997;
                                                        phi_15432_ = _e4999;
                                                        phi_15433_ = _e5001;
                                                    }
                                                    let _e5003 = phi_15430_;
                                                    let _e5005 = phi_15431_;
                                                    let _e5007 = phi_15432_;
                                                    let _e5009 = phi_15433_;
                                                    if _e5005 {
                                                        phi_15438_ = type_28(1u, _e5003);
                                                        phi_15439_ = false;
                                                        phi_15440_ = false;
                                                    } else {
                                                        phi_15438_ = type_28();
                                                        phi_15439_ = _e5007;
                                                        phi_15440_ = _e5009;
                                                    }
                                                    let _e5012 = phi_15438_;
                                                    let _e5014 = phi_15439_;
                                                    let _e5016 = phi_15440_;
                                                    if _e5014 {
                                                        phi_15445_ = type_28(0u, type_28().member_1);
                                                        phi_15446_ = true;
                                                    } else {
                                                        phi_15445_ = _e4993;
                                                        phi_15446_ = _e5016;
                                                    }
                                                    let _e5020 = phi_15445_;
                                                    let _e5022 = phi_15446_;
                                                    if _e5022 {
                                                        phi_15450_ = _e5020;
                                                    } else {
                                                        phi_15450_ = _e5012;
                                                    }
                                                    let _e5024 = phi_15450_;
                                                    let _e5027 = (_e5024.member != 0u);
                                                    if _e5027 {
                                                        phi_15457_ = false;
                                                    } else {
                                                        phi_15457_ = true;
                                                    }
                                                    let _e5029 = phi_15457_;
                                                    phi_15458_ = _e5024.member_1;
                                                    phi_15459_ = _e5029;
                                                    phi_15460_ = _e5027;
                                                    phi_15461_ = false;
                                                } else {
                                                    phi_15458_ = f32();
                                                    phi_15459_ = false;
                                                    phi_15460_ = false;
                                                    phi_15461_ = true;
                                                }
                                                let _e5031 = phi_15458_;
                                                let _e5033 = phi_15459_;
                                                let _e5035 = phi_15460_;
                                                let _e5037 = phi_15461_;
                                                phi_15462_ = _e3634;
                                                phi_15463_ = _e3635;
                                                phi_15464_ = _e5031;
                                                phi_15465_ = _e5033;
                                                phi_15466_ = _e5035;
                                                phi_15467_ = _e5037;
                                            }
                                            let _e5039 = phi_15462_;
                                            let _e5041 = phi_15463_;
                                            let _e5043 = phi_15464_;
                                            let _e5045 = phi_15465_;
                                            let _e5047 = phi_15466_;
                                            let _e5049 = phi_15467_;
                                            phi_15468_ = _e5039;
                                            phi_15469_ = _e5041;
                                            phi_15470_ = _e5043;
                                            phi_15471_ = _e3630;
                                            phi_15472_ = _e5045;
                                            phi_15473_ = _e5047;
                                            phi_15474_ = _e5049;
                                        }
                                        let _e5051 = phi_15468_;
                                        let _e5053 = phi_15469_;
                                        let _e5055 = phi_15470_;
                                        let _e5057 = phi_15471_;
                                        let _e5059 = phi_15472_;
                                        let _e5061 = phi_15473_;
                                        let _e5063 = phi_15474_;
                                        if _e5057 {
                                            phi_15478_ = false;
                                            phi_15479_ = false;
                                            phi_15480_ = false;
                                        } else {
                                            phi_15478_ = _e5059;
                                            phi_15479_ = _e5061;
                                            phi_15480_ = _e5063;
                                        }
                                        let _e5065 = phi_15478_;
                                        let _e5067 = phi_15479_;
                                        let _e5069 = phi_15480_;
                                        phi_15481_ = _e2930;
                                        phi_15482_ = _e5051;
                                        phi_15483_ = _e5053;
                                        phi_15484_ = _e5055;
                                        phi_15485_ = _e2930;
                                        phi_15486_ = _e5057;
                                        phi_15487_ = _e5065;
                                        phi_15488_ = _e5067;
                                        phi_15489_ = _e5069;
                                    } else {
                                        phi_15481_ = type_41();
                                        phi_15482_ = bool();
                                        phi_15483_ = f32();
                                        phi_15484_ = f32();
                                        phi_15485_ = type_41();
                                        phi_15486_ = true;
                                        phi_15487_ = false;
                                        phi_15488_ = false;
                                        phi_15489_ = false;
                                    }
                                    let _e5071 = phi_15481_;
                                    let _e5073 = phi_15482_;
                                    let _e5075 = phi_15483_;
                                    let _e5077 = phi_15484_;
                                    let _e5079 = phi_15485_;
                                    let _e5081 = phi_15486_;
                                    let _e5083 = phi_15487_;
                                    let _e5085 = phi_15488_;
                                    let _e5087 = phi_15489_;
                                    if _e5081 {
                                        phi_15493_ = true;
                                        phi_15494_ = false;
                                        phi_15495_ = false;
                                    } else {
                                        phi_15493_ = _e5083;
                                        phi_15494_ = _e5085;
                                        phi_15495_ = _e5087;
                                    }
                                    let _e5089 = phi_15493_;
                                    let _e5091 = phi_15494_;
                                    let _e5093 = phi_15495_;
                                    phi_15496_ = _e5071;
                                    phi_15497_ = _e5073;
                                    phi_15498_ = _e5075;
                                    phi_15499_ = _e5077;
                                    phi_15500_ = _e5079;
                                    phi_15501_ = _e5089;
                                    phi_15502_ = false;
                                    phi_15503_ = _e5091;
                                    phi_15504_ = _e5093;
                                } else {
                                    phi_15496_ = type_41();
                                    phi_15497_ = bool();
                                    phi_15498_ = f32();
                                    phi_15499_ = f32();
                                    phi_15500_ = type_41();
                                    phi_15501_ = false;
                                    phi_15502_ = true;
                                    phi_15503_ = false;
                                    phi_15504_ = false;
                                }
                                let _e5095 = phi_15496_;
                                let _e5097 = phi_15497_;
                                let _e5099 = phi_15498_;
                                let _e5101 = phi_15499_;
                                let _e5103 = phi_15500_;
                                let _e5105 = phi_15501_;
                                let _e5107 = phi_15502_;
                                let _e5109 = phi_15503_;
                                let _e5111 = phi_15504_;
                                local_31 = _e5107;
                                local_76 = _e5109;
                                local_77 = _e5111;
                                local_32 = _e5097;
                                local_33 = _e5095;
                                local_34 = _e5101;
                                local_35 = _e5099;
                                local_36 = _e5101;
                                local_37 = _e5101;
                                local_38 = _e5103;
                                continue;
                                continuing {
                                    phi_11307_ = _e2653;
                                    break if !(_e5105);
                                }
                            }
                            let _e5114 = local_31;
                            if _e5114 {
                                phi_15509_ = type_28(0u, type_28().member_1);
                                phi_15510_ = false;
                                phi_15511_ = false;
                            } else {
                                phi_15509_ = type_28();
                                let _e10694 = local_76;
                                phi_15510_ = _e10694;
                                let _e10697 = local_77;
                                phi_15511_ = _e10697;
                            }
                            let _e5118 = phi_15509_;
                            let _e5120 = phi_15510_;
                            let _e5122 = phi_15511_;
                            if _e5120 {
                                let _e5124 = local_32;
                                if _e5124 {
                                    let _e5126 = local_33;
                                    let _e5129 = local_34;
                                    let _e5132 = local_35;
                                    if ((_e5126.member_1 - _e5129) <= _e5132) {
                                        let _e5135 = local_36;
                                        phi_15525_ = type_28(1u, _e5135);
                                        phi_15526_ = false;
                                    } else {
                                        phi_15525_ = type_28();
                                        phi_15526_ = true;
                                    }
                                    let _e5138 = phi_15525_;
                                    let _e5140 = phi_15526_;
                                    phi_15527_ = _e5138;
                                    phi_15528_ = _e5140;
                                } else {
                                    phi_15527_ = type_28();
                                    phi_15528_ = true;
                                }
                                let _e5142 = phi_15527_;
                                let _e5144 = phi_15528_;
                                if _e5144 {
                                    let _e5146 = local_37;
                                    phi_15533_ = type_28(2u, _e5146);
                                } else {
                                    phi_15533_ = _e5142;
                                }
                                let _e5149 = phi_15533_;
                                phi_15534_ = _e5149;
                                phi_15535_ = false;
                            } else {
                                phi_15534_ = type_28();
                                phi_15535_ = _e5122;
                            }
                            let _e5151 = phi_15534_;
                            let _e5153 = phi_15535_;
                            if _e5153 {
                                let _e5155 = local_38;
                                phi_15541_ = type_28(1u, _e5155.member);
                                phi_15542_ = true;
                            } else {
                                phi_15541_ = _e5151;
                                phi_15542_ = _e5120;
                            }
                            let _e5159 = phi_15541_;
                            let _e5161 = phi_15542_;
                            phi_15546_ = _e5159;
                            phi_15547_ = _e5118;
                            phi_15548_ = _e5161;
                        } else {
                            phi_15546_ = _e2499;
                            phi_15547_ = type_28();
                            phi_15548_ = true;
                        }
                        let _e5163 = phi_15546_;
                        let _e5165 = phi_15547_;
                        let _e5167 = phi_15548_;
                        phi_15552_ = _e5163;
                        phi_15553_ = _e5165;
                        phi_15554_ = _e5167;
                    }
                    let _e5171 = phi_15552_;
                    let _e5173 = phi_15553_;
                    let _e5175 = phi_15554_;
                    if _e5175 {
                        phi_15558_ = _e5171;
                    } else {
                        phi_15558_ = _e5173;
                    }
                    let _e5177 = phi_15558_;
                    if (_e5177.member == 1u) {
                        if (_e5177.member_1 > _e319) {
                            phi_15569_ = false;
                        } else {
                            phi_15569_ = true;
                        }
                        let _e5183 = phi_15569_;
                        phi_15570_ = _e5183;
                    } else {
                        phi_15570_ = true;
                    }
                    let _e5185 = phi_15570_;
                    if _e5185 {
                        phi_15574_ = false;
                    } else {
                        phi_15574_ = true;
                    }
                    let _e5187 = phi_15574_;
                    if _e5187 {
                        phi_15578_ = 1u;
                    } else {
                        phi_15578_ = 0u;
                    }
                    let _e5189 = phi_15578_;
                    phi_15582_ = type_39(_e5177, _e5189);
                }
                let _e9683 = phi_15582_;
                switch bitcast<i32>(_e9683.member.member) {
                    case 0: {
                        phi_15597_ = type_42(0u, _e9683.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e9694 = function_3(_e9683.member.member_1);
                        phi_15597_ = type_42(0u, _e9683.member_1, _e9694, true);
                        break;
                    }
                    case 2: {
                        let _e9690 = function_3(_e9683.member.member_1);
                        phi_15597_ = type_42(1u, _e9683.member_1, _e9690, true);
                        break;
                    }
                    default: {
                        phi_15597_ = type_42();
                        break;
                    }
                }
                let _e9698 = phi_15597_;
                let _e9702 = params.member.member.member_12;
                let _e9703 = bitcast<u32>(_e9702);
                if (_e9703 < 8388608u) {
                    phi_15620_ = array<u32, 2>();
                    phi_15621_ = true;
                } else {
                    let _e9707 = ((_e9703 >> bitcast<u32>(31i)) == 1u);
                    if _e9707 {
                        phi_15619_ = array<u32, 2>();
                    } else {
                        phi_15619_ = array<u32, 2>((_e9703 << bitcast<u32>(29i)), ((((_e9703 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e9703 & 8388607u) >> bitcast<u32>(3i))));
                    }
                    let _e9721 = phi_15619_;
                    phi_15620_ = _e9721;
                    phi_15621_ = _e9707;
                }
                let _e9723 = phi_15620_;
                let _e9725 = phi_15621_;
                if _e9725 {
                    phi_15625_ = array<u32, 2>(0u, 0u);
                } else {
                    phi_15625_ = _e9723;
                }
                let _e9727 = phi_15625_;
                if (_e9698.member_2[0] == _e9727[0]) {
                    let _e9733 = params.member.member.member_12;
                    let _e9734 = bitcast<u32>(_e9733);
                    if (_e9734 < 8388608u) {
                        phi_15653_ = array<u32, 2>();
                        phi_15654_ = true;
                    } else {
                        let _e9738 = ((_e9734 >> bitcast<u32>(31i)) == 1u);
                        if _e9738 {
                            phi_15652_ = array<u32, 2>();
                        } else {
                            phi_15652_ = array<u32, 2>((_e9734 << bitcast<u32>(29i)), ((((_e9734 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e9734 & 8388607u) >> bitcast<u32>(3i))));
                        }
                        let _e9752 = phi_15652_;
                        phi_15653_ = _e9752;
                        phi_15654_ = _e9738;
                    }
                    let _e9754 = phi_15653_;
                    let _e9756 = phi_15654_;
                    if _e9756 {
                        phi_15658_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_15658_ = _e9754;
                    }
                    let _e9758 = phi_15658_;
                    phi_15661_ = (_e9698.member_2[1] == _e9758[1]);
                } else {
                    phi_15661_ = false;
                }
                let _e9762 = phi_15661_;
                let _e9764 = params.member.member.member_1;
                if ((_e9764 & 128u) != 0u) {
                    phi_15677_ = true;
                } else {
                    let _e9768 = params.member.member.member_1;
                    if ((_e9768 & 64u) != 0u) {
                        phi_15676_ = _e9762;
                    } else {
                        phi_15676_ = false;
                    }
                    let _e9772 = phi_15676_;
                    phi_15677_ = _e9772;
                }
                let _e9774 = phi_15677_;
                if _e9698.member_3 {
                    if _e9774 {
                        phi_15685_ = false;
                    } else {
                        phi_15685_ = true;
                    }
                    let _e9777 = phi_15685_;
                    phi_15686_ = _e9777;
                } else {
                    phi_15686_ = true;
                }
                let _e9779 = phi_15686_;
                if _e9779 {
                    phi_15691_ = _e9698.member;
                } else {
                    phi_15691_ = 1u;
                }
                let _e9782 = phi_15691_;
                if _e9698.member_3 {
                    phi_15699_ = (_e9782 == 0u);
                } else {
                    phi_15699_ = false;
                }
                let _e9788 = phi_15699_;
                if _e9788 {
                    let _e9793 = (_e9698.member_2[1] >> bitcast<u32>(20i));
                    if (_e9793 <= 896u) {
                        phi_15720_ = 0u;
                    } else {
                        phi_15720_ = ((((_e9793 - 896u) << bitcast<u32>(23i)) | ((_e9698.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e9698.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e9808 = phi_15720_;
                    let _e9810 = atomicMin((&earliest.member[0u]), _e9808);
                }
                phi_15724_ = type_20(0u, 0u, _e194, _e197, _e9698.member_2, _e9698.member_1);
                phi_15725_ = _e9788;
                phi_15726_ = (_e9782 != 0u);
            } else {
                phi_15724_ = type_20(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_15725_ = false;
                phi_15726_ = false;
            }
            let _e9812 = phi_15724_;
            let _e9814 = phi_15725_;
            let _e9816 = phi_15726_;
            let _e9819 = params.member.member.member_1;
            if ((_e9819 & 16u) != 0u) {
                if (_e123 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e9814 {
                    let _e9825 = atomicAdd((&counters[0u]), 1u);
                    phi_15745_ = _e9825;
                } else {
                    phi_15745_ = 0u;
                }
                let _e9827 = phi_15745_;
                workgroupBarrier();
                if (_e123 == 0u) {
                    let _e9830 = atomicLoad((&counters[0u]));
                    if (_e9830 > 0u) {
                        let _e9833 = atomicAdd((&contacts.member[0u]), _e9830);
                        atomicStore((&counters[1u]), _e9833);
                    }
                }
                workgroupBarrier();
                let _e9836 = atomicLoad((&counters[1u]));
                let _e9837 = (_e9836 + _e9827);
                if _e9814 {
                    let _e9840 = params.member.member_1.member_3;
                    if (_e9837 < _e9840) {
                        let _e9842 = (7u * _e9837);
                        atomicStore((&contacts.member[(4u + _e9842)]), _e9812.member);
                        atomicStore((&contacts.member[(_e9842 + 5u)]), _e9812.member_1);
                        atomicStore((&contacts.member[(_e9842 + 6u)]), _e9812.member_2);
                        atomicStore((&contacts.member[(_e9842 + 7u)]), _e9812.member_3);
                        atomicStore((&contacts.member[(_e9842 + 8u)]), _e9812.member_4[0]);
                        atomicStore((&contacts.member[(_e9842 + 9u)]), _e9812.member_4[1]);
                        atomicStore((&contacts.member[(_e9842 + 10u)]), _e9812.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e123 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e9816 {
                let _e9869 = atomicAdd((&counters[0u]), 1u);
                phi_15812_ = _e9869;
            } else {
                phi_15812_ = 0u;
            }
            let _e9871 = phi_15812_;
            workgroupBarrier();
            if (_e123 == 0u) {
                let _e9874 = atomicLoad((&counters[0u]));
                if (_e9874 > 0u) {
                    let _e9877 = atomicAdd((&undecided.member[0u]), _e9874);
                    atomicStore((&counters[1u]), _e9877);
                }
            }
            workgroupBarrier();
            let _e9880 = atomicLoad((&counters[1u]));
            let _e9881 = (_e9880 + _e9871);
            if _e9816 {
                let _e9884 = params.member.member_2.member;
                if (_e9881 < _e9884) {
                    let _e9888 = (2u * _e9881);
                    atomicStore((&undecided.member[(4u + _e9888)]), _e9812.member_2);
                    atomicStore((&undecided.member[(_e9888 + 5u)]), _e9812.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_846_ = _e179;
            break if !(_e185);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
