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
    var phi_717_: array<f32, 3>;

    if ((((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])) < (((param[0] * param[0]) + (param[1] * param[1])) + (param[2] * param[2]))) {
        phi_717_ = param_1;
    } else {
        phi_717_ = param;
    }
    let _e26 = phi_717_;
    return _e26;
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: u32) -> array<f32, 3> {
    var phi_578_: f32;
    var phi_579_: f32;
    var phi_618_: f32;
    var phi_619_: f32;
    var phi_664_: f32;
    var phi_665_: f32;
    var phi_399_: f32;
    var phi_400_: f32;
    var phi_445_: f32;
    var phi_446_: f32;
    var phi_488_: f32;
    var phi_489_: f32;
    var phi_537_: f32;
    var phi_538_: f32;
    var phi_680_: array<array<f32, 3>, 4>;

    let _e9 = (param_2[0] - param_3[0]);
    let _e12 = (param_2[1] - param_3[1]);
    let _e15 = (param_2[2] - param_3[2]);
    if (param_5 != 0u) {
        let _e157 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
        if (_e157 > 0f) {
            if (_e157 < 1f) {
                phi_399_ = _e157;
            } else {
                phi_399_ = 1f;
            }
            let _e161 = phi_399_;
            phi_400_ = _e161;
        } else {
            phi_400_ = 0f;
        }
        let _e163 = phi_400_;
        let _e199 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e199 > 0f) {
            if (_e199 < 1f) {
                phi_445_ = _e199;
            } else {
                phi_445_ = 1f;
            }
            let _e203 = phi_445_;
            phi_446_ = _e203;
        } else {
            phi_446_ = 0f;
        }
        let _e205 = phi_446_;
        let _e238 = ((((_e9 * param_4[0]) + (_e12 * param_4[1])) + (_e15 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e238 > 0f) {
            if (_e238 < 1f) {
                phi_488_ = _e238;
            } else {
                phi_488_ = 1f;
            }
            let _e242 = phi_488_;
            phi_489_ = _e242;
        } else {
            phi_489_ = 0f;
        }
        let _e244 = phi_489_;
        let _e257 = (param_2[0] - param_4[0]);
        let _e260 = (param_2[1] - param_4[1]);
        let _e263 = (param_2[2] - param_4[2]);
        let _e283 = ((((_e257 * param_3[0]) + (_e260 * param_3[1])) + (_e263 * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
        if (_e283 > 0f) {
            if (_e283 < 1f) {
                phi_537_ = _e283;
            } else {
                phi_537_ = 1f;
            }
            let _e287 = phi_537_;
            phi_538_ = _e287;
        } else {
            phi_538_ = 0f;
        }
        let _e289 = phi_538_;
        phi_680_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e163)), (param_2[1] - (param_3[1] * _e163)), (param_2[2] - (param_3[2] * _e163))), array<f32, 3>((param_2[0] - (param_4[0] * _e205)), (param_2[1] - (param_4[1] * _e205)), (param_2[2] - (param_4[2] * _e205))), array<f32, 3>((_e9 - (param_4[0] * _e244)), (_e12 - (param_4[1] * _e244)), (_e15 - (param_4[2] * _e244))), array<f32, 3>((_e257 - (param_3[0] * _e289)), (_e260 - (param_3[1] * _e289)), (_e263 - (param_3[2] * _e289))));
    } else {
        let _e19 = (param_4[0] - param_3[0]);
        let _e22 = (param_4[1] - param_3[1]);
        let _e25 = (param_4[2] - param_3[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > 0f) {
            if (_e36 < 1f) {
                phi_578_ = _e36;
            } else {
                phi_578_ = 1f;
            }
            let _e40 = phi_578_;
            phi_579_ = _e40;
        } else {
            phi_579_ = 0f;
        }
        let _e42 = phi_579_;
        let _e49 = array<f32, 3>((_e9 - (_e19 * _e42)), (_e12 - (_e22 * _e42)), (_e15 - (_e25 * _e42)));
        let _e72 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
        if (_e72 > 0f) {
            if (_e72 < 1f) {
                phi_618_ = _e72;
            } else {
                phi_618_ = 1f;
            }
            let _e76 = phi_618_;
            phi_619_ = _e76;
        } else {
            phi_619_ = 0f;
        }
        let _e78 = phi_619_;
        let _e114 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e114 > 0f) {
            if (_e114 < 1f) {
                phi_664_ = _e114;
            } else {
                phi_664_ = 1f;
            }
            let _e118 = phi_664_;
            phi_665_ = _e118;
        } else {
            phi_665_ = 0f;
        }
        let _e120 = phi_665_;
        phi_680_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e78)), (param_2[1] - (param_3[1] * _e78)), (param_2[2] - (param_3[2] * _e78))), array<f32, 3>((param_2[0] - (param_4[0] * _e120)), (param_2[1] - (param_4[1] * _e120)), (param_2[2] - (param_4[2] * _e120))), _e49, _e49);
    }
    let _e302 = phi_680_;
    let _e305 = function_(_e302[0], _e302[1]);
    let _e307 = function_(_e305, _e302[2]);
    let _e309 = function_(_e307, _e302[3]);
    return _e309;
}

fn function_2(param_6: array<f32, 3>, param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: u32) -> array<f32, 3> {
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_307_: bool;
    var phi_280_: bool;
    var phi_281_: bool;
    var phi_282_: bool;
    var phi_283_: bool;
    var phi_284_: bool;
    var phi_285_: bool;
    var phi_289_: bool;
    var phi_308_: bool;
    var phi_341_: array<f32, 3>;
    var phi_342_: bool;
    var phi_343_: array<f32, 3>;
    var phi_344_: bool;
    var phi_349_: array<f32, 3>;

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
                    phi_280_ = (_e78 <= 1f);
                    phi_281_ = false;
                } else {
                    phi_280_ = bool();
                    phi_281_ = true;
                }
                let _e99 = phi_280_;
                let _e101 = phi_281_;
                phi_282_ = _e99;
                phi_283_ = _e101;
            } else {
                phi_282_ = bool();
                phi_283_ = true;
            }
            let _e103 = phi_282_;
            let _e105 = phi_283_;
            phi_284_ = _e103;
            phi_285_ = _e105;
        } else {
            phi_284_ = bool();
            phi_285_ = true;
        }
        let _e107 = phi_284_;
        let _e109 = phi_285_;
        if _e109 {
            phi_289_ = false;
        } else {
            phi_289_ = _e107;
        }
        let _e111 = phi_289_;
        phi_308_ = _e111;
    } else {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                phi_300_ = ((_e74 + _e78) <= 1f);
                phi_301_ = false;
            } else {
                phi_300_ = bool();
                phi_301_ = true;
            }
            let _e85 = phi_300_;
            let _e87 = phi_301_;
            phi_302_ = _e85;
            phi_303_ = _e87;
        } else {
            phi_302_ = bool();
            phi_303_ = true;
        }
        let _e89 = phi_302_;
        let _e91 = phi_303_;
        if _e91 {
            phi_307_ = false;
        } else {
            phi_307_ = _e89;
        }
        let _e93 = phi_307_;
        phi_308_ = _e93;
    }
    let _e113 = phi_308_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e113 {
            phi_341_ = array<f32, 3>((param_6[0] - ((param_7[0] * _e74) + (param_8[0] * _e78))), (param_6[1] - ((param_7[1] * _e74) + (param_8[1] * _e78))), (param_6[2] - ((param_7[2] * _e74) + (param_8[2] * _e78))));
            phi_342_ = false;
        } else {
            phi_341_ = array<f32, 3>();
            phi_342_ = true;
        }
        let _e141 = phi_341_;
        let _e143 = phi_342_;
        phi_343_ = _e141;
        phi_344_ = _e143;
    } else {
        phi_343_ = array<f32, 3>();
        phi_344_ = true;
    }
    let _e145 = phi_343_;
    let _e147 = phi_344_;
    if _e147 {
        let _e148 = function_1(param_6, param_7, param_8, param_9);
        phi_349_ = _e148;
    } else {
        phi_349_ = _e145;
    }
    let _e150 = phi_349_;
    return _e150;
}

fn function_3(param_10: f32) -> array<u32, 2> {
    var phi_738_: array<u32, 2>;
    var phi_739_: array<u32, 2>;
    var phi_740_: bool;
    var phi_744_: array<u32, 2>;

    let _e13 = bitcast<u32>(param_10);
    if (_e13 < 8388608u) {
        phi_739_ = array<u32, 2>();
        phi_740_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_738_ = array<u32, 2>();
        } else {
            phi_738_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_738_;
        phi_739_ = _e31;
        phi_740_ = _e17;
    }
    let _e33 = phi_739_;
    let _e35 = phi_740_;
    if _e35 {
        phi_744_ = array<u32, 2>(0u, 0u);
    } else {
        phi_744_ = _e33;
    }
    let _e37 = phi_744_;
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
    var phi_803_: u32;
    var phi_819_: u32;
    var phi_840_: u32;
    var phi_841_: u32;
    var phi_844_: type_12;
    var phi_845_: type_12;
    var phi_868_: type_12;
    var phi_1042_: f32;
    var phi_1048_: f32;
    var phi_1053_: f32;
    var phi_1059_: f32;
    var phi_1064_: f32;
    var phi_1070_: f32;
    var phi_1076_: f32;
    var phi_1081_: f32;
    var phi_1087_: f32;
    var phi_1092_: f32;
    var phi_1097_: f32;
    var phi_1104_: f32;
    var phi_1110_: f32;
    var phi_1115_: f32;
    var phi_1121_: f32;
    var phi_1126_: f32;
    var phi_1132_: f32;
    var phi_1138_: f32;
    var phi_1143_: f32;
    var phi_1149_: f32;
    var phi_1154_: f32;
    var phi_1159_: f32;
    var phi_1166_: f32;
    var phi_1172_: f32;
    var phi_1177_: f32;
    var phi_1183_: f32;
    var phi_1188_: f32;
    var phi_1194_: f32;
    var phi_1200_: f32;
    var phi_1205_: f32;
    var phi_1211_: f32;
    var phi_1216_: f32;
    var phi_1221_: f32;
    var phi_1227_: f32;
    var phi_1232_: f32;
    var phi_1239_: bool;
    var phi_1263_: u32;
    var phi_1274_: f32;
    var phi_1275_: f32;
    var phi_1306_: type_38;
    var phi_1307_: bool;
    var phi_1308_: type_38;
    var phi_1309_: bool;
    var phi_1310_: type_38;
    var phi_1311_: bool;
    var phi_1316_: type_38;
    var phi_8257_: f32;
    var phi_8264_: f32;
    var phi_8269_: f32;
    var phi_8276_: f32;
    var phi_8281_: f32;
    var phi_8294_: f32;
    var phi_8301_: f32;
    var phi_8306_: f32;
    var phi_8313_: f32;
    var phi_8318_: f32;
    var phi_8323_: f32;
    var phi_8340_: f32;
    var phi_8347_: f32;
    var phi_8352_: f32;
    var phi_8359_: f32;
    var phi_8364_: f32;
    var phi_8378_: f32;
    var phi_8385_: f32;
    var phi_8390_: f32;
    var phi_8397_: f32;
    var phi_8402_: f32;
    var phi_8407_: f32;
    var phi_8424_: f32;
    var phi_8431_: f32;
    var phi_8436_: f32;
    var phi_8443_: f32;
    var phi_8448_: f32;
    var phi_8462_: f32;
    var phi_8469_: f32;
    var phi_8474_: f32;
    var phi_8481_: f32;
    var phi_8486_: f32;
    var phi_8491_: f32;
    var phi_8522_: f32;
    var phi_8528_: f32;
    var phi_8535_: f32;
    var phi_8542_: f32;
    var phi_8548_: f32;
    var phi_8555_: f32;
    var phi_8561_: f32;
    var phi_8567_: f32;
    var phi_8573_: f32;
    var phi_8580_: f32;
    var phi_8587_: f32;
    var phi_8611_: f32;
    var phi_8616_: f32;
    var phi_8621_: f32;
    var phi_8626_: f32;
    var phi_8631_: f32;
    var phi_8636_: f32;
    var phi_8646_: f32;
    var phi_8659_: f32;
    var phi_8665_: f32;
    var phi_8670_: f32;
    var phi_8676_: f32;
    var phi_8682_: f32;
    var phi_8687_: f32;
    var phi_8692_: f32;
    var phi_8700_: bool;
    var phi_8705_: f32;
    var phi_8712_: f32;
    var phi_8718_: f32;
    var phi_8736_: f32;
    var phi_8884_: f32;
    var phi_8891_: f32;
    var phi_8896_: f32;
    var phi_8903_: f32;
    var phi_8908_: f32;
    var phi_8921_: f32;
    var phi_8928_: f32;
    var phi_8933_: f32;
    var phi_8940_: f32;
    var phi_8945_: f32;
    var phi_8950_: f32;
    var phi_8967_: f32;
    var phi_8974_: f32;
    var phi_8979_: f32;
    var phi_8986_: f32;
    var phi_8991_: f32;
    var phi_9005_: f32;
    var phi_9012_: f32;
    var phi_9017_: f32;
    var phi_9024_: f32;
    var phi_9029_: f32;
    var phi_9034_: f32;
    var phi_9051_: f32;
    var phi_9058_: f32;
    var phi_9063_: f32;
    var phi_9070_: f32;
    var phi_9075_: f32;
    var phi_9089_: f32;
    var phi_9096_: f32;
    var phi_9101_: f32;
    var phi_9108_: f32;
    var phi_9113_: f32;
    var phi_9118_: f32;
    var phi_9236_: f32;
    var phi_9243_: f32;
    var phi_9251_: f32;
    var phi_9295_: type_14;
    var phi_9298_: f32;
    var phi_9319_: bool;
    var phi_9325_: type_15;
    var phi_9296_: type_14;
    var phi_9339_: type_15;
    var phi_9299_: f32;
    var local_19: f32;
    var phi_9288_: f32;
    var phi_9352_: f32;
    var phi_9418_: f32;
    var phi_9424_: f32;
    var phi_9433_: f32;
    var phi_9439_: f32;
    var phi_9448_: f32;
    var phi_9454_: f32;
    var phi_9463_: f32;
    var phi_9469_: f32;
    var phi_9475_: type_32;
    var phi_9476_: bool;
    var phi_9477_: type_32;
    var phi_9478_: bool;
    var phi_9486_: type_32;
    var phi_9655_: bool;
    var phi_9656_: bool;
    var phi_9657_: bool;
    var phi_9658_: bool;
    var phi_9659_: bool;
    var phi_9660_: bool;
    var phi_9664_: bool;
    var phi_9691_: f32;
    var phi_9745_: type_14;
    var phi_9748_: f32;
    var phi_9769_: bool;
    var phi_9775_: type_15;
    var phi_9746_: type_14;
    var phi_9789_: type_15;
    var phi_9749_: f32;
    var local_20: f32;
    var phi_9738_: f32;
    var phi_9802_: f32;
    var phi_9868_: f32;
    var phi_9874_: f32;
    var phi_9883_: f32;
    var phi_9889_: f32;
    var phi_9898_: f32;
    var phi_9904_: f32;
    var phi_9913_: f32;
    var phi_9919_: f32;
    var phi_9925_: type_32;
    var phi_9926_: bool;
    var phi_9927_: type_32;
    var phi_9928_: bool;
    var phi_9936_: type_32;
    var phi_10105_: bool;
    var phi_10106_: bool;
    var phi_10107_: bool;
    var phi_10108_: bool;
    var phi_10109_: bool;
    var phi_10110_: bool;
    var phi_10114_: bool;
    var phi_10147_: f32;
    var phi_10195_: type_14;
    var phi_10198_: f32;
    var phi_10219_: bool;
    var phi_10225_: type_15;
    var phi_10196_: type_14;
    var phi_10239_: type_15;
    var phi_10199_: f32;
    var local_21: f32;
    var phi_10188_: f32;
    var phi_10252_: f32;
    var phi_10318_: f32;
    var phi_10324_: f32;
    var phi_10333_: f32;
    var phi_10339_: f32;
    var phi_10348_: f32;
    var phi_10354_: f32;
    var phi_10363_: f32;
    var phi_10369_: f32;
    var phi_10375_: type_32;
    var phi_10376_: bool;
    var phi_10377_: type_32;
    var phi_10378_: bool;
    var phi_10386_: type_32;
    var phi_10555_: bool;
    var phi_10556_: bool;
    var phi_10557_: bool;
    var phi_10558_: bool;
    var phi_10559_: bool;
    var phi_10560_: bool;
    var phi_10564_: bool;
    var phi_10604_: f32;
    var phi_10645_: type_14;
    var phi_10648_: f32;
    var phi_10669_: bool;
    var phi_10675_: type_15;
    var phi_10646_: type_14;
    var phi_10689_: type_15;
    var phi_10649_: f32;
    var local_22: f32;
    var phi_10638_: f32;
    var phi_10702_: f32;
    var phi_10768_: f32;
    var phi_10774_: f32;
    var phi_10783_: f32;
    var phi_10789_: f32;
    var phi_10798_: f32;
    var phi_10804_: f32;
    var phi_10813_: f32;
    var phi_10819_: f32;
    var phi_10825_: type_32;
    var phi_10826_: bool;
    var phi_10827_: type_32;
    var phi_10828_: bool;
    var phi_10836_: type_32;
    var phi_11005_: bool;
    var phi_11006_: bool;
    var phi_11007_: bool;
    var phi_11008_: bool;
    var phi_11009_: bool;
    var phi_11010_: bool;
    var phi_11014_: bool;
    var phi_11015_: bool;
    var phi_11016_: bool;
    var phi_11017_: bool;
    var phi_11018_: bool;
    var phi_11019_: bool;
    var phi_11023_: bool;
    var phi_11029_: type_28;
    var phi_11030_: bool;
    var phi_11031_: type_28;
    var phi_11032_: bool;
    var phi_11075_: type_14;
    var phi_11078_: f32;
    var phi_11099_: bool;
    var phi_11105_: type_15;
    var phi_11076_: type_14;
    var phi_11119_: type_15;
    var phi_11079_: f32;
    var local_23: f32;
    var phi_11068_: f32;
    var phi_11132_: f32;
    var phi_11138_: f32;
    var phi_11163_: type_12;
    var phi_11166_: u32;
    var phi_11164_: type_12;
    var phi_11189_: type_12;
    var phi_11233_: u32;
    var phi_11234_: u32;
    var phi_11167_: u32;
    var phi_11235_: u32;
    var phi_11255_: type_12;
    var phi_11256_: type_12;
    var phi_11279_: type_12;
    var phi_11298_: f32;
    var phi_11311_: f32;
    var phi_11345_: f32;
    var phi_11352_: f32;
    var phi_11363_: bool;
    var phi_11364_: bool;
    var phi_11365_: bool;
    var phi_11366_: bool;
    var phi_11370_: bool;
    var phi_11381_: type_41;
    var phi_11382_: type_41;
    var phi_11383_: bool;
    var phi_11384_: type_41;
    var phi_11385_: bool;
    var phi_11396_: f32;
    var phi_11406_: type_12;
    var phi_11409_: f32;
    var phi_11411_: f32;
    var phi_11413_: f32;
    var phi_11407_: type_12;
    var phi_11436_: type_12;
    var phi_11461_: f32;
    var phi_11462_: f32;
    var phi_11488_: f32;
    var phi_11504_: f32;
    var phi_11511_: bool;
    var phi_11512_: bool;
    var phi_11513_: bool;
    var phi_11519_: f32;
    var phi_11520_: f32;
    var phi_11521_: bool;
    var phi_11410_: f32;
    var phi_11412_: f32;
    var phi_11414_: f32;
    var phi_11522_: f32;
    var phi_11523_: bool;
    var phi_11524_: bool;
    var local_24: bool;
    var phi_11528_: f32;
    var phi_11529_: f32;
    var phi_11537_: f32;
    var phi_11541_: type_12;
    var phi_11544_: f32;
    var phi_11542_: type_12;
    var phi_11567_: type_12;
    var phi_11597_: f32;
    var phi_11598_: bool;
    var phi_11599_: f32;
    var phi_11600_: bool;
    var phi_11601_: bool;
    var phi_11602_: bool;
    var phi_11603_: f32;
    var phi_11545_: f32;
    var phi_11604_: bool;
    var phi_11605_: bool;
    var phi_11606_: bool;
    var phi_11607_: bool;
    var local_25: bool;
    var phi_11611_: bool;
    var phi_11612_: bool;
    var phi_11616_: bool;
    var phi_11620_: f32;
    var phi_11621_: f32;
    var phi_11623_: type_41;
    var phi_11652_: f32;
    var phi_11659_: f32;
    var phi_11664_: f32;
    var phi_11671_: f32;
    var phi_11676_: f32;
    var phi_11689_: f32;
    var phi_11696_: f32;
    var phi_11701_: f32;
    var phi_11708_: f32;
    var phi_11713_: f32;
    var phi_11718_: f32;
    var phi_11777_: f32;
    var phi_11783_: f32;
    var phi_11788_: f32;
    var phi_11794_: f32;
    var phi_11799_: f32;
    var phi_11811_: f32;
    var phi_11817_: f32;
    var phi_11822_: f32;
    var phi_11828_: f32;
    var phi_11833_: f32;
    var phi_11859_: f32;
    var phi_11866_: f32;
    var phi_11871_: f32;
    var phi_11878_: f32;
    var phi_11883_: f32;
    var phi_11896_: f32;
    var phi_11903_: f32;
    var phi_11908_: f32;
    var phi_11915_: f32;
    var phi_11920_: f32;
    var phi_11925_: f32;
    var phi_11984_: f32;
    var phi_11990_: f32;
    var phi_11995_: f32;
    var phi_12001_: f32;
    var phi_12006_: f32;
    var phi_12018_: f32;
    var phi_12024_: f32;
    var phi_12029_: f32;
    var phi_12035_: f32;
    var phi_12040_: f32;
    var phi_12066_: f32;
    var phi_12073_: f32;
    var phi_12078_: f32;
    var phi_12085_: f32;
    var phi_12090_: f32;
    var phi_12103_: f32;
    var phi_12110_: f32;
    var phi_12115_: f32;
    var phi_12122_: f32;
    var phi_12127_: f32;
    var phi_12132_: f32;
    var phi_12191_: f32;
    var phi_12197_: f32;
    var phi_12202_: f32;
    var phi_12208_: f32;
    var phi_12213_: f32;
    var phi_12225_: f32;
    var phi_12231_: f32;
    var phi_12236_: f32;
    var phi_12242_: f32;
    var phi_12247_: f32;
    var phi_12296_: f32;
    var phi_12302_: f32;
    var phi_12330_: f32;
    var phi_12336_: f32;
    var phi_12341_: u32;
    var phi_12342_: u32;
    var phi_12312_: f32;
    var phi_12318_: f32;
    var phi_12323_: u32;
    var phi_12324_: u32;
    var phi_12343_: u32;
    var phi_12344_: u32;
    var phi_12413_: f32;
    var phi_12422_: f32;
    var phi_12557_: f32;
    var phi_12563_: f32;
    var phi_12570_: f32;
    var phi_12625_: type_12;
    var phi_12628_: bool;
    var phi_12626_: type_12;
    var phi_12651_: type_12;
    var phi_12678_: bool;
    var phi_12679_: bool;
    var phi_12629_: bool;
    var phi_12680_: bool;
    var phi_12681_: bool;
    var local_26: bool;
    var phi_12685_: bool;
    var local_27: bool;
    var phi_12692_: u32;
    var phi_12693_: u32;
    var phi_12694_: bool;
    var phi_12695_: u32;
    var phi_12696_: u32;
    var phi_12697_: bool;
    var phi_12701_: u32;
    var phi_12711_: bool;
    var phi_12723_: bool;
    var phi_12724_: bool;
    var phi_12872_: f32;
    var phi_12879_: f32;
    var phi_12884_: f32;
    var phi_12891_: f32;
    var phi_12896_: f32;
    var phi_12909_: f32;
    var phi_12916_: f32;
    var phi_12921_: f32;
    var phi_12928_: f32;
    var phi_12933_: f32;
    var phi_12938_: f32;
    var phi_12955_: f32;
    var phi_12962_: f32;
    var phi_12967_: f32;
    var phi_12974_: f32;
    var phi_12979_: f32;
    var phi_12993_: f32;
    var phi_13000_: f32;
    var phi_13005_: f32;
    var phi_13012_: f32;
    var phi_13017_: f32;
    var phi_13022_: f32;
    var phi_13039_: f32;
    var phi_13046_: f32;
    var phi_13051_: f32;
    var phi_13058_: f32;
    var phi_13063_: f32;
    var phi_13077_: f32;
    var phi_13084_: f32;
    var phi_13089_: f32;
    var phi_13096_: f32;
    var phi_13101_: f32;
    var phi_13106_: f32;
    var phi_13147_: type_12;
    var phi_13150_: f32;
    var phi_13152_: f32;
    var phi_13154_: f32;
    var phi_13156_: f32;
    var phi_13158_: bool;
    var phi_13160_: u32;
    var phi_13148_: type_12;
    var phi_13183_: type_12;
    var phi_13297_: f32;
    var phi_13303_: f32;
    var phi_13309_: f32;
    var phi_13311_: array<f32, 3>;
    var phi_13318_: f32;
    var phi_13325_: f32;
    var phi_13333_: f32;
    var phi_13377_: type_14;
    var phi_13380_: f32;
    var phi_13401_: bool;
    var phi_13407_: type_15;
    var phi_13378_: type_14;
    var phi_13421_: type_15;
    var phi_13381_: f32;
    var local_28: f32;
    var phi_13370_: f32;
    var phi_13434_: f32;
    var phi_13500_: f32;
    var phi_13506_: f32;
    var phi_13515_: f32;
    var phi_13521_: f32;
    var phi_13530_: f32;
    var phi_13536_: f32;
    var phi_13545_: f32;
    var phi_13551_: f32;
    var phi_13557_: type_32;
    var phi_13558_: bool;
    var phi_13559_: type_32;
    var phi_13560_: bool;
    var phi_13568_: type_32;
    var phi_13739_: bool;
    var phi_13740_: bool;
    var phi_13741_: bool;
    var phi_13742_: bool;
    var phi_13743_: bool;
    var phi_13744_: bool;
    var phi_13748_: bool;
    var phi_14045_: bool;
    var phi_14046_: bool;
    var phi_14047_: bool;
    var phi_14048_: bool;
    var phi_14049_: bool;
    var phi_14050_: bool;
    var phi_14054_: bool;
    var phi_14058_: bool;
    var phi_14069_: bool;
    var phi_14070_: bool;
    var phi_14144_: bool;
    var phi_14145_: bool;
    var phi_14165_: f32;
    var phi_14166_: bool;
    var phi_14167_: f32;
    var phi_14168_: bool;
    var phi_14169_: f32;
    var phi_14170_: bool;
    var phi_14171_: bool;
    var phi_14175_: f32;
    var phi_14176_: bool;
    var phi_14180_: f32;
    var phi_14212_: bool;
    var phi_14213_: bool;
    var phi_14233_: f32;
    var phi_14234_: bool;
    var phi_14235_: f32;
    var phi_14236_: bool;
    var phi_14237_: f32;
    var phi_14238_: bool;
    var phi_14239_: bool;
    var phi_14243_: f32;
    var phi_14244_: bool;
    var phi_14248_: f32;
    var phi_14253_: f32;
    var phi_14285_: bool;
    var phi_14286_: bool;
    var phi_14306_: f32;
    var phi_14307_: bool;
    var phi_14308_: f32;
    var phi_14309_: bool;
    var phi_14310_: f32;
    var phi_14311_: bool;
    var phi_14312_: bool;
    var phi_14316_: f32;
    var phi_14317_: bool;
    var phi_14321_: f32;
    var phi_14353_: bool;
    var phi_14354_: bool;
    var phi_14374_: f32;
    var phi_14375_: bool;
    var phi_14376_: f32;
    var phi_14377_: bool;
    var phi_14378_: f32;
    var phi_14379_: bool;
    var phi_14380_: bool;
    var phi_14384_: f32;
    var phi_14385_: bool;
    var phi_14389_: f32;
    var phi_14394_: f32;
    var phi_14399_: f32;
    var phi_14404_: f32;
    var phi_14898_: bool;
    var phi_14899_: bool;
    var phi_14904_: f32;
    var phi_14906_: f32;
    var phi_14909_: f32;
    var phi_14910_: f32;
    var phi_14911_: bool;
    var phi_14913_: f32;
    var phi_14914_: f32;
    var phi_14915_: f32;
    var phi_14917_: bool;
    var phi_14918_: bool;
    var phi_14920_: bool;
    var phi_14921_: f32;
    var phi_14922_: f32;
    var phi_14923_: f32;
    var phi_14925_: bool;
    var phi_14926_: bool;
    var phi_14927_: bool;
    var phi_14929_: bool;
    var phi_14930_: f32;
    var phi_14931_: f32;
    var phi_14932_: f32;
    var phi_14934_: bool;
    var phi_14935_: bool;
    var phi_14936_: bool;
    var phi_14938_: bool;
    var phi_15024_: f32;
    var phi_15097_: f32;
    var phi_15102_: f32;
    var phi_15175_: f32;
    var phi_15248_: f32;
    var phi_15253_: f32;
    var phi_15269_: f32;
    var phi_15270_: f32;
    var phi_15271_: f32;
    var phi_14951_: bool;
    var phi_15273_: u32;
    var phi_15274_: f32;
    var phi_15275_: bool;
    var phi_15276_: bool;
    var phi_15277_: bool;
    var phi_15278_: u32;
    var phi_15279_: f32;
    var phi_15280_: f32;
    var phi_15281_: f32;
    var phi_15282_: f32;
    var phi_15283_: bool;
    var phi_15284_: u32;
    var phi_15285_: bool;
    var phi_15286_: bool;
    var phi_15287_: bool;
    var phi_15288_: bool;
    var phi_15290_: bool;
    var phi_15299_: f32;
    var phi_15304_: f32;
    var phi_15313_: bool;
    var phi_15317_: bool;
    var phi_15318_: f32;
    var phi_15319_: f32;
    var phi_15320_: f32;
    var phi_15321_: f32;
    var phi_15322_: bool;
    var phi_15323_: u32;
    var phi_15324_: bool;
    var phi_15325_: bool;
    var phi_15326_: bool;
    var phi_15327_: bool;
    var phi_15329_: bool;
    var phi_13151_: f32;
    var phi_13153_: f32;
    var phi_13155_: f32;
    var phi_13157_: f32;
    var phi_13159_: bool;
    var phi_13161_: u32;
    var phi_15330_: f32;
    var phi_15332_: bool;
    var phi_15333_: bool;
    var phi_15334_: bool;
    var phi_15335_: bool;
    var phi_15337_: bool;
    var phi_15338_: bool;
    var local_29: bool;
    var phi_15342_: bool;
    var phi_15343_: bool;
    var phi_15345_: bool;
    var phi_15346_: bool;
    var local_30: f32;
    var phi_15351_: type_28;
    var phi_15352_: bool;
    var phi_15354_: bool;
    var phi_15355_: bool;
    var phi_15356_: bool;
    var phi_15361_: type_28;
    var phi_15363_: bool;
    var phi_15364_: bool;
    var phi_15365_: bool;
    var phi_15366_: bool;
    var phi_15378_: f32;
    var phi_15379_: bool;
    var phi_15380_: bool;
    var phi_15381_: bool;
    var phi_15386_: type_28;
    var phi_15387_: bool;
    var phi_15388_: bool;
    var phi_15393_: type_28;
    var phi_15394_: bool;
    var phi_15398_: type_28;
    var phi_15405_: bool;
    var phi_15406_: f32;
    var phi_15407_: bool;
    var phi_15408_: bool;
    var phi_15409_: bool;
    var phi_15410_: bool;
    var phi_15411_: f32;
    var phi_15412_: f32;
    var phi_15413_: bool;
    var phi_15414_: bool;
    var phi_15415_: bool;
    var phi_15416_: bool;
    var phi_15417_: f32;
    var phi_15418_: f32;
    var phi_15419_: bool;
    var phi_15420_: bool;
    var phi_15421_: bool;
    var phi_15422_: bool;
    var phi_15426_: bool;
    var phi_15427_: bool;
    var phi_15428_: bool;
    var phi_15429_: type_41;
    var phi_15430_: bool;
    var phi_15431_: f32;
    var phi_15432_: f32;
    var phi_15433_: type_41;
    var phi_15434_: bool;
    var phi_15435_: bool;
    var phi_15436_: bool;
    var phi_15437_: bool;
    var phi_15441_: bool;
    var phi_15442_: bool;
    var phi_15443_: bool;
    var phi_15444_: type_41;
    var phi_15445_: bool;
    var phi_15446_: f32;
    var phi_15447_: f32;
    var phi_15448_: type_41;
    var phi_15449_: bool;
    var phi_15450_: bool;
    var phi_15451_: bool;
    var phi_15452_: bool;
    var local_31: bool;
    var phi_15457_: type_28;
    var phi_15458_: bool;
    var phi_15459_: bool;
    var local_32: bool;
    var local_33: type_41;
    var local_34: f32;
    var local_35: f32;
    var local_36: f32;
    var phi_15473_: type_28;
    var phi_15474_: bool;
    var phi_15475_: type_28;
    var phi_15476_: bool;
    var local_37: f32;
    var phi_15481_: type_28;
    var phi_15482_: type_28;
    var phi_15483_: bool;
    var local_38: type_41;
    var phi_15489_: type_28;
    var phi_15490_: bool;
    var phi_15494_: type_28;
    var phi_15495_: type_28;
    var phi_15496_: bool;
    var phi_15500_: type_28;
    var phi_15501_: type_28;
    var phi_15502_: bool;
    var phi_15506_: type_28;
    var phi_15517_: bool;
    var phi_15518_: bool;
    var phi_15522_: bool;
    var phi_15526_: u32;
    var phi_1490_: type_14;
    var phi_1493_: f32;
    var phi_1514_: bool;
    var phi_1520_: type_15;
    var phi_1491_: type_14;
    var phi_1534_: type_15;
    var phi_1494_: f32;
    var local_39: f32;
    var phi_1483_: f32;
    var phi_1547_: f32;
    var phi_1563_: f32;
    var phi_1570_: f32;
    var phi_1575_: f32;
    var phi_1582_: f32;
    var phi_1587_: f32;
    var phi_1600_: f32;
    var phi_1607_: f32;
    var phi_1612_: f32;
    var phi_1619_: f32;
    var phi_1624_: f32;
    var phi_1629_: f32;
    var phi_1646_: f32;
    var phi_1653_: f32;
    var phi_1658_: f32;
    var phi_1665_: f32;
    var phi_1670_: f32;
    var phi_1684_: f32;
    var phi_1691_: f32;
    var phi_1696_: f32;
    var phi_1703_: f32;
    var phi_1708_: f32;
    var phi_1713_: f32;
    var phi_1730_: f32;
    var phi_1737_: f32;
    var phi_1742_: f32;
    var phi_1749_: f32;
    var phi_1754_: f32;
    var phi_1768_: f32;
    var phi_1775_: f32;
    var phi_1780_: f32;
    var phi_1787_: f32;
    var phi_1792_: f32;
    var phi_1797_: f32;
    var phi_2058_: f32;
    var phi_2065_: f32;
    var phi_2070_: f32;
    var phi_2077_: f32;
    var phi_2082_: f32;
    var phi_2095_: f32;
    var phi_2102_: f32;
    var phi_2107_: f32;
    var phi_2114_: f32;
    var phi_2119_: f32;
    var phi_2124_: f32;
    var phi_2141_: f32;
    var phi_2148_: f32;
    var phi_2153_: f32;
    var phi_2160_: f32;
    var phi_2165_: f32;
    var phi_2179_: f32;
    var phi_2186_: f32;
    var phi_2191_: f32;
    var phi_2198_: f32;
    var phi_2203_: f32;
    var phi_2208_: f32;
    var phi_2225_: f32;
    var phi_2232_: f32;
    var phi_2237_: f32;
    var phi_2244_: f32;
    var phi_2249_: f32;
    var phi_2263_: f32;
    var phi_2270_: f32;
    var phi_2275_: f32;
    var phi_2282_: f32;
    var phi_2287_: f32;
    var phi_2292_: f32;
    var phi_2323_: f32;
    var phi_2329_: f32;
    var phi_2336_: f32;
    var phi_2343_: f32;
    var phi_2349_: f32;
    var phi_2356_: f32;
    var phi_2362_: f32;
    var phi_2368_: f32;
    var phi_2374_: f32;
    var phi_2381_: f32;
    var phi_2388_: f32;
    var phi_2412_: f32;
    var phi_2417_: f32;
    var phi_2422_: f32;
    var phi_2427_: f32;
    var phi_2432_: f32;
    var phi_2437_: f32;
    var phi_2447_: f32;
    var phi_2456_: type_39;
    var phi_2457_: bool;
    var phi_2458_: type_39;
    var phi_2459_: bool;
    var phi_2465_: type_14;
    var phi_2468_: f32;
    var phi_2470_: u32;
    var phi_2472_: f32;
    var phi_2493_: bool;
    var phi_2499_: type_15;
    var phi_2466_: type_14;
    var phi_2513_: type_15;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_2675_: f32;
    var phi_2682_: f32;
    var phi_2687_: f32;
    var phi_2694_: f32;
    var phi_2699_: f32;
    var phi_2712_: f32;
    var phi_2719_: f32;
    var phi_2724_: f32;
    var phi_2731_: f32;
    var phi_2736_: f32;
    var phi_2741_: f32;
    var phi_2758_: f32;
    var phi_2765_: f32;
    var phi_2770_: f32;
    var phi_2777_: f32;
    var phi_2782_: f32;
    var phi_2796_: f32;
    var phi_2803_: f32;
    var phi_2808_: f32;
    var phi_2815_: f32;
    var phi_2820_: f32;
    var phi_2825_: f32;
    var phi_2842_: f32;
    var phi_2849_: f32;
    var phi_2854_: f32;
    var phi_2861_: f32;
    var phi_2866_: f32;
    var phi_2880_: f32;
    var phi_2887_: f32;
    var phi_2892_: f32;
    var phi_2899_: f32;
    var phi_2904_: f32;
    var phi_2909_: f32;
    var phi_2950_: type_12;
    var phi_2953_: f32;
    var phi_2955_: f32;
    var phi_2957_: f32;
    var phi_2959_: f32;
    var phi_2961_: bool;
    var phi_2963_: u32;
    var phi_2951_: type_12;
    var phi_2986_: type_12;
    var phi_3100_: f32;
    var phi_3106_: f32;
    var phi_3112_: f32;
    var phi_3114_: array<f32, 3>;
    var phi_3121_: f32;
    var phi_3128_: f32;
    var phi_3136_: f32;
    var phi_3180_: type_14;
    var phi_3183_: f32;
    var phi_3204_: bool;
    var phi_3210_: type_15;
    var phi_3181_: type_14;
    var phi_3224_: type_15;
    var phi_3184_: f32;
    var local_40: f32;
    var phi_3173_: f32;
    var phi_3237_: f32;
    var phi_3303_: f32;
    var phi_3309_: f32;
    var phi_3318_: f32;
    var phi_3324_: f32;
    var phi_3333_: f32;
    var phi_3339_: f32;
    var phi_3348_: f32;
    var phi_3354_: f32;
    var phi_3360_: type_32;
    var phi_3361_: bool;
    var phi_3362_: type_32;
    var phi_3363_: bool;
    var phi_3371_: type_32;
    var phi_3542_: bool;
    var phi_3543_: bool;
    var phi_3544_: bool;
    var phi_3545_: bool;
    var phi_3546_: bool;
    var phi_3547_: bool;
    var phi_3551_: bool;
    var phi_3848_: bool;
    var phi_3849_: bool;
    var phi_3850_: bool;
    var phi_3851_: bool;
    var phi_3852_: bool;
    var phi_3853_: bool;
    var phi_3857_: bool;
    var phi_3861_: bool;
    var phi_3872_: bool;
    var phi_3873_: bool;
    var phi_3947_: bool;
    var phi_3948_: bool;
    var phi_3968_: f32;
    var phi_3969_: bool;
    var phi_3970_: f32;
    var phi_3971_: bool;
    var phi_3972_: f32;
    var phi_3973_: bool;
    var phi_3974_: bool;
    var phi_3978_: f32;
    var phi_3979_: bool;
    var phi_3983_: f32;
    var phi_4015_: bool;
    var phi_4016_: bool;
    var phi_4036_: f32;
    var phi_4037_: bool;
    var phi_4038_: f32;
    var phi_4039_: bool;
    var phi_4040_: f32;
    var phi_4041_: bool;
    var phi_4042_: bool;
    var phi_4046_: f32;
    var phi_4047_: bool;
    var phi_4051_: f32;
    var phi_4056_: f32;
    var phi_4088_: bool;
    var phi_4089_: bool;
    var phi_4109_: f32;
    var phi_4110_: bool;
    var phi_4111_: f32;
    var phi_4112_: bool;
    var phi_4113_: f32;
    var phi_4114_: bool;
    var phi_4115_: bool;
    var phi_4119_: f32;
    var phi_4120_: bool;
    var phi_4124_: f32;
    var phi_4156_: bool;
    var phi_4157_: bool;
    var phi_4177_: f32;
    var phi_4178_: bool;
    var phi_4179_: f32;
    var phi_4180_: bool;
    var phi_4181_: f32;
    var phi_4182_: bool;
    var phi_4183_: bool;
    var phi_4187_: f32;
    var phi_4188_: bool;
    var phi_4192_: f32;
    var phi_4197_: f32;
    var phi_4202_: f32;
    var phi_4207_: f32;
    var phi_4220_: f32;
    var phi_4357_: type_14;
    var phi_4360_: f32;
    var phi_4381_: bool;
    var phi_4387_: type_15;
    var phi_4358_: type_14;
    var phi_4401_: type_15;
    var phi_4361_: f32;
    var local_41: f32;
    var phi_4350_: f32;
    var phi_4414_: f32;
    var phi_4430_: f32;
    var phi_4437_: f32;
    var phi_4442_: f32;
    var phi_4449_: f32;
    var phi_4454_: f32;
    var phi_4467_: f32;
    var phi_4474_: f32;
    var phi_4479_: f32;
    var phi_4486_: f32;
    var phi_4491_: f32;
    var phi_4496_: f32;
    var phi_4513_: f32;
    var phi_4520_: f32;
    var phi_4525_: f32;
    var phi_4532_: f32;
    var phi_4537_: f32;
    var phi_4551_: f32;
    var phi_4558_: f32;
    var phi_4563_: f32;
    var phi_4570_: f32;
    var phi_4575_: f32;
    var phi_4580_: f32;
    var phi_4597_: f32;
    var phi_4604_: f32;
    var phi_4609_: f32;
    var phi_4616_: f32;
    var phi_4621_: f32;
    var phi_4635_: f32;
    var phi_4642_: f32;
    var phi_4647_: f32;
    var phi_4654_: f32;
    var phi_4659_: f32;
    var phi_4664_: f32;
    var phi_4684_: bool;
    var phi_4685_: bool;
    var phi_4686_: bool;
    var phi_4701_: bool;
    var phi_4702_: bool;
    var phi_4707_: f32;
    var phi_4709_: f32;
    var phi_4710_: f32;
    var phi_4711_: bool;
    var phi_4712_: f32;
    var phi_4713_: f32;
    var phi_4714_: bool;
    var phi_4715_: bool;
    var phi_4716_: f32;
    var phi_4717_: f32;
    var phi_4718_: f32;
    var phi_4719_: f32;
    var phi_4720_: bool;
    var phi_4721_: bool;
    var phi_4722_: bool;
    var phi_4723_: bool;
    var phi_4724_: f32;
    var phi_4725_: f32;
    var phi_4726_: f32;
    var phi_4727_: f32;
    var phi_4728_: bool;
    var phi_4729_: bool;
    var phi_4730_: bool;
    var phi_4731_: bool;
    var phi_4732_: bool;
    var phi_4733_: f32;
    var phi_4734_: f32;
    var phi_4735_: f32;
    var phi_4736_: f32;
    var phi_4737_: bool;
    var phi_4738_: bool;
    var phi_4739_: bool;
    var phi_4740_: bool;
    var phi_4741_: bool;
    var phi_4827_: f32;
    var phi_4900_: f32;
    var phi_4905_: f32;
    var phi_4978_: f32;
    var phi_5051_: f32;
    var phi_5056_: f32;
    var phi_5072_: f32;
    var phi_5073_: f32;
    var phi_5074_: f32;
    var phi_4754_: bool;
    var phi_5076_: u32;
    var phi_5077_: f32;
    var phi_5078_: bool;
    var phi_5079_: bool;
    var phi_5080_: bool;
    var phi_5081_: u32;
    var phi_5082_: f32;
    var phi_5083_: f32;
    var phi_5084_: f32;
    var phi_5085_: f32;
    var phi_5086_: bool;
    var phi_5087_: u32;
    var phi_5088_: bool;
    var phi_5089_: bool;
    var phi_5090_: bool;
    var phi_5091_: bool;
    var phi_5092_: bool;
    var phi_5093_: bool;
    var phi_5102_: f32;
    var phi_5107_: f32;
    var phi_5116_: bool;
    var phi_5120_: bool;
    var phi_5121_: f32;
    var phi_5122_: f32;
    var phi_5123_: f32;
    var phi_5124_: f32;
    var phi_5125_: bool;
    var phi_5126_: u32;
    var phi_5127_: bool;
    var phi_5128_: bool;
    var phi_5129_: bool;
    var phi_5130_: bool;
    var phi_5131_: bool;
    var phi_5132_: bool;
    var phi_2954_: f32;
    var phi_2956_: f32;
    var phi_2958_: f32;
    var phi_2960_: f32;
    var phi_2962_: bool;
    var phi_2964_: u32;
    var phi_5133_: f32;
    var phi_5134_: f32;
    var phi_5135_: bool;
    var phi_5136_: bool;
    var phi_5137_: bool;
    var phi_5138_: bool;
    var phi_5139_: bool;
    var phi_5140_: bool;
    var phi_5141_: bool;
    var local_42: bool;
    var phi_5145_: bool;
    var phi_5146_: bool;
    var phi_5147_: bool;
    var phi_5148_: bool;
    var phi_5149_: bool;
    var local_43: f32;
    var phi_5154_: type_28;
    var phi_5155_: bool;
    var phi_5156_: bool;
    var phi_5157_: bool;
    var phi_5158_: bool;
    var phi_5159_: bool;
    var phi_5164_: type_28;
    var phi_5165_: bool;
    var phi_5166_: bool;
    var phi_5167_: bool;
    var phi_5168_: bool;
    var phi_5169_: bool;
    var phi_5173_: f32;
    var phi_5174_: bool;
    var phi_5175_: bool;
    var phi_5176_: bool;
    var phi_5177_: bool;
    var phi_5181_: f32;
    var phi_5182_: bool;
    var phi_5183_: bool;
    var phi_5184_: bool;
    var phi_5189_: type_28;
    var phi_5190_: bool;
    var phi_5191_: bool;
    var phi_5196_: type_28;
    var phi_5197_: bool;
    var phi_5201_: type_28;
    var phi_5208_: f32;
    var phi_5209_: bool;
    var phi_5321_: f32;
    var phi_5328_: f32;
    var phi_5336_: f32;
    var phi_5487_: f32;
    var phi_5494_: f32;
    var phi_5499_: f32;
    var phi_5506_: f32;
    var phi_5511_: f32;
    var phi_5524_: f32;
    var phi_5531_: f32;
    var phi_5536_: f32;
    var phi_5543_: f32;
    var phi_5548_: f32;
    var phi_5553_: f32;
    var phi_5570_: f32;
    var phi_5577_: f32;
    var phi_5582_: f32;
    var phi_5589_: f32;
    var phi_5594_: f32;
    var phi_5608_: f32;
    var phi_5615_: f32;
    var phi_5620_: f32;
    var phi_5627_: f32;
    var phi_5632_: f32;
    var phi_5637_: f32;
    var phi_5654_: f32;
    var phi_5661_: f32;
    var phi_5666_: f32;
    var phi_5673_: f32;
    var phi_5678_: f32;
    var phi_5692_: f32;
    var phi_5699_: f32;
    var phi_5704_: f32;
    var phi_5711_: f32;
    var phi_5716_: f32;
    var phi_5721_: f32;
    var phi_5829_: type_14;
    var phi_5832_: f32;
    var phi_5853_: bool;
    var phi_5859_: type_15;
    var phi_5830_: type_14;
    var phi_5873_: type_15;
    var phi_5833_: f32;
    var local_44: f32;
    var phi_5822_: f32;
    var phi_5886_: f32;
    var phi_6020_: f32;
    var phi_6026_: f32;
    var phi_6035_: f32;
    var phi_6041_: f32;
    var phi_6050_: f32;
    var phi_6056_: f32;
    var phi_6065_: f32;
    var phi_6071_: f32;
    var phi_6121_: type_14;
    var phi_6124_: f32;
    var phi_6145_: bool;
    var phi_6151_: type_15;
    var phi_6122_: type_14;
    var phi_6165_: type_15;
    var phi_6125_: f32;
    var local_45: f32;
    var phi_6114_: f32;
    var phi_6178_: f32;
    var phi_6210_: type_14;
    var phi_6213_: f32;
    var phi_6234_: bool;
    var phi_6240_: type_15;
    var phi_6211_: type_14;
    var phi_6254_: type_15;
    var phi_6214_: f32;
    var local_46: f32;
    var phi_6203_: f32;
    var phi_6267_: f32;
    var phi_6283_: f32;
    var phi_6290_: f32;
    var phi_6295_: f32;
    var phi_6302_: f32;
    var phi_6307_: f32;
    var phi_6320_: f32;
    var phi_6327_: f32;
    var phi_6332_: f32;
    var phi_6339_: f32;
    var phi_6344_: f32;
    var phi_6349_: f32;
    var phi_6366_: f32;
    var phi_6373_: f32;
    var phi_6378_: f32;
    var phi_6385_: f32;
    var phi_6390_: f32;
    var phi_6404_: f32;
    var phi_6411_: f32;
    var phi_6416_: f32;
    var phi_6423_: f32;
    var phi_6428_: f32;
    var phi_6433_: f32;
    var phi_6450_: f32;
    var phi_6457_: f32;
    var phi_6462_: f32;
    var phi_6469_: f32;
    var phi_6474_: f32;
    var phi_6488_: f32;
    var phi_6495_: f32;
    var phi_6500_: f32;
    var phi_6507_: f32;
    var phi_6512_: f32;
    var phi_6517_: f32;
    var phi_6558_: f32;
    var phi_6564_: f32;
    var phi_6575_: type_12;
    var phi_6578_: f32;
    var phi_6576_: type_12;
    var phi_6601_: type_12;
    var phi_6630_: f32;
    var phi_6636_: f32;
    var phi_6649_: f32;
    var phi_6579_: f32;
    var local_47: f32;
    var local_48: f32;
    var phi_6677_: type_14;
    var phi_6680_: f32;
    var phi_6701_: bool;
    var phi_6707_: type_15;
    var phi_6678_: type_14;
    var phi_6721_: type_15;
    var phi_6681_: f32;
    var local_49: f32;
    var phi_6670_: f32;
    var phi_6734_: f32;
    var phi_6739_: type_12;
    var phi_6742_: f32;
    var phi_6744_: bool;
    var phi_6746_: bool;
    var phi_6740_: type_12;
    var phi_6769_: type_12;
    var phi_6806_: f32;
    var phi_6813_: f32;
    var phi_6821_: f32;
    var phi_6829_: f32;
    var phi_6836_: f32;
    var phi_6844_: f32;
    var phi_6850_: f32;
    var phi_6868_: f32;
    var phi_6874_: f32;
    var phi_6881_: f32;
    var phi_6907_: f32;
    var phi_6913_: f32;
    var phi_6949_: bool;
    var phi_6956_: bool;
    var phi_6969_: f32;
    var phi_6975_: f32;
    var phi_6976_: f32;
    var phi_6977_: f32;
    var phi_6743_: f32;
    var phi_6745_: bool;
    var phi_6747_: bool;
    var local_50: f32;
    var phi_6982_: f32;
    var local_51: bool;
    var local_52: bool;
    var phi_6991_: type_40;
    var phi_6992_: type_40;
    var phi_6993_: bool;
    var local_53: bool;
    var phi_7010_: f32;
    var phi_7011_: f32;
    var phi_7014_: type_12;
    var phi_7017_: f32;
    var phi_7019_: f32;
    var phi_7015_: type_12;
    var phi_7042_: type_12;
    var phi_7121_: f32;
    var phi_7122_: f32;
    var phi_7110_: f32;
    var phi_7123_: f32;
    var phi_7124_: f32;
    var phi_7018_: f32;
    var phi_7020_: f32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var phi_7285_: bool;
    var phi_7286_: bool;
    var phi_7287_: bool;
    var phi_7288_: bool;
    var phi_7289_: bool;
    var phi_7290_: bool;
    var phi_7294_: bool;
    var phi_7298_: bool;
    var phi_7299_: bool;
    var phi_7300_: bool;
    var phi_7304_: f32;
    var phi_7307_: type_40;
    var phi_7308_: type_40;
    var phi_7309_: bool;
    var phi_7310_: type_40;
    var phi_7311_: type_40;
    var phi_7312_: bool;
    var phi_7317_: type_40;
    var phi_7318_: type_40;
    var phi_7319_: bool;
    var phi_7323_: type_40;
    var phi_7324_: type_40;
    var phi_7325_: bool;
    var phi_7326_: bool;
    var phi_7327_: type_40;
    var phi_7328_: type_40;
    var phi_7329_: bool;
    var phi_7330_: bool;
    var phi_7335_: type_40;
    var phi_7336_: bool;
    var phi_7340_: type_40;
    var phi_7356_: f32;
    var phi_7357_: f32;
    var phi_7358_: bool;
    var phi_7359_: f32;
    var phi_7360_: f32;
    var phi_7361_: bool;
    var phi_7362_: bool;
    var phi_7363_: bool;
    var phi_7364_: f32;
    var phi_7365_: f32;
    var phi_7366_: bool;
    var phi_7367_: bool;
    var phi_7368_: bool;
    var phi_7369_: f32;
    var phi_7370_: u32;
    var phi_7371_: f32;
    var phi_7372_: type_40;
    var phi_7373_: u32;
    var phi_7374_: u32;
    var phi_7375_: bool;
    var phi_7376_: bool;
    var phi_7377_: bool;
    var phi_7378_: f32;
    var phi_7379_: u32;
    var phi_7380_: f32;
    var phi_7381_: type_40;
    var phi_7382_: u32;
    var phi_7383_: u32;
    var phi_7384_: bool;
    var phi_7385_: bool;
    var phi_7386_: bool;
    var phi_7387_: bool;
    var phi_7388_: bool;
    var phi_7389_: f32;
    var phi_2469_: f32;
    var phi_2471_: u32;
    var phi_2473_: f32;
    var phi_7390_: type_40;
    var phi_7391_: u32;
    var phi_7392_: f32;
    var phi_7393_: u32;
    var phi_7394_: bool;
    var phi_7395_: bool;
    var phi_7396_: bool;
    var phi_7397_: bool;
    var phi_7398_: bool;
    var phi_7399_: bool;
    var local_57: bool;
    var phi_7403_: bool;
    var phi_7404_: bool;
    var phi_7405_: bool;
    var phi_7406_: bool;
    var local_58: type_40;
    var local_59: type_40;
    var phi_7423_: u32;
    var local_60: type_40;
    var phi_7428_: type_39;
    var phi_7429_: type_39;
    var phi_7430_: bool;
    var phi_7431_: bool;
    var phi_7432_: bool;
    var phi_7433_: bool;
    var phi_7437_: u32;
    var phi_7438_: f32;
    var phi_7439_: bool;
    var phi_7440_: bool;
    var phi_7441_: bool;
    var phi_7442_: bool;
    var phi_7446_: f32;
    var phi_7447_: u32;
    var phi_7448_: bool;
    var phi_7449_: bool;
    var phi_7450_: bool;
    var phi_7462_: f32;
    var phi_7465_: type_12;
    var phi_7466_: type_12;
    var phi_7489_: type_12;
    var phi_7510_: f32;
    var phi_7640_: type_14;
    var phi_7643_: f32;
    var phi_7664_: bool;
    var phi_7670_: type_15;
    var phi_7641_: type_14;
    var phi_7684_: type_15;
    var phi_7644_: f32;
    var local_61: f32;
    var phi_7633_: f32;
    var phi_7697_: f32;
    var phi_7713_: f32;
    var phi_7720_: f32;
    var phi_7725_: f32;
    var phi_7732_: f32;
    var phi_7737_: f32;
    var phi_7750_: f32;
    var phi_7757_: f32;
    var phi_7762_: f32;
    var phi_7769_: f32;
    var phi_7774_: f32;
    var phi_7779_: f32;
    var phi_7796_: f32;
    var phi_7803_: f32;
    var phi_7808_: f32;
    var phi_7815_: f32;
    var phi_7820_: f32;
    var phi_7834_: f32;
    var phi_7841_: f32;
    var phi_7846_: f32;
    var phi_7853_: f32;
    var phi_7858_: f32;
    var phi_7863_: f32;
    var phi_7880_: f32;
    var phi_7887_: f32;
    var phi_7892_: f32;
    var phi_7899_: f32;
    var phi_7904_: f32;
    var phi_7918_: f32;
    var phi_7925_: f32;
    var phi_7930_: f32;
    var phi_7937_: f32;
    var phi_7942_: f32;
    var phi_7947_: f32;
    var phi_7967_: bool;
    var phi_7968_: bool;
    var phi_7969_: bool;
    var local_62: bool;
    var phi_7977_: u32;
    var phi_7981_: type_39;
    var phi_7982_: bool;
    var phi_7990_: u32;
    var phi_7994_: type_39;
    var phi_7995_: type_39;
    var phi_7996_: bool;
    var phi_7997_: bool;
    var phi_8004_: type_39;
    var phi_8005_: bool;
    var phi_8009_: type_39;
    var phi_8010_: type_39;
    var phi_8011_: bool;
    var phi_8015_: type_39;
    var phi_15530_: type_39;
    var phi_15545_: type_42;
    var phi_15567_: array<u32, 2>;
    var phi_15568_: array<u32, 2>;
    var phi_15569_: bool;
    var phi_15573_: array<u32, 2>;
    var phi_15600_: array<u32, 2>;
    var phi_15601_: array<u32, 2>;
    var phi_15602_: bool;
    var phi_15606_: array<u32, 2>;
    var phi_15609_: bool;
    var phi_15624_: bool;
    var phi_15625_: bool;
    var phi_15633_: bool;
    var phi_15634_: bool;
    var phi_15639_: u32;
    var phi_15647_: bool;
    var phi_15668_: u32;
    var phi_15672_: type_20;
    var phi_15673_: bool;
    var phi_15674_: bool;
    var phi_15693_: u32;
    var phi_15760_: u32;
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
        phi_803_ = _e141;
    } else {
        phi_803_ = _e143;
    }
    let _e146 = phi_803_;
    let _e147 = (_e146 / 64u);
    if ((_e146 % 64u) > 0u) {
        phi_819_ = (_e147 + 1u);
    } else {
        phi_819_ = _e147;
    }
    let _e152 = phi_819_;
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
            phi_840_ = (_e156 + 1u);
        } else {
            phi_840_ = _e156;
        }
        let _e162 = phi_840_;
        phi_841_ = _e162;
    } else {
        phi_841_ = 0u;
    }
    let _e164 = phi_841_;
    phi_844_ = type_12(0u, _e164);
    loop {
        let _e167 = phi_844_;
        if (_e167.member < _e167.member_1) {
            phi_845_ = type_12((_e167.member + 1u), _e167.member_1);
            phi_868_ = type_12(1u, _e167.member);
        } else {
            phi_845_ = _e167;
            phi_868_ = type_12(0u, type_12().member_1);
        }
        let _e179 = phi_845_;
        let _e181 = phi_868_;
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
                let _e276 = params.member.member.member_5;
                let _e278 = params.member.member.member_11;
                let _e280 = params.member.member.member_12;
                let _e282 = params.member.member.member_13;
                let _e284 = params.member.member.member_1;
                if (_e246 < 0f) {
                    phi_1042_ = -(_e246);
                } else {
                    phi_1042_ = _e246;
                }
                let _e290 = phi_1042_;
                if (_e247 < 0f) {
                    phi_1048_ = -(_e247);
                } else {
                    phi_1048_ = _e247;
                }
                let _e294 = phi_1048_;
                if (_e290 > _e294) {
                    phi_1053_ = _e290;
                } else {
                    phi_1053_ = _e294;
                }
                let _e297 = phi_1053_;
                if (_e248 < 0f) {
                    phi_1059_ = -(_e248);
                } else {
                    phi_1059_ = _e248;
                }
                let _e301 = phi_1059_;
                if (_e297 > _e301) {
                    phi_1064_ = _e297;
                } else {
                    phi_1064_ = _e301;
                }
                let _e304 = phi_1064_;
                if (_e250 < 0f) {
                    phi_1070_ = -(_e250);
                } else {
                    phi_1070_ = _e250;
                }
                let _e308 = phi_1070_;
                if (_e251 < 0f) {
                    phi_1076_ = -(_e251);
                } else {
                    phi_1076_ = _e251;
                }
                let _e312 = phi_1076_;
                if (_e308 > _e312) {
                    phi_1081_ = _e308;
                } else {
                    phi_1081_ = _e312;
                }
                let _e315 = phi_1081_;
                if (_e252 < 0f) {
                    phi_1087_ = -(_e252);
                } else {
                    phi_1087_ = _e252;
                }
                let _e319 = phi_1087_;
                if (_e315 > _e319) {
                    phi_1092_ = _e315;
                } else {
                    phi_1092_ = _e319;
                }
                let _e322 = phi_1092_;
                if (_e304 > _e322) {
                    phi_1097_ = _e304;
                } else {
                    phi_1097_ = _e322;
                }
                let _e325 = phi_1097_;
                let _e326 = (_e325 + _e273);
                if (_e255 < 0f) {
                    phi_1104_ = -(_e255);
                } else {
                    phi_1104_ = _e255;
                }
                let _e330 = phi_1104_;
                if (_e256 < 0f) {
                    phi_1110_ = -(_e256);
                } else {
                    phi_1110_ = _e256;
                }
                let _e334 = phi_1110_;
                if (_e330 > _e334) {
                    phi_1115_ = _e330;
                } else {
                    phi_1115_ = _e334;
                }
                let _e337 = phi_1115_;
                if (_e257 < 0f) {
                    phi_1121_ = -(_e257);
                } else {
                    phi_1121_ = _e257;
                }
                let _e341 = phi_1121_;
                if (_e337 > _e341) {
                    phi_1126_ = _e337;
                } else {
                    phi_1126_ = _e341;
                }
                let _e344 = phi_1126_;
                if (_e259 < 0f) {
                    phi_1132_ = -(_e259);
                } else {
                    phi_1132_ = _e259;
                }
                let _e348 = phi_1132_;
                if (_e260 < 0f) {
                    phi_1138_ = -(_e260);
                } else {
                    phi_1138_ = _e260;
                }
                let _e352 = phi_1138_;
                if (_e348 > _e352) {
                    phi_1143_ = _e348;
                } else {
                    phi_1143_ = _e352;
                }
                let _e355 = phi_1143_;
                if (_e261 < 0f) {
                    phi_1149_ = -(_e261);
                } else {
                    phi_1149_ = _e261;
                }
                let _e359 = phi_1149_;
                if (_e355 > _e359) {
                    phi_1154_ = _e355;
                } else {
                    phi_1154_ = _e359;
                }
                let _e362 = phi_1154_;
                if (_e344 > _e362) {
                    phi_1159_ = _e344;
                } else {
                    phi_1159_ = _e362;
                }
                let _e365 = phi_1159_;
                let _e366 = (_e365 + _e273);
                if (_e264 < 0f) {
                    phi_1166_ = -(_e264);
                } else {
                    phi_1166_ = _e264;
                }
                let _e370 = phi_1166_;
                if (_e265 < 0f) {
                    phi_1172_ = -(_e265);
                } else {
                    phi_1172_ = _e265;
                }
                let _e374 = phi_1172_;
                if (_e370 > _e374) {
                    phi_1177_ = _e370;
                } else {
                    phi_1177_ = _e374;
                }
                let _e377 = phi_1177_;
                if (_e266 < 0f) {
                    phi_1183_ = -(_e266);
                } else {
                    phi_1183_ = _e266;
                }
                let _e381 = phi_1183_;
                if (_e377 > _e381) {
                    phi_1188_ = _e377;
                } else {
                    phi_1188_ = _e381;
                }
                let _e384 = phi_1188_;
                if (_e268 < 0f) {
                    phi_1194_ = -(_e268);
                } else {
                    phi_1194_ = _e268;
                }
                let _e388 = phi_1194_;
                if (_e269 < 0f) {
                    phi_1200_ = -(_e269);
                } else {
                    phi_1200_ = _e269;
                }
                let _e392 = phi_1200_;
                if (_e388 > _e392) {
                    phi_1205_ = _e388;
                } else {
                    phi_1205_ = _e392;
                }
                let _e395 = phi_1205_;
                if (_e270 < 0f) {
                    phi_1211_ = -(_e270);
                } else {
                    phi_1211_ = _e270;
                }
                let _e399 = phi_1211_;
                if (_e395 > _e399) {
                    phi_1216_ = _e395;
                } else {
                    phi_1216_ = _e399;
                }
                let _e402 = phi_1216_;
                if (_e384 > _e402) {
                    phi_1221_ = _e384;
                } else {
                    phi_1221_ = _e402;
                }
                let _e405 = phi_1221_;
                let _e406 = (_e405 + _e273);
                if (_e326 > _e366) {
                    phi_1227_ = _e326;
                } else {
                    phi_1227_ = _e366;
                }
                let _e409 = phi_1227_;
                if (_e409 > _e406) {
                    phi_1232_ = _e409;
                } else {
                    phi_1232_ = _e406;
                }
                let _e412 = phi_1232_;
                if (_e412 <= 65536f) {
                    phi_1239_ = (_e412 >= (1f / 65536f));
                } else {
                    phi_1239_ = false;
                }
                let _e417 = phi_1239_;
                if _e417 {
                    phi_1310_ = type_38();
                    phi_1311_ = true;
                } else {
                    if (_e412 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e412) & 2139095040u) != 2139095040u) {
                            let _e424 = (2130706432u - (bitcast<u32>(_e412) & 2139095040u));
                            if (_e424 > 8388608u) {
                                phi_1263_ = _e424;
                            } else {
                                phi_1263_ = 8388608u;
                            }
                            let _e427 = phi_1263_;
                            let _e428 = bitcast<f32>(_e427);
                            let _e429 = (_e276 * _e428);
                            if (_e276 > 0f) {
                                if (_e429 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_1274_ = _e429;
                                } else {
                                    phi_1274_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e433 = phi_1274_;
                                phi_1275_ = _e433;
                            } else {
                                phi_1275_ = _e429;
                            }
                            let _e435 = phi_1275_;
                            phi_1306_ = type_38(type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e246 * _e428), (_e247 * _e428), (_e248 * _e428)), array<f32, 3>((_e250 * _e428), (_e251 * _e428), (_e252 * _e428))), array<array<f32, 3>, 2>(array<f32, 3>((_e255 * _e428), (_e256 * _e428), (_e257 * _e428)), array<f32, 3>((_e259 * _e428), (_e260 * _e428), (_e261 * _e428))), array<array<f32, 3>, 2>(array<f32, 3>((_e264 * _e428), (_e265 * _e428), (_e266 * _e428)), array<f32, 3>((_e268 * _e428), (_e269 * _e428), (_e270 * _e428))), (_e273 * _e428)), _e435);
                            phi_1307_ = false;
                        } else {
                            phi_1306_ = type_38();
                            phi_1307_ = true;
                        }
                        let _e467 = phi_1306_;
                        let _e469 = phi_1307_;
                        phi_1308_ = _e467;
                        phi_1309_ = _e469;
                    } else {
                        phi_1308_ = type_38();
                        phi_1309_ = true;
                    }
                    let _e471 = phi_1308_;
                    let _e473 = phi_1309_;
                    phi_1310_ = _e471;
                    phi_1311_ = _e473;
                }
                let _e475 = phi_1310_;
                let _e477 = phi_1311_;
                if _e477 {
                    phi_1316_ = type_38(type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e246, _e247, _e248), array<f32, 3>(_e250, _e251, _e252)), array<array<f32, 3>, 2>(array<f32, 3>(_e255, _e256, _e257), array<f32, 3>(_e259, _e260, _e261)), array<array<f32, 3>, 2>(array<f32, 3>(_e264, _e265, _e266), array<f32, 3>(_e268, _e269, _e270)), _e273), _e276);
                } else {
                    phi_1316_ = _e475;
                }
                let _e480 = phi_1316_;
                local_18 = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e480.member.member[0][0], _e480.member.member[0][1], _e480.member.member[0][2]), array<f32, 3>(_e480.member.member[1][0], _e480.member.member[1][1], _e480.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e480.member.member_1[0][0], _e480.member.member_1[0][1], _e480.member.member_1[0][2]), array<f32, 3>(_e480.member.member_1[1][0], _e480.member.member_1[1][1], _e480.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e480.member.member_2[0][0], _e480.member.member_2[0][1], _e480.member.member_2[0][2]), array<f32, 3>(_e480.member.member_2[1][0], _e480.member.member_2[1][1], _e480.member.member_2[1][2])), _e480.member.member_3);
                if (_e480.member_1 > 0f) {
                    let _e5152 = local_18.member[0u];
                    let _e5158 = local_18.member[1u];
                    let _e5174 = local_18.member_1[0u];
                    let _e5180 = local_18.member_1[1u];
                    let _e5196 = local_18.member_2[0u];
                    let _e5202 = local_18.member_2[1u];
                    let _e5216 = function_2(array<f32, 3>((_e5152[0] + ((_e5158[0] - _e5152[0]) * _e280)), (_e5152[1] + ((_e5158[1] - _e5152[1]) * _e280)), (_e5152[2] + ((_e5158[2] - _e5152[2]) * _e280))), array<f32, 3>((_e5174[0] + ((_e5180[0] - _e5174[0]) * _e280)), (_e5174[1] + ((_e5180[1] - _e5174[1]) * _e280)), (_e5174[2] + ((_e5180[2] - _e5174[2]) * _e280))), array<f32, 3>((_e5196[0] + ((_e5202[0] - _e5196[0]) * _e280)), (_e5196[1] + ((_e5202[1] - _e5196[1]) * _e280)), (_e5196[2] + ((_e5202[2] - _e5196[2]) * _e280))), 0u);
                    let _e5227 = (((_e5216[0] * _e5216[0]) + (_e5216[1] * _e5216[1])) + (_e5216[2] * _e5216[2]));
                    if (_e5227 <= 0.000000000000000000000000000000000000011754944f) {
                        if (_e5227 > 0f) {
                            phi_1483_ = (0.000000000000000000106433627f * 2f);
                        } else {
                            phi_1483_ = 0f;
                        }
                        let _e5280 = phi_1483_;
                        phi_1547_ = _e5280;
                    } else {
                        phi_1490_ = type_14(0i, 5i);
                        phi_1493_ = bitcast<f32>(((bitcast<u32>(_e5227) >> bitcast<u32>(1i)) + 532369198u));
                        loop {
                            let _e5235 = phi_1490_;
                            let _e5237 = phi_1493_;
                            local_39 = _e5237;
                            if (_e5235.member < _e5235.member_1) {
                                let _e5244 = (_e5235.member + 1i);
                                if ((false == (_e5244 > _e5235.member)) != false) {
                                    phi_1514_ = true;
                                } else {
                                    phi_1514_ = false;
                                }
                                let _e5249 = phi_1514_;
                                if _e5249 {
                                    phi_1520_ = type_15(0u, type_15().member_1);
                                } else {
                                    phi_1520_ = type_15(1u, _e5244);
                                }
                                let _e5254 = phi_1520_;
                                phi_1491_ = type_14(_e5254.member_1, _e5235.member_1);
                                phi_1534_ = type_15(1u, _e5235.member);
                            } else {
                                phi_1491_ = _e5235;
                                phi_1534_ = type_15(0u, type_15().member_1);
                            }
                            let _e5260 = phi_1491_;
                            let _e5262 = phi_1534_;
                            let _e5265 = (bitcast<i32>(_e5262.member) != 0i);
                            if _e5265 {
                                phi_1494_ = (0.5f * (_e5237 + (_e5227 / _e5237)));
                            } else {
                                phi_1494_ = f32();
                            }
                            let _e5270 = phi_1494_;
                            continue;
                            continuing {
                                phi_1490_ = _e5260;
                                phi_1493_ = _e5270;
                                break if !(_e5265);
                            }
                        }
                        let _e5275 = local_39;
                        phi_1547_ = (_e5275 * (1f + (8f * 0.000000059604645f)));
                    }
                    let _e5282 = phi_1547_;
                    let _e5288 = local_18.member[0u];
                    if (_e5288[0] < 0f) {
                        phi_1563_ = -(_e5288[0]);
                    } else {
                        phi_1563_ = _e5288[0];
                    }
                    let _e5295 = phi_1563_;
                    if (_e5288[1] < 0f) {
                        phi_1570_ = -(_e5288[1]);
                    } else {
                        phi_1570_ = _e5288[1];
                    }
                    let _e5299 = phi_1570_;
                    if (_e5295 > _e5299) {
                        phi_1575_ = _e5295;
                    } else {
                        phi_1575_ = _e5299;
                    }
                    let _e5302 = phi_1575_;
                    if (_e5288[2] < 0f) {
                        phi_1582_ = -(_e5288[2]);
                    } else {
                        phi_1582_ = _e5288[2];
                    }
                    let _e5306 = phi_1582_;
                    if (_e5302 > _e5306) {
                        phi_1587_ = _e5302;
                    } else {
                        phi_1587_ = _e5306;
                    }
                    let _e5309 = phi_1587_;
                    let _e5312 = local_18.member[1u];
                    if (_e5312[0] < 0f) {
                        phi_1600_ = -(_e5312[0]);
                    } else {
                        phi_1600_ = _e5312[0];
                    }
                    let _e5319 = phi_1600_;
                    if (_e5312[1] < 0f) {
                        phi_1607_ = -(_e5312[1]);
                    } else {
                        phi_1607_ = _e5312[1];
                    }
                    let _e5323 = phi_1607_;
                    if (_e5319 > _e5323) {
                        phi_1612_ = _e5319;
                    } else {
                        phi_1612_ = _e5323;
                    }
                    let _e5326 = phi_1612_;
                    if (_e5312[2] < 0f) {
                        phi_1619_ = -(_e5312[2]);
                    } else {
                        phi_1619_ = _e5312[2];
                    }
                    let _e5330 = phi_1619_;
                    if (_e5326 > _e5330) {
                        phi_1624_ = _e5326;
                    } else {
                        phi_1624_ = _e5330;
                    }
                    let _e5333 = phi_1624_;
                    if (_e5309 > _e5333) {
                        phi_1629_ = _e5309;
                    } else {
                        phi_1629_ = _e5333;
                    }
                    let _e5336 = phi_1629_;
                    let _e5338 = local_18.member_3;
                    let _e5342 = local_18.member_1[0u];
                    if (_e5342[0] < 0f) {
                        phi_1646_ = -(_e5342[0]);
                    } else {
                        phi_1646_ = _e5342[0];
                    }
                    let _e5349 = phi_1646_;
                    if (_e5342[1] < 0f) {
                        phi_1653_ = -(_e5342[1]);
                    } else {
                        phi_1653_ = _e5342[1];
                    }
                    let _e5353 = phi_1653_;
                    if (_e5349 > _e5353) {
                        phi_1658_ = _e5349;
                    } else {
                        phi_1658_ = _e5353;
                    }
                    let _e5356 = phi_1658_;
                    if (_e5342[2] < 0f) {
                        phi_1665_ = -(_e5342[2]);
                    } else {
                        phi_1665_ = _e5342[2];
                    }
                    let _e5360 = phi_1665_;
                    if (_e5356 > _e5360) {
                        phi_1670_ = _e5356;
                    } else {
                        phi_1670_ = _e5360;
                    }
                    let _e5363 = phi_1670_;
                    let _e5366 = local_18.member_1[1u];
                    if (_e5366[0] < 0f) {
                        phi_1684_ = -(_e5366[0]);
                    } else {
                        phi_1684_ = _e5366[0];
                    }
                    let _e5373 = phi_1684_;
                    if (_e5366[1] < 0f) {
                        phi_1691_ = -(_e5366[1]);
                    } else {
                        phi_1691_ = _e5366[1];
                    }
                    let _e5377 = phi_1691_;
                    if (_e5373 > _e5377) {
                        phi_1696_ = _e5373;
                    } else {
                        phi_1696_ = _e5377;
                    }
                    let _e5380 = phi_1696_;
                    if (_e5366[2] < 0f) {
                        phi_1703_ = -(_e5366[2]);
                    } else {
                        phi_1703_ = _e5366[2];
                    }
                    let _e5384 = phi_1703_;
                    if (_e5380 > _e5384) {
                        phi_1708_ = _e5380;
                    } else {
                        phi_1708_ = _e5384;
                    }
                    let _e5387 = phi_1708_;
                    if (_e5363 > _e5387) {
                        phi_1713_ = _e5363;
                    } else {
                        phi_1713_ = _e5387;
                    }
                    let _e5390 = phi_1713_;
                    let _e5392 = local_18.member_3;
                    let _e5396 = local_18.member_2[0u];
                    if (_e5396[0] < 0f) {
                        phi_1730_ = -(_e5396[0]);
                    } else {
                        phi_1730_ = _e5396[0];
                    }
                    let _e5403 = phi_1730_;
                    if (_e5396[1] < 0f) {
                        phi_1737_ = -(_e5396[1]);
                    } else {
                        phi_1737_ = _e5396[1];
                    }
                    let _e5407 = phi_1737_;
                    if (_e5403 > _e5407) {
                        phi_1742_ = _e5403;
                    } else {
                        phi_1742_ = _e5407;
                    }
                    let _e5410 = phi_1742_;
                    if (_e5396[2] < 0f) {
                        phi_1749_ = -(_e5396[2]);
                    } else {
                        phi_1749_ = _e5396[2];
                    }
                    let _e5414 = phi_1749_;
                    if (_e5410 > _e5414) {
                        phi_1754_ = _e5410;
                    } else {
                        phi_1754_ = _e5414;
                    }
                    let _e5417 = phi_1754_;
                    let _e5420 = local_18.member_2[1u];
                    if (_e5420[0] < 0f) {
                        phi_1768_ = -(_e5420[0]);
                    } else {
                        phi_1768_ = _e5420[0];
                    }
                    let _e5427 = phi_1768_;
                    if (_e5420[1] < 0f) {
                        phi_1775_ = -(_e5420[1]);
                    } else {
                        phi_1775_ = _e5420[1];
                    }
                    let _e5431 = phi_1775_;
                    if (_e5427 > _e5431) {
                        phi_1780_ = _e5427;
                    } else {
                        phi_1780_ = _e5431;
                    }
                    let _e5434 = phi_1780_;
                    if (_e5420[2] < 0f) {
                        phi_1787_ = -(_e5420[2]);
                    } else {
                        phi_1787_ = _e5420[2];
                    }
                    let _e5438 = phi_1787_;
                    if (_e5434 > _e5438) {
                        phi_1792_ = _e5434;
                    } else {
                        phi_1792_ = _e5438;
                    }
                    let _e5441 = phi_1792_;
                    if (_e5417 > _e5441) {
                        phi_1797_ = _e5417;
                    } else {
                        phi_1797_ = _e5441;
                    }
                    let _e5444 = phi_1797_;
                    let _e5446 = local_18.member_3;
                    let _e5453 = local_18.member_3;
                    let _e5460 = (((_e5282 * (1f + (0.000000059604645f * 8f))) + (((((((_e5336 + _e5338) + (_e5390 + _e5392)) + (_e5444 + _e5446)) * (0.000000059604645f * 16f)) + (_e5453 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e480.member_1);
                    if _e5460 {
                        phi_2458_ = type_39();
                        phi_2459_ = true;
                    } else {
                        let _e5463 = local_18.member_1[0u];
                        let _e5469 = local_18.member_2[0u];
                        let _e5475 = ((_e5463[1] * _e5469[2]) - (_e5463[2] * _e5469[1]));
                        let _e5478 = ((_e5463[2] * _e5469[0]) - (_e5463[0] * _e5469[2]));
                        let _e5481 = ((_e5463[0] * _e5469[1]) - (_e5463[1] * _e5469[0]));
                        let _e5484 = local_18.member_1[1u];
                        let _e5490 = local_18.member_2[1u];
                        let _e5496 = ((_e5484[1] * _e5490[2]) - (_e5484[2] * _e5490[1]));
                        let _e5499 = ((_e5484[2] * _e5490[0]) - (_e5484[0] * _e5490[2]));
                        let _e5502 = ((_e5484[0] * _e5490[1]) - (_e5484[1] * _e5490[0]));
                        let _e5505 = local_18.member_1[0u];
                        let _e5511 = local_18.member_2[1u];
                        let _e5526 = local_18.member_1[1u];
                        let _e5532 = local_18.member_2[0u];
                        let _e5545 = (((_e5505[1] * _e5511[2]) - (_e5505[2] * _e5511[1])) + ((_e5526[1] * _e5532[2]) - (_e5526[2] * _e5532[1])));
                        let _e5546 = (((_e5505[2] * _e5511[0]) - (_e5505[0] * _e5511[2])) + ((_e5526[2] * _e5532[0]) - (_e5526[0] * _e5532[2])));
                        let _e5547 = (((_e5505[0] * _e5511[1]) - (_e5505[1] * _e5511[0])) + ((_e5526[0] * _e5532[1]) - (_e5526[1] * _e5532[0])));
                        let _e5550 = local_18.member[0u];
                        let _e5561 = local_18.member[1u];
                        let _e5572 = local_18.member[0u];
                        let _e5581 = ((((_e5561[0] * _e5475) + (_e5561[1] * _e5478)) + (_e5561[2] * _e5481)) + (((_e5572[0] * _e5545) + (_e5572[1] * _e5546)) + (_e5572[2] * _e5547)));
                        let _e5584 = local_18.member[0u];
                        let _e5595 = local_18.member[1u];
                        let _e5604 = ((((_e5584[0] * _e5496) + (_e5584[1] * _e5499)) + (_e5584[2] * _e5502)) + (((_e5595[0] * _e5545) + (_e5595[1] * _e5546)) + (_e5595[2] * _e5547)));
                        let _e5607 = local_18.member[1u];
                        let _e5618 = local_18.member[0u];
                        if (_e5618[0] < 0f) {
                            phi_2058_ = -(_e5618[0]);
                        } else {
                            phi_2058_ = _e5618[0];
                        }
                        let _e5625 = phi_2058_;
                        if (_e5618[1] < 0f) {
                            phi_2065_ = -(_e5618[1]);
                        } else {
                            phi_2065_ = _e5618[1];
                        }
                        let _e5629 = phi_2065_;
                        if (_e5625 > _e5629) {
                            phi_2070_ = _e5625;
                        } else {
                            phi_2070_ = _e5629;
                        }
                        let _e5632 = phi_2070_;
                        if (_e5618[2] < 0f) {
                            phi_2077_ = -(_e5618[2]);
                        } else {
                            phi_2077_ = _e5618[2];
                        }
                        let _e5636 = phi_2077_;
                        if (_e5632 > _e5636) {
                            phi_2082_ = _e5632;
                        } else {
                            phi_2082_ = _e5636;
                        }
                        let _e5639 = phi_2082_;
                        let _e5642 = local_18.member[1u];
                        if (_e5642[0] < 0f) {
                            phi_2095_ = -(_e5642[0]);
                        } else {
                            phi_2095_ = _e5642[0];
                        }
                        let _e5649 = phi_2095_;
                        if (_e5642[1] < 0f) {
                            phi_2102_ = -(_e5642[1]);
                        } else {
                            phi_2102_ = _e5642[1];
                        }
                        let _e5653 = phi_2102_;
                        if (_e5649 > _e5653) {
                            phi_2107_ = _e5649;
                        } else {
                            phi_2107_ = _e5653;
                        }
                        let _e5656 = phi_2107_;
                        if (_e5642[2] < 0f) {
                            phi_2114_ = -(_e5642[2]);
                        } else {
                            phi_2114_ = _e5642[2];
                        }
                        let _e5660 = phi_2114_;
                        if (_e5656 > _e5660) {
                            phi_2119_ = _e5656;
                        } else {
                            phi_2119_ = _e5660;
                        }
                        let _e5663 = phi_2119_;
                        if (_e5639 > _e5663) {
                            phi_2124_ = _e5639;
                        } else {
                            phi_2124_ = _e5663;
                        }
                        let _e5666 = phi_2124_;
                        let _e5668 = local_18.member_3;
                        let _e5669 = (_e5666 + _e5668);
                        let _e5672 = local_18.member_1[0u];
                        if (_e5672[0] < 0f) {
                            phi_2141_ = -(_e5672[0]);
                        } else {
                            phi_2141_ = _e5672[0];
                        }
                        let _e5679 = phi_2141_;
                        if (_e5672[1] < 0f) {
                            phi_2148_ = -(_e5672[1]);
                        } else {
                            phi_2148_ = _e5672[1];
                        }
                        let _e5683 = phi_2148_;
                        if (_e5679 > _e5683) {
                            phi_2153_ = _e5679;
                        } else {
                            phi_2153_ = _e5683;
                        }
                        let _e5686 = phi_2153_;
                        if (_e5672[2] < 0f) {
                            phi_2160_ = -(_e5672[2]);
                        } else {
                            phi_2160_ = _e5672[2];
                        }
                        let _e5690 = phi_2160_;
                        if (_e5686 > _e5690) {
                            phi_2165_ = _e5686;
                        } else {
                            phi_2165_ = _e5690;
                        }
                        let _e5693 = phi_2165_;
                        let _e5696 = local_18.member_1[1u];
                        if (_e5696[0] < 0f) {
                            phi_2179_ = -(_e5696[0]);
                        } else {
                            phi_2179_ = _e5696[0];
                        }
                        let _e5703 = phi_2179_;
                        if (_e5696[1] < 0f) {
                            phi_2186_ = -(_e5696[1]);
                        } else {
                            phi_2186_ = _e5696[1];
                        }
                        let _e5707 = phi_2186_;
                        if (_e5703 > _e5707) {
                            phi_2191_ = _e5703;
                        } else {
                            phi_2191_ = _e5707;
                        }
                        let _e5710 = phi_2191_;
                        if (_e5696[2] < 0f) {
                            phi_2198_ = -(_e5696[2]);
                        } else {
                            phi_2198_ = _e5696[2];
                        }
                        let _e5714 = phi_2198_;
                        if (_e5710 > _e5714) {
                            phi_2203_ = _e5710;
                        } else {
                            phi_2203_ = _e5714;
                        }
                        let _e5717 = phi_2203_;
                        if (_e5693 > _e5717) {
                            phi_2208_ = _e5693;
                        } else {
                            phi_2208_ = _e5717;
                        }
                        let _e5720 = phi_2208_;
                        let _e5722 = local_18.member_3;
                        let _e5723 = (_e5720 + _e5722);
                        let _e5726 = local_18.member_2[0u];
                        if (_e5726[0] < 0f) {
                            phi_2225_ = -(_e5726[0]);
                        } else {
                            phi_2225_ = _e5726[0];
                        }
                        let _e5733 = phi_2225_;
                        if (_e5726[1] < 0f) {
                            phi_2232_ = -(_e5726[1]);
                        } else {
                            phi_2232_ = _e5726[1];
                        }
                        let _e5737 = phi_2232_;
                        if (_e5733 > _e5737) {
                            phi_2237_ = _e5733;
                        } else {
                            phi_2237_ = _e5737;
                        }
                        let _e5740 = phi_2237_;
                        if (_e5726[2] < 0f) {
                            phi_2244_ = -(_e5726[2]);
                        } else {
                            phi_2244_ = _e5726[2];
                        }
                        let _e5744 = phi_2244_;
                        if (_e5740 > _e5744) {
                            phi_2249_ = _e5740;
                        } else {
                            phi_2249_ = _e5744;
                        }
                        let _e5747 = phi_2249_;
                        let _e5750 = local_18.member_2[1u];
                        if (_e5750[0] < 0f) {
                            phi_2263_ = -(_e5750[0]);
                        } else {
                            phi_2263_ = _e5750[0];
                        }
                        let _e5757 = phi_2263_;
                        if (_e5750[1] < 0f) {
                            phi_2270_ = -(_e5750[1]);
                        } else {
                            phi_2270_ = _e5750[1];
                        }
                        let _e5761 = phi_2270_;
                        if (_e5757 > _e5761) {
                            phi_2275_ = _e5757;
                        } else {
                            phi_2275_ = _e5761;
                        }
                        let _e5764 = phi_2275_;
                        if (_e5750[2] < 0f) {
                            phi_2282_ = -(_e5750[2]);
                        } else {
                            phi_2282_ = _e5750[2];
                        }
                        let _e5768 = phi_2282_;
                        if (_e5764 > _e5768) {
                            phi_2287_ = _e5764;
                        } else {
                            phi_2287_ = _e5768;
                        }
                        let _e5771 = phi_2287_;
                        if (_e5747 > _e5771) {
                            phi_2292_ = _e5747;
                        } else {
                            phi_2292_ = _e5771;
                        }
                        let _e5774 = phi_2292_;
                        let _e5776 = local_18.member_3;
                        let _e5777 = (_e5774 + _e5776);
                        let _e5779 = ((_e5723 * 8f) * _e5777);
                        let _e5786 = local_18.member_3;
                        if (_e5475 < 0f) {
                            phi_2323_ = -(_e5475);
                        } else {
                            phi_2323_ = _e5475;
                        }
                        let _e5803 = phi_2323_;
                        if (_e5478 < 0f) {
                            phi_2329_ = -(_e5478);
                        } else {
                            phi_2329_ = _e5478;
                        }
                        let _e5807 = phi_2329_;
                        if (_e5481 < 0f) {
                            phi_2336_ = -(_e5481);
                        } else {
                            phi_2336_ = _e5481;
                        }
                        let _e5812 = phi_2336_;
                        let _e5813 = ((_e5803 + _e5807) + _e5812);
                        if (_e5496 < 0f) {
                            phi_2343_ = -(_e5496);
                        } else {
                            phi_2343_ = _e5496;
                        }
                        let _e5817 = phi_2343_;
                        if (_e5499 < 0f) {
                            phi_2349_ = -(_e5499);
                        } else {
                            phi_2349_ = _e5499;
                        }
                        let _e5821 = phi_2349_;
                        if (_e5502 < 0f) {
                            phi_2356_ = -(_e5502);
                        } else {
                            phi_2356_ = _e5502;
                        }
                        let _e5826 = phi_2356_;
                        let _e5827 = ((_e5817 + _e5821) + _e5826);
                        if (_e5813 > _e5827) {
                            phi_2362_ = _e5813;
                        } else {
                            phi_2362_ = _e5827;
                        }
                        let _e5830 = phi_2362_;
                        if (_e5545 < 0f) {
                            phi_2368_ = -(_e5545);
                        } else {
                            phi_2368_ = _e5545;
                        }
                        let _e5834 = phi_2368_;
                        if (_e5546 < 0f) {
                            phi_2374_ = -(_e5546);
                        } else {
                            phi_2374_ = _e5546;
                        }
                        let _e5838 = phi_2374_;
                        if (_e5547 < 0f) {
                            phi_2381_ = -(_e5547);
                        } else {
                            phi_2381_ = _e5547;
                        }
                        let _e5843 = phi_2381_;
                        let _e5845 = (((_e5834 + _e5838) + _e5843) * 0.5f);
                        if (_e5830 > _e5845) {
                            phi_2388_ = _e5830;
                        } else {
                            phi_2388_ = _e5845;
                        }
                        let _e5848 = phi_2388_;
                        let _e5853 = local_18.member_3;
                        let _e5866 = ((((_e5550[0] * _e5475) + (_e5550[1] * _e5478)) + (_e5550[2] * _e5481)) * 3f);
                        let _e5867 = ((((_e5607[0] * _e5496) + (_e5607[1] * _e5499)) + (_e5607[2] * _e5502)) * 3f);
                        if (_e5866 < _e5867) {
                            phi_2412_ = _e5866;
                        } else {
                            phi_2412_ = _e5867;
                        }
                        let _e5870 = phi_2412_;
                        if (_e5581 < _e5604) {
                            phi_2417_ = _e5581;
                        } else {
                            phi_2417_ = _e5604;
                        }
                        let _e5873 = phi_2417_;
                        if (_e5870 < _e5873) {
                            phi_2422_ = _e5870;
                        } else {
                            phi_2422_ = _e5873;
                        }
                        let _e5876 = phi_2422_;
                        if (_e5866 > _e5867) {
                            phi_2427_ = _e5866;
                        } else {
                            phi_2427_ = _e5867;
                        }
                        let _e5879 = phi_2427_;
                        if (_e5581 > _e5604) {
                            phi_2432_ = _e5581;
                        } else {
                            phi_2432_ = _e5604;
                        }
                        let _e5882 = phi_2432_;
                        if (_e5879 > _e5882) {
                            phi_2437_ = _e5879;
                        } else {
                            phi_2437_ = _e5882;
                        }
                        let _e5885 = phi_2437_;
                        let _e5890 = -(_e5885);
                        if (_e5876 > _e5890) {
                            phi_2447_ = _e5876;
                        } else {
                            phi_2447_ = _e5890;
                        }
                        let _e5893 = phi_2447_;
                        if ((_e5893 - ((((((_e5669 * 8f) * _e5779) * (0.000000059604645f * (524f / 64f))) + ((_e5786 * 19f) * ((_e5669 * (_e5723 + _e5777)) + (_e5723 * _e5777)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5669) * ((1f + _e5723) * (1f + _e5777))))) + ((_e480.member_1 * (((_e5848 + (_e5779 * (0.000000059604645f * 8f))) + ((_e5853 * 6f) * (_e5723 + _e5777))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5723) * (1f + _e5777))))) * (3f * 1.0001f)))) > 0f) {
                            phi_2456_ = type_39(type_28(0u, f32()), 0u);
                            phi_2457_ = false;
                        } else {
                            phi_2456_ = type_39();
                            phi_2457_ = true;
                        }
                        let _e5899 = phi_2456_;
                        let _e5901 = phi_2457_;
                        phi_2458_ = _e5899;
                        phi_2459_ = _e5901;
                    }
                    let _e5903 = phi_2458_;
                    let _e5905 = phi_2459_;
                    if _e5905 {
                        phi_2465_ = type_14(0i, 2i);
                        phi_2468_ = _e280;
                        phi_2470_ = 0u;
                        phi_2472_ = _e280;
                        loop {
                            let _e5907 = phi_2465_;
                            let _e5909 = phi_2468_;
                            let _e5911 = phi_2470_;
                            let _e5913 = phi_2472_;
                            local_96 = _e5911;
                            local_99 = _e5909;
                            local_100 = _e5911;
                            if (_e5907.member < _e5907.member_1) {
                                let _e5920 = (_e5907.member + 1i);
                                if ((false == (_e5920 > _e5907.member)) != false) {
                                    phi_2493_ = true;
                                } else {
                                    phi_2493_ = false;
                                }
                                let _e5925 = phi_2493_;
                                if _e5925 {
                                    phi_2499_ = type_15(0u, type_15().member_1);
                                } else {
                                    phi_2499_ = type_15(1u, _e5920);
                                }
                                let _e5930 = phi_2499_;
                                phi_2466_ = type_14(_e5930.member_1, _e5907.member_1);
                                phi_2513_ = type_15(1u, _e5907.member);
                            } else {
                                phi_2466_ = _e5907;
                                phi_2513_ = type_15(0u, type_15().member_1);
                            }
                            let _e5936 = phi_2466_;
                            let _e5938 = phi_2513_;
                            if (bitcast<i32>(_e5938.member) != 0i) {
                                if (_e5938.member_1 > 0i) {
                                    phi_2529_ = true;
                                } else {
                                    if _e5460 {
                                        phi_2528_ = false;
                                    } else {
                                        phi_2528_ = true;
                                    }
                                    let _e5945 = phi_2528_;
                                    phi_2529_ = _e5945;
                                }
                                let _e5947 = phi_2529_;
                                if _e5947 {
                                    let _e5950 = local_18.member[0u];
                                    let _e5956 = local_18.member_1[0u];
                                    let _e5962 = local_18.member_2[0u];
                                    let _e5974 = local_18.member[1u];
                                    let _e5980 = local_18.member_1[1u];
                                    let _e5986 = local_18.member_2[1u];
                                    let _e5998 = local_18.member[0u];
                                    if (_e5998[0] < 0f) {
                                        phi_2675_ = -(_e5998[0]);
                                    } else {
                                        phi_2675_ = _e5998[0];
                                    }
                                    let _e6005 = phi_2675_;
                                    if (_e5998[1] < 0f) {
                                        phi_2682_ = -(_e5998[1]);
                                    } else {
                                        phi_2682_ = _e5998[1];
                                    }
                                    let _e6009 = phi_2682_;
                                    if (_e6005 > _e6009) {
                                        phi_2687_ = _e6005;
                                    } else {
                                        phi_2687_ = _e6009;
                                    }
                                    let _e6012 = phi_2687_;
                                    if (_e5998[2] < 0f) {
                                        phi_2694_ = -(_e5998[2]);
                                    } else {
                                        phi_2694_ = _e5998[2];
                                    }
                                    let _e6016 = phi_2694_;
                                    if (_e6012 > _e6016) {
                                        phi_2699_ = _e6012;
                                    } else {
                                        phi_2699_ = _e6016;
                                    }
                                    let _e6019 = phi_2699_;
                                    let _e6022 = local_18.member[1u];
                                    if (_e6022[0] < 0f) {
                                        phi_2712_ = -(_e6022[0]);
                                    } else {
                                        phi_2712_ = _e6022[0];
                                    }
                                    let _e6029 = phi_2712_;
                                    if (_e6022[1] < 0f) {
                                        phi_2719_ = -(_e6022[1]);
                                    } else {
                                        phi_2719_ = _e6022[1];
                                    }
                                    let _e6033 = phi_2719_;
                                    if (_e6029 > _e6033) {
                                        phi_2724_ = _e6029;
                                    } else {
                                        phi_2724_ = _e6033;
                                    }
                                    let _e6036 = phi_2724_;
                                    if (_e6022[2] < 0f) {
                                        phi_2731_ = -(_e6022[2]);
                                    } else {
                                        phi_2731_ = _e6022[2];
                                    }
                                    let _e6040 = phi_2731_;
                                    if (_e6036 > _e6040) {
                                        phi_2736_ = _e6036;
                                    } else {
                                        phi_2736_ = _e6040;
                                    }
                                    let _e6043 = phi_2736_;
                                    if (_e6019 > _e6043) {
                                        phi_2741_ = _e6019;
                                    } else {
                                        phi_2741_ = _e6043;
                                    }
                                    let _e6046 = phi_2741_;
                                    let _e6048 = local_18.member_3;
                                    let _e6052 = local_18.member_1[0u];
                                    if (_e6052[0] < 0f) {
                                        phi_2758_ = -(_e6052[0]);
                                    } else {
                                        phi_2758_ = _e6052[0];
                                    }
                                    let _e6059 = phi_2758_;
                                    if (_e6052[1] < 0f) {
                                        phi_2765_ = -(_e6052[1]);
                                    } else {
                                        phi_2765_ = _e6052[1];
                                    }
                                    let _e6063 = phi_2765_;
                                    if (_e6059 > _e6063) {
                                        phi_2770_ = _e6059;
                                    } else {
                                        phi_2770_ = _e6063;
                                    }
                                    let _e6066 = phi_2770_;
                                    if (_e6052[2] < 0f) {
                                        phi_2777_ = -(_e6052[2]);
                                    } else {
                                        phi_2777_ = _e6052[2];
                                    }
                                    let _e6070 = phi_2777_;
                                    if (_e6066 > _e6070) {
                                        phi_2782_ = _e6066;
                                    } else {
                                        phi_2782_ = _e6070;
                                    }
                                    let _e6073 = phi_2782_;
                                    let _e6076 = local_18.member_1[1u];
                                    if (_e6076[0] < 0f) {
                                        phi_2796_ = -(_e6076[0]);
                                    } else {
                                        phi_2796_ = _e6076[0];
                                    }
                                    let _e6083 = phi_2796_;
                                    if (_e6076[1] < 0f) {
                                        phi_2803_ = -(_e6076[1]);
                                    } else {
                                        phi_2803_ = _e6076[1];
                                    }
                                    let _e6087 = phi_2803_;
                                    if (_e6083 > _e6087) {
                                        phi_2808_ = _e6083;
                                    } else {
                                        phi_2808_ = _e6087;
                                    }
                                    let _e6090 = phi_2808_;
                                    if (_e6076[2] < 0f) {
                                        phi_2815_ = -(_e6076[2]);
                                    } else {
                                        phi_2815_ = _e6076[2];
                                    }
                                    let _e6094 = phi_2815_;
                                    if (_e6090 > _e6094) {
                                        phi_2820_ = _e6090;
                                    } else {
                                        phi_2820_ = _e6094;
                                    }
                                    let _e6097 = phi_2820_;
                                    if (_e6073 > _e6097) {
                                        phi_2825_ = _e6073;
                                    } else {
                                        phi_2825_ = _e6097;
                                    }
                                    let _e6100 = phi_2825_;
                                    let _e6102 = local_18.member_3;
                                    let _e6106 = local_18.member_2[0u];
                                    if (_e6106[0] < 0f) {
                                        phi_2842_ = -(_e6106[0]);
                                    } else {
                                        phi_2842_ = _e6106[0];
                                    }
                                    let _e6113 = phi_2842_;
                                    if (_e6106[1] < 0f) {
                                        phi_2849_ = -(_e6106[1]);
                                    } else {
                                        phi_2849_ = _e6106[1];
                                    }
                                    let _e6117 = phi_2849_;
                                    if (_e6113 > _e6117) {
                                        phi_2854_ = _e6113;
                                    } else {
                                        phi_2854_ = _e6117;
                                    }
                                    let _e6120 = phi_2854_;
                                    if (_e6106[2] < 0f) {
                                        phi_2861_ = -(_e6106[2]);
                                    } else {
                                        phi_2861_ = _e6106[2];
                                    }
                                    let _e6124 = phi_2861_;
                                    if (_e6120 > _e6124) {
                                        phi_2866_ = _e6120;
                                    } else {
                                        phi_2866_ = _e6124;
                                    }
                                    let _e6127 = phi_2866_;
                                    let _e6130 = local_18.member_2[1u];
                                    if (_e6130[0] < 0f) {
                                        phi_2880_ = -(_e6130[0]);
                                    } else {
                                        phi_2880_ = _e6130[0];
                                    }
                                    let _e6137 = phi_2880_;
                                    if (_e6130[1] < 0f) {
                                        phi_2887_ = -(_e6130[1]);
                                    } else {
                                        phi_2887_ = _e6130[1];
                                    }
                                    let _e6141 = phi_2887_;
                                    if (_e6137 > _e6141) {
                                        phi_2892_ = _e6137;
                                    } else {
                                        phi_2892_ = _e6141;
                                    }
                                    let _e6144 = phi_2892_;
                                    if (_e6130[2] < 0f) {
                                        phi_2899_ = -(_e6130[2]);
                                    } else {
                                        phi_2899_ = _e6130[2];
                                    }
                                    let _e6148 = phi_2899_;
                                    if (_e6144 > _e6148) {
                                        phi_2904_ = _e6144;
                                    } else {
                                        phi_2904_ = _e6148;
                                    }
                                    let _e6151 = phi_2904_;
                                    if (_e6127 > _e6151) {
                                        phi_2909_ = _e6127;
                                    } else {
                                        phi_2909_ = _e6151;
                                    }
                                    let _e6154 = phi_2909_;
                                    let _e6156 = local_18.member_3;
                                    let _e6163 = local_18.member_3;
                                    let _e6168 = (_e278 * 0.00390625f);
                                    local_16 = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_2950_ = type_12(0u, 96u);
                                    phi_2953_ = _e5913;
                                    phi_2955_ = _e5913;
                                    phi_2957_ = (_e282 - _e5913);
                                    phi_2959_ = _e5913;
                                    phi_2961_ = false;
                                    phi_2963_ = 0u;
                                    loop {
                                        let _e6171 = phi_2950_;
                                        let _e6173 = phi_2953_;
                                        let _e6175 = phi_2955_;
                                        let _e6177 = phi_2957_;
                                        let _e6179 = phi_2959_;
                                        let _e6181 = phi_2961_;
                                        let _e6183 = phi_2963_;
                                        local_43 = _e6173;
                                        local_86 = _e6175;
                                        if (_e6171.member < _e6171.member_1) {
                                            phi_2951_ = type_12((_e6171.member + 1u), _e6171.member_1);
                                            phi_2986_ = type_12(1u, _e6171.member);
                                        } else {
                                            phi_2951_ = _e6171;
                                            phi_2986_ = type_12(0u, type_12().member_1);
                                        }
                                        let _e6195 = phi_2951_;
                                        let _e6197 = phi_2986_;
                                        if (bitcast<i32>(_e6197.member) != 0i) {
                                            let _e6203 = local_18.member[0u];
                                            let _e6209 = local_18.member[1u];
                                            let _e6225 = local_18.member_1[0u];
                                            let _e6231 = local_18.member_1[1u];
                                            let _e6247 = local_18.member_2[0u];
                                            let _e6253 = local_18.member_2[1u];
                                            let _e6267 = function_2(array<f32, 3>((_e6203[0] + ((_e6209[0] - _e6203[0]) * _e6173)), (_e6203[1] + ((_e6209[1] - _e6203[1]) * _e6173)), (_e6203[2] + ((_e6209[2] - _e6203[2]) * _e6173))), array<f32, 3>((_e6225[0] + ((_e6231[0] - _e6225[0]) * _e6173)), (_e6225[1] + ((_e6231[1] - _e6225[1]) * _e6173)), (_e6225[2] + ((_e6231[2] - _e6225[2]) * _e6173))), array<f32, 3>((_e6247[0] + ((_e6253[0] - _e6247[0]) * _e6173)), (_e6247[1] + ((_e6253[1] - _e6247[1]) * _e6173)), (_e6247[2] + ((_e6253[2] - _e6247[2]) * _e6173))), 0u);
                                            if (_e6183 == 0u) {
                                                phi_3114_ = _e6267;
                                            } else {
                                                if (_e6183 == 1u) {
                                                    phi_3100_ = _e6267[0];
                                                } else {
                                                    phi_3100_ = 0f;
                                                }
                                                let _e6272 = phi_3100_;
                                                if (_e6183 == 2u) {
                                                    phi_3106_ = _e6267[1];
                                                } else {
                                                    phi_3106_ = 0f;
                                                }
                                                let _e6276 = phi_3106_;
                                                if (_e6183 == 3u) {
                                                    phi_3112_ = _e6267[2];
                                                } else {
                                                    phi_3112_ = 0f;
                                                }
                                                let _e6280 = phi_3112_;
                                                phi_3114_ = array<f32, 3>(_e6272, _e6276, _e6280);
                                            }
                                            let _e6283 = phi_3114_;
                                            if (_e6283[0] < 0f) {
                                                phi_3121_ = -(_e6283[0]);
                                            } else {
                                                phi_3121_ = _e6283[0];
                                            }
                                            let _e6288 = phi_3121_;
                                            if (_e6283[1] < 0f) {
                                                phi_3128_ = -(_e6283[1]);
                                            } else {
                                                phi_3128_ = _e6283[1];
                                            }
                                            let _e6293 = phi_3128_;
                                            if (_e6283[2] < 0f) {
                                                phi_3136_ = -(_e6283[2]);
                                            } else {
                                                phi_3136_ = _e6283[2];
                                            }
                                            let _e6299 = phi_3136_;
                                            let _e6300 = ((_e6288 + _e6293) + _e6299);
                                            if (_e6300 > 0f) {
                                                if ((bitcast<u32>(_e6300) & 2139095040u) != 2139095040u) {
                                                    let _e6305 = (1f / _e6300);
                                                    let _e6307 = (_e6283[0] * _e6305);
                                                    let _e6309 = (_e6283[1] * _e6305);
                                                    let _e6311 = (_e6283[2] * _e6305);
                                                    let _e6316 = (((_e6307 * _e6307) + (_e6309 * _e6309)) + (_e6311 * _e6311));
                                                    if (_e6316 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e6316 > 0f) {
                                                            phi_3173_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_3173_ = 0f;
                                                        }
                                                        let _e6369 = phi_3173_;
                                                        phi_3237_ = _e6369;
                                                    } else {
                                                        phi_3180_ = type_14(0i, 5i);
                                                        phi_3183_ = bitcast<f32>(((bitcast<u32>(_e6316) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e6324 = phi_3180_;
                                                            let _e6326 = phi_3183_;
                                                            local_40 = _e6326;
                                                            if (_e6324.member < _e6324.member_1) {
                                                                let _e6333 = (_e6324.member + 1i);
                                                                if ((false == (_e6333 > _e6324.member)) != false) {
                                                                    phi_3204_ = true;
                                                                } else {
                                                                    phi_3204_ = false;
                                                                }
                                                                let _e6338 = phi_3204_;
                                                                if _e6338 {
                                                                    phi_3210_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_3210_ = type_15(1u, _e6333);
                                                                }
                                                                let _e6343 = phi_3210_;
                                                                phi_3181_ = type_14(_e6343.member_1, _e6324.member_1);
                                                                phi_3224_ = type_15(1u, _e6324.member);
                                                            } else {
                                                                phi_3181_ = _e6324;
                                                                phi_3224_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e6349 = phi_3181_;
                                                            let _e6351 = phi_3224_;
                                                            let _e6354 = (bitcast<i32>(_e6351.member) != 0i);
                                                            if _e6354 {
                                                                phi_3184_ = (0.5f * (_e6326 + (_e6316 / _e6326)));
                                                            } else {
                                                                phi_3184_ = f32();
                                                            }
                                                            let _e6359 = phi_3184_;
                                                            continue;
                                                            continuing {
                                                                phi_3180_ = _e6349;
                                                                phi_3183_ = _e6359;
                                                                break if !(_e6354);
                                                            }
                                                        }
                                                        let _e6364 = local_40;
                                                        phi_3237_ = (_e6364 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e6371 = phi_3237_;
                                                    let _e6372 = (0.000000059604645f * 12f);
                                                    let _e6377 = ((((((((_e6046 + _e6048) + (_e6100 + _e6102)) + (_e6154 + _e6156)) * (0.000000059604645f * 16f)) + (_e6163 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e480.member_1 * _e6371) * (1f + _e6372)));
                                                    let _e6382 = (((_e6307 * _e5950[0]) + (_e6309 * _e5950[1])) + (_e6311 * _e5950[2]));
                                                    let _e6387 = (((_e6307 * (_e5950[0] - _e5956[0])) + (_e6309 * (_e5950[1] - _e5956[1]))) + (_e6311 * (_e5950[2] - _e5956[2])));
                                                    let _e6392 = (((_e6307 * (_e5950[0] - _e5962[0])) + (_e6309 * (_e5950[1] - _e5962[1]))) + (_e6311 * (_e5950[2] - _e5962[2])));
                                                    let _e6397 = (((_e6307 * _e5950[0]) + (_e6309 * _e5950[1])) + (_e6311 * _e5950[2]));
                                                    let _e6403 = (((_e6307 * _e5974[0]) + (_e6309 * _e5974[1])) + (_e6311 * _e5974[2]));
                                                    let _e6408 = (((_e6307 * (_e5974[0] - _e5980[0])) + (_e6309 * (_e5974[1] - _e5980[1]))) + (_e6311 * (_e5974[2] - _e5980[2])));
                                                    let _e6413 = (((_e6307 * (_e5974[0] - _e5986[0])) + (_e6309 * (_e5974[1] - _e5986[1]))) + (_e6311 * (_e5974[2] - _e5986[2])));
                                                    let _e6418 = (((_e6307 * _e5974[0]) + (_e6309 * _e5974[1])) + (_e6311 * _e5974[2]));
                                                    if (_e6382 < 0f) {
                                                        phi_3303_ = -(_e6382);
                                                    } else {
                                                        phi_3303_ = _e6382;
                                                    }
                                                    let _e6423 = phi_3303_;
                                                    if (_e6403 < 0f) {
                                                        phi_3309_ = -(_e6403);
                                                    } else {
                                                        phi_3309_ = _e6403;
                                                    }
                                                    let _e6427 = phi_3309_;
                                                    if (_e6387 < 0f) {
                                                        phi_3318_ = -(_e6387);
                                                    } else {
                                                        phi_3318_ = _e6387;
                                                    }
                                                    let _e6434 = phi_3318_;
                                                    if (_e6408 < 0f) {
                                                        phi_3324_ = -(_e6408);
                                                    } else {
                                                        phi_3324_ = _e6408;
                                                    }
                                                    let _e6438 = phi_3324_;
                                                    if (_e6392 < 0f) {
                                                        phi_3333_ = -(_e6392);
                                                    } else {
                                                        phi_3333_ = _e6392;
                                                    }
                                                    let _e6445 = phi_3333_;
                                                    if (_e6413 < 0f) {
                                                        phi_3339_ = -(_e6413);
                                                    } else {
                                                        phi_3339_ = _e6413;
                                                    }
                                                    let _e6449 = phi_3339_;
                                                    if (_e6397 < 0f) {
                                                        phi_3348_ = -(_e6397);
                                                    } else {
                                                        phi_3348_ = _e6397;
                                                    }
                                                    let _e6456 = phi_3348_;
                                                    if (_e6418 < 0f) {
                                                        phi_3354_ = -(_e6418);
                                                    } else {
                                                        phi_3354_ = _e6418;
                                                    }
                                                    let _e6460 = phi_3354_;
                                                    phi_3360_ = type_32(array<f32, 4>(_e6382, _e6387, _e6392, _e6397), array<f32, 4>(_e6403, _e6408, _e6413, _e6418), array<f32, 4>((_e6377 + ((_e6423 + _e6427) * _e6372)), (_e6377 + ((_e6434 + _e6438) * _e6372)), (_e6377 + ((_e6445 + _e6449) * _e6372)), (_e6377 + ((_e6456 + _e6460) * _e6372))));
                                                    phi_3361_ = false;
                                                } else {
                                                    phi_3360_ = type_32();
                                                    phi_3361_ = true;
                                                }
                                                let _e6467 = phi_3360_;
                                                let _e6469 = phi_3361_;
                                                phi_3362_ = _e6467;
                                                phi_3363_ = _e6469;
                                            } else {
                                                phi_3362_ = type_32();
                                                phi_3363_ = true;
                                            }
                                            let _e6471 = phi_3362_;
                                            let _e6473 = phi_3363_;
                                            if _e6473 {
                                                phi_3371_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_3371_ = _e6471;
                                            }
                                            let _e6475 = phi_3371_;
                                            local_17 = type_32(array<f32, 4>(_e6475.member[0], _e6475.member[1], _e6475.member[2], _e6475.member[3]), array<f32, 4>(_e6475.member_1[0], _e6475.member_1[1], _e6475.member_1[2], _e6475.member_1[3]), array<f32, 4>(_e6475.member_2[0], _e6475.member_2[1], _e6475.member_2[2], _e6475.member_2[3]));
                                            let _e6495 = (_e6173 - _e6179);
                                            let _e6499 = local_17.member[0u];
                                            let _e6502 = local_17.member_1[0u];
                                            let _e6505 = local_17.member[0u];
                                            let _e6511 = local_17.member_2[0u];
                                            if (((_e6499 + ((_e6502 - _e6505) * _e6173)) - _e6511) > 0f) {
                                                let _e6516 = local_17.member[1u];
                                                let _e6519 = local_17.member_1[1u];
                                                let _e6522 = local_17.member[1u];
                                                let _e6528 = local_17.member_2[1u];
                                                if (((_e6516 + ((_e6519 - _e6522) * _e6173)) - _e6528) > 0f) {
                                                    let _e6533 = local_17.member[2u];
                                                    let _e6536 = local_17.member_1[2u];
                                                    let _e6539 = local_17.member[2u];
                                                    let _e6545 = local_17.member_2[2u];
                                                    if (((_e6533 + ((_e6536 - _e6539) * _e6173)) - _e6545) > 0f) {
                                                        let _e6550 = local_17.member[3u];
                                                        let _e6553 = local_17.member_1[3u];
                                                        let _e6556 = local_17.member[3u];
                                                        let _e6562 = local_17.member_2[3u];
                                                        phi_3542_ = (((_e6550 + ((_e6553 - _e6556) * _e6173)) - _e6562) > 0f);
                                                        phi_3543_ = false;
                                                    } else {
                                                        phi_3542_ = bool();
                                                        phi_3543_ = true;
                                                    }
                                                    let _e6566 = phi_3542_;
                                                    let _e6568 = phi_3543_;
                                                    phi_3544_ = _e6566;
                                                    phi_3545_ = _e6568;
                                                } else {
                                                    phi_3544_ = bool();
                                                    phi_3545_ = true;
                                                }
                                                let _e6570 = phi_3544_;
                                                let _e6572 = phi_3545_;
                                                phi_3546_ = _e6570;
                                                phi_3547_ = _e6572;
                                            } else {
                                                phi_3546_ = bool();
                                                phi_3547_ = true;
                                            }
                                            let _e6574 = phi_3546_;
                                            let _e6576 = phi_3547_;
                                            if _e6576 {
                                                phi_3551_ = false;
                                            } else {
                                                phi_3551_ = _e6574;
                                            }
                                            let _e6578 = phi_3551_;
                                            if _e6578 {
                                                if (_e6173 <= _e6175) {
                                                    phi_3861_ = true;
                                                } else {
                                                    let _e6582 = local_16.member[0u];
                                                    let _e6585 = local_16.member_1[0u];
                                                    let _e6588 = local_16.member[0u];
                                                    let _e6594 = local_16.member_2[0u];
                                                    let _e6598 = local_17.member[0u];
                                                    let _e6601 = local_17.member_1[0u];
                                                    let _e6604 = local_17.member[0u];
                                                    let _e6610 = local_17.member_2[0u];
                                                    if ((((_e6582 + ((_e6585 - _e6588) * _e6173)) - _e6594) + ((_e6598 + ((_e6601 - _e6604) * _e6179)) - _e6610)) > 0f) {
                                                        let _e6616 = local_16.member[1u];
                                                        let _e6619 = local_16.member_1[1u];
                                                        let _e6622 = local_16.member[1u];
                                                        let _e6628 = local_16.member_2[1u];
                                                        let _e6632 = local_17.member[1u];
                                                        let _e6635 = local_17.member_1[1u];
                                                        let _e6638 = local_17.member[1u];
                                                        let _e6644 = local_17.member_2[1u];
                                                        if ((((_e6616 + ((_e6619 - _e6622) * _e6173)) - _e6628) + ((_e6632 + ((_e6635 - _e6638) * _e6179)) - _e6644)) > 0f) {
                                                            let _e6650 = local_16.member[2u];
                                                            let _e6653 = local_16.member_1[2u];
                                                            let _e6656 = local_16.member[2u];
                                                            let _e6662 = local_16.member_2[2u];
                                                            let _e6666 = local_17.member[2u];
                                                            let _e6669 = local_17.member_1[2u];
                                                            let _e6672 = local_17.member[2u];
                                                            let _e6678 = local_17.member_2[2u];
                                                            if ((((_e6650 + ((_e6653 - _e6656) * _e6173)) - _e6662) + ((_e6666 + ((_e6669 - _e6672) * _e6179)) - _e6678)) > 0f) {
                                                                let _e6684 = local_16.member[3u];
                                                                let _e6687 = local_16.member_1[3u];
                                                                let _e6690 = local_16.member[3u];
                                                                let _e6696 = local_16.member_2[3u];
                                                                let _e6700 = local_17.member[3u];
                                                                let _e6703 = local_17.member_1[3u];
                                                                let _e6706 = local_17.member[3u];
                                                                let _e6712 = local_17.member_2[3u];
                                                                phi_3848_ = ((((_e6684 + ((_e6687 - _e6690) * _e6173)) - _e6696) + ((_e6700 + ((_e6703 - _e6706) * _e6179)) - _e6712)) > 0f);
                                                                phi_3849_ = false;
                                                            } else {
                                                                phi_3848_ = bool();
                                                                phi_3849_ = true;
                                                            }
                                                            let _e6717 = phi_3848_;
                                                            let _e6719 = phi_3849_;
                                                            phi_3850_ = _e6717;
                                                            phi_3851_ = _e6719;
                                                        } else {
                                                            phi_3850_ = bool();
                                                            phi_3851_ = true;
                                                        }
                                                        let _e6721 = phi_3850_;
                                                        let _e6723 = phi_3851_;
                                                        phi_3852_ = _e6721;
                                                        phi_3853_ = _e6723;
                                                    } else {
                                                        phi_3852_ = bool();
                                                        phi_3853_ = true;
                                                    }
                                                    let _e6725 = phi_3852_;
                                                    let _e6727 = phi_3853_;
                                                    if _e6727 {
                                                        phi_3857_ = false;
                                                    } else {
                                                        phi_3857_ = _e6725;
                                                    }
                                                    let _e6729 = phi_3857_;
                                                    phi_3861_ = _e6729;
                                                }
                                                let _e6731 = phi_3861_;
                                                if _e6731 {
                                                    if _e6181 {
                                                        if (_e6173 >= _e282) {
                                                            phi_3872_ = false;
                                                        } else {
                                                            phi_3872_ = true;
                                                        }
                                                        let _e6734 = phi_3872_;
                                                        phi_3873_ = _e6734;
                                                    } else {
                                                        phi_3873_ = true;
                                                    }
                                                    let _e6736 = phi_3873_;
                                                    if _e6736 {
                                                        local_16 = type_32(array<f32, 4>(_e6475.member[0], _e6475.member[1], _e6475.member[2], _e6475.member[3]), array<f32, 4>(_e6475.member_1[0], _e6475.member_1[1], _e6475.member_1[2], _e6475.member_1[3]), array<f32, 4>(_e6475.member_2[0], _e6475.member_2[1], _e6475.member_2[2], _e6475.member_2[3]));
                                                        let _e6758 = local_16.member[0u];
                                                        let _e6761 = local_16.member_1[0u];
                                                        let _e6764 = local_16.member_2[0u];
                                                        if (_e6758 > _e6764) {
                                                            if (_e6761 > _e6764) {
                                                                phi_3947_ = false;
                                                            } else {
                                                                phi_3947_ = true;
                                                            }
                                                            let _e6768 = phi_3947_;
                                                            phi_3948_ = _e6768;
                                                        } else {
                                                            phi_3948_ = true;
                                                        }
                                                        let _e6770 = phi_3948_;
                                                        if _e6770 {
                                                            let _e6771 = (_e6761 >= _e6758);
                                                            if _e6771 {
                                                                phi_3970_ = f32();
                                                                phi_3971_ = false;
                                                            } else {
                                                                if ((_e6758 - _e6761) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3968_ = (((_e6758 - _e6764) / (_e6758 - _e6761)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3969_ = false;
                                                                } else {
                                                                    phi_3968_ = f32();
                                                                    phi_3969_ = true;
                                                                }
                                                                let _e6782 = phi_3968_;
                                                                let _e6784 = phi_3969_;
                                                                phi_3970_ = _e6782;
                                                                phi_3971_ = _e6784;
                                                            }
                                                            let _e6786 = phi_3970_;
                                                            let _e6788 = phi_3971_;
                                                            phi_3972_ = _e6786;
                                                            phi_3973_ = _e6771;
                                                            phi_3974_ = _e6788;
                                                        } else {
                                                            phi_3972_ = f32();
                                                            phi_3973_ = true;
                                                            phi_3974_ = false;
                                                        }
                                                        let _e6790 = phi_3972_;
                                                        let _e6792 = phi_3973_;
                                                        let _e6794 = phi_3974_;
                                                        if _e6792 {
                                                            phi_3978_ = 2f;
                                                            phi_3979_ = true;
                                                        } else {
                                                            phi_3978_ = _e6173;
                                                            phi_3979_ = _e6794;
                                                        }
                                                        let _e6796 = phi_3978_;
                                                        let _e6798 = phi_3979_;
                                                        if _e6798 {
                                                            phi_3983_ = _e6796;
                                                        } else {
                                                            phi_3983_ = _e6790;
                                                        }
                                                        let _e6800 = phi_3983_;
                                                        let _e6803 = local_16.member[1u];
                                                        let _e6806 = local_16.member_1[1u];
                                                        let _e6809 = local_16.member_2[1u];
                                                        if (_e6803 > _e6809) {
                                                            if (_e6806 > _e6809) {
                                                                phi_4015_ = false;
                                                            } else {
                                                                phi_4015_ = true;
                                                            }
                                                            let _e6813 = phi_4015_;
                                                            phi_4016_ = _e6813;
                                                        } else {
                                                            phi_4016_ = true;
                                                        }
                                                        let _e6815 = phi_4016_;
                                                        if _e6815 {
                                                            let _e6816 = (_e6806 >= _e6803);
                                                            if _e6816 {
                                                                phi_4038_ = f32();
                                                                phi_4039_ = false;
                                                            } else {
                                                                if ((_e6803 - _e6806) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_4036_ = (((_e6803 - _e6809) / (_e6803 - _e6806)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_4037_ = false;
                                                                } else {
                                                                    phi_4036_ = f32();
                                                                    phi_4037_ = true;
                                                                }
                                                                let _e6827 = phi_4036_;
                                                                let _e6829 = phi_4037_;
                                                                phi_4038_ = _e6827;
                                                                phi_4039_ = _e6829;
                                                            }
                                                            let _e6831 = phi_4038_;
                                                            let _e6833 = phi_4039_;
                                                            phi_4040_ = _e6831;
                                                            phi_4041_ = _e6816;
                                                            phi_4042_ = _e6833;
                                                        } else {
                                                            phi_4040_ = f32();
                                                            phi_4041_ = true;
                                                            phi_4042_ = false;
                                                        }
                                                        let _e6835 = phi_4040_;
                                                        let _e6837 = phi_4041_;
                                                        let _e6839 = phi_4042_;
                                                        if _e6837 {
                                                            phi_4046_ = 2f;
                                                            phi_4047_ = true;
                                                        } else {
                                                            phi_4046_ = _e6173;
                                                            phi_4047_ = _e6839;
                                                        }
                                                        let _e6841 = phi_4046_;
                                                        let _e6843 = phi_4047_;
                                                        if _e6843 {
                                                            phi_4051_ = _e6841;
                                                        } else {
                                                            phi_4051_ = _e6835;
                                                        }
                                                        let _e6845 = phi_4051_;
                                                        if (_e6800 < _e6845) {
                                                            phi_4056_ = _e6800;
                                                        } else {
                                                            phi_4056_ = _e6845;
                                                        }
                                                        let _e6848 = phi_4056_;
                                                        let _e6851 = local_16.member[2u];
                                                        let _e6854 = local_16.member_1[2u];
                                                        let _e6857 = local_16.member_2[2u];
                                                        if (_e6851 > _e6857) {
                                                            if (_e6854 > _e6857) {
                                                                phi_4088_ = false;
                                                            } else {
                                                                phi_4088_ = true;
                                                            }
                                                            let _e6861 = phi_4088_;
                                                            phi_4089_ = _e6861;
                                                        } else {
                                                            phi_4089_ = true;
                                                        }
                                                        let _e6863 = phi_4089_;
                                                        if _e6863 {
                                                            let _e6864 = (_e6854 >= _e6851);
                                                            if _e6864 {
                                                                phi_4111_ = f32();
                                                                phi_4112_ = false;
                                                            } else {
                                                                if ((_e6851 - _e6854) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_4109_ = (((_e6851 - _e6857) / (_e6851 - _e6854)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_4110_ = false;
                                                                } else {
                                                                    phi_4109_ = f32();
                                                                    phi_4110_ = true;
                                                                }
                                                                let _e6875 = phi_4109_;
                                                                let _e6877 = phi_4110_;
                                                                phi_4111_ = _e6875;
                                                                phi_4112_ = _e6877;
                                                            }
                                                            let _e6879 = phi_4111_;
                                                            let _e6881 = phi_4112_;
                                                            phi_4113_ = _e6879;
                                                            phi_4114_ = _e6864;
                                                            phi_4115_ = _e6881;
                                                        } else {
                                                            phi_4113_ = f32();
                                                            phi_4114_ = true;
                                                            phi_4115_ = false;
                                                        }
                                                        let _e6883 = phi_4113_;
                                                        let _e6885 = phi_4114_;
                                                        let _e6887 = phi_4115_;
                                                        if _e6885 {
                                                            phi_4119_ = 2f;
                                                            phi_4120_ = true;
                                                        } else {
                                                            phi_4119_ = _e6173;
                                                            phi_4120_ = _e6887;
                                                        }
                                                        let _e6889 = phi_4119_;
                                                        let _e6891 = phi_4120_;
                                                        if _e6891 {
                                                            phi_4124_ = _e6889;
                                                        } else {
                                                            phi_4124_ = _e6883;
                                                        }
                                                        let _e6893 = phi_4124_;
                                                        let _e6896 = local_16.member[3u];
                                                        let _e6899 = local_16.member_1[3u];
                                                        let _e6902 = local_16.member_2[3u];
                                                        if (_e6896 > _e6902) {
                                                            if (_e6899 > _e6902) {
                                                                phi_4156_ = false;
                                                            } else {
                                                                phi_4156_ = true;
                                                            }
                                                            let _e6906 = phi_4156_;
                                                            phi_4157_ = _e6906;
                                                        } else {
                                                            phi_4157_ = true;
                                                        }
                                                        let _e6908 = phi_4157_;
                                                        if _e6908 {
                                                            let _e6909 = (_e6899 >= _e6896);
                                                            if _e6909 {
                                                                phi_4179_ = f32();
                                                                phi_4180_ = false;
                                                            } else {
                                                                if ((_e6896 - _e6899) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_4177_ = (((_e6896 - _e6902) / (_e6896 - _e6899)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_4178_ = false;
                                                                } else {
                                                                    phi_4177_ = f32();
                                                                    phi_4178_ = true;
                                                                }
                                                                let _e6920 = phi_4177_;
                                                                let _e6922 = phi_4178_;
                                                                phi_4179_ = _e6920;
                                                                phi_4180_ = _e6922;
                                                            }
                                                            let _e6924 = phi_4179_;
                                                            let _e6926 = phi_4180_;
                                                            phi_4181_ = _e6924;
                                                            phi_4182_ = _e6909;
                                                            phi_4183_ = _e6926;
                                                        } else {
                                                            phi_4181_ = f32();
                                                            phi_4182_ = true;
                                                            phi_4183_ = false;
                                                        }
                                                        let _e6928 = phi_4181_;
                                                        let _e6930 = phi_4182_;
                                                        let _e6932 = phi_4183_;
                                                        if _e6930 {
                                                            phi_4187_ = 2f;
                                                            phi_4188_ = true;
                                                        } else {
                                                            phi_4187_ = _e6173;
                                                            phi_4188_ = _e6932;
                                                        }
                                                        let _e6934 = phi_4187_;
                                                        let _e6936 = phi_4188_;
                                                        if _e6936 {
                                                            phi_4192_ = _e6934;
                                                        } else {
                                                            phi_4192_ = _e6928;
                                                        }
                                                        let _e6938 = phi_4192_;
                                                        if (_e6893 < _e6938) {
                                                            phi_4197_ = _e6893;
                                                        } else {
                                                            phi_4197_ = _e6938;
                                                        }
                                                        let _e6941 = phi_4197_;
                                                        if (_e6848 < _e6941) {
                                                            phi_4202_ = _e6848;
                                                        } else {
                                                            phi_4202_ = _e6941;
                                                        }
                                                        let _e6944 = phi_4202_;
                                                        if (_e6944 > _e6173) {
                                                            phi_4207_ = _e6944;
                                                        } else {
                                                            phi_4207_ = _e6173;
                                                        }
                                                        let _e6947 = phi_4207_;
                                                        let _e6948 = (_e6947 > _e282);
                                                        if _e6948 {
                                                            phi_4712_ = f32();
                                                            phi_4713_ = f32();
                                                            phi_4714_ = false;
                                                            phi_4715_ = false;
                                                        } else {
                                                            let _e6949 = (_e6947 - _e6173);
                                                            let _e6950 = (_e6949 <= _e6168);
                                                            let _e6952 = (_e6947 + (_e278 * 0.01f));
                                                            if (_e6952 < _e282) {
                                                                phi_4220_ = _e6952;
                                                            } else {
                                                                phi_4220_ = _e282;
                                                            }
                                                            let _e6955 = phi_4220_;
                                                            if _e6950 {
                                                                if (_e480.member_1 > 0f) {
                                                                    let _e6959 = local_18.member[0u];
                                                                    let _e6965 = local_18.member[1u];
                                                                    let _e6981 = local_18.member_1[0u];
                                                                    let _e6987 = local_18.member_1[1u];
                                                                    let _e7003 = local_18.member_2[0u];
                                                                    let _e7009 = local_18.member_2[1u];
                                                                    let _e7023 = function_2(array<f32, 3>((_e6959[0] + ((_e6965[0] - _e6959[0]) * _e6955)), (_e6959[1] + ((_e6965[1] - _e6959[1]) * _e6955)), (_e6959[2] + ((_e6965[2] - _e6959[2]) * _e6955))), array<f32, 3>((_e6981[0] + ((_e6987[0] - _e6981[0]) * _e6955)), (_e6981[1] + ((_e6987[1] - _e6981[1]) * _e6955)), (_e6981[2] + ((_e6987[2] - _e6981[2]) * _e6955))), array<f32, 3>((_e7003[0] + ((_e7009[0] - _e7003[0]) * _e6955)), (_e7003[1] + ((_e7009[1] - _e7003[1]) * _e6955)), (_e7003[2] + ((_e7009[2] - _e7003[2]) * _e6955))), 0u);
                                                                    let _e7034 = (((_e7023[0] * _e7023[0]) + (_e7023[1] * _e7023[1])) + (_e7023[2] * _e7023[2]));
                                                                    if (_e7034 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e7034 > 0f) {
                                                                            phi_4350_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_4350_ = 0f;
                                                                        }
                                                                        let _e7087 = phi_4350_;
                                                                        phi_4414_ = _e7087;
                                                                    } else {
                                                                        phi_4357_ = type_14(0i, 5i);
                                                                        phi_4360_ = bitcast<f32>(((bitcast<u32>(_e7034) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e7042 = phi_4357_;
                                                                            let _e7044 = phi_4360_;
                                                                            local_41 = _e7044;
                                                                            if (_e7042.member < _e7042.member_1) {
                                                                                let _e7051 = (_e7042.member + 1i);
                                                                                if ((false == (_e7051 > _e7042.member)) != false) {
                                                                                    phi_4381_ = true;
                                                                                } else {
                                                                                    phi_4381_ = false;
                                                                                }
                                                                                let _e7056 = phi_4381_;
                                                                                if _e7056 {
                                                                                    phi_4387_ = type_15(0u, type_15().member_1);
                                                                                } else {
                                                                                    phi_4387_ = type_15(1u, _e7051);
                                                                                }
                                                                                let _e7061 = phi_4387_;
                                                                                phi_4358_ = type_14(_e7061.member_1, _e7042.member_1);
                                                                                phi_4401_ = type_15(1u, _e7042.member);
                                                                            } else {
                                                                                phi_4358_ = _e7042;
                                                                                phi_4401_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e7067 = phi_4358_;
                                                                            let _e7069 = phi_4401_;
                                                                            let _e7072 = (bitcast<i32>(_e7069.member) != 0i);
                                                                            if _e7072 {
                                                                                phi_4361_ = (0.5f * (_e7044 + (_e7034 / _e7044)));
                                                                            } else {
                                                                                phi_4361_ = f32();
                                                                            }
                                                                            let _e7077 = phi_4361_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4357_ = _e7067;
                                                                                phi_4360_ = _e7077;
                                                                                break if !(_e7072);
                                                                            }
                                                                        }
                                                                        let _e7082 = local_41;
                                                                        phi_4414_ = (_e7082 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e7089 = phi_4414_;
                                                                    let _e7095 = local_18.member[0u];
                                                                    if (_e7095[0] < 0f) {
                                                                        phi_4430_ = -(_e7095[0]);
                                                                    } else {
                                                                        phi_4430_ = _e7095[0];
                                                                    }
                                                                    let _e7102 = phi_4430_;
                                                                    if (_e7095[1] < 0f) {
                                                                        phi_4437_ = -(_e7095[1]);
                                                                    } else {
                                                                        phi_4437_ = _e7095[1];
                                                                    }
                                                                    let _e7106 = phi_4437_;
                                                                    if (_e7102 > _e7106) {
                                                                        phi_4442_ = _e7102;
                                                                    } else {
                                                                        phi_4442_ = _e7106;
                                                                    }
                                                                    let _e7109 = phi_4442_;
                                                                    if (_e7095[2] < 0f) {
                                                                        phi_4449_ = -(_e7095[2]);
                                                                    } else {
                                                                        phi_4449_ = _e7095[2];
                                                                    }
                                                                    let _e7113 = phi_4449_;
                                                                    if (_e7109 > _e7113) {
                                                                        phi_4454_ = _e7109;
                                                                    } else {
                                                                        phi_4454_ = _e7113;
                                                                    }
                                                                    let _e7116 = phi_4454_;
                                                                    let _e7119 = local_18.member[1u];
                                                                    if (_e7119[0] < 0f) {
                                                                        phi_4467_ = -(_e7119[0]);
                                                                    } else {
                                                                        phi_4467_ = _e7119[0];
                                                                    }
                                                                    let _e7126 = phi_4467_;
                                                                    if (_e7119[1] < 0f) {
                                                                        phi_4474_ = -(_e7119[1]);
                                                                    } else {
                                                                        phi_4474_ = _e7119[1];
                                                                    }
                                                                    let _e7130 = phi_4474_;
                                                                    if (_e7126 > _e7130) {
                                                                        phi_4479_ = _e7126;
                                                                    } else {
                                                                        phi_4479_ = _e7130;
                                                                    }
                                                                    let _e7133 = phi_4479_;
                                                                    if (_e7119[2] < 0f) {
                                                                        phi_4486_ = -(_e7119[2]);
                                                                    } else {
                                                                        phi_4486_ = _e7119[2];
                                                                    }
                                                                    let _e7137 = phi_4486_;
                                                                    if (_e7133 > _e7137) {
                                                                        phi_4491_ = _e7133;
                                                                    } else {
                                                                        phi_4491_ = _e7137;
                                                                    }
                                                                    let _e7140 = phi_4491_;
                                                                    if (_e7116 > _e7140) {
                                                                        phi_4496_ = _e7116;
                                                                    } else {
                                                                        phi_4496_ = _e7140;
                                                                    }
                                                                    let _e7143 = phi_4496_;
                                                                    let _e7145 = local_18.member_3;
                                                                    let _e7149 = local_18.member_1[0u];
                                                                    if (_e7149[0] < 0f) {
                                                                        phi_4513_ = -(_e7149[0]);
                                                                    } else {
                                                                        phi_4513_ = _e7149[0];
                                                                    }
                                                                    let _e7156 = phi_4513_;
                                                                    if (_e7149[1] < 0f) {
                                                                        phi_4520_ = -(_e7149[1]);
                                                                    } else {
                                                                        phi_4520_ = _e7149[1];
                                                                    }
                                                                    let _e7160 = phi_4520_;
                                                                    if (_e7156 > _e7160) {
                                                                        phi_4525_ = _e7156;
                                                                    } else {
                                                                        phi_4525_ = _e7160;
                                                                    }
                                                                    let _e7163 = phi_4525_;
                                                                    if (_e7149[2] < 0f) {
                                                                        phi_4532_ = -(_e7149[2]);
                                                                    } else {
                                                                        phi_4532_ = _e7149[2];
                                                                    }
                                                                    let _e7167 = phi_4532_;
                                                                    if (_e7163 > _e7167) {
                                                                        phi_4537_ = _e7163;
                                                                    } else {
                                                                        phi_4537_ = _e7167;
                                                                    }
                                                                    let _e7170 = phi_4537_;
                                                                    let _e7173 = local_18.member_1[1u];
                                                                    if (_e7173[0] < 0f) {
                                                                        phi_4551_ = -(_e7173[0]);
                                                                    } else {
                                                                        phi_4551_ = _e7173[0];
                                                                    }
                                                                    let _e7180 = phi_4551_;
                                                                    if (_e7173[1] < 0f) {
                                                                        phi_4558_ = -(_e7173[1]);
                                                                    } else {
                                                                        phi_4558_ = _e7173[1];
                                                                    }
                                                                    let _e7184 = phi_4558_;
                                                                    if (_e7180 > _e7184) {
                                                                        phi_4563_ = _e7180;
                                                                    } else {
                                                                        phi_4563_ = _e7184;
                                                                    }
                                                                    let _e7187 = phi_4563_;
                                                                    if (_e7173[2] < 0f) {
                                                                        phi_4570_ = -(_e7173[2]);
                                                                    } else {
                                                                        phi_4570_ = _e7173[2];
                                                                    }
                                                                    let _e7191 = phi_4570_;
                                                                    if (_e7187 > _e7191) {
                                                                        phi_4575_ = _e7187;
                                                                    } else {
                                                                        phi_4575_ = _e7191;
                                                                    }
                                                                    let _e7194 = phi_4575_;
                                                                    if (_e7170 > _e7194) {
                                                                        phi_4580_ = _e7170;
                                                                    } else {
                                                                        phi_4580_ = _e7194;
                                                                    }
                                                                    let _e7197 = phi_4580_;
                                                                    let _e7199 = local_18.member_3;
                                                                    let _e7203 = local_18.member_2[0u];
                                                                    if (_e7203[0] < 0f) {
                                                                        phi_4597_ = -(_e7203[0]);
                                                                    } else {
                                                                        phi_4597_ = _e7203[0];
                                                                    }
                                                                    let _e7210 = phi_4597_;
                                                                    if (_e7203[1] < 0f) {
                                                                        phi_4604_ = -(_e7203[1]);
                                                                    } else {
                                                                        phi_4604_ = _e7203[1];
                                                                    }
                                                                    let _e7214 = phi_4604_;
                                                                    if (_e7210 > _e7214) {
                                                                        phi_4609_ = _e7210;
                                                                    } else {
                                                                        phi_4609_ = _e7214;
                                                                    }
                                                                    let _e7217 = phi_4609_;
                                                                    if (_e7203[2] < 0f) {
                                                                        phi_4616_ = -(_e7203[2]);
                                                                    } else {
                                                                        phi_4616_ = _e7203[2];
                                                                    }
                                                                    let _e7221 = phi_4616_;
                                                                    if (_e7217 > _e7221) {
                                                                        phi_4621_ = _e7217;
                                                                    } else {
                                                                        phi_4621_ = _e7221;
                                                                    }
                                                                    let _e7224 = phi_4621_;
                                                                    let _e7227 = local_18.member_2[1u];
                                                                    if (_e7227[0] < 0f) {
                                                                        phi_4635_ = -(_e7227[0]);
                                                                    } else {
                                                                        phi_4635_ = _e7227[0];
                                                                    }
                                                                    let _e7234 = phi_4635_;
                                                                    if (_e7227[1] < 0f) {
                                                                        phi_4642_ = -(_e7227[1]);
                                                                    } else {
                                                                        phi_4642_ = _e7227[1];
                                                                    }
                                                                    let _e7238 = phi_4642_;
                                                                    if (_e7234 > _e7238) {
                                                                        phi_4647_ = _e7234;
                                                                    } else {
                                                                        phi_4647_ = _e7238;
                                                                    }
                                                                    let _e7241 = phi_4647_;
                                                                    if (_e7227[2] < 0f) {
                                                                        phi_4654_ = -(_e7227[2]);
                                                                    } else {
                                                                        phi_4654_ = _e7227[2];
                                                                    }
                                                                    let _e7245 = phi_4654_;
                                                                    if (_e7241 > _e7245) {
                                                                        phi_4659_ = _e7241;
                                                                    } else {
                                                                        phi_4659_ = _e7245;
                                                                    }
                                                                    let _e7248 = phi_4659_;
                                                                    if (_e7224 > _e7248) {
                                                                        phi_4664_ = _e7224;
                                                                    } else {
                                                                        phi_4664_ = _e7248;
                                                                    }
                                                                    let _e7251 = phi_4664_;
                                                                    let _e7253 = local_18.member_3;
                                                                    let _e7260 = local_18.member_3;
                                                                    if (((_e7089 * (1f + (0.000000059604645f * 8f))) + (((((((_e7143 + _e7145) + (_e7197 + _e7199)) + (_e7251 + _e7253)) * (0.000000059604645f * 16f)) + (_e7260 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e480.member_1) {
                                                                        phi_4684_ = false;
                                                                    } else {
                                                                        phi_4684_ = true;
                                                                    }
                                                                    let _e7269 = phi_4684_;
                                                                    phi_4685_ = _e7269;
                                                                } else {
                                                                    phi_4685_ = true;
                                                                }
                                                                let _e7271 = phi_4685_;
                                                                phi_4686_ = _e7271;
                                                            } else {
                                                                phi_4686_ = true;
                                                            }
                                                            let _e7273 = phi_4686_;
                                                            if _e7273 {
                                                                if _e6181 {
                                                                    if _e6950 {
                                                                        phi_4702_ = true;
                                                                    } else {
                                                                        if (_e6949 <= (_e6177 * 0.25f)) {
                                                                            phi_4701_ = false;
                                                                        } else {
                                                                            phi_4701_ = true;
                                                                        }
                                                                        let _e7278 = phi_4701_;
                                                                        phi_4702_ = _e7278;
                                                                    }
                                                                    let _e7280 = phi_4702_;
                                                                    if _e7280 {
                                                                        phi_4707_ = (_e6495 + _e6495);
                                                                    } else {
                                                                        phi_4707_ = 0f;
                                                                    }
                                                                    let _e7283 = phi_4707_;
                                                                    phi_4709_ = _e7283;
                                                                } else {
                                                                    phi_4709_ = (_e282 - _e6173);
                                                                }
                                                                let _e7285 = phi_4709_;
                                                                phi_4710_ = _e7285;
                                                                phi_4711_ = false;
                                                            } else {
                                                                phi_4710_ = f32();
                                                                phi_4711_ = true;
                                                            }
                                                            let _e7287 = phi_4710_;
                                                            let _e7289 = phi_4711_;
                                                            phi_4712_ = _e7287;
                                                            phi_4713_ = _e6949;
                                                            phi_4714_ = _e7273;
                                                            phi_4715_ = _e7289;
                                                        }
                                                        let _e7291 = phi_4712_;
                                                        let _e7293 = phi_4713_;
                                                        let _e7295 = phi_4714_;
                                                        let _e7297 = phi_4715_;
                                                        phi_4716_ = _e6947;
                                                        phi_4717_ = _e7291;
                                                        phi_4718_ = _e7293;
                                                        phi_4719_ = _e6947;
                                                        phi_4720_ = _e7295;
                                                        phi_4721_ = _e6948;
                                                        phi_4722_ = _e7297;
                                                        phi_4723_ = false;
                                                    } else {
                                                        phi_4716_ = f32();
                                                        phi_4717_ = f32();
                                                        phi_4718_ = f32();
                                                        phi_4719_ = f32();
                                                        phi_4720_ = false;
                                                        phi_4721_ = false;
                                                        phi_4722_ = false;
                                                        phi_4723_ = true;
                                                    }
                                                    let _e7299 = phi_4716_;
                                                    let _e7301 = phi_4717_;
                                                    let _e7303 = phi_4718_;
                                                    let _e7305 = phi_4719_;
                                                    let _e7307 = phi_4720_;
                                                    let _e7309 = phi_4721_;
                                                    let _e7311 = phi_4722_;
                                                    let _e7313 = phi_4723_;
                                                    phi_4724_ = _e7299;
                                                    phi_4725_ = _e7301;
                                                    phi_4726_ = _e7303;
                                                    phi_4727_ = _e7305;
                                                    phi_4728_ = false;
                                                    phi_4729_ = _e7307;
                                                    phi_4730_ = _e7309;
                                                    phi_4731_ = _e7311;
                                                    phi_4732_ = _e7313;
                                                } else {
                                                    phi_4724_ = f32();
                                                    phi_4725_ = f32();
                                                    phi_4726_ = f32();
                                                    phi_4727_ = f32();
                                                    phi_4728_ = true;
                                                    phi_4729_ = false;
                                                    phi_4730_ = false;
                                                    phi_4731_ = false;
                                                    phi_4732_ = false;
                                                }
                                                let _e7315 = phi_4724_;
                                                let _e7317 = phi_4725_;
                                                let _e7319 = phi_4726_;
                                                let _e7321 = phi_4727_;
                                                let _e7323 = phi_4728_;
                                                let _e7325 = phi_4729_;
                                                let _e7327 = phi_4730_;
                                                let _e7329 = phi_4731_;
                                                let _e7331 = phi_4732_;
                                                phi_4733_ = _e7315;
                                                phi_4734_ = _e7317;
                                                phi_4735_ = _e7319;
                                                phi_4736_ = _e7321;
                                                phi_4737_ = _e7323;
                                                phi_4738_ = _e7325;
                                                phi_4739_ = _e7327;
                                                phi_4740_ = _e7329;
                                                phi_4741_ = _e7331;
                                            } else {
                                                phi_4733_ = f32();
                                                phi_4734_ = f32();
                                                phi_4735_ = f32();
                                                phi_4736_ = f32();
                                                phi_4737_ = true;
                                                phi_4738_ = false;
                                                phi_4739_ = false;
                                                phi_4740_ = false;
                                                phi_4741_ = false;
                                            }
                                            let _e7333 = phi_4733_;
                                            let _e7335 = phi_4734_;
                                            let _e7337 = phi_4735_;
                                            let _e7339 = phi_4736_;
                                            let _e7341 = phi_4737_;
                                            let _e7343 = phi_4738_;
                                            let _e7345 = phi_4739_;
                                            let _e7347 = phi_4740_;
                                            let _e7349 = phi_4741_;
                                            if _e7341 {
                                                if (_e6173 <= _e6175) {
                                                    let _e7510 = (_e6183 + 1u);
                                                    let _e7511 = (_e7510 > 3u);
                                                    if _e7511 {
                                                        phi_4754_ = false;
                                                    } else {
                                                        phi_4754_ = true;
                                                    }
                                                    let _e7513 = phi_4754_;
                                                    phi_5076_ = _e7510;
                                                    phi_5077_ = f32();
                                                    phi_5078_ = false;
                                                    phi_5079_ = _e7513;
                                                    phi_5080_ = _e7511;
                                                } else {
                                                    let _e7353 = local_16.member[0u];
                                                    let _e7356 = local_16.member_1[0u];
                                                    let _e7359 = local_16.member[0u];
                                                    let _e7365 = local_16.member_2[0u];
                                                    let _e7366 = ((_e7353 + ((_e7356 - _e7359) * _e6179)) - _e7365);
                                                    let _e7369 = local_16.member[1u];
                                                    let _e7372 = local_16.member_1[1u];
                                                    let _e7375 = local_16.member[1u];
                                                    let _e7381 = local_16.member_2[1u];
                                                    let _e7382 = ((_e7369 + ((_e7372 - _e7375) * _e6179)) - _e7381);
                                                    if (_e7366 < _e7382) {
                                                        phi_4827_ = _e7366;
                                                    } else {
                                                        phi_4827_ = _e7382;
                                                    }
                                                    let _e7385 = phi_4827_;
                                                    let _e7388 = local_16.member[2u];
                                                    let _e7391 = local_16.member_1[2u];
                                                    let _e7394 = local_16.member[2u];
                                                    let _e7400 = local_16.member_2[2u];
                                                    let _e7401 = ((_e7388 + ((_e7391 - _e7394) * _e6179)) - _e7400);
                                                    let _e7404 = local_16.member[3u];
                                                    let _e7407 = local_16.member_1[3u];
                                                    let _e7410 = local_16.member[3u];
                                                    let _e7416 = local_16.member_2[3u];
                                                    let _e7417 = ((_e7404 + ((_e7407 - _e7410) * _e6179)) - _e7416);
                                                    if (_e7401 < _e7417) {
                                                        phi_4900_ = _e7401;
                                                    } else {
                                                        phi_4900_ = _e7417;
                                                    }
                                                    let _e7420 = phi_4900_;
                                                    if (_e7385 < _e7420) {
                                                        phi_4905_ = _e7385;
                                                    } else {
                                                        phi_4905_ = _e7420;
                                                    }
                                                    let _e7423 = phi_4905_;
                                                    let _e7426 = local_17.member[0u];
                                                    let _e7429 = local_17.member_1[0u];
                                                    let _e7432 = local_17.member[0u];
                                                    let _e7438 = local_17.member_2[0u];
                                                    let _e7439 = ((_e7426 + ((_e7429 - _e7432) * _e6173)) - _e7438);
                                                    let _e7442 = local_17.member[1u];
                                                    let _e7445 = local_17.member_1[1u];
                                                    let _e7448 = local_17.member[1u];
                                                    let _e7454 = local_17.member_2[1u];
                                                    let _e7455 = ((_e7442 + ((_e7445 - _e7448) * _e6173)) - _e7454);
                                                    if (_e7439 < _e7455) {
                                                        phi_4978_ = _e7439;
                                                    } else {
                                                        phi_4978_ = _e7455;
                                                    }
                                                    let _e7458 = phi_4978_;
                                                    let _e7461 = local_17.member[2u];
                                                    let _e7464 = local_17.member_1[2u];
                                                    let _e7467 = local_17.member[2u];
                                                    let _e7473 = local_17.member_2[2u];
                                                    let _e7474 = ((_e7461 + ((_e7464 - _e7467) * _e6173)) - _e7473);
                                                    let _e7477 = local_17.member[3u];
                                                    let _e7480 = local_17.member_1[3u];
                                                    let _e7483 = local_17.member[3u];
                                                    let _e7489 = local_17.member_2[3u];
                                                    let _e7490 = ((_e7477 + ((_e7480 - _e7483) * _e6173)) - _e7489);
                                                    if (_e7474 < _e7490) {
                                                        phi_5051_ = _e7474;
                                                    } else {
                                                        phi_5051_ = _e7490;
                                                    }
                                                    let _e7493 = phi_5051_;
                                                    if (_e7458 < _e7493) {
                                                        phi_5056_ = _e7458;
                                                    } else {
                                                        phi_5056_ = _e7493;
                                                    }
                                                    let _e7496 = phi_5056_;
                                                    if (_e7496 > 0f) {
                                                        phi_5074_ = 0.5f;
                                                    } else {
                                                        let _e7500 = (0.95f * (_e7423 / (_e7423 - _e7496)));
                                                        if (_e7500 > 0.0625f) {
                                                            if (_e7500 < 0.9f) {
                                                                phi_5072_ = _e7500;
                                                            } else {
                                                                phi_5072_ = 0.9f;
                                                            }
                                                            let _e7504 = phi_5072_;
                                                            phi_5073_ = _e7504;
                                                        } else {
                                                            phi_5073_ = 0.0625f;
                                                        }
                                                        let _e7506 = phi_5073_;
                                                        phi_5074_ = _e7506;
                                                    }
                                                    let _e7508 = phi_5074_;
                                                    phi_5076_ = u32();
                                                    phi_5077_ = (_e6495 * _e7508);
                                                    phi_5078_ = true;
                                                    phi_5079_ = false;
                                                    phi_5080_ = false;
                                                }
                                                let _e7515 = phi_5076_;
                                                let _e7517 = phi_5077_;
                                                let _e7519 = phi_5078_;
                                                let _e7521 = phi_5079_;
                                                let _e7523 = phi_5080_;
                                                phi_5081_ = _e7515;
                                                phi_5082_ = _e6175;
                                                phi_5083_ = _e7517;
                                                phi_5084_ = _e6177;
                                                phi_5085_ = _e6179;
                                                phi_5086_ = _e6181;
                                                phi_5087_ = _e6183;
                                                phi_5088_ = _e7519;
                                                phi_5089_ = _e7521;
                                                phi_5090_ = _e7523;
                                                phi_5091_ = false;
                                                phi_5092_ = false;
                                                phi_5093_ = false;
                                            } else {
                                                phi_5081_ = u32();
                                                phi_5082_ = _e7333;
                                                phi_5083_ = _e7335;
                                                phi_5084_ = _e7337;
                                                phi_5085_ = _e6173;
                                                phi_5086_ = true;
                                                phi_5087_ = 0u;
                                                phi_5088_ = _e7343;
                                                phi_5089_ = false;
                                                phi_5090_ = false;
                                                phi_5091_ = _e7345;
                                                phi_5092_ = _e7347;
                                                phi_5093_ = _e7349;
                                            }
                                            let _e7525 = phi_5081_;
                                            let _e7527 = phi_5082_;
                                            let _e7529 = phi_5083_;
                                            let _e7531 = phi_5084_;
                                            let _e7533 = phi_5085_;
                                            let _e7535 = phi_5086_;
                                            let _e7537 = phi_5087_;
                                            let _e7539 = phi_5088_;
                                            let _e7541 = phi_5089_;
                                            let _e7543 = phi_5090_;
                                            let _e7545 = phi_5091_;
                                            let _e7547 = phi_5092_;
                                            let _e7549 = phi_5093_;
                                            if _e7539 {
                                                let _e7550 = (_e7533 + _e7529);
                                                if (_e7550 > _e7527) {
                                                    phi_5102_ = _e7550;
                                                } else {
                                                    phi_5102_ = _e7527;
                                                }
                                                let _e7553 = phi_5102_;
                                                if (_e7553 < _e282) {
                                                    phi_5107_ = _e7553;
                                                } else {
                                                    phi_5107_ = _e282;
                                                }
                                                let _e7556 = phi_5107_;
                                                if !(_e6181) {
                                                    phi_5116_ = true;
                                                } else {
                                                    phi_5116_ = ((_e7556 - _e7533) > _e6168);
                                                }
                                                let _e7560 = phi_5116_;
                                                if _e7560 {
                                                    phi_5120_ = false;
                                                } else {
                                                    phi_5120_ = true;
                                                }
                                                let _e7562 = phi_5120_;
                                                phi_5121_ = _e7556;
                                                phi_5122_ = _e7527;
                                                phi_5123_ = _e7531;
                                                phi_5124_ = _e7533;
                                                phi_5125_ = _e7535;
                                                phi_5126_ = _e7537;
                                                phi_5127_ = _e7560;
                                                phi_5128_ = _e7562;
                                                phi_5129_ = false;
                                                phi_5130_ = false;
                                                phi_5131_ = false;
                                                phi_5132_ = false;
                                            } else {
                                                phi_5121_ = _e6173;
                                                phi_5122_ = _e6175;
                                                phi_5123_ = _e6177;
                                                phi_5124_ = _e6179;
                                                phi_5125_ = _e6181;
                                                phi_5126_ = _e7525;
                                                phi_5127_ = _e7541;
                                                phi_5128_ = false;
                                                phi_5129_ = _e7543;
                                                phi_5130_ = _e7545;
                                                phi_5131_ = _e7547;
                                                phi_5132_ = _e7549;
                                            }
                                            let _e7564 = phi_5121_;
                                            let _e7566 = phi_5122_;
                                            let _e7568 = phi_5123_;
                                            let _e7570 = phi_5124_;
                                            let _e7572 = phi_5125_;
                                            let _e7574 = phi_5126_;
                                            let _e7576 = phi_5127_;
                                            let _e7578 = phi_5128_;
                                            let _e7580 = phi_5129_;
                                            let _e7582 = phi_5130_;
                                            let _e7584 = phi_5131_;
                                            let _e7586 = phi_5132_;
                                            phi_2954_ = _e7564;
                                            phi_2956_ = _e7566;
                                            phi_2958_ = _e7568;
                                            phi_2960_ = _e7570;
                                            phi_2962_ = _e7572;
                                            phi_2964_ = _e7574;
                                            phi_5133_ = _e7527;
                                            phi_5134_ = _e7339;
                                            phi_5135_ = _e7576;
                                            phi_5136_ = _e7578;
                                            phi_5137_ = _e7580;
                                            phi_5138_ = _e7582;
                                            phi_5139_ = _e7584;
                                            phi_5140_ = false;
                                            phi_5141_ = _e7586;
                                        } else {
                                            phi_2954_ = f32();
                                            phi_2956_ = f32();
                                            phi_2958_ = f32();
                                            phi_2960_ = f32();
                                            phi_2962_ = bool();
                                            phi_2964_ = u32();
                                            phi_5133_ = f32();
                                            phi_5134_ = f32();
                                            phi_5135_ = false;
                                            phi_5136_ = false;
                                            phi_5137_ = false;
                                            phi_5138_ = false;
                                            phi_5139_ = false;
                                            phi_5140_ = true;
                                            phi_5141_ = false;
                                        }
                                        let _e7588 = phi_2954_;
                                        let _e7590 = phi_2956_;
                                        let _e7592 = phi_2958_;
                                        let _e7594 = phi_2960_;
                                        let _e7596 = phi_2962_;
                                        let _e7598 = phi_2964_;
                                        let _e7600 = phi_5133_;
                                        let _e7602 = phi_5134_;
                                        let _e7604 = phi_5135_;
                                        let _e7606 = phi_5136_;
                                        let _e7608 = phi_5137_;
                                        let _e7610 = phi_5138_;
                                        let _e7612 = phi_5139_;
                                        let _e7614 = phi_5140_;
                                        let _e7616 = phi_5141_;
                                        local_42 = _e7606;
                                        local_78 = _e7608;
                                        local_79 = _e7610;
                                        local_80 = _e7612;
                                        local_81 = _e7614;
                                        local_82 = _e7616;
                                        local_83 = _e7606;
                                        local_84 = _e7602;
                                        local_85 = _e7600;
                                        continue;
                                        continuing {
                                            phi_2950_ = _e6195;
                                            phi_2953_ = _e7588;
                                            phi_2955_ = _e7590;
                                            phi_2957_ = _e7592;
                                            phi_2959_ = _e7594;
                                            phi_2961_ = _e7596;
                                            phi_2963_ = _e7598;
                                            break if !(_e7604);
                                        }
                                    }
                                    let _e7619 = local_42;
                                    if _e7619 {
                                        phi_5145_ = false;
                                        phi_5146_ = false;
                                        phi_5147_ = false;
                                        phi_5148_ = false;
                                        phi_5149_ = false;
                                    } else {
                                        let _e11069 = local_78;
                                        phi_5145_ = _e11069;
                                        let _e11072 = local_79;
                                        phi_5146_ = _e11072;
                                        let _e11075 = local_80;
                                        phi_5147_ = _e11075;
                                        let _e11078 = local_81;
                                        phi_5148_ = _e11078;
                                        let _e11081 = local_82;
                                        phi_5149_ = _e11081;
                                    }
                                    let _e7621 = phi_5145_;
                                    let _e7623 = phi_5146_;
                                    let _e7625 = phi_5147_;
                                    let _e7627 = phi_5148_;
                                    let _e7629 = phi_5149_;
                                    if _e7621 {
                                        let _e7631 = local_43;
                                        phi_5154_ = type_28(1u, _e7631);
                                        phi_5155_ = false;
                                        phi_5156_ = false;
                                        phi_5157_ = false;
                                        phi_5158_ = false;
                                        phi_5159_ = false;
                                    } else {
                                        phi_5154_ = type_28();
                                        phi_5155_ = _e7623;
                                        phi_5156_ = _e7625;
                                        let _e11088 = local_83;
                                        phi_5157_ = _e11088;
                                        phi_5158_ = _e7627;
                                        phi_5159_ = _e7629;
                                    }
                                    let _e7634 = phi_5154_;
                                    let _e7636 = phi_5155_;
                                    let _e7638 = phi_5156_;
                                    let _e7640 = phi_5157_;
                                    let _e7642 = phi_5158_;
                                    let _e7644 = phi_5159_;
                                    if _e7636 {
                                        phi_5164_ = type_28(0u, type_28().member_1);
                                        phi_5165_ = false;
                                        phi_5166_ = false;
                                        phi_5167_ = false;
                                        phi_5168_ = false;
                                        phi_5169_ = true;
                                    } else {
                                        phi_5164_ = _e7634;
                                        phi_5165_ = _e7638;
                                        phi_5166_ = _e7640;
                                        phi_5167_ = _e7642;
                                        phi_5168_ = _e7644;
                                        phi_5169_ = _e7621;
                                    }
                                    let _e7648 = phi_5164_;
                                    let _e7650 = phi_5165_;
                                    let _e7652 = phi_5166_;
                                    let _e7654 = phi_5167_;
                                    let _e7656 = phi_5168_;
                                    let _e7658 = phi_5169_;
                                    if _e7650 {
                                        let _e11099 = local_84;
                                        phi_5173_ = _e11099;
                                        phi_5174_ = true;
                                        phi_5175_ = false;
                                        phi_5176_ = false;
                                        phi_5177_ = false;
                                    } else {
                                        let _e11101 = local_85;
                                        phi_5173_ = _e11101;
                                        phi_5174_ = _e7652;
                                        phi_5175_ = _e7654;
                                        phi_5176_ = _e7656;
                                        phi_5177_ = _e7658;
                                    }
                                    let _e7660 = phi_5173_;
                                    let _e7662 = phi_5174_;
                                    let _e7664 = phi_5175_;
                                    let _e7666 = phi_5176_;
                                    let _e7668 = phi_5177_;
                                    if _e7662 {
                                        phi_5181_ = _e7660;
                                        phi_5182_ = true;
                                        phi_5183_ = false;
                                        phi_5184_ = false;
                                    } else {
                                        let _e11108 = local_86;
                                        phi_5181_ = _e11108;
                                        phi_5182_ = _e7664;
                                        phi_5183_ = _e7666;
                                        phi_5184_ = _e7668;
                                    }
                                    let _e7670 = phi_5181_;
                                    let _e7672 = phi_5182_;
                                    let _e7674 = phi_5183_;
                                    let _e7676 = phi_5184_;
                                    if _e7672 {
                                        phi_5189_ = type_28(1u, _e7670);
                                        phi_5190_ = false;
                                        phi_5191_ = false;
                                    } else {
                                        phi_5189_ = type_28();
                                        phi_5190_ = _e7674;
                                        phi_5191_ = _e7676;
                                    }
                                    let _e7679 = phi_5189_;
                                    let _e7681 = phi_5190_;
                                    let _e7683 = phi_5191_;
                                    if _e7681 {
                                        phi_5196_ = type_28(0u, type_28().member_1);
                                        phi_5197_ = true;
                                    } else {
                                        phi_5196_ = _e7648;
                                        phi_5197_ = _e7683;
                                    }
                                    let _e7687 = phi_5196_;
                                    let _e7689 = phi_5197_;
                                    if _e7689 {
                                        phi_5201_ = _e7687;
                                    } else {
                                        phi_5201_ = _e7679;
                                    }
                                    let _e7691 = phi_5201_;
                                    phi_5208_ = _e7691.member_1;
                                    phi_5209_ = (_e7691.member != 0u);
                                } else {
                                    phi_5208_ = _e5909;
                                    phi_5209_ = true;
                                }
                                let _e7696 = phi_5208_;
                                let _e7698 = phi_5209_;
                                if _e7698 {
                                    let _e7699 = (_e7696 > _e280);
                                    if _e7699 {
                                        phi_7369_ = f32();
                                        phi_7370_ = u32();
                                        phi_7371_ = f32();
                                        phi_7372_ = type_40();
                                        phi_7373_ = u32();
                                        phi_7374_ = u32();
                                        phi_7375_ = false;
                                        phi_7376_ = false;
                                        phi_7377_ = false;
                                    } else {
                                        let _e7702 = local_18.member[0u];
                                        let _e7708 = local_18.member[1u];
                                        let _e7724 = local_18.member_1[0u];
                                        let _e7730 = local_18.member_1[1u];
                                        let _e7746 = local_18.member_2[0u];
                                        let _e7752 = local_18.member_2[1u];
                                        let _e7766 = function_2(array<f32, 3>((_e7702[0] + ((_e7708[0] - _e7702[0]) * _e5913)), (_e7702[1] + ((_e7708[1] - _e7702[1]) * _e5913)), (_e7702[2] + ((_e7708[2] - _e7702[2]) * _e5913))), array<f32, 3>((_e7724[0] + ((_e7730[0] - _e7724[0]) * _e5913)), (_e7724[1] + ((_e7730[1] - _e7724[1]) * _e5913)), (_e7724[2] + ((_e7730[2] - _e7724[2]) * _e5913))), array<f32, 3>((_e7746[0] + ((_e7752[0] - _e7746[0]) * _e5913)), (_e7746[1] + ((_e7752[1] - _e7746[1]) * _e5913)), (_e7746[2] + ((_e7752[2] - _e7746[2]) * _e5913))), 0u);
                                        if (_e7766[0] < 0f) {
                                            phi_5321_ = -(_e7766[0]);
                                        } else {
                                            phi_5321_ = _e7766[0];
                                        }
                                        let _e7771 = phi_5321_;
                                        if (_e7766[1] < 0f) {
                                            phi_5328_ = -(_e7766[1]);
                                        } else {
                                            phi_5328_ = _e7766[1];
                                        }
                                        let _e7776 = phi_5328_;
                                        if (_e7766[2] < 0f) {
                                            phi_5336_ = -(_e7766[2]);
                                        } else {
                                            phi_5336_ = _e7766[2];
                                        }
                                        let _e7782 = phi_5336_;
                                        let _e7783 = ((_e7771 + _e7776) + _e7782);
                                        let _e7786 = local_18.member[0u];
                                        let _e7792 = local_18.member_1[0u];
                                        let _e7798 = local_18.member_2[0u];
                                        let _e7810 = local_18.member[1u];
                                        let _e7816 = local_18.member_1[1u];
                                        let _e7822 = local_18.member_2[1u];
                                        let _e7834 = local_18.member[0u];
                                        if (_e7834[0] < 0f) {
                                            phi_5487_ = -(_e7834[0]);
                                        } else {
                                            phi_5487_ = _e7834[0];
                                        }
                                        let _e7841 = phi_5487_;
                                        if (_e7834[1] < 0f) {
                                            phi_5494_ = -(_e7834[1]);
                                        } else {
                                            phi_5494_ = _e7834[1];
                                        }
                                        let _e7845 = phi_5494_;
                                        if (_e7841 > _e7845) {
                                            phi_5499_ = _e7841;
                                        } else {
                                            phi_5499_ = _e7845;
                                        }
                                        let _e7848 = phi_5499_;
                                        if (_e7834[2] < 0f) {
                                            phi_5506_ = -(_e7834[2]);
                                        } else {
                                            phi_5506_ = _e7834[2];
                                        }
                                        let _e7852 = phi_5506_;
                                        if (_e7848 > _e7852) {
                                            phi_5511_ = _e7848;
                                        } else {
                                            phi_5511_ = _e7852;
                                        }
                                        let _e7855 = phi_5511_;
                                        let _e7858 = local_18.member[1u];
                                        if (_e7858[0] < 0f) {
                                            phi_5524_ = -(_e7858[0]);
                                        } else {
                                            phi_5524_ = _e7858[0];
                                        }
                                        let _e7865 = phi_5524_;
                                        if (_e7858[1] < 0f) {
                                            phi_5531_ = -(_e7858[1]);
                                        } else {
                                            phi_5531_ = _e7858[1];
                                        }
                                        let _e7869 = phi_5531_;
                                        if (_e7865 > _e7869) {
                                            phi_5536_ = _e7865;
                                        } else {
                                            phi_5536_ = _e7869;
                                        }
                                        let _e7872 = phi_5536_;
                                        if (_e7858[2] < 0f) {
                                            phi_5543_ = -(_e7858[2]);
                                        } else {
                                            phi_5543_ = _e7858[2];
                                        }
                                        let _e7876 = phi_5543_;
                                        if (_e7872 > _e7876) {
                                            phi_5548_ = _e7872;
                                        } else {
                                            phi_5548_ = _e7876;
                                        }
                                        let _e7879 = phi_5548_;
                                        if (_e7855 > _e7879) {
                                            phi_5553_ = _e7855;
                                        } else {
                                            phi_5553_ = _e7879;
                                        }
                                        let _e7882 = phi_5553_;
                                        let _e7884 = local_18.member_3;
                                        let _e7888 = local_18.member_1[0u];
                                        if (_e7888[0] < 0f) {
                                            phi_5570_ = -(_e7888[0]);
                                        } else {
                                            phi_5570_ = _e7888[0];
                                        }
                                        let _e7895 = phi_5570_;
                                        if (_e7888[1] < 0f) {
                                            phi_5577_ = -(_e7888[1]);
                                        } else {
                                            phi_5577_ = _e7888[1];
                                        }
                                        let _e7899 = phi_5577_;
                                        if (_e7895 > _e7899) {
                                            phi_5582_ = _e7895;
                                        } else {
                                            phi_5582_ = _e7899;
                                        }
                                        let _e7902 = phi_5582_;
                                        if (_e7888[2] < 0f) {
                                            phi_5589_ = -(_e7888[2]);
                                        } else {
                                            phi_5589_ = _e7888[2];
                                        }
                                        let _e7906 = phi_5589_;
                                        if (_e7902 > _e7906) {
                                            phi_5594_ = _e7902;
                                        } else {
                                            phi_5594_ = _e7906;
                                        }
                                        let _e7909 = phi_5594_;
                                        let _e7912 = local_18.member_1[1u];
                                        if (_e7912[0] < 0f) {
                                            phi_5608_ = -(_e7912[0]);
                                        } else {
                                            phi_5608_ = _e7912[0];
                                        }
                                        let _e7919 = phi_5608_;
                                        if (_e7912[1] < 0f) {
                                            phi_5615_ = -(_e7912[1]);
                                        } else {
                                            phi_5615_ = _e7912[1];
                                        }
                                        let _e7923 = phi_5615_;
                                        if (_e7919 > _e7923) {
                                            phi_5620_ = _e7919;
                                        } else {
                                            phi_5620_ = _e7923;
                                        }
                                        let _e7926 = phi_5620_;
                                        if (_e7912[2] < 0f) {
                                            phi_5627_ = -(_e7912[2]);
                                        } else {
                                            phi_5627_ = _e7912[2];
                                        }
                                        let _e7930 = phi_5627_;
                                        if (_e7926 > _e7930) {
                                            phi_5632_ = _e7926;
                                        } else {
                                            phi_5632_ = _e7930;
                                        }
                                        let _e7933 = phi_5632_;
                                        if (_e7909 > _e7933) {
                                            phi_5637_ = _e7909;
                                        } else {
                                            phi_5637_ = _e7933;
                                        }
                                        let _e7936 = phi_5637_;
                                        let _e7938 = local_18.member_3;
                                        let _e7942 = local_18.member_2[0u];
                                        if (_e7942[0] < 0f) {
                                            phi_5654_ = -(_e7942[0]);
                                        } else {
                                            phi_5654_ = _e7942[0];
                                        }
                                        let _e7949 = phi_5654_;
                                        if (_e7942[1] < 0f) {
                                            phi_5661_ = -(_e7942[1]);
                                        } else {
                                            phi_5661_ = _e7942[1];
                                        }
                                        let _e7953 = phi_5661_;
                                        if (_e7949 > _e7953) {
                                            phi_5666_ = _e7949;
                                        } else {
                                            phi_5666_ = _e7953;
                                        }
                                        let _e7956 = phi_5666_;
                                        if (_e7942[2] < 0f) {
                                            phi_5673_ = -(_e7942[2]);
                                        } else {
                                            phi_5673_ = _e7942[2];
                                        }
                                        let _e7960 = phi_5673_;
                                        if (_e7956 > _e7960) {
                                            phi_5678_ = _e7956;
                                        } else {
                                            phi_5678_ = _e7960;
                                        }
                                        let _e7963 = phi_5678_;
                                        let _e7966 = local_18.member_2[1u];
                                        if (_e7966[0] < 0f) {
                                            phi_5692_ = -(_e7966[0]);
                                        } else {
                                            phi_5692_ = _e7966[0];
                                        }
                                        let _e7973 = phi_5692_;
                                        if (_e7966[1] < 0f) {
                                            phi_5699_ = -(_e7966[1]);
                                        } else {
                                            phi_5699_ = _e7966[1];
                                        }
                                        let _e7977 = phi_5699_;
                                        if (_e7973 > _e7977) {
                                            phi_5704_ = _e7973;
                                        } else {
                                            phi_5704_ = _e7977;
                                        }
                                        let _e7980 = phi_5704_;
                                        if (_e7966[2] < 0f) {
                                            phi_5711_ = -(_e7966[2]);
                                        } else {
                                            phi_5711_ = _e7966[2];
                                        }
                                        let _e7984 = phi_5711_;
                                        if (_e7980 > _e7984) {
                                            phi_5716_ = _e7980;
                                        } else {
                                            phi_5716_ = _e7984;
                                        }
                                        let _e7987 = phi_5716_;
                                        if (_e7963 > _e7987) {
                                            phi_5721_ = _e7963;
                                        } else {
                                            phi_5721_ = _e7987;
                                        }
                                        let _e7990 = phi_5721_;
                                        let _e7992 = local_18.member_3;
                                        let _e7999 = local_18.member_3;
                                        local_14 = type_37(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e7786, array<f32, 3>((_e7786[0] - _e7792[0]), (_e7786[1] - _e7792[1]), (_e7786[2] - _e7792[2])), array<f32, 3>((_e7786[0] - _e7798[0]), (_e7786[1] - _e7798[1]), (_e7786[2] - _e7798[2])), _e7786), array<array<f32, 3>, 4>(_e7810, array<f32, 3>((_e7810[0] - _e7816[0]), (_e7810[1] - _e7816[1]), (_e7810[2] - _e7816[2])), array<f32, 3>((_e7810[0] - _e7822[0]), (_e7810[1] - _e7822[1]), (_e7810[2] - _e7822[2])), _e7810)), ((((((_e7882 + _e7884) + (_e7936 + _e7938)) + (_e7990 + _e7992)) * (0.000000059604645f * 16f)) + (_e7999 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e480.member_1);
                                        let _e8013 = local_14.member_1;
                                        if (_e7783 > _e8013) {
                                            if ((bitcast<u32>(_e7783) & 2139095040u) != 2139095040u) {
                                                let _e8018 = (1f / _e7783);
                                                let _e8020 = (_e7766[0] * _e8018);
                                                let _e8022 = (_e7766[1] * _e8018);
                                                let _e8024 = (_e7766[2] * _e8018);
                                                let _e8029 = (((_e8020 * _e8020) + (_e8022 * _e8022)) + (_e8024 * _e8024));
                                                if (_e8029 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8029 > 0f) {
                                                        phi_5822_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5822_ = 0f;
                                                    }
                                                    let _e8082 = phi_5822_;
                                                    phi_5886_ = _e8082;
                                                } else {
                                                    phi_5829_ = type_14(0i, 5i);
                                                    phi_5832_ = bitcast<f32>(((bitcast<u32>(_e8029) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8037 = phi_5829_;
                                                        let _e8039 = phi_5832_;
                                                        local_44 = _e8039;
                                                        if (_e8037.member < _e8037.member_1) {
                                                            let _e8046 = (_e8037.member + 1i);
                                                            if ((false == (_e8046 > _e8037.member)) != false) {
                                                                phi_5853_ = true;
                                                            } else {
                                                                phi_5853_ = false;
                                                            }
                                                            let _e8051 = phi_5853_;
                                                            if _e8051 {
                                                                phi_5859_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_5859_ = type_15(1u, _e8046);
                                                            }
                                                            let _e8056 = phi_5859_;
                                                            phi_5830_ = type_14(_e8056.member_1, _e8037.member_1);
                                                            phi_5873_ = type_15(1u, _e8037.member);
                                                        } else {
                                                            phi_5830_ = _e8037;
                                                            phi_5873_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8062 = phi_5830_;
                                                        let _e8064 = phi_5873_;
                                                        let _e8067 = (bitcast<i32>(_e8064.member) != 0i);
                                                        if _e8067 {
                                                            phi_5833_ = (0.5f * (_e8039 + (_e8029 / _e8039)));
                                                        } else {
                                                            phi_5833_ = f32();
                                                        }
                                                        let _e8072 = phi_5833_;
                                                        continue;
                                                        continuing {
                                                            phi_5829_ = _e8062;
                                                            phi_5832_ = _e8072;
                                                            break if !(_e8067);
                                                        }
                                                    }
                                                    let _e8077 = local_44;
                                                    phi_5886_ = (_e8077 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8084 = phi_5886_;
                                                let _e8085 = (0.000000059604645f * 12f);
                                                let _e8087 = local_14.member_1;
                                                let _e8090 = local_14.member_2;
                                                let _e8094 = ((_e8087 * 1.01f) + ((_e8090 * _e8084) * (1f + _e8085)));
                                                let _e8098 = local_14.member[0u][0u];
                                                let _e8106 = (((_e8020 * _e8098[0]) + (_e8022 * _e8098[1])) + (_e8024 * _e8098[2]));
                                                let _e8110 = local_14.member[0u][1u];
                                                let _e8118 = (((_e8020 * _e8110[0]) + (_e8022 * _e8110[1])) + (_e8024 * _e8110[2]));
                                                let _e8122 = local_14.member[0u][2u];
                                                let _e8130 = (((_e8020 * _e8122[0]) + (_e8022 * _e8122[1])) + (_e8024 * _e8122[2]));
                                                let _e8134 = local_14.member[0u][3u];
                                                let _e8142 = (((_e8020 * _e8134[0]) + (_e8022 * _e8134[1])) + (_e8024 * _e8134[2]));
                                                let _e8146 = local_14.member[1u][0u];
                                                let _e8154 = (((_e8020 * _e8146[0]) + (_e8022 * _e8146[1])) + (_e8024 * _e8146[2]));
                                                let _e8158 = local_14.member[1u][1u];
                                                let _e8166 = (((_e8020 * _e8158[0]) + (_e8022 * _e8158[1])) + (_e8024 * _e8158[2]));
                                                let _e8170 = local_14.member[1u][2u];
                                                let _e8178 = (((_e8020 * _e8170[0]) + (_e8022 * _e8170[1])) + (_e8024 * _e8170[2]));
                                                let _e8182 = local_14.member[1u][3u];
                                                let _e8190 = (((_e8020 * _e8182[0]) + (_e8022 * _e8182[1])) + (_e8024 * _e8182[2]));
                                                if (_e8106 < 0f) {
                                                    phi_6020_ = -(_e8106);
                                                } else {
                                                    phi_6020_ = _e8106;
                                                }
                                                let _e8194 = phi_6020_;
                                                if (_e8154 < 0f) {
                                                    phi_6026_ = -(_e8154);
                                                } else {
                                                    phi_6026_ = _e8154;
                                                }
                                                let _e8198 = phi_6026_;
                                                if (_e8118 < 0f) {
                                                    phi_6035_ = -(_e8118);
                                                } else {
                                                    phi_6035_ = _e8118;
                                                }
                                                let _e8205 = phi_6035_;
                                                if (_e8166 < 0f) {
                                                    phi_6041_ = -(_e8166);
                                                } else {
                                                    phi_6041_ = _e8166;
                                                }
                                                let _e8209 = phi_6041_;
                                                if (_e8130 < 0f) {
                                                    phi_6050_ = -(_e8130);
                                                } else {
                                                    phi_6050_ = _e8130;
                                                }
                                                let _e8216 = phi_6050_;
                                                if (_e8178 < 0f) {
                                                    phi_6056_ = -(_e8178);
                                                } else {
                                                    phi_6056_ = _e8178;
                                                }
                                                let _e8220 = phi_6056_;
                                                if (_e8142 < 0f) {
                                                    phi_6065_ = -(_e8142);
                                                } else {
                                                    phi_6065_ = _e8142;
                                                }
                                                let _e8227 = phi_6065_;
                                                if (_e8190 < 0f) {
                                                    phi_6071_ = -(_e8190);
                                                } else {
                                                    phi_6071_ = _e8190;
                                                }
                                                let _e8231 = phi_6071_;
                                                local_15 = type_32(array<f32, 4>(_e8106, _e8118, _e8130, _e8142), array<f32, 4>(_e8154, _e8166, _e8178, _e8190), array<f32, 4>((_e8094 + ((_e8194 + _e8198) * _e8085)), (_e8094 + ((_e8205 + _e8209) * _e8085)), (_e8094 + ((_e8216 + _e8220) * _e8085)), (_e8094 + ((_e8227 + _e8231) * _e8085))));
                                                let _e8243 = (((_e8020 * _e8020) + (_e8022 * _e8022)) + (_e8024 * _e8024));
                                                if (_e8243 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8243 > 0f) {
                                                        phi_6114_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_6114_ = 0f;
                                                    }
                                                    let _e8296 = phi_6114_;
                                                    phi_6178_ = _e8296;
                                                } else {
                                                    phi_6121_ = type_14(0i, 5i);
                                                    phi_6124_ = bitcast<f32>(((bitcast<u32>(_e8243) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8251 = phi_6121_;
                                                        let _e8253 = phi_6124_;
                                                        local_45 = _e8253;
                                                        if (_e8251.member < _e8251.member_1) {
                                                            let _e8260 = (_e8251.member + 1i);
                                                            if ((false == (_e8260 > _e8251.member)) != false) {
                                                                phi_6145_ = true;
                                                            } else {
                                                                phi_6145_ = false;
                                                            }
                                                            let _e8265 = phi_6145_;
                                                            if _e8265 {
                                                                phi_6151_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_6151_ = type_15(1u, _e8260);
                                                            }
                                                            let _e8270 = phi_6151_;
                                                            phi_6122_ = type_14(_e8270.member_1, _e8251.member_1);
                                                            phi_6165_ = type_15(1u, _e8251.member);
                                                        } else {
                                                            phi_6122_ = _e8251;
                                                            phi_6165_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8276 = phi_6122_;
                                                        let _e8278 = phi_6165_;
                                                        let _e8281 = (bitcast<i32>(_e8278.member) != 0i);
                                                        if _e8281 {
                                                            phi_6125_ = (0.5f * (_e8253 + (_e8243 / _e8253)));
                                                        } else {
                                                            phi_6125_ = f32();
                                                        }
                                                        let _e8286 = phi_6125_;
                                                        continue;
                                                        continuing {
                                                            phi_6121_ = _e8276;
                                                            phi_6124_ = _e8286;
                                                            break if !(_e8281);
                                                        }
                                                    }
                                                    let _e8291 = local_45;
                                                    phi_6178_ = (_e8291 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8298 = phi_6178_;
                                                let _e8309 = (((_e7766[0] * _e7766[0]) + (_e7766[1] * _e7766[1])) + (_e7766[2] * _e7766[2]));
                                                if (_e8309 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8309 > 0f) {
                                                        phi_6203_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_6203_ = 0f;
                                                    }
                                                    let _e8362 = phi_6203_;
                                                    phi_6267_ = _e8362;
                                                } else {
                                                    phi_6210_ = type_14(0i, 5i);
                                                    phi_6213_ = bitcast<f32>(((bitcast<u32>(_e8309) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8317 = phi_6210_;
                                                        let _e8319 = phi_6213_;
                                                        local_46 = _e8319;
                                                        if (_e8317.member < _e8317.member_1) {
                                                            let _e8326 = (_e8317.member + 1i);
                                                            if ((false == (_e8326 > _e8317.member)) != false) {
                                                                phi_6234_ = true;
                                                            } else {
                                                                phi_6234_ = false;
                                                            }
                                                            let _e8331 = phi_6234_;
                                                            if _e8331 {
                                                                phi_6240_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_6240_ = type_15(1u, _e8326);
                                                            }
                                                            let _e8336 = phi_6240_;
                                                            phi_6211_ = type_14(_e8336.member_1, _e8317.member_1);
                                                            phi_6254_ = type_15(1u, _e8317.member);
                                                        } else {
                                                            phi_6211_ = _e8317;
                                                            phi_6254_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8342 = phi_6211_;
                                                        let _e8344 = phi_6254_;
                                                        let _e8347 = (bitcast<i32>(_e8344.member) != 0i);
                                                        if _e8347 {
                                                            phi_6214_ = (0.5f * (_e8319 + (_e8309 / _e8319)));
                                                        } else {
                                                            phi_6214_ = f32();
                                                        }
                                                        let _e8352 = phi_6214_;
                                                        continue;
                                                        continuing {
                                                            phi_6210_ = _e8342;
                                                            phi_6213_ = _e8352;
                                                            break if !(_e8347);
                                                        }
                                                    }
                                                    let _e8357 = local_46;
                                                    phi_6267_ = (_e8357 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8364 = phi_6267_;
                                                let _e8370 = local_18.member[0u];
                                                if (_e8370[0] < 0f) {
                                                    phi_6283_ = -(_e8370[0]);
                                                } else {
                                                    phi_6283_ = _e8370[0];
                                                }
                                                let _e8377 = phi_6283_;
                                                if (_e8370[1] < 0f) {
                                                    phi_6290_ = -(_e8370[1]);
                                                } else {
                                                    phi_6290_ = _e8370[1];
                                                }
                                                let _e8381 = phi_6290_;
                                                if (_e8377 > _e8381) {
                                                    phi_6295_ = _e8377;
                                                } else {
                                                    phi_6295_ = _e8381;
                                                }
                                                let _e8384 = phi_6295_;
                                                if (_e8370[2] < 0f) {
                                                    phi_6302_ = -(_e8370[2]);
                                                } else {
                                                    phi_6302_ = _e8370[2];
                                                }
                                                let _e8388 = phi_6302_;
                                                if (_e8384 > _e8388) {
                                                    phi_6307_ = _e8384;
                                                } else {
                                                    phi_6307_ = _e8388;
                                                }
                                                let _e8391 = phi_6307_;
                                                let _e8394 = local_18.member[1u];
                                                if (_e8394[0] < 0f) {
                                                    phi_6320_ = -(_e8394[0]);
                                                } else {
                                                    phi_6320_ = _e8394[0];
                                                }
                                                let _e8401 = phi_6320_;
                                                if (_e8394[1] < 0f) {
                                                    phi_6327_ = -(_e8394[1]);
                                                } else {
                                                    phi_6327_ = _e8394[1];
                                                }
                                                let _e8405 = phi_6327_;
                                                if (_e8401 > _e8405) {
                                                    phi_6332_ = _e8401;
                                                } else {
                                                    phi_6332_ = _e8405;
                                                }
                                                let _e8408 = phi_6332_;
                                                if (_e8394[2] < 0f) {
                                                    phi_6339_ = -(_e8394[2]);
                                                } else {
                                                    phi_6339_ = _e8394[2];
                                                }
                                                let _e8412 = phi_6339_;
                                                if (_e8408 > _e8412) {
                                                    phi_6344_ = _e8408;
                                                } else {
                                                    phi_6344_ = _e8412;
                                                }
                                                let _e8415 = phi_6344_;
                                                if (_e8391 > _e8415) {
                                                    phi_6349_ = _e8391;
                                                } else {
                                                    phi_6349_ = _e8415;
                                                }
                                                let _e8418 = phi_6349_;
                                                let _e8420 = local_18.member_3;
                                                let _e8424 = local_18.member_1[0u];
                                                if (_e8424[0] < 0f) {
                                                    phi_6366_ = -(_e8424[0]);
                                                } else {
                                                    phi_6366_ = _e8424[0];
                                                }
                                                let _e8431 = phi_6366_;
                                                if (_e8424[1] < 0f) {
                                                    phi_6373_ = -(_e8424[1]);
                                                } else {
                                                    phi_6373_ = _e8424[1];
                                                }
                                                let _e8435 = phi_6373_;
                                                if (_e8431 > _e8435) {
                                                    phi_6378_ = _e8431;
                                                } else {
                                                    phi_6378_ = _e8435;
                                                }
                                                let _e8438 = phi_6378_;
                                                if (_e8424[2] < 0f) {
                                                    phi_6385_ = -(_e8424[2]);
                                                } else {
                                                    phi_6385_ = _e8424[2];
                                                }
                                                let _e8442 = phi_6385_;
                                                if (_e8438 > _e8442) {
                                                    phi_6390_ = _e8438;
                                                } else {
                                                    phi_6390_ = _e8442;
                                                }
                                                let _e8445 = phi_6390_;
                                                let _e8448 = local_18.member_1[1u];
                                                if (_e8448[0] < 0f) {
                                                    phi_6404_ = -(_e8448[0]);
                                                } else {
                                                    phi_6404_ = _e8448[0];
                                                }
                                                let _e8455 = phi_6404_;
                                                if (_e8448[1] < 0f) {
                                                    phi_6411_ = -(_e8448[1]);
                                                } else {
                                                    phi_6411_ = _e8448[1];
                                                }
                                                let _e8459 = phi_6411_;
                                                if (_e8455 > _e8459) {
                                                    phi_6416_ = _e8455;
                                                } else {
                                                    phi_6416_ = _e8459;
                                                }
                                                let _e8462 = phi_6416_;
                                                if (_e8448[2] < 0f) {
                                                    phi_6423_ = -(_e8448[2]);
                                                } else {
                                                    phi_6423_ = _e8448[2];
                                                }
                                                let _e8466 = phi_6423_;
                                                if (_e8462 > _e8466) {
                                                    phi_6428_ = _e8462;
                                                } else {
                                                    phi_6428_ = _e8466;
                                                }
                                                let _e8469 = phi_6428_;
                                                if (_e8445 > _e8469) {
                                                    phi_6433_ = _e8445;
                                                } else {
                                                    phi_6433_ = _e8469;
                                                }
                                                let _e8472 = phi_6433_;
                                                let _e8474 = local_18.member_3;
                                                let _e8478 = local_18.member_2[0u];
                                                if (_e8478[0] < 0f) {
                                                    phi_6450_ = -(_e8478[0]);
                                                } else {
                                                    phi_6450_ = _e8478[0];
                                                }
                                                let _e8485 = phi_6450_;
                                                if (_e8478[1] < 0f) {
                                                    phi_6457_ = -(_e8478[1]);
                                                } else {
                                                    phi_6457_ = _e8478[1];
                                                }
                                                let _e8489 = phi_6457_;
                                                if (_e8485 > _e8489) {
                                                    phi_6462_ = _e8485;
                                                } else {
                                                    phi_6462_ = _e8489;
                                                }
                                                let _e8492 = phi_6462_;
                                                if (_e8478[2] < 0f) {
                                                    phi_6469_ = -(_e8478[2]);
                                                } else {
                                                    phi_6469_ = _e8478[2];
                                                }
                                                let _e8496 = phi_6469_;
                                                if (_e8492 > _e8496) {
                                                    phi_6474_ = _e8492;
                                                } else {
                                                    phi_6474_ = _e8496;
                                                }
                                                let _e8499 = phi_6474_;
                                                let _e8502 = local_18.member_2[1u];
                                                if (_e8502[0] < 0f) {
                                                    phi_6488_ = -(_e8502[0]);
                                                } else {
                                                    phi_6488_ = _e8502[0];
                                                }
                                                let _e8509 = phi_6488_;
                                                if (_e8502[1] < 0f) {
                                                    phi_6495_ = -(_e8502[1]);
                                                } else {
                                                    phi_6495_ = _e8502[1];
                                                }
                                                let _e8513 = phi_6495_;
                                                if (_e8509 > _e8513) {
                                                    phi_6500_ = _e8509;
                                                } else {
                                                    phi_6500_ = _e8513;
                                                }
                                                let _e8516 = phi_6500_;
                                                if (_e8502[2] < 0f) {
                                                    phi_6507_ = -(_e8502[2]);
                                                } else {
                                                    phi_6507_ = _e8502[2];
                                                }
                                                let _e8520 = phi_6507_;
                                                if (_e8516 > _e8520) {
                                                    phi_6512_ = _e8516;
                                                } else {
                                                    phi_6512_ = _e8520;
                                                }
                                                let _e8523 = phi_6512_;
                                                if (_e8499 > _e8523) {
                                                    phi_6517_ = _e8499;
                                                } else {
                                                    phi_6517_ = _e8523;
                                                }
                                                let _e8526 = phi_6517_;
                                                let _e8528 = local_18.member_3;
                                                let _e8535 = local_18.member_3;
                                                let _e8545 = ((((_e8364 * (1f + (0.000000059604645f * 8f))) + (((((((_e8418 + _e8420) + (_e8472 + _e8474)) + (_e8526 + _e8528)) * (0.000000059604645f * 16f)) + (_e8535 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e8298) * (1f + (0.000000059604645f * 64f)));
                                                let _e8548 = local_15.member[0u];
                                                let _e8551 = local_15.member_1[0u];
                                                if (_e8548 < 0f) {
                                                    phi_6558_ = -(_e8548);
                                                } else {
                                                    phi_6558_ = _e8548;
                                                }
                                                let _e8556 = phi_6558_;
                                                if (_e8551 < 0f) {
                                                    phi_6564_ = -(_e8551);
                                                } else {
                                                    phi_6564_ = _e8551;
                                                }
                                                let _e8560 = phi_6564_;
                                                phi_6575_ = type_12(1u, 4u);
                                                phi_6578_ = ((_e8548 + ((_e8551 - _e8548) * _e5913)) - ((_e8013 * 1.01f) + ((_e8556 + _e8560) * (0.000000059604645f * 12f))));
                                                loop {
                                                    let _e8570 = phi_6575_;
                                                    let _e8572 = phi_6578_;
                                                    local_47 = _e8572;
                                                    local_48 = _e8572;
                                                    if (_e8570.member < _e8570.member_1) {
                                                        phi_6576_ = type_12((_e8570.member + 1u), _e8570.member_1);
                                                        phi_6601_ = type_12(1u, _e8570.member);
                                                    } else {
                                                        phi_6576_ = _e8570;
                                                        phi_6601_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e8584 = phi_6576_;
                                                    let _e8586 = phi_6601_;
                                                    let _e8590 = (bitcast<i32>(_e8586.member) != 0i);
                                                    if _e8590 {
                                                        let _e8593 = local_15.member[_e8586.member_1];
                                                        let _e8596 = local_15.member_1[_e8586.member_1];
                                                        if (_e8593 < 0f) {
                                                            phi_6630_ = -(_e8593);
                                                        } else {
                                                            phi_6630_ = _e8593;
                                                        }
                                                        let _e8601 = phi_6630_;
                                                        if (_e8596 < 0f) {
                                                            phi_6636_ = -(_e8596);
                                                        } else {
                                                            phi_6636_ = _e8596;
                                                        }
                                                        let _e8605 = phi_6636_;
                                                        let _e8613 = ((_e8593 + ((_e8596 - _e8593) * _e5913)) - ((_e8013 * 1.01f) + ((_e8601 + _e8605) * (0.000000059604645f * 12f))));
                                                        if (_e8572 < _e8613) {
                                                            phi_6649_ = _e8572;
                                                        } else {
                                                            phi_6649_ = _e8613;
                                                        }
                                                        let _e8616 = phi_6649_;
                                                        phi_6579_ = _e8616;
                                                    } else {
                                                        phi_6579_ = f32();
                                                    }
                                                    let _e8618 = phi_6579_;
                                                    continue;
                                                    continuing {
                                                        phi_6575_ = _e8584;
                                                        phi_6578_ = _e8618;
                                                        break if !(_e8590);
                                                    }
                                                }
                                                let _e8621 = local_47;
                                                if (_e8621 > 0f) {
                                                    let _e8625 = local_48;
                                                    let _e8628 = (((_e8545 - _e8625) / _e8545) * 2.02f);
                                                    if (_e8628 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e8628 > 0f) {
                                                            phi_6670_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_6670_ = 0f;
                                                        }
                                                        let _e8681 = phi_6670_;
                                                        phi_6734_ = _e8681;
                                                    } else {
                                                        phi_6677_ = type_14(0i, 5i);
                                                        phi_6680_ = bitcast<f32>(((bitcast<u32>(_e8628) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e8636 = phi_6677_;
                                                            let _e8638 = phi_6680_;
                                                            local_49 = _e8638;
                                                            if (_e8636.member < _e8636.member_1) {
                                                                let _e8645 = (_e8636.member + 1i);
                                                                if ((false == (_e8645 > _e8636.member)) != false) {
                                                                    phi_6701_ = true;
                                                                } else {
                                                                    phi_6701_ = false;
                                                                }
                                                                let _e8650 = phi_6701_;
                                                                if _e8650 {
                                                                    phi_6707_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_6707_ = type_15(1u, _e8645);
                                                                }
                                                                let _e8655 = phi_6707_;
                                                                phi_6678_ = type_14(_e8655.member_1, _e8636.member_1);
                                                                phi_6721_ = type_15(1u, _e8636.member);
                                                            } else {
                                                                phi_6678_ = _e8636;
                                                                phi_6721_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e8661 = phi_6678_;
                                                            let _e8663 = phi_6721_;
                                                            let _e8666 = (bitcast<i32>(_e8663.member) != 0i);
                                                            if _e8666 {
                                                                phi_6681_ = (0.5f * (_e8638 + (_e8628 / _e8638)));
                                                            } else {
                                                                phi_6681_ = f32();
                                                            }
                                                            let _e8671 = phi_6681_;
                                                            continue;
                                                            continuing {
                                                                phi_6677_ = _e8661;
                                                                phi_6680_ = _e8671;
                                                                break if !(_e8666);
                                                            }
                                                        }
                                                        let _e8676 = local_49;
                                                        phi_6734_ = (_e8676 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e8683 = phi_6734_;
                                                    let _e8685 = ((_e8683 * _e8298) * 1.01f);
                                                    phi_6739_ = type_12(0u, 4u);
                                                    phi_6742_ = 2f;
                                                    phi_6744_ = true;
                                                    phi_6746_ = true;
                                                    loop {
                                                        let _e8687 = phi_6739_;
                                                        let _e8689 = phi_6742_;
                                                        let _e8691 = phi_6744_;
                                                        let _e8693 = phi_6746_;
                                                        local_50 = _e8689;
                                                        local_87 = _e8689;
                                                        local_51 = _e8691;
                                                        local_52 = _e8693;
                                                        local_88 = _e8693;
                                                        local_53 = _e8693;
                                                        if (_e8687.member < _e8687.member_1) {
                                                            phi_6740_ = type_12((_e8687.member + 1u), _e8687.member_1);
                                                            phi_6769_ = type_12(1u, _e8687.member);
                                                        } else {
                                                            phi_6740_ = _e8687;
                                                            phi_6769_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e8705 = phi_6740_;
                                                        let _e8707 = phi_6769_;
                                                        let _e8711 = (bitcast<i32>(_e8707.member) != 0i);
                                                        if _e8711 {
                                                            let _e8715 = local_14.member[0u][_e8707.member_1];
                                                            let _e8722 = local_14.member[1u][_e8707.member_1];
                                                            if (_e8715[0] < 0f) {
                                                                phi_6806_ = -(_e8715[0]);
                                                            } else {
                                                                phi_6806_ = _e8715[0];
                                                            }
                                                            let _e8729 = phi_6806_;
                                                            if (_e8715[1] < 0f) {
                                                                phi_6813_ = -(_e8715[1]);
                                                            } else {
                                                                phi_6813_ = _e8715[1];
                                                            }
                                                            let _e8733 = phi_6813_;
                                                            if (_e8715[2] < 0f) {
                                                                phi_6821_ = -(_e8715[2]);
                                                            } else {
                                                                phi_6821_ = _e8715[2];
                                                            }
                                                            let _e8738 = phi_6821_;
                                                            let _e8739 = ((_e8729 + _e8733) + _e8738);
                                                            if (_e8722[0] < 0f) {
                                                                phi_6829_ = -(_e8722[0]);
                                                            } else {
                                                                phi_6829_ = _e8722[0];
                                                            }
                                                            let _e8743 = phi_6829_;
                                                            if (_e8722[1] < 0f) {
                                                                phi_6836_ = -(_e8722[1]);
                                                            } else {
                                                                phi_6836_ = _e8722[1];
                                                            }
                                                            let _e8747 = phi_6836_;
                                                            if (_e8722[2] < 0f) {
                                                                phi_6844_ = -(_e8722[2]);
                                                            } else {
                                                                phi_6844_ = _e8722[2];
                                                            }
                                                            let _e8752 = phi_6844_;
                                                            let _e8753 = ((_e8743 + _e8747) + _e8752);
                                                            if (_e8739 > _e8753) {
                                                                phi_6850_ = _e8739;
                                                            } else {
                                                                phi_6850_ = _e8753;
                                                            }
                                                            let _e8756 = phi_6850_;
                                                            let _e8760 = (_e8722[0] - _e8715[0]);
                                                            let _e8761 = (_e8722[1] - _e8715[1]);
                                                            let _e8762 = (_e8722[2] - _e8715[2]);
                                                            if (_e8760 < 0f) {
                                                                phi_6868_ = -(_e8760);
                                                            } else {
                                                                phi_6868_ = _e8760;
                                                            }
                                                            let _e8766 = phi_6868_;
                                                            if (_e8761 < 0f) {
                                                                phi_6874_ = -(_e8761);
                                                            } else {
                                                                phi_6874_ = _e8761;
                                                            }
                                                            let _e8770 = phi_6874_;
                                                            if (_e8762 < 0f) {
                                                                phi_6881_ = -(_e8762);
                                                            } else {
                                                                phi_6881_ = _e8762;
                                                            }
                                                            let _e8775 = phi_6881_;
                                                            let _e8782 = local_15.member[_e8707.member_1];
                                                            let _e8785 = local_15.member_1[_e8707.member_1];
                                                            if (_e8782 < 0f) {
                                                                phi_6907_ = -(_e8782);
                                                            } else {
                                                                phi_6907_ = _e8782;
                                                            }
                                                            let _e8790 = phi_6907_;
                                                            if (_e8785 < 0f) {
                                                                phi_6913_ = -(_e8785);
                                                            } else {
                                                                phi_6913_ = _e8785;
                                                            }
                                                            let _e8794 = phi_6913_;
                                                            let _e8798 = ((_e8013 * 1.01f) + ((_e8790 + _e8794) * (0.000000059604645f * 12f)));
                                                            let _e8805 = local_15.member_1[_e8707.member_1];
                                                            let _e8808 = local_15.member[_e8707.member_1];
                                                            let _e8809 = (_e8805 - _e8808);
                                                            let _e8812 = ((_e8798 + _e8798) + (_e8685 * ((((_e8766 + _e8770) + _e8775) + (_e8013 * 6f)) * 1.01f)));
                                                            let _e8815 = ((((_e8782 + ((_e8785 - _e8782) * _e5913)) - _e8798) - (_e8685 * ((_e8756 + (_e8013 * 3f)) * 1.01f))) - _e8545);
                                                            let _e8816 = (_e8815 > 0.000000000000000000000000000000000000011754944f);
                                                            let _e8817 = (_e8809 > _e8812);
                                                            if _e8817 {
                                                                phi_6949_ = true;
                                                            } else {
                                                                phi_6949_ = _e8816;
                                                            }
                                                            let _e8819 = phi_6949_;
                                                            if (_e8809 < -(_e8812)) {
                                                                phi_6956_ = true;
                                                            } else {
                                                                phi_6956_ = _e8816;
                                                            }
                                                            let _e8824 = phi_6956_;
                                                            if _e8817 {
                                                                phi_6977_ = _e8689;
                                                            } else {
                                                                if _e8816 {
                                                                    let _e8826 = (_e8812 - _e8809);
                                                                    if (_e8826 > 0.000000000000000000000000000000000000011754944f) {
                                                                        phi_6969_ = _e8826;
                                                                    } else {
                                                                        phi_6969_ = 0.000000000000000000000000000000000000011754944f;
                                                                    }
                                                                    let _e8829 = phi_6969_;
                                                                    let _e8830 = (_e8815 / _e8829);
                                                                    if (_e8689 < _e8830) {
                                                                        phi_6975_ = _e8689;
                                                                    } else {
                                                                        phi_6975_ = _e8830;
                                                                    }
                                                                    let _e8833 = phi_6975_;
                                                                    phi_6976_ = _e8833;
                                                                } else {
                                                                    phi_6976_ = _e8689;
                                                                }
                                                                let _e8835 = phi_6976_;
                                                                phi_6977_ = _e8835;
                                                            }
                                                            let _e8837 = phi_6977_;
                                                            phi_6743_ = _e8837;
                                                            phi_6745_ = (_e8691 && _e8824);
                                                            phi_6747_ = (_e8693 && _e8819);
                                                        } else {
                                                            phi_6743_ = f32();
                                                            phi_6745_ = bool();
                                                            phi_6747_ = bool();
                                                        }
                                                        let _e8839 = phi_6743_;
                                                        let _e8841 = phi_6745_;
                                                        let _e8843 = phi_6747_;
                                                        continue;
                                                        continuing {
                                                            phi_6739_ = _e8705;
                                                            phi_6742_ = _e8839;
                                                            phi_6744_ = _e8841;
                                                            phi_6746_ = _e8843;
                                                            break if !(_e8711);
                                                        }
                                                    }
                                                    let _e8846 = local_50;
                                                    if (_e8846 < 2f) {
                                                        let _e11279 = local_87;
                                                        phi_6982_ = _e11279;
                                                    } else {
                                                        phi_6982_ = 2f;
                                                    }
                                                    let _e8849 = phi_6982_;
                                                    let _e8850 = (_e8849 * 0.999f);
                                                    let _e8852 = local_51;
                                                    if _e8852 {
                                                        let _e8854 = local_52;
                                                        if _e8854 {
                                                            phi_6991_ = type_40();
                                                        } else {
                                                            phi_6991_ = type_40(1u, _e5913, 2f);
                                                        }
                                                        let _e8857 = phi_6991_;
                                                        phi_6992_ = _e8857;
                                                        let _e11286 = local_88;
                                                        phi_6993_ = _e11286;
                                                    } else {
                                                        phi_6992_ = type_40();
                                                        phi_6993_ = true;
                                                    }
                                                    let _e8859 = phi_6992_;
                                                    let _e8861 = phi_6993_;
                                                    if _e8861 {
                                                        let _e8863 = local_53;
                                                        if _e8863 {
                                                            if (_e8850 > (0.000000059604645f * 4096f)) {
                                                                let _e8867 = (_e5913 + _e8850);
                                                                if (_e8867 < _e282) {
                                                                    phi_7010_ = _e8867;
                                                                } else {
                                                                    phi_7010_ = _e282;
                                                                }
                                                                let _e8870 = phi_7010_;
                                                                phi_7011_ = _e8870;
                                                            } else {
                                                                phi_7011_ = _e5913;
                                                            }
                                                            let _e8872 = phi_7011_;
                                                            phi_7014_ = type_12(0u, 4u);
                                                            phi_7017_ = _e8872;
                                                            phi_7019_ = _e5913;
                                                            loop {
                                                                let _e8874 = phi_7014_;
                                                                let _e8876 = phi_7017_;
                                                                let _e8878 = phi_7019_;
                                                                local_54 = _e8876;
                                                                local_55 = _e8878;
                                                                local_56 = _e8878;
                                                                if (_e8874.member < _e8874.member_1) {
                                                                    phi_7015_ = type_12((_e8874.member + 1u), _e8874.member_1);
                                                                    phi_7042_ = type_12(1u, _e8874.member);
                                                                } else {
                                                                    phi_7015_ = _e8874;
                                                                    phi_7042_ = type_12(0u, type_12().member_1);
                                                                }
                                                                let _e8890 = phi_7015_;
                                                                let _e8892 = phi_7042_;
                                                                let _e8896 = (bitcast<i32>(_e8892.member) != 0i);
                                                                if _e8896 {
                                                                    let _e8899 = local_15.member[_e8892.member_1];
                                                                    let _e8902 = local_15.member_1[_e8892.member_1];
                                                                    let _e8905 = local_15.member[_e8892.member_1];
                                                                    let _e8911 = local_15.member_2[_e8892.member_1];
                                                                    let _e8912 = ((_e8899 + ((_e8902 - _e8905) * _e5913)) - _e8911);
                                                                    let _e8915 = local_15.member_1[_e8892.member_1];
                                                                    let _e8918 = local_15.member[_e8892.member_1];
                                                                    let _e8919 = (_e8915 - _e8918);
                                                                    if (_e8919 > 0f) {
                                                                        let _e8930 = (_e5913 - (_e8912 / _e8919));
                                                                        if (_e8878 > _e8930) {
                                                                            phi_7110_ = _e8878;
                                                                        } else {
                                                                            phi_7110_ = _e8930;
                                                                        }
                                                                        let _e8933 = phi_7110_;
                                                                        phi_7123_ = _e8876;
                                                                        phi_7124_ = _e8933;
                                                                    } else {
                                                                        if (_e8912 > 0f) {
                                                                            let _e8923 = (_e5913 - (_e8912 / _e8919));
                                                                            if (_e8876 < _e8923) {
                                                                                phi_7121_ = _e8876;
                                                                            } else {
                                                                                phi_7121_ = _e8923;
                                                                            }
                                                                            let _e8926 = phi_7121_;
                                                                            phi_7122_ = _e8926;
                                                                        } else {
                                                                            phi_7122_ = _e8876;
                                                                        }
                                                                        let _e8928 = phi_7122_;
                                                                        phi_7123_ = _e8928;
                                                                        phi_7124_ = _e8878;
                                                                    }
                                                                    let _e8935 = phi_7123_;
                                                                    let _e8937 = phi_7124_;
                                                                    phi_7018_ = _e8935;
                                                                    phi_7020_ = _e8937;
                                                                } else {
                                                                    phi_7018_ = f32();
                                                                    phi_7020_ = f32();
                                                                }
                                                                let _e8939 = phi_7018_;
                                                                let _e8941 = phi_7020_;
                                                                continue;
                                                                continuing {
                                                                    phi_7014_ = _e8890;
                                                                    phi_7017_ = _e8939;
                                                                    phi_7019_ = _e8941;
                                                                    break if !(_e8896);
                                                                }
                                                            }
                                                            let _e8944 = local_54;
                                                            let _e8946 = local_55;
                                                            let _e8950 = local_56;
                                                            let _e8951 = (_e8950 + ((_e8944 - _e8946) * 0.5f));
                                                            if (_e8951 > _e5913) {
                                                                if (_e8951 <= _e8872) {
                                                                    let _e8956 = local_15.member[0u];
                                                                    let _e8959 = local_15.member_1[0u];
                                                                    let _e8962 = local_15.member[0u];
                                                                    let _e8968 = local_15.member_2[0u];
                                                                    if (((_e8956 + ((_e8959 - _e8962) * _e8951)) - _e8968) > 0f) {
                                                                        let _e8973 = local_15.member[1u];
                                                                        let _e8976 = local_15.member_1[1u];
                                                                        let _e8979 = local_15.member[1u];
                                                                        let _e8985 = local_15.member_2[1u];
                                                                        if (((_e8973 + ((_e8976 - _e8979) * _e8951)) - _e8985) > 0f) {
                                                                            let _e8990 = local_15.member[2u];
                                                                            let _e8993 = local_15.member_1[2u];
                                                                            let _e8996 = local_15.member[2u];
                                                                            let _e9002 = local_15.member_2[2u];
                                                                            if (((_e8990 + ((_e8993 - _e8996) * _e8951)) - _e9002) > 0f) {
                                                                                let _e9007 = local_15.member[3u];
                                                                                let _e9010 = local_15.member_1[3u];
                                                                                let _e9013 = local_15.member[3u];
                                                                                let _e9019 = local_15.member_2[3u];
                                                                                phi_7285_ = (((_e9007 + ((_e9010 - _e9013) * _e8951)) - _e9019) > 0f);
                                                                                phi_7286_ = false;
                                                                            } else {
                                                                                phi_7285_ = bool();
                                                                                phi_7286_ = true;
                                                                            }
                                                                            let _e9023 = phi_7285_;
                                                                            let _e9025 = phi_7286_;
                                                                            phi_7287_ = _e9023;
                                                                            phi_7288_ = _e9025;
                                                                        } else {
                                                                            phi_7287_ = bool();
                                                                            phi_7288_ = true;
                                                                        }
                                                                        let _e9027 = phi_7287_;
                                                                        let _e9029 = phi_7288_;
                                                                        phi_7289_ = _e9027;
                                                                        phi_7290_ = _e9029;
                                                                    } else {
                                                                        phi_7289_ = bool();
                                                                        phi_7290_ = true;
                                                                    }
                                                                    let _e9031 = phi_7289_;
                                                                    let _e9033 = phi_7290_;
                                                                    if _e9033 {
                                                                        phi_7294_ = false;
                                                                    } else {
                                                                        phi_7294_ = _e9031;
                                                                    }
                                                                    let _e9035 = phi_7294_;
                                                                    if _e9035 {
                                                                        phi_7298_ = false;
                                                                    } else {
                                                                        phi_7298_ = true;
                                                                    }
                                                                    let _e9037 = phi_7298_;
                                                                    phi_7299_ = _e9037;
                                                                } else {
                                                                    phi_7299_ = true;
                                                                }
                                                                let _e9039 = phi_7299_;
                                                                phi_7300_ = _e9039;
                                                            } else {
                                                                phi_7300_ = true;
                                                            }
                                                            let _e9041 = phi_7300_;
                                                            if _e9041 {
                                                                phi_7304_ = 2f;
                                                            } else {
                                                                phi_7304_ = _e8951;
                                                            }
                                                            let _e9043 = phi_7304_;
                                                            phi_7307_ = type_40(2u, _e8872, _e9043);
                                                            phi_7308_ = type_40();
                                                            phi_7309_ = false;
                                                        } else {
                                                            phi_7307_ = type_40();
                                                            phi_7308_ = type_40(0u, _e5913, 2f);
                                                            phi_7309_ = true;
                                                        }
                                                        let _e9046 = phi_7307_;
                                                        let _e9048 = phi_7308_;
                                                        let _e9050 = phi_7309_;
                                                        phi_7310_ = _e9046;
                                                        phi_7311_ = _e9048;
                                                        phi_7312_ = _e9050;
                                                    } else {
                                                        phi_7310_ = type_40();
                                                        phi_7311_ = _e8859;
                                                        phi_7312_ = true;
                                                    }
                                                    let _e9052 = phi_7310_;
                                                    let _e9054 = phi_7311_;
                                                    let _e9056 = phi_7312_;
                                                    phi_7317_ = _e9054;
                                                    phi_7318_ = _e9052;
                                                    phi_7319_ = _e9056;
                                                } else {
                                                    phi_7317_ = type_40(0u, _e5913, 2f);
                                                    phi_7318_ = type_40();
                                                    phi_7319_ = true;
                                                }
                                                let _e9058 = phi_7317_;
                                                let _e9060 = phi_7318_;
                                                let _e9062 = phi_7319_;
                                                phi_7323_ = _e9058;
                                                phi_7324_ = _e9060;
                                                phi_7325_ = false;
                                                phi_7326_ = _e9062;
                                            } else {
                                                phi_7323_ = type_40();
                                                phi_7324_ = type_40();
                                                phi_7325_ = true;
                                                phi_7326_ = false;
                                            }
                                            let _e9064 = phi_7323_;
                                            let _e9066 = phi_7324_;
                                            let _e9068 = phi_7325_;
                                            let _e9070 = phi_7326_;
                                            phi_7327_ = _e9064;
                                            phi_7328_ = _e9066;
                                            phi_7329_ = _e9068;
                                            phi_7330_ = _e9070;
                                        } else {
                                            phi_7327_ = type_40();
                                            phi_7328_ = type_40();
                                            phi_7329_ = true;
                                            phi_7330_ = false;
                                        }
                                        let _e9072 = phi_7327_;
                                        let _e9074 = phi_7328_;
                                        let _e9076 = phi_7329_;
                                        let _e9078 = phi_7330_;
                                        if _e9076 {
                                            phi_7335_ = type_40(0u, _e5913, 2f);
                                            phi_7336_ = true;
                                        } else {
                                            phi_7335_ = _e9072;
                                            phi_7336_ = _e9078;
                                        }
                                        let _e9081 = phi_7335_;
                                        let _e9083 = phi_7336_;
                                        if _e9083 {
                                            phi_7340_ = _e9081;
                                        } else {
                                            phi_7340_ = _e9074;
                                        }
                                        let _e9085 = phi_7340_;
                                        if ((_e284 & 64u) != 0u) {
                                            if (_e9085.member == 2u) {
                                                let _e9089 = (_e9085.member_2 <= _e282);
                                                if _e9089 {
                                                    phi_7356_ = _e9085.member_2;
                                                    phi_7357_ = _e9085.member_2;
                                                    phi_7358_ = false;
                                                } else {
                                                    phi_7356_ = f32();
                                                    phi_7357_ = f32();
                                                    phi_7358_ = true;
                                                }
                                                let _e9093 = phi_7356_;
                                                let _e9095 = phi_7357_;
                                                let _e9097 = phi_7358_;
                                                phi_7359_ = _e9093;
                                                phi_7360_ = _e9095;
                                                phi_7361_ = _e9089;
                                                phi_7362_ = _e9097;
                                                phi_7363_ = false;
                                            } else {
                                                phi_7359_ = f32();
                                                phi_7360_ = f32();
                                                phi_7361_ = false;
                                                phi_7362_ = false;
                                                phi_7363_ = true;
                                            }
                                            let _e9099 = phi_7359_;
                                            let _e9101 = phi_7360_;
                                            let _e9103 = phi_7361_;
                                            let _e9105 = phi_7362_;
                                            let _e9107 = phi_7363_;
                                            phi_7364_ = _e9099;
                                            phi_7365_ = _e9101;
                                            phi_7366_ = _e9103;
                                            phi_7367_ = _e9105;
                                            phi_7368_ = _e9107;
                                        } else {
                                            phi_7364_ = f32();
                                            phi_7365_ = f32();
                                            phi_7366_ = false;
                                            phi_7367_ = false;
                                            phi_7368_ = true;
                                        }
                                        let _e9109 = phi_7364_;
                                        let _e9111 = phi_7365_;
                                        let _e9113 = phi_7366_;
                                        let _e9115 = phi_7367_;
                                        let _e9117 = phi_7368_;
                                        phi_7369_ = _e9109;
                                        phi_7370_ = _e9085.member;
                                        phi_7371_ = _e9111;
                                        phi_7372_ = _e9085;
                                        phi_7373_ = _e9085.member;
                                        phi_7374_ = _e9085.member;
                                        phi_7375_ = _e9113;
                                        phi_7376_ = _e9115;
                                        phi_7377_ = _e9117;
                                    }
                                    let _e9119 = phi_7369_;
                                    let _e9121 = phi_7370_;
                                    let _e9123 = phi_7371_;
                                    let _e9125 = phi_7372_;
                                    let _e9127 = phi_7373_;
                                    let _e9129 = phi_7374_;
                                    let _e9131 = phi_7375_;
                                    let _e9133 = phi_7376_;
                                    let _e9135 = phi_7377_;
                                    phi_7378_ = _e9119;
                                    phi_7379_ = _e9121;
                                    phi_7380_ = _e9123;
                                    phi_7381_ = _e9125;
                                    phi_7382_ = _e9127;
                                    phi_7383_ = _e9129;
                                    phi_7384_ = _e9131;
                                    phi_7385_ = _e7699;
                                    phi_7386_ = _e9133;
                                    phi_7387_ = _e9135;
                                    phi_7388_ = false;
                                } else {
                                    phi_7378_ = f32();
                                    phi_7379_ = u32();
                                    phi_7380_ = f32();
                                    phi_7381_ = type_40();
                                    phi_7382_ = u32();
                                    phi_7383_ = u32();
                                    phi_7384_ = false;
                                    phi_7385_ = false;
                                    phi_7386_ = false;
                                    phi_7387_ = false;
                                    phi_7388_ = true;
                                }
                                let _e9137 = phi_7378_;
                                let _e9139 = phi_7379_;
                                let _e9141 = phi_7380_;
                                let _e9143 = phi_7381_;
                                let _e9145 = phi_7382_;
                                let _e9147 = phi_7383_;
                                let _e9149 = phi_7384_;
                                let _e9151 = phi_7385_;
                                let _e9153 = phi_7386_;
                                let _e9155 = phi_7387_;
                                let _e9157 = phi_7388_;
                                phi_7389_ = _e7696;
                                phi_2469_ = _e9137;
                                phi_2471_ = _e9139;
                                phi_2473_ = _e9141;
                                phi_7390_ = _e9143;
                                phi_7391_ = _e9145;
                                phi_7392_ = _e7696;
                                phi_7393_ = _e9147;
                                phi_7394_ = _e9149;
                                phi_7395_ = _e9151;
                                phi_7396_ = _e9153;
                                phi_7397_ = _e9155;
                                phi_7398_ = false;
                                phi_7399_ = _e9157;
                            } else {
                                phi_7389_ = f32();
                                phi_2469_ = f32();
                                phi_2471_ = u32();
                                phi_2473_ = f32();
                                phi_7390_ = type_40();
                                phi_7391_ = u32();
                                phi_7392_ = f32();
                                phi_7393_ = u32();
                                phi_7394_ = false;
                                phi_7395_ = false;
                                phi_7396_ = false;
                                phi_7397_ = false;
                                phi_7398_ = true;
                                phi_7399_ = false;
                            }
                            let _e9159 = phi_7389_;
                            let _e9161 = phi_2469_;
                            let _e9163 = phi_2471_;
                            let _e9165 = phi_2473_;
                            let _e9167 = phi_7390_;
                            let _e9169 = phi_7391_;
                            let _e9171 = phi_7392_;
                            let _e9173 = phi_7393_;
                            let _e9175 = phi_7394_;
                            let _e9177 = phi_7395_;
                            let _e9179 = phi_7396_;
                            let _e9181 = phi_7397_;
                            let _e9183 = phi_7398_;
                            let _e9185 = phi_7399_;
                            local_57 = _e9177;
                            local_89 = _e9179;
                            local_90 = _e9181;
                            local_91 = _e9183;
                            local_92 = _e9185;
                            local_58 = _e9167;
                            local_59 = _e9167;
                            local_93 = _e9169;
                            local_60 = _e9167;
                            local_94 = _e9177;
                            local_95 = _e9173;
                            local_97 = _e9171;
                            local_98 = _e9159;
                            continue;
                            continuing {
                                phi_2465_ = _e5936;
                                phi_2468_ = _e9161;
                                phi_2470_ = _e9163;
                                phi_2472_ = _e9165;
                                break if !(_e9175);
                            }
                        }
                        let _e9188 = local_57;
                        if _e9188 {
                            phi_7403_ = false;
                            phi_7404_ = false;
                            phi_7405_ = false;
                            phi_7406_ = false;
                        } else {
                            let _e11386 = local_89;
                            phi_7403_ = _e11386;
                            let _e11389 = local_90;
                            phi_7404_ = _e11389;
                            let _e11392 = local_91;
                            phi_7405_ = _e11392;
                            let _e11395 = local_92;
                            phi_7406_ = _e11395;
                        }
                        let _e9190 = phi_7403_;
                        let _e9192 = phi_7404_;
                        let _e9194 = phi_7405_;
                        let _e9196 = phi_7406_;
                        if _e9190 {
                            let _e9198 = local_58;
                            if (_e9198.member_1 >= _e282) {
                                phi_7428_ = type_39(type_28(0u, f32()), 0u);
                            } else {
                                let _e9202 = local_59;
                                if (_e9202.member_1 > _e280) {
                                    phi_7423_ = 0u;
                                } else {
                                    let _e11400 = local_93;
                                    phi_7423_ = _e11400;
                                }
                                let _e9206 = phi_7423_;
                                let _e9208 = local_60;
                                phi_7428_ = type_39(type_28(2u, _e9208.member_1), _e9206);
                            }
                            let _e9215 = phi_7428_;
                            phi_7429_ = _e9215;
                            phi_7430_ = false;
                            phi_7431_ = false;
                            phi_7432_ = false;
                            phi_7433_ = false;
                        } else {
                            phi_7429_ = type_39();
                            phi_7430_ = _e9192;
                            let _e11407 = local_94;
                            phi_7431_ = _e11407;
                            phi_7432_ = _e9194;
                            phi_7433_ = _e9196;
                        }
                        let _e9217 = phi_7429_;
                        let _e9219 = phi_7430_;
                        let _e9221 = phi_7431_;
                        let _e9223 = phi_7432_;
                        let _e9225 = phi_7433_;
                        if _e9219 {
                            let _e11412 = local_95;
                            phi_7437_ = _e11412;
                            let _e11417 = local_97;
                            phi_7438_ = _e11417;
                            phi_7439_ = true;
                            phi_7440_ = false;
                            phi_7441_ = false;
                            phi_7442_ = false;
                        } else {
                            let _e11414 = local_96;
                            phi_7437_ = _e11414;
                            let _e11419 = local_98;
                            phi_7438_ = _e11419;
                            phi_7439_ = _e9221;
                            phi_7440_ = _e9223;
                            phi_7441_ = _e9225;
                            phi_7442_ = _e9190;
                        }
                        let _e9227 = phi_7437_;
                        let _e9229 = phi_7438_;
                        let _e9231 = phi_7439_;
                        let _e9233 = phi_7440_;
                        let _e9235 = phi_7441_;
                        let _e9237 = phi_7442_;
                        if _e9231 {
                            phi_7446_ = _e9229;
                            phi_7447_ = _e9227;
                            phi_7448_ = true;
                            phi_7449_ = false;
                            phi_7450_ = false;
                        } else {
                            let _e11426 = local_99;
                            phi_7446_ = _e11426;
                            let _e11429 = local_100;
                            phi_7447_ = _e11429;
                            phi_7448_ = _e9233;
                            phi_7449_ = _e9235;
                            phi_7450_ = _e9237;
                        }
                        let _e9239 = phi_7446_;
                        let _e9241 = phi_7447_;
                        let _e9243 = phi_7448_;
                        let _e9245 = phi_7449_;
                        let _e9247 = phi_7450_;
                        if _e9243 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e278 >= (0.000000059604645f * 8f)) {
                                phi_7462_ = _e278;
                            } else {
                                phi_7462_ = 0f;
                            }
                            let _e9254 = phi_7462_;
                            phi_7465_ = type_12(0u, 3u);
                            loop {
                                let _e9256 = phi_7465_;
                                if (_e9256.member < _e9256.member_1) {
                                    phi_7466_ = type_12((_e9256.member + 1u), _e9256.member_1);
                                    phi_7489_ = type_12(1u, _e9256.member);
                                } else {
                                    phi_7466_ = _e9256;
                                    phi_7489_ = type_12(0u, type_12().member_1);
                                }
                                let _e9268 = phi_7466_;
                                let _e9270 = phi_7489_;
                                if (bitcast<i32>(_e9270.member) != 0i) {
                                    let _e9276 = local_13[_e9270.member_1];
                                    let _e9278 = (_e9239 + (_e9254 * _e9276));
                                    if (_e9278 < _e282) {
                                        phi_7510_ = _e9278;
                                    } else {
                                        phi_7510_ = _e282;
                                    }
                                    let _e9281 = phi_7510_;
                                    let _e9284 = local_18.member[0u];
                                    let _e9290 = local_18.member[1u];
                                    let _e9306 = local_18.member_1[0u];
                                    let _e9312 = local_18.member_1[1u];
                                    let _e9328 = local_18.member_2[0u];
                                    let _e9334 = local_18.member_2[1u];
                                    let _e9348 = function_2(array<f32, 3>((_e9284[0] + ((_e9290[0] - _e9284[0]) * _e9281)), (_e9284[1] + ((_e9290[1] - _e9284[1]) * _e9281)), (_e9284[2] + ((_e9290[2] - _e9284[2]) * _e9281))), array<f32, 3>((_e9306[0] + ((_e9312[0] - _e9306[0]) * _e9281)), (_e9306[1] + ((_e9312[1] - _e9306[1]) * _e9281)), (_e9306[2] + ((_e9312[2] - _e9306[2]) * _e9281))), array<f32, 3>((_e9328[0] + ((_e9334[0] - _e9328[0]) * _e9281)), (_e9328[1] + ((_e9334[1] - _e9328[1]) * _e9281)), (_e9328[2] + ((_e9334[2] - _e9328[2]) * _e9281))), 0u);
                                    let _e9359 = (((_e9348[0] * _e9348[0]) + (_e9348[1] * _e9348[1])) + (_e9348[2] * _e9348[2]));
                                    if (_e9359 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e9359 > 0f) {
                                            phi_7633_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_7633_ = 0f;
                                        }
                                        let _e9412 = phi_7633_;
                                        phi_7697_ = _e9412;
                                    } else {
                                        phi_7640_ = type_14(0i, 5i);
                                        phi_7643_ = bitcast<f32>(((bitcast<u32>(_e9359) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e9367 = phi_7640_;
                                            let _e9369 = phi_7643_;
                                            local_61 = _e9369;
                                            if (_e9367.member < _e9367.member_1) {
                                                let _e9376 = (_e9367.member + 1i);
                                                if ((false == (_e9376 > _e9367.member)) != false) {
                                                    phi_7664_ = true;
                                                } else {
                                                    phi_7664_ = false;
                                                }
                                                let _e9381 = phi_7664_;
                                                if _e9381 {
                                                    phi_7670_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_7670_ = type_15(1u, _e9376);
                                                }
                                                let _e9386 = phi_7670_;
                                                phi_7641_ = type_14(_e9386.member_1, _e9367.member_1);
                                                phi_7684_ = type_15(1u, _e9367.member);
                                            } else {
                                                phi_7641_ = _e9367;
                                                phi_7684_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e9392 = phi_7641_;
                                            let _e9394 = phi_7684_;
                                            let _e9397 = (bitcast<i32>(_e9394.member) != 0i);
                                            if _e9397 {
                                                phi_7644_ = (0.5f * (_e9369 + (_e9359 / _e9369)));
                                            } else {
                                                phi_7644_ = f32();
                                            }
                                            let _e9402 = phi_7644_;
                                            continue;
                                            continuing {
                                                phi_7640_ = _e9392;
                                                phi_7643_ = _e9402;
                                                break if !(_e9397);
                                            }
                                        }
                                        let _e9407 = local_61;
                                        phi_7697_ = (_e9407 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e9414 = phi_7697_;
                                    let _e9420 = local_18.member[0u];
                                    if (_e9420[0] < 0f) {
                                        phi_7713_ = -(_e9420[0]);
                                    } else {
                                        phi_7713_ = _e9420[0];
                                    }
                                    let _e9427 = phi_7713_;
                                    if (_e9420[1] < 0f) {
                                        phi_7720_ = -(_e9420[1]);
                                    } else {
                                        phi_7720_ = _e9420[1];
                                    }
                                    let _e9431 = phi_7720_;
                                    if (_e9427 > _e9431) {
                                        phi_7725_ = _e9427;
                                    } else {
                                        phi_7725_ = _e9431;
                                    }
                                    let _e9434 = phi_7725_;
                                    if (_e9420[2] < 0f) {
                                        phi_7732_ = -(_e9420[2]);
                                    } else {
                                        phi_7732_ = _e9420[2];
                                    }
                                    let _e9438 = phi_7732_;
                                    if (_e9434 > _e9438) {
                                        phi_7737_ = _e9434;
                                    } else {
                                        phi_7737_ = _e9438;
                                    }
                                    let _e9441 = phi_7737_;
                                    let _e9444 = local_18.member[1u];
                                    if (_e9444[0] < 0f) {
                                        phi_7750_ = -(_e9444[0]);
                                    } else {
                                        phi_7750_ = _e9444[0];
                                    }
                                    let _e9451 = phi_7750_;
                                    if (_e9444[1] < 0f) {
                                        phi_7757_ = -(_e9444[1]);
                                    } else {
                                        phi_7757_ = _e9444[1];
                                    }
                                    let _e9455 = phi_7757_;
                                    if (_e9451 > _e9455) {
                                        phi_7762_ = _e9451;
                                    } else {
                                        phi_7762_ = _e9455;
                                    }
                                    let _e9458 = phi_7762_;
                                    if (_e9444[2] < 0f) {
                                        phi_7769_ = -(_e9444[2]);
                                    } else {
                                        phi_7769_ = _e9444[2];
                                    }
                                    let _e9462 = phi_7769_;
                                    if (_e9458 > _e9462) {
                                        phi_7774_ = _e9458;
                                    } else {
                                        phi_7774_ = _e9462;
                                    }
                                    let _e9465 = phi_7774_;
                                    if (_e9441 > _e9465) {
                                        phi_7779_ = _e9441;
                                    } else {
                                        phi_7779_ = _e9465;
                                    }
                                    let _e9468 = phi_7779_;
                                    let _e9470 = local_18.member_3;
                                    let _e9474 = local_18.member_1[0u];
                                    if (_e9474[0] < 0f) {
                                        phi_7796_ = -(_e9474[0]);
                                    } else {
                                        phi_7796_ = _e9474[0];
                                    }
                                    let _e9481 = phi_7796_;
                                    if (_e9474[1] < 0f) {
                                        phi_7803_ = -(_e9474[1]);
                                    } else {
                                        phi_7803_ = _e9474[1];
                                    }
                                    let _e9485 = phi_7803_;
                                    if (_e9481 > _e9485) {
                                        phi_7808_ = _e9481;
                                    } else {
                                        phi_7808_ = _e9485;
                                    }
                                    let _e9488 = phi_7808_;
                                    if (_e9474[2] < 0f) {
                                        phi_7815_ = -(_e9474[2]);
                                    } else {
                                        phi_7815_ = _e9474[2];
                                    }
                                    let _e9492 = phi_7815_;
                                    if (_e9488 > _e9492) {
                                        phi_7820_ = _e9488;
                                    } else {
                                        phi_7820_ = _e9492;
                                    }
                                    let _e9495 = phi_7820_;
                                    let _e9498 = local_18.member_1[1u];
                                    if (_e9498[0] < 0f) {
                                        phi_7834_ = -(_e9498[0]);
                                    } else {
                                        phi_7834_ = _e9498[0];
                                    }
                                    let _e9505 = phi_7834_;
                                    if (_e9498[1] < 0f) {
                                        phi_7841_ = -(_e9498[1]);
                                    } else {
                                        phi_7841_ = _e9498[1];
                                    }
                                    let _e9509 = phi_7841_;
                                    if (_e9505 > _e9509) {
                                        phi_7846_ = _e9505;
                                    } else {
                                        phi_7846_ = _e9509;
                                    }
                                    let _e9512 = phi_7846_;
                                    if (_e9498[2] < 0f) {
                                        phi_7853_ = -(_e9498[2]);
                                    } else {
                                        phi_7853_ = _e9498[2];
                                    }
                                    let _e9516 = phi_7853_;
                                    if (_e9512 > _e9516) {
                                        phi_7858_ = _e9512;
                                    } else {
                                        phi_7858_ = _e9516;
                                    }
                                    let _e9519 = phi_7858_;
                                    if (_e9495 > _e9519) {
                                        phi_7863_ = _e9495;
                                    } else {
                                        phi_7863_ = _e9519;
                                    }
                                    let _e9522 = phi_7863_;
                                    let _e9524 = local_18.member_3;
                                    let _e9528 = local_18.member_2[0u];
                                    if (_e9528[0] < 0f) {
                                        phi_7880_ = -(_e9528[0]);
                                    } else {
                                        phi_7880_ = _e9528[0];
                                    }
                                    let _e9535 = phi_7880_;
                                    if (_e9528[1] < 0f) {
                                        phi_7887_ = -(_e9528[1]);
                                    } else {
                                        phi_7887_ = _e9528[1];
                                    }
                                    let _e9539 = phi_7887_;
                                    if (_e9535 > _e9539) {
                                        phi_7892_ = _e9535;
                                    } else {
                                        phi_7892_ = _e9539;
                                    }
                                    let _e9542 = phi_7892_;
                                    if (_e9528[2] < 0f) {
                                        phi_7899_ = -(_e9528[2]);
                                    } else {
                                        phi_7899_ = _e9528[2];
                                    }
                                    let _e9546 = phi_7899_;
                                    if (_e9542 > _e9546) {
                                        phi_7904_ = _e9542;
                                    } else {
                                        phi_7904_ = _e9546;
                                    }
                                    let _e9549 = phi_7904_;
                                    let _e9552 = local_18.member_2[1u];
                                    if (_e9552[0] < 0f) {
                                        phi_7918_ = -(_e9552[0]);
                                    } else {
                                        phi_7918_ = _e9552[0];
                                    }
                                    let _e9559 = phi_7918_;
                                    if (_e9552[1] < 0f) {
                                        phi_7925_ = -(_e9552[1]);
                                    } else {
                                        phi_7925_ = _e9552[1];
                                    }
                                    let _e9563 = phi_7925_;
                                    if (_e9559 > _e9563) {
                                        phi_7930_ = _e9559;
                                    } else {
                                        phi_7930_ = _e9563;
                                    }
                                    let _e9566 = phi_7930_;
                                    if (_e9552[2] < 0f) {
                                        phi_7937_ = -(_e9552[2]);
                                    } else {
                                        phi_7937_ = _e9552[2];
                                    }
                                    let _e9570 = phi_7937_;
                                    if (_e9566 > _e9570) {
                                        phi_7942_ = _e9566;
                                    } else {
                                        phi_7942_ = _e9570;
                                    }
                                    let _e9573 = phi_7942_;
                                    if (_e9549 > _e9573) {
                                        phi_7947_ = _e9549;
                                    } else {
                                        phi_7947_ = _e9573;
                                    }
                                    let _e9576 = phi_7947_;
                                    let _e9578 = local_18.member_3;
                                    let _e9585 = local_18.member_3;
                                    let _e9592 = (((_e9414 * (1f + (0.000000059604645f * 8f))) + (((((((_e9468 + _e9470) + (_e9522 + _e9524)) + (_e9576 + _e9578)) * (0.000000059604645f * 16f)) + (_e9585 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e480.member_1);
                                    if _e9592 {
                                        phi_7967_ = false;
                                    } else {
                                        phi_7967_ = true;
                                    }
                                    let _e9594 = phi_7967_;
                                    phi_7968_ = _e9594;
                                    phi_7969_ = _e9592;
                                } else {
                                    phi_7968_ = false;
                                    phi_7969_ = false;
                                }
                                let _e9596 = phi_7968_;
                                let _e9598 = phi_7969_;
                                local_62 = _e9598;
                                continue;
                                continuing {
                                    phi_7465_ = _e9268;
                                    break if !(_e9596);
                                }
                            }
                            let _e9601 = local_62;
                            if _e9601 {
                                if (_e9239 > _e280) {
                                    phi_7977_ = 1u;
                                } else {
                                    phi_7977_ = _e9241;
                                }
                                let _e9604 = phi_7977_;
                                phi_7981_ = type_39(type_28(1u, _e9239), _e9604);
                                phi_7982_ = false;
                            } else {
                                phi_7981_ = type_39();
                                phi_7982_ = true;
                            }
                            let _e9608 = phi_7981_;
                            let _e9610 = phi_7982_;
                            if _e9610 {
                                if (_e9239 > _e280) {
                                    phi_7990_ = 0u;
                                } else {
                                    phi_7990_ = _e9241;
                                }
                                let _e9613 = phi_7990_;
                                phi_7994_ = type_39(type_28(2u, _e9239), _e9613);
                            } else {
                                phi_7994_ = _e9608;
                            }
                            let _e9617 = phi_7994_;
                            phi_7995_ = _e9617;
                            phi_7996_ = false;
                            phi_7997_ = false;
                        } else {
                            phi_7995_ = type_39();
                            phi_7996_ = _e9245;
                            phi_7997_ = _e9247;
                        }
                        let _e9619 = phi_7995_;
                        let _e9621 = phi_7996_;
                        let _e9623 = phi_7997_;
                        if _e9621 {
                            phi_8004_ = type_39(type_28(0u, f32()), 0u);
                            phi_8005_ = true;
                        } else {
                            phi_8004_ = _e9217;
                            phi_8005_ = _e9623;
                        }
                        let _e9627 = phi_8004_;
                        let _e9629 = phi_8005_;
                        phi_8009_ = _e9627;
                        phi_8010_ = _e9619;
                        phi_8011_ = _e9629;
                    } else {
                        phi_8009_ = _e5903;
                        phi_8010_ = type_39();
                        phi_8011_ = true;
                    }
                    let _e9631 = phi_8009_;
                    let _e9633 = phi_8010_;
                    let _e9635 = phi_8011_;
                    if _e9635 {
                        phi_8015_ = _e9631;
                    } else {
                        phi_8015_ = _e9633;
                    }
                    let _e9637 = phi_8015_;
                    phi_15530_ = _e9637;
                } else {
                    let _e524 = local_18.member_1[0u];
                    let _e530 = local_18.member_2[0u];
                    let _e536 = ((_e524[1] * _e530[2]) - (_e524[2] * _e530[1]));
                    let _e539 = ((_e524[2] * _e530[0]) - (_e524[0] * _e530[2]));
                    let _e542 = ((_e524[0] * _e530[1]) - (_e524[1] * _e530[0]));
                    let _e545 = local_18.member_1[1u];
                    let _e551 = local_18.member_2[1u];
                    let _e557 = ((_e545[1] * _e551[2]) - (_e545[2] * _e551[1]));
                    let _e560 = ((_e545[2] * _e551[0]) - (_e545[0] * _e551[2]));
                    let _e563 = ((_e545[0] * _e551[1]) - (_e545[1] * _e551[0]));
                    let _e566 = local_18.member_1[0u];
                    let _e572 = local_18.member_2[1u];
                    let _e587 = local_18.member_1[1u];
                    let _e593 = local_18.member_2[0u];
                    let _e606 = (((_e566[1] * _e572[2]) - (_e566[2] * _e572[1])) + ((_e587[1] * _e593[2]) - (_e587[2] * _e593[1])));
                    let _e607 = (((_e566[2] * _e572[0]) - (_e566[0] * _e572[2])) + ((_e587[2] * _e593[0]) - (_e587[0] * _e593[2])));
                    let _e608 = (((_e566[0] * _e572[1]) - (_e566[1] * _e572[0])) + ((_e587[0] * _e593[1]) - (_e587[1] * _e593[0])));
                    let _e611 = local_18.member[0u];
                    let _e619 = (((_e611[0] * _e536) + (_e611[1] * _e539)) + (_e611[2] * _e542));
                    let _e622 = local_18.member[1u];
                    let _e633 = local_18.member[0u];
                    let _e642 = ((((_e622[0] * _e536) + (_e622[1] * _e539)) + (_e622[2] * _e542)) + (((_e633[0] * _e606) + (_e633[1] * _e607)) + (_e633[2] * _e608)));
                    let _e645 = local_18.member[0u];
                    let _e656 = local_18.member[1u];
                    let _e665 = ((((_e645[0] * _e557) + (_e645[1] * _e560)) + (_e645[2] * _e563)) + (((_e656[0] * _e606) + (_e656[1] * _e607)) + (_e656[2] * _e608)));
                    let _e668 = local_18.member[1u];
                    let _e676 = (((_e668[0] * _e557) + (_e668[1] * _e560)) + (_e668[2] * _e563));
                    let _e679 = local_18.member[0u];
                    if (_e679[0] < 0f) {
                        phi_8257_ = -(_e679[0]);
                    } else {
                        phi_8257_ = _e679[0];
                    }
                    let _e686 = phi_8257_;
                    if (_e679[1] < 0f) {
                        phi_8264_ = -(_e679[1]);
                    } else {
                        phi_8264_ = _e679[1];
                    }
                    let _e690 = phi_8264_;
                    if (_e686 > _e690) {
                        phi_8269_ = _e686;
                    } else {
                        phi_8269_ = _e690;
                    }
                    let _e693 = phi_8269_;
                    if (_e679[2] < 0f) {
                        phi_8276_ = -(_e679[2]);
                    } else {
                        phi_8276_ = _e679[2];
                    }
                    let _e697 = phi_8276_;
                    if (_e693 > _e697) {
                        phi_8281_ = _e693;
                    } else {
                        phi_8281_ = _e697;
                    }
                    let _e700 = phi_8281_;
                    let _e703 = local_18.member[1u];
                    if (_e703[0] < 0f) {
                        phi_8294_ = -(_e703[0]);
                    } else {
                        phi_8294_ = _e703[0];
                    }
                    let _e710 = phi_8294_;
                    if (_e703[1] < 0f) {
                        phi_8301_ = -(_e703[1]);
                    } else {
                        phi_8301_ = _e703[1];
                    }
                    let _e714 = phi_8301_;
                    if (_e710 > _e714) {
                        phi_8306_ = _e710;
                    } else {
                        phi_8306_ = _e714;
                    }
                    let _e717 = phi_8306_;
                    if (_e703[2] < 0f) {
                        phi_8313_ = -(_e703[2]);
                    } else {
                        phi_8313_ = _e703[2];
                    }
                    let _e721 = phi_8313_;
                    if (_e717 > _e721) {
                        phi_8318_ = _e717;
                    } else {
                        phi_8318_ = _e721;
                    }
                    let _e724 = phi_8318_;
                    if (_e700 > _e724) {
                        phi_8323_ = _e700;
                    } else {
                        phi_8323_ = _e724;
                    }
                    let _e727 = phi_8323_;
                    let _e729 = local_18.member_3;
                    let _e730 = (_e727 + _e729);
                    let _e733 = local_18.member_1[0u];
                    if (_e733[0] < 0f) {
                        phi_8340_ = -(_e733[0]);
                    } else {
                        phi_8340_ = _e733[0];
                    }
                    let _e740 = phi_8340_;
                    if (_e733[1] < 0f) {
                        phi_8347_ = -(_e733[1]);
                    } else {
                        phi_8347_ = _e733[1];
                    }
                    let _e744 = phi_8347_;
                    if (_e740 > _e744) {
                        phi_8352_ = _e740;
                    } else {
                        phi_8352_ = _e744;
                    }
                    let _e747 = phi_8352_;
                    if (_e733[2] < 0f) {
                        phi_8359_ = -(_e733[2]);
                    } else {
                        phi_8359_ = _e733[2];
                    }
                    let _e751 = phi_8359_;
                    if (_e747 > _e751) {
                        phi_8364_ = _e747;
                    } else {
                        phi_8364_ = _e751;
                    }
                    let _e754 = phi_8364_;
                    let _e757 = local_18.member_1[1u];
                    if (_e757[0] < 0f) {
                        phi_8378_ = -(_e757[0]);
                    } else {
                        phi_8378_ = _e757[0];
                    }
                    let _e764 = phi_8378_;
                    if (_e757[1] < 0f) {
                        phi_8385_ = -(_e757[1]);
                    } else {
                        phi_8385_ = _e757[1];
                    }
                    let _e768 = phi_8385_;
                    if (_e764 > _e768) {
                        phi_8390_ = _e764;
                    } else {
                        phi_8390_ = _e768;
                    }
                    let _e771 = phi_8390_;
                    if (_e757[2] < 0f) {
                        phi_8397_ = -(_e757[2]);
                    } else {
                        phi_8397_ = _e757[2];
                    }
                    let _e775 = phi_8397_;
                    if (_e771 > _e775) {
                        phi_8402_ = _e771;
                    } else {
                        phi_8402_ = _e775;
                    }
                    let _e778 = phi_8402_;
                    if (_e754 > _e778) {
                        phi_8407_ = _e754;
                    } else {
                        phi_8407_ = _e778;
                    }
                    let _e781 = phi_8407_;
                    let _e783 = local_18.member_3;
                    let _e784 = (_e781 + _e783);
                    let _e787 = local_18.member_2[0u];
                    if (_e787[0] < 0f) {
                        phi_8424_ = -(_e787[0]);
                    } else {
                        phi_8424_ = _e787[0];
                    }
                    let _e794 = phi_8424_;
                    if (_e787[1] < 0f) {
                        phi_8431_ = -(_e787[1]);
                    } else {
                        phi_8431_ = _e787[1];
                    }
                    let _e798 = phi_8431_;
                    if (_e794 > _e798) {
                        phi_8436_ = _e794;
                    } else {
                        phi_8436_ = _e798;
                    }
                    let _e801 = phi_8436_;
                    if (_e787[2] < 0f) {
                        phi_8443_ = -(_e787[2]);
                    } else {
                        phi_8443_ = _e787[2];
                    }
                    let _e805 = phi_8443_;
                    if (_e801 > _e805) {
                        phi_8448_ = _e801;
                    } else {
                        phi_8448_ = _e805;
                    }
                    let _e808 = phi_8448_;
                    let _e811 = local_18.member_2[1u];
                    if (_e811[0] < 0f) {
                        phi_8462_ = -(_e811[0]);
                    } else {
                        phi_8462_ = _e811[0];
                    }
                    let _e818 = phi_8462_;
                    if (_e811[1] < 0f) {
                        phi_8469_ = -(_e811[1]);
                    } else {
                        phi_8469_ = _e811[1];
                    }
                    let _e822 = phi_8469_;
                    if (_e818 > _e822) {
                        phi_8474_ = _e818;
                    } else {
                        phi_8474_ = _e822;
                    }
                    let _e825 = phi_8474_;
                    if (_e811[2] < 0f) {
                        phi_8481_ = -(_e811[2]);
                    } else {
                        phi_8481_ = _e811[2];
                    }
                    let _e829 = phi_8481_;
                    if (_e825 > _e829) {
                        phi_8486_ = _e825;
                    } else {
                        phi_8486_ = _e829;
                    }
                    let _e832 = phi_8486_;
                    if (_e808 > _e832) {
                        phi_8491_ = _e808;
                    } else {
                        phi_8491_ = _e832;
                    }
                    let _e835 = phi_8491_;
                    let _e837 = local_18.member_3;
                    let _e838 = (_e835 + _e837);
                    let _e840 = ((_e784 * 8f) * _e838);
                    let _e847 = local_18.member_3;
                    if (_e536 < 0f) {
                        phi_8522_ = -(_e536);
                    } else {
                        phi_8522_ = _e536;
                    }
                    let _e864 = phi_8522_;
                    if (_e539 < 0f) {
                        phi_8528_ = -(_e539);
                    } else {
                        phi_8528_ = _e539;
                    }
                    let _e868 = phi_8528_;
                    if (_e542 < 0f) {
                        phi_8535_ = -(_e542);
                    } else {
                        phi_8535_ = _e542;
                    }
                    let _e873 = phi_8535_;
                    let _e874 = ((_e864 + _e868) + _e873);
                    if (_e557 < 0f) {
                        phi_8542_ = -(_e557);
                    } else {
                        phi_8542_ = _e557;
                    }
                    let _e878 = phi_8542_;
                    if (_e560 < 0f) {
                        phi_8548_ = -(_e560);
                    } else {
                        phi_8548_ = _e560;
                    }
                    let _e882 = phi_8548_;
                    if (_e563 < 0f) {
                        phi_8555_ = -(_e563);
                    } else {
                        phi_8555_ = _e563;
                    }
                    let _e887 = phi_8555_;
                    let _e888 = ((_e878 + _e882) + _e887);
                    if (_e874 > _e888) {
                        phi_8561_ = _e874;
                    } else {
                        phi_8561_ = _e888;
                    }
                    let _e891 = phi_8561_;
                    if (_e606 < 0f) {
                        phi_8567_ = -(_e606);
                    } else {
                        phi_8567_ = _e606;
                    }
                    let _e895 = phi_8567_;
                    if (_e607 < 0f) {
                        phi_8573_ = -(_e607);
                    } else {
                        phi_8573_ = _e607;
                    }
                    let _e899 = phi_8573_;
                    if (_e608 < 0f) {
                        phi_8580_ = -(_e608);
                    } else {
                        phi_8580_ = _e608;
                    }
                    let _e904 = phi_8580_;
                    let _e906 = (((_e895 + _e899) + _e904) * 0.5f);
                    if (_e891 > _e906) {
                        phi_8587_ = _e891;
                    } else {
                        phi_8587_ = _e906;
                    }
                    let _e909 = phi_8587_;
                    let _e914 = local_18.member_3;
                    let _e926 = (((((_e730 * 8f) * _e840) * (0.000000059604645f * (524f / 64f))) + ((_e847 * 19f) * ((_e730 * (_e784 + _e838)) + (_e784 * _e838)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e730) * ((1f + _e784) * (1f + _e838)))));
                    let _e927 = (_e619 * 3f);
                    let _e928 = (_e676 * 3f);
                    if (_e927 < _e928) {
                        phi_8611_ = _e927;
                    } else {
                        phi_8611_ = _e928;
                    }
                    let _e931 = phi_8611_;
                    if (_e642 < _e665) {
                        phi_8616_ = _e642;
                    } else {
                        phi_8616_ = _e665;
                    }
                    let _e934 = phi_8616_;
                    if (_e931 < _e934) {
                        phi_8621_ = _e931;
                    } else {
                        phi_8621_ = _e934;
                    }
                    let _e937 = phi_8621_;
                    if (_e927 > _e928) {
                        phi_8626_ = _e927;
                    } else {
                        phi_8626_ = _e928;
                    }
                    let _e940 = phi_8626_;
                    if (_e642 > _e665) {
                        phi_8631_ = _e642;
                    } else {
                        phi_8631_ = _e665;
                    }
                    let _e943 = phi_8631_;
                    if (_e940 > _e943) {
                        phi_8636_ = _e940;
                    } else {
                        phi_8636_ = _e943;
                    }
                    let _e946 = phi_8636_;
                    let _e951 = -(_e946);
                    if (_e937 > _e951) {
                        phi_8646_ = _e937;
                    } else {
                        phi_8646_ = _e951;
                    }
                    let _e954 = phi_8646_;
                    if ((_e954 - (_e926 + ((0f * (((_e909 + (_e840 * (0.000000059604645f * 8f))) + ((_e914 * 6f) * (_e784 + _e838))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e784) * (1f + _e838))))) * (3f * 1.0001f)))) > 0f) {
                        phi_15500_ = type_28(0u, type_28().member_1);
                        phi_15501_ = type_28();
                        phi_15502_ = true;
                    } else {
                        if (_e619 < 0f) {
                            phi_8659_ = -(_e619);
                        } else {
                            phi_8659_ = _e619;
                        }
                        let _e961 = phi_8659_;
                        if (_e642 < 0f) {
                            phi_8665_ = -(_e642);
                        } else {
                            phi_8665_ = _e642;
                        }
                        let _e965 = phi_8665_;
                        if (_e961 > _e965) {
                            phi_8670_ = _e961;
                        } else {
                            phi_8670_ = _e965;
                        }
                        let _e968 = phi_8670_;
                        if (_e665 < 0f) {
                            phi_8676_ = -(_e665);
                        } else {
                            phi_8676_ = _e665;
                        }
                        let _e972 = phi_8676_;
                        if (_e676 < 0f) {
                            phi_8682_ = -(_e676);
                        } else {
                            phi_8682_ = _e676;
                        }
                        let _e976 = phi_8682_;
                        if (_e972 > _e976) {
                            phi_8687_ = _e972;
                        } else {
                            phi_8687_ = _e976;
                        }
                        let _e979 = phi_8687_;
                        if (_e968 > _e979) {
                            phi_8692_ = _e968;
                        } else {
                            phi_8692_ = _e979;
                        }
                        let _e982 = phi_8692_;
                        let _e983 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e982 >= _e983) {
                            phi_8700_ = (_e982 <= (1f / _e983));
                        } else {
                            phi_8700_ = false;
                        }
                        let _e988 = phi_8700_;
                        if _e988 {
                            phi_8705_ = (0.000000059604645f * 256f);
                        } else {
                            phi_8705_ = 2f;
                        }
                        let _e991 = phi_8705_;
                        let _e993 = ((_e926 * 0.34f) + (_e982 * _e991));
                        if _e988 {
                            phi_8712_ = (1f / _e982);
                        } else {
                            phi_8712_ = 0f;
                        }
                        let _e996 = phi_8712_;
                        let _e997 = (_e278 * 0.0625f);
                        if (0.00000000000022737368f < _e997) {
                            phi_8718_ = 0.00000000000022737368f;
                        } else {
                            phi_8718_ = _e997;
                        }
                        let _e1000 = phi_8718_;
                        let _e1001 = (1f - _e280);
                        let _e1012 = ((((_e619 * _e1001) + (_e642 * _e280)) * (_e1001 * _e1001)) + (((_e665 * _e1001) + (_e676 * _e280)) * (_e280 * _e280)));
                        if (_e1012 < 0f) {
                            phi_8736_ = -(_e1012);
                        } else {
                            phi_8736_ = _e1012;
                        }
                        let _e1016 = phi_8736_;
                        if !((_e1016 > _e993)) {
                            let _e1021 = local_18.member[0u];
                            let _e1027 = local_18.member_1[0u];
                            let _e1033 = local_18.member_2[0u];
                            let _e1037 = (_e1021[0] - _e1027[0]);
                            let _e1038 = (_e1021[1] - _e1027[1]);
                            let _e1039 = (_e1021[2] - _e1027[2]);
                            let _e1040 = (_e1021[0] - _e1033[0]);
                            let _e1041 = (_e1021[1] - _e1033[1]);
                            let _e1042 = (_e1021[2] - _e1033[2]);
                            let _e1045 = local_18.member[1u];
                            let _e1051 = local_18.member_1[1u];
                            let _e1057 = local_18.member_2[1u];
                            let _e1061 = (_e1045[0] - _e1051[0]);
                            let _e1062 = (_e1045[1] - _e1051[1]);
                            let _e1063 = (_e1045[2] - _e1051[2]);
                            let _e1064 = (_e1045[0] - _e1057[0]);
                            let _e1065 = (_e1045[1] - _e1057[1]);
                            let _e1066 = (_e1045[2] - _e1057[2]);
                            let _e1069 = local_18.member[0u];
                            if (_e1069[0] < 0f) {
                                phi_8884_ = -(_e1069[0]);
                            } else {
                                phi_8884_ = _e1069[0];
                            }
                            let _e1076 = phi_8884_;
                            if (_e1069[1] < 0f) {
                                phi_8891_ = -(_e1069[1]);
                            } else {
                                phi_8891_ = _e1069[1];
                            }
                            let _e1080 = phi_8891_;
                            if (_e1076 > _e1080) {
                                phi_8896_ = _e1076;
                            } else {
                                phi_8896_ = _e1080;
                            }
                            let _e1083 = phi_8896_;
                            if (_e1069[2] < 0f) {
                                phi_8903_ = -(_e1069[2]);
                            } else {
                                phi_8903_ = _e1069[2];
                            }
                            let _e1087 = phi_8903_;
                            if (_e1083 > _e1087) {
                                phi_8908_ = _e1083;
                            } else {
                                phi_8908_ = _e1087;
                            }
                            let _e1090 = phi_8908_;
                            let _e1093 = local_18.member[1u];
                            if (_e1093[0] < 0f) {
                                phi_8921_ = -(_e1093[0]);
                            } else {
                                phi_8921_ = _e1093[0];
                            }
                            let _e1100 = phi_8921_;
                            if (_e1093[1] < 0f) {
                                phi_8928_ = -(_e1093[1]);
                            } else {
                                phi_8928_ = _e1093[1];
                            }
                            let _e1104 = phi_8928_;
                            if (_e1100 > _e1104) {
                                phi_8933_ = _e1100;
                            } else {
                                phi_8933_ = _e1104;
                            }
                            let _e1107 = phi_8933_;
                            if (_e1093[2] < 0f) {
                                phi_8940_ = -(_e1093[2]);
                            } else {
                                phi_8940_ = _e1093[2];
                            }
                            let _e1111 = phi_8940_;
                            if (_e1107 > _e1111) {
                                phi_8945_ = _e1107;
                            } else {
                                phi_8945_ = _e1111;
                            }
                            let _e1114 = phi_8945_;
                            if (_e1090 > _e1114) {
                                phi_8950_ = _e1090;
                            } else {
                                phi_8950_ = _e1114;
                            }
                            let _e1117 = phi_8950_;
                            let _e1119 = local_18.member_3;
                            let _e1123 = local_18.member_1[0u];
                            if (_e1123[0] < 0f) {
                                phi_8967_ = -(_e1123[0]);
                            } else {
                                phi_8967_ = _e1123[0];
                            }
                            let _e1130 = phi_8967_;
                            if (_e1123[1] < 0f) {
                                phi_8974_ = -(_e1123[1]);
                            } else {
                                phi_8974_ = _e1123[1];
                            }
                            let _e1134 = phi_8974_;
                            if (_e1130 > _e1134) {
                                phi_8979_ = _e1130;
                            } else {
                                phi_8979_ = _e1134;
                            }
                            let _e1137 = phi_8979_;
                            if (_e1123[2] < 0f) {
                                phi_8986_ = -(_e1123[2]);
                            } else {
                                phi_8986_ = _e1123[2];
                            }
                            let _e1141 = phi_8986_;
                            if (_e1137 > _e1141) {
                                phi_8991_ = _e1137;
                            } else {
                                phi_8991_ = _e1141;
                            }
                            let _e1144 = phi_8991_;
                            let _e1147 = local_18.member_1[1u];
                            if (_e1147[0] < 0f) {
                                phi_9005_ = -(_e1147[0]);
                            } else {
                                phi_9005_ = _e1147[0];
                            }
                            let _e1154 = phi_9005_;
                            if (_e1147[1] < 0f) {
                                phi_9012_ = -(_e1147[1]);
                            } else {
                                phi_9012_ = _e1147[1];
                            }
                            let _e1158 = phi_9012_;
                            if (_e1154 > _e1158) {
                                phi_9017_ = _e1154;
                            } else {
                                phi_9017_ = _e1158;
                            }
                            let _e1161 = phi_9017_;
                            if (_e1147[2] < 0f) {
                                phi_9024_ = -(_e1147[2]);
                            } else {
                                phi_9024_ = _e1147[2];
                            }
                            let _e1165 = phi_9024_;
                            if (_e1161 > _e1165) {
                                phi_9029_ = _e1161;
                            } else {
                                phi_9029_ = _e1165;
                            }
                            let _e1168 = phi_9029_;
                            if (_e1144 > _e1168) {
                                phi_9034_ = _e1144;
                            } else {
                                phi_9034_ = _e1168;
                            }
                            let _e1171 = phi_9034_;
                            let _e1173 = local_18.member_3;
                            let _e1177 = local_18.member_2[0u];
                            if (_e1177[0] < 0f) {
                                phi_9051_ = -(_e1177[0]);
                            } else {
                                phi_9051_ = _e1177[0];
                            }
                            let _e1184 = phi_9051_;
                            if (_e1177[1] < 0f) {
                                phi_9058_ = -(_e1177[1]);
                            } else {
                                phi_9058_ = _e1177[1];
                            }
                            let _e1188 = phi_9058_;
                            if (_e1184 > _e1188) {
                                phi_9063_ = _e1184;
                            } else {
                                phi_9063_ = _e1188;
                            }
                            let _e1191 = phi_9063_;
                            if (_e1177[2] < 0f) {
                                phi_9070_ = -(_e1177[2]);
                            } else {
                                phi_9070_ = _e1177[2];
                            }
                            let _e1195 = phi_9070_;
                            if (_e1191 > _e1195) {
                                phi_9075_ = _e1191;
                            } else {
                                phi_9075_ = _e1195;
                            }
                            let _e1198 = phi_9075_;
                            let _e1201 = local_18.member_2[1u];
                            if (_e1201[0] < 0f) {
                                phi_9089_ = -(_e1201[0]);
                            } else {
                                phi_9089_ = _e1201[0];
                            }
                            let _e1208 = phi_9089_;
                            if (_e1201[1] < 0f) {
                                phi_9096_ = -(_e1201[1]);
                            } else {
                                phi_9096_ = _e1201[1];
                            }
                            let _e1212 = phi_9096_;
                            if (_e1208 > _e1212) {
                                phi_9101_ = _e1208;
                            } else {
                                phi_9101_ = _e1212;
                            }
                            let _e1215 = phi_9101_;
                            if (_e1201[2] < 0f) {
                                phi_9108_ = -(_e1201[2]);
                            } else {
                                phi_9108_ = _e1201[2];
                            }
                            let _e1219 = phi_9108_;
                            if (_e1215 > _e1219) {
                                phi_9113_ = _e1215;
                            } else {
                                phi_9113_ = _e1219;
                            }
                            let _e1222 = phi_9113_;
                            if (_e1198 > _e1222) {
                                phi_9118_ = _e1198;
                            } else {
                                phi_9118_ = _e1222;
                            }
                            let _e1225 = phi_9118_;
                            let _e1227 = local_18.member_3;
                            let _e1234 = local_18.member_3;
                            let _e1238 = ((((((_e1117 + _e1119) + (_e1171 + _e1173)) + (_e1225 + _e1227)) * (0.000000059604645f * 16f)) + (_e1234 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e1241 = local_18.member[0u];
                            let _e1247 = local_18.member[1u];
                            let _e1263 = local_18.member_1[0u];
                            let _e1269 = local_18.member_1[1u];
                            let _e1285 = local_18.member_2[0u];
                            let _e1291 = local_18.member_2[1u];
                            let _e1305 = function_2(array<f32, 3>((_e1241[0] + ((_e1247[0] - _e1241[0]) * _e280)), (_e1241[1] + ((_e1247[1] - _e1241[1]) * _e280)), (_e1241[2] + ((_e1247[2] - _e1241[2]) * _e280))), array<f32, 3>((_e1263[0] + ((_e1269[0] - _e1263[0]) * _e280)), (_e1263[1] + ((_e1269[1] - _e1263[1]) * _e280)), (_e1263[2] + ((_e1269[2] - _e1263[2]) * _e280))), array<f32, 3>((_e1285[0] + ((_e1291[0] - _e1285[0]) * _e280)), (_e1285[1] + ((_e1291[1] - _e1285[1]) * _e280)), (_e1285[2] + ((_e1291[2] - _e1285[2]) * _e280))), 0u);
                            if (_e1305[0] < 0f) {
                                phi_9236_ = -(_e1305[0]);
                            } else {
                                phi_9236_ = _e1305[0];
                            }
                            let _e1310 = phi_9236_;
                            if (_e1305[1] < 0f) {
                                phi_9243_ = -(_e1305[1]);
                            } else {
                                phi_9243_ = _e1305[1];
                            }
                            let _e1315 = phi_9243_;
                            if (_e1305[2] < 0f) {
                                phi_9251_ = -(_e1305[2]);
                            } else {
                                phi_9251_ = _e1305[2];
                            }
                            let _e1321 = phi_9251_;
                            let _e1322 = ((_e1310 + _e1315) + _e1321);
                            if (_e1322 > 0f) {
                                if ((bitcast<u32>(_e1322) & 2139095040u) != 2139095040u) {
                                    let _e1327 = (1f / _e1322);
                                    let _e1329 = (_e1305[0] * _e1327);
                                    let _e1331 = (_e1305[1] * _e1327);
                                    let _e1333 = (_e1305[2] * _e1327);
                                    let _e1338 = (((_e1329 * _e1329) + (_e1331 * _e1331)) + (_e1333 * _e1333));
                                    if (_e1338 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1338 > 0f) {
                                            phi_9288_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_9288_ = 0f;
                                        }
                                        let _e1391 = phi_9288_;
                                        phi_9352_ = _e1391;
                                    } else {
                                        phi_9295_ = type_14(0i, 5i);
                                        phi_9298_ = bitcast<f32>(((bitcast<u32>(_e1338) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1346 = phi_9295_;
                                            let _e1348 = phi_9298_;
                                            local_19 = _e1348;
                                            if (_e1346.member < _e1346.member_1) {
                                                let _e1355 = (_e1346.member + 1i);
                                                if ((false == (_e1355 > _e1346.member)) != false) {
                                                    phi_9319_ = true;
                                                } else {
                                                    phi_9319_ = false;
                                                }
                                                let _e1360 = phi_9319_;
                                                if _e1360 {
                                                    phi_9325_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_9325_ = type_15(1u, _e1355);
                                                }
                                                let _e1365 = phi_9325_;
                                                phi_9296_ = type_14(_e1365.member_1, _e1346.member_1);
                                                phi_9339_ = type_15(1u, _e1346.member);
                                            } else {
                                                phi_9296_ = _e1346;
                                                phi_9339_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1371 = phi_9296_;
                                            let _e1373 = phi_9339_;
                                            let _e1376 = (bitcast<i32>(_e1373.member) != 0i);
                                            if _e1376 {
                                                phi_9299_ = (0.5f * (_e1348 + (_e1338 / _e1348)));
                                            } else {
                                                phi_9299_ = f32();
                                            }
                                            let _e1381 = phi_9299_;
                                            continue;
                                            continuing {
                                                phi_9295_ = _e1371;
                                                phi_9298_ = _e1381;
                                                break if !(_e1376);
                                            }
                                        }
                                        let _e1386 = local_19;
                                        phi_9352_ = (_e1386 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1393 = phi_9352_;
                                    let _e1394 = (0.000000059604645f * 12f);
                                    let _e1399 = ((_e1238 * 1.01f) + ((0f * _e1393) * (1f + _e1394)));
                                    let _e1404 = (((_e1329 * _e1021[0]) + (_e1331 * _e1021[1])) + (_e1333 * _e1021[2]));
                                    let _e1409 = (((_e1329 * _e1037) + (_e1331 * _e1038)) + (_e1333 * _e1039));
                                    let _e1414 = (((_e1329 * _e1040) + (_e1331 * _e1041)) + (_e1333 * _e1042));
                                    let _e1419 = (((_e1329 * _e1021[0]) + (_e1331 * _e1021[1])) + (_e1333 * _e1021[2]));
                                    let _e1425 = (((_e1329 * _e1045[0]) + (_e1331 * _e1045[1])) + (_e1333 * _e1045[2]));
                                    let _e1430 = (((_e1329 * _e1061) + (_e1331 * _e1062)) + (_e1333 * _e1063));
                                    let _e1435 = (((_e1329 * _e1064) + (_e1331 * _e1065)) + (_e1333 * _e1066));
                                    let _e1440 = (((_e1329 * _e1045[0]) + (_e1331 * _e1045[1])) + (_e1333 * _e1045[2]));
                                    if (_e1404 < 0f) {
                                        phi_9418_ = -(_e1404);
                                    } else {
                                        phi_9418_ = _e1404;
                                    }
                                    let _e1445 = phi_9418_;
                                    if (_e1425 < 0f) {
                                        phi_9424_ = -(_e1425);
                                    } else {
                                        phi_9424_ = _e1425;
                                    }
                                    let _e1449 = phi_9424_;
                                    if (_e1409 < 0f) {
                                        phi_9433_ = -(_e1409);
                                    } else {
                                        phi_9433_ = _e1409;
                                    }
                                    let _e1456 = phi_9433_;
                                    if (_e1430 < 0f) {
                                        phi_9439_ = -(_e1430);
                                    } else {
                                        phi_9439_ = _e1430;
                                    }
                                    let _e1460 = phi_9439_;
                                    if (_e1414 < 0f) {
                                        phi_9448_ = -(_e1414);
                                    } else {
                                        phi_9448_ = _e1414;
                                    }
                                    let _e1467 = phi_9448_;
                                    if (_e1435 < 0f) {
                                        phi_9454_ = -(_e1435);
                                    } else {
                                        phi_9454_ = _e1435;
                                    }
                                    let _e1471 = phi_9454_;
                                    if (_e1419 < 0f) {
                                        phi_9463_ = -(_e1419);
                                    } else {
                                        phi_9463_ = _e1419;
                                    }
                                    let _e1478 = phi_9463_;
                                    if (_e1440 < 0f) {
                                        phi_9469_ = -(_e1440);
                                    } else {
                                        phi_9469_ = _e1440;
                                    }
                                    let _e1482 = phi_9469_;
                                    phi_9475_ = type_32(array<f32, 4>(_e1404, _e1409, _e1414, _e1419), array<f32, 4>(_e1425, _e1430, _e1435, _e1440), array<f32, 4>((_e1399 + ((_e1445 + _e1449) * _e1394)), (_e1399 + ((_e1456 + _e1460) * _e1394)), (_e1399 + ((_e1467 + _e1471) * _e1394)), (_e1399 + ((_e1478 + _e1482) * _e1394))));
                                    phi_9476_ = false;
                                } else {
                                    phi_9475_ = type_32();
                                    phi_9476_ = true;
                                }
                                let _e1489 = phi_9475_;
                                let _e1491 = phi_9476_;
                                phi_9477_ = _e1489;
                                phi_9478_ = _e1491;
                            } else {
                                phi_9477_ = type_32();
                                phi_9478_ = true;
                            }
                            let _e1493 = phi_9477_;
                            let _e1495 = phi_9478_;
                            if _e1495 {
                                phi_9486_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                            } else {
                                phi_9486_ = _e1493;
                            }
                            let _e1497 = phi_9486_;
                            local_8 = type_32(array<f32, 4>(_e1497.member[0], _e1497.member[1], _e1497.member[2], _e1497.member[3]), array<f32, 4>(_e1497.member_1[0], _e1497.member_1[1], _e1497.member_1[2], _e1497.member_1[3]), array<f32, 4>(_e1497.member_2[0], _e1497.member_2[1], _e1497.member_2[2], _e1497.member_2[3]));
                            let _e1519 = local_8.member[0u];
                            let _e1522 = local_8.member_1[0u];
                            let _e1525 = local_8.member[0u];
                            let _e1531 = local_8.member_2[0u];
                            if (((_e1519 + ((_e1522 - _e1525) * _e280)) - _e1531) > 0f) {
                                let _e1536 = local_8.member[1u];
                                let _e1539 = local_8.member_1[1u];
                                let _e1542 = local_8.member[1u];
                                let _e1548 = local_8.member_2[1u];
                                if (((_e1536 + ((_e1539 - _e1542) * _e280)) - _e1548) > 0f) {
                                    let _e1553 = local_8.member[2u];
                                    let _e1556 = local_8.member_1[2u];
                                    let _e1559 = local_8.member[2u];
                                    let _e1565 = local_8.member_2[2u];
                                    if (((_e1553 + ((_e1556 - _e1559) * _e280)) - _e1565) > 0f) {
                                        let _e1570 = local_8.member[3u];
                                        let _e1573 = local_8.member_1[3u];
                                        let _e1576 = local_8.member[3u];
                                        let _e1582 = local_8.member_2[3u];
                                        phi_9655_ = (((_e1570 + ((_e1573 - _e1576) * _e280)) - _e1582) > 0f);
                                        phi_9656_ = false;
                                    } else {
                                        phi_9655_ = bool();
                                        phi_9656_ = true;
                                    }
                                    let _e1586 = phi_9655_;
                                    let _e1588 = phi_9656_;
                                    phi_9657_ = _e1586;
                                    phi_9658_ = _e1588;
                                } else {
                                    phi_9657_ = bool();
                                    phi_9658_ = true;
                                }
                                let _e1590 = phi_9657_;
                                let _e1592 = phi_9658_;
                                phi_9659_ = _e1590;
                                phi_9660_ = _e1592;
                            } else {
                                phi_9659_ = bool();
                                phi_9660_ = true;
                            }
                            let _e1594 = phi_9659_;
                            let _e1596 = phi_9660_;
                            if _e1596 {
                                phi_9664_ = false;
                            } else {
                                phi_9664_ = _e1594;
                            }
                            let _e1598 = phi_9664_;
                            if _e1598 {
                                phi_11018_ = bool();
                                phi_11019_ = true;
                            } else {
                                if (_e1305[0] < 0f) {
                                    phi_9691_ = -(_e1305[0]);
                                } else {
                                    phi_9691_ = _e1305[0];
                                }
                                let _e1603 = phi_9691_;
                                let _e1605 = ((_e1603 + 0f) + 0f);
                                if (_e1605 > 0f) {
                                    if ((bitcast<u32>(_e1605) & 2139095040u) != 2139095040u) {
                                        let _e1610 = (1f / _e1605);
                                        let _e1611 = (_e1305[0] * _e1610);
                                        let _e1612 = (0f * _e1610);
                                        let _e1613 = (0f * _e1610);
                                        let _e1618 = (((_e1611 * _e1611) + (_e1612 * _e1612)) + (_e1613 * _e1613));
                                        if (_e1618 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e1618 > 0f) {
                                                phi_9738_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_9738_ = 0f;
                                            }
                                            let _e1671 = phi_9738_;
                                            phi_9802_ = _e1671;
                                        } else {
                                            phi_9745_ = type_14(0i, 5i);
                                            phi_9748_ = bitcast<f32>(((bitcast<u32>(_e1618) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e1626 = phi_9745_;
                                                let _e1628 = phi_9748_;
                                                local_20 = _e1628;
                                                if (_e1626.member < _e1626.member_1) {
                                                    let _e1635 = (_e1626.member + 1i);
                                                    if ((false == (_e1635 > _e1626.member)) != false) {
                                                        phi_9769_ = true;
                                                    } else {
                                                        phi_9769_ = false;
                                                    }
                                                    let _e1640 = phi_9769_;
                                                    if _e1640 {
                                                        phi_9775_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_9775_ = type_15(1u, _e1635);
                                                    }
                                                    let _e1645 = phi_9775_;
                                                    phi_9746_ = type_14(_e1645.member_1, _e1626.member_1);
                                                    phi_9789_ = type_15(1u, _e1626.member);
                                                } else {
                                                    phi_9746_ = _e1626;
                                                    phi_9789_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e1651 = phi_9746_;
                                                let _e1653 = phi_9789_;
                                                let _e1656 = (bitcast<i32>(_e1653.member) != 0i);
                                                if _e1656 {
                                                    phi_9749_ = (0.5f * (_e1628 + (_e1618 / _e1628)));
                                                } else {
                                                    phi_9749_ = f32();
                                                }
                                                let _e1661 = phi_9749_;
                                                continue;
                                                continuing {
                                                    phi_9745_ = _e1651;
                                                    phi_9748_ = _e1661;
                                                    break if !(_e1656);
                                                }
                                            }
                                            let _e1666 = local_20;
                                            phi_9802_ = (_e1666 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e1673 = phi_9802_;
                                        let _e1674 = (0.000000059604645f * 12f);
                                        let _e1679 = ((_e1238 * 1.01f) + ((0f * _e1673) * (1f + _e1674)));
                                        let _e1684 = (((_e1611 * _e1021[0]) + (_e1612 * _e1021[1])) + (_e1613 * _e1021[2]));
                                        let _e1689 = (((_e1611 * _e1037) + (_e1612 * _e1038)) + (_e1613 * _e1039));
                                        let _e1694 = (((_e1611 * _e1040) + (_e1612 * _e1041)) + (_e1613 * _e1042));
                                        let _e1699 = (((_e1611 * _e1021[0]) + (_e1612 * _e1021[1])) + (_e1613 * _e1021[2]));
                                        let _e1705 = (((_e1611 * _e1045[0]) + (_e1612 * _e1045[1])) + (_e1613 * _e1045[2]));
                                        let _e1710 = (((_e1611 * _e1061) + (_e1612 * _e1062)) + (_e1613 * _e1063));
                                        let _e1715 = (((_e1611 * _e1064) + (_e1612 * _e1065)) + (_e1613 * _e1066));
                                        let _e1720 = (((_e1611 * _e1045[0]) + (_e1612 * _e1045[1])) + (_e1613 * _e1045[2]));
                                        if (_e1684 < 0f) {
                                            phi_9868_ = -(_e1684);
                                        } else {
                                            phi_9868_ = _e1684;
                                        }
                                        let _e1725 = phi_9868_;
                                        if (_e1705 < 0f) {
                                            phi_9874_ = -(_e1705);
                                        } else {
                                            phi_9874_ = _e1705;
                                        }
                                        let _e1729 = phi_9874_;
                                        if (_e1689 < 0f) {
                                            phi_9883_ = -(_e1689);
                                        } else {
                                            phi_9883_ = _e1689;
                                        }
                                        let _e1736 = phi_9883_;
                                        if (_e1710 < 0f) {
                                            phi_9889_ = -(_e1710);
                                        } else {
                                            phi_9889_ = _e1710;
                                        }
                                        let _e1740 = phi_9889_;
                                        if (_e1694 < 0f) {
                                            phi_9898_ = -(_e1694);
                                        } else {
                                            phi_9898_ = _e1694;
                                        }
                                        let _e1747 = phi_9898_;
                                        if (_e1715 < 0f) {
                                            phi_9904_ = -(_e1715);
                                        } else {
                                            phi_9904_ = _e1715;
                                        }
                                        let _e1751 = phi_9904_;
                                        if (_e1699 < 0f) {
                                            phi_9913_ = -(_e1699);
                                        } else {
                                            phi_9913_ = _e1699;
                                        }
                                        let _e1758 = phi_9913_;
                                        if (_e1720 < 0f) {
                                            phi_9919_ = -(_e1720);
                                        } else {
                                            phi_9919_ = _e1720;
                                        }
                                        let _e1762 = phi_9919_;
                                        phi_9925_ = type_32(array<f32, 4>(_e1684, _e1689, _e1694, _e1699), array<f32, 4>(_e1705, _e1710, _e1715, _e1720), array<f32, 4>((_e1679 + ((_e1725 + _e1729) * _e1674)), (_e1679 + ((_e1736 + _e1740) * _e1674)), (_e1679 + ((_e1747 + _e1751) * _e1674)), (_e1679 + ((_e1758 + _e1762) * _e1674))));
                                        phi_9926_ = false;
                                    } else {
                                        phi_9925_ = type_32();
                                        phi_9926_ = true;
                                    }
                                    let _e1769 = phi_9925_;
                                    let _e1771 = phi_9926_;
                                    phi_9927_ = _e1769;
                                    phi_9928_ = _e1771;
                                } else {
                                    phi_9927_ = type_32();
                                    phi_9928_ = true;
                                }
                                let _e1773 = phi_9927_;
                                let _e1775 = phi_9928_;
                                if _e1775 {
                                    phi_9936_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_9936_ = _e1773;
                                }
                                let _e1777 = phi_9936_;
                                local_9 = type_32(array<f32, 4>(_e1777.member[0], _e1777.member[1], _e1777.member[2], _e1777.member[3]), array<f32, 4>(_e1777.member_1[0], _e1777.member_1[1], _e1777.member_1[2], _e1777.member_1[3]), array<f32, 4>(_e1777.member_2[0], _e1777.member_2[1], _e1777.member_2[2], _e1777.member_2[3]));
                                let _e1799 = local_9.member[0u];
                                let _e1802 = local_9.member_1[0u];
                                let _e1805 = local_9.member[0u];
                                let _e1811 = local_9.member_2[0u];
                                if (((_e1799 + ((_e1802 - _e1805) * _e280)) - _e1811) > 0f) {
                                    let _e1816 = local_9.member[1u];
                                    let _e1819 = local_9.member_1[1u];
                                    let _e1822 = local_9.member[1u];
                                    let _e1828 = local_9.member_2[1u];
                                    if (((_e1816 + ((_e1819 - _e1822) * _e280)) - _e1828) > 0f) {
                                        let _e1833 = local_9.member[2u];
                                        let _e1836 = local_9.member_1[2u];
                                        let _e1839 = local_9.member[2u];
                                        let _e1845 = local_9.member_2[2u];
                                        if (((_e1833 + ((_e1836 - _e1839) * _e280)) - _e1845) > 0f) {
                                            let _e1850 = local_9.member[3u];
                                            let _e1853 = local_9.member_1[3u];
                                            let _e1856 = local_9.member[3u];
                                            let _e1862 = local_9.member_2[3u];
                                            phi_10105_ = (((_e1850 + ((_e1853 - _e1856) * _e280)) - _e1862) > 0f);
                                            phi_10106_ = false;
                                        } else {
                                            phi_10105_ = bool();
                                            phi_10106_ = true;
                                        }
                                        let _e1866 = phi_10105_;
                                        let _e1868 = phi_10106_;
                                        phi_10107_ = _e1866;
                                        phi_10108_ = _e1868;
                                    } else {
                                        phi_10107_ = bool();
                                        phi_10108_ = true;
                                    }
                                    let _e1870 = phi_10107_;
                                    let _e1872 = phi_10108_;
                                    phi_10109_ = _e1870;
                                    phi_10110_ = _e1872;
                                } else {
                                    phi_10109_ = bool();
                                    phi_10110_ = true;
                                }
                                let _e1874 = phi_10109_;
                                let _e1876 = phi_10110_;
                                if _e1876 {
                                    phi_10114_ = false;
                                } else {
                                    phi_10114_ = _e1874;
                                }
                                let _e1878 = phi_10114_;
                                if _e1878 {
                                    phi_11016_ = bool();
                                    phi_11017_ = true;
                                } else {
                                    if (_e1305[1] < 0f) {
                                        phi_10147_ = -(_e1305[1]);
                                    } else {
                                        phi_10147_ = _e1305[1];
                                    }
                                    let _e1883 = phi_10147_;
                                    let _e1885 = ((0f + _e1883) + 0f);
                                    if (_e1885 > 0f) {
                                        if ((bitcast<u32>(_e1885) & 2139095040u) != 2139095040u) {
                                            let _e1890 = (1f / _e1885);
                                            let _e1891 = (0f * _e1890);
                                            let _e1892 = (_e1305[1] * _e1890);
                                            let _e1893 = (0f * _e1890);
                                            let _e1898 = (((_e1891 * _e1891) + (_e1892 * _e1892)) + (_e1893 * _e1893));
                                            if (_e1898 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e1898 > 0f) {
                                                    phi_10188_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_10188_ = 0f;
                                                }
                                                let _e1951 = phi_10188_;
                                                phi_10252_ = _e1951;
                                            } else {
                                                phi_10195_ = type_14(0i, 5i);
                                                phi_10198_ = bitcast<f32>(((bitcast<u32>(_e1898) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1906 = phi_10195_;
                                                    let _e1908 = phi_10198_;
                                                    local_21 = _e1908;
                                                    if (_e1906.member < _e1906.member_1) {
                                                        let _e1915 = (_e1906.member + 1i);
                                                        if ((false == (_e1915 > _e1906.member)) != false) {
                                                            phi_10219_ = true;
                                                        } else {
                                                            phi_10219_ = false;
                                                        }
                                                        let _e1920 = phi_10219_;
                                                        if _e1920 {
                                                            phi_10225_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_10225_ = type_15(1u, _e1915);
                                                        }
                                                        let _e1925 = phi_10225_;
                                                        phi_10196_ = type_14(_e1925.member_1, _e1906.member_1);
                                                        phi_10239_ = type_15(1u, _e1906.member);
                                                    } else {
                                                        phi_10196_ = _e1906;
                                                        phi_10239_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1931 = phi_10196_;
                                                    let _e1933 = phi_10239_;
                                                    let _e1936 = (bitcast<i32>(_e1933.member) != 0i);
                                                    if _e1936 {
                                                        phi_10199_ = (0.5f * (_e1908 + (_e1898 / _e1908)));
                                                    } else {
                                                        phi_10199_ = f32();
                                                    }
                                                    let _e1941 = phi_10199_;
                                                    continue;
                                                    continuing {
                                                        phi_10195_ = _e1931;
                                                        phi_10198_ = _e1941;
                                                        break if !(_e1936);
                                                    }
                                                }
                                                let _e1946 = local_21;
                                                phi_10252_ = (_e1946 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1953 = phi_10252_;
                                            let _e1954 = (0.000000059604645f * 12f);
                                            let _e1959 = ((_e1238 * 1.01f) + ((0f * _e1953) * (1f + _e1954)));
                                            let _e1964 = (((_e1891 * _e1021[0]) + (_e1892 * _e1021[1])) + (_e1893 * _e1021[2]));
                                            let _e1969 = (((_e1891 * _e1037) + (_e1892 * _e1038)) + (_e1893 * _e1039));
                                            let _e1974 = (((_e1891 * _e1040) + (_e1892 * _e1041)) + (_e1893 * _e1042));
                                            let _e1979 = (((_e1891 * _e1021[0]) + (_e1892 * _e1021[1])) + (_e1893 * _e1021[2]));
                                            let _e1985 = (((_e1891 * _e1045[0]) + (_e1892 * _e1045[1])) + (_e1893 * _e1045[2]));
                                            let _e1990 = (((_e1891 * _e1061) + (_e1892 * _e1062)) + (_e1893 * _e1063));
                                            let _e1995 = (((_e1891 * _e1064) + (_e1892 * _e1065)) + (_e1893 * _e1066));
                                            let _e2000 = (((_e1891 * _e1045[0]) + (_e1892 * _e1045[1])) + (_e1893 * _e1045[2]));
                                            if (_e1964 < 0f) {
                                                phi_10318_ = -(_e1964);
                                            } else {
                                                phi_10318_ = _e1964;
                                            }
                                            let _e2005 = phi_10318_;
                                            if (_e1985 < 0f) {
                                                phi_10324_ = -(_e1985);
                                            } else {
                                                phi_10324_ = _e1985;
                                            }
                                            let _e2009 = phi_10324_;
                                            if (_e1969 < 0f) {
                                                phi_10333_ = -(_e1969);
                                            } else {
                                                phi_10333_ = _e1969;
                                            }
                                            let _e2016 = phi_10333_;
                                            if (_e1990 < 0f) {
                                                phi_10339_ = -(_e1990);
                                            } else {
                                                phi_10339_ = _e1990;
                                            }
                                            let _e2020 = phi_10339_;
                                            if (_e1974 < 0f) {
                                                phi_10348_ = -(_e1974);
                                            } else {
                                                phi_10348_ = _e1974;
                                            }
                                            let _e2027 = phi_10348_;
                                            if (_e1995 < 0f) {
                                                phi_10354_ = -(_e1995);
                                            } else {
                                                phi_10354_ = _e1995;
                                            }
                                            let _e2031 = phi_10354_;
                                            if (_e1979 < 0f) {
                                                phi_10363_ = -(_e1979);
                                            } else {
                                                phi_10363_ = _e1979;
                                            }
                                            let _e2038 = phi_10363_;
                                            if (_e2000 < 0f) {
                                                phi_10369_ = -(_e2000);
                                            } else {
                                                phi_10369_ = _e2000;
                                            }
                                            let _e2042 = phi_10369_;
                                            phi_10375_ = type_32(array<f32, 4>(_e1964, _e1969, _e1974, _e1979), array<f32, 4>(_e1985, _e1990, _e1995, _e2000), array<f32, 4>((_e1959 + ((_e2005 + _e2009) * _e1954)), (_e1959 + ((_e2016 + _e2020) * _e1954)), (_e1959 + ((_e2027 + _e2031) * _e1954)), (_e1959 + ((_e2038 + _e2042) * _e1954))));
                                            phi_10376_ = false;
                                        } else {
                                            phi_10375_ = type_32();
                                            phi_10376_ = true;
                                        }
                                        let _e2049 = phi_10375_;
                                        let _e2051 = phi_10376_;
                                        phi_10377_ = _e2049;
                                        phi_10378_ = _e2051;
                                    } else {
                                        phi_10377_ = type_32();
                                        phi_10378_ = true;
                                    }
                                    let _e2053 = phi_10377_;
                                    let _e2055 = phi_10378_;
                                    if _e2055 {
                                        phi_10386_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    } else {
                                        phi_10386_ = _e2053;
                                    }
                                    let _e2057 = phi_10386_;
                                    local_10 = type_32(array<f32, 4>(_e2057.member[0], _e2057.member[1], _e2057.member[2], _e2057.member[3]), array<f32, 4>(_e2057.member_1[0], _e2057.member_1[1], _e2057.member_1[2], _e2057.member_1[3]), array<f32, 4>(_e2057.member_2[0], _e2057.member_2[1], _e2057.member_2[2], _e2057.member_2[3]));
                                    let _e2079 = local_10.member[0u];
                                    let _e2082 = local_10.member_1[0u];
                                    let _e2085 = local_10.member[0u];
                                    let _e2091 = local_10.member_2[0u];
                                    if (((_e2079 + ((_e2082 - _e2085) * _e280)) - _e2091) > 0f) {
                                        let _e2096 = local_10.member[1u];
                                        let _e2099 = local_10.member_1[1u];
                                        let _e2102 = local_10.member[1u];
                                        let _e2108 = local_10.member_2[1u];
                                        if (((_e2096 + ((_e2099 - _e2102) * _e280)) - _e2108) > 0f) {
                                            let _e2113 = local_10.member[2u];
                                            let _e2116 = local_10.member_1[2u];
                                            let _e2119 = local_10.member[2u];
                                            let _e2125 = local_10.member_2[2u];
                                            if (((_e2113 + ((_e2116 - _e2119) * _e280)) - _e2125) > 0f) {
                                                let _e2130 = local_10.member[3u];
                                                let _e2133 = local_10.member_1[3u];
                                                let _e2136 = local_10.member[3u];
                                                let _e2142 = local_10.member_2[3u];
                                                phi_10555_ = (((_e2130 + ((_e2133 - _e2136) * _e280)) - _e2142) > 0f);
                                                phi_10556_ = false;
                                            } else {
                                                phi_10555_ = bool();
                                                phi_10556_ = true;
                                            }
                                            let _e2146 = phi_10555_;
                                            let _e2148 = phi_10556_;
                                            phi_10557_ = _e2146;
                                            phi_10558_ = _e2148;
                                        } else {
                                            phi_10557_ = bool();
                                            phi_10558_ = true;
                                        }
                                        let _e2150 = phi_10557_;
                                        let _e2152 = phi_10558_;
                                        phi_10559_ = _e2150;
                                        phi_10560_ = _e2152;
                                    } else {
                                        phi_10559_ = bool();
                                        phi_10560_ = true;
                                    }
                                    let _e2154 = phi_10559_;
                                    let _e2156 = phi_10560_;
                                    if _e2156 {
                                        phi_10564_ = false;
                                    } else {
                                        phi_10564_ = _e2154;
                                    }
                                    let _e2158 = phi_10564_;
                                    if _e2158 {
                                        phi_11015_ = bool();
                                    } else {
                                        if (_e1305[2] < 0f) {
                                            phi_10604_ = -(_e1305[2]);
                                        } else {
                                            phi_10604_ = _e1305[2];
                                        }
                                        let _e2164 = phi_10604_;
                                        let _e2165 = ((0f + 0f) + _e2164);
                                        if (_e2165 > 0f) {
                                            if ((bitcast<u32>(_e2165) & 2139095040u) != 2139095040u) {
                                                let _e2170 = (1f / _e2165);
                                                let _e2171 = (0f * _e2170);
                                                let _e2172 = (0f * _e2170);
                                                let _e2173 = (_e1305[2] * _e2170);
                                                let _e2178 = (((_e2171 * _e2171) + (_e2172 * _e2172)) + (_e2173 * _e2173));
                                                if (_e2178 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e2178 > 0f) {
                                                        phi_10638_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_10638_ = 0f;
                                                    }
                                                    let _e2231 = phi_10638_;
                                                    phi_10702_ = _e2231;
                                                } else {
                                                    phi_10645_ = type_14(0i, 5i);
                                                    phi_10648_ = bitcast<f32>(((bitcast<u32>(_e2178) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e2186 = phi_10645_;
                                                        let _e2188 = phi_10648_;
                                                        local_22 = _e2188;
                                                        if (_e2186.member < _e2186.member_1) {
                                                            let _e2195 = (_e2186.member + 1i);
                                                            if ((false == (_e2195 > _e2186.member)) != false) {
                                                                phi_10669_ = true;
                                                            } else {
                                                                phi_10669_ = false;
                                                            }
                                                            let _e2200 = phi_10669_;
                                                            if _e2200 {
                                                                phi_10675_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_10675_ = type_15(1u, _e2195);
                                                            }
                                                            let _e2205 = phi_10675_;
                                                            phi_10646_ = type_14(_e2205.member_1, _e2186.member_1);
                                                            phi_10689_ = type_15(1u, _e2186.member);
                                                        } else {
                                                            phi_10646_ = _e2186;
                                                            phi_10689_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e2211 = phi_10646_;
                                                        let _e2213 = phi_10689_;
                                                        let _e2216 = (bitcast<i32>(_e2213.member) != 0i);
                                                        if _e2216 {
                                                            phi_10649_ = (0.5f * (_e2188 + (_e2178 / _e2188)));
                                                        } else {
                                                            phi_10649_ = f32();
                                                        }
                                                        let _e2221 = phi_10649_;
                                                        continue;
                                                        continuing {
                                                            phi_10645_ = _e2211;
                                                            phi_10648_ = _e2221;
                                                            break if !(_e2216);
                                                        }
                                                    }
                                                    let _e2226 = local_22;
                                                    phi_10702_ = (_e2226 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e2233 = phi_10702_;
                                                let _e2234 = (0.000000059604645f * 12f);
                                                let _e2239 = ((_e1238 * 1.01f) + ((0f * _e2233) * (1f + _e2234)));
                                                let _e2244 = (((_e2171 * _e1021[0]) + (_e2172 * _e1021[1])) + (_e2173 * _e1021[2]));
                                                let _e2249 = (((_e2171 * _e1037) + (_e2172 * _e1038)) + (_e2173 * _e1039));
                                                let _e2254 = (((_e2171 * _e1040) + (_e2172 * _e1041)) + (_e2173 * _e1042));
                                                let _e2259 = (((_e2171 * _e1021[0]) + (_e2172 * _e1021[1])) + (_e2173 * _e1021[2]));
                                                let _e2265 = (((_e2171 * _e1045[0]) + (_e2172 * _e1045[1])) + (_e2173 * _e1045[2]));
                                                let _e2270 = (((_e2171 * _e1061) + (_e2172 * _e1062)) + (_e2173 * _e1063));
                                                let _e2275 = (((_e2171 * _e1064) + (_e2172 * _e1065)) + (_e2173 * _e1066));
                                                let _e2280 = (((_e2171 * _e1045[0]) + (_e2172 * _e1045[1])) + (_e2173 * _e1045[2]));
                                                if (_e2244 < 0f) {
                                                    phi_10768_ = -(_e2244);
                                                } else {
                                                    phi_10768_ = _e2244;
                                                }
                                                let _e2285 = phi_10768_;
                                                if (_e2265 < 0f) {
                                                    phi_10774_ = -(_e2265);
                                                } else {
                                                    phi_10774_ = _e2265;
                                                }
                                                let _e2289 = phi_10774_;
                                                if (_e2249 < 0f) {
                                                    phi_10783_ = -(_e2249);
                                                } else {
                                                    phi_10783_ = _e2249;
                                                }
                                                let _e2296 = phi_10783_;
                                                if (_e2270 < 0f) {
                                                    phi_10789_ = -(_e2270);
                                                } else {
                                                    phi_10789_ = _e2270;
                                                }
                                                let _e2300 = phi_10789_;
                                                if (_e2254 < 0f) {
                                                    phi_10798_ = -(_e2254);
                                                } else {
                                                    phi_10798_ = _e2254;
                                                }
                                                let _e2307 = phi_10798_;
                                                if (_e2275 < 0f) {
                                                    phi_10804_ = -(_e2275);
                                                } else {
                                                    phi_10804_ = _e2275;
                                                }
                                                let _e2311 = phi_10804_;
                                                if (_e2259 < 0f) {
                                                    phi_10813_ = -(_e2259);
                                                } else {
                                                    phi_10813_ = _e2259;
                                                }
                                                let _e2318 = phi_10813_;
                                                if (_e2280 < 0f) {
                                                    phi_10819_ = -(_e2280);
                                                } else {
                                                    phi_10819_ = _e2280;
                                                }
                                                let _e2322 = phi_10819_;
                                                phi_10825_ = type_32(array<f32, 4>(_e2244, _e2249, _e2254, _e2259), array<f32, 4>(_e2265, _e2270, _e2275, _e2280), array<f32, 4>((_e2239 + ((_e2285 + _e2289) * _e2234)), (_e2239 + ((_e2296 + _e2300) * _e2234)), (_e2239 + ((_e2307 + _e2311) * _e2234)), (_e2239 + ((_e2318 + _e2322) * _e2234))));
                                                phi_10826_ = false;
                                            } else {
                                                phi_10825_ = type_32();
                                                phi_10826_ = true;
                                            }
                                            let _e2329 = phi_10825_;
                                            let _e2331 = phi_10826_;
                                            phi_10827_ = _e2329;
                                            phi_10828_ = _e2331;
                                        } else {
                                            phi_10827_ = type_32();
                                            phi_10828_ = true;
                                        }
                                        let _e2333 = phi_10827_;
                                        let _e2335 = phi_10828_;
                                        if _e2335 {
                                            phi_10836_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_10836_ = _e2333;
                                        }
                                        let _e2337 = phi_10836_;
                                        local_11 = type_32(array<f32, 4>(_e2337.member[0], _e2337.member[1], _e2337.member[2], _e2337.member[3]), array<f32, 4>(_e2337.member_1[0], _e2337.member_1[1], _e2337.member_1[2], _e2337.member_1[3]), array<f32, 4>(_e2337.member_2[0], _e2337.member_2[1], _e2337.member_2[2], _e2337.member_2[3]));
                                        let _e2359 = local_11.member[0u];
                                        let _e2362 = local_11.member_1[0u];
                                        let _e2365 = local_11.member[0u];
                                        let _e2371 = local_11.member_2[0u];
                                        if (((_e2359 + ((_e2362 - _e2365) * _e280)) - _e2371) > 0f) {
                                            let _e2376 = local_11.member[1u];
                                            let _e2379 = local_11.member_1[1u];
                                            let _e2382 = local_11.member[1u];
                                            let _e2388 = local_11.member_2[1u];
                                            if (((_e2376 + ((_e2379 - _e2382) * _e280)) - _e2388) > 0f) {
                                                let _e2393 = local_11.member[2u];
                                                let _e2396 = local_11.member_1[2u];
                                                let _e2399 = local_11.member[2u];
                                                let _e2405 = local_11.member_2[2u];
                                                if (((_e2393 + ((_e2396 - _e2399) * _e280)) - _e2405) > 0f) {
                                                    let _e2410 = local_11.member[3u];
                                                    let _e2413 = local_11.member_1[3u];
                                                    let _e2416 = local_11.member[3u];
                                                    let _e2422 = local_11.member_2[3u];
                                                    phi_11005_ = (((_e2410 + ((_e2413 - _e2416) * _e280)) - _e2422) > 0f);
                                                    phi_11006_ = false;
                                                } else {
                                                    phi_11005_ = bool();
                                                    phi_11006_ = true;
                                                }
                                                let _e2426 = phi_11005_;
                                                let _e2428 = phi_11006_;
                                                phi_11007_ = _e2426;
                                                phi_11008_ = _e2428;
                                            } else {
                                                phi_11007_ = bool();
                                                phi_11008_ = true;
                                            }
                                            let _e2430 = phi_11007_;
                                            let _e2432 = phi_11008_;
                                            phi_11009_ = _e2430;
                                            phi_11010_ = _e2432;
                                        } else {
                                            phi_11009_ = bool();
                                            phi_11010_ = true;
                                        }
                                        let _e2434 = phi_11009_;
                                        let _e2436 = phi_11010_;
                                        if _e2436 {
                                            phi_11014_ = false;
                                        } else {
                                            phi_11014_ = _e2434;
                                        }
                                        let _e2438 = phi_11014_;
                                        phi_11015_ = _e2438;
                                    }
                                    let _e2440 = phi_11015_;
                                    phi_11016_ = _e2440;
                                    phi_11017_ = _e2158;
                                }
                                let _e2442 = phi_11016_;
                                let _e2444 = phi_11017_;
                                phi_11018_ = _e2442;
                                phi_11019_ = _e2444;
                            }
                            let _e2446 = phi_11018_;
                            let _e2448 = phi_11019_;
                            if _e2448 {
                                phi_11023_ = true;
                            } else {
                                phi_11023_ = _e2446;
                            }
                            let _e2450 = phi_11023_;
                            if !(_e2450) {
                                phi_11029_ = type_28(2u, _e280);
                                phi_11030_ = false;
                            } else {
                                phi_11029_ = type_28();
                                phi_11030_ = true;
                            }
                            let _e2454 = phi_11029_;
                            let _e2456 = phi_11030_;
                            phi_11031_ = _e2454;
                            phi_11032_ = _e2456;
                        } else {
                            phi_11031_ = type_28();
                            phi_11032_ = true;
                        }
                        let _e2458 = phi_11031_;
                        let _e2460 = phi_11032_;
                        if _e2460 {
                            let _e2466 = ((_e642 - (3f * _e619)) * _e996);
                            let _e2467 = ((_e665 - _e642) * _e996);
                            let _e2468 = (((3f * _e676) - _e665) * _e996);
                            local_6[0u] = 0f;
                            local_6[1u] = 1f;
                            local_6[2u] = 1f;
                            local_6[3u] = 1f;
                            let _e2475 = ((_e2467 * _e2467) - (_e2466 * _e2468));
                            if (_e2475 > 0f) {
                                if (_e2475 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e2475 > 0f) {
                                        phi_11068_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_11068_ = 0f;
                                    }
                                    let _e2529 = phi_11068_;
                                    phi_11132_ = _e2529;
                                } else {
                                    phi_11075_ = type_14(0i, 5i);
                                    phi_11078_ = bitcast<f32>(((bitcast<u32>(_e2475) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e2484 = phi_11075_;
                                        let _e2486 = phi_11078_;
                                        local_23 = _e2486;
                                        if (_e2484.member < _e2484.member_1) {
                                            let _e2493 = (_e2484.member + 1i);
                                            if ((false == (_e2493 > _e2484.member)) != false) {
                                                phi_11099_ = true;
                                            } else {
                                                phi_11099_ = false;
                                            }
                                            let _e2498 = phi_11099_;
                                            if _e2498 {
                                                phi_11105_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_11105_ = type_15(1u, _e2493);
                                            }
                                            let _e2503 = phi_11105_;
                                            phi_11076_ = type_14(_e2503.member_1, _e2484.member_1);
                                            phi_11119_ = type_15(1u, _e2484.member);
                                        } else {
                                            phi_11076_ = _e2484;
                                            phi_11119_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2509 = phi_11076_;
                                        let _e2511 = phi_11119_;
                                        let _e2514 = (bitcast<i32>(_e2511.member) != 0i);
                                        if _e2514 {
                                            phi_11079_ = (0.5f * (_e2486 + (_e2475 / _e2486)));
                                        } else {
                                            phi_11079_ = f32();
                                        }
                                        let _e2519 = phi_11079_;
                                        continue;
                                        continuing {
                                            phi_11075_ = _e2509;
                                            phi_11078_ = _e2519;
                                            break if !(_e2514);
                                        }
                                    }
                                    let _e2524 = local_23;
                                    phi_11132_ = (_e2524 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2531 = phi_11132_;
                                if (_e2467 < 0f) {
                                    phi_11138_ = -(_e2531);
                                } else {
                                    phi_11138_ = _e2531;
                                }
                                let _e2535 = phi_11138_;
                                let _e2537 = -((_e2467 + _e2535));
                                local_7[0u] = (_e2537 / (_e2537 + _e2468));
                                local_7[1u] = (_e2466 / (_e2466 + _e2537));
                                let _e2546 = local_7[1u];
                                let _e2547 = local_7[0u];
                                if (_e2546 < _e2547) {
                                    let _e2550 = local_7[1u];
                                    let _e2552 = local_7[0u];
                                    local_7[0u] = _e2550;
                                    local_7[1u] = _e2552;
                                }
                                phi_11163_ = type_12(0u, 2u);
                                phi_11166_ = 1u;
                                loop {
                                    let _e2556 = phi_11163_;
                                    let _e2558 = phi_11166_;
                                    local_63 = _e2558;
                                    if (_e2556.member < _e2556.member_1) {
                                        phi_11164_ = type_12((_e2556.member + 1u), _e2556.member_1);
                                        phi_11189_ = type_12(1u, _e2556.member);
                                    } else {
                                        phi_11164_ = _e2556;
                                        phi_11189_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2570 = phi_11164_;
                                    let _e2572 = phi_11189_;
                                    let _e2576 = (bitcast<i32>(_e2572.member) != 0i);
                                    if _e2576 {
                                        let _e2578 = local_7[_e2572.member_1];
                                        if (_e2578 > 0f) {
                                            let _e2581 = local_7[_e2572.member_1];
                                            if (_e2581 < 1f) {
                                                let _e2584 = local_7[_e2572.member_1];
                                                local_6[_e2558] = _e2584;
                                                phi_11233_ = (_e2558 + 1u);
                                            } else {
                                                phi_11233_ = _e2558;
                                            }
                                            let _e2588 = phi_11233_;
                                            phi_11234_ = _e2588;
                                        } else {
                                            phi_11234_ = _e2558;
                                        }
                                        let _e2590 = phi_11234_;
                                        phi_11167_ = _e2590;
                                    } else {
                                        phi_11167_ = u32();
                                    }
                                    let _e2592 = phi_11167_;
                                    continue;
                                    continuing {
                                        phi_11163_ = _e2570;
                                        phi_11166_ = _e2592;
                                        break if !(_e2576);
                                    }
                                }
                                let _e10155 = local_63;
                                phi_11235_ = _e10155;
                            } else {
                                phi_11235_ = 1u;
                            }
                            let _e2595 = phi_11235_;
                            local_6[_e2595] = 1f;
                            let _e2597 = local_6;
                            local_12 = _e2597;
                            phi_11255_ = type_12(0u, _e2595);
                            loop {
                                let _e2600 = phi_11255_;
                                if (_e2600.member < _e2600.member_1) {
                                    phi_11256_ = type_12((_e2600.member + 1u), _e2600.member_1);
                                    phi_11279_ = type_12(1u, _e2600.member);
                                } else {
                                    phi_11256_ = _e2600;
                                    phi_11279_ = type_12(0u, type_12().member_1);
                                }
                                let _e2612 = phi_11256_;
                                let _e2614 = phi_11279_;
                                if (bitcast<i32>(_e2614.member) != 0i) {
                                    let _e2620 = local_12[_e2614.member_1];
                                    if (_e2620 > _e280) {
                                        phi_11298_ = _e2620;
                                    } else {
                                        phi_11298_ = _e280;
                                    }
                                    let _e2623 = phi_11298_;
                                    let _e2626 = local_12[(_e2614.member_1 + 1u)];
                                    if (_e2626 < _e282) {
                                        phi_11311_ = _e2626;
                                    } else {
                                        phi_11311_ = _e282;
                                    }
                                    let _e2629 = phi_11311_;
                                    if (_e2623 <= _e2629) {
                                        let _e2631 = (1f - _e2623);
                                        let _e2642 = ((((_e619 * _e2631) + (_e642 * _e2623)) * (_e2631 * _e2631)) + (((_e665 * _e2631) + (_e676 * _e2623)) * (_e2623 * _e2623)));
                                        let _e2643 = (1f - _e2629);
                                        let _e2654 = ((((_e619 * _e2643) + (_e642 * _e2629)) * (_e2643 * _e2643)) + (((_e665 * _e2643) + (_e676 * _e2629)) * (_e2629 * _e2629)));
                                        if (_e2642 < 0f) {
                                            phi_11345_ = -(_e2642);
                                        } else {
                                            phi_11345_ = _e2642;
                                        }
                                        let _e2658 = phi_11345_;
                                        let _e2659 = (_e2658 > _e993);
                                        if (_e2654 < 0f) {
                                            phi_11352_ = -(_e2654);
                                        } else {
                                            phi_11352_ = _e2654;
                                        }
                                        let _e2663 = phi_11352_;
                                        let _e2664 = (_e2663 > _e993);
                                        if _e2659 {
                                            if _e2664 {
                                                phi_11363_ = ((_e2642 > 0f) != (_e2654 > 0f));
                                                phi_11364_ = false;
                                            } else {
                                                phi_11363_ = bool();
                                                phi_11364_ = true;
                                            }
                                            let _e2669 = phi_11363_;
                                            let _e2671 = phi_11364_;
                                            phi_11365_ = _e2669;
                                            phi_11366_ = _e2671;
                                        } else {
                                            phi_11365_ = bool();
                                            phi_11366_ = true;
                                        }
                                        let _e2673 = phi_11365_;
                                        let _e2675 = phi_11366_;
                                        if _e2675 {
                                            phi_11370_ = false;
                                        } else {
                                            phi_11370_ = _e2673;
                                        }
                                        let _e2677 = phi_11370_;
                                        if _e2659 {
                                            if _e2664 {
                                                if _e2677 {
                                                    phi_11381_ = type_41();
                                                } else {
                                                    phi_11381_ = type_41(1f, 0f, _e2677);
                                                }
                                                let _e2680 = phi_11381_;
                                                phi_11382_ = _e2680;
                                                phi_11383_ = _e2677;
                                            } else {
                                                phi_11382_ = type_41();
                                                phi_11383_ = true;
                                            }
                                            let _e2682 = phi_11382_;
                                            let _e2684 = phi_11383_;
                                            phi_11384_ = _e2682;
                                            phi_11385_ = _e2684;
                                        } else {
                                            phi_11384_ = type_41();
                                            phi_11385_ = true;
                                        }
                                        let _e2686 = phi_11384_;
                                        let _e2688 = phi_11385_;
                                        if _e2688 {
                                            if _e2659 {
                                                if (_e2642 < 0f) {
                                                    phi_11396_ = -1f;
                                                } else {
                                                    phi_11396_ = 1f;
                                                }
                                                let _e2691 = phi_11396_;
                                                let _e2694 = (_e665 - _e642);
                                                phi_11406_ = type_12(0u, 64u);
                                                phi_11409_ = _e2629;
                                                phi_11411_ = _e2623;
                                                phi_11413_ = (0.5f * (_e2623 + _e2629));
                                                loop {
                                                    let _e2700 = phi_11406_;
                                                    let _e2702 = phi_11409_;
                                                    let _e2704 = phi_11411_;
                                                    let _e2706 = phi_11413_;
                                                    local_65 = _e2704;
                                                    if (_e2700.member < _e2700.member_1) {
                                                        phi_11407_ = type_12((_e2700.member + 1u), _e2700.member_1);
                                                        phi_11436_ = type_12(1u, _e2700.member);
                                                    } else {
                                                        phi_11407_ = _e2700;
                                                        phi_11436_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2718 = phi_11407_;
                                                    let _e2720 = phi_11436_;
                                                    if (bitcast<i32>(_e2720.member) != 0i) {
                                                        let _e2724 = (1f - _e2706);
                                                        let _e2737 = ((_e2691 * ((((_e619 * _e2724) + (_e642 * _e2706)) * (_e2724 * _e2724)) + (((_e665 * _e2724) + (_e676 * _e2706)) * (_e2706 * _e2706)))) - _e993);
                                                        if (_e2737 > 0f) {
                                                            phi_11461_ = _e2702;
                                                            phi_11462_ = _e2706;
                                                        } else {
                                                            phi_11461_ = _e2706;
                                                            phi_11462_ = _e2704;
                                                        }
                                                        let _e2740 = phi_11461_;
                                                        let _e2742 = phi_11462_;
                                                        let _e2744 = ((_e2740 - _e2742) > _e1000);
                                                        if _e2744 {
                                                            let _e2745 = (1f - _e2706);
                                                            let _e2757 = (-(_e2737) / (_e2691 * (((((_e642 - (3f * _e619)) * _e2745) + (_e2694 * _e2706)) * _e2745) + (((_e2694 * _e2745) + (((3f * _e676) - _e665) * _e2706)) * _e2706))));
                                                            if (_e2737 > 0f) {
                                                                phi_11488_ = (0.5f * _e1000);
                                                            } else {
                                                                phi_11488_ = -((0.5f * _e1000));
                                                            }
                                                            let _e2763 = phi_11488_;
                                                            let _e2765 = ((_e2706 + _e2757) + _e2763);
                                                            if (_e2765 > _e2742) {
                                                                if (_e2765 < _e2740) {
                                                                    if (_e2757 < 0f) {
                                                                        phi_11504_ = -(_e2757);
                                                                    } else {
                                                                        phi_11504_ = _e2757;
                                                                    }
                                                                    let _e2771 = phi_11504_;
                                                                    if (_e2771 < (0.5f * (_e2740 - _e2742))) {
                                                                        phi_11511_ = false;
                                                                    } else {
                                                                        phi_11511_ = true;
                                                                    }
                                                                    let _e2776 = phi_11511_;
                                                                    phi_11512_ = _e2776;
                                                                } else {
                                                                    phi_11512_ = true;
                                                                }
                                                                let _e2778 = phi_11512_;
                                                                phi_11513_ = _e2778;
                                                            } else {
                                                                phi_11513_ = true;
                                                            }
                                                            let _e2780 = phi_11513_;
                                                            if _e2780 {
                                                                phi_11519_ = (0.5f * (_e2742 + _e2740));
                                                            } else {
                                                                phi_11519_ = _e2765;
                                                            }
                                                            let _e2784 = phi_11519_;
                                                            phi_11520_ = _e2784;
                                                            phi_11521_ = false;
                                                        } else {
                                                            phi_11520_ = f32();
                                                            phi_11521_ = true;
                                                        }
                                                        let _e2786 = phi_11520_;
                                                        let _e2788 = phi_11521_;
                                                        phi_11410_ = _e2740;
                                                        phi_11412_ = _e2742;
                                                        phi_11414_ = _e2786;
                                                        phi_11522_ = _e2742;
                                                        phi_11523_ = _e2744;
                                                        phi_11524_ = _e2788;
                                                    } else {
                                                        phi_11410_ = f32();
                                                        phi_11412_ = f32();
                                                        phi_11414_ = f32();
                                                        phi_11522_ = f32();
                                                        phi_11523_ = false;
                                                        phi_11524_ = false;
                                                    }
                                                    let _e2790 = phi_11410_;
                                                    let _e2792 = phi_11412_;
                                                    let _e2794 = phi_11414_;
                                                    let _e2796 = phi_11522_;
                                                    let _e2798 = phi_11523_;
                                                    let _e2800 = phi_11524_;
                                                    local_24 = _e2800;
                                                    local_64 = _e2796;
                                                    continue;
                                                    continuing {
                                                        phi_11406_ = _e2718;
                                                        phi_11409_ = _e2790;
                                                        phi_11411_ = _e2792;
                                                        phi_11413_ = _e2794;
                                                        break if !(_e2798);
                                                    }
                                                }
                                                let _e2803 = local_24;
                                                if _e2803 {
                                                    let _e10199 = local_64;
                                                    phi_11528_ = _e10199;
                                                } else {
                                                    let _e10201 = local_65;
                                                    phi_11528_ = _e10201;
                                                }
                                                let _e2805 = phi_11528_;
                                                phi_11529_ = _e2805;
                                            } else {
                                                phi_11529_ = _e2623;
                                            }
                                            let _e2807 = phi_11529_;
                                            if _e2664 {
                                                if (_e2654 < 0f) {
                                                    phi_11537_ = -1f;
                                                } else {
                                                    phi_11537_ = 1f;
                                                }
                                                let _e2810 = phi_11537_;
                                                phi_11541_ = type_12(0u, 64u);
                                                phi_11544_ = (_e1000 + _e1000);
                                                loop {
                                                    let _e2813 = phi_11541_;
                                                    let _e2815 = phi_11544_;
                                                    if (_e2813.member < _e2813.member_1) {
                                                        phi_11542_ = type_12((_e2813.member + 1u), _e2813.member_1);
                                                        phi_11567_ = type_12(1u, _e2813.member);
                                                    } else {
                                                        phi_11542_ = _e2813;
                                                        phi_11567_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2827 = phi_11542_;
                                                    let _e2829 = phi_11567_;
                                                    if (bitcast<i32>(_e2829.member) != 0i) {
                                                        let _e2833 = (_e2807 + _e2815);
                                                        if (_e2833 < _e2629) {
                                                            let _e2835 = (1f - _e2833);
                                                            let _e2848 = ((_e2810 * ((((_e619 * _e2835) + (_e642 * _e2833)) * (_e2835 * _e2835)) + (((_e665 * _e2835) + (_e676 * _e2833)) * (_e2833 * _e2833)))) > _e993);
                                                            if _e2848 {
                                                                phi_11597_ = f32();
                                                                phi_11598_ = false;
                                                            } else {
                                                                phi_11597_ = (_e2815 + _e2815);
                                                                phi_11598_ = true;
                                                            }
                                                            let _e2851 = phi_11597_;
                                                            let _e2853 = phi_11598_;
                                                            phi_11599_ = _e2851;
                                                            phi_11600_ = _e2853;
                                                            phi_11601_ = _e2848;
                                                            phi_11602_ = false;
                                                        } else {
                                                            phi_11599_ = f32();
                                                            phi_11600_ = false;
                                                            phi_11601_ = false;
                                                            phi_11602_ = true;
                                                        }
                                                        let _e2855 = phi_11599_;
                                                        let _e2857 = phi_11600_;
                                                        let _e2859 = phi_11601_;
                                                        let _e2861 = phi_11602_;
                                                        phi_11603_ = _e2833;
                                                        phi_11545_ = _e2855;
                                                        phi_11604_ = _e2857;
                                                        phi_11605_ = _e2859;
                                                        phi_11606_ = _e2861;
                                                        phi_11607_ = false;
                                                    } else {
                                                        phi_11603_ = f32();
                                                        phi_11545_ = f32();
                                                        phi_11604_ = false;
                                                        phi_11605_ = false;
                                                        phi_11606_ = false;
                                                        phi_11607_ = true;
                                                    }
                                                    let _e2863 = phi_11603_;
                                                    let _e2865 = phi_11545_;
                                                    let _e2867 = phi_11604_;
                                                    let _e2869 = phi_11605_;
                                                    let _e2871 = phi_11606_;
                                                    let _e2873 = phi_11607_;
                                                    local_25 = _e2869;
                                                    local_66 = _e2871;
                                                    local_67 = _e2873;
                                                    local_68 = _e2863;
                                                    continue;
                                                    continuing {
                                                        phi_11541_ = _e2827;
                                                        phi_11544_ = _e2865;
                                                        break if !(_e2867);
                                                    }
                                                }
                                                let _e2876 = local_25;
                                                if _e2876 {
                                                    phi_11611_ = false;
                                                    phi_11612_ = false;
                                                } else {
                                                    let _e10223 = local_66;
                                                    phi_11611_ = _e10223;
                                                    let _e10226 = local_67;
                                                    phi_11612_ = _e10226;
                                                }
                                                let _e2878 = phi_11611_;
                                                let _e2880 = phi_11612_;
                                                if _e2878 {
                                                    phi_11616_ = true;
                                                } else {
                                                    phi_11616_ = _e2880;
                                                }
                                                let _e2882 = phi_11616_;
                                                if _e2882 {
                                                    phi_11620_ = _e2629;
                                                } else {
                                                    let _e10230 = local_68;
                                                    phi_11620_ = _e10230;
                                                }
                                                let _e2884 = phi_11620_;
                                                phi_11621_ = _e2884;
                                            } else {
                                                phi_11621_ = _e2629;
                                            }
                                            let _e2886 = phi_11621_;
                                            phi_11623_ = type_41(_e2807, _e2886, _e2677);
                                        } else {
                                            phi_11623_ = _e2686;
                                        }
                                        let _e2889 = phi_11623_;
                                        if (_e2889.member > _e2889.member_1) {
                                            phi_15416_ = bool();
                                            phi_15417_ = f32();
                                            phi_15418_ = f32();
                                            phi_15419_ = true;
                                            phi_15420_ = false;
                                            phi_15421_ = false;
                                            phi_15422_ = false;
                                        } else {
                                            let _e2896 = ((_e2889.member_1 - _e2889.member) * 0.5f);
                                            let _e2897 = (_e2889.member + _e2896);
                                            let _e2899 = (_e2896 + (0.000000059604645f * 4f));
                                            let _e2901 = local_18.member_3;
                                            let _e2904 = local_18.member[0u];
                                            if (_e2904[0] < 0f) {
                                                phi_11652_ = -(_e2904[0]);
                                            } else {
                                                phi_11652_ = _e2904[0];
                                            }
                                            let _e2911 = phi_11652_;
                                            if (_e2904[1] < 0f) {
                                                phi_11659_ = -(_e2904[1]);
                                            } else {
                                                phi_11659_ = _e2904[1];
                                            }
                                            let _e2915 = phi_11659_;
                                            if (_e2911 > _e2915) {
                                                phi_11664_ = _e2911;
                                            } else {
                                                phi_11664_ = _e2915;
                                            }
                                            let _e2918 = phi_11664_;
                                            if (_e2904[2] < 0f) {
                                                phi_11671_ = -(_e2904[2]);
                                            } else {
                                                phi_11671_ = _e2904[2];
                                            }
                                            let _e2922 = phi_11671_;
                                            if (_e2918 > _e2922) {
                                                phi_11676_ = _e2918;
                                            } else {
                                                phi_11676_ = _e2922;
                                            }
                                            let _e2925 = phi_11676_;
                                            let _e2927 = local_18.member[1u];
                                            if (_e2927[0] < 0f) {
                                                phi_11689_ = -(_e2927[0]);
                                            } else {
                                                phi_11689_ = _e2927[0];
                                            }
                                            let _e2934 = phi_11689_;
                                            if (_e2927[1] < 0f) {
                                                phi_11696_ = -(_e2927[1]);
                                            } else {
                                                phi_11696_ = _e2927[1];
                                            }
                                            let _e2938 = phi_11696_;
                                            if (_e2934 > _e2938) {
                                                phi_11701_ = _e2934;
                                            } else {
                                                phi_11701_ = _e2938;
                                            }
                                            let _e2941 = phi_11701_;
                                            if (_e2927[2] < 0f) {
                                                phi_11708_ = -(_e2927[2]);
                                            } else {
                                                phi_11708_ = _e2927[2];
                                            }
                                            let _e2945 = phi_11708_;
                                            if (_e2941 > _e2945) {
                                                phi_11713_ = _e2941;
                                            } else {
                                                phi_11713_ = _e2945;
                                            }
                                            let _e2948 = phi_11713_;
                                            if (_e2925 > _e2948) {
                                                phi_11718_ = _e2925;
                                            } else {
                                                phi_11718_ = _e2948;
                                            }
                                            let _e2951 = phi_11718_;
                                            let _e2954 = local_18.member[0u];
                                            let _e2959 = local_18.member[1u];
                                            let _e2969 = (_e2954[0] + ((_e2959[0] - _e2954[0]) * _e2897));
                                            let _e2970 = (_e2954[1] + ((_e2959[1] - _e2954[1]) * _e2897));
                                            let _e2971 = (_e2954[2] + ((_e2959[2] - _e2954[2]) * _e2897));
                                            let _e2973 = local_18.member[1u];
                                            let _e2978 = local_18.member[0u];
                                            let _e2982 = (_e2973[0] - _e2978[0]);
                                            let _e2983 = (_e2973[1] - _e2978[1]);
                                            let _e2984 = (_e2973[2] - _e2978[2]);
                                            if (_e2982 < 0f) {
                                                phi_11777_ = -(_e2982);
                                            } else {
                                                phi_11777_ = _e2982;
                                            }
                                            let _e2988 = phi_11777_;
                                            if (_e2983 < 0f) {
                                                phi_11783_ = -(_e2983);
                                            } else {
                                                phi_11783_ = _e2983;
                                            }
                                            let _e2992 = phi_11783_;
                                            if (_e2988 > _e2992) {
                                                phi_11788_ = _e2988;
                                            } else {
                                                phi_11788_ = _e2992;
                                            }
                                            let _e2995 = phi_11788_;
                                            if (_e2984 < 0f) {
                                                phi_11794_ = -(_e2984);
                                            } else {
                                                phi_11794_ = _e2984;
                                            }
                                            let _e2999 = phi_11794_;
                                            if (_e2995 > _e2999) {
                                                phi_11799_ = _e2995;
                                            } else {
                                                phi_11799_ = _e2999;
                                            }
                                            let _e3002 = phi_11799_;
                                            let _e3008 = ((((_e2899 * _e3002) * 1.01f) + ((_e2951 + _e2901) * (0.000000059604645f * 8f))) + _e2901);
                                            if (_e2969 < 0f) {
                                                phi_11811_ = -(_e2969);
                                            } else {
                                                phi_11811_ = _e2969;
                                            }
                                            let _e3012 = phi_11811_;
                                            if (_e2970 < 0f) {
                                                phi_11817_ = -(_e2970);
                                            } else {
                                                phi_11817_ = _e2970;
                                            }
                                            let _e3016 = phi_11817_;
                                            if (_e3012 > _e3016) {
                                                phi_11822_ = _e3012;
                                            } else {
                                                phi_11822_ = _e3016;
                                            }
                                            let _e3019 = phi_11822_;
                                            if (_e2971 < 0f) {
                                                phi_11828_ = -(_e2971);
                                            } else {
                                                phi_11828_ = _e2971;
                                            }
                                            let _e3023 = phi_11828_;
                                            if (_e3019 > _e3023) {
                                                phi_11833_ = _e3019;
                                            } else {
                                                phi_11833_ = _e3023;
                                            }
                                            let _e3026 = phi_11833_;
                                            local_2 = type_24(array<f32, 3>(_e2969, _e2970, _e2971), _e3008, (_e3026 + _e3008));
                                            let _e3032 = local_18.member_3;
                                            let _e3034 = local_18.member_1[0u];
                                            if (_e3034[0] < 0f) {
                                                phi_11859_ = -(_e3034[0]);
                                            } else {
                                                phi_11859_ = _e3034[0];
                                            }
                                            let _e3041 = phi_11859_;
                                            if (_e3034[1] < 0f) {
                                                phi_11866_ = -(_e3034[1]);
                                            } else {
                                                phi_11866_ = _e3034[1];
                                            }
                                            let _e3045 = phi_11866_;
                                            if (_e3041 > _e3045) {
                                                phi_11871_ = _e3041;
                                            } else {
                                                phi_11871_ = _e3045;
                                            }
                                            let _e3048 = phi_11871_;
                                            if (_e3034[2] < 0f) {
                                                phi_11878_ = -(_e3034[2]);
                                            } else {
                                                phi_11878_ = _e3034[2];
                                            }
                                            let _e3052 = phi_11878_;
                                            if (_e3048 > _e3052) {
                                                phi_11883_ = _e3048;
                                            } else {
                                                phi_11883_ = _e3052;
                                            }
                                            let _e3055 = phi_11883_;
                                            let _e3057 = local_18.member_1[1u];
                                            if (_e3057[0] < 0f) {
                                                phi_11896_ = -(_e3057[0]);
                                            } else {
                                                phi_11896_ = _e3057[0];
                                            }
                                            let _e3064 = phi_11896_;
                                            if (_e3057[1] < 0f) {
                                                phi_11903_ = -(_e3057[1]);
                                            } else {
                                                phi_11903_ = _e3057[1];
                                            }
                                            let _e3068 = phi_11903_;
                                            if (_e3064 > _e3068) {
                                                phi_11908_ = _e3064;
                                            } else {
                                                phi_11908_ = _e3068;
                                            }
                                            let _e3071 = phi_11908_;
                                            if (_e3057[2] < 0f) {
                                                phi_11915_ = -(_e3057[2]);
                                            } else {
                                                phi_11915_ = _e3057[2];
                                            }
                                            let _e3075 = phi_11915_;
                                            if (_e3071 > _e3075) {
                                                phi_11920_ = _e3071;
                                            } else {
                                                phi_11920_ = _e3075;
                                            }
                                            let _e3078 = phi_11920_;
                                            if (_e3055 > _e3078) {
                                                phi_11925_ = _e3055;
                                            } else {
                                                phi_11925_ = _e3078;
                                            }
                                            let _e3081 = phi_11925_;
                                            let _e3084 = local_18.member_1[0u];
                                            let _e3089 = local_18.member_1[1u];
                                            let _e3099 = (_e3084[0] + ((_e3089[0] - _e3084[0]) * _e2897));
                                            let _e3100 = (_e3084[1] + ((_e3089[1] - _e3084[1]) * _e2897));
                                            let _e3101 = (_e3084[2] + ((_e3089[2] - _e3084[2]) * _e2897));
                                            let _e3103 = local_18.member_1[1u];
                                            let _e3108 = local_18.member_1[0u];
                                            let _e3112 = (_e3103[0] - _e3108[0]);
                                            let _e3113 = (_e3103[1] - _e3108[1]);
                                            let _e3114 = (_e3103[2] - _e3108[2]);
                                            if (_e3112 < 0f) {
                                                phi_11984_ = -(_e3112);
                                            } else {
                                                phi_11984_ = _e3112;
                                            }
                                            let _e3118 = phi_11984_;
                                            if (_e3113 < 0f) {
                                                phi_11990_ = -(_e3113);
                                            } else {
                                                phi_11990_ = _e3113;
                                            }
                                            let _e3122 = phi_11990_;
                                            if (_e3118 > _e3122) {
                                                phi_11995_ = _e3118;
                                            } else {
                                                phi_11995_ = _e3122;
                                            }
                                            let _e3125 = phi_11995_;
                                            if (_e3114 < 0f) {
                                                phi_12001_ = -(_e3114);
                                            } else {
                                                phi_12001_ = _e3114;
                                            }
                                            let _e3129 = phi_12001_;
                                            if (_e3125 > _e3129) {
                                                phi_12006_ = _e3125;
                                            } else {
                                                phi_12006_ = _e3129;
                                            }
                                            let _e3132 = phi_12006_;
                                            let _e3138 = ((((_e2899 * _e3132) * 1.01f) + ((_e3081 + _e3032) * (0.000000059604645f * 8f))) + _e3032);
                                            if (_e3099 < 0f) {
                                                phi_12018_ = -(_e3099);
                                            } else {
                                                phi_12018_ = _e3099;
                                            }
                                            let _e3142 = phi_12018_;
                                            if (_e3100 < 0f) {
                                                phi_12024_ = -(_e3100);
                                            } else {
                                                phi_12024_ = _e3100;
                                            }
                                            let _e3146 = phi_12024_;
                                            if (_e3142 > _e3146) {
                                                phi_12029_ = _e3142;
                                            } else {
                                                phi_12029_ = _e3146;
                                            }
                                            let _e3149 = phi_12029_;
                                            if (_e3101 < 0f) {
                                                phi_12035_ = -(_e3101);
                                            } else {
                                                phi_12035_ = _e3101;
                                            }
                                            let _e3153 = phi_12035_;
                                            if (_e3149 > _e3153) {
                                                phi_12040_ = _e3149;
                                            } else {
                                                phi_12040_ = _e3153;
                                            }
                                            let _e3156 = phi_12040_;
                                            local_3 = type_24(array<f32, 3>(_e3099, _e3100, _e3101), _e3138, (_e3156 + _e3138));
                                            let _e3162 = local_18.member_3;
                                            let _e3164 = local_18.member_2[0u];
                                            if (_e3164[0] < 0f) {
                                                phi_12066_ = -(_e3164[0]);
                                            } else {
                                                phi_12066_ = _e3164[0];
                                            }
                                            let _e3171 = phi_12066_;
                                            if (_e3164[1] < 0f) {
                                                phi_12073_ = -(_e3164[1]);
                                            } else {
                                                phi_12073_ = _e3164[1];
                                            }
                                            let _e3175 = phi_12073_;
                                            if (_e3171 > _e3175) {
                                                phi_12078_ = _e3171;
                                            } else {
                                                phi_12078_ = _e3175;
                                            }
                                            let _e3178 = phi_12078_;
                                            if (_e3164[2] < 0f) {
                                                phi_12085_ = -(_e3164[2]);
                                            } else {
                                                phi_12085_ = _e3164[2];
                                            }
                                            let _e3182 = phi_12085_;
                                            if (_e3178 > _e3182) {
                                                phi_12090_ = _e3178;
                                            } else {
                                                phi_12090_ = _e3182;
                                            }
                                            let _e3185 = phi_12090_;
                                            let _e3187 = local_18.member_2[1u];
                                            if (_e3187[0] < 0f) {
                                                phi_12103_ = -(_e3187[0]);
                                            } else {
                                                phi_12103_ = _e3187[0];
                                            }
                                            let _e3194 = phi_12103_;
                                            if (_e3187[1] < 0f) {
                                                phi_12110_ = -(_e3187[1]);
                                            } else {
                                                phi_12110_ = _e3187[1];
                                            }
                                            let _e3198 = phi_12110_;
                                            if (_e3194 > _e3198) {
                                                phi_12115_ = _e3194;
                                            } else {
                                                phi_12115_ = _e3198;
                                            }
                                            let _e3201 = phi_12115_;
                                            if (_e3187[2] < 0f) {
                                                phi_12122_ = -(_e3187[2]);
                                            } else {
                                                phi_12122_ = _e3187[2];
                                            }
                                            let _e3205 = phi_12122_;
                                            if (_e3201 > _e3205) {
                                                phi_12127_ = _e3201;
                                            } else {
                                                phi_12127_ = _e3205;
                                            }
                                            let _e3208 = phi_12127_;
                                            if (_e3185 > _e3208) {
                                                phi_12132_ = _e3185;
                                            } else {
                                                phi_12132_ = _e3208;
                                            }
                                            let _e3211 = phi_12132_;
                                            let _e3214 = local_18.member_2[0u];
                                            let _e3219 = local_18.member_2[1u];
                                            let _e3229 = (_e3214[0] + ((_e3219[0] - _e3214[0]) * _e2897));
                                            let _e3230 = (_e3214[1] + ((_e3219[1] - _e3214[1]) * _e2897));
                                            let _e3231 = (_e3214[2] + ((_e3219[2] - _e3214[2]) * _e2897));
                                            let _e3233 = local_18.member_2[1u];
                                            let _e3238 = local_18.member_2[0u];
                                            let _e3242 = (_e3233[0] - _e3238[0]);
                                            let _e3243 = (_e3233[1] - _e3238[1]);
                                            let _e3244 = (_e3233[2] - _e3238[2]);
                                            if (_e3242 < 0f) {
                                                phi_12191_ = -(_e3242);
                                            } else {
                                                phi_12191_ = _e3242;
                                            }
                                            let _e3248 = phi_12191_;
                                            if (_e3243 < 0f) {
                                                phi_12197_ = -(_e3243);
                                            } else {
                                                phi_12197_ = _e3243;
                                            }
                                            let _e3252 = phi_12197_;
                                            if (_e3248 > _e3252) {
                                                phi_12202_ = _e3248;
                                            } else {
                                                phi_12202_ = _e3252;
                                            }
                                            let _e3255 = phi_12202_;
                                            if (_e3244 < 0f) {
                                                phi_12208_ = -(_e3244);
                                            } else {
                                                phi_12208_ = _e3244;
                                            }
                                            let _e3259 = phi_12208_;
                                            if (_e3255 > _e3259) {
                                                phi_12213_ = _e3255;
                                            } else {
                                                phi_12213_ = _e3259;
                                            }
                                            let _e3262 = phi_12213_;
                                            let _e3268 = ((((_e2899 * _e3262) * 1.01f) + ((_e3211 + _e3162) * (0.000000059604645f * 8f))) + _e3162);
                                            if (_e3229 < 0f) {
                                                phi_12225_ = -(_e3229);
                                            } else {
                                                phi_12225_ = _e3229;
                                            }
                                            let _e3272 = phi_12225_;
                                            if (_e3230 < 0f) {
                                                phi_12231_ = -(_e3230);
                                            } else {
                                                phi_12231_ = _e3230;
                                            }
                                            let _e3276 = phi_12231_;
                                            if (_e3272 > _e3276) {
                                                phi_12236_ = _e3272;
                                            } else {
                                                phi_12236_ = _e3276;
                                            }
                                            let _e3279 = phi_12236_;
                                            if (_e3231 < 0f) {
                                                phi_12242_ = -(_e3231);
                                            } else {
                                                phi_12242_ = _e3231;
                                            }
                                            let _e3283 = phi_12242_;
                                            if (_e3279 > _e3283) {
                                                phi_12247_ = _e3279;
                                            } else {
                                                phi_12247_ = _e3283;
                                            }
                                            let _e3286 = phi_12247_;
                                            local_4 = type_24(array<f32, 3>(_e3229, _e3230, _e3231), _e3268, (_e3286 + _e3268));
                                            let _e3291 = local_3.member;
                                            let _e3296 = local_4.member;
                                            let _e3302 = ((_e3291[1] * _e3296[2]) - (_e3291[2] * _e3296[1]));
                                            let _e3305 = ((_e3291[2] * _e3296[0]) - (_e3291[0] * _e3296[2]));
                                            let _e3308 = ((_e3291[0] * _e3296[1]) - (_e3291[1] * _e3296[0]));
                                            if (_e3302 < 0f) {
                                                phi_12296_ = -(_e3302);
                                            } else {
                                                phi_12296_ = _e3302;
                                            }
                                            let _e3312 = phi_12296_;
                                            if (_e3305 < 0f) {
                                                phi_12302_ = -(_e3305);
                                            } else {
                                                phi_12302_ = _e3305;
                                            }
                                            let _e3316 = phi_12302_;
                                            if (_e3312 > _e3316) {
                                                if (_e3302 < 0f) {
                                                    phi_12312_ = -(_e3302);
                                                } else {
                                                    phi_12312_ = _e3302;
                                                }
                                                let _e3334 = phi_12312_;
                                                if (_e3308 < 0f) {
                                                    phi_12318_ = -(_e3308);
                                                } else {
                                                    phi_12318_ = _e3308;
                                                }
                                                let _e3338 = phi_12318_;
                                                if (_e3334 > _e3338) {
                                                    phi_12323_ = 2u;
                                                    phi_12324_ = 1u;
                                                } else {
                                                    phi_12323_ = 1u;
                                                    phi_12324_ = 0u;
                                                }
                                                let _e3341 = phi_12323_;
                                                let _e3343 = phi_12324_;
                                                phi_12343_ = _e3341;
                                                phi_12344_ = _e3343;
                                            } else {
                                                if (_e3305 < 0f) {
                                                    phi_12330_ = -(_e3305);
                                                } else {
                                                    phi_12330_ = _e3305;
                                                }
                                                let _e3321 = phi_12330_;
                                                if (_e3308 < 0f) {
                                                    phi_12336_ = -(_e3308);
                                                } else {
                                                    phi_12336_ = _e3308;
                                                }
                                                let _e3325 = phi_12336_;
                                                if (_e3321 > _e3325) {
                                                    phi_12341_ = 0u;
                                                    phi_12342_ = 2u;
                                                } else {
                                                    phi_12341_ = 1u;
                                                    phi_12342_ = 0u;
                                                }
                                                let _e3328 = phi_12341_;
                                                let _e3330 = phi_12342_;
                                                phi_12343_ = _e3328;
                                                phi_12344_ = _e3330;
                                            }
                                            let _e3345 = phi_12343_;
                                            let _e3347 = phi_12344_;
                                            let _e3350 = local_3.member[_e3347];
                                            let _e3353 = local_4.member[_e3345];
                                            let _e3357 = local_3.member[_e3345];
                                            let _e3360 = local_4.member[_e3347];
                                            let _e3362 = ((_e3350 * _e3353) - (_e3357 * _e3360));
                                            let _e3364 = local_3.member_1;
                                            let _e3366 = local_4.member_2;
                                            let _e3369 = local_3.member_2;
                                            let _e3371 = local_4.member_1;
                                            let _e3376 = local_3.member_2;
                                            let _e3379 = local_4.member_2;
                                            let _e3387 = local_3.member_2;
                                            let _e3390 = local_4.member_2;
                                            let _e3394 = (((((_e3364 * _e3366) + (_e3369 * _e3371)) * 2.01f) + (((_e3376 * 2f) * (_e3379 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3387) * (1f + _e3390))));
                                            if (_e3362 < 0f) {
                                                phi_12413_ = -(_e3362);
                                            } else {
                                                phi_12413_ = _e3362;
                                            }
                                            let _e3398 = phi_12413_;
                                            if (_e3398 > _e3394) {
                                                if (_e3362 < 0f) {
                                                    phi_12422_ = -1f;
                                                } else {
                                                    phi_12422_ = 1f;
                                                }
                                                let _e3402 = phi_12422_;
                                                let _e3405 = local_2.member[_e3347];
                                                let _e3408 = local_4.member[_e3345];
                                                let _e3412 = local_2.member[_e3345];
                                                let _e3415 = local_4.member[_e3347];
                                                let _e3419 = local_2.member_1;
                                                let _e3421 = local_4.member_2;
                                                let _e3424 = local_2.member_2;
                                                let _e3426 = local_4.member_1;
                                                let _e3431 = local_2.member_2;
                                                let _e3434 = local_4.member_2;
                                                let _e3442 = local_2.member_2;
                                                let _e3445 = local_4.member_2;
                                                let _e3449 = (((((_e3419 * _e3421) + (_e3424 * _e3426)) * 2.01f) + (((_e3431 * 2f) * (_e3434 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3442) * (1f + _e3445))));
                                                let _e3452 = local_3.member[_e3347];
                                                let _e3455 = local_2.member[_e3345];
                                                let _e3459 = local_3.member[_e3345];
                                                let _e3462 = local_2.member[_e3347];
                                                let _e3466 = local_3.member_1;
                                                let _e3468 = local_2.member_2;
                                                let _e3471 = local_3.member_2;
                                                let _e3473 = local_2.member_1;
                                                let _e3478 = local_3.member_2;
                                                let _e3481 = local_2.member_2;
                                                let _e3489 = local_3.member_2;
                                                let _e3492 = local_2.member_2;
                                                let _e3496 = (((((_e3466 * _e3468) + (_e3471 * _e3473)) * 2.01f) + (((_e3478 * 2f) * (_e3481 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3489) * (1f + _e3492))));
                                                let _e3497 = (_e3362 * _e3402);
                                                let _e3498 = (((_e3405 * _e3408) - (_e3412 * _e3415)) * _e3402);
                                                let _e3499 = (((_e3452 * _e3455) - (_e3459 * _e3462)) * _e3402);
                                                if (_e3497 < 0f) {
                                                    phi_12557_ = -(_e3497);
                                                } else {
                                                    phi_12557_ = _e3497;
                                                }
                                                let _e3503 = phi_12557_;
                                                if (_e3498 < 0f) {
                                                    phi_12563_ = -(_e3498);
                                                } else {
                                                    phi_12563_ = _e3498;
                                                }
                                                let _e3507 = phi_12563_;
                                                if (_e3499 < 0f) {
                                                    phi_12570_ = -(_e3499);
                                                } else {
                                                    phi_12570_ = _e3499;
                                                }
                                                let _e3512 = phi_12570_;
                                                let _e3517 = ((_e3497 - _e3498) - _e3499);
                                                let _e3520 = (((_e3394 + _e3449) + _e3496) + (((_e3503 + _e3507) + _e3512) * (0.000000059604645f * 4f)));
                                                local_5 = array<type_33, 4>(type_33(_e3498, _e3449), type_33(_e3499, _e3496), type_33(_e3517, _e3520), type_33(_e3517, _e3520));
                                                phi_12625_ = type_12(0u, 4u);
                                                phi_12628_ = true;
                                                loop {
                                                    let _e3527 = phi_12625_;
                                                    let _e3529 = phi_12628_;
                                                    local_27 = _e3529;
                                                    if (_e3527.member < _e3527.member_1) {
                                                        phi_12626_ = type_12((_e3527.member + 1u), _e3527.member_1);
                                                        phi_12651_ = type_12(1u, _e3527.member);
                                                    } else {
                                                        phi_12626_ = _e3527;
                                                        phi_12651_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3541 = phi_12626_;
                                                    let _e3543 = phi_12651_;
                                                    if (bitcast<i32>(_e3543.member) != 0i) {
                                                        let _e3550 = local_5[_e3543.member_1].member;
                                                        let _e3553 = local_5[_e3543.member_1].member_1;
                                                        let _e3555 = (_e3550 < -(_e3553));
                                                        if _e3555 {
                                                            phi_12678_ = bool();
                                                            phi_12679_ = false;
                                                        } else {
                                                            phi_12678_ = (_e3529 && (_e3550 > _e3553));
                                                            phi_12679_ = true;
                                                        }
                                                        let _e3559 = phi_12678_;
                                                        let _e3561 = phi_12679_;
                                                        phi_12629_ = _e3559;
                                                        phi_12680_ = _e3561;
                                                        phi_12681_ = _e3555;
                                                    } else {
                                                        phi_12629_ = bool();
                                                        phi_12680_ = false;
                                                        phi_12681_ = false;
                                                    }
                                                    let _e3563 = phi_12629_;
                                                    let _e3565 = phi_12680_;
                                                    let _e3567 = phi_12681_;
                                                    local_26 = _e3567;
                                                    continue;
                                                    continuing {
                                                        phi_12625_ = _e3541;
                                                        phi_12628_ = _e3563;
                                                        break if !(_e3565);
                                                    }
                                                }
                                                let _e3570 = local_26;
                                                if _e3570 {
                                                    phi_12685_ = false;
                                                } else {
                                                    phi_12685_ = true;
                                                }
                                                let _e3572 = phi_12685_;
                                                if _e3572 {
                                                    let _e3574 = local_27;
                                                    if _e3574 {
                                                        phi_12692_ = 1u;
                                                    } else {
                                                        phi_12692_ = 2u;
                                                    }
                                                    let _e3576 = phi_12692_;
                                                    phi_12693_ = _e3576;
                                                    phi_12694_ = false;
                                                } else {
                                                    phi_12693_ = u32();
                                                    phi_12694_ = true;
                                                }
                                                let _e3578 = phi_12693_;
                                                let _e3580 = phi_12694_;
                                                phi_12695_ = _e3578;
                                                phi_12696_ = 0u;
                                                phi_12697_ = _e3580;
                                            } else {
                                                phi_12695_ = u32();
                                                phi_12696_ = 2u;
                                                phi_12697_ = true;
                                            }
                                            let _e3582 = phi_12695_;
                                            let _e3584 = phi_12696_;
                                            let _e3586 = phi_12697_;
                                            if _e3586 {
                                                phi_12701_ = _e3584;
                                            } else {
                                                phi_12701_ = _e3582;
                                            }
                                            let _e3588 = phi_12701_;
                                            let _e3589 = (_e3588 == 0u);
                                            if _e3589 {
                                                phi_15410_ = bool();
                                                phi_15411_ = f32();
                                                phi_15412_ = f32();
                                                phi_15413_ = false;
                                                phi_15414_ = false;
                                                phi_15415_ = false;
                                            } else {
                                                if (_e3588 == 1u) {
                                                    phi_12711_ = _e2889.member_2;
                                                } else {
                                                    phi_12711_ = false;
                                                }
                                                let _e3593 = phi_12711_;
                                                let _e3594 = (_e278 * 0.99f);
                                                if _e3593 {
                                                    if ((_e2889.member_1 - _e2889.member) <= _e3594) {
                                                        phi_12723_ = false;
                                                    } else {
                                                        phi_12723_ = true;
                                                    }
                                                    let _e3600 = phi_12723_;
                                                    phi_12724_ = _e3600;
                                                } else {
                                                    phi_12724_ = true;
                                                }
                                                let _e3602 = phi_12724_;
                                                if _e3602 {
                                                    let _e3607 = local_18.member[0u];
                                                    let _e3613 = local_18.member_1[0u];
                                                    let _e3619 = local_18.member_2[0u];
                                                    let _e3631 = local_18.member[1u];
                                                    let _e3637 = local_18.member_1[1u];
                                                    let _e3643 = local_18.member_2[1u];
                                                    let _e3655 = local_18.member[0u];
                                                    if (_e3655[0] < 0f) {
                                                        phi_12872_ = -(_e3655[0]);
                                                    } else {
                                                        phi_12872_ = _e3655[0];
                                                    }
                                                    let _e3662 = phi_12872_;
                                                    if (_e3655[1] < 0f) {
                                                        phi_12879_ = -(_e3655[1]);
                                                    } else {
                                                        phi_12879_ = _e3655[1];
                                                    }
                                                    let _e3666 = phi_12879_;
                                                    if (_e3662 > _e3666) {
                                                        phi_12884_ = _e3662;
                                                    } else {
                                                        phi_12884_ = _e3666;
                                                    }
                                                    let _e3669 = phi_12884_;
                                                    if (_e3655[2] < 0f) {
                                                        phi_12891_ = -(_e3655[2]);
                                                    } else {
                                                        phi_12891_ = _e3655[2];
                                                    }
                                                    let _e3673 = phi_12891_;
                                                    if (_e3669 > _e3673) {
                                                        phi_12896_ = _e3669;
                                                    } else {
                                                        phi_12896_ = _e3673;
                                                    }
                                                    let _e3676 = phi_12896_;
                                                    let _e3679 = local_18.member[1u];
                                                    if (_e3679[0] < 0f) {
                                                        phi_12909_ = -(_e3679[0]);
                                                    } else {
                                                        phi_12909_ = _e3679[0];
                                                    }
                                                    let _e3686 = phi_12909_;
                                                    if (_e3679[1] < 0f) {
                                                        phi_12916_ = -(_e3679[1]);
                                                    } else {
                                                        phi_12916_ = _e3679[1];
                                                    }
                                                    let _e3690 = phi_12916_;
                                                    if (_e3686 > _e3690) {
                                                        phi_12921_ = _e3686;
                                                    } else {
                                                        phi_12921_ = _e3690;
                                                    }
                                                    let _e3693 = phi_12921_;
                                                    if (_e3679[2] < 0f) {
                                                        phi_12928_ = -(_e3679[2]);
                                                    } else {
                                                        phi_12928_ = _e3679[2];
                                                    }
                                                    let _e3697 = phi_12928_;
                                                    if (_e3693 > _e3697) {
                                                        phi_12933_ = _e3693;
                                                    } else {
                                                        phi_12933_ = _e3697;
                                                    }
                                                    let _e3700 = phi_12933_;
                                                    if (_e3676 > _e3700) {
                                                        phi_12938_ = _e3676;
                                                    } else {
                                                        phi_12938_ = _e3700;
                                                    }
                                                    let _e3703 = phi_12938_;
                                                    let _e3705 = local_18.member_3;
                                                    let _e3709 = local_18.member_1[0u];
                                                    if (_e3709[0] < 0f) {
                                                        phi_12955_ = -(_e3709[0]);
                                                    } else {
                                                        phi_12955_ = _e3709[0];
                                                    }
                                                    let _e3716 = phi_12955_;
                                                    if (_e3709[1] < 0f) {
                                                        phi_12962_ = -(_e3709[1]);
                                                    } else {
                                                        phi_12962_ = _e3709[1];
                                                    }
                                                    let _e3720 = phi_12962_;
                                                    if (_e3716 > _e3720) {
                                                        phi_12967_ = _e3716;
                                                    } else {
                                                        phi_12967_ = _e3720;
                                                    }
                                                    let _e3723 = phi_12967_;
                                                    if (_e3709[2] < 0f) {
                                                        phi_12974_ = -(_e3709[2]);
                                                    } else {
                                                        phi_12974_ = _e3709[2];
                                                    }
                                                    let _e3727 = phi_12974_;
                                                    if (_e3723 > _e3727) {
                                                        phi_12979_ = _e3723;
                                                    } else {
                                                        phi_12979_ = _e3727;
                                                    }
                                                    let _e3730 = phi_12979_;
                                                    let _e3733 = local_18.member_1[1u];
                                                    if (_e3733[0] < 0f) {
                                                        phi_12993_ = -(_e3733[0]);
                                                    } else {
                                                        phi_12993_ = _e3733[0];
                                                    }
                                                    let _e3740 = phi_12993_;
                                                    if (_e3733[1] < 0f) {
                                                        phi_13000_ = -(_e3733[1]);
                                                    } else {
                                                        phi_13000_ = _e3733[1];
                                                    }
                                                    let _e3744 = phi_13000_;
                                                    if (_e3740 > _e3744) {
                                                        phi_13005_ = _e3740;
                                                    } else {
                                                        phi_13005_ = _e3744;
                                                    }
                                                    let _e3747 = phi_13005_;
                                                    if (_e3733[2] < 0f) {
                                                        phi_13012_ = -(_e3733[2]);
                                                    } else {
                                                        phi_13012_ = _e3733[2];
                                                    }
                                                    let _e3751 = phi_13012_;
                                                    if (_e3747 > _e3751) {
                                                        phi_13017_ = _e3747;
                                                    } else {
                                                        phi_13017_ = _e3751;
                                                    }
                                                    let _e3754 = phi_13017_;
                                                    if (_e3730 > _e3754) {
                                                        phi_13022_ = _e3730;
                                                    } else {
                                                        phi_13022_ = _e3754;
                                                    }
                                                    let _e3757 = phi_13022_;
                                                    let _e3759 = local_18.member_3;
                                                    let _e3763 = local_18.member_2[0u];
                                                    if (_e3763[0] < 0f) {
                                                        phi_13039_ = -(_e3763[0]);
                                                    } else {
                                                        phi_13039_ = _e3763[0];
                                                    }
                                                    let _e3770 = phi_13039_;
                                                    if (_e3763[1] < 0f) {
                                                        phi_13046_ = -(_e3763[1]);
                                                    } else {
                                                        phi_13046_ = _e3763[1];
                                                    }
                                                    let _e3774 = phi_13046_;
                                                    if (_e3770 > _e3774) {
                                                        phi_13051_ = _e3770;
                                                    } else {
                                                        phi_13051_ = _e3774;
                                                    }
                                                    let _e3777 = phi_13051_;
                                                    if (_e3763[2] < 0f) {
                                                        phi_13058_ = -(_e3763[2]);
                                                    } else {
                                                        phi_13058_ = _e3763[2];
                                                    }
                                                    let _e3781 = phi_13058_;
                                                    if (_e3777 > _e3781) {
                                                        phi_13063_ = _e3777;
                                                    } else {
                                                        phi_13063_ = _e3781;
                                                    }
                                                    let _e3784 = phi_13063_;
                                                    let _e3787 = local_18.member_2[1u];
                                                    if (_e3787[0] < 0f) {
                                                        phi_13077_ = -(_e3787[0]);
                                                    } else {
                                                        phi_13077_ = _e3787[0];
                                                    }
                                                    let _e3794 = phi_13077_;
                                                    if (_e3787[1] < 0f) {
                                                        phi_13084_ = -(_e3787[1]);
                                                    } else {
                                                        phi_13084_ = _e3787[1];
                                                    }
                                                    let _e3798 = phi_13084_;
                                                    if (_e3794 > _e3798) {
                                                        phi_13089_ = _e3794;
                                                    } else {
                                                        phi_13089_ = _e3798;
                                                    }
                                                    let _e3801 = phi_13089_;
                                                    if (_e3787[2] < 0f) {
                                                        phi_13096_ = -(_e3787[2]);
                                                    } else {
                                                        phi_13096_ = _e3787[2];
                                                    }
                                                    let _e3805 = phi_13096_;
                                                    if (_e3801 > _e3805) {
                                                        phi_13101_ = _e3801;
                                                    } else {
                                                        phi_13101_ = _e3805;
                                                    }
                                                    let _e3808 = phi_13101_;
                                                    if (_e3784 > _e3808) {
                                                        phi_13106_ = _e3784;
                                                    } else {
                                                        phi_13106_ = _e3808;
                                                    }
                                                    let _e3811 = phi_13106_;
                                                    let _e3813 = local_18.member_3;
                                                    let _e3820 = local_18.member_3;
                                                    let _e3825 = (_e278 * 0.00390625f);
                                                    local = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    phi_13147_ = type_12(0u, 96u);
                                                    phi_13150_ = _e2889.member;
                                                    phi_13152_ = _e2889.member;
                                                    phi_13154_ = (_e2889.member_1 - _e2889.member);
                                                    phi_13156_ = _e2889.member;
                                                    phi_13158_ = false;
                                                    phi_13160_ = 0u;
                                                    loop {
                                                        let _e3828 = phi_13147_;
                                                        let _e3830 = phi_13150_;
                                                        let _e3832 = phi_13152_;
                                                        let _e3834 = phi_13154_;
                                                        let _e3836 = phi_13156_;
                                                        let _e3838 = phi_13158_;
                                                        let _e3840 = phi_13160_;
                                                        local_30 = _e3830;
                                                        local_75 = _e3832;
                                                        if (_e3828.member < _e3828.member_1) {
                                                            phi_13148_ = type_12((_e3828.member + 1u), _e3828.member_1);
                                                            phi_13183_ = type_12(1u, _e3828.member);
                                                        } else {
                                                            phi_13148_ = _e3828;
                                                            phi_13183_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e3852 = phi_13148_;
                                                        let _e3854 = phi_13183_;
                                                        if (bitcast<i32>(_e3854.member) != 0i) {
                                                            let _e3860 = local_18.member[0u];
                                                            let _e3866 = local_18.member[1u];
                                                            let _e3882 = local_18.member_1[0u];
                                                            let _e3888 = local_18.member_1[1u];
                                                            let _e3904 = local_18.member_2[0u];
                                                            let _e3910 = local_18.member_2[1u];
                                                            let _e3924 = function_2(array<f32, 3>((_e3860[0] + ((_e3866[0] - _e3860[0]) * _e3830)), (_e3860[1] + ((_e3866[1] - _e3860[1]) * _e3830)), (_e3860[2] + ((_e3866[2] - _e3860[2]) * _e3830))), array<f32, 3>((_e3882[0] + ((_e3888[0] - _e3882[0]) * _e3830)), (_e3882[1] + ((_e3888[1] - _e3882[1]) * _e3830)), (_e3882[2] + ((_e3888[2] - _e3882[2]) * _e3830))), array<f32, 3>((_e3904[0] + ((_e3910[0] - _e3904[0]) * _e3830)), (_e3904[1] + ((_e3910[1] - _e3904[1]) * _e3830)), (_e3904[2] + ((_e3910[2] - _e3904[2]) * _e3830))), 0u);
                                                            if (_e3840 == 0u) {
                                                                phi_13311_ = _e3924;
                                                            } else {
                                                                if (_e3840 == 1u) {
                                                                    phi_13297_ = _e3924[0];
                                                                } else {
                                                                    phi_13297_ = 0f;
                                                                }
                                                                let _e3929 = phi_13297_;
                                                                if (_e3840 == 2u) {
                                                                    phi_13303_ = _e3924[1];
                                                                } else {
                                                                    phi_13303_ = 0f;
                                                                }
                                                                let _e3933 = phi_13303_;
                                                                if (_e3840 == 3u) {
                                                                    phi_13309_ = _e3924[2];
                                                                } else {
                                                                    phi_13309_ = 0f;
                                                                }
                                                                let _e3937 = phi_13309_;
                                                                phi_13311_ = array<f32, 3>(_e3929, _e3933, _e3937);
                                                            }
                                                            let _e3940 = phi_13311_;
                                                            if (_e3940[0] < 0f) {
                                                                phi_13318_ = -(_e3940[0]);
                                                            } else {
                                                                phi_13318_ = _e3940[0];
                                                            }
                                                            let _e3945 = phi_13318_;
                                                            if (_e3940[1] < 0f) {
                                                                phi_13325_ = -(_e3940[1]);
                                                            } else {
                                                                phi_13325_ = _e3940[1];
                                                            }
                                                            let _e3950 = phi_13325_;
                                                            if (_e3940[2] < 0f) {
                                                                phi_13333_ = -(_e3940[2]);
                                                            } else {
                                                                phi_13333_ = _e3940[2];
                                                            }
                                                            let _e3956 = phi_13333_;
                                                            let _e3957 = ((_e3945 + _e3950) + _e3956);
                                                            if (_e3957 > 0f) {
                                                                if ((bitcast<u32>(_e3957) & 2139095040u) != 2139095040u) {
                                                                    let _e3962 = (1f / _e3957);
                                                                    let _e3964 = (_e3940[0] * _e3962);
                                                                    let _e3966 = (_e3940[1] * _e3962);
                                                                    let _e3968 = (_e3940[2] * _e3962);
                                                                    let _e3973 = (((_e3964 * _e3964) + (_e3966 * _e3966)) + (_e3968 * _e3968));
                                                                    if (_e3973 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e3973 > 0f) {
                                                                            phi_13370_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_13370_ = 0f;
                                                                        }
                                                                        let _e4026 = phi_13370_;
                                                                        phi_13434_ = _e4026;
                                                                    } else {
                                                                        phi_13377_ = type_14(0i, 5i);
                                                                        phi_13380_ = bitcast<f32>(((bitcast<u32>(_e3973) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e3981 = phi_13377_;
                                                                            let _e3983 = phi_13380_;
                                                                            local_28 = _e3983;
                                                                            if (_e3981.member < _e3981.member_1) {
                                                                                let _e3990 = (_e3981.member + 1i);
                                                                                if ((false == (_e3990 > _e3981.member)) != false) {
                                                                                    phi_13401_ = true;
                                                                                } else {
                                                                                    phi_13401_ = false;
                                                                                }
                                                                                let _e3995 = phi_13401_;
                                                                                if _e3995 {
                                                                                    phi_13407_ = type_15(0u, type_15().member_1);
                                                                                } else {
                                                                                    phi_13407_ = type_15(1u, _e3990);
                                                                                }
                                                                                let _e4000 = phi_13407_;
                                                                                phi_13378_ = type_14(_e4000.member_1, _e3981.member_1);
                                                                                phi_13421_ = type_15(1u, _e3981.member);
                                                                            } else {
                                                                                phi_13378_ = _e3981;
                                                                                phi_13421_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e4006 = phi_13378_;
                                                                            let _e4008 = phi_13421_;
                                                                            let _e4011 = (bitcast<i32>(_e4008.member) != 0i);
                                                                            if _e4011 {
                                                                                phi_13381_ = (0.5f * (_e3983 + (_e3973 / _e3983)));
                                                                            } else {
                                                                                phi_13381_ = f32();
                                                                            }
                                                                            let _e4016 = phi_13381_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_13377_ = _e4006;
                                                                                phi_13380_ = _e4016;
                                                                                break if !(_e4011);
                                                                            }
                                                                        }
                                                                        let _e4021 = local_28;
                                                                        phi_13434_ = (_e4021 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e4028 = phi_13434_;
                                                                    let _e4029 = (0.000000059604645f * 12f);
                                                                    let _e4034 = ((((((((_e3703 + _e3705) + (_e3757 + _e3759)) + (_e3811 + _e3813)) * (0.000000059604645f * 16f)) + (_e3820 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e4028) * (1f + _e4029)));
                                                                    let _e4039 = (((_e3964 * _e3607[0]) + (_e3966 * _e3607[1])) + (_e3968 * _e3607[2]));
                                                                    let _e4044 = (((_e3964 * (_e3607[0] - _e3613[0])) + (_e3966 * (_e3607[1] - _e3613[1]))) + (_e3968 * (_e3607[2] - _e3613[2])));
                                                                    let _e4049 = (((_e3964 * (_e3607[0] - _e3619[0])) + (_e3966 * (_e3607[1] - _e3619[1]))) + (_e3968 * (_e3607[2] - _e3619[2])));
                                                                    let _e4054 = (((_e3964 * _e3607[0]) + (_e3966 * _e3607[1])) + (_e3968 * _e3607[2]));
                                                                    let _e4060 = (((_e3964 * _e3631[0]) + (_e3966 * _e3631[1])) + (_e3968 * _e3631[2]));
                                                                    let _e4065 = (((_e3964 * (_e3631[0] - _e3637[0])) + (_e3966 * (_e3631[1] - _e3637[1]))) + (_e3968 * (_e3631[2] - _e3637[2])));
                                                                    let _e4070 = (((_e3964 * (_e3631[0] - _e3643[0])) + (_e3966 * (_e3631[1] - _e3643[1]))) + (_e3968 * (_e3631[2] - _e3643[2])));
                                                                    let _e4075 = (((_e3964 * _e3631[0]) + (_e3966 * _e3631[1])) + (_e3968 * _e3631[2]));
                                                                    if (_e4039 < 0f) {
                                                                        phi_13500_ = -(_e4039);
                                                                    } else {
                                                                        phi_13500_ = _e4039;
                                                                    }
                                                                    let _e4080 = phi_13500_;
                                                                    if (_e4060 < 0f) {
                                                                        phi_13506_ = -(_e4060);
                                                                    } else {
                                                                        phi_13506_ = _e4060;
                                                                    }
                                                                    let _e4084 = phi_13506_;
                                                                    if (_e4044 < 0f) {
                                                                        phi_13515_ = -(_e4044);
                                                                    } else {
                                                                        phi_13515_ = _e4044;
                                                                    }
                                                                    let _e4091 = phi_13515_;
                                                                    if (_e4065 < 0f) {
                                                                        phi_13521_ = -(_e4065);
                                                                    } else {
                                                                        phi_13521_ = _e4065;
                                                                    }
                                                                    let _e4095 = phi_13521_;
                                                                    if (_e4049 < 0f) {
                                                                        phi_13530_ = -(_e4049);
                                                                    } else {
                                                                        phi_13530_ = _e4049;
                                                                    }
                                                                    let _e4102 = phi_13530_;
                                                                    if (_e4070 < 0f) {
                                                                        phi_13536_ = -(_e4070);
                                                                    } else {
                                                                        phi_13536_ = _e4070;
                                                                    }
                                                                    let _e4106 = phi_13536_;
                                                                    if (_e4054 < 0f) {
                                                                        phi_13545_ = -(_e4054);
                                                                    } else {
                                                                        phi_13545_ = _e4054;
                                                                    }
                                                                    let _e4113 = phi_13545_;
                                                                    if (_e4075 < 0f) {
                                                                        phi_13551_ = -(_e4075);
                                                                    } else {
                                                                        phi_13551_ = _e4075;
                                                                    }
                                                                    let _e4117 = phi_13551_;
                                                                    phi_13557_ = type_32(array<f32, 4>(_e4039, _e4044, _e4049, _e4054), array<f32, 4>(_e4060, _e4065, _e4070, _e4075), array<f32, 4>((_e4034 + ((_e4080 + _e4084) * _e4029)), (_e4034 + ((_e4091 + _e4095) * _e4029)), (_e4034 + ((_e4102 + _e4106) * _e4029)), (_e4034 + ((_e4113 + _e4117) * _e4029))));
                                                                    phi_13558_ = false;
                                                                } else {
                                                                    phi_13557_ = type_32();
                                                                    phi_13558_ = true;
                                                                }
                                                                let _e4124 = phi_13557_;
                                                                let _e4126 = phi_13558_;
                                                                phi_13559_ = _e4124;
                                                                phi_13560_ = _e4126;
                                                            } else {
                                                                phi_13559_ = type_32();
                                                                phi_13560_ = true;
                                                            }
                                                            let _e4128 = phi_13559_;
                                                            let _e4130 = phi_13560_;
                                                            if _e4130 {
                                                                phi_13568_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                            } else {
                                                                phi_13568_ = _e4128;
                                                            }
                                                            let _e4132 = phi_13568_;
                                                            local_1 = type_32(array<f32, 4>(_e4132.member[0], _e4132.member[1], _e4132.member[2], _e4132.member[3]), array<f32, 4>(_e4132.member_1[0], _e4132.member_1[1], _e4132.member_1[2], _e4132.member_1[3]), array<f32, 4>(_e4132.member_2[0], _e4132.member_2[1], _e4132.member_2[2], _e4132.member_2[3]));
                                                            let _e4152 = (_e3830 - _e3836);
                                                            let _e4156 = local_1.member[0u];
                                                            let _e4159 = local_1.member_1[0u];
                                                            let _e4162 = local_1.member[0u];
                                                            let _e4168 = local_1.member_2[0u];
                                                            if (((_e4156 + ((_e4159 - _e4162) * _e3830)) - _e4168) > 0f) {
                                                                let _e4173 = local_1.member[1u];
                                                                let _e4176 = local_1.member_1[1u];
                                                                let _e4179 = local_1.member[1u];
                                                                let _e4185 = local_1.member_2[1u];
                                                                if (((_e4173 + ((_e4176 - _e4179) * _e3830)) - _e4185) > 0f) {
                                                                    let _e4190 = local_1.member[2u];
                                                                    let _e4193 = local_1.member_1[2u];
                                                                    let _e4196 = local_1.member[2u];
                                                                    let _e4202 = local_1.member_2[2u];
                                                                    if (((_e4190 + ((_e4193 - _e4196) * _e3830)) - _e4202) > 0f) {
                                                                        let _e4207 = local_1.member[3u];
                                                                        let _e4210 = local_1.member_1[3u];
                                                                        let _e4213 = local_1.member[3u];
                                                                        let _e4219 = local_1.member_2[3u];
                                                                        phi_13739_ = (((_e4207 + ((_e4210 - _e4213) * _e3830)) - _e4219) > 0f);
                                                                        phi_13740_ = false;
                                                                    } else {
                                                                        phi_13739_ = bool();
                                                                        phi_13740_ = true;
                                                                    }
                                                                    let _e4223 = phi_13739_;
                                                                    let _e4225 = phi_13740_;
                                                                    phi_13741_ = _e4223;
                                                                    phi_13742_ = _e4225;
                                                                } else {
                                                                    phi_13741_ = bool();
                                                                    phi_13742_ = true;
                                                                }
                                                                let _e4227 = phi_13741_;
                                                                let _e4229 = phi_13742_;
                                                                phi_13743_ = _e4227;
                                                                phi_13744_ = _e4229;
                                                            } else {
                                                                phi_13743_ = bool();
                                                                phi_13744_ = true;
                                                            }
                                                            let _e4231 = phi_13743_;
                                                            let _e4233 = phi_13744_;
                                                            if _e4233 {
                                                                phi_13748_ = false;
                                                            } else {
                                                                phi_13748_ = _e4231;
                                                            }
                                                            let _e4235 = phi_13748_;
                                                            if _e4235 {
                                                                if (_e3830 <= _e3832) {
                                                                    phi_14058_ = true;
                                                                } else {
                                                                    let _e4239 = local.member[0u];
                                                                    let _e4242 = local.member_1[0u];
                                                                    let _e4245 = local.member[0u];
                                                                    let _e4251 = local.member_2[0u];
                                                                    let _e4255 = local_1.member[0u];
                                                                    let _e4258 = local_1.member_1[0u];
                                                                    let _e4261 = local_1.member[0u];
                                                                    let _e4267 = local_1.member_2[0u];
                                                                    if ((((_e4239 + ((_e4242 - _e4245) * _e3830)) - _e4251) + ((_e4255 + ((_e4258 - _e4261) * _e3836)) - _e4267)) > 0f) {
                                                                        let _e4273 = local.member[1u];
                                                                        let _e4276 = local.member_1[1u];
                                                                        let _e4279 = local.member[1u];
                                                                        let _e4285 = local.member_2[1u];
                                                                        let _e4289 = local_1.member[1u];
                                                                        let _e4292 = local_1.member_1[1u];
                                                                        let _e4295 = local_1.member[1u];
                                                                        let _e4301 = local_1.member_2[1u];
                                                                        if ((((_e4273 + ((_e4276 - _e4279) * _e3830)) - _e4285) + ((_e4289 + ((_e4292 - _e4295) * _e3836)) - _e4301)) > 0f) {
                                                                            let _e4307 = local.member[2u];
                                                                            let _e4310 = local.member_1[2u];
                                                                            let _e4313 = local.member[2u];
                                                                            let _e4319 = local.member_2[2u];
                                                                            let _e4323 = local_1.member[2u];
                                                                            let _e4326 = local_1.member_1[2u];
                                                                            let _e4329 = local_1.member[2u];
                                                                            let _e4335 = local_1.member_2[2u];
                                                                            if ((((_e4307 + ((_e4310 - _e4313) * _e3830)) - _e4319) + ((_e4323 + ((_e4326 - _e4329) * _e3836)) - _e4335)) > 0f) {
                                                                                let _e4341 = local.member[3u];
                                                                                let _e4344 = local.member_1[3u];
                                                                                let _e4347 = local.member[3u];
                                                                                let _e4353 = local.member_2[3u];
                                                                                let _e4357 = local_1.member[3u];
                                                                                let _e4360 = local_1.member_1[3u];
                                                                                let _e4363 = local_1.member[3u];
                                                                                let _e4369 = local_1.member_2[3u];
                                                                                phi_14045_ = ((((_e4341 + ((_e4344 - _e4347) * _e3830)) - _e4353) + ((_e4357 + ((_e4360 - _e4363) * _e3836)) - _e4369)) > 0f);
                                                                                phi_14046_ = false;
                                                                            } else {
                                                                                phi_14045_ = bool();
                                                                                phi_14046_ = true;
                                                                            }
                                                                            let _e4374 = phi_14045_;
                                                                            let _e4376 = phi_14046_;
                                                                            phi_14047_ = _e4374;
                                                                            phi_14048_ = _e4376;
                                                                        } else {
                                                                            phi_14047_ = bool();
                                                                            phi_14048_ = true;
                                                                        }
                                                                        let _e4378 = phi_14047_;
                                                                        let _e4380 = phi_14048_;
                                                                        phi_14049_ = _e4378;
                                                                        phi_14050_ = _e4380;
                                                                    } else {
                                                                        phi_14049_ = bool();
                                                                        phi_14050_ = true;
                                                                    }
                                                                    let _e4382 = phi_14049_;
                                                                    let _e4384 = phi_14050_;
                                                                    if _e4384 {
                                                                        phi_14054_ = false;
                                                                    } else {
                                                                        phi_14054_ = _e4382;
                                                                    }
                                                                    let _e4386 = phi_14054_;
                                                                    phi_14058_ = _e4386;
                                                                }
                                                                let _e4388 = phi_14058_;
                                                                if _e4388 {
                                                                    if _e3838 {
                                                                        if (_e3830 >= _e2889.member_1) {
                                                                            phi_14069_ = false;
                                                                        } else {
                                                                            phi_14069_ = true;
                                                                        }
                                                                        let _e4391 = phi_14069_;
                                                                        phi_14070_ = _e4391;
                                                                    } else {
                                                                        phi_14070_ = true;
                                                                    }
                                                                    let _e4393 = phi_14070_;
                                                                    if _e4393 {
                                                                        local = type_32(array<f32, 4>(_e4132.member[0], _e4132.member[1], _e4132.member[2], _e4132.member[3]), array<f32, 4>(_e4132.member_1[0], _e4132.member_1[1], _e4132.member_1[2], _e4132.member_1[3]), array<f32, 4>(_e4132.member_2[0], _e4132.member_2[1], _e4132.member_2[2], _e4132.member_2[3]));
                                                                        let _e4415 = local.member[0u];
                                                                        let _e4418 = local.member_1[0u];
                                                                        let _e4421 = local.member_2[0u];
                                                                        if (_e4415 > _e4421) {
                                                                            if (_e4418 > _e4421) {
                                                                                phi_14144_ = false;
                                                                            } else {
                                                                                phi_14144_ = true;
                                                                            }
                                                                            let _e4425 = phi_14144_;
                                                                            phi_14145_ = _e4425;
                                                                        } else {
                                                                            phi_14145_ = true;
                                                                        }
                                                                        let _e4427 = phi_14145_;
                                                                        if _e4427 {
                                                                            let _e4428 = (_e4418 >= _e4415);
                                                                            if _e4428 {
                                                                                phi_14167_ = f32();
                                                                                phi_14168_ = false;
                                                                            } else {
                                                                                if ((_e4415 - _e4418) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14165_ = (((_e4415 - _e4421) / (_e4415 - _e4418)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14166_ = false;
                                                                                } else {
                                                                                    phi_14165_ = f32();
                                                                                    phi_14166_ = true;
                                                                                }
                                                                                let _e4439 = phi_14165_;
                                                                                let _e4441 = phi_14166_;
                                                                                phi_14167_ = _e4439;
                                                                                phi_14168_ = _e4441;
                                                                            }
                                                                            let _e4443 = phi_14167_;
                                                                            let _e4445 = phi_14168_;
                                                                            phi_14169_ = _e4443;
                                                                            phi_14170_ = _e4428;
                                                                            phi_14171_ = _e4445;
                                                                        } else {
                                                                            phi_14169_ = f32();
                                                                            phi_14170_ = true;
                                                                            phi_14171_ = false;
                                                                        }
                                                                        let _e4447 = phi_14169_;
                                                                        let _e4449 = phi_14170_;
                                                                        let _e4451 = phi_14171_;
                                                                        if _e4449 {
                                                                            phi_14175_ = 2f;
                                                                            phi_14176_ = true;
                                                                        } else {
                                                                            phi_14175_ = _e3830;
                                                                            phi_14176_ = _e4451;
                                                                        }
                                                                        let _e4453 = phi_14175_;
                                                                        let _e4455 = phi_14176_;
                                                                        if _e4455 {
                                                                            phi_14180_ = _e4453;
                                                                        } else {
                                                                            phi_14180_ = _e4447;
                                                                        }
                                                                        let _e4457 = phi_14180_;
                                                                        let _e4460 = local.member[1u];
                                                                        let _e4463 = local.member_1[1u];
                                                                        let _e4466 = local.member_2[1u];
                                                                        if (_e4460 > _e4466) {
                                                                            if (_e4463 > _e4466) {
                                                                                phi_14212_ = false;
                                                                            } else {
                                                                                phi_14212_ = true;
                                                                            }
                                                                            let _e4470 = phi_14212_;
                                                                            phi_14213_ = _e4470;
                                                                        } else {
                                                                            phi_14213_ = true;
                                                                        }
                                                                        let _e4472 = phi_14213_;
                                                                        if _e4472 {
                                                                            let _e4473 = (_e4463 >= _e4460);
                                                                            if _e4473 {
                                                                                phi_14235_ = f32();
                                                                                phi_14236_ = false;
                                                                            } else {
                                                                                if ((_e4460 - _e4463) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14233_ = (((_e4460 - _e4466) / (_e4460 - _e4463)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14234_ = false;
                                                                                } else {
                                                                                    phi_14233_ = f32();
                                                                                    phi_14234_ = true;
                                                                                }
                                                                                let _e4484 = phi_14233_;
                                                                                let _e4486 = phi_14234_;
                                                                                phi_14235_ = _e4484;
                                                                                phi_14236_ = _e4486;
                                                                            }
                                                                            let _e4488 = phi_14235_;
                                                                            let _e4490 = phi_14236_;
                                                                            phi_14237_ = _e4488;
                                                                            phi_14238_ = _e4473;
                                                                            phi_14239_ = _e4490;
                                                                        } else {
                                                                            phi_14237_ = f32();
                                                                            phi_14238_ = true;
                                                                            phi_14239_ = false;
                                                                        }
                                                                        let _e4492 = phi_14237_;
                                                                        let _e4494 = phi_14238_;
                                                                        let _e4496 = phi_14239_;
                                                                        if _e4494 {
                                                                            phi_14243_ = 2f;
                                                                            phi_14244_ = true;
                                                                        } else {
                                                                            phi_14243_ = _e3830;
                                                                            phi_14244_ = _e4496;
                                                                        }
                                                                        let _e4498 = phi_14243_;
                                                                        let _e4500 = phi_14244_;
                                                                        if _e4500 {
                                                                            phi_14248_ = _e4498;
                                                                        } else {
                                                                            phi_14248_ = _e4492;
                                                                        }
                                                                        let _e4502 = phi_14248_;
                                                                        if (_e4457 < _e4502) {
                                                                            phi_14253_ = _e4457;
                                                                        } else {
                                                                            phi_14253_ = _e4502;
                                                                        }
                                                                        let _e4505 = phi_14253_;
                                                                        let _e4508 = local.member[2u];
                                                                        let _e4511 = local.member_1[2u];
                                                                        let _e4514 = local.member_2[2u];
                                                                        if (_e4508 > _e4514) {
                                                                            if (_e4511 > _e4514) {
                                                                                phi_14285_ = false;
                                                                            } else {
                                                                                phi_14285_ = true;
                                                                            }
                                                                            let _e4518 = phi_14285_;
                                                                            phi_14286_ = _e4518;
                                                                        } else {
                                                                            phi_14286_ = true;
                                                                        }
                                                                        let _e4520 = phi_14286_;
                                                                        if _e4520 {
                                                                            let _e4521 = (_e4511 >= _e4508);
                                                                            if _e4521 {
                                                                                phi_14308_ = f32();
                                                                                phi_14309_ = false;
                                                                            } else {
                                                                                if ((_e4508 - _e4511) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14306_ = (((_e4508 - _e4514) / (_e4508 - _e4511)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14307_ = false;
                                                                                } else {
                                                                                    phi_14306_ = f32();
                                                                                    phi_14307_ = true;
                                                                                }
                                                                                let _e4532 = phi_14306_;
                                                                                let _e4534 = phi_14307_;
                                                                                phi_14308_ = _e4532;
                                                                                phi_14309_ = _e4534;
                                                                            }
                                                                            let _e4536 = phi_14308_;
                                                                            let _e4538 = phi_14309_;
                                                                            phi_14310_ = _e4536;
                                                                            phi_14311_ = _e4521;
                                                                            phi_14312_ = _e4538;
                                                                        } else {
                                                                            phi_14310_ = f32();
                                                                            phi_14311_ = true;
                                                                            phi_14312_ = false;
                                                                        }
                                                                        let _e4540 = phi_14310_;
                                                                        let _e4542 = phi_14311_;
                                                                        let _e4544 = phi_14312_;
                                                                        if _e4542 {
                                                                            phi_14316_ = 2f;
                                                                            phi_14317_ = true;
                                                                        } else {
                                                                            phi_14316_ = _e3830;
                                                                            phi_14317_ = _e4544;
                                                                        }
                                                                        let _e4546 = phi_14316_;
                                                                        let _e4548 = phi_14317_;
                                                                        if _e4548 {
                                                                            phi_14321_ = _e4546;
                                                                        } else {
                                                                            phi_14321_ = _e4540;
                                                                        }
                                                                        let _e4550 = phi_14321_;
                                                                        let _e4553 = local.member[3u];
                                                                        let _e4556 = local.member_1[3u];
                                                                        let _e4559 = local.member_2[3u];
                                                                        if (_e4553 > _e4559) {
                                                                            if (_e4556 > _e4559) {
                                                                                phi_14353_ = false;
                                                                            } else {
                                                                                phi_14353_ = true;
                                                                            }
                                                                            let _e4563 = phi_14353_;
                                                                            phi_14354_ = _e4563;
                                                                        } else {
                                                                            phi_14354_ = true;
                                                                        }
                                                                        let _e4565 = phi_14354_;
                                                                        if _e4565 {
                                                                            let _e4566 = (_e4556 >= _e4553);
                                                                            if _e4566 {
                                                                                phi_14376_ = f32();
                                                                                phi_14377_ = false;
                                                                            } else {
                                                                                if ((_e4553 - _e4556) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14374_ = (((_e4553 - _e4559) / (_e4553 - _e4556)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14375_ = false;
                                                                                } else {
                                                                                    phi_14374_ = f32();
                                                                                    phi_14375_ = true;
                                                                                }
                                                                                let _e4577 = phi_14374_;
                                                                                let _e4579 = phi_14375_;
                                                                                phi_14376_ = _e4577;
                                                                                phi_14377_ = _e4579;
                                                                            }
                                                                            let _e4581 = phi_14376_;
                                                                            let _e4583 = phi_14377_;
                                                                            phi_14378_ = _e4581;
                                                                            phi_14379_ = _e4566;
                                                                            phi_14380_ = _e4583;
                                                                        } else {
                                                                            phi_14378_ = f32();
                                                                            phi_14379_ = true;
                                                                            phi_14380_ = false;
                                                                        }
                                                                        let _e4585 = phi_14378_;
                                                                        let _e4587 = phi_14379_;
                                                                        let _e4589 = phi_14380_;
                                                                        if _e4587 {
                                                                            phi_14384_ = 2f;
                                                                            phi_14385_ = true;
                                                                        } else {
                                                                            phi_14384_ = _e3830;
                                                                            phi_14385_ = _e4589;
                                                                        }
                                                                        let _e4591 = phi_14384_;
                                                                        let _e4593 = phi_14385_;
                                                                        if _e4593 {
                                                                            phi_14389_ = _e4591;
                                                                        } else {
                                                                            phi_14389_ = _e4585;
                                                                        }
                                                                        let _e4595 = phi_14389_;
                                                                        if (_e4550 < _e4595) {
                                                                            phi_14394_ = _e4550;
                                                                        } else {
                                                                            phi_14394_ = _e4595;
                                                                        }
                                                                        let _e4598 = phi_14394_;
                                                                        if (_e4505 < _e4598) {
                                                                            phi_14399_ = _e4505;
                                                                        } else {
                                                                            phi_14399_ = _e4598;
                                                                        }
                                                                        let _e4601 = phi_14399_;
                                                                        if (_e4601 > _e3830) {
                                                                            phi_14404_ = _e4601;
                                                                        } else {
                                                                            phi_14404_ = _e3830;
                                                                        }
                                                                        let _e4604 = phi_14404_;
                                                                        let _e4605 = (_e4604 > _e2889.member_1);
                                                                        if _e4605 {
                                                                            phi_14909_ = f32();
                                                                            phi_14910_ = f32();
                                                                            phi_14911_ = false;
                                                                        } else {
                                                                            let _e4606 = (_e4604 - _e3830);
                                                                            if _e3838 {
                                                                                if (_e4606 <= _e3825) {
                                                                                    phi_14899_ = true;
                                                                                } else {
                                                                                    if (_e4606 <= (_e3834 * 0.25f)) {
                                                                                        phi_14898_ = false;
                                                                                    } else {
                                                                                        phi_14898_ = true;
                                                                                    }
                                                                                    let _e4612 = phi_14898_;
                                                                                    phi_14899_ = _e4612;
                                                                                }
                                                                                let _e4614 = phi_14899_;
                                                                                if _e4614 {
                                                                                    phi_14904_ = (_e4152 + _e4152);
                                                                                } else {
                                                                                    phi_14904_ = 0f;
                                                                                }
                                                                                let _e4617 = phi_14904_;
                                                                                phi_14906_ = _e4617;
                                                                            } else {
                                                                                phi_14906_ = (_e2889.member_1 - _e3830);
                                                                            }
                                                                            let _e4619 = phi_14906_;
                                                                            phi_14909_ = _e4619;
                                                                            phi_14910_ = _e4606;
                                                                            phi_14911_ = true;
                                                                        }
                                                                        let _e4621 = phi_14909_;
                                                                        let _e4623 = phi_14910_;
                                                                        let _e4625 = phi_14911_;
                                                                        phi_14913_ = _e4604;
                                                                        phi_14914_ = _e4621;
                                                                        phi_14915_ = _e4623;
                                                                        phi_14917_ = _e4625;
                                                                        phi_14918_ = _e4605;
                                                                        phi_14920_ = false;
                                                                    } else {
                                                                        phi_14913_ = f32();
                                                                        phi_14914_ = f32();
                                                                        phi_14915_ = f32();
                                                                        phi_14917_ = false;
                                                                        phi_14918_ = false;
                                                                        phi_14920_ = true;
                                                                    }
                                                                    let _e4627 = phi_14913_;
                                                                    let _e4629 = phi_14914_;
                                                                    let _e4631 = phi_14915_;
                                                                    let _e4633 = phi_14917_;
                                                                    let _e4635 = phi_14918_;
                                                                    let _e4637 = phi_14920_;
                                                                    phi_14921_ = _e4627;
                                                                    phi_14922_ = _e4629;
                                                                    phi_14923_ = _e4631;
                                                                    phi_14925_ = false;
                                                                    phi_14926_ = _e4633;
                                                                    phi_14927_ = _e4635;
                                                                    phi_14929_ = _e4637;
                                                                } else {
                                                                    phi_14921_ = f32();
                                                                    phi_14922_ = f32();
                                                                    phi_14923_ = f32();
                                                                    phi_14925_ = true;
                                                                    phi_14926_ = false;
                                                                    phi_14927_ = false;
                                                                    phi_14929_ = false;
                                                                }
                                                                let _e4639 = phi_14921_;
                                                                let _e4641 = phi_14922_;
                                                                let _e4643 = phi_14923_;
                                                                let _e4645 = phi_14925_;
                                                                let _e4647 = phi_14926_;
                                                                let _e4649 = phi_14927_;
                                                                let _e4651 = phi_14929_;
                                                                phi_14930_ = _e4639;
                                                                phi_14931_ = _e4641;
                                                                phi_14932_ = _e4643;
                                                                phi_14934_ = _e4645;
                                                                phi_14935_ = _e4647;
                                                                phi_14936_ = _e4649;
                                                                phi_14938_ = _e4651;
                                                            } else {
                                                                phi_14930_ = f32();
                                                                phi_14931_ = f32();
                                                                phi_14932_ = f32();
                                                                phi_14934_ = true;
                                                                phi_14935_ = false;
                                                                phi_14936_ = false;
                                                                phi_14938_ = false;
                                                            }
                                                            let _e4653 = phi_14930_;
                                                            let _e4655 = phi_14931_;
                                                            let _e4657 = phi_14932_;
                                                            let _e4659 = phi_14934_;
                                                            let _e4661 = phi_14935_;
                                                            let _e4663 = phi_14936_;
                                                            let _e4665 = phi_14938_;
                                                            if _e4659 {
                                                                if (_e3830 <= _e3832) {
                                                                    let _e4826 = (_e3840 + 1u);
                                                                    let _e4827 = (_e4826 > 3u);
                                                                    if _e4827 {
                                                                        phi_14951_ = false;
                                                                    } else {
                                                                        phi_14951_ = true;
                                                                    }
                                                                    let _e4829 = phi_14951_;
                                                                    phi_15273_ = _e4826;
                                                                    phi_15274_ = f32();
                                                                    phi_15275_ = false;
                                                                    phi_15276_ = _e4829;
                                                                    phi_15277_ = _e4827;
                                                                } else {
                                                                    let _e4669 = local.member[0u];
                                                                    let _e4672 = local.member_1[0u];
                                                                    let _e4675 = local.member[0u];
                                                                    let _e4681 = local.member_2[0u];
                                                                    let _e4682 = ((_e4669 + ((_e4672 - _e4675) * _e3836)) - _e4681);
                                                                    let _e4685 = local.member[1u];
                                                                    let _e4688 = local.member_1[1u];
                                                                    let _e4691 = local.member[1u];
                                                                    let _e4697 = local.member_2[1u];
                                                                    let _e4698 = ((_e4685 + ((_e4688 - _e4691) * _e3836)) - _e4697);
                                                                    if (_e4682 < _e4698) {
                                                                        phi_15024_ = _e4682;
                                                                    } else {
                                                                        phi_15024_ = _e4698;
                                                                    }
                                                                    let _e4701 = phi_15024_;
                                                                    let _e4704 = local.member[2u];
                                                                    let _e4707 = local.member_1[2u];
                                                                    let _e4710 = local.member[2u];
                                                                    let _e4716 = local.member_2[2u];
                                                                    let _e4717 = ((_e4704 + ((_e4707 - _e4710) * _e3836)) - _e4716);
                                                                    let _e4720 = local.member[3u];
                                                                    let _e4723 = local.member_1[3u];
                                                                    let _e4726 = local.member[3u];
                                                                    let _e4732 = local.member_2[3u];
                                                                    let _e4733 = ((_e4720 + ((_e4723 - _e4726) * _e3836)) - _e4732);
                                                                    if (_e4717 < _e4733) {
                                                                        phi_15097_ = _e4717;
                                                                    } else {
                                                                        phi_15097_ = _e4733;
                                                                    }
                                                                    let _e4736 = phi_15097_;
                                                                    if (_e4701 < _e4736) {
                                                                        phi_15102_ = _e4701;
                                                                    } else {
                                                                        phi_15102_ = _e4736;
                                                                    }
                                                                    let _e4739 = phi_15102_;
                                                                    let _e4742 = local_1.member[0u];
                                                                    let _e4745 = local_1.member_1[0u];
                                                                    let _e4748 = local_1.member[0u];
                                                                    let _e4754 = local_1.member_2[0u];
                                                                    let _e4755 = ((_e4742 + ((_e4745 - _e4748) * _e3830)) - _e4754);
                                                                    let _e4758 = local_1.member[1u];
                                                                    let _e4761 = local_1.member_1[1u];
                                                                    let _e4764 = local_1.member[1u];
                                                                    let _e4770 = local_1.member_2[1u];
                                                                    let _e4771 = ((_e4758 + ((_e4761 - _e4764) * _e3830)) - _e4770);
                                                                    if (_e4755 < _e4771) {
                                                                        phi_15175_ = _e4755;
                                                                    } else {
                                                                        phi_15175_ = _e4771;
                                                                    }
                                                                    let _e4774 = phi_15175_;
                                                                    let _e4777 = local_1.member[2u];
                                                                    let _e4780 = local_1.member_1[2u];
                                                                    let _e4783 = local_1.member[2u];
                                                                    let _e4789 = local_1.member_2[2u];
                                                                    let _e4790 = ((_e4777 + ((_e4780 - _e4783) * _e3830)) - _e4789);
                                                                    let _e4793 = local_1.member[3u];
                                                                    let _e4796 = local_1.member_1[3u];
                                                                    let _e4799 = local_1.member[3u];
                                                                    let _e4805 = local_1.member_2[3u];
                                                                    let _e4806 = ((_e4793 + ((_e4796 - _e4799) * _e3830)) - _e4805);
                                                                    if (_e4790 < _e4806) {
                                                                        phi_15248_ = _e4790;
                                                                    } else {
                                                                        phi_15248_ = _e4806;
                                                                    }
                                                                    let _e4809 = phi_15248_;
                                                                    if (_e4774 < _e4809) {
                                                                        phi_15253_ = _e4774;
                                                                    } else {
                                                                        phi_15253_ = _e4809;
                                                                    }
                                                                    let _e4812 = phi_15253_;
                                                                    if (_e4812 > 0f) {
                                                                        phi_15271_ = 0.5f;
                                                                    } else {
                                                                        let _e4816 = (0.95f * (_e4739 / (_e4739 - _e4812)));
                                                                        if (_e4816 > 0.0625f) {
                                                                            if (_e4816 < 0.9f) {
                                                                                phi_15269_ = _e4816;
                                                                            } else {
                                                                                phi_15269_ = 0.9f;
                                                                            }
                                                                            let _e4820 = phi_15269_;
                                                                            phi_15270_ = _e4820;
                                                                        } else {
                                                                            phi_15270_ = 0.0625f;
                                                                        }
                                                                        let _e4822 = phi_15270_;
                                                                        phi_15271_ = _e4822;
                                                                    }
                                                                    let _e4824 = phi_15271_;
                                                                    phi_15273_ = u32();
                                                                    phi_15274_ = (_e4152 * _e4824);
                                                                    phi_15275_ = true;
                                                                    phi_15276_ = false;
                                                                    phi_15277_ = false;
                                                                }
                                                                let _e4831 = phi_15273_;
                                                                let _e4833 = phi_15274_;
                                                                let _e4835 = phi_15275_;
                                                                let _e4837 = phi_15276_;
                                                                let _e4839 = phi_15277_;
                                                                phi_15278_ = _e4831;
                                                                phi_15279_ = _e3832;
                                                                phi_15280_ = _e4833;
                                                                phi_15281_ = _e3834;
                                                                phi_15282_ = _e3836;
                                                                phi_15283_ = _e3838;
                                                                phi_15284_ = _e3840;
                                                                phi_15285_ = _e4835;
                                                                phi_15286_ = _e4837;
                                                                phi_15287_ = _e4839;
                                                                phi_15288_ = false;
                                                                phi_15290_ = false;
                                                            } else {
                                                                phi_15278_ = u32();
                                                                phi_15279_ = _e4653;
                                                                phi_15280_ = _e4655;
                                                                phi_15281_ = _e4657;
                                                                phi_15282_ = _e3830;
                                                                phi_15283_ = true;
                                                                phi_15284_ = 0u;
                                                                phi_15285_ = _e4661;
                                                                phi_15286_ = false;
                                                                phi_15287_ = false;
                                                                phi_15288_ = _e4663;
                                                                phi_15290_ = _e4665;
                                                            }
                                                            let _e4841 = phi_15278_;
                                                            let _e4843 = phi_15279_;
                                                            let _e4845 = phi_15280_;
                                                            let _e4847 = phi_15281_;
                                                            let _e4849 = phi_15282_;
                                                            let _e4851 = phi_15283_;
                                                            let _e4853 = phi_15284_;
                                                            let _e4855 = phi_15285_;
                                                            let _e4857 = phi_15286_;
                                                            let _e4859 = phi_15287_;
                                                            let _e4861 = phi_15288_;
                                                            let _e4863 = phi_15290_;
                                                            if _e4855 {
                                                                let _e4864 = (_e4849 + _e4845);
                                                                if (_e4864 > _e4843) {
                                                                    phi_15299_ = _e4864;
                                                                } else {
                                                                    phi_15299_ = _e4843;
                                                                }
                                                                let _e4867 = phi_15299_;
                                                                if (_e4867 < _e2889.member_1) {
                                                                    phi_15304_ = _e4867;
                                                                } else {
                                                                    phi_15304_ = _e2889.member_1;
                                                                }
                                                                let _e4870 = phi_15304_;
                                                                if !(_e3838) {
                                                                    phi_15313_ = true;
                                                                } else {
                                                                    phi_15313_ = ((_e4870 - _e4849) > _e3825);
                                                                }
                                                                let _e4874 = phi_15313_;
                                                                if _e4874 {
                                                                    phi_15317_ = false;
                                                                } else {
                                                                    phi_15317_ = true;
                                                                }
                                                                let _e4876 = phi_15317_;
                                                                phi_15318_ = _e4870;
                                                                phi_15319_ = _e4843;
                                                                phi_15320_ = _e4847;
                                                                phi_15321_ = _e4849;
                                                                phi_15322_ = _e4851;
                                                                phi_15323_ = _e4853;
                                                                phi_15324_ = _e4874;
                                                                phi_15325_ = _e4876;
                                                                phi_15326_ = false;
                                                                phi_15327_ = false;
                                                                phi_15329_ = false;
                                                            } else {
                                                                phi_15318_ = _e3830;
                                                                phi_15319_ = _e3832;
                                                                phi_15320_ = _e3834;
                                                                phi_15321_ = _e3836;
                                                                phi_15322_ = _e3838;
                                                                phi_15323_ = _e4841;
                                                                phi_15324_ = _e4857;
                                                                phi_15325_ = false;
                                                                phi_15326_ = _e4859;
                                                                phi_15327_ = _e4861;
                                                                phi_15329_ = _e4863;
                                                            }
                                                            let _e4878 = phi_15318_;
                                                            let _e4880 = phi_15319_;
                                                            let _e4882 = phi_15320_;
                                                            let _e4884 = phi_15321_;
                                                            let _e4886 = phi_15322_;
                                                            let _e4888 = phi_15323_;
                                                            let _e4890 = phi_15324_;
                                                            let _e4892 = phi_15325_;
                                                            let _e4894 = phi_15326_;
                                                            let _e4896 = phi_15327_;
                                                            let _e4898 = phi_15329_;
                                                            phi_13151_ = _e4878;
                                                            phi_13153_ = _e4880;
                                                            phi_13155_ = _e4882;
                                                            phi_13157_ = _e4884;
                                                            phi_13159_ = _e4886;
                                                            phi_13161_ = _e4888;
                                                            phi_15330_ = _e4843;
                                                            phi_15332_ = _e4890;
                                                            phi_15333_ = _e4892;
                                                            phi_15334_ = _e4894;
                                                            phi_15335_ = _e4896;
                                                            phi_15337_ = false;
                                                            phi_15338_ = _e4898;
                                                        } else {
                                                            phi_13151_ = f32();
                                                            phi_13153_ = f32();
                                                            phi_13155_ = f32();
                                                            phi_13157_ = f32();
                                                            phi_13159_ = bool();
                                                            phi_13161_ = u32();
                                                            phi_15330_ = f32();
                                                            phi_15332_ = false;
                                                            phi_15333_ = false;
                                                            phi_15334_ = false;
                                                            phi_15335_ = false;
                                                            phi_15337_ = true;
                                                            phi_15338_ = false;
                                                        }
                                                        let _e4900 = phi_13151_;
                                                        let _e4902 = phi_13153_;
                                                        let _e4904 = phi_13155_;
                                                        let _e4906 = phi_13157_;
                                                        let _e4908 = phi_13159_;
                                                        let _e4910 = phi_13161_;
                                                        let _e4912 = phi_15330_;
                                                        let _e4914 = phi_15332_;
                                                        let _e4916 = phi_15333_;
                                                        let _e4918 = phi_15334_;
                                                        let _e4920 = phi_15335_;
                                                        let _e4922 = phi_15337_;
                                                        let _e4924 = phi_15338_;
                                                        local_29 = _e4916;
                                                        local_69 = _e4918;
                                                        local_70 = _e4920;
                                                        local_71 = _e4922;
                                                        local_72 = _e4924;
                                                        local_73 = _e4916;
                                                        local_74 = _e4912;
                                                        continue;
                                                        continuing {
                                                            phi_13147_ = _e3852;
                                                            phi_13150_ = _e4900;
                                                            phi_13152_ = _e4902;
                                                            phi_13154_ = _e4904;
                                                            phi_13156_ = _e4906;
                                                            phi_13158_ = _e4908;
                                                            phi_13160_ = _e4910;
                                                            break if !(_e4914);
                                                        }
                                                    }
                                                    let _e4927 = local_29;
                                                    if _e4927 {
                                                        phi_15342_ = false;
                                                        phi_15343_ = false;
                                                        phi_15345_ = false;
                                                        phi_15346_ = false;
                                                    } else {
                                                        let _e10561 = local_69;
                                                        phi_15342_ = _e10561;
                                                        let _e10564 = local_70;
                                                        phi_15343_ = _e10564;
                                                        let _e10567 = local_71;
                                                        phi_15345_ = _e10567;
                                                        let _e10570 = local_72;
                                                        phi_15346_ = _e10570;
                                                    }
                                                    let _e4929 = phi_15342_;
                                                    let _e4931 = phi_15343_;
                                                    let _e4933 = phi_15345_;
                                                    let _e4935 = phi_15346_;
                                                    if _e4929 {
                                                        let _e4937 = local_30;
                                                        phi_15351_ = type_28(1u, _e4937);
                                                        phi_15352_ = false;
                                                        phi_15354_ = false;
                                                        phi_15355_ = false;
                                                        phi_15356_ = false;
                                                    } else {
                                                        phi_15351_ = type_28();
                                                        phi_15352_ = _e4931;
                                                        let _e10576 = local_73;
                                                        phi_15354_ = _e10576;
                                                        phi_15355_ = _e4933;
                                                        phi_15356_ = _e4935;
                                                    }
                                                    let _e4940 = phi_15351_;
                                                    let _e4942 = phi_15352_;
                                                    let _e4944 = phi_15354_;
                                                    let _e4946 = phi_15355_;
                                                    let _e4948 = phi_15356_;
                                                    if _e4942 {
                                                        phi_15361_ = type_28(0u, type_28().member_1);
                                                        phi_15363_ = false;
                                                        phi_15364_ = false;
                                                        phi_15365_ = false;
                                                        phi_15366_ = true;
                                                    } else {
                                                        phi_15361_ = _e4940;
                                                        phi_15363_ = _e4944;
                                                        phi_15364_ = _e4946;
                                                        phi_15365_ = _e4948;
                                                        phi_15366_ = _e4929;
                                                    }
                                                    let _e4952 = phi_15361_;
                                                    let _e4954 = phi_15363_;
                                                    let _e4956 = phi_15364_;
                                                    let _e4958 = phi_15365_;
                                                    let _e4960 = phi_15366_;
                                                    if _e4954 {
                                                        let _e10586 = local_74;
                                                        phi_15378_ = _e10586;
                                                        phi_15379_ = true;
                                                        phi_15380_ = false;
                                                        phi_15381_ = false;
                                                    } else {
                                                        let _e10588 = local_75;
                                                        phi_15378_ = _e10588;
                                                        phi_15379_ = _e4956;
                                                        phi_15380_ = _e4958;
                                                        phi_15381_ = _e4960;
                                                    }
                                                    let _e4962 = phi_15378_;
                                                    let _e4964 = phi_15379_;
                                                    let _e4966 = phi_15380_;
                                                    let _e4968 = phi_15381_;
                                                    if _e4964 {
                                                        phi_15386_ = type_28(1u, _e4962);
                                                        phi_15387_ = false;
                                                        phi_15388_ = false;
                                                    } else {
                                                        phi_15386_ = type_28();
                                                        phi_15387_ = _e4966;
                                                        phi_15388_ = _e4968;
                                                    }
                                                    let _e4971 = phi_15386_;
                                                    let _e4973 = phi_15387_;
                                                    let _e4975 = phi_15388_;
                                                    if _e4973 {
                                                        phi_15393_ = type_28(0u, type_28().member_1);
                                                        phi_15394_ = true;
                                                    } else {
                                                        phi_15393_ = _e4952;
                                                        phi_15394_ = _e4975;
                                                    }
                                                    let _e4979 = phi_15393_;
                                                    let _e4981 = phi_15394_;
                                                    if _e4981 {
                                                        phi_15398_ = _e4979;
                                                    } else {
                                                        phi_15398_ = _e4971;
                                                    }
                                                    let _e4983 = phi_15398_;
                                                    let _e4986 = (_e4983.member != 0u);
                                                    if _e4986 {
                                                        phi_15405_ = false;
                                                    } else {
                                                        phi_15405_ = true;
                                                    }
                                                    let _e4988 = phi_15405_;
                                                    phi_15406_ = _e4983.member_1;
                                                    phi_15407_ = _e4988;
                                                    phi_15408_ = _e4986;
                                                    phi_15409_ = false;
                                                } else {
                                                    phi_15406_ = f32();
                                                    phi_15407_ = false;
                                                    phi_15408_ = false;
                                                    phi_15409_ = true;
                                                }
                                                let _e4990 = phi_15406_;
                                                let _e4992 = phi_15407_;
                                                let _e4994 = phi_15408_;
                                                let _e4996 = phi_15409_;
                                                phi_15410_ = _e3593;
                                                phi_15411_ = _e3594;
                                                phi_15412_ = _e4990;
                                                phi_15413_ = _e4992;
                                                phi_15414_ = _e4994;
                                                phi_15415_ = _e4996;
                                            }
                                            let _e4998 = phi_15410_;
                                            let _e5000 = phi_15411_;
                                            let _e5002 = phi_15412_;
                                            let _e5004 = phi_15413_;
                                            let _e5006 = phi_15414_;
                                            let _e5008 = phi_15415_;
                                            phi_15416_ = _e4998;
                                            phi_15417_ = _e5000;
                                            phi_15418_ = _e5002;
                                            phi_15419_ = _e3589;
                                            phi_15420_ = _e5004;
                                            phi_15421_ = _e5006;
                                            phi_15422_ = _e5008;
                                        }
                                        let _e5010 = phi_15416_;
                                        let _e5012 = phi_15417_;
                                        let _e5014 = phi_15418_;
                                        let _e5016 = phi_15419_;
                                        let _e5018 = phi_15420_;
                                        let _e5020 = phi_15421_;
                                        let _e5022 = phi_15422_;
                                        if _e5016 {
                                            phi_15426_ = false;
                                            phi_15427_ = false;
                                            phi_15428_ = false;
                                        } else {
                                            phi_15426_ = _e5018;
                                            phi_15427_ = _e5020;
                                            phi_15428_ = _e5022;
                                        }
                                        let _e5024 = phi_15426_;
                                        let _e5026 = phi_15427_;
                                        let _e5028 = phi_15428_;
                                        phi_15429_ = _e2889;
                                        phi_15430_ = _e5010;
                                        phi_15431_ = _e5012;
                                        phi_15432_ = _e5014;
                                        phi_15433_ = _e2889;
                                        phi_15434_ = _e5016;
                                        phi_15435_ = _e5024;
                                        phi_15436_ = _e5026;
                                        phi_15437_ = _e5028;
                                    } else {
                                        phi_15429_ = type_41();
                                        phi_15430_ = bool();
                                        phi_15431_ = f32();
                                        phi_15432_ = f32();
                                        phi_15433_ = type_41();
                                        phi_15434_ = true;
                                        phi_15435_ = false;
                                        phi_15436_ = false;
                                        phi_15437_ = false;
                                    }
                                    let _e5030 = phi_15429_;
                                    let _e5032 = phi_15430_;
                                    let _e5034 = phi_15431_;
                                    let _e5036 = phi_15432_;
                                    let _e5038 = phi_15433_;
                                    let _e5040 = phi_15434_;
                                    let _e5042 = phi_15435_;
                                    let _e5044 = phi_15436_;
                                    let _e5046 = phi_15437_;
                                    if _e5040 {
                                        phi_15441_ = true;
                                        phi_15442_ = false;
                                        phi_15443_ = false;
                                    } else {
                                        phi_15441_ = _e5042;
                                        phi_15442_ = _e5044;
                                        phi_15443_ = _e5046;
                                    }
                                    let _e5048 = phi_15441_;
                                    let _e5050 = phi_15442_;
                                    let _e5052 = phi_15443_;
                                    phi_15444_ = _e5030;
                                    phi_15445_ = _e5032;
                                    phi_15446_ = _e5034;
                                    phi_15447_ = _e5036;
                                    phi_15448_ = _e5038;
                                    phi_15449_ = _e5048;
                                    phi_15450_ = false;
                                    phi_15451_ = _e5050;
                                    phi_15452_ = _e5052;
                                } else {
                                    phi_15444_ = type_41();
                                    phi_15445_ = bool();
                                    phi_15446_ = f32();
                                    phi_15447_ = f32();
                                    phi_15448_ = type_41();
                                    phi_15449_ = false;
                                    phi_15450_ = true;
                                    phi_15451_ = false;
                                    phi_15452_ = false;
                                }
                                let _e5054 = phi_15444_;
                                let _e5056 = phi_15445_;
                                let _e5058 = phi_15446_;
                                let _e5060 = phi_15447_;
                                let _e5062 = phi_15448_;
                                let _e5064 = phi_15449_;
                                let _e5066 = phi_15450_;
                                let _e5068 = phi_15451_;
                                let _e5070 = phi_15452_;
                                local_31 = _e5066;
                                local_76 = _e5068;
                                local_77 = _e5070;
                                local_32 = _e5056;
                                local_33 = _e5054;
                                local_34 = _e5060;
                                local_35 = _e5058;
                                local_36 = _e5060;
                                local_37 = _e5060;
                                local_38 = _e5062;
                                continue;
                                continuing {
                                    phi_11255_ = _e2612;
                                    break if !(_e5064);
                                }
                            }
                            let _e5073 = local_31;
                            if _e5073 {
                                phi_15457_ = type_28(0u, type_28().member_1);
                                phi_15458_ = false;
                                phi_15459_ = false;
                            } else {
                                phi_15457_ = type_28();
                                let _e10644 = local_76;
                                phi_15458_ = _e10644;
                                let _e10647 = local_77;
                                phi_15459_ = _e10647;
                            }
                            let _e5077 = phi_15457_;
                            let _e5079 = phi_15458_;
                            let _e5081 = phi_15459_;
                            if _e5079 {
                                let _e5083 = local_32;
                                if _e5083 {
                                    let _e5085 = local_33;
                                    let _e5088 = local_34;
                                    let _e5091 = local_35;
                                    if ((_e5085.member_1 - _e5088) <= _e5091) {
                                        let _e5094 = local_36;
                                        phi_15473_ = type_28(1u, _e5094);
                                        phi_15474_ = false;
                                    } else {
                                        phi_15473_ = type_28();
                                        phi_15474_ = true;
                                    }
                                    let _e5097 = phi_15473_;
                                    let _e5099 = phi_15474_;
                                    phi_15475_ = _e5097;
                                    phi_15476_ = _e5099;
                                } else {
                                    phi_15475_ = type_28();
                                    phi_15476_ = true;
                                }
                                let _e5101 = phi_15475_;
                                let _e5103 = phi_15476_;
                                if _e5103 {
                                    let _e5105 = local_37;
                                    phi_15481_ = type_28(2u, _e5105);
                                } else {
                                    phi_15481_ = _e5101;
                                }
                                let _e5108 = phi_15481_;
                                phi_15482_ = _e5108;
                                phi_15483_ = false;
                            } else {
                                phi_15482_ = type_28();
                                phi_15483_ = _e5081;
                            }
                            let _e5110 = phi_15482_;
                            let _e5112 = phi_15483_;
                            if _e5112 {
                                let _e5114 = local_38;
                                phi_15489_ = type_28(1u, _e5114.member);
                                phi_15490_ = true;
                            } else {
                                phi_15489_ = _e5110;
                                phi_15490_ = _e5079;
                            }
                            let _e5118 = phi_15489_;
                            let _e5120 = phi_15490_;
                            phi_15494_ = _e5118;
                            phi_15495_ = _e5077;
                            phi_15496_ = _e5120;
                        } else {
                            phi_15494_ = _e2458;
                            phi_15495_ = type_28();
                            phi_15496_ = true;
                        }
                        let _e5122 = phi_15494_;
                        let _e5124 = phi_15495_;
                        let _e5126 = phi_15496_;
                        phi_15500_ = _e5122;
                        phi_15501_ = _e5124;
                        phi_15502_ = _e5126;
                    }
                    let _e5130 = phi_15500_;
                    let _e5132 = phi_15501_;
                    let _e5134 = phi_15502_;
                    if _e5134 {
                        phi_15506_ = _e5130;
                    } else {
                        phi_15506_ = _e5132;
                    }
                    let _e5136 = phi_15506_;
                    if (_e5136.member == 1u) {
                        if (_e5136.member_1 > _e280) {
                            phi_15517_ = false;
                        } else {
                            phi_15517_ = true;
                        }
                        let _e5142 = phi_15517_;
                        phi_15518_ = _e5142;
                    } else {
                        phi_15518_ = true;
                    }
                    let _e5144 = phi_15518_;
                    if _e5144 {
                        phi_15522_ = false;
                    } else {
                        phi_15522_ = true;
                    }
                    let _e5146 = phi_15522_;
                    if _e5146 {
                        phi_15526_ = 1u;
                    } else {
                        phi_15526_ = 0u;
                    }
                    let _e5148 = phi_15526_;
                    phi_15530_ = type_39(_e5136, _e5148);
                }
                let _e9639 = phi_15530_;
                switch bitcast<i32>(_e9639.member.member) {
                    case 0: {
                        phi_15545_ = type_42(0u, _e9639.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e9650 = function_3(_e9639.member.member_1);
                        phi_15545_ = type_42(0u, _e9639.member_1, _e9650, true);
                        break;
                    }
                    case 2: {
                        let _e9646 = function_3(_e9639.member.member_1);
                        phi_15545_ = type_42(1u, _e9639.member_1, _e9646, true);
                        break;
                    }
                    default: {
                        phi_15545_ = type_42();
                        break;
                    }
                }
                let _e9654 = phi_15545_;
                let _e9658 = params.member.member.member_12;
                let _e9659 = bitcast<u32>(_e9658);
                if (_e9659 < 8388608u) {
                    phi_15568_ = array<u32, 2>();
                    phi_15569_ = true;
                } else {
                    let _e9663 = ((_e9659 >> bitcast<u32>(31i)) == 1u);
                    if _e9663 {
                        phi_15567_ = array<u32, 2>();
                    } else {
                        phi_15567_ = array<u32, 2>((_e9659 << bitcast<u32>(29i)), ((((_e9659 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e9659 & 8388607u) >> bitcast<u32>(3i))));
                    }
                    let _e9677 = phi_15567_;
                    phi_15568_ = _e9677;
                    phi_15569_ = _e9663;
                }
                let _e9679 = phi_15568_;
                let _e9681 = phi_15569_;
                if _e9681 {
                    phi_15573_ = array<u32, 2>(0u, 0u);
                } else {
                    phi_15573_ = _e9679;
                }
                let _e9683 = phi_15573_;
                if (_e9654.member_2[0] == _e9683[0]) {
                    let _e9689 = params.member.member.member_12;
                    let _e9690 = bitcast<u32>(_e9689);
                    if (_e9690 < 8388608u) {
                        phi_15601_ = array<u32, 2>();
                        phi_15602_ = true;
                    } else {
                        let _e9694 = ((_e9690 >> bitcast<u32>(31i)) == 1u);
                        if _e9694 {
                            phi_15600_ = array<u32, 2>();
                        } else {
                            phi_15600_ = array<u32, 2>((_e9690 << bitcast<u32>(29i)), ((((_e9690 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e9690 & 8388607u) >> bitcast<u32>(3i))));
                        }
                        let _e9708 = phi_15600_;
                        phi_15601_ = _e9708;
                        phi_15602_ = _e9694;
                    }
                    let _e9710 = phi_15601_;
                    let _e9712 = phi_15602_;
                    if _e9712 {
                        phi_15606_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_15606_ = _e9710;
                    }
                    let _e9714 = phi_15606_;
                    phi_15609_ = (_e9654.member_2[1] == _e9714[1]);
                } else {
                    phi_15609_ = false;
                }
                let _e9718 = phi_15609_;
                let _e9720 = params.member.member.member_1;
                if ((_e9720 & 128u) != 0u) {
                    phi_15625_ = true;
                } else {
                    let _e9724 = params.member.member.member_1;
                    if ((_e9724 & 64u) != 0u) {
                        phi_15624_ = _e9718;
                    } else {
                        phi_15624_ = false;
                    }
                    let _e9728 = phi_15624_;
                    phi_15625_ = _e9728;
                }
                let _e9730 = phi_15625_;
                if _e9654.member_3 {
                    if _e9730 {
                        phi_15633_ = false;
                    } else {
                        phi_15633_ = true;
                    }
                    let _e9733 = phi_15633_;
                    phi_15634_ = _e9733;
                } else {
                    phi_15634_ = true;
                }
                let _e9735 = phi_15634_;
                if _e9735 {
                    phi_15639_ = _e9654.member;
                } else {
                    phi_15639_ = 1u;
                }
                let _e9738 = phi_15639_;
                if _e9654.member_3 {
                    phi_15647_ = (_e9738 == 0u);
                } else {
                    phi_15647_ = false;
                }
                let _e9744 = phi_15647_;
                if _e9744 {
                    let _e9749 = (_e9654.member_2[1] >> bitcast<u32>(20i));
                    if (_e9749 <= 896u) {
                        phi_15668_ = 0u;
                    } else {
                        phi_15668_ = ((((_e9749 - 896u) << bitcast<u32>(23i)) | ((_e9654.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e9654.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e9764 = phi_15668_;
                    let _e9766 = atomicMin((&earliest.member[0u]), _e9764);
                }
                phi_15672_ = type_20(0u, 0u, _e194, _e197, _e9654.member_2, _e9654.member_1);
                phi_15673_ = _e9744;
                phi_15674_ = (_e9738 != 0u);
            } else {
                phi_15672_ = type_20(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_15673_ = false;
                phi_15674_ = false;
            }
            let _e9768 = phi_15672_;
            let _e9770 = phi_15673_;
            let _e9772 = phi_15674_;
            let _e9775 = params.member.member.member_1;
            if ((_e9775 & 16u) != 0u) {
                if (_e123 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e9770 {
                    let _e9781 = atomicAdd((&counters[0u]), 1u);
                    phi_15693_ = _e9781;
                } else {
                    phi_15693_ = 0u;
                }
                let _e9783 = phi_15693_;
                workgroupBarrier();
                if (_e123 == 0u) {
                    let _e9786 = atomicLoad((&counters[0u]));
                    if (_e9786 > 0u) {
                        let _e9789 = atomicAdd((&contacts.member[0u]), _e9786);
                        atomicStore((&counters[1u]), _e9789);
                    }
                }
                workgroupBarrier();
                let _e9792 = atomicLoad((&counters[1u]));
                let _e9793 = (_e9792 + _e9783);
                if _e9770 {
                    let _e9796 = params.member.member_1.member_3;
                    if (_e9793 < _e9796) {
                        let _e9798 = (7u * _e9793);
                        atomicStore((&contacts.member[(4u + _e9798)]), _e9768.member);
                        atomicStore((&contacts.member[(_e9798 + 5u)]), _e9768.member_1);
                        atomicStore((&contacts.member[(_e9798 + 6u)]), _e9768.member_2);
                        atomicStore((&contacts.member[(_e9798 + 7u)]), _e9768.member_3);
                        atomicStore((&contacts.member[(_e9798 + 8u)]), _e9768.member_4[0]);
                        atomicStore((&contacts.member[(_e9798 + 9u)]), _e9768.member_4[1]);
                        atomicStore((&contacts.member[(_e9798 + 10u)]), _e9768.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e123 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e9772 {
                let _e9825 = atomicAdd((&counters[0u]), 1u);
                phi_15760_ = _e9825;
            } else {
                phi_15760_ = 0u;
            }
            let _e9827 = phi_15760_;
            workgroupBarrier();
            if (_e123 == 0u) {
                let _e9830 = atomicLoad((&counters[0u]));
                if (_e9830 > 0u) {
                    let _e9833 = atomicAdd((&undecided.member[0u]), _e9830);
                    atomicStore((&counters[1u]), _e9833);
                }
            }
            workgroupBarrier();
            let _e9836 = atomicLoad((&counters[1u]));
            let _e9837 = (_e9836 + _e9827);
            if _e9772 {
                let _e9840 = params.member.member_2.member;
                if (_e9837 < _e9840) {
                    let _e9844 = (2u * _e9837);
                    atomicStore((&undecided.member[(4u + _e9844)]), _e9768.member_2);
                    atomicStore((&undecided.member[(_e9844 + 5u)]), _e9768.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_844_ = _e179;
            break if !(_e185);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
